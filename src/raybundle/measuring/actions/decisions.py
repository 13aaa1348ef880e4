"""Verbs that decide: which parameters are free or held, and which image observations beyond a limit are left out."""

from __future__ import annotations

from dataclasses import dataclass, replace
from typing import ClassVar, Literal

from raybundle.adjustment.records.options import AdjustmentOptions
from raybundle.errors import InputError
from raybundle.measuring.actions.base import Action
from raybundle.measuring.actions.checks import check_number
from raybundle.measuring.names import Known
from raybundle.measuring.state import Choice, Draft, Key, State

Quantity = Literal["w", "sigma", "rays", "redundancy"]
"""By what image observations are selected."""


@dataclass(frozen=True, slots=True, kw_only=True)
class SetParameter(Action):
    """Whether a parameter of a camera is estimated or held in the next adjustments; auto: as block and options say."""

    verb: ClassVar[str] = "parameter"
    camera: str
    symbol: str
    choice: Choice | Literal["auto"]

    def settled(self, state: State, known: Known) -> Action:
        del state
        there = {} if known.block is None else {c.id: c.sensor.symbols for c in known.block.parametrised}
        if self.camera not in there:
            raise InputError("camera.not_in_block", camera=self.camera, known=list(there), n=len(there))
        if self.symbol not in there[self.camera]:
            raise InputError("camera.no_parameter", camera=self.camera, name=self.symbol, known=there[self.camera])
        return self

    def apply(self, draft: Draft) -> None:
        draft.parameters.pop((self.camera, self.symbol), None)
        if self.choice != "auto":
            draft.parameters[self.camera, self.symbol] = self.choice


@dataclass(frozen=True, slots=True, kw_only=True)
class RejectBeyond(Action):
    """Leave all image observations of the block out that were found beyond a limit: one action, which holds them."""

    verb: ClassVar[str] = "reject_beyond"
    quantity: Quantity
    limit: float
    rows: tuple[Key, ...]
    """(image, point) of each, as they were found; what the limit finds later does not matter"""

    def settled(self, state: State, known: Known) -> Action:
        check_number(self.quantity, self.limit, least=0.0)
        if not self.rows:
            raise InputError("selection.nothing_beyond", quantity=self.quantity, limit=self.limit)
        rows = tuple((known.image(image), point) for image, point in self.rows)
        there, old = known.pairs(), {new: name for name, new in state.renamed.items()}
        for image, point in rows:
            if (image, old.get(point, point)) not in there or point in state.renamed:
                raise InputError("mark.no_observation", point=point, image=image)
        return replace(self, rows=rows)

    def apply(self, draft: Draft) -> None:
        draft.rejected |= set(self.rows)


def with_decisions(options: AdjustmentOptions, state: State) -> AdjustmentOptions:
    """The options with the parameters that a journal frees and holds; what the options themselves name goes before."""
    named = {*options.free, *options.hold}
    decided = {pair: choice for pair, choice in state.parameters.items() if pair not in named}
    return replace(
        options, free=(*options.free, *sorted(p for p, choice in decided.items() if choice == "free")),
        hold=(*options.hold, *sorted(p for p, choice in decided.items() if choice == "held")),
    )  # fmt: skip
