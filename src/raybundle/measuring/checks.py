"""What actions of measuring are checked for: names, numbers, points that are there, places within a format."""

from __future__ import annotations

import math
from collections.abc import Iterable

from raybundle.errors import InputError
from raybundle.io.reading.words import quoted
from raybundle.measuring.known import Known
from raybundle.measuring.state import Mark, Numbers3, RoleName, State

LONGEST = 200
"""Characters of a name."""
SMALLEST, LARGEST = 1e-12, 1e12
"""Size of a number other than 0, as on the command line."""
FARTHEST = 1e11
"""Size of a coordinate: more than the Earth's radius in millimetres; of double precision 15 um are left there."""
WIDEST_PX = 1e5
"""Standard deviation of a mark: no format is wider."""


def check_name(what: str, name: str) -> None:
    """Raise InputError for a text that cannot be the name of a point or line."""
    if not name or name != name.strip() or not name.isprintable() or len(name) > LONGEST:
        raise InputError(
            f"{what} {quoted(name)}: a name has 1 to {LONGEST} printable characters and no blank at its ends "
            f"({len(name)} here); choose another"
        )


def check_number(
    what: str, value: float, *, least: float | None = None, above: float | None = None, most: float = LARGEST
) -> None:
    """Raise InputError for what is no finite number within its limits."""
    if not math.isfinite(value):
        raise InputError(f"{what} is {value}, no finite number; give a number")
    if above is not None and not value > above:
        raise InputError(f"{what} is {value:g}; it must be above {above:g}")
    if least is not None and not value >= least:
        raise InputError(f"{what} is {value:g}; it must be at least {least:g}")
    if abs(value) > most:
        raise InputError(f"{what} is {value:g}; it must be at most {most:g} in size")
    if 0 < abs(value) < SMALLEST and above is not None:
        raise InputError(f"{what} is {value:g}; it must be at least {SMALLEST:g}")


def check_given(point: str, role: RoleName, xyz: Numbers3, sigma: Numbers3) -> None:
    """Raise InputError for a name, role, coordinates and standard deviations that do not go together."""
    check_name("point", point)
    who = f"point {quoted(point)}"
    for axis, value, s in zip("XYZ", xyz, sigma, strict=True):
        if value is not None:
            check_number(f"{who}, {axis}", value, most=FARTHEST)
        if s is not None:
            check_number(f"{who}, sigma of {axis}", s, least=0.0)
            if value is None:
                raise InputError(f"{who} has a sigma of {axis} but no {axis}; give the coordinate too")
    given = [k for k in range(3) if xyz[k] is not None]
    if role != "tie" and not given:
        raise InputError(f"{who} is {role} without a coordinate; give at least one, or make it a tie point")
    lacking = [k for k in given if sigma[k] is None]
    if role == "control" and lacking:
        raise InputError(
            f"{who}: {'XYZ'[lacking[0]]} is control without a standard deviation; give its sigma, 0 to hold it"
        )


def check_point(name: str, state: State, known: Known) -> None:
    """Raise InputError for a point that is neither measured nor in the block."""
    if not exists(name, state, known):
        measured = ", ".join(map(quoted, _some(state.points))) or "none"
        raise InputError(
            f"point {quoted(name)} is neither measured nor in the block; measured are: {measured}. Mark it in an image "
            "first, or look at the spelling"
        )


def name_in_block(name: str, state: State, known: Known) -> str:
    """What the block calls a point; empty where it does not hold it."""
    for old, new in state.renamed.items():
        if new == name:
            return old
    return name if name in known.points and name not in state.renamed else ""


def exists(name: str, state: State, known: Known) -> bool:
    """Whether a point is measured or in the block."""
    return name in state.points or bool(name_in_block(name, state, known))


def _some(names: Iterable[str], most: int = 5) -> list[str]:
    return [name for name, _ in zip(names, range(most), strict=False)]


def marked(image: str, point: str, state: State, known: Known) -> str:
    """The image of a mark; raises InputError where there is none."""
    found = known.image(image)
    if (found, point) not in state.marks:
        check_point(point, state, known)
        places = ", ".join(map(quoted, _some(state.marks_of(point)))) or "none"
        raise InputError(f"point {quoted(point)} is not marked by hand in image {quoted(found)}; it is in: {places}")
    return found


def check_mark(known: Known, image: str, mark: Mark) -> None:
    """Raise InputError for a mark outside its image, or whose numbers are none."""
    who = f"image {quoted(image)}"
    check_number(f"{who}, x_px", mark.x_px)
    check_number(f"{who}, y_px", mark.y_px)
    known.inside(image, mark.x_px, mark.y_px)
    xx, yy, xy = mark.covariance
    for name, value in (("variance of x", xx), ("variance of y", yy)):
        check_number(f"{who}, {name} [px^2]", value, above=0.0, most=WIDEST_PX**2)
    check_number(f"{who}, covariance of x and y [px^2]", xy)
    if not xy * xy < xx * yy:
        raise InputError(
            f"{who}: a covariance of {xy:g} px^2 of x and y does not go with variances of {xx:g} and {yy:g}; its size "
            "must be below the root of their product"
        )
    if mark.clicked is not None:
        for axis, value in zip("xy", mark.clicked, strict=True):
            check_number(f"{who}, clicked {axis}", value)
    if mark.quality is not None:
        check_number(f"{who}, quality", mark.quality, least=0.0, most=1.0)
