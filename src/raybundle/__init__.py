"""Survey-grade photogrammetry: from measured image points to coordinates with true standard deviations.

    import raybundle as rb

    block = rb.read_block("camcal21")
    result = rb.adjust(block, rb.AdjustmentOptions(datum="inner"))
    rb.write_result(result, "camcal21-result")

    rb.show(result)  # the report in a browser; rb.plot_residuals(result), rb.table(result, "points")

    done = rb.orient("facade/", "facade-project", control="marks.csv")
    rb.calibrate("board/", "calibration", target="chessboard-9x6")
    rb.convert("facade-project/result", "model", to="colmap")
    rb.rectify("facade-project", "facade.tif", pixel=0.002)
    rb.film("fiducials.csv", "film", calibrated="certificate.csv", camera="rmk.toml")
    rb.rpc_correct("scene.tif", "control.gpkg", bias="shift", out="corrected.tif")
    rb.rpc_ortho("corrected.tif", "dem.tif", "ortho.tif", crs="EPSG:32654")

Names are loaded when they are first used: `import raybundle` alone loads neither NumPy nor SciPy.
"""

from importlib import import_module
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from raybundle.adjustment.evaluation.matrices import Matrices, matrices
    from raybundle.adjustment.evaluation.queries import NamedCovariance, covariance
    from raybundle.adjustment.records.options import AdjustmentOptions
    from raybundle.adjustment.result import Adjustment
    from raybundle.block import Block, Camera, Distances, Images, Instrument, Observations, Points, Role, Stations
    from raybundle.block.merge import merge_blocks
    from raybundle.block.transform import transform_block
    from raybundle.calibration.at_pixels import projection_uncertainty
    from raybundle.cameras.opencv import OpenCVCamera
    from raybundle.commands.calibrate import CalibrateSettings, calibrate
    from raybundle.commands.calibrations import (
        CalibrationAddSettings,
        CalibrationCompareSettings,
        CalibrationConvertSettings,
        CalibrationFindSettings,
        CalibrationListSettings,
        ZoomSettings,
        calibrate_zoom,
        compare_calibrations,
        convert_calibration,
        find_calibration,
        keep_calibration,
        kept_calibrations,
    )
    from raybundle.commands.convert import Converted, ConvertSettings, convert
    from raybundle.commands.empirical import (
        Empirical,
        EmpiricalSettings,
        empirical,
    )
    from raybundle.commands.estimate_cost import EstimateCostSettings, estimate_cost
    from raybundle.commands.film import (
        FilmSettings,
        StraightFilm,
        film,
    )
    from raybundle.commands.marks import (
        adjust_marks,
        export_marks,
        find_fiducials,
        mark,
        marks,
        query,
        transform_to_points,
    )
    from raybundle.commands.measure import MeasureSettings, measure
    from raybundle.commands.merge import MergeSettings, merge_projects
    from raybundle.commands.moved import MovedSettings, moved_points
    from raybundle.commands.new_project import begin
    from raybundle.commands.orient import OrientSettings, orient
    from raybundle.commands.photos import (
        FramesSettings,
        PhotosSettings,
        frames,
        photos,
    )
    from raybundle.commands.planning.check import CheckedFlight, PlanCheckSettings, check_flight
    from raybundle.commands.planning.mission import MissionSettings, PlannedMission, plan_mission
    from raybundle.commands.planning.network import NetworkSettings, plan_network
    from raybundle.commands.planning.next import NextSettings, plan_next
    from raybundle.commands.planning.photograph_list import ListSettings, plan_list
    from raybundle.commands.record import Recorded, RecordSettings, record
    from raybundle.commands.rectify import Rectification, RectifySettings, rectify
    from raybundle.commands.rpc import RpcFitSettings, RpcProjectSettings, rpc_fit, rpc_project
    from raybundle.commands.scenes.batch import Batch, RpcBatchSettings, rpc_batch
    from raybundle.commands.scenes.correct import RpcCorrectSettings, rpc_correct
    from raybundle.commands.scenes.ortho import Orthophoto, RpcOrthoSettings, rpc_ortho
    from raybundle.commands.sheet import DrawingSheet, drawing_sheet
    from raybundle.commands.sheet_settings import DrawingSheetSettings
    from raybundle.commands.show import show
    from raybundle.commands.spreadsheet import Spreadsheet, SpreadsheetSettings, spreadsheet
    from raybundle.commands.surface import MeasuredSurface, SurfaceSettings, surface
    from raybundle.commands.target_settings import (
        ChooseSettings,
        DetectSettings,
        SheetSettings,
        choose_targets,
        write_target_sheet,
    )
    from raybundle.commands.targets import detect_targets
    from raybundle.errors import InputError, NotSolvable, RaybundleError
    from raybundle.io.block.folder import read_block, write_block
    from raybundle.io.folders import overwriting
    from raybundle.numerics.transform import SimilarityTransform
    from raybundle.planning.flight import plan_flight
    from raybundle.planning.uav_networks import Flight
    from raybundle.report.compare import write_comparison
    from raybundle.report.network_page import write_network_page
    from raybundle.report.plotting import (
        plot_control,
        plot_interior,
        plot_network,
        plot_reliability,
        plot_residuals,
    )
    from raybundle.report.tables import table, table_names
    from raybundle.report.write import write_result
    from raybundle.report.writing import write_report
    from raybundle.results.folder import read_result
    from raybundle.results.matrices_file import write_matrices
    from raybundle.workflows.adjust import adjust
    from raybundle.workflows.calibrating.state import Calibration
    from raybundle.workflows.costs.estimate import Estimate
    from raybundle.workflows.orient import Orientation

    __version__: str

