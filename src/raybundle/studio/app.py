"""The routes of the studio's server.  Nothing that a file or a point is called is interpreted anywhere."""

from __future__ import annotations

import asyncio
import contextlib
import json
from collections.abc import AsyncGenerator, Awaitable, Callable, Mapping
from contextlib import asynccontextmanager
from dataclasses import dataclass, field
from importlib.resources import files
from pathlib import Path
from typing import Any

from starlette.applications import Starlette
from starlette.concurrency import run_in_threadpool
from starlette.exceptions import HTTPException
from starlette.middleware import Middleware
from starlette.requests import Request
from starlette.responses import Response
from starlette.routing import Route, WebSocketRoute
from starlette.websockets import WebSocket, WebSocketDisconnect

from raybundle.commands.marks import control_in_block
from raybundle.errors import InputError, RaybundleError, code_of, phrase
from raybundle.io.reading.trees import json_of
from raybundle.measuring.actions.control import control_of_text
from raybundle.report.languages.language import language_of
from raybundle.studio import answers, masking, tables
from raybundle.studio.calibrated import Calibrations
from raybundle.studio.deciding import PAGE_POLICY, Deciding
from raybundle.studio.desk import Desk
from raybundle.studio.detecting import Detecting
from raybundle.studio.epochs import Epochs
from raybundle.studio.forms import table_of
from raybundle.studio.guard import LARGEST_BODY, POLICY_HEADER, Guard, Session, TooLarge
from raybundle.studio.pairs import pairs
from raybundle.studio.pictures import Pictures
from raybundle.studio.products import Products
from raybundle.studio.queries import answer
from raybundle.studio.running import Running
from raybundle.studio.scene import scene
from raybundle.studio.snapping import fiducials_found, snapped
from raybundle.studio.tables import Wanted
from raybundle.studio.targeting import Targeting
from raybundle.studio.verbs import command_of
from raybundle.studio.watchers import Live, cause_of, json_text
from raybundle.studio.work import Work
from raybundle.words.catalogue import ENGLISH, entries

PAGE = {
    "": ("index.html", "text/html; charset=utf-8"),
    "studio.js": ("studio.js", "text/javascript; charset=utf-8"),
    "studio.css": ("studio.css", "text/css; charset=utf-8"),
    "decide.css": ("decide.css", "text/css; charset=utf-8"),
    "icon.svg": ("icon.svg", "image/svg+xml"),
}
Answer = Callable[[Request], Awaitable[Response]]
LARGE = 1 << 18
"""Bytes of a request that takes more than a moment."""
LONGEST_NUMBER = 9
"""Digits of an image, level, column or row, and less."""


