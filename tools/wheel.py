"""Build the sdist and wheels as they would be published, install each into an empty environment, and try it there.

python tools/wheel.py [--only 3.12]... [--dist FOLDER]

What is done:

1. `python -m build --sdist`; it must hold every file that is under version control, and what scikit-build-core adds.
2. From the sdist, unpacked outside the repository, `python -m build --wheel` for every Python from `requires-python`
   that this machine has: so a wheel needs nothing that the sdist lacks.  The wheel's content is checked.
3. An empty environment, with this wheel and what it requires and nothing else.  What takes how much space is said; more
   than LIMIT_MB is a failure.
4. The tests in tests/smoke, copied to a folder of their own, run there against that environment.

Exit status 1 where one of these fails.  With --dist, wheels and sdist are left there; else under build/wheel/dist.
"""

from __future__ import annotations

import argparse
import os
import shutil
import subprocess
import sys
import tarfile
import tempfile
import time
import tomllib
import zipfile
from importlib import metadata
from pathlib import Path

sys.path.insert(0, str(Path(__file__).parent))
from versions import ROOT, lowest_python, pythons, uv

PLACE = ROOT / "build/wheel"
LIMIT_MB = 500
"""Of an environment with the package and all that it requires, in units of 10^6 bytes."""
NEEDED = (
    "raybundle/__init__.pyi",
    "raybundle/py.typed",
    "raybundle/report/languages/de.txt",
    "raybundle/studio/static/index.html",
)
"""Files of a wheel that are no Python and without which it would do less than the repository does."""
NOT_PUBLISHED = (".ci/", ".github/", ".gitignore")
"""What is under version control for the forge alone."""


class Failure(Exception):
    """What is wrong with a distribution."""


def run(*words: object, folder: Path = ROOT, variables: dict[str, str] | None = None) -> None:
    """Run a program; CalledProcessError where it fails."""
    subprocess.run([str(w) for w in words], check=True, cwd=folder, env={**os.environ, **(variables or {})})


def versioned() -> set[str]:
    """Files under version control that are published, by their path from the root."""
    done = subprocess.run(["git", "ls-files", "-z"], check=True, cwd=ROOT, capture_output=True, text=True)
    return {f for f in done.stdout.split("\0") if f and (ROOT / f).exists() and not f.startswith(NOT_PUBLISHED)}


def sdist_problems(names: set[str], wanted: set[str]) -> list[str]:
    """What an sdist lacks, and what it holds that is not under version control."""
    missing = sorted(wanted - names)
    beyond = sorted(names - wanted - {"PKG-INFO"})
    return [*(f"the sdist lacks {f}" for f in missing), *(f"the sdist holds {f}, which is no source" for f in beyond)]


def wheel_problems(names: set[str], source: set[str]) -> list[str]:
    """What a wheel lacks of the package, and what it holds that is no part of it.

    names   files of the wheel
    source  files of the package in the repository, as raybundle/...
    """
    info = {n for n in names if n.split("/")[0].endswith(".dist-info")}
    native = {n for n in names if n.startswith("raybundle/_native.") and n.endswith((".so", ".pyd"))}
    missing = sorted((source | set(NEEDED)) - names)
    beyond = sorted(names - info - native - source)
    problems = [f"the wheel lacks {f}" for f in missing]
    problems += [f"the wheel holds {f}, which is not of the package" for f in beyond]
    if len(native) != 1:
        problems.append(f"the wheel holds {len(native)} compiled modules raybundle/_native, not 1")
    for needed in ("METADATA", "entry_points.txt", "licenses/LICENSE"):
        if not any(n.endswith(needed) for n in info):
            problems.append(f"the wheel has no {needed}")
    return problems


def builder(python: Path, name: str) -> Path:
    """Python of an environment that has `build` and nothing else."""
    folder = PLACE / name / "builder"
    inside = program(folder, "python")
    if not inside.exists():
        uv("venv", "--python", python, folder)
        uv("pip", "install", "--python", inside, "build[uv]>=1.2")
    return inside


def program(folder: Path, name: str) -> Path:
    """A program of a virtual environment."""
    return folder / ("Scripts" if os.name == "nt" else "bin") / (f"{name}.exe" if os.name == "nt" else name)


def built(python: Path, source: Path, out: Path, kind: str) -> Path:
    """The distribution (kind "sdist" or "wheel") that `python -m build` makes of a source folder."""
    before = set(out.glob("*")) if out.exists() else set()
    with tempfile.TemporaryDirectory() as fresh:
        run(python, "-m", "build", f"--{kind}", "--installer", "uv", "--outdir", fresh, source, folder=Path(fresh),
            variables={"RAYBUNDLE_REQUIRE_NATIVE": "1"})  # fmt: skip
        (file,) = (f for f in Path(fresh).iterdir() if f.is_file() and f.name != ".gitignore")
        out.mkdir(parents=True, exist_ok=True)
        place = out / file.name
        if place in before:
            place.unlink()
        return Path(shutil.move(file, place))


