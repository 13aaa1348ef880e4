"""Networks in a store: cut from columns, a product for each part, never in memory as a whole."""

from __future__ import annotations

import hashlib
import tempfile
from collections.abc import Mapping, Sequence
from dataclasses import replace
from itertools import pairwise
from pathlib import Path

import msgspec
import numpy as np

from raybundle.adjustment.assemble import image_observations
from raybundle.adjustment.options import AdjustmentOptions
from raybundle.block import Block, Observations, Points
from raybundle.blocking.columns import Columns
from raybundle.blocking.cutting import cut_of
from raybundle.blocking.network import LEAF, Network
from raybundle.blocking.part import Part
from raybundle.blocking.skeleton import Skeleton, skeleton_from
from raybundle.blocking.tasks import VERSION, Store
from raybundle.blocking.tree import Tree
from raybundle.io.block.arrays import arrays_of_block, block_of_arrays
from raybundle.numerics.arrays import Array, Index, Mask
from raybundle.pipeline.keys import key_of
from raybundle.pipeline.store import Folder

ROW = np.dtype(
    [("row", "<i8"), ("image", "<i4"), ("point", "<i4"), ("xy_px", "<f8", (2,)), ("cov_px2", "<f8", (3,)),
     ("rejected", "?")],
)  # fmt: skip
"""An image observation on its way to its part."""


def cut_columns(
    columns: Columns, options: AdjustmentOptions, free: Mapping[str, tuple[str, ...]], rejected: Mask, store: Store,
    leaf: int = LEAF, keep: int = 4,
) -> Network:  # fmt: skip
    """Cut a block that is read piece by piece, and keep network and parts.

    rejected  (m,) image observations that take no part
    leaf      unknowns of a leaf at most
    keep      parts that a process holds ready for use
    """
    image, point, content = _incidences(columns)
    taken = np.flatnonzero(~rejected)
    images, points = np.zeros(len(columns.bare.images), bool), np.zeros(columns.points, bool)
    images[image[taken]], points[point[taken]] = True, True
    skeleton = _skeleton(columns, options, free, images, points)
    name = key_of("network", VERSION, content, arrays_of_block(skeleton.block), options, dict(free), leaf, rejected)
    if store.has(name) and all(store.has(k) for k in store.wanted(name, ("parts",))["parts"].tolist() if k):
        return replace(network_of(store, name), keep=keep)
    found = cut_of(skeleton, image[taken], point[taken], leaf)
    at = np.full(len(image), -1, np.int32)
    at[taken] = found.at
    # what is rejected goes with its object point: it may return
    of_point = np.full(columns.points, -1, np.int32)
    of_point[point[taken]] = found.at
    at = np.where(at < 0, of_point[point], at)
    del image, point
    counts = np.bincount(at[at >= 0], minlength=len(found.tree))
    keys = tuple(key_of("part", VERSION, name, t) if counts[t] else "" for t in range(len(found.tree)))
    _keep_parts(columns, rejected, at, keys, store)
    kept = _kept(skeleton, options, free, images, points[skeleton.points], found.tree, found.boundary, counts, keys)
    store.store(name, {**kept, "keep": np.array(keep)})
    return network_of(store, name)


def _incidences(columns: Columns) -> tuple[Index, Index, str]:
    """Image and object point of all image observations, and a hash of all columns."""
    image, point = np.empty(columns.observations, np.int32), np.empty(columns.observations, np.int32)
    content = hashlib.blake2b(digest_size=20)
    for begin, o in columns.pieces_of_observations():
        image[begin : begin + len(o)], point[begin : begin + len(o)] = o.image, o.point
        for values in (o.image.astype(np.int32), o.point.astype(np.int32), o.xy_px, o.cov_px2):
            content.update(np.ascontiguousarray(values).tobytes())
    for _, p in columns.pieces_of_points():
        for values in (np.asarray(p.role, np.int32), p.xyz, p.sigma):
            content.update(np.ascontiguousarray(values).tobytes())
        content.update("\n".join(p.ids).encode("utf-8", "surrogatepass"))
    return image, point, content.hexdigest()


def _skeleton(
    columns: Columns, options: AdjustmentOptions, free: Mapping[str, tuple[str, ...]], images: Mask, points: Mask
) -> Skeleton:
    """The skeleton: of the object points those that observations outside the images name, or that are given."""
    bare = columns.bare
    named = np.zeros(columns.points, bool)
    for table in bare.tables.values():
        named[table.refers("point")] = True
    wanted = set(options.datum_points)
    at, given = list[Index](), list[Points]()
    for begin, p in columns.pieces_of_points():
        mine = named[begin : begin + len(p)] | p.is_control.any(axis=1)
        if wanted:
            mine |= np.array([name in wanted for name in p.ids])
        at.append(begin + np.flatnonzero(mine))
        given.append(p.rows(mine))
    places = np.concatenate(at) if at else np.zeros(0, np.int64)
    new = np.full(columns.points, -1, np.int32)
    new[places] = np.arange(len(places))
    whole = replace(bare, points=given[0].append(*given[1:]) if given else bare.points)
    return skeleton_from(
        whole.of_tables(lambda t: t.renumbered("point", new)), places, columns.points, options, free, images,
        points[places],
    )  # fmt: skip


