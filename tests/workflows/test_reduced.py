"""Photographs that tell nothing at the size of their pixels are searched again on reduced copies."""

from dataclasses import replace
from types import SimpleNamespace

import numpy as np
import pytest
from PIL import Image

from raybundle.errors import NoOrientation
from raybundle.io.photos.photo import find_photos
from raybundle.matching.features import feature_number
from raybundle.matching.methods import feature_method
from raybundle.matching.reduced import LONGEST_PX, Reduced, reduction
from raybundle.pipeline.project import Project
from raybundle.pipeline.stage import Run, Stage, Workflow
from raybundle.placing.marks import Given
from raybundle.workflows.orienting.options import OrientOptions
from raybundle.workflows.orienting.stages.reduced import ALTERNATIVE
from raybundle.workflows.orienting.state import Asked, OrientState


def texture(width, height, seed=3):
    rng = np.random.default_rng(seed)
    total = np.zeros((height, width))
    for size in (16, 40, 100):
        small = rng.integers(0, 256, (height // size + 2, width // size + 2), dtype=np.uint8)
        total += np.asarray(Image.fromarray(small).resize((width, height), Image.Resampling.BICUBIC), float)
    return (total / 3).astype(np.uint8)


@pytest.mark.long
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
def photos(tmp_path):
    """Two large photographs."""
    (tmp_path / "photos").mkdir()
    for value, name in enumerate("ab"):
        Image.fromarray(np.full((2400, 3600), value, np.uint8)).save(tmp_path / f"photos/{name}.png")
    return find_photos([tmp_path / "photos"]).photos


def oriented(folder, photos, counts):
    """The state after starts that orient so many photographs, None: that find nothing, and the methods tried."""
    tried = []

    def start(method, means):
        tried.append(method.name)
        count = counts[len(tried) - 1]
        if count is None:
            raise NoOrientation("nothing fits")
        return (SimpleNamespace(block=SimpleNamespace(images=SimpleNamespace(oriented=np.arange(2) < count))),)

    def stage(name, after, function=lambda *_: None, put=lambda s, _: s):
        return Stage(name=name, after=after, inputs=lambda s: s.method, function=function, put=put)

    steps = Workflow("test", alternatives=[ALTERNATIVE])
    for name, after in (("features", ()), ("matching", ("features",)), ("scene_matching", ("matching",))):
        steps.register(stage(name, after))
    steps.register(stage("start", ("scene_matching",), start, lambda s, ties: replace(s, ties=ties)))
    steps.register(stage("scene_start", ("start",)))
    method = feature_method("rootsift")
    asked = Asked(inputs=(), name="p", options=OrientOptions(), given=Given(), method=method)
    project = Project.open(folder / "project")
    try:
        state = OrientState(asked=asked, given=Given(), method=method, photos=photos)
        return Run(project=project).workflow(steps, state), tried
    finally:
        project.close()


@pytest.mark.parametrize(
    ("counts", "better"), [((2, 2), None), ((None, 2), True), ((0, 2), True), ((1, 1), False), ((1, None), False)]
)
def test_reduced_copies_are_tried_where_photographs_are_left_and_taken_where_they_orient_more(
    tmp_path, photos, counts, better
):
    state, tried = oriented(tmp_path, photos, counts)
    assert len(tried) == (1 if better is None else 2)
    assert isinstance(state.method, Reduced) is bool(better)
    if better:
        (told,) = state.notices
        assert (told.code, told.severity) == ("reduced_features", "note")
        assert (told.values["oriented"], told.values["photographs"], told.values["whole"]) == (2, 2, counts[0] or 0)


def test_where_neither_way_finds_anything_the_first_one_says_why(tmp_path, photos):
    with pytest.raises(NoOrientation, match="nothing fits"):
        oriented(tmp_path, photos, (None, None))


def test_photographs_of_ordinary_size_are_not_searched_again(tmp_path, photos):
    small = tuple(replace(p, width_px=2 * LONGEST_PX - 1, height_px=2000) for p in photos)
    state, tried = oriented(tmp_path, small, (0, 2))
    assert tried == ["rootsift"]
    assert not state.again
    assert reduction(6400, 3200) == 4
