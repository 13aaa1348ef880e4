"""`raybundle plan network`: stations round an object that reach a wanted standard deviation."""

from __future__ import annotations

from dataclasses import MISSING, dataclass, replace
from pathlib import Path
from typing import TYPE_CHECKING, Any, Literal

from raybundle.errors import InputError, phrase
from raybundle.numerics.progress import Progress, silent
from raybundle.settings import METRES, PIXELS, POSITIVE, Range, keywords, made, setting

if TYPE_CHECKING:
    from raybundle.block import Camera
    from raybundle.numerics.arrays import Array, Mask
    from raybundle.objects.surface import Surface
    from raybundle.planning.network.candidates import Stations
    from raybundle.planning.network.network_plan import NetworkPlan
    from raybundle.planning.network.site import Access, Site

REACH = 3.0
"""Without other words one may go so many extents of the object away"""
FORMAT = Range(low=100, high=100_000)
MeasuredName = Literal["retro", "targets", "dots", "natural", "phone", "hand"]


@dataclass(frozen=True, slots=True, kw_only=True)
class PlannedCamera:
    """An object and the camera that is to photograph it."""

    object: str
    """A kind with its size or line, a mesh, a raster or a result"""
    camera: Path | None = setting(
        None,
        "Photograph of the camera, its calibration, a block or a result.  [default: camera of OBJECT, if it is a "
        "block or result]",
        metavar="PHOTO|TOML|FOLDER",
    )
    format: tuple[int, int] = setting(
        (6000, 4000), "Format of the camera [px], without {camera}.", metavar="WIDTH HEIGHT", limits=(FORMAT, FORMAT)
    )
    c: float = setting(24.0, "Camera constant [mm], without {camera}.", limits=Range(low=0.1, high=1e4))
    pixel_mm: float = setting(0.006, "Pixel size, without {camera}.", metavar="MM", limits=Range(low=1e-4, high=1))
    hold_camera: bool = setting(
        False, "Fix the calibrated camera. Without it, the camera is calibrated with the object."
    )
    f_number: float = setting(8.0, "Aperture, for the depth of field.", limits=Range(low=0.5, high=128))
    image_sigma: float | None = setting(None, "Sigma of an image coordinate [px].", limits=PIXELS)
    unit: float = setting(1.0, "Metres per unit of a mesh.", limits=Range(low=1e-9, high=1e6))


@dataclass(frozen=True, slots=True, kw_only=True)
class NetworkSettings(PlannedCamera):
    """An object, a camera, where one may stand, and what is wanted."""

    out: Path = setting(MISSING, "New folder for the plan.", metavar="FOLDER")
    sigma: float | None = setting(
        None, "Required standard deviation of a coordinate [mm].", metavar="MM", limits=POSITIVE
    )
    photographs: int | None = setting(
        None, "Number of stations. Without it, the fewest that reach {sigma}.", limits=Range(low=3, high=200)
    )
    aim: Literal["worst", "mean", "calibration", "reliability"] = setting(
        "worst", "Quantity to minimise. worst: {sigma} of the worst point. mean: mean of all points. calibration: "
        "uncertainty of the calibration. reliability: weak mutual checks of image points."
    )  # fmt: skip
    focus: float | None = setting(
        None, "Focus distance of the lens [m].  [default: for the sharpest image of the object]", limits=METRES
    )
    measured: MeasuredName = setting(
        "targets", "Kind of image points. It sets the precision if {image_sigma} is missing."
    )
    object_points: int = setting(120, "Number of object points to assess the network.", limits=Range(low=8, high=1000))
    rays: int = setting(3, "Smallest number of photographs of each object point.", limits=Range(low=2, high=20))
    incidence: float = setting(65.0, "Largest angle of a ray to the normal [deg].", limits=Range(low=5, high=89))
    heights: tuple[float, float] | None = setting(
        None, "Camera heights above the object's lowest point [m].  [default: from half to one and a half times the "
        "object's height]",
        metavar="LOW HIGH", limits=(Range(low=-1e4, high=1e4), Range(low=-1e4, high=1e4)),
    )  # fmt: skip
    around: float | None = setting(None, "Largest distance of a station from the object [m].", limits=METRES)
    clearance: float | None = setting(
        None, "Smallest distance of a station from the object [m].  [default: by the focus]", limits=METRES
    )
    forbid: tuple[tuple[float, float, float, float, float, float], ...] = setting(
        (), "Box without stations. May be repeated.", metavar="X0 Y0 Z0 X1 Y1 Z1",
        limits=(Range(low=-1e7, high=1e7),) * 6,
    )  # fmt: skip
    crs: str = setting("", "Coordinate system of a raster or outline that is not in metres.", metavar="EPSG:CODE")
    everywhere: bool = setting(
        False,
        "Add stations until {sigma} is reached on all of the visible surface. Without it, at the object points only.",
    )
    repeat: int = setting(
        0, "Take so many more photographs from existing stations, at the most useful ones.",
        limits=Range(low=0, high=50),
    )  # fmt: skip
    stations: Path | None = setting(
        None,
        "Assess these stations instead of a search: stations.csv of a plan, a block or a result.",
        metavar="FILE|FOLDER",
    )
    scale_bars: int = setting(0, "Number of scale bars on the object.", limits=Range(low=0, high=20))
    scale_bar_sigma: float = setting(5e-5, "Standard deviation of scale bar lengths [m].", limits=METRES)
    scale_bar_length: float | None = setting(
        None, "Length of the scale bars [m].  [default: the largest that fits]", limits=METRES
    )
    control_points: int = setting(0, "Number of control points on the object.", limits=Range(low=0, high=200))
    control_sigma: tuple[float, float] = setting(
        (0.002, 0.002), "Standard deviations of the control points [m].", metavar="PLAN HEIGHT", limits=(METRES, METRES)
    )
    effort: Literal["quick", "thorough"] = setting(
        "thorough",
        "Effort of the search. quick: seconds, a minute for large networks. thorough: better stations, in minutes.",
    )


