"""Given values that contradict the others are named before what they tear."""

from dataclasses import replace

import numpy as np
import pytest

from raybundle import adjust
from raybundle.adjustment.records.options import AdjustmentOptions
from raybundle.block import Role
from raybundle.errors import NotSolvable
from raybundle.placing.mirror_mends import MENDS, USUAL
from raybundle.planning.simulate import Survey, simulate
from raybundle.planning.synthetic_networks import TargetField, field_scene
from tests.messages import with_details

OPTIONS = AdjustmentOptions(jobs=1)


def block_with(**survey):
    given = {"scale_bars": 2, "control": 6, "control_sigma": (0.001, 0.001, 0.001), **survey}
    return simulate(field_scene(TargetField(stations=4, frontal=0)), Survey(seed=5, **given)).observed


def answer(block, **options):
    """The messages of the refusal, or those of the faults."""
    try:
        notices = adjust(block, replace(OPTIONS, **options)).notices
    except NotSolvable as error:
        return with_details(error.message)
    return with_details(*(n.data for n in notices if n.severity == "fault"))


def unit_of(group, found):
    """The unit in which a group's lengths seem to be."""
    (values,) = (m.values for m in found if m.code == "groups_contradict.group" and m.values["group"] == group)
    return values["unit"]


def mends(found):
    """How control has to be mirrored."""
    return {m.values["mend"] for m in found if m.code == "control_contradicts.mend"}


def with_lengths(block, factor):
    d = block.distances
    return block.having(replace(d, length=np.asarray(d.length) * factor))


UNITS = [(1e3, "mm"), (1e2, "cm"), (1e-3, "km"), (1 / 0.3048, "feet"), (1 / 0.0254, "inches")]


@pytest.mark.parametrize(("factor", "unit"), UNITS)
def test_the_unit_of_scale_bars_is_named(factor, unit):
    assert unit_of("bars", answer(with_lengths(block_with(), factor))) == unit


@pytest.mark.parametrize(("factor", "unit"), [(1e3, "mm"), (1e2, "cm"), (1 / 0.3048, "feet")])
def test_control_in_another_unit_beside_bars_is_asked_for_too(factor, unit):
    block = block_with()
    control = block.points.is_control.any(axis=1)
    xyz = np.where(control[:, None], block.points.xyz * factor, block.points.xyz)
    sigma = np.where(control[:, None], block.points.sigma * factor, block.points.sigma)
    found = answer(replace(block, points=replace(block.points, xyz=xyz, sigma=sigma)))
    assert unit in {m.values.get("other_unit") or m.values.get("unit") for m in found}


@pytest.mark.parametrize("factor", [1.0, 1.0002, 0.9998])
def test_right_lengths_are_not_accused(factor):
    found = answer(with_lengths(block_with(scale_bar_sigma=1e-3), factor))
    assert not [m.code for m in found if "contradict" in m.code]


def test_positions_in_degrees_are_named():
    block = block_with(station_sigma=0.01)
    s = block.stations
    degrees = np.array([8.25, 47.5, 400.0]) + s.xyz / [75e3, 111e3, 1.0]
    assert unit_of("positions", answer(block.having(replace(s, xyz=degrees)))) == "degrees"


@pytest.mark.parametrize("mend", list(MENDS))
def test_mirrored_control_is_named_by_its_mend(mend):
    block = block_with(scale_bars=0)
    axes, signs = MENDS[mend]
    control = block.points.is_control.any(axis=1)
    xyz = block.points.xyz.copy()
    xyz[control] = xyz[control][:, np.argsort(axes)] * np.array(signs)
    mirrored = replace(block, points=replace(block.points, xyz=xyz))
    assert mend in mends(answer(mirrored))
    blank = replace(
        mirrored,
        images=replace(
            mirrored.images, centre=np.full_like(mirrored.images.centre, np.nan),
            rotation=np.full_like(mirrored.images.rotation, np.nan),
        ),
    )  # fmt: skip
    found = mends(answer(blank))
    assert found >= set(USUAL) or mend in found


def test_right_control_is_no_mirror_image():
    block = block_with()
    assert not mends(answer(block))
    assert (np.asarray(block.points.role) == Role.CONTROL).sum() == 6
