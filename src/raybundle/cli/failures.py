"""What is stated of an error, and the exit status."""

from __future__ import annotations

import contextlib
import os
import sys
import traceback
from typing import TextIO

from raybundle import words
from raybundle.errors import RaybundleError, printable


def failure_lines(error: Exception) -> tuple[str, int]:
    """What is stated of an error, and the exit status."""
    if isinstance(error, RaybundleError):
        return _lines(error), error.exit_status
    if isinstance(error, MemoryError) or _lacks_memory(error):
        return "MemoryError: there is not enough memory; give fewer or smaller inputs, or fewer --jobs", 2
    if isinstance(error, OSError) and error.filename is None and (_in_output(error) or _is_closed(sys.stdout)):
        silence(sys.stdout)
        reason = error.strerror or str(error)
        return f"the output could not be shown ({reason}); what was to be written is written", 2
    if isinstance(error, OSError):
        from raybundle.io.reading.words import quoted

        names = " -> ".join(quoted(os.fsdecode(n)) for n in (error.filename, error.filename2) if n is not None)
        return f"{type(error).__name__}: {names or 'a file'} cannot be used: {error.strerror or error}", 2
    first = printable(str(error).partition("\n")[0])[:1000]
    return f"internal error {type(error).__name__}: {first}; please report; --traceback shows it", 1


def _lines(error: RaybundleError) -> str:
    """The place and what happened, with the code; why it matters and what to do in lines of their own."""
    found = error.message
    if found is None:
        return f"{type(error).__name__}: {error}"
    reader = words.reader()
    more = (words.why(found.code, found.values, reader), words.action(found.code, found.values, reader))
    details = (line for d in found.details for line in d.text(reader).splitlines())
    return "\n".join([f"error: {error.headline} [{found.code}]", *(f"  {m}" for m in (*more, *details) if m)])


def _lacks_memory(error: Exception) -> bool:
    """Whether the system refused memory under a limit (ulimit -v): to map a library, or for the stack of a thread."""
    text = str(error)
    if isinstance(error, ImportError):
        return "failed to map segment" in text or "annot allocate memory" in text
    return isinstance(error, RuntimeError) and "can't start new thread" in text


def silence(stream: TextIO | None) -> None:
    """Let what is left in a stream's buffer go nowhere, so that the end of the process has nothing to complain of."""
    with contextlib.suppress(OSError, ValueError):
        if stream is not None:
            os.dup2(os.open(os.devnull, os.O_WRONLY), stream.fileno())


def _in_output(error: Exception) -> bool:
    """Whether an error was raised where the command shows something."""
    return any(f.f_globals.get("__name__") == "click.utils" for f, _ in traceback.walk_tb(error.__traceback__))


def _is_closed(stream: TextIO | None) -> bool:
    """Whether nothing more can be written to a stream."""
    try:
        if stream is not None:
            stream.flush()
    except (OSError, ValueError):
        return True
    return stream is None
