"""Figures of a set of photographs: match graph, common points, coverage, overlap, and residuals by radius."""

from __future__ import annotations

import math
from dataclasses import dataclass
from html import escape
from typing import TYPE_CHECKING

import numpy as np

from raybundle.adjustment.statistics.network import FEW
from raybundle.errors import phrase
from raybundle.numerics.arrays import Array, Index
from raybundle.report.figures.svg import (
    Drawing,
    Plot,
    axes,
    columns,
    dots,
    drawing,
    fitted,
    label,
    labels_apart,
    mixed,
    span,
    spread_rows,
    written,
)
from raybundle.report.text.numbers import grouped
from raybundle.report.view import View

if TYPE_CHECKING:
    from scipy.sparse import csr_array

MOST_DOTS, MOST_EDGES, MOST_CELLS, MOST_NAMES = 6000, 1500, 60, 40
"""Points and edges drawn, cells of the matrix along each side, images with their names."""
STRONG = 100
"""Common points of a firm connection."""
CLASSES = ((2, 2, "2"), (3, 3, "3"), (4, 5, "4–5"), (6, 9, "6–9"), (10, 10**9, "≥ 10"))
"""Ray counts that are distinguished."""
OVERLAP_COLOUR = (31, 90, 138)


@dataclass(frozen=True, slots=True, kw_only=True)
class Plan:
    """The plane that maps are drawn in."""

    origin: Array
    axes: Array
    """(2, 3) unit vectors that run right and up in the map"""
    names: tuple[str, str]
    oblique: bool = False
    """Whether it is the plane of the largest spread, as the directions of the axes are arbitrary; else XY"""
    """What the plane is, for captions"""

    def of(self, xyz: Array) -> Array:
        """Map coordinates (n, 2) of object points (n, 3)."""
        return (np.asarray(xyz) - self.origin) @ self.axes.T


def plan_of(view: View) -> Plan:
    """The XY plane; where the rotation of the system is arbitrary, the plane of the largest spread of the points."""
    unit = view.length_unit
    if not any(part.startswith("rotation") for part in view.adjustment.datum_defect):
        return Plan(origin=np.zeros(3), axes=np.eye(3)[:2], names=(f"X [{unit}]", f"Y [{unit}]"))
    rows = seen_points(view)
    xyz, centre = view.adjusted.points.xyz[rows], view.adjusted.images.centre
    xyz = np.vstack([xyz[spread_rows(len(rows), 20_000)], centre[np.isfinite(centre).all(axis=1)]])
    if len(xyz) < 3:
        return Plan(origin=np.zeros(3), axes=np.eye(3)[:2], names=(f"X [{unit}]", f"Y [{unit}]"))
    middle = np.median(xyz, axis=0)
    near = xyz - middle
    distance = np.linalg.norm(near, axis=1)
    near = near[distance <= np.quantile(distance, 0.98)]
    _, turned = np.linalg.eigh(near.T @ near)
    right, up = turned[:, 2], turned[:, 1]
    right, up = right * np.sign(right[np.argmax(abs(right))]), up * np.sign(up[np.argmax(abs(up))])
    return Plan(
        origin=middle,
        axes=np.stack([right, up]),
        names=(phrase("axis.along_object", unit=unit), phrase("axis.across", unit=unit)),
        oblique=True,
    )


def seen_points(view: View) -> Index:
    """Rows of object points with coordinates and a used ray."""
    return np.flatnonzero((view.rays > 0) & np.isfinite(view.adjusted.points.xyz).all(axis=1)).astype(np.int32)


def taken_images(view: View) -> Index:
    """Rows of images with an orientation and a used observation."""
    taken = np.zeros(len(view.given.images), bool)
    taken[view.given.observations.image[view.used]] = True
    return np.flatnonzero(taken & view.adjusted.images.oriented).astype(np.int32)


def common_points(view: View, images: Index) -> csr_array:
    """Number (n, n) of used object points that two of these images share, of an image with itself none."""
    from scipy.sparse import csr_array

    row = np.full(len(view.given.images), -1)
    row[images] = np.arange(len(images))
    o = view.given.observations
    keep = view.used & (row[o.image] >= 0)
    cells = (row[o.image[keep]], o.point[keep])
    shape = (len(images), len(view.given.points))
    seen = csr_array((np.ones(int(keep.sum())), cells), shape=shape)
    seen.data[:] = 1.0
    common = (seen @ seen.T).tocsr()
    common.setdiag(0.0)
    common.eliminate_zeros()
    common.sort_indices()
    return common


