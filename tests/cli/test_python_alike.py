"""What the command line does is done from Python under the same names, with the same files."""

from pathlib import Path

import numpy as np
import pytest
from tests.messages import refused
from tests.targets.test_cli_targets import photographs

import raybundle as rb
from raybundle.cli.main import main
from raybundle.errors import InputError
from raybundle.planning.simulate import Survey, simulate
from raybundle.planning.synthetic_networks import TargetField, field_scene
from raybundle.report.write import write_result


def same_files(one, two):
    files = [{p.relative_to(f): p.read_bytes() for p in Path(f).rglob("*") if p.is_file()} for f in (one, two)]
    assert files[0] == files[1] != {}


@pytest.fixture
def control(tmp_path):
    rng = np.random.default_rng(3)
    xyz = rng.uniform(-10, 10, (14, 3))
    depth = 1 + 0.001 * xyz[:, 0] + 0.02 * xyz[:, 2]
    xy = (xyz @ [[100.0, 3.0], [20.0, 90.0], [5.0, -8.0]] + [900, 700]) / depth[:, None] + rng.normal(0, 0.3, (14, 2))
    rows = [
        ",".join([f"p{k}", *map(str, [*a, *b]), "check" if k in {3, 7} else ""])
        for k, (a, b) in enumerate(zip(xyz.tolist(), xy.tolist(), strict=True))
    ]
    (tmp_path / "control.csv").write_text("\n".join(["point,X,Y,Z,x_px,y_px,role", *rows]) + "\n")
    return tmp_path / "control.csv"


def test_empirical(control, tmp_path, capsys):
    done = rb.empirical(control, out=tmp_path / "a")
    status = main(["empirical", str(control), "--out", str(tmp_path / "b")])
    assert status == (0 if done.fit.adequate else 3)
    assert done.advice.reason.headline() in capsys.readouterr().out.splitlines()
    same_files(tmp_path / "a", tmp_path / "b")
    assert len(done.used) == 12
    assert all(0 < v < 2 for v in done.check_rms_px)
    assert rb.empirical(control, model="dlt-brown", without="K3,P1").advice is None
    with pytest.raises(InputError, match=r'without=.*model="dlt-brown".*empirical\.excluded_needs_model'):
        rb.empirical(control, without=("K3",))
    with refused("setting.not_one_of", name="model", given="'cubic'"):
        rb.empirical(control, model="cubic")


def test_targets_in_photographs(tmp_path):
    photographs(tmp_path / "photos")
    files = {"out": tmp_path / "a.csv", "observations": tmp_path / "ao.csv", "overlay": tmp_path / "af"}
    found = rb.detect_targets(tmp_path / "photos", "aicon12", dots=True, **files)
    words = ["--out", tmp_path / "b.csv", "--observations", tmp_path / "bo.csv", "--overlay", tmp_path / "bf"]
    assert main(["targets", "detect", str(tmp_path / "photos"), "--target", "aicon12", "--dots", *map(str, words)]) == 0
    assert sorted(found) == ["a.png", "b.png"]
    assert (tmp_path / "a.csv").read_bytes() == (tmp_path / "b.csv").read_bytes()
    assert (tmp_path / "ao.csv").read_bytes() == (tmp_path / "bo.csv").read_bytes()
    same_files(tmp_path / "af", tmp_path / "bf")
    with pytest.raises(InputError, match=r"table=.*bits=.*target=.*target\.table_settings"):
        rb.detect_targets(tmp_path / "photos", table=tmp_path / "codes.csv")


def test_the_camera_library(tmp_path):
    block = simulate(field_scene(TargetField(stations=4)), Survey(points="exact", scale_bars=1)).observed
    write_result(rb.adjust(block), tmp_path / "result", report="none")
    about = {"camera_make": "Nikon", "camera_model": "D850", "focal": 24.0, "date": "2026-01-02"}
    kept = rb.keep_calibration(tmp_path / "result", library=tmp_path / "a", **about)
    words = [f"--{n.replace('_', '-')}={v}" for n, v in about.items()]
    assert main(["calibration", "add", str(tmp_path / "result"), *words, "--library", str(tmp_path / "b")]) == 0
    same_files(tmp_path / "a", tmp_path / "b")
    (entry,) = rb.kept_calibrations(library=tmp_path / "a").entries
    assert entry.key == kept.key
    assert kept.place.is_dir()
    photographs(tmp_path / "photos")
    found = rb.find_calibration(tmp_path / "photos/a.png", library=tmp_path / "a", out=tmp_path / "best.toml")
    assert found.best is None
    assert [m.fits for m in found.matches] == [False]
    assert not (tmp_path / "best.toml").exists()
    with pytest.raises(InputError, match=r"library\.no_key"):
        rb.keep_calibration(tmp_path / "result", library=tmp_path / "a")


def test_sheets(tmp_path):
    rb.write_target_sheet("agisoft12", tmp_path / "a.svg", codes="1-4", paper="A2", tile="A4", dot_radius=10.0)
    words = ["--target", "agisoft12", "--codes", "1-4", "--paper", "A2", "--tile", "A4", "--dot-radius", "1cm"]
    (tmp_path / "b").mkdir()
    assert main(["targets", "sheet", *words, "--out", str(tmp_path / "b/a.svg")]) == 0
    assert (tmp_path / "a.svg").read_bytes() == (tmp_path / "b/a.svg").read_bytes()
    with pytest.raises(InputError, match=r"codes=.*count=.*option\.one_of"):
        rb.write_target_sheet("aicon12", tmp_path / "c.svg")
    with refused("setting.too_small", name="dot_radius", given="0", least=0, above=True):
        rb.write_target_sheet("aicon12", tmp_path / "c.svg", count=3, dot_radius=0)
