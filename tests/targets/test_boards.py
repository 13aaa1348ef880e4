"""Boards, square tags and rasters of dots: rendered, found, named, measured; and real photographs of them."""

import cv2
import numpy as np
import pytest
from PIL import Image

from raybundle.errors import InputError
from raybundle.numerics import native
from raybundle.targets.border import fit_squares
from raybundle.targets.kinds.tags import dictionary
from raybundle.targets.lattice import lattices
from raybundle.targets.marks import detect, forms, target
from raybundle.targets.saddle import CornerOptions, fit_corners
from tests.conftest import DATA
from tests.targets.render import F, ellipse_of, expose, fine_pattern


def told(marks):
    """Code of the first remark, and the target."""
    message = marks.remarks[0].message
    return message.code, message.values.get("target")


def view(pattern, middle, scale, *, size=(420, 340), tilt=0.0, azimuth=0.0, turn=0.0, seed=1, **light):
    """A photograph of a plane pattern and pixel_from_plane; plane x to the right and y up, seen from the front.

    pattern  from plane points (..., 2) to 0 dark, 1 light
    middle   plane point in the middle of the photograph;  scale [px] of a unit there
    """
    t, a, k = np.radians([tilt, azimuth, turn])
    rotation = cv2.Rodrigues(np.array([0, 0, k]))[0] @ cv2.Rodrigues(t * np.array([np.cos(a), np.sin(a), 0]))[0]
    axes = rotation @ np.diag([1.0, -1.0, -1.0])  # the image's y runs downwards
    offset = np.array([0, 0, F / scale]) - axes[:, :2] @ middle
    K = np.array([[F, 0, size[0] / 2 + 0.2], [0, F, size[1] / 2 - 0.3], [0, 0, 1]])
    H = K @ np.column_stack([axes[:, :2], offset])
    return expose(fine_pattern(pattern, H, *size), np.random.default_rng(seed), **light), H


def seen(H, points):
    p = np.column_stack([points, np.ones(len(points))]) @ H.T
    return p[:, :2] / p[:, 2:]


def chessboard(columns, rows):
    """Inner corners at (c, -r), the square between the first four dark; light around."""

    def pattern(q):
        i, j = np.floor(q[..., 0]), np.floor(-q[..., 1])
        on = (i >= -1) & (i < columns) & (j >= -1) & (j < rows)
        return ~(on & ((i + j) % 2 == 0))

    return pattern


def drawn(cells, size):
    """A picture (h, w) 0 or 1 whose cells have `size`, upper left corner at the origin; light around."""

    def pattern(q):
        i, j = (np.floor(v / size).astype(int) for v in (q[..., 0], -q[..., 1]))
        on = (i >= 0) & (j >= 0) & (i < cells.shape[1]) & (j < cells.shape[0])
        return np.where(on, cells[np.clip(j, 0, cells.shape[0] - 1), np.clip(i, 0, cells.shape[1] - 1)], 1)

    return pattern


def discs(columns, rows, step, radius):
    """Dots at (c step + shift, -r); with a step of 2, every second row is shifted by 1."""

    def pattern(q):
        r = np.clip(np.round(-q[..., 1]), 0, rows - 1)
        shift = r % 2 * (step - 1)
        c = np.clip(np.round((q[..., 0] - shift) / step), 0, columns - 1)
        return np.hypot(q[..., 0] - c * step - shift, q[..., 1] + r) > radius

    return pattern


def errors(marks, truth):
    return np.array([xy - truth[n] for n, xy in zip(marks.name, marks.xy_px, strict=True)])


def mahalanobis(marks, e):
    return np.einsum("ni,nij,nj->n", e, np.linalg.inv(marks.covariance), e)


VIEWS = [
    {"scale": 30.0, "tilt": 0.0, "turn": 5.0},
    {"scale": 28.0, "tilt": 35.0, "azimuth": 70.0, "turn": 130.0, "blur": 1.2},
    {"scale": 28.0, "tilt": 55.0, "azimuth": 10.0, "turn": 250.0, "slope": (0.3, -0.2)},
]


