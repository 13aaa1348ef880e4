"""Scans of film: fiducial marks clicked, and the photographs oriented from marks in the scans."""

from dataclasses import replace

import numpy as np
import pytest
from click.testing import CliRunner
from PIL import Image

import raybundle as rb
from raybundle.cli.main import cli
from raybundle.errors import InputError
from raybundle.io.calibrations.ours import cameras_text
from raybundle.io.film.fiducials import film_of, read_calibrated
from raybundle.measuring.actions.verbs import Fiducial
from raybundle.measuring.film import read_scans
from raybundle.measuring.merge import merge
from raybundle.measuring.start import begun
from raybundle.measuring.state import folded

from .hand_made import PIXEL_MM, Scene, normalised

NAMES = [f"F{k + 1}" for k in range(8)]
MARKS = np.array([[-1, 0], [1, 0], [0, 1], [0, -1], [-1, -1], [1, 1], [-1, 1], [1, -1]]) * [17.4, 11.4]
SCANNER_MM = 0.011
SIZE = (3600, 2600)


def scanned(camera, xy_px, image):
    """Where points of the camera [px] are in a scan [px]: turned, shifted, the film shrunk by 400 ppm in x."""
    xy = camera.image_from_pixel(np.atleast_2d(xy_px)) * [1 - 400e-6, 1 + 150e-6]
    t = np.radians(1.3 - 0.8 * image)
    return xy @ [[np.cos(t), np.sin(t)], [-np.sin(t), np.cos(t)]] / SCANNER_MM * [1, -1] + [1790 + 7 * image, 1310]


@pytest.fixture
def archive(tmp_path):
    """Scene, folder of scans, and the files of the certificate."""
    scene = Scene(stations=3, points=10)
    folder = tmp_path / "archive"
    folder.mkdir()
    for k, name in enumerate(scene.images):
        Image.new("L", SIZE, 100 + k).save(folder / name)
    lines = [f"{n},{x},{y}" for n, (x, y) in zip(NAMES, MARKS.tolist(), strict=True)]
    (tmp_path / "certificate.csv").write_text("\n".join(["mark,x_mm,y_mm", *lines]) + "\n")
    (tmp_path / "camera.toml").write_text(cameras_text([replace(scene.camera, id="rmk", estimate=())]))
    project = rb.begin(
        folder, film=tmp_path / "certificate.csv", calibration=tmp_path / "camera.toml", pixel_mm=SCANNER_MM
    )
    return scene, folder, project


def fiducials(scene, image, rng, names=NAMES, wrong=None):
    made = []
    for name in names:
        at = scanned(scene.camera, scene.camera.pixel_from_image(MARKS[NAMES.index(name)][None]), image)[0]
        x, y = at + rng.normal(0, 0.2, 2) + ((6.0, 0.0) if name == wrong else (0.0, 0.0))
        made.append(Fiducial(image=scene.images[image], name=name, x_px=float(x), y_px=float(y)))
    return made


def click(scene, folder, image, point, rng):
    x, y = scanned(scene.camera, scene.place(image, point), image)[0] + rng.normal(0, 0.5, 2)
    if np.isfinite(x):
        rb.mark(
            folder, "put", image=scene.images[image], point=scene.names[point], x_px=float(x), y_px=float(y)
        )  # fmt: skip


def test_scans_end_in_a_block(archive):
    """Distances are true within their sigmas; the interior orientation is that of `film_of`."""
    scene, folder, project = archive
    rng = np.random.default_rng(1)
    for image in range(3):
        for f in fiducials(scene, image, rng):
            rb.mark(folder, f.verb, **{k: v for k, v in f.arguments.items() if v is not None})
        for point in range(10):
            click(scene, folder, image, point, rng)
    a, b = scene.names[:2]
    rb.mark(folder, "bar", start=a, end=b, length=scene.distance(a, b), sigma=0.001)
    result, left = rb.adjust_marks(folder)
    assert left == {}
    assert 0.6 < result.sigma0 < 1.5
    assert (normalised(result, scene.xyz, scene.names) ** 2).mean() < 3.5
    state, calibrated = rb.marks(folder), read_calibrated(project / "film" / "certificate.csv")
    marks = state.fiducials_in(scene.images[1])
    film = film_of(
        scene.images[1], [*marks], np.array([[m.x_px, m.y_px] for m in marks.values()]), np.full((8, 2), 0.2),
        calibrated, pixel_mm=SCANNER_MM,
    )  # fmt: skip
    o, b = result.given.observations, result.given
    for name, mark in state.marks_in(scene.images[1]).items():
        (row,) = np.flatnonzero((o.image == 1) & (o.point == b.points.ids.index(name)))
        straight = scene.camera.pixel_from_image(film.image_from_pixel(np.array([[mark.x_px, mark.y_px]])))[0]
        np.testing.assert_allclose(o.xy_px[row], straight, atol=1e-6)
        assert o.cov_px2[row, 0] == pytest.approx((0.5 * SCANNER_MM / PIXEL_MM) ** 2, rel=0.01)
    done = CliRunner().invoke(cli, ["mark", "adjust", str(folder), "--no-report"], standalone_mode=False)
    assert done.exception is None
    again = rb.read_block(project / "result" / "block")
    assert again.images.frames == result.given.images.frames
    listed = CliRunner().invoke(cli, ["mark", "list", str(folder)], standalone_mode=False).output
    assert "F1" in listed


