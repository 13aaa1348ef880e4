"""`raybundle frames`."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import click

from raybundle.cli.common import FOLDER, NEW_FOLDER, Command, common_options, counted, facts
from raybundle.cli.settings import options_of, values_of
from raybundle.commands.photos import FramesSettings, run_frames
from raybundle.settings import made


@click.command("frames", cls=Command)
@click.argument("video", type=FOLDER)
@options_of(FramesSettings, out=NEW_FOLDER)
@common_options
def command(video: Path, progress: str, **given: Any) -> None:
    """Choose sharp frames of a video by image motion and write them as photographs.

    EXIF gets make, model, time and place as far as the video has them. frames.csv lists the measurements.

    \b
    Example:
      raybundle frames walk.mp4 --out walk
      raybundle frames walk.mp4 --out walk-60 --count 60
    """  # noqa: D301
    from raybundle.cli.progress import reporting  # noqa: PLC0415  (what computes is loaded after the help)

    settings = made(FramesSettings, {"video": video, **values_of(FramesSettings, given)})
    with reporting(progress) as notify:
        frames = run_frames(settings, notify)
    a = frames.analysis
    seconds = f"{a.time_s[-1]:.1f} s, {a.width_px} x {a.height_px} px"
    facts(frames=len(a.time_s), width_px=a.width_px, height_px=a.height_px, photographs=frames.files)
    click.echo(f" {counted(len(a.time_s), 'frame')}, {seconds}; {counted(len(frames.files), 'photograph')} chosen")
    for remark in frames.remarks:
        click.echo(f" note: {remark}")
    click.echo(f" photographs: {settings.out}")
