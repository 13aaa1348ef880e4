"""Tables and cameras made in Python are held to what readers ask of files."""

from dataclasses import replace

import numpy as np
import pytest

from raybundle import adjust
from raybundle.block import Distances
from raybundle.block.boards import BoardViews, board_block
from raybundle.planning.simulate import Survey, simulate
from raybundle.planning.synthetic_networks import TargetField, field_scene
from tests.messages import refused


@pytest.fixture(scope="module")
def block():
    return simulate(field_scene(TargetField(rows=3, columns=4, stations=3)), Survey(scale_bars=2)).observed


@pytest.mark.parametrize(
    ("change", "row", "column", "code"),
    [
        ({"sigma": [1e-4, 0.0]}, 2, "sigma", "cell.not_positive"),
        ({"sigma": [1e-4, -1.0]}, 2, "sigma", "cell.not_positive"),
        ({"sigma": [1e-4, np.nan]}, 2, "sigma", "cell.empty"),
        ({"length": [1.0, np.nan]}, 2, "length", "cell.empty"),
        ({}, 1, "to", "observation.same_point"),
    ],
)
def test_a_row_that_no_file_may_hold_is_refused(block, change, row, column, code):
    bars = block.distances
    fields = {k: np.array(v) for k, v in change.items()} or {"end": bars.start}
    with refused(code, file="distances.csv", line=row + 1, column=column):
        adjust(block.having(replace(bars, **fields)))


def test_a_block_without_rows_is_adjusted(block):
    assert adjust(block.having(Distances.empty())).redundancy > 0


def test_models_and_parameters_that_there_are_not_are_named(block):
    (camera,) = block.cameras
    with refused("camera.model_unknown", camera="1", model="opencv"):
        adjust(replace(block, cameras=(replace(camera, model="opencv"),)))
    with refused("camera.symbols_unknown", camera="1", names=["f"]):
        adjust(replace(block, cameras=(replace(camera, values={**camera.values, "f": 1.2}),)))


@pytest.mark.parametrize("name", ["window", "misfit", "relief", "sigma_curvature"])
def test_figures_of_matching_are_positive(block, name):
    figures = np.full(len(block.points), np.nan)
    for figures[3] in (-1e-3, 0.0):
        with refused("cell.not_positive", file="points.csv", line=5, column=name):
            adjust(replace(block, points=replace(block.points, **{name: figures})))


@pytest.mark.parametrize("spacing", [np.nan, 0.0, -0.02])
def test_a_board_has_a_spacing(block, spacing):
    k = np.arange(9)
    views = BoardViews(view=0 * k, row=k // 3, column=k % 3, xy_px=np.zeros((9, 2)), weight=np.ones(9), spacing=spacing)
    with refused("cell.not_positive", column="spacing"):
        board_block(views, block.cameras[0])
