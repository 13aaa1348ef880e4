"""Written by tools/generate_stubs.py; do not edit."""

from collections.abc import Mapping
from collections.abc import Sequence
from pathlib import Path
from raybundle.adjustment.evaluation.matrices import Matrices as Matrices
from raybundle.adjustment.evaluation.matrices import matrices as matrices
from raybundle.adjustment.evaluation.queries import NamedCovariance as NamedCovariance
from raybundle.adjustment.evaluation.queries import covariance as covariance
from raybundle.adjustment.records.options import AdjustmentOptions as AdjustmentOptions
from raybundle.adjustment.result import Adjustment as Adjustment
from raybundle.block import Block as Block
from raybundle.block import Camera as Camera
from raybundle.block import Distances as Distances
from raybundle.block import Images as Images
from raybundle.block import Instrument as Instrument
from raybundle.block import Observations as Observations
from raybundle.block import Points as Points
from raybundle.block import Role as Role
from raybundle.block import Stations as Stations
from raybundle.block.boards import BoardViews as BoardViews
from raybundle.block.boards import board_block as board_block
from raybundle.block.joined import Joined
from raybundle.block.merge import merge_blocks as merge_blocks
from raybundle.block.select import select_block as select_block
from raybundle.block.transform import transform_block as transform_block
from raybundle.calibration.at_pixels import projection_uncertainty as projection_uncertainty
from raybundle.cameras.opencv import OpenCVCamera as OpenCVCamera
from raybundle.commands.archive import Archive as Archive
from raybundle.commands.archive import ArchiveSettings as ArchiveSettings
from raybundle.commands.archive import archive as archive
from raybundle.commands.calibrate import CalibrateSettings as CalibrateSettings
from raybundle.commands.calibrations import CalibrationAddSettings as CalibrationAddSettings
from raybundle.commands.calibrations import CalibrationCompareSettings as CalibrationCompareSettings
from raybundle.commands.calibrations import CalibrationConvertSettings as CalibrationConvertSettings
from raybundle.commands.calibrations import CalibrationFindSettings as CalibrationFindSettings
from raybundle.commands.calibrations import CalibrationListSettings as CalibrationListSettings
from raybundle.commands.calibrations import ComparedCalibrations
from raybundle.commands.calibrations import ConvertedCalibrations
from raybundle.commands.calibrations import FoundCalibrations
from raybundle.commands.calibrations import KeptCalibration
from raybundle.commands.calibrations import ZoomLens
from raybundle.commands.calibrations import ZoomSettings as ZoomSettings
from raybundle.commands.convert import ConvertSettings as ConvertSettings
from raybundle.commands.convert import Converted as Converted
from raybundle.commands.empirical import Empirical as Empirical
from raybundle.commands.empirical import EmpiricalSettings as EmpiricalSettings
from raybundle.commands.epochs import Epochs
from raybundle.commands.estimate_cost import EstimateCostSettings as EstimateCostSettings
from raybundle.commands.facade import Facade as Facade
from raybundle.commands.facade import FacadeSettings as FacadeSettings
from raybundle.commands.film import FilmSettings as FilmSettings
from raybundle.commands.film import StraightFilm as StraightFilm
from raybundle.commands.marks import export_marks as export_marks
from raybundle.commands.marks import find_fiducials as find_fiducials
from raybundle.commands.marks import mark as mark
from raybundle.commands.marks import marks as marks
from raybundle.commands.measure import MeasureSettings as MeasureSettings
from raybundle.commands.measure import Measured
from raybundle.commands.merge import MergeSettings as MergeSettings
from raybundle.commands.moved import MovedSettings as MovedSettings
from raybundle.commands.new_project import Notify
from raybundle.commands.orient import OrientSettings as OrientSettings
from raybundle.commands.panels import find_panels as find_panels
from raybundle.commands.photos import FramesSettings as FramesSettings
from raybundle.commands.photos import KnownPhotos
from raybundle.commands.photos import PhotosSettings as PhotosSettings
from raybundle.commands.planning.check import CheckedFlight as CheckedFlight
from raybundle.commands.planning.check import PlanCheckSettings as PlanCheckSettings
from raybundle.commands.planning.mission import MissionSettings as MissionSettings
from raybundle.commands.planning.mission import PlannedMission as PlannedMission
from raybundle.commands.planning.network import NetworkSettings as NetworkSettings
from raybundle.commands.planning.next import NextSettings as NextSettings
from raybundle.commands.planning.photograph_list import ListSettings as ListSettings
from raybundle.commands.record import RecordSettings as RecordSettings
from raybundle.commands.record import Recorded as Recorded
from raybundle.commands.rectify import Rectification as Rectification
from raybundle.commands.rectify import RectifySettings as RectifySettings
from raybundle.commands.rpc import Projected
from raybundle.commands.rpc import RpcFitSettings as RpcFitSettings
from raybundle.commands.rpc import RpcProjectSettings as RpcProjectSettings
from raybundle.commands.scenes.batch import Batch as Batch
from raybundle.commands.scenes.batch import RpcBatchSettings as RpcBatchSettings
from raybundle.commands.scenes.correct import Correction
from raybundle.commands.scenes.correct import RpcCorrectSettings as RpcCorrectSettings
from raybundle.commands.scenes.ortho import Orthophoto as Orthophoto
from raybundle.commands.scenes.ortho import RpcOrthoSettings as RpcOrthoSettings
from raybundle.commands.sheet import DrawingSheet as DrawingSheet
from raybundle.commands.sheet_settings import DrawingSheetSettings as DrawingSheetSettings
from raybundle.commands.show import show as show
from raybundle.commands.spreadsheet import Spreadsheet as Spreadsheet
from raybundle.commands.spreadsheet import SpreadsheetSettings as SpreadsheetSettings
from raybundle.commands.spreadsheet import spreadsheet as spreadsheet
from raybundle.commands.strain_results import StrainSettings as StrainSettings
from raybundle.commands.strain_results import Strains as Strains
from raybundle.commands.surface import MeasuredSurface as MeasuredSurface
from raybundle.commands.surface import SurfaceSettings as SurfaceSettings
from raybundle.commands.target_settings import ChooseSettings as ChooseSettings
from raybundle.commands.target_settings import DetectSettings as DetectSettings
from raybundle.commands.target_settings import SheetSettings as SheetSettings
from raybundle.errors import InputError as InputError
from raybundle.errors import NotSolvable as NotSolvable
from raybundle.errors import RaybundleError as RaybundleError
from raybundle.io.block.folder import read_block as read_block
from raybundle.io.block.folder import write_block as write_block
from raybundle.io.cameras.library import Library
from raybundle.io.folders import overwriting as overwriting
from raybundle.io.photos.video import Frames
from raybundle.measuring.query import Answer
from raybundle.metrology.congruence import Congruence
from raybundle.numerics.progress import Progress
from raybundle.numerics.transform import SimilarityTransform as SimilarityTransform
from raybundle.planning.flights.flight import plan_flight as plan_flight
from raybundle.planning.flights.uav_networks import Flight as Flight
from raybundle.planning.network.network_plan import NetworkPlan
from raybundle.planning.next.plan import NextPlan
from raybundle.report.comparison.page import write_comparison as write_comparison
from raybundle.report.network.page import write_network_page as write_network_page
from raybundle.report.plotting import plot_control as plot_control
from raybundle.report.plotting import plot_interior as plot_interior
from raybundle.report.plotting import plot_network as plot_network
from raybundle.report.plotting import plot_reliability as plot_reliability
from raybundle.report.plotting import plot_residuals as plot_residuals
from raybundle.report.tables import table as table
from raybundle.report.tables import table_names as table_names
from raybundle.report.write import write_result as write_result
from raybundle.report.writing import write_report as write_report
from raybundle.results.folder import ResultFolder
from raybundle.results.folder import read_result as read_result
from raybundle.results.matrices_file import write_matrices as write_matrices
from raybundle.scenes.rpc_fit import RpcFit
from raybundle.targets.layout import Sheet
from raybundle.targets.marks import Marks
from raybundle.targets.marks import Target
from raybundle.targets.subsets import Choice
from raybundle.workflows.adjust import adjust as adjust
from raybundle.workflows.calibrating.state import Calibration as Calibration
from raybundle.workflows.costs.estimate import Estimate as Estimate
from raybundle.workflows.orient import Orientation as Orientation
from typing import Any
from typing import Literal

