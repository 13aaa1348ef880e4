"""`raybundle empirical`: models of an image of an unknown sensor, fitted to known points."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING, Any, Literal

from raybundle.errors import InputError
from raybundle.io.folders import check_free
from raybundle.settings import PIXELS, keywords, made, path_of, setting

if TYPE_CHECKING:
    from raybundle.numerics.arrays import Array, Mask
    from raybundle.scenes.empirical import EmpiricalFit
    from raybundle.scenes.empirical_statistics import EmpiricalAdvice, EmpiricalStatistics

Model = Literal[
    "auto", "affine", "affine2", "parallel-perspective", "dlt", "dlt-brown", "sdlt", "plane-affine", "plane-projective"
]


@dataclass(frozen=True, slots=True, kw_only=True)
class EmpiricalSettings:
    """What is fitted to which points."""

    points: Path
    """table point,X,Y,Z,x_px,y_px or point,lon_deg,lat_deg,h_m,x_px,y_px, with a column role where some are compared"""
    model: Model = setting("auto", "Model to fit. auto: the adequate one with the fewest parameters.")
    image_sigma: float = setting(
        0.5, "Sigma of a measured image coordinate [px]. It decides which models are adequate.", limits=PIXELS
    )
    without: tuple[str, ...] = setting(
        (), "Additional parameters of dlt-brown to leave out.", metavar="K3,P1,...", joined=True
    )
    out: Path | None = setting(None, "New folder for model.json, parameters.csv and points.csv.", metavar="FOLDER")


@dataclass(frozen=True, slots=True, kw_only=True)
class ControlPoints:
    """Points with their places in the image."""

    ids: tuple[str, ...]
    xyz: Array
    """(n, 3) as given, or in a local frame in the middle of the points where they are geographic [m]"""
    xy_px: Array
    """(n, 2)"""
    check: Mask
    """(n,) which are compared only"""


@dataclass(frozen=True, slots=True, kw_only=True)
class Empirical:
    """A fitted model, and how good it is."""

    fit: EmpiricalFit
    statistics: EmpiricalStatistics
    points: ControlPoints
    advice: EmpiricalAdvice | None
    """all models, where the choice was left to the program"""
    check_rms_px: tuple[float, float] | None
    """rms difference of the check points in x and y; None: there are none"""

    @property
    def used(self) -> tuple[str, ...]:
        """Points that took part, in the order of the fit's rows."""
        return tuple(n for n, c in zip(self.points.ids, self.points.check.tolist(), strict=True) if not c)


@keywords(EmpiricalSettings)
def empirical(points: str | Path, **settings: Any) -> Empirical:
    """Fit an image of an unknown sensor to known points: affine, projective and DLT models.

    points    table point,X,Y,Z,x_px,y_px or point,lon_deg,lat_deg,h_m,x_px,y_px; role `check`: compared only
    settings  as of the command line, by the names of `EmpiricalSettings`: model="dlt-brown", without="K3"
    raises    InputError for what cannot be read, and for points to which the model cannot be fitted

    Limits: an inadequate model is returned as well; `fit.adequate` and `fit.reason` say so.
    """
    return run_empirical(made(EmpiricalSettings, {"points": path_of("points", points), **settings}))


def run_empirical(settings: EmpiricalSettings) -> Empirical:
    """Fit what the settings ask for, and write it where they say so."""
    import numpy as np

    from raybundle.scenes.empirical_statistics import empirical_statistics

    s = settings
    if s.out is not None:
        check_free(s.out)
    points = read_points(s.points)
    if s.model == "auto" and s.without:
        raise InputError("empirical.excluded_needs_model")
    fit, advice = _fitted(s, points)
    check_rms = None
    if points.check.any():
        d = fit.project(points.xyz[points.check]) - points.xy_px[points.check]
        x, y = np.sqrt(np.mean(d**2, axis=0)).tolist()
        check_rms = x, y
    found = Empirical(
        fit=fit, statistics=empirical_statistics(fit), points=points, advice=advice, check_rms_px=check_rms
    )
    if s.out is not None:
        _write(s.out, found)
    return found


def _fitted(s: EmpiricalSettings, points: ControlPoints) -> tuple[EmpiricalFit, EmpiricalAdvice | None]:
    """The model asked for; else the advised one, or that which predicts points left out best."""
    from raybundle.scenes.empirical import fit_empirical
    from raybundle.scenes.empirical_statistics import choose_empirical

    use = ~points.check
    try:
        if s.model != "auto":
            given = points.xyz[use], points.xy_px[use]
            return fit_empirical(s.model, *given, sigma_px=s.image_sigma, without=s.without), None
        advice = choose_empirical(points.xyz[use], points.xy_px[use], sigma_px=s.image_sigma)
    except InputError as error:
        raise error.at(s.points) from None
    chosen = advice.advised.fit if advice.advised is not None else None
    fit = chosen or min((c for c in advice.candidates if c.fit), key=lambda c: c.left_out_rms_px).fit
    assert fit is not None
    return fit, advice


