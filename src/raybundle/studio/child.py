"""A command of raybundle as a process of its own: its progress as it comes, what it states in the end, and stopped."""

from __future__ import annotations

import os
import signal
import subprocess
import sys
from collections.abc import Sequence
from dataclasses import dataclass, field
from pathlib import Path
from tempfile import TemporaryFile
from typing import IO, Any, cast

from raybundle.errors import InputError
from raybundle.io.reading.trees import json_of
from raybundle.numerics.progress import Progress

MOST_LINES = 200
"""Lines of a command's errors that are kept, the last ones."""
START = """
import os, runpy, signal, threading, _thread
signal.signal(signal.SIGINT, signal.default_int_handler)
threading.Thread(target=lambda: (os.read(0, 1), _thread.interrupt_main()), daemon=True).start()
runpy.run_module('raybundle', run_name='__main__')
"""
"""Begins the program so that it hears an interrupt, which a studio begun in the background (`&`) does not, and ends
with a studio that is killed: then its input ends."""
PATIENCE_S = 10.0
"""Seconds that a command has to end by itself when the studio ends."""


@dataclass(slots=True)
class Child:
    """One run of a command."""

    process: subprocess.Popen[str]
    printed: IO[str]
    reported: list[str] = field(default_factory=list[str])
    """lines of errors"""
    stop_requests: int = 0
    interruptible: bool = False
    """whether it has sent progress: an interrupt before that may be lost while the program is loaded"""

    @classmethod
    def begin(cls, words: Sequence[str]) -> Child:
        """Begin `raybundle` with these words of its command line; progress is asked for as JSON lines."""
        printed = TemporaryFile("w+", encoding="utf-8", errors="replace")  # noqa: SIM115  (closed by `ended`)
        # a group of its own: an interrupt at the terminal reaches the studio, which stops it once
        apart: dict[str, Any] = {"start_new_session": True}
        if sys.platform == "win32":
            apart = {"creationflags": subprocess.CREATE_NEW_PROCESS_GROUP}
        process = subprocess.Popen(  # noqa: S603  (this program, no shell)
            [sys.executable, "-c", START, *words], stdin=subprocess.PIPE, stdout=printed,
            stderr=subprocess.PIPE, text=True, encoding="utf-8", errors="replace",
            env={**os.environ, "PYTHONUTF8": "1"}, **apart,
        )  # fmt: skip
        return cls(process, printed)

    def follow(self, progress: Progress) -> tuple[int, str]:
        """Report its progress until it ends; its exit status and what it printed."""
        assert self.process.stderr is not None
        for line in self.process.stderr:
            found = _progress(line)
            if found is not None:
                self.interruptible = True
                progress(*found)
            elif line.strip():
                self.reported = [*self.reported[-MOST_LINES:], line.rstrip()]
        self.process.stderr.close()
        status = self.process.wait()
        if self.process.stdin is not None:
            self.process.stdin.close()
        self.printed.seek(0)
        words = self.printed.read()
        self.printed.close()
        return status, words

    def stop(self) -> None:
        """Ask it to stop between two tasks, as Ctrl-C does; asked again, or before it has begun, end it where it is.

        Both keep what is finished: products and results appear whole or not at all.
        """
        self.stop_requests += 1
        if self.process.poll() is not None:
            return
        if (
            self.stop_requests > 1 or not self.interruptible or sys.platform == "win32"
        ):  # there is no Ctrl-C for another process
            self.process.kill()
        else:
            self.process.send_signal(signal.SIGINT)

    def close(self) -> None:
        """Stop it, by force where it does not end in time."""
        self.stop()
        try:
            self.process.wait(PATIENCE_S)
        except subprocess.TimeoutExpired:
            self.process.kill()


def _progress(line: str) -> tuple[str, float] | None:
    """Stage and share of a line of progress; None for another line."""
    if not line.startswith("{"):
        return None
    try:
        found: Any = json_of(line, Path("progress"))
    except InputError:
        return None
    if not isinstance(found, dict):
        return None
    table = cast("dict[str, Any]", found)
    stage, share = table.get("stage"), table.get("share")
    return (stage, float(share)) if isinstance(stage, str) and isinstance(share, int | float) else None
