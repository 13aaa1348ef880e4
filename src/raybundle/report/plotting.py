"""Figures of matplotlib from an adjustment, for programs, papers and notebooks: what the report draws, to be restyled.

They are drawn from the same numbers as the pictures of the report.  matplotlib is loaded when the first is asked for.
"""

from __future__ import annotations

from importlib.util import find_spec
from typing import TYPE_CHECKING

from raybundle.adjustment.result import Adjustment
from raybundle.errors import InputError
from raybundle.report.view import View, view_of, with_near_viewpoints

if TYPE_CHECKING:
    from matplotlib.figure import Figure, SubFigure


def plot_network(result: Adjustment, *, figure: Figure | SubFigure | None = None) -> Figure:
    """Plan, front and side view at one scale: object points with error ellipses, images with their viewing directions.

    figure   into which is drawn, or a part of one; None: a new one
    returns  the Figure
    raises   InputError where matplotlib is not installed, for anything but an adjustment, and if no object point has
             coordinates

    Ellipses are of one standard deviation (a point lies within its own with 39 %), of 250 points at most, and enlarged;
    the title gives the factor.  Scenes of satellites stand near their ground: at their true height nothing else were to
    be seen.
    """
    _check()
    from raybundle.report.plots.network import draw

    return draw(with_near_viewpoints(_view(result)), figure)


def plot_residuals(
    result: Adjustment, *, camera: str | None = None, figure: Figure | SubFigure | None = None
) -> Figure:
    """Residuals of the image points of each camera: vectors over the format, their means, and their distribution.

    camera   its id; None: all, the first six of many
    figure   into which is drawn, or a part of one; None: a new one
    returns  the Figure
    raises   InputError where matplotlib is not installed, for anything but an adjustment, an unknown camera, and if no
             image point took part

    Residuals are adjusted minus observed, in the pixel frame (x right, y down).  A histogram that follows the normal
    curve does not prove independent residuals: their means over the format show common errors.
    """
    _check()
    from raybundle.report.plots.residuals import draw

    return draw(_view(result), camera, figure)


def plot_interior(
    result: Adjustment,
    *,
    camera: str | None = None,
    image: str | None = None,
    figure: Figure | SubFigure | None = None,
) -> Figure:
    """An interior orientation: distortion with its standard deviation, corrections, uncertainty of projection.

    camera   its id; None: the first one that has figures
    image    where each image has an interior orientation of its own; None: the first
    figure   into which is drawn, or a part of one; None: a new one
    returns  the Figure
    raises   InputError where matplotlib is not installed, for anything but an adjustment, an unknown camera, and for
             one without distortion and uncertainty, as a satellite's

    Bands are of one standard deviation, and may be thinner than the line.  Beyond the radius that observations reach
    (shaded) curves and bands are extrapolated, with unknown accuracy.
    """
    _check()
    from raybundle.report.plots.interior import draw

    return draw(_view(result), camera, image, figure)


def plot_reliability(
    result: Adjustment, *, camera: str | None = None, figure: Figure | SubFigure | None = None
) -> Figure:
    """Redundancy numbers of the image points over the format and distributed, and minimal detectable biases.

    camera   its id; None: all, the first six of many
    figure   into which is drawn, or a part of one; None: a new one
    returns  the Figure
    raises   InputError where matplotlib is not installed, for anything but an adjustment, an unknown camera, and for an
             adjustment without statistics

    Minimal detectable biases hold for a single blunder (level 0.1 %, power 80 %).  Coordinates with a redundancy
    number below 0.01 have none, since practically no blunder is detected there.
    """
    _check()
    from raybundle.report.plots.reliability import draw

    return draw(_view(result), camera, figure)


def plot_control(result: Adjustment, *, figure: Figure | SubFigure | None = None) -> Figure:
    """Differences at control and check points, adjusted minus given, with their standard deviations, and in plan.

    figure   into which is drawn, or a part of one; None: a new one
    returns  the Figure
    raises   InputError where matplotlib is not installed, for anything but an adjustment, and if no control was
             observed and no check point compared

    Bars are one standard deviation of the difference: of check points from that of the adjusted and of the given
    coordinate, of control that of the residual.  Control took part: its differences are no measure of accuracy.
    """
    _check()
    from raybundle.report.plots.control import draw

    return draw(_view(result), figure)


def _check() -> None:
    """Raise InputError where matplotlib is not installed, before anything is computed; it is not loaded."""
    if find_spec("matplotlib") is None:
        raise InputError("package.matplotlib_missing")


def _view(result: Adjustment) -> View:
    if not isinstance(result, Adjustment):  # pyright: ignore[reportUnnecessaryIsInstance]
        raise InputError("figure.no_adjustment", type=type(result).__name__)
    return view_of(result)
