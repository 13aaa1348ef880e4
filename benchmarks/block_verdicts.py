"""Verdicts on simulated blocks: 100 good, 100 weak, 100 wrong by construction; counts of each verdict.

    python benchmarks/block_verdicts.py [blocks of each class=100]

Good: testfield, ring and aerial networks with control or bars.  Weak: right observations that determine little: two
photographs, no rolled image with a free camera, few points, one scale bar, no control.  Wrong: a gross error that a
client would carry away: exchanged, mirrored or shifted control, a length of another unit, points under wrong names, an
image of another camera, a wrong calibration that is held, gross errors in 15 % of the image points, positions of
another datum.  The verdict is "fault" where a fault or an error is stated (status 3), "caution" where a caution is,
else "usable".  A good or weak block must not be a fault (at most 1 %); a wrong one must be.
"""

from __future__ import annotations

import json
import sys
from collections import Counter
from dataclasses import replace

import numpy as np
from scipy.stats import beta

from raybundle import adjust
from raybundle.adjustment.records.options import AdjustmentOptions
from raybundle.errors import InputError, NotSolvable
from raybundle.planning import synthetic_networks
from raybundle.planning.simulate import Survey, simulate

SNOOPING = AdjustmentOptions(jobs=1, estimate="auto", reject="snooping")
FIELD = {"control": 8, "control_sigma": (2e-4, 2e-4, 2e-4), "scale_bars": 2}
GROUND = {"control": 8, "control_sigma": (0.02, 0.02, 0.03)}


def scene_of(kind: str, **plan):
    """A scene and what is known of it."""
    if kind == "testfield":
        return synthetic_networks.field_scene(synthetic_networks.TargetField(**plan)), FIELD
    if kind == "ring":
        return synthetic_networks.ring_scene(synthetic_networks.Ring(**plan)), FIELD
    return synthetic_networks.aerial_scene(synthetic_networks.AerialStrips(**plan)), GROUND


KINDS = ("testfield", "ring", "aerial")


def block_of(kind: str, seed: int, plan=None, **survey):
    """A simulated block."""
    scene, given = scene_of(kind, **(plan or {}))
    return simulate(scene, Survey(seed=seed, **{**given, **survey})).observed


def good(seed: int):
    """Networks as they should be."""
    return KINDS[seed % 3], block_of(KINDS[seed % 3], seed)


def weak(seed: int):
    """Right observations that determine little."""
    ways = {
        "two photographs": lambda: block_of("testfield", seed, {"stations": 2, "frontal": 0}),
        "three photographs": lambda: block_of("testfield", seed, {"stations": 3, "frontal": 0}),
        "no rolled image": lambda: block_of("testfield", seed, {"roll_deg": (0.0,)}),
        "flat and square": lambda: block_of("testfield", seed, {"tilt_deg": 8.0, "depth": 0.0}),
        "few points": lambda: block_of("testfield", seed, {"rows": 3, "columns": 4}),
        "one scale bar": lambda: block_of("ring", seed, control=0, scale_bars=1),
        "three control points": lambda: block_of("aerial", seed, control=3),
        "no control": lambda: block_of("testfield", seed, control=0, scale_bars=0),
        "control in a corner": lambda: block_of("aerial", seed, control=4, control_sigma=(0.2, 0.2, 0.3)),
    }
    name = list(ways)[seed % len(ways)]
    return name, ways[name]()


def with_points(block, change):
    """The block whose control was changed: `change` of its coordinates (k, 3)."""
    control = block.points.is_control.any(axis=1)
    xyz = block.points.xyz.copy()
    xyz[control] = change(xyz[control])
    return replace(block, points=replace(block.points, xyz=xyz))


def shifted(xyz, seed):
    """One point moved by 0.3 of the extent's tenth."""
    out = xyz.copy()
    out[seed % len(xyz), seed % 3] += 0.05 * np.linalg.norm(np.ptp(xyz, axis=0))
    return out


def exchanged(xyz, seed):
    """Two points in each other's place."""
    out = xyz.copy()
    a, b = seed % len(xyz), (seed + 3) % len(xyz)
    out[[a, b]] = xyz[[b, a]]
    return out


