"""The figures of a report one by one, for notebooks and for other documents; drawn by the report's own sections."""

from __future__ import annotations

import base64
from collections.abc import Callable, Iterable, Iterator
from dataclasses import dataclass
from functools import cache
from html import escape
from importlib.resources import files
from pathlib import Path

from raybundle.adjustment.result import Adjustment
from raybundle.errors import InputError
from raybundle.io.folders import new_files
from raybundle.report.parts import Figure, Figures, Folded, Part, Section
from raybundle.report.sections.control import control_section
from raybundle.report.sections.interior import interior_section
from raybundle.report.sections.network import network_section
from raybundle.report.sections.reliability import reliability_section
from raybundle.report.sections.residuals import residual_section
from raybundle.report.view import View, view_of


@dataclass(frozen=True, slots=True, kw_only=True)
class Picture:
    """A figure of a report: a drawing that needs no other file, and what is to be said of it."""

    caption: str
    svg: str

    def save(self, path: str | Path) -> None:
        """Write it as an SVG file, which browsers, Inkscape and word processors open.

        raises  InputError for a name that does not end in .svg, or where nothing can be written
        """
        file = Path(path)
        if file.suffix.lower() != ".svg":
            raise InputError(
                "a picture is written as .svg; let a browser or Inkscape make other formats of it", file=file
            )
        with new_files(file) as (new,):
            new.write_text(self.svg, encoding="utf-8")

    def _repr_html_(self) -> str:
        """As an image of its own, so that its colours and those of the page keep apart."""
        data = base64.b64encode(self.svg.encode()).decode()
        caption = escape(self.caption)
        return (
            f'<figure><img src="data:image/svg+xml;base64,{data}" alt="{caption}">'
            f"<figcaption>{caption}</figcaption></figure>"
        )


class Pictures(tuple[Picture, ...]):
    """Several pictures, one below the other in a notebook."""

    __slots__ = ()

    def _repr_html_(self) -> str:
        """All of them."""
        return "".join(p._repr_html_() for p in self)

    def __repr__(self) -> str:
        """Their captions."""
        # a sentence ends with a full stop and a blank: numbers have full stops, too
        return f"<{len(self)} pictures: {'; '.join(p.caption.split('. ')[0].removesuffix('.') for p in self)}>"


def plot_network(result: Adjustment) -> Pictures:
    """Object points, images, control and error ellipses in three views; rays and angles of the points, rolls."""
    return _of(result, network_section)


def plot_residuals(result: Adjustment) -> Pictures:
    """Residuals of the image points: their distribution, means over the format, the vectors of the worst images."""
    return _of(result, residual_section)


def plot_interior(result: Adjustment) -> Pictures:
    """Distortion with its standard deviation, corrections over the format, uncertainty of projection, correlations."""
    return _of(result, interior_section)


def plot_reliability(result: Adjustment) -> Pictures:
    """Redundancy numbers and smallest detectable blunders over the format, and how they are distributed."""
    return _of(result, reliability_section)


def plot_control(result: Adjustment) -> Pictures:
    """Where control and check points were marked."""
    return _of(result, control_section)


def _of(result: Adjustment, section: Callable[[View], Section | None]) -> Pictures:
    made = section(view_of(result))
    return Pictures(() if made is None else _pictures(made.parts))


def _pictures(parts: Iterable[Part]) -> Iterator[Picture]:
    for part in parts:
        if isinstance(part, Figures):
            yield from map(picture_of, part.figures)
        elif isinstance(part, Folded):
            yield from _pictures(part.parts)


def picture_of(figure: Figure) -> Picture:
    """A figure of a section as one that needs no other file."""
    return Picture(caption=figure.caption, svg=_alone(str(figure.drawing.svg)))


def _alone(svg: str) -> str:
    """A drawing with the styles of the page that it was made for."""
    return svg.replace("<svg ", '<svg xmlns="http://www.w3.org/2000/svg" ', 1).replace(">", f">{_styles()}", 1)


@cache
def _styles() -> str:
    css = (files("raybundle.report") / "templates" / "style.css").read_text(encoding="utf-8")
    return f'<style>{css} svg {{ font-family: system-ui, "Segoe UI", "Noto Sans", Arial, sans-serif; }}</style>'
