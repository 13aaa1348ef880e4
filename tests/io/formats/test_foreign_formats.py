"""Laws that every foreign format fulfils: a new file in io/formats is tested by existing."""

import json
from dataclasses import replace
from xml.etree import ElementTree as ET

import numpy as np
import pytest
from scipy.spatial.transform import Rotation
from tests.messages import coded

from raybundle.cameras.conversions import camera_rays, grid_px, interiors
from raybundle.errors import InputError
from raybundle.io.formats import Export, formats, read_format, write_format
from raybundle.io.geo.coordinate_systems import local_frame
from raybundle.io.pictures.undistort import undistorted_block
from raybundle.planning.simulate import Survey, simulate
from raybundle.planning.synthetic_networks import TargetField, brown_camera, field_scene
from raybundle.sensors import sensor_models

BOTH = sorted(n for n, f in formats.items() if f.read and f.write)
WRITTEN = sorted(n for n, f in formats.items() if f.write)
LENS = {"K1": 3e-5, "K2": -4e-8, "K3": 0.0, "P1": 2e-6, "P2": -1e-6}
FRAME = local_frame("EPSG:32632", (500_000.0, 5_400_000.0, 400.0))


def make_block(**camera):
    survey = Survey(control=3, check=1, control_sigma=(0.01, 0.01, 0.01))
    lens = brown_camera(values={**LENS, **camera})
    block = simulate(field_scene(TargetField(camera=lens, stations=4, frontal=1, rows=5, columns=6)), survey).truth
    return replace(block, cameras=(replace(block.cameras[0], id="cam"),))


@pytest.fixture(scope="module")
def block():
    return make_block()


def exported(block):
    count = len(block.points)
    colours = np.stack([np.arange(count) % 256, np.full(count, 7), np.full(count, 250)], axis=1)
    sigma = np.full((count, 3), 0.001)
    return Export(
        block=block, colours=colours, sigma=sigma, station_sigma=np.full((len(block.images), 3), 0.002), frame=FRAME
    )


def target(tmp_path, name):
    return tmp_path / f"out{formats[name].suffix}"


NEEDS = {"las": ("laspy", "las"), "gpkg": ("pyogrio", "geo"), "dxf": ("ezdxf", "geo")}
"""Libraries of formats, and their extras"""


def needs(name):
    if name in NEEDS:
        library, extra = NEEDS[name]
        pytest.importorskip(library, reason=f"{name} needs the extra [{extra}]")


def image_order(block, other):
    """Positions in `other` of the images of a block; a format may drop the suffix of the name."""
    names = {i.rpartition(".")[0] or i: k for k, i in enumerate(other.images.ids)} | {
        i: k for k, i in enumerate(other.images.ids)
    }
    return [names[(f or i) if (f or i) in names else (f or i).rpartition(".")[0]] for i, f in named(block)]


def named(block):
    return list(zip(block.images.ids, block.images.file, strict=True))


def camera_difference_px(a, b):
    """Largest difference of the images of the same rays, over the whole format, in pixels near enough."""
    pixels = grid_px(a.width_px, a.height_px, 17)
    ra, rb = camera_rays(a, pixels), camera_rays(b, pixels)
    assert (a.width_px, a.height_px) == (b.width_px, b.height_px)
    return float(np.linalg.norm(ra / ra[2] - rb / rb[2], axis=0).max() * a.values["c"] / a.pixel_mm[0])


@pytest.mark.parametrize("name", BOTH)
def test_what_is_written_reads_back(name, block, tmp_path):
    written = write_format(name, exported(block), target(tmp_path, name))
    again = read_format(name, target(tmp_path, name))
    other, order = again.block, image_order(block, again.block)
    np.testing.assert_allclose(other.images.centre[order], block.images.centre, atol=1e-9)
    np.testing.assert_allclose(other.images.rotation[order], block.images.rotation, atol=1e-9)
    assert camera_difference_px(block.cameras[0], other.cameras[0]) < 3 * written.deviation_px + 0.02
    if len(other.observations) == 0:
        return
    assert observed(other, order) == observed(block, range(len(block.images)), control_only=name == "metashape")


def observed(block, order, *, control_only=False):
    """Image and pixel of every observation, as a set; single precision is enough."""
    place = {image: k for k, image in enumerate(order)}
    role = np.asarray(block.points.role)
    o = block.observations
    return {
        (place[i], round(float(x), 2), round(float(y), 2))
        for i, p, (x, y) in zip(o.image.tolist(), o.point.tolist(), o.xy_px, strict=True)
        if not control_only or role[p]
    }


