"""Cameras of a set of photographs: which photographs share an interior orientation, and where it starts."""

from __future__ import annotations

import re
from collections.abc import Sequence
from dataclasses import dataclass, replace
from fnmatch import fnmatchcase
from math import sqrt

from raybundle.block import Camera
from raybundle.block.known import observed_as_known
from raybundle.block.stored import joint_covariance
from raybundle.errors import InputError, Text, code_of, message_of_text, note, phrase
from raybundle.io.photos.metadata import Metadata
from raybundle.io.photos.photo import Photo
from raybundle.io.photos.start import (
    BY_FACTOR,
    DEFAULT_SOURCE,
    NOMINAL,
    XMP_SOURCE,
    Start,
    centre_sigma,
    starting_value,
    stated_projection,
)
from raybundle.sensors import sensor_models

SEVERAL_LENSES = ("dual camera", "dual wide camera", "triple camera")
"""Words in EXIF LensModel of phones with several lenses of fixed focal length, as "back dual camera 6mm": the range of
focal lengths that they state is from one lens to the other, and none zooms."""


@dataclass(frozen=True, slots=True, kw_only=True)
class CameraGroup:
    """Photographs that share one interior orientation: one camera, one lens, one zoom setting, one format."""

    id: str
    name: str
    """The camera in words, for people."""
    photos: tuple[int, ...]
    """Positions among the photographs."""
    width_px: int
    height_px: int
    pixel_mm: tuple[float, float]
    c_mm: float
    """Camera constant to start with."""
    sigma_c_mm: float
    """Its standard deviation; 0 where a stored calibration holds it."""
    source: str
    """Where the camera constant comes from, in words."""
    sigma_centre: float = 0.0
    """Standard deviation of the principal point about the middle, by the longer side of the format"""
    remarks: tuple[str, ...] = ()
    projection: str = ""
    """What its photographs state of a projection that is not central, in words; empty beside a calibration"""
    stored: Camera | None = None
    """The calibration that was given for this camera."""
    joined: tuple[str, ...] = ()
    """What photographs of it state differently and why they are of one camera all the same, in words."""
    pattern: str = ""
    """That set its photographs apart."""

    @property
    def stated(self) -> tuple[str, ...]:
        """All that there is to say of it."""
        return (self.projection, *self.remarks) if self.projection else self.remarks

    @property
    def c_px(self) -> float:
        """The camera constant in pixel widths."""
        return self.c_mm / self.pixel_mm[0]

    @property
    def sigma_c_px(self) -> float:
        """Its standard deviation in pixel widths."""
        return self.sigma_c_mm / self.pixel_mm[0]


def camera_groups(
    photos: Sequence[Photo], stored: Sequence[Camera] = (), separate: Sequence[str] = ()
) -> tuple[CameraGroup, ...]:
    """The cameras of some photographs, in the order of their first photograph.

    stored    calibrations to be used, as `read_cameras` reads them; each must fit a camera by its id or, where
            only one camera has its format, by that
    separate  patterns of names, as "left_*" or "a.jpg|b.jpg": photographs that match one are a camera apart,
            whatever they state
    raises    InputError where a stored calibration fits none, or more than one could be meant, or a pattern matches
              no photograph or one that another matches too
    Photographs belong together by make, model, serial number, lens, focal length, digital zoom and format as
    stored; turning the camera changes nothing.  Photographs without metadata belong together by their format.
    A lens or serial number that some photographs of a camera do not state is that which all others state, where these
    state one.  Files stored turned or at another size are distinguished here: `may_share_sensor` states which may be of
    one sensor, and the adjustment decides.
    Limits: whether a zoom or the focus was moved between photographs with the same entry.
    """
    members: dict[_Key, list[int]] = {}
    for k, photo in enumerate(photos):
        members.setdefault(_key(photo, _pattern_of(photo.name, separate)), []).append(k)
    for pattern in separate:
        if all(key.pattern != pattern for key in members):
            raise InputError("camera.pattern_without_photograph", pattern=pattern, names=[p.name for p in photos[:3]])
    joined = _with_unstated(members, photos)
    names = _ids([photos[m[0]] for m, _ in joined.values()])
    groups = [
        replace(_group(id_, photos, m), joined=lines, pattern=key.pattern)
        for id_, (key, (m, lines)) in zip(names, joined.items(), strict=True)
    ]
    return tuple(_with_remarks(g, groups, photos) for g in _with_stored(groups, stored))


def may_share_sensor(one: Photo, two: Photo) -> bool:
    """Whether two photographs state nothing that speaks against one body, lens and zoom setting; the format apart.

    What neither states speaks for nothing: where no photograph shows its camera, only what is measured does.
    """
    a, b = _key(one, ""), _key(two, "")
    known = all(x == y for x, y in zip(a.sure, b.sure, strict=True))
    return known and all(not x or not y or x == y for x, y in zip(a.unsure, b.unsure, strict=True))


