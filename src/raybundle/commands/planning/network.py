"""`raybundle plan network`: stations round an object that reach a wanted standard deviation."""

from __future__ import annotations

import json
from dataclasses import MISSING, dataclass, replace
from pathlib import Path
from typing import TYPE_CHECKING, Any, Literal

from raybundle.errors import InputError
from raybundle.numerics.progress import Progress, silent
from raybundle.settings import METRES, PIXELS, POSITIVE, Range, made, option, setting

if TYPE_CHECKING:
    from raybundle.block import Camera
    from raybundle.numerics.arrays import Array
    from raybundle.objects.surface import Surface
    from raybundle.planning.network_plan import NetworkPlan
    from raybundle.planning.site import Access, Site

SIGMA_PX = {"targets": 0.05, "dots": 0.1, "natural": 0.3, "hand": 0.5}
"""Standard deviations of image coordinates by what is measured, to plan with: coded targets of 10 px and more, small or
soft ones, tie points by least-squares matching (0.23 px at fountain-p11, benchmarks/results/orient.json), clicks"""
REACH = 3.0
"""Without other words one may go so many extents of the object away"""
STEP = 0.02
"""Extent below which an object is rather told in another unit [m]"""
FORMAT = Range(low=100, high=100_000)


@dataclass(frozen=True, slots=True, kw_only=True)
class NetworkSettings:
    """An object, a camera, where one may stand, and what is wanted."""

    object: str
    """KIND:NUMBERS, or a mesh"""
    out: Path = setting(MISSING, "New folder for the plan.", metavar="FOLDER")
    sigma: float | None = setting(
        None, "Wanted standard deviation of a coordinate [mm].", metavar="MM", limits=POSITIVE
    )
    photographs: int | None = setting(
        None, "So many stations; without it the fewest that reach {sigma}.", limits=Range(low=3, high=200)
    )
    aim: Literal["worst", "mean"] = setting("worst", "Whether {sigma} is that of the worst point or the mean.")
    camera: Path | None = setting(None, "A photograph of the camera, or its calibration.", metavar="PHOTO|CAMERA.toml")
    format: tuple[int, int] = setting(
        (6000, 4000), "Without {camera}: its format [px].", metavar="WIDTH HEIGHT", limits=(FORMAT, FORMAT)
    )
    c: float = setting(24.0, "Without {camera}: camera constant [mm].", limits=Range(low=0.1, high=1e4))
    pixel: float = setting(6.0, "Without {camera}: size of a pixel [um].", limits=Range(low=0.1, high=1000))
    hold_camera: bool = setting(False, "The camera is calibrated and held; else it is calibrated with the object.")
    f_number: float = setting(8.0, "Aperture, for the depth of field.", limits=Range(low=0.5, high=128))
    focus: float | None = setting(
        None, "Distance to which the lens is focused [m].  [default: so that most is sharp]", limits=METRES
    )
    measured: Literal["targets", "dots", "natural", "hand"] = setting(
        "targets", "What is measured; says how precisely where {noise} does not."
    )
    noise: float | None = setting(None, "Sigma of an image coordinate [px].", limits=PIXELS)
    points: int = setting(120, "Points on the object by which the network is judged.", limits=Range(low=8, high=1000))
    rays: int = setting(3, "Photographs that each of them must be in, at least.", limits=Range(low=2, high=20))
    incidence: float = setting(65.0, "Largest angle of a ray to the normal [deg].", limits=Range(low=5, high=89))
    heights: tuple[float, float] | None = setting(
        None, "Of the camera over the object's lowest point [m].  [default: half the object to its whole and half]",
        metavar="LOW HIGH", limits=(Range(low=-1e4, high=1e4), Range(low=-1e4, high=1e4)),
    )  # fmt: skip
    around: float | None = setting(None, "How far one may go from the object [m].", limits=METRES)
    clearance: float | None = setting(None, "How near one may go [m].  [default: by the focus]", limits=METRES)
    forbid: tuple[tuple[float, float, float, float, float, float], ...] = setting(
        (), "A box in which no station may be; may be given again.", metavar="X0 Y0 Z0 X1 Y1 Z1",
        limits=(Range(low=-1e7, high=1e7),) * 6,
    )  # fmt: skip
    unit: float = setting(1.0, "Metres of one unit of a mesh.", limits=Range(low=1e-9, high=1e6))
    effort: Literal["quick", "thorough"] = setting("thorough", "Seconds, or a minute for better stations.")


