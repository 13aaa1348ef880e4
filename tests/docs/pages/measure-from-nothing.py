# %% Photographs of a facade, and clicks in two
from pathlib import Path

from PIL import Image

import raybundle as rb

# places of nine points in three photographs of a facade, as a person clicks them [px]
clicks = {
    "ridge left": [(437.3, 331.7), (479.6, 444.0), (500.3, 514.6)],
    "ridge right": [(2226.3, 579.9), (2279.6, 572.2), (2288.9, 517.6)],
    "lantern": [(1283.9, 402.2), (1363.0, 444.2), (1414.7, 449.5)],
    "sill": [(1339.2, 1197.6), (1340.3, 1215.9), (1305.6, 1213.3)],
    "corner left": [(177.4, 1751.7), (193.5, 1719.6), (192.7, 1682.9)],
    "corner right": [(2527.4, 1570.7), (2558.5, 1588.5), (2539.3, 1594.6)],
    "window": [(2016.3, 1149.0), (2067.8, 1156.1), (2082.1, 1138.5)],
    "step": [(1818.4, 1733.8), (1815.1, 1739.9), (1768.8, 1738.6)],
    "chimney": [(803.3, 798.7), (862.2, 849.2), (896.1, 871.9)],
}
Path("archive").mkdir()
for k in range(3):
    exif = Image.Exif()
    exif[272] = "Z612"
    exif.get_ifd(0x8769).update({0x920A: 5.85, 0xA405: 35})  # focal length, and as of 35 mm film
    Image.new("L", (2832, 2128), 90 + k).save(f"archive/old_{k + 1}.jpg", exif=exif)
for k in range(2):
    for point, places in clicks.items():
        rb.mark("archive", "put", image=f"old_{k + 1}.jpg", point=point, x_px=places[k][0], y_px=places[k][1])
# %%
for point, places in clicks.items():
    if point != "sill":
        rb.mark("archive", "put", image="old_3.jpg", point=point, x_px=places[2][0], y_px=places[2][1])
rb.mark("archive", "bar", start="corner left", end="corner right", length=7.68, sigma=0.01)
