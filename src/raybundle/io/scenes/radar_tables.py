"""What files of radar scenes have in common: times, state vectors, polynomials of ground range, tie points, RPC.

Lines and pixels of the files count from 0 at centres; state vectors stand in the frame that turns with the earth.
"""

from __future__ import annotations

import re
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from math import comb

import numpy as np

from raybundle.errors import InputError, Message, RaybundleError, warning
from raybundle.io.reading.words import no_number, number_of, quoted
from raybundle.io.reading.xml import Element
from raybundle.numerics.arrays import Array
from raybundle.scenes.kinds.range_doppler import RangeDoppler
from raybundle.scenes.model_agreement import LEAST_PX
from raybundle.scenes.orbit import LEAST as LEAST_VECTORS
from raybundle.scenes.orbit import NEAREST, Orbit
from raybundle.scenes.rpc import Rpc, rpc_of

UNITS: Mapping[str, Mapping[str, float]] = {
    "m": {"m": 1.0, "metres": 1.0, "meters": 1.0, "km": 1e3, "mm": 1e-3},
    "s": {"s": 1.0, "seconds": 1.0, "ms": 1e-3, "us": 1e-6, "ns": 1e-9},
    "m/s": {"m/s": 1.0, "km/s": 1e3},
}
"""Factors of the units that an attribute may state, by the unit that is meant where it states none."""
DEGREE = 2 * NEAREST - 1
"""Largest of polynomials: that of an orbit between its state vectors"""
SHORT_S = 30.0
"""Steps of state vectors in whole cm from which on a polynomial through positions and velocities at once is better: its
velocities err by the rounding over the step; one through velocities alone errs by 1e-5 m/s at this step"""
_UTC = re.compile(r"(Z|[+-]00:?00)$")
EXTENT = 0.01
"""By which share of the swath the ranges at its edges may contradict each other: they change along an image."""


def utc(text: str) -> np.datetime64:
    """The time that a text states, in UTC; raises ValueError for another zone."""
    word = _UTC.sub("", text.strip())
    if {"+", "-"} & {*word[10:]}:
        raise ValueError(word)
    return np.datetime64(word, "ns")


def instant(element: Element) -> np.datetime64:
    """The time that an element states, in UTC."""
    try:
        return utc(element.content)
    except ValueError:
        element.fail("value.no_time", value=quoted(element.content.strip()))


def seconds(element: Element, epoch: np.datetime64) -> float:
    """The same in seconds after another time."""
    return float((instant(element) - epoch) / np.timedelta64(1, "ns")) * 1e-9


def only(parent: Element, name: str) -> Element:
    """The child of this name; raises InputError where there is none, or several (of beams, poles) that differ."""
    found = list(parent.all(name))
    if len({e.content.strip() for e in found}) > 1:
        found[1].fail("scene.values_differ", n=len(found))
    return parent.get(name)


def amount(parent: Element, name: str, unit: str = "m") -> float:
    """The number in a child; an attribute may state another unit."""
    child = only(parent, name)
    stated = (child.attributes.get("units") or child.attributes.get("unit")).strip() or unit
    if stated.lower() not in UNITS[unit]:
        child.fail("value.not_supported", value=quoted(stated), known=list(UNITS[unit]))
    return float(child.numbers(1)[0]) * UNITS[unit][stated.lower()]


def powers(element: Element, name: str, exponent: str, scale: float = 1.0) -> Array:
    """Coefficients by rising powers of children with an exponent in an attribute, times the powers of a scale.

    The attribute may be missing where there is one child.
    """
    found: dict[int, float] = {}
    for child in element.all(name):
        k = child.value(exponent) if exponent in child.attributes else 0.0
        if k not in range(DEGREE + 1) or k in found:
            child.fail("value.not_supported", value=quoted(child.attributes.get(exponent)), known=[f"0 ... {DEGREE}"])
        word = child.content.strip()
        value = number_of(word, scale ** int(k))
        if value is None:
            child.fail(no_number(word))
        found[int(k)] = value
    if not found:
        element.get(name)
    return np.array([found.get(k, 0.0) for k in range(1 + max(found))])


