"""Result folders: written whole or not at all, and read again for comparison."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from raybundle.block import Block
from raybundle.io.tables import Table


@dataclass(frozen=True, slots=True, kw_only=True)
class ResultFolder:
    """A result folder as it was read: `table.text["point"]`, `table.number["sX"]` (NaN where empty)."""

    path: Path
    result: Mapping[str, Any]
    """result.json: sigma0, redundancy, cameras, correlations, warnings ...; see the reference of the format."""
    block: Block
    """RESULT/block: the adjusted values."""
    images: Table
    """text image, camera, file; number X ... kappa_deg, sX ... skappa_deg"""
    points: Table
    """text point, role; number X, Y, Z, sX, sY, sZ, rays"""
    observations: Table
    """text image, point, rejected; number x_px ... mdby_px"""
    control: Table
    check: Table
    distances: Table
    stations: Table
