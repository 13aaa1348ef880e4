"""Whether products may lie where a run is reported: stated before anything is computed or remembered."""

from __future__ import annotations

import os
import re
import secrets
from collections.abc import Sequence
from pathlib import Path
from urllib.parse import urlsplit

from raybundle.errors import InputError
from raybundle.io.copies import StoreLost, check_copies
from raybundle.pipeline.confirmed_stores import confirm_store
from raybundle.pipeline.objects import Objects, objects_at, refused_url, shown_url
from raybundle.pipeline.store import whole_url
from raybundle.settings import option

LOCAL = {"file", "local"}
"""Of folders of this machine, or that it sees"""
ESCAPED = re.compile(r"%[0-9A-Fa-f]{2}")
KINDS = "as s3://bucket/folder, gs://, az:// or file:///folder"


def check_store(given: str, *, out: Path, apart: Sequence[Path] = (), lasting: bool = True) -> None:
    """Raise InputError for a URL where the products of a run cannot lie, with the setting as it was given.

    One where they can is confirmed from now on (`confirmed_stores`).

    given    the URL
    out      project or result folder of the run
    apart    what the run reads: folders of photographs, photographs, a block
    lasting  whether the place is one for good: it gets what it is known by; or nothing of this is left there
    """
    named = option("store", shown_url(given))
    if "://" not in given:
        raise InputError("store.no_url", file=named)
    try:
        scheme, secret = urlsplit(given).scheme, urlsplit(given).password
    except ValueError as error:
        raise InputError("store.invalid_url", detail=str(error), file=named) from None
    if secret:
        raise InputError("store.secret", file=named)
    refusal = refused_url(given)
    if refusal:
        raise InputError(refusal, file=named)
    if scheme == "memory":
        raise InputError("store.in_memory", file=named)
    _check_place(given, named, scheme)
    try:
        place = objects_at(whole_url(given))
        folder = place.folder
        if folder is not None:
            _check_folder(named, folder, out, apart)
        check_copies()
        _check_written(place, lasting=lasting)
        confirm_store(given)
    except StoreLost as error:
        raise error.at(named) from None


def _check_place(given: str, named: str, scheme: str) -> None:
    """Raise InputError for a URL that names no folder or bucket, or names one as no file system does."""
    place = given.partition("://")[2]
    if scheme in LOCAL:
        if not place.strip("/"):
            raise InputError("store.no_folder_name", file=named)
        if escaped := ESCAPED.search(place):
            raise InputError("store.escaped", text=escaped[0], file=named)
    elif not urlsplit(given).netloc:
        raise InputError("store.no_bucket_name", file=named)


def _check_folder(named: str, folder: Path, out: Path, apart: Sequence[Path]) -> None:
    """Raise InputError for a folder on this machine that holds something else, or cannot be made."""
    if folder.exists() and not folder.is_dir():
        raise InputError("store.is_a_file", file=named)
    place = Path(os.path.realpath(folder))
    for other, what in ((out, "result"), *((p, "input") for p in apart)):
        at = Path(os.path.realpath(other))
        inside = at == place or at in place.parents if at.is_dir() or other == out else at.parent == place
        if inside:
            raise InputError("store.not_separate", kind=what, place=str(other), file=named)
    try:
        folder.mkdir(parents=True, exist_ok=True)
    except OSError as error:
        raise InputError("store.not_writable", detail=error.strerror or str(error), file=named) from None
    probe = folder / f".probe.{secrets.token_hex(4)}"
    try:
        probe.write_bytes(b"")
        probe.unlink()
    except OSError as error:
        raise InputError("store.not_writable", detail=error.strerror or str(error), file=named) from None


def _check_written(place: Objects, *, lasting: bool) -> None:
    """Write what the place is known by; raises StoreLost, InputError."""
    if lasting:
        place.check()
        return
    probe = Objects(f"{place.url}/probe-{secrets.token_hex(8)}")
    probe.check()
    probe.clear()