@pytest.mark.parametrize("name", [n for n in BOTH if n not in {"metashape", "nerfstudio"}])
def test_points_and_colours_come_back(name, block, tmp_path):
    given = exported(block)
    write_format(name, given, target(tmp_path, name))
    again = read_format(name, target(tmp_path, name))
    # points may have got other names: compare them by their coordinates
    order = np.lexsort(np.round(again.block.points.xyz, 4).T)
    mine = np.lexsort(np.round(block.points.xyz, 4).T)
    np.testing.assert_allclose(again.block.points.xyz[order], block.points.xyz[mine], atol=1e-6)
    if again.colours is not None:
        np.testing.assert_array_equal(again.colours[order], given.colours[mine])


@pytest.mark.parametrize("name", WRITTEN)
def test_nothing_is_overwritten_and_an_error_leaves_nothing(name, block, tmp_path):
    needs(name)
    path = target(tmp_path, name)
    path.mkdir()
    (path / "mine.txt").write_text("keep")
    with pytest.raises(InputError, match=r"folder\.exists"):
        write_format(name, exported(block), path)
    assert [p.name for p in tmp_path.rglob("*")] == [path.name, "mine.txt"]
    nothing = replace(block, images=replace(block.images, centre=np.full((len(block.images), 3), np.nan)))
    with pytest.raises(InputError, match=r"block\.no_oriented_image"):
        write_format(name, exported(nothing), tmp_path / "sub" / path.name)
    assert list((tmp_path / "sub").iterdir()) == []


@pytest.mark.parametrize("name", WRITTEN)
def test_what_is_not_known_is_left_out_and_said(name, block, tmp_path):
    needs(name)
    xyz, centre = block.points.xyz.copy(), block.images.centre.copy()
    xyz[3], centre[2] = np.nan, np.nan
    part = replace(block, points=replace(block.points, xyz=xyz), images=replace(block.images, centre=centre))
    found = coded(write_format(name, exported(part), target(tmp_path, name), approximate=True).remarks)
    images = {"n": 1, "total": len(block.images), "names": [block.images.ids[2]]}
    assert found["conversion.not_oriented"] == images
    assert found["conversion.no_coordinates"] == {"n": 1, "total": len(block.points), "names": [block.points.ids[3]]}


@pytest.mark.parametrize("name", WRITTEN)
def test_an_interior_orientation_for_each_image_gets_its_own_camera(name, block, tmp_path):
    needs(name)
    camera = replace(block.cameras[0], interior="per_image")
    own = {1: {**camera.values, "c": camera.values["c"] * 1.01}}
    part = replace(block, cameras=(camera,), images=replace(block.images, interior=own))
    cameras, index = interiors(part)
    assert len(cameras) == 2
    assert index.tolist() == [0, 1, *[0] * (len(block.images) - 2)]
    write_format(name, exported(part), target(tmp_path, name), approximate=True)
    if name in BOTH:
        other = read_format(name, target(tmp_path, name)).block
        order = image_order(part, other)
        c = [other.cameras[int(other.images.camera[k])] for k in order]
        ratio = (c[1].values["c"] / c[1].pixel_mm[0]) / (c[0].values["c"] / c[0].pixel_mm[0])
        assert ratio == pytest.approx(1.01, abs=1e-5)


@pytest.mark.parametrize("name", [n for n in WRITTEN if n not in {"ply", "las", "kml", "geojson", "gpkg", "dxf"}])
def test_a_camera_without_distortion_is_exact(name, tmp_path):
    exact = make_block(**dict.fromkeys(LENS, 0.0), x0=0.0, y0=0.0)
    assert write_format(name, exported(exact), target(tmp_path, name)).deviation_px < 1e-9
    if name in BOTH:
        other = read_format(name, target(tmp_path, name)).block
        assert camera_difference_px(exact.cameras[0], other.cameras[0]) < 1e-8


