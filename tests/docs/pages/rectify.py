# %% A photograph of a plane wall, six points marked to 0.3 px
from pathlib import Path

import numpy as np
from PIL import Image

H = np.array([[310.0, 22.0, 150.0], [-14.0, -290.0, 520.0], [0.02, 0.05, 1.0]])  # wall [m] to photograph [px]
wall = np.array([[0, 0], [1.2, 0], [1.2, 1.1], [0, 1.1], [0.6, 0.5], [0.3, 0.8]])
seen = np.c_[wall, np.ones(6)] @ H.T
marks = seen[:, :2] / seen[:, 2:] + np.random.default_rng(1).normal(0, 0.3, (6, 2))
Image.fromarray(np.random.default_rng(2).integers(0, 255, (600, 800, 3), dtype=np.uint8)).save("wall.png")
Path("points.csv").write_text("point,X,Y,Z\n" + "".join(f"{k},{x},{y},\n" for k, (x, y) in enumerate(wall)))
Path("points-measurements.csv").write_text(
    "image,point,x_px,y_px\n" + "".join(f"wall.png,{k},{x},{y}\n" for k, (x, y) in enumerate(marks))
)
