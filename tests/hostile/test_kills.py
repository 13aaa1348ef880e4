"""Four kills of each command that writes results; `benchmarks/kills.py` goes on."""

import os
import sys
import time

import pytest

from tests.barriers import wait_for
from tests.hostile.killing import JOBS, Job, kill

pytestmark = pytest.mark.skipif(not hasattr(os, "killpg"), reason="the system has no groups of processes")
KILLS, SECONDS = 4, 12.0


@pytest.mark.long
@pytest.mark.parametrize("name", sorted(JOBS))
def test_kills(name, tmp_path):
    job = JOBS[name](tmp_path)
    if job is None:
        pytest.skip("demo_data/portal is part of the repository, not of the package")
    told = kill(job, KILLS, seed=1, deadline=time.monotonic() + SECONDS)
    assert told.wrong == []
    assert told.kills > 0


SLOPPY = """
import pathlib, sys, threading
out, text, stop = pathlib.Path(sys.argv[1]), sys.argv[2], int(sys.argv[3])
out.mkdir(exist_ok=True)
for k in range(5):
    (out / str(k)).write_text(text)
    if k == stop:
        (out.parent / "held").touch()
        threading.Event().wait()
"""


def test_a_writer_in_place_would_be_noticed(tmp_path):
    class Sloppy(Job):
        stop = -1

        def words(self, turn):
            return [sys.executable, "-c", SLOPPY, str(self.out), self.inputs[turn % 2], str(self.stop)]

        def finish(self, turn):
            self.stop = -1
            try:
                return super().finish(turn)
            finally:
                self.stop = 2  # of five files, which have three of the new content then

        def outlives(self, running, seconds):  # noqa: ARG002
            held = self.out.parent / "held"
            wait_for(held.exists, "it has begun to write")
            held.unlink()
            return True

    (tmp_path / "o").mkdir()
    told = kill(Sloppy("sloppy", [], ["a", "b"], tmp_path / "o" / "r"), 6, seed=1)
    assert (told.kills, told.new, len(told.wrong)) == (
        6,
        3,
        3,
    )  # every second one writes what is there but for two files
