"""Every reader of a file, with small valid inputs that it makes itself, for the fuzzer.

A reader takes the folder of one input and returns what is wrong with what it accepted (numbers that are not finite,
indices out of range, ...); it raises errors of raybundle and no others.
"""

import contextlib
import csv
import functools
import io
import json
import math
import shutil
import struct
from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path

import numpy as np

from raybundle.errors import RaybundleError


@dataclass(frozen=True, kw_only=True)
class Target:
    """A reader with its seeds."""

    name: str
    seeds: Callable[[Path], None]
    """Fills a new folder with folders 0, 1, ... of one valid input each."""
    read: Callable[[Path], list[str]]
    slow: bool = False
    """Takes more than some 20 ms an input."""


TARGETS: dict[str, Target] = {}


def target(name: str, seeds, read, *, slow: bool = False) -> None:
    TARGETS[name] = Target(name=name, seeds=seeds, read=read, slow=slow)


def place(top: Path, number: int = 0) -> Path:
    folder = top / str(number)
    folder.mkdir(parents=True)
    return folder


def texts(*inputs: dict[str, str | bytes]):
    """Seeds that are texts."""

    def write(top: Path) -> None:
        for k, files in enumerate(inputs):
            folder = place(top, k)
            for name, text in files.items():
                (folder / name).write_bytes(text if isinstance(text, bytes) else text.encode())

    return write


def only(folder: Path, *, but: str = "") -> Path:
    """The file of an input."""
    return min(folder.iterdir(), key=lambda p: (bool(but) and p.name.endswith(but), p.name))


def not_finite(**values) -> list[str]:
    return [name for name, value in values.items() if not np.isfinite(np.asarray(value, float)).all()]


def wrong_in_block(block) -> list[str]:
    wrong = not_finite(xy=block.observations.xy_px, cov=block.observations.cov_px2)
    for camera in block.cameras:
        wrong += not_finite(**{f"camera {s}": v for s, v in camera.values.items()})
        if min(camera.width_px, camera.height_px) <= 0:
            wrong.append("format")
    R = block.images.rotation[block.images.oriented]
    if len(R) and not np.allclose(R @ np.swapaxes(R, 1, 2), np.eye(3), atol=1e-6):
        wrong.append("rotation")
    o = block.observations
    if len(o) and not (0 <= o.image.min() <= o.image.max() < len(block.images)):
        wrong.append("image index")
    if len(o) and not (0 <= o.point.min() <= o.point.max() < len(block.points)):
        wrong.append("point index")
    return wrong


@functools.cache
def small_block():
    from raybundle.block.simulate import Survey, TargetField, brown_camera, field_scene, simulate

    camera = brown_camera(values=dict.fromkeys(("K2", "K3", "P1", "P2"), 0.0))
    plan = TargetField(camera=camera, stations=3, frontal=2, rows=3, columns=4)
    return simulate(field_scene(plan), Survey(control=4, control_sigma=(1e-3, 1e-3, 1e-3)))


# --- blocks, results, formats -------------------------------------------------------------------------------------


def block_seeds(top: Path) -> None:
    from raybundle.io.block_folder import write_block

    write_block(small_block().observed, place(top) / "b")
    for file in (top / "0" / "b").iterdir():
        file.rename(top / "0" / file.name)
    (top / "0" / "b").rmdir()


def scene_block_seeds(top: Path) -> None:
    from raybundle.io.block_folder import write_block
    from tests.truth.mixed_blocks import ikonos_pair, two_camera_rig

    for k, block in enumerate((ikonos_pair(points=12, check=2), two_camera_rig(stations=2))):
        folder = write_block(block, top / str(k))
        del folder


def read_a_block(folder: Path) -> list[str]:
    from raybundle.io.block_folder import read_block

    return wrong_in_block(read_block(folder))


def command(*arguments) -> tuple[int, str]:
    from raybundle.cli.main import main

    out, err = io.StringIO(), io.StringIO()
    with contextlib.redirect_stdout(out), contextlib.redirect_stderr(err):
        status = main([*map(str, arguments)])
    if status == 1:
        raise AssertionError(err.getvalue()[-200:])
    return status, out.getvalue()


NAMES = {"point", "role", "image", "camera", "file"}
"""Columns that hold names; a point may be called nan."""


