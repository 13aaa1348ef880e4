"""Onto control, robustly: blunders are named, heights that are not known are said."""

from dataclasses import replace
from datetime import UTC, datetime, timedelta
from pathlib import Path
from types import SimpleNamespace

import numpy as np
import pytest

from raybundle.adjustment.accuracy import accuracy
from raybundle.adjustment.engine import adjust_block
from raybundle.adjustment.options import AdjustmentOptions
from raybundle.block import Points, Role
from raybundle.block.select import transformed, with_rows
from raybundle.block.simulate import AerialStrips, Survey, aerial_scene, simulate
from raybundle.cli.summary import summary_lines
from raybundle.errors import InputError
from raybundle.io.control_files import ControlFile, Measurements
from raybundle.numerics.geodesy import LocalPlace
from raybundle.numerics.progress import silent
from raybundle.numerics.rotation import rotation_from_angles
from raybundle.numerics.transform import similarity
from raybundle.report.result_folder import check_differences, write_result
from raybundle.workflows.control_apart import check_apart
from raybundle.workflows.final import final_adjustment
from raybundle.workflows.georeference import georeference
from raybundle.workflows.marks import Given, ScaleBar
from raybundle.workflows.mirrored import mirrored_notices, without_control
from raybundle.workflows.misread import misread
from raybundle.workflows.parts import place_parts

NAMES = ("A", "B", "C", "D", "E", "F")


@pytest.fixture(scope="module")
def flight():
    """A free block somewhere, the truth, and six points with their marks."""
    simulation = simulate(aerial_scene(AerialStrips()), Survey(image_sigma_px=0.1, interior="exact"))
    truth = simulation.truth
    rays = truth.ray_count
    xyz = truth.points.xyz
    chosen: list[int] = []
    for corner in np.array([[-1, -1], [1, -1], [1, 1], [-1, 1], [0, 0], [0.5, -0.2]]):
        half = np.ptp(xyz[:, :2], axis=0) * 0.35
        distance = np.linalg.norm(xyz[:, :2] - (xyz[:, :2].mean(axis=0) + corner * half), axis=1)
        distance[rays < 4] = np.inf
        distance[chosen] = np.inf
        chosen.append(int(distance.argmin()))
    o = simulation.observed.observations
    rows = np.flatnonzero(np.isin(o.point, chosen))
    marks = Measurements(
        image=tuple(truth.images.ids[i] for i in o.image[rows]),
        point=np.array([chosen.index(p) for p in o.point[rows]], np.int32),
        xy_px=o.xy_px[rows],
        line=np.arange(2, 2 + len(rows), dtype=np.int32),
    )
    role = np.zeros(len(truth.points), np.int32)
    free = replace(
        truth,
        points=replace(truth.points, role=role, sigma=np.full_like(xyz, np.nan)),
        observations=simulation.observed.observations,
    )
    free = transformed(free, 0.013, rotation_from_angles(np.array([0.4, -0.3, 2.0])), np.array([1.0, 2.0, 3.0]))
    photos = [
        SimpleNamespace(
            name=name, width_px=truth.cameras[0].width_px, height_px=truth.cameras[0].height_px, orientation=1,
            metadata=SimpleNamespace(gps=None, make="", model="", serial="", taken=None),
        )
        for name in truth.images.ids
    ]  # fmt: skip
    return SimpleNamespace(free=free, truth=truth, photos=photos, marks=marks, xyz=xyz[chosen])


def control(flight, xyz=None, marks=None, sigma=0.01):
    xyz = flight.xyz if xyz is None else xyz
    return ControlFile(
        path=Path("control.csv"), crs=None, ids=NAMES, xyz=xyz, sigma=np.where(np.isfinite(xyz), sigma, np.nan),
        role=np.full(6, Role.CONTROL, np.int32), measurements=marks or flight.marks,
    )  # fmt: skip


def error(flight, placed):
    return np.linalg.norm(placed.block.images.centre - flight.truth.images.centre, axis=1).max()


def codes(placed):
    return {n.code for n in placed.notices}


def test_onto_six_points(flight):
    placed = georeference(flight.free, flight.photos, Given(control=(control(flight),)))
    assert error(flight, placed) < 0.5
    assert placed.block.points.ids[-6:] == NAMES
    assert placed.marked.sum() == 6


