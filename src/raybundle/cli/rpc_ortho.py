"""`raybundle rpc ortho`: a scene in the map."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import click

from raybundle.cli.common import FOLDER, NEW_FILE, Command, common_options, facts
from raybundle.cli.settings import options_of, values_of
from raybundle.cli.summary import Summary, of_texts, report
from raybundle.commands.scenes.ortho import RpcOrthoSettings, run_ortho
from raybundle.errors import InputError, note
from raybundle.settings import made


@click.command("ortho", cls=Command)
@click.argument("scene", type=FOLDER)
@options_of(RpcOrthoSettings, out=NEW_FILE)
@common_options
def ortho(scene: Path, progress: str, **given: Any) -> None:
    """Orthorectify SCENE with a raster of heights.

    Heights may be in any coordinate system, also in degrees. They refer to a geoid if the raster's system
    (EPSG:32654+5773) or --geoid defines one. Occlusions are not handled.

    \b
    Example:
      raybundle rpc ortho corrected.tif --dem dem.tif --out ortho.tif
      raybundle rpc ortho scene.tif --rpc corrected.RPB --dem dem.tif --geoid EPSG:3855 --out ortho.tif
      raybundle rpc ortho corrected.tif --dem dem.tif --crs EPSG:2193 --pixel 0.5 --out ortho.tif
    """
    from raybundle.cli.progress import reporting

    settings = made(RpcOrthoSettings, {"scene": scene, **values_of(RpcOrthoSettings, given)})
    if settings.out is None:
        raise InputError("option.missing", setting="out", value="FILE.tif")
    with reporting(progress) as notify:
        done = run_ortho(settings, progress=notify)
    facts(width=done.width, height=done.height, pixel=done.pixel, left=done.left, top=done.top, crs=done.crs)
    facts(seen_share=done.share, nodata=done.nodata, bands=done.bands)
    report(Summary(
        done=[note("scene.ortho", width=done.width, height=done.height, pixel=float(done.pixel), crs=str(done.crs),
                   share=float(done.share), nodata=float(done.nodata))],
        notices=[*of_texts(done.remarks), note("picture.hidden_places")], files=[done.out],
    ))  # fmt: skip
