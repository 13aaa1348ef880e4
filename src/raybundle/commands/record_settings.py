"""Settings that say whom a result is for and how good it is to be, alike for all commands that write one.

They are constants and not a base class: settings of commands have slots, and one of them derives from the options of an
adjustment already.
"""

from __future__ import annotations

from pathlib import Path
from typing import Protocol

from raybundle.results.record import Record, record_from

TITLE = "Title of the report."
CLIENT = "Client, on the first page of the report."
OPERATOR = "Operator, on the first page of the report."
ACCURACY_CLASS = (
    "Largest permitted RMSE at the check points. In metres: 0.03, or plan and height: 0.03,0.05 (-: no limit). Or a "
    "class of ASPRS (2024): asprs:2.5cm,5cm. If it is exceeded, the exit status is 4."
)


class Recorded(Protocol):
    """Settings of a command that writes a report."""

    @property
    def title(self) -> str:
        """Of the report."""
        ...

    @property
    def client(self) -> str:
        """Whom it is for."""
        ...

    @property
    def operator(self) -> str:
        """Who made it."""
        ...


def record_of(settings: Recorded) -> Record:
    """What they say of the delivery."""
    return Record(title=settings.title, client=settings.client, operator=settings.operator)


def record_in(project: Path) -> Record:
    """The table [record] of a project's project.toml; raises InputError for entries that are none."""
    from raybundle.io.reading.trees import read_toml

    file = project / "project.toml"
    return record_from(read_toml(file).tree()) if file.is_file() else Record()
