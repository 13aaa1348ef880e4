"""Projects that contradict each other are not merged in silence: given coordinates, places, scales, cameras, copies."""

from dataclasses import replace

import numpy as np
import pytest
from tests.messages import refused

import raybundle as rb
from raybundle.adjustment.records.options import AdjustmentOptions
from raybundle.block.same_images import images_measured_alike
from raybundle.block.select import select_block
from raybundle.block.transform import transform_block
from raybundle.cli.main import main
from raybundle.errors import InputError, Severity
from raybundle.io.block.scenes import local_in
from raybundle.metrology.frames import between
from raybundle.metrology.point_set import PointSet
from raybundle.numerics.length_units import units_of
from raybundle.numerics.places import Geocentric
from raybundle.numerics.transform import SimilarityTransform
from raybundle.planning.simulate import Survey, simulate
from raybundle.planning.synthetic_networks import AerialStrips, TargetField, aerial_scene, field_scene
from raybundle.workflows.block_frame import in_frame_of

UTM = "EPSG:32733"
ORIGIN = (500000.0, 6200000.0, 1200.0)


def flight(seed):
    scene = aerial_scene(AerialStrips(strips=2, images_per_strip=4, points_per_image=60))
    survey = Survey(
        seed=seed, image_sigma_px=0.3, control=5, control_sigma=(0.02, 0.02, 0.03), check=5, check_sigma=0.02,
        interior="exact",
    )  # fmt: skip
    return simulate(scene, survey).observed


def field(seed, length=1.0, **settings):
    survey = Survey(seed=seed, image_sigma_px=0.3, scale_bars=1, scale_bar_sigma=1e-5, **settings)
    block = simulate(field_scene(TargetField(rows=4, columns=5, stations=12)), survey).observed
    d = block.distances
    return block.having(replace(d, length=length * d.length))


@pytest.fixture(scope="module")
def flown():
    return flight(1)


@pytest.fixture(scope="module")
def flown_again(flown):
    """Another flight with the control of the first."""
    return replace(flight(2), points=flown.points)


def merged(tmp_path, *blocks, **settings):
    folders = [tmp_path / f"project-{k + 1}" for k in range(len(blocks))]
    for block, folder in zip(blocks, folders, strict=True):
        rb.write_block(block, folder)
    return rb.merge_projects(folders, tmp_path / "both", **settings)


def given(block):
    return block.points.is_control | block.points.is_check


def without(block, *roles):
    p = block.points
    gone = np.isin(p.role, [int(r) for r in roles])
    return replace(
        block,
        points=replace(
            p,
            role=np.where(gone, 0, p.role).astype(p.role.dtype),
            sigma=np.where(gone[:, None], np.nan, p.sigma),
            xyz=np.where(gone[:, None], np.nan, p.xyz),
        ),
    )


def test_given_coordinates_stay_as_they_are_given(flown, flown_again, tmp_path):
    for k, other in enumerate((without(flown_again, 1, 2), without(flown_again, 1), flown_again)):
        done = merged(tmp_path / str(k), flown, other).block
        where = [done.points.ids.index(n) for n in flown.points.ids]
        some = given(flown)
        assert some.sum() == 30
        np.testing.assert_array_equal(done.points.xyz[where][some], flown.points.xyz[some])
        np.testing.assert_array_equal(done.points.sigma[where], flown.points.sigma)
        away = np.linalg.norm(rb.adjust(done).adjusted.points.xyz[where] - flown.points.xyz, axis=1)
        assert np.nanmax(away) < 0.3


def test_given_coordinates_that_contradict_are_refused_by_what_they_differ(flown, flown_again, tmp_path):
    for k, (by, only) in enumerate(((1000.0, 5), (5.0, 1))):
        p = flown_again.points
        rows = np.flatnonzero(p.is_control.any(axis=1))[:only]
        xyz = p.xyz.copy()
        xyz[rows, 0] += by
        wrong = replace(flown_again, points=replace(p, xyz=xyz))
        with refused("join.control_contradicts", apart=by, limit=pytest.approx(0.1414, abs=1e-4), unit="m"):
            merged(tmp_path / str(k), flown, wrong)


def at(block, origin, crs=UTM):
    return replace(block, place=local_in(crs, origin))


def test_another_origin_of_one_system_is_brought_to_the_first(flown, flown_again):
    here, there = at(flown, ORIGIN), at(flown_again, (500100.0, 6199000.0, 1250.0))
    told = in_frame_of(at(flown_again, ORIGIN), there)
    assert told.reported.code == "join.other_frame"
    assert told.reported.values["name"] == flown_again.name
    assert told.reported.values["away_m"] > 900
    back = in_frame_of(told.block, here).block
    np.testing.assert_allclose(back.points.xyz, flown_again.points.xyz, atol=1e-8)
    np.testing.assert_allclose(back.images.centre, flown_again.images.centre, atol=1e-8)
    np.testing.assert_allclose(back.images.rotation, flown_again.images.rotation, atol=1e-12)
    # the same place on the earth
    one = here.place.geographic_from_block(flown_again.images.centre)
    np.testing.assert_allclose(told.block.place.geographic_from_block(told.block.images.centre), one, rtol=0, atol=1e-6)
    assert np.linalg.norm(told.block.images.centre - flown_again.images.centre, axis=1).min() > 900


def test_flights_of_two_origins_are_one_block(flown, flown_again, tmp_path):
    other = in_frame_of(at(flown_again, ORIGIN), at(flown, (500100.0, 6200000.0, 1200.0))).block
    done = merged(tmp_path, at(flown, ORIGIN), other)
    assert any(r.code == "join.other_frame" for r in done.remarks)
    assert not done.cautions
    assert done.joints[0].rms < 0.2
    assert rb.adjust(done.block).sigma0 == pytest.approx(1.0, abs=0.1)


