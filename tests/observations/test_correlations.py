"""Correlations within a row of stations, attitudes and differences: truth, rigour, ways in and out, refusals."""

from dataclasses import replace

import numpy as np
import pytest
from scipy.stats import chi2
from tests.adjustment.test_attitudes import flight
from tests.messages import refused

import raybundle as rb
from raybundle import adjust
from raybundle.adjustment.records.options import AdjustmentOptions
from raybundle.block import Attitudes, Role, Stations
from raybundle.io.block.arrays import arrays_of_block, block_of_arrays
from raybundle.io.block.folder import read_block, write_block
from raybundle.numerics.deviations import PAIRS, correlation_matrices, drawn
from raybundle.numerics.rotation import angles_from_rotation, rotation_from_angles
from raybundle.numerics.transform import SimilarityTransform
from raybundle.observations import in_order
from raybundle.observations.coordinates import Coordinates
from raybundle.observations.total_station import Differences
from raybundle.planning.simulate import Survey, simulate
from raybundle.planning.synthetic_networks import TargetField, field_scene
from raybundle.platforms.imu import reported

ONE = AdjustmentOptions(jobs=1)
EXACT = AdjustmentOptions(jobs=1, tolerance=1e-13)
TILTED = SimilarityTransform(
    scale=1.7, rotation=rotation_from_angles(np.array([0.3, -0.5, 2.0])), translation=np.array([300.0, -20.0, 5.0])
)
CLOSE = np.array([0.9, 0.85, 0.88])
"""Coefficients that tell nearly as much as the standard deviations"""
ENDS = np.array([0, 4, 24, 29, 12], np.int32)
"""Points of the field that baselines lead to"""


def of(table, r=CLOSE, sigma=None):
    """A table with these coefficients in all rows that observe all three."""
    sigma = table.sigma if sigma is None else np.tile(sigma, (len(table), 1))
    whole = np.isfinite(sigma).all(axis=1)[:, None]
    return replace(table, sigma=sigma, correlation=np.where(whole, r, 0.0))


def positions():
    """A flight whose place nothing tells but its observed positions."""
    block = flight(control=0, attitudes=False)
    return block.having(of(block.stations, sigma=[0.03, 0.02, 0.05]))


def attitudes():
    """A flight whose rotation nothing tells but its observed attitudes."""
    block = flight(control=0, positions=False, boresight=())
    return block.having(of(block.attitudes))


def baselines(points=ENDS, seed=3):
    """A field of targets on baselines from a held base that no image sees."""
    scene = field_scene(TargetField(rows=5, columns=6, depth=0.4, size=(0.8, 0.6), stations=6, frontal=1))
    block = simulate(scene, Survey(image_sigma_px=0.5, interior="exact", points="exact", seed=seed)).truth
    base, known = len(block.points), block.points
    block = replace(
        block,
        cameras=tuple(replace(c, estimate=()) for c in block.cameras),
        points=replace(
            known, ids=(*known.ids, "base"), xyz=np.vstack([known.xyz, [[5.0, -3.0, 2.0]]]),
            sigma=np.vstack([known.sigma, np.zeros((1, 3))]),
            role=np.append(known.role, Role.CONTROL).astype(np.int32),
        ),
    )  # fmt: skip
    d = block.points.xyz[points] - block.points.xyz[base]
    sigma = np.tile([3e-4, 5e-4, 8e-4], (len(points), 1))
    start = np.full(len(points), base, np.int32)
    return block.having(of(Differences(station=start, target=points, xyz=d, sigma=sigma)))


def measured_again(truth, rng):
    """The block with new errors of its image points and of all its tables."""
    o = truth.observations
    noise = rng.normal(0, 1, o.xy_px.shape) * np.sqrt(o.cov_px2[:, :2])
    return replace(truth, observations=replace(o, xy_px=o.xy_px + noise)).of_tables(lambda t: t.with_errors(rng))


def independent(block):
    return block.of_tables(lambda t: replace(t, correlation=None))


def error_of_image(truth, result, rng, part):
    """Error and covariance of the projection centre or the angles of an image; the second drawn."""
    i = int(rng.integers(len(truth.images)))
    reported = np.hstack([truth.images.centre, truth.images.angles])[i]
    found = np.hstack([result.adjusted.images.centre, result.adjusted.images.angles])[i]
    off = (found - reported)[part]
    return np.arctan2(np.sin(off), np.cos(off)) if part.start else off, result.precision.images[i][part, part]


