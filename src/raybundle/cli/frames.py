"""`raybundle frames`."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import click

from raybundle.cli.common import FOLDER, NEW_FOLDER, Command, common_options, facts
from raybundle.cli.settings import options_of, values_of
from raybundle.cli.summary import Summary, of_texts, report
from raybundle.commands.photos import FramesSettings, run_frames
from raybundle.errors import Severity, note
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
    """
    from raybundle.cli.progress import reporting

    settings = made(FramesSettings, {"video": video, **values_of(FramesSettings, given)})
    with reporting(progress) as notify:
        frames = run_frames(settings, notify)
    a = frames.analysis
    facts(frames=len(a.time_s), width_px=a.width_px, height_px=a.height_px, photographs=frames.files)
    report(Summary(
        done=[note("video.frames", n=len(frames.files), of=len(a.time_s), seconds=float(a.time_s[-1]),
                   width_px=a.width_px, height_px=a.height_px)],
        notices=of_texts(frames.remarks, Severity.WARNING), files=[settings.out],
    ))  # fmt: skip
