"""Images in leaves, and oriented parts brought into one system: synthetic models with wrong points and wrong models."""

import numpy as np
import pytest

from raybundle.numerics.rotation import rotation_from_vector
from raybundle.numerics.transform import SimilarityTransform, similarity
from raybundle.orientation.image_leaves import leaves_of
from raybundle.orientation.independent_models import Model, joined_models


def seen_on_a_grid(rows, columns, reach=2):
    """Observations of points at the places of a grid by images at the same places that lie within a reach."""
    place = np.array([(r, c) for r in range(rows) for c in range(columns)])
    apart = np.abs(place[:, None] - place[None]).max(axis=2)
    image, point = np.nonzero(apart <= reach)
    return np.repeat(image, 4), (4 * point[:, None] + np.arange(4)).ravel(), place


def test_leaves_take_every_image_once_and_know_their_surroundings():
    image, point, place = seen_on_a_grid(12, 20)
    leaves = leaves_of(image, point, len(place), 4 * len(place), 30)
    assert np.array_equal(np.sort(np.concatenate([leaf.own for leaf in leaves])), np.arange(len(place)))
    for leaf in leaves:
        assert 10 <= len(leaf.own) <= 30
        assert 0 < len(leaf.around) <= 0.3 * len(leaf.own) + 1
        assert not np.isin(leaf.around, leaf.own).any()
        apart = np.abs(place[leaf.around][:, None] - place[leaf.own][None]).max(axis=2).min(axis=1)
        assert (apart <= 2).all()


def test_leaves_hang_together_where_the_images_do():
    """A ring road: a half that is cut by numbers alone would be two pieces."""
    n = 90
    rng = np.random.default_rng(2)
    name = rng.permutation(n)
    image, point = np.array([(name[k], p % n) for k in range(n) for p in range(k, k + 4)]).T
    image, point = np.repeat(image, 10), (10 * point[:, None] + np.arange(10)).ravel()
    for leaf in leaves_of(image, point, n, 10 * n, 25):
        along = np.sort(np.argsort(name)[leaf.own])
        gaps = np.diff(np.append(along, along[0] + n))
        assert (gaps > 1).sum() == 1  # one stretch of the road


def test_images_that_see_nothing_are_of_no_leaf():
    leaves = leaves_of(np.array([0, 2]), np.array([0, 0]), 4, 1, 10)
    assert [leaf.images.tolist() for leaf in leaves] == [[0, 2]]


def street(models=6, noise=0.002, seed=0):
    """A row of models of 12 images, each sharing three with the next, in systems of their own."""
    rng = np.random.default_rng(seed)
    n = 9 * models + 3
    centre = np.column_stack([np.arange(n) * 1.0, 0.2 * np.sin(np.arange(n)), np.zeros(n)])
    points = np.column_stack([rng.uniform(-2, n + 2, 40 * n), rng.uniform(-3, 3, 40 * n), rng.uniform(4, 6, 40 * n)])
    found, truth = [], []
    for k in range(models):
        images = np.arange(9 * k, 9 * k + 12)
        near = np.flatnonzero(np.abs(points[:, 0] - centre[images, 0].mean()) < 7)
        t = SimilarityTransform(
            scale=float(np.exp(rng.normal(0, 0.5))), rotation=rotation_from_vector(rng.normal(0, 1, 3)),
            translation=rng.normal(0, 10, 3),
        )  # fmt: skip
        truth.append(t)
        found.append(
            Model(
                images=images, centre=t.points(centre[images] + rng.normal(0, noise, (12, 3))), points=near,
                xyz=t.points(points[near] + rng.normal(0, noise, (len(near), 3))), depth=5 * t.scale,
            )
        )  # fmt: skip
    return found, centre, points, n


def worst(models, transforms, centre):
    """Largest error of a projection centre after one similarity of all, in units of the street."""
    here = np.concatenate([t.points(m.centre) for m, t in zip(models, transforms, strict=True) if t is not None])
    there = np.concatenate([centre[m.images] for m, t in zip(models, transforms, strict=True) if t is not None])
    return float(np.linalg.norm(similarity(here, there).points(here) - there, axis=1).max())


def test_models_fall_into_one_system():
    models, centre, _, _ = street()
    transforms = joined_models(models)
    assert all(t is not None for t in transforms)
    assert worst(models, transforms, centre) < 0.02


def test_wrong_points_have_no_say():
    models, centre, _, _ = street()
    rng = np.random.default_rng(1)
    for m in models:
        wrong = rng.random(len(m.xyz)) < 0.3
        m.xyz[wrong] += rng.normal(0, 2 * m.depth, (int(wrong.sum()), 3))
    assert worst(models, joined_models(models), centre) < 0.02


def test_a_closed_ring_spreads_what_a_chain_would_sum_up():
    """Around a circle: every model turns the next by a little too much, and the ring closes all the same."""
    rng = np.random.default_rng(4)
    n, models = 96, 8
    angle = 2 * np.pi * np.arange(n) / n
    centre = 10 * np.column_stack([np.cos(angle), np.sin(angle), 0 * angle])
    points = rng.normal(0, 1, (6000, 3)) * [8, 8, 1]
    points = points[np.hypot(points[:, 0], points[:, 1]) > 4]
    found = []
    for k in range(models):
        images = np.arange(12 * k, 12 * k + 16) % n
        order = np.sort(images)
        middle = centre[order].mean(axis=0)
        near = np.flatnonzero(np.linalg.norm(points - 0.8 * middle, axis=1) < 5)
        # a model bent by 2 %: its places stretch with the distance from its middle
        bend = lambda x: x + 0.02 * (x - middle) * np.linalg.norm(x - middle, axis=1, keepdims=True) / 10  # noqa: E731, B023
        found.append(Model(images=order, centre=bend(centre[order]), points=near, xyz=bend(points[near]), depth=8.0))
    transforms = joined_models(found)
    assert all(t is not None for t in transforms)
    assert worst(found, transforms, centre) < 0.3


def test_a_model_that_contradicts_the_others_stays_out():
    models, centre, _, _ = street()
    m = models[2]
    m.centre[:, 0] *= -1  # mirrored: no similarity brings it onto its neighbours
    m.xyz[:, 0] *= -1
    transforms = joined_models(models)
    assert transforms[2] is None
    assert [t is not None for t in transforms] == [False, False, False, True, True, True]
    assert worst(models, transforms, centre) < 0.02


def test_look_alikes_between_far_models_do_not_bend_the_ring():
    """A tie that many points agree on and that is wrong: the others outvote it."""
    models, centre, _, _ = street(models=7)
    a, b = models[0], models[6]
    k = 60
    first = a.points[:k]
    # what model 6 calls by these names stands where they would be if its street began anew
    shift = similarity(a.xyz[:k], a.xyz[:k]).points(a.xyz[:k]) / a.depth * b.depth
    models[6] = Model(
        images=b.images, centre=b.centre, points=np.concatenate([first, b.points]),
        xyz=np.concatenate([shift, b.xyz]), depth=b.depth,
    )  # fmt: skip
    transforms = joined_models(models)
    good = [t for t in transforms if t is not None]
    assert len(good) >= 6
    assert worst(models, transforms, centre) < 0.05


@pytest.mark.parametrize("count", [0, 1])
def test_few_models(count):
    models = street(models=2)[0][:count]
    transforms = joined_models(models)
    assert len(transforms) == count
    assert all(t is not None and t.is_identity for t in transforms)


def test_models_without_anything_in_common_are_not_joined():
    models = street(models=4)[0]
    transforms = joined_models([models[0], models[3]])
    assert sum(t is not None for t in transforms) == 1
