"""What the start has oriented ends as a result: features where matching fails, images left out by name."""

from dataclasses import replace
from types import SimpleNamespace

import numpy as np
import pytest

from raybundle.adjustment.records.options import noise_of_photographs
from raybundle.adjustment.records.severity import Severity
from raybundle.block import Role
from raybundle.block.rejection import RejectionKind
from raybundle.block.select import with_rows, without_images
from raybundle.errors import NotSolvable, Undetermined
from raybundle.matching.least_squares import FIGURES
from raybundle.matching.refine import LEVELS, CandidateMatches, Refined, choose_references
from raybundle.numerics.progress import silent
from raybundle.placing.georeference import Georeferenced
from raybundle.placing.marks import Given
from raybundle.planning.simulate import Survey, simulate
from raybundle.planning.synthetic_networks import TargetField, brown_camera, field_scene
from raybundle.ties import precise
from raybundle.ties.block import TieBlock
from raybundle.ties.precise import refine
from raybundle.workflows import final_adjustment as final
from raybundle.workflows.final_adjustment import _with_block, final_adjustment, independent_notices, left_out
from raybundle.workflows.orienting.options import OrientOptions
from raybundle.workflows.orienting.stages.adjustment import _adjusted, incomplete_notice
from tests.messages import coded

CAMERA = brown_camera(estimate=("c", "K1"))
FEATURE_PX, MATCH_PX = 0.6, 0.1


def features(stations=8):
    """A block of features as a start leaves it."""
    plan = TargetField(camera=CAMERA, rows=14, columns=18, stations=stations, frontal=2)
    survey = Survey(seed=5, orientation="approximate", points="approximate", image_sigma_px=FEATURE_PX)
    simulation = simulate(field_scene(plan), survey)
    block = simulation.observed
    return block, simulation.truth


def tie_of(block):
    m = len(block.observations)
    return TieBlock(block=block, scale_px=np.full(m, 3.0), angle=np.zeros(m), not_oriented=())


def matching(monkeypatch, block, truth, failing, share=0.0):
    """Least-squares matching that measures to 0.1 px, and in some images next to nothing."""
    rng = np.random.default_rng(1)

    def refined(points, match):
        m = len(points.image)
        reference = choose_references(points)
        good = ~np.isin(points.image, failing) | (rng.random(m) < share)
        own = np.unique(reference[good])
        is_reference = np.zeros(m, bool)
        is_reference[own] = True
        measured = good | is_reference
        xy = np.where(measured[:, None], truth.observations.xy_px + rng.normal(0, MATCH_PX, (m, 2)), points.xy_px)
        cov = np.zeros((m, 3))
        cov[measured, :2] = MATCH_PX**2 / 9 * rng.lognormal(0, 0.3, m)[measured, None]
        return Refined(
            xy_px=xy,
            cov_px2=cov,
            measured=measured,
            reference=is_reference,
            correlation=np.ones(m),
            level=np.zeros(m, int),
            window_px=np.full(m, 3.0),
            residual=np.zeros((m, FIGURES)),
        )

    def nothing(points, places):
        k = len(places.image)
        return CandidateMatches(
            good=np.zeros(k, bool),
            xy_px=places.xy_px,
            cov_px2=np.zeros((k, 3)),
            correlation=np.zeros(k),
            level=np.full(k, LEVELS),
            window_px=np.full(k, np.nan),
            residual=np.zeros((k, FIGURES)),
        )

    monkeypatch.setattr(precise, "refine_tracks", refined)
    return refine(tie_of(block), nothing, 1)


def test_a_photograph_that_matching_does_not_measure_keeps_its_features_with_their_own_sigma(monkeypatch):
    block, truth = features()
    found = matching(monkeypatch, block, truth, [3])
    assert found.by_features == (block.images.ids[3],)
    assert not found.left_out
    o = found.block.observations
    mine = o.image == 3
    assert mine.sum() > 0.9 * (block.observations.image == 3).sum()
    sigma = np.sqrt(np.median(o.cov_px2[mine, 0]))
    assert sigma == pytest.approx(FEATURE_PX, rel=0.2)
    assert np.sqrt(np.median(o.cov_px2[~mine, 0])) == pytest.approx(MATCH_PX, rel=0.3)


def test_all_photographs_stay_where_matching_measures_nothing(monkeypatch):
    block, truth = features()
    found = matching(monkeypatch, block, truth, list(range(len(block.images))))
    assert len(found.by_features) == len(block.images)
    result = final_adjustment(placed(found.block), (), 1, silent, ())
    assert result.adjusted.images.oriented.all()
    assert result.sigma0 == pytest.approx(1.0, abs=0.15)


