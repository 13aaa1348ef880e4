"""Constants of the local variance of depths (src/raybundle/surfaces/depths/roughness.py), from rendered sets.

    python benchmarks/surface_roughness.py FOLDER PROJECT [FOLDER PROJECT ...] [--maps 2] [--density 2]

FOLDER is of tools/render.py, PROJECT of `raybundle orient` with its control. Of some maps of each: errors of depths
along rays, as depth parameters; by least squares of the logarithm of their squares the exponents by which variances
follow their witnesses, of each set and of all, each set with the same weight; by class of place robust chi-squares and
shares beyond five sigma, with the constants that stand in the module and with those that are fitted.
"""

from __future__ import annotations

import argparse
import sys
from dataclasses import replace
from pathlib import Path

import cv2
import numpy as np

ROOT = Path(__file__).resolve().parents[1]
sys.path[:0] = [str(ROOT), str(ROOT / "tools")]

from renderer.classes import NAMES  # noqa: E402
from renderer.judging import robust_chi_square  # noqa: E402
from renderer.truth import read_surface  # noqa: E402

from raybundle.io.block.folder import read_block  # noqa: E402
from raybundle.surfaces.depths import roughness  # noqa: E402
from raybundle.surfaces.depths.depth_map import DepthOptions, depth_map  # noqa: E402
from raybundle.surfaces.depths.pairs import sources_of_each  # noqa: E402
from raybundle.surfaces.depths.rays import ReferenceRays  # noqa: E402

HALF_PX = 4.0
LOG_OF_NORMAL = -1.2704
"""Mean of the logarithm of the square of a standard normal variable"""
NEAR_PX = 25.0
"""Distance up to which the surface is looked for [px]"""
EACH = 40_000
"""Depths of a map that are taken"""
WITNESSES = ("misfit", "near", "bend")


def watched_map(block, chosen, greys, density: int):
    """A depth map, and what its local variances were made of."""
    kept = {}
    local_factor = roughness.local_factor

    def watched(variance, shown, residual, brightness):
        if not kept:
            known = np.isfinite(variance)
            usual = roughness._usual(residual, brightness, known)  # noqa: SLF001
            kept.update(theory=variance.copy(), misfit=shown.misfit, near=shown.near, bend=shown.bend)
            kept["residual"] = np.maximum(residual / (roughness.BEYOND * usual), 1)
        return local_factor(variance, shown, residual, brightness)

    roughness.local_factor = watched
    try:
        return depth_map(block, chosen, greys, DepthOptions(density=density)), kept
    finally:
        roughness.local_factor = local_factor


def some_of(m, kept) -> np.ndarray:
    """Depths that are not doubtful, drawn among all."""
    good = np.flatnonzero((np.isfinite(m.t) & ~m.doubtful & np.isfinite(kept["theory"])).ravel())
    return np.sort(np.random.default_rng(1).choice(good, min(EACH, len(good)), replace=False))


def rows_of(m, kept, at, error, classes) -> np.ndarray:
    """(n, 8) logarithms of squared errors, theory, misfit, near misfit, bend, residual; class, variance.

    Witnesses of neighbours are relative to theory, and to their median in the map.
    """
    known = np.isfinite(kept["theory"])
    with np.errstate(divide="ignore", invalid="ignore"):
        rows = [np.log(error**2), np.log(kept["theory"].ravel()[at])]
        for name in WITNESSES:
            ratio = np.log(kept[name] / kept["theory"])
            rows.append((ratio - np.median(ratio[known & np.isfinite(ratio)])).ravel()[at])
        rows += [np.log(kept["residual"].ravel()[at]), classes, np.log((m.noise + m.roughness).ravel()[at])]
        found = np.vstack(rows).T
    return found[np.isfinite(found).all(axis=1)]


