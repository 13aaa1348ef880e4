"""Whether two results say the same, and how near."""

from raybundle.report.sameness import sameness


def test_same_near_and_unlike(tmp_path):
    a, b = tmp_path / "a", tmp_path / "b"
    for folder in (a, b):
        folder.mkdir()
        (folder / "points.csv").write_text("id,x,note\np,1000,\nq,-2,\n")
        (folder / "images.csv").write_text("id,x\ni,3\n")
    (a / "alone.csv").write_text("id\n")
    assert sameness(a, b).sentence == "all 2 tables are the same to the last bit"
    (b / "points.csv").write_text("id,x,note\np,1000,\nq,-2.00001,\n")
    assert sameness(a, b).sentence == (
        "1 of 2 tables are the same to the last bit, all to 1e-08 of the largest number of a column (x of points.csv)"
    )
    for other in ("id,x,note\np,1000,\n", "id,x,note\np,1000,\nr,-2,\n", "id,x,note\np,1000,wrong\nq,-2,\n"):
        (b / "points.csv").write_text(other)
        assert sameness(a, b).sentence == "not the same rows: points.csv"
    assert sameness(a, tmp_path / "none").sentence == ""
