"""Public sets of photographs: what is known of them, and how they are fetched, file by file and by check sum."""

from __future__ import annotations

import hashlib
import re
import urllib.error
import urllib.request
from collections.abc import Mapping
from dataclasses import dataclass
from http.client import HTTPException
from importlib.resources import files
from pathlib import Path
from typing import Any
from urllib.parse import quote, urlsplit

from raybundle.errors import InputError
from raybundle.io.ids import repeated
from raybundle.io.reading.trees import Json, read_toml, toml_of
from raybundle.io.reading.words import quoted
from raybundle.numerics.progress import Progress, silent

TIMEOUT_S = 30.0
CHUNK_BYTES = 1 << 18
LARGEST = 1 << 40
"""Bytes of a file, beyond which a listing is wrong."""
DIGEST = re.compile("[0-9a-f]{64}")


@dataclass(frozen=True, slots=True, kw_only=True)
class SetFile:
    """One file of a set."""

    path: str
    """below the set's folder, with /"""
    size: int
    """bytes"""
    sha256: str


@dataclass(frozen=True, slots=True, kw_only=True)
class Dataset:
    """A public set; it is fetched from its source, never from us."""

    name: str
    about: str
    source: str
    base: str
    """address of the folder in which its files stand, at one commit"""
    licence: str
    cite: str
    files: tuple[SetFile, ...]

    @property
    def size(self) -> int:
        """Bytes of all files."""
        return sum(f.size for f in self.files)


@dataclass(frozen=True, slots=True, kw_only=True)
class Fetched:
    """What a fetch did."""

    folder: Path
    there: int
    """files that were there already"""
    fetched: int


def known_datasets(listing: Path | None = None) -> Mapping[str, Dataset]:
    """The sets by their names: those of the package, or those that a file lists in the same manner.

    raises  InputError for a listing that is none, with the place
    """
    if listing is None:
        here = Path("datasets.toml")
        content = toml_of((files("raybundle.io") / here).read_text(encoding="utf-8"), here)
    else:
        content = read_toml(listing)
    return {name: _dataset(name, entry) for name, entry in content.tree().mapping().items()}


def _dataset(name: str, entry: Json) -> Dataset:
    folders = [part for part in _parts(name) if part in {"", ".", ".."}]
    if folders or len(_parts(name)) > 1:
        entry.fail("dataset.name", name=quoted(name))
    about, source, base, licence = (entry.get(key).text() for key in ("about", "source", "base", "licence"))
    if not _is_address(base):
        entry.get("base").fail("dataset.address", address=quoted(base))
    listed = tuple(_file(item) for item in entry.get("files").items())
    if len({f.path for f in listed}) < len(listed):
        entry.get("files").fail("name.twice", kind="file", name=quoted(repeated(f.path for f in listed)))
    cite = entry.get("cite").text() if entry.has("cite") else ""
    return Dataset(name=name, about=about, source=source, base=base, licence=licence, cite=cite, files=listed)


def _is_address(base: str) -> bool:
    """Whether a text is the address of a folder."""
    try:
        parts = urlsplit(base)
        port = parts.port  # which it looks at only here
    except ValueError:
        return False
    whole = bool(parts.hostname) and not re.search(r"\][^:]", parts.netloc)
    return parts.scheme in {"http", "https"} and whole and port != 0 and base.endswith("/")


def _file(item: Json) -> SetFile:
    """[path, bytes, SHA-256]; what is fetched stays below the folder that it is fetched to."""
    parts = item.items()
    if len(parts) != 3:
        item.fail("dataset.file_entry")
    path, digest = parts[0].text(), parts[2].text()
    if any(part in {"", ".", ".."} for part in _parts(path)):
        parts[0].fail("dataset.path_outside", path=quoted(path))
    if not DIGEST.fullmatch(digest):
        parts[2].fail("dataset.no_sha256", value=quoted(digest))
    return SetFile(path=path, size=parts[1].whole(1, LARGEST), sha256=digest)


def _parts(path: str) -> list[str]:
    return re.split(r"[/\\:]", path)


def dataset(name: str, listing: Path | None = None) -> Dataset:
    """A set by its name; raises InputError with the names that there are."""
    known = known_datasets(listing)
    if name not in known:
        raise InputError("dataset.unknown", name=name, known=list(known))
    return known[name]


