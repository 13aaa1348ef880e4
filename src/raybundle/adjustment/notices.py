"""What a result has to say by itself: warnings with the number, the limit and the remedy."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

import numpy as np

from raybundle.adjustment.accuracy import levelled
from raybundle.adjustment.bar_tests import bar_notice, wrong_bar
from raybundle.adjustment.components import NAMES, differs, without_known_before, without_worst
from raybundle.adjustment.control_notices import control_notices
from raybundle.adjustment.control_tests import Contradiction, ControlTests
from raybundle.adjustment.datum import ABOUT_LINE
from raybundle.adjustment.interior_notices import interior_notices
from raybundle.adjustment.network import FEW as FIRM
from raybundle.adjustment.network import weak_images
from raybundle.adjustment.reliability import UNCONTROLLED, RedundancySum
from raybundle.adjustment.result import Adjustment, Notice, ObservationGroup, VarianceComponent
from raybundle.adjustment.severity import NEARLY, POOR_FIT, Severity
from raybundle.adjustment.suspects import suspect_notices
from raybundle.adjustment.wrong_images import wrong_image_notices
from raybundle.block import Role
from raybundle.block.frames import stored_ways
from raybundle.block.points import automatic
from raybundle.block.rejection import WORDS, RejectionKind, counts
from raybundle.numerics.counting import counted, counted_are, grouped, significant
from raybundle.numerics.statistics import global_test

LONG = 1e4
"""From which on a number stands in groups of three digits"""
UNCHECKED = 0.01
"""Redundancy number below which an observation is not checked by the others (Förstner 1987): an error of forty
standard deviations may pass."""
FEW = 5.0
"""Redundancy of a group below which single values are suspects rather than all of them."""

ORIGIN = 0.5
"""By how many pixels coordinates of other programs differ that count from the middle of the first pixel."""
BEYOND = 6.0
"""Standard deviations beyond which no image point of a million is outside by chance (one in 10^9 of normal errors)."""
TURNED = 0.1
"""Share of an image's tie points behind it from which its orientation is doubted; seen of right ones: below 0.01."""


def notices_of(result: Adjustment, redundancy_sum: RedundancySum | None) -> tuple[Notice, ...]:
    """All notices of an adjustment but those that hang on the noise model (`cell_means.systematic_notices`)."""
    found: list[Notice] = []
    if redundancy_sum is not None and not abs(redundancy_sum.sum - result.redundancy) <= redundancy_sum.limit:
        found.append(
            Notice(
                code="redundancy_sum",
                message=f"the redundancy numbers sum to {redundancy_sum.sum:.6f} instead of {result.redundancy}, and "
                f"rounding explains {redundancy_sum.limit:.2g}: standard deviations are not reliable; "
                "please report this block",
            )
        )
    control = _control(result)
    found += _outside(result) + _fit(result) + interior_notices(result) + _rejected(result) + _points(result) + control
    if not any(n.severity is Severity.FAULT for n in control):  # wrong control bends the images that show it
        found += wrong_image_notices(result)
    found += _photographs(result) + _stored_ways(result) + _open_beside_given(result) + _unchecked_scale(result)
    return tuple(found)


def _outside(result: Adjustment) -> list[Notice]:
    """Image points beyond the format of their image, by more than noise and half a pixel of another origin explain."""
    block, o = result.given, result.given.observations
    size = np.array([(c.width_px, c.height_px) for c in block.cameras], float)[block.images.camera[o.image]]
    beyond = np.maximum(-o.xy_px, o.xy_px - size) - ORIGIN - BEYOND * np.sqrt(o.cov_px2[:, :2])
    rows = np.flatnonzero((beyond > 0).any(axis=1))
    if not len(rows):
        return []
    k = int(rows[beyond[rows].max(axis=1).argmax()])
    images = [block.images.ids[i] for i in dict.fromkeys(o.image[rows].tolist())]
    some = ", ".join(images[:5]) + " ..." * (len(images) > 5)
    x, y = o.xy_px[k].tolist()
    return [
        Notice(
            code="outside_format",
            message=f"{counted_are(len(rows), 'image point')} outside the format, in {some}: the farthest is point "
            f"{block.points.ids[o.point[k]]} at {x:.6g}, {y:.6g} px in {block.images.ids[o.image[k]]}, whose format is "
            f"{size[k, 0]:g} x {size[k, 1]:g} px. Check width_px and height_px of its camera, the unit and the origin "
            "of the image points (the outer corner of the first pixel, y down)",
            ids=tuple(images[:100]),
        )
    ]


