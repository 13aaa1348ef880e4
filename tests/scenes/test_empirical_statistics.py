"""Statistics of empirical models: reliability, physical units, significance, and the choice among models."""

import json

import numpy as np
import pytest

from raybundle.cli.main import main
from raybundle.errors import InputError
from raybundle.scenes.empirical import empirical_models, fit_empirical
from raybundle.scenes.empirical_statistics import choose_empirical, empirical_statistics
from tests.cli.reported import reported, values_of
from tests.messages import failed
from tests.scenes.test_empirical import LENS, cube, made


def noisy(name, n=60, sigma=0.3, seed=4):
    xyz = cube(n)
    return xyz, made(name, xyz) + np.random.default_rng(seed).normal(0, sigma, (n, 2))


@pytest.mark.parametrize("name", empirical_models)
def test_redundancy_numbers_sum_to_the_redundancy_and_w_is_normal(name):
    xyz, xy = noisy(name)
    fit = fit_empirical(name, xyz, xy, sigma_px=0.3)
    s = empirical_statistics(fit)
    assert s.redundancy.sum() == pytest.approx(fit.redundancy, rel=1e-6)
    assert np.nanstd(s.w) == pytest.approx(1, abs=0.25)
    assert not s.blunders
    # the covariance in px and m predicts the same scatter of the image points as the fit's own
    assert np.allclose(np.diag(s.correlation), 1)


def test_a_blunder_is_found_and_left_out_coordinates_are_those_of_a_fit_without_it():
    xyz, xy = noisy("dlt")
    fit = fit_empirical("dlt", xyz, xy, sigma_px=0.3)
    s = empirical_statistics(fit)
    weight = np.ones((60, 2), bool)
    weight[7, 1] = False
    A = fit.project_with_partials(xyz)[2][weight]
    l = (xy - fit.project(xyz))[weight]
    dx = np.linalg.lstsq(A, l, rcond=None)[0]
    apart = fit.residuals_px[7, 1] + fit.project_with_partials(xyz)[2][7, 1] @ dx
    assert s.left_out_px[7, 1] == pytest.approx(apart, rel=1e-3)
    xy[7, 1] += 2 * s.mdb_px[7, 1]
    wrong = empirical_statistics(fit_empirical("dlt", xyz, xy, sigma_px=0.3))
    assert wrong.blunders[0] == (7, 1)


def test_physical_units_do_not_depend_on_the_normalisation():
    """Parameters and covariance in px and m: the same points in mm give values that the units alone change."""
    xyz, xy = noisy("dlt-brown", 80)
    first = empirical_statistics(fit_empirical("dlt-brown", xyz, xy, sigma_px=0.3))
    second = empirical_statistics(fit_empirical("dlt-brown", xyz * 1000, xy, sigma_px=0.3), length_unit="mm")
    factors = {"px/m": 1e-3, "px": 1.0, "1/m": 1e-3, "px^-2": 1.0, "px^-4": 1.0, "px^-6": 1.0, "px^-1": 1.0}
    for a, b in zip(first.parameters, second.parameters, strict=True):
        assert b.value == pytest.approx(a.value * factors[a.unit], rel=1e-5, abs=1e-12 * abs(a.std) + 1e-25)
        assert b.std == pytest.approx(a.std * factors[a.unit], rel=1e-5)
        assert b.unit == a.unit.replace("m", "mm")
    fit = fit_empirical("dlt-brown", xyz, xy, sigma_px=0.3)
    L = np.array([p.value for p in first.parameters])[:11]
    d = xyz - fit.normalisation.object_offset
    image = (d @ np.array([L[:3], L[4:7]]).T + L[[3, 7]]) / (1 + d @ L[8:])[:, None]
    plain = fit.model.evaluate(d / fit.normalisation.object_scale, np.concatenate([fit.values[:11], np.zeros(5)]))[0]
    assert np.abs(image - plain * fit.normalisation.image_scale).max() < 1e-6


def test_lens_parameters_are_recovered_with_true_sigmas():
    scale = 1000.0  # of `made`
    true = LENS / scale ** np.array([2, 4, 6, 1, 1])
    errors = []
    for seed in range(40):
        s = empirical_statistics(fit_empirical("dlt-brown", *noisy("dlt-brown", 80, seed=seed), sigma_px=0.3))
        errors += [(p.value - t) / p.std for p, t in zip(s.parameters[11:], true, strict=True)]
    assert np.mean(np.square(errors)) == pytest.approx(1, abs=0.25)
    assert all(p.additional and p.significant for p in s.parameters[11:12])
    names = {frozenset(pair[:2]) for pair in s.correlated(0.9)}
    assert frozenset(("K2", "K3")) in names