def square_plot(xy: Array, *, width: float = 640, most_height: float = 520) -> Plot:
    """A plot of equal scale along both axes that holds these map coordinates (n, 2)."""
    x_range, y_range = span(xy[:, 0]), span(xy[:, 1])
    dx, dy = x_range[1] - x_range[0], y_range[1] - y_range[0]
    side = max(dx, dy)
    (x0, x1), (y0, y1) = x_range, y_range
    dx, dy = max(dx, 0.15 * side), max(dy, 0.15 * side)
    x_range = ((x0 + x1 - dx) / 2, (x0 + x1 + dx) / 2)
    y_range = ((y0 + y1 - dy) / 2, (y0 + y1 + dy) / 2)
    left = fitted(Plot(width=width, x_range=x_range, y_range=y_range)).left
    scale = min((width - left - 10) / dx, (most_height - 46) / dy)
    return Plot(
        width=left + 10 + dx * scale, height=46 + dy * scale, left=left, x_range=x_range, y_range=y_range
    )  # fmt: skip


def partners_of(common: csr_array) -> Index:
    """Of each image (n,) those that share FEW points with it at least."""
    rows = np.asarray(common.tocoo().row, np.int64)
    return np.bincount(rows[np.asarray(common.data, float) >= FEW], minlength=len(common.indptr) - 1)


def edges_of(common: csr_array) -> tuple[Index, Index, Array]:
    """Pairs of images to be drawn and their common points: the strongest, and the two strongest of every image."""
    cells = common.tocoo()
    row, col = (np.asarray(x, np.int64) for x in (cells.row, cells.col))
    count = np.asarray(cells.data, float)
    chosen = np.flatnonzero(row < col)
    if len(chosen) > MOST_EDGES:
        strongest = chosen[np.argsort(-count[chosen], kind="stable")[:MOST_EDGES]]
        of_image = np.lexsort((col, -count, row))
        two = of_image[np.arange(len(of_image)) - np.asarray(common.indptr, np.int64)[row[of_image]] < 2]
        pair = np.minimum(row, col) * len(common.indptr) + np.maximum(row, col)
        chosen = chosen[np.isin(pair[chosen], pair[np.r_[strongest, two]])]
    chosen = chosen[np.argsort(count[chosen], kind="stable")]
    return row[chosen].astype(np.int32), col[chosen].astype(np.int32), count[chosen]


def match_graph(view: View, plan: Plan, images: Index, common: csr_array) -> Drawing:
    """Images at their projection centres, joined where they share points; the wider the line, the more of them."""
    xy = plan.of(view.adjusted.images.centre[images])
    plot = square_plot(xy)
    x, y = plot.x(xy[:, 0]), plot.y(xy[:, 1])
    ids = [view.given.images.ids[i] for i in images]
    parts = [axes(plot, *plan.names, grid="xy")]
    first, second, count = edges_of(common)
    named = len(first) <= 400
    most = max(float(count.max(initial=0)), STRONG)
    for i, j, n in zip(first.tolist(), second.tolist(), count.astype(int).tolist(), strict=True):
        style = "edge strong" if n >= STRONG else "edge" if n >= FEW else "edge weak"
        width = 0.4 + 3.6 * math.sqrt(n / most)
        pair = written(phrase("drawn.pair", first=ids[i], second=ids[j], n=n))
        title = f"<title>{pair}</title>" if named else ""
        parts.append(
            f'<path class="{style}" stroke-width="{width:.1f}" d="M{x[i]:.1f} {y[i]:.1f}L{x[j]:.1f} {y[j]:.1f}">'
            f"{title}</path>"
        )
    for k, name in enumerate(ids):
        parts.append(
            f'<circle class="node" cx="{x[k]:.1f}" cy="{y[k]:.1f}" r="3.6"><title>{escape(name)}</title></circle>'
        )
    if len(ids) <= MOST_NAMES:
        parts += labels_apart(x.tolist(), y.tolist(), [_short(name) for name in ids], plot.box)
    return drawing(plot.width, plot.height, parts, phrase("drawn.match_graph"))


def _short(name: str, most: int = 14) -> str:
    return name if len(name) <= most else f"…{name[-most + 1 :]}"


