"""What a sheet writes at the lines of measured lengths: the adjusted length and its standard deviation."""

from __future__ import annotations

import math
from pathlib import Path

import numpy as np

from raybundle.block import Block
from raybundle.io.reading.trees import read_json
from raybundle.io.table_files import table_file
from raybundle.io.tables import read_table
from raybundle.numerics.counting import decimals_for
from raybundle.report.text.numbers import significant
from raybundle.results.folder import columns_of_table


def length_words(folder: Path | None, block: Block) -> dict[str, str]:
    """For each measured length "A - B" its words: 3.7801 m ± 0.9 mm, in space and not in the plane.

    folder  of a result: adjusted lengths, and their standard deviations sigma0 sigma sqrt(1 - r) by the redundancy
            number r of the length (Förstner and Wrobel 2016, section 4.1.3.1); else lengths as they were given
    """
    metres = 1.0 if block.length_unit == "m" else 0.001
    file = None if folder is None else table_file(folder, "distances")
    if folder is None or file is None or not file.is_file() or not (folder / "result.json").is_file():
        d = block.distances
        ends = [(block.points.ids[a], block.points.ids[b]) for a, b in zip(d.start, d.end, strict=True)]
        return {
            f"{a} - {b}": _words(metres * length, metres * sigma)
            for (a, b), length, sigma in zip(ends, d.length.tolist(), d.sigma.tolist(), strict=True)
        }
    result = read_json(folder / "result.json").value
    sigma0 = result.get("sigma0") if isinstance(result, dict) else None
    table = read_table(file, columns_of_table("distances"), least_rows=0, own=True)
    adjusted, sigma, r = table.numbers("adjusted", "sigma", "r").T
    known = sigma0 if isinstance(sigma0, int | float) else float("nan")
    std = known * sigma * np.sqrt(np.clip(1 - r, 0, None))
    return {
        f"{a} - {b}": _words(metres * length, metres * s)
        for a, b, length, s in zip(table.text["from"], table.text["to"], adjusted.tolist(), std.tolist(), strict=True)
        if math.isfinite(length)
    }


def _words(length: float, sigma: float) -> str:
    """Of metres: as many digits as the standard deviation bears, which is reported in millimetres."""
    if not sigma > 0 or not math.isfinite(sigma):
        return f"{length:.4f} m"
    digits = decimals_for(sigma, 6)
    return f"{length:.{digits}f} m ± {significant(1000 * sigma, 2)} mm"
