"""Reasons of tasks: the message of an error goes with its text through another process."""

import pickle

import pytest

from raybundle.errors import InputError, text_of_error


@pytest.mark.parametrize("place", [{}, {"file": "x.csv", "line": 3}])
def test_an_error_is_made_of_its_reason_again(place):
    error = InputError("outline.no_area", name="a", **place)
    reason = pickle.loads(pickle.dumps(text_of_error(error)))  # noqa: S301  (as between processes)
    again = InputError(reason)
    assert (str(reason), str(again), again.code) == (error.text(), str(error), error.code)
