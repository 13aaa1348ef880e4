"""The verdict on a calibration: is it good, for what, and what is to be photographed next.

What decides is what the network determines, not how small the residuals are: a wrong camera constant fits a flat field
seen squarely as well as the right one.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Literal

import numpy as np

from raybundle.adjustment.blunders.pixel_shape import UNTOLD
from raybundle.adjustment.evaluation.residual_structure import (
    RepeatedResiduals,
    ResidualStructure,
    repeated_residuals,
    residual_structure,
)
from raybundle.adjustment.records.figures import InteriorResult
from raybundle.adjustment.records.severity import Severity
from raybundle.adjustment.result import Adjustment
from raybundle.adjustment.statistics.network import CELLS, format_cells
from raybundle.block import Camera
from raybundle.calibration.cross_validation import CrossValidation, cross_validation
from raybundle.calibration.maps import projection_shifts
from raybundle.errors import Message, Text, note, phrase
from raybundle.numerics.arrays import Array, Mask
from raybundle.numerics.progress import Progress, silent
from raybundle.sensors import sensor_models

Grade = Literal["good", "usable", "weak", "not determinable"]
CROSSED = 0.5
"""Correlation from which x0 with P2, and y0 with P1, are listed too."""
COUPLED = 0.9
"""Correlation from which two parameters are named as coupled."""
REACH = 0.85
"""Share of the distance to the corners of the format that image points must reach."""
COVERED = 0.7
"""Share of the format's cells (10 x 10) that image points must cover."""
FEW_PHOTOGRAPHS = 6
UNSTABLE = "unstable_camera"
UNSTEADY = frozenset({UNSTABLE, "pixel_shape"})
"""Notices that speak against a calibration."""
GOOD_PX, USABLE_PX = 0.1, 0.3
"""Largest error of projection over the format, at infinity, of a good and a usable calibration: targets are measured to
some hundredths of a pixel and natural points to some tenths; an error that is shared by all photographs must stay below
what single points scatter by."""
SURE, LIKELY = 0.95, 0.5
"""A calibration is called good where its largest error is below GOOD_PX with this probability: whoever holds it must be
able to rely on it.  Below USABLE_PX it need only be more likely than not: it is a start, or for small things.

Where a verdict that is one class too low costs 1 and a good that is none costs k, good has the least expected cost from
a probability of k / (1 + k) on: SURE states that nineteen good calibrations called usable weigh as much as one wrong
good.  Nothing is to be gained from the residuals beyond sigma0: they do not depend on the errors of the estimates
(benchmarks/verdict_ceiling.py holds the verdict against one that knows the true covariance)."""
TILT_SPREAD = np.radians(20)


@dataclass(frozen=True, slots=True, kw_only=True)
class Proposal:
    """A photograph that could be added, after those proposed before it, and what they would bring."""

    words: Text
    """Where to stand and how to hold the camera, as an instruction"""
    uncertainty_px: float
    """Largest standard deviation of projection over the format that is to be expected with it and those before it;
    infinite where more are needed yet"""
    ratio: float
    """The same over that without any; NaN where neither is determinable"""


@dataclass(frozen=True, slots=True, kw_only=True)
class CalibrationQuality:
    """What the calibration of one camera is worth."""

    camera: str
    grade: Grade
    headline: Text
    """Is it good, and for what"""
    reasons: tuple[str, ...]
    """What speaks against it, the gravest first"""
    advice: tuple[Proposal, ...]
    """What to photograph next, one after the other, with the predicted effect (`planning.next.calibration`)"""
    unstable: bool
    """The photographs had not the same interior orientation: more of them would not help"""
    photographs: int
    image_sigma_px: float
    """Standard deviation of an image coordinate of median weight, from the residuals"""
    uncertainty_px: float
    """Largest standard deviation of projection over the format, at infinity"""
    typical_px: float
    """Its median over the format"""
    worst_px: float
    """Largest error of projection over the format, at infinity, that is not exceeded with a probability of SURE"""
    likely_px: float
    """The same with a probability of LIKELY"""
    inside_px: float
    """`worst_px` within the part of the format that image points reach"""
    reach: float
    """Farthest image point from the middle, as a share of the distance to the corners"""
    coverage: float
    """Share of the format's cells (10 x 10) with image points, all photographs together"""
    rolls: int
    """Quarter turns of the camera about its axis that occur (1 to 4)"""
    convergence: float
    """Largest angle between a viewing axis and the mean one [rad]"""
    couplings: tuple[tuple[str, str, float], ...]
    """Of c with the station along the axis, x0 and y0 with decentring: name, name, correlation"""
    validation: CrossValidation | None
    structure: ResidualStructure | None
    repeated: RepeatedResiduals | None
    """What the residuals have in common from photograph to photograph"""


