# %% The figures above are held by this:
import warnings
from pathlib import Path

import numpy as np
import rasterio
from pyproj import Transformer

import raybundle as rb
from raybundle.io.scenes.control import read_scene_control

warnings.simplefilter("ignore", rasterio.errors.NotGeoreferencedWarning)
said = rb.rpc_correct("scene/scene.tif", "scene/control.gpkg", image_sigma=0.4)
assert np.allclose(said.fit.values, [9.36, -6.46], atol=0.02)
assert np.allclose(said.fit.sigma, 0.15, atol=0.01)
assert np.allclose(said.checked.rms_px, [0.37, 0.34], atol=0.02)
assert abs(said.checked.rms_m - 0.22) < 0.01
assert abs(said.errors.err_bias_m - 0.10) < 0.01
assert abs(said.errors.err_rand_m - 0.24) < 0.01
assert np.allclose(said.errors.per_height, [-0.31, -0.03], atol=0.01)
with rasterio.open("scene/corrected.tif") as raster:
    assert abs(raster.rpcs.err_bias - said.corrected.err_bias_m) < 1e-12
# roads, bright in the scene, lie in the map where the check points were surveyed
control = read_scene_control(Path("scene/control.gpkg"))
to_map = Transformer.from_crs("EPSG:4326", "EPSG:32633", always_xy=True)
places = np.stack(to_map.transform(*control.geographic[:, :2].T), axis=1)
with rasterio.open("scene/ortho.tif") as raster:
    grey = np.array([v[0] for v in raster.sample(places)])
assert grey.min() > 1100, grey
