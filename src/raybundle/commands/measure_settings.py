"""Settings of the commands that measure by hand and ask results; nothing is loaded for them that computes."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Literal

from raybundle.settings import setting


@dataclass(frozen=True, slots=True, kw_only=True)
class QuerySettings:
    """Questions to a result."""

    coordinates: tuple[str, ...] = setting((), "Coordinates of each of these points.", metavar="POINT...")
    distance: tuple[tuple[str, str], ...] = setting(
        (), "Distance between two points; may be repeated.", metavar="A B", limits=("text", "text")
    )
    angle: tuple[tuple[str, str, str], ...] = setting(
        (), "Angle at B between A and C; may be repeated.", metavar="A B C", limits=("text", "text", "text")
    )
    area: tuple[str, ...] = setting((), "Area of the polygon through these points, in order.", metavar="A B C...")


@dataclass(frozen=True, slots=True, kw_only=True)
class DatumSettings:
    """A coordinate system by points."""

    origin: str = setting("", "Point with X = Y = Z = 0.", metavar="POINT")
    axis: str = setting("", "Point on the X axis: Y = Z = 0, X above 0.", metavar="POINT")
    plane: str = setting("", "Point in the XY plane: Z = 0, Y above 0.", metavar="POINT")


@dataclass(frozen=True, slots=True, kw_only=True)
class MarkAdjustSettings:
    """How a block with what was measured by hand is adjusted."""

    reject: Literal["none", "snooping"] = setting(
        "none", "snooping: image observations with significant blunders are left out, one at a time."
    )
    estimate: Literal["given", "auto"] = setting(
        "given", "given: the parameters that the block names; auto: chosen by significance and determinability."
    )
