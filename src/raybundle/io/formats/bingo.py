"""BINGO folders: photographs with image points, orientations and points, control, in and out.

image.dat   a line `photograph camera` for each photograph, a line `point x y` for each image point, then -99 or an
            empty line; mm about the image centre (the layout that Pix4D's help describes for its export)
itera.dat   ORIA photograph X Y Z phi omega kappa     exterior orientation; gon, phi the primary angle
            COOR point X Y Z                          object coordinates
geoin.dat   CONT point X Y Z [sX sY sZ]               control, full
            CONP point X Y [sX sY]                    control in plan
            CONH point Z [sZ]                         control in height
            CHCK point X Y Z                          check point

The names of the three files are those that CATALYST OrthoEngine's help states; the records are written as BINGO's
practice has them, in gon and with phi first.  Where the image points fit omega-phi-kappa alone, they are read so, and
that is stated.  C or # in the first column is a comment; other records are passed over and counted.
"""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path

import numpy as np

from raybundle.block import Role
from raybundle.errors import InputError, phrase
from raybundle.io.formats.aerial_text import (
    CAMERAS,
    END,
    LARGEST_MM,
    Contents,
    Line,
    Orientation,
    Photograph,
    assembled,
    checked,
    image_mm,
    in_metres,
    lines,
    numbered,
    write_own,
)
from raybundle.io.formats.base import Draft, Export, Format, Import, Scene, register, scene
from raybundle.io.reading.words import quoted
from raybundle.numerics.attitude import GON, pok_from_rotation, rotation_from_opk, rotation_from_pok

IMAGE, ITERA, GEOIN = "image.dat", "itera.dat", "geoin.dat"
READINGS = ("pok_gon", "opk_gon", "opk_deg")
XYZ = ("X", "Y", "Z")
AXES = {"CONT": XYZ, "CONP": XYZ[:2], "CONH": XYZ[2:], "CHCK": XYZ}
Known = dict[str, tuple[float, float, float]]


def write(export: Export, folder: Path) -> Draft:
    """Write the three files, and beside them cameras and names."""
    export, converted = in_metres(export, "BINGO")
    s = scene(export)
    checked(s, "BINGO")
    photographs = numbered(s.names)
    points = numbered([export.block.points.ids[k] for k in s.points.tolist()])
    (folder / IMAGE).write_text("".join(_image_lines(s, photographs, points)), encoding="utf-8")
    (folder / ITERA).write_text("".join(_itera_lines(s, photographs, points)), encoding="utf-8")
    (folder / GEOIN).write_text("".join(_geoin_lines(export, s, points)), encoding="utf-8")
    write_own(folder, s, export, photographs, points)
    return Draft(remarks=(*converted, *s.remarks, phrase("conversion.measured_points", unit="mm", table=CAMERAS)))


def _image_lines(s: Scene, photographs: list[str], points: list[str]) -> Iterator[str]:
    xy = image_mm(s)
    for k, name in enumerate(photographs):
        yield f"{name} {_word(s.cameras[int(s.camera[k])].id)}\n"
        for row in np.flatnonzero(s.image == k).tolist():
            yield f"{points[int(s.point[row])]:>16} {xy[row, 0]:15.9f} {xy[row, 1]:15.9f}\n"
        yield f"{END}\n"


def _word(text: str) -> str:
    return "_".join(text.split()) or "1"


def _itera_lines(s: Scene, photographs: list[str], points: list[str]) -> Iterator[str]:
    angles = pok_from_rotation(s.rotation) / GON
    for name, X0, a in zip(photographs, s.centre, angles, strict=True):
        place = " ".join(f"{v:.10f}" for v in X0.tolist())
        yield f"ORIA {name:>12} {place} {' '.join(f'{v:.12f}' for v in a.tolist())}\n"
    for name, x in zip(points, s.xyz, strict=True):
        yield f"COOR {name:>12} {' '.join(f'{v:.10f}' for v in x.tolist())}\n"


def _geoin_lines(export: Export, s: Scene, points: list[str]) -> Iterator[str]:
    p = export.block.points
    for name, k in zip(points, s.points.tolist(), strict=True):
        role, sigma = p.role[k], p.sigma[k]
        place = [f"{v:.10f}" for v in p.xyz[k].tolist()]
        spread = [f"{v:.6f}" for v in sigma.tolist()]
        given = np.isfinite(p.xyz[k]) & np.isfinite(sigma)
        if role == Role.CHECK:
            yield f"CHCK {name:>12} {' '.join(place)}\n"
        elif role == Role.CONTROL and given.all():
            yield f"CONT {name:>12} {' '.join(place)} {' '.join(spread)}\n"
        elif role == Role.CONTROL and given[:2].all():
            yield f"CONP {name:>12} {' '.join(place[:2])} {' '.join(spread[:2])}\n"
        elif role == Role.CONTROL and given[2]:
            yield f"CONH {name:>12} {place[2]} {spread[2]}\n"