def error_of_point(truth, result, rng):
    k = int(rng.choice(ENDS))
    return result.adjusted.points.xyz[k] - truth.points.xyz[k], result.precision.object_points[k]


CASES = {
    "stations": (positions, lambda *a: error_of_image(*a, slice(0, 3))),
    "attitudes": (attitudes, lambda *a: error_of_image(*a, slice(3, 6))),
    "differences": (baselines, error_of_point),
}


@pytest.mark.long
@pytest.mark.parametrize("case", CASES)
def test_unknowns_scatter_as_their_covariance_says_and_would_not_without_correlations(case):
    """Squares of three coordinates together, and of their sum: of errors that are stated as they are, and as not.

    The trace of a covariance does not depend on correlations, so that the three together hardly feel them; their sum
    in units of the standard deviations has (3 + 2 sum r) / 3 = 2.75 of the variance that independence promises.
    """
    make, error_of = CASES[case]
    truth, rng, runs = make(), np.random.default_rng(5), 80
    weight = 1 / next(iter(truth.tables.values())).sigma[0]
    together, alone, wrong = [], [], []
    for _ in range(runs):
        block = measured_again(truth, rng)
        state = rng.bit_generator.state
        e, C = error_of(truth, adjust(block, ONE), rng)
        together.append(e @ np.linalg.solve(C, e))
        alone.append((weight @ e) ** 2 / (weight @ C @ weight))
        rng.bit_generator.state = state
        e, C = error_of(truth, adjust(independent(block), ONE), rng)
        wrong.append((weight @ e) ** 2 / (weight @ C @ weight))
    low, high = chi2(runs).interval(0.999)
    assert chi2(3 * runs).interval(0.999)[0] < np.sum(together) < chi2(3 * runs).interval(0.999)[1]
    assert low < np.sum(alone) < high
    assert np.sum(wrong) > high


def all_three():
    """A flight with correlated positions, attitudes and baselines, of other standard deviations in each axis."""
    block = flight(control=4, boresight_sigma={"bz": 1e-3})
    ends, xyz, rng = np.arange(4, 10, dtype=np.int32), block.points.xyz, np.random.default_rng(9)
    steps = Differences(
        station=ends[:-1], target=ends[1:], xyz=xyz[ends[1:]] - xyz[ends[:-1]], sigma=np.full((5, 3), 0.01)
    )
    r = np.array([_possible(rng) for _ in range(12)])
    block = block.having(
        of(block.stations, r, [0.03, 0.02, 0.05]), of(block.attitudes, r[::-1]), of(steps, r[:5], [0.01, 0.02, 0.03])
    )
    return measured_again(block, rng)


def _possible(rng):
    root = rng.normal(0, 1, (3, 3))
    C = root @ root.T + 0.1 * np.eye(3)
    s = np.sqrt(np.diagonal(C))
    return [C[i, j] / (s[i] * s[j]) for i, j in PAIRS]


def close(found, wanted, limit=1e-9):
    assert np.abs(found - wanted).max() < limit * np.abs(wanted).max()


@pytest.mark.parametrize("residuals", ["of all", "of all but the attitudes"])
def test_adjusting_and_rotating_may_be_exchanged(residuals):
    """Adjusted in another frame is the adjusted block in that frame, with its covariances.

    Angles turn as their derivatives say, which residuals of 1e-4 rad change by as much: covariances agree to 1e-4.
    Where the attitudes are what the rest says they have none, and everything agrees to 1e-9.
    """
    block = all_three()
    if residuals != "of all":
        alone = adjust(replace(block, tables={n: t for n, t in block.tables.items() if n != "attitudes"}), EXACT)
        ins = next(i for i in block.instruments if i.model == "imu")
        seen = reported(alone.adjusted.images.rotation, np.array([ins.values[s] for s in ("bx", "by", "bz")]))[0]
        block = block.having(replace(block.attitudes, angles=angles_from_rotation(seen)))
    limit = 1e-9 if residuals != "of all" else 1e-4
    moved = rb.transform_block(block, TILTED, observed="follow")
    before, after = adjust(block, EXACT), adjust(moved, EXACT)
    for table in moved.tables.values():
        assert np.abs(table.correlation).max() > 0.3
    close(after.adjusted.points.xyz, TILTED.points(before.adjusted.points.xyz))
    close(after.adjusted.images.centre, TILTED.points(before.adjusted.images.centre))
    close(after.adjusted.images.rotation, TILTED.rotations(before.adjusted.images.rotation), limit)
    close(after.precision.object_points, TILTED.covariances(before.precision.object_points), limit)
    close(after.precision.images[:, :3, :3], TILTED.covariances(before.precision.images[:, :3, :3]), limit)
    assert after.sigma0 == pytest.approx(before.sigma0, rel=10 * limit)
    assert after.redundancy == before.redundancy


