"""Reports of `measure` and `moved` in German: nothing of what they add to an adjustment stays English."""

import numpy as np
import pytest
from tests.fields import SMALL
from tests.report.test_languages import english_atoms

import raybundle as rb
from raybundle.planning.simulate import Survey, simulate
from raybundle.planning.synthetic_networks import field_scene
from raybundle.report.languages.language import language_of


@pytest.fixture(scope="module")
def field(tmp_path_factory):
    """A block without a scale, and true coordinates."""
    folder = tmp_path_factory.mktemp("field")
    done = simulate(field_scene(SMALL), Survey(seed=5, image_sigma_px=0.1))
    rb.write_block(done.observed, folder / "free")
    truth = dict(zip(done.truth.points.ids, done.truth.points.xyz, strict=True))
    off = {"9": np.array([0.004, 0, 0])}
    lines = [f"{name},{','.join(repr(float(v)) for v in xyz + off.get(name, 0))},0.002" for name, xyz in truth.items()]
    (folder / "nominal.csv").write_text("\n".join(["point,X,Y,Z,tolerance", *lines, "nowhere,0,0,0,"]) + "\n")
    return folder, truth


def length(truth, a, b, off=0.0, *sigma):
    return a, b, float(np.linalg.norm(truth[a] - truth[b])) + off, *sigma


SETS = {
    "one bar and lengths that agree": ([("1", "20", 0)], [("2", "7", 0), ("7", "19", 0), ("11", "25", 0)], None),
    "lengths that are allowed": ([("1", "20", 0), ("3", "15", 0)], [("2", "7", 0), ("7", "19", 0)], (1.0, 0.0)),
    "lengths beyond": ([("1", "20", 0), ("3", "15", 0)], [("2", "7", 0.002), ("7", "19", 0)], (0.5, 0.0)),
    "two wrong lengths": ([("1", "20", 0)], [("2", "7", 0.002), ("7", "19", 0.003), ("2", "19", -0.004)], None),
    "two bars": ([("1", "20", 0.004), ("3", "15", 0)], [("20", "1", 0)], None),
    "three bars": ([("1", "20", 0.004), ("3", "15", 0), ("2", "18", 0)], [("2", "7", 0)], None),
}


@pytest.mark.parametrize("name", SETS)
def test_nothing_of_a_measurement_stays_english(field, tmp_path, name):
    folder, truth = field
    bars, lengths, allowed = SETS[name]
    left = english_atoms(
        language_of("de"),
        lambda: rb.measure(
            folder / "free", tmp_path / "m", scale_bar=[length(truth, *b, 1e-5) for b in bars],
            check_length=[length(truth, *k) for k in lengths], allowed=allowed, nominal=folder / "nominal.csv",
            language="de",
        ),
    )  # fmt: skip
    assert not left, "\n".join(left)


def test_nothing_of_a_test_of_motions_stays_english(field, tmp_path):
    folder, truth = field
    for name, off in (("first", 0.0), ("second", 0.004)):
        bars = [length(truth, "1", "20", off, 1e-5), length(truth, "3", "15", 0.0, 1e-5)]
        rb.measure(folder / "free", tmp_path / name, scale_bar=bars, report=False)
    left = english_atoms(
        language_of("de"),
        lambda: rb.moved_points(
            [tmp_path / "first", tmp_path / "second"], tmp_path / "m", axes=folder / "nominal.csv", language="de",
            client="Werk", operator="R. B.",
        ),
    )  # fmt: skip
    assert not left, "\n".join(left)