def calibration_quality(
    result: Adjustment,
    camera: str,
    validation: CrossValidation | None,
    structure: ResidualStructure | None,
) -> CalibrationQuality:
    """The verdict on the calibration of one camera; the adjustment must have statistics.

    validation  of this camera's photographs; structure  of the whole adjustment
    Limits: whether zoom, focus or stabilisation move before the camera is used.
    """
    interior = next(i for i in result.interior if i.camera == camera and i.image is None)
    k = next(i for i, c in enumerate(result.given.cameras) if c.id == camera)
    o, used = result.given.observations, result.image_observations.used
    mine: Mask = used & (result.given.images.camera[o.image] == k)
    images = np.unique(o.image[mine])
    sigma = float(result.sigma0 * np.sqrt(np.median(o.cov_px2[mine, :2]))) if mine.any() else np.nan
    adjusted = result.adjusted.cameras[k]
    repeated = repeated_residuals(result, k)
    reach, coverage = _format(result, k, mine)
    error = _projection(adjusted, interior, result, _doubt(validation, structure), repeated, reach)
    rolls, convergence = _views(result, images)
    couplings = _couplings(result, interior)
    doubtful = [n for n in result.notices if n.code in UNSTEADY and camera in n.ids]
    unstable = any(n.code == UNSTABLE for n in doubtful)
    # knots of surfaces in corners that no point reaches say nothing, and are none the worse for it
    surfaces = adjusted.sensor.local_width > 0
    lacking = () if surfaces else tuple(s for s, p in interior.parameters.items() if p.status == "not determinable")
    reasons = _reasons(
        lacking, interior, len(images), error, reach, coverage, rolls, convergence, couplings, validation, structure,
        repeated, unstable=unstable,
    )  # fmt: skip
    kinds = {p.symbol: p.kind for p in adjusted.sensor.parameters}
    vital = tuple(s for s in lacking if kinds[s] in {"scale", "principal point"})
    nonsense = any(n.severity is Severity.FAULT for n in doubtful)
    if not vital and (nonsense or error.typical > UNTOLD * float(np.hypot(adjusted.width_px, adjusted.height_px)) / 2):
        vital = ("",)
    grade = _grade(vital, error, reach, validation)
    if lacking and grade == "good":
        grade = "usable"
    unsteady = [n.reason or n.text for n in doubtful]
    if unsteady and grade == "good":
        grade = "usable"
    return CalibrationQuality(
        camera=camera, grade=grade, headline=_headline(grade, vital, error, sigma, reach),
        reasons=(*unsteady, *reasons), advice=(), unstable=unstable, photographs=len(images), image_sigma_px=sigma,
        uncertainty_px=error.largest, typical_px=error.typical, worst_px=error.sure, likely_px=error.likely,
        inside_px=error.inside,
        reach=reach, coverage=coverage, rolls=rolls, convergence=convergence,
        couplings=couplings, validation=validation, structure=structure, repeated=repeated,
    )  # fmt: skip


@dataclass(frozen=True, slots=True, kw_only=True)
class _Projection:
    """Errors of projection over the format, at infinity [px]; NaN where nothing was estimated."""

    largest: float = np.nan
    """Largest standard deviation"""
    typical: float = np.nan
    """Median standard deviation"""
    sure: float = np.nan
    """Largest error, not exceeded with a probability of SURE, everything that speaks against the covariance included"""
    likely: float = np.nan
    """The same with a probability of LIKELY"""
    inside: float = np.nan
    """As `sure`, within the part of the format that image points reach"""


def _projection(
    camera: Camera, interior: InteriorResult, result: Adjustment, doubt: float, repeated: RepeatedResiduals | None,
    reach: float,
) -> _Projection:  # fmt: skip
    C = None if result.precision is None else result.precision.interior.get(interior.camera)
    if C is None or not interior.free:
        return _Projection()
    shifts = projection_shifts(camera, interior.free)
    found = shifts.uncertainty(C)
    reached = reach * float(np.hypot(camera.width_px, camera.height_px)) / 2
    worst, near = doubt * shifts.worst_errors(C), doubt * shifts.worst_errors(C, within_px=reached)
    if repeated is not None and repeated.noticed:  # what the model lacks is no part of the covariance
        worst, near = np.hypot(worst, 2 * repeated.rms_px), np.hypot(near, 2 * repeated.rms_px)
    return _Projection(
        largest=found.largest, typical=float(np.nanmedian(found.std)), sure=float(np.quantile(worst, SURE)),
        likely=float(np.quantile(worst, LIKELY)), inside=float(np.quantile(near, SURE)),
    )  # fmt: skip


