# %% A wall of named points
from dataclasses import replace

import numpy as np

import raybundle as rb
from raybundle.planning.synthetic_networks import TargetField, field_scene
from raybundle.planning.simulate import Survey, simulate

survey = Survey(image_sigma_px=0.3, orientation="exact", points="exact")
flat = simulate(field_scene(TargetField(stations=6, depth=0.0)), survey).observed
stand = rb.SimilarityTransform(
    scale=1.0, rotation=np.array([[1.0, 0, 0], [0, 0, -1], [0, 1, 0]]), translation=np.zeros(3)
)
wall = rb.transform_block(flat, stand, observed="stay")
names = tuple(f"Z{k}" for k in range(len(wall.points)))
known = np.arange(len(names)) < 12
points = replace(
    wall.points,
    ids=names,
    role=np.where(known, rb.Role.CONTROL, rb.Role.TIE).astype(np.int32),
    sigma=np.where(known[:, None], 1e-3, np.nan) * np.ones((len(names), 3)),
)
rb.write_result(rb.adjust(replace(wall, points=points)), "wall-result", report="none")
