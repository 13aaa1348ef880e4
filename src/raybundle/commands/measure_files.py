"""Files of a measurement: nominal coordinates and known lengths, and the tables that it writes."""

from __future__ import annotations

import math
from pathlib import Path
from typing import TYPE_CHECKING, Any, Literal

from raybundle.errors import InputError
from raybundle.numerics.length_units import is_other_unit
from raybundle.numerics.natural import natural_order

if TYPE_CHECKING:
    from collections.abc import Sequence

    from raybundle.adjustment.records.notice import Notice
    from raybundle.metrology.best_fit import BestFit, Nominal
    from raybundle.metrology.lengths import KnownLength, LengthTest
    from raybundle.metrology.point_set import PointSet

LIST, NOMINAL, LENGTHS = "coordinate_list.csv", "nominal.csv", "lengths.csv"


def known_lengths(path: Path, unit: float) -> list[KnownLength]:
    """Lengths of a table from,to,length[,sigma] in units of so many metres; raises InputError."""
    from raybundle.io.tables import Column, read_table
    from raybundle.metrology.lengths import KnownLength

    columns = [Column(name=n, kind="text") for n in ("from", "to")]
    columns += [
        Column(name="length", kind="number", limit="> 0"),
        Column(name="sigma", kind="number", optional=True, empty=True, limit=">= 0"),
    ]
    table = read_table(path, columns)
    length, sigma = table.numbers("length", "sigma").T * unit
    rows = zip(table.text["from"], table.text["to"], length.tolist(), sigma.tolist(), strict=True)
    found = [
        KnownLength(start=a, end=b, length=d, sigma=0.0 if math.isnan(e) else e, line=line)
        for line, (a, b, d, e) in enumerate(rows, table.first_line)
    ]
    for k in found:
        if k.start == k.end:
            raise InputError("length_test.same_ends", start=k.start, end=k.end, file=path, line=k.line)
    return found


def without_doubles(
    known: Sequence[KnownLength], kind: Literal["length", "scale_bar"]
) -> tuple[list[KnownLength], tuple[Notice, ...]]:
    """Lengths, each once though it was given twice, its ends exchanged or not; and notices."""
    from raybundle.metrology.notices import given_twice

    found: dict[tuple[frozenset[str], float], KnownLength] = {}
    twice: list[str] = []
    for k in known:
        key = frozenset((k.start, k.end)), k.length
        if key in found:
            twice.append(f"{k.start} - {k.end}")
        found.setdefault(key, k)
    if not twice:
        return list(known), ()
    return list(found.values()), given_twice(kind, twice)


def check_lengths(points: PointSet, known: Sequence[KnownLength], path: Path | None) -> None:
    """Raise InputError for ends that were not measured, with the file and its line, and lengths in another unit."""
    import numpy as np

    place = {name: k for k, name in enumerate(points.ids)}
    for k in known:
        missing = [end for end in (k.start, k.end) if end not in place]
        if missing:
            file, line = (path, k.line) if k.line is not None else (None, None)
            raise InputError("length_test.ends_not_measured", points=missing, bars=False, file=file, line=line)
    if points.free_scale:
        return
    way = points.xyz[[place[k.end] for k in known]] - points.xyz[[place[k.start] for k in known]]
    ratio = float(np.median(np.array([k.length for k in known]) / np.maximum(np.linalg.norm(way, axis=1), 1e-300)))
    if is_other_unit(ratio):
        from raybundle.metrology.misfit_words import unit_of

        raise InputError(
            "length_test.other_unit",
            ratio=ratio,
            likely=bool(unit_of(ratio)),
            units=unit_of(ratio),
            table=path is not None,
            file=path,
        )


def fitted_to(points: PointSet, nominal: Nominal, path: Path, **how: Any) -> BestFit:
    """Measured points fitted onto those of a file (`best_fit`); raises InputError with the file."""
    from raybundle.metrology.best_fit import best_fit

    try:
        return best_fit(points, nominal, **how)
    except InputError as error:
        raise error.at(path) from None


def check_unit(points: PointSet, nominal: Nominal, path: Path) -> None:
    """Raise InputError where nominal points lie so far apart against the measured ones that their unit is another."""
    import numpy as np

    at = {name: k for k, name in enumerate(points.ids)}
    both = [(at[name], k) for k, name in enumerate(nominal.ids) if name in at]
    if len(both) < 2 or points.free_scale:
        return
    measured, wanted = (
        xyz[[*rows]] for xyz, rows in zip((points.xyz, nominal.xyz), zip(*both, strict=True), strict=True)
    )
    # by the median distance from the middle: few wrong points do not make another unit
    sizes = [float(np.median(np.linalg.norm(xyz - np.median(xyz, axis=0), axis=1))) for xyz in (wanted, measured)]
    if min(sizes) <= 1e-9 * max(sizes) or not is_other_unit(ratio := sizes[0] / sizes[1]):
        return  # those that are all one point lie in one line, which the fit finds
    from raybundle.metrology.misfit_words import unit_of

    raise InputError(
        "fit.other_unit",
        ratio=ratio,
        likely=bool(unit_of(ratio)),
        units=unit_of(ratio),
        file=path,
    )


