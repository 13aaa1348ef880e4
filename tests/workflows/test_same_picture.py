"""Photographs that repeat another are found by their pixels, and the better file stays."""

from types import SimpleNamespace

import numpy as np
import pytest
from PIL import Image

from raybundle.io.photos.photo import find_photos
from raybundle.matching.features import Described
from raybundle.matching.methods import feature_method
from raybundle.matching.verify import verify
from raybundle.pipeline.project import Project
from raybundle.pipeline.stage import Means
from raybundle.ties.points import find_features
from raybundle.ties.same_picture import same_picture_notice, same_pictures
from raybundle.ties.static_background import still_and_moving


def picture(shift=0, seed=3):
    rng = np.random.default_rng(seed)
    total = np.zeros((300, 500))
    for size in (4, 9, 25):
        small = rng.integers(0, 256, (300 // size + 2, 500 // size + 2), dtype=np.uint8)
        total += np.asarray(Image.fromarray(small).resize((500, 300), Image.Resampling.BICUBIC), float)
    return Image.fromarray((total / 3).astype(np.uint8)[:, shift : shift + 400])


@pytest.fixture
def found(tmp_path):
    """Repeats among three photographs: two of one picture, and one that the camera moved for."""
    (tmp_path / "photos").mkdir()
    picture().save(tmp_path / "photos/a_edited.jpg", quality=70)
    picture().save(tmp_path / "photos/b.jpg", quality=95)
    picture(30).save(tmp_path / "photos/c.jpg", quality=95)
    picture(60).save(tmp_path / "photos/d.jpg", quality=95)
    photos = find_photos([tmp_path / "photos"]).photos
    method = feature_method("rootsift")
    project = Project.open(tmp_path / "project")
    store, _ = find_features(Means(project=project), photos, method, 800)
    pairs = []
    for i in range(4):
        for j in range(i + 1, 4):
            f, g = store.of(i), store.of(j)
            one, two = (Described(xy_px=h.xy_px, descriptors=h.descriptors, size_px=(400, 300)) for h in (f, g))
            pairs.append(verify(i, j, f.xy_px, g.xy_px, method.match(one, two), (400, 300), (400, 300)))
    yield photos, same_pictures(pairs, photos, store, method)
    project.close()


def test_the_more_compressed_copy_repeats_the_other_and_is_named(found):
    photos, repeats = found
    assert repeats == {0: 1}
    stated = same_picture_notice(repeats, photos)
    assert (stated.code, stated.ids) == ("identical_images", ("a_edited.jpg",))
    assert stated.values["names"] == [f"{photos[0].name} ({photos[1].name})"]


def test_an_equal_part_at_the_same_pixels_is_no_copy(tmp_path):
    (tmp_path / "photos").mkdir()
    other = np.asarray(picture(seed=4)).copy()
    other[80:230, 60:330] = np.asarray(picture())[80:230, 60:330]  # a third of the format
    picture().save(tmp_path / "photos/a.jpg", quality=95)
    Image.fromarray(other).save(tmp_path / "photos/b.jpg", quality=95)
    picture(30).save(tmp_path / "photos/c.jpg", quality=95)
    photos = find_photos([tmp_path / "photos"]).photos
    method = feature_method("rootsift")
    project = Project.open(tmp_path / "project")
    store, _ = find_features(Means(project=project), photos, method, 800)
    f, g = store.of(0), store.of(1)
    one, two = (Described(xy_px=h.xy_px, descriptors=h.descriptors, size_px=(400, 300)) for h in (f, g))
    pair = verify(0, 1, f.xy_px, g.xy_px, method.match(one, two), (400, 300), (400, 300))
    still = still_and_moving(photos, store, method, 0, 1)
    assert pair.displacement_px < 0.5
    assert still.still > 0
    assert still.covered < 0.6
    assert same_pictures([pair], photos, store, method) == {}
    project.close()


class Given:
    """Features at given places, and their matches: those of the same number."""

    def __init__(self, *xy_px):
        self.xy_px = xy_px

    def of(self, k):
        return SimpleNamespace(xy_px=self.xy_px[k], descriptors=np.zeros((len(self.xy_px[k]), 1)))

    def match(self, one, two):
        return np.stack([np.arange(len(one.xy_px)), np.arange(len(two.xy_px))], axis=1)


@pytest.mark.parametrize(("region", "moving"), [((400, 300), False), ((120, 90), True)])
def test_what_moves_where_more_stands_still_is_no_motion(tmp_path, region, moving):
    """Matches of things that look alike lie among those that stand still; an object that turns has its own place."""
    for name, quality in (("a.jpg", 90), ("b.jpg", 80)):
        picture().save(tmp_path / name, quality=quality)
    photos = find_photos([tmp_path]).photos
    rng = np.random.default_rng(2)
    still, moved = rng.uniform(0, 1, (600, 2)) * (400, 300), 10 + rng.uniform(0, 1, (40, 2)) * np.array(region) * 0.9
    still = still[(still > 10 + np.array(region)).any(axis=1)] if moving else still
    store = Given(np.vstack([still, moved]), np.vstack([still, moved + [20.0, 1.0] + 0.01 * moved]))
    pair = still_and_moving(photos, store, store, 0, 1)
    assert pair.still == len(still)
    assert pair.moving == moving


def test_a_reduced_copy_repeats_its_original_and_another_shape_does_not(tmp_path):
    (tmp_path / "photos").mkdir()
    picture().save(tmp_path / "photos/a.jpg", quality=95)
    picture().resize((200, 150), Image.Resampling.LANCZOS).save(tmp_path / "photos/b_small.jpg", quality=90)
    picture(30).save(tmp_path / "photos/c.jpg", quality=95)
    picture().crop((0, 0, 400, 250)).save(tmp_path / "photos/d_cut.jpg", quality=95)
    photos = find_photos([tmp_path / "photos"]).photos
    method = feature_method("rootsift")
    project = Project.open(tmp_path / "project")
    store, _ = find_features(Means(project=project), photos, method, 800)
    sizes = [p.upright_size for p in photos]
    pairs = []
    for i, j in ((0, 1), (0, 3), (1, 2)):
        one, two = (
            Described(xy_px=(f := store.of(k)).xy_px, descriptors=f.descriptors, size_px=sizes[k]) for k in (i, j)
        )
        pairs.append(verify(i, j, one.xy_px, two.xy_px, method.match(one, two), sizes[i], sizes[j]))
    assert len(pairs[0].matches)
    assert len(pairs[1].matches)
    assert same_pictures(pairs, photos, store, method) == {1: 0}
    project.close()
