"""Result folders: written whole or not at all, and read again for comparison."""

from __future__ import annotations

import json
import math
from collections.abc import Mapping, Sequence
from dataclasses import asdict, dataclass, field, replace
from pathlib import Path
from typing import TYPE_CHECKING, Any, Literal, cast

import numpy as np

from raybundle.adjustment.accuracy import levelled
from raybundle.adjustment.check_points import check_differences, used_rays
from raybundle.adjustment.counts import counts
from raybundle.adjustment.result import Adjustment, InteriorResult, ObservationGroup, gravest_first
from raybundle.block import Block, Camera, Role
from raybundle.block.rejection import counts as rejections
from raybundle.block.rejection import found_wrong, words
from raybundle.block.stored import observed_jointly
from raybundle.errors import InputError
from raybundle.io.block_folder import (
    ANGLES,
    FILES,
    SIGMA_XYZ,
    XYZ,
    angles_deg,
    columns_of,
    named,
    point_columns,
    read_block,
    write_block_files,
)
from raybundle.io.block_observations import table_columns
from raybundle.io.folders import check_place, new_folder
from raybundle.io.reading.trees import read_json
from raybundle.io.reading.words import quoted
from raybundle.io.tables import Column, Table, read_table, write_table
from raybundle.numerics.arrays import Array
from raybundle.numerics.progress import Progress, silent
from raybundle.observations import ObservationKind, in_order

if TYPE_CHECKING:
    from raybundle.calibration.quality import CalibrationQuality
    from raybundle.io.coordinate_systems import LocalFrame
    from raybundle.report.section_photographs import PhotographFacts

Columns = dict[str, Sequence[str] | Array]

SIGMA_ANGLES = ("somega_deg", "sphi_deg", "skappa_deg")
IMAGES = (*XYZ, *ANGLES, *SIGMA_XYZ, *SIGMA_ANGLES)
POINTS = (*XYZ, *SIGMA_XYZ, "rays")
OBSERVATIONS = (
    *("x_px", "y_px", "sx_px", "sy_px", "vx_px", "vy_px", "rx", "ry"),
    *("wx", "wy", "tx", "ty", "mdbx_px", "mdby_px"),
)
TESTS = ("vX", "vY", "vZ", "rX", "rY", "rZ", "wX", "wY", "wZ")
CONTROL = (*XYZ, *SIGMA_XYZ, *TESTS)
CHECK = (*XYZ, "dX", "dY", "dZ", *SIGMA_XYZ)
STATIONS = (*XYZ, *SIGMA_XYZ, "X_adjusted", "Y_adjusted", "Z_adjusted", *TESTS)
ANGLES, SIGMA_ANGLES = ("omega_deg", "phi_deg", "kappa_deg"), ("somega_deg", "sphi_deg", "skappa_deg")
ATTITUDES = (
    *ANGLES, *SIGMA_ANGLES, *("omega_adjusted_deg", "phi_adjusted_deg", "kappa_adjusted_deg"),
    *("vomega_deg", "vphi_deg", "vkappa_deg", "romega", "rphi", "rkappa", "womega", "wphi", "wkappa"),
)  # fmt: skip


def _tests_of(kind: ObservationKind) -> tuple[str, ...]:
    """Columns of what an adjustment makes of a kind of observation; angles in degrees."""
    unit = "_deg" if kind.unit == "angle" else ""
    of = kind.components
    return (*(f"{what}{c}{unit}" for what in ("adjusted", "v") for c in of), *(f"{w}{c}" for w in "rw" for c in of))


def _layout(kind: ObservationKind) -> tuple[tuple[str, ...], tuple[str, ...], tuple[str, ...]]:
    """Columns of the table of a kind of observation: what was given, the adjusted quantities, v, r and w."""
    assert kind.table is not None
    given = [(c, n) for _, c in kind.table.cells() for n in c.names]
    numbers = tuple(n for c, n in given if c.of == "number")
    tests = _tests_of(kind)
    return tuple(n for c, n in given if c.of != "number"), (*numbers, *tests), ()


