"""Figure: the object with its precision as colour, seen from the side that shows most of it."""

from __future__ import annotations

import math
from dataclasses import dataclass
from html import escape

import numpy as np

from raybundle.errors import Message, Text, note, phrase
from raybundle.numerics.arrays import Array, Mask
from raybundle.report.figures.svg import CHARACTER, Drawing, drawing, label, round_below, spread_rows
from raybundle.report.network.sigma_classes import Classes, sigma_classes
from raybundle.report.text.numbers import plain
from raybundle.report.view import View

WIDTH, MOST_HEIGHT, MARGIN = 330.0, 300.0, 6.0
DOTS = 1500
"""Points that are drawn one by one; of more the median in each cell"""
CELL = 3.0
"""Side of a cell [px]"""
MOST_STATIONS = 400
FAR = 0.005
"""Share of many points on either side that may lie outside"""
BEHIND = 5.0
"""Standard deviation, by the median, from which a point is taken for background: that of depth grows with the square of
the distance, so that it is more than twice as far as the object"""
LEVEL = math.cos(math.radians(30))
"""A plane within 30 degrees of the horizontal is seen from above"""


@dataclass(frozen=True, slots=True, kw_only=True)
class ObjectView:
    """The drawing and its caption."""

    drawing: Drawing
    caption: str
    classes: Classes | None = None
    """of standard deviations"""


def object_view(view: View, *, from_above: bool, heights: bool = True, width: float = WIDTH) -> ObjectView | None:
    """Object points in the colour of their standard deviation; None where none has coordinates.

    from_above  seen along Z, as a map; else square to the plane that fits the points best, from the photographs' side
    heights     whether anybody measured heights; else the colour shows the plan alone
    Points further out than 99 of 100 are left out where there are many.  The colour shows the rms of the three standard
    deviations of a point, of which a cell has the median.
    """
    xyz = view.adjusted.points.xyz
    rows = np.flatnonzero((view.rays > 0) & np.isfinite(xyz).all(axis=1))
    if len(rows) < 3:
        return None
    centres = _centres(view)
    std = np.full(len(rows), np.nan) if view.std is None else rms_of(view.std[rows, : 3 if heights else 2])
    front = _object(std)
    towards, side = (np.eye(3), "above") if from_above else _square_to(xyz[rows[front]], centres, view)
    at, stations = xyz[rows] @ towards[:2].T, centres @ towards[:2].T
    near = _near(at, front)
    rows, at, std = rows[near], at[near], std[near]
    classes = sigma_classes(std, view.unit)
    low, high = _frame(at, stations)
    scale = min(width / (high[0] - low[0]), MOST_HEIGHT / (high[1] - low[1]))
    size = (high - low) * scale

    def placed(p: Array) -> Array:
        return MARGIN + np.column_stack([p[:, 0] - low[0], high[1] - p[:, 1]]) * scale

    parts = [coloured_dots(placed(at), std, classes) if len(at) <= DOTS else _cells(placed(at), std, classes)]
    inside: Mask = np.asarray(((stations >= low) & (stations <= high)).all(axis=1))
    shown = np.flatnonzero(inside)[spread_rows(int(inside.sum()), MOST_STATIONS)]
    parts.append(_stations(placed(stations[shown])))
    right, bottom = 2 * MARGIN + size[0] + 12, MARGIN + size[1]
    legend, wide, lines = _legend(classes, right)
    bar, long = _scale_bar(view, right, max(bottom - 6, lines + 16), scale, size[0])
    parts += [legend, bar]
    height = max(bottom, lines + 24) + MARGIN
    what = phrase("drawn.object", side=side, n=len(rows))
    drawn = drawing(right + max(wide, long), height, parts, what)
    caption = _caption(view, side, len(rows), near, inside, heights=heights)
    return ObjectView(drawing=drawn, caption=caption, classes=classes)


