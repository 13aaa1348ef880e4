# %% A scene of 4000 lines in 0.6 s from 600 km above the equator:
import json
import numpy as np

t = np.arange(-0.5, 0.51, 0.05)
r = 6_378_137.0 + 600_000.0
phase = 0.00109 * t  # rad, to the north
positions = np.stack([r * np.cos(phase), 0 * t, r * np.sin(phase)], axis=1)
half = (np.pi / 2 + phase) / 2  # the detector's third axis to the centre of the earth, its first to the south
pointing = np.stack([np.cos(half), 0 * t, np.sin(half), 0 * t], axis=1)
times = {"ephemeris_times": (1000 + t).tolist()}
scene = {
    "name_model": "USGS_ASTRO_LINE_SCANNER_SENSOR_MODEL",
    "name_sensor": "MADE_UP",
    "image_lines": 4000,
    "image_samples": 6000,
    "center_ephemeris_time": 1000.0,
    "line_scan_rate": [[0.5, -0.3, 0.6 / 4000]],
    "detector_center": {"line": 0.5, "sample": 3000.0},
    "starting_detector_line": 0.5,
    "starting_detector_sample": 0,
    "detector_line_summing": 1,
    "detector_sample_summing": 1,
    "focal2pixel_lines": [0.0, 125.0, 0.0],
    "focal2pixel_samples": [0.0, 0.0, 125.0],
    "focal_length_model": {"focal_length": 8000.0},
    "radii": {"semimajor": 6378.137, "semiminor": 6356.752314245, "unit": "km"},
    "instrument_position": {"unit": "m", "positions": positions.tolist(), **times},
    "instrument_pointing": {"quaternions": (pointing * [1, 1, -1, 1]).tolist(), **times},
    "body_rotation": {"quaternions": [[1, 0, 0, 0]] * len(t), **times},
}
with open("scene.json", "w") as file:
    json.dump(scene, file)

# %%
with open("image-points.csv", "w") as file:
    file.write("point,x_px,y_px,h_m\nA,700,600,250\nB,5200,900,300\nC,2900,2100,100\nD,1100,3500,420\nE,5500,3300,50\n")

# %% Five points moved by 7.3 and -4.1 px, measured to 0.2 px.
import csv

rng = np.random.default_rng(2)
with open("ground.csv", newline="") as file:
    rows = list(csv.DictReader(file))
with open("control.csv", "w") as file:
    file.write("point,lon_deg,lat_deg,h_m,x_px,y_px\n")
    for row in rows:
        x = float(row["x_px"]) + 7.3 + rng.normal(0, 0.2)
        y = float(row["y_px"]) - 4.1 + rng.normal(0, 0.2)
        file.write(f"{row['point']},{row['lon_deg']},{row['lat_deg']},{row['h_m']},{x},{y}\n")

# %%
from pyproj import Transformer

to_utm = Transformer.from_crs("EPSG:4979", "EPSG:32631", always_xy=True)
with open("control.csv", newline="") as file, open("utm.csv", "w") as out:
    out.write("point,X,Y,Z,x_px,y_px\n")
    for row in csv.DictReader(file):
        x, y, z = to_utm.transform(float(row["lon_deg"]), float(row["lat_deg"]), float(row["h_m"]))
        out.write(f"{row['point']},{x},{y},{z},{row['x_px']},{row['y_px']}\n")

# %%
from pathlib import Path

Path("scenes").mkdir()
text = Path("scene_RPC.TXT").read_text()
points = Path("control.csv").read_text().splitlines()
rows = [points[0] + ",image"]
for name in ("monday", "tuesday"):
    Path(f"scenes/{name}_RPC.TXT").write_text(text)
    rows += [f"{row},{name}.tif" for row in points[1:]]
Path("scenes/broken_RPC.TXT").write_text(text[:200])
Path("all.csv").write_text("\n".join(rows) + "\n")

# %%
from raybundle.io.scenes import read_scene
from raybundle.scenes.bias_choice import choose_bias

rpc = read_scene("corrected_RPC.TXT").rpc
with open("control.csv", newline="") as file:
    columns = ("lon_deg", "lat_deg", "h_m", "x_px", "y_px")
    control = np.array([[float(r[k]) for k in columns] for r in csv.DictReader(file)])
xy, by_ground = rpc.project_with_partials(control[:, :3])
assert np.abs(xy - control[:, 3:]).max() < 1
assert by_ground.shape == (5, 2, 3)
assert choose_bias(rpc, control[:, :3], control[:, 3:], sigma_px=0.2).advised.kind == "none"

print(correction.corrected.to_rasterio().err_bias)
assert abs(correction.corrected.to_rasterio().samp_off - (correction.corrected.image_offset[0] - 0.5)) < 1e-9