TABLES: Mapping[str, tuple[tuple[str, ...], tuple[str, ...], tuple[str, ...]]] = {
    "images": (("image", "camera", "file"), IMAGES, ()),
    "points": (("point", "role"), POINTS, ()),
    "observations": (("image", "point"), OBSERVATIONS, ("rejected",)),
    "control": (("point",), CONTROL, ()),
    "check": (("point",), CHECK, ()),
    "stations": (("image",), STATIONS, ()),
    "attitudes": (("image",), ATTITUDES, ()),
} | {kind.table.name: _layout(kind) for kind in in_order() if kind.table and kind.name not in {"station", "attitude"}}
"""Table -> text columns, numbers, text columns at the end."""
ALWAYS = ("images", "points", "observations", "control", "check", "distances", "stations", "attitudes")
"""Tables that a result folder has with or without rows; the others stand there where the block has rows of them."""
PROJECT = "project"
"""Folder in a result folder where `raybundle calibrate` keeps what is finished"""
ENTRIES = {
    "block",
    "result.json",
    "report.html",
    "network.html",
    "map.csv",
    "calibration.toml",
    *(f"{name}.csv" for name in TABLES),
}


@dataclass(frozen=True, slots=True, kw_only=True)
class ResultFolder:
    """A result folder as it was read: `table.text["point"]`, `table.number["sX"]` (NaN where empty)."""

    path: Path
    result: Mapping[str, Any]
    """result.json: sigma0, redundancy, cameras, correlations, warnings ...; see the reference of the format."""
    block: Block
    """RESULT/block: the adjusted values."""
    images: Table
    """text image, camera, file; number X ... kappa_deg, sX ... skappa_deg"""
    points: Table
    """text point, role; number X, Y, Z, sX, sY, sZ, rays"""
    observations: Table
    """text image, point, rejected; number x_px ... mdby_px"""
    control: Table
    check: Table
    distances: Table
    stations: Table
    attitudes: Table | None
    """None in results of versions before observed attitudes."""
    others: Mapping[str, Table] = field(default_factory=dict[str, Table])
    """Tables of further kinds of observations, by their names: "planes" ..."""


def check_target(path: str | Path) -> None:
    """Raise InputError where a result must not be written: over anything but a result folder."""
    folder = Path(path)
    check_place(folder)
    if not folder.exists():
        return
    if not folder.is_dir():
        raise InputError("stands there already and is no folder; choose another name for the result", file=folder)
    present = {entry.name for entry in folder.iterdir()}
    if (folder / PROJECT / "project.db").is_file():
        present -= {PROJECT}  # of a run that is to be continued, or of one that ended
    if not present:
        return
    if "result.json" not in present or not _is_ours(folder / "result.json"):
        raise InputError("is not a result folder and is not overwritten; choose another name", file=folder)
    inner = {entry.name for entry in (folder / "block").iterdir()} if (folder / "block").is_dir() else set[str]()
    foreign = sorted(present - ENTRIES) + sorted(f"block/{name}" for name in inner - set(FILES))
    if foreign:
        raise InputError(
            f"holds files that no adjustment wrote ({', '.join(foreign[:3])}); move them, or choose another name",
            file=folder,
        )


def _is_ours(path: Path) -> bool:
    try:
        content = read_json(path).value
    except InputError:
        return False
    return isinstance(content, dict) and {"sigma0", "redundancy", "cameras"} <= cast("dict[str, Any]", content).keys()


def stored_camera(adjustment: Adjustment, camera: Camera, qualities: Sequence[CalibrationQuality]) -> Camera:
    """An adjusted camera as a calibration: observed with its covariance; free where it could not be determined."""
    interior = next((i for i in adjustment.interior if i.camera == camera.id and i.image is None), None)
    precision = adjustment.precision
    plain = replace(camera, estimate=(), sigma={}, relations=(), calibrated=None)
    if any(q.camera == camera.id and q.grade == "not determinable" for q in qualities):
        return replace(plain, estimate="auto")
    if interior is None or precision is None or not interior.free:
        return plain
    return observed_jointly(plain, interior.free, precision.interior[camera.id])


