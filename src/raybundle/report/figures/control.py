"""Figure: marked control and check points in their images, with residuals as vectors."""

from __future__ import annotations

import math

import numpy as np

from raybundle.block import Role
from raybundle.errors import phrase
from raybundle.numerics.arrays import Array, Index
from raybundle.report.figures.svg import Drawing, drawing, label, labels_apart, round_below, vectors, written
from raybundle.report.text.numbers import significant
from raybundle.report.view import View

MOST_NAMES = 12
"""Marks of an image that are named in its drawing."""

MOST_IMAGES, ACROSS, WIDTH, GAP = 24, 4, 200.0, 12.0


def marked_images(view: View) -> tuple[Index, Index]:
    """Rows of the observations of control and check points, and the images with the most of them, in their order."""
    o = view.given.observations
    rows = np.flatnonzero(np.asarray(view.given.points.role)[o.point] != Role.TIE)
    count = np.bincount(o.image[rows], minlength=len(view.given.images))
    most = np.argsort(-count, kind="stable")[:MOST_IMAGES]
    return rows, np.sort(most[count[most] > 0]).astype(np.int32)


def marks_figure(view: View) -> tuple[Drawing, float] | None:
    """Marks in their images, and the residual [px] that the reference vector stands for; None where there are none."""
    rows, images = marked_images(view)
    if not len(images):
        return None
    residual = view.adjustment.image_observations.residuals_px
    size = np.linalg.norm(residual[rows], axis=1)
    usual = float(np.nanquantile(size, 0.9)) if np.isfinite(size).any() else 0.0
    reference = round_below(usual) if usual > 0 else 1.0
    per_px = 0.12 * WIDTH / max(usual, reference)
    parts: list[str] = []
    x0, y0, line_height, right = 0.0, 0.0, 0.0, 0.0
    for k, i in enumerate(images.tolist()):
        if k % ACROSS == 0 and k:
            x0, y0, line_height = 0.0, y0 + line_height + GAP, 0.0
        drawn, height = _one(view, rows, i, residual, per_px, (x0, y0))
        parts += drawn
        line_height, right = max(line_height, height), max(right, x0 + WIDTH)
        x0 += WIDTH + GAP
    foot = y0 + line_height + 16
    parts.append(f'<path class="vector" d="M4 {foot:.1f}h{reference * per_px:.1f}"/>')
    parts.append(label(10 + reference * per_px, foot + 3.5, f"{significant(reference, 1)} px"))
    return drawing(right + 4, foot + 10, parts, phrase("drawn.marks")), reference


def _one(
    view: View, rows: Index, image: int, residual: Array, per_px: float, corner: tuple[float, float]
) -> tuple[list[str], float]:
    """One image's format with its marks, and its height with the name."""
    o, points = view.given.observations, view.given.points
    camera = view.given.cameras[view.given.images.camera[image]]
    scale = WIDTH / max(camera.width_px, camera.height_px)
    w, h = camera.width_px * scale, camera.height_px * scale
    x0, y0 = corner[0] + 2, corner[1] + 15
    name = view.given.images.ids[image]
    parts = [
        label(x0, y0 - 4, name if len(name) <= 30 else f"…{name[-29:]}", "t"),
        f'<rect class="format" x="{x0:.1f}" y="{y0:.1f}" width="{w:.1f}" height="{h:.1f}"/>',
    ]
    mine = rows[o.image[rows] == image]
    x, y = x0 + o.xy_px[mine, 0] * scale, y0 + o.xy_px[mine, 1] * scale
    rejected = ~view.used[mine]
    v = np.clip(np.nan_to_num(residual[mine]) * per_px, -0.5 * WIDTH, 0.5 * WIDTH)
    parts.append(vectors(x, y, v[:, 0], v[:, 1], "vector"))
    for k, m in enumerate(mine.tolist()):
        point = int(o.point[m])
        check = int(points.role[point]) == Role.CHECK
        length = float(np.linalg.norm(residual[m]))
        known = math.isfinite(length)
        words = phrase(
            "drawn.mark", point=points.ids[point], known=known, residual_px=length if known else 0.0,
            rejected=bool(rejected[k]),
        )  # fmt: skip
        parts.append(
            f'<circle class="{"check" if check else "control"}" cx="{x[k]:.1f}" cy="{y[k]:.1f}" r="3">'
            f"<title>{written(words)}</title></circle>"
        )
        if rejected[k]:
            parts.append(f'<path class="mark" d="M{x[k] - 5:.1f} {y[k] - 5:.1f}l10 10m0 -10l-10 10"/>')
    if len(mine) <= MOST_NAMES:
        names = [points.ids[int(o.point[m])][:12] for m in mine.tolist()]
        parts += labels_apart(x.tolist(), y.tolist(), names, (x0, y0, w, h), "tiny")
    return parts, h + 15
