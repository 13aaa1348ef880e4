"""Photographs at URLs: listed, and read from copies on this machine.

A path that was a URL shows it without its second slash (https:/host/a.jpg), and is no file.  What reads it gets a copy
under what the service knows the content by (ETag, time, length), so that content that has changed is another copy.
Copies are bounded with those of products, and go when they were not used for longest (`raybundle.io.copies`).
"""

from __future__ import annotations

import hashlib
import re
import time
from collections.abc import Callable
from pathlib import Path
from typing import Any, TypeVar
from urllib.parse import urljoin

from raybundle.errors import InputError

T = TypeVar("T")
_URL = re.compile(r"([a-z][a-z0-9]+):/+(?=[^/])")
UTF16 = (b"\xff\xfe", b"\xfe\xff")
"""First bytes of such a file"""
LISTS = {".txt", ".list"}
"""Ends of files that hold names of photographs, one a line"""
GONE = {404, 410}
"""Answers of http that nothing is there"""
KNOWN_BY = ("ETag", "etag", "e_tag", "LastModified", "last_modified", "Last-Modified", "mtime", "md5Hash", "size")
"""What services state of an object that is another when its content is"""


def url_of(path: Path) -> str:
    """The URL that a path was; empty: it is one of this machine."""
    text = path.as_posix()
    found = _URL.match(text)
    return f"{found[1]}://{text[found.end() :]}" if found and found[1] not in {"file", "local"} else ""


def local_path(path: Path) -> Path:
    """The path of a URL of this machine (file:///folder); others as they are."""
    text = path.as_posix()
    found = _URL.match(text)
    return Path(f"/{text[found.end() :]}") if found and found[1] in {"file", "local"} else path


def remote_files(path: Path) -> list[Path] | None:
    """Files in a folder at a URL, or those that a list there names; None: it is a file itself.

    raises  InputError where it cannot be reached
    """
    from raybundle.io.photos.container import SUFFIXES

    url = url_of(path)
    if path.suffix.lower() in LISTS:
        data = _tried(url, lambda fs, place: bytes(fs.cat_file(place)))
        try:
            text = data.decode("utf-8-sig")
        except UnicodeDecodeError as error:
            raise InputError("file.not_utf8", byte=error.start + 1, utf16=data[:2] in UTF16, file=url) from None
        lines = (line.strip() for line in text.splitlines())
        names = [line for line in lines if line and not line.startswith("#")]
        return [Path(n if _URL.match(n) else _beside(url, n)) for n in names]
    if path.suffix.lower() in SUFFIXES:
        return None
    found = _tried(url, lambda fs, place: [str(p) for p in fs.ls(f"{place}/", detail=False)])
    ours = (p for p in found if "://" not in p or p.startswith(url))  # a page may link others
    return sorted(path / name for name in {p.rpartition("/")[2] for p in ours} if name)


def _beside(url: str, name: str) -> str:
    """A name in a list, from the list's own place."""
    scheme, _, rest = url.partition("://")  # protocols that urljoin does not know
    return f"{scheme}://" + urljoin(f"http://{rest}", name).removeprefix("http://")


def at_hand(path: Path, use: Callable[[Path], T]) -> T:
    """Read a file by a function of its path; what lies at a URL by the path of its copy.

    raises  InputError as the function, or where what lies at a URL cannot be got after three attempts
    """
    if not url_of(path):
        return use(path)
    for last in (False, False, True):
        file = _copy(path)
        try:
            return use(file)
        except (InputError, OSError) as error:
            if not file.exists() and not last:  # others needed its room
                continue
            if isinstance(error, InputError) and error.file == str(file):
                error.file = str(path)
            raise
    raise AssertionError


def _copy(path: Path) -> Path:
    """The copy of a file at a URL."""
    from raybundle.io.copies import Copies, copies_folder

    url, copies = url_of(path), Copies(copies_folder(), "photographs", path.suffix.lower())
    about = _tried(url, lambda fs, place: fs.info(place))
    size = about.get("size")
    known = "\n".join((url, *(f"{name} {about[name]}" for name in KNOWN_BY if name in about)))
    key = hashlib.sha256(known.encode()).hexdigest()
    found = copies.find(key)
    if found is not None:
        return found

    def get(here: Path) -> None:
        def got(fs: Any, place: str) -> None:
            fs.get_file(place, str(here))
            if size is not None and here.stat().st_size != size:
                raise ConnectionError(f"{here.stat().st_size} of {size} bytes came")

        _tried(url, got)

    return copies.make(key, int(size or 0), get, lambda _: None)


def _tried(url: str, what: Callable[[Any, str], T]) -> T:
    """Ask for something at a URL, after a pause again where it fails; raises InputError."""
    from raybundle.io.object_urls import PAUSE_S, SCHEMES, TRIES, WEB, opened, reason

    if "::" in url or url.partition("://")[0] not in SCHEMES | WEB:
        raise InputError("photograph.unknown_scheme", known=sorted((SCHEMES | WEB) - {"memory", "local"}), file=url)
    for attempt in range(TRIES):
        try:
            return what(*opened(url))
        except InputError:
            raise
        except Exception as error:  # noqa: BLE001  (each service has its own)
            if _missing(error):
                raise InputError("file.missing", file=url) from None
            if attempt + 1 == TRIES:
                raise InputError(
                    "photograph.not_fetched", n=TRIES, detail=reason(error.__cause__ or error), file=url
                ) from None
            time.sleep(PAUSE_S * 2**attempt)
    raise AssertionError


def _missing(error: Exception) -> bool:
    """Whether a service knows that nothing is there: by http whatever fails is no file, and its cause states more."""
    if not isinstance(error, FileNotFoundError | IsADirectoryError | NotADirectoryError):
        return False
    cause = error.__cause__
    return cause is None or not type(cause).__module__.startswith("aiohttp") or getattr(cause, "status", 0) in GONE
