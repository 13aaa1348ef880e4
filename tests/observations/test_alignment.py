"""Points on planes, lines, plumb lines and levels: true standard deviations, datum, refusals."""

from dataclasses import replace

import numpy as np
import pytest
from tests.messages import refused

from raybundle import adjust
from raybundle.adjustment.records.options import AdjustmentOptions
from raybundle.adjustment.system.assemble import assemble
from raybundle.block import Distances, Role
from raybundle.errors import DatumDefect
from raybundle.io.block.folder import read_block, write_block
from raybundle.numerics.rotation import rotation_from_vector
from raybundle.numerics.transform import similarity
from raybundle.observations.alignment import Levels, Lines, Planes, PlumbLines, PointsOnLine, _turned
from raybundle.planning.simulate import Survey, simulate
from raybundle.planning.synthetic_networks import TargetField, field_scene
from raybundle.report.write import write_result
from raybundle.results.folder import read_result

SIGMA, PX = 2e-4, 0.5
SCENE = field_scene(TargetField(rows=6, columns=7, depth=0.3, size=(0.8, 0.6), stations=6, frontal=1))
GRID = np.arange(42).reshape(6, 7)
FIGURES = {  # the points that stand on each figure
    "plane": (Planes, {"a": GRID[:, :3].ravel(), "b": GRID[:, 4:].ravel()}),
    "line": (Lines, {"a": GRID[0], "b": GRID[1:, 3]}),
    "plumb_line": (PlumbLines, {"a": GRID[1, :4], "b": GRID[4, 2:]}),
    "level": (Levels, {"a": GRID[:2].ravel(), "b": GRID[4:].ravel()}),
}


def placed(kind, xyz, rng, spread=SIGMA):
    """The points moved onto the kind's figures, up to their scatter; and the table."""
    table, figures = FIGURES[kind]
    xyz, names, points = xyz.copy(), [], []
    for name, rows in figures.items():
        middle, e = xyz[rows].mean(axis=0), rng.normal(0, 1, (len(rows), 3)) * spread
        if kind == "plane":
            n = np.array([0.1, -0.2 if name == "a" else 0.3, 1.0])
            n /= np.linalg.norm(n)
            xyz[rows] -= ((xyz[rows] - middle) @ n)[:, None] * n - e[:, :1] * n
        elif kind == "line":
            d = xyz[rows[-1]] - xyz[rows[0]]
            d /= np.linalg.norm(d)
            along = np.outer((xyz[rows] - middle) @ d, d)
            xyz[rows] = middle + along + e - np.outer(e @ d, d)
        elif kind == "plumb_line":
            xyz[rows, :2] = middle[:2] + e[:, :2]
            xyz[rows, 2] += np.linspace(0, 0.4, len(rows))
        else:
            xyz[rows, 2] = middle[2] + e[:, 2]
        names += [name] * len(rows)
        points += rows.tolist()
    return xyz, table(figure=tuple(names), point=np.array(points, np.int32), sigma=np.full(len(points), SIGMA))


def observed(kind, seed, spread=SIGMA):
    """Truth and an observed block of it; free network, cameras held."""
    rng = np.random.default_rng(seed)
    xyz, table = placed(kind, SCENE.xyz, rng, spread)
    made = simulate(replace(SCENE, xyz=xyz), Survey(image_sigma_px=PX, interior="exact", seed=seed, scale_bars=4))
    assert len(made.truth.points) == len(xyz)
    cameras = tuple(replace(c, estimate=()) for c in made.observed.cameras)
    return made.truth, replace(made.observed, cameras=cameras).having(table)


@pytest.mark.parametrize("kind", FIGURES)
def test_standard_deviations_hold(kind):
    """Squared errors of the points in the datum of the network over their covariance; redundancy numbers sum up."""
    total, count, groups = 0.0, 0, []
    for seed in range(12):
        truth, block = observed(kind, seed)
        result = adjust(block, AdjustmentOptions(jobs=1))
        assert result.sigma0 == pytest.approx(1.0, abs=0.15)
        r = np.nansum(result.image_observations.redundancy) + sum(g.redundancy.sum() for g in result.groups)
        assert r == pytest.approx(result.redundancy, abs=1e-5)
        (g,) = [g for g in result.groups if g.kind == kind]
        groups.append(float(np.sum((g.residual / g.sigma) ** 2)) / g.redundancy.sum())
        # inner constraints over all points are those of a rotation and shift without weights
        moved = similarity(result.adjusted.points.xyz, truth.points.xyz, scale=1.0)
        error = moved.points(result.adjusted.points.xyz) - truth.points.xyz
        C = result.precision.object_points
        total += float(np.einsum("pi,pij,pj->", error, np.linalg.inv(C), error))
        count += error.size
    assert 0.6 < total / count < 1.5
    assert 0.6 < np.mean(groups) < 1.5


@pytest.mark.parametrize("kind", FIGURES)
def test_a_scatter_beyond_the_stated_is_told(kind):
    _, block = observed(kind, 3, spread=30 * SIGMA)
    result = adjust(block, AdjustmentOptions(jobs=1))
    component = next(v for v in result.variance_components if v.kind == FIGURES[kind][0].name.replace("_", " ")
                     or v.kind.endswith(FIGURES[kind][0].name.replace("_", " ")))  # fmt: skip
    assert component.significant
    assert component.ratio > 3