def test_measurements_are_not_left_out_for_what_they_weigh(monkeypatch):
    """Where the residuals are far above what grey values promise, all measurements get that factor and stay."""
    block, truth = features()
    monkeypatch.setattr("tests.workflows.test_never_nothing.MATCH_PX", 0.9)
    found = matching(monkeypatch, block, truth, [])
    assert len(found.block.observations) > 0.98 * len(block.observations)


def placed(block):
    return Georeferenced(block=block, frame=None, notices=(), marked=np.zeros(len(block.points), bool), fixed=False)


def thinned(block, image, count):
    """The block with so many points left in an image."""
    mine = np.flatnonzero(block.observations.image == image)
    keep = np.ones(len(block.observations), bool)
    keep[mine[count:]] = False
    return with_rows(block, keep)


def test_gross_errors_stay_in_a_block_that_is_adjusted_again():
    block, _ = features()
    xy = block.observations.xy_px.copy()
    xy[20] += 60.0
    wrong = placed(replace(block, observations=replace(block.observations, xy_px=xy)))
    kept = final_adjustment(wrong, (), 1, silent, (), reject="none")
    assert not any(r is not None and r.kind is RejectionKind.BLUNDER for r in kept.image_observations.rejected)
    assert kept.options.reject == "none"
    found = final_adjustment(wrong, (), 1, silent, ())
    assert found.image_observations.rejected[20] is not None


def test_errors_of_few_photographs_are_said_to_be_taken_as_independent():
    told = {n: independent_notices("auto", noise_of_photographs("auto", n), n) for n in (3, 4, 5)}
    assert not told[5]
    assert not independent_notices("white", "white", 3)
    assert told[3][0].severity is Severity.WARNING
    assert told[4][0].values["images"] == 4
    block, _ = features(stations=2)
    assert len(block.images) < 5
    result = final_adjustment(placed(block), (), 1, silent, ())
    assert result.noise.kind == "white"
    assert "errors_independent" in {n.code for n in result.notices}


def test_an_image_that_nothing_holds_is_left_out_by_name():
    block, _ = features()
    result = final_adjustment(placed(thinned(block, 4, 2)), (), 1, silent, ())
    lost = left_out(result, ())
    assert [name for name, _ in lost] == [block.images.ids[4]]
    assert lost[0][1].message.code in {"excluded.undetermined", "excluded.few_points"}
    assert int(result.adjusted.images.oriented.sum()) == len(block.images) - 1


def test_several_images_that_nothing_holds_leave_together():
    block, _ = features()
    for image in (1, 4, 6):
        block = thinned(block, image, 2)
    result = final_adjustment(placed(block), (), 1, silent, ())
    assert {name for name, _ in left_out(result, ())} == {block.images.ids[i] for i in (1, 4, 6)}


def test_a_part_apart_leaves_and_the_larger_one_stays():
    block, _ = features(stations=10)
    o = block.observations
    apart = np.isin(o.image, [0, 1])
    half = np.arange(len(block.points)) % 4 == 0
    keep = np.where(apart, half[o.point], ~half[o.point])
    result = final_adjustment(placed(with_rows(block, keep)), (), 1, silent, ())
    assert {name for name, _ in left_out(result, ())} == {block.images.ids[i] for i in (0, 1)}


def test_two_images_with_two_points_each_are_an_error():
    block, _ = features(stations=0)
    few = np.isin(block.observations.point, [100, 101])
    with pytest.raises(NotSolvable, match=r"image\.too_few_points"):
        final_adjustment(placed(with_rows(block, few)), (), 1, silent, ())


def test_a_part_that_nothing_determines_costs_its_photographs_alone():
    whole, _ = features()
    o = whole.observations
    few = with_rows(whole, np.isin(o.image, [0, 1]) & (np.arange(len(o)) % 60 == 0))
    asked = SimpleNamespace(
        groups=(), photos=(), remarks=(), options=OrientOptions(precise=False), given=Given(), reject="snooping"
    )
    means = SimpleNamespace(jobs=1, progress=silent)
    done = _adjusted(asked, placed(whole), [placed(few), placed(whole)], means)
    adjustment, parts = done.adjustment, done.other_components
    assert len(parts) == 1
    assert adjustment.sigma0 < 2
    lost = dict(left_out(adjustment, parts))
    assert set(few.images.ids) <= set(lost)
    assert {reason.message.code for reason in lost.values()} == {"excluded.part"}


