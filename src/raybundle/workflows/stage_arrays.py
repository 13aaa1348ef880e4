"""How what several stages give is kept as arrays: notices, reasons, tie points, and some of them under one roof."""

from __future__ import annotations

import json
from collections.abc import Mapping, Sequence

import numpy as np

from raybundle.adjustment.records.notice import Notice
from raybundle.adjustment.records.severity import Severity
from raybundle.errors import Text, message_of, plain
from raybundle.io.block.arrays import arrays_of_block, block_of_arrays, names_of_text, text_of_names, value_of_text
from raybundle.numerics.arrays import Array
from raybundle.ties.block import TieBlock

Reasons = tuple[tuple[str, str], ...]
"""names of images and why each takes no part"""


def texts(values: Sequence[str]) -> Array:
    """Texts (n,)."""
    return np.array(values, dtype=np.str_)


def reasons_as_array(reasons: Sequence[tuple[str, str]]) -> Array:
    """Names, reasons and their messages as JSON (n, 3)."""
    rows = [
        (name, str(why), json.dumps([plain(m.json()) for m in why.messages] if isinstance(why, Text) else []))
        for name, why in reasons
    ]
    return np.array(rows, dtype=np.str_).reshape(-1, 3)


def reasons_of_array(kept: Array) -> Reasons:
    """The same again; of versions that had no messages the texts."""
    return tuple(_reason(*row) for row in kept.tolist())


def _reason(name: str, why: str, messages: str = "[]") -> tuple[str, str]:
    found = value_of_text(messages)
    return name, Text.of(*map(message_of, found)) if found else why


def notices_as_array(notices: Sequence[Notice]) -> Array:
    """Code, text, severity, ids, values and details as JSON, and the code of the words (n, 7)."""
    rows = [
        (f"{n.code}.{n.variant}" if n.variant else n.code, n.message, str(n.severity.value), text_of_names(n.ids),
         json.dumps(plain(n.values)), json.dumps([plain(d.json()) for d in n.details]), n.words)
        for n in notices
    ]  # fmt: skip
    return np.array(rows, dtype=np.str_).reshape(-1, 7)


def notices_of_array(kept: Array) -> tuple[Notice, ...]:
    """The same again."""
    return tuple(_notice(*row) for row in kept.tolist())


def _notice(
    code: str, message: str, severity: str, ids: str, values: str = "{}", details: str = "[]", words: str = ""
) -> Notice:  # fmt: skip
    return Notice(
        code=code, message=message, measured=Severity(severity), ids=names_of_text(ids), values=value_of_text(values),
        details=tuple(map(message_of, value_of_text(details))), words=words,
    )  # fmt: skip


def packed(parts: Mapping[str, Mapping[str, Array]]) -> dict[str, Array]:
    """The arrays of some parts under names of their own."""
    return {f"{part}:{name}": values for part, arrays in parts.items() for name, values in arrays.items()}


def unpacked(arrays: Mapping[str, Array]) -> dict[str, dict[str, Array]]:
    """The parts again, in their order; what is of no part is left."""
    found: dict[str, dict[str, Array]] = {}
    for key, values in arrays.items():
        part, colon, name = key.partition(":")
        if colon:
            found.setdefault(part, {})[name] = values
    return found


def numbered(parts: Sequence[Mapping[str, Array]]) -> dict[str, Array]:
    """As `packed`, of parts by their number."""
    return packed({str(k): part for k, part in enumerate(parts)})


def arrays_of_tie(tie: TieBlock) -> dict[str, Array]:
    """Tie points as they are kept."""
    lost = reasons_as_array(tie.not_oriented)
    return {**arrays_of_block(tie.block), "scale_px": tie.scale_px, "angle": tie.angle, "lost": lost}


def tie_of_arrays(a: Mapping[str, Array]) -> TieBlock:
    """The same again."""
    return TieBlock(
        block=block_of_arrays(a), scale_px=a["scale_px"], angle=a["angle"], not_oriented=reasons_of_array(a["lost"])
    )
