# %% Two strips of an aerial scanner; the clock of the INS is 12 ms late, its axes are rotated by some 0.2 degrees against the lens.
from dataclasses import replace
from pathlib import Path

import numpy as np

from raybundle.io.scenes import read_scene
from raybundle.io.digits import EVERY
from raybundle.io.tables import write_table
from raybundle.numerics.attitude import opk_from_rotation, rotation_from_rpy
from raybundle.numerics.geodesy import LocalPlace
from raybundle.numerics.rotation import rotation_from_vector

place, late, boresight = LocalPlace(origin=(15.0, 48.0, 300.0)), 0.012, np.array([0.004, -0.003, 0.002])
rng = np.random.default_rng(1)
folder = Path("strips")
folder.mkdir()


def fly(name, heading_deg, clock, turn):
    t, h = np.arange(-1.0, 11.0, 0.01), np.radians(heading_deg)
    along, across = 60 * (t - 5) + 4 * np.sin(0.9 * t), -200 * np.sin(h) ** 2 + 3 * np.sin(0.6 * t)
    xyz = np.stack(
        [along * np.sin(h) + across * np.cos(h), along * np.cos(h) - across * np.sin(h), 1200 + np.cos(t)], axis=1
    )
    wave = np.radians(0.8) * np.stack([np.sin(1.1 * t), np.sin(0.8 * t), np.sin(0.5 * t)], axis=1)
    angles = opk_from_rotation(rotation_from_vector(-turn) @ rotation_from_rpy(wave + [0, 0, h]))
    names = ("time_s", "longitude_deg", "latitude_deg", "height_m", "omega_deg", "phi_deg", "kappa_deg")
    rows = np.column_stack([t + clock, place.geographic_from_local(xyz), np.degrees(angles)])
    columns = dict(zip(names, rows.T))
    columns |= {n: np.full(len(t), 0.05) for n in ("sX", "sY", "sZ")}
    columns |= {n: np.full(len(t), 0.003) for n in ("somega_deg", "sphi_deg", "skappa_deg")}
    write_table(folder / f"{name}.csv", columns, EVERY)
    (folder / f"{name}.toml").write_text(f"""
scanner = "an aerial line scanner"
width_px = 8000
height_px = 5000

[lens]
c_mm = 62.7
pixel_mm = 0.0065
x0_mm = 0.0
y0_mm = 0.0                      # place of the line; > 0 looks ahead

[lines]
first_s = 0.001                  # middle of the first line
interval_s = 0.002

[trajectory]
file = "{name}.csv"
lever_arm_m = [0.0, 0.0, 0.0]    # from the projection centre to the point of the positions: right, forward, up
boresight_deg = [0.0, 0.0, 0.0]
""")
    return read_scene(folder / f"{name}.toml").rigorous


true = {n: fly(n, h, 0.0, np.zeros(3)) for n, h in (("east", 80.0), ("west", 260.0))}
for n, h in (("east", 80.0), ("west", 260.0)):
    fly(n, h, late, boresight)

# %%
head = """
[frame]
kind = "local"
origin = [15.0, 48.0, 300.0]
"""
for name in true:
    head += f"""
[cameras.{name}]
model = "linescan"
scene = "{name}.toml"
height_m = 300.0
position_fixes = 3                      # drift of GNSS within the strip
attitude_degree = 0                     # rx0, ry0, rz0: the misalignment of the INS
attitude_fixes = 5                      # drift of the INS
time_offset = true                      # dt
"""
(folder / "block.toml").write_text(head)
xyz = np.column_stack([rng.uniform(-250, 250, (60, 2)), rng.uniform(-30, 30, 60)])
ground = place.geographic_from_local(xyz)
with open(folder / "images.csv", "w") as file:
    file.write("image,camera,file,X,Y,Z,omega_deg,phi_deg,kappa_deg\n")
    file.writelines(f"{name},{name},,,,,,,\n" for name in true)
with open(folder / "points.csv", "w") as file:
    file.write("point,role,X,Y,Z,sX,sY,sZ\n")
    for k in range(16):
        x, y, z = xyz[k]
        file.write(f"{k},{'control' if k < 6 else 'check'},{x},{y},{z},0.02,0.02,0.03\n")
with open(folder / "observations.csv", "w") as file:
    file.write("image,point,x_px,y_px,sx_px,sy_px\n")
    for name, scene in true.items():
        for k, (x, y) in enumerate(scene.project(ground) + rng.normal(0, 0.3, (60, 2))):
            file.write(f"{name},{k},{x:.3f},{y:.3f},0.3,0.3\n")

# %%
from raybundle.results.folder import read_result

for name, found in read_result("strips-result").result["cameras"].items():
    print(name, {s: (round(found[s]["value"], 5), round(found[s]["std"], 5)) for s in ("rx0", "ry0", "rz0", "dt")})
    for symbol, value in zip(("rx0", "ry0", "rz0", "dt"), (*boresight, late)):
        assert abs(found[symbol]["value"] - value) < 4 * found[symbol]["std"]

# %%
head = head[: head.index("[cameras.")]
y0 = {"forward": 12.0, "nadir": 0.0, "backward": -12.0}
for name in true:
    head += f"""[trajectories.{name}]
position_fixes = 3
attitude_degree = -1
attitude_fixes = 5

"""
for line in y0:
    head += f"""[mounts.{line}]
estimate = ["bx", "by", "bz", "bt"]

"""
rows, images = [], []
for name, scene in true.items():
    for line, place_mm in y0.items():
        own = f"{name}_{line}"
        text = (folder / f"{name}.toml").read_text().replace("y0_mm = 0.0 ", f"y0_mm = {place_mm} ")
        (folder / f"{own}.toml").write_text(text)
        head += f"""[cameras.{own}]
model = "linescan"
scene = "{own}.toml"
height_m = 300.0
trajectory = "{name}"
mount = "{line}"

"""
        images.append(f"{own},{own},,,,,,,")
        look = scene.detector_look - [[0.0, place_mm / 62.7]]
        seen = replace(scene, detector_look=look)
        for k, (x, y) in enumerate(seen.project(ground) + rng.normal(0, 0.3, (60, 2))):
            if 0 < y < 5000:
                rows.append(f"{own},{k},{x:.3f},{y:.3f},0.3,0.3")
three = Path("three-lines")
three.mkdir()
for file in folder.iterdir():
    if file.suffix in (".toml", ".csv"):
        (three / file.name).write_text(file.read_text())
(three / "block.toml").write_text(head)
(three / "images.csv").write_text("image,camera,file,X,Y,Z,omega_deg,phi_deg,kappa_deg\n" + "\n".join(images) + "\n")
(three / "observations.csv").write_text("image,point,x_px,y_px,sx_px,sy_px\n" + "\n".join(rows) + "\n")

# %%
found = read_result("three-lines-result").result["cameras"]
for line in y0:
    for symbol, value in zip(("bx", "by", "bz", "bt"), (*boresight, late)):
        assert abs(found[line][symbol]["value"] - value) < 4 * found[line][symbol]["std"], (line, symbol)
