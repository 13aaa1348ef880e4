"""Errors by their codes and values: no test compares words."""

import json
from collections.abc import Generator, Iterable, Mapping
from contextlib import contextmanager
from pathlib import Path
from typing import Any

import pytest

from raybundle.cli.failures import failure_lines
from raybundle.errors import InputError, Message, Place, RaybundleError, message_of
from raybundle.words import COMMAND_LINE, reading


@contextmanager
def refused(code: str, kind: type[RaybundleError] = InputError, /, **values: Any) -> Generator[pytest.ExceptionInfo]:
    """An error of this code; its file (by name), line, column and values are those given, and others.

    raises  AssertionError where one differs; pytest's Failed where nothing is raised
    """
    with pytest.raises(kind) as caught:
        yield caught
    error = caught.value
    place = getattr(error, "place", Place())
    found = {"file": Path(place.file).name, "line": place.line, "column": place.column}
    found |= error.message.values if error.message else {}
    assert (error.code, {name: found.get(name) for name in values}) == (code, values), error


def with_details(*messages: Message) -> list[Message]:
    """Messages, each before its details and those of these."""
    return [found for m in messages for found in (m, *with_details(*m.details))]


def printed(code: str, /, **values: Any) -> str:
    """An error as the command line prints it, behind its place."""
    with reading(COMMAND_LINE):
        return failure_lines(InputError(code, **values))[0].removeprefix("error: ")


def coded(texts: Iterable[str]) -> dict[str, Mapping[str, Any]]:
    """Values of the messages of texts by their codes, with those of their details; of one code those of the last."""
    return {m.code: m.values for t in texts for m in with_details(*getattr(t, "messages", ()))}


def failed(capsys: pytest.CaptureFixture[str]) -> Message:
    """The error, with its place, that a command with --json has reported since the last call."""
    return message_of(json.loads(capsys.readouterr().out))
