# %% Two images of hills, from ahead and from behind, 1 m on the ground; the RPC is wrong by some pixels, ERR_BIAS 10 m. One control point, eight check points.
from dataclasses import replace
from pathlib import Path

import cv2
import numpy as np
from PIL import Image

from raybundle.io.scenes.rpc_text import write_rpc_text
from raybundle.numerics.places import Local
from raybundle.scenes.rpc_fit import fit_rpc
from raybundle.scenes.simulate import OrbitPlan, orbit_scene

place = (15.0, 48.0, 300.0)
frame = Local(origin=place)
scenes = {n: orbit_scene(OrbitPlan(target=place, pitch_deg=p)) for n, p in (("ahead", 2.6), ("behind", -2.8))}
rpcs = {n: replace(fit_rpc(s.localise, (4000, 4000), (0.0, 600.0)).rpc, err_bias_m=10.0) for n, s in scenes.items()}
rng = np.random.default_rng(1)


def noise(size):  # smooth, 900 x 900 m, a value a metre
    small = np.float32(rng.normal(size=(900 // size, 900 // size)))
    return cv2.resize(small, (900, 900), interpolation=cv2.INTER_CUBIC)


height, grey = 20 * noise(225), noise(50) + noise(20) + noise(10) + noise(5)


def at(layer, x, y):
    return cv2.remap(layer, np.float32(x + 450), np.float32(y + 450), cv2.INTER_CUBIC, borderMode=cv2.BORDER_REFLECT)


def picture(rpc, size=500):
    y, x = np.mgrid[0:size, 0:size] + 0.5
    pixels = np.column_stack([x.ravel(), y.ravel()])
    low, high = (frame.block_from_geographic(rpc.localise(pixels, h)).T.reshape(3, size, size) for h in (250.0, 350.0))
    t = 0.5
    for _ in range(8):  # where the ray meets the hills
        X, Y, _ = low + t * (high - low)
        t = (at(height, X, Y) - low[2]) / (high[2] - low[2])
    return np.uint16(np.clip(500 + 120 * at(grey, X, Y) + rng.normal(0, 3, (size, size)), 1, 2047))


Path("scenes").mkdir()
wrong = {"ahead": np.array([6.0, -3.0]), "behind": np.array([-4.0, 5.0])}
cut = {name: rpc.shifted(np.array([-1750.0, -1750.0])) for name, rpc in rpcs.items()}  # 500 px in the middle
for name, rpc in cut.items():
    Image.fromarray(picture(rpc)).save(f"scenes/{name}.tif")
    write_rpc_text(rpc.shifted(-wrong[name]), Path(f"scenes/{name}_RPC.TXT"))

x, y = rng.uniform(-150, 150, (2, 9))
points = np.column_stack([x, y, at(height, x[None], y[None])[0]])
with open("gcp.csv", "w") as file:
    file.write("point,X,Y,Z,sX,sY,sZ,role\n")
    for k, (lon, lat, h) in enumerate(frame.geographic_from_block(points)):
        file.write(f"{k},{lon:.9f},{lat:.9f},{h:.3f},0.2,0.2,0.3,{'control' if k == 0 else 'check'}\n")
with open("gcp-measurements.csv", "w") as file:
    file.write("image,point,x_px,y_px\n")
    for name, rpc in cut.items():
        for k, (px, py) in enumerate(rpc.project(frame.geographic_from_block(points)) + rng.normal(0, 0.3, (9, 2))):
            file.write(f"{name}.tif,{k},{px:.2f},{py:.2f}\n")

# %%
import json

cameras = json.loads(Path("pair-project/result/result.json").read_text())["cameras"]
for name, parameters in cameras.items():
    print(name, {s: f"{p['value']:.2f} +- {p['std']:.2f} px" for s, p in parameters.items()})
assert abs(cameras["ahead.tif"]["A0"]["value"] - 6.0) < 4 * cameras["ahead.tif"]["A0"]["std"]

import raybundle as rb

again = rb.orient("scenes", "pair-project", control="gcp.csv", mark_sigma=0.3, report=False)
print({s.name: s.from_cache for s in again.stages})
assert all(s.from_cache for s in again.stages if s.name in {"features", "matching", "start", "precision"})

# %% The same scenes at full size:
Path("pair").mkdir()
for name, rpc in rpcs.items():
    write_rpc_text(rpc, Path(f"pair/{name}_RPC.TXT"))

# %%
from raybundle.numerics.geodesy import LocalPlace

rng = np.random.default_rng(1)
xyz = np.column_stack([rng.uniform(-1500, 1500, (40, 2)), rng.uniform(-120, 120, 40)])
ground = LocalPlace(origin=place).geographic_from_local(xyz)
with open("pair/images.csv", "w") as file:
    file.write("image,camera,file,X,Y,Z,omega_deg,phi_deg,kappa_deg\n")
    file.writelines(f"{name},{name},,,,,,,\n" for name in scenes)
with open("pair/points.csv", "w") as file:
    file.write("point,role,X,Y,Z,sX,sY,sZ\n")
    for k in range(11):
        x, y, z = xyz[k]
        file.write(f"{k},control,{x},{y},{z},0.2,0.2,0.3\n" if k == 0 else f"{k},check,{x},{y},{z},0.2,0.2,0.3\n")
with open("pair/observations.csv", "w") as file:
    file.write("image,point,x_px,y_px,sx_px,sy_px\n")
    for name, shift in (("ahead", [6.0, -3.0]), ("behind", [-4.0, 5.0])):  # what the vendor's attitude is wrong by
        for k, (x, y) in enumerate(rpcs[name].project(ground) + shift + rng.normal(0, 0.3, (40, 2))):
            file.write(f"{name},{k},{x:.3f},{y:.3f},0.3,0.3\n")

# %%
from raybundle.results.folder import read_result

result = read_result("pair-result")
print({name: {s: round(p["value"], 1) for s, p in ps.items()} for name, ps in result.result["cameras"].items()})
assert abs(result.result["cameras"]["ahead"]["A0"]["value"] - 6.0) < 1.5
check = {s: result.block.points.xyz for s in "XYZ"}
assert len(check["X"]) == 40
