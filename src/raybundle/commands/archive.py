"""`raybundle archive`: a project as one package for deposit, described as an RO-Crate."""

from __future__ import annotations

import hashlib
import json
import zipfile
from collections.abc import Iterator, Mapping
from dataclasses import MISSING, asdict, dataclass
from datetime import UTC, datetime
from pathlib import Path
from typing import TYPE_CHECKING, Any

from raybundle.errors import InputError, Text, phrase
from raybundle.io.folders import check_free, new_files
from raybundle.numerics.progress import Progress, silent
from raybundle.settings import setting

if TYPE_CHECKING:
    from raybundle.results.record import Record

README = "README.txt"
CONTENTS_OF = (
    "result", "surface", "facade", "photographs", "project.toml", "measurements.json", "photographs.sha256",
    "checksums.sha256", "ro-crate-metadata.json",
)  # fmt: skip
CRATE, CHECKSUMS = "ro-crate-metadata.json", "checksums.sha256"
PHOTOGRAPHS, MEASUREMENTS = "photographs.sha256", "measurements.json"
SPECIFICATION = "https://w3id.org/ro/crate/1.1"
NEEDED = ("title", "operator", "object", "place", "rights", "archive")
"""Entries of the record for what DataCite makes mandatory and an archive asks first"""
TYPES = {
    ".csv": "text/csv", ".json": "application/json", ".html": "text/html", ".pdf": "application/pdf",
    ".toml": "application/toml", ".txt": "text/plain", ".tif": "image/tiff", ".jpg": "image/jpeg", ".png": "image/png",
    ".parquet": "application/vnd.apache.parquet", ".laz": "application/vnd.laszip", ".ply": "application/ply",
    ".sha256": "text/plain",
}  # fmt: skip
STORED = frozenset({".jpg", ".jpeg", ".png", ".laz", ".parquet", ".heic", ".pdf"})
"""Files that do not become smaller"""
BLOCK = 1 << 20


@dataclass(frozen=True, slots=True, kw_only=True)
class ArchiveSettings:
    """What goes into the package, and where it goes."""

    source: Path
    """project or result folder"""
    out: Path = setting(MISSING, "New package, NAME.zip.", metavar="NAME.zip")
    with_photographs: bool = setting(False, "Also put the photographs into the package; their checksums always are.")
    with_surface: bool = setting(False, "Also put the products of `surface` and `facade` into the package.")


@dataclass(frozen=True, slots=True, kw_only=True)
class Archive:
    """A written package."""

    file: Path
    files: int
    bytes: int
    notices: tuple[Text, ...] = ()
    """entries of the record that an archive asks for, and photographs that are not there"""


def archive(
    source: str | Path, out: str | Path, *, with_photographs: bool = False, with_surface: bool = False
) -> Archive:
    """Write a project as one package for deposit: the current result, its record, parameters and checksums.

    The package is an RO-Crate 1.1: `ro-crate-metadata.json` describes it in the terms of schema.org, from which
    repositories take those of DataCite.

    source            project or result folder
    out               new file, NAME.zip
    with_photographs  whether the photographs are in it; their checksums are in any case
    with_surface      whether the products of `surface` and `facade` are in it
    raises            InputError where there is no result
    """
    settings = ArchiveSettings(
        source=Path(source), out=Path(out), with_photographs=with_photographs, with_surface=with_surface
    )
    return run_archive(settings)