def write_result(
    adjustment: Adjustment,
    path: str | Path,
    *,
    report: Literal["html", "none"] = "html",
    additions: Mapping[str, object] | None = None,
    photographs: PhotographFacts | None = None,
    frame: LocalFrame | None = None,
    qualities: tuple[CalibrationQuality, ...] = (),
    progress: Progress = silent,
) -> None:
    """Write a result folder, whole or not at all; an older result there is replaced when the new one is complete.

    report       "html": report.html and network.html, the network in three dimensions
    additions    further keys of result.json
    photographs  what is known of the photographs that the adjustment comes from
    frame        the coordinate system in which the local frame of the adjustment stands; map.csv is in that system
    qualities    verdicts on calibrated cameras; calibration.toml, as `--calibration` takes it, is written beside them
    raises       InputError where something else stands at `path`
    """
    check_target(path)
    with new_folder(Path(path)) as folder:
        progress("writing tables", 0.0)
        (folder / "block").mkdir()
        write_block_files(_block_again(adjustment), folder / "block")
        progress("writing tables", 0.2)
        for name in TABLES:  # one after the other: those of the image observations are large
            write_table(folder / f"{name}.csv", result_table(adjustment, name))
        if frame is not None:
            from raybundle.report.map_table import map_table  # noqa: PLC0415  (pyproj only where it is used)

            write_table(folder / "map.csv", map_table(adjustment, frame))
        if qualities:
            from raybundle.io.calibrations.ours import cameras_text  # noqa: PLC0415

            cameras = [stored_camera(adjustment, c, qualities) for c in adjustment.adjusted.cameras]
            verdicts = "".join(f"# {q.camera}: {q.headline}\n" for q in qualities)
            text = f"{verdicts}\n{cameras_text(cameras)}"
            (folder / "calibration.toml").write_text(text, encoding="utf-8", newline="\n")
        contents = {**result_json(adjustment), **(additions or {})}
        text = json.dumps(_clean(contents), indent=1, ensure_ascii=False, allow_nan=False)
        (folder / "result.json").write_text(text + "\n", encoding="utf-8")
        progress("writing tables", 1.0)
        if report == "html":
            from raybundle.report.document import write_report  # noqa: PLC0415  (Jinja2 only where it is used)
            from raybundle.report.network_page import write_network_page  # noqa: PLC0415

            write_report(adjustment, folder / "report.html", progress, photographs, qualities)
            write_network_page(adjustment, folder / "network.html")
        if (Path(path) / PROJECT / "project.db").is_file():  # stays for the next run
            (Path(path) / PROJECT).rename(folder / PROJECT)


def _block_again(adjustment: Adjustment) -> Block:
    """The given block with adjusted values as approximations; what was observed or held stays as it was given."""
    given, adjusted = adjustment.given, adjustment.adjusted
    stays = given.points.is_control | given.points.is_check
    xyz = np.where(stays, given.points.xyz, adjusted.points.xyz)
    cameras: list[Camera] = []
    for before, after in zip(given.cameras, adjusted.cameras, strict=True):
        observed = {s: before.values[s] for s in before.sigma if s in before.values}
        cameras.append(replace(before, values={**after.values, **observed}))
    return replace(
        given,
        free_scale="scale" in adjustment.datum_defect,
        noise="" if adjustment.options.noise == "auto" else adjustment.options.noise,
        datum_over="" if adjustment.options.datum_over == "all" else adjustment.options.datum_over,
        rejected=found_wrong(given, adjustment.image_observations.rejected),
        cameras=tuple(cameras),
        images=replace(adjusted.images, held=given.images.held),
        points=replace(given.points, xyz=xyz),
    )


