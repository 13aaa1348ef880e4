"""`raybundle record`: the recording sheet of a project."""

from __future__ import annotations

from dataclasses import dataclass, fields
from pathlib import Path
from typing import TYPE_CHECKING, Any

from raybundle.commands.record_settings import record_in
from raybundle.errors import InputError, phrase
from raybundle.results.record import NAMES, RECORD, RECORD_FILE, Record, checked
from raybundle.settings import keywords, made, path_of, setting

if TYPE_CHECKING:
    from raybundle.io.reading.trees import Json
    from raybundle.results.recording_sheet import KnownByPhotographs


def _entry(words: str) -> Any:
    return setting(None, words, metavar="TEXT")


@dataclass(frozen=True, slots=True, kw_only=True)
class RecordSettings:
    """Entries to write; an empty text takes one away, what is not named stays."""

    project: Path
    """project folder of `orient`, or with `new` a name for one that it will make"""
    new: bool = setting(False, "Begin a new project.")
    title: str | None = _entry("Title of the delivery.")
    object: str | None = _entry("Name of the object.")
    place: str | None = _entry("Place of the object: address, parish, country.")
    reference: str | None = _entry("Numbers of inventories and of the order.")
    kind: str | None = _entry("Kind and former use of the object.")
    dating: str | None = _entry("Period, century or years.")
    persons: str | None = _entry("Persons who made, owned or changed the object.")
    materials: str | None = _entry("Materials and techniques.")
    condition: str | None = _entry("Condition of the object.")
    protection: str | None = _entry("Legal status.")
    description: str | None = _entry("Further remarks.")
    client: str | None = _entry("Client of the delivery.")
    purpose: str | None = _entry("Purpose of the recording.")
    operator: str | None = _entry("Persons who photographed or adjusted.")
    date: str | None = _entry("Date of the photographs.  [default: from the photographs]")
    instruments: str | None = _entry("Cameras, lenses, receivers, bars.  [default: from the photographs]")
    conditions: str | None = _entry("Weather, light and access.")
    control: str | None = setting(
        None, "Measurement of scale, control and vertical.", metavar="TEXT", flag="georeferencing", also=("control",)
    )
    rights: str | None = _entry("Licence or owner of the result.")
    archive: str | None = _entry("Archive of the recording: name and place.")


@dataclass(frozen=True, slots=True, kw_only=True)
class Recorded:
    """A recording sheet."""

    record: Record
    known: KnownByPhotographs | None
    """from the photographs; None: the project has no result yet"""
    files: tuple[Path, ...] = ()
    """that were written"""


@keywords(RecordSettings)
def record(project: str | Path, **entries: Any) -> Recorded:
    """The recording sheet of a project, with these entries written into project.toml, table [record].

    project  project folder of `orient`, or with new=True a name for one that it will make; a result there gets
             record.toml
    entries  by the names of `Record`: client="Monument office", place="Göttingen"; "" takes an entry away
    raises   InputError where something else stands there, or project.toml cannot be read

    A run of `orient` keeps them; the report has them from its next writing on.
    """
    return run_record(made(RecordSettings, {"project": path_of("project", project), **entries}))


def run_record(settings: RecordSettings) -> Recorded:
    """Write the entries that are given, and show all."""
    from raybundle.results.recording_sheet import read_recorded, recorded_text

    folder = settings.project
    given = {n: checked(n, v) for n in NAMES if (v := getattr(settings, n)) is not None}
    _check_project(folder, begins=settings.new and any(given.values()))
    reported = record_in(folder)
    result = folder / "result"
    _, known = read_recorded(result)
    if not given:
        return Recorded(record=reported, known=known)
    reported = Record(**{**reported.as_mapping(), **given})
    files = [_write(folder, reported)]
    if result.is_dir():
        text = recorded_text(reported.over(record_of_run(folder)), known)
        _replace(result / RECORD_FILE, text)
        files.append(result / RECORD_FILE)
    return Recorded(record=reported, known=known, files=tuple(files))


def _check_project(folder: Path, *, begins: bool) -> None:
    """Raise InputError where there is no project, and entries do not begin one in a folder that is not there yet."""
    if (folder / "project.db").is_file():
        return
    if folder.exists() and (not folder.is_dir() or any(folder.iterdir())):
        raise InputError(
            "project.not_a_project",
            file=folder,
        )
    if not begins:
        near = _projects_like(folder)
        raise InputError("project.missing", n=len(near), near=[str(p) for p in near], file=folder)


def _projects_like(folder: Path) -> list[Path]:
    """Projects beside a folder that is none, those of the most similar names first."""
    from difflib import get_close_matches

    parent = folder.absolute().parent
    names = [p.name for p in parent.iterdir() if (p / "project.db").is_file()] if parent.is_dir() else []
    return [folder.with_name(name) for name in get_close_matches(folder.name, names)]


def _write(folder: Path, reported: Record) -> Path:
    from raybundle.pipeline.project import Project
    from raybundle.pipeline.settings_file import with_entries

    file = folder / "project.toml"
    project = Project.open(folder)
    try:
        project.write_settings(with_entries(file, RECORD, reported.as_mapping()))
    finally:
        project.close()
    return file


def _replace(file: Path, text: str) -> None:
    import uuid

    temporary = file.with_name(f".{file.name}.{uuid.uuid4().hex[:8]}")
    try:
        temporary.write_text(text, encoding="utf-8")
        temporary.replace(file)
    finally:
        temporary.unlink(missing_ok=True)


def run_of(folder: Path) -> Json | None:
    """What the last run of `orient` in a project was asked for; None where there was none."""
    from raybundle.io.reading.trees import read_toml

    file = folder / "project.toml"
    tree = read_toml(file).tree() if file.is_file() else None
    return tree.get("orient") if tree is not None and tree.has("orient") else None


def record_of_run(folder: Path) -> Record:
    """What the last run was asked to print on its first page."""
    run, names = run_of(folder), ("title", "client", "operator")
    return Record() if run is None else Record(**{n: str(run.get(n).value) for n in names if run.has(n)})


def known_record(folder: Path) -> Record:
    """What is stated of a delivery: in its project, else with its result; dates and cameras from the photographs.

    folder  a result folder, of a project or alone
    """
    from raybundle.results.project_results import project_of
    from raybundle.results.recording_sheet import read_recorded

    own, known = read_recorded(folder)
    project = project_of(folder)
    if project is not None:
        own = record_in(project).over(own)
    if known is None:
        return own
    cameras = "; ".join(c.rpartition(", ")[0] for c in known.cameras[:3])
    return own.over(Record(date=known.dates, instruments=cameras))


def rows(reported: Recorded) -> list[tuple[str, str, str]]:
    """Entry, what it states, and "from the photographs" where nobody wrote it."""
    from raybundle.results.recording_sheet import rows_of

    given = reported.record.as_mapping()
    found = [(f.name, given[f.name], "") for f in fields(RecordSettings) if f.name in given]
    source = phrase("report_record.from_photographs")
    return [*found, *([] if reported.known is None else [(n, v, source) for n, v in rows_of(reported.known)])]
