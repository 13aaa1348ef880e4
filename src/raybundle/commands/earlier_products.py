"""Products that an earlier run of `surface` left in its folder and that this one does not write."""

from __future__ import annotations

import shutil
from collections.abc import Collection, Mapping
from pathlib import Path
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from raybundle.workflows.surface import Surface

TABLE = "written"
"""Of project.toml: of which points each product is"""
MEASURED = "measured"
"""Of project.toml: of which result they are"""
POINTS = "points"
"""Key of the cloud there, whose product has no name"""


def settle_earlier(surface: Surface, out: Path, work: Path, wanted: Collection[str]) -> tuple[str, ...]:
    """Remove products of other points than these; those of the same points stay.  What is to be told of both.

    A file beside points that it was not made of would be taken for one of them.  What is written next is no longer
    noted as written (`note_written`): a run that is killed meanwhile has not written all that it was asked for.
    """
    from raybundle.settings import option  # noqa: PLC0415
    from raybundle.workflows.surface_products import PRODUCTS  # noqa: PLC0415

    before, key = _written(work), _key(surface)
    told = list[str]()
    for name, product in sorted(PRODUCTS.items()):
        there = [out / f for f in product.files if (out / f).exists()]
        if not there or name in wanted:
            continue
        names = ", ".join(p.name for p in there)
        if before.get(name) == key:
            told.append(f"{names}: of an earlier run, of the same points")
            continue
        for path in there:
            shutil.rmtree(path) if path.is_dir() else path.unlink()
        told.append(f"{names}: removed, it was of other points; ask for it with {option(name)}")
    _note(work, {name: k for name, k in before.items() if name not in {w or POINTS for w in wanted}})
    return tuple(told)


def note_written(surface: Surface, work: Path, written: Collection[str], fingerprint: str) -> None:
    """Note of which points products are, and of which result (`results.fingerprint`)."""
    key = _key(surface)
    kept = {name: k for name, k in _written(work).items() if k == key}
    _note(work, kept | {name or POINTS: key for name in written}, fingerprint)


def measured_of(work: Path) -> str:
    """The fingerprint of the result that was measured; empty: it is not known."""
    from raybundle.results.fingerprint import FINGERPRINT  # noqa: PLC0415

    return _table(work, MEASURED).get(FINGERPRINT, "")


def all_written(work: Path) -> bool:
    """Whether all that the last run was asked for stands beside its work, of the same points, as it noted last."""
    from raybundle.errors import InputError  # noqa: PLC0415
    from raybundle.io.reading.trees import read_toml  # noqa: PLC0415
    from raybundle.workflows.surface_products import PRODUCTS  # noqa: PLC0415

    try:
        asked = read_toml(work / "project.toml").tree().get("surface")
    except InputError:
        return False
    wanted = [n for n in PRODUCTS if not n or (asked.has(n) and asked.get(n).value is not False)]
    noted = _written(work)
    there = all(any((work.parent / f).exists() for f in PRODUCTS[n].files) for n in wanted)
    return there and len({noted.get(n or POINTS, f"no {n}") for n in wanted}) == 1 and POINTS in noted


def _note(work: Path, known: Mapping[str, str], fingerprint: str = "") -> None:
    """Write down the key of the points of each product, and of which result they are where that is given."""
    from raybundle.pipeline.project import Project  # noqa: PLC0415
    from raybundle.pipeline.settings_file import with_table  # noqa: PLC0415
    from raybundle.results.fingerprint import FINGERPRINT  # noqa: PLC0415

    project = Project.open(work)
    try:
        for table, values in ((TABLE, known), (MEASURED, {FINGERPRINT: fingerprint})):
            if table == TABLE or fingerprint:
                lines = [f"[{table}]", *(f'{name} = "{k}"' for name, k in sorted(values.items()))]
                project.write_settings(with_table(work / "project.toml", table, "\n".join(lines)))
    finally:
        project.close()


def _key(surface: Surface) -> str:
    from raybundle.pipeline.keys import key_of  # noqa: PLC0415

    return key_of("points", surface.clouds)


def _written(work: Path) -> dict[str, str]:
    """Product -> the key of its points, as the last run noted."""
    return _table(work, TABLE)


def _table(work: Path, name: str) -> dict[str, str]:
    """A table of project.toml; empty where it cannot be read."""
    from raybundle.errors import InputError  # noqa: PLC0415
    from raybundle.io.reading.trees import read_toml  # noqa: PLC0415

    path = work / "project.toml"
    try:
        return {k: v.text() for k, v in read_toml(path).tree().get(name).mapping().items()} if path.is_file() else {}
    except InputError:
        return {}
