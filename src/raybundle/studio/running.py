"""A run of stages in the background: begun, reported as it goes, stopped; at its end the desk is read anew."""

from __future__ import annotations

import threading
import time
from calendar import timegm
from dataclasses import dataclass, field
from typing import Any

from raybundle.errors import InputError, RaybundleError, phrase
from raybundle.pipeline.project import StageRecord
from raybundle.studio.child import Child
from raybundle.studio.desk import Desk
from raybundle.studio.runnable import Runnable, Runs, runnable
from raybundle.studio.shelf import Origin
from raybundle.studio.watchers import Live, cause_of
from raybundle.studio.work import Work

EVERY_S = 0.25
"""Seconds between two messages of progress."""
BEAT_S = 1.0
"""Seconds after which stages are reported anew where there is no progress."""


@dataclass(slots=True)
class Run:
    """One run, as it stands."""

    what: Runs
    child: Child
    began: float
    """seconds since 1970"""
    ended: float | None = None
    step: str = ""
    """what is done at the moment, in words"""
    share: float = 0.0
    step_began: float = 0.0
    outcome: str = "running"
    """running, done, stopped, failed"""
    words: str = ""
    """what the command printed, or why it failed; empty where it was stopped"""

    def reported(self) -> dict[str, Any]:
        """As the page shows it."""
        now = time.time() if self.ended is None else self.ended
        spent = now - self.step_began
        left = spent * (1 - self.share) / self.share if 0 < self.share < 1 and self.outcome == "running" else None
        return {
            "name": self.what.name, "command": self.what.command, "outcome": self.outcome, "words": self.words,
            "seconds": now - self.began, "step": self.step, "share": self.share, "left_s": left,
            "stopping": bool(self.child.stop_requests) and self.outcome == "running", "stages": self._stages(),
        }  # fmt: skip

    def _stages(self) -> list[dict[str, Any]]:
        titles = self.what.titles
        # the record shows whole seconds; what an earlier run did is another's
        mine = {r.name: r for r in self.what.records() if _seconds(r) >= int(self.began)}
        last = max((k for k, t in enumerate(titles) if t in mine), default=-1)
        at = last + 1 if self.outcome == "running" else -1
        return [_stage(t, mine.get(t), behind=k < last, at=k == at) for k, t in enumerate(titles)]


def _stage(title: str, record: StageRecord | None, *, behind: bool, at: bool) -> dict[str, Any]:
    state = "at work" if at else "not needed" if behind else "waiting"
    if record is not None:
        state = "kept" if record.from_cache else "done"
    return {
        "title": title, "state": state, "seconds": None if record is None else record.seconds,
        "summary": "" if record is None else record.summary,
    }  # fmt: skip


def _seconds(record: StageRecord) -> float:
    """When a stage ended [s since 1970]; 0 where the record does not show."""
    try:
        return timegm(time.strptime(record.finished, "%Y-%m-%dT%H:%M:%SZ"))
    except ValueError:
        return 0.0


@dataclass(slots=True)
class Running:
    """One run at a time, beside which nothing is adjusted."""

    desk: Desk
    work: Work
    live: Live
    chosen: Runnable | None = None
    """with the settings of the page"""
    run: Run | None = None
    _thread: threading.Thread | None = None
    _sent: float = 0.0
    _lock: threading.Lock = field(default_factory=threading.Lock)

    @property
    def busy(self) -> bool:
        """Whether something runs."""
        return self._thread is not None and self._thread.is_alive()

    def what(self) -> Runnable:
        """What would be run; raises InputError where nothing can be."""
        if self.chosen is None:
            self.chosen = runnable(self.desk)
        return self.chosen

    def reported(self) -> dict[str, Any]:
        """The form, or why nothing can be run, and the run that goes on or was the last."""
        run = None if self.run is None or not self.run.what.titles else self.run.reported()
        try:
            return {"form": self.what().form(), "why": "", "run": run}
        except InputError as error:
            return {"form": None, "why": cause_of(error), "run": run}

    def choose(self, values: dict[str, Any]) -> dict[str, Any]:
        """The settings of the next run; raises InputError that names the one that cannot be."""
        self.chosen = self.what().chosen(values)
        return self.reported()

    def begin(self, other: Runs | None = None) -> dict[str, Any]:
        """Begin the run, or another; raises InputError where something runs or is adjusted."""
        what = other or self.what()
        with self._lock:
            if self.busy or self.work.busy:
                raise InputError("studio.busy")
            what.check()
            now = time.time()
            self.run = Run(what, Child.begin(what.child_words), now, step="beginning", step_began=now)
            self._thread = threading.Thread(target=self._follow, args=(self.run,), daemon=True)
            self._thread.start()
        return self.reported()

    def adjust(self) -> bool:
        """Adjust with what was measured; False where something runs or is adjusted."""
        with self._lock:
            return not self.busy and self.work.begin(measured=True)

    def stop(self) -> bool:
        """Stop between two tasks; asked again, at once.  False where nothing runs."""
        if self.run is None or not self.busy:
            return False
        self.run.child.stop()
        self._notify(self.run)
        return True

    def close(self) -> None:
        """End with the studio."""
        if self.run is not None and self.busy:
            self.run.child.close()
            self.wait()

    def wait(self) -> None:
        """Until nothing runs."""
        with self._lock:  # whoever begins holds it until what it began can be waited for
            thread = self._thread
        if thread is not None:
            thread.join()

    def _follow(self, run: Run) -> None:
        def progress(step: str, share: float) -> None:
            if step != run.step:
                run.step, run.step_began = step, time.time()
            run.share = share
            if time.time() - self._sent > EVERY_S:
                self._notify(run)

        over = threading.Event()
        beat = threading.Thread(target=self._beat, args=(run, over), daemon=True)
        beat.start()
        status, printed = run.child.follow(progress)
        over.set()
        beat.join()
        run.ended = time.time()
        stated = "\n".join(run.child.reported)
        if run.child.stop_requests and status:
            run.outcome = "stopped"
        elif status == 0:
            run.outcome, run.words = "done", printed.strip("\n")
            if run.what.origin is not None:
                self._read_anew(run, run.what.origin)
        else:
            run.outcome, run.words = "failed", stated or phrase("studio_run.status", status=status)
        self._notify(run)

    def _beat(self, run: Run, over: threading.Event) -> None:
        """Report the stages where the command itself states nothing for a while."""
        while not over.wait(BEAT_S):
            if time.time() - self._sent > BEAT_S:
                self._notify(run)

    def _read_anew(self, run: Run, origin: Origin) -> None:
        """Go on with the new result."""
        try:
            self.work.read_anew(origin, run.what.command)
        except RaybundleError as error:
            run.outcome, run.words = "failed", phrase("studio_run.unreadable", detail=error.text(self.live.reader))

    def _notify(self, run: Run) -> None:
        self._sent = time.time()
        self.live.notify_from_thread({"type": "run", "run": run.reported()})
