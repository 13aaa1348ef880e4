"""From photographs to an oriented block: right, stopped and continued, added to, done again."""

import csv
import json
import re
import shutil
from collections import Counter
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from raybundle.cli.main import main
from raybundle.io.block.folder import read_block
from raybundle.io.cameras.library import LibraryEntry, add_entry, key_of
from raybundle.io.photos.cameras import camera_groups, camera_of
from raybundle.io.photos.photo import find_photos
from raybundle.pipeline.project import Project
from raybundle.ties import points as tie_points
from raybundle.workflows.orient import OrientOptions, orient
from raybundle.workflows.orienting.stages import matching

PORTAL = Path(__file__).resolve().parents[2] / "demo_data/portal"
pytestmark = pytest.mark.skipif(
    not PORTAL.is_dir(), reason="demo_data/portal is part of the repository, not of the package"
)
NAMES = [f"portal_{k:02d}.jpg" for k in (1, 2, 3, 4, 5)]
COUNT = 800
QUICK = OrientOptions(feature_count=COUNT, precise=False, jobs=2)


def command(photos, out, *more):
    return [
        "orient",
        str(photos),
        "--out",
        str(out),
        "--feature-count",
        str(COUNT),
        "--jobs",
        "2",
        "--no-report",
        *more,
    ]


def numbers(project):
    """result.json without what a clock or the cache says."""
    result = json.loads((project / "result/result.json").read_text())
    for name in ("seconds", "stages"):
        del result[name]
    return result


def stages(project):
    return {s["name"]: s for s in json.loads((project / "result/result.json").read_text())["stages"]}


def tables(project):
    return {p.name: p.read_text() for p in sorted((project / "result").glob("*.csv"))}


@pytest.fixture(scope="module")
def photos(tmp_path_factory):
    folder = tmp_path_factory.mktemp("photos")
    for name in NAMES:
        shutil.copy(PORTAL / "photos" / name, folder)
    return folder


@pytest.fixture(scope="module")
def done(photos, tmp_path_factory):
    """One uninterrupted run."""
    out = tmp_path_factory.mktemp("orient") / "project"
    assert main(command(photos, out)) == 0
    return out


@pytest.fixture
def project(done, tmp_path):
    """A copy of the finished project."""
    return Path(shutil.copytree(done, tmp_path / done.name))


def test_the_result_says_what_the_format_asks_for(done):
    result = json.loads((done / "result/result.json").read_text())
    assert result["images"] == {"given": 5, "oriented": 5, "not_oriented": []}
    assert result["components"] == 1
    assert [s["name"] for s in result["stages"]] == [
        "photographs", "features", "matching", "start", "precision", "adjustment"
    ]  # fmt: skip
    for s in result["stages"]:
        assert set(s) == {"name", "seconds", "cpu_seconds", "peak_memory_mb", "from_cache"}
        assert s["seconds"] > 0
        assert s["from_cache"] is False
    assert result["converged"] is True
    assert result["sigma0"] == pytest.approx(1.0, abs=0.15)
    assert 0.02 < result["image_sigma_px"] < 0.3
    with (done / "result/images.csv").open() as file:
        assert [line.split(",")[2] for line in file][1:] == NAMES


def test_the_result_is_true(done):
    truth = read_block(PORTAL / "truth")
    adjusted = read_block(done / "result/block")
    interior = json.loads((done / "result/result.json").read_text())["cameras"]
    (camera,) = interior.values()
    (true,) = truth.cameras
    (nominal,) = adjusted.cameras
    scale = true.pixel_mm[0] / nominal.pixel_mm[0]
    assert abs(camera["c"]["value"] - true.values["c"] / scale) < 5 * camera["c"]["std"]
    rows = [truth.images.file.index(name) for name in adjusted.images.file]
    known = truth.images.centre[rows]
    m, R, t = similarity(adjusted.images.centre, known)
    error = m * adjusted.images.centre @ R.T + t - known
    assert np.abs(error).max() < 0.005  # metres, at about 6 m from the object and with few points
    angle = adjusted.images.rotation @ R.T @ truth.images.rotation[rows].transpose(0, 2, 1)
    error = np.degrees(np.arccos(np.clip((np.trace(angle, axis1=1, axis2=2) - 1) / 2, -1, 1)))
    with (done / "result/images.csv").open() as file:
        std = [[float(line[f"s{a}_deg"]) for a in ("omega", "phi", "kappa")] for line in csv.DictReader(file)]
    # five photographs tell the principal point from the attitudes by some tenths of a degree, and say so
    assert (error < 2.5 * np.linalg.norm(std, axis=1)).all()
    assert np.linalg.norm(std, axis=1).max() < 0.4
    for symbol in ("x0", "y0"):
        assert abs(camera[symbol]["value"] - true.values[symbol] / scale) < 4 * camera[symbol]["std"]


