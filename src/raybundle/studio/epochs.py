"""What moved between the dates of a result: displacements of points and areas, rectified photographs of each date."""

from __future__ import annotations

import threading
from collections.abc import Callable, Mapping
from dataclasses import dataclass, field
from typing import Any

import cv2
import numpy as np
from starlette.concurrency import run_in_threadpool
from starlette.exceptions import HTTPException
from starlette.requests import Request
from starlette.responses import Response
from starlette.routing import Route

from raybundle.errors import InputError, phrase
from raybundle.io.formats.base import Displaced
from raybundle.io.reading.trees import read_json
from raybundle.numerics.arrays import Array
from raybundle.numerics.statistics import fisher_tail
from raybundle.results.displacements import DISPLACEMENTS, read_displacements
from raybundle.studio.answers import finite
from raybundle.studio.desk import Desk
from raybundle.studio.shelf import own_result
from raybundle.studio.watchers import cause_of
from raybundle.workflows.epochs.movements import IN_AREA, MOVED, STABLE
from raybundle.workflows.epochs.pictures import DatedPictures
from raybundle.workflows.epochs.tables import EPOCHS

JPEG_QUALITY = 88


@dataclass(slots=True)
class _Read:
    """The displacements of a result, as its files were at a time."""

    stamp: tuple[int, ...]
    displaced: Displaced
    about: Mapping[str, Any]
    """epochs.json"""
    pictures: DatedPictures | None
    why: str
    """there are no pictures"""
    drawn: dict[int, bytes] = field(default_factory=dict[int, bytes])


@dataclass(slots=True)
class Epochs:
    """Read once for each result, when they are looked at."""

    desk: Desk
    _read: _Read | None = None
    _lock: threading.Lock = field(default_factory=threading.Lock)

    @property
    def gets(self) -> dict[str, Callable[[Mapping[str, Any]], Any]]:
        """Questions, by their paths."""
        return {"/api/epochs": lambda _: self.reported()}

    @property
    def pages(self) -> list[Route]:
        """A picture of each date."""
        return [Route("/figure/date/{number}.jpg", self._picture, methods=["GET"])]

    def reported(self) -> dict[str, Any]:
        """Dates, points and areas with their displacements; no dates: the result has none."""
        with self._lock:
            read = self._current()
            if read is None:
                return {"dates": [], "rows": [], "picture": None, "why": ""}
            try:
                return self._reported(read)
            except (KeyError, TypeError, ValueError, IndexError, AttributeError, np.linalg.LinAlgError) as error:
                file = self.desk.source / EPOCHS
                raise InputError("file.not_understood", detail=f"{type(error).__name__}: {error}", file=file) from None

    def _reported(self, read: _Read) -> dict[str, Any]:
        p = read.pictures
        shown = None if p is None else {"width": p.grid.width, "height": p.grid.height, "pixel": p.grid.pixel}
        names = [str(d["date"]) for d in read.about["dates"]]
        return {
            "dates": names, "rows": [*_areas(read, names), *_points(read, names)], "picture": shown,
            "why": read.why, "unit": "" if self.desk.block.free_scale else "m", "of": read.stamp[-1],
        }  # fmt: skip

    def _current(self) -> _Read | None:
        """What the result holds now; None: no displacements."""
        result = own_result(self.desk.source)
        if result is None or not all((result / n).is_file() for n in (DISPLACEMENTS, EPOCHS)):
            return None
        stamp = (self.desk.times, *((result / n).stat().st_mtime_ns for n in (EPOCHS, DISPLACEMENTS)))
        if self._read is None or self._read.stamp != stamp:
            pictures, why = None, ""
            try:
                pictures = DatedPictures.of(self.desk.block)
            except InputError as error:
                why = cause_of(error)
            about: Any = read_json(result / EPOCHS).value
            displaced = read_displacements(result / DISPLACEMENTS)
            self._read = _Read(stamp=stamp, displaced=displaced, about=about, pictures=pictures, why=why)
        return self._read

    async def _picture(self, request: Request) -> Response:
        number = request.path_params["number"]
        if not (number.isascii() and number.isdigit() and len(number) < 4):
            raise HTTPException(404, phrase("studio_page.bad_request", name="date", kind="number"))
        try:
            body = await run_in_threadpool(self._drawn, int(number))
        except InputError as error:
            raise HTTPException(404, cause_of(error)) from None
        return Response(body, media_type="image/jpeg", headers={"cache-control": "private, max-age=3600"})

    def _drawn(self, number: int) -> bytes:
        """JPEG of a date; made once."""
        with self._lock:
            read = self._current()
            if read is None or read.pictures is None or number >= len(read.pictures.dates):
                raise HTTPException(404, phrase("studio_page.no_page"))
            if number not in read.drawn:
                folders = list(dict.fromkeys(path.parent for path in self.desk.tiles.paths.values()))
                colours = read.pictures.rectified(read.pictures.dates[number], folders)
                _, body = cv2.imencode(".jpg", colours[..., ::-1], [cv2.IMWRITE_JPEG_QUALITY, JPEG_QUALITY])
                read.drawn[number] = body.tobytes()
            return read.drawn[number]