def test_control_in_one_place_is_refused_with_the_points(flight):
    one = np.tile(flight.xyz[0], (6, 1))
    with pytest.raises(InputError, match=r"control\.csv: all 6 control points have the same coordinates .*A, B, C, D"):
        check_apart(Given(control=(control(flight, one),)))
    plan = one.copy()
    plan[::2, 2] = np.nan
    with pytest.raises(InputError, match="was a line copied"):
        check_apart(Given(control=(control(flight, plan),)))
    apart = one.copy()
    apart[4, 1] += 0.001
    for xyz in (apart, flight.xyz, np.where(np.arange(6)[:, None] == 2, one, np.nan)):
        check_apart(Given(control=(control(flight, xyz),)))


def test_a_wrong_control_point_does_not_bend_the_start(flight):
    xyz = flight.xyz.copy()
    xyz[2, 0] += 40
    placed = georeference(flight.free, flight.photos, Given(control=(control(flight, xyz),), sigma_given=True))
    assert error(flight, placed) < 0.5


@pytest.mark.parametrize(("factor", "words"), [(1000, "in mm"), (100, "in cm"), (3.2808, "in feet"), (0.4, "names of")])
def test_a_bar_of_another_unit_beside_control_is_named_and_left_out(flight, factor, words):
    lengths = [float(np.linalg.norm(flight.xyz[0] - flight.xyz[k])) for k in (2, 3)]
    bars = (
        ScaleBar(start="A", end="C", length=factor * lengths[0], sigma=0.01),
        ScaleBar(start="A", end="D", length=lengths[1], sigma=0.01),
    )
    placed = georeference(flight.free, flight.photos, Given(control=(control(flight),), scale_bars=bars))
    (notice,) = [n for n in placed.notices if n.code == "distance_suspect"]
    assert (notice.ids, notice.severity) == (("A", "C"), "fault")
    assert words in notice.message
    assert placed.block.distances.length.tolist() == [lengths[1]]


def relief(flight):
    """The flight's control, with the block that has it on towers of up to a tenth of the extent, in its own frame."""
    rng = np.random.default_rng(4)
    given = flight.xyz + np.ptp(flight.xyz[:, 0]) * 0.1 * rng.uniform(0, 1, (6, 1)) * [0, 0, 1]
    names = tuple(f"{k}" for k in range(6))
    points = Points(ids=names, role=np.full(6, Role.CONTROL, np.int32), xyz=given, sigma=np.full((6, 3), 0.01))
    turned = 0.02 * (given + rng.normal(0, 0.01, (6, 3))) @ rotation_from_angles(np.array([0.4, -0.3, 2.0])).T
    return replace(flight.free, points=points), turned


@pytest.mark.parametrize(
    "wrong",
    [
        lambda x: x[:, [1, 0, 2]], lambda x: x[:, [0, 2, 1]], lambda x: x * [-1, 1, 1], lambda x: x * [1, 1, -1],
        lambda x: -x,
    ],
    ids=["XY", "YZ", "-X", "-Z", "all"],
)  # fmt: skip
def test_control_of_the_other_hand_is_named(flight, wrong):
    block, free = relief(flight)
    other = replace(block, points=replace(block.points, xyz=wrong(block.points.xyz)))
    (notice,) = mirrored_notices(other, free)
    assert (notice.code, notice.severity) == ("control_mirrored", "fault")
    assert notice.ids == block.points.ids
    assert "m as given, and to 0.0" in notice.message


def test_control_of_the_right_hand_is_no_mirror_image_whatever_is_wrong(flight):
    block, free = relief(flight)
    assert not mirrored_notices(block, free)
    cyclic = replace(block, points=replace(block.points, xyz=block.points.xyz[:, [1, 2, 0]]))
    assert not mirrored_notices(cyclic, free)
    for k in range(6):
        for axis in range(3):
            xyz = block.points.xyz.copy()
            xyz[k, axis] += 0.3 * np.ptp(xyz[:, 0])
            assert not mirrored_notices(replace(block, points=replace(block.points, xyz=xyz)), free)
    rng = np.random.default_rng(2)
    flat = block.points.xyz * [1, 1, 0] + [0, 0, 5.0]
    for _ in range(20):
        noisy = flat + rng.normal(0, 0.05, flat.shape)
        assert not mirrored_notices(replace(block, points=replace(block.points, xyz=noisy)), flat)


