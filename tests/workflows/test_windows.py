"""Least-squares matching as tasks: what one process measures at once, whoever does it, and after a kill."""

from dataclasses import replace
from functools import partial

import cv2
import numpy as np
import pytest

from raybundle.errors import InputError
from raybundle.io.photos.photo import read_photo
from raybundle.matching.refine import TrackPoints, match_candidates, refine_tracks
from raybundle.pipeline.executors import Processes, Threads
from raybundle.pipeline.project import Project
from raybundle.pipeline.stage import Means
from raybundle.ties import windows
from raybundle.ties.windows import Greys, matched
from tests.matching.scenes import Texture

STEP = 60.0


@pytest.fixture(scope="module")
def strip(tmp_path_factory):
    """Twelve photographs in a row over one texture, a third of the format apart, and tracks a little off."""
    folder = tmp_path_factory.mktemp("strip")
    texture, rng = Texture(5), np.random.default_rng(2)
    photos, image, point, xy = [], [], [], []
    ground = np.column_stack([rng.uniform(0, 900, 700), rng.uniform(20, 160, 700)])
    for i in range(12):
        path = folder / f"strip_{i:02d}.png"
        grey = texture.image(240, 180, lambda at, i=i: at + np.array([STEP * i, 0.0]))
        cv2.imwrite(str(path), (grey / 256).astype(np.uint8))
        photos.append(read_photo(path))
        own = ground - [STEP * i, 0.0]
        seen = np.flatnonzero((own[:, 0] > 15) & (own[:, 0] < 225))
        image.append(np.full(len(seen), i))
        point.append(seen)
        xy.append(own[seen])
    image, point, xy = np.concatenate(image), np.concatenate(point), np.concatenate(xy)
    tracks = TrackPoints(
        image=image.astype(np.int32), point=point.astype(np.int32), xy_px=xy + rng.normal(0, 0.3, xy.shape),
        scale_px=rng.uniform(2, 4, len(image)), angle=np.zeros(len(image)),
    )  # fmt: skip
    return photos, tracks, xy


@pytest.fixture
def project(tmp_path):
    p = Project.open(tmp_path / "project")
    yield p
    p.close()


def same(a, b):
    for name in ("xy_px", "cov_px2", "measured", "reference", "correlation", "level"):
        np.testing.assert_array_equal(getattr(a, name), getattr(b, name))


def at_once(photos, tracks):
    whole = Greys(limit=1e9)
    return refine_tracks(tracks, partial(match_candidates, image=lambda i, level: whole.of(photos[i], level)))


@pytest.mark.parametrize("executor", [Threads(1), Threads(4), Processes(2)], ids=["one", "threads", "processes"])
def test_what_one_process_measures_at_once(strip, project, executor):
    photos, tracks, true = strip
    found = refine_tracks(tracks, partial(matched, Means(project=project, executor=executor, jobs=3), photos))
    same(found, at_once(photos, tracks))
    assert len(project.products.keys_of_kind("windows")) > 3
    good = found.measured
    assert good.mean() > 0.9
    assert np.abs(found.xy_px - true)[good & ~found.reference].max() < 3  # what is off beside is the reference's place


def test_a_small_memory_changes_nothing(strip, project):
    photos, tracks, _ = strip
    found = refine_tracks(tracks, partial(matched, Means(project=project, executor=Threads(1), memory=1e5), photos))
    same(found, at_once(photos, tracks))
    assert sum(a.nbytes for p in windows.greys.held.values() for a in p) <= 3e5  # two photographs at least


def test_how_pairs_stand_together_changes_nothing(strip, tmp_path, monkeypatch):
    photos, tracks, _ = strip
    found = []
    for smallest in (1, 5, 20):
        monkeypatch.setattr(windows, "SMALLEST", smallest)
        p = Project.open(tmp_path / str(smallest))
        found.append(refine_tracks(tracks, partial(matched, Means(project=p, executor=Threads(2)), photos)))
        p.close()
    same(found[0], found[1])
    same(found[0], found[2])


def test_what_a_killed_run_measured_is_kept(strip, project):
    photos, tracks, _ = strip
    first = refine_tracks(tracks, partial(matched, Means(project=project, executor=Threads(1)), photos))
    kept = project.products.keys_of_kind("windows")
    project.products.forget(kept[1])
    again = Means(project=project, executor=Threads(1))
    same(refine_tracks(tracks, partial(matched, again, photos)), first)
    assert (again.asked, again.made) == (len(kept), 1)


def test_a_photograph_that_is_gone_is_named(strip, project):
    photos, tracks, _ = strip
    gone = [*photos[:4], replace(photos[4], path=photos[4].path.with_name("gone.png"), sha256="0" * 64), *photos[5:]]
    with pytest.raises(InputError, match=r"gone\.png"):
        refine_tracks(tracks, partial(matched, Means(project=project, executor=Threads(1)), gone))


def test_nothing_to_look_for_gives_nothing(strip, project):
    photos, tracks, _ = strip
    alone = TrackPoints(
        image=tracks.image[:1], point=tracks.point[:1], xy_px=tracks.xy_px[:1], scale_px=tracks.scale_px[:1],
        angle=tracks.angle[:1],
    )  # fmt: skip
    found = refine_tracks(alone, partial(matched, Means(project=project, executor=Threads(1)), photos))
    assert not found.measured.any()
