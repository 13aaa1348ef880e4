"""Damaged inputs for every reader, as many as time allows; goes on where it was stopped.

    python benchmarks/fuzz_readers.py                     5000 new inputs for each reader, 300 for slow ones
    python benchmarks/fuzz_readers.py --count 200 block   so many for some readers
    python benchmarks/fuzz_readers.py --replay block 4711 the input of a number, into benchmarks/work/replay

Each input is tried in a child process with a limit of CPU time (10 s) and memory (1 GB more than before).  An input is
known by its reader and its number; numbers continue behind those of earlier runs, so each run tries new ones.
Writes benchmarks/results/fuzz_readers.json after each reader; exit status 1 where anything but an error of raybundle,
or a sound value, came out.
"""

import argparse
import json
import platform
import sys
import time
from importlib.metadata import version
from pathlib import Path

ROOT = Path(__file__).resolve().parents[1]
sys.path.insert(0, str(ROOT))
RESULTS = ROOT / "benchmarks/results/fuzz_readers.json"
WORK = ROOT / "benchmarks/work/fuzz"
COUNT, SLOW_COUNT = 5000, 300
FIRST = 1_000_000
"""Numbers below belong to the tests."""
AT_ONCE = 500
"""Inputs of a reader between two savings."""


def empty():
    return {"next": FIRST, "inputs": 0, "counts": {}, "slowest_s": 0.0, "cpu_s": 0.0, "examples": {}}


def saved():
    try:
        return json.loads(RESULTS.read_text(encoding="utf-8"))["readers"]
    except (OSError, ValueError, KeyError):
        return {}


def save(readers):
    machine = {"machine": platform.machine(), "python": platform.python_version(), "raybundle": version("raybundle")}
    total = sum(r["inputs"] for r in readers.values())
    bad = sum(n for r in readers.values() for kind, n in r["counts"].items() if kind not in {"read", "refused"})
    text = json.dumps({**machine, "inputs": total, "bad": bad, "readers": dict(sorted(readers.items()))}, indent=1)
    RESULTS.parent.mkdir(parents=True, exist_ok=True)
    beside = RESULTS.with_suffix(".partial")
    beside.write_text(text + "\n", encoding="utf-8")
    beside.replace(RESULTS)


def run(target, entry, count):
    """Try `count` more inputs of a reader; yields after each part."""
    from tests.hostile.fuzzing import fuzz, seeds_in

    top = WORK / "seeds" / target.name
    if not top.is_dir():
        target.seeds(top)
    seeds = seeds_in(top)
    end = entry["next"] + count
    while entry["next"] < end:
        numbers = range(entry["next"], min(entry["next"] + AT_ONCE, end))
        began = time.perf_counter()
        found = fuzz(target, seeds, numbers, WORK / "shm")
        for kind, n in found.counts.items():
            entry["counts"][kind] = entry["counts"].get(kind, 0) + n
        entry["examples"].update({k: list(v) for k, v in found.examples.items() if k not in entry["examples"]})
        entry["inputs"] += sum(found.counts.values())
        entry["slowest_s"] = round(max(entry["slowest_s"], found.slowest_s), 2)
        entry["cpu_s"] = round(entry["cpu_s"] + time.perf_counter() - began, 1)
        entry["next"] = numbers.stop
        yield


def row(name, entry):
    counts = entry["counts"]
    bad = {k: n for k, n in counts.items() if k not in {"read", "refused"}}
    return (
        f"{name:28}{entry['inputs']:>8}{counts.get('read', 0):>8}{counts.get('refused', 0):>9}{sum(bad.values()):>6}"
        f"{entry['slowest_s']:>9.2f} s"
    )


def main():
    from tests.hostile.fuzzing import put, seeds_in, variant
    from tests.hostile.readers import TARGETS

    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("readers", nargs="*", metavar="READER")
    parser.add_argument("--count", type=int)
    parser.add_argument("--afresh", action="store_true", help="forget earlier counts, not the numbers tried")
    parser.add_argument("--replay", nargs=2, metavar=("READER", "NUMBER"))
    o = parser.parse_args()
    if o.replay:
        name, number = o.replay
        top = WORK / "seeds" / name
        if not top.is_dir():
            TARGETS[name].seeds(top)
        print(put(variant(seeds_in(top), name, int(number)), ROOT / "benchmarks/work/replay"))
        return 0
    unknown = set(o.readers) - TARGETS.keys()
    if unknown:
        parser.error(f"unknown: {', '.join(sorted(unknown))}; known: {', '.join(sorted(TARGETS))}")
    readers = saved()
    if o.afresh:
        readers = {name: {**empty(), "next": entry["next"]} for name, entry in readers.items()}
    print(f"{'reader':28}{'inputs':>8}{'read':>8}{'refused':>9}{'bad':>6}{'slowest':>11}", flush=True)
    for name in o.readers or sorted(TARGETS):
        target = TARGETS[name]
        entry = readers.setdefault(name, empty())
        for _ in run(target, entry, o.count or (SLOW_COUNT if target.slow else COUNT)):
            save(readers)
        print(row(name, entry), flush=True)
        for kind, (number, said) in entry["examples"].items():
            print(f"    {kind.split()[0]} #{number}: {said}", flush=True)
    return int(any(r["examples"] for r in readers.values()))


if __name__ == "__main__":
    sys.exit(main())
