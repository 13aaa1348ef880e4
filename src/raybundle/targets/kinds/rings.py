"""Coded rings of every registered family, and plain dots."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

import numpy as np

from raybundle.errors import phrase
from raybundle.numerics.arrays import Array
from raybundle.targets.codes import RingFamily
from raybundle.targets.detect import DetectionOptions, Detections, detect_targets
from raybundle.targets.families import families
from raybundle.targets.marks import Kind, MarkOptions, Marks, Target, register


@dataclass(frozen=True, slots=True, kw_only=True)
class Rings:
    """Targets of a ring family; with `dots` those without a ring, too."""

    rings: RingFamily | None
    dots: bool = False

    @property
    def family(self) -> str:
        """aicon14, dots."""
        return "dots" if self.rings is None else self.rings.name

    @property
    def title(self) -> str:
        """For people."""
        return "dots without a code" if self.rings is None else self.rings.title

    @property
    def objects(self) -> Mapping[str, Array]:
        """Unknown: single targets."""
        return {}

    @property
    def turns(self) -> int:
        """Every target has its name."""
        return 1

    @property
    def radius(self) -> float:
        """Unknown."""
        return np.nan

    def find(self, image: Array, options: MarkOptions) -> Marks:
        """Targets with a number, each once, and dots where they are wanted."""
        wanted = DetectionOptions(
            polarity=options.polarity, threads=options.threads,
            uncoded="dots" if self.dots or self.rings is None else "none",
        )  # fmt: skip
        return marks_of(detect_targets(image, self.rings, wanted), self.family)


def marks_of(found: Detections, family: str) -> Marks:
    """Detections by name; a number read twice in a photograph is left without one, and that is remarked."""
    numbers, count = np.unique(found.id[found.coded], return_counts=True)
    twice = numbers[count > 1]
    bare = ~found.coded | np.isin(found.id, twice)
    return Marks(
        family=family,
        name=tuple("" if b else str(int(i)) for i, b in zip(found.id, bare, strict=True)),
        xy_px=found.xy_px,
        covariance=found.covariance,
        ellipse=found.ellipse,
        gate=found.residual,
        remarks=tuple(phrase("target_seen.read_twice", target=str(i)) for i in twice),
    )


def _make(name: str) -> Target | None:
    if name == "dots":
        return Rings(rings=None)
    return Rings(rings=families[name]) if name in families else None


register("rings", Kind(form=", ".join(families), make=_make, names=lambda _: [*families]))
register("dots", Kind(form="dots", make=lambda name: _make(name) if name == "dots" else None, names=lambda _: ["dots"]))
