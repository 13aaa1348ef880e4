"""Photographs that were flown: where, when and how they were taken, and how sharp they are."""

from __future__ import annotations

import io
import os
from collections.abc import Sequence
from concurrent.futures import ThreadPoolExecutor

import numpy as np
from PIL import Image

from raybundle.errors import InputError, Text, phrase, warning
from raybundle.io.geo.coordinate_systems import local_frame
from raybundle.io.missions.areas import GEOGRAPHIC, in_crs
from raybundle.io.photos.photo import Photo, read_grey
from raybundle.io.reading.words import number_of
from raybundle.missions.check import Flown
from raybundle.missions.mission import Mission
from raybundle.missions.sharpness import Blur, Sharpness, blur_of, sharpness, tiles
from raybundle.numerics.arrays import Array
from raybundle.numerics.progress import Progress, silent

MARKER, BASELINE = 0xFF, (0xC0, 0xC1)
"""Of JPEG: what a marker begins with, and frames whose rows are complete in their order."""
ROWS = 1024
"""That are looked at in the least."""
SAMPLES = 5
"""Photographs by which the scale of blur is made."""


def flown_of(
    photos: Sequence[Photo], mission: Mission, *, sharp: bool = True, progress: Progress = silent
) -> tuple[Flown, tuple[str, ...]]:
    """What photographs say of themselves, in the coordinate system of a plan, in the order of their time; and remarks.

    sharp   whether their pixels are read
    Heights are those that the vehicle counts from its take-off, where it writes them; else those of the positions.
    """
    order = sorted(range(len(photos)), key=lambda k: (_time(photos[k], photos[0]), k))
    photos = [photos[k] for k in order]
    remarks: list[str] = []
    blur = _blur(photos, remarks, progress) if sharp else _unknown(len(photos))
    xyz, known = _positions(photos, mission, remarks)
    angles = _attitudes(photos, mission, xyz)
    seconds = np.array([_time(p, photos[0]) for p in photos])
    return Flown(
        names=tuple(p.name for p in photos), xyz=xyz, heading=angles[:, 0], pitch=angles[:, 1], roll=angles[:, 2],
        seconds=seconds, exposure_s=np.array([p.metadata.exposure_s or np.nan for p in photos]), blur_px=blur.px,
        blurred=blur.other, height_known=known,
    ), tuple(remarks)  # fmt: skip


def _time(photo: Photo, first: Photo) -> float:
    """Seconds from one photograph to another by their clocks; NaN where one has none."""
    mine, own = photo.metadata.taken, first.metadata.taken
    if mine is None or own is None:
        return np.nan
    return (mine.replace(tzinfo=None) - own.replace(tzinfo=None)).total_seconds()


def _positions(photos: Sequence[Photo], mission: Mission, remarks: list[str]) -> tuple[Array, bool]:
    """(n, 3) and whether heights count from the take-off."""
    n = len(photos)
    xyz = np.full((n, 3), np.nan)
    gps = [p.metadata.gps for p in photos]
    rows = [k for k, g in enumerate(gps) if g is not None]
    if len(rows) < n:
        bare = next(p.name for p, g in zip(photos, gps, strict=True) if g is None)
        remarks.append(Text.of(warning("flight_check.some_unplaced", n=n - len(rows), of=n, example=bare)))
    if not rows:
        return xyz, False
    lonlat = np.array([[g.longitude_deg, g.latitude_deg] for g in gps if g is not None])
    xyz[rows, :2] = in_crs(lonlat, GEOGRAPHIC, mission.crs)
    above = [number_of(p.metadata.xmp.get("drone-dji:RelativeAltitude", "").lstrip("+")) for p in photos]
    if all(a is not None for a in above):
        xyz[:, 2] = mission.take_off[2] + np.array(above, float)
        return xyz, True
    xyz[rows, 2] = [np.nan if g.altitude_m is None else g.altitude_m for g in gps if g is not None]
    return xyz, False


