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
from raybundle.adjustment.records.notice import Notice
from raybundle.block.rigs import without_rigs
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
from tests.truth.mixed_blocks import ikonos_pair, two_camera_rig


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
            again.covariance("point:1", "point:2")
    assert result.handle.work is not None  # whoever copies it takes nothing from it
    assert len(pickle.dumps(result)) < 400_000


def test_matrices_of_poses_bring_points_into_the_axes_of_opencv(result):
    poses, camera = result.poses(), result.adjusted.cameras[0]
    T, X = poses.matrices[2], result.points().xyz
    x, y, z = (X @ T[:3, :3].T + T[:3, 3]).T
    P = (X - poses.centre[2]) @ poses.rotation[2].T
    assert camera.values["c"] > 0
    np.testing.assert_allclose([x, -y, -z], P.T, atol=1e-12)
    assert (z > 0).all()


def test_arrays_have_the_covariances_of_the_result(result):
    poses, points, (camera,) = result.poses(), result.points(), result.cameras()
    for C, name in (
        (poses.covariance[1], f"image:{poses.ids[1]}"), (points.covariance[3], f"point:{points.ids[3]}"),
    ):  # fmt: skip
        np.testing.assert_allclose(result.covariance(name), C, rtol=1e-6, atol=1e-9 * np.abs(C).max())
    free = [camera.symbols.index(s) for s in result.interior[0].free]
    inner = camera.covariance[np.ix_(free, free)]
    np.testing.assert_allclose(result.covariance("camera:1"), inner, rtol=1e-6, atol=1e-9 * np.abs(inner).max())
    assert not np.delete(camera.covariance, free, axis=0).any()
    np.testing.assert_allclose(result.covariance("camera:1", "point:3"), result.covariance("point:3", "camera:1").T)


def test_matrices_of_a_rig_are_those_of_its_cameras(tmp_path):
    found = rb.adjust(two_camera_rig())
    poses, alone = found.poses(), without_rigs(found.adjusted).images
    np.testing.assert_array_equal(poses.centre[0], poses.centre[1])
    P = (found.points().xyz[3] - alone.centre[1]) @ alone.rotation[1].T
    np.testing.assert_allclose(
        (poses.matrices[1] @ [*found.points().xyz[3], 1.0])[:3], P * [1.0, -1.0, -1.0], atol=1e-12
    )
    assert np.linalg.norm(alone.centre[1] - alone.centre[0]) > 0.3


def test_scenes_and_images_without_rays_have_no_pose():
    assert np.isnan(rb.adjust(ikonos_pair()).poses().matrices[:, :3]).all()
    block = simulate(field_scene(TargetField(rows=4, columns=5, stations=6, frontal=1)), Survey(scale_bars=2)).observed
    o = block.observations
    lost = rb.adjust(replace(block, observations=o.rows(o.image != 2))).poses()
    assert np.isnan(lost.centre[2]).all()
    assert np.isnan(lost.covariance[2]).all()
    assert np.isfinite(lost.matrices[[0, 1, 3]]).all()


def test_columns_of_arrays_have_their_units(result):
    poses = result.poses().table("numpy")
    assert poses.dtype.names == (
        "image", "X_m", "Y_m", "Z_m", "omega_deg", "phi_deg", "kappa_deg",
        "sX_m", "sY_m", "sZ_m", "somega_deg", "sphi_deg", "skappa_deg",
    )  # fmt: skip
    images = table(result, "images")
    np.testing.assert_allclose(poses["skappa_deg"], images["skappa_deg"])
    points, same = result.points().table("numpy"), table(result, "points")
    np.testing.assert_array_equal(points["sZ_m"], same["sZ"])
    camera = result.cameras().table("numpy")
    assert camera["value"][camera["parameter"] == "c"] == result.interior[0].parameters["c"].value
    free = replace(result, datum_defect=("scale",), given=replace(result.given, nominal_scale=None))
    assert "X" in free.points().table("numpy").dtype.names
    with pytest.raises(InputError, match=r"value\.not_one_of"):
        result.points().table("excel")


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
