"""`raybundle empirical`."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, Any

import click

from raybundle.cli.common import COMMAND_SETTINGS, FOLDER, NEW_FOLDER, counted, significant
from raybundle.cli.numbers import PIXELS
from raybundle.errors import InputError

if TYPE_CHECKING:
    from raybundle.numerics.arrays import Array, Mask
    from raybundle.scenes.empirical import EmpiricalFit
    from raybundle.scenes.empirical_statistics import EmpiricalAdvice, EmpiricalStatistics

MODELS = (
    "affine", "affine2", "parallel-perspective", "dlt", "dlt-brown", "sdlt", "plane-affine", "plane-projective",
)  # fmt: skip
CORRELATED = 0.95


@click.command("empirical", context_settings=COMMAND_SETTINGS)
@click.argument("points", type=FOLDER)
@click.option("--model", type=click.Choice(("auto", *MODELS)), default="auto", show_default=True,
    help="auto: the adequate one with the fewest parameters.",
)  # fmt: skip
@click.option("--sigma", type=PIXELS, default=0.5, show_default=True,
    help="Of a measured image coordinate [px]; it decides what is adequate.",
)  # fmt: skip
@click.option("--without", default="", metavar="K3,P1,...", help="Additional parameters of dlt-brown to leave out.")
@click.option("--out", type=NEW_FOLDER, metavar="FOLDER",
    help="New folder for model.json, parameters.csv and points.csv.",
)  # fmt: skip
@click.option("--traceback", is_flag=True, expose_value=False,
    help="After an error, show where in the program it arose.",
)  # fmt: skip
def command(points: Path, model: str, sigma: float, without: str, out: Path | None) -> int:
    """Fit an image of an unknown sensor to known points: affine, projective and DLT models, and say what is adequate.

    POINTS is a table point,X,Y,Z,x_px,y_px or point,lon_deg,lat_deg,h_m,x_px,y_px; a column role with `check` marks
    points that are compared only.  Z may be missing for the models of a plane.

    \b
    Exit status: 0 adequate; 2 bad input; 3 the model is not adequate, or cannot be fitted to these points.

    \b
    Example:
      raybundle empirical control.csv
      raybundle empirical control.csv --model dlt-brown --without K3 --sigma 0.3 --out camera
    """  # noqa: D301
    import numpy as np  # noqa: PLC0415  (what computes is loaded after the help)

    from raybundle.scenes.empirical import fit_empirical  # noqa: PLC0415
    from raybundle.scenes.empirical_statistics import choose_empirical, empirical_statistics  # noqa: PLC0415

    if out is not None and out.exists() and (not out.is_dir() or any(out.iterdir())):
        raise InputError("stands there already and is not overwritten; choose another folder or delete it", file=out)
    ids, xyz, xy, check = _points(points)
    use = ~check
    left_out = tuple(s.strip() for s in without.split(",") if s.strip())
    if model == "auto" and left_out:
        raise InputError("--without belongs to one model; give --model dlt-brown")
    try:
        if model == "auto":
            advice = choose_empirical(xyz[use], xy[use], sigma_px=sigma)
            _tell_advice(advice)
            chosen = advice.advised.fit if advice.advised is not None else None
            fit = chosen or min((c for c in advice.candidates if c.fit), key=lambda c: c.left_out_rms_px).fit
            assert fit is not None
        else:
            fit = fit_empirical(model, xyz[use], xy[use], sigma_px=sigma, without=left_out)
    except InputError as error:
        raise InputError(str(error), file=points) from None
    statistics = empirical_statistics(fit)
    used = [n for n, u in zip(ids, use.tolist(), strict=True) if u]
    _tell_fit(fit, statistics, used)
    if check.any():
        d = fit.project(xyz[check]) - xy[check]
        x, y = np.sqrt(np.mean(d**2, axis=0)).tolist()
        click.echo(f" {counted(int(check.sum()), 'check point')}: rms {significant(x)}, {significant(y)} px")
    if out is not None:
        _write(out, fit, statistics, ids, xyz, xy, check)
        click.echo(f" model and statistics: {out}")
    return 0 if fit.adequate else 3


def _points(path: Path) -> tuple[tuple[str, ...], Array, Array, Mask]:
    """Ids, object points (n, 3), image points (n, 2) and which are check points (n,)."""
    import numpy as np  # noqa: PLC0415

    from raybundle.io.tables import Column, read_table  # noqa: PLC0415

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
        from raybundle.numerics.geodesy import LocalPlace  # noqa: PLC0415

        geographic = table.numbers(*ground)
        origin = geographic.mean(axis=0)
        xyz = LocalPlace(origin=(float(origin[0]), float(origin[1]), float(origin[2]))).local_from_geographic(
            geographic
        )
    elif "X" in table.number and "Y" in table.number:
        z = table.number.get("Z", np.zeros(table.rows))
        xyz = np.column_stack([table.number["X"], table.number["Y"], z])
    else:
        raise InputError("coordinates are needed: X, Y, Z or lon_deg, lat_deg, h_m", file=path, line=1)
    roles = table.text.get("role", ("",) * table.rows)
    for k, role in enumerate(roles):
        if role not in {"", "control", "check"}:
            raise InputError(f"{role!r} is neither control nor check", file=path, line=k + 2, column="role")
    check = np.array([r == "check" for r in roles], bool)
    return table.text["point"], xyz, table.numbers("x_px", "y_px"), check


def _tell_advice(advice: EmpiricalAdvice) -> None:
    click.echo(f" {'model':21}{'parameters':>10}{'redundancy':>12}{'sigma0':>9}{'left out [px]':>15}   adequate")
    for c in advice.candidates:
        if c.fit is None:
            click.echo(f" {c.name:21}{'not fitted':>10}   {c.reason.partition(': ')[2] or c.reason}")
            continue
        f = c.fit
        told = "yes" if f.adequate and f.redundancy else "no" if f.redundancy else "no redundancy"
        click.echo(f" {c.name:21}{len(f.free):10d}{f.redundancy:12d}{f.sigma0:9.3g}{c.left_out_rms_px:15.3g}   {told}")
    click.echo(f" advised: {advice.reason}")


def _tell_fit(fit: EmpiricalFit, s: EmpiricalStatistics, ids: list[str]) -> None:
    click.echo(f" {fit.model.name}: {counted(len(ids), 'point')}, redundancy {fit.redundancy}, sigma0 {fit.sigma0:.3f}")
    click.echo(f" {'symbol':8}{'value':>14}{'sigma':>12}  {'unit':9}{'t':>8}")
    for p in s.parameters:
        t = "held" if p.t is None else f"{p.t:.1f}"
        note = "   not significant" if p.additional and p.t is not None and not p.significant else ""
        click.echo(f" {p.symbol:8}{p.value:14.6g}{p.std:12.3g}  {p.unit:9}{t:>8}{note}")
    strong = s.correlated(CORRELATED)
    if strong:
        told = ", ".join(f"{a} - {b} {r:+.3f}" for a, b, r in strong[:5])
        click.echo(
            f" correlations beyond {CORRELATED}: {told}" + (f" and {len(strong) - 5} more" if len(strong) > 5 else "")
        )
    for row, axis in s.blunders[:5]:
        click.echo(
            f" w of {ids[row]} in {'xy'[axis]}: {s.w[row, axis]:+.1f} (limit {s.critical_w:.1f}); residual "
            f"{fit.residuals_px[row, axis]:+.3g} px, look at it again"
        )
    click.echo(f" {'' if fit.adequate else 'caution: '}{fit.reason}")


def _write(
    out: Path, fit: EmpiricalFit, s: EmpiricalStatistics, ids: tuple[str, ...], xyz: Array, xy: Array, check: Mask
) -> None:
    import json  # noqa: PLC0415

    import numpy as np  # noqa: PLC0415

    from raybundle.io.folders import new_folder  # noqa: PLC0415
    from raybundle.io.tables import write_table  # noqa: PLC0415

    n = fit.normalisation
    model: dict[str, Any] = {
        "model": fit.model.name, "object_offset": n.object_offset.tolist(), "image_offset_px": n.image_offset.tolist(),
        "sigma_px": fit.sigma_px, "sigma0": fit.sigma0, "redundancy": fit.redundancy, "adequate": fit.adequate,
        "reason": fit.reason, "critical_w": s.critical_w,
        "parameters": {p.symbol: {"value": p.value, "std": p.std, "unit": p.unit, "t": p.t} for p in s.parameters},
        "covariance": s.covariance.tolist(), "correlation": s.correlation.tolist(),
    }  # fmt: skip

    def spread(values: Array) -> Array:
        full = np.full((len(ids), 2), np.nan)
        full[~check] = values
        return full

    columns: dict[str, Any] = {
        "point": ids, "role": ["check" if c else "control" for c in check.tolist()],
        **{f"{a}_px": xy[:, k] for k, a in enumerate("xy")},
    }  # fmt: skip
    tables = {
        "v": fit.project(xyz) - xy, "r": spread(s.redundancy), "w": spread(s.w), "mdb": spread(s.mdb_px),
        "left_out": spread(s.left_out_px),
    }  # fmt: skip
    for name, values in tables.items():
        unit = "" if name in {"r", "w"} else "_px"
        columns |= {f"{name}_{a}{unit}": values[:, k] for k, a in enumerate("xy")}
    with new_folder(out) as folder:
        text = json.dumps(model, indent=1, allow_nan=False, default=float)
        (folder / "model.json").write_text(text + "\n", encoding="utf-8")
        write_table(folder / "points.csv", columns)
        write_table(
            folder / "parameters.csv",
            {
                "symbol": [p.symbol for p in s.parameters], "value": np.array([p.value for p in s.parameters]),
                "std": np.array([p.std for p in s.parameters]), "unit": [p.unit for p in s.parameters],
            },
        )  # fmt: skip
