"""A network that is degenerate by construction gets one verdict, however the last bits fall; the whole matrix is in
benchmarks/verdicts.py."""

import json
import os
import subprocess
import sys
from pathlib import Path

import pytest

from raybundle.numerics import native
from tests.verdicts.cases import CASES, Verdict, verdict

ROOT = Path(__file__).resolve().parents[2]
EXPECTED = {
    "square views of a plane": (0, {"c", "x0", "y0"}),
    "square views, three distances": (0, {"c", "x0", "y0"}),
    "square views, automatic": (0, {"A", "S", "c", "x0", "y0"}),
    "square views of a plane, from nothing": (0, {"c", "x0", "y0"}),
    "no rolls": (0, {"c", "y0"}),
    "no rolls, automatic": (0, {"A", "y0"}),
    "windows of one picture": (0, {"A", "S", "c", "x0", "y0"}),
    "windows of one picture, from nothing": (0, {"A", "S", "c", "x0", "y0"}),
    "level flight": (0, {"c", "x0", "y0"}),
    "one panorama": (3, {"RankDefect"}),
    "one panorama, little control": (3, {"TooFewObservations"}),
    "two images": (0, set()),
    "two images, automatic": (0, set()),
    "collinear points": (3, {"DatumDefect"}),
    "control on a line": (0, set()),
    "control on a line, from nothing": (0, set()),
    "one place": (3, {"RankDefect"}),
    "scattered image points": (3, {"NoConvergence"}),
    "an image with two points": (2, {"InputError"}),
}
QUICK = ("square views, three distances", "no rolls", "one panorama, little control", "one place", "collinear points")
"""Cases that the NumPy twins, too, adjust within seconds."""


def processor_flags():
    """Instruction sets as Linux names them; elsewhere nothing is known, and nothing is left out."""
    file = Path("/proc/cpuinfo")
    return file.read_text(encoding="utf-8") if file.is_file() else "avx512f"


COMBINATIONS = [("avx2", "Haswell", ()), ("baseline", "Prescott", ()), ("0", "SkylakeX", QUICK)]


@pytest.mark.long
@pytest.mark.parametrize("name", CASES)
def test_the_verdict_is_that_of_the_construction_whatever_the_order(name):
    found = {verdict(name, seed) for seed in range(3)}
    assert len(found) == 1, found
    (told,) = found
    status, lost = EXPECTED[name]
    assert (told.status, {n.split(" ")[0] for n in told.lost}) == (status, lost)


@pytest.mark.long
@pytest.mark.parametrize(("instructions", "blas", "cases"), COMBINATIONS)
def test_another_processor_says_the_same(instructions, blas, cases):
    if native.module() is None and instructions != "0":
        pytest.skip("no compiled kernels here")
    if blas == "SkylakeX" and "avx512f" not in processor_flags():
        pytest.skip("this processor has no AVX-512: BLAS kernels of SkylakeX end by an illegal instruction")
    environment = {
        **os.environ, "RAYBUNDLE_NATIVE": instructions, "OPENBLAS_CORETYPE": blas, "OPENBLAS_NUM_THREADS": "1"
    }  # fmt: skip
    done = subprocess.run(
        [sys.executable, "-m", "tests.verdicts.cases", "1", *cases],
        env=environment, cwd=ROOT, capture_output=True, text=True, check=True,
    )  # fmt: skip
    for line in done.stdout.splitlines():
        found = json.loads(line)
        ((status, lost, sentence),) = found["verdicts"]
        assert Verdict(status, tuple(lost), sentence) == verdict(found["case"]), found["case"]