def test_only_standard_deviations_that_are_assumed_follow_the_fit(flight):
    xyz = flight.xyz + np.random.default_rng(3).normal(0, 0.5, (6, 3))
    assumed = control(flight, xyz)
    placed = georeference(flight.free, flight.photos, Given(control=(assumed,)))
    assert "control_sigma" in codes(placed)
    assert placed.block.points.sigma[-6:, :2].min() > 0.1
    # the same figures, but they stand in the file, though they are those of the program as well
    stated = replace(assumed, stated=np.ones(6, bool))
    placed = georeference(flight.free, flight.photos, Given(control=(stated,)))
    assert "control_sigma" not in codes(placed)
    np.testing.assert_array_equal(placed.block.points.sigma[-6:, :2], 0.01)


def test_a_wrong_mark_is_named_with_the_point_that_stands_there(flight):
    marks = flight.marks
    mine = np.flatnonzero(np.array(marks.image) == marks.image[int(np.flatnonzero(marks.point == 4)[0])])
    a = mine[marks.point[mine] == 4][0]
    others = mine[marks.point[mine] != 4]
    xy = marks.xy_px.copy()
    xy[a] = xy[others[0]] if len(others) else xy[a] + 200
    wrong = replace(marks, xy_px=xy)
    placed = georeference(flight.free, flight.photos, Given(control=(control(flight, marks=wrong),)))
    (notice,) = [n for n in placed.notices if n.code == "mark_rejected"]
    assert notice.ids == ("E", marks.image[a])
    if len(others):
        assert NAMES[marks.point[others[0]]] in notice.message
    assert error(flight, placed) < 0.5


def test_plan_control_levels_by_the_view(flight):
    xyz = flight.xyz.copy()
    xyz[:, 2] = np.nan
    placed = georeference(flight.free, flight.photos, Given(control=(control(flight, xyz),)))
    assert "levelled" in codes(placed)
    plan = placed.block.images.centre - flight.truth.images.centre
    assert np.abs(plan[:, :2]).max() < 0.1 * np.ptp(flight.truth.points.xyz[:, :2], axis=0).max()


def test_one_point_is_too_little(flight):
    xyz = np.full_like(flight.xyz, np.nan)
    xyz[0] = flight.xyz[0]
    with pytest.raises(InputError, match="at least 2 are needed"):
        georeference(flight.free, flight.photos, Given(control=(control(flight, xyz),)))


def marked_as(flight, rays):
    """The marks of the control points, each in so many photographs that look at it from different sides."""
    m = flight.marks
    keep = []
    for k, count in enumerate(rays):
        mine = np.flatnonzero(m.point == k)
        keep += mine[np.linspace(0, len(mine) - 1, count).astype(int)].tolist()
    return replace(
        m, image=tuple(m.image[k] for k in keep), point=m.point[keep], xy_px=m.xy_px[keep], line=m.line[keep]
    )


@pytest.mark.parametrize("rays", [(2, 2, 1, 0, 0, 0), (2, 2, 1, 1, 1, 0), (2, 1, 1, 1, 0, 0), (1, 1, 1, 1, 1, 1)])
def test_points_that_one_photograph_shows_place_the_block_as_well(flight, rays):
    """Obliques of the same ground are no aerial set by their looks: the level by the view would be wrong by far."""
    placed = georeference(flight.free, flight.photos, Given(control=(control(flight, marks=marked_as(flight, rays)),)))
    assert placed.fixed
    assert error(flight, placed) < 1.0  # of a flight at 1000 m
    turn = np.einsum("nij,nkj->nik", placed.block.images.rotation, flight.truth.images.rotation)
    assert np.degrees(np.arccos((np.trace(turn, axis1=1, axis2=2) - 1) / 2)).max() < 0.1