def camera_of(group: CameraGroup) -> Camera:
    """The camera of a group, with starting values; what is estimated is for the caller to say.

    A stored calibration is taken as it is; otherwise model "brown" with everything but c zero.
    """
    if group.stored is not None:
        s = group.stored
        return Camera(
            id=group.id, model=s.model, width_px=s.width_px, height_px=s.height_px, pixel_mm=s.pixel_mm,
            values=s.values, estimate=s.estimate, sigma=s.sigma, interior=s.interior, relations=s.relations,
            calibrated=s.calibrated,
        )  # fmt: skip
    values = {p.symbol: 0.0 for p in sensor_models["brown"].parameters}
    values["c"] = group.c_mm
    return Camera(
        id=group.id,
        model="brown",
        width_px=group.width_px,
        height_px=group.height_px,
        pixel_mm=group.pixel_mm,
        values=values,
        known=values,
    )


def with_what_is_known(camera: Camera, group: CameraGroup) -> Camera:
    """The camera of a group without a calibration, observed as it is known before its photographs measure anything."""
    side = group.pixel_mm[0] * max(group.width_px, group.height_px)
    centre = group.sigma_centre * side
    stated = group.sigma_c_mm / group.c_mm
    by_factor = {DEFAULT_SOURCE: BY_FACTOR, XMP_SOURCE: stated}.get(code_of(group.source), max(stated, NOMINAL))
    return observed_as_known(camera, {"c": by_factor, "x0": centre, "y0": centre})


def _pattern_of(name: str, patterns: Sequence[str]) -> str:
    """The pattern that a photograph's name matches, by one of its parts between |; "" for none."""
    found = [p for p in patterns if fnmatchcase(name, p) or any(fnmatchcase(name, part) for part in p.split("|"))]
    if len(found) > 1:
        raise InputError("camera.two_patterns", photograph=name, first=found[0], second=found[1])
    return found[0] if found else ""


@dataclass(frozen=True, slots=True)
class _Key:
    """By what photographs belong to one camera."""

    pattern: str
    sure: tuple[str, str, float | None, float]
    """Make, model, focal length, digital zoom: each states something where it is stated, and where it is not."""
    unsure: tuple[str, str]
    """Serial number and lens, which programs and exchanged lenses' contacts leave out of single files."""
    size: tuple[int, int]


def _key(photo: Photo, pattern: str) -> _Key:
    m = photo.metadata
    zoom = m.zoom_ratio if m.zoom_ratio is not None and m.zoom_ratio > 1 else 1.0
    focal = m.focal_mm if m.focal_mm is not None else m.focal35_mm
    setting = None if focal is None else round(focal, 3)
    sure = m.make, m.model, setting, round(zoom, 3)
    return _Key(pattern, sure, (m.serial, m.lens), (photo.width_px, photo.height_px))


def _with_unstated(
    members: dict[_Key, list[int]], photos: Sequence[Photo]
) -> dict[_Key, tuple[list[int], tuple[str, ...]]]:
    """Photographs that leave serial number or lens out, with those that state them, where these state one.

    A camera is known by make, model and focal length; a second body or lens would state another number or name in
    some photograph.
    """
    found = {key: (list(m), list[str]()) for key, m in members.items()}
    for key in sorted(members, key=lambda k: sum(map(bool, k.unsure))):
        if all(key.unsure) or not key.sure[1] or key.sure[2] is None:
            continue
        fuller = [
            k
            for k in found
            if k != key
            and (k.pattern, k.sure, k.size) == (key.pattern, key.sure, key.size)
            and all(not mine or mine == theirs for mine, theirs in zip(key.unsure, k.unsure, strict=True))
        ]
        if len(fuller) != 1:
            continue
        mine, lines = found.pop(key)
        serial, lens = (
            theirs if theirs and not ours else "" for ours, theirs in zip(key.unsure, fuller[0].unsure, strict=True)
        )
        rows, words = found[fuller[0]]
        few, many = (mine, rows) if len(mine) <= len(rows) else (rows, mine)
        words += [
            *lines,
            phrase(
                "camera_start.one_camera", first=photos[few[0]].name, n=len(few), stated=few is not mine,
                has_serial=bool(serial), serial=serial, has_lens=bool(lens), lens=lens, others=len(many),
            ),
        ]  # fmt: skip
        found[fuller[0]] = sorted([*rows, *mine]), words
    first = sorted(found, key=lambda k: found[k][0][0])
    return {k: (found[k][0], tuple(found[k][1])) for k in first}


def _group(id_: str, photos: Sequence[Photo], members: Sequence[int]) -> CameraGroup:
    photo = photos[members[0]]
    start: Start = starting_value(photo.metadata, photo.width_px, photo.height_px)
    return CameraGroup(
        id=id_,
        name=_name(photo.metadata),
        photos=tuple(members),
        width_px=photo.width_px,
        height_px=photo.height_px,
        pixel_mm=(start.pixel_mm, start.pixel_mm),
        c_mm=start.c_mm,
        sigma_c_mm=start.c_mm * start.sigma,
        source=start.source,
        sigma_centre=max(centre_sigma(photos[k].metadata, photo.width_px, photo.height_px) for k in members),
        remarks=start.remarks,
        projection=stated_projection(photo.metadata),
    )


