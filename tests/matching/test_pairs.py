"""The choice of pairs: first ones, neighbours in common, parts."""

import numpy as np

from raybundle.matching.pairs import (
    BEST,
    FIRST,
    NEAR,
    NEARBY,
    Candidates,
    all_pairs,
    common_pairs,
    contained,
    first_round,
    joining_round,
    linked,
    nearby_pairs,
    needed,
    outside_largest,
    parts_of,
    sequence_pairs,
    unique_pairs,
)


def rows(*pairs):
    return np.array(pairs, np.int64).reshape(-1, 2)


def as_set(pairs):
    return {tuple(p) for p in pairs.tolist()}


def candidates(pairs, shared, likeness=None):
    pairs = unique_pairs(rows(*pairs))
    like = np.zeros(len(pairs), np.int64) if likeness is None else np.asarray(likeness)
    return Candidates(pairs=pairs, shared=np.asarray(shared), likeness=like)


def test_all_pairs():
    for n in (0, 1, 2, 7):
        pairs = all_pairs(n)
        assert len(as_set(pairs)) == len(pairs) == n * (n - 1) // 2
        assert (pairs[:, 0] < pairs[:, 1]).all()


def test_pairs_are_unique_whatever_their_order():
    assert unique_pairs(rows((3, 1), (1, 3), (2, 2), (0, 5))).tolist() == [[0, 5], [1, 3]]
    assert unique_pairs().shape == (0, 2)
    assert contained(rows((1, 3), (0, 4)), rows((1, 3), (2, 3))).tolist() == [True, False]


def test_those_that_follow_each_other():
    assert as_set(unique_pairs(sequence_pairs(np.array([2, 0, 1])))) == {(1, 2), (0, 2)}


def test_strips_are_tied_by_position_and_unknown_positions_do_no_harm():
    along, strip = np.meshgrid(np.arange(20.0), np.arange(5.0))
    positions = np.stack([10 * along.ravel(), 12 * strip.ravel(), np.full(100, 80.0)], axis=1)
    positions[7] = np.nan
    near = as_set(unique_pairs(nearby_pairs(positions, NEAR)))
    assert {(k, k + 20) for k in range(21, 59) if k % 20 not in (0, 19)} <= near
    assert {(k, k + 1) for k in range(21, 38)} <= near
    assert len(near) <= len(unique_pairs(nearby_pairs(positions, NEARBY))) <= 100 * NEARBY
    assert not [p for p in near if 7 in p]
    assert nearby_pairs(np.full((5, 3), np.nan), 3).shape == (0, 2)


def test_every_image_has_its_best_pairs_though_others_share_more():
    """Twenty images that share much with all others, and one that shares little with any."""
    n = 30
    pairs = all_pairs(n)
    shared = np.where((pairs == n - 1).any(axis=1), 1 + pairs[:, 0] % 7, 100)
    c = Candidates(pairs=pairs, shared=shared, likeness=np.zeros(len(pairs), np.int64))
    first = first_round(c, rows((0, 1)), n)
    assert len(first) == FIRST * n
    lonely = first[(first == n - 1).any(axis=1)]
    assert len(lonely) == BEST
    # those that share most with it: 6 with the images 6, 13, 20, 27, then 5 with the first of the next
    assert lonely[:, 0].tolist() == [5, 6, 13, 20, 27]


def test_certain_pairs_are_matched_whatever_they_look_like():
    n = 40
    pairs = all_pairs(n)
    shared = np.full(len(pairs), 50)
    certain = sequence_pairs(np.arange(n))
    shared[contained(pairs, certain)] = 0
    first = first_round(Candidates(pairs=pairs, shared=shared, likeness=shared), certain, n)
    assert as_set(certain) <= as_set(first)
    assert len(first) == FIRST * n


def test_equal_ones_go_by_the_likeness_of_signatures():
    c = candidates([(0, 1), (0, 2), (1, 2)], [5, 5, 9], [1, 2, 0])
    assert c.pairs[c.order()].tolist() == [[1, 2], [0, 2], [0, 1]]


def test_chance_makes_no_neighbours():
    assert linked(np.array([0, 15, 39, 40, 500])).tolist() == [False, False, False, True, True]


def test_two_neighbours_in_common_make_a_pair_likely():
    links = rows((0, 1), (0, 2), (1, 3), (2, 3), (3, 4), (4, 5))
    pairs, common = common_pairs(links, links, 6)
    assert dict(zip(map(tuple, pairs.tolist()), common.tolist(), strict=True)) == {(0, 3): 2, (1, 2): 2}
    assert not len(common_pairs(links, unique_pairs(links, rows((0, 3), (1, 2))), 6)[0])
    assert not len(common_pairs(rows(), rows(), 6)[0])


def test_common_neighbours_of_many_images_need_no_square_of_their_number():
    n = 100_000
    ring = np.concatenate([np.stack([np.arange(n), (np.arange(n) + k) % n], axis=1) for k in (1, 2)])
    links = unique_pairs(ring)
    pairs, common = common_pairs(links, links, n)
    assert len(pairs) == n  # those three apart
    assert (common == 2).all()


def test_parts():
    parts = parts_of(rows((0, 1), (1, 2), (4, 5)), 6)
    assert len(set(parts.tolist())) == 3
    assert outside_largest(parts).tolist() == [3, 4, 5]


def test_pairs_between_parts_and_of_images_with_few_neighbours_are_needed():
    links = rows((0, 1), (0, 2), (0, 3), (1, 2), (1, 3), (2, 3), (3, 4))
    asked = rows((0, 4), (1, 2), (2, 5), (4, 5))
    assert needed(asked, links, 6).tolist() == [True, False, True, True]
    assert needed(rows((0, 1)), rows(), 2).tolist() == [True]
    assert needed(rows(), links, 6).tolist() == []


def test_every_two_parts_have_their_turn():
    """One pair of parts shares much by repetition, the other little but truly: both are tried."""
    parts = np.array([0, 0, 0, 1, 1, 1, 2, 2])
    between = [(0, 3), (0, 4), (1, 3), (1, 4), (2, 5), (0, 1), (2, 6), (1, 7)]
    shared = {(0, 3): 90, (0, 4): 80, (1, 3): 70, (1, 4): 60, (2, 5): 50, (0, 1): 99, (2, 6): 7, (1, 7): 3}
    pairs = unique_pairs(rows(*between))
    c = candidates(between, [shared[p] for p in map(tuple, pairs.tolist())])
    assert as_set(joining_round(c, parts, 2)) == {(0, 3), (2, 6)}
    assert as_set(joining_round(c, parts, 4)) == {(0, 3), (2, 6), (0, 4), (1, 7)}
    assert (0, 1) not in as_set(joining_round(c, parts, 100))
    assert joining_round(c, parts, 0).shape == (0, 2)
