"""Calibrations that are observed with their covariance: the same numbers back, true standard deviations with them."""

from dataclasses import replace

import numpy as np
import pytest
from scipy.stats import chi2

from raybundle.adjustment.engine import adjust_block
from raybundle.adjustment.records.options import AdjustmentOptions
from raybundle.block import Relation
from raybundle.block.stored import joint_covariance, observed_jointly
from raybundle.commands.photograph_facts import _camera
from raybundle.errors import InputError
from raybundle.io.block.toml import read_cameras
from raybundle.io.calibrations.ours import cameras_text
from raybundle.io.photos.cameras import CameraGroup, with_calibration
from raybundle.observations.kind import Interior
from raybundle.observations.parameter import _calibrated
from raybundle.planning.network.calibration_networks import ROLLS, FlatField, flat_field_scene
from raybundle.planning.simulate import Survey, simulate
from raybundle.planning.synthetic_networks import TargetField, field_scene

FREE = ("c", "x0", "y0", "K1", "K2", "P1", "P2")


@pytest.fixture(scope="module")
def calibrated():
    """A camera of which only a mean network was taken, its covariance, and the truth."""
    plan = FlatField(tilt_deg=25.0, rolls_deg=ROLLS, distances=(0.8, 1.1))
    survey = Survey(seed=3, orientation="exact", points="exact", interior="exact", image_sigma_px=0.3)
    seen = simulate(flat_field_scene(plan), survey).observed
    free = replace(seen, cameras=(replace(seen.cameras[0], estimate=FREE),))
    result = adjust_block(free, AdjustmentOptions(jobs=1))
    return seen.cameras[0], result.precision.interior[seen.cameras[0].id] / result.sigma0**2


def test_covariance_and_values_come_back(calibrated, tmp_path):
    camera, C = calibrated
    known = observed_jointly(camera, FREE, C)
    assert known.estimate == FREE
    path = tmp_path / "camera.toml"
    path.write_text(cameras_text([known]))
    (again,) = read_cameras(path)
    assert again == known
    free, back = joint_covariance(again)
    size = np.sqrt(np.diag(C))
    assert free == FREE
    np.testing.assert_allclose(back / np.outer(size, size), C / np.outer(size, size), atol=1e-9)
    assert joint_covariance(camera) == ((), None)
    with pytest.raises(InputError, match=r"camera\.covariance_not_positive"):
        observed_jointly(camera, FREE, -C)


def as_relations(known):
    """As files said it before: with C = L L' the rows of L^-1 p are independent observations."""
    c = known.calibrated
    root = np.linalg.inv(np.linalg.cholesky(c.covariance))
    relations = tuple(
        Relation(
            name=f"calibration: {s}", origin="calibration", sigma=1.0, observed=float(root[k] @ c.values),
            terms=dict(zip(FREE[: k + 1], root[k].tolist(), strict=False)),
        )
        for k, s in enumerate(c.symbols)
    )  # fmt: skip
    return replace(known, calibrated=None, relations=relations)


@pytest.mark.parametrize("free", [FREE, FREE[2:], ("K1",)])
def test_what_files_said_before_means_the_same(calibrated, free, tmp_path):
    """All parameters free, or some held: the others are then observed as the calibration tells them given those."""
    camera, C = calibrated
    seen = simulate(
        replace(field_scene(TargetField()), camera=camera),
        Survey(seed=4, control=4, orientation="exact", points="exact", interior="exact", image_sigma_px=0.05),
    ).observed
    known = replace(observed_jointly(camera, FREE, C), estimate=free)
    older = as_relations(known)
    path = tmp_path / "camera.toml"
    path.write_text(cameras_text([older]))
    (again,) = read_cameras(path)
    assert not again.relations
    np.testing.assert_allclose(again.calibrated.covariance, C, rtol=1e-6, atol=1e-30)
    options = AdjustmentOptions(jobs=1)
    found = [adjust_block(replace(seen, cameras=(c,)), options) for c in (known, again, older)]
    assert {g.kind for g in found[1].groups} == {"control", "parameter"}
    assert {g.kind for g in found[2].groups} == {"control", "relation"}
    for other in found[:2]:
        np.testing.assert_allclose(other.adjusted.points.xyz, found[2].adjusted.points.xyz, rtol=0, atol=1e-9)
        r0, r1 = (np.sqrt(np.diagonal(r.precision.interior[camera.id])) / r.sigma0 for r in (other, found[2]))
        np.testing.assert_allclose(r0, r1, rtol=1e-6)
        total = np.nansum(other.image_observations.redundancy) + sum(g.redundancy.sum() for g in other.groups)
        assert total == pytest.approx(other.redundancy, abs=1e-6)
        if free == FREE:
            assert other.redundancy == found[2].redundancy
            assert other.sigma0 == pytest.approx(found[2].sigma0, rel=1e-9)


