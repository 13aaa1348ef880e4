"""Reasons of what takes no part: messages in memory, in the project store and in result.json."""

import json
import pickle
from pathlib import Path

import numpy as np

from raybundle.adjustment.records.notice import Notice, notice_of_text
from raybundle.errors import (
    InputError,
    excluded,
    joined_texts,
    message,
    message_of_text,
    named,
    phrase,
    text_json,
    text_of_error,
    without_file,
)
from raybundle.results.state import notice_of
from raybundle.words import Reader, headline
from raybundle.workflows.scenes.ties import _trouble
from raybundle.workflows.stage_arrays import notices_as_array, notices_of_array, reasons_as_array, reasons_of_array
from tests.messages import refused

FEW = phrase("not_oriented.few_common", n=4, least=6)
ALONE = phrase("not_oriented.alone")


def test_a_reason_is_kept_with_its_messages():
    reasons = (("a.jpg", joined_texts(FEW, ALONE)), ("b.jpg", "no image"))
    again = reasons_of_array(reasons_as_array(reasons))
    assert again == reasons
    assert [m.code for m in again[0][1].messages] == ["not_oriented.few_common", "not_oriented.alone"]
    assert again[0][1].messages[0].values == {"n": 4, "least": 6}
    assert type(again[1][1]) is str
    assert reasons_of_array(reasons_as_array(())) == ()


def test_reasons_of_earlier_projects_are_texts():
    assert reasons_of_array(np.array([["a.jpg", "only 4 points"]])) == (("a.jpg", "only 4 points"),)


def test_a_reason_is_read_in_other_languages_and_by_other_processes():
    again = pickle.loads(pickle.dumps(FEW))  # noqa: S301  (our own)
    german = Reader("de")
    assert again.by(german).startswith(headline("not_oriented.few_common", {"n": 4, "least": 6}, german))


def test_a_reason_has_its_code_in_result_json():
    found = text_json(joined_texts(FEW, ALONE))
    assert (found["code"], found["values"]) == ("not_oriented.few_common", {"n": 4, "least": 6})
    assert [d["code"] for d in found["details"]] == ["not_oriented.alone"]
    assert text_json("only 4 points") == {}


def test_reasons_are_details_of_an_error_behind_their_names():
    error = InputError(
        "photograph.too_few_usable", n=0, least=2, details=excluded([(f"{k}.jpg", FEW) for k in range(25)], ["seen"])
    )
    lines = str(error).splitlines()
    assert lines[1].startswith(f"  0.jpg: {FEW}")
    assert [d.code for d in error.message.details[20:]] == ["reason.more", "reason.text"]
    assert error.message.details[20].values == {"n": 5}


def test_a_reason_loses_the_file_that_its_list_names():
    error = InputError("photograph.too_small", width_px=9, height_px=9, file="/x/a.jpg", line=3)
    reason = text_of_error(error)
    assert reason.startswith("/x/a.jpg, line 3: ")
    assert without_file(reason, Path("/x/a.jpg")).startswith("line 3: ")
    assert without_file(reason, Path("/x/b.jpg")) == reason
    assert without_file("/x/a.jpg: damaged", Path("/x/a.jpg")) == "damaged"
    with refused("photograph.too_small", width_px=9, height_px=9) as again:
        raise InputError(reason)
    assert str(again.value).startswith("/x/a.jpg, line 3: ")
    assert named("a.jpg", "damaged").values == {"text": "damaged"}


def test_a_notice_with_the_words_of_a_remark_is_kept():
    remark = notice_of_text("photographs", ALONE)
    assert (remark.code, remark.words, remark.text) == ("photographs", "not_oriented.alone", str(ALONE))
    mirrored = Notice(code="mask_uniform.hidden", values={"n": 1}, ids=("a.jpg",))
    again = notices_of_array(notices_as_array([remark, mirrored, notice_of_text("photographs", "2 small")]))
    assert [(n.code, n.variant, n.words, n.text) for n in again[:2]] == [
        (n.code, n.variant, n.words, n.text) for n in (remark, mirrored)
    ]
    assert again[2].text == "2 small"


def test_notices_of_earlier_projects_are_read():
    rows = np.array([["photographs", "2 small", "note", "[]", "{}", "[]"]])
    (found,) = notices_of_array(rows)
    assert (found.code, found.text) == ("photographs", "2 small")


def test_a_notice_of_result_json_has_the_words_of_another_code():
    stored = {"code": "photographs", "words": "not_oriented.alone", "severity": "note", "message": "in English"}
    assert notice_of(stored).data.code == "not_oriented.alone"
    assert notice_of({**stored, "words": "not_oriented.unknown"}).text == "in English"


def test_what_is_wrong_of_a_pair_of_scenes_is_kept():
    found = message("scene.pair_scattered", n=40, spread_px=14.0, limit_px=4.0)
    assert _trouble(json.dumps(found.json())) == found
    assert _trouble("") is None
    assert _trouble("14 px apart") == message_of_text("14 px apart")
