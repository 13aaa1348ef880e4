"""`raybundle rpc correct`: the RPC of a scene corrected on control points, with what it then states of its errors."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, replace
from pathlib import Path
from typing import TYPE_CHECKING, Any, Literal

from raybundle.commands.scenes.common import HEIGHTS_HELP, beyond, check_near, check_new, heights_of, size_of
from raybundle.commands.scenes.inputs import SceneInput, is_object, path_of_object, scene_input
from raybundle.errors import InputError, Text, joined_texts, phrase
from raybundle.settings import ANY, PIXELS, keywords, made, path_of, setting

if TYPE_CHECKING:
    from raybundle.io.scenes import Scene
    from raybundle.io.scenes.control import SceneControl
    from raybundle.numerics.arrays import Array
    from raybundle.scenes.bias_choice import BiasAdvice, BiasFit
    from raybundle.scenes.rpc import Rpc
    from raybundle.scenes.rpc_errors import GroundErrors
    from raybundle.scenes.rpc_fit import RpcFit

BiasChoice = Literal["auto", "none", "shift", "drift", "affine"]
CRS_HELP = "Coordinate system of control that defines none, with its heights: EPSG:32633, EPSG:25832+7837."
UNDULATION_HELP = (
    "Height of the geoid above the ellipsoid of WGS 84 or GRS 80 at the control, if its heights refer to the geoid."
)
IMAGE_POINTS_HELP = "Table image,point,x_px,y_px. The control gives ground coordinates of these points."


@dataclass(frozen=True, slots=True, kw_only=True)
class ControlSettings:
    """How control of scenes is read, and what is adjusted."""

    image_points: Path | None = setting(None, IMAGE_POINTS_HELP, metavar="FILE")
    crs: str | None = setting(None, CRS_HELP, metavar="SYSTEM")
    undulation: float | None = setting(None, UNDULATION_HELP, metavar="M", limits=ANY)
    scene_bias: BiasChoice = setting("auto", "Bias model of the RPC. auto: by significance and leave-one-out.")
    image_sigma: float = setting(0.5, "Sigma of a measured image coordinate [px].", limits=PIXELS)
    heights: tuple[float, float] | None = setting(None, HEIGHTS_HELP, metavar="LOW HIGH", limits=(ANY, ANY))


@dataclass(frozen=True, slots=True, kw_only=True)
class RpcCorrectSettings(ControlSettings):
    """Which RPC is corrected on which points, and how."""

    scene: Path
    """scene file with an RPC, or a picture with one in its tag or beside it"""
    points: Path
    """control: CSV, GeoJSON, GeoPackage or gcp_list.txt"""
    out: Path | None = setting(
        None,
        "Corrected RPC to write: NAME_RPC.TXT, NAME.RPB, NAME.geom, or NAME.tif (a copy of the picture with the RPC "
        "in its tag).",
        metavar="FILE",
    )
    into_scene: bool = setting(
        False, "Write the RPC into the tag of the GeoTIFF SCENE itself. NAME-former_RPC.TXT keeps the former RPC."
    )
    rpc: Path | None = setting(None, "File with the RPC of the picture SCENE.  [default: its tag, or beside it]",
                               metavar="FILE")  # fmt: skip


@dataclass(frozen=True, slots=True, kw_only=True)
class Checked:
    """Check points against the corrected RPC."""

    ids: tuple[str, ...]
    differences_px: Array
    """(n, 2) measured - corrected projection"""
    rms_px: Array
    """(2,) x, y"""
    rms_m: float
    """of one horizontal axis on the ground, at the heights of the points"""


@dataclass(frozen=True, slots=True, kw_only=True)
class Correction:
    """What control points say of an RPC, and the correction that is advised, or was asked for."""

    rpc: Rpc
    """as the scene has it"""
    ids: tuple[str, ...]
    advice: BiasAdvice
    fit: BiasFit | None
    """None: the points do not determine the one that was asked for"""
    beyond: Mapping[int, str]
    """points whose heights the RPC was not made for, or that were measured outside the picture, and why"""
    size_px: tuple[int, int]
    scene: Scene
    errors: GroundErrors | None = None
    """ERR_BIAS and ERR_RAND of the corrected RPC"""
    checked: Checked | None = None
    remarks: tuple[str, ...] = ()
    picture: Path | None = None
    corrected: Rpc | None = None
    """with the correction built in; None where it was not asked for"""
    refitted: RpcFit | None = None
    """drift and affine: the new fit that stands for the corrected RPC"""
    written: tuple[Path, ...] = ()


@keywords(RpcCorrectSettings)
def rpc_correct(scene: Any, points: str | Path, *, rpc: Any = None, **settings: Any) -> Correction:
    """Correct an RPC on control points; with `out` it is written with the correction built in.

    scene     scene file with an RPC; a picture with one in its tag or beside it; an opened dataset of rasterio; a
              DataArray that rioxarray opened
    points    CSV, GeoJSON, GeoPackage or gcp_list.txt with ground and image points (see the how-to page)
    rpc       RPC instead of that of the scene: a path, an `Rpc`, or a `rasterio.rpc.RPC`
    settings  as of the command line, by the names of `RpcCorrectSettings`: scene_bias="shift", out="corrected.tif"
    returns   `corrected` is the RPC with the correction and its ERR_BIAS and ERR_RAND; `corrected.to_rasterio()` the
              same for rasterio
    raises    InputError for what cannot be read; NotSolvable where the points contradict the correction

    Limits: errors that all control points have in common.
    """
    opened = is_object(scene)
    path = path_of_object(scene) if opened else path_of("scene", scene)
    given = {"scene": path, "points": path_of("points", points)}
    own = rpc if rpc is None or not isinstance(rpc, str | Path) else path_of("rpc", rpc)
    asked = made(RpcCorrectSettings, {**given, **settings})
    check_outputs(asked)
    found = correction_of(asked, scene_input(scene if opened else path, own))
    return write_correction(asked, found, always=True)


def check_outputs(s: RpcCorrectSettings) -> None:
    """Raise InputError where what is asked for cannot be written, before anything is computed."""
    if s.into_scene and s.out is not None:
        raise InputError("option.exclusive", first="into_scene", second="out")
    if s.out is not None:
        check_new(s.out)
    if s.into_scene and (former := former_of(s.scene)).exists():
        raise InputError("scene.original_rpc", file=former)


def former_of(scene: Path) -> Path:
    """Where the RPC of a scene is kept that is replaced."""
    return scene.with_name(f"{scene.stem}-former_RPC.TXT")


def correction_of(settings: RpcCorrectSettings, given: SceneInput | None = None) -> Correction:
    """What the points say of the RPC; nothing is written."""
    from raybundle.io.scenes.control import read_scene_control

    s = settings
    given = given or scene_input(s.scene, s.rpc)
    _check_target(s, given)
    control = read_scene_control(s.points, image_points=s.image_points, crs=s.crs, undulation=s.undulation)
    return correction_on(given, control.of(given.name, given.scene.file.name, alone=True), s)


def _check_target(s: RpcCorrectSettings, given: SceneInput) -> None:
    """Raise InputError where the scene has no RPC, or the file to write cannot be made of it."""
    from raybundle.io.scenes.writing import RASTERS, check_rpc_name

    if given.scene.rpc is None:
        raise InputError("scene.rpc_missing", file=given.scene.file)
    if s.into_scene:
        if given.picture is None or given.picture.suffix.lower() not in RASTERS:
            raise InputError("scene.no_geotiff", file=s.scene)
        check_rpc_name(given.picture, given.picture)
    if s.out is not None:
        check_rpc_name(s.out, given.picture)


def correction_on(given: SceneInput, control: SceneControl, s: ControlSettings) -> Correction:
    """What control of one scene states of its RPC."""
    import numpy as np

    from raybundle.scenes.bias_choice import choose_bias, point_covariance
    from raybundle.scenes.height_units import check_height_unit
    from raybundle.scenes.image_axes import check_image_axes
    from raybundle.scenes.rpc_errors import ground_errors

    scene, rpc = given.scene, given.scene.rpc
    assert rpc is not None
    used, checks = (control.rows(np.flatnonzero(m).tolist()) for m in (~control.check, control.check))
    if not used.ids:
        raise InputError("scene_control.check_only", file=control.file)
    check_near(scene, rpc, control.geographic, control.ids)
    advice = choose_bias(rpc, used.geographic, used.xy_px, sigma_px=s.image_sigma, sigma_ground_m=used.sigma_m)
    fit = advice.advised if s.scene_bias == "auto" else next((f for f in advice.fits if f.kind == s.scene_bias), None)
    if fit is not None:
        check_image_axes(rpc, used.geographic, used.xy_px, size_of(scene), fit)
        if used.heights_m is not None:
            covariance, _ = point_covariance(rpc, used.geographic, s.image_sigma, used.sigma_m)
            check_height_unit(rpc, used.geographic, used.heights_m, used.xy_px, covariance, fit)
    return Correction(
        rpc=rpc, ids=used.ids, advice=advice, fit=fit, scene=scene, size_px=size_of(scene), picture=given.picture,
        beyond=_odd_points(scene, rpc, used),
        errors=None if fit is None else ground_errors(rpc, advice, fit),
        checked=None if fit is None or not checks.ids else _checked(rpc, fit, checks),
        remarks=(*given.remarks, *control.remarks),
    )  # fmt: skip


def _odd_points(scene: Scene, rpc: Rpc, used: SceneControl) -> dict[int, Text]:
    """Points whose heights the RPC was not made for, or that were measured outside the picture."""
    notes = beyond(rpc, used.geographic, range(len(used.ids)), only_heights=True)
    if scene.width_px and scene.height_px:
        for k, (x, y) in enumerate(used.xy_px.tolist()):
            if not (0 <= x <= scene.width_px and 0 <= y <= scene.height_px):
                where = phrase(
                    "scene.outside_picture", x_px=x, y_px=y, width_px=scene.width_px, height_px=scene.height_px
                )
                notes[k] = joined_texts(notes[k], where) if k in notes else where
    return notes


def _checked(rpc: Rpc, fit: BiasFit, checks: SceneControl) -> Checked:
    import numpy as np

    from raybundle.numerics.geodesy import metres_per_geographic
    from raybundle.scenes.bias import bias_design

    xy, by_ground = rpc.project_with_partials(checks.geographic)
    uv = (xy - rpc.image_offset) / rpc.image_scale
    left = checks.xy_px - xy - bias_design(fit.kind, uv) @ fit.values
    plan = (by_ground / metres_per_geographic(checks.geographic)[:, None, :])[:, :, :2]
    on_ground = np.linalg.solve(plan, left[..., None])[..., 0]
    return Checked(
        ids=checks.ids, differences_px=left, rms_px=np.sqrt(np.mean(left**2, axis=0)),
        rms_m=float(np.sqrt(np.mean(on_ground**2))),
    )  # fmt: skip


def write_correction(settings: RpcCorrectSettings, found: Correction, *, always: bool = False) -> Correction:
    """Build the correction in, and write it, where that is asked for.

    always  whether it is built in where nothing is written, too
    raises  InputError where the points do not determine it; NotSolvable where it must not be used
    """
    from raybundle.io.scenes.writing import write_rpc

    s, writes = settings, settings.out is not None or settings.into_scene
    check_correction(found, s)
    if not (writes or always):
        return found
    done = with_corrected(found, s.heights)
    rpc = done.corrected
    assert rpc is not None
    if s.out is not None:
        write_rpc(rpc, s.out, found.picture)
        return replace(done, written=(s.out,))
    if s.into_scene:
        assert found.picture is not None
        former = former_of(found.picture)
        write_rpc(found.rpc, former)
        write_rpc(rpc, found.picture, found.picture)
        return replace(done, written=(found.picture, former))
    return done


def check_correction(found: Correction, s: ControlSettings) -> None:
    """Raise where the points do not determine the correction, or contradict it."""
    from raybundle.scenes.bias_choice import check_fit

    file = s.points if isinstance(s, RpcCorrectSettings) else None
    if found.fit is None:
        raise InputError("bias.not_determined", n=len(found.ids), model=s.scene_bias, file=file)
    check_fit(found.advice, found.fit)


def with_corrected(found: Correction, heights: tuple[float, float] | None) -> Correction:
    """With the corrected RPC, which states its own errors."""
    from raybundle.scenes.rpc_fit import corrected_rpc

    fit, errors = found.fit, found.errors
    assert fit is not None
    assert errors is not None
    limits = heights_of(found.scene, heights)
    rpc, refitted = corrected_rpc(found.rpc, fit.kind, fit.values, found.size_px, limits)
    return replace(found, corrected=errors.of(rpc), refitted=refitted)
