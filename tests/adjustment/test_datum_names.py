"""What an open datum is called: by the motions of the object that leave everything observed as it is."""

from dataclasses import replace

import numpy as np
import pytest

from raybundle.adjustment.records.options import AdjustmentOptions
from raybundle.adjustment.system.assemble import assemble
from raybundle.adjustment.system.datum import (
    ABOUT_LINE,
    NAMES,
    Datum,
    _observed_rows,
    analyse,
    middle_and_extent,
    node_generators,
    open_names,
    point_generators,
)
from raybundle.adjustment.system.normals import Normals
from raybundle.block import Instrument
from raybundle.numerics.rotation import angles_from_rotation, rotation_from_vector
from raybundle.observations.alignment import Planes
from raybundle.observations.attitude import Attitudes
from raybundle.platforms import instrument_models
from tests.adjustment.test_moving_sensors import observed, two_camera_rig
from tests.native.cases import block_of

X = np.random.default_rng(4).normal(size=(6, 3)) * 30


def test_the_unit_of_generators_is_the_median_distance_from_the_middle():
    centre, extent = middle_and_extent(np.array([[7.0, 5, 5], [3, 5, 5], [5, 9, 5], [5, 1, 5], [5, 5, 90]]))
    assert centre.tolist() == [5, 5, 5]
    assert extent == 4
    assert middle_and_extent(np.ones((3, 3)))[1] == 1


def basis_of(*generators):
    return np.linalg.qr(np.array(generators, float).T)[0]


def test_generators_are_what_a_small_motion_does_to_points():
    centre, extent, step = np.array([5.0, -2.0, 7.0]), 12.0, 1e-5
    G = point_generators(X, centre, extent)
    for k in range(7):
        turn = np.eye(3)[k - 3] * step if 3 <= k < 6 else np.zeros(3)
        scale = 1 + step * (k == 6)
        shift = np.eye(3)[k] * step * extent if k < 3 else np.zeros(3)
        moved = centre + scale * (X - centre) @ rotation_from_vector(turn[None])[0].T + shift
        sign = np.sign(np.sum((moved - X) * G[:, :, k]))  # the sense of a rotation is free
        np.testing.assert_allclose(sign * G[:, :, k], (moved - X) / step, atol=1e-2)


AXIS, THROUGH = np.array([0.6, 0.64, 0.48]), np.array([0.3, -0.5, 0.1])
LINE = np.concatenate([np.cross(THROUGH, AXIS), AXIS, [0.0]])
"""A rotation about the line through a point shifts the middle at right angles to the axis."""


@pytest.mark.parametrize("pure", [(), (0,), (6,), (2, 6), (0, 1, 2, 6)])
def test_pure_generators_are_named(pure):
    assert open_names(np.eye(7)[:, list(pure)]) == tuple(NAMES[k] for k in pure)


def test_a_rotation_about_a_line_is_named_also_beside_an_open_scale():
    assert open_names(basis_of(LINE)) == (ABOUT_LINE,)
    assert open_names(basis_of(LINE, np.eye(7)[6])) == (NAMES[6], ABOUT_LINE)


@pytest.mark.parametrize("along", [[*0.3 * AXIS, 0.0, 0.0, 0.0, 0.0], [0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.2]])
def test_a_rotation_that_shifts_along_its_axis_or_scales_is_a_combination(along):
    motion = np.concatenate([np.zeros(3), AXIS, [0.0]]) + along
    (name,) = open_names(basis_of(motion))
    assert name.startswith("1 combination of ")
    assert {n for n in NAMES if n in name} == {n for n, v in zip(NAMES, motion, strict=True) if v}


def test_several_mixtures_are_counted():
    rng = np.random.default_rng(0)
    (name,) = open_names(basis_of(*rng.normal(size=(2, 7))))
    assert name.startswith("2 combinations of ")
    assert all(n in name for n in NAMES)


def free_rig():
    truth = two_camera_rig()
    points = replace(
        truth.points, role=np.zeros_like(truth.points.role), sigma=np.full_like(truth.points.sigma, np.nan)
    )
    return replace(observed(truth), points=points)


def with_planes():
    """Of a plane the unknowns move with the object."""
    block = block_of(scale_bars=2)
    planes = Planes(figure=("wall",) * 5, point=np.array([1, 4, 8, 11, 14], np.int32), sigma=np.full(5, 1e-2))
    return block.having(planes)


