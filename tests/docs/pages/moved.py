# %% Two epochs of a field of targets with a scale bar; points 5 and 17 move by 4 mm.
from dataclasses import replace
from pathlib import Path

import raybundle as rb
from raybundle.planning.synthetic_networks import TargetField, field_scene
from raybundle.planning.simulate import Survey, simulate

scene = field_scene(TargetField())
for seed, name, by in ((3, "spring", 0.0), (4, "autumn", 0.004)):
    xyz = scene.xyz.copy()
    xyz[4, 1] += by  # point 5
    xyz[16, 0] -= by  # point 17
    survey = Survey(seed=seed, image_sigma_px=0.3, scale_bars=1, scale_bar_sigma=1e-5)
    rb.write_block(simulate(replace(scene, xyz=xyz), survey).observed, name)

# %%
lines = [f"{k + 1},{1000 * y},{1000 * z},{1000 * x}" for k, (x, y, z) in enumerate(scene.xyz)]  # Y, Z, X of the field
Path("drawing.csv").write_text("\n".join(["point,X,Y,Z", *lines]))
