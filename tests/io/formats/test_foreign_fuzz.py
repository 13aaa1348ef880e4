"""Readers of foreign files on damaged input: a block, or an InputError that names the file; never anything else."""

import shutil

import pytest
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st

from raybundle.errors import InputError
from raybundle.io.formats import Export, formats, read_format, write_format
from raybundle.io.formats.base import Import
from raybundle.io.reading.xml import read_xml
from raybundle.planning.simulate import Survey, simulate
from raybundle.planning.synthetic_networks import TargetField, brown_camera, field_scene

BOTH = sorted(n for n, f in formats.items() if f.read and f.write)
PIECES = st.sampled_from(
    [
        b"",
        b"\0",
        b"-1",
        b"1e999",
        b"nan",
        b"NaN",
        b"[]",
        b"{}",
        b"null",
        b'"',
        b"<",
        b"&x;",
        b"\xff\xff\xff\xff\xff\x7f",
    ]
)
DAMAGE = st.lists(
    st.tuples(st.floats(0, 1), st.integers(0, 12), PIECES | st.binary(max_size=9)), min_size=1, max_size=4
)


@pytest.fixture(scope="module")
def folder(tmp_path_factory):
    """One small valid file or folder of each format."""
    camera = brown_camera(values=dict.fromkeys(("K2", "K3", "P1", "P2"), 0.0))
    plan = TargetField(camera=camera, stations=2, frontal=1, rows=2, columns=3)
    block = simulate(field_scene(plan), Survey(control=2, control_sigma=(1.0, 1.0, 1.0))).truth
    top = tmp_path_factory.mktemp("valid")
    for name in BOTH:
        write_format(name, Export(block=block), top / name / f"m{formats[name].suffix}")
    return top


@pytest.mark.parametrize("name", BOTH)
@settings(max_examples=40, deadline=None, suppress_health_check=[HealthCheck.function_scoped_fixture])
@given(which=st.integers(0, 30), damage=DAMAGE)
def test_damaged_files(name, folder, tmp_path, which, damage):
    copy = tmp_path / "copy"
    shutil.rmtree(copy, ignore_errors=True)
    shutil.copytree(folder / name, copy)
    files = sorted(p for p in copy.rglob("*") if p.is_file())
    file = files[which % len(files)]
    data = file.read_bytes()
    for share, length, new in damage:
        at = int(share * len(data))
        data = data[:at] + new + data[at + length :]
    file.write_bytes(data)
    try:
        result = read_format(name, copy / f"m{formats[name].suffix}")
    except InputError as error:
        assert str(copy) in str(error)  # noqa: PT017
    else:
        assert isinstance(result, Import)


@pytest.mark.parametrize(
    ("text", "words"),
    [
        ('<!DOCTYPE a [<!ENTITY b "c">]><document>&b;</document>', r"xml\.doctype"),
        ("<document>" + "<a>" * 200 + "</a>" * 200 + "</document>", r"file\.nested_too_deeply"),
        ("<document><a></document>", r"xml\.invalid"),
        ("<other/>", r"xml\.root_element"),
        ("", r"xml\.invalid"),
    ],
)
def test_xml_is_read_without_document_types(text, words, tmp_path):
    path = tmp_path / "a.xml"
    path.write_text(text)
    with pytest.raises(InputError, match=words) as caught:
        read_xml(path, "document")
    assert caught.value.line == 1


def test_an_opf_project_stays_in_its_folder(folder, tmp_path):
    shutil.copytree(folder / "opf" / "m", tmp_path / "m")
    project = tmp_path / "m" / "project.opf"
    project.write_text(project.read_text().replace("camera-list.json", "../camera-list.json"))
    with pytest.raises(InputError, match=r"opf\.path_outside"):
        read_format("opf", tmp_path / "m")