def test_other_places_on_the_earth_are_refused_with_both_systems(flown, flown_again, tmp_path):
    with refused("join.frames_differ") as error:
        merged(tmp_path, at(flown, ORIGIN), at(flown_again, (166100.0, 7500000.0, 20.0), "EPSG:32701"))
    found = [(d.values["system"], d.values["x_m"]) for d in error.value.message.details]
    assert found == [("EPSG:32701", 166100.0), ("EPSG:32733", 500000.0)]
    with pytest.raises(InputError, match="geocentric"):
        in_frame_of(replace(flown, place=Geocentric()), at(flown, ORIGIN))


def test_control_that_shifts_a_whole_project_is_told(flown, tmp_path):
    """Other control points than the first project has, all of them off by half a metre."""
    other = flight(2)
    p = other.points
    names = tuple(f"other-{n}" if r else n for n, r in zip(p.ids, p.role, strict=True))
    xyz = np.where(p.is_control | p.is_check, p.xyz + np.array([0.5, 0, 0]), p.xyz)
    done = merged(tmp_path, flown, replace(other, points=replace(p, ids=names, xyz=xyz)))
    (caution,) = done.cautions
    assert caution.code == "join.frames_contradict"
    assert caution.severity is Severity.WARNING
    assert caution.values["shift_m"] == pytest.approx(0.5, abs=0.1)


def test_scale_bars_that_contradict_are_told_with_factor_and_sigma(tmp_path, capsys):
    done = merged(tmp_path, field(3), field(4, 1.001))
    (caution,) = done.cautions
    assert caution.code == "join.scales_contradict"
    assert abs(caution.values["factor"] - 1.001) < 4 * caution.values["sigma"] < 4e-5
    assert [d.values["kind"] for d in caution.details] == ["bars", "bars"]
    assert not merged(tmp_path / "alike", field(3), field(4)).cautions
    sources = [str(tmp_path / f"project-{k}") for k in (1, 2)]
    assert main(["merge", *sources, "--out", str(tmp_path / "b")]) == 0
    assert f"warning: {caution.headline()}" in capsys.readouterr().out


def test_a_unit_that_lies_is_refused_and_named(tmp_path):
    big = transform_block(field(4), SimilarityTransform(scale=1000.0), observed="follow")
    with refused("join.other_unit", name="project-2", unit="mm", base="project-1", base_unit="m"):
        merged(tmp_path, field(3), big)
    assert units_of(25.4) == ("mm", "inches")
    assert units_of(304.8) == ("mm", "feet")
    assert units_of(3.2808) == ("feet", "m")
    assert units_of(0.001) == ("m", "mm")
    assert units_of(5.0) is None


def test_the_scale_between_two_measurements_is_true():
    """Over many drawn pairs the factor scatters as its standard deviation says."""
    rng = np.random.default_rng(0)
    xyz = rng.normal(size=(12, 3))
    ids = tuple(map(str, range(12)))

    def drawn():
        scale = 1 + 1e-4 * rng.normal()
        middle = xyz - xyz.mean(axis=0)
        direction = middle.reshape(-1, 1)
        covariance = 1e-8 * np.eye(36) + 1e-8 * direction @ direction.T
        return PointSet(name="s", ids=ids, xyz=scale * middle + 1e-4 * rng.normal(size=(12, 3)), covariance=covariance)

    found = [between(drawn(), drawn(), ids, placed=False) for _ in range(400)]
    t = np.array([(f.factor - 1) / f.sigma for f in found])
    assert np.std(t) == pytest.approx(1.0, abs=0.12)  # 3 standard deviations of it
    assert abs(np.mean(t)) < 0.16


def test_photographs_with_the_same_image_points_count_once(flown, flown_again, tmp_path):
    assert images_measured_alike(flown, flown_again) == ()
    with refused("join.same_measurement", n=8, first="project-1", second="project-2"):
        merged(tmp_path, flown, flown)
    part = select_block(flown, "image", np.arange(2))
    ids = tuple(f"again-{i}" for i in part.images.ids)
    part = replace(part, images=replace(part.images, ids=ids))
    both = rb.merge_blocks([flown_again, part], prefer={"point": 0})
    done = merged(tmp_path / "some", flown, both)
    (caution,) = done.cautions
    assert caution.code == "join.same_photographs"
    assert (caution.values["n"], caution.values["first"], caution.values["second"]) == (2, "project-1", "project-2")


def camera(block, **values):
    (c,) = block.cameras
    return replace(block, cameras=(replace(c, values={**c.values, **values}, estimate=(), sigma={}),))


def test_the_same_camera_with_other_values_is_refused(tmp_path):
    one, other = field(3), field(4)
    assert not merged(tmp_path / "free", one, other, same_camera=True).cautions
    with refused("join.camera_contradicts", times=pytest.approx(51, abs=0.5)):
        merged(tmp_path / "held", one, camera(other, c=one.cameras[0].values["c"] * 1.01), same_camera=True)


def test_approximations_of_a_camera_contradict_nothing(tmp_path):
    one, other = field(3), field(4)
    rough = replace(other, cameras=(replace(other.cameras[0], values={**other.cameras[0].values, "c": 25.0}),))
    assert not merged(tmp_path, one, rough, same_camera=True).cautions


def test_blocks_that_nothing_fixes_have_no_scale_to_contradict(tmp_path):
    free = [replace(b, tables={}) for b in (field(3), field(4, 2.0))]
    results = [tmp_path / f"r{k}" for k in range(2)]
    for block, folder in zip(free, results, strict=True):
        rb.write_result(rb.adjust(block, AdjustmentOptions(datum="inner")), folder, report="none")
    assert not rb.merge_projects(results, tmp_path / "both").cautions
