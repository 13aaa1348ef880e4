"""A click brought to the picture: the centre of a round target, a corner, a cross, or what looks as in another picture.

Never far from the click: what is found farther away than `reach_px` is refused, and stated.  Covariances come from the
residuals of the grey values, with a floor for what the models leave out; what a lens or a compression adds is for the
adjustment to find.
"""

from __future__ import annotations

from dataclasses import dataclass, replace
from typing import Literal

import numpy as np

from raybundle.errors import InputError, Text, named, phrase
from raybundle.matching.least_squares import Outcome, WindowOptions, match_windows, with_noisy_gradients
from raybundle.matching.refine import CORRELATION, INTERPOLATION_PX2, smoothed
from raybundle.measuring.junction import LEAST_ANGLE, Junction, Model, fit_junction, forstner_point
from raybundle.measuring.window_cross import HALVES, fit_window_cross
from raybundle.numerics.arrays import Array
from raybundle.targets.centre import fit_dots
from raybundle.targets.detect import detect_targets, eight_bits
from raybundle.targets.rings import find_edges

Kind = Literal["ellipse", "corner", "cross", "patch", "auto"]
Found = Literal["ellipse", "corner", "cross", "patch"]
JUNCTIONS: tuple[Model, ...] = ("corner", "cross")
NEXT_TO_NOTHING = 1e-6
"""Reach [px] with which nothing is found but a round target that the click lies in."""
REACH_PX = 12.0
"""Farthest that a click is moved by itself."""
MARGIN_PX = 100
"""Picture around a click that snapping looks at."""
HALF = 8
"""Of the window in which a corner or a cross is fitted [px]."""
WINDOWS_PATCH = ((8, 4.8), (12, 7.2), (5, 3.0))
"""Half width and weighting of the windows in which a patch is matched [px], the one that places it first."""
SURFACE_PX = 0.18
"""Standard deviation that a patch has beside what its grey values and its windows show: surfaces are not plane, and
their noise is not white.  With it the mean square of the errors over their stated covariance is near 1 on the
demonstration's photographs, whose truth is known (tests/studio/test_patches.py).  Crosses of windows have it, too:
their mouldings stand before the panes."""
FLOOR_PX = {"corner": 0.005}
"""Standard deviation of what a model leaves out: pixels are square and not Gaussian."""
PEAKS = 4
"""Places that look most alike and are matched by least squares."""
LEAST_SCORE = 0.5
"""Least correlation of a place that is matched, before it is turned and scaled."""
APART_PX = 1.0
"""Distance from which on two matched places are two."""
ALIKE = 0.6
"""Share of what the best match leaves of its contrast (1 - correlation) that the next one leaves: above, which of two
places is the same cannot be determined."""
RESIDUAL_DOT = 0.08
"""Largest standard deviation of a grey value, in units of the contrast, of what is still a dot, as of targets."""
WINDOWS = (1.25, 1.3, 1.4, 1.5)
"""Radii to which the ground around a small dot within a ring may be free."""
RESIDUAL = 0.10
"""Largest standard deviation of a grey value, in units of the contrast, of what is still a corner or cross."""
WINDOW_RESIDUAL = 0.15
"""The same of the crosses of windows, whose covariance holds what their texture shares."""
CONTRAST = 8.0
"""Least contrast [grey values of 256]."""
SIGMA_PX = 0.3
"""Largest standard deviation of what is still a point."""


@dataclass(frozen=True, slots=True, kw_only=True)
class Snapped:
    """A point of the picture."""

    x_px: float
    y_px: float
    covariance: tuple[float, float, float]
    """variances of x and y and their covariance [px^2]"""
    kind: Found
    quality: float
    """0 .. 1: 1 is a picture as the model has it; of patches the correlation"""
    moved_px: float
    """from the click"""


@dataclass(frozen=True, slots=True, kw_only=True)
class NotSnapped:
    """Why a click was not brought to the picture."""

    kind: Kind
    why: Text


