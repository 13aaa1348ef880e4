"""A block in another frame: everything in it after X -> s R X + t, or its approximate values alone."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from typing import Literal, TypeVar

import numpy as np

from raybundle.block.block import Block, Camera, Instrument
from raybundle.errors import InputError
from raybundle.numerics.arrays import Array, Mask
from raybundle.numerics.deviations import COUPLED, deviations_after, kept_after
from raybundle.numerics.transform import SimilarityTransform
from raybundle.observations.deviation import Deviations
from raybundle.observations.parameter import Calibrated
from raybundle.observations.relation import Relation
from raybundle.observations.table import Table
from raybundle.sensors.model import Parameter

P = TypeVar("P", Camera, Instrument)
SQUARE = 1e-6
"""By how much a matrix may be no rotation: what six printed digits leave."""


def transform_block(block: Block, by: SimilarityTransform, *, observed: Literal["follow", "stay"]) -> Block:
    """The block after X -> s R X + t.

    by        scale, rotation and translation; lengths stay in the block's `length_unit`
    observed  "follow": observed and given values are transformed to the new frame, with their standard deviations; an
              adjustment then gives the same result, transformed.  "stay": only approximate orientations and
              coordinates move, e.g. for a block that is transformed to its control
    raises    InputError for the first thing that cannot follow: what is about the vertical after a tilt, standard
              deviations of coordinates that a rotation would correlate, a geodetic place, a satellite scene
    """
    if observed not in ("follow", "stay"):
        raise InputError("transform.observed_unknown", value=repr(observed))
    if not by.scale > 0 or not np.isfinite(by.scale):
        raise InputError("transform.scale_not_positive", scale=by.scale)
    if not np.isfinite(by.translation).all():
        raise InputError("transform.translation_not_finite", translation=by.translation.tolist())
    off = float(np.abs(by.rotation @ by.rotation.T - np.eye(3)).max())
    if not off < SQUARE:
        raise InputError("transform.rotation_not_orthogonal", off=off, limit=SQUARE)
    if np.linalg.det(by.rotation) < 0:
        raise InputError("transform.rotation_mirrored")
    if observed == "stay":
        sizes = {name: getattr(block.points, name) for name in ("window", "sigma_curvature")}
        scaled = {name: None if size is None else by.scale * size for name, size in sizes.items()}
        points = replace(block.points, xyz=by.points(block.points.xyz), **scaled)
        return replace(block, images=block.images.transformed(by), points=points)
    if by.is_identity:
        return block
    _refuse_geodetic(block)
    own = {
        k: {
            s: v * _factor(block.cameras[int(block.images.camera[k])].sensor.parameters, s, by)
            for s, v in values.items()
        }
        for k, values in block.images.interior.items()
    }
    return replace(
        block,
        cameras=tuple(_parametrised(c, by) for c in block.cameras),
        instruments=tuple(_parametrised(i, by) for i in block.instruments),
        images=replace(block.images, interior=own).transformed(by),
        points=block.points.transformed(by, lambda k: f"point {block.points.ids[k]}"),
    ).having(*_tables(block, by))


def _tables(block: Block, by: SimilarityTransform) -> list[Table]:
    moved = [t.transformed(by, block.row_names(t)) for t in block.tables.values()]
    return [_deviations(block, t, by) if isinstance(t, Deviations) else t for t in moved]


def _refuse_geodetic(block: Block) -> None:
    scenes = [c.id for c in block.cameras if c.is_scene]
    if scenes:
        raise InputError("transform.scene", scene=scenes[0])
    if block.place is not None:
        raise InputError("transform.geodetic_frame")


def _factor(parameters: Sequence[Parameter], symbol: str, by: SimilarityTransform) -> float:
    return by.scale if any(p.symbol == symbol and p.is_length for p in parameters) else 1.0


def _deviations(block: Block, table: Deviations, by: SimilarityTransform) -> Deviations:
    cameras = [block.cameras[int(c)] for c in block.images.camera[table.image]]
    factor = [_factor(c.sensor.parameters, s, by) for c, s in zip(cameras, table.parameter, strict=True)]
    return replace(table, sigma=table.sigma * np.array(factor))


@dataclass(frozen=True, slots=True)
class _Way:
    """How the parameters of a camera or an instrument follow."""

    name: str
    parameters: tuple[Parameter, ...]
    vectors: tuple[tuple[str, ...], ...]
    """Symbols of those in the axes of the object, three each"""
    by: SimilarityTransform

    def factor(self, symbol: str) -> float:
        return _factor(self.parameters, symbol, self.by)

    def matrix(self, symbols: Sequence[str]) -> Array:
        """(k, k) parameters after by those before."""
        A = np.diag([self.factor(s) for s in symbols])
        at = {s: k for k, s in enumerate(symbols)}
        for vector in self.vectors:
            there = [(at[s], n) for n, s in enumerate(vector) if s in at]
            for i, m in there:
                for j, n in there:
                    A[i, j] = self.factor(vector[m]) * self.by.rotation[m, n]
        return A

    def completed(self, symbols: Sequence[str]) -> tuple[str, ...]:
        """The symbols, and those that they turn into."""
        beside = [s for v in self.vectors if {*v} & {*symbols} for s in v]
        return tuple(dict.fromkeys([*symbols, *beside]))

    def values(self, values: Mapping[str, float], others: Mapping[str, float]) -> dict[str, float]:
        symbols = self.completed([*values])
        old = np.array([values.get(s, others.get(s, 0.0)) for s in symbols])
        return dict(zip(symbols, (self.matrix(symbols) @ old).tolist(), strict=True))

    def sigma(self, sigma: Mapping[str, float]) -> dict[str, float]:
        new = {s: v * self.factor(s) for s, v in sigma.items()}
        for vector in self.vectors:
            old = np.array([[sigma.get(s, np.nan) for s in vector]])
            if not kept_after(self.by.rotation, old).all():
                raise InputError("transform.sigmas_correlated", name=self.name, parameters=vector)
            after = (self.factor(vector[0]) * deviations_after(self.by.rotation, old))[0].tolist()
            new = {s: v for s, v in new.items() if s not in vector}
            new |= {s: v for s, v in zip(vector, after, strict=True) if np.isfinite(v)}
        return new

    def estimate(self, free: tuple[str, ...]) -> tuple[str, ...]:
        new = [s for s in free if not any(s in v for v in self.vectors)]
        for vector in self.vectors:
            mine = np.array([s in free for s in vector])
            coupled = np.abs(self.by.rotation) > COUPLED
            after: Mask = np.asarray((coupled & mine).any(axis=1))
            if (coupled[after] & ~mine).any():
                raise InputError("transform.partly_free", name=self.name, parameters=vector)
            new += [s for s, m in zip(vector, after.tolist(), strict=True) if m]
        order = [p.symbol for p in self.parameters]
        return free if {*new} == {*free} else tuple(sorted(new, key=order.index))

    def calibrated(self, known: Calibrated) -> Calibrated:
        A = self.matrix(known.symbols)
        lacking = [s for s in self.completed(known.symbols) if s not in known.symbols]
        if lacking and self.by.turns:
            raise InputError("transform.calibration_incomplete", name=self.name, parameter=lacking[0])
        C = A @ known.covariance @ A.T
        size = np.sqrt(np.diagonal(C))
        R = C / np.outer(size, size)
        rows = tuple((*row[:k].tolist(), 1.0) for k, row in enumerate(R))
        values = (A @ np.array(known.values)).tolist()
        return replace(known, values=tuple(values), sigma=tuple(size.tolist()), correlations=rows)

    def relation(self, relation: Relation) -> Relation:
        symbols = self.completed([*relation.terms])
        old = np.array([relation.terms.get(s, 0.0) for s in symbols])
        new = np.linalg.solve(self.matrix(symbols).T, old).tolist()
        return replace(relation, terms={s: v for s, v in zip(symbols, new, strict=True) if v or s in relation.terms})


def _parametrised(thing: P, by: SimilarityTransform) -> P:
    """A camera or an instrument: lengths grow with the object, vectors in its axes turn, lever arms do not."""
    vectors = tuple(v for v in getattr(thing.sensor, "in_object", ()))
    touched = any(p.is_length for p in thing.sensor.parameters) and by.scale != 1
    if not touched and not (vectors and by.turns):
        return thing
    way = _Way(thing.id, thing.sensor.parameters, vectors if by.turns else (), by)
    return replace(
        thing,
        values=way.values(thing.values, {}),
        known=way.values(thing.known, thing.values),
        sigma=way.sigma(thing.sigma),
        estimate="auto" if thing.estimate == "auto" else way.estimate(thing.estimate),
        calibrated=None if thing.calibrated is None else way.calibrated(thing.calibrated),
        relations=tuple(map(way.relation, thing.relations)),
    )
