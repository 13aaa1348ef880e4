"""Photographs in parts: each is oriented, control joins what it places, and the rest stays apart and is told."""

from dataclasses import replace
from pathlib import Path
from types import SimpleNamespace

import numpy as np
import pytest

from raybundle.adjustment.decision.decide import decide
from raybundle.adjustment.records.options import AdjustmentOptions
from raybundle.block import Role
from raybundle.block.select import with_rows
from raybundle.block.transform import transform_block
from raybundle.io.geo.control_files import ControlFile, Measurements
from raybundle.numerics.rotation import rotation_from_angles
from raybundle.numerics.transform import SimilarityTransform
from raybundle.placing.georeference import Georeferenced
from raybundle.placing.marks import Given
from raybundle.placing.positions import Positions, turn_sigma
from raybundle.planning.simulate import Survey, simulate
from raybundle.planning.synthetic_networks import AerialStrips, aerial_scene
from raybundle.workflows.orienting.connected_components import (
    FEWEST_IMAGES,
    apart_notice,
    joined_notice,
    merged,
    place_components,
    start_components,
)


@pytest.fixture(scope="module")
def flight():
    """Two strips with points of their own only, each in a system of its own, and marks of points in both."""
    scene = aerial_scene(AerialStrips(strips=2, images_per_strip=5, points_per_image=120, side_overlap=0.35))
    simulation = simulate(scene, Survey(image_sigma_px=0.1, interior="exact"))
    truth = simulation.truth
    o = simulation.observed.observations
    second = o.image >= 5
    shared = np.intersect1d(o.point[second], o.point[~second])
    free = replace(
        truth,
        observations=o,
        points=replace(
            truth.points,
            role=np.zeros(len(truth.points), np.int32),
            sigma=np.full_like(truth.points.xyz, np.nan),
        ),
    )
    own = ~np.isin(o.point, shared)
    parts = []
    for k, mine in enumerate((~second, second)):
        part = with_rows(free, own & mine)
        there = np.arange(10) // 5 == k
        part = replace(
            part,
            images=replace(
                part.images,
                centre=np.where(there[:, None], part.images.centre, np.nan),
                rotation=np.where(there[:, None, None], part.images.rotation, np.nan),
            ),
        )
        turn = rotation_from_angles(np.array([0.4, -0.3, 1.0 + k]))
        parts.append(
            transform_block(
                part,
                SimilarityTransform(scale=0.01 * (k + 1), rotation=turn, translation=np.array([k, 2.0, 3.0])),
                observed="stay",
            )
        )
    photos = [
        SimpleNamespace(
            name=name, width_px=truth.cameras[0].width_px, height_px=truth.cameras[0].height_px, orientation=1,
            metadata=SimpleNamespace(gps=None),
        )
        for name in truth.images.ids
    ]  # fmt: skip
    return SimpleNamespace(truth=truth, free=free, parts=parts, photos=photos, own=own, shared=shared)


