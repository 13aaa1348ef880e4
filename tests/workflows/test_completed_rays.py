"""Where track points are looked for: only images that show enough of the same are asked."""

from itertools import permutations

import numpy as np

from raybundle.matching.refine import NEIGHBOURS_FROM, TrackPoints
from raybundle.planning.simulate import Survey, simulate
from raybundle.ties.precise import candidates
from tests.orientation.scenes import facade


def test_candidates_lie_in_images_with_enough_points_in_common():
    block = simulate(facade(3000, 5, 3), Survey(seed=3, orientation="exact", points="exact")).observed
    o = block.observations
    rng = np.random.default_rng(3)
    keep = np.flatnonzero(rng.random(len(o)) < 0.7)
    lone = int(o.image.max())
    keep = keep[(o.image[keep] != lone) | (np.cumsum(o.image[keep] == lone) < NEIGHBOURS_FROM)]
    points = TrackPoints(
        image=o.image[keep], point=o.point[keep], xy_px=o.xy_px[keep],
        scale_px=np.ones(len(keep)), angle=np.zeros(len(keep)),
    )  # fmt: skip
    references = np.sort(np.unique(points.point, return_index=True)[1])
    found = candidates(block, points, references)
    seen = [set(points.point[points.image == i].tolist()) for i in range(len(block.images))]
    images = permutations(range(len(seen)), 2)
    asked = {(i, j) for i, j in images if len(seen[i] & seen[j]) >= NEIGHBOURS_FROM}
    pairs = set(zip(points.image[found.reference].tolist(), found.image.tolist(), strict=True))
    assert len(found.reference) > 50
    assert pairs <= asked
    assert lone not in found.image
    assert all(p not in seen[i] for i, p in zip(found.image.tolist(), found.point.tolist(), strict=True))
