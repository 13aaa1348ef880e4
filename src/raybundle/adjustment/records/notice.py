"""Notices: what a result has to state, with its code, values and severity."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass, field, replace

from raybundle.adjustment.records.severity import Severity, severity_of
from raybundle.errors import Message, Text, Value, plain


@dataclass(frozen=True, slots=True, kw_only=True)
class Notice:
    """Something the user should know: a warning of result.json, a line of the report."""

    code: str
    """Stable, snake case: "not_determinable", "behind_camera" ...; with what is behind a dot as its variant"""
    message: str = ""
    """Its text, where no catalogue has the code."""
    ids: tuple[str, ...] = ()
    """Objects; `ids` among the values of the text."""
    reason: str = ""
    """Of one object: why, in words that stand after its name in a list."""
    measured: Severity | None = None
    """How grave it is, where that hangs on the numbers; None: as grave as its code."""
    values: Mapping[str, Value] = field(default_factory=dict[str, Value])
    """The numbers and names of the text, by name, with their unit in it."""
    also: tuple[str, ...] = ()
    """Other objects of which the same holds."""
    details: tuple[Message, ...] = ()
    variant: str = ""
    """Which of several messages of this code: "turned" of "behind_camera.turned"."""
    words: str = ""
    """The code whose words it has, where it shares those of other codes."""

    def __post_init__(self) -> None:
        """Take the variant off the code."""
        code, dot, variant = self.code.partition(".")
        if dot:
            object.__setattr__(self, "code", code)
            object.__setattr__(self, "variant", variant)

    @property
    def severity(self) -> Severity:
        """fault, caution or remark."""
        return self.measured or severity_of(self.code)

    @property
    def data(self) -> Message:
        """The message as data."""
        values: dict[str, Value] = {**({"ids": self.ids} if self.ids else {}), **self.values}
        code = self.words or (f"{self.code}.{self.variant}" if self.variant else self.code)
        return Message(code=code, values=plain(values), severity=self.severity, details=self.details)

    @property
    def text(self) -> str:
        """What, which object, the number against its limit, and what to do: in English, and in any language as data."""
        if self.message:
            return self.message
        more = (
            Message(code="notice.also", values={"n": len(self.also), "names": list(self.also)}) if self.also else None
        )
        return Text.of(self.data, *(() if more is None else (more,)))


def notice_of_text(code: str, text: str, ids: tuple[str, ...] = (), measured: Severity | None = None) -> Notice:
    """A notice of this code whose words are those of a message, where the text has one."""
    if isinstance(text, Text) and len(text.messages) == 1:
        (m,) = text.messages
        return Notice(code=code, words=m.code, values=m.values, details=m.details, ids=ids, measured=measured)
    return Notice(code=code, message=text, ids=ids, measured=measured)


def gravest_first(notices: Iterable[Notice]) -> list[Notice]:
    """The notices in order of their severity, those of one in the order in which they were made."""
    order = list(Severity)
    return sorted(notices, key=lambda n: order.index(n.severity))


MANY = 3
"""Notices of one kind that are reported one by one."""


NAMED = 10
"""Objects that a notice names in the place of their notices."""


def sorted_notices(notices: Iterable[Notice], many: int = MANY) -> list[Notice]:
    """The notices as people read them, the gravest first: one in place of many that say the same of other objects.

    many  notices of one kind that stand one by one
    """
    kinds: dict[tuple[str, Severity], list[Notice]] = {}
    for n in gravest_first(notices):
        kinds.setdefault((n.code, n.severity), []).append(n)
    found: list[Notice] = []
    for group in kinds.values():
        if len(group) <= many or not all(n.ids for n in group):
            found += list({n.text: n for n in group}.values())
            continue
        # a parameter stands behind its camera
        names = [": ".join(n.ids) if len(n.ids) == 2 else n.ids[0] for n in group[1:]]
        ids = tuple(dict.fromkeys(i for n in group for i in n.ids))
        found.append(_with_others(group[0], names, ids))
    return found


def _with_others(notice: Notice, names: Sequence[str], ids: tuple[str, ...]) -> Notice:
    """A notice that stands for others of its kind, too."""
    if not notice.message:
        return replace(notice, values={"ids": notice.ids, **notice.values}, also=tuple(names), ids=ids)
    named = f"{', '.join(names[:NAMED])}{', ...' if len(names) > NAMED else ''}"
    message = f"{notice.message.removesuffix('.')}. The same of {len(names)} more: {named}"
    return replace(notice, message=message, ids=ids)
