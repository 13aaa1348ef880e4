"""What a plan of a result's stations promises, beside what its adjustment states."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import numpy as np
from scipy.cluster.vq import kmeans2
from scipy.spatial import KDTree

from raybundle.adjustment.system.datum import GOOD
from raybundle.objects.surface import SurfacePoints
from raybundle.planning.measured import measured_kinds
from raybundle.planning.network.expected import Expected, Networks, has_depth
from raybundle.planning.network.of_result import good_points, surface_of_result
from raybundle.planning.network.site import Access, Site
from raybundle.results.folder import read_result

POINTS = 4000
PATCHES = 60
"""Of the map of a surface with many points; of others the map is that of the points"""
IN_EACH = 10
SELDOM = 0.5
"""Photographs in which a point is to be found on average, below which a plan knows nothing of it"""


def achieved(folder: Path, name: str, scale: float) -> dict:
    """Predicted and stated, of one result."""
    result = read_result(folder)
    block = result.block
    kind = measured_kinds[name]
    rows, _ = good_points(block)
    stated = np.sqrt(np.mean(result.points.numbers("sX", "sY", "sZ") ** 2, axis=1))
    known = rows[np.isfinite(stated[rows])]
    rows = known[:: max(1, len(known) // POINTS)]
    surface = surface_of_result(block)
    middle = surface.vertices[surface.triangles].mean(axis=1)
    normal = surface.normals[KDTree(middle).query(block.points.xyz[rows])[1]]
    camera = block.cameras[0]
    free = tuple(
        s for s, p in result.result["cameras"][camera.id].items()
        if p["status"] not in {"held", "not determinable", "not significant"}
    )  # fmt: skip
    everywhere = Access(low=np.full(3, -1e6), high=np.full(3, 1e6))
    o = block.observations
    used = np.isin(o.point, rows)
    cov = o.cov_px2[used, :2].mean(axis=1) * result.result["sigma0"] ** 2
    of_result = float(np.sqrt(np.median(cov)))
    site = Site(
        surface=surface, points=SurfacePoints(xyz=block.points.xyz[rows], normal=normal),
        camera=replace(camera, estimate=free), access=everywhere, sigma_px=kind.sigma_px / scale,
        found=kind.found, incidence_deg=89.0,
    )  # fmt: skip
    told = {"class": name, "image_sigma_px": site.sigma_px, "image_sigma_of_result_px": of_result, "free": free}
    networks = Networks(site, least_rays=0)
    parts = networks.parts(block.images.centre, block.images.rotation)
    seen = np.concatenate([p.points for p in parts])
    found = np.bincount(seen, np.concatenate([p.share for p in parts]), minlength=len(rows))
    good = (found >= SELDOM) & has_depth(np.sum([p.V for p in parts], axis=0))
    told["seen_once_or_never"] = float(1 - good.mean())
    site = replace(site, points=SurfacePoints(xyz=site.points.xyz[good], normal=normal[good]))
    networks = Networks(site, least_rays=0)  # points that are found less than twice on average were found none the less
    parts = networks.parts(block.images.centre, block.images.rotation)
    e = networks.expected(parts)
    if not isinstance(e, Expected):
        raise SystemExit(f"{folder}: a network of these stations and points does not hold together")
    for _ in range(3):  # inner constraints over points that are well determined, as the adjustment takes them
        e = Networks(site, least_rays=0, carriers=e.sigma < GOOD * np.median(e.sigma)).expected(parts)
        assert isinstance(e, Expected)
    rows = rows[good]
    ratio = e.sigma / stated[rows]
    told["points"] = len(rows)
    told["rays"] = [float(e.rays.mean()), float(np.bincount(o.point, minlength=len(block.points))[rows].mean())]
    told["median_ratio"] = float(np.median(ratio))
    told["ratio_quantiles"] = [float(v) for v in np.quantile(ratio, [0.1, 0.25, 0.75, 0.9])]
    patch = np.arange(len(rows))
    if len(rows) > IN_EACH * PATCHES:
        patch = kmeans2(site.points.xyz, PATCHES, seed=1, minit="++")[1]
    least = IN_EACH if len(rows) > IN_EACH * PATCHES else 1
    maps = [
        (np.median(e.sigma[patch == k]), np.median(stated[rows][patch == k]))
        for k in np.unique(patch) if (patch == k).sum() >= least
    ]  # fmt: skip
    predicted, adjusted = np.array(maps).T
    told["patches"] = len(maps)
    told["maps_correlation"] = float(np.corrcoef(np.log(predicted), np.log(adjusted))[0, 1])
    told["largest_ratio"] = float(predicted.max() / adjusted.max())
    told["with_sigma_of_result"] = {
        "median_ratio": told["median_ratio"] * of_result / site.sigma_px,
        "largest_ratio": told["largest_ratio"] * of_result / site.sigma_px,
    }
    return told
