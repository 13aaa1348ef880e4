"""Stage: the family of targets or the board, where nobody stated what was photographed."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace

from raybundle.io.photos.photo import Photo
from raybundle.numerics.arrays import Array
from raybundle.pipeline.stage import Codec, Means, Stage
from raybundle.targets.marks import target
from raybundle.workflows.calibrating.recognise import Recognised, recognised
from raybundle.workflows.calibrating.stages.photographs import with_dots
from raybundle.workflows.calibrating.state import CALIBRATE, CalibrateState
from raybundle.workflows.stage_arrays import texts


def look(photos: tuple[Photo, ...], means: Means) -> Recognised:
    """What some of the photographs show; raises InputError where it cannot be determined."""
    return recognised(photos, means.progress)


def _put(state: CalibrateState, shown: Recognised) -> CalibrateState:
    return replace(state, shown=shown, targets=with_dots(shown.targets, state.options))


def _arrays(shown: Recognised) -> dict[str, Array]:
    families = tuple(t.family for t in shown.targets)
    names = {"targets": families, "looked_at": shown.looked_at, "few": shown.few}
    return {name: texts(values) for name, values in names.items()}


def _product(a: Mapping[str, Array]) -> Recognised:
    return Recognised(
        targets=tuple(target(name) for name in a["targets"].tolist()),
        looked_at=tuple(a["looked_at"].tolist()),
        few=tuple(a["few"].tolist()),
    )


STAGE = CALIBRATE.register(
    Stage(
        name="recognised",
        line="photographs",
        after=("photographs",),
        inputs=lambda s: s.photos,
        function=look,
        put=_put,
        reported=lambda s: ", ".join(t.title for t in s.targets) or "no targets",
        codec=Codec(arrays=_arrays, product=_product),
        when=lambda s: not s.targets,
    )
)
