"""Pages of scenes, panoramas and trajectories: there where they belong, and what they say follows the data."""

import functools
import re
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from raybundle import adjust
from raybundle.adjustment.engine import adjust_block
from raybundle.errors import Text, phrase
from raybundle.report.figures.corrections import correction_figures
from raybundle.report.figures.series import running
from raybundle.report.sections.control import control_section
from raybundle.report.sections.interior import interior_section
from raybundle.report.sections.panoramas import panorama_section
from raybundle.report.sections.result import result_section
from raybundle.report.sections.scenes import scene_section, strip_section
from raybundle.report.sections.trajectories import trajectory_section
from raybundle.report.text.summary import details
from raybundle.report.text.words import verdict
from raybundle.report.view import view_of
from raybundle.report.writing import write_report
from tests.adjustment.test_antennas import SHIFT, flight
from tests.adjustment.test_moving_sensors import SIGMA, rolling
from tests.report.conftest import free
from tests.truth.mixed_blocks import MonteCarlo, ikonos_pair, room

SECTIONS = (scene_section, strip_section, panorama_section, trajectory_section)


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


def messages(parts):
    """Values of the messages of some parts, by their codes."""
    found = {}

    def add(*texts):
        for t in texts:
            for m in t.messages if isinstance(t, Text) else ():
                found.setdefault(m.code, []).append(m.values)

    for p in flat(parts):
        match p.kind:
            case "paragraph" | "heading":
                add(p.text)
            case "statements":
                add(*(t for pair in p.statements for t in pair))
            case "table":
                add(p.caption, p.note, *(c for row in p.rows for c in row))
            case "figures":
                add(*(f.caption for f in p.figures))
    return found


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
    assert [make(view) for make in SECTIONS] == [None] * 4


