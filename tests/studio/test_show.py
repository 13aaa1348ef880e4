"""The studio from Python: a process beside the program, of a folder or of an adjustment in memory."""

import sys
import urllib.request
from pathlib import Path
from urllib.parse import urlsplit

import pytest

import raybundle as rb
from raybundle.errors import InputError
from raybundle.planning.simulate import Survey, simulate
from raybundle.planning.synthetic_networks import TargetField, field_scene
from tests.barriers import DEADLINE_S


@pytest.fixture
def quiet(monkeypatch):
    opened = []
    monkeypatch.delitem(sys.modules, "ipykernel", raising=False)  # of the tests of notebooks
    monkeypatch.setattr("webbrowser.open", opened.append)
    return opened


@pytest.fixture
def result():
    return rb.adjust(simulate(field_scene(TargetField(rows=4, columns=5, stations=4)), Survey(control=4)).observed)


@pytest.mark.long
def test_an_adjustment_opens_in_a_folder_and_the_folder_again(result, quiet, tmp_path):
    studio = rb.show(result, tmp_path / "result", what="studio")
    try:
        assert studio.address.partition("token=")[2] not in quiet[0]  # a command line is read by all users
        assert studio.address in Path(urlsplit(quiet[0]).path).read_text()
        opener = urllib.request.build_opener(urllib.request.HTTPCookieProcessor())
        assert b"studio" in opener.open(studio.address, timeout=DEADLINE_S).read()
        assert studio.address in studio._repr_html_()
        assert str(tmp_path / "result") in repr(studio)
    finally:
        studio.stop()
    assert repr(studio).endswith("ended>")
    again = rb.show(rb.read_result(tmp_path / "result"))
    again.stop()
    assert again.folder == tmp_path / "result"


def test_what_cannot_be_opened_is_said(result, quiet, tmp_path):
    with pytest.raises(InputError, match=r"session\.no_project"):
        rb.show(tmp_path)
    with pytest.raises(InputError, match=r"studio\.page_of_folder"):
        rb.show(tmp_path, what="report")
    with pytest.raises(InputError, match=r"studio\.path_of_folder"):
        rb.show(tmp_path, tmp_path / "x")
    assert not quiet
