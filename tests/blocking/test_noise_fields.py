"""Noise fields of a network in parts are those of one piece: floor, fields, standard deviations, questions."""

from dataclasses import replace
from functools import cache

import numpy as np
import pytest

from raybundle.adjustment.decision.decide import decide
from raybundle.adjustment.engine import adjust_block
from raybundle.adjustment.evaluation.image_interiors import own_interiors
from raybundle.adjustment.evaluation.joint_interior import joint_interior, smooth_errors
from raybundle.adjustment.evaluation.queries import covariance, precision_in_datum
from raybundle.adjustment.records.options import AdjustmentOptions
from raybundle.adjustment.statistics import noise
from raybundle.adjustment.statistics.field_system import field_system
from raybundle.adjustment.statistics.fields import Components
from raybundle.adjustment.statistics.noise import spread_in_datum, spread_of
from raybundle.adjustment.system.factoring import made_by
from raybundle.blocking import fields as tasks
from raybundle.blocking.memory import Serial
from raybundle.blocking.normals_in_parts import in_parts
from raybundle.io.block.folder import read_block
from raybundle.numerics import native
from raybundle.pipeline.choosing import staying_for
from raybundle.pipeline.executors import Staying, Threads
from raybundle.pipeline.store import Folder
from raybundle.planning.simulate import Survey, simulate
from raybundle.planning.synthetic_networks import AerialStrips, aerial_scene
from raybundle.sensors import sensor_models
from raybundle.workflows.adjust import adjust
from tests.adjustment.test_noise import with_fields
from tests.blocking.networks import flight
from tests.blocking.test_elsewhere import OPTIONS as SNOOPING
from tests.blocking.test_elsewhere import ByTwin, Counting, adjusted
from tests.blocking.test_equal import NETWORKS as PLAIN
from tests.blocking.test_equal import stds
from tests.pipeline.machines import Machines

OPTIONS = AdjustmentOptions(jobs=1, noise="fields")
ROUNDING = 1e-6


def neighbours_alike(block, px=0.5):
    """With errors that neighbouring image points share, too rough for fields: a floor."""
    rng, o = np.random.default_rng(4), block.observations
    xy = o.xy_px.copy()
    for i in range(len(block.images)):
        mine, camera = o.image == i, block.cameras[block.images.camera[i]]
        at = xy[mine] / max(camera.width_px, camera.height_px) * 2 * np.pi
        for _ in range(6):
            k = rng.normal(size=2)
            wave = np.cos(at @ (k * rng.uniform(2, 5) / np.linalg.norm(k)) + rng.uniform(0, 6))
            xy[mine] += wave[:, None] * rng.normal(size=2) * px
    return replace(block, observations=replace(o, xy_px=xy))


def of_two_cameras():
    block = flight(observed=False)
    other = replace(block.cameras[0], id="2", estimate=("c",))
    camera = np.arange(len(block.images), dtype=np.int32) % 2
    return replace(block, cameras=(block.cameras[0], other), images=replace(block.images, camera=camera))


def by_model(model, **more):
    """A flight with another sensor model."""
    strips = AerialStrips(images_per_strip=9, points_per_image=25)
    values = dict.fromkeys(sensor_models[model].symbols, 0.0) | {"c": strips.camera.values["c"]} | more
    camera = replace(strips.camera, model=model, values=values, estimate=("c", "x0", "y0"))
    near = Survey(image_sigma_px=0.3, points="exact", orientation="exact", interior="exact", seed=2)
    return simulate(aerial_scene(replace(strips, camera=camera)), near).observed


