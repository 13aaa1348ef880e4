"""Two equal panels on a wall: photographs of one are not placed before the other, or a fault names them."""

import numpy as np
import pytest

from raybundle.matching.tracks import tracks_of
from raybundle.ties.arrangements import CELLS, arrangement, best_arrangement, similarity
from raybundle.ties.repeated import sound_pairs

from .test_repeated import C_PX, DIAGONALS, HEIGHT, WIDTH, orient_with, pair

PANEL = 150


def wall(equal, places_x, seed=1):
    """Places of features, and the pairs that matching would find; the panels' middles stand at 3 and 11 m."""
    rng = np.random.default_rng(seed)
    xyz = np.column_stack([rng.uniform(0, 14, 4000), rng.uniform(-0.4, 0.4, 4000), rng.uniform(0, 4, 4000)])
    xyz = xyz[(abs(abs(xyz[:, 0] - 7) - 4) > 1) | (abs(xyz[:, 2] - 2) > 1)]
    panel = np.column_stack([rng.uniform(-1, 1, PANEL), rng.uniform(-0.2, 0.2, PANEL), rng.uniform(1, 3, PANEL)])
    looks = np.concatenate(
        [np.arange(len(xyz)), *(len(xyz) + np.arange(PANEL) + PANEL * (k and not equal) for k in (0, 1))]
    )
    xyz = np.vstack([xyz, *(panel + np.array([x, 0, 0]) for x in (3, 11))])
    places, shown = [], []
    for k, x in enumerate(places_x):
        centre = np.array([x, -5.0 - 0.6 * (k % 2), 2 + 0.3 * (k % 3)])
        d = xyz - centre
        xy = np.stack([WIDTH / 2 + C_PX * d[:, 0] / d[:, 1], HEIGHT / 2 - C_PX * d[:, 2] / d[:, 1]], axis=1)
        xy += rng.normal(0, 0.3, xy.shape)
        inside = (xy > 5).all(axis=1) & (xy < (WIDTH - 5, HEIGHT - 5)).all(axis=1) & (rng.random(len(xy)) < 0.8)
        rows = np.flatnonzero(inside)
        places.append(xy[rows])
        shown.append(rows)
    pairs = []
    for i in range(len(places)):
        for j in range(i + 1, len(places)):
            # what is shown twice in one photograph is clear in none
            ends = [np.unique(looks[s], return_index=True, return_counts=True) for s in (shown[i], shown[j])]
            (a, at_a, na), (b, at_b, nb) = ends
            _, ia, ib = np.intersect1d(a[na == 1], b[nb == 1], return_indices=True)
            matches = np.column_stack([at_a[na == 1][ia], at_b[nb == 1][ib]])
            if len(matches) >= 40:
                pairs.append(pair(i, j, matches))
    return places, pairs


def arranged(places, pairs):
    names = [f"p{k:02d}" for k in range(len(places))]
    orient, diagonals = orient_with(places), DIAGONALS[: len(places)]

    def join(some):
        return tracks_of(some, places)

    sound = sound_pairs(pairs, places, names, diagonals, orient, join)
    first = arrangement(sound, orient(sound.tracks), places)
    return first, *best_arrangement(sound, pairs, places, names, diagonals, orient, join)


GROUPS = [2.2, 2.6, 3.0, 3.4, 3.8, 10.2, 10.6, 11.0, 11.4, 11.8]
CHAIN = np.linspace(2, 12, 10)


def test_photographs_of_two_equal_panels_stand_in_two_parts():
    first, sound, ties = arranged(*wall(True, GROUPS))
    assert [sorted(g.tolist()) for g in first.groups] == [[0, 1, 2, 3, 4], [5, 6, 7, 8, 9]]
    assert first.missing >= CELLS
    assert sorted(np.flatnonzero(t.block.images.oriented).tolist() for t in ties) == [[*range(5)], [*range(5, 10)]]
    (notice,) = [n for n in sound.notices if n.variant == "rearranged"]
    assert notice.severity.value == "warning"
    assert set(notice.ids) == {f"p{k:02d}" for k in range(10)}


@pytest.mark.parametrize(("equal", "places_x"), [(False, GROUPS), (False, CHAIN)])
def test_panels_that_differ_leave_everything_as_it_is(equal, places_x):
    places, pairs = wall(equal, places_x)
    first, sound, ties = arranged(places, pairs)
    assert not first.groups
    assert not sound.notices
    assert sum(int(t.block.images.oriented.sum()) for t in ties) == 10


def test_a_chain_of_photographs_past_both_panels_is_placed_along_the_wall():
    places, pairs = wall(True, CHAIN)
    _, sound, ties = arranged(places, pairs)
    assert not [n for n in sound.notices if n.severity.value == "fault"]
    (tie,) = ties
    centre = tie.block.images.centre
    steps = np.linalg.norm(np.diff(centre, axis=0), axis=1)
    ends = np.linalg.norm(centre[-1] - centre[0])
    assert 0.6 < ends / steps.sum() < 1.0


def test_similarity_is_the_share_of_features_that_match_anywhere():
    places = [np.zeros((10, 2))] * 3
    pairs = [pair(0, 1, np.column_stack([np.arange(4)] * 2)), pair(1, 2, np.column_stack([np.arange(4, 6)] * 2))]
    assert similarity(pairs, places).tolist() == [4 / 6, 2 / 6]
