"""Small square tags: as many as OpenCV finds, with corners and sigmas that are true; repeated ones without a name."""

import cv2
import numpy as np
import pytest

from raybundle.targets.kinds.tags import dictionary, seen_tags
from raybundle.targets.marks import detect
from raybundle.targets.tag_fit import fit_tags
from raybundle.targets.tag_reading import FALSE, bits_of, least_correlation, read_modules

FAMILY = "apriltag-36h11"
CELL, COLUMNS = 40, 14


def grid_of_tags(rng, side_px, ids, *, blur=0.6, noise=1.5, tilt=0.0, over=6):
    """A sheet of tags (h, w) uint8 with sides (n,) [px] and any turn, and their true corners (n, 4, 2).

    The exposure of a pixel is the mean over it of the blurred pattern, on a grid `over` times as fine.
    """
    tags = dictionary(FAMILY)
    rows = -(-len(ids) // COLUMNS)
    h, w = rows * CELL + 20, COLUMNS * CELL + 20
    fine = np.full((h * over, w * over), 220.0, np.float32)
    corners = np.zeros((len(ids), 4, 2))
    n = tags.markerSize + 2
    for k, (side, i) in enumerate(zip(side_px, ids, strict=True)):
        row, column = divmod(k, COLUMNS)
        centre = np.array([column, row]) * CELL + CELL / 2 + 10 + rng.uniform(-1, 1, 2)
        a = rng.uniform(0, 2 * np.pi)
        turn = np.array([[np.cos(a), -np.sin(a)], [np.sin(a), np.cos(a)]]) @ np.diag([1, 1 - tilt]) * side / n
        corners[k] = (np.array([[0, 0], [n, 0], [n, n], [0, n]]) - n / 2) @ turn.T + centre
        low = np.floor((corners[k].min(axis=0) - 1) * over).astype(int)
        high = np.ceil((corners[k].max(axis=0) + 1) * over).astype(int)
        x, y = np.meshgrid(np.arange(low[0], high[0]) + 0.5, np.arange(low[1], high[1]) + 0.5)
        uv = (np.stack([x, y], axis=-1) / over - centre) @ np.linalg.inv(turn).T + n / 2
        cell = np.floor(uv).astype(int)
        inside = ((cell >= 0) & (cell < n)).all(axis=-1)
        bits = bits_of(tags, int(i))
        part = fine[low[1] : high[1], low[0] : high[0]]
        part[inside] = 40 + 180 * bits[cell[inside][:, 1], cell[inside][:, 0]]
    fine = cv2.GaussianBlur(fine, (0, 0), blur * over)
    image = fine.reshape(h, over, w, over).mean(axis=(1, 3)) + rng.normal(0, noise, (h, w))
    return np.clip(np.rint(image), 0, 255).astype(np.uint8), corners


def plain_opencv(image):
    """Numbers that OpenCV reads as it comes."""
    detector = cv2.aruco.ArucoDetector(dictionary(FAMILY), cv2.aruco.DetectorParameters())
    seen = detector.detectMarkers(image)
    return [] if seen[1] is None else seen[1].ravel().tolist()


def whole_tags(marks):
    numbers = [n.split("/")[0] for n in marks.name if n]
    return {int(n) for n in set(numbers) if numbers.count(n) == 4}


@pytest.mark.long
@pytest.mark.parametrize(("least", "most", "count"), [(8, 24, 110), (10, 16, 75), (14, 25, 150)])
def test_as_many_small_tags_as_opencv_of_whatever_version(least, most, count):
    """OpenCV before 4.14 reads 19 of those of 10 to 16 px, later ones 76."""
    rng = np.random.default_rng(5)
    ids = np.arange(154)
    image, corners = grid_of_tags(rng, rng.uniform(least, most, 154), ids)
    read = set(plain_opencv(image))
    found = detect(image, FAMILY)
    mine = whole_tags(found)
    assert len(mine) >= count
    assert mine >= read
    off = [
        np.hypot(*(xy - corners[int(i), int(k) - 1]))
        for n, xy in zip(found.name, found.xy_px, strict=True)
        for i, k in [n.split("/")]
    ]
    assert max(off) < 0.2
    assert np.median(off) < 0.04


@pytest.mark.long
def test_sigmas_of_corners_are_true():
    """Mean normalised squared error of a corner, 2 for two coordinates; a tenth more sigma would be seen.

    Corners of a tag are correlated, so that only one of each counts: 300 of them, 2 +- 3.3 * 2 / sqrt(300).
    """
    rng = np.random.default_rng(6)
    squares = []
    tags = dictionary(FAMILY)
    for part in range(3):
        ids = np.arange(98) + 98 * part
        # steps of a coarser grid would be errors of the truth
        image, corners = grid_of_tags(rng, rng.uniform(11, 24, 98), ids, noise=2.5, tilt=0.2, over=14)
        start = corners + rng.normal(0, 0.3, corners.shape)
        fitted = fit_tags(image, start, np.stack([bits_of(tags, int(i)) for i in ids]))
        assert fitted.measured.mean() > 0.98
        rows = np.flatnonzero(fitted.measured)
        one = rng.integers(0, 4, len(rows))
        e = fitted.xy_px[rows, one] - corners[rows, one]
        squares.append(np.einsum("ni,nij,nj->n", e, np.linalg.inv(fitted.covariance[rows, one]), e))
    z2 = np.concatenate(squares)
    assert abs(z2.mean() - 2) < 3.3 * 2 / np.sqrt(len(z2)), z2.mean()


def test_a_tag_in_a_large_photograph():
    """OpenCV looks for tags of 3 % of the longer side; small ones in large photographs count here, too."""
    rng = np.random.default_rng(7)
    part, _ = grid_of_tags(rng, np.full(28, 18.0), np.arange(28))
    image = np.full((3000, 4500), 220, np.uint8)
    image[1000 : 1000 + part.shape[0], 2000 : 2000 + part.shape[1]] = part
    assert len(plain_opencv(image)) == 0
    assert len(whole_tags(detect(image, FAMILY))) >= 25


def test_repeated_tags_keep_their_corners_without_a_name():
    rng = np.random.default_rng(8)
    ids = np.array([1, 2, 3, 2, 4, 2, 5, 6])
    image, corners = grid_of_tags(rng, np.full(8, 22.0), ids)
    found = detect(image, FAMILY)
    assert whole_tags(found) == {1, 3, 4, 5, 6}
    assert (~found.named).sum() == 12
    assert [(r.message.code, r.message.values) for r in found.remarks] == [
        ("target_seen.tag_in_places", {"tag": "2", "n": 3})
    ]
    apart = np.linalg.norm(found.xy_px[~found.named][:, None] - corners[ids == 2].reshape(-1, 2), axis=2)
    assert apart.min(axis=1).max() < 0.1


def test_nothing_is_read_where_no_tag_is():
    """Quadrangles with a dark rim and modules at random are not read more often than is stated."""
    rng = np.random.default_rng(11)
    tags = dictionary(FAMILY)
    n, side = tags.markerSize + 2, 16
    squares = np.zeros((100, 100, n, n))
    squares[:, :, 1:-1, 1:-1] = rng.integers(0, 2, (100, 100, n - 2, n - 2))
    fine = np.full((100 * 24, 100 * 24), 220, np.uint8)
    for i, j in np.ndindex(100, 100):
        at = slice(24 * i + 4, 24 * i + 4 + side), slice(24 * j + 4, 24 * j + 4 + side)
        fine[at] = 40 + 180 * np.kron(squares[i, j], np.ones((2, 2)))
    low = np.stack(np.meshgrid(24.0 * np.arange(100) + 4, 24.0 * np.arange(100) + 4), axis=-1).reshape(-1, 1, 2)
    corners = low + np.array([[0, 0], [side, 0], [side, side], [0, side]], float)
    wrong = int((read_modules(fine, corners, tags)[0] >= 0).sum())
    assert wrong <= FALSE * 10_000  # 2.7 are to be expected


def test_how_much_must_agree():
    assert least_correlation(36, 4 * 587) == pytest.approx(1 - 7 / 36)
    assert least_correlation(16, 4 * 50) > 1  # too short: left to OpenCV


@pytest.mark.parametrize("turn", range(4))
def test_a_tag_is_read_from_any_corner(turn):
    rng = np.random.default_rng(12)
    ids = np.array([3, 77, 500])
    image, corners = grid_of_tags(rng, np.full(3, 18.0), ids)
    number, turned = read_modules(image, np.roll(corners, turn, axis=1), dictionary(FAMILY))
    assert number.tolist() == ids.tolist()
    assert np.array_equal(turned, corners)


def test_a_pattern_of_another_tag_does_not_pass():
    rng = np.random.default_rng(9)
    image, corners = grid_of_tags(rng, np.full(8, 20.0), np.arange(8))
    tags = dictionary(FAMILY)
    wrong = np.stack([bits_of(tags, 100 + k) for k in range(8)])
    assert not fit_tags(image, corners, wrong).measured.any()
    right = np.stack([bits_of(tags, k) for k in range(8)])
    assert fit_tags(image, corners, right).measured.all()


def test_the_edge_of_the_image_does_not_matter_and_a_cut_tag_is_left_out():
    rng = np.random.default_rng(10)
    image, corners = grid_of_tags(rng, np.full(1, 22.0), np.arange(1))
    low = np.floor(corners[0].min(axis=0)).astype(int)
    tags = dictionary(FAMILY)
    bits = bits_of(tags, 0)[None]
    close = image[low[1] - 1 :, low[0] - 1 :]
    assert fit_tags(close, corners - (low - 1), bits).measured.all()
    cut = image[low[1] + 3 :, low[0] + 3 :]
    assert not fit_tags(cut, corners - (low + 3), bits).measured.any()
    assert seen_tags(np.full((40, 40), 128, np.uint8), tags)[0].size == 0
