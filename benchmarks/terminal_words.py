"""What commands print when all is well: lines and words of the terminal, command by command.

    python benchmarks/terminal_words.py DATA [--work FOLDER] [--only NAME ...] [--out FILE.json]

DATA holds photos/ (sceaux-castle, castle-p19, copr-uav, cern-targets) and calibration/camcal-photos.  Projects stay in
--work, so that a second run prints the same within seconds.  Output to a file is what a terminal shows without the
progress bar.
"""

from __future__ import annotations

import argparse
import json
import subprocess
import sys
from pathlib import Path

RAYBUNDLE = [sys.executable, "-m", "raybundle"]


def commands(data: Path, work: Path) -> dict[str, list[list[str]]]:
    """Commands by name; of several the last one counts, those before make what it reads."""
    photos = data / "photos"

    def orient(name: str, *more: str) -> list[str]:
        return ["orient", str(photos / name / "images"), "--out", str(work / name), "--no-library", *more]

    demo = [["demo", "--seed", str(seed), "--out", str(work / f"demo-{seed}")] for seed in (1, 2)]
    blocks = [["adjust", str(work / f"demo-{seed}/block"), "--out", str(work / f"epoch-{seed}")] for seed in (1, 2)]
    scene = work / "scene"
    corrected = ["--image-sigma", "0.4", "--out", str(scene / "corrected.tif"), "--overwrite"]
    return {
        "demo": demo[:1],
        "adjust": [*demo[:1], *blocks[:1]],
        "orient sceaux-castle": [orient("sceaux-castle")],
        "orient castle-p19": [orient("castle-p19")],
        "orient copr-uav": [orient("copr-uav")],
        "surface sceaux-castle": [
            orient("sceaux-castle"), ["surface", str(work / "sceaux-castle"), "--free-scale", "--density", "4"]
        ],
        "calibrate": [
            ["calibrate", str(data / "calibration/camcal-photos/images"), "--out",
             str(work / "calibrate")],
        ],
        "measure": [
            ["measure", str(photos / "cern-targets/images"), "--target", "aicon14", "--scale-bar", "2", "74", "0.9512",
             "0.00001", "--out", str(work / "measure")],
        ],
        "moved": [
            *demo, *blocks, ["moved", str(work / "epoch-1"), str(work / "epoch-2"), "--out", str(work / "moved")]
        ],
        "rpc correct": [
            ["demo", "--set", "scene", "--out", str(scene)],
            ["rpc", "correct", str(scene / "scene.tif"), str(scene / "control.gpkg"), *corrected],
        ],
    }  # fmt: skip


def main() -> None:
    """Run them and print the figures."""
    parser = argparse.ArgumentParser(description=__doc__.partition("\n")[0])
    parser.add_argument("data", type=Path)
    parser.add_argument("--work", type=Path, default=Path("terminal-words"))
    parser.add_argument("--only", nargs="*", default=[])
    parser.add_argument("--out", type=Path)
    given = parser.parse_args()
    found: dict[str, dict[str, object]] = {}
    for name, several in commands(given.data, given.work).items():
        if given.only and name not in given.only:
            continue
        for words in several:
            done = subprocess.run([*RAYBUNDLE, *words], capture_output=True, text=True, check=False)
            if done.returncode not in {0, 4}:
                print(f"{name}: {' '.join(words[:2])} ended with {done.returncode}: {done.stderr.strip()[-400:]}")
                break
        else:
            lines = [line for line in done.stdout.splitlines() if line.strip()]
            found[name] = {"lines": len(lines), "words": sum(len(line.split()) for line in lines), "text": lines}
            print(f"{name:24}{len(lines):6} lines{found[name]['words']:6} words", flush=True)
    if given.out is not None:
        given.out.write_text(json.dumps(found, indent=1, ensure_ascii=False) + "\n")


if __name__ == "__main__":
    main()
