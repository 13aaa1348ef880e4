"""A line scanner on an orbit or a flight; its parameters correct the trajectory."""

from __future__ import annotations

from collections.abc import Mapping
from pathlib import Path
from typing import Any, ClassVar, Self

import numpy as np

from raybundle.block.block import Relation
from raybundle.errors import InputError, phrase
from raybundle.numerics.arrays import Array, Index, Mask
from raybundle.numerics.geodesy import geographic_from_geocentric
from raybundle.numerics.places import Place
from raybundle.scenes.corrections import Fixes, FixesAt, Pieces, bends
from raybundle.scenes.linescan import LineScene
from raybundle.scenes.observed import Observed
from raybundle.scenes.scan import Carrier, ScanScene, observe_line_at
from raybundle.scenes.sensor import PIXEL_MM, Key, SceneSensor
from raybundle.scenes.simulate import OrbitPlan, orbit_scene
from raybundle.scenes.trajectory import AXES, MOUNT, CorrectionModel, Trajectory

LOW_M = 60e3
"""Height above the ground of a sensor in the air; its viewpoint is where it was in the middle of the scene."""
DEEP_M = 10e3
"""Ground below the middle of a scene."""
ATTITUDE_RAD = 2e-5
"""Usual standard deviation of an attitude: 12 m on the ground from 600 km."""
DEGREES = (-1, 0, 1, 2)


