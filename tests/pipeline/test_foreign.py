"""Project folders from somebody else: they run no code, ask nobody and write nowhere."""

import importlib
import json
import os
import pkgutil
import socket
import threading
from inspect import signature

import pytest

import raybundle
from raybundle.cli.main import main
from raybundle.errors import InputError
from raybundle.io.folders import check_place
from raybundle.io.object_urls import SCHEMES
from raybundle.io.user_folders import settings_folder
from raybundle.pipeline.clusters import TOKEN
from raybundle.pipeline.confirmed_stores import confirm_store, confirmed_stores, is_confirmed
from raybundle.pipeline.objects import objects_at
from raybundle.pipeline.project import Project
from raybundle.pipeline.stores import check_store
from raybundle.pipeline.task_functions import FUNCTIONS
from raybundle.pipeline.tasks import function_of, options_of
from raybundle.workflows.unfinished_parts import NOTES, STORES, forget_stores
from tests.barriers import DEADLINE_S
from tests.messages import printed

fsspec = pytest.importorskip("fsspec", reason="the extra [cluster] is not installed")


@pytest.fixture(autouse=True)
def config(tmp_path, monkeypatch):
    monkeypatch.setenv("RAYBUNDLE_CONFIG", str(tmp_path / "config"))
    monkeypatch.setenv("RAYBUNDLE_PRODUCTS", str(tmp_path / "products"))


class Listener:
    """A port of this machine that counts who comes."""

    def __init__(self):
        self.count, self.socket = 0, socket.create_server(("127.0.0.1", 0))
        self.port = self.socket.getsockname()[1]
        self.thread = threading.Thread(target=self._listen, daemon=True)
        self.thread.start()

    def _listen(self):
        while True:
            try:
                connection, _ = self.socket.accept()
            except OSError:
                return
            self.count += 1
            connection.close()

    def close(self):
        self.socket.shutdown(socket.SHUT_RDWR)
        self.socket.close()
        self.thread.join(DEADLINE_S)


@pytest.fixture
def listener():
    found = Listener()
    yield found
    found.close()


def foreign(folder, store):
    """A project folder whose project.toml names a store."""
    Project.open(folder).close()
    (folder / "project.toml").write_text(f"[orient]\nphotos = []\nstore = {json.dumps(store)}\n")
    return folder


def reference(tmp_path, port):
    """A file that fsspec reads as instructions: a template that runs a command, and an address."""
    ran = tmp_path / "ran"
    command = "{{ cycler.__init__.__globals__.os.system('touch " + str(ran) + "') }}"
    facts = {
        "version": 1, "templates": {"u": f"http://127.0.0.1:{port}/", "f": "{{c}}"},
        "gen": [{"key": "k{{i}}", "url": command, "dimensions": {"i": [1]}}],
        "refs": {"tasks.jsonl": ["{{u}}tasks"], "token": [f"http://127.0.0.1:{port}/token"], "x": command},
    }  # fmt: skip
    (tmp_path / "x.json").write_text(json.dumps(facts))
    return ran, f"reference::{(tmp_path / 'x.json').as_uri()}"


def stores(tmp_path, port):
    """URLs that a project from somebody else could name."""
    _, chained = reference(tmp_path, port)
    http = f"http://127.0.0.1:{port}/x"
    return [
        chained, "reference://", f"reference://?fo={http}", f"simplecache::{http}", f"filecache::{http}",
        f"zip://x::{http}", f"blockcache::{http}", f"dir::{http}", http, f"webdav://127.0.0.1:{port}/x",
        f"ftp://127.0.0.1:{port}/x", f"sftp://127.0.0.1:{port}/x", f"github://a:b@127.0.0.1:{port}/", "memory://x",
        f"file://{tmp_path}/elsewhere", f"local://{tmp_path}/elsewhere", f"jupyter://127.0.0.1:{port}/x",
        f"S3::{http}", f"file::{http}", f"libarchive://a::{http}", f"smb://127.0.0.1:{port}/x/y",
    ]  # fmt: skip


CASES = range(21)


@pytest.mark.parametrize("case", CASES)
def test_a_foreign_project_is_looked_at_and_nothing_is_asked_or_written(tmp_path, listener, case, capsys):
    ran, _ = reference(tmp_path, listener.port)
    urls = stores(tmp_path, listener.port)
    assert len(urls) == len(CASES)
    folder = foreign(tmp_path / "p", urls[case])
    (tmp_path / "photos").mkdir()
    before = (folder / "project.toml").read_bytes()
    commands = (
        ["status", str(folder)],
        ["worker", str(folder), "--shard", "0/1", "--wait", "0"],
        ["orient", str(tmp_path / "photos"), "--out", str(folder)],
    )
    statuses = [main(words) for words in commands]
    said = capsys.readouterr()
    assert statuses == [0, 2, 2], said.err
    assert "Traceback" not in said.err
    assert urls[case] in said.out  # the folder's status names it
    assert not ran.exists()
    assert listener.count == 0
    assert not (tmp_path / "elsewhere").exists()
    assert (folder / "project.toml").read_bytes() == before
    assert confirmed_stores() == []


