"""A block of two radar scenes of two vendors, from their files to points on the command line."""

import csv

import numpy as np
import pytest

from raybundle.cli.main import main
from raybundle.io.block.folder import read_block, write_block
from raybundle.numerics.places import Local
from raybundle.results.folder import read_result
from tests.scenes.radar_products import TARGET, Product, georef, rcm, terrasar

PIXELS = {"forwards": False, "columns": 2500, "rows": 5000, "line_s": 0.0006}
RCM = Product(ground=True, polynomials=3, **PIXELS)
TSX = Product(off_deg=5.0, heading_deg=192.6, delay_s=2e-8, shift_s=4e-5, near_first=False, **PIXELS)
BLOCK = """
name = "two vendors"

[frame]
kind = "local"
origin = [15.0, 48.0, 300.0]

[cameras.rcm]
model = "range_doppler"
scene = "scenes/product.xml"
sigma = {dr = 5.0, dt = 5e-4}

[cameras.tsx]
model = "range_doppler"
scene = "scenes/TSX1/TSX1_SAR.xml"
sigma = {dr = 5.0, dt = 5e-4}
"""


def table(path, head, rows):
    with path.open("w", newline="") as file:
        csv.writer(file).writerows([head.split(","), *rows])


@pytest.fixture(scope="module")
def folder(tmp_path_factory):
    """The block: 60 points, the first four are control; 0.2 px, 0.2 m; the first scene's ranges are 3 px too long."""
    folder = tmp_path_factory.mktemp("radar") / "block"
    (folder / "scenes/TSX1/ANNOTATION").mkdir(parents=True)
    (folder / "scenes/product.xml").write_text(rcm(RCM))
    (folder / "scenes/TSX1/TSX1_SAR.xml").write_text(terrasar(TSX))
    (folder / "scenes/TSX1/ANNOTATION/GEOREF.xml").write_text(georef(TSX))
    (folder / "block.toml").write_text(BLOCK)
    rng = np.random.default_rng(3)
    xyz = points()
    ground = Local(origin=TARGET).geographic_from_block(xyz)
    rows = []
    for k, (product, offset) in enumerate(((RCM, [3.0, 0.0]), (TSX, [0.0, 0.0])), 1):
        xy = product.project(ground)[2] + offset + rng.normal(0, 0.2, (len(xyz), 2))
        rows += [[k, i, *p, 0.2, 0.2] for i, p in enumerate(xy.tolist())]
    table(folder / "observations.csv", "image,point,x_px,y_px,sx_px,sy_px", rows)
    control = xyz[:4] + rng.normal(0, 0.2, (4, 3))
    rows = [[i, "control", *p, 0.2, 0.2, 0.2] for i, p in enumerate(control.tolist())]
    table(folder / "points.csv", "point,role,X,Y,Z,sX,sY,sZ", rows)
    head = "image,camera,file,X,Y,Z,omega_deg,phi_deg,kappa_deg"
    table(folder / "images.csv", head, [[1, "rcm", *[""] * 7], [2, "tsx", *[""] * 7]])
    return folder


def points():
    return np.random.default_rng(2).uniform([-1200, -3000, -100], [1200, 3000, 200], (60, 3))


def test_two_radar_scenes_of_two_vendors_are_adjusted(folder, tmp_path):
    assert main(["adjust", str(folder), "--out", str(tmp_path / "out"), "--progress", "none"]) == 0
    found = read_result(tmp_path / "out")
    result = found.result
    assert 0.8 < result["sigma0"] < 1.2
    slope = 0.55 + 7e-7 * 3000  # of the slant range by the ground range of a column
    dr, own = (result["cameras"][k]["dr"] for k in ("rcm", "tsx"))
    assert abs(dr["value"] - 3 * RCM.spacing_m * slope) < 4 * dr["std"]
    assert abs(own["value"]) < 4 * own["std"]
    with (tmp_path / "out/points.csv").open() as file:
        table = {int(r["point"]): r for r in csv.DictReader(file)}
    off = np.array([
        [(float(table[k][a]) - v) / float(table[k][f"s{a}"]) for a, v in zip("XYZ", p, strict=True)]
        for k, p in enumerate(points().tolist()) if k >= 4
    ])  # fmt: skip
    assert 0.7 < np.sqrt(np.mean(off**2)) < 1.3


def test_delays_beside_a_scene_are_kept_with_the_block(folder, tmp_path):
    block = read_block(folder)
    write_block(block, tmp_path / "again")
    again = read_block(tmp_path / "again")
    ground = np.array([TARGET])
    for before, after in zip(block.cameras, again.cameras, strict=True):
        one, other = before.scene.scene, after.scene.scene
        assert (one.project(ground) == other.project(ground)).all()
