"""Which parameters of interior orientations stay free, and whether several cameras taken for one are found.

    python benchmarks/parameter_choice.py [--draws 200] [--few 60] [--without large]

Simulated blocks with smooth errors of 0.3 px that differ from image to image.  Every draw has K3 = A = S = 0, every
second one P1 = P2 = 0.  field: targets, 16 images; flight: strips and cross lines; ten: ten cameras in 50 images;
mixed: twelve images of two cameras named as one (differences of 1 % of c, 20 px of the principal point, 5 px of K1 at
half the longer side, as standard deviations), or of one camera; large: ten cameras and 180 000 image points, processor
time, without and with smooth errors; wandering: control, and a principal point that differs from image to image by 4 px
or not at all, in adjustments of a free and of a held camera.  Prints JSON.
"""

import argparse
import json
import sys
import time
from dataclasses import replace
from pathlib import Path

import numpy as np

ROOT = Path(__file__).resolve().parents[1]
sys.path[:0] = [str(ROOT)]

from tests.adjustment.mixed_cameras import adjusted, mixed  # noqa: E402
from tests.truth.real_noise import per_parameter, with_smooth_errors  # noqa: E402

from raybundle.adjustment.decision.decide import decide  # noqa: E402
from raybundle.adjustment.evaluation.image_interiors import own_interiors  # noqa: E402
from raybundle.adjustment.records.options import AdjustmentOptions  # noqa: E402
from raybundle.calibration.several_cameras import several_cameras  # noqa: E402
from raybundle.numerics.statistics import chi_square_tails  # noqa: E402
from raybundle.planning.flights.uav_networks import Flight, flight_scene, uav_camera  # noqa: E402
from raybundle.planning.simulate import Survey, simulate  # noqa: E402
from raybundle.planning.synthetic_networks import (  # noqa: E402
    AerialStrips,
    Ring,
    TargetField,
    aerial_scene,
    brown_camera,
    field_scene,
    ring_scene,
)  # fmt: skip

SMOOTH_PX = 0.3
CAMERAS = 10
CAMERA = brown_camera()
PIXEL_MM, HALF_MM = CAMERA.pixel_mm[0], CAMERA.pixel_mm[0] * CAMERA.width_px / 2


def scene_of(case: str, seed: int):
    """A scene whose camera has no K3, A and S, and no decentring where the seed is even."""
    nil = {"K3": 0.0, "A": 0.0, "S": 0.0, **({} if seed % 2 else {"P1": 0.0, "P2": 0.0})}
    if case == "flight":
        camera = uav_camera()
        camera = replace(camera, values={**camera.values, **nil})
        return flight_scene(Flight(points=18, cross_tilt_deg=15.0, camera=camera))
    camera = brown_camera(values=nil, estimate=("c",))
    if case == "large":
        return field_scene(TargetField(camera=camera, rows=40, columns=56, stations=96, frontal=4))
    return field_scene(TargetField(camera=camera, stations=46 if case == "ten" else 16))


def drawn(case: str, seed: int, smooth_px: float = SMOOTH_PX):
    """A block whose cameras are to be chosen, and its truth."""
    survey = Survey(seed=seed, image_sigma_px=0.2, points="exact", orientation="exact", interior="exact")
    done = simulate(scene_of(case, seed), survey)
    block, truth = done.observed, done.truth
    if case in {"ten", "large"}:
        of = (np.arange(len(block.images)) % CAMERAS).astype(np.int32)
        cameras = tuple(replace(block.cameras[0], id=str(k)) for k in range(CAMERAS))
        block, truth = (replace(b, cameras=cameras, images=replace(b.images, camera=of)) for b in (block, truth))
    if smooth_px:
        block = with_smooth_errors(block, np.random.default_rng(seed + 1000), 2, smooth_px)
    return replace(block, cameras=tuple(replace(c, estimate="auto") for c in block.cameras)), truth


def choice(case: str, draws: int) -> dict:
    """Shares of cameras: what is nil and stays free, what is not nil and is held; chi-square per parameter."""
    free, chi, seconds = [], [], 0.0
    for seed in range(draws):
        block, truth = drawn(case, seed)
        began = time.process_time()
        result = decide(block, AdjustmentOptions(jobs=1, noise="fields", tolerance=1e-4))
        seconds += time.process_time() - began
        true = {c.id: c.values for c in truth.cameras}
        for i in result.interior:
            free.append((seed % 2 == 0, set(i.free)))
            error = np.array([i.parameters[s].value - true[i.camera].get(s, 0.0) for s in i.free])
            chi.append(per_parameter(error, result.precision.interior[i.camera]))

    def share(symbol: str, *, nil: bool | None = None) -> float:
        return float(np.mean([symbol in f for is_nil, f in free if nil in {None, is_nil}]))

    return {
        "draws": draws, "nil_free": {"K3": share("K3"), "A": share("A"), "S": share("S"), "P": share("P1", nil=True)},
        "held": {"P": 1 - share("P1", nil=False), "K1": 1 - share("K1"), "K2": 1 - share("K2")},
        "chi_square": float(np.mean(chi)), "cpu_s_each": seconds / draws,
    }  # fmt: skip


