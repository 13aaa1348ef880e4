"""Photographs that are mirrored: found, and none of ordinary sets accused.

    python benchmarks/mirrored.py FOLDER ... [--most 16] [--draws 60]

FOLDER     photographs of one scene, none of them mirrored
--most     photographs of each, evenly spread
--draws    of each number of mirrored photographs: single ones, neighbours, any; fewer than half
Each pair is matched as it is and with one photograph mirrored; what is mirrored is drawn from these two.  Prints for
each set what is found in the set as it is, and of the draws how many are found exactly, found as possible, found with
other photographs, not found.  Not found may mean that they hang on nothing, and take no part.
"""

from __future__ import annotations

import argparse
from pathlib import Path

import cv2
import numpy as np

from raybundle.io.photos.photo import find_photos
from raybundle.matching.features import Described, Features, feature_number
from raybundle.matching.methods import feature_method
from raybundle.matching.verify import verify
from raybundle.ties.mirrored import Mirrored, mirrored_among, same_handed
from raybundle.ties.points import exact_grey_of

METHOD = feature_method("rootsift")
LONGEST_PX, CHANCE = 2000, 30
"""Sizes of the photographs; matches below which chance may make a pair of so few photographs."""
Pictures = list[tuple[Features, tuple[int, int]]]


def pictures(folder: Path, most: int) -> Pictures:
    """Features and sizes of photographs."""
    photos = find_photos([folder]).photos
    chosen = np.unique(np.linspace(0, len(photos) - 1, min(most, len(photos))).round().astype(int))
    found: Pictures = []
    for photo in (photos[k] for k in chosen):
        grey = exact_grey_of(photo)
        scale = min(1.0, LONGEST_PX / max(grey.shape))
        grey = cv2.resize(grey, None, fx=scale, fy=scale, interpolation=cv2.INTER_AREA).astype(np.uint8)
        h, w = grey.shape
        found.append((METHOD.detect(grey, feature_number(w, h, 5000)), (w, h)))
    return found


def matched(one: tuple[Features, tuple[int, int]], other: tuple[Features, tuple[int, int]], *, mirror: bool) -> int:
    """Verified matches of two photographs."""
    (f, s), (g, t) = one, other
    xy = np.column_stack([s[0] - f.xy_px[:, 0], f.xy_px[:, 1]]) if mirror else f.xy_px
    d = METHOD.mirrored(f.descriptors) if mirror else f.descriptors
    a = Described(xy_px=xy, descriptors=d, size_px=s)
    b = Described(xy_px=g.xy_px, descriptors=g.descriptors, size_px=t)
    found = verify(0, 1, xy, g.xy_px, METHOD.match(a, b), s, t).matches
    return len(found) if not mirror or same_handed(xy[found[:, 0]], g.xy_px[found[:, 1]]) else 0


def counts(p: Pictures) -> tuple[np.ndarray, np.ndarray]:
    """(n, n) matches of all pairs as they are, and mirrored."""
    plain, mirror = (np.zeros((len(p), len(p)), int) for _ in range(2))
    for i in range(len(p)):
        for j in range(i + 1):
            mirror[i, j] = mirror[j, i] = matched(p[i], p[j], mirror=True)
            if i != j:
                plain[i, j] = plain[j, i] = matched(p[i], p[j], mirror=False)
    return plain, mirror


def judged(plain: np.ndarray, mirror: np.ndarray) -> Mirrored | None:
    """What is found of such counts."""
    n = len(plain)
    ends = np.argwhere(np.triu(np.ones((n, n), bool), 1))
    count = plain[ends[:, 0], ends[:, 1]]
    asked = lambda i, j: int(mirror[i, j])  # noqa: E731
    return mirrored_among(ends, np.where(count < CHANCE, 0, count), n, asked, asked)


def drawn(plain: np.ndarray, mirror: np.ndarray, draws: int, rng: np.random.Generator) -> dict[str, int]:
    """What becomes of draws of mirrored photographs."""
    n, told = len(plain), {"exact": 0, "possible": 0, "others": 0, "not found": 0}
    for t in range(draws):
        size = 1 if t % 3 == 0 else int(rng.integers(1, max(2, (n + 1) // 2)))
        start = rng.integers(n)
        out = (start + np.arange(size)) % n if t % 3 < 2 else rng.choice(n, size, replace=False)
        if 2 * size >= n:
            continue
        chosen = np.isin(np.arange(n), out)
        across = chosen[:, None] != chosen
        found = judged(np.where(across, mirror, plain) * (1 - np.eye(n, dtype=int)), np.where(across, plain, mirror))
        if found is None:
            told["not found"] += 1
        elif not found.certain:
            told["possible"] += 1
        else:
            told["exact" if set(found.photographs) == set(out.tolist()) else "others"] += 1
    return told


def main() -> None:
    """Run them."""
    parser = argparse.ArgumentParser()
    parser.add_argument("folders", nargs="+", type=Path)
    parser.add_argument("--most", type=int, default=16)
    parser.add_argument("--draws", type=int, default=60)
    given = parser.parse_args()
    rng = np.random.default_rng(1)
    for folder in given.folders:
        plain, mirror = counts(pictures(folder, given.most))
        print(f"{folder}: {len(plain)} photographs; as they are: {judged(plain, mirror) or 'none'}", flush=True)
        print(f"  {drawn(plain, mirror, given.draws, rng)}", flush=True)


if __name__ == "__main__":
    main()