class LineSensor(SceneSensor):
    """A rigorous line scene; the parameters correct its trajectory [m, rad, s].

    Curves have a parameter for each place and axis in place of the powers of the time.
    """

    name = "linescan"
    geometry = LineScene
    formula = (
        "w = R(t) u(X - P(t))      w_x / w_z = psi_x(x)      w_y / w_z = psi_y(x)\n\n"
        "t = t(y), the time of the line\n"
        "R(t) = exp([r(tau)]x) R_table(t + dt)      on a trajectory of several: exp([b]x) M exp([r(tau)]x) M' R_table\n"
        "P(t) = P_table(t + dt) + E' p(tau) - R(t)' a      E: along track, across track, up\n\n"
        "u              direction, with velocity aberration and refraction\n"
        "psi_x, psi_y   directions of the detector of column x\n"
        "p, r           corrections of position and attitude: c0 + c1 tau + c2 tau^2, and curves: sum of B_k(tau) c_k\n"
        "               of pieces, of fixes (Lagrange) or of splines; tau = -1 at the first line, +1 at the last\n"
        "dt, a          offset between the clocks, lever arm\n"
        "b, bt          mount of one of several lines: misalignment; its time offset, added to dt"
    )
    possible = CorrectionModel(
        position_degree=2, attitude_degree=2, time_offset=True, lever_arm=True, mount=True
    ).parameters
    keys = (
        Key(name="position_degree", options=DEGREES), Key(name="attitude_degree", options=DEGREES),
        Key(name="position_fixes", holds="fixes"), Key(name="attitude_fixes", holds="fixes"),
        Key(name="position_pieces", holds="pieces"), Key(name="attitude_pieces", holds="pieces"),
        Key(name="time_offset", default=False), Key(name="lever_arm", default=False), Key(name="smooth", default={}),
        Key(name="height_m", default=0.0),
    )  # fmt: skip
    begin: ClassVar[Mapping[str, Any]] = {"position_degree": -1, "attitude_degree": 0}
    stored = (Trajectory, Carrier, CorrectionModel, Fixes, FixesAt, Pieces)

    def __init__(
        self, scene: ScanScene, place: Place, corrections: CorrectionModel, height_m: float = 0.0,
        file: Path | None = None, smooth: Mapping[str, float] | None = None, *, trajectory: str = "", mount: str = "",
    ) -> None:  # fmt: skip
        """Place a line scene with these corrections of its trajectory.

        smooth             axis of a curve ("rx") -> standard deviation of its bends, which are observed as zero
        trajectory, mount  ids of the block's instruments that have its parameters, where it shares them with others
        """
        self.scene, self.place, self.corrections, self.file = scene, place, corrections, file
        self.size_px = (scene.width_px, scene.height_px)
        self.height_m = float(height_m)
        self.smooth = dict(smooth or {})
        if strange := [s for s in self.smooth if s not in corrections.groups]:
            raise InputError(
                "line_scene.smooth_unknown",
                name=repr(strange[0]),
                known=list(corrections.groups),
                n=len(corrections.groups),
                column="smooth",
            )
        self.parameters = corrections.parameters
        self.trajectory, self.mount = trajectory, mount
        if trajectory:
            self.links = {s: mount if s in MOUNT else trajectory for s in corrections.symbols}
        self._width = corrections.width if corrections.groups or trajectory else 0
        sensor = scene.rays(np.array([self.size_px], float) / 2)[0]
        above = float(geographic_from_geocentric(sensor, scene.ellipsoid)[0, 2]) - self.height_m
        if above <= 0:
            raise InputError("line_scene.below_ground", height_m=self.height_m, above_m=-above)
        self._finish(min(500.0, above / 2))
        self.airborne = self.moves_along = above < LOW_M
        if self.airborne:
            self.centre = place.block_from_geographic(geographic_from_geocentric(sensor, scene.ellipsoid))[0]
            middle = self.localise(np.array([self.size_px], float) / 2, self.height_m, self.defaults)[0]
            self._view_m = float(np.linalg.norm(self.centre - middle))

    @classmethod
    def of_keys(
        cls, model: ScanScene, place: Place, size_px: tuple[int, int], file: Path | None, keys: Mapping[str, Any]
    ) -> Self:
        """As `SceneSensor`."""
        del size_px
        return cls(model, place, cls.corrections_of(keys), keys["height_m"], file, keys["smooth"])

    @staticmethod
    def corrections_of(keys: Mapping[str, Any]) -> CorrectionModel:
        """What its keys ask for; a curve takes the place of the polynomial unless that has a degree of its own."""
        found: dict[str, Any] = {n: keys[n] for n in ("time_offset", "lever_arm")}
        for part in AXES:
            fixes, pieces = f"{part}_fixes", f"{part}_pieces"
            if keys[fixes] is not None and keys[pieces] is not None:
                raise InputError("toml.keys_exclude", first=fixes, second=pieces, column=pieces)
            curve, degree = keys[fixes] or keys[pieces], keys[f"{part}_degree"]
            found[f"{part}_curve"] = curve
            found[f"{part}_degree"] = (0 if curve is None else -1) if degree is None else degree
        return CorrectionModel(**found)

    @classmethod
    def example(cls, place: Place, target: tuple[float, float, float]) -> Self:
        """As `SceneSensor`."""
        scene = orbit_scene(OrbitPlan(target=target))
        corrections = CorrectionModel(position_degree=0, attitude_curve=Fixes(count=3), time_offset=True)
        return cls(scene, place, corrections, target[2], smooth={"rx": 1e-6})

    @property
    def key_values(self) -> dict[str, Any]:
        """As `SceneSensor`; on a trajectory that others share, its keys are those of the trajectory."""
        if self.trajectory:
            mount = {"mount": self.mount} if self.mount else {}
            return {"trajectory": self.trajectory, **mount, "height_m": self.height_m}
        return {**self.correction_keys, "height_m": self.height_m}

    @property
    def correction_keys(self) -> dict[str, Any]:
        """The keys of what corrects its trajectory, with their values."""
        c, found = self.corrections, dict[str, Any]()
        for part in AXES:
            curve = getattr(c, f"{part}_curve")
            found[f"{part}_degree"] = getattr(c, f"{part}_degree")
            if isinstance(curve, Pieces):
                continuity = curve.degree - curve.new
                found[f"{part}_pieces"] = {"count": curve.count, "degree": curve.degree, "continuity": continuity}
            elif isinstance(curve, FixesAt):
                found[f"{part}_fixes"] = [self.scene.time_of_fix(t) for t in curve.at]
            elif curve is not None:
                found[f"{part}_fixes"] = curve.coefficients
        found |= {key: True for key in ("time_offset", "lever_arm") if getattr(c, key)}
        return {**found, **({"smooth": self.smooth} if self.smooth else {})}

    @property
    def state(self) -> dict[str, Any]:
        """As `SceneSensor`."""
        return {
            "scene": self.scene, "corrections": self.corrections, "height_m": self.height_m, "smooth": self.smooth,
            "trajectory": self.trajectory, "mount": self.mount,
        }  # fmt: skip

    @property
    def title(self) -> str:
        """As `SceneSensor`."""
        return phrase("report_scenes.model", strip=self.airborne)

    @property
    def groups(self) -> Mapping[str, tuple[str, ...]]:  # pyright: ignore[reportIncompatibleVariableOverride]
        """As `SceneSensor`."""
        return self.corrections.groups

    @property
    def curves(self) -> tuple[CorrectionModel, float] | None:
        """As `SceneSensor`."""
        return self.corrections, abs(self.scene.correction_span[1])

    @classmethod
    def assumed(cls, model: ScanScene) -> tuple[str, Mapping[str, float]] | None:
        """As `SceneSensor`."""
        del model
        return "scene_prior.orbit", {"sigma_rad": ATTITUDE_RAD}

    def usual_priors(self) -> dict[str, float]:
        """As `SceneSensor`: of attitudes, which alone are corrected where nobody states keys."""
        return {p.symbol: ATTITUDE_RAD for p in self.parameters if p.unit == "rad"}

    @property
    def depth_m(self) -> float:
        """From the highest mountain to below the deepest shore."""
        return DEEP_M

    @property
    def local_width(self) -> int:  # pyright: ignore[reportIncompatibleVariableOverride]
        """Parameters that one image point touches, where there is a curve."""
        return self._width

    def priors(self) -> dict[str, float]:
        """Standard deviations as the table of GNSS and INS states them.

        Those of positions for all corrections of the position, those of attitudes for the curves of the attitude; a
        polynomial of the attitude takes the misalignment of the INS, which its table does not know.
        """
        found: dict[str, float] = {}
        for s in self.symbols:
            if s.rstrip("0123456789").rstrip("_") in AXES["position"] and self.scene.position_sigma_m:
                found[s] = self.scene.position_sigma_m
            if s.startswith("r") and "_" in s and self.scene.attitude_sigma_rad:
                found[s] = self.scene.attitude_sigma_rad
        return found

    def in_front(self, points: Array, image: Array | None = None, values: Array | None = None) -> Mask:
        """Everywhere: `observe` raises where a line does not see a point."""
        del image, values
        return np.ones(points.shape[1], bool)

    @property
    def relations(self) -> tuple[Relation, ...]:  # pyright: ignore[reportIncompatibleVariableOverride]
        """The bends of the curves that are observed as zero."""
        c, found = self.corrections, list[Relation]()
        for axis, sigma in self.smooth.items():
            curve = c.attitude_curve if axis in AXES["attitude"] else c.position_curve
            members = c.groups[axis]
            for k, factors in [] if curve is None else bends(curve):
                terms = dict(zip(members[k : k + 3], factors.tolist(), strict=True))
                found.append(Relation(name=f"bend of {axis} at {members[k + 1]}", terms=terms, sigma=sigma))
        return tuple(found)

    def stations(self, xy_px: Array, values: Array) -> Array:
        """As `SensorModel`."""
        P, _ = self.scene.rays(xy_px, self.corrections, values)
        return self.place.block_from_geographic(geographic_from_geocentric(P, self.scene.ellipsoid))

    def observe(self, xyz: Array, values: Array, near: Array | None = None) -> Observed:
        """As `SceneSensor`."""
        return observe_line_at(self.scene, self.place, xyz, self.corrections, values, near)

    def local(self, image: Array, points: Array, values: Array) -> tuple[Array, Array, Index]:
        """G (2, n), its Jacobian (2, 5 + w, n) and the positions (n, w) of the parameters that it is taken by."""
        xyz = self.object_points(points)
        own = values[:, 0] if values.ndim == 2 else values
        signed = np.array([PIXEL_MM, -PIXEL_MM])
        begin = image.T / signed + np.array(self.size_px) / 2
        seen = self.scene.observe_few(self.place.geocentric_from_block(xyz), self.corrections, own, begin)
        xy, by_point, few, touched = seen
        J = np.zeros((2, 5 + few.shape[2], len(xyz)))
        J[0, 0] = J[1, 1] = 1
        by_block = by_point @ self.place.geocentric_by_block(xyz)
        J[:, 2:5] = -np.einsum("c,nce,de->cdn", signed, by_block, self.rotation)
        J[:, 5:] = -np.moveaxis(few * signed[:, None], 0, 2)
        return image - ((xy - np.array(self.size_px) / 2) * signed).T, J, touched

    def localise(self, xy_px: Array, height: Array | float, values: Array) -> Array:
        """As `SceneSensor`."""
        return self.place.block_from_geographic(self.scene.localise(xy_px, height, self.corrections, values))