def control(flight, images):
    """Control at points that these images see well: four of each strip, marked where they were observed."""
    o = flight.free.observations
    chosen: list[int] = []
    for strip in (0, 1):
        seen = np.isin(o.image, images) & (o.image // 5 == strip)
        rays = np.bincount(o.point[seen], minlength=len(flight.truth.points))
        candidates = np.flatnonzero(rays >= 3)
        xyz = flight.truth.points.xyz[candidates]
        corners = ([-1, -1], [1, 1], [-1, 1], [1, -1]) if len(candidates) else ()
        chosen += [int(candidates[np.argmax((xyz[:, :2] * corner).sum(axis=1))]) for corner in corners]
    chosen = list(dict.fromkeys(chosen))
    rows = np.flatnonzero(np.isin(o.point, chosen) & np.isin(o.image, images))
    return ControlFile(
        path=Path("control.csv"), crs=None, ids=tuple(f"G{k}" for k in range(len(chosen))),
        xyz=flight.truth.points.xyz[chosen], sigma=np.full((len(chosen), 3), 0.01),
        role=np.full(len(chosen), Role.CONTROL, np.int32),
        measurements=Measurements(
            image=tuple(flight.truth.images.ids[i] for i in o.image[rows]),
            point=np.array([chosen.index(p) for p in o.point[rows]], np.int32),
            xy_px=o.xy_px[rows],
            line=np.arange(len(rows), dtype=np.int32),
        ),
    )  # fmt: skip


def test_control_in_both_parts_joins_them(flight):
    given = Given(control=(control(flight, np.arange(10)),), sigma_given=True)
    placed, apart = place_components(flight.parts, flight.photos, given)
    assert not apart
    assert placed.block.images.oriented.all()
    (told,) = joined_notice(placed.joined, placed.block)
    assert told.code == "parts_joined"
    assert told.values["parts"] == 2
    # of photographs that the adjustment leaves out nothing is said
    images, (first, second) = placed.block.images, placed.joined
    kept = np.array([n in first for n in images.ids])
    left = replace(images, centre=np.where(kept[:, None], images.centre, np.nan))
    assert len(first) + len(second) == images.oriented.sum()
    assert joined_notice(placed.joined, replace(placed.block, images=left)) == ()
    assert np.linalg.norm(placed.block.images.centre - flight.truth.images.centre, axis=1).max() < 2.0
    assert placed.marked.sum() == len(given.control[0].ids)
    assert len(set(placed.block.points.ids)) == len(placed.block.points)
    result = decide(placed.block, AdjustmentOptions(jobs=1, reject="snooping"))
    assert result.sigma0 == pytest.approx(1.0, abs=0.1)
    error = result.adjusted.images.centre - flight.truth.images.centre
    std = np.sqrt(np.diagonal(result.precision.images[:, :3, :3], axis1=1, axis2=2))
    assert np.abs(error / std).max() < 4.5


def test_a_part_without_control_stays_apart_and_is_told(flight):
    given = Given(control=(control(flight, np.arange(5)),), sigma_given=True)
    placed, apart = place_components(flight.parts, flight.photos, given)
    assert len(apart) == 1
    assert placed.block.images.oriented.tolist() == [True] * 5 + [False] * 5
    assert apart[0].block.images.oriented.tolist() == [False] * 5 + [True] * 5
    assert not apart[0].fixed
    told = apart_notice(placed.block, apart, ["result-2"])
    assert "2 parts" in told.text
    assert (told.code, told.variant, told.values) == ("parts_apart", "", {"what": "photograph", "parts": 2, "n": 5})
    (part,) = told.details
    assert (part.code, part.values["folder"], part.values["photographs"]) == ("parts_apart.part", "result-2", 5)
    assert set(told.ids) == set(flight.truth.images.ids[5:])
    decide(apart[0].block, AdjustmentOptions(jobs=1))


def test_what_is_apart_is_called_by_its_name(flight):
    """One scene and panoramas are no photographs."""
    placed, apart = place_components(flight.parts, flight.photos, Given(control=(control(flight, np.arange(5)),)))
    photograph = placed.block.cameras[0]
    scene = replace(photograph, id="scene", scene=photograph.sensor)
    panorama = replace(photograph, id="pano", model="panorama")
    images = placed.block.images
    of_scene = replace(
        placed.block, cameras=(scene, photograph), images=replace(images, camera=np.array([0] + [1] * 9, np.int32))
    )
    (mixed,) = apart_notice(placed.block, [replace(apart[0], block=of_scene)], ["result-2"]).details
    assert (mixed.values["scenes"], mixed.values["photographs"], mixed.values["panoramas"]) == (1, 4, 0)
    alone = replace(of_scene, images=replace(of_scene.images, camera=np.zeros(10, np.int32)))
    of_panoramas = replace(apart[0], block=replace(apart[0].block, cameras=(panorama,)))
    told = apart_notice(alone, [of_panoramas], ["result-2"])
    assert (told.code, told.variant) == ("parts_apart", "scenes")
    assert told.values == {"what": "image", "parts": 2, "n": 5}
    assert (told.details[0].values["folder"], told.details[0].values["panoramas"]) == ("result-2", 5)


def test_without_control_nothing_is_joined(flight):
    _, apart = place_components(flight.parts, flight.photos, Given())
    assert len(apart) == 1


def test_merging_keeps_every_observation_and_one_point_of_each_name(flight):
    whole = merged(flight.parts)
    assert len(whole.observations) == sum(len(p.observations) for p in flight.parts)
    names = [n for p in flight.parts for n in p.points.ids]
    assert set(whole.points.ids) == set(names)
    o = whole.observations
    first = flight.parts[0].observations
    assert [whole.points.ids[k] for k in o.point[: len(first)]] == [flight.parts[0].points.ids[k] for k in first.point]


def test_every_part_of_a_set_of_tracks_is_oriented(flight):
    block = with_rows(flight.free, flight.own)
    raw = replace(
        block,
        images=replace(
            block.images, centre=np.full((10, 3), np.nan), rotation=np.full((10, 3, 3), np.nan)
        ),
        points=replace(block.points, xyz=np.full((len(block.points), 3), np.nan)),
    )  # fmt: skip
    ones = np.ones(len(raw.observations))
    parts = start_components(raw, ones, 0 * ones, 1)
    assert len(parts) == 2
    oriented = np.array([p.block.images.oriented for p in parts])
    assert oriented.sum(axis=0).tolist() == [1] * 10
    assert not parts[0].not_oriented
    for p in parts:
        assert len(p.scale_px) == len(p.block.observations)
        assert p.block.images.oriented.sum() >= FEWEST_IMAGES


def test_two_photographs_are_no_part(flight):
    o = flight.free.observations
    block = with_rows(flight.free, flight.own & np.isin(o.image, [0, 1, 2, 3, 4, 5, 6]))
    raw = replace(
        block,
        images=replace(block.images, centre=np.full((10, 3), np.nan), rotation=np.full((10, 3, 3), np.nan)),
        points=replace(block.points, xyz=np.full((len(block.points), 3), np.nan)),
    )
    ones = np.ones(len(raw.observations))
    parts = start_components(raw, ones, 0 * ones, 1)
    assert len(parts) == 1
    lost = dict(parts[0].not_oriented)
    assert {flight.truth.images.ids[5], flight.truth.images.ids[6]} <= set(lost)


def test_a_part_on_positions_in_a_line_is_not_joined(flight, monkeypatch):
    """How it turns about that line nothing tells; joined, its photographs would leave the adjustment one by one."""
    asked = []

    def placed(block, photos, given, around=None):
        asked.append(given.gps)
        second = block is flight.parts[1]
        return Georeferenced(
            block=block, frame=None, notices=(), marked=np.zeros(len(block.points), bool), fixed=given.gps,
            firm=not second,
        )  # fmt: skip

    monkeypatch.setattr("raybundle.workflows.orienting.connected_components.georeference", placed)
    whole, apart = place_components(flight.parts, flight.photos, Given())
    assert asked == [True, True, False]
    assert whole.block.images.oriented.tolist() == [True] * 5 + [False] * 5
    assert len(apart) == 1
    assert not apart[0].fixed


def test_positions_in_a_line_do_not_tell_the_turn_about_it():
    def positions(xyz, sigma=0.5):
        n = len(xyz)
        return Positions(
            image=np.arange(n), xyz=np.array(xyz), sigma=np.full((n, 3), sigma), flight=np.zeros(n, int), flights=1,
            assumed=np.zeros(n, bool),
        )  # fmt: skip

    line = [[20.0 * k, 0.01 * (-1) ** k, 80.0] for k in range(6)]
    assert turn_sigma(positions(line)) > 10
    zigzag = [[20.0 * k, 10.0 * (-1) ** k, 80.0] for k in range(6)]
    assert turn_sigma(positions(zigzag)) == pytest.approx(0.5 / (10 * np.sqrt(6)), rel=0.05)
    assert turn_sigma(positions([[x, y, np.nan] for x, y, _ in zigzag])) == np.inf
