"""Rasters as GDAL writes them: read with the values that they hold, or refused for what they are."""

import numpy as np
import pytest

from raybundle.errors import InputError, code_of
from raybundle.io.photos import tiff_bands
from raybundle.io.photos.container import Unusable, decode_channels, read_header
from raybundle.io.photos.photo import find_photos, read_colour, read_grey, read_photo

rasterio = pytest.importorskip("rasterio")
pytestmark = pytest.mark.filterwarnings("ignore::rasterio.errors.NotGeoreferencedWarning")
LUMINANCE = np.array([0.299, 0.587, 0.114])
LIMITS = {"uint8": (0, 255), "int8": (-100, 120), "uint16": (300, 4000), "int16": (-500, 3000), "uint32": (0, 90_000),
          "int32": (-9000, 90_000), "float32": (-0.1, 1.3), "float64": (270.0, 320.0)}  # fmt: skip
SIZE = 160, 96
RGBN = {"photometric": "rgb", "ALPHA": "NO"}
KINDS = [
    *((n, dtype, {"interleave": i}) for n in (1, 2, 3, 4, 5, 8) for dtype in LIMITS for i in ("pixel", "band")),
    *((n, dtype, {"compress": c, "tiled": n > 1, "blockxsize": 64, "blockysize": 64})
      for c in ("lzw", "deflate", "zstd", "packbits", "lzma")
      for n, dtype in ((1, "uint16"), (3, "uint8"), (5, "float32"))),
    *((n, dtype, {"BIGTIFF": "YES", "interleave": i}) for n, dtype in ((1, "uint8"), (3, "uint16"), (4, "float32"))
      for i in ("pixel", "band")),
    *((n, dtype, {"compress": "deflate", "predictor": p, "ENDIANNESS": e}) for e in ("LITTLE", "BIG")
      for n, dtype, p in ((1, "uint16", 2), (3, "int32", 2), (1, "float32", 3), (3, "float64", 3), (2, "float32", 3))),
    (1, "uint16", {"photometric": "miniswhite", "BIGTIFF": "YES"}), (3, "uint16", {"photometric": "rgb"}),
    (4, "uint16", RGBN), (3, "uint8", {"photometric": "minisblack"}), (3, "float32", {"photometric": "rgb"}),
    (1, "float32", {"compress": "lerc"}), (1, "int16", {"nodata": -500}),
    (1, "uint16", {"SPARSE_OK": "TRUE", "compress": "lzw"}),
]  # fmt: skip


def texture(n, dtype, size=SIZE):
    """Bands of different contrast, over the usual range of their numbers."""
    x, y = np.meshgrid(np.arange(size[0]), np.arange(size[1]))
    base = (np.sin(x / 9) + np.cos(y / 7)) / 4 + 0.5
    low, high = LIMITS[dtype]
    return np.stack([low + (high - low) * base * (1 - 0.05 * k) for k in range(n)]).astype(dtype)


def written(path, bands, driver="GTiff", **given):
    n, height, width = bands.shape
    how = {"driver": driver, "width": width, "height": height, "count": n, "dtype": bands.dtype, **given}
    with rasterio.open(path, "w", **how) as file:
        file.write(bands)
    return path


def expected(bands, *, colours, nodata=None):
    """Grey values of the band, or of red, green and blue."""
    shown = bands[:3] if colours else bands[:1]
    if shown.dtype not in (np.uint8, np.uint16):
        good = shown != nodata if nodata is not None else np.ones(shown.shape, bool)
        if shown.dtype.kind == "f" or shown[good].min() < 0 or shown[good].max() > 65535:
            low, high = np.percentile(shown[good].astype(float), (0.1, 99.9))
            shown = np.clip(np.round((shown.astype(float) - low) / (high - low) * 65535), 0, 65535)
        shown = np.where(good, shown, 0)
    return np.tensordot(LUMINANCE, shown, 1) if colours else shown[0]


