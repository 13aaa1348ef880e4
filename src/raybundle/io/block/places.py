"""Where the block of a project, of a result or of a block folder may lie."""

from __future__ import annotations

from pathlib import Path


def block_places(folder: Path) -> tuple[Path, ...]:
    """Folders that may hold it, of which the first with a block.toml does."""
    return folder / "result" / "block", folder / "block", folder
