"""The files of a planned network, and its figures in words."""

from __future__ import annotations

import json
from collections.abc import Callable
from pathlib import Path
from typing import TYPE_CHECKING, Any

from raybundle.errors import Text, note, phrase, warning

if TYPE_CHECKING:
    from raybundle.errors import Message
    from raybundle.numerics.arrays import Array
    from raybundle.planning.network.datum_of_plan import Held
    from raybundle.planning.network.network_plan import NetworkPlan

VISIBLE = "visible.csv"
"""Where points are not always found: what each photograph shows, and the probability that it is found"""
TIMES, HARDLY = 3.0, 100.0
"""Ratios of standard deviations stated in times rather than per cent, and as hardly determined"""


def write_network_plan(
    plan: NetworkPlan, name: str, out: Path, more: Callable[[Path], None] | None = None, kind: str = "",
) -> None:  # fmt: skip
    """Write FOLDER/block, stations.csv, points.csv, plan.json and network.html, whole or not at all.

    more  writes further files into the folder
    kind  of a list of photographs
    """
    import numpy as np

    from raybundle.adjustment.engine import adjust_block
    from raybundle.adjustment.records.options import AdjustmentOptions
    from raybundle.io.block.folder import write_block_files
    from raybundle.io.block.tables import named
    from raybundle.io.digits import COUNT, EVERY, SETTING, SHORT, STD, by_sigma, of_places
    from raybundle.io.digits import reported as in_digits
    from raybundle.io.folders import new_folder
    from raybundle.io.tables import write_table
    from raybundle.planning.network.planned_block import planned_block
    from raybundle.report.network.page import Planned, write_network_page
    from raybundle.results.contents import clean
    from raybundle.words import reader

    s, e = plan.design.stations, plan.expected
    h = plan.held
    control, bars = (None, None) if h is None else (h.control_sigma, h.bars)
    block = planned_block(plan.site, s, control_sigma=control, bars=bars, name=str(name))
    exact = planned_block(plan.site, s, control_sigma=control, bars=bars, name=block.name, seed=None)
    names = exact.points.ids
    inner = AdjustmentOptions(datum="inner", datum_points=names, jobs=1)
    result = adjust_block(exact, inner if control is None else AdjustmentOptions(jobs=1))
    seen = plan.promise_known
    std = np.sqrt(np.diagonal(seen.points, axis1=1, axis2=2))
    away = s.at - s.centre
    what_for = [purpose_words(plan, k) for k in range(len(s))]
    with new_folder(out) as folder:
        (folder / "block").mkdir()
        write_block_files(block, folder / "block")
        write_table(
            folder / "stations.csv",
            {
                "image": block.images.ids, "X": s.centre[:, 0], "Y": s.centre[:, 1], "Z": s.centre[:, 2],
                "at_X": s.at[:, 0], "at_Y": s.at[:, 1], "at_Z": s.at[:, 2],
                "azimuth_deg": np.degrees(np.arctan2(away[:, 0], away[:, 1])) % 360,
                "elevation_deg": np.degrees(np.arctan2(away[:, 2], np.hypot(away[:, 0], away[:, 1]))),
                "roll_deg": np.degrees(np.arctan2(np.sin(s.roll), np.cos(s.roll))),
                "points": np.bincount(block.observations.image, minlength=len(s)).astype(float),
                "what_for": what_for,
            },
            {
                **dict.fromkeys(("X", "Y", "Z", "at_X", "at_Y", "at_Z"), of_places(s.centre, s.at)),
                **dict.fromkeys(("azimuth_deg", "elevation_deg", "roll_deg"), SETTING), "points": COUNT,
            },
        )  # fmt: skip
        write_table(
            folder / "points.csv",
            {
                "point": names, **{a: plan.site.points.xyz[:, k] for k, a in enumerate("XYZ")},
                **{f"s{a}_mm": 1000 * std[:, k] for k, a in enumerate("XYZ")}, "rays": e.rays.astype(float),
                "often": seen.often,
                **({} if plan.site.found is None else {"unlucky_mm": 1000 * seen.unlucky_points}),
                **({} if h is None else {"known": known_words(h, len(names))}),
            },
            {
                **dict.fromkeys("XYZ", EVERY), **{f"s{a}_mm": STD for a in "XYZ"}, "rays": COUNT, "often": EVERY,
                "unlucky_mm": STD,
            },
        )  # fmt: skip
        if plan.site.found is not None:
            o = exact.observations
            write_table(
                folder / VISIBLE,
                {
                    "image": named(exact.images.ids, o.image), "point": named(names, o.point),
                    "found": plan.site.sigma_px**2 / o.cov_px2[:, 0],
                },
                EVERY,
            )  # fmt: skip
        if bars is not None:
            write_table(
                folder / "scale_bars.csv",
                {
                    "from": [names[i] for i in bars.pairs[:, 0]], "to": [names[j] for j in bars.pairs[:, 1]],
                    "length_m": bars.length(plan.site.points.xyz), "sigma_mm": 1000 * bars.sigma,
                },
                {"length_m": by_sigma(bars.sigma), "sigma_mm": STD},
            )  # fmt: skip
        (folder / "plan.json").write_text(
            json.dumps(clean(in_digits({**reported(plan), **({"list": kind} if kind else {})}, SHORT)), indent=1)
            + "\n",
            encoding="utf-8",
        )
        planned = Planned(
            corners=plan.corners, sigma=plan.map_sigma, covariance=seen.points,
            image_words=tuple(what_for), wanted=None if plan.wanted is None else (plan.wanted, plan.aim.name),
            remarks=(
                phrase("network_plan.promise", sigma_px=plan.site.sigma_px), frame_words(plan),
                phrase("network_plan.grey"),
            ),
        )  # fmt: skip
        write_network_page(result, folder / "network.html", planned, language=reader().language)
        if more is not None:
            more(folder)


