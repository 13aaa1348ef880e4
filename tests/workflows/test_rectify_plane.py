"""What stands before the plane: photographs that look past it are preferred, and where none does it is said."""

from dataclasses import replace
from types import SimpleNamespace

import numpy as np
import pytest

from raybundle.cli.rectify import _of_photo
from raybundle.errors import InputError
from raybundle.numerics.progress import silent
from raybundle.planning.simulate import Survey, simulate
from raybundle.planning.synthetic_networks import TargetField, brown_camera, field_scene
from raybundle.workflows.rectify import BEFORE, _best_views, _hidden, fit_photo, grid_over
from tests.messages import coded

RNG = np.random.default_rng(1)


@pytest.fixture(scope="module")
def view():
    """Five stations in a row above a level wall, and a tree of 1.2 m over its middle."""
    wall = np.column_stack([RNG.uniform(-2, 2, (900, 2)), RNG.normal(0, 0.01, 900)])
    tree = np.column_stack([RNG.uniform(-0.2, 0.2, (150, 2)), RNG.uniform(1.1, 1.2, 150)])
    shadow = np.abs(wall[:, :2]).max(axis=1) > 0.2
    scene = field_scene(TargetField(stations=8, frontal=0, camera=brown_camera(estimate=())))
    centre = np.column_stack([np.linspace(-1.4, 1.4, 5), np.zeros(5), np.full(5, 4.0)])
    scene = replace(
        scene, xyz=np.concatenate([wall[shadow], tree]), centre=centre, rotation=np.tile(np.eye(3), (5, 1, 1)),
        normal=None,
    )  # fmt: skip
    exact = Survey(orientation="exact", points="exact", interior="exact", image_sigma_px=0.1)
    block = simulate(scene, exact).observed
    plane = SimpleNamespace(origin=np.zeros(3), axes=np.eye(3))
    return block, plane


def views(block, plane, images):
    grid = grid_over(np.array([-1.0, -0.8, 1.0, 0.8]), 0.01)
    places, shape = grid.coarse()
    xyz = np.column_stack([places, np.zeros(len(places))])
    _, choice, before = _best_views(block, images, plane, xyz, shape, silent)
    return places, choice, before


def test_a_photograph_that_looks_past_is_preferred(view):
    places, choice, before = views(*view, range(5))
    behind = np.abs(places).max(axis=1) < 0.15
    assert (choice[behind] != 2).all()  # the one straight above shows the tree
    assert before[behind].max() < BEFORE
    beside = np.abs(places[:, 0]) > 0.8
    assert set(choice[beside & (places[:, 0] > 0)].tolist()) <= {3, 4}
    assert _hidden(before) == []


def test_where_none_looks_past_it_is_said(view):
    _, choice, before = views(*view, [2])
    assert (choice == 2).any()
    hidden = coded(_hidden(before[choice >= 0]))["picture.before_plane"]
    assert hidden["distance_share"] == 2 * BEFORE
    assert 0 < hidden["share"] < 1
    assert before.mean() > 0.02


SQUARE = np.array([[0, 0, 0], [4, 0, 0], [4, 3, 0], [0, 3, 0], [2, 1.5, 0]], float)


def pixels(xy, sign=1.0):
    """Where a photograph shows places of a plane, seen a little from the side."""
    w = 1 + 0.05 * xy[:, 0]
    return np.column_stack([500 + sign * 100 * xy[:, 0] / w, 400 - 100 * xy[:, 1] / w])


@pytest.mark.parametrize(("sign", "mirrored"), [(1.0, False), (-1.0, True)])
def test_a_picture_from_behind_is_told(sign, mirrored):
    single = fit_photo(list("abcde"), SQUARE, pixels(SQUARE, sign), model="projective", sigma_px=0.5, camera=None)
    assert single.mirrored == mirrored
    assert ("picture.mirrored" in [n.code for n in _of_photo(single, 0.5).notices]) == mirrored


@pytest.mark.parametrize("off", [0.0, 2.0])
def test_control_on_a_line_is_refused_with_the_reason(off):
    line = np.column_stack([np.arange(5.0), 0.5 * np.arange(5.0), np.zeros(5)])
    line[3, 1] += off
    with pytest.raises(InputError, match=r"picture\.control_on_line"):
        fit_photo(list("abcde"), line, pixels(line), model="projective", sigma_px=0.5, camera=None)


def test_a_wrong_mark_of_a_wall_is_told_in_words_of_walls():
    xy = pixels(SQUARE)
    xy[4] += 30
    single = fit_photo(list("abcde"), SQUARE, xy, model="projective", sigma_px=0.5, camera=None)
    (found,) = _of_photo(single, 0.5).notices
    assert found.code == "picture.residuals"
