"""Reasons of tasks: the message of an error goes with its text through another process."""

import pickle

import pytest

from raybundle.errors import InputError, content_of, reason_of


@pytest.mark.parametrize("place", [{}, {"file": "x.csv", "line": 3}])
def test_an_error_is_made_of_its_reason_again(place):
    error = InputError("outline.no_area", name="a", **place)
    reason = pickle.loads(pickle.dumps(reason_of(error)))  # noqa: S301  (as between processes)
    again = InputError(content_of(reason))
    assert (str(reason), str(again), again.code) == (str(error), str(error), error.code)
    assert content_of(str(reason)) == str(error)
