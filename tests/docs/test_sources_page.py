"""The page of sources of images: every name of the field stands there, rows name formats, models and tests."""

import re
import tomllib
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parents[2]
NAMES = """GeoEye WorldView IKONOS QuickBird SPOT OrbView IRS ASTER Landsat ADS40 DMC UltraCam DAS DIMAC DSS ICI AirSAR
ERS RADARSAT Sentinel UAV Kites balloons Panoramic Amateur still-video Photogrammetric Camcorders phones GNSS INS"""


@pytest.fixture(scope="module")
def groups():
    return tomllib.loads((ROOT / "docs/reference/sources.toml").read_text(encoding="utf-8"))["group"]


@pytest.mark.parametrize("name", NAMES.split())
def test_a_source_has_a_row(groups, name):
    rows = [row for group in groups for row in group["rows"] if name in row["name"]]
    assert rows
    page = (ROOT / "docs/reference/sources.md").read_text(encoding="utf-8")
    assert all(f"| {row['name']} |" in page for row in rows)


def test_tests_of_rows_stand_there(groups):
    for row in (row for group in groups for row in group["rows"]):
        assert row["tests"] or row["missing"], row["name"]
        for test in row["tests"]:
            file, _, name = test.partition("::")
            assert re.search(rf"^def {name}\(", (ROOT / file).read_text(encoding="utf-8"), re.MULTILINE), test
