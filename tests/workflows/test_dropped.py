"""What was dropped before the adjustment is said, each reason with its number."""

import json
import shutil
from pathlib import Path

import pytest

from raybundle.adjustment.records.severity import Severity
from raybundle.cli.main import main
from raybundle.words import headline
from raybundle.workflows.orienting.excluded_features import Dropped

PORTAL = Path(__file__).resolve().parents[2] / "demo_data/portal"


def test_the_reasons_add_up():
    d = Dropped(features=40_000, matched=16_744, started=16_000, measured=5_000, features_kept=100, added=300,
                adjusted=5_300)  # fmt: skip
    assert d.reasons == {
        "without_partner": 23_256, "contradict_orientation": 744, "not_measured_precisely": 10_900,
        "contradict_others": 100,
    }  # fmt: skip
    assert d.matched + d.added - sum(d.reasons.values()) + d.reasons["without_partner"] == d.adjusted
    assert d.share == pytest.approx(11_744 / 17_044)
    told = d.notice(5_300)
    assert told.severity is Severity.WARNING
    assert told.values == {
        "share": d.share, "features": 40_000, "matched": 16_744, "added": 300, "contradict_orientation": 744,
        "not_measured": 10_900, "contradict_others": 100, "adjusted": 5_300, "given": 5_300,
    }  # fmt: skip
    assert d.notice(5_410).values["given"] == 5_410
    for words in ("69 % of the image points", "matched 16 744", "10 900 by least-squares matching"):
        assert words in told.text


def test_without_least_squares_matching_only_what_contradicts_is_dropped():
    d = Dropped(features=900, matched=500, started=450, adjusted=450)
    assert d.reasons["not_measured_precisely"] == 0
    assert d.share == pytest.approx(0.1)
    assert d.notice(450).severity is Severity.NOTE


@pytest.mark.skipif(not PORTAL.is_dir(), reason="demo_data/portal is part of the repository, not of the package")
def test_result_and_report_state_it_and_a_second_run_says_the_same(tmp_path):
    (tmp_path / "photos").mkdir()
    for k in (1, 2, 3):
        shutil.copy(PORTAL / f"photos/portal_{k:02d}.jpg", tmp_path / "photos")
    call = ["orient", str(tmp_path / "photos"), "--out", str(tmp_path / "p"), "--feature-count", "600", "--jobs", "2"]
    found = []
    for _ in range(2):
        assert main(call) == 0
        result = json.loads((tmp_path / "p/result/result.json").read_text())
        found.append(result["measurements"])
        (notice,) = (w for w in result["warnings"] if w["code"] == "dropped")
        assert notice["values"]["not_measured"] == found[-1]["dropped"]["not_measured_precisely"]
        assert headline("dropped", notice["values"]) in (tmp_path / "p/result/report.html").read_text()
    assert found[0] == found[1]
    m = found[0]
    assert m["features"] > m["matched"] > 0
    lost = sum(n for r, n in m["dropped"].items() if r != "without_partner")
    assert m["matched"] + m["added"] - lost == m["adjusted"]