def wrong(seed: int):
    """Blocks that must not be used."""
    kind = KINDS[seed % 3]
    rng = np.random.default_rng(seed)

    def lengths(factor):
        block = block_of("testfield", seed)
        d = block.distances
        return block.having(replace(d, length=np.asarray(d.length) * factor))

    def names():
        block = block_of(kind, seed)
        o = block.observations
        image = int(rng.integers(len(block.images)))
        rows = np.flatnonzero(o.image == image)
        point = o.point.copy()
        point[rows] = np.roll(point[rows], 1)
        return replace(block, observations=replace(o, point=point))

    def other_camera():
        block = block_of(kind, seed)
        o = block.observations
        mine = o.image == int(rng.integers(len(block.images)))
        size = np.array([block.cameras[0].width_px, block.cameras[0].height_px]) / 2
        xy = np.where(mine[:, None], size + 0.8 * (o.xy_px - size), o.xy_px)
        return replace(block, observations=replace(o, xy_px=xy))

    def calibration():
        block = block_of(kind, seed)
        camera = block.cameras[0]
        held = replace(camera, estimate=(), values={**camera.values, "c": camera.values["c"] * 1.1})
        return replace(block, cameras=(held,))

    def positions():
        block = block_of(kind, seed, station_sigma=0.01)
        s = block.stations
        step = 0.3 * np.linalg.norm(np.ptp(s.xyz, axis=0))
        return block.having(replace(s, xyz=s.xyz + np.array([0.0, 0.0, step])))

    ways = {
        "control shifted": lambda: with_points(block_of(kind, seed), lambda x: shifted(x, seed)),
        "control exchanged": lambda: with_points(block_of(kind, seed), lambda x: exchanged(x, seed)),
        "control mirrored": lambda: with_points(block_of(kind, seed), lambda x: x[:, [1, 0, 2]]),
        "heights negative": lambda: with_points(block_of(kind, seed), lambda x: x * [1, 1, -1]),
        "lengths in mm": lambda: lengths(1000.0),
        "lengths 2 % long": lambda: lengths(1.02),
        "names of an image": names,
        "another camera": other_camera,
        "calibration of another": calibration,
        "positions of another datum": positions,
        "control of another scale": lambda: with_points(block_of("testfield", seed), lambda x: x * 1.05),
    }
    name = list(ways)[seed % len(ways)]
    return name, ways[name]()


def verdict(block) -> tuple[str, list[str]]:
    """What is said of a block, and why."""
    try:
        result = adjust(block, SNOOPING)
    except (NotSolvable, InputError) as error:
        return "fault", [f"{type(error).__name__}: {error}".splitlines()[0][:120]]
    severity = {n.severity.value for n in result.notices}
    codes = sorted({n.code for n in result.notices if n.severity.value in ("fault", "caution")})
    said = "fault" if "fault" in severity else "caution" if "caution" in severity else "usable"
    return said, codes


def limits(k: int, n: int) -> list[float]:
    """95 % limits of a share (Clopper and Pearson)."""
    low = 0.0 if k == 0 else float(beta.ppf(0.025, k, n - k + 1))
    high = 1.0 if k == n else float(beta.ppf(0.975, k + 1, n - k))
    return [round(low, 4), round(high, 4)]


def main() -> int:
    """All blocks."""
    count = int(sys.argv[1]) if len(sys.argv) > 1 else 100
    table, rows = {}, []
    for name, make in {"good": good, "weak": weak, "wrong": wrong}.items():
        said: Counter[str] = Counter()
        for seed in range(count):
            what, block = make(seed)
            found, why = verdict(block)
            said[found] += 1
            if (name != "wrong" and found == "fault") or (name == "wrong" and found != "fault"):
                rows.append({"class": name, "seed": seed, "what": what, "verdict": found, "why": why})
        table[name] = {v: {"blocks": said[v], "limits": limits(said[v], count)} for v in ("usable", "caution", "fault")}
    print(json.dumps({"blocks_of_each": count, "verdicts": table, "disagreements": rows}, indent=1))
    return int(table["good"]["fault"]["blocks"] > 0.01 * count or table["wrong"]["fault"]["blocks"] < count)


if __name__ == "__main__":
    raise SystemExit(main())
