"""Which parameters are free or held because somebody asked for it, whatever the block or a test states."""

from __future__ import annotations

from raybundle.adjustment.records.options import AdjustmentOptions
from raybundle.block import Block, Camera, Instrument
from raybundle.errors import InputError


def check_asked(block: Block, options: AdjustmentOptions) -> None:
    """Raise InputError for a parameter that the block does not have, and for one that is asked for both ways."""
    known = {c.id: c.sensor.symbols for c in block.parametrised}
    for name, asked in (("free", options.free), ("hold", options.hold)):
        for camera, symbol in asked:
            if camera not in known:
                raise InputError("parameter.unknown_camera", way=name, camera=camera, known=[*known])
            if symbol not in known[camera]:
                raise InputError("parameter.not_of_camera", way=name, camera=camera, symbol=symbol, known=known[camera])
    for camera, symbol in sorted(set(options.free) & set(options.hold)):
        raise InputError("parameter.free_and_held", camera=camera, symbol=symbol)


def with_asked(camera: Camera | Instrument, free: tuple[str, ...], options: AdjustmentOptions) -> tuple[str, ...]:
    """Free parameters of a camera, those that are asked to be free among them, those asked to be held not."""
    more = {s for c, s in options.free if c == camera.id} - set(free)
    held = {s for c, s in options.hold if c == camera.id}
    if not more and not held:
        return free
    return tuple(s for s in camera.sensor.symbols if (s in free or s in more) and s not in held)
