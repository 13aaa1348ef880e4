"""Signatures of photographs, the words that come with the package, the search for like ones."""

import numpy as np
import pytest

from raybundle.matching import nearest
from raybundle.matching.features import Features
from raybundle.matching.methods import feature_method
from raybundle.matching.nearest import most_similar
from raybundle.matching.reduced import Reduced
from raybundle.matching.signatures import (
    LENGTH,
    NORM,
    WORDS,
    likeness,
    shipped_codebook,
    shortened,
    signature,
    widest,
    words_of,
)


def contents(seed, n=200, d=16, places=10, pictures=40):
    """Descriptor vectors of pictures; every tenth shows the same place."""
    rng = np.random.default_rng(seed)
    things = rng.normal(size=(places, n, d))
    seen = [things[k % places] + rng.normal(0, 0.15, (n, d)) for k in range(pictures)]
    return [(v / np.linalg.norm(v, axis=1, keepdims=True)).astype(np.float32) for v in seen]


def test_the_shipped_words_say_their_version_and_of_what_they_were_made():
    book = shipped_codebook("rootsift")
    assert book.words.shape == (WORDS, 128)
    assert book.version == "rootsift 1"
    norms = np.linalg.norm(book.words, axis=1)
    assert ((norms > 0.3) & (norms <= 1.01)).all()  # means of unit vectors
    assert all(licence in book.about for licence in ("CC0", "CC BY 4.0", "MIT", "BSD-2-Clause"))
    judged = ("fountain", "herzjesu", "castle", "sceaux", "copr")
    assert not [name for name in judged if name in book.about.lower()]


def test_reduced_copies_have_the_words_of_their_method():
    assert Reduced(feature_method("rootsift")).codebook == feature_method("rootsift").codebook == "rootsift"


def test_pictures_of_one_place_have_like_signatures():
    vectors = contents(1)
    words = words_of(vectors, 64)
    s = np.stack([signature(v, words) for v in vectors])
    assert s.shape == (40, LENGTH)
    np.testing.assert_allclose(np.linalg.norm(s, axis=1), NORM, rtol=0.01)
    product = s.astype(float) @ s.T
    same = (np.arange(40)[:, None] - np.arange(40)) % 10 == 0
    assert product[same].min() > product[~same].max()


def test_the_words_of_a_set_are_the_same_every_time():
    vectors = contents(2)
    np.testing.assert_array_equal(words_of(vectors, 64), words_of(vectors, 64))
    few = [v[:1] for v in vectors[:5]]
    np.testing.assert_array_equal(words_of(few), np.vstack(few))


def test_a_picture_without_features_has_an_empty_signature():
    s = signature(np.zeros((0, 128), np.float32), shipped_codebook("rootsift").words)
    assert s.shape == (LENGTH,)
    assert not s.any()


def test_a_short_vector_keeps_cosines_as_it_says():
    """Signed sums: without bias, standard deviation 1 / sqrt(LENGTH)."""
    rng = np.random.default_rng(3)
    common = rng.normal(size=WORDS * 128)
    for cosine in (0.0, 0.2):
        long = np.sqrt(cosine) * common + np.sqrt(1 - cosine) * rng.normal(size=(60, WORDS * 128))
        s = np.stack([shortened(v) for v in long])
        pairs = np.stack(np.triu_indices(60, 1), axis=1)
        unit = long / np.linalg.norm(long, axis=1, keepdims=True)
        off = likeness(s, pairs) / NORM**2 - (unit @ unit.T)[tuple(pairs.T)]
        assert abs(off.mean()) < 0.005
        assert off.std() == pytest.approx(LENGTH**-0.5, rel=0.15)


def test_the_widest_features_come_first_and_of_equal_ones_the_strongest():
    f = Features(
        xy_px=np.zeros((5, 2)), scale_px=np.array([2.0, 7.0, 2.0, 9.0, 2.0]), angle=np.zeros(5),
        descriptors=np.zeros((5, 1), np.uint8),
    )  # fmt: skip
    assert widest(f, 4).tolist() == [3, 1, 0, 2]


@pytest.fixture
def small_blocks(monkeypatch):
    """Blocks so small that a test crosses many."""
    monkeypatch.setattr(nearest, "ROWS", 16)
    monkeypatch.setattr(nearest, "COLUMNS", 24)


def integers(seed, n, d=32):
    rng = np.random.default_rng(seed)
    v = rng.normal(size=(n, d))
    v[n // 2 : n // 2 + 5] = v[0]  # equal ones: ties
    return np.round(v * (NORM / np.linalg.norm(v, axis=1, keepdims=True))).astype(np.int16)


def by_sorting(s, count, rows, apart=None):
    """The same without blocks."""
    product = s.astype(np.int64) @ s.T.astype(np.int64)
    pairs = []
    for i in rows:
        others = [j for j in range(len(s)) if j != i and (apart is None or apart[i] != apart[j])]
        pairs += [(i, j) for j in sorted(others, key=lambda j: (-product[i, j], j))[:count]]
    return pairs


@pytest.mark.parametrize("count", [1, 7, 40])
@pytest.mark.parametrize("n", [5, 100])
def test_search_in_blocks_finds_exactly_the_most_alike(small_blocks, n, count):
    s = integers(4, n)
    assert list(zip(*(x.tolist() for x in most_similar(s, count)), strict=True)) == by_sorting(s, count, range(n))


def test_search_is_for_some_and_among_others_where_it_is_asked_so(small_blocks):
    s, apart = integers(5, 90), np.arange(90) % 3
    rows = np.array([3, 4, 50, 89])
    found = most_similar(s, 6, rows=rows, apart=apart)
    assert list(zip(*(x.tolist() for x in found), strict=True)) == by_sorting(s, 6, rows.tolist(), apart)
    assert [len(x) for x in most_similar(s, 6, apart=np.zeros(90, int))] == [0, 0]
    assert [len(x) for x in most_similar(s, 6, rows=np.zeros(0, int))] == [0, 0]
