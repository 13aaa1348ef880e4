"""What measured points, bars and lines there are: the fold of the actions, undone ones left out.

A state is a value: it is never changed, each action makes the next one (`folded`).  The actions themselves are in
`raybundle.measuring.actions.verbs`.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass, field
from types import MappingProxyType
from typing import Literal, Protocol

RoleName = Literal["tie", "control", "check"]
How = Literal["hand", "ellipse", "corner", "cross", "patch", "file"]
Key = tuple[str, str]
"""image, point"""
Choice = Literal["free", "held"]
"""Of a parameter: estimated in any case, or held in any case."""
Numbers3 = tuple[float | None, float | None, float | None]
"""X, Y, Z, or their standard deviations; None: not known"""


@dataclass(frozen=True, slots=True, kw_only=True)
class Mark:
    """A point marked in an image, in the pixels of its file."""

    x_px: float
    y_px: float
    covariance: tuple[float, float, float]
    """variances of x and y and their covariance [px^2]"""
    how: How = "hand"
    clicked: tuple[float, float] | None = None
    """where the hand pointed, before snapping"""
    quality: float | None = None
    """of the snapping, 0 .. 1"""


@dataclass(frozen=True, slots=True, kw_only=True)
class MeasuredPoint:
    """An object point that was named by hand."""

    role: RoleName = "tie"
    xyz: Numbers3 = (None, None, None)
    """given coordinates [length unit of the block]; None: not known"""
    sigma: Numbers3 = (None, None, None)
    """0: held"""
    reported: bool = False
    """whether role and coordinates were given, not only the point marked"""


@dataclass(frozen=True, slots=True, kw_only=True)
class Bar:
    """A measured distance [length unit of the block]."""

    length: float
    sigma: float


LineKind = Literal["straight", "plumb", "level", "plane"]


def figure_called(kind: LineKind) -> str:
    """What a figure is, in words."""
    return kind if kind in {"level", "plane"} else f"{kind} line"


@dataclass(frozen=True, slots=True, kw_only=True)
class Line:
    """Points that lie on one straight or plumb line, at one level, or on one plane."""

    kind: LineKind
    points: tuple[str, ...]
    sigma: float
    """of a point's distance from the figure [length unit of the block]"""

    @property
    def called(self) -> str:
        """What it is, in words."""
        return figure_called(self.kind)

    @property
    def upright(self) -> bool:
        """Whether it shows the vertical."""
        return self.kind in {"plumb", "level"}


@dataclass(frozen=True, slots=True, kw_only=True)
class Axes:
    """A coordinate system by points: X from the origin to the axis point, the plane point in XY."""

    origin: str
    axis: str
    plane: str = ""
    """"": levels and plumb lines show the vertical, and the axis point lies on X in plan"""

    @property
    def points(self) -> tuple[str, ...]:
        """All that are given."""
        return tuple(p for p in (self.origin, self.axis, self.plane) if p)


@dataclass(frozen=True, slots=True, kw_only=True)
class MaskedArea:
    """A polygon in which nothing is to be measured."""

    image: str
    """in which it was drawn"""
    polygon: tuple[tuple[float, float], ...]
    """corners in the pixels of that image's file"""
    camera: bool = False
    """whether it holds for all images of the same camera"""


DrawingKind = Literal["line", "area"]


@dataclass(frozen=True, slots=True, kw_only=True)
class Drawing:
    """A line or an area on a surface."""

    kind: DrawingKind
    corners: tuple[tuple[float, float], ...]
    """in the coordinates of the surface; of an area without the first one again"""
    layer: str
    note: str
    surface: str
    """folder within the project"""


@dataclass(frozen=True, slots=True, kw_only=True)
class State:
    """All that is measured."""

    marks: Mapping[Key, Mark] = field(default_factory=dict[Key, Mark])
    """(image, point) -> mark"""
    points: Mapping[str, MeasuredPoint] = field(default_factory=dict[str, MeasuredPoint])
    bars: Mapping[Key, Bar] = field(default_factory=dict[Key, Bar])
    """(from, to) -> bar"""
    lines: Mapping[str, Line] = field(default_factory=dict[str, Line])
    datum: Axes | None = None
    fiducials: Mapping[Key, Mark] = field(default_factory=dict[Key, Mark])
    """(scan, name of the fiducial mark) -> where it is"""
    rejected: frozenset[Key] = frozenset()
    """rows of the block, (image, point), that take no part"""
    renamed: Mapping[str, str] = field(default_factory=dict[str, str])
    """points of the block -> their new names"""
    parameters: Mapping[Key, Choice] = field(default_factory=dict[Key, Choice])
    """(camera, symbol) -> what was decided of that parameter"""
    masks: Mapping[str, MaskedArea] = field(default_factory=dict[str, MaskedArea])
    drawings: Mapping[str, Drawing] = field(default_factory=dict[str, Drawing])
    can_undo: int = 0
    """actions that can be taken back"""
    can_redo: int = 0

    @property
    def adjusts(self) -> bool:
        """Whether something of it takes part in an adjustment: masks and drawings alone do not."""
        return any((
            self.marks, self.points, self.bars, self.lines, self.datum, self.fiducials, self.rejected, self.renamed,
            self.parameters,
        ))  # fmt: skip

    def marks_of(self, point: str) -> dict[str, Mark]:
        """The marks of a point, by image."""
        return {image: m for (image, p), m in self.marks.items() if p == point}

    def fiducials_in(self, image: str) -> dict[str, Mark]:
        """The fiducial marks measured in a scan, by name."""
        return {name: m for (i, name), m in self.fiducials.items() if i == image}

    def marks_in(self, image: str) -> dict[str, Mark]:
        """The marks in an image, by point."""
        return {p: m for (i, p), m in self.marks.items() if i == image}


