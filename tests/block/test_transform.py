"""A block that is transformed and adjusted gives what the adjusted block gives, transformed; else it says why not."""

from dataclasses import replace

import numpy as np
import pytest

from raybundle.adjustment.engine import adjust_block
from raybundle.adjustment.records.options import AdjustmentOptions
from raybundle.block import Attitudes, Relation, Role
from raybundle.block.transform import transform_block
from raybundle.errors import InputError
from raybundle.numerics.places import Local
from raybundle.numerics.rotation import rotation_from_angles
from raybundle.numerics.transform import SimilarityTransform
from raybundle.observations import tables
from raybundle.observations.alignment import Levels, PlumbLines
from raybundle.observations.parameter import Calibrated
from raybundle.observations.total_station import Directions, SlopeDistances, ZenithAngles
from tests.adjustment.test_attitudes import flight
from tests.observations.test_kinds import EXAMPLES

SHIFT = np.array([300.0, -20.0, 5.0])
WAYS = {
    "scale and shift": SimilarityTransform(scale=2.5, translation=SHIFT),
    "about the vertical": SimilarityTransform(
        scale=0.4, rotation=rotation_from_angles(np.array([0, 0, 0.7])), translation=SHIFT
    ),
    "tilted": SimilarityTransform(
        scale=1.7, rotation=rotation_from_angles(np.array([0.3, -0.5, 2.0])), translation=SHIFT
    ),
}
OPTIONS = AdjustmentOptions(jobs=1, tolerance=1e-12)
BLOCKS = [name for name in EXAMPLES if name != "mixed"]  # has satellite scenes


def example(name, way):
    """An example that can follow: noise of the image points, no upright figures where it tilts, sigmas of spheres."""
    block = EXAMPLES[name]()
    o, rng = block.observations, np.random.default_rng(8)
    block = replace(block, observations=replace(o, xy_px=o.xy_px + rng.normal(0, np.sqrt(o.cov_px2[:, :2]))))
    if not WAYS[way].turns:
        return block
    sigma = np.where(np.isfinite(block.points.sigma), np.nanmax(block.points.sigma, initial=0.0), np.nan)
    block = replace(block, points=replace(block.points, sigma=sigma))
    kept = {n: t for n, t in block.tables.items() if not isinstance(t, Attitudes)}
    for n, t in kept.items():
        if hasattr(t, "xyz") and hasattr(t, "sigma"):
            kept[n] = replace(t, sigma=np.where(np.isfinite(t.sigma), np.nanmax(t.sigma), np.nan))
    if way == "tilted":
        upright = (PlumbLines, Levels, Directions, ZenithAngles)
        kept = {n: t for n, t in kept.items() if not isinstance(t, upright)}
        for n, t in kept.items():
            if isinstance(t, SlopeDistances):
                d = block.points.xyz[t.target] - block.points.xyz[t.station]
                length = np.linalg.norm(d, axis=1) + rng.normal(0, t.sigma)
                kept[n] = replace(t, instrument=None, reflector=None, length=length)
            elif n == "differences":
                kept[n] = t.rows(np.isfinite(t.xyz).all(axis=1))
    if way == "tilted" and name == "total station":  # of which nothing tells the vertical any more
        control = np.arange(len(block.points)) % 6 == 0
        points = replace(
            block.points, role=np.where(control, Role.CONTROL, Role.TIE).astype(np.int32),
            sigma=np.where(control[:, None], [1e-3] * 3, np.nan),
        )  # fmt: skip
        block = replace(block, points=points)
    return replace(block, tables=kept)


def close(found, wanted, rel):
    good = np.isfinite(wanted)
    assert (np.isfinite(found) == good).all()
    assert np.abs(found - wanted)[good].max(initial=0.0) < rel * np.abs(wanted[good]).max(initial=1e-300)


def near(found, wanted, limit, std):
    assert (np.isfinite(found) == np.isfinite(wanted)).all()
    assert (np.nan_to_num(np.abs(found - wanted)) <= np.maximum(limit, 1e-4 * np.nan_to_num(std))).all()


