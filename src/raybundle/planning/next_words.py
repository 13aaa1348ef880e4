"""What is to be done for a proposed photograph, in words that one can follow on site.

Told against the nearest photograph that there is: people on site know where they stood.  Left and right are those of
who takes that photograph; where no vertical is known, or one looks down or up, the picture's edges say what is up.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from raybundle.block.points import automatic
from raybundle.numerics.arrays import Array, Index
from raybundle.numerics.counting import counted, significant
from raybundle.planning.next_best import Chosen
from raybundle.planning.next_plan import NextPlan

SAME = 0.02
"""Of the distance to the object, a shift that nobody notices"""
ALONE = 0.1
"""Of the largest part of a shift, the part that is not said"""
HELD = np.radians(20)
"""Turn about the axis that is as good as none"""
TURNED_DEG = 10.0
"""Between two viewing directions, what is told in degrees"""
SHOWN = 3
"""Points that are named"""
FALLS = 0.9
"""Ratio of standard deviations below which a parameter is named as improved"""


@dataclass(frozen=True, slots=True, kw_only=True)
class Instruction:
    """One photograph in words; each part reads by itself."""

    where: str
    """"stand 3.0 m to the left of photograph 12, 2.0 m higher\""""
    hold: str
    """"hold the camera upright\""""
    aim: str
    """"point T7 in the middle of the picture\""""
    show: str
    """"it must show T1, T2, T7 (and 23 others)\""""
    brings: str
    """"largest sigma 0.31 mm instead of 0.42 mm; T7 from 0.42 to 0.25 mm\""""
    frees: tuple[str, ...]
    """Parameters of the camera that are determined with it and were not before"""

    def __str__(self) -> str:
        """All of it but what it brings."""
        parts = [self.where, self.hold, self.aim, self.show]
        words = "; ".join(p for p in parts if p)
        return words[:1].upper() + words[1:]


def instruction(plan: NextPlan, k: int) -> Instruction:
    """What to do for proposal k."""
    chosen = plan.proposals[k]
    centre, rotation = chosen.photograph.centre[0], chosen.photograph.rotation[0]
    near = nearest_photograph(plan, centre, rotation)
    return Instruction(
        where=where_words(plan, near, centre, plan.towards[k]), hold=hold_words(plan, near, rotation),
        aim=_aim_words(plan, chosen, near, rotation), show=_show_words(plan, chosen), brings=brings_words(plan, chosen),
        frees=freed_by(plan, k),
    )  # fmt: skip


def nearest_photograph(plan: NextPlan, centre: Array, rotation: Array) -> int:
    """Position of the photograph that stands nearest; of those of one place, the one held most alike."""
    block, o = plan.block, plan.block.observations
    seen = np.unique(o.image[plan.outlook.used])
    far = np.linalg.norm(block.images.centre[seen] - centre, axis=1)
    same = seen[far <= far.min() + SAME * _distance(plan, int(seen[far.argmin()]))]
    alike = np.einsum("nij,ij->n", block.images.rotation[same], rotation)
    return int(same[alike.argmax()])


def _distance(plan: NextPlan, image: int) -> float:
    """Median distance of a photograph from what it shows."""
    block, o = plan.block, plan.block.observations
    rows = plan.outlook.used & (o.image == image)
    return float(np.median(np.linalg.norm(block.points.xyz[o.point[rows]] - block.images.centre[image], axis=1)))


def where_words(plan: NextPlan, near: int, centre: Array, towards: Array) -> str:
    """Where the station is, against that of a photograph."""
    name = plan.block.images.ids[near]
    X0, R = plan.block.images.centre[near], plan.block.images.rotation[near]
    distance = _distance(plan, near)
    shift = centre - X0
    if np.linalg.norm(shift) < SAME * distance:
        return f"stand where photograph {name} was taken"
    ahead = -R[2]
    if plan.vertical is None:
        axes, words = (R[0], R[1], ahead), (("right", "left"), ("towards its upper edge", "towards its lower edge"))
    else:
        up = plan.vertical
        level = ahead - (ahead @ up) * up
        level = level if np.linalg.norm(level) > np.sin(HELD) else towards - X0 - ((towards - X0) @ up) * up
        level = level / max(float(np.linalg.norm(level)), 1e-300)
        axes, words = (np.cross(level, up), up, level), (("right", "left"), ("higher", "lower"))
    part = np.array([shift @ a for a in axes])
    least = max(SAME * distance, ALONE * float(np.abs(part).max()))
    unit, said = plan.result.length_unit, list[str]()
    for value, (plus, minus) in zip(part.tolist(), (*words, ("nearer", "farther back")), strict=True):
        if abs(value) >= least:
            much = f"{significant(abs(value), 2)} {unit}" if unit else f"{abs(value) / distance:.2f}"
            said.append(f"{much} {plus if value > 0 else minus}")
    scale = "" if unit else " (1 is the distance from there to the object)"
    if said[0].endswith(("right", "left")):
        first, _, turn = said[0].rpartition(" ")
        return f"stand {', '.join([f'{first} to the {turn} of photograph {name}', *said[1:]])}{scale}"
    if plan.vertical is None:
        return f"from where photograph {name} was taken go {', '.join(said)}{scale}"
    return f"stand {', '.join(said)} than photograph {name}{scale}"


