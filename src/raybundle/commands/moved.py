"""`raybundle moved`: which points have moved between measurements, by the congruence test."""

from __future__ import annotations

import json
from collections.abc import Mapping, Sequence
from dataclasses import MISSING, dataclass, replace
from pathlib import Path
from typing import TYPE_CHECKING, Any

from raybundle.commands.measure_files import check_unit, fitted_to, nominal_points
from raybundle.commands.measure_scale import bar_names
from raybundle.commands.pages import LANGUAGE_HELP, PDF_HELP, check_pages
from raybundle.commands.record_settings import CLIENT, OPERATOR, TITLE, record_of
from raybundle.errors import InputError, Message
from raybundle.numerics.natural import natural_order
from raybundle.numerics.progress import Progress, silent
from raybundle.settings import Range, keywords, made, setting

if TYPE_CHECKING:
    from raybundle.adjustment.result import Adjustment
    from raybundle.block import Block
    from raybundle.io.digits import Digits
    from raybundle.metrology.best_fit import BestFit
    from raybundle.metrology.congruence import Congruence
    from raybundle.metrology.point_set import PointSet

OTHER_SCALE = 0.05
"""Difference of scales, as a share, from which on axes are not those of the object: no part shrinks so much"""


@dataclass(frozen=True, slots=True, kw_only=True)
class MovedSettings:
    """Measurements of the same points at different times, and how they are held against each other."""

    epochs: tuple[Path, ...]
    """results, projects or blocks, in the order of time"""
    out: Path = setting(MISSING, "New folder for report.html, points.csv and moved.json.", metavar="FOLDER")
    datum_points: tuple[str, ...] = setting(
        (), "Known stable points.  [default: found by the test]", metavar="A,B,C,...", joined=True
    )
    points: tuple[str, ...] = setting(
        (),
        "Use only these points. Dots have their names of the first measurement.  [default: all named points, and dots]",
        metavar="A,B,C,...",
        joined=True,
    )
    significance: float = setting(
        0.05, "Probability that any stable point is reported as moved.", limits=Range(low=1e-6, high=0.5)
    )
    axes: Path | None = setting(
        None, "Nominal coordinates that define the axes of the result: point,X,Y,Z. The fit uses the stable points "
        "in the first measurement.  [default: the axes of the first measurement]", metavar="FILE",
    )  # fmt: skip
    by: tuple[str, ...] = setting(
        (),
        "Points for the fit of {axes}.  [default: all stable points of the file]",
        metavar="A,B,C,...",
        joined=True,
    )
    unit: float = setting(1.0, "Metres per unit of {axes}.", limits=Range(low=1e-9, high=1e6))
    free_scale: bool = setting(False, "Let epochs differ in scale, even if bars or control measured it.")
    title: str = setting("", TITLE, metavar="TEXT")
    client: str = setting("", CLIENT, metavar="TEXT")
    operator: str = setting("", OPERATOR, metavar="TEXT")
    report: bool = setting(True, "Leave out report.html.", flag="no-report")
    pdf: bool = setting(False, PDF_HELP)
    language: str = setting("en", LANGUAGE_HELP, metavar="CODE")


@keywords(MovedSettings)
def moved_points(
    epochs: Sequence[Adjustment | str | Path], out: str | Path, *, progress: Progress = silent, **settings: Any
) -> Congruence:
    """Test which points moved between results of the same points, and write what came of it.

    epochs    two or more results (folders, or adjustments), in the order of time; points are the same by their names,
              dots without a code by their place
    out       new folder: report.html, points.csv (displacements with standard deviations), moved.json
    settings  as of the command line, by the names of `MovedSettings`
    raises    InputError for fewer than four common points, or points that are held without error
    Limits: a motion that all points share.
    """
    names = tuple(Path(e) if isinstance(e, str | Path) else Path(f"epoch {k + 1}") for k, e in enumerate(epochs))
    asked = made(MovedSettings, {"epochs": names, "out": Path(out), **settings})
    return _moved(asked, epochs, progress)


def run_moved(settings: MovedSettings, progress: Progress = silent) -> Congruence:
    """Test and write what the settings ask for."""
    return _moved(settings, settings.epochs, progress)