def adjusted(folder: Path, *, report: bool) -> list[str]:
    out = folder.parent / "result"
    shutil.rmtree(out, ignore_errors=True)
    status, _ = command("adjust", folder, "--out", out, "--threads", "1", *([] if report else ["--no-report"]))
    if status != 0:
        return []
    sigma0 = json.loads((out / "result.json").read_text())["sigma0"]
    wrong = [] if sigma0 is not None and math.isfinite(sigma0) else [f"sigma0 {sigma0}"]
    for name in ("points.csv", "images.csv"):
        with (out / name).open(encoding="utf-8", newline="") as file:
            for row in csv.DictReader(file):
                wrong += [f"{name}: {k} {v}" for k, v in row.items() if k not in NAMES and v in {"nan", "inf", "-inf"}]
    return wrong


def format_seeds(name: str):
    def write(top: Path) -> None:
        from raybundle.io.formats import Export, formats, write_format

        write_format(name, Export(block=small_block().truth), place(top) / f"m{formats[name].suffix}")

    return write


def read_a_format(name: str):
    def read(folder: Path) -> list[str]:
        from raybundle.io.formats import formats, read_format

        return wrong_in_block(read_format(name, folder / f"m{formats[name].suffix}").block)

    return read


def result_seeds(top: Path) -> None:
    from raybundle.report.result_folder import write_result
    from raybundle.workflows.adjust import adjust

    write_result(adjust(small_block().observed), place(top) / "r", report="none")


def read_a_result(folder: Path) -> list[str]:
    from raybundle.cli.convert import read_source

    return wrong_in_block(read_source(folder / "r", None)[0].block)


def converted(folder: Path) -> list[str]:
    out = folder.parent / "converted"
    shutil.rmtree(out, ignore_errors=True)
    command("convert", folder, "--to", "colmap-text", "--out", out)
    return []


target("block", block_seeds, read_a_block)
target("block-scenes", scene_block_seeds, read_a_block, slow=True)
target("adjust", block_seeds, functools.partial(adjusted, report=False), slow=True)
target("adjust-scenes", scene_block_seeds, functools.partial(adjusted, report=False), slow=True)
target("report", block_seeds, functools.partial(adjusted, report=True), slow=True)
target("convert", block_seeds, converted, slow=True)
target("result", result_seeds, read_a_result, slow=True)
for _name in ("bingo", "colmap", "colmap-text", "metashape", "nerfstudio", "opensfm", "opf", "patb"):
    target(f"format-{_name}", format_seeds(_name), read_a_format(_name))


# --- calibrations -------------------------------------------------------------------------------------------------


def wrong_in_calibrations(found) -> list[str]:
    wrong: list[str] = []
    for calibration in found:
        camera = calibration.camera
        names = ("fx", "fy", "cx", "cy", "k1", "k2", "p1", "p2")
        values = camera.values if hasattr(camera, "values") else {n: getattr(camera, n) for n in names}
        wrong += not_finite(**{n: v for n, v in values.items() if v is not None})
        if min(camera.width_px, camera.height_px) <= 0:
            wrong.append("format")
        if calibration.covariance is not None:
            wrong += not_finite(covariance=calibration.covariance)
    return wrong


def calibration_seeds(name: str):
    def write(top: Path) -> None:
        from raybundle.io.calibrations import Calibration, calibration_formats
        from tests.io import test_calibrations as own

        camera = own.OURS if calibration_formats[name].model != "forward" else own.FORWARD
        own.written(Calibration(id="1", camera=camera), name, place(top))
        more = MORE_CALIBRATIONS.get(name)
        if more is not None:
            (place(top, 1) / more[0]).write_text(more[1])

    return write