@pytest.mark.parametrize("model", sorted(n for n, m in sensor_models.items() if m.all_round))
@pytest.mark.parametrize("name", WRITTEN)
def test_fisheyes_are_written_or_refused_by_name(name, model, block, tmp_path):
    needs(name)
    values = {**dict.fromkeys(sensor_models[model].symbols, 0.0), "c": 12.0, "x0": 0.01, "y0": 0.02}
    values |= {s: 1e-3 for s in ("k1",) if s in values} | {s: 1e-4 for s in ("K1",) if s in values}
    fish = replace(block, cameras=(replace(block.cameras[0], model=model, values=values, estimate="auto"),))
    if name in {"opf", "bundler"}:
        with pytest.raises(InputError, match=r"camera\.not_in_format"):
            write_format(name, exported(fish), target(tmp_path, name))
        return
    write_format(name, exported(fish), target(tmp_path, name))
    if name in BOTH:
        other = read_format(name, target(tmp_path, name)).block
        assert other.cameras[0].sensor.all_round
        assert camera_difference_px(fish.cameras[0], other.cameras[0]) < 0.05


K = {"k1": 0.05, "k2": -0.02, "k3": 0.01, "k4": -0.002}
"""Distortion that the corrections of `fisheye` meet to 0.2 px alone, 60 degrees off the axis."""


@pytest.mark.parametrize("name", [n for n in BOTH if n not in {"opf", "bundler"}])
def test_strongly_distorted_fisheyes_come_back_exactly(name, block, tmp_path):
    camera = block.cameras[0]
    half = np.hypot(camera.width_px * camera.pixel_mm[0], camera.height_px * camera.pixel_mm[1]) / 2
    values = {"c": half / np.radians(60), "x0": 0.01, "y0": 0.02, **K}
    fish = replace(block, cameras=(replace(camera, model="kannala_brandt", values=values, estimate="auto"),))
    written = write_format(name, exported(fish), target(tmp_path, name))
    assert written.deviation_px == 0
    again = read_format(name, target(tmp_path, name))
    assert again.deviation_px == 0
    found = again.block.cameras[0]
    assert found.model == "kannala_brandt"
    assert {k: found.values[k] for k in K} == pytest.approx(K, rel=1e-14)
    assert camera_difference_px(fish.cameras[0], found) < 1e-8


def test_terms_of_rounding_make_no_other_fisheye(block, tmp_path):
    values = {"c": 12.0, "x0": 0.01, "y0": 0.02, **K}
    fish = replace(block, cameras=(replace(block.cameras[0], model="kannala_brandt", values=values, estimate="auto"),))
    path = target(tmp_path, "metashape")
    write_format("metashape", exported(fish), path)
    text, more = path.read_text(), "<p1>5e-17</p1><p2>-2e-17</p2><b1>4e-13</b1><b2>1e-13</b2></calibration>"
    path.write_text(text.replace("</calibration>", more))
    assert read_format("metashape", path).block.cameras[0].model == "kannala_brandt"
    path.write_text(text.replace("</calibration>", "<p1>1e-4</p1></calibration>"))
    assert read_format("metashape", path).block.cameras[0].model == "fisheye"


def test_unknown_formats_and_directions_are_refused(block, tmp_path):
    with pytest.raises(InputError, match=r"format\.unknown"):
        write_format("doc", exported(block), tmp_path / "x")
    with pytest.raises(InputError, match=r"format\.only_written"):
        read_format("ply", tmp_path / "x")
    with pytest.raises(InputError, match=r"file\.missing"):
        read_format("colmap", tmp_path / "x")


def test_maps_need_a_coordinate_system(block, tmp_path):
    with pytest.raises(InputError, match=r"format\.needs_crs"):
        write_format("kml", replace(exported(block), frame=None), tmp_path / "x.kml")


def test_undistorted_observations_fit_the_pinhole(block):
    straight, remarks = undistorted_block(block)
    assert all(not v for s, v in straight.cameras[0].values.items() if s not in {"c", "x0", "y0"})
    o = straight.observations
    local = np.einsum(
        "nij,nj->ni",
        straight.images.rotation[o.image],
        straight.points.xyz[o.point] - straight.images.centre[o.image],
    )
    c = straight.cameras[0]
    image = -c.values["c"] * local[:, :2] / local[:, 2:] + [c.values["x0"], c.values["y0"]]
    np.testing.assert_allclose(c.pixel_from_image(image), o.xy_px, atol=1e-6)
    assert len(remarks) == (len(o) < len(block.observations))


def brown_forward(x, y, k1, k2, k3, k4, p1, p2):
    """OpenCV's formula, written down once more."""
    r2 = x * x + y * y
    radial = 1 + k1 * r2 + k2 * r2**2 + k3 * r2**3 + k4 * r2**4
    return (
        x * radial + 2 * p1 * x * y + p2 * (r2 + 2 * x * x),
        y * radial + p1 * (r2 + 2 * y * y) + 2 * p2 * x * y,
    )


