"""`raybundle merge`: several projects of one object to one block over their common points."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import MISSING, dataclass, replace
from pathlib import Path
from typing import TYPE_CHECKING, Any

from raybundle.errors import InputError, NotSolvable
from raybundle.io.folders import check_free
from raybundle.numerics.counting import counted, counted_are
from raybundle.numerics.progress import Progress, silent
from raybundle.settings import Range, made, setting

if TYPE_CHECKING:
    from raybundle.block import Block
    from raybundle.block.joined import Joined


@dataclass(frozen=True, slots=True, kw_only=True)
class MergeSettings:
    """What is merged, and how."""

    sources: tuple[Path, ...]
    """results, projects or blocks"""
    out: Path = setting(MISSING, "New block folder.", metavar="BLOCK")
    same_camera: bool = setting(
        False, "Cameras of one name are one camera; without it each project keeps its own, as of another day."
    )
    significance: float = setting(
        0.01, "Probability that any common point is called another, or moved, where none is.",
        limits=Range(low=1e-6, high=0.5),
    )  # fmt: skip


def merge_projects(
    sources: Sequence[str | Path], out: str | Path, *, progress: Progress = silent, **settings: Any
) -> Joined:
    """Merge results, projects or blocks of one object into one block folder, which is adjusted as any other.

    sources   folders; points are common by the names that people, codes or tables gave them, dots without a code by
              their place
    out       new block folder
    settings  as of the command line, by the names of `MergeSettings`
    raises    InputError for fewer than three common points without a common datum
    What it does not tell: whether common points stayed where they were; `moved_points` does.
    """
    given = {"sources": tuple(Path(s) for s in sources), "out": Path(out), **settings}
    return run_merge(made(MergeSettings, given), progress)


def run_merge(s: MergeSettings, progress: Progress = silent) -> Joined:
    """Merge what the settings ask for, and write it."""
    from raybundle.block.joined import join_blocks  # noqa: PLC0415  (what computes is loaded after the help)
    from raybundle.commands.planning.objects import adjusted_block_in  # noqa: PLC0415
    from raybundle.io.block.folder import write_block  # noqa: PLC0415
    from raybundle.io.folders import short_names  # noqa: PLC0415

    check_free(s.out)
    blocks: list[Block] = []
    tested: list[Block | Path] = []
    for k, source in enumerate(s.sources):
        progress("reading blocks", k / len(s.sources))
        block, raw = adjusted_block_in(source)
        blocks.append(block)
        tested.append(block if raw else source)
    names = short_names(s.sources)
    blocks, called, told = _with_dots_alike(blocks, names)
    carriers, remarks = _carriers(tested, blocks, names, s.significance, progress, called)
    done = join_blocks(blocks, names, carriers=carriers, same_camera=s.same_camera)
    write_block(done.block, s.out)
    progress("writing", 1.0)
    return replace(done, remarks=(*done.remarks, *told, *remarks))


def _with_dots_alike(
    blocks: Sequence[Block], names: Sequence[str]
) -> tuple[list[Block], list[dict[str, str]], list[str]]:
    """Blocks in which dots without a code are called alike where they are one by their place; what each was called."""
    from raybundle.block.joined import frame_of  # noqa: PLC0415
    from raybundle.metrology.dots import Dots  # noqa: PLC0415

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
    one = counted_are(len(known.by_place), "dot")
    rest = counted(sum(len(c) for c in called) - len(known.by_place), "other")
    whose = ", ".join(n for n, c in zip(names, called, strict=True) if c)
    told = (
        f"dots without a code are numbered anew in each measurement: {one} the same by their place, {rest} of {whose} "
    )
    return found, called, [told + "got new numbers"]


def _carriers(
    sources: Sequence[Block | Path], blocks: Sequence[Block], names: Sequence[str], significance: float,
    progress: Progress, called: Sequence[Mapping[str, str]],
) -> tuple[list[dict[str, float] | None], list[str]]:  # fmt: skip
    """For each block the common points that stayed, by the congruence test against the block of the frame."""
    import numpy as np  # noqa: PLC0415

    from raybundle.block.joined import frame_of  # noqa: PLC0415
    from raybundle.measuring.point_sets import point_set  # noqa: PLC0415
    from raybundle.measuring.session import adjusted_as_free  # noqa: PLC0415
    from raybundle.metrology.congruence import LEAST, congruence  # noqa: PLC0415

    first = frame_of(blocks)
    found: list[dict[str, float] | None] = [None] * len(blocks)
    remarks: list[str] = []
    try:
        progress("testing common points", 0.0)
        base = point_set(adjusted_as_free(sources[first]), names[first])
    except (InputError, NotSolvable) as error:
        return found, [f"common points were not tested, as {names[first]} cannot be adjusted by itself: {error}"]
    for k, source in enumerate(sources):
        if k == first:
            continue
        progress("testing common points", k / len(sources))
        try:
            mine = point_set(adjusted_as_free(source), names[k])
            mine = replace(mine, ids=tuple(called[k].get(i, i) for i in mine.ids))
            if len(set(mine.ids) & set(base.ids)) < LEAST:
                remarks.append(
                    f"{names[k]} has fewer than {LEAST} points in common with {names[first]}: none is tested"
                )
                continue
            tested = congruence([base, replace(mine, free_scale=True)], significance=significance)
        except (InputError, NotSolvable) as error:
            remarks.append(f"common points of {names[k]} were not tested: {error}")
            continue
        std = np.sqrt(np.trace(tested.covariance[0], axis1=1, axis2=2))
        stayed = zip(tested.ids, tested.moved.tolist(), std.tolist(), strict=True)
        found[k] = {name: std**-2 for name, moved, std in stayed if not moved}
        if 2 * int(tested.moved.sum()) > len(tested.ids):
            raise InputError(
                f"{int(tested.moved.sum())} of {len(tested.ids)} points that {names[k]} and {names[first]} call alike "
                "are not one point: are the names those of another object, or exchanged?"
            )
        if tested.after[1] < significance:
            remarks.append(
                f"common points of {names[k]} that stayed differ by more than their standard deviations say (F "
                f"{tested.after[0]:.3g}): these are too small, or many points moved a little"
            )
    return found, remarks
