"""What a program that uses the package looks like: every call as a stranger writes it, and what type it gives.

It is checked, not run: by basedpyright and mypy at their strictest, against the package as it is installed.  What a
call gives is asserted, so that a type that is lost on the way (Any, object) is an error.
"""

from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Any, assert_type

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure, SubFigure
from numpy.typing import NDArray

import raybundle as rb

Array = NDArray[Any]


def adjusted(folder: Path) -> rb.Adjustment:
    """A block, its options, its adjustment."""
    block = rb.read_block(folder)
    assert_type(block, rb.Block)
    assert_type(block.cameras[0], rb.Camera)
    assert_type(block.cameras[0].values["c"], float)
    assert_type(block.points.xyz, Array)
    assert_type(block.images, rb.Images)
    assert_type(block.observations, rb.Observations)
    assert_type(block.distances, rb.Distances)
    assert_type(block.points.rows(np.array([0, 1])), rb.Points)
    options = rb.AdjustmentOptions(datum="inner", estimate="auto", free=(("1", "K3"),))
    result = rb.adjust(block, options)
    assert_type(result, rb.Adjustment)
    assert_type(result.sigma0, float)
    assert_type(result.adjusted.points.ids, tuple[str, ...])
    if result.precision is not None:
        assert_type(result.precision.object_point_std, Array)
    for interior in result.interior:
        parameter = interior.parameters["c"]
        assert_type(parameter.value, float)
        assert_type(parameter.std, float | None)
    for notice in result.notices:
        assert_type(notice.message, str)
    return result


def told(seconds: str, share: float) -> None:
    """Takes the progress."""
    assert_type((seconds, share), tuple[str, float])


def from_photographs(photos: Path, out: Path) -> None:
    """Photographs to blocks, calibrations and coordinates."""
    oriented = rb.orient(photos, out, progress=told, control="control.csv")
    assert_type(oriented, rb.Orientation)
    assert_type(oriented.adjustment, rb.Adjustment)
    assert_type(oriented.oriented, int)
    calibrated = rb.calibrate([photos / "1.jpg", photos / "2.jpg"], out / "camera", target=("chessboard-9x6",))
    assert_type(calibrated, rb.Calibration)
    assert_type(calibrated.quality[0].camera, str)
    assert_type(calibrated.opencv().K, Array)
    measured = rb.measure(photos, out / "part")
    assert_type(measured.adjustment, rb.Adjustment)
    found = rb.detect_targets(str(photos), "april-36h11")
    for name, marks in found.items():
        assert_type(name, str)
        assert_type(marks.xy_px, Array)
        assert_type(marks.name, tuple[str, ...])
    converted = rb.convert(out, out / "model", to="colmap")
    assert_type(converted, rb.Converted)
    assert_type(converted.written, tuple[tuple[str, Path], ...])
    rectified = rb.rectify(out, out / "facade.tif", pixel=0.002)
    assert_type(rectified, rb.Rectification)
    assert_type(rectified.remarks, tuple[str, ...])


def statistics(result: rb.Adjustment) -> Mapping[str, float]:
    """Questions to a result."""
    answers = rb.query(result, distance=("1", "2"))
    assert_type(answers[0].values, tuple[float, ...])
    assert_type(answers[0].covariance, Array)
    assert_type(rb.table_names(result), tuple[str, ...])
    points = rb.table(result, "points")
    assert_type(points, NDArray[np.void])
    assert_type(len(points), int)
    named = rb.covariance(result, ["point 1:X", "point 2:X"])
    assert_type(named, rb.NamedCovariance)
    assert_type(named.matrix, Array)
    whole = rb.matrices(result)
    assert_type(whole, rb.Matrices)
    assert_type(whole.residuals, Array)
    assert_type(whole.unknowns, tuple[str, ...])
    rb.write_matrices(whole, "matrices")
    assert_type(rb.projection_uncertainty(result, [(0.0, 0.0), (100.0, 50.0)], distance=5.0), Array)
    assert_type(rb.projection_uncertainty(result, np.zeros((4, 2)), camera="1"), Array)
    camera = result.opencv("1", coefficients=5)
    assert_type(camera, rb.OpenCVCamera)
    assert_type(camera.distortion, Array)
    assert_type(camera.covariance, Array)
    return named.std


def figures(result: rb.Adjustment, page: Figure, part: SubFigure) -> Sequence[Axes]:
    """Figures, and into parts of others."""
    assert_type(rb.plot_network(result), Figure)
    assert_type(rb.plot_residuals(result, camera="1"), Figure)
    assert_type(rb.plot_interior(result, camera="1", image=None), Figure)
    assert_type(rb.plot_control(result), Figure)
    assert_type(rb.plot_residuals(result, figure=page), Figure)
    whole = rb.plot_reliability(result, figure=part)
    assert_type(whole, Figure)
    return whole.axes


def plans(out: Path) -> None:
    """What will be determined."""
    plan = rb.plan_network("box 4 x 3 x 2", out, sigma=0.5)
    assert_type(plan.wanted, float | None)
    assert_type(plan.map_sigma, Array)
    expected = rb.plan_flight(rb.Flight(camera=rb.read_block(out).cameras[0], lines=3, photographs=5))
    assert_type(expected.planned.sigma_m, Array)
    if expected.advised is not None:
        assert_type(expected.advised.lost, tuple[str, ...])


def scenes(scene: Path, out: Path) -> None:
    """Satellite scenes."""
    fitted = rb.rpc_fit(scene, out / "rpc.txt")
    assert_type(fitted.rms_px, Array)
    rb.rpc_project(scene, "points.csv", out / "image.csv")
    corrected = rb.rpc_correct("scene.tif", "control.csv", scene_bias="shift")
    assert_type(corrected.ids, tuple[str, ...])
    assert_type(corrected.size_px, tuple[int, int])
    if corrected.fit is not None:
        assert_type(corrected.fit.rms, Array)
    ortho = rb.rpc_ortho("scene.tif", "dem.tif", out / "ortho.tif", crs="EPSG:32654")
    assert_type(ortho, rb.Orthophoto)
    assert_type(ortho.values, Array | None)
    batch = rb.rpc_batch([scene], "control.csv", out)
    assert_type(batch, rb.Batch)


def files(result: rb.Adjustment, out: Path) -> None:
    """Results to files and back; what goes wrong."""
    try:
        rb.write_result(result, out, report="none")
        folder = rb.read_result(out)
        assert_type(folder.block, rb.Block)
        assert_type(folder.points.number["sX"], Array)
        assert_type(rb.transform_block(folder.block, rb.SimilarityTransform(scale=2.0), observed="stay"), rb.Block)
        assert_type(rb.merge_blocks([folder.block, result.adjusted]), rb.Block)
    except rb.InputError as error:
        assert_type(error, rb.InputError)
    except rb.NotSolvable as error:
        assert_type(str(error), str)
    except rb.RaybundleError as error:
        assert_type(error.exit_status, int)
    assert_type(rb.__version__, str)
