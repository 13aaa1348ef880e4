"""`raybundle plan next`: which photographs of a block in hand to take next."""

from __future__ import annotations

import json
from collections.abc import Mapping
from dataclasses import MISSING, dataclass, replace
from pathlib import Path
from typing import TYPE_CHECKING, Any, Literal

from raybundle.errors import InputError, NotSolvable, Text, joined_texts, note, phrase
from raybundle.numerics.progress import Progress, silent
from raybundle.settings import NOT_NEGATIVE, POSITIVE, Range, keywords, made, setting

if TYPE_CHECKING:
    from raybundle.adjustment.result import Adjustment
    from raybundle.io.digits import Digits
    from raybundle.numerics.arrays import Array
    from raybundle.planning.next.goals import For
    from raybundle.planning.next.plan import Conditions, NextPlan

LENGTH = Range(low=0, high=1e9, above=True)
"""A length in the unit of the block"""
ANYWHERE = Range(low=-1e9, high=1e9)


@dataclass(frozen=True, slots=True, kw_only=True)
class NextSettings:
    """How many photographs, what they are to lower, and where one may stand; lengths in the unit of the block."""

    result: Path
    """A result, block or project folder"""
    photographs: int = setting(
        MISSING, "Number of photographs, chosen one after the other.", limits=Range(low=1, high=100)
    )
    out: Path = setting(MISSING, "New folder for the proposals.", metavar="FOLDER")
    aim: Literal["worst", "mean", "calibration"] = setting(
        "worst", "Quantity to minimise. worst: largest sigma of a coordinate. mean: mean sigma. calibration: the "
        "camera's largest uncertainty of projection over the format.",
    )  # fmt: skip
    points: tuple[str, ...] = setting(
        (), "With {aim} worst: count only these points.", metavar="A,B,C,...", joined=True
    )  # fmt: skip
    camera: str = setting("", "Camera of the block for the new photographs.  [default: camera of most photographs]")
    around: float | None = setting(
        None, "Largest distance from the object.  [default: limited by {step} only]", limits=LENGTH
    )
    step: float | None = setting(
        None, "Largest distance from existing stations.  [default: distance of the object]", limits=LENGTH
    )
    heights: tuple[float, float] | None = setting(
        None, "Camera heights above the object's lowest point, for blocks with vertical Z.", metavar="LOW HIGH",
        limits=(ANYWHERE, ANYWHERE),
    )  # fmt: skip
    clearance: float | None = setting(
        None, "Smallest distance from object points.  [default: a tenth of the distance]", limits=NOT_NEGATIVE
    )
    forbid: tuple[tuple[float, float, float, float, float, float], ...] = setting(
        (), "Box without stations. May be repeated.", metavar="X0 Y0 Z0 X1 Y1 Z1",
        limits=(ANYWHERE,) * 6,
    )  # fmt: skip
    incidence: float = setting(75.0, "Largest angle of a ray to the normal [deg].", limits=Range(low=5, high=89))
    f_number: float | None = setting(
        None, "Aperture, for the depth of field; with {focus}.", limits=Range(low=0.5, high=128)
    )
    focus: float | None = setting(None, "Focus distance of the lens.", limits=POSITIVE)
    hidden_by: str | None = setting(
        None, "Object that hides others, in the frame of the block: a kind, mesh, raster or result, as of `plan "
        "network`.",
        metavar="OBJECT",
    )  # fmt: skip
    unit: float = setting(1.0, "Block units per unit of a mesh.", limits=Range(low=1e-9, high=1e9))
    candidates: int = setting(
        1000, "Number of compared stations and camera rotations.", limits=Range(low=3, high=100_000)
    )


@keywords(NextSettings)
def plan_next(
    result: Adjustment | str | Path, out: str | Path | None = None, *, photographs: int = 1,
    progress: Progress = silent, **settings: Any,
) -> NextPlan:  # fmt: skip
    """The next best photographs of a block in hand, each the best after those before it.

    result       an adjustment, or a result, block or project folder, which is adjusted again
    out          new folder: next.csv, next.json, block (the given one and the proposals), network.html; None: nothing
                 is written
    photographs  how many
    settings     as of the command line, by the names of `NextSettings`: aim="calibration"
    raises       InputError where nothing is within reach or seen, for a result without statistics, and for cameras
                 that are no frame cameras; NotSolvable where no photograph within reach lowers anything
    """
    source = Path() if not isinstance(result, (str, Path)) else Path(result)
    s = made(NextSettings, {"result": source, "out": Path(out or ""), "photographs": photographs, **settings})
    given = None if isinstance(result, (str, Path)) else result
    return _run(s, given, write=out is not None, progress=progress)


def run_plan_next(settings: NextSettings, progress: Progress = silent) -> NextPlan:
    """Propose what the settings ask for, and write it."""
    return _run(settings, None, write=True, progress=progress)