@dataclass(slots=True)
class Studio:
    """The server's parts."""

    desk: Desk
    session: Session
    live: Live
    work: Work
    running: Running
    detecting: Detecting
    large: asyncio.Semaphore = field(default_factory=lambda: asyncio.Semaphore(1))
    """Held by the one large request, as a table of control, that is worked on"""

    @classmethod
    def of(cls, desk: Desk, session: Session) -> Studio:
        """A studio for a desk."""
        live = Live(reader=session.reader)
        work = Work(desk, live)
        return cls(desk, session, live, work, Running(desk, work, live), Detecting(desk, live))

    def app(self) -> Starlette:
        """The application."""
        deciding = Deciding(self.desk, self.work, self.live)
        targeting = Targeting(self.desk, self.detecting)
        products = Products(self.desk, self.running, Pictures())
        epochs = Epochs(self.desk)
        calibrations = Calibrations(self.desk, self.work.shelf, language_of(self.session.reader.language))
        gets: dict[str, Callable[[Mapping[str, Any]], Any]] = {
            "/api/overview": lambda _: answers.overview(self.desk),
            "/api/observations": lambda q: answers.observations(self.desk, _text(q, "image")),
            "/api/worst": lambda _: answers.worst_of(self.desk),
            "/api/points": lambda q: tables.points(self.desk, _wanted(q)),
            "/api/table/observations": lambda q: tables.observations(self.desk, _wanted(q)),
            "/api/table/pairs": lambda q: pairs(self.desk, _wanted(q)),
            "/api/journal": lambda _: self._journal(),
            "/api/masks": lambda q: masking.drawn(self.desk, _text(q, "image")),
            "/api/standing": lambda _: answers.standing_of(self.desk),
            "/api/run": lambda _: self.running.reported(),
            "/api/calibration": lambda _: calibrations.reported(),
            **targeting.gets,
            **epochs.gets,
            **deciding.gets,
            **products.gets,
        }
        posts: dict[str, Callable[[dict[str, Any]], Any]] = {
            "/api/action": self._action,
            "/api/control": self._control,
            "/api/fiducials": self._fiducials,
            "/api/snap": lambda given: snapped(self.desk, given),
            "/api/adjust": lambda _: {"begun": self.running.adjust()},
            "/api/stop": lambda _: self._stop(),
            "/api/run": lambda _: self.running.begin(),
            "/api/run/settings": lambda given: self.running.choose(table_of(given, "values")),
            **targeting.posts,
            **deciding.posts,
            **products.posts,
        }
        routes = [
            *(Route(path, self._get(make), methods=["GET"]) for path, make in gets.items()),
            *(Route(path, self._post(make), methods=["POST"]) for path, make in posts.items()),
            Route("/api/predict", self._predict, methods=["GET"]),
            Route("/api/query", self._query, methods=["GET"]),
            Route("/api/scene", self._scene, methods=["GET"]),
            *deciding.pages,
            *targeting.pages,
            *products.pages,
            *epochs.pages,
            Route("/figure/calibration/{number}.svg", _figure(calibrations), methods=["GET"]),
            Route("/api/mask", self._mask, methods=["GET"]),
            Route("/api/tile/{image}/{level}/{column}/{row}", self._tile, methods=["GET"]),
            WebSocketRoute("/api/live", self._live),
            Route("/{name:path}", self._page, methods=["GET"]),
        ]
        return Starlette(
            routes=routes, middleware=[Middleware(Guard, session=self.session)], lifespan=self._lifespan,
            exception_handlers=dict.fromkeys((HTTPException, RaybundleError, TooLarge), self._refused),
        )  # fmt: skip

    @asynccontextmanager
    async def _lifespan(self, _: Starlette) -> AsyncGenerator[None]:
        self.live.loop = asyncio.get_running_loop()
        if self.desk.to_begin:
            self.work.soon()
        elif self.desk.adjustment is None:
            self.work.begin(measured=False)
        try:
            yield
        finally:
            self.detecting.stop()
            await run_in_threadpool(self.running.close)
            await run_in_threadpool(self.work.close)
            self.desk.close()

    async def _page(self, request: Request) -> Response:
        found = PAGE.get(request.path_params["name"])
        if found is None:
            raise HTTPException(404, phrase("studio_page.no_page"))
        name, kind = found
        body = (files("raybundle.studio") / "static" / name).read_bytes()
        if name == PAGE[""][0]:
            language = self.session.reader.language
            body = body.replace(b"{language}", language.encode()).replace(b"{words}", words_of_page(language).encode())
        return Response(body, headers={"content-type": kind})

    async def _tile(self, request: Request) -> Response:
        p = [request.path_params[n] for n in ("image", "level", "column", "row")]
        if not all(v.isascii() and v.isdigit() and len(v) < LONGEST_NUMBER for v in p):
            raise HTTPException(404, phrase("studio_page.bad_request", name="tile", kind="number"))
        try:
            body = await run_in_threadpool(self.desk.tiles.tile, *(int(v) for v in p))
        except (InputError, OSError) as error:
            raise HTTPException(404, cause_of(error)) from None
        return Response(body, media_type="image/jpeg", headers={"cache-control": "private, max-age=3600"})

    async def _mask(self, request: Request) -> Response:
        body = await run_in_threadpool(masking.picture, self.desk, _text(request.query_params, "image"))
        return Response(body, media_type="image/png") if body else Response(status_code=204)

    async def _scene(self, _: Request) -> Response:
        return Response(await run_in_threadpool(scene, self.desk), media_type="application/octet-stream")

    async def _predict(self, request: Request) -> Response:
        q = request.query_params
        found = await run_in_threadpool(answers.predictions, self.desk, _text(q, "point"), [*q.getlist("images")])
        return self._json(found)

    async def _query(self, request: Request) -> Response:
        q = request.query_params
        return self._json(await run_in_threadpool(answer, self.desk, _text(q, "kind"), tuple(q.getlist("points"))))

    def _stop(self) -> dict[str, Any]:
        """Stop whatever is at work."""
        stopping = [part.stop() for part in (self.running, self.detecting, self.work)]
        return {"stopping": any(stopping)}

    def _journal(self) -> dict[str, Any]:
        return {"actions": [
            {"seq": e.seq, "time": e.time, "author": e.author, "verb": e.verb, "arguments": dict(e.arguments),
             "command": command_of(self.desk.source, e.verb, e.arguments)}
            for e in self.desk.journal.entries()
        ]}  # fmt: skip

    def _action(self, given: dict[str, Any]) -> dict[str, Any]:
        verb, arguments = _text(given, "verb"), given.get("arguments", {})
        if not isinstance(arguments, dict):
            raise HTTPException(400, phrase("studio_page.bad_request", name="arguments", kind="table"))
        author = str(given.get("author", ""))[:100]
        return self._done(self.desk.journal.append_verb(verb, arguments, id=_text(given, "id"), author=author))

    def _done(self, seq: int) -> dict[str, Any]:
        """What is answered of an action that was done, when all tabs have been reported."""
        state = answers.state_of(self.desk)
        self.live.notify_from_thread({"type": "state", "state": state})
        self.work.soon()
        e = next(iter(self.desk.journal.entries(seq - 1)))
        return {
            "seq": seq, "state": state, "command": command_of(self.desk.source, e.verb, e.arguments),
            "test": answers.tested(self.desk, e.verb, e.arguments),
        }  # fmt: skip

    def _control(self, given: dict[str, Any]) -> dict[str, Any]:
        """Control coordinates of a table: one action, which holds the rows."""
        name = _text(given, "id")
        if not name:
            raise HTTPException(400, phrase("studio_page.bad_request", name="id", kind="id"))
        action, remarks = control_of_text(_text(given, "text"), _text(given, "file") or "control.csv")
        action = control_in_block(self.desk.source, action, self.desk.given)
        done = self._done(self.desk.journal.append(action, id=name, author=str(given.get("author", ""))[:100]))
        return {"added": [p.point for p in action.points], "remarks": list(remarks), **done}

    def _fiducials(self, given: dict[str, Any]) -> dict[str, Any]:
        """The other fiducial marks of a scan: one action each of those that are found."""
        first = _text(given, "id")
        if not first:
            raise HTTPException(400, phrase("studio_page.bad_request", name="id", kind="id"))
        found = fiducials_found(self.desk, _text(given, "image"))
        for k, action in enumerate(found.actions):
            self.desk.journal.append(action, id=f"{first}-{k}", author=str(given.get("author", ""))[:100])
        state = answers.state_of(self.desk)
        self.live.notify_from_thread({"type": "state", "state": state})
        self.work.soon()
        return {"found": [a.name for a in found.actions], "left": dict(found.left), "state": state}

    def _post(self, make: Callable[[dict[str, Any]], Any]) -> Answer:
        async def answer(request: Request) -> Response:
            body = await request.body()
            if len(body) < LARGE:
                return self._json(await run_in_threadpool(_answered, body, make))
            async with self.large:  # others are answered meanwhile
                return self._json(await run_in_threadpool(_answered, body, make))

        return answer

    def _get(self, make: Callable[[Mapping[str, Any]], Any]) -> Answer:
        async def answer(request: Request) -> Response:
            return await run_in_threadpool(lambda: self._json(make(request.query_params)))

        return answer

    def _json(self, content: Any, status: int = 200) -> Response:
        return Response(json_text(content, self.session.reader), status, media_type="application/json")

    async def _refused(self, _: Request, error: Exception) -> Response:
        status, reason = 409, ""
        match error:
            case HTTPException():
                status, reason = error.status_code, error.detail
            case TooLarge():
                status, reason = 413, phrase("studio_page.too_large", most=LARGEST_BODY)
            case _:
                reason = cause_of(error)
        return self._json({"error": reason, "code": code_of(reason)}, status)

    async def _live(self, socket: WebSocket) -> None:
        await socket.accept()
        queue = self.live.join()
        listening = asyncio.create_task(_listen(socket))
        try:
            await socket.send_json({"type": "state", "state": await run_in_threadpool(answers.state_of, self.desk)})
            while not listening.done():
                waiting = asyncio.create_task(queue.get())
                await asyncio.wait({waiting, listening}, return_when=asyncio.FIRST_COMPLETED)
                if not waiting.done():
                    waiting.cancel()
                    break
                message = waiting.result()
                if message is None:
                    break
                await socket.send_text(message)
        except (WebSocketDisconnect, RuntimeError):
            pass
        finally:
            self.live.leave(queue)
            listening.cancel()
            with contextlib.suppress(RuntimeError, WebSocketDisconnect):  # a tab that went away closes nothing
                await socket.close()


