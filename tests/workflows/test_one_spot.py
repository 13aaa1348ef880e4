"""Whether photographs have a base: the check says so for turns and copies, and for nothing else."""

from dataclasses import dataclass

import numpy as np
import pytest

from raybundle.io.photos.metadata import Metadata
from raybundle.io.photos.photo import Photo
from raybundle.matching.features import Features
from raybundle.matching.verify import VerifiedPair
from raybundle.ties.points import from_one_spot

WIDTH, HEIGHT, N = 1600, 1200, 400


@dataclass
class Store:
    xy: list

    def places(self, i):
        n = len(self.xy[i])
        return Features(xy_px=self.xy[i], scale_px=np.ones(n), angle=np.zeros(n), descriptors=np.zeros((n, 0)))


def photo(k, focal35):
    return Photo(
        path=None, name=f"{k}.jpg", width_px=WIDTH, height_px=HEIGHT, sha256=str(k),
        metadata=Metadata(focal35_mm=focal35),
    )  # fmt: skip


def seen(XYZ, centre, pan, c):
    """Pixels of object points from a camera that looks along +Z, turned about the vertical axis."""
    s, k = np.sin(pan), np.cos(pan)
    P = (XYZ - centre) @ np.array([[k, 0, -s], [0, 1, 0], [s, 0, k]]).T
    return c * P[:, :2] / P[:, 2:] + (WIDTH / 2, HEIGHT / 2)


def verdict(centres, pans, relief, c=1200.0, focal35=None, noise=0.4, wrong=0):
    rng = np.random.default_rng(3)
    XYZ = np.column_stack([rng.uniform(-4, 4, N), rng.uniform(-3, 3, N), 10 + relief * rng.uniform(-1, 1, N)])
    xy = [
        seen(XYZ, np.array(p, float), a, c) + rng.normal(0, noise, (N, 2)) for p, a in zip(centres, pans, strict=True)
    ]
    for a in xy[1:]:
        a[:wrong] += rng.uniform(-200, 200, (wrong, 2))
    matches = np.tile(np.arange(N)[:, None], 2)
    pairs = [
        VerifiedPair(
            first=i, second=j, matches=matches, candidates=N, geometry="planar", planar_share=1.0, displacement_px=50.0
        )
        for i in range(len(xy))
        for j in range(i + 1, len(xy))
    ]
    return from_one_spot(pairs, [photo(k, focal35) for k in range(len(xy))], Store(xy))


HERE = (0, 0, 0)


@pytest.mark.parametrize("focal35", [None, 25.96])  # the true one is 25.96 mm
@pytest.mark.parametrize("wrong", [0, 60])
def test_a_camera_that_only_turns_has_no_base(focal35, wrong):
    assert verdict([HERE] * 4, [0, 0.1, 0.2, 0.35], relief=3, focal35=focal35, wrong=wrong)


def test_a_copy_has_no_base():
    assert verdict([HERE] * 2, [0, 0], relief=3)


@pytest.mark.parametrize("relief", [0.0, 3.0])
@pytest.mark.parametrize("focal35", [None, 25.96])
def test_a_base_of_a_tenth_is_a_base_even_before_a_plane(relief, focal35):
    assert not verdict([HERE, (1, 0, 0), (2, 0, 0)], [0, 0, 0], relief, focal35=focal35)
    assert not verdict([HERE, (1, 0, 0), (2, 0, 0)], [0, -0.1, -0.2], relief, focal35=focal35)


def test_one_photograph_with_a_base_is_enough():
    assert not verdict([HERE, HERE, HERE, (1, 0, 0)], [0, 0.1, 0.2, 0], relief=2)