def nerfstudio_pixels(path, name, xyz):
    top = json.loads(path.read_text())
    frame = next(f for f in top["frames"] if f["file_path"] == f"images/{name}")
    M = np.array(frame["transform_matrix"])
    x, y, z = M[:3, :3].T @ (xyz - M[:3, 3])
    u, v = brown_forward(x / -z, -y / -z, *(top[k] for k in ("k1", "k2", "k3", "k4", "p1", "p2")))
    return top["fl_x"] * u + top["cx"], top["fl_y"] * v + top["cy"]


def opensfm_pixels(path, name, xyz):
    top = json.loads(path.read_text())[0]
    shot = top["shots"][name]
    camera = top["cameras"][shot["camera"]]
    x, y, z = Rotation.from_rotvec(shot["rotation"]).as_matrix() @ xyz + shot["translation"]
    u, v = brown_forward(x / z, y / z, *(camera[k] for k in ("k1", "k2", "k3")), 0.0, camera["p1"], camera["p2"])
    side = max(camera["width"], camera["height"])
    u, v = camera["focal_x"] * u + camera["c_x"], camera["focal_y"] * v + camera["c_y"]
    return u * side + camera["width"] / 2, v * side + camera["height"] / 2


def metashape_pixels(path, name, xyz):
    chunk = ET.parse(path).getroot().find("chunk")  # noqa: S314  (our own file)
    camera = next(
        c for c in chunk.find("cameras") if c.get("label") == name.rpartition(".")[0] or c.get("label") == name
    )
    sensor = next(s for s in chunk.find("sensors") if s.get("id") == camera.get("sensor_id"))
    k = {e.tag: float(e.text) for e in sensor.find("calibration") if e.text}
    M = np.array(camera.find("transform").text.split(), float).reshape(4, 4)
    X, Y, Z = M[:3, :3].T @ (xyz - M[:3, 3])
    x, y = X / Z, Y / Z
    r2 = x * x + y * y
    radial = 1 + sum(k.get(f"k{n}", 0.0) * r2**n for n in (1, 2, 3, 4))
    p1, p2 = k.get("p1", 0.0), k.get("p2", 0.0)
    u = x * radial + p1 * (r2 + 2 * x * x) + 2 * p2 * x * y
    v = y * radial + p2 * (r2 + 2 * y * y) + 2 * p1 * x * y
    size = sensor.find("resolution")
    return (
        float(size.get("width")) / 2 + k.get("cx", 0.0) + u * (k["f"] + k.get("b1", 0.0)) + v * k.get("b2", 0.0),
        float(size.get("height")) / 2 + k.get("cy", 0.0) + v * k["f"],
    )


def bundler_pixels(path, name, xyz):
    words = iter(path.read_text().split("\n", 1)[1].split())
    count = int(next(words))
    next(words)
    cameras = [[float(next(words)) for _ in range(15)] for _ in range(count)]
    k = path.with_name(f"{path.stem}-list.txt").read_text().split().index(name)
    f, k1, k2 = cameras[k][:3]
    P = np.array(cameras[k][3:12]).reshape(3, 3) @ xyz + cameras[k][12:]
    p = -P[:2] / P[2]
    x, y = f * (1 + k1 * (p @ p) + k2 * (p @ p) ** 2) * p
    return x + 3000, 2000 - y


PUBLISHED = {
    "nerfstudio": nerfstudio_pixels,
    "opensfm": opensfm_pixels,
    "metashape": metashape_pixels,
    "bundler": bundler_pixels,
}


@pytest.mark.parametrize("name", PUBLISHED)
def test_the_published_formula_gives_our_image_points(name, tmp_path):
    """From the file alone, by the formula of its program, without a line of our reader."""
    block = make_block(P1=0.0, P2=0.0, x0=0.0, y0=0.0) if name == "bundler" else make_block()
    path = target(tmp_path, name)
    written = write_format(name, exported(block), path)
    o = block.observations
    for row in range(0, len(o), 7):
        image = block.images.file[o.image[row]] or block.images.ids[o.image[row]]
        pixel = PUBLISHED[name](path, image, block.points.xyz[o.point[row]])
        assert np.linalg.norm(pixel - o.xy_px[row]) < written.deviation_px + 1e-6
    assert written.deviation_px < 0.2
