"""Where the system wants what belongs to a user: data that are kept, and what can be made again."""

from __future__ import annotations

import os
import sys
from pathlib import Path
from typing import Literal

PLACES = {
    "data": ("Application Support", "XDG_DATA_HOME", ".local/share"),
    "cache": ("Caches", "XDG_CACHE_HOME", ".cache"),
    "config": ("Application Support", "XDG_CONFIG_HOME", ".config"),
}
"""On macOS, below Library; elsewhere a variable, and the folder below the user's where it states nothing"""


def user_folder(what: Literal["data", "cache", "config"]) -> Path:
    """The folder of raybundle for data, for what can be made again, or for settings; it need not be there."""
    mac, variable, usual = PLACES[what]
    if sys.platform == "darwin":
        base = Path.home() / "Library" / mac
    elif sys.platform == "win32":
        base = Path(os.environ.get("LOCALAPPDATA") or Path.home() / "AppData" / "Local")
    else:
        base = Path(os.environ.get(variable) or Path.home() / usual)
    return base / "raybundle"


def made_again_folder() -> Path:
    """Where what can be made again is kept: RAYBUNDLE_CACHE, or the system's place for it."""
    given = os.environ.get("RAYBUNDLE_CACHE", "")
    return Path(given) if given else user_folder("cache")


def settings_folder() -> Path:
    """Where settings of this user are kept: RAYBUNDLE_CONFIG, or the system's place for them."""
    given = os.environ.get("RAYBUNDLE_CONFIG", "")
    return Path(given) if given else user_folder("config")
