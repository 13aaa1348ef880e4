"""Names of a block and of what comes with it, which are the same in every language."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import astuple
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from raybundle.adjustment.result import Adjustment
    from raybundle.report.delivery import Delivery
    from raybundle.report.facts import PhotographFacts

NAMING = frozenset({"image_left_out", "nominal_missing", "control_file"})
"""Notices about what the block has not: photographs that take no part, points that were not measured"""


def names_of(
    adjustment: Adjustment, photographs: PhotographFacts | None, delivery: Delivery | None
) -> Iterator[str]:  # fmt: skip
    """Names that a report may hold: of cameras, images, points, files, people, coordinate systems."""
    block = adjustment.given
    yield from (block.name, block.about, block.source, block.licence)
    for c in block.cameras:
        yield from (c.id, c.model)
    yield from block.images.ids
    yield from block.images.file
    yield from block.points.ids
    for g in adjustment.groups:
        yield from g.ids
    for i in adjustment.interior:
        yield from i.parameters
    for n in adjustment.notices:
        if n.code in NAMING:
            yield from n.ids
    if photographs is not None:
        for p in photographs.photographs:
            yield from (p.name, p.camera, p.device)
        for c in photographs.cameras:
            yield from (c.camera, c.name)
        for name, _ in (*photographs.refused, *photographs.not_oriented):
            yield name
    if delivery is not None:
        yield from astuple(delivery.record)
        yield from (f for f in (*delivery.files, delivery.surface) if "." in f)
        yield "block/"  # the folder; without its stroke it is a word as well
        if delivery.frame is not None:
            yield delivery.frame.crs
