"""Control that contradicts the rest: which point, whether it can be told from the others, and what hangs on it."""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np
from scipy.special import chdtri

from raybundle.adjustment.engine import open_datum
from raybundle.adjustment.queries import cofactors_with
from raybundle.adjustment.reliability import UNCONTROLLED, rounding
from raybundle.adjustment.result import Adjustment, Notice
from raybundle.block import Block, Role
from raybundle.block.rejection import Rejection, RejectionKind, Rejections
from raybundle.numerics.arrays import Array
from raybundle.numerics.counting import counted_are

SHOWN = 10
REFUTED = 0.99
"""Probability beyond which what another point's error leaves unexplained refutes that error: that of `separability`."""


@dataclass(frozen=True, slots=True, kw_only=True)
class WrongControl:
    """A control point that an adjustment with it rejects."""

    name: str
    tau: float
    """largest of its coordinates' test values; NaN where it is held and its image observations contradict it"""
    others: tuple[str, ...] = ()
    """control points of which one that is wrong would explain that as well"""
    open: tuple[str, ...] = ()
    """of the datum, what nothing determines without it"""
    settled: bool = True
    """whether the adjustment that rejects it has ended"""

    @property
    def may_go(self) -> bool:
        """Whether it is known to be the wrong one, and can be spared."""
        return self.settled and not self.others and not self.open


def worst_control(result: Adjustment) -> tuple[str, float] | None:
    """The control point with the largest test value and that value; None where nothing controls any."""
    worst: tuple[str, float] | None = None
    for g in result.groups:
        if g.kind != "control":
            continue
        t = np.where(g.redundancy > UNCONTROLLED, np.nan_to_num(np.abs(g.t)), 0.0)
        if len(t) and t.max() > (worst[1] if worst else 0.0):
            k = int(t.argmax())
            worst = (g.ids[k], float(t[k]))
    return worst


def contradicted(block: Block, reasons: Rejections) -> tuple[str, float] | None:
    """A held control point whose image observations are rejected one after the other: the point is wrong, not they."""
    blunders = (RejectionKind.BLUNDER,)
    rejected = np.array([r is not None and r.kind in blunders for r in reasons])
    p = len(block.points)
    lost = np.bincount(block.observations.point[rejected], minlength=p)
    rays = np.bincount(block.observations.point, minlength=p)
    held = block.points.is_control.any(axis=1) & (np.nan_to_num(block.points.sigma, nan=1.0) == 0).any(axis=1)
    share = np.where(held & (lost >= 3), lost / np.maximum(rays, 1), 0.0)
    k = int(share.argmax()) if p else 0
    return (block.points.ids[k], float("nan")) if p and share[k] > 0.25 else None


def judged(
    result: Adjustment, suspect: tuple[str, float], free: dict[str, tuple[str, ...]], reasons: Rejections
) -> WrongControl:
    """Whether the suspect may be left out: the adjustment has ended, the point is located, and the datum stays.

    result   of an adjustment in which it takes part, with test values
    suspect  its name and test value, of `worst_control` or `contradicted`
    free     camera id -> free parameters; reasons: of image observations that take no part

    Located: as for rays (`separability.unlocatable`; Förstner 1983), every other control point is refuted: beside it
    let go, this one still contradicts.  What it does not tell: several wrong ones at a time.
    """
    name, tau = suspect
    block, _ = left_out(result.adjusted, name, reasons)
    after = open_datum(block, result.options, free, reasons)
    lost = after if len(after) > len(result.datum_defect) else ()
    others = () if np.isnan(tau) else alternatives(result, name)
    return WrongControl(name=name, tau=tau, others=others, open=lost, settled=result.converged)


