"""Mutation testing of the numeric core: which small changes of the source no test notices.

    python benchmarks/block_coverage.py MAP.json -- -n 2 --dist loadfile      which tests run which blocks of statements
    python benchmarks/mutants.py MAP.json RESULT.jsonl -n 120 --seed 1

A mutant changes one operator, comparison, number, condition or sign within a function.  The source stays as it is: a
process that begins with the mutant compiles the changed text when it imports the module, as do the processes that its
tests begin.  An own script, as mutmut and cosmic-ray run either the whole suite for each mutant or a copy of the
package without its compiled part.  Tests of `tests/slow.txt` are not tried: what is measured is `make test`.

Tests of a mutant: of all that ran its block of statements, in themselves, in fixtures or by importing it, and passed,
first some that ran the least run block within the same statement (a condition decides on that); those in files that
name the module, those of the same package, then the rest, commands among them; within each the quickest, one case of
each function before its further cases, until BUDGET_S seconds are full.  Where none ran it within the process, those of
files that name the module, or begin processes of their own.

Left out by rule, as nothing that can be observed follows or as it stands for another mutant already:
- messages, texts, annotations, signatures, assertions, and what is raised;
- numbers below ROUNDING by half of them, and arguments `tol`, `rtol`, `atol`, `rcond`: limits of rounding and guards
  of divisions;
- `<` for `<=` between fractions (a side states a decimal number other than zero, divides, takes a root or is
  float()): equal values have no probability;
- the negated condition where a mutant of its only comparison or its `not` is the same;
- a number in `initial=` of a maximum, which stands for none at all, and in the shape of an array without elements;
- the 1 of a `-1` among the arguments of `reshape`, where any negative number stands for what is left.
"""

from __future__ import annotations

import argparse
import ast
import functools
import importlib
import json
import math
import os
import random
import re
import signal
import sys
import tempfile
import time
import traceback
from pathlib import Path

import pytest
from block_coverage import PLAIN, ROOT, SOURCE, Finder, Map, blocks, files_of

CORE = ["adjustment", "sensors", "observations", "surfaces/depths/refine.py"]
SETTING = "RAYBUNDLE_MUTANT"
"""Environment variable that holds a mutant, for processes that tests begin"""
BUDGET_S = 25.0
"""Seconds of tests tried for a mutant, as measured without it"""
FEWEST, FIRST, SELDOM, MOST = 5, 8, 10, 400
"""Tests tried whatever they take; tried before all others are collected; of such as enter what a condition
decides on; no more than these"""
ARGUMENTS = ("-x", *PLAIN, "-W", "ignore::pytest.PytestAssertRewriteWarning")
BROKEN = 77
"""Exit status of a process that did not get as far as its tests"""
LIMIT_S = 240.0
"""A mutant that takes longer never ends: it is caught"""
ROUNDING = 2e-6
"""Smaller numbers are limits of rounding or guards of divisions"""

BINARY = {ast.Add: "-", ast.Sub: "+", ast.Mult: "/", ast.Div: "*", ast.Pow: "*", ast.MatMult: "*", ast.FloorDiv: "/",
          ast.Mod: "*"}  # fmt: skip
COMPARED = {ast.Lt: "<=", ast.LtE: "<", ast.Gt: ">=", ast.GtE: ">", ast.Eq: "!=", ast.NotEq: "==", ast.Is: "is not",
            ast.IsNot: "is", ast.In: "not in", ast.NotIn: "in"}  # fmt: skip
UNSEEN = ("initial", "tol", "rtol", "atol", "rcond")
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

    rest = set()
    """Numbers of which the sign alone counts"""

    def walk(node):
        if isinstance(node, ast.Call):
            called = node.func.id if isinstance(node.func, ast.Name) else getattr(node.func, "attr", "")
            if called in PASSED_OVER or (called in {"zeros", "empty", "full"} and 0 in numbers(node.args[0])):
                return
            if called == "reshape":
                sizes = [size for given in node.args for size in getattr(given, "elts", [given])]
                rest.update(id(size.operand) for size in sizes if isinstance(size, ast.UnaryOp))
        if isinstance(node, ast.JoinedStr) or (isinstance(node, ast.keyword) and node.arg in UNSEEN):
            return
        if isinstance(node, ast.BinOp) and type(node.op) in BINARY and not text(node):
            old = {ast.Add: "+", ast.Sub: "-", ast.Mult: "*", ast.Div: "/", ast.Pow: "**", ast.MatMult: "@",
                   ast.FloorDiv: "//", ast.Mod: "%"}[type(node.op)]  # fmt: skip
            yield from between(node.left, node.right, old, BINARY[type(node.op)], node.lineno)
        if isinstance(node, ast.Compare) and len(node.ops) == 1:
            names = {ast.Lt: "<", ast.LtE: "<=", ast.Gt: ">", ast.GtE: ">=", ast.Eq: "==", ast.NotEq: "!=",
                     ast.Is: "is", ast.IsNot: "is not", ast.In: "in", ast.NotIn: "not in"}  # fmt: skip
            kind = type(node.ops[0])
            ordered = issubclass(kind, (ast.Lt, ast.LtE, ast.Gt, ast.GtE))
            if not (ordered and (fractional(node.left) or fractional(node.comparators[0]))):
                yield from between(node.left, node.comparators[0], names[kind], COMPARED[kind], node.lineno)
        if isinstance(node, ast.BoolOp):
            old, new = ("and", "or") if isinstance(node.op, ast.And) else ("or", "and")
            yield from between(node.values[0], node.values[1], old, new, node.lineno)
        if isinstance(node, ast.UnaryOp) and isinstance(node.op, (ast.Not, ast.USub, ast.Invert)):
            first = place(node)[0]
            yield node.lineno, first, place(node.operand)[0], ""
        if isinstance(node, (ast.If, ast.IfExp, ast.While)) and not negated_already(node.test):
            first, last = place(node.test)
            yield node.test.lineno, first, last, f"(not ({raw[first:last].decode()}))"
        seen = isinstance(node, ast.Constant) and id(node) not in rest
        if seen and type(node.value) in (int, float) and not 0 < abs(node.value) < ROUNDING:
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


