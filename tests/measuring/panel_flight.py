"""A rendered flight over rolling ground with four kinds of panels, its block with the true orientations."""

from dataclasses import dataclass

import cv2
import numpy as np

from raybundle.block import Block, Camera, Images, Observations, Points, Stations
from raybundle.numerics.rotation import rotation_from_vector

KINDS = ("cross", "chequered", "iron", "disc")
MODEL = {"cross": "cross", "chequered": "corner", "iron": "corner", "disc": "ellipse"}
SCALE = 40.0
"""Pixels of the ground's picture in a metre"""
SIZE = (40.0, 30.0)
"""Of the ground [m]"""
C_PX, FORMAT = 900.0, (900, 600)
HEIGHT = 25.0


def ground(rng, width, height, stones=4000):
    """Grey values of soil with stones."""
    picture = np.zeros((height, width), np.float32)
    for k in range(2, 9):
        small = rng.normal(size=(max(2, height * 2**k // width), 2**k)).astype(np.float32)
        picture += cv2.resize(small, (width, height), interpolation=cv2.INTER_CUBIC) * 0.75**k * 10
    for _ in range(stones):
        at, r = (int(rng.uniform(0, width)), int(rng.uniform(0, height))), rng.uniform(1, 9)
        axes = (int(r), int(r * rng.uniform(0.4, 1)))
        cv2.ellipse(picture, at, axes, rng.uniform(0, 180), 0, 360, float(rng.normal(0, 9)), -1)
    picture += rng.normal(size=picture.shape).astype(np.float32) * 3
    return np.clip(105 + picture * 1.6, 30, 200)


def draw_panel(picture, kind, xy, size_px, angle):
    """Draw a panel about a place [px, from the outer corner of the first pixel], eight times finer than the picture."""
    n = int(size_px * 8)
    u, v = np.meshgrid(np.arange(n) - (n - 1) / 2, np.arange(n) - (n - 1) / 2)
    white = {
        "cross": (abs(u) < n * 0.09) | (abs(v) < n * 0.09), "chequered": (u > 0) == (v > 0), "iron": abs(u) > abs(v),
        "disc": np.hypot(u, v) < n * 0.32,
    }[kind]  # fmt: skip
    fine = cv2.GaussianBlur(np.where(white, 225.0, 25.0).astype(np.float32), (0, 0), 2.5)
    side = int(size_px * 1.5) + 4
    corner = np.floor(xy).astype(int) - side // 2
    M = cv2.getRotationMatrix2D(((n - 1) / 2, (n - 1) / 2), angle, 1 / 8)
    M[:, 2] += np.array(xy) - 0.5 - corner - (n - 1) / 2
    drawn, mask = (cv2.warpAffine(p, M, (side, side), flags=cv2.INTER_LINEAR) for p in (fine, np.ones_like(fine)))
    part = picture[corner[1] : corner[1] + side, corner[0] : corner[0] + side]
    part[:] = part * (1 - mask) + drawn * mask


def relief(x, y):
    """Heights of the ground."""
    return 0.8 * np.sin(x / 7 + 1) * np.cos(y / 6)


@dataclass
class Flight:
    """Pictures, the block with a datum of its own, and the truth."""

    block: Block
    pictures: dict
    given: dict
    """point -> coordinates in the datum of control"""
    kinds: dict
    """point -> kind of its panel; without one where none was laid out"""
    seen: dict
    """(image, point) -> place"""


def flight(seed=1, shift=(1.4, -0.9, 2.3), left_out=(), wrong=None):
    """A flight whose block lies `shift` from its control.

    left_out  points without a panel
    wrong     point -> error of its given coordinates
    """
    rng = np.random.default_rng(seed)
    w, h = (int(s * SCALE) for s in SIZE)
    picture = ground(rng, w, h)
    camera = Camera(
        id="C", model="brown", width_px=FORMAT[0], height_px=FORMAT[1], pixel_mm=(0.01, 0.01),
        values=dict.fromkeys(("x0", "y0", "K1", "K2", "K3", "P1", "P2", "A", "S"), 0.0) | {"c": C_PX * 0.01},
        estimate=(),
    )  # fmt: skip
    xyz, kinds = {}, {}
    for k, (x, y) in enumerate((x, y) for x in (8, 16, 24, 32) for y in (8, 15, 22)):
        at = np.array([x, y]) + rng.uniform(-1.2, 1.2, 2)
        name = f"G{k + 1}"
        xyz[name] = np.array([*at, relief(*at)])
        if name in left_out:
            continue
        kinds[name] = KINDS[k % 4]
        place = np.array([at[0], SIZE[1] - at[1]]) * SCALE
        draw_panel(picture, kinds[name], place, rng.uniform(0.5, 0.9) * SCALE, rng.uniform(0, 90))
    centres, rotations, pictures, seen = [], [], {}, {}
    soft = cv2.GaussianBlur(picture, (0, 0), 0.5)
    for k, (y, x) in enumerate((y, x) for y in (9.0, 15.0, 21.0) for x in (9.0, 14.5, 20.0, 25.5, 31.0)):
        C = np.array([x, y, HEIGHT]) + rng.normal(0, 0.4, 3)
        R = rotation_from_vector(np.array([*rng.normal(0, 0.05, 2), rng.normal(0, 0.1)]))  # camera from object
        name = f"F{k:02d}"
        centres.append(C)
        rotations.append(R)
        pictures[k] = _exposed(soft, C, R, rng)
        for point, X in xyz.items():
            if point not in kinds:
                continue
            d = R @ (X - C)
            at = np.array([FORMAT[0] / 2 - C_PX * d[0] / d[2], FORMAT[1] / 2 + C_PX * d[1] / d[2]])
            if (at > 30).all() and (at < np.array(FORMAT) - 30).all():
                seen[name, point] = at
    moved = np.array(shift)
    n = len(centres)
    block = Block(
        name="flight", length_unit="m", cameras=(camera,),
        images=Images(
            ids=tuple(f"F{k:02d}" for k in range(n)), file=tuple(f"F{k:02d}.jpg" for k in range(n)),
            camera=np.zeros(n, np.int32), centre=np.array(centres) + moved, rotation=np.array(rotations),
        ),
        points=Points(
            ids=("t",), role=np.zeros(1, np.int32), xyz=np.array([[20.0, 15.0, 0.0]]) + moved,
            sigma=np.full((1, 3), np.nan),
        ),
        observations=Observations(
            image=np.zeros(0, np.int32), point=np.zeros(0, np.int32), xy_px=np.zeros((0, 2)),
            cov_px2=np.zeros((0, 3)),
        ),
    ).having(Stations(image=np.arange(n), xyz=np.array(centres) + moved, sigma=np.ones((n, 3))))  # fmt: skip
    given = {name: X + (wrong or {}).get(name, np.zeros(3)) + rng.normal(0, 0.01, 3) for name, X in xyz.items()}
    return Flight(block=block, pictures=pictures, given=given, kinds=kinds, seen=seen)


def _exposed(picture, C, R, rng):
    u, v = np.meshgrid(np.arange(FORMAT[0]) + 0.5, np.arange(FORMAT[1]) + 0.5)
    rays = np.stack([(u - FORMAT[0] / 2) / C_PX, -(v - FORMAT[1] / 2) / C_PX, -np.ones_like(u)], axis=-1) @ R
    z = np.zeros_like(u)
    for _ in range(8):
        t = (z - C[2]) / rays[..., 2]
        x, y = C[0] + t * rays[..., 0], C[1] + t * rays[..., 1]
        z = relief(x, y)
    at = [(a * SCALE - 0.5).astype(np.float32) for a in (x, SIZE[1] - y)]
    seen = cv2.remap(picture, *at, cv2.INTER_CUBIC, borderMode=cv2.BORDER_REFLECT)
    seen = cv2.GaussianBlur(seen, (0, 0), 0.55) + rng.normal(0, 2.0, seen.shape)
    return np.clip(np.round(seen), 0, 255).astype(np.uint8)