def _caption(view: View, side: str, points: int, near: Mask, inside: Mask, *, heights: bool) -> Text:
    found: list[Message] = [note("drawn.object_points", side=side, n=points)]
    if view.std is None:
        found.append(note("verdict.no_statistics"))
    else:
        found.append(note("drawn.object_colours", plan=not heights, median=points > DOTS))
    if inside.any():
        found.append(note("drawn.object_stations", outside=len(inside) - int(inside.sum())))
    if far := int((~near).sum()):
        found.append(note("report_network.far_points", n=far))
    return Text.of(*found)


def _centres(view: View) -> Array:
    """(n, 3) projection centres of the photographs that took part."""
    taken = np.unique(view.given.observations.image[view.used])
    taken = [i for i in taken.tolist() if not view.given.cameras[int(view.given.images.camera[i])].is_scene]
    centre = view.adjusted.images.centre[taken].reshape(-1, 3)
    return centre[np.isfinite(centre).all(axis=1)]


def _square_to(xyz: Array, centres: Array, view: View) -> tuple[Array, str]:
    """Unit vectors (3, 3) right, up and towards the eye for a view square to the best plane, and how it is seen."""
    some = xyz[spread_rows(len(xyz), 20_000)]
    some = some[_near(some, np.ones(len(some), bool))]
    middle = np.median(some, axis=0)
    axes = np.linalg.svd(some - middle, full_matrices=False)[2]
    normal = axes[2]
    seen_from = float(np.median((centres - middle) @ normal)) if len(centres) else float(normal[2])
    if seen_from < 0:  # of scenes, which stand nowhere: from above
        normal = -normal
    if any(part.startswith("rotation") for part in view.adjustment.datum_defect):
        up = _up_of_photographs(view, normal, axes[1])
    elif abs(normal[2]) > LEVEL:
        up = np.array([0.0, 1.0, 0.0])
    else:
        up = np.array([0.0, 0.0, 1.0])
    up = up - (up @ normal) * normal
    up /= np.linalg.norm(up)
    return np.stack([np.cross(up, normal), up, normal]), "square"


def _up_of_photographs(view: View, normal: Array, other: Array) -> Array:
    """Where nothing shows what is up: the mean upper side of the photographs."""
    R = view.adjusted.images.rotation
    up = R[np.isfinite(R).all(axis=(1, 2)), 1].mean(axis=0) if len(R) else other
    rest = up - (up @ normal) * normal
    return rest if np.linalg.norm(rest) > 0.1 else other


def _object(std: Array) -> Mask:
    """(k,) which points are of the object, and not of what stands behind it; all where that cannot be determined."""
    known = np.isfinite(std)
    if not known.any():
        return np.ones(len(std), bool)
    return np.asarray(~(std > BEHIND * np.median(std[known])))


def _near(at: Array, of: Mask) -> Mask:
    """(k,) whether a point lies within the extent of these points (k,), but for the few of them that lie far out."""
    if len(at) <= 200:
        return np.ones(len(at), bool)
    low, high = np.quantile(at[of], [FAR, 1 - FAR], axis=0)
    pad = 0.02 * (high - low)
    return np.asarray(((at >= low - pad) & (at <= high + pad)).all(axis=1))


def rms_of(std: Array) -> Array:
    """Root mean squares (k,) of the free coordinates of each point; NaN where none is."""
    known = np.isfinite(std)
    with np.errstate(invalid="ignore"):
        return np.sqrt(np.where(known, std, 0.0).__pow__(2).sum(axis=1) / known.sum(axis=1))


def _frame(at: Array, stations: Array) -> tuple[Array, Array]:
    """Lowest and highest corner: of the points, and of stations no farther off than a quarter of their extent."""
    low, high = at.min(axis=0), at.max(axis=0)
    reach = max(float((high - low).max()), 1e-9) / 4
    close = stations[((stations >= low - reach) & (stations <= high + reach)).all(axis=1)]
    if len(close):
        low, high = np.minimum(low, close.min(axis=0)), np.maximum(high, close.max(axis=0))
    pad = max(float((high - low).max()), 1e-9) * 0.03
    least = 0.1 * float((high - low).max())
    lack = np.maximum(0.0, least - (high - low)) / 2
    return low - pad - lack, high + pad + lack


