"""The probability that a station is wrong: what raises it, and where it stands."""

import json
from dataclasses import replace
from pathlib import Path
from types import SimpleNamespace

import numpy as np
import pytest

from raybundle import adjust
from raybundle.adjustment.records.notice import Notice
from raybundle.planning.simulate import Survey, simulate
from raybundle.planning.synthetic_networks import Ring, brown_camera, ring_scene
from raybundle.results.folder import read_result, written_folder
from raybundle.studio.answers import _p_wrong
from raybundle.ties.explained_matches import PairFits
from raybundle.ties.wrong_stations import (
    EVIDENCE,
    FALSE_ALARMS,
    LIMIT,
    MODEL,
    evidence,
    probabilities,
    with_probabilities,
)

CAMERA = brown_camera(size_px=(3000, 2000), pixel_mm=0.008)
ODD = 3


@pytest.fixture(scope="module")
def result():
    scene = ring_scene(Ring(camera=CAMERA, stations=7, rings=1, points=300))
    return adjust(simulate(scene, Survey(seed=3, image_sigma_px=0.5)).observed)


def fits(result, odd_share=1.0):
    """Matches of all pairs, of which all fit but those of one image."""
    n = len(result.adjusted.images)
    ends = np.array([(i, j) for i in range(n) for j in range(i + 1, n)])
    matches = np.full(len(ends), 100)
    odd = (ends == ODD).any(axis=1)
    return PairFits(ends=ends, matches=matches, fitting=np.where(odd, round(100 * odd_share), 100))


def test_right_stations_are_likely_right(result):
    p = probabilities(evidence(result, fits(result), ()))
    assert (p < 0.2).all()


def test_unexplained_matches_make_one_station_the_likeliest_wrong(result):
    before = probabilities(evidence(result, fits(result), ()))
    p = probabilities(evidence(result, fits(result, 0.3), ()))
    assert np.argmax(p) == ODD
    assert p[ODD] > 3 * before[ODD]


def test_a_fault_that_names_a_photograph_raises_its_probability(result):
    fault = Notice(code="image_contradicts.matches", ids=(result.adjusted.images.ids[ODD],))
    before = probabilities(evidence(result, fits(result), ()))
    p = probabilities(evidence(result, fits(result), (fault,)))
    assert np.argmax(p) == ODD
    assert p[ODD] > before[ODD]


def test_no_evidence_makes_a_wrong_station_less_likely():
    assert MODEL.coefficients.shape == (len(EVIDENCE) + 1,)
    assert (MODEL.coefficients[1:] >= 0).all()
    assert np.linalg.eigvalsh(MODEL.covariance).min() > -1e-3
    worst, best, beyond = probabilities(np.stack([MODEL.high, MODEL.low, 2 * MODEL.low]))
    assert worst > LIMIT > best
    assert beyond == best  # of stronger evidence than there was nothing is known


def test_the_model_is_that_of_the_benchmark():
    results = Path(__file__).parents[2] / "benchmarks/results/wrong_stations.json"
    kept = json.loads(results.read_text(encoding="utf-8"))
    for name, values in kept["model"].items():
        assert getattr(MODEL, name) == pytest.approx(np.array(values)), name
    alarms = kept["false_alarms"]
    assert pytest.approx(alarms["named"] / alarms["right"], abs=5e-4) == FALSE_ALARMS
    assert kept["limit"] == LIMIT


def test_images_without_orientation_are_not_judged(result):
    images = result.adjusted.images
    centre = np.array(images.centre)
    centre[2] = np.nan
    lost = replace(result, adjusted=replace(result.adjusted, images=replace(images, centre=centre)))
    p = probabilities(evidence(lost, fits(result), ()))
    assert np.flatnonzero(~np.isfinite(p)).tolist() == [2]


def test_probabilities_stand_in_the_result(result, tmp_path):
    done = with_probabilities(result, fits(result, 0.0), ())
    assert done.p_wrong is not None
    with written_folder(done, tmp_path / "result"):
        pass
    read = read_result(tmp_path / "result")
    assert read.images.number["p_wrong"] == pytest.approx(done.p_wrong, rel=0.01)
    told = json.loads((tmp_path / "result/result.json").read_text())["p_wrong"]
    assert _p_wrong(SimpleNamespace(source=tmp_path)) == told  # as the studio shows it
    assert told == dict(zip(read.images.text["image"], read.images.number["p_wrong"].tolist(), strict=True))


def test_likely_wrong_stations_are_named(result):
    ids = tuple(result.adjusted.images.ids)
    fault = Notice(code="repeated_structure.missing", ids=ids)
    vague = replace(result, precision=replace(result.precision, images=1e6 * result.precision.images))
    done = with_probabilities(vague, fits(result, 0.0), (fault,))
    assert done.p_wrong is not None
    named = [n for n in done.notices if n.code == "wrong_stations"]
    assert [set(n.ids) for n in named] == [{ids[k] for k in np.flatnonzero(done.p_wrong > LIMIT)}]


def test_results_without_them_are_read(result, tmp_path):
    with written_folder(result, tmp_path / "result"):
        pass
    header = (tmp_path / "result/images.csv").read_text().splitlines()[0]
    assert "p_wrong" not in header
    assert "p_wrong" not in read_result(tmp_path / "result").images.number
