"""Blocks of all kinds of sensors at their true values, and Monte Carlo of whole adjustments of them.

Each run draws new errors of the image points, the weighted control and the observed parameters (RPC biases,
trajectories, mountings); the statistics come once, from the errorless block.
"""

from __future__ import annotations

import functools
from collections.abc import Callable
from dataclasses import dataclass, replace

import numpy as np

from raybundle.adjustment.engine import free_parameters
from raybundle.adjustment.estimation import carry_out
from raybundle.adjustment.records.options import AdjustmentOptions
from raybundle.adjustment.statistics.precision import image_unknowns, interior_unknowns, node_cofactor
from raybundle.adjustment.system.assemble import State, assemble
from raybundle.adjustment.system.normals import Normals
from raybundle.adjustment.system.solve import solve
from raybundle.adjustment.system.transformation import fit_to_given
from raybundle.block import Block, Camera, Images, Observations, Points, Role
from raybundle.numerics.places import Local
from raybundle.numerics.rotation import rotation_from_angles, rotation_from_vector, vector_from_rotation
from raybundle.planning.simulate import measured
from raybundle.planning.synthetic_networks import brown_camera, look_at
from raybundle.scenes.kinds.linescan import LineSensor
from raybundle.scenes.kinds.rpc import RpcSensor
from raybundle.scenes.rpc_fit import fit_rpc
from raybundle.scenes.sensor import scene_camera, view_of
from raybundle.scenes.simulate import OrbitPlan, orbit_scene
from raybundle.scenes.trajectory import CorrectionModel
from raybundle.sensors import sensor_models
from tests.truth.bands import JointErrors

OPTIONS = AdjustmentOptions(jobs=1, tolerance=1e-5)
NONE = Observations(
    image=np.zeros(0, np.int32), point=np.zeros(0, np.int32), xy_px=np.zeros((0, 2)), cov_px2=np.zeros((0, 3))
)
PLACE = (15.0, 48.0, 300.0)


@dataclass
class MonteCarlo:
    """A block at its true values with its cofactors."""

    truth: Block
    work: object

    @classmethod
    def of(cls, truth: Block) -> MonteCarlo:
        free = {c.id: free_parameters(c) for c in truth.parametrised}
        work, _ = carry_out(truth, OPTIONS, free, ("",) * len(truth.observations))
        return cls(truth, work)

    def noisy(self, rng):
        """The block with new errors of all that is observed."""
        t = self.truth
        sigma = np.sqrt(t.observations.cov_px2[:, :2])
        xy = t.observations.xy_px + rng.normal(0, 1, sigma.shape) * sigma
        weighted = t.points.is_control & (np.nan_to_num(t.points.sigma) > 0)
        error = rng.normal(0, 1, t.points.xyz.shape) * np.nan_to_num(t.points.sigma)
        cameras, interior = [], {k: dict(v) for k, v in t.images.interior.items()}
        for k, camera in enumerate(t.cameras):
            values = dict(camera.values)
            for s, sigma_s in camera.sigma.items():
                if s not in camera.own_symbols:
                    values[s] += sigma_s * rng.normal()
                    continue
                for i in np.flatnonzero(t.images.camera == k):
                    own = interior.setdefault(int(i), {})
                    own[s] = own.get(s, camera.values[s]) + sigma_s * rng.normal()
            cameras.append(replace(camera, values=values))
        instruments = tuple(
            replace(i, values={**i.values, **{s: i.values[s] + v * rng.normal() for s, v in i.sigma.items()}})
            for i in t.instruments
        )
        shift = rng.normal(0, 1, t.stations.xyz.shape) * t.stations.sigma
        return replace(
            t,
            cameras=tuple(cameras),
            instruments=instruments,
            images=replace(t.images, interior=interior),
            observations=replace(t.observations, xy_px=xy),
            points=replace(t.points, xyz=t.points.xyz + np.where(weighted, error, 0.0)),
        ).having(replace(t.stations, xyz=t.stations.xyz + shift))

    def run(self, block):
        """Adjusted state in the frame of the truth."""
        free = {c.id: free_parameters(c) for c in block.parametrised}
        system = assemble(block, OPTIONS, np.zeros(len(block.observations), bool), free)
        for part in system.extra.parts:
            if part.kind.name in {"control", "station"}:
                part.rows.value[:] += (system.shift - self.work.system.shift)[part.rows.component]
        system.shift = self.work.system.shift
        normals = Normals.of(system, 1)
        truth = self.work.system.initial_state()
        solution = solve(normals, truth, OPTIONS)
        assert solution.converged
        return fit_to_given(system, solution.state, truth, self.work.datum)

    def errors(
        self, runs: int, seed: int, watch: Callable[[State], None] = lambda _: None
    ) -> dict[str, tuple[np.ndarray, int]]:
        """Normalised squared errors of one of each kind of unknown in each run, and their degrees of freedom.

        watch  is shown the adjusted state of each run
        """
        rng = np.random.default_rng(seed)
        work, truth = self.work, self.work.system.initial_state()
        system, normals, found = work.system, work.normals, work.found
        block = self.truth
        role = np.asarray(block.points.role)
        kinds = {"tie": Role.TIE, "check": Role.CHECK, "control": Role.CONTROL}
        points = {
            k: np.flatnonzero((role == r) & system.points_used & ~system.control_held.any(axis=1))
            for k, r in kinds.items()
        }
        images = np.flatnonzero(system.exterior_free & system.images_used)
        image_Q = {i: node_cofactor(normals, found, image_unknowns(system, int(i))) for i in images}
        rows = [(k, row) for k, row in enumerate(system.interior) if row.node >= 0 and row.free]
        interior_Q = {k: node_cofactor(normals, found, interior_unknowns(system, row)) for k, row in rows}
        result: dict[str, list[float]] = {}
        degrees: dict[str, int] = {}

        def add(name, e, Q):
            result.setdefault(name, []).append(float(e @ np.linalg.solve(Q, e)))
            degrees[name] = len(e)

        for _ in range(runs):
            state = self.run(self.noisy(rng))
            watch(state)
            for name, members in points.items():
                if len(members):
                    p = rng.choice(members)
                    add(f"{name} point", state.xyz[p] - truth.xyz[p], found.points[p])
            by_camera: dict[str, list[int]] = {}
            for i in images:
                by_camera.setdefault(block.cameras[int(block.images.camera[i])].id, []).append(int(i))
            for name, members in by_camera.items():
                i = int(rng.choice(members))
                turn = vector_from_rotation(state.rotation[i] @ truth.rotation[i].T)
                add(f"image of {name}", np.concatenate([state.centre[i] - truth.centre[i], turn]), image_Q[i])
            for k, row in rows:
                name = f"parameters of {row.owner(block).id}" + (" by image" if row.image >= 0 else "")
                if row.image >= 0 and rng.random() > 1 / sum(r.camera == row.camera and r.image >= 0 for _, r in rows):
                    continue
                e = (state.interior[k] - truth.interior[k])[list(row.free)]
                add(name, e, interior_Q[k])
        return {k: (np.array(v), degrees[k]) for k, v in result.items()}


