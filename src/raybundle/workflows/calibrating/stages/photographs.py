"""Stage: the photographs among the inputs, and what was stated of them."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from pathlib import Path

from raybundle.errors import InputError, excluded
from raybundle.io.photos.cameras import camera_groups
from raybundle.io.photos.photo import Found, find_photos
from raybundle.pipeline.stage import Means, Stage
from raybundle.targets.kinds.rings import Rings
from raybundle.targets.marks import Target, target
from raybundle.workflows.calibrating.options import CalibrateOptions
from raybundle.workflows.calibrating.state import CALIBRATE, CalibrateState

FEWEST_PHOTOGRAPHS = 3


@dataclass(frozen=True, slots=True, kw_only=True)
class Inputs:
    """What the search depends on, beside the files themselves."""

    paths: tuple[Path, ...]


def search(given: Inputs, means: Means) -> Found:
    """The photographs; raises InputError where they are too few."""
    found = find_photos(given.paths, progress=means.progress)
    _enough(found, given.paths)
    return found


def _enough(found: Found, inputs: Sequence[Path]) -> None:
    n = len(found.photos)
    if n < FEWEST_PHOTOGRAPHS:
        refused = [(p.name, r) for p, r in found.refused]
        raise InputError(
            "calibration.too_few_photographs", n=n, least=FEWEST_PHOTOGRAPHS,
            details=excluded(refused, found.remarks), file=", ".join(map(str, inputs)),
        )  # fmt: skip


def with_dots(targets: Sequence[Target], options: CalibrateOptions) -> tuple[Target, ...]:
    """Families of rings with the dots among them where those are wanted, too."""
    if not options.dots:
        return tuple(targets)
    return tuple(replace(t, dots=True) if isinstance(t, Rings) else t for t in targets)


def _put(state: CalibrateState, found: Found) -> CalibrateState:
    options = state.options
    targets = tuple(target(t) if isinstance(t, str) else t for t in options.targets)
    if options.sheet is not None:
        targets = (options.sheet.target,)
    groups = camera_groups(found.photos, (), options.separate)
    refused = tuple((p.name, r) for p, r in found.refused)
    return replace(state, found=found, refused=refused, targets=with_dots(targets, options), groups=groups)


STAGE = CALIBRATE.register(
    Stage(
        name="photographs",
        inputs=lambda s: Inputs(paths=s.inputs),
        function=search,
        put=_put,
        reported=lambda s: f"{len(s.photos)} photographs",
    )
)
