"""`raybundle photos` and `raybundle frames`: what is known of photographs, and photographs of a video."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import MISSING, dataclass
from pathlib import Path
from typing import TYPE_CHECKING, Any

from raybundle.numerics.progress import Progress, silent
from raybundle.settings import POSITIVE, Range, keywords, made, path_of, setting

if TYPE_CHECKING:
    from raybundle.io.photos.cameras import CameraGroup
    from raybundle.io.photos.photo import Found
    from raybundle.io.photos.video import Frames


@dataclass(frozen=True, slots=True, kw_only=True)
class PhotosSettings:
    """Which photographs are looked at."""

    photos: tuple[Path, ...]
    """folders and files"""
    calibration: Path | None = setting(None, "Stored calibrations to match.", metavar="CAMERAS.toml")


@dataclass(frozen=True, slots=True, kw_only=True)
class KnownPhotos:
    """What is known of photographs before they are oriented."""

    found: Found
    """photographs with what they say, and files left out with the reason"""
    cameras: tuple[CameraGroup, ...]
    """each with its photographs and starting values"""


@dataclass(frozen=True, slots=True, kw_only=True)
class FramesSettings:
    """How many frames of which video become photographs."""

    video: Path
    """any file that OpenCV decodes"""
    out: Path = setting(MISSING, "New or empty folder for the photographs.", metavar="FOLDER")
    count: int | None = setting(None, "Number of frames, evenly spaced by image motion.", limits=Range(low=1))
    every: float | None = setting(None, "Take one frame every so many seconds.", metavar="SECONDS", limits=POSITIVE)
    motion: float = setting(
        0.08, "Image motion from frame to frame, as a share of the longer side. Applies without {count} and {every}.",
        limits=POSITIVE,
    )  # fmt: skip


@keywords(PhotosSettings)
def photos(photos: str | Path | Sequence[str | Path], *, progress: Progress = silent, **settings: Any) -> KnownPhotos:
    """What is known about some photographs: cameras, starting values, positions, files left out.

    photos    folders and files
    settings  as of the command line, by the names of `PhotosSettings`: calibration="cameras.toml"
    raises    InputError for files that do not exist
    """
    inputs = (photos,) if isinstance(photos, str | Path) else photos
    return run_photos(made(PhotosSettings, {"photos": tuple(Path(p) for p in inputs), **settings}), progress)


def run_photos(settings: PhotosSettings, progress: Progress = silent) -> KnownPhotos:
    """Read what the photographs say, and group them into cameras."""
    from raybundle.io.block.toml import read_cameras
    from raybundle.io.photos.cameras import camera_groups
    from raybundle.io.photos.photo import find_photos

    found = find_photos(settings.photos, progress=progress)
    stored = () if settings.calibration is None else read_cameras(settings.calibration)
    return KnownPhotos(found=found, cameras=tuple(camera_groups(found.photos, stored)))


@keywords(FramesSettings)
def frames(video: str | Path, out: str | Path, *, progress: Progress = silent, **settings: Any) -> Frames:
    """Choose sharp frames of a video by image motion and write them as photographs, with frames.csv beside them.

    video     any file that OpenCV decodes
    out       new or empty folder
    settings  as of the command line, by the names of `FramesSettings`: count=60, or every=2.0 (seconds)
    raises    InputError where the file is no video, or `out` holds something

    Limits: the camera constant; many cameras crop and stabilise electronically for video.
    """
    given = {"video": path_of("video", video), "out": path_of("out", out), **settings}
    return run_frames(made(FramesSettings, given), progress)


def run_frames(settings: FramesSettings, progress: Progress = silent) -> Frames:
    """Extract what the settings ask for."""
    from raybundle.io.photos.video import FrameOptions, extract_frames

    s = settings
    options = FrameOptions(count=s.count, every_s=s.every, motion=s.motion)
    return extract_frames(s.video, s.out, options, progress=progress)
