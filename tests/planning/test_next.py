"""The next best photographs: what is promised is what a full adjustment with them states, and what is said is so."""

from dataclasses import replace

import numpy as np
import pytest

from raybundle.adjustment.decision.decide import decide
from raybundle.adjustment.engine import adjust_block
from raybundle.adjustment.evaluation.additions import with_photographs
from raybundle.adjustment.readjust import block_again
from raybundle.adjustment.records.options import AdjustmentOptions
from raybundle.block import Block
from raybundle.block.boards import spline_camera
from raybundle.calibration.maps import projection_shifts
from raybundle.errors import InputError
from raybundle.numerics.rotation import rotation_from_vector
from raybundle.objects.surface import Surface
from raybundle.planning.flights.uav_networks import Flight, flight_block
from raybundle.planning.next.best import next_best, ranking
from raybundle.planning.next.goals import Goal, measure_of
from raybundle.planning.next.obstacles import Obstacles
from raybundle.planning.next.outlook import Outlook
from raybundle.planning.next.plan import Conditions, frame_known, plan_next, vertical_of
from raybundle.planning.next.stations import Reach, reachable
from raybundle.planning.next.visibility import FARTHER, PointSight
from raybundle.planning.next.words import hold_message, instruction, place_message
from raybundle.planning.simulate import Survey, simulate
from raybundle.planning.synthetic_networks import Ring, TargetField, field_scene, ring_scene

FIELD = TargetField(rows=7, columns=9, stations=7, frontal=2)
EXACT = Survey(image_sigma_px=0.1, points="exact", orientation="exact", interior="exact")
TIGHT = AdjustmentOptions(noise="white", tolerance=1e-9)
BLOCKS = {
    "inner constraints, free camera": EXACT,
    "control, free camera": replace(EXACT, control=5, control_sigma=(0.002,) * 3),
    "control that is held": replace(EXACT, control=5, control_sigma=(0.0,) * 3),
    "scale bars": replace(EXACT, scale_bars=2),
    "stations observed": replace(EXACT, station_sigma=0.001),
    "rejected observations": replace(EXACT, control=5, control_sigma=(0.002,) * 3, gross_share=0.03),
    "minimal datum": EXACT,
    "held camera": replace(EXACT, control=4, control_sigma=(0.002,) * 3),
}


def adjusted(name="inner constraints, free camera", field=FIELD):
    block = simulate(field_scene(field), BLOCKS[name]).observed
    options = replace(TIGHT, datum="minimal") if name == "minimal datum" else TIGHT
    if name == "held camera":
        block = replace(block, cameras=(replace(block.cameras[0], estimate=()),))
    if name == "rejected observations":
        options = replace(options, reject="snooping")
    return decide(block, options)


def candidates(outlook, most=50):
    least = np.sqrt(outlook.joint.variances()).max(axis=1)
    sight = PointSight.of(outlook.block, outlook.used, outlook.joint.points, 0)
    found = reachable(outlook.block, outlook.used, 0, least, None, Reach(most=3 * most), outlook.joint.points)
    shown = sight.shown(outlook.block, 0, found.centre, found.rotation, least)
    enough = np.flatnonzero(np.bincount(shown.image, minlength=len(shown)) > 0)
    return shown.chosen(enough[np.linspace(0, len(enough) - 1, most).astype(int)])


def figures(outlook, *photographs):
    """Largest and mean standard deviation, and uncertainty of projection, of a full adjustment with photographs."""
    block, rejected = block_again(outlook.result), outlook.rejected
    for k, more in enumerate(photographs):
        block, rejected = with_photographs(block, rejected, more, (f"more {k}",))
    full = adjust_block(block, outlook.result.options, free=outlook.free, rejected=rejected, start="adjusted")
    scale = np.sqrt(outlook.variance) / full.sigma0
    std = scale * full.precision.object_point_std[outlook.joint.points]
    found = [std.max(), std[std > 0].mean()]
    if full.interior and full.interior[0].free:
        shifts = projection_shifts(outlook.block.cameras[0], full.interior[0].free, columns=18, rows=12)
        found.append(shifts.uncertainty(scale**2 * full.precision.interior["1"]).largest)
    return np.array(found)


