"""Equal windows round a tower: wrong pairs that one geometry explains are named, and the tower is whole."""

from types import SimpleNamespace

import numpy as np
import pytest

from raybundle.block import Camera
from raybundle.errors import NoOrientation
from raybundle.matching.tracks import numbers, placed, tracks_of
from raybundle.matching.verify import VerifiedPair
from raybundle.sensors import sensor_models
from raybundle.ties.block import block_of_tracks
from raybundle.ties.repeated import CONTRADICTED, contradicted, sound_pairs, spanning
from raybundle.workflows.orienting.connected_components import start_components

SIDES, PHOTOGRAPHS, C_PX, WIDTH, HEIGHT = 6, 18, 1100.0, 1200, 900
DIAGONALS = np.full(PHOTOGRAPHS, np.hypot(WIDTH, HEIGHT))


def tower(seed=1, wall=900, window=40):
    """Points (n, 3) on a tower of radius 3, and the point of the next window that looks like each (-1 on the wall)."""
    rng = np.random.default_rng(seed)
    angle, height = rng.uniform(0, 2 * np.pi, wall), rng.uniform(0, 6, wall)
    own_angle, own_height = rng.uniform(-0.2, 0.2, window), rng.uniform(1.5, 4.5, window)
    of_windows = np.concatenate([own_angle + 2 * np.pi * (k + 0.5) / SIDES for k in range(SIDES)])
    angle = np.concatenate([angle, of_windows])
    height = np.concatenate([height, np.tile(own_height, SIDES)])
    xyz = np.stack([3 * np.cos(angle), 3 * np.sin(angle), height], axis=1)
    looks = np.concatenate([-np.ones(wall, int), np.tile(np.arange(window), SIDES)])
    return xyz, looks


def seen(xyz, k):
    """Image points (n, 2) [px] of photograph k of a ring, and whether they are seen."""
    a = 2 * np.pi * k / PHOTOGRAPHS
    centre = np.array([11 * np.cos(a), 11 * np.sin(a), 2.5 + 0.4 * (k % 2)])
    z = (centre - [0, 0, 3]) / np.linalg.norm(centre - [0, 0, 3])
    x = np.cross([0, 0, 1], z)
    x /= np.linalg.norm(x)
    P = (xyz - centre) @ np.stack([x, np.cross(z, x), z]).T
    xy = np.stack([WIDTH / 2 - C_PX * P[:, 0] / P[:, 2], HEIGHT / 2 + C_PX * P[:, 1] / P[:, 2]], axis=1)
    outward = np.column_stack([xyz[:, :2] / 3, np.zeros(len(xyz))])
    towards = ((centre - xyz) * outward).sum(axis=1) / np.linalg.norm(centre - xyz, axis=1)
    return xy + np.random.default_rng(k).normal(0, 0.3, xy.shape), towards > 0.35


@pytest.fixture(scope="module")
def scene():
    """Places of features, object points they show, pairs, and whether each pair is right."""
    xyz, looks = tower()
    places, shown = [], []
    for k in range(PHOTOGRAPHS):
        xy, visible = seen(xyz, k)
        rows = np.flatnonzero(visible)
        places.append(xy[rows])
        shown.append(rows)
    pairs, right = [], []
    for i in range(PHOTOGRAPHS):
        for j in range(i + 1, PHOTOGRAPHS):
            _, a, b = np.intersect1d(shown[i], shown[j], return_indices=True)
            if len(a) >= 150:
                pairs.append(pair(i, j, np.column_stack([a, b])))
                right.append(True)
                continue
            # the window that each photograph shows best is taken for that of the other
            best = [np.flatnonzero(looks[s] >= 0) for s in (shown[i], shown[j])]
            first = {int(looks[shown[i][r]]): r for r in best[0]}
            second = {int(looks[shown[j][r]]): r for r in best[1]}
            common = sorted(first.keys() & second.keys())
            pairs.append(pair(i, j, np.array([(first[k], second[k]) for k in common])))
            share = np.mean([shown[i][first[k]] == shown[j][second[k]] for k in common])
            right.append(share > 0.5)
    return places, pairs, np.array(right)


def pair(i, j, matches):
    return VerifiedPair(
        first=i, second=j, matches=matches.astype(np.int32), candidates=len(matches), geometry="general",
        planar_share=0.5, displacement_px=50.0,
    )  # fmt: skip