MORE_CALIBRATIONS = {
    "opencv": (
        "i.yaml",
        ("image_width: 640\nimage_height: 480\ncamera_name: left  # of two\ncamera_matrix:\n  rows: 3\n  cols: 3\n"
         "  data: [530.5, 0., 319.5, 0, 531.5, 239.5, 0, 0, 1]\ndistortion_model: plumb_bob\n"
         "distortion_coefficients: {rows: 1, cols: 5, data: [-0.3, .1, 1e-3, -1e-3, 0]}\n"),
    ),
    "kalibr": (
        "c.yaml",
        ("cam0:\n  camera_model: pinhole\n  distortion_coeffs: [-0.28, 0.07, 0.0002, 1.7e-05]\n"
         "  distortion_model: radtan\n  intrinsics: [458.6, 457.3, 367.2, 248.4]\n  resolution: [752, 480]\n"
         "cam1:\n  T_cn_cnm1:\n  - [1.0, 0.0, 0.0, 0.1]\n  - [0.0, 1.0, 0.0, 0.0]\n  - [0.0, 0.0, 1.0, 0.0]\n"
         "  - [0.0, 0.0, 0.0, 1.0]\n  camera_model: pinhole\n  distortion_coeffs: [0.01, 0.0, 0.0, 0.0]\n"
         "  distortion_model: equidistant\n  intrinsics: [458.6, 457.3, 367.2, 248.4]\n  resolution: [752, 480]\n"),
    ),
    "mrcal": (
        "a.cameramodel",
        ("{\n 'lensmodel': 'LENSMODEL_OPENCV4',\n # fx fy cx cy\n 'intrinsics': [ 1761.1, 1761.2, 965.7, 587.5, -0.01, "
         "0.05, -0.0001, 0.0002,],\n 'extrinsics': [0,0,0,0,0,0],\n 'imagersize': [1900, 1200],\n}\n"),
    ),
}  # fmt: skip
CALIBRATIONS = (
    "australis", "colmap", "kalibr", "metashape", "micmac", "mrcal", "opencv", "opencv-fisheye", "photomodeler",
    "raybundle",
)  # fmt: skip


def read_a_calibration(name: str):
    def read(folder: Path) -> list[str]:
        from raybundle.io.calibrations import read_calibrations

        return wrong_in_calibrations(read_calibrations(only(folder), name))

    return read


def every_calibration(top: Path) -> None:
    for k, name in enumerate(CALIBRATIONS):
        calibration_seeds(name)(top / f"_{k}")
        (top / f"_{k}" / "0").rename(top / str(k))
        shutil.rmtree(top / f"_{k}")


def recognised_calibration(folder: Path) -> list[str]:
    from raybundle.io.calibrations import convert_calibration, read_calibrations

    for calibration in read_calibrations(only(folder))[:1]:
        convert_calibration(calibration, "opencv")
    return []


for _name in CALIBRATIONS:
    target(f"calibration-{_name}", calibration_seeds(_name), read_a_calibration(_name))
target("calibration", every_calibration, recognised_calibration)


# --- scenes, trajectories -----------------------------------------------------------------------------------------


@functools.cache
def small_rpc():
    from raybundle.scenes.rpc_fit import fit_rpc
    from tests.scenes.conftest import make_scene

    scene = make_scene()
    return fit_rpc(scene.localise, (scene.width_px, scene.height_px), (-100.0, 900.0)).rpc


def rpc_text_seeds(top: Path) -> None:
    from raybundle.io.scenes.rpc_text import write_rpc_text

    write_rpc_text(small_rpc(), place(top) / "a_RPC.TXT")


def rpb_seeds(top: Path) -> None:
    from tests.scenes.test_readers import rpb

    for k, kind in enumerate(("RPC00B", "RPC00A")):
        (place(top, k) / "a.RPB").write_text(rpb(small_rpc(), kind))


def tiff_seeds(top: Path) -> None:
    from tests.scenes.test_readers import tiff

    (place(top, 0) / "a.tif").write_bytes(tiff(small_rpc()))
    (place(top, 1) / "a.tif").write_bytes(tiff(small_rpc(), ">", big=True))


def nitf_seeds(top: Path) -> None:
    from tests.scenes.test_readers import nitf

    (place(top) / "a.ntf").write_bytes(nitf(small_rpc()))


def dimap_seeds(top: Path) -> None:
    from tests.scenes.test_dimap_orbit import PLAN, orbit_scene, product
    from tests.scenes.test_readers import dimap

    (place(top, 0) / "RPC_a.XML").write_text(dimap(small_rpc()))
    (place(top, 1) / "DIM_a.XML").write_text(product(orbit_scene(PLAN)))


