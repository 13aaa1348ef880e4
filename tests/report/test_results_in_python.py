"""A result as Python and notebooks see it: lines, tables, pictures, pages."""

import copy
import pickle
import re
import sys
import xml.etree.ElementTree as ET
from dataclasses import fields, is_dataclass, replace
from types import ModuleType

import numpy as np
import pytest

import raybundle as rb
from raybundle.adjustment.evaluation.queries import covariance_between
from raybundle.adjustment.records.notice import Notice
from raybundle.commands.show import show
from raybundle.errors import InputError, phrase
from raybundle.planning.simulate import Survey, simulate
from raybundle.planning.synthetic_networks import TargetField, field_scene
from raybundle.report.parts import Figures
from raybundle.report.sections.network import network_section
from raybundle.report.single_figure import svg_of
from raybundle.report.tables import table, table_names
from raybundle.report.view import view_of
from raybundle.results.tables import result_tables


@pytest.fixture(scope="module")
def result():
    scene = field_scene(TargetField(rows=4, columns=5, stations=4, frontal=1))
    near = {"points": "exact", "orientation": "exact", "interior": "exact"}
    return rb.adjust(simulate(scene, Survey(scale_bars=2, **near)).observed)


def test_a_result_is_plain_data(result):
    for again in (pickle.loads(pickle.dumps(result)), copy.deepcopy(result)):  # noqa: S301
        assert again.sigma0 == result.sigma0
        np.testing.assert_array_equal(again.precision.object_points, result.precision.object_points)
        assert again.handle.work is None
        with pytest.raises(InputError, match=r"adjustment\.no_statistics"):
            covariance_between(again, "point:1", "point:2")
    assert result.handle.work is not None  # whoever copies it takes nothing from it
    assert len(pickle.dumps(result)) < 400_000


def test_nothing_of_a_solver_stands_in_it_but_behind_its_handle(result):
    def modules(value, seen):
        if id(value) in seen or not is_dataclass(value):
            return
        seen.add(id(value))
        yield type(value).__module__
        for f in fields(value):
            yield from modules(getattr(value, f.name), seen)

    assert not {m for m in modules(result, set()) if m.endswith(("work", "normals", "assemble", "solve"))}


def test_it_shows_itself(result):
    line = repr(result)
    assert re.match(r"<Adjustment 'testfield', 5 .* 16 .* sigma0 ", line)
    assert "\n" not in line
    odd = replace(result, notices=(Notice(code="x", message="<script>alert(1)</script>"),) * 9)
    page = odd._repr_html_()
    assert "<script>" not in page
    assert "&lt;script&gt;" in page
    c = result.interior[0].parameters["c"]
    assert f"{c.value:.6g}" in page
    assert repr(result.given).startswith("<Block 'testfield', ")
    assert "2 distances" in repr(result.given)


def test_tables_are_those_of_the_result_folder(result, tmp_path):
    rb.write_result(result, tmp_path / "result", report="none")
    for name in table_names(result):
        found = table(result, name)
        columns = result_tables(result)[name]
        header = (tmp_path / "result" / f"{name}.csv").read_text(encoding="utf-8").splitlines()
        assert list(found.dtype.names) == header[0].split(",")
        assert len(found) == len(header) - 1 == len(next(iter(columns.values())))
    points = table(result, "points")
    np.testing.assert_array_equal(points["sX"], result.precision.object_point_std[:, 0])
    with pytest.raises(InputError, match=r"report\.no_table"):
        table(result, "pints")
    with pytest.raises(InputError, match=r"value\.not_one_of"):
        table(result, "points", to="excel")


@pytest.mark.parametrize("library", ["pandas", "polars"])
def test_data_frames_where_a_library_is_there(result, library, monkeypatch):
    stand_in = ModuleType(library)
    stand_in.DataFrame = dict
    monkeypatch.setitem(sys.modules, library, stand_in)
    frame = table(result, "points", to=library)
    assert frame["point"] == list(result.given.points.ids)
    monkeypatch.setitem(sys.modules, library, None)
    with pytest.raises(InputError, match=r"package\.tables_missing"):
        table(result, "points", to=library)


def test_a_figure_of_the_report_stands_alone(result):
    found = [f for part in network_section(view_of(result)).parts if isinstance(part, Figures) for f in part.figures]
    assert len(found) > 3
    for figure in found:
        assert ET.fromstring(svg_of(figure)).tag == "{http://www.w3.org/2000/svg}svg"  # noqa: S314


def test_a_page_is_written_and_opened(result, tmp_path, monkeypatch):
    opened = []
    monkeypatch.delitem(sys.modules, "ipykernel", raising=False)  # of the tests of notebooks
    monkeypatch.setattr("webbrowser.open", opened.append)
    page = show(result, tmp_path / "report.html")
    assert opened == [(tmp_path / "report.html").resolve().as_uri()]
    assert "iframe" in page._repr_html_()
    network = show(result, what="network")
    assert network.path.name == "network.html"
    assert phrase("network_page.title", name="testfield") in network.path.read_text(encoding="utf-8")
    monkeypatch.setitem(sys.modules, "ipykernel", ModuleType("ipykernel"))
    show(result, tmp_path / "again.html")
    assert len(opened) == 2  # a notebook shows it within itself


def test_an_adjustment_without_statistics_shows_itself_too(result):
    plain = rb.adjust(result.given, rb.AdjustmentOptions(statistics=False))
    assert "sigma0" in repr(plain)
    assert plain._repr_html_()
    assert np.isnan(table(plain, "points")["sX"]).all()
