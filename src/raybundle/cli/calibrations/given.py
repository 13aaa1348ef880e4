"""Calibrations as the command line gives them: options that the subcommands share, and what they stand for."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, Any

import click

from raybundle.cli.common import FOLDER
from raybundle.errors import InputError

if TYPE_CHECKING:
    from raybundle.block import Camera
    from raybundle.io.calibrations import Calibration

SIZE = click.option(
    "--size", nargs=2, type=click.IntRange(1), metavar="WIDTH HEIGHT", help="Format [px], where the file lacks it."
)
GIVEN = click.option("--from", "given", metavar="FORMAT", help="Format of the file.  [default: recognised]")
CAMERA = click.option("--camera", metavar="ID", help="One camera of a file that holds several.")
LIBRARY = click.option(
    "--library", type=FOLDER, metavar="FOLDER", help="The library.  [default: RAYBUNDLE_CAMERAS, or the user's folder]"
)


def calibrations_of(source: Path, given: str | None, size: tuple[int, int] | None) -> tuple[Calibration, ...]:
    """All calibrations of a file, or of the cameras of a result folder."""
    from raybundle.io.calibrations import read_calibrations  # noqa: PLC0415

    if given is None and (source / "result.json").is_file():
        return tuple(c for c, _ in of_result(source))
    return read_calibrations(source, given, size_px=size)


def of_result(folder: Path) -> list[tuple[Calibration, dict[str, Any]]]:
    """The adjusted cameras of a result folder with their covariance, and what the library wants to know of them."""
    import numpy as np  # noqa: PLC0415  (nothing numeric is loaded for the help)

    from raybundle.io.calibrations import Calibration  # noqa: PLC0415
    from raybundle.results.folder import read_result  # noqa: PLC0415

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
        raise InputError(f"holds no camera {id_!r}; known: {', '.join(c.id for c in found)}", file=source)
    return chosen


def one_of(source: Path, given: str | None, size: tuple[int, int] | None, id_: str | None) -> Calibration:
    """The one calibration of a file; raises InputError where it holds several and none is named."""
    found = list(chosen_of(calibrations_of(source, given, size), id_, source))
    if len(found) != 1:
        raise InputError(
            f"holds {len(found)} cameras ({', '.join(c.id for c in found)}); choose one: --camera", file=source
        )
    return found[0]


def our_camera(calibration: Calibration) -> tuple[Camera, str]:
    """The calibration as one of our cameras, and what the fit left, in words."""
    from raybundle.block import Camera  # noqa: PLC0415
    from raybundle.io.calibrations import convert_calibration  # noqa: PLC0415

    conversion = convert_calibration(calibration, "raybundle")
    camera = conversion.calibration.camera
    assert isinstance(camera, Camera)
    words = "" if conversion.exact else f"camera {calibration.id} was fitted: largest {conversion.largest_px:.2g} px"
    return camera, words
