"""More points bring little in strong networks, and much where they must determine the cameras."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import ClassVar

import numpy as np

from raybundle.numerics.arrays import Array
from raybundle.planning.network.calibration_networks import calibration_camera
from raybundle.planning.rules.networks import Cone, Network, Targets, known_camera
from raybundle.planning.rules.rule import Chart, Curve, Evidence, Figures, Limits, Rule, Words
from raybundle.planning.rules.sources import FRASER_1984, GRANSHAW_1980

SIDES = (3, 4, 5, 7, 10, 15)
"""Targets along a side of each of two layers: 18 to 450."""


@dataclass(frozen=True, slots=True, kw_only=True)
class _Case:
    name: str
    calibrated: bool
    cone: Cone


CASES = (
    _Case(name="8 photographs tilted 40°, calibrated", calibrated=True, cone=Cone(tilt_deg=40.0)),
    _Case(name="8 photographs tilted 40°, self-calibrating", calibrated=False, cone=Cone(tilt_deg=40.0)),
    _Case(
        name="4 photographs tilted 12°, never rolled, self-calibrating", calibrated=False,
        cone=Cone(count=4, tilt_deg=12.0, rolls_deg=(0.0,)),
    ),
)  # fmt: skip


def _targets(side: int) -> Targets:
    return Targets(size=(0.8, 0.8), depth=0.3, side=side, layers=2)


class NumberOfPoints(Rule):
    """A point is as good as its own rays once the cameras are."""

    name = "points"
    title = "Number of points"
    order = 4
    sources = (FRASER_1984, GRANSHAW_1980)
    words = Words(
        statement="In a strong network more points hardly make the points more accurate.",
        network=f"18 to 450 targets on two layers 0.3 m apart, in the middles of cells of 0.8 × 0.8 m (over "
        f"{_targets(SIDES[0]).over} to {_targets(SIDES[-1]).over}), all on all photographs, 0.05 px, inner "
        "constraints; strong: eight photographs with tilted axes and rolls; weak: four, hardly tilted, never rolled.",
        finding="With 25 times as many targets sigma of a coordinate changes by {strong:+.1%} in the strong network "
        "with a calibrated camera, by {strong_free:+.1%} where the camera is calibrated with it, and by "
        "{weak_free:+.0%} in the weak one. What more points do bring is the camera: its sigma c falls to 1 / "
        "{c:.1f}, as their number lets expect (√25 = 5).",
        ends="Few points: with 18, K3 of the strong network is not determinable. Numbers do not mend bad places: "
        "targets in the middle alone leave the lens undetermined (see [self-calibration](#self-calibration)).",
        costs="Following it saves: the {more:.0f} targets between 18 and 450 need not be fixed. Photographs are as "
        "many.",
    )
    example = """from raybundle.planning.rules.networks import Cone, Network, Targets

targets = Targets(size=(0.8, 0.8), depth=0.3, side=5, layers=2)
network = Network(targets=targets, stations=Cone(tilt_deg=40).stations())
print(f"{len(targets.xyz())} targets: sigma {1e6 * network.predicted().mean:.3g}")
"""
    limits: ClassVar[Mapping[str, Limits]] = {
        "strong": (
            -0.05,
            0.05,
        ),  # the orientations' share of a point's variance, some per cent, in one datum or another
        "strong_free": (-0.10, 0.02),
        "weak_free": (-0.8, -0.25),  # what the camera adds is most of it, and falls with 1 / sqrt(points)
        "c": (4.0, 6.0),
    }

    def evidence(self) -> Evidence:
        """Three networks over the number of points."""
        count = np.array([2.0 * s * s for s in SIDES])
        mean, c = list[Array](), list[Array]()
        for case in CASES:
            camera = known_camera() if case.calibrated else calibration_camera()
            results = [
                Network(
                    camera=camera, targets=_targets(s),
                    stations=case.cone.stations(),
                ).predicted()
                for s in SIDES
            ]  # fmt: skip
            mean.append(1e6 * np.array([r.mean for r in results]))
            c.append(np.array([r.std.get((camera.id, "c"), np.nan) / camera.pixel_mm[0] for r in results]))
        change = [m[-1] / m[0] - 1 for m in mean]
        return Evidence(
            charts=(
                Chart(
                    title="Object points", x_label="targets", y_label="sigma, mean of X, Y, Z [µm]",
                    logarithmic=(True, True),
                    curves=tuple(Curve(name=case.name, x=count, y=m) for case, m in zip(CASES, mean, strict=True)),
                ),
                Chart(
                    title="Camera constant", x_label="targets", y_label="sigma c [px]", logarithmic=(True, True),
                    curves=(
                        *(Curve(name=case.name, x=count, y=v) for case, v in zip(CASES[1:], c[1:], strict=True)),
                        Curve(name="1/√targets", x=count, y=c[1][0] * np.sqrt(count[0] / count), dashed=True),
                    ),
                ),
            ),
            figures=Figures(
                header=("targets", "strong, calibrated [µm]", "strong, self-calibrating", "weak, self-calibrating",
                        "sigma c, strong [px]", "weak"),
                rows=tuple((f"{n:.0f}", *(m[k] for m in mean), c[1][k], c[2][k]) for k, n in enumerate(count.tolist())),
            ),
            numbers={
                "strong": change[0], "strong_free": change[1], "weak_free": change[2], "c": c[1][0] / c[1][-1],
                "more": count[-1] - count[0],
            },
        )  # fmt: skip