def test_a_wrong_point_among_those_seen_once_does_not_bend_the_start(flight):
    xyz = flight.xyz.copy()
    xyz[4] += [0.0, 300.0, 0.0]
    marks = marked_as(flight, (2, 2, 1, 1, 1, 1))
    placed = georeference(flight.free, flight.photos, Given(control=(control(flight, xyz, marks),)))
    assert error(flight, placed) < 1.0


def test_a_scale_bar_gives_the_scale(flight):
    length = float(np.linalg.norm(flight.xyz[0] - flight.xyz[2]))
    nothing = control(flight, np.full_like(flight.xyz, np.nan))
    bar = ScaleBar(start="A", end="C", length=length, sigma=0.001)
    placed = georeference(flight.free, flight.photos, Given(control=(nothing,), scale_bars=(bar,)))
    base = np.linalg.norm(placed.block.images.centre[0] - placed.block.images.centre[-1])
    true = np.linalg.norm(flight.truth.images.centre[0] - flight.truth.images.centre[-1])
    assert base == pytest.approx(true, rel=1e-3)
    assert set(placed.block.points.role[-6:]) == {Role.TIE}
    with pytest.raises(InputError, match="point Q is not measured"):
        georeference(flight.free, flight.photos, Given(control=(nothing,), scale_bars=(replace(bar, end="Q"),)))


@pytest.mark.parametrize(
    ("length", "sigma", "words"),
    [(-24.0, 0.01, "length of -24 m is no distance"), (0.0, 0.01, "is no distance"), (24.0, -0.01, "must be above 0")],
)
def test_a_bar_that_is_no_distance_is_refused_in_words_of_its_own(length, sigma, words):
    with pytest.raises(InputError, match=f"scale bar A - B: .*{words}"):
        ScaleBar(start="A", end="B", length=length, sigma=sigma)


def measured_only(flight, marks=None):
    """The six points with the role tie: marked, and nothing given."""
    file = control(flight, np.full_like(flight.xyz, np.nan), marks)
    return replace(file, role=np.full(6, Role.TIE, np.int32))


def with_bar(flight, marks=None):
    length = float(np.linalg.norm(flight.xyz[0] - flight.xyz[2]))
    bar = ScaleBar(start="A", end="C", length=length, sigma=0.001)
    given = Given(control=(measured_only(flight, marks),), scale_bars=(bar,))
    placed = georeference(flight.free, flight.photos, given)
    return final_adjustment(placed, (), 1, silent, (), "stated")


def test_marked_points_of_which_nothing_is_given_end_as_object_points(flight):
    result = with_bar(flight)
    assert not {"parallel_rays", "marked_lost", "mark_rejected"} & {n.code for n in result.notices}
    rows = np.array([result.adjusted.points.ids.index(n) for n in NAMES])
    found = result.adjusted.points.xyz[rows]
    sigma = np.sqrt(np.einsum("nii->ni", result.precision.object_points[rows]))
    assert (sigma > 0).all()
    moved = similarity(found, flight.xyz)
    apart = moved.scale * found @ moved.rotation.T + moved.translation - flight.xyz
    assert (np.abs(apart) < 5 * sigma).all()


def test_a_wrong_mark_on_the_end_of_a_bar_is_named(flight):
    end = int(np.flatnonzero(flight.marks.point == 0)[0])
    xy = flight.marks.xy_px.copy()
    xy[end] += [9.0, -8.0]  # below what is gross beyond doubt: data snooping finds it
    told = [n for n in with_bar(flight, replace(flight.marks, xy_px=xy)).notices if n.code == "mark_rejected"]
    assert [n.ids for n in told] == [("A", flight.marks.image[end])]


def test_a_marked_point_whose_rays_do_not_meet_is_lost_by_name(flight):
    rows = np.flatnonzero(flight.marks.point == 1)
    keep = np.ones(len(flight.marks.point), bool)
    keep[rows[2:]] = False
    xy = flight.marks.xy_px.copy()
    xy[rows[1]] += [0.0, -600.0]
    marks = Measurements(
        image=tuple(n for n, k in zip(flight.marks.image, keep, strict=True) if k), point=flight.marks.point[keep],
        xy_px=xy[keep], line=flight.marks.line[keep],
    )  # fmt: skip
    assert [n.ids for n in with_bar(flight, marks).notices if n.code == "marked_lost"] == [("B",)]


