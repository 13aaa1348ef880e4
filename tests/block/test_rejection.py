"""Reasons of rejections are data; files have them alike in every language."""

import pytest

from raybundle import words as catalogue
from raybundle.block.rejection import Rejection, RejectionKind, counts, words

TEST = {"tau": 5.24, "limit": 4.2, "axis": "x"}


@pytest.mark.parametrize(
    ("reason", "expected"),
    [
        (Rejection(kind=RejectionKind.BLUNDER, **TEST), "blunder: tau 5.24 > 4.20 in x"),
        (Rejection(kind=RejectionKind.BLUNDER, tau=4.128, limit=4.12, axis="y"), "blunder: tau 4.13 > 4.12 in y"),
        (Rejection(kind=RejectionKind.BEHIND_CAMERA), "behind camera"),
    ],
)
def test_a_reason_of_files_is_the_same_for_every_reader(reason, expected):
    with catalogue.reading(catalogue.Reader("de")):
        assert str(reason) == expected
        assert reason.text != expected


def test_every_kind_has_words_and_is_counted_the_most_frequent_first():
    assert len({str(Rejection(kind=k)) for k in RejectionKind}) == len(RejectionKind)
    one, two = Rejection(kind=RejectionKind.SINGLE_RAY), Rejection(kind=RejectionKind.BLUNDER, **TEST)
    assert list(counts([None, one, two, None, two]).items()) == [("blunder", 2), ("single_ray", 1)]
    assert words([None, one]) == ("", str(one))
