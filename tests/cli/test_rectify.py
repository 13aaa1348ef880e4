"""`raybundle rectify`: colours of a known wall come back to their places, from a result and from one photograph."""

import math
import re
import shutil
from dataclasses import replace

import numpy as np
import pytest
from PIL import Image
from tests.cli.reported import reported, values_of
from tests.messages import refused

import raybundle as rb
from raybundle import adjust
from raybundle.block import Role
from raybundle.cli.main import main
from raybundle.errors import InputError
from raybundle.io.pictures.undistort import camera_plane
from raybundle.numerics.planes import plane_of_most
from raybundle.planning.simulate import Survey, simulate
from raybundle.planning.synthetic_networks import TargetField, brown_camera, field_scene
from raybundle.report.write import write_result
from raybundle.workflows.object_plane import plane_of

WALL = (-2.0, -1.5, 2.0, 1.5)
"""left, bottom, right, top of the painted part"""


def painted(u, v):
    """Colours (..., 3) of places on the wall: red grows to the right, green upwards."""
    red, green = (u - WALL[0]) / (WALL[2] - WALL[0]), (v - WALL[1]) / (WALL[3] - WALL[1])
    return np.stack([20 + 200 * red, 20 + 200 * green, np.full_like(red, 90.0)], axis=-1)


@pytest.fixture(scope="module")
def wall(tmp_path_factory):
    """A result of photographs of a painted plane."""
    folder = tmp_path_factory.mktemp("wall")
    small = brown_camera(size_px=(600, 400), pixel_mm=0.04)
    scene = field_scene(TargetField(camera=small, columns=9, rows=7, stations=4, frontal=1, depth=0.0))
    truth = simulate(scene, Survey(interior="exact", orientation="exact", points="exact", image_sigma_px=0.01)).observed
    (folder / "photos").mkdir()
    files = tuple(f"{k}.png" for k in range(len(truth.images)))
    origin, axes = truth.points.xyz.mean(axis=0), plane_of(truth).axes
    y, x = np.mgrid[0:400, 0:600] + 0.5
    pixels = np.stack([x.ravel(), y.ravel()], axis=1)
    ideal = truth.cameras[0].image_from_pixel(camera_plane(truth.cameras[0], pixels)).T
    values = truth.cameras[0].values
    inner = np.stack([ideal[0] - values["x0"], ideal[1] - values["y0"], np.full(ideal.shape[1], -values["c"])])
    for k, file in enumerate(files):
        ray = truth.images.rotation[k].T @ inner
        reach = ((origin - truth.images.centre[k]) @ axes[2]) / (axes[2] @ ray)
        at = truth.images.centre[k][:, None] + reach * ray
        u, v = axes[:2] @ (at - origin[:, None])
        Image.fromarray(np.clip(painted(u, v), 0, 255).round().astype(np.uint8).reshape(400, 600, 3)).save(
            folder / "photos" / file
        )
    block = replace(truth, images=replace(truth.images, file=files))
    fixed = replace(block, points=replace(block.points, role=np.full(len(block.points), Role.CONTROL, np.int32),
                                          sigma=np.full((len(block.points), 3), 1e-4)))  # fmt: skip
    write_result(adjust(fixed), folder / "result", report="none")
    return folder, block, origin, axes


def seen(path):
    return np.asarray(Image.open(path)).astype(float)


def test_a_wall_of_all_photographs(wall, tmp_path, capsys):
    folder, *_ = wall
    out = tmp_path / "wall.tif"
    found = reported(
        capsys, "rectify", folder / "result", "--photos", folder / "photos", "--out", out, "--pixel", 0.01,
        "--extent", -0.6, -0.4, 0.6, 0.4,
    )  # fmt: skip
    assert values_of(found, ["summary"])["picture.plane"]["rms"] < 1e-3
    picture = seen(out)
    assert picture.shape == (80, 120, 4)
    assert picture[..., 3].min() == 255
    u, v = np.meshgrid(-0.6 + 0.01 * (np.arange(120) + 0.5), 0.4 - 0.01 * (np.arange(80) + 0.5))
    # the plane of the result begins at the mean of its points, as this one
    away = np.abs(picture[..., :3] - painted(u, v))
    assert away.max() < 2.5  # rounded twice, and the places of the fitted plane
    assert away.mean() < 0.6
    world = [float(line) for line in (tmp_path / "wall.tfw").read_text().split()]
    assert world == pytest.approx([0.01, 0, 0, -0.01, -0.595, 0.395])
    assert "normal" in (tmp_path / "wall.toml").read_text()