def _run(s: NextSettings, given: Adjustment | None, *, write: bool, progress: Progress) -> NextPlan:
    from raybundle.io.folders import check_new_folder
    from raybundle.planning.next import plan as next_plan

    if write:
        check_new_folder(s.out)
    if s.points and s.aim != "worst":
        raise InputError("plan.points_and_aim")
    adjusted = _adjusted(s.result, progress) if given is None else given
    aim: For = "points" if s.points else s.aim
    plan = next_plan.plan_next(adjusted, aim, s.photographs, conditions_of(s, adjusted), s.points, progress)
    if not plan.proposals:
        raise NotSolvable("plan.no_improvement", n=plan.judged)
    if write:
        write_next_plan(plan, s)
    return plan


def _adjusted(folder: Path, progress: Progress) -> Adjustment:
    """The adjustment of a folder; raises InputError for one that is no block, or not adjusted yet."""
    import numpy as np

    from raybundle.io.block.folder import read_block
    from raybundle.measuring.session import block_folder, readjusted
    from raybundle.results.stored_options import made_as

    inner = block_folder(folder)
    block, options = made_as(inner, read_block(inner))
    taken, seen = (np.unique(rows) for rows in (block.observations.image, block.observations.point))
    if not block.images.oriented[taken].all() or not np.isfinite(block.points.xyz[seen]).all():
        raise InputError(
            "block.not_adjusted", file=folder,
        )  # fmt: skip
    return readjusted(block, progress, options)


def conditions_of(s: NextSettings, result: Adjustment) -> Conditions:
    """Where one may stand, and what a photograph shows."""
    import numpy as np

    from raybundle.commands.planning.objects import surface_of
    from raybundle.planning.network.optics import Optics
    from raybundle.planning.next.plan import Conditions, camera_of
    from raybundle.planning.next.stations import Reach

    if s.heights is not None and s.heights[1] < s.heights[0]:
        low, high = s.heights
        raise InputError("site.empty", axis="Z", low_m=float(low), high_m=float(high))
    if (s.f_number is None) != (s.focus is None):
        raise InputError(
            "option.needs",
            setting="f_number" if s.focus is None else "focus",
            other="focus" if s.focus is None else "f_number",
        )
    depth = (0.0, float("inf"))
    k = camera_of(result, result.image_observations.used, s.camera)
    if s.f_number is not None and s.focus is not None:
        metres = METRES_OF.get(result.length_unit)
        if metres is None:
            raise InputError("plan.focus_without_scale")
        camera = result.adjusted.cameras[k]
        c = camera.sensor.camera_constant(camera.parameters)
        near, far = Optics(f_number=s.f_number, focus=s.focus * metres).depth_of_field(c, camera.pixel_mm[0])
        depth = near / metres, far / metres
    boxes = np.sort(np.array(s.forbid, float).reshape(-1, 2, 3), axis=1)
    return Conditions(
        camera=result.given.cameras[k].id, depth=depth, incidence=float(np.radians(s.incidence)),
        surface=None if s.hidden_by is None else surface_of(s.hidden_by, s.unit)[0],
        reach=Reach(
            step=s.step, around=s.around, heights=s.heights, clearance=s.clearance, forbidden=boxes, most=s.candidates
        ),
    )  # fmt: skip


METRES_OF = {"m": 1.0, "mm": 0.001}


def write_next_plan(plan: NextPlan, settings: NextSettings) -> None:
    """Write FOLDER/next.csv, next.json, block and network.html, whole or not at all."""
    from raybundle.io.block.folder import write_block_files
    from raybundle.io.digits import SHORT
    from raybundle.io.digits import reported as in_digits
    from raybundle.io.folders import new_folder
    from raybundle.io.tables import write_table
    from raybundle.planning.next.words import instruction
    from raybundle.report.network.page import Planned, write_network_page
    from raybundle.results.contents import clean
    from raybundle.words import reader

    words = [instruction(plan, k) for k in range(len(plan.proposals))]
    after = plan.adjusted()
    block = plan.extended()
    unit = plan.result.length_unit
    proposed = str(phrase("next_photograph.about", n=len(words)))
    about = f"{block.about}; {proposed}" if block.about else proposed
    reported, columns = next_figures(plan), next_table(plan)
    with new_folder(settings.out) as folder:
        (folder / "block").mkdir()
        write_block_files(replace(block, about=about), folder / "block")
        write_table(folder / "next.csv", columns, next_digits(columns))
        (folder / "next.json").write_text(
            json.dumps(clean(in_digits(reported, SHORT)), indent=1) + "\n", encoding="utf-8"
        )
        n = len(block.images) - len(words)
        planned = Planned(
            covariance=plan.promised(after), proposed=tuple(range(n, n + len(words))), length_unit=unit,
            image_words=("",) * n + tuple(joined_texts(w.text, w.brings) for w in words),
            remarks=(
                *(
                    Text.of(note("next_photograph.proposal", name=name), *w.messages, *w.brings.messages)
                    for name, w in zip(plan.names, words, strict=True)
                ),
                phrase("next_photograph.predicted"),
            ),
        )  # fmt: skip
        write_network_page(after, folder / "network.html", planned, language=reader().language)


