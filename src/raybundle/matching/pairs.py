"""Which image pairs are worth matching: all of a small set, the likely ones of a large set."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from raybundle.numerics.arrays import Array

ALL = 60
"""Number of images up to which all pairs are matched."""
SEQUENCE = 6
NEIGHBOURS = 16
SIMILAR = 16
WORDS = 64
SAMPLE = 400
"""Descriptors of an image that go into the codebook."""


def choose_pairs(
    count: int, *, positions: Array | None = None, signatures: Array | None = None, everything: bool = False
) -> list[tuple[int, int]]:
    """Pairs (i < j) of images in the order of their names.

    positions   (n, 3) where the images were taken, NaN where not known; metres
    signatures  (n, k) unit vectors of the image contents (`signatures_of`)
    everything  all pairs, whatever the number
    Up to 60 images all pairs; otherwise the union of neighbours in the sequence, neighbours in space and images of
    similar content.
    """
    if count <= ALL or everything:
        return [(i, j) for i in range(count) for j in range(i + 1, count)]
    chosen = {(i, j) for i in range(count) for j in range(i + 1, min(i + 1 + SEQUENCE, count))}
    if positions is not None:
        chosen |= _nearest_in_space(positions)
    if signatures is not None:
        chosen |= _most_similar(signatures)
    return sorted(chosen)


def _nearest_in_space(positions: Array) -> set[tuple[int, int]]:
    from scipy.spatial import KDTree  # noqa: PLC0415

    known = np.flatnonzero(np.isfinite(positions[:, :2]).all(axis=1))
    if len(known) < 2:
        return set()
    k = min(NEIGHBOURS + 1, len(known))
    near: Array = np.reshape(KDTree(positions[known, :2]).query(positions[known, :2], k=k)[1], (len(known), k))
    return {_ordered(int(known[a]), int(known[b])) for a, row in enumerate(near) for b in row if a != b}


def _most_similar(signatures: Array) -> set[tuple[int, int]]:
    chosen: set[tuple[int, int]] = set()
    n = len(signatures)
    k = min(SIMILAR, n - 1)
    for begin in range(0, n, 512):
        likeness = signatures[begin : begin + 512] @ signatures.T
        likeness[np.arange(len(likeness)), np.arange(begin, begin + len(likeness))] = -np.inf
        best = np.argpartition(-likeness, k - 1, axis=1)[:, :k]
        chosen |= {_ordered(begin + a, int(b)) for a, row in enumerate(best) for b in row}
    return chosen


def _ordered(a: int, b: int) -> tuple[int, int]:
    return (a, b) if a < b else (b, a)


def codebook(samples: Sequence[Array]) -> Array:
    """Words (k, d) of descriptor vectors of many images, by k-means from a fixed seed."""
    import cv2  # noqa: PLC0415

    data = np.vstack([s[: SAMPLE // 2] for s in samples]).astype(np.float32)
    data = data[:: max(1, len(data) // 60_000)]
    if len(data) <= WORDS:
        return data
    cv2.setRNGSeed(1)
    stop = (cv2.TERM_CRITERIA_EPS + cv2.TERM_CRITERIA_MAX_ITER, 20, 1e-4)
    _, _, words = cv2.kmeans(data, WORDS, np.empty(0, np.int32), stop, 1, cv2.KMEANS_PP_CENTERS)
    return words


def signature(vectors: Array, words: Array) -> Array:
    """The content of an image as one unit vector: sums of differences to the nearest word (VLAD, Jégou et al. 2010)."""
    nearest = np.argmax(vectors @ words.T - 0.5 * (words**2).sum(axis=1), axis=1)
    result = np.zeros_like(words)
    np.add.at(result, nearest, vectors - words[nearest])
    result /= np.maximum(np.linalg.norm(result, axis=1, keepdims=True), 1e-12)
    flat = result.ravel()
    flat = np.sign(flat) * np.sqrt(np.abs(flat))
    return (flat / max(float(np.linalg.norm(flat)), 1e-12)).astype(np.float32)
