"""Patches on the demonstration's surfaces, whose places are known: what is stated is what they miss by."""

import csv
from pathlib import Path

import numpy as np

from raybundle.measuring.actions.verbs import Put
from raybundle.studio.snapping import snapped

TRUTH = Path(__file__).parents[2] / "demo_data" / "portal" / "truth" / "observations.csv"


def test_stated_covariances_of_patches_are_true_on_real_surfaces(desk):
    """Clicks within four pixels; reliefs, edges and all, as a hand meets them."""
    desk.session = desk.adjusted()
    true = {}
    with TRUTH.open(encoding="utf-8") as file:
        for row in csv.DictReader(file):
            if row["point"].startswith("P"):
                true.setdefault(row["point"], {})[row["image"]] = float(row["x_px"]), float(row["y_px"])
    ids = {Path(name).stem: i for name, i in zip(desk.block.images.file, desk.block.images.ids, strict=True)}
    rng, e, C = np.random.default_rng(5), [], []
    for point, places in [*true.items()][:400]:
        images = sorted(n for n in places if n in ids)
        if len(images) < 2:
            continue
        first, second = images[:2]
        x, y = places[first]
        desk.journal.append(Put(image=ids[first], point=point, x_px=x, y_px=y, covariance=(1e-4, 1e-4, 0.0)))
        at, turn, off = np.array(places[second]), rng.uniform(0, 2 * np.pi), rng.uniform(0, 4)
        x, y = at + off * np.array([np.cos(turn), np.sin(turn)])
        found = snapped(desk, {"image": ids[second], "x": x, "y": y, "kind": "patch", "point": point})
        if "why" not in found:
            xx, yy, xy = found["cov"]
            e.append(np.array([found["x"], found["y"]]) - at)
            C.append([[xx, xy], [xy, yy]])
    assert len(e) > 100
    square = np.einsum("ni,nij,nj->n", e, np.linalg.inv(C), e)
    # wrong surfaces at steps make the tail wide: the mean lies near 1, not within the band of normal errors
    assert 0.4 < square.mean() / 2 < 1.6
    assert np.median(square) / 1.386 < 1
