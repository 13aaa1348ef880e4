"""Laws that every kind of scene fulfils; a new file in `scenes.kinds` is tested by existing."""

from dataclasses import replace

import numpy as np
import pytest

from raybundle.block import Images
from raybundle.io.block.arrays import arrays_of_block, block_of_arrays
from raybundle.io.block.scene_keys import key_value
from raybundle.io.block.scenes import KEYS, scene_lines
from raybundle.io.block.toml_section import read_toml
from raybundle.numerics.places import Local
from raybundle.scenes.kinds import scene_kinds
from raybundle.scenes.sensor import scene_camera, view_of
from tests.adjustment.test_scenes import PLACES
from tests.truth.mixed_blocks import PLACE, block_of, control_table

GROUND = np.column_stack([np.random.default_rng(3).uniform(-1500, 1500, (20, 2)), np.linspace(-150, 150, 20)])


@pytest.fixture(scope="module", params=scene_kinds, ids=str)
def kind(request):
    return scene_kinds[request.param]


@pytest.fixture(scope="module")
def sensor(kind):
    return kind.example(Local(origin=PLACE), PLACE)


def shifted(sensor):
    """Values as large as usual standard deviations."""
    usual = sensor.usual_priors()
    other = {"m": 2.0, "s": 1e-4, "rad": 2e-5}
    return np.array([usual[p.symbol] if p.symbol in usual else other[p.unit] for p in sensor.parameters]) * np.resize(
        [1.0, -0.7], len(sensor.symbols)
    )


def test_it_states_itself(kind, sensor):
    others = [k for k in scene_kinds.values() if k is not kind]
    assert not any(issubclass(kind.geometry, k.geometry) for k in others)
    assert not {k.name for k in kind.keys} & set(KEYS)
    assert len(sensor.symbols) > 0
    assert set(sensor.symbols) <= {p.symbol for p in kind.possible} | {m for g in sensor.groups.values() for m in g}
    assert all(p.words and p.unit for p in (*sensor.parameters, *kind.possible))
    assert sensor.title
    assert kind.formula.strip()
    if sensor.curves is not None:
        model, half = sensor.curves
        assert sensor.symbols[: len(model.symbols)] == model.symbols
        assert half > 0
    assert np.isfinite(sensor.depth_m)
    assert sensor.depth_m > 0


@pytest.mark.parametrize("place", PLACES.values(), ids=PLACES)
def test_partial_derivatives_are_differences(kind, place):
    sensor = kind.example(place, PLACE)
    xyz = place.block_from_geographic(Local(origin=PLACE).geographic_from_block(GROUND))
    values = shifted(sensor)
    seen = sensor.observe(xyz, values)
    for k in range(3):
        up, down = (sensor.observe(xyz + s * np.eye(3)[k], values, seen.xy_px).xy_px for s in (1.0, -1.0))
        assert np.abs((up - down) / 2 - seen.by_point[:, :, k]).max() < 1e-6 * np.abs(seen.by_point).max()
    for k, (symbol, value) in enumerate(zip(sensor.symbols, values, strict=True)):
        step = 0.03 * abs(value)
        up, down = (
            sensor.observe(xyz, values + s * step * np.eye(len(values))[k], seen.xy_px).xy_px for s in (1.0, -1.0)
        )
        error = np.abs((up - down) / 2 - seen.by_parameters[:, :, k] * step).max()
        assert error < 1e-5 * max(np.abs(seen.by_parameters[:, :, k] * step).max(), 1.0), symbol


def test_ground_points_lie_where_the_image_shows_them(sensor):
    values = shifted(sensor)
    heights = sensor.place.geographic_from_block(GROUND)[:, 2]
    again = sensor.localise(sensor.observe(GROUND, values).xy_px, heights, values)
    assert np.abs(again - GROUND).max() < 1e-4


def test_the_projection_fulfils_the_condition(sensor):
    values = shifted(sensor)
    P = sensor.rotation @ (GROUND - sensor.centre).T
    g, J = sensor.condition_and_jacobian(*sensor.start(P, values), *P, *values)
    assert np.abs(g).max() < 1e-12
    assert sensor.in_front(P).all()
    if sensor.local_width:
        few, slopes, touched = sensor.local(sensor.start(P, values), P, values)
        full = np.zeros((2, len(values), len(GROUND)))
        for n, row in enumerate(touched):
            full[:, row, n] += slopes[:, 5:, n]
        np.testing.assert_allclose(full, J[:, 5:], atol=1e-9 * np.abs(J[:, 5:]).max())
        assert np.abs(few).max() < 1e-9


def test_it_begins_where_nobody_states_anything(kind, sensor):
    first = kind.begun(next(iter(sensor.state.values())), sensor.place, sensor.size_px)
    usual = first.usual_priors()
    assert all(usual[s] > 0 for s in first.symbols)
    assert (first.prior_px() > 0).all()
    assert kind.assumed(next(iter(sensor.state.values())))[1]


def test_an_rpc_stands_for_it(sensor):
    values = shifted(sensor)
    low, high = sensor.heights_m or (PLACE[2] - 400, PLACE[2] + 400)
    rpc, _ = sensor.as_rpc(values, (low, high), ((), np.zeros((0, 0))))
    there = rpc.project(sensor.place.geographic_from_block(GROUND))
    assert np.abs(there - sensor.observe(GROUND, values).xy_px).max() < 0.1


def test_arrays_keep_it_exactly(sensor):
    values = shifted(sensor)
    camera = scene_camera("one", sensor, values=dict(zip(sensor.symbols, values.tolist(), strict=True)))
    view = view_of(camera)
    block = block_of(
        [camera], [0], [view.centre], [view.rotation], GROUND, *control_table(20, 4, 4, 0.1), held=np.ones(1, bool),
        place=sensor.place,
    )  # fmt: skip
    again = block_of_arrays(arrays_of_block(block)).cameras[0]
    assert again.scene.symbols == sensor.symbols
    np.testing.assert_array_equal(again.scene.observe(GROUND, values).xy_px, sensor.observe(GROUND, values).xy_px)
    assert replace(again, scene=None) == replace(camera, scene=None)
    assert isinstance(block.images, Images)


def test_its_keys_make_it_again(kind, sensor, tmp_path):
    camera = scene_camera("one", replace_file(sensor, tmp_path))
    lines = scene_lines(camera, 1)
    (tmp_path / "block.toml").write_text("\n".join(lines) + "\n", encoding="utf-8")
    section = read_toml(tmp_path / "block.toml")
    model = next(iter(sensor.state.values()))
    keys = {k.name: key_value(section, k, model, {}, {}) for k in kind.keys}
    again = kind.of_keys(model, sensor.place, sensor.size_px, None, keys)
    assert again.key_values == sensor.key_values
    assert again.symbols == sensor.symbols
    assert set(section.values) - set(KEYS) == {*sensor.key_values, *sensor.symbols}


def replace_file(sensor, folder):
    sensor.file = folder / "scene.xml"
    return sensor
