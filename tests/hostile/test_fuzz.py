"""Damaged files for every reader: an error of raybundle or sound values, in bounded time and memory.

Bounded, with fixed numbers, so that it fails or passes the same everywhere; `benchmarks/fuzz_readers.py` goes on with
numbers of its own for as long as it is let.
"""

import random
import time
from dataclasses import replace

import pytest

from raybundle.errors import InputError
from tests.hostile.fuzzing import fuzz, put, seeds_in, variant
from tests.hostile.mutations import damaged
from tests.hostile.readers import TARGETS

pytest.importorskip("resource", reason="there are no limits of a process here")
INPUTS = {"first": range(30), "further": range(30, 120)}
SLOW_INPUTS = {"first": range(2), "further": range(2, 6)}
SECONDS = 6.0
"""For one reader, on a machine so slow that it does not try them all."""


@pytest.fixture(scope="module")
def tops(tmp_path_factory):
    return tmp_path_factory.mktemp("seeds")


@pytest.mark.parametrize("part", ["first", pytest.param("further", marks=pytest.mark.long)])
@pytest.mark.parametrize("name", sorted(TARGETS))
def test_damaged_inputs(name, part, tops, tmp_path):
    target = TARGETS[name]
    target.seeds(tops / part / name)
    seeds = seeds_in(tops / part / name)
    for files in seeds:
        assert target.read(put(files, tmp_path / "valid")) == []
    numbers = (SLOW_INPUTS if target.slow else INPUTS)[part]
    found = fuzz(target, seeds, numbers, tmp_path, time.monotonic() + SECONDS)
    assert found.bad == 0, found.examples
    assert sum(found.counts.values()) > 0


def test_an_input_is_known_by_its_number():
    seeds = [{"a.csv": b"a,b\n1,2\n", "b.json": b'{"a": [1, 2]}'}]
    assert variant(seeds, "x", 7) == variant(seeds, "x", 7)
    assert len({str(variant(seeds, "x", k)) for k in range(50)}) > 40
    assert all(isinstance(damaged(random.Random(k), b"<a><b>1</b></a>", "a.xml"), bytes) for k in range(300))


def swallows(folder):
    raise ValueError("of a foreign type")


def loops(folder):
    while True:
        pass


def eats(folder):
    return [] if b"x" * (3 << 29) else ["nothing"]


def dies(folder):
    import os
    import signal

    os.kill(os.getpid(), signal.SIGSEGV)


def shouts(folder):
    raise InputError("x \N{COMBINING ACUTE ACCENT}", file="\x1b[2J" * 2000)


def raw(folder):
    error = InputError("x")
    error.args = ("\x1b[2J",)
    raise error


@pytest.mark.long
@pytest.mark.parametrize(
    ("read", "kind"),
    [
        (swallows, "foreign"),
        (loops, "slow"),
        (eats, "memory"),
        (dies, "killed"),
        (raw, "message"),
        (lambda _: ["nan"], "nonsense"),
    ],
    ids=["foreign", "slow", "memory", "killed", "message", "nonsense"],
)
def test_the_fuzzer_would_notice(read, kind, tmp_path, monkeypatch):
    monkeypatch.setattr("tests.hostile.fuzzing.SECONDS", 0.2)
    target = replace(TARGETS["codes"], read=read)
    found = fuzz(target, [{"a": b"1"}], range(3), tmp_path)
    assert found.counts[kind] == found.bad == 3
    assert found.examples


def test_a_message_with_a_wild_path_is_printable():
    with pytest.raises(InputError) as caught:
        shouts(None)
    assert str(caught.value).isprintable()
