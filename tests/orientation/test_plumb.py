"""The vertical by plumb edges: true standard deviations, taken where edges meet, left where they do not."""

import os
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from raybundle.io.block.folder import read_block
from raybundle.io.photos.photo import read_photo
from raybundle.numerics.rotation import rotation_from_vector
from raybundle.orientation.plumb import LEAN, plumb_vertical
from raybundle.placing.plumb_lines import vertical_by_edges
from raybundle.placing.upright import doubts, upright

PORTAL = Path(__file__).resolve().parents[2] / "demo_data" / "portal"
VIEWS = 8
MEASURED = np.radians(0.1)


def edges(rng, plumb, clutter):
    """Normals of planes, their standard deviations and photographs; each plumb edge is seen in all photographs."""
    lean = rng.normal(0, LEAN, (plumb, 2))
    normals, image = [], []
    for view in range(VIEWS):
        a = rng.uniform(0, np.pi, plumb)
        tilt = lean[:, 0] * np.cos(a) + lean[:, 1] * np.sin(a) + rng.normal(0, MEASURED, plumb)
        upright_ = np.stack([np.cos(a), np.sin(a), tilt], axis=1)
        other = rng.normal(size=(clutter, 3))
        both = np.concatenate([upright_, other])
        normals.append(both / np.linalg.norm(both, axis=1, keepdims=True))
        image.append(np.full(len(both), view))
    n = np.concatenate(normals)
    return n, np.full(len(n), MEASURED), np.concatenate(image)


def prior(rng, sigma):
    z = np.array([*rng.normal(0, sigma, 2), 1.0])
    return z / np.linalg.norm(z)


def test_the_stated_sigma_is_true():
    rng = np.random.default_rng(1)
    ratio, sizes = [], []
    for _ in range(60):
        turn = rotation_from_vector(rng.normal(size=(1, 3)))[0]
        n, s, image = edges(rng, 25, 200)
        sigma = np.radians(2)
        found = plumb_vertical(n @ turn.T, s, image, turn @ prior(rng, sigma), sigma)
        assert found is not None
        off = np.linalg.norm(np.cross(found.up, turn[:, 2]))
        ratio.append(off / found.sigma / np.sqrt(2))
        sizes.append(found.sigma)
    assert 0.6 < np.sqrt(np.mean(np.square(ratio))) < 1.3
    assert np.degrees(np.median(sizes)) < 0.1


def test_edges_at_random_are_no_plumb_ones():
    rng = np.random.default_rng(2)
    for clutter in (50, 400):
        for _ in range(30):
            n, s, image = edges(rng, 0, clutter)
            assert plumb_vertical(n, s, image, prior(rng, 0.03), np.radians(2)) is None


@pytest.fixture(scope="module")
def portal():
    """A rendered facade and its truth."""
    block = read_block(PORTAL / "truth")
    names = [f or i for f, i in zip(block.images.file, block.images.ids, strict=True)]
    return block, [read_photo(PORTAL / "photos" / name, name=name) for name in names]


@pytest.mark.long
@pytest.mark.skipif(not PORTAL.is_dir(), reason="demo_data/portal is absent")
def test_a_rendered_facade_stands_upright(portal):
    block, photos = portal
    for tilt in ([0.02, 0.01], [-0.025, 0.0], [0.0, -0.02]):
        z = np.array([*tilt, 1.0]) / np.linalg.norm([*tilt, 1.0])
        found = vertical_by_edges(block, photos, z, np.radians(1.5))
        off = np.degrees(np.linalg.norm(found.up[:2]))
        assert off < 0.4
        assert np.radians(off) < 3 * found.sigma
        assert found.sigma < np.radians(0.5)


@pytest.mark.skipif(not PORTAL.is_dir(), reason="demo_data/portal is absent")
def test_the_vertical_of_a_block_is_told_with_its_edges(portal):
    block, photos = portal
    found = upright(block, photos, "terrestrial")
    assert found.edges is not None
    assert found.as_mapping()["plumb_edges"] == found.edges.edges
    assert [n.code for n in doubts(found, "auto")] == ["up_by_edges"]
    assert np.degrees(np.arccos(np.clip(found.rotation[2, 2], -1, 1))) < 0.4
    without = replace(found, edges=None, sigma=np.radians(1.0))
    assert [n.code for n in doubts(without, "auto")] == ["up_without_edges"]


@pytest.mark.data
def test_a_flight_does_not_take_edges():
    data = Path(os.environ.get("RAYBUNDLE_DATA", PORTAL.parents[2] / "shared" / "data")) / "photos" / "copr-uav"
    if not data.is_dir():
        pytest.skip(f"{data} is absent")
    block, photo = read_block(PORTAL / "truth"), read_photo(min((data / "images").iterdir()), name="a")
    found = upright(block, [photo], "aerial")
    assert found.kind == "aerial"
    assert found.edges is None
    assert not found.sought
