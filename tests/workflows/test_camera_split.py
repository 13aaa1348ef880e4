"""A camera that was not the same in all photographs: said once, with what to do, and nothing that speaks against it."""

import json
import re
from dataclasses import replace
from fnmatch import fnmatchcase

import numpy as np
import pytest

from raybundle import words
from raybundle.adjustment.decision.decide import decide
from raybundle.adjustment.records.options import AdjustmentOptions
from raybundle.calibration.quality import calibration_qualities
from raybundle.numerics.progress import silent
from raybundle.planning.simulate import Survey, simulate
from raybundle.planning.synthetic_networks import TargetField, field_scene
from raybundle.report.sections.calibration import calibration_section
from raybundle.workflows.calibrating.camera_split import cameras_apart
from raybundle.workflows.calibrating.target_block import reweighted, with_values

MOVED = (1, 4, 5, 9)


@pytest.fixture(scope="module")
def unsteady():
    """A field seen by a camera whose zoom moved in some photographs, in no order."""
    plan = TargetField(stations=10, frontal=2)
    block = simulate(field_scene(plan), Survey(image_sigma_px=0.1, orientation="exact", points="exact")).observed
    o = block.observations
    middle = np.array([block.cameras[0].width_px, block.cameras[0].height_px]) / 2
    moved = np.isin(o.image, MOVED)[:, None]
    xy = np.where(moved, middle + 1.002 * (o.xy_px - middle), o.xy_px)
    camera = replace(block.cameras[0], estimate="auto")
    start = replace(block, observations=replace(o, xy_px=xy), cameras=(camera,))
    settings = AdjustmentOptions(jobs=1, noise="white")
    first = decide(start, settings, silent)
    start = reweighted(with_values(start, first.adjusted), first.sigma0)
    _, after, told = cameras_apart(start, first, settings, silent)
    return replace(after, notices=(*told, *after.notices))


def test_the_groups_are_named_in_full_as_an_option(unsteady):
    (notice,) = [n for n in unsteady.notices if n.code == "unstable_camera"]
    (pattern,) = [json.loads(found) for found in re.findall(r'own_camera=("[^"]*[|][^"]*")', notice.text)]
    ids = unsteady.given.images.ids
    named = {i for i, name in enumerate(ids) if any(fnmatchcase(name, p) for p in pattern.split("|"))}
    assert named in (set(MOVED), set(range(len(ids))) - set(MOVED))


def test_no_more_photographs_of_a_camera_that_changes_are_proposed(unsteady):
    (quality,) = calibration_qualities(unsteady)
    assert quality.unstable
    assert not quality.advice
    (uncertain,) = [
        m for r in quality.reasons for m in r.messages if m.code == "calibration_quality.uncertain"
    ] or [None]  # fmt: skip
    assert uncertain is None or uncertain.values["unstable"]


def test_the_report_agrees_with_itself(unsteady):
    qualities = calibration_qualities(unsteady)
    text = str(calibration_section(qualities).parts)
    assert words.headline("front.next", {}) in text
    assert words.headline("calibration_quality.photograph_next", {}) not in text
    assert words.headline("calibration_quality.no_advice", {}) not in text
    assert words.headline("calibration_quality.as_predicted", {"unstable": False}) not in text
