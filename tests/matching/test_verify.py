"""Verification of pairs, the choice of trusted ones, and tracks."""

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from raybundle.matching.tracks import tracks_of
from raybundle.matching.verify import FEWEST, VerifiedPair, beyond_chance, log_false_alarms, trusted, verify
from tests.matching.scenes import SIZE, relief, view, with_wrong_matches

FIRST, SECOND = ([-0.6, 0.1, 8.0], [2.0, -4.0, 1.0]), ([0.9, -0.2, 7.5], [-1.0, 7.0, 4.0])


def verified(p, q, wrong=0, seed=1):
    """The pair, and how many of the right and of the wrong matches it kept."""
    xy1, xy2, matches = with_wrong_matches(p, q, wrong, seed)
    pair = verify(3, 5, xy1, xy2, matches, SIZE, SIZE)
    right = {tuple(m) for m in matches[: len(p)].tolist()}
    kept = {tuple(m) for m in pair.matches.tolist()}
    assert kept <= {tuple(m) for m in matches.tolist()}
    return pair, len(kept & right), len(kept - right)


@pytest.mark.parametrize("wrong", [0, 60, 200])
def test_relief_seen_from_two_places_is_a_general_pair(wrong):
    xyz = relief(200, 2)
    pair, right, false = verified(view(xyz, *FIRST), view(xyz, *SECOND), wrong)
    assert (pair.first, pair.second, pair.candidates) == (3, 5, 200 + wrong)
    assert pair.geometry == "general"
    assert right > 0.98 * 200
    assert false <= 0.05 * wrong  # a wrong match stays where it happens to lie by its epipolar line
    assert pair.planar_share < 0.85


def test_a_plane_is_told_from_relief():
    xyz = relief(150, 4, plane=True)
    pair, right, false = verified(view(xyz, *FIRST), view(xyz, *SECOND), 50)
    assert pair.geometry == "planar"
    assert right > 0.98 * 150
    assert false <= 0.15 * 50  # wrong matches that lie near an epipolar line stay
    assert pair.planar_share > 0.85
    assert pair.displacement_px > 20


def test_a_repeated_photograph_has_no_base():
    p = view(relief(150, 5), *FIRST)
    pair, right, _ = verified(p, p + 0.2)
    assert pair.geometry == "rotation"
    assert right > 0.98 * 150
    assert pair.displacement_px < 1.5


def test_a_turn_of_the_camera_is_explained_by_a_homography():
    xyz = relief(150, 6)
    pair, right, _ = verified(view(xyz, *FIRST), view(xyz, FIRST[0], [5.0, 1.0, 12.0]), 40)
    assert pair.planar_share > 0.85
    assert right > 0.98 * 150


def test_a_stamp_in_the_corner_is_a_watermark_and_matches_nothing():
    rng = np.random.default_rng(7)
    stamp = rng.uniform([1250, 1120], [1560, 1170], (80, 2))
    pair, *_ = verified(stamp, stamp + rng.normal(0, 0.1, stamp.shape))
    assert pair.geometry == "watermark"
    assert len(pair.matches) == 0


def test_a_stamp_does_not_hide_what_the_photographs_share():
    xyz = relief(200, 8)
    rng = np.random.default_rng(8)
    stamp = rng.uniform([1250, 1120], [1560, 1170], (30, 2))
    p, q = np.concatenate([view(xyz, *FIRST), stamp]), np.concatenate([view(xyz, *SECOND), stamp])
    pair, right, _ = verified(p, q)
    assert pair.geometry == "general"
    assert right > 0.9 * 200


@pytest.mark.parametrize("count", [0, 1, 7, FEWEST - 1])
def test_few_matches_are_not_believed(count):
    p = view(relief(count, 9), *FIRST)
    pair, *_ = verified(p, p + 5)
    assert pair.geometry == "none"
    assert pair.matches.shape == (0, 2)
    assert pair.candidates == count


def test_matches_at_random_are_not_believed():
    nothing = np.zeros((0, 2))
    pair, *_ = verified(nothing, nothing, wrong=40, seed=10)
    assert pair.geometry == "none"
    assert len(pair.matches) == 0


def test_verification_gives_the_same_twice():
    xyz = relief(120, 11)
    a, b = (verified(view(xyz, *FIRST), view(xyz, *SECOND), 80)[0] for _ in range(2))
    np.testing.assert_array_equal(a.matches, b.matches)
    assert (a.geometry, a.planar_share) == (b.geometry, b.planar_share)


def pair(first, second, matches, candidates=None):
    table = np.asarray(matches, np.int32).reshape(-1, 2)
    return VerifiedPair(
        first=first, second=second, matches=table, candidates=candidates or len(table),
        geometry="general" if len(table) else "none", planar_share=0.3, displacement_px=50.0,
    )  # fmt: skip


def several(n):
    return np.stack([np.arange(n), np.arange(n)], axis=1)


def ends(pairs):
    return [(p.first, p.second) for p in pairs]


def test_strong_pairs_are_trusted_and_weak_ones_only_where_there_is_no_other():
    strong, weak = several(60), several(20)
    pairs = [pair(0, 1, strong), pair(1, 2, strong), pair(0, 2, weak), pair(2, 3, weak), pair(3, 4, [])]
    assert ends(trusted(pairs, 5)) == [(0, 1), (1, 2), (2, 3)]


