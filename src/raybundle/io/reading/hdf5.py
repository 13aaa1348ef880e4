"""HDF5 as a tree of elements, as `xml` reads XML: below a group its members and attributes, below a dataset the latter.

h5py reads it; it is an extra, and loaded where a file is one.  An element is read when its parent is asked for it.
Links to other files are not followed, nor are tables that are stored in other files.
"""

from __future__ import annotations

import struct
from collections.abc import Generator, Iterator
from contextlib import contextmanager
from dataclasses import dataclass
from importlib import import_module
from math import prod
from pathlib import Path
from typing import Any, NoReturn

import numpy as np

from raybundle.errors import InputError, Message, Value, content
from raybundle.io.reading.files import opened
from raybundle.io.reading.words import SHOWN, bounded, no_number
from raybundle.io.reading.xml import Attributes, Element
from raybundle.numerics.arrays import Array

SIGNATURE = b"\x89HDF\r\n\x1a\n"
MOST = 1 << 22
"""Values of a table that is read at once: the coordinates of a grid are some 10^5"""
HEAP = b"GCOL"
WORDS = 1 << 12
"""Values that are also read as words"""
PACKAGE = "h5py"


@dataclass(slots=True)
class Node(Element):
    """A group, a dataset or an attribute; `children` stays empty."""

    data: Any = None
    """Group or dataset of h5py, None of an attribute"""
    values: Any = None
    """NumPy array of a dataset or an attribute"""

    def fail(self, code: str | Message, /, **values: Value) -> NoReturn:
        """Raise at this element: HDF5 has no lines."""
        raise InputError(content(code, values), file=self.file, column=self.name)

    def all(self, name: str) -> Iterator[Element]:
        """The member or the attribute of this name."""
        found = self.node(name)
        if found is not None:
            yield found

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
        if values is None or np.asarray(values).dtype.kind not in "fiu":
            self.fail(no_number(self.content[:SHOWN]))
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
        if len(values) % columns or (columns > 1 and found.shape[-1] != columns):
            found.fail("value.count", n=found.shape[-1], needed=columns)
        return values.reshape(-1, columns) if columns > 1 else values

    def _child(self, name: str) -> Node | None:
        with _guarded(self.file):
            data = self.data
            if data is None:
                return None
            kind = data.get(name, getlink=True) if hasattr(data, "keys") and name in data else None
            if kind is not None and type(kind).__name__ == "HardLink":
                return _node(self.file, name, data[name])
            return _node(self.file, name, np.asarray(data.attrs[name])) if name in data.attrs else None


def _node(path: Path, name: str, data: Any) -> Node:
    values: Any = data if isinstance(data, np.ndarray) else None
    if not isinstance(data, np.ndarray) and hasattr(data, "dtype"):
        stored = data.size is not None and data.size <= MOST and not data.external and not data.is_virtual
        if stored and data.dtype.kind == "O":
            _check_heap(path, data)
        values = np.asarray(data[()]) if stored and data.dtype.kind in "fiubSOU" else None
    words = "" if values is None or values.size > WORDS else " ".join(map(_word, values.ravel().tolist()))
    return Node(path, 0, name, Attributes({}), content=words, data=None if values is data else data, values=values)


def _word(value: Any) -> str:
    text = value.decode("utf-8", "replace") if isinstance(value, bytes) else str(value)
    return text.partition("\0")[0].strip()


def _check_heap(path: Path, data: Any) -> None:
    """Refuse heaps of texts whose objects do not fill them: the library of HDF5 reads such a one without end."""
    at = data.id.get_offset()
    if at is None:
        return
    with opened(path) as file:
        file.seek(at)
        for _, address, _ in struct.iter_unpack("<IQI", file.read(16 * data.size)):
            file.seek(min(address, 1 << 62))
            head = file.read(16)
            size = int.from_bytes(head[8:], "little") - len(head)
            heap = file.read(min(max(size, 0), MOST))
            k = 0
            while head[:4] == HEAP and len(heap) - k >= len(head):
                index, n = struct.unpack_from("<H6xQ", heap, k)
                step = n if index == 0 else len(head) + n + -n % 8
                if not len(head) <= step <= len(heap) - k:
                    raise ValueError("heap of texts")
                k += step


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
