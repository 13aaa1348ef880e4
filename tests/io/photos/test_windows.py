"""Windows of large TIFF files: any layout and compression gives the pixels that Pillow and rasterio give."""

import struct

import numpy as np
import pytest
from PIL import Image

from raybundle.errors import InputError
from raybundle.io.photos.windows import Windows
from raybundle.io.reading.tiff import is_tiff, tiff_tags

WINDOWS = [(0, 0, 300, 200), (17, 33, 18, 34), (100, 60, 299, 199), (250, 0, 300, 70)]
rng = np.random.default_rng(2)
GREY = (np.add.outer(np.arange(200), 3 * np.arange(300)) * 7 + rng.integers(0, 900, (200, 300))).astype(np.uint16)


def check(path, pixels):
    windows = Windows.of(path)
    assert (windows.width_px, windows.height_px) == (300, 200)
    for x0, y0, x1, y1 in WINDOWS:
        found = windows.read(x0, y0, x1, y1)
        assert found.dtype == pixels.dtype
        np.testing.assert_array_equal(found, pixels[y0:y1, x0:x1])


@pytest.mark.parametrize("compression", [None, "tiff_deflate", "tiff_lzw", "packbits", "tiff_adobe_deflate"])
@pytest.mark.parametrize("bits", [8, 16])
def test_strips(tmp_path, compression, bits):
    pixels = GREY if bits == 16 else (GREY >> 5).astype(np.uint8)
    Image.fromarray(pixels).save(tmp_path / "a.tif", compression=compression)
    check(tmp_path / "a.tif", pixels)


LAYOUTS = {
    "plain tiles": {"tiled": True, "blockxsize": 64, "blockysize": 48},
    "packed tiles": {"tiled": True, "blockxsize": 64, "blockysize": 48, "compress": "DEFLATE", "predictor": 2},
    "lzw strips, big": {"BIGTIFF": "YES", "compress": "LZW", "blockysize": 7},
    "big endian": {"ENDIANNESS": "BIG"},
    "big endian, packed": {
        "ENDIANNESS": "BIG",
        "compress": "DEFLATE",
        "tiled": True,
        "blockxsize": 32,
        "blockysize": 32,
    },
}


@pytest.mark.parametrize("options", LAYOUTS.values(), ids=LAYOUTS)
def test_layouts(tmp_path, options):
    rasterio = pytest.importorskip("rasterio")
    path = tmp_path / "a.tif"
    with (
        pytest.warns(rasterio.errors.NotGeoreferencedWarning),
        rasterio.open(path, "w", driver="GTiff", width=300, height=200, count=1, dtype="uint16", **options) as file,
    ):
        file.write(GREY, 1)
    check(path, GREY)


@pytest.mark.parametrize("interleave", ["PIXEL", "BAND"])
@pytest.mark.parametrize("compress", ["NONE", "DEFLATE"])
def test_bands(tmp_path, interleave, compress):
    """Of three bands the mean where they stand together, the first where each has strips of its own."""
    rasterio = pytest.importorskip("rasterio")
    bands = np.stack([GREY >> 1, GREY >> 2, GREY >> 3])
    path = tmp_path / "a.tif"
    with pytest.warns(rasterio.errors.NotGeoreferencedWarning), rasterio.open(
        path, "w", driver="GTiff", width=300, height=200, count=3, dtype="uint16", interleave=interleave,
        compress=compress, photometric="MINISBLACK",
    ) as file:  # fmt: skip
        file.write(bands)
    check(path, np.round(bands.mean(axis=0)).astype(np.uint16) if interleave == "PIXEL" else bands[0])


def test_white_is_zero(tmp_path):
    Image.fromarray(GREY).save(tmp_path / "a.tif", tiffinfo={262: 0})
    if tiff_tags(tmp_path / "a.tif")[1][262] != (0,):
        pytest.skip("Pillow writes black as zero")
    check(tmp_path / "a.tif", 65535 - GREY)


def test_only_what_is_needed_is_read(tmp_path, monkeypatch):
    Image.fromarray(GREY).save(tmp_path / "a.tif", compression="tiff_deflate", strip_size=300 * 2 * 8)
    windows = Windows.of(tmp_path / "a.tif")
    decoded: list[int] = []
    original = Windows.decoded
    monkeypatch.setattr(Windows, "decoded", lambda self, k: decoded.append(k) or original(self, k))
    windows.read(10, 20, 200, 30)
    assert len(decoded) <= 3
    windows.read(20, 21, 30, 29)
    assert len(decoded) <= 3  # still held


@pytest.mark.parametrize(
    ("change", "message"),
    [
        (lambda b: b[: len(b) // 2], r"tiff\.ends_early"),
        (lambda _: b"no TIFF at all", r"tiff\.no_tiff"),
        (lambda b: b[:4] + struct.pack("<I", len(b) + 9) + b[8:], r"tiff\.ends_early"),
    ],
    ids=["cut", "other", "pointer"],
)
def test_damaged_files(tmp_path, change, message):
    Image.fromarray(GREY).save(tmp_path / "a.tif")
    (tmp_path / "b.tif").write_bytes(change((tmp_path / "a.tif").read_bytes()))
    with pytest.raises(InputError, match=message):
        Windows.of(tmp_path / "b.tif")


def test_other_pixels_are_refused(tmp_path):
    Image.fromarray(GREY.astype(np.float32)).save(tmp_path / "a.tif")
    assert is_tiff(tmp_path / "a.tif")
    with pytest.raises(InputError, match=r"32.*3.*8.*16.*tiff\.pixel_format"):
        Windows.of(tmp_path / "a.tif")
