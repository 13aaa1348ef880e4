"""The results of a project: the current one, and those that it replaced.

    PROJECT/result            the current result, whichever command made it
    PROJECT/results/1-orient  earlier ones: a number, and the command that made them

A result with marks states the result that they were merged into: marks are always merged into that one, and
a mark that is taken back leaves nothing behind.
"""

from __future__ import annotations

import os
import re
import shutil
from collections.abc import Generator
from contextlib import contextmanager
from dataclasses import dataclass
from datetime import UTC, datetime
from pathlib import Path

from raybundle.errors import InputError
from raybundle.io.folders import new_folder
from raybundle.io.reading.trees import Json, read_json
from raybundle.results.fingerprint import fingerprint
from raybundle.results.folder import PROJECT as FINISHED

RESULT, EARLIER = "result", "results"
"""Folders of a project"""
MADE = "made"
"""Key of result.json: the command that made a result of a project, and the result that marks were merged into"""
ORIENT, MARKS, ADJUST, EPOCHS = "orient", "marks", "adjust", "epochs"
MOST = 8
"""Earlier results that are kept, beside the one that marks are merged into; the oldest make room."""
_NAME = re.compile(r"([0-9]+)-(orient|marks|adjust|epochs)")


@dataclass(frozen=True, slots=True, kw_only=True)
class Made:
    """What made a result."""

    by: str = ORIENT
    base: str = ""
    """name of the earlier result that marks were merged into; empty: there are none in it"""

    def as_addition(self) -> dict[str, object]:
        """The key of result.json; none of what `orient` made without marks."""
        if self == Made():
            return {}
        return {MADE: {"by": self.by, **({"base": self.base} if self.base else {})}}


def made_of(result: Path) -> Made:
    """What made a result folder; that of `orient` states nothing."""
    try:
        tree = read_json(result / "result.json")
        return _made(tree) if tree.has(MADE) else Made()
    except InputError:
        return Made()


def _made(tree: Json) -> Made:
    made = tree.get(MADE)
    by, base = (made.get(name).text() if made.has(name) else "" for name in ("by", "base"))
    return Made(by=by if by in {MARKS, ADJUST, EPOCHS} else ORIENT, base=base if _NAME.fullmatch(base) else "")


def own_result(source: Path) -> Path | None:
    """The current result folder of a project, or a result folder itself; None where there is none."""
    return next((f for f in (source / RESULT, source) if (f / "result.json").is_file()), None)


def project_of(folder: str | Path) -> Path | None:
    """The project folder that a folder is, or of which it is a result (or the block of one)."""
    folder = Path(folder)
    if (folder / "project.db").is_file():
        return folder
    whole = folder.resolve()  # "." and "a/.." have no name of their own
    result = whole.parent if whole.name == "block" else whole
    project = result.parent if result.name == RESULT else result.parent.parent
    own = result.name == RESULT or (result.parent.name == EARLIER and _NAME.fullmatch(result.name))
    return project if own and (project / "project.db").is_file() else None


def base_result(project: Path) -> Path | None:
    """The result of a project that marks are merged into; None: there is none without marks.

    raises  InputError where it is gone or damaged
    """
    current = project / RESULT
    if not (current / "result.json").is_file():
        return None
    if not _whole(current):
        raise InputError("project.result_damaged", n=len(earlier_results(project)), file=current)
    made = made_of(current)
    if made.base:
        base = project / EARLIER / made.base
        if not _whole(base):
            raise InputError("project.base_missing", file=base)
        return base
    return None if made.by == MARKS else current


def language_of_result(project: Path) -> str:
    """The language of the report of the current result; empty where it states none."""
    try:
        tree = read_json(project / RESULT / "result.json")
        return tree.get("language").text() if tree.has("language") else ""
    except InputError:
        return ""


def _whole(result: Path) -> bool:
    """Whether a folder is a result with its block."""
    try:
        return read_json(result / "result.json").has("sigma0") and (result / "block" / "block.toml").is_file()
    except InputError:
        return False


def earlier_results(project: Path) -> list[Path]:
    """The results that were replaced, newest first."""
    return [p for p in _numbered(project) if (p / "result.json").is_file()]


def _numbered(project: Path) -> list[Path]:
    """What is called as an earlier result, by number, the largest first."""
    folder = project / EARLIER
    found = [p for p in folder.iterdir() if _NAME.fullmatch(p.name)] if folder.is_dir() else []
    return sorted(found, key=lambda p: -_number(p))


