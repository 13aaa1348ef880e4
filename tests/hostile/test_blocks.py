"""Blocks that cannot be adjusted as they stand, or only with a warning: each says what, which and what to do."""

from dataclasses import replace

import numpy as np
import pytest

from raybundle.adjustment.records.options import AdjustmentOptions
from raybundle.block import Images, Observations, Points, Role
from raybundle.errors import DatumDefect, InputError, NotSolvable, RankDefect
from raybundle.planning.simulate import Survey, simulate
from raybundle.planning.synthetic_networks import TargetField, field_scene
from raybundle.workflows.adjust import adjust
from tests.fields import SMALL
from tests.messages import refused

SCENE = field_scene(TargetField(rows=6, columns=8, stations=6, frontal=2))


def observed(**survey):
    return simulate(SCENE, Survey(**survey)).observed


def codes(result):
    return {n.code for n in result.notices}


def with_rows(block, keep):
    o = block.observations
    rows = Observations(image=o.image[keep], point=o.point[keep], xy_px=o.xy_px[keep], cov_px2=o.cov_px2[keep])
    return replace(block, observations=rows)


def test_a_single_ray_is_named():
    block = observed()
    o = block.observations
    rows = np.flatnonzero(o.point == 7)
    keep = np.ones(len(o), bool)
    keep[rows[1:]] = False
    with pytest.raises(InputError, match=rf"{block.points.ids[7]}.*tie_points\.too_few_rays"):
        adjust(with_rows(block, keep))


def test_a_point_without_observation_is_named():
    block = observed()
    with pytest.raises(InputError, match=rf"{block.points.ids[3]}.*tie_points\.too_few_rays"):
        adjust(with_rows(block, block.observations.point != 3))


def test_a_point_that_starts_behind_the_camera_comes_back():
    block = observed(points="exact", orientation="exact", control=5)
    xyz = block.points.xyz.copy()
    k = int(np.flatnonzero(block.points.role == Role.TIE)[0])
    xyz[k] = [0, 0, 10]
    result = adjust(replace(block, points=replace(block.points, xyz=xyz)))
    assert result.sigma0 < 1.3
    assert not any(result.image_observations.rejected)


def test_a_point_behind_the_camera_is_rejected_and_named():
    block = observed(points="exact", orientation="exact", control=5)
    xyz, role, sigma = block.points.xyz.copy(), block.points.role.copy(), block.points.sigma.copy()
    k = int(np.flatnonzero(role == Role.TIE)[0])
    xyz[k], role[k], sigma[k] = [0, 0, 10], Role.CONTROL, 0
    result = adjust(replace(block, points=replace(block.points, xyz=xyz, role=role, sigma=sigma)))
    assert "behind_camera" in codes(result)
    reasons = [r for r in result.image_observations.rejected if r]
    assert {str(r) for r in reasons} == {"behind camera"}
    assert result.sigma0 < 1.3


@pytest.mark.parametrize("oriented", [True, False])
def test_two_identical_images_are_recognised(oriented):
    block = observed(points="exact", orientation="approximate")
    o = block.observations
    one = np.flatnonzero(o.image == 0)
    point, index = np.unique(o.point[one], return_inverse=True)
    images, points = block.images, block.points
    twice = replace(
        block,
        images=Images(
            ids=("a", "b"), camera=np.zeros(2, np.int32), file=("", ""),
            centre=images.centre[:2] if oriented else np.full((2, 3), np.nan),
            rotation=images.rotation[:2] if oriented else np.full((2, 3, 3), np.nan),
        ),
        observations=Observations(
            image=np.repeat(np.array([0, 1], np.int32), len(one)), point=np.tile(index, 2).astype(np.int32),
            xy_px=np.tile(o.xy_px[one], (2, 1)), cov_px2=np.tile(o.cov_px2[one], (2, 1)),
        ),
        points=Points(
            ids=tuple(points.ids[i] for i in point), role=points.role[point], xyz=points.xyz[point],
            sigma=points.sigma[point],
        ),
    )  # fmt: skip
    with pytest.raises(NotSolvable, match=r" a and b\."):
        adjust(twice)


def square_views():
    flat = field_scene(TargetField(rows=6, columns=8, depth=0.0, stations=0, frontal=5, tilt_deg=0))
    centre = flat.centre.copy()
    centre[:, 2] = 2.2
    return simulate(
        replace(flat, centre=centre, rotation=np.tile(np.eye(3), (len(centre), 1, 1))),
        Survey(control=4, orientation="exact"),
    ).observed


