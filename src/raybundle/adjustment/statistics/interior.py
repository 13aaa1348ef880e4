"""What the adjustment states of each interior orientation: significance, determinability, effect in the image."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from functools import cache

import numpy as np

from raybundle.adjustment.records.figures import InteriorResult, ParameterResult, Precision
from raybundle.adjustment.statistics.precision import interior_unknowns
from raybundle.adjustment.system.assemble import InteriorRow, State, System
from raybundle.adjustment.system.normals import Normals
from raybundle.block import Camera, Instrument
from raybundle.block.known import known_before
from raybundle.errors import InputError
from raybundle.numerics.arrays import Array, Index
from raybundle.numerics.statistics import correlation, fisher_tail
from raybundle.sensors import SensorModel

JOINT = ("radial", "decentring", "affinity", "harmonic", "principal point")
PLAUSIBLE = {"scale": 0.05, "principal point": 0.02}
"""Sigma beyond which a block states less about a parameter than one knows before: shares of c and of the format."""
PLAUSIBLE_SHIFT = 0.05
"""The same for corrections: largest shift within the format, as a share of half its diagonal."""


NEAR_LINES = 65
"""Lines at which the effect of parameters that act in a neighbourhood is looked at."""
PLAUSIBLE_CARRIED = {"length": 0.3, "rad": 0.02, "s": 0.1}
"""The same for what GNSS and INS have: a tape shows a lever arm better, a look at the mounting the misalignment."""


def image_effects(model: SensorModel, camera: Camera, values: Array, distance: float = 1.0) -> Array:
    """Largest shifts (k,) [px] over the format per unit of each parameter, the viewing rays held.

    distance  of the object points, which the effect of a length in object space depends on
    """
    return np.nanmax(np.linalg.norm(image_shifts(model, camera, values, distance), axis=1), axis=0)


def image_shifts(model: SensorModel, camera: Camera, values: Array, distance: float = 1.0) -> Array:
    """Shifts (n, 2, k) [px] of image points over the format per unit of each parameter, the viewing rays held.

    d x / d parameter = -B^-1 d g / d parameter at image points along the border and over the format.
    """
    half = camera.size_mm / 2
    t = np.linspace(-1, 1, 9)
    # a parameter that acts in its neighbourhood alone must not fall between the lines
    lines = np.linspace(-1, 1, NEAR_LINES) if model.local_width else t
    x, y = (a.ravel() for a in np.meshgrid(t * half[0], lines * half[1]))
    image = np.stack([x, y])
    spread = np.repeat(values[: len(model.symbols), None], x.size, axis=1)
    ray = model.point_on_ray(image, spread, distance)
    _, J = model.condition_and_jacobian(*image, *ray, *spread)
    B = np.moveaxis(J[:, :2], 2, 0)
    try:
        shift = -np.linalg.solve(B, np.moveaxis(J[:, 5:], 2, 0))
    except np.linalg.LinAlgError:
        parameters = [f"{s} = {v:g}" for s, v in zip(model.symbols, values.tolist(), strict=False)]
        raise InputError("camera.no_ray", camera=camera.id, parameters=parameters) from None
    return shift / np.array(camera.pixel_mm)[:, None]


def plausible_std(owner: Camera | Instrument, values: Array, position: int, effects: Callable[[], Array]) -> float:
    """Standard deviation of a parameter beyond which a block states less of it than one knows beforehand.

    effects  gives the largest shift [px] over the format per unit of each parameter (`image_effects`)
    """
    parameter = owner.sensor.parameters[position]
    if isinstance(owner, Instrument):
        # what is observed is known as well as stated; sigma0 may make a little more of it
        stated = 1.5 * owner.sigma.get(parameter.symbol, 0.0)
        # of a shift in object space nothing is known beforehand: another datum may be anywhere
        if parameter.unit == "length" and any(parameter.symbol in group for group in owner.sensor.in_object):
            return np.inf
        return max(PLAUSIBLE_CARRIED.get(parameter.unit, np.inf), stated)
    if parameter.kind == "scale":
        return PLAUSIBLE["scale"] * abs(float(values[position]))
    if parameter.kind == "principal point":
        return PLAUSIBLE["principal point"] * float(owner.size_mm.max())
    limit = PLAUSIBLE_SHIFT * 0.5 * float(np.hypot(owner.width_px, owner.height_px))
    return limit / max(float(effects()[position]), 1e-300)


def interior_results(
    normals: Normals, state: State, precision: Precision | None, variance: float, redundancy: int
) -> tuple[InteriorResult, ...]:
    """Parameters, correlations and tests of every interior orientation that takes part."""
    system = normals.system
    results: list[InteriorResult] = []
    for r, row in enumerate(system.interior):
        if not len(system.images_of(r)) and (row.node < 0 or row.camera >= 0):
            continue
        lengths = row.camera >= 0 and any(p.unit.startswith("length") for p in row.model.parameters)
        distance = _distance(system, state, system.images_of(r)) if lengths else 1.0
        results.append(_one(normals, row, state.interior[r], precision, variance, redundancy, distance))
    links = {c.id: c.sensor.links for c in system.block.cameras if c.sensor.links}
    found = {r.camera: r.parameters for r in results} if links else {}
    return tuple(
        replace(r, parameters={s: found[name][s] for s, name in links[r.camera].items()}) if r.camera in links else r
        for r in results
    )


def _distance(system: System, state: State, images: Index) -> float:
    """Median distance from these images to the points that they see."""
    o = system.block.observations
    mine = np.zeros(len(system.block.images), bool)
    mine[images] = True
    rows = system.rows[mine[o.image[system.rows]]]
    return float(np.median(np.linalg.norm(state.xyz[o.point[rows]] - state.centre[o.image[rows]], axis=1)))


def _one(
    normals: Normals, row: InteriorRow, values: Array, precision: Precision | None, variance: float, redundancy: int,
    distance: float,
) -> InteriorResult:  # fmt: skip
    system: System = normals.system
    owner = row.owner(system.block)
    C = None if precision is None or row.node < 0 else precision.interior[row.key(system.block)]
    diagonal = normals.diagonal[interior_unknowns(system, row)] if row.node >= 0 else np.zeros(0)
    variance = variance if variance > 0 else 1.0
    parameters: dict[str, ParameterResult] = {}
    known = known_before(owner)

    @cache
    def effects() -> Array:
        assert isinstance(owner, Camera)
        return image_effects(row.sensor, owner, values, distance)

    for position in row.carries:
        parameter = row.model.parameters[position]
        free = row.node >= 0 and position in row.free
        std = t = determinability = effect = effect_std = None
        status = "estimated" if free else "held"
        if free and parameter.symbol in owner.sigma:
            status = "observed"
        value = float(values[position])
        if parameter.kind not in {"scale", "other"}:
            effect = float(effects()[position]) * abs(value)
        if free and C is not None:
            k = row.free.index(position)
            std = float(np.sqrt(C[k, k]))
            determinability = float(1 / max(C[k, k] / variance * diagonal[k], 1e-300))
            effect_std = float(effects()[position]) * std if row.camera >= 0 else None
            t = abs(value) / std if parameter.kind != "scale" and std > 0 else None
            # what was known of this camera is observed: `known_before` states whether the images add to it
            if parameter.symbol not in known and std > plausible_std(owner, values, position, effects):
                status = "not determinable"
        parameters[parameter.symbol] = ParameterResult(
            symbol=parameter.symbol, unit=parameter.unit, meaning=parameter.meaning, values=parameter.values,
            value=value, std=std, t=t, determinability=determinability, effect_px=effect, effect_std_px=effect_std,
            status=status,
        )  # fmt: skip
    free_symbols = tuple(row.model.symbols[k] for k in row.free) if row.node >= 0 else ()
    image = None if row.image < 0 else system.block.images.ids[row.image]
    return InteriorResult(
        camera=owner.id, image=image, parameters=parameters, free=free_symbols,
        correlations=np.zeros((0, 0)) if C is None else correlation(C),
        joint_tests={} if C is None else joint_tests(row, values, C, redundancy),
    )  # fmt: skip


def joint_tests(row: InteriorRow, values: Array, C: Array, redundancy: int) -> dict[str, tuple[float, float]]:
    """F = x' C^-1 x / p of groups of parameters, with the probability of a larger one by chance."""
    tests: dict[str, tuple[float, float]] = {}
    for kind in JOINT:
        k = [i for i, position in enumerate(row.free) if row.model.parameters[position].kind == kind]
        if len(k) < 2 or redundancy < 1:
            continue
        x = values[[row.free[i] for i in k]]
        F = float(x @ np.linalg.solve(C[np.ix_(k, k)], x) / len(k))
        name = " ".join(row.model.symbols[row.free[i]] for i in k)
        tests[name] = (F, fisher_tail(F, len(k), redundancy))
    return tests
