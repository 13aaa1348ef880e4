"""Figures of matplotlib: what they show is what the report shows, and they are a programmer's to change."""

import io
import itertools
import json
import pickle
import subprocess
import sys
import textwrap
import xml.etree.ElementTree as ET
from dataclasses import replace

import numpy as np
import pytest

import raybundle as rb
from raybundle.adjustment.engine import adjust_block
from raybundle.adjustment.evaluation.cell_means import cell_means
from raybundle.errors import InputError, phrase
from raybundle.planning.simulate import Survey, simulate
from raybundle.planning.synthetic_networks import AerialStrips, SinglePhoto, aerial_scene, single_scene
from raybundle.report.detectable import detectable
from raybundle.report.figures.distortion import balanced, radial_curve
from raybundle.report.network.shape import ellipse_rows, ellipses, network_shape
from raybundle.report.residuals import normalised
from raybundle.report.view import adjusted_interior, view_of
from tests.report.conftest import MAKERS, made
from tests.report.test_sections_of_sensors import noisy, room, scenes

pytest.importorskip("matplotlib")
from matplotlib.collections import EllipseCollection, LineCollection, QuadMesh
from matplotlib.figure import Figure
from matplotlib.quiver import Quiver
from matplotlib.text import Text

NAMES = ("network", "residuals", "interior", "reliability", "control")
EXACT = {"orientation": "exact", "points": "exact", "interior": "exact"}


def plot(name, result, **given):
    return getattr(rb, f"plot_{name}")(result, **given)


@pytest.fixture(scope="module")
def rich():
    return made("rich")


def overlapping(figure, monkeypatch):
    """Pairs of texts that are drawn and cover each other."""
    drawn, draw = {}, Text.draw

    def watched(self, renderer):
        if self.get_visible() and self.get_text().strip():
            drawn[id(self)] = (self.get_text(), self.get_window_extent(renderer))
        draw(self, renderer)

    with monkeypatch.context() as m:
        m.setattr(Text, "draw", watched)
        figure.canvas.draw()
    assert len(drawn) > 10
    return [
        (a, b) for (a, x), (b, y) in itertools.combinations(drawn.values(), 2)
        if min(x.x1, y.x1) - max(x.x0, y.x0) > 2 and min(x.y1, y.y1) - max(x.y0, y.y0) > 2
    ]  # fmt: skip


@pytest.mark.parametrize("name", NAMES)
def test_a_figure_is_one_of_matplotlib_and_needs_no_window(rich, name, tmp_path, monkeypatch):
    loaded = "matplotlib.pyplot" in sys.modules  # as by a notebook that was run before in this process
    figure = plot(name, rich)
    assert isinstance(figure, Figure)
    assert figure.axes
    for kind in ("svg", "png", "pdf"):
        figure.savefig(tmp_path / f"figure.{kind}")
    assert ET.parse(tmp_path / "figure.svg").getroot().tag.endswith("svg")  # noqa: S314
    assert overlapping(figure, monkeypatch) == []
    assert ("matplotlib.pyplot" in sys.modules) == loaded
    figure.axes[0].set_title("mine")
    again = pickle.loads(pickle.dumps(figure))  # noqa: S301
    assert again.axes[0].get_title() == "mine"


@pytest.mark.parametrize("name", NAMES)
def test_a_notebook_shows_it_without_pyplot(rich, name):
    data, shown = plot(name, rich)._repr_png_()
    assert data.startswith(b"\x89PNG")
    assert 300 < shown["width"] < 1400


@pytest.mark.parametrize("maker", MAKERS)
@pytest.mark.parametrize("name", NAMES)
def test_every_adjustment_is_drawn_or_says_why_not(maker, name):
    try:
        figure = plot(name, made(maker))
    except InputError as error:
        assert len(str(error)) > 40  # noqa: PT017
    else:
        figure.draw_without_rendering()  # as before each file of any kind; files themselves above


@pytest.mark.parametrize("name", NAMES)
def test_without_matplotlib_it_says_what_to_install(rich, name, monkeypatch):
    monkeypatch.setitem(sys.modules, "matplotlib", None)
    monkeypatch.setattr("raybundle.report.plotting.view_of", lambda _: pytest.fail("computed"))
    with pytest.raises(InputError, match=r"package\.matplotlib_missing"):
        plot(name, rich)


def test_the_package_is_loaded_without_matplotlib():
    code = "import sys, raybundle as rb; rb.plot_network, rb.adjust; assert 'matplotlib' not in sys.modules"
    subprocess.run([sys.executable, "-c", code], check=True)


