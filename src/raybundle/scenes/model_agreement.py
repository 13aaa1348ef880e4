"""Agreement of a rigorous model with the vendor's RPC of the same image.

Both come from the same orbit, so that an error of the orbit does not separate them: what does is a rule of the file
that was misread (units, axes, pixel origin), or a damaged file.  The RPC's stated error (ERR_BIAS and ERR_RAND, root
mean squares in metres along one axis) is therefore a generous limit.  Where the RPC states none, the limit is what
aberration and refraction together move in this scene: a vendor may have left out either.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from raybundle.errors import Message, NotSolvable, RaybundleError, Value
from raybundle.numerics.arrays import Array
from raybundle.scenes.rpc import Rpc
from raybundle.scenes.sensor import Rigorous

STEPS = 25
"""Points along each side of the image."""
HEIGHTS = (-0.8, 0.0, 0.8)
"""Heights, as shares of the RPC's range."""
LEAST_PX = 1.0
"""Lowest limit: an RPC approximates its model to some tenths of a pixel, and pixel origins differ by a half or one."""


@dataclass(frozen=True, slots=True, kw_only=True)
class ModelAgreement:
    """Rigorous model minus RPC over the image; infinite where no ray of the rigorous model meets the ground."""

    mean_px: Array
    """(2,) x, y"""
    std_px: Array
    """(2,) x, y"""
    limit_px: float
    stated: bool
    """Whether the limit is the RPC's stated error."""

    @property
    def rms_px(self) -> float:
        """Root mean square distance in the image."""
        return float(np.sqrt(np.sum(self.mean_px**2 + self.std_px**2)))

    @property
    def values(self) -> dict[str, Value]:
        """Those of messages."""
        rms = self.rms_px
        return {
            "meets": bool(np.isfinite(rms)), "rms_px": rms if np.isfinite(rms) else None, "limit_px": self.limit_px,
            "stated": self.stated,
        }  # fmt: skip

    @property
    def contradicts(self) -> bool:
        """Whether the two models cannot be those of one image."""
        return not self.rms_px <= self.limit_px


class ModelsContradict(NotSolvable):
    """Rigorous model and RPC of one file are further apart than the RPC's stated error; carries the figures."""

    def __init__(self, file: object, agreement: ModelAgreement) -> None:
        values: dict[str, Value] = {"scene": str(file), **agreement.values}
        super().__init__(Message(code="scene.models_contradict", values=values))
        self.agreement = agreement


def image_grid(rpc: Rpc, size_px: tuple[int, int]) -> tuple[Array, Array]:
    """Image points (n, 2) over the part of the image that the RPC covers, and their heights (n,) [m]."""
    size = np.minimum(size_px, rpc.image_offset + rpc.image_scale)
    steps = (np.arange(STEPS) + 0.5) / STEPS
    h = rpc.ground_offset[2] + rpc.ground_scale[2] * np.array(HEIGHTS)
    x, y, z = (a.ravel() for a in np.meshgrid(steps * size[0], steps * size[1], h, indexing="ij"))
    return np.stack([x, y], axis=1), z


def model_agreement(line: Rigorous, rpc: Rpc) -> ModelAgreement:
    """Differences of the two models over the image and 80 % of the RPC's heights.

    Limits: how well either is known; they share the errors of their orbit.
    """
    xy, heights = image_grid(rpc, (line.width_px, line.height_px))
    limit, stated = _limit(line, rpc)
    try:
        d = xy - rpc.project(line.localise(xy, heights))
    except RaybundleError:
        d = np.full((1, 2), np.inf)
    if not np.isfinite(d).all():
        nowhere = np.full(2, np.inf)
        return ModelAgreement(mean_px=nowhere, std_px=nowhere, limit_px=limit, stated=stated)
    return ModelAgreement(mean_px=d.mean(axis=0), std_px=d.std(axis=0), limit_px=limit, stated=stated)


def _limit(line: Rigorous, rpc: Rpc) -> tuple[float, bool]:
    """Limit [px], and whether it is the RPC's stated error."""
    error = float(np.hypot(rpc.err_bias_m or 0.0, rpc.err_rand_m or 0.0))
    if error > 0:
        return max(LEAST_PX, float(np.linalg.norm(error / np.linalg.norm(rpc.pixel_on_ground(), axis=1)))), True
    return max(LEAST_PX, _corrections_px(line, float(rpc.ground_offset[2]))), False


def _corrections_px(line: Rigorous, height: float) -> float:
    """Largest displacement [px] in the image by aberration and refraction."""
    size = np.array([line.width_px, line.height_px])
    xy = size * np.array([[0.5, 0.5], [0.1, 0.1], [0.9, 0.1], [0.1, 0.9], [0.9, 0.9]])
    try:
        bare = line.without_corrections().project(line.localise(xy, height))
    except RaybundleError:
        return LEAST_PX
    return float(np.linalg.norm(bare - xy, axis=1).max())
