"""Networks that are degenerate by construction, the perturbations that must not matter, and what is said of each."""

from __future__ import annotations

import json
import re
import sys
from dataclasses import dataclass, replace

import numpy as np

from raybundle import adjust
from raybundle.adjustment.records.options import AdjustmentOptions
from raybundle.block import Block, Role
from raybundle.errors import RaybundleError
from raybundle.planning.flights.uav_networks import Flight, flight_block
from raybundle.planning.network.calibration_networks import FlatField, flat_field_scene
from raybundle.planning.simulate import Survey, simulate
from raybundle.planning.synthetic_networks import Scene, TargetField, brown_camera, field_scene, look_at
from tests.truth.mixed_blocks import room

EXACT = Survey(seed=1, orientation="exact", points="exact", interior="exact", image_sigma_px=0.05)
GIVEN = AdjustmentOptions(jobs=1)
AUTO = AdjustmentOptions(jobs=1, estimate="auto")
SNOOPING = AdjustmentOptions(jobs=1, estimate="auto", reject="snooping")


def _flat(plan: FlatField) -> Block:
    return simulate(flat_field_scene(plan), EXACT).observed


def _all_free(block: Block) -> Block:
    points = block.points
    return replace(
        block,
        points=replace(points, role=np.full_like(points.role, Role.TIE), sigma=np.full_like(points.sigma, np.nan)),
    )


def _blank(block: Block) -> Block:
    """Without approximate values."""
    images, points = block.images, block.points
    return replace(
        block,
        images=replace(
            images, centre=np.full_like(images.centre, np.nan), rotation=np.full_like(images.rotation, np.nan)
        ),
        points=replace(points, xyz=np.where(points.is_control, points.xyz, np.nan)),
    )


def windows_of_one_picture() -> Block:
    """As a camera sees a plane along which it moves: only the ratio of the camera constant to the distance shows."""
    scene = flat_field_scene(FlatField(tilt_deg=0.0, photographs=4, points=14, size=1.4))
    moved = np.array([[0.08 * k, 0.05 * k, 1.5] for k in range(4)])
    return simulate(replace(scene, centre=moved), EXACT).observed


def square_views_from_nothing() -> Block:
    """Square views of a plane, no orientation given, four control points: one image sees them all, the others three.

    Three points leave four exact poses of an image; which of them comes first is rounding.
    """
    scene = flat_field_scene(FlatField(tilt_deg=0.0, shift=0.5, photographs=4, size=2.8, points=14))
    block = simulate(scene, EXACT).observed
    wanted = np.array([[-0.3, -0.1, 0.0], [0.3, -0.1, 0.0], [-0.1, 0.3, 0.0], [0.5, 0.5, 0.0]])
    known = [int(np.argmin(np.linalg.norm(block.points.xyz - xyz, axis=1))) for xyz in wanted]
    role, sigma = np.full_like(block.points.role, Role.TIE), np.full_like(block.points.sigma, np.nan)
    role[known], sigma[known] = Role.CONTROL, 0.001
    o = block.observations
    keep = (o.image == 0) | (o.point != known[3])
    seen = replace(o, image=o.image[keep], point=o.point[keep], xy_px=o.xy_px[keep], cov_px2=o.cov_px2[keep])
    return _blank(replace(block, points=replace(block.points, role=role, sigma=sigma), observations=seen))


def control_on_a_line() -> Block:
    """Points in space, and control on one straight line through them: the rotation about it stays open."""
    scene = field_scene(TargetField(stations=6, frontal=0, tilt_deg=20.0, camera=brown_camera(estimate=())))
    line = np.linspace(-0.8, 0.8, 4)[:, None] * np.array([0.8, 0.5, 0.1])
    block = simulate(replace(scene, xyz=np.vstack([scene.xyz, line])), EXACT).observed
    known = np.arange(len(block.points)) >= len(block.points) - 4
    rng = np.random.default_rng(2)
    xyz = np.where(known[:, None], block.points.xyz + rng.normal(0, 0.001, block.points.xyz.shape), block.points.xyz)
    points = replace(
        block.points,
        xyz=xyz,
        role=np.where(known, Role.CONTROL, Role.TIE).astype(block.points.role.dtype),
        sigma=np.where(known[:, None], 0.001, np.nan) * np.ones(3),
    )
    return replace(block, points=points)


def scattered() -> Block:
    """Image points that lie anywhere within a fifth of the image about where they belong."""
    block = simulate(field_scene(TargetField(stations=6, frontal=0, camera=brown_camera(estimate=()))), EXACT).observed
    camera, o = block.cameras[0], block.observations
    noise = 0.2 * np.hypot(camera.width_px, camera.height_px) * np.random.default_rng(4).normal(size=o.xy_px.shape)
    return replace(block, observations=replace(o, xy_px=o.xy_px + noise))


def two_images() -> Block:
    scene = field_scene(TargetField(stations=2, frontal=0, tilt_deg=15.0))
    return simulate(scene, EXACT).observed


def collinear_points() -> Block:
    scene = field_scene(TargetField(stations=6, frontal=0, camera=brown_camera(estimate=())))
    line = np.linspace(-1, 1, 30)[:, None] * np.array([1.0, 0.2, 0.0])
    return simulate(replace(scene, xyz=line), EXACT).observed