@pytest.mark.parametrize("name", NAMES)
def test_anything_but_an_adjustment_is_refused(rich, name):
    with pytest.raises(InputError, match=r"Block.*figure\.no_adjustment"):
        plot(name, rich.given)


def test_parts_of_a_figure_are_drawn_into(rich):
    whole = Figure(figsize=(11, 8), layout="constrained")
    above, below = whole.subfigures(2, 1)
    assert rb.plot_residuals(rich, figure=above) is whole
    assert rb.plot_reliability(rich, figure=below) is whole
    assert len(above.axes) == len(rb.plot_residuals(rich).axes)
    own = Figure()
    assert rb.plot_network(rich, figure=own) is own
    with pytest.raises(InputError, match=r"Axes.*figure\.wrong_type"):
        rb.plot_network(rich, figure=own.axes[0])


def test_the_network_is_that_of_the_report(rich):
    view = view_of(rich)
    shape = network_shape(view)
    plan, front, side = rb.plot_network(rich).axes[:3]
    for axes, a, b in ((plan, 0, 1), (front, 0, 2), (side, 2, 1)):
        drawn = np.concatenate([c.get_offsets() for c in axes.collections if not isinstance(c, EllipseCollection)
                                and not isinstance(c, LineCollection)])  # fmt: skip
        assert sorted(map(tuple, drawn)) == sorted(map(tuple, view.adjusted.points.xyz[shape.kept][:, [a, b]]))
        assert axes.get_aspect() == 1
        assert axes.get_xlabel() == f"{'XYZ'[a]} [m]"
    ellipse = next(c for c in plan.collections if isinstance(c, EllipseCollection))
    widest = max(high - low for low, high in shape.limits)
    rows, factor = ellipse_rows(view, shape.kept, 0.014 * widest)
    half, _ = ellipses(view, rows, 0, 1)
    np.testing.assert_allclose(ellipse.get_widths(), 2 * factor * half[:, 1])
    assert phrase("plot.ellipses", n=len(rows), times=factor) in rb.plot_network(rich).get_suptitle()


def test_ellipses_are_those_of_the_covariances(rich):
    view = view_of(rich)
    rows = np.flatnonzero(np.trace(rich.precision.object_points, axis1=1, axis2=2) > 0)
    half, major = ellipses(view, rows, 0, 2)
    C = rich.precision.object_points[rows][:, [0, 2]][:, :, [0, 2]]
    along = np.einsum("ni,nij,nj->n", major, C, major)
    np.testing.assert_allclose(along, half[:, 1] ** 2)
    np.testing.assert_allclose(half[:, 0] * half[:, 1], np.sqrt(np.linalg.det(C)), rtol=1e-6)


def test_residuals_are_drawn_where_they_are(rich):
    at, means, histogram = rb.plot_residuals(rich).axes
    arrows = next(c for c in at.collections if isinstance(c, Quiver))
    used = rich.image_observations.used
    assert len(arrows.U) == used.sum()
    np.testing.assert_allclose(np.stack([arrows.U, arrows.V], axis=1), rich.image_observations.residuals_px[used])
    np.testing.assert_allclose(arrows.XY, rich.given.observations.xy_px[used])
    assert at.get_ylim()[0] > at.get_ylim()[1]  # y down, as residuals are
    counts = histogram.patches[0].get_data().values
    assert counts.sum() == np.isfinite(normalised(view_of(rich))).sum()
    cells = cell_means(rich, rich.given.cameras[0], used, normalised(view_of(rich)))
    found = phrase("plot.means_from_zero", n=int(cells.significant.sum()), of=cells.tested)
    assert means.get_title() == found.replace("; ", ";\n")


def test_curves_are_those_of_the_report(rich):
    interior = adjusted_interior(view_of(rich), rich.interior[0])
    curve = radial_curve(interior)
    axes = rb.plot_interior(rich, camera="1").axes[0]
    np.testing.assert_allclose(axes.lines[0].get_ydata(), 1000 * curve.value_mm)
    np.testing.assert_allclose(axes.lines[1].get_ydata(), 1000 * balanced(curve)[0].value_mm)
    band = axes.collections[0].get_paths()[0].vertices
    assert band[:, 1].max() == pytest.approx((1000 * (curve.value_mm + curve.std_mm)).max())
    with pytest.raises(InputError, match=r"7.*1.*figure\.none_of_camera"):
        rb.plot_interior(rich, camera="7")