def fetch(wanted: Dataset, folder: Path, *, progress: Progress = silent) -> Fetched:
    """Bring a set into a folder; what is there and right is kept, what was begun is continued.

    raises  InputError without a network, where nothing can be written, or where a file differs from its check sum
    A file gets its name when it is complete and its SHA-256 is right; until then it is called NAME.part.
    """
    there = done = 0
    for file in wanted.files:
        target = folder / file.path
        try:
            if _is_right(target, file):
                there += 1
            else:
                target.parent.mkdir(parents=True, exist_ok=True)
                _fetch_file(
                    wanted, file, target, lambda n, before=done: progress("fetching", (before + n) / wanted.size)
                )
        except OSError as error:
            detail = error.strerror or str(error)
            raise InputError("file.not_writable", detail=detail, refused=False, file=target) from None
        done += file.size
        progress("fetching", done / wanted.size)
    return Fetched(folder=folder, there=there, fetched=len(wanted.files) - there)


def _is_right(path: Path, file: SetFile) -> bool:
    return path.is_file() and path.stat().st_size == file.size and _digest(path) == file.sha256


def _digest(path: Path) -> str:
    with path.open("rb") as opened:
        return hashlib.file_digest(opened, "sha256").hexdigest()


def _fetch_file(wanted: Dataset, file: SetFile, target: Path, notify: Any) -> None:
    """One file, continued where an earlier run stopped, and once more from its beginning where that does not fit."""
    part = target.with_name(f"{target.name}.part")
    address = wanted.base + quote(file.path)
    continued = part.exists() and 0 < part.stat().st_size <= file.size
    if continued:
        _receive(address, part, file.size, notify)
    if not continued or not _is_right(part, file):
        part.unlink(missing_ok=True)
        _receive(address, part, file.size, notify)
    if not _is_right(part, file):
        found, size = _digest(part), part.stat().st_size
        part.unlink()
        raise InputError(
            "dataset.checksum", size_bytes=size, sha256=found[:12], expected_bytes=file.size,
            expected_sha256=file.sha256[:12], source=wanted.source, file=address,
        )  # fmt: skip
    part.replace(target)


def _receive(address: str, part: Path, size: int, notify: Any) -> None:
    """Append to `part` what of the address is missing, never more than `size` bytes and one."""
    have = part.stat().st_size if part.exists() else 0
    if have == size:
        return
    # not compressed: lengths and positions are those of the file
    request = urllib.request.Request(address, headers={"Accept-Encoding": "identity", "User-Agent": "raybundle"})  # noqa: S310
    if have:
        request.add_header("Range", f"bytes={have}-")
    answer = _asked(request)
    with answer:
        have = have if answer.status == 206 else 0
        with part.open("ab" if have else "wb") as file:
            while have <= size:
                try:
                    data = answer.read(min(CHUNK_BYTES, size + 1 - have))
                except (OSError, ValueError, HTTPException) as error:
                    raise _broken(address, error) from None
                if not data:
                    break
                file.write(data)
                have += len(data)
                notify(have)
    if have < size:
        raise InputError("dataset.connection_ended", received_bytes=have, size_bytes=size, file=address)


def _asked(request: urllib.request.Request) -> Any:
    address = request.full_url
    try:
        return urllib.request.urlopen(request, timeout=TIMEOUT_S)  # noqa: S310  (addresses are those of datasets.toml)
    except urllib.error.HTTPError as error:
        error.close()
        if error.code == 416:  # what is there is longer than what is offered
            return _asked(urllib.request.Request(address, headers={"User-Agent": "raybundle"}))  # noqa: S310
        busy = error.code in {429, 500, 502, 503, 504}
        raise InputError(
            "dataset.server_answer", status=str(error.code), detail=str(error.reason), busy=busy, file=address
        ) from None
    except (OSError, ValueError, HTTPException) as error:
        host, detail = str(urlsplit(address).hostname), str(getattr(error, "reason", error))
        raise InputError("dataset.no_connection", host=host, detail=detail, file=address) from None


def _broken(address: str, why: object) -> InputError:
    return InputError("dataset.connection_broken", detail=str(why), file=address)
