"""Targets of a photograph: found, read, measured."""

from __future__ import annotations

from dataclasses import dataclass, field, fields, replace
from typing import TYPE_CHECKING, Literal

import numpy as np

from raybundle.errors import InputError
from raybundle.numerics.arrays import Array, Index, Mask
from raybundle.targets.centre import CONTRAST, DotOptions, DotOutcome, Dots, fit_dots
from raybundle.targets.codes import RingFamily, rotations
from raybundle.targets.partial_dots import measure_dots
from raybundle.targets.pattern import pattern_misfit, settled_misfit
from raybundle.targets.rings import (
    Edges,
    circle,
    find_edges,
    find_parts,
    frame,
    joined,
    read_rings,
    rough_gate,
    sample,
)

if TYPE_CHECKING:
    from raybundle.targets.blobs import Blobs

Polarity = Literal["light", "dark", "both"]
LEAST_RADIUS, LEAST_MAJOR = 2.3, 2.9
"""Least mean radius and least semi-major axis of a dot [px]: texture is full of smaller ones."""
PARTLY = 1.6
"""Least radius to which grey values are looked at where something lies on a dot: what else is there is found out."""
GROUND_PX = 14.0
"""Ground around a dot that is used where there is so much: it shows the slope of the light [px]."""


@dataclass(frozen=True, slots=True, kw_only=True)
class Gate:
    """How much grey values may differ from those of the target drawn, in units of the contrast."""

    pattern: float
    """largest standard deviation of a grey value"""
    sector: float
    """largest mean departure of a sector"""


@dataclass(frozen=True, slots=True, kw_only=True)
class DetectionOptions:
    """What counts as a target."""

    polarity: Polarity = "both"
    """colour of the dots: light on dark, dark on light"""
    contrast: float = 0.05
    """least difference of dot and ground, as a share of the range of the grey values present"""
    misfit: float = 0.06
    """largest rms distance of the edge from an ellipse, in mean radii (and 0.12 px)"""
    quiet: float = 0.45
    """largest departure from the ground between dot and ring, in units of the contrast"""
    margin: float = 0.18
    """least distance of a sector from half way between dark and light"""
    beyond: float = 0.55
    """mean of a sector beyond the ring, in units of the contrast, from which something seems to lie on the target"""
    sure: float = 0.35
    """least margin of the sectors where something lies on a target"""
    residual: float = 0.08
    """largest standard deviation of a grey value in the fit of the dot, in units of the contrast"""
    small_gates: tuple[Gate, ...] = (Gate(pattern=0.10, sector=0.10),)
    """of targets that are small"""
    large_gates: tuple[Gate, ...] = (Gate(pattern=0.22, sector=0.13), Gate(pattern=0.10, sector=0.06))
    """of others: as they were read, since rings may be worn, unevenly lit or bent by perspective; and where that is
    not enough, moved to where the grey values want them.  A grey thing that covers two sectors and makes another
    number of them leaves more"""
    small: float = 6.0
    """mean radius of the dot below which a target is small: its sectors, blurred as they are, need only a third of
    `margin`, but the whole must look like the target drawn [px]"""
    uncoded: Literal["none", "dots"] = "dots"
    """whether dots without a ring are measured, too"""
    threads: int = 1
    dot: DotOptions = field(default_factory=DotOptions)


