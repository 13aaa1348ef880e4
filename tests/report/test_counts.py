"""What was given and what took part: the same numbers on the command line, in the report and in result.json."""

import csv
import json

import pytest

from raybundle.adjustment.evaluation.counts import counts
from raybundle.report.text.summary import details
from raybundle.report.write import write_result
from raybundle.words import headline


@pytest.mark.parametrize("name", ["rich", "rejected", "unused_rows"])
def test_counts_agree_on_the_command_line_in_the_report_and_in_the_result(case, name, tmp_path):
    a = case(name)
    n = counts(a)
    write_result(a, tmp_path / "r")
    with (tmp_path / "r/observations.csv").open(newline="") as file:
        rows = list(csv.DictReader(file))
    left = [r for r in rows if not r["rejected"]]
    with (tmp_path / "r/points.csv").open(newline="") as file:
        points = list(csv.DictReader(file))
    assert (n.image_observations_given, n.image_observations_used) == (len(rows), len(left))
    assert (n.points_given, n.points_used) == (len(points), len({r["point"] for r in left}))
    assert n.images_used == len({r["image"] for r in left})
    assert n.rejected == len(rows) - len(left)

    told = json.loads((tmp_path / "r/result.json").read_text())
    assert [told[k] for k in ("points_count", "points_used", "image_points", "image_points_used", "rejected")] == [
        n.points_given, n.points_used, n.image_observations_given, n.image_observations_used, n.rejected,
    ]  # fmt: skip

    pairs = (
        (n.images_given, n.images_used, "image"), (n.points_given, n.points_used, "object point"),
        (n.image_observations_given, n.image_observations_used, "image observation"),
    )  # fmt: skip
    (line,) = (m.values for m in details(a) if m.code == "summary.counts")
    assert (line["images"], line["points"], line["observations"]) == tuple(used for _, used, _ in pairs)
    assert tuple(line[f"{k}_given"] for k in ("images", "points", "observations")) == tuple(g for g, _, _ in pairs)
    html = (tmp_path / "r/report.html").read_text()
    for given, used, noun in pairs:
        value = headline(
            "result_section.used", {"used": used, "given": given, "rejected": n.rejected * ("obs" in noun)}
        )
        assert f'<td class="l">{noun}s</td><td class="l">{value}' in html.replace("\u00a0", " ")


def test_the_cases_have_something_to_count(case):
    assert counts(case("rejected")).rejected > 0
    n = counts(case("unused_rows"))
    assert n.points_used < n.points_given
