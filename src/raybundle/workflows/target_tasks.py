"""Targets measured in photographs, a task for each photograph."""

from __future__ import annotations

import json
from collections.abc import Mapping, Sequence
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass
from typing import Any

import numpy as np

from raybundle.errors import InputError, message_of_text
from raybundle.io.photos.photo import Photo, read_grey
from raybundle.io.reading.texts import stored_text
from raybundle.numerics.arrays import Array
from raybundle.pipeline.keys import key_of
from raybundle.pipeline.place import Product
from raybundle.pipeline.stage import Means
from raybundle.pipeline.store import Folder
from raybundle.pipeline.tasks import Task
from raybundle.targets.codes import RingFamily
from raybundle.targets.families import families
from raybundle.targets.kinds.rings import Rings
from raybundle.targets.marks import Marks, Target, detect, target

VERSION = 1
"""Raised with every change of what the detection of any target gives."""
PIXELS_A_SECOND = 8e6
"""For the order of tasks and the time that is left."""


@dataclass(frozen=True, slots=True, kw_only=True)
class OwnRings:
    """Rings by a table of one's own."""

    name: str
    title: str
    bits: int
    ring: tuple[float, float]
    ground: float
    read: tuple[float, float]
    table: tuple[tuple[int, int], ...]


@dataclass(frozen=True, slots=True, kw_only=True)
class Wanted:
    """A target as plain data."""

    family: str
    dots: bool = False
    rings: OwnRings | None = None

    @property
    def target(self) -> Target:
        """The target."""
        if self.rings is not None:
            r = self.rings
            own = RingFamily(
                name=r.name, title=r.title, bits=r.bits, ring=r.ring, ground=r.ground, read=r.read, table=dict(r.table)
            )
            return Rings(rings=own, dots=self.dots)
        found = target(self.family)
        return Rings(rings=found.rings, dots=True) if self.dots and isinstance(found, Rings) else found


def wanted(given: Target) -> Wanted | None:
    """A target as plain data; None for one that a program made and no name shows."""
    if isinstance(given, Rings):
        r = given.rings
        if r is None or families.get(r.name) is r:
            return Wanted(family=given.family, dots=given.dots)
        if r.rule is not None:
            return None
        own = OwnRings(
            name=r.name, title=r.title, bits=r.bits, ring=r.ring, ground=r.ground, read=r.read,
            table=tuple(sorted((int(i), int(code)) for i, code in r.table.items())),
        )  # fmt: skip
        return Wanted(family=given.family, dots=given.dots, rings=own)
    try:
        named = target(given.family)
    except InputError:
        return None
    return Wanted(family=given.family) if type(named) is type(given) and named == given else None


@dataclass(frozen=True, slots=True, kw_only=True)
class TargetsTask:
    """What the targets of a photograph are measured by."""

    photo: Photo
    targets: tuple[Wanted, ...]


def targets_of(store: Folder, task: TargetsTask) -> Product:
    """The task: points of all targets in one photograph."""
    del store
    grey = read_grey(task.photo)
    return arrays_of_marks([detect(grey, w.target) for w in task.targets])


def measure_targets(means: Means, photos: Sequence[Photo], targets: Sequence[Target]) -> tuple[tuple[Marks, ...], ...]:
    """Points of all targets in all photographs, one set for each family.

    Raises InputError where the pixels of a photograph cannot be read.  What is no target by name is measured each time.
    """
    plain = tuple(w for t in targets if (w := wanted(t)) is not None)
    if len(plain) < len(targets):
        return _each_time(means, photos, targets)
    tasks = [
        Task(
            key=key_of("targets", VERSION, p.sha256, plain), function=f"{__name__}:targets_of",
            options=TargetsTask(photo=p, targets=plain), cost=p.width_px * p.height_px / PIXELS_A_SECOND, name=p.name,
        )
        for p in photos
    ]  # fmt: skip
    for reason in means.do(tasks, "targets").values():
        raise InputError(reason)
    return tuple(marks_from(means.store.wanted(t.key), targets) for t in tasks)


def _each_time(means: Means, photos: Sequence[Photo], targets: Sequence[Target]) -> tuple[tuple[Marks, ...], ...]:
    def one(photo: Photo) -> tuple[Marks, ...]:
        grey = read_grey(photo)
        return tuple(detect(grey, t) for t in targets)

    done: list[tuple[Marks, ...]] = []
    with ThreadPoolExecutor(means.jobs) as pool:
        for k, found in enumerate(pool.map(one, photos)):
            means.progress("targets", (k + 1) / len(photos))
            done.append(found)
    return tuple(done)


FIELDS = ("xy_px", "covariance", "ellipse", "gate")


def arrays_of_marks(sets: Sequence[Marks]) -> dict[str, Array]:
    """Points of some families in one photograph, as they are kept."""
    arrays: dict[str, Array] = {}
    for k, m in enumerate(sets):
        arrays |= {f"{k}:{name}": getattr(m, name) for name in FIELDS}
        arrays[f"{k}:name"] = np.array(m.name, dtype=np.str_)
        arrays[f"{k}:remarks"] = np.array([json.dumps(message_of_text(r).json()) for r in m.remarks], dtype=np.str_)
    return arrays


def marks_from(a: Mapping[str, Array], targets: Sequence[Target]) -> tuple[Marks, ...]:
    """The same again."""

    def numbers(k: int) -> dict[str, Any]:
        return {name: a[f"{k}:{name}"] for name in FIELDS}

    return tuple(
        Marks(
            family=t.family, name=tuple(a[f"{k}:name"].tolist()),
            remarks=tuple(stored_text(r) for r in a[f"{k}:remarks"].tolist()),
            **numbers(k),
        )
        for k, t in enumerate(targets)
    )  # fmt: skip
