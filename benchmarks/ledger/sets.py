"""One set of the ledger: a TOML file, read and checked."""

from __future__ import annotations

import hashlib
import tomllib
from collections.abc import Mapping
from dataclasses import dataclass
from numbers import Real
from pathlib import Path
from typing import Any

MODULES = (
    "orientation", "interior orientation", "object points", "tie points", "surface", "means", "volumes", "movements",
)  # fmt: skip
"""What standard deviations are stated of"""
SOURCES = {
    "simulated": ("generator",),
    "rendered": ("arguments",),
    "files": ("folder", "repository", "commit", "checksums"),
}
"""Kind of source -> the fields that it needs"""
MEANS = (
    "simulation", "rendering", "laser total station", "published coordinates", "gantry", "geodetic control", "none",
)  # fmt: skip
"""Independent means by which a truth is known; none: halves of the set are compared with each other"""
TOP = {"name", "title", "licence", "judged", "judge", "commands", "split", "cpu_s", "source", "truth", "options"}


class BadSet(ValueError):
    """A TOML file that is no set."""


class NotHere(Exception):
    """What a set needs is not on this machine."""


@dataclass(frozen=True, slots=True, kw_only=True)
class LedgerSet:
    """A set: where it comes from, what is true of it, and how it is judged.

    judged    modules, of MODULES
    judge     name of a judge, of `judges.JUDGES`
    split     whether halves are compared, so that no independent truth is needed
    cpu_s     CPU seconds that the set takes, as measured
    options   of the judge
    """

    name: str
    title: str
    licence: str
    judged: tuple[str, ...]
    judge: str
    commands: tuple[str, ...]
    split: bool
    cpu_s: float
    source: Mapping[str, Any]
    truth: Mapping[str, Any]
    options: Mapping[str, Any]

    @property
    def independent(self) -> bool:
        """Whether the truth is known by means other than the photographs."""
        return self.truth["means"] != "none"


TYPES = {
    "source": dict,
    "truth": dict,
    "options": dict,
    "judged": list,
    "commands": list,
    "cpu_s": Real,
    "split": bool,
}
"""Fields of a set that are no text."""


def read_set(path: Path) -> LedgerSet:
    """The set of a TOML file.

    raises  BadSet with the field that is missing, unknown or wrong
    """
    try:
        found = tomllib.loads(path.read_text(encoding="utf-8"))
    except tomllib.TOMLDecodeError as error:
        raise BadSet(f"{path.name}: {error}") from error
    except UnicodeDecodeError as error:
        raise BadSet(f"{path.name}: is not UTF-8 ({error})") from error
    missing = TOP - {"options"} - set(found)
    unknown = set(found) - TOP
    if missing or unknown:
        raise BadSet(f"{path.name}: missing {sorted(missing)}, unknown {sorted(unknown)}")
    if found["name"] != path.stem:
        raise BadSet(f"{path.name}: name is {found['name']!r}; it is that of the file")
    wrong = [k for k, of in TYPES.items() if k in found and not isinstance(found[k], of)]
    if wrong:
        raise BadSet(f"{path.name}: {', '.join(f'{k} is no {TYPES[k].__name__}' for k in wrong)}")
    _check(path, found)
    return LedgerSet(
        name=found["name"], title=found["title"], licence=found["licence"], judged=tuple(found["judged"]),
        judge=found["judge"], commands=tuple(found["commands"]), split=found["split"], cpu_s=float(found["cpu_s"]),
        source=found["source"], truth=found["truth"], options=found.get("options", {}),
    )  # fmt: skip


def _check(path: Path, found: Mapping[str, Any]) -> None:
    kind, truth = found["source"].get("kind"), found["truth"]
    wrong = [m for m in found["judged"] if m not in MODULES]
    if wrong or not found["judged"]:
        raise BadSet(f"{path.name}: judged has {wrong or 'nothing'}; take some of {', '.join(MODULES)}")
    if kind not in SOURCES:
        raise BadSet(f"{path.name}: source.kind is {kind!r}; take one of {', '.join(SOURCES)}")
    lost = [name for name in SOURCES[kind] if name not in found["source"]]
    if lost:
        raise BadSet(f"{path.name}: source of kind {kind} needs {', '.join(lost)}")
    if truth.get("means") not in MEANS or not {"what", "sigma"} <= set(truth):
        raise BadSet(f"{path.name}: truth needs what, sigma, and means of {', '.join(MEANS)}")
    if found["split"] != (truth["means"] == "none"):
        raise BadSet(f"{path.name}: a set without independent truth is split, another is not")
    if not found["commands"]:
        raise BadSet(f"{path.name}: commands is empty")


def read_sets(folders: list[Path]) -> list[LedgerSet]:
    """All sets of folders, by name; a name that two files have is an error."""
    found: dict[str, LedgerSet] = {}
    for path in sorted(p for folder in folders for p in folder.glob("*.toml")):
        one = read_set(path)
        if one.name in found:
            raise BadSet(f"{path}: another set is called {one.name}")
        found[one.name] = one
    return [found[name] for name in sorted(found)]


@dataclass(frozen=True, slots=True, kw_only=True)
class Places:
    """Where data lie and results go.

    data    folders that files of sets are looked for in
    cache   folder of rendered scenes, projects and runs, one in it for each set
    """

    data: tuple[Path, ...]
    cache: Path

    def files(self, one: LedgerSet) -> Path:
        """The folder of a set's files, after a comparison of checksums.

        raises  NotHere where no data folder has it, or a checksum differs
        """
        folder = one.source["folder"]
        for root in self.data:
            if (root / folder).is_dir():
                _compare(root / folder, one.source["checksums"])
                return root / folder
        where = f"{one.source['repository']} at {one.source['commit'] or 'its last commit'}"
        raise NotHere(f"{folder} is in none of the data folders; its source is {where}")

    def of(self, one: LedgerSet) -> Path:
        """The cache folder of a set."""
        found = self.cache / one.name
        found.mkdir(parents=True, exist_ok=True)
        return found


def _compare(folder: Path, checksums: Mapping[str, str]) -> None:
    for name, expected in checksums.items():
        path = folder / name
        if not path.exists():
            raise NotHere(f"{name} is not in {folder.name}")
        found = hashlib.sha256(path.read_bytes()).hexdigest()
        if not found.startswith(expected):
            raise NotHere(f"{name} has checksum {found[:16]}, the set states {expected}")
