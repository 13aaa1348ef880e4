"""From photographs of targets and boards to a calibration with its verdict; what is wrong is said."""

import json
import re
import shutil

import cv2
import numpy as np
import pytest

from raybundle.block.stored import joint_covariance
from raybundle.cli.main import main
from raybundle.errors import InputError, phrase
from raybundle.io.block.folder import read_block
from raybundle.io.block.toml import read_cameras
from raybundle.workflows.calibrate import CalibrateOptions, calibrate
from raybundle.workflows.calibrating.recognise import recognised
from tests.conftest import DATA
from tests.messages import refused

BOARD = DATA / "calibration/opencv-chessboard/images"
CERN = DATA / "photos/cern-targets/images"
BARE = DATA / "photos/fountain-p11/images"
WANTED = CalibrateOptions(targets=("chessboard-9x6",))

needs_board = pytest.mark.skipif(not BOARD.is_dir(), reason=f"{BOARD} is absent")


@pytest.fixture(scope="module")
def board():
    return calibrate([BOARD], WANTED)


def changed(folder, change):
    """The photographs of the board, each changed by `change(number, image)`."""
    folder.mkdir()
    for k, path in enumerate(sorted(BOARD.glob("*.jpg"))):
        cv2.imwrite(str(folder / f"{path.stem}.png"), change(k, cv2.imread(str(path), cv2.IMREAD_GRAYSCALE)))
    return folder


@needs_board
def test_chessboard(board):
    """Limits: issue of the calibration; 0.183 px is what OpenCV reaches with a fitting window, c about 533 px."""
    a = board.adjustment
    used = a.image_observations.used
    v = a.image_observations.residuals_px[used]
    assert np.sqrt((v**2).sum(axis=1).mean()) <= 0.185
    camera = a.adjusted.cameras[0]
    c = camera.values["c"] / camera.pixel_mm[0]
    fx = c / (1 + camera.values["A"])
    assert (c + fx) / 2 == pytest.approx(533.0, abs=1.5)
    assert board.used == 13
    assert used.sum() > 690
    assert a.sigma0 == pytest.approx(1.0, abs=0.05)  # weights come from the residuals
    (q,) = board.quality
    assert q.reach < 0.8
    # points reach three quarters of the way to the corners: photographs that fill them bring most
    assert [a.ratio for a in q.advice] == sorted((a.ratio for a in q.advice), reverse=True)
    assert q.advice[0].ratio < 0.25
    assert "r5c8" in q.advice[0].words  # where to stand is told beside a photograph, what it must show by name
    assert "left08.jpg" in q.advice[0].words


@needs_board
@pytest.mark.parametrize(("spacing", "scale"), [("", "free"), ("2.5cm", "nominal")])
def test_lengths_are_in_the_unit_of_a_spacing_that_is_given(tmp_path, spacing, scale):
    words = ["calibrate", str(BOARD), "--target", "chessboard-9x6", "--out", str(tmp_path / "out"), "--jobs", "1"]
    assert main([*words, *(["--spacing", spacing] if spacing else [])]) == 0
    assert json.loads((tmp_path / "out/result.json").read_text())["scale"] == scale
    block = read_block(tmp_path / "out/block")
    assert (block.free_scale, block.nominal_scale) == (not spacing, bool(spacing))
    report = (tmp_path / "out/report.html").read_text()
    assert (phrase("limits.nominal_scale") in report) == bool(spacing)
    assert bool(re.search(r"\d units", report)) != bool(spacing)
    rows = dict(zip(block.points.ids, block.points.xyz, strict=True))
    flat = np.array([[int(n.split("c")[1]), int(n[1 : n.index("c")])] for n in rows]) * (25.0 if spacing else 1.0)
    size = [np.linalg.norm(np.array(x) - np.mean(x, axis=0)) for x in ([*rows.values()], flat)]
    assert size[0] / size[1] == pytest.approx(1, abs=1e-4)


@needs_board
def test_the_board_is_recognised(board):
    (found,) = recognised(board.photos).targets
    assert found.family == "chessboard-9x6"


