"""The store: archives whose arrays are read, or mapped, one by one, and verified as they are."""

import errno
import os
import subprocess
import sys
import zipfile

import numpy as np
import pytest

from raybundle.io.copies import StoreLost
from raybundle.pipeline.archives import ALIGNED, is_complete, members_of, write_archive
from raybundle.pipeline.keys import key_of
from raybundle.pipeline.place import ProductGone, mark_of
from raybundle.pipeline.store import KEY as KEY_NAME
from raybundle.pipeline.store import Folder

KEY = key_of("test", 1)
PRODUCT = {
    "xy": np.random.default_rng(1).normal(size=(61, 2)), "order": np.asfortranarray(np.arange(12.0).reshape(3, 4)),
    "names": np.array(["a", "bcd", "雪"]), "no text": np.array(""), "none": np.zeros((0, 3)), "number": np.array(2.5),
    "mixed": np.array([(1, 2.0)], dtype=[("i", "i4"), ("x", "f8")]), "one byte": np.array([7], np.uint8),
}  # fmt: skip


@pytest.fixture
def store(tmp_path):
    return Folder(tmp_path / "p" / "cache")


@pytest.fixture
def path(store):
    store.store(KEY, PRODUCT)
    (found,) = store.path.glob("*/*.npz")
    return found


@pytest.mark.parametrize("read", ["load", "mapped", "held"])
def test_what_is_read_is_what_was_kept(store, path, read):
    found = getattr(store, read)(KEY)
    assert found.keys() == PRODUCT.keys()
    for name, values in PRODUCT.items():
        np.testing.assert_array_equal(found[name], values)
        assert (found[name].dtype, found[name].flags.f_contiguous) == (values.dtype, values.flags.f_contiguous)
        assert found[name].flags.writeable == (read == "load")
    with np.load(path) as archive:  # any program reads it
        np.testing.assert_array_equal(archive["xy"], PRODUCT["xy"])


def test_arrays_lie_where_a_kernel_reads_them(path):
    with path.open("rb") as file:
        members = members_of(file)
        assert len(members) == len(PRODUCT) + 1
        for name, m in members.items():
            assert m.start % ALIGNED == 0, name
            file.seek(m.start)
            if name in PRODUCT:
                assert file.read(m.nbytes) == PRODUCT[name].tobytes("A")


def test_the_same_product_is_the_same_bytes(store, path):
    first = path.read_bytes()
    os.utime(path, (1, 1))
    store.store(KEY, PRODUCT)
    assert path.read_bytes() == first


def test_only_what_is_asked_for_is_read(store, path):
    with path.open("rb") as file:
        at = members_of(file)["xy"].start + 5
    data = bytearray(path.read_bytes())
    data[at] ^= 1
    path.write_bytes(data)
    assert store.has(KEY)  # it is as long as it was
    assert store.load(KEY, ["order"])["order"].shape == (3, 4)
    assert store.mapped(KEY, ["names"])["names"][2] == "雪"
    assert store.mapped(KEY, ["xy"]) is None
    assert not path.exists()


def test_a_file_that_was_replaced_is_verified_again(store, path):
    assert store.mapped(KEY, ["xy"]) is not None
    with path.open("rb") as file:
        at = members_of(file)["xy"].start + 5
    data = bytearray(path.read_bytes())
    data[at] ^= 1
    path.with_name("other").write_bytes(data)
    path.with_name("other").replace(path)
    assert store.mapped(KEY, ["xy"]) is None


@pytest.mark.parametrize("left", [0, 1, 21, 100, -1])
def test_a_product_that_was_cut_is_seen_without_reading_it(store, path, left):
    whole = path.read_bytes()
    assert is_complete(path)
    path.write_bytes(whole[:left])
    assert not store.has(KEY)
    assert not path.exists()


