"""Scanned film: shrinkage and a turned scan recovered within their sigma, reseau, certificate, command, bad input."""

from dataclasses import replace

import numpy as np
import pytest
from click.testing import CliRunner
from tests.messages import coded

from raybundle.cli.film import command
from raybundle.errors import InputError
from raybundle.io.block.toml import read_cameras
from raybundle.io.calibrations.ours import cameras_text
from raybundle.io.film.certificate import Certificate, certificate_camera
from raybundle.io.film.fiducials import (
    Calibrated,
    Marks,
    film_of,
    read_calibrated,
    read_marks,
    reseau_correction,
    straight_points,
    suspects,
)
from raybundle.planning.synthetic_networks import brown_camera

PIXEL = 0.0125
EIGHT = np.array([[-106, 0], [106, 0], [0, 106], [0, -106], [-106, -106], [106, 106], [-106, 106], [106, -106]], float)
NAMES = tuple(f"F{k + 1}" for k in range(8))
FIDUCIALS = Calibrated(names=NAMES, xy_mm=EIGHT, sigma_mm=np.full((8, 2), 0.002))
SHRINKAGE = (350e-6, -120e-6)
SHEAR, TURN = np.radians(0.004), np.radians(1.7)


def scanned(xy_mm, *, shrinkage=SHRINKAGE, shear=SHEAR, turn=TURN, tilt=(0.0, 0.0), mirrored=False, shift=(9500, 9300)):
    """Pixels of a scan of shrunk, sheared, turned film: written down once more, by its own formula."""
    xy = np.asarray(xy_mm, float)
    ax = (1 - shrinkage[0]) * np.array([np.cos(turn), np.sin(turn)])
    ay = (1 - shrinkage[1]) * np.array([-np.sin(turn + shear), np.cos(turn + shear)])
    film = xy[:, :1] * ax + xy[:, 1:] * ay
    film = film / (1 + film @ np.asarray(tilt))[:, None]
    return film / PIXEL * [-1 if mirrored else 1, -1] + shift


def film(model="affine", seed=1, sigma=0.1, names=NAMES, **how):
    rng = np.random.default_rng(seed)
    at = [NAMES.index(n) for n in names]
    true = EIGHT + rng.normal(0, 1, EIGHT.shape) * FIDUCIALS.sigma_mm
    xy = scanned(true[at], **how) + rng.normal(0, sigma, (len(at), 2))
    return film_of("s", names, xy, np.full((len(at), 2), max(sigma, 1e-3)), FIDUCIALS, pixel_mm=PIXEL, model=model)


@pytest.mark.parametrize(
    ("model", "how"),
    [
        ("similarity", {"shrinkage": (200e-6, 200e-6), "shear": 0.0}),
        ("affine", {}),
        ("affine", {"mirrored": True}),
        ("affine", {"turn": np.radians(91.0)}),
        ("projective", {"tilt": (2e-6, -1e-6)}),
    ],
)
def test_points_come_back_within_their_sigma(model, how):
    """Normalised squared errors of a point of the image against chi-square with 2 degrees, over 200 scans."""
    point = np.array([[40.0, -70.0]])
    squares, sigma0 = [], []
    for seed in range(200):
        f = film(model, seed, **how)
        error = (f.image_from_pixel(scanned(point, **how)) - point)[0]
        squares.append(error @ np.linalg.solve(f.covariance_of(scanned(point, **how))[0], error))
        sigma0.append(f.sigma0**2)
        assert f.mirrored == how.get("mirrored", False)
    # the mean of 200 values of variance 4: 2 +- 0.14; three sigma
    assert np.mean(squares) == pytest.approx(2, abs=0.45)
    assert np.mean(sigma0) == pytest.approx(1, abs=0.15)


def test_shrinkage_shear_and_turn_are_reported_within_their_sigma():
    truth = np.array([*SHRINKAGE, SHEAR, TURN])
    normalised = []
    for seed in range(200):
        s = film(seed=seed).shrinkage
        normalised.append((s.values - truth) / s.std)
    assert np.sqrt(np.mean(np.square(normalised), axis=0)) == pytest.approx(np.ones(4), abs=0.2)
    assert film().shrinkage.std[0] < 50e-6
    exact = film(sigma=0.0, names=NAMES)
    np.testing.assert_allclose(exact.shrinkage.values, truth, atol=6e-5)  # the marks' own 2 micrometres


def test_a_similarity_does_not_see_shear_but_says_it_does_not_fit():
    plain = film("similarity", sigma=0.05)
    assert plain.sigma0 > 3
    assert plain.shrinkage.values[0] == pytest.approx(plain.shrinkage.values[1], abs=1e-12)
    assert plain.shrinkage.values[2] == pytest.approx(0, abs=1e-12)
    assert film("affine", sigma=0.05).sigma0 < 2


