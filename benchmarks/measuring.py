"""Measuring by hand: the journal killed while it is written, and how long answers take.

python benchmarks/measuring.py [--kills 100]       figures into benchmarks/results/measuring.json
"""

import argparse
import json
import sys
import tempfile
import time
from pathlib import Path

import numpy as np

ROOT = Path(__file__).resolve().parents[1]
sys.path.insert(0, str(ROOT))
from tests.measuring.test_journal import check_kept, killed_while_writing  # noqa: E402

from raybundle.measuring.actions.verbs import Put  # noqa: E402
from raybundle.measuring.journal import Journal, entries_of  # noqa: E402
from raybundle.measuring.names import Known  # noqa: E402
from raybundle.measuring.position import locate  # noqa: E402
from raybundle.measuring.predict import predict, visible  # noqa: E402
from raybundle.measuring.session import Session  # noqa: E402
from raybundle.measuring.state import EMPTY, folded  # noqa: E402
from raybundle.planning.simulate import Survey, simulate  # noqa: E402
from raybundle.planning.synthetic_networks import Ring, ring_scene  # noqa: E402
from raybundle.workflows.adjust import adjust  # noqa: E402


def killed(kills):
    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder) / "measured.db"
        acknowledged = killed_while_writing(path, kills, seed=2)
        check_kept(path, acknowledged)
        return {"kills": kills, "acknowledged": len(acknowledged), "kept": len(entries_of(path)), "lost": 0, "twice": 0}


def milliseconds(what, count=50):
    times = []
    for k in range(count):
        began = time.perf_counter()
        what(k)
        times.append(1000 * (time.perf_counter() - began))
    return round(float(np.median(times)), 2)


def answers(stations):
    scene = ring_scene(Ring(stations=stations, rings=3))
    block = simulate(scene, Survey(image_sigma_px=0.3, control=5, orientation="exact", points="exact")).observed
    session = Session.of(adjust(block))
    o = block.observations
    p = int(np.argmax(block.ray_count))
    rows = [(block.images.ids[i], xy) for i, q, xy in zip(o.image, o.point, o.xy_px, strict=True) if q == p][:5]
    state = folded([Put(image=i, point="new", x_px=x, y_px=y) for i, (x, y) in rows])
    images, points = block.images.ids, block.points.ids
    used = [k for k in range(len(points)) if session.joint.takes_part(k)]
    return {
        "images": len(images), "points": len(points), "observations": len(o),
        "predict_adjusted_point": milliseconds(
            lambda k: predict(session, EMPTY, points[used[k % len(used)]], images[k % len(images)])
        ),
        "intersect_five_marks": milliseconds(lambda _: locate(session, state, "new")),
        "predict_by_five_marks": milliseconds(lambda k: predict(session, state, "new", images[k % len(images)])),
        "visible": milliseconds(lambda k: visible(session, EMPTY, points[used[k % len(used)]])),
    }  # fmt: skip


def appended():
    known = Known.of_photos({"a": (4000, 3000)})
    with tempfile.TemporaryDirectory() as folder, Journal.open(Path(folder) / "measured.db", known) as journal:
        return milliseconds(lambda k: journal.append(Put(image="a", point=f"p{k}", x_px=1.0, y_px=2.0)), 300)


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("--kills", type=int, default=100)
    given = parser.parse_args()
    result = {"killed": killed(given.kills), "milliseconds": [answers(16), answers(32)], "append_ms": appended()}
    print(json.dumps(result, indent=1))
    (ROOT / "benchmarks/results/measuring.json").write_text(json.dumps(result, indent=1) + "\n")


if __name__ == "__main__":
    main()
