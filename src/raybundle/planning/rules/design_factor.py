"""q S sigma / sqrt(k) against the full covariance, with q of the usual networks."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass, replace
from typing import ClassVar

import numpy as np

from raybundle.block import Block
from raybundle.numerics.arrays import Array
from raybundle.planning.network.calibration_networks import calibration_camera
from raybundle.planning.predicted import predicted
from raybundle.planning.rules.networks import Cone, Network, Targets, known_camera, on_site, pair, survey
from raybundle.planning.rules.rule import Chart, Curve, Evidence, Figures, Limits, Rule, Words
from raybundle.planning.rules.sources import FRASER_1984
from raybundle.planning.simulate import simulate
from raybundle.planning.synthetic_networks import AerialStrips, Ring, aerial_scene, ring_scene

BOX, FIELD = Targets(size=(0.4, 0.4), depth=0.1, side=6, layers=3), Targets(depth=0.3, side=7, layers=3)
EXPOSURES = (1, 2, 4)


@dataclass(frozen=True, slots=True, kw_only=True)
class Factor:
    """q over the points of a network."""

    each: Array
    """(p,) q of each point, k its number of rays"""
    rays: float
    """Mean number"""

    @property
    def fitted(self) -> float:
        """The q of least squares of the variances in units of (S sigma)^2 / k: root mean square."""
        return float(np.sqrt(np.mean(self.each**2)))

    @property
    def by_station(self) -> float:
        """The same with k = 1, one exposure at each station: what the network as a whole makes of S sigma."""
        return self.fitted / np.sqrt(self.rays)

    def part(self, share: float) -> float:
        """Quantile over the points."""
        return float(np.quantile(self.each, share))


class DesignFactor(Rule):
    """One number for the geometry; how far it may be trusted is how far it differs over the object."""

    name = "design-factor"
    title = "q S sigma / √k"
    order = 10
    sources = (FRASER_1984,)
    words = Words(
        statement="The standard deviation of a coordinate is q S sigma_xy / √k, with the image scale number S and a "
        "factor q of the kind of network.",
        network="q is fitted to the full covariance: root mean square over the points of sigma √k / (S sigma_xy), "
        "sigma the mean of the three axes, S = distance / c at each point. k as rays of a point, as the report of "
        "an adjustment takes it; and with one exposure at each station (k = 1), as networks are planned. Cameras "
        "calibrated unless stated otherwise; inner constraints.",
        finding="A single pair has q = {pair:.2f} (k = 1: {pair_station:.2f}), a ring {ring:.2f} "
        "({ring_station:.2f}), eight convergent stations {convergent:.2f} ({convergent_station:.2f}), an aerial "
        "strip {strip:.2f} ({strip_station:.2f}). Within one network the formula misses single points by little "
        "where the geometry is even (convergent: 80 % of the points within {convergent_low:+.0%} and "
        "{convergent_high:+.0%}), by much where it is not (strip: {strip_low:+.0%} to {strip_high:+.0%}). Two and "
        "four exposures at each station give what √k predicts to {repeated:.1%}; the camera free costs "
        "{self_calibrated:.1%} of q in the convergent network.",
        ends="q is a number of the geometry: a pair of B/D 0.3 has {pair_narrow:.1f}, one of 0.6 {pair:.1f}. It is "
        "one number for three axes: in the pair Z alone has {pair_z:.1f}, X {pair_x:.2f}. In a strip it grows with "
        "the length. Where a parameter is not determinable there is no q at all. Use it to choose among kinds of "
        "networks; a network itself is adjusted, in less than a second.",
        costs="q costs nothing; what it asks for does. Half the sigma by √k is four exposures at each of eight "
        "stations, "
        "{more:.0f} photographs and {minutes:.0f} minutes more; by S it is half the distance.",
    )
    example = """from raybundle.planning.rules.design_factor import factor
from raybundle.planning.rules.networks import Cone, Network, Targets, known_camera

