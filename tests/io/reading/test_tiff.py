"""Directories of TIFF and BigTIFF, both byte orders, read alike by the strict and by the lenient reader."""

from __future__ import annotations

import struct
from pathlib import Path

import pytest

from raybundle.errors import InputError
from raybundle.io.photos.exif import read_tags
from raybundle.io.reading.tiff import Memory, Tiff, is_tiff, tiff_tags

MAKE, WIDTH, RESOLUTION, SIGNED, MODEL_SCALE = 271, 256, 282, 340, 33550


def structure(order: str, *, big: bool) -> bytes:
    """A TIFF with one directory: a text, a number in place, a fraction, x/0, signed bytes, three doubles."""
    pointer, room, entry, width = ("Q", 8, 20, "Q") if big else ("I", 4, 12, "H")
    values = {
        WIDTH: (4, 1, struct.pack(order + "I", 70000)),
        MAKE: (2, 6, b"maker\0"),
        RESOLUTION: (5, 2, struct.pack(order + "IIII", 300, 7, 1, 0)),
        SIGNED: (6, 3, struct.pack("bbb", -1, 2, -3)),
        MODEL_SCALE: (12, 3, struct.pack(order + "ddd", 0.25, 0.5, 1e-9)),
    }
    head = (b"II" if order == "<" else b"MM") + struct.pack(order + "H", 43 if big else 42)
    head += struct.pack(order + "HHQ", 8, 0, 16) if big else struct.pack(order + "I", 8)
    after = len(head) + struct.calcsize("<" + width) + entry * len(values) + room
    rows, extra = b"", b""
    for tag, (type_, count, raw) in sorted(values.items()):
        place = raw.ljust(room, b"\0")
        if len(raw) > room:
            place, extra = struct.pack(order + pointer, after + len(extra)), extra + raw
        rows += struct.pack(order + "HH" + pointer, tag, type_, count) + place
    return head + struct.pack(order + width, len(values)) + rows + b"\0" * room + extra


@pytest.mark.parametrize("big", [False, True])
@pytest.mark.parametrize("order", ["<", ">"])
def test_both_readers_find_the_same(tmp_path: Path, *, order: str, big: bool) -> None:
    """Numbers of the file and of the EXIF reader, which reads text and fractions, too."""
    data = structure(order, big=big)
    path = tmp_path / "a.tif"
    path.write_bytes(data)
    assert is_tiff(path)
    found_order, numbers = tiff_tags(path)
    assert found_order == order
    assert numbers == {WIDTH: (70000,), SIGNED: (-1, 2, -3), MODEL_SCALE: (0.25, 0.5, 1e-9)}
    assert tiff_tags(path, frozenset({WIDTH}))[1] == {WIDTH: (70000,)}
    tags = read_tags(data)
    assert not tags.remarks
    assert tags.text(MAKE) == "maker"
    assert tags.numbers(RESOLUTION)[0] == pytest.approx(300 / 7, rel=1e-15)
    assert tags.numbers(RESOLUTION)[1] != tags.numbers(RESOLUTION)[1]
    assert tags.numbers(MODEL_SCALE) == (0.25, 0.5, 1e-9)


@pytest.mark.parametrize("big", [False, True])
def test_every_cut_is_noticed(tmp_path: Path, *, big: bool) -> None:
    """A file that ends anywhere is refused, EXIF that ends anywhere is read as far as it goes and says so."""
    data = structure("<", big=big)
    path = tmp_path / "cut.tif"
    whole = read_tags(data)
    for size in range(len(data)):
        path.write_bytes(data[:size])
        with pytest.raises(InputError, match=r"tiff\.ends_early|tiff\.no_tiff"):
            tiff_tags(path)
        tags = read_tags(data[:size])
        assert tags.remarks or tags == whole
    assert Tiff.of(Memory(memoryview(b"II\x2a"))) is None
