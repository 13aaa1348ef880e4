"""Which blocks of statements each test runs: the map for `mutants.py` and `short_suite.py`.

    python benchmarks/block_coverage.py MAP.json [--packages adjustment ...] [-- ARGUMENTS OF PYTEST]

Tests that run replace their rows of a map that exists; functions and blocks that are gone are dropped.  A block is the
body of a function, of a branch or of a loop; where a condition has no `else`, passing it over is a block too.  What a
test runs in its fixtures and in processes that it begins, killed ones included, counts as its own: a byte for each
block lies in a file that all of them share.  Processes with an empty environment are not seen.
"""

from __future__ import annotations

import argparse
import ast
import base64
import builtins
import functools
import importlib.abc
import importlib.machinery
import importlib.util
import json
import marshal
import mmap
import os
import subprocess
import sys
import tempfile
import zlib
from pathlib import Path

ROOT = Path(__file__).resolve().parents[1]
SOURCE = ROOT / "src" / "raybundle"
PLACE = "RAYBUNDLE_COVERAGE"
"""Environment variable: the folder that the processes of a measurement share"""
HITS = "RAYBUNDLE_COVERAGE_HITS"
"""Environment variable: the file of one worker and of the processes that its tests begin"""
PLAIN = ("-q", "-p", "no:cacheprovider", "-o", "python_files=test_*.py")
"""Arguments of pytest, which else compiles modules called `..._test.py` itself"""
SHORT = ("-m", "not bench and not long")


def files_of(package):
    place = SOURCE / package
    return sorted(f for f in place.rglob("*.py") if "generated" not in f.parts) if place.is_dir() else [place]


class Compiled(importlib.machinery.SourceFileLoader):
    """Compiles a module in its own way, and keeps nothing of it."""

    def __init__(self, fullname, path, compiled):
        super().__init__(fullname, path)
        self.compiled = compiled

    def get_code(self, fullname):
        return self.compiled(Path(self.get_filename(fullname)))


class Finder(importlib.abc.MetaPathFinder):
    """Modules of the package of which the file is watched."""

    def __init__(self, files, compiled):
        self.files, self.compiled = frozenset(files), compiled

    def find_spec(self, fullname, path=None, target=None):
        del path, target
        if fullname.partition(".")[0] != SOURCE.name:
            return None
        place = SOURCE.parent.joinpath(*fullname.split("."))
        for file, within in ((place / "__init__.py", [str(place)]), (place.with_suffix(".py"), None)):
            if file in self.files:
                loader = Compiled(fullname, str(file), self.compiled)
                return importlib.util.spec_from_file_location(
                    fullname, file, loader=loader, submodule_search_locations=within
                )
        return None


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


def marked(tree):
    """(key, statements, statement beside) of all places that a hit stands for, passed-over conditions among them."""
    for key, body in list(blocks(tree)):
        conditions = [node for node in body if isinstance(node, ast.If) and not node.orelse]
        yield key, body, body[0]
        for number, node in enumerate(conditions):
            yield f"{key} past {number}", node.orelse, node


def tree_of(file):
    return ast.parse(file.read_text(encoding="utf-8"))


def instrumented(file, first):
    """Code of a file that marks each block when it is entered, counted from `first`."""
    tree = tree_of(file)
    for number, (_, body, beside) in enumerate(marked(tree), first):
        line = ast.parse(f"ran_[{number}] = 1").body[0]
        for node in ast.walk(line):
            if isinstance(node, (ast.stmt, ast.expr)):
                ast.copy_location(node, beside)
        described = body and isinstance(body[0], ast.Expr) and isinstance(body[0].value, ast.Constant)
        body.insert(int(bool(described)), line)
    return compile(tree, str(file), "exec", dont_inherit=True)


def opened(path):
    with open(path, "r+b") as file:  # noqa: PTH123
        return mmap.mmap(file.fileno(), 0)


