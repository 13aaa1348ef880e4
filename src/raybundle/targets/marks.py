"""Whatever is put up to be measured, under one interface: coded rings, dots, square tags, boards.

A target is named by its family as a user writes it: aicon14, dots, apriltag-36h11, charuco-8x6-5x5_100, chessboard-9x6,
circles-7x5, photomodeler-sheet.  Each module in `kinds` registers how one kind of them is made from its name.
"""

from __future__ import annotations

import difflib
import re
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from importlib import import_module
from typing import Protocol

import numpy as np

from raybundle.errors import InputError, Text, phrase
from raybundle.numerics.arrays import Array, Index, Mask
from raybundle.targets.detect import Polarity


@dataclass(frozen=True, slots=True, kw_only=True)
class Marks:
    """Points of a family measured in one photograph."""

    family: str
    name: tuple[str, ...]
    """(n,) what each point is called, the same in every photograph: "3" the target 3, "17/1" the first corner of tag
    17, "r2c5" the point in row 2, column 5 of a board, counted from 0; "" a dot without a name"""
    xy_px: Array
    """(n, 2) pixel frame; of dots the centre of the ellipse, not the image of their centre"""
    covariance: Array
    """(n, 2, 2) [px^2], from the grey values alone"""
    ellipse: Array
    """(n, 2, 2) C of a dot's edge (x - centre)' C^-1 (x - centre) = 1 [px^2]; NaN for corners"""
    gate: Array
    """(n,) standard deviation of a grey value from the model that was fitted, in units of the contrast"""
    remarks: tuple[str, ...] = ()
    """what was seen and not used, and why"""

    def __len__(self) -> int:
        return len(self.name)

    @property
    def radius_px(self) -> Array:
        """(n,) mean radius of a dot's ellipse; NaN for corners."""
        C = self.ellipse
        return (C[:, 0, 0] * C[:, 1, 1] - C[:, 0, 1] ** 2) ** 0.25

    @property
    def named(self) -> Mask:
        """(n,) whether a point can be distinguished from the others."""
        return np.array([bool(n) for n in self.name], bool)

    def rows(self, chosen: Index | Mask) -> Marks:
        """Some of them."""
        which = np.arange(len(self))[chosen]
        return Marks(
            family=self.family, name=tuple(self.name[i] for i in which), xy_px=self.xy_px[which],
            covariance=self.covariance[which], ellipse=self.ellipse[which], gate=self.gate[which],
            remarks=self.remarks,
        )  # fmt: skip


@dataclass(frozen=True, slots=True, kw_only=True)
class MarkOptions:
    """What holds for all kinds."""

    polarity: Polarity = "both"
    """colour of dots: light on dark, dark on light, both"""
    threads: int = 1


class Target(Protocol):
    """What a family name stands for."""

    @property
    def family(self) -> str:
        """The name as it was given, in lower case."""
        ...

    @property
    def title(self) -> str:
        """For people."""
        ...

    @property
    def objects(self) -> Mapping[str, Array]:
        """Approximate X, Y, Z (3,) of a board's points by name, in units of its spacing; empty for single targets.

        X to the right along a row, Y upwards, Z towards whoever looks at the board.
        """
        ...

    @property
    def turns(self) -> int:
        """Positions of a board that nobody can distinguish: 1 at best.

        With 2 or 4, names may run from another corner in another photograph: such a board must be taken for exact.
        """
        ...

    @property
    def radius(self) -> float:
        """Radius of the dots in units of the spacing, where known; NaN otherwise."""
        ...

    def find(self, image: Array, options: MarkOptions) -> Marks:
        """Points in a photograph (h, w) uint8 or uint16."""
        ...


@dataclass(frozen=True, slots=True, kw_only=True)
class Kind:
    """How names of one kind are written and understood."""

    form: str
    """shown to users: chessboard-COLUMNSxROWS"""
    make: Callable[[str], Target | None]
    """the target of a name in lower case, None where the name is of another kind; raises InputError for a name of
    this kind that cannot be"""
    names: Callable[[str], Sequence[str]]
    """names of this kind that a text, which is none, may stand for: all, or those with the numbers in the text"""


kinds: dict[str, Kind] = {}
ALIKE = 0.6
"""Share of common letters and digits (2 M / T of difflib) from which a text stands for a name, difflib's default"""
MEANT = 4
"""Names that are equally near, at most"""


def register(name: str, kind: Kind) -> None:
    """Make a kind known."""
    kinds[name] = kind


def forms() -> list[str]:
    """How the names of all kinds are written."""
    _load()
    return [kinds[k].form for k in sorted(kinds)]


def target(family: str | Target) -> Target:
    """The target that a family name stands for, or the target itself; raises InputError."""
    if not isinstance(family, str):
        return family
    _load()
    name = family.strip().lower()
    for kind in kinds.values():
        made = kind.make(name)
        if made is not None:
            return made
    near = nearest(name, [n for kind in kinds.values() for n in kind.names(name)])
    raise InputError("target.unknown_family", name=str(family), near=near, n=len(near), known=forms())


def nearest(text: str, names: Sequence[str]) -> list[str]:
    """The names that a text most probably stands for, whatever separates its parts; none where it is like no name."""
    alike = {n: difflib.SequenceMatcher(None, _plain(n), _plain(text)).ratio() for n in names}
    best = max(alike.values(), default=0.0)
    return [n for n, a in alike.items() if a == best][:MEANT] if best >= ALIKE else []


def with_numbers(text: str, form: str) -> list[str]:
    """The name of a board of the form NAME-{}x{} with the two numbers of a text; none where it has others."""
    numbers = re.findall(r"\d+", text)
    return [form.format(*numbers)] if len(numbers) == 2 else []


def _plain(name: str) -> str:
    return re.sub(r"[^a-z0-9]", "", name.lower())


def detect(image: Array, family: str | Target, options: MarkOptions | None = None) -> Marks:
    """Find, name and measure the points of a family in a photograph (h, w) uint8 or uint16."""
    if image.ndim != 2 or str(image.dtype) not in {"uint8", "uint16"}:
        raise InputError("target.image_type", kind=str(image.dtype), shape=image.shape)
    return target(family).find(image, options or MarkOptions())


def no_ellipses(n: int) -> Array:
    """For corners (n, 2, 2)."""
    return np.full((n, 2, 2), np.nan)


def nothing(family: str, *remarks: str) -> Marks:
    """No point found, and why."""
    return Marks(
        family=family, name=(), xy_px=np.zeros((0, 2)), covariance=np.zeros((0, 2, 2)), ellipse=np.zeros((0, 2, 2)),
        gate=np.zeros(0), remarks=remarks,
    )  # fmt: skip


def two_seen(family: str) -> Text:
    """Of a photograph that shows the same board twice."""
    return phrase("target_seen.two_boards", target=family)


def grid_objects(columns: int, rows: int) -> dict[str, Array]:
    """Places of r0c0 .. in units of the spacing: columns to the right, rows downwards."""
    return {f"r{r}c{c}": np.array([c, -r, 0.0]) for r in range(rows) for c in range(columns)}


def _load() -> None:
    import_module("raybundle.targets.kinds")  # registers what it holds
