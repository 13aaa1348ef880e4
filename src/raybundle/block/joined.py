"""Blocks of one object in frames of their own, brought together over the points that they have in common.

Common points are those of one name that a person, a code or a table gave: numbers that matching gives to tie points
mean nothing in another block.
"""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace

import numpy as np

from raybundle.block.block import Block, Points
from raybundle.block.merge import PER_M, merge_blocks
from raybundle.block.points import automatic, automatic_name, automatic_number
from raybundle.block.transform import transform_block
from raybundle.errors import InputError, Message, Severity, Value, note, warning
from raybundle.numerics.arrays import Array, Index, Mask
from raybundle.numerics.transform import SimilarityTransform, similarity

FEWEST = 3
"""Common points that a similarity needs."""
CONTRADICTS = 5.0
"""Standard deviations of the difference from which on two coordinates of a control point are not the same"""
TILT = 1e-6
"""Sine of the angle from which on what was levelled is tilted."""


@dataclass(frozen=True, slots=True, kw_only=True)
class Joint:
    """How a block was brought to the first."""

    name: str
    common: tuple[str, ...]
    """Points that carry it"""
    apart: tuple[tuple[str, float], ...]
    """Points of one name that are not one point, and how far they lie from each other [length unit of the first]"""
    transform: SimilarityTransform | None
    """None: it stands in the same frame already"""
    rms: float
    """Of a coordinate of the points that carry it, by their weights, afterwards [length unit of the first]"""


@dataclass(frozen=True, slots=True, kw_only=True)
class Joined:
    """Several blocks as one."""

    block: Block
    first: str
    """The block whose frame all stand in"""
    joints: tuple[Joint, ...]
    remarks: tuple[Message, ...]
    cautions: tuple[Message, ...] = ()
    """What may make the adjustment of the block wrong"""


def fixed(block: Block) -> int:
    """2: control or positions fix the frame; 1: the scale is known; 0: neither."""
    if block.points.is_control.any() or len(block.stations) or block.place is not None:
        return 2
    return 0 if block.free_scale else 1


def in_own_frame(block: Block) -> Array:
    """(p, 3) coordinates of the points in the frame of the block; NaN where there are none.

    Check points of a block that nothing fixes are given in another frame, that of who surveyed them.
    """
    return block.points.xyz if fixed(block) == 2 else np.where(block.points.is_check, np.nan, block.points.xyz)


def frame_of(blocks: Sequence[Block]) -> int:
    """Which of several blocks gives the frame: the first that control or positions fix, else of a known scale."""
    return max(range(len(blocks)), key=lambda k: (fixed(blocks[k]), -k))


def join_blocks(
    blocks: Sequence[Block], names: Sequence[str], *, carriers: Sequence[Mapping[str, float] | None] = (),
    same_camera: bool = False,
) -> Joined:  # fmt: skip
    """One block of several that see the same named points, each in a frame of its own.

    blocks       with coordinates of the common points, as results have
    names        of the blocks, for messages and for what has to be renamed
    carriers     for each block, common points that are one point here and in the block of the frame, with the weights
                 by which they carry the joint; others of the same name keep apart.  None: all of them, weighted alike
    same_camera  cameras of one id are one camera, with the values of the first block; otherwise each block has its own
    raises       InputError for blocks with fewer than three common points, or levelled ones that would be tilted

    The frame is that of `frame_of`.  Coordinates of the others are approximate values afterwards, the adjustment of
    what comes out has the rest to say.
    Blocks that control, positions or a place on the earth fix stand in one frame already.  Given coordinates of control
    and check points are of the frame in which they were surveyed: they stay as they are.
    Limits: whether points of one name are one point (`raybundle.metrology.congruence`).
    """
    if len(blocks) < 2:
        raise InputError("join.one_block")
    first = frame_of(blocks)
    order = [first, *(k for k in range(len(blocks)) if k != first)]
    base, joints, remarks = blocks[first], list[Joint](), list[Message]()
    if first != 0:
        values: dict[str, Value] = {"name": names[first], "control": fixed(base) == 2}
        remarks.append(Message(code="join.frame_of", severity=Severity.NOTE, values=values))
    taken = replace(base, name=names[first])
    for k in order[1:]:
        block, joint, reported = _brought(
            blocks[k], taken, names[k], carriers[k] if carriers else None, same_camera=same_camera
        )
        taken = merge_blocks(
            [taken, block],
            prefer={"block": 0, "camera": 0, "instrument": 0, "point": 0, "observation": 0},
        )
        joints.append(joint)
        remarks += reported
    name = " + ".join(names)
    return Joined(block=replace(taken, name=name), first=names[first], joints=tuple(joints), remarks=tuple(remarks))


