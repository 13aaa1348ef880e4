"""The camera library: calibrations kept in the user's folder, found again by what a photograph's EXIF states.

Each entry is a folder with two files: `camera.toml`, which orient takes as its calibration, and `entry.toml` with
the key (make, model, serial, lens, focal length, focus), the covariance and where the calibration comes from.
"""

from __future__ import annotations

import json
import math
import os
import re
from collections.abc import Sequence
from dataclasses import dataclass, field, replace
from pathlib import Path
from typing import Any

import numpy as np

from raybundle.block import Camera
from raybundle.block.stored import observed_jointly
from raybundle.block.zoom import ZoomCalibration
from raybundle.errors import InputError, phrase
from raybundle.io.block.toml import read_cameras
from raybundle.io.calibrations.ours import cameras_text
from raybundle.io.cameras.zoom_files import ZOOM, read_zoom, write_zoom
from raybundle.io.digits import exact, exacts
from raybundle.io.folders import new_folder
from raybundle.io.ids import repeated
from raybundle.io.photos.cameras import CameraGroup, with_calibration
from raybundle.io.photos.photo import Photo
from raybundle.io.reading.trees import Json, read_toml
from raybundle.io.reading.words import quoted
from raybundle.io.user_folders import user_folder
from raybundle.numerics.arrays import Array
from raybundle.sensors import sensor_models

VARIABLE = "RAYBUNDLE_CAMERAS"
POOR = ("weak", "not determinable")
"""Verdicts that are reported where such a calibration is used."""
SAME_FOCAL = 5e-4
"""Relative difference of EXIF focal lengths that is rounding."""


@dataclass(frozen=True, slots=True, kw_only=True)
class CameraKey:
    """What EXIF states of a camera; empty or None where it is not known."""

    make: str = ""
    model: str = ""
    serial: str = ""
    lens: str = ""
    focal_mm: float | None = None
    """As EXIF has it, not the camera constant."""
    focus_m: float | None = None
    """Object distance to which the lens was focused."""

    def __str__(self) -> str:
        """For people."""
        focal = "focal length not known" if self.focal_mm is None else f"{self.focal_mm:g} mm"
        serial = f"no. {self.serial}" if self.serial else ""
        focus = "" if self.focus_m is None else f"focused at {self.focus_m:g} m"
        body = self.model if self.model.lower().startswith(self.make.lower()) else f"{self.make} {self.model}"
        return ", ".join(t for t in (body.strip() or "unknown camera", serial, self.lens, focal, focus) if t)


@dataclass(frozen=True, slots=True, kw_only=True)
class LibraryEntry:
    """A calibration with what it belongs to and where it comes from."""

    name: str = ""
    """Name of its folder; given when it is added."""
    key: CameraKey
    camera: Camera
    free: tuple[str, ...] = ()
    """Symbols that were estimated."""
    covariance: Array | None = None
    """(u, u) of `free`."""
    date: str = ""
    """ISO 8601, of the calibration."""
    source: str = ""
    sigma0: float | None = None
    photographs: int | None = None
    grade: str = ""
    """The verdict: good, usable, weak; "" where there is none"""
    zoom: ZoomCalibration | None = None
    """Of a zoom lens: the calibration as a function of the EXIF focal length; the key names none then"""


@dataclass(frozen=True, slots=True, kw_only=True)
class Library:
    """The entries that could be read, and those that could not with the reason."""

    folder: Path
    entries: tuple[LibraryEntry, ...]
    refused: tuple[tuple[Path, str], ...] = ()


@dataclass(frozen=True, slots=True, kw_only=True)
class Match:
    """Whether an entry serves a photograph, and why."""

    entry: LibraryEntry
    fits: bool
    reasons: tuple[str, ...]
    """What speaks for it, or the first thing that forbids it."""
    camera: Camera | None = None
    """The calibration for the photograph's format, where it fits."""
    rank: tuple[float, ...] = field(default=(), repr=False)
    """Higher is better."""


def library_folder() -> Path:
    """Where the library is: RAYBUNDLE_CAMERAS, or the system's place for a user's data."""
    given = os.environ.get(VARIABLE, "")
    if given:
        return Path(given)
    return user_folder("data") / "cameras"


def key_of(photo: Photo) -> CameraKey:
    """The key of a photograph, from its EXIF."""
    m = photo.metadata
    return CameraKey(
        make=m.make.strip(),
        model=m.model.strip(),
        serial=m.serial.strip(),
        lens=m.lens.strip(),
        focal_mm=m.focal_mm,
        focus_m=m.subject_distance_m,
    )


