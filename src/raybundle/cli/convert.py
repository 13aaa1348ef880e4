"""`raybundle convert`."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import click

from raybundle.cli.common import FOLDER, NEW_FILE_OR_FOLDER, Command, common_options, facts
from raybundle.cli.settings import options_of, values_of
from raybundle.cli.summary import Summary, of_texts, report
from raybundle.commands.convert import ConvertSettings, run_convert
from raybundle.errors import Severity, message, note
from raybundle.io.formats import formats
from raybundle.settings import made
from raybundle.workflows.convert import WRITABLE
from raybundle.workflows.sources import READABLE

TITLES = "\n".join(
    f"  {n:<12} {'read, write' if f.read and f.write else 'write' if f.write else 'read':<12} {f.title}"
    for n, f in sorted(formats.items())
)
HELP = f"""Convert between block folders, result folders and the formats of other programs.

INPUT is a block folder, a result folder, the project of `orient`, or a file or folder of another program. Results are
converted with adjusted values, without rejected observations. If the other program describes distortion differently,
cameras are fitted and the largest deviation is printed. If it exceeds 0.1 px, nothing is written without --approximate.
The tables of a result folder (points.csv, images.csv, observations.csv ...) are CSV already.

\b
Formats:
  {"block":<12} {"read, write":<12} block folder; as input also a result folder
  {"rpc":<12} {"write":<12} NAME_RPC.TXT of every satellite scene, its estimated bias built in
{TITLES}

\b
Example:
  raybundle convert camcal21-result --to colmap --out model
  raybundle convert model --to block --out camcal21-again
  raybundle convert pair-project/result --to rpc --out corrected
  raybundle convert flight-result --to kml --out flight.kml --crs EPSG:32611
  raybundle convert flight-project --to gpkg,dxf,las --out flight
  raybundle convert facade-result --to colmap --out dense/sparse --photos photos --undistort inside
"""


class _Target(click.Choice[str]):
    """The formats to write, and where to look for what is none of them."""

    def convert(self, value: str, param: click.Parameter | None, ctx: click.Context | None) -> str:
        """As a choice, of several with commas between each; tables are none."""
        if "," in value:
            return ",".join(self.convert(v.strip(), param, ctx) for v in value.split(","))
        if value.lower() == "csv":
            self.fail(message("format.csv").text(), param, ctx)
        return super().convert(value, param, ctx)


@click.command("convert", cls=Command, help=HELP)
@click.argument("source", type=FOLDER, metavar="INPUT")
@options_of(ConvertSettings, read_as=click.Choice(READABLE), to=_Target(WRITABLE), out=NEW_FILE_OR_FOLDER)
@common_options
def command(source: Path, progress: str, **given: Any) -> None:
    """Convert, and print what was assumed."""
    from raybundle.cli.progress import reporting

    settings = made(ConvertSettings, {"source": source, **values_of(ConvertSettings, given)})
    with reporting(progress) as notify:
        done = run_convert(settings, notify)
    b = done.block
    facts(images=int(b.images.oriented.sum()), points=done.points, observations=done.observations)
    facts(files=dict(done.written), cameras_px=done.deviation_px, not_read=dict(done.unread))
    from raybundle.results.state import state_messages

    fitted = [note("block.cameras_fitted", largest_px=done.deviation_px)] if done.deviation_px > 0 else []
    remarks = of_texts(done.remarks, Severity.NOTE)
    left_out = [m for m in remarks if m.code == "conversion.not_held"]
    more = done.files - len(done.written)
    beside = more > 0 and all(place.is_file() for _, place in done.written)
    report(Summary(
        done=[
            note("block.converted", images=int(b.images.oriented.sum()), points=done.points,
                 observations=done.observations, formats=[to for to, _ in done.written]),
            *left_out, *fitted, *([note("block.more_files", n=more)] if beside else []),
        ],
        notices=[*state_messages(done.state), *(m for m in remarks if m not in left_out)],
        files=[place for _, place in done.written],
    ))  # fmt: skip
