"""Simulated blocks: a scene, what is measured in it, and the truth beside it.

A *scene* is geometry without errors: a camera, stations and object points.  A *survey* states what is
measured, how well, and what is known beforehand.  Everything is drawn from one seeded generator, so the
same arguments give the same block on every machine.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, replace
from typing import Literal

import numpy as np

from raybundle.block.block import (
    Block,
    Camera,
    Distances,
    Images,
    Observations,
    Points,
    Role,
    Stations,
)
from raybundle.block.select import select_block
from raybundle.errors import InputError
from raybundle.numerics.arrays import Array, Index, Mask
from raybundle.numerics.rotation import rotation_from_vector
from raybundle.objects.surface import farthest_first
from raybundle.planning.synthetic_networks import Scene
from raybundle.sensors import SensorModel, sensor_models

Start = Literal["exact", "approximate", "absent"]

TOGETHER = 20_000
"""Points that are projected at a time"""
NEWTON, SETTLED = 20, 1e-13
"""Steps to an image point, and the step by which it has settled, as a share of it [or mm]"""


@dataclass(frozen=True, slots=True, kw_only=True)
class Survey:
    """What is measured, how well, and what is known beforehand."""

    seed: int = 1
    image_sigma_px: float = 0.1
    """Standard deviation of an image coordinate."""
    control: int = 0
    """Number of control points, well spread."""
    control_sigma: tuple[float, float, float] = (0.0, 0.0, 0.0)
    """0 = held; NaN = this coordinate is not given (XY-only, Z-only control)."""
    check: int = 0
    """Number of check points, spread between the control points."""
    check_sigma: float = 0.0
    scale_bars: int = 0
    """Number of distances between far points."""
    scale_bar_sigma: float = 1e-4
    station_sigma: float | None = None
    """Standard deviation of observed projection centres; None: none observed."""
    orientation: Start = "approximate"
    """Exterior orientation given at the start."""
    points: Start = "absent"
    """Coordinates of tie points given at the start."""
    interior: Literal["exact", "nominal"] = "nominal"
    """nominal: c two per cent off, all other estimated parameters 0."""
    approximate: float = 0.02
    """Error of approximate values: this share of the object distance, and this many radians."""
    gross_share: float = 0.0
    """Share of the image points that get a gross error."""
    gross_px: float = 20.0
    """Its size, in a random direction."""
    least_rays: int = 2
    """Tie points with fewer rays are left out."""


@dataclass(frozen=True, slots=True, kw_only=True)
class Simulation:
    """A simulated block and the truth beside it; both have the same images, points and rows."""

    truth: Block
    """Exact values everywhere; control and distances without errors."""
    observed: Block
    """What an adjustment is given."""
    gross: Mask
    """(m,) image observations with a gross error."""


def project(scene: Scene, image: int) -> tuple[Index, Array]:
    """The points that image number `image` shows: their positions (k,) and pixel coordinates (k, 2)."""
    rows, local = _near(scene, image)
    pixel, inside = _within(scene.camera, local)
    return rows[inside], pixel[inside]


def _near(scene: Scene, image: int) -> tuple[Index, Array]:
    """Points that an image may show, distortion apart: their positions (k,), and in the sensor frame (3, k)."""
    model = sensor_models[scene.camera.model]
    values = np.array([scene.camera.values.get(s, 0.0) for s in model.symbols])
    sight = scene.xyz - scene.centre[image]
    local = (scene.rotation[image] @ sight.T).astype(float)
    seen = model.in_front(local)
    if scene.normal is not None:
        slant = -np.sum(sight * scene.normal, axis=1) / np.linalg.norm(sight, axis=1)
        seen &= slant > 0.3  # flatter than 73 degrees off the normal a target cannot be measured
    rows = np.flatnonzero(seen)
    with np.errstate(all="ignore"):
        guess = scene.camera.pixel_from_image(model.start(local[:, rows], values).T)
    size = np.array([scene.camera.width_px, scene.camera.height_px], float)
    near = (np.abs(guess - size / 2) < 0.75 * size).all(axis=1)  # a margin for the distortion
    rows = rows[near]
    return rows.astype(np.int32), local[:, rows]


def _within(camera: Camera, local: Array) -> tuple[Array, Mask]:
    """Pixel coordinates (n, 2) of points (3, n) in the sensor frame, and which of them the format holds."""
    model = sensor_models[camera.model]
    values = np.array([camera.values.get(s, 0.0) for s in model.symbols])
    found = [
        camera.pixel_from_image(_images_of(local[:, k : k + TOGETHER], model, values).T)
        for k in range(0, max(local.shape[1], 1), TOGETHER)
    ]
    pixel = np.concatenate(found)
    with np.errstate(invalid="ignore"):
        inside = (pixel >= 0) & (pixel <= [camera.width_px, camera.height_px])
    return pixel, np.asarray(inside.all(axis=1))


def _images_of(points: Array, model: SensorModel, values: Array) -> Array:
    """Image points (2, n) [mm]; NaN beyond the radius up to which the distortion is one-to-one."""
    image = model.start(points, values)
    going = np.flatnonzero(np.isfinite(image).all(axis=0))
    with np.errstate(all="ignore"):
        for _ in range(NEWTON):  # for all at once; those that do not settle are not shown
            g, jacobian = model.condition_and_jacobian(*image[:, going], *points[:, going], *values)
            (a, b), (c, d) = jacobian[:, :2]
            step = np.stack([d * g[0] - b * g[1], a * g[1] - c * g[0]]) / (a * d - b * c)
            image[:, going] -= step
            going = going[np.abs(step).max(axis=0) > SETTLED * (1 + np.abs(image[:, going]).max(axis=0))]
            if not len(going):
                break
        g, jacobian = model.condition_and_jacobian(*image, *points, *values)
        (a, b), (c, d) = jacobian[:, :2]
        good = (np.abs(g).max(axis=0) < 1e-9) & (a * d - b * c > 0)
    shown = np.full_like(image, np.nan)
    shown[:, good] = model.solve(points[:, good], values, image[:, good])[0]
    return shown


def simulate(scene: Scene, survey: Survey) -> Simulation:
    """The block that a survey of a scene gives, and the truth.

    Points are numbered from 1, images "1", "2" ...; points with fewer rays than asked for are left out.
    raises  InputError where the scene leaves nothing to observe or fewer points than control and check need
    """
    rng = np.random.default_rng(survey.seed)
    scene, image, point, xy = _visible(scene, survey)
    role = _roles(scene, survey)
    truth = _truth(scene, survey, image, point, xy, role)
    noise = rng.normal(0, survey.image_sigma_px, xy.shape)
    gross, error = gross_errors(len(xy), survey, rng)
    measured = xy + noise + error
    observed = replace(
        truth,
        cameras=(_start_camera(scene.camera, survey),),
        images=start_images(truth.images, scene.xyz, survey, rng),
        observations=replace(truth.observations, xy_px=measured),
        points=start_points(truth.points, survey, rng),
    ).having(
        truth.distances.with_errors(rng),
        truth.stations.with_errors(rng),
    )
    return Simulation(truth=truth, observed=observed, gross=gross)


def _visible(scene: Scene, survey: Survey) -> tuple[Scene, Index, Index, Array]:
    """The scene without points of too few rays, and all its image points."""
    near = [_near(scene, k) for k in range(len(scene.centre))]
    xy, inside = _within(scene.camera, np.concatenate([local for _, local in near], axis=1))
    image = np.repeat(np.arange(len(near), dtype=np.int32), [len(rows) for rows, _ in near])[inside]
    point, xy = np.concatenate([rows for rows, _ in near])[inside], xy[inside]
    rays = np.bincount(point, minlength=len(scene.xyz))
    keep = rays >= min(survey.least_rays, len(scene.centre))
    new = (np.cumsum(keep) - 1).astype(np.int32)
    rows = keep[point]
    normal = None if scene.normal is None else scene.normal[keep]
    scene = replace(scene, xyz=scene.xyz[keep], normal=normal)
    if len(scene.xyz) < max(3, survey.control + survey.check, 2 * survey.scale_bars):
        raise InputError(
            "simulation.too_few_points",
            n=len(scene.xyz),
            rays=survey.least_rays,
            control=survey.control,
            check=survey.check,
            bars=survey.scale_bars,
        )
    return scene, image[rows], new[point[rows]], xy[rows]


def _roles(scene: Scene, survey: Survey) -> Index:
    role = np.full(len(scene.xyz), Role.TIE, np.int32)
    spread = farthest_first(scene.xyz, survey.control + survey.check)
    role[spread[: survey.control]] = Role.CONTROL
    role[spread[survey.control :]] = Role.CHECK
    return role


def _truth(scene: Scene, survey: Survey, image: Index, point: Index, xy: Array, role: Index) -> Block:
    n, p = len(scene.centre), len(scene.xyz)
    sigma = np.full((p, 3), np.nan)
    sigma[role == Role.CONTROL] = survey.control_sigma
    sigma[role == Role.CHECK] = survey.check_sigma
    variance = survey.image_sigma_px**2
    stations = Stations.empty()
    if survey.station_sigma is not None:
        all_images = np.arange(n, dtype=np.int32)
        stations = Stations(image=all_images, xyz=scene.centre.copy(), sigma=np.full((n, 3), survey.station_sigma))
    return Block(
        name=scene.name,
        about=f"simulated: {n} images, {p} points, {len(xy)} image points of {survey.image_sigma_px:g} px",
        source=f"raybundle simulation, seed {survey.seed}",
        length_unit=scene.length_unit,
        cameras=(scene.camera,),
        images=Images(
            ids=tuple(str(k + 1) for k in range(n)),
            camera=np.zeros(n, np.int32),
            centre=scene.centre,
            rotation=scene.rotation,
        ),
        observations=Observations(
            image=image, point=point, xy_px=xy, cov_px2=np.tile([variance, variance, 0.0], (len(xy), 1))
        ),
        points=Points(ids=tuple(str(k + 1) for k in range(p)), role=role, xyz=scene.xyz, sigma=sigma),
    ).having(_scale_bars(scene, survey), stations)


def _scale_bars(scene: Scene, survey: Survey) -> Distances:
    """Distances between far points, no point twice."""
    if survey.scale_bars == 0:
        return Distances.empty()
    ends = farthest_first(scene.xyz, 2 * survey.scale_bars).reshape(-1, 2).astype(np.int32)
    length = np.linalg.norm(scene.xyz[ends[:, 0]] - scene.xyz[ends[:, 1]], axis=1)
    sigma = np.full(len(ends), survey.scale_bar_sigma)
    return Distances(start=ends[:, 0].copy(), end=ends[:, 1].copy(), length=length, sigma=sigma)


def _start_camera(camera: Camera, survey: Survey) -> Camera:
    if survey.interior == "exact":
        return camera
    free = camera.estimate if camera.estimate != "auto" else tuple(camera.values)
    scale = {p.symbol for p in sensor_models[camera.model].parameters if p.kind == "scale"}
    nominal = {s: (round(v * 0.98, 1) if s in scale else 0.0) for s, v in camera.values.items() if s in free}
    return replace(camera, values={**camera.values, **nominal})


def gross_errors(count: int, survey: Survey, rng: np.random.Generator) -> tuple[Mask, Array]:
    """Which of so many image points have a gross error, and the errors (count, 2) [px], 0 where there is none."""
    gross = rng.random(count) < survey.gross_share
    direction = rng.uniform(0, 2 * np.pi, count)
    error = survey.gross_px * np.stack([np.cos(direction), np.sin(direction)], axis=1)
    return gross, np.where(gross[:, None], error, 0.0)


def start_images(images: Images, xyz: Array, survey: Survey, rng: np.random.Generator) -> Images:
    """Stations as they are given at the start of the adjustment of points (t, 3)."""
    n = len(images)
    move, turn = rng.normal(0, 1, (2, n, 3)) * survey.approximate
    if survey.orientation == "exact":
        return images
    if survey.orientation == "absent":
        return replace(images, centre=np.full((n, 3), np.nan), rotation=np.full((n, 3, 3), np.nan))
    distance = np.linalg.norm(images.centre - xyz.mean(axis=0), axis=1, keepdims=True)
    return replace(
        images, centre=images.centre + move * distance, rotation=rotation_from_vector(turn) @ images.rotation
    )


def start_points(points: Points, survey: Survey, rng: np.random.Generator) -> Points:
    """Control and check with their errors, tie points as far as they are known at the start."""
    error = rng.normal(0, 1, points.xyz.shape)
    extent = float(np.ptp(points.xyz, axis=0).max())
    given = points.xyz + np.where(np.isfinite(points.sigma), points.sigma, 0.0) * error
    given[np.isnan(points.sigma)] = np.nan
    tie = np.asarray(points.role) == Role.TIE
    start = {
        "exact": points.xyz,
        "approximate": points.xyz + survey.approximate * extent * error,
        "absent": np.full_like(points.xyz, np.nan),
    }[survey.points]
    return replace(points, xyz=np.where(tie[:, None], start, given))


def measured(block: Block, sigma_px: Mapping[str, float] | float, least_rays: int = 2) -> Block:
    """A block with the exact image points of all its points in all its images, of any sensor.

    block       with true values everywhere; its observations are replaced
    sigma_px    standard deviation of an image coordinate, for all or by camera id
    least_rays  points other than control with fewer are left out
    A point stands behind nothing here: every image shows all points within its format and in front of its sensor.
    """
    parts = [shown(block, i) for i in range(len(block.images))]
    image = np.repeat(np.arange(len(parts), dtype=np.int32), [len(rows) for rows, _ in parts])
    by_camera = [sigma_px[c.id] if isinstance(sigma_px, Mapping) else sigma_px for c in block.cameras]
    point, p = np.concatenate([rows for rows, _ in parts]), block.points
    keep = (np.bincount(point, minlength=len(p)) >= least_rays) | (np.asarray(p.role) == Role.CONTROL)
    variance = np.array(by_camera)[block.images.camera[image]] ** 2
    seen = Observations(
        image=image, point=point.astype(np.int32), xy_px=np.concatenate([pixel for _, pixel in parts]),
        cov_px2=np.stack([variance, variance, np.zeros(len(variance))], axis=1),
    )  # fmt: skip
    return select_block(replace(block, observations=seen), "point", keep)


def shown(block: Block, image: int) -> tuple[Index, Array]:
    """The points that an image of a block shows: their positions (k,) and pixel coordinates (k, 2)."""
    camera = block.cameras[int(block.images.camera[image])]
    own = block.images.interior.get(image, {})
    values = np.array([own.get(s, camera.values.get(s, 0.0)) for s in camera.sensor.symbols])
    local = block.images.rotation[image] @ (block.points.xyz - block.images.centre[image]).T
    rows = np.flatnonzero(camera.sensor.in_front(local, None, values))
    found = camera.pixel_from_image(_images_of(local[:, rows], camera.sensor, values).T)
    with np.errstate(invalid="ignore"):
        inside = ((found >= 0) & (found <= [camera.width_px, camera.height_px])).all(axis=1)
    return rows[inside].astype(np.int32), found[inside]