def read_library(folder: Path | None = None) -> Library:
    """All entries, in the order of their names; a damaged one costs that one."""
    folder = folder or library_folder()
    entries: list[LibraryEntry] = []
    refused: list[tuple[Path, str]] = []
    try:
        places = sorted(p for p in folder.iterdir() if p.is_dir() and not p.name.startswith("."))
    except FileNotFoundError:
        places = []
    except OSError as error:
        raise InputError("folder.not_listed", detail=error.strerror, file=folder) from None
    for place in places:
        try:
            entries.append(read_entry(place))
        except InputError as error:
            refused.append((place, error.text()))
    return Library(folder=folder, entries=tuple(entries), refused=tuple(refused))


def read_entry(place: Path) -> LibraryEntry:
    """One entry; raises InputError with file and place."""
    cameras = read_cameras(place / "camera.toml")
    if len(cameras) != 1:
        raise InputError("calibration.camera_count", n=len(cameras), file=place / "camera.toml")
    path = place / "entry.toml"
    top = read_toml(path).tree()
    key = top.get("key")
    free, covariance = _covariance(top, cameras[0])
    return LibraryEntry(
        name=place.name,
        key=CameraKey(
            make=_text(key, "make"),
            model=_text(key, "model"),
            serial=_text(key, "serial"),
            lens=_text(key, "lens"),
            focal_mm=_number(key, "focal_mm"),
            focus_m=_number(key, "focus_m"),
        ),
        camera=cameras[0],
        free=free,
        covariance=covariance,
        date=_text(top, "date"),
        source=_text(top, "source"),
        sigma0=_number(top, "sigma0"),
        photographs=top.get("photographs").whole(0) if top.has("photographs") else None,
        grade=_text(top, "grade"),
        zoom=read_zoom(place) if (place / ZOOM).is_file() else None,
    )


def _text(table: Json, name: str) -> str:
    return table.get(name).text() if table.has(name) else ""


def _number(table: Json, name: str) -> float | None:
    return table.get(name).number() if table.has(name) else None


def _covariance(top: Json, camera: Camera) -> tuple[tuple[str, ...], Array | None]:
    if not top.has("covariance"):
        return (), None
    table = top.get("covariance")
    free = tuple(i.text() for i in table.get("free").items())
    unknown = [s for s in free if s not in sensor_models[camera.model].symbols]
    if unknown:
        known = sensor_models[camera.model].symbols
        table.get("free").fail("parameter.unknown", name=quoted(unknown[0]), model=camera.model, known=known)
    if len(set(free)) != len(free):
        table.get("free").fail("parameter.twice", name=repeated(free))
    rows = table.get("rows").items()
    if len(rows) != len(free):
        table.get("rows").fail("value.count", n=len(rows), needed=len(free))
    C = np.array([r.numbers(len(free)) for r in rows]).reshape(len(free), len(free))
    d = np.sqrt(np.abs(np.diag(C)))
    if not (np.diag(C) > 0).all() or not np.allclose(C, C.T, rtol=1e-6, atol=1e-12 * float((d**2).min(initial=1.0))):
        table.get("rows").fail("calibration.no_covariance")
    if np.linalg.eigvalsh(C / np.outer(d, d)).min() < -1e-6:
        table.get("rows").fail("calibration.no_covariance")
    return free, C


def _quoted(text: str) -> str:
    return json.dumps(text, ensure_ascii=False).replace("\x7f", "\\u007f")


def _entry_text(entry: LibraryEntry) -> str:
    lines = [f"date = {_quoted(entry.date)}", f"source = {_quoted(entry.source)}"]
    lines += [f"sigma0 = {exact(entry.sigma0)}"] if entry.sigma0 is not None else []
    lines += [f"photographs = {int(entry.photographs)}"] if entry.photographs is not None else []
    lines += [f"grade = {_quoted(entry.grade)}"] if entry.grade else []
    k = entry.key
    lines += ["", "[key]"]
    lines += [
        f"{n} = {_quoted(v)}"
        for n, v in zip(("make", "model", "serial", "lens"), (k.make, k.model, k.serial, k.lens), strict=True)
    ]
    lines += [f"{n} = {exact(v)}" for n, v in (("focal_mm", k.focal_mm), ("focus_m", k.focus_m)) if v is not None]
    if entry.covariance is not None:
        lines += ["", "[covariance]", f"free = [{', '.join(_quoted(s) for s in entry.free)}]", "rows = ["]
        lines += [f"  {exacts(row)}," for row in np.asarray(entry.covariance).tolist()]
        lines.append("]")
    return "\n".join(lines) + "\n"


