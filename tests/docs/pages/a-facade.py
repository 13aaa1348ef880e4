# %% The figures above are held by this:
import csv
import json
import tomllib
from pathlib import Path

import numpy as np

with Path("portal/result/distances.csv").open() as file:
    rows = {row["from"]: row for row in csv.DictReader(file)}
assert abs(float(rows["T3"]["adjusted"]) - 3.7801) < 0.0004
with Path("portal/result/points.csv").open() as file:
    table = list(csv.DictReader(file))
sigma = np.nanmedian([[float(row[f"s{a}"] or "nan") for a in "XYZ"] for row in table], axis=0)
assert np.allclose(1000 * sigma, [0.19, 0.41, 0.18], atol=0.05), sigma
plane = tomllib.loads(Path("portal/facade/facade.toml").read_text())
assert 0.0025 < plane["points_rms"] < 0.0055
assert abs(plane["lean_deg"]) < 2 * plane["lean_sigma_deg"]
assert 0.0001 < plane["place_sigma"] < 0.0006
assert plane["measured"] > 0.8
assert 0.3 < plane["lean_sigma_deg"] < 0.6
assert "Portal of the town hall" in Path("portal/result/report.html").read_text()
result = json.loads(Path("portal/result/result.json").read_text())
assert 0.3 < result["image_sigma_px"] < 0.4
assert not [w for w in result["warnings"] if w.get("severity") == "fault"]
