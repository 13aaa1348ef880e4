# %% 4000 lines of 3 m from 693 km, off 48 N 15 E
import csv
import json
import numpy as np
from raybundle.scenes.kinds.range_doppler import side_looking

made = side_looking((15.0, 48.0, 300.0), size_px=(4000, 4000))
start = float(made.burst_times[0]) + made.line_s / 2
scene = {
    "name_model": "USGS_ASTRO_SAR_SENSOR_MODEL",
    "name_sensor": "MADE_UP",
    "image_lines": 4000,
    "image_samples": 4000,
    "center_ephemeris_time": 0.0,
    "starting_ephemeris_time": start,
    "line_exposure_duration": made.line_s,
    "scaled_pixel_width": made.pixel_m,
    "wavelength": 0.031,
    "look_direction": "right",
    "range_conversion_times": [-1.0, 1.0],
    "range_conversion_coefficients": [[made.first_m + made.pixel_m / 2, 1.0, 0.0, 0.0]] * 2,
    "radii": {"semimajor": 6378.137, "semiminor": 6356.752314245, "unit": "km"},
    "instrument_position": {
        "unit": "m",
        "positions": made.orbit.positions.tolist(),
        "velocities": made.orbit.velocities.tolist(),
        "ephemeris_times": made.orbit.times.tolist(),
    },
    "body_rotation": {
        "quaternions": [[1, 0, 0, 0]] * 2,
        "angular_velocities": [[0, 0, 0]] * 2,
        "ephemeris_times": [-60.0, 60.0],
    },
}
with open("radar.json", "w") as file:
    json.dump(scene, file)
# %% A radar and an optical scene of 40 points, four control points
from pathlib import Path
from raybundle.io.scenes.rpc_text import write_rpc_text
from raybundle.numerics.places import Local
from raybundle.scenes.rpc_fit import fit_rpc
from raybundle.scenes.simulate import OrbitPlan, orbit_scene

optical = orbit_scene(OrbitPlan(target=(15.0, 48.0, 300.0), gsd_m=2.0, width_px=6000, height_px=6000))
rpc = fit_rpc(optical.localise, (6000, 6000), (0.0, 600.0)).rpc
folder = Path("block")
(folder / "scenes").mkdir(parents=True)
write_rpc_text(rpc, folder / "scenes/optical_RPC.TXT")
(folder / "scenes/radar.json").write_text(Path("radar.json").read_text())
(folder / "block.toml").write_text("""
name = "radar and optical"

[frame]
kind = "local"
origin = [15.0, 48.0, 300.0]

[cameras.radar]
model = "range_doppler"
scene = "scenes/radar.json"
height_m = 300.0
sigma = {dr = 5.0, dt = 5e-4}

[cameras.optical]
model = "rpc"
scene = "scenes/optical_RPC.TXT"
width_px = 6000
height_px = 6000
sigma = {A0 = 5.0, B0 = 5.0}
""")

rng = np.random.default_rng(1)
xyz = np.column_stack([rng.uniform(-3000, 3000, (40, 2)), rng.uniform(-150, 150, 40)])
ground = Local(origin=(15.0, 48.0, 300.0)).geographic_from_block(xyz)
seen = {"1": made.project(ground) + [2.0, -0.5], "2": rpc.project(ground) + [3.0, -2.0]}
with open(folder / "images.csv", "w") as file:
    head = ["image", "camera", "file", "X", "Y", "Z", "omega_deg", "phi_deg", "kappa_deg"]
    rows = [[image, camera, *[""] * 7] for image, camera in (("1", "radar"), ("2", "optical"))]
    csv.writer(file).writerows([head, *rows])
with open(folder / "observations.csv", "w") as file:
    rows = [
        [image, k, *(xy + rng.normal(0, 0.3, 2)).tolist(), 0.3, 0.3]
        for image, all_xy in seen.items()
        for k, xy in enumerate(all_xy)
    ]
    csv.writer(file).writerows([["image", "point", "x_px", "y_px", "sx_px", "sy_px"], *rows])
with open(folder / "points.csv", "w") as file:
    rows = [[k, "control", *(xyz[k] + rng.normal(0, 0.3, 3)).tolist(), 0.3, 0.3, 0.3] for k in range(4)]
    csv.writer(file).writerows([["point", "role", "X", "Y", "Z", "sX", "sY", "sZ"], *rows])
# %%
from raybundle.results.folder import read_result

radar = read_result("result").result["cameras"]["radar"]
assert abs(radar["dr"]["value"] - 2.0 * made.pixel_m) < 4 * radar["dr"]["std"]
