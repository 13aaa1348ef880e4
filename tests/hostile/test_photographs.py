"""Photographs as they should not be: handled as their user would hope, with a message, never with a traceback."""

import errno
import json
import os
import re
import shutil
import subprocess
import sys
import zlib
from pathlib import Path

import numpy as np
import pytest
from PIL import Image

from raybundle.cli.main import main
from raybundle.errors import InputError
from raybundle.io.photos.photo import read_photo
from raybundle.pipeline.project import Project
from raybundle.words import headline

resource = pytest.importorskip("resource", reason="there are no limits of a process here")
ROOT = Path(__file__).resolve().parents[2]
PORTAL = ROOT / "demo_data/portal/photos"
pytestmark = pytest.mark.skipif(
    not PORTAL.is_dir(), reason="demo_data/portal is part of the repository, not of the package"
)
QUICK = ["--quick", "--no-report", "--feature-count", "600", "--jobs", "2"]


@pytest.fixture(scope="module")
def half(tmp_path_factory):
    """Five photographs of half the size."""
    folder = tmp_path_factory.mktemp("half")
    for k in range(1, 6):
        with Image.open(PORTAL / f"portal_{k:02d}.jpg") as image:
            image.reduce(2).save(folder / f"{k}.jpg", quality=92, exif=image.info["exif"])
    return folder


@pytest.fixture
def photos(half, tmp_path):
    return Path(shutil.copytree(half, tmp_path / "photos"))


class Told:
    def __init__(self, status, out, err):
        self.status, self.out, self.err, self.all = status, out, err, out + err
        assert "Traceback" not in self.all
        assert "internal error" not in self.all


@pytest.fixture
def orient(capsys, tmp_path):
    def call(*inputs, out="project", options=QUICK):
        status = main(["orient", *map(str, inputs), "--out", str(tmp_path / out), "--verbose", *options])
        told = capsys.readouterr()
        return Told(status, told.out, told.err)

    return call


def apart(photos, out, *before, preexec_fn=None):
    """The same in a process of its own, perhaps within another command."""
    call = [*before, sys.executable, "-m", "raybundle", "orient", str(photos), "--out", str(out), "--verbose", *QUICK]
    done = subprocess.run(call, capture_output=True, text=True, check=False, preexec_fn=preexec_fn)
    return Told(done.returncode, done.stdout, done.stderr)


