"""Time, memory and pages of a report as PDF with every point in it, beside its page; long tables in stacks or in cells.

Run: python benchmarks/report_pdf.py > benchmarks/results/report_pdf.json          a process for each
"""

import json
import os
import platform
import subprocess
import sys
import tempfile
import time
from importlib import metadata
from io import BytesIO
from pathlib import Path

from pypdf import PdfReader
from runs import peak_mb

from raybundle import adjust
from raybundle.planning.simulate import Survey, simulate
from raybundle.planning.synthetic_networks import AerialStrips, aerial_scene
from raybundle.report.paper import copy
from raybundle.report.writing import write_report

DENSITIES = (355, 3550, 8900)
"""Points an image: about 2 000, 20 000 and 50 000 in the block."""


def one(density: int, how: str) -> dict:
    """A block of 18 images from the air, adjusted; what its reports take beyond that."""
    if how == "cells":
        copy.STACKED = 10**9
    survey = Survey(control=8, orientation="exact", points="exact", interior="exact")
    result = adjust(simulate(aerial_scene(AerialStrips(points_per_image=density)), survey).observed)
    before = peak_mb()
    seconds = {}
    with tempfile.TemporaryDirectory() as folder:
        for kind in ("html", "pdf"):
            began = time.perf_counter()
            write_report(result, Path(folder) / f"report.{kind}", appendix="all")
            seconds[kind] = round(time.perf_counter() - began, 2)
        peak = peak_mb()
        pdf = (Path(folder) / "report.pdf").read_bytes()
    pages = [page.extract_text() for page in PdfReader(BytesIO(pdf)).pages]
    return {
        "points": len(result.given.points), "long tables in": how, "page s": seconds["html"], "PDF s": seconds["pdf"],
        "MB more at the peak": round(peak - before), "PDF MB": round(len(pdf) / 1e6, 1), "pages": len(pages),
        "pages before the appendix": next(k for k, text in enumerate(pages) if "APPENDIX" in text),
    }  # fmt: skip


def main() -> None:
    """All of them, in processes of their own."""
    runs = [(density, "stacks") for density in DENSITIES] + [(DENSITIES[0], "cells")]
    found = [
        json.loads(subprocess.run([sys.executable, __file__, str(d), how], check=True, capture_output=True).stdout)
        for d, how in runs
    ]
    versions = {name: metadata.version(name) for name in ("raybundle", "typst", "numpy")}
    print(json.dumps({"machine": platform.machine(), "cpus": os.cpu_count(), **versions, "reports": found}, indent=1))


if __name__ == "__main__":
    if len(sys.argv) > 1:
        print(json.dumps(one(int(sys.argv[1]), sys.argv[2])))
    else:
        main()