def plan_network(object: str, out: str | Path, *, progress: Progress = silent, **settings: Any) -> NetworkPlan:  # noqa: A002
    """Plan a network round an object and write it.

    object    "box:4,3,2.5", "cylinder:3,4", "facade:12,8", "corridor:60,8" [m], or a mesh file (PLY, OBJ, STL)
    out       new folder: block (a simulated block of the plan), stations.csv, points.csv, plan.json, network.html
    settings  as of the command line, by the names of `NetworkSettings`: sigma=0.1 [mm]
    raises    InputError where what is wanted is beyond reach, nobody can stand anywhere, or a file is no mesh
    """
    return run_plan_network(made(NetworkSettings, {"object": object, "out": Path(out), **settings}), progress)


def run_plan_network(settings: NetworkSettings, progress: Progress = silent) -> NetworkPlan:
    """Plan what the settings ask for, and write it."""
    from raybundle.io.folders import check_place  # noqa: PLC0415  (what computes is loaded after the help)
    from raybundle.planning import network_plan  # noqa: PLC0415

    if settings.sigma is None and settings.photographs is None:
        raise InputError(f"say what is wanted: {option('sigma', 'MM')}, or {option('photographs', 'N')}")
    check_place(settings.out, "folder")
    plan = network_plan.plan_network(
        site_of(settings), wanted=None if settings.sigma is None else settings.sigma / 1000,
        stations=settings.photographs, aim=settings.aim, least_rays=settings.rays, progress=progress,
        search=network_plan.QUICK if settings.effort == "quick" else None,
    )  # fmt: skip
    write_network_plan(plan, settings)
    return plan


def site_of(settings: NetworkSettings) -> Site:
    """The object, the camera and where one may stand."""
    from raybundle.objects.surface import spread  # noqa: PLC0415
    from raybundle.planning.optics import Optics  # noqa: PLC0415
    from raybundle.planning.site import Site  # noqa: PLC0415

    surface, side = surface_of(settings.object, settings.unit)
    camera = camera_of(settings)
    c_mm = camera.sensor.camera_constant(camera.parameters)
    extent = surface.extent
    fitting = extent * c_mm / float(camera.size_mm.min())  # distance at which the object fills the shorter side
    focus = settings.focus or max(fitting, 2 * c_mm / 1000)
    depth = Optics(f_number=settings.f_number, focus=focus).depth_of_field(c_mm, camera.pixel_mm[0])
    access = _access(settings, surface, side, depth, fitting)
    return Site(
        surface=surface, points=spread(surface, settings.points), camera=camera, access=access,
        sigma_px=settings.noise or SIGMA_PX[settings.measured], depth=depth, incidence_deg=settings.incidence,
    )  # fmt: skip


def surface_of(text: str, unit: float = 1.0) -> tuple[Surface, str]:
    """The surface of an object as it is told, and the side from which it is photographed: round, front or above."""
    from raybundle.io.meshes import SUFFIXES, read_mesh  # noqa: PLC0415
    from raybundle.objects.kinds import object_kinds  # noqa: PLC0415

    name, colon, numbers = text.partition(":")
    if colon and name in object_kinds:
        kind = object_kinds[name]
        try:
            values = [float(v) for v in numbers.replace("x", ",").split(",") if v.strip()]
        except ValueError:
            raise InputError(
                f"object {text}: {name} takes {kind.words}, with commas between: {_example(name)}"
            ) from None
        return kind.surface(values), kind.side
    path = Path(text)
    if path.suffix.lower() in SUFFIXES:
        surface = read_mesh(path, unit)
        if surface.extent < STEP:
            raise InputError(
                f"is {1000 * surface.extent:.3g} mm large if its unit is {unit:g} m; say which it is by "
                f"{option('unit', 0.001)} for millimetres, or make it larger than {1000 * STEP:g} mm", file=path,
            )  # fmt: skip
        return surface, "round"
    known = ", ".join(_example(k) for k in sorted(object_kinds))
    raise InputError(f"object {text}: neither a kind of object ({known}) nor a mesh ({', '.join(SUFFIXES)})")


def _example(name: str) -> str:
    from raybundle.objects.kinds import object_kinds  # noqa: PLC0415

    return f"{name}:" + ",".join(f"{v:g}" for v in object_kinds[name].example)