@pytest.mark.parametrize(
    ("n", "dtype", "how"), KINDS, ids=lambda v: "-".join(map(str, v.values())) if isinstance(v, dict) else v
)
def test_a_tiff_of_gdal_is_read(n, dtype, how, tmp_path):
    how = {k: v for k, v in how.items() if n > 1 or k != "interleave"}
    bands = texture(n, dtype)
    path = written(tmp_path / "a.tif", bands, **how)
    photo = read_photo(path)
    grey = read_grey(photo)
    assert (photo.width_px, photo.height_px) == SIZE
    assert grey.dtype == (np.uint16 if photo.bits == 16 else np.uint8)
    colours = how.get("photometric") == "rgb" or (dtype == "uint8" and n in {3, 4} and "photometric" not in how)
    stored = 65535 - bands if how.get("photometric") == "miniswhite" else bands
    assert np.abs(grey - expected(stored, colours=colours, nodata=how.get("nodata"))).max() <= 1
    assert read_colour(photo).shape == (*grey.shape, 3)
    channels, alpha = decode_channels(path, photo.kind)
    assert channels.shape[:2] == grey.shape
    assert alpha is None or n in {2, 4}
    remarks = [r for r in photo.metadata.remarks if code_of(r) == "photo_entry.bands"]
    plain = dtype in {"uint8", "uint16"} and (
        n == 1 or (colours and (n == 3 or dtype == "uint8")) or (dtype == "uint8" and n == 2)
    )
    assert len(remarks) == (not plain or ("band" in how.values() and n == 2))


@pytest.mark.parametrize(
    ("n", "how"), [(1, {}), (3, {"photometric": "ycbcr"}), (3, {"BIGTIFF": "YES"}), (1, {"tiled": True})]
)
def test_jpeg_in_tiff(n, how, tmp_path):
    path = written(tmp_path / "a.tif", texture(n, "uint8"), compress="jpeg", **how)
    with rasterio.open(path) as file:
        found = file.read()
    grey = read_grey(read_photo(path))
    assert np.abs(grey - (np.tensordot(LUMINANCE, found, 1) if n == 3 else found[0])).max() <= 3


@pytest.mark.parametrize(("n", "dtype"), [(1, "uint8"), (1, "uint16"), (3, "uint8"), (4, "uint16")])
def test_jpeg_2000_through_rasterio(n, dtype, tmp_path):
    path = written(tmp_path / "a.jp2", texture(n, dtype), "JP2OpenJPEG", QUALITY="100", REVERSIBLE="YES")
    grey = read_grey(read_photo(path))
    assert np.abs(grey - expected(texture(n, dtype), colours=False)).max() <= 1


def test_without_rasterio_other_compressions_are_refused_with_a_remedy(tmp_path, monkeypatch):
    lerc = written(tmp_path / "lerc.tif", texture(1, "float32"), compress="lerc")
    jp2 = written(tmp_path / "a.jp2", texture(1, "uint8"), "JP2OpenJPEG")
    monkeypatch.setattr("raybundle.io.raster_library.found_raster_library", lambda: None)
    monkeypatch.setattr(tiff_bands, "found_raster_library", lambda: None)
    with pytest.raises(InputError, match=r"tiff\.compression"):
        read_grey(read_photo(lerc))
    with pytest.raises(InputError, match=r"package\.rasterio_missing"):
        read_photo(jp2)
    assert read_grey(read_photo(written(tmp_path / "a.tif", texture(5, "float32")))).dtype == np.uint16


def test_not_finite_and_constant_pixels(tmp_path):
    bands = texture(1, "float32")
    bands[0, :5] = np.nan
    bands[0, 5] = np.inf
    grey = read_grey(read_photo(written(tmp_path / "a.tif", bands)))
    assert (grey[:6] == 0).all()
    assert grey[6:].max() == 65535
    assert (read_grey(read_photo(written(tmp_path / "b.tif", np.full((1, 40, 40), 7.5)))) == 0).all()


def test_what_is_no_photograph_is_refused(tmp_path):
    place = rasterio.Affine(0.2, 0, 500_000, 0, -0.2, 5_400_000)
    with pytest.raises(InputError, match=r"photograph\.map_raster"):
        read_photo(written(tmp_path / "dem.tif", texture(1, "float32"), transform=place, crs="EPSG:32633"))
    read_photo(written(tmp_path / "ortho.tif", texture(1, "uint16"), transform=place, crs="EPSG:32633"))
    with pytest.raises(Unusable, match=r"photograph\.tiff_pixels"):
        read_header(written(tmp_path / "c.tif", texture(1, "float32").astype("complex64")), limit_pixels=10**6)
    with pytest.raises(InputError, match=r"photograph\.too_large"):
        read_photo(tmp_path / "ortho.tif", limit_pixels=1000)


def test_one_remark_for_all_photographs_of_a_camera(tmp_path):
    for k in range(3):
        written(tmp_path / f"{k}.tif", texture(5, "uint16") + k)
    found = find_photos([tmp_path])
    assert len(found.photos) == 3
    assert (
        len([r for r in found.remarks if "photo_entry" in str(getattr(r, "message", "")) or "band" in r.lower()]) == 1
    )
