"""`raybundle plan list`: photographs to take along, one by one, by an assistant."""

from __future__ import annotations

import json
from collections.abc import Sequence
from dataclasses import MISSING, dataclass, fields, replace
from pathlib import Path
from typing import TYPE_CHECKING, Any, Literal

from raybundle.commands.planning.network import (
    MeasuredName,
    NetworkSettings,
    PlannedCamera,
    site_of,
    stations_of,
)
from raybundle.errors import InputError, Text, note, phrase
from raybundle.numerics.progress import Progress, silent
from raybundle.settings import METRES, Range, keywords, made, setting

if TYPE_CHECKING:
    from raybundle.planning.network.assistants import Shots, Task
    from raybundle.planning.network.network_plan import NetworkPlan
    from raybundle.planning.network.site import Site
    from raybundle.report.photograph_list import ListedPhotograph, PhotographList

ListKind = Literal["cipa", "calibration", "turntable", "targets"]
NEAR = frozenset({"calibration", "turntable"})
"""Lists whose photographs are taken from so near that not all is sharp: the lens is focused to where the object fills
the format"""
POINTS = {"cipa": 600}
"""Points by which a list is judged: natural ones are many"""
LIST = "list.csv"
"""File of a folder with a list, by which `plan check` knows it"""
PRINTED = "list.json"
"""What is printed beside the photographs, for a list that is ticked off"""


@dataclass(frozen=True, slots=True, kw_only=True)
class ListSettings(PlannedCamera):
    """An assistant, an object, a camera, and what they need."""

    kind: str
    """cipa, calibration, turntable or targets"""
    out: Path = setting(MISSING, "New folder for the list.", metavar="FOLDER")
    focus: float | None = setting(None, "Focus distance of the lens [m].  [default: by the photographs]", limits=METRES)
    measured: MeasuredName | None = setting(
        None, "Kind of image points.  [default: natural for a building, dots for a sheet, else targets]"
    )
    around: float = setting(30.0, "cipa: largest distance from the walls [m].", limits=METRES)
    clearance: float | None = setting(
        None, "cipa: smallest distance from the walls [m].  [default: by the list]", limits=METRES
    )
    eye: float = setting(1.7, "cipa: height of the camera above the ground [m].", limits=METRES)
    overlap: float = setting(
        0.6, "cipa: overlap of neighbouring photographs of the ring.", limits=Range(low=0.5, high=0.95)
    )
    steps: int = setting(24, "turntable: steps of a full turn.", limits=Range(low=3, high=360))
    elevations: tuple[float, ...] = setting(
        (15.0, 45.0),
        "turntable: elevations of the views above the table [deg]. May be repeated.",
        limits=Range(low=-80, high=89),
    )
    stations: Path | None = setting(
        None, "targets: stations.csv of a plan, a block or a result.", metavar="FILE|FOLDER"
    )
    count: int = setting(40, "targets: number of targets.", limits=Range(low=4, high=500))
    across: float = setting(
        10.0, "targets: diameter of a dot in the farthest photograph [px].", limits=Range(low=3, high=200)
    )


@keywords(ListSettings)
def plan_list(
    kind: str,
    object: str,  # noqa: A002
    out: str | Path,
    *,
    progress: Progress = silent,
    **settings: Any,
) -> NetworkPlan:
    """List photographs one by one, and write the list.

    kind      "cipa", "calibration", "turntable" or "targets"
    object    as of `plan_network`
    out       new folder: list.pdf, list.csv, and what `plan_network` writes
    settings  as of the command line, by the names of `ListSettings`
    raises    InputError where the list cannot be made, with what would help
    """
    return run_plan_list(made(ListSettings, {"kind": kind, "object": object, "out": Path(out), **settings}), progress)