def begin():
    """Marks blocks in this process from now on: sitecustomize of each process of a measurement calls it."""
    place = Path(os.environ[PLACE])
    plan = json.loads((place / "plan.json").read_text(encoding="utf-8"))

    def compiled(file):
        kept = place / f"{str(file.relative_to(SOURCE)).replace(os.sep, '.')}.code"
        if not kept.exists():
            part = kept.with_suffix(f".{os.getpid()}")
            part.write_bytes(marshal.dumps(instrumented(file, plan["first"][str(file)])))
            part.replace(kept)
        return marshal.loads(kept.read_bytes())  # noqa: S302

    hits = os.environ.get(HITS)
    builtins.ran_ = opened(hits) if hits else bytearray(plan["size"])
    sys.meta_path.insert(0, Finder(map(Path, plan["first"]), compiled))


def pytest_configure(config):
    """As a plugin: one recorder where tests run."""
    if PLACE in os.environ and (hasattr(config, "workerinput") or not getattr(config.option, "numprocesses", None)):
        config.pluginmanager.register(recorder(Path(os.environ[PLACE])))


def recorder(place):
    import numpy as np
    import pytest

    sys.path.insert(0, str(ROOT))
    from tests.slow import seconds

    path = place / f"hits-{os.getpid()}"
    path.write_bytes(bytes(len(builtins.ran_)))
    os.environ[HITS] = str(path)
    builtins.ran_ = opened(path)
    hit = np.frombuffer(builtins.ran_, np.uint8)
    starting = subprocess.Popen.__init__

    def watched(self, *args, env=None, **more):
        """Processes that get a PYTHONPATH of their own are watched too."""
        if env and "PYTHONPATH" in env and str(place) not in env["PYTHONPATH"]:
            env = {**env, "PYTHONPATH": f"{place}{os.pathsep}{env['PYTHONPATH']}"}
        starting(self, *args, env=env, **more)

    subprocess.Popen.__init__ = watched

    part = (place / f"part-{os.getpid()}.jsonl").open("w", encoding="utf-8")

    class Recorder:
        """Which blocks each test ran, those of its fixtures included, and its seconds: a line for each."""

        def __init__(self):
            self.fixtures, self.failed = {}, set()

        def taken(self):
            found = hit.copy()
            hit[:] = 0
            return found

        def pytest_collection_finish(self):
            part.write(json.dumps(["", 0, packed(self.taken())]) + "\n")

        @pytest.hookimpl(wrapper=True)
        def pytest_fixture_setup(self, fixturedef, request):
            del request
            before = self.taken()
            made = yield
            own = self.taken()
            self.fixtures[id(fixturedef)] = np.flatnonzero(own)
            hit[:] |= before | own
            return made

        @pytest.hookimpl(wrapper=True)
        def pytest_runtest_protocol(self, item, nextitem):
            del nextitem
            self.taken()
            begun = seconds()
            done = yield
            spent, ran = seconds() - begun, self.taken()
            for found in item._fixtureinfo.name2fixturedefs.values():  # noqa: SLF001
                for one in found:
                    ran[self.fixtures.get(id(one), [])] = 1
            row = [item.nodeid, round(spent, 3), None if item.nodeid in self.failed else packed(ran)]
            part.write(json.dumps(row) + "\n")
            part.flush()
            return done

        def pytest_runtest_logreport(self, report):
            if not report.passed:
                self.failed.add(report.nodeid)

    return Recorder()


def packed(hits):
    import numpy as np

    return base64.b64encode(zlib.compress(np.packbits(hits != 0).tobytes())).decode()


