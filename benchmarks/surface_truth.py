"""Depth maps of the rendered portal against exact depths, their variances against the errors; fountain-p11 by itself.

    python benchmarks/surface_truth.py [--maps 2 7 12 13] [--density 2] [--union 4] [--between 2]
                                       [--pandora PYTHON] [--no-fountain]

portal     the demonstration set, adjusted as `raybundle demo` does it; exact depths by ray casting
           (tests/surface/truth.py).  Of each map: share of the visible pixels that have a depth, robust error, share
           within 20 mm, and chi-squares of the errors by noise, roughness and orientation: the mean, the robust one
           ((median |e / sigma| / 0.6745)^2), shares within 1 and 1.96 sigma and beyond 5 sigma; of all pixels, of
           interior ones (whose eight neighbours on the grid are there), by classes of incidence, sources and contrast
peers      OpenCV's three-way SGBM, and with --pandora (figures apart; six minutes a map) pandora with libSGM, at full
           size on the rectified pair of the reference and its best source, in the same run: robust error, share within
           20 mm, share of the visible pixels
neighbours correlation of normalised errors by distance along the rows, beside the one that is stated
spread     variance of the logarithm of squared normalised errors, less that of normal ones: what the exponents of the
           local variance leave (src/raybundle/surfaces/depths/roughness.py, LEFT)
between    --between DENSITY: of all pairs of maps, orientation exact, the correlation of their errors at one place, and
           the stated one (src/raybundle/surfaces/heights/heights.py, between_maps)
union      --union DENSITY: maps of all photographs, and doubtful depths that others confirm: share of each map's
           visible pixels, their errors; of the object's surface that three or more photographs see (by rays to points
           spread evenly over it) the share at which a map has a depth within 20 mm of the truth
fountain   two maps of one reference with disjoint sources: chi-square of their difference by noise and orientation, and
           by all parts as if the surface disturbed the two independently

Figures go into benchmarks/results/surface_truth.json.
"""

import argparse
import json
import platform
import subprocess
import sys
import tempfile
import time
from collections.abc import Iterator
from dataclasses import dataclass, replace
from itertools import combinations, pairwise
from pathlib import Path

import cv2
import numpy as np

ROOT = Path(__file__).resolve().parents[1]
sys.path.insert(0, str(ROOT))
from tests.surface import portal  # noqa: E402
from tests.surface.truth import PORTAL, Portal  # noqa: E402

from raybundle.adjustment.evaluation.queries import joint_orientation  # noqa: E402
from raybundle.adjustment.system.predict import image_points  # noqa: E402
from raybundle.measuring.session import adjusted_again  # noqa: E402
from raybundle.numerics import native  # noqa: E402
from raybundle.surfaces.depths.depth_map import DepthMap, DepthOptions, depth_map  # noqa: E402
from raybundle.surfaces.depths.fusion import WITNESSES, MapView, agreement  # noqa: E402
from raybundle.surfaces.depths.orientation import shift_covariance  # noqa: E402
from raybundle.surfaces.depths.pairs import PairOfImages, sources_of_each  # noqa: E402
from raybundle.surfaces.depths.rays import ReferenceRays  # noqa: E402
from raybundle.surfaces.depths.transfer import places_in  # noqa: E402
from raybundle.surfaces.heights.heights import SHARED_PHOTOGRAPHS, SHARED_SURFACE, between_maps, between_two  # noqa: E402
from raybundle.surfaces.stages.fusion import MOST_MAPS  # noqa: E402

WORK = ROOT / "benchmarks/work"
FOUNTAIN = ROOT.parent / "shared/data/photos/fountain-p11/images"
INCIDENCES, CONTRASTS = (0, 0.3, 0.5, 0.7, 0.85, 1.01), (0, 6, 9, 12, 16, 999)
LAGS_PX = (4, 8, 16, 24, 48, 80)
BAND, RIM = 240, 40
"""Rows of a rectified pair that pandora matches at once, and around them."""
POINTS, WITHIN_M, SAME_M = 50_000, 0.02, 0.005
"""Over the object; how near a depth has to be to the truth, and a ray to its point."""
SAME_PLACE, LEAST_PLACES = 0.002, 3000
"""How near two exact depths are to be of one place, as a share; places at which two maps are compared at least."""
LEAST = 200
"""Pixels of a class that is told."""


