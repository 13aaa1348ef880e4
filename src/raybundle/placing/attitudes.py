"""Attitudes of photographs that an INS or a gimbal measured: whether they are used and rightly named.

They are observed with a misalignment (boresight) for each camera.  A misalignment is one small rotation for all
photographs, so that a wrong convention shows: after the best mounting the turns of the photographs against what was
stated scatter by far more than the standard deviations.  They are left out; the reading that fits is named.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace
from typing import Literal

import numpy as np

from raybundle.block import Block, Instrument
from raybundle.block.block import Attitudes
from raybundle.errors import InputError, Message, Text, message, warning
from raybundle.io.geo.coordinate_systems import LocalFrame
from raybundle.io.photos.photo import Photo
from raybundle.io.trajectories import PhotoAttitudes, Trajectory, attitudes_of_file, attitudes_of_gimbals
from raybundle.numerics.arrays import Array, Index
from raybundle.numerics.attitude import rotation_from_gimbal, rotation_from_opk, rotation_from_pok, rotation_from_rpy
from raybundle.numerics.deviations import CORRELATED, deviations_of
from raybundle.numerics.rotation import (
    angle_derivatives,
    angles_from_rotation,
    nearest_rotation,
    rotation_from_vector,
    vector_from_rotation,
)
from raybundle.placing.marks import Given, Placing
from raybundle.platforms.imu import Imu

Convention = Literal[
    "auto", "none", "opk", "opk-deg", "opk-gon", "opk-rad", "pok", "pok-deg", "pok-gon", "pok-rad", "matrix",
    "matrix-inverse", "rpy-ned", "gimbal",
]  # fmt: skip
GROSS, LEAST, MOST = 6.0, np.radians(3.0), np.radians(15.0)
"""Median scatter beyond which attitudes do not fit: so many standard deviations, at least and at most so much."""
DOUBT = 4.0
"""The same in standard deviations where another reading of the angles leaves a third of it."""
BETTER, ALIKE = 3.0, 1.1
MOUNTED = np.radians(20.0)
"""How far the camera may stand from a whole number of quarter turns in its mount."""
SINGLE = 10.0
"""Distance of one attitude from the others, in standard deviations, from which it is left out; at least LEAST."""
STEEP = 0.02
"""Cosine of phi below which omega, phi, kappa do not describe an attitude well."""
EXACT = 1e-6
"""Scatter of attitudes that agree with photographs of a simulation [rad]"""
ENOUGH = 4
"""Attitudes from which their scatter shows a convention."""
SAMPLE = 200
ACROSS, NOMINAL = 10.0, float(np.radians(1.0))
"""Spread of the positions across their line, in their standard deviations, below which they show no turn about it;
and what the mounting of the camera is then taken to be good to."""

READINGS: dict[str, Callable[[Array], Array]] = {
    "opk": rotation_from_opk,
    "phi_primary": lambda a: rotation_from_pok(a[:, [1, 0, 2]]),
    "opk_inverse": lambda a: np.swapaxes(rotation_from_opk(a), 1, 2),
    "opk_omega_phi_reversed": lambda a: rotation_from_opk(a * [-1, -1, 1]),
    "opk_kappa_reversed": lambda a: rotation_from_opk(a * [1, 1, -1]),
    "rpy": rotation_from_rpy,
    "rpy_roll_reversed": lambda a: rotation_from_rpy(a * [-1, 1, 1]),
    "rpy_pitch_reversed": lambda a: rotation_from_rpy(a * [1, -1, 1]),
    "rpy_roll_pitch_reversed": lambda a: rotation_from_rpy(a * [-1, -1, 1]),
    "pry": lambda a: rotation_from_rpy(a[:, [1, 0, 2]]),
    "rpy_yaw_from_east": lambda a: rotation_from_rpy(np.stack([a[:, 0], a[:, 1], np.pi / 2 - a[:, 2]], axis=1)),
    "gimbal": rotation_from_gimbal,
    "ypr": lambda a: rotation_from_rpy(a[:, ::-1]),
    "gimbal_rpy": lambda a: rotation_from_gimbal(a[:, ::-1]),
}
"""What three angles may mean besides their convention; `attitudes_contradict.reading` has the words."""
CALLED = {"opk": "opk", "pok": "pok", "rpy-ned": "rpy", "gimbal": "gimbal"}


@dataclass(frozen=True, slots=True, kw_only=True)
class Fit:
    """How attitudes fit the photographs with one mounting of the camera."""

    mount: Array
    """(3, 3) recorded to image axes"""
    apart: Array
    """(n,) angles of the photographs from it [rad]"""

    @property
    def scatter(self) -> float:
        """Median of the angles [rad]."""
        return float(np.median(self.apart))

    @property
    def quarter(self) -> int:
        """Quarter turns about the view, -1 to 2, that are nearest to the mounting."""
        angle = np.arctan2(self.mount[1, 0] - self.mount[0, 1], self.mount[0, 0] + self.mount[1, 1])
        return (round(float(angle) / (np.pi / 2)) + 1) % 4 - 1

    @property
    def quarters(self) -> Array:
        """(3, 3) those turns."""
        return rotation_from_vector(np.array([0.0, 0.0, self.quarter * np.pi / 2]))

    @property
    def askew(self) -> float:
        """Angle that the mounting is away from them [rad]."""
        return float(np.linalg.norm(_vector(self.mount @ self.quarters.T)))


def find_attitudes(
    photos: Sequence[Photo], positions: Trajectory | None, *, use: Convention, sigma_deg: tuple[float, float] | None,
    crs: str | None,
) -> tuple[PhotoAttitudes | None, tuple[str, ...]]:  # fmt: skip
    """The attitudes to be observed, and remarks.

    use        the convention that is expected; auto: whatever there is, where standard deviations are known
    sigma_deg  about level axes and the vertical, where none are stated
    raises     InputError where a convention is asked for that is not there, or one without standard deviations
    """
    if use == "none":
        return None, ()
    a, b = (float(np.radians(v)) for v in sigma_deg or (0.0, 0.0))
    sigma = (a, b) if sigma_deg is not None else None
    found = None if positions is None else attitudes_of_file(positions, photos, crs=crs, sigma=sigma, use=use)
    if found is None and (use == "gimbal" or sigma is not None):
        found = attitudes_of_gimbals(photos, sigma=sigma)
    if found is None:
        if use != "auto" or sigma is not None:
            raise InputError("attitude.missing")
        return None, ()
    if use not in {"auto", found.convention, found.reading, found.reading.partition("-")[0]}:
        raise InputError(
            "attitude.other_convention",
            source=found.source,
            convention=found.reading or found.convention,
            expected=str(use),
        )
    if found.stated == 0:
        if use != "auto":
            raise InputError("attitude.no_sigma", source=found.source)
        return None, (Text.of(warning("attitude.no_sigma_unused", source=found.source)),)
    return replace(_with_covariance(found), others=tuple(_with_covariance(a) for a in found.others)), ()


def _with_covariance(a: PhotoAttitudes) -> PhotoAttitudes:
    keep = np.asarray(np.isfinite(a.covariance).all(axis=(1, 2)), bool)
    return replace(
        a, names=tuple(n for n, k in zip(a.names, keep, strict=True) if k), rotation=a.rotation[keep],
        covariance=a.covariance[keep], angles=a.angles[keep], against_enu=a.against_enu[keep],
    )  # fmt: skip


def observe_attitudes(state: Placing, photos: Sequence[Photo], given: Given, frame: LocalFrame) -> None:
    """Observe the attitudes in a placed block, with a misalignment of each camera; or say why not."""
    recorded = given.attitudes
    if recorded is None:
        return
    number = {p.name: i for i, p in enumerate(photos)}
    image = np.array([number.get(n, -1) for n in recorded.names], np.int32)  # -1: a photograph that is not used
    block = state.block
    recorded = _chosen(state, recorded, image, frame)
    if recorded is None:
        return
    cameras = np.unique(block.images.camera[image[image >= 0]])
    mine = np.flatnonzero((image >= 0) & np.asarray(block.images.oriented)[image])
    image = image[mine]
    R, enu_from_local = block.images.rotation[image], _enu_from_local(block.images.centre[image], frame)
    part = replace(
        recorded, names=tuple(recorded.names[k] for k in mine), rotation=recorded.rotation[mine] @ enu_from_local,
        covariance=recorded.covariance[mine], angles=recorded.angles[mine],
        against_enu=recorded.against_enu[mine] @ enu_from_local,
    )  # fmt: skip
    taken = {c.id for c in block.parametrised}
    imus: list[Instrument] = []
    used: list[_Mounted] = []
    nominal = _in_a_line(block) and given.misalignment
    for n, c in enumerate(cameras.tolist()):
        mounted = _mounted(state, part, np.flatnonzero(block.images.camera[image] == c), R, n)
        name = "ins" if len(cameras) == 1 else f"ins-{block.cameras[c].id}"
        while name in taken:
            name += "_"
        imus.append(_imu(name, mounted.misalignment, NOMINAL if nominal else None))
        if len(mounted.rows):
            used.append(mounted)
            _note_convergence(state, block, part, mounted, frame)
    if used and nominal:
        state.notify("attitudes_nominal", sigma_deg=float(np.degrees(NOMINAL)))
    _observe(state, part, image, used, imus if given.misalignment else [])


def _chosen(state: Placing, recorded: PhotoAttitudes, image: Index, frame: LocalFrame) -> PhotoAttitudes | None:
    """The one of several readings of a file that the photographs fit; None where there are too few of them.

    The least scatter decides; of those that scatter alike the first whose camera is the least askew.  A customary
    reading scatters alike up to three times the least.
    """
    if not recorded.others:
        return recorded
    every, block = (recorded, *recorded.others), state.block
    rows = np.flatnonzero((image >= 0) & np.asarray(block.images.oriented)[image])
    if len(rows) < ENOUGH:
        state.notify("attitudes_undecided", *[a.reading for a in every], n=len(rows), needed=ENOUGH,
                     source=recorded.source, first=recorded.reading)  # fmt: skip
        return None
    R, turn = block.images.rotation[image[rows]], _enu_from_local(block.images.centre[image[rows]], frame)
    camera = block.images.camera[image[rows]]
    fits = [
        [fit_mount(R[camera == c], (a.rotation[rows] @ turn)[camera == c]) for c in np.unique(camera)] for a in every
    ]
    scatter = np.array([np.mean([f.scatter for f in fit]) for fit in fits])
    askew = np.array([max(f.askew for f in fit) for fit in fits])
    like = scatter <= max(ALIKE * float(scatter.min()), EXACT)
    like[0] |= recorded.customary and scatter[0] <= BETTER * scatter.min()
    upright = like & (askew < askew[like].min() + LEAST)
    best = int(np.flatnonzero(upright)[0])
    other = int(np.where(np.arange(len(every)) == best, np.inf, scatter).argmin())
    state.notify(
        "attitudes_reading", source=recorded.source, reading=every[best].reading, other=every[other].reading,
        scatter_deg=float(np.degrees(scatter[best])), other_deg=float(np.degrees(scatter[other])),
    )  # fmt: skip
    return replace(every[best], others=())


@dataclass(frozen=True, slots=True, kw_only=True)
class _Mounted:
    """The attitudes of one camera that are used."""

    rows: Index
    imu: int
    turn: Array
    """(3, 3) whole quarter turns of the camera about its view, by which it is mounted"""
    misalignment: Array
    """(3,) [rad] at the start"""


def _observe(
    state: Placing, recorded: PhotoAttitudes, image: Index, used: list[_Mounted], imus: list[Instrument]
) -> None:
    """Attitudes and IMUs into the block; the block of every part gets all IMUs, so that they are numbered alike."""
    block = state.block
    first = len(block.instruments)
    state.block = block = replace(block, instruments=(*block.instruments, *imus))
    if not used:
        return
    rows = np.concatenate([m.rows for m in used])
    turn = np.concatenate([np.tile(m.turn, (len(m.rows), 1, 1)) for m in used])
    imu = np.concatenate([np.full(len(m.rows), first + m.imu) for m in used])
    R = turn @ recorded.rotation[rows]
    angles = angles_from_rotation(R)
    steep = np.abs(np.cos(angles[:, 1])) < STEEP
    if steep.any():
        names = [recorded.names[k] for k in rows[steep]]
        state.notify("attitudes_steep", *names, n=len(names))
    order = np.flatnonzero(~steep)[np.argsort(image[rows[~steep]], kind="stable")]
    rows, turn, imu, R, angles = rows[order], turn[order], imu[order], R[order], angles[order]
    D = angle_derivatives(R) @ turn
    sigma, correlation = deviations_of(D @ recorded.covariance[rows] @ np.swapaxes(D, 1, 2))
    correlation = np.where(np.abs(correlation) > CORRELATED, correlation, 0.0)
    state.block = block.having(
        Attitudes(
            image=image[rows],
            angles=angles,
            sigma=sigma,
            correlation=correlation if correlation.any() else None,
            imu=imu.astype(np.int32) if imus else None,
        )
    )
    state.notify("attitudes", n=len(rows), convention=recorded.convention, source=recorded.source, cameras=len(imus))


def _mounted(state: Placing, recorded: PhotoAttitudes, rows: Index, R: Array, imu: int) -> _Mounted:
    """The attitudes of one camera (rows of `recorded`) against the photographs' rotations; none if they contradict."""
    nothing = _Mounted(rows=rows[:0], imu=imu, turn=np.eye(3), misalignment=np.zeros(3))
    if not len(rows):
        return nothing
    fit = fit_mount(R[rows], recorded.rotation[rows])
    sigma = float(np.sqrt(np.median(np.trace(recorded.covariance[rows], axis1=1, axis2=2))))
    limit = min(max(GROSS * sigma, LEAST), MOST)
    other = _better_reading(recorded, rows, R, fit)
    doubt = other is not None and (fit.scatter > DOUBT * sigma or fit.askew > MOUNTED)
    alone = fit.askew > MOUNTED and (fit.scatter > DOUBT * sigma or _one_heading(recorded, rows))
    if fit.scatter > limit or doubt or alone:
        _note_contradiction(state, recorded, fit, sigma, other)
        return nothing
    turn = fit.mount if fit.askew > MOUNTED else fit.quarters
    if fit.askew > MOUNTED or fit.quarter:
        quarter = fit.askew <= MOUNTED
        angle = 90.0 * fit.quarter if quarter else float(np.degrees(np.linalg.norm(_vector(fit.mount))))
        alike = _one_heading(recorded, rows)
        state.notify("attitudes_mount", source=recorded.source, angle_deg=angle, quarter=quarter, alike=alike)
    far = fit.apart > max(SINGLE * sigma, LEAST)
    if far.any():
        names = [recorded.names[k] for k in rows[far]]
        state.notify(
            "attitude_wrong", *names, n=len(names), off_deg=float(np.degrees(fit.apart[far].max())),
            scatter_deg=float(np.degrees(fit.scatter)),
        )  # fmt: skip
    return _Mounted(rows=rows[~far], imu=imu, turn=turn, misalignment=_vector(fit.mount @ turn.T))