def add_entry(entry: LibraryEntry, folder: Path | None = None) -> Path:
    """Put an entry into the library under a new name, whole or not at all; the folder it stands in.

    raises  InputError where its key names no camera model or no focal length: it could never be found again
    """
    folder = folder or library_folder()
    if entry.grade == "not determinable":
        raise InputError("library.not_determinable")
    k = entry.key
    focal = k.focal_mm is not None and math.isfinite(k.focal_mm) and k.focal_mm > 0
    if not k.model or not (focal or entry.zoom is not None):
        raise InputError("library.no_key")
    words = (
        k.make,
        k.model,
        k.serial,
        k.lens,
        f"{k.focal_mm:g}mm" if entry.zoom is None else "{:g}-{:g}mm".format(*entry.zoom.range_mm),
        f"{entry.camera.width_px}x{entry.camera.height_px}",
    )
    base = re.sub(r"[^a-z0-9.]+", "-", " ".join(w for w in words if w).lower()).strip("-.")[:120] or "camera"
    name, number = base, 2
    while (folder / name).exists():
        name, number = f"{base}-{number}", number + 1
    camera = replace(entry.camera, estimate=(), sigma={}, relations=(), calibrated=None, interior="shared")
    with new_folder(folder / name) as temporary:
        (temporary / "camera.toml").write_text(cameras_text([camera]), encoding="utf-8", newline="\n")
        if entry.zoom is not None:
            write_zoom(entry.zoom, temporary)
        (temporary / "entry.toml").write_text(_entry_text(entry), encoding="utf-8", newline="\n")
        read_entry(temporary)  # what cannot be read back is not kept
    return folder / name


def match(entry: LibraryEntry, photo: Photo) -> Match:
    """Whether an entry serves a photograph: same camera, lens, EXIF focal length and format, or a whole copy of it.

    Limits: whether zoom or focus were moved under the same entry, and whether a copy of the same
    shape was cropped rather than reduced.
    """
    against = _against(entry, photo)
    if against:
        return Match(entry=entry, fits=False, reasons=(against,))
    mine, own = entry.key, key_of(photo)
    base, remarks = (entry.camera, ()) if entry.zoom is None else _zoomed(entry.zoom, own)
    low, high = (0.0, 0.0) if entry.zoom is None else entry.zoom.range_mm
    reasons = [
        f"{mine.make} {mine.model}".strip(),
        phrase(
            "library_match.focal_length",
            focal_mm=own.focal_mm or 0,
            zoom=entry.zoom is not None,
            low_mm=low,
            high_mm=high,
        ),
        *remarks,
    ]
    same = [_same(mine.serial, own.serial), _same(mine.lens, own.lens)]
    for quantity, value, equal in (("serial", mine.serial, same[0]), ("lens", mine.lens, same[1])):
        reasons.append(phrase("library_match.same", quantity=quantity, equal=equal, value=value))
    camera = _for_format(base, photo)
    assert camera is not None
    if entry.zoom is None and entry.covariance is not None:
        camera = observed_jointly(camera, entry.free, entry.covariance)
    whole = (camera.width_px, camera.height_px) == (entry.camera.width_px, entry.camera.height_px)
    reasons.append(
        phrase(
            "library_match.format", whole=whole, width_px=entry.camera.width_px, height_px=entry.camera.height_px,
            own_width_px=photo.width_px, own_height_px=photo.height_px,
        )
    )  # fmt: skip
    apart = 0.0
    if mine.focus_m and own.focus_m and entry.zoom is None:
        c = entry.camera.values.get("c", own.focal_mm or 0.0)
        apart = abs(c * c / 1000 * (1 / mine.focus_m - 1 / own.focus_m)) / entry.camera.pixel_mm[0]
        if apart > 0:
            reasons.append(
                phrase("library_match.focus", focus_m=mine.focus_m, own_focus_m=own.focus_m, difference_px=apart)
            )
    rank = (float(same[0]), float(same[1]), float(whole), -apart)
    return Match(entry=entry, fits=True, reasons=tuple(reasons), camera=camera, rank=rank)


def _same(a: str, b: str) -> bool:
    return bool(a and b) and " ".join(a.lower().split()) == " ".join(b.lower().split())


def _against(entry: LibraryEntry, photo: Photo) -> str:
    """What forbids an entry for a photograph; "" for nothing."""
    mine, own = entry.key, key_of(photo)
    if not own.model:
        return phrase("library_match.no_model")
    for name, a, b in (
        ("make", mine.make, own.make), ("model", mine.model, own.model), ("serial", mine.serial, own.serial),
        ("lens", mine.lens, own.lens),
    ):  # fmt: skip
        if (a or b) and not _same(a, b) and (name == "model" or (a and b)):
            return phrase("library_match.other", quantity=name, value=a or "?", own=b or "?")
    if entry.zoom is not None:
        against = _beyond(entry.zoom, own.focal_mm)
        if against:
            return against
    elif mine.focal_mm is None or own.focal_mm is None:
        return phrase("library_match.focal_length_unknown", zoom=False)
    elif abs(mine.focal_mm - own.focal_mm) > SAME_FOCAL * mine.focal_mm:
        return phrase("library_match.other_focal_length", focal_mm=mine.focal_mm, own_focal_mm=own.focal_mm)
    zoom = photo.metadata.zoom_ratio
    if zoom is not None and zoom > 1:
        return phrase("library_match.digital_zoom", zoom=zoom)
    if _for_format(entry.camera, photo) is None:
        c = entry.camera
        turned = (photo.width_px, photo.height_px) == (c.height_px, c.width_px)
        return phrase(
            "library_match.other_format", width_px=c.width_px, height_px=c.height_px, own_width_px=photo.width_px,
            own_height_px=photo.height_px, turned=turned,
        )  # fmt: skip
    return ""


