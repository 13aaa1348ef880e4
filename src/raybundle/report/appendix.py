"""What is printed of the appendix of a report."""

from __future__ import annotations

from typing import Literal

Appendix = Literal["none", "short", "all"]
"""Nothing; all, but of many object points a sample; all with every object point"""
