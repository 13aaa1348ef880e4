"""Comparison of the rigorous model that a file holds with the vendor's RPC, in the same file or beside it."""

from __future__ import annotations

from pathlib import Path

from raybundle.errors import Message, RaybundleError, Severity
from raybundle.io.scenes.base import Scene, read_scene
from raybundle.scenes.model_agreement import ModelAgreement, ModelsContradict, model_agreement
from raybundle.scenes.rpc import Rpc


def agreement_of(scene: Scene) -> ModelAgreement | None:
    """How far the two models of a scene are apart; None where there is only one of them."""
    if scene.rigorous is None:
        return None
    rpc = scene.rpc or _beside(scene.file)
    return None if rpc is None else model_agreement(scene.rigorous, rpc)


def check_agreement(scene: Scene) -> None:
    """Raise ModelsContradict where rigorous model and RPC are further apart than the RPC's stated error."""
    agreement = agreement_of(scene)
    if agreement is not None and agreement.contradicts:
        raise ModelsContradict(scene.file, agreement)


def remarks_of(scene: Scene) -> tuple[Message, ...]:
    """Remarks on a scene whose RPC is used: those of its reader, and a rigorous model that contradicts the RPC."""
    try:
        check_agreement(scene)
    except ModelsContradict as contradiction:
        values = contradiction.agreement.values
        return (*scene.remarks, Message(code="scene.rpc_preferred", values=values, severity=Severity.WARNING))
    return scene.remarks


def _beside(file: Path) -> Rpc | None:
    """The RPC of a DIMAP product: DIM_NAME.XML and RPC_NAME.XML stand in one folder."""
    kind, _, name = file.name.partition("_")
    other = file.with_name(f"{'RPC' if kind.isupper() else 'rpc'}_{name}")
    if kind.upper() != "DIM" or not other.is_file():
        return None
    try:
        return read_scene(other).rpc
    except RaybundleError:
        return None  # a damaged neighbour is the matter of whoever opens it
