"""Remarks and cautions that stand by themselves: each is said where it is due, and not where it is not."""

from dataclasses import replace

import numpy as np

from raybundle import adjust
from raybundle.adjustment.decision.blunder_rejection import Snooping
from raybundle.adjustment.notices import _behind
from raybundle.adjustment.records.options import AdjustmentOptions
from raybundle.block.select import with_rows
from raybundle.planning.simulate import Survey, simulate
from raybundle.planning.synthetic_networks import TargetField, brown_camera, field_scene

OPTIONS = AdjustmentOptions(jobs=1)


def observed(*, estimate=("c", "x0", "y0"), **survey):
    field = TargetField(stations=4, frontal=0, camera=brown_camera(estimate=estimate))
    return simulate(field_scene(field), Survey(seed=2, **survey)).observed


def told(result, code):
    return [n for n in result.notices if n.code == code]


def test_control_that_no_image_shows_is_named():
    block = observed(control=5, control_sigma=(1e-4, 1e-4, 1e-4))
    name = next(n for n, c in zip(block.points.ids, block.points.is_control.any(axis=1), strict=True) if c)
    tie = int(np.flatnonzero(~block.points.is_control.any(axis=1))[0])  # no image shows it either
    blind = with_rows(block, ~np.isin(block.observations.point, (block.points.ids.index(name), tie)))
    assert not told(adjust(block, OPTIONS), "control_not_observed")
    (notice,) = told(adjust(blind, OPTIONS), "control_not_observed")
    assert notice.ids == (name,)


def test_snooping_that_runs_out_of_rounds_says_that_suspects_are_left(monkeypatch):
    block = observed(gross_share=0.02, gross_px=30)
    snooping = replace(OPTIONS, reject="snooping")
    assert not told(adjust(block, snooping), "snooping_unfinished")
    monkeypatch.setattr(Snooping, "rounds", 1)
    (notice,) = told(adjust(block, snooping), "snooping_unfinished")
    assert notice.values == {"rounds": 1}


def test_photographs_with_next_to_no_redundancy_say_to_what_factor_sigma0_is_known():
    block = observed(estimate=())
    names = tuple(f"t{k + 1}" for k in range(len(block.points)))
    ties = replace(block, points=replace(block.points, ids=names))
    two = ties.observations.image < 2
    both = np.bincount(ties.observations.point[two], minlength=len(names)) == 2
    few = np.flatnonzero(both)[:8]
    pair = with_rows(ties, two & np.isin(ties.observations.point, few))
    assert not told(adjust(ties, OPTIONS), "little_redundancy")
    result = adjust(pair, OPTIONS)
    assert result.redundancy < 6
    (notice,) = told(result, "little_redundancy")
    assert notice.values["redundancy"] == result.redundancy
    assert notice.severity == "warning"


def test_what_lies_behind_the_camera_is_a_fault_of_names_a_wrong_match_or_a_turned_image():
    named = adjust(observed(), OPTIONS)
    ids = tuple(f"t{k + 1}" for k in range(len(named.given.points)))
    found = replace(named, given=replace(named.given, points=replace(named.given.points, ids=ids)))
    of_first = np.flatnonzero(named.given.observations.image == 0).tolist()
    one, many = of_first[:1], of_first[: len(of_first) // 4]
    fault, match, turned = _behind(named, one), _behind(found, one), _behind(found, many)
    assert fault.severity == "fault"
    assert fault.code == "behind_camera"
    assert match.severity == "note"
    assert match.data.code == "behind_camera.matches"
    assert turned.severity == "fault"
    assert turned.ids == (named.given.images.ids[0],)
    assert turned.data.code == "behind_camera.photographs"


def test_control_that_nothing_checks_is_named_with_the_least_error_that_would_be_found():
    loose, precise = ((sigma,) * 3 for sigma in (1e-2, 1e-6))
    assert not told(adjust(observed(control=8, control_sigma=loose), OPTIONS), "control_unchecked")
    result = adjust(observed(control=8, control_sigma=precise), OPTIONS)
    (notice,) = told(result, "control_unchecked")
    assert notice.severity == "note"
    assert "X" in {d.values["axis"] for d in notice.details}
    group = next(g for g in result.groups if g.kind == "control")
    assert set(notice.ids) == {n for n, r in zip(group.ids, group.redundancy, strict=True) if r < 0.01}