def _beyond(zoom: ZoomCalibration, focal_mm: float | None) -> str:
    """Why a zoom calibration does not hold for a focal length; "" where it does."""
    if focal_mm is None:
        return phrase("library_match.focal_length_unknown", zoom=True)
    low, high = zoom.range_mm
    slack = zoom.resolution_mm / 2
    if not low - slack <= focal_mm <= high + slack:
        return phrase("library_match.beyond_zoom", low_mm=low, high_mm=high, own_focal_mm=focal_mm)
    return ""


def _zoomed(zoom: ZoomCalibration, own: CameraKey) -> tuple[Camera, tuple[str, ...]]:
    """The camera at the photograph's focal length, observed with the covariance that the zoom calibration has there."""
    at = zoom.predict(own.focal_mm or 0.0, own.focus_m)
    camera = observed_jointly(at.camera, at.free, at.covariance)
    if zoom.resolution_mm > 0 and "c" in at.free:
        sigma = float(np.sqrt(at.covariance[at.free.index("c"), at.free.index("c")]))
        rounded = phrase("library_match.focal_length_rounded", step_mm=zoom.resolution_mm, sigma_mm=sigma)
        return camera, (*at.remarks, rounded)
    return camera, at.remarks


def _for_format(camera: Camera, photo: Photo) -> Camera | None:
    """The calibration for the whole format in other pixels; None where the shape differs by more than rounding."""
    width, height = photo.width_px, photo.height_px
    if (width, height) == (camera.width_px, camera.height_px):
        return camera
    by_x, by_y = camera.width_px / width, camera.height_px / height
    if abs(by_x - by_y) > max(by_x, by_y) * 1.01 / min(width, height):
        return None
    pixel = (camera.pixel_mm[0] * by_x, camera.pixel_mm[1] * by_y)
    return replace(camera, width_px=width, height_px=height, pixel_mm=pixel)


def find_calibrations(photo: Photo, folder: Path | None = None) -> tuple[Match, ...]:
    """Every entry with the reason why it serves the photograph or not; those that serve first, the best at the top."""
    matches = [match(e, photo) for e in read_library(folder).entries]
    order = sorted(matches, key=lambda m: m.entry.date, reverse=True)
    return tuple(sorted(order, key=lambda m: (m.fits, m.rank), reverse=True))


def with_library(
    photos: Sequence[Photo], groups: Sequence[CameraGroup], folder: Path | None = None
) -> tuple[CameraGroup, ...]:
    """The cameras of some photographs, those without a stored calibration with the best one that the library has.

    What is taken is stated in the remarks; the reasons are given by `find_calibrations`.
    """
    result: list[CameraGroup] = []
    for group in groups:
        best = (
            None if group.stored is not None else next(iter(find_calibrations(photos[group.photos[0]], folder)), None)
        )
        if best is None or best.camera is None:
            result.append(group)
            continue
        taken = with_calibration(group, best.camera)
        line = phrase(
            "camera_library.taken", name=best.entry.name, dated=bool(best.entry.date), date=best.entry.date,
            observed=best.camera.calibrated is not None, poor=best.entry.grade in POOR,
            grade=best.entry.grade.replace(" ", "_"),
        )  # fmt: skip
        result.append(replace(taken, remarks=(*group.remarks, *taken.remarks, line)))
    return tuple(result)


def as_table(entry: LibraryEntry) -> dict[str, Any]:
    """An entry for JSON."""
    k, c = entry.key, entry.camera
    return {
        "name": entry.name, "make": k.make, "model": k.model, "serial": k.serial, "lens": k.lens,
        "focal_mm": k.focal_mm, "focus_m": k.focus_m, "width_px": c.width_px, "height_px": c.height_px,
        "sensor_model": c.model, "values": dict(c.values), "free": list(entry.free), "date": entry.date,
        "source": entry.source, "sigma0": entry.sigma0, "photographs": entry.photographs, "grade": entry.grade,
    }  # fmt: skip