def read(folder: Path) -> Import:
    """Photographs and points of a folder; orientations and control where their files are."""
    if not folder.is_dir():
        raise InputError("format.needs_folder", format="BINGO", files=[IMAGE, ITERA, GEOIN], file=folder)
    here = {p.name.lower(): p for p in sorted(folder.iterdir()) if p.is_file()}
    if IMAGE not in here:
        raise InputError("folder.file_missing", name=IMAGE, file=folder)
    photographs = list(_read_images(here[IMAGE]))
    if not photographs:
        raise InputError("file.no_images", file=here[IMAGE], line=1)
    orientations: dict[str, Orientation] = {}
    xyz, control, sigma = Known(), Known(), Known()
    if ITERA in here:
        orientations, xyz = _read_itera(here[ITERA])
    if GEOIN in here:
        control, sigma, check = _read_geoin(here[GEOIN])
        xyz = {**check, **xyz}
    return assembled(
        Contents(
            folder=folder,
            name="BINGO",
            photographs=photographs,
            orientations=orientations,
            xyz=xyz,
            control=control,
            control_sigma=sigma,
            readings=READINGS,
        )
    )


def _read_images(path: Path) -> Iterator[Photograph]:
    head: Line | None = None
    points: list[str] = []
    xy: list[list[float]] = []
    for line in lines(path):
        if line.name in {"C", "#"}:
            continue
        ends = line.name == END
        if ends or len(line.words) < 3:
            if head is not None:
                yield _photograph(head, points, xy)
            head, points, xy = None if ends else line, [], []
            if head is not None and len(head.words) != 2:
                line.fail("bingo.photograph_line", "camera")
        elif head is None:
            line.fail("bingo.point_before_photograph")
        else:
            x, y = line.values(1, ("x", "y"))
            if max(abs(x), abs(y)) > LARGEST_MM:
                line.fail("image_point.out_of_range", x=x, y=y, unit="mm", largest=LARGEST_MM)
            points.append(line.name)
            xy.append([x, y])
    if head is not None:
        yield _photograph(head, points, xy)


def _photograph(head: Line, points: list[str], xy: list[list[float]]) -> Photograph:
    return Photograph(
        name=head.name,
        camera=head.words[1],
        c_mm=None,
        points=tuple(points),
        xy_mm=np.array(xy, float).reshape(-1, 2),
        line=head,
    )


def _read_itera(path: Path) -> tuple[dict[str, Orientation], Known]:
    found: dict[str, Orientation] = {}
    xyz = Known()
    for line in lines(path):
        kind = line.name.upper()
        if kind not in {"ORIA", "COOR"}:
            continue
        if len(line.words) < 2:
            line.fail("name.missing", "name")
        name = line.words[1]
        if name in (found if kind == "ORIA" else xyz):
            line.fail("name.twice", kind="image" if kind == "ORIA" else "point", name=quoted(name))
        if kind == "COOR":
            X, Y, Z = line.values(2, XYZ)
            xyz[name] = (X, Y, Z)
            continue
        values = line.values(2, (*XYZ, "phi", "omega", "kappa"))
        angles = np.array(values[3:])
        found[name] = Orientation(
            centre=np.array(values[:3]),
            rotations=(
                rotation_from_pok(angles * GON),
                rotation_from_opk(angles * GON),
                rotation_from_opk(np.radians(angles)),
            ),
        )
    return found, xyz


def _read_geoin(path: Path) -> tuple[Known, Known, Known]:
    """Control, its standard deviations where they are reported, and check points."""
    control, sigma, check = Known(), Known(), Known()
    for line in lines(path):
        kind = line.name.upper()
        if kind not in AXES:
            continue
        if len(line.words) < 2:
            line.fail("name.missing", "name")
        name, axes = line.words[1], AXES[kind]
        if name in control or name in check:
            line.fail("name.twice", kind="point", name=quoted(name))
        place = _spread(axes, line.values(2, axes))
        if kind == "CHCK":
            check[name] = place
            continue
        control[name] = place
        if len(line.words) >= 2 + 2 * len(axes):
            found = line.values(2 + len(axes), [f"s{a}" for a in axes])
            if min(found) < 0:
                line.fail("cell.negative_sigma", "sX", value=quoted(min(found)))
            sigma[name] = _spread(axes, found)
    return control, sigma, check


def _spread(axes: tuple[str, ...], values: list[float]) -> tuple[float, float, float]:
    X, Y, Z = (values[axes.index(a)] if a in axes else float("nan") for a in XYZ)
    return X, Y, Z


register(
    Format(
        name="bingo",
        title="BINGO folder (image.dat, itera.dat, geoin.dat)",
        kind="folder",
        write=write,
        read=read,
        looks=lambda path: path.is_dir() and any(p.name.lower() == IMAGE for p in path.iterdir()),
    )
)
