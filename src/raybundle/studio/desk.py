"""What is open: a project, result or block, its adjustment, the journal of what is measured, and the photographs."""

from __future__ import annotations

import threading
from collections.abc import Sequence
from dataclasses import dataclass, field
from pathlib import Path
from typing import Literal

import numpy as np

from raybundle.adjustment.result import Adjustment
from raybundle.block import Block
from raybundle.errors import InputError
from raybundle.io.block.folder import read_block
from raybundle.measuring.actions.masks import photograph_files
from raybundle.measuring.film import Scans, read_scans
from raybundle.measuring.journal import Journal, journal_path
from raybundle.measuring.names import Known
from raybundle.measuring.session import Session, block_folder, given_block, latest_block, readjusted
from raybundle.measuring.start import Standing, standing_of, to_begin
from raybundle.numerics.arrays import Index
from raybundle.numerics.progress import Progress, silent
from raybundle.orientation.rays import common_counts
from raybundle.pipeline.project import photographs_of
from raybundle.results.stored_options import made_as
from raybundle.studio.tiles import Tiles

Kind = Literal["project", "result", "block"]


@dataclass(slots=True)
class Desk:
    """One thing that is looked at and measured in; several threads may ask it."""

    source: Path
    kind: Kind
    given: Block
    """as it was opened: what is measured is merged into it, each time anew"""
    session: Session
    journal: Journal
    tiles: Tiles
    standing: Standing
    """how far the photographs are oriented"""
    scans: Scans | None = None
    """what is known of the film that the photographs are scans of"""
    photos: Sequence[Path] = ()
    """where the photographs are, beside where the project states"""
    stamp: tuple[int, ...] = ()
    """of the block as it was read"""
    times: int = 0
    """how often it was read anew: images may have other numbers then"""
    _rows: tuple[Index, Index] | None = None
    _shared: Index | None = None
    lock: threading.RLock = field(default_factory=threading.RLock)

    @classmethod
    def open(cls, source: Path, folder: Path, photos: Sequence[Path] = ()) -> Desk:
        """Open a project, result or block folder as it stands; `adjust` brings the covariances after.

        folder  for decoded photographs
        photos  where the photographs are, beside where the project states
        raises  InputError where it is none of these, or a file of it is damaged
        """
        stamp = _stamp(source)
        given = read_block(given_block(source))
        scans = read_scans(source)
        known = Known.of(given, () if scans is None else scans.calibrated.names)
        journal = Journal.open_or_look(journal_path(source), known)
        block = _latest_block(source, given)
        tiles = _tiles(folder, source, given, known, photos)
        session = Session.of_block(block, None)
        return cls(source, _kind(source), given, session, journal, tiles, standing_of(block), scans, photos, stamp)

    def read_anew(self) -> None:
        """Go on with what a run has written in the folder; the journal stays open, and what was measured with it.

        raises  InputError where the folder holds no block any more; the desk is then as it was
        """
        stamp = _stamp(self.source)
        given = read_block(given_block(self.source))
        known = Known.of(given, () if self.scans is None else self.scans.calibrated.names)
        block, times = _latest_block(self.source, given), self.times + 1
        folder = self.tiles.folder.parent if self.times else self.tiles.folder
        folder = folder / f"read-{times}"
        folder.mkdir()
        with self.lock:
            self.given, self.kind, self.times, self.stamp = given, _kind(self.source), times, stamp
            self.journal.known, before = known, self.tiles
            self.tiles = _tiles(folder, self.source, given, known, self.photos)
            self.replaced(Session.of_block(block, None))
        before.forget()

    @property
    def written_elsewhere(self) -> bool:
        """Whether another program has written the block since it was read."""
        return _stamp(self.source) != self.stamp

    @property
    def block(self) -> Block:
        """As it stands now."""
        return self.session.block

    @property
    def adjustment(self) -> Adjustment | None:
        """The current adjustment; None until there is one."""
        return self.session.adjustment

    def adjusted(self, progress: Progress = silent) -> Session:
        """A session of the same block with its adjustment and covariances; takes as long as an adjustment."""
        block, options = made_as(latest_block(self.source), self.block)
        return Session.of_block(block, lambda block: readjusted(block, progress, options))

    @property
    def to_begin(self) -> bool:
        """Whether the marks are to orient photographs."""
        return to_begin(self.given, self.journal.state)

    def replaced(self, session: Session, standing: Standing | None = None) -> None:
        """Go on with another session."""
        with self.lock:
            self.session = session
            self.standing = standing_of(session.block) if standing is None else standing
            self._rows = self._shared = None

    @property
    def shared(self) -> Index:
        """(k, 3) pairs of images and the points that they share by observations that take part, most first."""
        with self.lock:
            if self._shared is None:
                block, a = self.block, self.adjustment
                o = block.observations
                used = np.ones(len(o), bool) if a is None else a.image_observations.used
                every = np.ones(len(block.images), bool)
                self._shared = common_counts(o.image[used], o.point[used], every, len(block.points))
            return self._shared

    def rows_in(self, image: int) -> Index:
        """Rows of the image observations of an image."""
        with self.lock:
            if self._rows is None:
                order = np.argsort(self.block.observations.image, kind="stable").astype(np.int32)
                counts = np.bincount(self.block.observations.image, minlength=len(self.block.images))
                self._rows = order, np.concatenate([[0], np.cumsum(counts)]).astype(np.int32)
            order, ends = self._rows
        return order[ends[image] : ends[image + 1]]

    def close(self) -> None:
        """Close the journal."""
        self.journal.close()


def _kind(source: Path) -> Kind:
    if (source / "project.db").is_file():
        return "project"
    return "block" if block_folder(source) == source else "result"


def _stamp(source: Path) -> tuple[int, ...]:
    """What changes when a block is written again; raises InputError where there is none."""
    try:
        stat = (given_block(source) / "block.toml").stat()
    except OSError:
        return ()
    return stat.st_mtime_ns, stat.st_size, stat.st_ino


def _latest_block(source: Path, given: Block) -> Block:
    folder = latest_block(source)
    return given if folder == given_block(source) else read_block(folder)


def _tiles(folder: Path, source: Path, given: Block, known: Known, photos: Sequence[Path]) -> Tiles:
    files = photograph_files(given, [*photos, *photographs_of(source), *photographs_of(source / "result")])
    paths = {k: files[name] for k, name in enumerate(given.images.file) if name in files}
    return Tiles(folder, paths, {k: known.size_px[name] for k, name in enumerate(given.images.ids)})


def named(desk: Desk, image: str) -> int:
    """Position of an image; raises InputError for one that is not there."""
    position = desk.session.index.get(image)
    if position is None:
        raise InputError("mark.unknown_image", image=image, n=len(desk.session.index), known=list(desk.session.index))
    return position
