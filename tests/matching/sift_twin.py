"""Features (Lowe 2004) with NumPy, in doubles and whole images at once: the twin of cpp/features.cpp.

Of equal differences the kernel takes one, the twin all.
"""

import numpy as np
from scipy.ndimage import correlate1d, maximum_filter, minimum_filter

SIGMA, LEVELS, BORDER = 1.6, 3, 5


def smooth(image, sigma):
    radius = max(1, int(np.ceil(3.5 * sigma)))
    weight = np.exp(-0.5 * (np.arange(-radius, radius + 1) / sigma) ** 2)
    for axis in (0, 1):
        image = correlate1d(image, weight / weight.sum(), axis, mode="mirror")
    return image


def doubled_image(image):
    h, w = image.shape
    y, x = (np.arange(2 * n - 1) for n in (h, w))
    rows = 0.5 * (image[y // 2] + image[(y + 1) // 2])
    return 0.5 * (rows[:, x // 2] + rows[:, (x + 1) // 2])


def octaves(grey, *, doubled=False):
    """Smoothed images (6, h, w) of each octave and its pixel."""
    image, pixel = np.asarray(grey, float), 1.0
    if doubled:
        image, pixel = doubled_image(image), 0.5
    step = [SIGMA * np.sqrt(4 ** (k / LEVELS) - 4 ** ((k - 1) / LEVELS)) for k in range(1, LEVELS + 3)]
    first = smooth(image, SIGMA) if min(image.shape) >= 2 * BORDER + 3 else image
    while min(first.shape) >= 2 * BORDER + 3:
        G = [first]
        for sigma in step:
            G.append(smooth(G[-1], sigma))
        yield np.array(G), pixel
        first, pixel = np.floor(256 * G[LEVELS][::2, ::2] + 0.5) / 256, 2 * pixel


def weights(n, x):
    """Of n values at ..., -1, 0, 1, ... in the polynomial through them, and in its slope."""
    powers = np.vander(np.arange(n) - n // 2, increasing=True)
    inverse = np.linalg.inv(powers)
    k = np.arange(n)
    return x**k @ inverse, np.append(0, k[1:] * x ** k[:-1]) @ inverse


def refined(D, at, least):
    """Place (level, y, x), value of an extremum by the polynomial through 75 differences; None where there is none."""
    start = np.array(at)
    at = start.copy()
    for _ in range(5):
        cube = D[tuple(slice(k - 1, k + 2) for k in at)]
        g = np.array([cube[2, 1, 1] - cube[0, 1, 1], cube[1, 2, 1] - cube[1, 0, 1], cube[1, 1, 2] - cube[1, 1, 0]]) / 2
        H = np.empty((3, 3))
        for i, a in enumerate(np.eye(3, dtype=int)):
            for j, b in enumerate(np.eye(3, dtype=int)):
                c = cube[tuple(1 + a + b)] if i != j else None
                H[i, j] = (
                    cube[tuple(1 + a)] + cube[tuple(1 - a)] - 2 * cube[1, 1, 1]
                    if c is None
                    else (c + cube[tuple(1 - a - b)] - cube[tuple(1 + a - b)] - cube[tuple(1 - a + b)]) / 4
                )
        move = -np.linalg.solve(H, g)
        if np.abs(move).max() < 0.6:
            value = cube[1, 1, 1] + g @ move / 2
            plane = H[1:, 1:]
            edge = np.trace(plane) ** 2 * 10 >= 121 * np.linalg.det(plane)
            if abs(value) <= least or edge:
                return None
            s, y, x = at
            around = D[s - 1 : s + 2, y - 2 : y + 3, x - 2 : x + 3]
            for _ in range(3):
                (p, dp), (q, dq), (r, dr) = (weights(n, d) for n, d in zip((3, 5, 5), move, strict=True))
                slope = [np.einsum("sji,s,j,i", around, *w) for w in ((dp, q, r), (p, dq, r), (p, q, dr))]
                move = move - np.linalg.solve(H, slope)
            return (at + move, abs(value), at[0]) if np.abs(move).max() < 1 else None
        at = at + np.round(move).astype(int)
        if np.abs(at - start)[1:].max() > 2 or not 1 <= at[0] <= LEVELS:
            return None
    return None


def search(grey, least, *, doubled=False):
    """Extrema (n, 4): x, y in the pixel frame, scale, strength; and for each its smoothed image, place there, sigma."""
    table, where = [], []
    for G, pixel in octaves(grey, doubled=doubled):
        D = np.diff(G, axis=0)
        found = ((maximum_filter(D, 3) == D) & (least < 2 * D)) | ((minimum_filter(D, 3) == D) & (-least > 2 * D))
        found[:, :BORDER], found[:, -BORDER:], found[:, :, :BORDER], found[:, :, -BORDER:] = [False] * 4
        found[[0, -1]] = False
        thinned = 2 if pixel == 0.5 else 1
        for at in np.argwhere(found):
            r = refined(D, at, least)
            if r is not None:
                (s, y, x), strength, level = r
                sigma = SIGMA * 2 ** (s / LEVELS)
                table.append([x * pixel + 0.5, y * pixel + 0.5, sigma * pixel, strength])
                where.append((G[level][::thinned, ::thinned], x / thinned, y / thinned, sigma / thinned))
    return np.array(table).reshape(-1, 4), where


def gradients(where, u, v):
    """(dx, dy) at places relative to an extremum, at the nearest pixels; 0 outside."""
    G, x, y, _ = where
    h, w = G.shape
    i, j = np.floor(x + u + 0.5).astype(int), np.floor(y + v + 0.5).astype(int)
    inside = (i >= 1) & (j >= 1) & (i < w - 1) & (j < h - 1)
    i, j = np.where(inside, i, 1), np.where(inside, j, 1)
    return inside * (G[j, i + 1] - G[j, i - 1]), inside * (G[j + 1, i] - G[j - 1, i])


def direction(where):
    """The strongest direction [rad]."""
    sigma = where[3]
    a, b = np.meshgrid(*2 * [(np.arange(16) - 7.5) * 9 / 16])
    dx, dy = gradients(where, a * sigma, b * sigma)
    weight = np.exp(-(a * a + b * b) / (2 * 1.5**2)) * (np.hypot(a, b) <= 4.5)
    bins = np.round(np.arctan2(dy, dx) * 36 / (2 * np.pi)).astype(int) % 36
    sums = np.bincount(bins.ravel(), (weight * np.hypot(dx, dy)).ravel(), 36)
    sums = correlate1d(sums, np.array([1, 4, 6, 4, 1]) / 16, mode="wrap")
    k = int(np.argmax(sums))
    l, c, r = sums[k - 1], sums[k], sums[(k + 1) % 36]
    return (k + 0.5 * (l - r) / (l - 2 * c + r)) * 2 * np.pi / 36


def descriptor(where, angle):
    """(128,) bytes: 4 x 4 cells of 3 sigma, 8 directions each."""
    sigma = where[3]
    a, b = np.meshgrid(*2 * [(np.arange(20) + 0.5) / 4 - 2.5])
    c, s = np.cos(angle), np.sin(angle)
    dx, dy = gradients(where, 3 * sigma * (c * a - s * b), 3 * sigma * (s * a + c * b))
    m = np.hypot(dx, dy) * np.exp(-(a * a + b * b) / 8)
    turn = (angle - np.arctan2(dy, dx)) * 4 / np.pi
    hist = np.zeros((4, 4, 8))
    for j in range(4):
        for i in range(4):
            near = np.clip(1 - np.abs(a - i + 1.5), 0, None) * np.clip(1 - np.abs(b - j + 1.5), 0, None)
            for k in range(8):
                apart = np.abs((turn - k + 4) % 8 - 4)
                hist[j, i, k] = (m * near * np.clip(1 - apart, 0, None)).sum()
    f = hist.ravel()
    f = np.minimum(f, 0.2 * np.linalg.norm(f))
    return np.minimum(255, np.floor(512 * np.sqrt(f / max(f.sum(), 1e-9)) + 0.5))