def spot_seeds(top: Path) -> None:
    from tests.scenes.test_spot import document

    (place(top) / "METADATA.DIM").write_text(document())


def maxar_seeds(top: Path) -> None:
    from tests.scenes.test_readers import KEYS, offsets

    rpc = small_rpc()
    off, scale = offsets(rpc)
    pairs = "".join(f"<{k}OFFSET>{float(v)!r}</{k}OFFSET>" for k, v in zip(KEYS, off, strict=True))
    pairs += "".join(f"<{k}SCALE>{float(v)!r}</{k}SCALE>" for k, v in zip(KEYS, scale, strict=True))
    names = ("LINENUMCOEF", "LINEDENCOEF", "SAMPNUMCOEF", "SAMPDENCOEF")
    rows = "".join(
        f"<{n}List><{n}>{' '.join(repr(float(c)) for c in row)}</{n}></{n}List>"
        for n, row in zip(names, rpc.coefficients, strict=True)
    )
    text = (
        "<isd><IMD><NUMROWS>7000</NUMROWS><NUMCOLUMNS>8000</NUMCOLUMNS><IMAGE><SATID>X</SATID>"
        "<FIRSTLINETIME>2020-01-01T00:00:00.000000Z</FIRSTLINETIME></IMAGE></IMD>"
        f"<RPB><SPECID>RPC00B</SPECID><IMAGE><ERRBIAS>3.5</ERRBIAS><ERRRAND>0.2</ERRRAND>{pairs}{rows}</IMAGE></RPB></isd>"
    )
    (place(top) / "a.XML").write_text(text)


def csm_seeds(top: Path) -> None:
    n = 9
    turned = [[0.0, 0.0, 0.0, 1.0]] * n
    isd = {
        "name_model": "USGS_ASTRO_LINE_SCANNER_SENSOR_MODEL", "name_sensor": "TEST", "center_ephemeris_time": 1000.0,
        "starting_ephemeris_time": 999.2, "line_scan_rate": [[0.5, -0.85, 0.1]], "detector_sample_summing": 1,
        "detector_line_summing": 1, "t0_ephemeris": -0.8, "dt_ephemeris": 0.2, "t0_quaternion": -0.8,
        "dt_quaternion": 0.2, "focal2pixel_lines": [0.0, 10.0, 0.0], "focal2pixel_samples": [0.0, 0.0, 10.0],
        "focal_length_model": {"focal_length": 50}, "image_lines": 16, "image_samples": 16,
        "detector_center": {"line": 0.5, "sample": 8.0}, "interpolation_method": "lagrange",
        "optical_distortion": {"radial": {"coefficients": [0.0, 0.0, 0.0]}},
        "radii": {"semimajor": 1000.0, "semiminor": 1000.0, "unit": "km"},
        "reference_height": {"maxheight": 1000, "minheight": -1000, "unit": "m"},
        "instrument_position": {
            "unit": "km", "positions": [[1050.0, 0.1 * k, 1.0 * k] for k in range(n)],
            "velocities": [[0.0, 0.5, 5.0]] * n, "reference_frame": 1,
        },
        "instrument_pointing": {"quaternions": turned}, "body_rotation": {"quaternions": turned},
        "starting_detector_line": 0, "starting_detector_sample": 0,
        "sun_position": {"positions": [[0.1, 0.1, 0.0]], "velocities": [[0.0, 0.0, 0.0]], "unit": "km"},
    }  # fmt: skip
    (place(top) / "a.json").write_text(json.dumps(isd))


def airborne_seeds(top: Path) -> None:
    from tests.scenes.test_airborne import write_strip

    folder = place(top)
    write_strip(folder, "strip1", 30.0)
    rows = (folder / "strip1.csv").read_text().splitlines()
    (folder / "strip1.csv").write_text("\n".join([rows[0], *rows[1::40]]) + "\n")


def read_a_scene(folder: Path) -> list[str]:
    from raybundle.io.scenes import read_scene

    scene = read_scene(only(folder, but=".csv"))
    wrong: list[str] = []
    if scene.rpc is not None:
        names = ("coefficients", "ground_offset", "ground_scale", "image_offset", "image_scale")
        wrong += not_finite(**{n: getattr(scene.rpc, n) for n in names})
        if not (scene.rpc.ground_scale.all() and scene.rpc.image_scale.all()):
            wrong.append("scale 0")
    if scene.line is not None:
        with contextlib.suppress(RaybundleError):
            scene.line.project(np.array([[11.0, 48.0, 0.0]]))
    return wrong