def match_matrix(ids: list[str], common: csr_array) -> tuple[Drawing, int]:
    """Common points of every two images as a matrix, and how many images stand for one of its cells."""
    group = -(-len(ids) // MOST_CELLS)
    n = -(-len(ids) // group)
    cells = common.tocoo()
    values = np.zeros((n, n))
    np.maximum.at(values, (cells.row // group, cells.col // group), cells.data)
    size = 20.0 if n <= 16 else 420.0 / n
    left, top = 96.0, 8.0
    width, height = left + n * size + 8, top + n * size + 34
    most = max(float(values.max(initial=0)), 1.0)
    parts: list[str] = []
    names = [ids[k * group] if group == 1 else f"{ids[k * group]} …" for k in range(n)]
    for i in range(n):
        if n <= MOST_NAMES:
            parts.append(label(left - 5, top + (i + 0.68) * size, _short(names[i]), "tiny", anchor="end"))
        for j in range(n):
            value = values[i, j]
            if value <= 0 or (group == 1 and i == j):
                continue
            fill = mixed(0.08 + 0.92 * math.sqrt(value / most), OVERLAP_COLOUR)
            title = f"<title>{escape(f'{names[i]} – {names[j]}: {grouped(float(value))}')}</title>" if n <= 30 else ""
            parts.append(
                f'<rect x="{left + j * size:.1f}" y="{top + i * size:.1f}" width="{size:.1f}" height="{size:.1f}" '
                f'fill="{fill}">{title}</rect>'
            )
    parts.append(f'<rect class="frame" x="{left}" y="{top}" width="{n * size:.1f}" height="{n * size:.1f}"/>')
    key = phrase("drawn.common_points_to", most=int(most))
    parts += colour_key(left, top + n * size + 10, key)
    return drawing(
        max(width, left + 96 + KEY_CHARACTER * len(key)),
        height,
        parts,
        phrase("drawn.match_matrix"),
    ), group


KEY_CHARACTER = 6.4
"""Width of a character beside a colour key [px], rather too much than too little."""


def colour_key(x: float, y: float, words: str) -> list[str]:
    """A strip of colours from zero to the largest value (square-root scale), with its words."""
    parts = [
        f'<rect x="{x + 9 * k:.1f}" y="{y:.1f}" width="9" height="8" '
        f'fill="{mixed(0.08 + 0.92 * k / 9, OVERLAP_COLOUR)}"/>'
        for k in range(10)
    ]
    return [*parts, label(x + 96, y + 8, words, "t")]


def near_points(xy: Array) -> Array:
    """Which map coordinates (n, 2) belong to the main extent: one per cent at either end may lie outside."""
    if len(xy) < 200:
        return np.ones(len(xy), bool)
    low, high = np.quantile(xy, [0.01, 0.99], axis=0)
    pad = 0.25 * (high - low)
    return np.all((xy >= low - pad) & (xy <= high + pad), axis=1)


def ray_map(view: View, plan: Plan) -> tuple[Drawing, int, int]:
    """Object points in the map, coloured by their number of rays; how many are drawn, and of how many."""
    rows = seen_points(view)
    xy = plan.of(view.adjusted.points.xyz[rows])
    inside = near_points(xy)
    rows, xy = rows[inside], xy[inside]
    kept = spread_rows(len(rows), MOST_DOTS)
    xy, rays = xy[kept], view.rays[rows[kept]]
    plot = square_plot(xy, width=446, most_height=430)
    plot = Plot(width=plot.width, height=plot.height + 20, left=plot.left, bottom=56, x_range=plot.x_range,
                y_range=plot.y_range)  # fmt: skip
    parts = [axes(plot, *plan.names, grid="xy")]
    x = plot.left
    for k, (low, high, words) in enumerate(CLASSES):
        mine = (rays <= high) if k == 0 else (rays >= low) & (rays <= high)
        parts.append(dots(plot.x(xy[mine, 0]), plot.y(xy[mine, 1]), f"rays rays{k}"))
        parts.append(dots(np.array([x + 4]), np.array([plot.height - 8.0]), f"rays rays{k} key"))
        parts.append(label(x + 10, plot.height - 4.5, words, "t"))
        x += 22 + 5.6 * len(words)
    width = max(plot.width, x + 10)
    return drawing(width, plot.height, parts, phrase("drawn.ray_map")), len(kept), int((view.rays > 0).sum())


def overlap_cells(view: View, plan: Plan) -> tuple[Plot, Array, tuple[Array, Array]] | None:
    """The map's plot, the number of images (rows, columns) with a point in each cell, and the cells' edges."""
    rows = seen_points(view)
    xy = plan.of(view.adjusted.points.xyz[rows])
    inside = near_points(xy)
    rows, xy = rows[inside], xy[inside]
    if not len(rows):
        return None
    plot = square_plot(xy, width=446, most_height=430)
    (x0, x1), (y0, y1) = plot.x_range, plot.y_range
    across = int(np.clip(math.sqrt(len(rows)) / 2, 6, 48))
    side = max(x1 - x0, y1 - y0) / across
    nx, ny = math.ceil((x1 - x0) / side), math.ceil((y1 - y0) / side)
    cell_of = np.full(len(view.given.points), -1)
    i = np.clip(((xy[:, 0] - x0) / side).astype(int), 0, nx - 1)
    j = np.clip(((xy[:, 1] - y0) / side).astype(int), 0, ny - 1)
    cell_of[rows] = j * nx + i
    o = view.given.observations
    keep = view.used & (cell_of[o.point] >= 0)
    both = np.unique(cell_of[o.point[keep]].astype(np.int64) * len(view.given.images) + o.image[keep])
    count = np.bincount(both // len(view.given.images), minlength=nx * ny).reshape(ny, nx)
    return plot, count, (x0 + side * np.arange(nx + 1), y0 + side * np.arange(ny + 1))


def overlap_map(plan: Plan, found: tuple[Plot, Array, tuple[Array, Array]]) -> Drawing:
    """How many images see each part of the object, in the map."""
    plot, count, (edges_x, edges_y) = found
    plot = Plot(width=plot.width, height=plot.height + 20, left=plot.left, bottom=56, x_range=plot.x_range,
                y_range=plot.y_range)  # fmt: skip
    most = float(count.max())
    x, y = np.minimum(plot.x(edges_x), plot.width - plot.right), np.maximum(plot.y(edges_y), plot.top)
    parts: list[str] = []
    few = count.size <= 2500
    for j, i in zip(*np.nonzero(count), strict=True):
        n = int(count[j, i])
        fill = mixed(0.08 + 0.92 * math.sqrt(n / most), OVERLAP_COLOUR)
        seen = written(phrase("drawn.images", n=n))
        title = f"<title>{seen}</title>" if few else ""
        parts.append(
            f'<rect x="{x[i]:.1f}" y="{y[j + 1]:.1f}" width="{x[i + 1] - x[i]:.1f}" height="{y[j] - y[j + 1]:.1f}" '
            f'fill="{fill}">{title}</rect>'
        )
    parts.append(axes(plot, *plan.names, grid=""))
    parts += colour_key(plot.left, plot.height - 14, phrase("drawn.images_to", most=int(most)))
    return drawing(max(plot.width, plot.left + 190), plot.height, parts, phrase("drawn.overlap"))


def radius_profile(view: View) -> tuple[Array, Array, Array]:
    """Edges (k + 1,) as a share of half the diagonal, rms (k,) of residuals there [px], and their number (k,)."""
    o, images = view.given.observations, view.given.images
    sizes = np.array([(c.width_px, c.height_px) for c in view.given.cameras], float)[images.camera[o.image]]
    radius = np.linalg.norm(o.xy_px - sizes / 2, axis=1) / (np.linalg.norm(sizes, axis=1) / 2)
    edges = np.linspace(0, 1, 11)
    which = np.clip((radius * 10).astype(int), 0, 9)[view.used]
    squares = (view.adjustment.image_observations.residuals_px[view.used] ** 2).sum(axis=1) / 2
    count = np.bincount(which, minlength=10)
    with np.errstate(invalid="ignore", divide="ignore"):
        rms = np.sqrt(np.bincount(which, squares, minlength=10) / count)
    return edges, np.where(count > 0, rms, np.nan), count


def radius_figure(profile: tuple[Array, Array, Array]) -> Drawing:
    """Residuals of image points against their distance from the middle of the format."""
    edges, rms, count = profile
    plot = fitted(Plot(width=300, height=190, x_range=(0, 1), y_range=(0.0, span(rms, zero=True)[1])))
    titles = [phrase("drawn.image_points", n=int(n)) for n in count]
    name = phrase("axis.distance_from_middle")
    parts = [axes(plot, name, phrase("axis.rms_residual")), columns(plot, edges, np.nan_to_num(rms), titles=titles)]
    return drawing(plot.width, plot.height, parts, phrase("drawn.residuals_by_radius"))
