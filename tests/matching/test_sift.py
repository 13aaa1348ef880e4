"""The features kernel: the same as its twin; turned, smaller and paler pictures; pictures with nothing in them."""

import json
import os
import subprocess
import sys
from concurrent.futures import ThreadPoolExecutor

import cv2
import numpy as np
import pytest

from raybundle.matching.features import Described
from raybundle.matching.methods import feature_method
from raybundle.matching.rootsift import RootSift
from raybundle.numerics import native
from tests.matching import sift_twin
from tests.matching.test_features import texture

pytestmark = pytest.mark.skipif(not native.available(), reason="the kernels are not compiled")
LEAST = 1.275


def blobs(h, w, places, sigma=3.0, depth=90.0):
    """Dark discs with soft rims at places (n, 2) in the pixel frame."""
    y, x = np.mgrid[:h, :w] + 0.5
    grey = np.full((h, w), 200.0)
    for u, v in places:
        grey -= depth * np.exp(-((x - u) ** 2 + (y - v) ** 2) / (2 * sigma**2))
    return np.round(grey).clip(0, 255).astype(np.uint8)


def found(grey, *, doubled=False, least=LEAST):
    return native.required().search_features(grey, least, doubled)


def compared(grey, *, doubled):
    """The table of the kernel, and how many of the twin's rows it has, to 0.01 px."""
    space = found(grey, doubled=doubled)
    table, (twin, where) = space.table(), sift_twin.search(grey, LEAST, doubled=doubled)
    apart = np.abs(table[:, None] - twin[None]).max(axis=2)
    nearest = apart.argmin(axis=1)
    return space, table, twin, where, apart, nearest


@pytest.mark.parametrize("doubled", [False, True])
@pytest.mark.parametrize(("h", "w"), [(97, 131), (64, 200), (150, 43)])
def test_the_kernel_is_its_twin(h, w, doubled):
    space, table, twin, where, apart, nearest = compared(texture(h, w, 7), doubled=doubled)
    assert len(table) > 20
    assert len(table) == pytest.approx(len(twin), abs=1)
    same = np.flatnonzero(apart.min(axis=1) < 0.01)
    assert len(same) >= len(table) - 1
    owner, angle = space.orient(np.arange(len(table)))
    assert (owner[: len(table)] == np.arange(len(table))).all()
    expected = np.array([sift_twin.direction(where[nearest[k]]) for k in same])
    turned = np.abs((angle[same] - expected + np.pi) % (2 * np.pi) - np.pi)
    assert np.mean(turned < 0.02) > 0.95  # two maxima may be nearly the same
    bytes_ = space.describe(same, angle[same])
    twins = np.array([sift_twin.descriptor(where[nearest[k]], angle[k]) for k in same])
    off = np.abs(bytes_ - twins)
    assert np.mean(off <= 2) > 0.98
    assert np.percentile(off.max(axis=1), 90) <= 6


def test_strips_leave_no_trace():
    """An image wider than a strip of the kernel: as its halves, which overlap by more than the filters reach."""
    grey = texture(120, 2400, 9)
    whole, left, right = (found(np.ascontiguousarray(g)).table() for g in (grey, grey[:, :1600], grey[:, 800:]))
    for part, begin, low, high in ((left, 0, 950, 1100), (right, 800, 1000, 1300)):
        mine = part + np.array([begin, 0, 0, 0])
        fine = mine[(mine[:, 2] < 5) & (mine[:, 0] > low) & (mine[:, 0] < high)]
        assert len(fine) > 20
        assert np.abs(fine[:, None] - whole[None]).max(axis=2).min(axis=1).max() < 1e-3


def test_a_blob_lies_where_it_is():
    """In the pixel frame: the corner of the first pixel is the origin."""
    rng = np.random.default_rng(3)
    places = np.array([[40.0 * i, 40.0 * j] for j in range(1, 6) for i in range(1, 8)]) + rng.uniform(-1, 1, (35, 2))
    for sigma in (1.5, 3.0, 6.0):
        f = feature_method("rootsift").detect(blobs(240, 320, places, sigma), 1000)
        off = np.linalg.norm(f.xy_px[None] - places[:, None], axis=2)
        assert off.min(axis=1).max() < 0.02
        scale = f.scale_px[off.argmin(axis=1)]
        assert np.ptp(scale) < 0.1 * scale.mean()


@pytest.mark.parametrize("contrast", [1.0, 0.4])
@pytest.mark.parametrize("scale", [1.0, 0.75])
@pytest.mark.parametrize("degrees", [0, 30, 137])
def test_a_turned_smaller_paler_picture_has_the_same_features(degrees, scale, contrast):
    grey = texture(400, 400, 11)
    M = cv2.getRotationMatrix2D((199.5, 199.5), degrees, scale)
    other = cv2.warpAffine(grey, M, (400, 400), flags=cv2.INTER_AREA, borderMode=cv2.BORDER_REFLECT)
    other = np.round(contrast * other.astype(float) + 20).clip(0, 255).astype(np.uint8)
    method = feature_method("rootsift")
    a, b = method.detect(grey, 600), method.detect(other, 900)
    first, second = (Described(xy_px=f.xy_px, descriptors=f.descriptors, size_px=(400, 400)) for f in (a, b))
    pair = method.match(first, second)
    there = (a.xy_px[pair[:, 0]] - 0.5) @ M[:, :2].T + M[:, 2] + 0.5
    right = np.linalg.norm(there - b.xy_px[pair[:, 1]], axis=1) < 2
    assert right.sum() > 80
    assert right.mean() > 0.9
    i, j = pair[right].T
    assert np.median(b.scale_px[j] / a.scale_px[i]) == pytest.approx(scale, rel=0.04)
    turned = (b.angle[j] - a.angle[i] + np.radians(degrees) + np.pi) % (2 * np.pi) - np.pi
    assert np.median(np.abs(turned)) < np.radians(3)


