"""Whether a result may be used, in a sentence that travels with what is made of it."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace
from pathlib import Path
from typing import Any

from raybundle import words
from raybundle.adjustment.records.notice import Notice
from raybundle.adjustment.records.severity import SEVERITY, Severity
from raybundle.errors import InputError, Message, Text, message_of, note, phrase
from raybundle.io.reading.trees import read_json

RELATIVE = "state.heights_relative"
"""What does not forbid the use of a result."""


def relative_heights(state: str) -> bool:
    """Whether `state_words` states relative heights, here or as a file has it."""
    return phrase(RELATIVE) in state


def state_messages(found: str) -> list[Message]:
    """What `state_words` gave, or a file has of it, as faults or a warning."""
    texts = found.messages if isinstance(found, Text) else [note("state.fault_text", text=found)] if found else []
    severity = Severity.WARNING if found == phrase(RELATIVE) else Severity.FAULT
    return [replace(m, severity=severity) for m in texts]


def state_words(result: Mapping[str, Any]) -> str:
    """What result.json states against the use of its result, with the first fault; empty where nothing does."""
    found: list[Message] = []
    if faults := _faults(result):
        text = notice_of(faults[0]).text
        first = replace(text.message, details=()) if isinstance(text, Text) else note("state.fault_text", text=text)
        found += [note("state.faults", n=len(faults)), first]
    if lost(result):
        found.append(note("state.accuracy_not_kept"))
    if any(n.get("code") == "levelled" for n in notices_in(result)):
        found.append(note("state.heights_relative"))
    return Text.of(*found) if found else ""


def faults_of(folder: Path) -> tuple[str, ...]:
    """Messages of the faults in a folder's result.json; () where there is none, or it cannot be read.

    Limits: whether a folder without a result, as a block, has any.
    """
    try:
        found = read_json(folder / "result.json").value
    except InputError:
        return ()
    return tuple(notice_of(n).text for n in _faults(found)) if isinstance(found, dict) else ()


def lost(result: Mapping[str, Any]) -> bool:
    """Whether an accuracy was asked for that is not kept."""
    wanted = result.get("accuracy_class")
    return isinstance(wanted, dict) and wanted.get("kept") is False


def _faults(result: Mapping[str, Any]) -> list[Mapping[str, Any]]:
    return [n for n in notices_in(result) if _fault(n)]


def notices_in(result: Mapping[str, Any]) -> list[Mapping[str, Any]]:
    """What a result.json warns of."""
    notices = result.get("warnings")
    return [n for n in notices if isinstance(n, dict)] if isinstance(notices, list) else []


def _fault(notice: Mapping[str, Any]) -> bool:
    return severity_of(notice) is Severity.FAULT


def severity_of(notice: Mapping[str, Any]) -> Severity:
    """How grave it is; results of versions that did not write how grave a notice is show its code."""
    lines = notice.get("severity", SEVERITY.get(str(notice.get("code", "")), Severity.NOTE))
    return Severity(lines) if lines in [s.value for s in Severity] else Severity.NOTE


def notice_of(stored: Mapping[str, Any]) -> Notice:
    """A notice of result.json; with its text where this version lacks the code, or an older one wrote no values."""
    code, values = ".".join(filter(None, (stored.get("code"), stored.get("variant")))), stored.get("values") or {}
    ids = tuple(str(i) for i in stored.get("ids") or ())
    other = str(stored.get("words", ""))
    shown = other or code
    known = shown in words.codes() and {*words.examples(shown)} <= {*values, *(["ids"] if ids else [])}
    return Notice(
        code=code, words=other if known else "", message="" if known else str(stored.get("message", "")),
        measured=severity_of(stored), ids=ids, values=values,
        details=tuple(map(message_of, stored.get("details") or ())),
    )  # fmt: skip
