"""A program that uses the package is understood by type checkers at their strictest, without a type that is lost."""

import json
import os
import subprocess
import sys
from pathlib import Path

import pytest

import raybundle

pytestmark = pytest.mark.long
STRANGER = Path(__file__).with_name("stranger.py")
WRONG = {
    "adjst": "import raybundle as rb\n\nrb.adjst\n",
    "inner": 'import raybundle as rb\n\nrb.AdjustmentOptions(datum="iner")\n',
    "colour": (
        "import raybundle as rb\n\n\ndef f(result: rb.Adjustment) -> None:\n    rb.plot_network(result, colour=1)\n"
    ),
}
"""What a checker has to find"""


@pytest.fixture(scope="module")
def installed(tmp_path_factory):
    """The Python of an environment that has the package and what it needs as if installed, and no source of it."""
    place = tmp_path_factory.mktemp("installed")
    subprocess.run([sys.executable, "-m", "venv", "--without-pip", str(place / "venv")], check=True)
    site = next((place / "venv").rglob("site-packages"))
    for folder in dict.fromkeys([Path(raybundle.__file__).parents[1], *map(Path, _site_packages())]):
        for entry in folder.iterdir():
            link = site / entry.name
            if not link.exists() and entry.suffix not in {".pth", ".py"} and entry.name != "__pycache__":
                link.symlink_to(entry, target_is_directory=entry.is_dir())
            elif entry.suffix == ".py" and not entry.name.startswith("_") and not link.exists():
                link.symlink_to(entry)
    assert (site / "raybundle/py.typed").is_file()
    return next(p for p in (place / "venv").glob("*/python*") if p.is_file())


def _site_packages():
    return [p for p in sys.path if p.endswith("site-packages")]


def pyright(python, file):
    """Messages of basedpyright, strict as pyright has it."""
    file.with_name("pyrightconfig.json").write_text(
        json.dumps({
            "typeCheckingMode": "strict", "pythonVersion": "3.11", "include": [file.name],
            "reportMissingTypeStubs": False,  # of SciPy, which has none
        })
    )  # fmt: skip
    done = subprocess.run(
        [sys.executable, "-m", "basedpyright", "--pythonpath", str(python), "--outputjson", "-p", str(file.parent)],
        capture_output=True, text=True, check=False, cwd=file.parent,
    )  # fmt: skip
    found = json.loads(done.stdout)
    assert found["summary"]["filesAnalyzed"] >= 1, done.stdout
    return [f"{m['range']['start']['line'] + 1}: {m['message']}" for m in found["generalDiagnostics"]]


def mypy(python, file):
    """Messages of mypy --strict."""
    done = subprocess.run(
        [sys.executable, "-m", "mypy", "--strict", "--python-executable", str(python), "--cache-dir", os.devnull,
         "--no-error-summary", "--hide-error-context", "--python-version", "3.11", str(file)],
        capture_output=True, text=True, check=False, cwd=file.parent,
    )  # fmt: skip
    assert done.returncode in (0, 1), done.stdout + done.stderr
    return done.stdout.splitlines()


@pytest.mark.parametrize("checker", [pyright, mypy], ids=["basedpyright", "mypy"])
def test_a_stranger_is_understood(checker, installed, tmp_path):
    pytest.importorskip("matplotlib")
    pytest.importorskip("basedpyright")
    pytest.importorskip("mypy")
    file = tmp_path / "stranger.py"
    file.write_text(STRANGER.read_text(encoding="utf-8"), encoding="utf-8")
    found = checker(installed, file)
    assert not found, "\n".join(found)


@pytest.mark.parametrize("checker", [pyright, mypy], ids=["basedpyright", "mypy"])
@pytest.mark.parametrize("wrong", WRONG)
def test_mistakes_of_a_stranger_are_found(checker, wrong, installed, tmp_path):
    pytest.importorskip("basedpyright")
    pytest.importorskip("mypy")
    file = tmp_path / "wrong.py"
    file.write_text(WRONG[wrong], encoding="utf-8")
    assert any(wrong.replace("inner", "iner") in m for m in checker(installed, file))
