"""Connections of the studio's server: whoever sends no whole request is closed, and only so many may wait."""

from __future__ import annotations

import asyncio
from collections.abc import Callable
from typing import Any

import uvicorn
from uvicorn.protocols.http.auto import AutoHTTPProtocol

HEADERS_S = 10.0
"""Seconds within which the header of a request is complete."""
MOST_WAITING = 128
"""Connections without a whole header; of more the oldest is closed."""


class Waiting:
    """Connections whose next header is not complete."""

    def __init__(self, seconds: float = HEADERS_S, most: int = MOST_WAITING) -> None:
        self.seconds, self.most = seconds, most
        self._ends: dict[Any, asyncio.TimerHandle] = {}

    @property
    def count(self) -> int:
        """How many there are now."""
        return len(self._ends)

    def begins(self, connection: Any) -> None:
        """A header is waited for; where it is already, the time goes on."""
        if connection in self._ends:
            return
        if len(self._ends) >= self.most:
            self._close(next(iter(self._ends)))
        loop = asyncio.get_running_loop()
        self._ends[connection] = loop.call_later(self.seconds, self._close, connection)

    def ends(self, connection: Any) -> None:
        """The header is there, or the connection is gone."""
        handle = self._ends.pop(connection, None)
        if handle is not None:
            handle.cancel()

    def _close(self, connection: Any) -> None:
        self.ends(connection)
        connection.transport.abort()


def protocol_of(waiting: Waiting) -> type[asyncio.Protocol]:
    """The protocol of uvicorn, whose connections are counted."""
    base: Any = AutoHTTPProtocol

    class Counted(base):
        """A connection of HTTP."""

        def connection_made(self, transport: asyncio.Transport) -> None:
            """Wait for its first header."""
            super().connection_made(transport)
            waiting.begins(self)

        def data_received(self, data: bytes) -> None:
            """Wait no more where a request has begun or the connection is one of a WebSocket."""
            super().data_received(data)
            idle = self.cycle is None or self.cycle.response_complete
            if self.transport.is_closing() or self.transport.get_protocol() is not self or not idle:
                waiting.ends(self)
            else:
                waiting.begins(self)

        def connection_lost(self, exc: Exception | None) -> None:
            """Forget it."""
            waiting.ends(self)
            super().connection_lost(exc)

    return Counted


class Server(uvicorn.Server):
    """A server that reports when it answers."""

    def __init__(self, config: uvicorn.Config, answers: Callable[[], object]) -> None:
        super().__init__(config)
        self.answers = answers

    async def startup(self, sockets: Any = None) -> None:
        """Start, and report it."""
        await super().startup(sockets)
        if self.started and not self.should_exit:
            await asyncio.get_running_loop().run_in_executor(None, self.answers)