@dataclass(frozen=True, slots=True, kw_only=True)
class Detections:
    """Targets of one photograph: those with a code first, by id; then dots without."""

    family: str
    id: Index
    """(n,) number in the family; -1 for a dot without a ring that can be read"""
    code: Index
    """(n,) canonical code; -1 without"""
    xy_px: Array
    """(n, 2) centre of the dot's ellipse, pixel frame"""
    covariance: Array
    """(n, 2, 2) of the centre [px^2], from the grey values alone"""
    ellipse: Array
    """(n, 2, 2) C of the edge (x - centre)' C^-1 (x - centre) = 1 [px^2]"""
    polarity: Index
    """(n,) +1 light dot, -1 dark dot"""
    contrast: Array
    """(n,) grey value of the dot less that of the ground"""
    residual: Array
    """(n,) standard deviation of a grey value in the fit, in units of the contrast"""
    margin: Array
    """(n,) least distance of a sector from half way between dark and light, 0.5 at best; NaN without a code"""
    begin: Array
    """(n,) direction in the image in which sector 0 begins, counter-clockwise as seen [rad]; NaN without a code"""

    def __len__(self) -> int:
        return len(self.id)

    @property
    def coded(self) -> Mask:
        """(n,) whether the target has a number."""
        return self.id >= 0

    def rows(self, chosen: Index | Mask) -> Detections:
        """Some of them."""
        return Detections(
            family=self.family, id=self.id[chosen], code=self.code[chosen], xy_px=self.xy_px[chosen],
            covariance=self.covariance[chosen], ellipse=self.ellipse[chosen], polarity=self.polarity[chosen],
            contrast=self.contrast[chosen], residual=self.residual[chosen], margin=self.margin[chosen],
            begin=self.begin[chosen],
        )  # fmt: skip


@dataclass(frozen=True, slots=True, kw_only=True)
class Found:
    """Dots with their rings before they are measured."""

    edges: Edges
    id: Index
    code: Index
    margin: Array
    begin: Array
    """(n,) where sector 0 of the code begins, in the frame of the dot [rad]"""


def detect_targets(image: Array, family: RingFamily | None, options: DetectionOptions | None = None) -> Detections:
    """Find, read and measure the targets of a photograph.

    image   (h, w) uint8 or uint16
    family  the rings in use: it must be named, since families share rings under different numbers; None: dots alone

    A number found twice keeps both places: which is wrong, if any, is for the network to say.
    What the covariance does not show stands in `covered.measure_dots`.
    """
    o = options or DetectionOptions()
    eight, scale = eight_bits(image)
    return _measure(image, find_targets(eight, family, o), family, o, scale)