__all__ = [
    "Adjustment",
    "AdjustmentOptions",
    "Archive",
    "ArchiveSettings",
    "Batch",
    "Block",
    "BoardViews",
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
    "Facade",
    "FacadeSettings",
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
    "StrainSettings",
    "Strains",
    "SurfaceSettings",
    "ZoomSettings",
    "__version__",
    "adjust",
    "adjust_marks",
    "archive",
    "begin",
    "board_block",
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
    "epochs",
    "estimate_cost",
    "export_marks",
    "facade",
    "film",
    "find_calibration",
    "find_fiducials",
    "find_panels",
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
    "select_block",
    "show",
    "spreadsheet",
    "strain",
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

__version__: str

def adjust_marks(
    folder: str | Path,
    progress: Progress = ...,
    *,
    datum: Literal['auto', 'control', 'minimal', 'inner'] = 'auto',
    datum_points: str | Sequence[str] = (),
    datum_over: Literal['', 'all', 'good'] = '',
    estimate: Literal['given', 'auto'] = 'given',
    free: Sequence[tuple[str, str] | list[str]] = (),
    hold: Sequence[tuple[str, str] | list[str]] = (),
    pixel_shape: Literal['sensor', 'any'] = 'sensor',
    weights: Literal['given', 'residuals'] = 'given',
    variance_groups: bool = False,
    reject: Literal['none', 'snooping'] = 'none',
    residuals: Literal['as_block', 'measured', 'corrected'] = 'as_block',
    robust_start: bool = False,
    statistics: bool = True,
    max_iterations: int = 100,
    tolerance: float = 1e-06,
    significance: float = 0.05,
    jobs: int = 0,
    noise: Literal['white', 'fields', 'auto'] = 'auto',
) -> tuple[Adjustment, Mapping[str, str]]:
    """Adjust the block of a folder with its manual measurements; also returns omitted ones with reasons.

    given   settings of AdjustmentOptions; parameters that `free` and `hold` name go before those of the journal
    raises  NoOrientation if no photograph is oriented, with the missing marks
    Photographs without orientation are oriented from their marks if possible.

    datum            Datum of the adjustment. auto: inner constraints for the part that control, distances and stations
                     leave open. control: an error if any part stays open. minimal: the fewest fixed coordinates. inner:
                     inner constraints for everything but a measured scale.
    datum_points     Points that define the datum. Without it: all points.
    estimate         Choice of camera parameters. given: those named in block.toml. auto: by significance and
                     determinability.
    free             Estimate this camera parameter in any case. May be repeated.
    hold             Fix this camera parameter at its value in the block. May be repeated.
    variance_groups  Estimate a variance factor for each group of observations. Groups are image points of each camera,
                     control, distances and others. A group without redundancy keeps its given standard deviation.
    reject           Rejection of blunders. snooping: reject image observations with significant blunders, one at a
                     time.
    residuals        Place of residuals: the measured or the corrected image point.  [default: as in block.toml]
    robust_start     Begin with a robust weight function and end with least squares.
    jobs             Number of processors; 0: all.
    noise            Error model of image coordinates. white: independent errors. fields: smooth errors that differ from
                     image to image, and a floor, both estimated from the residuals. auto: fields for five photographs
                     or more that are measured here; white for a given block.
    """

def begin(
    photos: str | Path | Sequence[str | Path],
    out: str | Path | None = None,
    *,
    notify: Notify = ...,
    progress: Progress = ...,
    calibration: str | Path | None = None,
    own_camera: str | Sequence[str] = (),
    library: bool = True,
    film: str | Path | None = None,
    pixel_mm: float | None = None,
    film_transformation: Literal['similarity', 'affine'] = 'affine',
) -> Path:
    """Begin a project of photographs that are to be measured by hand; returns its folder.

    photos    folders and files
    out       project folder; None: PHOTOS-project beside the folder of photographs
    notify      gets a line of each file that is no usable photograph
    settings  calibration, own_camera, library: as of `orient`; film, pixel_mm, film_transformation: scans of film
    raises    InputError where there is no photograph, or something else stands at `out`

    The photographs have their cameras, as `orient` finds them, and no orientation: marks orient them (`rb.mark`).  A
    project that exists at `out` keeps its measurements; new photographs are added.  Where `orient` has a result
    in it, that is what is measured in, and nothing is changed.

    calibration          File of known cameras. `estimate = []` in it fixes them. Calibrations of `raybundle calibrate`
                         are observed with their covariance.
    own_camera           Treat photographs matching PATTERN as a separate camera, e.g. 'left_*' or 'a.jpg|b.jpg'. For
                         photographs without metadata.
    library              False: Ignore calibrations of the camera library.
    film                 Calibrated fiducial marks of film scans: mark,x_mm,y_mm. All photographs are scans;
                         calibration= gives their camera.
    pixel_mm             Pixel size of the scanner.  [default: that of the camera]
    film_transformation  Transformation from a scan to the camera's frame.
    """

def calibrate(
    photos: str | Path | Sequence[str | Path],
    out: str | Path,
    *,
    progress: Progress = ...,
    target: str | Sequence[str] = (),
    table: str | Path | None = None,
    bits: int | None = None,
    sheet: str | Path | None = None,
    masks: str | Path | None = None,
    own_camera: str | Sequence[str] = (),
    model: str = 'auto',
    parameters: str = '',
    spacing: float | None = None,
    dots: bool = False,
    shear: bool = False,
    keep: bool = False,
    jobs: int = 0,
    noise: Literal['white', 'fields', 'auto'] = 'auto',
    title: str = '',
    client: str = '',
    operator: str = '',
    report: bool = True,
    pdf: bool = False,
    appendix: Literal['none', 'short', 'all'] = 'none',
    language: str = 'en',
) -> Calibration:
    """Calibrate the cameras of photographs of coded targets or a board; the result and its report stand in `out`.

    photos    folders and files
    out       result folder; an older one is replaced.  A run that was stopped continues
    settings  as of the command line, by the names of `CalibrateSettings`: target="aicon14", model="rational"
    raises    InputError where too few targets are found; NotSolvable where they orient no photographs

    Limits: the calibration holds for the zoom and focus of the photographs, and for the part of the
    format in which targets were seen.

    target      Targets in the photographs, e.g. aicon14 or chessboard-9x6. How-to Coded targets lists them.  [default:
                detected; natural points if there are none]
    table       Table of custom rings: id,code; with bits=.
    bits        Number of sectors of the rings of table=.
    sheet       TOML file of the printed sheet, instead of target=.
    masks       Masks of the photographs for natural points. They apply if there are no targets. File names as for
                `raybundle orient`.
    own_camera  Treat photographs matching PATTERN as a separate camera, e.g. 'left_*' or 'a.jpg|b.jpg'. For photographs
                without metadata.
    model       Distortion model: aicon, brown, brown_harmonic, division, eucm, field_of_view, fisheye, kannala_brandt,
                radial, rational, spline, thin_prism. auto: brown, or the better model for a wide lens or for systematic
                residuals.
    parameters  Parameters to estimate, e.g. c,x0,y0,K1,K2,P1,P2.  [default: significant and determinable ones]
    spacing     Distance of neighbouring points of a board, e.g. 25mm. It gives lengths in mm; the calibration does not
                depend on it.
    dots        Also use dots without a code among the targets.
    shear       Allow any shear and affinity of the pixels, for scanned pictures.
    keep        Store a good calibration in the camera library. orient finds it there.
    jobs        Number of processors; 0: all.
    noise       Error model of image coordinates. white: independent errors. fields: smooth errors that differ from
                image to image, and a floor, both estimated from the residuals. auto: fields for five photographs or
                more that are measured here; white for a given block.
    title       Title of the report.
    client      Client, on the first page of the report.
    operator    Operator, on the first page of the report.
    report      False: Leave out report.html and network.html.
    pdf         Write the report as report.pdf: A4, with page numbers and bookmarks. Also possible without report.html.
    appendix    Appendix of report.pdf. none; short: all but most of many object points; all: every object point, in
                report.html too. report.html always has the short one.
    language    Language of the report: en, de, fr. Tables and result.json stay English.
    """

def calibrate_zoom(
    results: Sequence[str | Path],
    out: str | Path,
    *,
    focal: float | Sequence[float] = (),
    resolution: float | None = None,
    keep: bool = False,
    library: str | Path | None = None,
) -> ZoomLens:
    """Combine calibrations of a zoom lens at several settings into one for every focal length in between.

    results   result folders of `calibrate`, all with the same model and parameters
    out       new folder for camera.toml and zoom.toml
    settings  as of the command line, by the names of `ZoomSettings`: focal=(24.0, 35.0), keep=True
    raises    InputError where the settings are too few or do not belong together

    focal       EXIF focal length of each camera in order, if the photographs lack it.
    resolution  Step of the focal lengths; 0: not rounded.
    keep        Store it in the camera library. orient finds it there for any focal length.
    library     Folder of the camera library.  [default: RAYBUNDLE_CAMERAS, or the user's folder]
    """

def check_flight(
    plan: str | Path,
    photos: str | Path | Sequence[str | Path],
    *,
    progress: Progress = ...,
    positions: str | Path | None = None,
    crs: str = '',
    dem: str | Path | None = None,
    seen: int | None = None,
    blur_tolerance: float = 1.5,
    tilt_tolerance: float = 10.0,
    sharpness: bool = True,
    out: str | Path | None = None,
) -> CheckedFlight:
    """Hold photographs against their plan: missing, blurred, tilted ones, and what is to be flown again.

    plan      mission.toml, or its folder
    photos    folders and files
    settings  as of the command line, by the names of `PlanCheckSettings`: seen=4, out="check"
    raises    InputError for what is no plan, and where no photograph lies where one was planned

    positions       Positions of the photographs, instead of their own.
    crs             Coordinate system of positions=, if that file defines none.
    dem             Raster of ground heights, if the plan followed one.
    seen            Required number of photographs of each place.  [default: half of the planned number, at least 3]
    blur_tolerance  Blur beyond that of the others that rejects a photograph [px].
    tilt_tolerance  Deviation of the view that rejects a photograph [deg].
    sharpness       False: Do not test sharpness: check only positions, times and angles.
    out             New folder for the table of photographs, gaps and a picture.
    """

def choose_targets(
    target: str | None = None,
    *,
    count: int,
    table: str | Path | None = None,
    bits: int | None = None,
) -> Choice:
    """Choose targets that stay distinct when an arc of their ring is hidden.

    target    family of rings, as "aicon14"; None with `table` and `bits`
    raises    InputError for a family of other targets, and for more than there are

    table  Table of custom targets: id,code; with bits=.
    bits   Number of sectors of the rings of table=.
    count
    """

def compare_calibrations(
    first: str | Path,
    second: str | Path,
    *,
    object_distance: float | None = None,
    format: tuple[int, int] | list[int] | None = None,
    camera: str | None = None,
) -> ComparedCalibrations:
    """How far apart two calibrations place the image of the same ray, after the best rotation.

    first, second  files of any format, or result folders
    settings       as of the command line, by the names of `CalibrationCompareSettings`: object_distance=5.0
    raises         InputError for what cannot be read, and for a file of several cameras where none is named

    object_distance  Distance of the object. Without it: infinity.
    format           Format [px], if the file lacks it.  [x>=1]
    camera           Name of one camera, if the file has several.
    """

def convert(
    source: str | Path | Block | Adjustment,
    out: str | Path,
    *,
    to: str,
    progress: Progress = ...,
    read_as: str | None = None,
    crs: str | None = None,
    frame_origin: tuple[float, float, float] | list[float] | None = None,
    undulation: float | None = None,
    photos: str | Path | None = None,
    undistort: Literal['inside', 'all'] | None = None,
    within: str | Path | None = None,
    tables: Literal['auto', 'csv', 'parquet'] = 'auto',
    approximate: bool = False,
    free_scale: bool = False,
) -> Converted:
    """Convert a block, a result or the files of another program; what is written stands in `out`.

    source    a folder or file, or a block or adjustment of this program; of a result, or a project of `orient`, the
              adjusted values, without rejected observations
    out       new file or folder; nothing is overwritten
    to        "colmap", "opf", "ply" ..., "block", "rpc"; "gpkg,dxf" for files that begin with the name `out`
    settings  as of the command line, by the names of `ConvertSettings`: crs="EPSG:25832", undistort="inside"
    raises    InputError for what cannot be read or written, and where a camera would deviate by more than 0.1 px

    Limits: what the format cannot hold is lost; the remarks of the answer name what had to be changed.

    read_as       Format of INPUT.  [default: recognised]
    to            Format to write, or several, e.g. gpkg,dxf,las. With several, out= NAME is the beginning of the file
                  names (NAME.gpkg and so on). Formats that cannot be written are named at the end.
    crs           Coordinate system: EPSG:25832, EPSG:25832+7837 or a PROJ string.
    frame_origin  Origin of the block's local east-north-up frame, in crs=. Without it, the block is in crs= itself and
                  is transformed to a local frame in its middle.
    undulation    Height of the geoid above the ellipsoid of WGS 84 or GRS 80, for crs=.
    photos        Folder of the photographs, for colours of points and undistort=.  [default: as the project states]
    undistort     Write undistorted photographs into images/ beside out=, with pinhole cameras. inside: no empty pixels.
                  all: nothing is cut.
    within        Plane of the drawing (dxf, gpkg): X right, Y up, Z out of it. Give the NAME.toml that rectify writes
                  beside a picture; drawing and picture then match.
    tables        Format of the tables. csv; parquet (with pyarrow). auto: CSV, but Parquet for tables with more rows
                  than a spreadsheet holds (1 048 575), if pyarrow is installed.
    approximate   Also write cameras with deviations above 0.1 px.
    free_scale    Allow a result with free scale. Its lengths have no unit.
    """

def convert_calibration(
    source: str | Path,
    out: str | Path,
    *,
    to: str,
    read_as: str | None = None,
    model: str | None = None,
    pixel_mm: float | None = None,
    format: tuple[int, int] | list[int] | None = None,
    camera: str | None = None,
    approximate: bool = False,
) -> ConvertedCalibrations:
    """Convert a calibration to the format of another program.

    source    file of any format, or a result folder
    out       new file; photographs that are stored turned or reduced have a second one where a file holds one camera
    to        "opencv", "metashape", "colmap" ..., "raybundle"
    settings  as of the command line, by the names of `CalibrationConvertSettings`: model="8", camera="nikon"
    raises    InputError for what cannot be read or written, and where a camera would deviate by more than 0.1 px

    read_as      Format of the file.  [default: recognised]
    to           Format to write.
    model        Distortion model of FORMAT, e.g. 8 (opencv) or OPENCV (colmap).
    pixel_mm     Pixel size, if INPUT lacks it.
    format       Format [px], if the file lacks it.  [x>=1]
    camera       Name of one camera, if the file has several.
    approximate  Also write cameras with deviations above 0.1 px.
    """

def detect_targets(
    photos: str | Path | Sequence[str | Path],
    target: str | Target | None = None,
    *,
    progress: Progress = ...,
    table: str | Path | None = None,
    bits: int | None = None,
    polarity: Literal['both', 'dark', 'light'] = 'both',
    out: str | Path | None = None,
    observations: str | Path | None = None,
    dots: bool = False,
    overlay: str | Path | None = None,
    jobs: int = 0,
) -> dict[str, Marks]:
    """Targets in photographs, by the photographs' names.

    photos    folders and files
    target    family as "aicon14", "apriltag-36h11", "chessboard-9x6", or a target of one's own; None: aicon14, or
              the rings of `table`
    settings  as of the command line, by the names of `DetectSettings`: polarity="light", overlay="found"
    raises    InputError for an unknown family, files that do not exist, and a photograph that cannot be read

    Limits: standard deviations come from the grey values alone; what lens and panel add is for the
    adjustment to find.

    table         Table of custom targets: id,code; with bits=.
    bits          Number of sectors of the rings of table=.
    polarity      Colour of the dots.
    out           Table of all detected targets.
    observations  Write named points as observations.csv of a block.
    dots          With rings: also detect dots without a ring.
    overlay       Write the photographs with the detected targets drawn in.
    jobs          Number of processors; 0: all.
    """

def drawing_sheet(
    sources: str | Path | Sequence[str | Path],
    out: str | Path,
    *,
    progress: Progress = ...,
    plane: str | Sequence[str] = (),
    vertical: bool = False,
    horizontal: bool = False,
    up: str = 'z',
    axis: tuple[str, str] | list[str] | None = None,
    origin: str = '',
    wall: int = 1,
    scale: int | None = None,
    paper: Literal['A4', 'A3', 'A2', 'A1', 'A0'] = 'A3',
    landscape: bool = False,
    portrait: bool = False,
    several: bool = False,
    extent: tuple[float, float, float, float] | list[float] | None = None,
    grid: float | None = None,
    draw_points: Literal['named', 'all', 'none'] = 'named',
    lengths: bool = True,
    language: str = '',
    title: str = '',
    object: str = '',
    place: str = '',
    date: str = '',
    client: str = '',
    operator: str = '',
    instruments: str = '',
    reference: str = '',
    rights: str = '',
) -> DrawingSheet:
    """Draw pictures to scale and measured points and lines on a sheet true to scale.

    sources   pictures of `rectify` (or others with a world file), and a result folder or project
    out       new PDF
    settings  as of the command line, by the names of `DrawingSheetSettings`: scale=50, paper="A2", title="South side"
    raises    InputError for what has no plane or no unit, for pictures of different planes, and where the object does
              not fit, with a scale and a paper that do

    Limits: whether the printer keeps the scale; measure the scale bar on the print.

    plane        Object points of the plane: three or more, or two with vertical=.  [default: plane of most points]
    vertical     Use a plumb plane: through two points of plane=, fitted to more of them, or through most points.
    horizontal   Use a level plane at the points' median height: floors, flat ground. If the result has a coordinate
                 system, the picture is in its map.
    up           Plumb direction. z: Z axis of the block. lines: its measured plumb lines. A,B: two points, B above A.
    axis         Two points of the plane's axis to the right, from A to B.  [default: level]
    origin       Point with its foot at the origin of the plane.  [default: in the middle of the points]
    wall         Without plane=: wall N by number of points. 1: the wall with most points.
    scale        Denominator of the scale: 50 is 1 : 50.  [default: the largest of 1, 2, 5, 10, 20, 50 ... that fits]
    paper        Paper size.
    landscape    Use the paper with its longer side horizontal.  [default: by the drawing]
    portrait     Use the paper with its longer side vertical.
    several      Use several sheets for a large object. Register marks in their overlaps join them.
    extent       Part to draw, in the coordinates of the plane or the map.  [default: the pictures, else the points]
    grid         Spacing of the grid crosses, in the unit of the plane; 0: none.  [default: a usual one]
    draw_points  Points to draw; all: also tie points.
    lengths      False: Leave out the values of measured lengths at their lines.
    language     Language of the sheet: en, de, fr.  [default: that of the project's reports]
    title        Title of the drawing.  [default: the object, or the name of the first source]
    object       Name of the object, in the title block.
    place        Place of the object.
    date         Date of the recording.
    client       Client of the drawing.
    operator     Operator.
    instruments  Instruments.
    reference    Numbers of object and order.
    rights       Owner and licence.
    """

def empirical(
    points: str | Path,
    *,
    model: Literal['auto', 'affine', 'affine2', 'parallel-perspective', 'dlt', 'dlt-brown', 'sdlt', 'plane-affine', 'plane-projective'] = 'auto',
    image_sigma: float = 0.5,
    without: str | Sequence[str] = (),
    out: str | Path | None = None,
) -> Empirical:
    """Fit an image of an unknown sensor to known points: affine, projective and DLT models.

    points    table point,X,Y,Z,x_px,y_px or point,lon_deg,lat_deg,h_m,x_px,y_px; role `check`: compared only
    settings  as of the command line, by the names of `EmpiricalSettings`: model="dlt-brown", without="K3"
    raises    InputError for what cannot be read, and for points to which the model cannot be fitted

    Limits: an inadequate model is returned as well; `fit.adequate` and `fit.reason` say so.

    model        Model to fit. auto: the adequate one with the fewest parameters.
    image_sigma  Sigma of a measured image coordinate [px]. It decides which models are adequate.
    without      Additional parameters of dlt-brown to leave out.
    out          New folder for model.json, parameters.csv and points.csv.
    """

def epochs(
    out: str | Path,
    *,
    progress: Progress = ...,
    own_camera: str | Sequence[str] = (),
    masks: str | Path | None = None,
    library: bool = True,
    target: str | Sequence[str] = (),
    attitudes: Literal['auto', 'none', 'opk', 'opk-deg', 'opk-gon', 'opk-rad', 'pok', 'pok-deg', 'pok-gon', 'pok-rad', 'matrix', 'matrix-inverse', 'rpy-ned', 'gimbal'] = 'auto',
    attitude_sigma: tuple[float, float] | list[float] | None = None,
    relative: Literal['', 'shift', 'drift'] = '',
    scene_bias: Literal['none', 'shift', 'drift', 'affine'] = 'shift',
    crs: str | None = None,
    features: str = 'rootsift',
    feature_count: int = 10000,
    wide_baselines: Literal['all', 'own', 'none'] = 'own',
    start: Literal['auto', 'growing', 'averaging', 'parts'] = 'auto',
    precise: bool = True,
    jobs: int = 0,
    cluster: str = '',
    store: str = '',
    memory: float = 0.0,
    redo_from: str = '',
    read_out: float | None = None,
    noise: Literal['white', 'fields', 'auto'] = 'auto',
    photos: str | Path | Sequence[str | Path] = (),
    calibration: str | Path | None = None,
    control: str | Path | Sequence[str | Path] = (),
    check: str | Path | Sequence[str | Path] = (),
    control_sigma: tuple[float, float] | list[float] | None = None,
    mark_sigma: float = 0.5,
    scale_bar: Sequence[tuple[str, str, float, float] | list[str | float]] = (),
    positions: str | Path | None = None,
    misalignment: bool = True,
    lever_arm: tuple[float, float, float, float] | list[float] | None = None,
    shift: bool = True,
    gps: bool = True,
    up: str = 'auto',
    accuracy_class: str = '',
    title: str = '',
    client: str = '',
    operator: str = '',
    wait_for_workers: int = 0,
    wait_limit: float = 600.0,
    report: bool = True,
    pdf: bool = False,
    appendix: Literal['none', 'short', 'all'] = 'none',
    language: str = 'en',
    add: str | Path | Sequence[str | Path] = (),
    date: str | Sequence[str] = (),
    group: str | Sequence[str] = (),
    datum_points: str | Sequence[str] = (),
    shared_cameras: Literal['test', 'yes', 'no'] = 'test',
    significance: float = 0.05,
    limit: str = '',
    confidence: float = 0.99,
    animation: bool = False,
) -> Epochs:
    """Adjust photographs of several dates together; displacements stand in `out`/result/displacements.csv.

    out       project folder; begun, or continued with further dates
    settings  as of the command line, by the names of `EpochsSettings`
    raises    InputError, NoOrientation; nothing that is finished is lost

    Limits: a motion that all points share; of points of which more than half moved alike, which half it was; control
    is taken to have stayed.

    own_camera        Treat photographs matching PATTERN as a separate camera, e.g. 'left_*' or 'a.jpg|b.jpg'. For
                      photographs without metadata.
    masks             Masks of the photographs: nothing is measured where they are 0. Named photo.jpg.png (COLMAP),
                      photo_mask.png or photo.png (Metashape).
    library           False: Ignore calibrations of the camera library.
    target            Coded targets in the photographs, e.g. aicon14 or apriltag-36h11. Their codes name new points or
                      points of control=. With several families: FAMILY:CODE.
    attitudes         Observe attitudes of positions=, or of the gimbal, by their convention. auto: attitudes with
                      standard deviations in the file. pok: phi is the primary angle.
    attitude_sigma    Standard deviations [deg] of attitudes that have none. With it, gimbal attitudes are observed too.
    relative          Use only differences of positions and attitudes within a flight line (relative aerial control).
                      drift: also after a drift of the positions.
    scene_bias        Parameters to estimate for the RPC of a satellite scene.
    crs               Coordinate system of inputs that define none, e.g. EPSG:32633: control, check points, positions=
                      in a grid. With heights (EPSG:32633+5773, EPSG:32633+ellipsoid) also for files that define only
                      the plan.
    features          Kind of features. rootsift; for wide baselines xfeat or disk (extra [learned]).
    feature_count     Number of features per photograph.
    wide_baselines    Further matching of photographs that stay without orientation or in other parts. own: affine
                      views; all: learned methods, too, where installed (extra [learned]).
    start             Start of the orientation: image by image, all pairs at once, or in parts that are joined. auto:
                      parts for very many photographs; all pairs if image by image leaves photographs out or the view is
                      narrow.
    precise           False: Skip least-squares matching: several times less precise.
    jobs              Number of processors; 0: all.
    cluster           Run tasks such as features and depth maps on other machines. Give the cluster folder from
                      `raybundle scheduler FOLDER` (extra [cluster]). shards: write the tasks for `raybundle worker` and
                      end.
    store             Storage of the products of stages. Give the URL of an object store for this project alone, e.g.
                      s3://bucket/folder (extra [cluster] and the package of the service). The project remembers it.
                      project: its own folder.  [default: as the last run, at first in the folder]
    memory            Memory limit for pixels during measurement, and for an adjustment [GB]. 0: 4 for pixels; for
                      adjustments four fifths of the free memory, at least 1. Larger adjustments run in parts, from 0.2
                      on.
    redo_from         Repeat this stage and all later ones. `raybundle status` lists them.
    read_out          Read-out time of a rolling shutter; 0: none. Without it, photographs with recorded times are
                      tested for it.
    noise             Error model of image coordinates. white: independent errors. fields: smooth errors that differ
                      from image to image, and a floor, both estimated from the residuals. auto: fields for five
                      photographs or more that are measured here; white for a given block.
    calibration       File of known cameras. `estimate = []` in it fixes them. Calibrations of `raybundle calibrate` are
                      observed with their covariance.
    control           Control points with their image points: gcp_list.txt, CSV or a block folder. Image points alone
                      are possible, e.g. of the ends of a scale bar: image,point,x_px,y_px.
    check             Check points, in the same formats.
    control_sigma     Standard deviation of control, if its file has none. In metres, regardless of the unit of the
                      file.  [default: 0.01 0.02]
    mark_sigma        Standard deviation of a marked image point.
    scale_bar         Known distance between two points, with its standard deviation [m]. The points are in control= or
                      are targets. May be repeated.
    positions         Positions of the photographs, instead of their own (MRK, CSV, geo.txt, Pix4D, Metashape, RTKLIB,
                      aerial lists).
    misalignment      False: Take attitudes as those of the camera: estimate no misalignment.
    lever_arm         Lever arm from the projection centre to the antenna, in the axes of the image. SIGMA 0 fixes it.
    shift             False: Take control and positions in one datum: estimate no shift of the positions of each flight.
    gps               False: Ignore positions in the photographs.
    up                Up direction, if neither control nor positions determine it. auto: from the attitude of the
                      camera; terrestrial, aerial, oblique; or two points A,B of control=, B plumb above A.
    accuracy_class    Largest permitted RMSE at the check points. In metres: 0.03, or plan and height: 0.03,0.05 (-: no
                      limit). Or a class of ASPRS (2024): asprs:2.5cm,5cm. If it is exceeded, the exit status is 4.
    title             Title of the report.
    client            Client, on the first page of the report.
    operator          Operator, on the first page of the report.
    wait_for_workers  Start when so many workers of cluster= are there.
    wait_limit        Seconds that workers are waited for. Then the run ends.
    report            False: Leave out report.html and network.html.
    pdf               Write the report as report.pdf: A4, with page numbers and bookmarks. Also possible without
                      report.html.
    appendix          Appendix of report.pdf. none; short: all but most of many object points; all: every object point,
                      in report.html too. report.html always has the short one.
    language          Language of the report: en, de, fr. Tables and result.json stay English.
    add               Photographs of one or more further dates: a folder or file. May be repeated.
    date              Date of the photographs of add=, in the same order.  [default: names of sub-folders, then EXIF]
    group             Test points as a group: NAME:A,B,C, or NAME:FILE with an outline X,Y. May be repeated.
    datum_points      Known stable points.  [default: found by the test]
    shared_cameras    Use one interior orientation of a camera for all dates. test: unless the dates contradict it.
    significance      Probability that any stable point or area is reported as moved.
    limit             Displacement that must not be exceeded, e.g. 10mm. If it is, the exit status is 6.
    confidence        Probability with which limit= is exceeded.
    animation         Write animation.gif: rectified photographs of all dates with displacements.
    """

def estimate_cost(
    photos: str | Path | None = None,
    *,
    progress: Progress = ...,
    images: int | None = None,
    megapixels: float | None = None,
    overlap: float = 10.0,
    flight_overlap: tuple[float, float] | list[float] | None = None,
    points_per_image: float | None = None,
    iterations: int = 6,
    workers: int = 1,
    memory: float | None = None,
    disk: float | None = None,
    network: float = 1.0,
    store_line: float = 10.0,
    measure: bool = False,
    shipped: bool = False,
) -> Estimate:
    """What an orientation and adjustment takes, stage by stage.

    photos    a folder of photographs: their number and size; None: as `images` and `megapixels` say
    settings  as of the command line, by the names of `EstimateCostSettings`: images=10_000, overlap=12.0
    raises    InputError where neither photographs nor their number are given

    Limits: how photographs of this object match.

    images            Number of photographs, if none exist yet.
    megapixels        Size of a photograph [megapixels]. Without it: from PHOTOS, else 20.
    overlap           Mean number of photographs that show a place of the object.
    flight_overlap    Overlap along and between lines of a flight, instead of overlap=.
    points_per_image  Adjusted image points per photograph. Without it: 0.8 of its features.
    iterations        Iterations of the adjustment.
    workers           Number of parallel processes.
    memory            Memory of a machine. Without it: the free memory here.
    disk              Free disk space for products. Without it: that of the current folder.
    network           Bandwidth between a worker and the shared store [Gbit/s]; 0: one machine.
    store_line        Bandwidth of the store [Gbit/s].
    measure           Measure this machine again, even if stored figures exist.
    shipped           Use the built-in figures of the processor named there.
    """

def facade(
    source: str | Path,
    out: str | Path | None = None,
    *,
    progress: Progress = ...,
    plane: str | Sequence[str] = (),
    vertical: bool = False,
    horizontal: bool = False,
    up: str = 'z',
    axis: tuple[str, str] | list[str] | None = None,
    origin: str = '',
    wall: int = 1,
    extent: tuple[float, float, float, float] | list[float] | None = None,
    pixel: float | None = None,
    density: Literal['1', '2', '4'] = '2',
    fill: float | None = None,
    section: str | Sequence[str] = (),
    scale: int | None = None,
    paper: Literal['auto', 'A4', 'A3', 'A2', 'A1', 'A0'] = 'auto',
    grid: float | None = None,
    photos: str | Path | Sequence[str | Path] = (),
    masks: str | Path | None = None,
    jobs: int = 0,
    memory: float = 2.0,
    title: str = '',
    client: str = '',
    operator: str = '',
    language: str = '',
) -> Facade:
    """Draw a wall with relief: true orthophoto, sheet to scale, drawing and sections.

    source    result folder or project of `orient`
    out       folder; a run that was stopped goes on there
    settings  as of the command line, by the names of `FacadeSettings`: wall=2, scale=50, paper="A2"
    raises    InputError where no wall is found, and where no two photographs show it

    Limits: what hides the wall is in the picture; pixels on interpolated heights may be displaced.

    plane       Object points of the plane: three or more, or two with vertical=.  [default: plane of most points]
    vertical    Use a plumb plane: through two points of plane=, fitted to more of them, or through most points.
    horizontal  Use a level plane at the points' median height: floors, flat ground. If the result has a coordinate
                system, the picture is in its map.
    up          Plumb direction. z: Z axis of the block. lines: its measured plumb lines. A,B: two points, B above A.
    axis        Two points of the plane's axis to the right, from A to B.  [default: level]
    origin      Point with its foot at the origin of the plane.  [default: in the middle of the points]
    wall        Without plane=: wall N by number of points. 1: the wall with most points.
    extent      Part of the wall, in coordinates of its plane.  [default: extent of its points]
    pixel       Pixel of the orthophoto in the object's unit.  [default: that of the photographs]
    density     Measured pixels: each, or every second or fourth of rows and columns.
    fill        Fill holes up to this depth from the next best photograph; 0: leave them white.  [default: 5 % of the
                longer side]
    section     Section line: corners X Y, X Y, ... in the plane.  [default: one level, one plumb, through the middle]
    scale       Denominator of the scale of the sheet.  [default: the largest usual one that fits the pixel and A1]
    paper       Paper size. auto: A3, A2 or A1.
    grid        Spacing of the grid crosses of the sheet; 0: none.  [default: a usual one]
    photos      Folder of the photographs.  [default: recorded in the project]
    masks       Masks of the photographs, as for `surface`.  [default: masks and drawn areas of the project]
    jobs        Number of processors; 0: all.
    memory      Memory limit of all depth maps in work.
    title       Title of the report.
    client      Client, on the first page of the report.
    operator    Operator, on the first page of the report.
    language    Language of the report: en, de, fr. Tables and result.json stay English.  [default: that of the project,
                else en]
    """

def film(
    marks: str | Path,
    out: str | Path,
    *,
    calibrated: str | Path,
    calibration: str | Path,
    image_points: str | Path | None = None,
    pixel_mm: float | None = None,
    transformation: Literal['similarity', 'affine', 'projective'] = 'affine',
    reseau: Literal['none', 'bilinear', 'affine'] = 'none',
) -> StraightFilm:
    """Bring image points of scanned film into the camera's frame by its fiducial marks or reseau.

    marks     CSV image,mark,x_px,y_px[,sx_px,sy_px] of the marks measured in the scans
    out       new folder: film.csv (shrinkage and fit of each scan), residuals.csv, cameras.toml, observations.csv
    settings  as of the command line, by the names of `FilmSettings`: calibrated="marks.csv", calibration="rmk.toml"
    raises    InputError for what cannot be read, and where the marks of a scan do not fit the certificate

    Limits: with as many marks as unknowns a wrong mark is not noticed.

    calibrated      CSV of the calibrated marks: mark,x_mm,y_mm[,sx_mm,sy_mm].
    calibration     TOML with one [cameras.ID]: format, c_mm, x0_mm, y0_mm of the certificate.
    image_points    CSV of image points: image,point,x_px,y_px[,sx_px,sy_px].
    pixel_mm        Pixel size of the scanner.  [default: that of the camera]
    transformation
    reseau          Correct locally between the crosses of a reseau.
    """

def find_calibration(
    photo: str | Path,
    *,
    out: str | Path | None = None,
    library: str | Path | None = None,
) -> FoundCalibrations:
    """Which calibrations of the camera library serve a photograph, and why the others do not.

    photo     photograph
    settings  as of the command line, by the names of `CalibrationFindSettings`: out="camera.toml"
    raises    InputError for a photograph that cannot be read

    out      Write the best calibration as a file for calibration=.
    library  Folder of the camera library.  [default: RAYBUNDLE_CAMERAS, or the user's folder]
    """

def frames(
    video: str | Path,
    out: str | Path,
    *,
    progress: Progress = ...,
    count: int | None = None,
    every: float | None = None,
    motion: float = 0.08,
) -> Frames:
    """Choose sharp frames of a video by image motion and write them as photographs, with frames.csv beside them.

    video     any file that OpenCV decodes
    out       new or empty folder
    settings  as of the command line, by the names of `FramesSettings`: count=60, or every=2.0 (seconds)
    raises    InputError where the file is no video, or `out` holds something

    Limits: the camera constant; many cameras crop and stabilise electronically for video.

    count   Number of frames, evenly spaced by image motion.
    every   Take one frame every so many seconds.
    motion  Image motion from frame to frame, as a share of the longer side. Applies without count= and every=.
    """

def keep_calibration(
    source: str | Path,
    *,
    read_as: str | None = None,
    photo: str | Path | None = None,
    camera_make: str | None = None,
    camera_model: str | None = None,
    serial: str | None = None,
    lens: str | None = None,
    focal: float | None = None,
    focus: float | None = None,
    date: str | None = None,
    format: tuple[int, int] | list[int] | None = None,
    camera: str | None = None,
    library: str | Path | None = None,
) -> KeptCalibration:
    """Store a calibration in the camera library.

    source    file of any format, or the result folder of an adjustment (with covariance)
    settings  as of the command line, by the names of `CalibrationAddSettings`: photo="images/DSC_0001.JPG"
    raises    InputError for an unreadable source, and for a calibration without identifying entries

    read_as       Format of the file.  [default: recognised]
    photo         Photograph of the set, for make, model, serial, lens, focal length and focus.
    camera_make   Camera make, instead of the photograph's entry.
    camera_model  Camera model, instead of the photograph's entry.
    serial        Serial number of the camera, instead of the photograph's entry.
    lens          Name of the lens, instead of the photograph's entry.
    focal         EXIF focal length, instead of the photograph's entry.
    focus         Focus distance of the lens, instead of the photograph's entry.
    date          Date of the calibration.  [default: today]
    format        Format [px], if the file lacks it.  [x>=1]
    camera        Name of one camera, if the file has several.
    library       Folder of the camera library.  [default: RAYBUNDLE_CAMERAS, or the user's folder]
    """

def kept_calibrations(
    *,
    library: str | Path | None = None,
) -> Library:
    """The calibrations of the camera library.

    settings  as of the command line, by the names of `CalibrationListSettings`: library="cameras"

    library  Folder of the camera library.  [default: RAYBUNDLE_CAMERAS, or the user's folder]
    """

def measure(
    photos: str | Path | Sequence[str | Path],
    out: str | Path,
    *,
    progress: Progress = ...,
    target: str | Sequence[str] = (),
    dots: bool = False,
    calibration: str | Path | None = None,
    scale_bar: Sequence[tuple[str, str, float, float] | list[str | float]] = (),
    control: str | Path | None = None,
    nominal: str | Path | None = None,
    by: str | Sequence[str] = (),
    fit_scale: bool = False,
    weighting: Literal['covariance', 'equal'] = 'covariance',
    check_length: Sequence[tuple[str, str, float] | list[str | float]] = (),
    lengths: str | Path | None = None,
    allowed: tuple[float, float] | list[float] | None = None,
    unit: float = 1.0,
    significance: float = 0.05,
    jobs: int = 0,
    noise: Literal['white', 'fields', 'auto'] = 'auto',
    title: str = '',
    client: str = '',
    operator: str = '',
    report: bool = True,
    pdf: bool = False,
    appendix: Literal['none', 'short', 'all'] = 'none',
    language: str = 'en',
) -> Measured:
    """Measure targets in photographs, or take a result of them, and hold the points against what is known.

    photos    folders and files of photographs, or one result folder
    out       result folder with coordinate_list.csv, nominal.csv and lengths.csv; an older one is replaced
    settings  as of the command line, by the names of `MeasureSettings`
    raises    InputError for points that were not measured; NotSolvable where the photographs cannot be oriented
    Limits: a length test looks at no arrangement of lines, as guidelines ask of an acceptance test.

    target        Targets in the photographs, e.g. aicon14. How-to Coded targets lists them.  [default: detected]
    dots          Also use dots without a code among the targets.
    calibration   Fix this calibration.  [default: the camera is calibrated with the object]
    scale_bar     Known distance between two targets with its standard deviation [m]. May be repeated.
    control       Known targets that define the datum: point,X,Y,Z; optional sX,sY,sZ (0: fixed) and role (control or
                  check). In units of unit=. Without standard deviations, they are estimated from the fit.
    nominal       Nominal coordinates: point,X,Y,Z; optional sX,sY,sZ and tolerance. In units of unit=.
    by            Points for the fit of the axes.  [default: all nominal ones]
    fit_scale     Also fit the scale to nominal=. Without a measured scale, it is always fitted.
    weighting     Weights of the fit: the joint covariance, or equal weights as in other programs.
    check_length  Known distance between two targets as an independent check [m]. May be repeated.
    lengths       Table of check distances: from,to,length; optional sigma. In units of unit=.
    allowed       Maximum permissible length error: A + K L, in mm and mm per metre.
    unit          Metres per unit of the files.
    significance  Probability of any false significant deviation or length.
    jobs          Number of processors; 0: all.
    noise         Error model of image coordinates. white: independent errors. fields: smooth errors that differ from
                  image to image, and a floor, both estimated from the residuals. auto: fields for five photographs or
                  more, also of a result.
    title         Title of the report.
    client        Client, on the first page of the report.
    operator      Operator, on the first page of the report.
    report        False: Leave out report.html and network.html.
    pdf           Write the report as report.pdf: A4, with page numbers and bookmarks. Also possible without
                  report.html.
    appendix      Appendix of report.pdf. none; short: all but most of many object points; all: every object point, in
                  report.html too. report.html always has the short one.
    language      Language of the report: en, de, fr. Tables and result.json stay English.
    """

def merge_projects(
    sources: Sequence[str | Path],
    out: str | Path,
    *,
    progress: Progress = ...,
    same_camera: bool = False,
    significance: float = 0.01,
) -> Joined:
    """Merge results, projects or blocks of one object into one block folder, which is adjusted as any other.

    sources   folders; points are common by the names that people, codes or tables gave them, dots without a code by
              their place
    out       new block folder
    settings  as of the command line, by the names of `MergeSettings`
    raises    InputError for fewer than three common points without a common datum, given coordinates, scales, cameras
              or places on the earth that contradict each other, a project that is given twice
    Limits: whether common points stayed where they were; `moved_points` does.

    same_camera   Join cameras of one name. Without it, each project keeps its own cameras, as of another day.
    significance  Probability that any unmoved common point is rejected as moved or exchanged.
    """

def moved_points(
    epochs: Sequence[Adjustment | str | Path],
    out: str | Path,
    *,
    progress: Progress = ...,
    datum_points: str | Sequence[str] = (),
    points: str | Sequence[str] = (),
    significance: float = 0.05,
    axes: str | Path | None = None,
    by: str | Sequence[str] = (),
    unit: float = 1.0,
    free_scale: bool = False,
    title: str = '',
    client: str = '',
    operator: str = '',
    report: bool = True,
    pdf: bool = False,
    language: str = 'en',
) -> Congruence:
    """Test which points moved between results of the same points, and write what came of it.

    epochs    two or more results (folders, or adjustments), in the order of time; points are the same by their names,
              dots without a code by their place
    out       new folder: report.html, points.csv (displacements with standard deviations), moved.json
    settings  as of the command line, by the names of `MovedSettings`
    raises    InputError for fewer than four common points, or points that are held without error
    Limits: a motion that all points share.

    datum_points  Known stable points.  [default: found by the test]
    points        Use only these points. Dots have their names of the first measurement.  [default: all named points,
                  and dots]
    significance  Probability that any stable point is reported as moved.
    axes          Nominal coordinates that define the axes of the result: point,X,Y,Z. The fit uses the stable points in
                  the first measurement.  [default: the axes of the first measurement]
    by            Points for the fit of axes=.  [default: all stable points of the file]
    unit          Metres per unit of axes=.
    free_scale    Let epochs differ in scale, even if bars or control measured it.
    title         Title of the report.
    client        Client, on the first page of the report.
    operator      Operator, on the first page of the report.
    report        False: Leave out report.html.
    pdf           Write the report as report.pdf: A4, with page numbers and bookmarks. Also possible without
                  report.html.
    language      Language of the report: en, de, fr. Tables and result.json stay English.
    """

def orient(
    photos: str | Path | Sequence[str | Path],
    out: str | Path,
    *,
    progress: Progress = ...,
    own_camera: str | Sequence[str] = (),
    masks: str | Path | None = None,
    library: bool = True,
    target: str | Sequence[str] = (),
    attitudes: Literal['auto', 'none', 'opk', 'opk-deg', 'opk-gon', 'opk-rad', 'pok', 'pok-deg', 'pok-gon', 'pok-rad', 'matrix', 'matrix-inverse', 'rpy-ned', 'gimbal'] = 'auto',
    attitude_sigma: tuple[float, float] | list[float] | None = None,
    relative: Literal['', 'shift', 'drift'] = '',
    scene_bias: Literal['none', 'shift', 'drift', 'affine'] = 'shift',
    crs: str | None = None,
    features: str = 'rootsift',
    feature_count: int = 10000,
    wide_baselines: Literal['all', 'own', 'none'] = 'own',
    start: Literal['auto', 'growing', 'averaging', 'parts'] = 'auto',
    precise: bool = True,
    jobs: int = 0,
    cluster: str = '',
    store: str = '',
    memory: float = 0.0,
    redo_from: str = '',
    read_out: float | None = None,
    noise: Literal['white', 'fields', 'auto'] = 'auto',
    calibration: str | Path | None = None,
    control: str | Path | Sequence[str | Path] = (),
    check: str | Path | Sequence[str | Path] = (),
    control_sigma: tuple[float, float] | list[float] | None = None,
    mark_sigma: float = 0.5,
    scale_bar: Sequence[tuple[str, str, float, float] | list[str | float]] = (),
    positions: str | Path | None = None,
    misalignment: bool = True,
    lever_arm: tuple[float, float, float, float] | list[float] | None = None,
    shift: bool = True,
    gps: bool = True,
    up: str = 'auto',
    accuracy_class: str = '',
    title: str = '',
    client: str = '',
    operator: str = '',
    wait_for_workers: int = 0,
    wait_limit: float = 600.0,
    report: bool = True,
    pdf: bool = False,
    appendix: Literal['none', 'short', 'all'] = 'none',
    language: str = 'en',
) -> Orientation:
    """Orient photographs and satellite scenes; the result and its report stand in `out`/result.

    photos    folders and files
    out       project folder; begun, or continued where a run was stopped
    settings  as of the command line, by the names of `OrientSettings`: control="gcp.csv", crs="EPSG:32633"
    raises    InputError, NoOrientation; nothing that is finished is lost

    Limits: without control or scale bars the position, orientation and scale of the result are
    arbitrary; and photographs of an object with similar parts can be oriented wrongly with small residuals.

    own_camera        Treat photographs matching PATTERN as a separate camera, e.g. 'left_*' or 'a.jpg|b.jpg'. For
                      photographs without metadata.
    masks             Masks of the photographs: nothing is measured where they are 0. Named photo.jpg.png (COLMAP),
                      photo_mask.png or photo.png (Metashape).
    library           False: Ignore calibrations of the camera library.
    target            Coded targets in the photographs, e.g. aicon14 or apriltag-36h11. Their codes name new points or
                      points of control=. With several families: FAMILY:CODE.
    attitudes         Observe attitudes of positions=, or of the gimbal, by their convention. auto: attitudes with
                      standard deviations in the file. pok: phi is the primary angle.
    attitude_sigma    Standard deviations [deg] of attitudes that have none. With it, gimbal attitudes are observed too.
    relative          Use only differences of positions and attitudes within a flight line (relative aerial control).
                      drift: also after a drift of the positions.
    scene_bias        Parameters to estimate for the RPC of a satellite scene.
    crs               Coordinate system of inputs that define none, e.g. EPSG:32633: control, check points, positions=
                      in a grid. With heights (EPSG:32633+5773, EPSG:32633+ellipsoid) also for files that define only
                      the plan.
    features          Kind of features. rootsift; for wide baselines xfeat or disk (extra [learned]).
    feature_count     Number of features per photograph.
    wide_baselines    Further matching of photographs that stay without orientation or in other parts. own: affine
                      views; all: learned methods, too, where installed (extra [learned]).
    start             Start of the orientation: image by image, all pairs at once, or in parts that are joined. auto:
                      parts for very many photographs; all pairs if image by image leaves photographs out or the view is
                      narrow.
    precise           False: Skip least-squares matching: several times less precise.
    jobs              Number of processors; 0: all.
    cluster           Run tasks such as features and depth maps on other machines. Give the cluster folder from
                      `raybundle scheduler FOLDER` (extra [cluster]). shards: write the tasks for `raybundle worker` and
                      end.
    store             Storage of the products of stages. Give the URL of an object store for this project alone, e.g.
                      s3://bucket/folder (extra [cluster] and the package of the service). The project remembers it.
                      project: its own folder.  [default: as the last run, at first in the folder]
    memory            Memory limit for pixels during measurement, and for an adjustment [GB]. 0: 4 for pixels; for
                      adjustments four fifths of the free memory, at least 1. Larger adjustments run in parts, from 0.2
                      on.
    redo_from         Repeat this stage and all later ones. `raybundle status` lists them.
    read_out          Read-out time of a rolling shutter; 0: none. Without it, photographs with recorded times are
                      tested for it.
    noise             Error model of image coordinates. white: independent errors. fields: smooth errors that differ
                      from image to image, and a floor, both estimated from the residuals. auto: fields for five
                      photographs or more that are measured here; white for a given block.
    calibration       File of known cameras. `estimate = []` in it fixes them. Calibrations of `raybundle calibrate` are
                      observed with their covariance.
    control           Control points with their image points: gcp_list.txt, CSV or a block folder. Image points alone
                      are possible, e.g. of the ends of a scale bar: image,point,x_px,y_px.
    check             Check points, in the same formats.
    control_sigma     Standard deviation of control, if its file has none. In metres, regardless of the unit of the
                      file.  [default: 0.01 0.02]
    mark_sigma        Standard deviation of a marked image point.
    scale_bar         Known distance between two points, with its standard deviation [m]. The points are in control= or
                      are targets. May be repeated.
    positions         Positions of the photographs, instead of their own (MRK, CSV, geo.txt, Pix4D, Metashape, RTKLIB,
                      aerial lists).
    misalignment      False: Take attitudes as those of the camera: estimate no misalignment.
    lever_arm         Lever arm from the projection centre to the antenna, in the axes of the image. SIGMA 0 fixes it.
    shift             False: Take control and positions in one datum: estimate no shift of the positions of each flight.
    gps               False: Ignore positions in the photographs.
    up                Up direction, if neither control nor positions determine it. auto: from the attitude of the
                      camera; terrestrial, aerial, oblique; or two points A,B of control=, B plumb above A.
    accuracy_class    Largest permitted RMSE at the check points. In metres: 0.03, or plan and height: 0.03,0.05 (-: no
                      limit). Or a class of ASPRS (2024): asprs:2.5cm,5cm. If it is exceeded, the exit status is 4.
    title             Title of the report.
    client            Client, on the first page of the report.
    operator          Operator, on the first page of the report.
    wait_for_workers  Start when so many workers of cluster= are there.
    wait_limit        Seconds that workers are waited for. Then the run ends.
    report            False: Leave out report.html and network.html.
    pdf               Write the report as report.pdf: A4, with page numbers and bookmarks. Also possible without
                      report.html.
    appendix          Appendix of report.pdf. none; short: all but most of many object points; all: every object point,
                      in report.html too. report.html always has the short one.
    language          Language of the report: en, de, fr. Tables and result.json stay English.
    """

def photos(
    photos: str | Path | Sequence[str | Path],
    *,
    progress: Progress = ...,
    calibration: str | Path | None = None,
) -> KnownPhotos:
    """What is known about some photographs: cameras, starting values, positions, files left out.

    photos    folders and files
    settings  as of the command line, by the names of `PhotosSettings`: calibration="cameras.toml"
    raises    InputError for files that do not exist

    calibration  Stored calibrations to match.
    """

def plan_list(
    kind: str,
    object: str,
    out: str | Path,
    *,
    progress: Progress = ...,
    camera: str | Path | None = None,
    format: tuple[int, int] | list[int] = (6000, 4000),
    c: float = 24.0,
    pixel_mm: float = 0.006,
    hold_camera: bool = False,
    f_number: float = 8.0,
    image_sigma: float | None = None,
    unit: float = 1.0,
    focus: float | None = None,
    measured: Literal['retro', 'targets', 'dots', 'natural', 'phone', 'hand'] | None = None,
    around: float = 30.0,
    clearance: float | None = None,
    eye: float = 1.7,
    overlap: float = 0.6,
    steps: int = 24,
    elevations: float | Sequence[float] = (15.0, 45.0),
    stations: str | Path | None = None,
    count: int = 40,
    across: float = 10.0,
) -> NetworkPlan:
    """List photographs one by one, and write the list.

    kind      "cipa", "calibration", "turntable" or "targets"
    object    as of `plan_network`
    out       new folder: list.pdf, list.csv, and what `plan_network` writes
    settings  as of the command line, by the names of `ListSettings`
    raises    InputError where the list cannot be made, with what would help

    camera       Photograph of the camera, its calibration, a block or a result.  [default: camera of OBJECT, if it is a
                 block or result]
    format       Format of the camera [px], without camera=.
    c            Camera constant [mm], without camera=.
    pixel_mm     Pixel size, without camera=.
    hold_camera  Fix the calibrated camera. Without it, the camera is calibrated with the object.
    f_number     Aperture, for the depth of field.
    image_sigma  Sigma of an image coordinate [px].
    unit         Metres per unit of a mesh.
    focus        Focus distance of the lens [m].  [default: by the photographs]
    measured     Kind of image points.  [default: natural for a building, dots for a sheet, else targets]
    around       cipa: largest distance from the walls [m].
    clearance    cipa: smallest distance from the walls [m].  [default: by the list]
    eye          cipa: height of the camera above the ground [m].
    overlap      cipa: overlap of neighbouring photographs of the ring.
    steps        turntable: steps of a full turn.
    elevations   turntable: elevations of the views above the table [deg]. May be repeated.
    stations     targets: stations.csv of a plan, a block or a result.
    count        targets: number of targets.
    across       targets: diameter of a dot in the farthest photograph [px].
    """

def plan_mission(
    area: str | Path,
    out: str | Path,
    *,
    pattern: Literal['nadir', 'double-grid', 'oblique-grid', 'corridor', 'facade', 'orbit'] = 'nadir',
    vehicle: str = '',
    camera: str = '',
    gsd: float | None = None,
    height: float | None = None,
    overlap: tuple[float, float] | list[float] = (0.8, 0.7),
    direction: float | None = None,
    margin: float | None = None,
    tilt: float | None = None,
    directions: int = 4,
    heights: tuple[float, float] | list[float] | None = None,
    rings: int = 1,
    width: float = 0.0,
    side: Literal['left', 'right'] = 'right',
    dem: str | Path | None = None,
    dem_unit: Literal['', 'm', 'ft', 'us-ft'] = '',
    dem_band: int = 1,
    follow: float = 1.0,
    crs: str = '',
    take_off: tuple[float, float] | list[float] | None = None,
    no_go: str | Path | Sequence[str | Path] = (),
    speed: float | None = None,
    blur: float = 1.0,
    exposure: float | None = None,
    interval: float | None = None,
    climb: float | None = None,
    battery: float | None = None,
    reserve: float = 0.25,
    height_limit: float = 120.0,
    sight: float = 500.0,
    trigger: Literal['distance', 'interval'] = 'distance',
    to: str | Sequence[str] = ('kml',),
    predict: bool = False,
    rtk: tuple[float, float, float] | list[float] = (0.02, 0.02, 0.03),
    free_lever_arm: bool = False,
    image_sigma: float = 0.3,
    name: str = 'mission',
) -> PlannedMission:
    """Plan a flight and write it: mission.toml, a picture, and a file for each battery and format.

    area      a file with an area, line or place, or coordinates: "7.1 50.1, 7.2 50.1, 7.2 50.2"
    out       new folder
    settings  as of the command line, by the names of `MissionSettings`: vehicle="mavic-3e", gsd=0.02, dem="dsm.tif"
    raises    InputError for what cannot be flown as asked for

    pattern         Flight pattern.
    vehicle         Known vehicle with its camera, e.g. mavic-3e.
    camera          Photograph of the camera, its calibration (TOML), the name of a known camera, or its format and
                    camera constant in px.  [default: that of vehicle=]
    gsd             Side of a pixel on the ground or facade [m].  [default: 0.02, or by height=]
    height          Height above ground, or distance from a facade or object [m]. Instead of gsd=.
    overlap         Overlap along a line and between lines.
    direction       Azimuth of the lines from grid north [deg].  [default: that of the fewest lines]
    margin          Margin around the area [m].  [default: half the spacing of lines]
    tilt            Tilt of the view from the nadir [deg].  [default: 0, of oblique views 35]
    directions      Number of oblique views of an oblique grid.
    heights         Lower and upper end of a facade or object above ground [m].
    rings           Number of rings of an orbit with tilt=.
    width           Width of a corridor [m].
    side            Side of a facade's line for the flight, seen along the line.
    dem             Raster of ground heights to follow.
    dem_unit        Unit of its heights, if the raster defines none.
    dem_band        Band of the raster.
    follow          Tolerance of heights above ground [m].
    crs             Coordinate system of typed coordinates, or of a file that defines none.  [default: longitude,
                    latitude]
    take_off        Take-off place, in the coordinates of the area.  [default: below the first photograph]
    no_go           Files with no-fly areas.
    speed           Speed on the lines [m/s].  [default: as vehicle, camera and blur= allow]
    blur            Largest motion during the exposure [px].
    exposure        Exposure time [s].  [default: 1/800, or the photograph's]
    interval        Shortest time between photographs [s].  [default: the camera's, or 1]
    climb           Largest rate of climb [m/s].  [default: the vehicle's]
    battery         Flight time of one battery [min].  [default: the vehicle's]
    reserve         Battery share in reserve.
    height_limit    Largest height above ground [m]; EU 2019/947, open category.
    sight           Largest distance of visual line of sight [m].
    trigger         Camera trigger on a line.
    to              Output formats of the plan: qgc, wpl, wpml, litchi, kml.
    predict         Predict precision without control, and list undetermined quantities.
    rtk             Standard deviations of positions, for predict= [m].
    free_lever_arm  Estimate the lever arm of the antenna, for predict=.
    image_sigma     Sigma of an image coordinate, for predict= [px].
    name            Name of the mission and of its files.
    """

def plan_network(
    object: str,
    out: str | Path,
    *,
    progress: Progress = ...,
    camera: str | Path | None = None,
    format: tuple[int, int] | list[int] = (6000, 4000),
    c: float = 24.0,
    pixel_mm: float = 0.006,
    hold_camera: bool = False,
    f_number: float = 8.0,
    image_sigma: float | None = None,
    unit: float = 1.0,
    sigma: float | None = None,
    photographs: int | None = None,
    aim: Literal['worst', 'mean', 'calibration', 'reliability'] = 'worst',
    focus: float | None = None,
    measured: Literal['retro', 'targets', 'dots', 'natural', 'phone', 'hand'] = 'targets',
    object_points: int = 120,
    rays: int = 3,
    incidence: float = 65.0,
    heights: tuple[float, float] | list[float] | None = None,
    around: float | None = None,
    clearance: float | None = None,
    forbid: Sequence[tuple[float, float, float, float, float, float] | list[float]] = (),
    crs: str = '',
    everywhere: bool = False,
    repeat: int = 0,
    stations: str | Path | None = None,
    scale_bars: int = 0,
    scale_bar_sigma: float = 5e-05,
    scale_bar_length: float | None = None,
    control_points: int = 0,
    control_sigma: tuple[float, float] | list[float] = (0.002, 0.002),
    effort: Literal['quick', 'thorough'] = 'thorough',
) -> NetworkPlan:
    """Plan a network round an object and write it.

    object    "box:4,3,2.5", "cylinder:3,4", "facade:12,8", "corridor:60,8" [m], or a mesh file (PLY, OBJ, STL)
    out       new folder: block (a simulated block of the plan), stations.csv, points.csv, plan.json, network.html
    settings  as of the command line, by the names of `NetworkSettings`: sigma=0.1 [mm]
    raises    InputError where what is wanted is beyond reach, nobody can stand anywhere, or a file is no mesh

    camera            Photograph of the camera, its calibration, a block or a result.  [default: camera of OBJECT, if it
                      is a block or result]
    format            Format of the camera [px], without camera=.
    c                 Camera constant [mm], without camera=.
    pixel_mm          Pixel size, without camera=.
    hold_camera       Fix the calibrated camera. Without it, the camera is calibrated with the object.
    f_number          Aperture, for the depth of field.
    image_sigma       Sigma of an image coordinate [px].
    unit              Metres per unit of a mesh.
    sigma             Required standard deviation of a coordinate [mm].
    photographs       Number of stations. Without it, the fewest that reach sigma=.
    aim               Quantity to minimise. worst: sigma= of the worst point. mean: mean of all points. calibration:
                      uncertainty of the calibration. reliability: weak mutual checks of image points.
    focus             Focus distance of the lens [m].  [default: for the sharpest image of the object]
    measured          Kind of image points. It sets the precision if image_sigma= is missing.
    object_points     Number of object points to assess the network.
    rays              Smallest number of photographs of each object point.
    incidence         Largest angle of a ray to the normal [deg].
    heights           Camera heights above the object's lowest point [m].  [default: from half to one and a half times
                      the object's height]
    around            Largest distance of a station from the object [m].
    clearance         Smallest distance of a station from the object [m].  [default: by the focus]
    forbid            Box without stations. May be repeated.
    crs               Coordinate system of a raster or outline that is not in metres.
    everywhere        Add stations until sigma= is reached on all of the visible surface. Without it, at the object
                      points only.
    repeat            Take so many more photographs from existing stations, at the most useful ones.
    stations          Assess these stations instead of a search: stations.csv of a plan, a block or a result.
    scale_bars        Number of scale bars on the object.
    scale_bar_sigma   Standard deviation of scale bar lengths [m].
    scale_bar_length  Length of the scale bars [m].  [default: the largest that fits]
    control_points    Number of control points on the object.
    control_sigma     Standard deviations of the control points [m].
    effort            Effort of the search. quick: seconds, a minute for large networks. thorough: better stations, in
                      minutes.
    """

def plan_next(
    result: Adjustment | str | Path,
    out: str | Path | None = None,
    *,
    photographs: int = 1,
    progress: Progress = ...,
    aim: Literal['worst', 'mean', 'calibration'] = 'worst',
    points: str | Sequence[str] = (),
    camera: str = '',
    around: float | None = None,
    step: float | None = None,
    heights: tuple[float, float] | list[float] | None = None,
    clearance: float | None = None,
    forbid: Sequence[tuple[float, float, float, float, float, float] | list[float]] = (),
    incidence: float = 75.0,
    f_number: float | None = None,
    focus: float | None = None,
    hidden_by: str | None = None,
    unit: float = 1.0,
    candidates: int = 1000,
) -> NextPlan:
    """The next best photographs of a block in hand, each the best after those before it.

    result       an adjustment, or a result, block or project folder, which is adjusted again
    out          new folder: next.csv, next.json, block (the given one and the proposals), network.html; None: nothing
                 is written
    photographs  how many
    settings     as of the command line, by the names of `NextSettings`: aim="calibration"
    raises       InputError where nothing is within reach or seen, for a result without statistics, and for cameras
                 that are no frame cameras; NotSolvable where no photograph within reach lowers anything

    photographs  Number of photographs, chosen one after the other.
    aim          Quantity to minimise. worst: largest sigma of a coordinate. mean: mean sigma. calibration: the camera's
                 largest uncertainty of projection over the format.
    points       With aim= worst: count only these points.
    camera       Camera of the block for the new photographs.  [default: camera of most photographs]
    around       Largest distance from the object.  [default: limited by step= only]
    step         Largest distance from existing stations.  [default: distance of the object]
    heights      Camera heights above the object's lowest point, for blocks with vertical Z.
    clearance    Smallest distance from object points.  [default: a tenth of the distance]
    forbid       Box without stations. May be repeated.
    incidence    Largest angle of a ray to the normal [deg].
    f_number     Aperture, for the depth of field; with focus=.
    focus        Focus distance of the lens.
    hidden_by    Object that hides others, in the frame of the block: a kind, mesh, raster or result, as of `plan
                 network`.
    unit         Block units per unit of a mesh.
    candidates   Number of compared stations and camera rotations.
    """

def query(
    result: Adjustment | ResultFolder | str | Path,
    *,
    distance: tuple[str, str] | Sequence[tuple[str, str]] = (),
    angle: tuple[str, str, str] | Sequence[tuple[str, str, str]] = (),
    coordinates: str | Sequence[str] = (),
    area: str | Sequence[str] = (),
    length: str | Sequence[str] = (),
    plane: str | Sequence[str] = (),
    line: str | Sequence[str] = (),
    to_plane: str | Sequence[str] = (),
    to_line: str | Sequence[str] = (),
) -> list[Answer]:
    """Coordinates, distances, angles, areas, lengths, planes and lines with sigmas from the full covariance.

    result       an adjustment, or a result, project or block folder; its block is adjusted again under the options
                 of the result (at once, since it holds adjusted values)
    coordinates  names of points; distance (A, B) or several; angle (A, B, C) at B or several; area, length, plane,
                 line: points in order; to_plane, to_line: a point, then those of the plane or line
    raises       InputError for points that are not there, and where nothing is asked

    coordinates  Coordinates of each of these points.
    distance     Distance between two points. May be repeated.
    angle        Angle at B between A and C. May be repeated.
    area         Area of the polygon through these points, in order.
    length       Length of the line from point to point, in order.
    plane        Flatness of four or more points: range of their deviations from the best plane, and each deviation.
    line         Largest distance of three or more points from their best line, and each distance.
    to_plane     Distance of the first point from the best plane through the others.
    to_line      Distance of the first point from the best line through the others.
    """

def record(
    project: str | Path,
    *,
    new: bool = False,
    title: str | None = None,
    object: str | None = None,
    place: str | None = None,
    reference: str | None = None,
    kind: str | None = None,
    dating: str | None = None,
    persons: str | None = None,
    materials: str | None = None,
    condition: str | None = None,
    protection: str | None = None,
    description: str | None = None,
    client: str | None = None,
    purpose: str | None = None,
    operator: str | None = None,
    date: str | None = None,
    instruments: str | None = None,
    conditions: str | None = None,
    control: str | None = None,
    rights: str | None = None,
    archive: str | None = None,
) -> Recorded:
    """The recording sheet of a project, with these entries written into project.toml, table [record].

    project  project folder of `orient`, or with new=True a name for one that it will make; a result there gets
             record.toml
    entries  by the names of `Record`: client="Monument office", place="Göttingen"; "" takes an entry away
    raises   InputError where something else stands there, or project.toml cannot be read

    A run of `orient` keeps them; the report has them from its next writing on.

    new          Begin a new project.
    title        Title of the delivery.
    object       Name of the object.
    place        Place of the object: address, parish, country.
    reference    Numbers of inventories and of the order.
    kind         Kind and former use of the object.
    dating       Period, century or years.
    persons      Persons who made, owned or changed the object.
    materials    Materials and techniques.
    condition    Condition of the object.
    protection   Legal status.
    description  Further remarks.
    client       Client of the delivery.
    purpose      Purpose of the recording.
    operator     Persons who photographed or adjusted.
    date         Date of the photographs.  [default: from the photographs]
    instruments  Cameras, lenses, receivers, bars.  [default: from the photographs]
    conditions   Weather, light and access.
    control      Measurement of scale, control and vertical.
    rights       Licence or owner of the result.
    archive      Archive of the recording: name and place.
    """

def rectify(
    source: str | Path,
    out: str | Path,
    *,
    progress: Progress = ...,
    plane: str | Sequence[str] = (),
    vertical: bool = False,
    horizontal: bool = False,
    up: str = 'z',
    axis: tuple[str, str] | list[str] | None = None,
    origin: str = '',
    wall: int = 1,
    pixel: float | None = None,
    extent: tuple[float, float, float, float] | list[float] | None = None,
    photos: str | Path | Sequence[str | Path] = (),
    only: str | Sequence[str] = (),
    relief: float | None = None,
    control: str | Path | None = None,
    transformation: Literal['projective', 'affine'] = 'projective',
    calibration: str | Path | None = None,
    mark_sigma: float = 0.5,
    free_scale: bool = False,
) -> Rectification:
    """Bring photographs of a plane object to scale; beside the picture stand a world file and NAME.toml.

    source    result folder or project of `orient`, or one photograph, which needs control="marks.csv"
    out       new picture: .tif, .png or .jpg
    settings  as of the command line, by the names of `RectifySettings`: pixel=0.002, plane=("A", "B", "C")
    raises    InputError for what cannot be read or does not fit together, and where the scale is free

    Limits: what lies off the plane is displaced, and what hides it is in the picture.

    plane           Object points of the plane: three or more, or two with vertical=.  [default: plane of most points]
    vertical        Use a plumb plane: through two points of plane=, fitted to more of them, or through most points.
    horizontal      Use a level plane at the points' median height: floors, flat ground. If the result has a coordinate
                    system, the picture is in its map.
    up              Plumb direction. z: Z axis of the block. lines: its measured plumb lines. A,B: two points, B above
                    A.
    axis            Two points of the plane's axis to the right, from A to B.  [default: level]
    origin          Point with its foot at the origin of the plane.  [default: in the middle of the points]
    wall            Without plane=: wall N by number of points. 1: the wall with most points.
    pixel           Size of a pixel in the object's unit.  [default: that of the photographs]
    extent          Part of the plane, in its coordinates; of a map, east and north.  [default: extent of the points]
    photos          Folder of the photographs.  [default: recorded in the project]
    only            Use only these photographs.
    relief          Largest displacement by the relief of a wall, in the object's unit. Beyond it, use `facade`.
                    [default: 3 pixels]
    control         For a PHOTO: points of the plane with their image points, as for orient.
    transformation  For a PHOTO: transformation. affine: for a distant view or a flat copy.
    calibration     For a PHOTO: calibration of the lens, to correct distortion.
    mark_sigma      For a PHOTO: standard deviation of a marked point.
    free_scale      Allow a result with free scale. Its lengths have no unit.
    """

def rpc_batch(
    scenes: str | Path | Sequence[str | Path],
    control: str | Path,
    out: str | Path,
    *,
    progress: Progress = ...,
    image_points: str | Path | None = None,
    crs: str | None = None,
    undulation: float | None = None,
    scene_bias: Literal['auto', 'none', 'shift', 'drift', 'affine'] = 'auto',
    image_sigma: float = 0.5,
    heights: tuple[float, float] | list[float] | None = None,
    to: Literal['txt', 'rpb', 'geom', 'tif'] = 'txt',
) -> Batch:
    """Correct the RPC of many scenes on one file of control; a scene that cannot be costs that scene.

    scenes    scene files, pictures, or folders of them
    control   ground and image points, each with the image in which it was measured
    out       new folder: one RPC a scene, and biases.csv with a row a scene
    settings  as of the command line, by the names of `RpcBatchSettings`: to="tif"
    raises    InputError where no scene can be corrected, and for what cannot be read or written as a whole

    image_points  Table image,point,x_px,y_px. The control gives ground coordinates of these points.
    crs           Coordinate system of control that defines none, with its heights: EPSG:32633, EPSG:25832+7837.
    undulation    Height of the geoid above the ellipsoid of WGS 84 or GRS 80 at the control, if its heights refer to
                  the geoid.
    scene_bias    Bias model of the RPC. auto: by significance and leave-one-out.
    image_sigma   Sigma of a measured image coordinate [px].
    heights       Ellipsoidal heights [m] of the validity range of the RPC.  [default: those of the file's RPC]
    to            Output for each scene: NAME_RPC.TXT, NAME.RPB, NAME.geom, or NAME.tif (a copy of its picture).
    """

def rpc_correct(
    scene: Any,
    points: str | Path,
    *,
    rpc: Any = None,
    image_points: str | Path | None = None,
    crs: str | None = None,
    undulation: float | None = None,
    scene_bias: Literal['auto', 'none', 'shift', 'drift', 'affine'] = 'auto',
    image_sigma: float = 0.5,
    heights: tuple[float, float] | list[float] | None = None,
    out: str | Path | None = None,
    into_scene: bool = False,
) -> Correction:
    """Correct an RPC on control points; with `out` it is written with the correction built in.

    scene     scene file with an RPC; a picture with one in its tag or beside it; an opened dataset of rasterio; a
              DataArray that rioxarray opened
    points    CSV, GeoJSON, GeoPackage or gcp_list.txt with ground and image points (see the how-to page)
    rpc       RPC instead of that of the scene: a path, an `Rpc`, or a `rasterio.rpc.RPC`
    settings  as of the command line, by the names of `RpcCorrectSettings`: scene_bias="shift", out="corrected.tif"
    returns   `corrected` is the RPC with the correction and its ERR_BIAS and ERR_RAND; `corrected.to_rasterio()` the
              same for rasterio
    raises    InputError for what cannot be read; NotSolvable where the points contradict the correction

    Limits: errors that all control points have in common.

    image_points  Table image,point,x_px,y_px. The control gives ground coordinates of these points.
    crs           Coordinate system of control that defines none, with its heights: EPSG:32633, EPSG:25832+7837.
    undulation    Height of the geoid above the ellipsoid of WGS 84 or GRS 80 at the control, if its heights refer to
                  the geoid.
    scene_bias    Bias model of the RPC. auto: by significance and leave-one-out.
    image_sigma   Sigma of a measured image coordinate [px].
    heights       Ellipsoidal heights [m] of the validity range of the RPC.  [default: those of the file's RPC]
    out           Corrected RPC to write: NAME_RPC.TXT, NAME.RPB, NAME.geom, or NAME.tif (a copy of the picture with the
                  RPC in its tag).
    into_scene    Write the RPC into the tag of the GeoTIFF SCENE itself. NAME-former_RPC.TXT keeps the former RPC.
    rpc           File with the RPC of the picture SCENE.  [default: its tag, or beside it]
    """

def rpc_fit(
    scene: str | Path,
    out: str | Path,
    *,
    heights: tuple[float, float] | list[float] | None = None,
) -> RpcFit:
    """Make an RPC that stands for the rigorous model of a scene.

    scene     scene file with a rigorous model
    out       new file, NAME_RPC.TXT or NAME.RPB
    settings  as of the command line, by the names of `RpcFitSettings`: heights=(0.0, 400.0)
    raises    InputError for what cannot be read or written

    Limits: how well the rigorous model is known.

    heights  Ellipsoidal heights [m] of the validity range of the RPC.  [default: those of the file's RPC]
    """

def rpc_ortho(
    scene: Any,
    dem: Any,
    out: str | Path | None = None,
    *,
    rpc: Any = None,
    progress: Progress = ...,
    crs: str | None = None,
    pixel: float | None = None,
    extent: tuple[float, float, float, float] | list[float] | None = None,
    geoid: str | None = None,
    undulation: float | None = None,
    resampling: Literal['nearest', 'bilinear', 'cubic'] = 'cubic',
    nodata: float | None = None,
) -> Orthophoto:
    """A scene in the map, over a raster of heights.

    scene     picture with an RPC in its tag or beside it; an opened dataset of rasterio; a DataArray that rioxarray
              opened
    dem       raster of heights: a file, a dataset of rasterio, a DataArray of rioxarray
    out       GeoTIFF to write; None: `values` (bands, height, width) are returned, beside `transform` and `crs`
    rpc       RPC instead of that of the scene: a path, an `Rpc`, or a `rasterio.rpc.RPC`
    settings  as of the command line, by the names of `RpcOrthoSettings`: crs="EPSG:32654", pixel=0.5
    raises    InputError for what cannot be read, and where scene and heights have nothing in common

    Limits: occlusions are not handled.

    rpc         File with the RPC of SCENE.  [default: its tag, or beside it]
    crs         Coordinate system of the map.  [default: the zone of UTM of the scene]
    pixel       Side of a pixel in its unit.  [default: that of the scene, in two digits]
    extent      Part of the map.  [default: common part of scene and dem=]
    geoid       Vertical datum of dem=, if the raster defines none: EPSG:5773 (EGM96), EPSG:3855 (EGM2008).  [default:
                as in the raster, else heights above the ellipsoid]
    undulation  Height of the geoid above the ellipsoid of WGS 84 or GRS 80, instead of a geoid grid.
    resampling  Interpolation between the pixels of the scene.
    nodata      Value of empty pixels.  [default: that of the scene, else 0, NaN among floats]
    """

def rpc_project(
    scene: str | Path,
    points: str | Path,
    out: str | Path,
    *,
    to_ground: bool = False,
    model: Literal['auto', 'rpc', 'rigorous'] = 'auto',
) -> Projected:
    """Image points of ground points by the model of a scene, or the other way, as a table.

    scene     scene file with an RPC or a rigorous model
    points    table point,lon_deg,lat_deg,h_m; with to_ground=True point,x_px,y_px,h_m
    out       new table
    settings  as of the command line, by the names of `RpcProjectSettings`: model="rigorous"
    raises    InputError for what cannot be read, and where no point has a place

    Limits: how well the model is known; an RPC is off by its bias until it is corrected.

    to_ground  Compute ground points of POINTS (point,x_px,y_px,h_m).
    model      Sensor model. auto: the RPC, if the file has one, else the rigorous model.
    """

def strain(
    reference: str | Path,
    deformed: str | Path | Sequence[str | Path],
    out: str | Path,
    *,
    progress: Progress = ...,
    step: int = 10,
    window: int = 31,
    gauge: int = 5,
    shape: Literal['affine', 'quadratic'] = 'affine',
    extent: tuple[float, float, float, float] | list[float] | None = None,
    area: str | Sequence[str] = (),
    mask: str | Path | None = None,
    scale: float | None = None,
) -> Strains:
    """Measure displacements and strains of a flat specimen by digital image correlation.

    reference  image before the load
    deformed   images under load, in the order of time, of the same size
    out        new folder: displacements.csv, strain.csv, maps, result.json
    settings   as of the command line, by the names of `StrainSettings`: step=10, window=31, scale=0.05
    raises     InputError for images of other sizes, and where no subset is found again
    Limits: motion towards the camera and lens distortion look like strain.

    step    Distance between subsets.
    window  Side of a subset, odd.
    gauge   Subsets along the side of the plane for a strain, odd.
    shape   Deformation within a subset.
    extent  Part of the reference image in pixels.  [default: all]
    area    Mean displacement and strain of a rectangle of the reference. May be repeated.
    mask    Image that is black outside the specimen.
    scale   Millimetres on the specimen per pixel.  [default: pixels only]
    """

def surface(
    source: str | Path,
    out: str | Path | None = None,
    *,
    progress: Progress = ...,
    plane: str | Sequence[str] = (),
    vertical: bool = False,
    horizontal: bool = False,
    up: str = 'z',
    axis: tuple[str, str] | list[str] | None = None,
    origin: str = '',
    wall: int = 1,
    density: Literal['1', '2', '4'] = '1',
    dsm: float | None = None,
    ortho: float | None = None,
    mesh: float | None = None,
    las: bool = False,
    depths: bool = False,
    thin: float | None = None,
    region: str | Sequence[str] = (),
    extent: tuple[float, float, float, float] | list[float] | None = None,
    photos: str | Path | Sequence[str | Path] = (),
    masks: str | Path | None = None,
    cluster: str = '',
    store: str = '',
    wait_for_workers: int = 0,
    wait_limit: float = 600.0,
    jobs: int = 0,
    memory: float = 2.0,
    free_scale: bool = False,
    title: str = '',
    client: str = '',
    operator: str = '',
    pdf: bool = False,
    language: str = '',
) -> MeasuredSurface:
    """Measure dense surface points in the photographs of a result; OUT/points.ply holds them.

    source    result folder or project of `orient`
    out       new folder; a run that was stopped goes on there
    settings  as of the command line, by the names of `SurfaceSettings`: density="2"
    raises    InputError where no two photographs show the same part, and where the scale is free

    Limits: errors that all photographs of a place share, as of reflections, water and moving shadows.

    plane             Object points of the plane: three or more, or two with vertical=.  [default: plane of most points]
    vertical          Use a plumb plane: through two points of plane=, fitted to more of them, or through most points.
    horizontal        Use a level plane at the points' median height: floors, flat ground. If the result has a
                      coordinate system, the picture is in its map.
    up                Plumb direction. z: Z axis of the block. lines: its measured plumb lines. A,B: two points, B above
                      A.
    axis              Two points of the plane's axis to the right, from A to B.  [default: level]
    origin            Point with its foot at the origin of the plane.  [default: in the middle of the points]
    wall              Without plane=: wall N by number of points. 1: the wall with most points.
    density           Measured pixels: each, or every second or fourth of rows and columns.
    dsm               Also write heights above the plane, on a grid of this cell size in the object's unit. If the
                      result has a coordinate system and no plane is given, heights are in its map.
    ortho             Also write a true orthophoto above the same plane, with this pixel size. Each pixel comes from the
                      photograph with the best view and has its uncertainty.
    mesh              Also write a mesh above the same plane, with this vertex spacing: PLY, OBJ, glTF. The orthophoto
                      is its texture.
    las               Also write the points as LAZ, or as LAS without a LAZ library.
    depths            Also write the depth map of each photograph with its standard deviations, as TIFF.
    thin              Thin the cloud: keep the best point per cube of this size.
    region            Measure only this part of the object: a file (GeoJSON, KML, CSV, OGR formats) or corners X Y, X Y,
                      ... in plan of the plane or the map. All heights count.  [default: everything visible]
    extent            Rectangle of the plane in its coordinates; of a map, east and north. Instead of a region.
    photos            Folder of the photographs.  [default: recorded in the project]
    masks             Masks of the photographs, named as for `orient`. Where they are 0, neither points nor colours are
                      taken.  [default: masks and drawn areas of the project]
    cluster           Run tasks such as features and depth maps on other machines. Give the cluster folder from
                      `raybundle scheduler FOLDER` (extra [cluster]). shards: write the tasks for `raybundle worker` and
                      end.
    store             Storage of the products of stages. Give the URL of an object store for this project alone, e.g.
                      s3://bucket/folder (extra [cluster] and the package of the service). The project remembers it.
                      project: its own folder.  [default: as the last run, at first in the folder]
    wait_for_workers  Start when so many workers of cluster= are there.
    wait_limit        Seconds that workers are waited for. Then the run ends.
    jobs              Number of processors; 0: all.
    memory            Memory limit of all depth maps in work. Beyond it, approximate depths are computed by bands of
                      rows. At least one map is made.
    free_scale        Allow a result with free scale. Its lengths have no unit.
    title             Title of the report.
    client            Client, on the first page of the report.
    operator          Operator, on the first page of the report.
    pdf               Also write surface.html as surface.pdf: A4, with page numbers and bookmarks.
    language          Language of the report: en, de, fr. Tables and result.json stay English.  [default: that of the
                      project, else en]
    """

def transform_to_points(
    result: Adjustment | str | Path,
    out: str | Path,
    *,
    origin: str = '',
    axis: str = '',
    plane: str = '',
    level: str | Sequence[str] = (),
) -> Path:
    """Write the points of a result in a coordinate system by points: OUT/points.csv and transformation.json.

    `transform_to_points("facade-project", "facade-axes", origin="A", axis="B", plane="C")`, or `level=("P", "Q", "R")`.

    points.csv           point, role, X, Y, Z, sX, sY, sZ, and the covariances cXY, cXZ, cYZ
    transformation.json  rotation and translation: X_new = rotation X + translation

    origin  Point with X = Y = Z = 0.
    axis    Point on the X axis: Y = Z = 0, X above 0; with a level: Y = 0, X above 0.
    plane   Point in the XY plane: Z = 0, Y above 0.
    level   Point at the same height as the others given here, e.g. on water or a floor. Three or more points give the
            XY plane instead of a plane point. Repeat it, or separate points by commas.
    """

def write_target_sheet(
    target: str | None,
    out: str | Path,
    *,
    table: str | Path | None = None,
    bits: int | None = None,
    count: int | None = None,
    codes: str | None = None,
    spacing: float | None = None,
    dot_radius: float = 5.0,
    paper: Literal['A0', 'A1', 'A2', 'A3', 'A4'] = 'A4',
    lying: bool = False,
    tile: Literal['A1', 'A2', 'A3', 'A4'] | None = None,
    polarity: Literal['dark', 'light'] = 'dark',
) -> Sheet:
    """Write targets at true size, with a scale bar to verify the printer, and FILE.toml with ids, radii, positions.

    target    family as "aicon14", "chessboard-9x6", "apriltag-36h11"; None with `table` and `bits`
    out       new FILE.pdf or FILE.svg
    settings  as of the command line, by the names of `SheetSettings`: codes="1-50", or count=20; lengths in millimetres
    raises    InputError for what does not go together or does not fit on the paper

    table       Table of custom targets: id,code; with bits=.
    bits        Number of sectors of the rings of table=.
    count       Number of targets, chosen to stay distinct when partly hidden.
    codes       Numbers of the targets, instead of count=.
    spacing     Boards: side of a square, distance of dots. Tags: their side.
    dot_radius  Radius of the dots.
    paper
    lying       Print with the longer side horizontal.
    tile        Cut the sheet into parts for a printer of this paper.
    polarity    Colour of the targets. dark: black on white. light: white on black.
    """
