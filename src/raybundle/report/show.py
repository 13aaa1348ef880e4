"""A result to look at, from Python: its report or its network in a browser."""

from __future__ import annotations

import sys
import tempfile
import webbrowser
from contextlib import suppress
from dataclasses import dataclass
from html import escape
from pathlib import Path
from typing import Literal

from raybundle.adjustment.result import Adjustment
from raybundle.report.network.page import write_network_page
from raybundle.report.writing import write_report

LARGEST_INLINE = 8_000_000
"""Bytes of a page that a notebook shows within itself."""


@dataclass(frozen=True, slots=True, kw_only=True)
class Page:
    """A page that was written."""

    path: Path

    def __repr__(self) -> str:
        """Where it stands."""
        return f"<page {self.path}>"

    def _repr_html_(self) -> str:
        """The page itself in a frame; of a large one where it stands."""
        if self.path.stat().st_size > LARGEST_INLINE:
            return f"<p>{escape(str(self.path))}</p>"
        text = escape(self.path.read_text(encoding="utf-8"))
        return f'<iframe srcdoc="{text}" width="100%" height="640" style="border:1px solid #d5dbe1"></iframe>'


def show_page(
    result: Adjustment, path: str | Path | None = None, *, what: Literal["report", "network"] = "report"
) -> Page:
    """Write the report of a result, or its network in three dimensions, and open it in the browser.

    path     the HTML file; None: one in a new temporary folder, which stays
    returns  the page, which a notebook shows within itself; there, and where no browser can be opened, none is
    """
    if path is None:
        path = Path(tempfile.mkdtemp(prefix="raybundle-")) / f"{what}.html"
    file = Path(path)
    (write_report if what == "report" else write_network_page)(result, file)
    if "ipykernel" not in sys.modules:
        with suppress(webbrowser.Error):
            webbrowser.open(file.resolve().as_uri())
    return Page(path=file)