def errors_and_joint(truth: Block, runs: int, seed: int) -> tuple[dict, dict]:
    """`MonteCarlo.errors` of a block, and of the same runs those of all points and of all images and parameters."""
    network = MonteCarlo.of(truth)
    joint, found = JointErrors(network.work), list[dict]()
    by_kind = network.errors(runs, seed, lambda state: found.append(joint.of(state)))
    return by_kind, {name: (np.array([f[name][0] for f in found]), found[0][name][1]) for name in found[0]}


def block_of(
    cameras, camera_of_image, centre, rotation, xyz, role, sigma, *, interior=None, held=None, station=None, place=None
) -> Block:
    """A block from its parts; images are numbered from 1, points from 1."""
    n, p = len(centre), len(xyz)
    return Block(
        place=place,
        cameras=tuple(cameras),
        images=Images(
            ids=tuple(str(k + 1) for k in range(n)),
            camera=np.asarray(camera_of_image, np.int32),
            file=("",) * n,
            centre=np.asarray(centre, float),
            rotation=np.asarray(rotation, float),
            held=held,
            interior=interior or {},
            station=station,
        ),
        observations=NONE,
        points=Points(ids=tuple(str(k + 1) for k in range(p)), role=np.asarray(role, np.int32), xyz=xyz, sigma=sigma),
    )


def control_table(p, control, check, control_sigma):
    """Roles (p,) and sigmas (p, 3): the first points are control, then come check points."""
    role, sigma = np.full(p, Role.TIE), np.full((p, 3), np.nan)
    role[:control], role[control : control + check] = Role.CONTROL, Role.CHECK
    sigma[:control] = control_sigma
    sigma[control : control + check] = 0.0
    return role, sigma


def _scene(pitch, roll, size, gsd):
    return orbit_scene(
        OrbitPlan(target=PLACE, pitch_deg=pitch, roll_deg=roll, width_px=size, height_px=size, gsd_m=gsd)
    )


@functools.cache
def _rpc(pitch, roll, size, gsd):
    return fit_rpc(_scene(pitch, roll, size, gsd).localise, (size, size), (0.0, 600.0)).rpc