def test_a_mark_outside_the_photograph_is_an_error_with_its_line(flight):
    xy = flight.marks.xy_px.copy()
    xy[3] = 1e6, 5
    with pytest.raises(InputError, match=r"control\.csv, line 5"):
        georeference(
            flight.free, flight.photos, Given(control=(control(flight, marks=replace(flight.marks, xy_px=xy)),))
        )


CRS = "EPSG:4979"
PLACE = (8.0, 50.0, 200.0)


def with_gps(flight, noise=0.02, shift=(0.0, 0.0, 0.0), pause=None):
    """The photographs with RTK positions; after number `pause` half an hour goes by and the shift changes its sign."""
    rng = np.random.default_rng(1)
    place = LocalPlace(origin=PLACE)
    second = np.arange(len(flight.photos)) >= (len(flight.photos) if pause is None else pause)
    moved = flight.truth.images.centre + np.where(second[:, None], -1, 1) * np.array(shift)
    photos = []
    for k, (photo, at) in enumerate(zip(flight.photos, moved + rng.normal(0, noise, moved.shape), strict=True)):
        lon, lat, h = place.geographic_from_local(at[None])[0]
        gps = SimpleNamespace(
            latitude_deg=lat, longitude_deg=lon, altitude_m=h, sigma_m=(noise, noise, noise), fix="rtk fixed"
        )
        taken = datetime(2026, 5, 1, 10, tzinfo=UTC) + timedelta(seconds=2 * k + 1800 * bool(second[k]))
        metadata = SimpleNamespace(**{**vars(photo.metadata), "gps": gps, "taken": taken})
        photos.append(SimpleNamespace(**{**vars(photo), "metadata": metadata}))
    return photos


def in_degrees(flight, chosen):
    """Control in longitude, latitude, height; the others are measured only."""
    xyz = np.full_like(flight.xyz, np.nan)
    xyz[chosen] = LocalPlace(origin=PLACE).geographic_from_local(flight.xyz[chosen])
    return replace(control(flight, xyz), crs=CRS)


def adjusted(placed):
    return adjust_block(placed.block, AdjustmentOptions())


def test_gps_places_the_block(flight):
    placed = georeference(flight.free, with_gps(flight), Given())
    assert placed.frame is not None
    assert "gps" in codes(placed)
    assert not any(c.model == "antenna" for c in placed.block.cameras)
    base = np.linalg.norm(placed.block.images.centre[0] - placed.block.images.centre[-1])
    true = np.linalg.norm(flight.truth.images.centre[0] - flight.truth.images.centre[-1])
    assert base == pytest.approx(true, rel=1e-3)


def test_one_control_point_suffices_beside_positions_and_finds_their_shift(flight):
    shift = np.array([0.8, -0.5, 1.7])
    photos = with_gps(flight, shift=shift)
    placed = georeference(flight.free, photos, Given(control=(in_degrees(flight, [0]),)))
    assert placed.block.cameras[-1].estimate == ("sx", "sy", "sz")
    result = adjusted(placed)
    antenna = next(r for r in result.interior if r.camera == "gnss")
    for s, true in zip(("sx", "sy", "sz"), shift, strict=True):
        p = antenna.parameters[s]
        assert abs(p.value - true) < 4 * p.std
        assert p.std < 0.2
    local = placed.frame.local_from_wgs84(LocalPlace(origin=PLACE).geographic_from_local(flight.truth.images.centre))
    apart = result.adjusted.images.centre - local
    assert np.all(np.abs(apart) < 5 * result.precision.image_std[:, :3])


def test_every_flight_has_its_shift(flight):
    photos = with_gps(flight, shift=(0.3, 0.2, 0.5), pause=10)
    placed = georeference(flight.free, photos, Given(control=(in_degrees(flight, [0, 1, 2, 3]),)))
    result = adjusted(placed)
    found = {r.camera: r.parameters["sz"] for r in result.interior if r.camera.startswith("gnss")}
    assert set(found) == {"gnss-1", "gnss-2"}
    for name, true in (("gnss-1", 0.5), ("gnss-2", -0.5)):
        assert abs(found[name].value - true) < 4 * found[name].std
    without = georeference(flight.free, photos, Given(control=(in_degrees(flight, [0, 1, 2, 3]),), shift=False))
    assert without.block.stations.antenna is None