@dataclass(frozen=True, slots=True, kw_only=True)
class Reference:
    """A point in another picture, for `patch`."""

    grey: Array
    """(h, w) uint8 or uint16"""
    x_px: float
    y_px: float
    affine: Array | None = None
    """(2, 2) target_from_reference of small vectors (`predict.affine`); None: neither turned nor scaled"""
    kind: Found = "patch"
    """what the point was taken for there"""


def snap(
    grey: Array, x: float, y: float, kind: Kind = "auto", reference: Reference | None = None, *,
    reach_px: float = REACH_PX, windows: bool = True,
) -> Snapped | NotSnapped:  # fmt: skip
    """The point of the picture at a click.

    grey       (h, w) uint8 or uint16; a part of a picture does, with MARGIN_PX around the click
    x, y       the click, pixel frame of `grey`
    kind       what the point is; auto: what it is in the reference, a patch where that was put by hand; without one
               the round target that the click lies in, else the nearest of round target, corner and cross
    reach_px   farthest that the click is moved; within a round target, to its centre, REACH_PX
    windows    whether a cross may be that of a window or of masonry
    raises     InputError for a picture that is none, a click outside, and a patch without a reference
    """
    _check(grey, x, y, kind, reach_px)
    if kind == "patch" and reference is None:
        raise InputError("snap.no_reference")
    if kind != "auto" or reference is not None:
        taken = reference.kind if kind == "auto" and reference is not None else kind
        assert taken != "auto"
        only = _snap(grey, x, y, taken, reference, reach_px)
        if taken != "cross" or isinstance(only, Snapped) or not windows:
            return only
        wide = _snap(grey, x, y, "cross", None, reach_px, wide=True)
        return wide if isinstance(wide, Snapped) else only
    dot = _snap(grey, x, y, "ellipse", None, reach_px)
    if isinstance(dot, Snapped) and isinstance(_snap(grey, x, y, "ellipse", None, NEXT_TO_NOTHING), Snapped):
        return dot
    tried = [dot, *(_snap(grey, x, y, one, None, reach_px) for one in JUNCTIONS)]
    found = [t for t in tried if isinstance(t, Snapped)]
    if found:
        return min(found, key=lambda f: f.moved_px)
    wide = _snap(grey, x, y, "cross", None, reach_px, wide=True)
    if isinstance(wide, Snapped):
        return wide
    return NotSnapped(kind="auto", why=Text.of(*(named(t.kind, t.why) for t in tried if isinstance(t, NotSnapped))))


def _check(grey: Array, x: float, y: float, kind: str, reach_px: float) -> None:
    if kind not in ("ellipse", "corner", "cross", "patch", "auto"):
        raise InputError("snap.unknown_kind", kind=str(kind))
    if grey.ndim != 2 or str(grey.dtype) not in {"uint8", "uint16"}:
        raise InputError("snap.image_type", kind=str(grey.dtype), shape=grey.shape)
    if not (0 <= x <= grey.shape[1] and 0 <= y <= grey.shape[0]):
        raise InputError("snap.outside", x_px=x, y_px=y, width_px=grey.shape[1], height_px=grey.shape[0])
    if not 0 < reach_px <= MARGIN_PX:
        raise InputError("snap.reach", reach_px=reach_px, most_px=MARGIN_PX)


def _snap(
    grey: Array, x: float, y: float, kind: Found, reference: Reference | None, reach_px: float, *, wide: bool = False
) -> Snapped | NotSnapped:
    click = np.array([x, y])
    if kind == "ellipse":
        found = _ellipse(grey, click, reach_px)
    elif kind == "patch":
        assert reference is not None
        found = _patch(grey, click, reference, reach_px)
    elif wide:
        found = _window_cross(grey, click, reach_px)
    else:
        found = _junction(grey, click, kind, reach_px)
    if isinstance(found, Text):
        return NotSnapped(kind=kind, why=found)
    xy, C, quality = found
    moved = float(np.hypot(*(xy - click)))
    limit = max(reach_px, REACH_PX) if kind == "ellipse" else reach_px  # a click within a dot means its centre
    if moved > limit:
        return NotSnapped(kind=kind, why=phrase("not_snapped.far", distance_px=moved, limit_px=limit))
    C = C + np.eye(2) * FLOOR_PX.get(kind, 0.0) ** 2
    return Snapped(
        x_px=float(xy[0]), y_px=float(xy[1]), covariance=(float(C[0, 0]), float(C[1, 1]), float(C[0, 1])), kind=kind,
        quality=float(np.clip(quality, 0, 1)), moved_px=moved,
    )  # fmt: skip


