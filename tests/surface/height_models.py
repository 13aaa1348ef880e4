"""Heights with errors that are correlated as is stated, for tests."""

import numpy as np
from scipy.ndimage import gaussian_filter

from raybundle.surfaces.heights.height_model import HeightModel
from raybundle.surfaces.heights.heights import Heights, within
from raybundle.surfaces.heights.nodes import at_cells, variances

FINE = 4
"""Places along the side of a cell of which its mean is taken"""
BLOCK = 32


def made(height, *, cell=0.01, sigma=1e-3, common=0.0, length=0.8, rng=None, step=0.0, fine=FINE):
    """Heights (rows, columns), with drawn errors where `rng` is given: local ones, a shift and two tilts of all.

    common  of the shift, and of each tilt half of it over a block; None: there are no errors of orientation
    """
    shape = height.shape
    nodes = tuple(-(-n // BLOCK) + 1 for n in shape)
    r, c = np.mgrid[: nodes[0], : nodes[1]]
    each = [] if common is None else [np.ones(nodes), (r - r.mean()) / 2, (c - c.mean()) / 2]
    moved = np.zeros((*nodes, 1, len(each)), np.float32)
    for k, one in enumerate(each):
        moved[..., 0, k] = common * one
    error = np.zeros(shape)
    if rng is not None:
        smooth = length * fine / 2
        noise = gaussian_filter(rng.normal(size=(fine * shape[0], fine * shape[1])), smooth, mode="wrap")
        noise *= np.sqrt(4 * np.pi) * smooth * sigma
        error += noise.reshape(shape[0], fine, shape[1], fine).mean(axis=(1, 3))
        error += at_cells(moved @ rng.normal(size=len(each)), BLOCK, shape)
    flat = np.zeros(shape, np.float32)
    heights = Heights(
        height=(height + error).astype(np.float32), local=flat + np.float32(sigma * np.sqrt(within(length))),
        step=flat + np.float32(step), orientation=np.sqrt(variances(moved, BLOCK, shape)).astype(np.float32),
        point=flat + np.float32(sigma), points=np.full(shape, 5, np.uint16), image=np.zeros(shape, np.int32),
    )  # fmt: skip
    return HeightModel(heights=heights, moved=moved, block=BLOCK, cell=cell, length=length)


def middles(shape, cell=0.01):
    """x and y of the middles of cells, rows downwards."""
    r, c = np.mgrid[: shape[0], : shape[1]] + 0.5
    return c * cell, (shape[0] - r) * cell


def file_of(model, *, unit="m", left=0.0, top=None, plane=None, wkt=""):
    """What heights.toml would say."""
    from raybundle.surfaces.files.heights import HeightFile

    rows, columns = model.shape
    wall = {"origin": [0.0, 0.0, 0.0], "right": [1.0, 0.0, 0.0], "up": [0.0, 0.0, 1.0], "normal": [0.0, -1.0, 0.0]}
    return HeightFile(
        left=left, top=rows * model.cell if top is None else top, cell=model.cell, width=columns, height=rows,
        unit=unit, block="wall", wkt=wkt, plane=plane or ({} if wkt else wall),
    )  # fmt: skip


def folder_of(model, folder, **told):
    """Written as a surface with heights."""
    from raybundle.surfaces.files.heights import write_model

    folder.mkdir(exist_ok=True)
    write_model(model, file_of(model, **told), folder)
    return folder
