"""Masks that were drawn by hand in a project, for its next run."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from pathlib import Path
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from raybundle.io.photos.photo import Photo


def masks_of_run(photos: Sequence[Path], given: Path | None, project: Path) -> Path | None:
    """The folder of masks that a run of `orient` takes: as it was given, with what was drawn by hand in the project.

    Where something is drawn, both are written together into PROJECT/measured-masks; the journal stays what counts.
    """
    from raybundle.io.photos.photo import find_photos

    return _with_drawn(project, given, lambda: find_photos(photos).photos, project)


def masks_of_result(source: Path, given: Path | None, folders: Sequence[Path], into: Path) -> Path | None:
    """The folder of masks of what a result shows: as given, else as its project was, with what was drawn there.

    folders  in which the photographs are
    into     folder in whose measured-masks both are written together, where something is drawn
    """
    from raybundle.io.block.folder import read_block
    from raybundle.measuring.actions.masks import photographs_in
    from raybundle.measuring.session import given_block
    from raybundle.pipeline.project import masks_given
    from raybundle.workflows.sources import result_within

    def photos() -> Sequence[Photo]:
        return photographs_in(read_block(given_block(source)), folders)

    return _with_drawn(source, given or masks_given(result_within(source)), photos, into)


def _with_drawn(project: Path, given: Path | None, photos: Callable[[], Sequence[Photo]], into: Path) -> Path | None:
    """The given folder, or one of those masks and the drawn ones."""
    from raybundle.io.block.folder import read_block
    from raybundle.measuring.actions.masks import FOLDER, drawn_by_file, write_masks
    from raybundle.measuring.journal import journal_path, state_of
    from raybundle.measuring.session import given_block, holds_block

    if not holds_block(project):
        return given
    state = state_of(journal_path(project))
    if not state.masks:
        return given
    drawn = drawn_by_file(read_block(given_block(project)), state)
    found = photos()
    if not any(p.name in drawn for p in found):
        return given
    write_masks(into / FOLDER, found, drawn, given)
    return into / FOLDER
