"""Tables of where a source shows what a reference shows: as exact as the models, for every kind of sensor."""

from dataclasses import replace

import numpy as np
import pytest

from raybundle.adjustment.system.predict import predicted_px
from raybundle.errors import InputError
from raybundle.platforms import sensor_models
from raybundle.surfaces.depths import transfer as module
from raybundle.surfaces.depths.rays import ReferenceRays
from raybundle.surfaces.depths.transfer import (
    MOST_NODES,
    TOLERANCE_PX,
    Projection,
    Transfer,
    lagrange,
    places_in,
    transfer,
)
from tests.messages import refused
from tests.surface import scene
from tests.surface.transfer_oracle import places_of


@pytest.mark.parametrize("model", scene.VALUES)
def test_tables_are_as_exact_as_the_models(model):
    block = scene.blocks(model)
    rays = ReferenceRays.of(block, 0)
    rng = np.random.default_rng(2)
    xy = rng.uniform(0.5, [scene.WIDTH - 0.5, scene.HEIGHT - 0.5], (400, 2))
    t = rng.uniform(*scene.RANGE, 400)
    for source in (1, 3):
        table = transfer(block, rays, source, scene.RANGE)
        exact = predicted_px(block, source, rays.points(xy, t))
        inside = ((exact > 0) & (exact < [scene.WIDTH, scene.HEIGHT])).all(axis=1)
        assert inside.sum() > 50
        e = np.abs(table.at(xy[inside], t[inside]) - exact[inside])
        known = np.isfinite(e).all(axis=1)
        assert known.mean() > 0.9
        assert e[known].max() < TOLERANCE_PX
        assert table.error_px < TOLERANCE_PX


@pytest.mark.parametrize("model", scene.VALUES)
def test_a_table_of_a_part_of_the_format_is_as_exact_there_and_smaller(model):
    block = scene.blocks(model)
    rays = ReferenceRays.of(block, 0)
    box = (0.35 * scene.WIDTH, 0.4 * scene.HEIGHT, 0.6 * scene.WIDTH, 0.55 * scene.HEIGHT)
    table = transfer(block, rays, 1, scene.RANGE, box)
    xy, t = (np.random.default_rng(2).uniform(*between, n) for between, n in (((box[:2], box[2:]), (300, 2)),
                                                                              (scene.RANGE, 300)))  # fmt: skip
    exact = predicted_px(block, 1, rays.points(xy, t))
    inside = ((exact > 0) & (exact < [scene.WIDTH, scene.HEIGHT])).all(axis=1)
    assert inside.sum() > 50
    e = np.abs(table.at(xy[inside], t[inside]) - exact[inside])
    assert np.isfinite(e).all(axis=1).mean() > 0.9
    assert np.nanmax(e) < TOLERANCE_PX
    for nodes, span in zip(table.places.shape[1::-1], (box[2] - box[0], box[3] - box[1]), strict=True):
        assert span <= (nodes - 1) * table.step_px < max(1.5 * span, span + table.step_px)
    assert (table.u0_px, table.v0_px) == box[:2]


def test_a_depth_that_is_not_known_has_no_place():
    """With the kernel and without it."""
    block = scene.blocks("brown")
    table = transfer(block, ReferenceRays.of(block, 0), 1, scene.RANGE)
    xy, t = np.array([[20.5, 30.0], [100.0, 90.25]]), np.array([0.1, np.nan])
    for found in (table.at(xy, t), places_of(table, xy, t)):
        assert np.isfinite(found[0]).all()
        assert np.isnan(found[1]).all()


def test_depth_and_pixel_say_where_a_point_is():
    block = scene.blocks("brown_rolling")
    rays = ReferenceRays.of(block, 0)
    xy, t = np.array([[20.5, 30.0], [100.0, 90.25]]), np.array([0.1, 0.12])
    xyz = rays.points(xy, t)
    assert np.allclose(rays.parameter(xy, xyz), t)
    assert np.allclose(predicted_px(block, 0, xyz), xy, atol=1e-6)