for _name, _seeds in (
    ("rpc-text", rpc_text_seeds), ("rpb", rpb_seeds), ("tiff", tiff_seeds), ("nitf", nitf_seeds),
    ("dimap", dimap_seeds), ("spot", spot_seeds), ("maxar", maxar_seeds), ("csm", csm_seeds),
    ("airborne", airborne_seeds),
):  # fmt: skip
    target(f"scene-{_name}", _seeds, read_a_scene)


def trajectory_seeds(top: Path) -> None:
    from tests.io.trajectories.test_trajectories import MRK

    texts(
        {"flight_Timestamp.MRK": MRK},
        {"eo.csv": "image,X,Y,Z,omega_gon,phi_gon,kappa_gon,sX,sY,sZ\na,500000,5400000,1200,1,-2,100,0.02,0.02,0.04\n"},
        {"ins.csv": "image,X,Y,Z,roll_deg,pitch_deg,yaw_deg\na,500000,5400000,1200,0,0,0\n"},
        {"gim.csv": "image,longitude_deg,latitude_deg,height_m,roll_deg,pitch_deg,yaw_deg\na,11.2,48.1,1200,0,0,0\n"},
    )(top)


def read_a_trajectory(folder: Path) -> list[str]:
    from raybundle.io.trajectories import read_trajectory

    found = read_trajectory(only(folder))
    wrong = ["xyz"] if np.isinf(found.xyz).any() else []
    return wrong + (["sigma"] if np.isinf(found.sigma).any() or (found.sigma < 0).any() else [])


target("trajectory", trajectory_seeds, read_a_trajectory)


# --- control, film, tables ----------------------------------------------------------------------------------------


def control_seeds(top: Path) -> None:
    from tests.io.test_control_files import CSV, GCP, MEASURED

    texts({"gcp_list.txt": GCP}, {"c.csv": CSV, "c-measurements.csv": MEASURED})(top)


def read_the_control(folder: Path) -> list[str]:
    from raybundle.io.control_files import read_control

    found = read_control(only(folder, but="-measurements.csv"))
    return (["xyz"] if np.isinf(found.xyz).any() else []) + (["sigma"] if np.isinf(found.sigma).any() else [])


def fiducial_seeds(top: Path) -> None:
    from tests.io.test_fiducials import EIGHT, NAMES

    rows = "".join(f"{n},{x},{y},0.002,0.002\n" for n, (x, y) in zip(NAMES, EIGHT, strict=True))
    texts({"c.csv": "mark,x_mm,y_mm,sx_mm,sy_mm\n" + rows})(top)


def read_the_fiducials(folder: Path) -> list[str]:
    from raybundle.io.fiducials import read_calibrated

    return not_finite(xy=read_calibrated(only(folder)).xy_mm)


def mark_seeds(top: Path) -> None:
    from tests.io.test_fiducials import EIGHT, NAMES, scanned

    rows = "".join(f"s,{n},{x:.3f},{y:.3f}\n" for n, (x, y) in zip(NAMES, scanned(EIGHT), strict=True))
    texts({"m.csv": "image,mark,x_px,y_px\n" + rows})(top)


def read_the_marks(folder: Path) -> list[str]:
    from raybundle.io.fiducials import read_marks
    from tests.io.test_fiducials import FIDUCIALS

    read_marks(only(folder), "mark", FIDUCIALS)
    return []


def crs_seeds(top: Path) -> None:
    texts({"c.txt": "EPSG:32633"}, {"c.txt": "+proj=utm +zone=11 +datum=WGS84"}, {"c.txt": "WGS84 UTM 33N"})(top)


def read_a_crs(folder: Path) -> list[str]:
    from raybundle.io.coordinate_systems import local_frame, parse_crs

    text = only(folder).read_bytes().decode("utf-8", "surrogateescape")
    parse_crs(text)
    local_frame(text, (500000.0, 5300000.0, 500.0))
    return []