def _note_contradiction(
    state: Placing, recorded: PhotoAttitudes, fit: Fit, sigma: float, other: tuple[str, Fit] | None
) -> None:
    """Add the fault of attitudes that contradict the photographs, and how they would fit better."""
    details: list[Message] = []
    if fit.askew > MOUNTED and fit.scatter < MOST:
        details.append(message("attitudes_contradict.mounting", off_deg=float(np.degrees(fit.askew))))
    if other is not None:
        name, found = other
        scatter = float(np.degrees(found.scatter))
        details.append(message("attitudes_contradict.reading", reading=name, scatter_deg=scatter))
    state.notify(
        "attitudes_contradict", details=tuple(details), source=recorded.source, reading=CALLED[recorded.convention],
        scatter_deg=float(np.degrees(fit.scatter)), sigma_deg=float(np.degrees(sigma)), other=other is not None,
    )  # fmt: skip


def fit_mount(R: Array, recorded: Array) -> Fit:
    """The one mounting M of R = M stated (n, 3, 3) that most of them share, and how far each is from it.

    Robust: of the mountings that single photographs give, the one that has the least median distance to the others.
    """
    M = R @ np.swapaxes(recorded, 1, 2)
    some = M[np.linspace(0, len(M) - 1, min(len(M), SAMPLE)).astype(int)]
    # trace of A B' = 1 + 2 cos(angle)
    apart = _angles(np.einsum("aij,bij->ab", some, M))
    best = some[int(np.median(apart, axis=1).argmin())]
    near = _angles(np.einsum("ij,bij->b", best, M))
    close = M[near <= 3 * max(float(np.median(near)), 1e-9)]
    mount = nearest_rotation(close.mean(axis=0))
    return Fit(mount=mount, apart=_angles(np.einsum("ij,bij->b", mount, M)))


