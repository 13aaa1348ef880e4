"""Run the tests with every Python from 3.11 that this machine has, and with the oldest dependencies allowed.

python tools/versions.py [--only NAME]... [--list] [arguments of pytest]

One environment each under build/versions: one for every minor version of Python, with the newest dependencies, and
`oldest`: the lowest Python of `requires-python` with the lowest version of every dependency and of every requirement of
the build.  All bounds are read from pyproject.toml; uv resolves them (`--resolution lowest-direct`).  The package is
installed as a wheel, so that what is tested is what is delivered.  Exit status 1 where the tests of one environment
fail or it cannot be made; an environment whose Python is absent is named, not run: .github/workflows/test.yml has it.
"""

from __future__ import annotations

import argparse
import os
import re
import shutil
import subprocess
import sys
import tomllib
from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path

ROOT = Path(__file__).resolve().parents[1]
PLACE = ROOT / "build/versions"
TESTED_EXTRAS = ("pdf", "las", "heic", "plots")
"""Extras that the tests use; `learned` brings gigabytes, and its tests skip without it."""


@dataclass(frozen=True, slots=True, kw_only=True)
class Environment:
    """A Python and which end of the allowed dependencies it gets."""

    name: str
    python: Path
    oldest: bool


def lowest_python(pyproject: dict) -> tuple[int, int]:
    """Major and minor version that `requires-python` begins with; ValueError where it has no lower bound."""
    bound = re.search(r">=\s*(\d+)\.(\d+)", pyproject["project"]["requires-python"])
    if bound is None:
        raise ValueError("pyproject.toml: requires-python has no lower bound (>=)")
    return int(bound[1]), int(bound[2])


def candidates(lowest: tuple[int, int]) -> Iterator[Path]:
    """Programs that may be a Python: this one, those on the path, those that pyenv keeps."""
    yield Path(sys.executable)
    major, first = lowest
    for minor in range(first, first + 20):
        found = shutil.which(f"python{major}.{minor}")
        if found:
            yield Path(found)
    pyenv = Path(os.environ.get("PYENV_ROOT", Path.home() / ".pyenv"))
    yield from sorted(pyenv.glob("versions/*/bin/python"))


def pythons(lowest: tuple[int, int]) -> dict[tuple[int, int], Path]:
    """Base interpreter of every minor version from the lowest that answers (a shim of pyenv may not)."""
    ask = "import sys; print(*sys.version_info[:2], sys._base_executable, sys.implementation.name, sep='\\n')"
    found: dict[tuple[int, int], Path] = {}
    for program in candidates(lowest):
        done = subprocess.run([program, "-c", ask], capture_output=True, text=True, check=False)
        answer = done.stdout.split("\n")
        if done.returncode or answer[3] != "cpython":
            continue
        version = int(answer[0]), int(answer[1])
        if version >= lowest:
            found.setdefault(version, Path(answer[2]))
    return dict(sorted(found.items()))


def environments(found: dict[tuple[int, int], Path], lowest: tuple[int, int]) -> list[Environment]:
    """One for each Python, and the oldest dependencies where the lowest Python is there."""
    rows = [Environment(name=f"{a}.{b}", python=python, oldest=False) for (a, b), python in found.items()]
    if lowest in found:
        rows.append(Environment(name="oldest", python=found[lowest], oldest=True))
    return rows


def pins(environment: Environment, requirements: list[str], name: str) -> Path:
    """File of constraints: the lowest version of each requirement, those that it brings along as new as may be."""
    folder = PLACE / environment.name
    folder.mkdir(parents=True, exist_ok=True)
    asked, pinned = folder / f"{name}.in", folder / f"{name}.txt"
    asked.write_text("\n".join(requirements) + "\n")
    uv("pip", "compile", "--python", environment.python, "--resolution", "lowest-direct", "--no-annotate",
       "--no-header", "--output-file", pinned, asked)  # fmt: skip
    return pinned


def uv(*words: object) -> None:
    """Run uv of this environment, or of the system; CalledProcessError where it fails."""
    own = Path(sys.executable).with_name("uv")
    program = str(own) if own.exists() else "uv"
    subprocess.run([program, *map(str, words), "--quiet"], check=True, cwd=ROOT)


def made(environment: Environment, pyproject: dict) -> Path:
    """The environment's own Python, the package and the tools of the tests installed beside it."""
    folder = PLACE / environment.name
    python = folder / "venv/bin/python"
    if not python.exists():
        uv("venv", "--python", environment.python, folder / "venv")
    project = pyproject["project"]
    bounds: list[object] = []
    if environment.oldest:
        wanted = [
            *project["dependencies"],
            *(one for e in TESTED_EXTRAS for one in project["optional-dependencies"][e]),
        ]
        bounds = ["--constraint", pins(environment, wanted, "dependencies"),
                  "--build-constraint", pins(environment, pyproject["build-system"]["requires"], "build")]  # fmt: skip
    # a folder of its own for the compiler: the editable installation keeps its own under build/
    build = f"raybundle:build-dir={folder / 'cmake'}"
    uv("pip", "install", "--python", python, "--reinstall-package", "raybundle", "--group", "test", *bounds,
       "--config-settings-package", build, f".[{','.join(TESTED_EXTRAS)}]")  # fmt: skip
    return python


def passed(environment: Environment, pyproject: dict, arguments: list[str]) -> bool:
    """Whether the environment can be made and its tests are green."""
    print(f"== {environment.name}: {environment.python}", flush=True)
    try:
        python = made(environment, pyproject)
    except subprocess.CalledProcessError as error:
        print(f"{environment.name}: not made, status {error.returncode} of {' '.join(error.cmd)}", flush=True)
        return False
    words = [python, "-m", "pytest", "-p", "no:cacheprovider", *arguments]
    return subprocess.run(words, check=False, cwd=ROOT).returncode == 0


def main() -> int:
    """Run what is asked for, or everything; one line a result at the end."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--only", action="append", default=[], metavar="NAME", help="3.12, oldest, ...; repeatable")
    parser.add_argument("--list", action="store_true", help="name the environments, run nothing")
    options, arguments = parser.parse_known_args()
    pyproject = tomllib.loads((ROOT / "pyproject.toml").read_text())
    lowest = lowest_python(pyproject)
    every = environments(pythons(lowest), lowest)
    unknown = set(options.only) - {one.name for one in every}
    if unknown:
        parser.error(f"not on this machine: {', '.join(sorted(unknown))}; there are {', '.join(e.name for e in every)}")
    chosen = [one for one in every if not options.only or one.name in options.only]
    if options.list:
        print(*(f"{one.name}\t{one.python}" for one in chosen), sep="\n")
        return 0
    green = {one.name: passed(one, pyproject, arguments) for one in chosen}
    if "oldest" not in {one.name for one in every}:
        print(f"oldest: not run, no Python {lowest[0]}.{lowest[1]} on this machine")
    print(*(f"{name}: {'green' if ok else 'RED'}" for name, ok in green.items()), sep="\n")
    return 0 if all(green.values()) else 1


if __name__ == "__main__":
    sys.exit(main())