def result_json(adjustment: Adjustment) -> dict[str, Any]:
    """The contents of result.json; NaN stands for a number that there is not."""
    a = adjustment
    lower, statistic, upper = a.global_test
    n = counts(a)
    return {
        "name": a.given.name,
        "raybundle": _version(),
        "length_unit": a.given.length_unit,
        "scale": "free" if "scale" in a.datum_defect else "fixed",
        "sigma0": a.sigma0,
        "sigma0_apriori": a.given.sigma0_apriori,
        "weighted_square_sum": a.weighted_square_sum,
        "redundancy": a.redundancy,
        "observations": a.observations,
        "unknowns": a.unknowns,
        "constraints": a.constraints,
        "datum": a.datum,
        "datum_defect": list(a.datum_defect),
        "converged": a.converged,
        "iterations": a.iterations,
        "seconds": a.seconds,
        "global_test": {"lower": lower, "statistic": statistic, "upper": upper},
        "images_count": n.images_given,
        "images_used": n.images_used,
        "points_count": n.points_given,
        "points_used": n.points_used,
        "image_points": n.image_observations_given,
        "image_points_used": n.image_observations_used,
        "rejected": n.rejected,
        "rejections": rejections(a.image_observations.rejected),
        "relative_precision": math.nan if a.network is None else a.network.relative_precision,
        "extent": math.nan if a.network is None else a.network.extent,
        "mean_std": math.nan if a.network is None else a.network.mean_std,
        "critical_w": a.critical_w,
        "critical_tau": a.critical_tau,
        "not_determinable": list(a.not_determinable),
        "not_significant": list(a.not_significant),
        "cameras": {_key(i): _parameters(i) for i in a.interior},
        "correlations": {_key(i): _correlations(i) for i in a.interior if len(i.free)},
        "noise": asdict(a.noise),
        "variance_components": [asdict(v) for v in a.variance_components],
        "options": asdict(a.options),
        "warnings": [
            {"code": n.code, "severity": n.severity.value, "message": n.message, "ids": list(n.ids)}
            for n in gravest_first(a.notices)
        ],
    }


def _version() -> str:
    from importlib.metadata import PackageNotFoundError, version  # noqa: PLC0415

    try:
        return version("raybundle")
    except PackageNotFoundError:
        return "source tree"


def _key(interior: InteriorResult) -> str:
    return interior.camera if interior.image is None else f"{interior.camera}/{interior.image}"


def _parameters(interior: InteriorResult) -> dict[str, dict[str, Any]]:
    return {
        symbol: {
            "value": p.value,
            "std": p.std,
            "std_white": p.std if p.std_white is None else p.std_white,
            "t": p.t,
            "unit": p.unit,
            "status": p.status,
            "determinability": p.determinability,
            "effect_px": p.effect_px,
        }
        for symbol, p in interior.parameters.items()
    }


def _correlations(interior: InteriorResult) -> dict[str, dict[str, float]]:
    table = np.asarray(interior.correlations).tolist()
    return {s: dict(zip(interior.free, row, strict=True)) for s, row in zip(interior.free, table, strict=True)}


def _clean(value: Any) -> Any:
    """The value with plain numbers, and None in place of NaN and infinity."""
    if isinstance(value, dict):
        return {str(k): _clean(v) for k, v in cast("dict[Any, Any]", value).items()}
    if isinstance(value, list | tuple):
        return [_clean(v) for v in cast("Sequence[Any]", value)]
    if isinstance(value, np.generic):
        return _clean(value.item())
    if isinstance(value, float) and not math.isfinite(value):
        return None
    return value


def result_tables(adjustment: Adjustment) -> dict[str, Columns]:
    """The columns of every table of a result folder, in the order of the files."""
    there = {*ALWAYS, *adjustment.given.tables}
    return {name: result_table(adjustment, name) for name in TABLES if name in there}


def result_table(adjustment: Adjustment, name: str) -> Columns:
    """The columns of one table of a result folder."""
    builders = {
        "images": _images,
        "points": _points,
        "observations": _observations,
        "control": _control,
        "check": _check,
        "stations": _stations,
        "attitudes": _attitudes,
    }
    kind = next((k for k in in_order() if k.table is not None and k.table.name == name), None)
    if name in builders:
        columns = builders[name](adjustment)
    else:
        assert kind is not None, name
        columns = _of_kind(adjustment, kind)
    first, numbers, last = TABLES[name]
    assert tuple(columns) == (*first, *numbers, *last), name
    return columns


