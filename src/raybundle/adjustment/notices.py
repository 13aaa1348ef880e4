"""What a result has to say by itself: warnings with the number, the limit and the remedy."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

import numpy as np

from raybundle.adjustment.blunders.accuracy import levelled
from raybundle.adjustment.blunders.bar_tests import bar_notice, wrong_bar
from raybundle.adjustment.blunders.control_notices import control_notices
from raybundle.adjustment.blunders.control_tests import Contradiction, ControlTests
from raybundle.adjustment.blunders.suspects import suspect_notices
from raybundle.adjustment.blunders.wrong_images import wrong_image_notices
from raybundle.adjustment.evaluation.antenna_notices import shift_notices
from raybundle.adjustment.evaluation.interior_notices import interior_notices
from raybundle.adjustment.evaluation.line_notices import line_notices
from raybundle.adjustment.records.figures import ObservationGroup, VarianceComponent
from raybundle.adjustment.records.notice import Notice
from raybundle.adjustment.records.severity import NEARLY, POOR_FIT, Severity
from raybundle.adjustment.result import Adjustment
from raybundle.adjustment.statistics.components import NAMES, differs, without_known_before, without_worst
from raybundle.adjustment.statistics.network import FEW as FIRM
from raybundle.adjustment.statistics.network import weak_images
from raybundle.adjustment.statistics.reliability import UNCONTROLLED, RedundancySum
from raybundle.adjustment.system.datum import ABOUT_LINE, open_values
from raybundle.block import Role
from raybundle.block.frames import stored_ways
from raybundle.block.points import automatic
from raybundle.block.rejection import RejectionKind, counts
from raybundle.errors import Message, Value, message
from raybundle.numerics.statistics import global_test

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
                values={
                    "sum": redundancy_sum.sum,
                    "redundancy": result.redundancy,
                    "limit": float(redundancy_sum.limit),
                },
            )
        )
    control = _control(result)
    found += _outside(result) + _fit(result) + interior_notices(result) + line_notices(result)
    found += _rejected(result) + _points(result) + control + shift_notices(result)
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
    x, y = o.xy_px[k].tolist()
    values: dict[str, Value] = {
        "n": len(rows), "point": block.points.ids[o.point[k]], "image": block.images.ids[o.image[k]],
        "x_px": x, "y_px": y, "width_px": int(size[k, 0]), "height_px": int(size[k, 1]),
    }  # fmt: skip
    return [Notice(code="outside_format", values=values, ids=tuple(images[:100]))]


def _fit(result: Adjustment) -> list[Notice]:
    if result.redundancy == 0:
        return [Notice(code="no_redundancy")]
    lower, value, upper = result.global_test
    if not value > upper and not value < lower:
        return []
    more = value > upper
    grave = Severity.FAULT if result.sigma0 > POOR_FIT else Severity.WARNING
    grave = Severity.NOTE if result.sigma0 < NEARLY else grave
    values: dict[str, Value] = {
        "sigma0": result.sigma0, "percent": 100 * abs(result.sigma0 - 1), "square_sum": value, "lower": lower,
        "upper": upper,
    }  # fmt: skip
    code = "global_test"
    if more and result.sigma0 < NEARLY:
        code = "global_test.nearly"
        values["limit_percent"] = 100 * (NEARLY - 1)
    elif not more:
        estimated = result.options.weights == "residuals"
        code = "global_test.estimated_weights" if estimated else "global_test.smaller"
    return [Notice(code=code, measured=grave if more else Severity.NOTE, values=values)]


def _behind(result: Adjustment, rows: Sequence[int]) -> Notice:
    """Points behind a camera: wrong numbers where somebody named them, else wrong matches, unless they are many."""
    o = result.given.observations
    pairs = _pairs(result, list(rows))
    values: dict[str, Value] = {"n": len(pairs), "pairs": [f"{p} ({i})" for i, p in pairs]}
    ids = tuple(p for _, p in pairs)
    if not automatic(ids).all():
        return Notice(code="behind_camera", values=values, ids=ids)
    n = len(result.given.images)
    share = np.bincount(o.image[list(rows)], minlength=n) / np.maximum(np.bincount(o.image, minlength=n), 1)
    turned = [result.given.images.ids[k] for k in np.flatnonzero(share > TURNED)]
    if turned:
        values = {"n": len(turned), "limit": TURNED}
        return Notice(code="behind_camera.photographs", values=values, ids=tuple(turned))
    return Notice(code="behind_camera.matches", values=values, ids=ids, measured=Severity.NOTE)


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

    each = tuple(message("rejected.kind", kind=kind.value, n=n) for kind, n in kinds.items())
    values: dict[str, Value] = {"n": sum(kinds.values()), "observations": len(o)}
    found = [Notice(code="rejected", values=values, details=each)]
    lost = rows(RejectionKind.BLUNDER_NOT_LOCATED)
    if lost:
        points = np.unique(o.point[lost])
        names = [result.given.points.ids[p] for p in points]
        found.append(
            Notice(
                code="blunder_not_located",
                measured=Severity.NOTE if automatic(names).all() else Severity.WARNING,
                values={"n": len(names)},
                ids=tuple(names[:100]),
            )
        )
    behind = rows(RejectionKind.BEHIND_CAMERA)
    if behind:
        found.append(_behind(result, behind))
    diverging = rows(RejectionKind.RAYS_DIVERGE)
    if diverging:
        names = sorted({p for _, p in _pairs(result, diverging)})
        found.append(Notice(code="rays_diverge", values={"n": len(names)}, ids=tuple(names[:100])))
    return found


def _points(result: Adjustment) -> list[Notice]:
    found: list[Notice] = []
    points = result.given.points
    used = result.image_observations.used
    rays = np.bincount(result.given.observations.point[used], minlength=len(points))
    lone = [points.ids[i] for i in np.flatnonzero((points.role == Role.CONTROL) & (rays == 1))]
    if lone and len(result.given.images) > 1:
        found.append(Notice(code="one_ray_control", values={"n": len(lone)}, ids=tuple(lone)))
    given = np.bincount(result.given.observations.point, minlength=len(points))
    silent = (points.role == Role.CONTROL) & (rays == 0)
    for code, some in (
        ("control_not_observed", silent & (given == 0)),
        ("control_not_observed.rejected", silent & (given > 0)),
    ):
        unseen = [points.ids[i] for i in np.flatnonzero(some)]
        if unseen:
            found.append(Notice(code=code, values={"n": len(unseen)}, ids=tuple(unseen)))
    ends = result.given.distances
    cut = [
        f"{points.ids[a]} - {points.ids[b]}"
        for a, b in zip(ends.start.tolist(), ends.end.tolist(), strict=True)
        if any(rays[k] == 0 and given[k] > 0 for k in (a, b))
    ]
    if cut:
        found.append(Notice(code="distance_lost", values={"n": len(cut)}, ids=tuple(cut[:100])))
    lost = [points.ids[i] for i in np.flatnonzero((points.role == Role.CHECK) & (rays < 2))]
    if lost:
        found.append(
            Notice(code="check_unseen", values={"n": len(lost)}, ids=tuple(lost[:100]), measured=Severity.NOTE)
        )
    network = result.network
    if network is not None:
        flat = np.flatnonzero((network.rays > 1) & (network.intersection_angle < np.radians(1)))
        flat = [i for i in flat if not points.is_control[i].all()]
        if flat:
            names = [points.ids[i] for i in flat]
            values: dict[str, Value] = {"n": len(names), "limit_deg": 1.0}
            found.append(Notice(code="small_angle", values=values, ids=tuple(names[:100])))
    return found


def _control(result: Adjustment) -> list[Notice]:
    """Suspects among control, distances and stations, the latter with the family-wise critical value.

    Where a whole group is less precise than stated, one notice states it; single values are suspects beside the others
    of their group.  Of control, the coordinates of a point are judged together (`control_tests`).  Where a scale bar
    alone explains it, that is stated of it, and nothing of the control that it bends.
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
    """Control of which nothing but its own standard deviation states that it is right: coordinates, and how far."""
    unchecked: dict[str, list[tuple[str, float]]] = {}
    for g in result.groups:
        if g.kind == "control":
            for k in np.flatnonzero((g.sigma > 0) & (g.redundancy < UNCHECKED)).tolist():
                unchecked.setdefault(g.component[k], []).append((g.ids[k], float(g.mdb[k])))
    if not unchecked:
        return []
    each: list[Message] = []
    for axis, points in sorted(unchecked.items()):
        names = [name for name, _ in points]
        seen = [(mdb, name) for name, mdb in points if np.isfinite(mdb)]
        if seen:
            least, point = min(seen)
            unit = result.given.length_unit
            each.append(
                message(
                    "control_unchecked.axis", axis=axis, n=len(names), points=names, least=least, point=point, unit=unit
                )
            )
        else:
            each.append(message("control_unchecked.no_limit", axis=axis, n=len(names), points=names))
    ids = tuple(dict.fromkeys(name for points in unchecked.values() for name, _ in points))
    return [Notice(code="control_unchecked", values={"n": len(ids)}, ids=ids[:100], details=tuple(each))]


