"""Adjustments as a report may meet them: rich ones, and those that lack something."""

from dataclasses import replace

import numpy as np
import pytest

from raybundle.adjustment.decision.decide import decide
from raybundle.adjustment.engine import adjust_block
from raybundle.adjustment.records.notice import Notice
from raybundle.adjustment.records.options import AdjustmentOptions
from raybundle.block import Camera
from raybundle.planning.simulate import Survey, simulate
from raybundle.planning.synthetic_networks import SinglePhoto, TargetField, brown_camera, field_scene, single_scene

EXACT = {"orientation": "exact", "points": "exact", "interior": "exact"}
FIELD = TargetField(rows=5, columns=6, stations=6, frontal=2)
HOSTILE = "<script>alert('x')</script>&\"“"


def field(survey=None, camera=None):
    scene = field_scene(FIELD if camera is None else replace(FIELD, camera=camera))
    return simulate(scene, survey or Survey(**EXACT)).observed


def rich(options=None):
    survey = Survey(
        control=5, control_sigma=(1e-4, 1e-4, 0.0), check=3, check_sigma=1e-4, scale_bars=2, station_sigma=0.01, **EXACT
    )
    block = field(survey)
    camera = replace(block.cameras[0], sigma={"c": 0.01})
    return adjust_block(block.with_cameras(camera), options or AdjustmentOptions())


def free():
    return adjust_block(field(), AdjustmentOptions())


def without_statistics():
    return rich(AdjustmentOptions(statistics=False))


def one_scale_bar():
    return adjust_block(field(Survey(scale_bars=1, **EXACT)), AdjustmentOptions())


def strange_numbers():
    """Suspects, a redundancy of one, joint tests out of range, a remark, a perfect fit."""
    a = rich()
    parameter = replace(a.interior[0].parameters["c"], std=0.0, remark="as given")
    interior = replace(
        a.interior[0], parameters={**a.interior[0].parameters, "c": parameter}, joint_tests={"K1 K2": (np.inf, 0.0)}
    )
    return replace(
        a,
        interior=(interior, *a.interior[1:]),
        suspects=(("1", "2", 5.5, 0.97), ("1", "3", 4.9, np.nan)),
        critical_tau=np.nan,
        sigma0=0.0,
        condition=np.inf,
    )


def resection():
    return adjust_block(
        simulate(single_scene(SinglePhoto()), Survey(control=12, **EXACT)).observed, AdjustmentOptions()
    )


def without_redundancy():
    scene = single_scene(SinglePhoto(points=3))
    return adjust_block(simulate(scene, Survey(control=3, **EXACT)).observed, AdjustmentOptions())


def rejected():
    block = field(Survey(gross_share=0.02, gross_px=30.0, **EXACT))
    return decide(block, AdjustmentOptions(reject="snooping"))


def interior_of_each_image():
    block = field(Survey(control=25, **EXACT), brown_camera(estimate=("c", "x0", "y0")))
    return adjust_block(block.with_cameras(replace(block.cameras[0], interior="per_image")), AdjustmentOptions())


def two_cameras():
    block = field()
    second = replace(block.cameras[0], id="2", estimate=())
    index = (np.arange(len(block.images)) % 2).astype(np.int32)
    both = replace(block, cameras=(*block.cameras, second), images=replace(block.images, camera=index))
    return adjust_block(both, AdjustmentOptions())


def fisheye():
    values = {"c": 10.0, "x0": 0.02, "y0": 0.01, "K1": -3e-5, "K2": 1e-8, "K3": 0.0, "P1": 1e-5, "P2": -1e-5}
    camera = Camera(
        id="fish", model="fisheye", width_px=5000, height_px=4000, pixel_mm=(0.005, 0.005), values=values,
        estimate=("c", "x0", "y0", "K1", "K2", "P1", "P2"),
    )  # fmt: skip
    return adjust_block(field(camera=camera), AdjustmentOptions())


def unused_rows():
    """An image that nothing was measured in, and a control point that no image shows."""
    a = free()

    def more(block):
        images, points = block.images, block.points
        nowhere = np.full((1, 3), np.nan)
        return replace(
            block,
            images=replace(
                images, ids=(*images.ids, "blind"), camera=np.append(images.camera, 0).astype(np.int32),
                file=(*images.file, ""),
                centre=np.vstack([images.centre, nowhere]),
                rotation=np.concatenate([images.rotation, np.full((1, 3, 3), np.nan)]),
            ),
            points=replace(
                points, ids=(*points.ids, "unseen"), role=np.append(points.role, 1).astype(np.int32),
                xyz=np.vstack([points.xyz, np.zeros((1, 3))]), sigma=np.vstack([points.sigma, np.zeros((1, 3))]),
            ),
        )  # fmt: skip

    return adjust_block(more(a.given), AdjustmentOptions())


def hostile():
    a = rich()

    def renamed(block):
        images = tuple(f"{i}{HOSTILE}" for i in block.images.ids)
        points = tuple(f"{i}{HOSTILE}" for i in block.points.ids)
        return replace(
            block,
            name=HOSTILE,
            about=HOSTILE,
            images=replace(block.images, ids=images, file=images),
            points=replace(block.points, ids=points),
        )

    return replace(
        a,
        given=renamed(a.given),
        adjusted=renamed(a.adjusted),
        notices=(Notice(code="not_determinable", message=f"something {HOSTILE}"),),
        groups=tuple(replace(g, ids=tuple(f"{i}{HOSTILE}" for i in g.ids)) for g in a.groups),
    )


MAKERS = {
    f.__name__: f
    for f in (
        rich, free, without_statistics, resection, without_redundancy, rejected, one_scale_bar,
        strange_numbers, interior_of_each_image, two_cameras,
        fisheye, unused_rows, hostile,
    )
}  # fmt: skip
_made = {}


def made(name):
    if name not in _made:
        _made[name] = MAKERS[name]()
    return _made[name]


@pytest.fixture(scope="session")
def case():
    return made


@pytest.fixture(params=list(MAKERS))
def any_case(request):
    return made(request.param)


@pytest.fixture
def free_case():
    return made("free")
