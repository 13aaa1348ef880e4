"""`raybundle film`: image points of scanned film to the camera's frame, by fiducial marks or a reseau."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import MISSING, dataclass
from pathlib import Path
from typing import TYPE_CHECKING, Any, Literal

from raybundle.errors import InputError, Message, as_detail
from raybundle.io.folders import check_free
from raybundle.settings import POSITIVE, keywords, made, path_of, setting

if TYPE_CHECKING:
    from raybundle.block import Camera
    from raybundle.io.film.fiducials import Calibrated, Film, Marks
    from raybundle.numerics.arrays import Array


@dataclass(frozen=True, slots=True, kw_only=True)
class FilmSettings:
    """What is brought into the camera's frame, and how."""

    marks: Path
    """CSV image,mark,x_px,y_px[,sx_px,sy_px]"""
    calibrated: Path = setting(MISSING, "CSV of the calibrated marks: mark,x_mm,y_mm[,sx_mm,sy_mm].", metavar="FILE")
    calibration: Path = setting(
        MISSING, "TOML with one [cameras.ID]: format, c_mm, x0_mm, y0_mm of the certificate.", metavar="FILE"
    )
    image_points: Path | None = setting(
        None, "CSV of image points: image,point,x_px,y_px[,sx_px,sy_px].", metavar="FILE"
    )
    pixel_mm: float | None = setting(
        None, "Pixel size of the scanner.  [default: that of the camera]", metavar="MM", limits=POSITIVE
    )
    transformation: Literal["similarity", "affine", "projective"] = setting("affine", "")
    reseau: Literal["none", "bilinear", "affine"] = setting("none", "Correct locally between the crosses of a reseau.")
    out: Path = setting(MISSING, "New folder; nothing is overwritten.", metavar="FOLDER")


@dataclass(frozen=True, slots=True, kw_only=True)
class StraightFilm:
    """Scans with their transformation, and the points that were brought through it."""

    films: Mapping[str, Film]
    """by image"""
    points: Marks | None = None
    """as measured in the scans; None where none were given"""


@keywords(FilmSettings)
def film(marks: str | Path, out: str | Path, **settings: Any) -> StraightFilm:
    """Bring image points of scanned film into the camera's frame by its fiducial marks or reseau.

    marks     CSV image,mark,x_px,y_px[,sx_px,sy_px] of the marks measured in the scans
    out       new folder: film.csv (shrinkage and fit of each scan), residuals.csv, cameras.toml, observations.csv
    settings  as of the command line, by the names of `FilmSettings`: calibrated="marks.csv", calibration="rmk.toml"
    raises    InputError for what cannot be read, and where the marks of a scan do not fit the certificate

    Limits: with as many marks as unknowns a wrong mark is not noticed.
    """
    return run_film(made(FilmSettings, {"marks": path_of("marks", marks), "out": path_of("out", out), **settings}))


def run_film(settings: FilmSettings) -> StraightFilm:
    """Fit each scan, and write what comes of it."""
    from raybundle.io.film.fiducials import read_calibrated, read_marks, straight_points

    s = settings
    check_free(s.out)
    certificate = read_calibrated(s.calibrated)
    camera = _camera(s.calibration)
    marks = read_marks(s.marks, "mark", certificate)
    points = None if s.image_points is None else read_marks(s.image_points, "point")
    films = _films(s, marks, certificate, s.pixel_mm or camera.pixel_mm[0])
    _write(s.out, films, camera, None if points is None else straight_points(points, films, camera))
    return StraightFilm(films=films, points=points)