def read_points(path: Path) -> ControlPoints:
    """The points of a table; raises InputError."""
    import numpy as np

    from raybundle.io.tables import Column, read_table

    ground, grid = ("lon_deg", "lat_deg", "h_m"), ("X", "Y", "Z")
    table = read_table(
        path,
        [
            Column(name="point", kind="id"),
            *(Column(name=c, kind="number", optional=True) for c in (*grid, *ground)),
            *(Column(name=c, kind="number") for c in ("x_px", "y_px")),
            Column(name="role", kind="text", optional=True, empty=True),
        ],
    )
    if all(c in table.number for c in ground):
        from raybundle.numerics.geodesy import LocalPlace

        geographic = table.numbers(*ground)
        east, north, up = geographic.mean(axis=0).tolist()
        xyz = LocalPlace(origin=(east, north, up)).local_from_geographic(geographic)
    elif "X" in table.number and "Y" in table.number:
        z = table.number.get("Z", np.zeros(table.rows))
        xyz = np.column_stack([table.number["X"], table.number["Y"], z])
    else:
        raise InputError(
            "table.one_position", grid=["X", "Y", "Z"], geographic=["lon_deg", "lat_deg", "h_m"], file=path, line=1
        )
    roles = table.text.get("role", ("",) * table.rows)
    for k, role in enumerate(roles):
        if role not in {"", "control", "check"}:
            from raybundle.io.reading.words import quoted

            raise InputError(
                "value.not_supported",
                value=quoted(role),
                known=["control", "check"],
                file=path,
                line=k + table.first_line,
                column="role",
            )
    check = np.array([r == "check" for r in roles], bool)
    return ControlPoints(ids=table.text["point"], xyz=xyz, xy_px=table.numbers("x_px", "y_px"), check=check)


def _write(out: Path, found: Empirical) -> None:
    import json

    import numpy as np

    from raybundle.io.digits import STD, Within, jointly
    from raybundle.io.folders import new_folder
    from raybundle.io.tables import write_table

    fit, s = found.fit, found.statistics
    n = fit.normalisation
    model: dict[str, Any] = {
        "model": fit.model.name, "object_offset": n.object_offset.tolist(), "image_offset_px": n.image_offset.tolist(),
        "sigma_px": fit.sigma_px, "sigma0": fit.sigma0, "redundancy": fit.redundancy, "adequate": fit.adequate,
        "reason": fit.reason.text(), "message": fit.reason.json(), "critical_w": s.critical_w,
        "parameters": {p.symbol: {"value": p.value, "std": p.std, "unit": p.unit, "t": p.t} for p in s.parameters},
        "covariance": s.covariance.tolist(), "correlation": s.correlation.tolist(),
    }  # fmt: skip
    alone = [rule.limit for rule in jointly(s.covariance[None])]
    values = Within(np.concatenate([np.zeros(0), *alone]))
    with new_folder(out) as folder:
        text = json.dumps(model, indent=1, allow_nan=False, default=float)
        (folder / "model.json").write_text(text + "\n", encoding="utf-8")
        write_table(folder / "points.csv", *_columns(found))
        write_table(
            folder / "parameters.csv",
            {
                "symbol": [p.symbol for p in s.parameters], "value": np.array([p.value for p in s.parameters]),
                "std": np.array([p.std for p in s.parameters]), "unit": [p.unit for p in s.parameters],
            },
            {"value": values, "std": STD},
        )  # fmt: skip


def _columns(found: Empirical) -> tuple[dict[str, Any], dict[str, Any]]:
    """points.csv: residuals of all points, redundancy, w and smallest detectable blunders of those that took part."""
    import numpy as np

    from raybundle.io.digits import EVERY, REDUNDANCY, STD, TEST, by_sigma

    s, points = found.statistics, found.points

    def spread(values: Array) -> Array:
        full = np.full((len(points.ids), 2), np.nan)
        full[~points.check] = values
        return full

    columns: dict[str, Any] = {
        "point": points.ids, "role": ["check" if c else "control" for c in points.check.tolist()],
        **{f"{a}_px": points.xy_px[:, k] for k, a in enumerate("xy")},
    }  # fmt: skip
    tables = {
        "v": found.fit.project(points.xyz) - points.xy_px, "r": spread(s.redundancy), "w": spread(s.w),
        "mdb": spread(s.mdb_px), "left_out": spread(s.left_out_px),
    }  # fmt: skip
    sigma = by_sigma(np.full(len(points.ids), found.fit.sigma_px))
    rules = {"v": sigma, "r": REDUNDANCY, "w": TEST, "mdb": STD, "left_out": sigma}
    digits: dict[str, Any] = {"x_px": EVERY, "y_px": EVERY}
    for name, values in tables.items():
        unit = "" if name in {"r", "w"} else "_px"
        columns |= {f"{name}_{a}{unit}": values[:, k] for k, a in enumerate("xy")}
        digits |= {f"{name}_{a}{unit}": rules[name] for a in "xy"}
    return columns, digits
