"""Whether two results say the same, and how near."""

import pytest

from raybundle.report.sameness import sameness


def test_same_near_and_unlike(tmp_path):
    a, b = tmp_path / "a", tmp_path / "b"
    for folder in (a, b):
        folder.mkdir()
        (folder / "points.csv").write_text("id,x,note\np,1000,\nq,-2,\n")
        (folder / "images.csv").write_text("id,x\ni,3\n")
    (a / "alone.csv").write_text("id\n")
    found = sameness(a, b).sentence.message
    assert found.code == "comparison.same_tables"
    assert (found.values["n"], found.values["equal"], found.values["difference"]) == (2, 2, 0)
    (b / "points.csv").write_text("id,x,note\np,1000,\nq,-2.00001,\n")
    values = sameness(a, b).sentence.message.values
    assert (values["n"], values["equal"], values["where"]) == (2, 1, "x of points.csv")
    assert values["difference"] == pytest.approx(1e-8)
    for other in ("id,x,note\np,1000,\n", "id,x,note\np,1000,\nr,-2,\n", "id,x,note\np,1000,wrong\nq,-2,\n"):
        (b / "points.csv").write_text(other)
        found = sameness(a, b).sentence.message
        assert (found.code, found.values) == ("comparison.other_rows", {"table": "points.csv"})
    assert sameness(a, tmp_path / "none").sentence == ""