def numbers(node):
    return [part.value for part in getattr(node, "elts", [node]) if isinstance(part, ast.Constant)]


def fractional(node):
    """Whether an expression states a decimal number other than zero, divides, takes a root, or is a `float()`."""
    return any(
        (isinstance(part, ast.Call) and isinstance(part.func, ast.Name) and part.func.id == "float")
        or (isinstance(part, ast.Constant) and isinstance(part.value, float) and part.value != 0)
        or (isinstance(part, ast.BinOp) and isinstance(part.op, ast.Div))
        or (isinstance(part, ast.Attribute) and part.attr in {"sqrt", "hypot", "norm", "median"})
        for part in ast.walk(node)
    )


def negated_already(test):
    if isinstance(test, ast.UnaryOp):
        return isinstance(test.op, ast.Not)
    return (
        isinstance(test, ast.Compare)
        and len(test.ops) == 1
        and isinstance(test.ops[0], (ast.Eq, ast.NotEq, ast.Is, ast.IsNot, ast.In, ast.NotIn))
    )


def install(stated):
    """From now on the module of a mutant is compiled with it."""
    name, first, last, new = json.loads(stated)

    def compiled(file):
        raw = file.read_bytes()
        return compile(raw[:first] + new.encode() + raw[last:], str(file), "exec", dont_inherit=True)

    sys.meta_path.insert(0, Finder([ROOT / name], compiled))


def blocks_of(file, line):
    """Key of the innermost block that holds a line, and those of the blocks within its statement there."""
    every = list(blocks(ast.parse(file.read_text(encoding="utf-8"))))
    name, body = min(
        ((key, body) for key, body in every if body[0].lineno <= line <= body[-1].end_lineno),
        key=lambda held: held[1][-1].end_lineno - held[1][0].lineno,
    )
    at = next(statement for statement in body if line <= statement.end_lineno)
    within = [key for key, inner in every if at.lineno < inner[0].lineno and inner[-1].end_lineno <= at.end_lineno]
    return name, [key for key in within if key != name]


@functools.cache
def source_of(path):
    return (ROOT / path).read_text(encoding="utf-8")


def chosen_tests(table, long, file, line):
    """Tests that are worth trying, best first."""

    def runners(key):
        return [test for test in table.ran(f"{file.relative_to(ROOT)} {key}") if test not in long]

    own, within = blocks_of(file, line)
    seldom = frozenset(min(filter(None, map(runners, within)), key=len, default=()))
    ran = runners(own)
    module = ".".join(file.relative_to(SOURCE.parent).with_suffix("").parts)
    parent, _, name = module.rpartition(".")
    named = re.compile(rf"{re.escape(module)}\b|from {re.escape(parent)} import [^\n]*\b{name}\b")
    package = module.split(".")[1].rstrip("s")
    seconds, texts = table.seconds, {}
    for path in {test.partition("::")[0] for test in table.tests}:
        texts[path] = source_of(path)
    if not ran:
        alone = [p for p, words in texts.items() if named.search(words) or ("subprocess" in words and package in p)]
        ran = [test for test in table.tests if test.partition("::")[0] in alone and test not in long]

    def rank(test):
        path = test.partition("::")[0]
        near = 0 if named.search(texts[path]) else 1 if path.split("/")[1].rstrip("s") == package else 2
        return near, seconds[test]

    cases = {}
    for test in sorted(ran, key=rank):
        cases.setdefault(test.partition("[")[0], []).append(test)
    further = {test for function in cases.values() for test in function[1:]}
    ordered = sorted(ran, key=lambda test: (rank(test)[0], test in further, seconds[test]))
    ordered = list(dict.fromkeys([*sorted(seldom, key=rank)[:SELDOM], *ordered]))
    spent, chosen = 0.0, []
    for test in ordered[:MOST]:
        spent += seconds[test]
        if spent > BUDGET_S and len(chosen) >= FEWEST:
            continue
        chosen.append(test)
    return chosen


