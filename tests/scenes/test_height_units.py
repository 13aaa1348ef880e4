"""Heights of control in feet and other units, on level ground and on relief; right heights of every kind."""

from dataclasses import replace

import numpy as np
import pytest

from raybundle.cli.main import main
from raybundle.io.scenes.rpc_text import write_rpc_text
from raybundle.scenes.bias_choice import choose_bias, point_covariance
from raybundle.scenes.height_units import height_unit

STATED_M = 5.0


def points(rpc, count, relief, rng, bias=1.0, height=400.0):
    """Ground points, and where they are measured with a bias of so many times the stated one, and noise."""
    ground = rpc.ground_offset + rpc.ground_scale * rng.uniform(-0.7, 0.7, (count, 3))
    ground[:, 2] = height + rng.uniform(-0.5, 0.5, count) * relief
    prior = replace(rpc, err_bias_m=STATED_M).bias_sigma_px()
    return ground, rpc.project(ground) + rng.normal(0, bias, 2) * prior + rng.normal(0, 0.4, (count, 2))


def unit(rpc, ground, xy, heights=None):
    heights = ground[:, 2] if heights is None else heights
    fit = choose_bias(rpc, ground, xy, sigma_px=0.5).advised
    found = height_unit(rpc, ground, heights, xy, point_covariance(rpc, ground, 0.5, None)[0], fit)
    return None if found is None else found.name


@pytest.mark.parametrize("count", [5, 12])
def test_feet_over_relief_are_found_by_the_residuals(rpc, count):
    rng = np.random.default_rng(count)
    named = [unit(rpc, g / [1, 1, 0.3048], xy) for g, xy in (points(rpc, count, 100, rng, bias=2.0) for _ in range(20))]
    assert named.count("feet") >= 17


@pytest.mark.parametrize("count", [2, 3, 12])
def test_feet_over_level_ground_are_found_by_the_bias_that_the_vendor_states(rpc, count):
    rng, stated = np.random.default_rng(count), replace(rpc, err_bias_m=STATED_M)
    named = [
        unit(stated, g / [1, 1, 0.3048], xy) for g, xy in (points(rpc, count, 0, rng, bias=0.3) for _ in range(20))
    ]
    assert named.count("feet") >= 18


def test_heights_above_the_sea_are_mended_above_the_sea(rpc):
    """The geoid is 30 m below the ellipsoid: the height in the file is what was taken in the wrong unit."""
    ground, xy = points(rpc, 8, 100, np.random.default_rng(1))
    above = ground[:, 2] + 30
    wrong = ground.copy()
    wrong[:, 2] = above / 0.3048 - 30
    assert unit(rpc, wrong, xy, above / 0.3048) == "feet"


@pytest.mark.parametrize("stated", [STATED_M, None])
@pytest.mark.parametrize("relief", [0, 5, 200])
def test_right_heights_have_no_other_unit(rpc, stated, relief):
    """Biases to six times what the vendor states."""
    rng, own = np.random.default_rng(relief), replace(rpc, err_bias_m=stated)
    cases = [
        points(rpc, n, relief, rng, bias, height) for n in (1, 3, 10) for bias in (1, 6) for height in (15, 300, 700)
        for _ in range(3)
    ]  # fmt: skip
    assert [unit(own, g, xy) for g, xy in cases] == [None] * len(cases)


@pytest.mark.parametrize("wrong", [False, True])
def test_the_command_refuses_and_names_the_unit(rpc, tmp_path, capsys, wrong):
    write_rpc_text(rpc, tmp_path / "scene_RPC.TXT")
    ground, xy = points(rpc, 8, 40, np.random.default_rng(4))
    ground = ground / [1, 1, 0.3048 if wrong else 1]
    table = tmp_path / "control.csv"
    lines = [
        ",".join([f"P{k}", *(repr(float(v)) for v in (*g, *p))])
        for k, (g, p) in enumerate(zip(ground, xy, strict=True))
    ]
    table.write_text("\n".join(["point,lon_deg,lat_deg,h_m,x_px,y_px", *lines]) + "\n")
    words = ["rpc", "correct", str(tmp_path / "scene_RPC.TXT"), str(table)]
    assert main(words) == (3 if wrong else 0)
    assert ("[scene_control.height_unit]" in capsys.readouterr().err) is wrong
