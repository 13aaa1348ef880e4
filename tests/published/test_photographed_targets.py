"""Photographs of targets whose calibration others have published: from the pictures to the camera."""

import json

import numpy as np
import pytest

from raybundle.workflows.calibrate import CalibrateOptions, calibrate
from tests.conftest import DATA

SHEET = DATA / "calibration/camcal-photos/images"
PUBLISHED = DATA / "blocks/camcal21/expected.json"
PIXEL_MM = 5.43764 / 1704
"""Of the published values, whose pixels are square but for their affinity."""
PANEL = DATA / "photos/cern-targets/images"


@pytest.mark.data
@pytest.mark.long
@pytest.mark.skipif(not SHEET.is_dir(), reason=f"{SHEET} is absent")
def test_all_photographs_of_a_printed_sheet():
    """The camera of DBAT's 21 photographs, which it calibrates from points measured by PhotoModeler."""
    done = calibrate([SHEET], CalibrateOptions(targets=("photomodeler-sheet",)))
    assert done.used == 21
    seen = {n for sets in done.marks for m in sets for n in m.name if n}
    assert len(seen) >= 95
    (camera,) = done.adjustment.adjusted.cameras
    published = json.loads(PUBLISHED.read_text())["cameras"]["1"]
    (interior,) = done.adjustment.interior
    for symbol in ("c", "x0", "y0"):
        own = interior.parameters[symbol]
        value, std = own.value / camera.pixel_mm[0], own.std / camera.pixel_mm[0]
        other, other_std = published[symbol]["value"] / PIXEL_MM, published[symbol]["std"] / PIXEL_MM
        assert abs(value - other) < 3 * np.hypot(std, other_std), (symbol, value, other, std, other_std)


@pytest.mark.data
@pytest.mark.long
@pytest.mark.skipif(not PANEL.is_dir(), reason=f"{PANEL} is absent")
def test_all_photographs_of_a_panel():
    """MicMac reads 2033 targets, and its bundle with equal weights leaves 0.0144 px."""
    done = calibrate([PANEL], CalibrateOptions(targets=("aicon14",)))
    assert done.used == 39
    assert sum(int(m.named.sum()) for sets in done.marks for m in sets) >= 2047
    a = done.adjustment
    used = a.image_observations.used
    assert {c.model for c in a.adjusted.cameras} == {"brown_harmonic"}
    square = float((a.image_observations.residuals_px[used] ** 2).sum())
    assert np.sqrt(square / a.redundancy) <= 0.0125
