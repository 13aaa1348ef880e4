"""What gives a measurement its scale and axes: scale bars, held against each other, and control."""

from __future__ import annotations

from collections.abc import Callable, Collection, Mapping, Sequence
from dataclasses import replace
from itertools import combinations
from pathlib import Path
from typing import TYPE_CHECKING

from raybundle.errors import InputError, code_of, message

if TYPE_CHECKING:
    from raybundle.adjustment.records.notice import Notice
    from raybundle.adjustment.result import Adjustment
    from raybundle.block import Block
    from raybundle.io.geo.control_files import ControlFile
    from raybundle.metrology.bars import BarTest
    from raybundle.metrology.misfit import Misfit
    from raybundle.numerics.arrays import Array

BEYOND = 2.0
"""Ratio of the scales of two bars from which on no measurement is made of them: one is in another unit"""
FAR_OFF = 1.05
"""Ratio of the scales of bars and control from which on they are not of one object"""
CONTROL_M = 5e-5
"""Standard deviation of control that states none [m]: that of a good total station or laser tracker at some metres"""


def scaled(block: Block, bars: Sequence[tuple[str, str, float, float]]) -> Block:
    """A block in metres with scale bars between its points (A, B, length, sigma [m]).

    raises  InputError for points that the block has not, and for bars of which one is in another unit
    """
    import numpy as np

    from raybundle.block import Distances
    from raybundle.block.transform import transform_block
    from raybundle.numerics.transform import SimilarityTransform

    if not bars:
        return block
    place = {name: k for k, name in enumerate(block.points.ids)}
    missing = sorted({p for a, b, _, _ in bars for p in (a, b) if p not in place})
    if missing:
        raise InputError("length_test.ends_not_measured", points=missing, bars=True)
    for a, b, length, sigma in bars:
        if sigma >= length:
            raise InputError("scale_bar.sigma_too_large", start=a, end=b, length_m=length, sigma_m=sigma)
    start = np.array([place[a] for a, _, _, _ in bars], np.int32)
    end = np.array([place[b] for _, b, _, _ in bars], np.int32)
    length = np.array([bar[2] for bar in bars])
    measured = np.linalg.norm(block.points.xyz[start] - block.points.xyz[end], axis=1)
    if not (measured > 0).all():
        a, b, _, _ = bars[int(np.argmin(measured > 0))]
        raise InputError("scale_bar.no_length", start=a, end=b)
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
    import numpy as np

    if ratio.max() <= BEYOND * ratio.min():
        return
    others = np.array([np.median(np.delete(ratio, k)) for k in range(len(ratio))])
    apart = np.abs(np.log(ratio / others))
    at = range(2) if len(bars) == 2 else [int(apart.argmax())]
    names = [f"{a} - {b}" for a, b, _, _ in bars]
    details = [
        message(
            "scale_bar.given_and_measured", bar=names[k], given_m=bars[k][2], pair=len(bars) == 2, others=names[1 - k],
            measured_m=float(bars[k][2] * others[k] / ratio[k]),
        )
        for k in at
    ]  # fmt: skip
    length = np.array([bar[2] for bar in bars])
    measured = length / ratio
    exchanged: tuple[str, ...] = ()
    for a, b in combinations(range(len(bars)), 2):
        order = np.arange(len(bars))
        order[[a, b]] = b, a
        again = length[order] / measured
        if again.max() < FAR_OFF * again.min():
            exchanged = names[a], names[b]
    first, second = exchanged or ("", "")
    raise InputError(
        "scale_bar.contradict", details=details, factor=float(ratio.max() / ratio.min()), exchanged=bool(exchanged),
        first=first, second=second,
    )  # fmt: skip


def with_bars_compared(block: Block, free: Callable[[Block], Adjustment]) -> tuple[Block, BarTest | None]:
    """The block with bars that bend nothing where they contradict each other, and what they make of each other.

    free  an adjustment of the block as a free network, to which bars are compared
    """
    import numpy as np

    from raybundle.measuring.point_sets import point_set
    from raybundle.metrology.bars import Bar, bars_compared

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


def bar_names(block: Block) -> list[str]:
    """The distances of a block by their ends and lengths: "1 - 20 0.96108 m"."""
    ids, d = block.points.ids, block.distances
    rows = zip(d.start.tolist(), d.end.tolist(), d.length.tolist(), strict=True)
    return [f"{ids[a]} - {ids[b]} {length:.6g} {block.length_unit}" for a, b, length in rows]


def bars_of(block: Block) -> frozenset[frozenset[str]]:
    """The pairs of points between which a distance was observed."""
    ids, d = block.points.ids, block.distances
    return frozenset(frozenset((ids[a], ids[b])) for a, b in zip(d.start.tolist(), d.end.tolist(), strict=True))