_HOME = {
    "Matrices": "adjustment.evaluation.matrices",
    "matrices": "adjustment.evaluation.matrices",
    "NamedCovariance": "adjustment.evaluation.queries",
    "covariance": "adjustment.evaluation.queries",
    "projection_uncertainty": "calibration.at_pixels",
    "OpenCVCamera": "cameras.opencv",
    "write_matrices": "results.matrices_file",
    "Adjustment": "adjustment.result",
    "AdjustmentOptions": "adjustment.records.options",
    "Batch": "commands.scenes.batch",
    "Block": "block",
    "CalibrateSettings": "commands.calibrate",
    "Calibration": "workflows.calibrating.state",
    "CalibrationAddSettings": "commands.calibrations",
    "CalibrationCompareSettings": "commands.calibrations",
    "CalibrationConvertSettings": "commands.calibrations",
    "CalibrationFindSettings": "commands.calibrations",
    "CalibrationListSettings": "commands.calibrations",
    "Camera": "block",
    "CheckedFlight": "commands.planning.check",
    "ChooseSettings": "commands.target_settings",
    "ConvertSettings": "commands.convert",
    "Converted": "commands.convert",
    "DetectSettings": "commands.target_settings",
    "Distances": "block",
    "Empirical": "commands.empirical",
    "EmpiricalSettings": "commands.empirical",
    "Estimate": "workflows.costs.estimate",
    "EstimateCostSettings": "commands.estimate_cost",
    "FilmSettings": "commands.film",
    "Flight": "planning.uav_networks",
    "FramesSettings": "commands.photos",
    "Images": "block",
    "InputError": "errors",
    "Instrument": "block",
    "MeasureSettings": "commands.measure",
    "MissionSettings": "commands.planning.mission",
    "MergeSettings": "commands.merge",
    "Spreadsheet": "commands.spreadsheet",
    "SpreadsheetSettings": "commands.spreadsheet",
    "MovedSettings": "commands.moved",
    "NotSolvable": "errors",
    "Observations": "block",
    "OrientSettings": "commands.orient",
    "Orientation": "workflows.orient",
    "Orthophoto": "commands.scenes.ortho",
    "PhotosSettings": "commands.photos",
    "PlanCheckSettings": "commands.planning.check",
    "PlannedMission": "commands.planning.mission",
    "Points": "block",
    "RaybundleError": "errors",
    "MeasuredSurface": "commands.surface",
    "Rectification": "commands.rectify",
    "record": "commands.record",
    "Recorded": "commands.record",
    "RecordSettings": "commands.record",
    "drawing_sheet": "commands.sheet",
    "DrawingSheetSettings": "commands.sheet_settings",
    "DrawingSheet": "commands.sheet",
    "RectifySettings": "commands.rectify",
    "SurfaceSettings": "commands.surface",
    "Role": "block",
    "RpcBatchSettings": "commands.scenes.batch",
    "RpcCorrectSettings": "commands.scenes.correct",
    "RpcFitSettings": "commands.rpc",
    "RpcOrthoSettings": "commands.scenes.ortho",
    "RpcProjectSettings": "commands.rpc",
    "SheetSettings": "commands.target_settings",
    "SimilarityTransform": "numerics.transform",
    "Stations": "block",
    "StraightFilm": "commands.film",
    "ZoomSettings": "commands.calibrations",
    "adjust": "workflows.adjust",
    "adjust_marks": "commands.marks",
    "begin": "commands.new_project",
    "calibrate": "commands.calibrate",
    "calibrate_zoom": "commands.calibrations",
    "check_flight": "commands.planning.check",
    "choose_targets": "commands.target_settings",
    "compare_calibrations": "commands.calibrations",
    "convert": "commands.convert",
    "convert_calibration": "commands.calibrations",
    "detect_targets": "commands.targets",
    "empirical": "commands.empirical",
    "estimate_cost": "commands.estimate_cost",
    "export_marks": "commands.marks",
    "film": "commands.film",
    "find_calibration": "commands.calibrations",
    "frames": "commands.photos",
    "keep_calibration": "commands.calibrations",
    "kept_calibrations": "commands.calibrations",
    "find_fiducials": "commands.marks",
    "mark": "commands.marks",
    "marks": "commands.marks",
    "measure": "commands.measure",
    "merge_projects": "commands.merge",
    "spreadsheet": "commands.spreadsheet",
    "moved_points": "commands.moved",
    "merge_blocks": "block.merge",
    "orient": "commands.orient",
    "overwriting": "io.folders",
    "photos": "commands.photos",
    "plan_flight": "planning.flight",
    "plan_mission": "commands.planning.mission",
    "plan_list": "commands.planning.photograph_list",
    "plan_network": "commands.planning.network",
    "NetworkSettings": "commands.planning.network",
    "ListSettings": "commands.planning.photograph_list",
    "plan_next": "commands.planning.next",
    "NextSettings": "commands.planning.next",
    "plot_control": "report.plotting",
    "plot_interior": "report.plotting",
    "plot_network": "report.plotting",
    "plot_reliability": "report.plotting",
    "plot_residuals": "report.plotting",
    "query": "commands.marks",
    "read_block": "io.block.folder",
    "read_result": "results.folder",
    "rectify": "commands.rectify",
    "surface": "commands.surface",
    "rpc_batch": "commands.scenes.batch",
    "rpc_correct": "commands.scenes.correct",
    "rpc_fit": "commands.rpc",
    "rpc_ortho": "commands.scenes.ortho",
    "rpc_project": "commands.rpc",
    "show": "commands.show",
    "table": "report.tables",
    "table_names": "report.tables",
    "transform_block": "block.transform",
    "transform_to_points": "commands.marks",
    "write_block": "io.block.folder",
    "write_comparison": "report.compare",
    "write_network_page": "report.network_page",
    "write_report": "report.writing",
    "write_result": "report.write",
    "write_target_sheet": "commands.target_settings",
}