def _attitudes(photos: Sequence[Photo], mission: Mission, xyz: Array) -> Array:
    """(n, 3) heading from grid north, pitch, roll [rad]; NaN where not recorded or without a position."""
    angles = np.full((len(photos), 3), np.nan)
    rows = [k for k, p in enumerate(photos) if p.metadata.gimbal is not None and np.isfinite(xyz[k, :2]).all()]
    if not rows:
        return angles
    frame = local_frame(mission.crs, np.array(mission.take_off))
    plan = np.column_stack([xyz[rows, :2], np.full(len(rows), mission.take_off[2])])
    turn = frame.scale_and_convergence(plan)[:, 1]
    recorded = np.radians(np.array([photos[k].metadata.gimbal for k in rows], float))
    angles[rows] = recorded
    angles[rows, 0] = (recorded[:, 0] - turn) % (2 * np.pi)
    return angles


def _unknown(n: int) -> Blur:
    return Blur(px=np.full(n, np.nan), other=np.zeros(n, bool))


def _blur(photos: Sequence[Photo], remarks: list[str], progress: Progress) -> Blur:
    """Blur of all photographs; each is decoded once, several at a time."""
    found: list[Sharpness] = []
    chosen: list[Array | None] = []
    with ThreadPoolExecutor(max_workers=os.cpu_count() or 1) as pool:
        for k, squares in enumerate(pool.map(_squares, photos)):
            chosen.append(squares)
            found.append(Sharpness(ratio=np.full(2, np.nan)) if squares is None else sharpness(squares))
            progress(phrase("flight_check.sharpness"), (k + 1) / len(photos))
    damaged = [p.name for p, c in zip(photos, chosen, strict=True) if c is None]
    if damaged:
        remarks.append(Text.of(warning("flight_check.not_decoded", n=len(damaged), example=damaged[0])))
    ratio = np.array([f.ratio for f in found])
    known = np.flatnonzero(np.isfinite(ratio).all(axis=1))
    if not len(known):
        return _unknown(len(photos))
    away = np.abs(np.log(ratio[known] / np.median(ratio[known], axis=0))).sum(axis=1)
    usual = known[np.argsort(away)[:SAMPLES]].tolist()
    return blur_of(found, [c for k in usual if (c := chosen[k]) is not None])


def _squares(photo: Photo) -> Array | None:
    """Squares of the upper part where that shows something, else of the whole; None where nothing can be decoded."""
    try:
        upper = upper_part(photo)
        if upper is not None:
            squares = tiles(upper)
            if np.isfinite(sharpness(squares).ratio).all():
                return squares
        return tiles(read_grey(photo))
    except InputError:
        return None


def upper_part(photo: Photo) -> Array | None:
    """Grey values (rows, w) of the upper quarter of a baseline JPEG; None for other files, and damaged ones.

    A JPEG is decoded from its first row on, and its header states how many rows there are: with fewer the decoder is
    done in a fifth of the time.  Blur of a motion or of the focus is in all of a photograph.
    """
    if photo.kind != "jpeg":
        return None
    try:
        with Image.open(io.BytesIO(_with_rows(photo.path.read_bytes(), photo.height_px))) as image:
            image.draft("L", image.size)
            return np.asarray(image.convert("L"))
    except (OSError, ValueError, SyntaxError):
        return None


def _with_rows(data: bytes, height: int) -> bytes:
    """A baseline JPEG whose header has a quarter of the rows; raises ValueError for another (ITU-T T.81, B.2.2)."""
    rows = min(height, max(height // 4, ROWS))
    at = 2
    while at + 9 < len(data) and data[at] == MARKER:
        if data[at + 1] in BASELINE:
            return data[: at + 5] + rows.to_bytes(2, "big") + data[at + 7 :]
        at += 2 + int.from_bytes(data[at + 2 : at + 4], "big")
    raise ValueError
