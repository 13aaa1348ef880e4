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
    "ground-control": "orient PHOTOS --control CONTROL.csv --out PROJECT",
    "gcp": "orient PHOTOS --control CONTROL.csv --out PROJECT",
    "gnss": "orient PHOTOS --positions POSITIONS.txt --out PROJECT",
    "rtk": "orient PHOTOS --positions POSITIONS.txt --out PROJECT",
    "bundle": "adjust BLOCK --out RESULT",
    "optimize": "adjust BLOCK --out RESULT",
    "bundle-adjustment": "adjust BLOCK --out RESULT",
    "triangulate": "adjust BLOCK --out RESULT",
    "initial-processing": "orient PHOTOS --out PROJECT",
    "smartpoints": "orient PHOTOS --out PROJECT",
    "feature-extractor": "orient PHOTOS --out PROJECT",
    "image-matching": "orient PHOTOS --out PROJECT",
    "matcher": "orient PHOTOS --out PROJECT",
    "masks": "orient PHOTOS --masks DIR --out PROJECT",
    "merge-chunks": "merge PROJECT PROJECT --out MERGED",
    "chunk": "orient PHOTOS --out PROJECT",
    "tapioca": "orient PHOTOS --out PROJECT",
    "tapas": "orient PHOTOS --out PROJECT",
    "gcp-mtp-manager": "orient PHOTOS --control CONTROL.csv --out PROJECT",
    "gcp-bascule": "orient PHOTOS --control CONTROL.csv --out PROJECT",
    "model-aligner": "orient PHOTOS --control CONTROL.csv --out PROJECT",
    "reference-pane": "orient PHOTOS --control CONTROL.csv --out PROJECT",
    "center-bascule": "orient PHOTOS --positions POSITIONS.txt --out PROJECT",
    "geolocation": "orient PHOTOS --positions POSITIONS.txt --out PROJECT",
    "ppk": "orient PHOTOS --positions POSITIONS.txt --out PROJECT",
    "campari": "adjust BLOCK --out RESULT",
    "self-calibration": "adjust BLOCK --estimate auto --out RESULT",
    "gradual-selection": "adjust BLOCK --reject snooping --out RESULT",
    "data-snooping": "adjust BLOCK --reject snooping --out RESULT",
    "inner-constraints": "adjust BLOCK --datum inner --out RESULT",
    "free-network": "adjust BLOCK --datum inner --out RESULT",
    "variance-components": "adjust BLOCK --variance-groups --out RESULT",
    # calibration
    "calibrate-camera": "calibrate PHOTOS --target chessboard-9x6 --out CALIBRATION",
    "stereo-calibrate": "adjust BLOCK --out RESULT",
    "camera-calibration": "calibrate PHOTOS --out CALIBRATION",
    "chessboard": "calibrate PHOTOS --target chessboard-10x7 --out CALIBRATION",
    "checkerboard": "calibrate PHOTOS --target chessboard-10x7 --out CALIBRATION",
    "charuco": "calibrate PHOTOS --target BOARD --out CALIBRATION",
    "intrinsics": "calibrate PHOTOS --out CALIBRATION",
    "undistort": "convert RESULT --to colmap --out dense/sparse --photos PHOTOS --undistort inside",
    "idealize": "convert RESULT --to colmap --out dense/sparse --photos PHOTOS --undistort inside",
    # surfaces and maps
    "malt": "surface RESULT --dsm CELL",
    "c3dc": "surface RESULT",
    "tawny": "surface RESULT --ortho CELL",
    "stereo-fusion": "surface RESULT",
    "patch-match-stereo": "surface RESULT --depths",
    "pointcloud": "surface RESULT --las",
    "point-cloud": "surface RESULT --las",
    "dense": "surface RESULT",
    "densify": "surface RESULT",
    "densification": "surface RESULT",
    "mvs": "surface RESULT",
    "depthmaps": "surface RESULT --depths",
    "mesh": "surface RESULT --mesh CELL",
    "orthophoto": "surface RESULT --ortho CELL",
    "orthomosaic": "surface RESULT --ortho CELL",
    "orthoimage": "surface RESULT --ortho CELL",
    "dsm": "surface RESULT --dsm CELL",
    "dem": "surface RESULT --dsm CELL",
    "build-dem": "surface RESULT --dsm CELL",
    "texture": "surface RESULT --mesh CELL --ortho CELL",
    "processing-area": "surface RESULT --region FILE",
    "classify-ground": "heights ground SURFACE",
    "dtm": "heights ground SURFACE",
    "terrain": "heights ground SURFACE",
    "profile": "heights section SURFACE",
    "cross-section": "heights section SURFACE",
    "stockpile": "heights volume SURFACE",
    "cut-and-fill": "heights volume SURFACE",
    "cut-fill": "heights volume SURFACE",
    "dod": "heights difference BEFORE AFTER",
    "cloud-compare": "heights difference BEFORE AFTER",
    "warp-perspective": "rectify RESULT --out FILE",
    "elevation": "facade RESULT",
    "rectification": "rectify RESULT --out FILE",
    "orthorectify": "rpc ortho SCENE --dem FILE",
    # measurement
    "mtp": "mark put PROJECT IMAGE POINT X Y",
    "coded-targets": "measure PHOTOS --out RESULT",
    "markers": "mark put PROJECT IMAGE POINT X Y",
    "detect-markers": "targets detect PHOTOS",
    "aruco": "targets detect PHOTOS",
    "print-coded-targets": "targets sheet --target FAMILY --out SHEET.pdf",
    "constraints": "mark line PROJECT LINE POINT POINT --figure plumb",
    "scale-and-rotation": "datum RESULT --origin A --axis B --plane C --out FOLDER",
    "scalebar": "mark bar PROJECT A B LENGTH",
    "distance": "query RESULT",
    "deformation": "moved BEFORE AFTER --out FOLDER",
    "monitoring": "epochs PROJECT --add PHOTOS",
    "inspection": "measure PHOTOS --out RESULT",
    # exchange and the rest
    "colmap": "convert RESULT --to colmap --out PATH",
    "metashape": "convert RESULT --to metashape --out PATH",
    "aperi-cloud": "convert RESULT --to ply --out FILE",
    "model-converter": "convert MODEL --to block --out BLOCK",
    "file-storage": "calibration convert CAMERA.toml --to opencv --out camera.yaml",
    "export": "convert RESULT --to FORMAT --out PATH",
    "import": "convert INPUT --from FORMAT --to block --out PATH",
    "excel": "spreadsheet RESULT --out FILE",
    "raycloud": "studio PROJECT",
    "saisie-appuis": "studio PROJECT",
    "network-processing": "scheduler FOLDER",
    "viewer": "studio PROJECT",
    "gui": "studio PROJECT",
    "video": "frames VIDEO --out FOLDER",
    "flight": "plan mission AREA --out MISSION",
    "drone": "plan mission AREA --out MISSION",
    "network-design": "plan network OBJECT --out FOLDER",
    "report": "adjust BLOCK --out RESULT",
    "image-quality": "plan check PLAN PHOTOS",
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
