"""Errors as details of other messages, and the errors of these again."""

import json

from raybundle.errors import InputError, Place, TasksWaiting, as_detail, as_error, message_of


def test_an_error_comes_back_from_a_detail_with_its_place():
    error = InputError("outline.no_area", name="area 2", file="plan.csv", line=3)
    detail = as_detail(error)
    assert detail.place == Place("plan.csv", 3)
    assert detail.text() == error.text()
    back = as_error(message_of(json.loads(json.dumps(detail.json()))))
    assert (str(back), back.file, back.line) == (str(error), "plan.csv", 3)


def test_an_error_without_a_place_is_a_detail_without_one():
    assert as_detail(TasksWaiting("task.shards_waiting", n=2, file_name="tasks", project="p")).place is None
    assert as_detail(InputError("outline.no_area", name="area 2")).place is None


def test_an_error_that_has_only_a_text_is_a_detail_of_it():
    assert as_detail(InputError("of a plugin")).values == {"detail": "of a plugin"}
