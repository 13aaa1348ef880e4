"""Who may ask the studio's server: whoever has the session, from its own page, with a message of reasonable size.

The first load of the page carries a token that works once; it is exchanged for a cookie that scripts cannot read and
that no other site's page can send (HttpOnly, SameSite=Strict).  Hosts other than the loopback's names are refused, so
that a name that somebody else's name server points here (DNS rebinding) is of no use.
"""

from __future__ import annotations

import hmac
import secrets
from dataclasses import dataclass, field
from http.cookies import CookieError, SimpleCookie
from urllib.parse import parse_qs

from starlette.datastructures import Headers, MutableHeaders
from starlette.responses import HTMLResponse, JSONResponse, RedirectResponse
from starlette.types import ASGIApp, Message, Receive, Scope, Send

from raybundle.errors import Text, code_of, phrase
from raybundle.words import COMMAND_LINE, Reader

COOKIE = "raybundle-studio"
LARGEST_BODY = 8 * 1024 * 1024
"""Bytes of a request: a table of control with a hundred thousand points."""
POLICY = (
    "default-src 'none'; script-src 'self'; style-src 'self'; img-src 'self' blob:; connect-src 'self'; "
    "frame-src 'self'; font-src 'self'; base-uri 'none'; form-action 'none'; frame-ancestors 'none'"
)
POLICY_HEADER = "content-security-policy"
HEADERS = {
    POLICY_HEADER: POLICY,
    "x-content-type-options": "nosniff",
    "referrer-policy": "no-referrer",
    "cross-origin-opener-policy": "same-origin",
    "cross-origin-resource-policy": "same-origin",
    "x-frame-options": "DENY",
}

ONWARDS = '<!doctype html><meta charset="utf-8"><title>studio</title><meta http-equiv="refresh" content="0;url=/">'
"""The page that leads to the studio's own, once the cookie is set"""


@dataclass(slots=True)
class Session:
    """The secrets of one run of the server."""

    port: int
    token: str = field(default_factory=lambda: secrets.token_urlsafe(32))
    """in the address that is opened first; works once"""
    cookie: str = field(default_factory=lambda: secrets.token_urlsafe(32))
    spent: bool = False
    reader: Reader = COMMAND_LINE
    """whoever opens the address"""

    @property
    def hosts(self) -> frozenset[str]:
        """What the page may be called."""
        return frozenset(f"{name}:{self.port}" for name in ("127.0.0.1", "localhost", "[::1]"))

    @property
    def address(self) -> str:
        """The address to open."""
        return f"http://127.0.0.1:{self.port}/?token={self.token}"

    @property
    def jar(self) -> str:
        """Name of the cookie: cookies know no ports, and two studios must not take each other's."""
        return f"{COOKIE}-{self.port}"

    def enters(self, token: str) -> bool:
        """Whether a token lets in; it does so once."""
        if self.spent or not hmac.compare_digest(token.encode(), self.token.encode()):
            return False
        self.spent = True
        return True

    def knows(self, headers: Headers) -> bool:
        """Whether a request comes from the session."""
        jar = SimpleCookie()
        try:
            jar.load(headers.get("cookie", ""))
        except CookieError:
            return False
        found = jar.get(self.jar)
        return found is not None and hmac.compare_digest(found.value.encode(), self.cookie.encode())