def part_of(block, mine):
    """The block with these images (n,) oriented alone."""
    images = replace(
        block.images,
        centre=np.where(mine[:, None], block.images.centre, np.nan),
        rotation=np.where(mine[:, None, None], block.images.rotation, np.nan),
    )
    o = block.observations
    rays = np.bincount(o.point[mine[o.image]], minlength=len(block.points))
    thin = with_rows(block, mine[o.image] & (rays > 1)[o.point])
    return replace(thin, images=images)


def test_parts_of_two_flights_keep_their_antennas(flight):
    photos = with_gps(flight, shift=(0.3, 0.2, 0.5), pause=10)
    first = np.arange(len(photos)) < 10
    blocks = (part_of(flight.free, first), part_of(flight.free, ~first))
    given = Given(control=(in_degrees(flight, [0, 1, 2, 3, 4, 5]),))
    whole, apart = place_parts(blocks, photos, given)
    assert not apart
    stations = whole.block.stations
    names = [whole.block.cameras[a].id for a in stations.antenna.tolist()]
    assert names == ["gnss-1" if first[i] else "gnss-2" for i in stations.image.tolist()]
    alone, _ = place_parts(blocks[:1], photos, given)
    assert [c.id for c in alone.block.cameras if c.model == "antenna"] == ["gnss-1"]


def test_a_lever_arm_is_held_or_observed(flight):
    given = Given(lever_arm=((0.1, -0.05, 0.3), 0.0))
    (held,) = [c for c in georeference(flight.free, with_gps(flight), given).block.cameras if c.id == "gnss"]
    assert held.estimate == ()
    assert held.values["az"] == 0.3
    given = replace(given, lever_arm=((0.1, -0.05, 0.3), 0.02))
    (observed,) = [c for c in georeference(flight.free, with_gps(flight), given).block.cameras if c.id == "gnss"]
    assert observed.sigma == {"ax": 0.02, "ay": 0.02, "az": 0.02}


def test_positions_too_near_each_other_are_not_used(flight):
    extent = np.ptp(flight.truth.images.centre, axis=0).max()
    placed = georeference(flight.free, with_gps(flight, noise=float(extent)), Given())
    assert "gps_too_near" in codes(placed)
    assert placed.frame is None
    assert len(placed.block.stations) == 0


def test_a_check_point_without_marks_is_said_and_left_out(flight):
    keep = flight.marks.point != 5
    marks = Measurements(
        image=tuple(n for n, k in zip(flight.marks.image, keep, strict=True) if k), point=flight.marks.point[keep],
        xy_px=flight.marks.xy_px[keep], line=flight.marks.line[keep],
    )  # fmt: skip
    file = control(flight, marks=marks)
    role = file.role.copy()
    role[4:] = Role.CHECK
    placed = georeference(flight.free, flight.photos, Given(control=(replace(file, role=role),)))
    assert placed.block.points.ids[-5:] == NAMES[:5]
    assert len(placed.marked) == len(placed.block.points)
    (told,) = [n for n in placed.notices if n.code == "check_unseen"]
    assert told.ids == ("F",)


def vertical_in(placed, truth):
    """Angle between Z of a placed block and the true vertical [deg]."""
    both = sum(a.T @ b for a, b in zip(placed.block.images.rotation, truth.images.rotation, strict=True))
    u, _, v = np.linalg.svd(both)
    return float(np.degrees(np.arccos(np.clip((u @ v)[2, 2], -1, 1))))


def test_a_free_flight_is_aerial_and_level(flight):
    placed = georeference(flight.free, flight.photos, Given())
    assert placed.upright.kind == "aerial"
    assert placed.upright.probability > 0.95
    assert vertical_in(placed, flight.truth) < 3
    assert not {"up_ambiguous", "up_uncertain"} & codes(placed)


