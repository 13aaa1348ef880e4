"""Views of the network: images look at the object, ellipses lie as their covariances say."""

import re
from dataclasses import replace

import numpy as np
import pytest

from raybundle.report.figures.network import network_views
from raybundle.report.view import view_of


def panels(adjustment):
    """The drawn groups of the three views: plan, side, front."""
    return re.findall(
        r'<g clip-path="url\(#panel\d\d\)">(.*?)</g>', str(network_views(view_of(adjustment)).drawing.svg)
    )


def test_images_look_at_the_object(case):
    drawn = panels(case("free"))
    assert len(drawn) == 3
    for panel in drawn[1:]:
        dots = re.search(r'class="points"[^>]* d="([^"]+)"', panel).group(1)
        middle = np.array(re.findall(r"M(-?\d+) (-?\d+)h0", dots), float).mean(axis=0) / 10
        frames = [
            np.array(re.findall(r"(-?[\d.]+) (-?[\d.]+)", d), float) for d in re.findall(r'"camera" d="([^"]+)"', panel)
        ]
        assert frames
        for p in frames:
            base, apex = p[:4].mean(axis=0), p[5]
            assert (base - apex) @ (middle - apex) > 0


@pytest.mark.parametrize("degrees", [30.0, 120.0])
def test_ellipses_lie_as_their_covariances_say(case, degrees):
    a = case("free")
    along = np.array([np.cos(np.radians(degrees)), np.sin(np.radians(degrees)), 0.0])
    C = 1e-8 * np.eye(3) + 9e-8 * np.outer(along, along)
    precision = replace(a.precision, object_points=np.broadcast_to(C, a.precision.object_points.shape))
    found = re.findall(
        r'rx="([\d.]+)" ry="([\d.]+)" transform="[^"]*rotate\((-?\d+)\)"', panels(replace(a, precision=precision))[0]
    )
    assert found
    major, minor, turn = np.array(found, float).T
    assert (turn + degrees) % 180 == pytest.approx(0.0)
    assert major / minor == pytest.approx(np.sqrt(10), rel=0.05)
