"""Self-calibration needs convergent photographs of many targets, well distributed."""

from __future__ import annotations

from collections.abc import Mapping
from typing import ClassVar

import numpy as np

from raybundle.planning.network.calibration_networks import FlatField, calibration_camera, flat_field_scene
from raybundle.planning.predicted import Predicted
from raybundle.planning.rules.networks import Cone, Network, Targets, known_camera, on_site, pixels
from raybundle.planning.rules.rule import Cell, Chart, Curve, Evidence, Figures, Limits, Rule, Words
from raybundle.planning.rules.sources import FRASER_1984, JAMES_2014, YORK_1982

SIDES = (3, 4, 5, 7, 10, 14, 20)
SIZES = (0.2, 0.3, 0.45, 0.6, 0.8, 1.0, 1.2)
MIDDLE = Targets(size=(0.3, 0.3))
FIELDS = {
    **{f"{t.side**2} targets over {t.over}": t for t in (Targets(), Targets(side=20), Targets(side=3))},
    f"100 targets in the middle, {MIDDLE.over}": MIDDLE,
}


class SelfCalibration(Rule):
    """What it costs to leave the camera free, and where it cannot be left free."""

    name = "self-calibration"
    title = "Self-calibration"
    order = 6
    sources = (FRASER_1984, YORK_1982, JAMES_2014)
    words = Words(
        statement="A camera calibrates itself only in a network of convergent photographs of many, well distributed "
        "targets.",
        network="Eight photographs of a flat field, targets in the middles of equal cells, from 1.5 m, rolled by 0 "
        "and 90° in turn, axes 40° against the "
        "normal of the field, or parallel to it and 0.4 m apart; Brown's eight terms free or the camera calibrated; "
        "0.05 px.",
        finding="Convergent, with 100 targets, leaving the camera free costs {cost:.1%} of sigma of the object "
        "points, with 400 {cost_many:.1%}, with 9 {cost_few:.0%}, and then {lost_few:.0f} of the eight terms are "
        "not determinable. Drawn together in the middle of the format, the same 100 targets let the points be as "
        "good, but sigma c is {middle:.1f} times as large, and K2 and K3 are open: such a calibration is of no use "
        "to other photographs. With parallel axes c, x0, y0 and K1 are not determinable, whatever the number of "
        "targets.",
        ends="Nothing here is wrong of the lens model. Where it is, a network that determines its parameters badly "
        "bends the object (a dome over a plane: James and Robson 2014), which no standard deviation of this page "
        "shows.",
        costs="No photograph more: eight convergent ones take {round:.1f} minutes, eight parallel ones {along:.1f}. "
        "400 "
        "targets in place of 100 are paper, not minutes.",
    )
    example = """from raybundle.planning.rules.networks import Cone, Network, Targets, pixels

network = Network(targets=Targets(side=10), stations=Cone(count=8, tilt_deg=40).stations())
found = network.predicted()
print(f"sigma {1e6 * found.mean:.3g}, c {pixels(found, 'c', network.camera):.3g}")
"""
    limits: ClassVar[Mapping[str, Limits]] = {
        "cost": (0.0, 0.05),  # the camera's eight unknowns among 1600 observations: 0.5 %, and more at the edge
        "cost_many": (0.0, 0.0125),  # a quarter of that
        "cost_few": (0.05, 0.5),
        "lost_few": (1.0, 3.0),
        "middle": (
            3.33,
            37.0,
        ),  # c is seen in what the field spans of the format: 1 / 0.3 for c, its cube for K1 beside
        "lost_parallel": (3.0, 8.0),
    }

    def evidence(self) -> Evidence:
        """Camera free against camera known, over number and spread of the targets."""
        cone = Cone(count=8, tilt_deg=40.0)
        scene = flat_field_scene(FlatField(tilt_deg=0.0, rolls_deg=(0.0, 90.0), shift=0.4))
        square = (scene.centre, scene.rotation)
        free = calibration_camera()

        def both(targets: Targets, stations: tuple[np.ndarray, np.ndarray]) -> tuple[Predicted, Predicted]:
            known = Network(camera=known_camera(), targets=targets, stations=stations).predicted()
            return known, Network(camera=free, targets=targets, stations=stations).predicted()

        convergent = {name: both(targets, cone.stations()) for name, targets in FIELDS.items()}
        parallel = both(Targets(), square)
        many = [both(Targets(side=s), cone.stations()) for s in SIDES]
        wide = np.array([Targets(size=(s, s)).span[0] for s in SIZES])
        spread = [both(Targets(size=(s, s)), cone.stations()) for s in SIZES]
        cost = {name: b.mean / a.mean - 1 for name, (a, b) in convergent.items()}
        c = {name: pixels(b, "c", free) for name, (_, b) in convergent.items()}
        names = list(FIELDS)
        rows = [_row(f"convergent, {name}", *convergent[name], c[name]) for name in names]
        return Evidence(
            charts=(
                Chart(
                    title="Number of targets, cells of 1 × 1 m", x_label="targets", y_label="sigma [px]",
                    logarithmic=(True, True),
                    curves=tuple(
                        Curve(
                            name=s, x=np.array(SIDES, float) ** 2,
                            y=np.array([pixels(b, s, free) for _, b in many]),
                        )
                        for s in ("c", "x0")
                    ),
                ),
                Chart(
                    title="Spread of 100 targets", x_label="side of what they span [m]", y_label="sigma [px]",
                    logarithmic=(False, True),
                    curves=tuple(
                        Curve(name=s, x=wide, y=np.array([pixels(b, s, free) for _, b in spread]))
                        for s in ("c", "x0")
                    ),
                ),
            ),
            figures=Figures(
                header=("network", "camera known [µm]", "camera free", "sigma c [px]", "not determinable"),
                rows=(*rows, _row(f"parallel, {names[0]}", *parallel, float("nan"))),
            ),
            numbers={
                "cost": cost[names[0]], "cost_many": cost[names[1]], "cost_few": cost[names[2]],
                "lost_few": len(convergent[names[2]][1].lost), "middle": c[names[3]] / c[names[0]],
                "lost_parallel": len(parallel[1].lost), "round": on_site(cone.stations()[0]).minutes,
                "along": on_site(scene.centre).minutes,
            },
        )  # fmt: skip


def _row(name: str, known: Predicted, free: Predicted, c: float) -> tuple[Cell, ...]:
    lost = ", ".join(s for _, s in free.lost)
    return name, 1e6 * known.mean, float("nan") if "c" in lost else 1e6 * free.mean, c, lost or "none"