def test_two_points_say_which_way_is_up(flight):
    nothing = control(flight, np.full_like(flight.xyz, np.nan))
    placed = georeference(flight.free, flight.photos, Given(control=(nothing,), up="A,B"))
    assert placed.upright.kind == "given"
    names = placed.block.points.ids
    a, b = (placed.block.points.xyz[names.index(n)] for n in "AB")
    away = (b - a) / np.linalg.norm(b - a)
    np.testing.assert_allclose(away, [0, 0, 1], atol=1e-9)
    with pytest.raises(InputError, match="point Q has no place"):
        georeference(flight.free, flight.photos, Given(control=(nothing,), up="A,Q"))
    with pytest.raises(InputError, match="--up sideways"):
        georeference(flight.free, flight.photos, Given(up="sideways"))


def test_few_photographs_are_called_ambiguous(flight):
    images = flight.free.images
    centre, rotation = images.centre.copy(), images.rotation.copy()
    centre[2:], rotation[2:] = np.nan, np.nan
    two = replace(flight.free, images=replace(images, centre=centre, rotation=rotation))
    placed = georeference(two, flight.photos, Given())
    assert "up_ambiguous" in codes(placed)


def test_heights_that_nobody_measured_are_neither_compared_nor_called_given(flight, tmp_path):
    """Four control points of plan, two check points of plan, as from lists whose heights are all 0."""
    xyz = flight.xyz.copy()
    xyz[:, 2] = np.nan
    file = control(flight, xyz)
    role = file.role.copy()
    role[4:] = Role.CHECK
    placed = georeference(flight.free, flight.photos, Given(control=(replace(file, role=role),)))
    done = replace(adjust_block(placed.block, AdjustmentOptions(threads=1)), notices=placed.notices)
    rows, difference = check_differences(done)
    assert len(rows) == 2
    assert np.isfinite(difference[:, :2]).all()
    assert not np.isfinite(difference[:, 2]).any()
    assert "rmse_v" not in accuracy(done)["asprs"] or accuracy(done)["asprs"]["rmse_v"] is None
    write_result(done, tmp_path / "r")
    given = (tmp_path / "r/control.csv").read_text().splitlines()
    column = given[0].split(",").index("Z")
    assert {line.split(",")[column] for line in given[1:]} == {""}
    check = (tmp_path / "r/check.csv").read_text().splitlines()
    assert {line.split(",")[check[0].split(",").index("Z")] for line in check[1:]} == {""}
    assert " Z " not in "".join(line for line in summary_lines(done) if "check point" in line)


def test_the_report_has_leave_one_out_and_asprs_figures(flight, tmp_path):
    file = control(flight)
    role = file.role.copy()
    role[4:] = Role.CHECK
    placed = georeference(flight.free, flight.photos, Given(control=(replace(file, role=role),), sigma_given=True))
    done = replace(adjust_block(placed.block, AdjustmentOptions(threads=1)), notices=placed.notices)
    write_result(done, tmp_path / "r", report="html")
    page = (tmp_path / "r/report.html").read_text()
    assert "Accuracy in the sense of ASPRS (2023)" in page
    assert "RMSE_H" in page
    assert "At least 30 are asked for there" in page
    assert "Control left out, one coordinate at a time" in page
    left = accuracy(done)["leave_one_out"]
    assert {t["coordinate"] for t in left} == {"X", "Y", "Z"}
    # to first order that is what the adjustment without that coordinate says
    one = left[0]
    k = placed.block.points.ids.index(one["point"])
    sigma = placed.block.points.sigma.copy()
    sigma[k, "XYZ".index(one["coordinate"])] = np.nan
    without = adjust_block(
        replace(placed.block, points=replace(placed.block.points, sigma=sigma)), AdjustmentOptions(threads=1)
    )
    axis = "XYZ".index(one["coordinate"])
    d = without.adjusted.points.xyz[k, axis] - placed.block.points.xyz[k, axis]
    assert one["difference"] == pytest.approx(d, rel=0.02, abs=1e-5)


def test_a_robust_similarity_passes_over_triples_in_one_line():
    """Two photographs that state one position, as a receiver without a new fix writes it."""
    from raybundle.workflows.georeference import _robust

    rng = np.random.default_rng(4)
    source = rng.normal(0, 10, (6, 3))
    target = 2 * source + 5.0
    target[1] = target[0]
    scale, R, t = _robust(source, target, 3)
    assert scale == pytest.approx(2.0, rel=0.2)
    assert np.isfinite(R).all()
    assert np.isfinite(t).all()