@pytest.mark.parametrize("name", BLOCKS)
def test_order_and_sigmas_are_those_of_full_adjustments(name):
    result = adjusted(name)
    outlook = Outlook.of(result)
    shown = candidates(outlook, 20)
    full = np.array([figures(outlook, shown.chosen(np.array([i]))) for i in range(len(shown))])
    assert (name == "rejected observations") == (not outlook.used.all())
    for k, kind in enumerate(("worst", "mean", "calibration")[: full.shape[1]]):
        if name == "minimal datum" and kind != "calibration":
            continue  # a full adjustment chooses other coordinates to hold, here those of the result stay held
        low = np.array([s.value for s in ranking(outlook, shown, Goal(kind=kind, camera="1"), np.ones(20, bool))])
        assert low == pytest.approx(full[:, k], rel=1e-9)
        assert np.array_equal(np.argsort(low, kind="stable"), np.argsort(full[:, k], kind="stable"))


def test_cameras_with_surfaces_of_corrections():
    """Hundreds of parameters, of which a point touches few; those of the corners rest on what is known beforehand."""
    block = simulate(field_scene(FIELD), BLOCKS["control, free camera"]).observed
    block = replace(block, cameras=(replace(spline_camera(block.cameras[0], sigma_px=5), id="1"),))
    outlook = Outlook.of(decide(block, TIGHT))
    shown = candidates(outlook, 5)
    full = np.array([figures(outlook, shown.chosen(np.array([i]))) for i in range(5)])
    for k, (kind, exact) in enumerate((("worst", 1e-9), ("mean", 1e-9), ("calibration", 1e-7))):
        low = [s.value for s in ranking(outlook, shown, Goal(kind=kind, camera="1"), np.ones(5, bool))]
        assert low == pytest.approx(full[:, k], rel=exact)


def test_each_is_exact_after_those_before_it():
    outlook = Outlook.of(adjusted("control, free camera"))
    shown = candidates(outlook)
    found = next_best(outlook, shown, Goal(kind="mean"), count=3)
    taken = [c.photograph for c in found]
    for k, c in enumerate(found):
        assert c.after.value == pytest.approx(figures(outlook, *taken[: k + 1])[1], rel=1e-9)
        others = [figures(outlook, *taken[:k], shown.chosen(np.array([i])))[1] for i in (0, 17, 40)]
        assert c.ranked[[0, 17, 40]] == pytest.approx(others, rel=1e-9)
        assert c.after.value == c.ranked.min()
        assert c.before.value == pytest.approx(found[k - 1].after.value if k else c.before.value, rel=1e-9)


def test_what_is_promised_of_all_points_is_what_an_adjustment_states():
    plan = plan_next(adjusted("control, free camera"), "worst", 2)
    promised = np.sqrt(np.diagonal(plan.promised(plan.adjusted()), axis1=1, axis2=2))
    assert promised[plan.outlook.joint.points] == pytest.approx(plan.proposals[-1].std_after, rel=1e-9)


def test_only_points_that_are_asked_for():
    result = adjusted()
    ids = result.given.points.ids
    plan = plan_next(result, "points", 1, points=(ids[0], ids[5]))
    at = plan.outlook.joint.place(np.array([0, 5]))
    assert plan.proposals[0].after.value == pytest.approx(plan.proposals[0].std_after[at].max(), rel=1e-12)
    with pytest.raises(InputError, match=r"plan\.points_not_adjusted"):
        measure_of(plan.outlook, Goal(kind="points"))
    with pytest.raises(InputError, match=r"nobody.*plan\.points_not_adjusted"):
        plan_next(result, "points", 1, points=("nobody",))


