"""What the pixels of a sensor can have of affinity and shear, and values beyond that.

Rows and columns stand at right angles and at equal distances by lithography.  Residuals that ask for more are the
symptom of something else that the model lacks, or of photographs that say too little; believed, it moves the principal
point and the camera constant.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace

import numpy as np

from raybundle.adjustment.records.notice import Notice
from raybundle.adjustment.records.severity import Severity
from raybundle.adjustment.result import Adjustment
from raybundle.block import Camera
from raybundle.errors import Value
from raybundle.numerics.statistics import family_wise_t

LIMIT = 1e-4
"""Affinity and shear that a sensor may have."""
ROUNDED = 0.5
"""Pixels by which each side of a picture that was made smaller is rounded: its pixels are that much less square."""
LEVEL = 1e-3
"""Probability of any statement on all cameras of a block whose pixels are as a sensor has them, at most."""
UNLIKELY = 2.6
"""Standard deviations beyond the limit from which on a value is more probably chance than a sensor's (99 percent)."""
UNTOLD = 0.01
"""Error of projection, in half diagonals of the format, from which on nothing is reported of a camera."""


@dataclass(frozen=True, slots=True, kw_only=True)
class ShapeNotice(Notice):
    """An affinity or a shear of a camera that no sensor has, with its numbers: `ids` are camera and symbol."""

    value: float
    std: float
    """As the noise of the image coordinates was when it was made"""
    limit: float
    critical: float
    """Standard deviations beyond the limit up to which it may be chance"""
    shear: bool
    under_noise: bool = False
    """Whether `std` is that of the noise which the result states already"""


def shape_limit(camera: Camera, symbol: str) -> float:
    """Largest believable value of a parameter of the kind affinity.

    Of a picture whose sides were rounded to whole pixels when it was made smaller, the pixels are less square by half a
    pixel of each side; its rows and columns stay at right angles.
    """
    return LIMIT + (0.0 if _is_shear(camera, symbol) else ROUNDED * (1 / camera.width_px + 1 / camera.height_px))


def beyond_sensor(result: Adjustment, cameras: Sequence[str]) -> ShapeNotice | None:
    """The affinity or shear of these cameras that is farthest beyond what a sensor has, significantly; else None.

    Significantly: (|value| - limit) / std beyond `_critical`.
    """
    tested = [*_estimated(result, cameras)]
    critical = _critical(result, len(tested))
    found = [
        _notice(c.id, symbol, value, std, limit, critical, shear=_is_shear(c, symbol))
        for c, symbol, value, std, limit in tested
        if abs(value) - limit > critical * std
    ]
    return max(found, key=lambda n: abs(n.value) / n.limit, default=None)


def _critical(result: Adjustment, count: int) -> float:
    """Standard deviations up to which so many values may be chance: Student's t, family-wise at `LEVEL`.

    They are tested anew each time another parameter leaves, so that each counts as often as there are parameters.
    sigma0 and its degrees of freedom are those of what was measured: what was known of cameras before is stated wide,
    and makes sigma0 smaller than the noise is.  As with control, sigma0 below 1 counts as 1: of few observations it is
    small by chance, and just then that makes values significant.
    """
    rounds = max((len(i.parameters) for i in result.interior), default=1)
    square, redundancy = result.weighted_square_sum, float(result.redundancy)
    for g in result.groups:
        before = np.array([origin == "known before" for origin in g.origin], bool)
        if before.any():
            square -= float(g.square[before].sum())
            redundancy -= float(g.redundancy[before].sum())
    critical = family_wise_t(LEVEL, count * rounds, redundancy)
    if not np.isfinite(critical) or not result.sigma0 > 0:
        return critical
    return critical * max(float(np.sqrt(max(square, 0.0) / redundancy)), 1.0) / result.sigma0


def weak_shape(result: Adjustment, cameras: Sequence[str]) -> Notice | None:
    """The affinity or shear of these cameras that states least of the sensor; else None.

    It is reported worse than what a sensor may have, or lies beyond that by `UNLIKELY` standard deviations, too few for
    `beyond_sensor` to say so.  Estimated, it would take with it what it correlates with: of photographs about one axis,
    an affinity stretches the camera and the object along that axis.  Not every such value is significant, and none of
    them is the sensor's.
    """
    found = [
        (std / limit, _unknown(c.id, symbol, value, std, limit))
        for c, symbol, value, std, limit in _estimated(result, cameras)
        if std > limit or abs(value) - limit > UNLIKELY * std
    ]
    return max(found, key=lambda f: f[0])[1] if found else None


def _estimated(result: Adjustment, cameras: Sequence[str]) -> Iterator[tuple[Camera, str, float, float, float]]:
    """Camera, symbol, value, standard deviation and limit of each affinity and shear that is free in these cameras."""
    for interior in result.interior:
        if interior.camera not in cameras:
            continue
        camera = next(c for c in result.given.cameras if c.id == interior.camera)
        for p in camera.sensor.parameters:
            value = interior.parameters.get(p.symbol)
            if p.kind == "affinity" and p.symbol in interior.free and value is not None and value.std:
                yield camera, p.symbol, value.value, value.std, shape_limit(camera, p.symbol)


def _unknown(camera: str, symbol: str, value: float, std: float, limit: float) -> Notice:
    values: dict[str, Value] = {"camera": camera, "symbol": symbol, "sigma": std, "found": value, "limit": limit}
    return Notice(code="shape_held", ids=(camera, symbol), values=values)


def under_its_noise(result: Adjustment) -> Adjustment:
    """The result with what was stated of affinity and shear under white noise restated under the noise that it has.

    Some decisions are taken under white noise.  Where smooth errors make standard deviations so much larger that a
    value may be a sensor's after all, it stays held, for a sensor's is known better than by these photographs; that
    is a remark.
    """
    wider = result.noise.ratio_interior
    if result.noise.kind != "fields" or not wider > 1.0:
        return result
    notices = tuple(
        _restated(n, wider) if isinstance(n, ShapeNotice) and not n.under_noise else n for n in result.notices
    )
    return replace(result, notices=notices)


def _restated(n: ShapeNotice, wider: float) -> Notice:
    camera, symbol = n.ids
    std = wider * n.std
    if abs(n.value) - n.limit > n.critical * std:
        return _notice(camera, symbol, n.value, std, n.limit, n.critical, shear=n.shear)
    return _unknown(camera, symbol, n.value, std, n.limit)


def _is_shear(camera: Camera, symbol: str) -> bool:
    return next(p.shear for p in camera.sensor.parameters if p.symbol == symbol)


def _notice(
    camera: str, symbol: str, value: float, std: float, limit: float, critical: float, *, shear: bool
) -> ShapeNotice:
    """A fault where it would move image points by more than the share UNTOLD of the half diagonal.

    An affinity or a shear of that size does; the rest of the interior orientation is nonsense then, too.
    """
    values: dict[str, Value] = {
        "camera": camera,
        "symbol": symbol,
        "shear": shear,
        "found": value,
        "sigma": std,
        "limit": limit,
    }
    return ShapeNotice(
        code="pixel_shape", values=values, ids=(camera, symbol), value=value,
        std=std, limit=limit, critical=critical, shear=shear,
        measured=Severity.FAULT if abs(value) > UNTOLD else Severity.WARNING,
    )  # fmt: skip
