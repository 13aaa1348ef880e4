"""Stage: coded targets in the photographs, measured as named points of which nothing is given, or of the control's."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from pathlib import Path

import numpy as np

from raybundle.adjustment.records.notice import Notice
from raybundle.block import Role
from raybundle.errors import InputError, message_of_text, phrase
from raybundle.io.geo.control_files import ControlFile, Measurements
from raybundle.io.photos.photo import Photo
from raybundle.numerics.arrays import Array
from raybundle.pipeline.stage import Means, Stage
from raybundle.placing.marks import Given
from raybundle.targets.marks import Marks, Target, target
from raybundle.workflows.calibrating.target_block import covariance_rows
from raybundle.workflows.orienting.state import ORIENT, OrientState
from raybundle.workflows.target_tasks import measure_targets

FILE = Path("targets")
"""What stands for the file that names the points, where messages name one."""


@dataclass(frozen=True, slots=True, kw_only=True)
class Inputs:
    """What is measured."""

    photos: tuple[Photo, ...]
    targets: tuple[Target, ...]
    given: Given


@dataclass(frozen=True, slots=True, kw_only=True)
class Seen:
    """What is known of object space with the targets, and what there is to say."""

    given: Given
    points: int
    rays: int
    notices: tuple[Notice, ...]


def measure(i: Inputs, means: Means) -> Seen:
    """Each photograph is measured by a task of its own."""
    marks = measure_targets(means, i.photos, i.targets)
    found = named_targets(i.photos, i.targets, marks)
    notices: list[Notice] = []
    if not found.ids:
        notices.append(Notice(code="no_targets.unread", values={"families": [t.title for t in i.targets]}))
    notices += [
        Notice(code="photographs.targets", values={"photograph": p.name}, details=(message_of_text(r),))
        for p, sets in zip(i.photos, marks, strict=True) for m in sets for r in m.remarks
    ]  # fmt: skip
    return Seen(
        given=with_targets(i.given, found), points=len(found.ids), rays=len(found.measurements), notices=tuple(notices)
    )


def named_targets(photos: Sequence[Photo], targets: Sequence[Target], marks: Sequence[Sequence[Marks]]) -> ControlFile:
    """The targets that have a name, as marked points of which nothing is given.

    marks  for each photograph, for each family
    Of several families names begin with the family: "aicon14:3".  A code that was read twice in one photograph is one
    of them by mistake, and nobody knows which: both are left out there.
    """
    names: dict[str, int] = {}
    image, point = list[str](), list[int]()
    xy, covariance, radius = list[Array](), list[Array](), list[Array]()
    for photo, sets in zip(photos, marks, strict=True):
        for m in sets:
            prefix = "" if len(targets) == 1 else f"{m.family}:"
            once = [k for k, n in enumerate(m.name) if n and m.name.count(n) == 1]
            own = m.rows(np.array(once, np.int64))
            image += [photo.name] * len(own)
            point += [names.setdefault(prefix + n, len(names)) for n in own.name]
            xy.append(own.xy_px)
            covariance.append(covariance_rows(own.covariance))
            radius.append(own.radius_px)
    n = len(names)
    return ControlFile(
        path=FILE, crs=None, ids=tuple(names), xyz=np.full((n, 3), np.nan), sigma=np.full((n, 3), np.nan),
        role=np.full(n, int(Role.TIE), np.int32),
        measurements=Measurements(
            image=tuple(image), point=np.array(point, np.int32), xy_px=np.vstack([np.zeros((0, 2)), *xy]),
            line=np.zeros(len(image), np.int32), covariance=np.vstack([np.zeros((0, 3)), *covariance]),
            radius_px=np.concatenate([np.zeros(0), *radius]),
        ),
    )  # fmt: skip


def with_targets(given: Given, found: ControlFile) -> Given:
    """What is given, with the measured targets: those that control names are measurements of its points.

    A point that control marks in a photograph in which the target was read is taken where the target is.
    """
    left = np.ones(len(found.ids), bool)
    control: list[ControlFile] = []
    for file in given.control:
        mine = {name: k for k, name in enumerate(found.ids) if name in set(file.ids)}
        if not mine:
            control.append(file)
            continue
        left[list(mine.values())] = False
        own = {k: file.ids.index(name) for name, k in mine.items()}
        m = found.measurements.rows(np.flatnonzero(np.isin(found.measurements.point, list(own))))
        m = replace(m, point=np.array([own[int(k)] for k in m.point], np.int32))
        read = set(zip(m.image, m.point.tolist(), strict=True))
        before = file.measurements
        kept = [k for k, key in enumerate(zip(before.image, before.point.tolist(), strict=True)) if key not in read]
        control.append(replace(file, measurements=before.rows(np.array(kept, np.int64)).and_(m)))
    if left.any():
        at = np.cumsum(left) - 1
        m = found.measurements.rows(np.flatnonzero(left[found.measurements.point]))
        control.append(
            replace(
                found, ids=tuple(n for n, k in zip(found.ids, left, strict=True) if k), xyz=found.xyz[left],
                sigma=found.sigma[left], role=found.role[left],
                measurements=replace(m, point=at[m.point].astype(np.int32)),
            )
        )  # fmt: skip
    return replace(given, control=tuple(control))


def _inputs(state: OrientState) -> Inputs:
    return Inputs(photos=state.photos, targets=wanted(state.asked.options.target), given=state.given)


def wanted(names: Sequence[str]) -> tuple[Target, ...]:
    """Targets by the names of their families; raises InputError for a name that is none, or stands there twice."""
    if len(set(names)) < len(names):
        raise InputError("target.family_twice", names=names)
    return tuple(target(name) for name in names)


def _put(state: OrientState, seen: Seen) -> OrientState:
    return replace(state, given=seen.given, notices=(*state.notices, *seen.notices))


def _outcome(state: OrientState) -> str:
    rays = sum(int(np.isfinite(c.measurements.covariances).all(axis=1).sum()) for c in state.given.control)
    return phrase("stage_summary.targets", n=rays)


STAGE = ORIENT.register(
    Stage(
        name="targets",
        line="photographs",
        after=("photographs",),
        inputs=_inputs,
        function=measure,
        put=_put,
        reported=_outcome,
        when=lambda s: bool(s.asked.options.target and s.photos),
    )
)