class Map:
    """Rows of tests, columns of blocks."""

    def __init__(self, path):
        import numpy as np

        table = json.loads(Path(path).read_text(encoding="utf-8"))
        self.keys, tests = table["blocks"], table["tests"]
        self.column = {key: i for i, key in enumerate(self.keys)}
        self.seconds = {test: spent for test, (spent, _) in tests.items()}
        self.tests = [test for test, (_, hits) in tests.items() if hits]

        self.bits = np.array([np.packbits(unpacked(tests[test][1], len(self.keys))) for test in self.tests])
        """Eight blocks a byte"""
        self.imported = unpacked(table["imported"], len(self.keys))

    def ran(self, key):
        """Tests that ran a block."""
        column = self.column.get(key)
        if column is None:
            return []
        if self.imported[column]:
            return self.tests
        held = self.bits[:, column >> 3] & (128 >> (column & 7))
        return [self.tests[i] for i in held.nonzero()[0]]


def unpacked(text, n):
    import numpy as np

    return np.unpackbits(np.frombuffer(zlib.decompress(base64.b64decode(text)), np.uint8))[:n] > 0


def merged(earlier, rows, keys):
    """A map of all that ran now, and of the other tests as the earlier map has them."""
    import numpy as np

    measured = {key.partition(" ")[0] for key in keys}
    older = [key for key in earlier["blocks"] if key.partition(" ")[0] not in measured] if earlier else ()
    every = [*keys, *older]
    place = {key: i for i, key in enumerate(every)}
    imported, tests = np.zeros(len(every), bool), {}

    def moved(text, columns):
        full = np.zeros(len(every), bool)
        at = columns[unpacked(text, len(columns))]
        full[at[at >= 0]] = True
        return full

    columns = np.array([place[key] for key in keys])
    for test, spent, text in rows:
        if test:
            tests[test] = [spent, text and packed(moved(text, columns))]
        else:
            imported |= moved(text, columns)
    if earlier:
        columns = np.array([place.get(key, -1) for key in earlier["blocks"]])
        imported |= moved(earlier["imported"], columns)
        for test, (spent, text) in earlier["tests"].items():
            if test not in tests and is_there(test):
                tests[test] = [spent, text and packed(moved(text, columns))]
    return {"blocks": every, "imported": packed(imported), "tests": tests}


@functools.cache
def source_of(path):
    return (ROOT / path).read_text(encoding="utf-8") if (ROOT / path).exists() else ""


def is_there(test):
    path, *_, function = test.partition("[")[0].split("::")
    return f"def {function}(" in source_of(path)


def measure(path, packages, arguments):
    keys, first, env = [], {}, dict(os.environ)
    for package in packages:
        for file in files_of(package):
            first[str(file)] = len(keys)
            keys += [f"{file.relative_to(ROOT)} {key}" for key, _, _ in marked(tree_of(file))]
    with tempfile.TemporaryDirectory() as folder:
        place = Path(folder)
        (place / "plan.json").write_text(json.dumps({"size": len(keys), "first": first}), encoding="utf-8")
        (place / "sitecustomize.py").write_text(
            f"import sys\nsys.path.insert(0, {str(ROOT / 'benchmarks')!r})\nimport block_coverage\n"
            "del sys.path[0]\nblock_coverage.begin()\n"
        )
        env["PYTHONPATH"] = os.pathsep.join(filter(None, [folder, env.get("PYTHONPATH")]))
        subprocess.run(
            [sys.executable, "-m", "pytest", *PLAIN, "-p", "block_coverage", f"--basetemp={place}/t",
             "-W", "ignore::pytest.PytestAssertRewriteWarning", *SHORT, *arguments],
            cwd=ROOT, check=False, env={**env, PLACE: folder},
        )  # fmt: skip
        rows = [json.loads(line) for part in place.glob("part-*.jsonl") for line in part.open(encoding="utf-8")]
    earlier = json.loads(path.read_text(encoding="utf-8")) if path.exists() else None
    path.write_text(json.dumps(merged(earlier, rows, keys)), encoding="utf-8")


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("map", type=Path)
    parser.add_argument("--packages", nargs="+", default=[""], help="below src/raybundle; default: all")
    end = sys.argv.index("--") if "--" in sys.argv else len(sys.argv)
    args = parser.parse_args(sys.argv[1:end])
    measure(args.map, args.packages, sys.argv[end + 1 :])


if __name__ == "__main__":
    main()
