"""What becomes of satellite scenes where a block goes into another program: RPCs with the bias built in, or points."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from pathlib import Path
from typing import cast

import numpy as np

from raybundle.block import Block, Camera
from raybundle.errors import InputError, phrase
from raybundle.io.formats.base import Export
from raybundle.io.scenes.rpc_text import write_rpc_text
from raybundle.numerics.arrays import Mask
from raybundle.scenes.sensor import SceneSensor
from raybundle.sensors import sensor_models

RELIEF_M = 500.0
"""Heights above and below the points of a rigorous scene for which its RPC is made."""


def scene_images(block: Block) -> Mask:
    """(n,) which images are satellite scenes."""
    return np.array([c.is_scene for c in block.cameras], bool)[block.images.camera]


def write_rpcs(export: Export, folder: Path) -> tuple[tuple[Path, ...], tuple[str, ...]]:
    """NAME_RPC.TXT of every scene with its estimated bias built in; the files, and how well new RPCs fit.

    A shift goes into the offsets, exactly; drift, affine and rigorous models need a new fit, whose misfit is reported.
    ERR_BIAS and ERR_RAND are those of the adjusted bias, where a result shows its covariance.
    raises  InputError where the block has no scene
    """
    block = export.block
    scenes = np.flatnonzero(scene_images(block))
    if not len(scenes):
        raise InputError("block.no_scene", block=block.name)
    files: list[Path] = []
    remarks: list[str] = []
    for i in scenes.tolist():
        camera = block.cameras[int(block.images.camera[i])]
        sensor, values = cast("SceneSensor", camera.scene), camera.parameters
        name = Path(block.images.file[i] or block.images.ids[i]).stem
        path = folder / f"{name}_RPC.TXT"
        if path in files:
            raise InputError("name.twice", kind="scene", name=name)
        heights = sensor.heights_m or _heights_of_points(block, sensor)
        rpc, fit = sensor.as_rpc(values, heights, export.interior.get(camera.id, ((), np.zeros((0, 0)))))
        if fit is not None:
            largest = float(fit.largest_px.max())
            low, high = (float(h) for h in heights)
            remarks.append(phrase("conversion.new_rpc", name=path.name, low_m=low, high_m=high, largest_px=largest))
        write_rpc_text(rpc, path)
        files.append(path)
    return tuple(files), tuple(remarks)


def _heights_of_points(block: Block, sensor: SceneSensor) -> tuple[float, float]:
    known = np.isfinite(block.points.xyz).all(axis=1)
    if not known.any():
        return sensor.height_m - RELIEF_M, sensor.height_m + RELIEF_M
    heights = sensor.place.geographic_from_block(block.points.xyz[known])[:, 2]
    return float(heights.min()) - RELIEF_M, float(heights.max()) + RELIEF_M


def with_viewpoints(block: Block) -> Block:
    """The block with a central projection from the nominal viewpoint in place of each scene: for its points alone."""
    model = sensor_models["brown"]

    def central(camera: Camera) -> Camera:
        c = cast("SceneSensor", camera.scene).camera_constant(camera.parameters)
        values = {**dict.fromkeys(model.symbols, 0.0), "c": c}
        return replace(
            camera, model="brown", scene=None, relations=(), calibrated=None, estimate=(), sigma={}, values=values
        )

    return replace(block, cameras=tuple(central(c) if c.is_scene else c for c in block.cameras))


def without_scenes(block: Block) -> Block:
    """The block without the orientation and the image points of its scenes."""
    scenes = scene_images(block)
    o = block.observations
    keep = ~scenes[o.image]
    return replace(
        with_viewpoints(block),
        images=replace(
            block.images,
            centre=np.where(scenes[:, None], np.nan, block.images.centre),
            rotation=np.where(scenes[:, None, None], np.nan, block.images.rotation),
        ),
        observations=o.rows(keep),
    )


def names_of_scenes(block: Block, most: int = 5) -> str:
    """The first few scenes, for a message."""
    names: Sequence[str] = [block.images.ids[i] for i in np.flatnonzero(scene_images(block))]
    return ", ".join(names[:most]) + (" ..." if len(names) > most else "")
