"""`raybundle rectify`."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, Any

import click

from raybundle.cli.common import COMMAND_SETTINGS, FOLDER, FREE_SCALE, NEW_FILE, common_options, counted, significant
from raybundle.cli.numbers import NUMBER, POSITIVE, Number
from raybundle.errors import InputError

if TYPE_CHECKING:
    from raybundle.io.pictures.rectified import Rectified
    from raybundle.numerics.progress import Progress
    from raybundle.workflows.rectify import Grid, SinglePhoto

Area = tuple[float, float, float, float]
ROUNDING = 1e-9
"""Share of the extent of the points below which a difference is that of rounding."""


@click.command("rectify", context_settings=COMMAND_SETTINGS)
@click.argument("source", type=FOLDER, metavar="RESULT|PHOTO")
@click.option("--out", type=NEW_FILE, required=True, metavar="FILE", help="New picture: .tif, .png or .jpg.")
@click.option("--pixel", type=POSITIVE, metavar="SIZE",
    help="Size of a pixel in the object's unit.  [default: that of the photographs]")  # fmt: skip
@click.option("--area", type=(NUMBER, NUMBER, NUMBER, NUMBER), metavar="LEFT BOTTOM RIGHT TOP",
    help="Part of the plane, in its coordinates.  [default: where the points lie]")  # fmt: skip
@click.option(
    "--plane", "points", metavar="A,B,C,...", help="Object points of the plane.  [default: that of most points]"
)
@click.option("--horizontal", is_flag=True, help="A level plane at the points' median height: floors, flat ground.")
@click.option("--photos", type=FOLDER, multiple=True, metavar="FOLDER", help="Where the photographs are.  [default: as "
    "the project knows]")  # fmt: skip
@click.option("--only", multiple=True, metavar="NAME", help="Take this photograph alone, or these.")
@click.option("--control", type=FOLDER, metavar="FILE",
    help="For a PHOTO: points of the plane and their places in it, as for orient.")  # fmt: skip
@click.option("--model", type=click.Choice(["projective", "affine"]), default="projective", show_default=True,
    help="For a PHOTO; affine: taken from far away, or copied flat.")  # fmt: skip
@click.option(
    "--calibration", type=FOLDER, metavar="CAMERA.toml", help="For a PHOTO: the lens, to take its distortion off."
)
@click.option("--mark-sigma", type=Number(0.001, 1e5), default=0.5, show_default=True, metavar="PX",
    help="For a PHOTO: standard deviation of a marked point.")  # fmt: skip
@FREE_SCALE
@common_options
def command(
    source: Path,
    out: Path,
    pixel: float | None,
    area: Area | None,
    points: str | None,
    horizontal: bool,  # noqa: FBT001  (a flag of the command line)
    photos: tuple[Path, ...],
    only: tuple[str, ...],
    control: Path | None,
    model: str,
    calibration: Path | None,
    mark_sigma: float,
    progress: str,
    *,
    free_scale: bool,
) -> None:
    """Bring photographs of a plane object to scale.

    RESULT is a result folder or the project of `orient`: every pixel comes from the photograph that shows it best,
    through the calibrated lens. PHOTO is one photograph with four points or more of the plane marked in it.
    Beside the picture stand a world file, which maps and drawings read, and NAME.toml with the plane.

    \b
    Example:
      raybundle rectify facade-project --out facade.tif --pixel 0.002
      raybundle rectify wall.jpg --control marks.csv --out wall.tif
    """  # noqa: D301  (\b is click's mark for a paragraph that keeps its lines)
    from raybundle.cli.progress import reporting  # noqa: PLC0415  (what computes is loaded after the help)
    from raybundle.io.pictures.rectified import check_picture  # noqa: PLC0415

    check_picture(out)
    if not source.exists():
        raise InputError("there is no such file or folder; check the path", file=source)
    with reporting(progress) as tell:
        if source.is_dir():
            if control is not None or calibration is not None:
                raise InputError("--control and --calibration belong to a single PHOTO; a result has both already")
            names = tuple(n.strip() for n in (points or "").split(",") if n.strip())
            lines = _of_result(source, out, pixel, area, names, photos, only, tell, horizontal=horizontal,
                               free_scale=free_scale)  # fmt: skip
        else:
            if points or horizontal or only or photos:
                raise InputError("--plane, --horizontal, --photos and --only belong to a result; a PHOTO has --control")
            if control is None:
                raise InputError("a single photograph needs points of the plane: --control FILE", file=source)
            lines = _of_photo(source, out, pixel, area, control, model, calibration, mark_sigma)
    click.echo("\n".join(f" {line}" for line in lines))


def _of_result(
    source: Path, out: Path, pixel: float | None, area: Area | None, names: tuple[str, ...], photos: tuple[Path, ...],
    only: tuple[str, ...], tell: Progress, *, horizontal: bool, free_scale: bool,
) -> list[str]:  # fmt: skip
    from dataclasses import replace  # noqa: PLC0415

    import numpy as np  # noqa: PLC0415

    from raybundle.block.frames import in_file_frames  # noqa: PLC0415
    from raybundle.cli.convert import read_source  # noqa: PLC0415
    from raybundle.io.formats import base as exchange  # noqa: PLC0415
    from raybundle.pipeline.project import photographs_of  # noqa: PLC0415
    from raybundle.workflows.rectify import FEW, grid_over, plane_of, rectify_block, usual_pixel  # noqa: PLC0415

    result = source / "result" if (source / "result" / "result.json").is_file() else source
    export, _ = read_source(result, None)
    export = replace(export, block=in_file_frames(export.block))
    if export.block.free_scale and not free_scale:
        raise InputError(
            f"{exchange.FREE_SCALE}, so that no picture to scale can be made; {exchange.GIVE_SCALE}, or --free-scale "
            "for a picture whose lengths are in no unit",
            file=source,
        )
    folders = photos or photographs_of(result)
    if not folders:
        raise InputError("where its photographs are is not known; say so with --photos FOLDER", file=source)
    plane = plane_of(export.block, names, horizontal=horizontal, sigma=export.sigma)
    size = pixel or usual_pixel(export.block, plane)
    grid = grid_over(plane.extent if area is None else np.array(area), size)
    picture, remarks = rectify_block(export.block, folders, plane, grid, only=only, progress=tell)
    unit = "" if export.block.free_scale else export.block.length_unit
    about: dict[str, Any] = {
        "unit": unit,
        "origin": plane.origin.tolist(), "right": plane.axes[0].tolist(), "up": plane.axes[1].tolist(),
        "normal": plane.axes[2].tolist(), "points": plane.points, "points_of": plane.of, "points_rms": plane.rms,
        "slope_rms": picture.slope[0], "slope_largest": picture.slope[1],
    }  # fmt: skip
    if export.block.free_scale:
        about["scale"] = "free"
    if export.frame is not None:
        about["frame"] = export.frame.as_mapping()
    _write(picture, out, grid, about)
    of = f" of {plane.of}" if plane.of > plane.points else ""
    told = [
        f"plane of {plane.points}{of} points, which lie {significant(plane.rms)} {unit or 'units'} off it (rms)",
    ]
    if plane.points < FEW * plane.of:
        told.append(
            f"caution: {100 * plane.points / plane.of:.0f} % of the points lie in this plane, so that most of what the "
            "picture shows is displaced; --plane A,B,C takes the wall that you mean"
        )
    return [
        *told,
        (
            f"what lies in front of or behind it is displaced by {picture.slope[0]:.2f} of its distance from it (rms; "
            f"{picture.slope[1]:.1f} at most)"
        ),
        *_picture_lines(picture, grid, unit, out),
        *(f"remark: {r}" for r in remarks),
    ]


def _of_photo(
    photo: Path, out: Path, pixel: float | None, area: Area | None, control: Path, model: str,
    calibration: Path | None, sigma_px: float,
) -> list[str]:  # fmt: skip
    import numpy as np  # noqa: PLC0415

    from raybundle.io.block.toml import read_cameras  # noqa: PLC0415
    from raybundle.io.photos.photo import read_photo  # noqa: PLC0415
    from raybundle.workflows.rectify import fit_photo, grid_over, rectify_photo  # noqa: PLC0415

    shown = read_photo(photo)
    camera = None
    if calibration is not None:
        fitting = [
            c for c in read_cameras(calibration) if (c.width_px, c.height_px) == (shown.width_px, shown.height_px)
        ]
        if len(fitting) != 1:
            raise InputError(
                f"{len(fitting)} of its cameras have the {shown.width_px} x {shown.height_px} px of the photograph; "
                "one is needed",
                file=calibration,
            )
        camera = fitting[0]
    names, xyz, xy = _marks(control, photo)
    single = fit_photo(names, xyz, xy, model=model, sigma_px=sigma_px, camera=camera)
    size = pixel or _usual(single)
    grid = grid_over(single.extent if area is None else np.array(area), size)
    picture = rectify_photo(photo, single, grid, (shown.width_px, shown.height_px))
    fit = single.fit
    about: dict[str, Any] = {
        "model": fit.model.name, "control_points": len(names), "sigma0": fit.sigma0, "redundancy": fit.redundancy,
        "differences": {n: d.tolist() for n, d in zip(names, single.differences, strict=True)},
    }  # fmt: skip
    _write(picture, out, grid, about)
    lines = [f"{'point':<12}{'right':>12}{'up':>12}   measured minus given"]
    # of four points the transformation leaves nothing but rounding
    nothing = ROUNDING * float(np.ptp(single.plane_xy, axis=0).max())
    differences = np.where(np.abs(single.differences) < nothing, 0.0, single.differences)
    lines += [f"{n:<12}{d[0]:>12.4g}{d[1]:>12.4g}" for n, d in zip(names, differences, strict=True)]
    if fit.redundancy:
        lines.append(f"sigma0 {fit.sigma0:.2f} (1 = marks as good as {sigma_px:g} px), redundancy {fit.redundancy}")
        if not fit.adequate:
            worst = names[int(np.linalg.norm(fit.residuals_px, axis=1).argmax())]
            lines.append(f"caution: {fit.reason}; the largest residual is that of {worst}")
    else:
        lines.append("caution: just enough points; one more would show whether they are right")
    if single.off_plane > 0:
        lines.append(f"the control points lie {significant(single.off_plane)} off their plane (rms)")
    return [*lines, *_picture_lines(picture, grid, "", out)]


def _marks(control: Path, photo: Path) -> tuple[list[str], Any, Any]:
    """Names, coordinates (n, 3) and pixels (n, 2) of the control points marked in this photograph."""
    import numpy as np  # noqa: PLC0415

    from raybundle.io.geo.control_files import read_control  # noqa: PLC0415

    file = read_control(control)
    m = file.measurements
    rows = [
        k for k, (name, p) in enumerate(zip(m.image, m.point.tolist(), strict=True))
        if name in {photo.name, photo.stem} and np.isfinite(file.xyz[p, :2]).all()
    ]  # fmt: skip
    if not rows:
        raise InputError(f"no point with X and Y is marked in {photo.name}; image names must agree", file=control)
    points = m.point[rows]
    return [file.ids[p] for p in points.tolist()], file.xyz[points], m.xy_px[rows]


def _usual(single: SinglePhoto) -> float:
    """The size of a photograph's pixel in the middle of the control points, in two digits."""
    import numpy as np  # noqa: PLC0415

    left, bottom, right, top = single.extent
    middle = np.array([[(left + right) / 2, (bottom + top) / 2, 0.0]])
    _, J, _ = single.fit.project_with_partials(middle)
    value = 1 / float(np.sqrt(abs(np.linalg.det(J[0, :, :2]))))
    digits = 10.0 ** (np.floor(np.log10(value)) - 1)
    return float(np.ceil(value / digits) * digits)


def _write(picture: Rectified, out: Path, grid: Grid, about: dict[str, Any]) -> None:
    head = {
        "left": grid.left, "top": grid.top, "pixel": grid.pixel, "width_px": grid.width, "height_px": grid.height,
    }  # fmt: skip
    picture.write(
        out, left=grid.left, top=grid.top, pixel=grid.pixel, about={**head, **about, "photographs": picture.shares}
    )


def _picture_lines(picture: Rectified, grid: Grid, unit: str, out: Path) -> list[str]:
    covered = 100 * float(picture.seen.mean())
    return [
        f"{out}: {grid.width} x {grid.height} px of {grid.pixel:g} {unit}".rstrip() + f", {covered:.0f} % covered from "
        f"{counted(len(picture.shares), 'photograph')}",
    ]
