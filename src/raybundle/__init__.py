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
    rb.film("fiducials.csv", "film", calibrated="certificate.csv", calibration="rmk.toml")
    rb.rpc_correct("scene.tif", "control.gpkg", scene_bias="shift", out="corrected.tif")
    rb.rpc_ortho("corrected.tif", "dem.tif", "ortho.tif", crs="EPSG:32654")

Names are loaded when they are first used: `import raybundle` alone loads neither NumPy nor SciPy.  Editors and type
checkers read __init__.pyi, which tools/generate_stubs.py writes.
"""

from importlib import import_module
from typing import Any

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
    "Archive": "commands.archive",
    "ArchiveSettings": "commands.archive",
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
    "Flight": "planning.flights.uav_networks",
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
    "StrainSettings": "commands.strain_results",
    "Strains": "commands.strain_results",
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
    "Facade": "commands.facade",
    "FacadeSettings": "commands.facade",
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
    "BoardViews": "block.boards",
    "archive": "commands.archive",
    "board_block": "block.boards",
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
    "find_panels": "commands.panels",
    "mark": "commands.marks",
    "marks": "commands.marks",
    "measure": "commands.measure",
    "merge_projects": "commands.merge",
    "spreadsheet": "commands.spreadsheet",
    "epochs": "commands.epochs",
    "moved_points": "commands.moved",
    "strain": "commands.strain",
    "merge_blocks": "block.merge",
    "orient": "commands.orient",
    "overwriting": "io.folders",
    "photos": "commands.photos",
    "plan_flight": "planning.flights.flight",
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
    "facade": "commands.facade",
    "rectify": "commands.rectify",
    "surface": "commands.surface",
    "rpc_batch": "commands.scenes.batch",
    "rpc_correct": "commands.scenes.correct",
    "rpc_fit": "commands.rpc",
    "rpc_ortho": "commands.scenes.ortho",
    "rpc_project": "commands.rpc",
    "select_block": "block.select",
    "show": "commands.show",
    "table": "report.tables",
    "table_names": "report.tables",
    "transform_block": "block.transform",
    "transform_to_points": "commands.marks",
    "write_block": "io.block.folder",
    "write_comparison": "report.comparison.page",
    "write_network_page": "report.network.page",
    "write_report": "report.writing",
    "write_result": "report.write",
    "write_target_sheet": "commands.target_settings",
}

__all__ = [*_HOME, "__version__"]  # noqa: PLE0604  # pyright: ignore[reportUnsupportedDunderAll]


def __getattr__(name: str) -> Any:
    """The public name, from the module where it lives."""
    if name == "__version__":
        from importlib.metadata import version

        value: Any = version("raybundle")
    elif name in _HOME:
        value = getattr(import_module(f"raybundle.{_HOME[name]}"), name)
    else:
        raise AttributeError(f"module 'raybundle' has no attribute {name!r}")
    globals()[name] = value
    return value


def __dir__() -> list[str]:
    """The public names."""
    return sorted(__all__)