def hold_words(plan: NextPlan, near: int, rotation: Array) -> str:
    """How the camera is turned about its axis."""
    if plan.vertical is not None:
        across, upright = rotation[0] @ plan.vertical, rotation[1] @ plan.vertical
        turn = float(np.arctan2(-across, upright))
        if abs(turn) < HELD:
            return "hold the camera upright"
        if abs(turn) > np.pi - HELD:
            return "hold the camera upside down"
        return (
            f"roll the camera {_turned(turn)} about its viewing axis, its {'right' if turn > 0 else 'left'} side down"
        )
    R, name = plan.block.images.rotation[near], plan.block.images.ids[near]
    x = rotation[0]
    turn = float(np.arctan2(-(x @ R[1]), x @ R[0]))
    if abs(turn) < HELD:
        return f"hold the camera as for photograph {name}"
    if abs(turn) > np.pi - HELD:
        return f"hold the camera upside down against photograph {name}"
    return f"roll the camera {_turned(turn)} about its viewing axis, against photograph {name}"


def _turned(turn: float) -> str:
    angle = abs(float(np.degrees(turn)))
    angle = 90.0 if abs(angle - 90) < np.degrees(HELD) else round(angle / 5) * 5.0
    return f"by {angle:.0f} degrees {'clockwise' if turn > 0 else 'anticlockwise'}"


def _aim_words(plan: NextPlan, chosen: Chosen, near: int, rotation: Array) -> str:
    """Where to look, against a photograph, and what stands in the middle of the picture then, or nearest to it."""
    camera, seen = plan.block.cameras[plan.camera], chosen.photograph
    off = np.linalg.norm(seen.xy_px - np.array([camera.width_px, camera.height_px]) / 2, axis=1)
    k = int(off.argmin())
    place = "in the middle of the picture" if off[k] < 0.1 * camera.width_px else "near the middle of the picture"
    middle = f"{_point(plan, int(seen.point[k]))} {place}"
    x, y, z = plan.block.images.rotation[near] @ -rotation[2]
    aside, up = np.degrees(np.arctan2(x, -z)), np.degrees(np.arctan2(y, np.hypot(x, z)))
    ways = ((aside, "to the right", "to the left"), (up, "up", "down"))
    said = [f"{abs(v):.0f} degrees {plus if v > 0 else minus}" for v, plus, minus in ways if abs(v) > TURNED_DEG]
    if not said:
        return middle
    return f"look {' and '.join(said)} of where photograph {plan.block.images.ids[near]} looks: {middle}"


def shown_points(plan: NextPlan, chosen: Chosen) -> Index:
    """(k,) positions of the points that the photograph is taken for: those that it betters most come first."""
    at = plan.outlook.joint.place(chosen.photograph.point)
    before, after = chosen.std_before[at].max(axis=1), chosen.std_after[at].max(axis=1)
    return chosen.photograph.point[np.argsort(after - before, kind="stable")]


def _show_words(plan: NextPlan, chosen: Chosen) -> str:
    points = shown_points(plan, chosen)
    named = [plan.block.points.ids[p] for p in points.tolist()]
    asked = set(plan.goal.points)
    named = [n for n in named if n in asked] + [n for n in named if n not in asked]
    by_program = automatic(named)
    if by_program.all():
        return f"it shows {counted(len(named), 'tie point')}"
    known = [n for n, of_program in zip(named, by_program.tolist(), strict=True) if not of_program]
    more = len(named) - len(known[:SHOWN])
    return f"it must show {', '.join(known[:SHOWN])}" + (f" (and {more} others)" if more else "")