__all__ = [
    "Adjustment",
    "AdjustmentOptions",
    "Batch",
    "Block",
    "CalibrateSettings",
    "Calibration",
    "CalibrationAddSettings",
    "CalibrationCompareSettings",
    "CalibrationConvertSettings",
    "CalibrationFindSettings",
    "CalibrationListSettings",
    "Camera",
    "CheckedFlight",
    "ChooseSettings",
    "ConvertSettings",
    "Converted",
    "DetectSettings",
    "Distances",
    "DrawingSheet",
    "DrawingSheetSettings",
    "Empirical",
    "EmpiricalSettings",
    "Estimate",
    "EstimateCostSettings",
    "FilmSettings",
    "Flight",
    "FramesSettings",
    "Images",
    "InputError",
    "Instrument",
    "ListSettings",
    "Matrices",
    "MeasureSettings",
    "MeasuredSurface",
    "MergeSettings",
    "MissionSettings",
    "MovedSettings",
    "NamedCovariance",
    "NetworkSettings",
    "NextSettings",
    "NotSolvable",
    "Observations",
    "OpenCVCamera",
    "OrientSettings",
    "Orientation",
    "Orthophoto",
    "PhotosSettings",
    "PlanCheckSettings",
    "PlannedMission",
    "Points",
    "RaybundleError",
    "RecordSettings",
    "Recorded",
    "Rectification",
    "RectifySettings",
    "Role",
    "RpcBatchSettings",
    "RpcCorrectSettings",
    "RpcFitSettings",
    "RpcOrthoSettings",
    "RpcProjectSettings",
    "SheetSettings",
    "SimilarityTransform",
    "Spreadsheet",
    "SpreadsheetSettings",
    "Stations",
    "StraightFilm",
    "SurfaceSettings",
    "ZoomSettings",
    "__version__",
    "adjust",
    "adjust_marks",
    "begin",
    "calibrate",
    "calibrate_zoom",
    "check_flight",
    "choose_targets",
    "compare_calibrations",
    "convert",
    "convert_calibration",
    "covariance",
    "detect_targets",
    "drawing_sheet",
    "empirical",
    "estimate_cost",
    "export_marks",
    "film",
    "find_calibration",
    "find_fiducials",
    "frames",
    "keep_calibration",
    "kept_calibrations",
    "mark",
    "marks",
    "matrices",
    "measure",
    "merge_blocks",
    "merge_projects",
    "moved_points",
    "orient",
    "overwriting",
    "photos",
    "plan_flight",
    "plan_list",
    "plan_mission",
    "plan_network",
    "plan_next",
    "plot_control",
    "plot_interior",
    "plot_network",
    "plot_reliability",
    "plot_residuals",
    "projection_uncertainty",
    "query",
    "read_block",
    "read_result",
    "record",
    "rectify",
    "rpc_batch",
    "rpc_correct",
    "rpc_fit",
    "rpc_ortho",
    "rpc_project",
    "show",
    "spreadsheet",
    "surface",
    "table",
    "table_names",
    "transform_block",
    "transform_to_points",
    "write_block",
    "write_comparison",
    "write_matrices",
    "write_network_page",
    "write_report",
    "write_result",
    "write_target_sheet",
]


def _loaded(name: str) -> Any:
    """The public name, from the module where it lives."""
    if name == "__version__":
        from importlib.metadata import version  # noqa: PLC0415

        value: Any = version("raybundle")
    elif name in _HOME:
        value = getattr(import_module(f"raybundle.{_HOME[name]}"), name)
    else:
        raise AttributeError(f"module 'raybundle' has no attribute {name!r}")
    globals()[name] = value
    return value


if not TYPE_CHECKING:  # a checker that saw it would take every name for a public one
    __getattr__ = _loaded


def __dir__() -> list[str]:
    """The public names."""
    return sorted(__all__)
