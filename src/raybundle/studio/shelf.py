"""The last adjustments of a session: result folders beside one another, with figures, compared in pairs."""

from __future__ import annotations

import shutil
import threading
from dataclasses import dataclass, field, replace
from pathlib import Path
from typing import Any, Literal

import numpy as np

from raybundle.errors import InputError
from raybundle.measuring.journal import measured_result
from raybundle.report.comparison.page import comparison
from raybundle.results.folder import ResultFolder, read_result
from raybundle.results.project_results import base_result, linked, own_result, project_of
from raybundle.results.stored_options import as_mapping, options_of
from raybundle.settings import as_typed
from raybundle.studio.answers import finite

MOST = 8
"""Adjustments on the shelf; the oldest but the first, which was there when the studio was opened, makes room."""
WORST = 5
"""Residuals that are reported of each."""
Origin = Literal["opened", "before", "adjusted", "oriented", "calibrated", "elsewhere"]
PAGES = ("report.html", "network.html")


@dataclass(frozen=True, slots=True, kw_only=True)
class Stored:
    """One adjustment."""

    number: int
    """0: the own result of what was opened"""
    folder: Path
    origin: Origin
    command: str = ""
    """that made it; "" of what was there"""


@dataclass(slots=True)
class Shelf:
    """Adjustments that were made, the one that was there when the studio was opened first."""

    folder: Path
    adjustments: list[Stored] = field(default_factory=list[Stored])
    _made: int = 0
    _lock: threading.Lock = field(default_factory=threading.Lock)
    _shown: dict[int, dict[str, Any]] = field(default_factory=dict[int, dict[str, Any]])

    @classmethod
    def of(cls, source: Path, folder: Path) -> Shelf:
        """A shelf with the own result of a project or result folder and that of what was measured in it before.

        folder  for the copies, which goes with the server
        """
        found = cls(folder)
        own, before = own_result(source), measured_result(source)
        project = project_of(source)
        first = own if project is None else base_result(project)
        if first is not None:
            found._put(Stored(number=0, folder=first, origin="opened"))
        if (before / "result.json").is_file() and before != first:
            found._made = 1
            found._put(Stored(number=1, folder=before, origin="before"))
        return found

    def put(self, result: Path, command: str, origin: Origin = "adjusted") -> int:
        """Keep a copy of a result folder; its number."""
        with self._lock:
            self._made += 1
            self._put(Stored(number=self._made, folder=result, origin=origin, command=command))
            while len(self.adjustments) > MOST:
                oldest = self.adjustments.pop(1)
                self._shown.pop(oldest.number, None)
                shutil.rmtree(oldest.folder, ignore_errors=True)
            return self._made

    def _put(self, made: Stored) -> None:
        copy = self.folder / f"adjustment-{made.number}"
        shutil.copytree(made.folder, copy, copy_function=linked, ignore=shutil.ignore_patterns("project"))
        self.adjustments.append(replace(made, folder=copy))

    def one(self, number: int) -> Stored:
        """An adjustment of the shelf; raises InputError."""
        for each in [*self.adjustments]:
            if each.number == number:
                return each
        raise InputError(
            "studio.adjustment_not_stored",
            number=number,
            stored=[k.number for k in self.adjustments],
            n=len(self.adjustments),
        )

    def page(self, number: int, name: str) -> bytes:
        """A page of an adjustment: its report, or its network in three dimensions; raises InputError."""
        file = self.one(number).folder / name
        if name not in PAGES or not file.is_file():
            raise InputError("studio.adjustment_without_page", number=number, name=name)
        return file.read_bytes()

    def compared(self, first: int, second: int, language: str) -> str:
        """The page that puts two of them side by side, as `raybundle compare` writes it; raises InputError."""
        a, b = (read_result(self.one(n).folder) for n in (first, second))
        return comparison(a, b, language)

    def reported(self) -> list[dict[str, Any]]:
        """Each in figures, the first first."""
        found: list[dict[str, Any]] = []
        for each in [*self.adjustments]:
            if each.number not in self._shown:
                self._shown[each.number] = _figures(each)
            found.append(self._shown[each.number])
        return found


def _figures(stored: Stored) -> dict[str, Any]:
    """What is reported of an adjustment beside the others."""
    read = read_result(stored.folder)
    r = read.result
    numbers = ("sigma0", "redundancy", "observations", "unknowns", "image_points", "rejected", "mean_std")
    return {
        "number": stored.number, "origin": stored.origin, "command": stored.command,
        "worst": _worst(read), "check": _check(read),
        **{name: _number(r.get(name)) for name in numbers}, "noise": str(as_mapping(r.get("noise")).get("kind", "")),
        "options": as_typed(options_of(r)), "unit": "" if read.block.free_scale else read.block.length_unit,
        "report": (stored.folder / "report.html").is_file(), "network": (stored.folder / "network.html").is_file(),
        "parameters": [
            {"camera": camera, "symbol": symbol, "value": _number(p.get("value")), "sigma": _number(p.get("std")),
             "status": str(p.get("status", "")), "unit": "" if p.get("unit") == "1" else str(p.get("unit", ""))}
            for camera, table in as_mapping(r.get("cameras")).items() for symbol, p in as_mapping(table).items()
        ],
    }  # fmt: skip


def _number(value: Any) -> float | None:
    return finite(float(value)) if isinstance(value, int | float) and not isinstance(value, bool) else None


def _worst(read: ResultFolder) -> list[dict[str, Any]]:
    """The largest test values of what takes part."""
    o = read.observations
    w = np.stack([np.abs(o.number["wx"]), np.abs(o.number["wy"])], axis=1).reshape(-1, 2)
    size = np.nan_to_num(w, nan=-1.0).max(axis=1, initial=-1.0)
    size[[bool(reason) for reason in o.text["rejected"]]] = -1.0
    rows = [k for k in np.argsort(-size, kind="stable")[:WORST].tolist() if size[k] >= 0]
    v = np.hypot(o.number["vx_px"], o.number["vy_px"])
    return [
        {"image": o.text["image"][k], "point": o.text["point"][k], "w": float(size[k]), "v_px": finite(float(v[k]))}
        for k in rows
    ]


def _check(read: ResultFolder) -> dict[str, Any]:
    """Root mean square of the differences at check points, in each axis; None where there are none."""
    rms: list[float | None] = []
    for axis in "XYZ":
        d = read.check.number[f"d{axis}"]
        d = d[np.isfinite(d)]
        rms.append(float(np.sqrt((d**2).mean())) if len(d) else None)
    return {"points": len(read.check.text["point"]), "rms": rms}
