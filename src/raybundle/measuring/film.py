"""Scans of film: what is known of their camera, and where each lies in its frame by the fiducial marks measured in it.

PROJECT/film/certificate.csv   calibrated positions of the marks, as `raybundle film` reads them
PROJECT/film/film.toml         pixel of the scanner, model of the transformation
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field, replace
from pathlib import Path
from typing import Literal, cast

import numpy as np

from raybundle.block import Block, Camera
from raybundle.block.block import PixelFrame
from raybundle.errors import InputError, phrase
from raybundle.io.film.fiducials import LEAST, Calibrated, Film, film_of, read_calibrated, suspects
from raybundle.io.reading.trees import read_toml
from raybundle.measuring.state import State
from raybundle.numerics.arrays import Array
from raybundle.orientation.projective.missing_data import Lack

FOLDER = "film"
Straight = Literal["similarity", "affine"]
"""Transformations that stay one where they are turned round; a projective one is for prints."""


@dataclass(frozen=True, slots=True, kw_only=True)
class Scans:
    """What is known of the film that photographs are scans of."""

    calibrated: Calibrated
    pixel_mm: float
    """size of a pixel of the scanner"""
    model: Straight = "affine"


@dataclass(frozen=True, slots=True, kw_only=True)
class Placed:
    """A block whose scans lie in their camera's frame as their fiducial marks say."""

    block: Block
    lacking: tuple[Lack, ...] = ()
    """scans that have too few fiducial marks, or such as do not fit: their marks take no part"""
    films: Mapping[str, Film] = field(default_factory=dict[str, Film])
    """by image"""

    @property
    def words(self) -> tuple[str, ...]:
        """What is to be stated of the films: marks that do not fit the others."""
        suspected = {name: suspects(f) for name, f in self.films.items()}
        return tuple(phrase("measuring.suspect_fiducials", image=n, marks=list(s)) for n, s in suspected.items() if s)


def read_scans(project: str | Path) -> Scans | None:
    """What a project knows of the film of its photographs; None where they are none."""
    folder = Path(project) / FOLDER
    if not (folder / "film.toml").is_file():
        return None
    tree = read_toml(folder / "film.toml").tree().get("film")
    model = tree.get("model").text()
    if model not in {"similarity", "affine"}:
        raise InputError("fiducial.unknown_model", model=model, file=folder / "film.toml")
    return Scans(
        calibrated=read_calibrated(folder / "certificate.csv"), pixel_mm=tree.get("pixel_mm").number(),
        model=cast("Straight", model),
    )  # fmt: skip


def write_scans(scans: Scans, certificate: Path, folder: Path) -> None:
    """Write what a project knows of its film into a new folder."""
    (folder / "certificate.csv").write_bytes(certificate.read_bytes())
    text = f'[film]\npixel_mm = {scans.pixel_mm!r}\nmodel = "{scans.model}"\n'
    (folder / "film.toml").write_text(text, encoding="utf-8")


def as_scans(block: Block, sizes: Mapping[int, tuple[int, int]], scans: Scans) -> Block:
    """The block with its images as scans of these sizes [px], each for now in the middle of its camera's format."""
    frames: dict[int, PixelFrame] = {}
    for k, (width, height) in sizes.items():
        camera = block.cameras[int(block.images.camera[k])]
        M = np.diag(np.array(camera.pixel_mm) / scans.pixel_mm)
        shift = np.array([width, height]) / 2 - M @ [camera.width_px / 2, camera.height_px / 2]
        frames[k] = _frame(width, height, M, shift)
    return replace(block, images=replace(block.images, frames=frames))


def placed(block: Block, state: State, scans: Scans | None) -> Placed:
    """The block with its scans where the fiducial marks say that they lie in the camera's frame."""
    if scans is None:
        return Placed(block=block)
    frames, lacking, films = dict(block.images.frames), list[Lack](), dict[str, Film]()
    least = LEAST[scans.model]
    for k, name in enumerate(block.images.ids):
        frame, marks = frames.get(k), state.fiducials_in(name)
        if frame is None or frame.affine is None:
            continue
        if len(marks) < least:
            lacking.append(Lack(image=name, kind="fiducials", have=len(marks), need=least))
            continue
        xy = np.array([[m.x_px, m.y_px] for m in marks.values()])
        sigma = np.sqrt([[m.covariance[0], m.covariance[1]] for m in marks.values()])
        try:
            film = film_of(name, [*marks], xy, sigma, scans.calibrated, pixel_mm=scans.pixel_mm, model=scans.model)
        except InputError as error:
            lacking.append(Lack(image=name, kind="film", have=len(marks), need=least, stated=str(error)))
            continue
        films[name] = film
        M, shift = _file_from_camera(film, block.cameras[int(block.images.camera[k])])
        frames[k] = _frame(frame.width_px, frame.height_px, M, shift)
    images = replace(block.images, frames=frames)
    return Placed(block=replace(block, images=images), lacking=tuple(lacking), films=films)


def _file_from_camera(film: Film, camera: Camera) -> tuple[Array, Array]:
    """The affine transformation of a scan: its pixels by those of the camera."""
    ends = film.middle_px + np.array([[0.0, 0.0], [1.0, 0.0], [0.0, 1.0]]) * 1000.0
    at = camera.pixel_from_image(film.image_from_pixel(ends))
    A = (at[1:] - at[0]).T / 1000.0
    M = np.linalg.inv(A)
    return M, ends[0] - M @ at[0]


def _frame(width: int, height: int, M: Array, shift: Array) -> PixelFrame:
    (a, b), (c, d) = M.tolist()
    x, y = shift.tolist()
    return PixelFrame(turned=0, width_px=width, height_px=height, affine=(a, b, x, c, d, y))
