"""`raybundle plan network`."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import click

from raybundle.cli.common import NEW_FOLDER, Command, common_options, significant
from raybundle.cli.settings import options_of, values_of
from raybundle.cli.summary import Summary, report
from raybundle.commands.planning.network import NetworkSettings, run_plan_network
from raybundle.commands.planning.network_files import SIDES, free_camera, purpose_words, reported, side_of
from raybundle.errors import Message, note, warning
from raybundle.settings import made

if TYPE_CHECKING:
    from raybundle.planning.network.network_plan import NetworkPlan

SEEN = 0.98
"""Share of the object from which on nothing is stated of the rest"""


@click.command("network", cls=Command)
@click.argument("object", metavar="OBJECT")
@options_of(NetworkSettings, out=NEW_FOLDER)
@common_options
def command(object: str, progress: str, **given: Any) -> None:  # noqa: A002  (the argument's name)
    """Plan photographs of an object: stations, camera rotations and expected precision.

    OBJECT is a kind with its size in metres: box:WIDTH,DEPTH,HEIGHT; cylinder:DIAMETER,HEIGHT; facade:WIDTH,HEIGHT or
    facade:OUTLINE.csv; corridor:LENGTH,WIDTH or corridor:AXIS.geojson,WIDTH. Or it is a mesh (PLY, OBJ, STL), a raster
    of heights (GeoTIFF), or a result folder with the points of the object. Boxes and facades face -Y. The plan has the
    fewest stations for the required standard deviation, at their best places, each with its purpose. FOLDER gets
    network.html (the object in colours of its precision), stations.csv, points.csv, plan.json, and a simulated block
    for `adjust`.

    \b
    Example:
      raybundle plan network box:4,3,2.5 --sigma 0.15 --c 24 --pixel-mm 0.006 --out plan
      raybundle plan network facade:12,8 --photographs 10 --measured natural --heights 1.2 4 --out facade-plan
      raybundle plan network box:4,3,2.5 --stations plan/stations.csv --scale-bars 2 --scale-bar-sigma 2e-5 --out known
    """
    from raybundle.cli.progress import reporting

    settings = made(NetworkSettings, {"object": object, **values_of(NetworkSettings, given)})
    with reporting(progress) as notify:
        plan = run_plan_network(settings, notify)
    report(_summary(plan, settings))


def _summary(plan: NetworkPlan, settings: NetworkSettings) -> Summary:
    """What the command reports."""
    t = reported(plan)
    o, site = t["object"], plan.site
    near, far = site.depth
    reached = f"{plan.figure:.3g} px" if plan.aim.unit == "px" else f"{t['least_redundancy']:.2f}"
    if plan.aim.unit == "m":
        reached = _mm(t["reached_m"])
    wanted = "" if plan.wanted is None else _mm(plan.wanted)
    target = "none" if plan.wanted is None else "met" if plan.reached else "missed"
    done = [
        note("network.stations", n=t["photographs"], object=f"{site.surface.name} {site.surface.about}",
             aim=plan.aim.name, reached=reached, wanted=wanted, target=target),
        note("network.precision", mean=_mm(t["mean_m"]), worst=_mm(t["worst_m"]),
             coordinate=_mm(t["largest_coordinate_m"])),
        note("network.object", share=o["seen_twice"], median=_mm(o["median_m"]), largest=_mm(o["largest_m"]),
             known=t["known"] is not None),
    ]  # fmt: skip
    more: list[Message] = [
        note("network.geometry", base_to_depth=t["base_to_depth"], rays=t["rays_mean"], scale=t["image_scale_number"],
             q=t["q"], sigma_px=site.sigma_px),
        note("network.effort", minutes=t["minutes"], path_m=t["path_m"]),
    ]  # fmt: skip
    if near > 0:
        more.append(note("network.sharp", near_m=near, far_m=far if far < 1e6 else 0.0))
    for m in plan.more:
        before, after = (_mm(m.figures[k]) if plan.aim.unit == "m" else "" for k in (0, -1))
        again = len(m.of) > 0 and bool((m.of >= 0).all())
        more.append(note(
            "network.added", n=len(m.of), again=again, known=plan.aim.unit == "m", before=before, after=after,
            share=m.open_share,
        ))  # fmt: skip
    if t["known"] is not None:
        k = t["known"]
        more.append(note(
            "network.known", control=k["control"], bars=k["scale_bars"], lengths_m=list(k["bar_lengths_m"]),
            worst=_mm(k["worst_m"]), mean=_mm(k["mean_m"]),
        ))  # fmt: skip
    if site.free:
        std, pixel, px = t["interior_mm"], site.camera.pixel_mm[0], t["calibration_px"]
        known = [f"{s} {std[s] / pixel:.2g} px" for s in ("c", "x0", "y0") if s in std]
        more.append(note("network.calibrated", parameters=known, known=px is not None, worst_px=px))
    purposes = [f"{k + 1:02d}  {purpose_words(plan, k)}" for k in range(t["photographs"])]
    return Summary(
        done=done, details=[*more, *purposes], notices=[*_unseen(plan, settings, o["seen_twice"]), *_seldom(plan)],
        next_step=note("network.next", folder=str(settings.out)), files=[settings.out],
    )  # fmt: skip


def _unseen(plan: NetworkPlan, settings: NetworkSettings, seen: float) -> list[Message]:
    """Of points that no two photographs show."""
    out = plan.left_out
    if len(out):
        sides = list(dict.fromkeys(SIDES[side_of(n)] for n in out.normal))
        of = len(out) + len(plan.site.points)
        return [warning("plan.points_out_of_sight", n=len(out), of=of, sides=sides, rays=settings.rays)]
    return [note("plan.object_between_points", share=1 - seen)] if seen < SEEN else []


def _seldom(plan: NetworkPlan) -> list[Message]:
    """Of points that are not always found."""
    often = plan.promise.often
    found: list[Message] = []
    if (often < 1).any():
        share, worst = float(1 - often.mean()), plan.promise.unlucky
        found.append(note("plan.points_seldom_found", share=share, worst=1000 * worst, unit="mm"))
    if plan.promise.lost > 0:
        found.append(warning("plan.network_falls_apart", share=plan.promise.lost))
    return [*found, *free_camera(plan)]


def _mm(metres: float) -> str:
    if not metres < 1e6:
        return "not determined"
    return f"{significant(1000 * metres, 2)} mm"