def empirical_seeds(top: Path) -> None:
    k = np.arange(12)
    rows = zip(
        k, np.cos(k) * 10 + 20, np.sin(k * 1.7) * 10, k * 0.1, 300 + 100 * np.cos(k), 400 + np.sin(k), strict=True
    )
    lines = "".join(",".join(f"{v:.4f}" if j else str(v) for j, v in enumerate(row)) + ",\n" for row in rows)
    texts({"p.csv": "point,X,Y,Z,x_px,y_px,role\n" + lines})(top)


def read_empirical_points(folder: Path) -> list[str]:
    from raybundle.cli.empirical import _points

    _points(only(folder))
    return []


target("control", control_seeds, read_the_control)
target("fiducials", fiducial_seeds, read_the_fiducials)
target("film-marks", mark_seeds, read_the_marks)
target("crs", crs_seeds, read_a_crs, slow=True)
target("empirical", empirical_seeds, read_empirical_points)


# --- cameras, targets, projects -----------------------------------------------------------------------------------

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
    from raybundle.io.block_toml import read_cameras

    return [s for c in read_cameras(only(folder)) for s in not_finite(**c.values)]


def library_seeds(top: Path) -> None:
    from tests.io.test_camera_library import ENTRY, add_entry

    add_entry(ENTRY, place(top))


def read_the_library(folder: Path) -> list[str]:
    from raybundle.io.camera_library import read_library

    return [s for e in read_library(folder).entries for s in not_finite(**e.camera.values)]


def read_a_zoom(folder: Path) -> list[str]:
    from raybundle.io.zoom_files import read_zoom

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
    from raybundle.io.project import Project

    folder = place(top)
    project = Project.open(folder)
    project.store_pairs([(k, {"inliers": 3, "kind": "f"}, np.arange(6).reshape(3, 2)) for k in ("a", "b")])
    project.write_settings('[orient]\nphotos = ["here"]\n')
    with project.stage("features") as stage:
        stage.summary = "two"
    project.db.execute("PRAGMA journal_mode=DELETE")
    project.close()
    (folder / "cache" / ".keep").touch()


def read_a_project(folder: Path) -> list[str]:
    from raybundle.io.project import Project, photographs_of

    photographs_of(folder)
    for create in (False, True):
        project = Project.open(folder, create=create)
        try:
            project.stages()
            project.pairs(["a", "b"])
        finally:
            project.close()
    return []


target("cameras", texts({"c.toml": CAMERA}), read_the_cameras)
target("library", library_seeds, read_the_library)
target("zoom", texts({"camera.toml": CAMERA, "zoom.toml": ZOOM}), read_a_zoom)
target("sheet", texts({"s.toml": SHEET}, {"s.toml": SHEET.replace('"aicon14"', '"own"\nbits = 12')}), read_a_sheet)
target("codes", texts({"t.csv": "id,code\n1,21\n2,23\n3,27\n"}, {"t.txt": "# mine\n1 21\n2 23\n"}), read_the_codes)
target("project", project_seeds, read_a_project)


# --- photographs and videos ---------------------------------------------------------------------------------------

XMP = (
    b'<?xpacket begin="" id="W5M0MpCehiHzreSzNTczkc9d"?><x:xmpmeta xmlns:x="adobe:ns:meta/"><rdf:RDF '
    b'xmlns:rdf="http://www.w3.org/1999/02/22-rdf-syntax-ns#"><rdf:Description rdf:about="" '
    b'xmlns:drone-dji="http://www.dji.com/drone-dji/1.0/" drone-dji:RtkFlag="50" drone-dji:RtkStdLon="0.01" '
    b'drone-dji:RtkStdHgt="0.02" drone-dji:GimbalYawDegree="+12.3" drone-dji:GimbalPitchDegree="-90" '
    b'drone-dji:GimbalRollDegree="0" drone-dji:AbsoluteAltitude="+512.3" '
    b'drone-dji:DewarpData="2022-06-08;3713.29,3713.29,7.02,-8.72,-0.11,0.01,-0.0001,0,0.0"><drone-dji:GpsLatitude>48.1'
    b"</drone-dji:GpsLatitude></rdf:Description></rdf:RDF></x:xmpmeta>"
)