def _images(a: Adjustment) -> Columns:
    images = a.adjusted.images
    std = np.full((len(images), 6), np.nan) if a.precision is None else a.precision.image_std
    # a satellite scene stands nowhere: its nominal viewpoint is not shown
    blank = np.where(np.array([c.scene is not None for c in a.given.cameras])[images.camera], np.nan, 0.0)[:, None]
    std = std + blank
    return {
        "image": images.ids,
        "camera": [a.given.cameras[c].id for c in images.camera],
        "file": images.file,
        **columns_of(XYZ, images.centre + blank),
        **columns_of(ANGLES, angles_deg(images) + blank),
        **columns_of(SIGMA_XYZ, std[:, :3]),
        **columns_of(SIGMA_ANGLES, np.degrees(std[:, 3:])),
    }


def _point_std(a: Adjustment) -> Array:
    return np.full((len(a.given.points), 3), np.nan) if a.precision is None else a.precision.object_point_std


def _points(a: Adjustment) -> Columns:
    points = a.adjusted.points
    return {
        **point_columns(points),
        **columns_of(XYZ, points.xyz),
        **columns_of(SIGMA_XYZ, _point_std(a)),
        "rays": used_rays(a),
    }


def _observations(a: Adjustment) -> Columns:
    o, s = a.given.observations, a.image_observations
    return {
        "image": named(a.given.images.ids, o.image),
        "point": named(a.given.points.ids, o.point),
        **columns_of(("x_px", "y_px"), o.xy_px),
        **columns_of(("sx_px", "sy_px"), np.sqrt(o.cov_px2[:, :2])),
        **columns_of(("vx_px", "vy_px"), s.residuals_px),
        **columns_of(("rx", "ry"), s.redundancy),
        **columns_of(("wx", "wy"), s.w),
        **columns_of(("tx", "ty"), s.t),
        **columns_of(("mdbx_px", "mdby_px"), s.mdb_px),
        "rejected": words(s.rejected),
    }


class _Tests:
    """Residual, redundancy number and w of the observations of one kind, by id and component."""

    def __init__(self, groups: Sequence[ObservationGroup], kind: str) -> None:
        self.rows: dict[tuple[str, str], list[tuple[float, float, float]]] = {}
        for g in groups:
            if g.kind == kind:
                for k, key in enumerate(zip(g.ids, g.component, strict=True)):
                    values = (float(g.residual[k]), float(g.redundancy[k]), float(g.w[k]))
                    self.rows.setdefault(key, []).append(values)

    def of(self, id_: str, component: str) -> tuple[float, float, float]:
        """The next row of this id and component; NaN where there is none."""
        found = self.rows.get((id_, component))
        return found.pop(0) if found else (math.nan, math.nan, math.nan)

    def by_axis(self, ids: Sequence[str]) -> dict[str, Array]:
        """Columns vX ... wZ."""
        values = np.array([[self.of(i, axis) for axis in XYZ] for i in ids], float).reshape(-1, 3, 3)
        return columns_of(TESTS, values.transpose(0, 2, 1).reshape(-1, 9))


def _control(a: Adjustment) -> Columns:
    rows = np.flatnonzero(np.asarray(a.given.points.role) == Role.CONTROL).astype(np.int32)
    ids = named(a.given.points.ids, rows)
    known = a.given.points.is_control[rows]
    known[:, 2] &= ~np.isin(np.array(ids), list(levelled(a)))
    return {
        "point": ids,
        **columns_of(XYZ, np.where(known, a.given.points.xyz[rows], np.nan)),
        **columns_of(SIGMA_XYZ, np.where(known, a.given.points.sigma[rows], np.nan)),
        **_Tests(a.groups, "control").by_axis(ids),
    }


def _check(a: Adjustment) -> Columns:
    rows, difference = check_differences(a)
    given = np.where(a.given.points.is_check[rows], a.given.points.xyz[rows], np.nan)
    sigma = np.nan_to_num(a.given.points.sigma[rows])
    std = np.where(np.isfinite(difference), np.hypot(_point_std(a)[rows], sigma), np.nan)
    return {
        "point": named(a.given.points.ids, rows),
        **columns_of(XYZ, given),
        **columns_of(("dX", "dY", "dZ"), difference),
        **columns_of(SIGMA_XYZ, std),
    }


