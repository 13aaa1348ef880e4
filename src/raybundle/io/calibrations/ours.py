"""Our own cameras: the [cameras.ID] tables of a TOML file, as `calibration` of orient takes them."""

from __future__ import annotations

import re
from collections.abc import Sequence
from pathlib import Path

import numpy as np

from raybundle.block import Block, Camera, Images, Observations, Points
from raybundle.block.stored import joint_covariance, observed_jointly
from raybundle.errors import InputError
from raybundle.io.block.toml import head_text, read_cameras, read_head
from raybundle.io.calibrations.base import Calibration, CalibrationFormat, Conversion, register


def read(path: Path, size_px: tuple[int, int] | None) -> tuple[Calibration, ...]:
    """The cameras of a TOML file, which may be the block.toml of a block."""
    del size_px
    cameras = read_head(path).cameras if path.name == "block.toml" else read_cameras(path)
    if not cameras:
        raise InputError("calibration.no_camera", file=path)
    return tuple(_calibration(c) for c in cameras)


def _calibration(camera: Camera) -> Calibration:
    free, covariance = joint_covariance(camera)
    if covariance is None:
        free = tuple(s for s in camera.values if s in camera.sigma)
        covariance = np.diag([camera.sigma[s] ** 2 for s in free]) if free else None
    return Calibration(id=camera.id, camera=camera, pixel_mm=camera.pixel_mm, free=free, covariance=covariance)


def cameras_text(cameras: Sequence[Camera]) -> str:
    """The [cameras.ID] tables of a TOML file; `read_cameras` reads them back equal."""
    none = np.zeros(0, np.int32)
    block = Block(
        cameras=tuple(cameras),
        images=Images(ids=(), camera=none, file=(), centre=np.zeros((0, 3)), rotation=np.zeros((0, 3, 3))),
        observations=Observations(image=none, point=none, xy_px=np.zeros((0, 2)), cov_px2=np.zeros((0, 3))),
        points=Points(ids=(), role=none, xyz=np.zeros((0, 3)), sigma=np.zeros((0, 3))),
    )
    text = head_text(block)
    return text[text.index("\n[cameras.") + 1 :]


def write(conversions: Sequence[Conversion], suffix: str) -> str:
    """A TOML file of cameras."""
    del suffix
    cameras: list[Camera] = []
    for conversion in conversions:
        camera = conversion.calibration.camera
        assert isinstance(camera, Camera)
        covariance = conversion.calibration.covariance
        cameras.append(
            camera if covariance is None else observed_jointly(camera, conversion.calibration.free, covariance)
        )
    return cameras_text(cameras)


register(
    CalibrationFormat(
        name="raybundle",
        title="our own TOML file of cameras; also a block.toml",
        suffixes=(".toml",),
        read=read,
        write=write,
        several=True,
        model="any",
        keeps="covariance",
        recognises=lambda text, suffix: suffix == ".toml" and bool(re.search(r"^\[cameras\.", text, re.MULTILINE)),
    )
)
