"""Which tests are long: those that took more than 1.5 seconds of processor time when they were last measured.

    pytest --cpu FILE ...           records seconds (with xdist each worker appends)
    python -m tests.slow FILE...    writes tests/slow.txt from that

A test in the list has the mark `long`, as one that states it itself: `make test-long` runs both.  Those of KEPT stay in
`make test`, however long they take: the main job, and whether standard deviations are true.
"""

import resource
import sys
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


def main(files):
    rows = [line.split(" ", 1) for f in files for line in Path(f).read_text(encoding="utf-8").splitlines()]
    slow = {name for spent, name in rows if float(spent) > MOST and not name.startswith(KEPT)}
    others = names() - {name for _, name in rows}  # not measured now
    LIST.write_text("".join(f"{name}\n" for name in sorted(slow | others)), encoding="utf-8")


if __name__ == "__main__":
    main(sys.argv[1:])
