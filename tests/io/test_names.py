"""One rule for names: whatever a file system calls a photograph, each reader reads what its writer writes."""

import json
import os
import subprocess
import sys
from dataclasses import replace

import cv2
import numpy as np
import pytest
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st
from tests.io.formats.test_foreign_formats import BOTH, exported, make_block, needs

from raybundle import adjust
from raybundle.errors import InputError
from raybundle.io.block.folder import read_block, write_block
from raybundle.io.formats import formats, read_format, write_format
from raybundle.io.photos.photo import find_photos, shown
from raybundle.readable import readable, readable_names, without_controls
from raybundle.results.folder import read_result, written_folder

CASES = [
    "Screenshot 10.00\u202fAM.png", "a\u00a0b.jpg", "\u200ea.jpg", " lead.jpg", "trail.jpg ", "a\nb.jpg", "a\r\nb.jpg",
    "tab\tx.jpg", "\x1b[31mred\x1b[0m.jpg", "\x1b]0;title\x07.jpg", 'q"uote.jpg', "com,ma.jpg", "#hash.jpg", "a;b.jpg",
    "\u2028x.jpg", "\x85y.jpg", "\ufeffz.jpg", "\udcff\udc80.jpg", "'q.jpg", "a\\b.jpg", "\\x1b.jpg", "=1+1", "nan",
    "*", "\u3000i.jpg", "\u202egpj.exe", "e\u0301.jpg", "\u00e9.jpg", "<b>&amp;.jpg", "%20.jpg", "a b  c.jpg", "-1",
    "\U000e0041.jpg", "\u200b", "\x7f.jpg", "雪.jpg", "👁\u200d🗨.jpg", ".", "~", "1e5", "a|b", "{x}", "[1]", "x=y",
]  # fmt: skip
"""Names that a file system holds"""
FILE_NAMES = st.text(
    st.characters(exclude_characters="/\0", exclude_categories=()), min_size=1, max_size=24
).filter(lambda n: not any("\ud800" <= c <= "\udc7f" or "\udd00" <= c <= "\udfff" for c in n))  # fmt: skip
"""Without what is none: surrogates stand for bytes only (PEP 383)"""


@pytest.fixture(scope="module")
def block():
    found = make_block()
    return replace(found, images=replace(found.images, file=found.images.ids))


def named(block, names):
    """The block whose images have the first of the names."""
    ids = tuple(names[: len(block.images)])
    return replace(block, images=replace(block.images, ids=ids, file=ids))


def renamed(block, names):
    """Blocks that use all names once."""
    count = len(block.images)
    for k in range(0, len(names), count):
        part = [*dict.fromkeys(names[k : k + count])]
        part += [f"filled {i}" for i in range(count - len(part))]
        yield named(block, part)


def check_block(block, folder):
    write_block(block, folder)
    again = read_block(folder)
    assert again.images.ids == readable_names(block.images.ids)
    assert again.images.file == tuple(map(readable, block.images.file))
    np.testing.assert_array_equal(again.observations.image, block.observations.image)
    write_block(again, folder.with_name("twice"))
    assert (folder.with_name("twice") / "images.csv").read_bytes() == (folder / "images.csv").read_bytes()


@pytest.mark.parametrize("name", CASES)
def test_a_readable_name_is_printable_and_stays(name):
    new = readable(name)
    assert new.isprintable()
    assert new == new.strip()
    assert readable(new) == new
    new.encode()
    if name.isprintable() and name == name.strip():
        assert new == name


def test_names_that_differ_stay_different():
    names = ["a\n", r"a\x0a", "a\n ", r"a\x0a\x20", "b", "a\r"]
    new = readable_names(names)
    assert len({*new}) == len(names)
    assert new[1] == names[1]
    assert new[3] == names[3]
    assert readable_names(new) == new


def test_blocks_with_names_of_a_file_system(block, tmp_path):
    for k, one in enumerate(renamed(block, CASES)):
        (tmp_path / f"{k}").mkdir()
        check_block(one, tmp_path / f"{k}/block")


def check_drawn(block, folder, names):
    for k, one in enumerate(renamed(block, names)):
        (folder / f"{k}").mkdir()
        check_block(one, folder / f"{k}/block")


