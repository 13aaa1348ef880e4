"""Mutation testing of the numeric core: which small changes of the source no test notices.

    python benchmarks/mutants.py map MAP.json TESTS...          which tests run which blocks of statements
    python benchmarks/mutants.py try MAP.json RESULT.jsonl -n 120 --seed 1

A mutant changes one operator, comparison, number, condition or sign within a function.  The source stays as it is: a
process that begins with the mutant compiles the changed text when it imports the module, as do the processes that its
tests begin.  An own script, as mutmut and cosmic-ray run either the whole suite for each mutant or a copy of the
package without its compiled part.

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
import builtins
import importlib.abc
import importlib.machinery
import importlib.util
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

ROOT = Path(__file__).resolve().parents[1]
SOURCE = ROOT / "src" / "raybundle"
CORE = ["adjustment", "sensors", "observations", "surfaces/depths/refine.py"]
SETTING = "RAYBUNDLE_MUTANT"
"""Environment variable that holds a mutant, for processes that tests begin"""
BUDGET_S = 25.0
"""Seconds of tests tried for a mutant, as measured without it"""
FEWEST, FIRST, SELDOM, MOST = 5, 8, 10, 150
"""Tests tried whatever they take; tried before all others are collected; of such as enter what a condition
decides on; no more than these"""
PLAIN = ("-q", "-p", "no:cacheprovider", "-o", "python_files=test_*.py")
"""Arguments of pytest, which else compiles modules called `..._test.py` itself"""
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


class Compiled(importlib.machinery.SourceFileLoader):
    """Compiles a module from a changed tree, and keeps nothing of it."""

    change = None

    def get_code(self, fullname):
        path = self.get_filename(fullname)
        return compile(self.change(Path(path)), path, "exec", dont_inherit=True)


class Finder(importlib.abc.MetaPathFinder):
    """Modules of the package of which the file is watched."""

    def __init__(self, files, change):
        self.files, self.change = frozenset(files), change

    def find_spec(self, fullname, path=None, target=None):
        del path, target
        if fullname.partition(".")[0] != SOURCE.name:
            return None
        place = SOURCE.parent.joinpath(*fullname.split("."))
        for file, within in ((place / "__init__.py", [str(place)]), (place.with_suffix(".py"), None)):
            if file in self.files:
                loader = Compiled(fullname, str(file))
                loader.change = self.change
                return importlib.util.spec_from_file_location(
                    fullname, file, loader=loader, submodule_search_locations=within
                )
        return None


def install(stated):
    """From now on the module of a mutant is compiled with it."""
    name, first, last, new = json.loads(stated)

    def changed(file):
        raw = file.read_bytes()
        return raw[:first] + new.encode() + raw[last:]

    sys.meta_path.insert(0, Finder([ROOT / name], changed))


def blocks(tree):
    """(key, statements) of each block: name of the function, and number of the block within it."""

    def within(body, name, count):
        count[0] += 1
        yield f"{name} {count[0]}", body
        for statement in body:
            if isinstance(statement, (ast.FunctionDef, ast.AsyncFunctionDef, ast.ClassDef)):
                yield from outer(statement, name)
                continue
            for field in ("body", "orelse", "finalbody"):
                if getattr(statement, field, None):
                    yield from within(getattr(statement, field), name, count)
            for part in (*getattr(statement, "handlers", ()), *getattr(statement, "cases", ())):
                yield from within(part.body, name, count)

    def outer(node, name=""):
        if isinstance(node, (ast.ClassDef, ast.Module)):
            for child in node.body:
                yield from outer(child, f"{name}.{getattr(node, 'name', '')}")
        elif isinstance(node, (ast.FunctionDef, ast.AsyncFunctionDef)):
            yield from within(node.body, f"{name}.{node.name}", [0])
        else:
            for child in ast.iter_child_nodes(node):
                if isinstance(child, ast.stmt):
                    yield from outer(child, name)

    yield from outer(tree)


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


class Recorder:
    """pytest plugin: which blocks each test ran, those of its fixtures included, and its seconds."""

    def __init__(self):
        self.hit, self.keys, self.imported = bytearray(), [], set()
        self.fixtures, self.tests, self.seconds, self.failed = {}, {}, {}, set()
        builtins.ran_ = self.hit

    def change(self, file):
        tree = ast.parse(file.read_text(encoding="utf-8"))
        for key, body in list(blocks(tree)):
            line = ast.parse(f"ran_[{len(self.keys)}] = 1").body[0]
            self.keys.append(f"{file.relative_to(ROOT)} {key}")
            self.hit.append(0)
            for node in ast.walk(line):
                if isinstance(node, (ast.stmt, ast.expr)):
                    ast.copy_location(node, body[0])
            described = isinstance(body[0], ast.Expr) and isinstance(body[0].value, ast.Constant)
            body.insert(int(described), line)
        return tree

    def taken(self):
        found = {i for i, hit in enumerate(self.hit) if hit} if any(self.hit) else set()
        self.hit[:] = bytes(len(self.hit))
        return found

    def pytest_collection_finish(self):
        self.imported = self.taken()

    @pytest.hookimpl(wrapper=True)
    def pytest_fixture_setup(self, fixturedef, request):
        del request
        before = self.taken()
        made = yield
        own = self.fixtures[id(fixturedef)] = self.taken()
        for i in before | own:
            self.hit[i] = 1
        return made

    @pytest.hookimpl(wrapper=True)
    def pytest_runtest_protocol(self, item, nextitem):
        del nextitem
        self.taken()
        done = yield
        ran = self.taken()
        for name, found in item._fixtureinfo.name2fixturedefs.items():  # noqa: SLF001
            del name
            for one in found:
                ran |= self.fixtures.get(id(one), set())
        self.tests[item.nodeid] = sorted(ran)
        return done

    def pytest_runtest_logreport(self, report):
        self.seconds[report.nodeid] = self.seconds.get(report.nodeid, 0.0) + report.duration
        if not report.passed:
            self.failed.add(report.nodeid)


def make_map(args):
    sys.path.insert(0, str(ROOT))
    recorder = Recorder()
    files = [file for package in args.packages for file in files_of(package)]
    sys.meta_path.insert(0, Finder(files, recorder.change))
    with tempfile.TemporaryDirectory() as place:
        pytest.main([*PLAIN, f"--basetemp={place}/t", *args.arguments, *args.tests], plugins=[recorder])
    table = {"seconds": {}, "tests": {}, "imported": []}
    if Path(args.map).exists():
        table = json.loads(Path(args.map).read_text(encoding="utf-8"))
    table["imported"] = sorted({*table.get("imported", []), *(recorder.keys[i] for i in recorder.imported)})
    again = {test.partition("::")[0] for test in recorder.tests}
    for name in ("tests", "seconds"):  # what these files held before may be gone
        table[name] = {test: v for test, v in table[name].items() if test.partition("::")[0] not in again}
    for test, ran in recorder.tests.items():
        table["seconds"][test] = round(recorder.seconds.get(test, 9.0), 3)
        if test not in recorder.failed:
            table["tests"][test] = [recorder.keys[i] for i in ran]
    Path(args.map).write_text(json.dumps(table), encoding="utf-8")


def files_of(package):
    place = SOURCE / package
    return sorted(f for f in place.rglob("*.py") if "generated" not in f.parts) if place.is_dir() else [place]


def chosen_tests(table, file, line):
    """Tests that are worth trying, best first."""
    own, within = blocks_of(file, line)
    key = f"{file.relative_to(ROOT)} {own}"
    ran_within = [found for w in within if (found := table["blocks"].get(f"{file.relative_to(ROOT)} {w}"))]
    seldom = frozenset(min(ran_within, key=len, default=()))
    ran = table["tests"] if key in table["imported"] else table["blocks"].get(key, [])
    module = ".".join(file.relative_to(SOURCE.parent).with_suffix("").parts)
    parent, _, name = module.rpartition(".")
    named = re.compile(rf"{re.escape(module)}\b|from {re.escape(parent)} import [^\n]*\b{name}\b")
    package = module.split(".")[1].rstrip("s")
    seconds, texts = table["seconds"], table["texts"]
    for test in () if texts else table["tests"]:
        path = test.partition("::")[0]
        texts[path] = texts.get(path) or (ROOT / path).read_text(encoding="utf-8")
    if not ran:
        alone = [p for p, words in texts.items() if named.search(words) or ("subprocess" in words and package in p)]
        ran = [test for test in table["tests"] if test.partition("::")[0] in alone]

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
        failed = [line for line in lines if line.startswith(("FAILED", "ERROR"))]
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
    table = json.loads(Path(args.map).read_text(encoding="utf-8"))
    table["texts"], table["blocks"] = {}, {}
    for test, keys in table["tests"].items():
        for key in keys:
            table["blocks"].setdefault(key, []).append(test)
    out = Path(args.result)
    rows = [json.loads(line) for line in out.read_text(encoding="utf-8").splitlines()] if out.exists() else []
    done = {(r["file"], *r["at"]) for r in rows}
    for package, file, mutant in drawn(args.packages, args.n, args.seed):
        name, at = str(file.relative_to(ROOT)), [*mutant]
        if (name, *at) in done:
            continue
        begun = time.time()
        raw = file.read_bytes()
        tests = chosen_tests(table, file, mutant[0])
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
    ways = parser.add_subparsers(dest="way", required=True)
    mapped = ways.add_parser("map")
    mapped.add_argument("map")
    mapped.add_argument("tests", nargs="+")
    mapped.add_argument("--packages", nargs="+", default=CORE)
    mapped.add_argument("--arguments", nargs="*", default=["-m", "not bench and not long"], help="of pytest")
    tried = ways.add_parser("try")
    tried.add_argument("map")
    tried.add_argument("result")
    tried.add_argument("-n", type=int, default=120)
    tried.add_argument("--seed", type=int, default=1)
    tried.add_argument("--packages", nargs="+", default=CORE)
    args = parser.parse_args()
    if args.way == "map":
        make_map(args)
    else:
        for name in ("hypothesis", "scipy.optimize", "scipy.sparse.linalg", "scipy.stats", "sympy"):
            importlib.import_module(name)  # once for all mutants
        try_mutants(args)


if __name__ == "__main__":
    main()
