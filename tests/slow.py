"""Which tests are long: those that took more than 1.5 seconds of processor time when they were last measured.

    python -m tests.slow MEASURED...

writes tests/slow.txt from what `pytest --cpu FILE` recorded (with xdist each worker writes to the same file).  A test
of the list has the mark `long`, as one that states it itself; a line without "::" stands for all tests of a file.
"""

import os
import resource
import sys
from pathlib import Path

import pytest

LIST = Path(__file__).parent / "slow.txt"
MOST = 1.5
"""Seconds of a test of `make test`; what prepares it counts for the whole file"""


def names():
    return frozenset(LIST.read_text(encoding="utf-8").splitlines())


def seconds():
    """Processor time of this process and of those that it waited for."""
    used = (resource.getrusage(who) for who in (resource.RUSAGE_SELF, resource.RUSAGE_CHILDREN))
    return sum(u.ru_utime + u.ru_stime for u in used)


class Measured:
    """Appends `seconds phase test` to a file."""

    def __init__(self, file):
        self.file = Path(file)

    def _during(self, item, phase):
        begun = seconds()
        yield
        if (spent := seconds() - begun) > 0.01:
            with self.file.open("a", encoding="utf-8") as out:
                out.write(f"{spent:.2f} {phase} {item.nodeid}\n")

    @pytest.hookimpl(hookwrapper=True)
    def pytest_runtest_setup(self, item):
        yield from self._during(item, "setup")

    @pytest.hookimpl(hookwrapper=True)
    def pytest_runtest_call(self, item):
        yield from self._during(item, "call")


def main(files):
    rows = [line.rstrip("\n").split(" ", 2) for f in files for line in Path(f).read_text(encoding="utf-8").splitlines()]
    found = {name if phase == "call" else name.partition("::")[0] for spent, phase, name in rows if float(spent) > MOST}
    measured = {name for _, _, name in rows}
    kept = {n for n in names() if n not in measured} if LIST.exists() else set()
    files = {n for n in found | kept if "::" not in n}
    LIST.write_text("".join(f"{n}\n" for n in sorted(found | kept) if n.partition("::")[0] not in files or n in files))


if __name__ == "__main__":
    os.chdir(Path(__file__).parents[1])
    main(sys.argv[1:])
