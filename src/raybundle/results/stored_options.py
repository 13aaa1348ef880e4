"""What a result was asked for: the options of its adjustment, read back."""

from __future__ import annotations

from collections.abc import Collection, Mapping
from dataclasses import replace
from pathlib import Path
from typing import Any, cast

import numpy as np

from raybundle.adjustment.records.options import AdjustmentOptions
from raybundle.block import Block, Role
from raybundle.io.reading.trees import read_json
from raybundle.io.table_files import table_file
from raybundle.io.tables import read_table
from raybundle.results.folder import columns_of_table
from raybundle.settings import settings_of


def options_of(result: Mapping[str, Any]) -> AdjustmentOptions:
    """The options that a result.json shows, as far as they are options of the command line."""
    given: dict[str, Any] = {}
    options = as_mapping(result.get("options"))
    for s in settings_of(AdjustmentOptions):
        value = options.get(s.name, s.default)
        given[s.name] = tuple(tuple(v) if isinstance(v, list) else v for v in value) if s.many else value
    return AdjustmentOptions(**given)


def made_as(block: Path, given: Block) -> tuple[Block, AdjustmentOptions]:
    """A block folder's block and the options with which its adjustment is that of the result whose block it is.

    given  the block as it was read; without a result beside the folder it is returned, with the defaults

    Parameters that were chosen then are named; control that was found wrong is checked alone; where control was not
    observed (inner constraints, a minimal datum), its points stand where they were adjusted, which the block's own
    coordinates do not show.  Not stated: which coordinates a minimal datum held.
    """
    folder = block.parent
    if not (folder / "result.json").is_file():
        return given, AdjustmentOptions()
    result = as_mapping(read_json(folder / "result.json").value)
    asked = options_of(result)
    if asked.estimate == "auto":
        chosen = _chosen(result, [c.id for c in given.cameras])
        free = dict.fromkeys((*asked.free, *(pair for pair, is_free in chosen.items() if is_free)))
        hold = dict.fromkeys((*asked.hold, *(pair for pair, is_free in chosen.items() if not is_free)))
        asked = replace(asked, estimate="given", free=tuple(free), hold=tuple(hold))
    if given.points.is_control.any():
        given = _with_roles(given, table_file(folder, "points"), moved=asked.datum in {"inner", "minimal"})
    return given, asked


def _with_roles(block: Block, points: Path, *, moved: bool) -> Block:
    """The block with its control points in the roles that a result's table gives them, and `moved` to their places."""
    table = read_table(points, columns_of_table("points"), least_rows=0, own=True)
    if not table.rows:
        return block
    at = {name: k for k, name in enumerate(table.text["point"])}
    row = np.array([at.get(name, -1) for name in block.points.ids])
    check = np.array([word == Role.CHECK.word for word in table.text["role"]])[row] & (row >= 0)
    p = replace(block.points, role=np.where(check, Role.CHECK, block.points.role).astype(block.points.role.dtype))
    if moved:
        adjusted = np.stack([table.number[c] for c in "XYZ"], axis=1)[row]
        new = p.is_control & (row >= 0)[:, None] & np.isfinite(adjusted)
        p = replace(p, xyz=np.where(new, adjusted, p.xyz))
    return replace(block, points=p)


def _chosen(result: Mapping[str, Any], cameras: Collection[str]) -> dict[tuple[str, str], bool]:
    """(camera, symbol) of parameters of cameras -> whether it was estimated, of any of its images."""
    found: dict[tuple[str, str], bool] = {}
    for key, parameters in as_mapping(result.get("cameras")).items():
        camera = key if key in cameras else next((c for c in cameras if key.startswith(f"{c}/")), "")
        for symbol, given in as_mapping(parameters).items() if camera else ():
            found[camera, symbol] = found.get((camera, symbol), False) or as_mapping(given).get("std") is not None
    return found


def as_mapping(value: Any) -> Mapping[str, Any]:
    """A table of a result.json; empty for what is none."""
    return cast("Mapping[str, Any]", value) if isinstance(value, Mapping) else {}
