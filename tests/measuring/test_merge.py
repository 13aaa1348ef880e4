"""Block and state make a block: adjusted as if all had been measured at once, exported and read again."""

from dataclasses import replace

import numpy as np
import pytest
from scipy.stats import chi2

from raybundle.block import Role
from raybundle.block.frames import file_from_camera, stored_turned
from raybundle.block.select import with_rows
from raybundle.block.transform import transform_block
from raybundle.errors import InputError, phrase
from raybundle.io.block.folder import read_block
from raybundle.io.geo.control_files import read_control
from raybundle.measuring.actions.verbs import Point, Put, Reject, Rename, SetBar, SetDatum, SetLine
from raybundle.measuring.axes import by_level
from raybundle.measuring.export import lost_in_csv, lost_in_gcp_list, write_csv, write_gcp_list, write_merged_block
from raybundle.measuring.merge import merge
from raybundle.measuring.names import Known
from raybundle.measuring.predict import predict
from raybundle.measuring.session import Session
from raybundle.measuring.state import EMPTY, folded
from raybundle.numerics.rotation import rotation_from_vector
from raybundle.numerics.transform import SimilarityTransform
from raybundle.observations.alignment import PlumbLines
from raybundle.workflows.adjust import adjust

from .scenes import simulation, small_block

SIGMA = 0.3
COV = (SIGMA**2, SIGMA**2, 0.0)


def some_points(block, count, least=4):
    return [int(p) for p in np.flatnonzero((block.ray_count >= least) & (np.asarray(block.points.role) == 0))][:count]


def rows_of(block, p):
    o = block.observations
    return [(block.images.ids[i], xy) for i, q, xy in zip(o.image, o.point, o.xy_px, strict=True) if q == p]


def puts(block, p, name):
    return [Put(image=i, point=name, x_px=x, y_px=y, covariance=COV) for i, (x, y) in rows_of(block, p)]


def without_points(block, points):
    return with_rows(block, ~np.isin(block.observations.point, points))


def free_block():
    """The small block without control, in a frame and scale of its own."""
    block = small_block()
    p = block.points
    free = replace(block, points=replace(p, role=np.zeros_like(p.role), sigma=np.full_like(p.sigma, np.nan)))
    return transform_block(
        free,
        SimilarityTransform(
            scale=0.37, rotation=rotation_from_vector(np.array([0.4, -1.1, 2.0])), translation=np.array([5.0, 6.0, 7.0])
        ),
        observed="stay",
    )


def test_nothing_measured_changes_nothing():
    block = small_block()
    assert merge(block, EMPTY).block is block or repr(merge(block, EMPTY).block) == repr(block)


def test_measured_by_hand_equals_measured_before():
    block = small_block()
    chosen = some_points(block, 3)
    rest = without_points(block, chosen)
    state = folded([a for p in chosen for a in puts(block, p, f"hand {p}")])
    whole, again = adjust(block), adjust(merge(rest, state).block)
    assert again.sigma0 == pytest.approx(whole.sigma0, rel=1e-9)
    for p in chosen:
        k = again.adjusted.points.ids.index(f"hand {p}")
        np.testing.assert_allclose(again.adjusted.points.xyz[k], whole.adjusted.points.xyz[p], atol=1e-8)
        np.testing.assert_allclose(
            again.precision.object_points[k], whole.precision.object_points[p], rtol=1e-5, atol=1e-12
        )


def test_a_mark_stands_in_place_of_the_row_and_of_its_rejection():
    block = small_block()
    p = some_points(block, 1)[0]
    (image, _), *_ = rows_of(block, p)
    name = block.points.ids[p]
    state = folded([Put(image=image, point=name, x_px=7.0, y_px=8.0, covariance=(1.0, 2.0, 0.5))])
    made = merge(replace(block, rejected=((image, name),)), state).block
    assert len(made.observations) == len(block.observations)
    assert made.rejected == ()
    np.testing.assert_allclose(made.observations.xy_px[-1], [7, 8])
    np.testing.assert_allclose(made.observations.cov_px2[-1], [1.0, 2.0, 0.5])


