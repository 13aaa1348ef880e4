"""Frames of a video: which are taken, what is written with them, what the container says."""

import csv
import struct
from datetime import UTC, datetime

import cv2
import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from tests.cli.reported import reported, values_of
from tests.messages import coded

from raybundle.cli.main import main
from raybundle.errors import InputError
from raybundle.io.photos.cameras import camera_groups
from raybundle.io.photos.movie import read_movie_metadata
from raybundle.io.photos.photo import find_photos, read_photo
from raybundle.io.photos.video import FrameOptions, analyse, choose, extract_frames

RATE = 10


def panorama():
    rng = np.random.default_rng(4)
    image = np.zeros((260, 1500, 3), np.float32)
    for cell in (4, 12, 40):
        coarse = rng.uniform(0, 255, (260 // cell + 2, 1500 // cell + 2, 3)).astype(np.float32)
        image += cv2.resize(coarse, (1500, 260), interpolation=cv2.INTER_CUBIC) / 3
    return np.clip(image, 0, 255).astype(np.uint8)


def shift_of(k):
    """The view stands still for 20 frames, then moves by 6 px a frame."""
    return 0 if k < 20 else 6 * (k - 20)


@pytest.fixture(scope="module")
def video(tmp_path_factory):
    """80 frames of 400 x 240 px; two of three moving frames are blurred."""
    path = tmp_path_factory.mktemp("video") / "a walk.mp4"
    writer = cv2.VideoWriter(str(path), cv2.VideoWriter_fourcc(*"mp4v"), RATE, (400, 240))
    wide = panorama()
    for k in range(80):
        frame = wide[10:250, shift_of(k) : shift_of(k) + 400]
        if k >= 20 and k % 3:
            frame = cv2.GaussianBlur(frame, (9, 9), 2.5)
        writer.write(np.ascontiguousarray(frame))
    writer.release()
    return path


def test_motion_and_sharpness_are_measured(video):
    a = analyse(video)
    assert (len(a.time_s), a.width_px, a.height_px, a.rotation_deg) == (80, 400, 240, 0)
    assert a.motion[17] < 0.01
    assert a.motion[-1] == pytest.approx(6 * 60 / 400, rel=0.05)
    moving = np.arange(20, 80)
    sharp = moving % 3 == 0
    assert a.sharpness[moving][sharp].min() > 1.2 * a.sharpness[moving][~sharp].max()


def test_by_motion_the_sharp_frames_are_taken_and_none_while_the_view_stands(video, tmp_path):
    frames = extract_frames(video, tmp_path / "out", FrameOptions(motion=0.1))
    assert 8 <= len(frames.frames) <= 10
    assert sum(k < 19 for k in frames.frames) <= 1
    assert all(k % 3 == 0 for k in frames.frames if k >= 20)
    steps = np.diff([shift_of(k) for k in frames.frames])
    assert steps.min() > 0.05 * 400
    assert steps.max() < 0.16 * 400


def test_a_number_of_frames(video, tmp_path):
    frames = extract_frames(video, tmp_path / "out", FrameOptions(count=6))
    assert len(frames.files) == 6
    assert [f.name for f in frames.files] == [f"a walk_{k:02d}.jpg" for k in frames.frames]
    with (tmp_path / "out" / "frames.csv").open(newline="") as file:
        rows = list(csv.DictReader(file))
    assert [int(r["frame"]) for r in rows] == list(frames.frames)


def test_by_time_what_shows_the_same_is_left_out(video):
    chosen, remarks = choose(analyse(video), FrameOptions(every_s=0.5))
    assert sum(k < 20 for k in chosen) == 1
    assert len(chosen) >= 12
    assert coded(remarks)["video.same_frames"]["n"] > 0


def test_the_photographs_are_photographs(video, tmp_path):
    frames = extract_frames(video, tmp_path / "out", FrameOptions(count=3))
    found = find_photos([tmp_path / "out"])
    assert len(found.photos) == 3
    assert len(camera_groups(found.photos)) == 1
    pixels = cv2.imread(str(frames.files[1]))
    expected = panorama()[10:250, shift_of(frames.frames[1]) : shift_of(frames.frames[1]) + 400]
    assert np.abs(pixels.astype(float) - expected).mean() < 8  # 25 for a neighbouring frame


def test_a_view_that_never_moves_is_remarked(tmp_path):
    path = tmp_path / "still.avi"
    writer = cv2.VideoWriter(str(path), cv2.VideoWriter_fourcc(*"MJPG"), RATE, (400, 240))
    for _ in range(12):
        writer.write(np.ascontiguousarray(panorama()[:240, :400]))
    writer.release()
    frames = extract_frames(path, tmp_path / "out")
    assert len(frames.files) == 1
    assert "hardly moves" in frames.remarks[0]


def test_what_is_no_video_is_said(tmp_path, video):
    (tmp_path / "text.mp4").write_text("no video")
    with pytest.raises(InputError, match=r"video\.not_decoded"):
        extract_frames(tmp_path / "text.mp4", tmp_path / "out")
    with pytest.raises(InputError, match=r"file\.missing"):
        extract_frames(tmp_path / "none.mp4", tmp_path / "out")
    assert not (tmp_path / "out").exists()
    (tmp_path / "full").mkdir()
    (tmp_path / "full" / "a").touch()
    with pytest.raises(InputError, match=r"folder\.exists"):
        extract_frames(video, tmp_path / "full")
    with pytest.raises(InputError, match=r"video\.count_and_time"):
        extract_frames(video, tmp_path / "out", FrameOptions(count=3, every_s=1))


def test_command_line(video, tmp_path, capsys):
    if main(["frames", "--help"]) == 2:
        pytest.skip("the command is not registered")
    capsys.readouterr()
    found = reported(capsys, "frames", video, "--out", tmp_path / "out", "--count", 4)
    frames = values_of(found, ["summary"])["video.frames"]
    assert frames.pop("seconds") == pytest.approx(7.9)
    assert frames == {"n": 4, "of": 80, "width_px": 400, "height_px": 240}
    assert main(["frames", str(video), "--out", str(tmp_path / "out")]) == 2


# ---- the container


def box(kind, *bodies):
    body = b"".join(bodies)
    return struct.pack(">I", 8 + len(body)) + kind + body


def movie(metadata, creation=3_800_000_000):
    header = box(b"mvhd", b"\0\0\0\0" + struct.pack(">II", creation, creation) + b"\0" * 90)
    return box(b"ftyp", b"qt  \0\0\0\0") + box(b"moov", header, metadata)


def keyed(entries):
    keys = b"".join(box(b"mdta", k.encode()) for k in entries)
    items = b"".join(
        box(struct.pack(">I", n), box(b"data", struct.pack(">II", code, 0), raw))
        for n, (code, raw) in enumerate(entries.values(), 1)
    )
    handler = box(b"hdlr", b"\0" * 8 + b"mdta" + b"\0" * 13)
    return box(b"meta", handler, box(b"keys", struct.pack(">II", 0, len(entries)), keys), box(b"ilst", items))


PHONE = keyed({
    "com.apple.quicktime.make": (1, b"Apple"),
    "com.apple.quicktime.model": (1, b"iPhone 15"),
    "com.apple.quicktime.location.ISO6709": (1, b"-33.8568+151.2153+012.5/"),
    "com.apple.quicktime.camera.focal_length.35mm_equivalent": (21, struct.pack(">i", 26)),
})  # fmt: skip


def test_a_phone_says_make_model_place_and_focal_length(tmp_path):
    (tmp_path / "a.mov").write_bytes(movie(PHONE))
    m = read_movie_metadata(tmp_path / "a.mov")
    assert (m.make, m.model, m.focal35_mm, m.position) == ("Apple", "iPhone 15", 26.0, (-33.8568, 151.2153, 12.5))
    assert m.start == datetime(2024, 5, 31, 11, 33, 20, tzinfo=UTC)


def test_user_data_of_a_camera(tmp_path):
    texts = {b"\xa9mak": b"Maker", b"\xa9mod": b"Action 7", b"\xa9xyz": b"+47.5+008.25/"}
    atoms = [box(k, struct.pack(">HH", len(v), 0), v) for k, v in texts.items()]
    (tmp_path / "a.mp4").write_bytes(movie(box(b"udta", *atoms), creation=0))
    m = read_movie_metadata(tmp_path / "a.mp4")
    assert (m.make, m.model, m.position, m.start) == ("Maker", "Action 7", (47.5, 8.25, None), None)


def test_the_container_reaches_the_photographs(video, tmp_path):
    """A movie box of the same size as the one that is there would disturb the offsets; so it stands at the end."""
    path = tmp_path / "phone.mp4"
    data = video.read_bytes()
    at = data.index(b"moov") - 4
    length = struct.unpack_from(">I", data, at)[0]
    assert at + length == len(data)
    path.write_bytes(data[:at] + struct.pack(">I", length + len(PHONE)) + data[at + 4 :] + PHONE)
    frames = extract_frames(path, tmp_path / "out", FrameOptions(count=2))
    photo = read_photo(frames.files[0])
    m = photo.metadata
    assert (m.make, m.model, m.focal35_mm) == ("Apple", "iPhone 15", 26)
    assert m.gps.latitude_deg == pytest.approx(-33.8568)
    assert m.gps.altitude_m == 12.5
    (group,) = camera_groups([photo])
    assert group.source == "35 mm equivalent"


@settings(max_examples=100, deadline=None)
@given(changes=st.lists(st.tuples(st.integers(0, 2000), st.integers(0, 255)), max_size=6), cut=st.integers(0, 600))
def test_no_container_makes_the_reader_fail(tmp_path_factory, changes, cut):
    data = bytearray(movie(PHONE))
    for at, value in changes:
        data[at % len(data)] = value
    path = tmp_path_factory.getbasetemp() / "fuzz.mov"
    path.write_bytes(data[: len(data) - cut])
    read_movie_metadata(path)
