"""Photographs that the first matching leaves apart: joined by affine views, at true stations, and only where needed."""

import json
from dataclasses import replace
from types import SimpleNamespace

import cv2
import numpy as np
import pytest

from raybundle.adjustment.records.notice import Notice
from raybundle.block import Block, Camera, Images, Observations, Points
from raybundle.matching import methods as registry
from raybundle.matching.affine_views import VIEWS, AffineViews
from raybundle.matching.features import Features
from raybundle.matching.methods import LEARNED, feature_method
from raybundle.ties.rotations import Common, agreeing
from raybundle.ties.wide_baselines import budget_s, joined_features
from raybundle.workflows.orient import OrientOptions, orient
from raybundle.workflows.orienting.stages.adjustment import kept_joins
from raybundle.workflows.orienting.stages.wide_baselines import STAGE, further_methods
from tests.matching.test_features import texture

W, H, C_PX = 640, 480, 620.0
CAMERA = Camera(
    id="1", model="brown", width_px=W, height_px=H, pixel_mm=(0.01, 0.01), values={"c": 0.01 * C_PX}, estimate=()
)


def letters(size=1400):
    """Lines of letters: flat, and other letters everywhere."""
    rng, sheet = np.random.default_rng(7), np.full((size, size), 215, np.uint8)
    for k in range(46):
        line = "".join(chr(rng.integers(97, 123)) if rng.random() > 0.16 else " " for _ in range(110))
        cv2.putText(sheet, line, (8, 26 + 30 * k), cv2.FONT_HERSHEY_SIMPLEX, 0.8, 40, 2, cv2.LINE_AA)
    return sheet


def towards(centre, target):
    """Rotation of a camera that looks at a place, upright."""
    z = (centre - target) / np.linalg.norm(centre - target)
    x = np.cross([0, 1, 0], z) / np.linalg.norm(np.cross([0, 1, 0], z))
    return np.array([x, np.cross(z, x), z])


def photograph(sheet, centre, target, rng, width=4.0):
    """The sheet in the plane Z = 0, seen from a station."""
    R, n = towards(centre, target), len(sheet)
    K = np.array([[C_PX, 0, -W / 2], [0, -C_PX, -H / 2], [0, 0, -1]])
    plane = np.array([[width / n, 0, -width / 2], [0, -width / n, width / 2], [0, 0, 1]])
    M = np.diag([3, 3, 1]) @ K @ np.column_stack([R[:, :2], -R @ centre]) @ plane
    big = cv2.warpPerspective(sheet, M, (3 * W, 3 * H), flags=cv2.INTER_CUBIC)
    grey = cv2.resize(big, (W, H), interpolation=cv2.INTER_AREA)
    return np.clip(grey + rng.normal(0, 20, grey.shape), 0, 255).astype(np.uint8)


@pytest.mark.long
def test_a_plane_seen_under_64_degrees_is_joined_by_affine_views(tmp_path):
    rng, sheet, truth = np.random.default_rng(2), letters(), {}
    (tmp_path / "photos").mkdir()
    for k, degrees in enumerate((-4, -2, 0, 62, 64, 66)):
        a = np.radians(degrees)
        centre = np.array([5.5 * np.sin(a), k % 3 - 1.0, 5.5 * np.cos(a)])
        target = np.array([*rng.normal(0, 0.1, 2), 0])
        truth[f"{k}.png"] = centre
        cv2.imwrite(str(tmp_path / f"photos/{k}.png"), photograph(sheet, centre, target, rng))
    options = OrientOptions(jobs=1, precise=False, wide_baselines="none")
    first = orient([tmp_path / "photos"], tmp_path / "project", options, calibration=[CAMERA])
    assert [len(c.photographs) for c in first.other_components] == [3]
    assert first.wide_baselines == {}
    options = replace(options, wide_baselines="own")
    whole = orient([tmp_path / "photos"], tmp_path / "project", options, calibration=[CAMERA])
    assert (whole.oriented, whole.other_components) == (6, ())
    (step,) = whole.wide_baselines["methods"]
    assert step["method"] == "affine_views"
    assert len(step["joined"]) == 3
    assert step["cpu_s"] <= whole.wide_baselines["budget_s"] == 60.0
    json.dumps(whole.additions())
    notice = next(n for n in whole.adjustment.notices if n.code == "wide_baselines")
    assert notice.values["joined"] == 3
    found = whole.adjustment.adjusted.images
    xyz = np.array([truth[name] for name in found.ids])
    a, b = found.centre - found.centre.mean(axis=0), xyz - xyz.mean(axis=0)
    u, s, vt = np.linalg.svd(b.T @ a)
    assert np.linalg.det(u @ vt) > 0
    off = np.linalg.norm(s.sum() / (a**2).sum() * a @ (u @ vt).T - b, axis=1)
    assert off.max() < 0.01 * np.linalg.norm(np.ptp(xyz, axis=0))  # 1 % of the extent
    again = orient([tmp_path / "photos"], tmp_path / "project", options, calibration=[CAMERA])
    assert next(s for s in again.stages if s.name == "wide baselines").from_cache
    assert np.array_equal(again.adjustment.adjusted.images.centre, found.centre)


