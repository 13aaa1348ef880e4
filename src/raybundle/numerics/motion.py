"""Small motions of a sensor while an image is taken, for conditions: NumPy arrays and SymPy expressions alike."""

from __future__ import annotations

from raybundle.numerics.maths import Scalar, cos, sin

Point = tuple[Scalar, Scalar, Scalar]


def turned_axes(point: Point, turn: Point) -> Point:
    """A point in axes that were turned by a small rotation vector: Cayley's form, exp(-[turn]x) to third order.

    (1 - [a]x + (a a' + [a]x^2 ...)) written out: R = ((1 - a.a) I + 2 a a' - 2 [a]x) / (1 + a.a),  a = turn / 2
    """
    (X, Y, Z), (a, b, c) = point, (t / 2 for t in turn)
    square = a * a + b * b + c * c
    along = 2 * (a * X + b * Y + c * Z)
    own = 1 - square
    whole = 1 + square
    return (
        (own * X + a * along - 2 * (b * Z - c * Y)) / whole,
        (own * Y + b * along - 2 * (c * X - a * Z)) / whole,
        (own * Z + c * along - 2 * (a * Y - b * X)) / whole,
    )


def mounted_axes(point: Point, angles: Point) -> Point:
    """A point in the axes of a camera that is mounted with omega, phi, kappa: R3(kappa) R2(phi) R1(omega) point."""
    (X, Y, Z), (omega, phi, kappa) = point, angles
    so, co, sp, cp, sk, ck = sin(omega), cos(omega), sin(phi), cos(phi), sin(kappa), cos(kappa)
    y, z = co * Y + so * Z, co * Z - so * Y
    x, z = cp * X - sp * z, sp * X + cp * z
    return ck * x + sk * y, ck * y - sk * x, z
