"""Heights with errors that are correlated as is stated, for tests."""

import numpy as np
from scipy.ndimage import gaussian_filter

from raybundle.surfaces.height_model import HeightModel
from raybundle.surfaces.heights import Heights, within

FINE = 4
"""Places along the side of a cell of which its mean is taken"""
BLOCK = 32


def made(height, *, cell=0.01, sigma=1e-3, common=0.0, length=0.8, rng=None, step=0.0):
    """Heights (rows, columns), with drawn errors where `rng` is given: local ones, a shift and two tilts of all."""
    shape = height.shape
    blocks = tuple(-(-n // BLOCK) for n in shape)
    r, c = np.mgrid[: blocks[0], : blocks[1]]
    moved = np.stack(
        [np.full(blocks, common), common * (r - r.mean()) / 2, common * (c - c.mean()) / 2], axis=2
    ).astype(np.float32)  # fmt: skip
    error = np.zeros(shape)
    if rng is not None:
        smooth = length * FINE / 2
        noise = gaussian_filter(rng.normal(size=(FINE * shape[0], FINE * shape[1])), smooth, mode="wrap")
        noise *= np.sqrt(4 * np.pi) * smooth * sigma
        error += noise.reshape(shape[0], FINE, shape[1], FINE).mean(axis=(1, 3))
        error += _of_cells(moved @ rng.normal(size=3), shape)
    flat = np.zeros(shape, np.float32)
    heights = Heights(
        height=(height + error).astype(np.float32), local=flat + np.float32(sigma * np.sqrt(within(length))),
        step=flat + np.float32(step), orientation=_of_cells(np.linalg.norm(moved, axis=2), shape).astype(np.float32),
        point=flat + np.float32(sigma), points=np.full(shape, 5, np.uint16), image=np.zeros(shape, np.int32),
    )  # fmt: skip
    return HeightModel(heights=heights, moved=moved, block=BLOCK, cell=cell, length=length)


def _of_cells(of_block, shape):
    return np.kron(of_block, np.ones((BLOCK, BLOCK)))[: shape[0], : shape[1]]


def middles(shape, cell=0.01):
    """x and y of the middles of cells, rows downwards."""
    r, c = np.mgrid[: shape[0], : shape[1]] + 0.5
    return c * cell, (shape[0] - r) * cell


def file_of(model, *, unit="m", left=0.0, top=None, plane=None, wkt=""):
    """What heights.toml would say."""
    from raybundle.workflows.height_files import HeightFile

    rows, columns = model.shape
    plane = plane or {"origin": [0.0, 0.0, 0.0], "right": [1.0, 0.0, 0.0], "up": [0.0, 0.0, 1.0],
                      "normal": [0.0, -1.0, 0.0]}  # fmt: skip
    return HeightFile(
        left=left, top=rows * model.cell if top is None else top, cell=model.cell, width=columns, height=rows,
        unit=unit, block="wall", wkt=wkt, plane={} if wkt else plane,
    )  # fmt: skip


def folder_of(model, folder, **told):
    """Written as a surface with heights."""
    from raybundle.workflows.height_files import write_model

    folder.mkdir(exist_ok=True)
    write_model(model, file_of(model, **told), folder)
    return folder
