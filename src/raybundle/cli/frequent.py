"""Commands and options that `--help` shows: those of which the tutorials and how-tos make most use."""

from __future__ import annotations

COMMANDS = (
    "plan", "targets", "calibrate", "orient", "adjust", "mark", "measure", "surface", "heights", "convert",
)  # fmt: skip
OPTIONS: dict[str, tuple[str, ...]] = {
    "orient": (
        "--out", "--control", "--check", "--scale-bar", "--positions", "--crs", "--calibration", "--feature-count",
        "--quick", "--accuracy-class",
    ),
    "epochs": (
        "--add", "--date", "--group", "--datum-points", "--limit", "--confidence", "--animation", "--control", "--crs",
        "--pdf",
    ),
    "adjust": (
        "--out", "--datum", "--estimate", "--variance-groups", "--reject", "--noise", "--accuracy-class", "--no-report",
        "--tables", "--verbose",
    ),
    "surface": (
        "--out", "--density", "--dsm", "--ortho", "--mesh", "--las", "--extent", "--vertical", "--photos", "--verbose",
    ),
    "calibrate": (
        "--out", "--target", "--sheet", "--spacing", "--table", "--model", "--parameters", "--keep", "--no-report",
        "--pdf",
    ),
    "plan network": (
        "--out", "--photographs", "--sigma", "--c", "--pixel-mm", "--heights", "--rays", "--stations", "--scale-bars",
        "--effort",
    ),
    "plan flight": (
        "--area", "--gsd", "--lines", "--photographs-per-line", "--height", "--overlap", "--alternate", "--cross",
        "--rtk", "--out",
    ),
    "plan mission": (
        "--vehicle", "--camera", "--gsd", "--overlap", "--pattern", "--heights", "--dem", "--to", "--predict", "--out",
    ),
    "plan list": (
        "--c", "--pixel-mm", "--around", "--clearance", "--stations", "--count", "--elevations", "--steps",
        "--f-number", "--out",
    ),
}  # fmt: skip
"""Of commands with many options, by the words of the command"""