@pytest.mark.parametrize(
    ("line", "words"),
    [
        ('calibration = "c"', r"calibration\.no_list"),
        ('calibration = [{parameter = "c", value = 1.0}]', r"1.*calibration\.incomplete_entry"),
        ('calibration = [{parameter = "q", value = 1.0, sigma = 1.0}]', r"parameter\.unknown"),
        ('calibration = [{parameter = "c", value = 1.0, sigma = -1.0}]', r"0.*value\.not_above"),
        (
            """calibration = [
    {parameter = "c", value = 1.0, sigma = 1.0}, {parameter = "c", value = 1.0, sigma = 1.0, correlations = [0.1]}
]""",
            r"parameter\.twice",
        ),
        (
            'calibration = [{parameter = "c", value = 1.0, sigma = 1.0}, {parameter = "K1", value = 1.0, sigma = 1.0}]',
            r"2.*0.*1.*calibration\.correlation_count",
        ),
        (
            """calibration = [
    {parameter = "c", value = 1.0, sigma = 1.0}, {parameter = "K1", value = 1.0, sigma = 1.0, correlations = [1.5]}
]""",
            r"calibration\.not_positive_definite",
        ),
    ],
)
def test_a_calibration_that_is_none_is_refused(calibrated, tmp_path, line, words):
    path = tmp_path / "camera.toml"
    path.write_text(cameras_text([calibrated[0]]) + line + "\n")
    with pytest.raises(InputError, match=words):
        read_cameras(path)


@pytest.mark.long
def test_object_points_carry_the_uncertainty_of_the_calibration(calibrated):
    """60 blocks, each with a calibration drawn from its covariance: held it is far too sure, observed it is true."""
    camera, C = calibrated
    scene = replace(field_scene(TargetField()), camera=camera)
    root = np.linalg.cholesky(C)
    rng = np.random.default_rng(8)
    squares = {"held": [], "observed": []}
    for run in range(60):
        survey = Survey(seed=run, control=4, orientation="exact", points="exact", interior="exact", image_sigma_px=0.05)
        simulated = simulate(scene, survey)
        values = np.array([camera.values[s] for s in FREE]) + root @ rng.standard_normal(len(FREE))
        drawn = replace(camera, estimate=(), values={**camera.values, **dict(zip(FREE, values, strict=True))})
        for name, used in (("held", drawn), ("observed", observed_jointly(drawn, FREE, C))):
            block = replace(simulated.observed, cameras=(used,))
            result = adjust_block(block, AdjustmentOptions(jobs=1))
            k = int(np.flatnonzero(simulated.truth.points.role == 0)[run % 20])
            error = result.adjusted.points.xyz[k] - simulated.truth.points.xyz[k]
            covariance = result.precision.object_points[k] / result.sigma0**2
            squares[name].append(error @ np.linalg.solve(covariance, error))
    low, high = chi2.ppf([0.0005, 0.9995], 3 * 60)
    assert low < sum(squares["observed"]) < high
    assert sum(squares["held"]) > 3 * high


def test_correlations_that_were_rounded_are_taken(calibrated):
    """Two terms of a polynomial that hardly differ, as a file with six digits has them."""
    camera, _ = calibrated
    C = np.array([[1.0, 0.9999997], [0.9999997, 1.0]])
    C = np.round(C, 6)
    known = observed_jointly(camera, ("K1", "K2"), C * 1e-18)
    free, back = joint_covariance(known)
    assert free == ("K1", "K2")
    assert np.diag(back) == pytest.approx(1e-18, rel=1e-5)


def test_a_group_of_photographs_knows_the_standard_deviation_of_its_calibration(calibrated):
    camera, C = calibrated
    group = CameraGroup(
        id=camera.id, name=camera.id, photos=(0,), width_px=camera.width_px, height_px=camera.height_px,
        pixel_mm=camera.pixel_mm,
        c_mm=camera.values["c"], sigma_c_mm=1.0, source="35 mm equivalent", remarks=(),
    )  # fmt: skip
    known = observed_jointly(camera, FREE, C)
    assert with_calibration(group, known).sigma_c_mm == pytest.approx(np.sqrt(C[0, 0]))
    held = replace(known, estimate=(), sigma={"c": 0.01})
    assert with_calibration(group, held).sigma_c_mm == 0
    # and so does what the report prints, where 0 reads "held"
    assert _camera(with_calibration(group, known)).sigma_c_px == pytest.approx(np.sqrt(C[0, 0]) / camera.pixel_mm[0])
    assert _camera(with_calibration(group, held)).sigma_c_px == 0


def test_what_is_held_of_a_calibration_moves_what_is_free(calibrated):
    """Observed together, held away from their values: the others are expected where the covariance puts them."""
    camera, C = calibrated
    known = observed_jointly(camera, FREE, C)
    held = {"x0": known.values["x0"] + 0.02, "P1": known.values["P1"] + 1e-5}
    free = tuple(s for s in FREE if s not in held)
    at = tuple(known.sensor.symbols.index(s) for s in free)
    interior = Interior(
        key="1", camera=0, instrument=-1, image=-1, symbols=known.sensor.symbols, free=at,
        given={**known.values, **held}, sigma={}, calibrated=known.calibrated,
    )  # fmt: skip
    places, expected, within = _calibrated(interior)
    f, h = [FREE.index(s) for s in free], [FREE.index(s) for s in held]
    inverse = np.linalg.inv(C)  # of the free ones given the others (Schur complement)
    moved = -np.linalg.solve(inverse[np.ix_(f, f)], inverse[np.ix_(f, h)] @ [0.02, 1e-5])
    size = np.sqrt(np.diag(C))[f]
    assert places == list(at)
    np.testing.assert_allclose((expected - [known.values[s] for s in free]) / size, moved / size, atol=1e-6)
    np.testing.assert_allclose(
        within / np.outer(size, size), np.linalg.inv(inverse[np.ix_(f, f)]) / np.outer(size, size), atol=1e-6
    )
