"""Other users and programs of the same machine: they get no token, and hold up nobody."""

import contextlib
import http.client
import json
import os
import socket
import threading
from urllib.parse import urlsplit

import pytest
from starlette.testclient import TestClient

from raybundle.studio import app as app_module
from raybundle.studio import serve as serving
from raybundle.studio.desk import Desk
from raybundle.studio.guard import Session
from raybundle.studio.sockets import MOST_WAITING, Server, Waiting
from tests.barriers import DEADLINE_S, wait_for
from tests.studio.conftest import BASE

FROM_FILE = {"sec-fetch-site": "cross-site", "sec-fetch-mode": "navigate", "sec-fetch-dest": "document"}


def test_the_token_is_handed_over_in_a_file_of_the_user(project, photo_folders, monkeypatch):
    seen, opened = {}, threading.Event()

    def open_(address):
        page = serving.Path(urlsplit(address).path)
        seen["address"], seen["page"], seen["mode"] = address, page.read_text(), page.stat().st_mode & 0o777
        with contextlib.closing(http.client.HTTPConnection(*seen["where"], timeout=DEADLINE_S)) as connection:
            connection.request("GET", "/")
            seen["status"] = connection.getresponse().status
        opened.set()
        seen["server"].should_exit = True

    class Seen(Server):
        def __init__(self, *more):
            super().__init__(*more)
            seen["server"] = self

    def told(address):
        seen["told"] = address
        parts = urlsplit(address)
        seen["where"] = parts.hostname, parts.port

    monkeypatch.setattr(serving.webbrowser, "open", open_)
    monkeypatch.setattr(serving, "Server", Seen)
    serving.serve(project, photo_folders, notify=told)
    assert opened.is_set()
    assert seen["status"] == 401  # it answered when the browser was opened
    token = seen["told"].partition("token=")[2]
    assert token not in seen["address"]
    assert seen["address"].startswith("file:///")
    assert token in seen["page"]
    if os.name == "posix":
        assert seen["mode"] == 0o600


@pytest.fixture
def stranger(studio):
    with TestClient(studio.app(), base_url=BASE) as client:
        yield client


def test_the_page_in_the_file_lets_in_once(stranger, studio):
    token = {"token": studio.session.token}
    first = stranger.get("/", params=token, headers=FROM_FILE, follow_redirects=False)
    assert first.status_code == 200
    assert 'content="0;url=/"' in first.text
    assert studio.session.token not in first.text
    assert "samesite=strict" in first.headers["set-cookie"].lower()
    assert stranger.get("/").status_code == 200
    stranger.cookies.clear()
    assert stranger.get("/", params=token, headers=FROM_FILE).status_code == 401


@pytest.mark.parametrize(
    ("path", "more"),
    [
        ("/", {}), ("/?token=", {}), ("/?token=x", {}), ("/api/overview?token=TOKEN", {}),
        ("/studio.js?token=TOKEN", {}),
        ("/?token=TOKEN", {"sec-fetch-mode": "no-cors"}), ("/?token=TOKEN", {"sec-fetch-dest": "iframe"}),
        ("/?token=TOKEN", {"sec-fetch-dest": "image"}), ("/?token=TOKEN", {"host": "evil.example"}),
        ("/?token=TOKEN", {"sec-fetch-site": "same-site"}),
    ],
)  # fmt: skip
def test_other_pages_are_not_let_in_by_it(stranger, studio, path, more):
    path = path.replace("TOKEN", studio.session.token)
    assert stranger.get(path, headers={**FROM_FILE, **more}, follow_redirects=False).status_code in {401, 403}
    assert not studio.session.spent


def test_a_browser_that_opens_the_file_gets_in(browser, project, photo_folders, tmp_path):
    with running(project, photo_folders, tmp_path) as (session, _):
        page = serving.hand_over(session.address, tmp_path)
        context = browser.new_context()
        try:
            tab = context.new_page()
            tab.goto(page.as_uri())
            tab.wait_for_url(f"http://127.0.0.1:{session.port}/", timeout=1000 * DEADLINE_S)
            tab.wait_for_function(
                "document.title.length > 0 && !!document.querySelector('script')", timeout=1000 * DEADLINE_S
            )
        finally:
            context.close()