def test_what_cannot_be_determined_is_freed():
    """A level flight at one height does not determine c."""
    flight = Flight(height_jitter=0.0, angle_jitter_deg=0.0, alternating=True, points=9)
    result = decide(flight_block(flight), AdjustmentOptions(noise="white"))
    assert [s for s, p in result.interior[0].parameters.items() if p.status == "not determinable"] == ["c"]
    plan = plan_next(result, "calibration", 2)
    assert plan.proposals[0].before.value > 100
    assert plan.proposals[-1].after.value < 1
    assert [instruction(plan, k).frees for k in range(2)] == [("c",), ()]
    then = adjust_block(plan.extended(), AdjustmentOptions(noise="white"), free=plan.outlook.free)
    assert then.interior[0].parameters["c"].status == "estimated"
    shifts = projection_shifts(plan.block.cameras[0], then.interior[0].free, columns=18, rows=12)
    scale = plan.outlook.variance / then.sigma0**2
    full = shifts.uncertainty(scale * then.precision.interior[plan.block.cameras[0].id]).largest
    assert plan.proposals[-1].after.value == pytest.approx(full, rel=0.01)


def test_stated_widths_of_smooth_errors_are_kept():
    """Standard deviations that are wider than for white noise stay so, and what is told to be now is what is stated."""
    scene = field_scene(replace(FIELD, stations=10, rows=10, columns=14))
    block = simulate(scene, replace(EXACT, control=5, control_sigma=(0.002,) * 3)).observed
    o = block.observations
    half = np.array([3000.0, 2000.0])
    bend = 0.3 * np.sin(np.pi * (o.xy_px - half)[:, ::-1] / 1500 + o.image[:, None])
    block = replace(block, observations=replace(o, xy_px=o.xy_px + bend))
    result = decide(block, AdjustmentOptions(noise="fields"))
    assert result.noise.kind == "fields"
    plan = plan_next(result, "worst", 1)
    assert plan.outlook.wider.max() > 1.0001
    assert plan.proposals[0].before.value == pytest.approx(np.nanmax(result.precision.object_point_std), rel=1e-9)
    plan = plan_next(result, "calibration", 1)
    shifts = projection_shifts(plan.block.cameras[0], result.interior[0].free, columns=18, rows=12)
    stated = shifts.uncertainty(result.precision.interior["1"]).largest
    assert plan.proposals[0].before.value == pytest.approx(stated, rel=1e-9)


def test_of_many_points_the_weakest_are_regarded():
    result = room(points=1100, stations=7)
    plan = plan_next(result, "worst", 1, Conditions(reach=Reach(most=60)))
    assert len(plan.outlook.joint.points) == 1000 < len(result.given.points)
    assert plan.proposals[0].before.value == pytest.approx(np.nanmax(result.precision.object_point_std), rel=1e-9)
    stated = np.sqrt(np.nanmax(np.diagonal(plan.promised(plan.adjusted()), axis1=1, axis2=2)))
    assert plan.proposals[0].after.value == pytest.approx(stated, rel=1e-9)


def test_line_scanners_are_no_frame_cameras():
    result = adjusted("control, free camera")
    line = replace(result.given.cameras[0], model="pushbroom", values={}, estimate=())
    told = replace(result, given=replace(result.given, cameras=(line,)))
    with pytest.raises(InputError, match=r"1.*plan\.no_frame_camera"):
        plan_next(told, "worst", 1)


def room(survey=None, **ring):
    """Photographs round a cylinder that stands upright, levelled and scaled by control."""
    scene = ring_scene(Ring(**{"stations": 10, "rings": 1, "points": 120, "roll_deg": (0.0,), **ring}))
    return decide(simulate(scene, survey or replace(EXACT, control=6, control_sigma=(0.001,) * 3)).observed, TIGHT)


@pytest.fixture(scope="module")
def levelled():
    return plan_next(room(), "mean", 1)


def shifts_of(found):
    """Ways and lengths of a place."""
    v = found.values
    ways = [(v.get(way), v.get(size)) for way, size in (("first", "one"), ("second", "two"), ("third", "three"))]
    return {way: size for way, size in ways if way not in {None, "none"}}