EMPTY = State()


@dataclass(slots=True)
class Draft:
    """A state in work: what actions change."""

    marks: dict[Key, Mark] = field(default_factory=dict[Key, Mark])
    points: dict[str, MeasuredPoint] = field(default_factory=dict[str, MeasuredPoint])
    bars: dict[Key, Bar] = field(default_factory=dict[Key, Bar])
    lines: dict[str, Line] = field(default_factory=dict[str, Line])
    datum: Axes | None = None
    fiducials: dict[Key, Mark] = field(default_factory=dict[Key, Mark])
    rejected: set[Key] = field(default_factory=set[Key])
    renamed: dict[str, str] = field(default_factory=dict[str, str])
    parameters: dict[Key, Choice] = field(default_factory=dict[Key, Choice])
    masks: dict[str, MaskedArea] = field(default_factory=dict[str, MaskedArea])
    drawings: dict[str, Drawing] = field(default_factory=dict[str, Drawing])

    @classmethod
    def of(cls, state: State) -> Draft:
        """A copy that can be changed."""
        return cls(
            dict(state.marks), dict(state.points), dict(state.bars), dict(state.lines), state.datum,
            dict(state.fiducials), set(state.rejected), dict(state.renamed), dict(state.parameters),
            dict(state.masks), dict(state.drawings),
        )  # fmt: skip

    def done(self, can_undo: int, can_redo: int) -> State:
        """The finished state; the draft must not be changed after."""
        return State(
            marks=MappingProxyType(self.marks), points=MappingProxyType(self.points),
            bars=MappingProxyType(self.bars), lines=MappingProxyType(self.lines), datum=self.datum,
            fiducials=MappingProxyType(self.fiducials), rejected=frozenset(self.rejected),
            renamed=MappingProxyType(self.renamed), parameters=MappingProxyType(self.parameters),
            masks=MappingProxyType(self.masks), drawings=MappingProxyType(self.drawings),
            can_undo=can_undo, can_redo=can_redo,
        )  # fmt: skip

    def drop_points(self, gone: set[str]) -> None:
        """Take points away, and all that names them."""
        self.points = {p: v for p, v in self.points.items() if p not in gone}
        self.marks = {k: m for k, m in self.marks.items() if k[1] not in gone}
        self.bars = {k: b for k, b in self.bars.items() if not gone & set(k)}
        self.lines = {n: line for n, line in self.lines.items() if not gone & set(line.points)}
        if self.datum is not None and gone & set(self.datum.points):
            self.datum = None


class Applicable(Protocol):
    """An action, or undo and redo, as the fold sees them."""

    @property
    def turns(self) -> Literal["", "undo", "redo"]:
        """Whether it moves among the actions before it."""
        ...

    def apply(self, draft: Draft) -> None:
        """Change a draft."""
        ...


@dataclass(slots=True)
class Fold:
    """The actions that count, those taken back, and the state that they make."""

    done: list[Applicable] = field(default_factory=list[Applicable])
    undone: list[Applicable] = field(default_factory=list[Applicable])
    state: State = EMPTY

    def add(self, actions: Iterable[Applicable]) -> None:
        """Fold further actions in; undo and redo with nothing to move do nothing."""
        new: list[Applicable] = []
        afresh = False
        for a in actions:
            if a.turns == "undo":
                if self.done:
                    self.undone.append(self.done.pop())
                    afresh = True
            elif a.turns == "redo":
                if self.undone:
                    again = self.undone.pop()
                    self.done.append(again)
                    new.append(again)
            else:
                self.done.append(a)
                self.undone.clear()
                new.append(a)
        draft = Draft() if afresh else Draft.of(self.state)
        for a in self.done if afresh else new:
            a.apply(draft)
        self.state = draft.done(len(self.done), len(self.undone))


def in_force(actions: Sequence[Applicable]) -> tuple[list[bool], list[int | None]]:
    """Of each action whether it counts, and which one an undo took back or a redo did again, as a position."""
    counts, moved = [False] * len(actions), list[int | None]()
    done, undone = list[int](), list[int]()
    for k, a in enumerate(actions):
        which: int | None = None
        if a.turns == "undo" and done:
            which = done.pop()
            undone.append(which)
        elif a.turns == "redo" and undone:
            which = undone.pop()
            done.append(which)
        elif not a.turns:
            done.append(k)
            undone.clear()
        moved.append(which)
    for k in done:
        counts[k] = True
    return counts, moved


def folded(actions: Iterable[Applicable]) -> State:
    """The state that actions make, from nothing."""
    fold = Fold()
    fold.add(actions)
    return fold.state
