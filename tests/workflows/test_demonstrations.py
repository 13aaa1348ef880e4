"""Sets of photographs that are made on the spot: every one that there is, by its being there."""

import numpy as np
import pytest

import raybundle as rb
from raybundle.cli.main import main
from raybundle.commands.demonstrations import make_set, set_named, set_names
from raybundle.commands.demonstrations.files import made_camera
from raybundle.commands.demonstrations.sets import board, flight, part, scene
from raybundle.errors import InputError
from raybundle.planning.rendered.ground import gravel_pit
from raybundle.planning.rendered.part import photograph
from raybundle.planning.rendered.rendering import View
from raybundle.targets.detect import detect_targets
from raybundle.targets.families import family_named
from raybundle.targets.marks import detect, target
from tests.messages import refused


@pytest.fixture(scope="module")
def made(tmp_path_factory):
    """Each set, made once."""
    folder = tmp_path_factory.mktemp("sets")
    return {name: (folder / name, make_set(name, folder / name)) for name in OF_PHOTOGRAPHS}


OF_PHOTOGRAPHS = [n for n in set_names() if n != "scene"]


@pytest.mark.long
@pytest.mark.parametrize("name", OF_PHOTOGRAPHS)
def test_a_set_has_photographs_that_say_what_they_are(name, made):
    folder, told = made[name]
    assert set_named(name).ABOUT
    assert told
    files = sorted(folder.rglob("*.jpg"))
    assert len(files) >= 10
    read = rb.photos(sorted({f.parent for f in files}))
    assert len(read.found.photos) == len(files)
    assert len(read.cameras) == 1
    with pytest.raises(InputError):
        make_set(name, folder)


def test_the_scene_is_what_it_says(tmp_path):
    """RPC, control and heights fit together: to the errors of marking, and by the shift that was put in."""
    told = make_set("scene", tmp_path / "scene")
    assert [t.split(":")[0] for t in told] == ["scene.tif", "control.gpkg", "heights.tif"]
    said = rb.rpc_correct(tmp_path / "scene/scene.tif", tmp_path / "scene/control.gpkg", image_sigma=0.35)
    assert said.fit.kind == "shift"
    assert not said.advice.set_aside
    assert np.abs(said.fit.values - scene.WRONG).max() < 4 * said.fit.sigma.max()
    assert said.rpc.err_bias_m == scene.STATED_M


def test_what_is_no_set_is_told(tmp_path, capsys):
    assert main(["demo", "--set", "nothing", "--out", str(tmp_path / "x")]) == 2
    assert ", ".join(set_names()) in capsys.readouterr().err
    with refused("dataset.unknown", name="nothing", known=["board", "flight", "part", "scene"]):
        make_set("nothing", tmp_path / "y")


def looking(camera, centre, rotation):
    return View(name="a", camera=camera, centre=np.asarray(centre, float), rotation=rotation)


def test_a_target_is_found_where_it_was_drawn():
    """The pixels show what the camera's model projects there, to a few hundredths."""
    true = {n: xyz for n, (xyz, _) in part.nominal().items()}
    bars = part.on_bars()
    camera = made_camera("m", (1600, 1200), 0.0075, c=12.31, x0=0.043, y0=-0.061, K1=-1.6e-4, K2=1.1e-6)
    centre, rotation = part.stations(np.random.default_rng(1))[2]
    view = looking(camera, centre, rotation)
    grey = photograph(part.bodies(true, bars), view, np.random.default_rng(2)).mean(axis=2).round().astype(np.uint8)
    found = detect_targets(grey, family_named(part.FAMILY))
    found = found.rows(found.coded)
    assert len(found) >= 20
    for name, xy in zip(map(str, found.id.tolist()), found.xy_px, strict=True):
        place = {**true, **bars}[name]
        np.testing.assert_allclose(xy, view.pixels_of(place[None])[0], atol=0.12, err_msg=name)


def test_a_board_lies_where_its_point_is():
    plan = np.array([[3.0, -2.0]])
    ground = gravel_pit(size=(40.0, 30.0)).with_boards(plan)
    camera = made_camera("m", (400, 300), 0.0073, c=8.62, K1=-3e-4)
    view = looking(camera, [0.0, 0.0, 25.0], np.eye(3))
    pixels = ground.photograph(view, np.random.default_rng(1)).mean(axis=2)
    x, y = view.pixels_of(ground.points(plan))[0]
    # four squares meet in the point: diagonal ones are alike, neighbours are not
    quarters = [pixels[int(y + dy), int(x + dx)] for dy, dx in ((-3, -3), (-3, 3), (3, -3), (3, 3))]
    assert min(quarters[0], quarters[3]) > 150 or max(quarters[0], quarters[3]) < 80
    assert abs(quarters[0] - quarters[3]) < 60 < abs(quarters[0] - quarters[1])


@pytest.mark.long
def test_the_flight_marks_each_point_in_two_photographs_or_more(tmp_path):
    views = flight.views()
    ground = gravel_pit()
    for name, xy in {**flight.CONTROL, **flight.CHECK}.items():
        seen = [v for v in views if v.inside(v.pixels_of(ground.points(np.array([xy], float))), 40)[0]]
        assert len(seen) >= 3, name


def test_the_true_camera_of_the_board_is_what_opencv_projects():
    """The truth that is written in OpenCV's terms is the camera with which the photographs are drawn."""
    cv2 = pytest.importorskip("cv2")
    fx, fy, cx, cy = board.K
    for view in board.views()[:4]:
        ours = view.pixels_of(board.BOARD.corners)
        R = np.diag([1.0, -1.0, -1.0]) @ view.rotation
        theirs, _ = cv2.projectPoints(
            board.BOARD.corners, cv2.Rodrigues(R)[0], -R @ view.centre, np.array([[fx, 0, cx], [0, fy, cy], [0, 0, 1]]),
            np.array(board.DISTORTION),
        )  # fmt: skip
        np.testing.assert_allclose(ours - 0.5, theirs[:, 0], atol=1e-6)


@pytest.mark.long
def test_a_corner_of_the_bent_board_is_found_where_it_was_drawn():
    view = board.views()[2]
    grey = board.BOARD.photograph(view, np.random.default_rng(1))[..., 0]
    inner = f"chessboard-{board.BOARD.columns - 1}x{board.BOARD.rows - 1}"
    found = detect(grey, target(inner))
    assert len(found) == len(board.BOARD.corners)
    true = view.pixels_of(board.BOARD.corners)
    apart = np.linalg.norm(found.xy_px[:, None] - true, axis=2).min(axis=1)
    assert apart.max() < 0.05
    assert np.ptp(board.BOARD.corners[:, 2]) > 2e-4


def test_photographs_of_the_board_reach_the_corners_of_the_format():
    views = board.views()
    xy = np.concatenate([v.pixels_of(board.BOARD.corners) for v in views])
    size = np.array(board.SIZE)
    assert ((xy > 0) & (xy < size)).all()
    for corner in ((0, 0), (0, 1), (1, 0), (1, 1)):
        assert np.linalg.norm((xy - size * corner) / size, axis=1).min() < 0.2
