"""`raybundle merge`: several projects of one object to one block over their common points."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import MISSING, dataclass, replace
from pathlib import Path
from typing import TYPE_CHECKING, Any

from raybundle.errors import InputError, Message, NotSolvable, as_detail, note
from raybundle.io.folders import check_free
from raybundle.numerics.progress import Progress, silent
from raybundle.settings import Range, keywords, made, setting

if TYPE_CHECKING:
    from raybundle.block import Block
    from raybundle.block.joined import Joined
    from raybundle.commands.merge_tests import Member


@dataclass(frozen=True, slots=True, kw_only=True)
class MergeSettings:
    """What is merged, and how."""

    sources: tuple[Path, ...]
    """results, projects or blocks"""
    out: Path = setting(MISSING, "New block folder.", metavar="BLOCK")
    same_camera: bool = setting(
        False, "Join cameras of one name. Without it, each project keeps its own cameras, as of another day."
    )
    significance: float = setting(
        0.01, "Probability that any unmoved common point is rejected as moved or exchanged.",
        limits=Range(low=1e-6, high=0.5),
    )  # fmt: skip


@keywords(MergeSettings)
def merge_projects(
    sources: Sequence[str | Path], out: str | Path, *, progress: Progress = silent, **settings: Any
) -> Joined:
    """Merge results, projects or blocks of one object into one block folder, which is adjusted as any other.

    sources   folders; points are common by the names that people, codes or tables gave them, dots without a code by
              their place
    out       new block folder
    settings  as of the command line, by the names of `MergeSettings`
    raises    InputError for fewer than three common points without a common datum, given coordinates, scales, cameras
              or places on the earth that contradict each other, a project that is given twice
    Limits: whether common points stayed where they were; `moved_points` does.
    """
    given = {"sources": tuple(Path(s) for s in sources), "out": Path(out), **settings}
    return run_merge(made(MergeSettings, given), progress)


def run_merge(s: MergeSettings, progress: Progress = silent) -> Joined:
    """Merge what the settings ask for, and write it."""
    from raybundle.block.joined import frame_of, join_blocks
    from raybundle.commands.merge_tests import Member, measured_once
    from raybundle.commands.planning.objects import adjusted_block_in
    from raybundle.io.block.folder import write_block
    from raybundle.io.folders import short_names
    from raybundle.workflows.block_frame import in_frame_of

    if len(s.sources) < 2:
        raise InputError("join.one_block")
    check_free(s.out)
    names = short_names(s.sources)
    read: list[tuple[Block, bool]] = []
    for k, source in enumerate(s.sources):
        progress("reading blocks", k / len(s.sources))
        block, raw = adjusted_block_in(source)
        read.append((replace(block, name=names[k]), raw))
    base = read[frame_of([b for b, _ in read])][0]
    placed = [in_frame_of(b, base) for b, _ in read]
    blocks, called, reported = _with_dots_alike([p.block for p in placed], names)
    members = [
        Member(name=name, block=block, source=b if raw else source, brought=p.by, called=c)
        for name, block, (b, raw), source, p, c in zip(names, blocks, read, s.sources, placed, called, strict=True)
    ]
    carriers, remarks, more = _carriers(members, s, progress)
    done = join_blocks(blocks, names, carriers=carriers, same_camera=s.same_camera)
    cautions = measured_once(blocks, names)
    write_block(done.block, s.out)
    progress("writing", 1.0)
    brought = [p.reported for p in placed if p.reported is not None]
    return replace(
        done, remarks=(*done.remarks, *brought, *reported, *remarks), cautions=(*done.cautions, *cautions, *more)
    )


def _with_dots_alike(
    blocks: Sequence[Block], names: Sequence[str]
) -> tuple[list[Block], list[dict[str, str]], list[Message]]:
    """Blocks in which dots without a code are called alike where they are one by their place; what each was called."""
    from raybundle.block.joined import frame_of
    from raybundle.metrology.dots import Dots

    first = frame_of(blocks)
    known = Dots.of(blocks[first].points.ids, blocks[first].points.xyz)
    found, called = list(blocks), [dict[str, str]() for _ in blocks]
    for k, block in enumerate(blocks):
        if k == first:
            continue
        called[k] = known.names(block.points.ids, block.points.xyz)
        ids = tuple(called[k].get(i, i) for i in block.points.ids)
        found[k] = replace(block, points=replace(block.points, ids=ids))
    if not any(called):
        return found, called, []
    rest = sum(len(c) for c in called) - len(known.by_place)
    others = [n for n, c in zip(names, called, strict=True) if c]
    return found, called, [note("join.dots_renumbered", n=len(known.by_place), others=rest, names=others)]


def _carriers(
    members: Sequence[Member], s: MergeSettings, progress: Progress
) -> tuple[list[dict[str, float] | None], list[Message], list[Message]]:
    """For each block the common points that stayed, by the congruence test against the block of the frame.

    Remarks and cautions beside it: about points, scales, frames and cameras of the same id.
    """
    import numpy as np

    from raybundle.block.joined import frame_of
    from raybundle.commands.merge_tests import check_cameras, check_frames, stayed_of

    first = frame_of([m.block for m in members])
    base = members[first]
    found: list[dict[str, float] | None] = [None] * len(members)
    remarks: list[Message] = []
    cautions: list[Message] = []
    try:
        progress("testing common points", 0.0)
        base.shape  # noqa: B018  (adjusted once, for all)
    except (InputError, NotSolvable) as error:
        return found, [note("join.block_not_adjusted", details=[as_detail(error)], name=base.name)], []
    for k, member in enumerate(members):
        if k == first:
            continue
        progress("testing common points", k / len(members))
        if s.same_camera:
            cautions += check_cameras(base, member)
        tested = stayed_of(base, member, s.significance)
        if isinstance(tested, Message):
            remarks.append(tested)
            continue
        std = np.sqrt(np.trace(tested.covariance[0], axis1=1, axis2=2))
        stayed = zip(tested.ids, tested.moved.tolist(), std.tolist(), strict=True)
        carry = {name: sigma**-2 for name, moved, sigma in stayed if not moved}
        found[k] = carry
        cautions += check_frames(base, member, list(carry))
        if tested.after[1] < s.significance:
            remarks.append(note("join.points_beyond_sigma", name=member.name, F=tested.after[0]))
    return found, remarks, cautions