def test_a_picture_to_scale_wants_a_length(wall, tmp_path, capsys):
    folder, block, *_ = wall
    write_result(adjust(block), tmp_path / "free", report="none")
    out = tmp_path / "wall.tif"
    arguments = ["rectify", str(tmp_path / "free"), "--photos", str(folder / "photos"), "--out", str(out), "--progress"]
    assert main([*arguments, "none"]) == 2
    told = capsys.readouterr().err
    assert "[block.scale_free]" in told
    assert "--free-scale" in told
    assert not list(tmp_path.glob("wall.*"))
    assert main([*arguments, "none", "--free-scale"]) == 0
    about = (tmp_path / "wall.toml").read_text()
    assert 'scale = "free"' in about
    assert 'unit = ""' in about
    assert " m " not in capsys.readouterr().out


def marks(folder, block, origin, axes, wrong=None):
    """Control of the first photograph in the wall's own coordinates."""
    o, image = block.observations, 0
    rows = np.flatnonzero(o.image == image)[::3]
    uv = (block.points.xyz[o.point[rows]] - origin) @ axes[:2].T
    xy = o.xy_px[rows].copy()
    if wrong is not None:
        xy[wrong] += 12
    ids = [block.points.ids[p] for p in o.point[rows]]
    (folder / "c.csv").write_text(
        "point,X,Y,Z\n" + "".join(f"{n},{a},{b},\n" for n, (a, b) in zip(ids, uv, strict=True))
    )
    (folder / "c-measurements.csv").write_text(
        "image,point,x_px,y_px\n" + "".join(f"0.png,{n},{a},{b}\n" for n, (a, b) in zip(ids, xy, strict=True))
    )
    return ids


def lens(folder, target):
    """The cameras of the result in a file of their own."""
    text = (folder / "result" / "block" / "block.toml").read_text()
    path = target / "camera.toml"
    path.write_text(text[text.index("[cameras") :])
    return path


def test_a_wall_of_one_photograph(wall, tmp_path, capsys):
    folder, block, origin, axes = wall
    marks(tmp_path, block, origin, axes)
    common = ["rectify", str(folder / "photos" / "0.png"), "--control", str(tmp_path / "c.csv"), "--pixel", "0.01",
              "--extent", "-0.4", "-0.3", "0.4", "0.3", "--mark-sigma", "0.05"]  # fmt: skip
    calibration = lens(folder, tmp_path)
    assert main([*common, "--out", str(tmp_path / "one.png"), "--calibration", str(calibration)]) == 0
    told = capsys.readouterr().out
    assert "sigma0" in told
    assert "warning" not in told
    picture = seen(tmp_path / "one.png")
    u, v = np.meshgrid(-0.4 + 0.01 * (np.arange(80) + 0.5), 0.3 - 0.01 * (np.arange(60) + 0.5))
    good = picture[..., 3] > 0
    assert good.mean() > 0.9
    assert np.abs(picture[..., :3] - painted(u, v))[good].max() < 2.5
    # without the calibration the distortion is in the residuals, and is told
    assert main([*common, "--out", str(tmp_path / "bent.png")]) == 0
    assert "warning" in capsys.readouterr().out