def test_many_candidates_of_which_few_fit_are_a_weak_pair():
    repeated = pair(0, 2, several(60), candidates=400)
    assert ends(trusted([pair(0, 1, several(50)), pair(1, 2, several(50)), repeated], 3)) == [(0, 1), (1, 2)]


def test_of_weak_pairs_the_better_is_taken_first():
    pairs = [pair(0, 1, several(16)), pair(0, 2, several(30)), pair(1, 2, several(25))]
    assert ends(trusted(pairs, 3)) == [(0, 2), (1, 2)]


def places(*counts, seed=1):
    """Features of images, no two at one place."""
    rng = np.random.default_rng(seed)
    return [np.stack([10.0 * np.arange(n), rng.uniform(0, 1000, n)], axis=1) for n in counts]


def as_sets(t):
    return {
        frozenset(zip(t.image[t.point == k].tolist(), t.feature[t.point == k].tolist(), strict=True))
        for k in range(t.points)
    }


def test_matches_of_several_pairs_join_to_tracks():
    pairs = [pair(0, 1, [[0, 5], [1, 6]]), pair(1, 2, [[5, 2], [4, 4]]), pair(0, 2, [[0, 2]])]
    t = tracks_of(pairs, places(8, 8, 8))
    assert as_sets(t) == {
        frozenset({(0, 0), (1, 5), (2, 2)}), frozenset({(0, 1), (1, 6)}), frozenset({(1, 4), (2, 4)})
    }  # fmt: skip
    assert len(t.conflicts) == 0
    assert (np.diff(t.point) >= 0).all()


def test_a_match_that_would_put_a_point_twice_into_an_image_is_left_out():
    # the chain 0:0 - 1:0 - 2:0 is of strong pairs, the weak pair (0, 2) says 0:1 - 2:0
    filler = [[k, k] for k in range(2, 7)]
    pairs = [pair(0, 1, [[0, 0], *filler]), pair(1, 2, [[0, 0], *filler]), pair(0, 2, [[1, 0]])]
    t = tracks_of(pairs, places(8, 8, 8))
    assert len(t.conflicts) == 1
    assert frozenset({(0, 0), (1, 0), (2, 0)}) in as_sets(t)
    assert not any((0, 1) in track for track in as_sets(t))
    assert t.points == 6


def test_features_at_one_place_count_as_one():
    xy = places(4, 4, 4)
    xy[1][3] = xy[1][2] + 0.01  # one blob with two orientations
    t = tracks_of([pair(0, 1, [[0, 2]]), pair(1, 2, [[3, 1]])], xy)
    assert as_sets(t) == {frozenset({(0, 0), (1, 2), (2, 1)})}


def test_no_matches_give_no_tracks():
    t = tracks_of([pair(0, 1, [])], places(3, 3))
    assert t.points == 0
    assert len(t.image) == len(t.feature) == len(t.point) == 0


@given(st.data())
@settings(max_examples=60, deadline=None, derandomize=True)
def test_no_track_has_two_places_in_one_image_or_a_ray_alone(data):
    images = data.draw(st.integers(2, 5))
    match = st.tuples(st.integers(0, 5), st.integers(0, 5))
    pairs = [
        pair(i, j, data.draw(st.lists(match, max_size=6, unique=True)))
        for i in range(images)
        for j in range(i + 1, images)
    ]
    t = tracks_of(pairs, places(*[6] * images))
    key = t.point.astype(int) * images + t.image
    assert len(np.unique(key)) == len(key)
    if t.points:
        assert np.bincount(t.point).min() >= 2
        assert sorted(set(t.point.tolist())) == list(range(t.points))
    feature = t.image.astype(int) * 6 + t.feature
    assert len(np.unique(feature)) == len(feature)
    offered = {(p.first, a, p.second, b) for p in pairs for a, b in p.matches.tolist()}
    linked = {(i, a) for i, a, *_ in offered} | {(j, b) for *_, j, b in offered}
    assert set(zip(t.image.tolist(), t.feature.tolist(), strict=True)) <= linked


def test_what_chance_explains_among_so_many_pairs_is_believed_no_more():
    """Random matches: what a geometry explains of them is chance; of right ones it never is."""
    rng = np.random.default_rng(5)
    by_chance = []
    for seed in range(12):
        xy1, xy2 = rng.uniform(0, SIZE, (400, 2)), rng.uniform(0, SIZE, (400, 2))
        by_chance.append(
            verify(0, seed + 1, xy1, xy2, np.tile(np.arange(400)[:, None], 2).astype(np.int32), SIZE, SIZE)
        )
    assert sum(len(p.matches) > 0 for p in by_chance) > 6  # fifteen of four hundred are soon found
    xyz = relief(60, 2)
    right = verified(view(xyz, *FIRST), view(xyz, *SECOND), 100)[0]
    plane = verified(*(view(relief(60, 4, plane=True), *v) for v in (FIRST, SECOND)), 100)[0]
    kept = beyond_chance([*by_chance, right, plane])
    assert [len(p.matches) > 0 for p in kept] == [False] * 12 + [True] * 2
    assert {p.geometry for p in kept[:12]} == {"none"}


def test_the_number_of_false_alarms_is_that_of_the_formula():
    # 3 (20 - 7) C(20, 15) C(15, 7) 0.01^8
    assert log_false_alarms(20, 15, 0.01, 7, 3) == pytest.approx(np.log(39 * 15504 * 6435 * 1e-16))
    assert log_false_alarms(20, 7, 0.01, 7, 3) == np.inf