@pytest.mark.parametrize("how", VIEWS)
def test_chessboard(how):
    t = target("Chessboard-9x6 ")
    assert t.turns == 1
    image, H = view(chessboard(9, 6), (4.0, -2.5), **how)
    marks = detect(image, t)
    names = list(t.objects)
    assert list(marks.name) == names  # so r0c0 is the same corner at every turn
    truth = dict(zip(names, seen(H, np.array([t.objects[n][:2] for n in names])), strict=True))
    e = errors(marks, truth)
    assert np.sqrt(np.mean(e**2)) < 0.02
    assert abs(e.mean(axis=0)).max() < 0.006
    assert 1.0 < mahalanobis(marks, e).mean() < 3.5
    assert np.isnan(marks.radius_px).all()
    assert (marks.gate < 0.05).all()


def test_corner_windows_keep_off_the_neighbours():
    """Squares of nine pixels: a window of 11 px on each side would hold four corners."""
    image, H = view(chessboard(5, 4), (2.0, -1.5), 9.0, size=(140, 120), turn=20.0)
    xy = seen(H, np.array([[c, -r] for r in range(4) for c in range(5)]))
    u, v = (seen(H, np.array([[c + 1 - k, -r - k] for r in range(4) for c in range(5)])) - xy for k in (0, 1))
    start = xy + np.random.default_rng(2).normal(0, 0.3, xy.shape)
    good = fit_corners(image, start, u, v)
    assert good.measured.all()
    assert abs(good.xy_px - xy).max() < 0.05
    wide = fit_corners(image, start, u, v, CornerOptions(reach=1.6, most_px=15.0))
    assert not wide.measured.any()
    along, across = np.array([[[9.0, 0]], [[0, 9.0]]])
    flat = fit_corners(np.full((50, 50), 90, np.uint8), np.array([[25.0, 25]]), along, across)
    assert not flat.measured.any()


def test_compiled_corners_are_those_of_the_twin():
    if not native.available():
        pytest.skip("the kernels are not compiled")
    image, H = view(chessboard(7, 5), (3.0, -2.0), 22.0, size=(220, 180), tilt=40.0, azimuth=20.0, turn=30.0)
    xy = seen(H, np.array([[c, -r] for r in range(5) for c in range(7)]))
    u, v = (seen(H, np.array([[c + 1 - k, -r - k] for r in range(5) for c in range(7)])) - xy for k in (0, 1))
    start = xy + np.random.default_rng(3).normal(0, 0.4, xy.shape)
    start[:3] = [[1.0, 1.0], [500.0, 20.0], [110.3, 90.2]]  # at the border, outside, within a square
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(native, "module", lambda: None)
        twin = fit_corners(image, start, u, v)
    fitted = fit_corners(image, start, u, v)
    assert (fitted.measured == twin.measured).all()
    assert fitted.measured.sum() >= 30
    good = fitted.measured
    assert np.allclose(fitted.xy_px[good], twin.xy_px[good], rtol=0, atol=1e-8)
    assert np.allclose(fitted.covariance[good], twin.covariance[good], rtol=1e-6, atol=0)
    for k in ("contrast", "residual", "blur_px"):
        assert np.allclose(getattr(fitted, k)[good], getattr(twin, k)[good], rtol=1e-7)


def beside(pattern, step, axis=0):
    """A pattern and the same again, so far to the right (downwards)."""
    shift = np.array([[step, 0.0], [0.0, -step]])[axis]
    return lambda q: pattern(q) & pattern(q - shift)


@pytest.mark.parametrize("turn", [0.0, 35.0])
def test_two_boards_in_a_photograph_are_noticed(turn):
    image, _ = view(beside(chessboard(5, 4), 7.5), (5.8, -1.5), 24.0, turn=turn)
    marks = detect(image, "chessboard-5x4")
    assert len(marks) == 0
    assert told(marks) == ("target_seen.two_boards", "chessboard-5x4")
    other = detect(image, "chessboard-7x5")
    assert told(other) == ("target_seen.no_board", "chessboard-7x5")