def test_python_makes_the_same_pictures(wall, tmp_path):
    folder, block, origin, axes = wall
    marks(tmp_path, block, origin, axes)
    (tmp_path / "line").mkdir()
    (tmp_path / "python").mkdir()
    area = (-0.4, -0.3, 0.4, 0.3)
    part = ["--pixel", "0.02", "--extent", *map(str, area), "--progress", "none"]
    all_of_it = [str(folder / "result"), "--photos", str(folder / "photos"), "--out", str(tmp_path / "line" / "a.tif")]
    assert main(["rectify", *all_of_it, *part]) == 0
    done = rb.rectify(
        folder / "result", tmp_path / "python" / "a.tif", photos=folder / "photos", pixel=0.02, extent=area
    )
    assert (done.grid.width, done.grid.height, done.unit) == (40, 30, "m")
    one = [folder / "photos" / "0.png", "--control", tmp_path / "c.csv", "--out", tmp_path / "line" / "b.png"]
    assert main(["rectify", *map(str, one), *part]) == 0
    done = rb.rectify(
        folder / "photos" / "0.png", tmp_path / "python" / "b.png", control=tmp_path / "c.csv", pixel=0.02, extent=area
    )
    assert done.picture.seen.any()
    names = {p.name for p in (tmp_path / "line").iterdir()}
    assert {"a.tif", "a.tfw", "a.toml", "b.png", "b.pgw", "b.toml"} == names
    for name in names:
        assert (tmp_path / "python" / name).read_bytes() == (tmp_path / "line" / name).read_bytes(), name
    with refused("setting.too_small", name="pixel", given="0", least=0):
        rb.rectify(folder / "result", tmp_path / "python" / "c.tif", pixel=0)


def test_four_points_leave_nothing_and_print_no_rounding(tmp_path, capsys):
    Image.fromarray(np.full((300, 400, 3), 120, np.uint8)).save(tmp_path / "w.png")
    (tmp_path / "c.csv").write_text("point,X,Y,Z\na,0,0,\nb,1.37,0,\nc,1.37,0.91,\nd,0,0.91,\n")
    (tmp_path / "c-measurements.csv").write_text(
        "image,point,x_px,y_px\nw.png,a,41.3,262.8\nw.png,b,371.9,251.2\nw.png,c,349.4,33.7\nw.png,d,58.6,41.1\n"
    )
    arguments = [
        "rectify",
        str(tmp_path / "w.png"),
        "--control",
        str(tmp_path / "c.csv"),
        "--out",
        str(tmp_path / "o.png"),
    ]
    assert main([*arguments, "--verbose"]) == 0
    printed = capsys.readouterr().out
    assert "e-1" not in printed
    rows = [line.split() for line in printed.splitlines()]
    assert [row for row in rows if row[0] in "abcd"] == [[n, "0", "0"] for n in "abcd"]


def test_a_wrong_mark_is_named(wall, tmp_path, capsys):
    folder, block, origin, axes = wall
    ids = marks(tmp_path, block, origin, axes, wrong=3)
    calibration = lens(folder, tmp_path)
    assert main([
        "rectify", str(folder / "photos" / "0.png"), "--control", str(tmp_path / "c.csv"), "--out",
        str(tmp_path / "one.jpg"), "--calibration", str(calibration),
    ]) == 0  # fmt: skip
    assert re.search(rf"largest: {ids[3]}\. \[picture\.residuals\]", capsys.readouterr().out)


@pytest.mark.parametrize(
    ("arguments", "message"),
    [
        (["{r}", "--out", "{o}/a.bmp"], "[picture.suffix]"),
        (["{r}", "--out", "{o}/a.png"], "--photos FOLDER"),
        (["{r}", "--out", "{o}/a.png", "--photos", "{p}", "--plane", "nobody,1,2"], "nobody"),
        (["{r}", "--out", "{o}/a.png", "--photos", "{p}", "--pixel", "1e-6"], "[picture.too_large]"),
        (["{r}", "--out", "{o}/a.png", "--photos", "{p}", "--pixel", "100"], "larger than the area"),
        (
            ["{r}", "--out", "{o}/a.png", "--photos", "{p}", "--extent", "50", "50", "51", "51"],
            "[picture.no_photograph]",
        ),
        (["{r}", "--out", "{o}/a.png", "--photos", "{p}", "--only", "x.png"], "x.png. [photograph.not_in_result]"),
        (["{p}/0.png", "--out", "{o}/a.png"], "--control FILE"),
        (["{p}/none.png", "--out", "{o}/a.png"], "no such file"),
    ],
)
def test_bad_input_is_told(wall, tmp_path, capsys, arguments, message):
    folder, *_ = wall
    names = {"r": folder / "result", "p": folder / "photos", "o": tmp_path}
    assert main(["rectify", *(a.format(**names) for a in arguments)]) == 2
    assert message in capsys.readouterr().err
    assert not any(tmp_path.iterdir())


