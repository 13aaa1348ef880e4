"""What the notebooks of the gallery share: published numbers beside computed ones, and where large data lie."""

import os
from collections.abc import Sequence
from pathlib import Path

HERE = Path(__file__).resolve().parent


def compare(rows: Sequence[tuple[str, str, float]], *, units: float = 0.5) -> None:
    """Print published, computed and the difference in units of the last published digit; assert that it is rounding.

    rows   what it is, the number as it was published (a text: its digits count), the number computed
    units  how many units of the last published digit a number may be off: 0.5 is rounding alone
    """
    wide = max(len(name) for name, _, _ in rows)
    print(f"{'':{wide}}  {'published':>16}  {'computed':>16}  {'difference':>14}")
    wrong: list[str] = []
    for name, published, computed in rows:
        digits, last = _digits(published)
        apart = computed - float(published)
        told = f"{computed:.{digits + 2}e}" if "e" in published.lower() else f"{computed:.{digits + 2}f}"
        print(f"{name:{wide}}  {published:>16}  {told:>16}  {apart / last:+8.2f} units")
        if not abs(apart) <= units * last * (1 + 1e-6):  # NaN is wrong, too
            wrong.append(name)
    assert not wrong, f"not as published: {', '.join(wrong)}"


def _digits(published: str) -> tuple[int, float]:
    """Digits behind the point, and the unit of the last one."""
    mantissa, _, exponent = published.lower().partition("e")
    digits = len(mantissa.partition(".")[2])
    return digits, 10.0 ** (int(exponent or 0) - digits)


def data(name: str) -> Path | None:
    """A folder of the public data that tests use, or None where it is not here: RAYBUNDLE_DATA, or beside the clone."""
    folder = Path(os.environ.get("RAYBUNDLE_DATA", HERE.parents[1].parent / "shared/data")) / name
    return folder if folder.is_dir() else None