def test_the_adequate_model_with_the_fewest_parameters_is_advised():
    for name in ("affine", "dlt", "dlt-brown"):
        advice = choose_empirical(*noisy(name, 80), sigma_px=0.3)
        assert advice.advised is not None
        assert advice.advised.name == name, advice.reason
    xyz, xy = noisy("affine", 80, sigma=5.0)
    none = choose_empirical(xyz, xy, sigma_px=0.3)
    assert none.advised is None
    assert none.reason.code == "empirical.none_adequate"
    flat = xyz * [1, 1, 0]
    plane = choose_empirical(flat, made("plane-projective", flat), sigma_px=0.3)
    assert plane.advised is not None
    assert plane.advised.name == "plane-projective"
    with pytest.raises(InputError, match=r"empirical\.none_fitted"):
        choose_empirical(xyz[:2], xy[:2], sigma_px=0.3)


def table(path, xyz, xy, roles=None):
    lines = ["point,X,Y,Z,x_px,y_px" + (",role" if roles else "")]
    for k, (p, m) in enumerate(zip(xyz, xy, strict=True)):
        row = [f"p{k}", *(repr(float(v)) for v in (*p, *m)), *([roles[k]] if roles else [])]
        lines.append(",".join(row))
    path.write_text("\n".join(lines) + "\n")
    return str(path)


def test_the_command(tmp_path, capsys):
    xyz, xy = noisy("dlt-brown", 80)
    roles = ["check" if k % 8 == 0 else "control" for k in range(80)]
    file = table(tmp_path / "points.csv", xyz, xy, roles)
    found = values_of(reported(capsys, "empirical", file, "--image-sigma", 0.3, "--out", tmp_path / "out"))
    assert (found["empirical.advised"]["model"], found["empirical.advised"]["n"]) == ("dlt-brown", 16)
    assert found["empirical.check_points"]["n"] == 10
    model = json.loads((tmp_path / "out/model.json").read_text())
    assert model["adequate"]
    assert model["parameters"]["K1"]["unit"] == "px^-2"
    assert np.array(model["covariance"]).shape == (16, 16)
    head = (tmp_path / "out/points.csv").read_text().splitlines()
    assert head[0] == (
        "point,role,x_px,y_px,v_x_px,v_y_px,r_x,r_y,w_x,w_y,mdb_x_px,mdb_y_px,left_out_x_px,left_out_y_px"
    )
    assert len(head) == 81
    assert main(["empirical", file, "--image-sigma", "0.3", "--out", str(tmp_path / "out")]) == 2
    assert "[folder.exists]" in capsys.readouterr().err
    assert main(["empirical", file, "--model", "affine", "--image-sigma", "0.3"]) == 3
    assert "[empirical.not_adequate]" in capsys.readouterr().out
    assert main(["empirical", file, "--model", "dlt-brown", "--without", "K3", "--image-sigma", "0.3"]) in {0, 3}
    assert "held" in capsys.readouterr().out


def test_bad_tables(tmp_path, capsys):
    xyz, xy = noisy("dlt", 5)
    assert main(["empirical", table(tmp_path / "few.csv", xyz, xy), "--model", "dlt", "--json"]) == 2
    few = failed(capsys)
    assert (few.code, few.values["model"], few.values["object"]) == ("empirical.too_few_points", "dlt", 5)
    assert few.place.file.endswith("few.csv")
    assert main(["empirical", table(tmp_path / "r.csv", xyz, xy, ["chek"] * 5)]) == 2
    assert "[value.not_supported]" in capsys.readouterr().err
    (tmp_path / "none.csv").write_text("point,x_px,y_px\na,1,2\n")
    assert main(["empirical", str(tmp_path / "none.csv"), "--json"]) == 2
    needed = failed(capsys).text()
    assert all(name in needed for name in ("X", "Y", "Z", "lon_deg", "lat_deg", "h_m"))
    assert main(["empirical", str(tmp_path / "r.csv"), "--without", "K1"]) == 2


def test_geographic_points_are_taken_to_a_cartesian_frame(tmp_path, capsys):
    from raybundle.numerics.geodesy import LocalPlace

    xyz, xy = noisy("dlt", 40)
    ground = LocalPlace(origin=(8.0, 49.0, 200.0)).geographic_from_local(xyz)
    text = table(tmp_path / "g.csv", ground, xy)
    file = tmp_path / "g.csv"
    file.write_text(file.read_text().replace("X,Y,Z", "lon_deg,lat_deg,h_m"))
    found = reported(capsys, "empirical", text, "--image-sigma", 0.3, "--model", "dlt")
    assert values_of(found, ["notes"])["empirical.adequate"]["sigma_px"] == 0.3