def test_the_plane_that_most_points_lie_in(wall):
    _, block, _, _ = wall
    rng = np.random.default_rng(1)
    xyz = block.points.xyz.copy()
    axes = plane_of(block).axes
    away = rng.choice(len(xyz), len(xyz) // 3, replace=False)
    xyz[away] += np.outer(rng.uniform(0.3, 1, len(away)), axes[2])
    found = plane_of(replace(block, points=replace(block.points, xyz=xyz)))
    assert math.degrees(math.acos(min(1.0, float(found.axes[2] @ axes[2])))) < 0.01
    assert found.points == len(xyz) - len(away)


def relief(rng, *, wall=0.25, n=4000):
    """Points before and behind a wall that a quarter lie in, their sigmas, and the wall's normal."""
    normal = np.array([0.05, 1.0, -0.03]) / np.linalg.norm([0.05, 1.0, -0.03])
    xyz = rng.uniform([-18, -6, 0], [18, 6, 20], (n, 3)) * [1.0, 1.0, 0.9]
    sigma = rng.uniform(0.01, 0.05, (n, 3))
    mine = rng.random(n) < wall
    xyz[mine, 1] = -(xyz[mine, 0] * normal[0] + xyz[mine, 2] * normal[2]) / normal[1]
    xyz += rng.normal(0, sigma)
    return xyz, sigma, mine, normal


def test_the_plane_of_a_quarter_of_the_points_is_found_within_their_sigmas():
    xyz, sigma, mine, normal = relief(np.random.default_rng(3))
    found = plane_of_most(xyz, sigma, 0.005)
    assert math.degrees(math.acos(min(1.0, abs(float(found.normal @ normal))))) < 0.05
    assert found.inliers[mine].mean() > 0.995  # 3.29 sigma: one in a thousand is missed
    # of the others those that lie in it by chance: within 2 x 3.29 x 0.03 m of 12 m
    assert found.inliers[~mine].mean() < 0.03


def test_a_plane_of_few_points_is_a_caution(wall, tmp_path, capsys):
    folder, *_ = wall
    copy = tmp_path / "result"
    shutil.copytree(folder / "result", copy)
    lines = (copy / "points.csv").read_text().splitlines()
    head = lines[0].split(",")
    z = head.index("Z")
    rng = np.random.default_rng(2)
    for k in range(1, len(lines)):
        cells = lines[k].split(",")
        if k % 3:
            cells[z] = f"{float(cells[z]) + rng.uniform(0.5, 4):.4f}"
        lines[k] = ",".join(cells)
    (copy / "points.csv").write_text("\n".join(lines) + "\n")
    arguments = ["rectify", str(copy), "--out", str(tmp_path / "a.png"), "--photos", str(folder / "photos")]
    found = reported(capsys, *arguments)
    plane = values_of(found, ["summary"])["picture.plane"]
    assert (plane["n"], plane["of"]) == (18, 56)
    assert values_of(found, ["warnings"])["picture.few_points_in_plane"] == {"share": 18 / 56}


@pytest.mark.parametrize("given", [{"transformation": "affine"}, {"mark_sigma": 1.0}, {"control": "marks.csv"}])
def test_what_belongs_to_a_photograph_is_refused_with_a_result(wall, tmp_path, given):
    (name,) = given
    with pytest.raises(InputError, match=rf"{name}=.*picture\.setting_of_other_source"):
        rb.rectify(wall[0] / "result", tmp_path / "a.tif", **given)
    assert not list(tmp_path.iterdir())