def _fit(result: Adjustment) -> list[Notice]:
    if result.redundancy == 0:
        return [
            Notice(
                code="no_redundancy",
                message="no redundancy: sigma0 cannot be estimated; standard deviations carry the a-priori sigma0 and "
                "no blunder can be found. Add observations.",
            )
        ]
    lower, value, upper = result.global_test
    if not value > upper and not value < lower:
        return []
    more = value > upper
    grave = Severity.FAULT if result.sigma0 > POOR_FIT else Severity.CAUTION
    grave = Severity.REMARK if result.sigma0 < NEARLY else grave
    return [
        Notice(
            code="global_test",
            measured=grave if more else Severity.REMARK,
            message=f"sigma0 {result.sigma0:.3g} differs from 1 (weighted square sum {_sum(value)}, 95 % limits "
            f"{_sum(lower)} .. {_sum(upper)}): {_meaning(result, more=more)}. Standard deviations carry the "
            "a-posteriori sigma0.",
        )
    ]


def _sum(squares: float) -> str:
    """A sum of squares with five digits."""
    return grouped(round(float(f"{squares:.5g}"))) if squares >= LONG else f"{squares:.5g}"


def _meaning(result: Adjustment, *, more: bool) -> str:
    """What a sigma0 other than 1 says of the observations."""
    if more and result.sigma0 < NEARLY:
        return f"less than {100 * (NEARLY - 1):.0f} %, which so many observations show"
    if more:
        return "the observations are less precise than stated, or the model does not fit or blunders are left"
    if result.options.weights == "residuals":
        return "the residuals are smaller than when the weights were taken from them, no merit of the observations"
    return "the observations are more precise than stated"


def _behind(result: Adjustment, rows: Sequence[int]) -> Notice:
    """Points behind a camera: wrong numbers where somebody named them, else wrong matches, unless they are many."""
    o = result.given.observations
    pairs = _pairs(result, list(rows))
    shown = ", ".join(f"point {p} in image {i}" for i, p in pairs[:5]) + (" ..." if len(pairs) > 5 else "")
    ids = tuple(p for _, p in pairs)
    if not automatic(ids).all():
        return Notice(code="behind_camera", message=f"behind the camera: {shown}; check the point numbers", ids=ids)
    n = len(result.given.images)
    share = np.bincount(o.image[list(rows)], minlength=n) / np.maximum(np.bincount(o.image, minlength=n), 1)
    turned = [result.given.images.ids[k] for k in np.flatnonzero(share > TURNED)]
    if turned:
        some = ", ".join(turned[:5]) + " ..." * (len(turned) > 5)
        message = (
            f"more than {TURNED:.0%} of the tie points of {some} lie behind the camera: photographs may be oriented on "
            "the wrong side. Compare their positions with where they were taken"
        )
        return Notice(code="behind_camera", message=message, ids=tuple(turned))
    message = f"{counted_are(len(pairs), 'image point')} left out, wrong matches behind the camera: {shown}"
    return Notice(code="behind_camera", message=message, ids=ids, measured=Severity.REMARK)


def _pairs(result: Adjustment, rows: list[int]) -> list[tuple[str, str]]:
    """Image and point of observations, sorted."""
    o, images, points = result.given.observations, result.given.images.ids, result.given.points.ids
    return sorted({(images[o.image[i]], points[o.point[i]]) for i in rows})


def _rejected(result: Adjustment) -> list[Notice]:
    rejected, o = result.image_observations.rejected, result.given.observations
    kinds = counts(rejected)
    if not kinds:
        return []

    def rows(kind: RejectionKind) -> list[int]:
        return [i for i, r in enumerate(rejected) if r is not None and r.kind is kind]

    each = ", ".join(f"{WORDS[kind]} ({grouped(n)})" for kind, n in kinds.items())
    found = [
        Notice(
            code="rejected",
            message=f"{grouped(sum(kinds.values()))} of {grouped(len(o))} image observations rejected: {each}",
        )
    ]
    lost = rows(RejectionKind.BLUNDER_NOT_LOCATED)
    if lost:
        points = np.unique(o.point[lost])
        names = [result.given.points.ids[p] for p in points]
        found.append(
            Notice(
                code="blunder_not_located",
                measured=Severity.REMARK if automatic(names).all() else Severity.CAUTION,
                message=f"{counted_are(len(names), 'point')} left out: one of "
                f"{'their' if len(names) > 1 else 'its'} rays is wrong, and which one cannot be told "
                f"(fewer than three rays would be left, or two rays explain it alike): {', '.join(names[:10])}"
                f"{' ...' if len(names) > 10 else ''}. More rays to such points would save them",
                ids=tuple(names[:100]),
            )
        )
    behind = rows(RejectionKind.BEHIND_CAMERA)
    if behind:
        found.append(_behind(result, behind))
    diverging = rows(RejectionKind.RAYS_DIVERGE)
    if diverging:
        names = sorted({p for _, p in _pairs(result, diverging)})
        found.append(
            Notice(
                code="rays_diverge",
                message=f"{counted_are(len(names), 'point')} left out, the rays diverge: {', '.join(names[:10])}"
                f"{' ...' if len(names) > 10 else ''}. The match is wrong, or the object is too far away "
                "for these stations",
                ids=tuple(names[:100]),
            )
        )
    return found


