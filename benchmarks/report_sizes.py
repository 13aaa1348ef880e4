"""Size of report, network page and PDF of large flights, and what writing them takes.

Run: python benchmarks/report_sizes.py [STRIPS IMAGES POINTS ...]          images a strip, points an image; a process
for each; writes benchmarks/results/report_sizes.json
"""

import json
import platform
import subprocess
import sys
import tempfile
import time
from pathlib import Path

from runs import peak_mb

from raybundle import adjust
from raybundle.planning.simulate import Survey, simulate
from raybundle.planning.synthetic_networks import AerialStrips, aerial_scene
from raybundle.report.network.page import write_network_page
from raybundle.report.writing import write_report

RESULTS = Path(__file__).parent / "results/report_sizes.json"
FLIGHTS = ("6", "8", "60", "40", "50", "60", "100", "100", "25")


def one(strips, images, points):
    """A flight, adjusted; its pages."""
    survey = Survey(
        control=30, check=20, station_sigma=0.05, orientation="exact", points="exact", interior="exact"
    )  # fmt: skip
    scene = aerial_scene(AerialStrips(strips=strips, images_per_strip=images, points_per_image=points))
    result = adjust(simulate(scene, survey).observed)
    told = {"images": len(result.given.images), "points": len(result.given.points)}
    with tempfile.TemporaryDirectory() as folder:
        for name, write in (
            ("report.html", write_report),
            ("network.html", write_network_page),
            ("report.pdf", write_report),
        ):
            began = time.process_time()
            write(result, Path(folder) / name)
            told[f"{name}, MB"] = round((Path(folder) / name).stat().st_size / 1e6, 2)
            told[f"{name}, CPU s"] = round(time.process_time() - began, 1)
    print(json.dumps(told | {"peak MB": round(peak_mb())}))


def main():
    """All flights, in processes of their own."""
    given = sys.argv[1:] or FLIGHTS
    found = []
    for k in range(0, len(given), 3):
        done = subprocess.run(
            [sys.executable, __file__, "--", *given[k : k + 3]], check=True, capture_output=True, text=True
        )
        found.append(json.loads(done.stdout))
        print(found[-1], flush=True)
    RESULTS.write_text(json.dumps({"machine": platform.machine(), "flights": found}, indent=1) + "\n", encoding="utf-8")


if __name__ == "__main__":
    if sys.argv[1:2] == ["--"]:
        one(*map(int, sys.argv[2:]))
    else:
        main()