@needs_board
def test_half_of_the_photographs_half_hidden(tmp_path):
    def hide(k, image):
        image = image.copy()
        if k % 2:
            image[:, : image.shape[1] // 2] = 90
        return image

    done = calibrate([changed(tmp_path / "half", hide)], WANTED)
    assert done.used + len(done.not_used) == 13
    assert len(done.not_used) >= 4
    assert all("chessboard" in why for _, why in done.not_used)


@needs_board
def test_two_boards_in_one_photograph(tmp_path):
    def twice(k, image):
        if k != 3:
            return image
        half = cv2.resize(image, None, fx=0.5, fy=0.5, interpolation=cv2.INTER_AREA)
        both = np.full_like(image, 128)
        both[:240, :320] = both[240:, 320:] = half
        return both

    done = calibrate([changed(tmp_path / "two", twice)], WANTED)
    assert done.used == 12
    ((name, why),) = done.not_used
    assert name == "left04.png"
    assert "target_seen.two_boards" in {m.code for m in why.messages}
    assert list(done.seconds) == ["photographs", "targets", "start", "adjustment", "verdict"]


@needs_board
@pytest.mark.parametrize("how", ["blurred", "overexposed"])
def test_spoiled_photographs_are_named(tmp_path, how):
    def spoil(_, image):
        if how == "blurred":
            return cv2.GaussianBlur(image, (0, 0), 9)
        return np.clip(image.astype(float) * 6 + 100, 0, 255).astype(np.uint8)

    with pytest.raises(InputError, match=r"(?s)0.*13.*6.*left01\.png.*calibration\.too_few_points"):
        calibrate([changed(tmp_path / "spoiled", spoil)], WANTED)


@needs_board
def test_wrong_size_of_the_board():
    with pytest.raises(InputError, match=r"(?s)6.*8.*calibration\.too_few_points"):
        calibrate([BOARD], CalibrateOptions(targets=("chessboard-8x6",)))


@needs_board
def test_one_photograph_is_too_few(tmp_path):
    shutil.copy(BOARD / "left01.jpg", tmp_path)
    with refused("calibration.too_few_photographs", n=1, least=3):
        calibrate([tmp_path], WANTED)


@pytest.mark.long
@needs_board
def test_zoom_moved_halfway(tmp_path):
    def zoom(k, image):
        if k < 6:
            return image
        h, w = image.shape
        M = np.array([[1.04, 0, -0.02 * w], [0, 1.04, -0.02 * h]])
        return cv2.warpAffine(image, M, (w, h), flags=cv2.INTER_CUBIC, borderMode=cv2.BORDER_REPLICATE)

    done = calibrate([changed(tmp_path / "zoom", zoom)], WANTED)
    first, second = done.adjustment.adjusted.cameras
    assert second.values["c"] / first.values["c"] == pytest.approx(1.04, abs=0.005)
    (told,) = [n for n in done.adjustment.notices if n.code == "two_cameras"]
    assert "left06.png" in told.text
    assert done.adjustment.given.images.camera.tolist() == [0] * 6 + [1] * 7


@needs_board
def test_a_mirrored_photograph_is_a_calibration_mirrored(tmp_path, board):
    done = calibrate([changed(tmp_path / "mirror", lambda _, image: image[:, ::-1])], WANTED)
    here, there = (d.adjustment.adjusted.cameras[0].values for d in (board, done))
    assert there["c"] == pytest.approx(here["c"], rel=1e-3)
    assert there["x0"] == pytest.approx(-here["x0"], abs=1e-3)


@needs_board
def test_command_line(tmp_path, capsys):
    out = tmp_path / "result"
    words = ["calibrate", str(BOARD), "--target", "chessboard-9x6", "--out", str(out), "--progress", "none"]
    assert main([*words, "--verbose"]) == 0
    said = capsys.readouterr().out
    assert "13 of 13 photographs" in said
    assert re.search(r"photograph 1\. .*\.: \S+ px", said)
    told = json.loads((out / "result.json").read_text())
    (verdict,) = told["calibration"].values()
    assert verdict["grade"] in {"good", "usable", "weak"}
    assert verdict["advice"][0]["ratio"] < 0.9
    assert told["images"] == {"given": 13, "oriented": 13, "not_oriented": []}
    (camera,) = read_cameras(out / "calibration.toml")
    free, covariance = joint_covariance(camera)
    assert camera.estimate == free == ("c", "x0", "y0", "K1", "K2", "K3", "P1", "P2", "A")
    assert np.sqrt(covariance[0, 0]) == pytest.approx(told["cameras"][camera.id]["c"]["std"], rel=1e-6)
    text = (out / "report.html").read_text()
    assert text.index('id="calibration"') < text.index('id="interior"')


@needs_board
def test_what_cannot_be(tmp_path, capsys):
    assert main(["calibrate", str(BOARD), "--target", "chessbord", "--out", str(tmp_path / "r")]) == 2
    assert "[target.unknown_family]" in capsys.readouterr().err
    with pytest.raises(InputError, match=r"browne.*camera\.calibration_model_unknown"):
        calibrate([BOARD], CalibrateOptions(model="browne"))
    with pytest.raises(InputError, match=r"board\.not_alone"):
        calibrate([BOARD], CalibrateOptions(targets=("chessboard-9x6", "aicon14")))


@pytest.mark.long
@pytest.mark.skipif(not BARE.is_dir(), reason=f"{BARE} is absent")
def test_photographs_without_targets_are_calibrated_by_natural_points(tmp_path):
    for path in sorted(BARE.iterdir())[3:7]:
        picture = cv2.imread(str(path))
        small = cv2.resize(picture, None, fx=0.25, fy=0.25, interpolation=cv2.INTER_AREA)
        cv2.imwrite(str(tmp_path / f"{path.stem}.png"), small)
    done = calibrate([tmp_path], CalibrateOptions())
    assert done.adjustment.notices[0].code == "no_targets"
    assert done.used == 4
    assert done.quality[0].grade != "good"


@pytest.mark.long
@pytest.mark.skipif(not CERN.is_dir(), reason=f"{CERN} is absent")
def test_coded_targets_and_two_cameras_mixed():
    """Photographs of two cameras, whose metadata do not tell them apart; MicMac's bundle has 0.0144 px."""
    photos = sorted(CERN.iterdir())
    chosen = [p for start in ("043", "671") for p in [q for q in photos if q.name.startswith(start)][:9]]
    done = calibrate(chosen, CalibrateOptions(targets=("aicon14",)))
    assert len(done.adjustment.adjusted.cameras) == 2
    assert any(n.code == "two_cameras" and "043" in n.text for n in done.adjustment.notices)
    assert {c.model for c in done.adjustment.adjusted.cameras} == {"brown_harmonic"}  # fourfold, the same in both
    assert all(0.005 < q.image_sigma_px < 0.0105 for q in done.quality)
    assert 0.005 < done.largest_eccentricity_px < 0.05
    apart = calibrate(chosen, CalibrateOptions(targets=("aicon14",), separate=("043_*", "671_*")))
    for a, b in zip(done.adjustment.adjusted.cameras, apart.adjustment.adjusted.cameras, strict=True):
        assert a.values["c"] == pytest.approx(b.values["c"], rel=1e-6)


@pytest.mark.long
def test_a_board_that_looks_the_same_when_turned_is_held(tmp_path):
    """8 x 6 inner corners, photographs of a pinhole camera of 620 px, some of them upside down."""
    square, px = 25.0, 4.0
    board = np.full((int(9 * square * px), int(11 * square * px)), 255, np.uint8)
    for r in range(7):
        for c in range(9):
            if (r + c) % 2 == 0:
                x, y = int((c + 1) * square * px), int((r + 1) * square * px)
                board[y : y + int(square * px), x : x + int(square * px)] = 0
    K = np.array([[620.0, 0, 319.5], [0, 620.0, 239.5], [0, 0, 1]])
    middle = np.array([5.5 * square, 4.5 * square, 0.0])
    for k, (a, t, roll) in enumerate(
        np.radians([(0, 30, 0), (60, 35, 180), (120, 30, 0), (180, 35, 180), (250, 32, 0), (310, 30, 90)])
    ):
        out = np.array([np.sin(t) * np.cos(a), np.sin(t) * np.sin(a), -np.cos(t)])
        z = -out
        x = np.cross([0.0, 1.0, 0.0], z)
        x /= np.linalg.norm(x)
        R = np.stack([x, np.cross(z, x), z])
        R = np.array([[np.cos(roll), -np.sin(roll), 0], [np.sin(roll), np.cos(roll), 0], [0, 0, 1]]) @ R
        X0 = middle + 420 * out
        H = K @ np.stack([R[:, 0], R[:, 1], -R @ X0], axis=1) @ np.diag([1 / px, 1 / px, 1.0])
        big = np.diag([4.0, 4.0, 1.0]) @ H
        view = cv2.warpPerspective(board, big, (2560, 1920), flags=cv2.INTER_AREA, borderValue=255)
        view = cv2.resize(cv2.GaussianBlur(view, (0, 0), 2.5), (640, 480), interpolation=cv2.INTER_AREA)
        cv2.imwrite(str(tmp_path / f"{k}.png"), np.clip(20 + 0.8 * view, 0, 255).astype(np.uint8))
    done = calibrate([tmp_path], CalibrateOptions(targets=("chessboard-8x6",), estimate=("c", "x0", "y0")))
    assert done.used == 6
    assert any(n.code == "board_alike" for n in done.adjustment.notices)
    camera = done.adjustment.adjusted.cameras[0]
    assert camera.values["c"] / camera.pixel_mm[0] == pytest.approx(620, abs=1.5)
    assert (np.asarray(done.adjustment.given.points.sigma) == 0).all()


@needs_board
def test_mirrored_photographs_among_others_are_named_and_left_out(tmp_path):
    folder = changed(tmp_path / "some", lambda k, image: image[:, ::-1] if k in {2, 5} else image)
    done = calibrate([folder], WANTED)
    assert [name for name, _ in done.not_used] == ["left03.png", "left06.png"]
    assert all(why.message.code == "not_oriented.contradicting_share" for _, why in done.not_used)
    assert done.used == 11
    c = done.adjustment.adjusted.cameras[0].values["c"] / done.adjustment.adjusted.cameras[0].pixel_mm[0]
    assert c == pytest.approx(534.6, abs=1.0)


@needs_board
def test_fewer_than_five_photographs_have_the_caution_of_orient(board):
    """White noise of so few is not chosen for being right; with five or more it is estimated, and nothing said."""
    done = calibrate(sorted(BOARD.glob("*.jpg"))[:4], WANTED)
    (told,) = [n for n in done.adjustment.notices if n.code == "errors_independent"]
    assert told.severity == "warning"
    assert (told.values["images"], told.values["least"]) == (4, 5)
    assert not [n for n in board.adjustment.notices if n.code == "errors_independent"]
