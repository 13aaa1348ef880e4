"""Where the stations of a network should be: the first order of design (Grafarend 1974; Fraser 1984).

Stations are exchanged against candidates until none is better (Fedorov 1972), from several beginnings; then those of
the best networks are moved.  The covariances are those of the adjustment (`planning.network.expected`); what
candidates are tried first is given by the covariances of points whose stations are known.
"""

from __future__ import annotations

import warnings
from collections.abc import Sequence
from dataclasses import dataclass, field

import numpy as np
from threadpoolctl import threadpool_limits

from raybundle.errors import InputError
from raybundle.numerics.arrays import Array
from raybundle.numerics.progress import Progress, silent
from raybundle.planning.network.aims import AimName, aims
from raybundle.planning.network.candidates import Stations, candidate_stations
from raybundle.planning.network.expected import Expected, Networks, Part, Short

SHORT = 10.0
"""Value of a network that is not determined, beyond which each ray that is missing adds 1: more than any logarithm"""
TRIED = 12
"""Candidates of each exchange that are tried exactly"""
UNSEEN = 3.0
"""Standard deviation that stands for a point without rays, in extents of the object"""

TOGETHER = 0.03
"""First steps of all stations at once, in extents of the object and half turns"""


@dataclass(frozen=True, slots=True, kw_only=True)
class Search:
    """How thoroughly is searched; in numbers of trials, so that the answer is the same on every machine."""

    places: int = 400
    beginnings: int = 16
    moved: int = 5
    """Networks whose stations are moved one after the other"""
    moves: int = 2400
    """Of all stations of each of these, and of the best one at the end"""
    together: int = 12000
    """Moves of all stations of the best one together"""
    seed: int = 1


@dataclass(frozen=True, slots=True, kw_only=True)
class Design:
    """A network that was found."""

    stations: Stations
    value: float
    """Logarithm of the figure, of lengths in extents of the object; 10 and more where it is not determined"""
    figure: float
    """That of the aim, as the worst standard deviation of a point [m]; infinite where it is not determined"""
    expected: Expected | None
    tried: int = 0
    history: tuple[tuple[str, float], ...] = field(default=())
    """What was done, and the figure after it [m]"""


class Designer:
    """Networks of one site, compared by one figure."""

    def __init__(self, networks: Networks, aim: AimName = "worst", progress: Progress = silent) -> None:
        """Prepare; `aim` states what counts."""
        self.networks, self.site, self.progress = networks, networks.site, progress
        self.aim = aims[aim]
        self.scale = self.aim.scale(networks)
        self.tried = 0

    def figure(self, parts: Sequence[Part], e: Expected) -> float:
        """The figure of a network, in the unit of the aim."""
        return self.aim.figure(self.networks, parts, e)

    def value(self, parts: Sequence[Part]) -> float:
        """What is made small: see `Design.value`."""
        self.tried += 1
        e = self.networks.expected(parts)
        return SHORT + e.lack if isinstance(e, Short) else float(np.log(self.figure(parts, e) / self.scale))

    def design(self, stations: Stations, history: tuple[tuple[str, float], ...] = ()) -> Design:
        """What a network is worth."""
        parts = self.networks.parts(stations.centre, stations.rotation)
        e = self.networks.expected(parts)
        if isinstance(e, Short):
            return Design(
                stations=stations, value=SHORT + e.lack, figure=np.inf, expected=None, tried=self.tried, history=history
            )
        figure = self.figure(parts, e)
        value = float(np.log(figure / self.scale))
        return Design(stations=stations, value=value, figure=figure, expected=e, tried=self.tried, history=history)


def improved(designer: Designer, start: Stations, search: Search | None = None, count: int | None = None) -> Design:
    """The best network of as many stations that is found, beginning with `start` and from others; never a worse one.

    start   stations where one may stand; may be fewer than `count`, or none
    count   how many stations there are to be; None: as many as in `start`
    raises  InputError where one of `start` stands where one may not, or nothing can be seen from anywhere
    The same arguments give the same stations.  Limits: that there is no better one; how sensitive the
    figure is to stations that are not met exactly.
    """
    with threadpool_limits(1):
        return _improved(designer, start, search or Search(), count or len(start))


