"""Photographs that nothing oriented yet: a project folder in which they can be measured by hand."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Any

from raybundle.commands.begin_settings import BeginSettings
from raybundle.commands.orient import OrientSettings, keep_settings
from raybundle.errors import InputError
from raybundle.io.photos.container import SUFFIXES
from raybundle.io.reading.trees import read_toml
from raybundle.measuring.journal import named_folder
from raybundle.measuring.session import block_folder, holds_block
from raybundle.numerics.progress import Progress, silent
from raybundle.settings import asked, keywords

if TYPE_CHECKING:
    from raybundle.block import Block
    from raybundle.measuring.film import Scans

Notify = Callable[[str], object]
"""Gets lines for people"""


@keywords(BeginSettings)
def begin(
    photos: str | Path | Sequence[str | Path], out: str | Path | None = None, *, notify: Notify = str,
    progress: Progress = silent, **settings: Any,
) -> Path:  # fmt: skip
    """Begin a project of photographs that are to be measured by hand; returns its folder.

    photos    folders and files
    out       project folder; None: PHOTOS-project beside the folder of photographs
    notify      gets a line of each file that is no usable photograph
    settings  calibration, own_camera, library: as of `orient`; film, pixel_mm, film_transformation: scans of film
    raises    InputError where there is no photograph, or something else stands at `out`

    The photographs have their cameras, as `orient` finds them, and no orientation: marks orient them (`rb.mark`).  A
    project that exists at `out` keeps its measurements; new photographs are added.  Where `orient` has a result
    in it, that is what is measured in, and nothing is changed.
    """
    first = Path(photos) if isinstance(photos, str | Path) else Path(next(iter(photos)))
    s = asked(BeginSettings, photos, out or default_project(first), settings)
    if holds_block(s.out / "result"):
        return s.out
    block = _block(s, notify, progress)
    keep_settings(
        OrientSettings(
            photos=tuple(p.resolve() for p in s.photos),
            out=s.out,
            calibration=s.calibration,
            own_camera=s.own_camera,
            library=s.library,
        )
    )
    _keep_film(s)
    _write(block, s.out)
    return s.out


def measuring_folder(source: str | Path, out: str | Path | None = None, notify: Notify = str) -> Path:
    """The folder in which what is measured is kept: as it is given, or a project of the photographs in it.

    source  a project, result or block folder; a project of `orient` that has no result; a folder of photographs
    out     where a project of photographs stands; None: PHOTOS-project beside them
    raises  InputError where it is none of these
    """
    source = Path(source)
    found = standing_folder(source, out)
    if found is not None:
        return found
    if (source / "project.db").is_file():
        _write(_block(_as_asked(source), notify, silent), source)
        return source
    if not has_photographs(source):
        block_folder(source)  # which states what is wrong
    return begin(source, out, notify=notify)


def standing_folder(source: str | Path, out: str | Path | None = None) -> Path | None:
    """The same where it stands already; nothing is made."""
    source = Path(source)
    if holds_block(source):
        return source
    project = Path(out) if out is not None else default_project(source)
    if not (source / "project.db").is_file() and has_photographs(source) and holds_block(project):
        return project
    return None


def default_project(photos: Path) -> Path:
    """Where a project of a folder of photographs stands if nothing else is stated: beside it."""
    whole = photos.resolve()
    folder = named_folder(whole if whole.is_dir() else whole.parent)
    return folder.with_name(f"{folder.name}-project")


def has_photographs(folder: Path) -> bool:
    """Whether a folder holds files that are called as photographs."""
    return folder.is_dir() and any(p.suffix.lower() in SUFFIXES for p in folder.iterdir())


def _as_asked(project: Path) -> BeginSettings:
    """What a run of `orient` without a result was asked for."""
    tree = read_toml(project / "project.toml").tree().get("orient")
    known = tree.get("calibration").text() if tree.has("calibration") else None
    apart = next((n for n in ("own_camera", "separate") if tree.has(n)), "")  # the second: of earlier versions
    return BeginSettings(
        photos=tuple(Path(p.text()) for p in tree.get("photos").items()), out=project,
        calibration=None if known is None else Path(known),
        own_camera=tuple(p.text() for p in tree.get(apart).items()) if apart else (),
        library=not tree.has("library") or bool(tree.get("library").value),
    )  # fmt: skip


def _block(s: BeginSettings, notify: Notify, progress: Progress) -> Block:
    """The photographs alone; raises InputError where some are gone that a project holds."""
    from raybundle.io.block.folder import read_block
    from raybundle.io.block.toml import read_cameras
    from raybundle.io.cameras.library import library_folder
    from raybundle.workflows.unoriented_block import bare_block, of_film

    before = read_block(s.out / "block") if holds_block(s.out / "block") else None
    known = () if s.calibration is None else read_cameras(s.calibration)
    scans = _scans(s)
    library = library_folder() if s.library else None
    if scans is None:
        block = bare_block(
            s.photos,
            s.out.name,
            calibration=known,
            separate=s.own_camera,
            library=library,
            notify=notify,
            progress=progress,
        )
    else:
        known = known or (before.cameras if before is not None else ())
        block = of_film(bare_block(s.photos, s.out.name, notify=notify, progress=progress), known, scans)
    lost = sorted(set() if before is None else set(before.images.ids) - set(block.images.ids))
    if lost:
        raise InputError(
            "project.photographs_missing",
            n=len(lost),
            names=lost,
            file=s.out,
        )
    return block


def _scans(s: BeginSettings) -> Scans | None:
    """What is known of the film that the photographs are scans of: as it is given, or as the project knows."""
    from raybundle.io.block.toml import read_cameras
    from raybundle.io.film.fiducials import read_calibrated
    from raybundle.measuring.film import Scans, read_scans

    if s.film is None:
        return read_scans(s.out)
    if s.calibration is None:
        raise InputError("film.camera_missing")
    cameras = read_cameras(s.calibration)
    if len(cameras) != 1:
        raise InputError("calibration.camera_count", n=len(cameras), file=s.calibration)
    pixel = s.pixel_mm or cameras[0].pixel_mm[0]
    return Scans(calibrated=read_calibrated(s.film), pixel_mm=pixel, model=s.film_transformation)


def _write(block: Block, project: Path) -> None:
    from raybundle.io.block.folder import write_block_files
    from raybundle.io.folders import new_folder

    with new_folder(project / "block", replacing=True) as folder:
        write_block_files(block, folder)


def _keep_film(s: BeginSettings) -> None:
    """Keep what was given of the film in the project."""
    from raybundle.io.folders import new_folder
    from raybundle.measuring.film import FOLDER, write_scans

    scans = _scans(s)
    if s.film is None or scans is None:
        return
    with new_folder(s.out / FOLDER, replacing=True) as folder:
        write_scans(scans, s.film, folder)