def run_plan_list(settings: ListSettings, progress: Progress = silent) -> NetworkPlan:
    """List what the settings ask for, and write it."""
    from raybundle.commands.planning.network_files import write_network_plan
    from raybundle.io.folders import check_new_folder
    from raybundle.planning.network.assistants import assistants
    from raybundle.planning.network.datum_of_plan import Wanted
    from raybundle.planning.network.network_plan import plan_network

    if settings.kind not in assistants:
        raise InputError("plan.unknown_list", kind=settings.kind, known=sorted(assistants))
    check_new_folder(settings.out)
    shots = assistants[settings.kind].shots(task_of(settings))
    known = Wanted() if shots.bars is None else Wanted(bars=shots.bars[0], bar_sigma=shots.bars[1])
    plan = plan_network(shots.site, start=shots.stations, as_given=True, least_rays=2, known=known, progress=progress)
    title = phrase("photograph_list.title", assistant=settings.kind, name=_object_words(plan))
    printed, listed = printed_list(settings, shots, plan, title)

    def more(folder: Path) -> None:
        write_list(folder, printed, listed)

    write_network_plan(plan, phrase("network_plan.title", name=title), settings.out, more, settings.kind)
    return plan


def task_of(settings: ListSettings) -> Task:
    """What the assistant is given."""
    from raybundle.planning.network.assistants import Task

    s = settings
    usual: dict[str, MeasuredName] = {"cipa": "natural", "calibration": "dots"}
    site = site_of(
        NetworkSettings(
            **{f.name: getattr(s, f.name) for f in fields(PlannedCamera)}, out=s.out, focus=s.focus,
            measured=s.measured or usual.get(s.kind, "targets"), incidence=75.0, object_points=POINTS.get(s.kind, 100),
        ),
        taken=True,
    )  # fmt: skip
    if s.focus is None and s.kind in NEAR:
        site = replace(site, depth=_focused(site, s.f_number))
    return Task(
        site=site, reach=s.around, eye=s.eye, overlap=s.overlap, steps=s.steps, elevations_deg=s.elevations,
        measured_by=None if s.stations is None else stations_of(s.stations), targets=s.count, across_px=s.across,
        clearance=s.clearance or 0.0,
    )  # fmt: skip


def _focused(site: Site, f_number: float) -> tuple[float, float]:
    """Depth of field of the lens, focused to where the object fills the shorter side of the format."""
    import numpy as np

    from raybundle.planning.network.assistants.base import FULL
    from raybundle.planning.network.optics import Optics

    low, high = site.surface.wanted_bounds
    c = site.camera.sensor.camera_constant(site.camera.parameters)
    half = np.arctan(np.abs(site.camera.size_mm).min() / 2 / c)
    distance = float(np.linalg.norm(high - low)) / 2 / np.tan(FULL * half)
    focus = max(distance, 2 * c / 1000)
    return Optics(f_number=f_number, focus=focus).depth_of_field(c, site.camera.pixel_mm[0])


def _object_words(plan: NetworkPlan) -> str:
    """The object in words."""
    surface = plan.site.surface
    return f"{surface.name} {surface.about}".rstrip()


def printed_list(
    settings: ListSettings, shots: Shots, plan: NetworkPlan, title: str
) -> tuple[PhotographList, tuple[ListedPhotograph, ...]]:
    """What is printed, and its lines."""
    from raybundle.report.photograph_list import PhotographList, edges_of

    surface = plan.site.surface
    listed = photographs_of(shots, plan)
    target, dot, code, seen = (
        phrase("photograph_list.table_head", name=c) for c in ("target", "dot", "code", "photographs")
    )
    head = (target, "X", "Y", "Z [m]", dot, code, seen)
    printed = PhotographList(
        title=title, facts=(phrase("photograph_list.photographs", n=len(listed)), *facts_of(settings, plan)),
        rules=shots.rules,
        photographs=listed,
        edges=edges_of(surface.vertices[surface.triangles]),
        table=(head, *shots.about_targets)
        if shots.about_targets else (),
    )  # fmt: skip
    return printed, listed


