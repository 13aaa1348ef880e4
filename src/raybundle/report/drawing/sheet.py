"""A drawing on paper, true to scale: the pages of its PDF."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from raybundle.errors import InputError, message
from raybundle.report.drawing.content import Drawing, Field
from raybundle.report.drawing.fonts import load_fonts
from raybundle.report.drawing.legend import Legend, legend
from raybundle.report.drawing.paper import (
    MOST_SHEETS,
    OVERLAP,
    PAPERS,
    SMALLEST,
    Division,
    Paper,
    divided,
    scale_that_fits,
    usual_length,
)
from raybundle.report.drawing.title_block import WIDTH, TitleBlock, title_block

POINT = 72 / 25.4
"""Points of a PDF in a millimetre"""
NAME, NUMBER = 2.4, 2.1
"""Sizes of letters [mm]: names of points, numbers of the grid"""
GRID = 50.0
"""Usual distance of grid lines [mm], at most"""
ABOVE = 0.8
"""Between a line and the words along it [mm]"""
CROSS = 2.5
"""Half a cross of the grid [mm]"""
BESIDE = 75.0
"""Width that a legend beside the title block needs [mm]; where there is less it stands above"""


LEAST_GRID = 10.0
"""Distance of grid lines [mm], at least: their numbers need it"""
LEAST_ROOM = 40.0
"""Width and height that are left for the drawing [mm], at least"""


@dataclass(frozen=True, slots=True, kw_only=True)
class Sheets:
    """How a drawing comes to lie on paper."""

    paper: Paper
    scale: int
    division: Division
    block: TitleBlock
    legend: Legend
    beside: bool
    """whether the legend stands beside the title block, and not above"""


def planned(drawing: Drawing, name: str, *, scale: int | None, landscape: bool | None, several: bool) -> Sheets:
    """Choose the paper's direction where that is free, the largest usual scale where none is given, and the sheets.

    name       of the paper
    landscape  None: as the object is larger
    several    whether more than one sheet may be taken
    raises     InputError where the object does not fit, with a scale and a paper that do
    """
    load_fonts()
    ways = (False, True) if landscape is None else (landscape,)
    found = [s for way in ways if (s := _on(drawing, name, scale, landscape=way, several=several)) is not None]
    if found:
        best = min(found, key=lambda s: (s.scale, len(s.division.parts), not s.paper.width > s.paper.height))
        _check_grid(drawing, best)
        return best
    raise _misfit(drawing, name, scale, ways, several=several)


def _check_grid(drawing: Drawing, sheets: Sheets) -> None:
    """Raise InputError for a grid whose numbers would lie on each other."""
    apart = (drawing.grid or 0.0) * drawing.millimetres / sheets.scale
    if 0 < apart < LEAST_GRID:
        need = usual_length(2 * LEAST_GRID * sheets.scale / drawing.millimetres)
        raise InputError(
            "drawing.grid_too_dense", grid=drawing.grid or 0.0, apart_mm=apart, least_mm=LEAST_GRID, needed=need
        )


def _on(drawing: Drawing, name: str, scale: int | None, *, landscape: bool, several: bool) -> Sheets | None:
    """The sheets on one paper; None where the object does not fit."""
    wide, tall = PAPERS[name][::-1] if landscape else PAPERS[name]
    none = Division(parts=(), columns=1, rows=1, overlap=np.zeros(2), size=np.zeros(2))
    first = _laid(drawing, name, wide, tall, scale, none, several=several)
    # once more with the scale and the number of sheets that title block and legend are to say
    return None if first is None else _laid(
        drawing, name, wide, tall, scale, first.division, several=several, told=first.scale
    )  # fmt: skip


def _laid(
    drawing: Drawing, name: str, wide: float, tall: float, scale: int | None, division: Division, *, several: bool,
    told: int = SMALLEST,
) -> Sheets | None:  # fmt: skip
    paper, block, key, beside = _furnished(drawing, name, wide, tall, told, division)
    if (paper.room < LEAST_ROOM).any():
        return None
    chosen = scale or scale_that_fits(drawing.size, paper.room)
    if chosen is None:
        return None
    unit = chosen / drawing.millimetres
    found = divided(drawing.low, drawing.high, paper.room * unit, OVERLAP * unit)
    if found is None or (len(found.parts) > 1 and not several):
        return None
    return Sheets(paper=paper, scale=chosen, division=found, block=block, legend=key, beside=beside)


def _furnished(
    drawing: Drawing, name: str, wide: float, tall: float, scale: int, division: Division
) -> tuple[Paper, TitleBlock, Legend, bool]:
    paper = Paper(name=name, width=wide, height=tall, strip=0.0)
    block = title_block(drawing.title, _fields(drawing, paper, scale, 1, max(len(division.parts), 1)))
    left, _, right, _ = paper.frame
    beside = right - left - WIDTH >= BESIDE
    key = legend(drawing, right - left - WIDTH if beside else right - left, division)
    strip = max(block.height, key.height) if beside else block.height + key.height
    return Paper(name=name, width=wide, height=tall, strip=strip), block, key, beside


def _fields(drawing: Drawing, paper: Paper, scale: int, number: int, of: int) -> Sequence[Field]:
    say = drawing.language.text
    told = (
        Field(label=say("scale"), text=f"1 : {scale:,}".replace(",", " "), first=True),
        Field(label=say("paper"), text=say(paper.words)),
        Field(label=say("sheet"), text=say(f"{number} of {of}")),
    )
    return (*drawing.fields, *told)


def _misfit(drawing: Drawing, name: str, scale: int | None, ways: Sequence[bool], *, several: bool) -> InputError:
    size = drawing.size / 1000
    fits = [s.scale for way in ways if (s := _on(drawing, name, None, landscape=way, several=False)) is not None]
    larger = [n for n in PAPERS if n != name and any(
        _on(drawing, n, scale, landscape=way, several=False) is not None for way in (False, True)
    )]  # fmt: skip
    remedies = [message("drawing.fitting_scale", scale=min(fits))] if fits else []
    remedies += [message("drawing.fitting_paper", paper=larger[0])] if larger else []
    if scale and not several:
        remedies.append(message("drawing.joined_sheets"))
    return InputError(
        "drawing.does_not_fit", width_m=size[0], height_m=size[1], paper=name, scale=scale or 0,
        sheets=MOST_SHEETS if several else 0, details=remedies or [message("drawing.title_block")],
    )  # fmt: skip
