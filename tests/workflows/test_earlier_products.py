"""What is told of files that an earlier run of `surface` left, and which of them stay."""

from types import SimpleNamespace

import pytest

from raybundle.commands.earlier_products import note_written, settle_earlier

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


def test_what_is_of_the_same_points_stays(written):
    found = settled(written, ONE, 0.02)
    assert [t.partition(": ")[2] for t in found.told] == ["of an earlier run, of the same points"] * 3
    assert not found.others


@pytest.mark.parametrize(("thin", "now"), [(None, "with all points"), (0.05, "thinned by 0.05")])
def test_what_was_thinned_otherwise_stays_and_is_told_so(written, thin, now):
    found = settled(written, ONE, thin)
    assert found.told == (
        "heights.tif: of an earlier run, of the same points",  # heights are of all points, however these are thinned
        f"points.laz: of an earlier run, thinned by 0.02, beside points.ply {now}; made alike with las=",
        f"surface.pdf: of an earlier run, thinned by 0.02, beside points.ply {now}; made alike with pdf=",
    )
    assert found.others == {"points.laz": "thinned by 0.02", "surface.pdf": "thinned by 0.02"}
    assert (written / "points.laz").exists()


def test_all_points_beside_thinned_ones_are_told_too(written):
    note_written(ONE, written / "work", {"", "las"}, None, "")
    found = settled(written, ONE, 0.1)
    assert "points.laz: of an earlier run, with all points, beside points.ply thinned by 0.1; made alike with las=" in (
        found.told
    )


def test_what_is_of_other_points_is_removed_and_told(written):
    found = settled(written, OTHER, 0.02, wanted=frozenset({"", "dsm"}))
    assert found.told == (
        "points.laz: removed, it was of other points; ask for it with las=",
        "surface.pdf: removed, it was of other points; ask for it with pdf=",
    )
    assert {p.name for p in written.iterdir()} == {"work", "points.ply", "heights.tif"}