def satellite_cameras(place, bias="shift", *, err_bias_m=12.0, size=4000, gsd=1.0, rigorous=()):
    """Two scenes of an IKONOS-like pair as cameras; those named in `rigorous` by their line model."""
    cameras = []
    for name, pitch, roll in (("forward", 2.6, 0.4), ("backward", -2.8, -0.5)):
        if name in rigorous:
            scene = _scene(pitch, roll, size, gsd)
            sensor = LineSensor(scene, place, CorrectionModel(position_degree=0, attitude_degree=1), PLACE[2])
            sigma = dict.fromkeys(("along0", "across0", "up0"), 2.0) | dict.fromkeys(("rx0", "ry0", "rz0"), 1.5e-5)
            cameras.append(scene_camera(name, sensor, sigma=sigma | dict.fromkeys(("rx1", "ry1", "rz1"), 3e-6)))
            continue
        rpc = replace(_rpc(pitch, roll, size, gsd), err_bias_m=err_bias_m, err_rand_m=0.5)
        cameras.append(scene_camera(name, RpcSensor(rpc, place, (size, size), bias)))
    return cameras


def ikonos_pair(bias="shift", rigorous=(), points=60, check=15) -> Block:
    """Two scenes, one control point of 0.3 m, image points of 0.3 px."""
    place = Local(origin=PLACE)
    rng = np.random.default_rng(4)
    cameras = satellite_cameras(place, bias, rigorous=rigorous)
    xyz = np.column_stack([rng.uniform(-1600, 1600, (points, 2)), rng.uniform(-150, 150, points)])
    views = [view_of(c) for c in cameras]
    block = block_of(
        cameras, [0, 1], [v.centre for v in views], [v.rotation for v in views], xyz,
        *control_table(points, 1, check, 0.3), held=np.ones(2, bool), place=place,
    )  # fmt: skip
    return measured(block, 0.3)


PANORAMA = {
    "c": 60.0, "y0": 0.12, "e": 0.010, "K1": -4e-6, "K2": 6e-10, "d": 0.002, "T": 5e-4, "I": 3e-4, "A": 8e-6,
    "u1": 0.0, "u2": 0.0,
}  # fmt: skip
EIGHT = ("y0", "K1", "K2", "e", "d", "T", "I", "A")
"""Principal row, radial terms, eccentricity along and across, tilt and inclination of the line, angular scale."""


def panorama_camera(estimate=("c", *EIGHT), values=None) -> Camera:
    """A panorama of 40 000 columns; the line covers 103 degrees."""
    width = 40_000
    pixel = 2 * np.pi * PANORAMA["c"] / width
    return Camera(
        id="panorama", model="panorama", width_px=width, height_px=16_000, pixel_mm=(pixel, pixel),
        values={**PANORAMA, **(values or {})}, estimate=estimate,
    )  # fmt: skip


UPRIGHT = np.array([[1.0, 0.0, 0.0], [0.0, 0.0, 1.0], [0.0, -1.0, 0.0]])
"""Object axes to panorama axes: y, the axis of rotation, points up."""


def room(stations=4, points=150, control=6, camera=None, sigma_px=0.25) -> Block:
    """Panoramas in a room of 10 x 8 x 4 m with points all over it, not nearer than 0.8 m to a station."""
    rng = np.random.default_rng(11)
    size = np.array([10.0, 8.0, 4.0])
    corners = np.array([[0, 0, 0.5], [10, 8, 0.5], [10, 0, 3.4], [0, 8, 3.2], [5, 0, 1.5], [10, 4, 2.0]])
    centre = np.array([[2.5, 2.0, 1.5], [7.5, 2.2, 1.6], [7.2, 6.0, 1.4], [2.6, 5.8, 1.7]])
    cloud = rng.uniform(0, 1, (4 * points, 3)) * size
    far = np.linalg.norm(cloud[:, None] - centre, axis=2).min(axis=1) > 0.8
    xyz = np.concatenate([corners[:control], cloud[far][:points]])
    centre = centre[:stations]
    turn = rng.normal(0, 0.02, (stations, 3))
    turn[:, 1] += rng.uniform(-np.pi, np.pi, stations)
    rotation = rotation_from_vector(turn) @ UPRIGHT
    block = block_of(
        [camera or panorama_camera()], np.zeros(stations), centre, rotation, xyz,
        *control_table(points + control, control, 20, 0.0005),
    )  # fmt: skip
    return measured(block, sigma_px)


