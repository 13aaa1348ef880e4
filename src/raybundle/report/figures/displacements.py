"""Figures: vectors of points in two views of the object, deviations or motions; errors of lengths over the lengths."""

from __future__ import annotations

import math
from collections.abc import Sequence
from html import escape

import numpy as np

from raybundle.errors import phrase
from raybundle.numerics.arrays import Array, Mask
from raybundle.report.figures.svg import (
    Drawing,
    Plot,
    axes,
    drawing,
    fitted,
    label,
    labels_apart,
    line,
    round_below,
    span,
    vectors,
)
from raybundle.report.text.numbers import plain, significant

WIDTH, HEIGHT, MARGIN = 330.0, 240.0, 26.0
LONGEST = 0.16
"""Length of the usual vector, as a share of the width, where points are few; of many it spans what lies between two"""
USUAL = 0.9
"""Share of the vectors that are no longer than what the scale is chosen by"""
BEYOND = 3.0
"""Times the usual vector at which longer ones are cut"""


def principal_axes(xyz: Array) -> Array:
    """(3, 3) unit vectors: right and up of the view that shows most of points (n, 3), and towards the eye.

    Up is as near to Z as may be, or to Y where the plane of the points is level.
    """
    normal = np.linalg.svd(xyz - xyz.mean(axis=0), full_matrices=False)[2][2]
    level = abs(normal[2]) > math.cos(math.radians(30))
    if level:
        normal = normal if normal[2] > 0 else -normal
    elif normal[1] > 0:
        normal = -normal  # from the front, which is where Y comes from
    up = np.array([0.0, 1.0, 0.0]) if level else np.array([0.0, 0.0, 1.0])
    up = up - (up @ normal) * normal
    up /= np.linalg.norm(up)
    return np.stack([np.cross(up, normal), up, normal])


def displacement_views(
    ids: Sequence[str], xyz: Array, d: Array, marked: Mask, unit: tuple[float, str], kind: str
) -> tuple[tuple[Drawing, str], ...]:
    """Two drawings with their captions: components in the plane that fits the points best, and from its edge.

    xyz     (n, 3) points [m]; d (n, 3) their vectors [m]; marked (n,) which stand out, and are named
    unit    factor from metres and name, of the vectors
    kind    deviations or displacements
    """
    frame = principal_axes(xyz)
    length = np.linalg.norm(d, axis=1)
    usual = float(np.quantile(length[np.isfinite(length)], USUAL)) if np.isfinite(length).any() else 0.0
    usual = max(usual, float(np.nanmax(length, initial=0.0)) / BEYOND)
    reference = round_below(usual * unit[0]) / unit[0] if usual > 0 else 1.0 / unit[0]
    size = f"{plain(reference * unit[0])} {unit[1]}"
    long_px = min(LONGEST * WIDTH, math.sqrt(WIDTH * HEIGHT / max(len(ids), 1)))
    per_m = long_px / max(usual, reference)
    found: list[tuple[Drawing, str]] = []
    for right, up in ((0, 1), (0, 2)):
        drawn = _view(
            ids, xyz @ frame[[right, up]].T, d @ frame[[right, up]].T, marked, (per_m, long_px), (reference, size),
            phrase("drawn.vectors", kind=kind),
        )  # fmt: skip
        found.append((drawn, phrase("drawn.vectors_in", kind=kind, across=up == 2)))
    return tuple(found)


def _view(
    ids: Sequence[str], at: Array, d: Array, marked: Mask, scaled: tuple[float, float], reference: tuple[float, str],
    what: str,
) -> Drawing:  # fmt: skip
    per_m, long_px = scaled
    low, high = at.min(axis=0), at.max(axis=0)
    wide, tall = np.maximum(high - low, 1e-9 * max(float(np.ptp(at, axis=0).max()), 1e-9))
    scale = min((WIDTH - 2 * MARGIN) / wide, (HEIGHT - 2 * MARGIN) / tall)
    height = tall * scale + 2 * MARGIN
    x = MARGIN + (at[:, 0] - low[0]) * scale
    y = height - MARGIN - (at[:, 1] - low[1]) * scale
    v = d * per_m
    size = np.maximum(np.linalg.norm(v, axis=1), 1e-300)
    v = v * np.minimum(1.0, BEYOND * long_px / size)[:, None]
    parts = [vectors(x[~marked], y[~marked], v[~marked, 0], -v[~marked, 1], "vector bold")]
    if marked.any():
        parts.append(vectors(x[marked], y[marked], v[marked, 0], -v[marked, 1], "vector bold strange"))
    for k, name in enumerate(ids):
        style = "control" if marked[k] else "dot"
        parts.append(
            f'<circle class="{style}" cx="{x[k]:.1f}" cy="{y[k]:.1f}" r="{2.6 if marked[k] else 1.6}">'
            f"<title>{escape(name)}</title></circle>"
        )
    named = np.flatnonzero(marked) if marked.any() else np.arange(len(ids) if len(ids) <= 40 else 0)
    box = (0.0, 0.0, WIDTH, height)
    parts += labels_apart(x[named].tolist(), y[named].tolist(), [ids[int(k)][:14] for k in named], box, "t")
    foot = height + 12
    parts.append(f'<path class="scalebar" d="M{MARGIN} {foot:.1f}h{reference[0] * per_m:.1f}"/>')
    parts.append(label(MARGIN + reference[0] * per_m + 6, foot + 3.5, reference[1]))
    return drawing(WIDTH, foot + 10, parts, what)


def length_errors(
    length: Array, error: Array, sigma: Array, significant_: Mask, allowed: Array, *, coverage: float
) -> Drawing:
    """Errors of lengths (k,) [mm] over the lengths [m], with bars of `coverage` standard deviations and the limits."""
    order = np.argsort(length, kind="stable")
    x, e, s, a = length[order], error[order], coverage * sigma[order], allowed[order]
    y_range = span(e - s, e + s, a[np.isfinite(a)], -a[np.isfinite(a)], zero=True)
    plot = fitted(Plot(width=420, height=240, x_range=span(x, zero=True), y_range=y_range))
    parts = [axes(plot, phrase("axis.length"), phrase("axis.error"), grid="xy")]
    parts.append(line(plot, np.array(plot.x_range), np.zeros(2), "zero"))
    if np.isfinite(a).any():
        parts += [line(plot, x, side * a, "limit") for side in (1, -1)]
    px, low, high, mid = plot.x(x), plot.y(e - s), plot.y(e + s), plot.y(e)
    bars = "".join(f"M{u:.1f} {b:.1f}V{t:.1f}" for u, b, t in zip(px, low, high, strict=True))
    parts.append(f'<path class="vector" d="{bars}"/>')
    for u, v, strange, value in zip(px, mid, significant_[order].tolist(), e.tolist(), strict=True):
        style = "control" if strange else "dot"
        parts.append(
            f'<circle class="{style}" cx="{u:.1f}" cy="{v:.1f}" r="{2.8 if strange else 1.8}">'
            f"<title>{significant(value)} mm</title></circle>"
        )
    return drawing(plot.width, plot.height, parts, phrase("drawn.length_errors"))
