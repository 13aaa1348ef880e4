"""Interior orientations that a network does not determine: kept near what was given, so that all else can be stated.

A network that leaves a camera parameter open (square views of a plane and the camera constant; no rolls and the
principal point) is singular, or nearly so: whether its factor fails, its iteration ends, or a standard deviation of
metres comes out hangs on the last bits.  Observed with a standard deviation far beyond what anybody knows of a camera
beforehand, the parameter is carried instead of the rounding, and its own standard deviation states what is true on
every machine: it is not determinable.  What is determined hardly notices: the added weight is a hundredth of the least
that the observations bring of a parameter which counts as determinable.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, replace
from functools import cache

import numpy as np

from raybundle.adjustment.records.figures import InteriorResult, ParameterResult
from raybundle.adjustment.result import Adjustment
from raybundle.adjustment.statistics.interior import image_effects, plausible_std
from raybundle.block import Block, Camera
from raybundle.errors import NotSolvable
from raybundle.numerics.arrays import Array

FAR = 10.0
"""Times the standard deviation from which on a parameter counts as not determinable."""
CARRIED = 0.5
"""Share of the added standard deviation from which on a parameter's own comes from it: a quarter of what is known."""


@dataclass(frozen=True, slots=True, kw_only=True)
class Steadied:
    """A block whose undetermined parameters are observed, and which."""

    block: Block
    added: Mapping[tuple[str, str], float]
    """Camera and symbol -> standard deviation."""


def steadied(block: Block, free: dict[str, tuple[str, ...]], error: NotSolvable) -> Steadied | None:
    """The block with the free parameters of the cameras that a defect names observed; None where it names none."""
    named = {u.name for u in error.undetermined if u.kind == "parameter"}
    cameras = list[Camera]()
    added = dict[tuple[str, str], float]()
    for camera in block.cameras:
        own = _priors(camera, free.get(camera.id, ())) if camera.id in named and camera.scene is None else {}
        added |= {(camera.id, symbol): std for symbol, std in own.items()}
        cameras.append(replace(camera, sigma={**camera.sigma, **own}) if own else camera)
    if not added:
        return None
    return Steadied(block=replace(block, cameras=tuple(cameras)), added=added)


def _priors(camera: Camera, free: tuple[str, ...]) -> dict[str, float]:
    """Standard deviations of the free parameters of a camera that are not observed already."""
    model = camera.sensor

    @cache
    def effects() -> Array:
        return image_effects(model, camera, camera.parameters)

    found: dict[str, float] = {}
    for position, symbol in enumerate(model.symbols):
        if symbol in free and symbol not in camera.sigma:
            std = FAR * plausible_std(camera, camera.parameters, position, effects)
            if np.isfinite(std) and std > 0:
                found[symbol] = std
    return found


def without_priors(result: Adjustment, given: Block, added: Mapping[tuple[str, str], float]) -> Adjustment:
    """The result as one of the block that was given: what was added is no observation of the user's."""
    cameras = tuple(replace(a, sigma=g.sigma) for a, g in zip(result.adjusted.cameras, given.cameras, strict=True))
    groups = tuple(
        g.rows(np.array(keep))
        for g in result.groups
        if g.kind == "parameter"
        for keep in [[(i.partition("/")[0], c) not in added for i, c in zip(g.ids, g.component, strict=True)]]
        if any(keep)
    )
    return replace(
        result,
        given=given,
        adjusted=replace(result.adjusted, cameras=cameras),
        groups=(*(g for g in result.groups if g.kind != "parameter"), *groups),
        variance_components=tuple(v for v in result.variance_components if v.kind != "parameters" or groups),
        observations=result.observations - len(added),
        constraints=result.constraints + len(added),
    )


def determined_by_network(
    interior: InteriorResult, added: Mapping[tuple[str, str], float], variance: float
) -> InteriorResult:
    """A parameter that its added observation shows rather than the network is not determinable.

    variance  what covariances are cofactors times
    """
    scale = np.sqrt(variance) if variance > 0 else 1.0

    def status(symbol: str, p: ParameterResult) -> str:
        prior = added.get((interior.camera, symbol))
        if prior is not None and p.std is not None and p.std / scale > CARRIED * prior:
            return "not determinable"
        return "estimated" if prior is not None and p.status == "observed" else p.status

    parameters = {s: replace(p, status=status(s, p)) for s, p in interior.parameters.items()}
    return replace(interior, parameters=parameters)