def _keep_parts(columns: Columns, rejected: Mask, at: Index, keys: Sequence[str], store: Store) -> None:
    """Keep a product for each part: its observations pass through a file each."""
    room = store.path if isinstance(store, Folder) else None
    if room is not None:
        room.mkdir(parents=True, exist_ok=True)
    with tempfile.TemporaryDirectory(dir=room) as folder:
        for begin, o in columns.pieces_of_observations():
            mine = at[begin : begin + len(o)]
            rows = np.empty(len(o), ROW)
            rows["row"], rows["image"], rows["point"] = np.arange(begin, begin + len(o)), o.image, o.point
            rows["xy_px"], rows["cov_px2"] = o.xy_px, o.cov_px2
            rows["rejected"] = rejected[begin : begin + len(o)]
            order = np.argsort(mine, kind="stable")
            bounds = np.searchsorted(mine[order], np.arange(len(keys) + 1))
            for t in np.flatnonzero(np.diff(bounds)).tolist():
                with (Path(folder) / str(t)).open("ab") as file:
                    rows[order[bounds[t] : bounds[t + 1]]].tofile(file)
        for t, key in enumerate(keys):
            if key and not store.has(key):
                store.store(key, _kept_part(columns, np.fromfile(Path(folder) / str(t), ROW)))


def _kept_part(columns: Columns, rows: Array) -> dict[str, Array]:
    """A part as it is kept."""
    rows = rows[np.lexsort((rows["image"], rows["point"]))]
    images, image = np.unique(rows["image"], return_inverse=True)
    points, point = np.unique(rows["point"], return_inverse=True)
    bare = columns.bare
    block = replace(
        bare, images=bare.images.rows(images), points=columns.points_at(points), tables={},
        observations=Observations(
            image=image.astype(np.int32), point=point.astype(np.int32), xy_px=np.ascontiguousarray(rows["xy_px"]),
            cov_px2=np.ascontiguousarray(rows["cov_px2"]),
        ),
    )  # fmt: skip
    xy, whiten, _ = image_observations(block, np.arange(len(rows)))
    own = {
        "images": images, "points": points, "rows": rows["row"].copy(), "rejected": rows["rejected"].copy(),
        "xy_mm": xy, "whiten": whiten,
    }  # fmt: skip
    return {**{f"block.{name}": values for name, values in arrays_of_block(block).items()}, **own}


def _part_of(found: Mapping[str, Array]) -> tuple[Part, Mask]:
    part = Part(
        block=_block(found), images=found["images"], points=found["points"], rows=found["rows"],
        measured=(found["xy_mm"], found["whiten"]),
    )  # fmt: skip
    return part, found["rejected"].astype(bool)


def _block(found: Mapping[str, Array]) -> Block:
    return block_of_arrays({n.removeprefix("block."): v for n, v in found.items() if n.startswith("block.")})


def _lists(name: str, lists: Sequence[Index]) -> dict[str, Array]:
    """Lists of positions as one, with where each begins."""
    return {
        name: np.concatenate([np.zeros(0, np.int64), *lists]).astype(np.int32),
        f"{name}.first": np.concatenate([[0], np.cumsum([len(x) for x in lists])]).astype(np.int64),
    }


def _from_lists(name: str, found: Mapping[str, Array]) -> tuple[Index, ...]:
    values, first = found[name], found[f"{name}.first"].tolist()
    return tuple(values[a:b] for a, b in pairwise(first))


def _kept(
    skeleton: Skeleton, options: AdjustmentOptions, free: Mapping[str, tuple[str, ...]], images: Mask, points: Mask,
    tree: Tree, boundary: Sequence[Index], counts: Index, keys: Sequence[str],
) -> dict[str, Array]:  # fmt: skip
    """A network as it is kept, without its parts."""
    return {
        **{f"block.{name}": values for name, values in arrays_of_block(skeleton.block).items()},
        **_lists("own", tree.own), **_lists("boundary", boundary), "parent": tree.parent, "level": tree.level,
        "points": skeleton.points, "count": np.array(skeleton.count), "images used": images, "points used": points,
        "shift": skeleton.system.shift, "counts": counts, "parts": np.array(keys, np.str_),
        "options": np.array(msgspec.json.encode(options).decode()),
        "free": np.array(msgspec.json.encode(dict(free)).decode()),
    }  # fmt: skip


def network_of(store: Store, key: str) -> Network:
    """A network that was kept."""
    found = store.wanted(key)
    options = msgspec.json.decode(str(found["options"]), type=AdjustmentOptions)
    free = msgspec.json.decode(str(found["free"]), type=dict[str, tuple[str, ...]])
    skeleton = skeleton_from(
        _block(found), found["points"], int(found["count"]), options, free, found["images used"],
        found["points used"], found["shift"],
    )  # fmt: skip
    parts = tuple(found["parts"].tolist())
    return Network(
        key=key, skeleton=skeleton, boundary=_from_lists("boundary", found), counts=found["counts"],
        tree=Tree(own=_from_lists("own", found), parent=found["parent"], level=found["level"]),
        part=lambda t: _part_of(store.lent(parts[t])), keep=int(found["keep"]),
    )  # fmt: skip
