"""A block with its adjustment, kept open: what a server or a command asks where points should be seen."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass, field, replace
from pathlib import Path

import numpy as np

from raybundle.adjustment.decision.decide import decide
from raybundle.adjustment.records.options import AdjustmentOptions
from raybundle.adjustment.result import Adjustment
from raybundle.block import Block, Camera
from raybundle.errors import InputError, NotSolvable, Text, as_detail, joined_texts, phrase
from raybundle.io.block.folder import read_block
from raybundle.io.block.places import block_places
from raybundle.measuring.joint import Joint
from raybundle.measuring.journal import measured_result
from raybundle.measuring.names import Known
from raybundle.numerics.progress import Progress, silent
from raybundle.results.project_results import base_result, project_of
from raybundle.results.stored_options import made_as

Adjust = Callable[[Block], Adjustment]


def readjusted(block: Block, progress: Progress = silent, options: AdjustmentOptions | None = None) -> Adjustment:
    """The adjustment of a block that holds adjusted values: it converges at once, and has all covariances.

    options  under which it was adjusted; rejected image observations, parameters that were chosen, noise and what
             carries the datum are known of the block
    """
    asked = options or AdjustmentOptions()
    like = replace(
        asked, reject="none", estimate="given", robust_start=False, noise=block.noise or "white",
        datum_over=block.datum_over or "all",
    )  # fmt: skip
    return decide(block, like, progress)


def adjusted_again(folder: str | Path, progress: Progress = silent) -> Adjustment:
    """The adjustment of a project, result or block folder, of a result under its options; see `readjusted`."""
    block, options = _stored(folder)
    return readjusted(block, progress, options)


def adjusted_as_free(given: Block | str | Path, progress: Progress = silent) -> Adjustment:
    """The adjustment of a block, or of a folder, with inner constraints for everything but a measured scale.

    Control then has no part in the shape of the network, and no point is without error.
    """
    block, options = (given, AdjustmentOptions()) if isinstance(given, Block) else _stored(given)
    return readjusted(block, progress, replace(options, datum="inner", datum_points=()))


def _stored(folder: str | Path) -> tuple[Block, AdjustmentOptions]:
    """The block of a folder, and the options that its result was made under."""
    inner = block_folder(folder)
    return made_as(inner, read_block(inner))


@dataclass(slots=True)
class Session:
    """A block, adjusted or only oriented, and the answers that are kept of it."""

    block: Block
    """as it stands: adjusted where there is an adjustment"""
    adjustment: Adjustment | None
    neglected: str
    """what covariances leave out, in words; "" where they are full"""
    joint: Joint | None
    known: Known
    index: Mapping[str, int]
    """image -> position"""
    points: Mapping[str, int]
    """point -> position"""
    _depths: dict[int, tuple[float, float]] = field(default_factory=dict[int, tuple[float, float]])

    @classmethod
    def of(cls, adjustment: Adjustment) -> Session:
        """Of an adjustment, with its full covariances if it has statistics."""
        joint = None if adjustment.handle.work is None else Joint.of(adjustment)
        words = "" if joint else phrase("measuring.no_statistics")
        block = replace(adjustment.adjusted, free_scale=adjustment.free_scale)
        return cls._made(block, adjustment, words, joint)

    @classmethod
    def of_block(cls, block: Block, adjust: Adjust | None = readjusted) -> Session:
        """Of a block, adjusted once where that is possible.

        adjust  None: the block as it stands, without covariances
        """
        if adjust is None:
            return cls._made(block, None, phrase("measuring.block_not_adjusted"), None)
        try:
            return cls.of(adjust(block))
        except NotSolvable as error:
            words = joined_texts(phrase("measuring.block_not_adjusted"), Text.of(as_detail(error)))
            return cls._made(block, None, words, None)

    @classmethod
    def _made(cls, block: Block, adjustment: Adjustment | None, neglected: str, joint: Joint | None) -> Session:
        index = {name: i for i, name in enumerate(block.images.ids)}
        points = {name: i for i, name in enumerate(block.points.ids)}
        return cls(block, adjustment, neglected, joint, Known.of(block), index, points)

    @property
    def variance(self) -> float:
        """Factor between a-priori covariances of image points and those that the residuals show."""
        a = self.adjustment
        return 1.0 if a is None else a.variance_factor

    def camera(self, image: int) -> Camera:
        """The camera of an image with the parameters of that image."""
        return self.block.camera_of(image)

    def oriented(self, image: int) -> bool:
        """Whether an image's exterior orientation is known."""
        return bool(self.block.images.oriented[image])

    def position(self, image: str) -> int:
        """Position of an image, by id or file; raises InputError."""
        return self.index[self.known.image(image)]

    def depths(self, image: int) -> tuple[float, float]:
        """Distances from the projection centre between which object points may lie, as the block suggests.

        Half of the nearest to twice the farthest of the points that the image sees, but for one in a hundred at either
        end; where it sees none, of all points.
        """
        if image not in self._depths:
            b, centre = self.block, self.block.images.centre[image]
            seen = np.unique(b.observations.point[np.asarray(b.observations.image) == image])
            found = np.zeros(0)
            for which in (seen, np.arange(len(b.points))):
                d = np.linalg.norm(b.points.xyz[which] - centre, axis=1)
                found = d[np.isfinite(d) & (d > 0)]
                if len(found):
                    break
            near, far = np.quantile(found, [0.01, 0.99]) if len(found) else (1.0, 100.0)
            self._depths[image] = float(near) / 2, float(far) * 2
        return self._depths[image]


def block_folder(folder: str | Path) -> Path:
    """The block folder of a project, a result or a block folder; raises InputError."""
    folder = Path(folder)
    for inner in block_places(folder):
        if (inner / "block.toml").is_file():
            return inner
    code = "project.no_result" if (folder / "project.toml").is_file() else "session.no_project"
    raise InputError(code, file=folder)


def given_block(folder: str | Path) -> Path:
    """The block folder that marks are merged into: in a project that of its result without marks."""
    project = project_of(folder)
    base = None if project is None else base_result(project)
    if base is not None:
        return base / "block"
    return block_folder(folder) if project is None or not (project / "block").is_dir() else project / "block"


def latest_block(folder: str | Path) -> Path:
    """The block folder with what was measured, as it was adjusted last; the own one where that was written later."""
    inner, latest = block_folder(folder), measured_result(folder) / "block"
    own, measured = ((b / "block.toml").stat().st_mtime if b.is_dir() else -1.0 for b in (inner, latest))
    return latest if measured >= own else inner


def holds_block(folder: Path) -> bool:
    """Whether a folder is a project, a result or a block folder."""
    return any((inner / "block.toml").is_file() for inner in block_places(folder))