def write_list(folder: Path, printed: PhotographList, listed: Sequence[ListedPhotograph]) -> None:
    """Write list.pdf, list.csv and list.json."""
    from raybundle.io.tables import write_table
    from raybundle.report.photograph_list import MOST_EDGES, list_pdf

    (folder / "list.pdf").write_bytes(list_pdf(printed))
    write_table(
        folder / LIST,
        {
            "image": [p.number for p in listed], "group": [p.group for p in listed], "see": [p.see for p in listed],
            "how": [p.how for p in listed], "taken": [p.ticked for p in listed],
        },
        {},
    )  # fmt: skip
    entry = {
        "title": printed.title, "facts": printed.facts, "rules": printed.rules, "table": printed.table,
        "edges": printed.edges[:MOST_EDGES].tolist(),
    }  # fmt: skip
    (folder / PRINTED).write_text(json.dumps(entry, indent=1) + "\n", encoding="utf-8")


def photographs_of(shots: Shots, plan: NetworkPlan) -> tuple[ListedPhotograph, ...]:
    """The lines of the list."""
    import numpy as np

    from raybundle.planning.network.assistants.base import held_words
    from raybundle.report.photograph_list import ListedPhotograph

    s, low = shots.stations, plan.site.surface.wanted_bounds[0]
    found = list[ListedPhotograph]()
    for k, leaf in enumerate(shots.leaves):
        to = s.at[k] - s.centre[k]
        distance = float(np.linalg.norm(to))
        tilt = float(np.degrees(np.arctan2(to[2], np.hypot(to[0], to[1]))))
        x, y, z = s.centre[k]
        how = Text.of(
            note("photograph_list.stand", x=x, y=y, height=z - low[2]),
            note("photograph_list.aim", distance=distance, tilt_deg=abs(tilt), up=tilt > 0),
            *held_words(plan.site.camera, float(s.roll[k])).messages,
        )  # fmt: skip
        found.append(
            ListedPhotograph(
                number=f"{k + 1:02d}", group=leaf.group, centre=s.centre[k], at=s.at[k], how=how, see=leaf.see
            )
        )
    return tuple(found)


def facts_of(settings: ListSettings, plan: NetworkPlan) -> list[str]:
    """Camera and promised precision."""
    camera = plan.site.camera
    c = camera.sensor.camera_constant(camera.parameters)
    near, far = plan.site.depth
    found = [
        note(
            "photograph_list.camera", width_px=camera.width_px, height_px=camera.height_px,
            pixel_um=1000 * camera.pixel_mm[0], c_mm=c, f_number=settings.f_number,
        )
    ]  # fmt: skip
    if settings.focus is not None:
        found.append(note("photograph_list.focus", focus_m=settings.focus))
    if near > 0:
        found.append(note("photograph_list.sharp", near_m=near, far_m=far if far < 1e6 else 0.0))
    promise = plan.promise
    lines: list[str] = [
        Text.of(*found),
        phrase(
            "photograph_list.promise", sigma_px=plan.site.sigma_px, worst_mm=1000 * promise.worst,
            mean_mm=1000 * promise.mean,
        ),
    ]  # fmt: skip
    if promise.calibration_px is not None:
        lines.append(_worth_words(plan, promise.calibration_px))
    if len(plan.left_out):
        share = len(plan.left_out) / (len(plan.left_out) + len(plan.site.points))
        lines.append(phrase("photograph_list.unseen", share=share))
    return lines


def _worth_words(plan: NetworkPlan, sigma_px: float) -> str:
    """What the calibration that comes with the photographs is good for."""
    from raybundle.calibration.quality import GOOD_PX, REACH, SURE, USABLE_PX
    from raybundle.planning.network.calibration_quality import calibration_worth

    w = calibration_worth(plan.site, plan.design.stations, plan.promise.interior)
    limit = {"good": 0.0, "usable": GOOD_PX}.get(w.grade, USABLE_PX)
    found = [
        note(
            "photograph_list.calibration", sigma_px=sigma_px, likely_px=w.likely_px, sure=SURE, sure_px=w.sure_px
        ),
        note("photograph_list.use", grade=w.grade, limit_px=limit),
    ]  # fmt: skip
    if w.reach < REACH:
        found.append(note("photograph_list.reach", share=w.reach))
    return Text.of(*found)