@pytest.mark.parametrize(
    ("right", "up", "nearer", "said"),
    [
        (-1.0, 0.5, 0.0, {"left": 1.0, "higher": 0.5}),
        (0.8, -0.4, 0.2, {"right": 0.8, "lower": 0.4, "nearer": 0.2}),
        (0.0, 0.0, -0.7, {"farther": 0.7}),
        (0.0, 0.3, 0.6, {"higher": 0.3, "nearer": 0.6}),
        (0.01, 0.0, 0.01, {}),
        (1.0, 0.05, 0.0, {"right": 1.0}),
    ],
)
def test_words_of_the_place(levelled, right, up, nearer, said):
    image, block = 3, levelled.block
    R, X0 = block.images.rotation[image], block.images.centre[image]
    ahead = -R[2] * [1, 1, 0]
    ahead = ahead / np.linalg.norm(ahead)
    centre = X0 + right * np.cross(ahead, [0, 0, 1]) + up * np.array([0, 0, 1]) + nearer * ahead
    assert levelled.vertical is not None
    found = place_message(levelled, image, centre, np.zeros(3))
    assert found.values["name"] == block.images.ids[image]
    assert found.code == ("next_photograph.place" if said else "next_photograph.same_place")
    assert shifts_of(found) == pytest.approx(said)
    assert found.values.get("unit") == ("m" if said else None)


@pytest.mark.parametrize(
    ("turn", "said"),
    [
        (0.0, {"upside_down": False}),
        (10.0, {"upside_down": False}),
        (90.0, {"angle_deg": 90, "clockwise": True}),
        (-85.0, {"angle_deg": 90, "clockwise": False}),
        (180.0, {"upside_down": True}),
        (43.0, {"angle_deg": 45, "clockwise": True}),
    ],
)
def test_words_of_the_roll(levelled, turn, said):
    """Clockwise as seen by who holds it: the right side, which is x of the image, goes down."""
    upright = levelled.block.images.rotation[3]
    about = np.arctan2(upright[0, 2], upright[1, 2])  # that photographs are scattered a little
    level = rotation_from_vector(np.array([[0.0, 0.0, -about]]))[0] @ upright
    if abs(level[0, 2]) > 1e-9:
        level = rotation_from_vector(np.array([[0.0, 0.0, about]]))[0] @ upright
    rolled = next(
        R
        for sign in (1, -1)
        for R in [rotation_from_vector(np.array([[0.0, 0.0, sign * np.radians(turn)]]))[0] @ level]
        if turn in {0.0, 180.0} or R[0, 2] * np.sin(np.radians(turn)) < 0
    )
    found = hold_message(levelled, 3, rolled)
    assert found.code == ("next_photograph.roll" if "clockwise" in said else "next_photograph.hold")
    assert found.values == {**said, "against": False, "name": ""}


def test_words_without_a_vertical_are_of_the_picture():
    plan = plan_next(adjusted(), "mean", 1)
    assert plan.vertical is None
    assert not frame_known(plan.result)
    R, X0 = plan.block.images.rotation[2], plan.block.images.centre[2]
    name = plan.block.images.ids[2]
    ahead = np.median(np.linalg.norm(plan.block.points.xyz - X0, axis=1))
    found = place_message(plan, 2, X0 - 0.5 * ahead * R[0] + 0.25 * ahead * R[1], np.zeros(3))
    assert shifts_of(found) == pytest.approx({"left": 0.5, "upper_edge": 0.25}, rel=0.1)
    assert (found.values["name"], found.values["known"]) == (name, False)
    quarter = rotation_from_vector(np.array([[0.0, 0.0, np.pi / 2], [0.0, 0.0, -np.pi / 2]])) @ R
    both = [hold_message(plan, 2, q).values for q in quarter]
    assert {v["clockwise"] for v in both} == {True, False}
    assert all((v["angle_deg"], v["against"], v["name"]) == (90, True, name) for v in both)
    assert hold_message(plan, 2, R).values == {"upside_down": False, "against": True, "name": name}


