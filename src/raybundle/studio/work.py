"""Adjusting in the background: covariances of what was opened, and what was measured together with it."""

from __future__ import annotations

import threading
from collections.abc import Callable
from dataclasses import dataclass, field
from functools import partial

from raybundle.adjustment.options import AdjustmentOptions
from raybundle.errors import RaybundleError
from raybundle.measuring.decisions import with_decisions
from raybundle.measuring.journal import measured_result
from raybundle.measuring.merge import merge
from raybundle.measuring.session import Session, readjusted
from raybundle.report.write import write_result
from raybundle.studio.answers import finite
from raybundle.studio.desk import Desk
from raybundle.studio.live import Live
from raybundle.studio.shelf import Shelf
from raybundle.studio.verbs import command_of_adjusting
from raybundle.workflows.adjust import adjust


class Stopped(Exception):
    """The person said stop."""


@dataclass(slots=True)
class Work:
    """One piece of work at a time."""

    desk: Desk
    live: Live
    options: AdjustmentOptions = field(default_factory=AdjustmentOptions)
    """of the next adjustments, without what the journal says of parameters"""
    shelf: Shelf = field(init=False)
    _thread: threading.Thread | None = None
    _over: bool = True
    _stop: threading.Event = field(default_factory=threading.Event)
    _lock: threading.Lock = field(default_factory=threading.Lock)

    def __post_init__(self) -> None:
        """Keep the result that is there."""
        self.shelf = Shelf.of(self.desk.source, self.desk.tiles.folder)

    @property
    def busy(self) -> bool:
        """Whether something is being adjusted."""
        return not self._over

    def begin(self, *, measured: bool) -> bool:
        """Adjust the block as it is, or with what was measured; False where something is being adjusted already."""
        with self._lock:
            if self.busy:
                return False
            self._stop.clear()
            self._over = False
            target = self._measured if measured else self._as_it_is
            self._thread = threading.Thread(target=self._run, args=(target,), daemon=True)
            self._thread.start()
        return True

    def stop(self) -> bool:
        """Stop at the next step; False where nothing is being adjusted."""
        self._stop.set()
        return self.busy

    def wait(self) -> None:
        """Until nothing is being adjusted."""
        if self._thread is not None:
            self._thread.join()

    def _run(self, target: Callable[[], str]) -> None:
        folder, trouble = "", ""
        try:
            folder = target()
        except Stopped:
            trouble = "stopped; nothing was changed"
        except RaybundleError as error:
            trouble = str(error)
        except Exception as error:  # noqa: BLE001  (a thread of its own: whoever waits must hear of it)
            trouble = f"a fault of the program: {type(error).__name__}: {error}"
        a = self.desk.adjustment
        self._over = True
        self.live.tell_from_thread({
            "type": "adjusted", "sigma0": None if a is None else finite(a.sigma0), "folder": folder, "error": trouble,
        })  # fmt: skip

    def _as_it_is(self) -> str:
        self._tell("covariances", 0.0)
        as_before = partial(readjusted, progress=self._tell, options=self.shelf.parameters_before())
        self.desk.replaced(self.desk.adjusted(as_before))
        return ""

    def _measured(self) -> str:
        """Block and marks, adjusted and written; the block that was opened is not touched."""
        desk = self.desk
        state, options = desk.journal.state, self.options
        made = merge(desk.given, state)
        done = adjust(made.block, with_decisions(options, state), progress=self._tell)
        folder = measured_result(desk.source)
        write_result(done, folder, progress=self._tell)
        self.shelf.put(folder, command_of_adjusting(desk.source, options))
        desk.replaced(Session.of(done))
        return str(folder)

    def _tell(self, stage: str, share: float) -> None:
        if self._stop.is_set():
            raise Stopped
        self.live.tell_from_thread({"type": "progress", "stage": stage, "share": share})
