"""Whether two results say the same, and how near."""

import pytest

from raybundle.errors import phrase
from raybundle.report.comparison.sameness import sameness


def test_same_near_and_unlike(tmp_path):
    a, b = tmp_path / "a", tmp_path / "b"
    for folder in (a, b):
        folder.mkdir()
        (folder / "points.csv").write_text("id,x,note\np,1000,\nq,-2,\n")
        (folder / "images.csv").write_text("id,x\ni,3\n")
    (a / "alone.csv").write_text("id\n")
    assert sameness(a, b).sentence == phrase("sameness.all", n=2)
    (b / "points.csv").write_text("id,x,note\np,1000,\nq,-2.00001,\n")
    found = sameness(a, b)
    assert (found.equal, found.tables, found.where) == (1, 2, ("x", "points.csv"))
    assert found.difference == pytest.approx(1e-8, rel=0.01)
    assert found.sentence.message.code == "sameness.some"
    for other in ("id,x,note\np,1000,\n", "id,x,note\np,1000,\nr,-2,\n", "id,x,note\np,1000,wrong\nq,-2,\n"):
        (b / "points.csv").write_text(other)
        assert sameness(a, b).sentence == phrase("sameness.unlike", table="points.csv")
    assert sameness(a, tmp_path / "none").sentence == ""
