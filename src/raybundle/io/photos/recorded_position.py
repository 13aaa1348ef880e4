"""Position of a photograph from all entries that record one: EXIF, and XMP of the aircraft or of an editor.

Each source is judged by itself (a fix, a hemisphere, parts that are degrees, minutes and seconds), then against the
others: within what rounding explains they agree, and the one with more digits is taken.  Where sources disagree,
those of the majority are taken; without one, the finest if single GNSS positions may differ so much, else none.
Whatever is left out has a remark.
"""

from __future__ import annotations

import math
import re
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from typing import Any

from raybundle.errors import Message, Text, note, phrase
from raybundle.io.photos.exif import Tags
from raybundle.io.photos.map_datum import geographic_system, in_wgs84, is_wgs84
from raybundle.io.reading.words import number_of

GNSS_M = 5.0
"""Usual standard deviation of a single GNSS position in plan, per axis."""
NEAR_M = 3 * math.sqrt(2) * GNSS_M
"""Largest difference of two single positions of one place: three standard deviations of the difference."""
METRES_PER_DEGREE = 111_320.0
NO_FIX_DEG = 1e-4
"""Both coordinates below this are written by receivers without a fix."""
FINEST = 9
"""Decimals that are looked at."""
COARSE_DEG = 1.5 / 3600
"""Step of the last digit from which on rounding outweighs the usual standard deviation."""
SLACK_DEG = 1e-9
XMP_PAIRS = (
    ("XMP drone-dji:GpsLatitude", ("drone-dji:GpsLatitude",), ("drone-dji:GpsLongitude", "drone-dji:GpsLongtitude")),
    ("XMP drone-dji:Latitude", ("drone-dji:Latitude",), ("drone-dji:Longitude", "drone-dji:Longtitude")),
)
LIMITS = (90.0, 180.0)
LETTERS = ("NS", "EW")


@dataclass(frozen=True, slots=True, kw_only=True)
class Recorded:
    """Latitude and longitude from one source."""

    source: str
    origin: str
    """Who wrote it: sources of one origin are one vote"""
    angles: tuple[float, float]
    """[deg]"""
    step: tuple[float, float]
    """Of the last digit [deg]"""
    signed: tuple[bool, bool] = (True, True)
    """Whether the hemisphere is stated"""

    def agrees(self, other: Recorded) -> bool:
        """Whether rounding explains the difference."""
        turn = (self.angles[1] - other.angles[1] + 180) % 360 - 180
        pairs = zip((self.angles[0] - other.angles[0], turn), self.step, other.step, strict=True)
        return all(abs(d) <= s + t + SLACK_DEG for d, s, t in pairs)

    def distance_m(self, other: Recorded) -> float:
        """Distance in plan, on a sphere."""
        north = (self.angles[0] - other.angles[0]) * METRES_PER_DEGREE
        turn = (self.angles[1] - other.angles[1] + 180) % 360 - 180
        return math.hypot(north, turn * METRES_PER_DEGREE * math.cos(math.radians(self.angles[0])))

    @property
    def rounding_m(self) -> tuple[float, float]:
        """Standard deviation of the rounding, east and north."""
        north, east = (s * METRES_PER_DEGREE / math.sqrt(12) for s in self.step)
        return east * math.cos(math.radians(self.angles[0])), north

    @property
    def coarse(self) -> bool:
        """Whether its rounding outweighs the usual standard deviation."""
        return max(self.step) > COARSE_DEG

    def __str__(self) -> str:
        """For people."""
        return f"{self.source} {self.angles[0]:.7g}, {self.angles[1]:.7g}"


def recorded_position(tags: Tags, entries: Mapping[str, str]) -> tuple[Recorded | None, tuple[str, ...]]:
    """The position to be used, None without one, and remarks on what was left out."""
    remarks: list[str] = []
    found = [c for c in _candidates(tags, entries, remarks) if _has_fix(c, remarks)]
    usable = _with_hemispheres(found, remarks)
    if not usable:
        return None, tuple(remarks)
    chosen = _chosen(usable, remarks)
    if chosen is not None and chosen.coarse:
        remarks.append(
            phrase("photo_entry.position_rounded", step_m=max(chosen.rounding_m) * math.sqrt(12), position=str(chosen))
        )
    return chosen, tuple(remarks)