@contextlib.contextmanager
def running(project, photos, folder, waiting=None):
    """A server in a thread."""
    (folder / "opened").mkdir()
    desk = Desk.open(project, folder / "opened", photos)
    begun = threading.Event()
    with serving.listening(0) as connection:
        session = Session(port=connection.getsockname()[1])
        studio = serving.Studio.of(desk, session)
        config = serving.configured(studio.app(), Waiting() if waiting is None else waiting)
        server = Server(config, begun.set)
        thread = threading.Thread(target=server.run, kwargs={"sockets": [connection]})
        thread.start()
        try:
            assert begun.wait(DEADLINE_S)
            studio.work.wait()
            yield session, studio
        finally:
            server.should_exit = True
            thread.join(DEADLINE_S)


def entered(session):
    """A function that asks, as the user's browser does: status and body."""
    with contextlib.closing(http.client.HTTPConnection("127.0.0.1", session.port, timeout=DEADLINE_S)) as connection:
        connection.request("GET", f"/?token={session.token}")
        cookie = connection.getresponse().getheader("set-cookie").partition(";")[0]

    def ask(method, path, body=None):
        with contextlib.closing(
            http.client.HTTPConnection("127.0.0.1", session.port, timeout=DEADLINE_S)
        ) as connection:
            headers = {
                "cookie": cookie,
                "content-type": "application/json",
                "origin": f"http://127.0.0.1:{session.port}",
            }
            connection.request(method, path, body, headers)
            answer = connection.getresponse()
            return answer.status, answer.read()

    return ask


def test_600_half_open_connections_do_not_keep_the_user_out(project, photo_folders, tmp_path):
    waiting, half = Waiting(seconds=DEADLINE_S), []
    with running(project, photo_folders, tmp_path, waiting) as (session, _):
        ask = entered(session)
        try:
            for _ in range(600):
                half.append(socket.create_connection(("127.0.0.1", session.port), timeout=DEADLINE_S))
                with contextlib.suppress(OSError):  # closed for others already
                    half[-1].sendall(b"GET / HTTP/1.1\r\nhost: 127.0")
            assert ask("GET", "/api/overview")[0] == 200
            assert 0 < waiting.count <= MOST_WAITING
        finally:
            for each in half:
                each.close()


def test_a_header_that_does_not_end_is_closed(project, photo_folders, tmp_path):
    waiting = Waiting(seconds=10 * DEADLINE_S)
    with running(project, photo_folders, tmp_path, waiting) as (session, _):
        ask = entered(session)
        waiting.seconds = 0.3
        for first in (
            b"",
            b"GET / HTTP/1.1\r\nhost: ",
            f"GET / HTTP/1.1\r\nhost: 127.0.0.1:{session.port}\r\n".encode(),
        ):
            with socket.create_connection(("127.0.0.1", session.port), timeout=DEADLINE_S) as half:
                half.sendall(first)
                with contextlib.suppress(ConnectionError):
                    assert half.recv(10) == b""
        waiting.seconds = 10 * DEADLINE_S
        assert ask("GET", "/api/overview")[0] == 200


@pytest.mark.parametrize("count", [40_000, pytest.param(400_000, marks=pytest.mark.long)])
def test_a_large_table_does_not_stop_the_others(project, photo_folders, tmp_path, monkeypatch, count):
    """Its rows are refused or taken; while they are read, others are answered."""
    rows = "\n".join(f"p{k},{k % 977},{k % 983},1" for k in range(count))
    body = json.dumps({"id": "table", "file": "control.csv", "text": "point,X,Y,Z\n" + rows})
    at, go, read = threading.Event(), threading.Event(), app_module.control_of_text

    def held(*given):
        at.set()
        assert go.wait(DEADLINE_S)
        return read(*given)

    monkeypatch.setattr(app_module, "control_of_text", held)
    with running(project, photo_folders, tmp_path) as (session, _):
        ask, done = entered(session), []
        thread = threading.Thread(target=lambda: done.append(ask("POST", "/api/control", body)))
        thread.start()
        wait_for(lambda: at.is_set() or done, "it is read, or refused before")
        for _ in range(3):
            assert ask("GET", "/icon.svg")[0] == 200
        go.set()
        thread.join()
        assert done[0][0] in {200, 409, 413}, done
