"""Tables of a result: their columns, and what stands in them."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence

import numpy as np

from raybundle.adjustment.blunders.accuracy import levelled
from raybundle.adjustment.evaluation.check_points import check_differences, used_rays
from raybundle.adjustment.records.figures import ObservationGroup
from raybundle.adjustment.result import Adjustment
from raybundle.block import Role
from raybundle.block.rejection import words
from raybundle.io.block.folder import angles_deg
from raybundle.io.block.observations import table_columns
from raybundle.io.block.points import point_columns
from raybundle.io.block.tables import ANGLES, SIGMA_XYZ, XYZ, columns_of, named
from raybundle.io.table_files import Named
from raybundle.numerics.arrays import Array
from raybundle.observations import ObservationKind, OfKinds, in_order

Columns = dict[str, Sequence[str] | Array]
Layout = tuple[tuple[str, ...], tuple[str, ...], tuple[str, ...]]

SIGMA_ANGLES = ("somega_deg", "sphi_deg", "skappa_deg")
IMAGES = (*XYZ, *ANGLES, *SIGMA_XYZ, *SIGMA_ANGLES)
CORRELATIONS = ("rXY", "rXZ", "rYZ")
LATER = ("window", "roughness", *CORRELATIONS)
"""Columns of points.csv that results of earlier versions lack."""
DATE, DATED = "date", ("images", "points")
"""Column of results of several dates, and the tables that have it then, behind all others."""
P_WRONG = "p_wrong"
"""Column of images.csv of results of photographs, behind all others."""
POINTS = (*XYZ, *SIGMA_XYZ, "rays", *LATER)
OBSERVATIONS = (
    *("x_px", "y_px", "sx_px", "sy_px", "vx_px", "vy_px", "rx", "ry"),
    *("wx", "wy", "tx", "ty", "mdbx_px", "mdby_px"),
)
TESTS = ("vX", "vY", "vZ", "rX", "rY", "rZ", "wX", "wY", "wZ")
CONTROL = (*XYZ, *SIGMA_XYZ, *TESTS)
CHECK = (*XYZ, "dX", "dY", "dZ", *SIGMA_XYZ)
STATIONS = (*XYZ, *SIGMA_XYZ, "X_adjusted", "Y_adjusted", "Z_adjusted", *TESTS)
ATTITUDES = (
    *ANGLES, *SIGMA_ANGLES, *("omega_adjusted_deg", "phi_adjusted_deg", "kappa_adjusted_deg"),
    *("vomega_deg", "vphi_deg", "vkappa_deg", "romega", "rphi", "rkappa", "womega", "wphi", "wkappa"),
)  # fmt: skip


def _tests_of(kind: ObservationKind) -> tuple[str, ...]:
    """Columns of what an adjustment makes of a kind of observation; angles in degrees."""
    unit = "_deg" if kind.unit == "angle" else ""
    of = kind.components
    return (*(f"{what}{c}{unit}" for what in ("adjusted", "v") for c in of), *(f"{w}{c}" for w in "rw" for c in of))


def _layout(kind: ObservationKind) -> Layout:
    """Columns of the table of a kind of observation: what was given, the adjusted quantities, v, r and w."""
    assert kind.table is not None
    given = [(c, n) for _, c in kind.table.cells() for n in c.names]
    numbers = tuple(n for c, n in given if c.of == "number")
    tests = _tests_of(kind)
    return tuple(n for c, n in given if c.of != "number"), (*numbers, *tests), ()


_OF_EVERY_BLOCK: Mapping[str, Layout] = {
    "images": (("image", "camera", "file"), IMAGES, ()),
    "points": (("point", "role"), POINTS, ()),
    "observations": (("image", "point"), OBSERVATIONS, ("rejected",)),
    "control": (("point",), CONTROL, ()),
    "check": (("point",), CHECK, ()),
    "stations": (("image",), STATIONS, ()),
    "attitudes": (("image",), ATTITUDES, ()),
}
TABLES: Mapping[str, Layout] = OfKinds(
    lambda: {
        **_OF_EVERY_BLOCK,
        **{k.table.name: _layout(k) for k in in_order() if k.table and k.name not in {"station", "attitude"}},
    }
)
"""Table -> text columns, numbers, text columns at the end."""


ALWAYS = ("images", "points", "observations", "control", "check", "distances", "stations")
"""Tables that a result folder has with or without rows; the others stand there where the block has rows of them."""


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
    if name in DATED and adjustment.given.images.date is not None:
        columns[DATE] = _dates(adjustment, name, adjustment.given.images.date)
    if name == "images" and adjustment.p_wrong is not None:
        columns[P_WRONG] = adjustment.p_wrong
    return columns


def _dates(a: Adjustment, name: str, dates: Sequence[str]) -> Sequence[str]:
    """The date of each image; of each point that was seen at one date, empty of others."""
    if name == "images":
        return dates
    seen: dict[int, set[str]] = {}
    o = a.given.observations
    for p, i in {*zip(o.point.tolist(), o.image.tolist(), strict=True)}:
        seen.setdefault(p, set()).add(dates[int(i)])
    return ["".join(seen[p]) if len(seen.get(p, ())) == 1 else "" for p in range(len(a.given.points))]


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
    points, rough = a.adjusted.points, None if a.precision is None else a.precision.roughness
    return {
        **point_columns(points),
        **columns_of(XYZ, points.xyz),
        **columns_of(SIGMA_XYZ, _point_std(a)),
        "rays": used_rays(a),
        "window": _lacking(a) if points.window is None else points.window,
        "roughness": _lacking(a)
        if rough is None
        else np.where(np.isfinite(rough).all(axis=1), np.linalg.norm(rough, axis=1), np.nan),
        **columns_of(CORRELATIONS, _point_correlations(a)),
    }


def _point_correlations(a: Adjustment) -> Array:
    """(p, 3) correlations of X and Y, X and Z, Y and Z; NaN where a coordinate is held."""
    if a.precision is None:
        return np.full((len(a.given.points), 3), np.nan)
    std = a.precision.object_point_std
    first, second = [0, 0, 1], [1, 2, 2]
    product = std[:, first] * std[:, second]
    covariance = a.precision.object_points[:, first, second]
    return np.divide(covariance, product, out=np.full(product.shape, np.nan), where=product > 0)


def _lacking(a: Adjustment) -> Array:
    return np.full(len(a.given.points), np.nan)


def _observations(a: Adjustment) -> Columns:
    o, s = a.given.observations, a.image_observations
    return {
        "image": Named(a.given.images.ids, o.image),
        "point": Named(a.given.points.ids, o.point),
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
    """The table of a kind of observation as `_layout` states."""
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
