"""Onto control, robustly: blunders are named, heights that are not known are said."""

from dataclasses import replace
from itertools import permutations

import numpy as np
import pytest

from raybundle.adjustment.blunders.accuracy import Accuracy
from raybundle.adjustment.engine import adjust_block
from raybundle.adjustment.evaluation.check_points import check_differences
from raybundle.adjustment.records.options import AdjustmentOptions
from raybundle.block import Role
from raybundle.errors import InputError
from raybundle.io.geo.control_files import Measurements
from raybundle.numerics.progress import silent
from raybundle.numerics.transform import similarity
from raybundle.placing.control_at_one_place import check_apart
from raybundle.placing.georeference import georeference
from raybundle.placing.marks import Given, ScaleBar
from raybundle.report.text.summary import details
from raybundle.report.write import write_result
from raybundle.words import headline
from raybundle.workflows.final_adjustment import final_adjustment
from tests.messages import refused
from tests.workflows.free_flight import NAMES, codes, control, error, flight

__all__ = ["flight"]


def test_onto_six_points(flight):
    placed = georeference(flight.free, flight.photos, Given(control=(control(flight),)))
    assert error(flight, placed) < 0.5
    assert placed.block.points.ids[-6:] == NAMES
    assert placed.marked.sum() == 6


def test_control_in_one_place_is_refused_with_the_points(flight):
    one = np.tile(flight.xyz[0], (6, 1))
    with refused("control.one_place", file="control.csv", n=6, names=list(NAMES)):
        check_apart(Given(control=(control(flight, one),)))
    plan = one.copy()
    plan[::2, 2] = np.nan
    with pytest.raises(InputError, match=r"control\.one_place"):
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


@pytest.mark.parametrize(("factor", "unit"), [(1000, "mm"), (100, "cm"), (3.2808, "feet"), (0.4, "")])
def test_a_bar_of_another_unit_beside_control_is_named_and_left_out(flight, factor, unit):
    lengths = [float(np.linalg.norm(flight.xyz[0] - flight.xyz[k])) for k in (2, 3)]
    bars = (
        ScaleBar(start="A", end="C", length=factor * lengths[0], sigma=0.01),
        ScaleBar(start="A", end="D", length=lengths[1], sigma=0.01),
    )
    placed = georeference(flight.free, flight.photos, Given(control=(control(flight),), scale_bars=bars))
    (notice,) = [n for n in placed.notices if n.code == "distance_suspect"]
    assert (notice.ids, notice.severity) == (("A", "C"), "fault")
    assert notice.values["likely"] == unit
    assert notice.values["ratio"] == pytest.approx(factor, rel=0.02)
    assert placed.block.distances.length.tolist() == [lengths[1]]


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
        assert (notice.values["hint"], notice.values["other"]) == ("same_place", NAMES[marks.point[others[0]]])
    assert error(flight, placed) < 0.5


def test_a_mark_under_another_name_is_told_with_the_point_that_is_there(flight):
    """The only mark of a board in a photograph bears the name of another board, which is seen elsewhere."""
    marks, image = flight.marks, np.array(flight.marks.image)
    here = next(
        (a, b)
        for name in dict.fromkeys(image)
        for a, b in permutations(np.flatnonzero(image == name), 2)
        if (marks.point == marks.point[b]).sum() > 2 and (marks.point == marks.point[a]).sum() > 3
    )
    a, b = here  # b's place is given for a, and b is not marked there at all
    xy = marks.xy_px.copy()
    xy[a] = xy[b]
    wrong = replace(marks, xy_px=xy).rows(np.delete(np.arange(len(image)), b))
    placed = georeference(flight.free, flight.photos, Given(control=(control(flight, marks=wrong),)))
    (notice,) = [n for n in placed.notices if n.code == "mark_rejected"]
    assert notice.ids == (NAMES[marks.point[a]], image[a])
    assert (notice.values["hint"], notice.values["other"]) == ("near", NAMES[marks.point[b]])
    assert 0 < notice.values["other_px"] < 15


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
    with pytest.raises(InputError, match=r"2.*control\.too_few_measured"):
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
    with refused("scale_bar.end_not_measured", point="Q"):
        georeference(flight.free, flight.photos, Given(control=(nothing,), scale_bars=(replace(bar, end="Q"),)))


