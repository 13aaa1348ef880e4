"""Run sets of the ledger and write its page.

make ledger                                    all sets that have no result yet, then docs/ledger.md
make ledger LEDGER="--sets ring,field --redo"  these sets, again
make ledger LEDGER="--from FOLDER"             also the sets of a folder outside the repository
make ledger LEDGER="--page --check"            is docs/ledger.md that of the result files?
"""

from __future__ import annotations

import argparse
import multiprocessing
import os
import shutil
import sys
import time
from concurrent.futures import ProcessPoolExecutor, ThreadPoolExecutor
from concurrent.futures.process import BrokenProcessPool
from dataclasses import replace
from pathlib import Path
from typing import Any

from . import RESULTS, ROOT, SETS, peers, results
from .page import PAGE, page
from .sets import BadSet, LedgerSet, Places, read_sets


def main() -> int:
    """Run, report, write the page."""
    parser = argparse.ArgumentParser(
        prog="ledger", description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter
    )
    parser.add_argument("--sets", default="", metavar="NAME,...", help="run these sets alone")
    parser.add_argument("--from", dest="folders", type=Path, action="append", default=[], metavar="FOLDER",
                        help="read sets of this folder too; its results and page are written into it")  # fmt: skip
    parser.add_argument("--data", type=Path, action="append", default=[], metavar="FOLDER", help="look for files here")
    parser.add_argument("--cache", type=Path, default=ROOT / "build" / "ledger", metavar="FOLDER",
                        help="keep scenes, projects and runs here")  # fmt: skip
    parser.add_argument("--jobs", type=int, default=1, help="processes at once")
    parser.add_argument("--redo", action="store_true", help="run sets that have a result again")
    parser.add_argument("--page", action="store_true", help="write the page alone")
    parser.add_argument("--check", action="store_true", help="with --page: compare it, write nothing")
    given = parser.parse_args()
    if given.page:
        return _page(check=given.check)
    try:
        own, outside = read_sets([SETS]), read_sets(given.folders) if given.folders else []
    except BadSet as error:
        parser.error(str(error))
    empty = [str(f) for f in given.folders if not any(f.glob("*.toml"))]
    if empty:
        parser.error(f"no set NAME.toml in {', '.join(empty)}")
    wanted = {name for name in given.sets.split(",") if name}
    unknown = wanted - {one.name for one in (*own, *outside)}
    if unknown:
        parser.error(f"no set is called {', '.join(sorted(unknown))}")
    shared = Path(os.environ.get("RAYBUNDLE_DATA", ROOT.parent / "shared" / "data"))
    places = Places(data=(*given.data, *given.folders, shared, given.cache / "data"), cache=given.cache)
    if not given.folders and not wanted:
        peers.keep()
    failed = _run_all(_due(own, wanted, RESULTS, redo=given.redo), places, RESULTS, given.jobs, redo=given.redo)
    if outside:
        there = given.folders[0] / "results"
        apart = replace(places, cache=given.cache / "outside" / given.folders[0].resolve().name)
        due = _due(outside, wanted, there, redo=given.redo)
        failed += _run_all(due, apart, there, given.jobs, redo=given.redo)
        (given.folders[0] / "ledger.md").write_text(page(outside, results.read(there)), encoding="utf-8")
    _page()
    return int(failed > 0)


def _due(sets: list[LedgerSet], wanted: set[str], folder: Path, *, redo: bool) -> list[LedgerSet]:
    """Sets that are to be run: those wanted, without those that have figures."""
    done = set() if redo else {name for name, found in results.read(folder).items() if found["groups"]}
    return [one for one in sets if (not wanted or one.name in wanted) and one.name not in done]


def _run_all(sets: list[LedgerSet], places: Places, folder: Path, jobs: int, *, redo: bool) -> int:
    """Run sets, again from nothing where `redo`; the number of those that have no figures."""
    failed = 0
    for one in sets if redo else ():
        shutil.rmtree(places.cache / one.name, ignore_errors=True)
    with ThreadPoolExecutor(max(jobs, 1)) as pool:
        for found in pool.map(_by_itself, sets, [places] * len(sets)):
            results.write(found, folder)
            failed += bool(found["reason"])
            figures = found["reason"] or ", ".join(
                f"{g['module']} {g['label']} {g['method'] if g['method'] != 'raybundle' else ''}".strip()
                + f" {g['chi_square']:.2f}"
                for g in found["groups"]
            )
            print(f"{found['name']}: {found['cpu_s']} s; {figures}", file=sys.stderr, flush=True)
    return failed


def _by_itself(one: LedgerSet, places: Places) -> dict[str, Any]:
    """The figures of a set by a process of its own: one that is killed ends no other set."""
    began = time.perf_counter()
    with ProcessPoolExecutor(1, multiprocessing.get_context("spawn")) as pool:
        try:
            return pool.submit(results.run, one, places).result()
        except BrokenProcessPool:
            return results.killed(one, time.perf_counter() - began)


def _page(*, check: bool = False) -> int:
    text = page(read_sets([SETS]), results.read(RESULTS))
    if check:
        same = PAGE.exists() and PAGE.read_text(encoding="utf-8") == text
        if not same:
            print("docs/ledger.md is not that of benchmarks/results/ledger; run: make ledger LEDGER=--page")
        return int(not same)
    PAGE.write_text(text, encoding="utf-8")
    return 0


if __name__ == "__main__":
    raise SystemExit(main())
