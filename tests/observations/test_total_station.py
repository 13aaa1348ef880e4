"""Directions, zenith angles, slope distances and coordinate differences beside photographs: truth, tests, datum."""

from dataclasses import replace

import numpy as np
import pytest
from scipy.stats import chi2

from raybundle import adjust
from raybundle.adjustment.records.options import AdjustmentOptions
from raybundle.errors import InputError
from raybundle.io.block.arrays import arrays_of_records
from raybundle.io.block.folder import read_block, write_block
from raybundle.observations.total_station import Differences, Directions, SlopeDistances, ZenithAngles
from raybundle.planning.simulate import Survey, simulate
from raybundle.planning.synthetic_networks import TargetField, field_scene
from raybundle.report.write import write_result
from raybundle.results.folder import read_result

SCENE = field_scene(TargetField(rows=5, columns=6, depth=0.3, size=(0.8, 0.6), stations=6, frontal=1))
ANGLE, LENGTH, STEP = np.radians(0.001), 4e-4, 3e-4
"""Standard deviations: 1.1 mgon, 0.4 mm, 0.3 mm"""
KINDS = ("direction", "zenith_angle", "slope_distance", "difference")
ONE = AdjustmentOptions(jobs=1)
INSTRUMENT, REFLECTOR = 1.6, 0.08


def total_station(seed, setups=2):
    """Truth and a block whose points were sighted from set-ups that no image sees; images in a free network."""
    rng = np.random.default_rng(seed)
    made = simulate(SCENE, Survey(image_sigma_px=0.5, interior="exact", seed=seed))
    truth, block = (_with_setups(b, setups) for b in (made.truth, made.observed))
    p = len(truth.points) - setups
    X = truth.points.xyz
    targets = np.sort(rng.permutation(p)[:10])
    pairs = [(p + s, int(t)) for s in range(setups) for t in (*targets, *(p + k for k in range(setups) if k != s))]
    station, target = (np.array(c, np.int32) for c in zip(*pairs, strict=True))
    d = X[target] - X[station] + [0, 0, REFLECTOR - INSTRUMENT]
    turn = np.array([0.3, 5.9, 2.0])[station - p]
    azimuth = np.arctan2(d[:, 0], d[:, 1])
    n = len(station)
    heights = {"instrument": np.full(n, INSTRUMENT), "reflector": np.full(n, REFLECTOR)}
    level = np.array([[0, 4], [4, 9], [9, 0], [14, 20]], np.int32)
    steps = X[level[:, 1]] - X[level[:, 0]] + rng.normal(0, STEP, (4, 3))
    steps[1:, :2] = np.nan
    tables = (
        Directions(
            set=tuple(f"s{s}" for s in station - p), station=station, target=target,
            angle=(azimuth - turn + rng.normal(0, ANGLE, n)) % (2 * np.pi), sigma=np.full(n, ANGLE),
        ),
        ZenithAngles(
            station=station, target=target, angle=np.arctan2(np.hypot(d[:, 0], d[:, 1]), d[:, 2])
            + rng.normal(0, ANGLE, n), sigma=np.full(n, ANGLE), **heights,
        ),
        SlopeDistances(
            station=station, target=target, length=np.linalg.norm(d, axis=1) + rng.normal(0, LENGTH, n),
            sigma=np.full(n, LENGTH), **heights,
        ),
        Differences(
            station=level[:, 0], target=level[:, 1], xyz=steps, sigma=np.where(np.isnan(steps), np.nan, STEP)
        ),
    )  # fmt: skip
    cameras = tuple(replace(c, estimate=()) for c in block.cameras)
    # approximate values of what no image sees, wrong by centimetres
    near = X[p:] + rng.normal(0, 0.02, (setups, 3))
    points = replace(block.points, xyz=np.vstack([block.points.xyz[:p], near]))
    return truth, replace(block, cameras=cameras, points=points).having(*tables)


def _with_setups(block, setups):
    points = block.points
    places = np.array([[-3.0, -4.0, 1.0], [3.5, -5.0, 1.4], [0.0, -6.0, 0.5]])[:setups]
    return replace(
        block,
        points=replace(
            points, ids=(*points.ids, *(f"S{k}" for k in range(setups))), xyz=np.vstack([points.xyz, places]),
            sigma=np.vstack([points.sigma, np.full((setups, 3), np.nan)]),
            role=np.append(points.role, np.zeros(setups, np.int32)),
        ),
    )  # fmt: skip


def with_control(truth, block, rows=(0, 5), sigma=5e-4, rng=None):
    """Two control points: place and direction of the object."""
    points = block.points
    xyz, s, role = points.xyz.copy(), points.sigma.copy(), np.asarray(points.role).copy()
    for k in rows:
        xyz[k] = truth.points.xyz[k] + (0 if rng is None else rng.normal(0, sigma, 3))
        s[k], role[k] = sigma, 1
    return replace(block, points=replace(points, xyz=xyz, sigma=s, role=role))