def _doubt(validation: CrossValidation | None, structure: ResidualStructure | None) -> float:
    """Factor by which the standard deviations are too small, as residuals show."""
    excess = 1.0 if validation is None else max(validation.excess, 1.0)
    # what is within its own scatter is no structure
    return max(excess, structure.factor) if structure is not None and _structured(structure) else excess


def _structured(structure: ResidualStructure) -> bool:
    return structure.correlation > max(0.05, 5 * structure.std)


def _format(result: Adjustment, k: int, mine: Mask) -> tuple[float, float]:
    camera = result.given.cameras[k]
    xy = result.given.observations.xy_px[mine] / np.array([camera.width_px, camera.height_px])
    if not len(xy):
        return 0.0, 0.0
    half = np.array([camera.width_px, camera.height_px]) / 2
    radius = np.linalg.norm((xy - 0.5) * 2 * half, axis=1) / np.linalg.norm(half)
    return float(radius.max()), len(np.unique(format_cells(xy))) / CELLS**2


def _views(result: Adjustment, images: Array) -> tuple[int, float]:
    axes = result.adjusted.images.rotation[images, 2]
    mean = axes.mean(axis=0)
    size = float(np.linalg.norm(mean))
    spread = np.pi if size < 1e-9 else float(np.arccos(np.clip(axes @ mean / size, -1, 1)).max(initial=0.0))
    roll = np.zeros(0) if result.network is None else result.network.roll[images]
    quarters = np.unique(np.round(roll[np.isfinite(roll)] / (np.pi / 2)).astype(int) % 4)
    return max(1, len(quarters)), spread


def _couplings(result: Adjustment, interior: InteriorResult) -> tuple[tuple[str, str, float], ...]:
    """Of c with the station's position along its viewing axis; principal point with the decentring parameters."""
    model = sensor_models[next(c.model for c in result.given.cameras if c.id == interior.camera)]
    kind = {p.symbol: p.kind for p in model.parameters}
    found: list[tuple[str, str, float]] = []
    R, free = interior.correlations, interior.free
    for i, a in enumerate(free):
        for j, b in enumerate(free):
            if kind[a] == "principal point" and kind[b] == "decentring" and len(R):
                found.append((a, b, float(R[i, j])))
    # of each coordinate of the principal point the decentring term that is most like it; others where they matter
    own = {a: b for a, b, _ in sorted(found, key=lambda f: abs(f[2]))}
    scale = [i for i, a in enumerate(free) if kind[a] == "scale"]
    precision = result.precision
    cross = None if precision is None else precision.interior_exterior.get(interior.camera)
    along = np.nan
    if scale and cross is not None and precision is not None and len(cross):
        k = next(i for i, c in enumerate(result.given.cameras) if c.id == interior.camera)
        here = np.flatnonzero((result.given.images.camera == k) & np.isfinite(precision.images[:, 0, 0]))
        if len(here) == len(cross):
            axis = result.adjusted.images.rotation[here, 2]
            C = precision.images[here, :3, :3]
            std = np.sqrt(np.diagonal(C, axis1=1, axis2=2))
            covariance = np.einsum("ni,ni,ni->n", cross[:, scale[0], :3], std, axis)
            r = covariance / np.sqrt(np.einsum("ni,nij,nj->n", axis, C, axis))
            along = float(r[np.nanargmax(np.abs(r))]) if np.isfinite(r).any() else np.nan
    named = [f for f in found if own.get(f[0]) == f[1] or abs(f[2]) > CROSSED]
    return (*([(free[scale[0]], "Z", along)] if scale and np.isfinite(along) else []), *named)


