"""The stages of `orient` as values: each a file, done by whatever executor, the same products."""

import shutil
from dataclasses import replace
from importlib import import_module
from pathlib import Path
from pkgutil import iter_modules

import numpy as np
import pytest
from PIL import Image

from raybundle.adjustment.records.notice import Notice
from raybundle.errors import code_of
from raybundle.io.photos.photo import find_photos
from raybundle.io.trajectories import read_trajectory
from raybundle.matching.methods import feature_method
from raybundle.matching.reduced import Reduced
from raybundle.pipeline.executors import Processes, Threads
from raybundle.pipeline.project import Project
from raybundle.pipeline.stage import Means, Stage, Workflow
from raybundle.ties.points import find_features, match_pairs
from raybundle.workflows import orient as module
from raybundle.workflows.orient import OrientOptions, orient, stages
from raybundle.workflows.orienting import stages as orienting
from raybundle.workflows.orienting.state import ORIENT

KEPT = {"features", "matching", "start", "precision"}
PORTAL = Path(__file__).resolve().parents[2] / "demo_data/portal/photos"
needs_portal = pytest.mark.skipif(not PORTAL.is_dir(), reason="demo_data/portal is part of the repository")


@pytest.fixture(scope="module")
def photos(tmp_path_factory):
    """Three photographs of half the size."""
    folder = tmp_path_factory.mktemp("half")
    for k in (2, 3, 4):
        with Image.open(PORTAL / f"portal_{k:02d}.jpg") as image:
            image.reduce(2).save(folder / f"portal_{k:02d}.jpg", quality=92, exif=image.info["exif"])
    return folder


def test_every_file_is_one_stage_and_every_stage_has_its_place():
    names = [m.name for m in iter_modules(orienting.__path__)]
    of_files = [import_module(f"{orienting.__name__}.{n}") for n in names]
    assert sorted(m.STAGE.name for m in of_files if hasattr(m, "STAGE")) == sorted(ORIENT.stages)
    assert [m.ALTERNATIVE for m in of_files if hasattr(m, "ALTERNATIVE")] == ORIENT.alternatives
    order = [s.name for s in ORIENT.in_order()]
    assert order.index("features") < order.index("matching") < order.index("start") < order.index("precision")
    assert all(other in ORIENT.stages for s in ORIENT.in_order() for other in (*s.after, *s.before))
    for a in ORIENT.alternatives:  # its first way stands together
        first = order.index(a.first[0])
        assert tuple(order[first : first + len(a.first)]) == a.first
    assert stages() == (
        "photographs",
        "features",
        "matching",
        "start",
        "wide baselines",
        "precision",
        "adjustment",
        "report",
    )


@needs_portal
@pytest.mark.parametrize("method", ["rootsift", "reduced"])
def test_features_and_pairs_of_other_processes_are_the_same(photos, tmp_path, method):
    wanted = feature_method("rootsift") if method == "rootsift" else Reduced(feature_method("rootsift"))
    found = find_photos([photos]).photos
    products = []
    for name, executor in (("threads", Threads(2)), ("processes", Processes(2))):
        project = Project.open(tmp_path / name)
        try:
            means = Means(project=project, executor=executor)
            store, failed = find_features(means, found, wanted, 500)
            pairs = match_pairs(means, found, store, wanted, [(0, 1), (0, 2), (1, 2)])
            assert not failed
            assert means.made == means.asked == 6
            products.append((store.keys, [store.of(i).descriptors for i in range(3)], [p.matches for p in pairs]))
        finally:
            project.close()
    (keys, descriptors, matches), (others, *rest) = products
    assert keys == others
    for one, two in zip([*descriptors, *matches], [*rest[0], *rest[1]], strict=True):
        np.testing.assert_array_equal(one, two)
    assert min(len(m) for m in matches[::2]) > 30


@needs_portal
def test_a_stage_of_ones_own_is_one_value(photos, tmp_path, monkeypatch):
    """It takes what it needs of the state, is done in its place, and told."""
    counted = Stage(
        name="counted", after=("start",), before=("precision", "scene_start"),
        inputs=lambda s: (s.ties, s.photos), function=lambda i, _: len(i[0][0].block.points),
        put=lambda s, n: replace(s, notices=(*s.notices, Notice(code="count", message=f"{n} points"))),
        reported=lambda s: s.notices[-1].message,
    )  # fmt: skip
    mine = Workflow("orient", stages={**ORIENT.stages, "counted": counted}, alternatives=ORIENT.alternatives)
    monkeypatch.setattr(module, "ORIENT", mine)
    options = OrientOptions(feature_count=600, precise=False, jobs=2)
    done = orient([photos], tmp_path / "p", options)
    told = {r.name: r.summary for r in done.stages}
    assert [r.name for r in done.stages].index("counted") == 3 + 1
    assert told["counted"].endswith(" points")
    assert [n.text for n in done.adjustment.notices if n.code == "count"] == [told["counted"]]


@needs_portal
def test_a_photograph_that_lies_elsewhere_is_the_same(photos, tmp_path):
    """Products depend on what the photographs are, not on where they lie or what the project is called."""
    options = OrientOptions(feature_count=600, jobs=2)
    orient([photos], tmp_path / "p", options)
    moved = tmp_path / "moved"
    moved.mkdir()
    for path in photos.iterdir():
        (moved / path.name).write_bytes(path.read_bytes())
    again = orient([moved], tmp_path / "p", options)
    assert {r.name for r in again.stages if r.from_cache} == KEPT


@needs_portal
def test_what_does_not_concern_a_stage_makes_nothing_again(photos, tmp_path):
    """The project's name, and positions that come from a file beside the photographs."""
    options = OrientOptions(feature_count=600, jobs=2)
    first = orient([photos], tmp_path / "p", options)
    assert first.adjustment.given.name == "p"
    (tmp_path / "p").rename(tmp_path / "renamed")
    again = orient([photos], tmp_path / "renamed", options)
    assert {r.name for r in again.stages if r.from_cache} == KEPT
    assert again.adjustment.given.name == "renamed"
    assert again.adjustment.sigma0 == first.adjustment.sigma0
    lines = [f"portal_{k:02d}.jpg,500{k}00.0,500{k % 3}000.0,10{k}.0,5,5,5" for k in (2, 3, 4)]
    table = tmp_path / "positions.csv"
    table.write_text("\n".join(["image,X,Y,Z,sX,sY,sZ", *lines]) + "\n", encoding="utf-8")
    placed = orient(
        [photos], tmp_path / "renamed", replace(options, crs="EPSG:32633"), positions=read_trajectory(table)
    )
    assert {r.name for r in placed.stages if r.from_cache} == KEPT


@needs_portal
def test_a_mirrored_photograph_is_left_out_by_name(photos, tmp_path):
    folder = tmp_path / "photos"
    shutil.copytree(photos, folder)
    with Image.open(folder / "portal_03.jpg") as image:
        image.transpose(Image.Transpose.FLIP_LEFT_RIGHT).save(folder / "portal_03.jpg", exif=image.info["exif"])
    with Image.open(PORTAL / "portal_05.jpg") as image:
        image.reduce(2).save(folder / "portal_05.jpg", quality=92, exif=image.info["exif"])
    done = orient([folder], tmp_path / "project", OrientOptions(precise=False))
    assert code_of(dict(done.not_oriented)["portal_03.jpg"]) == "not_oriented.mirrored"
    (notice,) = [n for n in done.adjustment.notices if n.code == "mirrored_photographs"]
    assert notice.values["names"] == ["portal_03.jpg"]
    assert notice.values["matches"] > 5 * notice.values["plain"]