def _of_kind(a: Adjustment, kind: ObservationKind) -> Columns:
    """The table of a kind of observation as `_layout` says."""
    table, count = kind.table_of(a.given), len(kind.components)
    group = next((g for g in a.groups if g.kind == kind.name), None)
    found = np.full((len(table), 4, count), np.nan)
    lacking = np.full(len(table), np.nan)
    if group is not None:
        k, c = group.item, group.quantity
        found[k, 0, c], found[k, 1, c], found[k, 2, c] = group.adjusted, group.residual, group.redundancy
        found[k, 3, c] = group.w
    names = _tests_of(kind)
    if kind.unit == "angle":
        found[:, :2] = np.degrees(found[:, :2])
    columns = table_columns(table, a.given) | columns_of(names, found.reshape(len(table), 4 * count))
    first, numbers, _ = _layout(kind)
    return {name: columns.get(name, lacking) for name in (*first, *numbers)}


def _stations(a: Adjustment) -> Columns:
    s = a.given.stations
    ids = named(a.given.images.ids, s.image)
    return {
        "image": ids,
        **columns_of(XYZ, s.xyz),
        **columns_of(SIGMA_XYZ, s.sigma),
        **columns_of(("X_adjusted", "Y_adjusted", "Z_adjusted"), a.adjusted.images.centre[s.image]),
        **_Tests(a.groups, "station").by_axis(ids),
    }


def _attitudes(a: Adjustment) -> Columns:
    """Attitudes as observed and as adjusted [deg], the latter of the image itself, without misalignment."""
    o = a.given.attitudes
    ids = named(a.given.images.ids, o.image)
    tests = _Tests(a.groups, "attitude")
    rows = np.array([[tests.of(i, angle) for angle in ("omega", "phi", "kappa")] for i in ids], float).reshape(-1, 3, 3)
    rows[:, :, 0] = np.degrees(rows[:, :, 0])
    return {
        "image": ids,
        **columns_of(ANGLES, np.degrees(o.angles)),
        **columns_of(SIGMA_ANGLES, np.degrees(o.sigma)),
        **columns_of(ATTITUDES[6:9], np.degrees(a.adjusted.images.angles[o.image])),
        **columns_of(ATTITUDES[9:], rows.transpose(0, 2, 1).reshape(-1, 9)),
    }


def read_result(path: str | Path) -> ResultFolder:
    """A result folder's tables and result.json; raises InputError where it is not one."""
    folder = Path(path)
    if not (folder / "result.json").is_file():
        raise InputError("is not a result folder, it holds no result.json; give what --out named", file=folder)
    if not _is_ours(folder / "result.json"):
        raise InputError("is not the result.json of an adjustment; adjust again", file=folder / "result.json")
    result = cast("dict[str, Any]", read_json(folder / "result.json").value)
    block = read_block(folder / "block")
    known = {"image": frozenset(block.images.ids), "point": frozenset(block.points.ids)}
    tables: dict[str, Table] = {}
    for name, (first, numbers, last) in TABLES.items():
        if (name == "attitudes" or name not in ALWAYS) and not (folder / f"{name}.csv").is_file():
            continue
        columns = (
            *(Column(name=n, kind="text", empty=True) for n in first),
            *(Column(name=n, kind="number", empty=True) for n in numbers),
            *(Column(name=n, kind="text", empty=True) for n in last),
        )
        tables[name] = read_table(folder / f"{name}.csv", columns, least_rows=0)
        for column, ids in known.items():
            _check_ids(folder / f"{name}.csv", column, tables[name].text.get(column, ()), ids)
    return ResultFolder(
        path=folder,
        result=result,
        block=block,
        images=tables["images"],
        points=tables["points"],
        observations=tables["observations"],
        control=tables["control"],
        check=tables["check"],
        distances=tables["distances"],
        stations=tables["stations"],
        attitudes=tables.get("attitudes"),
        others={name: tables[name] for name in tables if name not in ALWAYS},
    )


def _check_ids(path: Path, column: str, ids: Sequence[str], known: frozenset[str]) -> None:
    """Raise where a table names what the block beside it does not hold."""
    for row, id_ in enumerate(ids):
        if id_ not in known:
            message = f"{quoted(id_)} does not stand in block/{column}s.csv; the result is damaged: adjust again"
            raise InputError(message, file=path, line=row + 2, column=column)