def test_a_store_is_confirmed_by_giving_it_once(tmp_path, capsys):
    url = f"file://{tmp_path}/bucket"
    folder = foreign(tmp_path / "p", url)
    (tmp_path / "photos").mkdir()
    command = ["orient", str(tmp_path / "photos"), "--out", str(folder)]
    assert main(command) == 2
    assert printed("store.not_confirmed", url=url, worker="raybundle worker") in capsys.readouterr().err
    assert main([*command, "--store", url]) == 2  # there are no photographs
    assert "store.not_confirmed" not in capsys.readouterr().err
    assert is_confirmed(url)
    assert main(command) == 2
    assert "store.not_confirmed" not in capsys.readouterr().err
    if os.name == "posix":
        assert settings_folder().stat().st_mode & 0o777 == 0o700


def test_a_worker_confirms_the_url_that_it_is_given(tmp_path):
    main(["worker", f"file://{tmp_path}/bucket/", "--shard", "0/1", "--wait", "0"])
    assert is_confirmed(f"file://{tmp_path}/bucket")


def test_a_list_that_is_damaged_confirms_nothing(tmp_path):
    confirm_store("s3://a/b")
    assert is_confirmed("s3://a/b/")
    assert not is_confirmed("s3://a")
    assert not is_confirmed("s3://a/b/c")
    for content in (b"\xff", b"{}", b'["s3://a/b"', b"[1]", b'"s3://a/b"', b""):
        (settings_folder() / "stores.json").write_bytes(content)
        assert not is_confirmed("s3://a/b")
    confirm_store("s3://a/b")
    assert is_confirmed("s3://a/b")


def test_parts_of_a_foreign_result_remove_nothing_elsewhere(tmp_path):
    folder, bucket = tmp_path / ".r.parts", tmp_path / "bucket"
    token = "0" * 32
    kept = bucket / f"{token}-parts-1" / "token"
    kept.parent.mkdir(parents=True)
    kept.write_text(token)
    (folder / NOTES).mkdir(parents=True)
    (folder / NOTES / STORES).write_text(f"1 file://{bucket}\n")
    (folder / NOTES / TOKEN).write_text(token)
    forget_stores(folder)
    assert kept.exists()
    confirm_store(f"file://{bucket}")
    forget_stores(folder)
    assert not kept.exists()


@pytest.mark.parametrize("scheme", sorted({*fsspec.available_protocols(), "S3", "x", ""} - SCHEMES))
def test_other_schemes_are_no_stores(tmp_path, scheme):
    with pytest.raises(InputError):
        objects_at(f"{scheme}://x/y")
    with pytest.raises(InputError):
        check_store(f"{scheme}://x/y", out=tmp_path / "p")


@pytest.mark.parametrize("scheme", sorted(SCHEMES))
def test_no_scheme_chains(tmp_path, scheme):
    for url in (f"{scheme}://a::file:///x", f"{scheme}::file:///x", f"reference::{scheme}://a/b"):
        with pytest.raises(InputError, match=r"store\.chained"):
            objects_at(url)
        with pytest.raises(InputError, match=r"store\.chained"):
            check_store(url, out=tmp_path / "p")


def test_every_function_of_tasks_is_registered():
    """Those in the modules that make tasks, by their signature: a store, and options."""
    modules = {m.name for m in pkgutil.walk_packages(raybundle.__path__, "raybundle.")}
    assert {*FUNCTIONS} <= modules
    found = {}
    for name in FUNCTIONS:
        module = importlib.import_module(name)
        for function, each in vars(module).items():
            if function.startswith("_") or getattr(each, "__module__", "") != name or not callable(each):
                continue
            if isinstance(each, type) or str(signature(each).return_annotation) != "Product":
                continue
            kinds = [p.annotation for p in signature(each).parameters.values()]
            if len(kinds) == 2 and kinds[0] in {"Folder", "Store"}:
                found.setdefault(name, set()).add(function)
    assert found == {name: {*functions} for name, functions in FUNCTIONS.items()}
    for module, functions in FUNCTIONS.items():
        for function in functions:
            assert options_of(f"{module}:{function}")


@pytest.mark.parametrize(
    "name",
    [
        "os:system", "antigravity:geohash", "raybundle.cli.main:main", "raybundle.pipeline.store:store_at", "os", "",
        ":", "raybundle.ties.pairs:", "raybundle.ties.pairs:key_of", "raybundle.ties.pairs:compared:x",
        "this:d", "tests.pipeline.graph:os.system",
    ],
)  # fmt: skip
def test_no_other_function_is_called_or_imported(name, monkeypatch):
    def imported(*_):
        raise AssertionError(name)

    monkeypatch.setattr("raybundle.pipeline.tasks.import_module", imported)
    with pytest.raises(TypeError, match=repr(name)):
        function_of(name)


@pytest.mark.parametrize("out", ["s3://bucket/x", "s3://", "gs://b", "https://host/x", "file:///tmp/x", "S3://b/c",
                                 "az://x", "memory://x", "sftp://host/y", "reference::file:///x"])  # fmt: skip
def test_results_are_not_written_to_a_url(tmp_path, out, monkeypatch, capsys):
    monkeypatch.chdir(tmp_path)
    (tmp_path / "photos").mkdir()
    for command in (["orient", "photos", "--out", out], ["calibrate", "photos", "--out", out]):
        assert main(command) == 2
        stated = capsys.readouterr().err
        assert "[folder.url]" in stated
        assert "--store URL" in stated
    assert {p.name for p in tmp_path.iterdir()} == {"photos"}


def test_a_name_with_a_colon_is_no_url(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    for name in ("a:b", "2026-11-28T10:00", "x/s3:/y", str(tmp_path / "s3:/y"), ":"):
        check_place(type(tmp_path)(name))