def controlled(block: Block, path: Path, unit: float) -> tuple[Block, tuple[Notice, ...]]:
    """A block with control and check points of a file, brought to their axes, and what is to be reported.

    unit    metres of one unit of the file
    raises  InputError for fewer than three control points that were measured, or points in a line
    Control that contradicts the network as a whole (mirrored, another scale, other names) takes no part: nothing that
    was measured is bent by it. A single point that contradicts the others is compared as a check point.
    """
    import numpy as np

    from raybundle.block.transform import transform_block
    from raybundle.io.geo.control_files import ControlDefaults, read_control
    from raybundle.metrology.misfit import in_one_line, misfit
    from raybundle.metrology.misfit_words import control_contradicted, control_wrong
    from raybundle.metrology.notices import (
        control_assumed,
        control_lost,
        control_remarks,
        tolerances_ignored,
    )
    from raybundle.numerics.transform import similarity

    usual = ControlDefaults(plan=CONTROL_M / unit, height=CONTROL_M / unit, unit=_unit_name(unit))
    given = read_control(path, defaults=usual)
    place = {name: k for k, name in enumerate(block.points.ids)}
    full = _measured_control(given, place, path)
    names = [given.ids[k] for k in full]
    source, target = block.points.xyz[[place[n] for n in names]], unit * given.xyz[full]
    if in_one_line(source) or in_one_line(target):
        raise InputError(
            "control.points_in_line",
            n=len(names),
            points=names,
            file=path,
        )
    known = len(block.distances) > 0
    floor = float(np.sqrt(np.mean(np.nan_to_num(unit * given.sigma[full]) ** 2)))
    found = misfit(source, target, scale_sigma=_scale_sigma(block) if known else None, floor=floor)
    _check_scale(found, path)
    against = control_contradicted(found, path.name, names)
    if against:
        turned = similarity(source[found.fits], target[found.fits], scale=1.0 if known else None)
        if not found.mirrored and not found.scattered:
            block = transform_block(block, turned, observed="stay")
        return block, against
    fits = np.ones(len(full), bool) if found.instead else found.fits
    fit = similarity(source[fits], target[fits], scale=None)
    block = replace(transform_block(block, fit, observed="stay"), length_unit="m", free_scale=False)
    off = float(np.sqrt((fit.residuals**2).sum() / max(3 * int(fits.sum()) - 7, 1)))
    assumed = np.ones(len(given.ids), bool) if given.stated is None else ~given.stated
    own, remarks = unit * given.sigma, list(given.remarks)
    reported: list[Notice] = [*control_wrong(found, path.name, names)]
    tolerances = [r for r in remarks if code_of(r) == "control_file.tolerance_unused"]
    reported += [tolerances_ignored(path.name)] if tolerances else []
    remarks = [r for r in remarks if r not in tolerances]
    if assumed[full].any() and off > CONTROL_M:
        own = np.where(assumed[:, None], off, own)
        remarks = [r for r in remarks if code_of(r) != "control_file.sigma_assumed"]
        reported.append(control_assumed(path.name, 1000 * off))
    reported += control_remarks(remarks)
    out = {n for n, f in zip(names, fits.tolist(), strict=True) if not f}
    reported += control_lost([n for n in given.ids if n not in place])
    return _with_control(block, given, unit, own, out), tuple(reported)


def _with_control(block: Block, given: ControlFile, unit: float, own: Array, out: Collection[str]) -> Block:
    """The block with the coordinates of a file; those of `out` are check points."""
    import numpy as np

    from raybundle.block import Role

    place = {name: k for k, name in enumerate(block.points.ids)}
    xyz, sigma, role = block.points.xyz.copy(), block.points.sigma.copy(), np.array(block.points.role)
    for k, name in enumerate(given.ids):
        if name not in place:
            continue
        p, ok = place[name], np.isfinite(given.xyz[k])
        xyz[p, ok], sigma[p] = unit * given.xyz[k, ok], np.where(ok, own[k], np.nan)
        role[p] = Role.CHECK if name in out else given.role[k]
    return replace(block, points=replace(block.points, xyz=xyz, sigma=sigma, role=role))


def _measured_control(given: ControlFile, place: Mapping[str, int], path: Path) -> list[int]:
    """Rows of control with three coordinates that was measured; raises InputError for fewer than three."""
    import numpy as np

    from raybundle.block import Role

    full = [
        k for k, name in enumerate(given.ids)
        if name in place and given.role[k] == Role.CONTROL and np.isfinite(given.xyz[k]).all()
    ]  # fmt: skip
    if len(full) < 3:
        raise InputError(
            "control.too_few_for_datum",
            n=len(full),
            total=len(given.ids),
            file=path,
        )
    return full


def _check_scale(found: Misfit, path: Path) -> None:
    """Raise InputError where control is in another unit than bars."""
    import numpy as np

    from raybundle.metrology.misfit_words import unit_of

    if found.scaled and not found.scattered and abs(np.log(found.factor)) > np.log(FAR_OFF):
        unit = unit_of(found.factor)
        raise InputError(
            "control.other_unit",
            ratio=float(1 / found.factor),
            likely=bool(unit),
            units=unit,
            file=path,
        )


def _scale_sigma(block: Block) -> float:
    """Standard deviation of the scale by the bars of a block, as a share."""
    import numpy as np

    d = block.distances
    return float(1 / np.sqrt(np.sum((d.length / np.maximum(d.sigma, 1e-12)) ** 2)))


def _unit_name(unit: float) -> str:
    return {1.0: "m", 0.01: "cm", 0.001: "mm", 0.0254: "inches"}.get(unit, f"units of {unit:g} m")
