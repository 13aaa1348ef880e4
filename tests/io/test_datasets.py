"""Public sets: listed with check sums, fetched, continued, and refused where they differ."""

import hashlib
import os
import re
import threading
from http.server import BaseHTTPRequestHandler, ThreadingHTTPServer
from pathlib import Path
from urllib.parse import unquote

import numpy as np
import pytest

from raybundle.cli.main import main
from raybundle.errors import InputError
from raybundle.io import datasets
from raybundle.io.datasets import Dataset, SetFile, fetch, known_datasets

DATA = Path(os.environ.get("RAYBUNDLE_DATA", Path(__file__).resolve().parents[3] / "shared/data"))
CONTENT = {
    "images/a 1.jpg": np.random.default_rng(1).bytes(700_000),
    "images/b.jpg": np.random.default_rng(2).bytes(300_000),
    "readme.txt": b"a text",
}


class Handler(BaseHTTPRequestHandler):
    """Serves the server's `content`; breaks off after `stop_after` bytes; knows ranges or not."""

    def log_message(self, *_):
        pass

    def do_GET(self):
        server = self.server
        name = unquote(self.path[1:])
        begin = int(re.sub(r"\D", "", self.headers.get("Range", "0")) or 0) if server.ranges else 0
        server.asked.append((name, begin))
        data = server.content.get(name)
        if data is None:
            self.send_error(404)
            return
        if begin >= len(data):
            self.send_error(416)
            return
        self.send_response(206 if begin else 200)
        self.send_header("Content-Length", str(len(data) - begin))
        self.end_headers()
        self.wfile.write(data[begin:][: server.stop_after])


@pytest.fixture
def server():
    with ThreadingHTTPServer(("127.0.0.1", 0), Handler) as running:
        running.content, running.asked, running.ranges, running.stop_after = dict(CONTENT), [], True, None
        thread = threading.Thread(target=running.serve_forever, kwargs={"poll_interval": 0.01})
        thread.start()
        yield running
        running.shutdown()
        thread.join()


def dataset_at(port):
    listed = tuple(
        SetFile(path=name, size=len(data), sha256=hashlib.sha256(data).hexdigest()) for name, data in CONTENT.items()
    )
    return Dataset(
        name="small", about="two photographs", source="https://example.org/small", base=f"http://127.0.0.1:{port}/",
        licence="CC0", cite="", files=listed,
    )  # fmt: skip


@pytest.fixture
def small(server):
    return dataset_at(server.server_port)


def is_whole(folder):
    found = {p.relative_to(folder).as_posix(): p.read_bytes() for p in folder.rglob("*") if p.is_file()}
    return found == CONTENT


def test_a_set_arrives_whole_with_progress_and_is_not_fetched_twice(small, server, tmp_path):
    told = []
    done = fetch(small, tmp_path / "s", progress=lambda _, share: told.append(share))
    assert (done.there, done.fetched) == (0, 3)
    assert is_whole(tmp_path / "s")
    assert told == sorted(told)
    assert told[-1] == 1.0
    assert len(told) > 4
    server.asked.clear()
    assert fetch(small, tmp_path / "s").there == 3
    assert server.asked == []


def test_a_fetch_that_broke_continues_where_it_stopped(small, server, tmp_path):
    server.stop_after = 500_000
    with pytest.raises(InputError, match=r"dataset\.connection_ended"):
        fetch(small, tmp_path)
    part = tmp_path / "images/a 1.jpg.part"
    assert part.stat().st_size == 500_000
    assert not (tmp_path / "images/a 1.jpg").exists()
    server.stop_after = None
    server.asked.clear()
    fetch(small, tmp_path)
    assert server.asked[0] == ("images/a 1.jpg", 500_000)
    assert is_whole(tmp_path)


@pytest.mark.parametrize("wrong", [b"something else", b"x" * 700_000, CONTENT["images/a 1.jpg"] + b"more"])
def test_a_wrong_beginning_is_fetched_anew(small, tmp_path, wrong):
    part = tmp_path / "images/a 1.jpg.part"
    part.parent.mkdir()
    part.write_bytes(wrong)
    fetch(small, tmp_path)
    assert is_whole(tmp_path)


def test_a_server_without_ranges_sends_all_again(small, server, tmp_path):
    server.ranges = False
    (tmp_path / "images").mkdir()
    (tmp_path / "images/a 1.jpg.part").write_bytes(CONTENT["images/a 1.jpg"][:1000])
    fetch(small, tmp_path)
    assert is_whole(tmp_path)


def test_a_file_that_was_changed_is_replaced(small, tmp_path):
    fetch(small, tmp_path)
    (tmp_path / "readme.txt").write_bytes(b"b text")
    done = fetch(small, tmp_path)
    assert (done.there, done.fetched) == (2, 1)
    assert is_whole(tmp_path)


@pytest.mark.parametrize("data", [b"a tale", b"a", b"a text and more"])
def test_what_differs_from_its_check_sum_is_not_kept(small, server, tmp_path, data):
    server.content["readme.txt"] = data
    with pytest.raises(InputError, match=r"dataset\.checksum|dataset\.connection_ended"):
        fetch(small, tmp_path)
    assert not (tmp_path / "readme.txt").exists()


