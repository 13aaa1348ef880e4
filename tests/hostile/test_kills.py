"""Four kills of each command that writes results; `benchmarks/kills.py` goes on."""

import os
import sys
import time

import pytest

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
import pathlib, sys, time
out = pathlib.Path(sys.argv[1])
out.mkdir(exist_ok=True)
for k in range(5):
    (out / str(k)).write_text(sys.argv[2])
    time.sleep(0.05)
"""


def test_a_writer_in_place_would_be_noticed(tmp_path):
    class Sloppy(Job):
        def words(self, turn):
            return [sys.executable, "-c", SLOPPY, str(self.out), self.inputs[turn % 2]]

    (tmp_path / "o").mkdir()
    told = kill(Sloppy("sloppy", [], ["a", "b"], tmp_path / "o" / "r"), 6, seed=1)
    assert told.wrong
