"""Who may ask: the checks of a server that runs on somebody's computer."""

import pytest
from starlette.testclient import TestClient
from starlette.websockets import WebSocketDisconnect

from raybundle.studio.guard import LARGEST_BODY
from tests.studio.conftest import BASE, LIVE, PORT


@pytest.fixture
def stranger(studio):
    with TestClient(studio.app(), base_url=BASE) as client:
        yield client


@pytest.mark.parametrize("path", ["/", "/api/overview", "/api/tile/0/0/0/0", "/studio.js", "/api/scene"])
def test_nothing_without_a_session(stranger, path):
    answer = stranger.get(path)
    assert answer.status_code == 401
    assert answer.json()["code"] == "studio_page.no_session"


def test_the_token_works_once(stranger, studio):
    token = studio.session.token
    first = stranger.get("/", params={"token": token}, follow_redirects=False)
    assert first.status_code == 303
    cookie = first.headers["set-cookie"]
    assert "HttpOnly" in cookie
    assert "samesite=strict" in cookie.lower()
    assert token not in cookie
    stranger.cookies.clear()
    assert stranger.get("/", params={"token": token}).status_code == 401


def test_a_wrong_token_and_a_wrong_cookie(stranger, studio):
    assert stranger.get("/", params={"token": "x" * 43}).status_code == 401
    assert not studio.session.spent
    for value in ("x", studio.session.token, '"', "a=b; c"):
        assert stranger.get("/api/overview", headers={"cookie": f"{studio.session.jar}={value}"}).status_code == 401


@pytest.mark.parametrize("host", ["evil.example", f"evil.example:{PORT}", f"127.0.0.1.evil.example:{PORT}", ""])
def test_another_name_is_refused(client, host):
    assert client.get("/api/overview", headers={"host": host}).status_code == 403


@pytest.mark.parametrize(
    "origin", ["http://evil.example", "null", f"http://127.0.0.1:{PORT + 1}", f"https://127.0.0.1:{PORT}"]
)
def test_pages_of_other_sites_are_refused(client, origin):
    send = {"id": "1", "verb": "undo", "arguments": {}}
    assert client.post("/api/action", json=send, headers={"origin": origin}).status_code == 403
    assert client.get("/api/overview", headers={"origin": origin}).status_code == 403
    with pytest.raises(WebSocketDisconnect), client.websocket_connect(LIVE, headers={"origin": origin}):
        pass


def test_what_a_browser_calls_cross_site_is_refused(client):
    assert client.get("/api/overview", headers={"sec-fetch-site": "cross-site"}).status_code == 403


def test_a_socket_without_session_or_page_is_refused(stranger, client):
    with client.websocket_connect(LIVE) as tab:
        assert tab.receive_json()["type"] == "state"
    with pytest.raises(WebSocketDisconnect), stranger.websocket_connect(LIVE, headers={"origin": BASE}):
        pass
    del client.headers["origin"]
    with pytest.raises(WebSocketDisconnect), client.websocket_connect(LIVE):
        pass


@pytest.mark.parametrize(
    "path",
    [
        "/../project.db", "/%2e%2e/project.db", "/..%2fproject.db", "/static/studio.js", "//etc/passwd",
        "/%2Fetc%2Fpasswd", "/index.html", "/studio.js%00", "/api/tile/0/0/0/..%2f..", "/api/tile/-1/0/0/0",
        "/api/tile/0/99/0/0",
        "/api/tile/99999999999999999999/0/0/0", "/api/observations?image=..%2f..%2fetc%2fpasswd", "/api/nothing",
    ],
)  # fmt: skip
def test_no_path_leads_anywhere_else(client, path):
    answer = client.get(path)
    assert answer.status_code in {404, 409}
    assert set(answer.json()) == {"error", "code"}


def test_every_answer_forbids_what_the_page_does_not_need(client):
    for path in ("/", "/studio.js", "/api/overview", "/nothing"):
        policy = client.get(path).headers["content-security-policy"]
        assert "default-src 'none'" in policy
        assert "unsafe" not in policy
        assert client.get(path).headers["x-content-type-options"] == "nosniff"


def test_requests_that_are_no_json_or_too_large(client):
    assert client.post("/api/action", content="verb=undo").status_code == 400
    assert client.post("/api/action", data={"verb": "undo"}).status_code == 400
    json = {"content-type": "application/json"}
    for content in ("[]", "{", "\xff", "[" * 100_000, '"x"'):
        assert client.post("/api/action", content=content.encode("latin-1"), headers=json).status_code == 400
    large = b'{"id": "' + b"x" * LARGEST_BODY + b'"}'
    assert client.post("/api/action", content=large, headers=json).status_code == 413

    def slowly():
        yield from (b"x" * 65536 for _ in range(LARGEST_BODY // 65536 + 1))

    assert client.post("/api/action", content=slowly(), headers=json).status_code == 413


@pytest.mark.parametrize("method", ["PUT", "DELETE", "PATCH", "OPTIONS"])
def test_no_other_methods(client, method):
    json = {"content-type": "application/json"}
    assert client.request(method, "/api/action", headers=json, content="{}").status_code in {404, 405}
