"""Analytic textures and synthetic image points whose truth is known."""

import numpy as np

from raybundle.numerics.rotation import rotation_from_angles

SIZE = (1600, 1200)
FOCAL_PX = 1500.0


class Texture:
    """Random plane waves between two wavelengths [px]: known at every place, not only at pixels."""

    def __init__(self, seed=1, waves=40, shortest=7.0, longest=40.0):
        rng = np.random.default_rng(seed)
        length = rng.uniform(shortest, longest, waves)
        direction = rng.uniform(0, np.pi, waves)
        self.k = 2 * np.pi / length[:, None] * np.stack([np.cos(direction), np.sin(direction)], axis=1)
        self.phase = rng.uniform(0, 2 * np.pi, waves)

    def at(self, xy):
        """Values (...) of places (..., 2), mean 0, standard deviation 1."""
        total = np.zeros(xy.shape[:-1])
        for k, phase in zip(self.k, self.phase, strict=True):
            total += np.cos(xy @ k + phase)
        return total * np.sqrt(2 / len(self.k))

    def image(self, width, height, source=None, level=30000.0, contrast=6000.0):
        """uint16 picture of what `source` (pixel frame to texture) shows at the pixel centres."""
        x, y = np.meshgrid(np.arange(width) + 0.5, np.arange(height) + 0.5)
        xy = np.stack([x, y], axis=-1)
        xy = xy if source is None else source(xy)
        across, down = xy[0] - xy[0, 0], xy[:, 0] - xy[0, 0]
        if np.allclose(xy, xy[0, 0] + across + down[:, None], rtol=0, atol=1e-9):  # a wave is a product of two
            right, below = (np.exp(1j * (along @ self.k.T)) for along in (across, down))
            first = np.exp(1j * (xy[0, 0] @ self.k.T + self.phase))
            grey = ((below * first) @ right.T).real * np.sqrt(2 / len(self.k))
        else:
            grey = self.at(xy)
        return quantised(level + contrast * grey)


def quantised(grey):
    return np.clip(np.round(grey), 0, 65535).astype(np.uint16)


def noisy(image, sigma, seed):
    return quantised(image + np.random.default_rng(seed).normal(0, sigma, image.shape))


def view(xyz, centre, angles_deg):
    """Pixel frame (n, 2) of object points in a camera without distortion."""
    R = rotation_from_angles(np.radians([angles_deg]))[0]
    U, V, W = R @ (xyz - centre).T
    return np.stack([SIZE[0] / 2 - FOCAL_PX * U / W, SIZE[1] / 2 + FOCAL_PX * V / W], axis=1)


def relief(n, seed, *, plane=False):
    rng = np.random.default_rng(seed)
    xyz = rng.uniform([-2, -1.5, -1], [2, 1.5, 1], (n, 3))
    if plane:
        xyz[:, 2] = 0
    return xyz


def with_wrong_matches(p, q, wrong, seed, noise=0.4):
    """Features of two images and matches (n + wrong, 2), the wrong ones last."""
    rng = np.random.default_rng(seed)
    anywhere = rng.uniform([0, 0], SIZE, (2, wrong, 2))
    xy1 = np.concatenate([p + rng.normal(0, noise, p.shape), anywhere[0]])
    xy2 = np.concatenate([q + rng.normal(0, noise, q.shape), anywhere[1]])
    order = rng.permutation(len(xy2))
    back = np.argsort(order)
    return xy1, xy2[order], np.stack([np.arange(len(xy1)), back], axis=1).astype(np.int32)