def one_place() -> Block:
    """A camera that only turns."""
    scene = field_scene(TargetField(stations=6, frontal=0, tilt_deg=20.0, camera=brown_camera(estimate=("c",))))
    here = np.repeat(np.array([[0.0, 0.0, 2.2]]), len(scene.centre), axis=0)
    aims = np.column_stack([np.linspace(-0.3, 0.3, len(here)), np.linspace(-0.2, 0.2, len(here)), np.zeros(len(here))])
    turning = Scene(camera=scene.camera, centre=here, rotation=look_at(here, aims), xyz=scene.xyz)
    return simulate(turning, EXACT).observed


def level_flight() -> Block:
    """Positions observed, everything exactly level at one height: camera constant and height show together only."""
    return flight_block(Flight(lines=3, photographs=5, points=14, height_jitter=0.0, angle_jitter_deg=0.0))


def an_image_with_two_points() -> Block:
    block = simulate(field_scene(TargetField(stations=6)), EXACT).observed
    o = block.observations
    mine = np.flatnonzero(o.image == 3)
    keep = np.ones(len(o), bool)
    keep[mine[2:]] = False
    return replace(
        block,
        observations=replace(o, image=o.image[keep], point=o.point[keep], xy_px=o.xy_px[keep], cov_px2=o.cov_px2[keep]),
    )


CASES = {
    "square views of a plane": (lambda: _flat(FlatField(tilt_deg=0.0, shift=0.1)), GIVEN),
    "square views, three distances": (
        lambda: _flat(FlatField(tilt_deg=0.0, shift=0.1, distances=(1.2, 1.5, 1.8))),
        GIVEN,
    ),
    "square views, automatic": (
        lambda: _flat(FlatField(tilt_deg=0.0, shift=0.1, distances=(1.2, 1.5, 1.8))),
        AUTO,
    ),
    "square views of a plane, from nothing": (square_views_from_nothing, GIVEN),
    "no rolls": (lambda: _flat(FlatField(tilt_deg=30.0, up_to_centre=True)), GIVEN),
    "no rolls, automatic": (lambda: _flat(FlatField(tilt_deg=30.0, up_to_centre=True)), AUTO),
    "windows of one picture": (windows_of_one_picture, AUTO),
    "windows of one picture, from nothing": (lambda: _blank(windows_of_one_picture()), SNOOPING),
    "level flight": (level_flight, GIVEN),
    "one panorama": (lambda: _all_free(room(stations=1)), GIVEN),
    "one panorama, little control": (lambda: room(stations=1), GIVEN),
    "two images": (two_images, GIVEN),
    "two images, automatic": (two_images, SNOOPING),
    "collinear points": (collinear_points, GIVEN),
    "control on a line": (control_on_a_line, GIVEN),
    "control on a line, from nothing": (lambda: _blank(control_on_a_line()), GIVEN),
    "one place": (one_place, GIVEN),
    "scattered image points": (scattered, GIVEN),
    "an image with two points": (an_image_with_two_points, GIVEN),
}


def perturbed(block: Block, seed: int) -> Block:
    """The block with other last bits of its image points and its rows in another order; 0: as it is."""
    if not seed:
        return block
    rng = np.random.default_rng(seed)
    i, p, o = block.images, block.points, block.observations
    bits = o.xy_px * (1 + np.finfo(float).eps * rng.integers(-1, 2, o.xy_px.shape))
    images, points, rows = (rng.permutation(n) for n in (len(i), len(p), len(o)))
    at_image, at_point = np.argsort(images), np.argsort(points)
    held = None if i.held is None else i.held[images]
    assert not i.interior
    whole = replace(
        block,
        images=replace(
            i, ids=tuple(i.ids[k] for k in images), camera=i.camera[images], file=tuple(i.file[k] for k in images),
            centre=i.centre[images], rotation=i.rotation[images], held=held,
        ),
        points=replace(
            p, ids=tuple(p.ids[k] for k in points), role=np.asarray(p.role)[points], xyz=p.xyz[points],
            sigma=p.sigma[points],
        ),
        observations=replace(
            o, image=at_image[o.image[rows]].astype(np.int32), point=at_point[o.point[rows]].astype(np.int32),
            xy_px=bits[rows], cov_px2=o.cov_px2[rows],
        ),
    )  # fmt: skip
    return whole.of_tables(lambda t: t.renumbered("image", at_image).renumbered("point", at_point))


SAID = {"not_determinable", "held_not_determinable", "control_leaves_open"}


@dataclass(frozen=True)
class Verdict:
    """What a user is told: exit status, held or lost parameters, and the sentence without its figures."""

    status: int
    lost: tuple[str, ...]
    sentence: str


def _plain(words: str) -> str:
    return re.sub(r"[-+]?\d+(\.\d+)?(e[-+]?\d+)?", "#", words)


def verdict(name: str, seed: int = 0) -> Verdict:
    """The verdict on a perturbed case, through the door that users take."""
    make, options = CASES[name]
    try:
        result = adjust(perturbed(make(), seed), options)
    except RaybundleError as error:
        return Verdict(error.exit_status, (type(error).__name__,), _plain(str(error)))
    said = sorted({n.code for n in result.notices if n.code in SAID})
    return Verdict(0, tuple(sorted(result.not_determinable)), " ".join((*said, *result.datum_defect)))


def main() -> None:
    """The verdicts of one process as a line of JSON: cases, then how many perturbations."""
    count = int(sys.argv[1])
    for name in sys.argv[2:] or CASES:
        found = [verdict(name, seed) for seed in range(count)]
        sys.stdout.write(json.dumps({"case": name, "verdicts": [[v.status, v.lost, v.sentence] for v in found]}) + "\n")
        sys.stdout.flush()


if __name__ == "__main__":
    main()
