"""Sheets of targets as PDF or SVG at true size, with a TOML file that states what is on them."""

from __future__ import annotations

from pathlib import Path
from xml.sax.saxutils import escape

from raybundle.errors import InputError
from raybundle.io.folders import check_new_file, new_files
from raybundle.targets.layout import Disc, Outline, Page, Sheet
from raybundle.targets.sidecar import sidecar

POINT = 72 / 25.4
"""Points of a PDF in a millimetre."""


def write_sheet(sheet: Sheet, path: Path) -> tuple[Path, ...]:
    """Write FILE.pdf, or FILE.svg (FILE-2.svg and so on for further pages), and FILE.toml; returns what was written.

    Raises InputError for another ending, where nothing can be written, where reportlab is missing for a PDF, or where
    one of them stands there; nothing is written then.
    """
    kind = path.suffix.lower()
    if kind not in {".pdf", ".svg"}:
        raise InputError("sheet.file_type", ending=path.suffix, file=path)
    files: dict[Path, bytes] = {}
    if kind == ".pdf":
        files[path] = pdf(sheet)
    else:
        for k, page in enumerate(sheet.printed, start=1):
            name = path if k == 1 else path.with_name(f"{path.stem}-{k}{path.suffix}")
            files[name] = svg(page).encode()
    beside = path.with_suffix(".toml")
    files[beside] = sidecar(sheet).encode()
    for name, content in files.items():
        # of a writing that was stopped, the file beside it may stand there alone
        if not (name == beside and beside.is_file() and beside.read_bytes() == content):
            check_new_file(name)
    # the file beside it first: with it alone the same sheet can be written again
    order = (beside, *(name for name in files if name != beside))
    with new_files(*order) as temporary:
        for name, place in zip(order, temporary, strict=True):
            place.write_bytes(files[name])
    return tuple(files)


def pdf(sheet: Sheet) -> bytes:
    """The printed pages as one PDF, without a date: the same sheet gives the same bytes."""
    try:
        from reportlab.pdfgen.canvas import Canvas
    except ImportError as error:
        raise InputError("package.reportlab_missing") from error
    import io

    buffer = io.BytesIO()
    canvas = Canvas(buffer, invariant=1)
    canvas.setTitle(f"{sheet.title}")
    for page in sheet.printed:
        canvas.setPageSize((page.width * POINT, page.height * POINT))
        canvas.scale(POINT, POINT)
        for s in page.shapes:
            if isinstance(s, Disc):
                canvas.setFillGray(0 if s.black else 1)
                canvas.circle(s.x, s.y, s.radius, stroke=0, fill=1)
            elif isinstance(s, Outline):
                canvas.setFillGray(0 if s.black else 1)
                outline = canvas.beginPath()
                outline.moveTo(*s.xy[0])
                for x, y in s.xy[1:]:
                    outline.lineTo(x, y)
                outline.close()
                canvas.drawPath(outline, stroke=0, fill=1)
            else:
                canvas.setFillGray(0)
                canvas.setFont("Helvetica", s.size)
                canvas.drawCentredString(s.x, s.y, s.text)
        canvas.showPage()
    canvas.save()
    return buffer.getvalue()


def svg(page: Page) -> str:
    """One page; the user unit is the millimetre."""
    w, h = page.width, page.height
    lines = [
        f'<svg xmlns="http://www.w3.org/2000/svg" width="{w:g}mm" height="{h:g}mm" viewBox="0 0 {w:g} {h:g}">',
        f'<rect width="{w:g}" height="{h:g}" fill="#fff"/>',
    ]
    for s in page.shapes:
        if isinstance(s, Disc):
            fill = "#000" if s.black else "#fff"
            lines.append(f'<circle cx="{s.x:.4f}" cy="{h - s.y:.4f}" r="{s.radius:.4f}" fill="{fill}"/>')
        elif isinstance(s, Outline):
            fill = "#000" if s.black else "#fff"
            points = " ".join(f"{x:.4f},{h - y:.4f}" for x, y in s.xy)
            lines.append(f'<polygon points="{points}" fill="{fill}"/>')
        else:
            at = f'x="{s.x:.4f}" y="{h - s.y:.4f}" font-size="{s.size:g}" text-anchor="middle" font-family="sans-serif"'
            lines.append(f"<text {at}>{escape(s.text)}</text>")
    return "\n".join([*lines, "</svg>", ""])
