"""What figures of matplotlib have in common: a Figure that shows itself, colours, formats, vectors, names."""

from __future__ import annotations

from collections.abc import Sequence
from io import BytesIO
from typing import Any, cast

from matplotlib.axes import Axes
from matplotlib.backends.backend_agg import FigureCanvasAgg
from matplotlib.collections import QuadMesh
from matplotlib.figure import Figure, SubFigure

from raybundle.block import Camera
from raybundle.errors import InputError
from raybundle.numerics.arrays import Array, Mask
from raybundle.report.figures.svg import CHARACTER, round_below, spots_apart
from raybundle.report.text.numbers import significant
from raybundle.report.view import View

BLUE, ORANGE, GREEN, VERMILION, GREY, BLACK = "#0072B2", "#E69F00", "#009E73", "#D55E00", "#8A8A8A", "#1A1A1A"
"""Distinguished by eyes that see no red or green, and in grey (Okabe and Ito 2008)"""
DPI = 150
"""Of what is drawn as dots of an image, and of a figure in a notebook"""
RASTERIZED = 1500
"""Symbols beyond which they are dots of an image within SVG and PDF: each would be an element of its own"""
MOST_CAMERAS = 6
"""Cameras that are drawn without being asked for"""
ABOVE_KEY = 20
"""Distance of a title from axes that have a key above [point]"""
PANEL = 3.6
"""Width of a panel [inch]"""


class ShownFigure(Figure):
    """A Figure that a notebook shows although pyplot knows nothing of it: no window is opened, no state changed."""

    def _repr_png_(self) -> tuple[bytes, dict[str, int]]:
        """As IPython asks for it: PNG, and the size at which it is shown."""
        held = BytesIO()
        self.savefig(held, format="png")
        width, height = (round(96 * float(inches)) for inches in self.get_size_inches())
        return held.getvalue(), {"width": width, "height": height}


Canvas = Figure | SubFigure
"""Into which is drawn"""


def begun(figure: Canvas | None, width: float, height: float, layout: str = "constrained") -> tuple[Canvas, Figure]:
    """What is drawn into, and the whole Figure of it: a new one of this size [inch] where none was given."""
    if figure is None:
        made = ShownFigure(figsize=(width, height), dpi=DPI, layout=cast("Any", layout))
        FigureCanvasAgg(made)  # which draws without a window
        return made, made
    if not isinstance(figure, Figure | SubFigure):  # pyright: ignore[reportUnnecessaryIsInstance]
        raise InputError("figure.wrong_type", type=type(figure).__name__)
    return figure, figure.figure


def chosen_cameras(view: View, camera: str | None) -> list[tuple[int, Mask]]:
    """Cameras with image points that took part, and the rows (m,) of these; of many the first ones.

    raises  InputError where there is none, or none of this name
    """
    found = view.cameras()
    ids = [view.given.cameras[c].id for c, _ in found]
    if not found:
        raise InputError("figure.no_image_points")
    if camera is None:
        return found[:MOST_CAMERAS]
    if camera not in ids:
        raise InputError("figure.camera_without_points", camera=camera, known=ids)
    return [found[ids.index(camera)]]


def format_axes(axes: Axes, camera: Camera, title: str, pad: float = 6) -> None:
    """Axes over an image format: pixels, y down, at true proportions."""
    axes.set(
        xlim=(0, camera.width_px), ylim=(camera.height_px, 0), aspect="equal", xlabel="x [px]", ylabel="y [px]",
    )  # fmt: skip
    axes.locator_params(nbins=5)
    axes.set_title(title.replace("; ", ";\n"), fontsize="medium", pad=pad)


def format_width(camera: Camera) -> float:
    """Width over height of a format, within what can be drawn as a panel."""
    return min(max(camera.width_px / camera.height_px, 0.5), 4.0)