def test_two_boards_of_different_size_do_no_harm():
    small = chessboard(4, 3)
    image, _ = view(lambda q: chessboard(6, 5)(q) & small(1.5 * (q - [7.5, -1.0])), (5.0, -2.0), 26.0)
    assert len(detect(image, "chessboard-6x5")) == 30
    assert len(detect(image, "chessboard-4x3")) == 12


def test_two_rasters_and_two_charuco_boards_are_noticed():
    image, _ = view(beside(discs(5, 4, 1, 0.27), 7.0, axis=1), (2.0, -5.0), 24.0, size=(340, 420))
    marks = detect(image, "circles-5x4")
    assert len(marks) == 0
    assert told(marks) == ("target_seen.two_boards", "circles-5x4")
    t = target("charuco-5x4-4x4_50")
    cells = t.board(old=False).generateImage((5 * 24, 4 * 24), marginSize=0) > 127
    both = np.ones((4 * 24, 12 * 24), bool)
    both[:, : 5 * 24] = both[:, 7 * 24 :] = cells
    image, _ = view(drawn(both, 1 / 24), (6.0, -2.0), 30.0)
    marks = detect(image, t)
    assert len(marks) == 0
    assert told(marks) == ("target_seen.two_boards", "charuco-5x4-4x4_50")


@pytest.mark.parametrize("blind", [False, True])
def test_squares_counted_for_corners_name_the_board(blind):
    image, _ = view(chessboard(9, 6), (4.0, -2.5), 30.0)
    if blind:
        image[:] = 128
    marks = detect(image, "chessboard-10x7")
    assert len(marks) == 0
    values = marks.remarks[0].message.values
    assert (values["squares"], values["named"]) == (not blind, "chessboard-9x6")


def test_wrong_numbers_and_hidden_boards_give_a_reason():
    image, _ = view(chessboard(9, 6), (4.0, -2.5), 30.0)
    smaller = detect(image, "chessboard-8x6")
    assert len(smaller) == 0
    assert told(smaller)[0] in {"target_seen.larger_board", "target_seen.no_board"}
    image[:, :170] = 128
    hidden = detect(image, "chessboard-9x6")
    assert len(hidden) == 0
    assert told(hidden) == ("target_seen.no_board", "chessboard-9x6")


@pytest.mark.parametrize("how", VIEWS)
@pytest.mark.parametrize("family", ["apriltag-36h11", "aruco-4x4_50"])
def test_square_tags(family, how):
    tags = dictionary(family)
    n = tags.markerSize + 2
    cells = np.ones((n + 2, 2 * n + 4), int)
    truth_at = {}
    for k, number in enumerate((7, 21)):
        x = 1 + k * (n + 2)
        cells[1 : n + 1, x : x + n] = cv2.aruco.generateImageMarker(tags, number, n) > 127
        corners = [(x, -1), (x + n, -1), (x + n, -1 - n), (x, -1 - n)]
        truth_at |= {f"{number}/{i + 1}": np.array(c) / n for i, c in enumerate(corners)}
    image, H = view(drawn(cells, 1 / n), (1.1, -0.6), **(how | {"scale": 4.0 * how["scale"]}))
    marks = detect(image, family)
    assert sorted(marks.name) == sorted(truth_at)
    e = errors(marks, {k: seen(H, v[None])[0] for k, v in truth_at.items()})
    assert np.sqrt(np.mean(e**2)) < 0.03
    assert (np.sqrt(marks.covariance[:, 0, 0]) < 0.03).all()


def test_a_tag_seen_twice_has_no_name():
    tags = dictionary("aruco-4x4_50")
    cells = np.ones((8, 16), int)
    cells[1:7, 1:7] = cells[1:7, 9:15] = cv2.aruco.generateImageMarker(tags, 5, 6) > 127
    image, _ = view(drawn(cells, 1 / 6), (1.3, -0.6), 100.0)
    marks = detect(image, "aruco-4x4_50")
    assert marks.name == ("",) * 8
    assert [(r.message.code, r.message.values) for r in marks.remarks] == [
        ("target_seen.tag_in_places", {"tag": "5", "n": 2})
    ]


