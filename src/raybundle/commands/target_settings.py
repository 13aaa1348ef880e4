"""Settings of `raybundle targets sheet | choose | detect`, and what designs a sheet; what computes is loaded late."""

from __future__ import annotations

import re
from collections.abc import Sequence
from dataclasses import MISSING, dataclass
from pathlib import Path
from typing import TYPE_CHECKING, Any, Literal

from raybundle.errors import InputError
from raybundle.settings import NOT_NEGATIVE, Range, keywords, made, path_of, setting

if TYPE_CHECKING:
    from raybundle.numerics.arrays import Index
    from raybundle.targets.codes import RingFamily
    from raybundle.targets.layout import Sheet, SheetOptions
    from raybundle.targets.marks import Target
    from raybundle.targets.subsets import Choice

MOST_CODES = 1_000_000
MILLIMETRES = Range(low=0, high=1e5, above=True)
"""A length on a sheet [mm]."""
FAMILY_HELP = (
    "Family of the targets: aicon14, agisoft12, dots, apriltag-36h11, chessboard-9x6 and others (how-to targets)."
)


@dataclass(frozen=True, slots=True, kw_only=True)
class FamilySettings:
    """Which targets."""

    target: str | None = setting(None, FAMILY_HELP, metavar="FAMILY", also=("family",))
    table: Path | None = setting(None, "Table of custom targets: id,code; with {bits}.", metavar="FILE")
    bits: int | None = setting(None, "Number of sectors of the rings of {table}.", limits=Range(low=3, high=24))

    def rings(self) -> RingFamily:
        """The ring family that is named; raises InputError."""
        from raybundle.targets.codes import read_table
        from raybundle.targets.families import families, family_named

        if self.table is not None:
            if self.target is not None or self.bits is None:
                raise InputError("target.table_settings", sheet=False)
            return read_table(self.table, self.bits)
        if self.target is None:
            raise _unnamed(sorted(families))
        return family_named(self.target)

    def wanted(self, *, dots: bool = False) -> Target:
        """The target that is named, with dots beside its rings where that is asked for; raises InputError."""
        from raybundle.targets.kinds.rings import Rings
        from raybundle.targets.marks import forms, target

        if self.target is None and self.table is None:
            raise _unnamed([name for form in forms() for name in re.sub(r" \(.*?\)| and others", "", form).split(", ")])
        by_name = self.target if self.table is None else None
        found = Rings(rings=self.rings()) if by_name is None else target(by_name)
        return Rings(rings=found.rings, dots=True) if dots and isinstance(found, Rings) else found


def _unnamed(known: Sequence[str]) -> InputError:
    return InputError("target.family_missing", known=list(known))


@dataclass(frozen=True, slots=True, kw_only=True)
class SheetSettings(FamilySettings):
    """What is printed on which paper."""

    count: int | None = setting(
        None, "Number of targets, chosen to stay distinct when partly hidden.", limits=Range(low=1)
    )
    codes: str | None = setting(None, "Numbers of the targets, instead of {count}.", metavar="ID,FROM-TO,...")
    spacing: float | None = setting(
        None, "Boards: side of a square, distance of dots. Tags: their side.", limits=MILLIMETRES
    )
    dot_radius: float = setting(5.0, "Radius of the dots.", limits=MILLIMETRES, typed="5mm")
    paper: Literal["A0", "A1", "A2", "A3", "A4"] = setting("A4", "")
    lying: bool = setting(False, "Print with the longer side horizontal.")
    tile: Literal["A1", "A2", "A3", "A4"] | None = setting(
        None, "Cut the sheet into parts for a printer of this paper."
    )
    polarity: Literal["dark", "light"] = setting(
        "dark", "Colour of the targets. dark: black on white. light: white on black."
    )
    out: Path = setting(MISSING, "FILE.pdf or FILE.svg; FILE.toml is written beside it.", metavar="FILE")

    def options(self) -> SheetOptions:
        """What the sheet is drawn with."""
        from raybundle.targets.layout import SheetOptions

        return SheetOptions(
            dot_radius_mm=self.dot_radius, paper=self.paper, orientation="lying" if self.lying else "upright",
            polarity=self.polarity, tile=self.tile or "",
        )  # fmt: skip


@dataclass(frozen=True, slots=True, kw_only=True)
class ChooseSettings(FamilySettings):
    """How many targets of a family are chosen."""

    count: int = setting(MISSING, "", limits=Range(low=1))