def test_a_page_of_scenes():
    result = scenes("drift")
    section = scene_section(view_of(result))
    (table,) = (p for p in section.parts if p.kind == "table")
    assert len(table.rows) == 8
    shown = {(r[3].split()[0], k // 4): r[4] for k, r in enumerate(table.rows)}
    p = result.interior[0].parameters["A0"]
    assert float(shown["A0", 0].replace("\N{MINUS SIGN}", "-")) == pytest.approx(p.value, abs=p.std)
    told = messages(section.parts)
    assert "report_scenes.no_trend" in told
    assert not any(m["constant"] for m in told["report_scenes.bias_map"])
    assert len(drawings(section)) == 8


def test_a_wave_along_the_track_is_noticed():
    told = messages(scene_section(view_of(scenes(wave=1.0))).parts)
    wave = told["report_scenes.wave"][0]
    assert (wave["name"], wave["axis"]) == ("1", "x")
    assert 0.3 < wave["size_px"] < 3
    assert "report_scenes.no_trend" not in told


def test_a_rigorous_scene_is_compared_with_its_rpc():
    told = messages(scene_section(view_of(scenes(rigorous=("forward",)))).parts)
    assert "report_scenes.no_jitter" in told
    assert {"strip": False} in told["report_scenes.model"]


def test_a_page_of_panoramas():
    result = adjust_block(noisy(room()))
    section = panorama_section(view_of(result))
    told = messages(section.parts)
    along = next(m for m in told["report_panoramas.offset"] if m["symbol"] == "e")
    assert (along["value"], along["unit"]) == (pytest.approx(10.0, abs=0.1), "mm")
    assert 0 < along["sigma"] < 1
    assert "report_panoramas.no_trend" in told
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
    assert "velocity" in {m["kind"] for m in messages(section.parts)["report_trajectories.motion"]}


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


@functools.cache
def flown():
    from tempfile import TemporaryDirectory

    from raybundle.scenes.corrections import Fixes
    from raybundle.scenes.trajectory import CorrectionModel
    from tests.scenes.test_airborne import noisy as measured
    from tests.scenes.test_airborne import strips

    model = CorrectionModel(position_curve=Fixes(count=3), attitude_degree=0, attitude_curve=Fixes(count=5))
    with TemporaryDirectory() as folder:
        return adjust_block(measured(strips(Path(folder), model), 0.3))


def test_strips_of_line_scanners_have_their_own_section():
    view = view_of(flown())
    assert scene_section(view) is None
    section = strip_section(view)
    told = words(section.parts)
    found = messages(section.parts)
    assert section.title.message.code == "report_scenes.strips_title"
    assert found["report_scenes.strips"] == [{"n": 2}]
    assert not re.search(r"ERR_BIAS|vendor|[Ss]atellite|bias", told)
    # for each of the two strips: residuals, two along the track, three of the position and three of the attitude
    assert len(drawings(section)) == 2 * (1 + 2 + 6)
    drawn = found["report_scenes.correction"]
    assert "attitude_about_z" in {m["quantity"] for m in drawn}
    assert sum(m["banded"] for m in drawn) == 12
    assert strip_section(view_of(scenes())) is None


def test_the_band_of_a_correction_is_its_standard_deviation():
    view = view_of(flown())
    camera = view.adjusted.cameras[0]
    figure = correction_figures(view, camera)[2]  # the height
    p = flown().interior[0].parameters
    heights = [p[f"up_{k}"].value * view.factor for k in (1, 2, 3)]
    mean = np.array([1, 4, 1]) @ heights / 6  # Simpson's rule is exact for the parabola through three fixes
    assert figure.caption.message.values["mean"] == pytest.approx(mean, abs=0.51)
    assert '"band first"' in figure.drawing.svg


def test_parameters_of_scenes_stand_in_one_table_alone():
    view = view_of(flown())
    rows = [" ".join(r) for p in flat(strip_section(view).parts) if p.kind == "table" for r in p.rows]
    assert sum("rx_2" in r for r in rows) == 2
    assert any("rx_2 [°]" in r for r in rows)
    for section in (control_section(view), interior_section(view)):
        assert not any("rx_2" in " ".join(r) for p in flat(section.parts) if p.kind == "table" for r in p.rows)
    assert messages(interior_section(view).parts)["report_interior.scenes"] == [{"names": ["strip1", "strip2"]}]


def flat(parts):
    return [q for p in parts for q in (flat(p.parts) if p.kind == "folded" else [p])]


def figures(result):
    return {name: value for m in details(result) for name, value in m.values.items()}


def test_scenes_are_not_compared_with_photographs():
    for result in (scenes(), flown()):
        view = view_of(result)
        facts = next(p for p in result_section(view, verdict(view)).parts if p.kind == "facts").facts
        assert [m.code for m in facts[0].remark.messages] == ["front.quotient"]
        codes = {m.code for _, text in verdict(view).statements for m in text.messages}
        assert "verdict.relative_precision" in codes
        assert "verdict.precision_class" not in codes
        found = figures(result)
        assert not found["sized"]
        assert found["class_name"] == "none"
    view = view_of(free())
    facts = next(p for p in result_section(view, verdict(view)).parts if p.kind == "facts").facts
    name = view.adjustment.network.precision_class.partition(" ")[0]
    assert facts[0].remark.messages[0].values == {"name": name}
    assert "verdict.precision_class" in {m.code for _, text in verdict(view).statements for m in text.messages}
    assert figures(free())["sized"]


def test_observed_parameters_have_the_units_of_the_report():
    attitudes = pytest.importorskip("tests.adjustment.test_attitudes")
    block = noisy(attitudes.flight(arm=("ax",), arm_sigma={"ax": 0.05}, boresight_sigma={"bx": 0.01}))
    result = adjust_block(block)
    view = view_of(result)
    parts = flat(control_section(view).parts)
    titles = [p.text for p in parts if p.kind == "heading"]
    at = next(k for k, p in enumerate(parts) if p.kind == "heading" and p.text == "Observed parameters")
    said, body = parts[at + 1 : at + 3]
    assert "Observed attitudes" in titles
    assert [m.code for m in said.text.messages][:2] == ["report_control.observed", "report_control.rms_by_sigma"]
    units = {r[1]: r[2] for r in body.rows}
    assert (units["ax"], units["bx"]) == (view.unit, "°")
    given = next(float(r[4]) for r in body.rows if r[1] == "bx")
    assert given == pytest.approx(np.degrees(0.01), rel=1e-2)
    attitude = next(
        p for p in parts[titles.index("Observed attitudes") :] if p.kind == "table" and "omega" in str(p.rows)
    )
    assert any("°" in str(c) for c in attitude.columns)
    imu = [p for p in flat(interior_section(view).parts) if p.kind == "table" and any("bx" in r for r in p.rows)]
    assert any("°" in cell for r in imu[0].rows for cell in r)
    assert not any(cell in {"rad", "length"} for p in flat(interior_section(view).parts) if p.kind == "table"
                   for r in p.rows for cell in r)  # fmt: skip


def test_the_logarithm_of_a_camera_constant_is_called_so():
    """ln 20.5 = 3.02 stood there as c, without a word."""
    before = pytest.importorskip("tests.adjustment.test_known_before")
    block = before.known(before.block_of(1, 25.0, before.ROLLS))
    view = view_of(before.adjusted(block))
    body = next(
        p for p in flat(control_section(view).parts) if p.kind == "table" and "ln c" in " ".join(map(str, p.rows))
    )
    rows, known = {r[1]: r for r in body.rows}, phrase("report_control.known_before", symbol="ln c")
    assert float(rows[known][3]) == pytest.approx(np.log(block.cameras[0].values["c"]), rel=1e-4)
    assert rows[known][2] != "mm"
    assert rows["known before: x0"][2] == "mm"
    assert [m.values for m in body.note.messages if m.code == "report_control.logarithms"] == [{"symbols": ["c"]}]