def _points(result: Adjustment) -> list[Notice]:
    found: list[Notice] = []
    points = result.given.points
    used = result.image_observations.used
    rays = np.bincount(result.given.observations.point[used], minlength=len(points))
    lone = [points.ids[i] for i in np.flatnonzero((points.role == Role.CONTROL) & (rays == 1))]
    if lone and len(result.given.images) > 1:
        found.append(
            Notice(
                code="one_ray_control", message=f"control points with a single ray: {', '.join(lone)}", ids=tuple(lone)
            )
        )
    given = np.bincount(result.given.observations.point, minlength=len(points))
    silent = (points.role == Role.CONTROL) & (rays == 0)
    for why, some in (
        ("that no image shows", silent & (given == 0)),
        ("whose image points were all rejected", silent & (given > 0)),
    ):
        unseen = [points.ids[i] for i in np.flatnonzero(some)]
        if unseen:
            found.append(
                Notice(
                    code="control_not_observed",
                    message=f"control points {why}: {', '.join(unseen[:10])}; they take no part",
                    ids=tuple(unseen),
                )
            )
    ends = result.given.distances
    cut = [
        f"{points.ids[a]} - {points.ids[b]}"
        for a, b in zip(ends.start.tolist(), ends.end.tolist(), strict=True)
        if any(rays[k] == 0 and given[k] > 0 for k in (a, b))
    ]
    if cut:
        found.append(
            Notice(
                code="distance_lost",
                message=f"distances that take no part, as image points of their ends were rejected: "
                f"{', '.join(cut[:10])}",
                ids=tuple(cut[:100]),
            )
        )
    lost = [points.ids[i] for i in np.flatnonzero((points.role == Role.CHECK) & (rays < 2))]
    if lost:
        found.append(
            Notice(
                code="check_unseen",
                message=f"check points with fewer than two rays: {', '.join(lost[:10])}{' ...' * (len(lost) > 10)}; "
                "they take no part and nothing is compared there",
                ids=tuple(lost[:100]), measured=Severity.REMARK,
            )
        )  # fmt: skip
    network = result.network
    if network is not None:
        flat = np.flatnonzero((network.rays > 1) & (network.intersection_angle < np.radians(1)))
        flat = [i for i in flat if not points.is_control[i].all()]
        if flat:
            names = [points.ids[i] for i in flat]
            found.append(
                Notice(
                    code="small_angle",
                    message=f"{counted_are(len(names), 'object point')} intersected at less than 1 degree: "
                    f"{', '.join(names[:10])}{' ...' if len(names) > 10 else ''}; the depth is weak",
                    ids=tuple(names[:100]),
                )
            )
    return found


def _control(result: Adjustment) -> list[Notice]:
    """Suspects among control, distances and stations, the latter with the family-wise critical value.

    Where a whole group is less precise than stated, one notice says so; single values are suspects beside the others
    of their group.  Of control, the coordinates of a point are judged together (`control_tests`).  Where a scale bar
    alone explains it, that is said of it, and nothing of the control that it bends.
    """
    limit = result.critical_w
    scale = max(result.sigma0, 1.0) if np.isfinite(result.sigma0) else 1.0
    if (bar := wrong_bar(result, limit * scale)) is not None:
        return [bar_notice(bar, limit * scale, result.given.length_unit), *_unchecked(result)]
    found: list[Notice] = []
    against = ControlTests(result).contradiction
    wrong = {c.kind: c for c in result.variance_components if c.significant and c.kind in NAMES.values()}
    for g in map(without_known_before, result.groups):
        component = wrong.get(NAMES[g.kind])
        own = scale
        if (
            component is not None
            and component.ratio > scale
            and component.redundancy > FEW
            and (not against.wrong if g.kind == "control" else _without_worst(result, g))
        ):
            own = component.ratio
            found.append(_group_notice(component, result.sigma0))
            against = Contradiction() if g.kind == "control" else against
        if g.kind == "control":
            found += control_notices(result, against)
            continue
        found += suspect_notices(result, g, limit * own)
    return found + _unchecked(result)


