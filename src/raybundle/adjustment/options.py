"""The settings of an adjustment: one frozen object for Python, command line, project file and report."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Literal

Datum = Literal["auto", "control", "minimal", "inner"]
NoiseModel = Literal["white", "fields", "auto"]


FEWEST_IMAGES = 5
"""Images from which on their differences are looked for unasked: fewer are too small a sample of them."""


def noise_of_photographs(asked: NoiseModel, images: int) -> NoiseModel:
    """What `auto` means for this number of photographs that were measured here."""
    return ("fields" if images >= FEWEST_IMAGES else "white") if asked == "auto" else asked


@dataclass(frozen=True, slots=True, kw_only=True)
class AdjustmentOptions:
    """How a block is adjusted.  The defaults adjust what is given: nothing rejected, nothing chosen."""

    datum: Datum = "auto"
    """auto: what control, distances and stations leave open is taken by inner constraints; control: an
    error if anything stays open; minimal: the fewest coordinates of well-spread points held; inner: inner
    constraints for everything but a scale that distances fix."""
    datum_points: tuple[str, ...] = ()
    """Points that carry the inner constraints; () = all object points."""
    datum_over: Literal["", "all", "good"] = ""
    """Without `datum_points`: all object points; good: those that rays determine to twice the median standard
    deviation, where points far away would carry their uncertainty into every standard deviation; "": as the block
    says, or all."""
    estimate: Literal["given", "auto"] = "given"
    """given: the parameters named in the block; auto: chosen by significance, BIC and determinability."""
    pixel_shape: Literal["sensor", "any"] = "sensor"
    """sensor: the automatic choice holds an affinity or a shear beyond what a sensor has; any: it believes each, as of
    scanned pictures.  Parameters that a camera's `estimate` names are free in any case."""
    weights: Literal["given", "residuals"] = "given"
    """Where the standard deviations of the image points come from.  residuals: an earlier adjustment of the same image
    points chose them, so that sigma0 near 1 and a passed global test say nothing; no number hangs on it."""
    reject: Literal["none", "snooping"] = "none"
    """snooping: blunders leave one family at a time, with reactivation."""
    residuals: Literal["as_block", "measured", "corrected"] = "as_block"
    """Where the residual is taken; see BLOCK_FORMAT."""
    robust_start: bool = False
    """Start with a Huber weight function; the end is always pure least squares."""
    statistics: bool = True
    """False stops after the estimate: no covariances, no redundancy numbers."""
    noise: NoiseModel = "auto"
    """white: errors of image coordinates are independent; fields: smooth errors that differ from image to image and a
    floor, both from the residuals, widen the standard deviations (the estimates stay); auto: fields for five
    photographs or more that are measured here, white noise for blocks that are given."""
    max_iterations: int = 100
    tolerance: float = 1e-6
    """The last step's length, in standard deviations of the unknowns (root of dx' N dx / u)."""
    significance: float = 0.05
    """Family-wise significance level of the tests on additional parameters and of data snooping."""
    threads: int = 0
    """0 = all processors."""
