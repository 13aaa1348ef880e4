"""Archives of arrays as products are kept: .npz files of NumPy whose arrays lie uncompressed at multiples of 64 bytes.

Any program reads them with np.load; here an array is read, or mapped, without touching the others.  Each array has its
check sum (CRC-32, in the directory at the end of the file), so what is read is verified and nothing else needs to be.
The same arrays give the same bytes: times are left out.
"""

from __future__ import annotations

import mmap
import os
import struct
import zipfile
import zlib
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from functools import lru_cache
from io import BytesIO
from pathlib import Path
from tokenize import TokenError
from typing import BinaryIO

import numpy as np

from raybundle.numerics.arrays import Array

DAMAGED = (
    OSError, ValueError, EOFError, zipfile.BadZipFile, zlib.error, struct.error, KeyError, MemoryError, OverflowError,
    RuntimeError, SyntaxError, TypeError, TokenError,
)  # fmt: skip
"""What reading a damaged archive of arrays can raise; unsupported and too deep ones are RuntimeErrors."""
ALIGNED = 64
"""Bytes: a cache line, and the widest vectors that kernels load."""
PADDING = 0xD935
"""Extra field of an archive's member that states nothing, as `zipalign` writes it."""
LARGE = 1 << 30
"""Bytes from which on sizes are written with 64 bits."""
LOCAL, END, END64 = struct.Struct("<4s22xHH"), struct.Struct("<4s6xHIIH"), struct.Struct("<4s36xQQ")
"""Of the ZIP format (APPNOTE 6.3.10, 4.3.7, 4.3.16 and 4.3.14): lengths before a member; where the directory lies."""
END64_LOCATOR = 20
CHUNK = 1 << 24
"""Bytes that are read at once while a check sum is made."""


@dataclass(frozen=True, slots=True)
class Member:
    """An array in an archive."""

    start: int
    """of its first number in the file [bytes]"""
    header: bytes
    dtype: np.dtype
    shape: tuple[int, ...]
    fortran: bool
    sum: int
    """CRC-32 of header and numbers"""

    @property
    def nbytes(self) -> int:
        """Of its numbers."""
        return int(np.prod(self.shape, dtype=object)) * self.dtype.itemsize

    def array(self, buffer: memoryview | mmap.mmap | bytearray, offset: int) -> Array:
        """The array over a buffer."""
        return np.ndarray(self.shape, self.dtype, buffer, offset, order="F" if self.fortran else "C")


def write_archive(file: BinaryIO, product: Mapping[str, Array]) -> None:
    """Write an archive, and let go of it where the disk is full."""
    with zipfile.ZipFile(file, "w") as archive:
        for name, values in product.items():
            array = np.asanyarray(values)
            large = array.nbytes > LARGE
            info = zipfile.ZipInfo(f"{name}.npy")
            begin = archive.start_dir + LOCAL.size + len(info.filename.encode()) + 4 + 20 * large
            room = -begin % ALIGNED
            info.extra = struct.pack("<HH", PADDING, room) + bytes(room)
            with archive.open(info, "w", force_zip64=large) as member:
                np.lib.format.write_array(member, array, allow_pickle=False)


def is_complete(path: Path) -> bool:
    """Whether an archive is there as long as it was written, by the record at its end; its arrays are not read."""
    try:
        with path.open("rb", buffering=0) as file:
            size = file.seek(0, os.SEEK_END)
            back = min(size, END.size + END64_LOCATOR + END64.size)
            file.seek(size - back)
            last = file.read(back)
        mark, _, length, begin, comment = END.unpack(last[-END.size :])
        if mark != b"PK\5\6" or comment:
            return False
        if last[-END.size - END64_LOCATOR :].startswith(b"PK\6\7"):
            mark, length, begin = END64.unpack(last[: END64.size])
            return mark == b"PK\6\6" and begin + length + back == size
    except (OSError, struct.error):
        return False
    else:
        return begin + length + END.size == size


def members_of(file: BinaryIO) -> dict[str, Member]:
    """Where the arrays of an archive lie; raises one of DAMAGED."""
    found: dict[str, Member] = {}
    with zipfile.ZipFile(file) as archive:
        infos = archive.infolist()
    for info in infos:
        if info.compress_type != zipfile.ZIP_STORED or info.flag_bits & 1:
            raise ValueError(f"{info.filename} is compressed")
        file.seek(info.header_offset)
        mark, name, extra = LOCAL.unpack(file.read(LOCAL.size))
        if mark != b"PK\3\4":
            raise ValueError(f"{info.filename} is not where the directory states")
        begin = info.header_offset + LOCAL.size + name + extra
        file.seek(begin)
        head = file.read(12)
        short = head[6:7] == b"\1"
        length = 10 + struct.unpack_from("<H", head, 8)[0] if short else 12 + struct.unpack_from("<I", head, 8)[0]
        header = head[:length] + file.read(max(length - 12, 0))
        shape, fortran, dtype = _described(header)
        m = Member(begin + length, header, dtype, shape, fortran, info.CRC)
        if length + m.nbytes != info.file_size:
            raise ValueError(f"{info.filename} is not as long as its header states")
        found[info.filename.removesuffix(".npy")] = m
    return found


@lru_cache(4096)
def _described(header: bytes) -> tuple[tuple[int, ...], bool, np.dtype]:
    """Shape, order and type of an array; raises ValueError for what would be unpickled."""
    file = BytesIO(header)
    version = np.lib.format.read_magic(file)
    read = {(1, 0): np.lib.format.read_array_header_1_0, (2, 0): np.lib.format.read_array_header_2_0}.get(version)
    if read is None:
        raise ValueError(f"version {version} of the format of arrays")
    shape, fortran, dtype = read(file)
    if dtype.hasobject or min(shape, default=0) < 0:
        raise ValueError("objects are not read")
    return shape, fortran, dtype


def read_member(file: BinaryIO, m: Member) -> Array:
    """An array as a copy of one's own, verified; raises one of DAMAGED."""
    held = bytearray(m.nbytes)
    file.seek(m.start)
    if file.readinto(held) != m.nbytes:  # pyright: ignore[reportAttributeAccessIssue]  (of every file on disk)
        raise EOFError
    _check(m, held)
    return m.array(held, 0)


def mapped_members(file: BinaryIO, members: Sequence[Member], known: set[int]) -> list[Array]:
    """Arrays over the file itself, which cannot be written into; raises one of DAMAGED.

    known  where arrays begin that were verified before; those that are now are added
    """
    held = mmap.mmap(file.fileno(), 0, access=mmap.ACCESS_READ)
    found: list[Array] = []
    for m in members:
        if m.start % ALIGNED:
            raise ValueError("an array does not lie where a kernel can read it")
        if m.start not in known:
            with memoryview(held) as whole:
                _check(m, whole[m.start : m.start + m.nbytes])
            known.add(m.start)
        found.append(m.array(held, m.start))
    return found


def _check(m: Member, numbers: memoryview | bytearray) -> None:
    """Raise ValueError where numbers are not those that were written."""
    total = zlib.crc32(m.header)
    with memoryview(numbers) as whole:
        for k in range(0, len(whole), CHUNK):
            total = zlib.crc32(whole[k : k + CHUNK], total)
    if total != m.sum or len(numbers) != m.nbytes:
        raise ValueError("the check sum of an array is not that with which it was written")