def camera_of(settings: NetworkSettings) -> Camera:
    """The camera: as calibrated, as a photograph states it, or by its numbers."""
    from raybundle.planning.scenes import brown_camera  # noqa: PLC0415

    free = () if settings.hold_camera else ("c", "x0", "y0", "K1", "K2", "K3", "P1", "P2")
    if settings.camera is None:
        pixel = settings.pixel / 1000
        zero = dict.fromkeys(("x0", "y0", "K1", "K2", "K3", "P1", "P2"), 0.0)
        return brown_camera(values={**zero, "c": settings.c}, size_px=settings.format, pixel_mm=pixel, estimate=free)
    if settings.camera.suffix == ".toml":
        from raybundle.io.block.toml import read_cameras  # noqa: PLC0415

        camera = read_cameras(settings.camera)[0]
        known = tuple(s for s in free if s in camera.sensor.symbols)
        return replace(camera, id="1", estimate=known, sigma={}, relations=())
    from raybundle.io.photos.cameras import camera_groups  # noqa: PLC0415
    from raybundle.io.photos.photo import read_photo  # noqa: PLC0415

    (group,) = camera_groups([read_photo(settings.camera)])
    zero = dict.fromkeys(("x0", "y0", "K1", "K2", "K3", "P1", "P2"), 0.0)
    camera = brown_camera(values={**zero, "c": group.c_mm}, size_px=(group.width_px, group.height_px), estimate=free)
    return replace(camera, pixel_mm=group.pixel_mm)


def _access(
    settings: NetworkSettings, surface: Surface, side: str, depth: tuple[float, float], fitting: float
) -> Access:
    """Where one may stand: a box about the object, without what is forbidden."""
    import numpy as np  # noqa: PLC0415

    from raybundle.planning.site import Access  # noqa: PLC0415

    low, high = (b.astype(float) for b in surface.wanted_bounds)
    extent, tall = surface.extent, float(high[2] - low[2])
    around = settings.around or min(REACH * max(extent, 0.5 * fitting), depth[1])
    heights = settings.heights or (0.5 * tall if side == "round" else 0.0, 1.5 * tall)
    if side == "above":
        heights = settings.heights or (0.3 * fitting, 1.5 * fitting)
    if heights[1] < heights[0]:
        raise InputError(
            f"{option('heights')}: {heights[0]:g} to {heights[1]:g} m leaves nothing; give the lower first"
        )
    box_low = np.array([low[0] - around, low[1] - around, low[2] + heights[0]])
    box_high = np.array([high[0] + around, high[1] + around, low[2] + heights[1]])
    clearance = settings.clearance or max(depth[0], 0.05 * extent)
    if side == "front":
        box_high[1] = low[1] - clearance
    if clearance >= around:
        raise InputError(
            f"nothing is sharp nearer than {clearance:.3g} m and one may go {around:.3g} m away: a larger f-number "
            f"({option('f_number')}), another focus ({option('focus')}) or more room ({option('around')}) is needed"
        )
    boxes: Array = np.array(settings.forbid, float).reshape(-1, 2, 3)
    return Access(low=box_low, high=box_high, clearance=clearance, forbidden=np.sort(boxes, axis=1))