def _moved(s: MovedSettings, epochs: Sequence[Adjustment | str | Path], progress: Progress) -> Congruence:
    from raybundle.adjustment.readjust import block_again
    from raybundle.adjustment.result import Adjustment
    from raybundle.block.points import dot_number
    from raybundle.io.folders import check_new_folder, short_names
    from raybundle.measuring.point_sets import point_set
    from raybundle.measuring.session import adjusted_as_free
    from raybundle.metrology.congruence import congruence
    from raybundle.metrology.dots import dots_alike
    from raybundle.metrology.epochs import comparable, most_moved, others_as_well
    from raybundle.metrology.misfit_words import axes_notices

    if len(epochs) < 2:
        raise InputError("epochs.only_one")
    check_new_folder(s.out)
    check_pages(s)
    if s.axes is None and s.by:
        raise InputError("option.needs", setting="by", other="axes")
    nominal = None if s.axes is None else nominal_points(s.axes, s.unit)
    sets: list[PointSet] = []
    bars: dict[str, list[str]] = {}
    faults: dict[str, tuple[str, ...]] = {}
    for k, (name, epoch) in enumerate(zip(short_names(s.epochs), epochs, strict=True)):
        progress("reading measurements", k / len(epochs))
        found = adjusted_as_free(block_again(epoch) if isinstance(epoch, Adjustment) else _with_coordinates(epoch))
        # dots have a number of their own in each measurement: which are asked for is known when they are called alike
        bars[name] = bar_names(found.given)
        dots = any(dot_number(p) >= 0 for p in s.points)
        if s.points and not dots and not set(s.points) & set(found.given.points.ids):
            raise InputError("measurement.unknown_points", name=name, points=list(s.points))
        sets.append(point_set(found, name, () if dots else s.points))
        if reported := _faults(epoch):
            faults[name] = reported
    if s.free_scale:
        sets = [replace(e, free_scale=True) for e in sets]
    progress("testing", 0.9)
    sets, by_place = dots_alike(sets)
    if s.points:
        sets = [e.rows([k for k, i in enumerate(e.ids) if i in set(s.points)]) for e in sets]
        _check_there(s.points, sets)
    sets, reported = comparable(sets, bars)
    done = congruence(sets, significance=s.significance, datum=s.datum_points)
    reported = (*reported, *most_moved(done), *others_as_well(done))
    done = replace(done, reported=reported, by_place=tuple(i for i in by_place if i in set(done.ids)))
    fit = None
    if nominal is not None:
        if not s.by:
            stayed = {i for i, m in zip(done.ids, done.moved, strict=True) if not m}
            nominal = nominal.rows([k for k, i in enumerate(nominal.ids) if i in stayed])
        path = s.axes or Path()
        check_unit(sets[0], nominal, path)
        fit = fitted_to(sets[0], nominal, path, by=s.by)
        _check_axes(fit, path)
        done = done.in_axes(fit.transform, fit.turn)
        done = replace(done, reported=(*done.reported, *axes_notices(fit, path.name, done.largest)))
    _write(s, done, fit, faults)
    return done


def _with_coordinates(folder: str | Path) -> Block | Path:
    """The folder, or its block where coordinates had to be found first."""
    from raybundle.commands.planning.objects import adjusted_block_in

    block, raw = adjusted_block_in(Path(folder))
    return block if raw else Path(folder)


def _check_there(points: Sequence[str], sets: Sequence[PointSet]) -> None:
    """Raise InputError for points that were asked for and that no measurement has."""
    missing = [p for p in points if not any(p in e.ids for e in sets)]
    if missing:
        raise InputError("epochs.points_unknown", points=missing)


def _check_axes(fit: BestFit, path: Path) -> None:
    """Raise InputError where the axes of a file are no axes of the measurement: mirrored, of another scale."""
    from raybundle.metrology.misfit_words import fit_values

    m = fit.misfit
    if m.scattered:
        raise InputError(Message(code="nominal_names", values=fit_values(m)), file=path)
    if m.mirrored:
        raise InputError(Message(code="nominal_mirrored", values=fit_values(m)), file=path)
    if m.scaled and abs(m.factor - 1) > OTHER_SCALE:
        raise InputError(Message(code="nominal_scale", values=fit_values(m)), file=path)


def faults_in(epochs: Sequence[Path]) -> dict[str, tuple[str, ...]]:
    """Of each measurement whose own result is not to be used yet, by its short name: the faults that it states."""
    from raybundle.io.folders import short_names
    from raybundle.results.state import faults_of

    found = {name: faults_of(epoch) for name, epoch in zip(short_names(epochs), epochs, strict=True)}
    return {name: messages for name, messages in found.items() if messages}


def _faults(epoch: Adjustment | str | Path) -> tuple[str, ...]:
    from raybundle.adjustment.records.severity import Severity

    if isinstance(epoch, str | Path):
        from raybundle.results.state import faults_of

        return faults_of(Path(epoch))
    return tuple(n.text for n in epoch.notices if n.severity is Severity.FAULT)


