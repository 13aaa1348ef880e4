"""A project as one package for deposit."""

import hashlib
import json
import re
import zipfile

import pytest

import raybundle as rb
from raybundle.errors import InputError


def packed(project, photo_folders, **given):
    (project.parent / "x").mkdir(exist_ok=True)
    done = rb.archive(project, project.parent / "x" / "p.zip", **given)
    return done, zipfile.ZipFile(done.file)


def test_a_package_describes_itself_and_its_checksums_hold(project, photo_folders):
    block = rb.read_result(project).block
    o = block.observations
    rb.mark(project, "put", image=block.images.ids[0], point="A", x_px=10.0, y_px=10.0)
    rb.record(project, title="Portal", operator="A. Meier; B. Roth", rights="CC BY 4.0", place="Rom", object="Portal")
    done, package = packed(project, photo_folders)
    assert len(o)
    (notice,) = done.notices
    assert notice.message.code == "deposit.entries_missing"
    assert notice.message.values["names"] == ["archive"]
    names = set(package.namelist())
    assert {"result/result.json", "result/README.txt", "project.toml", "measurements.json"} <= names
    assert not any(n.startswith(("photographs/", "cache/")) for n in names)
    stated = dict(reversed(line.split("  ", 1)) for line in package.read("checksums.sha256").decode().splitlines())
    assert set(stated) == names - {"checksums.sha256"}
    assert all(hashlib.sha256(package.read(n)).hexdigest() == h for n, h in stated.items())
    photographs = package.read("photographs.sha256").decode().splitlines()
    assert len(photographs) == len(block.images)
    graph = {e["@id"]: e for e in json.loads(package.read("ro-crate-metadata.json"))["@graph"]}
    root = graph["./"]
    assert (root["name"], root["license"]) == ("Portal", "CC BY 4.0")
    assert [graph[p["@id"]]["name"] for p in root["author"]] == ["A. Meier", "B. Roth"]
    assert graph["#place"]["name"] == "Rom"
    assert {p["@id"] for p in root["hasPart"]} == names - {"checksums.sha256", "ro-crate-metadata.json"}
    assert all(p["@id"] in graph for p in root["hasPart"])


def test_photographs_that_are_gone_are_named(project, photo_folders):
    first = rb.read_result(project).block.images.file[0]
    (photo_folders[0] / first).unlink()
    file = project / "project.toml"
    file.write_text(re.sub(r'"[^"]*/photos/', f'"{photo_folders[0].as_posix()}/', file.read_text()))
    done, package = packed(project, photo_folders, with_photographs=True)
    found = {n.removeprefix("photographs/") for n in package.namelist() if n.startswith("photographs/")}
    missing = [
        n for m in done.notices if m.message.code == "deposit.photographs_missing" for n in m.message.values["names"]
    ]
    assert first in missing
    assert found.isdisjoint(missing)
    assert len(found) + len(missing) == len(rb.read_result(project).block.images)


@pytest.mark.parametrize(("name", "code"), [("p.tar", "file.suffix"), ("p.zip", "file.exists")])
def test_what_cannot_be_written_is_refused(project, name, code):
    (project.parent / "p.zip").write_bytes(b"somebody's")
    with pytest.raises(InputError) as refused:
        rb.archive(project, project.parent / name)
    assert refused.value.code == code
    assert (project.parent / "p.zip").read_bytes() == b"somebody's"
