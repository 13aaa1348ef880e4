"""Masks that were drawn by hand in a project, for its next run."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from raybundle.commands.orient import OrientSettings


def masks_of_run(settings: OrientSettings) -> Path | None:
    """The folder of masks that a run takes: as it was given, and with it what was drawn by hand in the project.

    Where something is drawn, both are written together into PROJECT/measured-masks; the journal stays what counts.
    """
    from raybundle.io.block.folder import read_block  # noqa: PLC0415  (loaded after the help)
    from raybundle.io.photos.photo import find_photos  # noqa: PLC0415
    from raybundle.measuring.journal import journal_path, state_of  # noqa: PLC0415
    from raybundle.measuring.masks import FOLDER, drawn_by_file, write_masks  # noqa: PLC0415
    from raybundle.measuring.session import block_folder, holds_block  # noqa: PLC0415

    out, given = settings.out, settings.masks
    if not holds_block(out):
        return given
    state = state_of(journal_path(out))
    if not state.masks:
        return given
    drawn = drawn_by_file(read_block(block_folder(out)), state)
    photos = find_photos(settings.photos).photos
    if not any(p.name in drawn for p in photos):
        return given
    write_masks(out / FOLDER, photos, drawn, given)
    return out / FOLDER
