"""What a kind of observation is: its table, what takes part, what it would be at given values, and its words.

An adjustment asks each kind for its rows and, at the values of an iteration, for residuals and partial derivatives by
*parameter blocks*: coordinates of an object point, centre and rotation of an image, parameters of an interior
orientation.  Which unknowns these are, or whether they are held, is the adjustment's affair.
"""

from __future__ import annotations

from abc import ABC, abstractmethod
from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass, field, replace
from typing import Any, ClassVar, Literal, Protocol, TypeVar

import numpy as np

from raybundle.numerics.arrays import Array, Index, Mask
from raybundle.observations.table import Table

T = TypeVar("T")
Of = Literal["point", "centre", "rotation", "interior", "own"]
"""Parameter blocks: coordinates of object points, centres, small rotations and interior orientations of images, and
unknowns that a kind of observation has for itself.

A small rotation d of an image is about its own axes: R_new = exp([d]x) R.
"""


class Values(Protocol):
    """The values of an iteration, lengths in the frame shifted by `Scope.shift`."""

    rotation: Array
    """(n, 3, 3) object axes to image axes"""
    centre: Array
    """(n, 3)"""
    interior: Array
    """(q, k) parameters of each interior orientation, in the order of its model"""
    xyz: Array
    """(p, 3)"""
    own: Mapping[str, Array]
    """Kind -> (count, w) values of its own unknowns"""


@dataclass(frozen=True, slots=True, kw_only=True)
class Interior:
    """The parameters of an interior orientation, or of an instrument, as observations see them."""

    key: str
    """Camera id, or camera id / image id; of an instrument its id."""
    camera: int
    """Position in the block's cameras; -1: of an instrument."""
    instrument: int = -1
    """Position in the block's instruments; -1: of a camera."""
    image: int = -1
    """Position of the image whose own parameters these are; -1: those that images share"""
    symbols: tuple[str, ...]
    free: tuple[int, ...]
    """Positions of the free parameters; () where nothing is adjusted."""
    given: Mapping[str, float] = field(default_factory=dict[str, float])
    """Values that were given."""
    sigma: Mapping[str, float] = field(default_factory=dict[str, float])
    """Symbols whose given values are observed."""
    calibrated: Any = None
    """`raybundle.observations.parameter.Calibrated`: parameters that are observed together"""
    relations: tuple[Any, ...] = ()
    """`raybundle.observations.relation.Relation`s"""


@dataclass(frozen=True, slots=True, kw_only=True)
class Scope:
    """What of a block takes part in an adjustment, as far as observations outside the images ask."""

    point_ids: tuple[str, ...]
    image_ids: tuple[str, ...]
    points: Mask
    """(p,) that take part"""
    images: Mask
    """(n,) that take part and whose exterior orientation is free"""
    xyz: Array
    """(p, 3) given coordinates"""
    sigma: Array
    """(p, 3) of the given coordinates"""
    coordinates: Mask
    """(p, 3) given coordinates that are observed here; those of eliminated points go with the points"""
    shift: Array
    """(3,) origin of the frame in which values stand"""
    interior: tuple[Interior, ...]
    datum_is_chosen: bool = False
    """Whether the datum is free by choice, so that nothing is observed that would carry it."""

    def parameters_of(self, instruments: Index) -> Index:
        """Positions in `interior` of instruments, given theirs in the block; -1: none."""
        at = {i.instrument: r for r, i in enumerate(self.interior) if i.instrument >= 0}
        return np.array([at.get(c, -1) for c in np.asarray(instruments).tolist()], np.int32)


@dataclass(frozen=True, slots=True)
class Joint:
    """Rows that are correlated with each other."""

    rows: Index
    """(j,) positions among the kind's `Rows`, ascending"""
    correlation: Array
    """(j, j) positive definite; with the standard deviations of the rows their covariance"""


