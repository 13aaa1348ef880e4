"""Products in an object store.

    URL/KIND/KEY.npz  a product: the same bytes as in a folder, with their check sums
    URL/token         what the store is known by
    URL/tasks.jsonl   tasks for shards

An object is there when it is whole: that is how these stores work; elsewhere (file://) it is written beside its place
and renamed.  Whatever fails is tried three times.  Arrays are mapped from copies on this machine (`copies`).
"""

from __future__ import annotations

import re
import secrets
import time
import uuid
from collections.abc import Callable, Sequence
from contextlib import suppress
from dataclasses import dataclass, field
from functools import lru_cache
from pathlib import Path
from threading import Lock
from typing import Any, TypeVar
from urllib.parse import urlsplit

from raybundle.errors import InputError, Message, message
from raybundle.io.copies import FULL, Copies, StoreLost, copies_folder
from raybundle.io.object_urls import APPEARS_WHOLE, PAUSE_S, REFUSED, SCHEMES, TRIES, WEB, opened, reason
from raybundle.pipeline.archives import write_archive
from raybundle.pipeline.place import FileMark, Product, kind_of

ONE_BY_ONE = 8
"""Products that are asked for one by one; of more the store lists all of their kind, a thousand a request."""
HEADS = 512
"""Bytes that an archive takes beside its arrays, for each of them, about."""
TOKEN, TOKENS = "token", re.compile(r"[0-9a-f]{32}")
OURS = re.compile(r"[A-Za-z0-9_ -]+-[0-9a-f]{40}\.npz|\.[A-Za-z0-9_. -]+\.[0-9a-f]{8}|token|tasks\.jsonl")
"""Names of what is kept in a store."""

T = TypeVar("T")


class _Removed(Exception):
    """Another process removed an object while this one was getting it."""