def _points(read: _Read, names: list[str]) -> list[dict[str, Any]]:
    """Of each point its displacements against its first date."""
    d = read.displaced
    order = {name: k for k, name in enumerate(names)}
    rows: dict[str, list[int]] = {}
    for k, point in enumerate(d.point):
        rows.setdefault(point, []).append(k)
    found: list[dict[str, Any]] = []
    for point, each in rows.items():
        moved = [d.verdict[k] in {MOVED, IN_AREA} for k in each]
        verdict = next((d.verdict[k] for k, m in zip(each, moved, strict=True) if m), d.verdict[each[0]])
        row = {"name": point, "area": False, "verdict": verdict, "first": order[d.start[each[0]]]}
        if verdict != STABLE:
            row |= _series(read, d.vector[each], d.covariance[each], d.p[each].tolist())
            row |= {"at": [order[d.end[k]] for k in each], "moved": moved}
        found.append({**row, **_place(read, d.xyz[each[0]])})
    return found


def _areas(read: _Read, names: list[str]) -> list[dict[str, Any]]:
    """Areas that moved, and groups that were given."""
    d, order = read.displaced, {name: k for k, name in enumerate(names)}
    place = dict(zip(d.point, d.xyz, strict=True))
    found: list[dict[str, Any]] = []
    for a in read.about["areas"]:
        if not (a["moved"] or a["given"]):
            continue
        each = a["displacements"]
        v, C = np.array([r["d_m"] for r in each], float), np.array([r["covariance_m2"] for r in each], float)
        F = np.einsum("ri,rij,rj->r", v, np.linalg.pinv(C, hermitian=True), v) / 3
        p = [fisher_tail(float(f), 3, float("inf")) for f in F]
        level = float(read.about["limit_of_one_test"]) / len(each)
        xyz = np.mean([place[name] for name in a["points"] if name in place] or [np.full(3, np.nan)], axis=0)
        found.append({
            "name": a["name"], "area": True, "verdict": MOVED if a["moved"] else STABLE, "first": 0,
            "at": [order[r["to"]] for r in each], "moved": [a["moved"] and q < level for q in p],
            "points": a["points"],
            "between": [[r["shortest_m"], r["longest_m"]] for r in each] if a.get("uneven") else None,
            **_series(read, v, C, p), **_place(read, xyz),
        })  # fmt: skip
    return found


def _series(read: _Read, vector: Array, covariance: Array, p: list[float]) -> dict[str, Any]:
    """Displacements with their standard deviations, in the axes of the block, of the picture, and along the last."""
    length = np.linalg.norm(vector, axis=1)
    way = vector[int(length.argmax())] / max(float(length.max()), 1e-300)
    own = vector / np.maximum(length, 1e-300)[:, None]
    seen = vector if read.pictures is None else read.pictures.directions(vector)
    return {
        "d": vector.tolist(), "s": np.sqrt(np.maximum(np.diagonal(covariance, axis1=1, axis2=2), 0)).tolist(),
        "length": length.tolist(), "sigma": _sigma(own, covariance).tolist(), "p": [finite(q) for q in p],
        "along": (vector @ way).tolist(), "along_sigma": _sigma(np.tile(way, (len(vector), 1)), covariance).tolist(),
        "seen": seen.tolist(),
    }  # fmt: skip


def _sigma(way: Array, covariance: Array) -> Array:
    """(r,) standard deviations along directions."""
    return np.sqrt(np.maximum(np.einsum("ri,rij,rj->r", way, covariance, way), 0))


def _place(read: _Read, xyz: Array) -> dict[str, Any]:
    """Where a point lies in the pictures, None: not known."""
    if read.pictures is None or not np.isfinite(xyz).all():
        return {"place": None}
    metres = 0.001 if read.pictures.block.length_unit == "mm" else 1.0
    return {"place": read.pictures.cells(xyz[None] / metres)[0].tolist()}