@pytest.mark.long
def test_standard_deviations_hold():
    """Squared errors of points and set-ups over their covariance, and each group's square sum over its redundancy."""
    squares, setups, groups, degrees = [], [], dict.fromkeys(KINDS, 0.0), dict.fromkeys(KINDS, 0.0)
    for seed in range(40):
        truth, block = total_station(seed)
        result = adjust(with_control(truth, block, rng=np.random.default_rng(900 + seed)), ONE)
        total = np.nansum(result.image_observations.redundancy) + sum(g.redundancy.sum() for g in result.groups)
        assert total == pytest.approx(result.redundancy, abs=1e-5)
        for g in result.groups:
            if g.kind in KINDS:
                groups[g.kind] += g.square.sum()
                degrees[g.kind] += g.redundancy.sum()
        for where, rows in ((squares, [11]), (setups, [len(truth.points) - 1])):
            e = (result.adjusted.points.xyz - truth.points.xyz)[rows]
            C = result.precision.object_points[rows]
            where.append(float(np.einsum("pi,pij,pj->", e, np.linalg.inv(C), e)))
    for found in (squares, setups):
        low, high = chi2.ppf([0.0005, 0.9995], 3 * len(found))
        assert low < sum(found) < high
    for kind in KINDS:
        low, high = chi2.ppf([0.0005, 0.9995], degrees[kind])
        assert low < groups[kind] < high, kind


def test_a_set_up_between_fixed_points_is_the_textbooks_resection():
    """Against a dense adjustment of its own, of one set-up and four points that are held."""
    truth, block = total_station(3, setups=1)
    fixed = [0, 5, 24, 14]
    block = with_control(truth, block, fixed, 0.0)
    p = len(truth.points) - 1
    tables = [block.tables[n] for n in ("directions", "zenith_angles", "slope_distances")]
    X = block.points.xyz[fixed]
    d = X - truth.points.xyz[p]
    level = np.hypot(d[:, 0], d[:, 1])
    rng = np.random.default_rng(5)
    seen = [np.arctan2(d[:, 0], d[:, 1]) - 6.1, np.arctan2(level, d[:, 2]), np.linalg.norm(d, axis=1)]
    seen = [s + rng.normal(0, sigma, 4) for s, sigma in zip(seen, (ANGLE, ANGLE, LENGTH), strict=True)]
    rows = {"station": np.full(4, p, np.int32), "target": np.array(fixed, np.int32)}
    new = (
        Directions(set=("a",) * 4, angle=seen[0] % (2 * np.pi), sigma=np.full(4, ANGLE), **rows),
        ZenithAngles(angle=seen[1], sigma=np.full(4, ANGLE), **rows),
        SlopeDistances(length=seen[2], sigma=np.full(4, LENGTH), **rows),
    )
    block = replace(block, tables={}).having(*new)
    assert len(tables) == len(new)
    result = adjust(block, ONE)

    unknown = np.array([*truth.points.xyz[p], 6.1])

    def model(u):
        d = X - u[:3]
        h = np.hypot(d[:, 0], d[:, 1])
        t = np.arctan2(d[:, 0], d[:, 1]) - u[3] - seen[0]
        return np.concatenate([
            np.arctan2(np.sin(t), np.cos(t)) / ANGLE, (np.arctan2(h, d[:, 2]) - seen[1]) / ANGLE,
            (np.linalg.norm(d, axis=1) - seen[2]) / LENGTH,
        ])  # fmt: skip

    for _ in range(10):
        A = np.stack([(model(unknown + e) - model(unknown - e)) / 2e-6 for e in 1e-6 * np.eye(4)], axis=1)
        unknown = unknown - np.linalg.solve(A.T @ A, A.T @ model(unknown))
    np.testing.assert_allclose(result.adjusted.points.xyz[p], unknown[:3], rtol=0, atol=1e-7)
    Q = np.linalg.inv(A.T @ A)
    np.testing.assert_allclose(result.precision.object_points[p] / result.sigma0**2, Q[:3, :3], rtol=1e-4)
    v = model(unknown)
    r = 1 - np.diagonal(A @ Q @ A.T)
    found = {g.kind: g for g in result.groups}
    for k, kind in enumerate(KINDS[:3]):
        mine = slice(4 * k, 4 * k + 4)
        np.testing.assert_allclose(found[kind].redundancy, r[mine], atol=1e-6)
        np.testing.assert_allclose(found[kind].w, v[mine] / np.sqrt(r[mine]), rtol=1e-4, atol=1e-5)