@pytest.mark.parametrize("kind", ["plumb_line", "level"])
def test_what_is_upright_levels_the_datum(kind):
    _, block = observed(kind, 5)
    R = rotation_from_vector(np.array([0.02, -0.01, 0.0]))
    tilted = replace(
        block,
        images=replace(block.images, centre=block.images.centre @ R.T, rotation=block.images.rotation @ R.T),
        points=replace(block.points, xyz=block.points.xyz @ R.T),
    )
    result = adjust(tilted, AdjustmentOptions(jobs=1))
    assert not any("rotation X" in d or "rotation Y" in d for d in result.datum_defect)
    assert adjust(block.having(FIGURES[kind][0].empty())).datum_defect != result.datum_defect
    rows = FIGURES[kind][1]["a"]
    where = result.adjusted.points.xyz[rows]
    assert np.abs(np.ptp(where[:, 2:] if kind == "level" else where[:, :2], axis=0)).max() < 10 * SIGMA


def test_they_are_read_and_written_and_stand_in_the_result(tmp_path):
    _, block = observed("plane", 1)
    for kind in ("line", "plumb_line", "level"):
        block = block.having(placed(kind, SCENE.xyz, np.random.default_rng(1))[1])
    write_block(block, tmp_path / "block")
    again = read_block(tmp_path / "block")
    assert set(again.tables) == {"distances", "planes", "lines", "plumb_lines", "levels"}
    for name, table in block.tables.items():
        if name == "distances":
            continue
        there = again.tables[name]
        assert there.figure == table.figure
        assert [again.points.ids[k] for k in there.point] == [block.points.ids[k] for k in table.point]
        np.testing.assert_array_equal(there.sigma, table.sigma)
    result = adjust(observed("line", 1)[1])
    write_result(result, tmp_path / "out")
    lines = read_result(tmp_path / "out").others["lines"]
    (g,) = [g for g in result.groups if g.kind == "line"]
    assert (abs(lines.numbers("v1", "v2").ravel() - g.residual) <= 1.001e-3 * abs(g.residual / g.w)).all()
    assert PointsOnLine.title in (tmp_path / "out/report.html").read_text()


@pytest.mark.parametrize(
    ("rows", "code", "values"),
    [([0, 1], "alignment.too_few_points", {"least": 3}), ([0, 1, 2], "plane.points_in_line", {})],
)
def test_a_plane_without_a_place_is_refused(rows, code, values):
    xyz = SCENE.xyz.copy()
    xyz[:3] = [[0, 0, 0], [1, 1, 0], [2, 2, 0]]
    table = Planes(figure=("wall",) * len(rows), point=np.array(rows, np.int32), sigma=np.full(len(rows), 1e-3))
    start = simulate(SCENE, Survey(points="exact", orientation="exact", scale_bars=2)).observed
    free = {c.id: () for c in start.cameras}
    block = replace(start, points=replace(start.points, xyz=xyz)).having(table)
    system = assemble(block, AdjustmentOptions(), np.zeros(len(block.observations), bool), free)
    with refused(code, **values):
        system.initial_state()


def test_without_a_scale_they_are_refused():
    _, block = observed("level", 1)
    with refused("datum.no_scale", DatumDefect) as error:
        adjust(block.having(Distances.empty()))
    assert [d.values["kind"] for d in error.value.message.details] == ["levels"]


def test_control_and_a_plane_together():
    """A held point on a plane holds it; nothing is singular."""
    _, block = observed("plane", 2)
    role, sigma = np.array(block.points.role), np.array(block.points.sigma)
    xyz = np.array(block.points.xyz)
    truth = observed("plane", 2)[0].points.xyz
    for k in (0, 6, 35, 41):
        role[k], sigma[k], xyz[k] = Role.CONTROL, 0.0 if k else 1e-4, truth[k]
    result = adjust(replace(block, points=replace(block.points, role=role, sigma=sigma, xyz=xyz)))
    assert result.sigma0 == pytest.approx(1.0, abs=0.2)
    assert result.datum_defect == ()


@pytest.mark.parametrize("spread", [1, 10, 40])
def test_deviations_from_plumb_lines_tell_no_turn_about_the_vertical(spread):
    """However far points are off: a turn changes no sum of squares; standard deviations are those of a free network."""
    _, block = observed("plumb_line", 5, spread=spread * SIGMA)
    result = adjust(block, AdjustmentOptions(jobs=1, reject="none"))
    assert result.datum_defect == ("position X", "position Y", "position Z", "rotation Z")
    std = result.precision.object_point_std / result.sigma0
    _, exact = observed("plumb_line", 5, spread=0.0)
    expected = adjust(exact, AdjustmentOptions(jobs=1, reject="none"))
    np.testing.assert_allclose(
        np.median(std, axis=0), np.median(expected.precision.object_point_std / expected.sigma0, axis=0), rtol=0.1
    )


def test_turned_axes_stay_square_and_of_length_one():
    e, u = rotation_from_vector(np.array([[0.3, -0.4, 0.9], [2.0, 1.0, 0.1]])).transpose(1, 0, 2)[:2]
    step = np.array([[0.3, -0.2], [1e-3, 0.5]])
    new, side = _turned(e, u, step)
    aim = e + step[:, :1] * u + step[:, 1:] * np.cross(e, u)
    np.testing.assert_allclose(new, aim / np.linalg.norm(aim, axis=1)[:, None], rtol=0, atol=1e-15)
    np.testing.assert_allclose(np.linalg.norm(side, axis=1), 1, rtol=0, atol=1e-15)
    np.testing.assert_allclose((new * side).sum(axis=1), 0, rtol=0, atol=1e-15)