def _candidates(tags: Tags, entries: Mapping[str, str], remarks: list[str]) -> Iterator[Recorded]:
    exif = _from_exif(tags, remarks)
    if exif is None and not any(tags.numbers(tag, gps=True) for tag in (2, 4)):
        exif = _from_xmp_exif(entries, remarks)  # an editor's copy of EXIF: no second witness beside it
    exif = None if exif is None else _of_receiver(exif, tags, entries, remarks)
    if exif is not None:
        yield exif
    for source, *keys in XMP_PAIRS:
        texts = [next((entries[k].strip() for k in names if entries.get(k)), "") for names in keys]
        if not any(texts):
            continue
        angles = [number_of(t) for t in texts]
        if angles[0] is None or angles[1] is None:
            if not all(texts):  # what is no number has a remark already
                remarks.append(phrase("photo_entry.half_missing", source=source, longitude=bool(texts[0])))
        elif any(abs(a) > m for a, m in zip(angles, LIMITS, strict=True) if a is not None):
            remarks.append(
                phrase("photo_entry.no_place", source=source, latitude_deg=angles[0], longitude_deg=angles[1])
            )
        else:
            steps = (step_of_text(texts[0]), step_of_text(texts[1]))
            yield Recorded(source=source, origin="drone-dji", angles=(angles[0], angles[1]), step=steps)


def _of_receiver(found: Recorded, tags: Tags, entries: Mapping[str, str], remarks: list[str]) -> Recorded | None:
    """The position of EXIF in WGS 84; None with a remark where the receiver had no fix or its datum is not known."""
    status = (tags.text(9, gps=True) or entries.get("exif:GPSStatus", "")).strip().upper()
    if status[:1] == "V":
        remarks.append(phrase("photo_entry.no_fix_status", source=found.source, status=status))
        return None
    datum = tags.text(18, gps=True) or entries.get("exif:GPSMapDatum", "")
    if is_wgs84(datum):
        return found
    system = geographic_system(datum)
    moved = None if system is None or not all(found.signed) else in_wgs84(system, *found.angles)
    if moved is None:
        remarks.append(phrase("photo_entry.no_transformation", source=found.source, map_datum=datum))
        return None
    result = replace(found, angles=moved)
    remarks.append(
        phrase(
            "photo_entry.moved", source=found.source, map_datum=datum, system=str(system),
            shift_m=result.distance_m(found),
        )
    )  # fmt: skip
    return result


def _from_exif(tags: Tags, remarks: list[str]) -> Recorded | None:
    parts = [tags.numbers(tag, gps=True) for tag in (2, 4)]
    if not any(parts):
        return None
    letters = [tags.text(tag, gps=True).strip().upper()[:1] for tag in (1, 3)]
    return _of_parts("EXIF", parts, letters, remarks)


def _from_xmp_exif(entries: Mapping[str, str], remarks: list[str]) -> Recorded | None:
    """Texts like "47,30.5N" or "47,30,15N"."""
    if not (entries.get("exif:GPSLatitude") and entries.get("exif:GPSLongitude")):
        return None
    parts: list[tuple[float, ...]] = []
    letters: list[str] = []
    for key in ("exif:GPSLatitude", "exif:GPSLongitude"):
        text = entries[key].strip().upper()
        letters.append(text[-1:] if text[-1:].isalpha() else "")
        numbers = [number_of(w) for w in text.rstrip("NSEW ").split(",")]
        parts.append(tuple(math.nan if n is None else n for n in numbers))
    return _of_parts("XMP exif:GPSLatitude", parts, letters, remarks)


def _of_parts(
    source: str, parts: Sequence[tuple[float, ...]], letters: Sequence[str], remarks: list[str]
) -> Recorded | None:
    """Degrees, minutes, seconds of latitude and longitude; None with a remark where they are no angles."""
    found: list[tuple[float, float]] = []
    signed: list[bool] = []
    for values, letter, allowed, limit, name in zip(
        parts, letters, LETTERS, LIMITS, ("latitude", "longitude"), strict=True
    ):
        angle = _angle(values)
        if isinstance(angle, Message) or abs(angle[0]) > limit:
            why = (
                angle
                if isinstance(angle, Message)
                else note("photo_entry.angle_beyond", value_deg=angle[0], limit_deg=limit)
            )
            remarks.append(Text.of(note("photo_entry.angle", source=source, longitude=name == "longitude"), why))
            return None
        degrees, step = angle
        known = letter in allowed if letter else False
        if degrees < 0 and letter == allowed[0]:
            remarks.append(
                phrase(
                    "photo_entry.angle_contradicts",
                    source=source,
                    longitude=name == "longitude",
                    value_deg=degrees,
                    letter=letter,
                )
            )
            return None
        negative = degrees < 0 or letter == allowed[1]
        signed.append(known or degrees < 0)
        found.append((-abs(degrees) if negative else degrees, step))
    (latitude, one), (longitude, two) = found
    return Recorded(
        source=source, origin="EXIF", angles=(latitude, longitude), step=(one, two), signed=(signed[0], signed[1])
    )


