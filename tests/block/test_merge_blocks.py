"""Blocks that are merged: what each holds is carried, what contradicts follows the rule that is named or is refused."""

from dataclasses import replace

import numpy as np
import pytest

import raybundle as rb
from raybundle.adjustment.engine import adjust_block
from raybundle.adjustment.records.options import AdjustmentOptions
from raybundle.block import PixelFrame, Relation
from raybundle.block.merge import SUBJECTS, merge_blocks
from raybundle.block.select import select_block, with_rows
from raybundle.block.transform import transform_block
from raybundle.errors import InputError
from raybundle.numerics.places import Local
from raybundle.numerics.transform import SimilarityTransform
from raybundle.observations.alignment import Planes
from raybundle.observations.total_station import Directions
from raybundle.planning.simulate import Survey, simulate
from raybundle.planning.synthetic_networks import AerialStrips, TargetField, aerial_scene, field_scene
from tests.observations.test_kinds import EXAMPLES

SURVEY = Survey(
    image_sigma_px=0.3, control=5, control_sigma=(0.02,) * 3, station_sigma=0.05, scale_bars=2, points="approximate",
    interior="exact",
)  # fmt: skip


@pytest.fixture(scope="module")
def flights():
    """A block, and the two halves of its images with the points that each sees and those that are given."""
    scene = aerial_scene(AerialStrips(strips=2, images_per_strip=4, points_per_image=60))
    block = simulate(scene, SURVEY).observed
    block = replace(block, name="whole", rejected=((block.images.ids[0], block.points.ids[3]),))
    halves = []
    for k, mine in enumerate((np.arange(8) < 4, np.arange(8) >= 4)):
        part = select_block(block, "image", mine)
        part = with_rows(part, np.ones(len(part.observations), bool))
        halves.append(replace(part, name=f"flight {k + 1}"))
    return block, halves


def test_two_flights_adjusted_as_one_block_are_the_whole_block(flights):
    block, halves = flights
    merged = rb.merge_blocks(halves)
    assert merged.name == "flight 1 + flight 2"
    assert merged.images.ids == block.images.ids
    assert len(merged.observations) == len(block.observations)
    assert {n: len(t) for n, t in merged.tables.items()} == {n: len(t) for n, t in block.tables.items()}
    options = AdjustmentOptions(jobs=1, tolerance=1e-10)
    one, two = adjust_block(block, options), adjust_block(merged, options)
    assert two.sigma0 == pytest.approx(one.sigma0, rel=1e-9)
    assert two.redundancy == one.redundancy
    order = [merged.points.ids.index(n) for n in block.points.ids if n in merged.points.ids]
    known = [block.points.ids.index(merged.points.ids[k]) for k in order]
    np.testing.assert_allclose(
        two.precision.object_points[order], one.precision.object_points[known], rtol=1e-6, atol=1e-14
    )


def changed_camera(block):
    c = block.cameras[0]
    return replace(block, cameras=(replace(c, values={**c.values, "c": c.values["c"] + 1}), *block.cameras[1:]))


def with_points(block, **columns):
    return replace(block, points=replace(block.points, **columns))


def moved_control(block):
    control = block.points.is_control
    return with_points(block, xyz=np.where(control, block.points.xyz + 0.5, block.points.xyz))


def wider_control(block):
    return with_points(block, sigma=2 * block.points.sigma)


def other_roles(block):
    return with_points(block, role=np.where(block.points.role == 1, 2, block.points.role))


def moved_image_point(block):
    o = block.observations
    return replace(block, observations=replace(o, xy_px=o.xy_px + 1.0))


def moved_stations(block):
    return block.having(replace(block.stations, xyz=block.stations.xyz + 1.0))


def stored_turned(block):
    frame = PixelFrame(turned=90, width_px=400, height_px=300)
    return replace(block, images=replace(block.images, frames={0: frame}))


def of_camera(block):
    second = replace(block.cameras[0], id="second")
    one = np.full(len(block.images), 1, np.int32)
    return replace(block, cameras=(*block.cameras, second), images=replace(block.images, camera=one))


def held(block, shift=0.0):
    images = block.images
    return replace(block, images=replace(images, held=np.ones(len(images), bool), centre=images.centre + shift))


def on_rig(block):
    return replace(block, images=replace(block.images, station=np.zeros(len(block.images), np.int32)))


CONTRADICTIONS = {
    "values": (changed_camera, "camera", r"values\.c is .*merge\.contradiction"),
    "control": (moved_control, "point", r": xyz is .*merge\.contradiction"),
    "sigmas": (wider_control, "point", r": sigma is .*merge\.contradiction"),
    "roles": (other_roles, "point", r": role is control .* check .*merge\.contradiction"),
    "image points": (moved_image_point, "observation", r": xy_px is .*merge\.contradiction"),
    "stations": (moved_stations, "observation", r"stations\.csv.*merge\.contradiction"),
    "frames": (stored_turned, "image", r": frames is .*merge\.contradiction"),
    "camera of an image": (of_camera, "image", r": camera is .* second .*merge\.contradiction"),
    "held": (held, "image", r": held is False .* True .*merge\.contradiction"),
    "rig": (on_rig, "image", r": station is .*merge\.contradiction"),
    "a-priori sigma": (lambda b: replace(b, sigma0_apriori=0.5), "block", r"sigma0_apriori.*merge\.contradiction"),
}