def several(draws: int, size: float, focus: float = 0.0) -> dict:
    """Pairs of cameras with differences of `size` times the usual (0: one camera): named, and with the right images."""
    named = exact = 0
    for seed in range(draws):
        rng = np.random.default_rng(500_000 + seed)
        c, x0, y0, K1 = size * rng.normal(size=4)
        change = {
            "c": 0.01 * CAMERA.values["c"] * c, "x0": 20 * PIXEL_MM * x0, "y0": 20 * PIXEL_MM * y0,
            "K1": 5 * PIXEL_MM / HALF_MM**3 * K1,
        }  # fmt: skip
        block, of = mixed([{}, change] if size else [{}], seed, focus=focus)
        found = several_cameras(adjusted(block))
        named += found is not None
        if found is not None and size:
            camera = found.applied(block).images.camera
            exact += len(set(zip(camera.tolist(), of.tolist(), strict=True))) == 2
    return {"draws": draws, "named": named, "exact": exact}


def wandering(draws: int, wander_px: float) -> dict:
    """A principal point of each image's own: how true centres are stated, and whether residuals can show it.

    centres: root of chi-square per coordinate; own_px: median standard deviation of an image's own principal point;
    shown: share of draws in which all images' own principal points differ from nil (chi-square, 1 %).
    """
    found = {}
    for name, scene, sigma in (
        ("field", field_scene(TargetField(camera=brown_camera(), stations=12, frontal=4)), 1e-4),
        ("ring", ring_scene(Ring(camera=brown_camera(), points=250)), 1e-4),
        ("flight", aerial_scene(AerialStrips(strips=3, images_per_strip=6)), 0.02),
        ("flight, camera held", aerial_scene(AerialStrips(strips=3, images_per_strip=6)), 0.02),
    ):
        squares, own_px, shown = [], [], 0
        for seed in range(draws):
            survey = Survey(
                seed=seed, image_sigma_px=0.2, points="exact", orientation="exact", interior="exact", control=10,
                control_sigma=(sigma,) * 3,
            )  # fmt: skip
            done, rng = simulate(scene, survey), np.random.default_rng(seed + 77)
            block = with_smooth_errors(done.observed, rng, 2, SMOOTH_PX)
            o = block.observations
            shift = wander_px * rng.normal(size=(len(block.images), 2))
            block = replace(block, observations=replace(o, xy_px=o.xy_px + shift[o.image]))
            estimate = () if name.endswith("held") else "auto"
            block = replace(block, cameras=tuple(replace(c, estimate=estimate) for c in block.cameras))
            result = decide(block, AdjustmentOptions(jobs=1, noise="fields", tolerance=1e-4))
            error = result.adjusted.images.centre - done.truth.images.centre
            C = result.precision.images[:, :3, :3]
            squares.append(np.einsum("ni,ni->", error, np.linalg.solve(C, error[:, :, None])[:, :, 0]) / error.size)
            (own,) = own_interiors(result)
            at = (4 * np.arange(len(own.images))[:, None] + [1, 2]).ravel()
            difference, V = own.difference_px.ravel()[at], own.covariance[np.ix_(at, at)]
            own_px.append(float(np.median(np.sqrt(np.diagonal(V)))))
            values, vectors = np.linalg.eigh(V)
            parts = values > 1e-6 * values[-1]
            square = float((((vectors.T @ difference) ** 2)[parts] / values[parts]).sum())
            shown += chi_square_tails(square, int(parts.sum()))[1] < 0.01
        found[name] = {
            "draws": draws, "centres": float(np.sqrt(np.mean(squares))), "own_px": float(np.median(own_px)),
            "shown": shown / draws,
        }  # fmt: skip
    return found


def large() -> dict:
    """Processor time of ten cameras and 180 000 image points."""
    found = {}
    for noise, smooth_px in (("white", 0.0), ("fields", SMOOTH_PX)):
        block, _ = drawn("large", 1, smooth_px)
        began = time.process_time()
        result = decide(block, AdjustmentOptions(jobs=1, noise=noise, tolerance=1e-4, reject="snooping"))
        found[noise] = {
            "image_points": len(block.observations), "cpu_s": time.process_time() - began,
            "free": sum(len(i.free) for i in result.interior),
        }  # fmt: skip
    return found


def main() -> None:
    """All cases, or without some."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--draws", type=int, default=200)
    parser.add_argument("--few", type=int, default=60, help="draws of ten cameras, of large differences, of a focus")
    parser.add_argument("--without", nargs="*", default=[])
    given = parser.parse_args()
    cases = {
        "field": lambda: choice("field", given.draws),
        "flight": lambda: choice("flight", given.draws),
        "ten": lambda: choice("ten", given.few),
        "one camera": lambda: several(given.draws, 0.0),
        "one camera, focus wanders by 0.2 %": lambda: several(given.few, 0.0, 2e-3),
        "two cameras": lambda: several(given.draws, 1.0),
        "two cameras, differences twice as large": lambda: several(given.few, 2.0),
        "large": large,
        "principal point steady": lambda: wandering(given.few, 0.0),
        "principal point wanders by 4 px": lambda: wandering(given.few, 4.0),
    }
    found = {}
    for name, run in cases.items():
        if name not in given.without:
            found[name] = run()
            print(name, json.dumps(found[name]), file=sys.stderr, flush=True)
    print(json.dumps(found, indent=1))


if __name__ == "__main__":
    main()
