"""Settings that say which plane is meant, and its axes: of pictures to scale and of drawing sheets alike."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING

from raybundle.errors import InputError, NotSolvable, phrase
from raybundle.numerics.progress import Progress, silent
from raybundle.settings import Range, setting

if TYPE_CHECKING:
    from raybundle.adjustment.result import Adjustment
    from raybundle.io.formats import Export
    from raybundle.numerics.arrays import Array
    from raybundle.workflows.object_plane import Covariance, Plane, PlaneAsked

OF_PLANE = ("plane", "vertical", "horizontal", "up", "axis", "origin", "wall")


@dataclass(frozen=True, slots=True, kw_only=True)
class PlaneSettings:
    """A plane of the object and axes in it."""

    plane: tuple[str, ...] = setting(
        (), "Object points of the plane: three or more, or two with {vertical}.  [default: plane of most points]",
        metavar="A,B,C,...", joined=True,
    )  # fmt: skip
    vertical: bool = setting(
        False, "Use a plumb plane: through two points of {plane}, fitted to more of them, or through most points."
    )  # fmt: skip
    horizontal: bool = setting(
        False, "Use a level plane at the points' median height: floors, flat ground. If the result has a coordinate "
        "system, the picture is in its map.",
    )  # fmt: skip
    up: str = setting(
        "z", "Plumb direction. z: Z axis of the block. lines: its measured plumb lines. A,B: two points, B above A.",
        metavar="z|lines|A,B",
    )  # fmt: skip
    axis: tuple[str, str] | None = setting(
        None, "Two points of the plane's axis to the right, from A to B.  [default: level]", metavar="A B",
        limits=("text", "text"),
    )  # fmt: skip
    origin: str = setting(
        "", "Point with its foot at the origin of the plane.  [default: in the middle of the points]",
        metavar="POINT",
    )  # fmt: skip
    wall: int = setting(
        1, "Without {plane}: wall N by number of points. 1: the wall with most points.", metavar="N",
        limits=Range(low=1, high=20),
    )  # fmt: skip


def plane_asked(settings: PlaneSettings) -> PlaneAsked:
    """The plane that settings ask for; raises InputError for what does not go together."""
    from raybundle.workflows.object_plane import PlaneAsked

    s = settings
    return PlaneAsked(
        points=s.plane,
        vertical=s.vertical,
        horizontal=s.horizontal,
        up=s.up,
        axis=s.axis,
        origin=s.origin,
        wall=s.wall,
    )


def plane_in(
    source: Path, export: Export, settings: PlaneSettings, progress: Progress = silent,
    adjusted: Callable[[], Adjustment] | None = None,
) -> tuple[Plane, tuple[str, ...]]:  # fmt: skip
    """The plane of a result that settings ask for, in its map where that is meant, and remarks.

    source  the result folder: what its result.json states of the vertical, and its adjustment for the errors of points
    adjusted  gives the adjustment; None: the result's block is adjusted once more where that is needed
    """
    from raybundle.io.reading.trees import read_json
    from raybundle.workflows.object_plane import plane_of

    reason = source / "result.json"
    about = read_json(reason).value if reason.is_file() else {}
    asked = plane_asked(settings)
    plane = plane_of(
        export.block, asked, sigma=export.sigma, about=about if isinstance(about, dict) else {},
        covariance=_covariance(source, progress, adjusted) if about else lambda _: None,
    )  # fmt: skip
    plane, more = _in_its_map(plane, export, asked)
    return plane, (*plane.remarks, *more)


def _covariance(source: Path, progress: Progress, adjusted: Callable[[], Adjustment] | None) -> Covariance:
    """Joint covariances of points of a result: its block holds adjusted values, and is adjusted once more for them."""

    def covariance(names: Sequence[str]) -> Array | None:
        from raybundle.measuring.joint import Joint
        from raybundle.measuring.query import positions
        from raybundle.measuring.session import adjusted_again

        try:
            adjustment = adjusted_again(source, progress) if adjusted is None else adjusted()
            return Joint.of(adjustment).of_points(positions(adjustment.adjusted, names).tolist())
        except (NotSolvable, InputError):  # a point that took no part has no errors that are known
            return None

    return covariance


def _in_its_map(plane: Plane, export: Export, asked: PlaneAsked) -> tuple[Plane, tuple[str, ...]]:
    """A horizontal plane of a georeferenced block as level ground of its map, and remarks; any other as it is."""
    from raybundle.io.geo.parsed_names import plan_system
    from raybundle.io.geo.parsed_systems import system_name
    from raybundle.workflows.object_plane import in_map

    frame = export.frame
    if frame is None or not asked.horizontal:
        return plane, ()
    if asked.has_axes:
        return plane, (phrase("picture.axes_given"),)
    if plan_system(frame.crs) is None:
        return plane, (phrase("picture.local_plane", system=system_name(frame.crs)),)
    reason = phrase("picture.in_map", system=system_name(frame.crs))
    return in_map(plane, frame, 0.001 if export.block.length_unit == "mm" else 1.0), (reason, *frame.remarks)
