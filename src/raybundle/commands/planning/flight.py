"""`raybundle plan flight`: what a flight will determine, and what would mend it."""

from __future__ import annotations

from dataclasses import dataclass, replace
from pathlib import Path
from typing import TYPE_CHECKING

from raybundle.errors import InputError
from raybundle.missions.defaults import OVERLAP
from raybundle.numerics.progress import Progress, silent
from raybundle.settings import METRES, PIXELS, Range, setting

if TYPE_CHECKING:
    from raybundle.planning.flights.aerial import ControlTable
    from raybundle.planning.flights.flight import FlightPlan
    from raybundle.planning.flights.uav_networks import Flight

MOST = 1000
"""Photographs of a forecast, without those that changes of the plan add"""
LINES, PHOTOS, HEIGHT = 4, 8, 80.0
"""Of a flight of which neither these nor area and pixel are given"""
FORMAT, SHARE = Range(low=100, high=100_000), Range(low=0, high=0.95)


@dataclass(frozen=True, slots=True, kw_only=True)
class FlightSettings:
    """A flight over level ground or hills as it is planned: by area or lines, overlap, format and camera constant."""

    area: tuple[float, float] | None = setting(
        None, "Area to photograph, across and along the lines [m]. Instead of {lines}, {photographs_per_line} and "
        "{ground}.",
        metavar="WIDTH LENGTH", limits=(METRES, METRES),
    )  # fmt: skip
    lines: int | None = setting(
        None, "Number of flight lines.  [default: 4, or by {area}]", limits=Range(low=1, high=40)
    )
    photographs_per_line: int | None = setting(
        None, "Number of photographs per line.  [default: 8, or by {area}]", limits=Range(low=2, high=80)
    )
    gsd: float | None = setting(None, "Ground sampling distance [m], instead of {height}.", limits=METRES)
    height: float | None = setting(None, "Height above ground [m].  [default: 80, or by {gsd}]", limits=METRES)
    relief: float = setting(0.0, "Height range of the ground, in per cent of {height}.", limits=Range(low=0, high=60))
    base: float | None = setting(
        None, "Distance between photographs of a line [m].  [default: by {overlap}]", limits=METRES
    )
    line_spacing: float | None = setting(None, "Distance between lines [m].  [default: by {overlap}]", limits=METRES)
    overlap: tuple[float, float] = setting(
        OVERLAP, "Overlap along a line and between lines.", metavar="ALONG ACROSS", limits=(SHARE, SHARE)
    )
    camera: str = setting(
        "5472x3648,3650", "Photograph of the camera, its calibration (TOML), the name of a known camera, or its "
        "format and camera constant in px.", metavar="PHOTO|FILE|NAME|WxH,C",
    )  # fmt: skip
    hold_camera: bool = setting(False, "Fix the calibrated camera. Without it, the camera is calibrated in flight.")
    rtk: tuple[float, float, float] = setting(
        (0.02, 0.02, 0.03), "Standard deviations of the positions [m].", metavar="E N U",
        limits=(METRES, METRES, METRES),
    )  # fmt: skip
    no_rtk: bool = setting(False, "Assume positions of 5, 5, 10 m (no RTK), instead of {rtk}.")
    free_lever_arm: bool = setting(
        False, "Estimate the lever arm of the antenna. Without it, projection centres are observed."
    )
    alternate: bool = setting(False, "Fly every second line in the opposite direction.")
    cross: float | None = setting(
        None,
        "Add as many cross lines, with the camera tilted by this angle [deg].",
        metavar="TILT",
        limits=Range(low=0, high=60),
    )
    cross_height: float | None = setting(
        None, "Height of the cross lines above ground [m].  [default: {height}]", limits=METRES
    )
    read_out: float = setting(
        0.0, "Read-out time of a rolling shutter, estimated [ms]; 0: none.", limits=Range(low=0, high=1000)
    )
    speed: float = setting(10.0, "Speed on the lines, for {read_out} [m/s].", limits=Range(low=0, high=100, above=True))
    control_points: int = setting(0, "Number of control points: 1 to 5, 9 or 13.", limits=Range(low=0, high=13))
    control_sigma: tuple[float, float] = setting(
        (0.01, 0.02), "Standard deviations of control points [m].", metavar="PLAN HEIGHT", limits=(METRES, METRES)
    )
    jitter: tuple[float, float] = setting(
        (0.5, 1.5), "Unevenness of the flight: standard deviations [m], [deg].", metavar="HEIGHT ANGLE",
        limits=(Range(low=0, high=1e6), Range(low=0, high=180)),
    )  # fmt: skip
    image_sigma: float = setting(0.3, "Sigma of an image coordinate [px].", limits=PIXELS)
    ground: float | None = setting(
        None,
        "Side of a square of tie points [m].  [default: by {area}, or {lines} and {photographs_per_line}]",
        limits=METRES,
    )
    tie_points: int | None = setting(
        None, "Tie points along the longer side.  [default: 30, or enough for every photograph]",
        limits=Range(low=4, high=200),
    )  # fmt: skip
    control_table: bool = setting(False, "Print the effect of control: by number, standard deviation and place.")
    out: Path | None = setting(None, "New folder for the simulated block of the plan.", metavar="FOLDER")

    def flight(self) -> Flight:
        """The flight with its camera, height, lines and photographs.

        raises  InputError for settings that contradict each other, and for more photographs than are forecast
        """
        from raybundle.io.missions.cameras import mission_camera
        from raybundle.planning.flights.aerial import NO_RTK
        from raybundle.planning.flights.flight import points_of
        from raybundle.planning.flights.uav_networks import FREE, Flight, uav_camera

        self._checked()
        given = mission_camera(self.camera)
        width, height, c = given.width_px, given.height_px, given.c_px
        usual = uav_camera()
        camera = replace(
            usual, width_px=width, height_px=height, values={**usual.values, "c": c * usual.pixel_mm[0]},
            estimate=() if self.hold_camera else FREE,
        )  # fmt: skip
        above = (self.height or HEIGHT) if self.gsd is None else self.gsd * c
        along, across = above * height / c, above * width / c
        base = self.base or (1 - self.overlap[0]) * along
        spacing = self.line_spacing or (1 - self.overlap[1]) * across
        lines, photos = self._numbers(base, spacing)
        covered = ((photos - 1) * base * max((lines - 1) * spacing, across / 2)) ** 0.5
        size, length = (self.ground or covered, None) if self.area is None else self.area
        made = Flight(
            camera=camera, height=above, lines=lines, photographs=photos, spacing=spacing, base=base,
            size=size, length=length, alternating=self.alternate, cross_tilt_deg=self.cross,
            height_jitter=self.jitter[0], angle_jitter_deg=self.jitter[1], image_sigma_px=self.image_sigma,
            station_sigma=NO_RTK if self.no_rtk else self.rtk, control=self.control_points,
            relief=self.relief / 100, lever_arm=self.free_lever_arm, cross_height=self.cross_height,
            read_out_s=self.read_out / 1000, speed=self.speed,
            control_sigma=(self.control_sigma[0], *self.control_sigma),
        )  # fmt: skip
        return replace(made, points=self.tie_points or max(made.points, points_of(made)))

    def _checked(self) -> None:
        """Refuse two settings that say the same."""
        for given, others in (("area", ("lines", "photographs_per_line", "ground")), ("gsd", ("height",))):
            twice = [other for other in others if getattr(self, other) is not None]
            if getattr(self, given) is not None and twice:
                raise InputError("option.exclusive", first=given, second=twice[0])

    def _numbers(self, base: float, spacing: float) -> tuple[int, int]:
        """Lines, and photographs of each: over an area as `plan mission` lays them, half a spacing beyond its edges."""
        from raybundle.planning.flights.uav_networks import covering

        if self.area is None:
            lines, photos = self.lines or LINES, self.photographs_per_line or PHOTOS
        else:
            lines, photos = covering(self.area, spacing, base)
        if lines * photos > MOST:
            wide, long = self.area or (0.0, 0.0)
            raise InputError(
                "plan.flight_too_large", total=lines * photos, most=MOST, lines=lines, photographs=photos,
                area=self.area is not None, width_m=wide, length_m=long, base_m=base, spacing_m=spacing,
            )  # fmt: skip
        return lines, photos


def run_plan_flight(
    settings: FlightSettings, progress: Progress = silent
) -> tuple[Flight, FlightPlan, ControlTable | None]:
    """The flight, its forecast, what control brings, and the simulated block as a folder, where they are asked for."""
    from raybundle.io.block.folder import write_block
    from raybundle.io.folders import check_new_folder
    from raybundle.planning.flights.flight import flight_control, plan_flight
    from raybundle.planning.flights.uav_networks import flight_block

    out = settings.out
    if out is not None:
        check_new_folder(out)
    plan = settings.flight()
    done = plan_flight(plan, progress)
    table = flight_control(plan) if settings.control_table else None
    if out is not None:
        write_block(flight_block(plan), out)
    return plan, done, table
