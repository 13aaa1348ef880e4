"""Wrong codes of ring targets with a tenth of the ring hidden by a grey wedge; counts with exact bounds.

    python benchmarks/wrong_codes.py [shots] [processes]      or  python benchmarks/run.py wrong_codes

A shot is a target of the family, drawn as a picture, photographed through a random homography (dot radius 4 to 12 px,
tilt to 60 degrees), blurred, lit unevenly, with noise; both polarities.  The wedge begins anywhere, has any grey from a
fifth to four fifths between dark and light, and covers the ring alone or reaches beyond it, half of the shots each.
Nothing of the decoder's model is used.  Many shots lie side by side in one photograph.

Rates are of shots, and of reads (targets that were given a number); bounds are those of Clopper and Pearson 1934,
one-sided, 95 %.  The network's check is the program's own: each wrong number is put into a simulated, oriented
network that shows every number of the family, where the program's adjustment decides which image observations are
blunders; a number seen twice in a photograph loses its name, as `marks_of` has it.  What it does not tell: dirt that
gives one target the same wrong number in several photographs makes a point of its own, in the right place and under a
wrong name.
"""

from __future__ import annotations

import json
import math
import os
import sys
import time
from concurrent.futures import ProcessPoolExecutor
from dataclasses import replace
from multiprocessing import get_context
from pathlib import Path

import cv2
import numpy as np
from scipy.stats import beta

from raybundle.adjustment.decision.decide import decide
from raybundle.adjustment.records.options import AdjustmentOptions
from raybundle.planning.simulate import Survey, simulate
from raybundle.planning.synthetic_networks import TargetField, field_scene
from raybundle.targets.codes import sectors
from raybundle.targets.detect import DetectionOptions, detect_targets
from raybundle.targets.families import families

sys.path.insert(0, str(Path(__file__).resolve().parents[1]))

from tests.targets.render import mirrored, plane_view

NAMES = ("aicon12", "aicon14", "agisoft12", "agisoft14")
SHOTS, WHOLE = 41_600, 2_560
"""Of each family: with a wedge, without."""
HIDDEN = 0.1
"""Share of the ring under the wedge."""
FINE = 3
"""Samples along a pixel."""
FINEST = 64
"""Samples to the radius of a dot as it is drawn."""
CELLS = 8
"""Targets along a side of a photograph."""
RADII, TILTS, BLURS, NOISES, CONTRASTS = (4.0, 12.0), (0.0, 60.0), (0.4, 1.0), (1.0, 4.0), (100.0, 180.0)
GREYS = (0.2, 0.8)
"""Of the wedge, between dark and light."""
CONFIDENCE = 0.95
NEAR_PX = 3.0
"""Distance from a target's centre up to which a read is one of it."""
TOGETHER = 20
"""Wrong numbers put into one network."""


def drawn(family, code, scale, wedge):
    """A target (h, w), 0 ground to 255 dot, `scale` samples to the radius; wedge: begin, outer radius, grey."""
    finer = max(1, round(FINEST / scale))  # edges by counting
    size = 2 * math.ceil(family.ground * scale) + 2
    picture = np.zeros((finer * size, finer * size), np.uint8)

    def fill(outline, grey):
        at = finer * (size / 2 + scale * outline * [1, -1]) - 0.5
        cv2.fillPoly(picture, [np.round(16 * at).astype(np.int32)], grey, cv2.LINE_8, 4)

    def arc(radius, a, b):
        t = np.linspace(a, b, max(8, int(abs(b - a) * 30)))
        return radius * np.stack([np.cos(t), np.sin(t)], axis=1)

    fill(arc(1.0, 0, 2 * np.pi), 255)
    for a, b in sectors(code, family.bits) * 2 * np.pi / family.bits:
        fill(np.concatenate([arc(family.ring[1], a, b), arc(family.ring[0], b, a)]), 255)
    if wedge is not None:
        begin, outer, grey = wedge
        end = begin + 2 * np.pi * HIDDEN
        fill(np.concatenate([arc(outer, begin, end), arc(1.5, end, begin)]), round(255 * grey))
    return cv2.resize(picture, (size, size), interpolation=cv2.INTER_AREA)


