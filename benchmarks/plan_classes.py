"""What a plan counts with beforehand, learned from results: sigma of image points, and how often points are found.

python benchmarks/plan_classes.py RESULT=CLASS [RESULT=CLASS ...]      as fountain=natural monstree=phone

RESULTs are result folders of `raybundle orient` or `calibrate`, CLASS what the photographs are.  Of each: the median
standard deviation of an image coordinate of points with three rays or more, and the one that makes as precise points
(median) where all image points have it, which is larger where precise and coarse ones are mixed; and of the photographs
that show a point, by the surface that the points span and what stands before it, the share in which it was measured, by
the angle of the ray to the surface.  The share is told as most / (1 + exp((angle - half) / width)), fitted to the
observed shares of all sets of a class, and of all but one each.
"""

from __future__ import annotations

import argparse
import json
from pathlib import Path

import numpy as np
from scipy.optimize import least_squares
from scipy.spatial import KDTree

from raybundle.objects.sight import Sight
from raybundle.objects.surfels import CORNERS, surface_of_points
from raybundle.planning.network.of_result import points_of_result
from raybundle.results.folder import read_result

OUT = Path(__file__).with_name("results") / "plan_classes.json"
EDGES = np.arange(0, 90, 10)


def of_result(folder: Path) -> dict:
    """What one result tells."""
    result = read_result(folder)
    block, o = result.block, result.block.observations
    used = np.array([not t for t in result.observations.text["rejected"]])
    cov = o.cov_px2[:, :2].mean(axis=1) * result.result["sigma0"] ** 2
    rows, towards, rays = points_of_result(block, used)
    good = rays >= 3
    often = np.isin(o.point, rows[good]) & used
    told = {
        "photographs": len(block.images), "points": int(good.sum()), "rays_mean": float(rays[good].mean()),
        "image_sigma_px": float(np.sqrt(np.median(cov[often]))),
        "image_sigma_rms_px": float(np.sqrt(np.mean(cov[often]))),
    }  # fmt: skip
    told["alike_sigma_px"] = told["image_sigma_px"] * alike(block, np.flatnonzero(often), cov)
    shown, angle = shown_in(block, rows[good], towards[good])
    found = np.zeros((len(block.points), len(block.images)), bool)
    found[o.point[used], o.image[used]] = True
    found = found[rows[good]]
    told["found_but_hidden"] = float((found & ~shown).sum() / found.sum())
    shown |= found
    bins = np.digitize(angle, EDGES) - 1
    told["shown"] = [int((shown & (bins == k)).sum()) for k in range(len(EDGES))]
    told["found"] = [int((found & (bins == k)).sum()) for k in range(len(EDGES))]
    return told


def alike(block, rows, cov):
    """Times the median that one standard deviation of all image points must be for points as precise as they are."""
    o = block.observations
    image, point = o.image[rows], o.point[rows]
    to = block.points.xyz[point] - block.images.centre[image]
    far = np.linalg.norm(to, axis=1)
    ray = to / far[:, None]
    across = (np.eye(3) - ray[:, :, None] * ray[:, None, :]) / far[:, None, None] ** 2

    def sigma(variance):
        N = np.zeros((len(block.points), 3, 3))
        np.add.at(N, point, across / variance[:, None, None])
        used = np.unique(point)
        values = np.linalg.eigvalsh(N[used])
        return np.sqrt(np.sum(1 / np.maximum(values, 1e-12 * values.max()), axis=1))

    return float(np.median(sigma(cov[rows]) / sigma(np.full(len(rows), np.median(cov[rows])))))


def shown_in(block, rows, towards):
    """(n, images) whether photographs show points, and the angles of incidence [deg]."""
    xyz = block.points.xyz[rows]
    surface = surface_of_points(xyz, towards)
    disc = surface.vertices.reshape(-1, CORNERS + 1, 3)
    normal = surface.normals.reshape(-1, CORNERS, 3)[:, 0]
    near = KDTree(disc[:, 0]).query(xyz)[1]
    normal, radius = normal[near], np.linalg.norm(disc[near, 1] - disc[near, 0], axis=1)
    below = np.minimum(0, np.einsum("ij,ij->i", xyz - disc[near, 0], normal))
    lifted = xyz + (0.3 * radius - below)[:, None] * normal  # before the discs that the point itself made
    sight = Sight(surface)
    shown, angle = np.zeros((2, len(rows), len(block.images)))
    for i, (centre, rotation) in enumerate(zip(block.images.centre, block.images.rotation, strict=True)):
        camera = block.cameras[block.images.camera[i]]
        local = rotation @ (xyz - centre).T
        with np.errstate(all="ignore"):
            px = camera.pixel_from_image(camera.sensor.start(local, camera.parameters).T)
            inside = camera.sensor.in_front(local) & (px > 0).all(axis=1)
            inside &= (px < [camera.width_px, camera.height_px]).all(axis=1)
        shown[:, i] = inside & sight.visible(centre, lifted, normal)
        to = centre - xyz
        cosine = np.einsum("ij,ij->i", to, normal) / np.linalg.norm(to, axis=1)
        angle[:, i] = np.degrees(np.arccos(np.clip(cosine, -1, 1)))
    return shown.astype(bool), angle


def fitted(sets: list[dict]) -> dict[str, float]:
    """The curve of shares found over sets that count alike."""
    middle = EDGES + 5
    share = [np.array(s["found"]) / np.maximum(s["shown"], 1) for s in sets]
    enough = [np.array(s["shown"]) > 200 for s in sets]

    def off(p):
        curve = p[0] / (1 + np.exp((middle - p[1]) / p[2]))
        return np.concatenate([(s - curve)[e] for s, e in zip(share, enough, strict=True)])

    fit = least_squares(off, [0.9, 57, 8], bounds=([0.1, 10, 2], [1, 89, 30]))
    return dict(zip(("most", "half_deg", "width_deg"), map(float, fit.x), strict=True)) | {
        "rms": float(np.sqrt(np.mean(fit.fun**2)))
    }


def main() -> None:
    """Learn, print and write."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("results", nargs="+")
    sets, classes = {}, {}
    for text in parser.parse_args().results:
        path, _, name = text.partition("=")
        folder = Path(path)
        sets[folder.name] = of_result(folder / "result" if (folder / "result").is_dir() else folder)
        classes.setdefault(name or "natural", []).append(folder.name)
    told = {"sets": sets, "classes": {}}
    for name, mine in classes.items():
        sigma = [sets[n]["alike_sigma_px"] for n in mine]
        told["classes"][name] = {
            "sets": mine, **fitted([sets[n] for n in mine]),
            "alike_sigma_px": {"median": float(np.median(sigma)), "least": min(sigma), "most": max(sigma)},
            "without": {n: fitted([sets[m] for m in mine if m != n]) for n in mine if len(mine) > 1},
        }  # fmt: skip
    print(json.dumps(told, indent=1))
    OUT.write_text(json.dumps(told, indent=1) + "\n")


if __name__ == "__main__":
    main()