def agree(block, by, rel):
    """Adjusted and transformed is transformed and adjusted."""
    before = adjust_block(block, OPTIONS)
    after = adjust_block(transform_block(block, by, observed="follow"), OPTIONS)
    assert after.sigma0 == pytest.approx(before.sigma0, rel=1e-8)
    assert after.redundancy == before.redundancy
    a, b = before.adjusted, after.adjusted
    extent = by.scale * np.ptp(a.points.xyz[np.isfinite(a.points.xyz).all(axis=1)], axis=0).max()
    # an iteration ends at a ten-thousandth of a standard deviation, which of a set-up that no image sees is more
    point_std, image_std = after.precision.object_point_std, after.precision.image_std
    # and the derivatives, of which covariances are made, are of places as far apart, seen over the extent
    rel = max(rel, 4e-4 * np.nanmax(point_std) / extent)
    near(b.points.xyz, by.points(a.points.xyz), 1e-8 * extent, point_std)
    near(b.images.centre, by.points(a.images.centre), 1e-8 * extent, image_std[:, :3])
    near(b.images.rotation, by.rotations(a.images.rotation), 1e-8, image_std[:, 3:].max(axis=1)[:, None, None])
    close(after.precision.object_points, by.covariances(before.precision.object_points), rel)
    close(after.precision.images[:, :3, :3], by.covariances(before.precision.images[:, :3, :3]), rel)
    told = transform_block(a, by, observed="follow")  # of the parameters
    for one, two in zip(told.parametrised, b.parametrised, strict=True):
        std = {q.symbol: q.std or 0.0 for i in after.interior if i.camera == two.id for q in i.parameters.values()}
        for q in one.sensor.parameters:
            limit = 1e-5 * std.get(q.symbol, 0.0)
            assert two.values[q.symbol] == pytest.approx(one.values[q.symbol], rel=1e-8, abs=max(limit, 1e-12))
    for one, two in zip(before.interior, after.interior, strict=True):
        for s, p in one.parameters.items():
            if p.std is not None and not any(s in v for v in getattr(one_model(before, one), "in_object", ())):
                factor = by.scale if p.unit.startswith("length") else 1.0
                assert two.parameters[s].std == pytest.approx(factor * p.std, rel=rel)
    return before


def one_model(result, interior):
    key = interior.camera.partition("/")[0]
    return next(c.sensor for c in result.given.parametrised if c.id == key)


@pytest.mark.parametrize("way", WAYS)
@pytest.mark.parametrize("name", BLOCKS)
def test_adjusting_and_transforming_may_be_exchanged(name, way):
    # the inverse of the normal matrix is good to what its condition leaves: set-ups are known by distances alone
    agree(example(name, way), WAYS[way], rel=5e-8 if (name, way) == ("total station", "tilted") else 1e-8)


def test_every_table_has_followed():
    there = {way: {n for name in BLOCKS for n in example(name, way).tables} for way in WAYS}
    assert there["scale and shift"] == set(tables)
    assert there["about the vertical"] == set(tables) - {"attitudes"}  # in a test of its own
    upright = {"plumb_lines", "levels", "directions", "zenith_angles"}
    assert there["tilted"] == set(tables) - {"attitudes"} - upright


def test_attitudes_of_a_level_flight_turn_about_the_vertical():
    block = flight(boresight_sigma={"bz": 1e-3})
    level = block.attitudes.angles * [0, 0, 1]
    rotation = rotation_from_angles(block.images.angles * [0, 0, 1])
    a, by = block.attitudes, WAYS["about the vertical"]
    turned = replace(a, angles=level, sigma=np.tile([1e-4, 1e-4, 3e-4], (len(a), 1))).transformed(by)
    np.testing.assert_allclose(turned.sigma, np.tile([1e-4, 1e-4, 3e-4], (len(a), 1)), rtol=1e-12)
    np.testing.assert_allclose(
        rotation_from_angles(turned.angles), by.rotations(rotation_from_angles(level)), atol=1e-14
    )
    assert rotation.shape == (len(block.images), 3, 3)
    assert turned.correlation is None or np.abs(turned.correlation).max() < 1e-9
    assert np.abs(a.transformed(by).correlation).max() > 1e-6  # of the flight as it was, which is not level


