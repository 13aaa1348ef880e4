"""What keeps points from fitting, in words: for nominal coordinates, axes, control and epochs alike."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

import numpy as np

from raybundle.adjustment.result import Notice
from raybundle.adjustment.severity import POOR_FIT, Severity
from raybundle.metrology.best_fit import BestFit
from raybundle.metrology.misfit import Misfit
from raybundle.numerics.counting import counted, significant, some_of

MM = 1000.0
FEW = 5
"""Points that are named with their figures"""
NEAR_UNIT = 0.01
"""Difference from a ratio of units, as a share, within which a factor is taken for it: bars and parts are better"""
UNITS = {
    1000.0: ("millimetres", "metres"), 100.0: ("centimetres", "metres"), 10.0: ("millimetres", "centimetres"),
    25.4: ("millimetres", "inches"), 2.54: ("centimetres", "inches"), 1 / 0.0254: ("inches", "metres"),
    12.0: ("inches", "feet"), 1 / 0.3048: ("feet", "metres"),
}  # fmt: skip
"""Ratios of lengths, and in which units they are when these are taken for those"""


def unit_of(factor: float) -> str:
    """Which exchange of units a factor of lengths looks like, in words; "" for none."""
    for ratio, (small, large) in UNITS.items():
        if abs(factor / ratio - 1) < NEAR_UNIT:
            return f"{small} for {large}"
        if abs(factor * ratio - 1) < NEAR_UNIT:
            return f"{large} for {small}"
    return ""


def scale_words(factor: float, sigma: float) -> str:
    """A factor near 1 by its difference in ppm, else by itself."""
    if abs(factor - 1) < NEAR_UNIT:
        return f"{1e6 * (factor - 1):+.4g} ± {1e6 * sigma:.2g} ppm"
    return f"a factor of {factor:.6g} ± {significant(sigma, 2)}"


def mirrored_words(found: Misfit, what: str) -> str:
    """That points are those of a mirror image."""
    return (
        f"{what} are those of a mirror image: mirrored they fit to {significant(MM * found.rms, 2)} mm rms, as they "
        "are no rotation brings them there. Two axes are exchanged, or one counts the other way"
    )


def scattered_words(found: Misfit, what: str) -> str:
    """That nothing fits."""
    return (
        f"{what} fit in no axes: {int(found.fits.sum())} of {len(found.fits)} agree with each other, to "
        f"{significant(MM * found.rms, 2)} mm rms. Are the names those of another object, or exchanged?"
    )


def factor_words(found: Misfit, what: str) -> str:
    """That another scale fits far better, and which unit that may be; whole sentences."""
    unit = unit_of(found.factor)
    may = f"That is {unit}." if unit else "Is a scale bar wrong, or another than was given, or the unit?"
    return (
        f"{what} differ in scale by {scale_words(found.factor, found.factor_sigma)}: with that they fit to "
        f"{significant(MM * found.rms, 2)} mm rms, without to {significant(MM * found.rms_kept, 2)} mm. {may}"
    )


def wrong_words(found: Misfit, names: Sequence[str]) -> str:
    """Which points do not agree with the others, by how much, and which names look exchanged."""
    each = [f"{names[k]} by {significant(MM * float(found.distance[k]), 3)} mm" for k in found.wrong[:FEW]]
    some = ", ".join([*each, *["..."] * (len(found.wrong) > FEW)])
    told = f"{some} (the others agree to {significant(MM * found.rms, 2)} mm rms)"
    if found.exchanged:
        pairs = some_of([f"{names[a]} and {names[b]}" for a, b in found.exchanged], FEW)
        told += f". With the names exchanged they fit: {pairs}"
    if found.instead:
        told += f". Left out instead, explains it as well: {some_of([names[k] for k in found.instead])}"
    return told


def nominal_contradicted(fit: BestFit) -> tuple[Notice, ...]:
    """What keeps measured points from fitting onto nominal ones: a fault for each, the gravest first."""
    m, n = fit.misfit, fit.asked
    if m.scattered:
        return (
            Notice(
                code="nominal_names",
                message=scattered_words(m, "measured and nominal points"),
                measured=Severity.FAULT,
            ),
        )
    told: list[Notice] = []
    if m.mirrored:
        words = f"{mirrored_words(m, 'nominal coordinates')}: mend the file"
        told.append(Notice(code="nominal_mirrored", message=words, measured=Severity.FAULT))
    if m.scaled:
        grave = Severity.FAULT if m.rms_kept > POOR_FIT * m.rms else Severity.CAUTION
        words = factor_words(m, "nominal and measured points")
        told.append(Notice(code="nominal_scale", message=words, measured=grave))
    if m.wrong and not m.mirrored:
        out = any(not f and i in set(n) for i, f in zip(fit.ids, fit.fitted.tolist(), strict=True))
        part = "without it" if out else "with it all the same, as it is named"
        if len(m.wrong) > 1:
            part = "without them" if out else "with them all the same, as they are named"
        message = (
            f"nominal points against the others, where these have them: {wrong_words(m, n)}. The axes are fitted {part}"
        )
        ids = tuple(n[k] for k in m.wrong[:100])
        told.append(Notice(code="nominal_wrong", message=message, ids=ids))
    return tuple(told)


def axes_notices(fit: BestFit, file: str, largest: float) -> tuple[Notice, ...]:
    """How well the axes of a file fit, and which of its points do not agree with the others.

    largest  length of the largest displacement [m]
    """
    turn = float(np.sqrt(max(np.linalg.eigvalsh(fit.turn)[-1], 0.0)))
    rms, across = significant(MM * fit.rms, 2), significant(MM * turn * largest, 2)
    message = (
        f"the axes of {file} fit by {counted(int(fit.fitted.sum()), 'point')} to {rms} mm rms; "
        f"their turn is known to {significant(1e3 * turn, 2)} mrad: {across} mm across the largest displacement, "
        "contained in standard deviations"
    )
    told = [Notice(code="axes_fitted", message=message, measured=Severity.REMARK)]
    more = [replace(n, measured=Severity.CAUTION) for n in nominal_contradicted(fit)]
    return (*more, *told)


def control_contradicted(found: Misfit, file: str, names: Sequence[str]) -> tuple[Notice, ...]:
    """A fault where control contradicts the network as a whole, so that none of it takes part."""
    ids = tuple(names[:100])
    if found.scattered:
        words = scattered_words(found, f"the points of {file} and the measured ones")
        return (
            Notice(code="control_contradicts", message=f"{words} No control takes part: the axes are others", ids=ids),
        )
    if found.mirrored:
        words = mirrored_words(found, f"the coordinates of {file}")
        return (Notice(code="control_mirrored", message=f"{words}. No control takes part: mend the file", ids=ids),)
    if found.scaled:
        words = factor_words(found, f"the points of {file} and the scale bars")
        return (
            Notice(
                code="control_contradicts",
                message=f"{words} No control takes part: the scale is that of the bars",
                ids=ids,
            ),
        )
    return ()


def control_wrong(found: Misfit, file: str, names: Sequence[str]) -> tuple[Notice, ...]:
    """Of single control points that contradict the others."""
    if not found.wrong:
        return ()
    ids = tuple(names[k] for k in found.wrong)
    which = wrong_words(found, names)
    if found.instead:
        message = f"{file}: control against the others: {which}. All of it takes part: more points would tell which"
        return (Notice(code="control_contradicts", message=message, ids=ids),)
    rest = "It takes no part, and is compared" if len(ids) == 1 else "They take no part, and are compared"
    message = f"{file}: control against the others, where these have it: {which}. {rest}: check coordinates and names"
    return (Notice(code="control_left_out", message=message, ids=ids),)
