"""From light to a file: Bayer pattern, noise, demosaicing, gamma, JPEG with metadata."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path

import numpy as np
from numpy.typing import NDArray
from PIL import Image
from scipy import ndimage

from .camera import Camera

Light = NDArray[np.float32]
GAINS = np.array([1.9, 1.0, 1.6], dtype=np.float32)
"""White balance of red, green and blue."""
SUBSAMPLING = {"4:4:4": 0, "4:2:2": 1, "4:2:0": 2}


@dataclass(frozen=True, slots=True, kw_only=True)
class Sensor:
    """What a camera does with light.

    full_well    electrons of a green pixel at the brightest value
    read_noise   standard deviation [electrons]
    bayer        whether pixels see one colour each, which demosaicing completes
    quality      JPEG quality of libjpeg, 1 to 100; 0: PNG
    subsampling  of chroma: 4:4:4, 4:2:2 or 4:2:0
    tables       of quantisation: standard (ITU-T T.81, annex K, scaled by quality) or camera (`camera_tables`)
    """

    full_well: float = 20000.0
    read_noise: float = 3.0
    bayer: bool = True
    quality: int = 93
    subsampling: str = "4:2:0"
    tables: str = "standard"

    def developed(self, light: Light, rng: np.random.Generator) -> NDArray[np.uint8]:
        """8-bit sRGB (m, n, 3) of linear light (3, m, n), 1 = white."""
        raw = light / GAINS[:, None, None]
        if self.bayer:
            raw = self._exposed(mosaic(raw), rng)
            colours = demosaiced(raw * bayer_gains(raw.shape))
        else:
            colours = self._exposed(raw, rng) * GAINS[:, None, None]
        return np.ascontiguousarray(np.moveaxis(np.rint(255 * srgb(colours)).astype(np.uint8), 0, -1))

    def _exposed(self, raw: Light, rng: np.random.Generator) -> Light:
        """Light with shot noise (the normal limit of Poisson's) and read noise, in 14 bit."""
        electrons = np.maximum(raw, 0) * self.full_well
        deviation = np.sqrt(electrons + self.read_noise**2)
        electrons += deviation * rng.standard_normal(raw.shape, dtype=np.float32)
        return np.rint(np.clip(electrons / self.full_well, -0.05, 1) * 16383).astype(np.float32) / np.float32(16383)


def _colour_of(shape: tuple[int, ...]) -> NDArray[np.uint8]:
    """0, 1, 2 for red, green, blue of RGGB, (2, 2) repeated."""
    m, n = shape
    return np.tile(np.array([[0, 1], [1, 2]], dtype=np.uint8), (m // 2 + 1, n // 2 + 1))[:m, :n]


def mosaic(light: Light) -> Light:
    """One colour of each pixel, RGGB, (m, n) of (3, m, n)."""
    return np.take_along_axis(light, _colour_of(light.shape[1:])[None].astype(np.intp), axis=0)[0]


def bayer_gains(shape: tuple[int, ...]) -> Light:
    """White balance of each pixel of the mosaic."""
    return GAINS[_colour_of(shape)]


_CROSS = np.array([[0, 0, -1, 0, 0], [0, 0, 2, 0, 0], [-1, 2, 4, 2, -1], [0, 0, 2, 0, 0], [0, 0, -1, 0, 0]]) / 8
_ROW = np.array([[0, 0, 0.5, 0, 0], [0, -1, 0, -1, 0], [-1, 4, 5, 4, -1], [0, -1, 0, -1, 0], [0, 0, 0.5, 0, 0]]) / 8
_DIAGONAL = (
    np.array([[0, 0, -1.5, 0, 0], [0, 2, 0, 2, 0], [-1.5, 0, 6, 0, -1.5], [0, 2, 0, 2, 0], [0, 0, -1.5, 0, 0]]) / 8
)


def demosaiced(raw: Light) -> Light:
    """Colours (3, m, n) of an RGGB mosaic (m, n), by gradient-corrected linear filters (Malvar, He, Cutler 2004)."""
    cross, row, column, diagonal = (
        ndimage.correlate(raw, kernel.astype(np.float32), mode="mirror") for kernel in (_CROSS, _ROW, _ROW.T, _DIAGONAL)
    )
    red, green, blue = raw.copy(), raw.copy(), raw.copy()
    green[::2, ::2], green[1::2, 1::2] = cross[::2, ::2], cross[1::2, 1::2]
    red[::2, 1::2], red[1::2, ::2], red[1::2, 1::2] = row[::2, 1::2], column[1::2, ::2], diagonal[1::2, 1::2]
    blue[1::2, ::2], blue[::2, 1::2], blue[::2, ::2] = row[1::2, ::2], column[::2, 1::2], diagonal[::2, ::2]
    return np.stack([red, green, blue])


def srgb(linear: Light) -> Light:
    """Values 0 to 1 of IEC 61966-2-1."""
    value = np.clip(linear, 0, 1)
    return np.where(value <= 0.0031308, 12.92 * value, 1.055 * value ** np.float32(1 / 2.4) - 0.055)


def camera_tables(quality: int) -> list[list[int]]:
    """Quantisation of luminance and chroma, 8 x 8 by rows, that rises steadily with frequency; no program's standard.

    quality  1 to 100, from which the mean step follows as in the standard tables
    """
    scale = (200 - 2 * quality) / 100 if quality >= 50 else 50 / quality
    u, v = np.mgrid[:8, :8]
    rise = 1 + 0.28 * (u + v)
    return [np.clip(np.rint(step * scale * rise), 1, 255).astype(int).ravel().tolist() for step in (18, 24)]


def write_photograph(picture: NDArray[np.uint8], path: Path, camera: Camera, sensor: Sensor, second: int) -> None:
    """Write a picture (m, n, 3) with make, model, focal length and time; `second` counts from the first photograph."""
    exif = Image.Exif()
    exif[0x010F], exif[0x0110] = "Rendered", camera.model
    exif[0x0112] = 1
    time = f"2026:06:01 {10 + second // 3600:02d}:{second // 60 % 60:02d}:{second % 60:02d}"
    folder = exif.get_ifd(0x8769)
    folder[0x9003] = time
    folder[0x920A] = round(camera.interior.c, 2)
    folder[0xA405] = round(camera.focal_35mm)
    folder[0xA002], folder[0xA003] = camera.width_px, camera.height_px
    image = Image.fromarray(picture)
    if sensor.quality and sensor.tables == "camera":
        tables = camera_tables(sensor.quality)
        image.save(path, qtables=tables, subsampling=SUBSAMPLING[sensor.subsampling], exif=exif)
    elif sensor.quality:
        image.save(path, quality=sensor.quality, subsampling=SUBSAMPLING[sensor.subsampling], exif=exif)
    else:
        image.save(path, exif=exif)
