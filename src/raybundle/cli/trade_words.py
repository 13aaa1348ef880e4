"""Words of the trade that are no commands, each with the command line that does what it names."""

from __future__ import annotations

import difflib

TRADE_WORDS: dict[str, str] = {
    # orientation
    "align": "orient PHOTOS --out PROJECT",
    "sfm": "orient PHOTOS --out PROJECT",
    "mapper": "orient PHOTOS --out PROJECT",
    "aerotriangulation": "orient PHOTOS --control CONTROL.csv --out PROJECT",
    "georeference": "orient PHOTOS --control CONTROL.csv --out PROJECT",
    "gcp": "orient PHOTOS --control CONTROL.csv --out PROJECT",
    "gnss": "orient PHOTOS --positions POSITIONS.txt --out PROJECT",
    "rtk": "orient PHOTOS --positions POSITIONS.txt --out PROJECT",
    "bundle": "adjust BLOCK --out RESULT",
    "bundle-adjustment": "adjust BLOCK --out RESULT",
    "triangulate": "adjust BLOCK --out RESULT",
    # calibration
    "chessboard": "calibrate PHOTOS --target chessboard-10x7",
    "checkerboard": "calibrate PHOTOS --target chessboard-10x7",
    "charuco": "calibrate PHOTOS --target BOARD",
    "intrinsics": "calibrate PHOTOS",
    "undistort": "convert RESULT --to colmap --out dense/sparse --photos PHOTOS --undistort inside",
    # surfaces and maps
    "pointcloud": "surface RESULT --las",
    "point-cloud": "surface RESULT --las",
    "dense": "surface RESULT",
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
    "cut-fill": "heights volume SURFACE",
    "dod": "heights difference BEFORE AFTER",
    "cloud-compare": "heights difference BEFORE AFTER",
    "rectification": "rectify RESULT",
    "orthorectify": "rpc ortho SCENE",
    # measurement
    "markers": "targets detect PHOTOS",
    "scalebar": "mark bar PROJECT A B LENGTH",
    "distance": "query RESULT",
    "deformation": "moved BEFORE AFTER",
    "monitoring": "moved BEFORE AFTER",
    "inspection": "measure PHOTOS",
    # exchange and the rest
    "export": "convert RESULT --to FORMAT --out PATH",
    "import": "convert INPUT --from FORMAT --to block --out PATH",
    "excel": "spreadsheet RESULT",
    "viewer": "studio PROJECT",
    "gui": "studio PROJECT",
    "video": "frames VIDEO",
    "flight": "plan mission AREA",
    "network-design": "plan network OBJECT",
    "report": "adjust BLOCK --out RESULT",
    "exif": "photos PHOTOS",
}
NEAR = 0.85
"""Likeness of a word to one of these from which it is taken for a misspelling."""
SHORTEST = 4
"""Letters of a beginning that stands for a word."""


def command_of(word: str) -> str | None:
    """The command line that does what a word names; None for a word that is none of the trade's."""
    plain = word.lower().replace("_", "").replace("-", "")
    spellings = {spelling.replace("-", ""): line for spelling, line in TRADE_WORDS.items()}
    near = difflib.get_close_matches(plain, spellings, n=1, cutoff=NEAR)
    near += [s for s in spellings if len(plain) >= SHORTEST and s.startswith(plain)]
    return spellings[near[0]] if near else None