@pytest.mark.parametrize("kind", KINDS)
def test_a_gross_error_is_named(kind):
    truth, block = total_station(7)
    table = next(t for t in block.tables.values() if type(t).__name__.lower().startswith(kind.replace("_", "")[:9]))
    field = {"direction": "angle", "zenith_angle": "angle", "slope_distance": "length", "difference": "xyz"}[kind]
    values = getattr(table, field).copy()
    if kind == "difference":
        values[2, 2] += 40 * STEP
    else:
        values[3] += 40 * table.sigma[3]
    block = with_control(truth, block.having(replace(table, **{field: values})))
    result = adjust(block, ONE)
    (g,) = [g for g in result.groups if g.kind == kind]
    worst = int(np.nanargmax(np.abs(g.w)))
    assert g.item[worst] == (2 if kind == "difference" else 3)
    assert any(n.code == f"{kind}_suspect" and g.ids[worst] in n.text for n in result.notices)


def test_where_the_circle_begins_does_not_matter():
    truth, block = total_station(9)
    block = with_control(truth, block)
    t = block.tables["directions"]
    turned = replace(t, angle=(t.angle + np.where(np.array(t.set) == "s0", 2.2, -0.4)) % (2 * np.pi))
    a, b = adjust(block, ONE), adjust(block.having(turned), ONE)
    np.testing.assert_allclose(a.adjusted.points.xyz, b.adjusted.points.xyz, rtol=0, atol=1e-9)
    assert a.sigma0 == pytest.approx(b.sigma0, rel=1e-9)


def test_what_they_tell_of_the_datum():
    """Zenith angles the vertical, distances the scale, a difference in plan the turn about the vertical."""
    truth, block = total_station(11)
    assert adjust(block, ONE).datum_defect == ("position X", "position Y", "position Z")
    result = adjust(block.having(Differences.empty()), ONE)
    assert result.datum_defect == ("position X", "position Y", "position Z", "rotation Z")
    spread = np.ptp(result.adjusted.points.xyz[:, 2]) - np.ptp(truth.points.xyz[:, 2])
    assert abs(spread) < 0.01


def test_folders_degrees_and_gon(tmp_path):
    truth, block = total_station(13)
    block = with_control(truth, block)
    write_block(block, tmp_path / "block")
    again = read_block(tmp_path / "block")
    for name, table in block.tables.items():
        found = dict(arrays_of_records(again.tables[name]))
        for field, values in arrays_of_records(table):
            if values.dtype.kind == "f":
                np.testing.assert_allclose(found[field], values, rtol=1e-12)
            else:
                np.testing.assert_array_equal(found[field], values)
    path = tmp_path / "block/directions.csv"
    lines = path.read_text().splitlines()
    gon = [lines[0].replace("_deg", "_gon")]
    for line in lines[1:]:
        *ids, angle, sigma = line.split(",")
        gon.append(",".join([*ids, repr(float(angle) / 0.9), repr(float(sigma) / 0.9)]))
    path.write_text("\n".join(gon) + "\n")
    np.testing.assert_allclose(
        read_block(tmp_path / "block").tables["directions"].angle, block.tables["directions"].angle, rtol=1e-12
    )
    result = adjust(again, ONE)
    write_result(result, tmp_path / "out")
    shown = read_result(tmp_path / "out").others["zenith_angles"]
    (g,) = [g for g in result.groups if g.kind == "zenith_angle"]
    np.testing.assert_allclose(np.radians(shown.number["v_deg"]), g.residual, rtol=0, atol=1.001e-3 * g.sigma.max())
    report = (tmp_path / "out/report.html").read_text()
    for words in ("Horizontal directions", "Zenith angles", "Slope distances", "Coordinate differences"):
        assert words in report


@pytest.mark.parametrize(
    ("table", "change", "words"),
    [
        ("directions", lambda t: replace(t, target=t.station), r"observation\.same_point"),
        ("directions", lambda t: replace(t, set=("one",) * len(t)), r"observation\.set_station"),
        ("zenith_angles", lambda t: replace(t, angle=t.angle + np.pi), r"observation\.zenith_angle"),
        ("differences", lambda t: replace(t, sigma=np.full_like(t.sigma, np.nan)), r"observation\.value_without_sigma"),
    ],
)
def test_what_is_wrong_is_said(tmp_path, table, change, words):
    truth, block = total_station(15)
    block = with_control(truth, block)
    write_block(block.having(change(block.tables[table])), tmp_path / "block")
    with pytest.raises(InputError, match=words):
        read_block(tmp_path / "block")


def test_a_set_up_above_its_target_has_no_direction():
    truth, block = total_station(17)
    block = with_control(truth, truth.having(*block.tables.values()))
    t = block.tables["directions"]
    xyz = block.points.xyz.copy()
    xyz[t.station[0], :2] = xyz[t.target[0], :2]
    with pytest.raises(InputError, match=r"total_station\.vertical_sight"):
        adjust(replace(block, points=replace(block.points, xyz=xyz)), ONE)
