"""Arrays that carry their partial derivatives: a function of NumPy that is given them returns those of its result.

Forward differentiation by dual numbers (Griewank and Walther, Evaluating Derivatives, SIAM 2008, chapter 3): each
elementary operation states its own derivative, and the chain rule does the rest to the last digit.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping
from typing import Any

import numpy as np

from raybundle.numerics.arrays import Array

_SLOPES: Mapping[Any, Callable[..., Any]] = {
    np.negative: lambda _: (-1.0,),
    np.positive: lambda _: (1.0,),
    np.absolute: lambda x: (np.sign(x),),
    np.sqrt: lambda x: (0.5 / np.sqrt(x),),
    np.square: lambda x: (2 * x,),
    np.reciprocal: lambda x: (-1 / x**2,),
    np.exp: lambda x: (np.exp(x),),
    np.log: lambda x: (1 / x,),
    np.sin: lambda x: (np.cos(x),),
    np.cos: lambda x: (-np.sin(x),),
    np.tan: lambda x: (1 / np.cos(x) ** 2,),
    np.arcsin: lambda x: (1 / np.sqrt(1 - x**2),),
    np.arccos: lambda x: (-1 / np.sqrt(1 - x**2),),
    np.arctan: lambda x: (1 / (1 + x**2),),
    np.add: lambda *_: (1.0, 1.0),
    np.subtract: lambda *_: (1.0, -1.0),
    np.multiply: lambda a, b: (b, a),
    np.divide: lambda a, b: (1 / b, -a / b**2),
    np.power: lambda a, b: (b * a ** (b - 1), a**b * np.log(np.where(np.greater(a, 0), a, 1.0))),
    np.remainder: lambda a, b: (1.0, -np.floor(a / b)),
    np.arctan2: lambda a, b: (b / (a**2 + b**2), -a / (a**2 + b**2)),
    np.hypot: lambda a, b: (a / np.hypot(a, b), b / np.hypot(a, b)),
    np.maximum: lambda a, b: (np.greater_equal(a, b), np.less(a, b)),
    np.minimum: lambda a, b: (np.less_equal(a, b), np.greater(a, b)),
}
"""Derivatives of functions of numbers by each of their arguments."""
_FLAT = frozenset({
    np.greater, np.greater_equal, np.less, np.less_equal, np.equal, np.not_equal, np.isfinite, np.isnan, np.sign,
    np.floor, np.ceil, np.rint,
})  # fmt: skip
"""Functions that do not change with their arguments: their values are plain."""


class Dual(np.lib.mixins.NDArrayOperatorsMixin):
    """An array (...) with its partial derivatives, (..., w) by each group of w unknowns."""

    __slots__ = ("by", "value")

    def __init__(self, value: Any, by: Mapping[int, Array]) -> None:
        """Of the values, and the derivatives by the number of the group."""
        self.value = np.asarray(value, float)
        self.by = dict(by)

    @property
    def shape(self) -> tuple[int, ...]:
        """Of the values."""
        return self.value.shape

    @property
    def ndim(self) -> int:
        """Of the values."""
        return self.value.ndim

    def __len__(self) -> int:
        return len(self.value)

    def __repr__(self) -> str:
        return f"Dual({self.value!r})"

    def __getitem__(self, key: Any) -> Dual:
        """Part of the array; an ellipsis counts the axes of the values."""
        keys = key if isinstance(key, tuple) else (key,)
        with_last = (*keys, slice(None)) if any(k is Ellipsis for k in keys) else keys
        return Dual(self.value[key], {n: d[with_last] for n, d in self.by.items()})

    def sum(self, axis: int | None = None) -> Dual:
        """Over one axis, or all."""
        if axis is not None and not -self.ndim <= axis < self.ndim:
            raise TypeError(f"axis {axis} of an array of {self.ndim} axes")
        axes = tuple(range(self.ndim)) if axis is None else axis % self.ndim
        return Dual(self.value.sum(axis=axes), {n: d.sum(axis=axes) for n, d in self.by.items()})

    def __array_ufunc__(self, function: Any, method: str, *given: Any, **how: Any) -> Any:
        """The function of the values, and the chain rule."""
        plain = [g.value if isinstance(g, Dual) else g for g in given]
        if method != "__call__" or how:
            return NotImplemented
        if function in _FLAT:
            return function(*plain)
        if function not in _SLOPES:
            raise TypeError(f"numpy.{function.__name__} has no derivative here; use {_listed(_SLOPES)}")
        return _chained(function(*plain), zip(given, _SLOPES[function](*plain), strict=True))

    def __array_function__(self, function: Any, _: Any, given: Any, how: Any) -> Any:
        """The same for functions of whole arrays."""
        if function not in _WHOLE:
            raise TypeError(f"numpy.{function.__name__} has no derivative here; use {_listed(_WHOLE)}")
        return _WHOLE[function](*given, **how)


def _listed(functions: Iterable[Any]) -> str:
    return ", ".join(sorted(f.__name__ for f in functions))


def _chained(value: Array, terms: Iterable[tuple[Any, Any]]) -> Dual:
    """The sum of slopes times the derivatives of the arguments."""
    by = dict[int, Array]()
    shape = np.shape(value)
    for one, slope in terms:
        if isinstance(one, Dual):
            for n, d in one.by.items():
                lifted = d.reshape((*(1,) * (len(shape) - one.ndim), *d.shape))
                term = np.asarray(slope, float)[..., None] * lifted
                whole = (*shape, d.shape[-1])
                term = term if term.shape == whole else np.broadcast_to(term, whole)
                by[n] = by[n] + term if n in by else term
    return Dual(value, by)


def _norm(x: Dual, *, axis: int) -> Dual:
    return np.sqrt((x * x).sum(axis=axis))


def _stack(parts: Iterable[Any], *, axis: int = 0) -> Dual:
    parts = list(parts)
    value = np.stack([p.value if isinstance(p, Dual) else np.asarray(p, float) for p in parts], axis=axis)
    at, by = axis % value.ndim, dict[int, Array]()
    for k, part in enumerate(parts):
        for n, d in part.by.items() if isinstance(part, Dual) else ():
            room = by.setdefault(n, np.zeros((*value.shape, d.shape[-1])))
            room[(*(slice(None),) * at, k)] = d
    return Dual(value, by)


def _where(condition: Array, yes: Any, no: Any) -> Dual:
    condition = np.asarray(condition, bool)
    which = condition.astype(float)
    plain = [x.value if isinstance(x, Dual) else x for x in (yes, no)]
    return _chained(np.where(condition, *plain), [(yes, which), (no, 1 - which)])


def _einsum(how: str, *given: Any) -> Dual:
    """Linear in each argument; the letter Z is kept for the unknowns."""
    terms, arrow, out = how.replace(" ", "").partition("->")
    letters = terms.split(",")
    if not arrow:  # as NumPy: letters that stand once, in order
        out = "".join(sorted(k for k in set(terms) - {","} if terms.count(k) == 1))
    if "Z" in how or "." in how:
        raise TypeError("numpy.einsum: give letters other than Z, and no ellipsis")
    plain = [g.value if isinstance(g, Dual) else np.asarray(g, float) for g in given]
    by = dict[int, Array]()
    for k, one in enumerate(given):
        for n, d in one.by.items() if isinstance(one, Dual) else ():
            mine = ",".join(f"{w}Z" if j == k else w for j, w in enumerate(letters))
            term = np.einsum(f"{mine}->{out}Z", *[d if j == k else p for j, p in enumerate(plain)])
            by[n] = by[n] + term if n in by else term
    return Dual(np.einsum(how, *plain), by)


def _cross(a: Any, b: Any) -> Dual:
    turn = np.zeros((3, 3, 3))
    turn[[0, 1, 2], [1, 2, 0], [2, 0, 1]], turn[[0, 1, 2], [2, 0, 1], [1, 2, 0]] = 1.0, -1.0
    return _einsum("xij,ki,kj->kx", turn, a, b)


_WHOLE: Mapping[Any, Callable[..., Dual]] = {
    np.sum: lambda x, axis=None: x.sum(axis),
    np.linalg.norm: _norm,
    np.stack: _stack,
    np.where: _where,
    np.einsum: _einsum,
    np.cross: _cross,
}
"""Functions of whole arrays: sum and norm over an axis, stack, where, einsum, and cross of rows (k, 3)."""
