"""Reasons of rejections are data; their words are those that files have always shown."""

import pytest

from raybundle.block.rejection import WORDS, Rejection, RejectionKind, counts, words

TEST = {"tau": 5.24, "limit": 4.2, "axis": "x"}


@pytest.mark.parametrize(
    ("reason", "expected"),
    [
        (Rejection(kind=RejectionKind.BLUNDER, **TEST), "blunder: tau 5.24 > 4.20 in x"),
        (
            Rejection(kind=RejectionKind.BLUNDER_NOT_LOCATED, **TEST),
            "blunder in one of the point's rays: tau 5.24 > 4.20 in x of one ray",
        ),
        (Rejection(kind=RejectionKind.BLUNDER, tau=4.128, limit=4.12, axis="y"), "blunder: tau 4.13 > 4.12 in y"),
        (Rejection(kind=RejectionKind.BEHIND_CAMERA), "behind the camera"),
        (Rejection(kind=RejectionKind.SINGLE_RAY), "single ray left"),
        (Rejection(kind=RejectionKind.GIVEN, detail="given as an outlier"), "given as an outlier"),
    ],
)
def test_the_words_are_as_before(reason, expected):
    assert str(reason) == expected


def test_every_kind_has_words_and_is_counted_the_most_frequent_first():
    assert set(WORDS) == set(RejectionKind)
    one, two = Rejection(kind=RejectionKind.SINGLE_RAY), Rejection(kind=RejectionKind.BLUNDER, **TEST)
    assert list(counts([None, one, two, None, two]).items()) == [("blunder", 2), ("single_ray", 1)]
    assert words([None, one]) == ("", WORDS[one.kind])