@pytest.mark.parametrize("pair", [(0, 2), (1, 5), (3, 4)])
def test_exchanged_names_of_control_are_named_and_take_no_part(flight, pair):
    xyz = flight.xyz.copy()
    xyz[list(pair)] = flight.xyz[list(pair[::-1])]
    placed = georeference(flight.free, flight.photos, Given(control=(control(flight, xyz),), sigma_given=True))
    (notice,) = [n for n in placed.notices if n.code == "control_exchanged"]
    names = tuple(NAMES[k] for k in pair)
    assert (notice.ids, notice.severity) == (names, "fault")
    assert f"control points {names[0]} and {names[1]} seem to be exchanged" in notice.message
    assert error(flight, placed) < 0.5
    left = placed.block.points
    assert {n for n, c in zip(left.ids, left.is_control.any(axis=1), strict=True) if c} == set(NAMES) - set(names)
    assert placed.marked.sum() == 6


@pytest.mark.parametrize(("given", "factor"), [(1.0, 1000.0), (1000.0, 0.001)])
def test_a_point_of_another_unit_is_named_and_takes_no_part(flight, given, factor):
    xyz = given * flight.xyz
    xyz[3] *= factor
    placed = georeference(
        flight.free, flight.photos, Given(control=(control(flight, xyz, sigma=0.01 * given),), sigma_given=True)
    )
    (notice,) = [n for n in placed.notices if n.code == "control_unit"]
    assert notice.ids == ("D",)
    assert ("millimetres among metres" if factor > 1 else "metres among millimetres") in notice.message
    centre = placed.block.images.centre / given
    assert np.linalg.norm(centre - flight.truth.images.centre, axis=1).max() < 0.5


def test_nothing_else_looks_exchanged_or_in_another_unit(flight):
    """Right control, scattered control, and every single or double error that is no exchange."""
    rng = np.random.default_rng(8)
    free = flight.xyz @ rotation_from_angles(np.array([0.4, -0.3, 2.0])).T
    for noise in (0.0, 0.01, 1.0):
        for _ in range(40):
            seen = free + rng.normal(0, 0.01, free.shape)
            xyz = flight.xyz + rng.normal(0, 1, free.shape) * noise
            assert misread(seen, xyz, units=True) is None
            wrong = rng.choice(6, int(rng.integers(1, 3)), replace=False)
            xyz[wrong] += rng.normal(0, 0.3 * np.ptp(flight.xyz[:, 0]), (len(wrong), 3))
            assert misread(seen, xyz, units=True) is None


def test_few_points_and_points_in_a_line_tell_no_exchange(flight):
    swapped = flight.xyz[[1, 0, 2, 3]]
    assert misread(flight.xyz[:4], swapped, units=True) is None
    line = np.arange(6.0)[:, None] * [1.0, 2.0, 0.5]
    assert misread(line, line[[1, 0, 2, 3, 4, 5]], units=True) is None


def test_exchanged_positions_of_two_photographs_are_named_and_not_used(flight):
    photos = with_gps(flight)
    a, b = photos[1].metadata.gps, photos[5].metadata.gps
    photos[1].metadata.gps, photos[5].metadata.gps = b, a
    placed = georeference(flight.free, photos, Given())
    (notice,) = [n for n in placed.notices if n.code == "positions_exchanged"]
    ids = flight.free.images.ids
    assert (notice.ids, notice.severity) == ((ids[1], ids[5]), "fault")
    assert placed.fixed
    assert not {1, 5} & set(placed.block.stations.image.tolist())
    assert "positions_exchanged" not in codes(georeference(flight.free, with_gps(flight), Given()))


def test_control_of_the_other_hand_takes_no_part(flight):
    block, free = relief(flight)
    assert mirrored_notices(replace(block, points=replace(block.points, xyz=-block.points.xyz)), free)
    left = without_control(replace(block, points=replace(block.points, xyz=-block.points.xyz)))
    assert not left.points.is_control.any()
    assert not left.points.is_check.any()
    assert left.points.ids == block.points.ids