def test_a_baseline_from_a_held_point_is_a_network_of_one():
    """The covariance of a baseline by coefficients, and the same one of coordinates as a matrix."""
    block = measured_again(baselines(), np.random.default_rng(7))
    steps = block.tables["differences"]
    result = adjust(block, EXACT)
    base = block.points.xyz[-1]
    C = steps.sigma[:, :, None] * correlation_matrices(steps.correlation, len(steps)) * steps.sigma[:, None, :]
    network = Coordinates(
        network=tuple(f"n{k}" for k in range(len(ENDS))), point=ENDS, other=ENDS, xyz=base + steps.xyz,
        covariance=C.reshape(-1, 9),
    )  # fmt: skip
    other = adjust(replace(block, tables={}).having(network), EXACT)
    close(result.adjusted.points.xyz, other.adjusted.points.xyz, 1e-10)
    close(result.precision.object_points[:-1], other.precision.object_points[:-1])
    one = next(g for g in result.groups if g.kind == "difference")
    two = next(g for g in other.groups if g.kind == "coordinate")
    for name in ("residual", "redundancy", "w", "mdb", "square", "adjusted_std"):
        np.testing.assert_allclose(getattr(one, name), getattr(two, name), rtol=1e-5, atol=1e-6)
    total = np.nansum(result.image_observations.redundancy) + one.redundancy.sum()
    assert total == pytest.approx(result.redundancy, abs=1e-6)


def test_without_coefficients_nothing_changes():
    block = independent(all_three())
    zeros = block.of_tables(lambda t: replace(t, correlation=np.zeros((len(t), 3))))
    empty = block.of_tables(lambda t: replace(t, correlation=np.full((len(t), 3), np.nan)))
    one = adjust(block, ONE)
    for same in (zeros, empty):
        two = adjust(same, ONE)
        np.testing.assert_array_equal(two.adjusted.points.xyz, one.adjusted.points.xyz)
        np.testing.assert_array_equal(two.precision.object_points, one.precision.object_points)
        for a, b in zip(one.groups, two.groups, strict=True):
            np.testing.assert_array_equal(a.w, b.w)
    scaled = rb.transform_block(all_three(), SimilarityTransform(scale=2.0, translation=np.ones(3)), observed="follow")
    for name, table in scaled.tables.items():
        np.testing.assert_array_equal(table.correlation, all_three().tables[name].correlation)


def test_they_go_through_folders_arrays_and_halves(tmp_path):
    block = all_three()
    write_block(block, tmp_path / "block")
    for again in (read_block(tmp_path / "block"), block_of_arrays(arrays_of_block(block))):
        for name, table in block.tables.items():
            np.testing.assert_array_equal(again.tables[name].correlation, table.correlation)
    header = (tmp_path / "block/attitudes.csv").read_text().splitlines()[0]
    assert "somega_deg,sphi_deg,skappa_deg,romega_phi,romega_kappa,rphi_kappa,imu" in header
    first = rb.read_block(tmp_path / "block")
    halves = [first.of_tables(lambda t, k=k: t.rows(np.arange(len(t)) % 2 == k)) for k in (0, 1)]
    bare = halves[1].of_tables(lambda t: replace(t, correlation=None))
    merged = rb.merge_blocks([halves[0], bare])
    stations = merged.stations
    one = np.isin(stations.image, halves[0].stations.image)
    np.testing.assert_array_equal(stations.correlation[one], halves[0].stations.correlation)
    assert (stations.correlation[~one] == 0).all()


@pytest.mark.parametrize("name", ["stations", "attitudes", "differences"])
def test_weights_of_a_group_leave_them(name):
    block = all_three()
    kind = next(k for k in in_order() if k.table is not None and k.table.name == name)
    table, wider = block.tables[name], kind.weighted(block, 3.0).tables[name]
    np.testing.assert_array_equal(wider.sigma, 3 * table.sigma)
    np.testing.assert_array_equal(wider.correlation, table.correlation)


