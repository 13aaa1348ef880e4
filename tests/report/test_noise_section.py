"""What a result says of the noise that its standard deviations rest on: report, result.json, command line."""

import json
from dataclasses import replace

import pytest

from raybundle import words
from raybundle.adjustment.engine import adjust_block
from raybundle.adjustment.evaluation.residual_structure import structure_notice
from raybundle.adjustment.records.options import AdjustmentOptions
from raybundle.errors import phrase
from raybundle.planning.simulate import Survey, simulate
from raybundle.planning.synthetic_networks import TargetField, field_scene
from raybundle.report.text.summary import details
from raybundle.report.write import write_result
from tests.adjustment.test_noise import with_fields


@pytest.fixture(scope="module")
def result():
    scene = field_scene(TargetField(rows=6, columns=8, stations=8))
    block = simulate(scene, Survey(points="exact", orientation="exact", interior="exact")).observed
    return adjust_block(with_fields(block, 0.3), AdjustmentOptions(noise="fields"))


def test_floor_and_fields_stand_in_the_report_and_in_result_json(result, tmp_path):
    write_result(result, tmp_path / "r")
    told = json.loads((tmp_path / "r/result.json").read_text())
    noise, c = told["noise"], told["cameras"]["1"]["c"]
    assert noise["kind"] == "fields"
    assert noise["phi"] >= 1
    assert noise["tau_px"] == pytest.approx(0.3, rel=0.3)
    assert 0.5 < noise["share"] <= 1
    assert noise["images"] == noise["sampled"] == 12
    assert c["std"] / c["std_white"] > 1.3
    assert told["options"]["noise"] == "fields"
    page = (tmp_path / "r/report.html").read_text()
    assert words.headline("report_noise.title", {}) in page
    assert words.headline("report_noise.sigma_independent", {}) in page
    assert words.headline("report_noise.smooth_errors", {}) in page


def test_white_noise_has_no_section_and_one_standard_deviation(result, tmp_path):
    white = adjust_block(result.given, AdjustmentOptions())
    write_result(white, tmp_path / "r")
    told = json.loads((tmp_path / "r/result.json").read_text())
    assert told["noise"]["kind"] == "white"
    assert all(p["std"] == p["std_white"] for p in told["cameras"]["1"].values())
    assert words.headline("report_noise.title", {}) not in (tmp_path / "r/report.html").read_text()
    assert not any("noise" in m.code for m in details(white))


def test_the_summary_says_how_much_wider_standard_deviations_are(result):
    found = {m.code: m.values for m in details(result)}
    assert found["summary.noise_smooth"]["sigma_px"] == result.noise.tau_px
    centres = [m.values for m in details(result) if m.values.get("kind") == "centres"]
    assert centres == [{"kind": "centres", "factor": result.noise.ratio_images}]


def test_a_reason_is_told_where_noise_stays_white(result, tmp_path):
    noise = replace(result.noise, kind="white", reason=phrase("noise.rig"))
    told = replace(result, noise=noise)
    write_result(told, tmp_path / "r")
    assert noise.reason in (tmp_path / "r/report.html").read_text()
    (reason,) = [m.values["cause"] for m in details(told) if m.code == "summary.noise_white"]
    assert reason == noise.reason


def test_structure_of_residuals_is_noticed_for_white_noise_alone(result):
    assert structure_notice(replace(result, noise=replace(result.noise, kind="fields"))) is None
