"""A drawing in the reader's language: its entries, notes and what is written along lines; names stay."""

from __future__ import annotations

from dataclasses import replace

from raybundle.report.drawing.content import Drawing
from raybundle.report.languages.language import Language


def drawing_in(drawing: Drawing, language: Language) -> Drawing:
    """The same in a language; texts that are `Localised` stay as they are."""
    say = language.text
    return replace(
        drawing,
        language=language,
        fields=tuple(replace(f, label=say(f.label), text=say(f.text)) for f in drawing.fields),
        notes=tuple(say(n) for n in drawing.notes),
        lines=tuple(replace(n, words=say(n.words)) for n in drawing.lines),
    )