def test_free_block_is_brought_to_measured_control():
    block, truth = free_block(), simulation().truth
    chosen = some_points(small_block(), 5)
    actions = []
    for p in chosen:
        actions += puts(small_block(), p, block.points.ids[p])
        xyz = tuple(truth.points.xyz[p].tolist())
        actions.append(Point(point=block.points.ids[p], role="control", xyz=xyz, sigma=(0.002,) * 3))
    made = merge(block, folded(actions))
    assert not made.left_out
    result = adjust(made.block)
    assert 0.8 < result.sigma0 < 1.2
    assert not result.datum_defect
    assert np.nanmax(np.abs(result.adjusted.points.xyz - truth.points.xyz)) < 0.02


def test_a_bar_gives_a_free_block_its_scale():
    block, truth = replace(free_block(), free_scale=True), simulation().truth
    a, b = some_points(small_block(), 40)[::39]
    true = float(np.linalg.norm(truth.points.xyz[a] - truth.points.xyz[b]))
    names = block.points.ids[a], block.points.ids[b]
    made = merge(block, folded([SetBar(start=names[0], end=names[1], length=true, sigma=1e-4)])).block
    assert not made.free_scale
    result = adjust(made)
    found = result.adjusted.points.xyz
    c, d = some_points(small_block(), 40)[5:7]
    assert np.linalg.norm(found[c] - found[d]) == pytest.approx(
        float(np.linalg.norm(truth.points.xyz[c] - truth.points.xyz[d])), rel=2e-3
    )


def test_axes_by_points_are_held():
    block = free_block()
    names = [block.points.ids[p] for p in some_points(small_block(), 30)[::14]]
    result = adjust(merge(block, folded([SetDatum(origin=names[0], axis=names[1], plane=names[2])])).block)
    at = [block.points.ids.index(n) for n in names]
    xyz = result.adjusted.points.xyz[at]
    held = np.array([[True, True, True], [False, True, True], [False, False, True]])
    assert (xyz[held] == 0).all()
    assert xyz[1, 0] > 0
    assert xyz[2, 1] > 0
    assert len(result.datum_defect) == 1  # the scale, from the point where the axes are held
    assert (result.precision.object_point_std[at][held] == 0).all()
    with pytest.raises(InputError, match=r"axes\.contradicts_block"):
        merge(small_block(), folded([SetDatum(origin=names[0], axis=names[1], plane=names[2])]))
    upright = PlumbLines(figure=("a", "a"), point=np.array(at[:2], np.int32), sigma=np.full(2, 0.01))
    with pytest.raises(InputError, match=r"axes\.contradicts_block"):
        merge(block.having(upright), folded([SetDatum(origin=names[0], axis=names[1], plane=names[2])]))


def level_state(block, truth, bar_sigma=1e-4):
    """A level of three points, two of them origin and axis, and a length; with their numbers."""
    at = some_points(small_block(), 40)[::9][:5]
    n = [block.points.ids[p] for p in at]
    length = float(np.linalg.norm(truth[at[3]] - truth[at[4]]))
    state = folded([
        SetLine(line="water", points=tuple(n[:3]), kind="level", sigma=1e-4), SetDatum(origin=n[0], axis=n[1]),
        SetBar(start=n[3], end=n[4], length=length, sigma=bar_sigma),
    ])  # fmt: skip
    return state, at


def test_a_level_and_two_points_are_axes_with_true_standard_deviations():
    """Of a block that lies on its side; against the truth in the axes of the same points."""
    block, truth = replace(free_block(), free_scale=True), simulation().truth.points.xyz
    state, at = level_state(block, truth)
    result = adjust(merge(block, state).block)
    assert result.datum_defect == ()
    found, C = result.adjusted.points.xyz, result.precision.object_points
    assert (found[at[0]] == 0).all()
    assert found[at[1], 1] == 0
    assert found[at[1], 0] > 0
    up = np.cross(*(truth[at[1:3]] - truth[at[0]]))
    up /= np.linalg.norm(up)
    up = up if (found[at[4]] @ [0, 0, 1]) * ((truth[at[4]] - truth[at[0]]) @ up) > 0 else -up
    true = (truth - truth[at[0]]) @ by_level(truth[at[:3]][[0, 1, 0, 1, 2]], up).T
    free = [p for p in some_points(small_block(), 400) if p not in at[:2]]
    square = [(e := found[p] - true[p]) @ np.linalg.solve(C[p], e) for p in free]
    # points share the errors of the axes, so that their mean is wide; one block of many is told by the next test
    assert 0.2 < np.mean(square) / 3 < 5
    assert np.abs(found[free] - true[free]).max() < 0.02


