"""The recording sheet: all that was written of object and recording, and what the photographs know of themselves."""

from __future__ import annotations

from raybundle.report.chapters import Occasion, chapter
from raybundle.report.languages import Said
from raybundle.report.parts import Heading, Paragraph, Part, Section, table, text
from raybundle.results.record import PARTS, WORDS, Record
from raybundle.results.recorded import known_by_photographs, rows_of

LABELS = {
    "title": "Title", "client": "Client", "operator": "Operator", "object": "Object", "place": "Place", "date": "Date",
    "instruments": "Instruments", "rights": "Rights", "reference": "Reference", "kind": "Kind", "dating": "Dating",
    "persons": "Persons", "materials": "Materials", "condition": "Condition", "protection": "Protection",
    "description": "Description", "purpose": "Purpose", "conditions": "Conditions", "control": "Control and scale",
    "archive": "Archive",
}  # fmt: skip
"""Entries as they are printed"""
TITLES = {"object": "Object", "recording": "Recording", "delivery": "Delivery"}
ON_FRONT = {"title", "client", "operator", "object", "place", "date", "instruments", "rights"}
"""Entries of the first page; a sheet that says no more is not printed again"""


@chapter("record", after="network", part="appendix")
def recording_sheet(o: Occasion) -> tuple[Section, ...]:
    """Printed where more is written than stands on the first page."""
    if o.delivery is None or not set(o.delivery.record.as_mapping()) - ON_FRONT:
        return ()
    parts: list[Part] = []
    for part, title in TITLES.items():
        rows = _rows(o.delivery.record, part)
        if rows:
            shape = (text("entry"), text("what"), text("record"))
            parts += [Heading(text=title), table(shape, zip(*rows, strict=True))]
    if o.photographs is not None:
        facts = o.photographs.photographs
        devices = {p.camera: p.device for p in facts if p.device}
        known = known_by_photographs(o.view.adjustment, devices, tuple(p.taken for p in facts))
        shape = (text("entry"), text("from the photographs"))
        parts += [Heading(text="Photographs"), table(shape, zip(*rows_of(known), strict=True))]
    note = (
        "Entries of the object follow the Core Data Index to Historic Buildings and Monuments (Council of Europe, "
        "CIDOC), those of the recording the 3x3 rules of CIPA."
    )
    return (Section(anchor="record", title="Recording sheet", parts=(*parts, Paragraph(text=note, note=True))),)


def _rows(record: Record, part: str) -> list[tuple[str, str, str]]:
    said = record.as_mapping().items()
    return [(LABELS[n], WORDS[n], Said(" / ".join(v.splitlines()))) for n, v in said if PARTS[n] == part]
