"""What can be run from the page: `orient` in a project, `calibrate` in a calibration; settings, command and stages."""

from __future__ import annotations

import shlex
from collections.abc import Mapping
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Any, Literal, Protocol

from raybundle.commands.calibrate import CalibrateSettings
from raybundle.commands.orient import OrientSettings, settings_asked
from raybundle.errors import InputError, phrase
from raybundle.io.reading.trees import read_json
from raybundle.pipeline.project import HERE, Project, StageRecord
from raybundle.results.folder import PROJECT
from raybundle.settings import as_typed
from raybundle.studio.desk import Desk
from raybundle.studio.forms import fields_of, settings_of_form, words_of
from raybundle.studio.shelf import Origin

Name = Literal["orient", "calibrate"]
Settings = OrientSettings | CalibrateSettings


class Runs(Protocol):
    """A command that can be run in the background."""

    @property
    def name(self) -> str:
        """What it is called."""
        ...

    @property
    def command(self) -> str:
        """As it is typed."""
        ...

    @property
    def child_words(self) -> list[str]:
        """Of the command line of a child that shows its progress."""
        ...

    @property
    def titles(self) -> tuple[str, ...]:
        """Its stages, in order; none: only its progress is known."""
        ...

    @property
    def origin(self) -> Origin | None:
        """How the result is called with which the page goes on; None: nothing is read anew."""
        ...

    def records(self) -> list[StageRecord]:
        """The stages that are recorded."""
        ...

    def check(self) -> None:
        """Raise InputError where it cannot be run."""
        ...


@dataclass(frozen=True, slots=True, kw_only=True)
class Runnable:
    """A command with its settings."""

    name: Name
    settings: Settings
    usual: Settings
    """as the opened folder was made"""

    @property
    def words(self) -> list[str]:
        """Of the command line, without the program."""
        s = self.settings
        return [self.name, *as_typed(s), "--out", str(s.out), "--", *(str(p) for p in s.photos)]

    @property
    def command(self) -> str:
        """As it is typed."""
        return shlex.join(["raybundle", *self.words])

    @property
    def child_words(self) -> list[str]:
        """The same for a child, which shows its progress."""
        return [self.name, "--progress", "json", *self.words[1:]]

    @property
    def titles(self) -> tuple[str, ...]:
        """Its stages, in order."""
        from raybundle.workflows.calibrating.stages import CALIBRATE
        from raybundle.workflows.orient import stages

        return stages() if self.name == "orient" else (*CALIBRATE.titles(), "report")

    @property
    def origin(self) -> Origin:
        """How its result is called."""
        return "oriented" if self.name == "orient" else "calibrated"

    def check(self) -> None:
        """Raise InputError where no photographs are given."""
        if not self.settings.photos:
            raise InputError("studio.no_photographs")

    def records(self) -> list[StageRecord]:
        """The stages that are recorded in its project folder; none where it cannot be read at this moment."""
        folder = self.settings.out if self.name == "orient" else self.settings.out / PROJECT
        try:
            opened = Project.open(folder, create=False, store=HERE)  # only what was recorded is read
        except InputError:
            return []
        try:
            return opened.stages()
        except InputError:
            return []
        finally:
            opened.close()

    def form(self) -> dict[str, Any]:
        """The settings as a form, and the command."""
        shown, usual = (shlex.join(str(p) for p in s.photos) for s in (self.settings, self.usual))
        photos = {
            "name": "photos", "flag": phrase("label.photographs"), "kind": "words",
            "help": phrase("studio_run.photos_help"), "choices": [],
            "whole": False, "low": None, "high": None, "metavar": "PHOTOS ...", "value": shown, "default": usual,
        }  # fmt: skip
        return {"name": self.name, "fields": [photos, *fields_of(self.settings)], "command": self.command}

    def chosen(self, given: Mapping[str, Any]) -> Runnable:
        """With the settings that a form gives; raises InputError that names the setting."""
        values = dict(given)
        photos = values.pop("photos", shlex.join(str(p) for p in self.usual.photos))
        if not isinstance(photos, str):
            raise InputError("setting.no_text", name="photos", given=str(photos))
        paths = tuple(Path(w) for w in words_of(photos, "photos"))
        if not paths:
            raise InputError("studio.no_photographs")
        settings = settings_of_form(type(self.usual), values, {"photos": paths, "out": self.usual.out})
        return replace(self, settings=settings)


def runnable(desk: Desk) -> Runnable:
    """What can be run in what is open; raises InputError where nothing can."""
    source = desk.source
    if (source / "project.db").is_file():
        usual = settings_asked(source)
        return Runnable(name="orient", settings=usual, usual=_bare(usual))
    if (source / PROJECT / "project.db").is_file():
        folders = tuple(dict.fromkeys(p.parent for p in desk.tiles.paths.values()))
        usual = CalibrateSettings(photos=folders, out=source, target=_families(source))
        return Runnable(name="calibrate", settings=usual, usual=usual)
    raise InputError("studio.nothing_to_run")


def _bare(settings: OrientSettings) -> OrientSettings:
    return OrientSettings(photos=settings.photos, out=settings.out)


def _families(result: Path) -> tuple[str, ...]:
    """What a calibration was made of, as it states itself."""
    tree = read_json(result / "result.json")
    if not tree.has("targets"):
        return ()
    return tuple(f.text() for f in tree.get("targets").get("families").items())
