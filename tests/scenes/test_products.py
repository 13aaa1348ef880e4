"""Products that hold no geometry of a scene are named for what they are."""

import numpy as np
import pytest

from raybundle.commands.scenes.inputs import scene_input
from raybundle.errors import InputError
from raybundle.io.scenes import read_scene
from raybundle.io.scenes.products import SCALE, TIE_POINTS, raster_without_model
from tests.messages import refused

SENTINEL2 = '<?xml version="1.0"?><n1:{level}_User_Product xmlns:n1="https://psd-14.sentinel2.eo.esa.int/PSD/a.xsd"/>'
FILES = {
    "LC09_L1TP_MTL.txt": (b"GROUP = LANDSAT_METADATA_FILE\n  GROUP = PRODUCT_CONTENTS\n", "scene.is_map", "landsat"),
    "LT05_MTL.txt": (b"GROUP = L1_METADATA_FILE\n", "scene.is_map", "landsat"),
    "LC09_MTL.json": (b'{"LANDSAT_METADATA_FILE": {}}', "scene.is_map", "landsat"),
    "LC09_MTL.xml": (b"<LANDSAT_METADATA_FILE></LANDSAT_METADATA_FILE>", "scene.is_map", "landsat"),
    "MTD_MSIL1C.xml": (SENTINEL2.format(level="Level-1C").encode(), "scene.is_map", "sentinel2"),
    "MTD_MSIL2A.xml": (SENTINEL2.format(level="Level-2A").encode(), "scene.is_map", "sentinel2"),
    "MTD_MSIL1B.xml": (SENTINEL2.format(level="Level-1B").encode(), "scene.product_not_read", "sentinel2"),
    "DIM_ORT.XML": (
        b"<Dimap_Document><Dataset_Content><DATASET_TYPE>RASTER_ORTHO</DATASET_TYPE></Dataset_Content></Dimap_Document>",
        "scene.is_map", "orthoimage",
    ),
    "AST_L1A_003.hdf": (b"\x0e\x03\x13\x01" + bytes(40), "scene.product_not_read", "aster"),
    "saocom.xml": (b"<SAOCOM_XMLProduct><Channel/></SAOCOM_XMLProduct>", "scene.product_not_read", "saocom"),
    "K5_Aux.xml": (b"<Root><MissionID>KMPS</MissionID></Root>", "scene.product_not_read", "kompsat5"),
    "umbra.cphd": (b"CPHD/1.1.0\nXML_BLOCK_SIZE := 10\n", "scene.product_not_read", "cphd"),
    "DAT_01.001": (b"\x00\x00\x00\x01\x3f\xc0\x12\x12\x00\x00\x02\xd0" + bytes(800), "scene.product_not_read", "ceos"),
    "VDF_DAT.001": (b"\x00\x00\x00\x01\xc0\xc0\x12\x12\x00\x00\x01\x68" + bytes(40), "scene.product_not_read", "ceos"),
}  # fmt: skip


@pytest.mark.parametrize("name", FILES)
def test_a_product_is_named(tmp_path, name):
    content, code, what = FILES[name]
    (tmp_path / name).write_bytes(content)
    with refused(code, file=name, what=what):
        read_scene(tmp_path / name)


def test_a_folder_with_one_metadata_file_is_named(tmp_path):
    (tmp_path / "S2A.SAFE").mkdir()
    (tmp_path / "S2A.SAFE" / "MTD_MSIL1C.xml").write_bytes(FILES["MTD_MSIL1C.xml"][0])
    with refused("scene.is_map", what="sentinel2"):
        read_scene(tmp_path / "S2A.SAFE")


def test_rasters_are_maps_or_lack_their_orbit(tmp_path):
    rasterio = pytest.importorskip("rasterio")
    from rasterio.control import GroundControlPoint

    def written(name, **georeference):
        with rasterio.open(
            tmp_path / name, "w", driver="GTiff", width=8, height=8, count=1, dtype="uint8",
            **georeference,
        ) as raster:  # fmt: skip
            raster.write(np.ones((1, 8, 8), np.uint8))
        return tmp_path / name

    corners = [GroundControlPoint(r, c, 15 + c / 1e3, 48 - r / 1e3, 0) for r in (0, 7) for c in (0, 7)]
    cases = {
        "map.tif": ({"crs": "EPSG:32633", "transform": rasterio.Affine(10, 0, 5e5, 0, -10, 5.3e6)}, "scene.is_map"),
        "grd.tif": ({"crs": "EPSG:4326", "gcps": corners}, "scene.no_orbit"),
    }
    for name, (georeference, code) in cases.items():
        path = written(name, **georeference)
        for read in (read_scene, scene_input):
            with pytest.raises(InputError) as caught:
                read(path)
            assert caught.value.code == code


@pytest.mark.parametrize(
    ("scale", "tie", "is_map"),
    [((0.1, 0.1, 0.0), 4e5, True), ((0.0, 0.0, 0.0), 4e5, False), ((np.nan, 0.1, 0.0), 4e5, False),
     ((0.1, 0.1, 0.0), np.nan, False)],
)  # fmt: skip
def test_only_finite_placements_make_a_map(tmp_path, scale, tie, is_map):
    from PIL import Image, TiffImagePlugin

    tags = TiffImagePlugin.ImageFileDirectory_v2()
    for tag, values in ((SCALE, scale), (TIE_POINTS, (0.0, 0.0, 0.0, tie, 5.7e6, 0.0))):
        tags[tag], tags.tagtype[tag] = values, 12
    Image.new("L", (8, 8)).save(tmp_path / "a.tif", tiffinfo=tags)
    found = raster_without_model(tmp_path / "a.tif")
    assert (found is not None and found.code == "scene.is_map") == is_map
