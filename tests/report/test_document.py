"""The report: whole, self-contained, escaped, bounded, for every state of a result."""

import re
import time
from dataclasses import replace
from html.parser import HTMLParser

import numpy as np
import pytest

from raybundle.io.block.folder import read_block
from raybundle.report.parts import MOST_ROWS
from raybundle.report.sections.control import control_section
from raybundle.report.sections.tables import tables_section
from raybundle.report.text.numbers import fixed, grouped, significant
from raybundle.report.view import view_of
from raybundle.report.writing import write_report
from raybundle.words import headline
from raybundle.workflows.adjust import adjust
from tests.report.conftest import HOSTILE

SECTIONS = (
    "front", "result", "summary", "accuracy", "precision", "control", "interior", "residuals", "reliability", "network",
    "tables", "provenance",
)  # fmt: skip
VOID = {"meta", "br", "rect", "path", "circle", "ellipse", "hr", "input", "link", "img"}


class Checked(HTMLParser):
    """Collects text and attributes, and insists on balanced tags."""

    def __init__(self):
        super().__init__()
        self.open, self.text, self.attributes, self.ids = [], [], [], []

    def handle_starttag(self, tag, attrs):
        self.attributes += [(tag, k, v or "") for k, v in attrs]
        self.ids += [v for k, v in attrs if k == "id"]
        if tag not in {"meta", "br", "hr", "input", "link", "img"}:
            self.open.append(tag)

    def handle_startendtag(self, tag, attrs):
        self.attributes += [(tag, k, v or "") for k, v in attrs]

    def handle_endtag(self, tag):
        assert self.open.pop() == tag

    def handle_data(self, data):
        self.text.append(data if not self.open or self.open[-1] != "style" else "")


def parsed(html):
    parser = Checked()
    parser.feed(html)
    parser.close()
    assert not parser.open
    return parser


def report(adjustment, folder):
    write_report(adjustment, folder / "report.html")
    return (folder / "report.html").read_text(encoding="utf-8")


def test_every_state_gives_a_whole_page(any_case, tmp_path):
    page = parsed(report(any_case, tmp_path))
    assert [i for i in page.ids if i in SECTIONS] == list(SECTIONS)
    text = " ".join(page.text)
    assert not re.search(r"\b(nan|inf|None|NaN)\b", text)
    numbers = [
        v for _, k, v in page.attributes if k in {"d", "x", "y", "width", "height", "transform", "r", "rx", "ry"}
    ]
    assert numbers
    assert not [v for v in numbers if re.search(r"nan|inf", v)]


def test_nothing_is_fetched_from_elsewhere(any_case, tmp_path):
    html = report(any_case, tmp_path)
    page = parsed(html)
    links = [v for tag, k, v in page.attributes if k in {"href", "src", "srcset", "data", "action", "xlink:href"}]
    assert links
    assert all(v.startswith("#") for v in links)
    assert "@import" not in html
    assert not re.search(r"url\((?!#)", html)
    assert not {tag for tag, _, _ in page.attributes} & {"script", "iframe", "object", "embed", "img", "link"}


def test_links_of_the_contents_lead_somewhere(case, tmp_path):
    page = parsed(report(case("rich"), tmp_path))
    targets = [v[1:] for tag, k, v in page.attributes if (tag, k) == ("a", "href")]
    # its projection centres are observed
    assert {*SECTIONS, "trajectories", "specialist", "appendix"} <= set(targets)
    assert set(targets) <= set(page.ids)
    first = targets.index("specialist")
    assert targets[first : first + 3] == ["specialist", "result", "summary"]


def test_ids_are_unique(case, tmp_path):
    page = parsed(report(case("rich"), tmp_path))
    assert len(page.ids) == len(set(page.ids))


def test_names_cannot_break_out(case, tmp_path):
    html = report(case("hostile"), tmp_path)
    assert "<script" not in html
    assert HOSTILE in " ".join(parsed(html).text)


def test_the_numbers_of_the_result_stand_in_the_report(case, tmp_path):
    a = case("rich")
    text = " ".join(parsed(report(a, tmp_path)).text)
    assert significant(a.sigma0, 5) in text
    assert f"redundancy {grouped(a.redundancy)}" in text
    c = a.interior[0].parameters["c"]
    assert fixed(c.value, 4 if c.std < 0.001 else 3)[:6] in text
    for g in a.groups:
        assert all(i in text for i in g.ids)
    assert all(a.given.points.ids[int(i)] in text for i in np.flatnonzero(a.given.points.role == 2))


