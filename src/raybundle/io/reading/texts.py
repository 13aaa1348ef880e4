"""Texts that were stored with their messages."""

from __future__ import annotations

import json

from raybundle.errors import Text, message_of


def stored_text(stored: str, words: str | None = None) -> str:
    """The text of a message, or of several, as JSON; what is none stays as it is, or is `words`."""
    try:
        found = json.loads(stored)
        return Text.of(*map(message_of, found if isinstance(found, list) else [found]))
    except (ValueError, KeyError, TypeError, AttributeError):
        return stored if words is None else words
