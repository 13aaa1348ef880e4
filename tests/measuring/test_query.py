"""Questions to results: standard deviations from the full covariance, and true."""

import json
import re
from dataclasses import replace

import numpy as np
import pytest
from scipy.stats import chi2

import raybundle as rb
from raybundle.adjustment.records.options import AdjustmentOptions
from raybundle.block import Distances, Role
from raybundle.cli.main import main
from raybundle.errors import InputError, phrase
from raybundle.io.block.folder import write_block
from raybundle.measuring.axes import by_level
from raybundle.measuring.joint import Joint
from raybundle.measuring.query import ask, in_axes
from raybundle.results.folder import read_result
from raybundle.workflows.adjust import adjust

from .scenes import simulation, small_block


@pytest.fixture(scope="module")
def result():
    return adjust(small_block())


def names_of(block, count=4):
    used = np.flatnonzero((block.ray_count >= 4) & (np.asarray(block.points.role) == 0))
    return [block.points.ids[k] for k in used[:: len(used) // count][:count]]


def test_a_distance_has_the_sigma_of_both_ends_together(result):
    a, b = names_of(result.adjusted, 2)
    found = ask(result, "distance", (a, b))
    xyz = [result.adjusted.points.xyz[result.adjusted.points.ids.index(n)] for n in (a, b)]
    u = (xyz[1] - xyz[0]) / np.linalg.norm(xyz[1] - xyz[0])
    C = {(p, q): result.covariance(f"point:{p}", f"point:{q}") for p in (a, b) for q in (a, b)}
    variance = u @ (C[a, a] + C[b, b] - C[a, b] - C[b, a]) @ u
    assert found.values[0] == pytest.approx(np.linalg.norm(xyz[1] - xyz[0]))
    assert found.sigma[0] == pytest.approx(np.sqrt(variance), rel=1e-6)
    assert found.unit == "m"


@pytest.fixture(scope="module")
def thirty():
    """Simulations with their adjustments, the same for every quantity."""
    made = [simulation(seed=seed + 500) for seed in range(30)]
    return [(m, adjust(m.observed)) for m in made]


@pytest.mark.parametrize(
    ("quantity", "count"),
    [
        ("coordinates", 1),
        ("distance", 2),
        ("angle", 3),
        ("area", 4),
        ("length", 4),
        ("plane", 5),
        ("line", 3),
        ("to_plane", 5),
        ("to_line", 4),
    ],
)
def test_sigmas_are_true_and_derivatives_right(thirty, quantity, count):
    square, freedom = 0.0, 0
    for made, found in thirty:
        points = names_of(made.observed, 5)[:count]
        answer, true = ask(found, quantity, points), value_of(made.truth, quantity, points)
        e = np.array(answer.values) - true
        # deviations from a form depend on each other: those that are left are all the same in their sum
        values, vectors = np.linalg.eigh(answer.covariance)
        free = values > 1e-9 * values[-1]
        square += float(((vectors[:, free].T @ e) ** 2 / values[free]).sum())
        freedom += int(free.sum())
    low, high = chi2(freedom).ppf([0.0005, 0.9995])
    assert low < square < high


def value_of(block, quantity, points):
    X = np.array([block.points.xyz[block.points.ids.index(n)] for n in points])
    if quantity == "coordinates":
        return X[0]
    if quantity == "distance":
        return np.linalg.norm(X[1] - X[0])
    if quantity == "angle":
        a, b = X[0] - X[1], X[2] - X[1]
        return np.degrees(np.arccos(a @ b / np.linalg.norm(a) / np.linalg.norm(b)))
    if quantity == "area":
        return np.linalg.norm(np.cross(X, np.roll(X, -1, axis=0)).sum(axis=0)) / 2
    if quantity == "length":
        return np.linalg.norm(np.diff(X, axis=0), axis=1).sum()
    form = X[1:] if quantity.startswith("to_") else X
    centre = form.mean(axis=0)
    axes = np.linalg.eigh((form - centre).T @ (form - centre))[1]
    axes = axes * np.sign(axes[np.argmax(np.abs(axes), axis=0), range(3)])
    off = (X - centre) @ axes
    if quantity == "to_plane":
        return abs(off[0, 0])
    if quantity == "to_line":
        return np.hypot(*off[0, :2])
    if quantity == "plane":
        return np.array([np.ptp(off[:, 0]), *off[:, 0]])
    return np.array([np.hypot(*off[:, :2].T).max(), *np.hypot(*off[:, :2].T)])


def test_axes_by_points_carry_their_errors(result):
    """Against the adjustment in which these coordinates are held: the same up to the scale, which control fixes."""
    a, b, c = names_of(result.adjusted, 3)
    moved = in_axes(result, a, b, c)
    at = {n: k for k, n in enumerate(moved.ids)}
    np.testing.assert_allclose(moved.xyz[at[a]], 0, atol=1e-12)
    np.testing.assert_allclose(moved.xyz[at[b], 1:], 0, atol=1e-12)
    assert abs(moved.xyz[at[c], 2]) < 1e-12
    assert (moved.covariance[at[a]] == 0).all()
    assert (moved.covariance[at[b], 1:] == 0).all()
    assert moved.covariance[at[c], 2, 2] == 0
    # X of the axis point is its distance from the origin
    assert np.sqrt(moved.covariance[at[b], 0, 0]) == pytest.approx(ask(result, "distance", (a, b)).sigma[0], rel=1e-5)
    assert np.linalg.eigvalsh(moved.covariance).min() > -1e-12


def test_axes_by_a_level_carry_the_errors_of_all_its_points(result):
    """Against differences of the whole transformation, and the joint covariance."""
    block = result.adjusted
    a, b, *level = names = names_of(block, 6)
    moved = in_axes(result, a, b, level=level)
    at = [block.points.ids.index(n) for n in names]
    xyz, C = block.points.xyz[at], Joint.of(result).of_points(at)

    def into(x):
        r = x.reshape(-1, 3)
        return (r - r[0]) @ by_level(r, np.array([0.0, 0.0, 1.0])).T

    J = np.zeros((18, 18))
    for k in range(18):
        d = np.zeros(18)
        d[k] = 1e-5
        J[:, k] = (into(xyz.ravel() + d) - into(xyz.ravel() - d)).ravel() / 2e-5
    expected = J @ C @ J.T
    rows = [moved.ids.index(n) for n in names]
    np.testing.assert_allclose(moved.xyz[rows], into(xyz.ravel()), atol=1e-9)
    for k, row in enumerate(rows):
        np.testing.assert_allclose(
            moved.covariance[row], expected[3 * k : 3 * k + 3, 3 * k : 3 * k + 3], atol=1e-7 * np.abs(expected).max()
        )
    for given, words in (
        ({"level": level[:2]}, r"2.*axes\.level_no_plane"),
        ({"level": [level[0], level[0], level[1]]}, r"axes\.same_points"),
        ({}, r"joint\.unknown_point"),
    ):
        with pytest.raises(InputError, match=words):
            in_axes(result, a, b, **given)


def test_what_is_refused(result):
    for quantity, points, words in (
        ("distance", ("1",), r"1.*2.*quantity\.point_count"),
        ("distance", ("1", "none"), r"joint\.unknown_point"),
        ("distance", (names_of(result.adjusted)[0],) * 2, r"quantity\.not_defined"),
        ("area", ("1", "2"), r"3.*quantity\.point_count"),
    ):
        with pytest.raises(InputError, match=words):
            ask(result, quantity, points)
    with pytest.raises(InputError, match=r"quantity\.none"):
        rb.query(result)


@pytest.fixture
def folder(tmp_path):
    write_block(small_block(), tmp_path / "ring")
    return tmp_path / "ring"


def run(capsys, *words):
    status = main([str(w) for w in words])
    out = capsys.readouterr()
    return status, out.out, out.err


def test_command_lines(folder, capsys, result):
    names = names_of(result.adjusted, 4)
    status, out, _ = run(capsys, "query", folder, "--area", *names, "--distance", *names[:2], "--json")
    assert status == 0
    rows = [json.loads(line) for line in out.splitlines()]
    assert [r["quantity"] for r in rows] == ["distance", "area"]
    assert rows[0]["sigma"]["distance"] == pytest.approx(ask(result, "distance", names[:2]).sigma[0], rel=1e-3)
    status, out, _ = run(capsys, "query", folder, "--coordinates", *names[:2], "--angle", *names[:3])
    assert status == 0
    assert out.count("+-") == 7
    assert run(capsys, "query", folder)[0] == 2
    out_folder = folder.parent / "axes"
    words = ("--origin", names[0], "--axis", names[1], "--plane", names[2], "--out", out_folder)
    assert run(capsys, "datum", folder, *words)[0] == 0
    assert {p.name for p in out_folder.iterdir()} == {"points.csv", "transformation.json"}
    assert run(capsys, "datum", folder, "--origin", names[0], "--out", out_folder)[0] == 2


def test_measuring_on_the_command_line(folder, capsys):
    block = small_block()
    o = block.observations
    p = int(np.flatnonzero(block.ray_count >= 4)[0])
    rows = [(block.images.file[i], *xy) for i, q, xy in zip(o.image, o.point, o.xy_px, strict=True) if q == p]
    for image, x, y in rows:
        assert run(capsys, "mark", "put", folder, image, "gate", x, y, "--mark-sigma", 0.3)[0] == 0
    image, x, y = rows[0]
    assert run(capsys, "mark", "move", folder, image, "gate", x, y, "--mark-sigma", 0.2)[0] == 0
    other = block.points.ids[int(np.flatnonzero(block.ray_count >= 4)[5])]
    assert run(capsys, "mark", "bar", folder, "gate", other, 1.5, 0.5)[0] == 0
    assert run(capsys, "mark", "point", folder, "gate", "--role", "check", "--coordinates", 1, 2, "-")[0] == 0
    assert run(capsys, "mark", "undo", folder)[0] == 0
    assert run(capsys, "mark", "redo", folder)[0] == 0
    assert run(capsys, "mark", "undo", folder)[0] == 0
    status, out, _ = run(capsys, "mark", "list", folder)
    assert (status, f"{len(rows)} marks" in out, re.search(rf"gate\b.*\b{other}\b.*1\.5", out) is not None) == (
        0,
        True,
        True,
    )
    status, out, _ = run(capsys, "mark", "list", folder, "--history", "--json")
    assert len(out.splitlines()) == len(rows) + 6
    status, out, _ = run(capsys, "mark", "export", folder, folder.parent / "marks.csv", "--verbose")
    assert (status, "scale bars: 1" in out) == (0, True)
    status, out, err = run(capsys, "mark", "adjust", folder, "--no-report")
    assert status == 0, err
    read = read_result(folder.parent / "ring-measured")
    assert "gate" in read.points.text["point"]
    status, _, err = run(capsys, "mark", "put", folder, "none.jpg", "gate", 1, 1)
    assert status == 2
    assert "none.jpg" in err
    assert run(capsys, "mark", "put", folder, image, "gate", "nan", 1)[0] == 2
    assert rb.marks(folder).points["gate"].role == "tie"
    assert rb.mark(folder, "forget", point="gate") == len(rows) + 7


def test_held_coordinates_have_no_variance_even_at_the_end_of_a_scale_bar():
    """A point that a scale bar retains among the unknowns, held in Y and Z."""
    block = small_block()
    names = names_of(block, 3)
    a, b, _ = (block.points.ids.index(n) for n in names)
    role, sigma = np.array(block.points.role), block.points.sigma.copy()
    role[a] = Role.CONTROL
    sigma[a] = [np.nan, 0.0, 0.0]
    length = float(np.linalg.norm(block.points.xyz[a] - block.points.xyz[b]))
    bar = Distances(
        start=np.array([a], np.int32), end=np.array([b], np.int32), length=np.array([length]), sigma=np.array([1e-3])
    )
    held = replace(block, points=replace(block.points, role=role, sigma=sigma)).having(bar)
    found = adjust(held)
    std = found.precision.object_point_std[a]
    answer = ask(found, "coordinates", (names[0],))
    assert answer.sigma[1:] == (0.0, 0.0)
    assert answer.sigma[0] == pytest.approx(std[0], rel=1e-6)
    own = found.covariance(f"point:{names[0]}")
    np.testing.assert_allclose(np.sqrt(np.diagonal(own)), std, rtol=1e-6, atol=1e-12)
    without = ask(
        adjust(replace(held, tables={k: t for k, t in held.tables.items() if k != "distances"})),
        "distance",
        (names[0], names[2]),
    )
    assert ask(found, "distance", (names[0], names[2])).sigma[0] < 1.5 * without.sigma[0]


OPTIONS = (
    {},
    {"hold": (("camera", "K1"),)},
    {"datum": "inner"},
    {"datum": "minimal"},
    {"datum": "inner", "datum_points": ("1", "20", "60", "110", "200")},
    {"residuals": "corrected"},
    {"estimate": "auto"},
    {"noise": "fields"},
    {"reject": "snooping"},
)


@pytest.mark.parametrize("options", OPTIONS, ids=str)
def test_a_result_is_asked_under_the_options_that_it_was_made_with(options, tmp_path):
    """Coordinates and standard deviations are those of its own tables."""
    block = small_block()
    options = {k: ((block.cameras[0].id, "K1"),) if k == "hold" else v for k, v in options.items()}
    rb.write_result(adjust(block, AdjustmentOptions(**options)), tmp_path / "result", report=False)
    read = read_result(tmp_path / "result")
    names = names_of(block, 5)
    at = [read.points.text["point"].index(n) for n in names]
    found = rb.query(tmp_path / "result", coordinates=names)
    for name, k, answer in zip(names, at, found, strict=True):
        stated = [read.points.number[f"s{c}"][k] for c in "XYZ"]
        np.testing.assert_allclose(answer.values, [read.points.number[c][k] for c in "XYZ"], atol=1e-3 * min(stated))
        np.testing.assert_allclose(answer.sigma, stated, rtol=1e-3, err_msg=name)
    assert (phrase("measuring.minimal_datum") in found[0].remark) == (options.get("datum") == "minimal")
    moved = rb.transform_to_points(
        tmp_path / "result", tmp_path / "axes", **dict(zip(("origin", "axis", "plane"), names, strict=False))
    )
    assert (moved / "points.csv").is_file()


def test_control_that_was_found_wrong_stays_out(tmp_path):
    block = small_block()
    p = block.points
    k = int(np.flatnonzero(p.is_control.any(axis=1))[0])
    wrong = replace(p, xyz=p.xyz + 0.1 * (np.arange(len(p)) == k)[:, None])
    result = adjust(replace(block, points=wrong), AdjustmentOptions(reject="snooping"))
    assert any(n.code == "control_rejected" for n in result.notices)
    rb.write_result(result, tmp_path / "result", report="none")
    read = read_result(tmp_path / "result")
    names = names_of(block, 3)
    for name, answer in zip(names, rb.query(tmp_path / "result", coordinates=names), strict=True):
        row = read.points.text["point"].index(name)
        np.testing.assert_allclose(answer.sigma, [read.points.number[f"s{c}"][row] for c in "XYZ"], rtol=1e-3)


def test_numbers_of_numpy_are_numbers(tmp_path):
    block = small_block()
    write_block(block, tmp_path / "block")
    x, y = block.observations.xy_px[0]
    image = block.images.ids[int(block.observations.image[0])]
    assert isinstance(x, np.float64)
    assert rb.mark(tmp_path / "block", "put", image=image, point="new", x_px=x, y_px=y, clicked=np.array([x, y])) == 1
    assert rb.marks(tmp_path / "block").marks[image, "new"].clicked == (x, y)


def test_points_of_a_list_stand_apart_or_with_commas_between():
    from raybundle.cli.settings import values_of
    from raybundle.commands.marks_settings import QuerySettings

    for typed in (("1,5,7,12",), ("1", "5", "7", "12"), ("1,5", "7, 12")):
        assert values_of(QuerySettings, {"plane": typed})["plane"] == ("1", "5", "7", "12")