def similarity(source, target):
    """Scale, rotation and shift, target_from_source (Umeyama 1991)."""
    a, b = source - source.mean(axis=0), target - target.mean(axis=0)
    u, d, vt = np.linalg.svd(b.T @ a)
    turn = np.diag([1, 1, np.sign(np.linalg.det(u @ vt))])
    R = u @ turn @ vt
    m = np.trace(np.diag(d) @ turn) / (a**2).sum()
    return m, R, target.mean(axis=0) - m * R @ source.mean(axis=0)


def test_a_second_run_takes_every_stage_from_the_cache_and_changes_no_number(project, photos, capsys):
    before = numbers(project), tables(project)
    assert main(command(photos, project)) == 0
    cached = {name: s["from_cache"] for name, s in stages(project).items()}
    assert [name for name, c in cached.items() if c] == ["features", "matching", "start", "precision"]
    assert numbers(project) == before[0]
    assert tables(project) == before[1]
    capsys.readouterr()
    assert main(["status", str(project)]) == 0
    lines = {line.split()[0]: line for line in capsys.readouterr().out.splitlines()}
    assert "from cache" in lines["features"]
    assert "10 pairs" in lines["matching"]


@pytest.fixture
def counted(monkeypatch):
    """How often pairs are verified and features detected."""
    count = Counter()
    for module, name in ((tie_points, "verify"), (tie_points, "grey_of")):
        original = getattr(module, name)

        def wrapper(*arguments, original=original, name=name):
            count[name] += 1
            return original(*arguments)

        monkeypatch.setattr(module, name, wrapper)
    return count


@pytest.mark.long
def test_photographs_that_are_added_are_matched_with_the_others_and_only_they(project, photos, tmp_path, counted):
    more = tmp_path / "more"
    more.mkdir()
    shutil.copy(PORTAL / "photos/portal_06.jpg", more)
    result = orient([photos, more], project, QUICK)
    assert counted == {"grey_of": 1, "verify": 5}
    assert len(result.photos) == 6
    assert len(result.pairs) == 15
    assert result.not_oriented == ()
    again = orient([photos], project, QUICK)
    assert counted == {"grey_of": 1, "verify": 5}
    assert len(again.pairs) == 10


@pytest.mark.long
@pytest.mark.parametrize(
    ("first", "kept"),
    [
        ("start", {"features", "matching"}),
        ("matching", {"features"}),
        ("adjustment", {"features", "matching", "start"}),
    ],
)
def test_from_a_stage_on_everything_is_done_again(project, photos, first, kept):
    plain = orient([photos], project, QUICK)  # fills the cache of `start`
    assert {s.name for s in plain.stages if s.from_cache} == {"features", "matching", "start"}
    result = orient([photos], project, replace(QUICK, redo_from=first))
    assert {s.name for s in result.stages if s.from_cache} == kept
    assert result.adjustment.sigma0 == plain.adjustment.sigma0
    np.testing.assert_array_equal(result.adjustment.adjusted.points.xyz, plain.adjustment.adjusted.points.xyz)


def products(project, kind):
    found = sorted((project / "cache").glob(f"*/{kind}-*.npz"))
    assert found
    return found


