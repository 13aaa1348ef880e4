"""Photographs at URLs: the same as in a folder, each fetched once, and one that cannot be got costs that one."""

import threading
from collections import Counter
from functools import partial
from http.server import SimpleHTTPRequestHandler, ThreadingHTTPServer
from pathlib import Path

import numpy as np
import pytest
from tests.messages import refused

from raybundle.errors import code_of
from raybundle.io import object_urls
from raybundle.io.copies import copies_folder
from raybundle.io.photos.photo import find_photos, read_grey, read_photo
from raybundle.io.photos.remote import local_path, remote_files, url_of
from raybundle.matching.methods import feature_method
from raybundle.pipeline.executors import Processes, Threads
from raybundle.pipeline.project import Project
from raybundle.pipeline.stage import Means
from raybundle.ties.points import find_features

pytest.importorskip("fsspec", reason="URLs are an extra")
pytest.importorskip("aiohttp", reason="it brings http to fsspec")
PORTAL = Path(__file__).resolve().parents[3] / "demo_data/portal/photos"


class Handler(SimpleHTTPRequestHandler):
    """Files of a folder; of some names it answers the next requests with an error, or sends half."""

    fails, halves, sent = Counter(), Counter(), Counter()

    def send_head(self):
        name = self.path.rpartition("/")[2]
        if self.fails[name]:
            self.fails[name] -= 1
            self.send_error(503)
            return None
        return super().send_head()

    def copyfile(self, source, out):
        name = self.path.rpartition("/")[2]
        self.sent[name] += 1
        data = source.read()
        if self.halves[name]:
            self.halves[name] -= 1
            data = data[: len(data) // 2]
            self.close_connection = True
        out.write(data)

    def log_message(self, *_):
        pass


@pytest.fixture
def site(tmp_path, monkeypatch):
    """A folder with three photographs, and where a server shows it."""
    folder = tmp_path / "site" / "photos"
    folder.mkdir(parents=True)
    for k in (1, 2, 3):
        (folder / f"portal_{k:02d}.jpg").write_bytes((PORTAL / f"portal_{k:02d}.jpg").read_bytes())
    monkeypatch.setenv("RAYBUNDLE_PRODUCTS", str(tmp_path / "copies"))
    monkeypatch.setattr(object_urls, "PAUSE_S", 0.001)
    for counts in (Handler.fails, Handler.halves, Handler.sent):
        counts.clear()
    server = ThreadingHTTPServer(("127.0.0.1", 0), partial(Handler, directory=str(folder.parent)))
    thread = threading.Thread(target=server.serve_forever)
    thread.start()
    yield folder, f"http://127.0.0.1:{server.server_address[1]}"
    server.shutdown()
    thread.join()
    server.server_close()


def copied():
    return [p for p in copies_folder().rglob("*") if p.is_file() and p.suffix == ".jpg"]


def test_a_folder_a_list_and_files_at_urls_are_those_of_the_folder(site):
    folder, url = site
    here = find_photos([folder])
    (folder / "notes.txt").write_text("no photograph")
    (folder.parent / "list.txt").write_text(f"# of today\nphotos/portal_01.jpg\n\n{url}/photos/portal_03.jpg\n")
    there = find_photos([Path(f"{url}/photos")])
    assert [p.content for p in there.photos] == [p.content for p in here.photos]
    assert [p.metadata for p in there.photos] == [p.metadata for p in here.photos]
    assert [code_of(r) for r in there.remarks if code_of(r).startswith("photo_entry.other")]
    listed = find_photos([Path(f"{url}/list.txt")])
    assert [p.name for p in listed.photos] == ["portal_01.jpg", "portal_03.jpg"]
    assert [p.content for p in find_photos([Path(f"file://{folder}")]).photos] == [p.content for p in here.photos]
    one = find_photos([Path(f"{url}/photos/portal_02.jpg")]).photos[0]
    assert url_of(one.path) == f"{url}/photos/portal_02.jpg"
    assert np.array_equal(read_grey(one), read_grey(here.photos[1]))
    assert Handler.sent["portal_02.jpg"] == 1, "it was fetched once"
    assert len(copied()) == 3


def test_features_of_workers_are_those_of_files(site, tmp_path):
    folder, url = site
    digests = []
    for name, where, executor in (("a", folder, Threads(1)), ("b", Path(f"{url}/photos"), Processes(2))):
        photos = find_photos([where]).photos
        project = Project.open(tmp_path / name)
        try:
            method = feature_method("rootsift")
            means = Means(project=project, executor=executor)
            with project.stage("features"):
                _, lost = find_features(means, photos, method, 500)
            assert not lost
            kept = project.products.keys_of_kind("features")
            digests.append([project.products.place.file(k).read_bytes() for k in kept])
        finally:
            project.close()
    assert digests[0] == digests[1]
    assert len(digests[0]) == 3


def test_faults_are_tried_again_and_then_cost_one_photograph(site):
    folder, url = site
    Handler.fails["portal_01.jpg"] = 4  # fsspec asks twice for what a server knows of a file
    Handler.halves["portal_02.jpg"] = 1
    Handler.fails["portal_03.jpg"] = 10**6
    found = find_photos([Path(f"{url}/photos")])
    assert [p.name for p in found.photos] == ["portal_01.jpg", "portal_02.jpg"]
    ((lost, why),) = found.refused
    assert (lost.name, code_of(why)) == ("portal_03.jpg", "photograph.not_fetched")
    with refused("file.missing"):
        read_photo(Path(f"{url}/photos/none.jpg"))
    with refused("photograph.unknown_scheme"):
        read_photo(Path("reference://x/a.jpg"))
    assert found.photos[1].content == find_photos([folder]).photos[1].content
    # the service is gone between two stages
    (folder / "portal_01.jpg").unlink()
    with refused("file.missing"):
        read_grey(found.photos[0])


def test_a_photograph_that_was_exchanged_is_another(site):
    folder, url = site
    path = Path(f"{url}/photos/portal_01.jpg")
    before = read_photo(path)
    (folder / "portal_01.jpg").write_bytes((PORTAL / "portal_04.jpg").read_bytes())
    with refused("photograph.changed"):
        read_grey(before)
    assert read_photo(path).sha256 == read_photo(PORTAL / "portal_04.jpg").sha256


def test_copies_take_no_more_than_they_may(site, monkeypatch):
    _, url = site
    monkeypatch.setenv("RAYBUNDLE_PRODUCTS_GB", "0.0013")
    photos = find_photos([Path(f"{url}/photos")]).photos
    assert len(photos) == 3
    assert sum(p.stat().st_size for p in copied()) <= 1.3e6
    assert len(read_grey(photos[0]))
    assert Handler.sent["portal_01.jpg"] == 2, "it had made room for others"


def test_paths_that_were_urls():
    assert url_of(Path("s3://bucket/a b/c.jpg")) == "s3://bucket/a b/c.jpg"
    assert url_of(Path("C:/photos")) == url_of(Path("/a:/b")) == url_of(Path("a/b.jpg")) == ""
    assert local_path(Path("file:///a/b.jpg")) == Path("/a/b.jpg")
    assert local_path(Path("a/b.jpg")) == Path("a/b.jpg")


def test_an_object_store_is_listed():
    import fsspec

    fs = fsspec.filesystem("memory")
    fs.pipe_file("/photos-here/a.jpg", (PORTAL / "portal_01.jpg").read_bytes())
    fs.pipe_file("/photos-here/list.txt", b"a.jpg\n")
    try:
        assert remote_files(Path("memory://photos-here/list.txt")) == [Path("memory:/photos-here/a.jpg")]
        assert read_photo(Path("memory://photos-here/a.jpg")).sha256 == read_photo(PORTAL / "portal_01.jpg").sha256
    finally:
        fs.rm("/photos-here", recursive=True)


def test_a_project_is_in_a_folder(tmp_path):
    with refused("project.at_url"):
        Project.open(Path("s3://bucket/project"))