def test_shifts_of_antennas_turn_and_lever_arms_stay():
    block = flight(clock=("dt",), boresight_sigma={"bz": 1e-3})
    antenna = next(i for i in block.instruments if i.model == "antenna")
    relation = Relation(name="r", terms={"sx": 1.0, "ax": 2.0}, sigma=0.1, observed=3.0)
    known = Calibrated(
        symbols=("sx", "sy", "sz", "ax"), values=(1.0, 2.0, 3.0, 4.0), sigma=(0.1, 0.2, 0.3, 0.4),
        correlations=((1.0,), (0.5, 1.0), (0.0, 0.1, 1.0), (0.0, 0.0, 0.2, 1.0)),
    )  # fmt: skip
    values = {**antenna.values, "sx": 1.0, "sy": 2.0, "sz": 3.0, "ax": 4.0, "dt": 0.5}
    given = replace(
        antenna, values=values, estimate=("sx", "sy"), relations=(relation,), calibrated=known, known={"sz": 7.0},
        sigma={"sx": 0.2, "sy": 0.2, "sz": 0.2, "ay": 0.3},
    )  # fmt: skip
    block = replace(block, instruments=tuple(given if i is antenna else i for i in block.instruments), tables={})
    by = WAYS["about the vertical"]
    block = replace(block, points=replace(block.points, sigma=np.full_like(block.points.sigma, np.nan)))
    moved = next(i for i in transform_block(block, by, observed="follow").instruments if i.id == antenna.id)
    vector = [moved.values[s] for s in ("sx", "sy", "sz")]
    np.testing.assert_allclose(vector, by.vectors(np.array([1.0, 2.0, 3.0])), rtol=1e-14)
    assert moved.values["ax"] == pytest.approx(4.0 * by.scale)
    assert moved.values["dt"] == 0.5
    assert moved.estimate == ("sx", "sy")
    assert moved.sigma == pytest.approx({"ay": 0.3 * by.scale, **dict.fromkeys(("sx", "sy", "sz"), 0.2 * by.scale)})
    assert sum(f * moved.values[s] for s, f in moved.relations[0].terms.items()) == pytest.approx(1.0 + 2.0 * 4.0)
    A = np.zeros((4, 4))
    A[:3, :3], A[3, 3] = by.scale * by.rotation, by.scale
    np.testing.assert_allclose(moved.calibrated.covariance, A @ known.covariance @ A.T, rtol=1e-12, atol=1e-18)
    with pytest.raises(InputError, match=r"transform\.partly_free"):
        transform_block(block, WAYS["tilted"], observed="follow")


def test_what_cannot_follow_says_why():
    def refused(block, way, match, reason=""):
        with pytest.raises(InputError, match=match) as caught:
            transform_block(block, WAYS[way], observed="follow")
        if reason:
            assert [d.code for d in caught.value.message.details] == [reason]
        return transform_block(block, WAYS[way], observed="stay")

    field = EXAMPLES["field"]()
    refused(field, "tilted", r"point \w+ [\s\S]*transform\.row_not_possible", "transform.would_correlate")
    kept = refused(EXAMPLES["figures"](), "tilted", r"point|plumb_lines.csv, row 1")
    assert kept.tables.keys() == EXAMPLES["figures"]().tables.keys()
    figures = example("figures", "about the vertical")
    refused(figures, "tilted", r"plumb_lines.csv, row 1 \(a, point \d+\) ", "transform.vertical_turned")
    sighted = example("total station", "about the vertical")
    for name in ("directions", "zenith_angles", "slope_distances"):
        alone = replace(sighted, tables={name: sighted.tables[name]})
        refused(alone, "tilted", rf"{name}.csv, row \d+ \(.*point S0")
    alone = replace(sighted, tables={"differences": sighted.tables["differences"]})
    refused(alone, "tilted", r"differences.csv, row 2 \(point .*\) [\s\S]*transform\.row_not_possible")
    refused(replace(field, place=Local(origin=(15.0, 48.0, 300.0))), "scale and shift", r"transform\.geodetic_frame")
    refused(EXAMPLES["mixed"](), "scale and shift", r"transform\.scene")
    with pytest.raises(InputError, match=r"0.*transform\.scale_not_positive"):
        transform_block(field, SimilarityTransform(scale=0.0), observed="follow")


def test_approximate_values_move_alone_where_observed_ones_stay():
    block, by = EXAMPLES["airborne"](), WAYS["tilted"]
    moved = transform_block(block, by, observed="stay")
    np.testing.assert_array_equal(moved.points.xyz, by.scale * block.points.xyz @ by.rotation.T + by.translation)
    np.testing.assert_array_equal(moved.images.rotation, block.images.rotation @ by.rotation.T)
    assert moved.tables is block.tables
    assert moved.instruments is block.instruments