def made(folder: Path, *arguments: str) -> Path:
    """A result of raybundle, made where it is not there."""
    if not (folder / "result").exists():
        folder.parent.mkdir(parents=True, exist_ok=True)
        subprocess.run([sys.executable, "-m", "raybundle", *arguments, "--out", str(folder)], check=True, cwd=ROOT)
    return folder / "result"


def robust(x) -> float:
    return float(np.median(np.abs(x)) / 0.6745)


def shares(x) -> dict[str, float]:
    """Of normalised errors."""
    a = np.abs(x)
    return {
        "pixels": len(x), "chi2_mean": round(float(np.mean(x**2)), 3), "chi2_robust": round(robust(x) ** 2, 3),
        "within_1": round(float(np.mean(a < 1)), 4), "within_1.96": round(float(np.mean(a < 1.96)), 4),
        "beyond_5": round(float(np.mean(a > 5)), 5),
    }  # fmt: skip


def classes(x, values, edges) -> dict[str, float]:
    """Robust chi-square by class."""
    found = {}
    for low, high in pairwise(edges):
        mine = x[(values >= low) & (values < high)]
        if len(mine) >= LEAST:
            found[f"{low:g}-{high:g}"] = round(robust(mine) ** 2, 3)
    return found


@dataclass(frozen=True, slots=True, kw_only=True)
class RectifiedPair:
    """A reference and a source as rows that show the same, the reference with `count` empty columns on its left."""

    left: np.ndarray
    right: np.ndarray
    count: int
    """columns by which the source may lie further left, of which 0 stands for `least` to the depth's far end"""
    least: int
    place: tuple[np.ndarray, np.ndarray]
    """row and column (h, w) of each pixel of the reference in `left` less the empty columns"""
    by_column: np.ndarray
    """(h, w) depth parameter for a column"""

    @classmethod
    def of(cls, block, reference: int, source: int, t_range, greys) -> "RectifiedPair":
        """Turned about their centres so that the base lies along the rows."""
        rays = ReferenceRays.of(block, reference)
        camera = rays.camera
        h, w = camera.height_px, camera.width_px
        y, x = np.mgrid[:h, :w] + 0.5
        d = rays.rays(np.stack([x.ravel(), y.ravel()], axis=1))[1]
        centres, rotations = block.images.centre, block.images.rotation
        base = centres[source] - centres[reference]
        along = base / np.linalg.norm(base)
        forward = -(rotations[reference][2] + rotations[source][2])
        forward -= along * (forward @ along)
        forward /= np.linalg.norm(forward)
        R = np.stack([along, np.cross(forward, along), forward])
        f = camera.values["c"] / camera.pixel_mm[0]
        q = d @ R.T
        u, v = f * q[:, 0] / q[:, 2], f * q[:, 1] / q[:, 2]
        # depth along the rectified axis: X = centre + d / t
        deep = (q[:, 2]).reshape(h, w)
        lows, highs = (np.nanmin(deep) / t_range[1], np.nanmax(deep) / t_range[0])
        least = int(f * np.linalg.norm(base) / highs) - 2
        count = int(np.ceil((f * np.linalg.norm(base) / lows - least + 2) / 16)) * 16
        x0, y0 = np.floor(u.min()), np.floor(v.min())
        columns, rows = int(np.ceil(u.max()) - x0), int(np.ceil(v.max()) - y0)
        pictures = []
        for image, left in ((reference, x0), (source, x0 - least - count)):
            X, Y = np.meshgrid(
                np.arange(columns + (count if image == source else 0)) + left + 0.5, np.arange(rows) + y0 + 0.5
            )
            direction = np.stack([X / f, Y / f, np.ones_like(X)], axis=-1).reshape(-1, 3) @ R
            own = ReferenceRays.of(block, image)
            place = (
                image_points(own.camera, own.rotation, own.centre, own.centre + direction).reshape(*X.shape, 2) - 0.5
            )
            place = np.where(np.isfinite(place), place, -9).astype(np.float32)
            pictures.append(cv2.remap(greys(image), place[..., 0], place[..., 1], cv2.INTER_CUBIC, borderValue=0))
        one = cv2.copyMakeBorder(pictures[0], 0, 0, count, 0, cv2.BORDER_CONSTANT, value=0)
        j, i = np.clip(np.floor(v - y0).astype(int), 0, rows - 1), np.clip(np.floor(u - x0).astype(int), 0, columns - 1)
        return cls(
            left=one, right=pictures[1], count=count, least=least, place=(j.reshape(h, w), i.reshape(h, w)),
            by_column=deep / (f * np.linalg.norm(base)),
        )  # fmt: skip

    def depths(self, columns: np.ndarray) -> np.ndarray:
        """(h, w) depth parameters in the pixels of the reference, of columns as `left` has them; NaN where none are."""
        # the source's canvas starts `least + count` further left, the reference's `count`: what is left is `least`
        found = np.where(self.left > 0, columns, np.nan)[:, self.count :]
        return self.by_column * (found[self.place] + self.least)


