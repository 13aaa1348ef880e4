"""What photographs say of a camera against what was known of it before (`raybundle.block.known`).

Where they contradict it jointly, the camera that was found is none that this one can be, and orientations that lean on
it are wrong with it.  Where they add nothing to it, everything else leans on what was known.
"""

from __future__ import annotations

from dataclasses import replace

import numpy as np
from scipy.special import chdtri

from raybundle.adjustment.evaluation.held_interiors import CARRIED
from raybundle.adjustment.records.figures import InteriorResult, ParameterResult
from raybundle.adjustment.records.notice import Notice
from raybundle.adjustment.result import Adjustment
from raybundle.block import Camera, Relation
from raybundle.block.known import known_before
from raybundle.errors import Message, Value, message

NAMED_CAMERAS = 3
"""Cameras that a notice names; the rest are counted."""
OPEN = 0.4
"""Sigma of ln c from which on nothing was stated of the camera constant: a guess, and no camera is contradicted."""
LENSES = (0.25, 20.0)
"""Camera constants in longer sides of the format that lenses have: 9 mm to 720 mm for 24 x 36 mm."""
FOUND = 0.1
"""Relative standard deviation of a camera constant from which on photographs have determined it by themselves."""
LEVEL = 1e-3
"""Probability with which a camera that is as known before is called a contradiction, at most."""


def against_known(result: Adjustment) -> Adjustment:
    """The result with what is to be stated of its cameras against what was known of them."""
    notices = list[Notice]()
    interiors = list[InteriorResult]()
    names = list[str]()
    leaning = list[tuple[Camera, InteriorResult, dict[str, Relation]]]()
    for interior in result.interior:
        camera = next((c for c in result.given.cameras if c.id == interior.camera), None)
        if camera is None:  # of an instrument nothing is known so
            interiors.append(interior)
            continue
        known = {s: r for s, r in known_before(camera).items() if s in interior.free}
        unknown = [s for s, r in known.items() if not _confirmed(interior, s, r, result.sigma0)]
        parameters = {s: replace(p, status="not determinable") for s, p in interior.parameters.items() if s in unknown}
        interiors.append(replace(interior, parameters={**interior.parameters, **parameters}))
        names += [f"{s} (camera {camera.id})" for s in unknown]
        contradiction = _contradiction(result, camera, interior)
        if contradiction is not None:
            notices.append(contradiction)
        elif unknown:
            leaning.append((camera, interior, {s: known[s] for s in unknown}))
    notices += _unknown(leaning)
    if not notices:
        return result
    return replace(
        result, interior=tuple(interiors), notices=(*notices, *result.notices),
        not_determinable=tuple(dict.fromkeys((*result.not_determinable, *names))),
    )  # fmt: skip


def _confirmed(interior: InteriorResult, symbol: str, known: Relation, sigma0: float) -> bool:
    """Whether the photographs say more of a parameter than was known: at most half its standard deviation is left."""
    p = interior.parameters[symbol]
    if p.std is None:
        return True
    white = p.std_white or p.std  # the prior's share is that of the adjustment, whatever the noise is
    std = white / abs(p.value) if known.logarithm else white
    return std / (sigma0 if np.isfinite(sigma0) and sigma0 > 0 else 1.0) <= CARRIED * known.sigma


def _unknown(leaning: list[tuple[Camera, InteriorResult, dict[str, Relation]]]) -> list[Notice]:
    """One notice of all that photographs do not say of their cameras; internet photographs have a camera each."""
    if not leaning:
        return []
    camera, interior, known = leaning[0]
    each = [_prior(camera, s, r, interior.parameters[s]) for s, r in known.items()]
    others = leaning[1:NAMED_CAMERAS]
    each += [message("held_not_determinable.parameters", camera=c.id, symbols=[*of]) for c, _, of in others]
    ids = dict.fromkeys(i for camera, _, known in leaning for i in (camera.id, *known))
    values: dict[str, Value] = {"cameras": len(leaning), "n": sum(len(of) for _, _, of in leaning)}
    return [Notice(code="held_not_determinable.known_before", values=values, ids=tuple(ids), details=tuple(each))]


