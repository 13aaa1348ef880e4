"""How a browser is led to an address that holds a secret."""

from __future__ import annotations

import os
from html import escape
from pathlib import Path


def hand_over(address: str, folder: Path) -> Path:
    """A page, which this user alone can read, that leads to the address: a command line is read by all users."""
    page = folder / "open.html"
    with open(page, "x", encoding="utf-8", opener=lambda path, flags: os.open(path, flags, 0o600)) as file:
        file.write(
            '<!doctype html><meta charset="utf-8"><meta name="referrer" content="no-referrer"><title>studio</title>'
            f'<meta http-equiv="refresh" content="0;url={escape(address, quote=True)}">\n'
        )
    return page
