"""What the terminal says of a result in single lines."""

import re
from types import SimpleNamespace

import pytest

from raybundle import adjust
from raybundle.adjustment.result import WHITE, Noise
from raybundle.cli.calibrate import lines
from raybundle.planning.scenes import TargetField, field_scene
from raybundle.planning.simulate import Survey, simulate
from raybundle.report.text.summary import noise_lines


@pytest.mark.parametrize(
    ("tau", "focus", "told"),
    [
        (0.09, 0.0, "contain smooth errors of 0.09 px that differ from image to image, errors that"),
        (0.0, 0.42, "contain a focus that wanders by 0.42 px, errors that"),
        (0.0, 0.0, "contain errors that neighbouring points share (variance times 2.4); times those of white noise"),
    ],
)
def test_the_noise_is_told_by_what_standard_deviations_contain(tau, focus, told):
    noise = Noise(
        kind="fields", phi=2.4, tau_px=tau, focus_px=focus, share=0.5, images=12, directions=3, reason="",
        ratio_interior=1.6, ratio_images=float("nan"), ratio_points=1.0,
    )  # fmt: skip
    (line,) = noise_lines(noise)
    assert told in line
    assert line.endswith("(medians): 1.6 for the interior orientation, 1 for object points")
    assert noise_lines(WHITE) == []


def test_what_calibrate_prints_of_a_model_has_units():
    survey = Survey(points="exact", orientation="exact", interior="exact")
    result = adjust(simulate(field_scene(TargetField()), survey).observed)
    quality = SimpleNamespace(camera="1", headline="", reasons=(), advice=(), grade="good")
    done = SimpleNamespace(
        marks=(), completed=0, dots=0, targets=(), adjustment=result, photos=(), refused=(), not_used=(), used=0,
        quality=(quality,),
    )  # fmt: skip
    (model,) = [line for line in lines(done) if line.startswith("  model brown")]
    assert re.search(r": c 20\.\d+ ± \S+ mm, ", model)
    assert re.search(r"K1 \S+ ± \S+ mm\^-2", model)