def _unchecked(result: Adjustment) -> list[Notice]:
    """Control of which nothing but its own standard deviation says that it is right: coordinates, and how far."""
    unchecked: dict[str, list[tuple[str, float]]] = {}
    for g in result.groups:
        if g.kind == "control":
            for k in np.flatnonzero((g.sigma > 0) & (g.redundancy < UNCHECKED)).tolist():
                unchecked.setdefault(g.component[k], []).append((g.ids[k], float(g.mdb[k])))
    if not unchecked:
        return []
    told: list[str] = []
    for axis, points in sorted(unchecked.items()):
        seen = [(mdb, name) for name, mdb in points if np.isfinite(mdb)]
        least = f" ({min(seen)[0]:.2g} would just be found at {min(seen)[1]})" if seen else ""
        names = ", ".join(name for name, _ in points[:5]) + " ..." * (len(points) > 5)
        told.append(f"{axis} of {names}{least}")
    return [
        Notice(
            code="control_unchecked",
            message=f"control that the other observations hardly check: {'; '.join(told)}. They know it ten times "
            "worse than stated or more, and smaller errors pass into the result unseen. More control, or check "
            "points, would tell",
            ids=tuple(dict.fromkeys(name for points in unchecked.values() for name, _ in points))[:100],
        )
    ]


KNOWN_BY = 2.0
"""Ratio of the 95 % limits of sigma0 from which on it tells nothing: a-priori values are a guess of that factor."""


def _photographs(result: Adjustment) -> list[Notice]:
    """Photographs joined by tie points that hang on one connection, or whose residuals tell next to nothing.

    Of measured points nothing is said: who measures them knows how few they are.
    """
    block, network = result.given, result.network
    if network is None or not block.observations.point.size:
        return []
    seen = np.unique(block.observations.point)
    if 2 * automatic(block.points.ids[k] for k in seen.tolist()).sum() < len(seen):
        return []
    found: list[Notice] = []
    used = np.unique(block.observations.image[result.image_observations.used])
    weak = [block.images.ids[k] for k in weak_images(network, len(block.images))]
    if weak:
        grave = len(weak) == len(used) > 2  # the block as a whole hangs on few points
        found.append(
            Notice(
                code="weak_photographs",
                measured=Severity.FAULT if grave else Severity.CAUTION,
                values={"weak": len(weak), "photographs": len(used), "common": FIRM},
                message=f"{counted(len(weak), 'photograph')} with fewer than 2 neighbours of {FIRM} common points: "
                f"{', '.join(weak[:10])}{' ...' if len(weak) > 10 else ''}. Their orientation hangs on one connection "
                "or few points; add photographs from positions between theirs and the next",
                ids=tuple(weak[:100]),
            )
        )
    r = result.redundancy
    if r > 0:
        low, _, high = global_test(0.0, r)
        if high > KNOWN_BY**2 * low:
            found.append(
                Notice(
                    code="little_redundancy",
                    message=f"redundancy {r}: sigma0, and with it every standard deviation, is known to a factor of "
                    f"{np.sqrt(high / low):.2g} only (95 % limits; {KNOWN_BY:g} is the least that tells anything), and "
                    "a wrong orientation may fit as well. Add photographs with more overlap, or mark points",
                )
            )
    return found


def _stored_ways(result: Adjustment) -> list[Notice]:
    """Files whose pixels are not those in which image points are told."""
    return [
        Notice(
            code="stored_turned",
            message=f"image points of {counted(len(way.images), 'photograph')} stored {way.words} "
            f"({', '.join(way.images[:5])}{' ...' if len(way.images) > 5 else ''}) are told in the pixels of camera "
            f"{result.given.cameras[way.camera].id}, not of the file: do not copy marks from observations.csv, measure "
            "them in the file",
            ids=way.images[:100],
        )
        for way in stored_ways(result.given)
    ]


