"""Accuracy grows with the rays of a point, by the square root beyond four."""

from __future__ import annotations

from collections.abc import Mapping
from typing import ClassVar

import numpy as np

from raybundle.planning.rules.networks import Cone, Network, Targets, known_camera, on_site
from raybundle.planning.rules.rule import Chart, Curve, Evidence, Figures, Limits, Rule, Words
from raybundle.planning.rules.sources import FRASER_1984, YORK_1982

COUNTS = (2, 3, 4, 5, 6, 8, 10, 12, 16)
TARGETS = Targets(depth=0.3, side=7, layers=3)


class Rays(Rule):
    """Up to four rays the geometry gains with their number, beyond it the noise alone."""

    name = "rays"
    title = "Rays"
    order = 3
    sources = (FRASER_1984, YORK_1982)
    words = Words(
        statement="Points are the more accurate the more photographs show them; beyond four rays the gain is small.",
        network=f"147 targets in a box of {TARGETS.over.removesuffix(' m')} × 0.3 m, each on all photographs, which "
        "stand at equal azimuths 1.5 "
        "m away, the axes 35° against the vertical; camera calibrated, 0.05 px, inner constraints.",
        finding="From two rays to four sigma of a coordinate falls to 1 / {two_four:.2f}, from four to eight to 1 / "
        "{four_eight:.3f}: √2, as twice the observations in the same directions do. A fifth photograph brings "
        "{fifth:.0%}, a ninth would bring {ninth:.0%}. What rays bring besides is control of each other: the mean "
        "redundancy number of an image coordinate is {r2:.2f} with two rays, {r4:.2f} with four, {r8:.2f} with "
        "eight, and with two the least is {least2:.2f}: an error along the epipolar line shows nowhere.",
        ends="Rays from where others are already: a second exposure from the same place is worth √2 as well, but "
        "neither opens an angle nor controls what the place has in common. Few rays in a bad geometry gain far more "
        "than √2 by a ray in a new direction (see [base to depth](#base-to-depth)).",
        costs="A photograph for each ray, half a minute and the way: two take {two_minutes:.1f} minutes, four "
        "{four_minutes:.1f}, eight {eight_minutes:.1f}. Half the sigma of four is sixteen: {sixteen_minutes:.1f}.",
    )
    example = """from raybundle.planning.rules.networks import Cone, Network, Targets, known_camera

targets = Targets(depth=0.3, side=7, layers=3)
network = Network(camera=known_camera(), targets=targets, stations=Cone(count=4, tilt_deg=35).stations())
print(f"sigma Z {1e6 * network.predicted().rms[2]:.1f}, mean {1e6 * network.predicted().mean:.1f}")
"""
    limits: ClassVar[Mapping[str, Limits]] = {
        "four_eight": (1.40, 1.43),  # sqrt(2)
        "two_four": (1.43, 2.0),  # more than sqrt(2): the second pair of rays opens the other direction
        "fifth": (0.09, 0.12),  # 1 - sqrt(4 / 5)
        "ninth": (0.05, 0.065),  # 1 - sqrt(8 / 9)
        "least2": (0.0, 1e-3),  # along the epipolar line, which is nearly an axis of the image
        "r4": (0.55, 0.65),  # (2 k - 3) / (2 k) = 0.625, less the share of the orientations
        "r8": (0.75, 0.82),  # 0.8125, the same
    }

    def evidence(self) -> Evidence:
        """The same points seen from two to sixteen stations."""
        results = []
        for count in COUNTS:
            stations = Cone(count=count, tilt_deg=35.0).stations()
            results.append(Network(camera=known_camera(), targets=TARGETS, stations=stations).predicted())
        k = np.array(COUNTS, float)
        rms = 1e6 * np.array([p.rms for p in results])
        mean = np.sqrt(np.mean(rms**2, axis=1))
        redundancy = [p.result.image_observations.redundancy for p in results]
        r, least = np.array([a.mean() for a in redundancy]), np.array([a.min() for a in redundancy])
        at = {n: i for i, n in enumerate(COUNTS)}
        return Evidence(
            charts=(
                Chart(
                    title="Object points", x_label="rays of each point", y_label="sigma [µm]", logarithmic=(True, True),
                    curves=(
                        Curve(name="Z", x=k, y=rms[:, 2]),
                        Curve(name="X", x=k, y=rms[:, 0]),
                        Curve(name="mean of the three", x=k, y=mean),
                        Curve(name="1/√k through four", x=k, y=mean[at[4]] * np.sqrt(4 / k), dashed=True),
                    ),
                ),
                Chart(
                    title="Control of each other", x_label="rays of each point", y_label="redundancy number",
                    curves=(Curve(name="mean", x=k, y=r), Curve(name="least", x=k, y=least)),
                ),
            ),
            figures=Figures(
                header=("rays", "sigma X [µm]", "Y", "Z", "mean", "redundancy number, mean", "least"),
                rows=tuple((str(n), *rms[at[n]], mean[at[n]], r[at[n]], least[at[n]]) for n in (2, 3, 4, 6, 8, 16)),
                decimals=(1, 1, 1, 1, 2, 2),
            ),
            numbers={
                "two_four": mean[at[2]] / mean[at[4]], "four_eight": mean[at[4]] / mean[at[8]],
                "fifth": 1 - mean[at[5]] / mean[at[4]], "ninth": 1 - np.sqrt(8 / 9),
                **{
                    f"{name}_minutes": on_site(Cone(count=n, tilt_deg=35.0).stations()[0]).minutes
                    for name, n in (("two", 2), ("four", 4), ("eight", 8), ("sixteen", 16))
                },
                "r2": r[at[2]], "r4": r[at[4]], "r8": r[at[8]], "least2": least[at[2]],
            },
        )  # fmt: skip
