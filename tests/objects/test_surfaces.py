"""Surfaces, what is seen of them, and how far places are from them."""

import numpy as np
import pytest
import trimesh

from raybundle.errors import InputError
from raybundle.objects.distance import Distances
from raybundle.objects.kinds import object_kinds
from raybundle.objects.sight import Sight
from raybundle.objects.surface import Surface, spread


def ball(shift=(0.0, 0.0, 0.0)):
    m = trimesh.creation.icosphere(subdivisions=4)
    return Surface(name="ball", vertices=np.array(m.vertices) + shift, triangles=np.array(m.faces))


@pytest.mark.parametrize("kind", object_kinds.values(), ids=lambda k: k.name)
class TestKinds:
    def test_normals_point_outwards(self, kind):
        s = kind.surface(kind.example)
        middle = s.vertices[s.triangles].mean(axis=1)
        away = np.sum((middle - s.vertices.mean(axis=0)) * s.normals, axis=1)
        assert away.min() >= 0
        if kind.side == "front":
            assert np.allclose(s.normals, [0, -1, 0])
        if kind.side == "above":
            assert np.allclose(s.normals, [0, 0, 1])
        if kind.side == "round":
            assert s.open_edges == 0

    def test_it_is_as_large_as_asked_for(self, kind):
        s = kind.surface(kind.example)
        assert np.sort(np.ptp(s.vertices, axis=0))[::-1][: len(kind.example)] == pytest.approx(
            np.sort([*kind.example, kind.example[0]] if kind.name == "cylinder" else kind.example)[::-1][
                : len(kind.example)
            ]
        )

    @pytest.mark.parametrize("wrong", [(), (1.0, 2.0, 3.0, 4.0), None])
    def test_numbers_that_are_none_of_it_are_refused(self, kind, wrong):
        given = wrong if wrong is not None else (*kind.example[:-1], -1.0)
        with pytest.raises(InputError, match=kind.name):
            kind.surface(given)

    def test_points_are_spread_over_all_of_it(self, kind):
        s = kind.surface(kind.example)
        p = spread(s, 60)
        far = np.linalg.norm(p.xyz[:, None] - p.xyz[None], axis=2) + 1e9 * np.eye(60)
        assert far.min() > 0.5 * np.sqrt(s.wanted_area / 60)
        assert Distances(s).of(p.xyz).max() < 1e-9 * s.extent
        assert np.array_equal(p.xyz, spread(s, 60).xyz)


def test_an_outline_is_filled_whatever_its_direction():
    house = np.array([[0, 0], [6, 0], [6, 4], [3, 7], [0, 4.0]])
    for outline in (house, house[::-1]):
        s = object_kinds["facade"].surface((), outline)
        assert s.wanted_area == pytest.approx(33)
        assert np.allclose(s.normals, [0, -1, 0])
    with pytest.raises(InputError, match=r"outline\.crosses_itself"):
        object_kinds["facade"].surface((), np.array([[0, 0], [4, 4], [4, 0], [0, 4.0]]))


@pytest.mark.parametrize("embree", [True, False], ids=["embree", "pure"])
def test_half_a_ball_is_seen_far_from_the_origin(embree):
    s = ball((5e5, 5e6, 100.0))
    p = spread(s, 200)
    sight = Sight(s, embree=embree)
    centre = np.array([5e5 + 4, 5e6 + 1, 102.0])
    seen = sight.visible(centre, p.xyz, p.normal)
    to = centre - p.xyz
    assert np.array_equal(seen, np.sum(to * p.normal, axis=1) > 0)  # a ball hides nothing that faces the station
    assert sight.inside(np.array([[5e5, 5e6, 100.0], [5e5 + 2, 5e6, 100.0]])).tolist() == [True, False]


@pytest.mark.parametrize("embree", [True, False], ids=["embree", "pure"])
def test_what_stands_between_hides_and_what_stands_behind_does_not(embree):
    wall = trimesh.creation.box(bounds=[[-1, 0, 0], [1, 0.1, 2]])
    screen = trimesh.creation.box(bounds=[[-0.2, -2.1, 0], [0.2, -2.0, 2]])
    both = trimesh.util.concatenate([wall, screen])
    s = Surface(name="x", vertices=np.array(both.vertices), triangles=np.array(both.faces))
    at = np.array([[0.0, 0.0, 1.0], [0.9, 0.0, 1.0]])
    normal = np.tile([0.0, -1.0, 0.0], (2, 1))
    sight = Sight(s, embree=embree)
    assert sight.visible(np.array([0.0, -4.0, 1.0]), at, normal).tolist() == [False, True]
    assert sight.visible(np.array([0.0, -1.0, 1.0]), at, normal).tolist() == [True, True]
    assert sight.visible(np.array([0.0, 1.0, 1.0]), at, normal).tolist() == [False, False]
    # a ray that misses the edge of the screen by 5 mm of 4 m
    edge = np.array([0.41, -4.0, 1.0])
    assert sight.visible(edge, at[:1], normal[:1]).tolist() == [True]
    assert sight.visible(edge, at[:1], normal[:1], beside=0.01).tolist() == [False]


def test_distances_are_those_of_trimesh():
    for mesh in (trimesh.creation.box(extents=(4, 3, 2)), trimesh.creation.icosphere(subdivisions=3)):
        s = Surface(name="x", vertices=np.array(mesh.vertices), triangles=np.array(mesh.faces))
        places = np.random.default_rng(1).uniform(-4, 4, (100, 3))
        assert np.abs(Distances(s).of(places) - trimesh.proximity.closest_point(mesh, places)[1]).max() < 1e-12


def test_surfaces_that_are_none_are_refused():
    flat = np.array([[0, 0, 0], [1, 0, 0], [2, 0, 0.0]])
    with pytest.raises(InputError, match=r"mesh\.no_area"):
        Surface(name="x", vertices=flat, triangles=np.array([[0, 1, 2]]))
    with pytest.raises(InputError, match=r"7.*3.*mesh\.unknown_vertex"):
        Surface(name="x", vertices=flat, triangles=np.array([[0, 1, 6]]))
    with pytest.raises(InputError, match=r"2.*mesh\.vertex_not_finite"):
        Surface(name="x", vertices=np.array([[0, 0, 0], [np.nan, 0, 0], [0, 1, 0]]), triangles=np.array([[0, 1, 2]]))