@pytest.mark.long
def test_a_damaged_product_is_made_again(project, photos):
    before = numbers(project)
    for kind in ("start", "precision"):
        for path in products(project, kind):
            path.write_bytes(path.read_bytes()[:1000])
    assert main(command(photos, project)) == 0
    assert numbers(project) == before
    assert {n for n, s in stages(project).items() if s["from_cache"]} == {"features", "matching"}


def test_features_that_are_damaged_are_found_again(project, photos, counted):
    path = products(project, "features")[2]
    path.write_bytes(b"damaged")
    result = orient([photos], project, QUICK)
    assert counted == {"grey_of": 1}
    assert result.oriented == 5


def test_features_that_are_damaged_during_the_work_are_made_again(project, photos, monkeypatch):
    whole = [p.read_bytes() for p in products(project, "features")]
    original = tie_points.match_pairs

    def damaged_before(*arguments):
        products(project, "features")[2].write_bytes(b"damaged")
        return original(*arguments)

    monkeypatch.setattr(matching, "match_pairs", damaged_before)
    orient([photos], project, replace(QUICK, redo_from="matching"))
    assert [p.read_bytes() for p in products(project, "features")] == whole


@pytest.mark.long
def test_the_number_of_jobs_changes_no_result(project, photos):
    a, b = (orient([photos], project, replace(QUICK, jobs=k, redo_from="matching")) for k in (1, 3))
    # sums are formed in another order: the last digits differ, and nothing else
    assert a.adjustment.sigma0 == pytest.approx(b.adjustment.sigma0, rel=1e-9)
    np.testing.assert_allclose(a.adjustment.adjusted.points.xyz, b.adjustment.adjusted.points.xyz, rtol=1e-6, atol=1e-6)
    assert [p.matches.tolist() for p in a.pairs] == [p.matches.tolist() for p in b.pairs]


def test_a_photograph_that_changed_is_a_new_one(project, photos, tmp_path, counted):
    changed = Path(shutil.copytree(photos, tmp_path / "changed"))
    data = (PORTAL / "photos/portal_07.jpg").read_bytes()
    (changed / NAMES[0]).write_bytes(data)
    result = orient([changed], project, QUICK)
    assert counted["grey_of"] == 1
    assert 4 <= counted["verify"] <= 8  # its pairs, those that are unlike at first look once more where they are needed
    assert result.photos[0].name == NAMES[0]


def test_originals_are_never_touched(done, photos):
    for name in NAMES:
        assert (photos / name).read_bytes() == (PORTAL / "photos" / name).read_bytes()
    assert sorted(p.name for p in photos.iterdir()) == NAMES


def test_the_project_holds_no_leftovers(done):
    opened = Project.open(done, create=False)
    try:
        assert [r.name for r in opened.stages()][:6] == [
            "photographs", "features", "matching", "start", "precision", "adjustment"
        ]  # fmt: skip
    finally:
        opened.close()
    assert not [p for p in done.rglob(".*") if p.is_file()]


def test_photographs_of_another_camera_are_told_by_their_names(project, photos):
    result = orient([photos], project, replace(QUICK, own_camera=("portal_0[45]*",)))
    assert len(result.groups) == 2
    assert result.adjustment.given.images.camera.tolist() == [0, 0, 0, 1, 1]


def test_the_camera_library_is_asked(project, photos, tmp_path, monkeypatch):
    """The calibration is held, said so, and left out where it is not wanted."""
    taken = find_photos([photos]).photos[0]
    camera = camera_of(camera_groups([taken])[0])
    if not taken.metadata.model or taken.metadata.focal_mm is None:
        pytest.skip("the photographs of the portal have no EXIF")
    held = replace(camera, values={**camera.values, "c": camera.values["c"] * 1.01})
    add_entry(LibraryEntry(key=key_of(taken), camera=held, date="2026-05-01"), tmp_path / "library")
    monkeypatch.setenv("RAYBUNDLE_CAMERAS", str(tmp_path / "library"))
    result = orient([photos], project, QUICK)
    assert result.adjustment.adjusted.cameras[0].values["c"] == held.values["c"]
    held_of_library = re.compile(r"library, of 2026-05-01, is held")
    assert any(n.code == "camera" and held_of_library.search(n.text) for n in result.adjustment.notices)
