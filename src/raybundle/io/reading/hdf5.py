"""HDF5 as a tree of elements, as `xml` reads XML: below a group its members and attributes, below a dataset the latter.

h5py reads it; it is an extra, and loaded where a file is one.  An element is read when its parent is asked for it.
Links to other files are not followed, nor are tables that are stored in other files.
"""

from __future__ import annotations

import struct
from collections.abc import Callable, Generator, Iterator
from contextlib import contextmanager
from dataclasses import dataclass
from functools import lru_cache
from importlib import import_module
from math import prod
from mmap import ACCESS_READ, mmap
from pathlib import Path
from typing import Any, NoReturn

import numpy as np

from raybundle.errors import InputError, Message, Value, content
from raybundle.io.reading.files import opened
from raybundle.io.reading.words import SHOWN, bounded, no_number, quoted
from raybundle.io.reading.xml import Attributes, Element
from raybundle.numerics.arrays import Array

SIGNATURE = b"\x89HDF\r\n\x1a\n"
MOST_BYTES = 1 << 26
"""Of a table that is read at once, and of a chunk of it: the coordinates of a grid are some MB"""
HEAP = b"GCOL\x01"
OBJECT = 16
"""Bytes of the head of a heap, and of an object in it"""
MOST_OBJECTS = 1 << 24
WORDS = 1 << 12
"""Values that are also read as words"""
PACKAGE = "h5py"


@dataclass(slots=True)
class Node(Element):
    """A group, a dataset or an attribute; `children` stays empty."""

    data: Any = None
    """Group, dataset or named type of h5py, None of an attribute"""
    values: Any = None
    """NumPy array of a dataset or an attribute"""
    size_bytes: int = 0
    """Of these, whether they are read or not"""

    def fail(self, code: str | Message, /, **values: Value) -> NoReturn:
        """Raise at this element: HDF5 has no lines."""
        raise InputError(content(code, values), file=self.file, column=self.name)

    def all(self, name: str) -> Iterator[Element]:
        """The member or the attribute of this name; raises InputError where it is too large to be read."""
        found = self.node(name)
        if found is not None:
            found.check_size()
            yield found

    def check_size(self) -> None:
        """Refuse values that were not read."""
        if self.size_bytes > MOST_BYTES:
            self.fail("value.table_too_large", size_bytes=self.size_bytes, limit_bytes=MOST_BYTES)

    def node(self, *names: str) -> Node | None:
        """The element down this way of names."""
        child = self._child(names[0]) if names else self
        return child if child is None or not names else child.node(*names[1:])

    @property
    def shape(self) -> tuple[int, ...]:
        """Of a dataset, whether its values are read or not; (0,) of anything else."""
        return tuple(getattr(self.data, "shape", None) or np.shape(self.values) or (0,))

    def numbers(self, count: int) -> Array:
        """(count,) finite numbers, in the order of the file."""
        values = self.values
        self.check_size()
        if values is None or np.asarray(values).dtype.kind not in "fiu":
            kind = type(values if self.data is None else self.data).__name__
            self.fail("value.not_a_number", value=quoted(self.content[:SHOWN] or kind))
        found = bounded(np.array(values, float).ravel())
        if found is None or not np.isfinite(found).all():
            self.fail(no_number("nan" if found is not None else "inf"))
        if len(found) != count:
            self.fail("value.count", n=len(found), needed=count)
        return found

    def table(self, *names: str, columns: int = 1) -> Array:
        """(n, columns) numbers of an element below; (n,) of one column."""
        found = self.node(*names)
        if found is None:
            self.fail("xml.element_missing", path="/".join(names))
        values = found.numbers(prod(found.shape))
        if not len(values) or len(values) % columns or (columns > 1 and found.shape[-1] != columns):
            found.fail("value.count", n=found.shape[-1] if len(values) else 0, needed=columns)
        return values.reshape(-1, columns) if columns > 1 else values

    def _child(self, name: str) -> Node | None:
        with _guarded(self.file):
            data = self.data
            if data is None:
                return None
            kind = data.get(name, getlink=True) if hasattr(data, "keys") and name in data else None
            if kind is not None and type(kind).__name__ == "HardLink":
                found = data[name]
                return _node(self.file, name, found, lambda: found[()])
            if name not in data.attrs:
                return None
            node = _node(self.file, name, data.attrs.get_id(name), lambda: data.attrs[name])
            node.data = None
            return node