def sgbm(pair: RectifiedPair) -> np.ndarray:
    """(h, w) depth parameters by OpenCV's semi-global matching along three paths."""
    matcher = cv2.StereoSGBM_create(
        0, pair.count, 5, P1=200, P2=800, disp12MaxDiff=1, uniquenessRatio=5, speckleWindowSize=100, speckleRange=2,
        preFilterCap=31, mode=cv2.STEREO_SGBM_MODE_SGBM_3WAY,
    )  # fmt: skip
    found = matcher.compute(pair.left, pair.right).astype(np.float32) / 16
    return pair.depths(np.where(found < 0, np.nan, found))


def pandora(pair: RectifiedPair, python: str) -> np.ndarray:
    """(h, w) depth parameters by pandora with libSGM, run by a Python that has them."""
    found = np.full(pair.left.shape, np.nan, np.float32)
    for begin in range(0, len(found), BAND):
        # its costs of all rows at once take more memory than there is; paths from beyond the rim hardly reach further
        rows = slice(max(0, begin - RIM), begin + BAND + RIM)
        with tempfile.TemporaryDirectory() as folder:
            files = [str(Path(folder) / name) for name in ("left.tif", "right.tif")]
            for path, pixels in zip(files, (pair.left, pair.right), strict=True):
                cv2.imwrite(path, pixels[rows])
            script = [python, str(ROOT / "benchmarks/peer_pandora.py"), *files, str(-pair.count), "0", folder]
            subprocess.run(script, check=True, capture_output=True)
            found[begin : begin + BAND] = -np.load(Path(folder) / "disparity.npy")[begin - rows.start :][:BAND]
    return pair.depths(found)


def beside(theirs: np.ndarray, exact: np.ndarray) -> dict[str, float]:
    """A peer's depths: robust error, share within 20 mm, share of the visible pixels."""
    error = np.abs(1 / theirs - 1 / exact)
    there = np.isfinite(error)
    return {
        "error_mm": round(1000 * robust(error[there]), 3),
        "within_20_mm": round(float(np.mean(error[there] < WITHIN_M)), 4),
        "complete": round(float(there.sum() / np.isfinite(exact).sum()), 4),
    }  # fmt: skip


def neighbours(found: DepthMap, variance, e) -> dict[str, dict[str, float]]:
    """Correlation of normalised errors along the rows, measured and stated."""
    x = np.where(np.abs(e / np.sqrt(variance)) < 4, e / np.sqrt(variance), np.nan)
    own = found.noise.astype(float) + found.roughness
    common = float(np.nanmedian((variance - own) / variance))
    told = {}
    for lag in LAGS_PX:
        k = lag // found.grid.stride
        a, b = x[:, k:], x[:, :-k]
        both = np.isfinite(a) & np.isfinite(b)
        stated = common + (1 - common) * float(found.correlation_between(np.array(lag)))
        told[str(lag)] = {
            "measured": round(float(np.corrcoef(a[both], b[both])[0, 1]), 3), "stated": round(stated, 3)
        }  # fmt: skip
    return told