def test_the_uncertainty_is_that_of_the_question(rich):
    figure = rb.plot_interior(rich)
    mesh = next(c for a in figure.axes for c in a.collections if isinstance(c, QuadMesh))
    values = np.asarray(mesh.get_array())
    rows, columns = values.shape
    camera = rich.given.cameras[0]
    x = (np.arange(columns) + 0.5) * camera.width_px / columns
    y = (np.arange(rows) + 0.5) * camera.height_px / rows
    C = rb.projection_uncertainty(rich, np.stack(np.meshgrid(x, y), axis=2).reshape(-1, 2))
    std = np.sqrt(np.trace(C, axis1=1, axis2=2) / 2).reshape(rows, columns)
    np.testing.assert_allclose(values, std, rtol=1e-6)


def test_detectable_blunders_are_counted_whole(rich):
    _, redundancy, blunders = rb.plot_reliability(rich).axes[:3]
    found, _ = detectable(view_of(rich))
    assert sum(p.get_height() for p in blunders.patches) == np.isfinite(found).sum()
    assert sum(p.get_height() for p in redundancy.patches) == 2 * rich.image_observations.used.sum()
    with pytest.raises(InputError, match=r"figure\.no_redundancy_numbers"):
        rb.plot_reliability(made("without_statistics"))


def test_differences_are_those_of_check_and_control(rich):
    first = rb.plot_control(rich).axes[0]
    control, check = (c[0].get_ydata() for c in first.containers)
    view = view_of(rich)
    np.testing.assert_allclose(sorted(check), sorted(1000 * view.check_difference[:, 0]))
    group = next(g for g in rich.groups if g.kind == "control")
    mine = [k for k, c in enumerate(group.component) if c == "X"]
    np.testing.assert_allclose(sorted(control), sorted(1000 * group.residual[mine]))
    assert first.get_ylabel() == "dX [mm]"
    with pytest.raises(InputError, match=r"figure\.no_control"):
        rb.plot_control(made("free"))


def test_scenes_and_panoramas():
    found = scenes()
    assert len(rb.plot_residuals(found).axes) == 6
    assert len(rb.plot_residuals(found, camera="forward").axes) == 3
    with pytest.raises(InputError, match=r"figure\.camera_without_points"):
        rb.plot_residuals(found, camera="sideward")
    low, high = rb.plot_network(found).axes[1].get_ylim()
    assert high - low < 1e5  # scenes stand near their ground, not in their orbit
    rb.plot_reliability(found)
    with pytest.raises(InputError, match=r"figure\.no_camera"):
        rb.plot_interior(found)
    panorama = adjust_block(noisy(room()))
    for name in NAMES:
        plot(name, panorama).savefig(io.BytesIO(), format="png")


def test_one_image_without_redundancy():
    scene = single_scene(SinglePhoto())
    block = simulate(scene, Survey(control=len(scene.xyz), **EXACT)).observed
    result = rb.adjust(block)
    assert rb.plot_network(result).get_suptitle().startswith("1 image, ")
    rb.plot_residuals(result)
    rb.plot_reliability(result)


def test_large_blocks_stay_small_files(tmp_path):
    scene = aerial_scene(AerialStrips(strips=3, images_per_strip=8, points_per_image=1500))
    result = rb.adjust(
        simulate(scene, Survey(control=8, control_sigma=(0.02, 0.02, 0.03), check=100, **EXACT)).observed
    )
    assert len(result.given.points) > 5000
    for name in ("network", "residuals", "reliability", "control"):
        file = tmp_path / f"{name}.svg"
        plot(name, result).savefig(file)
        assert file.stat().st_size < 3e6, name


def test_infinite_values_of_single_points_do_no_harm(rich):
    xyz = rich.adjusted.points.xyz.copy()
    xyz[0] = np.nan
    odd = replace(rich, adjusted=replace(rich.adjusted, points=replace(rich.adjusted.points, xyz=xyz)))
    for name in NAMES:
        plot(name, odd).savefig(io.BytesIO(), format="svg")


@pytest.mark.long
def test_ipython_shows_it():
    """Where IPython is there: the figure is the picture of a cell, not its name."""
    pytest.importorskip("IPython")
    code = textwrap.dedent("""
        import json
        from IPython.core.interactiveshell import InteractiveShell
        from tests.report.conftest import made
        import raybundle as rb
        shown, about = InteractiveShell.instance().display_formatter.format(rb.plot_network(made("rich")))
        print(json.dumps([sorted(shown), about]))
    """)
    done = subprocess.run([sys.executable, "-c", code], check=True, capture_output=True, text=True)
    kinds, about = json.loads(done.stdout.splitlines()[-1])
    assert "image/png" in kinds
    assert about["image/png"]["width"] > 300
