"""The stages of `calibrate`: a run that is stopped continues, and what was measured is not measured again."""

import json
import shutil
from importlib import import_module
from pathlib import Path
from pkgutil import iter_modules

import cv2
import numpy as np
import pytest

from raybundle.adjustment.records.notice import Notice
from raybundle.cli.main import main
from raybundle.io.photos.photo import find_photos
from raybundle.pipeline.executors import Processes, Threads
from raybundle.pipeline.project import Project
from raybundle.pipeline.stage import Means
from raybundle.targets.codes import RingFamily
from raybundle.targets.families import families
from raybundle.targets.kinds.rings import Rings
from raybundle.targets.marks import target
from raybundle.workflows import target_tasks
from raybundle.workflows.calibrating import stages
from raybundle.workflows.calibrating.stages import start
from raybundle.workflows.calibrating.state import CALIBRATE
from raybundle.workflows.target_tasks import Wanted, arrays_of_marks, marks_from, measure_targets, wanted

SIZE, C = (640, 480), 700.0


@pytest.fixture(scope="module")
def photos(tmp_path_factory):
    """Seven views of a chessboard."""
    folder = tmp_path_factory.mktemp("board")
    rng = np.random.default_rng(5)
    squares = np.kron(np.indices((9, 12)).sum(axis=0) % 2, np.ones((40, 40))) * 200 + 30
    board = cv2.copyMakeBorder(squares.astype(np.uint8), 40, 40, 40, 40, cv2.BORDER_CONSTANT, value=230)
    middle = np.array([[1, 0, -board.shape[1] / 2], [0, 1, -board.shape[0] / 2], [0, 0, 1.0]])
    K = np.array([[C, 0, SIZE[0] / 2], [0, C, SIZE[1] / 2], [0, 0, 1]])
    for k in range(7):
        tilt = np.radians(rng.uniform(15, 32)) * (k > 0)
        around, roll = 2 * np.pi * k / 6, (k % 2) * np.pi / 2
        R, _ = cv2.Rodrigues(tilt * np.array([np.cos(around), np.sin(around), 0]))
        Z, _ = cv2.Rodrigues(np.array([0, 0, roll]))
        H = K @ np.column_stack([(Z @ R)[:, :2], [0, 0, 1150.0]]) @ middle
        image = cv2.warpPerspective(board, H, SIZE, flags=cv2.INTER_AREA, borderValue=230)
        image = np.clip(cv2.GaussianBlur(image, (0, 0), 0.7) + rng.normal(0, 1.5, image.shape), 0, 255)
        cv2.imwrite(str(folder / f"{k}.png"), image.astype(np.uint8))
    return folder


def command(photos, out, *more):
    return ["calibrate", str(photos), "--out", str(out), "--jobs", "2", "--no-report", *more]


@pytest.fixture(scope="module")
def done(photos, tmp_path_factory):
    out = tmp_path_factory.mktemp("done") / "calibration"
    assert main(command(photos, out)) == 0
    return out


def numbers(folder):
    result = json.loads((folder / "result.json").read_text(encoding="utf-8"))
    return result["sigma0"], result["cameras"]


@pytest.fixture
def measured(monkeypatch):
    """How often targets were looked for."""
    count = []
    original = target_tasks.detect
    monkeypatch.setattr(target_tasks, "detect", lambda *a: count.append(1) or original(*a))
    return count


def test_every_file_is_one_stage():
    of_files = [import_module(f"{stages.__name__}.{m.name}") for m in iter_modules(stages.__path__)]
    assert sorted(m.STAGE.name for m in of_files) == sorted(CALIBRATE.stages)
    assert CALIBRATE.titles() == ("photographs", "targets", "start", "adjustment", "verdict")


@pytest.mark.long
def test_a_stopped_run_continues(photos, done, tmp_path, monkeypatch, capsys, measured):
    out = tmp_path / "calibration"
    monkeypatch.setattr(start, "board_oriented", lambda *_: (_ for _ in ()).throw(KeyboardInterrupt))
    assert main(command(photos, out)) == 130
    assert f" {out}, " in capsys.readouterr().err
    assert len(measured) == 7
    monkeypatch.undo()
    count = []
    original = target_tasks.detect
    monkeypatch.setattr(target_tasks, "detect", lambda *a: count.append(1) or original(*a))
    assert main(command(photos, out)) == 0
    assert not count
    assert numbers(out) == numbers(done)