def test_boards_and_flights_have_no_left_by_a_vertical():
    """A field under control whose Z is its normal: the frame is known, but nobody on site goes by it."""
    result = adjusted("control, free camera")
    assert frame_known(result)
    assert vertical_of(result) is None
    assert vertical_of(room()) is not None
    assert vertical_of(room(EXACT)) is None


def test_reach(levelled):
    block, used, points = levelled.block, levelled.outlook.used, levelled.outlook.joint.points
    least, up = np.ones(len(points)), np.array([0.0, 0.0, 1.0])

    def where(**given):
        return reachable(block, used, 0, least, up, Reach(**given), points).centre

    low = block.points.xyz[points, 2].min()
    centre = where(heights=(0.2, 0.9))
    assert ((centre[:, 2] - low >= 0.2) & (centre[:, 2] - low <= 0.9)).all()
    box = np.array([[[-9, -9, -9], [0, 9, 9]]], float)
    assert (where(forbidden=box)[:, 0] > 0).all()
    far = np.linalg.norm(where(clearance=2.5)[:, None] - block.points.xyz[points], axis=2).min(axis=1)
    assert far.min() >= 2.5
    near = np.linalg.norm(where(step=0.5)[:, None] - block.images.centre, axis=2).min(axis=1)
    assert near.max() <= 0.5 + 1e-9
    assert np.abs(where(around=1.5)).max() < 1.5 + np.abs(block.points.xyz).max()
    with pytest.raises(InputError, match=r"plan\.no_station_within"):
        where(around=0.01)


def test_image_points_are_as_precise_as_those_of_the_same_points():
    result = adjusted()
    o = result.given.observations
    cov = o.cov_px2.copy()
    cov[o.point == 4] = [0.09, 0.04, 0.0]
    block = replace(result.adjusted, observations=replace(o, cov_px2=cov))
    points = np.arange(len(block.points))
    sight = PointSight.of(block, np.ones(len(o), bool), points, 0)
    assert sight.cov_px2[4].tolist() == [0.09, 0.04, 0.0]
    assert sight.cov_px2[5] == pytest.approx([0.01, 0.01, 0.0])
    single = replace(block, cameras=(*block.cameras, replace(block.cameras[0], id="2")))
    other = block.images.camera.copy()
    other[o.image[o.point == 4]] = 1
    single = replace(single, images=replace(block.images, camera=other))
    seen = PointSight.of(single, np.ones(len(o), bool), points, 0)
    assert seen.cov_px2[4] == pytest.approx(np.median(cov[other[o.image] == 0], axis=0))


def test_what_is_sharp_and_seen_slantwise(levelled):
    block, used, points = levelled.block, levelled.outlook.used, levelled.outlook.joint.points
    sight = PointSight.of(block, used, points, 0)
    R, X0 = block.images.rotation[:1], block.images.centre[:1]
    every = sight.shown(block, 0, X0, R)
    depth = -np.einsum("j,kj->k", R[0, 2], block.points.xyz[every.point] - X0[0])
    near = replace(sight, depth=(0.0, float(np.median(depth)))).shown(block, 0, X0, R)
    assert set(near.point) == set(every.point[depth < np.median(depth)])
    steep = replace(sight, incidence=np.radians(30)).shown(block, 0, X0, R)
    assert 0 < len(steep.point) < len(every.point)
    assert FARTHER > 1


def wall(x):
    corners = np.array([[x, -5, -5], [x, 5, -5], [x, 5, 5], [x, -5, 5]], float)
    return corners, np.array([[0, 1, 2], [0, 2, 3]])


