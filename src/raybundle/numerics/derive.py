"""Turn one condition equation into residuals and Jacobians: NumPy functions, NumPy source, C++ source.

Needs SymPy (extra `raybundle[models]`); imported only for a user's own model and by the generator.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import Any, cast

import numpy as np

from raybundle.errors import InputError
from raybundle.numerics.arrays import Array
from raybundle.numerics.maths import AngleRatio_numpy, AngleRatioSlope_numpy, Scalar

try:
    import sympy as sp
    from sympy.printing.cxx import CXX17CodePrinter
    from sympy.printing.numpy import NumPyPrinter
except ModuleNotFoundError as error:
    raise InputError("package.sympy_missing") from error

POINT = ("x", "y", "X", "Y", "Z")


@dataclass(frozen=True, slots=True)
class Derived:
    """Residuals and partial derivatives of a condition with shared subexpressions."""

    names: tuple[str, ...]
    shared: Sequence[tuple[Any, Any]]
    outputs: Sequence[Any]
    """g1, g2, then d g1 / d each name, then d g2 / d each name; of a platform three of each."""
    rows: int = 2


def differentiate(condition: Callable[..., tuple[Scalar, ...]], symbols: Sequence[str]) -> Derived:
    """Values and Jacobian of a condition, or of the point of a platform, as expressions."""
    names = (*POINT, *symbols)
    variables = sp.symbols(names)
    residuals = condition(*variables)
    jacobian = [sp.diff(g, v) for g in residuals for v in variables]
    found: Any = sp.cse([*residuals, *jacobian], sp.numbered_symbols("t"), order="none")
    shared, outputs = found
    return Derived(names, shared, outputs, len(residuals))


def derive(
    condition: Callable[..., tuple[Scalar, Scalar]], symbols: Sequence[str]
) -> Callable[..., tuple[Array, Array]]:
    """The condition's g (2, n) and Jacobian (2, 5 + k, n) as one vectorised function."""
    namespace: dict[str, Any] = {}
    exec(numpy_source(differentiate(condition, symbols)), _numpy_names(), namespace)  # noqa: S102  (own text)
    return namespace["condition_and_jacobian"]


def derive_point(
    point: Callable[..., tuple[Scalar, Scalar, Scalar]], symbols: Sequence[str]
) -> Callable[..., tuple[Array, Array]]:
    """The point (3, n) of a platform and its Jacobian (3, 5 + m, n) as one vectorised function."""
    namespace: dict[str, Any] = {}
    exec(numpy_source(differentiate(point, symbols), "point_and_jacobian"), _numpy_names(), namespace)  # noqa: S102
    return namespace["point_and_jacobian"]


def _numpy_names() -> dict[str, Any]:
    return {"np": np, "numpy": np, "AngleRatio_numpy": AngleRatio_numpy, "AngleRatioSlope_numpy": AngleRatioSlope_numpy}


class _Powers:
    """Integer powers as products."""

    def _print_Pow(self, expr: Any, rational: bool = False) -> str:  # noqa: FBT001, FBT002  (SymPy's signature)
        base, exponent = expr.as_base_exp()
        if exponent.is_Integer and 1 < abs(int(exponent)) <= 8:
            text = f"({self.doprint(base)})"  # type: ignore[attr-defined]
            product = "*".join([text] * abs(int(exponent)))
            return f"({product})" if exponent > 0 else f"(1.0/({product}))"
        if exponent == -1:
            return f"(1.0/({self.doprint(base)}))"  # type: ignore[attr-defined]
        # printers of C take no second argument
        return super()._print_Pow(expr, rational) if rational else super()._print_Pow(expr)  # type: ignore[misc]


class _NumPy(_Powers, NumPyPrinter):  # pyright: ignore[reportIncompatibleMethodOverride]
    def _print_Function(self, expr: Any) -> str:
        name = type(expr).__name__
        if name in {"AngleRatio", "AngleRatioSlope"}:
            return f"{name}_numpy({', '.join(self._print(a) for a in expr.args)})"
        return super()._print_Function(expr)


class _Cxx(_Powers, CXX17CodePrinter):  # pyright: ignore[reportIncompatibleMethodOverride]
    pass


def numpy_source(derived: Derived, function: str = "condition_and_jacobian") -> str:
    """Python text of `condition_and_jacobian(x, y, X, Y, Z, *parameters)`."""
    show: Callable[[Any], str] = cast("Any", _NumPy({"fully_qualified_modules": False}).doprint)
    k, rows = len(derived.names), derived.rows
    lines = [f"def {function}({', '.join(derived.names)}):"]
    lines += [f"    {name} = {_np(show(e))}" for name, e in derived.shared]
    lines.append(f"    shape = np.broadcast_shapes({', '.join(f'np.shape({n})' for n in derived.names)})")
    lines += [f"    g = np.empty(({rows}, *shape))", f"    J = np.zeros(({rows}, {k}, *shape))"]
    lines += [f"    g[{i}] = {_np(show(e))}" for i, e in enumerate(derived.outputs[:rows])]
    for i, e in enumerate(derived.outputs[rows:]):
        if e != 0:
            lines.append(f"    J[{i // k}, {i % k}] = {_np(show(e))}")
    lines.append("    return g, J")
    return "\n".join(lines) + "\n"


def _np(text: str) -> str:
    for name in ("sin", "cos", "sqrt", "tan", "exp", "log"):
        text = text.replace(f"numpy.{name}(", f"np.{name}(")
        text = text.replace(f" {name}(", f" np.{name}(") if not text.startswith(f"{name}(") else f"np.{text}"
        text = text.replace(f"*{name}(", f"*np.{name}(").replace(f"({name}(", f"(np.{name}(")
        text = text.replace(f"-{name}(", f"-np.{name}(")
    return text