def of_portal(numbers, density: int, peer: str) -> Iterator[list[dict]]:
    """Every map against its truth: those that are done, after each."""
    adjustment = adjusted_again(made(WORK / "portal", "demo", "--set", str(PORTAL)))
    block = adjustment.adjusted
    (ROOT / ".pytest_cache/d/surface").mkdir(parents=True, exist_ok=True)
    truth = Portal(ROOT / ".pytest_cache/d/surface")
    chosen, told = sources_of_each(block), []

    def greys(image):
        return portal.grey(block, image).astype(np.uint8)

    for k in numbers:
        began = time.process_time()
        found = depth_map(block, chosen[k], greys, DepthOptions(density=density)).sure()
        seconds = time.process_time() - began
        joint = joint_orientation(adjustment, (k, *chosen[k].sources))
        variance = found.variance(shift_covariance(block, joint, k, chosen[k].sources, found.t_range))
        depths, grid = truth.depths(k), found.grid
        exact = grid.of(depths.t)
        e = found.t - exact
        known = np.isfinite(e)
        inner = cv2.erode(np.isfinite(found.t).astype(np.uint8), np.ones((3, 3), np.uint8), borderValue=0) > 0
        x = np.where(known, e / np.sqrt(variance), np.nan)
        used = ((found.views[..., None] >> np.arange(len(found.sources))) & 1).sum(axis=-1)
        mm = 1000 * np.abs(1 / found.t - 1 / exact)
        pair = RectifiedPair.of(block, k, chosen[k].sources[0], found.t_range, greys)
        peers = {"sgbm": sgbm(pair)} | ({"pandora": pandora(pair, peer)} if peer else {})
        told.append(
            {
                "map": block.images.file[k], "sources": len(found.sources),
                "seconds": round(seconds, 1), "complete": round(float(known.sum() / np.isfinite(exact).sum()), 4),
                "error_mm": round(robust(mm[known]), 3), "within_20_mm": round(float(np.mean(mm[known] < 20)), 4),
                "peers": {name: beside(theirs, depths.t) for name, theirs in peers.items()},
                "all": shares(x[known]), "interior": shares(x[known & inner]),
                "interior_share": round(float((known & inner).sum() / known.sum()), 3),
                "incidence": classes(x[known], found.incidence[known], INCIDENCES),
                "by_sources": classes(x[known], used[known], (1, 2, 3, 4, 5)),
                "contrast": classes(x[known], found.contrast[known], CONTRASTS),
                "spread": round(float(np.var(np.log(x[known & (mm < 20)] ** 2)) - np.pi**2 / 2), 3),
                "parts_mm": {
                    name: round(float(1000 * np.median((np.sqrt(v) / exact**2)[known])), 3)
                    for name, v in (
                        ("noise", found.noise), ("roughness", found.roughness),
                        ("orientation", np.maximum(variance - found.noise - found.roughness, 0)),
                    )
                },
                "neighbours": neighbours(found, variance, e),
            }
        )  # fmt: skip
        print(json.dumps(told[-1], indent=1), flush=True)
        yield told


def of_union(density: int) -> dict:
    """What all maps together cover, doubtful depths among them that others confirm."""
    adjustment = adjusted_again(made(WORK / "portal", "demo", "--set", str(PORTAL)))
    block = adjustment.adjusted
    (ROOT / ".pytest_cache/d/surface").mkdir(parents=True, exist_ok=True)
    truth = Portal(ROOT / ".pytest_cache/d/surface")
    points = spread(truth)
    chosen = {s.reference: s for s in sources_of_each(block) if s.sources}

    def greys(image):
        return portal.grey(block, image).astype(np.uint8)

    maps, views = {}, {}
    for k, s in chosen.items():
        found = maps[k] = depth_map(block, s, greys, DepthOptions(density=density))
        joint = joint_orientation(adjustment, (k, *s.sources))
        shifts = shift_covariance(block, joint, k, s.sources, found.t_range)
        whole = np.sqrt(found.variance(shifts))
        views[k] = MapView(
            rays=ReferenceRays.of(block, k), grid=found.grid, t=found.t, slopes=found.slopes, whole=whole,
            sigma=np.sqrt(found.noise + found.roughness), doubtful=found.doubtful,
        )  # fmt: skip
        print(block.images.file[k], flush=True)
    seen, covered, alone = np.zeros(len(points), int), np.zeros(len(points), bool), np.zeros(len(points), bool)
    told, errors = {}, []
    for k, found in maps.items():
        stays, x, exact = confirmed(block, chosen[k], maps, views, truth, k)
        visible, place = visible_in(truth, ReferenceRays.of(truth.block, k), points)
        seen += visible
        alone |= right_at(found.sure(), truth, k, points, visible, place)
        covered |= right_at(replace(found, t=np.where(stays, found.t, np.nan)), truth, k, points, visible, place)
        there = np.isfinite(exact)
        told[block.images.file[k]] = {
            "alone": round(float((np.isfinite(found.sure().t) & there).sum() / there.sum()), 4),
            "confirmed": round(float((stays & there).sum() / there.sum()), 4),
            "doubtful": shares(x[stays & found.doubtful & there]), "all": shares(x[stays & there]),
        }  # fmt: skip
        errors.append(x[stays & there])
        print(block.images.file[k], told[block.images.file[k]], flush=True)
    several = seen >= 3
    return {
        "density": density, "points": len(points), "seen_by_three": int(several.sum()),
        "alone": round(float(alone[several].mean()), 4), "covered": round(float(covered[several].mean()), 4),
        "all": shares(np.concatenate(errors)), "maps": told,
    }  # fmt: skip