def cell(rng, family, side, hidden):
    """A photographed target (side, side) in grey values, its position in the family, its place, its parameters."""
    k = int(rng.integers(len(family)))
    radius, tilt = rng.uniform(*RADII), np.radians(rng.uniform(*TILTS))
    wedge = None
    if hidden:
        outer = family.ring[1] if rng.integers(2) else family.ground - 0.05
        wedge = (rng.uniform(0, 2 * np.pi), outer, rng.uniform(*GREYS))
    scale = FINE * radius
    picture = drawn(family, int(family.codes[k]), scale, wedge)
    half = min(side, 2 * math.ceil(radius * family.ground + 2)) / 2
    low = int(side / 2 - half)
    size = side - 2 * low
    centre = side / 2 + rng.uniform(-0.5, 0.5, 2)
    H = plane_view(radius, tilt, rng.uniform(0, 2 * np.pi), rng.uniform(0, 2 * np.pi), centre - low)
    assert not mirrored(H)
    middle = picture.shape[0] / 2 - 0.5
    plane_from_picture = np.array([[1, 0, -middle], [0, 1, -middle], [0, 0, scale]])
    sample_from_pixel = np.array([[FINE, 0, -0.5], [0, FINE, -0.5], [0, 0, 1]])
    fine = cv2.warpPerspective(
        picture, sample_from_pixel @ H @ plane_from_picture, (FINE * size, FINE * size), flags=cv2.INTER_LINEAR
    )
    fine = cv2.GaussianBlur(fine.astype(np.float32), (0, 0), rng.uniform(*BLURS) * FINE)
    share = np.zeros((side, side), np.float32)
    share[low : low + size, low : low + size] = cv2.resize(fine, (size, size), interpolation=cv2.INTER_AREA) / 255
    if rng.integers(2):
        share = 1 - share
    t = (np.arange(side) + 0.5) / side - 0.5
    slope = rng.uniform(-0.3, 0.3, 2)
    light = 1 + slope[0] * t[None, :] + slope[1] * t[:, None]
    grey = (40 + rng.uniform(*CONTRASTS) * share) * light
    grey += rng.uniform(*NOISES) * rng.standard_normal(grey.shape, np.float32)
    told = {"radius_px": round(radius, 1), "tilt_deg": round(float(np.degrees(tilt)))}
    if wedge is not None:
        told |= {"grey": round(wedge[2], 2), "beyond": bool(wedge[1] > family.ring[1])}
    return grey, k, centre, told