def test_axes_and_level_of_many_blocks_are_in_the_band():
    square, freedom = 0.0, 0
    for seed in range(25):
        made = simulation(seed=100 + seed, stations=8)
        truth, observed = made.truth.points.xyz, made.observed
        p = observed.points
        bare = replace(p, role=np.zeros_like(p.role), sigma=np.full_like(p.sigma, np.nan))
        block = replace(observed, points=bare, free_scale=True)
        state, at = level_state(block, truth)
        result = adjust(merge(block, state).block)
        up = np.array([0.0, 0.0, 1.0])
        true = (truth - truth[at[0]]) @ by_level(truth[at[:3]][[0, 1, 0, 1, 2]], up).T
        e = (result.adjusted.points.xyz - true)[at[3]]
        square += float(e @ np.linalg.solve(result.precision.object_points[at[3]], e))
        freedom += 3
    low, high = chi2.ppf([0.0005, 0.9995], freedom)
    assert low < square < high


def test_two_points_are_no_axes_without_a_vertical():
    block = free_block()
    a, b = (block.points.ids[p] for p in some_points(small_block(), 2))
    with pytest.raises(InputError, match=r"axes\.no_vertical"):
        merge(block, folded([SetDatum(origin=a, axis=b)]))
    state = folded([SetLine(line="drop", points=(a, b), kind="plumb", sigma=1e-3), SetDatum(origin=a, axis=b)])
    with pytest.raises(InputError, match=r"axes\.vertical"):
        merge(block, state)


def test_lines_rejections_names_and_what_is_left_out():
    block = small_block()
    chosen = some_points(block, 4)
    names = [block.points.ids[p] for p in chosen]
    image, (x, y) = rows_of(block, chosen[0])[0]
    state = folded([
        Rename(point=names[0], to="gate", original=names[0]), Reject(image=image, point="gate"),
        SetLine(line="sill", points=("gate", *names[1:3]), sigma=0.01),
        SetLine(line="edge", points=(names[1], names[2]), kind="plumb", sigma=0.02),
        Put(image=image, point="once", x_px=x, y_px=y), SetBar(start="once", end="gate", length=1.0, sigma=0.1),
        Point(point="far", role="check", xyz=(1.0, 2.0, 3.0)),
    ])  # fmt: skip
    made = merge(block, state)
    assert made.block.points.ids[chosen[0]] == "gate"
    assert made.block.rejected == ((image, "gate"),)
    assert made.block.tables["lines"].figure == ("sill",) * 3
    assert made.block.tables["plumb_lines"].figure == ("edge",) * 2
    assert not len(made.block.distances)
    assert made.left_out == {
        "once": phrase("measuring.too_few_marks", n=1, oriented=False),
        "far": phrase("measuring.unmarked_point", role="check", oriented=False),
        "once-gate": phrase("measuring.point_left_out", point="once", cause=made.left_out["once"]),
    }
    assert "once" not in made.block.points.ids


def test_marks_are_in_the_pixels_of_turned_files():
    block = small_block()
    p = some_points(block, 1)[0]
    rows = rows_of(block, p)
    turned = stored_turned(block, np.array([block.images.ids.index(rows[0][0])]), 180)
    i = block.images.ids.index(rows[0][0])
    camera = turned.cameras[0]
    rest = without_points(turned, [p])
    file_xy = file_from_camera(turned.observations.xy_px, camera, turned.images.frames[i])
    at = np.flatnonzero((turned.observations.point == p) & (turned.observations.image == i))[0]
    actions = [Put(image=rows[0][0], point="new", x_px=file_xy[at, 0], y_px=file_xy[at, 1], covariance=(1.0, 2.0, 0.5))]
    actions += [a for a in puts(turned, p, "new") if a.image != rows[0][0]]
    made = merge(rest, folded(actions)).block
    k = np.flatnonzero(made.observations.image == i)[-1]
    np.testing.assert_allclose(made.observations.xy_px[k], turned.observations.xy_px[at], atol=1e-9)
    np.testing.assert_allclose(made.observations.cov_px2[k], [1.0, 2.0, 0.5], atol=1e-12)
    session = Session.of(adjust(rest))
    found = predict(session, folded(actions[1:]), "new", rows[0][0])
    np.testing.assert_allclose(found.xy_px, file_xy[at], atol=3)