@keywords(NetworkSettings)
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
    from raybundle.commands.planning.network_files import write_network_plan
    from raybundle.io.folders import check_new_folder
    from raybundle.planning.network import network_plan
    from raybundle.planning.network.datum_of_plan import Wanted

    if settings.sigma is None and settings.photographs is None and settings.stations is None:
        raise InputError("plan.no_goal")
    if settings.everywhere and settings.sigma is None:
        raise InputError("option.needs", setting="everywhere", other="sigma")
    check_new_folder(settings.out)
    plan = network_plan.plan_network(
        site_of(settings, taken=settings.stations is not None),
        wanted=None if settings.sigma is None else settings.sigma / 1000,
        stations=settings.photographs, aim=settings.aim, least_rays=settings.rays, progress=progress,
        search=network_plan.QUICK if settings.effort == "quick" else None,
        start=None if settings.stations is None else stations_of(settings.stations),
        as_given=settings.stations is not None, everywhere=settings.everywhere, repeat=settings.repeat,
        known=Wanted(
            control=settings.control_points, control_sigma=(settings.control_sigma[0], *settings.control_sigma),
            bars=settings.scale_bars, bar_sigma=settings.scale_bar_sigma, bar_length=settings.scale_bar_length,
        ),
    )  # fmt: skip
    write_network_plan(plan, phrase("network_plan.title", name=title_of(settings.object)), settings.out)
    return plan


def title_of(text: str) -> str:
    """What an object is called: a file or folder by its name, a kind as it is reported."""
    return Path(text).resolve().name if Path(text).exists() else text


def site_of(settings: NetworkSettings, *, taken: bool = False) -> Site:
    """The object, the camera and where one may stand.

    taken  stations are given: without a focus that is reported their photographs are sharp everywhere
    """
    from raybundle.commands.planning.objects import surface_of
    from raybundle.objects.surface import spread
    from raybundle.planning.measured import measured_kinds
    from raybundle.planning.network.optics import Optics
    from raybundle.planning.network.site import Site

    surface, side = surface_of(settings.object, settings.unit, settings.crs)
    camera = camera_of(settings)
    c_mm = camera.sensor.camera_constant(camera.parameters)
    extent = surface.extent
    fitting = extent * c_mm / float(camera.size_mm.min())  # distance at which the object fills the shorter side
    focus = settings.focus or max(fitting, 2 * c_mm / 1000)
    depth = Optics(f_number=settings.f_number, focus=focus).depth_of_field(c_mm, camera.pixel_mm[0])
    if taken and settings.focus is None:
        depth = (0.0, float("inf"))
    access = _access(settings, surface, side, depth, fitting)
    kind = measured_kinds[settings.measured]
    return Site(
        surface=surface, points=spread(surface, settings.object_points), camera=camera, access=access,
        sigma_px=settings.image_sigma or kind.sigma_px, depth=depth, incidence_deg=settings.incidence,
        found=kind.found if kind.half_deg < 90 else None,
    )  # fmt: skip


