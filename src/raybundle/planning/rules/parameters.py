"""Too many parameters weaken weak networks."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace
from typing import ClassVar

import numpy as np

from raybundle.block import Camera
from raybundle.planning.network.calibration_networks import calibration_camera
from raybundle.planning.predicted import Predicted
from raybundle.planning.rules.networks import Cone, Network, Targets, on_site
from raybundle.planning.rules.rule import Chart, Curve, Evidence, Figures, Limits, Rule, Words
from raybundle.planning.rules.sources import ACKERMANN_1980, JAMES_2014

SETS: dict[str, tuple[str, ...]] = {
    "none": (),
    "c": ("c",),
    "c, x0, y0": ("c", "x0", "y0"),
    "and K1": ("c", "x0", "y0", "K1"),
    "and K2, K3": ("c", "x0", "y0", "K1", "K2", "K3"),
    "and P1, P2": ("c", "x0", "y0", "K1", "K2", "K3", "P1", "P2"),
    "and A, S": ("c", "x0", "y0", "K1", "K2", "K3", "P1", "P2", "A", "S"),
}
ROLLED = (0.0, 90.0, 180.0, 270.0)
STRONG = Cone(count=8, tilt_deg=40.0, rolls_deg=ROLLED)
WEAK = Cone(count=4, tilt_deg=12.0, rolls_deg=(0.0,))
RELIEF, FLAT = Targets(side=7, layers=2, depth=0.3), Targets()
NETWORKS = {
    "strong: 8 tilted 40°, rolled, relief 0.3 m": (STRONG, RELIEF),
    "weak: 4 tilted 12°, never rolled, relief 0.3 m": (WEAK, RELIEF),
    "weaker: the same of a flat field": (WEAK, FLAT),
}


class Parameters(Rule):
    """Each parameter that a network hardly determines takes from what it should determine."""

    name = "parameters"
    title = "Number of parameters"
    order = 9
    sources = (ACKERMANN_1980, JAMES_2014)
    words = Words(
        statement="Additional parameters cost a strong network nothing; too many weaken a weak one.",
        network=f"98 targets on two layers 0.3 m apart over {RELIEF.over}, or 100 on a plane over {FLAT.over}, from "
        "1.5 m, "
        "0.05 px, inner "
        "constraints; the parameters of Brown's model are set free in the order of the table.",
        finding="Ten parameters free against none cost the strong network {strong:.1%} of sigma of its object "
        "points, the weak one {weak:.0%} ({weak_plane:.0%} in X and Y). On the flat field x0 and y0 alone make X "
        "and Y {principal:.0f} times as uncertain, and with affinity and shear {lost:.0f} parameters are not "
        "determinable.",
        ends="Parameters that are left out although the lens needs them do not weaken a network, but falsify it; "
        "which belong in is decided by their significance and determinability ([choose "
        "parameters](../how-to/choose-parameters.md)), and by the halves of real photographs ([noise of "
        "photographs](noise-of-photographs.md)).",
        costs="Parameters cost nothing on site. The strong network takes {eight_minutes:.1f} minutes, the weak one "
        "{four_minutes:.1f}.",
    )
    example = """from dataclasses import replace
from raybundle.planning.network.calibration_networks import calibration_camera
from raybundle.planning.rules.networks import Cone, Network, Targets

camera = replace(calibration_camera(), estimate=("c", "x0", "y0"))
weak = Cone(count=4, tilt_deg=12, rolls_deg=(0,))
network = Network(camera=camera, targets=Targets(side=7, layers=2, depth=0.3), stations=weak.stations())
print(f"sigma {1e6 * network.predicted().mean:.3g}")
"""
    limits: ClassVar[Mapping[str, Limits]] = {
        # ten unknowns among 1568 observations: 0.3 %, and more of the lens at the edge of the field
        "strong": (0.0, 0.05),
        # frozen: 0.28 and 1.17, as the covariance of these networks has them
        "weak": (0.2, 0.4),
        "weak_plane": (0.9, 1.5),
        "principal": (10.0, 18.0),  # x0, y0 and the turns are one without rolls; 13.6 as computed
        "lost": (3.0, 3.0),
    }

    def evidence(self) -> Evidence:
        """Three networks over the number of free parameters."""
        results = {
            (name, words): _free(cone, targets, free)
            for name, (cone, targets) in NETWORKS.items()
            for words, free in SETS.items()
        }
        count = np.array([len(free) for free in SETS.values()], float)
        strong, weak, weaker = NETWORKS
        last = list(SETS)[-1]

        def mean(name: str, words: str) -> float:
            p = results[name, words]
            return float("nan") if ("1", "c") in p.lost else 1e6 * p.mean

        def plane(name: str, words: str) -> float:
            return float(np.mean(results[name, words].rms[:2]))

        return Evidence(
            charts=(
                Chart(
                    title="Object points", x_label="free parameters", y_label="sigma, mean of X, Y, Z [µm]",
                    logarithmic=(False, True),
                    curves=tuple(
                        Curve(name=name, x=count, y=np.array([mean(name, words) for words in SETS]))
                        for name in NETWORKS
                    ),
                ),
            ),
            figures=Figures(
                header=("free", "strong [µm]", "weak", "weaker", "not determinable there"),
                rows=tuple(
                    (
                        words, *(mean(name, words) for name in NETWORKS),
                        ", ".join(s for _, s in results[weaker, words].lost) or "none",
                    )
                    for words in SETS
                ),
            ),
            numbers={
                "eight_minutes": on_site(STRONG.stations()[0]).minutes,
                "four_minutes": on_site(WEAK.stations()[0]).minutes,
                "strong": mean(strong, last) / mean(strong, "none") - 1,
                "weak": mean(weak, last) / mean(weak, "none") - 1,
                "weak_plane": plane(weak, last) / plane(weak, "none") - 1,
                "principal": plane(weaker, "c, x0, y0") / plane(weaker, "c"), "lost": len(results[weaker, last].lost),
            },
        )  # fmt: skip


def _free(cone: Cone, targets: Targets, free: tuple[str, ...]) -> Predicted:
    camera: Camera = replace(calibration_camera(), estimate=free)
    return Network(camera=camera, targets=targets, stations=cone.stations()).predicted()
