"""Calibrations of other programs."""

import shutil
from pathlib import Path

from tests.hostile.readers.registry import not_finite, only, place, target


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
