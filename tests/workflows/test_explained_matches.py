"""Photographs that their verified matches contradict: stretched, enlarged, misplaced."""

from dataclasses import replace

import numpy as np
import pytest

from raybundle.block.block import PixelFrame
from raybundle.block.frames import file_from_camera
from raybundle.matching.verify import VerifiedPair
from raybundle.numerics.rotation import rotation_from_vector
from raybundle.planning.simulate import Survey, simulate
from raybundle.planning.synthetic_networks import Ring, brown_camera, ring_scene
from raybundle.ties.explained_matches import best_shares, pair_fits, unexplained_notice

CAMERA = brown_camera(size_px=(3000, 2000), pixel_mm=0.008)


@pytest.fixture(scope="module")
def truth():
    scene = ring_scene(Ring(camera=CAMERA, stations=7, rings=1, points=300))
    block = simulate(scene, Survey(seed=3, image_sigma_px=0.5)).truth
    return replace(block, images=replace(block.images, file=tuple(f"{i}.jpg" for i in block.images.ids)))


def features(block, seed=1):
    """Places (n, 2) of all points in each image, and the pairs of images that share forty and more."""
    o, rng = block.observations, np.random.default_rng(seed)
    row = np.full((len(block.images), len(block.points)), -1)
    xy = []
    for i in range(len(block.images)):
        mine = np.flatnonzero(o.image == i)
        row[i, o.point[mine]] = np.arange(len(mine))
        xy.append(o.xy_px[mine] + rng.normal(0, 0.5, (len(mine), 2)))
    pairs = []
    for i in range(len(xy)):
        for j in range(i + 1, len(xy)):
            both = np.flatnonzero((row[i] >= 0) & (row[j] >= 0))
            matches = np.stack([row[i, both], row[j, both]], axis=1)
            pairs.append(
                VerifiedPair(
                    first=i, second=j, matches=matches, candidates=len(both), geometry="general", planar_share=0.2,
                    displacement_px=100.0,
                )
            )  # fmt: skip
    return xy, [p for p in pairs if len(p.matches) >= 40]


def shares(block, xy, pairs):
    return best_shares(pair_fits(block, block.images.file, xy, pairs), len(block.images))


def notices(block, xy, pairs, names=None):
    return unexplained_notice(block, pair_fits(block, names or block.images.file, xy, pairs))


def test_right_photographs_are_explained(truth):
    xy, pairs = features(truth)
    assert shares(truth, xy, pairs).min() > 0.98
    assert notices(truth, xy, pairs) == ()


def test_a_stretched_photograph_is_named(truth):
    xy, pairs = features(truth)
    xy[3] = (xy[3] - [1500, 1000]) * [1.25, 1] + [1500, 1000]
    (notice,) = notices(truth, xy, pairs)
    assert notice.ids == (truth.images.ids[3],)
    assert notice.values["median"] > 0.98


def test_photographs_that_are_stored_turned_are_explained(truth):
    xy, pairs = features(truth)
    frames = {
        1: PixelFrame(turned=90, width_px=2000, height_px=3000),
        4: PixelFrame(turned=180, width_px=3000, height_px=2000),
    }
    for k, frame in frames.items():
        xy[k] = file_from_camera(xy[k], truth.cameras[0], frame)
    block = replace(truth, images=replace(truth.images, frames=frames))
    assert shares(truth, xy, pairs).min() < 0.5
    assert shares(block, xy, pairs).min() > 0.98


def test_a_misplaced_photograph_is_named_and_one_that_is_missing_is_not_needed(truth):
    xy, pairs = features(truth)
    rotation = np.array(truth.images.rotation)
    rotation[2] = rotation_from_vector(np.array([0.03, 0.05, 0.0])) @ rotation[2]
    block = replace(truth, images=replace(truth.images, rotation=rotation))
    names = [*truth.images.file[:-1], "elsewhere.jpg"]
    (notice,) = notices(block, xy, pairs, names)
    assert notice.ids == (truth.images.ids[2],)