Point = tuple[Array, Array, float]
"""Place, covariance, quality."""


def _crop(grey: Array, at: Array, half: int) -> tuple[Array, Array]:
    """The picture around a place, and its first pixel."""
    x, y = (int(np.floor(v)) for v in at)
    x0, y0 = max(0, x - half), max(0, y - half)
    return grey[y0 : y + half + 1, x0 : x + half + 1], np.array([x0, y0], float)


def _ellipse(grey: Array, click: Array, reach: float) -> Point | Text:
    """The dot under the click, or the nearest within reach; looked at again around itself, whatever the click."""
    at, found, most = click, None, max(reach, REACH_PX)
    for _ in range(3):
        part, origin = _crop(grey, at, MARGIN_PX)
        if min(part.shape) < 16:
            return phrase("not_snapped.margin")
        found = _dot(np.ascontiguousarray(part), at - origin, reach if at is click else most)
        if found is None:
            return phrase("not_snapped.no_target", reach_px=reach)
        found = found[0] + origin, *found[1:]
        if (np.floor(found[0]) == np.floor(at)).all():
            break
        if np.hypot(*(found[0] - click)) > most:
            away = float(np.hypot(*(found[0] - click)))
            return phrase("not_snapped.target_far", distance_px=away, limit_px=most)
        at = found[0]
    assert found is not None
    return found


def _dot(part: Array, at: Array, reach: float) -> Point | None:
    """The dot at a place, or the nearest: as targets are detected, else the spot there, whatever is around it."""
    dots = detect_targets(part, None)
    k = _nearest(at, dots.xy_px, dots.ellipse, reach)
    if k is not None:
        return dots.xy_px[k], dots.covariance[k], 1 - float(dots.residual[k]) / RESIDUAL_DOT
    # small ones within rings, which blur brings close: their ground is free of anything else for half a radius at most
    from raybundle.targets.blobs import find_blobs

    eight, _ = eight_bits(part)
    blobs = find_blobs(eight, max(CONTRAST, 0.1 * float(np.subtract(*np.percentile(eight, [99.5, 0.5])))))
    edges = find_edges(eight, blobs.xy_px, blobs.ellipse, blobs.sign)
    k = _nearest(at, edges.xy_px, edges.ellipse, reach)
    if k is None:
        return None
    best: Point | None = None
    for window in WINDOWS:
        fit = fit_dots(part, edges.xy_px[k : k + 1], edges.ellipse[k : k + 1], np.array([window]))
        residual = float(fit.residual[0]) / max(abs(float(fit.values[0, 7])), 1e-9)
        quality = 1 - residual / RESIDUAL_DOT
        if fit.measured[0] and quality > 0 and (best is None or quality > best[2]):
            best = fit.xy_px[0], fit.cov_px2[0], quality
    return best


def _nearest(at: Array, xy: Array, ellipse: Array, reach: float) -> int | None:
    """Of dots (n,) the one that a place lies in, or the nearest within reach."""
    if not len(xy):
        return None
    offset = xy - at
    distance = np.hypot(*offset.T)
    inside = np.einsum("ni,nij,nj->n", offset, np.linalg.inv(ellipse), offset) < 1
    limit = np.where(inside, max(reach, REACH_PX), reach)
    k = int(np.argmin(distance - 1e6 * (inside & (distance <= limit))))
    return k if distance[k] <= limit[k] else None


