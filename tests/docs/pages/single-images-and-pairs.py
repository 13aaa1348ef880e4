# %% Points of a camera with strong distortion; every eighth is a check point
import csv

from raybundle.planning.synthetic_networks import SinglePhoto, single_scene

photo = simulate(single_scene(SinglePhoto(points=100)), Survey(control=80, image_sigma_px=0.3, interior="exact"))
o, p = photo.observed.observations, photo.truth.points
with open("points.csv", "w", newline="") as file:
    rows = csv.writer(file)
    rows.writerow(["point", "X", "Y", "Z", "x_px", "y_px", "role"])
    for k, (point, xy) in enumerate(zip(o.point, o.xy_px)):
        rows.writerow([p.ids[point], *p.xyz[point], *xy, "check" if k % 8 == 0 else "control"])
