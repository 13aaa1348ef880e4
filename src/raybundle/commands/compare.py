"""`raybundle compare`: two result folders side by side in an HTML file."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING

from raybundle.errors import InputError
from raybundle.numerics.progress import Progress, silent
from raybundle.settings import setting

if TYPE_CHECKING:
    from raybundle.results.folder import ResultFolder


@dataclass(frozen=True, slots=True, kw_only=True)
class CompareSettings:
    """Which results are compared, and where the comparison goes; in Python `raybundle.write_comparison` takes them."""

    first: Path
    """result folder or project"""
    second: Path | None = None
    """the same; None: the current result of the project `first`, which itself stands for the one before"""
    out: Path = setting(
        Path("compare.html"), "HTML file to write. Only an older comparison is replaced.", metavar="FILE"
    )


@dataclass(frozen=True, slots=True, kw_only=True)
class Compared:
    """Two results, and what is to be kept in mind where they are compared."""

    results: tuple[ResultFolder, ResultFolder]
    cautions: tuple[str, ...]
    same: str = ""
    """how near the numbers of both are, in words"""


def run_compare(settings: CompareSettings, progress: Progress = silent) -> Compared:
    """Read both results and write the comparison; raises InputError."""
    from raybundle.report.comparison.page import write_comparison
    from raybundle.report.comparison.sameness import sameness
    from raybundle.results.folder import read_result

    out = settings.out
    if out.is_dir() or out.suffix.lower() not in {".html", ".htm"}:
        raise InputError("file.suffix", known=[".html", ".htm"], file=out)
    if not out.absolute().parent.is_dir():
        raise InputError("folder.missing", file=out)
    progress("reading results", 0.0)
    first, second = _compared(settings)
    a, b = read_result(first), read_result(second)
    progress("comparing", 0.0)
    cautions = tuple(write_comparison(a, b, out))
    return Compared(results=(a, b), cautions=cautions, same=sameness(a.path, b.path).sentence)


def _compared(settings: CompareSettings) -> tuple[Path, Path]:
    """The two result folders; of one project alone the one before and the current one."""
    from raybundle.results.project_results import earlier_results, made_of
    from raybundle.workflows.sources import result_within

    if settings.second is not None:
        return result_within(settings.first), result_within(settings.second)
    current = result_within(settings.first)
    earlier = earlier_results(settings.first)
    if not earlier:
        raise InputError("comparison.one_result", file=settings.first)
    base = made_of(current).base  # of one run with the current one
    return next((p for p in earlier if p.name != base), earlier[0]), current