def mixed() -> Block:
    """Frames, a pushbroom, two panoramas and two RPC scenes of one site of 240 m; five control points."""
    place = Local(origin=PLACE)
    rng = np.random.default_rng(21)
    xyz = np.column_stack([rng.uniform(-120, 120, (90, 2)), rng.uniform(0, 25, 90)])
    xyz[:5, :2] = [[-110, -110], [110, -105], [105, 110], [-100, 110], [0, 0]]
    values = dict.fromkeys(sensor_models["brown"].symbols, 0.0) | {"c": 20.4, "K1": -3e-5}
    frame = replace(brown_camera(values=values, estimate=("c", "x0", "y0", "K1")), id="frame")
    push = Camera(
        id="pushbroom", model="pushbroom", width_px=6000, height_px=6000, pixel_mm=(0.008, 0.008),
        values=dict.fromkeys(sensor_models["pushbroom"].symbols, 0.0) | {"c": 60.0, "vy": 10.0}, estimate=MOTION,
        sigma=MOTION_SIGMA, per_image=MOTION,
    )  # fmt: skip
    pano = panorama_camera(estimate=("c", "y0", "e"), values={"d": 0.0, "T": 0.0, "I": 0.0, "A": 0.0})
    scenes = satellite_cameras(place, err_bias_m=5.0, gsd=0.5)
    look = [[-60.0, -100.0, 120.0], [60.0, -90.0, 130.0], [90.0, 60.0, 125.0], [-80.0, 80.0, 120.0], [0.0, 10.0, 140.0]]
    frames = np.array(look)
    frame_R = look_at(
        frames, frames * [0.3, 0.3, 0.0], np.radians([0.0, 90.0, 180.0, 270.0, 45.0]), up=np.array([0.0, 1.0, 0.0])
    )
    air = np.array([[5.0, -3.0, 600.0], [-20.0, 8.0, 620.0]])
    air_R = rotation_from_angles(np.array([[0.02, -0.01, 0.1], [-0.03, 0.02, 1.6]]))
    stand = np.array([[-40.0, 10.0, 12.0], [50.0, -30.0, 14.0]])
    stand_R = rotation_from_vector(np.array([[0.01, 0.5, -0.01], [-0.02, 2.0, 0.01]])) @ UPRIGHT
    views = [view_of(c) for c in scenes]
    centre = np.concatenate([frames, air, stand, [v.centre for v in views]])
    rotation = np.concatenate([frame_R, air_R, stand_R, [v.rotation for v in views]])
    held = np.array([False] * 9 + [True] * 2)
    motion = {5: {"vy": 10.0, "wx": 1e-4}, 6: {"vy": 10.3, "vx": 0.1, "wz": -1e-4}}
    interior = {i: {**dict.fromkeys(MOTION, 0.0), **m} for i, m in motion.items()}
    block = block_of(
        [frame, push, pano, *scenes], [0] * 5 + [1] * 2 + [2] * 2 + [3, 4], centre, rotation, xyz,
        *control_table(90, 5, 10, 0.02), interior=interior, held=held, place=place,
    )  # fmt: skip
    return measured(block, {"frame": 0.3, "pushbroom": 0.3, "panorama": 0.3, "forward": 0.3, "backward": 0.3})


MOTION = ("vx", "vy", "vz", "wx", "wy", "wz")
MOTION_SIGMA = {"vx": 0.02, "vy": 0.02, "vz": 0.02, "wx": 2e-4, "wy": 2e-4, "wz": 2e-4}


def two_camera_rig(stations=6) -> Block:
    """A rig of two cameras before a field of points; the second camera's mounting is estimated."""
    rng = np.random.default_rng(31)
    xyz = np.column_stack([rng.uniform(-2, 2, 50), rng.uniform(-1.5, 1.5, 50), rng.uniform(-0.4, 0.4, 50)])
    values = dict.fromkeys(sensor_models["brown_mounted"].symbols, 0.0) | {"c": 20.0, "K1": -5e-5}
    left = Camera(
        id="left", model="brown", width_px=4000, height_px=3000, pixel_mm=(0.005, 0.005),
        values={s: values[s] for s in sensor_models["brown"].symbols}, estimate=(),
    )  # fmt: skip
    mounting = {"bx": 0.312, "by": -0.011, "bz": 0.024, "om": 0.012, "ph": -0.051, "ka": 0.007}
    right = replace(left, id="right", model="brown_mounted", values={**values, **mounting}, estimate=tuple(mounting))
    centre = np.column_stack(
        [rng.uniform(-1.5, 1.5, stations), rng.uniform(-1, 1, stations), rng.uniform(4, 5, stations)]
    )
    rotation = look_at(
        centre, rng.uniform(-0.3, 0.3, (stations, 3)), rng.uniform(0, 6, stations), up=np.array([0.0, 1.0, 0.0])
    )
    block = block_of(
        [left, right], np.tile([0, 1], stations), np.repeat(centre, 2, axis=0), np.repeat(rotation, 2, axis=0), xyz,
        *control_table(50, 5, 10, 0.001), station=np.repeat(np.arange(stations, dtype=np.int32), 2),
    )  # fmt: skip
    return measured(block, 0.2)
