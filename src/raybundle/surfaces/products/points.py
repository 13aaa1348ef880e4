"""Product: the cloud as points.ply, with colours, standard deviations and what else is known of each point."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from pathlib import Path

import numpy as np

from raybundle.io.formats.ply import write_in_parts
from raybundle.numerics.arrays import Array
from raybundle.surfaces.product import Context, Product, Written, register
from raybundle.surfaces.run import Surface
from raybundle.surfaces.state import Cloud

POINTS = "points.ply"


def columns_of(cloud: Cloud) -> Mapping[str, Array]:
    """What is stated of each point beside place and colour, by name."""
    axes = {f"sigma_{a}": cloud.sigma[:, k] for k, a in enumerate("xyz")}
    parts = {f"sigma_{a}": cloud.parts[:, k] for k, a in enumerate(("noise", "roughness", "orientation"))}
    seen = {"rays": cloud.views.astype(np.int32), "maps": cloud.confirmed.astype(np.int32)}
    return {**axes, **parts, **seen, "incidence": cloud.incidence, "image": cloud.image}


def _write(surface: Surface, out: Path, context: Context) -> Written:
    unit, ids = context.unit, surface.block.images.ids
    comments = [f"unit {unit}" if unit else 'scale = "free"', "sigma_* one standard deviation"]
    comments += [f"image {i} {ids[i]}" for i, _ in surface.clouds]

    def parts() -> Iterator[tuple[Array, Array, Mapping[str, Array]]]:
        for cloud in context.points.parts():
            yield cloud.xyz, cloud.colour, columns_of(cloud)

    write_in_parts(out / POINTS, len(context.points), parts(), tuple(comments))
    return Written(files=(out / POINTS,), reported=())


PRODUCT = register(Product(name="", files=(POINTS,), write=_write, of_cloud=True))
