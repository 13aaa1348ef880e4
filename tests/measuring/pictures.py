"""Rendered pictures of points whose place is known, and clicks near them."""

import cv2
import numpy as np
from scipy.ndimage import gaussian_filter

from raybundle.measuring.snap import Reference
from tests.targets.render import expose, fine_grid, plane_view, share, shot, to_plane

SIZE = 72


def click_near(rng, xy, radius=5.0):
    """A click within `radius` of a place."""
    angle, r = rng.uniform(0, 2 * np.pi), radius * np.sqrt(rng.uniform())
    return xy + r * np.array([np.cos(angle), np.sin(angle)])


def ellipse(rng):
    """A dot, seen askew."""
    made = shot(rng, rng.uniform(4, 14), np.deg2rad(rng.uniform(0, 45)), size=SIZE, inverse=rng.uniform() < 0.5,
                noise=rng.uniform(1, 4), blur=rng.uniform(0.5, 1.0))  # fmt: skip
    return made.image, made.centre, None


def _plane(rng, tilt_deg, pattern, **light):
    """A plane pattern of distances to edges, its origin near the middle of the picture."""
    centre = rng.uniform(-0.5, 0.5, 2) + SIZE / 2
    # square on, the unit of the plane is 10 px
    H = plane_view(10.0, np.deg2rad(rng.uniform(0, tilt_deg)), *rng.uniform(0, 2 * np.pi, 2), centre)
    q, _ = to_plane(H, *fine_grid(SIZE, SIZE))
    fine = pattern(q)
    return expose(fine.astype(np.float32), rng, **light), H[:2, 2] / H[2, 2], None


def _side(d):
    """Share of a sample on the positive side of an edge at distance d [units of the plane]."""
    step = np.hypot(*np.gradient(d))
    return share(d / np.maximum(step, 1e-12))


def corner(rng, tilt_deg=30.0):
    """The corner of a window, or of four squares of a chessboard, or of three surfaces."""
    levels = np.array(
        {0: [1, 0, 0, 0], 1: [1, 0, 0, 1], 2: [1.0, 0.3, 0.3, 0.3], 3: [0.9, 0.5, 0.1, 0.1]}[int(rng.integers(4))]
    )

    def pattern(q):
        u, v = _side(q[..., 0]), _side(q[..., 1])
        return levels[0] * u * v + levels[1] * u * (1 - v) + levels[2] * (1 - u) * v + levels[3] * (1 - u) * (1 - v)

    return _plane(rng, tilt_deg, pattern, noise=rng.uniform(1, 4), blur=rng.uniform(0.6, 1.0))


def cross(rng, tilt_deg=20.0):
    """A cross of two bars."""
    half = rng.uniform(0.08, 0.25)

    def pattern(q):
        bars = [np.minimum(_side(half - q[..., k]), _side(half + q[..., k])) for k in (0, 1)]
        return 1 - (1 - bars[0]) * (1 - bars[1])

    return _plane(rng, tilt_deg, pattern, noise=rng.uniform(1, 4), blur=rng.uniform(0.6, 1.0))


_FINE = {}


def texture(path):
    """A photograph as a pattern that is sampled three times as finely as the pictures made of it."""
    if path not in _FINE:
        _FINE[path] = cv2.imread(str(path), cv2.IMREAD_GRAYSCALE).astype(np.float32)
    return _FINE[path]


def patch(rng, path, scale=3.0):
    """Two pictures of a plane with the texture of a photograph, the second turned, scaled and sheared against it."""
    fine = texture(path)
    h, w = fine.shape
    while True:
        at = rng.uniform([250, 250], [w - 250, h - 250])
        x, y = at.astype(int)
        part = fine[y - 24 : y + 24, x - 24 : x + 24]
        edges = np.abs(cv2.Sobel(part, cv2.CV_32F, 1, 0)).mean(), np.abs(cv2.Sobel(part, cv2.CV_32F, 0, 1)).mean()
        if min(edges) > 20:
            break
    A = np.eye(2) + rng.uniform(-0.12, 0.12, (2, 2))
    pictures, places = [], []
    for M in (np.eye(2), A):
        centre = rng.uniform(-0.5, 0.5, 2) + SIZE / 2
        # picture pixel p (centre at 0.5) <- fine pixel: at + scale M^-1 (p - centre); averaged over the pixel
        back = scale * np.linalg.inv(M)
        n = 4
        offset = (np.arange(n) + 0.5) / n
        px, py = np.meshgrid((np.arange(SIZE)[:, None] + offset).ravel(), (np.arange(SIZE)[:, None] + offset).ravel())
        source = at + (np.stack([px, py], axis=-1) - centre) @ back.T - 0.5
        big = cv2.remap(fine, *np.moveaxis(source.astype(np.float32), -1, 0), cv2.INTER_CUBIC)
        grey = big.reshape(SIZE, n, SIZE, n).mean(axis=(1, 3))
        grey = cv2.GaussianBlur(grey, (0, 0), 0.5) + rng.normal(0, 2.0, grey.shape)
        pictures.append(np.clip(np.round(grey), 0, 255).astype(np.uint8))
        places.append(centre)
    reference = Reference(grey=pictures[0], x_px=places[0][0], y_px=places[0][1])
    return pictures[1], places[1], reference


def wedges(rng, apart, blur, noise=2.5):
    """Four quarters of different grey between two edges that meet at an angle [rad], blurred [px], on a fine grid."""
    fine, size = 6, 60
    centre = rng.uniform(-0.5, 0.5, 2) + size / 2
    y, x = (np.mgrid[: size * fine, : size * fine] + 0.5) / fine
    turn = rng.uniform(0, 2 * np.pi)
    sides = [(x - centre[0]) * np.cos(t) + (y - centre[1]) * np.sin(t) > 0 for t in (turn, turn + apart)]
    grey = np.choose(sides[0] * 2 + sides[1], rng.permutation([60.0, 190.0, 110.0, 150.0]))
    grey = gaussian_filter(grey, blur * fine).reshape(size, fine, size, fine).mean(axis=(1, 3))
    return np.clip(np.round(grey + rng.normal(0, noise, grey.shape)), 0, 255).astype(np.uint8), centre
