# %% The figures above are held by this:
import csv
import json
from pathlib import Path

import numpy as np

result = json.loads(Path("pit-project/result/result.json").read_text())
assert 0.020 < result["asprs"]["rmse_h"] < 0.026
assert 0.024 < result["asprs"]["rmse_v"] < 0.032
assert 0.036 < result["flight"]["gsd_m"] < 0.039
assert not [w for w in result["warnings"] if w.get("severity") == "fault"]
assert not [w for w in result["warnings"] if w["code"] == "coordinate_system"]
with Path("pit-project/result/check.csv").open() as file:
    rows = list(csv.DictReader(file))
rms = [1000 * np.sqrt(np.mean([float(r[f"d{a}"]) ** 2 for r in rows])) for a in "XYZ"]
assert np.allclose(rms, [14, 12, 24], atol=2.5), rms
with Path("pit-project/result/map.csv").open() as file:
    rows = [r for r in csv.DictReader(file) if r["kind"] == "tie" and r["sX"]]
rms = [1000 * np.sqrt(np.mean([float(r[f"s{a}"]) ** 2 for r in rows])) for a in "XYZ"]
assert np.allclose(rms, [9, 10, 30], rtol=0.15), rms