def test_a_product_of_more_members_and_bytes_than_16_and_32_bits_count(tmp_path, monkeypatch):
    """The records of the format for them, at a size that a test can write."""
    monkeypatch.setattr("raybundle.pipeline.archives.LARGE", 10)
    monkeypatch.setattr(zipfile, "ZIP_FILECOUNT_LIMIT", 3)
    file = tmp_path / "large.npz"
    with file.open("wb") as opened:
        write_archive(opened, PRODUCT)
    assert b"PK\6\6" in file.read_bytes()
    assert is_complete(file)
    with file.open("rb") as opened:
        members = members_of(opened)
    assert all(m.start % ALIGNED == 0 for m in members.values())
    file.write_bytes(file.read_bytes()[:-1])
    assert not is_complete(file)


def test_a_slice_of_a_large_product_takes_no_more_memory_than_it_is(store):
    """A process that maps 40 MB and sums a part of it, by its own memory (what is mapped from files apart)."""
    resource = pytest.importorskip("resource")
    del resource
    if not os.path.exists("/proc/self/status"):  # noqa: PTH110
        pytest.skip("memory is told by /proc")
    store.store(KEY, {"a": np.ones((5_000_000,))})
    program = (
        "import sys; from pathlib import Path; from raybundle.pipeline.store import Folder\n"
        "own = lambda: int(next(l for l in open('/proc/self/status') if l.startswith('RssAnon')).split()[1])\n"
        "store = Folder(Path(sys.argv[1])); before = own()\n"
        "total = store.mapped(sys.argv[2], ['a'])['a'][2_000_000:2_100_000].sum()\n"
        "print(int(total), own() - before)"
    )
    said = subprocess.run(
        [sys.executable, "-c", program, str(store.path), KEY], capture_output=True, text=True, check=True
    )
    total, kilobytes = map(int, said.stdout.split())
    assert total == 100_000
    assert kilobytes < 20_000


def test_a_product_that_is_gone_is_made_again_where_it_is_known_how(store, path):
    path.write_bytes(b"")
    with pytest.raises(ProductGone, match=r"product\.gone"):
        store.wanted(KEY)
    store.makers[KEY] = lambda: store.store(KEY, PRODUCT)
    assert store.wanted(KEY)["number"] == 2.5
    store.forget(KEY)
    assert store.held(KEY)["number"] == 2.5


def test_a_file_that_is_swept_away_while_it_is_written_is_written_again(store, monkeypatch):
    swept = []

    def write(file, product):
        write_archive(file, product)
        if not swept:
            swept.append(file.name)
            os.unlink(file.name)  # noqa: PTH108

    monkeypatch.setattr("raybundle.pipeline.store.write_archive", write)
    store.store(KEY, PRODUCT)
    assert swept
    assert store.load(KEY)["number"] == 2.5


@pytest.mark.parametrize("look", [1, 2, 3])
def test_a_product_that_is_made_again_while_a_damaged_one_is_removed_stays(store, path, monkeypatch, look):
    """Another process makes it after each of the looks at the file."""
    data = path.read_bytes()
    path.write_bytes(data[: len(data) // 2] + bytes(b ^ 255 for b in data[len(data) // 2 :]))
    looks = []

    def seen(file):
        mark = mark_of(file)
        looks.append(mark)
        if len(looks) == look:
            Folder(store.path).place.keep(KEY, {**PRODUCT, KEY_NAME: np.array(KEY)})
        return mark

    monkeypatch.setattr("raybundle.pipeline.store.mark_of", seen)
    store.load(KEY)
    monkeypatch.undo()
    assert len(looks) >= look
    assert Folder(store.path).load(KEY)["number"] == 2.5
    assert [p.name for p in path.parent.iterdir()] == [path.name]


@pytest.mark.parametrize("number", [errno.EMFILE, errno.ENFILE, errno.ENOMEM])
@pytest.mark.parametrize("read", ["load", "mapped", "wanted", "lent", "held"])
def test_a_system_that_is_short_of_something_damages_no_product(store, path, monkeypatch, number, read):
    def members(file):
        raise OSError(number, os.strerror(number))

    monkeypatch.setattr("raybundle.pipeline.store.members_of", members)
    with pytest.raises(StoreLost, match=r"store\.not_readable"):
        getattr(store, read)(KEY)
    monkeypatch.undo()
    assert path.exists()
    assert store.wanted(KEY)["number"] == 2.5