def test_drawn_errors_have_the_covariance_that_is_stated():
    rng = np.random.default_rng(1)
    sigma = np.tile([1.0, 2.0, np.nan], (40000, 1))
    errors = drawn(rng, sigma, np.tile([-0.7, 0.0, 0.0], (40000, 1)))
    assert np.isnan(errors[:, 2]).all()
    C = np.cov(errors[:, :2].T)
    np.testing.assert_allclose(C, [[1.0, -1.4], [-1.4, 4.0]], atol=0.1)
    plain = drawn(np.random.default_rng(2), sigma)
    np.testing.assert_array_equal(plain, np.random.default_rng(2).normal(0, 1, sigma.shape) * sigma)
    mixed = drawn(np.random.default_rng(2), sigma, np.where(np.arange(40000)[:, None] == 5, [0.5, 0, 0], 0.0))
    assert (mixed != plain)[:, 0].sum() == 0
    assert np.flatnonzero((mixed != plain)[:, 1]).tolist() == [5]
    block = baselines()
    again = [block.tables["differences"].with_errors(rng) for _ in range(400)]
    z = np.array([(t.xyz - block.tables["differences"].xyz) / t.sigma for t in again]).reshape(-1, 3)
    np.testing.assert_allclose(np.corrcoef(z.T), correlation_matrices(CLOSE[None], 1)[0], atol=0.03)


def test_networks_are_drawn_with_their_matrix():
    rng, points = np.random.default_rng(3), np.arange(3, dtype=np.int32)
    root = rng.normal(0, 1, (9, 9))
    C = (root @ root.T + np.eye(9)).reshape(3, 3, 3, 3)
    a, b = np.triu_indices(3)
    table = Coordinates(
        network=("n",) * 6, point=points[a], other=points[b], xyz=np.where((a == b)[:, None], np.ones((6, 3)), np.nan),
        covariance=C[a, :, b].reshape(-1, 9),
    )  # fmt: skip
    found = np.array([(t := table.with_errors(rng)).xyz[t.own].ravel() - 1 for _ in range(20000)])
    np.testing.assert_allclose(np.cov(found.T), C.reshape(9, 9), atol=0.05 * np.abs(C).max())


LEVEL = SimilarityTransform(rotation=rotation_from_angles(np.array([0.0, 0.0, 0.7])))


def row_of(sigma, r=None, table=Stations):
    sigma = np.array([sigma])
    values = np.where(np.isfinite(sigma), 1.0, np.nan)
    where = {"image": np.zeros(1, np.int32)} if table is not Differences else {
        "station": np.zeros(1, np.int32), "target": np.ones(1, np.int32)
    }  # fmt: skip
    what = {"angles": np.array([[0.1, 0.2, 0.3]])} if table is Attitudes else {"xyz": values}
    return table(**where, **what, sigma=sigma, correlation=None if r is None else np.array([r]))


@pytest.mark.parametrize("table", [Stations, Differences])
def test_a_rotation_makes_coefficients_of_standard_deviations(table):
    turned = row_of([1.0, 2.0, 3.0], table=table).transformed(TILTED)
    C = TILTED.covariances(np.diag([1.0, 4.0, 9.0]))
    np.testing.assert_allclose(turned.sigma[0], np.sqrt(np.diagonal(C)), rtol=1e-14)
    for n, (i, j) in enumerate(PAIRS):
        assert turned.correlation[0, n] == pytest.approx(C[i, j] / np.sqrt(C[i, i] * C[j, j]))
    assert row_of([2.0, 2.0, 2.0], table=table).transformed(TILTED).correlation is None  # a sphere stays one
    plan = row_of([1.0, 2.0, np.nan], table=table).transformed(LEVEL)
    assert plan.correlation[0, 0] != 0
    assert (plan.correlation[0, 1:] == 0).all()
    assert np.isnan(plan.sigma[0, 2])
    assert why_not(row_of([1.0, 2.0, np.nan], table=table)).code == "transform.not_given"
    close = why_not(row_of([1e-7, 2.0, 3.0], table=table))
    assert (close.code, close.values["kind"], close.values["limit"]) == (
        "transform.too_correlated",
        "coordinate",
        1e-10,
    )
    assert close.values["eigenvalue"] < 1e-10
    assert why_not(row_of([1.0, 2.0, 3.0], [0.9, 0.9, -0.9], table=table)).code == "transform.coefficients"


