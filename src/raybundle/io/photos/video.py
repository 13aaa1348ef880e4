"""Photographs from a video: frames chosen by sharpness and by image motion.

The image motion between neighbouring frames is that of a similarity transform fitted to tracked points (Lucas
and Kanade 1981 on corners of Shi and Tomasi 1994); summed up along the video it states how much the view has
changed.  The video is cut into pieces, and a sharp frame near the middle of each piece is taken.
"""

from __future__ import annotations

import math
from collections.abc import Iterator
from dataclasses import dataclass
from datetime import timedelta
from fractions import Fraction
from pathlib import Path
from typing import Any

import numpy as np

from raybundle.errors import InputError, phrase
from raybundle.io.digits import COUNT, Figures, Places
from raybundle.io.folders import check_free, new_folder
from raybundle.io.photos.movie import MovieMetadata, read_movie_metadata
from raybundle.io.reading.files import check_regular
from raybundle.io.tables import write_table
from raybundle.numerics.arrays import Array, Index
from raybundle.numerics.progress import Progress, silent

ANALYSED_PX = 480
"""Longer side of the reduced frames in which sharpness and motion are measured."""
SMOOTHED_S = 0.25
"""Time over which the motion is averaged, so that the trembling of a hand does not add up."""
STILL = 0.01
"""Motion by the longer side below which two frames show the same."""
BLURRED = 0.5
"""Sharpness by that of the neighbouring frames below which a chosen frame is remarked."""
CLEARLY = 1.25
"""Sharpness by that of a frame nearer the middle of a piece from which on the farther one is taken."""
JPEG_QUALITY = 95
ORIENTATION = {0: 1, 90: 6, 180: 3, 270: 8}


@dataclass(frozen=True, slots=True, kw_only=True)
class FrameOptions:
    """How many frames: one of the three."""

    count: int | None = None
    """This many, evenly by image motion."""
    every_s: float | None = None
    """One in so many seconds, frames that show the same as the one before left out."""
    motion: float = 0.08
    """One whenever the view has moved by this share of the longer side; where the others are not given."""


@dataclass(frozen=True, slots=True, kw_only=True)
class Analysis:
    """What was measured in each frame of a video."""

    width_px: int
    height_px: int
    rotation_deg: int
    """By how much a player turns the frames clockwise."""
    time_s: Array
    """(n,)"""
    sharpness: Array
    """(n,) share of the grey value variance that fine detail has; to be compared within a video only."""
    motion: Array
    """(n,) image motion since the first frame, by the longer side."""


@dataclass(frozen=True, slots=True, kw_only=True)
class Frames:
    """What was written."""

    files: tuple[Path, ...]
    frames: tuple[int, ...]
    """Their numbers in the video, from 0."""
    analysis: Analysis
    remarks: tuple[str, ...]


def extract_frames(
    video: Path, out: Path, options: FrameOptions | None = None, *, progress: Progress = silent
) -> Frames:
    """Write chosen frames of a video as JPEG files with EXIF, and frames.csv with what was measured.

    out     a new or empty folder; written whole or not at all
    raises  InputError where the file is no video that OpenCV can decode, or `out` holds something
    Limits: the camera constant.  Many cameras crop the sensor for video and stabilise
    electronically; then each frame has an interior orientation of its own.
    """
    options = options or FrameOptions()
    _check(options)
    check_free(out)
    metadata = read_movie_metadata(video)
    analysis = analyse(video, progress=progress)
    chosen, remarks = choose(analysis, options)
    names = [f"{video.stem}_{k:0{len(str(len(analysis.time_s)))}d}.jpg" for k in chosen]
    with new_folder(out) as folder:
        wanted = dict(zip(chosen, names, strict=True))
        for k, frame in _decoded(video):
            if k in wanted:
                _write(frame, folder / wanted[k], _exif(metadata, analysis, k, video.name))
                progress("writing frames", list(wanted).index(k) / len(wanted))
            if k >= chosen[-1]:
                break
        _write_table(folder / "frames.csv", names, chosen, analysis)
    progress("writing frames", 1.0)
    return Frames(files=tuple(out / n for n in names), frames=tuple(chosen), analysis=analysis, remarks=tuple(remarks))


def _check(options: FrameOptions) -> None:
    if options.count is not None and options.every_s is not None:
        raise InputError("video.count_and_time")
    if options.count is not None and options.count < 1:
        raise InputError("video.option_not_positive", option="count", value=options.count)
    if options.every_s is not None and not 0 < options.every_s < math.inf:
        raise InputError("video.option_not_positive", option="every_s", value=options.every_s)
    if not 0 < options.motion < math.inf:
        raise InputError("video.option_not_positive", option="motion", value=options.motion)