def test_the_part_with_most_photographs_leads_whatever_is_left_of_the_first():
    whole, _ = features()
    o = whole.observations
    few = with_rows(whole, np.isin(o.image, [0, 1, 2]) & (np.arange(len(o)) % 3 == 0))
    few = replace(
        few, images=replace(few.images, centre=_only(few.images.centre, 3), rotation=_only(few.images.rotation, 3))
    )
    asked = SimpleNamespace(
        groups=(),
        photos=(),
        remarks=(),
        options=OrientOptions(precise=False),
        given=Given(),
        scenes=None,
        reject="snooping",
    )
    means = SimpleNamespace(jobs=1, progress=silent)
    done = _adjusted(asked, placed(few), [placed(whole)], means)
    oriented = int(done.adjustment.given.images.oriented.sum())
    assert oriented > 3
    assert [int(p.adjustment.given.images.oriented.sum()) for p in done.other_components] == [3]
    assert done.placed.block.images.oriented.sum() >= oriented
    (notice,) = incomplete_notice(SimpleNamespace(photos=[None] * 40, scenes=None), done)
    assert (notice.code, notice.severity.value) == ("incomplete", "fault")
    assert notice.values["oriented"] == oriented + 3
    assert incomplete_notice(SimpleNamespace(photos=[None] * (oriented + 3), scenes=None), done) == ()


def _only(values, count):
    """The orientations of the first images, none of the others."""
    number = np.arange(len(values)).reshape(-1, *[1] * (values.ndim - 1))
    return np.where(number < count, values, np.nan)


def test_rays_that_are_all_parallel_say_so(monkeypatch):
    whole, _ = features()
    monkeypatch.setattr(
        "raybundle.workflows.final_adjustment.flat_points", lambda block: np.ones(len(block.points), bool)
    )
    with pytest.raises(NotSolvable, match=r"network\.no_depth"):
        final_adjustment(placed(whole), (), 1, silent, ())


def test_points_that_keep_one_ray_leave_with_the_images_that_saw_them():
    whole, _ = features()
    o = whole.observations
    rows = np.ones(len(o), bool)
    rows[np.flatnonzero(o.point == o.point[0])[1:]] = False
    less = _with_block(placed(whole), with_rows(whole, rows)).block
    assert np.bincount(less.observations.point, minlength=len(less.points)).min() >= 2


def test_control_with_which_nothing_can_be_adjusted_leaves_before_any_photograph(monkeypatch):
    whole, _ = features()
    p = whole.points
    role, sigma = np.array(p.role), np.array(p.sigma)
    role[:4], sigma[:4] = Role.CONTROL, 0.01
    block = replace(whole, points=replace(p, role=role, sigma=sigma))

    def decided(block, *rest):
        if block.points.is_control.any():
            raise NotSolvable("nothing fits")
        return decide(block, *rest)

    decide = final._decided
    monkeypatch.setattr(final, "_decided", decided)
    result = final_adjustment(placed(block), (), 1, silent, ())
    assert result.adjusted.images.oriented.all()
    (notice,) = [n for n in result.notices if n.code == "control_left_out"]
    assert set(notice.ids) == set(p.ids[:4])
    assert notice.severity is Severity.FAULT
    assert not left_out(result, ())
    assert not result.given.points.is_control.any()
    assert result.given.cameras[0].estimate == block.cameras[0].estimate


def test_what_was_tried_with_control_is_not_told_of_the_result_without_it(monkeypatch):
    """With control the attempts lose photographs and hold the camera; without it neither happened."""
    whole, _ = features()
    p = whole.points
    role, sigma = np.array(p.role), np.array(p.sigma)
    role[:4], sigma[:4] = Role.CONTROL, 0.01
    block = replace(whole, points=replace(p, role=role, sigma=sigma))

    def decided(block, *rest):
        if not block.points.is_control.any():
            return decide(block, *rest)
        left = int(block.images.oriented.sum())
        image = [Undetermined(kind="image", name=block.images.ids[left - 1])]
        raise NotSolvable("nothing fits.", undetermined=image if left > 5 else [])

    decide = final._decided
    monkeypatch.setattr(final, "_decided", decided)
    marked = np.isin(np.arange(len(p)), np.arange(4))
    result = final_adjustment(replace(placed(block), marked=marked), (), 1, silent, ())
    assert result.adjusted.images.oriented.all()
    assert not left_out(result, ())
    codes = {n.code for n in result.notices}
    assert "control_left_out" in codes
    assert not {"held_not_determinable", "marked_lost", "points_left_out"} & codes


def test_few_photographs_say_why_their_noise_is_white():
    """Four photographs: the automatic choice is white noise, with its reason."""
    whole, _ = features()
    few = with_rows(whole, whole.observations.image < 4)
    out = np.arange(len(whole.images)) >= 4
    result = final_adjustment(placed(without_images(few, out)), (), 1, silent, ())
    assert result.noise.kind == "white"
    assert coded([result.noise.reason])["noise.too_few_photographs"]["n"] == 4
