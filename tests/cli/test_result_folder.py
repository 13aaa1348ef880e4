"""Result folders: complete, valid JSON, written whole or not at all, read back equal."""

import json
import math
from dataclasses import replace

import numpy as np
import pytest

from raybundle.adjustment.engine import adjust_block
from raybundle.adjustment.records.notice import Notice
from raybundle.adjustment.records.options import AdjustmentOptions
from raybundle.block.rejection import Rejection, RejectionKind
from raybundle.errors import InputError
from raybundle.io.block.folder import read_block
from raybundle.planning.simulate import Survey, simulate
from raybundle.planning.synthetic_networks import TargetField, field_scene
from raybundle.report.write import write_result
from raybundle.results.folder import check_target, read_result
from raybundle.results.tables import ALWAYS

SURVEY = Survey(
    control=5,
    control_sigma=(1e-4, 1e-4, 0.0),
    check=3,
    check_sigma=1e-4,
    scale_bars=2,
    station_sigma=0.01,
    orientation="exact",
    points="exact",
    interior="exact",
)


@pytest.fixture(scope="module")
def adjustment():
    block = simulate(field_scene(TargetField(rows=5, columns=6, stations=6, frontal=2)), SURVEY).observed
    camera = replace(block.cameras[0], sigma={"c": 0.01})
    return adjust_block(block.with_cameras(camera), AdjustmentOptions())


@pytest.fixture
def folder(adjustment, tmp_path):
    write_result(adjustment, tmp_path / "result", report="none")
    return tmp_path / "result"


HEADERS = {
    "images": "image,camera,file,X,Y,Z,omega_deg,phi_deg,kappa_deg,sX,sY,sZ,somega_deg,sphi_deg,skappa_deg",
    "points": "point,role,X,Y,Z,sX,sY,sZ,rays,window,roughness,rXY,rXZ,rYZ",
    "observations": ("image,point,x_px,y_px,sx_px,sy_px,vx_px,vy_px,rx,ry,wx,wy,tx,ty,mdbx_px,mdby_px,rejected"),
    "control": "point,X,Y,Z,sX,sY,sZ,vX,vY,vZ,rX,rY,rZ,wX,wY,wZ",
    "check": "point,X,Y,Z,dX,dY,dZ,sX,sY,sZ",
}


def test_the_files_and_headers_are_those_of_the_format(folder):
    expected = {"block", "result.json", "README.txt", *(f"{name}.csv" for name in ALWAYS)}
    assert {p.name for p in folder.iterdir()} == expected
    for name, header in HEADERS.items():
        assert (folder / f"{name}.csv").read_text().split("\n", 1)[0] == header
    assert (folder / "distances.csv").read_text().startswith("from,to,length,sigma,adjusted,v,r,w\n")


def test_the_table_of_points_gives_their_covariances(folder, adjustment):
    """Standard deviations and correlations of a row make the covariance; held coordinates have none."""
    table = read_result(folder).points.number
    std = np.stack([table[c] for c in ("sX", "sY", "sZ")], axis=1)
    r = np.stack([table[c] for c in ("rXY", "rXZ", "rYZ")], axis=1)
    wanted = adjustment.precision.object_points
    for k, (i, j) in enumerate([(0, 1), (0, 2), (1, 2)]):
        held = (std[:, i] == 0) | (std[:, j] == 0)
        assert (np.isnan(r[:, k]) == held).all()
        free = ~held
        np.testing.assert_allclose((std[:, i] * std[:, j] * r[:, k])[free], wanted[free, i, j], rtol=2e-5)
    assert np.nanmax(abs(r)) > 0.1
    assert np.isnan(r).any()


def test_result_json_holds_what_the_format_promises(folder, adjustment):
    result = json.loads((folder / "result.json").read_text(), parse_constant=pytest.fail)
    promised = {"sigma0", "redundancy", "observations", "unknowns", "constraints", "datum", "converged"}
    assert promised | {"iterations", "seconds", "cameras", "correlations", "warnings"} <= result.keys()
    assert result["sigma0"] == pytest.approx(adjustment.sigma0, rel=1e-7)
    c = result["cameras"]["1"]["c"]
    assert abs(c["value"] - adjustment.adjusted.cameras[0].values["c"]) <= 1e-3 * c["std"]
    assert c["std"] > 0
    assert result["cameras"]["1"]["A"]["std"] is None
    assert result["correlations"]["1"]["c"]["c"] == pytest.approx(1)
    assert result["correlations"]["1"]["c"]["K1"] == result["correlations"]["1"]["K1"]["c"]


