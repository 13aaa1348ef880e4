"""Several blocks in one: cameras, instruments, images and points are matched by their ids, all else is carried."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, fields, replace
from typing import Any, Literal, NoReturn, TypeVar, get_args

import numpy as np

from raybundle.block.agreement import Rows, codes, once, united
from raybundle.block.block import Block, Camera, Images, Instrument, Observations, Points, Role
from raybundle.block.transform import transform_block
from raybundle.errors import InputError, Message, message
from raybundle.numerics.arrays import Index
from raybundle.numerics.records import Records
from raybundle.numerics.transform import SimilarityTransform
from raybundle.observations.table import Table

P = TypeVar("P", Camera, Instrument)
Subject = Literal["block", "camera", "instrument", "image", "point", "observation"]
SUBJECTS: tuple[Subject, ...] = get_args(Subject)
WORDS = {"name": " + ", "about": "; ", "source": "; ", "licence": "; "}
"""Texts of a block, which contradict nothing: what stands between those that differ."""
MATCHED = ("window", "misfit", "relief", "sigma_curvature")
"""Columns of points that were measured by matching: of the first block that knows them"""
ROWS = {"cameras", "instruments", "images", "observations", "points", "tables", "rejected"}
PER_M = {"m": 1.0, "mm": 1000.0}


def merge_blocks(blocks: Sequence[Block], *, prefer: Mapping[Subject, int] | None = None) -> Block:
    """One block of several in one object frame, in which nothing is lost that any of them holds.

    blocks   their ids name the same things: images, points, cameras and instruments of one id are one
    prefer   kind -> position (from 0) of the block that decides contradictions of this kind.  Kinds:
             "block" (units, place, a-priori sigma ...), "camera", "instrument", "image" (its camera, file, pixel frame,
             station, held orientation), "point" (role and given coordinates), "observation".  With "block" the others
             are brought to its length unit
    raises   InputError where blocks contradict each other and `prefer` does not say which stands, with the object and
             both values

    Approximate orientations and coordinates contradict nothing: those of the last block stand that has the image
    oriented, or sees the point in two images.  Rows of observations that blocks hold alike are one; distances of one
    pair of points that differ are two observations, image points and positions of one image that differ contradict.
    Limits: blocks must be in one frame (`transform_block`), and ids must name the same things in all blocks.
    """
    for k, b in enumerate(blocks):
        if not isinstance(b, Block):  # pyright: ignore[reportUnnecessaryIsInstance]
            raise InputError("merge.no_block", entry=k, kind=type(b).__name__)
    if prefer is not None and not isinstance(prefer, Mapping):  # pyright: ignore[reportUnnecessaryIsInstance]
        raise InputError("merge.prefer_no_mapping", value=repr(prefer))
    rules = dict(prefer or {})
    for what, k in rules.items():
        if what not in SUBJECTS or not 0 <= k < len(blocks):
            raise InputError("merge.prefer_unknown", name=str(what), block=k, known=SUBJECTS, n=len(blocks))
    if not blocks:
        raise InputError("merge.no_blocks")
    return _Merge(tuple(blocks), rules).done() if len(blocks) > 1 else blocks[0]


@dataclass(frozen=True, slots=True)
class _Merge:
    """Blocks and whose word stands."""

    blocks: tuple[Block, ...]
    prefer: Mapping[Subject, int]

    def done(self) -> Block:
        merge = replace(self, blocks=self.in_one_unit())
        head = merge.head()
        cameras = merge.parametrised("camera", [b.cameras for b in merge.blocks])
        instruments = merge.parametrised("instrument", [b.instruments for b in merge.blocks])
        numbers = {
            "camera": _numbers([[c.id for c in b.cameras] for b in merge.blocks]),
            "instrument": _numbers([[i.id for i in b.instruments] for b in merge.blocks]),
            "image": _numbers([b.images.ids for b in merge.blocks]),
            "point": _numbers([b.points.ids for b in merge.blocks]),
        }
        made = replace(
            merge.blocks[0],
            **head,
            cameras=cameras,
            instruments=instruments,
            images=merge.images(numbers),
            points=merge.points(numbers["point"]),
            rejected=tuple(dict.fromkeys(pair for b in merge.blocks for pair in b.rejected)),
            tables={},
        )
        made = replace(made, observations=merge.observations(made, numbers))
        names = dict.fromkeys(name for b in merge.blocks for name in b.tables)
        return made.having(*(merge.table(made, name, numbers) for name in names))

    def in_one_unit(self) -> tuple[Block, ...]:
        k = self.prefer.get("block")
        if k is None:
            return self.blocks
        unit = self.blocks[k].length_unit
        by = {u: SimilarityTransform(scale=PER_M[unit] / PER_M[u]) for u in PER_M}
        return tuple(
            b if b.length_unit == unit
            else replace(transform_block(b, by[b.length_unit], observed="follow"), length_unit=unit)
            for b in self.blocks
        )  # fmt: skip

    def head(self) -> dict[str, Any]:
        """All that a block states beside its tables."""
        found = dict[str, Any]()
        for f in fields(Block):
            if f.name in ROWS:
                continue
            values = [getattr(b, f.name) for b in self.blocks]
            if f.name in WORDS and "block" not in self.prefer:
                found[f.name] = WORDS[f.name].join(dict.fromkeys(v for v in values if v))
                continue
            given = [(k, v) for k, v in enumerate(values) if v is not None and v != ""] or [(0, values[0])]
            stands = next((p for p in given if p[0] == self.prefer.get("block")), given[0])
            for k, v in given:
                if v != stands[1] and "block" not in self.prefer:
                    self.refuse("block", f.name, (stands[0], stands[1]), (k, v))
            found[f.name] = stands[1]
        return found

    def parametrised(self, what: Subject, lists: Sequence[tuple[P, ...]]) -> tuple[P, ...]:
        """Cameras or instruments, one of each id."""
        of: dict[str, list[tuple[int, P]]] = {}
        for k, things in enumerate(lists):
            for thing in things:
                of.setdefault(thing.id, []).append((k, thing))
        found = list[P]()
        for name, given in of.items():
            k, stands = next((t for t in given if t[0] == self.prefer.get(what)), given[0])
            for j, other in given if what not in self.prefer else []:
                for label, one, two in _differences(stands, other):
                    self.refuse(what, f"{name}: {label}", (k, one), (j, two))
            known = stands.known or next((t.known for _, t in given if t.known), {})
            found.append(replace(stands, known=known))
        return tuple(found)

    def images(self, numbers: Mapping[str, Sequence[Index]]) -> Images:
        stations = self.stations()
        moved = [
            replace(b.images.renumbered("camera", new), station=s)
            for b, new, s in zip(self.blocks, numbers["camera"], stations, strict=True)
        ]
        whole = moved[0].append(*moved[1:])
        ids = [c.id for c in self._first_of("camera", numbers)]

        def refuse(name: str, one: int, two: int) -> None:
            value = [ids[int(whole.camera[k])] if name == "camera" else _entry(whole, name, k) for k in (one, two)]
            self.refuse_rows("image", f"{whole.ids[one]}: {name}", rows, (one, value[0]), (two, value[1]))

        rows = self.rows_of("image", numbers["image"])
        return united(whole, rows, refuse, whole.held)

    def _first_of(self, what: Literal["camera"], numbers: Mapping[str, Sequence[Index]]) -> list[Camera]:
        found = {int(n): c for b, new in zip(self.blocks, numbers[what], strict=True)
                 for c, n in zip(b.cameras, new, strict=True)}  # fmt: skip
        return [found[k] for k in range(len(found))]

    def stations(self) -> list[Index | None]:
        """Stations of the images of each block, numbered so that stations of common images are one."""
        if all(b.images.station is None for b in self.blocks):
            return [None] * len(self.blocks)
        label, used, lead = dict[str, int](), set[int](), self.prefer.get("image")
        order = sorted(range(len(self.blocks)), key=lambda k: (k != lead, k))
        for k in order:
            images = self.blocks[k].images
            groups: dict[int, list[str]] = {}
            own = -1 - np.arange(len(images)) if images.station is None else images.station
            for name, s in zip(images.ids, own.tolist(), strict=True):
                groups.setdefault(s, []).append(name)
            before = {n: label[n] for n in images.ids if n in label}
            for s, names in groups.items():
                known = {before[n] for n in names if n in before}
                apart = [n for n in before if before[n] in known and n not in names]
                if (len(known) > 1 or apart) and lead is None:
                    first = next(n for n in names if n in before)
                    others = [n for n in label if label[n] == before[first]]
                    self.refuse("image", f"{first}: station", (order[0], others), (k, names))
                free = s if s >= 0 and s not in used else max(used, default=-1) + 1
                number = min(known) if known else free
                used.add(number)
                for n in names:
                    label.setdefault(n, number)
        return [np.array([label[n] for n in b.images.ids], np.int32) for b in self.blocks]

    def points(self, numbers: Sequence[Index]) -> Points:
        whole = self.blocks[0].points.append(*(b.points for b in self.blocks[1:]))
        rows = self.rows_of("point", numbers)
        count = len(whole)
        role, given = np.asarray(whole.role), whole.is_control | whole.is_check
        speaks = role != Role.TIE
        chosen = rows.first(speaks)
        stands = chosen[rows.of]
        parts = replace(whole, xyz=np.where(given, whole.xyz, np.nan))
        for name, c in parts.columns():
            code = codes(c, getattr(parts, name), count)
            for k in np.flatnonzero(speaks & (code != code[stands]))[:1].tolist():
                one, two = (
                    Role(int(role[j])).word if name == "role" else _entry(parts, name, j) for j in (int(stands[k]), k)
                )
                label = f"{whole.ids[k]}: {name}"
                self.refuse_rows("point", label, rows, (int(stands[k]), one), (k, two))
        rays = np.concatenate([b.ray_count for b in self.blocks])
        found = np.asarray(np.isfinite(whole.xyz).all(axis=1))
        seen = found & (rays > 1)
        near = np.where(seen[last := rows.first(seen, last=True)], last, rows.first(found))
        made = whole.rows(chosen)
        matched = {n: v[rows.first(np.isfinite(v))] for n in MATCHED if (v := getattr(whole, n)) is not None}
        return replace(made, xyz=np.where(given[chosen], made.xyz, whole.xyz[near]), **matched)

    def observations(self, made: Block, numbers: Mapping[str, Sequence[Index]]) -> Observations:
        moved = [
            b.observations.renumbered("image", i).renumbered("point", p)
            for b, i, p in zip(self.blocks, numbers["image"], numbers["point"], strict=True)
        ]
        whole = moved[0].append(*moved[1:])

        def refuse(one: int, two: int) -> None:
            name = f"{made.images.ids[whole.image[one]]}, {made.points.ids[whole.point[one]]}: xy_px"
            values = [[*whole.xy_px[k].tolist(), *whole.cov_px2[k].tolist()] for k in (one, two)]
            self.refuse_rows("observation", name, rows, (one, values[0]), (two, values[1]))

        rows = self.sources(moved, "observation")
        return once(whole, rows, refuse)

    def table(self, made: Block, name: str, numbers: Mapping[str, Sequence[Index]]) -> Table:
        moved = list[Table]()
        kind = next(type(b.tables[name]) for b in self.blocks if name in b.tables)
        for k, b in enumerate(self.blocks):
            t = b.table(kind)
            for to in ("point", "image", "instrument"):
                t = t.renumbered(to, numbers[to][k])
            moved.append(t)
        whole = moved[0].append(*moved[1:])
        called = made.row_names(whole)

        def refuse(one: int, two: int) -> None:
            name, values = next(
                (n, [_entry(whole, n, k) for k in (one, two)])
                for n, c in whole.columns()
                if len({*codes(c, getattr(whole, n), len(whole))[[one, two]].tolist()}) > 1
            )
            label = called(one).partition("(")[2].rstrip(")")
            text = f"{whole.name}.csv, {label}: {name}"
            self.refuse_rows("observation", text, rows, (one, values[0]), (two, values[1]))

        rows = self.sources(moved, "observation")
        merged = once(whole, rows, refuse)
        with np.errstate(invalid="ignore"):
            bad = [w for w in merged.faults() if w.rows.any()]
            fresh = bad and not any(w.rows.any() for t in moved for w in t.faults())
        if fresh:
            k = int(np.flatnonzero(bad[0].rows)[0])
            found = bad[0].message(k)
            why = found if isinstance(found, Message) else message("error.other", detail=found)
            raise InputError("merge.do_not_fit", details=[why], name=made.row_names(merged)(k), entry=bad[0].column)
        return merged

    def rows_of(self, what: Subject, numbers: Sequence[Index]) -> Rows:
        source = np.repeat(np.arange(len(numbers)), [len(n) for n in numbers])
        return Rows(of=np.concatenate(numbers), source=source, lead=self.prefer.get(what, -1))

    def sources(self, tables: Sequence[Records], what: Subject) -> Rows:
        source = np.repeat(np.arange(len(tables)), [len(t) for t in tables])
        return Rows(of=np.arange(len(source)), source=source, lead=self.prefer.get(what, -1))

    def refuse_rows(self, what: Subject, text: str, rows: Rows, one: tuple[int, Any], two: tuple[int, Any]) -> None:
        if what not in self.prefer:
            self.refuse(what, text, (int(rows.source[one[0]]), one[1]), (int(rows.source[two[0]]), two[1]))

    def refuse(self, what: Subject, text: str, one: tuple[int, Any], two: tuple[int, Any]) -> NoReturn:
        (j, a), (k, b) = one, two
        raise InputError(
            "merge.contradiction",
            name=text,
            value=str(a),
            other=str(b),
            block=self.blocks[j].name,
            other_block=self.blocks[k].name,
            first=j,
            second=k,
            subject=what,
        )


def _numbers(ids: Sequence[Sequence[str]]) -> list[Index]:
    """New positions of the things of each block, by their ids in the order in which they appear."""
    at: dict[str, int] = {}
    return [np.array([at.setdefault(i, len(at)) for i in of], np.int32) for of in ids]


def _differences(one: P, two: P) -> list[tuple[str, Any, Any]]:
    """Fields in which two cameras or instruments differ, with their values; of mappings the first symbol."""
    found = list[tuple[str, Any, Any]]()
    for f in fields(one):
        a, b = getattr(one, f.name), getattr(two, f.name)
        if a == b or (f.name == "known" and not (a and b)):
            continue
        label = f.name
        if isinstance(a, Mapping) and isinstance(b, Mapping):
            symbol = next((s for s in (*a, *b) if a.get(s) != b.get(s)), None)
            if symbol is None:
                continue
            label, a, b = f"{f.name}.{symbol}", a.get(symbol, "-"), b.get(symbol, "-")
        found.append((label, a, b))
    return found


def _entry(table: Records, name: str, k: int) -> Any:
    """An entry of a column, as a message shows it."""
    values = getattr(table, name)
    value = values.get(k, "-") if isinstance(values, Mapping) else values[k]
    return value.tolist() if isinstance(value, np.ndarray | np.generic) else value
