"""What a command reports at its end: what was done, how good it is, what is wrong, the next step, and the files."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass, replace
from typing import TYPE_CHECKING, Any, Protocol

import click

from raybundle.errors import Message, Severity, Text, excluded, note, warning

if TYPE_CHECKING:
    from raybundle.adjustment.result import Adjustment
SUMMARY = "raybundle.summary"
SHOWN = 3
"""Faults and warnings that a terminal shows"""


class Coded(Protocol):
    """A notice: a message, and other objects of which the same holds."""

    @property
    def data(self) -> Message: ...  # noqa: D102
    @property
    def also(self) -> tuple[str, ...]: ...  # noqa: D102


@dataclass(frozen=True, slots=True, kw_only=True)
class Summary:
    """What a command reports."""

    done: Sequence[Message]
    """What was done and how good it is: a line each."""
    notices: Sequence[Message | Coded] = ()
    """Faults, warnings and notes."""
    next_step: Message | None = None
    """What to do where nothing is wrong; else that is the remedy of the gravest notice."""
    files: Sequence[object] = ()
    """Files and folders that were written."""
    table: Sequence[Message | str] = ()
    """Rows and lines of a command that shows a table: always printed"""
    details: Sequence[Message | str] = ()
    """Further figures, and rows of tables, for --verbose."""


def report(summary: Summary) -> None:
    """Hand a summary to the command that runs, which prints it in the end."""
    click.get_current_context().meta[SUMMARY] = summary


def of_adjustment(
    a: Adjustment, files: Sequence[object], *, done: Sequence[Message] = (), next_step: Message | None = None,
    details: Sequence[Message | str] = (), notices: Sequence[Message] = (),
) -> Summary:  # fmt: skip
    """The summary of an adjustment; `done` replaces how much was adjusted, notices and details are added."""
    from raybundle.adjustment.records.notice import sorted_notices
    from raybundle.report.text import summary

    if a.free_scale:
        next_step = note("summary.next_scale")
    return Summary(
        done=(*(done or (summary.adjusted(a),)), summary.accuracy(a)), next_step=next_step, files=files,
        notices=(*notices, *sorted_notices(a.notices)), details=(*summary.details(a), *details),
    )  # fmt: skip


def not_usable(refused: Sequence[tuple[str, str]]) -> list[Message]:
    """A warning that names files without a part in the result; their reasons are its details."""
    if not refused:
        return []
    names = [name for name, _ in refused]
    return [warning("photographs.not_usable", n=len(names), names=names, details=excluded(refused))]


def of_texts(texts: Iterable[str], severity: Severity | None = None) -> list[Message]:
    """The messages of texts, all of one severity, or each of its own; of what has none it is a note."""
    found = [m for t in texts for m in (t.messages if isinstance(t, Text) else [note("summary.text", text=t)])]
    return [
        replace(m, severity=severity or (Severity.NOTE if m.severity is Severity.ERROR else m.severity)) for m in found
    ]


def lines(summary: Summary, *, verbose: bool) -> list[str]:
    """What a terminal shows, at most eight lines without --verbose."""
    from raybundle.words import headline, reader

    grave = _grave(summary.notices)
    shown = grave if verbose else grave[:SHOWN]
    found = [*(m.headline() for m in summary.done), *table_lines(summary)]
    if verbose:
        found += [f"  {d if isinstance(d, str) else d.text()}" for d in summary.details]
    found += [notice_line(n, whole=verbose) for n in shown]
    if len(grave) > len(shown):
        found.append(headline("summary.more", {"n": len(grave) - len(shown)}, reader()))
    if verbose:
        found += [notice_line(n, whole=True) for n in summary.notices if _message(n).severity is Severity.NOTE]
    step = _remedy(grave) or (summary.next_step.headline() if summary.next_step else "")
    if step:
        found.append(headline("summary.next", {"step": step}, reader()))
    if summary.files:
        found.append(headline("summary.files", {"files": [str(f) for f in summary.files]}, reader()))
    return found


def table_lines(summary: Summary) -> list[str]:
    """The rows of its table."""
    return [row if isinstance(row, str) else row.text() for row in summary.table]


def loud(summary: Summary) -> list[str]:
    """What a quiet command prints: faults and warnings."""
    return [notice_line(n) for n in _grave(summary.notices)]


def data(summary: Summary) -> dict[str, Any]:
    """The same for JSON: messages as code, values and text."""
    found: dict[str, Any] = {"summary": [_object(m) for m in summary.done], "lines": table_lines(summary)}
    for name, severity in (("faults", Severity.FAULT), ("warnings", Severity.WARNING), ("notes", Severity.NOTE)):
        found[name] = [_object(n) for n in summary.notices if _message(n).severity is severity]
    found["details"] = [_object(d) for d in summary.details if not isinstance(d, str)]
    if summary.next_step:
        found["next"] = _object(summary.next_step)
    return found


def _message(notice: Message | Coded) -> Message:
    return notice if isinstance(notice, Message) else notice.data


def _grave(notices: Iterable[Message | Coded]) -> list[Message | Coded]:
    """Faults and warnings, the gravest first."""
    order = list(Severity)
    grave = (n for n in notices if _message(n).severity is not Severity.NOTE)
    return sorted(grave, key=lambda n: order.index(_message(n).severity))


def notice_line(notice: Message | Coded, *, whole: bool = False) -> str:
    """Severity, what happened and the code, which leads to the rest; `whole`: why it matters and its details too."""
    message, also = _message(notice), getattr(notice, "also", ())
    stored = getattr(notice, "message", "")
    if stored:  # a text of an earlier result
        return f"{message.severity.value}: {stored} [{message.code}]"
    if whole:
        also = f" (+{', '.join(also)})" if also else ""
        first, *others = message.text().splitlines()
        return "\n".join([f"{message.severity.value}: {first}{also} [{message.code}]", *others])
    others = f" (+{len(also)})" if also else ""
    place = f"{message.place.text()}: " if message.place else ""
    return f"{message.severity.value}: {place}{message.headline()}{others} [{message.code}]"


def _remedy(grave: Sequence[Message | Coded]) -> str:
    """What to do about the gravest notice that has a remedy."""
    from raybundle.words import action, reader

    found = (action(m.code, m.values, reader()) for m in map(_message, grave))
    return next(filter(None, found), "")


def _object(notice: Message | Coded) -> Mapping[str, Any]:
    message = _message(notice)
    also = getattr(notice, "also", ())
    return {**message.json(), **({"also": list(also)} if also else {}), "text": message.text()}