def test_a_file_that_is_gone_is_named(small, server, tmp_path):
    del server.content["images/b.jpg"]
    with pytest.raises(InputError, match=r"b\.jpg.*404.*dataset\.server_answer") as caught:
        fetch(small, tmp_path)
    assert caught.value.exit_status == 2
    assert (tmp_path / "images/a 1.jpg").exists()


def test_without_a_network_the_message_says_what_to_do(monkeypatch, capsys, tmp_path):
    with ThreadingHTTPServer(("127.0.0.1", 0), Handler) as closed:
        port = closed.server_port
    monkeypatch.setattr(datasets, "known_datasets", lambda _listing: {"small": dataset_at(port)})
    assert main(["datasets", "get", "small", "--out", str(tmp_path / "s")]) == 2
    told = capsys.readouterr()
    assert "licence: CC0" in told.out
    assert "[dataset.no_connection]" in told.err
    assert "Traceback" not in told.err


def test_a_folder_that_cannot_be_made_is_named(small, tmp_path):
    (tmp_path / "images").write_text("a file")
    with pytest.raises(InputError, match=r"file\.not_writable"):
        fetch(small, tmp_path)


def test_the_command_fetches(small, monkeypatch, capsys, tmp_path):
    monkeypatch.setattr(datasets, "known_datasets", lambda _listing: {"small": small})
    monkeypatch.chdir(tmp_path)
    assert main(["datasets", "get", "small"]) == 0
    assert "3 files" in capsys.readouterr().out
    assert is_whole(tmp_path / "small")
    assert main(["datasets", "get", "large"]) == 2
    assert "[dataset.unknown]" in capsys.readouterr().err


LISTING = """[one]
about = "a"
source = "https://example.org"
base = "https://example.org/"
licence = "CC0"
files = [["images/a.jpg", 12, "{digest}"]]
"""


@pytest.mark.parametrize(
    ("old", "new", "words"),
    [
        ("images/a.jpg", "../a.jpg", "dataset.path_outside"),
        ("images/a.jpg", "/a.jpg", "dataset.path_outside"),
        ("images/a.jpg", "C:\\\\..\\\\a.jpg", "dataset.path_outside"),
        ('["images/a.jpg", 12', '["b", 1, "{digest}"], ["b", 12', "name.twice"),
        ("12", "0", "value.not_whole"),
        ("12, ", "", "dataset.file_entry"),
        ("{digest}", "{digest}0", "dataset.no_sha256"),
        ("https://example.org/", "file:///etc/", "dataset.address"),
        ("[one]", '["../one"]', "dataset.name"),
        ('licence = "CC0"', "", "value.key_missing"),
        ('about = "a"', "about = 3", "value.no_text"),
        ("[one]", "[one", "toml.invalid"),
    ],
)
def test_a_listing_of_ones_own_is_checked(tmp_path, capsys, old, new, words):
    path = tmp_path / "l.toml"
    path.write_text(LISTING.format(digest="0" * 64))
    assert list(known_datasets(path)) == ["one"]
    assert main(["datasets", "list", "--listing", str(path)]) == 0
    assert "licence: CC0" in capsys.readouterr().out
    path.write_text(LISTING.replace(old, new, 1).format(digest="0" * 64))
    with pytest.raises(InputError, match=re.escape(words)) as caught:
        known_datasets(path)
    assert "l.toml" in str(caught.value)
    assert main(["datasets", "get", "one", "--listing", str(path), "--out", str(tmp_path / "o")]) == 2
    assert not (tmp_path / "o").exists()


def test_the_table_of_sets_is_sound(capsys):
    known = known_datasets()
    assert {"sceaux-castle", "fountain-p11", "copr-uav"} <= set(known)
    for one in known.values():
        assert one.base.startswith("https://")
        assert one.base.endswith("/")
        assert re.search(r"/[0-9a-f]{40}/", one.base), "files at one commit"
        assert one.licence
        paths = [f.path for f in one.files]
        assert len(set(paths)) == len(paths) > 5
        for f in one.files:
            assert not f.path.startswith("/")
            assert ".." not in f.path
            assert re.fullmatch("[0-9a-f]{64}", f.sha256)
            assert f.size > 0
    assert main(["datasets", "list"]) == 0
    out = capsys.readouterr().out
    assert all(name in out for name in known)


def test_the_check_sums_are_those_of_the_files():
    photo_sets = DATA / "photos"
    if not photo_sets.is_dir():
        pytest.skip("no public data: set RAYBUNDLE_DATA to the folder that holds photos/")
    for name in ("sceaux-castle", "fountain-p11"):
        one = known_datasets()[name]
        here = [f for f in one.files if f.path.startswith("images/") and (photo_sets / name / f.path).exists()]
        assert len(here) >= 11
        f = here[3]
        data = (photo_sets / name / f.path).read_bytes()
        assert (len(data), hashlib.sha256(data).hexdigest()) == (f.size, f.sha256)