def _open_beside_given(result: Adjustment) -> list[Notice]:
    """Control or projection centres that fix a part of the datum only, which is not what they were measured for."""
    points, images = result.given.points, result.given.images
    control = [points.ids[k] for k in np.flatnonzero(points.is_control.any(axis=1))]
    centres = [images.ids[k] for k in dict.fromkeys(result.given.stations.image.tolist())]
    if not (control or centres) or not result.datum_defect:
        return []
    if control and not centres and levelled(result).issuperset(control):
        return []  # what is open is how it lies tilted, which the notice of its unknown heights says
    names = control + centres
    kinds = [("control", control), ("observed projection centres", centres)]
    given = " and ".join(kind for kind, of in kinds if of)
    listed = "; ".join(
        f"{kind}: {', '.join(of[:10])}{' ...' if len(of) > 10 else ''}"
        for kind, of in [("Control points", control), ("Projection centres", centres)]
        if of
    )
    why = _why_open(result, centred=bool(centres))
    return [
        Notice(
            code="control_leaves_open",
            message=f"{given} leave{'s' * (not centres)} open: {', '.join(result.datum_defect)}; that they do "
            f"not tell, or no better than errors of their stated size would: there the result stands arbitrarily, and "
            f"coordinates in that direction mean nothing. {listed}: {why}",
            ids=tuple(names[:100]),
        )
    ]


def _why_open(result: Adjustment, *, centred: bool) -> str:
    """Why control or projection centres leave a part of the datum open, and what to do."""
    from scipy.special import chdtri  # noqa: PLC0415

    if ABOUT_LINE not in result.datum_defect:
        return "measure more"
    points, stations = result.given.points, result.given.stations
    fixed = points.is_control.any(axis=1)
    given = np.concatenate([points.xyz[fixed], stations.xyz])
    sigma = np.concatenate([points.sigma[fixed], stations.sigma])
    given = given[np.isfinite(given).all(axis=1)]
    width = float(np.linalg.svd(given - given.mean(axis=0), compute_uv=False)[1]) if len(given) > 1 else 0.0
    width /= np.sqrt(max(len(given), 1))
    unit = result.given.length_unit
    poor = float(np.nanmax(np.sqrt(np.nanmean(sigma**2, axis=0)))) if np.isfinite(sigma).any() else 0.0
    chance = np.sqrt(chdtri(len(given), LINE) / max(len(given), 1))  # how far errors alone put them off a line
    if width > chance * poor:
        return (
            f"they lie {significant(width, 2)} {unit} rms off one straight line, but standard deviations of "
            f"{significant(poor, 2)} {unit} tell too little about a turn around it; measure them better, heights "
            "above all"
        )
    beside = "measure control beside it" if centred else "measure one beside it"
    return f"they lie on one straight line; {beside}"


LINE = 0.01
"""Probability of lying as far off a line by errors of measurement, below which points do not lie on it."""


def _unchecked_scale(result: Adjustment) -> list[Notice]:
    """Scale bars that no other observation controls: every length stands and falls with them."""
    bars = next((g for g in result.groups if g.kind == "distance"), None)
    if bars is None or not len(bars.ids) or not (np.nan_to_num(bars.redundancy) < UNCONTROLLED).all():
        return []
    names = ", ".join(bars.ids[:5])
    return [
        Notice(
            code="scale_unchecked",
            message=f"nothing controls the scale: it rests on {counted(len(bars.ids), 'scale bar')} "
            f"({names}), and an error of its length goes into every length unseen. A "
            "second bar, or a measured length between two points, would check it",
            ids=bars.ids[:5],
        )
    ]


def _without_worst(result: Adjustment, g: ObservationGroup) -> bool:
    """Whether a group still differs from the others when its largest test value is left out: it is not that one."""
    square, r = without_worst(g)
    worst = float(g.square[g.sigma > 0].sum()) - square
    return differs(square, r, (result.weighted_square_sum - worst, result.redundancy - 1.0))


def _group_notice(component: VarianceComponent, sigma0: float) -> Notice:
    return Notice(
        code="group_less_precise",
        message=f"{component.kind}: less precise than stated by a factor of {component.ratio:.3g} (all together "
        f"{sigma0:.3g}; {component.count} values, redundancy {component.redundancy:.1f}). Give them that much larger a "
        "sigma, or look for what they have in common, as a wrong datum.",
        ids=(component.kind,),
        # a-priori standard deviations are guesses of a factor of two: below POOR_FIT what is stated is a little small
        measured=Severity.FAULT if component.ratio >= POOR_FIT else Severity.CAUTION,
        values={"ratio": component.ratio, "count": component.count, "redundancy": component.redundancy},
    )


def with_group_notices(result: Adjustment) -> tuple[Notice, ...]:
    """The notices of a result whose variance components have changed since."""
    codes = {f"{kind}_suspect" for kind in NAMES} | {"group_less_precise", "control_unchecked"}
    others = tuple(n for n in result.notices if n.code not in codes)
    return (*others, *_control(replace(result, notices=others)))
