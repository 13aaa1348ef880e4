"""The settings of an adjustment: one frozen object for Python, command line, project file and report.

Fields with a help are options of the command line, too (`commands.adjust`).
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Literal

from raybundle.settings import NOT_NEGATIVE, setting

Datum = Literal["auto", "control", "minimal", "inner"]
NoiseModel = Literal["white", "fields", "auto"]
NOISE_HELP = (
    "Errors of image coordinates, for standard deviations: white: independent; fields: smooth ones that "
    "differ from image to image, and a floor, both estimated from the residuals; auto: fields for five photographs or "
    "more that are measured here, white for a block that is given."
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
        "auto", "auto: inner constraints take what control, distances and stations leave open; control: an error if "
        "anything stays open; minimal: the fewest coordinates held; inner: inner constraints for everything but a "
        "measured scale.",
    )  # fmt: skip
    datum_points: tuple[str, ...] = setting(
        (), "Points that carry the datum; all if not given.", metavar="A,B,C,...", joined=True
    )
    datum_over: Literal["", "all", "good"] = ""
    """Without `datum_points`: all object points; good: those that rays determine to twice the median standard
    deviation, where points far away would carry their uncertainty into every standard deviation; "": as the block
    says, or all."""
    estimate: Literal["given", "auto"] = setting(
        "given", "given: the parameters named in block.toml; auto: chosen by significance and determinability."
    )
    free: tuple[tuple[str, str], ...] = setting(
        (), "Estimate this parameter of a camera in any case; may be repeated.", metavar="CAMERA SYMBOL",
        limits=("text", "text"),
    )  # fmt: skip
    hold: tuple[tuple[str, str], ...] = setting(
        (), "Hold this parameter of a camera as the block has it, in any case; may be repeated.",
        metavar="CAMERA SYMBOL", limits=("text", "text"),
    )  # fmt: skip
    pixel_shape: Literal["sensor", "any"] = "sensor"
    """sensor: the automatic choice holds an affinity or a shear beyond what a sensor has; any: it believes each, as of
    scanned pictures.  Parameters that a camera's `estimate` names are free in any case."""
    weights: Literal["given", "residuals"] = "given"
    """Where the standard deviations of the image points come from.  residuals: an earlier adjustment of the same image
    points chose them, so that sigma0 near 1 and a passed global test say nothing; no number hangs on it."""
    variance_groups: bool = setting(
        False, "Groups of observations (image points of each camera, control, distances ...) have variance factors of "
        "their own, as far as residuals determine them; what has no redundancy keeps its standard deviation as given.",
    )  # fmt: skip
    reject: Literal["none", "snooping"] = setting(
        "none", "snooping: image observations with significant blunders are left out, one at a time."
    )
    residuals: Literal["as_block", "measured", "corrected"] = setting(
        "as_block", "Where residuals are taken: at the measured or at the corrected image point.  [default: as in"
        "block.toml]", unsaid=True,
    )  # fmt: skip
    robust_start: bool = setting(False, "Begin with a robust weight function; the end is least squares.")
    statistics: bool = True
    """False stops after the estimate: no covariances, no redundancy numbers."""
    max_iterations: int = 100
    tolerance: float = 1e-6
    """The last step's length, in standard deviations of the unknowns (root of dx' N dx / u)."""
    significance: float = 0.05
    """Family-wise significance level of the tests on additional parameters and of data snooping."""
    jobs: int = setting(0, "How many processors; 0: all.", limits=NOT_NEGATIVE)
    noise: NoiseModel = setting("auto", NOISE_HELP)
    """fields widens the standard deviations; the estimates stay."""
