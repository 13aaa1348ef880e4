"""Networks in a store: cut from columns, a product for each part, never in memory as a whole."""

from __future__ import annotations

import hashlib
import tempfile
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, replace
from itertools import pairwise
from pathlib import Path

import msgspec
import numpy as np

from raybundle.adjustment.records.options import AdjustmentOptions
from raybundle.adjustment.system.assemble import image_observations
from raybundle.block import Block, Observations, Points
from raybundle.blocking.columns import Columns
from raybundle.blocking.cutting import cut_of
from raybundle.blocking.network import LEAF, Network, parts_ready
from raybundle.blocking.part import Part
from raybundle.blocking.skeleton import Skeleton, skeleton_from
from raybundle.blocking.store import VERSION, Store
from raybundle.blocking.tree import WORTH, Tree
from raybundle.io.block.arrays import arrays_of_block, block_of_arrays
from raybundle.numerics.arrays import Array, Index, Mask
from raybundle.pipeline.keys import key_of
from raybundle.pipeline.store import Folder

ROW = np.dtype(
    [("row", "<i8"), ("image", "<i4"), ("point", "<i4"), ("xy_px", "<f8", (2,)), ("cov_px2", "<f8", (3,)),
     ("rejected", "?")],
)  # fmt: skip
"""An image observation on its way to its part."""


@dataclass(frozen=True, slots=True)
class Cut:
    """A network that is cut, and how its parts come to lie in a store."""

    network: Network
    keep_parts: Callable[[], None]
    """Puts network and parts where tasks find them, if they are not there"""


def cut_columns(
    columns: Columns, options: AdjustmentOptions, free: Mapping[str, tuple[str, ...]], rejected: Mask, store: Store, *,
    leaf: int = LEAF, keep: int = 4, ready: float | None = None, worth: float = WORTH, shift: Array | None = None,
    notes: Store | None = None, number: int = 0,
) -> Cut:  # fmt: skip
    """Cut a block that is read piece by piece.

    rejected  (m,) image observations that take no part
    store     where tasks are to find network and parts
    leaf      unknowns of a leaf at most
    keep      parts that a process holds ready for use
    ready     bytes of parts that a process holds ready for use, in place of `keep`
    worth     as of `tree.dissect`
    shift     (3,) origin of the frame of the values; None: near the middle of the images
    notes     where it stays how the network was cut, for a run that is started again; None: in `store`
    number    of this network, where several of the same content are in use
    """
    notes = store if notes is None else notes
    image, point, content = _incidences(columns)
    taken = np.flatnonzero(~rejected)
    images, points = np.zeros(len(columns.bare.images), bool), np.zeros(columns.points, bool)
    images[image[taken]], points[point[taken]] = True, True
    skeleton = _skeleton(columns, options, free, images, points, shift)
    name = key_of(
        "network", VERSION, content, arrays_of_block(skeleton.block), options, dict(free), leaf, worth, rejected,
        skeleton.system.shift, number,
    )  # fmt: skip
    if not notes.has(name):
        found = cut_of(skeleton, image[taken], point[taken], leaf, worth)
        at = np.full(len(image), -1, np.int32)
        at[taken] = found.at
        # what is rejected goes with its object point: it may return
        of_point = np.full(columns.points, -1, np.int32)
        of_point[point[taken]] = found.at
        at = np.where(at < 0, of_point[point], at)
        counts = np.bincount(at[at >= 0], minlength=len(found.tree))
        keys = tuple(key_of("part", VERSION, name, t) if counts[t] else "" for t in range(len(found.tree)))
        used = images, points[skeleton.points]
        kept = _kept(skeleton, options, free, *used, found.tree, found.boundary, counts, keys)
        held = keep if ready is None else parts_ready(counts, ready)
        notes.store(key_of("places", name), {"at": at})
        notes.store(name, {**kept, "keep": np.array(held)})
    del image, point

    def keep_parts() -> None:
        kept = notes.lent(name)
        if not store.has(name):
            store.store(name, kept)
        keys = kept["parts"].tolist()
        if not all(store.has(k) for k in keys if k):
            _keep_parts(columns, rejected, notes.lent(key_of("places", name))["at"], keys, store)

    network = network_of(store, name, notes)
    return Cut(replace(network, keep=keep) if ready is None else network, keep_parts)


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
    columns: Columns, options: AdjustmentOptions, free: Mapping[str, tuple[str, ...]], images: Mask, points: Mask,
    shift: Array | None,
) -> Skeleton:  # fmt: skip
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
        points[places], shift,
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


def lists(name: str, lists: Sequence[Index]) -> dict[str, Array]:
    """Lists of positions as one, with where each begins."""
    return {
        name: np.concatenate([np.zeros(0, np.int64), *lists]).astype(np.int32),
        f"{name}.first": np.concatenate([[0], np.cumsum([len(x) for x in lists])]).astype(np.int64),
    }


def from_lists(name: str, found: Mapping[str, Array]) -> tuple[Index, ...]:
    """The lists that `lists` put together."""
    values, first = found[name], found[f"{name}.first"].tolist()
    return tuple(values[a:b] for a, b in pairwise(first))


def _kept(
    skeleton: Skeleton, options: AdjustmentOptions, free: Mapping[str, tuple[str, ...]], images: Mask, points: Mask,
    tree: Tree, boundary: Sequence[Index], counts: Index, keys: Sequence[str],
) -> dict[str, Array]:  # fmt: skip
    """A network as it is kept, without its parts."""
    return {
        **{f"block.{name}": values for name, values in arrays_of_block(skeleton.block).items()},
        **lists("own", tree.own), **lists("boundary", boundary), "parent": tree.parent, "level": tree.level,
        "points": skeleton.points, "count": np.array(skeleton.count), "images used": images, "points used": points,
        "shift": skeleton.system.shift, "counts": counts, "parts": np.array(keys, np.str_),
        "options": np.array(msgspec.json.encode(options).decode()),
        "free": np.array(msgspec.json.encode(dict(free)).decode()),
    }  # fmt: skip


def network_of(store: Store, key: str, where: Store | None = None) -> Network:
    """A network that was kept.

    store  where its parts are
    where  where it is itself; None: there, too
    """
    found = (store if where is None else where).wanted(key)
    options = msgspec.json.decode(str(found["options"]), type=AdjustmentOptions)
    free = msgspec.json.decode(str(found["free"]), type=dict[str, tuple[str, ...]])
    skeleton = skeleton_from(
        _block(found), found["points"], int(found["count"]), options, free, found["images used"],
        found["points used"], found["shift"],
    )  # fmt: skip
    parts = tuple(found["parts"].tolist())
    return Network(
        key=key, skeleton=skeleton, boundary=from_lists("boundary", found), counts=found["counts"],
        tree=Tree(own=from_lists("own", found), parent=found["parent"], level=found["level"]),
        part=lambda t: _part_of(store.lent(parts[t])), keep=int(found["keep"]),
    )  # fmt: skip
