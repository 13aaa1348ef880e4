"""What an installation must do wherever it stands: tools/wheel.py and cibuildwheel run this against a wheel.

The installation that is tried is that of RAYBUNDLE_TRIED, a Python; without it, the one that runs the tests.  All
goes through its programs, so that pytest and what belongs to it need not be in its environment.
"""

import json
import os
import re
import subprocess
import sys
import threading
import urllib.request
from pathlib import Path

import pytest

TRIED = os.environ.get("RAYBUNDLE_TRIED", "")
PYTHON = TRIED or sys.executable
STARTS_IN_S = 300
"""The first start of an installation compiles every module; two processors that others use take a while."""


def python(text, folder):
    done = subprocess.run([PYTHON, "-c", text], cwd=folder, capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stdout[-1000:] + done.stderr[-3000:]
    return done.stdout


def raybundle(folder, *words, exits=0):
    """What the program of the installation prints; not `python -m`, so that the entry point is tried, too."""
    program = Path(PYTHON).with_name("raybundle.exe" if os.name == "nt" else "raybundle")
    # what is printed there holds Greek letters, and a console of Windows has a code page of its own
    apart = {**os.environ, "PYTHONUTF8": "1"}
    done = subprocess.run(
        [program, *map(str, words)], cwd=folder, capture_output=True, encoding="utf-8", check=False, env=apart
    )
    assert done.returncode == exits, (words, done.stdout[-2000:], done.stderr[-3000:])
    return done.stdout


@pytest.mark.skipif(not TRIED and "CIBUILDWHEEL" not in os.environ, reason="an editable installation is the repository")
def test_what_is_tried_is_the_installation(tmp_path):
    file = Path(python("import raybundle; print(raybundle.__file__)", tmp_path).strip())
    assert "site-packages" in file.parts
    assert (file.parent / "py.typed").is_file()


def test_every_module_is_there(tmp_path):
    """Each can be imported without the extras, or says which of them it needs: the rest needs what is required."""
    text = (
        "import importlib, pkgutil, raybundle\n"
        "names = [m.name for m in pkgutil.walk_packages(raybundle.__path__, 'raybundle.')]\n"
        "for n in names:\n"
        "    if n != 'raybundle.__main__' and n != 'raybundle.studio.child':\n"
        "        try:\n"
        "            importlib.import_module(n)\n"
        "        except Exception as error:\n"
        "            assert 'raybundle[' in str(error), n\n"
        "print(len(names))"
    )
    assert int(python(text, tmp_path)) > 400


def test_doctor_finds_what_is_required_and_the_compiled_kernels(tmp_path):
    found = json.loads(raybundle(tmp_path, "doctor", "--json"))
    assert all(found["required"].values())
    assert found["native"]["available"] or os.environ.get("RAYBUNDLE_NATIVE") == "0"


def test_a_simulated_field_is_adjusted_from_the_command_line(tmp_path):
    done = json.loads(raybundle(tmp_path, "demo", "--out", "demo", "--json"))
    assert "demo.points" in {m["code"] for m in done["summary"]}
    page = (tmp_path / "demo/result/report.html").read_text(encoding="utf-8")
    assert "</html>" in page
    raybundle(tmp_path, "adjust", "demo/block", "--out", "german", "--language", "de")
    assert "Standardabweichung" in (tmp_path / "german/report.html").read_text(encoding="utf-8")


def test_a_report_is_printed_or_the_extra_is_named(tmp_path):
    raybundle(tmp_path, "simulate", "flat", "--out", "flat", "--scale-bars", "1")
    there = python("import importlib.util as u; print(u.find_spec('typst') is not None)", tmp_path).strip() == "True"
    raybundle(tmp_path, "adjust", "flat/block", "--out", "printed", "--pdf", exits=0 if there else 2)
    assert not there or (tmp_path / "printed/report.pdf").read_bytes().startswith(b"%PDF-")


def test_a_simulated_block_is_adjusted_from_python(tmp_path):
    raybundle(tmp_path, "simulate", "flat", "--out", "flat", "--scale-bars", "1")
    text = (
        "import raybundle as rb\n"
        "result = rb.adjust(rb.read_block('flat/block'), rb.AdjustmentOptions(datum='inner'))\n"
        "print(result.sigma0, result.precision.object_point_std.shape[1])"
    )
    sigma0, coordinates = python(text, tmp_path).split()
    assert 0.8 < float(sigma0) < 1.2
    assert coordinates == "3"


@pytest.mark.long
def test_photographs_are_measured(tmp_path):
    """Targets found, centres, orientation, adjustment, and the plate against its drawing."""
    raybundle(tmp_path, "demo", "--set", "part", "--out", "part")
    bars = ["--scale-bar", "101", "102", "0.66", "0.000005", "--scale-bar", "103", "104", "0.84", "0.000005"]
    done = json.loads(raybundle(
        tmp_path, "measure", "part/before", "--target", "aicon14", *bars, "--lengths", "part/lengths.csv",
        "--unit", "0.001", "--out", "before", "--json",
    ))  # fmt: skip
    assert {"points": 34, "images": 12}.items() <= done["summary"][0]["values"].items()


def test_targets_are_printed(tmp_path):
    raybundle(tmp_path, "targets", "sheet", "--target", "aicon14", "--codes", "1-4", "--out", "sheet.pdf")
    assert (tmp_path / "sheet.pdf").read_bytes().startswith(b"%PDF-")


def test_the_studio_starts_shows_its_page_and_ends(tmp_path):
    raybundle(tmp_path, "simulate", "flat", "--out", "flat", "--scale-bars", "1")
    begun = subprocess.Popen(
        [PYTHON, "-u", "-m", "raybundle", "studio", "flat/block", "--no-browser"],
        cwd=tmp_path, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, encoding="utf-8",
        env={**os.environ, "PYTHONUTF8": "1"},
    )  # fmt: skip
    late = threading.Timer(STARTS_IN_S, begun.kill)
    late.start()
    try:
        said = ""
        while not (address := re.search(r"http://\S+", said)):
            line = begun.stdout.readline()
            assert line, said
            said += line
        # the address lets one browser in, which it knows again by its cookie
        opener = urllib.request.build_opener(urllib.request.HTTPCookieProcessor())
        with opener.open(address[0], timeout=300) as answer:
            assert b"studio.js" in answer.read()
    finally:
        late.cancel()
        begun.terminate()
        begun.communicate(timeout=300)
    if os.name != "nt":  # there, to terminate is to kill
        assert begun.returncode in {0, 143}  # 128 + SIGTERM, as shells say it