@pytest.mark.parametrize(("change", "subject", "message"), CONTRADICTIONS.values(), ids=CONTRADICTIONS)
def test_contradictions_are_refused_or_follow_the_rule(flights, change, subject, message):
    _, (first, _) = flights
    if subject == "image" and change not in {of_camera, held, on_rig}:
        frame = PixelFrame(turned=270, width_px=400, height_px=300)
        first = replace(first, images=replace(first.images, frames={0: frame}))
    if change is held or change is on_rig:
        none = np.zeros(len(first.images), bool)
        first = replace(first, images=replace(first.images, held=none))
    second = change(first)
    with pytest.raises(InputError, match=message) as told:
        merge_blocks([first, second])
    assert f"prefer=dict({subject}=0)" in str(told.value)
    with pytest.raises(InputError):
        merge_blocks([first, second], prefer={s: 0 for s in SUBJECTS if s != subject})
    for k, stands in enumerate((first, second)):
        merged = merge_blocks([first, second], prefer={subject: k})
        assert merged.points.role.tolist() == (stands if subject == "point" else first).points.role.tolist()
        if subject == "camera":
            assert merged.cameras == stands.cameras
        if subject == "point":
            given = stands.points.is_control
            np.testing.assert_array_equal(merged.points.xyz[given], stands.points.xyz[given])
            np.testing.assert_array_equal(merged.points.sigma[given], stands.points.sigma[given])
        if subject == "observation":
            np.testing.assert_array_equal(merged.observations.xy_px, stands.observations.xy_px)
            np.testing.assert_array_equal(merged.stations.xyz, stands.stations.xyz)
        if subject == "image":
            assert dict(merged.images.frames) == dict(stands.images.frames)
            assert [merged.cameras[c].id for c in merged.images.camera] == [
                stands.cameras[c].id for c in stands.images.camera
            ]
        if subject == "block":
            assert merged.length_unit == stands.length_unit
            assert merged.sigma0_apriori == stands.sigma0_apriori


def test_images_held_at_two_places_contradict_and_others_do_not(flights):
    _, (first, _) = flights
    moved = replace(first, images=replace(first.images, centre=first.images.centre + 1.0))
    merged = merge_blocks([first, moved])  # approximate values: those of the last
    np.testing.assert_array_equal(merged.images.centre, moved.images.centre)
    with pytest.raises(InputError, match=r"merge\.contradiction"):
        merge_blocks([held(first), held(first, 1.0)])
    merged = merge_blocks([held(first), held(first, 1.0)], prefer={"image": 0})
    np.testing.assert_array_equal(merged.images.centre, first.images.centre)


def test_lengths_of_another_unit_are_brought_to_the_preferred_one():
    block = replace(EXAMPLES["field"](), name="a")
    by = rb.SimilarityTransform(scale=1000.0)
    millimetres = replace(rb.transform_block(block, by, observed="follow"), length_unit="mm")
    bars = millimetres.distances
    with pytest.raises(InputError, match=r"length_unit.*1.*merge\.contradiction"):
        merge_blocks([block, millimetres])
    merged = merge_blocks([block, millimetres], prefer=dict.fromkeys(SUBJECTS, 0))
    assert merged.length_unit == "m"
    np.testing.assert_allclose(merged.points.xyz, block.points.xyz, rtol=1e-14)
    np.testing.assert_allclose(bars.length, 1000 * block.distances.length)


def test_places_on_the_earth_contradict_and_one_alone_stands(flights):
    _, (first, second) = flights
    here, there = (Local(origin=(15.0, 48.0, h)) for h in (0.0, 300.0))
    assert merge_blocks([first, replace(second, place=here)]).place == here
    with pytest.raises(InputError, match=r"merge\.contradiction"):
        merge_blocks([replace(first, place=there), replace(second, place=here)])


def test_repeated_distances_are_two_and_alike_ones_one(flights):
    _, (first, _) = flights
    bars = first.distances
    assert len(merge_blocks([first, first]).distances) == len(bars)
    longer = first.having(replace(bars, length=bars.length + 1e-3))
    assert len(merge_blocks([first, longer]).distances) == 2 * len(bars)
    planes = Planes(figure=("a",), point=np.zeros(1, np.int32), sigma=np.array([0.1]))
    with pytest.raises(InputError, match=r"planes\.csv.*0\.1.*0\.2.*merge\.contradiction"):
        merge_blocks([first.having(planes), first.having(replace(planes, sigma=np.array([0.2])))])