def _brought(
    block: Block, base: Block, name: str, carriers: Mapping[str, float] | None, *, same_camera: bool
) -> tuple[Block, Joint, list[Message]]:
    """A block in the frame of another, nothing in it called as something else there."""
    common = _common(block, base)
    mine, theirs = _rows(block, common), _rows(base, common)
    source, target = in_own_frame(block)[mine], in_own_frame(base)[theirs]
    known: Mask = np.asarray(np.isfinite(source).all(axis=1) & np.isfinite(target).all(axis=1), bool)
    weight = np.array([1.0 if carriers is None else carriers.get(c, 0.0) for c in common])
    kept: list[bool] = [w > 0 for w in weight.tolist()]
    fits: Mask = np.asarray((weight > 0) & known, bool)
    transform: SimilarityTransform | None = None
    _check_given(block, base, [c for c, k in zip(common, kept, strict=True) if k], name)
    if fixed(block) == 2 and fixed(base) == 2:
        distance = np.linalg.norm(PER_M[base.length_unit] / PER_M[block.length_unit] * source - target, axis=1)
    else:
        if fits.sum() < FEWEST:
            few = [c for c, k in zip(common, known.tolist(), strict=True) if k][:5]
            raise InputError(
                "join.too_few_common", name=name, base=base.name, n=int(fits.sum()), points=few, least=FEWEST
            )
        transform = similarity(source[fits], target[fits], weight[fits])
        distance = np.linalg.norm(transform.points(source) - target, axis=1)
        block = _moved(block, transform, base, name)
    apart = tuple((c, float(d)) for c, d, f in zip(common, distance.tolist(), kept, strict=True) if not f)
    carry = tuple(c for c, f in zip(common, kept, strict=True) if f)
    remarks: list[Message] = []
    block = _renamed(block, base, name, {c for c, _ in apart}, same_camera=same_camera, remarks=remarks)
    mean = np.average(distance[fits] ** 2, weights=weight[fits]) / 3 if fits.any() else np.nan
    return block, Joint(name=name, common=carry, apart=apart, transform=transform, rms=float(np.sqrt(mean))), remarks


def _check_given(block: Block, base: Block, common: Sequence[str], name: str) -> None:
    """Raise InputError where coordinates that are given for points of two blocks contradict each other."""
    factor = PER_M[base.length_unit] / PER_M[block.length_unit]
    i, j = _rows(block, common), _rows(base, common)
    both = _given(block.points)[i] & _given(base.points)[j]
    d = np.abs(factor * block.points.xyz[i] - base.points.xyz[j])
    s = np.hypot(factor * block.points.sigma[i], base.points.sigma[j])
    limit = CONTRADICTS * s + 1e-9 * np.abs(base.points.xyz[j]) + 1e-9
    with np.errstate(invalid="ignore"):
        ratio = np.where(both, d / limit, 0.0)
    count = int((ratio > 1).any(axis=1).sum())
    if not count:
        return
    k, axis = divmod(int(ratio.argmax()), 3)
    raise InputError(
        "join.control_contradicts",
        point=common[k],
        name=name,
        base=base.name,
        others=count - 1,
        apart=float(d[k, axis]),
        limit=float(limit[k, axis]),
        unit=base.length_unit,
    )


def _rows(block: Block, points: Sequence[str]) -> Index:
    at = {name: k for k, name in enumerate(block.points.ids)}
    return np.array([at[name] for name in points], np.int64)


def _given(points: Points) -> Mask:
    """(p, 3) coordinates of control and check points that are given with their standard deviations."""
    return np.asarray((points.is_control | points.is_check) & np.isfinite(points.sigma), bool)


def _common(block: Block, base: Block) -> list[str]:
    """Names of the points that both have, with coordinates, and that no program made up."""
    named: Mask = np.asarray(~automatic(block.points.ids) & np.isfinite(block.points.xyz).any(axis=1), bool)
    placed: Mask = np.asarray(np.isfinite(base.points.xyz).any(axis=1), bool)
    known = {n for k, n in enumerate(base.points.ids) if placed[k]}
    return [n for k, n in enumerate(block.points.ids) if named[k] and n in known]


