"""Chooses the tests of `make test`; the others become tests/slow.txt, those of `make test-long`.

    pytest -m "not bench" --cpu CPU.txt                                      seconds of each test
    python benchmarks/block_coverage.py MAP.json -- -n 2 --dist loadfile     blocks that each test runs
    python benchmarks/short_suite.py CPU.txt... --map MAP.json

Long are all above `slow.MOST` seconds.  Of those above LEAST so many are short as bring the most blocks a second that
fewer than TIMES other short tests run (CORE_TIMES in the numeric core), less those that later ones made needless, and
the quickest case of each function; in tests of the core functions without cases, too, below WHOLE.  All below LEAST are
short, and those of ALWAYS: what they hold (formats, damaged files, words, kernels, the source itself) shows in no
block.  A test that is not in the map keeps its place, as does one that was not measured, and all below `slow.MOST`
without a map.  Of several measurements of a test the least counts.  What long tests alone run is counted, and --alone
writes which these are.
"""

from __future__ import annotations

import argparse
import sys
from pathlib import Path

import numpy as np
from block_coverage import ROOT, SOURCE, Map
from mutants import CORE

sys.path.insert(0, str(ROOT))
from tests import slow

LEAST, WHOLE, TIMES, CORE_TIMES = 0.08, 0.5, 1, 2
ALWAYS = (*slow.KEPT, "tests/words/", "tests/io/", "tests/hostile/test_fuzz.py", "tests/hostile/test_every_reader.py",
          "tests/hostile/readers/", "tests/published/", "tests/docs/", "tests/native/", "tests/public/", "tests/tools/",
          "tests/test_")  # fmt: skip
OF_CORE = ("tests/adjustment/", "tests/calibration/", "tests/observations/", "tests/sensors/")


def measured(files):
    spent = {}
    for file in files:
        for line in Path(file).read_text(encoding="utf-8").splitlines():
            seconds, name = line.split(" ", 1)
            spent[name] = min(float(seconds), spent.get(name, np.inf))
    return spent


def chosen(ran, seconds, counts, times):
    """Rows that are needed until each block (column) is run `times` times, or as often as all rows do it."""
    needed = np.minimum(times, counts + ran.sum(0))
    ran, needed = ran[:, needed > counts], (needed - counts)[needed > counts]
    lacking, left, order = needed.copy(), np.ones(len(ran), bool), []
    while lacking.any():
        gain = np.where(left, (ran @ (lacking > 0)) / seconds, 0)
        best = int(gain.argmax())
        order.append(best)
        left[best] = False
        lacking = np.maximum(lacking - ran[best], 0)
    held = ran[order].sum(0)
    for one in sorted(order, key=lambda i: -seconds[i]):
        if np.all(held - ran[one] >= needed):
            held -= ran[one]
            order.remove(one)
    return order


def times_of(keys, times, core):
    """How many tests are to run each block."""
    files = tuple(str((SOURCE / part).relative_to(ROOT)) for part in CORE)
    return np.array([core if key.startswith(files) else times for key in keys])


def divided(table, spent, least=LEAST, times=TIMES, core=CORE_TIMES):
    """Names of tests that are chosen, in their order, and of those that are long."""
    above = {name for name, s in spent.items() if s > slow.MOST and not name.startswith(slow.KEPT)}
    row = {name: i for i, name in enumerate(table.tests)} if table else {}
    free = [name for name in row
            if least <= spent.get(name, 0) and name not in above and not name.startswith(ALWAYS)]  # fmt: skip
    unknown = {name for name in slow.names() if name not in row and (name not in spent or spent[name] >= least)}
    if not free:
        return [], above | unknown
    n = len(table.keys)
    counts, ran = np.zeros(n, np.int64), np.zeros((len(free), n), np.float32)
    for name in spent.keys() & row.keys() - above - set(free):
        counts += np.unpackbits(table.bits[row[name]])[:n]
    for i, name in enumerate(free):
        ran[i] = np.unpackbits(table.bits[row[name]])[:n]
    wanted = times_of(table.keys, times, core)
    order = [free[i] for i in chosen(ran, np.array([spent[name] for name in free]), counts, wanted)]
    long = above | unknown | (set(free) - set(order))
    for function in {name.partition("[")[0] for name in free}:
        cases = [name for name in spent if name.partition("[")[0] == function]
        last = min(set(free) & set(cases), key=spent.__getitem__)
        if long.issuperset(cases) and (len(cases) > 1 or (spent[last] < WHOLE and last.startswith(OF_CORE))):
            order.append(last)
    return order, long - set(order)


def alone(table, long):
    """How many blocks a long test runs that no short one does, by test: those of most first, each block once."""
    is_long = np.array([name in long for name in table.tests])
    names, short = np.array(table.tests)[is_long], np.bitwise_or.reduce(table.bits[~is_long], axis=0)
    ran = np.unpackbits(table.bits[is_long] & ~short, axis=1)[:, : len(table.keys)]
    ran = ran[:, ran.any(0)]
    rows = {}
    while ran.any():
        best = int(ran.sum(1).argmax())
        rows[str(names[best])] = int(ran[best].sum())
        ran = ran[:, ran[best] == 0]
    return rows


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("cpu", nargs="+", type=Path)
    parser.add_argument("--map", type=Path)
    parser.add_argument("--least", type=float, default=LEAST, help="seconds from which a test can become long")
    parser.add_argument("--times", type=int, default=TIMES, help="tests that are to run a block")
    parser.add_argument("--core-times", type=int, default=CORE_TIMES, help="tests that are to run one of the core")
    parser.add_argument("--alone", type=Path, help="write the long tests that run what no short one does")
    args = parser.parse_args()
    spent, before = measured(args.cpu), slow.names()
    table = args.map and Map(args.map)
    order, long = divided(table, spent, args.least, args.times, args.core_times)
    slow.LIST.write_text("".join(f"{name}\n" for name in sorted(long)), encoding="utf-8")
    sums = [sum(s for name, s in spent.items() if name not in names) for names in (before, long)]
    print(f"short: {sums[0]:.0f} s before, {sums[1]:.0f} s now; {len(order)} chosen, {len(long - before)} moved")
    if table:
        rows = alone(table, long)
        print(f"{sum(rows.values())} of {len(table.keys)} blocks are run by long tests alone")
        if args.alone:
            args.alone.write_text("".join(f"{n} {name}\n" for name, n in rows.items()), encoding="utf-8")


if __name__ == "__main__":
    main()
