"""Words of messages: one catalogue a language, and the text that a reader gets of a code and its values.

A catalogue is the folder of a language here, of files in Fluent (https://projectfluent.org).  The entry of the code
`scale.single_bar` is `scale-single_bar`: its value is the headline, its attributes are `.why` (why it matters) and
`.do` (what to do).  Comments before an English entry give an example of each value.  What a language has no words for
is read in English.
"""

from __future__ import annotations

from raybundle.words.catalogue import ENGLISH, codes, examples, languages, text_codes
from raybundle.words.render import (
    COMMAND_LINE,
    PYTHON,
    Reader,
    action,
    headline,
    read_by,
    reader,
    reading,
    sentences,
    why,
)

__all__ = [
    "COMMAND_LINE", "ENGLISH", "PYTHON", "Reader", "action", "codes", "examples", "headline", "languages", "read_by",
    "reader", "reading", "sentences", "text_codes", "why",
]  # fmt: skip
