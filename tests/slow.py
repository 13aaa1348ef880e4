"""Which tests are long: tests/slow.txt, which benchmarks/short_suite.py writes.

They took more than MOST seconds of processor time (`pytest --cpu FILE`; with xdist each worker appends), or fewer and
run no block of statements that short tests do not run.  A test in the list has the mark `long`, as one that states
it itself: `make test-long` runs both.  Those of KEPT stay in `make test`, however long they take: the main job, and
whether standard deviations are true.
"""

import resource
from pathlib import Path

import pytest

LIST = Path(__file__).parent / "slow.txt"
MOST = 1.5
"""Seconds of a test of `make test`, without those of its fixtures"""
KEPT = ("tests/smoke/", "tests/truth/")


def names():
    return frozenset(LIST.read_text(encoding="utf-8").splitlines())


def seconds():
    """Processor time of this process and of those that it waited for."""
    used = (resource.getrusage(who) for who in (resource.RUSAGE_SELF, resource.RUSAGE_CHILDREN))
    return sum(u.ru_utime + u.ru_stime for u in used)


def part(text):
    """(K, N) of `K/N`."""
    k, n = map(int, text.split("/"))
    if not 0 < k <= n:
        raise ValueError(text)
    return k, n


class Measured:
    """Appends `seconds test` to a file."""

    def __init__(self, file):
        self.file = Path(file)

    @pytest.hookimpl(hookwrapper=True)
    def pytest_runtest_call(self, item):
        begun = seconds()
        yield
        with self.file.open("a", encoding="utf-8") as out:
            out.write(f"{seconds() - begun:.2f} {item.nodeid}\n")