def _angles(trace: Array) -> Array:
    return np.arccos(np.clip((trace - 1) / 2, -1.0, 1.0))


def _better_reading(recorded: PhotoAttitudes, rows: Index, R: Array, fit: Fit) -> tuple[str, Fit] | None:
    """Another reading of the angles that fits clearly better, or as well without a mounting askew; None: there is none.

    Fewer than ENOUGH attitudes show nothing: with one mounting to choose, many readings fit a few of them.
    """
    if len(rows) < ENOUGH:
        return None
    fits = {
        name: fit_mount(R[rows], make(recorded.angles[rows]) @ recorded.against_enu[rows])
        for name, make in READINGS.items() if name != CALLED[recorded.convention]
    }  # fmt: skip
    name = min(fits, key=lambda n: (fits[n].scatter > 1.1 * min(f.scatter for f in fits.values()), fits[n].askew))
    found = fits[name]
    straight = fit.askew > MOUNTED >= found.askew and found.scatter < 1.5 * fit.scatter
    return (name, found) if found.scatter < fit.scatter / BETTER or straight else None


def _vector(rotation: Array) -> Array:
    return vector_from_rotation(rotation[None])[0]


def _one_heading(recorded: PhotoAttitudes, rows: Index) -> bool:
    """Whether the attitudes differ too little to separate a mounting from a wrong zero of their angles."""
    return bool(_angles(np.einsum("ij,bij->b", recorded.rotation[rows[0]], recorded.rotation[rows])).max() < MOUNTED)