def _junction(grey: Array, click: Array, kind: Model, reach: float) -> Point | Text:
    """The corner or cross nearest to the click: first where edges meet, then by the grey values of a window."""
    scale = 1.0 if grey.dtype == np.uint8 else 256.0
    at = _nearest_meeting(grey, click, reach)
    if at is None:
        return phrase("not_snapped.no_edges", reach_px=reach, kind=kind)
    fit = None
    for _ in range(4):
        fit = fit_junction(grey, at, HALF, kind)
        if fit is None:
            return phrase("not_snapped.margin")
        if not np.isfinite(fit.xy).all() or np.hypot(*(fit.xy - at)) > HALF:
            return phrase("not_snapped.other_grey_values", kind=kind)
        if (np.floor(fit.xy) == np.floor(at)).all():
            break
        at = fit.xy
    assert fit is not None
    return _refused(fit, kind, RESIDUAL, scale) or (fit.xy, fit.covariance, 1 - fit.residual / RESIDUAL)


def _refused(fit: Junction, kind: Model, residual: float, scale: float) -> Text | None:
    """Why a corner or a cross is none."""
    if not fit.ended or not np.isfinite(fit.covariance).all():
        return phrase("not_snapped.no_place", kind=kind)
    if fit.contrast < CONTRAST * scale:
        return phrase("not_snapped.contrast", contrast=fit.contrast / scale, limit=CONTRAST)
    if fit.angle < LEAST_ANGLE:
        angle, limit = np.degrees([fit.angle, LEAST_ANGLE])
        return phrase("not_snapped.angle", angle_deg=angle, limit_deg=limit)
    if fit.residual > residual:
        return phrase("not_snapped.grey_values", kind=kind, residual=fit.residual, limit=residual)
    if (sigma := _largest_sigma(fit.covariance)) > SIGMA_PX:
        return phrase("not_snapped.sigma", sigma_px=sigma, limit_px=SIGMA_PX, texture=True)
    return None


def _window_cross(grey: Array, click: Array, reach: float) -> Point | Text:
    """The cross of unequal bars nearest to the click, in a photograph's texture."""
    meeting = _nearest_meeting(grey, click, reach)
    starts, fit = [click] if meeting is None else [click, meeting], None
    for _ in range(3):
        fit = fit_window_cross(grey, starts)
        if fit is None:
            return phrase("not_snapped.margin")
        if not np.isfinite(fit.xy).all() or np.hypot(*(fit.xy - starts[0])) > HALVES[0]:
            return phrase("not_snapped.other_grey_values", kind="cross")
        if (np.floor(fit.xy) == np.floor(starts[0])).all():
            break
        starts = [fit.xy]
    assert fit is not None
    fit = replace(fit, covariance=fit.covariance + SURFACE_PX**2 * np.eye(2))
    scale = 1.0 if grey.dtype == np.uint8 else 256.0
    why = _refused(fit, "cross", WINDOW_RESIDUAL, scale)
    return why or (fit.xy, fit.covariance, 1 - fit.residual / WINDOW_RESIDUAL)


def _largest_sigma(covariance: Array) -> float:
    return float(np.sqrt(np.linalg.eigvalsh(covariance)[1]))


def _nearest_meeting(grey: Array, click: Array, reach: float) -> Array | None:
    """Where edges near the click meet; windows shrink from the reach on."""
    at = click
    for half in (9, 7, 5, 5, 5):
        new = forstner_point(grey, at, half)
        if new is None or np.hypot(*(new - click)) > reach:
            return None if half == 9 else at
        at = new
    return at


