"""The lines that a command prints about an adjustment."""

import re
from types import SimpleNamespace

from raybundle import adjust
from raybundle.adjustment.fields import Noise
from raybundle.block.simulate import Survey, TargetField, field_scene, simulate
from raybundle.cli.calibrate import lines
from raybundle.cli.summary import noise_lines


def test_noise_lines_say_what_their_numbers_are():
    noise = Noise(kind="fields", phi=1.7, tau_px=0.21, ratio_interior=3.1, ratio_images=2.2, ratio_points=float("nan"))
    first, second = noise_lines(noise)
    assert "smooth errors of 0.21 px that differ from image to image (fields)" in first
    assert "vary 1.7 times as much as independent errors would (floor)" in first
    assert second.endswith("medians: interior orientation 3.1, projection centres 2.2")
    assert noise_lines(Noise(kind="white")) == []


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
