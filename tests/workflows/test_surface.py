"""The surface of rendered photographs, from result to point cloud: three of the portal, at half their size."""

import base64
import json
import re
from dataclasses import replace

import cv2
import numpy as np
import pytest
from scipy.spatial import KDTree

from raybundle.block import PixelFrame
from raybundle.commands.surface import surface
from raybundle.errors import InputError
from raybundle.io.block.folder import read_block, write_block
from raybundle.numerics import native
from raybundle.surfaces.files.heights import read_heights
from raybundle.surfaces.run import surface as measured
from raybundle.surfaces.state import SurfaceOptions
from tests.workflows.half_portal import NAMES, PORTAL, half_portal


@pytest.fixture(scope="module")
def found(half, copy_of_surface, tmp_path_factory):
    """Surface of the three photographs, every fourth pixel."""
    work = copy_of_surface(tmp_path_factory.mktemp("surface") / "s") / "work"
    return measured(half / "block", work, SurfaceOptions(density=4), photos=[half], jobs=1), work


def test_points_are_those_of_the_object(found):
    done, _ = found
    assert len(done) > 3000
    assert not done.left_out
    truth = read_block(PORTAL / "truth")
    cloud = np.concatenate([c.xyz for c in done.parts()])
    sigma = np.concatenate([np.linalg.norm(c.sigma, axis=1) for c in done.parts()])
    assert (sigma > 0).all()
    assert np.isfinite(sigma).all()
    named = np.array([n.startswith("P") for n in truth.points.ids])
    tree = KDTree(cloud)
    near, _ = tree.query(truth.points.xyz[named], distance_upper_bound=0.03)
    hit = np.isfinite(near)
    assert hit.mean() > 0.3
    # a pixel of four is 22 mm on the object: the nearest point lies within it, in depth by far nearer
    assert np.median(near[hit]) < 0.012
    for c in done.parts():
        assert (c.confirmed >= 1).all()
        assert (c.views >= 2).all()
        assert (c.incidence <= 1).all()
        assert len(np.unique(c.colour)) > 20


