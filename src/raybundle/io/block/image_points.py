"""The table of image observations of a block folder."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path

import numpy as np

from raybundle.block import Block, Observations
from raybundle.block.rejection import known_wrong
from raybundle.errors import message
from raybundle.io.block.tables import columns_of, problems_of, require
from raybundle.io.digits import EVERY
from raybundle.io.table_files import Named
from raybundle.io.tables import Column, Table, read_table, write_table
from raybundle.numerics.arrays import Array, Mask


def columns_for(images: dict[str, int], points: dict[str, int]) -> tuple[Column, ...]:
    """What the columns hold; points not yet known are added to `points`."""
    return (
        Column(name="image", kind="reference", known=images, where="images.csv"),
        Column(name="point", kind="new_reference", known=points),
        Column(name="x_px", kind="number"),
        Column(name="y_px", kind="number"),
        Column(name="sx_px", kind="number", limit="> 0"),
        Column(name="sy_px", kind="number", limit="> 0"),
        Column(name="sxy_px2", kind="number", optional=True, empty=True),
        Column(name="rejected", kind="number", optional=True, empty=True),
    )


def no_observations() -> Observations:
    """An empty table."""
    none = np.zeros(0, np.int32)
    return Observations(image=none, point=none, xy_px=np.zeros((0, 2)), cov_px2=np.zeros((0, 3)))


def read_observations(
    path: Path, images: dict[str, int], points: dict[str, int], *, least_rows: int = 1
) -> tuple[Observations, tuple[tuple[str, str], ...]]:
    """The table, and image and point of rows that are known as wrong; points not yet known are added to `points`."""
    table = read_table(path, columns_for(images, points), unique=("image", "point"), least_rows=least_rows, own=True)
    found, wrong = observations_of(path, table)
    image, point = [*images], [*points]
    rows = np.flatnonzero(wrong).tolist()
    return found, tuple((image[int(found.image[k])], point[int(found.point[k])]) for k in rows)


def observations_of(path: Path, table: Table) -> tuple[Observations, Mask]:
    """The rows of a table as image observations, and which are known as wrong; raises InputError for what cannot be."""
    first = table.first_line
    sx, sy = table.number["sx_px"], table.number["sy_px"]
    sxy = np.nan_to_num(table.number.get("sxy_px2", np.zeros(table.rows)))
    wrong = np.nan_to_num(table.number.get("rejected", np.zeros(table.rows)))
    limit = sx * sy
    require(
        path,
        problems_of(
            (wrong != 0) & (wrong != 1), "rejected", lambda k: message("cell.not_a_flag", value=wrong[k]), first
        ),
        problems_of(
            np.abs(sxy) >= limit * (1 - 1e-9),
            "sxy_px2",
            lambda k: message("observation.covariance", sxy_px2=sxy[k], limit_px2=limit[k]),
            first,
        ),
        problems_of(
            (sx < 1e-150) | (sy < 1e-150) | (sx > 1e150) | (sy > 1e150),
            "sx_px",
            lambda k: message("observation.sigma_out_of_range", sx_px=sx[k], sy_px=sy[k]),
            first,
        ),
    )
    found = Observations(
        image=table.index["image"],
        point=table.index["point"],
        xy_px=np.stack([table.number["x_px"], table.number["y_px"]], axis=1),
        cov_px2=np.stack([sx * sx, sy * sy, sxy], axis=1),
    )
    return found, wrong == 1


def write_observations(path: Path, block: Block) -> None:
    """Write the table, with all digits."""
    o = block.observations
    columns: dict[str, Sequence[str] | Array] = {
        "image": Named(block.images.ids, o.image),
        "point": Named(block.points.ids, o.point),
        **columns_of(("x_px", "y_px"), o.xy_px),
        **columns_of(("sx_px", "sy_px"), np.sqrt(o.cov_px2[:, :2])),
    }
    if o.cov_px2[:, 2].any():
        columns["sxy_px2"] = o.cov_px2[:, 2]
    if (wrong := known_wrong(block)).any():
        columns["rejected"] = np.where(wrong, 1.0, np.nan)
    write_table(path, columns, EVERY)