def _opened(video: Path) -> Any:
    import cv2

    check_regular(video)
    capture = cv2.VideoCapture(str(video), cv2.CAP_FFMPEG)
    capture.set(cv2.CAP_PROP_ORIENTATION_AUTO, 0)
    if not capture.isOpened():
        raise InputError("video.not_decoded", file=video)
    return capture


def _decoded(video: Path) -> Iterator[tuple[int, Array]]:
    """Number and pixels (blue, green, red; as stored) of each frame."""
    capture = _opened(video)
    try:
        k = 0
        while True:
            there, frame = capture.read()
            if not there:
                return
            yield k, frame
            k += 1
    finally:
        capture.release()


def analyse(video: Path, *, progress: Progress = silent) -> Analysis:
    """Sharpness and motion of every frame, measured at reduced size in one pass with bounded memory."""
    import cv2

    capture = _opened(video)
    rate = capture.get(cv2.CAP_PROP_FPS) or 25.0
    promised = max(1.0, capture.get(cv2.CAP_PROP_FRAME_COUNT))
    turn = round(capture.get(cv2.CAP_PROP_ORIENTATION_META)) % 360
    capture.release()
    sharpness: list[float] = []
    rates: list[Array] = []
    before: Array | None = None
    size = (0, 0)
    for k, frame in _decoded(video):
        size = frame.shape[1], frame.shape[0]
        scale = min(1.0, ANALYSED_PX / max(size))
        small = cv2.resize(frame, None, fx=scale, fy=scale, interpolation=cv2.INTER_AREA)
        grey = cv2.cvtColor(small, cv2.COLOR_BGR2GRAY)
        sharpness.append(_sharpness(grey))
        rates.append(np.zeros(4) if before is None else _motion(before, grey))
        before = grey
        if k % 20 == 0:
            progress("looking at the frames", min(1.0, k / promised))
    if not sharpness:
        raise InputError("video.no_frame", file=video)
    return Analysis(
        width_px=size[0],
        height_px=size[1],
        rotation_deg=turn if turn in ORIENTATION else 0,
        time_s=np.arange(len(sharpness)) / rate,
        sharpness=np.array(sharpness),
        motion=np.cumsum(np.linalg.norm(_smoothed(np.array(rates), max(1, round(SMOOTHED_S * rate))), axis=1)),
    )


def _sharpness(grey: Array) -> float:
    """Energy of the Laplacian by the variance, so that what is seen matters less than how sharply."""
    import cv2

    return float(cv2.Laplacian(grey, cv2.CV_32F).var() / (float(grey.var()) + 1.0))


def _motion(before: Array, after: Array) -> Array:
    """Shift (2,), change of scale and rotation of a frame, in shares of its longer side at its edge."""
    import cv2

    corners: Any = cv2.goodFeaturesToTrack(before, 300, 0.01, 8)
    if corners is None or len(corners) < 8:
        return np.zeros(4)
    moved, status, _ = cv2.calcOpticalFlowPyrLK(before, after, corners, None)  # pyright: ignore[reportCallIssue, reportArgumentType]
    found = status.ravel() == 1
    longer = max(before.shape)
    middle = np.array(before.shape[1::-1]) / 2
    a, b = corners[found, 0] - middle, moved[found, 0] - middle
    if len(a) < 8:
        return np.array([1.0, 0, 0, 0])  # nothing is found again: the view has changed altogether
    fitted: Any = cv2.estimateAffinePartial2D(a, b, method=cv2.RANSAC, ransacReprojThreshold=1.5)
    matrix: Array | None = fitted[0]
    if matrix is None:
        return np.zeros(4)
    cosine, sine = float(matrix[0, 0]), float(matrix[1, 0])
    shift = matrix[:, 2] / longer
    return np.array([*shift, (math.hypot(cosine, sine) - 1) / 2, math.atan2(sine, cosine) / 2])


def _smoothed(rates: Array, width: int) -> Array:
    """Moving mean over `width` rows."""
    kernel = np.ones(width) / width
    return np.stack([np.convolve(np.pad(r, width, mode="edge"), kernel, "same")[width:-width] for r in rates.T], axis=1)