def _moved(block: Block, by: SimilarityTransform, base: Block, name: str) -> Block:
    """A free block in the frame of another; what it observed stays, lengths in the unit of the other."""
    tilt = float(np.linalg.norm(by.rotation[:2, 2]))
    levelled = [t.name for t in block.tables.values() if t.upright and len(t)]
    if levelled and tilt > TILT:
        raise InputError(
            "join.vertical_tilted",
            name=name,
            tables=levelled,
            base=base.name,
            tilt_deg=np.degrees(np.arcsin(min(tilt, 1.0))),
        )
    factor = PER_M[base.length_unit] / PER_M[block.length_unit]
    if factor != 1:
        unit = SimilarityTransform(scale=factor)
        block = replace(transform_block(block, unit, observed="follow"), length_unit=base.length_unit)
        by = SimilarityTransform(scale=by.scale / factor, rotation=by.rotation, translation=by.translation)
    moved = transform_block(block, by, observed="stay")
    xyz = np.where(block.points.is_check, block.points.xyz, moved.points.xyz)
    return replace(moved, points=replace(moved.points, xyz=xyz), free_scale=base.free_scale)


def _renamed(
    block: Block, base: Block, name: str, apart: set[str], *, same_camera: bool, remarks: list[Message]
) -> Block:
    """A block in which nothing but common points, and cameras where they are the same, is called as in another."""
    free = 1 + max((automatic_number(n) for n in base.points.ids), default=-1)
    points: dict[str, str] = {}
    for n in block.points.ids:
        if automatic_number(n) >= 0:
            points[n] = automatic_name(free)
            free += 1
        elif n in apart:
            points[n] = _new(n, name, base.points.ids)
    images = {n: _new(n, name, base.images.ids) for n in block.images.ids if n in base.images.ids}
    taken = {c.id: (c.width_px, c.height_px, c.model) for c in base.cameras}
    cameras: dict[str, str] = {}
    if same_camera:
        for c in block.cameras:
            if taken.get(c.id, (c.width_px, c.height_px, c.model)) != (c.width_px, c.height_px, c.model):
                raise InputError(
                    "join.cameras_differ",
                    camera=c.id,
                    name=name,
                    model=c.model,
                    width_px=c.width_px,
                    height_px=c.height_px,
                    other_model=taken[c.id][2],
                    other_width_px=taken[c.id][0],
                    other_height_px=taken[c.id][1],
                )
    else:
        cameras = {c.id: _new(c.id, name, list(taken)) for c in block.cameras if c.id in taken}
    if images:
        values: dict[str, Value] = {"n": len(images), "name": name, "example": next(iter(images.values()))}
        remarks.append(Message(code="join.images_renamed", severity=Severity.NOTE, values=values))
    if cameras:
        values = {"n": len(cameras), "name": name, "ids": list(cameras), "renamed": list(cameras.values())}
        remarks.append(Message(code="join.cameras_renamed", severity=Severity.NOTE, values=values))
    return replace(
        block,
        points=replace(block.points, ids=tuple(points.get(n, n) for n in block.points.ids)),
        images=replace(block.images, ids=tuple(images.get(n, n) for n in block.images.ids)),
        cameras=tuple(replace(c, id=cameras.get(c.id, c.id)) for c in block.cameras),
        rejected=tuple((images.get(i, i), points.get(p, p)) for i, p in block.rejected),
    )


def _new(old: str, block: str, taken: Sequence[str]) -> str:
    """A name after its block that nothing has."""
    found, k = f"{block}:{old}", 2
    while found in taken:
        found, k = f"{block}-{k}:{old}", k + 1
    return found


def joint_messages(joint: Joint, unit: str) -> list[Message]:
    """How a block came into the common frame, and its points that lie apart from those of the same name."""
    scale = math.nan if joint.transform is None else joint.transform.scale
    frame = "same" if joint.transform is None else "moved"
    n = len(joint.common)
    found = [note("join.block", name=joint.name, frame=frame, n=n, scale=scale, rms=joint.rms, unit=unit)]
    if joint.apart:
        names, distances = [p for p, _ in joint.apart], [float(d) for _, d in joint.apart]
        found.append(warning(
            "join.points_apart", name=joint.name, n=len(names), points=names, distances=distances, unit=unit
        ))  # fmt: skip
    return found