def test_rejected_observations_are_listed_with_their_reasons(case, tmp_path):
    a = case("rejected")
    text = " ".join(parsed(report(a, tmp_path)).text)
    reasons = [str(r) for r in a.image_observations.rejected if r]
    assert reasons
    assert all(r in text for r in reasons)


def test_suspects_are_listed(case, tmp_path):
    text = " ".join(parsed(report(case("strange_numbers"), tmp_path)).text)
    assert headline("report_reliability.suspects", {}) in text
    assert "0.97" in text


def test_points_held_have_no_sigma(case, tmp_path):
    text = " ".join(parsed(report(case("resection"), tmp_path)).text)
    assert headline("report_network.all_held", {}) in text


def test_long_tables_are_cut_and_say_so(case):
    a = case("free")
    n = 3 * MOST_ROWS
    points = a.adjusted.points
    take = np.arange(n) % len(points)
    many = replace(
        points,
        ids=tuple(f"p{k}" for k in range(n)),
        role=points.role[take],
        xyz=points.xyz[take],
        sigma=points.sigma[take],
    )
    view = view_of(a)
    std = np.full((n, 3), 0.1)
    block = replace(a.adjusted, points=many)
    bigger = replace(
        view,
        adjustment=replace(a, adjusted=block, given=block, network=None),
        std=std,
        rays=np.full(n, 3.0),
    )
    folded = tables_section(bigger).parts[0]
    table = folded.parts[0]
    assert len(table.rows) == MOST_ROWS
    assert "points.csv" in table.note


def test_progress_is_told(case, tmp_path):
    told = []
    write_report(case("free"), tmp_path / "r.html", lambda stage, share: told.append((stage, share)))
    assert told[0][1] == 0.0
    assert told[-1] == ("report", 1.0)
    assert [s for _, s in told] == sorted(s for _, s in told)


def test_the_same_result_gives_the_same_page(case, tmp_path):
    def undated(html):
        return re.sub(r"\d{4}-\d\d-\d\d \d\d:\d\d", "", html)

    assert undated(report(case("rich"), tmp_path)) == undated(report(case("rich"), tmp_path))


@pytest.mark.data
@pytest.mark.parametrize("name", ["camcal21", "prague-s1", "sxb", "rc30-pair"])
def test_public_blocks(blocks, name, tmp_path):
    a = adjust(read_block(blocks / name))
    text = " ".join(parsed(report(a, tmp_path)).text)
    assert significant(a.sigma0, 5) in text


@pytest.mark.data
@pytest.mark.long
def test_a_large_block_is_reported_quickly_and_briefly(blocks, tmp_path):
    a = adjust(read_block(blocks / "roma"))
    began = time.process_time()
    write_report(a, tmp_path / "roma.html")
    assert time.process_time() - began < 4.0
    assert (tmp_path / "roma.html").stat().st_size < 6e6
    assert "of 26\u202f321 points" in (tmp_path / "roma.html").read_text(encoding="utf-8")


def test_long_groups_of_observations_are_folded_below_their_largest(case):
    a = case("rich")
    stations = next(g for g in a.groups if g.kind == "station")
    times = np.arange(4 * len(stations.ids)) % len(stations.ids)
    arrays = (
        "item",
        "quantity",
        "given",
        "sigma",
        "adjusted",
        "adjusted_std",
        "residual",
        "redundancy",
        "w",
        "t",
        "mdb",
        "square",
    )
    longer = replace(
        stations,
        ids=tuple(f"{stations.ids[k]}/{n}" for n, k in enumerate(times)),
        component=tuple(stations.component[k] for k in times),
        **{name: getattr(stations, name)[times] for name in arrays},
    )
    parts = control_section(view_of(replace(a, groups=(longer,)))).parts
    tables = [p for p in parts if p.kind == "table" and p.caption == headline("report_control.largest_rows", {})]
    assert len(tables) == 1
    shown = [float(row[8].replace("−", "-")) for row in tables[0].rows]
    assert abs(shown[0]) == pytest.approx(np.nanmax(np.abs(longer.w)), abs=0.005)
    assert [abs(w) for w in shown] == sorted((abs(w) for w in shown), reverse=True)
    folded = [p for p in parts if p.kind == "folded"]
    assert len(folded[0].parts[0].rows) == len(times)