def drawn(examples):
    """Sets of 20 names."""

    def decorate(function):
        check = given(st.lists(FILE_NAMES, min_size=20, max_size=20, unique=True))(function)
        return settings(
            max_examples=examples, deadline=None, database=None,
            suppress_health_check=[HealthCheck.function_scoped_fixture, HealthCheck.too_slow],
        )(check)  # fmt: skip

    return decorate


@drawn(25)
def test_blocks_with_500_drawn_names(block, tmp_path_factory, names):
    check_drawn(block, tmp_path_factory.mktemp("names"), names)


@pytest.mark.long
@drawn(500)
def test_blocks_with_10_000_drawn_names(block, tmp_path_factory, names):
    check_drawn(block, tmp_path_factory.mktemp("names"), names)


@pytest.mark.parametrize("name", BOTH)
def test_exchange_formats_with_names_of_a_file_system(name, block, tmp_path):
    needs(name)
    for k, one in enumerate(renamed(block, CASES)):
        path = tmp_path / f"out{k}{formats[name].suffix}"
        check_format(name, replace(one, images=read_names(one.images)), path)


def read_names(images):
    """As they come from a folder of photographs or from a block."""
    return replace(images, ids=readable_names(images.ids), file=readable_names(images.file))


def check_format(name, block, path):
    """Either the writer refuses with the name, or the reader reads as many images, whose names differ."""
    try:
        write_format(name, exported(block), path)
    except InputError as error:
        assert "name" in str(error), error  # noqa: PT017
        return
    again = read_format(name, path).block
    assert len(again.images) == len(block.images)
    assert len({*again.images.ids}) == len(block.images)
    if len(again.observations):  # a block needs some
        check_block(again, path.with_name(f"{path.name}-block-{len(list(path.parent.iterdir()))}") / "b")


@pytest.mark.parametrize("name", BOTH)
@drawn(5)
def test_exchange_formats_with_drawn_names(name, block, tmp_path_factory, names):
    needs(name)
    folder = tmp_path_factory.mktemp("names")
    for k, one in enumerate(renamed(block, names)):
        path = folder / f"out{k}{formats[name].suffix}"
        check_format(name, replace(one, images=read_names(one.images)), path)


def test_results_with_names_of_a_file_system(block, tmp_path):
    for k, one in enumerate(renamed(block, CASES)):
        with written_folder(adjust(one), tmp_path / f"{k}"):
            pass
        assert read_result(tmp_path / f"{k}").block.images.ids == readable_names(one.images.ids)


@pytest.mark.skipif(os.name != "posix", reason="such names are none there")
def test_photographs_are_found_under_readable_names_and_nothing_obeys_them(tmp_path):
    ok, data = cv2.imencode(".png", np.zeros((40, 60, 3), np.uint8))
    assert ok
    made = [n for n in CASES if n.endswith((".jpg", ".png", ".jpg "))]
    for k, name in enumerate(made):
        with open(os.fsencode(str(tmp_path)) + b"/" + os.fsencode(name), "wb") as file:  # noqa: PTH123
            file.write(data.tobytes() + bytes([k]))
    found = find_photos([tmp_path])
    assert {p.name for p in found.photos} == {readable(n) for n in made if n.endswith((".jpg", ".png"))}
    assert all(p.path.exists() for p in found.photos)
    again = find_photos([tmp_path])
    assert [p.name for p in again.photos] == [p.name for p in found.photos]
    command = [sys.executable, "-m", "raybundle", "photos", str(tmp_path)]
    done = subprocess.run(command, capture_output=True, check=False)
    said = (done.stdout + done.stderr).decode()
    assert "red" in said
    assert without_controls(said) == said


@pytest.mark.parametrize("name", [n for n in CASES if without_controls(n) != n])
def test_an_error_holds_nothing_that_a_terminal_obeys(name, tmp_path):
    error = InputError(f"{name} is wrong", file=tmp_path / name)
    assert without_controls(str(error)).replace("\n", "") == str(error).replace("\n", "")
    assert "\x1b" not in str(error)
    json.dumps(str(error)).encode()
    assert shown(tmp_path / name).as_posix().isprintable()