def test_a_plane_photographed_squarely_leaves_c_open():
    result = adjust(square_views())
    assert result.not_determinable == ("c (camera 1)",)
    notice = next(n for n in result.notices if n.code == "not_determinable")
    assert notice.values["remedy"] == "converge"
    automatic = adjust(square_views(), AdjustmentOptions(estimate="auto"))
    assert "c (camera 1)" in automatic.not_determinable
    assert automatic.interior[0].parameters["c"].std is None
    assert "held_not_determinable" in codes(automatic)


def test_no_datum_is_an_error_only_if_control_is_asked_for():
    with refused("datum.not_by_control", DatumDefect, free=7):
        adjust(observed(), AdjustmentOptions(datum="control"))
    result = adjust(observed())
    assert len(result.datum_defect) == result.constraints == 7


def test_control_in_plan_only_leaves_the_height_to_inner_constraints():
    result = adjust(observed(control=5, control_sigma=(1e-4, 1e-4, np.nan)))
    assert result.datum_defect == ("position Z",)
    assert result.constraints == 1
    assert "inner constraints" in result.datum
    assert result.sigma0 < 1.3


def test_unconnected_parts_are_named():
    a = observed()
    n, p = len(a.images), len(a.points)
    two = replace(
        a,
        images=Images(
            ids=(*a.images.ids, *("b" + i for i in a.images.ids)), camera=np.tile(a.images.camera, 2),
            file=a.images.file * 2, centre=np.vstack([a.images.centre, a.images.centre + 50]),
            rotation=np.vstack([a.images.rotation] * 2),
        ),
        observations=Observations(
            image=np.concatenate([a.observations.image, a.observations.image + n]).astype(np.int32),
            point=np.concatenate([a.observations.point, a.observations.point + p]).astype(np.int32),
            xy_px=np.vstack([a.observations.xy_px] * 2), cov_px2=np.vstack([a.observations.cov_px2] * 2),
        ),
        points=Points(
            ids=(*a.points.ids, *("b" + i for i in a.points.ids)), role=np.tile(a.points.role, 2),
            xyz=np.vstack([a.points.xyz] * 2), sigma=np.vstack([a.points.sigma] * 2),
        ),
    )  # fmt: skip
    with refused("block.parts_without_datum", DatumDefect, parts=2) as error:
        adjust(two)
    assert f"images {a.images.ids[0]}" in str(error.value)
    assert f"images b{a.images.ids[0]}" in str(error.value)


def wrong_control():
    block = observed(control=8, control_sigma=(1e-4, 1e-4, 1e-4))
    xyz = block.points.xyz.copy()
    k = int(np.flatnonzero(block.points.role == Role.CONTROL)[2])
    xyz[k, 0] += 1e-3
    return replace(block, points=replace(block.points, xyz=xyz)), block.points.ids[k]


def test_a_control_point_ten_sigma_off_is_named():
    block, name = wrong_control()
    result = adjust(block)
    assert {n.ids for n in result.notices if n.code == "control_suspect"} == {(name,)}
    cleaned = adjust(block, AdjustmentOptions(reject="snooping"))
    assert [n.ids for n in cleaned.notices if n.code == "control_rejected"] == [(name,)]


def test_gross_errors_are_found_and_nothing_else():
    simulation = simulate(field_scene(SMALL), Survey(gross_share=0.01, gross_px=20))
    plain = adjust(simulation.observed)
    assert "global_test" in codes(plain)
    result = adjust(simulation.observed, AdjustmentOptions(reject="snooping"))
    rejected = np.array([bool(r) for r in result.image_observations.rejected])
    assert rejected[simulation.gross].all()
    assert (rejected & ~simulation.gross).sum() <= 2
    assert result.sigma0 < 1.1


def test_an_image_with_two_points_is_named():
    block = observed(points="exact", orientation="exact", least_rays=3)
    rows = np.flatnonzero(block.observations.image == 4)
    keep = np.ones(len(block.observations), bool)
    keep[rows[2:]] = False
    with pytest.raises(RankDefect, match=rf"{block.images.ids[4]}[\s\S]*image\.too_few_points"):
        adjust(with_rows(block, keep))


def test_approximate_values_leave_control_as_given():
    from raybundle.orientation import approximate_values

    block = observed(control=5, control_sigma=(1e-4, 1e-4, np.nan), orientation="absent")
    start = approximate_values(block).block
    given = block.points.is_control
    np.testing.assert_array_equal(start.points.xyz[given], block.points.xyz[given])
