"""Several distances to a plane field: they help tilted views, and square views not at all."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace
from typing import ClassVar

import numpy as np

from raybundle.planning.network.calibration_networks import ROLLS, FlatField, calibration_camera, flat_field_scene
from raybundle.planning.predicted import Predicted, predicted
from raybundle.planning.rules.networks import Targets, on_site, pixels, survey
from raybundle.planning.rules.rule import Cell, Chart, Curve, Evidence, Figures, Limits, Rule, Words
from raybundle.planning.rules.sources import FRASER_1984
from raybundle.planning.simulate import simulate

ONE, THREE = (1.5,), (1.2, 1.5, 1.8)
TILT = 20.0
TILTS = (5.0, 7.5, 10.0, 15.0, 20.0, 30.0, 45.0)
KNOWN = (1e-2, 3e-3, 1e-3, 3e-4, 1e-4)
"""Standard deviations of known projection centres [m]"""


class Distances(Rule):
    """c and the distance make one scale; a tilt, or distances that are known, part them."""

    name = "distances"
    title = "Several distances"
    order = 7
    sources = (FRASER_1984,)
    words = Words(
        statement="A plane field is photographed from several distances. Square views determine no camera constant "
        "from however many: a tilt, or distances that are known, must come with them.",
        network=f"Eight photographs of a flat field of 10 × 10 unknown targets over {Targets().over}, from 1.5 m, or "
        "from "
        "1.2, 1.5 "
        "and 1.8 m in turn; 0.05 px, Brown's eight terms free. Square views are shifted sideways by 0.1 m. "
        "Projection centres are unknown, or known with a standard deviation.",
        finding="At a tilt of 20° three distances in place of one divide sigma c by {c:.2f}, with rolls or without; "
        "without rolls they divide sigma x0 by {x0:.1f} as well, with them by {x0_rolled:.2f}. Squarely c is not "
        "determinable from one distance nor from three: a longer c and larger distances give the same photographs. "
        "With projection centres known to 1 mm three distances determine c to {known:.1f} px, to 0.1 mm "
        "{known_well:.1f} px; one distance leaves it open even then, as the distance of the plane itself is unknown.",
        ends="Known distances on the field do not help square views: they scale camera and field alike. Nor do three "
        "distances replace a tilt: one distance at 45° gives sigma c = {steep:.2f} px, three at 10° {flat:.2f} px.",
        costs="No photograph more: the same eight, three of them nearer and three farther. At a tilt of 20° the way is "
        "{way:.1f} m in place of {way_one:.1f} m. Known distances cost an instrument.",
    )
    example = """from raybundle.planning.network.calibration_networks import FlatField, flat_field_scene
from raybundle.planning.predicted import predicted
from raybundle.planning.rules.networks import pixels, survey
from raybundle.planning.simulate import simulate

