"""A figure of a report as a document of its own, with the styles of the page that it was drawn for."""

from __future__ import annotations

from functools import cache
from importlib.resources import files

from raybundle.report.parts import Figure


def svg_of(figure: Figure) -> str:
    """A figure of a section as an SVG document that needs no other file."""
    svg = str(figure.drawing.svg)
    return svg.replace("<svg ", '<svg xmlns="http://www.w3.org/2000/svg" ', 1).replace(">", f">{_styles()}", 1)


@cache
def _styles() -> str:
    css = (files("raybundle.report") / "templates" / "style.css").read_text(encoding="utf-8")
    return f'<style>{css} svg {{ font-family: system-ui, "Segoe UI", "Noto Sans", Arial, sans-serif; }}</style>'
