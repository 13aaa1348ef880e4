"""Few points, measured by hand: every candidate is carried to the end, and what is lacking is data."""

from dataclasses import replace

import numpy as np
import pytest

from raybundle.block import Block, Images, Observations, Points
from raybundle.block.known import observed_as_known
from raybundle.orientation.projective.manual_points import orient_few
from tests.measuring.hand_made import HAND_PX, Scene


def block_of(scene, images, points, seed=1):
    """The marks of some images and points, with the noise of a hand, without orientation."""
    rng = np.random.default_rng(seed)
    rows = [(i, p, scene.place(i, p)) for i in images for p in points]
    rows = [(i, p, xy + rng.normal(0, HAND_PX, 2)) for i, p, xy in rows if np.isfinite(xy).all()]
    n = len(scene.images)
    lens = {p.symbol: 0.0 for p in scene.camera.sensor.parameters}
    camera = replace(scene.camera, values={**lens, "c": 24.0}, estimate="auto", relations=())
    return Block(
        cameras=(observed_as_known(camera, {"c": 0.05}),),
        images=Images(
            ids=tuple(scene.images), camera=np.zeros(n, np.int32), file=("",) * n, centre=np.full((n, 3), np.nan),
            rotation=np.full((n, 3, 3), np.nan),
        ),
        observations=Observations(
            image=np.array([r[0] for r in rows], np.int32), point=np.array([r[1] for r in rows], np.int32),
            xy_px=np.array([r[2] for r in rows]), cov_px2=np.tile([HAND_PX**2, HAND_PX**2, 0.0], (len(rows), 1)),
        ),
        points=Points(
            ids=tuple(scene.names), role=np.zeros(len(scene.names), np.int32),
            xyz=np.full((len(scene.names), 3), np.nan), sigma=np.full((len(scene.names), 3), np.nan),
        ),
    )  # fmt: skip


def turn(found, scene, a, b):
    """Angle [deg] between the relative rotation that was found and the true one."""
    R, T = found.images.rotation, scene.rotation
    D = (R[b] @ R[a].T) @ (T[b] @ T[a].T).T
    return np.degrees(np.arccos(np.clip((np.trace(D) - 1) / 2, -1, 1)))


@pytest.mark.parametrize("seed", range(5))
def test_eight_points_of_two_photographs(seed):
    scene = Scene(seed=seed)
    found = orient_few(block_of(scene, (0, 1), range(8), seed))
    assert list(found.new) == [True, True, False, False]
    assert turn(found.block, scene, 0, 1) < 2.0
    assert [(k.image, k.kind, k.have, k.need) for k in found.lacking] == [
        ("old_3.jpg", "marks", 0, 4), ("old_4.jpg", "marks", 0, 4)
    ]  # fmt: skip


def test_what_is_given_of_cameras_is_kept():
    """Only values move; what was known before stays known."""
    scene = Scene()
    block = block_of(scene, range(4), range(13))
    found = orient_few(block)
    (old,), (new,) = block.cameras, found.block.cameras
    assert (new.relations, new.estimate, new.known) == (old.relations, old.estimate, old.known)
    assert new.values["c"] == pytest.approx(scene.camera.values["c"], rel=0.02)
    assert max(turn(found.block, scene, 0, k) for k in (1, 2, 3)) < 1.0


def test_photographs_from_one_place_have_no_base():
    scene = Scene(stations=2)
    scene.centre[1] = scene.centre[0]
    scene.rotation[1] = scene.rotation[0]
    found = orient_few(block_of(scene, (0, 1), range(13)))
    assert not found.new.any()
    (lack,) = found.lacking
    assert (lack.kind, lack.message.code) == ("base", "photograph.lacks_base")


def test_five_common_points_and_points_in_a_line():
    scene = Scene()
    found = orient_few(block_of(scene, (0, 1), range(5)))
    (first, *_) = found.lacking
    assert (first.image, first.other, first.kind, first.have, first.need) == ("old_1.jpg", "old_2.jpg", "common", 5, 6)
    scene.xyz[:6] = np.linspace([-3, -1, 0], [3, 1, 1], 6)
    block = block_of(scene, (0, 1), range(13))
    third = block_of(scene, (2,), range(6))
    o, t = block.observations, third.observations
    both = replace(
        o, image=np.concatenate([o.image, t.image]), point=np.concatenate([o.point, t.point]),
        xy_px=np.concatenate([o.xy_px, t.xy_px]), cov_px2=np.concatenate([o.cov_px2, t.cov_px2]),
    )  # fmt: skip
    found = orient_few(replace(block, observations=both))
    assert list(found.new) == [True, True, False, False]
    assert found.lacking[0].kind == "fit"