def attempt(stated, tests):
    """Whether a test notices the mutant, and which: in a process of its own, few tests before more are collected."""
    with tempfile.TemporaryDirectory() as place:
        output = Path(place) / "output"
        (Path(place) / "sitecustomize.py").write_text(
            f"import os, sys\nsys.path.insert(0, {str(ROOT / 'benchmarks')!r})\nimport mutants\n"
            f"del sys.path[0]\nmutants.install(os.environ[{SETTING!r}])\n"
        )
        child = os.fork()
        if not child:
            code = BROKEN
            try:
                os.setsid()
                os.chdir(ROOT)
                for stream in (1, 2):
                    os.dup2(os.open(output, os.O_CREAT | os.O_WRONLY | os.O_APPEND), stream)
                os.environ.update({SETTING: stated, "PYTHONPATH": place})
                install(stated)
                for number, part in enumerate((tests[:FIRST], tests[FIRST:])):
                    if part and (not number or not code):
                        code = int(pytest.main([*ARGUMENTS, f"--basetemp={place}/{number}", *part]))
                sys.stdout.flush()
            except BaseException:
                traceback.print_exc()
                raise
            finally:
                os._exit(code)
        ended = time.monotonic() + LIMIT_S
        status = None
        while status is None:
            done, value = os.waitpid(child, os.WNOHANG)
            if done:
                status = value
            elif time.monotonic() > ended:
                os.killpg(child, signal.SIGKILL)
                os.waitpid(child, 0)
                return True, "too long"
            else:
                time.sleep(0.05)
        lines = output.read_text(encoding="utf-8", errors="replace").splitlines()
        failed = [line for line in lines if line.startswith(("FAILED ", "ERROR "))]
        if os.waitstatus_to_exitcode(status) == pytest.ExitCode.USAGE_ERROR and not failed:
            return False, "not tried: pytest finds a test by no name"
        if os.waitstatus_to_exitcode(status) == BROKEN:
            raise RuntimeError("\n".join(lines[-20:]))
        return status != 0, failed[0] if failed else f"exit {os.waitstatus_to_exitcode(status)}"


def drawn(packages, n, seed):
    """As many mutants of each package as its share of all, ten at least."""
    found = {p: [(f, m) for f in files_of(p) for m in sorted(set(mutants(f)))] for p in packages}
    total = sum(map(len, found.values()))
    draw = random.Random(seed)
    chosen = []
    for package, all_of in found.items():
        share = min(max(round(n * len(all_of) / total), 10), len(all_of))
        print(f"{package}: {len(all_of)} mutants, {share} drawn (seed {seed})", flush=True)
        chosen += [(package, *one) for one in draw.sample(all_of, share)]
    return chosen


def try_mutants(args):
    sys.path.insert(0, str(ROOT))
    table, long = Map(args.map), frozenset(Path(args.long).read_text(encoding="utf-8").splitlines())
    out = Path(args.result)
    rows = [json.loads(line) for line in out.read_text(encoding="utf-8").splitlines()] if out.exists() else []
    done = {(r["file"], *r["at"]) for r in rows}
    for package, file, mutant in drawn(args.packages, args.n, args.seed):
        name, at = str(file.relative_to(ROOT)), [*mutant]
        if (name, *at) in done:
            continue
        begun = time.time()
        raw = file.read_bytes()
        tests = chosen_tests(table, long, file, mutant[0])
        seen, why = attempt(json.dumps([name, *at[1:]]), tests) if tests else (False, "no test runs this block")
        row = {"package": package, "file": name, "at": at, "line": raw.decode().splitlines()[at[0] - 1].strip(),
               "old": raw[at[1]:at[2]].decode(), "new": at[3], "caught": seen, "why": why, "tests": len(tests),
               "seconds": round(time.time() - begun, 1)}  # fmt: skip
        rows.append(row)
        with out.open("a", encoding="utf-8") as file_out:
            file_out.write(json.dumps(row) + "\n")
        mark = "caught  " if seen else "SURVIVED"
        print(f"{len(rows)} {mark} {name}:{at[0]} {row['old']!r} -> {at[3]!r}  {why[:90]}", flush=True)
    for package in (*args.packages, ""):
        of = [r["caught"] for r in rows if r["package"].startswith(package)]
        low, high = wilson(sum(of), len(of))
        print(f"{package or 'all'}: caught {sum(of)} of {len(of)}, 95 % interval {low:.0%} to {high:.0%}")


def wilson(caught, n, z=1.96):
    """Interval of a share (Wilson 1927)."""
    middle = (caught + z * z / 2) / (n + z * z)
    half = z * math.sqrt(caught * (n - caught) / n + z * z / 4) / (n + z * z)
    return middle - half, middle + half


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("map")
    parser.add_argument("result")
    parser.add_argument("-n", type=int, default=120)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--packages", nargs="+", default=CORE)
    parser.add_argument("--long", default=ROOT / "tests/slow.txt", help="list of tests that are not tried")
    args = parser.parse_args()
    for name in ("hypothesis", "scipy.optimize", "scipy.sparse.linalg", "scipy.stats", "sympy"):
        importlib.import_module(name)  # once for all mutants
    try_mutants(args)


if __name__ == "__main__":
    main()
