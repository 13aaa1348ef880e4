"""Targets found in the photographs: those that a calibration keeps, or found now, and what became of each."""

from __future__ import annotations

import threading
from collections.abc import Sequence
from dataclasses import dataclass, field
from typing import Any

import numpy as np
from scipy.spatial import KDTree

from raybundle import errors
from raybundle.errors import InputError, Text, code_of, phrase
from raybundle.io.photos.photo import Photo, read_grey
from raybundle.measuring.frames import to_file
from raybundle.numerics.arrays import Array, Mask
from raybundle.pipeline.keys import key_of
from raybundle.pipeline.project import products_of
from raybundle.results.folder import PROJECT
from raybundle.studio.answers import finite, numbers
from raybundle.studio.desk import Desk, named
from raybundle.studio.watchers import Live, cause_of
from raybundle.targets.families import families
from raybundle.targets.kinds.rings import Rings
from raybundle.targets.marks import Marks, Target, detect, forms, target
from raybundle.workflows.target_tasks import VERSION, marks_from, wanted

NEAR_PX = 1.5
"""How far an image observation may lie from a mark without a name to be of it: the centre of a circle is not quite the
centre of its ellipse."""
MOST_ROWS = 5000
USED, REJECTED, APART, UNNAMED = "used", "rejected", "apart", "unidentified"
Sets = tuple[Marks, ...]


@dataclass(slots=True)
class Detecting:
    """Targets by photograph and families; found one photograph after the other, in the background."""

    desk: Desk
    live: Live
    _found: dict[tuple[str, str], tuple[str, Sets]] = field(default_factory=dict[tuple[str, str], tuple[str, Sets]])
    """(hash of a photograph, families) -> where from, marks"""
    _failed: dict[tuple[str, str], str] = field(default_factory=dict[tuple[str, str], str])
    _thread: threading.Thread | None = None
    _waiting: list[tuple[str, str]] = field(default_factory=list[tuple[str, str]])
    """(image, families)"""
    _stop: threading.Event = field(default_factory=threading.Event)
    _lock: threading.Lock = field(default_factory=threading.Lock)

    @property
    def busy(self) -> bool:
        """Whether targets are sought."""
        return self._thread is not None and self._thread.is_alive()

    def overview(self, text: str) -> dict[str, Any]:
        """How many targets each photograph shows, and what became of them; raises InputError for unknown families."""
        targets = targets_of(text)
        rows: list[dict[str, Any]] = []
        for image in self.desk.block.images.ids:
            found, why = self._known(image, text, targets) if targets else (None, "")
            rows.append({"image": image, **_counts(self.desk, image, found), "why": why})
        return {
            "families": text, "known": [*families], "forms": forms(), "images": rows, "detecting": self.busy,
        }  # fmt: skip

    def of_image(self, image: str, text: str) -> dict[str, Any]:
        """The marks of one photograph with their ellipses and precision; raises InputError."""
        named(self.desk, image)
        found, why = self._known(image, text, targets_of(text))
        about = {"image": image, "families": text, "why": why}
        if found is None:
            return {**about, "from": "", "rows": [], "remarks": []}
        source, sets = found
        rows = _rows(self.desk, image, sets)
        remarks = [r for m in sets for r in m.remarks]
        return {**about, "from": source, "rows": rows[:MOST_ROWS], "remarks": remarks, "total": len(rows)}

    def begin(self, text: str, images: Sequence[str]) -> dict[str, Any]:
        """Seek targets in some photographs, or in all; raises InputError for families or images that are none."""
        targets = targets_of(text)
        if not targets:
            raise InputError("target.family_missing", known=list(forms()))
        for image in images:
            named(self.desk, image)
        with self._lock:
            added = [(i, text) for i in images or self.desk.block.images.ids if (i, text) not in self._waiting]
            self._waiting += added
            if not self.busy and added:
                self._stop.clear()
                self._thread = threading.Thread(target=self._work, daemon=True)
                self._thread.start()
        return {"begun": len(added)}

    def stop(self) -> bool:
        """Stop behind the photograph at work; False where nothing is sought."""
        self._stop.set()
        return self.busy

    def wait(self) -> None:
        """Until nothing is sought."""
        with self._lock:  # whoever begins holds it until what it began can be waited for
            thread = self._thread
        if thread is not None:
            thread.join()

    def _work(self) -> None:
        done, trouble = list[str](), ""
        while True:
            with self._lock:
                if self._stop.is_set():
                    self._waiting.clear()
                if not self._waiting:
                    self._thread = None  # whoever asks now begins anew
                    break
                image, text = self._waiting[0]
                left = len(self._waiting)
            share = len(done) / (len(done) + left)
            self.live.notify_from_thread(
                {"type": "progress", "stage": phrase("studio_target.in_image", image=image), "share": share}
            )
            try:
                self._one(image, text)
            except Exception as error:  # noqa: BLE001  (a thread of its own: whoever waits must hear of it)
                trouble = self._failed[image, text] = Text.of(errors.named(image, cause_of(error)))
            done.append(image)
            with self._lock:
                self._waiting.remove((image, text))
        self.live.notify_from_thread({"type": "targets", "images": done, "error": trouble, "code": code_of(trouble)})

    def _one(self, image: str, text: str) -> None:
        targets, photo = targets_of(text), self._photo(image)
        if self._known(image, text, targets)[0] is None:
            grey = read_grey(photo)
            self._found[photo.sha256, text] = "studio", tuple(detect(grey, t) for t in targets)

    def _photo(self, image: str) -> Photo:
        return self.desk.tiles.photo(named(self.desk, image))

    def _known(self, image: str, text: str, targets: Sequence[Target]) -> tuple[tuple[str, Sets] | None, str]:
        """What is kept or was found here, or why there can be nothing."""
        try:
            photo = self._photo(image)
        except InputError as error:
            return None, cause_of(error)
        key = photo.sha256, text
        if key not in self._found:
            kept = _kept(self.desk, photo, targets)
            if kept is None:
                return None, self._failed.get((image, text), "")
            self._found[key] = "calibrate", kept
        return self._found[key], ""


