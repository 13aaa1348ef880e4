"""Photographs that tell nothing at the size of their pixels are searched again on reduced copies."""

from dataclasses import replace

import numpy as np
import pytest
from PIL import Image

from raybundle.errors import NoOrientation
from raybundle.io.photos.photo import find_photos
from raybundle.io.project import Project
from raybundle.matching.features import feature_method, feature_number
from raybundle.matching.reduced import LONGEST_PX, Reduced, reduction
from raybundle.numerics.progress import silent
from raybundle.workflows.photo_run import PhotoRun


def texture(width, height, seed=3):
    rng = np.random.default_rng(seed)
    total = np.zeros((height, width))
    for size in (16, 40, 100):
        small = rng.integers(0, 256, (height // size + 2, width // size + 2), dtype=np.uint8)
        total += np.asarray(Image.fromarray(small).resize((width, height), Image.Resampling.BICUBIC), float)
    return (total / 3).astype(np.uint8)


def test_places_and_sizes_are_those_of_the_photograph():
    grey, method = texture(3200, 2400), feature_method("rootsift")
    found = Reduced(method).detect(grey, 10_000)
    small = method.detect(np.asarray(Image.fromarray(grey).reduce(2)), 4800)
    assert 0 < len(found) <= feature_number(1600, 1200, 10_000) == 4800
    near = np.linalg.norm(found.xy_px[:, None] - 2 * small.xy_px[None], axis=2).min(axis=1)
    assert np.median(near) < 0.5
    assert np.median(found.scale_px) == pytest.approx(2 * np.median(small.scale_px), rel=0.1)
    few = method.detect(grey[:1200, :1600], 10_000)
    assert np.array_equal(Reduced(method).detect(grey[:1200, :1600], 10_000).xy_px, few.xy_px)  # small ones as they are


@pytest.fixture
def run(tmp_path):
    """Two large photographs, begun."""
    (tmp_path / "photos").mkdir()
    for value, name in enumerate("ab"):
        Image.fromarray(np.full((2400, 3600), value, np.uint8)).save(tmp_path / f"photos/{name}.png")
    photos = find_photos([tmp_path / "photos"]).photos
    project = Project.open(tmp_path / "project")
    yield project, PhotoRun(photos, 1, silent)
    project.close()


def started(monkeypatch, counts):
    """Starts that orient so many photographs with each kind of features, in the order of the tries."""
    tried = []

    def features(self, _project, _stage, method, _most):
        tried.append(method.name)

    def start(self, *_):
        if counts[len(tried) - 1] is None:
            raise NoOrientation("nothing fits")

    monkeypatch.setattr(PhotoRun, "features", features)
    monkeypatch.setattr(PhotoRun, "matching", lambda *_: None)
    monkeypatch.setattr(PhotoRun, "start", start)
    monkeypatch.setattr(PhotoRun, "_oriented", lambda _: counts[max(len(tried) - 1, 0)] or 0)
    return tried


@pytest.mark.parametrize(("counts", "better"), [((2, 2), None), ((0, 2), True), ((1, 1), False), ((1, None), False)])
def test_reduced_copies_are_tried_where_photographs_are_left_and_taken_where_they_orient_more(
    run, monkeypatch, counts, better
):
    project, photographs = run
    tried = started(monkeypatch, counts)
    method = feature_method("rootsift")
    photographs.features(project, None, method, 1000)
    tried[:] = tried[:1]
    monkeypatch.setattr(PhotoRun, "_oriented", lambda _: counts[len(tried) - 1] or 0)
    found = photographs.searched_again(project, "name", "auto", method, 1000)
    assert len(tried) == (1 if better is None else 2)
    assert (found is not photographs) is bool(better)
    if better:
        (told,) = found.notices
        assert (told.code, told.severity) == ("reduced_features", "remark")
        assert f"2 of 2 photographs hang together by them, {counts[0]} by" in told.message


def test_photographs_of_ordinary_size_are_not_searched_again(run, monkeypatch):
    project, photographs = run
    tried = started(monkeypatch, (0, 2))
    photographs.photos = tuple(replace(p, width_px=2 * LONGEST_PX - 1, height_px=2000) for p in photographs.photos)
    assert photographs.searched_again(project, "name", "auto", feature_method("rootsift"), 1000) is photographs
    assert not tried
    assert reduction(6400, 3200) == 4