def test_a_wrong_mark_is_named():
    xy = scanned(EIGHT)
    xy[3] += [4.0, 0.0]
    f = film_of("s", NAMES, xy, np.full((8, 2), 0.1), FIDUCIALS, pixel_mm=PIXEL)
    assert suspects(f)[0].startswith("F4 (w = ")
    assert suspects(film()) == ()


def crosses():
    g = np.linspace(-100, 100, 11)
    x, y = np.meshgrid(g, g)
    return np.stack([x.ravel(), y.ravel()], axis=1)


def waves(xy):
    """A deformation that no affine takes up [mm]."""
    return 0.03 * np.stack([np.sin(xy[:, 0] / 40) * np.cos(xy[:, 1] / 50), np.cos(xy[:, 0] / 45)], axis=1)


@pytest.mark.parametrize("method", ["bilinear", "affine"])
def test_a_reseau_corrects_local_deformation(method):
    marks = crosses()
    names = tuple(str(k) for k in range(len(marks)))
    reseau = Calibrated(names=names, xy_mm=marks, sigma_mm=np.zeros_like(marks))
    xy = scanned(marks + waves(marks))
    f = film_of("s", names, xy, np.full(marks.shape, 0.1), reseau, pixel_mm=PIXEL, reseau=method)
    rng = np.random.default_rng(1)
    points = rng.uniform(-110, 110, (300, 2))  # some beyond the outer crosses
    measured = scanned(points + waves(points))
    inside = np.abs(points).max(axis=1) < 95
    left = np.linalg.norm(f.image_from_pixel(measured) - points, axis=1)
    plain = replace(f, reseau="none")
    before = np.linalg.norm(plain.image_from_pixel(measured) - points, axis=1)
    assert np.sqrt(np.mean(before[inside] ** 2)) > 0.015
    assert np.sqrt(np.mean(left[inside] ** 2)) < 0.002
    assert left.max() < 0.012
    # at the crosses themselves the bilinear correction is exact
    if method == "bilinear":
        np.testing.assert_allclose(f.image_from_pixel(xy), marks, atol=1e-9)


def test_a_missing_cross_is_bridged():
    marks = crosses()
    kept = np.delete(np.arange(len(marks)), 60)
    c = -waves(marks)
    at = np.array([[2.0, 3.0]])  # in the mesh of the missing cross
    found = reseau_correction(at, marks[kept], c[kept], "bilinear")
    np.testing.assert_allclose(found, -waves(at), atol=0.003)
    with pytest.raises(InputError, match=r"3.*film\.too_few_crosses"):
        reseau_correction(at, marks[:3], c[:3], "bilinear")


def test_the_certificate_becomes_a_camera():
    radii = (40.0, 80.0, 120.0, 148.0)
    K1, K2 = 2.1e-8, -6e-13
    table = tuple(-1000 * (K1 * r**3 + K2 * r**5) for r in radii)  # positive outwards: the correction is inwards
    given = Certificate(
        id="RC", c_mm=153.2, format_mm=(230, 230), symmetry_mm=(0.006, -0.011), autocollimation_mm=(0.001, -0.004),
        radius_mm=radii, distortion_um=table,
    )  # fmt: skip
    camera, remarks = certificate_camera(given, pixel_mm=PIXEL)
    assert camera.values["K1"] == pytest.approx(K1, rel=1e-6)
    assert camera.values["K2"] == pytest.approx(K2, rel=1e-6)
    assert (camera.values["x0"], camera.width_px, camera.estimate) == (0.006, 18400, ())
    assert coded(remarks)["film.principal_points_differ"]["difference_um"] == pytest.approx(8.6, abs=0.05)
    with pytest.raises(InputError, match=r"2.*1.*certificate\.distortion_table"):
        certificate_camera(replace(given, radius_mm=(1.0, 2.0), distortion_um=(1.0,)), pixel_mm=PIXEL)


def test_points_reach_the_frame_of_the_block():
    """A point measured in a turned scan lands where the ideal camera has it, with its covariance turned."""
    camera, _ = certificate_camera(Certificate(id="RC", c_mm=153.2, format_mm=(230, 230)), pixel_mm=PIXEL)
    image_mm = np.array([[50.0, 20.0], [-90.0, 101.0]])
    turn = np.radians(90.0)
    f = film(sigma=0.0, turn=turn)
    points = Marks(
        image=("s", "s"), name=("1", "2"), xy_px=scanned(image_mm, turn=turn), sigma_px=np.array([[0.3, 0.1]] * 2)
    )
    straight, cov = straight_points(points, {"s": f}, camera)
    np.testing.assert_allclose(camera.image_from_pixel(straight.xy_px), image_mm, atol=0.01)
    np.testing.assert_allclose(np.sqrt(cov[:, :2]), [[0.1, 0.3]] * 2, rtol=2e-3)
    with pytest.raises(InputError, match=r"film\.no_marks"):
        straight_points(replace(points, image=("s", "t")), {"s": f}, camera)


