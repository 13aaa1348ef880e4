"""Result folders with all that people look at: report, network, map, calibration."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from pathlib import Path
from typing import TYPE_CHECKING, Literal

from raybundle.adjustment.result import Adjustment
from raybundle.io.tables import write_table
from raybundle.numerics.progress import Progress, silent
from raybundle.results.folder import written_folder

if TYPE_CHECKING:
    from raybundle.calibration.quality import CalibrationQuality
    from raybundle.io.geo.coordinate_systems import LocalFrame
    from raybundle.report.facts import PhotographFacts


def write_result(
    adjustment: Adjustment,
    path: str | Path,
    *,
    report: Literal["html", "none"] = "html",
    additions: Mapping[str, object] | None = None,
    photographs: PhotographFacts | None = None,
    frame: LocalFrame | None = None,
    qualities: tuple[CalibrationQuality, ...] = (),
    more: Callable[[Path], None] | None = None,
    progress: Progress = silent,
) -> None:
    """Write a result folder, whole or not at all; an older result there is replaced when the new one is complete.

    report       "html": report.html and network.html, the network in three dimensions
    additions    further keys of result.json
    photographs  what is known of the photographs that the adjustment comes from
    frame        the coordinate system in which the local frame of the adjustment stands; map.csv is in that system
    qualities    verdicts on calibrated cameras; calibration.toml, as orient takes it, is written beside them
    more         writes further files of the result into the folder
    raises       InputError where something else stands at `path`
    """
    with written_folder(adjustment, path, additions, progress) as folder:
        if frame is not None:
            from raybundle.results.map_table import map_table  # noqa: PLC0415  (pyproj only where it is used)

            write_table(folder / "map.csv", map_table(adjustment, frame))
        if qualities:
            from raybundle.results.calibrated import calibration_text  # noqa: PLC0415

            text = calibration_text(adjustment, qualities)
            (folder / "calibration.toml").write_text(text, encoding="utf-8", newline="\n")
        if more is not None:
            more(folder)
        if report == "html":
            from raybundle.report.document import write_report  # noqa: PLC0415  (Jinja2 only where it is used)
            from raybundle.report.network_page import write_network_page  # noqa: PLC0415

            write_report(adjustment, folder / "report.html", progress, photographs, qualities)
            write_network_page(adjustment, folder / "network.html")
