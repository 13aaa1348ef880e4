"""Block folders, results, formats of other programs, and the commands that read them."""

import csv
import functools
import json
import math
import shutil
from pathlib import Path

from tests.hostile.readers.registry import command, place, target, wrong_in_block


@functools.cache
def small_block():
    from raybundle.planning.simulate import Survey, simulate
    from raybundle.planning.synthetic_networks import TargetField, brown_camera, field_scene

    camera = brown_camera(values=dict.fromkeys(("K2", "K3", "P1", "P2"), 0.0))
    plan = TargetField(camera=camera, stations=3, frontal=2, rows=3, columns=4)
    return simulate(field_scene(plan), Survey(control=4, control_sigma=(1e-3, 1e-3, 1e-3)))


def block_seeds(top: Path) -> None:
    from raybundle.io.block.folder import write_block

    write_block(small_block().observed, place(top) / "b")
    for file in (top / "0" / "b").iterdir():
        file.rename(top / "0" / file.name)
    (top / "0" / "b").rmdir()


def scene_block_seeds(top: Path) -> None:
    from raybundle.io.block.folder import write_block
    from tests.truth.mixed_blocks import ikonos_pair, two_camera_rig

    for k, block in enumerate((ikonos_pair(points=12, check=2), two_camera_rig(stations=2))):
        folder = write_block(block, top / str(k))
        del folder


def read_a_block(folder: Path) -> list[str]:
    from raybundle.io.block.folder import read_block

    return wrong_in_block(read_block(folder))


NAMES = {"point", "role", "image", "camera", "file"}
"""Columns that hold names; a point may be called nan."""


def adjusted(folder: Path, *, report: bool) -> list[str]:
    out = folder.parent / "result"
    shutil.rmtree(out, ignore_errors=True)
    status, _ = command("adjust", folder, "--out", out, "--jobs", "1", *([] if report else ["--no-report"]))
    if status != 0:
        return []
    sigma0 = json.loads((out / "result.json").read_text())["sigma0"]
    wrong = [] if sigma0 is not None and math.isfinite(sigma0) else [f"sigma0 {sigma0}"]
    for name in ("points.csv", "images.csv"):
        with (out / name).open(encoding="utf-8", newline="") as file:
            for row in csv.DictReader(file):
                wrong += [f"{name}: {k} {v}" for k, v in row.items() if k not in NAMES and v in {"nan", "inf", "-inf"}]
    return wrong


def format_seeds(name: str):
    def write(top: Path) -> None:
        from raybundle.io.formats import Export, formats, write_format

        write_format(name, Export(block=small_block().truth), place(top) / f"m{formats[name].suffix}")

    return write


def read_a_format(name: str):
    def read(folder: Path) -> list[str]:
        from raybundle.io.formats import formats, read_format

        return wrong_in_block(read_format(name, folder / f"m{formats[name].suffix}").block)

    return read


def result_seeds(top: Path) -> None:
    from raybundle.report.write import write_result
    from raybundle.workflows.adjust import adjust

    write_result(adjust(small_block().observed), place(top) / "r", report="none")


def read_a_result(folder: Path) -> list[str]:
    from raybundle.workflows.sources import read_source

    return wrong_in_block(read_source(folder / "r", None)[0].block)


def converted(folder: Path) -> list[str]:
    out = folder.parent / "converted"
    shutil.rmtree(out, ignore_errors=True)
    command("convert", folder, "--to", "colmap-text", "--out", out)
    return []


target("block", block_seeds, read_a_block)
target("block-scenes", scene_block_seeds, read_a_block, slow=True)
target("adjust", block_seeds, functools.partial(adjusted, report=False), slow=True)
target("adjust-scenes", scene_block_seeds, functools.partial(adjusted, report=False), slow=True)
target("report", block_seeds, functools.partial(adjusted, report=True), slow=True)
target("convert", block_seeds, converted, slow=True)
target("result", result_seeds, read_a_result, slow=True)
for _name in ("bingo", "colmap", "colmap-text", "metashape", "nerfstudio", "opensfm", "opf", "patb"):
    target(f"format-{_name}", format_seeds(_name), read_a_format(_name))
