"""A machined part with coded targets, measured twice."""

from __future__ import annotations

from itertools import combinations
from pathlib import Path

import numpy as np

from raybundle.commands.demonstrations.files import Taken, made_camera, write_photograph, write_rows
from raybundle.numerics.arrays import Array
from raybundle.numerics.progress import Progress
from raybundle.planning.rendered.part import Face, block, card, photograph, plain, target
from raybundle.planning.rendered.rendering import View
from raybundle.planning.synthetic_networks import look_at
from raybundle.targets.codes import sectors
from raybundle.targets.families import family_named

ABOUT = "photographs of a part with coded targets before and after it was loaded, nominal coordinates, lengths"
SEED = 5
FAMILY = "aicon14"
DOT_M, CARD_M = 0.0042, 0.0165
"""Radius of a dot, half the side of a card"""
MADE_M = 0.00003
"""Standard deviation of a bore's place: how well the part was made"""
OFF = {"12": (0.0, 0.00045, 0.0)}
"""A bore that is not where it should be"""
MOVED = {"9": (0.0, 0.0, -0.00042), "15": (0.00035, 0.0, 0.0)}
"""What the load did"""
CERTIFIED_M = 0.000005
BARS = {
    ("101", "102"): ((-0.50, -0.33, 0.012), (-0.50, 0.33, 0.012)),
    ("103", "104"): ((-0.42, -0.42, 0.012), (0.42, -0.42, 0.012)),
}
CHECK_BAR = {"111": -0.42, "112": -0.11, "113": 0.13, "114": 0.42}
"""X of the targets of a third bar"""
BLOCKS = (
    ((-0.36, -0.26, 0.0), (0.36, 0.26, 0.04)),
    ((-0.30, -0.20, 0.04), (-0.06, 0.04, 0.16)),
    ((0.08, -0.06, 0.04), (0.28, 0.18, 0.24)),
)
"""Plate, low and high block: opposite corners"""
ON_PLATE = (
    (-0.32, -0.23), (-0.11, -0.235), (0.10, -0.23), (0.32, -0.23), (0.325, 0.0), (0.32, 0.23), (0.11, 0.235),
    (-0.10, 0.23), (-0.325, 0.22), (-0.33, 0.07), (-0.16, 0.13), (0.015, 0.06),
)  # fmt: skip
"""X, Y; 1 to 12"""
ON_LOW = ((-0.26, -0.16), (-0.10, -0.16), (-0.10, 0.0), (-0.26, 0.0))
"""13 to 16"""
ON_HIGH = ((0.12, -0.02), (0.24, -0.02), (0.24, 0.14), (0.12, 0.14))
"""17 to 20"""
ON_SIDES = (
    ((-0.18, -0.20, 0.10), (0, -1, 0)), ((-0.30, -0.08, 0.10), (-1, 0, 0)), ((0.18, -0.06, 0.14), (0, -1, 0)),
    ((0.28, 0.06, 0.14), (1, 0, 0)), ((0.18, 0.18, 0.14), (0, 1, 0)), ((0.08, 0.06, 0.15), (-1, 0, 0)),
)  # fmt: skip
"""Places and normals; 21 to 26"""
TOP = (0.0, 0.0, 1.0)


def nominal() -> dict[str, tuple[Array, Array]]:
    """Places of the bores [m] and the directions in which their targets face."""
    flat = [(*xy, 0.04) for xy in ON_PLATE] + [(*xy, 0.16) for xy in ON_LOW] + [(*xy, 0.24) for xy in ON_HIGH]
    every = [*((xyz, TOP) for xyz in flat), *ON_SIDES]
    return {str(k + 1): (np.array(xyz), np.array(n, float)) for k, (xyz, n) in enumerate(every)}


def on_bars() -> dict[str, Array]:
    """Targets on the two scale bars and on the one whose lengths are checked."""
    ends = {n: np.array(xyz) for bar, places in BARS.items() for n, xyz in zip(bar, places, strict=True)}
    return ends | {n: np.array([x, 0.40, 0.012]) for n, x in CHECK_BAR.items()}


def stations(rng: np.random.Generator) -> list[tuple[Array, Array]]:
    """Twelve places round the part and above it, the camera rolled by quarter turns."""
    found: list[tuple[Array, Array]] = []
    for k in range(12):
        around, tilt = (k * 45.0 + 10, 42.0) if k < 8 else (k * 90.0 + 40, 16.0)
        a, t = np.radians(around), np.radians(tilt + rng.uniform(-3, 3))
        away = 1.45 * np.array([np.sin(t) * np.cos(a), np.sin(t) * np.sin(a), np.cos(t)])
        centre = away + rng.normal(0, 0.03, 3)
        aim = np.array([0, -0.01, 0.06]) + rng.normal(0, 0.015, 3)
        roll = np.radians((0, 90, 0, -90)[k % 4] + rng.normal(0, 3))
        found.append((centre, look_at(centre, aim, roll)[0]))
    return found