@dataclass(frozen=True, slots=True, kw_only=True)
class DetectSettings(FamilySettings):
    """What is looked for in which photographs, and what is written of it."""

    photos: tuple[Path, ...]
    """folders and files"""
    polarity: Literal["both", "dark", "light"] = setting("both", "Colour of the dots.")
    out: Path | None = setting(None, "Table of all detected targets.", metavar="FILE")
    observations: Path | None = setting(None, "Write named points as observations.csv of a block.", metavar="FILE")
    dots: bool = setting(False, "With rings: also detect dots without a ring.")
    overlay: Path | None = setting(None, "Write the photographs with the detected targets drawn in.", metavar="DIR")
    jobs: int = setting(0, "Number of processors; 0: all.", limits=NOT_NEGATIVE)


@keywords(SheetSettings)
def write_target_sheet(target: str | None, out: str | Path, **settings: Any) -> Sheet:
    """Write targets at true size, with a scale bar to verify the printer, and FILE.toml with ids, radii, positions.

    target    family as "aicon14", "chessboard-9x6", "apriltag-36h11"; None with `table` and `bits`
    out       new FILE.pdf or FILE.svg
    settings  as of the command line, by the names of `SheetSettings`: codes="1-50", or count=20; lengths in millimetres
    raises    InputError for what does not go together or does not fit on the paper
    """
    return run_sheet(made(SheetSettings, {"target": target, "out": path_of("out", out), **settings}))[0]


@keywords(ChooseSettings)
def choose_targets(target: str | None = None, *, count: int, **settings: Any) -> Choice:
    """Choose targets that stay distinct when an arc of their ring is hidden.

    target    family of rings, as "aicon14"; None with `table` and `bits`
    raises    InputError for a family of other targets, and for more than there are
    """
    s = made(ChooseSettings, {"target": target, "count": count, **settings})
    return run_choose(s)[0]


def run_choose(settings: ChooseSettings) -> tuple[Choice, RingFamily]:
    """The chosen targets, and the family that they are of."""
    from raybundle.targets.subsets import choose_codes

    family = settings.rings()
    return choose_codes(family, settings.count), family


def run_sheet(settings: SheetSettings) -> tuple[Sheet, Sequence[Path]]:
    """Design and write a sheet; also the files."""
    from raybundle.targets.sheets import write_sheet

    s = settings
    sheet = designed_sheet(s.wanted(), s.count, s.codes, s.spacing, s.options())
    return sheet, write_sheet(sheet, s.out)


def designed_sheet(
    target: Target, count: int | None, codes: str | None, spacing: float | None, options: SheetOptions
) -> Sheet:
    """The sheet of a family; raises InputError where options do not go with it."""
    from raybundle.targets.kinds.rings import Rings
    from raybundle.targets.layout import design
    from raybundle.targets.subsets import choose_codes

    if isinstance(target, Rings) and target.rings is not None:
        if (count is None) == (codes is None):
            raise InputError("option.one_of", first="codes", second="count")
        ids = choose_codes(target.rings, count).ids if count is not None else read_ids(codes or "")
        return design(target.rings, ids, options)
    from raybundle.targets.kinds.tags import Tags
    from raybundle.targets.layout_boards import design_board, design_dots, design_tags

    if spacing is None:
        raise InputError("sheet.spacing_missing", family=target.family)
    if isinstance(target, Tags):
        if codes is None and count is None:
            raise InputError("option.one_of", first="codes", second="count")
        numbers = read_ids(codes).tolist() if codes is not None else list(range(count or 0))
        return design_tags(target, numbers, spacing, options)
    if isinstance(target, Rings):
        if codes is not None:
            raise InputError("sheet.dots_without_numbers")
        return design_dots(spacing, count, options)
    if codes is not None or count is not None:
        raise InputError("sheet.board_without_numbers", family=target.family)
    return design_board(target, spacing, options)


def read_ids(text: str) -> Index:
    """Numbers and ranges, as 1,4,7-12; raises InputError."""
    import numpy as np

    from raybundle.io.reading.words import quoted, whole_of

    ids: list[int] = []
    for word in text.split(","):
        match = re.fullmatch(r"\s*(\d+)(?:\s*-\s*(\d+))?\s*", word)
        if match is None:
            raise InputError("target.code_form", text=text, word=quoted(word))
        first, last = whole_of(match[1]), whole_of(match[2] or match[1])
        if first is None or last is None or last - first > MOST_CODES:
            raise InputError("target.code_range", word=quoted(word), most=MOST_CODES)
        ids += range(first, last + 1)
    if len(set(ids)) < len(ids) or not ids:
        raise InputError("target.code_twice", text=text)
    return np.array(ids)