async def _listen(socket: WebSocket) -> None:
    """What a tab states is thrown away; it ends with the tab."""
    with contextlib.suppress(WebSocketDisconnect, RuntimeError, KeyError, ValueError):
        while True:
            await socket.receive_text()


def words_of_page(language: str) -> str:
    """The entries that the page shows, in Fluent, as JSON that cannot end the script element in which it stands."""
    found = {**entries(ENGLISH), **entries(language)}
    text = "".join(e.text for name, e in found.items() if name.startswith(("studio_", "label-")))
    return json.dumps(text, ensure_ascii=False).replace("<", "\\u003c")


def _answered(body: bytes, make: Callable[[dict[str, Any]], Any]) -> Any:
    """The answer to a request's body, outside of the loop that serves all tabs."""
    try:
        given = json_of((body or b"{}").decode(), Path("request"))
    except (UnicodeDecodeError, InputError):
        raise HTTPException(400, phrase("studio_page.bad_request", name="body", kind="json")) from None
    if not isinstance(given, dict):
        raise HTTPException(400, phrase("studio_page.bad_request", name="body", kind="table"))
    try:
        json.dumps(given, ensure_ascii=False).encode()
    except (UnicodeEncodeError, ValueError):
        raise HTTPException(400, phrase("studio_page.bad_characters")) from None
    return make(given)


def _figure(calibrations: Calibrations) -> Answer:
    async def answer(request: Request) -> Response:
        number = request.path_params["number"]
        if not (number.isascii() and number.isdigit() and len(number) < LONGEST_NUMBER):
            raise HTTPException(404, phrase("studio_page.bad_request", name="figure", kind="number"))
        body = await run_in_threadpool(calibrations.figure, int(number))
        return Response(body, media_type="image/svg+xml", headers={POLICY_HEADER: PAGE_POLICY})

    return answer


def _text(given: Mapping[str, Any], name: str) -> str:
    value = given.get(name, "")
    if not isinstance(value, str):
        raise HTTPException(400, phrase("studio_page.bad_request", name=name, kind="text"))
    return value


def _wanted(q: Mapping[str, Any]) -> Wanted:
    try:
        offset, limit = int(q.get("offset", 0)), int(q.get("limit", 100))
    except ValueError:
        raise HTTPException(400, phrase("studio_page.bad_request", name="offset, limit", kind="number")) from None
    return Wanted(
        sort=q.get("sort", ""), down=q.get("down", "") == "1", search=q.get("search", ""), role=q.get("role", ""),
        offset=offset, limit=limit,
    )  # fmt: skip
