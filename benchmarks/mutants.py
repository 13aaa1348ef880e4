"""Mutation testing of the numeric core: which small changes of the source no test notices.

    python benchmarks/mutants.py map MAP.json TESTS...      which tests run which lines (needs the package coverage)
    python benchmarks/mutants.py try MAP.json RESULT.jsonl -n 200 --seed 1 PACKAGES...

A mutant changes one operator, comparison, number, condition or sign within a function.  It is written into the source
of this checkout (use one of its own), the tests that run its line are run, the quickest first, up to the first that
fails, and the source is put back.  Messages, texts and annotations are not changed.  An own script, as mutmut and
cosmic-ray run either the whole suite for each mutant or a copy of the package without its compiled part.
"""

from __future__ import annotations

import argparse
import ast
import json
import os
import random
import subprocess
import sys
import time
from pathlib import Path

ROOT = Path(__file__).resolve().parents[1]
SOURCE = ROOT / "src" / "raybundle"
MOST_TESTS = 40
"""Tests tried for a mutant, the quickest that run its line"""
LIMIT_S = 240.0
"""A mutant that takes longer never ends: it is caught"""

BINARY = {ast.Add: "-", ast.Sub: "+", ast.Mult: "/", ast.Div: "*", ast.Pow: "*", ast.MatMult: "*", ast.FloorDiv: "/",
          ast.Mod: "*"}  # fmt: skip
COMPARED = {ast.Lt: "<=", ast.LtE: "<", ast.Gt: ">=", ast.GtE: ">", ast.Eq: "!=", ast.NotEq: "==", ast.Is: "is not",
            ast.IsNot: "is", ast.In: "not in", ast.NotIn: "in"}  # fmt: skip
PASSED_OVER = ("Message", "Text", "phrase", "cast", "TypeVar", "fault", "warning", "note", "annotation")


def mutants(file):
    """(line, column, end, text) of each change of a file."""
    source = file.read_text(encoding="utf-8")
    tree = ast.parse(source)
    starts = [0]
    for line in source.encode().splitlines(keepends=True):
        starts.append(starts[-1] + len(line))
    raw = source.encode()

    def place(node):
        return (starts[node.lineno - 1] + node.col_offset, starts[node.end_lineno - 1] + node.end_col_offset)

    def between(left, right, old, new, line):
        first, last = place(left)[1], place(right)[0]
        gap = raw[first:last].decode()
        at = gap.find(old)
        if at >= 0 and "#" not in gap:
            yield line, first + at, first + at + len(old.encode()), new

    def walk(node):
        if isinstance(node, ast.Call):
            called = node.func.id if isinstance(node.func, ast.Name) else getattr(node.func, "attr", "")
            if called in PASSED_OVER:
                return
        if isinstance(node, ast.BinOp) and type(node.op) in BINARY and not text(node):
            old = {ast.Add: "+", ast.Sub: "-", ast.Mult: "*", ast.Div: "/", ast.Pow: "**", ast.MatMult: "@",
                   ast.FloorDiv: "//", ast.Mod: "%"}[type(node.op)]  # fmt: skip
            yield from between(node.left, node.right, old, BINARY[type(node.op)], node.lineno)
        if isinstance(node, ast.Compare) and len(node.ops) == 1:
            names = {ast.Lt: "<", ast.LtE: "<=", ast.Gt: ">", ast.GtE: ">=", ast.Eq: "==", ast.NotEq: "!=",
                     ast.Is: "is", ast.IsNot: "is not", ast.In: "in", ast.NotIn: "not in"}  # fmt: skip
            kind = type(node.ops[0])
            yield from between(node.left, node.comparators[0], names[kind], COMPARED[kind], node.lineno)
        if isinstance(node, ast.BoolOp):
            old, new = ("and", "or") if isinstance(node.op, ast.And) else ("or", "and")
            yield from between(node.values[0], node.values[1], old, new, node.lineno)
        if isinstance(node, ast.UnaryOp) and isinstance(node.op, (ast.Not, ast.USub, ast.Invert)):
            first = place(node)[0]
            yield node.lineno, first, place(node.operand)[0], ""
        if isinstance(node, (ast.If, ast.IfExp, ast.While)):
            first, last = place(node.test)
            yield node.test.lineno, first, last, f"(not ({raw[first:last].decode()}))"
        if isinstance(node, ast.Constant) and type(node.value) in (int, float):
            value = node.value + 1 if isinstance(node.value, int) else node.value * 1.5 + (node.value == 0)
            yield (node.lineno, *place(node), repr(value))
        for child in ast.iter_child_nodes(node):
            if child in getattr(node, "decorator_list", ()) or child is getattr(node, "annotation", 0):
                continue
            if isinstance(child, (ast.Raise, ast.Assert, ast.arguments)) or child is getattr(node, "returns", 0):
                continue
            yield from walk(child)

    for outer in ast.walk(tree):
        if isinstance(outer, (ast.FunctionDef, ast.AsyncFunctionDef)):
            for statement in outer.body:
                yield from walk(statement)


def text(node):
    return any(isinstance(part, ast.JoinedStr) or (isinstance(part, ast.Constant) and isinstance(part.value, str))
               for part in ast.walk(node))  # fmt: skip


