"""The normal equations with the columns of noise fields as a sum over parts (`adjustment.statistics.field_system`)."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np

from raybundle.adjustment.statistics.field_system import at_entries, dense, entries
from raybundle.adjustment.statistics.fields import WithFields
from raybundle.adjustment.system.assemble import State
from raybundle.blocking import fields
from raybundle.blocking.fields import packed, unpacked
from raybundle.blocking.network_in_memory import WholeNormals
from raybundle.blocking.network_store import from_lists, lists
from raybundle.numerics import large
from raybundle.numerics.arrays import Array, Index

MODULE = "fields"
WIDER = 4.0
"""Memory of a part's sweep with the columns of fields, over that of one without."""
MATRIX = ("data", "indices", "indptr", "shape")


@dataclass(slots=True)
class FieldsInParts:
    """As `adjustment.statistics.field_system.Wide`; no matrix is here as a whole, but those of one part at a time."""

    base: WholeNormals
    state: State
    kind: type[WithFields]
    held: str
    """Product with the coordinates that carry the datum of the factor"""
    keys: tuple[str, ...]
    """By tree node, products with the matrices"""
    unknowns: tuple[Index, ...]
    """By tree node, unknowns of nodes that stand in its matrices; none where it has no part"""
    columns: tuple[Index, ...]
    """By tree node, coefficients that do"""
    right: Array
    given: Array
    is_finite: bool

    @classmethod
    def of(cls, base: WholeNormals, state: State, images: Index, kind: type[WithFields]) -> FieldsInParts:
        """With a task for each part, in no order."""
        parts, of, held = base.parts.parts, base.kept_state(state), base.parts.held

        def options(t: int) -> fields.Widened:
            return fields.Widened(network=parts.network.key, node=t, state=of.keys[t], held=held, kind=kind.name)

        keys = parts.each("widen", options, lambda o: (o.state,), MODULE, wider=WIDER)
        width, none = kind.columns, np.zeros(0, np.int64)

        def find() -> dict[str, Array]:
            right, given = np.zeros(width * len(images)), np.zeros(int(base.system.offsets[-1]))
            unknowns, columns, finite = list[Index](), list[Index](), True
            for found in base.of_each(keys, "right", "given", "images", "unknowns", "finite"):
                at = np.searchsorted(images, found.get("images", none))
                columns.append((width * at[:, None] + np.arange(width)).ravel())
                unknowns.append(found.get("unknowns", none))
                if found:
                    right[columns[-1]] += found["right"]
                    given[unknowns[-1]] += found["given"]
                    finite &= bool(found["finite"])
            sums = {"right": right, "given": given, "finite": np.array(finite)}
            return {**sums, **lists("unknowns", unknowns), **lists("columns", columns)}

        found = parts.noted("widened", keys, find)
        extra, given = base.extra(state), np.array(found["given"])
        np.add.at(given, extra.unknown, -extra.value * extra.residual[extra.row])
        given[base.held_unknowns()] = 0.0
        return cls(
            base=base, state=state, kind=kind, held=held, keys=keys, unknowns=from_lists("unknowns", found),
            columns=from_lists("columns", found), right=np.array(found["right"]), given=given,
            is_finite=bool(found["finite"]),
        )  # fmt: skip

    def _each(self, *names: str) -> Iterator[tuple[int, tuple[Any, ...]]]:
        """Tree nodes that have a part, and matrices of these."""
        parts = self.base.parts.parts
        parts.do(self.keys)
        arrays = tuple(f"{name}.{of}" for name in names for of in MATRIX)
        for t, key in enumerate(self.keys):
            if len(self.unknowns[t]):
                found = parts.store.lent(key, arrays)
                yield t, tuple(unpacked(name, found) for name in names)

    def at(self, chosen: Array) -> tuple[Array, Array]:
        """Columns (N, k) of H and (10 f, k) of the fields' own matrix."""
        place = np.full(len(self.right), -1)
        place[chosen] = np.arange(len(chosen))
        H, own = np.zeros((len(self.given), len(chosen))), np.zeros((len(self.right), len(chosen)))
        for t, (h, o) in self._each("H", "own"):
            to = place[self.columns[t]]
            mine = np.flatnonzero(to >= 0)
            if len(mine):
                H[np.ix_(self.unknowns[t], to[mine])] += h[:, mine].toarray()
                own[np.ix_(self.columns[t], to[mine])] += o[:, mine].toarray()
        return H, own

    def times(self, coefficients: Any) -> Array:
        """H c (N, k) of coefficients (10 f, k), which may be sparse."""
        found = np.zeros((len(self.given), coefficients.shape[1]))
        for t, (h,) in self._each("H"):
            found[self.unknowns[t]] += dense(h @ coefficients[self.columns[t]])
        return found

    def transposed(self, nodes: Array) -> Array:
        """H' n of nodes (N,) or (N, k)."""
        found = np.zeros((len(self.right), *nodes.shape[1:]))
        for t, (h,) in self._each("H"):
            found[self.columns[t]] += h.T @ nodes[self.unknowns[t]]
        return found

    def subtract(self, own: Array, nodes: Array) -> None:
        """Take H' n from columns (10 f, k), in place; nodes (N, k)."""
        for t, (h,) in self._each("H"):
            own[self.columns[t]] -= h.T @ nodes[self.unknowns[t]]

    def shared(self, image: int) -> Array:
        """(f,) square sums of the fields' own matrix between one image and each."""
        width = self.kind.columns
        whole = np.zeros((width, len(self.right)))
        rows = np.arange(width * image, width * (image + 1))
        parts = self.base.parts.parts
        for t, columns in enumerate(self.columns):
            mine = np.flatnonzero(np.isin(columns, rows))
            if len(mine):
                own = unpacked("own", parts.store.lent(self.keys[t], tuple(f"own.{of}" for of in MATRIX)))
                whole[:, columns] += own[mine].toarray()
        return (whole**2).reshape(width, -1, width).sum(axis=(0, 2))

    def _asked(self, name: str, given: Sequence[str], gather: Callable[[list[dict[str, Array]]], Array]) -> Array:
        """What is gathered of the products of a task for each part; neither they nor what was given stay."""
        base, parts, of = self.base, self.base.parts.parts, self.base.kept_state(self.state)

        def options(t: int) -> fields.Asked:
            return fields.Asked(
                network=parts.network.key, node=t, state=of.keys[t], held=self.held, kind=self.kind.name, given=given[t]
            )

        keys = parts.each(name, options, lambda o: (o.state, o.given), MODULE, wider=WIDER)

        def find() -> dict[str, Array]:
            found = gather(base.of_each(keys))
            parts.forget(keys)
            return {"found": found}

        found = parts.noted(name, keys, find)["found"]
        parts.forget([key for key in given if key])
        return found

    def _to_points(self, name: str, given: Sequence[str], shape: tuple[int, ...]) -> Array:
        """Values (p, ...) of the points of all parts."""

        def gather(products: list[dict[str, Array]]) -> Array:
            found = large.zeros(shape)
            for mine, product in zip(self.base.touched.points, products, strict=True):
                if len(mine):
                    found[mine] = product["points"]
            return found

        return self._asked(name, given, gather)

    def _handed(self, nodes: Array, coefficients: Callable[[Index], dict[str, Array]]) -> list[str]:
        """Values (N, k) of nodes and of coefficients as products of the parts; "" where there is none."""
        put = self.base.parts.parts.put
        return [
            put("fields", {"nodes": nodes[unknowns], **coefficients(columns)}) if len(unknowns) else ""
            for unknowns, columns in zip(self.unknowns, self.columns, strict=True)
        ]

    def expand(self, nodes: Array, coefficients: Array) -> Array:
        """J c of the points (p, 3, k) for coefficients (10 f, k) with J c of the nodes (N, k)."""
        system, k = self.base.system, nodes.shape[1]
        given = self._handed(nodes, lambda columns: {"fields": coefficients[columns]})
        found = self._to_points("moved", given, (*self.state.xyz.shape, k))
        kept = np.flatnonzero(system.point_node >= 0)
        found[kept] = nodes[system.offsets[system.point_node[kept]][:, None] + np.arange(3)]
        return found

    def condense(self, points: Array) -> Array:
        """What right sides (p, 3, k) of the points bring to the fields (10 f, k)."""

        def gather(products: list[dict[str, Array]]) -> Array:
            found = np.zeros((len(self.right), points.shape[2]))
            for columns, product in zip(self.columns, products, strict=True):
                if product:
                    found[columns] += product["fields"]
            return found

        return self._asked("projected", self.base.handed(points), gather)

    def influences(self, nodes: Array, basis: Any) -> tuple[Array, Array]:
        """J J' of the nodes at the blocks that there are, and of the points (p, 3, 3)."""
        row, column = entries(self.base)
        given = self._handed(nodes, lambda columns: packed("basis", basis[columns]))
        return at_entries(nodes, row, column), self._to_points("squared", given, (len(self.state.xyz), 3, 3))

    def ray_blocks(self, points: Index) -> Array:
        """Normal matrices (k, 3, 3) of retained points by image points alone, held coordinates as control states."""
        base, parts, of = self.base, self.base.parts.parts, self.base.kept_state(self.state)

        def options(t: int) -> fields.Retained:
            return fields.Retained(network=parts.network.key, node=t, state=of.keys[t])

        keys = parts.each("retained", options, lambda o: (o.state,), MODULE)

        def find() -> dict[str, Array]:
            found = np.zeros((len(base.system.point_node), 3, 3))
            for mine, product in zip(base.touched.points, base.of_each(keys), strict=True):
                if product:
                    found[mine[base.system.point_node[mine] >= 0]] += product["blocks"]
            parts.forget(keys)
            return {"blocks": found[points]}

        return parts.noted("retained", keys, find)["blocks"]


class NormalsInParts(WholeNormals):
    """The same, with noise fields."""

    def with_fields(self, state: State, images: Index, kind: type[WithFields]) -> FieldsInParts:
        """The normal equations with the columns of fields (`adjustment.statistics.field_system`)."""
        return FieldsInParts.of(self, state, images, kind)