def make(folder: Path, progress: Progress) -> tuple[str, ...]:
    """As `demonstrations` states."""
    rng = np.random.default_rng((SEED, 1))
    wanted = nominal()
    true = {n: xyz + rng.normal(0, MADE_M, 3) + OFF.get(n, (0, 0, 0)) for n, (xyz, _) in wanted.items()}
    bars = on_bars()
    for epoch, load in (("before", {}), ("after", MOVED)):
        there = {n: xyz + load.get(n, (0, 0, 0)) for n, xyz in true.items()}
        _write_photographs(folder / epoch, there, bars, progress)
    rows = [(n, *(f"{1000 * v:.3f}" for v in xyz), "0.2") for n, (xyz, _) in wanted.items()]
    write_rows(folder / "nominal.csv", ("point", "X", "Y", "Z", "tolerance"), rows)
    lengths = [(a, b, f"{1000 * abs(CHECK_BAR[b] - CHECK_BAR[a]):.3f}") for a, b in combinations(CHECK_BAR, 2)]
    write_rows(folder / "lengths.csv", ("from", "to", "length"), lengths)
    reported = [
        f"scale bar {a} - {b}: {np.linalg.norm(bars[a] - bars[b]):.5f} m, sigma {CERTIFIED_M:f} m" for a, b in BARS
    ]
    return (
        "before, after: 12 photographs each of a part with 26 coded targets (aicon14), before and after a load",
        "nominal.csv: nominal coordinates of its bores in mm, with a tolerance of 0.2 mm",
        f"lengths.csv: {len(lengths)} lengths of a bar of {len(CHECK_BAR)} targets in mm",
        *reported,
    )


def _write_photographs(folder: Path, part: dict[str, Array], bars: dict[str, Array], progress: Progress) -> None:
    """The photographs of one day."""
    rng = np.random.default_rng((SEED, 2, len(folder.name)))
    camera = made_camera(
        "measuring", (1600, 1200), 0.0075, c=12.31, x0=0.043, y0=-0.061, K1=-1.6e-4, K2=1.1e-6, P1=7e-6, P2=-5e-6
    )
    day = "18" if folder.name == "before" else "19"
    world = bodies(part, bars)
    for k, (centre, rotation) in enumerate(stations(rng)):
        progress(f"photographs {folder.name}", k / 12)
        view = View(name=f"{folder.name}_{k + 1:02d}.jpg", camera=camera, centre=centre, rotation=rotation)
        pixels = photograph(world, view, np.random.default_rng((SEED, 3, len(folder.name), k)))
        taken = Taken(model="Virtual measuring camera", focal_mm=12.0, when=f"2026:05:{day} 09:{20 + k:02d}:00")
        write_photograph(folder / view.name, pixels, camera, taken)


def bodies(part: dict[str, Array], bars: dict[str, Array]) -> list[list[Face]]:
    """Table with plate and bars, and the two blocks; each target lies on the body that it belongs to."""
    rng = np.random.default_rng((SEED, 4))
    x, y = np.eye(3)[:2]
    table = Face(
        corner=np.array([-0.7, -0.6, -0.001]), right=x, up=y, size=(1.4, 1.2), paint=plain(96, rng, scatter=7), fine=1
    )
    rods = plain(46, rng, scatter=3)
    flat = [table]
    for a, b in (*BARS, ("111", "114")):
        low, high = np.minimum(bars[a], bars[b]), np.maximum(bars[a], bars[b])
        flat += block(low - np.array([0.03, 0.03, 0.012]), high + np.array([0.03, 0.03, -0.0002]), rods)
    metal = [plain(grey, rng) for grey in (150, 165, 172)]
    plate, low, high = (block(np.array(a), np.array(b), paint) for (a, b), paint in zip(BLOCKS, metal, strict=True))
    normals = {n: normal for n, (_, normal) in nominal().items()}
    for n, xyz in bars.items():
        flat.append(_card(n, xyz, np.array(TOP)))
    for n, xyz in part.items():
        at = int(n)
        of = plate if at <= 12 else low if at <= 16 or at in {21, 22} else high
        of.append(_card(n, xyz, normals[n]))
    return [[*flat, *plate], low, high]


def _card(name: str, xyz: Array, normal: Array) -> Face:
    """A coded target, a fifth of a millimetre before its surface."""
    family = family_named(FAMILY)
    code = int(family.code_of(np.array([int(name)]))[0])
    ring = sectors(code, family.bits) * 2 * np.pi / family.bits
    return card(xyz, normal, CARD_M, target(ring, family.ring, DOT_M, CARD_M))
