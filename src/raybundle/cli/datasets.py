"""`raybundle datasets`."""

from __future__ import annotations

from pathlib import Path

import click

from raybundle.cli.common import FOLDER, NEW_FOLDER, Group, common_options, facts
from raybundle.cli.summary import Summary, report
from raybundle.errors import note, phrase

listing_option = click.option(
    "--listing", type=FOLDER, metavar="FILE", help="TOML file with other sets instead of the built-in ones."
)


@click.group("datasets", cls=Group)
def command() -> None:
    """Fetch public sets of photographs, checked file by file.

    \b
    Example:
      raybundle datasets list
      raybundle datasets get sceaux-castle
      raybundle orient sceaux-castle/images --out sceaux-project
    """


@command.command("list")
@listing_option
def list_command(listing: Path | None) -> None:
    """Show the sets: name, size, content, licence."""
    from raybundle.io.datasets import known_datasets

    sets = known_datasets(listing)
    facts(sets=[{"name": s.name, "bytes": s.size, "about": s.about, "licence": s.licence} for s in sets.values()])
    report(Summary(done=[], table=[
        row for one in sets.values() for row in (
            f"{one.name:14s} {one.size / 1e6:6.0f} MB  {one.about}",
            f"{'':27s}{phrase('dataset.licence', licence=one.licence, cite='none')}",
        )
    ]))  # fmt: skip


@command.command("get")
@click.argument("name")
@click.option("--out", type=NEW_FOLDER, metavar="FOLDER", help="Output folder. Default: a folder named after the set.")
@listing_option
@common_options
def get_command(name: str, out: Path | None, listing: Path | None, progress: str) -> None:
    """Fetch a set from its source and check every file. A stopped fetch continues with the same command.

    \b
    Example:
      raybundle datasets get sceaux-castle
      raybundle datasets get copr-uav --out flight
      raybundle datasets get reichstag --listing benchmarks/corpus.toml
    """
    from raybundle.cli.progress import reporting
    from raybundle.io.datasets import dataset, fetch

    wanted = dataset(name, listing)
    folder = Path(name) if out is None else out
    click.echo(phrase("dataset.origin", name=wanted.name, source=wanted.source))
    click.echo(phrase("dataset.licence", licence=wanted.licence, cite=wanted.cite or "none"))
    with reporting(progress) as notify:
        done = fetch(wanted, folder, progress=notify)
    facts(folder=folder, fetched=done.fetched, there=done.there, source=wanted.source, licence=wanted.licence)
    fetched = note("dataset.fetched", n=done.fetched, there=done.there)
    report(Summary(done=[fetched], details=[wanted.about], files=[folder]))
