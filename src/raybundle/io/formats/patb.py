"""PAT-B folders: photographs with image points, exterior orientations, control and adjusted points, in and out.

NAME.im    a line `number c` for each photograph, a line `point x y [group]` for each image point, then -99; micrometres
NAME.ori   three lines a photograph: `number X Y Z`, then the nine elements of the rotation from image axes to object
           axes row by row, five and four to a line; m
NAME.con   a line `point X Y Z [codes]` for each control point, closed by -99; a coordinate 0 with a code 0 is not given
NAME.adj   a line `point X Y Z` for each adjusted point

Layouts after the help pages of CATALYST OrthoEngine (fields of 16 characters, 5F16.12 and 4F16.12 for the rotation,
names of the files) and of Cardinal Systems' VR Mapping; fields are read wherever blanks separate them.  In which sense
the rotation turns is not agreed upon: it is read as described here, unless the image points fit its transpose alone.
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
from raybundle.numerics.arrays import Array
from raybundle.numerics.rotation import nearest_rotation

STEM = "block"
READINGS = ("image_to_object", "object_to_image")


def write(export: Export, folder: Path) -> Draft:
    """Write the four files, and beside them cameras and names."""
    export, converted = in_metres(export, "PAT-B")
    s = scene(export)
    checked(s, "PAT-B")
    photographs = numbered(s.names)
    points = numbered([export.block.points.ids[k] for k in s.points.tolist()])
    (folder / f"{STEM}.im").write_text("".join(_image_lines(s, photographs, points)), encoding="utf-8")
    (folder / f"{STEM}.ori").write_text("".join(_orientation_lines(s, photographs)), encoding="utf-8")
    (folder / f"{STEM}.con").write_text("".join(_control_lines(export, s, points)), encoding="utf-8")
    adjusted = [f"{p:>16}{_row(x)}\n" for p, x in zip(points, s.xyz, strict=True)]
    (folder / f"{STEM}.adj").write_text("".join(adjusted), encoding="utf-8")
    write_own(folder, s, export, photographs, points)
    return Draft(remarks=(*converted, *s.remarks, phrase("conversion.measured_points", unit="µm", table=CAMERAS)))


def _row(values: Array, digits: int = 10) -> str:
    return "".join(f" {v:19.{digits}f}" for v in values.tolist())


def _image_lines(s: Scene, photographs: list[str], points: list[str]) -> Iterator[str]:
    xy = image_mm(s) * 1000
    for k, name in enumerate(photographs):
        c = s.cameras[int(s.camera[k])].values.get("c", 0.0) * 1000
        yield f"{name:>16} {c:.6f}\n"
        for row in np.flatnonzero(s.image == k).tolist():
            yield f"{points[int(s.point[row])]:>16} {xy[row, 0]:.6f} {xy[row, 1]:.6f} 1\n"
        yield f"{END:>16}\n"


def _orientation_lines(s: Scene, photographs: list[str]) -> Iterator[str]:
    for name, X0, R in zip(photographs, s.centre, s.rotation, strict=True):
        elements = [f"{v:16.12f}" for v in R.T.ravel().tolist()]
        yield f"{name:>16}{'':16}{_row(X0)}\n{''.join(elements[:5])}\n{''.join(elements[5:])}\n"


def _control_lines(export: Export, s: Scene, points: list[str]) -> Iterator[str]:
    p = export.block.points
    for number, k in zip(points, s.points.tolist(), strict=True):
        given = np.isfinite(p.xyz[k]) & np.isfinite(p.sigma[k])
        if p.role[k] == Role.CONTROL and given.any():
            row = _row(np.where(given, p.xyz[k], 0.0))
            yield f"{number:>16}{row} {int(given[:2].all())} {int(given[2])}\n"
    yield f"{END:>16}\n"


def read(folder: Path) -> Import:
    """Photographs, points and control of a folder; orientations, control and adjusted points where their files are."""
    if not folder.is_dir():
        raise InputError("format.needs_folder", format="PAT-B", files=["NAME.im", "NAME.ori", "NAME.con"], file=folder)
    image_file = _file(folder, (".im",))
    if image_file is None:
        raise InputError("folder.file_missing", name="NAME.im", file=folder)
    photographs = list(_read_images(image_file))
    if not photographs:
        raise InputError("file.no_images", file=image_file, line=1)
    orientation, control = _file(folder, (".ori",), "patb_eo.txt"), _file(folder, (".con",))
    adjusted = _file(folder, (".adj", ".xyz"))
    return assembled(
        Contents(
            folder=folder,
            name="PAT-B",
            photographs=photographs,
            orientations={} if orientation is None else _read_orientations(orientation),
            xyz={} if adjusted is None else _read_points(adjusted),
            control={} if control is None else _read_points(control),
            readings=READINGS,
        )
    )


def _file(folder: Path, suffixes: tuple[str, ...], name: str = "") -> Path | None:
    found = sorted(
        p for p in folder.iterdir() if p.is_file() and (p.suffix.lower() in suffixes or p.name.lower() == name)
    )
    if len(found) > 1:
        raise InputError("folder.several_files", n=len(found), name=f"NAME{suffixes[0]}", file=found[1])
    return found[0] if found else None


def _read_images(path: Path) -> Iterator[Photograph]:
    head: Line | None = None
    points: list[str] = []
    xy: list[list[float]] = []
    for line in lines(path):
        if head is None:
            if line.name != END:
                head, points, xy = line, [], []
                if len(line.words) < 2:
                    line.fail("patb.photograph_line", "c")
                line.values(1, ("c",))
        elif line.name == END:
            yield _photograph(head, points, xy)
            head = None
        else:
            if len(line.words) == 2:
                line.fail("patb.image_point_line", end=END)
            x, y = line.values(1, ("x", "y"))
            if max(abs(x), abs(y)) > LARGEST_MM * 1000:
                line.fail("image_point.out_of_range", x=x, y=y, unit="um", largest=LARGEST_MM * 1000)
            points.append(line.name)
            xy.append([x / 1000, y / 1000])
    if head is not None:
        head.fail("patb.photograph_not_closed", photograph=quoted(head.name), end=END)


def _photograph(head: Line, points: list[str], xy: list[list[float]]) -> Photograph:
    c = head.values(1, ("c",))[0] / 1000
    if not 0 < c < 100 * LARGEST_MM:
        head.fail("patb.camera_constant", "c", c_um=1000 * c)
    return Photograph(
        name=head.name,
        camera=f"c{c:g}",
        c_mm=c,
        points=tuple(points),
        xy_mm=np.array(xy, float).reshape(-1, 2),
        line=head,
    )


def _read_orientations(path: Path) -> dict[str, Orientation]:
    found: dict[str, Orientation] = {}
    rows = iter(lines(path))
    for head in rows:
        if head.name == END:
            continue
        if head.name in found:
            head.fail("name.twice", kind="image", name=quoted(head.name))
        # between the number and the coordinates some programs write a camera
        X0 = np.array(head.values(max(1, len(head.words) - 3), ("X", "Y", "Z")))
        elements: list[float] = []
        for names in (("a11", "a12", "a13", "a21", "a22"), ("a23", "a31", "a32", "a33")):
            line = next(rows, None)
            if line is None:
                head.fail("patb.rotation_missing", photograph=quoted(head.name))
            elements += line.values(0, names)
        D = np.array(elements).reshape(3, 3)
        with np.errstate(all="ignore"):
            good = np.abs(D @ D.T - np.eye(3)).max() < 1e-3 and np.linalg.det(D) > 0
        if not good:
            head.fail("rotation.not_orthogonal")
        D = nearest_rotation(D)
        found[head.name] = Orientation(centre=X0, rotations=(D.T, D))
    return found


def _read_points(path: Path) -> dict[str, tuple[float, float, float]]:
    found: dict[str, tuple[float, float, float]] = {}
    for line in lines(path):
        if line.name == END:
            continue
        X, Y, Z = line.values(1, ("X", "Y", "Z"))
        if line.name in found:
            line.fail("name.twice", kind="point", name=quoted(line.name))
        plan, height = (line.words[4] != "0", line.words[5] != "0") if len(line.words) > 5 else (True, True)
        nan = float("nan")
        found[line.name] = (X if plan else nan, Y if plan else nan, Z if height else nan)
    return found


register(
    Format(
        name="patb",
        title="PAT-B folder (image points, orientations, control)",
        kind="folder",
        write=write,
        read=read,
        looks=lambda path: path.is_dir() and any(p.suffix.lower() == ".im" for p in path.iterdir()),
    )
)