def test_squares_that_cannot_be_measured():
    corners = np.array([[[10.0, 10], [40, 10], [40, 40], [10, 40]]])
    flat = np.full((50, 50), 90, np.uint8)
    assert not fit_squares(flat, corners, 1 / 6).measured.any()
    flat[10:40, 10:40] = 20
    assert fit_squares(flat, corners, 1 / 6).measured.all()
    assert not fit_squares(flat, corners - 12, 1 / 6).measured.any()


@pytest.mark.parametrize(("how", "old"), [(VIEWS[0], False), (VIEWS[1], True)])
def test_charuco(how, old):
    t = target("charuco-7x5-4x4_50")
    cells = t.board(old=old).generateImage((7 * 24, 5 * 24), marginSize=0) > 127
    image, H = view(drawn(cells, 1 / 24), (3.5, -2.5), **(how | {"scale": 40.0}))
    marks = detect(image, t)
    assert set(marks.name) == set(t.objects)
    truth = {n: seen(H, p[None, :2] + [1, -1])[0] for n, p in t.objects.items()}
    e = errors(marks, truth)
    assert np.sqrt(np.mean(e**2)) < 0.02
    image[:, :210] = 128  # half of it hidden
    part = detect(image, t)
    assert 6 <= len(part) < len(marks)
    assert abs(errors(part, truth)).max() < 0.06


@pytest.mark.parametrize("family", ["circles-7x5", "acircles-4x9"])
@pytest.mark.parametrize("how", VIEWS)
def test_rasters_of_dots(family, how):
    t = target(family)
    places = np.array([p[:2] for p in t.objects.values()])
    image, H = view(discs(t.columns, t.rows, 1 + t.staggered, 0.27), places.mean(axis=0), **(how | {"scale": 32.0}))
    marks = detect(image, family)
    assert set(marks.name) == set(t.objects)
    shift = {n: np.array([[1, 0, p[0]], [0, 1, p[1]], [0, 0, 1]]) for n, p in t.objects.items()}
    truth = {n: ellipse_of(H @ T, 0.27)[0] for n, T in shift.items()}
    e = errors(marks, truth)
    if abs(e).max() > 5:  # from the other corner
        assert t.turns == 2
        pairs = dict(zip(t.objects, reversed(t.objects), strict=True))
        e = errors(marks, {n: truth[pairs[n]] for n in truth})
    assert np.sqrt(np.mean(e**2)) < 0.02
    assert np.isfinite(marks.radius_px).all()


def test_lattices_go_round_gaps_and_follow_a_lens():
    rng = np.random.default_rng(3)
    place = np.array([(c, r) for r in range(12) for c in range(15)])
    kept = rng.random(len(place)) > 0.12
    xy = place[kept] * [40.0, 36.0] + [60, 50]
    d = (xy - [340, 250]) / 400
    xy = xy + 400 * d * -0.12 * (d**2).sum(axis=1, keepdims=True) + rng.normal(0, 0.2, xy.shape)
    xy = np.concatenate([xy, rng.uniform(0, 500, (15, 2))])
    ellipse = np.tile(np.diag([100.0, 81.0]), (len(xy), 1, 1))
    (found,) = lattices(xy, ellipse, 30)
    real = found.dot < kept.sum()
    assert real.sum() >= kept.sum() - 3
    assert (
        found.place[real] - place[kept][found.dot[real]] == found.place[real][0] - place[kept][found.dot[real][0]]
    ).all()


