"""Accuracy grows with convergence: the camera constant and the object points."""

from __future__ import annotations

from collections.abc import Mapping
from typing import ClassVar

import numpy as np

from raybundle.planning.network.calibration_networks import ROLLS
from raybundle.planning.rules.networks import Cone, Network, Targets, on_site, pixels
from raybundle.planning.rules.rule import Chart, Curve, Evidence, Figures, Limits, Rule, Words
from raybundle.planning.rules.sources import FRASER_1984, GRANSHAW_1980, YORK_1982

TILTS = (3.0, 5.0, 7.5, 10.0, 15.0, 20.0, 30.0, 45.0, 60.0)


class Convergence(Rule):
    """Tilted axes show c from the distance; parallel ones do not."""

    name = "convergence"
    title = "Convergence"
    order = 2
    sources = (FRASER_1984, GRANSHAW_1980, YORK_1982)
    words = Words(
        statement="The more the axes converge, the more accurate are camera constant and object points.",
        network=f"Eight photographs of a flat field of 10 × 10 unknown targets over {Targets().over}, at equal "
        "azimuths "
        "from 1.5 m, "
        "rolled by 0, 90, 180, 270°; 0.05 px, Brown's eight terms free, inner constraints. The tilt is that of the "
        "axes against the normal of the field; opposite axes make twice the angle.",
        finding="From a tilt of 10° to one of 45° sigma c falls to 1 / {c:.1f}, sigma of the object points to "
        "1 / {points:.1f} (Z alone to 1 / {depth:.1f}). Where 10 and 45° are the angles between opposite axes, "
        "sigma c falls to 1 / {c_axes:.1f}.",
        ends="Beyond 45° little is left to gain: from 45 to 60° sigma c falls by {c_beyond:.0%}, the object points by "
        "{points_beyond:.0%}. A field with relief helps c at small tilts, and none helps where all axes are parallel "
        "(see [several distances](#distances)).",
        costs="No photograph more. Eight at a tilt of 45° take {minutes:.1f} minutes, of them {walking:.0f} s on the "
        "way; at 10° it is {less:.0f} s less. The field must be free all round.",
    )
    example = """from raybundle.planning.rules.networks import Cone, Network, pixels

cone = Cone(count=8, tilt_deg=45, rolls_deg=(0, 90, 180, 270))
network = Network(stations=cone.stations())
found = network.predicted()
print(f"sigma c {pixels(found, 'c', network.camera):.3g}, Z {1e6 * found.rms[2]:.3g}")
"""
    limits: ClassVar[Mapping[str, Limits]] = {
        # the perspective of a field of size s at distance D under a tilt t is c (s / D) sin t: c is given by it and by
        # its square, so that the gain lies between sin 45 / sin 10 and the square of that
        "c": (4.07, 16.6),
        "c_axes": (4.39, 19.3),  # the same of 22.5 and 5 degrees
        # k rays of a cone weigh k sin^2 t in Z: sin 45 / sin 10 = 4.07, and more by what sigma c adds at small tilts
        "depth": (4.07, 5.0),
        "points": (2.0, 5.0),  # X and Y gain by c alone
    }

    def evidence(self) -> Evidence:
        """The same network over the tilt."""
        tilts = np.array([*TILTS, 22.5])
        networks = [Network(stations=Cone(count=8, tilt_deg=t, rolls_deg=ROLLS).stations()) for t in tilts]
        results = [n.predicted() for n in networks]
        c, x0 = (
            np.array([pixels(r, s, n.camera) for r, n in zip(results, networks, strict=True)]) for s in ("c", "x0")
        )
        rms = 1e6 * np.array([r.rms for r in results])
        mean = np.sqrt(np.mean(rms**2, axis=1))
        at = {t: k for k, t in enumerate(tilts.tolist())}
        n = len(TILTS)
        steep, gentle = (on_site(networks[at[t]].stations[0]) for t in (45.0, 10.0))
        return Evidence(
            charts=(
                Chart(
                    title="Interior orientation", x_label="tilt of the axes [°]", y_label="sigma [px]",
                    logarithmic=(False, True),
                    curves=(Curve(name="c", x=tilts[:n], y=c[:n]), Curve(name="x0", x=tilts[:n], y=x0[:n])),
                ),
                Chart(
                    title="Object points", x_label="tilt of the axes [°]", y_label="sigma [µm]",
                    logarithmic=(False, True),
                    curves=(Curve(name="Z", x=tilts[:n], y=rms[:n, 2]), Curve(name="X, Y", x=tilts[:n], y=rms[:n, 0])),
                ),
            ),
            figures=Figures(
                header=("tilt", "between axes", "sigma c [px]", "x0", "sigma X, Y [µm]", "Z"),
                rows=tuple(
                    (f"{t:g}°", f"{2 * t:g}°", c[at[t]], x0[at[t]], rms[at[t], 0], rms[at[t], 2])
                    for t in (5.0, 10.0, 20.0, 30.0, 45.0, 60.0)
                ),
            ),
            numbers={
                "c": c[at[10.0]] / c[at[45.0]], "points": mean[at[10.0]] / mean[at[45.0]],
                "depth": rms[at[10.0], 2] / rms[at[45.0], 2], "c_axes": c[at[5.0]] / c[at[22.5]],
                "minutes": steep.minutes, "walking": 60 * steep.minutes - 8 * steep.seconds_per_photograph,
                "less": 60 * (steep.minutes - gentle.minutes),
                "c_beyond": 1 - c[at[60.0]] / c[at[45.0]], "points_beyond": 1 - mean[at[60.0]] / mean[at[45.0]],
            },
        )  # fmt: skip
