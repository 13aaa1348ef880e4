"""The page of sources of images: rows of docs/reference/sources.toml, held against registries and tests."""

from __future__ import annotations

import re
import tomllib
from collections.abc import Collection
from pathlib import Path
from typing import Any

from raybundle.io.calibrations import calibration_formats
from raybundle.io.scenes import scene_formats
from raybundle.io.trajectories import trajectory_formats
from raybundle.platforms import instrument_models
from raybundle.scenes.kinds import scene_kinds
from raybundle.sensors import sensor_models

ROOT = Path(__file__).resolve().parents[1]
REFERENCE = ROOT / "docs/reference"
KEYS = {"name", "formats", "models", "tests", "data", "missing", "reads"}
DATA = {"published", "simulated", "invented", "none", "none of this satellite"}
HEAD = """# Sources of images

| test data | meaning |
|---|---|
| published | a file or block that others published, with their numbers where there are any |
| simulated | images of known truth |
| invented | files in the vendor's form with known geometry |
"""


def page(sensor_pages: Collection[str]) -> str:
    """The page; raises ValueError for a row that names a format, model or test that does not exist.

    sensor_pages  models that have a page of their own
    """
    parts = [HEAD]
    for group in tomllib.loads((REFERENCE / "sources.toml").read_text(encoding="utf-8"))["group"]:
        parts.append(
            f"## {group['title']}\n\n| source | read | model | test | data | missing |\n|---|---|---|---|---|---|"
        )
        parts += [_row(row, sensor_pages) for row in group["rows"]]
        parts.append("")
    return "\n".join(parts)


def _row(row: dict[str, Any], sensor_pages: Collection[str]) -> str:
    if set(row) - KEYS or row["data"] not in DATA:
        raise ValueError(f"{row['name']}: unknown key or kind of data")
    formats = {**scene_formats, **trajectory_formats, **calibration_formats}
    models = {*sensor_models, *scene_kinds, *instrument_models}
    lost = [n for n in row["formats"] if n not in formats] + [n for n in row["models"] if n not in models]
    lost += [t for t in row["tests"] if not _stands(t)]
    if lost:
        raise ValueError(f"{row['name']}: {', '.join(lost)} does not exist")
    read = [formats[n].title for n in row["formats"]] + ([row["reads"]] if "reads" in row else [])
    used, tested = [_linked(m, sensor_pages) for m in row["models"]], list(map(_called, row["tests"]))
    cells = ["; ".join(read), ", ".join(used), ", ".join(tested), row["data"], row.get("missing", "")]
    return f"| {row['name']} | " + " | ".join(c or "–" for c in cells) + " |"


def _stands(test: str) -> bool:
    file, _, name = test.partition("::")
    path = ROOT / file
    return path.is_file() and re.search(rf"^def {name}\(", path.read_text(encoding="utf-8"), re.MULTILINE) is not None


def _called(test: str) -> str:
    return f"`{test.removeprefix('tests/').replace('::', ' ')}`"


def _linked(model: str, sensor_pages: Collection[str]) -> str:
    return f"[{model}](sensors/{model}.md)" if model in sensor_pages else model