def test_names():
    assert any("chessboard-" in f for f in forms())
    for name, message in (
        ("jigsaw-9", r"jigsaw-9.*target\.unknown_family"),
        ("checkers-9x6", r"checkers-9x6.*target\.unknown_family"),
        ("checkerboard10x7", r"Check .*chessboard-10x7.*target\.unknown_family"),
        ("asymcircles_4x11", r"Check .*acircles-4x11.*target\.unknown_family"),
        ("tag36h11", r"Check .*apriltag-36h11.*target\.unknown_family"),
        ("apriltag36h11", r"Check .*apriltag-36h11.*target\.unknown_tags"),
        ("DICT_4X4_50", r"Check .*aruco-4x4_50.*target\.unknown_family"),
        ("aicon-14bit", r"aicon14.*target\.unknown_family"),
        ("agisoft", r"agisoft12.*agisoft14.*agisoft16.*agisoft20.*target\.unknown_family"),
        ("chessboard", r"board\.chessboard_name"),
        ("chessboard-2x6", r"board\.chessboard_size"),
        ("circles-2x2", r"board\.dots_size"),
        ("circles", r"board\.dots_name"),
        ("apriltag-1h1", r"Check .*apriltag-16h5.*target\.unknown_tags"),
        ("charuco", r"board\.charuco_name"),
        ("charuco-30x30-4x4_50", r"450.*50.*board\.charuco_tags"),
        ("charuco-2x5-4x4_50", r"3.*board\.charuco_size"),
    ):
        with pytest.raises(InputError, match=message):
            target(name)
    assert target("charuco-7x5-apriltag_36h11-0.6").family == "charuco-7x5-apriltag_36h11-0.6"
    assert [target(f).turns for f in ("chessboard-9x6", "chessboard-8x6", "chessboard-7x7", "circles-5x5")] == [
        1,
        2,
        4,
        4,
    ]
    with pytest.raises(InputError, match=r"8.*16.*target\.image_type"):
        detect(np.zeros((20, 20, 3), np.uint8), "dots")


def photographs(name):
    folder = DATA / "calibration" / name / "images"
    if not folder.is_dir():
        pytest.skip(f"no photographs {name}: set RAYBUNDLE_DATA")
    images = []
    for path in sorted(folder.iterdir()):
        with Image.open(path) as image:
            images.append(np.array(image.convert("L")))
    return images


@pytest.mark.data
def test_chessboard_photographs_of_others():
    """OpenCV's own corners (window 11) give 0.409 px, with a window that fits 0.183 px."""
    t = target("chessboard-9x6")
    images = photographs("opencv-chessboard")
    marks = [detect(image, t) for image in images]
    assert sum(len(m) for m in marks) == 13 * 54
    objects = [np.array([t.objects[n] * [1, -1, 1] for n in m.name], np.float32) for m in marks]
    points = [(m.xy_px - 0.5).astype(np.float32)[:, None] for m in marks]
    rms, K, *_ = cv2.calibrateCamera(objects, points, images[0].shape[::-1], None, None)
    assert rms <= 0.185
    assert abs(K[0, 0] - 533) < 1.5
    assert abs(K[1, 1] - 533) < 1.5


@pytest.mark.long
@pytest.mark.data
def test_photographs_of_a_sheet_of_dots():
    """Seven of the 21; PhotoModeler measured as many, once one more.  Two do not show the whole sheet."""
    images = [photographs("camcal-photos")[k] for k in (2, 5, 6, 9, 10, 14, 18)]
    marks = [detect(image, "photomodeler-sheet") for image in images]
    assert all(len(m) >= n for m, n in zip(marks, (100, 93, 99, 94, 99, 100, 100), strict=True))
    for m in marks:
        assert len(set(m.name)) == len(m)
        assert set(m.name) >= {"1001", "1002", "1003", "1004"}
        # names agree with the plane: a projective map from their places leaves no more than lens and paper do
        t = target("photomodeler-sheet").objects
        plane = np.array([t[n][:2] for n in m.name])
        H, _ = cv2.findHomography(plane, m.xy_px)
        assert abs(seen(H, plane) - m.xy_px).max() < 30
        assert np.linalg.det(H) < 0  # seen from the front
        if len(m) < 95:  # what is lacking lies at the border or beyond
            lacking = seen(H, np.array([t[n][:2] for n in set(t) - set(m.name)]))
            size = np.array(images[0].shape[::-1])
            assert (np.minimum(lacking, size - lacking).min(axis=1) < 60).all()
    twice = cv2.resize(images[0], None, fx=0.5, fy=0.5, interpolation=cv2.INTER_AREA)
    both = detect(np.hstack([twice, twice]), "photomodeler-sheet")
    assert len(both) == 0
    assert told(both)[0] == "target_seen.two_boards"