def confirmed(block, chosen, maps, views, truth: Portal, k: int) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Depths (rows, columns) that stay: sure ones, and doubtful ones that others confirm; errors, all; exact depths."""
    found, mine = maps[k], views[k]
    best = sorted((p for p in chosen.pairs if p.source in maps), key=lambda p: (-p.points, p.source))[:MOST_MAPS]
    others = sorted(p.source for p in best)
    tables = [places_in(block, mine.rays, j, found.t_range) for j in others]
    told = agreement(mine, [views[j] for j in others], tables, others, own=k)
    stays = ~found.doubtful & np.isfinite(found.t)
    known = np.isfinite(found.t)
    doubtful = (told.confirming >= WITNESSES) & (told.against + told.perhaps_against == 0)
    stays[known] |= ~told.sure & doubtful
    exact = found.grid.of(truth.depths(k).t)
    return stays, (found.t - exact) / mine.all_parts, exact


def right_at(found: DepthMap, truth: Portal, image: int, points, visible, place) -> np.ndarray:
    """(n,) whether a map has the right depth of points that its photograph shows."""
    rays, g = ReferenceRays.of(truth.block, image), found.grid
    mine = np.flatnonzero(visible)
    at = place[mine]
    column = np.round((at[:, 0] - g.x0 - 0.5) / g.stride).astype(int)
    row = np.round((at[:, 1] - g.y0 - 0.5) / g.stride).astype(int)
    inside = (row >= 0) & (row < g.rows) & (column >= 0) & (column < g.columns)
    mine, at, row, column = mine[inside], at[inside], row[inside], column[inside]
    du, dv = at[:, 0] - (g.x0 + 0.5 + g.stride * column), at[:, 1] - (g.y0 + 0.5 + g.stride * row)
    t = found.t[row, column] + found.slopes[0, row, column] * du + found.slopes[1, row, column] * dv
    right = np.zeros(len(points), bool)
    right[mine[np.abs(1 / t - 1 / rays.parameter(at, points[mine])) < WITHIN_M]] = True
    return right


def spread(truth: Portal) -> np.ndarray:
    """(n, 3) points spread evenly over the object."""
    vertices, triangles, _ = truth.mesh
    a, b, c = (vertices[triangles[:, k]] for k in range(3))
    area = np.linalg.norm(np.cross(b - a, c - a), axis=1)
    place = (np.arange(POINTS) + 0.5) / POINTS * area.sum()
    mine = np.searchsorted(np.cumsum(area), place)
    return (a[mine] + b[mine] + c[mine]) / 3


def visible_in(truth: Portal, rays: ReferenceRays, points: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """(n,) whether a photograph shows points (n, 3), and where (n, 2) [px]."""
    place = image_points(rays.camera, rays.rotation, rays.centre, points)
    with np.errstate(invalid="ignore"):
        visible = ((place > 0) & (place < [rays.camera.width_px, rays.camera.height_px])).all(axis=1)
    d = points[visible] - rays.centre
    length = np.linalg.norm(d, axis=1)
    met, _ = truth.cast(rays.centre, d / length[:, None])
    visible[visible] = np.abs(met - length) < SAME_M
    return visible, place


def of_pairs_of_maps(density: int) -> dict:
    """Correlation at one place of the errors that two maps have by noise and roughness, and what is stated of it."""
    adjustment = adjusted_again(made(WORK / "portal", "demo", "--set", str(PORTAL)))
    (ROOT / ".pytest_cache/d/surface").mkdir(parents=True, exist_ok=True)
    truth = Portal(ROOT / ".pytest_cache/d/surface")
    images = adjustment.adjusted.images
    exact = replace(images, centre=truth.block.images.centre, rotation=truth.block.images.rotation)
    block = replace(adjustment.adjusted, images=exact, cameras=truth.block.cameras)

    def greys(image):
        return portal.grey(block, image).astype(np.uint8)

    chosen, maps = sources_of_each(adjustment.adjusted), []
    for s in chosen:
        found = depth_map(block, s, greys, DepthOptions(density=density)).sure()
        t = found.grid.of(truth.depths(s.reference).t)
        maps.append((found, ReferenceRays.of(block, s.reference), t, (found.t - t) / np.sqrt(found.variance())))
        print(block.images.file[s.reference], flush=True)
    pairs = []
    for k, j in combinations(range(len(chosen)), 2):
        if told := pair_of_maps(maps[k], maps[j], places_in(block, maps[k][1], j, maps[k][0].t_range)):
            stated = between_maps(one_pair(chosen, k, j, told["angle_deg"]))
            shared = between_two(chosen[k], chosen[j], 90.0) / SHARED_PHOTOGRAPHS
            pairs.append({"maps": [k, j], "shared": round(shared, 4), "stated": stated, **told})
    apart = np.array([p["measured"] - p["stated"] for p in pairs])
    measured, weight = (np.array([p[name] for p in pairs]) for name in ("measured", "places"))
    return {
        "density": density, "mean_measured": round(float(np.average(measured, weights=weight)), 3),
        "mean_stated": between_maps(chosen), "within_0.1": round(float(np.mean(np.abs(apart) < 0.1)), 3),
        "constants": [SHARED_PHOTOGRAPHS, SHARED_SURFACE], "fitted": fitted(pairs),
        "pairs": pairs,
    }  # fmt: skip


def fitted(pairs: list[dict]) -> list[float]:
    """The constants of `between_two` that fit what was measured of the pairs best by least squares; their sigmas."""
    parts = np.array([[p["shared"], max(np.cos(np.radians(p["angle_deg"])), 0.0)] for p in pairs])
    measured = np.array([p["measured"] for p in pairs])
    found, squares, *_ = np.linalg.lstsq(parts, measured, rcond=None)
    variance = np.linalg.inv(parts.T @ parts) * squares[0] / (len(pairs) - 2)
    return [round(float(x), 3) for x in (*found, *np.sqrt(np.diag(variance)))]


def pair_of_maps(mine, other, table) -> dict[str, float]:
    """Correlation of the normalised errors of two maps (map, rays, exact depths, errors) where they show one place."""
    (found, rays, t, x), (there, theirs, t2, x2) = mine, other
    known, g = np.isfinite(x), there.grid
    xy, exact = found.grid.xy_px[known], t[known].astype(float)
    at = table.at(xy, exact)
    column, row = (np.round((at[:, k] - low - 0.5) / g.stride) for k, low in ((0, g.x0), (1, g.y0)))
    with np.errstate(invalid="ignore"):
        inside = np.flatnonzero((column >= 0) & (column < g.columns) & (row >= 0) & (row < g.rows))
    column, row = column[inside].astype(int), row[inside].astype(int)
    again = theirs.parameter(at[inside], rays.points(xy[inside], exact[inside]))
    same = np.abs(again / t2[row, column] - 1) < SAME_PLACE
    a, b = x[known][inside], x2[row, column]
    same &= (np.abs(a) < 3) & (np.abs(b) < 3)
    if same.sum() < LEAST_PLACES:
        return {}
    d, d2 = rays.rays(xy[inside][same])[1], theirs.rays(at[inside][same])[1]
    cosine = (d * d2).sum(axis=1) / np.linalg.norm(d, axis=1) / np.linalg.norm(d2, axis=1)
    return {
        "angle_deg": round(float(np.degrees(np.arccos(np.median(cosine)))), 1), "places": int(same.sum()),
        "measured": round(float(np.corrcoef(a[same], b[same])[0, 1]), 3),
    }  # fmt: skip


def one_pair(chosen, k: int, j: int, angle_deg: float) -> list:
    """The sources of two references, of which only each other is known."""
    return [
        replace(chosen[a], pairs=(PairOfImages(reference=a, source=b, points=1, angle_deg=angle_deg, scale=1.0),))
        for a, b in ((k, j), (j, k))
    ]


def of_fountain(density: int) -> dict:
    """Two maps of one reference with disjoint sources."""
    adjustment = adjusted_again(made(WORK / "fountain", "orient", str(FOUNTAIN)))
    block = adjustment.adjusted
    every = sources_of_each(block)
    best = max(every, key=lambda s: (len(s.sources), s.seen))

    def greys(image):
        path = str(FOUNTAIN / block.images.file[image])
        return cv2.imread(path, cv2.IMREAD_GRAYSCALE | cv2.IMREAD_IGNORE_ORIENTATION)

    parts = best.sources[0::2], best.sources[1::2]
    a, b = (depth_map(block, replace(best, sources=p), greys, DepthOptions(density=density)).sure() for p in parts)
    joint = joint_orientation(adjustment, (best.reference, *parts[0], *parts[1]))
    shifts = shift_covariance(block, joint, best.reference, (*parts[0], *parts[1]), a.t_range)
    both = np.isfinite(a.t) & np.isfinite(b.t)
    sensitivity = np.concatenate([a.shift, -b.shift], axis=2)[both]
    t = a.t[both].astype(float)
    oriented = shifts.of_depths(a.grid.xy_px[both], t, sensitivity)
    noise = (a.noise.astype(float) + b.noise)[both]
    rough = (a.roughness.astype(float) + b.roughness)[both]
    d = (a.t.astype(float) - b.t)[both]
    return {
        "reference": block.images.file[best.reference], "pixels": int(both.sum()),
        "grey_correlation": [round(float(c), 3) for c in a.grey[3, 3:]],
        "relative": {
            name: float(f"{np.median(np.sqrt(v) / t):.2g}")
            for name, v in (("difference", d**2), ("noise", noise), ("roughness", rough), ("orientation", oriented))
        },
        "noise_and_orientation": shares(d / np.sqrt(noise + oriented)),
        "all_parts": shares(d / np.sqrt(noise + rough + oriented)),
    }  # fmt: skip


def keep(name: str, found: dict) -> None:
    """Into the file, beside what it holds of others."""
    path = ROOT / "benchmarks/results/surface_truth.json"
    result = json.loads(path.read_text()) if path.exists() else {}
    result[name] = found
    result["about"] = {
        "instruction_set": native.instruction_set(), "machine": platform.machine(), "opencv": cv2.__version__
    }  # fmt: skip
    path.write_text(json.dumps(result, indent=1) + "\n")


def main() -> None:
    """All of it."""
    parser = argparse.ArgumentParser()
    parser.add_argument("--maps", type=int, nargs="*", default=[2, 7, 12, 13])
    parser.add_argument("--density", type=int, default=2)
    parser.add_argument("--union", type=int, default=0, choices=[0, 1, 2, 4])
    parser.add_argument("--between", type=int, default=0, choices=[0, 1, 2, 4])
    parser.add_argument("--pandora", default="", metavar="PYTHON", help="one that has pandora and its plugin libSGM")
    parser.add_argument("--no-fountain", action="store_true")
    given = parser.parse_args()
    cv2.setNumThreads(1)
    if given.maps:
        for told in of_portal(given.maps, given.density, given.pandora):
            keep("pandora" if given.pandora else "portal", {"density": given.density, "maps": told})
    if given.between:
        keep("between_maps", of_pairs_of_maps(given.between))
    if given.union:
        keep("union", of_union(given.union))
    if not given.no_fountain and FOUNTAIN.exists():
        keep("fountain", of_fountain(4))


if __name__ == "__main__":
    main()