def _improved(d: Designer, start: Stations, search: Search, count: int) -> Design:
    wrong = np.flatnonzero(~d.site.may_stand(start.centre)) if len(start) else []
    if len(wrong):
        raise InputError("plan.station_not_allowed", station=wrong[0] + 1)
    given = d.design(start)
    history = [("as given", given.figure)]
    all_ = candidate_stations(d.site, search.places)
    parts = d.networks.parts(all_.centre, all_.rotation)
    V = np.array([p.V for p in parts])
    rng = np.random.default_rng(search.seed)
    found = list[tuple[float, Stations]]()
    for k in range(search.beginnings):
        d.progress("exchanging stations", k / search.beginnings)
        first = start if k == 0 and len(start) else _drawn(d, all_, V, count, rng, k)
        found.append(_exchanged(d, first, all_, parts, V, count))
    found.sort(key=lambda f: f[0])
    history.append(("stations exchanged", _figure(d, found[0][0])))
    moved = list[tuple[float, Stations]]()
    for k, (value, stations) in enumerate(found[: search.moved]):
        d.progress("moving stations", 0.5 * k / search.moved)
        moved.append(_moved(d, stations, value, search.moves, np.random.default_rng([search.seed, k]), 0.1))
    if given.value < SHORT:
        moved.append(_moved(d, start, given.value, search.moves, np.random.default_rng([search.seed, 99]), 0.1))
    value, stations = min(moved, key=lambda f: f[0])
    d.progress("moving stations together", 0.5)
    value, stations = _moved_together(d, stations, value, search.together, search.seed)
    d.progress("moving stations", 0.9)
    value, stations = _moved(d, stations, value, search.moves, np.random.default_rng([search.seed, 100]), 0.02)
    history.append(("stations moved", _figure(d, value)))
    best = d.design(stations, tuple(history))
    return best if best.value <= given.value else given


def _figure(d: Designer, value: float) -> float:
    return float(np.exp(value) * d.scale) if value < SHORT else np.inf


def _rough(d: Designer, V: Array) -> Array:
    """(k,) sums of powers of the points' standard deviations where stations are known; V (k, t, 3, 3)."""
    least = 1 / (UNSEEN * d.site.extent) ** 2
    square = _trace_of_inverse(V, least)
    return np.mean(square ** (d.aim.power / 2), axis=1)


def _trace_of_inverse(V: Array, least: float) -> Array:
    """Traces of the inverses of symmetric matrices (..., 3, 3) with `least` added to their diagonal."""
    a, b, c = (V[..., i, i] + least for i in range(3))
    f, e, g = V[..., 0, 1], V[..., 0, 2], V[..., 1, 2]
    minors = (b * c - g * g) + (a * c - e * e) + (a * b - f * f)
    return minors / (a * (b * c - g * g) - f * (f * c - g * e) + e * (f * g - b * e))