def _reasons(
    lacking: tuple[str, ...], interior: InteriorResult, photographs: int, error: _Projection, reach: float,
    coverage: float, rolls: int, convergence: float, couplings: tuple[tuple[str, str, float], ...],
    validation: CrossValidation | None, structure: ResidualStructure | None, repeated: RepeatedResiduals | None,
    *, unstable: bool,
) -> list[Text]:  # fmt: skip
    found: list[Message] = []
    for s in lacking:
        p = interior.parameters[s]
        known, std, unit = p.std is not None, p.std or 0.0, p.in_unit("").strip()
        found.append(note("calibration_quality.not_determinable", symbol=s, known=known, std=std, unit=unit))
    if photographs < FEW_PHOTOGRAPHS:
        found.append(note("calibration_quality.few_photographs", n=photographs, least=FEW_PHOTOGRAPHS))
    if error.sure > GOOD_PX:
        found.append(note(
            "calibration_quality.uncertain", sure_px=error.sure, certainty=SURE, likely_px=error.likely,
            unstable=unstable,
        ))  # fmt: skip
    if reach < REACH:
        found.append(note("calibration_quality.reach", reach=reach))
    if coverage < COVERED:
        found.append(note("calibration_quality.coverage", coverage=coverage))
    if rolls == 1:
        found.append(note("calibration_quality.not_rolled"))
    if convergence < TILT_SPREAD:
        found.append(note("calibration_quality.no_convergence", angle_deg=float(np.degrees(convergence))))
    found += [
        note("calibration_quality.coupled", symbol=a, other="station" if b == "Z" else b, correlation=r)
        for a, b, r in couplings if abs(r) > COUPLED
    ]  # fmt: skip
    return [Text.of(m) for m in (*found, *_of_validation(validation), *_of_residuals(structure, repeated))]


def _of_validation(validation: CrossValidation | None) -> list[Message]:
    """What photographs that were left out show against a calibration."""
    if validation is not None and validation.contradicts:
        return [note("calibration_quality.contradicted", excess=validation.excess)]
    if validation is not None and validation.few_views:
        return [note("calibration_quality.few_views", ratio=validation.ratio)]
    return []


def _of_residuals(structure: ResidualStructure | None, repeated: RepeatedResiduals | None) -> list[Message]:
    """What the residuals show against the model of a camera."""
    found: list[Message] = []
    if structure is not None and _structured(structure):
        found.append(note(
            "calibration_quality.structure", correlation=structure.correlation, factor=structure.factor
        ))  # fmt: skip
    if repeated is not None and repeated.noticed:
        found.append(note("calibration_quality.repeated", correlation=repeated.correlation, rms_px=repeated.rms_px))
    return found


def _grade(lacking: tuple[str, ...], error: _Projection, reach: float, validation: CrossValidation | None) -> Grade:
    if lacking:
        return "not determinable"
    contradicted = validation is not None and validation.contradicts
    if not error.likely <= USABLE_PX or reach < 0.6 or contradicted:
        return "weak"
    good = error.sure <= GOOD_PX and reach >= REACH
    return "good" if good and validation is not None else "usable"


def _headline(grade: Grade, lacking: tuple[str, ...], error: _Projection, sigma: float, reach: float) -> Text:
    if grade == "not determinable":
        names = [s for s in lacking if s]
        return phrase("calibration_quality.head_not_determinable", names=names, whole=not names)
    figures = note(
        "calibration_quality.head_figures", typical_px=error.typical, largest_px=error.largest, sigma_px=sigma
    )  # fmt: skip
    if grade == "weak":
        return Text.of(note("calibration_quality.head_weak"), figures)
    part = note("calibration_quality.head_part", reach=reach) if reach < REACH else None
    if grade == "usable" and reach < REACH and error.inside <= GOOD_PX:
        return Text.of(note("calibration_quality.head_inside", reach=reach, inside_px=error.inside), figures)
    head = (
        note("calibration_quality.head_usable", px=error.sure) if grade == "usable"
        else note("calibration_quality.head_good", px=max(sigma, error.sure))
    )  # fmt: skip
    return Text.of(head, figures, *([] if part is None else [part]))


def calibration_qualities(result: Adjustment, progress: Progress = silent) -> tuple[CalibrationQuality, ...]:
    """The verdict on each camera that has one interior orientation with estimated parameters."""
    if result.precision is None:
        return ()
    wanted = [
        i.camera
        for i in result.interior
        if i.image is None and (i.free or any(p.status == "not determinable" for p in i.parameters.values()))
    ]
    if not wanted:
        return ()
    structure = residual_structure(result) if result.noise.kind == "white" else None  # else the covariance carries it
    return tuple(
        calibration_quality(result, c, cross_validation(result, c, progress=progress), structure) for c in wanted
    )
