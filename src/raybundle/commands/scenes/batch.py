"""`raybundle rpc batch`: many scenes corrected on one file of control, with one table of their biases."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import MISSING, dataclass, replace
from pathlib import Path
from typing import TYPE_CHECKING, Any, Literal

from raybundle.commands.scenes.correct import (
    ControlSettings,
    Correction,
    check_correction,
    correction_on,
    with_corrected,
)
from raybundle.commands.scenes.inputs import RASTERS, scene_input
from raybundle.errors import InputError, Message, RaybundleError, Severity, as_detail, message
from raybundle.numerics.progress import Progress, silent
from raybundle.settings import keywords, made, path_of, setting

if TYPE_CHECKING:
    from raybundle.io.digits import Digits
    from raybundle.io.scenes.control import SceneControl

ENDINGS = {"txt": "_RPC.TXT", "rpb": ".RPB", "geom": ".geom", "tif": ".tif"}
BIASES = "biases.csv"


@dataclass(frozen=True, slots=True, kw_only=True)
class RpcBatchSettings(ControlSettings):
    """Which scenes are corrected on which control."""

    scenes: tuple[Path, ...]
    """scene files, pictures, or folders of them"""
    control: Path = setting(MISSING, "Control as for `rpc correct`, with a column image.", metavar="FILE")
    out: Path = setting(MISSING, "New folder for the corrected RPC and the table of biases.", metavar="FOLDER")
    to: Literal["txt", "rpb", "geom", "tif"] = setting(
        "txt", "Output for each scene: NAME_RPC.TXT, NAME.RPB, NAME.geom, or NAME.tif (a copy of its picture)."
    )


@dataclass(frozen=True, slots=True, kw_only=True)
class BatchScene:
    """What became of one scene."""

    name: str
    correction: Correction | None = None
    file: Path | None = None
    """what was written of it"""
    problem: Message | None = None
    """why nothing was"""

    @property
    def problem_line(self) -> str:
        """Its problem in one line; empty where there is none."""
        return " ".join(self.problem.text().split()) if self.problem is not None else ""

    remarks: tuple[str, ...] = ()


@dataclass(frozen=True, slots=True, kw_only=True)
class Batch:
    """What became of the scenes."""

    scenes: tuple[BatchScene, ...]
    table: Path

    @property
    def corrected(self) -> tuple[BatchScene, ...]:
        """Those that were corrected."""
        return tuple(s for s in self.scenes if s.correction is not None)

    @property
    def failed(self) -> tuple[BatchScene, ...]:
        """Those that were not, with their problems."""
        return tuple(s for s in self.scenes if s.correction is None)


@keywords(RpcBatchSettings)
def rpc_batch(
    scenes: str | Path | Sequence[str | Path], control: str | Path, out: str | Path, *, progress: Progress = silent,
    **settings: Any,
) -> Batch:  # fmt: skip
    """Correct the RPC of many scenes on one file of control; a scene that cannot be costs that scene.

    scenes    scene files, pictures, or folders of them
    control   ground and image points, each with the image in which it was measured
    out       new folder: one RPC a scene, and biases.csv with a row a scene
    settings  as of the command line, by the names of `RpcBatchSettings`: to="tif"
    raises    InputError where no scene can be corrected, and for what cannot be read or written as a whole
    """
    given = (scenes,) if isinstance(scenes, str | Path) else scenes
    asked = {
        "scenes": tuple(path_of("scenes", s) for s in given), "control": path_of("control", control),
        "out": path_of("out", out),
    }  # fmt: skip
    return run_batch(made(RpcBatchSettings, {**asked, **settings}), progress)


def run_batch(s: RpcBatchSettings, progress: Progress = silent) -> Batch:
    """Correct and write all that can be, and the table."""
    from raybundle.io.folders import check_new_folder, new_folder
    from raybundle.io.raster_library import raster_library
    from raybundle.io.scenes.control import read_scene_control

    check_new_folder(s.out)
    if s.to == "tif":
        raster_library()
    control = read_scene_control(s.control, image_points=s.image_points, crs=s.crs, undulation=s.undulation)
    files = list(scenes_among(s.scenes))
    if not files:
        raise InputError("scene.none_here", file=s.scenes[0])
    if len(files) > 1 and not all(control.image):
        raise InputError("scene_control.image_missing", n=len(files), file=s.control)
    with new_folder(s.out) as folder:
        found: list[BatchScene] = []
        for done, file in enumerate(files):
            progress("correcting", done / len(files))
            found.append(_one(s, file, control, folder, {f.file.name for f in found if f.file is not None}))
        progress("correcting", 1.0)
        if not any(f.correction is not None for f in found):
            details = [
                message("scene.not_corrected", details=[f.problem] if f.problem else (), scene=f.name)
                for f in found[:5]
            ]
            raise InputError("scene.none_corrected", details=details, n=len(found), file=s.control)
        _write_biases(folder / BIASES, found)
    return Batch(
        scenes=tuple(f if f.file is None else replace(f, file=s.out / f.file.name) for f in found),
        table=s.out / BIASES,
    )


def scenes_among(given: Sequence[Path]) -> Iterator[Path]:
    """The scenes among files and folders: pictures with an RPC, and files that show one without a picture."""
    from raybundle.io.scenes.control import scene_key

    for path in given:
        if not path.is_dir():
            yield path
            continue
        groups: dict[str, list[Path]] = {}
        for file in sorted(path.iterdir()):
            if file.is_file() and not file.name.startswith("."):
                groups.setdefault(scene_key(file.name), []).append(file)
        for files in groups.values():
            chosen = _scene_of(files)
            if chosen is not None:
                yield chosen


def _scene_of(files: Sequence[Path]) -> Path | None:
    """Of files of one name the picture with an RPC, else the file that shows one."""
    from raybundle.io.scenes import is_scene
    from raybundle.workflows.scenes.images import model_of

    pictures = [f for f in files if f.suffix.lower() in RASTERS]
    for picture in pictures:
        try:
            if model_of(picture) is not None:
                return picture
        except RaybundleError:
            return picture  # damaged: it is reported when it is read
    others = [f for f in files if f not in pictures and f.suffix.lower() not in {".csv", ".geojson", ".gpkg"}]
    return next((f for f in others if is_scene(f)), None)


def _one(s: RpcBatchSettings, file: Path, control: SceneControl, folder: Path, taken: set[str]) -> BatchScene:
    """One scene, corrected and written, or why not."""
    from raybundle.io.scenes.writing import write_rpc

    stem = file.name.removesuffix("_RPC.TXT").removesuffix("_rpc.txt")
    target = folder / f"{Path(stem).stem if stem == file.name else stem}{ENDINGS[s.to]}"
    try:
        if target.name in taken:
            raise InputError("scene.name_twice", name=target.stem, file=file)
        given = scene_input(file)
        if given.scene.rpc is None:
            raise InputError("scene.rpc_missing", file=file)
        found = correction_on(given, control.of(given.name, given.scene.file.name), s)
        check_correction(found, s)
        found = with_corrected(found, s.heights)
        assert found.corrected is not None
        write_rpc(found.corrected, target, given.picture)
    except RaybundleError as error:
        return BatchScene(name=file.name, problem=replace(as_detail(error), severity=Severity.WARNING))
    return BatchScene(name=file.name, correction=found, file=target, remarks=given.remarks)


def _write_biases(path: Path, scenes: Sequence[BatchScene]) -> None:
    from raybundle.io.digits import COUNT, STD, by_sigma
    from raybundle.io.tables import write_table
    from raybundle.scenes.bias import BIAS_PARAMETERS

    symbols = BIAS_PARAMETERS["affine"]
    columns: dict[str, list[Any]] = {}

    def put(name: str, value: Any) -> None:
        columns.setdefault(name, []).append(value)

    for scene in scenes:
        c = scene.correction
        fit = None if c is None else c.fit
        errors = None if c is None else c.errors
        checked = None if c is None else c.checked
        values = {} if fit is None else dict(zip(BIAS_PARAMETERS[fit.kind], fit.values.tolist(), strict=True))
        sigmas = {} if fit is None else dict(zip(BIAS_PARAMETERS[fit.kind], fit.sigma.tolist(), strict=True))
        none = float("nan")
        put("scene", scene.name)
        put("bias", "" if fit is None else fit.kind)
        put("points", 0.0 if c is None else float(len(c.ids) - len(c.advice.set_aside)))
        put("set_aside", 0.0 if c is None else float(len(c.advice.set_aside)))
        for symbol in symbols:
            put(f"{symbol}_px", values.get(symbol, none))
            put(f"s{symbol}_px", sigmas.get(symbol, none))
        for k, axis in enumerate("xy"):
            put(f"rms_{axis}_px", none if fit is None else float(fit.rms[k]))
        put("check_points", 0.0 if checked is None else float(len(checked.ids)))
        for k, axis in enumerate("xy"):
            put(f"check_rms_{axis}_px", none if checked is None else float(checked.rms_px[k]))
        put("err_bias_m", none if errors is None else errors.err_bias_m)
        put("err_rand_m", none if errors is None or errors.err_rand_m is None else errors.err_rand_m)
        put("file", "" if scene.file is None else scene.file.name)
        put("problem", scene.problem_line)
    import numpy as np

    table = {n: tuple(v) if isinstance(v[0], str) else np.array(v, float) for n, v in columns.items()}
    digits: dict[str, Digits] = {n: STD for n, v in table.items() if isinstance(v, np.ndarray)}
    digits |= dict.fromkeys(("points", "set_aside", "check_points"), COUNT)
    digits |= {f"{symbol}_px": by_sigma(np.asarray(table[f"s{symbol}_px"])) for symbol in symbols}
    write_table(path, table, digits)
