"""The photographs of the portal with coded targets over the cards that are drawn there, true to 0.01 px.

The plane of each card is projected by the true camera; between 17 x 17 exact places the distortion is interpolated.
What stands before a card in a photograph hides it there, as the truth's list of image points says.
"""

from dataclasses import replace

import cv2
import numpy as np
from PIL import Image
from scipy.interpolate import RectBivariateSpline

from raybundle.adjustment.system.predict import residuals_px
from raybundle.block import Observations, Points
from raybundle.io.block.folder import read_block
from raybundle.targets.marks import target
from tests.targets.render import ring_pattern

FAMILY = "aicon14"
DOT_M = 0.024
TURN = {"T1": 0.1, "T2": -0.1, "T3": 0.0, "T4": 0.0, "T5": 0.0, "T6": 0.0, "T7": 0.15, "T8": -0.15}
"""Of each card's normal about the vertical."""
FINE = 6


def code_of(name):
    return int(name[1:]) + 10


def projected(block, image, xyz):
    """(n, 2) of points (n, 3) by the true camera."""
    n = len(xyz)
    points = Points(
        ids=tuple(f"q{k}" for k in range(n)), role=np.zeros(n, np.int32), xyz=xyz, sigma=np.full((n, 3), np.nan)
    )
    xy = np.zeros((n, 2))
    for _ in range(6):  # residuals are those at the measured point, to first order
        o = Observations(
            image=np.full(n, image, np.int32), point=np.arange(n, dtype=np.int32), xy_px=xy,
            cov_px2=np.tile([1.0, 1.0, 0.0], (n, 1)),
        )  # fmt: skip
        xy = xy + residuals_px(replace(block, points=points, observations=o), np.arange(n))
    return xy


def hang(grey, block, image, name, rng):
    """Draw a target over its card."""
    family = target(FAMILY).rings
    centre = block.points.xyz[block.points.ids.index(name)]
    right, up = np.array([np.cos(TURN[name]), np.sin(TURN[name]), 0.0]), np.array([0, 0, 1.0])
    half = family.ground * DOT_M
    t = np.linspace(-1.2, 1.2, 17)
    s, v = np.meshgrid(t, t)
    plane = np.stack([s.ravel(), v.ravel()], axis=1) * half
    at = projected(block, image, centre + plane[:, :1] * right + plane[:, 1:] * up)
    # pixels to the plane: a homography, and what is left of it as a smooth surface
    H, _ = cv2.findHomography(plane / DOT_M, at, 0)
    low = np.floor(at.min(axis=0)).astype(int)
    high = np.ceil(at.max(axis=0)).astype(int)
    if (low < 1).any() or high[0] >= grey.shape[1] - 1 or high[1] >= grey.shape[0] - 1:
        return False
    left = at - cv2.perspectiveTransform((plane / DOT_M)[None], H)[0]
    grid = t * half / DOT_M
    bend = [RectBivariateSpline(grid, grid, left[:, k].reshape(17, 17)) for k in (0, 1)]
    w, h = high - low
    x, y = ((np.arange(n * FINE) + 0.5) / FINE for n in (w, h))
    xy = np.stack(np.meshgrid(x, y), axis=-1) + low
    q = cv2.perspectiveTransform(xy.reshape(1, -1, 2), np.linalg.inv(H))[0]
    shift = np.stack([b.ev(q[:, 1], q[:, 0]) for b in bend], axis=1)
    q = cv2.perspectiveTransform((xy.reshape(-1, 2) - shift)[None], np.linalg.inv(H))[0].reshape(*xy.shape[:2], 2)
    r = np.hypot(q[..., 0], q[..., 1])
    gx, gy = np.gradient(r, axis=1), np.gradient(r, axis=0)
    code = int(family.code_of(np.array([code_of(name)]))[0])
    fine = ring_pattern(q, 1 / np.maximum(np.hypot(gx, gy), 1e-9), family.ring, family.bits, code)
    covered = (r < family.ground).astype(float)
    value = cv2.GaussianBlur(25 + 190 * fine, (0, 0), 0.5 * FINE).reshape(h, FINE, w, FINE).mean(axis=(1, 3))
    cover = cv2.GaussianBlur(covered, (0, 0), 0.5 * FINE).reshape(h, FINE, w, FINE).mean(axis=(1, 3))
    part = grey[low[1] : high[1], low[0] : high[0]]
    drawn = value + rng.normal(0, 1.1, value.shape)
    part[:] = np.clip(np.round(part * (1 - cover[..., None]) + drawn[..., None] * cover[..., None]), 0, 255)
    return True


def hung(folder, portal, names, seed=5):
    """Photographs with targets in a folder; which target hangs in which."""
    block = read_block(portal / "truth")
    rng = np.random.default_rng(seed)
    o = block.observations
    drawn = {}
    for name in names:
        image = block.images.file.index(name)
        picture = Image.open(portal / "photos" / name)
        pixels = np.array(picture)
        seen = {block.points.ids[p] for p in o.point[o.image == image]}
        drawn[name] = [t for t in TURN if t in seen and hang(pixels, block, image, t, rng)]
        Image.fromarray(pixels).save(folder / name, quality=97, exif=picture.info["exif"])
    return drawn
