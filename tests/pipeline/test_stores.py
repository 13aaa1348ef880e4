"""Which stores are refused, before anything is computed or remembered."""

import re

import pytest

from raybundle.cli.main import main
from raybundle.errors import InputError
from raybundle.io.block.folder import write_block
from raybundle.io.copies import Copies, check_copies, copies_folder
from raybundle.io.user_folders import made_again_folder
from raybundle.pipeline.project import store_given
from raybundle.pipeline.stores import check_store
from tests.blocking.networks import flight
from tests.messages import printed

fsspec = pytest.importorskip("fsspec", reason="the extra [cluster] is not installed")


@pytest.fixture(autouse=True)
def copies(tmp_path, monkeypatch):
    monkeypatch.setenv("RAYBUNDLE_PRODUCTS", str(tmp_path / "products"))


def run(capsys, *words):
    """Exit status and what is said of the error."""
    status = main([str(w) for w in words])
    return status, capsys.readouterr().err


def test_what_is_no_store_is_refused_with_the_option_as_typed(tmp_path, monkeypatch):
    (tmp_path / "here").mkdir()
    monkeypatch.chdir(tmp_path / "here")
    (tmp_path / "file").write_text("x")
    (tmp_path / "photos").mkdir()
    cases = {
        "Project": "store.",
        "s3//bucket": "store.",
        "s3://[x": "store.",
        "memory://x": "store.in_memory",
        "http://host/x": "store.web_page",
        "s3://name:secret@host/x": "store.secret",
        "nosuch://x": "store.unknown_scheme",
        "file:///": "store.no_folder_name",
        "file://": "store.no_folder_name",
        "local:////": "store.no_folder_name",
        f"file://{tmp_path}/a%20b/y": "store.escaped",
        "file://bucket%20x/y": "store.escaped",
        "s3:///y": "store.no_bucket_name",
        "gs://": "store.no_bucket_name",
        f"file://{tmp_path}/file": "store.is_a_file",
        f"file://{tmp_path}/file/x": "store.not_writable",
        "file:///proc/x": "store.not_writable",
        f"file://{tmp_path}/out": "store.not_separate",
        f"file://{tmp_path}/out/cache": "store.not_separate",
        f"local://{tmp_path}/out/result/x": "store.not_separate",
        f"file://{tmp_path}/photos/store": "store.not_separate",
    }
    for url, why in cases.items():
        with pytest.raises(InputError, match=re.escape(why)) as error:
            check_store(url, out=tmp_path / "out", apart=(tmp_path / "photos",))
        said = str(error.value)
        assert said.startswith(f'store="{url}"') or "secret" in url, said
        assert "name:secret" not in said
        assert "Error" not in said
        assert "token" not in said
    assert not (tmp_path / "out").exists()
    assert {p.name for p in tmp_path.iterdir()} == {"file", "photos", "here"}
    assert not list((tmp_path / "here").iterdir())


def test_what_is_not_for_good_leaves_nothing(tmp_path):
    check_store(f"file://{tmp_path}/parts", out=tmp_path / "out", lasting=False)
    assert not list((tmp_path / "parts").iterdir())
    check_store(f"file://{tmp_path}/good", out=tmp_path / "out")
    assert (tmp_path / "good/token").is_file()


def test_a_photograph_in_the_store_itself_is_refused_and_beside_it_is_not(tmp_path):
    photo = tmp_path / "in/a.jpg"
    photo.parent.mkdir()
    photo.write_bytes(b"")
    with pytest.raises(InputError, match=r"store\.not_separate"):
        check_store(f"file://{tmp_path}/in", out=tmp_path / "out", apart=(photo,))
    check_store(f"file://{tmp_path}/in/store", out=tmp_path / "out", apart=(photo,))


def test_a_store_that_was_refused_is_not_remembered(tmp_path, capsys):
    (tmp_path / "photos").mkdir()
    words = ("orient", tmp_path / "photos", "--out", tmp_path / "project")
    for url in ("Project", f"file://{tmp_path}/project/cache", "nosuch://x"):
        status, shown = run(capsys, *words, "--store", url)
        assert status == 2
        assert f"--store {url}" in shown
        assert not store_given(tmp_path / "project")
    # one that stands there from before does not stand in the way of the next
    (tmp_path / "project").mkdir(exist_ok=True)
    (tmp_path / "project/project.toml").write_text('[orient]\nphotos = []\nstore = "Project"\n')
    status, shown = run(capsys, *words)
    assert status == 2
    assert printed("store.of_last_run", here="project") in shown
    assert "\n  --store Project: " in shown
    status, shown = run(capsys, *words, "--store", "project")
    assert "no URL" not in shown
    assert "photograph" in shown  # which there are none of


def test_an_adjustment_refuses_a_store_at_once_where_nothing_is_cut(tmp_path, capsys):
    write_block(flight(), tmp_path / "block")
    for url in ("s3//typo", f"file://{tmp_path}/block/x", f"file://{tmp_path}/result"):
        status, said = run(capsys, "adjust", tmp_path / "block", "--out", tmp_path / "result", "--store", url)
        assert status == 2
        assert f"--store {url}" in said
        assert not (tmp_path / "result").exists()


def test_copies_in_a_file_are_refused(tmp_path, monkeypatch):
    (tmp_path / "file").write_text("x")
    monkeypatch.setenv("RAYBUNDLE_PRODUCTS", str(tmp_path / "file"))
    with pytest.raises(InputError, match=r"store\.copies_no_folder"):
        check_store(f"file://{tmp_path}/s", out=tmp_path / "out")
    monkeypatch.setenv("RAYBUNDLE_PRODUCTS", str(tmp_path / "file/below"))
    with pytest.raises(InputError, match=r"store\.copies_no_folder"):
        check_copies()


def test_copies_go_where_all_that_is_made_again_goes(tmp_path, monkeypatch):
    monkeypatch.setenv("RAYBUNDLE_CACHE", str(tmp_path / "cache"))
    assert copies_folder() == tmp_path / "products"
    monkeypatch.delenv("RAYBUNDLE_PRODUCTS")
    assert copies_folder() == tmp_path / "cache/products"
    monkeypatch.delenv("RAYBUNDLE_CACHE")
    assert copies_folder() == made_again_folder() / "products"
    assert made_again_folder().name == "raybundle"


def test_a_count_below_nothing_is_not_believed(tmp_path, monkeypatch):
    monkeypatch.setenv("RAYBUNDLE_PRODUCTS_GB", "1e-6")
    copies = Copies(tmp_path / "products", "a")
    for k in range(3):
        copies.make(f"x-{k:040x}", 400, lambda here: here.write_bytes(b"1" * 400), lambda _: None)
        (tmp_path / "products/held").write_text("-1000000")
    assert sum(p.stat().st_size for p in (tmp_path / "products").rglob("*.npz")) <= 1000
