"""Features: spread over the format, in the pixel frame, the same with tiles."""

import cv2
import numpy as np
import pytest

from raybundle.errors import InputError
from raybundle.matching.features import spread
from raybundle.matching.methods import feature_method


def texture(h, w, seed=1):
    rng = np.random.default_rng(seed)
    image = sum(cv2.GaussianBlur(rng.random((h, w)).astype(np.float32), (0, 0), s) * s for s in (1.5, 3.0, 6.0))
    return cv2.normalize(image, None, 0, 255, cv2.NORM_MINMAX).astype(np.uint8)


def test_features_follow_a_shift_without_bias():
    image = texture(500, 640)
    method = feature_method("rootsift")
    a, b = method.detect(image, 800), method.detect(np.roll(image, (12, 34), axis=(0, 1)), 800)
    near = np.linalg.norm((a.xy_px + np.array([34, 12]))[:, None] - b.xy_px[None], axis=2)
    close = near.min(axis=1) < 0.5
    assert close.mean() > 0.5
    shift = (b.xy_px[near.argmin(axis=1)] - a.xy_px)[close].mean(axis=0)
    assert np.abs(shift - [34, 12]).max() < 0.02


def test_a_mirrored_image_mirrors_its_features():
    """An offset of half a pixel in the pixel frame would show twice."""
    image = texture(400, 400, 3)
    method = feature_method("rootsift")
    a, b = method.detect(image, 500), method.detect(np.ascontiguousarray(image[:, ::-1]), 500)
    mirrored = a.xy_px * [-1, 1] + [400, 0]
    near = np.linalg.norm(mirrored[:, None] - b.xy_px[None], axis=2)
    close = near.min(axis=1) < 0.6
    assert close.sum() > 100
    assert np.abs((b.xy_px[near.argmin(axis=1)] - mirrored)[close].mean(axis=0)).max() < 0.05


def test_weak_parts_keep_features():
    rng = np.random.default_rng(2)
    xy = np.vstack([rng.uniform(0, 100, (5000, 2)), rng.uniform(0, 1000, (500, 2))])
    strength = np.concatenate([np.full(5000, 10.0), np.ones(500)])
    chosen = spread(xy, strength, 1000, 1000, 1000)
    assert len(chosen) == 1000
    assert (chosen >= 5000).sum() > 400


def test_an_unknown_method_is_named():
    with pytest.raises(InputError, match="rootsift"):
        feature_method("nothing")


def test_a_blank_image_has_no_features():
    assert len(feature_method("rootsift").detect(np.full((300, 300), 128, np.uint8), 100)) == 0


@pytest.mark.parametrize("share", [0.5, 0.3, 0.15, 0.08])
def test_dark_and_hazy_photographs_have_their_features(share):
    """Eight bits of a photograph that is dark, or hazy at the same contrast; matched with the photograph itself."""
    method = feature_method("rootsift")
    rng = np.random.default_rng(5)
    bright = np.clip(texture(480, 640, 4) + rng.normal(0, 0.5, (480, 640)), 0, 255)
    reference = method.detect(bright.astype(np.uint8), 1500)
    for offset in (0.0, 150.0):
        dark = method.detect(np.round(bright * share + offset).clip(0, 255).astype(np.uint8), 1500)
        near = np.linalg.norm(reference.xy_px[:, None] - dark.xy_px[None], axis=2).min(axis=1)
        assert len(dark) > 0.6 * len(reference)
        assert (near < 1.0).mean() > 0.6


def test_noise_gives_few_features():
    rng = np.random.default_rng(2)
    for sigma in (0.0, 1.0, 4.0):
        flat = np.round(60 + rng.normal(0, sigma, (600, 800))).clip(0, 255).astype(np.uint8)
        assert len(feature_method("rootsift").detect(flat, 4000)) < 400
