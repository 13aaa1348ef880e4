"""An empty id, or one that stands twice, is refused before anything is written."""

from dataclasses import replace

import numpy as np
import pytest
from tests.io.formats.test_foreign_formats import BOTH, exported, make_block, needs

from raybundle import adjust
from raybundle.errors import InputError
from raybundle.io.block.folder import write_block
from raybundle.io.formats import formats, write_format
from raybundle.io.trajectories import trajectory_formats, write_trajectory
from raybundle.io.trajectories.base import Trajectory
from raybundle.results.folder import written_folder


def with_id(block, what, position, name):
    """The block in which one image, point or camera has another id."""
    if what == "camera":
        cameras = list(block.cameras)
        cameras[position] = replace(cameras[position], id=name)
        return replace(block, cameras=tuple(cameras))
    table = getattr(block, f"{what}s")
    ids = list(table.ids)
    ids[position] = name
    return replace(block, **{f"{what}s": replace(table, ids=tuple(ids))})


@pytest.fixture(scope="module")
def block():
    return make_block()


PLACES = [("image", 0), ("image", 2), ("image", -1), ("point", 0), ("point", 7), ("point", -1), ("camera", 0)]
TWICE = [("image", 1), ("image", -1), ("point", 1), ("point", -1)]
WRITERS = ["block", *BOTH]


def write(block, name, folder):
    if name == "block":
        write_block(block, folder / "out")
    else:
        needs(name)
        write_format(name, exported(block), folder / f"out{formats[name].suffix}")


@pytest.mark.parametrize("name", WRITERS)
@pytest.mark.parametrize(("what", "position"), PLACES)
def test_an_empty_id_is_not_written(block, what, position, name, tmp_path):
    with pytest.raises(InputError, match=r"id\.empty"):
        write(with_id(block, what, position, ""), name, tmp_path)
    assert [*tmp_path.iterdir()] == []


@pytest.mark.parametrize("name", WRITERS)
@pytest.mark.parametrize(("what", "position"), TWICE)
def test_an_id_that_stands_twice_is_not_written(block, what, position, name, tmp_path):
    first = getattr(block, f"{what}s").ids[0]
    with pytest.raises(InputError, match=r"1.*id\.twice"):
        write(with_id(block, what, position, first), name, tmp_path)
    assert [*tmp_path.iterdir()] == []


def test_nor_in_a_result(block, tmp_path):
    with (
        pytest.raises(InputError, match=r"1.*5.*id\.empty"),
        written_folder(adjust(with_id(block, "image", 0, "")), tmp_path / "r"),
    ):
        pass
    assert [*tmp_path.iterdir()] == []


@pytest.mark.parametrize("name", sorted(n for n, f in trajectory_formats.items() if f.write))
@pytest.mark.parametrize("names", [("", "b"), ("a", ""), ("a", "a")])
def test_nor_as_positions(names, name, tmp_path):
    given = Trajectory(
        path=tmp_path, names=names, xyz=np.zeros((2, 3)), sigma=np.ones((2, 3)), crs="EPSG:32633",
        rotation=np.tile(np.eye(3), (2, 1, 1)), rotation_sigma=np.ones((2, 3)), convention="opk",
        angles=np.zeros((2, 3)),
    )  # fmt: skip
    with pytest.raises(InputError, match=r"id\.empty|id\.twice"):
        write_trajectory(given, tmp_path / "t.csv", name=name)
    assert [*tmp_path.iterdir()] == []
