"""`raybundle plan network`."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import click

from raybundle.cli.common import COMMAND_SETTINGS, NEW_FOLDER, common_options, counted, significant
from raybundle.cli.settings import options_of, values_of
from raybundle.commands.planning.network import NetworkSettings, purpose_words, run_plan_network, side_words, told
from raybundle.settings import made

if TYPE_CHECKING:
    from raybundle.planning.network_plan import NetworkPlan

SEEN = 0.98
"""Share of the object from which on nothing is said of the rest"""
SHOWN = 12
"""Stations that are told one by one; the others stand in stations.csv"""


@click.command("network", context_settings=COMMAND_SETTINGS)
@click.argument("object", metavar="OBJECT")
@options_of(NetworkSettings, out=NEW_FOLDER)
@common_options
def command(object: str, progress: str, **given: Any) -> None:  # noqa: A002  (the argument's name)
    """Plan photographs of an object: where to stand, how to turn the camera, what precision to expect where.

    OBJECT is a kind with its size in metres (box:WIDTH,DEPTH,HEIGHT, cylinder:DIAMETER,HEIGHT, facade:WIDTH,HEIGHT,
    corridor:LENGTH,WIDTH) or a mesh (PLY, OBJ, STL). Boxes and facades face -Y. The fewest stations are looked for that
    promise the wanted standard deviation, and moved to where they serve best; each is said what it is there for.
    FOLDER gets network.html (the object in colours of its precision), stations.csv, points.csv, plan.json, and a
    simulated block that `adjust` takes.

    \b
    Example:
      raybundle plan network box:4,3,2.5 --sigma 0.15 --c 24 --pixel 6 --out plan
      raybundle plan network facade:12,8 --photographs 10 --measured natural --heights 1.2 4 --out facade-plan
    """  # noqa: D301
    from raybundle.cli.progress import reporting  # noqa: PLC0415  (what computes is loaded after the help)

    settings = made(NetworkSettings, {"object": object, **values_of(NetworkSettings, given)})
    with reporting(progress) as tell:
        plan = run_plan_network(settings, tell)
    click.echo("\n".join(f" {line}" for line in _lines(plan, settings)))


def _lines(plan: NetworkPlan, settings: NetworkSettings) -> list[str]:
    t = told(plan)
    n, aim = t["photographs"], "worst point" if plan.aim == "worst" else "mean"
    reached = f"sigma of a coordinate {_mm(t['reached_m'])} ({aim})"
    if plan.wanted is not None:
        reached += f", wanted {_mm(plan.wanted)}" + ("" if plan.reached else ": not reached")
    o = t["object"]
    near, far = plan.site.depth
    seen = f"{100 * o['seen_twice']:.0f} % of the object is seen twice or more, there median {_mm(o['median_m'])}"
    sharp = f"sharp from {significant(near, 3)} " + (f"to {significant(far, 3)} m" if far < 1e6 else "m on")
    network = f"rays {t['rays_mean']:.1f}, S {t['image_scale_number']:.0f}, q {t['q']:.2f}"
    lines = [
        f"{counted(n, 'photograph')} of {plan.site.surface.name} {plan.site.surface.about}: {reached}",
        f"mean {_mm(t['mean_m'])}, worst {_mm(t['worst_m'])}; {seen}, largest {_mm(o['largest_m'])}",
        f"{network}, image sigma {plan.site.sigma_px:g} px; {sharp}",
        f"about {t['minutes']:.0f} min on site, {t['path_m']:.0f} m to walk",
    ]
    if plan.site.free:
        std, pixel = t["interior_mm"], plan.site.camera.pixel_mm[0]
        known = (f"{s} {std[s] / pixel:.2g} px" for s in ("c", "x0", "y0") if s in std)
        lines.append(f"calibrated with it: {', '.join(known)}")
    lines += [f"{k + 1:02d}  {purpose_words(plan, k)}" for k in range(min(n, SHOWN))]
    if n > SHOWN:
        lines.append(f"... {n - SHOWN} more in stations.csv")
    out = plan.left_out
    if len(out):
        sides = dict.fromkeys(side_words(n) for n in out.normal)
        lines.append(
            f"caution: {len(out)} of {len(out) + len(plan.site.points)} points ({', '.join(sides)}) cannot be seen "
            f"{settings.rays} times from where one may stand; nothing is promised of them (--heights, --clearance, "
            "--incidence, --around)"
        )
    elif o["seen_twice"] < SEEN:
        lines.append(
            f"remark: {100 - 100 * o['seen_twice']:.0f} % of the object lies between the points and is not seen twice; "
            "with more --points it is less"
        )
    return [*lines, f"{settings.out}: network.html, stations.csv, points.csv, block"]


def _mm(metres: float) -> str:
    return f"{significant(1000 * metres, 2)} mm"
