"""What was photographed is found out from rendered boards and from real photographs."""

from pathlib import Path

import cv2
import numpy as np
import pytest

from raybundle.errors import InputError
from raybundle.io.photos.photo import find_photos
from raybundle.targets.families import families
from raybundle.targets.family_recognition import SeenTags, charuco_of, smallest
from raybundle.targets.layout import SheetOptions, design
from raybundle.targets.layout_boards import design_board, design_tags
from raybundle.targets.marks import target
from raybundle.targets.sheets import write_sheet
from raybundle.workflows.calibrate import calibrate
from raybundle.workflows.calibrating.recognise import recognised
from raybundle.workflows.calibrating.stages.natural import _no_targets
from raybundle.workflows.orient import orient
from tests.conftest import DATA
from tests.targets.test_sheets import raster

VIEWS = (
    np.array([[0.55, 0.12, 90], [-0.1, 0.5, 150], [1.2e-4, 8e-5, 1]]),
    np.array([[0.6, -0.05, 130], [0.08, 0.52, 60], [-5e-5, 1.5e-4, 1]]),
)


def seen(folder, sheet, views=VIEWS, hide=None):
    """Photographs of a sheet."""
    write_sheet(sheet, folder / "sheet.svg")
    flat = cv2.GaussianBlur(raster(folder / "sheet.svg"), (0, 0), 1.2)
    shots = folder / "photographs"
    shots.mkdir()
    for k, H in enumerate(views):
        image = cv2.warpPerspective(flat, H, (840, 840), borderValue=255)
        if hide is not None:
            image[hide] = 150
        cv2.imwrite(str(shots / f"{k}.png"), image)
    return find_photos([shots]).photos


@pytest.mark.parametrize(
    ("family", "spacing"),
    [
        ("charuco-8x6-5x5_50", 23),
        ("charuco-7x5-apriltag_36h11", 26),
        ("charuco-5x7-4x4_50-0.6", 30),
        ("circles-7x5", 24),
        ("acircles-4x11", 18),
        ("acircles-5x7", 18),
        ("chessboard-9x6", 18),
        ("chessboard-13x9", 13),
    ],
)
def test_boards_of_any_size(tmp_path, family, spacing):
    photos = seen(tmp_path, design_board(target(family), spacing, SheetOptions(dot_radius_mm=4)))
    assert [t.family for t in recognised(photos).targets] == [family]


@pytest.mark.parametrize("family", ["aruco-6x6_50", "apriltag-25h9", "apriltag-36h11"])
def test_tags(tmp_path, family):
    numbers = [3, 1, 7, 20, 12, 5]  # in no order of a board
    photos = seen(tmp_path, design_tags(target(family), numbers, 50.0, SheetOptions()))
    assert [t.family for t in recognised(photos).targets] == [family]


@pytest.mark.parametrize("family", ["aicon14", "agisoft14"])
def test_families_that_share_codes_are_told_by_their_rings(tmp_path, family):
    shared = [c for c in families["aicon14"].codes.tolist() if c in set(families["agisoft14"].codes.tolist())][:12]
    f = families[family]
    photos = seen(tmp_path, design(f, np.sort(f.id_of(np.array(shared))), SheetOptions(dot_radius_mm=5)))
    assert [t.family for t in recognised(photos).targets] == [family]


def test_nothing_known(tmp_path):
    rng = np.random.default_rng(1)
    for k in range(2):
        cv2.imwrite(str(tmp_path / f"{k}.png"), rng.normal(120, 20, (300, 400)).clip(0, 255).astype(np.uint8))
    assert recognised(find_photos([tmp_path]).photos).targets == ()


@pytest.mark.long
def test_targets_on_too_few_of_the_photographs_are_named(tmp_path):
    f = families["aicon14"]
    photos = seen(tmp_path, design(f, np.sort(f.id_of(f.codes[:12])), SheetOptions(dot_radius_mm=5)), VIEWS[:1])
    rng = np.random.default_rng(1)
    for k in range(1, 3):
        plain = rng.normal(120, 20, (840, 840)).clip(0, 255).astype(np.uint8)
        cv2.imwrite(str(tmp_path / "photographs" / f"{k}.png"), plain)
    shown = recognised(find_photos([photos[0].path.parent]).photos)
    assert shown.targets == ()
    assert "aicon14" in shown.few
    assert shown.looked_at == ("0.png", "1.png", "2.png")
    found = _no_targets(shown).data
    assert (found.code, found.values["n"], found.values["names"]) == ("no_targets.few", 3, list(shown.looked_at))
    assert found.values["first"] == shown.few[0]


def test_a_folder_above_the_photographs_is_said(tmp_path):
    above = tmp_path / "above"
    (above / "images").mkdir(parents=True)
    for attempt in (lambda: calibrate([above]), lambda: orient([above], tmp_path / "project")):
        with pytest.raises(InputError, match=r"(?s)\(images\).*(too_few_photographs|too_few_usable)"):
            attempt()


def test_a_board_that_is_not_seen_whole_must_be_named(tmp_path):
    """Cut off at different places, it looks like another board in each photograph."""
    sheet = design_board(target("chessboard-13x9"), 13, SheetOptions())
    views = [np.array([[0.9, 0, -x], [0, 0.9, -y], [0, 0, 1.0]]) for x, y in ((70, 330), (150, 420))]
    photos = seen(tmp_path, sheet, views)
    with pytest.raises(InputError, match=r'target="chessboard-9x6".*target\.board_ambiguous'):
        recognised(photos)


def test_tags_that_are_no_board():
    rng = np.random.default_rng(3)
    square = np.array([[0, 0], [1, 0], [1, 1], [0, 1]])
    loose = SeenTags(id=np.arange(9), corners=rng.uniform(0, 300, (9, 1, 2)) + 30 * square)
    assert charuco_of("aruco-5x5_1000", [loose]) is None
    assert smallest("aruco-5x5_1000", 49) == "aruco-5x5_50"
    assert smallest("aruco-5x5_1000", 50) == "aruco-5x5_100"
    assert smallest("apriltag-36h11", 3) == "apriltag-36h11"


@pytest.mark.data
@pytest.mark.parametrize(
    ("folder", "family"),
    [
        pytest.param("photos/cern-targets/images", "aicon14", marks=pytest.mark.long),
        ("calibration/camcal-photos/images", "photomodeler-sheet"),
        ("calibration/opencv-chessboard/images", "chessboard-9x6"),
    ],
)
def test_photographs(folder, family):
    if not Path(DATA / folder).is_dir():
        pytest.skip(f"no {folder}: set RAYBUNDLE_DATA")
    assert [t.family for t in recognised(find_photos([DATA / folder]).photos).targets] == [family]
