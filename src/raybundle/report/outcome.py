"""What became of something that was asked for of a result: an accuracy, tolerances, lengths."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Literal

from raybundle.errors import Text, phrase

Name = Literal["accuracy", "asprs", "tolerances", "lengths", "displacements", "limit"]


@dataclass(frozen=True, slots=True, kw_only=True)
class Outcome:
    """One thing that was asked for; displacements are kept whatever they are, their limit may not be."""

    name: Name
    kept: bool | None
    """None: it cannot be judged"""
    sentence: Text
    """what was found, against what was asked for"""

    @property
    def label(self) -> Text:
        """Its name in words."""
        return phrase("outcome.name", name=self.name)