def of_set(folder: Path, project: Path, maps: int, density: int) -> np.ndarray:
    """Rows of some maps of a rendered set."""
    surface = read_surface(folder)
    block = read_block(project / "result" / "block")
    chosen = [s for s in sources_of_each(block) if s.sources]

    def greys(image):
        return cv2.imread(str(folder / "photos" / Path(block.images.file[image]).name), cv2.IMREAD_GRAYSCALE)

    found = []
    for s in chosen[:: max(1, len(chosen) // maps)][:maps]:
        m, kept = watched_map(block, s, greys, density)
        rays, at = ReferenceRays.of(block, s.reference), some_of(m, kept)
        xy, t = m.grid.xy_px.reshape(-1, 2)[at], m.t.ravel()[at].astype(float)
        xyz, by_t = rays.points(xy, t), rays.by_t(xy, t)
        half = HALF_PX * surface.gsd
        good = surface.in_core(xyz)
        at, xyz, by_t = at[good], xyz[good], by_t[good]
        ray = by_t / np.linalg.norm(by_t, axis=1, keepdims=True)
        near = np.abs(surface.window_distances(xyz, ray, half)) < NEAR_PX * surface.gsd
        at, xyz, by_t, ray = at[near], xyz[near], by_t[near], ray[near]
        error = surface.distances(xyz, ray) / np.linalg.norm(by_t, axis=1)
        found.append(rows_of(m, kept, at, error, surface.classes_at(xyz, half)))
    return np.concatenate(found)


def of_portal(project: Path, maps: int, density: int) -> np.ndarray:
    """Rows of some maps of the demonstration set, its orientation exact; all of one class."""
    from tests.surface import portal
    from tests.surface.truth import Portal

    cache = ROOT / ".pytest_cache/d/surface"
    cache.mkdir(parents=True, exist_ok=True)
    truth, own = Portal(cache), read_block(project / "result" / "block")
    images = replace(own.images, centre=truth.block.images.centre, rotation=truth.block.images.rotation)
    block = replace(own, images=images, cameras=truth.block.cameras)
    chosen = [s for s in sources_of_each(own) if s.sources]
    found = []
    for s in chosen[2 :: max(1, len(chosen) // maps)][:maps]:
        m, kept = watched_map(block, s, lambda k: portal.grey(block, k).astype(np.uint8), density)
        at = some_of(m, kept)
        error = m.t.ravel()[at].astype(float) - m.grid.of(truth.depths(s.reference).t).ravel()[at]
        found.append(rows_of(m, kept, at, error, np.full(len(at), NAMES.index("smooth"))))
    return np.concatenate(found)


def main() -> None:
    """All of it."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("sets", nargs="*", type=Path)
    parser.add_argument("--portal", type=Path, help="project of raybundle demo --set demo_data/portal")
    parser.add_argument("--maps", type=int, default=2)
    parser.add_argument("--density", type=int, default=2)
    parser.add_argument("--save", type=Path)
    o = parser.parse_args()
    every = [of_set(a, b, o.maps, o.density) for a, b in zip(o.sets[::2], o.sets[1::2], strict=True)]
    every += [of_portal(o.portal, o.maps, o.density)] if o.portal else []
    if o.save:
        np.savez(o.save, *every)
    for rows in every:
        fitted_to([rows])
    fitted, left = fitted_to(every)
    rows = np.concatenate(every)
    square, theory, kind, stated = rows[:, 0], rows[:, 1], rows[:, 6], rows[:, 7]
    by = theory + rows[:, 2:6] @ fitted[1:] + left / 2
    print("class            n   stated    > 5 sigma   theory   fitted    > 5 sigma")
    for code, name in enumerate(NAMES):
        mine = kind == code
        if mine.sum() >= 100:
            x = [np.exp((square[mine] - v[mine]) / 2) for v in (stated, theory, by)]
            chi, beyond = ([f(v) for v in x] for f in (robust_chi_square, lambda v: 100 * np.mean(v > 5)))
            print(
                f"{name:<12}{mine.sum():>7}{chi[0]:>9.2f}{beyond[0]:>11.2f} %{chi[1]:>9.2f}{chi[2]:>9.2f}"
                f"{beyond[2]:>11.2f} %"
            )


def fitted_to(every: list[np.ndarray]) -> tuple[np.ndarray, float]:
    """Constant and exponents (5,) of sets of rows, and the variance that they leave; printed."""
    rows, root = np.concatenate(every), np.concatenate([np.full(len(r), len(r) ** -0.5) for r in every])
    target = rows[:, 0] - rows[:, 1] - LOG_OF_NORMAL
    design = np.column_stack([np.ones(len(rows)), rows[:, 2:6]])
    fitted, *_ = np.linalg.lstsq(design * root[:, None], target * root, rcond=None)
    left = float(np.average((target - design @ fitted) ** 2, weights=root**2) - np.pi**2 / 2)
    named = zip(("constant", *WITNESSES, "residual"), fitted, strict=True)
    print("  ".join(f"{name} {value:.2f}" for name, value in named) + f"  left {left:.2f}")
    return fitted, left


if __name__ == "__main__":
    main()
