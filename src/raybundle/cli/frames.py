"""`raybundle frames`."""

from __future__ import annotations

from pathlib import Path

import click

from raybundle.cli.common import COMMAND_SETTINGS, FOLDER, NEW_FOLDER, common_options, counted
from raybundle.cli.numbers import POSITIVE


@click.command("frames", context_settings=COMMAND_SETTINGS)
@click.argument("video", type=FOLDER)
@click.option(
    "--out", type=NEW_FOLDER, required=True, metavar="FOLDER", help="A new or empty folder for the photographs."
)
@click.option("--count", type=click.IntRange(1), help="So many frames, evenly by image motion.")
@click.option("--every", type=POSITIVE, metavar="SECONDS", help="One frame in so many seconds.")
@click.option(
    "--motion",
    type=POSITIVE,
    default=0.08,
    show_default=True,
    help="Without --count and --every: one frame whenever the view has moved by this share of the image's longer side.",
)
@common_options
def command(video: Path, out: Path, count: int | None, every: float | None, motion: float, progress: str) -> None:
    """Choose sharp frames of a video by image motion and write them as photographs.

    Make, model, time and place go into their EXIF as far as the video says them; frames.csv lists what was measured.

    \b
    Example:
      raybundle frames walk.mp4 --out walk
      raybundle frames walk.mp4 --out walk-60 --count 60
    """  # noqa: D301
    from raybundle.cli.progress import reporting  # noqa: PLC0415  (what computes is loaded after the help)
    from raybundle.io.photos.video import FrameOptions, extract_frames  # noqa: PLC0415

    with reporting(progress) as tell:
        options = FrameOptions(count=count, every_s=every, motion=motion)
        frames = extract_frames(video, out, options, progress=tell)
    a = frames.analysis
    seconds = f"{a.time_s[-1]:.1f} s, {a.width_px} x {a.height_px} px"
    click.echo(f" {counted(len(a.time_s), 'frame')}, {seconds}; {counted(len(frames.files), 'photograph')} chosen")
    for remark in frames.remarks:
        click.echo(f" remark: {remark}")
    click.echo(f" photographs: {out}")