def _point(plan: NextPlan, point: int) -> str:
    """A point as one finds it: by its name, or by its place in a photograph where a program named it."""
    name = plan.block.points.ids[point]
    if not automatic([name])[0]:
        return f"point {name}"
    o = plan.block.observations
    row = int(np.flatnonzero(plan.outlook.used & (o.point == point))[0])
    x, y = o.xy_px[row]
    return f"what photograph {plan.block.images.ids[o.image[row]]} shows at {x:.0f}, {y:.0f} px"


def brings_words(plan: NextPlan, chosen: Chosen) -> str:
    """What it does to what is to be lowered, and to single points and parameters."""
    said = [f"{goal_words(plan)} {less_words(plan, chosen.before.value, chosen.after.value)}"]
    gone = chosen.std_before.max(axis=1) - chosen.std_after.max(axis=1)
    k = int(gone.argmax())
    if plan.goal.kind != "calibration":
        name = plan.block.points.ids[plan.outlook.joint.points[k]]
        was, now = (float(s[k].max()) for s in (chosen.std_before, chosen.std_after))
        said.append(f"point {name} {less_words(plan, was, now)}")
    parameters = [(s, r) for s, r in parameter_ratios(plan, chosen) if r < FALLS]
    if parameters and plan.goal.kind == "calibration":
        said.append(", ".join(f"{s} {100 * (1 - r):.0f} %" for s, r in parameters[:SHOWN]) + " smaller")
    return "; ".join(said)


def less_words(plan: NextPlan, was: float, now: float) -> str:
    """How a figure falls."""
    words = f"{figure_words(plan, now)} instead of {figure_words(plan, was)}"
    if not np.isfinite(was) or figure_words(plan, now) != figure_words(plan, was):
        return words
    return f"{figure_words(plan, now)}, {100 * (1 - now / was):.1g} % less"


def goal_words(plan: NextPlan) -> str:
    """What is to be lowered."""
    return {
        "worst": "largest sigma", "mean": "mean sigma", "points": "largest sigma of the points asked for",
        "calibration": "largest uncertainty of projection",
    }[plan.goal.kind]  # fmt: skip


def figure_words(plan: NextPlan, value: float) -> str:
    """A figure of what is to be lowered, with its unit."""
    if not np.isfinite(value):
        return "not determinable"
    if plan.goal.kind == "calibration":
        return f"{significant(value, 2)} px"
    unit = plan.result.length_unit
    if unit == "m" and value < 1:
        return f"{significant(1000 * value, 2)} mm"
    return f"{significant(value, 2)} {unit}".rstrip()


def parameter_ratios(plan: NextPlan, chosen: Chosen) -> list[tuple[str, float]]:
    """Parameters of the camera that are estimated, and their standard deviations by those before; the best first."""
    told = [(s, after / before) for s, before, after in _parameters(plan, chosen) if before > 0]
    return sorted(told, key=lambda t: t[1])


def freed_by(plan: NextPlan, k: int) -> tuple[str, ...]:
    """Parameters of which the observations tell more than what one knows of such a camera, from this proposal on."""
    chosen, carried = plan.proposals[k], plan.outlook.carried
    found = list[str]()
    for symbol, before, after in _parameters(plan, chosen):
        # more than half of what is known is then of the observations, and was of what one knows of such a camera
        limit = np.sqrt(plan.outlook.variance * carried.get(symbol, 0.0) / 2)
        if after < limit <= before:
            found.append(symbol)
    return tuple(found)


def _parameters(plan: NextPlan, chosen: Chosen) -> list[tuple[str, float, float]]:
    """Parameters of the camera that are estimated, with their standard deviations without and with a photograph."""
    system = plan.outlook.factored.system
    row = next((r for r in system.interior if r.camera == plan.camera and r.image < 0), None)
    if row is None or row.node < 0 or not row.free:
        return []
    unknowns = system.offsets[row.node] + row.start + np.arange(len(row.free))
    at = plan.outlook.joint.columns[unknowns] - 3 * len(plan.outlook.joint.points)
    before, after = chosen.interior_std_before[at].tolist(), chosen.interior_std_after[at].tolist()
    symbols = [row.model.symbols[i] for i in row.free]
    return list(zip(symbols, before, after, strict=True))
