"""Ground panels of control points with given coordinates, found where photographs should show them.

Of a point some places in each photograph look like panels (`panel_candidates`).  Where rays to such places in several
photographs meet near the given coordinates, there may be the point: a hypothesis.  The given coordinates and the block
differ by the errors of the block's position, which all points share: the hypotheses of all points that agree on one
shift (from four points on, on one similarity transformation) are taken (consensus; Fischler and Bolles 1981).  A point
is accepted with three photographs and more, and where no other hypothesis that fits is as distinct.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from contextlib import suppress
from dataclasses import dataclass, field, replace
from itertools import combinations

import numpy as np

from raybundle.errors import InputError
from raybundle.measuring.frames import to_camera, to_file
from raybundle.measuring.panel_candidates import KINDS, Place, measured_panel, panel_places
from raybundle.measuring.position import rays_meeting
from raybundle.measuring.session import Session
from raybundle.measuring.snap import Found, Snapped
from raybundle.measuring.views import ray, seen_in
from raybundle.numerics.arrays import Array
from raybundle.numerics.progress import Progress, silent
from raybundle.numerics.transform import SimilarityTransform, similarity

LEAST_RAYS = 3
"""Photographs in which an accepted point is measured"""
SAME_PX = 3.0
"""Distance of a place from where a hypothesis is seen, within which it belongs to it: errors of the orientations"""
MARGIN_PX = 40
"""Picture around the searched area that a panel may reach into"""
MOST_PX = 700
"""Half of the largest searched area"""
RIVAL = 0.7
"""Distinctness of the second hypothesis of a point over that of the first, above which it cannot be decided"""
FEWEST = 3
"""Points whose shifts agree, from which on a shift is believed"""
FLOOR_PX = 0.1
"""Standard deviation of a measured panel beside what its grey values show: creases of cloth, paint, rough ground"""
DISTINCT = 0.6
"""Contrast times symmetry of what may be a panel, over those of the most distinct place of the searched area"""
SPREAD = 4.0
"""Residuals of the consensus in robust standard deviations beyond which a point is not accepted"""


@dataclass(frozen=True, slots=True, kw_only=True)
class Hypothesis:
    """A place in object space where photographs show what looks like a panel."""

    xyz: Array
    """(3,)"""
    seen: Mapping[int, Place]
    """image -> the measured place, in the pixels of its file"""

    @property
    def worth(self) -> float:
        """How distinct it is: contrast and symmetry, of all photographs."""
        return float(sum(c.worth for c in self.seen.values()))

    @property
    def mean_worth(self) -> float:
        """The same of a photograph."""
        return self.worth / len(self.seen)


@dataclass(frozen=True, slots=True, kw_only=True)
class FoundPanel:
    """A panel that was found."""

    point: str
    marks: Mapping[str, Snapped]
    """image -> place in the pixels of its file"""
    off: Array
    """(3,) block minus given coordinates, without the shift that all points share [length unit]"""


@dataclass(frozen=True, slots=True, kw_only=True)
class PanelSearch:
    """What a search found."""

    found: tuple[FoundPanel, ...]
    missed: Mapping[str, str] = field(default_factory=dict[str, str])
    """point -> reason: not_visible, nothing, few_rays, few_points, ambiguous, off, no_panel"""
    off: Mapping[str, float] = field(default_factory=dict[str, float])
    """of points that are off: distance of the nearest panel from their place [length unit]"""
    shift: Array = field(default_factory=lambda: np.zeros(3))
    """(3,) block minus given coordinates, median of the found points"""
    spread: float = 0.0
    """robust standard deviation of what points differ from the consensus [length unit]"""


Pictures = Callable[[int], Array | None]
"""image -> grey values (h, w) as stored; None: not there"""


def search_panels(
    session: Session, given: Mapping[str, Array], sigma: Mapping[str, float], reach: float, pictures: Pictures,
    progress: Progress = silent,
) -> PanelSearch:  # fmt: skip
    """Look for points with given coordinates (3,) [length unit of the block; Z NaN: not known].

    sigma  standard deviation of a coordinate of each point
    reach  largest difference of block and given coordinates
    """
    at = {name: _with_height(session, xyz) for name, xyz in given.items()}
    places = _candidates(session, at, reach, pictures, progress)
    options = {name: _hypotheses(session, at[name], reach, here) for name, here in places.items()}
    missed = {name: "not_visible" for name in given if not places[name]}
    missed |= {name: "nothing" for name in given if places[name] and not options[name]}
    strong = {name: [h for h in hs if len(h.seen) >= LEAST_RAYS] for name, hs in options.items()}
    missed |= {name: "few_rays" for name in given if options[name] and not strong[name]}
    strong = {name: _distinct(hs) for name, hs in strong.items() if hs}
    if len(strong) < FEWEST:
        return PanelSearch(found=(), missed={**missed, **dict.fromkeys(strong, "few_points")})
    flat = {name: np.isfinite(xyz) for name, xyz in given.items()}
    fit = _consensus(strong, at, flat, reach / 4, SPREAD * float(np.median([sigma[n] for n in strong])))
    limits = {n: SPREAD * float(np.hypot(fit.spread, sigma[n])) * np.sqrt(flat[n].sum()) for n in strong}
    accepted, reasons, off = _accepted(strong, at, flat, fit, limits)
    marks = _measured(session, accepted, pictures)
    found: list[FoundPanel] = []
    for name, h in accepted.items():
        if len(marks[name]) < LEAST_RAYS:
            reasons[name] = "no_panel"
            continue
        away = np.where(flat[name], h.xyz - fit.by.points(at[name]), np.nan)
        found.append(FoundPanel(point=name, marks=marks[name], off=away))
    shifts = [accepted[f.point].xyz - at[f.point] for f in found]
    return PanelSearch(
        found=tuple(found), missed={**missed, **reasons}, off=off, spread=fit.spread,
        shift=np.median(shifts, axis=0) if shifts else np.zeros(3),
    )  # fmt: skip


def _with_height(session: Session, xyz: Array) -> Array:
    """Coordinates, a missing height from the object points next to them in plan."""
    if np.isfinite(xyz[2]):
        return np.array(xyz)
    p = session.block.points.xyz
    p = p[np.isfinite(p).all(axis=1)]
    near = np.argsort(np.hypot(*(p[:, :2] - xyz[:2]).T))[:50]
    return np.array([xyz[0], xyz[1], float(np.median(p[near, 2])) if len(near) else 0.0])


def _candidates(
    session: Session, at: Mapping[str, Array], reach: float, pictures: Pictures, progress: Progress
) -> dict[str, dict[int, list[Place]]]:
    """Of each point, the places in each image that should show it."""
    b = session.block
    rows = np.flatnonzero(b.images.oriented)
    areas: dict[int, list[tuple[str, Array, float]]] = {}
    for name, xyz in at.items():
        for i, place in zip(rows.tolist(), seen_in(session, rows, xyz), strict=True):
            if not np.isfinite(place).all():
                continue
            camera, radius = b.cameras[int(b.images.camera[i])], reach / pixel_size(session, i, xyz)
            if ((place > -radius) & (place < [camera.width_px + radius, camera.height_px + radius])).all():
                areas.setdefault(i, []).append((name, place, min(max(radius, 4 * SAME_PX), MOST_PX)))
    found: dict[str, dict[int, list[Place]]] = {name: {} for name in at}
    for n, (i, here) in enumerate(areas.items()):
        progress("panels", n / len(areas))
        grey = pictures(i)
        if grey is None:
            continue
        for name, place, radius in here:
            centre = to_file(b, i, place[None])[0]
            places = _in_area(grey, centre, radius)
            if places is not None:
                found[name][i] = places
    progress("panels", 1.0)
    return found


def _in_area(grey: Array, centre: Array, radius: float) -> list[Place] | None:
    """Places within an area of a picture, in its pixels; None where the area lies outside."""
    h, w = grey.shape
    low = np.maximum(np.floor(centre - radius - MARGIN_PX), 0).astype(int)
    high = np.minimum(np.ceil(centre + radius + MARGIN_PX), [w, h]).astype(int)
    if (high - low < 2 * MARGIN_PX).any():
        return None
    part = np.ascontiguousarray(grey[low[1] : high[1], low[0] : high[0]])
    x0, y0 = (float(v) for v in low)
    moved = [replace(c, x_px=c.x_px + x0, y_px=c.y_px + y0) for c in panel_places(part)]
    return [c for c in moved if np.hypot(c.x_px - centre[0], c.y_px - centre[1]) <= radius + MARGIN_PX / 2]


def _hypotheses(
    session: Session, given: Array, reach: float, places: Mapping[int, Sequence[Place]]
) -> list[Hypothesis]:
    """Where rays of two images meet near a point, with all images that show something there; the most seen first."""
    b = session.block
    images = [i for i, here in places.items() if here]
    if len(images) < 2:
        return []
    xy = {i: to_camera(b, i, np.array([[c.x_px, c.y_px] for c in places[i]])) for i in images}
    rays = {i: np.array([ray(session, i, p) for p in xy[i]]) for i in images}
    found: list[Hypothesis] = []
    keys: set[frozenset[tuple[int, int]]] = set()
    for i, k in combinations(images, 2):
        for m, n in _meeting(b.images.centre[[i, k]], rays[i], rays[k], given, reach, pixel_size(session, i, given)):
            if any((i, m) in key and (k, n) in key for key in keys):
                continue
            xyz, made = rays_meeting(session, [i, k], [rays[i][m], rays[k][n]]), dict[int, int]()
            for _ in range(2):  # with the two, then with all that show it
                made = {} if xyz is None else _supported(session, xyz, xy, images)
                xyz = (
                    rays_meeting(session, list(made), [rays[j][q] for j, q in made.items()]) if len(made) > 1 else None
                )
            key = frozenset(made.items())
            if xyz is None or len(made) < 2 or key in keys:
                continue
            keys.add(key)
            found.append(Hypothesis(xyz=xyz, seen={j: places[j][q] for j, q in made.items()}))
    return _apart(
        sorted(found, key=lambda h: (-len(h.seen), -h.worth)), SAME_PX * 4 * pixel_size(session, images[0], given)
    )


def _apart(hs: Sequence[Hypothesis], least: float) -> list[Hypothesis]:
    """Without those beside a better one, or that share most of its places."""
    found: list[Hypothesis] = []
    for h in hs:
        if not any(_one(h, f) or np.linalg.norm(h.xyz - f.xyz) < least for f in found):
            found.append(h)
    return found


def _distinct(hs: Sequence[Hypothesis]) -> list[Hypothesis]:
    """Those that are about as distinct as the most distinct one: panels stand out from the ground."""
    most = max(h.mean_worth for h in hs)
    return [h for h in hs if h.mean_worth >= DISTINCT * most]


def _supported(session: Session, xyz: Array, xy: Mapping[int, Array], images: Sequence[int]) -> dict[int, int]:
    """Image -> number of the place that lies where a point is seen."""
    seen = seen_in(session, np.array(images, np.int64), xyz)
    found: dict[int, int] = {}
    for i, place in zip(images, seen, strict=True):
        away = np.linalg.norm(xy[i] - place, axis=1)
        k = int(np.argmin(away))
        if away[k] <= SAME_PX:
            found[i] = k
    return found


def pixel_size(session: Session, image: int, xyz: Array) -> float:
    """Size of a pixel of an image at a place of the object, about."""
    camera = session.camera(image)
    middle = np.array([camera.width_px, camera.height_px]) / 2
    angle = np.linalg.norm(ray(session, image, middle + np.array([1.0, 0.0])) - ray(session, image, middle))
    return float(angle * np.linalg.norm(xyz - session.block.images.centre[image]))


def _meeting(
    centre: Array, first: Array, second: Array, given: Array, reach: float, pixel: float
) -> list[tuple[int, int]]:  # fmt: skip
    """Rows of rays (m, 3), (n, 3) of two images that meet within some pixels and a reach of a place."""
    base = centre[1] - centre[0]
    c = first @ second.T
    with np.errstate(divide="ignore", invalid="ignore"):
        s = ((first @ base)[:, None] - c * (second @ base)[None]) / (1 - c * c)
        t = (c * (first @ base)[:, None] - (second @ base)[None]) / (1 - c * c)
    one = centre[0] + s[..., None] * first[:, None]
    two = centre[1] + t[..., None] * second[None]
    middle = (one + two) / 2 - given
    good = (s > 0) & (t > 0) & (np.linalg.norm(one - two, axis=2) <= 2 * SAME_PX * pixel)
    good &= (np.hypot(middle[..., 0], middle[..., 1]) <= reach) & (np.abs(middle[..., 2]) <= 2 * reach)
    return [(int(m), int(n)) for m, n in np.argwhere(good)]


@dataclass(frozen=True, slots=True)
class _Fit:
    """From given coordinates to the block, and how far points scatter about it."""

    by: SimilarityTransform
    spread: float


def _consensus(
    options: Mapping[str, Sequence[Hypothesis]], at: Mapping[str, Array], flat: Mapping[str, Array], wide: float,
    least: float,
) -> _Fit:  # fmt: skip
    """The shift on which most points agree, the most distinct ones where as many do on several; then the similarity."""
    rows = [(name, h) for name, hs in options.items() for h in hs]
    d = np.array([h.xyz - at[name] for name, h in rows])
    names = np.array([name for name, _ in rows])
    plan = np.array([[*np.where(flat[name], 1.0, 0.0)] for name in names])
    worth = np.array([h.worth for _, h in rows])
    tolerance, best = max(wide, least), (-1, -1.0, np.zeros(3))
    for shift in d:
        away = np.linalg.norm((d - shift) * plan, axis=1)
        near = away < tolerance
        agreed = {n: worth[near & (names == n)].max() for n in set(names[near].tolist())}
        value = (len(agreed), float(sum(agreed.values())))
        if value > best[:2]:
            best = (*value, shift)
    fit = _Fit(SimilarityTransform(translation=np.array(best[2])), tolerance)
    limit = tolerance
    for _ in range(8):
        taken = _taken(options, at, flat, fit, limit)
        if len(taken) < FEWEST:
            return fit
        fit = _fitted(taken, at, flat, tolerance)
        limit = min(limit, max(SPREAD * fit.spread, least))
    return fit


def _taken(
    options: Mapping[str, Sequence[Hypothesis]], at: Mapping[str, Array], flat: Mapping[str, Array], fit: _Fit,
    limit: float,
) -> dict[str, Hypothesis]:  # fmt: skip
    """Of each point the most distinct hypothesis within a limit of its place."""
    found: dict[str, Hypothesis] = {}
    for name, hs in options.items():
        near = [h for h in hs if _away(h, at[name], flat[name], fit) <= limit]
        if near:
            found[name] = max(near, key=lambda h: h.worth)
    return found


def _away(h: Hypothesis, given: Array, known: Array, fit: _Fit) -> float:
    return float(np.linalg.norm((h.xyz - fit.by.points(given))[known]))


def _fitted(taken: Mapping[str, Hypothesis], at: Mapping[str, Array], flat: Mapping[str, Array], most: float) -> _Fit:
    """The median shift of the taken hypotheses; a similarity from four points with three coordinates on."""
    source = np.array([at[n] for n in taken])
    target = np.array([h.xyz for h in taken.values()])
    known = np.array([flat[n] for n in taken])
    by, free = SimilarityTransform(translation=np.median(target - source, axis=0)), 3
    if known.all() and len(taken) > FEWEST:
        with suppress(InputError):  # control in one line, as along a road: the shift alone
            s = similarity(source, target)
            by, free = SimilarityTransform(scale=s.scale, rotation=s.rotation, translation=s.translation), 7
    left = np.where(known, target - by.points(source), np.nan)
    redundant = max(3 * len(taken) - free, 1) / (3 * len(taken))
    spread = 1.4826 * float(np.nanmedian(np.abs(left))) / np.sqrt(redundant)
    return _Fit(by, min(max(spread, 1e-9), most))


def _accepted(
    options: Mapping[str, Sequence[Hypothesis]], at: Mapping[str, Array], flat: Mapping[str, Array], fit: _Fit,
    limits: Mapping[str, float],
) -> tuple[dict[str, Hypothesis], dict[str, str], dict[str, float]]:  # fmt: skip
    """The points with one hypothesis that fits, or one that is more distinct than others; else why not, and how far."""
    found: dict[str, Hypothesis] = {}
    reasons: dict[str, str] = {}
    off: dict[str, float] = {}
    for name, hs in options.items():
        away = [_away(h, at[name], flat[name], fit) for h in hs]
        near = sorted((h for h, a in zip(hs, away, strict=True) if a <= limits[name]), key=lambda h: -h.worth)
        if not near:
            reasons[name] = "off"
            off[name] = float(min(away))
        elif len(near) > 1 and near[1].worth > RIVAL * near[0].worth:
            reasons[name] = "ambiguous"
        else:
            found[name] = near[0]
    return found, reasons, off


def _measured(
    session: Session, accepted: Mapping[str, Hypothesis], pictures: Pictures
) -> dict[str, dict[str, Snapped]]:
    """Of each point the measured places, by image; of those of one kind only, which most are of."""
    tried: dict[str, dict[int, Snapped]] = {name: {} for name in accepted}
    for i in sorted({i for h in accepted.values() for i in h.seen}):
        grey = pictures(i)
        for name, h in accepted.items():
            if grey is None or i not in h.seen:
                continue
            made = measured_panel(grey, h.seen[i])
            if made is not None:
                tried[name][i] = made
    found: dict[str, dict[str, Snapped]] = {}
    for name, marks in tried.items():
        kinds = [m.kind for m in marks.values()]
        kind: Found = max(KINDS, key=kinds.count)
        found[name] = {session.block.images.ids[i]: _floored(m) for i, m in marks.items() if m.kind in {kind, "patch"}}
    return found


def _floored(mark: Snapped) -> Snapped:
    xx, yy, xy = mark.covariance
    return replace(mark, covariance=(xx + FLOOR_PX**2, yy + FLOOR_PX**2, xy))


def _one(a: Hypothesis, b: Hypothesis) -> bool:
    """Whether two hypotheses share most of their places."""
    same = sum(b.seen.get(i) is c for i, c in a.seen.items())
    return 2 * same >= min(len(a.seen), len(b.seen))
