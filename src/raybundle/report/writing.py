"""Reports as files: HTML for the screen, PDF for print and archive."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path

from raybundle.adjustment.result import Adjustment
from raybundle.calibration.quality import CalibrationQuality
from raybundle.io.folders import new_files
from raybundle.numerics.progress import Progress, silent
from raybundle.report.appendix import Appendix
from raybundle.report.chapters import Occasion
from raybundle.report.delivery import Delivery, delivery_of
from raybundle.report.document import PDF, Document, document_of, html
from raybundle.report.facts import PhotographFacts
from raybundle.report.languages import ENGLISH
from raybundle.report.languages.language import language_of
from raybundle.report.languages.names import names_of
from raybundle.report.text.metrology_words import length_of
from raybundle.report.text.words import verdict
from raybundle.report.view import view_of


def write_report(
    adjustment: Adjustment,
    path: str | Path,
    progress: Progress = silent,
    photographs: PhotographFacts | None = None,
    qualities: tuple[CalibrationQuality, ...] = (),
    delivery: Delivery | None = None,
    *,
    appendix: Appendix = "none",
    language: str = ENGLISH,
) -> None:
    """Write the report of an adjustment: report.html for the screen, report.pdf for print and archive.

    adjustment       any result: without statistics, control or redundancy the parts that need them say so
    path             the file, a PDF where its name ends in .pdf; it needs no other, no network and no font.  Its
                     folder exists; an older file is overwritten
    photographs      what is known of the photographs that the adjustment comes from; None: those sections are left out
    qualities        verdicts on calibrated cameras; they come first then
    delivery         client, coordinate system, and compliance with the required accuracy; None: not given
    appendix         of a PDF: "none"; "short"; "all": with every object point. A page has the short one at least
    language         of the report, as "de"; InputError for one that there is not

    Long tables and dense figures are thinned evenly and say so; the result folder's tables hold every row.
    """
    write_reports(
        adjustment, (Path(path),), progress, photographs=photographs, qualities=qualities, delivery=delivery,
        appendix=appendix, language=language,
    )  # fmt: skip


def write_reports(
    adjustment: Adjustment, files: Sequence[Path], progress: Progress = silent, *,
    photographs: PhotographFacts | None = None, qualities: tuple[CalibrationQuality, ...] = (),
    delivery: Delivery | None = None, appendix: Appendix = "none", language: str = ENGLISH,
) -> None:  # fmt: skip
    """Write one report, as `write_report` does, into several files of one folder."""
    delivery = delivery or delivery_of(adjustment)
    view = view_of(adjustment, delivery.accuracy, length_of(delivery.findings))
    occasion = Occasion(
        view=view,
        reported=verdict(view),
        appendix=appendix,
        photographs=photographs,
        qualities=qualities,
        delivery=delivery,
        language=language_of(language, names_of(adjustment, photographs, delivery)),
    )
    document = document_of(occasion, progress)
    with new_files(*files) as new:
        for file in new:
            file.write_bytes(set_document(document, file, progress))
    progress("report", 1.0)


def set_document(document: Document, target: Path, progress: Progress = silent) -> bytes:
    """A document as its file holds it: PDF where the name ends in .pdf, else HTML."""
    if target.suffix.lower() != PDF:
        return html(document).encode("utf-8")
    from raybundle.report.paper.press import pdf_of

    progress("report: printed pages", 1.0)
    return pdf_of(document)
