"""The date of each photograph: as it is given, by the folder that it lies in, or by the day on which it was taken."""

from __future__ import annotations

import re
from collections import Counter
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from datetime import date
from itertools import pairwise
from pathlib import Path

from raybundle.errors import InputError, Message, code_of, excluded, warning
from raybundle.io.photos.photo import Found, Photo, find_photos
from raybundle.io.photos.remote import url_of
from raybundle.numerics.progress import Progress, silent
from raybundle.workflows.scenes.images import find_scenes

MOST_REASONS = 3
"""Photographs of a date that are listed with the reason why they take no part"""
SLACK_DAYS = 2
"""By how many days photographs of one date may be taken before or after it"""
_DATE = re.compile(r"(\d{4})[-_.]?(\d{2})[-_.]?(\d{2})")


@dataclass(frozen=True, slots=True, kw_only=True)
class Source:
    """Photographs that were added together."""

    path: Path
    """folder or file"""
    date: str = ""
    """YYYY-MM-DD; empty: each photograph has its own"""


def date_of(text: str) -> str:
    """The date YYYY-MM-DD that a text begins with, as 20260501, 2026-05-01 or 2026_05_01; empty: none."""
    found = _DATE.match(text)
    if found is None:
        return ""
    try:
        return date.fromisoformat(f"{found[1]}-{found[2]}-{found[3]}").isoformat()
    except ValueError:
        return ""


def given_date(text: str) -> str:
    """A date that somebody gave; raises InputError for what is none."""
    found = date_of(text) if _DATE.fullmatch(text) else ""
    if not found:
        raise InputError("epochs.no_date_text", text=text)
    return found


def folders_of(source: Source) -> list[Source]:
    """The sub-folders that are called by dates, each with its own; a source without such folders as it is."""
    if source.date or not source.path.is_dir():
        return [source]
    parts = [Source(path=p, date=d) for p in sorted(source.path.iterdir()) if p.is_dir() and (d := date_of(p.name))]
    own = Source(path=source.path, date=date_of(source.path.resolve().name))
    return parts or [own]


def dates_of(photos: Sequence[Photo], sources: Sequence[Source]) -> dict[str, str]:
    """The date of each photograph by its name.

    raises  InputError for photographs without a date
    """
    given = [(s.path.resolve(), s.date) for s in sources if s.date]
    found: dict[str, str] = {}
    for photo in photos:
        places = {photo.path.resolve(), photo.path.parent.resolve()}  # a photograph may be a link
        mine = next((d for p, d in given if p in places), "")
        taken = photo.metadata.taken
        found[photo.name] = mine or ("" if taken is None else taken.date().isoformat())
    missing = [name for name, d in found.items() if not d]
    if missing:
        raise InputError("epochs.photographs_without_date", n=len(missing), names=missing)
    return found


def contradicted(photos: Sequence[Photo], dates: Mapping[str, str]) -> list[Message]:
    """Warnings of dates that the days on which their photographs were taken contradict.

    Only differences of days count: a clock that is set wrong is wrong at all dates.  Two dates contradict where the
    days are in another order, or their difference is wrong by more than half; a date does where its own days are
    further apart than half of the way to the next date.
    """
    days: dict[str, list[date]] = {}
    for photo in photos:
        if photo.metadata.taken is not None:
            days.setdefault(dates[photo.name], []).append(photo.metadata.taken.date())
    found: list[Message] = []
    names = sorted(days)
    taken = {name: sorted(days[name]) for name in names}
    at = {name: date.fromisoformat(name) for name in names}
    for k, name in enumerate(names):
        near = min((abs((at[n] - at[name]).days) for n in names[max(k - 1, 0) : k + 2] if n != name), default=0)
        first, last = taken[name][0], taken[name][-1]
        if near and (last - first).days > max(SLACK_DAYS, near / 2):
            found.append(warning("epochs.date_of_many_days", date=name, first=str(first), last=str(last)))
    wide = {m.values["date"] for m in found}
    for start, end in pairwise(name for name in names if name not in wide):
        stated = (at[end] - at[start]).days
        first, last = (taken[name][len(taken[name]) // 2] for name in (start, end))
        if abs((last - first).days - stated) > max(SLACK_DAYS, stated / 2):
            found.append(
                warning(
                    "epochs.dates_contradict", start=start, end=end, days=stated, first=str(first), last=str(last),
                    taken=(last - first).days,
                )
            )  # fmt: skip
    return found


def found_in(folders: Sequence[Source], progress: Progress = silent) -> Found:
    """The photographs of all dates, as they are looked for by `orient`.

    raises  InputError for what does not exist, for folders without photographs of their own, and photographs without
            a date
    """
    paths = [s.path for s in folders]
    scenes = find_scenes(paths).files
    found = find_photos(paths, leave=scenes, progress=progress)
    files = [*scenes, *(p.path for p in found.photos), *(p for p, _ in found.refused)]
    there = {place for f in files for place in (f.absolute(), f.parent.resolve())}
    for path in paths:
        if not url_of(path) and path.resolve() not in there and path.absolute() not in there:
            raise InputError("epochs.source_empty", folder=str(path))
    dates_of(found.photos, folders)
    return found


def left_out(found: Found, folders: Sequence[Source], lost: Sequence[tuple[str, str]]) -> list[Message]:
    """A warning for each date, or folder without one, with photographs that take no part.

    found  as of `found_in`
    lost   names of photographs without orientation, and why
    """
    given = {s.path.resolve(): s.date for s in folders if s.date}

    def date(path: Path) -> str:
        return given.get(path.absolute()) or given.get(path.parent.resolve()) or path.parent.name

    of_photo = {p.name: date(p.path) for p in found.photos}
    without = [(date(path), path.name, reason) for path, reason in found.refused]
    count = Counter([*of_photo.values(), *(d for d, _, _ in without)])
    copies = Counter(d for d, _, reason in without if code_of(reason) == "photograph.copy")
    refused = Counter(d for d, _, _ in without)
    without += [(of_photo[name], name, reason) for name, reason in lost if name in of_photo]
    warnings: list[Message] = []
    for d in sorted({d for d, _, _ in without}):
        names = [(name, reason) for of, name, reason in without if of == d]
        warnings.append(
            warning(
                "epochs.photographs_left_out", date=d, n=len(names), total=count[d], whole=len(names) == count[d],
                copies=copies[d], unusable=refused[d] - copies[d], lost=len(names) - refused[d],
                names=[n for n, _ in names], details=excluded(names, most=MOST_REASONS),
            )
        )  # fmt: skip
    return warnings
