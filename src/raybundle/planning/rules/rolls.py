"""Rolls break the coupling of the principal point with the stations."""

from __future__ import annotations

from collections.abc import Mapping
from typing import ClassVar

import numpy as np

from raybundle.planning.network.calibration_networks import ROLLS, FlatField, calibration_camera, flat_field_scene
from raybundle.planning.predicted import Predicted, predicted
from raybundle.planning.rules.networks import Targets, on_site, pixels, survey
from raybundle.planning.rules.rule import Chart, Curve, Evidence, Figures, Limits, Rule, Words
from raybundle.planning.rules.sources import FRASER_1984, YORK_1982
from raybundle.planning.simulate import simulate

NONE = (0.0,)
TWO = (0.0, 90.0)
TILTS = (5.0, 7.5, 10.0, 15.0, 20.0, 30.0, 45.0)


class Rolls(Rule):
    """A shift of the principal point and a turn of the camera look alike until the camera is rolled."""

    name = "rolls"
    title = "Rolls"
    order = 8
    sources = (FRASER_1984, YORK_1982)
    words = Words(
        statement="Photographs rolled by 90° break the coupling of x0, y0 with the stations.",
        network=f"Eight photographs of a flat field of 10 × 10 unknown targets over {Targets().over} from 1.5 m at "
        "equal "
        "azimuths, the camera "
        "never rolled, rolled by 0 and 90°, or by 0, 90, 180 and 270° in turn; 0.05 px, Brown's eight terms free.",
        finding="At a tilt of 20° rolls divide sigma x0 by {x0:.0f} and sigma y0 by {y0:.0f}, at 45° by "
        "{x0_steep:.1f} and {y0_steep:.1f}; with four rolls sigma x0 is {two:.0%} of that with two. The largest "
        "correlation of x0 with an element of an exterior orientation falls from {coupled:.3f} to {parted:.2f}. c "
        "does not change ({c:.3f} times its sigma), X and Y of the object points are {points:.1f} times as accurate.",
        ends="The steeper the axes, the less is left to part. A field with relief or photographs from several "
        "distances part x0 and the stations, too ([several distances](#distances)). Without rolls, walking round "
        "with the upper side of the image to the middle leaves c and y0 open ([calibration "
        "networks](calibration-networks.md)).",
        costs="Nothing where the camera is held otherwise from station to station, as here. A second photograph at "
        "each, "
        "rolled, is {more:.0f} photographs and {minutes:.0f} minutes more.",
    )
    example = """from raybundle.planning.network.calibration_networks import FlatField, flat_field_scene
from raybundle.planning.predicted import predicted
from raybundle.planning.rules.networks import pixels, survey
from raybundle.planning.simulate import simulate

scene = flat_field_scene(FlatField(tilt_deg=20, rolls_deg=(0, 90)))
found = predicted(simulate(scene, survey()).truth)
print(f"sigma x0 {pixels(found, 'x0', scene.camera):.3g}, y0 {pixels(found, 'y0', scene.camera):.3g}")
"""
    limits: ClassVar[Mapping[str, Limits]] = {
        # without rolls x0 shows only in the perspective within a photograph, s / D sin t of the format, to which the
        # coupling adds the same in the turn; with them in opposite turns: sigma x0 is then noise over the root of n
        "x0": (10.0, 40.0),
        "y0": (10.0, 40.0),
        "x0_steep": (2.0, 10.0),
        "y0_steep": (2.0, 10.0),
        "c": (0.99, 1.01),  # at equal azimuths c is not coupled with x0, y0
        "coupled": (0.99, 1.0),
        "parted": (0.0, 0.9),
        "two": (0.5, 1.0),
        "points": (1.5, 5.0),
    }

    def evidence(self) -> Evidence:
        """Rolls over the tilt."""
        camera = calibration_camera()
        rolls = {"never rolled": NONE, "rolled 0, 90°": TWO, "rolled 0, 90, 180, 270°": ROLLS}
        results = {
            (name, t): predicted(simulate(flat_field_scene(FlatField(tilt_deg=t, rolls_deg=r)), survey()).truth)
            for name, r in rolls.items()
            for t in TILTS
        }
        x = np.array(TILTS)
        px = {
            (name, s): np.array([pixels(results[name, t], s, camera) for t in TILTS])
            for name in rolls
            for s in ("c", "x0", "y0")
        }
        at = {t: k for k, t in enumerate(TILTS)}
        none, two, four = rolls
        here = flat_field_scene(FlatField()).centre
        rms = {name: results[name, 20.0].rms for name in rolls}
        return Evidence(
            charts=tuple(
                Chart(
                    title=f"sigma {s}", x_label="tilt of the axes [°]", y_label="sigma [px]", logarithmic=(False, True),
                    curves=tuple(Curve(name=name, x=x, y=px[name, s]) for name in rolls),
                )
                for s in ("x0", "y0")
            ),
            figures=Figures(
                header=("network", "sigma c [px]", "x0", "y0", "sigma X [µm]", "Y", "Z", "largest correlation of x0"),
                rows=tuple(
                    (
                        f"tilt {t:g}°, {name}", *(px[name, s][at[t]] for s in ("c", "x0", "y0")),
                        *(1e6 * results[name, t].rms), _coupling(results[name, t], "x0"),
                    )
                    for t in (10.0, 20.0, 45.0)
                    for name in rolls
                ),
            ),
            numbers={
                "x0": px[none, "x0"][at[20.0]] / px[four, "x0"][at[20.0]],
                "y0": px[none, "y0"][at[20.0]] / px[four, "y0"][at[20.0]],
                "x0_steep": px[none, "x0"][at[45.0]] / px[four, "x0"][at[45.0]],
                "y0_steep": px[none, "y0"][at[45.0]] / px[four, "y0"][at[45.0]],
                "c": px[four, "c"][at[20.0]] / px[none, "c"][at[20.0]],
                "more": len(here), "minutes": on_site(np.repeat(here, 2, axis=0)).minutes - on_site(here).minutes,
                "two": px[four, "x0"][at[20.0]] / px[two, "x0"][at[20.0]],
                "coupled": _coupling(results[none, 20.0], "x0"), "parted": _coupling(results[four, 20.0], "x0"),
                "points": float(np.mean(rms[none][:2]) / np.mean(rms[four][:2])),
            },
        )  # fmt: skip


def _coupling(result: Predicted, symbol: str) -> float:
    """Largest correlation, without its sign, of a camera parameter with an element of an exterior orientation."""
    precision = result.result.precision
    assert precision is not None
    k = precision.parameters["1"].index(symbol)
    return float(np.abs(precision.interior_exterior["1"][:, k]).max())
