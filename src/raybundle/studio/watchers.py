"""Who watches, and what they are reported: every tab hears of every change."""

from __future__ import annotations

import asyncio
import json
from dataclasses import dataclass, field
from typing import Any

from raybundle.errors import RaybundleError, Text, as_detail, phrase
from raybundle.words import COMMAND_LINE, Reader

PLAIN = frozenset({str, int, float, bool, type(None)})
QUEUE = 200
"""Messages that wait for a tab that does not read; one that is slower begins anew."""


@dataclass(slots=True)
class Live:
    """Queues of the open tabs."""

    tabs: set[asyncio.Queue[str | None]] = field(default_factory=set[asyncio.Queue[str | None]])
    loop: asyncio.AbstractEventLoop | None = None
    reader: Reader = COMMAND_LINE
    """of all tabs"""

    def join(self) -> asyncio.Queue[str | None]:
        """A queue for one more tab."""
        queue: asyncio.Queue[str | None] = asyncio.Queue(QUEUE)
        self.tabs.add(queue)
        self.loop = asyncio.get_running_loop()
        return queue

    def leave(self, queue: asyncio.Queue[str | None]) -> None:
        """A tab was closed."""
        self.tabs.discard(queue)

    def notify(self, message: dict[str, Any]) -> None:
        """Send it to every tab, from the server's own thread; what is reported is written down once for all of them."""
        self._put(json_text(message, self.reader))

    def _put(self, text: str) -> None:
        for queue in [*self.tabs]:
            try:
                queue.put_nowait(text)
            except asyncio.QueueFull:
                self.tabs.discard(queue)
                while not queue.empty():
                    queue.get_nowait()
                queue.put_nowait(None)  # the tab is closed, it connects again and reads everything

    def notify_from_thread(self, message: dict[str, Any]) -> None:
        """Send it to every tab, from any thread."""
        if self.loop is not None and not self.loop.is_closed():
            self.loop.call_soon_threadsafe(self._put, json_text(message, self.reader))


def json_text(content: Any, reader: Reader) -> str:
    """JSON of plain data, texts of the catalogues as the reader has them."""
    return json.dumps(_read(content, reader), ensure_ascii=False, allow_nan=False, separators=(",", ":"))


def _read(content: Any, reader: Reader) -> Any:
    match content:
        case Text():
            return content.by(reader)
        case dict():
            return {k: v if type(v) in PLAIN else _read(v, reader) for k, v in content.items()}  # pyright: ignore[reportUnknownVariableType, reportUnknownArgumentType]
        case list() | tuple():
            return [v if type(v) in PLAIN else _read(v, reader) for v in content]  # pyright: ignore[reportUnknownVariableType, reportUnknownArgumentType]
        case _:
            return content


def cause_of(error: Exception) -> Text:
    """Why something failed in the background, where whoever waits must hear of every error."""
    if isinstance(error, RaybundleError):
        return Text.of(as_detail(error))
    return phrase("studio_page.fault", kind=type(error).__name__, detail=str(error))
