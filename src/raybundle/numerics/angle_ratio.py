"""atan2(r, w) / r and its derivative as functions of SymPy, smooth at r = 0."""

from __future__ import annotations

from typing import Any, cast

import sympy as sp


class AngleRatio(sp.Function):
    """atan2(r, w) / r as a function of r**2 and w, smooth at r = 0."""

    def fdiff(self, argindex: int = 1) -> Any:
        """Partial derivatives, closed in these two functions."""
        r2, w = cast("tuple[Any, Any]", self.args)
        return AngleRatioSlope(r2, w) if argindex == 1 else -1 / (r2 + w * w)


class AngleRatioSlope(sp.Function):
    """Derivative of `AngleRatio` by r**2."""