@dataclass(frozen=True, slots=True, kw_only=True)
class Rows:
    """Observed quantities, one number each."""

    item: Index
    """(k,) row of the table"""
    component: Index
    """(k,) which quantity of the row"""
    value: Array
    """(k,) observed, in the frame of the values"""
    sigma: Array
    """(k,)"""
    offset: Array
    """(k,) what the frame's shift has taken from `value`"""
    joint: tuple[Joint, ...] = ()
    """Which are correlated; no row stands in two of them, and rows in none are independent of all"""

    @classmethod
    def of(
        cls, item: Any, component: Any, value: Any, sigma: Any, offset: Any = None, *, joint: tuple[Joint, ...] = ()
    ) -> Rows:
        """Of arrays or lists."""
        value = np.asarray(value, float)
        return cls(
            item=np.asarray(item, np.int32),
            component=np.asarray(component, np.int32),
            value=value,
            sigma=np.asarray(sigma, float),
            offset=np.zeros(len(value)) if offset is None else np.asarray(offset, float),
            joint=joint,
        )

    def __len__(self) -> int:
        return len(self.value)


@dataclass(frozen=True, slots=True)
class Partials:
    """Partial derivatives of observed quantities by single numbers of parameter blocks."""

    of: Of
    row: Index
    """(e,) position among the kind's `Rows`"""
    item: Index
    """(e,) object point, image, position in `Scope.interior` or among the kind's own"""
    component: Index
    """(e,) coordinate, axis of rotation, position of the parameter, or unknown of the kind's own"""
    value: Array
    """(e,)"""


@dataclass(frozen=True, slots=True)
class Observed:
    """What a kind's rows are at given values."""

    residual: Array
    """(k,) adjusted - observed"""
    partials: tuple[Partials, ...]


@dataclass(frozen=True, slots=True)
class Named:
    """What a kind's rows are called in results."""

    ids: tuple[str, ...]
    component: tuple[str, ...]
    origin: tuple[str, ...] = ()


