"""What is told of files that an earlier run of `surface` left, and which of them stay."""

from types import SimpleNamespace

import pytest

from raybundle.commands.previous_products import note_written, settle_earlier

ONE, OTHER = (SimpleNamespace(clouds=((0, key),)) for key in ("points-1", "points-2"))


@pytest.fixture
def written(tmp_path):
    """A folder with points, LAZ, heights and a PDF of one surface, thinned by 0.02."""
    (tmp_path / "work").mkdir()
    for name in ("points.ply", "points.laz", "heights.tif", "surface.pdf"):
        (tmp_path / name).write_bytes(b"x")
    note_written(ONE, tmp_path / "work", {"", "las", "dsm", "pdf"}, 0.02, "")
    return tmp_path


def settled(folder, surface, thin, wanted=frozenset({""})):
    return settle_earlier(surface, folder, folder / "work", wanted, thin, {"pdf": "surface.pdf"})


def coded(found):
    """Codes and values of what is told."""
    return [(m.code, m.values) for text in found.reported for m in text.messages]


def test_what_is_of_the_same_points_stays(written):
    found = settled(written, ONE, 0.02)
    assert coded(found) == [
        ("surface_remark.earlier", {"names": [name]}) for name in ("heights.tif", "points.laz", "surface.pdf")
    ]
    assert not found.others


@pytest.mark.parametrize("thin", [None, 0.05])
def test_what_was_thinned_otherwise_stays_and_is_told_so(written, thin):
    found = settled(written, ONE, thin)
    lengths = {"length": 0.02, "now": thin or 0.0}
    other = "surface_remark.otherwise_thinned"
    assert coded(found) == [
        ("surface_remark.earlier", {"names": ["heights.tif"]}),  # heights are of all points, however these are thinned
        (other, {"names": ["points.laz"], "setting": "las", **lengths}),
        (other, {"names": ["surface.pdf"], "setting": "pdf", **lengths}),
    ]
    assert found.others == {"points.laz": 0.02, "surface.pdf": 0.02}
    assert (written / "points.laz").exists()


def test_all_points_beside_thinned_ones_are_told_too(written):
    note_written(ONE, written / "work", {"", "las"}, None, "")
    found = settled(written, ONE, 0.1)
    values = {"names": ["points.laz"], "setting": "las", "length": 0.0, "now": 0.1}
    assert ("surface_remark.otherwise_thinned", values) in coded(found)


def test_what_is_of_other_points_is_removed_and_told(written):
    found = settled(written, OTHER, 0.02, wanted=frozenset({"", "dsm"}))
    assert coded(found) == [
        ("surface_remark.removed", {"names": ["points.laz"], "setting": "las"}),
        ("surface_remark.removed", {"names": ["surface.pdf"], "setting": "pdf"}),
    ]
    assert {p.name for p in written.iterdir()} == {"work", "points.ply", "heights.tif"}
