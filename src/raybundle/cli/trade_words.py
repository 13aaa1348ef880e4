"""Words of the trade that are no commands, each with the command line that does what it names."""

from __future__ import annotations

import difflib
import re

TRADE_WORDS: dict[str, str] = {
    # orientation
    "resection": "orient PHOTOS --out PROJECT",
    "stitch": "orient PHOTOS --out PROJECT",
    "align": "orient PHOTOS --out PROJECT",
    "sfm": "orient PHOTOS --out PROJECT",
    "mapper": "orient PHOTOS --out PROJECT",
    "aerotriangulation": "orient PHOTOS --control CONTROL.csv --out PROJECT",
    "georeference": "orient PHOTOS --control CONTROL.csv --out PROJECT",
    "gcp": "orient PHOTOS --control CONTROL.csv --out PROJECT",
    "gnss": "orient PHOTOS --positions POSITIONS.txt --out PROJECT",
    "rtk": "orient PHOTOS --positions POSITIONS.txt --out PROJECT",
    "bundle": "adjust BLOCK --out RESULT",
    "optimize": "adjust BLOCK --out RESULT",
    "bundle-adjustment": "adjust BLOCK --out RESULT",
    "triangulate": "adjust BLOCK --out RESULT",
    # calibration
    "chessboard": "calibrate PHOTOS --target chessboard-10x7 --out CALIBRATION",
    "checkerboard": "calibrate PHOTOS --target chessboard-10x7 --out CALIBRATION",
    "charuco": "calibrate PHOTOS --target BOARD --out CALIBRATION",
    "intrinsics": "calibrate PHOTOS --out CALIBRATION",
    "undistort": "convert RESULT --to colmap --out dense/sparse --photos PHOTOS --undistort inside",
    # surfaces and maps
    "pointcloud": "surface RESULT --las",
    "point-cloud": "surface RESULT --las",
    "dense": "surface RESULT",
    "densify": "surface RESULT",
    "mvs": "surface RESULT",
    "depthmaps": "surface RESULT --depths",
    "mesh": "surface RESULT --mesh CELL",
    "orthophoto": "surface RESULT --ortho CELL",
    "orthomosaic": "surface RESULT --ortho CELL",
    "orthoimage": "surface RESULT --ortho CELL",
    "dsm": "surface RESULT --dsm CELL",
    "dem": "surface RESULT --dsm CELL",
    "dtm": "heights ground SURFACE",
    "terrain": "heights ground SURFACE",
    "profile": "heights section SURFACE",
    "cross-section": "heights section SURFACE",
    "stockpile": "heights volume SURFACE",
    "cut-and-fill": "heights volume SURFACE",
    "cut-fill": "heights volume SURFACE",
    "dod": "heights difference BEFORE AFTER",
    "cloud-compare": "heights difference BEFORE AFTER",
    "elevation": "facade RESULT",
    "rectification": "rectify RESULT --out FILE",
    "orthorectify": "rpc ortho SCENE --dem FILE",
    # measurement
    "markers": "targets detect PHOTOS",
    "scalebar": "mark bar PROJECT A B LENGTH",
    "distance": "query RESULT",
    "deformation": "moved BEFORE AFTER --out FOLDER",
    "monitoring": "moved BEFORE AFTER --out FOLDER",
    "inspection": "measure PHOTOS --out RESULT",
    # exchange and the rest
    "colmap": "convert RESULT --to colmap --out PATH",
    "metashape": "convert RESULT --to metashape --out PATH",
    "export": "convert RESULT --to FORMAT --out PATH",
    "import": "convert INPUT --from FORMAT --to block --out PATH",
    "excel": "spreadsheet RESULT --out FILE",
    "viewer": "studio PROJECT",
    "gui": "studio PROJECT",
    "video": "frames VIDEO --out FOLDER",
    "flight": "plan mission AREA --out MISSION",
    "drone": "plan mission AREA --out MISSION",
    "network-design": "plan network OBJECT --out FOLDER",
    "report": "adjust BLOCK --out RESULT",
    "exif": "photos PHOTOS",
}
NEAR = 0.85
"""Likeness of a word to one of these from which it is taken for a misspelling."""
SHORTEST = 4
"""Letters of a beginning that stands for a word."""


def command_of(word: str) -> str | None:
    """The command line that does what a word names; None for a word that is none of the trade's."""
    plain = re.sub("[^a-z0-9]", "", word.lower())
    spellings = {spelling.replace("-", ""): line for spelling, line in TRADE_WORDS.items()}
    near = difflib.get_close_matches(plain, spellings, n=1, cutoff=NEAR)
    near += [s for s in spellings if len(plain) >= SHORTEST and s.startswith(plain)]
    near += sorted((s for s in spellings if len(s) >= SHORTEST and s in plain), key=len, reverse=True)
    return spellings[near[0]] if near else None
