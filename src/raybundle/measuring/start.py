"""Photographs without orientation that points are measured in: oriented from these points, or what they lack."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field, replace

from raybundle.adjustment.decision.decide import decide
from raybundle.adjustment.records.notice import Notice
from raybundle.adjustment.records.options import AdjustmentOptions
from raybundle.adjustment.result import Adjustment
from raybundle.block import Block
from raybundle.errors import NoOrientation, NotSolvable, Text, as_detail, joined_texts, note, phrase
from raybundle.measuring.film import Scans
from raybundle.measuring.mark_blunders import Wrong, with_wrong_marks, without_wrong_marks, wrong_marks
from raybundle.measuring.merge import Merged, merge
from raybundle.measuring.orienting import unoriented
from raybundle.measuring.session import Session
from raybundle.measuring.state import State
from raybundle.orientation.projective.missing_data import COMMON, KNOWN, Lack

AT_ONCE = 50_000
"""Image observations up to which a block is adjusted anew after every mark."""


@dataclass(frozen=True, slots=True, kw_only=True)
class Standing:
    """How far the photographs are oriented, and what the next ones need."""

    oriented: int
    images: int
    lacking: tuple[Lack, ...] = ()
    wrong: tuple[Wrong, ...] = ()
    unknown: tuple[str, ...] = ()
    """sentences on camera constants that nothing states"""
    film: tuple[str, ...] = ()
    """sentences on fiducial marks"""
    trouble: str = ""
    """why there are no covariances; "" where there are"""

    @property
    def line(self) -> Text:
        """In one line: how many are oriented, and the next step."""
        reported = [note("measuring.oriented", n=self.oriented, of=self.images)]
        if self.lacking:  # the one that needs least comes next
            reported.append(min(self.lacking, key=lambda k: (k.kind == "marks", k.need - k.have)).short)
        return Text.of(*reported).with_text("; ".join(m.text() for m in reported))

    @property
    def words(self) -> tuple[str, ...]:
        """All of it in sentences, the line apart."""
        return (
            *(k.words for k in self.lacking), *(w.words for w in self.wrong), *self.film, *self.unknown,
            *([self.trouble] if self.trouble else []),
        )  # fmt: skip


@dataclass(frozen=True, slots=True, kw_only=True)
class Begun:
    """A block with its marks as far as it can be oriented, adjusted."""

    session: Session
    standing: Standing
    left_out: Mapping[str, str] = field(default_factory=dict[str, str])


def to_begin(block: Block, state: State) -> bool:
    """Whether marks stand in photographs without orientation, or none has one."""
    out = unoriented(block)
    if out.all():
        return True
    names = {name for name, o in zip(block.images.ids, out, strict=True) if o}
    return any(image in names for image, _ in state.marks)


def standing_of(block: Block) -> Standing:
    """How a block stands in which nothing was measured since."""
    out = unoriented(block)
    need = COMMON if out.all() else KNOWN
    names = [name for name, o in zip(block.images.ids, out, strict=True) if o]
    lacking = tuple(Lack(image=name, kind="marks", need=need) for name in names)
    return Standing(oriented=len(out) - len(names), images=len(out), lacking=lacking)


def begun(block: Block, state: State, scans: Scans | None = None) -> Begun:
    """Orient and adjust a block with all that was measured, at once, as far as it goes.

    scans   what is known of the film that photographs are scans of
    raises  InputError as `merge`
    Blunders leave by data snooping, and are named.  Where the points do not determine the interior orientation, it is
    held; where nothing can be adjusted, the photographs stand as the start found them, without covariances.
    """
    made = merge(block, state, scans)
    placed = made.block
    if not placed.images.oriented.any() or not len(placed.observations):
        session = Session.of_block(block, None)
        return Begun(session=session, standing=_standing(made, block, None, ""), left_out=made.left_out)
    if len(placed.observations) > AT_ONCE:
        trouble = phrase("measuring.large_block", n=len(placed.observations))
        session = Session.of_block(placed, None)
        return Begun(session=session, standing=_standing(made, placed, None, trouble), left_out=made.left_out)
    options = AdjustmentOptions(reject="snooping", noise=block.noise or "white", datum_over=block.datum_over or "all")
    try:
        result, held = solved(placed, lambda b: decide(b, options))
    except NotSolvable as error:
        trouble = joined_texts(phrase("measuring.not_adjusted"), Text.of(as_detail(error)))
        session = Session.of_block(placed, None)
        return Begun(session=session, standing=_standing(made, placed, None, trouble), left_out=made.left_out)
    session = Session.of(result)
    trouble = phrase("measuring.interior_held") if held else ""
    session.neglected = trouble or session.neglected
    standing = _standing(made, placed, result, trouble)
    return Begun(session=session, standing=standing, left_out=made.left_out)


def solved(block: Block, adjust: Callable[[Block], Adjustment]) -> tuple[Adjustment, bool]:
    """The adjustment of a block, with its interior orientations held where it is not determined with them.

    raises  NotSolvable of the first try where that does not help
    """
    try:
        return adjust(block), False
    except NotSolvable as error:
        free = [c.id for c in block.cameras if c.estimate and not c.is_scene]
        if not free:
            raise
        held = tuple(replace(c, estimate=()) if c.id in free else c for c in block.cameras)
        try:
            result = adjust(replace(block, cameras=held))
        except NotSolvable:
            raise error from None
    notice = Notice(code="held_not_determinable.cameras", values={"n": len(free)}, ids=tuple(free))
    return replace(result, notices=(notice, *result.notices)), True


def adjusted(made: Merged, adjust: Callable[[Block], Adjustment]) -> Adjustment:
    """The adjustment of a block with its marks; where photographs were oriented by these alone, see `solved`.

    Marks that contradict the others are named, see `with_wrong_marks`.

    raises  NoOrientation that states what the photographs lack where none is oriented; what `adjust` raises
    """
    if made.lacking and not made.block.images.oriented.any() and not len(made.block.observations):
        raise NoOrientation(
            "photograph.none_oriented",
            details=[k.message for k in made.lacking[:20]],
            images={k.image: k.words for k in made.lacking},
        )
    if not made.new:
        return without_wrong_marks(made.block, made.marked, adjust)
    return with_wrong_marks(solved(made.block, adjust)[0], made.marked)


def standing_after(made: Merged, result: Adjustment) -> Standing:
    """How the photographs stand after a block with its marks was adjusted."""
    return _standing(made, made.block, result, "")


def _standing(made: Merged, block: Block, result: Adjustment | None, trouble: str) -> Standing:
    out = unoriented(block)
    return Standing(
        oriented=int((~out).sum()), images=len(out), lacking=made.lacking, unknown=_unknown(made.unknown, result),
        wrong=() if result is None else wrong_marks(result, made.marked), trouble=trouble, film=made.film,
    )  # fmt: skip


def _unknown(cameras: Sequence[str], result: Adjustment | None) -> tuple[str, ...]:
    """What became of camera constants that nothing states."""
    if result is None:
        return ()
    stated: list[str] = []
    for found in result.interior:
        if found.camera not in cameras:
            continue
        camera = next(c for c in result.adjusted.cameras if c.id == found.camera)
        parameter = found.parameters[camera.sensor.scale_symbol]
        c = parameter.value / camera.pixel_mm[0]
        if parameter.std is None or parameter.status in {"held", "not determinable"}:
            stated.append(phrase("measuring.constant_open", camera=camera.id, c_px=c))
        else:
            s = parameter.std / camera.pixel_mm[0]
            stated.append(phrase("measuring.constant_of_points", camera=camera.id, c_px=c, sigma_px=s))
    return tuple(stated)