@pytest.mark.parametrize(
    ("length", "sigma", "words"),
    [(-24.0, 0.01, r"-24 m.*scale_bar\.length"), (0.0, 0.01, r"scale_bar\.length"), (24.0, -0.01, r"scale_bar\.sigma")],
)
def test_a_bar_that_is_no_distance_is_refused_in_words_of_its_own(length, sigma, words):
    with pytest.raises(InputError, match=f"Scale bar A - B: .*{words}"):
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
    with pytest.raises(InputError, match=r"control\.csv.*5.*mark\.outside_photograph"):
        georeference(
            flight.free, flight.photos, Given(control=(control(flight, marks=replace(flight.marks, xy_px=xy)),))
        )


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
    with refused("vertical.point_without_place", point="Q"):
        georeference(flight.free, flight.photos, Given(control=(nothing,), up="A,Q"))
    with pytest.raises(InputError, match=r"sideways.*vertical\.unknown_way"):
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
    done = replace(adjust_block(placed.block, AdjustmentOptions(jobs=1)), notices=placed.notices)
    rows, difference = check_differences(done)
    assert len(rows) == 2
    assert np.isfinite(difference[:, :2]).all()
    assert not np.isfinite(difference[:, 2]).any()
    assert Accuracy(done).as_mapping()["asprs"]["rmse_v"] is None
    write_result(done, tmp_path / "r")
    given = (tmp_path / "r/control.csv").read_text().splitlines()
    column = given[0].split(",").index("Z")
    assert {line.split(",")[column] for line in given[1:]} == {""}
    check = (tmp_path / "r/check.csv").read_text().splitlines()
    assert {line.split(",")[check[0].split(",").index("Z")] for line in check[1:]} == {""}
    (found,) = [m.values for m in details(done) if m.code == "summary.check_points"]
    assert found["axes"] == ["X", "Y"]


def test_the_report_has_leave_one_out_and_asprs_figures(flight, tmp_path):
    file = control(flight)
    role = file.role.copy()
    role[4:] = Role.CHECK
    placed = georeference(flight.free, flight.photos, Given(control=(replace(file, role=role),), sigma_given=True))
    done = replace(adjust_block(placed.block, AdjustmentOptions(jobs=1)), notices=placed.notices)
    write_result(done, tmp_path / "r", report="html")
    page = (tmp_path / "r/report.html").read_text()
    assert headline("report_control.asprs", {}) in page
    assert "RMSE_H" in page
    assert headline("report_control.check_points_needed", {"least": 30}) in page
    assert headline("report_control.coordinates_left_out", {}) in page
    left = Accuracy(done).as_mapping()["leave_one_out"]
    assert {t["coordinate"] for t in left} == {"X", "Y", "Z"}
    # to first order that is what the adjustment without that coordinate says
    one = left[0]
    k = placed.block.points.ids.index(one["point"])
    sigma = placed.block.points.sigma.copy()
    sigma[k, "XYZ".index(one["coordinate"])] = np.nan
    without = adjust_block(
        replace(placed.block, points=replace(placed.block.points, sigma=sigma)), AdjustmentOptions(jobs=1)
    )
    axis = "XYZ".index(one["coordinate"])
    d = without.adjusted.points.xyz[k, axis] - placed.block.points.xyz[k, axis]
    assert one["difference"] == pytest.approx(d, rel=0.02, abs=1e-5)


def test_a_robust_similarity_passes_over_triples_in_one_line():
    """Two photographs that state one position, as a receiver without a new fix writes it."""
    from raybundle.placing.georeference import _robust

    rng = np.random.default_rng(4)
    source = rng.normal(0, 10, (6, 3))
    target = 2 * source + 5.0
    target[1] = target[0]
    scale, R, t = _robust(source, target, 3)
    assert scale == pytest.approx(2.0, rel=0.2)
    assert np.isfinite(R).all()
    assert np.isfinite(t).all()
