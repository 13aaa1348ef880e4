"""Photographs among files of every kind, and their pixels."""

import os
import struct
import zlib

import numpy as np
import pytest
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st
from PIL import Image
from tests.io.photos.heic_samples import heic

from raybundle import words
from raybundle.errors import InputError
from raybundle.io.photos.photo import (
    find_photos,
    read_colour,
    read_grey,
    read_photo,
    stored_from_upright,
    upright,
    upright_from_stored,
)


def scene(width=600, height=400, seed=1):
    rng = np.random.default_rng(seed)
    coarse = rng.integers(0, 256, (height // 20, width // 20, 3), dtype=np.uint8)
    return np.asarray(Image.fromarray(coarse).resize((width, height), Image.Resampling.BICUBIC))


def save(path, pixels=None, **options):
    Image.fromarray(scene() if pixels is None else pixels).save(path, **options)
    return path


def reasons(found):
    return {path.name: reason for path, reason in found.refused}


def png_header(width, height):
    head = struct.pack(">IIBBBBB", width, height, 8, 2, 0, 0, 0)
    chunk = b"IHDR" + head
    return b"\x89PNG\r\n\x1a\n" + struct.pack(">I", 13) + chunk + struct.pack(">I", zlib.crc32(chunk))


def test_each_bad_file_costs_that_file_only(tmp_path):
    save(tmp_path / "good 1.jpg")
    save(tmp_path / "gut ä 雪.png", scene(seed=2))
    (tmp_path / "empty.jpg").touch()
    (tmp_path / "text.jpg").write_text("dear diary, today I took no photograph")
    whole = save(tmp_path / "cut.jpg", scene(seed=3), quality=95).read_bytes()
    (tmp_path / "cut.jpg").write_bytes(whole[: len(whole) // 2])
    whole = save(tmp_path / "cut.png", scene(seed=4)).read_bytes()
    (tmp_path / "cut.png").write_bytes(whole[: len(whole) // 2])
    whole = save(tmp_path / "cut.tif", scene(seed=5)).read_bytes()
    (tmp_path / "cut.tif").write_bytes(whole[: len(whole) // 2])
    whole = save(tmp_path / "cut.webp", scene(seed=6)).read_bytes()
    (tmp_path / "cut.webp").write_bytes(whole[: len(whole) // 2])
    save(tmp_path / "thumb.jpg", scene(100, 100))
    (tmp_path / "bomb.png").write_bytes(png_header(30000, 30000) + b"\0\0\0\0IEND")
    (tmp_path / "copy.jpg").write_bytes((tmp_path / "good 1.jpg").read_bytes())
    (tmp_path / "gone.jpg").symlink_to(tmp_path / "nowhere.jpg")
    os.mkfifo(tmp_path / "pipe.jpg")
    (tmp_path / ".hidden.jpg").write_text("x")
    (tmp_path / "notes.txt").write_text("x")
    (tmp_path / "more").mkdir()
    found = find_photos([tmp_path])
    assert [p.name for p in found.photos] == ["copy.jpg", "gut ä 雪.png"]
    why = reasons(found)
    codes = {name: reason.messages[0].code for name, reason in why.items()}
    assert codes["empty.jpg"] == "photograph.empty"
    assert "dear diary, " in why["text.jpg"]
    for name in ("cut.jpg", "cut.png", "cut.tif", "cut.webp"):
        assert codes[name] in {"photograph.pixels_unreadable", "photograph.header_unreadable"}, why[name]
    assert codes["thumb.jpg"] == "photograph.thumbnail"
    bomb = why["bomb.png"].messages[0]
    assert (bomb.code, bomb.values["megapixels"], bomb.values["limit_megapixels"]) == ("photograph.too_large", 900, 600)
    assert codes["good 1.jpg"] == "photograph.copy"
    assert found.copies == {"good 1.jpg": "copy.jpg"}
    assert codes["gone.jpg"] == "file.not_readable"
    assert codes["pipe.jpg"] == "file.not_a_file"
    assert len(why) == 11
    assert any("sub-folder" in r for r in found.remarks)
    assert any(".txt" in r for r in found.remarks)


def test_a_file_without_permission_costs_that_file_only(tmp_path):
    save(tmp_path / "a.jpg")
    save(tmp_path / "b.jpg", scene(seed=2)).chmod(0)
    if os.access(tmp_path / "b.jpg", os.R_OK):
        pytest.skip("this user may read everything")
    found = find_photos([tmp_path])
    assert [p.name for p in found.photos] == ["a.jpg"]
    assert "Permission denied" in reasons(found)["b.jpg"]


def test_a_limit_is_held_before_decoding(tmp_path):
    save(tmp_path / "a.webp")
    save(tmp_path / "b.tif")
    found = find_photos([tmp_path], limit_pixels=200_000)
    assert found.photos == ()
    assert {reason.messages[0].code for _, reason in found.refused} == {"photograph.too_large"}


def test_small_photographs_alone_are_no_thumbnails(tmp_path):
    for k in range(3):
        save(tmp_path / f"{k}.jpg", scene(100, 100, seed=k))
    assert len(find_photos([tmp_path]).photos) == 3


def test_the_order_is_that_of_a_reader(tmp_path):
    for k in (10, 9, 1):
        save(tmp_path / f"img{k}.jpg", scene(seed=k))
    assert [p.name for p in find_photos([tmp_path]).photos] == ["img1.jpg", "img9.jpg", "img10.jpg"]


def test_names_that_repeat_become_paths(tmp_path):
    for k in (1, 2):
        (tmp_path / f"flight {k}").mkdir()
        save(tmp_path / f"flight {k}" / "a.jpg", scene(seed=k))
    found = find_photos([tmp_path / "flight 1", tmp_path / "flight 2", tmp_path / "flight 1" / "a.jpg"])
    assert [p.name for p in found.photos] == ["flight 1/a.jpg", "flight 2/a.jpg"]


def test_an_input_that_does_not_exist_is_an_error(tmp_path):
    with pytest.raises(InputError, match=r"file\.missing"):
        find_photos([tmp_path / "photos"])


def test_a_raw_file_beside_its_jpeg_is_left_out(tmp_path):
    save(tmp_path / "DSC1.JPG", format="JPEG")
    (tmp_path / "DSC1.NEF").write_bytes(b"MM\0*")
    found = find_photos([tmp_path])
    assert [p.name for p in found.photos] == ["DSC1.JPG"]
    assert found.refused == ()
    assert "DSC1.NEF" in found.remarks[0]


# ---- pixels


@pytest.mark.parametrize("suffix", ["png", "tif", "webp", "jpg"])
def test_pixels_of_eight_bits(tmp_path, suffix):
    options = {"webp": {"lossless": True}, "jpg": {"quality": 100, "subsampling": 0}}.get(suffix, {})
    photo = read_photo(save(tmp_path / f"a.{suffix}", **options))
    grey, colour = read_grey(photo), read_colour(photo)
    assert (photo.bits, grey.dtype, grey.shape, colour.shape) == (8, np.uint8, (400, 600), (400, 600, 3))
    assert grey.flags.c_contiguous
    assert np.abs(grey - scene() @ [0.299, 0.587, 0.114]).max() < 3
    assert np.abs(colour.astype(int) - scene()).max() <= (6 if suffix == "jpg" else 0)


@pytest.mark.parametrize("suffix", ["png", "tif"])
@pytest.mark.parametrize("channels", [1, 3])
def test_pixels_of_sixteen_bits_are_kept(tmp_path, suffix, channels):
    import cv2

    rng = np.random.default_rng(1)
    pixels = rng.integers(0, 65536, (40, 60, channels), dtype=np.uint16)
    path = tmp_path / f"a.{suffix}"
    assert cv2.imwrite(str(path), pixels[..., ::-1])
    photo = read_photo(path)
    grey = read_grey(photo)
    assert (photo.bits, grey.dtype) == (16, np.uint16)
    expected = pixels[..., 0] if channels == 1 else pixels @ [0.299, 0.587, 0.114]
    assert np.abs(grey - expected).max() <= 0.51
    colour = read_colour(photo)
    assert np.abs(colour - pixels / 256).max() <= 1


def test_transparency_palette_and_bilevel(tmp_path):
    image = Image.fromarray(scene())
    image.convert("RGBA").save(tmp_path / "a.png")
    image.convert("P").save(tmp_path / "p.png")
    image.convert("1").save(tmp_path / "b.tif")
    for photo in find_photos([tmp_path]).photos:
        assert read_grey(photo).shape == (400, 600)
        assert read_colour(photo).shape == (400, 600, 3)
    assert np.abs(read_grey(read_photo(tmp_path / "a.png")) - scene() @ [0.299, 0.587, 0.114]).max() < 1


def test_floating_point_pixels_become_16_bits(tmp_path):
    Image.fromarray(scene()[..., 0].astype(np.float32)).save(tmp_path / "thermal.tif")
    grey = read_grey(read_photo(tmp_path / "thermal.tif"))
    assert (grey.dtype, grey.min(), grey.max()) == (np.uint16, 0, 65535)


def test_damage_within_the_pixels_is_found_when_they_are_read(tmp_path):
    path = save(tmp_path / "a.png")
    photo = read_photo(path)
    data = bytearray(path.read_bytes())
    data[len(data) // 2] ^= 255
    path.write_bytes(data)
    with pytest.raises(InputError, match=r"a\.png.*photograph\.pixels_unreadable"):
        read_grey(photo)


def test_a_file_exchanged_during_the_work_is_noticed(tmp_path):
    photo = read_photo(save(tmp_path / "a.png"))
    save(tmp_path / "a.png", scene(300, 200))
    with pytest.raises(InputError, match=r"600.*400.*photograph\.size_changed"):
        read_grey(photo)


def test_a_long_tiff_is_mapped_not_read(tmp_path, monkeypatch):
    exif = Image.Exif()
    exif[0x0110] = "Body"
    path = save(tmp_path / "a.tif", exif=exif)
    monkeypatch.setattr("raybundle.io.photos.container.WHOLE_BYTES", 100)
    photo = read_photo(path)
    assert photo.metadata.model == "Body"
    assert np.array_equal(read_colour(photo), scene())


# ---- orientation


@pytest.mark.parametrize("orientation", range(1, 9))
def test_pixels_stay_as_stored_and_points_go_both_ways(tmp_path, orientation):
    from PIL import ImageOps

    exif = Image.Exif()
    exif[0x0112] = orientation
    path = save(tmp_path / "a.png", scene(60, 40), exif=exif)
    photo = read_photo(path)
    assert (photo.orientation, photo.width_px, photo.height_px) == (orientation, 60, 40)
    stored = read_colour(photo)
    assert np.array_equal(stored, scene(60, 40))
    with Image.open(path) as image:
        shown = np.asarray(ImageOps.exif_transpose(image))
    assert np.array_equal(upright(stored, orientation), shown)
    assert shown.shape[1::-1] == photo.upright_size
    xy = np.array([[0.5, 0.5], [59.5, 0.5], [17.5, 30.5]])
    there = upright_from_stored(xy, photo)
    columns, rows = np.floor(there).astype(int).T
    assert np.array_equal(shown[rows, columns], stored[np.floor(xy[:, 1]).astype(int), np.floor(xy[:, 0]).astype(int)])
    assert np.allclose(stored_from_upright(there, photo), xy)


# ---- extras


@pytest.mark.parametrize(
    ("name", "data", "module", "extra"),
    [("a.heic", b"\0\0\0\x18ftypheic", "pi_heif", "heic"), ("a.nef", b"MM\0*", "rawpy", "raw")],
)
def test_a_kind_that_needs_an_extra_names_it(tmp_path, monkeypatch, name, data, module, extra):
    import sys

    monkeypatch.setitem(sys.modules, module, None)
    (tmp_path / name).write_bytes(data.ljust(64, b"\0"))
    found = find_photos([tmp_path])
    assert found.photos == ()
    (made,) = reasons(found)[name].messages
    assert (made.code, made.values) == ("photograph.package_missing", {"extra": extra})


@pytest.mark.parametrize("orientation", [1, 3, 6, 8])
def test_heic_pixels_are_as_the_sensor_has_them(tmp_path, orientation):
    """The decoder turns the picture upright itself; that is undone."""
    pytest.importorskip("pi_heif", reason="needs the extra raybundle[heic]")
    (tmp_path / "a.heic").write_bytes(heic(orientation))
    photo = read_photo(tmp_path / "a.heic")
    assert (photo.orientation, photo.width_px, photo.height_px) == (orientation, 64, 48)
    assert np.abs(read_colour(photo).astype(int) - scene(64, 48)).mean() < 6  # turned the wrong way: above 50
    assert read_grey(photo).flags.c_contiguous


# ---- rubbish


@pytest.fixture(scope="module")
def small_files(tmp_path_factory):
    folder = tmp_path_factory.mktemp("small")
    exif = Image.Exif()
    exif[0x0112] = 6
    exif.get_ifd(0x8769)[0x920A] = 5.0
    return [save(folder / f"a.{s}", scene(40, 40), exif=exif).read_bytes() for s in ("jpg", "png", "tif", "webp")]


@settings(max_examples=300, deadline=None, suppress_health_check=[HealthCheck.function_scoped_fixture])
@given(
    which=st.integers(0, 3), cut=st.integers(0, 3000),
    changes=st.lists(st.tuples(st.integers(0, 400), st.integers(0, 255)), max_size=5),
)  # fmt: skip
def test_no_change_of_some_bytes_makes_the_reader_fail(small_files, tmp_path, which, cut, changes):
    data = bytearray(small_files[which])
    for at, value in changes:
        data[at % len(data)] = value
    path = tmp_path / "a.jpg"
    path.write_bytes(data[: len(data) - min(cut, len(data)) if cut % 2 else len(data)])
    try:
        photo = read_photo(path, limit_pixels=1_000_000)
        grey = read_grey(photo)
    except InputError:
        return
    assert grey.shape == (photo.height_px, photo.width_px)
    assert 1 <= photo.orientation <= 8


@pytest.mark.parametrize(
    ("name", "data", "hint"),
    [
        ("a.pgm", b"P5\n4 4\n255\n0123456789abcdef", r"photograph\.anymap"),
        ("a.jpg", b"P6\n4 4\n255\n0123456789abcdef", r"photograph\.anymap"),
        ("walk.mp4", b"\0\0\0\x18ftypmp42\0\0\0\0mp42isom", r"photograph\.video"),
        ("walk.jpg", b"\0\0\0\x18ftypisom\0\0\0\0mp42isom", r"photograph\.video"),
        ("walk.mkv", b"\x1aE\xdf\xa3" + bytes(40), r"photograph\.video"),
    ],
)
def test_what_comes_from_cameras_and_is_no_photograph_gets_a_hint(tmp_path, name, data, hint):
    path = tmp_path / name
    path.write_bytes(data)
    with pytest.raises(InputError, match=hint):
        read_photo(path)
    found = find_photos([tmp_path])
    assert not found.photos
    codes = [why.messages[0].code for _, why in found.refused]
    assert hint.replace("\\", "") in codes or words.headline(hint.replace("\\", ""), {}) in " ".join(found.remarks)


def test_of_equal_files_the_one_that_is_called_no_copy_stays(tmp_path):
    for name in ("DSC_7.JPG", "DSC_7 (1).JPG", "copy_of_7.JPG", "a.JPG"):
        save(tmp_path / name, scene(160, 120, seed=3 if name == "a.JPG" else 1))
    found = find_photos([tmp_path])
    assert [p.name for p in found.photos] == ["a.JPG", "DSC_7.JPG"]
    assert found.copies == {"DSC_7 (1).JPG": "DSC_7.JPG", "copy_of_7.JPG": "DSC_7.JPG"}
    (made,) = reasons(found)["copy_of_7.JPG"].messages
    assert (made.code, made.values) == ("photograph.copy", {"original": "DSC_7.JPG"})
