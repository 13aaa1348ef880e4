"""Photographs that cannot calibrate a camera: what is missing is said, in the words of whoever took them."""

from types import SimpleNamespace

import numpy as np
import pytest

from raybundle.errors import NotSolvable, RankDefect
from raybundle.planning.network.calibration_networks import ROLLS, FlatField, flat_field_scene
from raybundle.planning.simulate import Survey, simulate
from raybundle.planning.synthetic_networks import TargetField, field_scene
from raybundle.workflows.calibrate import CalibrateOptions, calibrate
from raybundle.workflows.calibrating.defects import check_spline, explained, flat_only
from tests.messages import refused, with_details
from tests.workflows.flat_views import patched


@pytest.mark.parametrize(("photographs", "rolls"), [(3, (0.0,)), (6, (0.0, 90.0, 180.0, 270.0))])
def test_square_views_of_a_sheet_say_what_is_missing(monkeypatch, tmp_path, photographs, rolls):
    """Points of 0.3 px: no verdict is reached, the network falls apart at the start."""
    patched(monkeypatch, tmp_path, 0.0, photographs=photographs, sigma_px=0.3, rolls=rolls, seed=photographs)
    with refused("calibration.flat_views", NotSolvable, least_deg=pytest.approx(15)) as stated:
        calibrate([tmp_path], CalibrateOptions(targets=("aicon14",), jobs=1))
    assert not stated.value.message.details


def seen(scene):
    return simulate(scene, Survey(image_sigma_px=0.1, points="exact", orientation="exact", interior="exact")).observed


@pytest.mark.parametrize("tilt", [0.0, 5.0, 25.0])
def test_flat_views_are_told_from_convergent_ones(tilt):
    block = seen(flat_field_scene(FlatField(tilt_deg=tilt, shift=0.1, rolls_deg=ROLLS)))
    assert bool(flat_only(block)) == (tilt < 15)


def test_what_is_not_flat_is_not_called_so():
    assert not flat_only(seen(field_scene(TargetField(depth=0.5, tilt_deg=5.0))))


def test_another_defect_keeps_its_words_and_its_data():
    block = seen(flat_field_scene(FlatField(tilt_deg=30.0)))
    defect = RankDefect("image.too_few_points", n=1, images=["3"])
    error = explained(defect, block)
    assert isinstance(error, RankDefect)
    assert defect.message in with_details(error.message)
    assert error.code == "calibration.not_possible"


def adjusted(c, residual, model="spline"):
    camera = SimpleNamespace(id="1", model=model, parameters=np.array([c]))
    return SimpleNamespace(
        adjusted=SimpleNamespace(cameras=(camera,)), redundancy=100,
        image_observations=SimpleNamespace(residuals_px=np.full((100, 2), residual), used=np.ones(100, bool)),
    )  # fmt: skip


@pytest.mark.parametrize(("c", "residual", "refused"), [(8.0, 0.1, False), (8.0, 97.0, True), (-8.0, 0.1, True)])
def test_a_spline_that_ends_worse_is_refused(c, residual, refused):
    before = adjusted(8.0, 0.12, "brown")
    if refused:
        with pytest.raises(NotSolvable, match=r"calibration\.spline_worse"):
            check_spline(before, adjusted(c, residual))
    else:
        check_spline(before, adjusted(c, residual))
