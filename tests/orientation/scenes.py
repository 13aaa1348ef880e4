"""Scenes for the tests of approximate values, and what an orientation is compared with."""

from dataclasses import replace

import numpy as np

from raybundle.block import Block, Camera
from raybundle.block.block import Images, Observations
from raybundle.block.select import with_rows
from raybundle.numerics.rotation import rotation_from_vector
from raybundle.numerics.transform import similarity
from raybundle.planning.simulate import Simulation, Survey, simulate
from raybundle.planning.synthetic_networks import Ring, Scene, brown_camera, look_at, ring_scene

ROOM = np.array([8.0, 6.0, 3.0])


def fisheye():
    c, pixel, half = 8.0, 0.006, np.radians(95)
    size = int(2 * c * half / pixel)
    values = {"c": c, "x0": 0.02, "y0": -0.03, "K1": -2e-4, "K2": 1e-6, "K3": 0.0, "P1": 0.0, "P2": 0.0}
    return Camera(
        id="1", model="fisheye", width_px=size, height_px=size, pixel_mm=(pixel, pixel), values=values,
        estimate=("c", "x0", "y0", "K1", "K2"),
    )  # fmt: skip


def panorama():
    c, pixel = 50.0, 0.01
    return Camera(
        id="1", model="panorama", width_px=round(2 * np.pi * c / pixel), height_px=9000, pixel_mm=(pixel, pixel),
        values={"c": c, "y0": 0.1, "e": 0.0, "K1": -3e-6}, estimate=("c", "y0"),
    )  # fmt: skip


def room(camera, stations, seed, points=400):
    """Points on the walls, floor and ceiling of a room, and upright stations within, turned anyhow."""
    rng = np.random.default_rng(3)
    xyz, face = rng.uniform(0, 1, (points, 3)), rng.integers(0, 6, points)
    xyz[np.arange(points), face // 2] = face % 2
    xyz = xyz * ROOM + rng.normal(0, 0.05, xyz.shape)
    rng = np.random.default_rng(seed)
    centre = rng.uniform(0.2, 0.8, (stations, 3)) * ROOM
    turn = rng.uniform(0, 2 * np.pi, stations)
    slope = np.zeros(stations) if camera.model == "panorama" else rng.uniform(-0.5, 0.5, stations)
    view = np.stack([np.cos(turn), np.sin(turn), slope], axis=1)
    tilt = rotation_from_vector(rng.normal(0, 0.05, (stations, 3)))
    return Scene(camera=camera, centre=centre, rotation=tilt @ look_at(centre, centre + view), xyz=xyz)


def both(a: Simulation, b: Simulation) -> tuple[Block, Block]:
    """Truth and observed block of two simulations of the same points, one after the other."""

    def joined(x: Block, y: Block) -> Block:
        n, ox, oy = len(x.images), x.observations, y.observations
        return replace(
            x,
            cameras=(replace(x.cameras[0], id="A"), replace(y.cameras[0], id="B")),
            images=Images(
                ids=tuple(f"a{i}" for i in x.images.ids) + tuple(f"b{i}" for i in y.images.ids),
                camera=np.concatenate([x.images.camera, y.images.camera + 1]),
                file=x.images.file + y.images.file,
                centre=np.vstack([x.images.centre, y.images.centre]),
                rotation=np.concatenate([x.images.rotation, y.images.rotation]),
            ),
            observations=Observations(
                image=np.concatenate([ox.image, oy.image + n]).astype(np.int32),
                point=np.concatenate([ox.point, oy.point]),
                xy_px=np.vstack([ox.xy_px, oy.xy_px]),
                cov_px2=np.vstack([ox.cov_px2, oy.cov_px2]),
            ),
        )

    truth, observed = joined(a.truth, b.truth), joined(a.observed, b.observed)
    keep = np.bincount(truth.observations.point, minlength=len(truth.points))[truth.observations.point] > 1
    return with_rows(truth, keep), with_rows(observed, keep)


def tie_block(scene: Scene, seed: int, factor: float, wrong: float, anywhere: float = 0.0):
    """A block as automatic matching gives it: truth, observed, wrong rays (m,).

    No control, the camera constant off by `factor`, no distortion known; `wrong` of the rays are off by up to
    300 px, and `anywhere` lie anywhere in the image.
    """
    s = simulate(scene, Survey(seed=seed, image_sigma_px=0.5, orientation="absent", interior="exact"))
    rng, o, camera = np.random.default_rng(seed), s.observed.observations, s.observed.cameras[0]
    m, size = len(o), [camera.width_px, camera.height_px]
    off, lost = rng.random(m) < wrong, rng.random(m) < anywhere
    direction, length = rng.uniform(0, 2 * np.pi, m), rng.uniform(20, 300, m)
    xy = o.xy_px + np.where(off, length, 0.0)[:, None] * np.stack([np.cos(direction), np.sin(direction)], axis=1)
    xy[lost] = rng.uniform(0, 1, (int(lost.sum()), 2)) * size
    values = {**dict.fromkeys(camera.values, 0.0), "c": camera.values["c"] * factor}
    block = replace(
        s.observed,
        cameras=(replace(camera, values=values, estimate=("c", "K1", "K2")),),
        observations=replace(o, xy_px=np.clip(xy, 0, size)),
    )
    return s.truth, block, off | lost


def facade(points, images, seed):
    """A wall with bays, photographed from a walk along it."""
    rng = np.random.default_rng(seed)
    xyz = rng.uniform([0, 0, -0.5], [40, 12, 0.5], (points, 3))
    xyz[:, 2] *= rng.random(points) < 0.3
    x = np.linspace(0, 40, images) + rng.normal(0, 0.5, images)
    centre = np.stack([x, rng.uniform(1.5, 1.8, images), 14 + rng.normal(0, 1, images)], axis=1)
    target = np.stack([x + rng.normal(0, 2, images), 6 + rng.normal(0, 1, images), np.zeros(images)], axis=1)
    rotation = look_at(centre, target, up=np.array([0.0, 1.0, 0.0]))
    return Scene(camera=brown_camera(), centre=centre, rotation=rotation, xyz=xyz)


def ring(points, stations=12, seed=7):
    return ring_scene(Ring(camera=brown_camera(), points=points, stations=stations, seed=seed))


def errors(truth: Block, found: Block) -> tuple[float, float]:
    """Largest error of a projection centre, as a share of their extent, and of a rotation [rad], after a similarity."""
    s = similarity(found.images.centre, truth.images.centre)
    extent = float(np.ptp(truth.images.centre, axis=0).max())
    turn = s.rotations(found.images.rotation) @ np.swapaxes(truth.images.rotation, 1, 2)
    angle = np.arccos(np.clip((np.trace(turn, axis1=1, axis2=2) - 1) / 2, -1, 1))
    return float(np.linalg.norm(s.residuals, axis=1).max()) / extent, float(angle.max())
