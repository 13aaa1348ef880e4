"""Progress on a terminal, as lines of text or of JSON, or not at all."""

from __future__ import annotations

import contextlib
import json
import re
import sys
import time
from collections.abc import Generator
from contextlib import contextmanager
from typing import TYPE_CHECKING

from raybundle.errors import phrase, text_json
from raybundle.numerics.progress import Counted, Progress, Remark, silent

if TYPE_CHECKING:
    from rich.progress import Progress as Bar
    from rich.progress import TaskID

PATIENCE = 2.0
"""Seconds before a bar appears."""
LINES = 30.0
"""Seconds between lines of text, and before the first."""


@contextmanager
def reporting(mode: str) -> Generator[Progress]:
    """The progress function for a mode of `--progress`; the terminal is clean again at the end."""
    if mode == "json":
        yield _JsonLines()
    elif mode == "auto" and sys.stderr is not None and sys.stderr.isatty():
        terminal = _Terminal()
        try:
            yield terminal
        finally:
            terminal.close()
    elif mode == "auto" and sys.stderr is not None:
        yield _Lines()
    else:
        yield silent


class _JsonLines:
    """One JSON object a line on stderr."""

    def __init__(self) -> None:
        self.start = time.monotonic()

    def __call__(self, stage: str, share: float) -> None:
        if isinstance(share, Remark):
            self._say({"remark": stage, **text_json(stage), "seconds": round(time.monotonic() - self.start, 3)})
            return
        line: dict[str, object] = {
            "stage": stage, "share": round(share, 4), "seconds": round(time.monotonic() - self.start, 3),
        }  # fmt: skip
        if isinstance(share, Counted):
            line |= {"done": share.done, "total": share.total, "seconds_left": round(share.seconds_left, 1)}
        self._say(line)

    @staticmethod
    def _say(line: dict[str, object]) -> None:
        with contextlib.suppress(OSError, ValueError):  # nobody reads any more: the work goes on
            print(json.dumps(line), file=sys.stderr, flush=True)  # noqa: T201  (this is the output asked for)


class _Lines:
    """A line of text on stderr now and then, once the work has taken longer."""

    def __init__(self) -> None:
        self.next = time.monotonic() + LINES

    def __call__(self, stage: str, share: float) -> None:
        if isinstance(share, Remark) or (now := time.monotonic()) < self.next:
            return
        self.next = now + LINES
        left = share.seconds_left / 60 if isinstance(share, Counted) else None
        text = phrase("progress.line", stage=_name(stage), share=min(max(share, 0.0), 1.0), left=left or 0.0)
        with contextlib.suppress(OSError, ValueError):
            print(text, file=sys.stderr, flush=True)  # noqa: T201  (as the bar on a terminal)


def _name(stage: str) -> str:
    return phrase("progress.stage", stage=re.sub(r"\W+", "_", stage), name=stage)


class _Terminal:
    """A bar with stage, share and time left, once the work has taken two seconds."""

    def __init__(self) -> None:
        self.start = time.monotonic()
        self.stage = self.shown = ""
        self.bar: Bar | None = None
        self.task: TaskID | None = None

    def __call__(self, stage: str, share: float) -> None:
        with contextlib.suppress(OSError, ValueError):
            self._show(stage, share)

    def _show(self, stage: str, share: float) -> None:
        if self.bar is None:
            if time.monotonic() - self.start < PATIENCE:
                return
            self.bar = self._open()
        if isinstance(share, Remark):
            self._remark(stage)
            return
        if stage != self.stage or self.task is None:
            if self.task is not None:
                self.bar.remove_task(self.task)
            self.shown = _name(stage)
            self.task = self.bar.add_task(self.shown, total=1.0)
            self.stage = stage
        self.bar.update(self.task, description=self.shown, completed=min(max(share, 0.0), 1.0))

    def _remark(self, text: str) -> None:
        """Say on the line of the stage how the work stands, until it goes on."""
        assert self.bar is not None
        if self.task is None:
            self.task = self.bar.add_task(self.shown, total=1.0)
        self.bar.update(self.task, description=f"{self.shown}: {text}" if self.shown else text)

    @staticmethod
    def _open() -> Bar:
        from rich.console import Console
        from rich.progress import BarColumn, TaskProgressColumn, TextColumn, TimeRemainingColumn
        from rich.progress import Progress as Bar

        bar = Bar(
            TextColumn("{task.description}"),
            BarColumn(),
            TaskProgressColumn(),
            TimeRemainingColumn(),
            console=Console(stderr=True),
            transient=True,
        )
        bar.start()
        return bar

    def close(self) -> None:
        """Take the bar away."""
        with contextlib.suppress(OSError, ValueError):
            if self.bar is not None:
                self.bar.stop()