def choose(analysis: Analysis, options: FrameOptions) -> tuple[list[int], list[str]]:
    """Numbers of the frames to take, in order, and remarks."""
    n, total = len(analysis.time_s), float(analysis.motion[-1])
    remarks: list[str] = []
    if total < STILL:
        remarks.append(phrase("video.no_motion"))
    if options.every_s is not None:
        place, width = analysis.time_s, options.every_s
    elif options.count is not None:
        count = min(options.count, n)
        # where nothing moves, time has to distinguish the pieces
        place = analysis.motion + 1e-6 * analysis.time_s
        width = float(place[-1]) / count if count else 1.0
    else:
        place, width = analysis.motion, options.motion
    pieces = max(1, math.ceil(float(place[-1]) / width - 1e-9)) if width > 0 else 1
    chosen = sorted({_sharpest(analysis.sharpness, place, width, piece) for piece in range(pieces)})
    if options.every_s is not None:
        kept = [k for j, k in enumerate(chosen) if not j or analysis.motion[k] - analysis.motion[chosen[j - 1]] > STILL]
        if len(kept) < len(chosen):
            remarks.append(phrase("video.same_frames", n=len(chosen) - len(kept)))
        chosen = kept
    typical = float(np.median(analysis.sharpness))
    blurred = [k for k in chosen if analysis.sharpness[k] < BLURRED * typical]
    if blurred:
        remarks.append(phrase("video.blurred", n=len(blurred), frames=blurred, share=BLURRED))
    if options.count is not None and len(chosen) < options.count:
        remarks.append(phrase("video.fewer_frames", n=len(chosen), wanted=options.count))
    return chosen, remarks


def _sharpest(sharpness: Array, place: Array, width: float, piece: int) -> int:
    """The sharpest frame in the middle of a piece, or in all of it where that is clearly sharper."""
    distance = np.abs(place - (piece + 0.5) * width)
    near: Index = np.flatnonzero(distance <= width / 3)
    all_: Index = np.flatnonzero(distance <= width / 2)
    if not len(all_):
        return int(distance.argmin())
    best = int(all_[np.argmax(sharpness[all_])])
    middle = int(near[np.argmax(sharpness[near])]) if len(near) else best
    return best if sharpness[best] > CLEARLY * sharpness[middle] else middle


def _exif(metadata: MovieMetadata, analysis: Analysis, k: int, video: str) -> bytes:
    """What the container states, with the time of the frame."""
    from PIL import Image

    tags = Image.Exif()
    texts = {0x010F: metadata.make, 0x0110: metadata.model}
    tags.update({tag: text for tag, text in texts.items() if text})
    tags[0x010E] = f"frame {k} of {video}, {analysis.time_s[k]:.3f} s from its start"
    tags[0x0112] = ORIENTATION[analysis.rotation_deg]
    tags[0x0131] = f"raybundle frames; video by {metadata.software}" if metadata.software else "raybundle frames"
    inner = tags.get_ifd(0x8769)
    inner[0xA002], inner[0xA003] = analysis.width_px, analysis.height_px
    if metadata.lens:
        inner[0xA434] = metadata.lens
    if metadata.focal35_mm is not None:
        inner[0xA405] = round(metadata.focal35_mm)
    if metadata.start is not None:
        taken = metadata.start + timedelta(seconds=float(analysis.time_s[k]))
        inner[0x9003] = taken.strftime("%Y:%m:%d %H:%M:%S")
        inner[0x9291] = f"{taken.microsecond // 1000:03d}"
        inner[0x9011] = "+00:00"
    if metadata.position is not None:
        tags.get_ifd(0x8825).update(_gps(metadata.position))
    return tags.tobytes()


def _gps(position: tuple[float, float, float | None]) -> dict[int, Any]:
    latitude, longitude, altitude = position
    gps: dict[int, Any] = {1: "N" if latitude >= 0 else "S", 2: _sexagesimal(latitude)}
    gps |= {3: "E" if longitude >= 0 else "W", 4: _sexagesimal(longitude)}
    if altitude is not None:
        gps |= {5: b"\1" if altitude < 0 else b"\0", 6: _rational(abs(altitude))}
    return gps


def _sexagesimal(degrees: float) -> tuple[Any, Any, Any]:
    minutes = abs(degrees) % 1 * 60
    return _rational(int(abs(degrees))), _rational(int(minutes)), _rational(minutes % 1 * 60)


def _rational(value: float) -> Any:
    from PIL.TiffImagePlugin import IFDRational

    fraction = Fraction(value).limit_denominator(10_000)
    return IFDRational(fraction.numerator, fraction.denominator)


def _write(frame: Array, path: Path, exif: bytes) -> None:
    from PIL import Image

    Image.fromarray(np.ascontiguousarray(frame[..., ::-1])).save(path, quality=JPEG_QUALITY, subsampling=0, exif=exif)


def _write_table(path: Path, names: list[str], chosen: list[int], analysis: Analysis) -> None:
    a, k = analysis, np.array(chosen, np.int64)
    write_table(
        path,
        {
            "file": names, "frame": k.astype(float), "time_s": np.asarray(a.time_s, float)[k],
            "sharpness": np.asarray(a.sharpness, float)[k], "motion": np.asarray(a.motion, float)[k],
        },
        {"frame": COUNT, "time_s": Places(3), "sharpness": Figures(4), "motion": Places(4)},
    )  # fmt: skip
