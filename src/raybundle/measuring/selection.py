"""Gradual selection: image observations beyond a limit, by what an adjustment states of them."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import cast

import numpy as np

from raybundle.adjustment.evaluation.check_points import used_rays
from raybundle.adjustment.result import Adjustment
from raybundle.block import Role
from raybundle.errors import InputError
from raybundle.measuring.actions.decisions import Quantity
from raybundle.measuring.session import adjusted_again, latest_block
from raybundle.measuring.state import Key, State
from raybundle.numerics.arrays import Array, Index, Mask
from raybundle.results.folder import ResultFolder, read_result


@dataclass(frozen=True, slots=True, kw_only=True)
class Criterion:
    """A quantity by which image observations are selected."""

    words: str
    """what it is"""
    above: bool
    """whether those above the limit are selected, or those below it"""
    ties: bool
    """whether tie points alone are selected: it is a quantity of a whole point"""

    def beyond(self, values: Array, limit: float) -> Mask:
        """Which values are beyond a limit; those that are not known are not."""
        with np.errstate(invalid="ignore"):
            return values > limit if self.above else values < limit


CRITERIA: Mapping[Quantity, Criterion] = {
    "w": Criterion(words="largest |w| of an image observation", above=True, ties=False),
    "sigma": Criterion(words="largest standard deviation of X, Y, Z of a tie point", above=True, ties=True),
    "rays": Criterion(words="rays of a tie point that take part", above=False, ties=True),
    "redundancy": Criterion(words="smaller redundancy number of an image observation", above=False, ties=False),
}


@dataclass(frozen=True, slots=True, kw_only=True)
class Figures:
    """What an adjustment states of its image observations, one row each."""

    images: tuple[str, ...]
    points: tuple[str, ...]
    image: Index
    """(m,) position in `images`"""
    point: Index
    """(m,) position in `points`"""
    used: Mask
    tie: Mask
    """(m,) of a tie point"""
    values: Mapping[Quantity, Array]
    """(m,) each; NaN where it is not known"""


@dataclass(frozen=True, slots=True, kw_only=True)
class Selected:
    """Image observations beyond a limit."""

    rows: tuple[Key, ...]
    """(image, point) of those of the block that take part, the farthest beyond first"""
    points: int
    """object points that they belong to"""
    marks: int
    """marks made by hand that are beyond it, too: they are removed, not rejected"""
    used: int
    """image observations that take part in all"""


def figures_of(a: Adjustment) -> Figures:
    """The figures of an adjustment."""
    block, s = a.given, a.image_observations
    sigma = np.full(len(block.points), np.nan)
    if a.precision is not None:
        known = np.isfinite(a.precision.object_point_std).all(axis=1)
        sigma[known] = a.precision.object_point_std[known].max(axis=1)
    o = block.observations
    return Figures(
        images=block.images.ids, points=block.points.ids, image=o.image, point=o.point, used=s.used,
        tie=np.asarray(block.points.role)[o.point] == Role.TIE,
        values={
            "w": _extreme(np.abs(s.w), largest=True), "sigma": sigma[o.point], "rays": used_rays(a)[o.point],
            "redundancy": _extreme(s.redundancy, largest=False),
        },
    )  # fmt: skip


def figures_of_result(result: ResultFolder) -> Figures:
    """The same, as a result folder keeps them."""
    b, o, p = result.block, result.observations, result.points
    image_of = {name: k for k, name in enumerate(b.images.ids)}
    row_of = {name: k for k, name in enumerate(p.text["point"])}
    image = np.array([image_of[name] for name in o.text["image"]], np.int32)
    point = np.array([row_of[name] for name in o.text["point"]], np.int32)
    used = np.array([not reason for reason in o.text["rejected"]], bool)
    pairs = {n: np.stack([o.number[f"{n}x"], o.number[f"{n}y"]], axis=1).reshape(-1, 2) for n in ("w", "r")}
    sigma = _extreme(np.stack([p.number[f"s{axis}"] for axis in "XYZ"], axis=1).reshape(-1, 3), largest=True)
    rays = np.bincount(point[used], minlength=len(row_of)).astype(float)
    return Figures(
        images=b.images.ids, points=tuple(p.text["point"]), image=image, point=point, used=used,
        tie=np.array([role == "tie" for role in p.text["role"]], bool)[point],
        values={
            "w": _extreme(np.abs(pairs["w"]), largest=True), "sigma": sigma[point], "rays": rays[point],
            "redundancy": _extreme(pairs["r"], largest=False),
        },
    )  # fmt: skip


def quantity_of(name: str) -> Quantity:
    """The quantity of a name; raises InputError."""
    if name not in CRITERIA:
        raise InputError("selection.unknown_quantity", quantity=str(name), known=list(CRITERIA))
    return cast("Quantity", name)


def latest_result(folder: Path) -> Path | None:
    """The last result of a project, result or block folder: with what was measured, or its own if later; or None."""
    found = latest_block(folder).parent
    return found if (found / "result.json").is_file() else None


def latest_figures(folder: Path) -> Figures:
    """The figures of the last result of a folder; of a block that has none, of its adjustment."""
    found = latest_result(folder)
    if found is None:
        return figures_of(adjusted_again(folder))
    return figures_of_result(read_result(found))


def selected(figures: Figures, state: State, quantity: Quantity, limit: float) -> Selected:
    """The image observations beyond a limit that take part and are not rejected by hand already.

    w, redundancy  of each image observation
    sigma, rays    of tie points: all image observations of a point; in the length unit of the block
    raises         InputError for a limit that is no number
    """
    if not np.isfinite(limit):
        raise InputError("number.not_finite", entry=quantity, value=limit)
    criterion = CRITERIA[quantity]
    found = figures.used & criterion.beyond(figures.values[quantity], limit)
    if criterion.ties:
        found &= figures.tie
    chosen = np.flatnonzero(found)
    far = figures.values[quantity][chosen]
    chosen = chosen[np.argsort(-far if criterion.above else far, kind="stable")]
    pairs = [
        (figures.images[i], state.renamed.get(figures.points[p], figures.points[p]))
        for i, p in zip(figures.image[chosen].tolist(), figures.point[chosen].tolist(), strict=True)
    ]
    rows = tuple(pair for pair in pairs if pair not in state.marks and pair not in state.rejected)
    return Selected(
        rows=rows, points=len({p for _, p in rows}), marks=sum(pair in state.marks for pair in pairs),
        used=int(figures.used.sum()),
    )  # fmt: skip


def _extreme(values: Array, *, largest: bool) -> Array:
    """Largest or smallest number of each row; NaN where a row has none."""
    outer = -np.inf if largest else np.inf
    filled = np.where(np.isnan(values), outer, values)
    found = filled.max(axis=1, initial=outer) if largest else filled.min(axis=1, initial=outer)
    return np.where(np.isinf(found), np.nan, found)
