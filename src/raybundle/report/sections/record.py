"""The recording sheet: all that was written of object and recording, and what the photographs know of themselves."""

from __future__ import annotations

from raybundle.errors import phrase
from raybundle.report.chapters import Occasion, chapter
from raybundle.report.languages import Localised
from raybundle.report.parts import Heading, Paragraph, Part, Section, table, text
from raybundle.results.record import PARTS, Record
from raybundle.results.recording_sheet import known_by_photographs, rows_of

TITLES = ("object", "recording", "delivery")
"""Parts of the sheet"""
ON_FRONT = {"title", "client", "operator", "object", "place", "date", "instruments", "rights"}
"""Entries of the first page; a sheet that states no more is not printed again"""


@chapter("record", after="network", part="appendix")
def recording_sheet(o: Occasion) -> tuple[Section, ...]:
    """Printed where more is written than stands on the first page."""
    if o.delivery is None or not set(o.delivery.record.as_mapping()) - ON_FRONT:
        return ()
    parts: list[Part] = []
    for part in TITLES:
        rows = _rows(o.delivery.record, part)
        if rows:
            shape = (
                text(phrase("report_record.entry")),
                text(phrase("label.meaning")),
                text(phrase("report_record.record")),
            )
            parts += [Heading(text=phrase("report_record.part", part=part)), table(shape, zip(*rows, strict=True))]
    if o.photographs is not None:
        facts = o.photographs.photographs
        devices = {p.camera: p.device for p in facts if p.device}
        known = known_by_photographs(o.view.adjustment, devices, tuple(p.taken for p in facts))
        shape = (text(phrase("report_record.entry")), text(phrase("report_record.from_photographs")))
        parts += [Heading(text=phrase("report_photographs.title")), table(shape, zip(*rows_of(known), strict=True))]
    parts.append(Paragraph(text=phrase("report_record.sources"), note=True))
    return (Section(anchor="record", title=phrase("report_record.title"), parts=tuple(parts)),)


def _rows(record: Record, part: str) -> list[tuple[str, str, str]]:
    stated = record.as_mapping().items()
    return [
        (
            phrase("report_record.name", name=n),
            phrase("report_record.meaning", name=n),
            Localised(" / ".join(v.splitlines())),
        )
        for n, v in stated
        if PARTS[n] == part
    ]