def texture(seed, width, height):
    """Blobs of many sizes that are seen nowhere else."""
    rng = np.random.default_rng(seed)
    total = np.zeros((height, width, 3))
    for size in (6, 14, 40, 110):
        small = rng.integers(0, 256, (height // size + 1, width // size + 1, 3), dtype=np.uint8)
        total += np.asarray(Image.fromarray(small).resize((width, height), Image.Resampling.BICUBIC))
    return (total / 4).astype(np.uint8)


def turned(picture, c, pan, tilt, roll):
    """What a camera that only turns sees of a far picture, 640 x 480 px."""
    (sp, cp), (st, ct), (sr, cr) = ((np.sin(a), np.cos(a)) for a in (pan, tilt, roll))
    R = np.array([[cp, 0, sp], [0, 1, 0], [-sp, 0, cp]]) @ np.array([[1, 0, 0], [0, ct, -st], [0, st, ct]])
    R = R @ np.array([[cr, -sr, 0], [sr, cr, 0], [0, 0, 1]])
    height, width = picture.shape[:2]
    far = np.array([[c, 0, width / 2], [0, c, height / 2], [0, 0, 1]])
    near = np.array([[c, 0, 320], [0, c, 240], [0, 0, 1]])
    H = far @ R @ np.linalg.inv(near)
    H /= H[2, 2]
    image = Image.fromarray(picture)
    return image.transform((640, 480), Image.Transform.PERSPECTIVE, H.ravel()[:8], Image.Resampling.BICUBIC)


TURNS = ((-0.25, 0, 0), (-0.1, 0.08, 0.02), (0.05, -0.05, 0.04), (0.2, 0.03, 0.06), (0.3, 0.1, 0.08))


@pytest.mark.parametrize("distorted", [False, True])
def test_photographs_from_one_spot_are_told_so(orient, tmp_path, distorted):
    folder = tmp_path / "spot"
    folder.mkdir()
    picture = texture(5, 1600, 1200)
    rng = np.random.default_rng(1)
    for k, angles in enumerate(TURNS):
        pixels = np.asarray(turned(picture, 700.0, *angles)).astype(float)
        if distorted:  # a barrel of 4 px in the corners
            x, y = np.meshgrid(np.arange(640) - 319.5, np.arange(480) - 239.5)
            s = 1 + 4 / 400 * (x**2 + y**2) / 400**2
            rows, columns = np.clip((y * s + 239.5).round(), 0, 479), np.clip((x * s + 319.5).round(), 0, 639)
            pixels = pixels[rows.astype(int), columns.astype(int)]
        noisy = np.clip(pixels + rng.normal(0, 3, pixels.shape), 0, 255).astype(np.uint8)
        Image.fromarray(noisy).save(folder / f"{k}.png")
    outcome = orient(folder)
    assert outcome.status == 3, outcome.all
    assert "[tie_points.no_base]" in outcome.err
    assert "[tie_points.no_base]" in outcome.err
    assert not (tmp_path / "project/result").exists()


def test_copies_of_one_photograph_have_no_base(orient, half, tmp_path):
    folder = tmp_path / "burst"
    folder.mkdir()
    with Image.open(half / "2.jpg") as image:
        for quality in (70, 80, 90):
            image.save(folder / f"{quality}.jpg", quality=quality, exif=image.info["exif"])
    outcome = orient(folder)
    assert outcome.status == 3, outcome.all
    assert "[tie_points.no_base]" in outcome.err


def test_a_photograph_beside_its_copy_of_another_quality_does_not_hinder_the_others(orient, photos):
    with Image.open(photos / "2.jpg") as image:
        image.save(photos / "2 copy.jpg", quality=70, exif=image.info["exif"])
    outcome = orient(photos)
    assert outcome.status == 0, outcome.all
    assert "6 of 6 photographs" in outcome.out or "2 copy.jpg: " in outcome.out


def cameras_of(tmp_path):
    return json.loads((tmp_path / "project/result/result.json").read_text())["cameras"]


def test_two_cameras_are_two(orient, photos, tmp_path):
    for k in (4, 5):
        with Image.open(photos / f"{k}.jpg") as image:
            exif = image.getexif()
            exif[0x0110] = "another 18"
            image.resize((640, 480), Image.Resampling.LANCZOS).save(
                photos / f"{k}.jpg", quality=92, exif=exif.tobytes()
            )
    outcome = orient(photos)
    assert outcome.status == 0, outcome.all
    assert "5 of 5 photographs" in outcome.out
    assert len(cameras_of(tmp_path)) == 2


def line_of(printed, part):
    """The line that contains a part."""
    return next(line for line in printed.splitlines() if part in line)


def test_photographs_turned_by_a_program_are_oriented_and_told_of(orient, photos, tmp_path, capsys):
    for k in (2, 4):
        with Image.open(photos / f"{k}.jpg") as image:
            image.transpose(Image.Transpose.ROTATE_90).save(photos / f"{k}.jpg", quality=92, exif=image.info["exif"])
    outcome = orient(photos)
    assert outcome.status == 0, outcome.all
    assert "5 of 5 photographs" in outcome.out
    assert "2.jpg, 4.jpg." in line_of(outcome.out, "[stored_turned]")
    assert len(cameras_of(tmp_path)) == 1
    # other programs get the files as they are stored
    out = tmp_path / "colmap"
    assert (
        main(
            [
                "convert",
                str(tmp_path / "project/result"),
                "--to",
                "colmap",
                "--out",
                str(out),
                "--verbose",
                "--approximate",
            ]
        )
        == 0
    )
    written = capsys.readouterr().out
    fitted = {"camera": "", "model": "", "largest_px": 0.0}
    begin, end = headline("conversion.camera_fitted", fitted).split("  ", 1)[0], " "
    one, other = re.findall(rf"{begin} (\S+){end}", written)
    # the simulated lens is the same turned by half: which of both it is, is stated as doubtful
    assert one == "virtual-24-24mm"
    assert other in {f"virtual-24-24mm-600x800-turned{turn}" for turn in (90, 270)}
    assert "[camera_joined.doubtful]" in outcome.out


def test_copies_at_half_the_size_share_the_camera_of_the_others(orient, photos, tmp_path):
    for k in (2, 4):
        with Image.open(photos / f"{k}.jpg") as image:
            image.reduce(2).save(photos / f"{k}.jpg", quality=95, exif=image.info["exif"])
    # by few quick points of 120 000 pixels the interior orientation is not outcome well enough to decide
    outcome = orient(photos, options=["--no-report", "--jobs", "2"])
    assert outcome.status == 0, outcome.all
    assert "5 of 5 photographs" in outcome.out
    assert "2.jpg, 4.jpg." in line_of(outcome.out, "[stored_turned.size]")
    assert len(cameras_of(tmp_path)) == 1


def test_a_lens_that_one_photograph_leaves_out_makes_no_second_camera(orient, photos, tmp_path):
    with Image.open(photos / "3.jpg") as image:
        exif = image.getexif()
        del exif.get_ifd(0x8769)[0xA434]
        image.save(photos / "3.jpg", quality=92, exif=exif.tobytes())
    outcome = orient(photos)
    assert outcome.status == 0, outcome.all
    assert "3.jpg" in outcome.out
    assert "Virtual 24 mm" in outcome.out
    assert len(cameras_of(tmp_path)) == 1


def test_photographs_taken_upright_share_the_camera_of_the_others(orient, photos, tmp_path):
    for k, orientation in ((2, 6), (4, 8)):
        with Image.open(photos / f"{k}.jpg") as image:
            exif = image.getexif()
            exif[0x0112] = orientation  # as a viewer would turn it; the pixels stay as the sensor has them
            image.save(photos / f"{k}.jpg", quality=92, exif=exif.tobytes())
    outcome = orient(photos)
    assert outcome.status == 0, outcome.all
    assert "5 of 5 photographs" in outcome.out
    assert len(cameras_of(tmp_path)) == 1


@pytest.mark.skipif(os.name == "nt", reason="names are Unicode there")
def test_names_that_are_no_utf8_are_shown_and_written(orient, half, tmp_path):
    folder = tmp_path / "Süd 雪 'x' $y"
    folder.mkdir()
    for k in range(1, 5):
        shutil.copy(half / f"{k}.jpg", os.fsencode(folder) + b"/bad\xff %d.jpg" % k)
    shutil.copy(half / "1.jpg", os.fsencode(folder) + b"/twice\xfe.jpg")
    outcome = orient(folder, out="Süd 雪 'x'/project;")
    assert outcome.status == 0, outcome.all
    first, third = (rf"bad\xff {k}.jpg" for k in (1, 3))
    assert first in line_of(outcome.out, r"twice\xfe.jpg:")
    rows = (tmp_path / "Süd 雪 'x'/project;/result/images.csv").read_text(encoding="utf-8")
    assert third in rows
    outcome = orient(folder, out=os.fsdecode(b"project\xff"))
    assert outcome.status == 2
    assert "[file.name_not_utf8]" in outcome.err


def png(width, height, rows):
    """A file of zeros, of which only some rows are there."""
    data = zlib.compress(bytes((1 + 3 * width) * rows), 9)

    def chunk(name, content):
        return len(content).to_bytes(4, "big") + name + content + zlib.crc32(name + content).to_bytes(4, "big")

    header = width.to_bytes(4, "big") + height.to_bytes(4, "big") + bytes([8, 2, 0, 0, 0])
    return b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", header) + chunk(b"IDAT", data) + chunk(b"IEND", b"")


@pytest.mark.skipif(sys.platform == "win32", reason="no limit of memory there")
def test_a_bomb_is_not_decoded(photos, tmp_path):
    (photos / "bomb.png").write_bytes(png(30_000, 30_000, 40))
    limit = 3 << 30  # of addresses, of which numerical libraries reserve a lot; the pixels alone need 2.7 GB

    def bounded():
        resource.setrlimit(resource.RLIMIT_AS, (limit, limit))

    outcome = apart(photos, tmp_path / "project", preexec_fn=bounded)
    assert outcome.status == 0, outcome.all
    assert re.search("bomb.png: .* 900 .*600", outcome.out)
    assert "5 of 5 photographs" in outcome.out


def test_a_bomb_below_the_limit_is_not_decoded_either(tmp_path):
    path = tmp_path / "bomb.png"
    path.write_bytes(png(6_000, 6_000, 6_000))
    with pytest.raises(InputError, match=r"photograph\.no_content"):
        read_photo(path)


def test_a_file_damaged_in_its_middle_costs_that_file(orient, photos):
    Image.fromarray(texture(3, 800, 600)).save(photos / "damaged.png")
    data = bytearray((photos / "damaged.png").read_bytes())
    data[9000:9400] = bytes(400)
    (photos / "damaged.png").write_bytes(data)
    outcome = orient(photos)
    assert outcome.status == 0, outcome.all
    assert "5 of 5 photographs" in outcome.out
    assert "damaged.png: " in outcome.out


def test_a_photograph_that_goes_away_during_the_work_is_named(orient, photos, monkeypatch):
    from raybundle.workflows.orienting.stages import photographs as stage

    original = stage.find_photos

    def found(*arguments, **options):
        result = original(*arguments, **options)
        (photos / "5.jpg").unlink()
        return result

    monkeypatch.setattr(stage, "find_photos", found)
    outcome = orient(photos)
    assert outcome.status == 0, outcome.all
    assert "4 of 4 photographs" in outcome.out
    assert "5.jpg: " in outcome.out


def in_a_namespace():
    """Whether a mount of one's own can be made here."""
    if not shutil.which("unshare"):
        return False
    done = subprocess.run(["unshare", "-rm", "mount", "-t", "tmpfs", "t", "/tmp"], capture_output=True, check=False)  # noqa: S108
    return done.returncode == 0


needs_mounts = pytest.mark.skipif(not in_a_namespace(), reason="a disk cannot be mounted here")


@pytest.mark.long
@needs_mounts
@pytest.mark.parametrize("size", ["100k", "450k"])
def test_a_full_disk_is_named_and_what_is_finished_is_kept(photos, tmp_path, size):
    """100 kB end while the database is begun, 450 kB within the features."""
    out = tmp_path / "project"
    out.mkdir()
    kept = tmp_path / "kept"
    script = f'mount -t tmpfs -o size={size} t "$0" && "$@"; status=$?; cp -r "$0" {kept}; exit $status'
    outcome = apart(photos, out, "unshare", "-rm", "bash", "-c", script, str(out))
    assert outcome.status == 2, outcome.all
    assert f"error: {out}: " in outcome.err
    assert "[project.not_writable]" in outcome.err
    assert not (kept / "result").exists()
    assert not [p for p in kept.rglob(".*") if p.is_file()]
    products = {p.name: p.stat().st_mtime_ns for p in kept.glob("cache/*/*.npz")}
    assert (0 < len(products) < 5) if size == "450k" else not products
    if products:
        outcome = apart(photos, kept)
        assert outcome.status == 0, outcome.all
        assert "5 of 5 photographs" in outcome.out
        assert {p.name: p.stat().st_mtime_ns for p in kept.glob("cache/*/*.npz")}.items() > products.items()


def test_a_disk_that_fills_while_the_result_is_written_keeps_the_old_one(orient, photos, tmp_path, monkeypatch):
    from raybundle.results import folder as result_folder

    assert orient(photos).status == 0
    before = {p.name: p.read_bytes() for p in (tmp_path / "project/result").glob("*.csv")}

    def full(*_, **__):
        raise OSError(errno.ENOSPC, os.strerror(errno.ENOSPC))

    monkeypatch.setattr(result_folder, "write_table", full)
    outcome = orient(photos)
    assert outcome.status == 2
    assert f"({os.strerror(errno.ENOSPC)})" in outcome.err
    assert "[file.not_writable]" in outcome.err
    assert {p.name: p.read_bytes() for p in (tmp_path / "project/result").glob("*.csv")} == before
    assert not list((tmp_path / "project").glob(".*"))


@needs_mounts
def test_a_read_only_folder_is_named_and_can_be_looked_at(photos, tmp_path):
    out = tmp_path / "project"
    Project.open(out).close()
    (out / "result").mkdir()
    script = 'mount --bind "$0" "$0" && mount -o remount,ro,bind "$0" && "$@"'
    outcome = apart(photos, out, "unshare", "-rm", "bash", "-c", script, str(out))
    assert outcome.status == 2, outcome.all
    assert f"{out}/result: " in outcome.err
    assert "[file.not_writable]" in outcome.err
    look = [sys.executable, "-m", "raybundle", "status", str(out)]
    done = subprocess.run(["unshare", "-rm", "bash", "-c", script, str(out), *look], capture_output=True, check=False)
    assert (done.returncode, done.stderr) == (0, b"")


@pytest.mark.parametrize("limit", [20_000, 60_000])
def test_a_limit_of_file_sizes_is_named(photos, tmp_path, limit):
    def bounded():
        resource.setrlimit(resource.RLIMIT_FSIZE, (limit, limit))

    outcome = apart(photos, tmp_path / "project", preexec_fn=bounded)
    assert outcome.status == 2, outcome.all
    assert "[project.not_writable]" in outcome.err
    assert "Choose a" in outcome.err
