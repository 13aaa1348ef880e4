"""Cameras, the camera library, zooms, sheets and codes of targets, projects."""

import math
from pathlib import Path

import numpy as np

from tests.hostile.readers.registry import not_finite, only, place, target, texts

CAMERA = (
    '[cameras.1]\nmodel = "brown"\nwidth_px = 6000\nheight_px = 4000\npixel_mm = [0.006, 0.006]\nc_mm = 24.5\n'
    "x0_mm = 0.01\ny0_mm = -0.02\nK1 = 1e-4\nestimate = []\n"
)
ZOOM = (
    "range_mm = [24.0, 70.0]\nresolution_mm = 0.5\nsettings_mm = [24.0, 50.0, 70.0]\nsquare_sum = 3.5\nredundancy = 4\n"
    '\n[[parameters]]\nsymbol = "c"\nvariable = "f"\ncoefficients = [0.1, 1.0]\n\n[covariance]\nrows = [\n'
    "  [1e-6, 0.0],\n  [0.0, 1e-6],\n]\n"
)
SHEET = (
    'family = "aicon14"\npolarity = "dark"\npaper = "A4"\ndot_radius_mm = 5.0\nring_radii_mm = [10.0, 15.0]\n'
    "\n[[pages]]\nwidth_mm = 210.0\nheight_mm = 297.0\nscale_bar_mm = 100.0\ntargets = [\n"
    '  { name = "3", code = 21, x_mm = 32.0, y_mm = 250.0 },\n'
    '  { name = "4", code = 23, x_mm = 62.0, y_mm = 250.0 },\n]\n'
)


def read_the_cameras(folder: Path) -> list[str]:
    from raybundle.io.block.toml import read_cameras

    return [s for c in read_cameras(only(folder)) for s in not_finite(**c.values)]


def library_seeds(top: Path) -> None:
    from tests.io.test_camera_library import ENTRY, add_entry

    add_entry(ENTRY, place(top))


def read_the_library(folder: Path) -> list[str]:
    from raybundle.io.cameras.library import read_library

    return [s for e in read_library(folder).entries for s in not_finite(**e.camera.values)]


def read_a_zoom(folder: Path) -> list[str]:
    from raybundle.io.cameras.zoom_files import read_zoom

    found = read_zoom(folder)
    return not_finite(coefficients=found.coefficients, covariance=found.covariance)


def read_a_sheet(folder: Path) -> list[str]:
    from raybundle.targets.sidecar import read_sidecar

    found = read_sidecar(only(folder))
    _ = found.target
    return [t.name for t in found.targets if not math.isfinite(t.x_mm + t.y_mm)]


def read_the_codes(folder: Path) -> list[str]:
    from raybundle.targets.codes import read_table

    read_table(only(folder), 12)
    return []


def project_seeds(top: Path) -> None:
    from raybundle.pipeline.project import Project

    folder = place(top)
    project = Project.open(folder)
    row = {"inliers": np.array(3), "kind": np.array("f"), "matches": np.arange(6).reshape(3, 2)}
    project.store_small([(k, row) for k in ("a", "b")])
    project.write_settings('[orient]\nphotos = ["here"]\n')
    with project.stage("features") as stage:
        stage.summary = "two"
    project.db.execute("PRAGMA journal_mode=DELETE")
    project.close()
    (folder / "cache" / ".keep").touch()


def read_a_project(folder: Path) -> list[str]:
    from raybundle.pipeline.project import Project, photographs_of

    photographs_of(folder)
    for create in (False, True):
        project = Project.open(folder, create=create)
        try:
            project.stages()
            project.small(["a", "b"])
        finally:
            project.close()
    return []


target("cameras", texts({"c.toml": CAMERA}), read_the_cameras)
target("library", library_seeds, read_the_library)
target("zoom", texts({"camera.toml": CAMERA, "zoom.toml": ZOOM}), read_a_zoom)
target("sheet", texts({"s.toml": SHEET}, {"s.toml": SHEET.replace('"aicon14"', '"own"\nbits = 12')}), read_a_sheet)
target("codes", texts({"t.csv": "id,code\n1,21\n2,23\n3,27\n"}, {"t.txt": "# mine\n1 21\n2 23\n"}), read_the_codes)
target("project", project_seeds, read_a_project)
