"""Masks: named as other programs name them, heeded from the features on; a background that stands still is said."""

import json
import re
from dataclasses import replace

import numpy as np
import pytest
from PIL import Image

from raybundle.cli.main import main
from raybundle.errors import InputError
from raybundle.io.photos.masks import find_masks
from raybundle.io.photos.photo import find_photos
from raybundle.matching.methods import feature_method
from raybundle.ties.points import detected, feature_key
from raybundle.workflows.mask_notices import mask_notices

WIDTH, HEIGHT, C = 640, 480, 800.0
STEP = np.radians(9)


def texture(rng, height, width):
    total = np.zeros((height, width))
    for size in (4, 9, 25, 70):
        small = rng.integers(0, 256, (height // size + 2, width // size + 2), dtype=np.uint8)
        total += np.asarray(Image.fromarray(small).resize((width, height), Image.Resampling.BICUBIC), float)
    return total / 4


def turntable(folder, count=8):
    """A body of revolution with bumps that turns before a textured wall: photographs, and masks of the wall."""
    rng = np.random.default_rng(4)
    wall, skin = texture(rng, HEIGHT, WIDTH), texture(rng, 500, 1600)
    x, y = np.meshgrid(np.arange(WIDTH) + 0.5 - WIDTH / 2, np.arange(HEIGHT) + 0.5 - HEIGHT / 2)
    ray = np.stack([x / C, np.ones_like(x), -y / C], axis=-1)  # from (0, -3.2, 0) along y, z up

    def radius(angle, z):
        return 0.5 + 0.12 * np.sin(3 * z * np.pi) + 0.08 * np.sin(3 * angle)

    (folder / "photos").mkdir()
    (folder / "masks").mkdir()
    for k in range(count):
        depth = np.full(x.shape, np.nan)
        for d in np.arange(2.3, 3.3, 0.004):  # the first point within the body
            X, Y, Z = ray[..., 0] * d, ray[..., 1] * d - 3.2, ray[..., 2] * d
            inside = np.hypot(X, Y) < radius(np.arctan2(Y, X) - k * STEP, Z)
            depth[inside & np.isnan(depth) & (np.abs(Z) < 0.8)] = d
        seen = np.isfinite(depth)
        d = np.where(seen, depth, 3.0)
        X, Y, Z = ray[..., 0] * d, ray[..., 1] * d - 3.2, ray[..., 2] * d
        u = ((np.arctan2(Y, X) - k * STEP) % (2 * np.pi)) / (2 * np.pi) * 1599
        v = np.clip((Z + 0.8) / 1.6 * 499, 0, 499)
        i, j = np.clip(v.astype(int), 0, 498), np.clip(u.astype(int), 0, 1598)
        a, b = v - i, u - j
        body = (skin[i, j] * (1 - b) + skin[i, j + 1] * b) * (1 - a) + (
            skin[i + 1, j] * (1 - b) + skin[i + 1, j + 1] * b
        ) * a
        grey = np.where(seen, body, wall) + rng.normal(0, 1.5, x.shape)
        Image.fromarray(np.clip(grey, 0, 255).astype(np.uint8)).save(folder / f"photos/{k}.png")
        Image.fromarray((seen * 255).astype(np.uint8)).save(folder / f"masks/{k}.png.png")
    return folder


@pytest.fixture(scope="module")
def scene(tmp_path_factory):
    return turntable(tmp_path_factory.mktemp("turntable"))


def orient(scene, out, *more):
    return main([
        "orient", str(scene / "photos"), "--out", str(out), "--feature-count", "1500", "--jobs", "2", "--no-report",
        *more,
    ])  # fmt: skip


def turns(out):
    """Angles [rad] between the photographs and the first."""
    from raybundle.io.block.folder import read_block

    images = read_block(out / "result/block").images
    relative = images.rotation @ images.rotation[0].T
    return np.arccos(np.clip((np.trace(relative, axis1=1, axis2=2) - 1) / 2, -1, 1))


@pytest.mark.long
def test_a_turntable_before_a_wall_is_wrong_or_refused_without_masks_and_that_is_said(scene, tmp_path, capsys):
    status = orient(scene, tmp_path / "project")
    told = capsys.readouterr()
    assert "[static_background]" in told.out + told.err
    assert "--masks DIR" in told.out + told.err
    if status == 0:
        notices = json.loads((tmp_path / "project/result/result.json").read_text())["warnings"]
        assert any(n["code"] == "static_background" for n in notices)


@pytest.mark.long
def test_with_masks_it_is_right(scene, tmp_path, capsys):
    assert orient(scene, tmp_path / "project", "--masks", str(scene / "masks")) == 0
    assert "8 of 8 photographs" in capsys.readouterr().out
    notices = json.loads((tmp_path / "project/result/result.json").read_text())["warnings"]
    found = {n["code"]: n for n in notices}
    assert {"n": 8, "photographs": 8, "of": "features"}.items() <= found["masks"]["values"].items()
    assert "static_background" not in found
    assert turns(tmp_path / "project") == pytest.approx(np.arange(8) * STEP, abs=np.radians(0.5))


# ---- names, sizes, frames


@pytest.fixture
def photos(tmp_path):
    rng = np.random.default_rng(1)
    (tmp_path / "photos").mkdir()
    for name in ("a.jpg", "b.jpg"):
        Image.fromarray(texture(rng, 240, 320).astype(np.uint8)).save(tmp_path / "photos" / name, quality=95)
    return find_photos([tmp_path / "photos"]).photos


def mask(path, width=320, height=240, left=160):
    """0 to the left."""
    path.parent.mkdir(parents=True, exist_ok=True)
    pixels = np.ones((height, width), np.uint8)  # 1 is as good as 255
    pixels[:, : left * width // 320] = 0
    Image.fromarray(pixels).save(path)


@pytest.mark.parametrize("name", ["a.jpg.png", "a_mask.png", "a.png", "photos/a.jpg.png"])
def test_masks_are_found_by_the_names_of_colmap_and_metashape(photos, tmp_path, name):
    mask(tmp_path / "masks" / name)
    masks = find_masks(tmp_path / "masks", photos)
    assert list(masks.files) == ["a.jpg"]
    assert masks.missing == ("b.jpg",)
    (told,) = mask_notices(masks)
    assert "completely: 1 (b.jpg)" in told.text
    method = feature_method("rootsift")
    found = detected(method, photos[0], 300, masks)
    assert len(found) > 50
    assert found.xy_px[:, 0].min() > 160
    assert detected(method, photos[1], 300, masks).xy_px[:, 0].min() < 160


@pytest.mark.parametrize("factor", [2, 0.5])
def test_a_mask_of_another_size_is_scaled(photos, tmp_path, factor):
    mask(tmp_path / "masks/a.png", int(320 * factor), int(240 * factor))
    free = find_masks(tmp_path / "masks", photos).of(photos[0])
    assert free.shape == (240, 320)
    assert not free[:, :160].any()
    assert free[:, 160:].all()


def test_a_mask_of_another_shape_costs_itself_and_names_both_sizes(photos, tmp_path):
    mask(tmp_path / "masks/a.png", 320, 200)
    (tmp_path / "masks/b.png").write_bytes(b"no picture")
    masks = find_masks(tmp_path / "masks", photos)
    assert not masks.files
    reasons = dict(masks.refused)
    assert re.search(r"320 x 200 px.*a\.jpg 320 x 240", reasons["a.jpg"])
    assert "b.png" in reasons["b.jpg"]
    assert [n.code for n in mask_notices(masks)] == ["masks", "mask_refused"]


def test_the_mask_of_a_picture_shown_upright_is_turned_as_the_photograph_is(photos, tmp_path):
    path = tmp_path / "photos/b.jpg"
    with Image.open(path) as image:
        exif = image.getexif()
        exif[0x0112] = 6
        image.save(path, exif=exif.tobytes())
    photo = find_photos([tmp_path / "photos"]).photos[1]
    upright = np.zeros((320, 240), np.uint8)
    upright[:10] = 255  # the upper rows, which the sensor has at the left
    (tmp_path / "masks").mkdir()
    Image.fromarray(upright).save(tmp_path / "masks/b.png")
    free = find_masks(tmp_path / "masks", [photo]).of(photo)
    assert free[:, :10].all()
    assert not free[:, 10:].any()


def test_names_that_repeat_are_told_apart_by_their_folders(tmp_path):
    rng = np.random.default_rng(1)
    for folder in ("left", "right"):
        (tmp_path / folder).mkdir()
        Image.fromarray(texture(rng, 240, 320).astype(np.uint8)).save(tmp_path / folder / "a.png")
    photos = find_photos([tmp_path / "left", tmp_path / "right"]).photos
    mask(tmp_path / "masks/right/a.png.png")
    mask(tmp_path / "masks/a.png")  # of which?
    assert list(find_masks(tmp_path / "masks", photos).files) == ["right/a.png"]


def test_a_folder_without_any_mask_says_how_they_are_named(photos, tmp_path):
    with pytest.raises(InputError, match=r"a\.jpg\.png.*mask\.none_found"):
        find_masks(tmp_path / "photos", photos)
    with pytest.raises(InputError, match=r"file\.missing"):
        find_masks(tmp_path / "none", photos)


def test_the_key_of_features_follows_the_content_of_the_mask(photos, tmp_path):
    method = feature_method("rootsift")
    keys = {feature_key(photos[0], method, 300)}
    for left in (100, 160):
        mask(tmp_path / "masks/a.png", left=left)
        keys.add(feature_key(photos[0], method, 300, find_masks(tmp_path / "masks", photos).key(photos[0])))
    assert len(keys) == 3


def test_windows_that_reach_into_the_mask_are_not_measured(photos, tmp_path):
    mask(tmp_path / "masks/a.png")
    masks = find_masks(tmp_path / "masks", photos)
    at = np.array([[161.0, 100.0], [175.0, 100.0], [100.0, 100.0]])
    assert masks.visible(photos[0], at, np.array([8.0, 8.0, 0.0])).tolist() == [False, True, False]
    assert masks.visible(photos[1], at, np.full(3, 8.0)).all()


# ---- how masks lie, what masks, what does not


def with_orientation(path, orientation):
    """The picture as it is, with an EXIF orientation."""
    with Image.open(path) as image:
        exif = image.getexif()
        exif[0x0112] = orientation
        image.save(path, exif=exif.tobytes())


def codes(masks):
    return [n.code for n in mask_notices(masks)]


@pytest.mark.parametrize("orientation", [2, 3, 4])
def test_it_is_said_where_nothing_tells_how_a_mask_lies(photos, tmp_path, orientation):
    with_orientation(tmp_path / "photos/b.jpg", orientation)
    photos = find_photos([tmp_path / "photos"]).photos
    for name in ("a.png", "b.png"):
        mask(tmp_path / "masks" / name)
    masks = find_masks(tmp_path / "masks", photos)
    assert not masks.of(photos[1])[:, :160].any()  # as stored
    told = mask_notices(masks)[1]
    assert (told.code, told.ids) == ("mask_orientation", ("b.jpg",))
    assert f"EXIF orientation {orientation}" in told.text


@pytest.mark.parametrize(("of_photo", "of_mask", "hidden"), [
    (3, 3, "left"), (3, 1, "right"), (1, 3, "right"), (2, 3, "left"), (1, 1, "left"),
])  # fmt: skip
def test_an_orientation_that_the_mask_itself_states_is_heeded(photos, tmp_path, of_photo, of_mask, hidden):
    with_orientation(tmp_path / "photos/a.jpg", of_photo)
    photo = find_photos([tmp_path / "photos"]).photos[0]
    mask(tmp_path / "masks/a.png")
    with_orientation(tmp_path / "masks/a.png", of_mask)
    masks = find_masks(tmp_path / "masks", [photo])
    free = masks.of(photo)
    assert free[:, :160].any() == (hidden == "right")
    assert free[:, 160:].any() == (hidden == "left")
    assert "mask_orientation" not in codes(masks)


def painted(mode):
    """A picture that masks the left half in a way that programs write."""
    free = np.zeros((240, 320), np.uint8)
    free[:, 160:] = 1
    if mode in {"LA", "RGBA"}:
        white = [np.full_like(free, 255)] * (len(mode) - 1)
        return Image.fromarray(np.dstack([*white, free * 255]), mode)
    if mode == "P":
        image = Image.fromarray(free, "P")
        image.putpalette([0, 0, 0, 1, 0, 0])
        return image
    if mode == "I;16":
        return Image.fromarray(free.astype(np.uint16))
    return Image.fromarray(np.dstack([free * 0, free * 0, free]))


@pytest.mark.parametrize("mode", ["LA", "RGBA", "P", "I;16", "RGB"])
def test_alpha_masks_and_the_least_of_any_channel_counts_as_used(photos, tmp_path, mode):
    (tmp_path / "masks").mkdir()
    painted(mode).save(tmp_path / "masks/a.png")
    free = find_masks(tmp_path / "masks", photos).of(photos[0])
    assert free[:, 160:].all()
    assert not free[:, :160].any()


@pytest.mark.parametrize(("left", "variant"), [(0, ""), (320, "hidden")])
def test_a_mask_that_is_of_one_value_is_named(photos, tmp_path, left, variant):
    photos = (*photos, replace(photos[1], name="c.jpg"))
    mask(tmp_path / "masks/a.png", left=left)
    told = mask_notices(find_masks(tmp_path / "masks", photos))[-1]
    assert (told.code, told.variant, told.ids) == ("mask_uniform", variant, ("a.jpg",))
    assert "a.jpg" in told.text


def test_masks_that_leave_nothing_are_refused_at_once(photos, tmp_path):
    for name in ("a.png", "b.png"):
        mask(tmp_path / "masks" / name, left=320)
    with pytest.raises(InputError, match=r"2.*a\.jpg.*b\.jpg.*mask\.all_hidden"):
        find_masks(tmp_path / "masks", photos)


@pytest.mark.parametrize("damage", ["truncated", "checksum"])
def test_a_damaged_mask_costs_itself_alone(photos, tmp_path, damage):
    rng = np.random.default_rng(2)
    for name in ("a.png", "b.png"):
        mask(tmp_path / "masks" / name)
    path = tmp_path / "masks/a.png"
    Image.fromarray(rng.integers(0, 2, (240, 320), np.uint8) * 255).save(path)
    data = bytearray(path.read_bytes())
    if damage == "truncated":
        path.write_bytes(data[: len(data) // 2])
    else:
        data[len(data) // 2] ^= 0x55
        path.write_bytes(data)
    masks = find_masks(tmp_path / "masks", photos)
    assert list(masks.files) == ["b.jpg"]
    stated, refused = mask_notices(masks)
    assert {"n": 1, "photographs": 2}.items() <= stated.values.items()
    assert refused.code == "mask_refused"
    assert [d.place.file for d in refused.details] == ["a.jpg"]
    assert len(detected(feature_method("rootsift"), photos[0], 300, masks)) > 50


@pytest.mark.parametrize("name", ["a_MASK.PNG", "a_mask.jpg", "A.jpg.png"])
def test_a_mask_of_nearly_the_right_name_is_seen(photos, tmp_path, name):
    mask(tmp_path / "masks" / name)
    if (tmp_path / "masks" / name.lower()).exists() and name != name.lower():
        pytest.skip("the file system tells no capital letters")
    with pytest.raises(InputError, match=r"a\.jpg\.png.*mask\.none_found"):
        find_masks(tmp_path / "masks", photos)
    mask(tmp_path / "masks/b.png")
    refused = mask_notices(find_masks(tmp_path / "masks", photos))[1]
    assert (refused.code, refused.ids) == ("mask_refused", ("a.jpg",))
    (why,) = refused.details
    assert (why.code, why.values["name"]) == ("mask.other_name", name)