@pytest.fixture
def measured():
    block = small_block()
    chosen = some_points(block, 3)
    actions = [a for k, p in enumerate(chosen) for a in puts(block, p, f"point {k}, é")]
    actions += [
        Point(point="point 0, é", role="control", xyz=(1.25, 2.5, 1 / 3), sigma=(0.01, 0.01, 0.0)),
        Point(point="point 1, é", role="check", xyz=(1.5, 2.5, None), sigma=(0.01, 0.02, None)),
    ]
    return without_points(block, chosen), folded(actions)


def marks_read(control):
    m = control.measurements
    return {(i, control.ids[k]): tuple(xy) for i, k, xy in zip(m.image, m.point, m.xy_px.tolist(), strict=True)}


def test_a_csv_is_read_as_control(measured, tmp_path):
    block, state = measured
    known = Known.of(block)
    write_csv(state, tmp_path / "points.csv", known)
    read = read_control(tmp_path / "points.csv")
    file = dict(zip(block.images.ids, block.images.file, strict=True))
    assert read.ids == tuple(state.points)
    assert marks_read(read) == {(file[i], p): (m.x_px, m.y_px) for (i, p), m in state.marks.items()}
    assert [Role(r).name.lower() for r in read.role] == [v.role for v in state.points.values()]
    np.testing.assert_array_equal(read.xyz[0], [1.25, 2.5, 1 / 3])
    np.testing.assert_array_equal(read.sigma[0], [0.01, 0.01, 0.0])
    np.testing.assert_array_equal(read.xyz[1], [1.5, 2.5, np.nan])


def test_a_gcp_list_is_read_as_control(measured, tmp_path):
    block, state = measured
    site = "+proj=tmerc +lat_0=50 +lon_0=15 +datum=WGS84"  # its coordinates begin near 0
    write_gcp_list(state, tmp_path / "gcp_list.txt", Known.of(block), site)
    read = read_control(tmp_path / "gcp_list.txt")
    assert (read.crs, read.ids) == (site, ("point 0, é",))
    assert len(read.measurements) == len(state.marks_of("point 0, é"))
    with pytest.raises(InputError, match=r"export\.no_control"):
        write_gcp_list(EMPTY, tmp_path / "gcp_list.txt", Known.of(block), "EPSG:32633")


def test_what_a_file_cannot_hold_is_told(measured, tmp_path):
    _, state = measured
    assert lost_in_csv(EMPTY) == lost_in_gcp_list(EMPTY) == ()
    more = folded([
        *(Point(point=n, role="check", xyz=(1.0, 2.0, 3.0)) for n in "abc"),
        SetBar(start="a", end="b", length=2.0, sigma=0.1), SetLine(line="edge", points=("a", "b", "c"), sigma=0.1),
        SetDatum(origin="a", axis="b", plane="c"),
    ])  # fmt: skip

    def lost(texts):
        (text,) = texts
        return {d.values["what"]: d.values["n"] for d in text.message.details}

    assert lost(lost_in_csv(more)) == {"scale_bars": 1, "lines": 1, "datum": 1}
    assert lost(lost_in_gcp_list(state))["partial_points"] == 1
    assert "point_sigmas" in lost(lost_in_gcp_list(state))


def test_a_block_holds_all(measured, tmp_path):
    block, state = measured
    write_merged_block(state, tmp_path / "block", block)
    read, made = read_block(tmp_path / "block"), merge(block, state).block
    assert read.points.ids == made.points.ids
    np.testing.assert_array_equal(read.observations.xy_px, made.observations.xy_px)
    np.testing.assert_allclose(read.observations.cov_px2, made.observations.cov_px2)
    control = read_control(tmp_path / "block")
    assert {"point 0, é", "point 1, é"} <= set(control.ids)