def _name(metadata: Metadata) -> str:
    make, model = metadata.make.strip(), metadata.model.strip()
    body = model if make and model.lower().startswith(make.split()[0].lower()) else f"{make} {model}".strip()
    focal = "" if metadata.focal_mm is None else f"{metadata.focal_mm:g} mm"
    return ", ".join(t for t in (body or "unknown camera", metadata.lens, focal) if t)


def _ids(photos: Sequence[Photo]) -> list[str]:
    """Short readable ids: model and focal length, then what distinguishes equal ones."""
    ids: list[str] = []
    for photo in photos:
        m = photo.metadata
        focal = "" if m.focal_mm is None else f"{m.focal_mm:g}mm"
        plain = [_slug(m.model) or "camera", focal] if m.model or m.focal_mm else []
        size = f"{photo.width_px}x{photo.height_px}"
        steps = [plain, [*plain, size], [*plain, size, _slug(m.serial)], [*plain, size, _slug(m.serial), _slug(m.lens)]]
        names = ["-".join(p for p in step if p) for step in steps]
        new = next((n for n in names if n and n not in ids), "")
        number = 2
        while not new or new in ids:
            new, number = f"{names[-1]}-{number}", number + 1
        ids.append(new)
    return ids


def _slug(text: str) -> str:
    return re.sub(r"[^a-z0-9]+", "-", text.lower()).strip("-")[:40]


def _with_stored(groups: Sequence[CameraGroup], stored: Sequence[Camera]) -> list[CameraGroup]:
    """Give each stored calibration to the camera that it fits."""
    result = {g.id: g for g in groups}
    for camera in stored:
        fitting = [g for g in groups if (g.width_px, g.height_px) == (camera.width_px, camera.height_px)]
        named = [g for g in fitting if g.id == camera.id]
        known = [f"{g.id} ({g.width_px} x {g.height_px} px)" for g in groups]
        if not fitting:
            raise InputError(
                "calibration.format_differs", camera=camera.id, width_px=camera.width_px, height_px=camera.height_px,
                known=known,
            )  # fmt: skip
        if not named and len(fitting) > 1:
            raise InputError("calibration.several_cameras", camera=camera.id, n=len(fitting), known=known)
        group = (named or fitting)[0]
        if result[group.id].stored is not None:
            raise InputError("calibration.two_for_camera", camera=group.id, known=known)
        result[group.id] = with_calibration(group, camera)
    return list(result.values())


def _calibrated_sigma(camera: Camera, symbol: str) -> float:
    """Standard deviation of a parameter by its calibration; 0 where that holds it."""
    if not camera.estimate:
        return 0.0
    symbols, covariance = joint_covariance(camera)
    if covariance is None or symbol not in symbols:
        return camera.sigma.get(symbol, 0.0)
    k = symbols.index(symbol)
    return sqrt(float(covariance[k, k]))


def with_calibration(group: CameraGroup, camera: Camera) -> CameraGroup:
    """The group with a stored calibration in place of its starting values."""
    c = next(p.symbol for p in sensor_models[camera.model].parameters if p.kind == "scale")
    c_px, own = camera.values[c] / camera.pixel_mm[0], group.c_px
    remarks: tuple[str, ...] = ()
    if code_of(group.source) != DEFAULT_SOURCE and abs(c_px / own - 1) > 0.1:
        remarks = (
            Text.of(
                note("camera_start.calibration_differs", c_px=round(c_px), own_px=round(own)),
                message_of_text(group.source),
            ),
        )
    return replace(
        group, pixel_mm=camera.pixel_mm, c_mm=camera.values[c], sigma_c_mm=_calibrated_sigma(camera, c),
        source=phrase("camera_start.stored", camera=camera.id), remarks=remarks, projection="", stored=camera,
    )  # fmt: skip


def _with_remarks(group: CameraGroup, groups: Sequence[CameraGroup], photos: Sequence[Photo]) -> CameraGroup:
    """Add what only the whole set shows."""
    m = photos[group.photos[0]].metadata
    remarks = list(group.remarks)
    unknown = {i for i in group.photos if not photos[i].metadata.model}
    if unknown and len(groups) > 1 and any(photos[g.photos[0]].metadata.model for g in groups):
        remarks.append(phrase("camera_start.no_metadata"))
    several_lenses = any(word in m.lens.lower() for word in SEVERAL_LENSES)
    zooms = m.focal_range_mm is not None and m.focal_range_mm[1] > m.focal_range_mm[0] * 1.01
    if zooms and m.focal_range_mm is not None and not several_lenses and len(group.photos) > 1:
        low, high = m.focal_range_mm
        remarks.append(phrase("camera_start.zoom_lens", low_mm=low, high_mm=high, focal_mm=m.focal_mm or 0.0))
    return replace(group, remarks=tuple(remarks))