def orient_with(places):
    values = dict.fromkeys((p.symbol for p in sensor_models["brown"].parameters), 0.0) | {"c": C_PX * 0.001}
    camera = Camera(id="1", model="brown", width_px=WIDTH, height_px=HEIGHT, pixel_mm=(0.001, 0.001), values=values)
    photos = [SimpleNamespace(name=f"p{k:02d}") for k in range(len(places))]

    def orient(tracks):
        xy = placed(places)(numbers(tracks.image, tracks.feature))
        raw = block_of_tracks(photos, [camera], np.zeros(len(photos), int), xy, tracks)
        n = len(tracks.image)
        return start_components(raw, np.full(n, 4.0), np.zeros(n), 1)

    return orient


def found(scene):
    places, pairs, _ = scene
    names = [f"p{k:02d}" for k in range(len(places))]
    return sound_pairs(pairs, places, names, DIAGONALS, orient_with(places), lambda some: tracks_of(some, places))


def test_pairs_of_different_windows_are_left_out_by_name_and_the_others_stay(scene):
    places, pairs, right = scene
    assert (~right).sum() > 40
    assert contradicted(pairs, tracks_of(pairs, places), DIAGONALS) > CONTRADICTED
    sound = found(scene)
    kept = {(p.first, p.second) for p in sound.pairs}
    assert kept == {(p.first, p.second) for p, r in zip(pairs, right, strict=True) if r}
    (notice,) = sound.notices
    assert notice.code == "repeated_structure"
    assert notice.severity.value == "warning"
    assert notice.values["pairs"] == (~right).sum()
    wrong = next(p for p, r in zip(pairs, right, strict=True) if not r)
    assert f"p{wrong.first:02d} - p{wrong.second:02d}" in notice.values["names"]
    assert contradicted(sound.pairs, sound.tracks, DIAGONALS) < CONTRADICTED


def test_the_tower_that_results_is_whole(scene):
    places, _, _ = scene
    (part,) = orient_with(places)(found(scene).tracks)
    centres = part.block.images.centre
    assert np.isfinite(centres).all()
    a = 2 * np.pi * np.arange(PHOTOGRAPHS) / PHOTOGRAPHS
    truth = np.stack([11 * np.cos(a), 11 * np.sin(a), 2.5 + 0.4 * (np.arange(PHOTOGRAPHS) % 2)], axis=1)
    p, q = centres - centres.mean(axis=0), truth - truth.mean(axis=0)
    U, S, V = np.linalg.svd(q.T @ p)
    assert np.linalg.det(U @ V) > 0
    assert np.abs(q - S.sum() / (p**2).sum() * p @ (U @ V).T).max() < 0.05


def test_ordinary_matches_are_left_as_they_are(scene):
    places, pairs, right = scene
    sound = found((places, [p for p, r in zip(pairs, right, strict=True) if r], right[right]))
    assert not sound.notices
    assert len(sound.pairs) == right.sum()


@pytest.mark.parametrize(("apart_px", "doubted"), [(5.0, False), (60.0, False), (90.0, True)])
def test_a_detail_found_twice_close_by_contradicts_nothing(apart_px, doubted):
    """Every second object point is found at two places of every photograph, and each pair matches either."""
    rng = np.random.default_rng(1)
    n, count = 300, 6
    base = rng.uniform(100, 800, (n, 2))
    places = [np.vstack([base, base + np.array([apart_px, 0.0])]) for _ in range(count)]
    pairs = []
    for i in range(count):
        for j in range(i + 1, count):
            second = np.arange(n) + n * (rng.random(n) < 0.3)
            pairs.append(pair(i, j, np.column_stack([np.arange(n), second])))
    share = contradicted(pairs, tracks_of(pairs, places), DIAGONALS)
    assert (share > CONTRADICTED) is doubted


def test_what_cannot_be_told_apart_is_a_fault(scene):
    places, pairs, _ = scene
    names = [f"p{k:02d}" for k in range(len(places))]

    def nothing(_tracks):
        raise NoOrientation("no")

    sound = sound_pairs(
        pairs, places, names, np.full(len(places), 1500.0), nothing, lambda some: tracks_of(some, places)
    )
    assert sound.notices[0].severity.value == "fault"
    assert sound.notices[0].variant == "ambiguous"
    assert len(sound.pairs) == len(pairs)


def test_trees_of_the_strongest_pairs_hang_together_in_as_many_ways():
    def strong(i, j, n):
        return pair(i, j, np.zeros((n, 2), int))

    pairs = [strong(0, 1, 90), strong(1, 2, 80), strong(0, 2, 70), strong(2, 3, 60), strong(1, 3, 50), strong(0, 3, 40)]
    assert [(p.first, p.second) for p in spanning(pairs, 4, 1)] == [(0, 1), (1, 2), (2, 3)]
    assert len(spanning(pairs, 4, 2)) == 6