class Guard:
    """Everything that is asked passes here first."""

    def __init__(self, app: ASGIApp, session: Session) -> None:
        self.app = app
        self.session = session

    async def __call__(self, scope: Scope, receive: Receive, send: Send) -> None:
        """Refuse, let in, or hand on."""
        if scope["type"] == "lifespan":
            await self.app(scope, receive, send)
            return
        headers = Headers(scope=scope)
        if self._handed_over(scope, headers):
            await self._enter(scope, receive, send, from_file=True)
            return
        refusal = self._refusal(scope, headers)
        if refusal is not None:
            await self._refused(scope, receive, send, *refusal)
            return
        if not self.session.knows(headers):
            await self._enter(scope, receive, send)
            return
        await self.app(scope, _Limited(receive), _with_headers(send))

    def _refusal(self, scope: Scope, headers: Headers) -> tuple[int, Text] | None:
        if headers.get("host", "").lower() not in self.session.hosts:
            return 403, phrase("studio_page.other_host")
        origin = headers.get("origin")
        if origin is not None and origin.removeprefix("http://").lower() not in self.session.hosts:
            return 403, phrase("studio_page.other_site")
        if headers.get("sec-fetch-site", "") in {"cross-site", "same-site"}:
            return 403, phrase("studio_page.other_site")
        if scope["type"] == "websocket" and origin is None:
            return 403, phrase("studio_page.no_origin")
        writes = scope.get("method") not in {"GET", "HEAD", None}
        if writes and headers.get("content-type", "").split(";")[0].strip() != "application/json":
            return 400, phrase("studio_page.not_json")
        length = headers.get("content-length", "0")
        if not length.isdigit() or int(length) > LARGEST_BODY:
            return 413, phrase("studio_page.too_large", most=LARGEST_BODY)
        return None

    def _handed_over(self, scope: Scope, headers: Headers) -> bool:
        """Whether the page that the command wrote into a file leads here: to a browser a file is another site."""
        return (
            scope["type"] == "http" and scope["method"] == "GET" and scope["path"] == "/"
            and headers.get("host", "").lower() in self.session.hosts
            and headers.get("sec-fetch-site") == "cross-site" and headers.get("sec-fetch-mode") == "navigate"
            and headers.get("sec-fetch-dest") == "document" and b"token=" in scope.get("query_string", b"")
        )  # fmt: skip

    async def _enter(self, scope: Scope, receive: Receive, send: Send, *, from_file: bool = False) -> None:
        given = parse_qs(scope.get("query_string", b"").decode("latin-1")).get("token", [""])[0]
        if scope.get("method") == "GET" and scope["path"] == "/" and given and self.session.enters(given):
            # the cookie goes with what a page of ours asks for, and not with a redirection that began at a file
            onwards = {**HEADERS, "cache-control": "no-store"}
            answer = HTMLResponse(ONWARDS, headers=onwards) if from_file else RedirectResponse("/", 303, HEADERS)
            answer.set_cookie(self.session.jar, self.session.cookie, httponly=True, samesite="strict", path="/")
            await answer(scope, receive, send)
            return
        await self._refused(scope, receive, send, 401, phrase("studio_page.no_session"))

    async def _refused(self, scope: Scope, receive: Receive, send: Send, status: int, reason: Text) -> None:
        words = reason.by(self.session.reader)
        if scope["type"] == "websocket":
            await send({"type": "websocket.close", "code": 1008, "reason": words})
            return
        closing = {**HEADERS, "connection": "close"}  # who has no session holds no connection
        content = {"error": words, "code": code_of(reason)}
        await JSONResponse(content, status_code=status, headers=closing)(scope, receive, send)


class TooLarge(Exception):
    """A body that goes on beyond the limit, whatever its header stated."""


class _Limited:
    """A request's body, counted."""

    def __init__(self, receive: Receive) -> None:
        self.receive = receive
        self.got = 0

    async def __call__(self) -> Message:
        message = await self.receive()
        self.got += len(message.get("body", b"") or b"")
        if message["type"] == "http.request" and self.got > LARGEST_BODY:
            raise TooLarge
        return message


def _with_headers(send: Send) -> Send:
    async def sending(message: Message) -> None:
        if message["type"] == "http.response.start":
            headers = MutableHeaders(scope=message)
            for name, value in HEADERS.items():
                if name != POLICY_HEADER or name not in headers:  # a report has one of its own, as strict
                    headers[name] = value
            if "frame-ancestors 'self'" in headers[POLICY_HEADER]:
                headers["x-frame-options"] = "SAMEORIGIN"
            headers.setdefault("cache-control", "no-store")
        await send(message)

    return sending
