"""The cells of heights and the pixels of an orthophoto that a surface is asked for, in one plane."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from raybundle.block import Block
from raybundle.errors import phrase
from raybundle.numerics.arrays import Array
from raybundle.surfaces.grid import HeightGrid, HeightPlane
from raybundle.workflows.object_plane import Plane
from raybundle.workflows.rectify import Grid, grid_over, two_digits, usual_pixel, whole_pixels

if TYPE_CHECKING:
    from raybundle.surfaces.run import Surface

POINTS = 2.0
"""Points of a depth map along the side of a cell, where nobody states how large cells are: most have some then."""
EDGE, LOOKED_AT = 1e-3, 5
"""Share of the points beyond each edge of the area that is proposed, and one in so many that show it."""
TEXTURE_PX = 8192
"""Longer side of the picture on a mesh, where no other is asked for: what graphics cards take."""

MOST_VERTICES = 2e6
"""Of a mesh: what programs that show meshes still turn"""


@dataclass(frozen=True, slots=True, kw_only=True)
class Grids:
    """What is asked for; None: it is not."""

    plane: Plane | None = None
    heights: HeightGrid | None = None
    orthophoto: Grid | None = None
    reported: tuple[str, ...] = ()
    """remarks"""


def area_of_points(surface: Surface, grid: HeightGrid) -> tuple[int, Array]:
    """How many points lie beside a grid, and left, bottom, right, top in whole cells that hold nearly all of them.

    At each edge EDGE of the points are left out, which may be wrong ones far away; it is never less than the grid.
    """
    g, outside, some = grid.grid, 0, list[Array]()
    for cloud in surface.parts():
        uv = grid.plane.coordinates(cloud.xyz)[:, :2]
        at = grid.cells(uv)
        outside += int(((at < 0) | (at >= [g.width, g.height])).any(axis=1).sum())
        some.append(uv[::LOOKED_AT])
    low, high = np.quantile(np.concatenate(some), [EDGE, 1 - EDGE], axis=0)
    mine = np.array([g.left, g.top - g.height * g.pixel, g.left + g.width * g.pixel, g.top])
    area = np.concatenate([np.minimum(low, mine[:2]), np.maximum(high, mine[2:])])
    return outside, whole_pixels(area, g.pixel)


def grids_over(
    block: Block, plane: Plane, extent: Array | None, *, density: int, heights: float | None,
    orthophoto: float | None, mesh: float | None, reported: tuple[str, ...],
) -> Grids:  # fmt: skip
    """The grids over a part of a plane.

    extent      left, bottom, right, top; None: where the points of the plane lie
    density     every so many pixels of a photograph has a depth
    heights, orthophoto, mesh  sides of cells, pixels and triangles; None: not asked for
    raises      InputError where a cell is larger than the area, and where there would be too many
    """
    area = plane.extent if extent is None else extent
    pixel, name = usual_pixel(block, plane), "dsm"
    cell, least = heights, two_digits(POINTS * density * pixel)
    if cell is None:
        name = "ortho" if orthophoto is not None else "mesh"
        cell = two_digits(max(POINTS * density * pixel, orthophoto or 0.0))
    elif cell < 0.75 * least:
        reported = (
            *reported,
            phrase("surface_remark.fine_cells", cell=cell, density=density, pixel=pixel, least=least),
        )
    grid_over(area, cell, setting=name)  # as asked for, before it is made whole cells
    grid = grid_over(whole_pixels(area, cell) if extent is None else area, cell, setting=name)
    picture = None
    whole = np.array([grid.left, grid.top - grid.height * grid.pixel, grid.left + grid.width * grid.pixel, grid.top])
    if orthophoto is not None:
        picture = grid_over(whole, orthophoto, setting="ortho")
    elif mesh is not None:
        longest = max(whole[2] - whole[0], whole[3] - whole[1])
        picture = grid_over(whole, max(pixel, float(longest) / TEXTURE_PX), setting="mesh")
    if mesh is not None:
        grid_over(whole, mesh, most=MOST_VERTICES, setting="mesh")
    return Grids(
        plane=plane, heights=HeightGrid(plane=HeightPlane.of(plane), grid=grid), orthophoto=picture, reported=reported
    )
