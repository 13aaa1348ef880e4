"""How long a large block takes to open in the studio, from the command to the list of images in the page.

    python benchmarks/studio_opening.py [POINTS] [STATIONS ALONG A SIDE] [RAYS]

By default 484 images of a flight, 200 000 object points, about 1.5 million image observations.  The server is the
command `raybundle studio`, the page stands in Chromium, which is there already.  The first opening reads files from the
disk, the others from memory; the median is told, and the largest memory of the server.  Figures go to standard output
and to benchmarks/results/studio_opening.json.  Needs playwright and a Chromium (RAYBUNDLE_CHROMIUM names one).
"""

from __future__ import annotations

import argparse
import json
import os
import re
import signal
import subprocess
import sys
import tempfile
import time
from pathlib import Path

import numpy as np

ROOT = Path(__file__).resolve().parents[1]
sys.path.insert(0, str(ROOT))
from benchmarks.run import machine  # noqa: E402
from benchmarks.runs import peak_mb  # noqa: E402
from benchmarks.studio_space import block_of  # noqa: E402
from tests.studio.browser import ARGUMENTS, chromium  # noqa: E402

OPENINGS = 5
CLOSE = 20.5
"""Distance of stations: more than seven photographs show a point."""


def opened(folder: Path, browser) -> dict:
    """One opening: the server begun, the page shown, the server ended."""
    began = time.perf_counter()
    command = [sys.executable, "-m", "raybundle", "studio", str(folder), "--no-browser"]
    server = subprocess.Popen(command, stdout=subprocess.PIPE, text=True)
    address = re.search(r"http://\S+", server.stdout.readline())[0]
    listening = time.perf_counter() - began
    page = browser.new_page()
    page.goto(address)
    page.locator("#image-list [role=option]").first.wait_for(timeout=120_000)
    shown = time.perf_counter() - began
    page.close()
    peak = peak_mb(server.pid) * 1024 / 1e6
    server.send_signal(signal.SIGINT)
    server.wait()
    return {"listening_s": round(listening, 2), "shown_s": round(shown, 2), "peak_gb": round(peak, 2)}


def main() -> None:
    """Figures of one block."""
    from playwright.sync_api import sync_playwright

    import raybundle as rb

    parser = argparse.ArgumentParser()
    parser.add_argument("points", type=int, nargs="?", default=200_000)
    parser.add_argument("stations", type=int, nargs="?", default=22)
    parser.add_argument("rays", type=int, nargs="?", default=12)
    asked = parser.parse_args()
    with tempfile.TemporaryDirectory() as folder:
        block = block_of(asked.points, asked.stations, asked.rays, CLOSE)
        rb.write_block(block, Path(folder) / "flight")
        with sync_playwright() as play:
            browser = play.chromium.launch(executable_path=chromium(), args=list(ARGUMENTS))
            found = [opened(Path(folder) / "flight", browser) for _ in range(OPENINGS)]
            browser.close()
    told = {
        "machine": machine(), "load": round(os.getloadavg()[0], 1), "images": len(block.images),
        "points": len(block.points), "image_observations": len(block.observations), "openings": found,
        **{f"median_{name}": float(np.median([f[name] for f in found])) for name in found[0]},
    }  # fmt: skip
    print(json.dumps(told, indent=1))
    (ROOT / "benchmarks" / "results" / "studio_opening.json").write_text(json.dumps(told, indent=1) + "\n")


if __name__ == "__main__":
    main()
