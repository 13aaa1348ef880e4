"""The rendered portal as the refinement sees it: one reference, four sources, starts made of the truth."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path

import cv2
import numpy as np

from raybundle.block import Block
from raybundle.surfaces.depths.rays import ReferenceRays
from raybundle.surfaces.depths.refine import PixelGrid, RefineOptions, Source, refine
from raybundle.surfaces.depths.transfer import transfer
from tests.surface.truth import PORTAL, Depths, Portal

REFERENCE, SOURCES = 1, (0, 2, 5, 8)
RANGE = (0.18, 0.45)
"""Inverse depths [1/m]."""
BEYOND = 5.0
"""Standard deviations beyond which a pixel went to another minimum: such are counted apart."""


@dataclass(frozen=True, slots=True, kw_only=True)
class PortalScene:
    block: Block
    reference: np.ndarray
    sources: list[Source]
    depths: Depths
    reach: float
    """Pixels in the most sensitive source for a unit of t"""

    def start(self, grid: PixelGrid, noise_px: float, seed: int = 5) -> np.ndarray:
        """(3, rows, columns): the truth and noise, and slopes of the smoothed truth, which know no details."""
        t = self.depths.t
        known = np.where(np.isfinite(t), t, np.nanmedian(t))
        gy, gx = np.gradient(cv2.GaussianBlur(known, (0, 0), 3))
        at = grid.of(t)
        off = noise_px / self.reach * np.random.default_rng(seed).standard_normal(at.shape)
        return np.stack([at + off, grid.of(gx), grid.of(gy)]).astype(np.float32)


def grey(block: Block, image: int) -> np.ndarray:
    path = PORTAL / "photos" / block.images.file[image]
    return cv2.imread(str(path), cv2.IMREAD_GRAYSCALE | cv2.IMREAD_IGNORE_ORIENTATION).astype(np.float32)


def scene(cache: Path) -> PortalScene:
    cache.mkdir(parents=True, exist_ok=True)
    portal = Portal(cache)
    block = portal.block
    rays = ReferenceRays.of(block, REFERENCE)
    sources = [Source(grey=grey(block, k), transfer=transfer(block, rays, k, RANGE)) for k in SOURCES]
    depths = portal.depths(REFERENCE)
    middle, t = np.array([[800.5, 600.5]]), np.array([np.nanmedian(depths.t)])
    moved = [np.linalg.norm(s.transfer.at(middle, t + 1e-3) - s.transfer.at(middle, t - 1e-3)) / 2e-3 for s in sources]
    return PortalScene(
        block=block, reference=grey(block, REFERENCE), sources=sources, depths=depths, reach=float(np.nanmax(moved))
    )


def added_noise(
    s: PortalScene, grid: PixelGrid, sigma: float, options: RefineOptions | None = None
) -> dict[str, float]:
    """White noise added twice: chi-square of the differences against what is stated, by two sources or more."""
    start, runs = s.start(grid, 0.3), []
    for seed in (1, 2):
        rng = np.random.default_rng(seed)
        more = [
            g + sigma * rng.standard_normal(g.shape).astype(np.float32)
            for g in (s.reference, *(q.grey for q in s.sources))
        ]
        sources = [Source(grey=g, transfer=q.transfer) for g, q in zip(more[1:], s.sources, strict=True)]
        runs.append(refine(more[0], sources, grid, start, options))
    a, b = runs
    several = np.array([int(v).bit_count() for v in a.views.ravel()]).reshape(a.views.shape) >= 2
    same = a.found & b.found & (a.views == b.views) & several
    e2 = (a.t - b.t)[same].astype(float) ** 2
    stated = e2 / sum((sigma / r.contrast) ** 2 * r.noise * r.inflation**2 for r in runs)[same]
    promised = e2 / sum((sigma / r.contrast) ** 2 * r.noise for r in runs)[same]
    return {
        "pixels": int(same.sum()),
        "chi2": round(float(stated[stated < BEYOND**2].mean()), 3),
        "chi2_all": round(float(stated.mean()), 3),
        "beyond_5_sigma": round(float(np.mean(stated >= BEYOND**2)), 5),
        "chi2_without_curvature": round(float(promised[promised < BEYOND**2].mean()), 3),
    }