def why_not(row):
    """The reason why a row cannot follow a tilt."""
    with refused("transform.row_not_possible") as caught:
        row.transformed(TILTED)
    return caught.value.message.details[0]


def test_a_rotation_correlates_angles():
    turned = row_of([1e-4, 1e-4, 1e-3], table=Attitudes).transformed(TILTED)
    assert np.abs(turned.correlation).min() > 1e-3
    again = turned.transformed(TILTED.inverse)
    np.testing.assert_allclose(again.sigma[0], [1e-4, 1e-4, 1e-3], rtol=1e-9)
    np.testing.assert_allclose(again.correlation, 0.0, atol=1e-9)
    missing = why_not(row_of([1e-4, np.nan, 1e-3], table=Attitudes))
    assert (missing.code, missing.values) == ("transform.not_observed", {"kind": "angle"})


def written(tmp_path, name, rows):
    """A block folder whose table has these rows of coefficients first."""
    write_block(all_three(), tmp_path / "block")
    path = tmp_path / f"block/{name}.csv"
    head, *lines = path.read_text().splitlines()
    at = head.split(",").index("romega_phi" if name == "attitudes" else "rXY")
    for k, new in rows.items():
        cells = lines[k].split(",")
        for n, text in new.items():
            cells[at + n] = text
        lines[k] = ",".join(cells)
    path.write_text("\n".join([head, *lines]) + "\n")
    return tmp_path / "block"


@pytest.mark.parametrize("name", ["stations", "attitudes", "differences"])
@pytest.mark.parametrize(
    ("cells", "code", "values"),
    [
        ({0: "1"}, "observation.correlation_range", {"correlation": 1}),
        ({1: "-2.5"}, "observation.correlation_range", {"correlation": -2.5}),
        ({0: "0.9", 1: "0.9", 2: "-0.9"}, "observation.correlations_not_possible", {"correlations": [0.9, 0.9, -0.9]}),
        ({2: "x"}, "cell.not_a_number", {}),
        ({-1: "", 0: "0", 1: "0.5", 2: "0"}, "observation.correlation_without_sigma", {"correlation": 0.5}),
    ],
)
def test_a_wrong_coefficient_is_refused_with_its_place(tmp_path, name, cells, code, values):
    if -1 in cells and name != "attitudes":  # a coordinate and its sigma leave together
        cells = {-4: "", **cells}
    with refused(code, file=f"{name}.csv", line=4, **values) as error:
        read_block(written(tmp_path, name, {2: cells}))
    assert error.value.column.startswith("r")


def test_empty_cells_are_zero_and_columns_stand_together(tmp_path):
    folder = written(tmp_path, "stations", {2: {0: "", 1: "", 2: ""}})
    assert (read_block(folder).stations.correlation[2] == 0).all()
    path = folder / "stations.csv"
    path.write_text(path.read_text().replace(",rXZ", ",rXY", 1).replace("rXY,rXY", "rXY,rXW"))
    with refused("table.unknown_column", file="stations.csv", line=1, column="rXW"):
        read_block(folder)
    lines = [line.split(",") for line in path.read_text().splitlines()]
    at = lines[0].index("rXW")
    path.write_text("\n".join(",".join(c for k, c in enumerate(line) if k != at) for line in lines) + "\n")
    with refused("table.columns_together", names=["rXY", "rYZ"], missing=["rXZ"]):
        read_block(folder)


def test_a_block_made_in_python_says_the_row():
    block = all_three()
    s = block.stations
    at = {"file": "stations.csv", "line": 4}
    bad = s.correlation.copy()
    bad[2] = r = [0.99, 0.99, -0.99]
    with refused("observation.correlations_not_possible", **at, column="rXY", correlations=r):
        adjust(block.having(replace(s, correlation=bad)), ONE)
    bad[2] = [0.0, 1.5, 0.0]
    with refused("observation.correlation_range", **at, column="rXZ", correlation=1.5):
        adjust(block.having(replace(s, correlation=bad)), ONE)
    sigma, xyz = s.sigma.copy(), s.xyz.copy()
    sigma[2, 2] = xyz[2, 2] = np.nan
    with refused("observation.correlation_without_sigma", **at, column="rXZ", first="sX", second="sZ"):
        adjust(block.having(replace(s, sigma=sigma, xyz=xyz)), ONE)