def vectors(
    axes: Axes, at: Array, vector: Array, enlarged: float, unit: tuple[float, str], *, colour: str = BLUE,
    width: float = 0.01,
) -> None:  # fmt: skip
    """Vectors (n, 2) at points (n, 2) in the units of the axes, with an arrow of round length as their key.

    enlarged  length in the drawing over that of the vector
    unit      factor from the units of the vectors to those of the key, and its name
    """
    if not len(at) or not enlarged > 0:
        return
    drawn = axes.quiver(
        at[:, 0], at[:, 1], vector[:, 0], vector[:, 1], angles="xy", scale_units="xy", scale=1 / enlarged,
        units="inches", width=width, color=colour, rasterized=len(at) > RASTERIZED, clip_on=True,
    )  # fmt: skip
    wide, tall = (abs(high - low) for low, high in (axes.get_xlim(), axes.get_ylim()))
    length = round_below(0.12 * wide / enlarged * unit[0]) / unit[0]
    words = length_words(length * unit[0], unit[1])
    above = 0.13 / PANEL * max(wide / tall, 1.0)  # room for letters, whatever the height of the axes
    axes.quiverkey(
        drawn, 0.9, 1 + above, length, words, labelpos="W", coordinates="axes", labelsep=0.05,
        fontproperties={"size": "small"}, labelcolor=BLACK,
    )  # fmt: skip


def length_words(value: float, unit: str) -> str:
    """A round length with its unit: of a metre and more in metres."""
    return f"{significant(value / 1000, 1)} m" if unit == "mm" and value >= 1000 else f"{significant(value, 1)} {unit}"


def cells_over_format(
    axes: Axes, camera: Camera, values: Array, name: str, colours: str = "cividis", *,
    low: float | None = 0.0, high: float | None = None,
) -> QuadMesh:  # fmt: skip
    """Values (rows, columns) as coloured cells over a format, with their scale; NaN stays white."""
    rows, columns = values.shape
    x = [k * camera.width_px / columns for k in range(columns + 1)]
    y = [k * camera.height_px / rows for k in range(rows + 1)]
    mesh = axes.pcolormesh(x, y, values, cmap=colours, vmin=low, vmax=high, rasterized=rows * columns > RASTERIZED)
    axes.figure.colorbar(mesh, cax=axes.inset_axes((1.03, 0.0, 0.05, 1.0)), label=name)
    return mesh


def named(axes: Axes, at: Array, names: Sequence[str]) -> None:
    """Names beside points (n, 2), each where it covers no other one; a name that has no room is left out.

    Positions hang on the size of the drawing: they are found when everything else stands.
    """
    whole = axes.figure.figure
    whole.draw_without_rendering()
    size = 8.0
    pixel = size / 10 * whole.dpi / 72  # of the drawings that spots are found for, whose letters are 10 px high
    shown = axes.transData.transform(at) / pixel
    box = axes.get_window_extent().get_points() / pixel
    (x0, y0), (x1, y1) = box.tolist()
    spots = spots_apart(
        shown[:, 0].tolist(), (-shown[:, 1]).tolist(), [len(n) * CHARACTER for n in names], (x0, -y1, x1 - x0, y1 - y0)
    )
    for k, right, up in spots:
        axes.annotate(
            names[k], at[k], (4 if right else -4, 3 if up else -3), textcoords="offset points", fontsize=size,
            ha="left" if right else "right", va="bottom" if up else "top", color=BLACK,
        )  # fmt: skip


def counts_axis(axes: Axes, name: str) -> None:
    """The axis of a histogram."""
    axes.set_ylabel(name)
    axes.grid(visible=True, axis="y", alpha=0.3, linewidth=0.6)
    axes.set_axisbelow(True)


def rows_of_cameras(
    view: View, camera: str | None, figure: Canvas | None
) -> tuple[list[tuple[int, Mask]], Any, Figure]:
    """The chosen cameras, a row of three panels (n, 3) for each, as high as the widest format asks, and the figure."""
    cameras = chosen_cameras(view, camera)
    widest = max(format_width(view.given.cameras[c]) for c, _ in cameras)
    height = PANEL / min(max(widest, 0.8), 2.0) + 0.9
    canvas, whole = begun(figure, 3 * PANEL + 0.6, height * len(cameras))
    return cameras, canvas.subplots(len(cameras), 3, squeeze=False), whole