def whole(parent: Element, name: str) -> int:
    """The number of pixels in a child."""
    value = float(only(parent, name).numbers(1)[0])
    if value != int(value) or not 1 <= value <= 10_000_000:
        parent.get(name).fail("scene.pixel_count", value=value)
    return int(value)


def choice(parent: Element, name: str, known: Mapping[str, float]) -> float:
    """What a word in a child stands for."""
    word = only(parent, name).content.strip()
    if word.upper() not in known:
        parent.get(name).fail("value.not_supported", value=quoted(word), known=list(known))
    return known[word.upper()]


SIDES = {"RIGHT": 1.0, "LEFT": -1.0}
ORDERS = {"INCREASING": 1.0, "DECREASING": -1.0}


def orbit_of(parent: Element, vectors: Sequence[Element], epoch: np.datetime64, names: Sequence[str]) -> Orbit:
    """The orbit of elements that hold a time, three components of position and three of velocity, by these names."""
    if len(vectors) < LEAST_VECTORS:
        parent.fail("scene.position_count", n=len(vectors), least=LEAST_VECTORS)
    times = np.array([seconds(v.get(names[0]), epoch) for v in vectors])
    rows = [[amount(v, n, u) for n, u in zip(names[1:], ("m",) * 3 + ("m/s",) * 3, strict=True)] for v in vectors]
    return orbit_of_table(parent, times, *np.hsplit(np.array(rows).reshape(-1, 6), 2))


def orbit_of_table(parent: Element, times: Array, positions: Array, velocities: Array) -> Orbit:
    """The orbit of times (n,) [s], positions [m] and velocities [m/s] (n, 3) that stand below this element."""
    sizes = (len(times), len(positions), len(velocities))
    if min(sizes) < max(LEAST_VECTORS, *sizes):
        parent.fail("scene.position_count", n=min(sizes), least=max(LEAST_VECTORS, *sizes))
    order = np.argsort(times)
    try:
        return Orbit(times=times[order], positions=positions[order], velocities=velocities[order]).fitted()
    except InputError as error:
        raise error.at(parent.file, parent.line or None, parent.name) from None


def corners(size_px: tuple[int, int], along: float, across: float) -> Array:
    """Image points (4, 2) of the near and the far corner of the earliest line, and of the latest.

    along, across  1: lines run from the earliest, columns from the nearest; else -1
    """
    columns, rows = size_px
    return np.array(
        [[columns - 0.5 if (k % 2) == (across > 0) else 0.5, rows - 0.5 if (k > 1) == (along > 0) else 0.5]
         for k in range(4)]
    )  # fmt: skip


def rounded_jointly(times: Array) -> bool:
    """Whether positions that are rounded to whole cm are interpolated together with their velocities."""
    return bool(np.median(np.abs(np.diff(times))) > SHORT_S)


@dataclass(frozen=True, slots=True, kw_only=True)
class Columns:
    """Slant ranges of columns: of a range that grows by so much from pixel to pixel, or its polynomials at times."""

    spacing_m: float
    near_m: float
    """At the centre of the nearest pixel"""
    times: Array
    coefficients: Array

    @staticmethod
    def slant(spacing_m: float, near_m: float) -> Columns:
        """Columns are slant ranges."""
        return Columns(spacing_m=spacing_m, near_m=near_m, times=np.zeros(1), coefficients=np.array([[0.0, 1.0]]))

    def scene(
        self, size_px: tuple[int, int], orbit: Orbit, lines_s: tuple[float, float], *, sign: float, side: float,
        height_m: float,
    ) -> RangeDoppler:  # fmt: skip
        """A scene in one piece.

        lines_s  time of the first line's centre, and from line to line
        sign     1: the first column is the nearest, -1: the farthest
        """
        first_s, line_s = lines_s
        first = self.near_m + (0 if sign > 0 else size_px[0] - 1) * self.spacing_m
        return RangeDoppler(
            width_px=size_px[0], height_px=size_px[1], orbit=orbit, burst_y=np.zeros(1),
            burst_times=np.array([first_s - line_s / 2]), line_s=line_s, pixel_m=sign * self.spacing_m,
            first_m=first - sign * self.spacing_m / 2, range_times=self.times, range_coefficients=self.coefficients,
            range_steps=True, side=side, height_m=round(height_m, 1),
        )  # fmt: skip