def test_tables_read_back_to_a_thousandth_of_their_standard_deviations(folder, adjustment):
    read = read_result(folder)
    adjusted, statistics = adjustment.adjusted, adjustment.image_observations
    xyz, std = read.points.numbers("X", "Y", "Z"), adjustment.precision.object_point_std
    assert (np.abs(xyz - adjusted.points.xyz) <= 1e-3 * std).all()
    e, C = xyz - adjusted.points.xyz, adjustment.precision.object_points
    jointly = [
        v[f] @ np.linalg.solve(c[np.ix_(f, f)], v[f]) for v, c in zip(e, C, strict=True) if (f := np.diag(c) > 0).any()
    ]
    assert max(jointly) <= 1e-6
    np.testing.assert_allclose(read.points.numbers("sX", "sY", "sZ"), std, rtol=1e-4)
    o = read.observations
    w = o.numbers("wx", "wy")
    np.testing.assert_allclose(w, statistics.w, atol=0.5e-3)
    std_v = np.abs(statistics.residuals_px / statistics.w)
    assert (np.abs(o.numbers("vx_px", "vy_px") - statistics.residuals_px) <= 1.0001e-3 * std_v).all()
    np.testing.assert_allclose(o.numbers("rx", "ry"), statistics.redundancy, atol=1e-5)
    np.testing.assert_allclose(o.numbers("x_px", "y_px"), adjustment.given.observations.xy_px, atol=1e-5)
    assert (
        np.abs(read.images.numbers("X", "Y", "Z") - adjusted.images.centre)
        <= 1e-3 * adjustment.precision.image_std[:, :3]
    ).all()
    assert read.points.text["point"] == adjusted.points.ids
    assert read.points.number["rays"].sum() == len(adjusted.observations)


def test_no_number_of_a_result_has_more_digits_than_it_deserves(folder):
    """Seventeen digits stand in the block; what was given stands in control.csv as it was given."""
    lengths = {}
    for name in ("points", "images", "observations"):
        rows = [line.split(",") for line in (folder / f"{name}.csv").read_text().splitlines()]
        lengths |= {c: max(len(r[k].lstrip("-").replace(".", "")) for r in rows[1:]) for k, c in enumerate(rows[0])}
    assert max(n for c, n in lengths.items() if c[0] in "srwtvm" and c != "role") <= 10
    assert (folder / "block/observations.csv").stat().st_size > 0.4 * (folder / "observations.csv").stat().st_size


def test_control_and_stations_are_told_apart_by_coordinate(folder, adjustment):
    read = read_result(folder)
    control, stations = read.control, read.stations
    assert control.rows == 5
    group = next(g for g in adjustment.groups if g.kind == "control")
    k = [
        i
        for i, key in enumerate(zip(group.ids, group.component, strict=True))
        if key == (control.text["point"][2], "Y")
    ]
    assert control.number["vY"][2] == pytest.approx(group.residual[k[0]], abs=1e-3 * group.sigma[k[0]])
    adjusted = adjustment.adjusted.points.xyz[adjustment.adjusted.points.ids.index(control.text["point"][2])]
    assert control.number["vY"][2] == pytest.approx(adjusted[1] - control.number["Y"][2], abs=1e-3 * group.sigma[k[0]])
    np.testing.assert_allclose(
        stations.numbers("vX", "vY", "vZ"),
        stations.numbers("X_adjusted", "Y_adjusted", "Z_adjusted") - stations.numbers("X", "Y", "Z"),
        atol=2e-3 * 0.01,
    )
    np.testing.assert_allclose(
        read.distances.number["v"],
        read.distances.number["adjusted"] - read.distances.number["length"],
        atol=2e-3 * float(read.distances.number["sigma"].max()),
    )


def test_check_points_get_the_sigma_of_the_difference(folder, adjustment):
    check = read_result(folder).check
    assert check.rows == 3
    at = [adjustment.given.points.ids.index(p) for p in check.text["point"]]
    given, adjusted = adjustment.given.points.xyz[at], adjustment.adjusted.points.xyz[at]
    expected = np.hypot(adjustment.precision.object_point_std[at], 1e-4)
    np.testing.assert_allclose(check.numbers("sX", "sY", "sZ"), expected, rtol=1e-4)
    assert (np.abs(check.numbers("dX", "dY", "dZ") - (adjusted - given)) <= 1.001e-3 * expected).all()
    assert (np.abs(check.numbers("dX", "dY", "dZ")) < 6 * expected).all()


