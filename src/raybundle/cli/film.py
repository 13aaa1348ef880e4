"""`raybundle film`."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, cast

import click

from raybundle.cli.common import COMMAND_SETTINGS, FOLDER, NEW_FOLDER, common_options, counted
from raybundle.cli.numbers import POSITIVE
from raybundle.errors import InputError

if TYPE_CHECKING:
    from raybundle.block import Camera
    from raybundle.io.film.fiducials import Film, Marks, Model, Reseau

LARGE_SHRINKAGE = 0.01


@click.command("film", context_settings=COMMAND_SETTINGS)
@click.argument("marks_file", type=FOLDER, metavar="MARKS")
@click.option("--calibrated", type=FOLDER, required=True, metavar="FILE", help="CSV: mark,x_mm,y_mm[,sx_mm,sy_mm].")
@click.option(
    "--camera",
    "camera_file",
    type=FOLDER,
    required=True,
    metavar="FILE",
    help="TOML with one [cameras.ID]: format, c_mm, x0_mm, y0_mm of the certificate.",
)
@click.option("--points", "points_file", type=FOLDER, metavar="FILE", help="CSV: image,point,x_px,y_px[,sx_px,sy_px].")
@click.option("--pixel-mm", type=POSITIVE, metavar="MM", help="Pixel of the scanner.  [default: that of the camera]")
@click.option("--model", type=click.Choice(["similarity", "affine", "projective"]), default="affine", show_default=True)
@click.option(
    "--reseau",
    type=click.Choice(["none", "bilinear", "affine"]),
    default="none",
    show_default=True,
    help="Local correction between the crosses of a reseau.",
)
@click.option("--out", type=NEW_FOLDER, required=True, metavar="FOLDER", help="New folder; nothing is overwritten.")
@common_options
def command(
    marks_file: Path,
    calibrated: Path,
    camera_file: Path,
    points_file: Path | None,
    pixel_mm: float | None,
    model: str,
    reseau: str,
    out: Path,
    progress: str,
) -> None:
    """Bring image points of scanned film into the camera's frame by its fiducial marks or reseau.

    MARKS is a CSV image,mark,x_px,y_px[,sx_px,sy_px] of the marks measured in the scans. Written are film.csv
    (shrinkage and fit of each scan), residuals.csv, cameras.toml and, with --points, observations.csv for a block
    folder, in the pixel frame of the ideal camera.

    \b
    Example:
      raybundle film fiducials.csv --calibrated certificate.csv --camera rmk.toml --points points.csv --out film
    """  # noqa: D301  (\b is click's mark for a paragraph that keeps its lines)
    del progress
    from raybundle.io.film.fiducials import film_of, read_calibrated, read_marks, straight_points  # noqa: PLC0415

    if out.exists() and (not out.is_dir() or any(out.iterdir())):
        raise InputError("stands there already and is not overwritten; choose another name", file=out)
    certificate = read_calibrated(calibrated)
    camera = _camera(camera_file)
    marks = read_marks(marks_file, "mark", certificate)
    points = None if points_file is None else read_marks(points_file, "point")
    films: dict[str, Film] = {}
    failed: list[str] = []
    for image in dict.fromkeys(marks.image):
        rows = marks.of(image)
        try:
            films[image] = film_of(
                image,
                [marks.name[k] for k in rows.tolist()],
                marks.xy_px[rows],
                marks.sigma_px[rows],
                certificate,
                pixel_mm=pixel_mm or camera.pixel_mm[0],
                model=cast("Model", model),
                reseau=cast("Reseau", reseau),
            )
        except InputError as error:
            failed.append(str(error))
    if failed:
        raise InputError("\n  ".join([*failed, "nothing is written"]), file=marks_file)
    straight = None if points is None else straight_points(points, films, camera)
    _write(out, films, camera, straight)
    _print(films, points)
    click.echo(f" film: {out}")


def _camera(path: Path) -> Camera:
    from raybundle.io.block.toml import read_cameras  # noqa: PLC0415

    cameras = read_cameras(path)
    if len(cameras) != 1:
        raise InputError(f"{len(cameras)} cameras stand here; give one, that of the film", file=path)
    return cameras[0]


def _write(
    out: Path,
    films: dict[str, Film],
    camera: Camera,
    straight: tuple[Marks, object] | None,
) -> None:
    import numpy as np  # noqa: PLC0415

    from raybundle.io.calibrations.ours import cameras_text  # noqa: PLC0415
    from raybundle.io.folders import new_folder  # noqa: PLC0415
    from raybundle.io.tables import write_table  # noqa: PLC0415

    every = list(films.values())
    shrinkage = [f.shrinkage for f in every]
    values, std = (np.array([getattr(s, n) for s in shrinkage]) for n in ("values", "std"))
    unit = {"shrinkage_x_ppm": 1e6, "shrinkage_y_ppm": 1e6, "shear_arcsec": 206264.806, "turn_deg": 57.29577951308232}
    columns = {
        "image": [f.image for f in every],
        "model": [f.model for f in every],
        "marks": np.array([len(f.marks) for f in every], float),
        "redundancy": np.array([f.redundancy for f in every], float),
        "sigma0": np.array([f.sigma0 for f in every]),
        "rms_um": np.array([np.sqrt(np.mean(f.residuals_mm**2)) * 1000 for f in every]),
        "mirrored": ["yes" if f.mirrored else "no" for f in every],
    }
    for k, (name, factor) in enumerate(unit.items()):
        columns |= {name: values[:, k] * factor, f"s{name}": std[:, k] * factor}
    with new_folder(out) as folder:
        (folder / "cameras.toml").write_text(cameras_text([camera]), encoding="utf-8")
        write_table(folder / "film.csv", columns)
        rows = {"image": [f.image for f in every for _ in f.marks], "mark": [m for f in every for m in f.marks]}
        residuals, w = np.vstack([f.residuals_mm for f in every]) * 1000, np.vstack([f.w for f in every])
        numbers = {"vx_um": residuals[:, 0], "vy_um": residuals[:, 1], "wx": w[:, 0], "wy": w[:, 1]}
        write_table(folder / "residuals.csv", {**rows, **numbers})
        if straight is not None:
            points, cov = straight[0], np.asarray(straight[1])
            write_table(
                folder / "observations.csv",
                {
                    "image": points.image,
                    "point": points.name,
                    "x_px": points.xy_px[:, 0],
                    "y_px": points.xy_px[:, 1],
                    "sx_px": points.sigma_px[:, 0],
                    "sy_px": points.sigma_px[:, 1],
                    "sxy_px2": cov[:, 2],
                },
            )


def _print(films: dict[str, Film], points: Marks | None) -> None:
    import numpy as np  # noqa: PLC0415

    from raybundle.io.film.fiducials import suspects  # noqa: PLC0415

    measured = "" if points is None else f", {counted(len(points.image), 'image point')}"
    click.echo(f" {counted(len(films), 'scan')}{measured}")
    click.echo('  image         marks  sigma0   rms [um]   shrinkage x, y [ppm]     shear ["]   turn [deg]')
    for f in films.values():
        s = f.shrinkage
        rms = float(np.sqrt(np.mean(f.residuals_mm**2))) * 1000
        x, y = (f"{s.values[k] * 1e6:.0f} +- {s.std[k] * 1e6:.0f}" for k in (0, 1))
        shear, turn = s.values[2] * 206264.806, np.degrees(s.values[3])
        sigma0 = f"{f.sigma0:6.2f}" if f.redundancy else "     -"
        mirror = "  mirrored" if f.mirrored else ""
        fit = f"  {f.image:<14}{len(f.marks):>4}  {sigma0}  {rms:8.1f}"
        click.echo(f"{fit}   {x:>12}, {y:<12} {shear:8.1f}   {turn:9.4f}{mirror}")
        if f.mirrored:
            click.echo(
                "    mirrored: the film was scanned from behind, or two marks opposite to each other are exchanged"
            )
        if np.abs(s.values[:2]).max() > LARGE_SHRINKAGE:
            click.echo("    no film shrinks by more than 1 %: look at --pixel-mm")
        if f.misfit > 1:
            click.echo(
                f"    residuals are larger than stated; standard deviations are enlarged by sigma0 = {f.sigma0:.3g}"
            )
        if bad := suspects(f):
            click.echo(f"    suspect marks: {', '.join(bad)}; measure them again")
    if all(f.redundancy == 0 for f in films.values()):
        click.echo(
            " remark: as many marks as unknowns: a wrong one is not noticed; measure more, or take a simpler model"
        )
