"""Errors over their stated standard deviations: what every judge yields."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field, replace

import numpy as np
from numpy.typing import ArrayLike, NDArray

Array = NDArray[np.float64]
OURS = "raybundle"


@dataclass(frozen=True, slots=True, kw_only=True)
class Errors:
    """Errors of one group of coordinates.

    module      of `sets.MODULES`
    label       class of place, kind of quantity; "" where there is only one
    ratio       (n,) error over stated standard deviation, that of the truth included
    sigma       (n,) stated standard deviations, in `unit`
    unit        of sigma; "" where coordinates have several
    coordinate  (n,) names: X, c, K1 ...
    draw        (n,) number of the run; errors of one run are correlated, those of two are not
    joint       of each run the squared error over the whole covariance, and its degrees of freedom
    flagged     whether the result itself warns of these coordinates
    method      raybundle, or the peer whose standard deviations these are
    """

    module: str
    ratio: Array
    sigma: Array
    label: str = ""
    unit: str = ""
    coordinate: Sequence[str] = ()
    draw: NDArray[np.int64] = field(default_factory=lambda: np.zeros(0, np.int64))
    joint: Sequence[tuple[float, int]] = ()
    flagged: bool = False
    method: str = OURS

    def of_one_draw(self) -> Errors:
        """The same where all runs use the same observations, as splits of one set: a whole covariance counts once."""
        if not self.joint:
            return self
        d2, degrees = np.mean(np.array(self.joint, float), axis=0)
        return replace(self, draw=np.zeros(len(self.ratio), np.int64), joint=[(float(d2), round(float(degrees)))])

    def wrong(self, factor: float) -> Errors:
        """The same errors with all stated standard deviations multiplied by a factor."""
        return replace(
            self, ratio=self.ratio / factor, sigma=self.sigma * factor,
            joint=[(d2 / factor**2, d) for d2, d in self.joint],
        )  # fmt: skip


class Collected:
    """Errors by group, gathered run by run."""

    def __init__(self) -> None:
        self.groups: dict[tuple[str, str, str], dict[str, list]] = {}

    def add(
        self, module: str, error: ArrayLike, sigma: ArrayLike, coordinate: Sequence[str], draw: int, *,
        label: str = "", method: str = OURS, unit: str = "", joint: tuple[float, int] | None = None,
    ) -> None:  # fmt: skip
        """Add the errors of one run."""
        e, s = np.atleast_1d(np.asarray(error, float)), np.atleast_1d(np.asarray(sigma, float))
        group = self.groups.setdefault(
            (module, label, method), {"ratio": [], "sigma": [], "coordinate": [], "draw": [], "joint": [], "unit": []}
        )
        group["ratio"].append(e / s)
        group["sigma"].append(s)
        group["coordinate"] += list(coordinate)
        group["draw"].append(np.full(len(e), draw))
        group["unit"].append(unit)
        if joint is not None:
            group["joint"].append(joint)

    def errors(self) -> list[Errors]:
        """All groups."""
        return [
            Errors(
                module=module, label=label, method=method, ratio=np.concatenate(g["ratio"]),
                sigma=np.concatenate(g["sigma"]), coordinate=g["coordinate"], draw=np.concatenate(g["draw"]),
                joint=g["joint"], unit=g["unit"][0],
            )
            for (module, label, method), g in self.groups.items()
        ]  # fmt: skip