def test_views_show_features_at_their_places():
    method = AffineViews()
    found = method.detect(texture(240, 320), 400)
    assert set(np.unique(found.descriptors[:, -1])) == set(range(len(VIEWS)))
    own, others = found.descriptors[:, -1] == 0, found.descriptors[:, -1] > 0
    off = found.xy_px[others][:, None] - found.xy_px[own]
    length = np.linalg.norm(off, axis=2)
    nearest = off[np.arange(len(off)), length.argmin(axis=1)][length.min(axis=1) < 1]
    assert len(nearest) > 300
    assert np.abs(nearest.mean(axis=0)).max() < 0.05
    assert feature_method(method.name).content == method.content


def test_new_features_are_old_ones_where_those_lie():
    def features(xy):
        n = len(xy)
        return Features(
            xy_px=np.array(xy, float), scale_px=np.ones(n), angle=np.zeros(n), descriptors=np.ones((n, 4), np.uint8)
        )

    whole, place = joined_features(
        features([[10, 10], [50, 50]]), features([[10.5, 10], [80, 80], [80.5, 80], [50, 53]]), 1.5
    )
    assert place.tolist() == [0, 2, 2, 3]
    assert whole.xy_px.tolist() == [[10, 10], [50, 50], [80, 80], [50, 53]]
    assert not whole.descriptors[2:].any()


def stations(oriented):
    """Four stations around points at random, the first ones oriented; places [px] of the points in each."""
    rng = np.random.default_rng(4)
    xyz = rng.uniform(-1, 1, (60, 3))
    centre = np.array([[6 * np.sin(a), 0.3 * k, 6 * np.cos(a)] for k, a in enumerate((0.0, 0.3, 0.6, 0.9))])
    R = np.array([towards(c, np.zeros(3)) for c in centre])
    P = np.einsum("nij,knj->kni", R, xyz[:, None] - centre)
    xy = np.stack([W / 2 - C_PX * P[..., 0] / P[..., 2], H / 2 + C_PX * P[..., 1] / P[..., 2]], axis=-1)
    known = np.arange(4) < oriented
    images = Images(
        ids=tuple("abcd"), camera=np.zeros(4, np.int32), file=tuple("abcd"),
        centre=np.where(known[:, None], centre, np.nan), rotation=np.where(known[:, None, None], R, np.nan),
    )  # fmt: skip
    nothing = np.zeros((0, 3))
    block = Block(
        name="", cameras=(replace(CAMERA, values=dict.fromkeys(CAMERA.sensor.symbols, 0.0) | CAMERA.values),),
        images=images, points=Points(ids=(), role=np.zeros(0, np.int32), xyz=nothing, sigma=nothing),
        observations=Observations(
            image=np.zeros(0, np.int32), point=np.zeros(0, np.int32), xy_px=np.zeros((0, 2)), cov_px2=nothing
        ),
    )  # fmt: skip
    return block, xy + rng.normal(0, 0.3, xy.shape)


