"""Notices of points, image points and the fit: each names its objects, at its limit and not before."""

from dataclasses import replace

import numpy as np
import pytest
from scipy.stats import chi2

from raybundle.adjustment.engine import adjust_block
from raybundle.adjustment.notices import _fit, _outside, _photographs, _points
from raybundle.adjustment.records.options import AdjustmentOptions
from raybundle.adjustment.records.severity import NEARLY, POOR_FIT
from raybundle.block import Role
from raybundle.block.rejection import Rejection, RejectionKind
from raybundle.planning.simulate import Survey, simulate
from raybundle.planning.synthetic_networks import TargetField, field_scene


@pytest.fixture(scope="module")
def result():
    survey = Survey(points="exact", orientation="exact", interior="exact", control=8, control_sigma=(1e-3,) * 3,
                    check=3, scale_bars=2)  # fmt: skip
    block = simulate(field_scene(TargetField(rows=5, columns=6, stations=4, frontal=1)), survey).observed
    return adjust_block(block, AdjustmentOptions(jobs=1))


def without_rays(result, left):
    """The result with all rays of some points rejected but so many: point -> number."""
    o = result.given.observations
    lost = np.zeros(len(o), bool)
    for point, number in left.items():
        lost[np.flatnonzero(o.point == point)[number:]] = True
    reasons = tuple(Rejection(kind=RejectionKind.GIVEN) if k else None for k in lost)
    return replace(result, image_observations=replace(result.image_observations, rejected=reasons))


def codes(notices):
    return {n.data.code: n for n in notices}


def test_points_that_lost_their_rays_are_named(result):
    points, bars = result.given.points, result.given.distances
    ends = {*bars.start.tolist(), *bars.end.tolist()}
    control, check, tie = (
        [k for k in np.flatnonzero(points.role == role).tolist() if k not in ends]
        for role in (Role.CONTROL, Role.CHECK, Role.TIE)
    )
    assert codes(_points(result)).keys() <= {"small_angle"}
    end = int(bars.end[1])
    left = {control[0]: 1, control[1]: 0, control[2]: 2, check[0]: 1, check[1]: 2, check[2]: 0, tie[0]: 0, end: 0}
    found = codes(_points(without_rays(result, left)))
    ids = points.ids
    silent = [ids[control[1]], *([ids[end]] if points.role[end] == Role.CONTROL else [])]
    assert set(found["control_not_observed.rejected"].ids) == set(silent)
    assert "control_not_observed" not in found
    assert found["one_ray_control"].ids == (ids[control[0]],)
    assert set(found["check_unseen"].ids) == {ids[check[0]], ids[check[2]]}
    cut = [f"{ids[a]} - {ids[b]}" for a, b in zip(bars.start, bars.end, strict=True)
           if {int(a), int(b)} & {int(k) for k, n in left.items() if n == 0}]  # fmt: skip
    assert list(found["distance_lost"].ids) == cut
    assert len(cut) > 0
    narrow = replace(
        result.network, intersection_angle=np.where(np.isin(np.arange(len(points)), tie[:2]), 0.017, 0.018)
    )
    assert set(codes(_points(replace(result, network=narrow)))["small_angle"].ids) == {ids[tie[0]], ids[tie[1]]}


@pytest.mark.parametrize(("axis", "side"), [(0, -1), (0, 1), (1, -1), (1, 1)])
def test_image_points_beyond_the_format_are_named_from_six_sigma_and_half_a_pixel(result, axis, side):
    o, camera = result.given.observations, result.given.cameras[0]
    sigma = np.sqrt(o.cov_px2[7, axis])
    for more, due in ((-0.01, False), (0.01, True)):
        xy = o.xy_px.copy()
        edge = 0.0 if side < 0 else (camera.width_px, camera.height_px)[axis]
        xy[7, axis] = edge + side * (0.5 + 6 * sigma + more)
        found = _outside(replace(result, given=replace(result.given, observations=replace(o, xy_px=xy))))
        assert bool(found) is due
    values = found[0].values
    assert values["n"] == 1
    assert values["point"] == result.given.points.ids[o.point[7]]
    assert values["image"] == result.given.images.ids[o.image[7]] == found[0].ids[0]
    assert (values["x_px"], values["y_px"]) == tuple(xy[7])
    assert (values["width_px"], values["height_px"]) == (camera.width_px, camera.height_px)


@pytest.mark.parametrize(
    ("sigma0", "code", "severity"),
    [
        (0.5, "global_test.smaller", "note"),
        (0.98 * NEARLY, "global_test.nearly", "note"),
        (1.02 * NEARLY, "global_test", "warning"),
        (0.98 * POOR_FIT, "global_test", "warning"),
        (1.02 * POOR_FIT, "global_test", "fault"),
    ],
)
def test_sigma0_beside_one(result, sigma0, code, severity):
    r = 100_000
    limits = chi2(r).ppf([0.025, 0.975])
    found = replace(result, sigma0=sigma0, redundancy=r, global_test=(limits[0], sigma0**2 * r, limits[1]))
    (notice,) = _fit(found)
    assert (notice.data.code, notice.severity) == (code, severity)
    assert notice.values["percent"] == pytest.approx(abs(100 * sigma0 - 100))
    assert not _fit(replace(found, global_test=(limits[0], r, limits[1])))


def test_below_some_redundancy_sigma0_is_known_to_no_factor_of_two(result):
    names = tuple(f"t{k + 1}" for k in range(len(result.given.points)))
    ties = replace(result, given=replace(result.given, points=replace(result.given.points, ids=names)))
    for r in range(1, 60):
        low, high = chi2(r).ppf([0.025, 0.975])
        found = codes(_photographs(replace(ties, redundancy=r)))
        assert ("little_redundancy" in found) is bool(high > 4 * low)
        if high > 4 * low:
            assert found["little_redundancy"].values["factor"] == pytest.approx(np.sqrt(high / low))
    assert "little_redundancy" not in codes(_photographs(result))
