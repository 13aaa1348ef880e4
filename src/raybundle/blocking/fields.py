"""Noise fields of a part, as tasks: everything that fields need of normal equations is a sum over parts.

An eliminated object point belongs to one part, so that what fields share with the unknowns and with one another when
object points are eliminated adds up, and so does what right sides of points bring to them.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import numpy as np

from raybundle.adjustment.statistics.field_system import WideNormals, carrying
from raybundle.adjustment.statistics.fields import WithFields, WithOwnInterior
from raybundle.blocking import sweeps
from raybundle.blocking.store import Store
from raybundle.blocking.sweeps import Values
from raybundle.blocking.tasks import known, part_at
from raybundle.numerics.arrays import Array
from raybundle.pipeline.place import Product

KINDS = {kind.name: kind for kind in (WithFields, WithOwnInterior)}
WIDER = 3
"""Memory of a part with the columns of fields, over that of the part."""


@dataclass(frozen=True, slots=True, kw_only=True)
class Widened:
    """A part with fields at a state."""

    network: str
    node: int
    state: str
    held: str
    kind: str
    """Of KINDS"""


def wide_of(store: Store, o: Widened | Asked) -> WideNormals | None:
    """The part with the columns of fields, ready for use; None where the tree node has no observations.

    Some stay ready, a third as many as parts do: the first ones, since all parts are asked in turn.
    """
    found = part_at(store, o, o.held)
    if found is None:
        return None
    at, (work, state) = known(store, o.network), found
    of = (o.state, o.held, o.kind)
    kept = at.wide.get(o.node)
    if kept is not None and kept[0] == of:
        return kept[1]
    at.wide.pop(o.node, None)
    wide = WideNormals.of(work.normals, state, carrying(work.of.system), KINDS[o.kind])
    if len(at.wide) < max(1, at.network.keep // WIDER):
        at.wide[o.node] = of, wide
    return wide


def widen(store: Store, o: Widened) -> Product:
    """A part's H and own matrix of the fields, right sides, its images with fields and its unknowns in the network."""
    wide, part = wide_of(store, o), part_at(store, o)
    if wide is None or part is None:
        none = np.zeros(0)
        return {"right": none, "given": none, "images": none.astype(int), "unknowns": none.astype(int),
                "finite": np.array(True)}  # fmt: skip
    wide.reduced()
    work, _ = part
    found = {
        "right": wide.right, "given": wide.given, "images": work.part.images[carrying(work.of.system)],
        "unknowns": sweeps.rows_of(known(store, o.network).network, work.of.nodes), "finite": np.array(wide.is_finite),
        **packed("H", wide.H), **packed("own", wide.own),
    }  # fmt: skip
    wide.H = wide.own = None
    return found


def packed(name: str, matrix: Any) -> dict[str, Array]:
    """A matrix, or a sparse one (csr), as arrays."""
    return {name: matrix} if isinstance(matrix, np.ndarray) else {
        f"{name}.data": matrix.data, f"{name}.indices": matrix.indices.astype(np.int32),
        f"{name}.indptr": matrix.indptr.astype(np.int32), f"{name}.shape": np.array(matrix.shape),
    }  # fmt: skip


def unpacked(name: str, found: Values) -> Any:
    """The matrix again."""
    from scipy.sparse import csr_matrix

    if name in found:
        return found[name]
    values = (found[f"{name}.{of}"] for of in ("data", "indices", "indptr"))
    return csr_matrix(tuple(values), shape=tuple(found[f"{name}.shape"].tolist()))


@dataclass(frozen=True, slots=True, kw_only=True)
class Asked:
    """A part with fields at a state, and a product with what is asked of it."""

    network: str
    node: int
    state: str
    held: str
    kind: str
    given: str


def moved(store: Store, o: Asked) -> Product:
    """J c of the points (p, 3, k), given J c of the nodes and c."""
    wide = wide_of(store, o)
    if wide is None:
        return {}
    given = store.lent(o.given)
    return {"points": wide.expand(given["nodes"], given["fields"])}


def projected(store: Store, o: Asked) -> Product:
    """What right sides of the part's points bring to its fields (10 f, k)."""
    wide = wide_of(store, o)
    return {} if wide is None else {"fields": wide.condense(store.lent(o.given, ("points",))["points"])}


def squared(store: Store, o: Asked) -> Product:
    """J J' of the points (p, 3, 3), given J of the nodes and the basis."""
    wide = wide_of(store, o)
    if wide is None:
        return {}
    given = store.lent(o.given)
    return {"points": wide.squares(given["nodes"], unpacked("basis", given))}


@dataclass(frozen=True, slots=True, kw_only=True)
class Retained:
    """A part at a state."""

    network: str
    node: int
    state: str


def retained(store: Store, o: Retained) -> Product:
    """Normal matrices (k, 3, 3) of the part's points that have nodes, held coordinates as control states."""
    found = part_at(store, o, "")
    if found is None:
        return {}
    work, state = found
    normals, node = work.normals, work.of.system.point_node
    normals.reduce(state)
    blocks = [normals.node_block(normals.values, n, n) for n in node[node >= 0].tolist()]
    return {"blocks": np.array(blocks).reshape(-1, 3, 3)}
