"""What the terminal says of a result in single lines."""

import re
from dataclasses import replace
from types import SimpleNamespace

import numpy as np
import pytest

from raybundle import adjust
from raybundle.adjustment.result import WHITE, Noise
from raybundle.cli.calibrate import camera_lines
from raybundle.io.photos.start import NOMINAL_PIXEL_MM
from raybundle.planning.simulate import Survey, simulate
from raybundle.planning.synthetic_networks import TargetField, field_scene
from raybundle.report.chapters import Occasion
from raybundle.report.delivery import delivery_of
from raybundle.report.sections.front import glance_parts
from raybundle.report.text.numbers import significant
from raybundle.report.text.summary import a_priori, noise_messages
from raybundle.report.text.words import verdict
from raybundle.report.view import view_of
from tests.report.conftest import made


@pytest.mark.parametrize(
    ("tau", "focus", "found"), [(0.09, 0.0, {"smooth": 0.09}), (0.0, 0.42, {"focus": 0.42}), (0.0, 0.0, {})]
)
def test_the_noise_is_stated_by_what_standard_deviations_contain(tau, focus, found):
    noise = Noise(
        kind="fields", phi=2.4, tau_px=tau, focus_px=focus, share=0.5, images=12, directions=3, reason="",
        ratio_interior=1.6, ratio_images=float("nan"), ratio_points=1.0,
    )  # fmt: skip
    messages = noise_messages(noise)
    sizes = {m.code.removeprefix("summary.noise_"): m.values["sigma_px"] for m in messages if "sigma_px" in m.values}
    assert sizes == found
    factors = {m.values.get("kind"): m.values["factor"] for m in messages if "factor" in m.values}
    assert factors == {None: 2.4, "interior": 1.6, "points": 1.0}
    assert noise_messages(WHITE) == []


@pytest.mark.parametrize(("pixel_mm", "size_um"), [(0.005, 1.5), (NOMINAL_PIXEL_MM, None)])
def test_micrometres_are_stated_where_pixels_have_a_size(pixel_mm, size_um):
    """Photographs that do not tell theirs are given pixels of a micrometre: 0.3 um is nothing that is known of them."""
    block = simulate(field_scene(TargetField()), Survey(image_sigma_px=0.3)).observed
    cameras = tuple(replace(c, pixel_mm=(pixel_mm, pixel_mm)) for c in block.cameras)
    px, um, one = a_priori(replace(block, cameras=cameras))
    assert px == pytest.approx(0.3)
    assert um == (size_um and pytest.approx(size_um))
    assert one


def test_the_headline_and_the_key_figure_of_points_are_one_number():
    """Where a few points hold most of the variance both are the median, over the points, of the rms of a point."""
    result = made("rich")
    cofactors = np.array(result.precision.object_points)
    cofactors[np.flatnonzero(np.isfinite(cofactors[:, 0, 0]) & (cofactors[:, 0, 0] > 0))[0]] *= 1e4
    spread = np.array([0.2, 1.0, 3.0])  # axes that differ: the median of all coordinates is another number
    cofactors *= spread[:, None] * spread
    of_points = replace(result.precision, object_points=cofactors)
    view = view_of(replace(result, precision=of_points))
    headline = {m.code: m.values for m in verdict(view).headline.messages}
    number = headline["verdict.points_median"]["sigma"]
    facts = glance_parts(Occasion(view=view, reported=verdict(view)), delivery_of(view.adjustment))[0].facts
    (fact,) = [f for f in facts if f.label.messages[0].code == "label.standard_deviation"]
    assert fact.remark.messages[0].values == {"median": True}
    assert fact.value == f"{significant(number, 2)} mm"


def test_what_calibrate_prints_of_a_model_has_units():
    survey = Survey(points="exact", orientation="exact", interior="exact")
    result = adjust(simulate(field_scene(TargetField()), survey).observed)
    quality = SimpleNamespace(camera="1", headline="", reasons=(), advice=(), grade="good")
    done = SimpleNamespace(adjustment=result)
    (model,) = [line for line in camera_lines(done, quality) if line.startswith("  model brown")]
    assert re.search(r": c 20\.\d+ ± \S+ mm, ", model)
    assert re.search(r"K1 \S+ ± \S+ mm\^-2", model)