@dataclass(slots=True)
class Objects:
    """Where products lie: at a URL that fsspec understands."""

    url: str
    _opened: tuple[Any, str] | None = None
    """file system, and the path of the URL in it"""
    _copies: Copies | None = None
    _lock: Lock = field(default_factory=Lock)

    @property
    def name(self) -> str:
        """The URL."""
        return self.url

    @property
    def shared(self) -> bool:
        """What lies in the memory of a process is its own."""
        return not self.url.startswith("memory://")

    @property
    def folder(self) -> Path | None:
        """The folder of this machine in which it is; None: it is none."""
        fs, root = self._open()
        return Path(root) if "file" in ([fs.protocol] if isinstance(fs.protocol, str) else fs.protocol) else None

    def check(self) -> None:
        """By the token, which is written where there is none."""
        self._copies_here(begin=True)

    def has(self, key: str) -> bool:
        """Whether an object is there; its length was compared when it was sent."""
        fs, path = self._fs(), self._path(key)
        return self._tried(lambda: _exists(fs, path))

    def those(self, keys: Sequence[str]) -> set[str]:
        """Those that are there: by lists where they are many."""
        kinds: dict[str, list[str]] = {}
        for key in keys:
            kinds.setdefault(kind_of(key), []).append(key)
        found = set[str]()
        for kind, wanted in kinds.items():
            if len(wanted) <= ONE_BY_ONE:
                found |= {key for key in wanted if self.has(key)}
            else:
                found |= {*wanted} & {*self.keys_of_kind(kind)}
        return found

    def file(self, key: str) -> Path | None:
        """The copy on this machine, got where there is none."""
        copies = self._copies_here(begin=False)
        if copies is None:
            return None
        found = copies.find(key)
        if found is not None:
            return found
        fs, path = self._fs(), self._path(key)
        try:
            size = self._tried(lambda: int(fs.info(path)["size"]))
            return copies.make(key, size, lambda here: self._get(fs, path, size, here), lambda _: None)
        except (FileNotFoundError, _Removed):
            return None

    def _get(self, fs: Any, path: str, size: int, here: Path) -> None:
        def get() -> None:
            fs.get_file(path, str(here))
            found = here.stat().st_size
            if found == size:
                return
            fs.invalidate_cache()
            now = int(fs.info(path)["size"])  # another process may have replaced it
            if found != now:
                raise ConnectionError(f"{found} of {now} bytes came")

        for last in (False, False, True):
            try:
                self._tried(get, writes_here=True)
            except FileNotFoundError:
                if not self._tried(lambda: _exists(fs, path)):
                    raise _Removed from None
                if last or not here.parent.is_dir():
                    raise  # the folder of copies is gone
            else:
                return

    def damaged(self, key: str, again: bool, which: FileMark | None) -> None:  # noqa: FBT001
        """Remove the copy; where it was got anew and is damaged again, the object."""
        del which  # a good copy that goes with it is got once more
        if self._copies is not None:
            self._copies.forget(key)
        if again:
            self.forget(key)

    def keep(self, key: str, product: Product) -> None:
        """Send a product, and keep the copy: it will be read."""
        copies = self._copies_here(begin=True)
        assert copies is not None
        size = sum(values.nbytes + HEADS for values in product.values())

        def write(here: Path) -> None:
            with here.open("wb") as file:
                write_archive(file, product)

        copies.make(key, size, write, lambda here: self._put_file(here, self._path(key)))

    def _put_file(self, here: Path, path: str) -> None:
        fs = self._fs()
        self._put(lambda to: fs.put_file(str(here), to), path, here.stat().st_size)

    def _put(self, send: Callable[[str], None], path: str, size: int) -> None:
        """Send something; nobody sees it before all of it is there."""
        fs = self._fs()

        def put() -> None:
            if self._appears_whole:
                send(path)
                _check_length(fs, path, size)
                return
            if fs.isdir(path):
                raise InputError("store.occupied", place=path)
            folder, _, name = path.rpartition("/")
            beside = f"{folder}/.{name}.{uuid.uuid4().hex[:8]}"
            fs.makedirs(folder, exist_ok=True)
            try:
                send(beside)
                _check_length(fs, beside, size)
                fs.mv(beside, path)
            except BaseException:
                with suppress(Exception):
                    fs.rm_file(beside)
                raise

        try:
            self._tried(put)
        except FileNotFoundError:
            raise StoreLost(
                "store.no_bucket",
                file=self.url,
            ) from None

    @property
    def _appears_whole(self) -> bool:
        return urlsplit(self.url).scheme in APPEARS_WHOLE

    def keys_of_kind(self, kind: str) -> list[str]:
        """By the names of the objects."""
        fs, path = self._fs(), f"{self._root()}/{kind}"

        def listed() -> list[str]:
            fs.invalidate_cache()
            return fs.ls(path, detail=False)

        try:
            names = [n.rstrip("/").rpartition("/")[2] for n in self._tried(listed)]
        except (FileNotFoundError, NotADirectoryError):
            return []
        return sorted(n.removesuffix(".npz") for n in names if n.endswith(".npz") and OURS.fullmatch(n))

    def forget(self, *keys: str) -> None:
        """Remove copies and objects."""
        copies = self._copies_here(begin=False)
        if copies is not None:
            for key in keys:
                copies.forget(key)
        self._remove([self._path(key) for key in keys])

    def _remove(self, paths: Sequence[str]) -> None:
        """Remove objects, a thousand a request where the service can."""
        fs = self._fs()

        def remove() -> None:
            if len(paths) == 1:
                fs.rm_file(paths[0])
            elif paths:
                fs.rm(list(paths))

        with suppress(FileNotFoundError, IsADirectoryError):
            self._tried(remove)

    def text(self, name: str) -> str | None:
        """An object that is a text."""
        fs, path = self._fs(), f"{self._root()}/{name}"
        try:
            return self._tried(lambda: bytes(fs.cat_file(path))).decode("utf-8", "replace")
        except FileNotFoundError:
            return None

    def keep_text(self, name: str, text: str) -> str:
        """Send a text."""
        fs, data = self._fs(), text.encode("utf-8", "replace")
        self._put(lambda to: fs.pipe_file(to, data), f"{self._root()}/{name}", len(data))
        return f"{self.url}/{name}"

    def forget_text(self, name: str) -> None:
        """Remove a text."""
        self._remove([f"{self._root()}/{name}"])

    def clear(self) -> None:
        """Remove the objects that are ours, and no others, with their copies."""
        fs, root = self._fs(), self._root()
        copies = self._copies_here(begin=False)
        if copies is not None:
            copies.clear()
        with suppress(FileNotFoundError):
            self._remove([p for p in self._tried(lambda: fs.find(root)) if OURS.fullmatch(p.rpartition("/")[2])])
        with suppress(Exception):  # elsewhere than in object stores folders are left
            if not self._appears_whole and not fs.find(root):
                fs.rm(root, recursive=True)
        self._copies = None

    def _path(self, key: str) -> str:
        return f"{self._root()}/{kind_of(key)}/{key}.npz"

    def _root(self) -> str:
        return self._open()[1]

    def _fs(self) -> Any:
        return self._open()[0]

    def _open(self) -> tuple[Any, str]:
        """The file system; raises InputError where there is none for this URL."""
        with self._lock:
            if self._opened is None:
                self._opened = opened(self.url)
            return self._opened

    def _copies_here(self, *, begin: bool) -> Copies | None:
        """Copies on this machine; None where there is nothing yet and nothing is to `begin`."""
        if self._copies is None:
            token = self.text(TOKEN)
            if token is None and begin:
                token = secrets.token_hex(16)
                self.keep_text(TOKEN, token)
                token = self.text(TOKEN)  # another process may have begun at the same time
            if token is None:
                return None
            if not TOKENS.fullmatch(token):
                raise InputError("store.foreign_token", file=self.url)
            self._copies = Copies(copies_folder(), token)
        return self._copies

    def _tried(self, what: Callable[[], T], *, writes_here: bool = False) -> T:
        """Do something, after a pause again where it fails; raises StoreLost, FileNotFoundError.

        writes_here  a full disk is that of the copies, which make room
        """
        for attempt in range(TRIES):
            try:
                return what()
            except (FileNotFoundError, IsADirectoryError, NotADirectoryError, InputError):
                raise
            except Exception as error:  # each service has its own
                if writes_here and isinstance(error, OSError) and error.errno in FULL:
                    raise
                if attempt + 1 == TRIES:
                    raise self._lost(error) from None
                time.sleep(PAUSE_S * 2**attempt)
        raise AssertionError

    def _lost(self, error: Exception) -> StoreLost:
        """What is wrong, and what to do."""
        found = reason(error)
        if isinstance(error, PermissionError) or REFUSED.search(f"{type(error).__name__} {found}"):
            cause = "refused"
        elif isinstance(error, OSError) and error.errno in FULL:
            cause = "full"
        else:
            cause = "other"
        return StoreLost("store.lost", cause=cause, n=TRIES, detail=found, file=self.url)


