"""A result in a few lines, as Python and notebooks show it."""

from __future__ import annotations

import math
from html import escape
from typing import TYPE_CHECKING

from raybundle.adjustment.severity import Severity
from raybundle.numerics.counting import counted, grouped

if TYPE_CHECKING:
    from raybundle.adjustment.result import Adjustment, ParameterResult

COLOURS = {Severity.FAULT: "#a12f2f", Severity.WARNING: "#b5532a", Severity.NOTE: "#5b6774"}
NOTICES = 5
"""Notices that a notebook shows."""


def line_of(a: Adjustment) -> str:
    """One line: what was adjusted, how well it fits, in which datum, and how many notices there are."""
    used = a.image_observations.used
    parts = [
        repr(a.given.name),
        counted(len(set(a.given.observations.image[used].tolist())), "image"),
        counted(len(set(a.given.observations.point[used].tolist())), "object point"),
        f"sigma0 {a.sigma0:.4g}" if math.isfinite(a.sigma0) else "no sigma0",
        f"redundancy {grouped(a.redundancy)}",
        *([] if a.converged else ["not converged"]),
        *(counted(n, s.value) for s in Severity if (n := sum(x.severity is s for x in a.notices))),
    ]
    return f"<Adjustment {', '.join(parts)}>"


def html_of(a: Adjustment) -> str:
    """A small table: the line above, interior orientations, the gravest notices."""
    from raybundle.adjustment.result import printed_unit, sorted_notices  # noqa: PLC0415  (which imports this)

    head = f"<p><b>{escape(line_of(a)[1:-1])}</b><br>datum: {escape(a.datum)}</p>"
    rows = "".join(
        f"<tr><td>{escape(i.camera if i.image is None else f'{i.camera}, {i.image}')}</td><td>{escape(p.symbol)}</td>"
        f"<td>{p.value:.6g}</td><td>{_std(p)}</td><td>{escape(printed_unit(p.unit, a.length_unit))}</td>"
        f"<td>{escape(p.status)}</td></tr>"
        for i in a.interior
        if i.image is None
        for p in i.parameters.values()
        if p.std is not None or p.value
    )
    titles = "".join(f"<th>{t}</th>" for t in ("camera", "parameter", "value", "sigma", "unit", ""))
    table = f"<table><tr>{titles}</tr>{rows}</table>" if rows else ""
    reported = sorted_notices(a.notices)
    notices = "".join(
        f'<li><b style="color:{COLOURS[n.severity]}">{n.severity.value}</b>: {escape(n.text)}</li>'
        for n in reported[:NOTICES]
    )
    more = f"<li>and {counted(len(reported) - NOTICES, 'more notice')}</li>" if len(reported) > NOTICES else ""
    return f"<div>{head}{table}{f'<ul>{notices}{more}</ul>' if notices else ''}</div>"


def _std(p: ParameterResult) -> str:
    return "" if p.std is None else f"{p.std:.2g}"
