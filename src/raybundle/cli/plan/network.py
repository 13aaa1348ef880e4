"""`raybundle plan network`."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import click

from raybundle.cli.common import NEW_FOLDER, Command, common_options, counted, significant
from raybundle.cli.settings import options_of, values_of
from raybundle.cli.summary import notice_line
from raybundle.commands.planning.network import NetworkSettings, run_plan_network
from raybundle.commands.planning.network_files import SIDES, free_camera_warning, purpose_words, reported, side_of
from raybundle.errors import note, phrase, warning
from raybundle.settings import made

if TYPE_CHECKING:
    from raybundle.planning.network_plan import NetworkPlan

SEEN = 0.98
"""Share of the object from which on nothing is stated of the rest"""
SHOWN = 12
"""Stations that are reported one by one; the others stand in stations.csv"""


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
    """  # noqa: D301
    from raybundle.cli.progress import reporting  # noqa: PLC0415  (what computes is loaded after the help)

    settings = made(NetworkSettings, {"object": object, **values_of(NetworkSettings, given)})
    with reporting(progress) as notify:
        plan = run_plan_network(settings, notify)
    click.echo("\n".join(f" {line}" for line in _lines(plan, settings)))


def _lines(plan: NetworkPlan, settings: NetworkSettings) -> list[str]:
    t = reported(plan)
    n = t["photographs"]
    aim = phrase("network_plan.aim", name=plan.aim.name)
    reached = f"{aim} " + (f"{plan.figure:.3g} px" if plan.aim.unit == "px" else f"{t['least_redundancy']:.2f}")
    if plan.aim.unit == "m":
        reached = f"sigma of a coordinate {_mm(t['reached_m'])} ({aim})"
    if plan.wanted is not None:
        reached += f", wanted {_mm(plan.wanted)}" + ("" if plan.reached else ": not reached")
    o = t["object"]
    near, far = plan.site.depth
    seen = f"{100 * o['seen_twice']:.0f} % of the object is seen twice or more, there median {_mm(o['median_m'])}"
    sharp = f"; sharp from {significant(near, 3)} " + (f"to {significant(far, 3)} m" if far < 1e6 else "m on")
    frame = "" if t["known"] is None else " (of the object with what is known of it)"
    network = (
        f"B/D {t['base_to_depth']:.2f}, rays {t['rays_mean']:.1f}, S {t['image_scale_number']:.0f}, q {t['q']:.2f}"
    )
    lines = [
        f"{counted(n, 'photograph')} of {plan.site.surface.name} {plan.site.surface.about}: {reached}",
        f"mean {_mm(t['mean_m'])}, worst {_mm(t['worst_m'])}, its largest coordinate {_mm(t['largest_coordinate_m'])}",
        f"{seen}, largest {_mm(o['largest_m'])}{frame}",
        f"{network}, image sigma {plan.site.sigma_px:g} px{sharp if near > 0 else ''}",
        f"about {t['minutes']:.0f} min on site, {t['path_m']:.0f} m to walk",
    ]
    for m in plan.more:
        again = len(m.of) and (m.of >= 0).all()
        what = "once more from stations that are there" if again else "for all of the surface that can be seen"
        after = f": {_mm(m.figures[0])} before, {_mm(m.figures[-1])} with them" if plan.aim.unit == "m" else ""
        still = f"; {100 * m.open_share:.0f} % of it stay above what is wanted" if m.open_share > 0 else ""
        lines.append(f"{counted(len(m.of), 'photograph')} {what}{after}{still}")
    if t["known"] is not None:
        k = t["known"]
        parts = [counted(k[n], w) for n, w in (("control", "control point"), ("scale_bars", "scale bar")) if k[n]]
        if k["bar_lengths_m"]:
            parts[-1] += f" ({', '.join(f'{v:.3g}' for v in k['bar_lengths_m'])} m long)"
        lines.append(f"with {' and '.join(parts)}: worst {_mm(k['worst_m'])}, mean {_mm(k['mean_m'])}")
    if plan.site.free:
        std, pixel = t["interior_mm"], plan.site.camera.pixel_mm[0]
        known = (f"{s} {std[s] / pixel:.2g} px" for s in ("c", "x0", "y0") if s in std)
        px = t["calibration_px"]
        whole = "" if px is None else f"; image points to {px:.2g} px at worst"
        lines.append(f"calibrated with it: {', '.join(known)}{whole}")
    lines += [f"{k + 1:02d}  {purpose_words(plan, k)}" for k in range(min(n, SHOWN))]
    if n > SHOWN:
        lines.append(f"... {n - SHOWN} more in stations.csv")
    lines += _seldom(plan)
    out = plan.left_out
    if len(out):
        sides = dict.fromkeys(SIDES[side_of(n)] for n in out.normal)
        total = len(out) + len(plan.site.points)
        lines.append(
            notice_line(
                warning("plan.points_out_of_sight", n=len(out), of=total, sides=list(sides), rays=settings.rays)
            )
        )
    elif o["seen_twice"] < SEEN:
        lines.append(notice_line(note("plan.object_between_points", share=1 - o["seen_twice"])))
    return [*lines, f"{settings.out}: network.html, stations.csv, points.csv, block"]


def _seldom(plan: NetworkPlan) -> list[str]:
    """Of points that are not always found."""
    often = plan.promise.often
    lines = list[str]()
    if (often < 1).any():
        share, worst = float(1 - often.mean()), plan.promise.unlucky
        lines.append(notice_line(note("plan.points_seldom_found", share=share, worst=1000 * worst, unit="mm")))
    if plan.promise.lost > 0:
        lines.append(notice_line(warning("plan.network_falls_apart", share=plan.promise.lost)))
    if found := free_camera_warning(plan):
        lines.append(notice_line(found))
    return lines


def _mm(metres: float) -> str:
    if not metres < 1e6:
        return "not determined"
    return f"{significant(1000 * metres, 2)} mm"
