"""Ground panels found by themselves (`raybundle mark find`): found of visible, false ones, and how precisely.

    python benchmarks/ground_panels.py [--flights 10] [--copr PROJECT]

Figures go into benchmarks/results/ground_panels.json:

rendered  flights over rolling ground with twelve panels of four kinds, of which one is not laid out and one has wrong
          coordinates; the block lies 3 m from its control
copr      PROJECT is the set copr-uav, oriented with four of its control points; its marks by hand are the reference
          (plan coordinates by hand-held GPS, so that control points contradict each other by metres)
"""

import argparse
import json
import os
import sys
import time
from pathlib import Path

import numpy as np

ROOT = Path(__file__).resolve().parents[1]
sys.path.insert(0, str(ROOT))
from tests.measuring.panel_flight import flight  # noqa: E402

from raybundle.io.block.folder import read_block  # noqa: E402
from raybundle.io.geo.coordinate_systems import frame_from_mapping  # noqa: E402
from raybundle.io.photos.photo import find_photos, read_grey  # noqa: E402
from raybundle.measuring.panel_search import search_panels  # noqa: E402
from raybundle.measuring.session import Session  # noqa: E402

DATA = Path(os.environ.get("RAYBUNDLE_DATA", ROOT.parent / "shared/data")) / "photos/copr-uav"
REACH, RIGHT_PX = 6.0, 1.5


def rendered(flights):
    """Figures of rendered flights."""
    total = dict.fromkeys(("points", "found", "false_points", "marks", "visible", "false_marks"), 0)
    off, chi, missed = [], [], {}
    for seed in range(1, flights + 1):
        rng = np.random.default_rng(1000 + seed)
        out, wrong = (f"G{k + 1}" for k in rng.choice(12, 2, replace=False))
        made = flight(seed, left_out=(out,), wrong={wrong: np.array([*rng.normal(0, 1, 2), 0.0])})
        session = Session.of_block(made.block, None)
        done = search_panels(session, made.given, dict.fromkeys(made.given, 0.01), REACH, made.pictures.get)
        found = {f.point for f in done.found}
        visible = [p for p in made.given if p not in {out, wrong} and sum(q == p for _, q in made.seen) >= 3]
        total["points"] += len(visible)
        total["found"] += len(found & set(visible))
        total["false_points"] += len(found - set(visible))
        for p in set(visible) - found:
            missed[done.missed[p]] = missed.get(done.missed[p], 0) + 1
        total["visible"] += sum(p in found for _, p in made.seen)
        for f in done.found:
            for image, m in f.marks.items():
                at = made.seen.get((image, f.point))
                d = np.array([m.x_px, m.y_px]) - (at if at is not None else np.nan)
                if at is None:
                    continue  # cut by the rim
                total["marks"] += 1
                if np.hypot(*d) > RIGHT_PX:
                    total["false_marks"] += 1
                    continue
                xx, yy, xy = m.covariance
                off.append(float(np.hypot(*d)))
                chi.append(float(d @ np.linalg.solve(np.array([[xx, xy], [xy, yy]]), d)) / 2)
    return {**total, "missed": missed, "rms_px": round(float(np.sqrt(np.mean(np.square(off)))), 3),
            "chi_square": round(float(np.mean(chi)), 2)}  # fmt: skip


def copr(project, sigma):
    """Figures of copr-uav beside its marks by hand."""
    block = read_block(project / "result/block")
    frame = frame_from_mapping(json.loads((project / "result/result.json").read_text())["frame"])
    given, hand = {}, {}
    for line in (DATA / "gcp_list.txt").read_text().splitlines()[1:]:
        x, y, _, u, v, image, point = line.split()
        given[point] = frame.local_from_crs(np.array([[float(x), float(y), np.nan]]))[0]
        hand[image, point] = np.array([float(u), float(v)])
    files = {p.name: p for p in find_photos([DATA / "images"]).photos}
    began = time.process_time()
    done = search_panels(
        Session.of_block(block, None), given, dict.fromkeys(given, sigma), REACH,
        lambda i: read_grey(files[block.images.ids[i]]),
    )  # fmt: skip
    marks = {(i, f.point): m for f in done.found for i, m in f.marks.items()}
    off = {f"{i} {p}": round(float(np.hypot(*(hand[i, p] - [m.x_px, m.y_px]))), 2)
           for (i, p), m in marks.items() if (i, p) in hand}  # fmt: skip
    return {
        "points": len(given), "found": sorted(f.point for f in done.found), "missed": dict(done.missed),
        "marks": len(marks), "beside_hand_px": off, "cpu_s": round(time.process_time() - began, 1),
    }  # fmt: skip


def main():
    """Print and write the figures."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--flights", type=int, default=10)
    parser.add_argument("--copr", type=Path)
    asked = parser.parse_args()
    found = {"rendered": rendered(asked.flights)}
    if asked.copr is not None:
        found |= {f"copr_sigma_{s}_m": copr(asked.copr, s) for s in (0.2, 2.0)}
    text = json.dumps(found, indent=1)
    print(text)
    (ROOT / "benchmarks/results/ground_panels.json").write_text(text + "\n", encoding="utf-8")


if __name__ == "__main__":
    main()