def nominal_points(path: Path, unit: float) -> Nominal:
    """Coordinates of a table point,X,Y,Z[,sX,sY,sZ][,tolerance] in units of so many metres; raises InputError."""
    import numpy as np

    from raybundle.io.tables import Column, read_table
    from raybundle.metrology.best_fit import Nominal

    columns = [Column(name="point", kind="id"), *(Column(name=a, kind="number") for a in "XYZ")]
    columns += [Column(name=f"s{a}", kind="number", optional=True, empty=True, limit=">= 0") for a in "XYZ"]
    columns.append(Column(name="tolerance", kind="number", optional=True, empty=True, limit="> 0"))
    table = read_table(path, columns)
    return Nominal(
        ids=table.text["point"], xyz=unit * table.numbers(*"XYZ"),
        tolerance=unit * table.numbers("tolerance")[:, 0],
        sigma=unit * np.nan_to_num(table.numbers("sX", "sY", "sZ")),
    )  # fmt: skip


def write_tables(folder: Path, points: PointSet, fit: BestFit | None, lengths: LengthTest | None) -> None:
    """Coordinates, deviations from nominal and errors of lengths, each in a table of its own."""
    import numpy as np

    from raybundle.io.digits import (
        PROBABILITY,
        SHARE,
        SHORT,
        STD,
        by_sigma,
        in_network,
        jointly,
        of_pairs,
    )
    from raybundle.io.tables import write_table
    from raybundle.numerics.statistics import correlation

    order = np.array(natural_order(points.ids), np.int64)
    own = points.own[order]
    R = np.array([correlation(C) for C in own])
    write_table(
        folder / LIST,
        {
            "point": [points.ids[k] for k in order], **_axes("", "_m", points.xyz[order]),
            **_axes("s", "_mm", 1000 * np.sqrt(np.diagonal(own, axis1=1, axis2=2))),
            "rXY": R[:, 0, 1], "rXZ": R[:, 0, 2], "rYZ": R[:, 1, 2],
        },
        {
            **dict(zip(("X_m", "Y_m", "Z_m"), in_network(jointly(own), points.xyz), strict=True)),
            **{f"s{a}_mm": STD for a in "XYZ"},
            **dict(zip(("rXY", "rXZ", "rYZ"), of_pairs(own), strict=True)),
        },
    )  # fmt: skip
    if fit is not None:
        f = fit
        std = np.sqrt(np.maximum(np.diagonal(f.covariance, axis1=1, axis2=2), 0))
        write_table(
            folder / NOMINAL,
            {
                "point": f.ids, "fitted": ["yes" if v else "" for v in f.fitted], **_axes("", "_m", f.xyz),
                **_axes("d", "_mm", 1000 * f.deviation), **_axes("sd", "_mm", 1000 * std),
                "length_mm": 1000 * f.length, "p": f.p_value,
                "significant": ["yes" if v else "" for v in f.significant], "tolerance_mm": 1000 * f.tolerance,
                "verdict": f.verdict,
            },
            {
                **{f"{a}_m": by_sigma(std[:, k]) for k, a in enumerate("XYZ")},
                **{f"d{a}_mm": by_sigma(1000 * std[:, k]) for k, a in enumerate("XYZ")},
                **{f"sd{a}_mm": STD for a in "XYZ"}, "length_mm": by_sigma(1000 * np.linalg.norm(std, axis=1)),
                "p": PROBABILITY, "tolerance_mm": SHARE,
            },
        )  # fmt: skip
    if lengths is not None:
        t = lengths
        write_table(
            folder / LENGTHS,
            {
                "from": [k.start for k in t.known], "to": [k.end for k in t.known],
                "known_m": np.array([k.length for k in t.known]), "measured_m": t.measured, "error_mm": 1000 * t.error,
                "sigma_mm": 1000 * t.error_sigma, "p": t.p_value,
                "significant": ["yes" if v else "" for v in t.significant], "allowed_mm": 1000 * t.allowed,
                "was_bar": ["yes" if v else "" for v in t.served],
            },
            {
                "known_m": SHORT, "measured_m": by_sigma(t.error_sigma),
                "error_mm": by_sigma(1000 * t.error_sigma), "sigma_mm": STD, "p": PROBABILITY, "allowed_mm": SHARE,
            },
        )  # fmt: skip


def _axes(before: str, after: str, values: Any) -> dict[str, Any]:
    return {f"{before}{a}{after}": values[:, k] for k, a in enumerate("XYZ")}
