"""Mistaken marks of hands: named, stated as untestable, silent or named falsely, as `raybundle mark adjust` reports.

    python benchmarks/marks.py [--draws 200] [--clean 400] [--jobs 2]      into benchmarks/results/marks.json

An oriented ring of photographs (simulated, adjusted once: tie points of 0.3 px), and sets of new points marked by hand
with 0.5 px in 3 to 9 photographs; in two points of each set 1, 2 or 3 marks are off by 5, 20 or 70 px in independent
directions.  Every set goes the whole way: the actions of the journal, merged, adjusted, reported.

named       all mistaken marks of the point are named, and no other of it
untestable  the point's marks are reported as contradictory, or as not tested
silent      neither
falsely     another mark of the point is named
clean sets  share with a mark that is reported as mistaken, where none is: by adjusting, by any click
clicks      mistaken points of which a mark is red after the last click, and right points of clean sets that are
            reported as not tested
"""

import argparse
import json
import sys
from collections import Counter
from concurrent.futures import ProcessPoolExecutor
from functools import cache
from pathlib import Path

import numpy as np

ROOT = Path(__file__).resolve().parents[1]
sys.path.insert(0, str(ROOT))

from raybundle.adjustment.records.options import AdjustmentOptions  # noqa: E402
from raybundle.measuring import mark_tests  # noqa: E402
from raybundle.measuring.actions.verbs import Put  # noqa: E402
from raybundle.measuring.merge import merge  # noqa: E402
from raybundle.measuring.session import Session  # noqa: E402
from raybundle.measuring.start import adjusted  # noqa: E402
from raybundle.measuring.state import folded  # noqa: E402
from raybundle.planning.simulate import Survey, project, simulate  # noqa: E402
from raybundle.planning.synthetic_networks import Ring, brown_camera, ring_scene  # noqa: E402
from raybundle.workflows.adjust import adjust  # noqa: E402

HAND_PX, SIZES, WRONG, RAYS, POINTS = 0.5, (5, 20, 70), (1, 2, 3), range(3, 10), 8


@cache
def oriented(seed=1):
    """An adjusted block, and the places (image -> point -> px) of all points of a second scene of the same stations."""
    camera = brown_camera(size_px=(3000, 2000), pixel_mm=0.008, estimate=("c", "x0", "y0", "K1"))
    plan = Ring(camera=camera, stations=28, rings=1, points=200, seed=seed)
    made = simulate(ring_scene(plan), Survey(seed=seed, image_sigma_px=0.3, orientation="exact", points="exact"))
    new = ring_scene(Ring(camera=camera, stations=28, rings=1, points=400, seed=seed + 100))
    seen = [dict(zip(*(v.tolist() for v in project(new, k)), strict=True)) for k in range(28)]
    return adjust(made.observed).adjusted, seen


def a_set(number, wrong_points=2):
    """Actions of a set of points, and of each: (photographs, mistaken marks, size, images of these)."""
    rng = np.random.default_rng(number)
    block, seen = oriented()
    actions, truth = [], {}
    combinations = [(n, m, d) for n in RAYS for m in WRONG for d in SIZES]
    for k in range(POINTS):
        n, m, d = combinations[(number * wrong_points + k) % len(combinations)]
        m = m if k < wrong_points else 0
        if m == 0:
            n = int(rng.choice(RAYS))
        fits = [p for p in range(400) if sum(p in s for s in seen) >= n]
        p = int(rng.choice(fits))
        images = rng.permutation([i for i, s in enumerate(seen) if p in s])[:n]
        for j, i in enumerate(images):
            turn = rng.uniform(0, 2 * np.pi)
            off = d * np.array([np.cos(turn), np.sin(turn)]) if j < m else np.zeros(2)
            x, y = np.array(seen[i][p]) + rng.normal(0, HAND_PX, 2) + off
            actions.append(Put(image=block.images.ids[i], point=f"hand {k}", x_px=float(x), y_px=float(y)))
        truth[f"hand {k}"] = n, m, d, {block.images.ids[i] for i in images[:m]}
    return actions, truth


