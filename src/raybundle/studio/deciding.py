"""The routes of the page on which an adjustment is decided: options, parameters, limits, what was adjusted before."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from typing import Any

from starlette.concurrency import run_in_threadpool
from starlette.exceptions import HTTPException
from starlette.requests import Request
from starlette.responses import Response
from starlette.routing import Route

from raybundle.errors import InputError, phrase
from raybundle.measuring.journal import Entry
from raybundle.studio import choosing
from raybundle.studio.answers import state_of
from raybundle.studio.desk import Desk
from raybundle.studio.forms import table_of
from raybundle.studio.guard import POLICY_HEADER
from raybundle.studio.verbs import command_of
from raybundle.studio.watchers import Live, cause_of
from raybundle.studio.work import Work

PAGE_POLICY = (
    "sandbox allow-scripts; default-src 'none'; script-src 'unsafe-inline'; style-src 'unsafe-inline'; "
    "img-src data: blob:; font-src data:; base-uri 'none'; form-action 'none'; frame-ancestors 'self'"
)
"""Of a report, which holds its script and style: a page of no origin that reaches nothing, not even this server."""


@dataclass(frozen=True, slots=True)
class Deciding:
    """What the page asks and does."""

    desk: Desk
    work: Work
    live: Live

    @property
    def gets(self) -> dict[str, Callable[[Mapping[str, Any]], Any]]:
        """Questions, by their paths."""
        return {
            "/api/options": lambda _: choosing.form(self.work.options, self.desk.source),
            "/api/parameters": lambda _: choosing.parameters(self.desk),
            "/api/criteria": lambda _: choosing.criteria(self.desk),
            "/api/selection": lambda q: choosing.selection(self.desk, str(q.get("by", "")), _limit(q.get("limit"))),
            "/api/adjustments": lambda _: {"adjustments": self.work.shelf.reported()},
        }

    @property
    def posts(self) -> dict[str, Callable[[dict[str, Any]], Any]]:
        """Deeds, by their paths."""
        return {"/api/options": self._options, "/api/reject": self._reject}

    @property
    def pages(self) -> list[Route]:
        """Reports and comparisons, each a document of its own."""
        return [
            Route("/report/{name}", self._last, methods=["GET"]),
            Route("/adjustment/{number}/{name}", self._page, methods=["GET"]),
            Route("/comparison/{first}/{second}", self._comparison, methods=["GET"]),
        ]

    def _options(self, given: dict[str, Any]) -> dict[str, Any]:
        """The options of the next adjustments, those of the button above included; what is not given is as usual."""
        self.work.options = choosing.options_of_form(table_of(given, "values"))
        return choosing.form(self.work.options, self.desk.source)

    def _reject(self, given: dict[str, Any]) -> dict[str, Any]:
        """Reject what is beyond a limit now: one action, which holds the image observations that were found."""
        name, journal = given.get("id"), self.desk.journal
        if not isinstance(name, str) or not name:
            raise HTTPException(400, phrase("studio_page.bad_request", name="id", kind="id"))
        entry = next((e for e in journal.entries() if e.id == name), None)  # sent again it counts once
        if entry is None:
            quantity, found = choosing.beyond(self.desk, str(given.get("by", "")), _limit(given.get("limit")))
            arguments = {"quantity": quantity, "limit": _limit(given.get("limit")), "rows": found.rows}
            author = str(given.get("author", ""))[:100]
            seq = journal.append_verb("reject_beyond", arguments, id=name, author=author)
            entry = next(iter(journal.entries(seq - 1)))
        elif not _same_request(entry, given):
            raise HTTPException(409, phrase("studio_page.id_used", id=name[:40]))
        state = state_of(self.desk)
        self.live.notify_from_thread({"type": "state", "state": state})
        return {"seq": entry.seq, "state": state, "command": command_of(self.desk.source, entry.verb, entry.arguments)}

    async def _page(self, request: Request) -> Response:
        number, name = (request.path_params[n] for n in ("number", "name"))
        return await _document(lambda: self.work.shelf.page(_number(number), name))

    async def _last(self, request: Request) -> Response:
        """A page of the last adjustment."""
        name, stored = request.path_params["name"], self.work.shelf.adjustments
        if not stored:
            raise HTTPException(404, phrase("studio_page.no_page"))
        return await _document(lambda: self.work.shelf.page(stored[-1].number, name))

    async def _comparison(self, request: Request) -> Response:
        first, second = (_number(request.path_params[n]) for n in ("first", "second"))
        return await _document(lambda: self.work.shelf.compared(first, second, self.live.reader.language).encode())


def _same_request(entry: Entry, given: Mapping[str, Any]) -> bool:
    """Whether an action of the journal is what is asked for, sent before."""
    a, limit = entry.arguments, _limit(given.get("limit"))
    return (entry.verb, a.get("quantity"), a.get("limit")) == ("reject_beyond", given.get("by"), limit)


async def _document(make: Callable[[], bytes]) -> Response:
    try:
        body = await run_in_threadpool(make)
    except InputError as error:
        raise HTTPException(404, cause_of(error)) from None
    return Response(body, headers={"content-type": "text/html; charset=utf-8", POLICY_HEADER: PAGE_POLICY})


def _number(text: str) -> int:
    if not (text.isascii() and text.isdigit() and len(text) < 9):
        raise HTTPException(404, phrase("studio_page.no_page"))
    return int(text)


def _limit(value: Any) -> float:
    try:
        return float(value)
    except (TypeError, ValueError):
        raise HTTPException(400, phrase("studio_page.bad_request", name="limit", kind="number")) from None