def _class_of(std: Array, classes: Classes | None) -> Array:
    """(k,) positions among the colours; one more where there is no standard deviation."""
    if classes is None:
        return np.zeros(len(std), int)
    found = np.searchsorted(np.array(classes.limits), std, side="left")
    return np.where(np.isfinite(std), found, len(classes.colours))


def _colours(classes: Classes | None) -> tuple[str, ...]:
    return ("#66727e",) if classes is None else (*classes.colours, "#999999")


def coloured_dots(px: Array, std: Array, classes: Classes | None) -> str:
    """Points (k, 2) [px] in the colours of their standard deviations (k,)."""
    of, parts = _class_of(std, classes), list[str]()
    size = float(np.clip(60 / math.sqrt(len(px)), 3.0, 8.0))
    for k, colour in enumerate(_colours(classes)):
        d = "".join(f"M{x:.1f} {y:.1f}h0" for x, y in px[of == k].tolist())
        if d:  # round caps, of a width that every renderer takes as it stands
            parts.append(f'<path class="object" stroke="{colour}" stroke-width="{size:.1f}" d="{d}"/>')
    return "".join(parts)


def _cells(px: Array, std: Array, classes: Classes | None) -> str:
    """Squares in the colour of the median of their points; neighbours of a row that look alike are one."""
    cell = np.floor(px / CELL).astype(int)
    order = np.lexsort((std, cell[:, 0], cell[:, 1]))
    cell, sorted_std = cell[order], std[order]
    starts = np.flatnonzero(np.any(np.diff(cell, axis=0, prepend=cell[:1] - 1) != 0, axis=1))
    known = np.add.reduceat(np.isfinite(sorted_std).astype(int), starts)
    middle = sorted_std[starts + np.maximum(known - 1, 0) // 2]  # NaN stand last
    of, at = _class_of(np.where(known > 0, middle, np.nan), classes), cell[starts]
    parts: list[str] = []
    for k, colour in enumerate(_colours(classes)):
        mine = at[of == k]
        if not len(mine):
            continue
        new = np.flatnonzero(
            (np.diff(mine[:, 1], prepend=-(10**6)) != 0) | (np.diff(mine[:, 0], prepend=-(10**6)) != 1)
        )
        runs = np.diff(np.append(new, len(mine)))
        d = "".join(
            f"M{CELL * x:g} {CELL * y + CELL / 2:g}h{CELL * n:g}"
            for (x, y), n in zip(mine[new].tolist(), runs.tolist(), strict=True)
        )
        parts.append(f'<path class="objectcells" stroke="{colour}" stroke-width="{CELL:g}" d="{d}"/>')
    return "".join(parts)


def _stations(px: Array) -> str:
    d = "".join(f"M{x:.1f} {y - 3:.1f}l2.6 4.6h-5.2z" for x, y in px.tolist())
    return f'<path class="station" d="{d}"/>' if d else ""


def _scale_bar(view: View, x: float, y: float, scale: float, across: float) -> tuple[str, float]:
    """A bar of a round length, and how wide it is with its words."""
    length = round_below(min(across / 4, 110.0) / scale)
    long, words = length * scale, f"{plain(length)} {view.length_unit}"
    bar = f'<path class="scalebar" d="M{x:.1f} {y - 4:.1f}v8m0 -4h{long:.1f}m0 -4v8"/>'
    return bar + label(x + long + 6, y + 3.5, words), long + 8 + CHARACTER * 1.1 * len(words)


def _legend(classes: Classes | None, x: float) -> tuple[str, float, float]:
    """Colours and their words, a line each, how wide they are and where they end."""
    if classes is None:
        return "", 0.0, MARGIN
    parts, wide, y = list[str](), 0.0, MARGIN + 8
    for colour, words in classes.legend:
        if colour:
            parts.append(f'<rect x="{x:.1f}" y="{y - 6:.1f}" width="12" height="12" fill="{escape(colour)}"/>')
        parts.append(label(x + (18 if colour else 0), y + 3.5, words))
        wide = max(wide, (18 if colour else 0) + CHARACTER * 1.1 * len(words) + 4)
        y += 18
    return "".join(parts), wide, y
