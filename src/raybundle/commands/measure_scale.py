"""What gives a measurement its scale and axes: scale bars, held against each other, and control."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import replace
from itertools import combinations
from pathlib import Path
from typing import TYPE_CHECKING

from raybundle.errors import InputError
from raybundle.settings import option

if TYPE_CHECKING:
    from raybundle.adjustment.result import Adjustment, Notice
    from raybundle.block import Block
    from raybundle.metrology.bars import BarTest
    from raybundle.numerics.arrays import Array

BEYOND = 2.0
"""Ratio of the scales of two bars from which on no measurement is made of them: one is in another unit"""
FAR_OFF = 1.05
"""Ratio of the scales of bars and control from which on they are not of one object"""
CONTROL_M = 5e-5
"""Standard deviation of control that states none [m]: that of a good total station or laser tracker at some metres"""
COARSE = 0.02
"""Share of the extent within which control fits a network, to begin with; tests of the adjustment tell the rest"""


def scaled(block: Block, bars: Sequence[tuple[str, str, float, float]]) -> Block:
    """A block in metres with scale bars between its points (A, B, length, sigma [m]).

    raises  InputError for points that the block has not, and for bars of which one is in another unit
    """
    import numpy as np  # noqa: PLC0415

    from raybundle.block import Distances  # noqa: PLC0415
    from raybundle.block.transform import transform_block  # noqa: PLC0415
    from raybundle.numerics.transform import SimilarityTransform  # noqa: PLC0415

    if not bars:
        return block
    place = {name: k for k, name in enumerate(block.points.ids)}
    missing = sorted({p for a, b, _, _ in bars for p in (a, b) if p not in place})
    if missing:
        raise InputError(f"scale bars end at points that were not measured: {', '.join(missing[:10])}")
    start = np.array([place[a] for a, _, _, _ in bars], np.int32)
    end = np.array([place[b] for _, b, _, _ in bars], np.int32)
    length = np.array([bar[2] for bar in bars])
    measured = np.linalg.norm(block.points.xyz[start] - block.points.xyz[end], axis=1)
    if not (measured > 0).all():
        a, b, _, _ = bars[int(np.argmin(measured > 0))]
        raise InputError(f"scale bar {a} - {b}: its ends are one point, or have no coordinates")
    ratio = length / measured
    if not len(block.distances) and not block.points.is_control.any():  # nothing else gives a scale
        middle = float(np.median(ratio))
        same = SimilarityTransform(scale=middle)
        block = replace(transform_block(block, same, observed="stay"), length_unit="m", free_scale=False)
        ratio = ratio / middle
    _check_units(bars, ratio)
    added = Distances(start=start, end=end, length=length, sigma=np.array([bar[3] for bar in bars]))
    return block.adding(added)


def _check_units(bars: Sequence[tuple[str, str, float, float]], ratio: Array) -> None:
    """Raise InputError where a bar makes the network more than `BEYOND` times as large as the others do.

    ratio  (k,) of given and measured lengths
    """
    import numpy as np  # noqa: PLC0415

    if ratio.max() <= BEYOND * ratio.min():
        return
    others = np.array([np.median(np.delete(ratio, k)) for k in range(len(ratio))])
    apart = np.abs(np.log(ratio / others))
    at = range(2) if len(bars) == 2 else [int(apart.argmax())]
    told = "; ".join(
        f"{bars[k][0]} - {bars[k][1]} is given as {bars[k][2]:.6g} m, by "
        f"{'the others' if len(bars) > 2 else f'{bars[1 - k][0]} - {bars[1 - k][1]}'} it is "
        f"{bars[k][2] * others[k] / ratio[k]:.6g} m"
        for k in at
    )
    length = np.array([bar[2] for bar in bars])
    measured = length / ratio
    asked = "Is one in another unit, or between other targets? Scale bars are in metres"
    for a, b in combinations(range(len(bars)), 2):
        order = np.arange(len(bars))
        order[[a, b]] = b, a
        again = length[order] / measured
        if again.max() < FAR_OFF * again.min():
            asked = (
                f"With the lengths of {bars[a][0]} - {bars[a][1]} and {bars[b][0]} - {bars[b][1]} exchanged they "
                "agree: was each given the certificate of the other?"
            )
    raise InputError(
        f"scale bars contradict each other by a factor of {float(ratio.max() / ratio.min()):.3g}: {told}. {asked}"
    )


def with_bars_compared(block: Block, free: Callable[[Block], Adjustment]) -> tuple[Block, BarTest | None]:
    """The block with bars that bend nothing where they contradict each other, and what they make of each other.

    free  an adjustment of the block as a free network, to which bars are compared
    """
    import numpy as np  # noqa: PLC0415

    from raybundle.measuring.point_sets import point_set  # noqa: PLC0415
    from raybundle.metrology.bars import Bar, bars_compared  # noqa: PLC0415

    d = block.distances
    if len(d) < 2:
        return block, None
    ids = block.points.ids
    bars = [
        Bar(start=ids[a], end=ids[b], length=length, sigma=sigma)
        for a, b, length, sigma in zip(
            d.start.tolist(), d.end.tolist(), d.length.tolist(), d.sigma.tolist(), strict=True
        )
    ]
    network = free(block.having(d.rows(np.zeros(0, np.int32))))
    points = point_set(network, "the free network", [p for bar in bars for p in (bar.start, bar.end)])
    test = bars_compared(points, bars)
    if test is None or not test.contradict:
        return block, test
    wide = dict(zip(test.bars, test.sigma.tolist(), strict=True))
    sigma = np.array([wide.get(bar, bar.sigma) for bar in bars])
    return block.having(replace(d, sigma=sigma)), test


def bars_of(block: Block) -> frozenset[frozenset[str]]:
    """The pairs of points between which a distance was observed."""
    ids, d = block.points.ids, block.distances
    return frozenset(frozenset((ids[a], ids[b])) for a, b in zip(d.start.tolist(), d.end.tolist(), strict=True))


def controlled(block: Block, path: Path, unit: float) -> tuple[Block, tuple[Notice, ...]]:
    """A block with control and check points of a file, brought to their axes, and what is to be told.

    unit    metres of one unit of the file
    raises  InputError for fewer than three control points that were measured, and where they fit no network
    """
    import numpy as np  # noqa: PLC0415

    from raybundle.block import Role  # noqa: PLC0415
    from raybundle.block.transform import transform_block  # noqa: PLC0415
    from raybundle.io.geo.control_files import NO_TOLERANCE, ControlDefaults, assumed_words, read_control  # noqa: PLC0415
    from raybundle.metrology.notices import (  # noqa: PLC0415
        control_assumed,
        control_far,
        control_lost,
        control_remarks,
        tolerances_ignored,
    )
    from raybundle.numerics.transform import robust_similarity  # noqa: PLC0415

    usual = ControlDefaults(plan=CONTROL_M / unit, height=CONTROL_M / unit)
    given = read_control(path, defaults=usual)
    place = {name: k for k, name in enumerate(block.points.ids)}
    here = [k for k, name in enumerate(given.ids) if name in place]
    full = [k for k in here if given.role[k] == Role.CONTROL and np.isfinite(given.xyz[k]).all()]
    if len(full) < 3:
        raise InputError(
            f"{len(full)} of {len(given.ids)} points are control with X, Y and Z and were measured; three give a "
            f"datum. Names are the codes of the targets{''.join(f'; {r}' for r in given.remarks)}",
            file=path,
        )
    at = np.array([place[given.ids[k]] for k in full])
    source, target = block.points.xyz[at], unit * given.xyz[full]
    extent = float(np.linalg.norm(np.ptp(target, axis=0)))
    known = len(block.distances) > 0
    fit, fits = robust_similarity(source, target, COARSE * extent)
    if known and abs(np.log(fit.scale)) > np.log(FAR_OFF):
        raise InputError(
            f"the scale bars make the network {1 / fit.scale:.4g} times as large as the control: is one of them in "
            f"another unit? {option('unit')} is that of the file",
            file=path,
        )
    block = replace(transform_block(block, fit, observed="stay"), length_unit="m", free_scale=False)
    apart = (fit.points(source) - target)[fits]
    off = float(np.sqrt((apart**2).sum() / max(3 * len(apart) - 7, 1)))
    assumed = np.ones(len(given.ids), bool) if given.stated is None else ~given.stated
    own, remarks = unit * given.sigma, list(given.remarks)
    told: list[Notice] = [tolerances_ignored(path.name)] if NO_TOLERANCE in remarks else []
    remarks = [r for r in remarks if r != NO_TOLERANCE]
    if assumed[full].any() and off > CONTROL_M:
        own = np.where(assumed[:, None], off, own)
        remarks = [r for r in remarks if assumed_words(usual) not in r]
        told.append(control_assumed(path.name, 1000 * off))
    told += control_remarks(path.name, remarks)
    xyz, sigma, role = block.points.xyz.copy(), block.points.sigma.copy(), np.array(block.points.role)
    for k in here:
        p = place[given.ids[k]]
        ok = np.isfinite(given.xyz[k])
        xyz[p, ok], sigma[p], role[p] = (
            unit * given.xyz[k, ok],
            np.where(ok, own[k], np.nan),
            given.role[k],
        )
    told += control_lost([n for n in given.ids if n not in place])
    told += control_far([given.ids[k] for k, f in zip(full, fits.tolist(), strict=True) if not f])
    return replace(block, points=replace(block.points, xyz=xyz, sigma=sigma, role=role)), tuple(told)
