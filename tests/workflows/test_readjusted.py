"""The block of a result, adjusted again as a user does it, gives the same result."""

import json
import shutil
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from raybundle.adjustment.records.options import AdjustmentOptions
from raybundle.block.rejection import RejectionKind, found_wrong, given_rejections, known_wrong
from raybundle.block.select import with_rows
from raybundle.cli.main import main
from raybundle.io.block.folder import read_block, write_block
from raybundle.io.block.tables import named
from raybundle.planning.simulate import Survey, simulate
from raybundle.planning.synthetic_networks import TargetField, field_scene
from raybundle.report.write import write_result
from raybundle.workflows.adjust import adjust
from raybundle.workflows.orienting.connected_components import merged

ASKED = AdjustmentOptions(reject="snooping", noise="fields", datum_over="good", estimate="auto")


@pytest.fixture(scope="module")
def first(tmp_path_factory):
    """A result with blunders rejected under smooth noise, and its folder."""
    survey = Survey(seed=4, image_sigma_px=0.3, gross_share=0.02, gross_px=12.0, points="approximate")
    block = simulate(field_scene(TargetField(rows=8, columns=9, stations=8)), survey).observed
    block = replace(block, observations=replace(block.observations, cov_px2=block.observations.cov_px2 * 9))
    result = adjust(block, ASKED)
    folder = tmp_path_factory.mktemp("result") / "first"
    write_result(result, folder, report="none")
    return result, folder


def test_the_same_result_comes_of_the_block_alone(first):
    before, folder = first
    block = read_block(folder / "block")
    assert (block.noise, block.datum_over) == ("fields", "good")
    lost = [r for r in before.image_observations.rejected if r is not None]
    assert len(lost) > 5
    assert known_wrong(block).sum() == len([r for r in lost if r.kind is not RejectionKind.SINGLE_RAY])
    after = adjust(block)
    assert after.redundancy == before.redundancy
    assert after.sigma0 == pytest.approx(before.sigma0, rel=1e-6)
    np.testing.assert_array_equal(after.image_observations.used, before.image_observations.used)
    assert after.noise.kind == before.noise.kind == "fields"
    assert after.noise.phi == pytest.approx(before.noise.phi, rel=1e-4)
    assert after.precision is not None
    assert before.precision is not None
    np.testing.assert_allclose(after.precision.object_points, before.precision.object_points, rtol=1e-3, atol=1e-12)
    (stated,) = [n for n in after.notices if n.code == "given_rejected"]
    assert stated.values["n"] == known_wrong(block).sum()
    assert {r.kind for r in after.image_observations.rejected if r} <= {RejectionKind.GIVEN, RejectionKind.SINGLE_RAY}


def test_what_is_asked_for_goes_before_what_the_block_says(first):
    _, folder = first
    white = adjust(read_block(folder / "block"), AdjustmentOptions(noise="white", datum_over="all"))
    assert white.noise.kind == "white"
    assert white.options.datum_over == "all"


def test_without_the_column_all_rows_take_part(first, tmp_path, capsys):
    _, folder = first
    block = Path(shutil.copytree(folder / "block", tmp_path / "block"))
    kept = read_block(block)
    lines = (block / "observations.csv").read_text(encoding="utf-8").splitlines()
    assert lines[0].endswith(",rejected")
    assert sum(line.endswith(",1") for line in lines) == known_wrong(kept).sum()
    (block / "observations.csv").write_text("\n".join(x.rpartition(",")[0] for x in lines) + "\n", encoding="utf-8")
    assert main(["adjust", str(block), "--out", str(tmp_path / "all"), "--no-report"]) == 0
    assert "[given_rejected]" not in capsys.readouterr().out
    assert json.loads((tmp_path / "all/result.json").read_text(encoding="utf-8"))["rejected"] == 0


@pytest.mark.parametrize("value", ["2", "-1", "0.5"])
def test_another_number_in_the_column_is_named(first, tmp_path, value, capsys):
    _, folder = first
    block = Path(shutil.copytree(folder / "block", tmp_path / "block"))
    lines = (block / "observations.csv").read_text(encoding="utf-8").splitlines()
    lines[3] = lines[3].rpartition(",")[0] + f",{value}"
    (block / "observations.csv").write_text("\n".join(lines) + "\n", encoding="utf-8")
    assert main(["adjust", str(block), "--out", str(tmp_path / "r")]) == 2
    assert "[cell.not_a_flag]" in capsys.readouterr().err


def test_folders_selections_and_merged_parts_keep_what_is_wrong(first, tmp_path):
    before, _ = first
    block = replace(before.given, rejected=found_wrong(before.given, before.image_observations.rejected))
    write_block(block, tmp_path / "b")
    again = read_block(tmp_path / "b")
    assert set(again.rejected) == set(block.rejected)
    rng = np.random.default_rng(2)
    keep = rng.random(len(block.observations)) < 0.7
    part = with_rows(block, keep)
    o = part.observations
    names = set(zip(named(part.images.ids, o.image), named(part.points.ids, o.point), strict=True))
    assert known_wrong(part).sum() == len(names & set(block.rejected))
    both = merged([part, with_rows(block, ~keep)])
    assert known_wrong(both).sum() == known_wrong(block).sum()
    assert sum(r is not None for r in given_rejections(both)) == known_wrong(block).sum()
