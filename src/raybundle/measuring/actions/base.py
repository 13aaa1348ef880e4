"""What every action of measuring is."""

from __future__ import annotations

from abc import ABC, abstractmethod
from dataclasses import asdict, dataclass
from typing import Any, ClassVar, Literal

from raybundle.measuring.names import Known
from raybundle.measuring.state import Draft, State


@dataclass(frozen=True, slots=True, kw_only=True)
class Action(ABC):
    """One verb with its arguments."""

    verb: ClassVar[str] = ""

    @property
    def turns(self) -> Literal["", "undo", "redo"]:
        """Whether it moves among the actions before it."""
        return ""

    @property
    def arguments(self) -> dict[str, Any]:
        """As JSON states them."""
        return asdict(self)

    def settled(self, state: State, known: Known) -> Action:
        """The action with images by their ids; raises InputError where it cannot be done in this state."""
        del state, known
        return self

    @abstractmethod
    def apply(self, draft: Draft) -> None:
        """Change a draft."""