def pair(xy, i, j, n=60, *, strong=False, turned=False):
    """Matches of two photographs; turned: of a part that looks the same and is turned by a right angle."""
    other = xy[:n, j]
    if turned:
        other = np.column_stack([W / 2 + other[:, 1] - H / 2, H / 2 - other[:, 0] + W / 2])
    return Common(first=i, second=j, strong=strong, xy=(xy[:n, i], other))


def test_pairs_count_that_agree_in_the_rotation():
    block, xy = stations(3)
    found = agreeing(block, block, [pair(xy, 0, 3), pair(xy, 1, 3, 40), pair(xy, 2, 3, 20, turned=True)])
    assert found.keys() == {0, 1}
    assert found[0].sum() > 55


def test_one_pair_counts_only_if_it_is_strong():
    block, xy = stations(3)
    assert agreeing(block, block, [pair(xy, 0, 3)]) is None
    assert agreeing(block, block, [pair(xy, 0, 3), pair(xy, 0, 3, 50)]) is None  # two methods, one pair
    assert agreeing(block, block, [pair(xy, 0, 3, strong=True)]).keys() == {0}


def test_what_contradicts_with_half_as_many_matches_leaves_nothing_decisive():
    block, xy = stations(3)
    wrong = pair(xy, 2, 3, 58, turned=True)
    assert agreeing(block, block, [pair(xy, 0, 3, 40), pair(xy, 1, 3, 40), wrong]) is None


def test_learned_methods_are_used_where_installed_and_asked_for(monkeypatch):
    for name in LEARNED:
        monkeypatch.setitem(registry.methods, name, SimpleNamespace(name=name, needs=("no_such_package",), install=""))
    assert further_methods("all") == further_methods("own") == ("affine_views",)
    monkeypatch.setitem(registry.methods, "xfeat", SimpleNamespace(name="xfeat", needs=(), install=""))
    assert further_methods("all") == ("affine_views", "xfeat")
    assert further_methods("own") == ("affine_views",)


def test_nothing_is_done_where_all_photographs_are_oriented():
    photos = [SimpleNamespace(name=n) for n in "abc"]
    options = SimpleNamespace(options=OrientOptions())
    state = SimpleNamespace(
        photos=photos,
        repeats={},
        mirrored=(),
        lost=(),
        scenes=None,
        asked=options,
        ties=(None,),
        notices=(),
        oriented=3,
    )
    assert not STAGE.when(state)
    assert not STAGE.when(SimpleNamespace(**{**vars(state), "lost": (("c", "the same picture"),), "repeats": {2: 0}}))
    assert not STAGE.when(SimpleNamespace(**{**vars(state), "lost": (("c", "mirrored"),), "mirrored": (2,)}))
    assert STAGE.when(SimpleNamespace(**{**vars(state), "lost": (("c", "apart"),)}))
    assert STAGE.when(SimpleNamespace(**{**vars(state), "ties": (None, None)}))
    apart = {**vars(state), "ties": (None, None)}
    assert not STAGE.when(SimpleNamespace(**{**apart, "notices": (Notice(code="repeated_structure"),)}))
    assert not STAGE.when(SimpleNamespace(**{**apart, "oriented": 2}))


def test_the_budget_grows_with_what_is_apart_and_has_a_bound():
    assert [budget_s(apart, 30) for apart in (0, 2, 30)] == [0.0, 40.0, 210.0]


def test_photographs_that_the_adjustment_leaves_out_again_are_not_joined():
    first = Notice(code="wide_baselines", ids=("a", "b"), values={"methods": ["affine_views"], "pairs": 4, "joined": 2})
    other = Notice(code="photographs", message="b")
    assert kept_joins((other, first), set()) == [other, first]
    _, less = kept_joins((other, first), {"b"})
    assert (less.ids, less.values["joined"]) == (("a",), 1)
    assert kept_joins((other, first), {"a", "b"}) == [other]