KNOWN_BY = 2.0
"""Ratio of the 95 % limits of sigma0 from which on it shows nothing: a-priori values are a guess of that factor."""


def _photographs(result: Adjustment) -> list[Notice]:
    """Photographs joined by tie points that hang on one connection, or whose residuals show next to nothing.

    Of measured points nothing is stated: who measures them knows how few they are.
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
                measured=Severity.FAULT if grave else Severity.WARNING,
                values={"weak": len(weak), "photographs": len(used), "common": FIRM},
                ids=tuple(weak[:100]),
            )
        )
    r = result.redundancy
    if r > 0:
        low, _, high = global_test(0.0, r)
        if high > KNOWN_BY**2 * low:
            values: dict[str, Value] = {"redundancy": r, "factor": float(np.sqrt(high / low)), "limit": KNOWN_BY}
            found.append(Notice(code="little_redundancy", values=values))
    return found


def _stored_ways(result: Adjustment) -> list[Notice]:
    """Files whose pixels are not those in which image points are given."""
    found: list[Notice] = []
    for way in stored_ways(result.given):
        camera = result.given.cameras[way.camera].id
        values: dict[str, Value] = {"n": len(way.images), "camera": camera}
        code = "stored_turned" if way.frame.turned else "stored_turned.size"
        if way.frame.turned:
            values["turned_deg"] = way.frame.turned
        else:
            values |= {"width_px": way.frame.width_px, "height_px": way.frame.height_px}
        found.append(Notice(code=code, values=values, ids=way.images[:100]))
    return found


def _open_beside_given(result: Adjustment) -> list[Notice]:
    """Control or projection centres that fix a part of the datum only, which is not what they were measured for."""
    points, images = result.given.points, result.given.images
    control = [points.ids[k] for k in np.flatnonzero(points.is_control.any(axis=1))]
    centres = [images.ids[k] for k in dict.fromkeys(result.given.stations.image.tolist())]
    if not (control or centres) or not result.datum_defect:
        return []
    if control and not centres and levelled(result).issuperset(control):
        return []  # what is open is how it lies tilted, which the notice of its unknown heights states
    names = control + centres
    kind = "both" if control and centres else "control" if control else "centres"
    code, values = _why_open(result)
    part, each = open_values(result.datum_defect)
    values |= {"n": len(result.datum_defect), "part": part, "kind": kind}
    return [Notice(code=code, values=values, ids=tuple(names[:100]), details=each)]


def _why_open(result: Adjustment) -> tuple[str, dict[str, Value]]:
    """Why control or projection centres leave a part of the datum open, as a code and its values."""
    from scipy.special import chdtri

    if ABOUT_LINE not in result.datum_defect:
        return "control_leaves_open", {}
    points, stations = result.given.points, result.given.stations
    fixed = points.is_control.any(axis=1)
    given = np.concatenate([points.xyz[fixed], stations.xyz])
    sigma = np.concatenate([points.sigma[fixed], stations.sigma])
    given = given[np.isfinite(given).all(axis=1)]
    width = float(np.linalg.svd(given - given.mean(axis=0), compute_uv=False)[1]) if len(given) > 1 else 0.0
    width /= np.sqrt(max(len(given), 1))
    poor = float(np.nanmax(np.sqrt(np.nanmean(sigma**2, axis=0)))) if np.isfinite(sigma).any() else 0.0
    chance = np.sqrt(chdtri(len(given), LINE) / max(len(given), 1))  # how far errors alone put them off a line
    if width > chance * poor:
        return "control_leaves_open.imprecise", {"width": width, "sigma": poor, "unit": result.given.length_unit}
    return "control_leaves_open.line", {}


LINE = 0.01
"""Probability of lying as far off a line by errors of measurement, below which points do not lie on it."""


def _unchecked_scale(result: Adjustment) -> list[Notice]:
    """Scale bars that no other observation controls: every length stands and falls with them."""
    bars = next((g for g in result.groups if g.kind == "distance"), None)
    if bars is None or not len(bars.ids) or not (np.nan_to_num(bars.redundancy) < UNCONTROLLED).all():
        return []
    return [Notice(code="scale_unchecked", values={"n": len(bars.ids)}, ids=bars.ids[:5])]


def _without_worst(result: Adjustment, g: ObservationGroup) -> bool:
    """Whether a group still differs from the others when its largest test value is left out: it is not that one."""
    square, r = without_worst(g)
    worst = float(g.square[g.sigma > 0].sum()) - square
    return differs(square, r, (result.weighted_square_sum - worst, result.redundancy - 1.0))


def _group_notice(component: VarianceComponent, sigma0: float) -> Notice:
    return Notice(
        code="group_less_precise",
        ids=(component.kind,),
        # a-priori standard deviations are guesses of a factor of two: below POOR_FIT what is stated is a little small
        measured=Severity.FAULT if component.ratio >= POOR_FIT else Severity.WARNING,
        values={
            "kind": component.kind.replace(" ", "_"),
            "ratio": component.ratio,
            "sigma0": sigma0,
            "count": component.count,
            "redundancy": component.redundancy,
        },
    )


def with_group_notices(result: Adjustment) -> tuple[Notice, ...]:
    """The notices of a result whose variance components have changed since."""
    codes = {f"{kind}_suspect" for kind in NAMES} | {"group_less_precise", "control_unchecked"}
    others = tuple(n for n in result.notices if n.code not in codes)
    return (*others, *_control(replace(result, notices=others)))