def alternatives(result: Adjustment, name: str) -> tuple[str, ...]:
    """Other control points that, were they the wrong ones, would leave nothing against this one; weighted points only.

    Residuals v of weighted coordinates, whitened, have the cofactor Qvv; letting points go takes T = v' Qvv^+ v of them
    from the square sum (Baarda 1968).  Beside point j let go, point i takes T_ij - T_j more, where i is right sigma0^2
    chi-square with rank Qvv_ij - rank Qvv_j degrees of freedom.
    """
    g = next(g for g in result.groups if g.kind == "control")
    work = result.work
    assert work is not None
    assert work.found is not None
    weighted = g.sigma > 0
    index = {n: i for i, n in enumerate(result.given.points.ids)}
    point = np.array([index[n] for n in g.ids])[weighted]
    axis = np.array(["XYZ".index(c) for c in g.component])[weighted]
    sigma, v = g.sigma[weighted], (g.residual / np.where(weighted, g.sigma, 1.0))[weighted] / result.sigma0
    mine = np.flatnonzero(point == index[name])
    columns = cofactors_with(result, point[mine], axis[mine], point, axis) / np.outer(sigma, sigma[mine])
    within = rounding(work.normals, work.state, work.found)
    found: list[str] = []
    for j in dict.fromkeys(point.tolist()):
        if j == index[name]:
            continue
        his = np.flatnonzero(point == j)
        Q = work.found.points_minimal[j][np.ix_(axis[his], axis[his])] / np.outer(sigma[his], sigma[his])
        both = np.block([[columns[mine], columns[his].T], [columns[his], Q]])
        alone, own = _let_go(np.eye(len(his)) - Q, v[his], within)
        T, rank = _let_go(np.eye(len(both)) - both, np.concatenate([v[mine], v[his]]), within)
        more = rank - own
        if more <= 0 or T - alone < float(chdtri(more, 1 - REFUTED)):
            found.append(result.given.points.ids[j])
    return tuple(found)


def _let_go(Q: Array, v: Array, within: float) -> tuple[float, int]:
    """T = v' Q^+ v and the rank of Q, whose eigenvalues below `within` are rounding."""
    values, vectors = np.linalg.eigh(Q)
    told = values > max(within, UNCONTROLLED)
    return float(((vectors[:, told].T @ v) ** 2 / values[told]).sum()), int(told.sum())


def left_out(block: Block, name: str, reasons: Rejections) -> tuple[Block, Rejections]:
    """The block with a control point turned into a check point; a single ray of it tells nothing any more."""
    k = block.points.ids.index(name)
    role = block.points.role.copy()
    role[k] = Role.CHECK
    rays = np.flatnonzero(block.observations.point == k)
    if len(rays) == 1:  # it held the point's image
        lone = Rejection(kind=RejectionKind.SINGLE_RAY)
        reasons = tuple(r or lone if i == rays[0] else r for i, r in enumerate(reasons))
    return replace(block, points=replace(block.points, role=role)), reasons


def _how(wrong: WrongControl) -> str:
    return "its image observations contradict it" if np.isnan(wrong.tau) else f"tau {wrong.tau:.1f}"


def rejected_notice(wrong: WrongControl) -> Notice:
    """The fault of a point that was left out."""
    return Notice(
        code="control_rejected",
        message=f"control point {wrong.name} contradicts the rest ({_how(wrong)}) and takes no part any more; "
        "look at its coordinates and at its number in the images",
        ids=(wrong.name,),
    )


def kept_notice(wrong: WrongControl) -> Notice:
    """The caution of a point that contradicts the rest and takes part, with why it does."""
    group = (wrong.name, *wrong.others)
    names = ", ".join(group[:SHOWN]) + (" ..." if len(group) > SHOWN else "")
    if wrong.others:
        said = (
            f"{counted_are(len(group), 'control point')} in contradiction: {names} ({_how(wrong)} at {wrong.name}), "
            "and which of them is wrong cannot be told, so all take part"
        )
        remedy = "Look at their coordinates and marks; more control would tell which one it is"
    elif wrong.open:
        said = (
            f"control point {wrong.name} contradicts the rest ({_how(wrong)}) and takes part nevertheless: without it "
            f"nothing determines {', '.join(wrong.open)}"
        )
        remedy = "Look at its coordinates and marks, and measure more control"
    else:
        said = (
            f"control point {wrong.name} contradicts the rest ({_how(wrong)}) in an adjustment that did not end, and "
            "takes part"
        )
        remedy = "Look at its coordinates and marks"
    return Notice(code="control_not_located", message=f"{said}. {remedy}", ids=group[:100])
