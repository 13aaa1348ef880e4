"""What actions of measuring are checked for: names, numbers, points that are there, places within a format."""

from __future__ import annotations

import math
from typing import Literal

from raybundle.errors import InputError
from raybundle.io.reading.words import quoted
from raybundle.measuring.names import Known
from raybundle.measuring.state import Mark, Numbers3, RoleName, State

LONGEST = 200
"""Characters of a name."""
SMALLEST, LARGEST = 1e-12, 1e12
"""Size of a number other than 0, as on the command line."""
FARTHEST = 1e11
"""Size of a coordinate: more than the Earth's radius in millimetres; of double precision 15 um are left there."""
WIDEST_PX = 1e5
"""Standard deviation of a mark: no format is wider."""


def check_name(kind: Literal["point", "line", "mask", "table", "drawing", "layer", "note"], name: str) -> None:
    """Raise InputError for a text that cannot be a name."""
    if not name or name != name.strip() or not name.isprintable() or len(name) > LONGEST:
        raise InputError("mark.bad_name", kind=kind, name=quoted(name), n=len(name), most=LONGEST)


def check_number(
    entry: str, value: float, *, least: float | None = None, above: float | None = None, most: float = LARGEST
) -> None:
    """Raise InputError for what is no finite number within its limits."""
    if not math.isfinite(value):
        raise InputError("number.not_finite", entry=entry, value=value)
    if above is not None and not value > above:
        raise InputError("number.too_small", entry=entry, value=value, limit=above)
    if least is not None and not value >= least:
        raise InputError("number.below", entry=entry, value=value, limit=least)
    if abs(value) > most:
        raise InputError("number.too_large", entry=entry, value=value, limit=most)
    if 0 < abs(value) < SMALLEST and above is not None:
        raise InputError("number.below", entry=entry, value=value, limit=SMALLEST)


def check_given(point: str, role: RoleName, xyz: Numbers3, sigma: Numbers3) -> None:
    """Raise InputError for a name, role, coordinates and standard deviations that do not go together."""
    check_name("point", point)
    for axis, value, s in zip("XYZ", xyz, sigma, strict=True):
        if value is not None:
            check_number(f"{point}, {axis}", value, most=FARTHEST)
        if s is not None:
            check_number(f"{point}, s{axis}", s, least=0.0)
            if value is None:
                raise InputError("mark.sigma_without_coordinate", point=point, axis=axis)
    given = [k for k in range(3) if xyz[k] is not None]
    if role != "tie" and not given:
        raise InputError("mark.role_without_coordinate", point=point, role=role)
    lacking = [k for k in given if sigma[k] is None]
    if role == "control" and lacking:
        raise InputError("mark.control_without_sigma", point=point, axis="XYZ"[lacking[0]])


def check_point(name: str, state: State, known: Known) -> None:
    """Raise InputError for a point that is neither measured nor in the block."""
    if not exists(name, state, known):
        raise InputError("mark.unknown_point", point=name, known=list(state.points), n=len(state.points))


def name_in_block(name: str, state: State, known: Known) -> str:
    """What the block calls a point; empty where it does not hold it."""
    for old, new in state.renamed.items():
        if new == name:
            return old
    return name if name in known.points and name not in state.renamed else ""


def exists(name: str, state: State, known: Known) -> bool:
    """Whether a point is measured or in the block."""
    return name in state.points or bool(name_in_block(name, state, known))


def marked(image: str, point: str, state: State, known: Known) -> str:
    """The image of a mark; raises InputError where there is none."""
    found = known.image(image)
    if (found, point) not in state.marks:
        check_point(point, state, known)
        raise InputError(
            "mark.not_marked",
            point=point,
            image=found,
            images_marked=list(state.marks_of(point)),
            n=len(state.marks_of(point)),
        )
    return found


def check_mark(known: Known, image: str, mark: Mark) -> None:
    """Raise InputError for a mark outside its image, or whose numbers are none."""
    check_number(f"{image}, x_px", mark.x_px)
    check_number(f"{image}, y_px", mark.y_px)
    known.inside(image, mark.x_px, mark.y_px)
    xx, yy, xy = mark.covariance
    for name, value in (("xx", xx), ("yy", yy)):
        check_number(f"{image}, {name} [px^2]", value, above=0.0, most=WIDEST_PX**2)
    check_number(f"{image}, xy [px^2]", xy)
    if not xy * xy < xx * yy:
        raise InputError("mark.covariance", image=image, xy_px2=xy, xx_px2=xx, yy_px2=yy)
    if mark.clicked is not None:
        for axis, value in zip("xy", mark.clicked, strict=True):
            check_number(f"{image}, clicked.{axis}", value)
    if mark.quality is not None:
        check_number(f"{image}, quality", mark.quality, least=0.0, most=1.0)
