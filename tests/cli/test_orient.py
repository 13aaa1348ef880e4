"""`raybundle orient` and hostile input: a message, the right exit status, never a traceback."""

import json
import os
import shutil
import struct
import zlib
from pathlib import Path

import numpy as np
import pytest
from PIL import Image

from raybundle.cli.main import main
from raybundle.errors import code_of
from raybundle.io.photos.photo import find_photos
from raybundle.readable import readable
from raybundle.words import headline
from raybundle.workflows.orienting.stages.photographs import _beside

PORTAL = Path(__file__).resolve().parents[2] / "demo_data/portal/photos"
needs_portal = pytest.mark.skipif(
    not PORTAL.is_dir(), reason="demo_data/portal is part of the repository, not of the package"
)


def texture(seed, width=640, height=480, cells=16):
    """Blobs of every size that are seen nowhere else."""
    rng = np.random.default_rng(seed)
    total = np.zeros((height, width, 3))
    for size in (cells, 2 * cells, 5 * cells):
        small = rng.integers(0, 256, (height // size + 1, width // size + 1, 3), dtype=np.uint8)
        total += np.asarray(Image.fromarray(small).resize((width, height), Image.Resampling.BICUBIC))
    return (total / 3).astype(np.uint8)


def save(path, pixels):
    Image.fromarray(pixels).save(path, quality=92)
    return path


def png_header(width, height):
    chunk = b"IHDR" + struct.pack(">IIBBBBB", width, height, 8, 2, 0, 0, 0)
    return b"\x89PNG\r\n\x1a\n" + struct.pack(">I", 13) + chunk + struct.pack(">I", zlib.crc32(chunk))


class Told:
    """What a call of the command said."""

    def __init__(self, status, captured):
        self.status, self.out, self.err = status, captured.out, captured.err
        self.all = captured.out + captured.err
        assert "Traceback" not in self.all


@pytest.fixture
def orient(capsys, tmp_path):
    def call(*inputs, out=None, more=()):
        folder = tmp_path / "project" if out is None else out
        quick = ["--quick", "--no-report", "--feature-count", "500", "--jobs", "2"]
        status = main(["orient", *map(str, inputs), "--out", str(folder), "--verbose", *quick, *more])
        return Told(status, capsys.readouterr())

    return call


@pytest.fixture
def photos(tmp_path):
    folder = tmp_path / "photos"
    folder.mkdir()
    return folder


def some_of_the_portal(folder, numbers, names=None):
    names = names or [f"portal_{k:02d}.jpg" for k in numbers]
    for k, name in zip(numbers, names, strict=True):
        shutil.copy(PORTAL / f"portal_{k:02d}.jpg", folder / name)
    return names


@needs_portal
def test_every_bad_file_costs_that_file_and_is_named_with_its_reason(orient, photos, tmp_path):
    good = some_of_the_portal(
        photos, [1, 2, 3, 4], ["left 1.jpg", "Süd ä 雪.jpg", "  blank .JPG", "'quoted' & $x;.jpg"]
    )
    whole = (PORTAL / "portal_05.jpg").read_bytes()
    (photos / "truncated.jpg").write_bytes(whole[: len(whole) // 2])
    (photos / "zero.jpg").touch()
    (photos / "letter.jpg").write_text("dear diary, today I took no photograph")
    shutil.copy(PORTAL / "portal_02.jpg", photos / "twice.jpg")
    (photos / "bomb.png").write_bytes(png_header(60000, 60000) + b"\0\0\0\0IEND")
    save(photos / "thumbnail.jpg", texture(1, 160, 120, 4))
    save(photos / "something else.jpg", texture(2, 1600, 1200, 24))
    told = orient(photos)
    assert told.status == 0, told.all
    assert "4 of 5 photographs" in told.out
    assert "[photographs.not_usable]" in told.out
    result = json.loads((tmp_path / "project/result/result.json").read_text())
    lost = {entry["file"]: entry["reason"] for entry in result["images"]["not_oriented"]}
    assert (result["images"]["given"], result["images"]["oriented"]) == (11, 4)
    reasons = {
        "truncated.jpg": "truncated|incomplete|end",
        "zero.jpg": "empty",
        "letter.jpg": "image|photograph",
        "twice.jpg": "identical",
        "bomb.png": "megapixels",
        "thumbnail.jpg": "thumbnail",
        "something else.jpg": "in common with the others",
    }
    import re

    named = dict(lost)
    if "twice.jpg" not in named:  # of two equal files the first by name is taken
        named["twice.jpg"] = named.pop("Süd ä 雪.jpg")
    assert set(named) == set(reasons)
    for name, pattern in reasons.items():
        assert re.search(pattern, named[name]), (name, named[name])
    for name, reason in lost.items():
        assert f"{name}: {reason}" in " ".join(told.out.split())
    rows = (tmp_path / "project/result/images.csv").read_text(encoding="utf-8")
    assert sum(readable(name) in rows for name in good) >= 3


@needs_portal
def test_two_photographs_are_enough(orient, photos):
    some_of_the_portal(photos, [2, 3])
    told = orient(photos)
    assert told.status == 0, told.all
    assert "2 of 2 photographs" in told.out


@needs_portal
def test_one_photograph_is_not(orient, photos):
    some_of_the_portal(photos, [2])
    told = orient(photos)
    assert told.status == 2
    assert "[photograph.too_few_usable]" in told.err


@needs_portal
def test_the_same_photograph_again_and_again_is_one(orient, photos):
    some_of_the_portal(photos, [2, 2, 2], ["a.jpg", "b.jpg", "c.jpg"])
    told = orient(photos)
    assert told.status == 2
    assert "[photograph.too_few_usable]" in told.err
    assert "b.jpg: " in told.err


def test_an_empty_folder_and_a_folder_of_other_things(orient, photos):
    assert orient(photos).status == 2
    (photos / "notes.txt").write_text("nothing")
    (photos / "zero.jpg").touch()
    told = orient(photos)
    assert told.status == 2
    assert "0 usable photographs" in told.err
    assert "zero.jpg: " in told.err


def test_a_missing_folder_is_named(orient, tmp_path):
    told = orient(tmp_path / "nowhere")
    assert told.status == 2
    assert "[file.missing]" in told.err


def test_photographs_of_different_things_say_what_to_do(orient, photos, tmp_path):
    for k in range(3):
        save(photos / f"{k}.jpg", texture(10 + k))
    told = orient(photos)
    assert told.status == 3
    assert "[tie_points.too_few_common]" in told.err
    assert "[tie_points.too_few_common]" in told.err
    assert not (tmp_path / "project/result").exists()


def test_photographs_without_texture(orient, photos):
    for k in range(3):
        save(photos / f"{k}.png", np.full((480, 640, 3), 100 + k, np.uint8))
    told = orient(photos)
    assert told.status == 3
    assert "[tie_points.too_few_common]" in told.err


def test_windows_of_one_picture_are_not_oriented_without_a_word(orient, photos, tmp_path):
    """As a camera sees a plane along which it moves: the camera constant cannot be told from the distance."""
    scene = texture(20, 1400, 1000)
    for k in range(4):
        save(photos / f"{k}.jpg", scene[60 * k : 60 * k + 480, 90 * k : 90 * k + 640])
    told = orient(photos)
    if told.status == 0:
        found = json.loads((tmp_path / "project/result/result.json").read_text())["warnings"]
        assert "held_not_determinable" in {w["code"] for w in found}
        assert "[held_not_determinable" in told.out
    else:
        assert told.status == 3, told.all
        assert told.err.strip()


def test_a_photograph_with_noise_added_has_no_base(orient, photos):
    rng, scene = np.random.default_rng(1), texture(21).astype(int)
    for k in range(3):
        save(photos / f"{k}.png", np.clip(scene + rng.normal(0, 2, scene.shape), 0, 255).astype(np.uint8))
    told = orient(photos)
    assert told.status == 3, told.all


def test_the_result_is_not_written_into_something_else(orient, photos, tmp_path):
    for k in range(2):
        save(photos / f"{k}.jpg", texture(k))
    file = tmp_path / "file"
    file.write_text("a letter")
    told = orient(photos, out=file)
    assert told.status == 2
    assert file.read_text() == "a letter"
    full = tmp_path / "full"
    full.mkdir()
    (full / "letter.txt").write_text("dear")
    told = orient(photos, out=full)
    assert told.status == 2
    assert "[project.folder_not_empty]" in told.err
    assert [p.name for p in full.iterdir()] == ["letter.txt"]
    told = orient(photos, out=photos)
    assert told.status == 2
    assert sorted(p.name for p in photos.iterdir()) == ["0.jpg", "1.jpg"]


@pytest.mark.skipif(not hasattr(os, "geteuid") or os.geteuid() == 0, reason="nothing is read-only for root")
def test_a_read_only_place_is_named(orient, photos, tmp_path):
    place = tmp_path / "locked"
    place.mkdir(mode=0o500)
    told = orient(photos, out=place / "project")
    assert told.status == 2
    assert "[file.not_writable]" in told.err


@pytest.mark.parametrize(
    "more",
    [
        ["--calibration", "nowhere.toml"],
        ["--control", "nowhere.csv"],
        ["--features", "unknown"],
        ["--from-stage", "nothing"],
        ["--scale-bar", "A", "B", "long", "0.1"],
        ["--feature-count", "3"],
    ],
)
def test_a_wrong_option_is_named(orient, photos, more):
    told = orient(photos, more=more)
    assert told.status == 2
    assert more[1] in told.err or more[0] in told.err


def test_a_bar_of_negative_length_is_refused_before_anything_is_done(orient, photos, tmp_path):
    told = orient(photos, more=["--scale-bar", "A", "B", "-24", "0.01"])
    assert told.status == 2
    assert "'--scale-bar': -24.0 " in told.err
    assert "x>0" in told.err
    assert not (tmp_path / "project").exists()


def test_a_damaged_project_is_named(orient, photos, tmp_path):
    for k in range(2):
        save(photos / f"{k}.jpg", texture(k))
    out = tmp_path / "project"
    out.mkdir()
    (out / "project.db").write_bytes(b"no database " * 600)
    told = orient(photos)
    assert told.status == 2
    assert "project.db" in told.err


def test_status_of_something_else_is_an_error_and_makes_nothing(capsys, tmp_path):
    for folder in (tmp_path, tmp_path / "nowhere"):
        status = main(["status", str(folder)])
        assert status == 2
        assert "[project.no_database]" in capsys.readouterr().err
    assert list(tmp_path.iterdir()) == []


def test_status_of_a_run_that_failed_shows_what_is_done(orient, photos, tmp_path, capsys):
    for k in range(3):
        save(photos / f"{k}.jpg", texture(30 + k))
    assert orient(photos).status == 3
    assert main(["status", str(tmp_path / "project")]) == 0
    lines = {line.split()[0]: line for line in capsys.readouterr().out.splitlines()}
    assert headline("stage_summary.matching", {"pairs": 3, "skipped": 0, "verified": 0}) in lines["matching"]
    assert "not done" in lines["start"]


def test_a_control_file_in_the_folder_is_no_other_file(tmp_path):
    """Called by another name of the folder, too; what is used is not counted among what is not looked at."""
    folder = tmp_path / "photos"
    folder.mkdir()
    for name in ("gcp.csv", "notes.txt"):
        (folder / name).write_text("name\n")
    save(folder / "a.jpg", texture(1))
    (tmp_path / "link").symlink_to(folder)
    used = _beside([folder], [tmp_path / "link" / "gcp.csv", tmp_path / "elsewhere.csv"])
    assert used == [folder / "gcp.csv"]
    (remark,) = [r for r in find_photos([folder], leave=used).remarks if code_of(r) == "photo_entry.other_files"]
    assert "(.txt)" in remark