def eight_bits(image: Array) -> tuple[Array, float]:
    """The image (h, w) as uint8, for finding; and grey values per step of it."""
    if image.ndim != 2 or str(image.dtype) not in {"uint8", "uint16"}:
        raise InputError("target.image_type", kind=str(image.dtype), shape=image.shape)
    if image.dtype == np.uint8:
        return np.ascontiguousarray(image), 1.0
    top = max(
        float(np.percentile(image[:: max(1, image.shape[0] // 500), :: max(1, image.shape[1] // 500)], 99.9)), 255.0
    )
    return np.clip(image * np.float32(255 / top), 0, 255).astype(np.uint8), top / 255


def find_targets(image: Array, family: RingFamily | None, options: DetectionOptions) -> Found:
    """Dots and their numbers, to about a tenth of a pixel; image (h, w) uint8."""
    from raybundle.targets.blobs import find_blobs

    o = options
    small = image[:: max(1, image.shape[0] // 400), :: max(1, image.shape[1] // 400)]
    least = max(6.0, o.contrast * float(np.subtract(*np.percentile(small, [99.5, 0.5]))))
    if min(image.shape) < 8:
        return _nothing()
    blobs = find_blobs(image, least, o.threads)
    wanted = {"light": 1, "dark": -1, "both": 0}[o.polarity]
    chosen = np.flatnonzero(blobs.sign == wanted) if wanted else np.arange(len(blobs.sign))
    chosen = chosen[rough_gate(image, blobs.xy_px[chosen], blobs.ellipse[chosen], blobs.sign[chosen], least)]
    edges = _whole_and_parts(image, blobs, chosen, o)
    n = len(edges.xy_px)
    ids, code, margin, begin = np.full(n, -1), np.full(n, -1), np.full(n, np.nan), np.full(n, np.nan)
    if family is not None and n:
        r = read_rings(image, edges, family)
        number = family.id_of(r.code)
        # small rings are blurred into each other; they are drawn as a whole later, which is the stricter test
        least_margin = np.where(r.beyond < o.beyond, o.margin, o.sure)
        least_margin = np.where(_radius(edges.ellipse) < o.small, o.margin / 3, least_margin)
        good = (number >= 0) & (r.margin >= least_margin) & (edges.quiet < o.quiet)
        good &= _reaches(edges, image.shape, family.read[1] + 0.1)
        ids[good], margin[good] = number[good], r.margin[good]
        if good.any():
            code[good] = family.code_of(number[good])
            later = np.argmax(rotations(r.code[good], family.bits) == code[good, None], axis=1)
            begin[good] = r.begin[good] + later * 2 * np.pi / family.bits
    order = np.lexsort((edges.xy_px[:, 0], np.where(ids < 0, np.iinfo(np.int64).max, ids)))
    return Found(edges=edges.rows(order), id=ids[order], code=code[order], margin=margin[order], begin=begin[order])


def _whole_and_parts(image: Array, blobs: Blobs, chosen: Index, o: DetectionOptions) -> Edges:
    """Dots by their whole edge; and, where none was found, by the larger part of it."""
    spots = blobs.xy_px[chosen], blobs.ellipse[chosen], blobs.sign[chosen]
    edges = find_edges(image, *spots, rays=12)
    edges = edges.rows(_plausible(edges, image.shape, 2.0 * o.misfit, o.quiet + 0.25))
    rest = np.setdiff1d(np.arange(len(chosen)), edges.source)
    edges = edges.rows(_distinct(edges, edges.misfit))
    whole = find_edges(image, edges.xy_px, edges.ellipse, np.sign(edges.contrast))
    fine = _plausible(whole, image.shape, o.misfit, np.inf)
    lost = np.setdiff1d(np.arange(len(edges.xy_px)), whole.source[fine])
    whole = whole.rows(fine)
    parts = [find_parts(image, *(a[rest] for a in spots))]
    parts.append(find_parts(image, edges.xy_px[lost], edges.ellipse[lost], np.sign(edges.contrast[lost])))
    found = joined([whole, *(p.rows(_plausible(p, image.shape, o.misfit, np.inf, margin=0.0)) for p in parts)])
    if not found.partly.any():
        return whole
    # a part beside a whole one is the same dot, or none
    return found.rows(_distinct(found, found.misfit + 1e6 * found.partly))


def _nothing() -> Found:
    none = np.zeros(0)
    edges = Edges(
        xy_px=np.zeros((0, 2)), ellipse=np.zeros((0, 2, 2)), ground=none, contrast=none, misfit=none, quiet=none,
        source=none.astype(np.int64), partly=none > 0,
    )  # fmt: skip
    whole = none.astype(np.int64)
    return Found(edges=edges, id=whole, code=whole, margin=none, begin=none)


def _radius(ellipse: Array) -> Array:
    return np.sqrt(np.sqrt(np.maximum(np.linalg.det(ellipse), 0)))


def _reaches(edges: Edges, shape: tuple[int, ...], radii: float) -> Mask:
    """Whether so many radii around the dot lie within the image."""
    reach = radii * np.sqrt(edges.ellipse[:, [0, 1], [0, 1]])
    inside = (edges.xy_px - reach > 0) & (edges.xy_px + reach < np.array([shape[1], shape[0]]))
    return np.all(inside, axis=1)


def _plausible(edges: Edges, shape: tuple[int, ...], misfit: float, quiet: float, margin: float = 1.25) -> Mask:
    radius, trace = _radius(edges.ellipse), edges.ellipse[:, 0, 0] + edges.ellipse[:, 1, 1]
    major = np.sqrt((trace + np.sqrt(np.maximum(trace**2 - 4 * radius**4, 0))) / 2)
    return (
        (radius > LEAST_RADIUS)
        & (major > LEAST_MAJOR)
        & (edges.misfit < misfit * radius + 0.12)
        & (edges.quiet < quiet)
        & _reaches(edges, shape, margin)
    )  # fmt: skip


def _distinct(edges: Edges, badness: Array) -> Index:
    """Positions of dots, the best of each group within half a radius of each other, by a grid of cells."""
    radius = _radius(edges.ellipse)
    order = np.argsort(badness / radius, kind="stable")
    cells: dict[tuple[int, int], list[int]] = {}
    kept: list[int] = []
    for i in order:
        x, y = edges.xy_px[i]
        cx, cy = int(x // 8), int(y // 8)
        reach = 1 + int(radius[i] // 16)
        near = [
            j
            for a in range(cx - reach, cx + reach + 1)
            for b in range(cy - reach, cy + reach + 1)
            for j in cells.get((a, b), ())
        ]
        if any(np.hypot(*(edges.xy_px[j] - edges.xy_px[i])) < 0.5 * min(radius[i], radius[j]) for j in near):
            continue
        cells.setdefault((cx, cy), []).append(int(i))
        kept.append(int(i))
    return np.sort(np.array(kept, np.int64))


def _as_drawn(
    image: Array, dots: Dots, row: int, ring: tuple[int, float], family: RingFamily, gates: tuple[Gate, ...]
) -> bool:
    """Whether a target looks like the one that was read: as it was read, or moved to where the grey values want it."""
    return any(
        misfit < gate.pattern and sector < gate.sector
        for gate, drawn in zip(gates, (pattern_misfit, settled_misfit), strict=False)
        for misfit, sector in [drawn(image, dots.values[row], *ring, family, covered=bool(dots.covered[row]))]
    )


def clean_ground(image: Array, edges: Edges, farthest: float = 4.2) -> Array:
    """Radii (n,) to which the ground around dots is even; at most `farthest`."""
    rho = np.arange(1.3, farthest + 0.01, 0.1)
    u = circle(np.arange(24) * np.pi / 12)
    places = edges.xy_px[:, None] + (u * rho[:, None, None]).reshape(-1, 2) @ frame(edges.ellipse).transpose(0, 2, 1)
    v = sample(image, places).reshape(len(edges.xy_px), len(rho), 24)
    # light may fall off across a target; what lies on one side only is more than a quarter of the contrast
    slope = np.einsum("nrk,ki->nri", v, u) / 12
    amplitude = np.hypot(slope[..., 0], slope[..., 1])
    slope *= np.minimum(1, 0.25 * abs(edges.contrast[:, None]) / np.maximum(amplitude, 1e-9))[..., None]
    v = v - slope @ u.T
    h, w = image.shape
    # even is what differs little around a circle, and from the darkest (lightest) circle around a light (dark) dot
    middle = np.median(v, axis=2)
    best = np.where(edges.contrast > 0, middle.min(axis=1), middle.max(axis=1))
    allowed = 0.15 * abs(edges.contrast[:, None]) + 6
    off = (abs(v - middle[..., None]) > allowed[..., None]) | (abs(middle - best[:, None]) > allowed)[..., None]
    outside = ((places < 1) | (places > [w - 1, h - 1])).any(axis=2).reshape(off.shape)
    bad = np.any(off | outside, axis=2)
    # the blur of the dot itself ends where the ground is reached for the first time
    ground = np.argmax(~bad, axis=1)
    beyond = bad & (np.arange(len(rho)) > ground[:, None])
    first = np.where(beyond.any(axis=1), np.argmax(beyond, axis=1), len(rho))
    return np.where(bad.all(axis=1), rho[0], rho[first - 1])


def _measure(image: Array, found: Found, family: RingFamily | None, o: DetectionOptions, scale: float) -> Detections:
    """Fit the dots and keep those whose grey values are those of a dot; pieces of rings that were read are none."""
    coded = _measured(image, found, np.flatnonzero(found.id >= 0), family, o, scale)
    if o.uncoded == "none":
        return coded
    bare = np.flatnonzero(found.id < 0)
    if family is not None:
        bare = bare[~_within_targets(found.edges.xy_px[bare], coded, family.ring[1])]
    dots = _measured(image, found, bare, None, o, scale)
    arrays = {
        f.name: np.concatenate([getattr(coded, f.name), getattr(dots, f.name)])
        for f in fields(Detections)
        if f.name != "family"
    }
    return Detections(family=coded.family, **arrays)


def _within_targets(xy: Array, targets: Detections, radii: float) -> Mask:
    """Which places (n,) lie within so many radii of the dot of a target: nothing but its ring is printed there."""
    inside = np.zeros(len(xy), bool)
    for centre, inverse in zip(targets.xy_px, np.linalg.inv(targets.ellipse), strict=True):
        d = xy - centre
        inside |= np.einsum("ni,ij,nj->n", d, inverse, d) < radii**2
    return inside


def _measured(
    image: Array, found: Found, chosen: Index, family: RingFamily | None, o: DetectionOptions, scale: float
) -> Detections:
    """The dots `chosen` (k,) that are dots: of targets of a family, or without a ring."""
    e = found.edges.rows(chosen)
    minor = np.sqrt(np.linalg.eigvalsh(e.ellipse)[:, 0]) if len(e.ellipse) else np.zeros(0)
    window = np.minimum(0.94 * clean_ground(image, _scaled(e, scale)), 1 + GROUND_PX / np.maximum(minor, 1))
    # dots that are blurred are larger than they seem
    room = 0.85 * (np.minimum(e.xy_px, np.array([image.shape[1], image.shape[0]]) - e.xy_px) - 1)
    window = np.minimum(window, (room / np.sqrt(e.ellipse[:, [0, 1], [0, 1]])).min(axis=1, initial=np.inf))
    window = np.clip(window, np.where(e.partly, PARTLY, 1.25), 4.0)
    if family is not None:
        window = np.full(len(chosen), (1 + family.ring[0]) / 2)
    dots = measure_dots(image, e.xy_px, e.ellipse, window, o.dot, None if family is not None else e.partly)
    retry = ~dots.measured & (dots.outcome != DotOutcome.COVERED)
    if retry.any() and family is None:
        again = fit_dots(image, e.xy_px[retry], e.ellipse[retry], np.full(retry.sum(), 1.3), o.dot)
        _replace(dots, retry, again)
    # a dot with a whole edge in a ring that is read is one, however rough
    retry = (dots.outcome == DotOutcome.COVERED) & ~e.partly
    if retry.any() and family is not None:
        _replace(dots, retry, fit_dots(image, e.xy_px[retry], e.ellipse[retry], window[retry], o.dot))
    contrast = dots.values[:, CONTRAST]
    residual = dots.residual / np.maximum(abs(contrast), 1e-9)
    good = dots.measured & (residual < o.residual) & (np.sign(contrast) == np.sign(e.contrast))
    if family is not None:
        small = _radius(e.ellipse) < o.small
        for i in np.flatnonzero(good):
            ring = int(found.code[chosen[i]]), float(found.begin[chosen[i]])
            good[i] = _as_drawn(image, dots, int(i), ring, family, o.small_gates if small[i] else o.large_gates)
    begin = np.einsum(
        "nij,nj->ni", frame(e.ellipse), np.stack([np.cos(found.begin[chosen]), -np.sin(found.begin[chosen])], axis=1)
    )
    return Detections(
        family="" if family is None else family.name,
        id=found.id[chosen][good], code=found.code[chosen][good], xy_px=dots.xy_px[good],
        covariance=dots.cov_px2[good], ellipse=dots.ellipse[good], polarity=np.sign(contrast[good]).astype(np.int64),
        contrast=contrast[good], residual=residual[good], margin=found.margin[chosen][good],
        begin=np.arctan2(-begin[good, 1], begin[good, 0]),
    )  # fmt: skip


def _replace(dots: Dots, rows: Mask, by: Dots) -> None:
    """Rows of fits by others."""
    for whole, part in (
        (dots.values, by.values), (dots.cov_px2, by.cov_px2), (dots.residual, by.residual), (dots.doubts, by.doubts),
        (dots.outcome, by.outcome), (dots.covered, by.covered),
    ):  # fmt: skip
        whole[rows] = part


def _scaled(e: Edges, scale: float) -> Edges:
    """Levels in grey values of the image itself."""
    return replace(e, ground=e.ground * scale, contrast=e.contrast * scale)
