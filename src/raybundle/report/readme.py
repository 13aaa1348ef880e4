"""README.txt of a result folder: what each file is, and what the columns of its tables are."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

from raybundle import __version__
from raybundle.adjustment.result import Adjustment
from raybundle.errors import phrase
from raybundle.io.geo.coordinate_systems import LocalFrame
from raybundle.report.languages.language import Language
from raybundle.report.map_axes import origin_words
from raybundle.results.tables import P_WRONG, TABLES

README = "README.txt"
COLUMNS: Mapping[str, str] = {
    "X, Y, Z": "coordinates",
    "omega_deg, phi_deg, kappa_deg": "angles",
    "x_px, y_px": "image_point",
    "sX, sY, sZ, somega_deg, sphi_deg, skappa_deg": "sigma",
    "sx_px, sy_px, sigma": "sigma_given",
    "p_wrong": "p_wrong",
    "rays": "rays",
    "window": "window",
    "roughness": "roughness",
    "rXY, rXZ, rYZ": "correlation",
    "dX, dY, dZ": "difference",
    "adjusted, X_adjusted, Y_adjusted, Z_adjusted": "adjusted",
    "vx_px, vy_px, vX, vY, vZ, v": "residual",
    "rx, ry, rX, rY, rZ, r": "redundancy",
    "wx, wy, wX, wY, wZ, w": "normalised",
    "tx, ty": "test",
    "mdbx_px, mdby_px": "detectable",
    "rejected": "rejected",
}
"""Columns -> the name of what they hold; columns of tables that are not there are left out"""
WIDTH = 22


def readme(adjustment: Adjustment, files: Sequence[str], language: Language, frame: LocalFrame | None = None) -> str:
    """The text.

    files  names of what stands in the folder
    frame  in which X, Y, Z are local
    """
    block = adjustment.adjusted
    unit = "none" if adjustment.free_scale else block.length_unit
    stems = {name: name.partition(".")[0] for name in files}
    later = set[str]() if adjustment.p_wrong is None else {P_WRONG}
    there = later | {c for stem in stems.values() if stem in TABLES for part in TABLES[stem] for c in part}
    lines = [language.text(phrase("result_readme.title", name=block.name, version=__version__)), ""]
    for name in sorted(files):
        key = stems[name] if stems[name] in TABLES else name.replace(".", "_")
        lines.append(f"{name:{WIDTH}s}{language.text(phrase('result_readme.file', entry=key))}")
    lines += ["", language.text(phrase("result_readme.rules", unit=unit))]
    lines += [""] if frame is None else [language.text(origin_words(frame)), ""]
    for names, key in COLUMNS.items():
        shown = ", ".join(n for n in names.split(", ") if n in there)
        if shown:
            gap = "\n" + " " * WIDTH if len(shown) >= WIDTH else " " * (WIDTH - len(shown))
            lines.append(f"{shown}{gap}{language.text(phrase('result_readme.column', content=key))}")
    return "\n".join(lines) + "\n"
