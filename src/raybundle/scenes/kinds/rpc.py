"""A scene by its rational polynomials; its parameters are those of a bias in the image."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import replace
from pathlib import Path
from typing import Any, ClassVar, Self

import numpy as np

from raybundle.errors import NoConvergence
from raybundle.numerics.arrays import Array
from raybundle.numerics.places import Place
from raybundle.scenes.bias import BIAS_PARAMETERS, BiasKind, bias_design
from raybundle.scenes.observed import Observed
from raybundle.scenes.rpc import Rpc, correct_image, observe_rpc_at
from raybundle.scenes.rpc_errors import errors_of_covariance
from raybundle.scenes.rpc_fit import RpcFit, corrected_rpc, fit_rpc
from raybundle.scenes.rpc_image import rpc_of_image
from raybundle.scenes.sensor import Key, SceneSensor
from raybundle.scenes.simulate import OrbitPlan, orbit_scene
from raybundle.sensors import Parameter

RANGES = 4.0
"""Ground below the middle of a scene, in halves of the range of its heights."""
USUAL_BIAS_M, USUAL_RAND_M = 20.0, 2.0
"""Standard deviations of an RPC that states none: common to the scene, and changing within it."""
MEANINGS = {
    "A0": "parameter.bias_shift_x", "A1": "parameter.bias_x_columns", "A2": "parameter.bias_x_rows",
    "B0": "parameter.bias_shift_y", "B1": "parameter.bias_y_columns", "B2": "parameter.bias_y_rows",
}  # fmt: skip


class RpcSensor(SceneSensor):
    """An RPC scene; the parameters are those of its bias [px].

    Order of the coefficients as in RPC00B.  Pixels count from the outer corner of the first one.
    """

    name = "rpc"
    geometry = Rpc
    rigorous: ClassVar[bool] = False
    formula = (
        "y_n = P1(φ, λ, h) / P2(φ, λ, h)      x_n = P3(φ, λ, h) / P4(φ, λ, h)\n\n"
        "P = a1 + a2 λ + a3 φ + a4 h + a5 λφ + a6 λh + a7 φh + a8 λ² + a9 φ² + a10 h² + a11 φλh + a12 λ³\n"
        "    + a13 λφ² + a14 λh² + a15 λ²φ + a16 φ³ + a17 φh² + a18 λ²h + a19 φ²h + a20 h³\n\n"
        "φ, λ, h, x_n, y_n: latitude, longitude, height, column and row, less their offset, over their scale\n\n"
        "x = x_RPC + A0 + A1 u + A2 v      y = y_RPC + B0 + B1 u + B2 v\n\n"
        "u, v: column and row, -1 .. 1 over the scene\n"
        "bias: shift A0, B0; drift A0, A2, B0, B2; affine all; none"
    )
    possible = tuple(Parameter(s, "px", meaning) for s, meaning in MEANINGS.items())
    keys = (Key(name="bias", default="shift", options=tuple(BIAS_PARAMETERS)),)

    def __init__(
        self, rpc: Rpc, place: Place, size_px: tuple[int, int], bias: BiasKind = "shift", file: Path | None = None
    ) -> None:
        """Place an RPC scene of this size with this model of its bias."""
        self.rpc, self.place, self.size_px, self.file = rpc, place, size_px, file
        self.bias: BiasKind = bias
        self.parameters = tuple(p for p in self.possible if p.symbol in BIAS_PARAMETERS[bias])
        self.height_m = float(rpc.ground_offset[2])
        self._finish()

    @classmethod
    def of_keys(
        cls, model: Rpc, place: Place, size_px: tuple[int, int], file: Path | None, keys: Mapping[str, Any]
    ) -> Self:
        """As `SceneSensor`; raises InputError where the image is not that of the RPC."""
        return cls(rpc_of_image(model, *size_px, file or cls.name), place, size_px, keys["bias"], file)

    @classmethod
    def example(cls, place: Place, target: tuple[float, float, float]) -> Self:
        """As `SceneSensor`."""
        scene = orbit_scene(OrbitPlan(target=target))
        size = scene.width_px, scene.height_px
        return cls(fit_rpc(scene.localise, size, (0.0, 600.0)).rpc, place, size, "affine")

    @property
    def key_values(self) -> dict[str, Any]:
        """As `SceneSensor`."""
        return {"bias": self.bias}

    @property
    def state(self) -> dict[str, Any]:
        """As `SceneSensor`."""
        return {"rpc": self.rpc, "size_px": self.size_px, "bias": self.bias}

    @property
    def title(self) -> str:
        """As `SceneSensor`."""
        return f"RPC, {self.bias}"

    @property
    def depth_m(self) -> float:
        """By the range of heights for which the polynomials hold."""
        return RANGES * float(self.rpc.ground_scale[2])

    def observe(self, xyz: Array, values: Array, near: Array | None = None) -> Observed:
        """As `SceneSensor`."""
        del near
        return observe_rpc_at(self.rpc, self.place, xyz, self.bias, values)

    def localise(self, xy_px: Array, height: Array | float, values: Array) -> Array:
        """As `SceneSensor`."""
        try:
            ground = self.rpc.localise(correct_image(self.rpc, xy_px, self.bias, values), height)
        except NoConvergence as error:
            details = [error.message] if error.message else []
            raise NoConvergence("rpc.scene_localisation", details=details, scene=str(self.file or self.name)) from None
        return self.place.block_from_geographic(ground)

    @classmethod
    def assumed(cls, model: Rpc) -> tuple[str, Mapping[str, float]] | None:
        """As `SceneSensor`."""
        return None if model.err_bias_m else ("scene_prior.rpc", {"sigma_m": USUAL_BIAS_M})

    def priors(self) -> dict[str, float]:
        """Standard deviations of the parameters as the vendor states them, where he does [px].

        ERR_BIAS for the shifts; ERR_RAND, which changes within the scene, for the terms that do.
        """
        found: dict[str, float] = {}
        gsd = np.linalg.norm(self.rpc.pixel_on_ground(), axis=1)
        for s in self.symbols:
            metres = self.rpc.err_bias_m if s[1] == "0" else self.rpc.err_rand_m
            if metres:
                found[s] = metres / float(gsd[0 if s[0] == "A" else 1])
        return found

    def usual_priors(self) -> dict[str, float]:
        """As `SceneSensor`."""
        gsd = np.linalg.norm(self.rpc.pixel_on_ground(), axis=1)
        usual = {
            s: (USUAL_BIAS_M if s[1] == "0" else USUAL_RAND_M) / float(gsd[int(s[0] == "B")]) for s in self.symbols
        }
        return {**usual, **self.priors()}

    def prior_px(self) -> Array:
        """As `SceneSensor`, of the shifts alone."""
        found = self.rpc.bias_sigma_px()
        return USUAL_BIAS_M / np.linalg.norm(self.rpc.pixel_on_ground(), axis=1) if found is None else found

    def metres(self, symbol: str) -> float:
        """As `SceneSensor`."""
        return float(np.linalg.norm(self.rpc.pixel_on_ground(), axis=1)[int(symbol[0] == "B")])

    def shift(self, xy_px: Array, values: Array) -> Array | None:
        """As `SceneSensor`."""
        if not self.symbols:
            return None
        return bias_design(self.bias, (xy_px - self.rpc.image_offset) / self.rpc.image_scale) @ values

    def check_near(self, xyz: Array, names: Sequence[str]) -> None:
        """As `SceneSensor`."""
        self.rpc.check_near(self.place.geographic_from_block(xyz), names)

    @property
    def heights_m(self) -> tuple[float, float] | None:
        """As `SceneSensor`."""
        middle, reach = float(self.rpc.ground_offset[2]), float(self.rpc.ground_scale[2])
        return middle - reach, middle + reach

    def as_rpc(
        self, values: Array, heights: tuple[float, float], known: tuple[tuple[str, ...], Array]
    ) -> tuple[Rpc, RpcFit | None]:
        """As `SceneSensor`: a shift goes into the offsets, exactly.

        With the errors of its adjusted bias; the vendor's where its covariance is not known.  ERR_RAND is the vendor's,
        with what the terms that change over the image are uncertain by.
        """
        rpc, fit = corrected_rpc(self.rpc, self.bias, values, self.size_px, heights)
        symbols, covariance = known
        wanted = BIAS_PARAMETERS[self.bias]
        if not wanted or set(symbols) != set(wanted):
            return replace(rpc, err_bias_m=self.rpc.err_bias_m, err_rand_m=self.rpc.err_rand_m), fit
        order = [symbols.index(s) for s in wanted]
        bias, changing = errors_of_covariance(self.rpc, self.bias, covariance[np.ix_(order, order)])
        rand = float(np.hypot(self.rpc.err_rand_m or 0.0, changing))
        return replace(rpc, err_bias_m=bias, err_rand_m=rand or None), fit
