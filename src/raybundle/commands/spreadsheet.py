"""`raybundle spreadsheet`: the tables of a result as one workbook."""

from __future__ import annotations

from dataclasses import MISSING, dataclass
from pathlib import Path

from raybundle.errors import InputError, phrase
from raybundle.io.folders import check_free
from raybundle.numerics.progress import Progress, silent
from raybundle.settings import setting

FIRST = (
    "coordinate_list", "nominal", "lengths", "map", "map_control", "points", "control", "check", "distances", "images",
    "cameras", "parameters",
)  # fmt: skip
"""Tables that stand first, in this order; the others follow by name."""
SUFFIX = ".xlsx"


@dataclass(frozen=True, slots=True, kw_only=True)
class SpreadsheetSettings:
    """Which tables, and where they go."""

    source: Path
    """folder with tables: a result, a project, what `moved` or `measure` wrote"""
    out: Path = setting(MISSING, "New workbook, FILE.xlsx.", metavar="FILE")
    tables: tuple[str, ...] = setting(
        (), "Only these tables. Give file names without .csv.  [default: all that have rows]",
        metavar="A,B,C,...", joined=True,
    )  # fmt: skip


@dataclass(frozen=True, slots=True, kw_only=True)
class Spreadsheet:
    """A written workbook."""

    file: Path
    sheets: tuple[str, ...]
    left_out: tuple[str, ...]
    """tables that no sheet holds, and why"""


def spreadsheet(source: str | Path, out: str | Path, *, tables: tuple[str, ...] = ()) -> Spreadsheet:
    """Write the tables of a folder as sheets of one workbook (.xlsx).

    source  a result or a project, or what `moved` or `measure` wrote
    out     new file
    tables  these alone, by the names of their files without .csv; (): all that have rows
    raises  InputError for a folder without tables, and for a name that is none of them
    Limits: tables that are longer than a sheet's 1 048 575 rows are left out and named.
    """
    return run_spreadsheet(SpreadsheetSettings(source=Path(source), out=Path(out), tables=tables))


def run_spreadsheet(s: SpreadsheetSettings, progress: Progress = silent) -> Spreadsheet:
    """Write what the settings ask for."""
    from raybundle.io.workbook import ROWS, has_rows, write_workbook
    from raybundle.measuring.selection import latest_result

    check_free(s.out)
    if s.out.suffix.lower() != SUFFIX:
        raise InputError("file.suffix", known=[SUFFIX], file=s.out)
    folder = s.source
    if not folder.is_dir():
        raise InputError("result.no_folder", file=folder)
    found = _tables(folder)
    if not found and (result := latest_result(folder)) is not None:
        folder = result
        found = _tables(folder)
    strange = [name for name in s.tables if name.removesuffix(".csv") not in found]
    if strange:
        raise InputError("workbook.unknown_table", table=strange[0], n=len(found), known=list(found), file=folder)
    wanted = [name.removesuffix(".csv") for name in s.tables] or _in_order(found)
    left: list[str] = []
    taken: list[tuple[str, Path]] = []
    for k, name in enumerate(wanted):
        progress("reading tables", k / len(wanted))
        file = found[name]
        if file.suffix != ".csv":
            left.append(phrase("workbook.left_out", name=file.name, cause="parquet", rows=ROWS - 1))
        elif not has_rows(file):
            if s.tables:
                left.append(phrase("workbook.left_out", name=file.name, cause="empty", rows=ROWS - 1))
        elif _longer(file, ROWS):
            left.append(phrase("workbook.left_out", name=file.name, cause="rows", rows=ROWS - 1))
        else:
            taken.append((name, file))
    if not taken:
        raise InputError("workbook.no_table", file=folder)
    names = write_workbook(s.out, taken, title=s.source.resolve().name)
    progress("writing", 1.0)
    return Spreadsheet(file=s.out, sheets=tuple(names), left_out=tuple(left))


def _tables(folder: Path) -> dict[str, Path]:
    """The tables that stand in a folder, by name."""
    return {f.stem: f for suffix in (".parquet", ".csv") for f in sorted(folder.glob(f"*{suffix}"))}


def _in_order(found: dict[str, Path]) -> list[str]:
    return [*(n for n in FIRST if n in found), *sorted(n for n in found if n not in FIRST)]


def _longer(file: Path, rows: int) -> bool:
    """Whether a table has more lines than a sheet has rows."""
    if file.stat().st_size < 2 * rows:
        return False
    with file.open("rb") as data:
        return sum(1 for _ in data) > rows
