"""Interior orientation of single images as observed deviations: between a shared camera and one for each image."""

from dataclasses import replace

import numpy as np
import pytest
from scipy.stats import chi2

from raybundle import adjust
from raybundle.adjustment.records.options import AdjustmentOptions
from raybundle.errors import InputError
from raybundle.io.block.folder import read_block, write_block
from raybundle.observations.deviation import Deviation, Deviations
from raybundle.planning.simulate import Survey, simulate
from raybundle.planning.synthetic_networks import TargetField, field_scene
from raybundle.report.write import write_result
from raybundle.results.folder import read_result

SCENE = field_scene(TargetField(rows=5, columns=6, depth=0.5, size=(0.8, 0.6), stations=8, frontal=2))
FREE = ("c", "x0", "y0", "K1")
SHARE = 1e-3
"""Standard deviation of an image's camera constant, of it"""
ONE = AdjustmentOptions(jobs=1)


def wandering(seed, share=SHARE):
    """Truth, images whose camera constants differ, and the camera constants."""
    rng = np.random.default_rng(seed)
    survey = Survey(image_sigma_px=0.3, interior="exact", seed=seed, scale_bars=4)
    made = simulate(SCENE, survey)
    truth, block = made.truth, made.observed
    camera = truth.cameras[0]
    own = camera.values["c"] * (1 + share * rng.standard_normal(len(truth.images)))
    # the image points of a camera with another constant: exact ones moved by the change of projection
    o = block.observations
    exact, moved = (_projected(truth, c) for c in (np.full(len(own), camera.values["c"]), own))
    o = replace(o, xy_px=o.xy_px + moved - exact)
    free = replace(block.cameras[0], estimate=FREE, per_image=("c",), sigma={})
    return truth, replace(block, cameras=(free,), observations=o), own


def _projected(block, c):
    """(m, 2) image points with a camera constant for each image; the lens of these scenes is free of distortion."""
    o, camera = block.observations, block.cameras[0]
    assert all(v == 0 for s, v in camera.values.items() if s not in {"c", "x0", "y0"})
    X = np.einsum(
        "nij,nj->ni", block.images.rotation[o.image], block.points.xyz[o.point] - block.images.centre[o.image]
    )
    xy = -c[o.image, None] * X[:, :2] / X[:, 2:] + [camera.values["x0"], camera.values["y0"]]
    return camera.pixel_from_image(xy)


def told(block, sigma):
    images = np.arange(len(block.images), dtype=np.int32)
    return block.having(Deviations(image=images, parameter=("c",) * len(images), sigma=np.full(len(images), sigma)))


@pytest.fixture(scope="module")
def plain():
    """A camera without distortion, so that a test can project by itself."""
    global SCENE  # noqa: PLW0603
    camera = SCENE.camera
    SCENE = replace(SCENE, camera=replace(camera, values={s: v if s in {"c", "x0", "y0"} else 0.0
                                                          for s, v in camera.values.items()}))  # fmt: skip


@pytest.mark.long
def test_standard_deviations_hold(plain):
    """Camera constants of single images about the truth, over what is stated; and the group's variance component."""
    squares, ratio, sigma0, shared = [], [], [], []
    for seed in range(100, 130):
        _truth, block, own = wandering(seed)
        c = block.cameras[0].values["c"]
        result = adjust(told(block, SHARE * c), ONE)
        (g,) = [g for g in result.groups if g.kind == "deviation"]
        total = np.nansum(result.image_observations.redundancy) + sum(g.redundancy.sum() for g in result.groups)
        assert total == pytest.approx(result.redundancy, abs=1e-5)
        ratio.append((float(g.square.sum()), float(g.redundancy.sum())))
        sigma0.append(result.sigma0**2)
        for i in result.interior:
            if i.image is not None:
                p = i.parameters["c"]
                squares.append(((p.value - own[block.images.ids.index(i.image)]) / p.std) ** 2)
        if seed < 105:
            shared.append(adjust(replace(block, cameras=(replace(block.cameras[0], per_image=()),)), ONE).sigma0)
    assert 0.8 < np.mean(squares) < 1.25  # 300 squares
    square, r = np.sum(ratio, axis=0)
    low, high = chi2.ppf([0.0005, 0.9995], r)
    assert low < square < high
    assert 0.95 < np.mean(sigma0) < 1.05
    assert (np.array(shared) ** 2 > np.array(sigma0[:5]) + 0.01).all()  # one camera for all: what it leaves shows


def test_it_lies_between_one_camera_and_one_for_each_image(plain):
    _, block, _ = wandering(3)
    c = block.cameras[0].values["c"]
    tight, loose = adjust(told(block, 1e-7 * c), ONE), adjust(told(block, 1e3 * c), ONE)
    one = adjust(replace(block, cameras=(replace(block.cameras[0], per_image=()),)), ONE)
    each = adjust(block, ONE)
    np.testing.assert_allclose(tight.adjusted.points.xyz, one.adjusted.points.xyz, rtol=0, atol=1e-6)
    np.testing.assert_allclose(loose.adjusted.points.xyz, each.adjusted.points.xyz, rtol=0, atol=1e-6)


def test_a_scatter_beyond_the_stated_is_told(plain):
    _, block, _ = wandering(5, share=5 * SHARE)
    result = adjust(told(block, SHARE * block.cameras[0].values["c"]), ONE)
    component = next(v for v in result.variance_components if v.kind == "deviations of single images")
    assert component.significant
    assert 3 < component.ratio < 8


def test_it_stands_in_folders(plain, tmp_path):
    _, block, _ = wandering(7)
    block = told(block, SHARE * block.cameras[0].values["c"])
    write_block(block, tmp_path / "block")
    result = adjust(read_block(tmp_path / "block"), ONE)
    write_result(result, tmp_path / "out")
    table = read_result(tmp_path / "out").others["deviations"]
    (g,) = [g for g in result.groups if g.kind == "deviation"]
    assert table.text["image"] == block.images.ids
    assert (abs(table.number["v"] - g.residual) <= 1.001e-3 * abs(g.residual / g.w)).all()
    assert Deviation.title in (tmp_path / "out/report.html").read_text()


def test_a_parameter_that_images_share_is_refused(plain):
    _, block, _ = wandering(9)
    block = told(block, 0.01)
    with pytest.raises(InputError, match=r"deviation\.parameter_not_free"):
        adjust(replace(block, cameras=(replace(block.cameras[0], per_image=()),)), ONE)
    twice = block.tables["deviations"].append(block.tables["deviations"])
    assert twice.wrong()[0].rows.any()
