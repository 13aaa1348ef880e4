"""Planes of an object: plumb, by points, with axes; how far they lean, and how sure that is."""

from dataclasses import replace

import numpy as np
import pytest

from raybundle.block.transform import transform_block
from raybundle.errors import InputError, phrase
from raybundle.numerics.transform import SimilarityTransform
from raybundle.observations.alignment import PlumbLines
from raybundle.planning.simulate import Survey, simulate
from raybundle.planning.synthetic_networks import TargetField, brown_camera, field_scene
from raybundle.workflows.object_plane import PlaneAsked, plane_of

EXACT = Survey(interior="exact", orientation="exact", points="exact", image_sigma_px=0.01)


def turned(block, degrees):
    """The flat field stood up: 90 degrees make it plumb, less lean it back."""
    c, s = np.cos(np.radians(degrees)), np.sin(np.radians(degrees))
    R = np.array([[1, 0, 0], [0, c, -s], [0, s, c]])
    by = SimilarityTransform(scale=1.0, rotation=R, translation=np.array([3.0, -2.0, 1.0]))
    return transform_block(block, by, observed="stay")


@pytest.fixture(scope="module")
def field():
    scene = field_scene(TargetField(camera=brown_camera(), columns=9, rows=7, stations=4, frontal=1, depth=0.0))
    return simulate(scene, EXACT).observed


@pytest.fixture(scope="module")
def wall(field):
    """A plumb one, and the names of its corners: bottom left, bottom right, top left, top right."""
    block = turned(field, 90.0)
    xyz = block.points.xyz
    at = plane_of(block).coordinates(xyz)[:, :2]
    corners = [int(np.argmax(at @ d)) for d in ((-1, -1), (1, -1), (-1, 1), (1, 1))]
    return block, tuple(block.points.ids[k] for k in corners)


def moved(block, xyz):
    return replace(block, points=replace(block.points, xyz=xyz))


def test_a_plumb_plane_goes_through_two_points(wall):
    block, (a, b, *_) = wall
    plane = plane_of(block, PlaneAsked(points=(a, b), vertical=True, origin=a, axis=(a, b)))
    index = block.points.ids.index
    assert abs(plane.axes[2, 2]) < 1e-12
    there = plane.coordinates(block.points.xyz[[index(a), index(b)]])
    assert there[0] == pytest.approx([0, 0, 0], abs=1e-12)
    assert there[1, 1:] == pytest.approx([0, 0], abs=1e-12)
    assert there[1, 0] > 0
    # two points have no extent: that of the wall in which they stand
    every = plane.coordinates(block.points.xyz)
    assert plane.extent == pytest.approx([*every[:, :2].min(axis=0), *every[:, :2].max(axis=0)])


def test_the_viewer_stands_in_front_and_axes_are_right_handed(wall):
    block, names = wall
    for asked in (PlaneAsked(), PlaneAsked(vertical=True), PlaneAsked(points=names), PlaneAsked(points=names[:3])):
        plane = plane_of(block, asked)
        assert np.linalg.det(plane.axes) == pytest.approx(1.0)
        assert (plane.coordinates(block.images.centre)[:, 2] > 0).all()
        assert plane.axes[1, 2] == pytest.approx(1.0)


@pytest.mark.parametrize("lean", [2.0, -1.0])
def test_how_far_a_wall_leans(field, wall, lean):
    block = turned(field, 90.0 - lean)
    for asked in (PlaneAsked(points=wall[1]), PlaneAsked(points=wall[1], vertical=True), PlaneAsked(vertical=True),
                  PlaneAsked()):  # fmt: skip
        found = plane_of(block, asked)
        assert np.degrees(found.lean.angle) == pytest.approx(lean, abs=1e-6)
        assert found.lean.values["back"] == (lean > 0)
        if asked.vertical:
            assert abs(found.axes[2, 2]) < 1e-12


@pytest.mark.parametrize(("lean", "sigma", "told"), [(5.0, 0.1, False), (26.0, 0.5, True), (26.0, 12.0, False)])
def test_what_leans_as_no_wall_does_is_a_caution(field, wall, lean, sigma, told):
    block, names = turned(field, 90.0 - lean), wall[1]
    asked = PlaneAsked(points=names, vertical=True)
    exact = plane_of(block, asked)
    found = replace(exact, lean=replace(exact.lean, sigma=np.radians(sigma)))
    assert bool(found.cautions) == told
    if told:
        assert found.cautions[0].message.code == "plane.leans"
        assert found.cautions[0].message.values["limit_deg"] == pytest.approx(11, abs=0.5)
        assert not found.remarks
    assert not plane_of(block, PlaneAsked(points=names)).cautions  # a roof is made as it lies


def test_a_wall_that_is_not_plumb_is_told_where_a_plumb_one_is_asked_for(field, wall):
    noise = np.random.default_rng(3).normal(0, 1e-4, (len(field.points), 3))
    upright, leaning = (turned(moved(field, field.points.xyz + noise), 90.0 - lean) for lean in (0.0, 2.0))
    asked = PlaneAsked(points=wall[1], vertical=True)

    def covariance(names):
        return 1e-2 * np.eye(3 * len(names))

    told = plane_of(leaning, asked, covariance=lambda names: covariance(names) * 1e-6).remarks
    assert len(told) == 1
    assert told[0].message.code == "plane.not_plumb"
    assert told[0].message.values["back"] is True
    assert told[0].message.values["lean_deg"] == pytest.approx(2, abs=0.1)
    assert not plane_of(upright, asked, covariance=covariance).remarks
    assert not plane_of(leaning, PlaneAsked(points=wall[1])).remarks


