"""Project folders: complete products or none, and a message where nothing can be written."""

import numpy as np
import pytest

from raybundle.errors import InputError
from raybundle.io.block.arrays import arrays_of_block, block_of_arrays
from raybundle.pipeline import store as stores
from raybundle.pipeline.keys import key_of
from raybundle.pipeline.project import Project
from raybundle.pipeline.store import Files, writing
from raybundle.planning.simulate import Survey, simulate
from raybundle.planning.synthetic_networks import TargetField, field_scene


@pytest.fixture
def project(tmp_path):
    opened = Project.open(tmp_path / "p")
    yield opened
    opened.close()


def test_products_come_back_equal(project):
    key = key_of("features", 1)
    assert project.products.load(key) is None
    project.products.store(key, {"a": np.arange(5.0), "b": np.array(["x", "yy"])})
    found = project.products.load(key)
    assert (found["a"] == np.arange(5.0)).all()
    assert found["b"].tolist() == ["x", "yy"]


@pytest.mark.parametrize("size", [0, 10, 200])
def test_a_damaged_product_is_made_again(project, size):
    key = key_of("start", 1)
    project.products.store(key, {"a": np.arange(100.0)})
    (file,) = (project.folder / "cache").glob("*/start-*.npz")
    file.write_bytes(file.read_bytes()[:size])
    assert project.products.load(key) is None
    assert not project.products.has(key)


def test_who_finds_a_product_damaged_leaves_the_one_that_another_has_made_since(project, monkeypatch):
    """Two read the damaged file at once; the slower one says so when the quicker one has made it again."""
    key = key_of("start", 1)
    store = project.products
    store.store(key, {"a": np.arange(100.0)})
    (file,) = (project.folder / "cache").glob("*/start-*.npz")
    data = bytearray(file.read_bytes())
    data[300] ^= 255
    file.write_bytes(data)
    damaged, is_complete = Files.damaged, stores.is_complete

    def late(files, *arguments, **named):
        store.store(key, {"a": np.arange(100.0)})
        damaged(files, *arguments, **named)

    monkeypatch.setattr(Files, "damaged", late)
    assert store.load(key)["a"].tolist() == list(range(100))

    def cut(path):  # was found so, and is made again before the file is removed
        store.store(key, {"a": np.arange(100.0)})
        return is_complete(path.with_name("no such file"))

    monkeypatch.setattr(stores, "is_complete", cut)
    assert not store.has(key)
    monkeypatch.undo()
    assert store.has(key)


def test_a_product_under_the_name_of_another_is_made_again(project):
    """As a restored or synchronised folder may have it."""
    one, two = key_of("start", 1), key_of("start", 2)
    project.products.store(one, {"a": np.arange(3.0)})
    project.products.store(two, {"a": np.arange(4.0)})
    files = {k: next((project.folder / "cache").glob(f"*/{k}.npz")) for k in (one, two)}
    files[two].write_bytes(files[one].read_bytes())
    assert project.products.load(two) is None
    assert project.products.load(one)["a"].tolist() == [0, 1, 2]


def test_a_write_that_fails_leaves_nothing(project, monkeypatch):
    def full(*_, **__):
        raise OSError(28, "No space left on device")

    monkeypatch.setattr(np.lib.format, "write_array", full)
    with pytest.raises(InputError, match=r"project\.not_writable"):
        project.products.store(key_of("start", 2), {"a": np.zeros(3)})
    assert not list((project.folder / "cache").glob("*/*"))


def test_pairs_are_kept_with_their_facts(project):
    matches = np.array([[1, 2], [3, 4]], np.int32)
    keys = [key_of("matching", k) for k in range(3)]
    for key, n in zip(keys[:2], (7, 0), strict=True):
        product = {"candidates": np.array(n), "what": np.array("ä"), "share": np.array(np.nan), "matches": matches[:n]}
        project.store_small([(key, product)])
    found = project.small(keys)
    assert set(found) == set(keys[:2])
    assert (found[keys[0]]["candidates"].item(), found[keys[0]]["what"].item()) == (7, "ä")
    assert np.isnan(found[keys[0]]["share"])
    assert (found[keys[0]]["matches"] == matches).all()
    assert found[keys[1]]["matches"].shape == (0, 2)
    project.forget_kind("match")
    assert len(project.small(keys)) == 2
    project.forget_kind("matching")
    assert not project.small(keys)


def test_a_stage_is_recorded_only_when_it_ends(project):
    with project.stage("features") as stage:
        stage.summary = "3 photographs"
    with pytest.raises(ZeroDivisionError), project.stage("matching"):
        1 / 0
    assert [r.name for r in project.stages()] == ["features"]
    assert project.stages()[0].summary == "3 photographs"


def test_something_else_is_not_overwritten(tmp_path):
    (tmp_path / "letter.txt").write_text("dear")
    with pytest.raises(InputError, match=r"project\.folder_not_empty"):
        Project.open(tmp_path)
    with pytest.raises(InputError, match=r"project\.no_database"):
        Project.open(tmp_path / "new", create=False)


def test_a_file_that_is_no_database_is_named(tmp_path):
    (tmp_path / "project.db").write_text("no database, but long enough to be read as one" * 100)
    with pytest.raises(InputError, match=r"project\.db.*project\.not_readable"):
        Project.open(tmp_path)


def test_keys_depend_on_everything():
    assert key_of("a", 1, {"x": 2.0}) == key_of("a", 1, {"x": 2.0})
    others = {key_of("a", 1, np.zeros(2)), key_of("a", 1, np.ones(2)), key_of("a", 2, np.zeros(2)), key_of("b", 1)}
    assert len(others) == 4
    with pytest.raises(TypeError):
        key_of("a", object())


def test_a_read_only_place_is_named(tmp_path):
    with pytest.raises(InputError, match=r"project\.not_writable"), writing(tmp_path):
        raise OSError(30, "Read-only file system")


def test_a_block_as_arrays_comes_back_equal(project):
    block = simulate(field_scene(TargetField()), Survey(scale_bars=2, control=5, station_sigma=0.1)).observed
    key = key_of("block", 1)
    project.products.store(key, arrays_of_block(block))
    again = block_of_arrays(project.products.load(key))
    assert again.cameras == block.cameras
    for name in ("images", "observations", "points", "distances", "stations"):
        a, b = getattr(again, name), getattr(block, name)
        for field in a.__dataclass_fields__:
            np.testing.assert_array_equal(getattr(a, field), getattr(b, field))
