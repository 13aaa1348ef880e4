"""`raybundle moved`: which points have moved between measurements, by the congruence test."""

from __future__ import annotations

import json
from collections.abc import Sequence
from dataclasses import MISSING, dataclass, replace
from pathlib import Path
from typing import TYPE_CHECKING, Any

from raybundle.errors import InputError
from raybundle.numerics.progress import Progress, silent
from raybundle.settings import Range, made, setting

if TYPE_CHECKING:
    from raybundle.adjustment.result import Adjustment
    from raybundle.metrology.congruence import Congruence


@dataclass(frozen=True, slots=True, kw_only=True)
class MovedSettings:
    """Measurements of the same points at different times, and how they are held against each other."""

    epochs: tuple[Path, ...]
    """results, projects or blocks, in the order of time"""
    out: Path = setting(MISSING, "New folder: points.csv, moved.json.", metavar="FOLDER")
    datum: tuple[str, ...] = setting(
        (), "Points that are known to have stayed; all after this word.  [default: found by the test]", metavar="POINT"
    )
    points: tuple[str, ...] = setting(
        (), "Take these points alone.  [default: all that have a name of their own]", metavar="POINT"
    )
    significance: float = setting(
        0.05, "Probability that any point is called moved where none did.", limits=Range(low=1e-6, high=0.5)
    )
    free_scale: bool = setting(False, "Epochs may differ in scale, though bars or control measured it.")


def moved_points(
    epochs: Sequence[Adjustment | str | Path], out: str | Path, *, progress: Progress = silent, **settings: Any
) -> Congruence:
    """Test which points moved between results of the same points, and write what came of it.

    epochs    two or more results (folders, or adjustments), in the order of time; points are the same by their names
    out       new folder: points.csv (displacements with standard deviations), moved.json
    settings  as of the command line, by the names of `MovedSettings`
    raises    InputError for fewer than four common points, or points that are held without error
    What it does not tell: a motion that all points share.
    """
    names = tuple(Path(e) if isinstance(e, str | Path) else Path(f"epoch {k + 1}") for k, e in enumerate(epochs))
    asked = made(MovedSettings, {"epochs": names, "out": Path(out), **settings})
    return _moved(asked, epochs, progress)


def run_moved(settings: MovedSettings, progress: Progress = silent) -> Congruence:
    """Test and write what the settings ask for."""
    return _moved(settings, settings.epochs, progress)


def _moved(s: MovedSettings, epochs: Sequence[Adjustment | str | Path], progress: Progress) -> Congruence:
    from raybundle.adjustment.again import block_again  # noqa: PLC0415
    from raybundle.adjustment.result import Adjustment  # noqa: PLC0415  (what computes is loaded after the help)
    from raybundle.io.folders import check_new_folder  # noqa: PLC0415
    from raybundle.measuring.point_sets import point_set  # noqa: PLC0415
    from raybundle.measuring.session import adjusted_as_free  # noqa: PLC0415
    from raybundle.metrology.congruence import congruence  # noqa: PLC0415

    if len(epochs) < 2:
        raise InputError("two or more measurements are held against each other; one is given")
    check_new_folder(s.out)
    sets = []
    for k, (name, epoch) in enumerate(zip(_names(s.epochs), epochs, strict=True)):
        progress("reading measurements", k / len(epochs))
        found = adjusted_as_free(block_again(epoch) if isinstance(epoch, Adjustment) else epoch)
        sets.append(point_set(found, name, s.points))
    if s.free_scale:
        sets = [replace(e, free_scale=True) for e in sets]
    progress("testing", 0.9)
    done = congruence(sets, significance=s.significance, datum=s.datum)
    _write(s.out, done)
    return done


def _names(paths: Sequence[Path]) -> list[str]:
    """Short names of the epochs that differ."""
    short = [p.name or str(p) for p in paths]
    return short if len(set(short)) == len(short) else [str(p) for p in paths]


def _write(out: Path, done: Congruence) -> None:
    import numpy as np  # noqa: PLC0415

    from raybundle.io.folders import new_folder  # noqa: PLC0415
    from raybundle.io.tables import write_table  # noqa: PLC0415
    from raybundle.results.contents import clean  # noqa: PLC0415

    std = np.sqrt(np.maximum(np.diagonal(done.covariance, axis1=2, axis2=3), 0))
    columns: dict[str, Any] = {"point": done.ids, "moved": ["yes" if m else "" for m in done.moved]}
    for j in range(len(done.displacement)):
        tag = "" if len(done.displacement) == 1 else f"_{j + 2}"
        columns |= {f"d{a}{tag}_mm": 1000 * done.displacement[j, :, k] for k, a in enumerate("XYZ")}
        columns |= {f"sd{a}{tag}_mm": 1000 * std[j, :, k] for k, a in enumerate("XYZ")}
        columns[f"length{tag}_mm"] = 1000 * np.linalg.norm(done.displacement[j], axis=1)
    columns |= {"F": done.statistic, "p": done.p_value, "detectable_mm": 1000 * done.detectable}
    told = {
        "epochs": done.epochs, "points": len(done.ids), "moved": [done.ids[k] for k in np.flatnonzero(done.moved)],
        "significance": done.significance, "limit_of_one_point": done.limit, "degrees_of_freedom": done.freedom,
        "scale_free": done.scale,
        "all_points": {"F": done.before[0], "p": done.before[1]},
        "points_that_stayed": {"F": done.after[0], "p": done.after[1]},
        "to_the_first": [
            {"scale": t.scale, "rotation": t.rotation.tolist(), "translation_m": t.translation.tolist()}
            for t in done.transforms
        ],
    }  # fmt: skip
    with new_folder(out) as folder:
        write_table(folder / "points.csv", columns)
        (folder / "moved.json").write_text(json.dumps(clean(told), indent=1) + "\n", encoding="utf-8")
