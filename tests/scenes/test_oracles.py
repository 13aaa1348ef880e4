"""Pixel conventions, one test per program: rpcm counts from the centre of the first pixel, the others as we do."""

import sys
import types
import warnings

import numpy as np
import pytest

from raybundle.io.scenes import read_scene
from raybundle.io.scenes.rpc_text import write_rpc_text

FILES = ("rpc/rpc_IKONOS.txt", "rpc/rpc_PLEIADES.xml", "rpc/rpc_WV3.xml")
PLEIADES = "shareloc/RPC_PHR1B_P_201709281038393_SEN_PRG_FC_178609-001.XML"


def ground(rpc, n=2000):
    rng = np.random.default_rng(3)
    return rpc.ground_offset + rpc.ground_scale * rng.uniform(-0.9, 0.9, (n, 3))


@pytest.fixture
def rpcm(monkeypatch):
    # its terrain model is a compiled package of its own, which projection does not need
    monkeypatch.setitem(sys.modules, "srtm4", types.ModuleType("srtm4"))
    return pytest.importorskip("rpcm", reason="rpcm is not installed (pip install --no-deps rpcm geojson)")


@pytest.mark.parametrize("file", FILES)
def test_rpcm_counts_half_a_pixel_less(sensors, rpcm, file):
    rpc = read_scene(sensors / file).rpc
    points = ground(rpc)
    column, row = rpcm.rpc_from_rpc_file(str(sensors / file)).projection(*points.T)
    assert np.abs(rpc.project(points) - np.stack([column, row], axis=1) - 0.5).max() < 1e-9


def test_rasterio_counts_as_we_do(sensors, tmp_path):
    rasterio = pytest.importorskip("rasterio", reason="rasterio is not installed")
    from rasterio.transform import RPCTransformer

    rpc = read_scene(sensors / FILES[0]).rpc
    write_rpc_text(rpc, tmp_path / "image_RPC.TXT")
    blank = {"driver": "GTiff", "width": 8, "height": 8, "count": 1, "dtype": "uint8"}
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")  # an image without georeference
        with rasterio.open(tmp_path / "image.tif", "w", **blank) as image:
            image.write(np.zeros((1, 8, 8), np.uint8))
        with rasterio.open(tmp_path / "image.tif") as image, RPCTransformer(image.rpcs) as transformer:
            points = ground(rpc, 50)
            rows, columns = transformer.rowcol(*points.T, op=lambda v: v)
    assert np.abs(rpc.project(points) - np.stack([columns, rows], axis=1)).max() < 1e-6


def test_shareloc_counts_as_we_do(sensors):
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")
        module = pytest.importorskip("shareloc.geomodels", reason="shareloc is not installed")
        model = module.GeoModel(str(sensors / PLEIADES))
        rpc = read_scene(sensors / PLEIADES).rpc
        points = ground(rpc, 50)
        rows, columns, _ = model.inverse_loc(*np.ascontiguousarray(points.T))
    assert np.abs(rpc.project(points) - np.stack([columns, rows], axis=1)).max() < 1e-6