def test_what_was_done_is_not_done_again_and_gives_the_same_bits(found, half):
    done, work = found
    again = measured(half / "block", work, SurfaceOptions(density=4), photos=[half], jobs=2)
    assert again.clouds == done.clouds
    assert all(r.from_cache for r in again.records)
    key = done.clouds[0][1]
    before = {k: np.array(v) for k, v in done.store.wanted(key).items()}
    file = next(work.rglob(f"*{key.rsplit('-', 1)[1]}*.npz"))
    file.write_bytes(file.read_bytes()[: file.stat().st_size // 2])  # as a full disk leaves it
    third = measured(half / "block", work, SurfaceOptions(density=4), photos=[half], jobs=1)
    after = third.store.wanted(key)
    assert all(np.array_equal(before[k], after[k], equal_nan=before[k].dtype.kind == "f") for k in before)


def test_without_compiled_kernels_no_surface(monkeypatch, tmp_path):
    monkeypatch.setattr(native, "module", lambda: None)
    with pytest.raises(InputError) as refused:
        measured(tmp_path, tmp_path / "s", SurfaceOptions(), photos=[tmp_path])
    assert refused.value.message.code == "environment.native_missing"


def test_heights_are_written_with_what_orientation_does_to_them(half, tmp_path):
    rasterio = pytest.importorskip("rasterio")
    done = surface(half / "block", tmp_path / "s", photos=(half,), density="4", dsm=0.05, jobs=1)
    names = [name for name, _ in done.written]
    assert names == ["", "dsm"]
    shown = json.loads(re.search(r'id="network-data">(.*?)</script>', (tmp_path / "s/surface_3d.html").read_text())[1])
    places = np.frombuffer(base64.b64decode(shown["cloud"]["xyz"]), "<u2").reshape(-1, 3)
    cloud = np.concatenate([c.xyz for c in done.surface.parts()])
    drawn = places * shown["cloud"]["step"] + shown["cloud"]["low"] + np.array(shown["origin"])
    assert np.abs(drawn - cloud).max() < shown["cloud"]["step"]
    assert len(shown["cloud"]["names"]) == 3
    assert shown["classes"]["cloud"]["colours"]
    assert "<h1>Surface of" in (tmp_path / "s/surface.html").read_text()
    model, file = read_heights(tmp_path / "s")
    with rasterio.open(tmp_path / "s/heights.tif") as one, rasterio.open(tmp_path / "s/heights_sigma.tif") as many:
        assert np.array_equal(one.read(1), model.heights.height, equal_nan=True)
        assert one.transform[0] == 0.05
        assert many.descriptions[0] == "sigma"
        assert np.allclose(many.read(1), model.heights.sigma, equal_nan=True)
    known = model.known
    assert known.mean() > 0.1
    # points of the cloud lie on the heights of their cells
    cloud = np.concatenate([c.xyz for c in done.surface.parts()])
    plane = done.surface.heights.grid.plane
    uvh = plane.coordinates(cloud)
    cells = np.floor(done.surface.heights.grid.cells(uvh[:, :2])).astype(int)
    inside = ((cells >= 0) & (cells < [file.width, file.height])).all(axis=1)
    there = model.heights.height[cells[inside, 1], cells[inside, 0]]
    assert np.nanmedian(np.abs(there - uvh[inside, 2])) < 0.02
    assert np.allclose(plane.points(uvh), cloud)
    one_cell = np.zeros(known.shape)
    at = tuple(np.argwhere(known)[known.sum() // 2])
    one_cell[at] = 1.0
    alone = model.sum_of(one_cell)
    assert alone.value == pytest.approx(float(model.heights.height[at]))
    assert alone.local == pytest.approx(float(model.local[at]), rel=1e-5)
    assert alone.orientation == pytest.approx(float(model.heights.orientation[at]), rel=0.5)
    (tmp_path / "s/heights_orientation.npz").unlink()
    with pytest.raises(InputError, match=r"heights_orientation\.npz.*surface_files\.no_heights"):
        read_heights(tmp_path / "s")


@pytest.fixture(scope="module")
def loose_scale(tmp_path_factory):
    """Heights in cells of 2 cm by a scale bar of 1 %, and the middle of the points, about which its error moves all."""
    pytest.importorskip("rasterio")
    folder = half_portal(tmp_path_factory.mktemp("loose"))
    bar = folder / "block/distances.csv"
    head, first = bar.read_text().splitlines()[:2]
    start, end, length, _ = first.split(",")
    bar.write_text(f"{head}\n{start},{end},{length},{0.01 * float(length)}\n")
    surface(folder / "block", folder / "s", photos=(folder,), density="4", dsm=0.02, jobs=1)
    return *read_heights(folder / "s"), read_block(folder / "block").points.xyz.mean(axis=0)


def scaled(model, file, middle):
    """(rows, columns) how a surface that is 1 % larger lies above places that are held, NaN at steps."""
    h = model.heights.height.astype(float)
    axes = np.array([file.plane[k] for k in ("right", "up", "normal")])
    u0, v0, h0 = axes @ (middle - np.array(file.plane["origin"]))
    rows, columns = h.shape
    u, v = file.left + (np.arange(columns) + 0.5) * file.cell, file.top - (np.arange(rows) + 0.5) * file.cell
    right, up = np.full(h.shape, np.nan), np.full(h.shape, np.nan)
    right[:, 1:-1], up[1:-1] = (h[:, 2:] - h[:, :-2]) / 2 / file.cell, (h[:-2] - h[2:]) / 2 / file.cell
    for axis in (0, 1):
        step = np.abs(np.diff(h, axis=axis)) > file.cell
        right[
            np.insert(step, 0, values=False, axis=axis) | np.insert(step, step.shape[axis], values=False, axis=axis)
        ] = np.nan
    return 0.01 * (h - h0 - right * (u - u0) - up * (v - v0)[:, None])


def test_an_error_of_scale_moves_heights_of_relief_as_it_moves_the_object(loose_scale):
    model, file, middle = loose_scale
    exact, side = scaled(model, file, middle), 3
    each = [
        (slice(r, r + side), slice(c, c + side))
        for r in range(0, model.shape[0] - side, 2)
        for c in range(0, model.shape[1] - side, 2)
    ]
    each = [w for w in each if np.isfinite(exact[w]).all()]
    assert len(each) > 200
    moved, true, height = list[np.ndarray](), list[float](), list[float]()
    for w in each:
        weights = np.zeros(model.shape)
        weights[w] = 1 / side**2
        found = model.sum_of(weights)
        moved.append(found.moved)
        height.append(found.value)
        true.append(float(exact[w].mean()))
    at = np.array([(w[0].start, w[1].start) for w in each])
    one, other = np.triu_indices(len(each), 1)
    far = np.abs(at[one] - at[other]).max(axis=1) <= 24
    far &= np.abs(np.array(height)[one] - np.array(height)[other]) > 0.1
    one, other = one[far], other[far]
    stated = np.linalg.norm(np.array(moved)[one] - np.array(moved)[other], axis=1)
    expected = np.abs(np.array(true)[one] - np.array(true)[other])
    assert len(one) > 500
    assert np.sqrt(np.mean(stated**2)) == pytest.approx(np.sqrt(np.mean(expected**2)), rel=0.15)
    assert np.corrcoef(stated, expected)[0, 1] > 0.9
    # as the adjustment is all but exact beside its scale, each mean by itself is told as well
    assert np.corrcoef(np.linalg.norm(moved, axis=1), np.abs(true))[0, 1] > 0.9


def test_a_language_that_there_is_not_is_told_before_anything_is_measured(half, tmp_path):
    with pytest.raises(InputError, match=r"xx.*report\.unknown_language"):
        surface(half / "block", tmp_path / "s", photos=(half,), language="xx")
    assert not (tmp_path / "s").exists()


def test_a_plane_is_asked_for_with_heights_alone(half, tmp_path):
    with pytest.raises(InputError, match=r"vertical=.*dsm=.*surface\.plane_without_heights"):
        surface(half / "block", tmp_path / "s", photos=(half,), vertical=True)


def test_photographs_that_are_not_there_are_named(half, tmp_path):
    for name in list(NAMES)[:2]:
        (tmp_path / name.replace(".jpg", ".png")).write_bytes((half / name.replace(".jpg", ".png")).read_bytes())
    (tmp_path / NAMES[2].replace(".jpg", ".png")).write_bytes(b"no picture")
    done = measured(half / "block", tmp_path / "w", SurfaceOptions(density=4), photos=[tmp_path], jobs=1)
    assert len(done.clouds) == 2
    (lost,) = done.left_out
    assert lost[0] == "portal_08"
    with pytest.raises(InputError, match=r"surface\.too_few_photographs"):
        measured(half / "block", tmp_path / "v", SurfaceOptions(density=4), photos=[tmp_path / "w"], jobs=1)


def test_a_file_that_is_stored_turned_gives_the_same_points(half, found, tmp_path):
    before, _ = found
    block = read_block(half / "block")
    for name in block.images.file:
        grey = cv2.imread(str(half / name))
        cv2.imwrite(str(tmp_path / name), grey if "02" not in name else cv2.rotate(grey, cv2.ROTATE_180))
    camera = block.cameras[0]
    frame = PixelFrame(turned=180, width_px=camera.width_px, height_px=camera.height_px)
    k = next(i for i, name in enumerate(block.images.file) if "02" in name)
    write_block(replace(block, images=replace(block.images, frames={k: frame})), tmp_path / "block")
    done = measured(tmp_path / "block", tmp_path / "w", SurfaceOptions(density=4), photos=[tmp_path], jobs=1)
    assert not done.left_out
    assert done.counts == before.counts
    for one, other in zip(before.parts(), done.parts(), strict=True):
        assert np.array_equal(one.xyz, other.xyz)
        assert np.array_equal(one.colour, other.colour)


def test_one_photograph_has_no_surface(half, tmp_path):
    name = NAMES[0].replace(".jpg", ".png")
    (tmp_path / name).write_bytes((half / name).read_bytes())
    with pytest.raises(InputError, match=r"surface\.too_few_photographs"):
        measured(half / "block", tmp_path / "w", SurfaceOptions(density=4), photos=[tmp_path], jobs=1)


def test_a_folder_with_other_things_is_left_alone(half, tmp_path):
    (tmp_path / "letter.txt").write_text("dear")
    with pytest.raises(InputError, match=r"letter\.txt.*surface\.foreign_file"):
        surface(half / "block", tmp_path, photos=(half,))
    assert [p.name for p in tmp_path.iterdir()] == ["letter.txt"]
