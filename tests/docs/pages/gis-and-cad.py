# %%
import pyogrio

for layer, shape in pyogrio.list_layers("map.gpkg"):
    print(layer, shape, pyogrio.read_info("map.gpkg", layer=layer)["features"])