@cache
def opened():
    """The session of the block, as the studio has it before anything is measured."""
    return Session.of_block(oriented()[0])


def red(actions, every):
    """Points of which a click was red: any, or the last one."""
    found = {}
    for k, a in enumerate(actions, 1):
        if every or k == len(actions) or actions[k].point != a.point:
            text = mark_tests.mark_verdict(opened(), folded(actions[:k]), a.point, a.image)
            found[a.point] = found.get(a.point, False) or (text is not None and text.message.code == "mark.off")
    return found


def outcome(number, wrong_points=2):
    """Of each mistaken point (photographs, mistaken, size, what was reported, red); of a set what is false or open."""
    actions, truth = a_set(number, wrong_points)
    clicks = red(actions, every=not wrong_points) if not wrong_points or number % 5 == 0 else {}
    found = merge(oriented()[0], folded(actions))
    result = adjusted(found, lambda block: adjust(block, AdjustmentOptions(jobs=1)))
    named, open_points, rows, clean = {}, set(), [], False
    for n in result.notices:
        if n.code.startswith("mark_contradicts"):
            point, *images = n.ids
            if len(images) == 1:
                named.setdefault(point, set()).update(images)
            else:
                open_points.add(point)
            clean |= truth[point][1] == 0
        elif n.code.startswith("marks_untested"):
            open_points |= set(n.ids)
    for point, (n, m, d, images) in truth.items():
        if not m:
            continue
        got = named.get(point, set())
        what = "named" if got == images else "falsely" if got - images else "untestable"
        if what == "untestable" and point not in open_points:
            what = "silent"
        rows.append((n, m, d, what, clicks.get(point)))
    return rows, (clean, any(clicks.values()), [(t[0], p in open_points) for p, t in truth.items() if not t[1]])


def table(rows):
    """Shares in per cent of each size and number of mistaken marks, and of each number of photographs."""
    found = {}
    for label, key in {
        "px, mistaken": lambda r: f"{r[2]} px, {r[1]} mistaken",
        "photographs": lambda r: f"{r[0]} photographs",
        "all": lambda _: "all",
    }.items():
        groups = {}
        for r in rows:
            groups.setdefault(key(r), Counter())[r[3]] += 1
        found[label] = {
            g: {"points": c.total()} | {w: round(100 * c[w] / c.total(), 1) for w in WORDS} for g, c in groups.items()
        }
    return found


def percent(values):
    """Share of what is true."""
    return round(100 * float(np.mean(list(values))), 2)


WORDS = ("named", "untestable", "silent", "falsely")


def main():
    """Run all, print and write the table."""
    parser = argparse.ArgumentParser()
    parser.add_argument("--draws", type=int, default=200)
    parser.add_argument("--clean", type=int, default=400)
    parser.add_argument("--jobs", type=int, default=2)
    given = parser.parse_args()
    sets = given.draws * len(RAYS) * len(WRONG) * len(SIZES) // 2
    with ProcessPoolExecutor(given.jobs) as pool:
        done = list(pool.map(outcome, range(sets), chunksize=20))
        clean = list(pool.map(outcome, range(10**6, 10**6 + given.clean), [0] * given.clean, chunksize=20))
    rows = [r for found, _ in done for r in found]
    clicked = [r for r in rows if r[4] is not None]
    right = [t for _, c in clean for t in c[2]]
    result = {
        "draws_of_each": given.draws, "mistaken": table(rows),
        "clean": {
            "sets": len(clean), "alarms_percent": percent(c[0] for _, c in clean),
            "sets_with_red_click_percent": percent(c[1] for _, c in clean),
            "points_not_tested_percent": {f"{n} photographs": percent(t for k, t in right if k == n) for n in RAYS},
        },
        "right_points_named_percent_of_sets": percent(c[0] for _, c in done),
        "red_after_last_click_percent": {f"{d} px": percent(r[4] for r in clicked if r[2] == d) for d in SIZES},
    }  # fmt: skip
    text = json.dumps(result, indent=1)
    print(text)
    if given.draws >= 200:
        (ROOT / "benchmarks/results/marks.json").write_text(text + "\n", encoding="utf-8")


if __name__ == "__main__":
    main()