def test_the_standard_deviation_of_the_lean_of_named_points_is_true(wall):
    block, names = wall
    rng, sigma = np.random.default_rng(1), 2e-3
    found = plane_of(block, PlaneAsked(points=names[:3]), covariance=lambda n: sigma**2 * np.eye(3 * len(n)))
    at = [block.points.ids.index(n) for n in names[:3]]
    leans = []
    for _ in range(400):
        xyz = block.points.xyz.copy()
        xyz[at] += rng.normal(0, sigma, (3, 3))
        leans.append(plane_of(moved(block, xyz), PlaneAsked(points=names[:3])).lean.angle)
    assert found.lean.sigma == pytest.approx(np.std(leans), rel=0.15)  # 400 draws: 4 %, and four of these


def test_the_errors_of_plumb_lines_go_into_it(wall):
    block, (a, b, c, d) = wall
    rng, sigma = np.random.default_rng(2), 2e-3
    asked = PlaneAsked(points=(a, b, d), up=f"{a},{c}")
    found = plane_of(block, asked, covariance=lambda n: sigma**2 * np.eye(3 * len(n)))
    at = [block.points.ids.index(n) for n in (a, b, c, d)]
    leans = []
    for _ in range(400):
        xyz = block.points.xyz.copy()
        xyz[at] += rng.normal(0, sigma, (4, 3))
        leans.append(plane_of(moved(block, xyz), asked).lean.angle)
    assert found.lean.sigma == pytest.approx(np.std(leans), rel=0.15)


@pytest.mark.long
def test_the_standard_deviation_by_scatter_is_true(wall):
    block, _ = wall
    rng = np.random.default_rng(4)
    found = [
        plane_of(moved(block, block.points.xyz + rng.normal(0, 1e-4, block.points.xyz.shape)), PlaneAsked()).lean
        for _ in range(40)
    ]  # fmt: skip
    # 40 draws: 11 % of a standard deviation
    assert np.mean([f.sigma for f in found]) == pytest.approx(np.std([f.angle for f in found]), rel=0.35)


def test_what_is_plumb_by_measured_lines(field, wall):
    block = turned(field, 87.0)
    a, b, c, d = (block.points.ids.index(n) for n in wall[1])
    table = PlumbLines(figure=("x", "x", "y", "y"), point=np.array([a, c, b, d]), sigma=np.full(4, 1e-3))
    plane = plane_of(block.having(table), PlaneAsked(points=wall[1], vertical=True, up="lines"))
    assert plane.plumb.words == phrase("plumb.lines", n=2)
    assert plane.axes[2] @ plane.plumb.up == pytest.approx(0, abs=1e-12)
    assert plane.lean.angle == pytest.approx(0, abs=1e-6)  # what nothing tells is drawn towards Z
    # the block's own Z says otherwise
    assert np.degrees(plane_of(block, PlaneAsked(points=wall[1])).lean.angle) == pytest.approx(3.0)


def test_where_z_comes_from_is_told(wall):
    block, names = wall
    about = {"upright": {"kind": "terrestrial", "sigma_deg": 0.3, "plumb_edges": 156}}
    plane = plane_of(block, PlaneAsked(points=names), about=about)
    assert plane.plumb.words == phrase("plumb.block_found", by="edges", edges=156, known=True, sigma_deg=0.3)
    assert plane.lean.sigma >= np.radians(0.3)
    assert plane_of(
        block, PlaneAsked(points=names), about={"upright": {"kind": "given", "sigma_deg": None}}
    ).plumb.words


@pytest.mark.parametrize(
    ("asked", "told"),
    [
        ({"points": ("A", "B")}, r"2 .* 3 .*plane\.too_few_points"),
        ({"points": ("A", "A", "B")}, r"A.*plane\.point_twice"),
        ({"vertical": True, "horizontal": True}, r"plane\.vertical_and_horizontal"),
        ({"points": ("nobody", "A", "B")}, r"nobody.*point\.not_in_result"),
        ({"up": "sideways"}, r"sideways.*vertical\.way_unknown"),
        ({"up": "lines"}, r"lines.*vertical\.no_plumb_line"),
        ({"up": "A,nobody"}, r"nobody.*point\.not_in_result"),
        ({"axis": ("A", "nobody")}, r"nobody.*point\.not_in_result"),
        ({"origin": "nobody"}, r"nobody.*point\.not_in_result"),
        ({"points": ("A", "C"), "vertical": True}, r"plane\.points_above_each_other"),
    ],
)
def test_what_makes_no_plane_is_refused(wall, asked, told):
    block, (a, b, c, _) = wall
    names = {"A": a, "B": b, "C": c}
    xyz = block.points.xyz.copy()
    xyz[block.points.ids.index(c)] = xyz[block.points.ids.index(a)] + [0, 0, 1]
    ids = tuple({v: k for k, v in names.items()}.get(i, i) for i in block.points.ids)
    block = replace(block, points=replace(block.points, xyz=xyz, ids=ids))
    with pytest.raises(InputError, match=told):
        plane_of(block, PlaneAsked(**asked))


def test_an_axis_through_the_plane_is_refused(wall):
    block, (a, b, *_) = wall
    xyz = block.points.xyz.copy()
    normal = plane_of(block, PlaneAsked(points=wall[1])).axes[2]
    xyz[block.points.ids.index(b)] = xyz[block.points.ids.index(a)] + normal
    with pytest.raises(InputError, match=r"plane\.axis_no_direction"):
        plane_of(moved(block, xyz), PlaneAsked(points=(*wall[1][2:], a), axis=(a, b)))