def _prior(camera: Camera, symbol: str, known: Relation, found: ParameterResult) -> Message:
    """What was known of a parameter, and what was found."""
    found_px, sigma_px = _px(camera, found.value), _px(camera, found.std or 0.0)
    if known.logarithm:
        return message(
            "held_not_determinable.factor", camera=camera.id, symbol=symbol,
            known_px=_px(camera, float(np.exp(known.observed))), factor=float(np.exp(known.sigma)),
            found_px=found_px, sigma_px=sigma_px,
        )  # fmt: skip
    return message(
        "held_not_determinable.value", camera=camera.id, symbol=symbol, known_px=_px(camera, known.observed),
        known_sigma_px=_px(camera, known.sigma), found_px=found_px, sigma_px=sigma_px,
    )  # fmt: skip


def _contradiction(result: Adjustment, camera: Camera, interior: InteriorResult) -> Notice | None:
    """Where the interior orientation lies beyond what was known, by the sum of squares v'C^-1 v of all that was.

    The residuals v of what was known have the covariance C - C(adjusted), which is less than C where the image
    coordinates are as precise as stated: the sum is chi-square distributed, or smaller, and `LEVEL` is kept over all
    cameras.  Where they are less precise, or a blunder among them bends the camera, it is larger (`_by_noise`).
    """
    found = _found_by_photographs(camera, interior)
    squares = 0.0
    far = list[tuple[float, str]]()
    for g in result.groups:
        for k, (name, component, origin) in enumerate(zip(g.ids, g.component, g.origin, strict=False)):
            if name == _key(interior) and origin == "known before" and component not in found:
                square = float((g.residual[k] / g.sigma[k]) ** 2)
                squares += square
                far.append((square, component))
    if not far:
        return None
    limit = _by_noise(result) * float(chdtri(len(far), LEVEL / len(result.interior)))
    if not squares > limit:
        return None
    known = {r.name: (s, r) for s, r in known_before(camera).items()}
    parts = list[Message]()
    for _, name in sorted(far, reverse=True):
        symbol, relation = known[name]
        at = _px(camera, interior.parameters[symbol].value)
        if relation.logarithm:
            known_px, factor = _px(camera, float(np.exp(relation.observed))), float(np.exp(relation.sigma))
            parts.append(
                message("camera_contradicts.factor", symbol=symbol, found_px=at, known_px=known_px, factor=factor)
            )
        else:
            known_px, sigma = _px(camera, relation.observed), _px(camera, relation.sigma)
            parts.append(
                message("camera_contradicts.value", symbol=symbol, found_px=at, known_px=known_px, known_sigma_px=sigma)
            )
    values: dict[str, Value] = {
        "camera": camera.id,
        "squares": squares,
        "n": len(far),
        "limit": limit,
        "level_percent": 100 * LEVEL,
    }
    return Notice(code="camera_contradicts", values=values, ids=(camera.id,), details=tuple(parts))


def _found_by_photographs(camera: Camera, interior: InteriorResult) -> set[str]:
    """Names of what was only guessed and that photographs have found: a long lens without metadata is no contradiction.

    The normal distribution of the guess is for the start: lenses have longer tails.
    """
    names = set[str]()
    for symbol, relation in known_before(camera).items():
        p = interior.parameters.get(symbol)
        if p is None or p.std is None or not relation.logarithm or relation.sigma < OPEN:
            continue
        share = abs(p.value) / float(max(camera.size_mm))
        if LENSES[0] < share < LENSES[1] and p.std < FOUND * abs(p.value):
            names.add(relation.name)
    return names


def _by_noise(result: Adjustment) -> float:
    """Largest factor by which noise of sigma0 > 1 enlarges the variance of a residual of what was known; 1 or more.

    Known with the variance c beside image observations that show it with a stated one and truly with s^2 a, its
    residual has the variance c^2 (c + s^2 a) / (c + a)^2: over a that is c at most where s^2 <= 2, else c s^4 /
    (4 (s^2 - 1)), at a = c (s^2 - 2) / s^2.
    """
    s2 = result.sigma0**2
    return float(s2**2 / (4 * (s2 - 1))) if s2 > 2.0 else 1.0


def _key(interior: InteriorResult) -> str:
    return interior.camera if interior.image is None else f"{interior.camera}/{interior.image}"


def _px(camera: Camera, value: float) -> float:
    return value / camera.pixel_mm[0]
