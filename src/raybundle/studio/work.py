"""Adjusting in the background: what was opened, what was measured with it, photographs oriented from their marks."""

from __future__ import annotations

import threading
from collections.abc import Callable
from dataclasses import dataclass, field, replace

from raybundle.adjustment.records.options import AdjustmentOptions
from raybundle.commands.marked_results import write_marked
from raybundle.errors import code_of, phrase
from raybundle.measuring.actions.decisions import with_decisions
from raybundle.measuring.merge import merge
from raybundle.measuring.session import Session
from raybundle.measuring.start import adjusted, begun, standing_after
from raybundle.results.project_results import own_result
from raybundle.studio.answers import finite
from raybundle.studio.desk import Desk
from raybundle.studio.shelf import Origin, Shelf
from raybundle.studio.verbs import command_of_adjusting
from raybundle.studio.watchers import Live, cause_of
from raybundle.workflows.adjust import adjust

REST_S = 0.3
"""Seconds after a mark from which on photographs are oriented from it."""


class Stopped(Exception):
    """The person stopped it."""


@dataclass(slots=True)
class Work:
    """One piece of work at a time."""

    desk: Desk
    live: Live
    options: AdjustmentOptions = field(default_factory=AdjustmentOptions)
    """of the next adjustments, without what the journal states of parameters"""
    shelf: Shelf = field(init=False)
    _thread: threading.Thread | None = None
    _over: bool = True
    _stop: threading.Event = field(default_factory=threading.Event)
    _lock: threading.Lock = field(default_factory=threading.Lock)
    _at_once: threading.Lock = field(default_factory=threading.Lock)
    _timer: threading.Timer | None = None
    _closed: bool = False

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
            self._thread = threading.Thread(target=self._run, args=(target, self.desk.journal.seq), daemon=True)
            self._thread.start()
        return True

    def stop(self) -> bool:
        """Stop at the next step; False where nothing is being adjusted."""
        self._stop.set()
        return self.busy

    def close(self) -> None:
        """Stop, and begin nothing more; until nothing asks the journal."""
        self.stop()
        with self._lock:
            self._closed = True
            if self._timer is not None:
                self._timer.cancel()
        with self._at_once:
            pass

    def soon(self) -> None:
        """Orient the photographs from their marks as soon as the hand rests; nothing where that is not asked for."""
        if not self.desk.to_begin:
            return
        with self._lock:
            if self._closed:
                return
            if self._timer is not None:
                self._timer.cancel()
            self._timer = threading.Timer(REST_S, self._begin_photographs)
            self._timer.daemon = True
            self._timer.start()

    def read_anew(self, origin: Origin, command: str) -> None:
        """Go on with the result that a run wrote; raises InputError where there is none.

        command  that made it
        """
        with self._at_once:  # not while photographs are oriented from their marks
            self.desk.read_anew()
            result = own_result(self.desk.source)
            if result is not None:
                self.shelf.put(result, command, origin)
        if self.desk.to_begin:
            self.soon()
        else:
            self.begin(measured=False)

    def wait(self) -> None:
        """Until nothing is being adjusted."""
        with self._lock:  # whoever begins holds it until what it began can be waited for
            timer = self._timer
        if timer is not None:
            timer.join()
        with self._lock:
            thread = self._thread
        if thread is not None:
            thread.join()

    def _run(self, target: Callable[[], str], seq: int) -> None:
        folder, trouble = "", ""
        try:
            folder = target()
        except Stopped:
            trouble = phrase("studio_page.stopped")
        except Exception as error:  # noqa: BLE001  (a thread of its own: whoever waits must hear of it)
            trouble = cause_of(error)
        a = self.desk.adjustment
        self._over = True
        self.live.notify_from_thread({
            "type": "adjusted", "sigma0": None if a is None else finite(a.sigma0), "folder": folder, "error": trouble,
            "code": code_of(trouble),
        })  # fmt: skip
        with self._at_once:
            if not self._closed and seq != self.desk.journal.seq:
                self.soon()  # with what was marked meanwhile

    def _begin_photographs(self) -> None:
        """Orient and adjust with all marks, unless an adjustment is asked for in between."""
        with self._at_once:
            if self.busy or self._closed:
                return
            seq, state, trouble = self.desk.journal.seq, self.desk.journal.state, ""
            try:
                found = begun(self.desk.given, state, self.desk.scans)
            except Exception as error:  # noqa: BLE001  (a thread of its own: whoever waits must hear of it)
                trouble, found = cause_of(error), None
            if self.busy:
                return  # an adjustment was asked for, which does the same
            if found is None:
                standing = replace(self.desk.standing, trouble=trouble)
                self.desk.replaced(self.desk.session, standing)
            else:
                self.desk.replaced(found.session, found.standing)
        self.live.notify_from_thread({"type": "oriented", "seq": seq})

    def _as_it_is(self) -> str:
        self._notify("covariances", 0.0)
        self.desk.replaced(self.desk.adjusted(self._notify))
        return ""

    def _measured(self) -> str:
        """Block and marks, adjusted and written; the block that was opened is not touched."""
        desk = self.desk
        if desk.written_elsewhere:
            desk.read_anew()
            result = own_result(desk.source)
            if result is not None:
                self.shelf.put(result, "", "elsewhere")
        state, options = desk.journal.state, self.options
        decided = with_decisions(options, state)
        made = merge(desk.given, state, desk.scans)
        done = adjusted(made, lambda block: adjust(block, decided, self._notify))
        folder = write_marked(desk.source, done, language=self.live.reader.language, progress=self._notify)
        self.shelf.put(folder, command_of_adjusting(desk.source, options))
        desk.replaced(Session.of(done), standing_after(made, done))
        return str(folder)

    def _notify(self, stage: str, share: float) -> None:
        if self._stop.is_set():
            raise Stopped
        self.live.notify_from_thread({"type": "progress", "stage": stage, "share": share})