@pytest.mark.parametrize("count", [2500, 5000])
def test_a_first_look_stops_what_has_nothing_in_common_and_changes_nothing_else(count):
    """Descriptors without images: of some of both the same, of the rest none."""
    rng = np.random.default_rng(count)

    def described(common, place):
        own = rng.gamma(0.6, 30.0, (count - len(common), 128))
        rows = np.vstack([own[:place], common + rng.normal(0, 2.0, common.shape), own[place:]])
        rows *= 400 / np.linalg.norm(rows, axis=1, keepdims=True)
        return Described(
            xy_px=np.zeros((count, 2)), descriptors=np.clip(rows, 0, 255).astype(np.uint8), size_px=(400, 400),
            scale_px=np.linspace(2.0, 9.0, count),
        )  # fmt: skip

    method = feature_method("rootsift")
    both = rng.gamma(0.6, 30.0, (60, 128))
    for place in (0, count - 60):  # the strongest, and the widest
        a, b = described(both, place), described(both, place)
        found = method.match(a, b)
        assert len(found) >= 60
        assert (method.likely_matches(a, b) == found).all()
    assert method.likely_matches(described(both[:0], 0), described(both[:0], 0)).shape == (0, 2)


@pytest.mark.parametrize(
    "shape", [(0, 0), (0, 5), (1, 1), (1, 400), (400, 1), (2, 2), (12, 12), (13, 13), (13, 40), (17, 1100)]
)
@pytest.mark.parametrize("doubled", [False, True])
def test_small_and_empty_pictures(shape, doubled):
    for grey in (np.zeros(shape, np.uint8), np.random.default_rng(1).integers(0, 256, shape, dtype=np.uint8)):
        space = found(grey, doubled=doubled)
        table = space.table()
        assert np.isfinite(table).all()
        assert ((table[:, :2] > 0) & (table[:, :2] < shape[::-1])).all()
        if not grey.any() or max(shape) < 2 or min(shape) < 7:
            assert len(table) == 0
        owner, angle = space.orient(np.arange(len(table)))
        assert space.describe(owner, angle).shape == (len(owner), 128)


def test_a_constant_picture_has_no_features():
    for value in (0, 128, 255):
        assert len(feature_method("rootsift").detect(np.full((90, 121), value, np.uint8), 100)) == 0


def test_colour_and_wrong_calls_are_refused():
    with pytest.raises(TypeError):
        found(np.zeros((20, 20, 3), np.uint8))
    space = found(texture(60, 60))
    with pytest.raises(ValueError, match="extremum"):
        space.orient(np.array([len(space.table())]))
    with pytest.raises(ValueError, match="direction"):
        space.describe(np.array([0]), np.array([np.nan]))
    with pytest.raises(ValueError, match="limit"):
        found(texture(60, 60), least=0.0)


def all_bytes(f):
    return b"".join(np.ascontiguousarray(a).tobytes() for a in (f.xy_px, f.scale_px, f.angle, f.descriptors))


def test_one_and_many_threads_give_the_same_bits():
    pictures = [texture(211, 301, k) for k in range(4)] * 3
    method = feature_method("rootsift")
    alone = [all_bytes(method.detect(p, 500)) for p in pictures]
    with ThreadPoolExecutor(8) as threads:
        together = list(threads.map(lambda p: all_bytes(method.detect(p, 500)), pictures))
    assert alone == together


ANOTHER = """
import json, sys
import numpy as np
from raybundle.numerics import native
grey = np.load(sys.argv[1])
space = native.required().search_features(grey, 1.275, True)
table = space.table()
owner, angle = space.orient(np.arange(len(table)))
print(json.dumps([native.instruction_set(), table.tolist(), angle.tolist(), space.describe(owner, angle).tolist()]))
"""


def test_the_same_features_with_every_instruction_set(tmp_path):
    np.save(tmp_path / "grey.npy", texture(140, 170, 5))
    results = {}
    for limit in ("1", "avx2", "baseline"):
        command = [sys.executable, "-c", ANOTHER, str(tmp_path / "grey.npy")]
        done = subprocess.run(command, env={**os.environ, "RAYBUNDLE_NATIVE": limit}, check=True, capture_output=True)
        name, *results[limit] = json.loads(done.stdout)
        assert limit == "1" or name in {limit, "baseline"}
    for limit in ("avx2", "baseline"):
        for one, other in zip(results["1"], results[limit], strict=True):
            a, b = np.array(one), np.array(other)
            assert a.shape == b.shape
            assert np.mean(np.abs(a - b) <= (1 if a.shape[-1] == 128 else 2e-3)) > 0.995


def test_without_kernels_opencv_finds_the_features(monkeypatch):
    """Under a key of its own, so that neither takes up what the other has stored; the same kind of descriptors."""
    grey = texture(300, 400, 13)
    ours, content = RootSift().detect(grey, 500), RootSift().content
    monkeypatch.setattr(native, "module", lambda: None)
    theirs = RootSift().detect(grey, 500)
    assert RootSift().content != content
    near = np.linalg.norm(ours.xy_px[:, None] - theirs.xy_px[None], axis=2)
    i, j = np.nonzero(near < 0.3)
    alike = (np.abs(ours.scale_px[i] / theirs.scale_px[j] - 1) < 0.15) & (
        np.abs((ours.angle[i] - theirs.angle[j] + np.pi) % (2 * np.pi) - np.pi) < 0.1
    )
    assert alike.sum() > 50
    a, b = (RootSift().vectors(d) for d in (ours.descriptors[i[alike]], theirs.descriptors[j[alike]]))
    assert np.median((a * b).sum(axis=1)) > 0.95
