"""A desk with photographs and its server, without a network."""

import shutil
from copy import copy
from pathlib import Path

import pytest
from starlette.testclient import TestClient

from raybundle.measuring.session import latest_block
from raybundle.studio.app import Studio
from raybundle.studio.desk import Desk
from raybundle.studio.guard import Session
from tests.once import made_once

PORTAL = Path(__file__).parents[2] / "demo_data" / "portal"
PORT = 8123
BASE = f"http://127.0.0.1:{PORT}"
LIVE = f"ws://127.0.0.1:{PORT}/api/live"


@pytest.fixture(scope="session")
def oriented(tmp_path_factory):
    """The demonstration's photographs, oriented once."""
    from raybundle.commands.orient import orient

    def make(folder):
        shutil.copytree(PORTAL / "photos", folder / "photos")
        orient(sorted((folder / "photos").glob("*.jpg"))[:5], folder / "project", precise=False, report=False)

    return made_once(tmp_path_factory, "portal", make)


@pytest.fixture(scope="session", autouse=True)
def adjusted_once():
    """Adjust what a page finds when it is entered for the first test alone: by the bytes of the block."""
    known, adjusted = {}, Desk.adjusted

    def found(desk, *progress):
        if desk.adjustment is not None:
            return adjusted(desk, *progress)
        files = tuple((p.name, p.read_bytes()) for p in sorted(latest_block(desk.source).iterdir()) if p.is_file())
        if files not in known:
            known[files] = adjusted(desk, *progress)
        return copy(known[files])  # a page may replace what is in it

    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(Desk, "adjusted", found)
        yield


@pytest.fixture
def project(oriented, tmp_path):
    shutil.copytree(oriented, tmp_path / "set")
    return tmp_path / "set" / "project"


@pytest.fixture
def photo_folders(project):
    """Where the photographs of the project lie, beside the places that it names itself."""
    return [project.parent / "photos"]


@pytest.fixture
def desk(project, photo_folders, tmp_path):
    (tmp_path / "tiles").mkdir()
    desk = Desk.open(project, tmp_path / "tiles", photo_folders)
    yield desk
    desk.close()


@pytest.fixture
def studio(desk):
    return Studio.of(desk, Session(port=PORT))


@pytest.fixture
def client(studio):
    """A browser that has entered."""
    with TestClient(studio.app(), base_url=BASE) as client:
        client.get("/", params={"token": studio.session.token})
        client.headers["origin"] = BASE
        studio.work.wait()
        yield client