def test_what_is_lacking_and_wrong_of_fiducials_is_said(archive):
    scene, _, project = archive
    rng = np.random.default_rng(2)
    block, scans = rb.read_block(project / "block"), read_scans(project)
    two = folded(fiducials(scene, 0, rng, NAMES[:2]))
    lack = merge(block, two, scans).lacking[0]
    assert lack.message.code == "photograph.lacks_fiducials"
    assert (lack.image, lack.have) == ("old_1.jpg", 2)
    oriented, following = begun(block, two, scans).standing.line.messages
    assert oriented.values == {"n": 0, "of": 3}
    assert following.values == {"kind": "fiducials", "image": "old_1.jpg", "other": "", "n": 1}
    wrong = folded(fiducials(scene, 0, rng, wrong="F6"))
    (told,) = merge(block, wrong, scans).film
    assert told.message.code == "measuring.suspect_fiducials"
    assert told.message.values["image"] == "old_1.jpg"
    assert told.message.values["marks"][0].startswith("F6 ")


def test_fiducials_are_refused_with_a_reason(archive, tmp_path):
    scene, folder, project = archive
    image = scene.images[0]
    with pytest.raises(InputError, match=r"F9.*F1.*fiducial\.not_calibrated"):
        rb.mark(folder, "fiducial", image=image, name="F9", x_px=1.0, y_px=1.0)
    with pytest.raises(InputError, match=r"fiducial\.not_measured"):
        rb.mark(folder, "fiducial", image=image, name="F1")
    with pytest.raises(InputError, match=r"fiducial\.one_coordinate"):
        rb.mark(folder, "fiducial", image=image, name="F1", x_px=1.0)
    with pytest.raises(InputError, match=r"mark\.outside_image"):
        rb.mark(folder, "fiducial", image=image, name="F1", x_px=4000.0, y_px=1.0)
    rb.mark(folder, "fiducial", image=image, name="F1", x_px=3.0, y_px=1.0)
    rb.mark(folder, "fiducial", image=image, name="F1", x_px=5.0, y_px=1.0)
    assert rb.marks(folder).fiducials[image, "F1"].x_px == 5.0
    rb.mark(folder, "undo")
    assert rb.marks(folder).fiducials[image, "F1"].x_px == 3.0
    rb.mark(folder, "fiducial", image=image, name="F1")
    assert rb.marks(folder).fiducials == {}
    with pytest.raises(InputError, match=r"film\.camera_missing"):
        rb.begin(folder, tmp_path / "other", film=tmp_path / "certificate.csv")
    plain = tmp_path / "plain"
    plain.mkdir()
    Image.new("L", SIZE, 1).save(plain / "a.jpg")
    with pytest.raises(InputError, match=r"fiducial\.no_film"):
        rb.mark(plain, "fiducial", image="a.jpg", name="F1", x_px=1.0, y_px=1.0)
    assert rb.begin(folder) == project
    assert read_scans(project).pixel_mm == SCANNER_MM
    assert rb.read_block(project / "block").images.frames[0].affine is not None


def drawn(scene, image):
    """A scan with dots at the fiducial marks."""
    grey = np.full((SIZE[1], SIZE[0]), 60, np.uint8)
    for at in scanned(scene.camera, scene.camera.pixel_from_image(MARKS), image):
        yy, xx = np.mgrid[int(at[1]) - 20 : int(at[1]) + 21, int(at[0]) - 20 : int(at[0]) + 21]
        inside = np.clip(8.5 - np.hypot(xx + 0.5 - at[0], yy + 0.5 - at[1]), 0, 1)
        grey[yy, xx] = np.round(60 + 160 * inside).astype(np.uint8)
    return grey


def test_the_other_fiducials_are_found(archive):
    """Three are measured, four are found to a few hundredths of a pixel; one that is not there is named."""
    scene, folder, project = archive
    grey = drawn(scene, 0)
    true = scanned(scene.camera, scene.camera.pixel_from_image(MARKS), 0)
    x, y = true[6].astype(int)
    grey[y - 30 : y + 30, x - 30 : x + 30] = 60
    Image.fromarray(grey).save(folder / scene.images[0], quality=97)
    image = scene.images[0]
    with pytest.raises(InputError, match=r"0.*3.*fiducial\.too_few"):
        rb.find_fiducials(folder, image)
    for k in (4, 5, 7):
        rb.mark(folder, "fiducial", image=image, name=NAMES[k], x_px=float(true[k, 0]), y_px=float(true[k, 1]))
    left = rb.find_fiducials(folder, image)
    assert set(left) == {"F7"}, left
    found = rb.marks(folder).fiducials_in(image)
    assert set(found) == set(NAMES) - {"F7"}
    off = [np.hypot(*(np.array([m.x_px, m.y_px]) - true[NAMES.index(n)])) for n, m in found.items()]
    assert max(off) < 0.1
    assert all(m.how == "ellipse" for n, m in found.items() if n not in {"F5", "F6", "F8"})
    assert rb.find_fiducials(project, image).keys() == {"F7"}


def test_scans_stand_in_a_block_folder_whole_or_not_at_all(archive):
    _, _, project = archive
    table = project / "block" / "images.csv"
    head, first, *rest = table.read_text(encoding="utf-8").splitlines()
    cells = first.split(",")
    cells[head.split(",").index("scan_xy")] = ""
    table.write_text("\n".join([head, ",".join(cells), *rest]) + "\n", encoding="utf-8")
    with pytest.raises(InputError, match=r"scan_xx.*old_1\.jpg.*image\.scan_incomplete") as caught:
        rb.read_block(project / "block")
    assert caught.value.line == 2
