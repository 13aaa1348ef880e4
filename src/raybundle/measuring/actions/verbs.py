"""The verbs of measuring: one small type each, with its checks.

Names are data: they are kept, compared and written, never interpreted.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import asdict, dataclass, replace
from typing import Any, ClassVar, Literal, cast

import msgspec
import numpy as np

from raybundle.errors import InputError
from raybundle.io.reading.words import quoted
from raybundle.measuring.actions.base import Action
from raybundle.measuring.actions.checks import (
    check_given,
    check_mark,
    check_name,
    check_number,
    check_point,
    exists,
    marked,
    name_in_block,
)
from raybundle.measuring.actions.control import GiveControl
from raybundle.measuring.actions.decisions import RejectBeyond, SetParameter
from raybundle.measuring.actions.drawings import Draw, Erase
from raybundle.measuring.actions.masks import SetMask, Unmask
from raybundle.measuring.names import Known
from raybundle.measuring.state import (
    Axes,
    Bar,
    Draft,
    How,
    Line,
    LineKind,
    Mark,
    MeasuredPoint,
    Numbers3,
    RoleName,
    State,
)

LEAST: Mapping[LineKind, int] = {"straight": 3, "plumb": 2, "level": 2, "plane": 4}
"""Points from which on a figure states something."""

LEAST_RATIO = 3
"""Of a measured length to its standard deviation: below, a length of nothing is within three of them."""

HAND_PX = 0.5
"""Standard deviation of a point marked by hand, as of the marks of control files."""
FIDUCIAL_PX = 0.2
"""The same of a fiducial mark, as of the marks of `raybundle film`."""
NOTHING: Numbers3 = (None, None, None)


@dataclass(frozen=True, slots=True, kw_only=True)
class Put(Action):
    """Mark a point in an image; a name that is new makes a tie point."""

    verb: ClassVar[str] = "put"
    image: str
    point: str
    x_px: float
    y_px: float
    covariance: tuple[float, float, float] = (HAND_PX**2, HAND_PX**2, 0.0)
    how: How = "hand"
    clicked: tuple[float, float] | None = None
    quality: float | None = None

    @property
    def mark(self) -> Mark:
        """What it puts there."""
        return Mark(
            x_px=self.x_px, y_px=self.y_px, covariance=self.covariance, how=self.how, clicked=self.clicked,
            quality=self.quality,
        )  # fmt: skip

    def settled(self, state: State, known: Known) -> Action:
        check_name("point", self.point)
        image = known.image(self.image)
        check_mark(known, image, self.mark)
        if (image, self.point) in state.marks:
            raise InputError("mark.exists", point=self.point, image=image)
        return replace(self, image=image)

    def apply(self, draft: Draft) -> None:
        draft.marks[self.image, self.point] = self.mark
        draft.points.setdefault(self.point, MeasuredPoint())


@dataclass(frozen=True, slots=True, kw_only=True)
class Move(Put):
    """Mark a point elsewhere in an image in which it is marked."""

    verb: ClassVar[str] = "move"

    def settled(self, state: State, known: Known) -> Action:
        image = marked(self.image, self.point, state, known)
        check_mark(known, image, self.mark)
        return replace(self, image=image)


@dataclass(frozen=True, slots=True, kw_only=True)
class Remove(Action):
    """Take a mark away; the point stays."""

    verb: ClassVar[str] = "remove"
    image: str
    point: str

    def settled(self, state: State, known: Known) -> Action:
        return replace(self, image=marked(self.image, self.point, state, known))

    def apply(self, draft: Draft) -> None:
        draft.marks.pop((self.image, self.point), None)


@dataclass(frozen=True, slots=True, kw_only=True)
class Point(Action):
    """Give a point its role, and what is known of its coordinates."""

    verb: ClassVar[str] = "point"
    point: str
    role: RoleName = "tie"
    xyz: Numbers3 = NOTHING
    sigma: Numbers3 = NOTHING

    def settled(self, state: State, known: Known) -> Action:
        del state, known
        check_given(self.point, self.role, self.xyz, self.sigma)
        return self

    def apply(self, draft: Draft) -> None:
        draft.points[self.point] = MeasuredPoint(role=self.role, xyz=self.xyz, sigma=self.sigma, reported=True)


@dataclass(frozen=True, slots=True, kw_only=True)
class Rename(Action):
    """Give a point another name, wherever it is named."""

    verb: ClassVar[str] = "rename"
    point: str
    to: str
    original: str = ""
    """its name in the block, where it stands there; found, whatever is given"""

    def settled(self, state: State, known: Known) -> Action:
        check_point(self.point, state, known)
        check_name("point", self.to)
        original = name_in_block(self.point, state, known)
        if exists(self.to, state, known):
            raise InputError("mark.name_taken", point=self.point, to=self.to)
        return replace(self, original=original)

    def apply(self, draft: Draft) -> None:
        def of(name: str) -> str:
            return self.to if name == self.point else name

        d = draft
        if self.original:
            d.renamed.pop(self.original, None)
            if self.original != self.to:
                d.renamed[self.original] = self.to
        d.points = {of(p): v for p, v in d.points.items()}
        d.marks = {(i, of(p)): m for (i, p), m in d.marks.items()}
        d.bars = {(of(a), of(b)): v for (a, b), v in d.bars.items()}
        d.lines = {n: replace(v, points=tuple(map(of, v.points))) for n, v in d.lines.items()}
        d.rejected = {(i, of(p)) for i, p in d.rejected}
        if d.datum is not None:
            d.datum = Axes(**{k: of(p) if p else "" for k, p in asdict(d.datum).items()})


@dataclass(frozen=True, slots=True, kw_only=True)
class Forget(Action):
    """Take away all that was measured of a point, and the bars and lines that name it."""

    verb: ClassVar[str] = "forget"
    point: str

    def settled(self, state: State, known: Known) -> Action:
        if self.point not in state.points:
            if exists(self.point, state, known):
                raise InputError("mark.point_of_block", point=self.point)
            check_point(self.point, state, known)
        return self

    def apply(self, draft: Draft) -> None:
        draft.drop_points({self.point})


@dataclass(frozen=True, slots=True, kw_only=True)
class SetBar(Action):
    """A measured distance between two points; one between them before is replaced."""

    verb: ClassVar[str] = "bar"
    start: str
    end: str
    length: float
    sigma: float

    def settled(self, state: State, known: Known) -> Action:
        for name in (self.start, self.end):
            check_point(name, state, known)
        if self.start == self.end:
            raise InputError("mark.bar_same_ends", start=self.start, end=self.end)
        check_number(f"{self.start} - {self.end}, length", self.length, above=0.0)
        check_number(f"{self.start} - {self.end}, sigma", self.sigma, above=0.0)
        if not LEAST_RATIO * self.sigma <= self.length:
            raise InputError(
                "mark.bar_sigma",
                start=self.start,
                end=self.end,
                sigma=self.sigma,
                length=self.length,
                ratio=LEAST_RATIO,
            )
        return self

    def apply(self, draft: Draft) -> None:
        draft.bars.pop((self.end, self.start), None)
        draft.bars[self.start, self.end] = Bar(length=self.length, sigma=self.sigma)


@dataclass(frozen=True, slots=True, kw_only=True)
class Unbar(Action):
    """Take a scale bar away."""

    verb: ClassVar[str] = "unbar"
    start: str
    end: str

    def settled(self, state: State, known: Known) -> Action:
        if not {(self.start, self.end), (self.end, self.start)} & state.bars.keys():
            raise InputError("mark.no_bar", start=self.start, end=self.end, known=[f"{a} - {b}" for a, b in state.bars])
        return self

    def apply(self, draft: Draft) -> None:
        draft.bars.pop((self.start, self.end), None)
        draft.bars.pop((self.end, self.start), None)


@dataclass(frozen=True, slots=True, kw_only=True)
class SetLine(Action):
    """Points on one line, level or plane; one of that name is replaced, no points: it is taken away."""

    verb: ClassVar[str] = "line"
    line: str
    points: tuple[str, ...]
    kind: LineKind = "straight"
    sigma: float = 0.01

    def settled(self, state: State, known: Known) -> Action:
        check_name("line", self.line)
        if not self.points:
            if self.line not in state.lines:
                raise InputError("mark.no_line", line_name=self.line, known=list(state.lines))
            return self
        for name in self.points:
            check_point(name, state, known)
        least = LEAST[self.kind]
        if len(set(self.points)) < len(self.points) or len(self.points) < least:
            raise InputError(
                "mark.line_points", line_name=self.line, kind=self.kind, n=len(set(self.points)), least=least
            )
        check_number(f"{self.line}, sigma", self.sigma, above=0.0)
        return self

    def apply(self, draft: Draft) -> None:
        if self.points:
            draft.lines[self.line] = Line(kind=self.kind, points=tuple(self.points), sigma=self.sigma)
        else:
            draft.lines.pop(self.line, None)


@dataclass(frozen=True, slots=True, kw_only=True)
class SetDatum(Action):
    """The coordinate system by three points, or by two where levels or plumb lines show the vertical.

    All empty: as the block has it.
    """

    verb: ClassVar[str] = "datum"
    origin: str = ""
    axis: str = ""
    plane: str = ""

    def settled(self, state: State, known: Known) -> Action:
        names = (self.origin, self.axis, self.plane)
        if not any(names):
            return self
        for what, name in zip(("origin", "axis", "plane"), names, strict=True):
            if name:
                check_point(name, state, known)
            elif what != "plane":
                raise InputError("axes.point_missing", which=what)
        given = [n for n in names if n]
        if len(set(given)) < len(given):
            raise InputError("axes.same_points", names=given)
        return self

    def apply(self, draft: Draft) -> None:
        draft.datum = Axes(origin=self.origin, axis=self.axis, plane=self.plane) if self.origin else None


@dataclass(frozen=True, slots=True, kw_only=True)
class Reject(Action):
    """Leave an image observation of the block out."""

    verb: ClassVar[str] = "reject"
    image: str
    point: str

    def settled(self, state: State, known: Known) -> Action:
        image = known.image(self.image)
        check_point(self.point, state, known)
        original = name_in_block(self.point, state, known)
        if not original or not known.observed(image, original):
            raise InputError("mark.no_observation", point=self.point, image=image)
        return replace(self, image=image)

    def apply(self, draft: Draft) -> None:
        draft.rejected.add((self.image, self.point))


@dataclass(frozen=True, slots=True, kw_only=True)
class Accept(Action):
    """Let an image observation take part again that was rejected by hand."""

    verb: ClassVar[str] = "accept"
    image: str
    point: str

    def settled(self, state: State, known: Known) -> Action:
        image = known.image(self.image)
        if (image, self.point) not in state.rejected:
            raise InputError("mark.not_rejected", point=self.point, image=image)
        return replace(self, image=image)

    def apply(self, draft: Draft) -> None:
        draft.rejected.discard((self.image, self.point))


@dataclass(frozen=True, slots=True, kw_only=True)
class Fiducial(Action):
    """Where a fiducial mark is in a scan of film; one measured before is replaced, without a place it is taken away."""

    verb: ClassVar[str] = "fiducial"
    image: str
    name: str
    x_px: float | None = None
    y_px: float | None = None
    covariance: tuple[float, float, float] = (FIDUCIAL_PX**2, FIDUCIAL_PX**2, 0.0)
    how: How = "hand"
    clicked: tuple[float, float] | None = None
    quality: float | None = None

    @property
    def mark(self) -> Mark | None:
        """What it puts there; None: nothing."""
        if self.x_px is None or self.y_px is None:
            return None
        return Mark(
            x_px=self.x_px, y_px=self.y_px, covariance=self.covariance, how=self.how, clicked=self.clicked,
            quality=self.quality,
        )  # fmt: skip

    def settled(self, state: State, known: Known) -> Action:
        image = known.image(self.image)
        if self.name not in known.fiducials:
            if not known.fiducials:
                raise InputError("fiducial.no_film")
            raise InputError("fiducial.not_calibrated", name=self.name, known=list(known.fiducials))
        if (self.x_px is None) != (self.y_px is None):
            raise InputError("fiducial.one_coordinate", name=self.name, image=image)
        if self.mark is not None:
            check_mark(known, image, self.mark)
        elif (image, self.name) not in state.fiducials:
            raise InputError("fiducial.not_measured", name=self.name, image=image)
        return replace(self, image=image)

    def apply(self, draft: Draft) -> None:
        if self.mark is None:
            draft.fiducials.pop((self.image, self.name), None)
        else:
            draft.fiducials[self.image, self.name] = self.mark


@dataclass(frozen=True, slots=True, kw_only=True)
class _Turn(Action):
    """What moves among the actions before it: the fold does that, and the state itself stays."""

    def apply(self, draft: Draft) -> None:
        del draft


@dataclass(frozen=True, slots=True, kw_only=True)
class Undo(_Turn):
    """Take the last action back that is not taken back."""

    verb: ClassVar[str] = "undo"

    @property
    def turns(self) -> Literal["", "undo", "redo"]:
        return "undo"

    def settled(self, state: State, known: Known) -> Action:
        if not state.can_undo:
            raise InputError("journal.nothing_to_undo")
        return self


@dataclass(frozen=True, slots=True, kw_only=True)
class Redo(_Turn):
    """Do again what was taken back last."""

    verb: ClassVar[str] = "redo"

    @property
    def turns(self) -> Literal["", "undo", "redo"]:
        return "redo"

    def settled(self, state: State, known: Known) -> Action:
        if not state.can_redo:
            raise InputError("journal.nothing_to_redo")
        return self


_KINDS: tuple[type[Action], ...] = (
    Put, Move, Remove, Point, Rename, Forget, SetBar, Unbar, SetLine, SetDatum, Reject, Accept, RejectBeyond,
    SetParameter, Fiducial, GiveControl, SetMask, Unmask, Draw, Erase, Undo, Redo,
)  # fmt: skip
VERBS: dict[str, type[Action]] = {kind.verb: kind for kind in _KINDS}
"""Every verb -> its type."""


def _plain(value: Any) -> Any:
    """Numbers and arrays of NumPy as Python's own."""
    if isinstance(value, np.generic | np.ndarray):
        return value.tolist()
    if isinstance(value, dict):
        return {k: _plain(v) for k, v in cast("dict[str, Any]", value).items()}
    return [_plain(v) for v in cast("list[Any]", value)] if isinstance(value, list | tuple) else value


def action_of(verb: str, arguments: Mapping[str, Any]) -> Action:
    """The action that a verb and its arguments as JSON say; raises InputError."""
    kind = VERBS.get(verb)
    if kind is None:
        raise InputError("action.unknown_verb", verb=quoted(verb), known=list(VERBS))
    foreign = sorted(set(arguments) - set(kind.__dataclass_fields__))
    if foreign:
        raise InputError(
            "action.unknown_argument", verb=verb, name=quoted(foreign[0]), known=list(kind.__dataclass_fields__)
        )
    try:
        return msgspec.convert(_plain(dict(arguments)), kind)
    except msgspec.ValidationError as error:
        raise InputError("action.arguments", verb=verb, detail=str(error)) from None
