# %% The same map by rasterio
import warnings

import rasterio

warnings.simplefilter("ignore", rasterio.errors.NotGeoreferencedWarning)
said = rb.rpc_correct("scene/scene.tif", "scene/control.gpkg", image_sigma=0.4)
with rasterio.open("scene/scene.tif") as scene, rasterio.open("scene/heights.tif") as heights:
    done = rb.rpc_ortho(scene, heights, rpc=said.corrected, pixel=2.0)
    other, _ = rasterio.warp.reproject(
        scene.read(1),
        done.values[0].copy(),
        rpcs=said.corrected.to_rasterio(),
        src_crs="EPSG:4326",
        dst_transform=done.transform,
        dst_crs=done.crs,
        RPC_DEM="scene/heights.tif",
    )
print(done.values.shape, other.shape)
