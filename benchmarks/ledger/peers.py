"""Which peers are here: versions, or the reason why one is not; kept in benchmarks/results/ledger_peers.json."""

from __future__ import annotations

import json
import os
import subprocess
import sys
from pathlib import Path

from . import RESULTS

FILE = RESULTS.with_name("ledger_peers.json")
CALLS = {
    "OpenCV": "`cv2.calibrateCameraExtended`: standard deviations of the interior orientation",
    "pycolmap": "`pycolmap.estimate_ba_covariance`: stations, interior orientation, points with all else held",
    "calibsense": "`calibsense.instrument`: covariance of the interior orientation",
    "mrcal": "`mrcal.projection_uncertainty`",
}
"""Peer -> the call whose standard deviations are judged"""
MODULES = {"OpenCV": "cv2", "pycolmap": "pycolmap", "calibsense": "calibsense", "mrcal": "mrcal"}
PYTHONS = {"calibsense": "RAYBUNDLE_CALIBSENSE_PYTHON", "mrcal": "RAYBUNDLE_MRCAL_PYTHON"}
"""Peers that have a Python of their own -> the variable that names it"""

NOTES = {"mrcal": "its dependency pyfltk has no wheel and builds with FLTK 1.4 only"}
"""Why an installation by pip ended without the peer, as tried in November 2026"""


def found() -> dict[str, str]:
    """Version of each peer, or the reason of its absence."""
    return {name: _version(name) for name in CALLS}


def _version(name: str) -> str:
    python = os.environ.get(PYTHONS[name], "") if name in PYTHONS else sys.executable
    if not python:
        return f"not installed: {NOTES.get(name, f'{PYTHONS[name]} names no Python')}"
    code = f"import {MODULES[name]} as m; print(m.__version__)"
    done = subprocess.run([python, "-c", code], capture_output=True, text=True, check=False)
    lines = done.stderr.strip().splitlines()
    return (
        done.stdout.strip() if not done.returncode else f"not installed: {NOTES.get(name, lines[-1] if lines else '')}"
    )


def keep() -> None:
    """Write what is here; what another machine had is replaced."""
    FILE.write_text(json.dumps(found(), indent=1) + "\n", encoding="utf-8")


def table(path: Path = FILE) -> str:
    """The peers in Markdown."""
    there = json.loads(path.read_text(encoding="utf-8")) if path.exists() else {}
    lines = ["| peer | call | version |", "|---|---|---|"]
    lines += [f"| {name} | {call} | {there.get(name, 'not looked for')} |" for name, call in CALLS.items()]
    return "\n".join(lines) + "\n"