scene = flat_field_scene(FlatField(tilt_deg=20, rolls_deg=(0, 90, 180, 270), distances=(1.2, 1.5, 1.8)))
found = predicted(simulate(scene, survey()).truth)
print(f"sigma c {pixels(found, 'c', scene.camera):.3g}, x0 {pixels(found, 'x0', scene.camera):.3g}")
"""
    limits: ClassVar[Mapping[str, Limits]] = {
        # the distances vary by 13 % (root mean square) about their mean, which parts c from a tilted field's distance;
        # they can at most undo the correlation of the two, and three of eight photographs are nearer, three farther
        "c": (1.2, 3.0),
        "x0": (2.0, 10.0),
        "x0_rolled": (1.0, 1.5),  # what rolls have parted already gains by little
        "lost_one": (1.0, 8.0),
        "lost_three": (1.0, 8.0),
        "known": (7.0, 30.0),  # c times 1 mm over the spread of the distances, over the root of the photographs: 16 px
        "lost_known_one": (1.0, 8.0),
    }

    def evidence(self) -> Evidence:
        """Distances over tilts, and square views with known projection centres."""
        camera = calibration_camera()

        def px(result: Predicted, symbol: str) -> float:
            return pixels(result, symbol, camera)

        tilted = {
            (d, r, t): _flat(FlatField(tilt_deg=t, rolls_deg=r, distances=d))
            for d in (ONE, THREE)
            for r in ((0.0,), ROLLS)
            for t in TILTS
        }
        square = {d: _flat(_square(d)) for d in (ONE, THREE)}
        known = {s: _flat(_square(THREE), station_sigma=s) for s in KNOWN}
        known_one = _flat(_square(ONE), station_sigma=1e-4)
        bars = _flat(_square(THREE), scale_bars=4, scale_bar_sigma=1e-5)
        assert ("1", "c") in bars.lost  # a part of the sentence on where the rule ends
        rows: list[tuple[Cell, ...]] = [
            (
                f"tilt {t:g}°, {'rolls' if r == ROLLS else 'no rolls'}, {'one distance' if d == ONE else 'three'}",
                *(px(tilted[d, r, t], s) for s in ("c", "x0", "y0")), _lost(tilted[d, r, t]),
            )
            for t in (10.0, 20.0, 45.0)
            for r in ((0.0,), ROLLS)
            for d in (ONE, THREE)
        ]  # fmt: skip
        named = {
            "square, one distance": square[ONE], "square, three distances": square[THREE],
            "square, three, four known distances on the field": bars,
            "square, one, projection centres known to 0.1 mm": known_one,
            "square, three, projection centres known to 1 mm": known[1e-3],
            "square, three, projection centres known to 0.1 mm": known[1e-4],
        }  # fmt: skip
        rows += [(name, *(px(p, s) for s in ("c", "x0", "y0")), _lost(p)) for name, p in named.items()]
        x = np.array(TILTS)
        curves = [
            Curve(
                name=f"{symbol}, {'one distance' if d == ONE else 'three'}", x=x,
                y=np.array([px(tilted[d, (0.0,), t], symbol) for t in TILTS]),
            )
            for symbol in ("c", "x0")
            for d in (ONE, THREE)
        ]  # fmt: skip
        at = (ONE, (0.0,), TILT), (THREE, (0.0,), TILT), (ONE, ROLLS, TILT), (THREE, ROLLS, TILT)
        one, three, one_rolled, three_rolled = (tilted[k] for k in at)
        return Evidence(
            charts=(
                Chart(
                    title="Tilted, no rolls", x_label="tilt of the axes [°]", y_label="sigma [px]",
                    logarithmic=(False, True), curves=tuple(curves),
                ),
                Chart(
                    title="Square views from three distances", x_label="sigma of the projection centres [mm]",
                    y_label="sigma [px]", logarithmic=(True, True),
                    curves=tuple(
                        Curve(name=s, x=1000 * np.array(KNOWN), y=np.array([px(known[k], s) for k in KNOWN]))
                        for s in ("c", "x0")
                    ),
                ),
            ),
            figures=Figures(header=("network", "sigma c [px]", "x0", "y0", "not determinable"), rows=tuple(rows)),
            numbers={
                "c": px(one, "c") / px(three, "c"), "x0": px(one, "x0") / px(three, "x0"),
                "x0_rolled": px(one_rolled, "x0") / px(three_rolled, "x0"),
                "lost_one": len(square[ONE].lost), "lost_three": len(square[THREE].lost),
                "way": _way(THREE), "way_one": _way(ONE),
                "known": px(known[1e-3], "c"), "known_well": px(known[1e-4], "c"),
                "lost_known_one": float(("1", "c") in known_one.lost),
                "steep": px(tilted[ONE, ROLLS, 45.0], "c"), "flat": px(tilted[THREE, ROLLS, 10.0], "c"),
            },
        )  # fmt: skip


def _way(distances: tuple[float, ...]) -> float:
    """Through the stations of a tilt of 20 degrees [m]."""
    return on_site(flat_field_scene(FlatField(tilt_deg=TILT, distances=distances)).centre).path_m


def _square(distances: tuple[float, ...]) -> FlatField:
    return FlatField(tilt_deg=0.0, rolls_deg=ROLLS, distances=distances, shift=0.1)


def _flat(plan: FlatField, **known: float) -> Predicted:
    return predicted(simulate(flat_field_scene(plan), replace(survey(), **known)).truth)


def _lost(result: Predicted) -> str:
    return ", ".join(s for _, s in result.lost) or "none"
