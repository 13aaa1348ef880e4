"""Simulated blocks: a scene, what is measured in it, and the truth beside it.

A *scene* is geometry without errors: a camera, stations and object points.  A *survey* says what is
measured, how well, and what is known beforehand.  Everything is drawn from one seeded generator, so the
same arguments give the same block on every machine.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field, replace
from typing import Literal

import numpy as np

from raybundle.block.block import (
    Block,
    Camera,
    Distances,
    Images,
    LengthUnit,
    Observations,
    Points,
    Role,
    Stations,
)
from raybundle.errors import InputError
from raybundle.numerics.arrays import Array, Index, Mask
from raybundle.numerics.rotation import rotation_from_vector
from raybundle.sensors import SensorModel, sensor_models

Start = Literal["exact", "approximate", "absent"]


@dataclass(frozen=True, slots=True, kw_only=True)
class Scene:
    """Geometry without errors."""

    camera: Camera
    """With true values."""
    centre: Array
    """(n, 3) projection centres."""
    rotation: Array
    """(n, 3, 3) object axes to image axes."""
    xyz: Array
    """(p, 3) object points."""
    normal: Array | None = None
    """(p, 3) outward surface normals; a point is seen only from its outer side.  None: from everywhere."""
    name: str = "simulated"
    length_unit: LengthUnit = "m"


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


def brown_camera(
    *,
    values: Mapping[str, float] | None = None,
    size_px: tuple[int, int] = (6000, 4000),
    pixel_mm: float = 0.004,
    estimate: tuple[str, ...] = ("c", "x0", "y0", "K1", "K2", "K3", "P1", "P2"),
) -> Camera:
    """A camera with 24 mm x 16 mm format and the distortion of a good 20 mm lens, unless told otherwise."""
    lens = {"c": 20.4, "x0": 0.041, "y0": -0.063, "K1": 2.1e-4, "K2": -4.2e-7, "K3": 3.0e-10, "P1": 9e-6, "P2": -6e-6}
    return Camera(
        id="1",
        model="brown",
        width_px=size_px[0],
        height_px=size_px[1],
        pixel_mm=(pixel_mm, pixel_mm),
        values={"A": 0.0, "S": 0.0, **lens, **(values or {})},
        estimate=estimate,
    )


@dataclass(frozen=True, slots=True, kw_only=True)
class TargetField:
    """Convergent images of a field of targets, rolled by quarter turns."""

    camera: Camera = field(default_factory=brown_camera)
    size: tuple[float, float] = (2.4, 1.6)
    """Width and height of the field (X, Y)."""
    depth: float = 0.4
    """Height of the relief; 0 = a flat field."""
    rows: int = 10
    columns: int = 14
    stations: int = 16
    """On a circle round the field, besides `frontal` ones."""
    frontal: int = 4
    """Images squarely in front of the field."""
    tilt_deg: float = 35.0
    """Angle between the view from the circle and the field's normal."""
    distance: float = 2.2
    roll_deg: tuple[float, ...] = (0.0, 90.0, 180.0, 270.0)
    """Taken in turn."""
    seed: int = 7
    """Of the relief and the freehand scatter of the stations."""


@dataclass(frozen=True, slots=True, kw_only=True)
class AerialStrips:
    """Parallel strips of vertical images over hilly ground; flown there and back."""

    camera: Camera = field(
        default_factory=lambda: brown_camera(
            values={"c": 50.0, "x0": 0.0, "y0": 0.0, "K1": 0.0, "K2": 0.0, "K3": 0.0, "P1": 0.0, "P2": 0.0},
            size_px=(10000, 7500),
            pixel_mm=0.005,
            estimate=(),
        )
    )
    height: float = 800.0
    """Above mean ground."""
    relief: float = 40.0
    strips: int = 3
    images_per_strip: int = 6
    forward_overlap: float = 0.6
    side_overlap: float = 0.3
    points_per_image: int = 60
    wobble_deg: float = 2.0
    """Scatter of omega, phi and kappa."""
    seed: int = 7


@dataclass(frozen=True, slots=True, kw_only=True)
class Ring:
    """Stations on rings round a cylinder; a point is seen only from its own side."""

    camera: Camera = field(default_factory=brown_camera)
    radius: float = 1.0
    height: float = 2.0
    distance: float = 4.0
    """Of the stations from the axis."""
    stations: int = 16
    """On each ring."""
    rings: int = 2
    points: int = 300
    roll_deg: tuple[float, ...] = (0.0, 90.0)
    seed: int = 7


