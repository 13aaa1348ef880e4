"""A trajectory that several line scenes share: one set of corrections, which cameras of the block name."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

from raybundle.block import Instrument
from raybundle.platforms.instrument import InstrumentModel
from raybundle.scenes.kinds.linescan import LineSensor
from raybundle.scenes.trajectory import CorrectionModel


class SharedTrajectory(InstrumentModel, registered=False):
    """The corrections of a trajectory's table as unknowns of several scenes.

    Polynomials and curves go over the time from the first line of any scene to the last of any; rotations are about the
    axes of the detector of the first scene.
    """

    name = "trajectory"
    section = "trajectories"
    noun = "trajectory"
    formula = LineSensor.formula

    def __init__(self, corrections: CorrectionModel, keys: Mapping[str, Any]) -> None:
        """Of what corrects it, and the keys with which block.toml states this."""
        self.corrections, self.keys = corrections, dict(keys)
        self.parameters = corrections.parameters

    @property
    def groups(self) -> Mapping[str, tuple[str, ...]]:
        """As `CorrectionModel.groups`."""
        return self.corrections.groups


def trajectory_of(
    id_: str, sensor: LineSensor, *, estimate: tuple[str, ...] | None = None, sigma: Mapping[str, float] | None = None,
    values: Mapping[str, float] | None = None,
) -> Instrument:  # fmt: skip
    """The instrument with the corrections that a scene without a mount has.

    estimate  symbols of free parameters; None: all
    sigma     their prior standard deviations; None: as the table of GNSS and INS states
    """
    model = SharedTrajectory(sensor.corrections, sensor.correction_keys)
    free = model.symbols if estimate is None else estimate
    sigma = sensor.priors() if sigma is None else sigma
    return Instrument(
        id=id_, model=model.name, values=values or {}, estimate=free, scene=model,
        sigma={s: v for s, v in sigma.items() if s in free}, relations=sensor.relations,
    )  # fmt: skip