def write_network_plan(plan: NetworkPlan, settings: NetworkSettings) -> None:
    """Write FOLDER/block, stations.csv, points.csv, plan.json and network.html, whole or not at all."""
    import numpy as np  # noqa: PLC0415

    from raybundle.adjustment.engine import adjust_block  # noqa: PLC0415
    from raybundle.adjustment.options import AdjustmentOptions  # noqa: PLC0415
    from raybundle.io.block.folder import write_block_files  # noqa: PLC0415
    from raybundle.io.folders import new_folder  # noqa: PLC0415
    from raybundle.io.tables import write_table  # noqa: PLC0415
    from raybundle.planning.planned_block import planned_block  # noqa: PLC0415
    from raybundle.report.network_page import Planned, write_network_page  # noqa: PLC0415
    from raybundle.results.contents import clean  # noqa: PLC0415

    s, e = plan.design.stations, plan.expected
    block = planned_block(plan.site, s, name=f"plan of {settings.object}")
    names = block.points.ids
    exact = planned_block(plan.site, s, name=block.name, seed=None)
    result = adjust_block(exact, AdjustmentOptions(datum="inner", datum_points=names, threads=1))
    std = np.sqrt(np.diagonal(e.points, axis1=1, axis2=2))
    away = s.at - s.centre
    with new_folder(settings.out) as folder:
        (folder / "block").mkdir()
        write_block_files(block, folder / "block")
        write_table(
            folder / "stations.csv",
            {
                "image": block.images.ids, "X": s.centre[:, 0], "Y": s.centre[:, 1], "Z": s.centre[:, 2],
                "at_X": s.at[:, 0], "at_Y": s.at[:, 1], "at_Z": s.at[:, 2],
                "azimuth_deg": np.degrees(np.arctan2(away[:, 0], away[:, 1])) % 360,
                "elevation_deg": np.degrees(np.arctan2(away[:, 2], np.hypot(away[:, 0], away[:, 1]))),
                "roll_deg": np.degrees(np.arctan2(np.sin(s.roll), np.cos(s.roll))),
                "points": np.bincount(block.observations.image, minlength=len(s)).astype(float),
                "what_for": [purpose_words(plan, k) for k in range(len(s))],
            },
        )  # fmt: skip
        write_table(
            folder / "points.csv",
            {
                "point": names, **{a: plan.site.points.xyz[:, k] for k, a in enumerate("XYZ")},
                **{f"s{a}_mm": 1000 * std[:, k] for k, a in enumerate("XYZ")}, "rays": e.rays.astype(float),
            },
        )  # fmt: skip
        (folder / "plan.json").write_text(json.dumps(clean(told(plan)), indent=1) + "\n", encoding="utf-8")
        planned = Planned(
            corners=plan.corners, sigma=plan.map_sigma, covariance=e.points,
            image_words=tuple(purpose_words(plan, k) for k in range(len(s))),
            remarks=(
                (
                    f"Standard deviations that the plan promises, with {plan.site.sigma_px:g} px of image points, "
                    "relative to all points together. A scale bar or control gives the scale, and its own error."
                ),
                "Grey parts of the object are shown by less than two photographs.",
            ),
        )  # fmt: skip
        write_network_page(result, folder / "network.html", planned)


def told(plan: NetworkPlan) -> dict[str, Any]:
    """The figures of a plan, metres and degrees."""
    import numpy as np  # noqa: PLC0415

    e, seen = plan.expected, np.isfinite(plan.map_sigma)
    free = plan.site.free
    return {
        "photographs": len(plan.design.stations),
        "aim": plan.aim,
        "wanted_m": plan.wanted,
        "reached_m": plan.design.figure,
        "worst_m": float(e.sigma.max()),
        "mean_m": float(np.sqrt(np.mean(e.sigma**2))),
        "object": {
            "area_m2": plan.site.surface.wanted_area,
            "seen_twice": float(seen.mean()),
            "largest_m": float(np.nanmax(plan.map_sigma)),
            "median_m": float(np.nanmedian(plan.map_sigma)),
        },
        "interior_mm": {s: float(v) for s, v in zip(free, np.sqrt(np.diag(e.interior)), strict=True)},
        "image_sigma_px": plan.site.sigma_px,
        "image_scale_number": plan.scale_number,
        "rays_mean": float(e.rays.mean()),
        "q": plan.q,
        "depth_of_field_m": [d if np.isfinite(d) else None for d in plan.site.depth],
        "minutes": plan.cost.minutes,
        "path_m": plan.cost.path_m,
        "tried": [{"photographs": n, "reached_m": f if np.isfinite(f) else None} for n, f in plan.tried],
    }


def purpose_words(plan: NetworkPlan, k: int) -> str:
    """What a station is there for, in words."""
    import numpy as np  # noqa: PLC0415

    p = plan.purposes[k]
    where = plan.site.points
    if len(p.unseen):
        return f"{len(p.unseen)} points {side_words(where.normal[p.unseen].mean(axis=0))} would be seen once without it"
    if not np.isfinite(p.ratio):
        return "without it the network is not determined"
    said = list[str]()
    if p.ratio > 1.02:
        said.append(f"{plan.aim} sigma {100 * (p.ratio - 1):.0f} % larger without it")
    said.append(f"{side_words(where.normal[p.worst])} up to {100 * (p.worst_ratio - 1):.0f} %")
    if p.parameters and p.parameters[0][1] > 1.05:
        said.append(", ".join(f"{s} {100 * (r - 1):.0f} %" for s, r in p.parameters[:2]))
    return "; ".join(said)


def side_words(normal: Array) -> str:
    """The side of an object that has this normal: the front is that towards -Y."""
    x, y, z = (float(v) for v in normal)
    if abs(z) > max(abs(x), abs(y)):
        return "on top" if z > 0 else "below"
    if abs(y) >= abs(x):
        return "in front (towards -Y)" if y < 0 else "behind (towards +Y)"
    return "on the right (towards +X)" if x > 0 else "on the left (towards -X)"