class ObservationKind(ABC):
    """One kind of observation outside the images; a subclass registers itself."""

    registry: ClassVar[dict[str, ObservationKind]] = {}

    name: ClassVar[str]
    """In results: the kind of a group of observations"""
    group: ClassVar[str]
    """Plural: the group of a variance component"""
    order: ClassVar[int]
    """In which reports and result files list the kinds"""
    unit: ClassVar[Literal["length", "angle", "own"]]
    """Of the observed quantities: that of the object, rad, or one for each row (that of a parameter)"""
    title: ClassVar[str]
    """Heading of its table in a report"""
    object: ClassVar[str]
    """What the ids of its rows name: "point", "image", "from–to" """
    noun: ClassVar[str] = ""
    """One row of its table, as people count them; "" where they are not counted"""
    quantities: ClassVar[str]
    """Its observed quantities, in the plural"""
    components: ClassVar[tuple[str, ...]] = ("",)
    """What stands behind v, r and w in the columns of a result's table, for each of the quantities of a row"""
    table: ClassVar[type[Table] | None] = None
    """Of its own in a block, with a field `sigma`; None: it observes what other tables of the block hold"""
    carries_datum: ClassVar[bool] = False
    """Whether it shows where or how the object lies in its frame; left out where the datum is chosen freely."""
    carries_points: ClassVar[bool] = False
    """Whether object points take part by its rows alone, without a ray: the set-ups of a total station"""
    fixes_scale: ClassVar[bool] = False
    """Whether one of its rows alone determines the scale, wherever it stands."""
    needs_scale: ClassVar[bool] = False
    """Whether its standard deviations mean nothing where nothing fixes the scale: a smaller object would fit better"""
    left_open: ClassVar[str] = ""
    """Code of the message where it leaves the datum open although it carries it: unknowns of its own"""
    hides: ClassVar[tuple[int, ...]] = (0, 1, 2, 3, 4, 5, 6)
    """Which of the datum's parameters (position, rotation, scale) those unknowns may hide"""

    @property
    def key(self) -> str:
        """Its group as messages have it, without blanks."""
        return self.group.replace(" ", "_")

    def __init_subclass__(cls, *, registered: bool = True) -> None:
        super().__init_subclass__()
        if not registered:
            return
        made = cls()
        if made.name in ObservationKind.registry:
            raise TypeError(f"two kinds of observations are called {made.name}")
        if made.table is not None and made.table.name in {k.table.name for k in in_order() if k.table is not None}:
            raise TypeError(f"{made.name}: another kind of observations has a table called {made.table.name}")
        ObservationKind.registry[made.name] = made

    @classmethod
    def table_of(cls, block: Any) -> Any:
        """Its table in a block; None where it has none of its own."""
        return None if cls.table is None else block.table(cls.table)

    def check(self, table: Any, scope: Scope) -> None:  # noqa: B027  (most have nothing to check)
        """Raise InputError where rows cannot be adjusted, whatever the values."""

    def points(self, table: Any, scope: Scope) -> Index:
        """Object points that its rows touch beside image observations: they cannot be eliminated one by one."""
        return np.zeros(0, np.int32)

    def instruments(self, table: Any, scope: Scope) -> set[int]:
        """Instruments (antennas, IMUs) whose parameters its rows touch."""
        return set()

    own_width: ClassVar[int] = 0
    """Unknowns that each thing of its own has: a plane's inclination and distance"""

    def own(self, table: Any, scope: Scope) -> tuple[str, ...]:
        """Names of the things that have unknowns of its own."""
        return ()

    def own_start(self, table: Any, scope: Scope) -> Array:
        """Approximate values (count, w) of them."""
        return np.zeros((0, 1))

    def own_moved(self, values: Array, step: Array) -> Array:
        """The values (count, w) after a step (count, `own_width`)."""
        return values + step

    def own_placed(self, values: Array, scale: float, R: Array, t: Array) -> Array:
        """The values (count, w) in the frame of scale R X + t."""
        return values

    def own_generators(self, values: Array, centre: Array) -> Array:
        """How its unknowns follow shifts, rotations about `centre` and scale of the frame: (count, `own_width`, 7)."""
        return np.zeros((len(values), self.own_width, 7))

    @abstractmethod
    def rows(self, table: Any, scope: Scope) -> Rows:
        """The observed quantities that take part.

        raises  InputError where one cannot
        """

    @abstractmethod
    def observed(self, table: Any, rows: Rows, scope: Scope, values: Values) -> Observed:
        """Residuals and partial derivatives at these values."""

    def places(self, table: Any, rows: Rows, scope: Scope, values: Values) -> Array | None:
        """(k, 3) where the one point of each row would lie if the row had no residual; None: where it lies.

        Residuals of an item that turn with the object (distances in X and Y from a plumb line) change each by a turn,
        and their sum of squares not at all: they do not show it, however large they are.
        """
        return None

    @abstractmethod
    def named(self, table: Any, rows: Rows, scope: Scope) -> Named:
        """Names of the rows and of their quantities."""

    def weighted(self, block: Any, factor: float) -> Any:
        """The block with its standard deviations multiplied."""
        table = self.table_of(block)
        return block.having(replace(table, sigma=factor * table.sigma))


def partials(of: Of, row: Array, item: Array, component: Array | int, value: Array) -> Partials:
    """Partials of arrays that are broadcast against `row`."""
    shape = np.shape(row)
    component, value = (
        given if given.shape == shape else np.full(shape, given)
        for given in (np.asarray(component, np.int32), np.asarray(value, float))
    )
    return Partials(of, np.asarray(row, np.int32), np.asarray(item, np.int32), component, value)


def in_order() -> list[ObservationKind]:
    """All kinds, in their order."""
    return sorted(ObservationKind.registry.values(), key=lambda kind: kind.order)


class OfKinds(Mapping[str, T]):
    """A mapping that follows from the kinds that are registered: made anew where these have changed.

    A kind of one's own may be imported before or after the modules that read, adjust and report.
    """

    def __init__(self, made: Callable[[], Mapping[str, T]]) -> None:
        """Of what makes it from the kinds that there are."""
        self._made = made
        self._of: tuple[ObservationKind, ...] = ()
        self._held: Mapping[str, T] = {}

    def _now(self) -> Mapping[str, T]:
        kinds = tuple(ObservationKind.registry.values())
        if kinds != self._of:
            self._of, self._held = kinds, self._made()
        return self._held

    def __getitem__(self, name: str) -> T:
        """The entry of a name."""
        return self._now()[name]

    def __iter__(self) -> Iterator[str]:
        """The names, in the order of the kinds."""
        return iter(self._now())

    def __len__(self) -> int:
        """Their number."""
        return len(self._now())
