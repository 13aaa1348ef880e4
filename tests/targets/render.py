"""Photographs of plane targets, rendered without the model that measures them.

A pinhole camera looks at a plane pattern; its perspective image is sampled finely, edges by their share of a sample,
blurred by a Gaussian (optics), averaged over square pixels (sensor), lit unevenly, given noise and rounded to 8 bits.
"""

from dataclasses import dataclass

import cv2
import numpy as np

FINE = 8
"""Samples along a pixel."""
F = 2000.0
"""camera constant [px]"""


@dataclass
class Shot:
    image: np.ndarray
    centre: np.ndarray
    """of the ellipse that the dot is seen as, pixel frame"""
    ellipse: np.ndarray
    """(2, 2) C of (x - centre)' C^-1 (x - centre) = 1"""
    projected: np.ndarray
    """image of the dot's own centre"""
    plane_from_pixel: np.ndarray


def plane_view(radius, tilt, azimuth, turn, centre):
    """pixel_from_plane (3, 3) of a plane whose dot of radius 1 is seen with `radius` px when looked at squarely."""
    z = F / radius
    n = np.array([np.sin(tilt) * np.cos(azimuth), np.sin(tilt) * np.sin(azimuth), -np.cos(tilt)])
    u = np.cross(n, [np.sin(turn), np.cos(turn), 0.3])
    u /= np.linalg.norm(u)
    v = np.cross(u, n)  # runs downwards in the image where u runs to the right
    K = np.array([[F, 0, centre[0]], [0, F, centre[1]], [0, 0, 1]])
    return K @ np.stack([u, v, np.array([0, 0, z])], axis=1)


def mirrored(H):
    """Whether a plane is seen from behind."""
    return np.linalg.det(H) < 0


def ellipse_of(H, radius=1.0):
    """Centre and C of the image of a circle around the plane's origin."""
    Q = H @ np.diag([radius**2, radius**2, -1.0]) @ H.T  # dual conic
    centre = Q[:2, 2] / Q[2, 2]
    return centre, np.outer(centre, centre) - Q[:2, :2] / Q[2, 2]


def share(d):
    """How much of a sample lies within, for the distance to the edge in samples, positive within."""
    return np.clip(d + 0.5, 0, 1)


def ring_pattern(q, scale, ring=(2.0, 3.0), bits=0, code=0, hidden=None):
    """Grey values 0..1 at plane points (..., 2); `scale` (...) samples per unit of the plane."""
    x, y = q[..., 0], q[..., 1]
    r = np.sqrt(x * x + y * y)
    value = share((1 - r) * scale)
    if bits:
        in_ring = np.minimum(share((r - ring[0]) * scale), share((ring[1] - r) * scale))
        on = in_ring > 0
        at = np.arctan2(y[on], x[on]) % (2 * np.pi) * bits / (2 * np.pi)
        k = np.floor(at).astype(int) % bits
        bit = (code >> k) & 1
        beside = np.where(at - np.floor(at) < 0.5, (code >> ((k - 1) % bits)) & 1, (code >> ((k + 1) % bits)) & 1)
        arc = np.minimum(at - np.floor(at), 1 - (at - np.floor(at))) * 2 * np.pi / bits * r[on]
        s = share(arc * scale[on])
        value[on] = np.maximum(value[on], in_ring[on] * (bit * s + beside * (1 - s)))
    if hidden is not None:
        begin, end, grey, *radii = hidden
        inner, outer = radii or (1.5, np.inf)
        within = (r > inner) & (r < outer)
        value = np.where(((np.arctan2(y, x) - begin) % (2 * np.pi) < (end - begin)) & within, grey, value)
    return value


def fine_grid(width, height):
    """x (1, w) and y (h, 1) of the fine samples."""
    x, y = ((np.arange(n * FINE) + 0.5) / FINE for n in (width, height))
    return x[None], y[:, None]


def fine_pattern(pattern, H, width, height, rows=256):
    """A pattern of plane points (..., 2) at the fine samples of a picture, some rows at a time."""
    G, x = np.linalg.inv(H), (np.arange(width * FINE) + 0.5) / FINE
    fine = np.empty((height * FINE, width * FINE), np.float32)
    for first in range(0, len(fine), rows):
        strip = fine[first : first + rows]
        y = ((np.arange(first, first + len(strip)) + 0.5) / FINE)[:, None]
        w = x * G[2, 0] + y * G[2, 1] + G[2, 2]
        strip[:] = pattern(np.stack([(x * G[i, 0] + y * G[i, 1] + G[i, 2]) / w for i in (0, 1)], axis=-1))
    return fine