@dataclass(frozen=True, slots=True, kw_only=True)
class SinglePhoto:
    """One photo of a few points at various depths: a resection."""

    camera: Camera = field(default_factory=lambda: brown_camera(estimate=()))
    points: int = 12
    distance: float = 10.0
    depth: float = 3.0
    seed: int = 7


def look_at(centre: Array, target: Array, roll: Array | float = 0.0, up: Array | None = None) -> Array:
    """Rotations (n, 3, 3), object axes to image axes, of cameras at `centre` (n, 3) that view `target` (n, 3).

    roll  turn of the image about the viewing axis, against the position in which `up` is up [rad]
    """
    back = np.atleast_2d(centre) - np.atleast_2d(target)
    back = back / np.linalg.norm(back, axis=1, keepdims=True)
    right = np.cross(np.array([0.0, 0.0, 1.0]) if up is None else up, back)
    plumb = np.linalg.norm(right, axis=1) < 1e-9
    right[plumb] = np.cross([0.0, 1.0, 0.0], back[plumb])
    right /= np.linalg.norm(right, axis=1, keepdims=True)
    upright = np.stack([right, np.cross(back, right), back], axis=1)
    turn = np.zeros((len(back), 3))
    turn[:, 2] = -np.asarray(roll)
    return rotation_from_vector(turn) @ upright


def field_scene(plan: TargetField) -> Scene:
    """Points and stations of a testfield; the field lies in the plane Z = 0, the stations above it."""
    rng = np.random.default_rng(plan.seed)
    w, h = plan.size
    x, y = np.meshgrid(np.linspace(-w / 2, w / 2, plan.columns), np.linspace(-h / 2, h / 2, plan.rows))
    z = plan.depth * rng.integers(0, 5, x.size) / 4
    xyz = np.stack([x.ravel(), y.ravel(), z], axis=1)
    n = plan.stations + plan.frontal
    azimuth = 2 * np.pi * np.arange(plan.stations) / max(plan.stations, 1)
    tilt = np.radians(plan.tilt_deg + rng.uniform(-5, 5, plan.stations))
    circle = np.stack([np.sin(tilt) * np.cos(azimuth), np.sin(tilt) * np.sin(azimuth), np.cos(tilt)], axis=1)
    frontal = np.tile([0.0, 0.0, 1.0], (plan.frontal, 1))
    scatter = rng.uniform(-0.05, 0.05, (n, 3)) * plan.distance
    centre = np.concatenate([circle, frontal]) * plan.distance * rng.uniform(0.9, 1.15, (n, 1)) + scatter
    target = rng.uniform(-0.1, 0.1, (n, 3)) * [w, h, 0] + [0, 0, plan.depth / 2]
    roll = np.radians(np.resize(np.asarray(plan.roll_deg), n))
    rotation = look_at(centre, target, roll, up=np.array([0.0, 1.0, 0.0]))
    return Scene(camera=plan.camera, centre=centre, rotation=rotation, xyz=xyz, name="testfield")


def aerial_scene(plan: AerialStrips) -> Scene:
    """Points and stations of an aerial block, strips along X."""
    rng = np.random.default_rng(plan.seed)
    c = plan.camera.values["c"]
    width, height = plan.camera.size_mm * plan.height / c
    base, spacing = width * (1 - plan.forward_overlap), height * (1 - plan.side_overlap)
    strip, along = np.divmod(np.arange(plan.strips * plan.images_per_strip), plan.images_per_strip)
    back = strip % 2 == 1
    x = np.where(back, plan.images_per_strip - 1 - along, along) * base
    n = len(x)
    centre = np.stack([x, strip * spacing, np.full(n, plan.height)], axis=1)
    centre += rng.uniform(-0.02, 0.02, (n, 3)) * plan.height
    angles = rng.normal(0, np.radians(plan.wobble_deg), (n, 3))
    level = np.tile(np.eye(3), (n, 1, 1))
    level[back] = np.diag([-1.0, -1.0, 1.0])
    rotation = rotation_from_vector(angles) @ level
    low = [-width / 2, -height / 2]
    high = [(plan.images_per_strip - 1) * base + width / 2, (plan.strips - 1) * spacing + height / 2]
    area = (high[0] - low[0]) * (high[1] - low[1])
    count = max(4, round(plan.points_per_image * area / (width * height)))
    xy = rng.uniform(low, high, (count, 2))
    wave = np.sin(3 * np.pi * xy[:, 0] / (high[0] - low[0])) * np.cos(2 * np.pi * xy[:, 1] / (high[1] - low[1]))
    z = plan.relief / 2 * (wave + rng.uniform(-0.2, 0.2, count))
    xyz = np.column_stack([xy, z])
    return Scene(camera=plan.camera, centre=centre, rotation=rotation, xyz=xyz, name="aerial")


