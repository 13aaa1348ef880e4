"""Pages of scenes, panoramas and trajectories: there where they belong, and what they say follows the data."""

import functools
import re
from dataclasses import replace

import numpy as np
import pytest

from raybundle import adjust
from raybundle.adjustment.engine import adjust_block
from raybundle.report.document import write_report
from raybundle.report.figures_series import running
from raybundle.report.section_panoramas import panorama_section
from raybundle.report.section_scenes import scene_section
from raybundle.report.section_trajectories import trajectory_section
from raybundle.report.view import view_of
from tests.adjustment.test_antennas import SHIFT, flight
from tests.adjustment.test_moving_sensors import SIGMA, rolling
from tests.report.conftest import free
from tests.truth.mixed_blocks import MonteCarlo, ikonos_pair, room

SECTIONS = (scene_section, panorama_section, trajectory_section)


def noisy(block, seed=5):
    return MonteCarlo.of(block).noisy(np.random.default_rng(seed))


def words(parts):
    """All text of some parts."""
    found = []
    for p in parts:
        if p.kind == "paragraph":
            found.append(p.text)
        elif p.kind == "statements":
            found += [" ".join(s) for s in p.statements]
        elif p.kind == "table":
            found += [p.caption, p.note, *(" ".join(r) for r in p.rows)]
        elif p.kind == "figures":
            found += [f.caption for f in p.figures]
        elif p.kind == "folded":
            found.append(words(p.parts))
    return " ".join(found)


def drawings(section):
    parts = list(section.parts)
    for p in parts:
        if p.kind == "folded":
            parts += p.parts
    return [f.drawing.svg for p in parts if p.kind == "figures" for f in p.figures]


@functools.cache
def scenes(bias="shift", wave=0.0, rigorous=()):
    block = noisy(ikonos_pair(bias, rigorous, points=300, check=8))
    if wave:
        xy = block.observations.xy_px.copy()
        mine = block.observations.image == 0
        xy[mine, 0] += wave * np.sin(xy[mine, 1] / 150)
        block = replace(block, observations=replace(block.observations, xy_px=xy))
    return adjust(block)


def test_blocks_of_photographs_have_none_of_these_pages():
    view = view_of(free())
    assert [make(view) for make in SECTIONS] == [None, None, None]


def test_a_page_of_scenes():
    result = scenes("drift")
    section = scene_section(view_of(result))
    (table,) = (p for p in section.parts if p.kind == "table")
    assert len(table.rows) == 8
    shown = {(r[3].split()[0], k // 4): r[4] for k, r in enumerate(table.rows)}
    p = result.interior[0].parameters["A0"]
    assert float(shown["A0", 0].replace("\N{MINUS SIGN}", "-")) == pytest.approx(p.value, abs=p.std)
    assert "no jitter is seen" in words(section.parts)
    assert "it changes over the scene" in words(section.parts)
    assert len(drawings(section)) == 8


def test_a_wave_along_the_track_is_noticed():
    assert "The mean residual changes with the line: 1 in x by up to" in words(
        scene_section(view_of(scenes(wave=1.0))).parts
    )


def test_a_rigorous_scene_is_compared_with_its_rpc():
    told = words(scene_section(view_of(scenes(rigorous=("forward",)))).parts)
    assert "as smooth as an RPC" in told
    assert "orbit and attitude" in told


def test_a_page_of_panoramas():
    result = adjust_block(noisy(room()))
    section = panorama_section(view_of(result))
    told = words(section.parts)
    assert re.search(r"stands beside the axis of rotation: (9\.9|10\.0)\d* ± 0\.\d+ mm along the view, ", told)
    assert "No mean residual changes with direction or elevation" in told
    assert len(drawings(section)) == 5


def test_a_page_of_positions():
    result = adjust_block(noisy(flight(SHIFT)))
    section = trajectory_section(view_of(result))
    tables = [p for p in section.parts if p.kind == "table"]
    assert [r[0] for r in tables[0].rows] == ["east", "north", "height"]
    assert {r[0] for r in tables[1].rows} == {"line1", "line2", "line3"}
    assert {r[1] for r in tables[1].rows} >= {"sx", "sy", "sz", "ax"}
    assert len(drawings(section)) == 9


def test_attitudes_have_their_place():
    attitudes = pytest.importorskip("tests.adjustment.test_attitudes")
    result = adjust_block(noisy(attitudes.flight()))
    section = trajectory_section(view_of(result))
    (first, *_) = (p for p in section.parts if p.kind == "table")
    assert [r[0] for r in first.rows] == ["east", "north", "height", "omega", "phi", "kappa"]
    assert len(drawings(section)) == 6


def test_motion_of_single_images():
    section = trajectory_section(view_of(adjust_block(noisy(rolling(sigma=SIGMA)))))
    assert len(drawings(section)) == 2
    assert "Velocity during read-out" in words(section.parts)


def test_every_page_is_written(tmp_path):
    for k, result in enumerate((scenes(), adjust_block(noisy(room())), adjust_block(noisy(flight(SHIFT))))):
        write_report(result, tmp_path / f"{k}.html")
        text = (tmp_path / f"{k}.html").read_text()
        assert f'id="{("scenes", "panoramas", "trajectories")[k]}"' in text
        assert "nan" not in re.sub(r"<[^>]*>|nanometre", "", text).lower().split()


def test_running_means_weigh_and_are_tested():
    rng = np.random.default_rng(1)
    at = rng.uniform(0, 100, 3000)
    sigma = rng.choice([0.1, 5.0], 3000)
    v = rng.normal(0, 1, 3000) * sigma
    plain = running(at, v, 0, 100)
    weighed = running(at, v, 0, 100, sigma=sigma)
    assert np.nanmedian(weighed.std) < np.nanmedian(plain.std) / 10
    assert weighed.probability > 1e-3
    assert running(at, v + 0.03 * np.sin(at / 5), 0, 100, sigma=sigma).probability < 1e-3
    assert np.isnan(running(at[:5], v[:5], 0, 100).mean).all()