def test_what_no_file_may_hold_is_no_merged_block(flights):
    _, (first, _) = flights

    def sets(station, target):
        return first.having(
            Directions(
                set=("s",), station=np.array([station], np.int32), target=np.array([target], np.int32),
                angle=np.array([1.0]), sigma=np.array([1e-4]),
            )
        )  # fmt: skip

    with pytest.raises(InputError, match=r"(?s)directions\.csv.*2.*merge\.do_not_fit"):
        merge_blocks([sets(0, 1), sets(1, 2)])


def test_instruments_and_relations_are_matched_by_id():
    block = EXAMPLES["airborne"]()
    half = np.arange(len(block.images)) % 2 == 0
    one, two = (select_block(block, "image", m) for m in (half, ~half))
    turned = select_block(two, "instrument", np.arange(len(two.instruments))[::-1])
    merged = merge_blocks([one, turned])
    assert merged.instruments == block.instruments
    found = dict(zip(merged.stations.image.tolist(), merged.stations.antenna.tolist(), strict=True))
    given = dict(zip(block.stations.image.tolist(), block.stations.antenna.tolist(), strict=True))
    assert {merged.images.ids[i]: merged.instruments[a].id for i, a in found.items()} == {
        block.images.ids[i]: block.instruments[a].id for i, a in given.items()
    }
    other = replace(one.instruments[0], relations=(Relation(name="r", terms={"ax": 1.0}, sigma=1.0),))
    with pytest.raises(InputError, match=r"merge\.contradiction"):
        merge_blocks([one, replace(one, instruments=(other, *one.instruments[1:]))])


def test_rules_name_what_there_is(flights):
    _, (first, second) = flights
    assert merge_blocks([first]) is first
    for prefer in ({"cameras": 0}, {"camera": 2}):
        with pytest.raises(InputError, match=r"merge\.prefer_unknown"):
            merge_blocks([first, second], prefer=prefer)
    with pytest.raises(InputError, match=r"merge\.no_blocks"):
        merge_blocks([])


@pytest.mark.parametrize("unit", ["mm", "turned"])
def test_rounding_is_no_contradiction_and_nothing_stands_twice(unit):
    made = simulate(
        field_scene(TargetField(rows=4, columns=5, stations=4)),
        Survey(control=4, control_sigma=(1e-3, 1e-3, 1e-3), scale_bars=3, station_sigma=0.01),
    ).observed
    turn = np.array([[0.6, -0.8, 0.0], [0.8, 0.6, 0.0], [0.0, 0.0, 1.0]])
    there = (
        SimilarityTransform(scale=1 / 3, rotation=np.eye(3), translation=np.array([1000.0, -170.0, 3.0]))
        if unit == "mm"
        else SimilarityTransform(scale=1.0, rotation=turn, translation=np.array([1000.0, -170.0, 3.0]))
    )
    far = transform_block(made, there, observed="follow")
    near = transform_block(transform_block(far, there.inverse, observed="follow"), there, observed="follow")
    assert (near.points.xyz != far.points.xyz).any(), "rounded, or this says nothing"
    whole = merge_blocks([far, near])
    assert len(whole.distances) == len(made.distances)
    assert len(whole.stations) == len(made.stations)
    assert len(whole.observations) == len(made.observations)
    worse = replace(near, points=replace(near.points, xyz=near.points.xyz * (1 + 1e-9)))
    with pytest.raises(InputError, match=r"merge\.contradiction"):
        merge_blocks([far, worse])


def test_what_is_no_block_rule_or_rotation_is_refused(flights):
    block, _ = flights
    for wrong, words in (
        (lambda: merge_blocks(["folder", block]), r"merge\.no_block"),
        (lambda: merge_blocks([block, block], prefer="x"), r"merge\.prefer_no_mapping"),
        (lambda: transform_block(block, SimilarityTransform(), observed="folow"), r"transform\.observed_unknown"),
        (
            lambda: transform_block(block, SimilarityTransform(rotation=np.diag([1, 1, -1.0])), observed="stay"),
            r"transform\.rotation_mirrored",
        ),
        (
            lambda: transform_block(block, SimilarityTransform(rotation=2 * np.eye(3)), observed="stay"),
            r"1.*transform\.rotation_not_orthogonal",
        ),
    ):
        with pytest.raises(InputError, match=words):
            wrong()


@pytest.mark.parametrize("order", [1, -1])
def test_what_matching_measured_of_a_point_is_that_of_the_block_that_knows_it(order):
    block = simulate(field_scene(TargetField(rows=3, columns=4, stations=4)), Survey()).observed
    p = block.points
    half = np.where(np.arange(len(p)) % 2, 0.01, np.nan)
    known = replace(block, points=replace(p, window=half, sigma_curvature=np.full(len(p), 0.002)))
    made = merge_blocks([block, known][::order])
    np.testing.assert_array_equal(made.points.window, half)
    assert (made.points.sigma_curvature == 0.002).all()