def _number(result: Path) -> int:
    return int(result.name.partition("-")[0])


@dataclass(frozen=True, slots=True, kw_only=True)
class Kept:
    """A result of a project in figures."""

    path: Path
    by: str
    """the command that made it"""
    written: str
    """UTC, ISO 8601"""
    sigma0: float | None
    redundancy: int | None
    scale: bool
    """whether something determines the scale"""


def kept_results(project: Path) -> list[Kept]:
    """The current result, then the earlier ones, newest first; what cannot be read is passed over."""
    current = project / RESULT
    others = [p for p in earlier_results(project) if not _same(p, current)]
    return [k for p in (current, *others) for k in _in_figures(p)]


def _same(first: Path, second: Path) -> bool:
    """Whether two folders hold one result: the first of a run that was killed before it replaced the second."""
    a, b = first / "result.json", second / "result.json"
    try:
        return a.samefile(b) or a.read_bytes() == b.read_bytes()
    except OSError:
        return False


def _in_figures(result: Path) -> list[Kept]:
    try:
        file = result / "result.json"
        tree, stamp = read_json(file), datetime.fromtimestamp(file.stat().st_mtime, UTC)
        sigma0, redundancy = (tree.get(name).value if tree.has(name) else None for name in ("sigma0", "redundancy"))
        open_ = tree.get("datum_defect").value if tree.has("datum_defect") else []
    except (InputError, OSError):
        return []
    by = _NAME.fullmatch(result.name)
    return [Kept(
        path=result, by=by.group(2) if by else made_of(result).by, written=f"{stamp:%Y-%m-%dT%H:%M:%SZ}",
        sigma0=float(sigma0) if isinstance(sigma0, int | float) else None,
        redundancy=redundancy if isinstance(redundancy, int) else None,
        scale=isinstance(open_, list) and "scale" not in open_,
    )]  # fmt: skip


@contextmanager
def replacing(project: Path, by: str, *, marks: bool) -> Generator[Made]:
    """Keep the current result among the earlier ones while another one takes its place; yields what that one states.

    marks  whether marks are merged in the new one

    Where the new result has the same orientations, cameras and files, or is not written, nothing is kept. Files are
    linked where the file system can: results are replaced whole, never changed.
    """
    current, before, made = project / RESULT, fingerprint(project / RESULT), made_of(project / RESULT)
    there = set(earlier_results(project))
    kept = _kept(project, made.by)
    base = made.base or (kept.name if kept is not None and made.by != MARKS else "")
    try:
        yield Made(by=by, base=base if marks else "")
    except BaseException:
        if kept is not None and kept not in there:
            shutil.rmtree(kept, ignore_errors=True)
        raise
    whole = kept is not None and {p.name for p in kept.iterdir()} <= {p.name for p in current.iterdir()}
    if kept is not None and whole and kept.name != made_of(current).base and fingerprint(current) == before:
        shutil.rmtree(kept, ignore_errors=True)
    _forget_oldest(project)


def _kept(project: Path, by: str) -> Path | None:
    """A copy of the current result; None where there is none."""
    current = project / RESULT
    if not (current / "result.json").is_file():
        return None
    last = next(iter(earlier_results(project)), None)
    if last is not None and _same(last, current):
        return last
    kept = new_place(project, by)
    with new_folder(kept) as folder:
        left = shutil.ignore_patterns(FINISHED)
        shutil.copytree(current, folder, copy_function=linked, ignore=left, dirs_exist_ok=True)
    return kept


def new_place(project: Path, by: str) -> Path:
    """Where a further result among the earlier ones stands."""
    last = max(map(_number, _numbered(project)), default=0)
    return project / EARLIER / f"{last + 1}-{by}"


def _forget_oldest(project: Path) -> None:
    """Delete the oldest of the earlier results beyond `MOST`."""
    base = project / EARLIER / made_of(project / RESULT).base
    for old in [p for p in earlier_results(project) if p != base][MOST:]:
        shutil.rmtree(old, ignore_errors=True)


def linked(source: str, target: str) -> None:
    """The file under another name, which costs nothing, or a copy."""
    try:
        os.link(source, target)
    except OSError:
        shutil.copy2(source, target)