def _angle(values: tuple[float, ...]) -> tuple[float, float] | Message:
    """Degrees and the step of the last digit; else what is wrong."""
    if not 1 <= len(values) <= 3:
        return note("photo_entry.angle_numbers", n=len(values))
    known = list(values)
    while known and not math.isfinite(known[-1]):
        known.pop()  # x/0: the part is not known
    if not known or not all(map(math.isfinite, known)):
        return note("photo_entry.angle_fraction")
    shown = ", ".join(f"{v:.9g}" for v in known)
    if any(v < 0 or v > 60 for v in known[1:]):
        return note("photo_entry.angle_sixty", values=shown)
    if any(v % 1 and any(known[k + 1 :]) for k, v in enumerate(known)):
        return note("photo_entry.angle_decimals", values=shown)
    last = max((k for k, v in enumerate(known) if v), default=len(known) - 1)
    last = last if known[last] % 1 else len(known) - 1
    size = sum(abs(v) / 60**k for k, v in enumerate(known))
    sign = -1.0 if known[0] < 0 else 1.0
    return sign * size, 10.0 ** -_decimals(known[last]) / 60**last


def _decimals(value: float) -> int:
    return next((k for k in range(FINEST) if abs(round(value, k) - value) < 1e-10), FINEST)


def step_of_number(value: float) -> float:
    """Step of the last digit of a number."""
    return 10.0 ** -_decimals(value)


def step_of_text(text: str) -> float:
    """Step of the last digit of a number as it is written."""
    digits = re.search(r"\.(\d*)", text)
    return 10.0 ** -min(len(digits[1]) if digits else 0, FINEST)


def _has_fix(found: Recorded, remarks: list[str]) -> bool:
    if max(map(abs, found.angles)) >= NO_FIX_DEG:
        return True
    remarks.append(phrase("photo_entry.no_fix", source=found.source))
    return False


def _with_hemispheres(found: Sequence[Recorded], remarks: list[str]) -> list[Recorded]:
    """Sources whose hemisphere is stated, or follows from another that agrees but for the sign."""
    whole = [c for c in found if all(c.signed)]
    result: list[Recorded] = []
    for c in found:
        if all(c.signed):
            result.append(c)
            continue
        signs = next((s for o in whole if (s := _signed_as(c, o)) is not None), None)
        if signs is not None:
            result.append(signs)
            continue
        lacking = [n for n, s in zip(("GPSLatitudeRef", "GPSLongitudeRef"), c.signed, strict=True) if not s]
        remarks.append(phrase("photo_entry.no_hemisphere", source=c.source, missing=lacking, position=str(c)))
    return result


def _signed_as(found: Recorded, other: Recorded) -> Recorded | None:
    angles = [a if s else math.copysign(a, b) for a, s, b in zip(found.angles, found.signed, other.angles, strict=True)]
    signed = replace(found, angles=(angles[0], angles[1]), signed=(True, True))
    return signed if signed.agrees(other) or signed.distance_m(other) <= NEAR_M else None


def _chosen(usable: Sequence[Recorded], remarks: list[str]) -> Recorded | None:
    clusters = [[o for o in usable if o.agrees(c)] for c in usable]
    votes = [len({o.origin for o in cluster}) for cluster in clusters]
    finest = sorted(range(len(usable)), key=lambda k: (-votes[k], max(usable[k].step)))
    best = usable[finest[0]]
    others = [c for c in usable if not best.agrees(c)]
    if not others:
        return best
    far = max(others, key=best.distance_m)
    distance = best.distance_m(far)
    values: dict[str, Any] = {"first": str(best), "second": str(far), "apart_m": distance}
    tied = {o.origin for o in others} - {o.origin for o in clusters[finest[0]]}
    if distance <= NEAR_M:
        remarks.append(phrase("photo_entry.positions_differ", source=best.source, **values))
        return best
    if votes[finest[0]] > 1 or not tied:
        remarks.append(phrase("photo_entry.position_contradicts", source=far.source, **values))
        return best
    remarks.append(phrase("photo_entry.positions_contradict", **values))
    return None