def test_a_plane_is_linear_in_the_pixels_of_a_central_perspective():
    block = scene.blocks("brown")
    camera = replace(block.cameras[0], values={**block.cameras[0].values, "K1": 0.0, "P1": 0.0})
    rays = ReferenceRays.of(block.with_cameras(camera), 1)
    xy = scene.pixels()
    origin, d = rays.rays(xy)
    normal = np.array([0.2, -0.1, 1.0])
    t = (d @ normal) / -(origin @ normal)
    linear = np.column_stack([np.ones(len(xy)), xy])
    fitted = linear @ np.linalg.lstsq(linear, t, rcond=None)[0]
    assert np.abs(fitted - t).max() < 1e-12


def all_round():
    """Panoramas of which one column in 400 is a 400th of the circle."""
    block = scene.blocks("panorama")
    camera = block.cameras[0]
    values = {**camera.values, "c": 400 * camera.pixel_mm[0] / (2 * np.pi)}
    return block.with_cameras(replace(camera, values=values, width_px=400))


def test_panoramas_know_distances_and_begin_anew_at_their_seam():
    block = all_round()
    rays = ReferenceRays.of(block, 0)
    assert rays.axis is None
    table = transfer(block, rays, 1, scene.RANGE)
    rng = np.random.default_rng(1)
    xy, t = rng.uniform([0.5, 20], [399.5, 100], (500, 2)), rng.uniform(*scene.RANGE, 500)
    xyz = rays.points(xy, t)
    assert np.allclose(np.linalg.norm(xyz - rays.rays(xy)[0], axis=1), 1 / t)
    exact = predicted_px(block, 1, xyz)
    e = np.abs(table.at(xy, t) - exact).max(axis=1)
    assert np.isfinite(e).mean() > 0.9  # the others are near the seam
    assert np.nanmax(e) < TOLERANCE_PX


def test_derivatives_of_the_interpolation_are_those_of_a_cubic():
    f = np.linspace(0, 3, 13)
    nodes = np.arange(4.0) ** 3 - 2 * np.arange(4.0) ** 2
    value, first, second = (w @ nodes for w in lagrange(f))
    assert np.allclose(value, f**3 - 2 * f**2)
    assert np.allclose(first, 3 * f**2 - 4 * f)
    assert np.allclose(second, 6 * f - 4)


def test_what_cannot_be_tabulated_is_refused():
    block = scene.blocks("fisheye")
    rays = ReferenceRays.of(block, 0)
    with refused("depth_map.depth_range"):
        transfer(block, rays, 1, (0.2, 0.1))
    unknown = replace(block.images, centre=np.full((5, 3), np.nan))
    with refused("image.not_oriented", image="1"):
        ReferenceRays.of(replace(block, images=unknown), 1)
    with refused("depth_map.projection_table", image="1", limit_px=1e-12):
        transfer(block, rays, 1, scene.RANGE, tolerance_px=1e-12)


def test_every_kind_of_platform_is_among_them():
    assert {"brown_rolling", "brown_mounted", "pushbroom", "panorama", "fisheye"} <= set(scene.VALUES) & set(
        sensor_models
    )


def test_where_no_table_fits_places_are_projected(monkeypatch):
    """As where a source stands among the depths, whose rays no table follows: none grows beyond all memory."""
    assert MOST_NODES * 16 < 3e8
    block = scene.blocks("brown")
    rays = ReferenceRays.of(block, 0)
    table = places_in(block, rays, 1, scene.RANGE)
    assert isinstance(table, Transfer)
    assert table.error_px < module.LOOKED_UP_PX
    monkeypatch.setattr(module, "MOST_NODES", 100)
    monkeypatch.setattr(module, "COARSEST_PX", 4 * scene.WIDTH)
    monkeypatch.setattr(module, "LOOKED_UP_PX", 1e-9)
    with pytest.raises(InputError, match=r"depth_map\.projection_table"):
        transfer(block, rays, 1, scene.RANGE, tolerance_px=1e-9)
    found = places_in(block, rays, 1, scene.RANGE)
    assert isinstance(found, Projection)
    xy, t = np.array([[20.5, 30.0], [100.0, 90.25]]), np.full(2, scene.RANGE[0])
    assert np.allclose(found.at(xy, t), predicted_px(block, 1, rays.points(xy, t)), equal_nan=True)