def targets_of(text: str) -> tuple[Target, ...]:
    """The targets of families with blanks between; raises InputError for one that is none."""
    return tuple(target(word) for word in text.split())


def _kept(desk: Desk, photo: Photo, targets: Sequence[Target]) -> Sets | None:
    """What the stage of targets keeps of a photograph, with dots or without."""
    folder = next((f for f in (desk.source / PROJECT, desk.source) if (f / "cache").is_dir()), None)
    if folder is None or not targets:
        return None
    try:
        store = products_of(folder)
    except InputError:  # a store that the user has not confirmed: targets are detected again
        return None
    for dots in (False, True):
        made = [Rings(rings=t.rings, dots=True) if dots and isinstance(t, Rings) else t for t in targets]
        plain = tuple(w for t in made if (w := wanted(t)) is not None)
        product = store.load(key_of("targets", VERSION, photo.sha256, plain))
        if product is not None:
            return marks_from(product, made)
    return None


def _joined(sets: Sets) -> tuple[list[str], Array, Array, Array]:
    """Names as the points of a block are called, places, covariances and ellipses of all sets."""
    many = len(sets) > 1
    names = [f"{m.family}:{n}" if many and n else n for m in sets for n in m.name]
    xy = np.concatenate([np.zeros((0, 2)), *(m.xy_px for m in sets)])
    covariance, ellipse = (
        np.concatenate([np.zeros((0, 2, 2)), *(getattr(m, name) for m in sets)]) for name in ("covariance", "ellipse")
    )
    return names, xy, covariance, ellipse


def _fates(desk: Desk, image: str, names: Sequence[str], xy: Array) -> tuple[list[str], list[str]]:
    """What each mark is called in the block, and what became of it there."""
    k = named(desk, image)
    rows, block, a = desk.rows_in(k), desk.block, desk.adjustment
    points = [block.points.ids[p] for p in block.observations.point[rows]]
    used: Mask = np.ones(len(rows), bool) if a is None else a.image_observations.used[rows]
    at = {name: bool(u) for name, u in zip(points, used, strict=True)}
    called = list(names)
    bare = [i for i, n in enumerate(called) if not n]
    if bare and len(rows):
        places = to_file(block, k, block.observations.xy_px[rows])
        far, nearest = KDTree(places).query(xy[bare])
        for i, d, r in zip(bare, np.atleast_1d(far).tolist(), np.atleast_1d(nearest).tolist(), strict=True):
            if d < NEAR_PX:
                called[i] = points[r]
    fates = [UNNAMED if not n else APART if n not in at else USED if at[n] else REJECTED for n in called]
    return called, fates


def _rows(desk: Desk, image: str, sets: Sets) -> list[dict[str, Any]]:
    """Each mark: name, place, standard deviation of a coordinate [px], ellipse, and what became of it."""
    names, xy, covariance, C = _joined(sets)
    called, fates = _fates(desk, image, names, xy)
    s = numbers(np.sqrt((covariance[:, 0, 0] + covariance[:, 1, 1]) / 2))
    round_: Mask = np.asarray(np.isfinite(C).all(axis=(1, 2)))
    axes, directions = np.linalg.eigh(np.where(round_[:, None, None], C, np.eye(2)))
    found: list[dict[str, Any]] = []
    for i, name in enumerate(called):
        ellipse = None
        if round_[i]:
            b, a = np.sqrt(np.maximum(axes[i], 0)).tolist()
            ellipse = {"a": a, "b": b, "angle_deg": float(np.degrees(np.arctan2(*directions[i, ::-1, 1])))}
        found.append({
            "name": name, "x": float(xy[i, 0]), "y": float(xy[i, 1]), "s": s[i], "ellipse": ellipse, "fate": fates[i],
        })  # fmt: skip
    return found


def _counts(desk: Desk, image: str, found: tuple[str, Sets] | None) -> dict[str, Any]:
    if found is None:
        return {"from": "", "found": None, "fates": {}, "median_s": None, "remarks": []}
    source, sets = found
    names, xy, covariance, _ = _joined(sets)
    _, fates = _fates(desk, image, names, xy)
    s = np.sqrt((covariance[:, 0, 0] + covariance[:, 1, 1]) / 2)
    return {
        "from": source, "found": len(names), "fates": {f: fates.count(f) for f in (USED, REJECTED, APART, UNNAMED)},
        "median_s": finite(float(np.median(s))) if len(s) else None, "remarks": [r for m in sets for r in m.remarks],
    }  # fmt: skip
