"""Damaged inputs for a reader, tried in child processes with limits of memory and time."""

import contextlib
import faulthandler
import io
import json
import os
import random
import re
import resource
import select
import shutil
import signal
import sys
import time
import traceback
import warnings
from collections import Counter
from dataclasses import dataclass, field
from pathlib import Path

from raybundle.errors import RaybundleError
from tests.hostile.mutations import damaged

SECONDS = 10.0
"""CPU time that no input may take."""
EXTRA_BYTES = 1 << 30
"""Memory that no input may take beyond what the process had before."""
SILENT_S = 120.0
"""A child that says nothing for so long hangs where no signal reaches it."""
BATCH = 200
SMALL_BYTES = 900_000


@dataclass
class Found:
    """What became of the inputs of one reader."""

    counts: Counter[str] = field(default_factory=Counter)
    """read, refused, and what must not be: foreign, slow, memory, nonsense, message, killed"""
    examples: dict[str, tuple[int, str]] = field(default_factory=dict)
    """The first input of each kind of misbehaviour, and what happened."""
    slowest_s: float = 0.0

    @property
    def bad(self) -> int:
        return sum(n for kind, n in self.counts.items() if kind not in {"read", "refused"})


def seeds_in(folder: Path) -> list[dict[str, bytes]]:
    """The inputs below a folder, each a folder of files."""
    found = []
    for place in sorted(p for p in folder.iterdir() if p.is_dir()):
        files = {str(f.relative_to(place)): f.read_bytes() for f in sorted(place.rglob("*")) if f.is_file()}
        assert sum(map(len, files.values())) < SMALL_BYTES, place
        found.append(files)
    return found


def variant(seeds, name: str, number: int) -> dict[str, bytes]:
    """Input `number` of a reader; the same every time."""
    rng = random.Random(f"{name} {number}")
    files = dict(rng.choice(seeds))
    for _ in range(rng.choice((1, 1, 1, 2))):
        which = rng.choice(sorted(files))
        if len(files) > 1 and rng.random() < 0.01:
            del files[which]
            continue
        files[which] = damaged(rng, files[which], which.lower())
    return files


def put(files: dict[str, bytes], folder: Path) -> Path:
    shutil.rmtree(folder, ignore_errors=True)
    folder.mkdir(parents=True)
    for name, data in files.items():
        (folder / name).parent.mkdir(parents=True, exist_ok=True)
        (folder / name).write_bytes(data)
    return folder


class TooLong(BaseException):
    """Raised by the timer within the reader."""


def _ring(*_):
    raise TooLong


def judged(read, folder: Path) -> tuple[str, str, float]:
    """What a reader does with an input: a kind of `Found.counts`, a sentence, CPU seconds."""
    before, began = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss, time.process_time()
    signal.signal(signal.SIGVTALRM, _ring)
    signal.setitimer(signal.ITIMER_VIRTUAL, SECONDS)
    kind, said = "read", ""
    try:
        wrong = read(folder)
        signal.setitimer(signal.ITIMER_VIRTUAL, 0)
        if wrong:
            kind, said = "nonsense", "; ".join(map(str, wrong))[:200]
    except RaybundleError as error:
        text = str(error)
        kind = "refused"
        if len(text) > 3000 or not text.replace("\n", " ").replace("\t", " ").isprintable():
            kind, said = "message", f"{len(text)} characters: {text[:150]!r}"
    except TooLong:
        kind, said = "slow", _where(sys.exc_info()[2])
    except MemoryError:
        kind, said = "memory", _where(sys.exc_info()[2])
    except BaseException as error:  # noqa: BLE001  (any other is what is looked for)
        kind, said = "foreign", f"{type(error).__name__}: {str(error)[:120]} @ {_where(error.__traceback__)}"
    finally:
        signal.setitimer(signal.ITIMER_VIRTUAL, 0)
    grown = (resource.getrusage(resource.RUSAGE_SELF).ru_maxrss - before) * 1024
    if kind in {"read", "refused"} and grown > EXTRA_BYTES:
        kind, said = "memory", f"{grown / 1e9:.2f} GB"
    return kind, said, time.process_time() - began


def _where(trace) -> str:
    ours = [f for f in traceback.extract_tb(trace) if "raybundle" in f.filename or "hostile" in f.filename]
    return " < ".join(f"{Path(f.filename).name}:{f.lineno}" for f in reversed(ours[-4:]))


def fuzz(target, seeds, numbers: range, work: Path, deadline: float = float("inf"), make=variant) -> Found:
    """Try the inputs of these numbers; after the deadline (of time.monotonic) no other than the first one."""
    found = Found()
    at = numbers.start
    while at < numbers.stop and (at == numbers.start or time.monotonic() < deadline):
        at = _batch(target, seeds, range(at, min(at + BATCH, numbers.stop)), work, found, deadline, make)
    return found


def _batch(target, seeds, numbers: range, work: Path, found: Found, deadline: float, make) -> int:
    """One child; the number after the last input that was tried."""
    reading, writing = os.pipe()
    sys.stdout.flush()
    sys.stderr.flush()
    child = os.fork()
    if child == 0:
        os.close(reading)
        _in_child(target, seeds, numbers, work, writing, deadline, make)
    os.close(writing)
    begun, silent = numbers.start, False
    with os.fdopen(reading, "rb", 0) as pipe:
        text = b""
        while True:
            if not select.select([pipe], [], [], SILENT_S)[0]:
                os.kill(child, signal.SIGKILL)
                silent = True
                break
            piece = pipe.read(1 << 16)
            if not piece:
                break
            text += piece
    status = os.waitpid(child, 0)[1]
    at = numbers.start
    for row in text.decode("utf-8", "replace").splitlines():
        with contextlib.suppress(ValueError):
            entry = json.loads(row)
            if isinstance(entry, int):
                begun = entry
                continue
            number, kind, said, seconds = entry
            at = number + 1
            found.counts[kind] += 1
            found.slowest_s = max(found.slowest_s, seconds)
            if kind not in {"read", "refused"}:
                found.examples.setdefault(f"{kind} {re.sub(r'[0-9.e+-]+', '#', said)[-120:]}", (number, said))
    if silent or status != 0:
        found.counts["killed"] += 1
        found.examples.setdefault("killed", (begun, "no answer" if silent else f"signal {status & 127}"))
        return begun + 1
    return at if at > numbers.start else numbers.stop


def _in_child(target, seeds, numbers, work, writing, deadline, make):
    faulthandler.disable()
    null = os.open(os.devnull, os.O_RDWR)
    for number in (0, 1, 2):
        os.dup2(null, number)
    sys.stdout = sys.stderr = io.StringIO()
    now = int(Path("/proc/self/statm").read_text().split()[0]) * resource.getpagesize()
    resource.setrlimit(resource.RLIMIT_AS, (now + 4 * EXTRA_BYTES,) * 2)
    resource.setrlimit(resource.RLIMIT_CORE, (0, 0))
    warnings.simplefilter("ignore")
    import numpy as np

    np.seterr(all="ignore")
    with os.fdopen(writing, "w") as pipe:
        for number in numbers:
            if number > numbers.start and time.monotonic() > deadline:
                break
            pipe.write(f"{number}\n")
            pipe.flush()
            folder = put(make(seeds, target.name, number), work / target.name)
            outcome = judged(target.read, folder)
            pipe.write(json.dumps([number, *outcome]) + "\n")
            pipe.flush()
            if outcome[0] == "memory":  # the peak of this process would hide the next one
                break
    os._exit(0)
