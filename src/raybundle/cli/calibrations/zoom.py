"""`raybundle calibration zoom`."""

from __future__ import annotations

from datetime import UTC, datetime
from pathlib import Path
from typing import TYPE_CHECKING, Any

import click

from raybundle.cli.calibrations.given import LIBRARY, of_result, our_camera
from raybundle.cli.common import COMMAND_SETTINGS, FOLDER, NEW_FOLDER, TRACEBACK
from raybundle.cli.numbers import NOT_NEGATIVE, POSITIVE
from raybundle.errors import InputError

if TYPE_CHECKING:
    from raybundle.block.zoom import ZoomSetting
    from raybundle.io.cameras.library import CameraKey


@click.command("zoom", context_settings=COMMAND_SETTINGS)
@click.argument("results", type=FOLDER, nargs=-1, required=True, metavar="RESULT...")
@click.option(
    "--out", type=NEW_FOLDER, required=True, metavar="FOLDER", help="New folder for camera.toml and zoom.toml."
)
@click.option(
    "--focal", type=POSITIVE, multiple=True, metavar="MM",
    help="EXIF focal length of each camera in its order, where the photographs do not tell it.",
)  # fmt: skip
@click.option("--resolution", type=NOT_NEGATIVE, metavar="MM", help="Step of the focal lengths; 0: not rounded.")
@click.option("--keep", is_flag=True, help="Keep it in the camera library, where orient finds it for any focal length.")
@LIBRARY
@TRACEBACK
def zoom(
    results: tuple[Path, ...], out: Path, focal: tuple[float, ...], resolution: float | None, library: Path | None,
    *, keep: bool,
) -> None:  # fmt: skip
    """Combine calibrations of a zoom lens at several settings into one for every focal length in between.

    RESULT are result folders of `raybundle calibrate`, all with the same --model and --estimate.

    \b
    Example:
      raybundle calibrate 24mm/ --target aicon14 --estimate c,x0,y0,K1,K2,P1,P2 --out z24
      raybundle calibration zoom z24 z35 z50 z70 --out lens --keep
    """  # noqa: D301
    from raybundle.calibration.zoom import calibrate_zoom, zoom_residuals  # noqa: PLC0415
    from raybundle.io.cameras.library import LibraryEntry, add_entry  # noqa: PLC0415
    from raybundle.io.cameras.zoom_files import write_zoom  # noqa: PLC0415
    from raybundle.io.folders import new_folder  # noqa: PLC0415

    settings, keys = _zoom_settings(results, focal)
    lens = calibrate_zoom(sorted(settings, key=lambda s: s.focal_mm), resolution_mm=resolution)
    if out.exists():
        raise InputError("stands there already and is not overwritten; choose another name", file=out)
    with new_folder(out) as folder:
        write_zoom(lens, folder)
    low, high = lens.range_mm
    rounded = f"rounded to {lens.resolution_mm:g} mm" if lens.resolution_mm else "not rounded"
    click.echo(f" {len(settings)} settings from {low:g} to {high:g} mm, focal lengths {rounded}")
    worst = abs(zoom_residuals(lens, sorted(settings, key=lambda s: s.focal_mm))).max(axis=0)
    for symbol, variable, order, most in zip(lens.symbols, lens.variables, lens.orders, worst, strict=True):
        click.echo(f"  {symbol}: order {order} in {variable}, largest residual {most:.2g}")
    click.echo(f" scatter about the curves: {lens.variance_factor:.2f} times what the calibrations' variances allow")
    click.echo(f" written: {out}")
    if keep:
        key = keys[0]
        if any((k.make, k.model, k.serial, k.lens) != (key.make, key.model, key.serial, key.lens) for k in keys):
            raise InputError("the settings are of different cameras or lenses by their EXIF; not kept")
        entry = LibraryEntry(
            key=_any_focal(key), camera=lens.camera, zoom=lens, date=datetime.now(UTC).date().isoformat(),
            source=f"zoom calibration of {len(settings)} settings",
        )  # fmt: skip
        click.echo(f" kept in the camera library: {add_entry(entry, library)}")


def _any_focal(key: CameraKey) -> CameraKey:
    """The key of a zoom lens: that of a setting without its focal length and focus."""
    from dataclasses import replace  # noqa: PLC0415

    return replace(key, focal_mm=None, focus_m=None)


def _zoom_settings(results: tuple[Path, ...], focal: tuple[float, ...]) -> tuple[list[ZoomSetting], list[CameraKey]]:
    """The settings and EXIF keys of all cameras in some result folders."""
    from raybundle.block.zoom import ZoomSetting  # noqa: PLC0415
    from raybundle.io.cameras.library import CameraKey  # noqa: PLC0415
    from raybundle.results.folder import read_result  # noqa: PLC0415

    settings: list[ZoomSetting] = []
    keys: list[CameraKey] = []
    for folder in results:
        told = read_result(folder).result.get("calibration", {})
        for calibration, _ in of_result(folder):
            if calibration.covariance is None:
                raise InputError(
                    f"camera {calibration.id} has no covariance; calibrate it with statistics", file=folder
                )
            exif: dict[str, Any] = told.get(calibration.id, {}).get("exif", {})
            key = CameraKey(**exif)
            at = focal[len(settings)] if len(focal) > len(settings) else key.focal_mm
            if at is None:
                raise InputError(
                    f"the EXIF focal length of camera {calibration.id} is not known; give one --focal for each camera",
                    file=folder,
                )
            own, _ = our_camera(calibration)
            settings.append(
                ZoomSetting(
                    focal_mm=at, camera=own, free=calibration.free, covariance=calibration.covariance,
                    focus_m=key.focus_m,
                )
            )  # fmt: skip
            keys.append(key)
    return settings, keys