def stations_of(path: Path) -> Stations:
    """The stations of a plan's table, of a block or of a result."""
    import numpy as np

    from raybundle.commands.planning.objects import block_in
    from raybundle.io.tables import Column, read_table
    from raybundle.planning.network.candidates import Stations
    from raybundle.planning.network.of_result import stations_of_result

    if path.is_dir():
        return stations_of_result(block_in(path))
    names = ("X", "Y", "Z", "at_X", "at_Y", "at_Z", "roll_deg")
    others = ("azimuth_deg", "elevation_deg", "points")
    columns = [Column(name="image", kind="id"), *(Column(name=n, kind="number") for n in names)]
    columns += [Column(name=n, kind="number", optional=True, empty=True) for n in others]
    table = read_table(path, [*columns, Column(name="what_for", kind="text", optional=True, empty=True)])
    values = table.numbers(*names)
    if np.linalg.norm(values[:, :3] - values[:, 3:6], axis=1).min() < 1e-9:
        raise InputError("plan.station_at_itself", file=path)
    return Stations(centre=values[:, :3], at=values[:, 3:6], roll=np.radians(values[:, 6]))


def camera_of(settings: NetworkSettings) -> Camera:
    """The camera: as calibrated, as a photograph states it, or by its numbers."""
    from raybundle.planning.synthetic_networks import brown_camera

    free = () if settings.hold_camera else ("c", "x0", "y0", "K1", "K2", "K3", "P1", "P2")
    if settings.camera is None and Path(settings.object).is_dir():
        settings = replace(settings, camera=Path(settings.object))
    if settings.camera is None:
        pixel = settings.pixel_mm
        zero = dict.fromkeys(("x0", "y0", "K1", "K2", "K3", "P1", "P2"), 0.0)
        return brown_camera(values={**zero, "c": settings.c}, size_px=settings.format, pixel_mm=pixel, estimate=free)
    if settings.camera.suffix == ".toml" or settings.camera.is_dir():
        camera = _calibrated(settings.camera)
        known = tuple(s for s in free if s in camera.sensor.symbols)
        return replace(camera, estimate=known, sigma={}, relations=())
    from raybundle.io.cameras.library import with_library
    from raybundle.io.photos.cameras import camera_groups
    from raybundle.io.photos.photo import read_photo

    photo = read_photo(settings.camera)
    (group,) = with_library([photo], camera_groups([photo]))
    zero = dict.fromkeys(("x0", "y0", "K1", "K2", "K3", "P1", "P2"), 0.0)
    camera = brown_camera(values={**zero, "c": group.c_mm}, size_px=(group.width_px, group.height_px), estimate=free)
    return replace(camera, pixel_mm=group.pixel_mm)


def _calibrated(path: Path) -> Camera:
    """The camera of a calibration, or that of most photographs of a block; raises InputError for others than frames."""
    import numpy as np

    from raybundle.commands.planning.objects import block_in
    from raybundle.io.block.toml import read_cameras
    from raybundle.platforms import Carried

    if path.is_dir():
        block = block_in(path)
        if not block.cameras:
            raise InputError("block.no_camera", file=path)
        camera = block.cameras[int(np.bincount(block.images.camera, minlength=len(block.cameras)).argmax())]
    else:
        cameras = read_cameras(path)
        if len(cameras) != 1:
            raise InputError("calibration.camera_count", n=len(cameras), file=path)
        (camera,) = cameras
    if camera.is_scene or isinstance(camera.sensor, Carried):
        raise InputError(
            "plan.no_frame_camera", camera=camera.id, model=camera.model, file=path,
        )  # fmt: skip
    return camera


def _access(
    settings: NetworkSettings, surface: Surface, side: str, depth: tuple[float, float], fitting: float
) -> Access:
    """Where one may stand: a box about the object, without what is forbidden."""
    import numpy as np

    from raybundle.planning.network.site import Access

    low, high = (b.astype(float) for b in surface.wanted_bounds)
    extent, tall = surface.extent, float(high[2] - low[2])
    around = settings.around or min(REACH * max(extent, 0.5 * fitting), depth[1])
    heights = settings.heights or (0.5 * tall if side == "round" else 0.0, 1.5 * tall)
    if side == "above":
        heights = settings.heights or (0.3 * fitting, 1.5 * fitting)
    if heights[1] < heights[0]:
        raise InputError("site.empty", axis="Z", low_m=float(heights[0]), high_m=float(heights[1]))
    box_low = np.array([low[0] - around, low[1] - around, low[2] + heights[0]])
    box_high = np.array([high[0] + around, high[1] + around, low[2] + heights[1]])
    clearance = settings.clearance or max(depth[0], 0.05 * extent)
    if side == "front":
        box_high[1] = low[1] - clearance
    if clearance >= around:
        raise InputError("plan.never_sharp", near_m=float(clearance), far_m=float(around))
    boxes: Array = np.array(settings.forbid, float).reshape(-1, 2, 3)

    def near(centre: Array) -> Mask:
        off = np.maximum(np.maximum(low - centre, centre - high), 0)[:, :2]
        return np.asarray(np.linalg.norm(off, axis=1) <= around)

    return Access(low=box_low, high=box_high, clearance=clearance, forbidden=np.sort(boxes, axis=1), allowed=near)