def _note_convergence(
    state: Placing, block: Block, recorded: PhotoAttitudes, mounted: _Mounted, frame: LocalFrame
) -> None:
    """Say so where the misalignment about the vertical is what true north and grid north differ by."""
    oriented = block.images.centre[block.images.oriented]
    lon, lat, _ = frame.wgs84_from_local(oriented.mean(axis=0)[None])[0]
    middle = 6 * np.floor(lon / 6) + 3
    convergence = float(np.arctan(np.tan(np.radians(lon - middle)) * np.sin(np.radians(lat))))
    up = np.mean(mounted.turn @ recorded.rotation[mounted.rows], axis=0)[:, 2]
    about = float(mounted.misalignment @ up)
    sigma = float(np.sqrt(np.median(recorded.covariance[mounted.rows, 2, 2]) / len(mounted.rows)))
    tolerance = max(3 * sigma, np.radians(0.05))
    if abs(convergence) > 3 * tolerance and abs(abs(about) - abs(convergence)) < tolerance:
        state.notify(
            "attitudes_convergence", about_deg=float(np.degrees(about)), convergence_deg=float(np.degrees(convergence))
        )


def _enu_from_local(centre: Array, frame: LocalFrame) -> Array:
    """(n, 3, 3) from the axes of the block to east, north, up at local places (n, 3)."""
    return np.swapaxes(frame.local_from_enu(frame.crs_from_local(centre)), 1, 2)


def _in_a_line(block: Block) -> bool:
    """Whether nothing but attitudes shows how the block is turned about the line of its positions."""
    xyz, sigma = block.stations.xyz, block.stations.sigma
    known = np.isfinite(xyz).all(axis=1)
    if block.points.is_control.all(axis=1).sum() >= 3 or known.sum() < 2:
        return False
    across = np.linalg.svd(xyz[known] - xyz[known].mean(axis=0), compute_uv=False)[1] / np.sqrt(known.sum())
    return bool(across < ACROSS * np.sqrt(np.mean(sigma[known] ** 2)))


def _imu(name: str, misalignment: Array, sigma: float | None) -> Instrument:
    """The IMU of a camera; its misalignment free, or observed to be none with a standard deviation [rad]."""
    symbols = tuple(p.symbol for p in Imu.parameters)
    start = misalignment if sigma is None else np.zeros(3)
    return Instrument(
        id=name, model=Imu.name, estimate=symbols, values=dict(zip(symbols, start.tolist(), strict=True)),
        sigma={} if sigma is None else dict.fromkeys(symbols, sigma),
    )  # fmt: skip