def photo_seeds(suffix: str):
    def write(top: Path) -> None:
        from PIL import Image

        from tests.io.photos.test_photo_files import save, scene

        exif = Image.Exif()
        exif[0x0112], exif[0x010F], exif[0x0110] = 6, "Mäker", "M1"
        exif.get_ifd(0x8769).update({0x920A: 5.0, 0xA405: 28, 0x9003: "2024:05:06 07:08:09"})
        exif.get_ifd(0x8825).update({1: "N", 2: (48.0, 7.0, 3.2), 3: "E", 4: (11.0, 7.0, 3.2), 6: 500.0})
        save(place(top, 0) / f"a.{suffix}", scene(40, 40), exif=exif)
        if suffix == "jpg":
            save(place(top, 1) / "a.jpg", scene(40, 40), exif=exif, xmp=XMP)
        elif suffix in {"png", "tif"}:
            wide = (np.arange(1600).reshape(40, 40) * 40).astype(np.uint16)
            Image.fromarray(wide).save(place(top, 1) / f"a.{suffix}")

    return write


def read_a_photograph(folder: Path) -> list[str]:
    from raybundle.io.photos.cameras import camera_groups, camera_of
    from raybundle.io.photos.photo import find_photos, read_grey
    from raybundle.io.photos.windows import is_tiff, tiff_tags

    file = only(folder)
    wrong: list[str] = []
    found = find_photos([folder])  # a bad file costs that file: no exception here
    for photo in found.photos:
        for camera in map(camera_of, camera_groups([photo])):
            wrong += not_finite(**camera.values, **{f"sigma {s}": v for s, v in camera.sigma.items()})
            if camera.values["c"] <= 0 or any(v <= 0 for v in camera.sigma.values()):
                wrong.append("c or a sigma is not positive")
        gps = photo.metadata.gps
        if gps is not None:
            wrong += not_finite(latitude=gps.latitude_deg, longitude=gps.longitude_deg, altitude=gps.altitude_m or 0.0)
        read_grey(photo)
    if is_tiff(file):
        tiff_tags(file)
    return wrong


def read_metadata_of_xmp(folder: Path) -> list[str]:
    from raybundle.io.photos.read_metadata import read_metadata

    metadata, _ = read_metadata(None, only(folder).read_bytes())
    sigma = metadata.gps.sigma_m if metadata.gps is not None else None
    return [] if sigma is None or all(s > 0 for s in sigma if not math.isnan(s)) else ["sigma"]


def movie_seeds(top: Path) -> None:
    from tests.io.photos.test_video_frames import PHONE, box, movie

    said = {b"\xa9mak": b"Maker", b"\xa9mod": b"Action 7", b"\xa9xyz": b"+47.5+008.25/"}
    boxes = [box(k, struct.pack(">HH", len(v), 0), v) for k, v in said.items()]
    texts({"a.mov": movie(PHONE)}, {"a.mp4": movie(box(b"udta", *boxes), creation=0)})(top)


def read_a_movie(folder: Path) -> list[str]:
    from raybundle.io.photos.movie import read_movie_metadata

    position = read_movie_metadata(only(folder)).position
    return [] if position is None else not_finite(position=[v for v in position if v is not None])


def video_seeds(top: Path) -> None:
    import cv2

    writer = cv2.VideoWriter(str(place(top) / "a.mp4"), cv2.VideoWriter_fourcc(*"mp4v"), 10, (64, 48))
    noise = np.random.default_rng(0).integers(0, 255, (48, 200, 3), dtype=np.uint8)
    for k in range(8):
        writer.write(np.ascontiguousarray(noise[:, 4 * k : 4 * k + 64]))
    writer.release()


def read_a_video(folder: Path) -> list[str]:
    from raybundle.io.photos.video import FrameOptions, extract_frames

    out = folder.parent / "frames"
    shutil.rmtree(out, ignore_errors=True)
    extract_frames(only(folder), out, FrameOptions(count=2))
    return []


for _name in ("jpg", "png", "tif", "webp"):
    target(f"photo-{_name}", photo_seeds(_name), read_a_photograph)
target("xmp", texts({"x.xmp": XMP}), read_metadata_of_xmp)
target("movie", movie_seeds, read_a_movie)
target("video", video_seeds, read_a_video, slow=True)
