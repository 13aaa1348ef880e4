# %% A simulated field of targets, with nominal coordinates in millimetres and a certificate of lengths.
from itertools import combinations
from pathlib import Path

import numpy as np

import raybundle as rb
from raybundle.planning.synthetic_networks import TargetField, field_scene
from raybundle.planning.simulate import Survey, simulate

done = simulate(field_scene(TargetField()), Survey(seed=5, image_sigma_px=0.1))
rb.write_block(done.observed, "field")
truth = dict(zip(done.truth.points.ids, done.truth.points.xyz, strict=True))
rows = [f"{name},{1000 * x},{1000 * y},{1000 * z},0.5" for name, (x, y, z) in truth.items()]
Path("cad.csv").write_text("\n".join(["point,X,Y,Z,tolerance", *rows]))
pairs = combinations(["2", "7", "11", "19", "23"], 2)
rows = [f"{a},{b},{1000 * np.linalg.norm(truth[a] - truth[b])}" for a, b in pairs]
Path("certificate.csv").write_text("\n".join(["from,to,length", *rows]))
bar = float(np.linalg.norm(truth["1"] - truth["20"]))
rb.measure("field", "part", scale_bar=[("1", "20", bar, 1e-5)])

# %%
wrong = float(np.linalg.norm(truth["3"] - truth["15"])) + 0.005
done = rb.measure("field", "two-bars", scale_bar=[("1", "20", bar, 1e-5), ("3", "15", wrong, 1e-5)], report=False)
(found,) = [n for n in done.adjustment.notices if n.code == "bars_contradict"]
assert found.severity == "fault"
assert "3 - 15" in found.text
