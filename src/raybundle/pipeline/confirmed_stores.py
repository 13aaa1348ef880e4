"""Stores at URLs that the user of this machine has given: a project folder may come from somebody else.

    CONFIG/stores.json  URLs, a list; CONFIG is RAYBUNDLE_CONFIG, or the system's place for settings of a user

A URL that a project folder names is used only if it stands in this list.  Giving it once, as the store of a run or as
`raybundle worker URL`, adds it.
"""

from __future__ import annotations

import json
import os
import uuid
from contextlib import suppress
from pathlib import Path

from raybundle.errors import InputError
from raybundle.io.reading.trees import read_json
from raybundle.io.user_folders import settings_folder
from raybundle.pipeline.objects import shown_url
from raybundle.pipeline.store import whole_url

FILE = "stores.json"
WORKER = "raybundle worker"


def confirm_store(url: str) -> None:
    """Add a URL that the user has given; without effect if the list cannot be written."""
    name, known = _name(url), confirmed_stores()
    if name in known:
        return
    folder = settings_folder()
    with suppress(OSError):
        folder.mkdir(mode=0o700, parents=True, exist_ok=True)
        temporary = folder / f".{FILE}.{uuid.uuid4().hex[:8]}"
        try:
            temporary.write_text(json.dumps([*known, name], indent=1) + "\n", encoding="utf-8")
            os.replace(temporary, folder / FILE)  # noqa: PTH105  (whole, or not at all)
        finally:
            temporary.unlink(missing_ok=True)


def is_confirmed(url: str) -> bool:
    """Whether the user has given this URL on this machine."""
    return _name(url) in confirmed_stores()


def check_confirmed(url: str, named_in: Path) -> None:
    """Raise InputError for a URL that a project folder names and the user has not given; nothing is opened.

    named_in  the file that names it
    """
    if not is_confirmed(url):
        shown = shown_url(url)
        raise InputError(
            "store.not_confirmed",
            url=shown,
            worker=WORKER,
            file=named_in,
        )


def confirmed_stores() -> list[str]:
    """URLs of the list; none if it is missing or damaged."""
    with suppress(InputError, OSError):
        return [url.text() for url in read_json(settings_folder() / FILE).items()]
    return []


def _name(url: str) -> str:
    return whole_url(url).rstrip("/")
