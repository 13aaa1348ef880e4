"""Bytes, text and lines of a file, bounded before anything is allocated."""

from __future__ import annotations

import codecs
import errno
import lzma
import os
import re
import stat
import struct
import zipfile
import zlib
from collections.abc import Generator, Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import BinaryIO

import numpy as np

from raybundle.errors import InputError

TEXT_BYTES = 1 << 30
"""Largest text file that is read at once."""
UNSIZED_BYTES = 1 << 20
"""What is read of a file that states nothing of its size, as those of /proc."""
UTF16_BYTES, SHORTEST_UTF16 = 512, 8
"""Beginning of a file by which UTF-16 without a mark is recognised, and the shortest."""
_CONTROL = re.compile(r"[\x00-\x08\x0b\x0e-\x1f\x7f]")


UNPACKING = (zipfile.BadZipFile, zlib.error, lzma.LZMAError, RuntimeError, EOFError, ValueError, struct.error)
"""Exceptions of a damaged zip file: directory, names of members, compressed data, unknown method (a RuntimeError)."""


@contextmanager
def guarded(path: Path) -> Generator[None]:
    """Give what the numbers of a damaged file can do to a computation, or the system to a file, the file's name."""
    try:
        yield
    except OSError as error:
        raise InputError("file.not_readable", detail=error.strerror or str(error), file=path) from None
    except (MemoryError, RecursionError):
        raise InputError("file.memory", file=path) from None
    except (ArithmeticError, np.linalg.LinAlgError):
        raise InputError("file.not_computable", file=path) from None


def stands(path: Path) -> bool:
    """Whether a name stands in its folder, whatever it names.

    What is optional is absent where it does not.  A link to nothing or to itself was meant to be read, though
    `Path.exists` denies it: who reads it (`check_regular`) refuses it.
    """
    return os.path.lexists(path)


def check_regular(path: Path) -> None:
    """Raise InputError where a path is no regular file: reading a pipe may never end, nor may a device."""
    try:
        mode = path.stat().st_mode
    except FileNotFoundError:
        if path.is_symlink():
            raise InputError("file.link_broken", target=str(path.readlink()), file=path) from None
        raise InputError("file.missing", file=path) from None
    except OSError as error:
        if error.errno == errno.ELOOP:
            raise InputError("file.link_loop", file=path) from None
        raise InputError("file.not_readable", detail=error.strerror, file=path) from None
    except ValueError:  # a zero byte in the name
        raise InputError("file.impossible_name", file=path) from None
    if not stat.S_ISREG(mode):
        kinds = ((stat.S_ISDIR, "folder"), (stat.S_ISFIFO, "pipe"), (stat.S_ISSOCK, "socket"))
        kind = next((name for of_kind, name in kinds if of_kind(mode)), "device")
        raise InputError("file.not_a_file", kind=kind, file=path)


@contextmanager
def opened(path: Path) -> Generator[BinaryIO]:
    """A regular file, open for reading its bytes; raises InputError where it is none or cannot be opened or read."""
    check_regular(path)
    try:
        with path.open("rb") as file:
            yield file
    except OSError as error:
        raise InputError("file.not_readable", detail=error.strerror, file=path) from None


def read_bytes(path: Path, limit: int = TEXT_BYTES) -> bytes:
    """The bytes of a file; raises InputError where it cannot be read or is larger than the limit."""
    with opened(path) as file:
        size = os.fstat(file.fileno()).st_size
        if size > limit:
            raise InputError("file.too_large", size_bytes=size, limit_bytes=limit, file=path)
        data = file.read(min(limit, size or UNSIZED_BYTES) + 1)
    if len(data) > (size or min(limit, UNSIZED_BYTES)):
        raise InputError("file.changed", file=path)
    return data


def as_utf8(data: bytes, *, whole: bool = True) -> bytes:
    """The bytes of a text as UTF-8 without a byte order mark: UTF-16 is converted, other bytes stay as they are.

    whole  False for the beginning of a text, which may end within a character

    UTF-16 has a mark, or else a zero in every second byte, which no text of one byte a letter has.
    """
    if data.startswith(codecs.BOM_UTF8):
        return data[len(codecs.BOM_UTF8) :]
    encoding = _utf_16(data)
    if not encoding:
        return data
    try:
        text = codecs.getincrementaldecoder(encoding)().decode(data, final=whole)
        return text.removeprefix("\ufeff").encode("utf-8")
    except UnicodeError:
        return data


def _utf_16(data: bytes) -> str:
    """The name of the encoding if it is UTF-16, else empty."""
    if data.startswith((codecs.BOM_UTF16_LE, codecs.BOM_UTF16_BE)):
        return "utf-16-le" if data.startswith(codecs.BOM_UTF16_LE) else "utf-16-be"
    head = data[:UTF16_BYTES]
    if len(head) < SHORTEST_UTF16:
        return ""
    for encoding, zeros, letters in (("utf-16-le", head[1::2], head[::2]), ("utf-16-be", head[::2], head[1::2])):
        if 0 not in letters and zeros.count(0) > len(zeros) / 2 and zeros[:2] == b"\0\0":
            return encoding
    return ""


def read_text(path: Path, limit: int = TEXT_BYTES) -> str:
    """The text of a UTF-8 or UTF-16 file, without a byte order mark, line ends as newlines.

    raises  InputError with the line of a byte that is not UTF-8, or of a control character
    """
    text = decoded(path, as_utf8(read_bytes(path, limit))).replace("\r\n", "\n")
    check_text(path, text)
    return text


def check_text(path: Path, text: str) -> None:
    """Raise InputError with the line of a control character, which no text has."""
    if found := _CONTROL.search(text):
        line = text.count("\n", 0, found.start()) + 1
        raise InputError("file.control_character", byte=f"0x{ord(found[0]):02x}", file=path, line=line)


def decoded(path: Path, data: bytes, first_line: int = 1) -> str:
    """Bytes as UTF-8; raises InputError with the line, counted from `first_line`, of a byte that is not."""
    try:
        return data.decode("utf-8")
    except UnicodeDecodeError as error:
        line = first_line + data.count(b"\n", 0, error.start)
        utf16 = data[:2] in {b"\xff\xfe", b"\xfe\xff"}
        byte = f"0x{data[error.start]:02x}"
        raise InputError("file.not_utf8", byte=byte, utf16=utf16, file=path, line=line) from None


def read_lines(path: Path, limit: int = TEXT_BYTES) -> Iterator[tuple[int, str]]:
    """The lines of a text file with their numbers."""
    return enumerate(read_text(path, limit).replace("\r", "\n").split("\n"), 1)
