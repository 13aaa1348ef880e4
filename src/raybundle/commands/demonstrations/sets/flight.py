"""A flight over a gravel pit with control and check points."""

from __future__ import annotations

from pathlib import Path

import numpy as np

from raybundle.commands.demonstrations.files import Taken, made_camera, write_photograph, write_rows
from raybundle.io.geo.coordinate_systems import local_frame
from raybundle.numerics.arrays import Array
from raybundle.numerics.progress import Progress
from raybundle.numerics.rotation import rotation_from_vector
from raybundle.planning.rendered.ground import gravel_pit
from raybundle.planning.rendered.rendering import View
from raybundle.planning.synthetic_networks import look_at

ABOUT = "photographs of a flight over a gravel pit, with control and check points in UTM"
SEED = 11
CRS = "EPSG:32633"
ORIGIN = (534_720.0, 5_338_160.0, 312.0)
"""Easting, northing, height above the ellipsoid of the middle of the pit; the place is made up, the map is not"""
HEIGHT_M = 42.0
CONTROL = {"G1": (-23, -17), "G2": (24, -18), "G3": (23, 18), "G4": (-24, 17), "G5": (-2, 1)}
CHECK = {"C1": (-12, -15), "C2": (14, -13), "C3": (15, 12), "C4": (-14, 11), "C5": (-20, -3), "C6": (3, 19)}
SURVEYED = (0.010, 0.010, 0.015)
"""Standard deviations of the surveyed points: RTK with a pole [m]"""
MARKED_PX = 0.3
RECEIVER = (1.5, 1.5, 3.0)
"""Standard deviations of the positions in the photographs [m]; one error is common to all of them"""


def views() -> list[View]:
    """Three lines along X, and one across them with the camera tilted."""
    camera = made_camera(
        "flyer", (1200, 900), 0.0073, c=8.62, x0=0.031, y0=-0.022, K1=-3.1e-4, K2=4.0e-6, P1=4e-6, P2=-3e-6
    )
    rng = np.random.default_rng(SEED)
    found: list[View] = []
    lines = [
        (x, y, 0.0, 0.0 if k % 2 == 0 else np.pi) for k, y in enumerate((-15, 0, 15)) for x in (-21, -10, 1, 12, 23)
    ]
    lines += [(0.0, y, 0.38, np.pi / 2) for y in (-27, -14, -1)]
    for k, (x, y, tilt, heading) in enumerate(lines):
        centre = np.array([x, y, HEIGHT_M]) + rng.normal(0, (0.6, 0.6, 0.8))
        along = np.array([np.cos(heading), np.sin(heading), 0.0])
        aim = centre + np.tan(tilt) * along - [0, 0, 1.0]
        turn = rotation_from_vector(rng.normal(0, np.radians(1.5), (1, 3)))[0]
        rotation = turn @ look_at(centre, aim, up=along)[0]
        found.append(View(name=f"PIT_{k + 1:04d}.jpg", camera=camera, centre=centre, rotation=rotation))
    return found


def make(folder: Path, progress: Progress) -> tuple[str, ...]:
    """As `demonstrations` states."""
    rng = np.random.default_rng((SEED, 1))
    frame = local_frame(CRS, ORIGIN)
    places = {**CONTROL, **CHECK}
    plan = np.array(list(places.values()), float)
    ground = gravel_pit().with_boards(plan)
    xyz = ground.points(plan)
    taken, common = views(), rng.normal(0, RECEIVER)
    for k, view in enumerate(taken):
        progress("photographs", k / len(taken))
        place = frame.wgs84_from_local((view.centre + common + rng.normal(0, 0.3, 3))[None])[0]
        when = f"2026:06:21 10:{15 + k // 12:02d}:{5 * (k % 12):02d}"
        pixels = ground.photograph(view, np.random.default_rng((SEED, 2, k)))
        data = Taken(model="Virtual flyer", focal_mm=8.6, when=when, place=(place[0], place[1], place[2]))
        write_photograph(folder / "photos" / view.name, pixels, view.camera, data)
    surveyed = frame.crs_from_local(xyz + rng.normal(0, SURVEYED, xyz.shape))
    marks = {name: _marks(taken, xyz[k], rng) for k, name in enumerate(places)}
    _write_control(folder / "gcp_list.txt", surveyed, marks, list(places))
    sigmas = [f"{s:g}" for s in SURVEYED]
    rows = [(n, *(f"{v:.3f}" for v in surveyed[k]), *sigmas, "check") for k, n in enumerate(places) if n in CHECK]
    write_rows(folder / "checks.csv", ("point", "X", "Y", "Z", "sX", "sY", "sZ", "role"), rows)
    seen = [(image, n, f"{x:.2f}", f"{y:.2f}") for n in CHECK for image, x, y in marks[n]]
    write_rows(folder / "checks-measurements.csv", ("image", "point", "x_px", "y_px"), seen)
    control = f"{len(CONTROL)} control points in {CRS}, surveyed to 10 mm in plan and 15 mm in height"
    return (
        f"photos: {len(taken)} photographs of 1200 x 900 px from {HEIGHT_M:g} m above the ground",
        f"gcp_list.txt: {control}, and their places in the photographs",
        f"checks.csv, checks-measurements.csv: {len(CHECK)} check points alike",
    )


def _marks(views: list[View], point: Array, rng: np.random.Generator) -> list[tuple[str, float, float]]:
    """Where a careful person marks a point, in the five photographs that show it best."""
    found: list[tuple[float, str, float, float]] = []
    for view in views:
        xy = view.pixels_of(point[None])
        if view.inside(xy, 40)[0]:
            x, y = xy[0] + rng.normal(0, MARKED_PX, 2)
            off = float(np.linalg.norm(xy[0] - [view.camera.width_px / 2, view.camera.height_px / 2]))
            found.append((off, view.name, float(x), float(y)))
    return [(name, x, y) for _, name, x, y in sorted(found)[:6]]


def _write_control(
    path: Path, surveyed: Array, marks: dict[str, list[tuple[str, float, float]]], names: list[str]
) -> None:
    """The list that OpenDroneMap reads."""
    lines = [CRS]
    for k, name in enumerate(names):
        if name in CONTROL:
            E, N, H = surveyed[k]
            lines += [f"{E:.3f} {N:.3f} {H:.3f} {x:.2f} {y:.2f} {image} {name}" for image, x, y in marks[name]]
    path.write_text("\n".join(lines) + "\n", encoding="utf-8")