def cxx_source(name: str, derived: Derived, *, all_round: bool = False) -> str:
    """C++ text of `struct <name>`: all partial derivatives for a chunk of V observations, in lanes.

    all_round  whether points beside the sensor and behind it have an image, too
    """
    show = _Cxx({"user_functions": {"AngleRatio": "angle_ratio", "AngleRatioSlope": "angle_ratio_slope"}}).doprint
    k = len(derived.names)
    outputs = list(enumerate(derived.outputs))
    full = _lanes(derived, show, derived.shared, outputs)
    image = [0, 1, 2, 3, 2 + k, 3 + k]  # g1, g2, dg1/dx, dg1/dy, dg2/dx, dg2/dy
    short = [(to, derived.outputs[i]) for to, i in enumerate(image)]
    reduced = _lanes(derived, show, _needed(derived.shared, [e for _, e in short]), short)
    ends = [0, 1, *range(2, 7), *range(2 + k, 7 + k)]  # the same by x, y, X, Y, Z
    some = [(to, derived.outputs[i]) for to, i in enumerate(ends)]
    by_point = _lanes(derived, show, _needed(derived.shared, [e for _, e in some]), some)
    explicit = [derived.outputs[i] for i in image[2:]] == [1, 0, 0, 1]
    return (
        f"struct {name} {{\n"
        f'  static constexpr const char* label = "{name}";\n'
        f"  static constexpr int parameters = {k - 5};\n"
        f"  static constexpr bool explicit_image = {'true' if explicit else 'false'};\n"
        f"  static constexpr bool all_round = {'true' if all_round else 'false'};\n"
        "  static RB_INLINE void evaluate(const double (*in)[V], const double (*own)[V], double (*out)[V]) {\n"
        f"{full}  }}\n"
        "  static RB_INLINE void by_image(const double (*in)[V], const double (*own)[V], double (*out)[V]) {\n"
        f"{reduced}  }}\n"
        "  static RB_INLINE void by_point(const double (*in)[V], const double (*own)[V], double (*out)[V]) {\n"
        f"{by_point}  }}\n"
        "};\n"
    )


def cxx_platform_source(name: str, derived: Derived, *, uses_image: bool) -> str:
    """C++ text of a platform's `struct`: where a point lies in the axes of the sensor, with partial derivatives."""
    show = _Cxx({}).doprint
    k = len(derived.names)
    point = list(enumerate(derived.outputs[:3]))
    few = _needed(derived.shared, [e for _, e in point])
    by_image = ""
    if uses_image:
        moving = [*point, *((3 + 2 * c + e, derived.outputs[3 + k * c + e]) for c in range(3) for e in range(2))]
        by_image = (
            "  static RB_INLINE void by_image(const double (*in)[V], const double (*own)[V], double (*out)[V]) {\n"
            f"{_lanes(derived, show, _needed(derived.shared, [e for _, e in moving]), moving)}  }}\n"
        )
    used: set[Any] = set().union(*(e.free_symbols for _, e in [*few, *point]))
    alone = [f"    const double {n} = {_argument(i)};\n" for i, n in enumerate(derived.names) if sp.Symbol(n) in used]
    alone += [f"    const double {n} = {show(e)};\n" for n, e in few]
    alone += [f"    out[{i}] = {show(e)};\n" for i, e in point]
    return (
        f"struct {name} {{\n"
        f"  static constexpr int parameters = {k - 5};\n"
        f"  static constexpr bool uses_image = {'true' if uses_image else 'false'};\n"
        "  static RB_INLINE void evaluate(const double (*in)[V], const double (*own)[V], double (*out)[V]) {\n"
        f"{_lanes(derived, show, derived.shared, list(enumerate(derived.outputs)))}  }}\n"
        "  static RB_INLINE void place(const double (*in)[V], const double (*own)[V], double (*out)[V]) {\n"
        f"{_lanes(derived, show, few, point)}  }}\n"
        f"{by_image}"
        "  static RB_INLINE void place_one(const double* in, const double* own, double* out) {\n"
        f"{''.join(alone)}  }}\n"
        "};\n"
    )


def _lanes(derived: Derived, show: Any, shared: Sequence[tuple[Any, Any]], outputs: Sequence[tuple[int, Any]]) -> str:
    used: set[Any] = set().union(*(e.free_symbols for _, e in [*shared, *outputs]))
    lines = ["    RB_SIMD\n    for (int l = 0; l < V; ++l) {\n"]
    lines += [
        f"      const double {n} = {_argument(i)}[l];\n" for i, n in enumerate(derived.names) if sp.Symbol(n) in used
    ]
    lines += [f"      const double {n} = {show(e)};\n" for n, e in shared]
    lines += [f"      out[{i}][l] = {show(e)};\n" for i, e in outputs]
    return "".join([*lines, "    }\n"])


def _argument(position: int) -> str:
    """Image and object point stand in `in`, parameters in `own`: a platform's among those of a combination."""
    k = len(POINT)
    return f"in[{position}]" if position < k else f"own[{position - k}]"


def _needed(shared: Sequence[tuple[Any, Any]], outputs: Sequence[Any]) -> list[tuple[Any, Any]]:
    wanted: set[Any] = set().union(*(e.free_symbols for e in outputs))
    kept: list[tuple[Any, Any]] = []
    for name, e in reversed(shared):
        if name in wanted:
            wanted |= e.free_symbols
            kept.append((name, e))
    return kept[::-1]
