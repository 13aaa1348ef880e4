"""Verification by epipolar geometry, trust in pairs, conflict-free tracks, choice of pairs."""

import numpy as np

from raybundle.matching.tracks import tracks_of
from raybundle.matching.verify import VerifiedPair, trusted, verify

SIZE = (2000, 1500)


def views(depth, shift=(0.8, 0.1, 0.0), angle=0.1, n=200, seed=1):
    """Image points of n object points in two photographs."""
    rng = np.random.default_rng(seed)
    X = np.column_stack([rng.uniform(-3, 3, n), rng.uniform(-2, 2, n), depth(rng, n)])
    c, s = np.cos(angle), np.sin(angle)
    R = np.array([[c, 0, s], [0, 1, 0], [-s, 0, c]])

    def image(P):
        return 1800 * P[:, :2] / P[:, 2:] + [1000, 750]

    return image(X) + rng.normal(0, 0.3, (n, 2)), image((X - shift) @ R.T) + rng.normal(0, 0.3, (n, 2))


def relief(rng, n):
    return rng.uniform(6, 9, n)


def plane(rng, n):
    return np.full(n, 8.0)


def pairs_with_outliers(n, wrong, seed=2):
    rng = np.random.default_rng(seed)
    matches = np.column_stack([np.arange(n), np.arange(n)]).astype(np.int32)
    matches[:wrong, 1] = rng.permutation(n)[:wrong]
    return matches


def test_wrong_matches_leave():
    a, b = views(relief)
    found = verify(0, 1, a, b, pairs_with_outliers(200, 60), SIZE, SIZE)
    assert found.geometry == "general"
    right = (found.matches[:, 0] == found.matches[:, 1]).mean()
    assert right > 0.9
    assert 130 <= len(found.matches) <= 160


def test_a_plane_and_a_turn_are_recognised():
    a, b = views(plane)
    assert verify(0, 1, a, b, pairs_with_outliers(200, 20), SIZE, SIZE).geometry == "planar"
    a, b = views(relief, shift=(0, 0, 0))
    assert verify(0, 1, a, b, pairs_with_outliers(200, 20), SIZE, SIZE).geometry in {"planar", "rotation"}


def test_a_watermark_is_no_object():
    rng = np.random.default_rng(3)
    stamp = np.column_stack([rng.uniform(1700, 1950, 60), rng.uniform(1400, 1480, 60)])
    found = verify(0, 1, stamp, stamp + rng.normal(0, 0.1, stamp.shape), pairs_with_outliers(60, 0), SIZE, SIZE)
    assert found.geometry == "watermark"
    assert len(found.matches) == 0


def test_chance_is_no_pair():
    rng = np.random.default_rng(4)
    a, b = rng.uniform(0, 1500, (60, 2)), rng.uniform(0, 1500, (60, 2))
    found = verify(0, 1, a, b, pairs_with_outliers(60, 60), SIZE, SIZE)
    assert len(found.matches) < 30
    assert len(verify(0, 1, a, b, pairs_with_outliers(60, 60)[:10], SIZE, SIZE).matches) == 0


def pair(i, j, matches, candidates=None):
    m = np.array(matches, np.int32).reshape(-1, 2)
    return VerifiedPair(
        first=i, second=j, matches=m, candidates=candidates or len(m), geometry="general", planar_share=0.5,
        displacement_px=50.0,
    )  # fmt: skip


def test_weak_pairs_are_used_only_where_there_is_nothing_better():
    strong = [(k, k) for k in range(50)]
    pairs = [pair(0, 1, strong), pair(1, 2, strong), pair(0, 2, strong[:16], 300), pair(2, 3, strong[:16], 300)]
    assert [(p.first, p.second) for p in trusted(pairs, 4)] == [(0, 1), (1, 2), (2, 3)]


def test_tracks_have_one_place_in_an_image():
    xy = [np.column_stack([np.arange(10.0), np.arange(10.0)]) * 20 for _ in range(3)]
    pairs = [pair(0, 1, [(0, 0), (1, 1)]), pair(1, 2, [(0, 0), (1, 1)]), pair(0, 2, [(0, 0), (5, 1)])]
    tracks = tracks_of(pairs, xy)
    for p in range(tracks.points):
        images = tracks.image[tracks.point == p]
        assert len(images) > 1
        assert len(np.unique(images)) == len(images)
    assert len(tracks.conflicts) == len(tracks.apart_px) == 1
    assert max(np.bincount(tracks.point)) == 3


def test_features_at_one_place_are_one():
    xy = [np.array([[10.0, 10.0], [10.0, 10.0], [50.0, 50.0]]), np.array([[11.0, 10.0], [51.0, 50.0]])]
    tracks = tracks_of([pair(0, 1, [(0, 0), (2, 1)])], xy)
    other = tracks_of([pair(0, 1, [(1, 0), (2, 1)])], xy)
    assert (tracks.feature == other.feature).all()


def test_no_pairs_no_tracks():
    assert tracks_of([], [np.zeros((3, 2))]).points == 0
