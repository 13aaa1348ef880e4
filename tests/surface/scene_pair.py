"""Satellite scenes of a made-up terrain with a block of tie points and control, whose orientation has errors."""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from raybundle.block import Block, Images, Observations, Points, Role
from raybundle.io.block.folder import write_block
from raybundle.scenes.kinds.rpc import RpcSensor
from raybundle.scenes.sensor import scene_camera, view_of
from tests.scenes.render import PLACE, Terrain, octave, render_scene, scene_rpc, write_scene
from tests.scenes.render_sets import PITCH, SHIFTS

SIZE, TIES, CONTROL = 360, 150, 5
TIE_PX, MARK_PX, CONTROL_M = 0.1, 0.2, (0.1, 0.1, 0.15)


def hills():
    """Hills with texture down to pixels."""
    smooth = Terrain.made(half=450.0, relief=30.0)
    fine = octave(np.random.default_rng(2), len(smooth.grey), 2.0)
    return replace(smooth, grey=0.8 * smooth.grey + 0.6 * fine / fine.std())


def scene_block(names=("ahead", "behind", "nadir"), seed=5, size=SIZE, terrain=None, bias="shift"):
    """A block of scenes whose RPCs are wrong by their shifts, and the true RPCs."""
    terrain = terrain or hills()
    rng = np.random.default_rng(seed)
    true = [scene_rpc(PITCH[n], size) for n in names]
    sensors = [
        RpcSensor(rpc.shifted(-np.array(SHIFTS[n])), PLACE, (size, size), bias)
        for n, rpc in zip(names, true, strict=True)
    ]
    cameras = tuple(scene_camera(n, s) for n, s in zip(names, sensors, strict=True))
    half = 0.3 * size  # pixels of 0.7 m
    xyz = terrain.points(*rng.uniform(-half, half, (2, TIES + CONTROL)))
    image, point = (x.ravel() for x in np.meshgrid(np.arange(len(names)), np.arange(len(xyz)), indexing="ij"))
    xy = np.concatenate([rpc.project(PLACE.geographic_from_block(xyz)) for rpc in true])
    seen = ((xy > 3) & (xy < size - 3)).all(axis=1)
    sigma = np.where(point < CONTROL, MARK_PX, TIE_PX)
    xy = xy + rng.normal(0, 1, xy.shape) * sigma[:, None]
    given = np.full((len(xyz), 3), np.nan)
    given[:CONTROL] = CONTROL_M
    start = xyz + rng.normal(0, 1, xyz.shape) * np.where(np.isfinite(given), given, 1.0)
    views = [view_of(c) for c in cameras]
    block = Block(
        name="scenes", cameras=cameras, place=PLACE,
        images=Images(
            ids=tuple(names), camera=np.arange(len(names), dtype=np.int32), file=tuple(f"{n}.tif" for n in names),
            centre=np.array([v.centre for v in views]), rotation=np.array([v.rotation for v in views]),
            held=np.ones(len(names), bool),
        ),
        observations=Observations(
            image=image[seen].astype(np.int32), point=point[seen].astype(np.int32), xy_px=xy[seen],
            cov_px2=np.stack([sigma**2, sigma**2, 0 * sigma], axis=1)[seen],
        ),
        points=Points(
            ids=tuple(f"p{k}" for k in range(len(xyz))), xyz=start, sigma=given,
            role=np.where(np.arange(len(xyz)) < CONTROL, Role.CONTROL, Role.TIE),
        ),
    )  # fmt: skip
    return block, true


def write_scenes(folder, *, noise=12.0, size=SIZE, terrain=None, **options):
    """The images of such a block in a folder, and `block` beside them; the terrain that they show.

    noise  standard deviation of a grey value; those of the ground scatter by 150
    """
    terrain = terrain or hills()
    block, true = scene_block(size=size, terrain=terrain, **options)
    rng = np.random.default_rng(9)
    for k, (name, rpc) in enumerate(zip(block.images.ids, true, strict=True)):
        grey = render_scene(rpc, terrain, size, seed=k + 1) + rng.normal(0, noise, (size, size))
        pixels = np.clip(np.rint(grey), 1, 2047).astype(np.uint16)
        write_scene(folder, name, pixels, rpc)
    write_block(block, folder / "block")
    return terrain