def run_archive(s: ArchiveSettings, progress: Progress = silent) -> Archive:
    """Write what the settings ask for."""
    from raybundle.commands.record import known_record
    from raybundle.workflows.sources import result_within

    if s.out.suffix.lower() != ".zip":
        raise InputError("file.suffix", known=[".zip"], file=s.out)
    check_free(s.out)
    result = result_within(s.source)
    if not (result / "result.json").is_file():
        raise InputError("result.none_in_folder", file=s.source)
    notices: list[Text] = []
    given = known_record(result)
    lacking = [n for n in NEEDED if not given.as_mapping().get(n)]
    if lacking:
        notices.append(phrase("deposit.entries_missing", n=len(lacking), names=lacking))
    files = dict(_files(s, result))
    hashes, lost = _photographs(s, result, files)
    if lost:
        notices.append(phrase("deposit.photographs_missing", n=len(lost), names=lost))
    sizes, sums = dict[str, int](), dict[str, str]()
    with new_files(s.out) as (target,), zipfile.ZipFile(target, "w") as package:
        for k, (name, file) in enumerate(files.items()):
            progress("packing", k / len(files))
            sizes[name], sums[name] = _put(package, name, file)
        texts = {PHOTOGRAPHS: "".join(f"{h}  {n}\n" for n, h in hashes.items())} if hashes else {}
        texts |= _measurements(s.source)
        sizes |= {name: len(text.encode()) for name, text in texts.items()}
        texts[README] = _readme(sizes)
        sizes[README] = len(texts[README].encode())
        texts[CRATE] = _crate(given, result, sizes)
        for name, text in texts.items():
            sums[name] = hashlib.sha256(text.encode()).hexdigest()
        texts[CHECKSUMS] = "".join(f"{h}  {n}\n" for n, h in sorted(sums.items()))
        for name, text in texts.items():
            package.writestr(name, text, zipfile.ZIP_DEFLATED)
    progress("packing", 1.0)
    return Archive(file=s.out, files=len(files) + len(texts), bytes=s.out.stat().st_size, notices=tuple(notices))


def _files(s: ArchiveSettings, result: Path) -> Iterator[tuple[str, Path]]:
    """Names in the package and the files that stand there."""
    from raybundle.results.folder import PROJECT
    from raybundle.results.project_results import project_of

    folders = [result]
    project = project_of(s.source)
    if project is not None:
        if (project / "project.toml").is_file():
            yield "project.toml", project / "project.toml"
        if s.with_surface:
            folders += [f for name in ("surface", "facade") if (f := project / name).is_dir()]
    for folder in folders:
        name = "result" if folder == result else folder.name
        for file in sorted(folder.rglob("*")):
            inner = file.relative_to(folder)
            kept = not {PROJECT, "work"} & {inner.parts[0]} and not any(p.startswith(".") for p in inner.parts)
            if file.is_file() and kept:
                yield f"{name}/{inner.as_posix()}", file


def _photographs(s: ArchiveSettings, result: Path, files: dict[str, Path]) -> tuple[dict[str, str], list[str]]:
    """Checksums of the photographs by name, and those that are not there; where wanted they join the files."""
    from raybundle.io.block.folder import read_block
    from raybundle.io.reading.trees import read_json
    from raybundle.measuring.actions.masks import photograph_files
    from raybundle.pipeline.project import photographs_of
    from raybundle.workflows.photograph_contents import CONTENTS

    tree = read_json(result / "result.json")
    stated = {n: h.text() for n, h in tree.get(CONTENTS).mapping().items()} if tree.has(CONTENTS) else {}
    block = read_block(result / "block")
    there = photograph_files(block, photographs_of(s.source) or photographs_of(result))
    names = [n for n in block.images.file if n]
    hashes = {n: stated.get(n) or _hash(there[n]) for n in names if n in stated or n in there}
    if s.with_photographs:
        files |= {f"photographs/{n}": path for n, path in there.items()}
    return hashes, [n for n in names if n not in (there if s.with_photographs else hashes)]


def _measurements(source: Path) -> dict[str, str]:
    """The journal of what was measured by hand, as a text; nothing where there is none."""
    from raybundle.measuring.journal import entries_of, journal_path

    path = journal_path(source)
    rows = [asdict(e) for e in entries_of(path)] if path.is_file() else []
    return {MEASUREMENTS: json.dumps(rows, indent=1, ensure_ascii=False) + "\n"} if rows else {}


def _readme(sizes: Mapping[str, int]) -> str:
    """What stands at the top of the package."""
    there = {*(name.partition("/")[0] for name in sizes), CHECKSUMS, CRATE}
    rows = ((n, phrase("deposit.content", entry=n.replace(".", "_").replace("-", "_"))) for n in CONTENTS_OF)
    return "".join(f"{name:26s}{words}\n" for name, words in rows if name in there)


def _hash(file: Path) -> str:
    with file.open("rb") as data:
        return hashlib.file_digest(data, "sha256").hexdigest()