def _patch(grey: Array, click: Array, reference: Reference, reach: float) -> Point | Text:
    """The place that looks like that of another picture: by correlation first, then by least-squares matching."""
    import cv2

    _check(reference.grey, reference.x_px, reference.y_px, "patch", reach)
    own = np.array([reference.x_px, reference.y_px])
    A = np.eye(2) if reference.affine is None else np.asarray(reference.affine, float)
    part, origin = _crop(grey, click, MARGIN_PX)
    first, first_origin = _crop(reference.grey, own, MARGIN_PX)
    target, source = smoothed(part), smoothed(first)
    size = 2 * HALF + 1
    # the template as the target would show it, with its point at the middle of its middle pixel
    back = np.linalg.inv(A)
    shift = own - first_origin - 0.5 - back @ np.array([HALF, HALF], float)
    warp = np.concatenate([back, shift[:, None]], axis=1)
    flags = cv2.INTER_LINEAR | cv2.WARP_INVERSE_MAP
    template = cv2.warpAffine(source.astype(np.float32), warp, (size, size), flags=flags, borderMode=cv2.BORDER_REFLECT)
    span = int(np.ceil(reach)) + HALF
    cx, cy = np.floor(click - origin).astype(int)
    x0, y0 = max(0, cx - span), max(0, cy - span)
    window = target[y0 : cy + span + 1, x0 : cx + span + 1].astype(np.float32)
    if min(window.shape) < size:
        return phrase("not_snapped.margin")
    score = cv2.matchTemplate(window, template, cv2.TM_CCOEFF_NORMED)
    yy, xx = np.mgrid[: score.shape[0], : score.shape[1]]
    x, y = xx + x0 + HALF + 0.5, yy + y0 + HALF + 0.5
    off = click - origin
    score = np.where((np.hypot(x - off[0], y - off[1]) > reach) | ~np.isfinite(score), -1, score)
    found, why, best = list[Point](), list[Text](), float(score.max())
    for _ in range(PEAKS):
        k = int(np.argmax(score))
        if score.flat[k] < LEAST_SCORE:
            break
        start = np.array([x.flat[k], y.flat[k]])
        score = np.where(np.hypot(x - start[0], y - start[1]) < 2.5, -1, score)
        match = _matched(source, target, own - first_origin, start, A)
        if isinstance(match, Text):
            why.append(match)
        elif all(np.hypot(*(match[0] - m[0])) > APART_PX for m in found):
            found.append(match)
    if why and not found:
        return why[0]
    if not found:
        return phrase("not_snapped.nothing_alike", reach_px=reach, correlation=best, limit=LEAST_SCORE)
    found.sort(key=lambda m: -m[2])
    if len(found) > 1 and 1 - found[0][2] >= ALIKE * (1 - found[1][2]):
        return phrase("not_snapped.two_alike", distance_px=float(np.hypot(*(found[0][0] - found[1][0]))))
    return found[0][0] + origin, found[0][1], found[0][2]


def _matched(source: Array, target: Array, own: Array, start: Array, A: Array) -> Point | Text:
    """By least-squares matching in two windows: what they differ by shows how far the surface is from plane.

    The smaller window's place, or the larger's where that alone has texture enough.
    """
    found, why = list[Point](), list[Text]()
    for half, sigma in WINDOWS_PATCH:
        match = _in_window(source, target, own, start, A, WindowOptions(half=half, sigma=sigma, reach=3.0))
        if isinstance(match, Text):
            why.append(match)
        else:
            found.append(match)
    if not found:
        return why[0]
    place, C, quality = found[0]
    C = C + SURFACE_PX**2 * np.eye(2) + sum(np.outer(m[0] - place, m[0] - place) for m in found[1:])
    s = _largest_sigma(C)
    if s > SIGMA_PX:
        return phrase("not_snapped.sigma", sigma_px=s, limit_px=SIGMA_PX, texture=True)
    return place, C, quality


def _in_window(source: Array, target: Array, own: Array, start: Array, A: Array, window: WindowOptions) -> Point | Text:
    found = match_windows(source, target, own[None], start[None], A[None], window)
    outcome = Outcome(int(found.outcome[0]))
    if outcome != Outcome.MATCHED:
        return phrase("not_snapped.no_convergence", outcome=outcome.name.lower())
    if found.correlation[0] < CORRELATION:
        return phrase("not_snapped.correlation", correlation=float(found.correlation[0]), limit=CORRELATION)
    xx, yy, xy = with_noisy_gradients(found, own[None], window).cov_px2[0] + INTERPOLATION_PX2
    C = np.array([[xx, xy], [xy, yy]])
    if (s := _largest_sigma(C)) > SIGMA_PX:
        return phrase("not_snapped.sigma", sigma_px=s, limit_px=SIGMA_PX, texture=False)
    return found.xy_px[0], C, float(found.correlation[0])