def ring_scene(plan: Ring) -> Scene:
    """Points on a cylinder about the Z axis, and stations on rings round it."""
    rng = np.random.default_rng(plan.seed)
    angle = rng.uniform(0, 2 * np.pi, plan.points)
    normal = np.stack([np.cos(angle), np.sin(angle), np.zeros(plan.points)], axis=1)
    xyz = plan.radius * rng.uniform(0.97, 1.03, (plan.points, 1)) * normal
    xyz[:, 2] = rng.uniform(-plan.height / 2, plan.height / 2, plan.points)
    ring, at = np.divmod(np.arange(plan.rings * plan.stations), plan.stations)
    turn = 2 * np.pi * (at + ring / plan.rings) / plan.stations
    level = plan.height * (ring / max(plan.rings - 1, 1) - 0.5) if plan.rings > 1 else np.zeros(len(ring))
    centre = np.stack([plan.distance * np.cos(turn), plan.distance * np.sin(turn), level], axis=1)
    roll = np.radians(np.resize(np.asarray(plan.roll_deg), len(centre)))
    rotation = look_at(centre, np.zeros_like(centre), roll)
    return Scene(camera=plan.camera, centre=centre, rotation=rotation, xyz=xyz, normal=normal, name="ring")


def single_scene(plan: SinglePhoto) -> Scene:
    """Points spread over the format of one photo taken in an arbitrary direction."""
    rng = np.random.default_rng(plan.seed)
    depth = plan.distance + rng.uniform(-plan.depth / 2, plan.depth / 2, plan.points)
    half = 0.42 * plan.camera.size_mm / plan.camera.values["c"]
    # one point in each cell of a grid, so that they are spread
    columns = int(np.ceil(np.sqrt(plan.points)))
    cell = np.stack(np.divmod(np.arange(plan.points), columns), axis=1) + rng.uniform(0.1, 0.9, (plan.points, 2))
    tangent = (2 * cell / [np.ceil(plan.points / columns), columns] - 1) * half
    sensor = np.column_stack([tangent * depth[:, None], -depth])
    rotation = rotation_from_vector(np.array([0.4, -0.3, 1.1]))
    centre = np.array([12.0, -7.0, 5.0])
    return Scene(
        camera=plan.camera,
        centre=centre[None],
        rotation=rotation[None],
        xyz=centre + sensor @ rotation,
        name="resection",
    )


def project(scene: Scene, image: int) -> tuple[Index, Array]:
    """The points that image number `image` shows: their positions (k,) and pixel coordinates (k, 2)."""
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
    pixel = scene.camera.pixel_from_image(_images_of(local[:, rows], model, values).T)
    with np.errstate(invalid="ignore"):
        inside = ((pixel >= 0) & (pixel <= size)).all(axis=1)
    return rows[inside].astype(np.int32), pixel[inside]


def _images_of(points: Array, model: SensorModel, values: Array) -> Array:
    """Image points (2, n) [mm]; NaN beyond the radius up to which the distortion is one-to-one."""
    image = model.start(points, values)
    with np.errstate(all="ignore"):
        for _ in range(20):  # Newton for all at once; those that do not settle are not shown
            g, jacobian = model.condition_and_jacobian(*image, *points, *values)
            (a, b), (c, d) = jacobian[:, :2]
            det = a * d - b * c
            image = image - np.stack([d * g[0] - b * g[1], a * g[1] - c * g[0]]) / det
        g, jacobian = model.condition_and_jacobian(*image, *points, *values)
        (a, b), (c, d) = jacobian[:, :2]
        good = (np.abs(g).max(axis=0) < 1e-9) & (a * d - b * c > 0)
    shown = np.full_like(image, np.nan)
    shown[:, good] = model.project(points[:, good], values, image[:, good])[0]
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
    gross = rng.random(len(xy)) < survey.gross_share
    direction = rng.uniform(0, 2 * np.pi, len(xy))
    error = survey.gross_px * np.stack([np.cos(direction), np.sin(direction)], axis=1)
    measured = xy + noise + np.where(gross[:, None], error, 0.0)
    observed = replace(
        truth,
        cameras=(_start_camera(scene.camera, survey),),
        images=_start_images(truth.images, scene, survey, rng),
        observations=replace(truth.observations, xy_px=measured),
        points=_start_points(truth.points, scene, survey, rng),
    ).having(
        replace(
            truth.distances,
            length=truth.distances.length + rng.normal(0, 1, len(truth.distances)) * truth.distances.sigma,
        ),
        replace(
            truth.stations, xyz=truth.stations.xyz + rng.normal(0, 1, truth.stations.xyz.shape) * truth.stations.sigma
        ),
    )
    return Simulation(truth=truth, observed=observed, gross=gross)


