"""A result, exported to any format that holds observations, comes back as a block that adjusts."""

import numpy as np
import pytest

import raybundle as rb
from raybundle.block import Observations, Points, Role
from raybundle.cli.main import main
from raybundle.commands.demonstrations import set_names
from raybundle.io.block.folder import read_block
from raybundle.io.formats import formats
from raybundle.workflows.sources import read_source, result_within, with_two_rays

IN_BLOCKS = ("bingo", "colmap", "colmap-text", "opensfm", "opf", "patb")
"""Formats that are written and read, with image observations."""
NOT_IN_BLOCKS = {"metashape", "nerfstudio"}
"""No image observations of tie points."""
SETS = {
    "board": ("calibrate", "photos", "--target", "chessboard-9x6", "--spacing", "25"),
    "flight": ("orient", "photos"),
    "part": ("measure", "before", "--target", "aicon14", "--scale-bar", "101", "102", "0.66", "0.000005"),
}
"""Demonstration sets of photographs, and what makes a result of them; `scene` is no block of photographs."""


def run(*words):
    assert main([str(w) for w in words]) == 0


@pytest.fixture(scope="module")
def demo(tmp_path_factory):
    folder = tmp_path_factory.mktemp("demo") / "demo"
    run("demo", "--out", folder, "--quiet")
    return folder


def round_trip(source, name, folder):
    """The block that comes back and its adjustment."""
    suffix = formats[name].suffix
    run("convert", source, "--to", name, "--out", folder / f"there{suffix}", "--approximate", "--free-scale")
    run("convert", folder / f"there{suffix}", "--from", name, "--to", "block", "--out", folder / "back",
        "--approximate")  # fmt: skip
    block = read_block(folder / "back")
    return block, rb.adjust(block)


def test_every_format_with_a_reader_and_a_writer_is_in_the_round_trips():
    assert {n for n, f in formats.items() if f.read and f.write} == {*IN_BLOCKS, *NOT_IN_BLOCKS}


@pytest.mark.parametrize("name", IN_BLOCKS)
def test_the_demonstration_result_comes_back_and_adjusts(name, demo, tmp_path):
    block, again = round_trip(demo / "result", name, tmp_path)
    given = read_source(demo / "result")[0].block
    assert len(block.observations) == len(given.observations)
    assert len(block.points) == len(given.points)
    rays = np.bincount(block.observations.point, minlength=len(block.points))
    assert rays.min() >= 2
    assert again.sigma0 < 0.2  # residuals of 0.1 px, stated 1 px


@pytest.mark.long
@pytest.mark.parametrize("made", SETS)
def test_results_of_the_photograph_sets_come_back_and_adjust(made, tmp_path):
    assert {*SETS, "scene"} == set(set_names())
    run("demo", "--set", made, "--out", tmp_path / made)
    command, photos, *options = SETS[made]
    run(command, tmp_path / made / photos, *options, "--out", tmp_path / "project")
    given = read_source(result_within(tmp_path / "project"))[0].block
    for name in IN_BLOCKS:
        folder = tmp_path / name
        folder.mkdir()
        block, again = round_trip(tmp_path / "project", name, folder)
        assert len(block.images) == int(given.images.oriented.sum()), name
        assert np.isfinite(again.sigma0), name


def thinned(block, keep):
    """The block with these rows of its observations; all of its points stay."""
    o = block.observations
    return rb.Block(
        cameras=block.cameras,
        images=block.images,
        points=block.points,
        observations=Observations(
            image=o.image[keep], point=o.point[keep], xy_px=o.xy_px[keep], cov_px2=o.cov_px2[keep]
        ),
    )


@pytest.mark.parametrize("rays", [0, 1])
@pytest.mark.parametrize("role", [Role.TIE, Role.CONTROL, Role.CHECK])
@pytest.mark.parametrize("count", [1, 3])
def test_tie_points_with_fewer_than_two_rays_leave_a_foreign_block(rays, role, count, demo):
    block = read_block(demo / "block")
    named = block.points_named
    thin = np.flatnonzero(~named)[:count]
    o = block.observations
    keep = np.ones(len(o), bool)
    for p in thin:
        keep[np.flatnonzero(o.point == p)[rays:]] = False
    block = thinned(block, keep)
    roles = np.asarray(block.points.role).copy()
    roles[thin] = role
    points = Points(ids=block.points.ids, role=roles, xyz=block.points.xyz, sigma=block.points.sigma)
    found, remarks = with_two_rays(rb.Block(cameras=block.cameras, images=block.images, points=points,
                                            observations=block.observations))  # fmt: skip
    lost = {block.points.ids[p] for p in thin} if role == Role.TIE else set()
    assert set(block.points.ids) - set(found.points.ids) == lost
    assert bool(remarks) == bool(lost)
