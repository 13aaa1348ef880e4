"""Settings of the commands that measure by hand and ask results; nothing is loaded for them that computes."""

from __future__ import annotations

from dataclasses import dataclass

from raybundle.settings import NOT_NEGATIVE, setting


@dataclass(frozen=True, slots=True, kw_only=True)
class QuerySettings:
    """Questions to a result."""

    coordinates: tuple[str, ...] = setting((), "Coordinates of each of these points.", metavar="POINT...", joined=True)
    distance: tuple[tuple[str, str], ...] = setting(
        (), "Distance between two points. May be repeated.", metavar="A B", limits=("text", "text")
    )
    angle: tuple[tuple[str, str, str], ...] = setting(
        (), "Angle at B between A and C. May be repeated.", metavar="A B C", limits=("text", "text", "text")
    )
    area: tuple[str, ...] = setting(
        (), "Area of the polygon through these points, in order.", metavar="A B C...", joined=True
    )
    length: tuple[str, ...] = setting(
        (), "Length of the line from point to point, in order.", metavar="A B C...", joined=True
    )
    plane: tuple[str, ...] = setting(
        (),
        "Flatness of four or more points: range of their deviations from the best plane, and each deviation.",
        metavar="A B C D...",
        joined=True,
    )
    line: tuple[str, ...] = setting(
        (),
        "Largest distance of three or more points from their best line, and each distance.",
        metavar="A B C...",
        joined=True,
    )
    to_plane: tuple[str, ...] = setting(
        (), "Distance of the first point from the best plane through the others.", metavar="P A B C...", joined=True
    )
    to_line: tuple[str, ...] = setting(
        (), "Distance of the first point from the best line through the others.", metavar="P A B...", joined=True
    )  # fmt: skip


@dataclass(frozen=True, slots=True, kw_only=True)
class DatumSettings:
    """A coordinate system by points."""

    origin: str = setting("", "Point with X = Y = Z = 0.", metavar="POINT")
    axis: str = setting(
        "", "Point on the X axis: Y = Z = 0, X above 0; with a level: Y = 0, X above 0.", metavar="POINT"
    )
    plane: str = setting("", "Point in the XY plane: Z = 0, Y above 0.", metavar="POINT")
    level: tuple[str, ...] = setting(
        (), "Point at the same height as the others given here, e.g. on water or a floor. Three or more points give "
        "the XY plane instead of a plane point. Repeat it, or separate points by commas.", metavar="POINT", joined=True,
    )  # fmt: skip


@dataclass(frozen=True, slots=True, kw_only=True)
class RejectSettings:
    """Which image observations are left out together, by what the last adjustment states of them; one of these."""

    w: float | None = setting(
        None, "Reject observations with larger |w|, the normalised residual.", metavar="LIMIT", limits=NOT_NEGATIVE
    )
    sigma: float | None = setting(
        None, "Reject tie points with a larger standard deviation of X, Y or Z. In the length unit of the block.",
        metavar="LIMIT", limits=NOT_NEGATIVE,
    )  # fmt: skip
    rays: float | None = setting(
        None, "Reject tie points with fewer active rays.", metavar="LIMIT", limits=NOT_NEGATIVE
    )
    redundancy: float | None = setting(
        None,
        "Reject observations with a smaller redundancy number (the smaller of x and y).",
        metavar="LIMIT",
        limits=NOT_NEGATIVE,
    )
