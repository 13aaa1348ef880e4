"""Calibrations in files and result folders, and cameras of photographs that are stored turned or reduced."""

from __future__ import annotations

from collections.abc import Sequence
from collections.abc import Set as AbstractSet
from pathlib import Path
from typing import TYPE_CHECKING, Any

from raybundle.errors import InputError, Text, as_detail, note, phrase
from raybundle.io.folders import check_free

if TYPE_CHECKING:
    from raybundle.block import Camera
    from raybundle.io.calibrations import Calibration, Conversion


def calibrations_of(source: Path, given: str | None, size: tuple[int, int] | None) -> tuple[Calibration, ...]:
    """All calibrations of a file, or of the cameras of a result folder."""
    from raybundle.io.calibrations import read_calibrations

    if given is None and (source / "result.json").is_file():
        return tuple(c for c, _ in of_result(source))
    return read_calibrations(source, given, size_px=size)


def of_result(folder: Path) -> list[tuple[Calibration, dict[str, Any]]]:
    """The adjusted cameras of a result folder with their covariance, and what the library wants to know of them."""
    import numpy as np

    from raybundle.io.calibrations import Calibration
    from raybundle.results.folder import read_result

    result = read_result(folder)
    images = result.block.images
    found: list[tuple[Calibration, dict[str, Any]]] = []
    for k, camera in enumerate(result.block.cameras):
        table: dict[str, dict[str, float]] = result.result.get("correlations", {}).get(camera.id, {})
        free = tuple(table)
        std = [result.result["cameras"][camera.id][s]["std"] for s in free]
        covariance = None
        if free and all(s is not None for s in std):
            covariance = np.array([[table[a][b] for b in free] for a in free]) * np.outer(std, std)
        verdict: dict[str, Any] = result.result.get("calibration", {}).get(camera.id, {})
        facts = {
            "sigma0": result.result.get("sigma0"),
            "photographs": int(verdict.get("photographs", (np.asarray(images.camera) == k).sum())),
            "grade": verdict.get("grade", ""),
            "source": f"adjustment {folder.name} of {result.block.name}",
        }
        calibration = Calibration(
            id=camera.id,
            camera=camera,
            pixel_mm=camera.pixel_mm,
            free=free if covariance is not None else (),
            covariance=covariance,
        )
        found.append((calibration, facts))
    return found


def chosen_of(found: tuple[Calibration, ...], id_: str | None, source: Path) -> tuple[Calibration, ...]:
    """That of one camera where one is named; raises InputError where there is none of this name."""
    if id_ is None:
        return found
    chosen = tuple(c for c in found if c.id == id_)
    if not chosen:
        raise InputError("camera.unknown", camera=id_, known=[c.id for c in found], file=source)
    return chosen


def one_of(source: Path, given: str | None, size: tuple[int, int] | None, id_: str | None) -> Calibration:
    """The one calibration of a file; raises InputError where it holds several and none is named."""
    found = list(chosen_of(calibrations_of(source, given, size), id_, source))
    if len(found) != 1:
        raise InputError(
            "calibration.several",
            n=len(found),
            cameras=[c.id for c in found],
            file=source,
        )
    return found[0]


def our_camera(calibration: Calibration) -> tuple[Camera, Text | None]:
    """The calibration as one of our cameras, and the deviation of the fit; None: it is exact."""
    from raybundle.block import Camera
    from raybundle.io.calibrations import convert_calibration

    conversion = convert_calibration(calibration, "raybundle")
    camera = conversion.calibration.camera
    assert isinstance(camera, Camera)
    if conversion.exact:
        return camera, None
    return camera, phrase("calibration_remark.fitted", camera=calibration.id, largest_px=conversion.largest_px)


def calibrations_of_files(folder: Path) -> tuple[tuple[Calibration, ...], tuple[str, ...]]:
    """A calibration for each way in which files are stored other than their camera has its pixels, and cautions.

    Where the camera's model cannot be turned, that is a warning: the camera of the result is then the only one.
    """
    from raybundle.block.frames import stored_ways
    from raybundle.io.calibrations import Calibration
    from raybundle.results.folder import read_result

    block = read_result(folder).block
    found: list[Calibration] = []
    cautions: list[str] = []
    for way in stored_ways(block):
        own = block.cameras[way.camera].id
        stored: dict[str, Any] = {
            "n": len(way.images), "images": way.images, "turned_deg": way.frame.turned,
            "width_px": way.frame.width_px, "height_px": way.frame.height_px, "other": own,
        }  # fmt: skip
        try:
            camera = way.camera_of_files(block)
        except InputError as error:
            lacking = note("calibration_remark.not_of_stored", details=[as_detail(error)], **stored)
            cautions.append(Text.of(lacking))
            continue
        remark = phrase("calibration_remark.of_stored", camera=camera.id, **stored)
        found.append(Calibration(id=camera.id, camera=camera, pixel_mm=camera.pixel_mm, remarks=(remark,)))
    return tuple(found), tuple(cautions)


def with_names(
    conversions: Sequence[Conversion], of_files: AbstractSet[str], out: Path, *, several: bool
) -> list[tuple[Path, list[Conversion]]]:
    """The files to write: one, or one for each stored way beside that of the result where a file holds one camera.

    of_files  ids of the cameras of `calibrations_of_files`
    raises    InputError where one of them is there already
    """
    beside = [c for c in conversions if c.calibration.id in of_files]
    if several or not 0 < len(beside) < len(conversions):
        return [(out, list(conversions))]
    files = [(out, [c for c in conversions if c.calibration.id not in of_files])]
    files += [(out.with_stem(f"{out.stem}-{c.calibration.id}"), [c]) for c in beside]
    for path, _ in files:
        check_free(path)
    return files
