"""The settings of an adjustment: one frozen object for Python, command line, project file and report.

Fields with a help are options of the command line, too (`commands.adjust`).
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Literal

from raybundle.settings import NOT_NEGATIVE, setting

Datum = Literal["auto", "control", "minimal", "inner"]
RejectMode = Literal["none", "snooping"]
NoiseModel = Literal["white", "fields", "auto"]
NOISE_HELP = (
    "Error model of image coordinates. white: independent errors. fields: smooth errors that differ from image to "
    "image, and a floor, both estimated from the residuals. auto: fields for five photographs or more that are "
    "measured here; white for a given block."
)

FEWEST_IMAGES = 5
"""Images from which on their differences are looked for unasked: fewer are too small a sample of them."""


def noise_of_photographs(asked: NoiseModel, images: int) -> NoiseModel:
    """What `auto` means for this number of photographs that were measured here."""
    return ("fields" if images >= FEWEST_IMAGES else "white") if asked == "auto" else asked


@dataclass(frozen=True, slots=True, kw_only=True)
class AdjustmentOptions:
    """How a block is adjusted.  The defaults adjust what is given: nothing rejected, nothing chosen."""

    datum: Datum = setting(
        "auto", "Datum of the adjustment. auto: inner constraints for the part that control, distances and stations "
        "leave open. control: an error if any part stays open. minimal: the fewest fixed coordinates. inner: inner "
        "constraints for everything but a measured scale.",
    )  # fmt: skip
    datum_points: tuple[str, ...] = setting(
        (), "Points that define the datum. Without it: all points.", metavar="A,B,C,...", joined=True
    )
    datum_over: Literal["", "all", "good"] = ""
    """Without `datum_points`: all object points; good: those that rays determine to twice the median standard
    deviation, where points far away would carry their uncertainty into every standard deviation; "": as the block
    states, or all."""
    estimate: Literal["given", "auto"] = setting(
        "given",
        "Choice of camera parameters. given: those named in block.toml. auto: by significance and determinability.",
    )
    free: tuple[tuple[str, str], ...] = setting(
        (), "Estimate this camera parameter in any case. May be repeated.", metavar="CAMERA SYMBOL",
        limits=("text", "text"),
    )  # fmt: skip
    hold: tuple[tuple[str, str], ...] = setting(
        (), "Fix this camera parameter at its value in the block. May be repeated.",
        metavar="CAMERA SYMBOL", limits=("text", "text"),
    )  # fmt: skip
    pixel_shape: Literal["sensor", "any"] = "sensor"
    """sensor: the automatic choice holds an affinity or a shear beyond what a sensor has; any: it believes each, as of
    scanned pictures.  Parameters that a camera's `estimate` names are free in any case."""
    weights: Literal["given", "residuals"] = "given"
    """Where the standard deviations of the image points come from.  residuals: an earlier adjustment of the same image
    points chose them, so that sigma0 near 1 and a passed global test say nothing; no number hangs on it."""
    variance_groups: bool = setting(
        False, "Estimate a variance factor for each group of observations. Groups are image points of each camera, "
        "control, distances and others. A group without redundancy keeps its given standard deviation.",
    )  # fmt: skip
    reject: RejectMode = setting(
        "none", "Rejection of blunders. snooping: reject image observations with significant blunders, one at a time."
    )
    residuals: Literal["as_block", "measured", "corrected"] = setting(
        "as_block", "Place of residuals: the measured or the corrected image point.  [default: as in block.toml]",
        unstated=True,
    )  # fmt: skip
    robust_start: bool = setting(False, "Begin with a robust weight function and end with least squares.")
    statistics: bool = True
    """False stops after the estimate: no covariances, no redundancy numbers."""
    max_iterations: int = 100
    tolerance: float = 1e-6
    """The last step's length, in standard deviations of the unknowns (root of dx' N dx / u)."""
    significance: float = 0.05
    """Family-wise significance level of the tests on additional parameters and of data snooping."""
    jobs: int = setting(0, "Number of processors; 0: all.", limits=NOT_NEGATIVE)
    noise: NoiseModel = setting("auto", NOISE_HELP)
    """fields widens the standard deviations; the estimates stay."""