def _visible(scene: Scene, survey: Survey) -> tuple[Scene, Index, Index, Array]:
    """The scene without points of too few rays, and all its image points."""
    seen = [project(scene, k) for k in range(len(scene.centre))]
    image = np.repeat(np.arange(len(seen), dtype=np.int32), [len(rows) for rows, _ in seen])
    point = np.concatenate([rows for rows, _ in seen])
    xy = np.concatenate([pixel for _, pixel in seen])
    rays = np.bincount(point, minlength=len(scene.xyz))
    keep = rays >= min(survey.least_rays, len(scene.centre))
    new = (np.cumsum(keep) - 1).astype(np.int32)
    rows = keep[point]
    normal = None if scene.normal is None else scene.normal[keep]
    scene = replace(scene, xyz=scene.xyz[keep], normal=normal)
    if len(scene.xyz) < max(3, survey.control + survey.check, 2 * survey.scale_bars):
        raise InputError(
            f"simulation: only {len(scene.xyz)} points are seen {survey.least_rays} times, {survey.control} control "
            f"and {survey.check} check points and {survey.scale_bars} scale bars of two points each are wanted; add "
            "points or stations, or bring the stations nearer"
        )
    return scene, image[rows], new[point[rows]], xy[rows]


def _roles(scene: Scene, survey: Survey) -> Index:
    role = np.full(len(scene.xyz), Role.TIE, np.int32)
    spread = _well_spread(scene.xyz, survey.control + survey.check)
    role[spread[: survey.control]] = Role.CONTROL
    role[spread[survey.control :]] = Role.CHECK
    return role


def _well_spread(xyz: Array, count: int) -> Index:
    """Positions of points far from each other: each the farthest from those before (Gonzalez 1985)."""
    chosen = np.zeros(count, np.int32)
    distance = np.linalg.norm(xyz - xyz.mean(axis=0), axis=1)
    for k in range(count):
        chosen[k] = int(np.argmax(distance))
        to_new = np.linalg.norm(xyz - xyz[chosen[k]], axis=1)
        distance = to_new if k == 0 else np.minimum(distance, to_new)
    return chosen


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
            file=("",) * n,
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
    ends = _well_spread(scene.xyz, 2 * survey.scale_bars).reshape(-1, 2)
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


def _start_images(images: Images, scene: Scene, survey: Survey, rng: np.random.Generator) -> Images:
    n = len(images)
    move, turn = rng.normal(0, 1, (2, n, 3)) * survey.approximate
    if survey.orientation == "exact":
        return images
    if survey.orientation == "absent":
        return replace(images, centre=np.full((n, 3), np.nan), rotation=np.full((n, 3, 3), np.nan))
    middle = scene.xyz.mean(axis=0)
    distance = np.linalg.norm(scene.centre - middle, axis=1, keepdims=True)
    return replace(
        images, centre=images.centre + move * distance, rotation=rotation_from_vector(turn) @ images.rotation
    )


def _start_points(points: Points, scene: Scene, survey: Survey, rng: np.random.Generator) -> Points:
    """Control and check with their errors, tie points as far as they are known at the start."""
    error = rng.normal(0, 1, points.xyz.shape)
    extent = float(np.ptp(scene.xyz, axis=0).max())
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
    rows, new = keep[point], (np.cumsum(keep) - 1).astype(np.int32)
    variance = np.array(by_camera)[block.images.camera[image[rows]]] ** 2
    return replace(
        block,
        observations=Observations(
            image=image[rows],
            point=new[point[rows]],
            xy_px=np.concatenate([pixel for _, pixel in parts])[rows],
            cov_px2=np.stack([variance, variance, np.zeros(len(variance))], axis=1),
        ),
        points=Points(
            ids=tuple(name for name, k in zip(p.ids, keep, strict=True) if k),
            role=p.role[keep],
            xyz=p.xyz[keep],
            sigma=p.sigma[keep],
        ),
    )


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
