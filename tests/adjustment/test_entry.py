"""Blocks and options that come from Python are refused by name where nothing can be adjusted with them."""

from dataclasses import replace

import numpy as np
import pytest

from raybundle import AdjustmentOptions, InputError, adjust
from raybundle.adjustment.estimation import reject_single_rays
from raybundle.block.rejection import Rejection, RejectionKind
from raybundle.planning.simulate import Survey, simulate
from raybundle.planning.synthetic_networks import TargetField, field_scene

PLAN = TargetField(stations=3, frontal=2, rows=3, columns=4)
BLOCK = simulate(field_scene(PLAN), Survey(control=4, control_sigma=(1e-3,) * 3)).observed


def changed(table, name, change):
    part = getattr(BLOCK, table)
    value = getattr(part, name).copy()
    return replace(BLOCK, **{table: replace(part, **{name: change(value)})})


def put(at, number):
    def change(value):
        value[at] = number
        return value

    return change


OPTIONS = {
    "datum": "x", "reject": "snoping", "estimate": "snoping", "residuals": None, "noise": "grey", "datum_over": 5,
    "max_iterations": 0, "jobs": -1, "tolerance": float("nan"), "significance": 2.0, "datum_points": "p1",
    "robust_start": "yes", "pixel_shape": "round", "weights": 3,
}  # fmt: skip
CONTROL = int(np.flatnonzero(BLOCK.points.is_control.all(axis=1))[0])
WRONG = {
    "an image before the first": (
        "observations",
        "image",
        put(0, -1),
        r"observations\.image.*0.*1.*block\.position_out_of_range",
    ),
    "an image after the last": (
        "observations",
        "image",
        put(3, 10**6),
        r"observations\.image\[3\].*block\.position_out_of_range",
    ),
    "a point after the last": ("observations", "point", put(0, 10**6), r"0.*block\.position_out_of_range"),
    "no positions": ("observations", "image", lambda v: v.astype(float), r"block\.not_whole_numbers"),
    "a camera that is none": ("images", "camera", put(0, 7), r"images\.camera.*block\.position_out_of_range"),
    "a row too few": ("observations", "xy_px", lambda v: v[:-1], r"block\.shape"),
    "no columns": ("observations", "xy_px", lambda v: v.ravel(), r"block\.shape"),
    "a list": ("observations", "xy_px", lambda v: v.tolist(), r"block\.shape"),
    "texts": ("observations", "xy_px", lambda v: v.astype(str), r"block\.not_numbers"),
    "no finite place": ("observations", "xy_px", put((0, 0), np.nan), r"block\.number_too_large"),
    "a place far away": ("observations", "xy_px", put((0, 0), 1e150), r"1\.?0*e\+?150.*block\.number_too_large"),
    "a negative sigma": ("points", "sigma", put((CONTROL, 1), -1.0), r"1.*Y.*point\.sigma_out_of_range"),
    "an infinite sigma": ("points", "sigma", put((CONTROL, 0), np.inf), r"X.*point\.sigma_out_of_range"),
    "control without a coordinate": ("points", "xyz", put((CONTROL, 2), np.nan), r"point\.no_coordinate"),
    "an infinite coordinate": ("points", "xyz", put((0, 2), np.inf), r"block\.number_too_large"),
}


@pytest.mark.parametrize("name", OPTIONS)
def test_options_that_mean_nothing_are_refused(name):
    with pytest.raises(InputError, match=rf"{name}.*adjustment\.option_(choice|range|not_names|not_bool)"):
        adjust(BLOCK, AdjustmentOptions(**{name: OPTIONS[name]}))


@pytest.mark.parametrize("case", WRONG)
def test_what_is_wrong_in_a_block_is_named(case):
    table, name, change, words = WRONG[case]
    with pytest.raises(InputError, match=words):
        adjust(changed(table, name, change))


def test_what_is_no_block_is_refused():
    with pytest.raises(InputError, match=r"adjustment\.block_type"):
        adjust("path/to/block")
    with pytest.raises(InputError, match=r"AdjustmentOptions.*adjustment\.options_type"):
        adjust(BLOCK, {"datum": "inner"})


def test_what_is_right_passes():
    assert adjust(BLOCK, AdjustmentOptions(max_iterations=np.int64(50), jobs=1)).converged


def test_a_parameter_is_observed_at_its_default_where_the_camera_gives_no_value():
    block = simulate(field_scene(TargetField()), Survey(scale_bars=1, interior="exact")).observed
    camera = block.cameras[0]
    free = ("c", "x0", "y0", "K1", "A")
    values = {s: v for s, v in camera.values.items() if s != "A"}
    observed = replace(camera, values=values, estimate=free, sigma={"A": 1e-4})
    told = adjust(block.with_cameras(observed)).interior[0].parameters["A"]
    zero = replace(observed, values={**values, "A": 0.0})
    assert told.value == pytest.approx(adjust(block.with_cameras(zero)).interior[0].parameters["A"].value, abs=1e-12)


def test_the_last_ray_of_a_point_leaves_with_the_others_but_not_of_control():
    block, m = BLOCK, len(BLOCK.observations)
    o, control = block.observations, block.points.is_control.any(axis=1)
    mask = np.random.default_rng(2).random(m) < 0.6
    given = tuple(Rejection(kind=RejectionKind.GIVEN) if k else None for k in mask)
    reasons, lost = reject_single_rays(block, given, mask)
    left = {p: [k for k in range(m) if o.point[k] == p and not mask[k]] for p in range(len(block.points))}
    lone = {rows[0] for p, rows in left.items() if len(rows) == 1 and not control[p]}
    assert any(len(rows) == 1 and control[p] for p, rows in left.items())
    assert {k for k in range(m) if lost[k] and not mask[k]} == lone
    assert lost[mask].all()
    assert {k for k, r in enumerate(reasons) if r is not None and r.kind is RejectionKind.SINGLE_RAY} == lone
    assert [r for r, k in zip(reasons, mask, strict=True) if k] == [r for r in given if r]