def ground_columns(spacing_m: float, entries: Sequence[tuple[float, float, Array]]) -> Columns:
    """Columns are ground ranges from the nearest pixel on.

    entries  times [s], origins g0 [m] and coefficients of slant range by powers of (g - g0)
    """
    entries = sorted(entries, key=lambda e: e[0])
    degree = max(2, *(len(c) for _, _, c in entries))
    table = np.zeros((len(entries), degree))
    for row, (_, origin, c) in zip(table, entries, strict=True):
        for k, value in enumerate(c):
            for j in range(k + 1):
                row[j] += value * comb(k, j) * (-origin) ** (k - j)
    return Columns(spacing_m=spacing_m, near_m=0.0, times=np.array([t for t, _, _ in entries]), coefficients=table)


def tied(
    scene: RangeDoppler, geographic: Array, xy_px: Array, limit_px: float = LEAST_PX
) -> tuple[RangeDoppler, tuple[Message, ...]]:  # fmt: skip
    """A scene, and a warning where the tie points of its file contradict it.

    Where there are several polynomials of range, the tie points choose between the nearest in time and the mean of two.
    """
    if not len(xy_px):
        return scene, ()
    several = len(scene.range_times) > 1
    found = [(_mean_px(s, geographic, xy_px), s) for s in ((scene, replace(scene, range_steps=False))[: 1 + several])]
    rms, best = min(found, key=lambda f: f[0])
    if rms <= limit_px:
        return best, ()
    meets = bool(np.isfinite(rms))
    found_px = rms if meets else None
    return best, (
        warning("scene.tie_points", n=len(xy_px), meets=meets, rms_px=found_px, limit_px=limit_px),
    )  # fmt: skip


def _mean_px(scene: RangeDoppler, geographic: Array, xy_px: Array) -> float:
    try:
        d = scene.project(geographic) - xy_px
    except RaybundleError:
        return float("inf")
    return float(np.sqrt(np.mean(np.sum(d * d, axis=1))))


def tie_points(grid: Element | None) -> tuple[Array, Array]:
    """Longitude, latitude, height (n, 3) and image points (n, 2) of the elements imageTiePoint."""
    points = [] if grid is None else list(grid.all("imageTiePoint"))
    ground = [[p.get("geodeticCoordinate").number(k) for k in ("longitude", "latitude", "height")] for p in points]
    image = [[p.get("imageCoordinate").number(k) for k in ("pixel", "line")] for p in points]
    return np.array(ground).reshape(-1, 3), np.array(image).reshape(-1, 2) + 0.5


def rational_functions(element: Element) -> Rpc:
    """The RPC of the element rationalFunctions."""
    order = ("longitude", "latitude", "height")
    names = [f"{a}{b}Coefficients" for a in ("line", "pixel") for b in ("Numerator", "Denominator")]
    return rpc_of(
        coefficients=np.stack([element.get(n).numbers(20) for n in names]),
        ground_offset=np.array([element.number(f"{k}Offset") for k in order]),
        ground_scale=np.array([element.number(f"{k}Scale") for k in order]),
        image_offset=np.array([element.number(f"{k}Offset") for k in ("pixel", "line")]) + 0.5,
        image_scale=np.array([element.number(f"{k}Scale") for k in ("pixel", "line")]),
        err_bias_m=element.number("biasError", 0.0) or None,
        err_rand_m=element.number("randomError", 0.0) or None,
    )
