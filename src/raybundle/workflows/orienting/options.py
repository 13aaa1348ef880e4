"""What `orient` can be asked for."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path
from typing import Literal

from raybundle.adjustment.records.options import NOISE_HELP, NoiseModel
from raybundle.settings import NOT_NEGATIVE, POSITIVE, Range, setting

KNOWN_HELP = (
    "File of known cameras. `estimate = []` in it fixes them. Calibrations of `raybundle calibrate` are observed "
    "with their covariance."
)
APART_HELP = (
    "Treat photographs matching PATTERN as a separate camera, e.g. 'left_*' or 'a.jpg|b.jpg'. For photographs "
    "without metadata."
)
LIBRARY_HELP = "Ignore calibrations of the camera library."
CLUSTER_HELP = (
    "Run tasks such as features and depth maps on other machines. Give the cluster folder from `raybundle scheduler "
    "FOLDER` (extra [cluster]). shards: write the tasks for `raybundle worker` and end."
)
"""Of the setting `cluster`, which every command has whose stages can be done elsewhere"""
STORE_HELP = (
    "Storage of the products of stages. Give the URL of an object store for this project alone, e.g. "
    "s3://bucket/folder (extra [cluster] and the package of the service). The project remembers it. project: its "
    "own folder.  [default: as the last run, at first in the folder]"
)
"""Of the setting `store`"""
PIXELS_GB = 4.0
"""Memory that image pixels take unasked while points are measured."""


@dataclass(frozen=True, slots=True, kw_only=True)
class OrientOptions:
    """How photographs are oriented.  The defaults need no change."""

    own_camera: tuple[str, ...] = setting((), APART_HELP, metavar="PATTERN")
    masks: Path | None = setting(
        None, "Masks of the photographs: nothing is measured where they are 0. Named photo.jpg.png (COLMAP), "
        "photo_mask.png or photo.png (Metashape).", metavar="DIR",
    )  # fmt: skip
    library: bool = setting(True, LIBRARY_HELP, flag="no-library")
    target: tuple[str, ...] = setting(
        (), "Coded targets in the photographs, e.g. aicon14 or apriltag-36h11. Their codes name new points or points "
        "of {control}. With several families: FAMILY:CODE.", metavar="FAMILY", also=("family",),
    )  # fmt: skip
    attitudes: Literal[
        "auto", "none", "opk", "opk-deg", "opk-gon", "opk-rad", "pok", "pok-deg", "pok-gon", "pok-rad", "matrix",
        "matrix-inverse", "rpy-ned", "gimbal",
    ] = setting(
        "auto", "Observe attitudes of {positions}, or of the gimbal, by their convention. auto: attitudes with "
        "standard deviations in the file. pok: phi is the primary angle.",
    )  # fmt: skip
    attitude_sigma: tuple[float, float] | None = setting(
        None, "Standard deviations [deg] of attitudes that have none. With it, gimbal attitudes are observed too.",
        metavar="TILT HEADING", limits=(POSITIVE, POSITIVE),
    )  # fmt: skip
    relative: Literal["", "shift", "drift"] = setting(
        "", "Use only differences of positions and attitudes within a flight line (relative aerial control). drift: "
        "also after a drift of the positions.",
    )  # fmt: skip
    scene_bias: Literal["none", "shift", "drift", "affine"] = setting(
        "shift", "Parameters to estimate for the RPC of a satellite scene."
    )
    crs: str | None = setting(
        None, "Coordinate system of inputs that define none, e.g. EPSG:32633: control, check points, {positions} in "
        "a grid. With heights (EPSG:32633+5773, EPSG:32633+ellipsoid) also for files that define only the plan.",
        metavar="SYSTEM",
    )  # fmt: skip
    features: str = setting(
        "rootsift", "Kind of features. rootsift; for wide baselines xfeat or disk (extra [learned]).", metavar="METHOD"
    )
    feature_count: int = setting(10_000, "Number of features per photograph.", limits=Range(low=100))
    wide_baselines: Literal["all", "own", "none"] = setting(
        "own", "Further matching of photographs that stay without orientation or in other parts. own: affine views; "
        "all: learned methods, too, where installed (extra [learned]).",
    )  # fmt: skip
    start: Literal["auto", "growing", "averaging", "parts"] = setting(
        "auto", "Start of the orientation: image by image, all pairs at once, or in parts that are joined. auto: "
        "parts for very many photographs; all pairs if image by image leaves photographs out or the view is narrow.",
    )  # fmt: skip
    precise: bool = setting(True, "Skip least-squares matching: several times less precise.", flag="quick")
    jobs: int = setting(0, "Number of processors; 0: all.", limits=NOT_NEGATIVE)
    cluster: str = setting("", CLUSTER_HELP, metavar="FOLDER|shards")
    store: str = setting("", STORE_HELP, metavar="URL|project")
    memory: float = setting(
        0.0, "Memory limit for pixels during measurement, and for an adjustment [GB]. 0: 4 for pixels; for "
        "adjustments four fifths of the free memory, at least 1. Larger adjustments run in parts, from 0.2 on.",
        metavar="GB", limits=Range(low=0.0, high=1e6),
    )  # fmt: skip
    redo_from: str = setting(
        "",
        "Repeat this stage and all later ones. `raybundle status` lists them.",
        flag="from-stage",
        metavar="STAGE",
    )
    read_out: float | None = setting(
        None, "Read-out time of a rolling shutter; 0: none. Without it, photographs with recorded times are tested "
        "for it.", metavar="MS", limits=Range(low=0, high=1000),
    )  # fmt: skip
    noise: NoiseModel = setting("auto", NOISE_HELP)

    @property
    def read_out_s(self) -> float | None:
        """Read-out time of rolling shutters [s]."""
        return None if self.read_out is None else self.read_out / 1000
