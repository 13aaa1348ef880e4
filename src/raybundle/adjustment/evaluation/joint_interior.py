"""The interior orientations of several cameras as one vector, with the covariance that is stated for it.

Whatever is held afterwards follows from it without another adjustment, as far as the adjustment is linear: with the
parameters S held at v, the others are x - Q_S Q_SS^-1 (x_S - v), Q the cofactors of least squares.  The estimates stay
those of least squares under any noise, so that their covariance becomes K C K', K = (I, -Q_S Q_SS^-1), C the one that
is stated (error propagation; Förstner and Wrobel 2016, 2.7).
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace

import numpy as np

from raybundle.adjustment.records.figures import InteriorResult, ParameterResult
from raybundle.adjustment.result import Adjustment
from raybundle.adjustment.statistics.field_system import FieldSystem, field_system, reason_against
from raybundle.adjustment.statistics.fields import FEWEST_DIRECTIONS, Components
from raybundle.adjustment.statistics.interior import plausible_std
from raybundle.adjustment.statistics.noise import components, spread_alone
from raybundle.adjustment.statistics.precision import interior_unknowns
from raybundle.adjustment.statistics.system_state import Work
from raybundle.adjustment.system.datum import Transformation
from raybundle.block import Camera
from raybundle.numerics.arrays import Array, Index

TOGETHER = 16
"""Right sides that the kernels solve at once."""


@dataclass(frozen=True, slots=True, kw_only=True)
class JointInterior:
    """Free parameters of cameras, their values, and their covariances by white noise and as stated."""

    names: tuple[tuple[str, str], ...]
    """(k,) camera and symbol"""
    values: Array
    """(k,)"""
    white: Array
    """(k, k) covariance by white noise: sigma0^2 times the cofactors of least squares"""
    stated: Array
    """(k, k) covariance under the noise that the result states"""
    square_sum: float
    """Weighted square sum of the residuals"""
    redundancy: int
    residuals: int
    """Degrees of freedom of the variance in `stated`: redundancy, or directions in which fields are estimated"""
    smooth_px: float
    """Standard deviation of an image coordinate by smooth errors [px]; 0 under white noise"""
    smooth: bool
    """Whether `stated` is that of noise which is not white"""

    def at(self, names: Sequence[tuple[str, str]]) -> Index:
        """Places of these parameters."""
        return np.array([self.names.index(n) for n in names], np.int64)

    def square(self, names: Sequence[tuple[str, str]], *, white: bool = False) -> float:
        """X' C^-1 x of these parameters: chi-square distributed with as many degrees where they are nil."""
        k = self.at(names)
        return _square(self.values[k], (self.white if white else self.stated)[np.ix_(k, k)])

    def held(self, at: dict[tuple[str, str], float]) -> JointInterior:
        """What is left with these parameters held at these values; sigma0 grows with the square sum."""
        k = self.at([*at])
        rest = np.setdiff1d(np.arange(len(self.names)), k)
        gain = np.linalg.solve(self.white[np.ix_(k, k)], self.white[np.ix_(k, rest)]).T
        K = np.zeros((len(rest), len(self.names)))
        K[np.arange(len(rest)), rest] = 1.0
        K[:, k] = -gain
        step = self.values[k] - np.array([*at.values()])
        before = self.square_sum / max(self.redundancy, 1)
        square_sum, redundancy = (
            self.square_sum + before * _square(step, self.white[np.ix_(k, k)]),
            self.redundancy + len(k),
        )
        growth = square_sum / redundancy / before if before > 0 and self.redundancy > 0 else 1.0
        return replace(
            self, names=tuple(self.names[i] for i in rest), values=self.values[rest] - gain @ step,
            white=growth * (K @ self.white @ K.T), stated=growth * (K @ self.stated @ K.T), square_sum=square_sum,
            redundancy=redundancy,
        )  # fmt: skip


def _square(x: Array, C: Array) -> float:
    """The square x' C^-1 x of x (k,), by standard deviations of one: parameters have many units."""
    s = np.sqrt(np.diagonal(C))
    return float(x / s @ np.linalg.solve(C / np.outer(s, s), x / s))


def joint_interior(result: Adjustment, cameras: Sequence[str], smooth: Smooth | None) -> JointInterior:
    """The free parameters of these cameras, without those that single images have of their own.

    smooth  what the stated covariance contains besides white noise; None: nothing
    Without the normal equations parameters of different cameras count as uncorrelated.
    """
    work = result.handle.work
    rows = [] if work is None else [r for r in work.system.interior if r.node >= 0 and r.image < 0]
    rows = [] if work is None else [r for r in rows if r.key(work.system.block) in cameras]
    interiors = {i.camera: i for i in result.interior if i.image is None and i.camera in cameras and i.free}
    if work is None or work.found is None:
        return _apart(result, interiors)
    names = [(r.key(work.system.block), r.model.symbols[k]) for r in rows for k in r.free]
    values = np.array([interiors[c].parameters[s].value for c, s in names])
    unknowns = np.concatenate([interior_unknowns(work.system, r) for r in rows]) if rows else np.zeros(0, np.int64)
    scale = result.sigma0**2 if np.isfinite(result.sigma0) and result.sigma0 > 0 else 1.0
    white, stated = _covariances(work, unknowns.astype(np.int64), smooth, scale)
    return JointInterior(
        names=tuple(names), values=values, white=white, stated=stated, square_sum=result.weighted_square_sum,
        redundancy=result.redundancy,
        residuals=max(result.redundancy if smooth is None else smooth.components.directions, 1),
        smooth_px=0.0 if smooth is None else smooth.components.smooth_px,
        smooth=smooth is not None,
    )  # fmt: skip