def to_plane(H, x, y):
    """Plane points (..., 2) and samples per unit of the plane, at pixel positions x and y."""
    G = np.linalg.inv(H)
    w = x * G[2, 0] + (y * G[2, 1] + G[2, 2])
    u, v = ((x * G[i, 0] + (y * G[i, 1] + G[i, 2])) / w for i in (0, 1))
    # gradient of the radius in px^-1, times w and the radius, which makes distances to circles exact to first order
    gx, gy = (u * (G[0, j] - u * G[2, j]) + v * (G[1, j] - v * G[2, j]) for j in (0, 1))
    r = np.maximum(np.sqrt(u * u + v * v), 1e-9)
    scale = FINE * np.abs(w) * r / np.maximum(np.sqrt(gx * gx + gy * gy), 1e-12)
    return np.moveaxis(np.stack([u, v]), 0, -1), scale


def expose(fine, rng, blur=0.7, noise=2.0, low=40.0, contrast=160.0, slope=(0.0, 0.0), kind="light", depth=np.uint8):
    """Optics, pixels, light, noise and rounding of a pattern 0..1 at fine samples.

    slope: relative change of the light across the whole image in x and y (kind "light"), or an added change in units
    of the contrast (kind "stray").
    """
    h, w = fine.shape[0] // FINE, fine.shape[1] // FINE
    if blur:
        fine = cv2.GaussianBlur(fine, (0, 0), blur * FINE, borderType=cv2.BORDER_REPLICATE)
    image = low + contrast * fine.reshape(h, FINE, w, FINE).mean(axis=(1, 3))
    x, y = np.meshgrid((np.arange(w) + 0.5) / w - 0.5, (np.arange(h) + 0.5) / h - 0.5)
    change = slope[0] * x + slope[1] * y
    image = image * (1 + change) if kind == "light" else image + contrast * change
    image = image + rng.normal(0, noise, image.shape)
    return np.clip(np.round(image), 0, np.iinfo(depth).max).astype(depth)


def straight_cover(part, angle, grey):
    """Something with a straight edge, seen in the direction `angle` of a dot; hides `part` of its circumference."""

    def cover(p):
        return p[..., 0] * np.cos(angle) + p[..., 1] * np.sin(angle) - np.cos(np.pi * part), grey

    return cover


def round_cover(part, angle, grey):
    """A blob round a point of a dot's edge; hides `part` of its circumference."""

    def cover(p):
        return 2 * np.sin(np.pi * part / 2) - np.hypot(p[..., 0] - np.cos(angle), p[..., 1] - np.sin(angle)), grey

    return cover


def shot(
    rng, radius, tilt=0.0, *, size=None, bits=0, code=0, ring=(2.0, 3.0), inverse=False, hidden=None, cover=None,
    **light,
):  # fmt: skip
    """One target near the middle of a small image; tilt in radians, azimuth, turn and place at random.

    cover  function of positions in the frame in which the dot's edge is the unit circle: distance to the border of what
           lies on the target, positive within, and its grey value 0..1
    """
    reach = ring[1] if bits else 1.0
    size = size or 2 * int(np.ceil(radius * reach * 1.15 + 8))
    centre = rng.uniform(-0.5, 0.5, 2) + size / 2
    H = plane_view(radius, tilt, rng.uniform(0, 2 * np.pi), rng.uniform(0, 2 * np.pi), centre)
    x, y = fine_grid(size, size)
    if mirrored(H):
        raise ValueError("the plane is seen from behind")
    fine = np.empty((size * FINE, size * FINE))
    for first in range(0, len(fine), 128):  # of all, positions and distances would take hundreds of megabytes
        q, scale = to_plane(H, x, y[first : first + 128])
        seen = q * [1, -1]  # codes run counter-clockwise as seen, and the rows of an image run downwards
        fine[first : first + 128] = ring_pattern(seen, scale, ring, bits, code, hidden)
    fine = 1 - fine if inverse else fine
    c, C = ellipse_of(H)
    if cover is not None:
        xy = np.stack(np.broadcast_arrays(x, y), axis=-1)
        distance, grey = cover((xy - c) @ np.linalg.inv(np.linalg.cholesky(C)).T)
        step = np.hypot(*np.gradient(distance))
        on = share(distance / np.maximum(step, 1e-12))
        fine = fine * (1 - on) + grey * on
    image = expose(fine.astype(np.float32), rng, **light)
    return Shot(image, c, C, H[:2, 2] / H[2, 2], np.linalg.inv(H))
