"""Readers as targets of the fuzzer: what one is, where they stand, and what several of them share."""

import contextlib
import io
from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path

import numpy as np


@dataclass(frozen=True, kw_only=True)
class Target:
    """A reader with its seeds."""

    name: str
    seeds: Callable[[Path], None]
    """Fills a new folder with folders 0, 1, ... of one valid input each."""
    read: Callable[[Path], list[str]]
    slow: bool = False
    """Takes more than some 20 ms an input."""


TARGETS: dict[str, Target] = {}


def target(name: str, seeds, read, *, slow: bool = False) -> None:
    TARGETS[name] = Target(name=name, seeds=seeds, read=read, slow=slow)


def place(top: Path, number: int = 0) -> Path:
    folder = top / str(number)
    folder.mkdir(parents=True)
    return folder


def texts(*inputs: dict[str, str | bytes]):
    """Seeds that are texts."""

    def write(top: Path) -> None:
        for k, files in enumerate(inputs):
            folder = place(top, k)
            for name, text in files.items():
                (folder / name).write_bytes(text if isinstance(text, bytes) else text.encode())

    return write


def only(folder: Path, *, but: str = "") -> Path:
    """The file of an input."""
    return min(folder.iterdir(), key=lambda p: (bool(but) and p.name.endswith(but), p.name))


def not_finite(**values) -> list[str]:
    return [name for name, value in values.items() if not np.isfinite(np.asarray(value, float)).all()]


def wrong_in_block(block) -> list[str]:
    wrong = not_finite(xy=block.observations.xy_px, cov=block.observations.cov_px2)
    for camera in block.cameras:
        wrong += not_finite(**{f"camera {s}": v for s, v in camera.values.items()})
        if min(camera.width_px, camera.height_px) <= 0:
            wrong.append("format")
    R = block.images.rotation[block.images.oriented]
    if len(R) and not np.allclose(R @ np.swapaxes(R, 1, 2), np.eye(3), atol=1e-6):
        wrong.append("rotation")
    o = block.observations
    if len(o) and not (0 <= o.image.min() <= o.image.max() < len(block.images)):
        wrong.append("image index")
    if len(o) and not (0 <= o.point.min() <= o.point.max() < len(block.points)):
        wrong.append("point index")
    return wrong


def command(*arguments) -> tuple[int, str]:
    from raybundle.cli.main import main

    out, err = io.StringIO(), io.StringIO()
    with contextlib.redirect_stdout(out), contextlib.redirect_stderr(err):
        status = main([*map(str, arguments)])
    if status == 1:
        raise AssertionError(err.getvalue()[-200:])
    return status, out.getvalue()
