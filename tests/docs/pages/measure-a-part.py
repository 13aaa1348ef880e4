# %% The figures above are held by this:
import csv
import json
from pathlib import Path

import numpy as np


def table(path):
    with Path(path).open() as file:
        return {row.get("point", row.get("from", "") + "-" + row.get("to", "")): row for row in csv.DictReader(file)}


nominal, lengths = table("before/nominal.csv"), table("before/lengths.csv")
assert [n for n, row in nominal.items() if row["verdict"] == "beyond"] == ["12"]
assert abs(float(nominal["12"]["length_mm"]) - 0.40) < 0.012
assert sum(row["significant"] == "yes" for row in nominal.values()) in {24, 25, 26}
errors = [float(row["error_mm"]) for row in lengths.values()]
assert max(map(abs, errors)) < 0.010
sigma = np.array([[float(row[f"s{a}_mm"]) for a in "XYZ"] for row in table("before/coordinate_list.csv").values()])
assert 0.0045 < np.sqrt(np.mean(sigma**2)) < 0.0065
assert 0.015 < sigma.max() < 0.03
load = table("load/points.csv")
moved = {n: float(row["length_mm"]) for n, row in load.items() if row["moved"]}
assert sorted(moved) == ["15", "9"]
assert abs(float(load["9"]["dZ_mm"]) + 0.42) < 0.015
assert abs(float(load["15"]["dX_mm"]) - 0.35) < 0.015
assert Path("load/report.pdf").is_file()
warnings = json.loads(Path("after/result.json").read_text())["warnings"]
assert not [w for w in warnings if w["severity"] != "note"]
assert abs(moved["9"] - 0.42) < 0.015
assert abs(moved["15"] - 0.35) < 0.015
assert 0.02 < np.median([float(row["detectable_mm"]) for row in load.values()]) < 0.04
