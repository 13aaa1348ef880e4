# %% A film that shrank by 350 ppm in x and grew by 120 ppm in y, in a scan rotated by 1.7 degrees
from pathlib import Path

import numpy as np

names = [f"F{k + 1}" for k in range(8)]
marks = 106.0 * np.array([[-1, 0], [1, 0], [0, 1], [0, -1], [-1, -1], [1, 1], [-1, 1], [1, -1]])
points = np.array([[50.0, 20.0], [-90.0, 101.0]])
t = np.radians(1.7)
rng = np.random.default_rng(1)


def scan(xy):
    film = xy * [1 - 350e-6, 1 + 120e-6]
    return film @ [[np.cos(t), np.sin(t)], [-np.sin(t), np.cos(t)]] / 0.0125 * [1, -1] + [9500, 9300]


def table(path, header, names, xy):
    rows = [f"{n},{x:.5f},{y:.5f}" for n, (x, y) in zip(names, xy)]
    Path(path).write_text("\n".join([header, *rows]) + "\n")


table("certificate.csv", "mark,x_mm,y_mm", names, marks)
measured = scan(marks) + rng.normal(0, 0.15, (8, 2))
table("marks.csv", "image,mark,x_px,y_px", [f"17_0412.tif,{n}" for n in names], measured)
table("points.csv", "image,point,x_px,y_px", ["17_0412.tif,1", "17_0412.tif,2"], scan(points))
# %%
import csv

row = next(csv.DictReader(Path("film/film.csv").open()))
print("shrinkage", row["shrinkage_x_ppm"], "+-", row["sshrinkage_x_ppm"], "ppm")
assert abs(float(row["shrinkage_x_ppm"]) - 350) < 4 * float(row["sshrinkage_x_ppm"])
assert abs(float(row["shrinkage_y_ppm"]) + 120) < 4 * float(row["sshrinkage_y_ppm"])