class Lines:
    """pytest plugin: names the running test to coverage, and keeps its seconds."""

    def __init__(self, measured):
        self.measured, self.seconds = measured, {}

    def pytest_runtest_logstart(self, nodeid, location):
        del location
        self.measured.switch_context(nodeid)

    def pytest_runtest_logreport(self, report):
        self.seconds[report.nodeid] = self.seconds.get(report.nodeid, 0.0) + report.duration


def make_map(out, tests):
    import coverage
    import pytest

    measured = coverage.Coverage(data_file=None, source=[str(SOURCE)])
    measured.start()
    plugin = Lines(measured)
    pytest.main(["-q", "-p", "no:cacheprovider", "-m", "not bench", *tests], plugins=[plugin])
    measured.stop()
    data = measured.get_data()
    lines = {}
    for name in data.measured_files():
        found = data.contexts_by_lineno(name)
        lines[str(Path(name).relative_to(ROOT))] = {
            str(k): sorted(t for t in v if t) for k, v in found.items() if any(v)
        }
    table = {"seconds": plugin.seconds, "lines": lines}
    if Path(out).exists():
        old = json.loads(Path(out).read_text(encoding="utf-8"))
        table["seconds"] = old["seconds"] | table["seconds"]
        for name, found in old["lines"].items():
            here = lines.setdefault(name, {})
            for k, tests_of in found.items():
                here[k] = sorted({*here.get(k, ()), *tests_of})
    Path(out).write_text(json.dumps(table), encoding="utf-8")


def attempt(file, raw, mutant, tests):
    """Whether a test notices the mutant, and which."""
    _, first, last, new = mutant
    file.write_bytes(raw[:first] + new.encode() + raw[last:])
    environment = dict(os.environ, PYTHONDONTWRITEBYTECODE="1", OMP_NUM_THREADS="1")
    command = [
        sys.executable,
        "-m",
        "pytest",
        "-x",
        "-q",
        "--no-header",
        "-p",
        "no:cacheprovider",
        *tests,
    ]
    try:
        done = subprocess.run(
            command, cwd=ROOT, env=environment, capture_output=True, text=True, timeout=LIMIT_S, check=False
        )
    except subprocess.TimeoutExpired:
        return True, "too long"
    finally:
        file.write_bytes(raw)
    failed = [line for line in done.stdout.splitlines() if line.startswith(("FAILED", "ERROR"))]
    return done.returncode != 0, failed[0] if failed else f"exit {done.returncode}"


def try_mutants(args):
    table = json.loads(Path(args.map).read_text(encoding="utf-8"))
    found = []
    for package in args.packages:
        place = SOURCE / package
        files = sorted(f for f in place.rglob("*.py") if "generated" not in f.parts) if place.is_dir() else [place]
        found += [(f, m) for f in files for m in sorted(set(mutants(f)))]
    chosen = random.Random(args.seed).sample(found, min(args.n, len(found)))
    print(f"{len(found)} mutants, {len(chosen)} drawn (seed {args.seed})", flush=True)
    rows = Path(args.result).read_text(encoding="utf-8").splitlines() if Path(args.result).exists() else []
    done = {(r["file"], *r["at"]): r["caught"] for r in map(json.loads, rows)}
    caught = sum(done.values())
    for number, (file, mutant) in enumerate(chosen, 1):
        name, at = str(file.relative_to(ROOT)), [*mutant]
        if (name, *at) in done:
            continue
        begun = time.time()
        raw = file.read_bytes()
        tests = table["lines"].get(name, {}).get(str(mutant[0]), [])
        tests = sorted(tests, key=lambda t: table["seconds"].get(t, 9.0))[:MOST_TESTS]
        seen, why = attempt(file, raw, mutant, tests) if tests else (False, "no test runs this line")
        caught += seen
        line = raw.decode().splitlines()[mutant[0] - 1].strip()
        row = {"file": name, "at": at, "line": line, "old": raw[mutant[1]:mutant[2]].decode(), "new": mutant[3],
               "caught": seen, "why": why, "tests": len(tests), "seconds": round(time.time() - begun, 1)}  # fmt: skip
        with Path(args.result).open("a", encoding="utf-8") as out:
            out.write(json.dumps(row) + "\n")
        mark = "caught  " if seen else "SURVIVED"
        print(f"{number} {mark} {name}:{mutant[0]} {row['old']!r} -> {mutant[3]!r}  {why[:90]}", flush=True)
    print(f"caught {caught} of {len(chosen)}")


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    ways = parser.add_subparsers(dest="way", required=True)
    mapped = ways.add_parser("map")
    mapped.add_argument("map")
    mapped.add_argument("tests", nargs="+")
    tried = ways.add_parser("try")
    tried.add_argument("map")
    tried.add_argument("result")
    tried.add_argument("-n", type=int, default=200)
    tried.add_argument("--seed", type=int, default=1)
    tried.add_argument("packages", nargs="+")
    args = parser.parse_args()
    if args.way == "map":
        make_map(args.map, args.tests)
    else:
        try_mutants(args)


if __name__ == "__main__":
    main()