@pytest.mark.parametrize(
    ("names", "model", "words"),
    [
        (("F1", "F2"), "affine", r"2.*3.*film\.too_few_marks"),
        (("F1", "F2", "F3"), "projective", r"4.*film\.too_few_marks"),
    ],
)
def test_too_few_marks_are_refused(names, model, words):
    with pytest.raises(InputError, match=words):
        film(model, names=names)


def test_marks_on_one_line_are_refused():
    line = Calibrated(
        names=("a", "b", "c"), xy_mm=np.array([[-1.0, 0], [0, 0], [1, 0]]) * 100, sigma_mm=np.zeros((3, 2))
    )
    with pytest.raises(InputError, match=r"film\.marks_in_line"):
        film_of("s", line.names, scanned(line.xy_mm), np.full((3, 2), 0.1), line, pixel_mm=PIXEL)


@pytest.fixture
def files(tmp_path):
    rng = np.random.default_rng(1)
    (tmp_path / "certificate.csv").write_text(
        "mark,x_mm,y_mm\n" + "".join(f"{n},{x},{y}\n" for n, (x, y) in zip(NAMES, EIGHT, strict=True))
    )
    marks = scanned(EIGHT) + rng.normal(0, 0.1, (8, 2))
    rows = [f"a.tif,{n},{x},{y},0.1,0.1\n" for n, (x, y) in zip(NAMES, marks, strict=True)]
    (tmp_path / "marks.csv").write_text("image,mark,x_px,y_px,sx_px,sy_px\n" + "".join(rows))
    points = scanned(np.array([[50.0, 20.0], [-90.0, 101.0]]))
    rows = [f"a.tif,{k},{x},{y}\n" for k, (x, y) in enumerate(points)]
    (tmp_path / "points.csv").write_text("image,point,x_px,y_px\n" + "".join(rows))
    camera, _ = certificate_camera(Certificate(id="RC", c_mm=153.2, format_mm=(230, 230)), pixel_mm=PIXEL)
    (tmp_path / "camera.toml").write_text(cameras_text([camera]))
    return tmp_path


def run(files, *more):
    words = [
        "marks.csv",
        "--calibrated",
        "certificate.csv",
        "--calibration",
        "camera.toml",
        "--image-points",
        "points.csv",
    ]
    given = [str(files / w) if "." in w else w for w in words]
    return CliRunner().invoke(command, [*given, "--out", str(files / "film"), *more])


def test_the_command_writes_what_a_block_takes(files):
    result = run(files)
    assert result.exit_code == 0, result.output
    assert "1 scan" in result.output
    assert "2 image points" in result.output
    camera = read_cameras(files / "film/cameras.toml")[0]
    lines = (files / "film/observations.csv").read_text().splitlines()
    assert lines[0] == "image,point,x_px,y_px,sx_px,sy_px,sxy_px2"
    xy = np.array([[float(v) for v in line.split(",")[2:4]] for line in lines[1:]])
    np.testing.assert_allclose(camera.image_from_pixel(xy), [[50, 20], [-90, 101]], atol=0.005)
    head, row = (line.split(",") for line in (files / "film/film.csv").read_text().splitlines())
    film_row = dict(zip(head, row, strict=True))
    assert float(film_row["shrinkage_x_ppm"]) == pytest.approx(350, abs=4 * float(film_row["sshrinkage_x_ppm"]))
    assert len((files / "film/residuals.csv").read_text().splitlines()) == 9
    again = run(files)
    assert isinstance(again.exception, InputError)
    assert again.exception.code == "folder.exists"