@pytest.mark.long
def test_other_options_take_what_was_measured(photos, done, tmp_path, measured, capsys):
    out = Path(shutil.copytree(done, tmp_path / "again"))
    assert main(command(photos, out, "--parameters", "c,x0,y0,K1")) == 0
    assert not measured
    assert numbers(out) != numbers(done)
    assert main(command(photos, out)) == 0
    assert numbers(out) == numbers(done)
    capsys.readouterr()
    assert main(["status", str(out)]) == 0
    stated = {line.split()[0]: line for line in capsys.readouterr().out.splitlines()[1:]}
    assert stated.pop("products:")
    assert list(stated) == list(CALIBRATE.titles())
    assert "from cache" in stated["targets"]
    assert "7 of 7 photographs" in stated["start"]
    assert "sigma0" in stated["adjustment"]


@pytest.mark.long
def test_a_photograph_that_is_added_is_measured_alone(photos, done, tmp_path, measured):
    folder = Path(shutil.copytree(photos, tmp_path / "more"))
    image = cv2.imread(str(folder / "3.png"), cv2.IMREAD_GRAYSCALE)
    cv2.imwrite(str(folder / "9.png"), cv2.flip(image, -1))
    out = Path(shutil.copytree(done, tmp_path / "again"))
    assert main(command(folder, out)) == 0
    assert len(measured) == 1


def test_a_folder_that_was_begun_for_nothing_is_gone(photos, tmp_path):
    out = tmp_path / "none"
    assert main(command(photos, out, "--target", "nothing-7")) == 2
    assert not out.exists()


def test_a_folder_called_project_that_is_none_is_not_touched(photos, done, tmp_path, capsys):
    out = Path(shutil.copytree(done, tmp_path / "foreign"))
    shutil.rmtree(out / "project")
    (out / "project").mkdir()
    (out / "project/thesis.txt").write_text("mine", encoding="utf-8")
    assert main(command(photos, out)) == 2
    assert "[result.foreign_files]" in capsys.readouterr().err
    assert (out / "project/thesis.txt").read_text(encoding="utf-8") == "mine"


def test_targets_of_other_processes_are_the_same(photos, tmp_path):
    found = find_photos([photos]).photos
    targets = (target("chessboard-11x8"),)
    kept = []
    for name, executor in (("threads", Threads(2)), ("processes", Processes(2))):
        project = Project.open(tmp_path / name)
        try:
            kept.append(measure_targets(Means(project=project, executor=executor), found, targets))
        finally:
            project.close()
    for (one,), (other,) in zip(*kept, strict=True):
        assert one.name == other.name
        assert len(one) == 88
        np.testing.assert_array_equal(one.xy_px, other.xy_px)
        np.testing.assert_array_equal(one.covariance, other.covariance)


def test_targets_are_told_as_plain_data():
    table = RingFamily(
        name="mine", title="my rings", bits=8, ring=(2.0, 3.0), ground=3.5, read=(2.2, 2.8), table={1: 23, 2: 37}
    )
    for given in (Rings(rings=table, dots=True), target("aicon14"), target("dots"), target("charuco-8x6-5x5_100")):
        plain = wanted(given)
        assert isinstance(plain, Wanted)
        assert plain.target == given

    class Own:
        """A target of somebody's program."""

        family = "chessboard-9x6"

    assert wanted(Own()) is None
    assert wanted(Rings(rings=families["aicon14"], dots=True)) == Wanted(family="aicon14", dots=True)


def test_marks_and_starts_are_kept_whole(photos, done):
    project = Project.open(done / "project", create=False)
    try:
        (start_file,) = (done / "project/cache").glob("*/start-*.npz")
        a = project.products.load(start_file.stem)
    finally:
        project.close()
    begun = start.STAGE.codec.product(a)
    assert len(begun.given.places) == 88
    again = start.STAGE.codec.arrays(begun)
    assert a.keys() == again.keys()
    for name, values in a.items():
        np.testing.assert_array_equal(values, again[name])
    assert all(isinstance(n, Notice) for n in begun.notices)
    marks = target("chessboard-11x8").find(cv2.imread(str(photos / "1.png"), cv2.IMREAD_GRAYSCALE), None)
    (back,) = marks_from(arrays_of_marks([marks]), [target("chessboard-11x8")])
    assert (back.name, back.remarks) == (marks.name, marks.remarks)
    np.testing.assert_array_equal(back.xy_px, marks.xy_px)