def test_the_block_again_gives_the_same_adjustment(folder, adjustment):
    """What was observed stays as given; only approximate values move, so nothing is counted twice."""
    block = read_block(folder / "block")
    control = block.points.is_control
    np.testing.assert_array_equal(block.points.xyz[control], adjustment.given.points.xyz[control])
    assert block.cameras[0].values["c"] == adjustment.given.cameras[0].values["c"]
    assert block.cameras[0].values["K1"] == adjustment.adjusted.cameras[0].values["K1"]
    again = adjust_block(block, AdjustmentOptions())
    assert again.sigma0 == pytest.approx(adjustment.sigma0, rel=1e-9)
    np.testing.assert_allclose(again.adjusted.points.xyz, adjustment.adjusted.points.xyz, atol=1e-8)


def test_numbers_that_there_are_not_become_null_and_empty(adjustment, tmp_path):
    bare = replace(
        adjustment,
        sigma0=math.nan,
        precision=None,
        network=None,
        groups=(),
        notices=(Notice(code="no_redundancy", message="none", ids=("a",)),),
    )
    write_result(bare, tmp_path / "r", report="none")
    read = read_result(tmp_path / "r")
    assert read.result["sigma0"] is None
    assert read.result["relative_precision"] is None
    assert read.result["warnings"] == [{"code": "no_redundancy", "severity": "fault", "message": "none", "ids": ["a"]}]
    assert np.isnan(read.points.numbers("sX", "sY", "sZ")).all()
    assert np.isnan(read.control.number["vX"]).all()
    assert "nan" not in (tmp_path / "r" / "points.csv").read_text().lower()


def test_a_check_point_without_rays_has_no_difference(adjustment, tmp_path):
    point = int(np.flatnonzero(np.asarray(adjustment.given.points.role) == 2)[0])
    keep = (
        Rejection(kind=RejectionKind.BEHIND_CAMERA) if p == point else None for p in adjustment.given.observations.point
    )
    rejected = replace(adjustment.image_observations, rejected=tuple(keep))
    write_result(replace(adjustment, image_observations=rejected), tmp_path / "r", report="none")
    read = read_result(tmp_path / "r")
    row = read.check.text["point"].index(adjustment.given.points.ids[point])
    assert np.isnan(read.check.number["dX"][row])
    assert np.isfinite(read.check.number["dX"]).sum() == 2
    assert read.points.number["rays"][point] == 0
    behind = sum(words.startswith("behind") for words in read.observations.text["rejected"])
    assert read.result["rejected"] == behind > 0


def test_a_result_is_replaced_only_by_a_complete_one(folder, adjustment, monkeypatch):
    before = (folder / "result.json").read_bytes()
    monkeypatch.setattr("raybundle.results.folder.result_json", broken)
    with pytest.raises(InputError, match=r"file\.not_writable"):
        write_result(adjustment, folder, report="none")
    assert (folder / "result.json").read_bytes() == before
    assert [p.name for p in folder.parent.iterdir()] == ["result"]
    monkeypatch.undo()
    write_result(replace(adjustment, seconds=12.5), folder, report="none")
    assert json.loads((folder / "result.json").read_text())["seconds"] == 12.5
    assert [p.name for p in folder.parent.iterdir()] == ["result"]


def broken(*_):
    raise OSError(28, "No space left on device")


def test_other_folders_are_never_overwritten(folder, adjustment, tmp_path):
    check_target(folder)
    check_target(tmp_path / "new")
    (tmp_path / "file").write_text("x")
    with pytest.raises(InputError, match=r"result\.not_a_folder"):
        write_result(adjustment, tmp_path / "file", report="none")
    for place in (folder, folder / "block"):
        (place / ".report.html.2cfa3545.partial").mkdir()  # as a writer leaves it that was killed
    check_target(folder)
    (folder / "notes.txt").write_text("mine")
    with pytest.raises(InputError, match=r"notes\.txt.*result\.foreign_files"):
        write_result(adjustment, folder, report="none")
    (folder / "notes.txt").unlink()
    (folder / "block" / "mine.csv").write_text("mine")
    with pytest.raises(InputError, match=r"block/mine\.csv.*result\.foreign_files"):
        write_result(adjustment, folder, report="none")
    (folder / "block" / "mine.csv").unlink()
    (folder / "result.json").write_text('{"sigma0": 1}')
    with pytest.raises(InputError, match=r"result\.other_folder"):
        write_result(adjustment, folder, report="none")


def test_what_is_not_a_result_is_not_read(folder):
    (folder / "points.csv").write_text("point,X\n1,2\n")
    with pytest.raises(InputError, match=r"points\.csv.*1.*table\.columns_missing"):
        read_result(folder)
    (folder / "result.json").write_text("[1, 2")
    with pytest.raises(InputError, match=r"result\.json.*result\.not_of_adjustment"):
        read_result(folder)
