"""What is known of a camera before its photographs measure anything: observations of its own, beside what they show.

A camera of which nothing is stated is none of which nothing is known.  Its principal point lies near the middle of the
format, its camera constant near what the file states.  Where photographs determine these, the observations weigh
nothing: a principal point to 0.02 % of the format against 2 % moves by a ten-thousandth of what was known wrongly.
Where they do not, all else is as uncertain as that makes it, and stated so; held, it would count as free of error.

A camera constant is known by a factor: that it is half is as likely as that it is twice.  Its logarithm is observed.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace

import numpy as np

from raybundle.block.block import Camera, Instrument, Relation


def observed_as_known(camera: Camera, sigma: Mapping[str, float]) -> Camera:
    """The camera with values observed as they are known beforehand.

    sigma  symbol -> standard deviation; of a scale (the camera constant) of its natural logarithm
    """
    kinds = {p.symbol: p.kind for p in camera.sensor.parameters}
    added = tuple(
        Relation(
            name=f"known before: {symbol}", terms={symbol: 1.0}, sigma=std, origin="known before",
            observed=float(np.log(camera.values[symbol])) if kinds[symbol] == "scale" else camera.values[symbol],
            logarithm=kinds[symbol] == "scale",
        )
        for symbol, std in sigma.items()
        if kinds[symbol] != "scale" or camera.values[symbol] > 0
    )  # fmt: skip
    return replace(camera, relations=(*camera.relations, *added), known=dict(camera.values))


def known_before(camera: Camera | Instrument) -> dict[str, Relation]:
    """By symbol, how what was known of a camera before is observed."""
    return {next(iter(r.terms)): r for r in camera.relations if r.origin == "known before"}