def _drawn(d: Designer, all_: Stations, V: Array, count: int, rng: np.random.Generator, k: int) -> Stations:
    """Stations taken one after the other, each the best of a part of the candidates that is drawn; of all for k = 1."""
    chosen = list[int]()
    base = np.zeros(V.shape[1:])
    for _ in range(count):
        some = np.arange(len(V)) if k == 1 else rng.choice(len(V), max(len(V) // 5, 1), replace=False)
        best = int(some[_rough(d, base + V[some]).argmin()])
        chosen.append(best)
        base = base + V[best]
    return all_.rows(np.array(chosen))


def _exchanged(
    d: Designer, stations: Stations, all_: Stations, parts: list[Part], V: Array, count: int
) -> tuple[float, Stations]:
    """Each station in turn is replaced by the candidate that is best beside the others, until none is better."""
    mine = d.networks.parts(stations.centre, stations.rotation)
    while len(mine) < count:
        best = int(_rough(d, np.sum([p.V for p in mine], axis=0) + V).argmin())
        mine.append(parts[best])
        stations = _and_one(stations, all_, best)
    value, still, k = d.value(mine), 0, 0
    while still < count:
        others = mine[:k] + mine[k + 1 :]
        rough = _rough(d, np.sum([p.V for p in others], axis=0) + V)
        # while points lack rays, those that show most of them come first
        filled = _filled(d, others, parts) if value >= SHORT else np.zeros(len(parts))
        best, at = value, -1
        for c in np.lexsort((rough, -filled))[:TRIED].tolist():
            tried = d.value([*mine[:k], parts[c], *mine[k + 1 :]])
            if tried < best - 1e-6:
                best, at = tried, c
        if at >= 0:
            mine[k] = parts[at]
            stations = stations.with_one(k, all_.centre[at], all_.at[at], float(all_.roll[at]))
            value, still = best, 0
        else:
            still += 1
        k = (k + 1) % count
    return value, stations


def _filled(d: Designer, mine: Sequence[Part], all_: Sequence[Part]) -> Array:
    """(k,) of each candidate how many of the rays it has that points lack in a network."""
    t = len(d.site.points)
    found = np.bincount(np.concatenate([p.points for p in mine]), np.concatenate([p.share for p in mine]), minlength=t)
    lacking = np.maximum(d.networks.least_rays - found, 0)
    return np.array([np.minimum(lacking[p.points], p.share).sum() for p in all_])


def _and_one(stations: Stations, all_: Stations, k: int) -> Stations:
    return Stations(
        centre=np.vstack([stations.centre, all_.centre[k]]), at=np.vstack([stations.at, all_.at[k]]),
        roll=np.append(stations.roll, all_.roll[k]),
    )  # fmt: skip


def _moved(
    d: Designer, stations: Stations, value: float, moves: int, rng: np.random.Generator, step: float
) -> tuple[float, Stations]:
    """Stations moved one after the other by steps that grow with success and shrink without (Rechenberg 1973)."""
    n = len(stations)
    mine = d.networks.parts(stations.centre, stations.rotation)
    size = np.full(n, step)
    span = np.maximum(d.site.access.high - d.site.access.low, 1e-9)
    reach = np.minimum(span, 2 * d.site.extent)
    for m in range(moves):
        k = m % n
        kind = rng.integers(4)
        turn = rng.normal(0, 1, 7) * size[k]
        if kind == 1:
            turn[:3] = 0
        elif kind == 2:
            turn[3:6] = 0
        elif kind == 3:
            turn[:6] *= rng.random(6) < 0.4
        centre = np.clip(stations.centre[k] + turn[:3] * reach, d.site.access.low, d.site.access.high)
        at = stations.at[k] + turn[3:6] * d.site.extent
        roll = float(stations.roll[k] + turn[6] * np.pi)
        if np.linalg.norm(centre - at) < 1e-6 or not d.site.may_stand(centre[None])[0]:
            size[k] *= 0.95
            continue
        tried = Stations(centre=centre[None], at=at[None], roll=np.array([roll]))
        part = d.networks.parts(tried.centre, tried.rotation)[0]
        new = d.value([*mine[:k], part, *mine[k + 1 :]])
        if new < value:
            value, mine[k] = new, part
            stations = stations.with_one(k, centre, at, roll)
            size[k] = min(size[k] * 1.6, 0.5)
        else:
            size[k] = max(size[k] * 0.93, 1e-4)
    return value, stations


def _moved_together(d: Designer, stations: Stations, value: float, trials: int, seed: int) -> tuple[float, Stations]:
    """All stations moved at once, as the worst point wants it: CMA-ES (Hansen 2016)."""
    if not trials:
        return value, stations
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")  # it misses a library for plots
        from cma import CMAEvolutionStrategy
    n, a = len(stations), d.site.access
    reach = np.minimum(np.maximum(a.high - a.low, 1e-9), 2 * d.site.extent)

    def of(x: Array) -> Stations:
        step = x.reshape(n, 7)
        return Stations(
            centre=np.clip(stations.centre + step[:, :3] * reach, a.low, a.high),
            at=stations.at + step[:, 3:6] * d.site.extent, roll=stations.roll + step[:, 6] * np.pi,
        )  # fmt: skip

    def worth(x: Array) -> float:
        s = of(x)
        outside = int((~d.site.may_stand(s.centre)).sum())
        if outside or np.linalg.norm(s.centre - s.at, axis=1).min() < 1e-6:
            return 10 * SHORT + outside
        return d.value(d.networks.parts(s.centre, s.rotation))

    best, x_best = value, np.zeros(7 * n)
    options = {"verbose": -9, "seed": seed, "maxfevals": trials, "tolfun": 1e-7}
    strategy = CMAEvolutionStrategy(x_best, TOGETHER, options)
    while not strategy.stop():
        xs = [np.asarray(x, float) for x in strategy.ask()]
        values = [worth(x) for x in xs]
        strategy.tell(xs, values)
        k = int(np.argmin(values))
        if values[k] < best:
            best, x_best = values[k], xs[k]
        d.progress("moving stations together", 0.5 + 0.4 * strategy.countevals / trials)
    return best, of(x_best)
