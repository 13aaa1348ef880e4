"""Lines and areas drawn on an orthophoto or on heights: they are in the coordinates of its surface."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import PurePosixPath
from typing import ClassVar

import numpy as np

from raybundle.errors import InputError
from raybundle.io.reading.words import quoted
from raybundle.measuring.actions.base import Action
from raybundle.measuring.actions.checks import FARTHEST, check_name, check_number
from raybundle.measuring.names import Known
from raybundle.measuring.state import Draft, Drawing, DrawingKind, State
from raybundle.objects.rings import ring_of

MOST_CORNERS = 5000


@dataclass(frozen=True, slots=True, kw_only=True)
class Draw(Action):
    """A line or an area with its layer and a note; one of that name is replaced."""

    verb: ClassVar[str] = "draw"
    drawing: str
    kind: DrawingKind
    corners: tuple[tuple[float, float], ...]
    """in the coordinates of the surface"""
    layer: str = "lines"
    note: str = ""
    surface: str = "surface"
    """its folder, within the project"""

    def settled(self, state: State, known: Known) -> Action:
        del state, known
        check_name("drawing", self.drawing)
        check_name("layer", self.layer)
        if self.note:
            check_name("note", self.note)
        least, n = 3 if self.kind == "area" else 2, len(self.corners)
        if not least <= n <= MOST_CORNERS:
            raise InputError("mark.drawing_corners", drawing=self.drawing, n=n, least=least, most=MOST_CORNERS)
        for k, place in enumerate(self.corners):
            for axis, value in zip("XY", place, strict=True):
                check_number(f"{self.drawing}, corners[{k}].{axis}", value, most=FARTHEST)
        if self.kind == "area":
            ring_of(np.array(self.corners, float), self.drawing)
        folder = PurePosixPath(self.surface)
        if folder.is_absolute() or ".." in folder.parts or not self.surface.isprintable():
            raise InputError("mark.drawing_surface", drawing=self.drawing, surface=quoted(self.surface))
        return self

    def apply(self, draft: Draft) -> None:
        draft.drawings[self.drawing] = Drawing(
            kind=self.kind, corners=tuple(self.corners), layer=self.layer, note=self.note, surface=self.surface
        )


@dataclass(frozen=True, slots=True, kw_only=True)
class Erase(Action):
    """Take a drawn line or area away."""

    verb: ClassVar[str] = "erase"
    drawing: str

    def settled(self, state: State, known: Known) -> Action:
        del known
        if self.drawing not in state.drawings:
            there = list(state.drawings)
            raise InputError("mark.no_drawing", drawing=quoted(self.drawing), known=there, n=len(there))
        return self

    def apply(self, draft: Draft) -> None:
        draft.drawings.pop(self.drawing, None)
