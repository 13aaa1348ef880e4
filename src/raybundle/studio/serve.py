"""The studio's server: on the loopback alone, on a free port, until it is interrupted."""

from __future__ import annotations

import os
import shutil
import signal
import socket
import sys
import threading
import webbrowser
from collections.abc import Callable, Generator, Sequence
from contextlib import contextmanager
from pathlib import Path
from tempfile import TemporaryDirectory, gettempdir

import uvicorn
from starlette.types import ASGIApp

from raybundle.commands.opening import hand_over
from raybundle.errors import InputError
from raybundle.studio.app import Studio
from raybundle.studio.desk import Desk
from raybundle.studio.guard import Session
from raybundle.studio.sockets import HEADERS_S, Server, Waiting, protocol_of
from raybundle.words import ENGLISH, Reader

FOLDER = "raybundle-studio-"
"""Begin of the names of folders of decoded photographs; the process that owns it follows."""
LARGEST_MESSAGE = 64 * 1024
"""Bytes that a tab may send through its WebSocket at once; it has nothing to say that is longer."""


def listening(port: int) -> socket.socket:
    """A socket on the loopback; raises InputError where the port is taken."""
    # asyncio sends at once (TCP_NODELAY) only where the protocol is named: without it every answer waits 40 ms
    found = socket.socket(socket.AF_INET, socket.SOCK_STREAM, socket.IPPROTO_TCP)
    found.setsockopt(socket.SOL_SOCKET, socket.SO_REUSEADDR, 1)
    try:
        found.bind(("127.0.0.1", port))
        found.listen(128)  # who opens the address at once waits until the server answers
    except OSError as error:
        found.close()
        raise InputError("studio.port_in_use", port=port, detail=error.strerror) from None
    return found


def configured(app: ASGIApp, waiting: Waiting) -> uvicorn.Config:
    """How the server works; `waiting` closes connections that send no whole header in time."""
    return uvicorn.Config(
        app, log_level="warning", access_log=False, ws="websockets-sansio", ws_max_size=LARGEST_MESSAGE,
        ws_per_message_deflate=False, limit_concurrency=512, timeout_graceful_shutdown=2, server_header=False,
        http=protocol_of(waiting),
    )  # fmt: skip


def serve(
    source: Path, photos: Sequence[Path] = (), *, port: int = 0, browser: bool = True,
    notify: Callable[[str], None] = print, header_s: float = HEADERS_S, language: str = ENGLISH,
) -> None:  # fmt: skip
    """Open a project, result or block folder and serve it until interrupted.

    port     0: a free one
    browser  open the page
    notify     gets the address once; it works once
    header_s seconds within which the header of a request is complete
    language of the page and of the reports that it writes
    raises   InputError where there is nothing to open, or the port is taken
    """
    _sweep()
    with TemporaryDirectory(prefix=f"{FOLDER}{os.getpid()}-") as folder:
        desk = Desk.open(source, Path(folder), photos)
        with listening(port) as connection:
            session = Session(port=connection.getsockname()[1], reader=Reader(language, flags=True))
            config = configured(Studio.of(desk, session).app(), Waiting(seconds=header_s))
            page = hand_over(session.address, Path(folder)) if browser else None
            server = Server(config, lambda: page and webbrowser.open(page.as_uri()))
            with _ending(server):
                notify(session.address)
                if desk.journal.read_only:
                    notify(f"warning: {desk.journal.read_only.text()}")
                server.run(sockets=[connection])


@contextmanager
def _ending(server: uvicorn.Server) -> Generator[None]:
    """Let the server end, and its folder be removed, when the terminal is closed or the process is asked to end."""
    if threading.current_thread() is not threading.main_thread():
        yield
        return
    hang_up = getattr(signal, "SIGHUP", None)  # there is none on Windows
    before = {s: signal.getsignal(s) for s in (signal.SIGTERM, signal.SIGINT, hang_up) if s is not None}

    def end(number: int, _: object) -> None:
        sys.exit(128 + number)  # the server ended before, and raises the signal again

    def should_end(_: int, __: object) -> None:
        server.should_exit = True

    signal.signal(signal.SIGTERM, end)
    signal.signal(signal.SIGINT, signal.default_int_handler)  # ignored where it was begun in the background
    if hang_up is not None:
        signal.signal(hang_up, should_end)
    try:
        yield
    finally:
        for number, handler in before.items():
            signal.signal(number, handler)


def _sweep() -> None:
    """Remove what studios left that were killed."""
    for folder in Path(gettempdir()).glob(f"{FOLDER}*-*"):
        owner = folder.name.removeprefix(FOLDER).split("-")[0]
        if owner.isdigit() and not _lives(int(owner)):
            shutil.rmtree(folder, ignore_errors=True)


def _lives(process: int) -> bool:
    if os.name != "posix":  # there a signal 0 would end it
        return True
    try:
        os.kill(process, 0)
    except ProcessLookupError:
        return False
    except OSError:
        return True
    return True
