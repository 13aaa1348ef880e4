"""TIFFs as GDAL writes them by default: read, or refused for what they are."""

import numpy as np
import pytest

from raybundle.io.photos.container import Unusable, read_header

rasterio = pytest.importorskip("rasterio")

KINDS = [
    (bands, dtype, interleave)
    for bands in (1, 2, 3, 4, 5, 8)
    for dtype in ("uint8", "uint16", "int16", "float32", "float64")
    for interleave in ("pixel", "band")
]


@pytest.mark.filterwarnings("ignore::rasterio.errors.NotGeoreferencedWarning")
@pytest.mark.parametrize(("bands", "dtype", "interleave"), KINDS)
def test_a_tiff_of_gdal_is_read_or_refused_for_its_bands_and_bits(bands, dtype, interleave, tmp_path):
    path = tmp_path / "a.tif"
    given = {"interleave": interleave} if bands > 1 else {}
    with rasterio.open(path, "w", driver="GTiff", width=40, height=30, count=bands, dtype=dtype, **given) as file:
        file.write(np.ones((bands, 30, 40), dtype))
    try:
        header = read_header(path, limit_pixels=10**6)
    except Unusable as error:
        found = error.message
        assert found.code in {"photograph.bits", "photograph.tiff_pixels"}
        assert found.values.get("bands", bands) == bands
        assert dtype != "uint8" or bands not in (1, 3)
    else:
        assert (header.width_px, header.height_px) == (40, 30)