def test_what_stands_between_hides(levelled):
    points = levelled.outlook.joint.points
    xyz = levelled.block.points.xyz[points]
    at = np.arange(len(xyz))
    corners, triangles = wall(2.5)
    n = 64
    turn = 2 * np.pi * np.arange(n) / n
    r, h = np.linalg.norm(xyz[:, :2], axis=1).max(), np.abs(xyz[:, 2]).max()
    ring = np.stack([r * np.cos(turn), r * np.sin(turn)], axis=1)
    mantle = np.concatenate([np.c_[ring, np.full(n, -h)], np.c_[ring, np.full(n, h)]])
    k, j = np.arange(n), (np.arange(n) + 1) % n
    faces = np.concatenate([np.stack([k, j, n + j], axis=1), np.stack([k, n + j, n + k], axis=1)])
    plain = Obstacles.of(Surface(name="mantle", vertices=mantle, triangles=faces), xyz)
    seen = plain.visible(np.array([4.0, 0, 0]), at)
    assert seen[xyz[:, 0] > 0.5 * r].all()
    assert not seen[xyz[:, 0] < -0.1 * r].any()
    both = Surface(
        name="mantle and wall", vertices=np.concatenate([mantle, corners]),
        triangles=np.concatenate([faces, triangles + len(mantle)]),
    )  # fmt: skip
    hidden = Obstacles.of(both, xyz)
    assert not hidden.visible(np.array([4.0, 0, 0]), at).any()
    places = np.array([[r + 0.3, 0.0, 0.0], [r + 0.6, 0, 0]])
    assert plain.allowed(0.5)(places).tolist() == [False, True]
    with pytest.raises(InputError, match=r"plan\.object_elsewhere"):
        Obstacles.of(Surface(name="elsewhere", vertices=mantle + 50, triangles=faces), xyz)
    with_ = plan_next(levelled.result, "mean", 1, Conditions(surface=both))
    assert with_.proposals[0].photograph.centre[0, 0] < 2.5
    assert with_.judged < with_.reached


def two_cameras() -> Block:
    block = simulate(field_scene(FIELD), replace(EXACT, control=5, control_sigma=(0.002,) * 3)).observed
    of = np.zeros(len(block.images), np.int32)
    of[:3] = 1
    cameras = (block.cameras[0], replace(block.cameras[0], id="second", estimate=()))
    return replace(block, cameras=cameras, images=replace(block.images, camera=of))


def test_the_camera_of_most_photographs_unless_told():
    result = decide(two_cameras(), TIGHT)
    assert plan_next(result, "mean", 1).camera == 0
    other = plan_next(result, "mean", 1, Conditions(camera="second"))
    assert other.camera == 1
    assert other.adjusted().given.images.camera[-1] == 1
    with pytest.raises(InputError, match=r"plan\.unknown_camera") as error:
        plan_next(result, "mean", 1, Conditions(camera="third"))
    assert error.value.message.values["known"] == ["1", "second"]
    with pytest.raises(InputError, match=r"plan\.camera_fixed"):
        plan_next(result, "calibration", 1, Conditions(camera="second"))


def test_what_cannot_be_answered_is_told():
    result = adjusted("control, free camera")
    with pytest.raises(InputError, match=r"plan\.too_few_candidates"):
        plan_next(result, "worst", 99, Conditions(reach=Reach(most=30)))
    with pytest.raises(InputError, match=r"plan\.nothing_seen_again"):
        plan_next(result, "worst", 1, Conditions(depth=(1e-3, 2e-3)))
    with pytest.raises(InputError, match=r"adjustment\.no_statistics"):
        plan_next(decide(result.given, replace(TIGHT, statistics=False)), "worst", 1)
    low = plan_next(adjusted(), "worst", 1, Conditions(reach=Reach(heights=(0.0, 2.0))))
    assert low.vertical == pytest.approx([0, 0, 1])  # who gives heights knows which way is up
    camera = replace(result.given.cameras[0], interior="per_image", estimate=())
    own = decide(replace(result.given, cameras=(camera,)), TIGHT)
    with pytest.raises(InputError, match=r"plan\.no_frame_camera"):
        plan_next(own, "worst", 1)