def _apart(result: Adjustment, interiors: dict[str, InteriorResult]) -> JointInterior:
    names = [(c, s) for c, i in interiors.items() for s in i.free]
    C = np.zeros((len(names), len(names)))
    first = 0
    for c, i in interiors.items():
        mine = slice(first, first + len(i.free))
        C[mine, mine] = 0.0 if result.precision is None else result.precision.interior[c]
        first += len(i.free)
    values = np.array([interiors[c].parameters[s].value for c, s in names])
    return JointInterior(
        names=tuple(names),
        values=values,
        white=C,
        stated=C,
        square_sum=result.weighted_square_sum,
        redundancy=result.redundancy,
        residuals=max(result.redundancy, 1),
        smooth_px=0.0,
        smooth=False,
    )


@dataclass(frozen=True, slots=True, kw_only=True)
class Smooth:
    """Smooth errors of a factored block, and their variance components by the residuals."""

    fields: FieldSystem
    components: Components


def smooth_errors(result: Adjustment, known: Components | None = None) -> Smooth | None:
    """Smooth errors that differ from image to image, by the residuals; None where they determine none.

    known  components from residuals of more free parameters
    """
    work = result.handle.work
    if work is None or work.found is None or result.redundancy <= 0:
        return None
    if reason_against(work.system):
        return None
    fields = field_system(work.normals, work.state)
    if not fields.is_finite:
        return None
    estimated = known or components(fields, result.sigma0**2)[0]
    return Smooth(fields=fields, components=estimated) if estimated.directions >= FEWEST_DIRECTIONS else None


def _covariances(work: Work, unknowns: Index, smooth: Smooth | None, variance: float) -> tuple[Array, Array]:
    """Covariances (k, k) of unknowns of nodes by white noise and under fields."""
    assert work.found is not None
    solvers: list[Callable[[Array], Array]] = [work.normals.solved_nodes]
    if smooth is not None:
        parts = smooth.components
        solvers.append(spread_alone(smooth.fields, parts.phi, parts.root(variance)).among_nodes)
    n, k = int(work.system.offsets[-1]), len(unknowns)
    found = list[Array]()
    for solve in solvers:
        C = np.zeros((k, k))
        for first in range(0, k, TOGETHER):
            some = np.arange(first, min(first + TOGETHER, k))
            nodes = np.zeros((n, len(some)))
            nodes[unknowns[some], np.arange(len(some))] = 1.0
            C[:, some] = solve(nodes)[unknowns]
        found.append(variance * _in_datum((C + C.T) / 2, work.found.transformation, unknowns))
    return found[0], found[-1]


def _in_datum(C: Array, change: Transformation | None, unknowns: Index) -> Array:
    """The cofactors in the datum of the result, where a datum can move these unknowns at all."""
    if change is None:
        return C
    G, H = change.nodes[unknowns], change.nodes_h[unknowns]
    return change.apply(C, G, H, G, H) if np.abs(G).max(initial=0.0) > 0 else C


def with_joint(result: Adjustment, joint: JointInterior, *, white: bool = False) -> Adjustment:
    """The result with the interior orientations of a joint one: values, standard deviations, what is determinable."""
    cameras = {c.id: c for c in result.given.cameras}
    C = joint.white if white else joint.stated
    std = dict(zip(joint.names, np.sqrt(np.maximum(np.diagonal(C), 0.0)).tolist(), strict=True))
    value = dict(zip(joint.names, joint.values.tolist(), strict=True))
    known = {c for c, _ in joint.names}

    def of(i: InteriorResult) -> InteriorResult:
        if i.image is not None or i.camera not in known:
            return i
        camera = cameras[i.camera]
        free = tuple(s for s in i.free if (i.camera, s) in std)
        parameters = {
            s: _parameter(p, camera, value[i.camera, s], std[i.camera, s]) if s in free else _held(p, s in i.free)
            for s, p in i.parameters.items()
        }
        return replace(i, parameters=parameters, free=free)

    return replace(
        result, interior=tuple(of(i) for i in result.interior), weighted_square_sum=joint.square_sum,
        redundancy=joint.redundancy,
        sigma0=float(np.sqrt(joint.square_sum / joint.redundancy)) if joint.redundancy > 0 else result.sigma0,
    )  # fmt: skip


def _held(p: ParameterResult, now: bool) -> ParameterResult:  # noqa: FBT001
    return replace(p, std=None, t=None, status="held") if now else p


def _parameter(p: ParameterResult, camera: Camera, value: float, std: float) -> ParameterResult:
    position = camera.sensor.symbols.index(p.symbol)
    size = p.effect_std_px / p.std if p.effect_std_px is not None and p.std else 0.0
    values = camera.parameters.copy()
    values[position] = value
    status = p.status
    if status in ("estimated", "not determinable"):
        effects = np.zeros(len(values))
        effects[position] = size
        limit = plausible_std(camera, values, position, lambda: effects)
        status = "not determinable" if std > limit else "estimated"
    return replace(
        p, value=value, std=std, t=None if p.t is None or not std > 0 else abs(value) / std, status=status,
        effect_px=None if p.effect_px is None else size * abs(value), effect_std_px=size * std,
    )  # fmt: skip