def reported(plan: NetworkPlan) -> dict[str, Any]:
    """The figures of a plan, metres and degrees."""
    import numpy as np

    e, seen = plan.expected, np.isfinite(plan.map_sigma)
    free, h = plan.site.free, plan.held

    def finite(v: float) -> float | None:
        return float(v) if np.isfinite(v) else None

    known = None if h is None else {
        "control": len(h.control), "scale_bars": 0 if h.bars is None else len(h.bars.sigma),
        "bar_lengths_m": [] if h.bars is None else h.bars.length(plan.site.points.xyz).tolist(),
        "worst_m": plan.promise_known.worst, "mean_m": plan.promise_known.mean,
    }  # fmt: skip
    return {
        "photographs": len(plan.design.stations),
        "aim": plan.aim.name,
        "wanted_m": plan.wanted,
        "reached_m": plan.figure if plan.aim.unit == "m" else None,
        "calibration_px": plan.promise.calibration_px,
        "least_redundancy": plan.promise.least_redundancy,
        "worst_m": plan.promise.worst,
        "worst_in_one_of_ten_m": plan.promise.unlucky,
        "largest_coordinate_m": plan.promise.largest,
        "mean_m": plan.promise.mean,
        "drawings_that_fall_apart": plan.promise.lost,
        "object": {
            "area_m2": plan.site.surface.wanted_area,
            "seen_twice": float(seen.mean()),
            "largest_m": float(np.nanmax(plan.map_sigma)),
            "median_m": float(np.nanmedian(plan.map_sigma)),
        },
        "interior_mm": {s: float(v) for s, v in zip(free, np.sqrt(np.diag(plan.promise.interior)), strict=True)},
        "image_sigma_px": plan.site.sigma_px,
        "image_scale_number": plan.scale_number,
        "rays_mean": float(e.rays.mean()),
        "added": [
            {
                "photographs": len(m.of),
                "again_from": [int(k) + 1 for k in m.of if k >= 0],
                "before_m": finite(m.figures[0]),
                "after_m": finite(m.figures[-1]),
                "open_share": m.open_share,
            }
            for m in plan.more
        ],
        "base_to_depth": plan.base_to_depth,
        "q": plan.q,
        "known": known,
        "depth_of_field_m": [d if np.isfinite(d) else None for d in plan.site.depth],
        "minutes": plan.cost.minutes,
        "path_m": plan.cost.path_m,
        "tried": [{"photographs": n, "reached_m": f if np.isfinite(f) else None} for n, f in plan.tried],
    }


SIDES = {"top": "+Z", "below": "-Z", "front": "-Y", "back": "+Y", "right": "+X", "left": "-X"}
"""Sides of an object, and the axes that point to them"""


def frame_words(plan: NetworkPlan) -> Text:
    """In what frame the standard deviations of a plan's points are reported."""
    h = plan.held
    control, bars = (0, 0) if h is None else (len(h.control), 0 if h.bars is None else len(h.bars.sigma))
    return phrase("network_plan.frame", control=control, bars=bars)


def known_words(h: Held, points: int) -> list[str]:
    """What is known of each point beforehand: control, scale bar, or nothing."""
    bars = set[int]() if h.bars is None else set(h.bars.pairs.ravel().tolist())
    control = set(h.control)
    return [
        phrase("network_plan.known", control=k in control, bar=k in bars) if k in control | bars else ""
        for k in range(points)
    ]  # fmt: skip


def free_camera(plan: NetworkPlan) -> list[Message]:
    """What a plan of natural points does not know where the camera is calibrated with the object; [] for others."""
    from raybundle.planning.measured import FREE_CAMERA

    if plan.site.found is None or not plan.site.free:
        return []
    low, high = FREE_CAMERA
    return [warning("plan.free_camera", low=float(low), high=float(high))]


def purpose_words(plan: NetworkPlan, k: int) -> Text:
    """What a station is there for: what would be worse without it."""
    p, normal = plan.purposes[k], plan.site.points.normal
    if len(p.unseen):
        side = side_of(normal[p.unseen].mean(axis=0))
        return phrase("network_plan.points_unseen", n=len(p.unseen), side=side)
    if not p.ratio < HARDLY:
        return phrase("network_plan.undetermined")
    larger = [(plan.aim.name, p.ratio)] if p.ratio > 1.02 else []
    larger.append((side_of(normal[p.worst]), p.worst_ratio))
    if p.parameters and p.parameters[0][1] > 1.05:
        larger += p.parameters[:2]
    return Text.of(*(
        note("network_plan.larger", what=what, ratio=ratio, per_cent=100 * (ratio - 1), size=_size(ratio))
        for what, ratio in larger
    ))  # fmt: skip


def _size(ratio: float) -> str:
    """How a ratio of standard deviations is written."""
    return "hardly" if ratio > HARDLY else "times" if ratio > TIMES else "per_cent"


def side_of(normal: Array) -> str:
    """The side of an object that has this normal: the front is that towards -Y."""
    axis = max((1, 0, 2), key=lambda k: abs(normal[k]))
    towards = f"{'-+'[int(normal[axis] > 0)]}{'XYZ'[axis]}"
    return next(side for side, direction in SIDES.items() if direction == towards)
