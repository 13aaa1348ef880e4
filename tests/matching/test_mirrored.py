"""Mirrored photographs: descriptors without a new detection, groups, symmetrical things, what is reported."""

from types import SimpleNamespace

import cv2
import numpy as np
import pytest
from scipy.spatial import KDTree

from raybundle.matching.methods import feature_method
from raybundle.matching.reduced import Reduced
from raybundle.ties.mirrored import mirrored_among, stored_mirrored
from tests.matching.test_features import texture


def test_descriptors_of_the_mirrored_picture_need_no_detection():
    method = feature_method("rootsift")
    grey = cv2.GaussianBlur(texture(240, 320), (0, 0), 1.2)
    one, two = method.detect(grey, 400), method.detect(np.ascontiguousarray(grey[:, ::-1]), 400)
    apart, at = KDTree(two.xy_px).query(np.column_stack([320 - one.xy_px[:, 0], one.xy_px[:, 1]]))
    turn = (one.angle + two.angle[at]) % (2 * np.pi) - np.pi
    same = (apart < 0.3) & (np.abs(turn) < 0.05)
    assert same.sum() > 100
    a, b = (x[same].astype(float) for x in (method.mirrored(one.descriptors), two.descriptors[at]))
    alike = (a * b).sum(axis=1) / np.linalg.norm(a, axis=1) / np.linalg.norm(b, axis=1)
    assert np.median(alike) > 0.99
    np.testing.assert_array_equal(Reduced(method).mirrored(one.descriptors), method.mirrored(one.descriptors))


def row(n=10, neighbours=1000, *, symmetrical=0):
    """Matches (n, n) of photographs along a facade, as they are and mirrored."""
    apart = np.abs(np.subtract.outer(np.arange(n), np.arange(n)))
    plain = np.where(apart == 0, 0, neighbours // 2 ** np.maximum(apart - 1, 0))
    return plain, np.full((n, n), symmetrical)


def found(plain, mirror, out=()):
    """What is found if some photographs are mirrored, with 20 matches by chance; pairs by number of photographs."""
    n = len(plain)
    chosen = np.isin(np.arange(n), out)
    across = chosen[:, None] != chosen
    plain, mirror = np.where(across, np.maximum(mirror, 20), plain), np.where(across, plain, mirror)
    ends = np.argwhere(np.triu(np.ones((n, n), bool), 1))
    asked = lambda i, j: int(mirror[i, j])  # noqa: E731
    return mirrored_among(ends, plain[ends[:, 0], ends[:, 1]], n, asked, asked)


@pytest.mark.parametrize("out", [(0,), (4,), (3, 4, 5), (0, 9), (1, 4, 7), (6, 7, 8, 9)])
def test_mirrored_photographs_are_found(out):
    m = found(*row(), out)
    assert m.certain
    assert m.photographs == out
    assert m.pair[0] in out
    assert m.pair[1] not in out
    assert m.matches == 1000
    assert m.plain == 20


def test_ordinary_photographs_are_not_accused():
    assert found(*row()) is None
    assert found(*row(symmetrical=400)) is None
    assert found(*row(neighbours=40)) is None  # chance explains as many
    plain, mirror = row()
    plain[:, 4] = plain[4] = 60  # one that hangs on the others by few
    assert found(plain, mirror) is None
    assert mirrored_among(np.zeros((0, 2), int), np.zeros(0, int), 3, None, None) is None


def test_where_a_symmetrical_object_explains_them_they_stay():
    m = found(*row(symmetrical=300), (4,))
    assert not m.certain
    assert m.photographs == (4,)
    assert m.plain == 300


def test_of_two_halves_neither_is_left_out():
    m = found(*row(), (0, 1, 2, 3, 4))
    assert not m.certain
    assert len(m.photographs) == 5


def test_photographs_that_are_stored_mirrored_are_named():
    photos = [SimpleNamespace(name=str(k), orientation=k) for k in range(1, 9)]
    (notice,) = stored_mirrored(photos)
    assert notice.values["names"] == ["2", "4", "5", "7"]
    assert not stored_mirrored([photos[0], photos[5]])
