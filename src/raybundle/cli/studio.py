"""`raybundle studio`."""

from __future__ import annotations

import contextlib
import json
from pathlib import Path

import click

from raybundle.cli.common import FOLDER, NEW_FOLDER, Command


@click.command("studio", cls=Command)
@click.argument("source", type=FOLDER, metavar="PROJECT|RESULT|BLOCK|PHOTOS")
@click.option("--out", type=NEW_FOLDER, metavar="PROJECT",
    help="Project folder of PHOTOS, new or existing.  [default: PHOTOS-project]",
)  # fmt: skip
@click.option("--photos", type=FOLDER, multiple=True, metavar="FOLDER",
    help="Folder of the photographs.  [default: recorded in the project]",
)  # fmt: skip
@click.option(
    "--port", type=click.IntRange(0, 65535), default=0, show_default=True, help="Port of the server; 0: a free one."
)
@click.option("--language", default="", metavar="CODE",
    help="Language of the page and its reports: en, de.  [default: that of the project, else en]",
)  # fmt: skip
@click.option("--json", "as_json", is_flag=True, help="Print the address as a JSON object.")
@click.option("--no-browser", is_flag=True, help="Print the address without opening it.")
def command(
    source: Path,
    out: Path | None,
    photos: tuple[Path, ...],
    *,
    port: int,
    no_browser: bool,
    language: str,
    as_json: bool,
) -> None:
    """Look, measure and adjust in the browser.

    The server listens on this computer only. The printed address works once; the browser that opens it keeps access.
    Every measurement is stored in PROJECT/measured.db (RESULT.measured.db beside a result or block). Adjustments with
    them are the current result of the project, PROJECT/result. For photographs that matching cannot join, a project is
    begun beside them. Marked points orient these photographs at once.

    \b
    Example:
      raybundle studio facade-project
      raybundle studio facade-result --photos facade/ --no-browser
      raybundle studio archive/ --out archive-project
    """
    from raybundle.commands.new_project import measuring_folder
    from raybundle.commands.pages import language_in
    from raybundle.studio.serve import serve

    language_in(None, language)  # one that there is not is reported before anything is begun
    project = measuring_folder(source, out, lambda line: click.echo(f"   {line}"))

    spoken = language_in(project, language)

    def notify(address: str) -> None:
        words = f" studio of {project}: {address}\n Ctrl-C ends it; what was measured is kept"
        click.echo(json.dumps({"project": str(project), "address": address}) if as_json else words)

    with contextlib.suppress(KeyboardInterrupt):  # the way in which it ends
        serve(project, photos, port=port, browser=not no_browser, notify=notify, language=spoken)
