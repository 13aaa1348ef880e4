"""`raybundle rpc`: rational polynomials of satellite scenes, here used and made."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import MISSING, dataclass, replace
from pathlib import Path
from typing import TYPE_CHECKING, Any, Literal

from raybundle.commands.scenes.common import HEIGHTS_HELP, beyond, check_near, check_new, heights_of, size_of
from raybundle.commands.scenes.inputs import scene_input
from raybundle.errors import InputError, NotSolvable, RaybundleError, as_detail, message, phrase
from raybundle.settings import ANY, keywords, made, path_of, setting

if TYPE_CHECKING:
    from raybundle.io.scenes import Scene
    from raybundle.numerics.arrays import Array
    from raybundle.scenes.rpc import Rpc
    from raybundle.scenes.rpc_fit import RpcFit
    from raybundle.scenes.sensor import Rigorous


@dataclass(frozen=True, slots=True, kw_only=True)
class RpcProjectSettings:
    """Which points are projected, which way, by which model."""

    scene: Path
    """scene file"""
    points: Path
    """table point,lon_deg,lat_deg,h_m, or point,x_px,y_px,h_m to the ground"""
    out: Path = setting(MISSING, "Table to write.", metavar="CSV")
    to_ground: bool = setting(False, "Compute ground points of POINTS (point,x_px,y_px,h_m).")
    model: Literal["auto", "rpc", "rigorous"] = setting(
        "auto", "Sensor model. auto: the RPC, if the file has one, else the rigorous model."
    )


@dataclass(frozen=True, slots=True, kw_only=True)
class RpcFitSettings:
    """Of which scene an RPC is made."""

    scene: Path
    """scene file with a rigorous model"""
    out: Path = setting(MISSING, "RPC to write: NAME_RPC.TXT, NAME.RPB or NAME.geom.", metavar="FILE")
    heights: tuple[float, float] | None = setting(None, HEIGHTS_HELP, metavar="LOW HIGH", limits=(ANY, ANY))


@dataclass(frozen=True, slots=True, kw_only=True)
class Projected:
    """Points in image and on the ground."""

    ids: tuple[str, ...]
    image: Array
    """(n, 2) [px], outer-corner origin; NaN where the model has none"""
    ground: Array
    """(n, 3) longitude, latitude [deg], ellipsoidal height [m]; NaN where the model has none"""
    notes: tuple[str, ...]
    """what is to be stated of a point, or nothing"""
    beyond: tuple[int, ...]
    """points outside the range for which the RPC was made"""
    lost: tuple[int, ...]
    """points without coordinates"""


@keywords(RpcProjectSettings)
def rpc_project(scene: str | Path, points: str | Path, out: str | Path, **settings: Any) -> Projected:
    """Image points of ground points by the model of a scene, or the other way, as a table.

    scene     scene file with an RPC or a rigorous model
    points    table point,lon_deg,lat_deg,h_m; with to_ground=True point,x_px,y_px,h_m
    out       new table
    settings  as of the command line, by the names of `RpcProjectSettings`: model="rigorous"
    raises    InputError for what cannot be read, and where no point has a place

    Limits: how well the model is known; an RPC is off by its bias until it is corrected.
    """
    given = {"scene": path_of("scene", scene), "points": path_of("points", points), "out": path_of("out", out)}
    return run_project(made(RpcProjectSettings, {**given, **settings}))


@keywords(RpcFitSettings)
def rpc_fit(scene: str | Path, out: str | Path, **settings: Any) -> RpcFit:
    """Make an RPC that stands for the rigorous model of a scene.

    scene     scene file with a rigorous model
    out       new file, NAME_RPC.TXT or NAME.RPB
    settings  as of the command line, by the names of `RpcFitSettings`: heights=(0.0, 400.0)
    raises    InputError for what cannot be read or written

    Limits: how well the rigorous model is known.
    """
    given = {"scene": path_of("scene", scene), "out": path_of("out", out)}
    return run_fit(made(RpcFitSettings, {**given, **settings}))[0]


def run_project(settings: RpcProjectSettings) -> Projected:
    """Project what the settings ask for, and write the table; every point keeps its row."""
    from raybundle.io.digits import EVERY
    from raybundle.io.folders import new_files
    from raybundle.io.scenes import check_agreement
    from raybundle.io.tables import write_table

    s = settings
    check_new(s.out)
    scene = scene_input(s.scene).scene
    if s.model != "rpc":
        check_agreement(scene)
    model = _model(scene, s.model)
    columns = ("x_px", "y_px", "h_m") if s.to_ground else ("lon_deg", "lat_deg", "h_m")
    ids, rows = _table(s.points, columns)
    done = _projected(scene, model, ids, rows, s)
    both = dict(zip(("x_px", "y_px", "lon_deg", "lat_deg", "h_m"), (*done.image.T, *done.ground.T), strict=True))
    if s.to_ground:
        both["h_m"] = rows[:, 2]
    with new_files(s.out) as (file,):
        write_table(file, {"point": ids, **both, **({"note": done.notes} if any(done.notes) else {})}, EVERY)
    return done


def _projected(
    scene: Scene, model: Rpc | Rigorous, ids: tuple[str, ...], rows: Array, s: RpcProjectSettings
) -> Projected:
    """The points with their places, as far as the model has some."""
    from raybundle.scenes.rpc import NO_PLACE

    if scene.rpc is not None and not s.to_ground and not (scene.rpc.ranges_away(rows) < NO_PLACE).any():
        check_near(
            scene, scene.rpc, rows, ids
        )  # none of them: its message states more than a table without coordinates
    found, why = _each(lambda part: _placed(scene, model, part, to_ground=s.to_ground), ids, rows, s.scene)
    ground, image = (found, rows[:, :2]) if s.to_ground else (rows, found)
    notes = ["" if e is None else str(e) for e in why]
    if scene.rpc is not None and model is scene.rpc:
        there = [k for k in range(len(ids)) if why[k] is None]
        for k, note in beyond(scene.rpc, ground, there).items():
            notes[k] = note
    return Projected(
        ids=ids, image=image, ground=ground, notes=tuple(notes),
        beyond=tuple(k for k, note in enumerate(notes) if note and why[k] is None),
        lost=tuple(k for k, e in enumerate(why) if e is not None),
    )  # fmt: skip


def run_fit(settings: RpcFitSettings) -> tuple[RpcFit, tuple[str, ...]]:
    """Fit and write the RPC; also remarks."""
    from raybundle.io.scenes import check_agreement, read_scene
    from raybundle.io.scenes.writing import check_rpc_name, write_rpc
    from raybundle.numerics.geodesy import WGS84
    from raybundle.scenes.kinds.range_doppler import RangeDoppler
    from raybundle.scenes.rpc_fit import fit_rpc

    s = settings
    check_new(s.out)
    check_rpc_name(s.out)
    scene = read_scene(s.scene)
    if scene.rigorous is None:
        raise InputError("scene.model_missing", model="rigorous", choice=False, file=s.scene)
    if isinstance(scene.rigorous, RangeDoppler) and len(scene.rigorous.burst_y) > 1:
        raise NotSolvable("rpc.bursts", n=len(scene.rigorous.burst_y))
    check_agreement(scene)
    remarks = ()
    if scene.rigorous.ellipsoid != WGS84:
        remarks = (phrase("scene.other_body"),)
    result = fit_rpc(scene.rigorous.localise, size_of(scene), heights_of(scene, s.heights))
    write_rpc(result.rpc, s.out)
    return result, remarks


def _model(s: Scene, model: str) -> Rpc | Rigorous:
    chosen = {"auto": s.rpc or s.rigorous, "rpc": s.rpc, "rigorous": s.rigorous}[model]
    if chosen is None:
        raise InputError("scene.model_missing", model=model, choice=True, file=s.file)
    return chosen


def _table(path: Path, columns: tuple[str, ...], optional: tuple[str, ...] = ()) -> tuple[tuple[str, ...], Array]:
    """Ids and numbers (n, k); the optional columns only if the table has all of them."""
    import numpy as np

    from raybundle.io.tables import Column, read_table

    table = read_table(
        path,
        [
            Column(name="point", kind="id"),
            *(Column(name=c, kind="number") for c in columns),
            *(Column(name=c, kind="number", optional=True, limit=">= 0") for c in optional),
        ],
    )
    rows = table.numbers(*columns, *optional)
    return table.text["point"], rows if np.isfinite(rows).all() else rows[:, : len(columns)]


def _placed(s: Scene, model: Rpc | Rigorous, rows: Array, *, to_ground: bool) -> Array:
    from raybundle.scenes.rpc import NO_PLACE

    if to_ground:
        return model.localise(rows[:, :2], rows[:, 2])
    if s.rpc is not None and (far := float(s.rpc.ranges_away(rows).max())) >= NO_PLACE:
        raise InputError("rpc.point_far_away", ratio=far, limit=float(NO_PLACE))
    return model.project(rows)


def _each(
    function: Callable[[Array], Array], ids: tuple[str, ...], rows: Array, scene: Path
) -> tuple[Array, list[RaybundleError | None]]:
    """Results (n, k) and what hinders a row from having one; raises only where no row has one.

    Halves are tried again where a whole cannot be computed, so that few bad rows among many cost little.
    """
    import numpy as np

    found: dict[int, Array] = {}
    why: list[RaybundleError | None] = [None] * len(rows)
    parts = [(0, len(rows))] if len(rows) else []
    while parts:
        start, end = parts.pop()
        try:
            found[start] = function(rows[start:end])
        except RaybundleError as error:
            if end - start == 1:
                why[start] = error
            else:
                middle = (start + end) // 2
                parts += [(start, middle), (middle, end)]
    if why and not found:
        error = why[0]
        assert error is not None
        cause, where = as_detail(error), message("scene.no_place", point=ids[0], n=len(ids), name=str(scene))
        raise type(error)(replace(cause, details=(*cause.details, where)))
    width = next(iter(found.values())).shape[1] if found else 3
    values = np.full((len(rows), width), np.nan)
    for start, part in found.items():
        values[start : start + len(part)] = part
    return values, why
