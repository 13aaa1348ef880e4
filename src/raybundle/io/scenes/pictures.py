"""Pixels of a scene's picture by windows: through rasterio (extra `geo`), or from an array that stands for a file."""

from __future__ import annotations

import warnings
from collections.abc import Generator
from contextlib import contextmanager
from dataclasses import dataclass
from pathlib import Path
from typing import Any, Protocol

import numpy as np

from raybundle.errors import InputError
from raybundle.io.raster_library import raster_errors, raster_library
from raybundle.numerics.arrays import Array, Mask


class Picture(Protocol):
    """What is asked of a picture."""

    @property
    def width(self) -> int:
        """In pixels."""
        ...

    @property
    def height(self) -> int:
        """In pixels."""
        ...

    @property
    def bands(self) -> int:
        """How many values a pixel has."""
        ...

    @property
    def dtype(self) -> np.dtype[Any]:
        """Of the values."""
        ...

    @property
    def nodata(self) -> float | None:
        """Value that means nothing; None: there is none."""
        ...

    def window(self, x0: int, y0: int, x1: int, y1: int, reduced: int = 1) -> tuple[Array, Mask | None]:
        """Values (h, w, bands) of columns x0 to x1 and rows y0 to y1, and which of them mean something; None: all.

        reduced  1, or the side of squares that are averaged into one
        """
        ...


@dataclass(frozen=True, slots=True)
class RasterPicture:
    """An opened dataset of rasterio."""

    raster: Any
    library: Any

    @property
    def width(self) -> int:
        """In pixels."""
        return int(self.raster.width)

    @property
    def height(self) -> int:
        """In pixels."""
        return int(self.raster.height)

    @property
    def bands(self) -> int:
        """How many there are."""
        return int(self.raster.count)

    @property
    def dtype(self) -> np.dtype[Any]:
        """One that holds all bands."""
        return np.dtype(np.result_type(*self.raster.dtypes))

    @property
    def nodata(self) -> float | None:
        """Of the first band."""
        return None if self.raster.nodata is None else float(self.raster.nodata)

    def window(self, x0: int, y0: int, x1: int, y1: int, reduced: int = 1) -> tuple[Array, Mask | None]:
        """As `Picture`."""
        window = self.library.windows.Window(x0, y0, x1 - x0, y1 - y0)
        shape = (-(-(y1 - y0) // reduced), -(-(x1 - x0) // reduced))
        resampling = self.library.enums.Resampling.average
        try:
            values = self.raster.read(window=window, out_shape=(self.bands, *shape), resampling=resampling)
            seen = None
            if not all("all_valid" in {f.name for f in flags} for flags in self.raster.mask_flag_enums):
                seen = self.raster.dataset_mask(window=window, out_shape=shape) > 0
        except self.library.errors.RasterioError as error:
            raise InputError(
                "raster.not_readable", detail=str(error).splitlines()[0][:200], file=self.raster.name
            ) from None
        return np.moveaxis(values, 0, 2), seen


@dataclass(frozen=True, slots=True)
class ArrayPicture:
    """An array (bands, rows, columns) or (rows, columns), such as a DataArray; it is read where it is asked for."""

    array: Any
    nodata: float | None = None

    @property
    def width(self) -> int:
        """In pixels."""
        return int(self.array.shape[-1])

    @property
    def height(self) -> int:
        """In pixels."""
        return int(self.array.shape[-2])

    @property
    def bands(self) -> int:
        """How many there are."""
        return 1 if len(self.array.shape) == 2 else int(self.array.shape[0])

    @property
    def dtype(self) -> np.dtype[Any]:
        """Of the array."""
        return np.dtype(self.array.dtype)

    def window(self, x0: int, y0: int, x1: int, y1: int, reduced: int = 1) -> tuple[Array, Mask | None]:
        """As `Picture`."""
        part = np.asarray(self.array[..., y0:y1, x0:x1])
        values = np.moveaxis(part.reshape(self.bands, y1 - y0, x1 - x0), 0, 2)
        seen: Mask | None = None
        if self.nodata is not None:
            nothing = np.isnan(values) if np.isnan(self.nodata) else values == self.nodata
            seen = np.asarray(~nothing.all(axis=2), bool)
        elif self.dtype.kind == "f":
            seen = np.asarray(np.isfinite(values).all(axis=2), bool)
        return (values, seen) if reduced == 1 else _averaged(values, seen, reduced)


def _averaged(values: Array, seen: Mask | None, reduced: int) -> tuple[Array, Mask | None]:
    """Squares of pixels as their mean; with one that means nothing the whole square does."""
    h, w, bands = values.shape
    high, wide = -(-h // reduced) * reduced, -(-w // reduced) * reduced
    room = ((0, high - h), (0, wide - w))
    cells = np.pad(values, (*room, (0, 0)), mode="edge").reshape(high // reduced, reduced, -1, reduced, bands)
    mean = cells.mean(axis=(1, 3))
    mean = mean if values.dtype.kind == "f" else np.rint(mean)
    if seen is not None:
        squares = np.pad(seen, room, mode="edge").reshape(high // reduced, reduced, -1, reduced)
        seen = np.asarray(squares.all(axis=(1, 3)), bool)
    return mean.astype(values.dtype), seen


@contextmanager
def opened_raster(path: Path) -> Generator[Any]:
    """The dataset of rasterio; raises InputError where it cannot be opened, or the library is not installed."""
    library = raster_library(path)
    with raster_errors(path), warnings.catch_warnings():
        warnings.simplefilter("ignore", library.errors.NotGeoreferencedWarning)
        raster = library.open(path)
    with raster:
        yield raster


@contextmanager
def opened_picture(path: Path | None, opened: Any = None) -> Generator[Picture]:
    """The picture in a file, or in an object of rasterio or rioxarray that is opened already."""
    if opened is not None and hasattr(opened, "dims"):
        nodata = opened.attrs.get("_FillValue", opened.encoding.get("_FillValue"))
        yield ArrayPicture(opened, None if nodata is None else float(nodata))
    elif opened is not None:
        yield RasterPicture(opened, raster_library())
    elif path is None:
        raise InputError("scene.no_picture")
    else:
        with opened_raster(path) as raster:
            yield RasterPicture(raster, raster_library())
