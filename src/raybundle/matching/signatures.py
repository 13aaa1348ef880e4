"""What a photograph shows, as one short vector: photographs with like vectors may show the same."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from functools import lru_cache
from pathlib import Path

import numpy as np

from raybundle.matching.features import Described, Features
from raybundle.numerics.arrays import Array, Index

VERSION = 1
"""Raised with every change of what `signature` gives from the same words."""
DESCRIBED = 3000
"""Features of a photograph that its signature is made of, those of the widest surroundings: of fine ones there are
many that only the nearest photographs share."""
COARSE = 1000
"""Features by which photographs are compared before they are matched."""
WORDS = 256
LENGTH = 2048
"""Numbers of a signature.  Of its 256 x 128 sums each goes into one of them, with one of two signs."""
NORM = 4000.0
"""Norm of a signature in whole numbers: below 4096, so that float32 holds all sums of products of two exactly."""
SAMPLE, SAMPLED = 60_000, 200
"""Descriptors and photographs from which words are learnt where a method brings none."""
BYTES_OF_ONE = 512.0
"""Of words as they are kept: the bytes of a component of 1, as of stored RootSIFT."""


@dataclass(frozen=True, slots=True, kw_only=True)
class Codebook:
    """Words: typical descriptor vectors, to the nearest of which others are compared."""

    words: Array
    """(k, d) float32"""
    version: str
    """changes with the words"""
    about: str = ""
    """of what they were made"""


@lru_cache
def shipped_codebook(name: str) -> Codebook:
    """The words that come with the package (tools/make_codebook.py): as bytes, with their version and sources."""
    with np.load(Path(__file__).parent / "codebooks" / f"{name}.npz", allow_pickle=False) as file:
        words = file["words"].astype(np.float32) / np.float32(BYTES_OF_ONE)
        return Codebook(words=words, version=f"{name} {int(file['version'])}", about=str(file["about"]))


def words_of(samples: Sequence[Array], count: int = WORDS) -> Array:
    """Words (count, d) float32 of unit vectors of many photographs, by k-means from a fixed seed.

    samples  (n, d) float32 of each photograph; where they are fewer than words asked for, they are the words
    """
    import cv2

    data = np.ascontiguousarray(np.vstack(samples), np.float32)
    if len(data) <= count:
        return data
    cv2.setRNGSeed(1)
    stop = (cv2.TERM_CRITERIA_EPS + cv2.TERM_CRITERIA_MAX_ITER, 20, 1e-4)
    return cv2.kmeans(data, count, np.empty(0, np.int32), stop, 1, cv2.KMEANS_PP_CENTERS)[2]


def widest(features: Features | Described, count: int) -> Index:
    """Positions of the features of the widest surroundings; of equal ones the strongest."""
    return np.argsort(-features.scale_px, kind="stable")[:count]


def signature(vectors: Array, words: Array) -> Array:
    """(LENGTH,) int16 of norm 4000 or, without features, 0: sums of differences to the nearest word, shortened.

    vectors  (n, d) unit vectors of the features
    words    (k, d)
    The sums of each word have unit length, and of every component the root is taken, so that what repeats in one
    photograph does not outweigh the rest (VLAD, Jégou et al. 2010; Arandjelović and Zisserman 2013).

    What the product of two signatures does not show: whether the same things stand in the same order.
    """
    total = np.zeros(words.shape, np.float64)
    if len(vectors):
        nearest = np.argmax(vectors @ words.T - 0.5 * (words**2).sum(axis=1), axis=1)
        np.add.at(total, nearest, vectors - words[nearest])
    total /= np.maximum(np.linalg.norm(total, axis=1, keepdims=True), 1e-12)
    return shortened(np.sign(total.ravel()) * np.sqrt(np.abs(total.ravel())))


def shortened(long: Array) -> Array:
    """(LENGTH,) int16 of norm 4000, or 0: signed sums of the components of a vector, chosen by a hash.

    Cosines of two vectors are kept, with a standard deviation of 1 / sqrt(LENGTH) (Charikar et al. 2002).
    """
    place, sign = _places(long.size)
    short = np.bincount(place, long * sign, LENGTH)
    return np.round(short * (NORM / max(float(np.linalg.norm(short)), 1e-12))).astype(np.int16)


@lru_cache
def _places(size: int) -> tuple[Index, Array]:
    """Where each component goes, and with which sign: SplitMix64 (Steele et al. 2014) of its number."""
    x = np.arange(1, size + 1, dtype=np.uint64) * np.uint64(0x9E3779B97F4A7C15)
    x = (x ^ (x >> np.uint64(30))) * np.uint64(0xBF58476D1CE4E5B9)
    x = (x ^ (x >> np.uint64(27))) * np.uint64(0x94D049BB133111EB)
    x ^= x >> np.uint64(31)
    return (x % np.uint64(LENGTH)).astype(np.int64), np.where(x >> np.uint64(63), 1.0, -1.0)


def likeness(signatures: Array, pairs: Index) -> Array:
    """(m,) int64: products of the signatures (n, LENGTH) of pairs (m, 2); 16e6 for equal ones."""
    result = np.zeros(len(pairs), np.int64)
    for begin in range(0, len(pairs), 4096):
        i, j = pairs[begin : begin + 4096].T
        result[begin : begin + 4096] = np.einsum(
            "ij,ij->i", signatures[i].astype(np.int64), signatures[j], dtype=np.int64
        )
    return result