def _digits(columns: Mapping[str, Any]) -> dict[str, Digits]:
    """The digits of points.csv: displacements by their standard deviations, coordinates by those of the first."""
    from raybundle.io.digits import PROBABILITY, STD, TEST, by_sigma

    rules: dict[str, Digits] = {"F": TEST, "p": PROBABILITY, "detectable_mm": STD}
    for tag in sorted({n[3:-3] for n in columns if n.startswith("sdX")}):
        std = {a: columns[f"sd{a}{tag}_mm"] for a in "XYZ"}
        rules |= {f"sd{a}{tag}_mm": STD for a in "XYZ"} | {f"d{a}{tag}_mm": by_sigma(std[a]) for a in "XYZ"}
        rules[f"length{tag}_mm"] = by_sigma(sum(std[a] ** 2 for a in "XYZ") ** 0.5)
        rules = {f"{a}_m": by_sigma(std[a] / 1000) for a in "XYZ"} | rules
    return rules


def _write(
    s: MovedSettings, done: Congruence, fit: BestFit | None, faults: Mapping[str, tuple[str, ...]]
) -> None:  # fmt: skip
    import numpy as np

    from raybundle.io.digits import SHORT
    from raybundle.io.digits import reported as in_digits
    from raybundle.io.folders import new_folder
    from raybundle.io.tables import write_table
    from raybundle.results.contents import clean

    order = np.array(natural_order(done.ids), np.int64)
    std = np.sqrt(np.maximum(np.diagonal(done.covariance, axis1=2, axis2=3), 0))
    columns: dict[str, Any] = {
        "point": [done.ids[k] for k in order], "moved": ["yes" if done.moved[k] else "" for k in order],
        **{f"{a}_m": done.xyz[:, k] for k, a in enumerate("XYZ")},
    }  # fmt: skip
    for j in range(len(done.displacement)):
        tag = "" if len(done.displacement) == 1 else f"_{j + 2}"
        columns |= {f"d{a}{tag}_mm": 1000 * done.displacement[j, :, k] for k, a in enumerate("XYZ")}
        columns |= {f"sd{a}{tag}_mm": 1000 * std[j, :, k] for k, a in enumerate("XYZ")}
        columns[f"length{tag}_mm"] = 1000 * np.linalg.norm(done.displacement[j], axis=1)
    columns |= {"F": done.statistic, "p": done.p_value, "detectable_mm": 1000 * done.detectable}
    found = {
        "epochs": done.epochs, "points": len(done.ids), "moved": [done.ids[k] for k in np.flatnonzero(done.moved)],
        "significance": done.significance, "limit_of_one_point": done.limit, "degrees_of_freedom": done.freedom,
        "scale_free": done.scale, "dots_by_place": list(done.by_place),
        "axes": None if fit is None or s.axes is None else {
            "of": s.axes.name, "fitted_by": [i for i, f in zip(fit.ids, fit.fitted, strict=True) if f],
            "rms_m": fit.rms, "turn_sigma_rad": float(np.sqrt(max(float(np.linalg.eigvalsh(fit.turn)[-1]), 0.0))),
            "scale": fit.misfit.factor, "did_not_fit": [fit.asked[k] for k in fit.misfit.wrong],
        },
        "may_have_moved_instead": [{"point": a.point, "other": a.other, "F": a.F, "p": a.p} for a in done.alternatives],
        "warnings": [{"code": n.code, "severity": n.severity.value, "message": n.text} for n in done.reported],
        "record": record_of(s).as_mapping(),
        "not_to_be_used_yet": {name: list(messages) for name, messages in faults.items()},
        "all_points": {"F": done.before[0], "p": done.before[1]},
        "points_that_stayed": {"F": done.after[0], "p": done.after[1]},
        "to_the_first": [
            {"scale": t.scale, "rotation": t.rotation.tolist(), "translation_m": t.translation.tolist()}
            for t in done.transforms
        ],
    }  # fmt: skip
    with new_folder(s.out) as folder:
        ordered = {n: v if isinstance(v, list) else v[order] for n, v in columns.items()}
        write_table(folder / "points.csv", ordered, _digits(ordered))
        (folder / "moved.json").write_text(
            json.dumps(clean(in_digits(found, SHORT)), indent=1) + "\n", encoding="utf-8"
        )
        pages = [folder / name for name, asked in (("report.html", s.report), ("report.pdf", s.pdf)) if asked]
        if pages:
            from raybundle.report.moved import MovedFacts, axes_words, write_moved_report

            axes = "" if fit is None or s.axes is None else axes_words(s.axes.name, fit)
            about = MovedFacts(record=record_of(s), faults=faults, axes=axes)
            write_moved_report(done, pages, s.language, about)
