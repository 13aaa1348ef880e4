"""`raybundle rpc batch`: many scenes on one file of control."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, Any

import click

from raybundle.cli.common import FOLDER, NEW_FOLDER, Command, common_options, facts, significant
from raybundle.cli.settings import options_of, values_of
from raybundle.cli.summary import Summary, of_texts, report
from raybundle.commands.scenes.batch import RpcBatchSettings, run_batch
from raybundle.errors import Message, message_of_text, note, warning
from raybundle.settings import made

if TYPE_CHECKING:
    from raybundle.commands.scenes.batch import BatchScene


@click.command("batch", cls=Command)
@click.argument("scenes", type=FOLDER, nargs=-1, required=True)
@options_of(RpcBatchSettings, out=NEW_FOLDER)
@common_options
def batch(scenes: tuple[Path, ...], progress: str, **given: Any) -> None:
    """Correct many SCENES (files or folders) on one control file.

    The column image of the control names the image of each measurement: NAME or NAME.tif. biases.csv has one row per
    scene. If a scene cannot be corrected, its row gives the reason; the other scenes are corrected.

    \b
    Example:
      raybundle rpc batch scenes --control control.gpkg --out corrected
      raybundle rpc batch a.tif b.tif --control utm.csv --crs EPSG:32654 --to tif --out corrected
    """
    from raybundle.cli.progress import reporting

    settings = made(RpcBatchSettings, {"scenes": scenes, **values_of(RpcBatchSettings, given)})
    with reporting(progress) as notify:
        done = run_batch(settings, notify)
    facts(scenes=[_fact(s) for s in done.scenes], table=done.table)
    rows = [f"{'scene':32}{'bias':>8}{'points':>8}{'rms x, y [px]':>18}{'ERR_BIAS [m]':>14}"]
    notices: list[Message] = []
    for scene in done.corrected:
        c = scene.correction
        if c is None or c.fit is None or c.errors is None:
            continue
        rms = ", ".join(f"{v:.3f}" for v in c.fit.rms)
        used = len(c.ids) - len(c.advice.set_aside)
        rows.append(f"{scene.name[:31]:32}{c.fit.kind:>8}{used:8d}{rms:>18}{significant(c.errors.err_bias_m):>14}")
        notices += of_texts(scene.remarks)
        if wrong := [c.ids[k] for k in c.advice.set_aside]:
            notices.append(warning("rpc.control_set_aside", scene=scene.name, points=wrong))
    notices += [
        warning("rpc.scene_left_out", scene=scene.name, details=[message_of_text(scene.problem_line)])
        for scene in done.failed
    ]
    corrected = note("scene.corrected", n=len(done.corrected), of=len(done.scenes))
    report(Summary(done=[corrected], table=rows, notices=notices, files=[done.table]))


def _fact(scene: BatchScene) -> dict[str, Any]:
    """What became of a scene, for JSON."""
    c = scene.correction
    fit = None if c is None else c.fit
    return {
        "scene": scene.name, "file": scene.file, "problem": scene.problem_line,
        "message": None if scene.problem is None else scene.problem.json(),
        "remarks": list(scene.remarks), "bias": None if fit is None else fit.kind,
        "rms_px": None if fit is None else fit.rms, "errors": None if c is None else c.errors,
    }  # fmt: skip
