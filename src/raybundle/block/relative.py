"""Relative aerial control: what GNSS and INS measure of a flight line by the differences between its exposures.

Errors that stay the same along a line, as of a base in another datum, wrong ambiguities or a misalignment that changed
when the aircraft turned, cancel in the differences from one exposure to the next.  Differences g2 - g1, g3 - g2, ... of
positions with independent errors are correlated (tridiagonal covariance s^2 D D'); used with that covariance they give
the normal equations D' (D D')^-1 D / s^2 = (I - 1 1' / n) / s^2: those of the positions themselves with one unknown
shift of the line.  So each line gets an antenna with a free shift (and an IMU with a free misalignment) of its own,
and the statistics stay those of single positions.  Blázquez and Colomina 2012.
"""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from raybundle.block.block import Block, Instrument
from raybundle.errors import InputError
from raybundle.numerics.arrays import Array, Index
from raybundle.platforms import instrument_models

SHIFT, DRIFT = ("sx", "sy", "sz"), ("dx", "dy", "dz")
MISALIGNMENT = ("bx", "by", "bz")


def relative_control(
    block: Block, line: Index, *, drift: bool = False, shift_sigma: tuple[float, float, float] | None = None
) -> Block:
    """The block whose observed positions and attitudes count by their differences along flight lines.

    line    (n,) number of the flight line of each image; -1: its position and attitude are left out
    drift   whether a drift of each line's positions, linear in time, is free as well; without times the images of a
            line count as equally spaced, in their order
    shift_sigma  standard deviations of the shift of a line where no control shows the place of the block; NaN: free
    raises  InputError where no line has two observed images, or with a drift three
    Lever arms stay what they are; where one is estimated, each line then has its own.
    """
    line = np.asarray(line)
    if len(line) != len(block.images):
        raise InputError("flight_line.count", n=len(line), images=len(block.images))
    stations = block.stations.rows(_enough(line[block.stations.image], 3 if drift else 2))
    attitudes = block.attitudes.rows(_enough(line[block.attitudes.image], 2))
    if not len(stations) and not len(attitudes):
        raise InputError("flight_line.too_few_images", least=3 if drift else 2)
    instruments = list(block.instruments)
    taken = {c.id for c in block.parametrised}
    of_station = line[stations.image]
    antenna, imu = np.full(len(stations), -1, np.int32), np.full(len(attitudes), -1, np.int32)
    for n in np.unique(of_station).tolist():
        mine = of_station == n
        before = None if stations.antenna is None else stations.antenna[mine]
        antenna[mine] = len(instruments)
        free = (*SHIFT, *(DRIFT if drift else ()))
        instruments.append(_own(block, "antenna", before, _free(f"line-{n + 1}", taken), free, shift_sigma))
    of_attitude = line[attitudes.image]
    for n in np.unique(of_attitude).tolist():
        mine = of_attitude == n
        before = None if attitudes.imu is None else attitudes.imu[mine]
        imu[mine] = len(instruments)
        instruments.append(_own(block, "imu", before, _free(f"ins-line-{n + 1}", taken), MISALIGNMENT))
    time = stations.time
    if drift:
        time = _times(of_station) if time is None else _centred(time, of_station)
    return replace(block, instruments=tuple(instruments)).having(
        replace(stations, antenna=antenna if len(stations) else None, time=time),
        replace(attitudes, imu=imu if len(attitudes) else None),
    )


def _enough(line: Index, least: int) -> Array:
    """(k,) rows on a line that has so many of them."""
    count = np.bincount(line[line >= 0], minlength=1)
    return (line >= 0) & (count[np.maximum(line, 0)] >= least)


def _own(
    block: Block, model: str, before: Index | None, name: str, free: tuple[str, ...],
    shift_sigma: tuple[float, float, float] | None = None,
) -> Instrument:  # fmt: skip
    """The antenna or IMU of a line, with the values and the lever arm of the one that the line had."""
    start = Instrument(id=name, model=model, values=dict.fromkeys(instrument_models[model].symbols, 0.0))
    used = set() if before is None else set(before.tolist())
    if len(used) > 1:
        raise InputError(
            "flight_line.several_instruments",
            line_name=name,
            names=sorted(block.instruments[k].id if k >= 0 else "-" for k in used),
        )
    if used and (k := used.pop()) >= 0:
        start = replace(block.instruments[k], id=name)
    known = tuple(s for s in start.estimate if s not in free) if isinstance(start.estimate, tuple) else ()
    sigma = {s: v for s, v in start.sigma.items() if s not in {*SHIFT, *DRIFT}}
    observed = {s: v for s, v in zip(SHIFT, shift_sigma or (), strict=False) if v > 0}
    values = {**start.values, **dict.fromkeys(observed, 0.0)}
    return replace(start, estimate=(*known, *free), sigma={**sigma, **observed}, values=values)


def _free(name: str, taken: set[str]) -> str:
    while name in taken:
        name += "_"
    taken.add(name)
    return name


def _times(line: Index) -> Array:
    """Numbers of the rows along their line, about its middle."""
    time = np.zeros(len(line))
    for n in np.unique(line):
        mine = line == n
        time[mine] = np.arange(mine.sum())
    return _centred(time, line)


def _centred(time: Array, line: Index) -> Array:
    """Times about the middle of each line, so that shift and drift are apart."""
    result = np.array(time, float)
    for n in np.unique(line):
        result[line == n] -= result[line == n].mean()
    return result