def some_without_fields():
    """A strip by a stereographic lens, of a model that takes up any field."""
    block = flight()
    first, o = block.cameras[0], block.observations
    values = dict.fromkeys(sensor_models["spline"].symbols, 0.0) | {"c": first.values["c"], "w": 30.0, "h": 30.0}
    other = replace(first, id="2", model="spline", values=values, estimate=())
    camera = np.repeat(np.arange(3), len(block.images) // 3).astype(np.int32) // 2
    middle = np.array([first.width_px, first.height_px]) / 2
    t2 = np.sum((o.xy_px - middle) ** 2, axis=1, keepdims=True) * (first.pixel_mm[0] / first.values["c"]) ** 2
    stereographic = middle + (o.xy_px - middle) * 2 / (np.sqrt(1 + t2) + 1)
    xy = np.where(camera[o.image][:, None] == 1, stereographic, o.xy_px)
    return replace(
        block, cameras=(first, other), images=replace(block.images, camera=camera),
        observations=replace(o, xy_px=xy),
    )  # fmt: skip


NETWORKS = {
    **{n: (make, replace(o, noise="fields")) for n, (make, o) in PLAIN.items() if not o.robust_start},
    "two cameras": (of_two_cameras, OPTIONS),
    "fisheye": (lambda: by_model("fisheye"), OPTIONS),
    "rolling shutter": (lambda: by_model("brown_rolling", r=1e-3), OPTIONS),
    "some without fields": (some_without_fields, OPTIONS),
    "long": (lambda: flight(images=24), OPTIONS),
    "parameters chosen": (
        lambda: replace(flight(), cameras=(replace(flight().cameras[0], estimate="auto"),)),
        replace(OPTIONS, reject="snooping"),
    ),
}


def same(one, other, limit=ROUNDING):
    """Every standard deviation, relative to that of one piece."""
    one, other = np.asarray(one, float), np.asarray(other, float)
    assert np.array_equal(np.isnan(one), np.isnan(other))
    some = np.isfinite(one)
    size = np.abs(one[some])
    assert (np.abs(other[some] - one[some]) <= limit * np.where(size > 0, size, 1.0)).all()


def figures(found):
    return [getattr(found, n) for n in ("phi", "tau_px", "focus_px", "directions", "chi_square", "images", "sampled",
                                        "share", "ratio_interior", "ratio_images", "ratio_points")]  # fmt: skip


def same_precision(one, other):
    assert len(one.interior) == len(other.interior)
    same(stds(one.object_points), stds(other.object_points))
    same(stds(one.images), stds(other.images))
    for key, C in one.interior.items():
        same(stds(C), stds(other.interior[key]))


def same_result(one, other):
    assert one.noise.kind == other.noise.kind
    same(figures(one.noise), figures(other.noise))
    same_precision(one.precision, other.precision)
    for a, b in zip(one.groups, other.groups, strict=True):
        same(a.adjusted_std, b.adjusted_std)
    assert [(n.code, n.values.keys()) for n in one.notices] == [(n.code, n.values.keys()) for n in other.notices]


def leaves(result):
    return sum(not c for c in result.handle.work.normals.parts.network.tree.children)


def by_parts(adjusting, block, options, leaf=60, **means):
    with made_by(in_parts(leaf, **means)):
        return adjusting(block, options)


@cache
def in_one_piece(name):
    make, options = NETWORKS[name]
    block = with_fields(make(), 0.3)
    return block, decide(block, options)


@pytest.mark.parametrize("leaf", [24, 60])
@pytest.mark.parametrize("name", NETWORKS)
def test_fields_in_parts_are_those_of_one_piece(name, leaf):
    block, one = in_one_piece(name)
    parts = by_parts(decide, block, NETWORKS[name][1], leaf)
    assert 2 <= leaves(parts) <= 16
    assert one.noise.kind == "fields"
    assert one.noise.tau_px > 0.1
    same_result(one, parts)


def test_a_floor_in_parts_is_that_of_one_piece():
    block = neighbours_alike(flight(control=0, observed=False))
    one, parts = adjust_block(block, OPTIONS), by_parts(adjust_block, block, OPTIONS)
    assert one.noise.phi > 1.02
    same_result(one, parts)


def widened(result, phi):
    """Cofactors under a floor and fields that are given, and what answers questions."""
    w = result.handle.work
    components = Components(phi=phi, tau_square=40.0, focus_square=90.0, directions=99, chi_square=9.0)
    spread = spread_of(field_system(w.normals, w.state), w.found, phi, components.root(1.0))
    return spread, spread_in_datum(spread, w.found, w.datum)


@pytest.mark.parametrize("exact", [300, 10], ids=["all", "random combinations"])
@pytest.mark.parametrize("name", ["everything", "inner constraints", "held", "interior of each image"])
def test_floor_and_fields_spread_as_in_one_piece(name, exact, monkeypatch):
    monkeypatch.setattr(noise, "EXACT", exact)
    make, options = NETWORKS[name]
    block, options = with_fields(make(), 0.1), replace(options, noise="white")
    one, parts = adjust_block(block, options), by_parts(adjust_block, block, options)
    (whole, a), (summed, b) = widened(one, 2.3), widened(parts, 2.3)
    assert (whole.outside is None) == (exact < 30 or name == "held")  # rows of which the floor knows
    same(stds(a.points), stds(b.points))
    normals, own = one.handle.work.normals, parts.handle.work.normals
    for n in range(len(one.handle.work.system.sizes)):
        same(stds(normals.node_block(a.inverse, n, n)), stds(own.node_block(b.inverse, n, n)), 2e-6)
    right = np.random.default_rng(3).normal(size=(len(normals.right), 3))
    x, y = whole.among_nodes(right), summed.among_nodes(right)
    assert np.abs(x - y).max() < ROUNDING * np.abs(x).max()


def test_samples_of_larger_blocks_are_the_same_images(monkeypatch):
    for name, value in {"WHOLE": 12, "SAMPLE": 8, "SAMPLES": 3, "EXACT": 10}.items():
        monkeypatch.setattr(noise, name, value)
    block = with_fields(flight(images=16), 0.3)
    one, parts = adjust_block(block, OPTIONS), by_parts(adjust_block, block, OPTIONS)
    assert one.noise.sampled == 24
    same_result(one, parts)


def test_questions_are_answered_under_the_same_noise():
    block = neighbours_alike(with_fields(flight(control=0, observed=False), 0.3))
    one, parts = adjust_block(block, OPTIONS), by_parts(adjust_block, block, OPTIONS)
    names = [f"point:{block.points.ids[k]}" for k in (3, 150)] + [f"image:{block.images.ids[2]}"]
    a, b = (covariance(r, names).matrix for r in (one, parts))
    size = np.sqrt(np.outer(np.diagonal(a), np.diagonal(a)))
    assert (np.abs(a - b) < ROUNDING * size).all()
    chosen = tuple(block.points.ids[i] for i in (0, 40, 90, 150, 190))
    same_precision(precision_in_datum(one, chosen), precision_in_datum(parts, chosen))


def test_interiors_of_images_and_cameras_are_those_of_one_piece():
    block = with_fields(of_two_cameras(), 0.3)
    one, parts = adjust_block(block, OPTIONS), by_parts(adjust_block, block, OPTIONS)
    a, b = ([own_interiors(r)[k] for k in (0, 1)] for r in (one, parts))
    for c, d in zip(a, b, strict=True):
        assert np.array_equal(c.images, d.images)
        std = np.sqrt(np.diagonal(c.covariance))
        assert np.abs(c.difference_px - d.difference_px).ravel().max() < ROUNDING * std.max()
        same(std, stds(d.covariance))
    joint = [joint_interior(r, ["2", block.cameras[0].id], smooth_errors(r)) for r in (one, parts)]
    same(stds(joint[0].stated), stds(joint[1].stated))


def test_shared_errors_are_noticed_with_the_same_factors():
    """`auto`: white noise, and a remark of what it leaves out."""
    block, options = with_fields(flight(), 0.5), AdjustmentOptions(jobs=1)
    one, parts = adjust(block, options), by_parts(adjust, block, options)
    (a,), (b,) = ([n for n in r.notices if n.code.startswith("residual_structure")] for r in (one, parts))
    assert a.code == b.code
    assert a.values["ratio_points"] == pytest.approx(b.values["ratio_points"], rel=ROUNDING)
    assert a.values["tau_px"] == pytest.approx(b.values["tau_px"], rel=ROUNDING)


def bits(result):
    parts = [result.precision.object_points, result.precision.images, *result.precision.interior.values()]
    return [np.asarray(p).tobytes() for p in parts], figures(result.noise)


def test_whoever_does_the_tasks_gives_the_same_bits(tmp_path):
    block = with_fields(flight(), 0.3)
    one = adjust_block(block, OPTIONS)
    made = iter(range(1000))
    wanted = None
    executors = {"serial": Serial(), "threads": Threads(2), "one": Staying(1), "two": Staying(2)}
    for name, executor in executors.items():
        means = {"store": lambda name=name: Folder(tmp_path / name / f"{next(made)}"), "executor": executor}
        found = by_parts(adjust_block, block, OPTIONS, 36, **means)
        wanted = bits(found) if wanted is None else wanted
        assert bits(found) == wanted, name
        same_result(one, found)
        if isinstance(executor, Staying):
            executor.close()


@pytest.mark.long
def test_workers_of_a_cluster_give_the_same_bits(tmp_path):
    pytest.importorskip("distributed", reason="the extra [cluster] is not installed")
    block = with_fields(flight(), 0.3)
    store = lambda name: lambda: Folder(tmp_path / name)  # noqa: E731
    wanted = by_parts(adjust_block, block, OPTIONS, 36, store=store("serial"), executor=Serial())
    machines = Machines(tmp_path / "cluster")
    try:
        machines.scheduler()
        machines.worker(jobs=2)
        executor = staying_for(str(machines.folder), 1, 1e9)
        found = by_parts(adjust_block, block, OPTIONS, 36, store=store("cluster"), executor=executor)
        assert bits(found) == bits(wanted)
    finally:
        machines.close()


def test_parts_that_do_not_stay_ready_are_made_anew(monkeypatch):
    block = with_fields(flight(), 0.3)
    wanted = by_parts(adjust_block, block, OPTIONS)
    made, plain = [], tasks.WideNormals.of
    monkeypatch.setattr(tasks.WideNormals, "of", lambda *a: (made.append(1), plain(*a))[1])
    few = by_parts(adjust_block, block, OPTIONS, ready=1.0)
    assert len(few.handle.work.normals.parts.parts.known.wide) == 1
    assert len(made) > len(few.handle.work.normals.parts.network.tree)
    assert bits(few) == bits(wanted)


def test_a_run_that_was_cut_short_goes_on_to_the_same_noise(tmp_path):
    block, options = with_fields(flight(), 0.3), replace(SNOOPING, noise="fields")
    whole, last, done = Counting(), Counting(), 0
    wanted = bits(adjusted(block, tmp_path / "whole", whole, options))
    for share in (0.6, 0.3, 0.06):
        short = Counting(int(share * len(whole.done)))
        with pytest.raises(KeyboardInterrupt):
            adjusted(block, tmp_path / "short", short, options)
        done += len(short.done)
    assert bits(adjusted(block, tmp_path / "short", last, options)) == wanted
    assert done + len(last.done) <= 1.1 * len(whole.done)


@pytest.mark.skipif(not native.available(), reason="there are no kernels to be without")
def test_a_worker_without_kernels_gives_the_same_noise(tmp_path, monkeypatch):
    block, options = with_fields(flight(), 0.3), replace(SNOOPING, noise="fields")
    same_result(decide(block, options), adjusted(block, tmp_path, ByTwin(monkeypatch), options))


@pytest.mark.data
@pytest.mark.parametrize("name", ["aicon", "camcal21", "prague-c1", "riva-net1", "roma", "sxb"])
def test_fields_of_published_blocks_in_parts_are_those_of_one_piece(blocks, name):
    block = read_block(blocks / name)
    one = adjust(block, AdjustmentOptions(jobs=1, noise="fields"))
    # adjusted values to start from: an iteration is no part of what is compared
    block = replace(one.given, points=one.adjusted.points, images=one.adjusted.images, cameras=one.adjusted.cameras)
    one, parts = adjust_block(block, OPTIONS), by_parts(adjust_block, block, OPTIONS, 24)
    same_result(one, parts)