def _node(path: Path, name: str, data: Any, read: Callable[[], Any]) -> Node:
    """A group, a named type, or a dataset or an attribute (`AttrID`), of which `read` reads the values."""
    node = Node(path, 0, name, Attributes({}), data=data)
    kind = getattr(data, "dtype", None)
    if kind is None or not hasattr(data, "shape") or data.shape is None or kind.kind not in "fiubSOU":
        return node
    if getattr(data, "external", None) or getattr(data, "is_virtual", False):
        return node
    if kind.kind == "O":
        if import_module(PACKAGE).check_string_dtype(kind) is None:  # references, lists
            return node
        found = path.stat()
        _check_heaps(path, found.st_size, found.st_mtime_ns)
    node.size_bytes = max(prod(data.shape), prod(getattr(data, "chunks", None) or (0,))) * kind.itemsize
    if node.size_bytes <= MOST_BYTES:
        node.values = np.asarray(read())
        if node.values.size <= WORDS:
            node.content = " ".join(map(_word, node.values.ravel().tolist()))
    return node


def _word(value: Any) -> str:
    text = value.decode("utf-8", "replace") if isinstance(value, bytes) else str(value)
    return text.partition("\0")[0].strip()


@lru_cache(maxsize=8)
def _check_heaps(path: Path, size: int, changed_ns: int) -> None:
    """Refuse a file with a heap of texts whose objects do not fill it: the library of HDF5 reads it without end.

    size, changed_ns  of the file: it is checked once
    """
    del changed_ns
    objects = 0
    with opened(path) as file, mmap(file.fileno(), 0, access=ACCESS_READ) as data:
        at = data.find(HEAP)
        while at >= 0:
            end = at + (struct.unpack_from("<Q", data, at + 8)[0] if size - at >= OBJECT else size)
            k = at + OBJECT
            while end <= size and k + OBJECT <= end:  # the library reads no other
                index, n = struct.unpack_from("<H6xQ", data, k)
                step = n if index == 0 else OBJECT + n + -n % 8
                objects += 1
                if not OBJECT <= step <= end - k or objects > MOST_OBJECTS:
                    raise ValueError("heap of texts")
                k += step
            at = data.find(HEAP, at + 1)


@contextmanager
def _guarded(path: Path) -> Generator[None]:
    """Give what h5py raises for a damaged file the file's name."""
    try:
        yield
    except InputError:
        raise
    except Exception as error:  # noqa: BLE001  (h5py promises no kind)
        detail = str(error).splitlines()[0][:SHOWN] if str(error) else type(error).__name__
        raise InputError("file.hdf5_damaged", detail=detail, file=path) from None


@contextmanager
def hdf5_root(path: Path) -> Generator[Node]:
    """The root group of a file, open within; raises InputError where h5py is missing or the file is damaged."""
    try:
        h5py = import_module(PACKAGE)
    except ImportError:
        raise InputError("package.h5py_missing", file=path) from None
    with _guarded(path):
        file = h5py.File(path, "r")
    try:
        yield Node(path, 0, "/", Attributes({}), data=file)
    finally:
        file.close()


def hdf5_names(path: Path, head: bytes) -> frozenset[str]:
    """Names of members and attributes of the root group; none of another file, or without h5py."""
    if not head.startswith(SIGNATURE):
        return frozenset()
    try:
        with hdf5_root(path) as root, _guarded(path):
            return frozenset({*root.data.keys(), *root.data.attrs.keys()})
    except InputError:
        return frozenset()
