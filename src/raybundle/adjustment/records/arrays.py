"""Adjusted quantities as arrays, each with its covariance, and as tables with units in the names of columns."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from importlib import import_module
from typing import Any, Literal

import numpy as np

from raybundle.block import Images
from raybundle.errors import InputError
from raybundle.numerics.arrays import Array
from raybundle.numerics.rotation import angles_from_rotation

To = Literal["numpy", "pandas", "polars"]
ANGLES = ("omega", "phi", "kappa")


@dataclass(frozen=True, slots=True, kw_only=True)
class Poses:
    """Exterior orientations of images."""

    ids: tuple[str, ...]
    centre: Array
    """(n, 3) projection centres, in a rig of its station [length unit]; NaN of images without rays and of scenes"""
    rotation: Array
    """(n, 3, 3) object axes to image axes, in a rig to those of its station: x right, y up, z backwards"""
    covariance: Array | None
    """(n, 6, 6) of X, Y, Z, omega, phi, kappa [length unit, rad]; None without statistics"""
    length_unit: str
    """empty where nothing fixes the scale"""
    alone: Images
    """each camera for itself: in a rig behind its mounting"""

    @property
    def matrices(self) -> Array:
        """(n, 4, 4) from object to camera coordinates as OpenCV and COLMAP have them: x right, y down, z forwards.

        Of a mounted camera those of the camera itself; NaN as `centre`.
        """
        lost = 0 * self.centre
        found = np.tile(np.eye(4), (len(self.ids), 1, 1))
        found[:, :3, :3] = np.diag([1.0, -1.0, -1.0]) @ self.alone.rotation + lost[:, :, None]
        found[:, :3, 3] = lost - np.einsum("nij,nj->ni", found[:, :3, :3], self.alone.centre)
        return found

    def table(self, to: To = "pandas") -> Any:
        """A row an image: X_m ... kappa_deg, and standard deviations sX_m ... skappa_deg."""
        angles = np.degrees(angles_from_rotation(self.rotation))
        columns: dict[str, Any] = {"image": self.ids, **_lengths("XYZ", self.centre, self.length_unit)}
        columns |= {f"{name}_deg": angles[:, k] for k, name in enumerate(ANGLES)}
        if self.covariance is not None:
            std = _deviations(self.covariance)
            columns |= _lengths(("sX", "sY", "sZ"), std[:, :3], self.length_unit)
            columns |= {f"s{name}_deg": np.degrees(std[:, 3 + k]) for k, name in enumerate(ANGLES)}
        return as_table(columns, to)


@dataclass(frozen=True, slots=True, kw_only=True)
class ObjectPoints:
    """Object points."""

    ids: tuple[str, ...]
    role: tuple[str, ...]
    """tie, control, check"""
    xyz: Array
    """(p, 3) [length unit]"""
    covariance: Array | None
    """(p, 3, 3) [length unit^2]; 0 of held coordinates, NaN of points that took no part, None without statistics"""
    length_unit: str

    def table(self, to: To = "pandas") -> Any:
        """A row a point: X_m, Y_m, Z_m, and standard deviations sX_m, sY_m, sZ_m."""
        columns: dict[str, Any] = {"point": self.ids, "role": self.role}
        columns |= _lengths("XYZ", self.xyz, self.length_unit)
        if self.covariance is not None:
            columns |= _lengths(("sX", "sY", "sZ"), _deviations(self.covariance), self.length_unit)
        return as_table(columns, to)


@dataclass(frozen=True, slots=True, kw_only=True)
class Interior:
    """One interior orientation."""

    camera: str
    image: str | None
    """where each image has its own"""
    symbols: tuple[str, ...]
    units: tuple[str, ...]
    values: Array
    """(k,)"""
    covariance: Array | None
    """(k, k); 0 of held parameters, None without statistics"""


@dataclass(frozen=True, slots=True)
class Interiors(Sequence[Interior]):
    """Interior orientations."""

    each: tuple[Interior, ...]

    def __getitem__(self, k: Any) -> Any:
        """By position."""
        return self.each[k]

    def __len__(self) -> int:
        return len(self.each)

    def table(self, to: To = "pandas") -> Any:
        """A row a parameter: camera, image, parameter, value, sigma, unit."""
        rows = [
            (i.camera, i.image or "", symbol, float(i.values[k]), std, i.units[k])
            for i in self.each
            for k, (symbol, std) in enumerate(zip(i.symbols, _std_of(i), strict=True))
        ]
        names = ("camera", "image", "parameter", "value", "sigma", "unit")
        return as_table(dict(zip(names, map(list, zip(*rows, strict=True)), strict=True)) if rows else
                        {name: [] for name in names}, to)  # fmt: skip


def as_table(columns: Mapping[str, Any], to: To) -> Any:
    """Columns as a structured array of NumPy, or as a data frame of a library that is installed.

    raises  InputError for another library, or one that is not installed
    """
    if to == "numpy":
        arrays = {key: np.asarray(values) for key, values in columns.items()}
        made = np.empty(len(next(iter(arrays.values()))), [(key, a.dtype, a.shape[1:]) for key, a in arrays.items()])
        for key, values in arrays.items():
            made[key] = values
        return made
    if to not in ("pandas", "polars"):
        raise InputError("value.not_one_of", entry="to", given=str(to), known=["numpy", "pandas", "polars"])
    try:
        library: Any = import_module(to)
    except ImportError:
        raise InputError("package.tables_missing", package=to) from None
    return library.DataFrame({k: v if isinstance(v, np.ndarray) else list(v) for k, v in columns.items()})


def _lengths(names: Sequence[str], values: Array, unit: str) -> dict[str, Any]:
    return {f"{name}_{unit}" if unit else name: values[:, k] for k, name in enumerate(names)}


def _deviations(covariance: Array) -> Array:
    variance = np.diagonal(covariance, axis1=1, axis2=2)
    return np.sqrt(np.where(variance >= 0, variance, np.nan))


def _std_of(i: Interior) -> list[float]:
    if i.covariance is None:
        return [float("nan")] * len(i.symbols)
    return np.sqrt(np.diagonal(i.covariance)).tolist()