def batch(task):
    """Shots of one photograph after the other: counts, and every wrong read."""
    name, seed, photographs, hidden = task
    cv2.setNumThreads(1)
    family, rng = families[name], np.random.default_rng(seed)
    side = 2 * math.ceil(RADII[1] * family.ground + 4)
    right, wrong = 0, []
    for _ in range(photographs):
        image = np.zeros((CELLS * side, CELLS * side), np.uint8)
        shots = []
        for n in range(CELLS**2):
            row, column = divmod(n, CELLS)
            grey, k, centre, told = cell(rng, family, side, hidden)
            image[row * side : (row + 1) * side, column * side : (column + 1) * side] = np.clip(np.round(grey), 0, 255)
            shots.append((int(family.ids[k]), centre + np.array([column, row]) * side, told))
        d = detect_targets(image, family, DetectionOptions(uncoded="none"))
        for id_, xy, margin in zip(d.id.tolist(), d.xy_px, d.margin, strict=True):
            row, column = int(xy[1] // side), int(xy[0] // side)
            true, place, told = shots[row * CELLS + column]
            if id_ == true and np.hypot(*(xy - place)) < NEAR_PX:
                right += 1
            else:
                wrong.append({"true": true, "read": id_, "margin": round(float(margin), 3), **told})
    return name, hidden, photographs * CELLS**2, right, wrong


def kept_by_the_network(name, wrong):
    """How many of wrong reads (true id, read id) survive the adjustment's search for blunders."""
    family = families[name]
    columns = math.ceil(math.sqrt(1.4 * len(family)))
    plan = TargetField(columns=columns, rows=math.ceil(len(family) / columns), stations=8, frontal=2)
    survey = Survey(
        image_sigma_px=0.05, points="approximate", orientation="approximate", approximate=1e-3, interior="exact"
    )
    given = simulate(field_scene(plan), survey).observed
    number = {int(i): n for n, i in enumerate(family.ids)}
    left = 0
    for first in range(0, len(wrong), TOGETHER):
        rng = np.random.default_rng(first)
        o = given.observations
        point = o.point.copy()
        mislabelled = []
        for true, read in wrong[first : first + TOGETHER]:
            rows = np.flatnonzero(o.point == number[true])
            row = int(rng.choice(rows))
            twice = ((o.image == o.image[row]) & (point == number[read])).any()
            if not twice:  # else `marks_of` leaves both without a name
                point[row] = number[read]
                mislabelled.append(row)
        block = replace(given, observations=replace(o, point=point))
        result = decide(block, AdjustmentOptions(reject="snooping", robust_start=True))
        left += sum(not result.image_observations.rejected[row] for row in mislabelled)
    return left


def bounds(count, of):
    """Clopper and Pearson: lower and upper bound of a rate, each at CONFIDENCE."""
    low = beta.ppf(1 - CONFIDENCE, count, of - count + 1) if count else 0.0
    high = beta.ppf(CONFIDENCE, count + 1, of - count) if count < of else 1.0
    return float(low), float(high)


def rates(count, of):
    """A count with its rate and bounds."""
    low, high = bounds(count, of)
    return {"count": count, "of": of, "rate": count / max(of, 1), "lower_bound": low, "upper_bound": high}


def main():
    """Measure and print."""
    shots = int(sys.argv[1]) if len(sys.argv) > 1 else SHOTS
    processes = int(sys.argv[2]) if len(sys.argv) > 2 else 2
    began = time.perf_counter()
    each = 10
    tasks = []
    for f, name in enumerate(NAMES):
        for hidden, number in ((True, shots), (False, WHOLE)):
            parts = math.ceil(number / (each * CELLS**2))
            tasks += [(name, 10_000 * f + 5_000 * hidden + n, each, hidden) for n in range(parts)]
    for variable in ("OMP_NUM_THREADS", "OPENBLAS_NUM_THREADS", "MKL_NUM_THREADS"):
        os.environ[variable] = "1"  # of the processes to come, which have a processor each
    with ProcessPoolExecutor(processes, mp_context=get_context("spawn")) as pool:
        done = list(pool.map(batch, tasks, chunksize=4))
    out = {"confidence": CONFIDENCE, "hidden_share": HIDDEN}
    for name in NAMES:
        part = {}
        for hidden, key in ((True, "hidden"), (False, "whole")):
            mine = [d for d in done if d[0] == name and d[1] == hidden]
            number, right = sum(d[2] for d in mine), sum(d[3] for d in mine)
            wrong = [w for d in mine for w in d[4]]
            reads = right + len(wrong)
            part[key] = {
                "right": right, "recall": right / number, "wrong_of_shots": rates(len(wrong), number),
                "wrong_of_reads": rates(len(wrong), reads),
            }  # fmt: skip
            if hidden:
                left = kept_by_the_network(name, [(w["true"], w["read"]) for w in wrong])
                part[key]["wrong_of_shots_after_network"] = rates(left, number)
                part[key]["list"] = wrong[:50]
        out[name] = part
    out["seconds"], out["processes"] = time.perf_counter() - began, processes
    json.dump(out, sys.stdout, indent=1)


if __name__ == "__main__":
    main()
