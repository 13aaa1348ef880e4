"""Accuracy grows with the base-to-depth ratio; normal and convergent pairs."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace
from typing import ClassVar

import numpy as np

from raybundle.numerics.arrays import Array
from raybundle.planning.predicted import Predicted, predicted
from raybundle.planning.rules.networks import IMAGE_SIGMA_PX, Cone, Network, Targets, known_camera, pair
from raybundle.planning.rules.rule import Chart, Curve, Evidence, Figures, Limits, Rule, Words
from raybundle.planning.rules.sources import FRASER_1984, GRANSHAW_1980

DEPTH = 1.5
RATIOS = (0.05, 0.1, 0.2, 0.3, 0.4, 0.6, 0.8, 1.0, 1.4, 2.0)
SEEN_SQUARELY = 1.0
"""Ratio up to which a normal pair shows the whole object in both photographs"""
TARGETS = Targets(size=(0.4, 0.4), depth=0.1, side=6, layers=3)
ANGLES = (10, 20, 30, 45, 60, 75, 90, 105, 120, 140, 160)


class BaseToDepth(Rule):
    """sigma_Z = (D / B) (D / c) sqrt(2) sigma_xy of the normal case, and what convergence makes of it."""

    name = "base-to-depth"
    title = "Base to depth"
    order = 1
    sources = (FRASER_1984, GRANSHAW_1980)
    words = Words(
        statement="The wider the base against the depth, the more accurate are the depths.",
        network=f"Two photographs of 108 targets in a box of {TARGETS.over.removesuffix(' m')} × 0.1 m, 1.5 m away, "
        "the "
        "camera calibrated "
        "(24 megapixels, c = 4000 px), 0.05 px: axes parallel (normal case) or meeting in the middle; orientations "
        "known, or found from the same targets (inner constraints). The law is error propagation of Z = B c / "
        "parallax: sigma_Z = (D / B) (D / c) √2 sigma_xy.",
        finding="sigma Z falls in proportion to the base: to 1 / {normal_gain:.1f} from B/D 0.1 to 1 with parallel "
        "axes, and within {law:.1%} of the law. Finding the orientation from the targets themselves costs "
        "{relative:.0%} of sigma Z. X and Y gain little beyond B/D 0.3. Axes that meet keep the object in both "
        "photographs: beyond B/D 1, where a normal pair no longer sees it all, sigma Z still falls.",
        ends="Depths grow better, X and Y worse, as the angle of the rays opens at a constant distance: the mean of "
        "the three is least at {best_angle:.0f}° between the axes and within 10 % of that from {from_angle:.0f}° to "
        "{to_angle:.0f}°. Not in the figures: that matching natural features fails long before 60°, and that round "
        "targets are seen slantwise.",
        costs="No photograph more: the second is taken {narrow:.2f} m beside the first at B/D 0.1, {wide:.1f} m at 1.",
    )
    example = """from raybundle.planning.rules.networks import Network, Targets, known_camera, pair

targets = Targets(size=(0.4, 0.4), depth=0.1, side=6, layers=3)
network = Network(camera=known_camera(), targets=targets, stations=pair(0.6 * 1.5, 1.5, convergent=True))
print(f"sigma Z {1e6 * network.predicted().rms[2]:.3g}")
"""
    limits: ClassVar[Mapping[str, Limits]] = {
        "normal_gain": (9.5, 10.5),  # ten times the base
        "law": (0.0, 0.01),  # the box is 3 % of the depth to either side, its square is what is left
        "relative": (0.0, 0.2),  # five parameters of relative orientation from 108 points
        "best_angle": (75.0, 120.0),  # of two rays the mean variance is least at a right angle
    }

    def evidence(self) -> Evidence:
        """Pairs over the base, and at a constant distance over the angle."""
        held = {c: [_known(_pair(r, convergent=c)) for r in RATIOS if c or r <= SEEN_SQUARELY] for c in (False, True)}
        free = [_pair(r, convergent=True).predicted() for r in RATIOS]
        ratio = np.array(RATIOS)
        square = ratio[ratio <= SEEN_SQUARELY]
        law = 1e6 / ratio * DEPTH / 4000 * np.sqrt(2) * IMAGE_SIGMA_PX
        normal, meeting, found = (1e6 * np.array([p.rms for p in part]) for part in (held[False], held[True], free))
        turned = 1e6 * np.array([_known(_turned(a)).rms for a in ANGLES])
        mean = np.sqrt(np.mean(turned**2, axis=1))
        angles = np.array(ANGLES, float)
        near = angles[mean < 1.1 * mean.min()]
        at = {r: k for k, r in enumerate(RATIOS)}
        return Evidence(
            charts=(
                Chart(
                    title="Two photographs, base over depth", x_label="base to depth B/D", y_label="sigma [µm]",
                    logarithmic=(True, True),
                    curves=(
                        Curve(name="Z, axes parallel", x=square, y=normal[:, 2]),
                        Curve(name="Z, axes meeting", x=ratio, y=meeting[:, 2]),
                        Curve(name="X, axes parallel", x=square, y=normal[:, 0]),
                        Curve(name="X, axes meeting", x=ratio, y=meeting[:, 0]),
                        Curve(name="law of the normal case", x=ratio, y=law, dashed=True),
                    ),
                ),
                Chart(
                    title="Two photographs, 1.5 m from the middle", x_label="angle between the axes [°]",
                    y_label="sigma [µm]", logarithmic=(False, True),
                    curves=(
                        *(Curve(name=n, x=angles, y=turned[:, k]) for k, n in enumerate("XYZ")),
                        Curve(name="mean", x=angles, y=mean, dashed=True),
                    ),
                ),
            ),
            figures=Figures(
                header=("B/D", "Z parallel [µm]", "Z meeting", "Z, orientation found", "X parallel", "X meeting"),
                rows=tuple(_row(r, at[r], normal, meeting, found) for r in (0.1, 0.3, 0.6, 1.0, 2.0)),
            ),
            numbers={
                "normal_gain": normal[at[0.1], 2] / normal[at[1.0], 2],
                "law": float(np.abs(normal[:, 2] / law[: len(square)] - 1).max()),
                "relative": float((found[:, 2] / meeting[:, 2]).max() - 1),
                "narrow": 0.1 * DEPTH, "wide": DEPTH,
                "best_angle": float(angles[mean.argmin()]), "from_angle": near.min(), "to_angle": near.max(),
            },
        )  # fmt: skip


def _row(ratio: float, k: int, normal: Array, meeting: Array, found: Array) -> tuple[str | float, ...]:
    z, x = (normal[k, 2], normal[k, 0]) if k < len(normal) else (np.nan, np.nan)
    return f"{ratio:g}", z, meeting[k, 2], found[k, 2], x, meeting[k, 0]


def _pair(ratio: float, *, convergent: bool) -> Network:
    stations = pair(ratio * DEPTH, DEPTH, convergent=convergent)
    return Network(camera=known_camera(), targets=TARGETS, stations=stations)


def _turned(angle: float) -> Network:
    stations = Cone(count=2, tilt_deg=angle / 2, distances=(DEPTH,), rolls_deg=(0.0,)).stations()
    return Network(camera=known_camera(), targets=TARGETS, stations=stations)


def _known(network: Network) -> Predicted:
    """With the orientations held."""
    block = network.block()
    held = np.ones(len(block.images), bool)
    return predicted(replace(block, images=replace(block.images, held=held)))