targets = Targets(depth=0.3, side=7, layers=3)
network = Network(camera=known_camera(), targets=targets, stations=Cone(count=8, tilt_deg=35).stations())
print(f"q {factor(network.block()).fitted:.2f}")
"""
    limits: ClassVar[Mapping[str, Limits]] = {
        # on the axis of a normal pair: q^2 = 2 (1 + 2 / (B/D)^2) / 3, that is 2.09 for 0.6 and 3.93 for 0.3; up to a
        # sixth more for the orientation that is found with it
        "pair": (2.0, 2.45),
        "pair_narrow": (3.8, 4.6),
        # rays from all directions: sqrt(3/2) = 1.22; less off the axis, where an image scale is larger by 1 / cos
        "convergent": (1.0, 1.45),
        "ring": (1.0, 1.45),
        "strip": (3.0, 8.0),  # overlapping pairs of B/D 0.4 have 3.0 where orientations are known
        "repeated": (0.0, 0.01),  # k times the observations of known cameras; a hundredth for the datum
        "self_calibrated": (0.0, 0.05),
    }

    def evidence(self) -> Evidence:
        """Q of each network, and the covariance of the convergent one with several exposures."""
        blocks = {name: made() for name, made in NETWORKS.items()}
        found = {name: factor(block) for name, block in blocks.items()}
        convergent, free, pairs = (
            found["8 convergent stations, 35°"],
            found["8 convergent, 35°, self-calibrating"],
            blocks["pair, B/D 0.6"],
        )
        strip, ring, normal = (
            found["aerial strip, 10 photographs"],
            found["ring, 2 × 16 stations"],
            found["pair, B/D 0.6"],
        )
        repeated = [factor(_convergent(count)) for count in EXPOSURES]
        axes = predicted(pairs).rms / predicted(pairs).mean * normal.fitted
        wide = np.linspace(0, 1, 21)
        stations = Cone(count=8).stations()[0]
        return Evidence(
            charts=(
                Chart(
                    title="q over the points of a network", x_label="share of the points [%]", y_label="q (k rays)",
                    logarithmic=(False, True),
                    curves=tuple(
                        Curve(name=name, x=100 * wide, y=np.quantile(f.each, wide)) for name, f in found.items()
                        if name in SHOWN
                    ),
                ),
            ),
            figures=Figures(
                header=("network", "rays", "q (k rays)", "q (k = 1)", "10 % below", "90 % below", "largest"),
                rows=tuple(
                    (name, f.rays, f.fitted, f.by_station, f.part(0.1), f.part(0.9), f.part(1.0))
                    for name, f in found.items()
                ),
                decimals=(1, 2, 2, 2, 2, 2),
            ),
            numbers={
                "pair": normal.fitted, "pair_station": normal.by_station, "pair_narrow": found["pair, B/D 0.3"].fitted,
                "pair_z": axes[2], "pair_x": axes[0], "ring": ring.fitted, "ring_station": ring.by_station,
                "convergent": convergent.fitted, "convergent_station": convergent.by_station,
                "convergent_low": convergent.part(0.1) / convergent.fitted - 1,
                "convergent_high": convergent.part(0.9) / convergent.fitted - 1, "strip": strip.fitted,
                "strip_station": strip.by_station, "strip_low": strip.part(0.1) / strip.fitted - 1,
                "strip_high": strip.part(0.9) / strip.fitted - 1,
                "repeated": max(abs(f.fitted / repeated[0].fitted - 1) for f in repeated),
                "more": 3 * len(stations), "minutes": on_site(np.repeat(stations, 4, axis=0)).minutes
                - on_site(stations).minutes,
                "self_calibrated": free.fitted / convergent.fitted - 1,
            },
        )  # fmt: skip


def factor(block: Block) -> Factor:
    """Q of the points of a block without errors."""
    o, c = block.observations, block.cameras[0]
    distance = np.linalg.norm(block.points.xyz[o.point] - block.images.centre[o.image], axis=1)
    rays = np.bincount(o.point, minlength=len(block.points))
    seen = rays > 0
    scale = np.bincount(o.point, distance, len(rays))[seen] / rays[seen] / c.values["c"]
    sigma_mm = np.sqrt(o.cov_px2[:, 0].mean()) * c.pixel_mm[0]
    sigma = np.sqrt(np.trace(predicted(block).points[seen], axis1=1, axis2=2) / 3)
    return Factor(each=sigma * np.sqrt(rays[seen]) / (scale * sigma_mm), rays=float(rays[seen].mean()))


def _pair(ratio: float, *, convergent: bool = False) -> Block:
    return Network(
        camera=known_camera(), targets=BOX, stations=pair(1.5 * ratio, 1.5, convergent=convergent)
    ).block()  # fmt: skip


def _convergent(exposures: int = 1, tilt: float = 35.0, *, free: bool = False) -> Block:
    """Eight stations with so many exposures each."""
    centre, rotation = (np.repeat(a, exposures, axis=0) for a in Cone(count=8, tilt_deg=tilt).stations())
    camera = calibration_camera() if free else known_camera()
    return Network(camera=camera, targets=FIELD, stations=(centre, rotation)).block()


def _ring() -> Block:
    return simulate(ring_scene(Ring(camera=known_camera(), stations=16, rings=2)), survey()).truth


def _strip(strips: int) -> Block:
    plan = AerialStrips(strips=strips, images_per_strip=10)
    return simulate(aerial_scene(replace(plan, wobble_deg=0.0)), survey(0.3)).truth


NETWORKS: dict[str, Callable[[], Block]] = {
    "pair, B/D 0.3": lambda: _pair(0.3),
    "pair, B/D 0.6": lambda: _pair(0.6),
    "pair, B/D 1.0, axes meeting": lambda: _pair(1.0, convergent=True),
    "ring, 2 × 16 stations": _ring,
    "8 convergent stations, 35°": _convergent,
    "8 convergent stations, 55°": lambda: _convergent(tilt=55.0),
    "8 convergent, 35°, self-calibrating": lambda: _convergent(free=True),
    "aerial strip, 10 photographs": lambda: _strip(1),
    "aerial block, 3 strips of 10": lambda: _strip(3),
}
SHOWN = (
    "pair, B/D 0.6", "ring, 2 × 16 stations", "8 convergent stations, 35°", "aerial strip, 10 photographs",
    "aerial block, 3 strips of 10",
)  # fmt: skip