def _exists(fs: Any, path: str) -> bool:
    """Whether an object is there; what else goes wrong than that it is not is raised."""
    fs.invalidate_cache()
    try:
        return fs.info(path)["type"] == "file"
    except FileNotFoundError:
        return False


def _check_length(fs: Any, path: str, size: int) -> None:
    """Raise ConnectionError where not all of an object came."""
    fs.invalidate_cache()
    there = int(fs.info(path)["size"])
    if there != size:
        raise ConnectionError(f"{there} of {size} bytes came there")


def shown_url(url: str) -> str:
    """A URL as it may be shown: without a secret."""
    try:
        parts = urlsplit(url)
        return parts._replace(netloc=parts.hostname or "").geturl() if parts.password else url
    except ValueError:
        return url


def refused_url(url: str) -> Message | None:
    """Why a URL can be no store, by its text alone; None: it can."""
    scheme = url.partition("://")[0]
    if "::" in url:
        return message("store.chained")
    if scheme in WEB:
        return message("store.web_page", scheme=scheme)
    if scheme not in SCHEMES:
        return message("store.unknown_scheme", scheme=scheme, known=sorted(SCHEMES - {"memory", "local"}))
    return None


@lru_cache
def objects_at(url: str) -> Objects:
    """The place at a URL, the same one for all stores of this process."""
    if "://" not in url:
        raise InputError("store.no_url", file=url)
    refusal = refused_url(url)
    if refusal:
        raise InputError(refusal, file=shown_url(url))
    return Objects(url.rstrip("/") if not url.endswith("://") else url)
