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
    rb.rpc_correct("scene.XML", "control.csv", bias="shift", out="corrected_RPC.TXT")

Names are loaded when they are first used: `import raybundle` alone loads neither NumPy nor SciPy.
"""

from importlib import import_module
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from raybundle.adjustment.options import AdjustmentOptions
    from raybundle.adjustment.result import Adjustment
    from raybundle.block import Block, Camera, Distances, Images, Instrument, Observations, Points, Role, Stations
    from raybundle.block.merge import merge_blocks
    from raybundle.block.transform import transform_block
    from raybundle.commands.begin import begin
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
    from raybundle.commands.film import (
        FilmSettings,
        StraightFilm,
        film,
    )
    from raybundle.commands.measure import (
        adjust_marks,
        export_marks,
        find_fiducials,
        mark,
        marks,
        query,
        transform_to_points,
    )
    from raybundle.commands.measured import MeasureSettings, measure_targets
    from raybundle.commands.moved import MovedSettings, moved_points
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
    from raybundle.commands.rectify import Rectification, RectifySettings, rectify
    from raybundle.commands.rpc import (
        RpcCorrectSettings,
        RpcFitSettings,
        RpcProjectSettings,
        rpc_correct,
        rpc_fit,
        rpc_project,
    )
    from raybundle.commands.show import show
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
    from raybundle.numerics.transform import SimilarityTransform
    from raybundle.planning.flight import plan_flight
    from raybundle.planning.uav_networks import Flight
    from raybundle.report.compare import write_comparison
    from raybundle.report.document import write_report
    from raybundle.report.network_page import write_network_page
    from raybundle.report.pictures import (
        plot_control,
        plot_interior,
        plot_network,
        plot_reliability,
        plot_residuals,
    )
    from raybundle.report.tables import table, table_names
    from raybundle.report.write import write_result
    from raybundle.results.folder import read_result
    from raybundle.workflows.adjust import adjust
    from raybundle.workflows.calibrate_state import Calibration
    from raybundle.workflows.orient import Orientation

    __version__: str

_HOME = {
    "Adjustment": "adjustment.result",
    "AdjustmentOptions": "adjustment.options",
    "Block": "block",
    "CalibrateSettings": "commands.calibrate",
    "Calibration": "workflows.calibrate_state",
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
    "FilmSettings": "commands.film",
    "Flight": "planning.uav_networks",
    "FramesSettings": "commands.photos",
    "Images": "block",
    "InputError": "errors",
    "Instrument": "block",
    "MeasureSettings": "commands.measured",
    "MissionSettings": "commands.planning.mission",
    "MovedSettings": "commands.moved",
    "NotSolvable": "errors",
    "Observations": "block",
    "OrientSettings": "commands.orient",
    "Orientation": "workflows.orient",
    "PhotosSettings": "commands.photos",
    "PlanCheckSettings": "commands.planning.check",
    "PlannedMission": "commands.planning.mission",
    "Points": "block",
    "RaybundleError": "errors",
    "Rectification": "commands.rectify",
    "RectifySettings": "commands.rectify",
    "Role": "block",
    "RpcCorrectSettings": "commands.rpc",
    "RpcFitSettings": "commands.rpc",
    "RpcProjectSettings": "commands.rpc",
    "SheetSettings": "commands.target_settings",
    "SimilarityTransform": "numerics.transform",
    "Stations": "block",
    "StraightFilm": "commands.film",
    "ZoomSettings": "commands.calibrations",
    "adjust": "workflows.adjust",
    "adjust_marks": "commands.measure",
    "begin": "commands.begin",
    "calibrate": "commands.calibrate",
    "calibrate_zoom": "commands.calibrations",
    "check_flight": "commands.planning.check",
    "choose_targets": "commands.target_settings",
    "compare_calibrations": "commands.calibrations",
    "convert": "commands.convert",
    "convert_calibration": "commands.calibrations",
    "detect_targets": "commands.targets",
    "empirical": "commands.empirical",
    "export_marks": "commands.measure",
    "film": "commands.film",
    "find_calibration": "commands.calibrations",
    "frames": "commands.photos",
    "keep_calibration": "commands.calibrations",
    "kept_calibrations": "commands.calibrations",
    "find_fiducials": "commands.measure",
    "mark": "commands.measure",
    "marks": "commands.measure",
    "measure_targets": "commands.measured",
    "moved_points": "commands.moved",
    "merge_blocks": "block.merge",
    "orient": "commands.orient",
    "photos": "commands.photos",
    "plan_flight": "planning.flight",
    "plan_mission": "commands.planning.mission",
    "plan_list": "commands.planning.photograph_list",
    "plan_network": "commands.planning.network",
    "NetworkSettings": "commands.planning.network",
    "ListSettings": "commands.planning.photograph_list",
    "plan_next": "commands.planning.next",
    "NextSettings": "commands.planning.next",
    "plot_control": "report.pictures",
    "plot_interior": "report.pictures",
    "plot_network": "report.pictures",
    "plot_reliability": "report.pictures",
    "plot_residuals": "report.pictures",
    "query": "commands.measure",
    "read_block": "io.block.folder",
    "read_result": "results.folder",
    "rectify": "commands.rectify",
    "rpc_correct": "commands.rpc",
    "rpc_fit": "commands.rpc",
    "rpc_project": "commands.rpc",
    "show": "commands.show",
    "table": "report.tables",
    "table_names": "report.tables",
    "transform_block": "block.transform",
    "transform_to_points": "commands.measure",
    "write_block": "io.block.folder",
    "write_comparison": "report.compare",
    "write_network_page": "report.network_page",
    "write_report": "report.document",
    "write_result": "report.write",
    "write_target_sheet": "commands.target_settings",
}

__all__ = [
    "Adjustment",
    "AdjustmentOptions",
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
    "Empirical",
    "EmpiricalSettings",
    "FilmSettings",
    "Flight",
    "FramesSettings",
    "Images",
    "InputError",
    "Instrument",
    "ListSettings",
    "MeasureSettings",
    "MissionSettings",
    "MovedSettings",
    "NetworkSettings",
    "NextSettings",
    "NotSolvable",
    "Observations",
    "OrientSettings",
    "Orientation",
    "PhotosSettings",
    "PlanCheckSettings",
    "PlannedMission",
    "Points",
    "RaybundleError",
    "Rectification",
    "RectifySettings",
    "Role",
    "RpcCorrectSettings",
    "RpcFitSettings",
    "RpcProjectSettings",
    "SheetSettings",
    "SimilarityTransform",
    "Stations",
    "StraightFilm",
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
    "detect_targets",
    "empirical",
    "export_marks",
    "film",
    "find_calibration",
    "find_fiducials",
    "frames",
    "keep_calibration",
    "kept_calibrations",
    "mark",
    "marks",
    "measure_targets",
    "merge_blocks",
    "moved_points",
    "orient",
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
    "query",
    "read_block",
    "read_result",
    "rectify",
    "rpc_correct",
    "rpc_fit",
    "rpc_project",
    "show",
    "table",
    "table_names",
    "transform_block",
    "transform_to_points",
    "write_block",
    "write_comparison",
    "write_network_page",
    "write_report",
    "write_result",
    "write_target_sheet",
]


def __getattr__(name: str) -> Any:
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


def __dir__() -> list[str]:
    """The public names."""
    return sorted(__all__)
