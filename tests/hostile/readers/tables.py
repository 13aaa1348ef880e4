"""Control, film marks, coordinate systems and other tables."""

from pathlib import Path

import numpy as np

from tests.hostile.readers.registry import not_finite, only, place, target, texts


def control_seeds(top: Path) -> None:
    from tests.io.test_control_files import CSV, GCP, MEASURED

    texts({"gcp_list.txt": GCP}, {"c.csv": CSV, "c-measurements.csv": MEASURED})(top)


def read_the_control(folder: Path) -> list[str]:
    from raybundle.io.geo.control_files import read_control

    found = read_control(only(folder, but="-measurements.csv"))
    return (["xyz"] if np.isinf(found.xyz).any() else []) + (["sigma"] if np.isinf(found.sigma).any() else [])


def fiducial_seeds(top: Path) -> None:
    from tests.io.test_fiducials import EIGHT, NAMES

    rows = "".join(f"{n},{x},{y},0.002,0.002\n" for n, (x, y) in zip(NAMES, EIGHT, strict=True))
    texts({"c.csv": "mark,x_mm,y_mm,sx_mm,sy_mm\n" + rows})(top)


def read_the_fiducials(folder: Path) -> list[str]:
    from raybundle.io.film.fiducials import read_calibrated

    return not_finite(xy=read_calibrated(only(folder)).xy_mm)


def mark_seeds(top: Path) -> None:
    from tests.io.test_fiducials import EIGHT, NAMES, scanned

    rows = "".join(f"s,{n},{x:.3f},{y:.3f}\n" for n, (x, y) in zip(NAMES, scanned(EIGHT), strict=True))
    texts({"m.csv": "image,mark,x_px,y_px\n" + rows})(top)


def read_the_marks(folder: Path) -> list[str]:
    from raybundle.io.film.fiducials import read_marks
    from tests.io.test_fiducials import FIDUCIALS

    read_marks(only(folder), "mark", FIDUCIALS)
    return []


def crs_seeds(top: Path) -> None:
    texts({"c.txt": "EPSG:32633"}, {"c.txt": "+proj=utm +zone=11 +datum=WGS84"}, {"c.txt": "WGS84 UTM 33N"})(top)


def read_a_crs(folder: Path) -> list[str]:
    from raybundle.io.geo.coordinate_systems import local_frame
    from raybundle.io.geo.parsed_systems import parse_crs

    text = only(folder).read_bytes().decode("utf-8", "surrogateescape")
    parse_crs(text)
    local_frame(text, (500000.0, 5300000.0, 500.0))
    return []


def empirical_seeds(top: Path) -> None:
    k = np.arange(12)
    rows = zip(
        k, np.cos(k) * 10 + 20, np.sin(k * 1.7) * 10, k * 0.1, 300 + 100 * np.cos(k), 400 + np.sin(k), strict=True
    )
    lines = "".join(",".join(f"{v:.4f}" if j else str(v) for j, v in enumerate(row)) + ",\n" for row in rows)
    texts({"p.csv": "point,X,Y,Z,x_px,y_px,role\n" + lines})(top)


def read_empirical_points(folder: Path) -> list[str]:
    from raybundle.commands.empirical import read_points

    read_points(only(folder))
    return []


def spreadsheet_seeds(top: Path) -> None:
    """The tables of users as two countries' spreadsheets save them; a folder begins with its reader's name."""
    from tests.io.spreadsheets import READERS
    from tests.io.test_spreadsheets import saved

    for k, (name, reader) in enumerate(READERS.items()):
        folder = place(top, k)
        separator, encoding, above = (";", "cp1252", "sep=;") if k % 2 else ("\t", "utf-8-sig", "")
        plain = name in {"codes", "outline"}
        for file, text in reader.files.items():
            table = saved(text, separator, "" if plain else above) if file.endswith(".csv") else text
            (folder / file).write_bytes(table.encode("utf-8" if plain else encoding))
        (folder / "name").write_text(name)


def read_a_spreadsheet(folder: Path) -> list[str]:
    from tests.io.spreadsheets import READERS

    try:
        name = (folder / "name").read_text()
    except (OSError, UnicodeDecodeError):
        return []
    if name in READERS:
        READERS[name].read(folder)
    return []


def displacement_seeds(top: Path) -> None:
    head = "point,from,to,X,Y,Z,dX,dY,dZ,sdX,sdY,sdZ,rXY,rXZ,rYZ,length,F,p,p_tested,verdict,"
    head += "detectable_before,detectable\n"
    row = "t{},2026-05-01,2026-06-01,1.5,2,3,0.01,0,-0.02,0.001,0.001,0.002,0.1,0,-0.2,0.022,9.1,0.001,,moved,,0.004\n"
    texts({"displacements.csv": head + "".join(row.format(k) for k in range(3))})(top)


def read_the_displacements(folder: Path) -> list[str]:
    from raybundle.results.displacements import read_displacements

    found = read_displacements(only(folder))
    return [n for n in ("xyz", "vector", "covariance") if np.isinf(getattr(found, n)).any()]


target("spreadsheets", spreadsheet_seeds, read_a_spreadsheet)
target("control", control_seeds, read_the_control)
target("displacements", displacement_seeds, read_the_displacements)
target("fiducials", fiducial_seeds, read_the_fiducials)
target("film-marks", mark_seeds, read_the_marks)
target("crs", crs_seeds, read_a_crs, slow=True)
target("empirical", empirical_seeds, read_empirical_points)
