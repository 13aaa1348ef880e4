"""A folder that cannot be written: it is named; what is there can be looked at, and nothing is lost."""

import os
import stat
from contextlib import contextmanager

import pytest
from starlette.testclient import TestClient

from raybundle.errors import InputError
from raybundle.measuring.journal import Journal, entries_of, journal_path
from raybundle.studio.app import Studio
from raybundle.studio.desk import Desk
from raybundle.studio.guard import Session
from tests.studio.conftest import BASE, PORT
from tests.studio.test_app import mark


@contextmanager
def read_only(*folders):
    """Nobody may write in the folders meanwhile."""
    before = {p: p.stat().st_mode for top in folders for p in (top, *top.rglob("*"))}
    for path, mode in before.items():
        path.chmod(mode & ~(stat.S_IWUSR | stat.S_IWGRP | stat.S_IWOTH))
    try:
        if os.access(folders[0], os.W_OK):
            pytest.skip("this user may write everywhere")
        yield
    finally:
        for path, mode in before.items():
            path.chmod(mode)


@contextmanager
def opened(project, photo_folders, tiles):
    """A browser that has entered."""
    tiles.mkdir()
    desk = Desk.open(project, tiles, photo_folders)
    studio = Studio.of(desk, Session(port=PORT))
    with TestClient(studio.app(), base_url=BASE) as client:
        client.get("/", params={"token": studio.session.token})
        client.headers["origin"] = BASE
        studio.work.wait()
        yield client, desk, studio


def asked(client):
    """Everything that can be looked at answers."""
    for path in ("/api/overview", "/api/points", "/api/journal", "/api/run", "/api/table/observations", "/api/scene"):
        assert client.get(path).status_code == 200, path
    return client.get("/api/overview").json()


@pytest.mark.parametrize("before", [0, 1, 3])
def test_a_folder_that_is_read_only_from_the_beginning(project, photo_folders, tmp_path, before):
    with opened(project, photo_folders, tmp_path / "first") as (client, _, _):
        image = client.get("/api/overview").json()["images"][0]["id"]
        for k in range(before):
            assert mark(client, image, f"p{k}", 10.0 + k, 20.0).status_code == 200
    if not before:
        journal_path(project).unlink(missing_ok=True)
    with read_only(project.parent), opened(project, photo_folders, tmp_path / "t") as (client, desk, _):
        assert len(asked(client)["state"]["marks"]) == before
        refused = mark(client, image, "p9", 50.0, 20.0)
        assert refused.status_code == 409
        assert str(project) in refused.json()["error"]
        assert refused.json()["code"] == "journal.read_only"
        assert len(asked(client)["state"]["marks"]) == before
        assert desk.journal.read_only
    assert len(entries_of(journal_path(project))) == before
    with opened(project, photo_folders, tmp_path / "again") as (client, _, _):
        assert mark(client, image, "p9", 50.0, 20.0).status_code == 200


def test_a_folder_that_becomes_read_only_loses_nothing(project, photo_folders, tmp_path, monkeypatch):
    sent = []
    monkeypatch.setattr("raybundle.studio.watchers.Live.notify_from_thread", lambda _, message: sent.append(message))
    with opened(project, photo_folders, tmp_path / "t") as (client, desk, studio):
        image = client.get("/api/overview").json()["images"][0]["id"]
        assert mark(client, image, "p1", 10.0, 20.0).status_code == 200
        with read_only(project.parent):
            second = mark(client, image, "p2", 10.0, 30.0)
            assert second.status_code in {200, 409}  # files that are open may be written still
            assert client.post("/api/adjust", json={}).json()["begun"]
            studio.work.wait()
            code = next(m["code"] for m in reversed(sent) if m["type"] == "adjusted")
            assert code in {"", "folder.not_writable", "file.not_writable"}
            asked(client)
        kept = 1 + (second.status_code == 200)
        assert len(desk.journal.entries()) == kept
        assert mark(client, image, "p3", 10.0, 40.0).status_code == 200
        assert client.post("/api/adjust", json={}).json()["begun"]
        studio.work.wait()
        assert (project / "result/result.json").is_file()
    assert len(entries_of(journal_path(project))) == kept + 1


def test_a_damaged_journal_in_such_a_folder_is_named(project, photo_folders, tmp_path):
    journal_path(project).write_bytes(b"none of ours" * 100)
    (tmp_path / "t").mkdir()
    with read_only(project.parent), pytest.raises(InputError) as refused:
        Desk.open(project, tmp_path / "t", photo_folders)
    assert refused.value.code == "journal.not_usable"
    assert refused.value.message.values["cause"] == "damaged"


def test_a_journal_that_may_be_written_is_opened_as_ever(desk, project):
    assert not desk.journal.read_only
    with Journal.open_or_look(journal_path(project), desk.journal.known) as again:
        assert not again.read_only