def _put(package: zipfile.ZipFile, name: str, file: Path) -> tuple[int, str]:
    """Put a file into the package; its size and checksum."""
    info = zipfile.ZipInfo.from_file(file, name, strict_timestamps=False)
    info.compress_type = zipfile.ZIP_STORED if file.suffix.lower() in STORED else zipfile.ZIP_DEFLATED
    found, size = hashlib.sha256(), 0
    with file.open("rb") as data, package.open(info, "w", force_zip64=True) as out:
        while block := data.read(BLOCK):
            out.write(block)
            found.update(block)
            size += len(block)
    return size, found.hexdigest()


def _crate(given: Record, result: Path, sizes: Mapping[str, int]) -> str:
    """The description: https://w3id.org/ro/crate/1.1."""
    from raybundle import __version__

    r = given.as_mapping()
    now = datetime.now(UTC).replace(microsecond=0).isoformat()
    made_at = datetime.fromtimestamp((result / "result.json").stat().st_mtime, UTC).replace(microsecond=0).isoformat()
    people = [{"@id": f"#person-{k}"} for k, _ in enumerate(_names(given.operator), 1)]
    properties = [
        {"@type": "PropertyValue", "@id": f"#{n}", "name": n, "value": r[n]}
        for n in ("kind", "dating", "persons", "materials", "condition", "protection") if n in r
    ]  # fmt: skip
    root: dict[str, Any] = {
        "@id": "./", "@type": "Dataset", "name": r.get("title") or result.resolve().parent.name,
        "description": r.get("description") or _words(given), "datePublished": now[:10],
        "license": r.get("rights", ""), "author": people, "identifier": r.get("reference", ""),
        "temporalCoverage": r.get("date", ""), "hasPart": [{"@id": name} for name in sizes],
        "about": {"@id": "#object"}, "mentions": {"@id": "#adjustment"},
        **({"publisher": {"@id": "#archive"}} if "archive" in r else {}),
        **({"funder": {"@id": "#client"}} if "client" in r else {}),
    }  # fmt: skip
    context: list[dict[str, Any]] = [
        {"@id": CRATE, "@type": "CreativeWork", "conformsTo": {"@id": SPECIFICATION}, "about": {"@id": "./"}},
        {k: v for k, v in root.items() if v not in ("", [])},
        *({"@id": name, "@type": "File", "contentSize": str(size), **_type(name)} for name, size in sizes.items()),
        {"@id": "#object", "@type": "Thing", "name": r.get("object") or root["name"],
         **({"description": r["description"]} if "description" in r else {}),
         "additionalProperty": [{"@id": p["@id"]} for p in properties],
         **({"location": {"@id": "#place"}} if "place" in r else {})},
        *properties,
        *({"@id": f"#person-{k}", "@type": "Person", "name": n} for k, n in enumerate(_names(given.operator), 1)),
        *({"@id": f"#{n}", "@type": kind, "name": r[n]}
          for n, kind in (("place", "Place"), ("archive", "Organization"), ("client", "Organization")) if n in r),
        {"@id": "https://pypi.org/project/raybundle", "@type": "SoftwareApplication", "name": "raybundle",
         "softwareVersion": __version__, "url": "https://pypi.org/project/raybundle"},
        {"@id": "#adjustment", "@type": "CreateAction", "name": phrase("deposit.adjustment"), "endTime": made_at,
         "instrument": {"@id": "https://pypi.org/project/raybundle"}, "agent": people,
         "object": [{"@id": PHOTOGRAPHS}] if PHOTOGRAPHS in sizes else [],
         "result": [{"@id": "result/result.json"}],
         **{name: r[n] for n, name in (("instruments", "description"), ("conditions", "disambiguatingDescription"))
            if n in r}},
    ]  # fmt: skip
    made = {"@context": f"{SPECIFICATION}/context", "@graph": context}
    return json.dumps(made, indent=1, ensure_ascii=False) + "\n"


def _names(persons: str) -> list[str]:
    return [name.strip() for name in persons.replace(";", ",").split(",") if name.strip()]


def _words(given: Record) -> str:
    """What the package holds, where nobody described it."""
    return phrase("deposit.description", of=[w for w in (given.object, given.place) if w])


def _type(name: str) -> dict[str, str]:
    kind = TYPES.get(Path(name).suffix.lower())
    return {"encodingFormat": kind} if kind else {}