def _films(s: FilmSettings, marks: Marks, certificate: Calibrated, pixel_mm: float) -> dict[str, Film]:
    """The transformation of each scan; raises InputError that names all that have none."""
    from raybundle.io.film.fiducials import film_of

    films: dict[str, Film] = {}
    failed: list[Message] = []
    for image in dict.fromkeys(marks.image):
        rows = marks.of(image)
        names = [marks.name[k] for k in rows.tolist()]
        try:
            films[image] = film_of(
                image, names, marks.xy_px[rows], marks.sigma_px[rows], certificate, pixel_mm=pixel_mm,
                model=s.transformation, reseau=s.reseau,
            )  # fmt: skip
        except InputError as error:
            failed.append(as_detail(error))
    if failed:
        raise InputError("film.scans_not_transformed", details=failed, n=len(failed), file=s.marks)
    return films


def _camera(path: Path) -> Camera:
    from raybundle.io.block.toml import read_cameras

    cameras = read_cameras(path)
    if len(cameras) != 1:
        raise InputError("calibration.camera_count", n=len(cameras), file=path)
    return cameras[0]


def _write(out: Path, films: Mapping[str, Film], camera: Camera, straight: tuple[Marks, Array] | None) -> None:
    import numpy as np

    from raybundle.io.calibrations.ours import cameras_text
    from raybundle.io.digits import EVERY, TEST, of_residual
    from raybundle.io.folders import new_folder
    from raybundle.io.tables import write_table

    every = list(films.values())
    with new_folder(out) as folder:
        (folder / "cameras.toml").write_text(cameras_text([camera]), encoding="utf-8")
        write_table(folder / "film.csv", *_columns(every))
        rows = {"image": [f.image for f in every for _ in f.marks], "mark": [m for f in every for m in f.marks]}
        residuals, w = np.vstack([f.residuals_mm for f in every]) * 1000, np.vstack([f.w for f in every])
        numbers = {"vx_um": residuals[:, 0], "vy_um": residuals[:, 1], "wx": w[:, 0], "wy": w[:, 1]}
        digits = {f"v{x}_um": of_residual(residuals[:, k], w[:, k]) for k, x in enumerate("xy")}
        write_table(folder / "residuals.csv", {**rows, **numbers}, {**digits, "wx": TEST, "wy": TEST})
        if straight is not None:
            points, cov = straight
            write_table(folder / "observations.csv", {
                "image": points.image, "point": points.name, "x_px": points.xy_px[:, 0], "y_px": points.xy_px[:, 1],
                "sx_px": points.sigma_px[:, 0], "sy_px": points.sigma_px[:, 1], "sxy_px2": cov[:, 2],
            }, EVERY)  # fmt: skip


def _columns(films: list[Film]) -> tuple[dict[str, Any], dict[str, Any]]:
    """film.csv: fit and shrinkage of each scan; and the digits of its numbers."""
    import numpy as np

    from raybundle.io.digits import COUNT, SHARE, STD, by_sigma

    shrinkage = [f.shrinkage for f in films]
    values, std = (np.array([getattr(s, n) for s in shrinkage]) for n in ("values", "std"))
    unit = {"shrinkage_x_ppm": 1e6, "shrinkage_y_ppm": 1e6, "shear_arcsec": 206264.806, "turn_deg": 57.29577951308232}
    columns: dict[str, Any] = {
        "image": [f.image for f in films], "model": [f.model for f in films],
        "marks": np.array([len(f.marks) for f in films], float),
        "redundancy": np.array([f.redundancy for f in films], float), "sigma0": np.array([f.sigma0 for f in films]),
        "rms_um": np.array([np.sqrt(np.mean(f.residuals_mm**2)) * 1000 for f in films]),
        "mirrored": ["yes" if f.mirrored else "no" for f in films],
    }  # fmt: skip
    digits: dict[str, Any] = {"marks": COUNT, "redundancy": COUNT, "sigma0": SHARE, "rms_um": STD}
    for k, (name, factor) in enumerate(unit.items()):
        columns |= {name: values[:, k] * factor, f"s{name}": std[:, k] * factor}
        digits |= {name: by_sigma(std[:, k] * factor), f"s{name}": STD}
    return columns, digits
