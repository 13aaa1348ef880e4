"""Rendered dots on some of which something lies, and what became of them."""

from dataclasses import dataclass

import numpy as np

from raybundle.targets.centre import DotOutcome
from tests.targets.render import round_cover, shot, straight_cover

WHOLE = 4
"""Every fourth dot is whole."""


@dataclass
class Covered:
    shot: object
    part: float
    """of the circumference that is hidden; 0: nothing"""
    radius: float


def dots(count, seed):
    """Dots of 8 to 40 px, blurs of 0.5 to 1.5 px, tilts to 60 degrees, 5 to 45 % hidden, dark, light and half way."""
    rng = np.random.default_rng(seed)
    for i in range(count):
        radius, tilt, blur, part = (
            rng.uniform(4, 20),
            rng.uniform(0, 60),
            rng.uniform(0.5, 1.5),
            rng.uniform(0.05, 0.45),
        )
        kind = (straight_cover, round_cover)[rng.integers(2)]
        cover = kind(part, rng.uniform(0, 2 * np.pi), (0.0, 1.0, 0.5)[rng.integers(3)]) if i % WHOLE else None
        s = shot(
            rng, radius, np.radians(tilt), size=2 * int(radius * 2.2 + 10), blur=blur, cover=cover,
            inverse=bool(rng.integers(2)), slope=rng.uniform(-0.1, 0.1, 2),
        )  # fmt: skip
        yield Covered(s, part if cover is not None else 0.0, radius)


def measured(fit, count, seed):
    """Of each dot: part hidden, squared error over its covariance (NaN: not measured), outcome, precision [px]."""
    rng = np.random.default_rng(seed + 1)
    rows = []
    for c in dots(count, seed):
        s = c.shot
        d = fit(s.image, s.centre[None] + rng.normal(0, 0.15, (1, 2)), s.ellipse[None] * (1 + rng.normal(0, 0.05)),
                np.array([2.0]))  # fmt: skip
        e, fine = d.xy_px[0] - s.centre, d.outcome[0] == DotOutcome.MEASURED
        square = e @ np.linalg.solve(d.cov_px2[0], e) if fine else np.nan
        rows.append((c.part, square, d.outcome[0], np.sqrt(np.trace(d.cov_px2[0]) / 2)))
    return np.array(rows)