@pytest.mark.parametrize(
    ("file", "old", "new", "words"),
    [
        ("marks.csv", "F3", "F9", r"4.*F9.*film\.mark_not_calibrated"),
        ("marks.csv", "F3", "F2", r"4.*3.*table\.pair_twice"),
        ("marks.csv", ",0.1\n", ",x\n", r"2.*sy_px.*cell\.not_a_number"),
        ("certificate.csv", "F4,0.0", "F4,nan", r"5.*x_mm.*value\.not_finite"),
        ("certificate.csv", "mark,x_mm", "mark,x", r"table\.unknown_column"),
        ("certificate.csv", "F4,0.0,-106", "F4,0.0,-106000", r"5.*x_mm.*film\.mark_outside_camera"),
        ("points.csv", "a.tif,1,", "a.tif,1,99999", r"3.*x_px.*film\.position_outside_scan"),
        ("points.csv", "a.tif,1", "b.tif,1", r"b\.tif.*film\.no_marks"),
        ("camera.toml", "c_mm = 153.2", "c_mm = -1", "c_mm"),
    ],
)
def test_bad_files_are_named(files, file, old, new, words):
    text = (files / file).read_text()
    assert old in text
    (files / file).write_text(text.replace(old, new, 1))
    with pytest.raises(InputError, match=words):
        raise run(files).exception


def test_defaults_of_marks(files):
    assert read_calibrated(files / "certificate.csv").sigma_mm.max() == 0
    assert read_marks(files / "points.csv", "point").sigma_px.min() == 0.2
    assert brown_camera().model == "brown"


def exchanged(i, j, names=NAMES, **how):
    xy = scanned(EIGHT, **how)
    xy[[i, j]] = xy[[j, i]]
    at = [NAMES.index(n) for n in names]
    return names, xy[at], np.full((len(at), 2), 0.2), FIDUCIALS


@pytest.mark.parametrize("model", ["similarity", "affine", "projective"])
@pytest.mark.parametrize("how", [{}, {"mirrored": True}, {"turn": np.radians(91.0)}])
@pytest.mark.parametrize("pair", [(0, 1), (2, 5), (4, 7)])
def test_exchanged_marks_are_named(model, how, pair):
    a, b = (NAMES[k] for k in pair)
    with pytest.raises(InputError, match=r"film\.marks_implausible|film\.no_transformation") as caught:
        film_of("s", *exchanged(*pair, **how), pixel_mm=PIXEL, model=model)
    blame = caught.value.message.details[-1]
    assert (blame.code, blame.values["pairs"][0]) == ("film.marks_exchanged", f"{a} - {b}")


def test_three_marks_tell_by_the_shape_of_the_film():
    with pytest.raises(InputError, match=r"film\.marks_implausible") as caught:
        film_of("s", *exchanged(0, 2, names=("F1", "F3", "F5")), pixel_mm=PIXEL)
    assert "F1 - F3" in caught.value.message.details[-1].values["pairs"]


def test_a_mark_far_off_is_named():
    xy = scanned(EIGHT)
    xy[6] += [900.0, 0.0]
    with pytest.raises(InputError, match=r"film\.marks_implausible") as caught:
        film_of("s", NAMES, xy, np.full((8, 2), 0.2), FIDUCIALS, pixel_mm=PIXEL)
    blame = caught.value.message.details[-1]
    assert (blame.code, blame.values["mark"]) == ("film.wrong_mark", "F7")
    assert blame.values["offset_mm"] == pytest.approx(11.3, abs=0.05)
    rng = np.random.default_rng(3)
    with pytest.raises(InputError, match=r"film\.marks_implausible") as caught:
        film_of("s", NAMES, xy[rng.permutation(8)], np.full((8, 2), 0.2), FIDUCIALS, pixel_mm=PIXEL)
    assert caught.value.message.details[-1].code == "film.several_wrong_marks"


def test_standard_deviations_grow_with_sigma0():
    """Marks measured ten times worse than stated: the stated sigma of the shrinkage covers its error all the same."""
    normalised = []
    for seed in range(100):
        xy = scanned(EIGHT) + np.random.default_rng(seed).normal(0, 1.0, (8, 2))
        f = film_of("s", NAMES, xy, np.full((8, 2), 0.1), FIDUCIALS, pixel_mm=PIXEL)
        assert f.misfit == f.sigma0 > 2
        normalised.append((f.shrinkage.values[0] - SHRINKAGE[0]) / f.shrinkage.std[0])
    assert np.sqrt(np.mean(np.square(normalised))) == pytest.approx(1.05, abs=0.25)  # t with 10 degrees of freedom
    assert film().misfit == 1


def test_the_command_writes_nothing_for_exchanged_marks(files):
    text = (files / "marks.csv").read_text()
    (files / "marks.csv").write_text(text.replace(",F1,", ",Fx,").replace(",F2,", ",F1,").replace(",Fx,", ",F2,"))
    result = run(files)
    assert isinstance(result.exception, InputError)
    assert "F1 - F2" in str(result.exception)
    assert "[film.scans_not_transformed]" in str(result.exception)
    assert not (files / "film").exists()


def test_a_wrong_pixel_of_the_scanner_is_noticed(files):
    assert "[film.shrinkage]" in run(files, "--pixel-mm", "0.025").output