def next_table(plan: NextPlan) -> dict[str, Any]:
    """The proposals as columns."""
    import numpy as np

    from raybundle.planning.next.words import instruction, nearest_photograph, shown_points

    chosen, block = plan.proposals, plan.block
    centre = np.array([c.photograph.centre[0] for c in chosen])
    rotation = np.array([c.photograph.rotation[0] for c in chosen])
    words = [instruction(plan, k) for k in range(len(chosen))]
    near = [nearest_photograph(plan, X, R) for X, R in zip(centre, rotation, strict=True)]
    angles = np.degrees(replace(block.images, centre=centre, rotation=rotation).angles)
    before, after = (np.array([getattr(c, n).value for c in chosen]) for n in ("before", "after"))
    return {
        "image": plan.names, **{a: centre[:, k] for k, a in enumerate("XYZ")},
        **{f"at_{a}": plan.towards[:, k] for k, a in enumerate("XYZ")},
        **{f"{a}_deg": angles[:, k] for k, a in enumerate(("omega", "phi", "kappa"))},
        "near": [block.images.ids[k] for k in near],
        "points": np.array([float(len(c.photograph.point)) for c in chosen]),
        "sigma_before": _finite(before), "sigma_after": _finite(after), "gain": 1 - _finite(after) / before,
        "point_before": [_name(plan, c.before.point) for c in chosen],
        "point_after": [_name(plan, c.after.point) for c in chosen],
        "frees": [" ".join(w.frees) for w in words],
        "shows": [" ".join(block.points.ids[p] for p in shown_points(plan, c)[:20].tolist()) for c in chosen],
        "words": [str(w) for w in words],
    }  # fmt: skip


def next_digits(columns: Mapping[str, Any]) -> dict[str, Digits]:
    """The digits of `next_table`: a place to a millionth of its distance, an angle as a level shows it."""
    import numpy as np

    from raybundle.io.digits import COUNT, PROBABILITY, SETTING, STD, of_places

    centre, at = (np.stack([columns[f"{n}{a}"] for a in "XYZ"], axis=1) for n in ("", "at_"))
    place = of_places(centre, at)
    return {
        **{f"{n}{a}": place for n in ("", "at_") for a in "XYZ"},
        **{f"{a}_deg": SETTING for a in ("omega", "phi", "kappa")},
        "points": COUNT, "sigma_before": STD, "sigma_after": STD, "gain": PROBABILITY,
    }  # fmt: skip


def _finite(values: Array) -> Array:
    """An empty cell for what is not determined."""
    import numpy as np

    return np.where(np.isfinite(values), values, np.nan)


def _name(plan: NextPlan, point: int) -> str:
    return plan.block.points.ids[point] if point >= 0 else ""


def next_figures(plan: NextPlan) -> dict[str, Any]:
    """The figures of the proposals, as next.json has them."""
    import numpy as np

    from raybundle.planning.next.words import instruction, parameter_ratios, shown_points

    def figure(value: float) -> float | None:
        return value if np.isfinite(value) else None

    def reported(k: int) -> dict[str, Any]:
        c, w = plan.proposals[k], instruction(plan, k)
        ranked = c.ranked[np.isfinite(c.ranked)]
        return {
            "image": plan.names[k],
            "centre": c.photograph.centre[0].tolist(),
            "rotation": c.photograph.rotation[0].tolist(),
            "at": plan.towards[k].tolist(),
            "words": str(w),
            "brings": w.brings,
            "before": figure(c.before.value),
            "after": figure(c.after.value),
            "frees": list(w.frees),
            "parameters": dict(parameter_ratios(plan, c)),
            "shows": [plan.block.points.ids[p] for p in shown_points(plan, c).tolist()],
            "median_candidate": figure(float(np.median(ranked))) if len(ranked) else None,
        }

    unit = "px" if plan.goal.kind == "calibration" else plan.result.length_unit
    return {
        "aim": plan.goal.kind,
        "camera": plan.block.cameras[plan.camera].id,
        "unit": unit,
        "photographs": len(plan.proposals),
        "wanted": plan.wanted,
        "reached": plan.reached,
        "judged": plan.judged,
        "points_regarded": len(plan.outlook.joint.points),
        "sigma0": plan.result.sigma0,
        "vertical_known": plan.vertical is not None,
        "proposals": [reported(k) for k in range(len(plan.proposals))],
    }
