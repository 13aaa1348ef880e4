"""Simulated networks, adjusted as a user adjusts them: options.scene, options.survey, options.adjust, options.runs."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
from tests.orientation.rig_blocks import rig_block
from tests.truth.door_blocks import CASES
from tests.truth.platform_blocks import camera_of
from tests.truth.real_noise import with_smooth_errors

from ledger.errors import Collected, Errors
from ledger.judges.truth_of_blocks import collect
from ledger.sets import LedgerSet, Places
from raybundle import adjust
from raybundle.adjustment.records.options import AdjustmentOptions
from raybundle.block import Block
from raybundle.planning.flights.uav_networks import Flight, flight_scene
from raybundle.planning.simulate import Survey, simulate
from raybundle.planning.synthetic_networks import (
    AerialStrips,
    Ring,
    Scene,
    SinglePhoto,
    TargetField,
    aerial_scene,
    field_scene,
    ring_scene,
    single_scene,
)

APART = 10_000
"""Between the seeds of the first runs of two sets"""
SCENES = {
    "field": (TargetField, field_scene),
    "ring": (Ring, ring_scene),
    "aerial": (AerialStrips, aerial_scene),
    "flight": (Flight, flight_scene),
    "photograph": (SinglePhoto, single_scene),
}


def scene_named(given: dict) -> Scene:
    """The scene of options.scene: kind, and what its plan takes; camera = model, free = parameters, of a camera."""
    given = dict(given)
    plan, make = SCENES[given.pop("kind")]
    model, free, values = given.pop("camera", ""), given.pop("free", None), given.pop("values", {})
    scene = make(plan(**{k: tuple(v) if isinstance(v, list) else v for k, v in given.items()}))
    camera = camera_of(model, id="1", values=values) if model else scene.camera
    if not model and values:
        camera = replace(camera, values={**camera.values, **values})
    if free is not None:
        camera = replace(camera, estimate=tuple(free))
    return replace(scene, camera=camera)


def draw(one: LedgerSet, seed: int) -> tuple[Block, Block]:
    """The block at its true values, and what was measured in run `seed`."""
    o = one.options
    if "door" in o:
        case = CASES[o["door"]]().clean
        return case.truth, case.given(seed)[0]
    if "rig" in o:
        how = {"seed": o.get("seed", 1), **o.get("rig_settings", {})}
        truth = rig_block(o["rig"], noise=False, **how)
        return truth, _noisy(truth, np.random.default_rng([seed, 46]))
    survey = {k: tuple(v) if isinstance(v, list) else v for k, v in o.get("survey", {}).items()}
    made = simulate(scene_named(o["scene"]), Survey(**{"seed": seed, **survey}))
    block = made.observed
    if "smooth" in o:
        block = with_smooth_errors(block, np.random.default_rng([seed, 47]), **o["smooth"])
    return made.truth, block


def _noisy(truth: Block, rng: np.random.Generator) -> Block:
    o, p = truth.observations, truth.points
    sigma = np.sqrt(o.cov_px2[:, :2])
    moved = np.where(p.is_control, np.nan_to_num(p.sigma) * rng.normal(0, 1, p.xyz.shape), 0.0)
    return replace(
        truth, observations=replace(o, xy_px=o.xy_px + sigma * rng.normal(0, 1, sigma.shape)),
        points=replace(p, xyz=p.xyz + moved),
    )  # fmt: skip


def judge(one: LedgerSet, _places: Places) -> list[Errors]:
    """Errors of all runs."""
    collected = Collected()
    options = AdjustmentOptions(**{"jobs": 1, "noise": "white", **one.options.get("adjust", {})})
    first = APART * one.source["seed"]  # no two sets draw the same errors
    for seed in range(first, first + one.options["runs"]):
        truth, block = draw(one, seed)
        collect(collected, adjust(block, options), truth, seed, one.judged)
    return collected.errors()