def check_sdist(file: Path) -> None:
    """Failure where it is not complete."""
    with tarfile.open(file) as archive:
        names = {m.name.partition("/")[2] for m in archive if m.isfile()}
    problems = sdist_problems(names, versioned())
    if problems:
        raise Failure("\n".join(problems))
    print(f"{file.name}: {len(names)} files, {file.stat().st_size / 1e6:.1f} MB", flush=True)


def check_wheel(file: Path) -> None:
    """Failure where something is missing or does not belong there."""
    with zipfile.ZipFile(file) as archive:
        names = {n for n in archive.namelist() if not n.endswith("/")}
    source = {f.removeprefix("src/") for f in versioned() if f.startswith("src/raybundle/")}
    problems = wheel_problems(names, source)
    if problems:
        raise Failure("\n".join(problems))
    print(f"{file.name}: {len(names)} files, {file.stat().st_size / 1e6:.1f} MB", flush=True)


def installed(python: Path, wheel: Path, name: str) -> Path:
    """A new environment that has the wheel, what it requires, and nothing else."""
    folder = PLACE / name / "empty"
    shutil.rmtree(folder, ignore_errors=True)
    uv("venv", "--python", python, folder)
    uv("pip", "install", "--python", program(folder, "python"), wheel)
    return folder


def sizes(environment: Path) -> dict[str, float]:
    """Space of each distribution of an environment [10^6 bytes], the largest first."""
    (place,) = environment.glob("Lib/site-packages" if os.name == "nt" else "lib/python*/site-packages")
    found = {}
    for one in metadata.distributions(path=[str(place)]):
        files = (Path(str(one.locate_file(f))) for f in one.files or ())
        found[one.metadata["Name"]] = sum(f.stat().st_size for f in files if f.is_file()) / 1e6
    return dict(sorted(found.items(), key=lambda pair: -pair[1]))


def check_size(environment: Path) -> float:
    """Say what takes how much space; Failure above the limit."""
    each = sizes(environment)
    total = sum(each.values())
    large = [f"{name} {size:.0f}" for name, size in each.items() if size >= 5]
    print(f"installed {total:.0f} MB in {len(each)} packages, of these {', '.join(large)}", flush=True)
    if total > LIMIT_MB:
        raise Failure(f"what is installed takes {total:.0f} MB, more than {LIMIT_MB}")
    return total


def smoke(environment: Path) -> None:
    """Run tests/smoke from a folder outside the repository; CalledProcessError where one fails."""
    with tempfile.TemporaryDirectory() as place:
        shutil.copytree(ROOT / "tests/smoke", Path(place) / "smoke", ignore=shutil.ignore_patterns("__pycache__"))
        # a path of Python's own would let the repository in
        outside = {k: v for k, v in os.environ.items() if k not in {"PYTHONPATH", "PYTHONHOME"}}
        outside["RAYBUNDLE_TRIED"] = str(program(environment, "python"))
        words = [sys.executable, "-m", "pytest", "-q", "-p", "no:cacheprovider", "--rootdir", place, "smoke"]
        subprocess.run(words, check=True, cwd=place, env=outside)


def tried(name: str, python: Path, sdist: Path, out: Path) -> str:
    """What came of one Python, in a line; Failure or CalledProcessError where it is not as it should be."""
    print(f"== {name}: {python}", flush=True)
    start = time.monotonic()
    with tempfile.TemporaryDirectory() as outside, tarfile.open(sdist) as archive:
        archive.extractall(outside, filter="data")
        (source,) = Path(outside).iterdir()
        wheel = built(builder(python, name), source, out, "wheel")
    took = time.monotonic() - start
    check_wheel(wheel)
    environment = installed(python, wheel, name)
    total = check_size(environment)
    smoke(environment)
    return f"{wheel.name}, built in {took:.0f} s, installed {total:.0f} MB, smoke tests green"


def main() -> int:
    """Build, check, install, try; one line a Python at the end."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--only", action="append", default=[], metavar="VERSION", help="3.12, ...; repeatable")
    parser.add_argument("--dist", type=Path, default=PLACE / "dist", metavar="FOLDER", help="where wheels are left")
    options = parser.parse_args()
    found = {f"{a}.{b}": p for (a, b), p in pythons(lowest_python(project())).items()}
    unknown = set(options.only) - set(found)
    if unknown:
        parser.error(f"not on this machine: {', '.join(sorted(unknown))}; there are {', '.join(found)}")
    chosen = {name: p for name, p in found.items() if not options.only or name in options.only}
    first, python = next(iter(chosen.items()))
    told, green = {}, True
    try:
        sdist = built(builder(python, first), ROOT, options.dist, "sdist")
        check_sdist(sdist)
        for name, one in chosen.items():
            told[name] = tried(name, one, sdist, options.dist)
    except (Failure, subprocess.CalledProcessError) as error:
        print(f"RED: {error}", flush=True)
        green = False
    print(*(f"{name}: {line}" for name, line in told.items()), sep="\n")
    return 0 if green else 1


def project() -> dict:
    """The file pyproject.toml."""
    return tomllib.loads((ROOT / "pyproject.toml").read_text(encoding="utf-8"))


if __name__ == "__main__":
    sys.exit(main())