@pytest.mark.parametrize(
    ("made", "defect"),
    [(block_of, 7), (lambda: block_of(scale_bars=2), 6), (free_rig, 7), (with_planes, 6)],
    ids=["frames", "bars", "rig", "planes"],
)
def test_what_is_open_changes_no_residual(made, defect):
    """Residuals along each generator stay, by differences; offsets of a rig and figures move with the points."""
    block = made()
    free = {c.id: tuple(c.estimate) for c in block.parametrised}
    system = assemble(block, AdjustmentOptions(), np.zeros(len(block.observations), bool), free)
    state = system.initial_state()
    normals = Normals.of(system, 1)
    normals.reduce(state)
    datum = analyse(system, state, AdjustmentOptions())
    assert datum.defect == defect
    nodes = node_generators(system, state, datum)
    points = point_generators(state.xyz, datum.centre, datum.extent) @ datum.basis
    retained = np.flatnonzero(system.point_node >= 0)

    def change(step, shift):
        """Derivative of all residuals in this direction."""
        shift = shift.copy()
        shift[retained] = step[system.offsets[system.point_node[retained]][:, None] + np.arange(3)]
        ends = []
        for sign in (-1e-6, 1e-6):
            moved = system.updated(state, sign * step, sign * shift)
            ends.append(np.concatenate([normals.residuals(moved)[0].ravel(), normals.extra(moved).residual]))
        return np.abs(ends[1] - ends[0]).max() / 2e-6

    for k in range(defect):
        assert change(nodes[:, k], points[:, :, k]) < 1e-4 * change(0.9 * nodes[:, k], points[:, :, k])
    flat = np.concatenate([nodes, points.reshape(-1, defect)])
    assert np.linalg.matrix_rank(flat / np.linalg.norm(flat, axis=0)) == defect


def with_attitudes():
    block = block_of(station_sigma=1e-3)
    attitudes = Attitudes(
        image=np.arange(3, dtype=np.int32), angles=angles_from_rotation(block.images.rotation[:3]),
        sigma=np.full((3, 3), 1e-3),
    )  # fmt: skip
    return block.having(attitudes)


def with_instruments():
    """Stations by an antenna with a shift, attitudes by an IMU with a misalignment, neither known."""
    block = with_attitudes()
    gnss = Instrument(id="gnss", model="antenna", values=zeros("antenna"), estimate=("sx", "sy", "sz"))
    ins = Instrument(id="ins", model="imu", values=zeros("imu"), estimate=("bx", "by", "bz"))
    stations = replace(block.stations, antenna=np.zeros(len(block.stations), np.int32))
    attitudes = replace(block.attitudes, imu=np.ones(len(block.attitudes), np.int32))
    return replace(block, instruments=(gnss, ins)).having(stations).having(attitudes)


def zeros(model):
    return dict.fromkeys(instrument_models[model].symbols, 0.0)


@pytest.mark.parametrize("made", [lambda: block_of(station_sigma=1e-3, scale_bars=1), with_attitudes, with_instruments])
def test_what_observations_fix_is_how_they_change_as_the_object_moves(made):
    block = made()
    free = {c.id: tuple(c.estimate) for c in block.parametrised}
    system = assemble(block, AdjustmentOptions(), np.zeros(len(block.observations), bool), free)
    state, normals = system.initial_state(), Normals.of(system, 1)
    normals.reduce(state)
    centre, extent = middle_and_extent(state.xyz)
    rows, sigma = _observed_rows(system, state, centre, extent)
    every = np.ones(len(block.points), bool)
    all_of_them = Datum(kind="inner", basis=np.eye(7), centre=centre, extent=extent, carriers=every)
    nodes, points = node_generators(system, state, all_of_them), point_generators(state.xyz, centre, extent)
    parts = [p for p in system.extra.parts if p.kind.carries_datum and p.kind.name != "control"]
    mine = np.concatenate([p.positions for p in parts])
    unit = np.concatenate([np.full(len(p.rows), extent if p.kind.unit == "length" else 1.0) for p in parts])
    np.testing.assert_allclose(sigma * unit, system.extra.sigma[mine])
    retained = np.flatnonzero(system.point_node >= 0)
    instruments = [
        system.offsets[row.node] + row.start + i
        for row in system.interior for i in range(len(row.free)) if row.instrument >= 0 and row.node >= 0
    ]  # fmt: skip
    by_instruments = np.zeros((len(mine), len(instruments)))
    for j, unknown in enumerate(instruments):
        step = 1e-6 * (np.arange(len(nodes)) == unknown)
        ends = [
            normals.standardised(system.updated(state, s, np.zeros_like(state.xyz))).residual[mine]
            for s in (-step, step)
        ]
        by_instruments[:, j] = (ends[1] - ends[0]) * system.extra.sigma[mine] / 2e-6 / unit
    changed = np.zeros((len(mine), 7))
    for k in range(7):
        ends = []
        for step in (-1e-6, 1e-6):
            shift = points[:, :, k].copy()
            shift[retained] = nodes[system.offsets[system.point_node[retained]][:, None] + np.arange(3), k]
            moved = system.updated(state, step * nodes[:, k], step * shift)
            ends.append(normals.standardised(moved).residual[mine] * system.extra.sigma[mine])
        changed[:, k] = (ends[1] - ends[0]) / 2e-6 / unit
    np.testing.assert_allclose(rows, changed - by_instruments @ np.linalg.pinv(by_instruments) @ changed, atol=1e-5)
