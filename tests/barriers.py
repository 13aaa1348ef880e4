"""Waiting for others: until they are there, however busy the machine is; never for a time that should do."""

import os
import signal
import subprocess
import sys
import threading
import time
from collections.abc import Callable, Sequence
from pathlib import Path
from typing import Any, TypeVar

DEADLINE_S = 300.0
"""After which nothing comes any more: many times what the slowest machine needs."""
T = TypeVar("T")


def wait_for(found: Callable[[], T], what: str, seconds: float = DEADLINE_S) -> T:
    """What a function gives, as soon as that is true.

    raises  AssertionError after the deadline, with `what` was waited for and what was given last
    """
    until = time.monotonic() + seconds
    while not (given := found()):
        assert time.monotonic() < until, f"{what}: not within {seconds:g} s, but {given!r}"
        time.sleep(0.02)
    return given


HELD = """
import sys
from raybundle.cli.main import main
from tests.barriers import hold

if __name__ == "__main__":
    hold(sys.argv[1], int(sys.argv[2]))
    sys.exit(main(sys.argv[3:]))
"""
"""Runs a command of raybundle that is held: arguments are those of `hold`, and the words of the command."""

SIGNALLED = """
import os, signal, sys
from raybundle.cli import progress
from raybundle.cli.main import main

say, stages = progress._JsonLines._say, [sys.argv[1]]

def told(line):
    say(line)
    if line.get("stage") in stages:
        stages.clear()
        os.kill(os.getpid(), signal.Signals[sys.argv[2]])

if __name__ == "__main__":
    progress._JsonLines._say = staticmethod(told)
    sys.exit(main([*sys.argv[3:], "--progress", "json"]))
"""
"""Runs a command of raybundle that gets a signal at the first progress of a stage: stage, signal, words."""


def hold(which: str, count: int) -> None:
    """Say "held" when this process has kept so many products, and go no further: somebody is to kill it there.

    which  how their folder and key begin, as "cache/depth map-"
    """
    from raybundle.pipeline.store import Folder

    store, left = Folder.store, [count]

    def held(self, key, product):
        store(self, key, product)
        if f"{self.path.name}/{key}".startswith(which):
            left[0] -= 1
            if not left[0]:
                sys.stdout.write("held\n")
                sys.stdout.flush()
                threading.Event().wait()

    Folder.store = held


def kill_where_held(words: Sequence[str | Path], **more: Any) -> None:
    """Begin a program and kill it where `hold` holds it, with all processes of its group."""
    with subprocess.Popen(words, stdout=subprocess.PIPE, text=True, start_new_session=True, **more) as running:
        assert running.stdout is not None
        assert "held\n" in running.stdout, "it ended before it was held"
        os.killpg(running.pid, signal.SIGKILL)
