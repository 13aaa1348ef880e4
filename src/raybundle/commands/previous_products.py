"""Products that an earlier run of `surface` left in its folder and that this one does not write."""

from __future__ import annotations

import shutil
from collections.abc import Collection, Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from raybundle.surfaces.run import Surface

TABLE = "written"
"""Of project.toml: of which points each product is, and by which length they were thinned"""
MEASURED = "measured"
"""Of project.toml: of which result they are"""
POINTS = "points"
"""Key of the cloud there, whose product has no name"""


@dataclass(frozen=True, slots=True, kw_only=True)
class Earlier:
    """What is to be reported of products of earlier runs."""

    reported: tuple[str, ...]
    """a line for each product"""
    others: Mapping[str, float | None]
    """files with more points, or fewer, than this run writes, by which length they are thinned; None: not at all"""


def settle_earlier(
    surface: Surface, out: Path, work: Path, wanted: Collection[str], thin: float | None, pages: Mapping[str, str]
) -> Earlier:  # fmt: skip
    """Remove products of other points than these; those of the same points stay.  What is to be reported of both.

    thin   by which length points are thinned now; None: all are written
    pages  files of all points that are no products, by the setting with which each is asked for

    A file beside points that it was not made of would be taken for one of them.  What is written next is no longer
    noted as written (`note_written`): a run that is killed meanwhile has not written all that it was asked for.
    """
    from raybundle.errors import phrase
    from raybundle.surfaces.products import PRODUCTS

    before, key, now = _written(work), _key(surface), _thinned(thin)
    reported, others = list[str](), dict[str, float | None]()
    files = {name: (p.files, p.of_cloud) for name, p in PRODUCTS.items()} | {n: ((f,), True) for n, f in pages.items()}
    for name, (products, of_cloud) in sorted(files.items()):
        there = [out / f for f in products if (out / f).exists()]
        if not there or name in wanted:
            continue
        names = [p.name for p in there]
        made_of, _, length = before.get(name, "").partition(" ")
        if made_of == key:
            if of_cloud and length != now:
                was = float(length) if length else None
                reported.append(
                    phrase(
                        "surface_remark.otherwise_thinned",
                        names=names,
                        length=was or 0.0,
                        now=thin or 0.0,
                        setting=name,
                    )
                )
                others |= dict.fromkeys(names, was)
            else:
                reported.append(phrase("surface_remark.earlier", names=names))
            continue
        for path in there:
            shutil.rmtree(path) if path.is_dir() else path.unlink()
        reported.append(phrase("surface_remark.removed", names=names, setting=name))
    _note(work, {name: k for name, k in before.items() if name not in {w or POINTS for w in wanted}})
    return Earlier(reported=tuple(reported), others=others)


def note_written(surface: Surface, work: Path, written: Collection[str], thin: float | None, fingerprint: str) -> None:
    """Note of which points products and pages are, and of which result (`results.fingerprint`)."""
    key = _key(surface)
    now = f"{key} {_thinned(thin)}".strip()
    kept = {name: k for name, k in _written(work).items() if k.partition(" ")[0] == key}
    _note(work, kept | {name or POINTS: now for name in written}, fingerprint)


def measured_of(work: Path) -> str:
    """The fingerprint of the result that was measured; empty: it is not known."""
    from raybundle.results.fingerprint import FINGERPRINT

    return _table(work, MEASURED).get(FINGERPRINT, "")


def all_written(work: Path) -> bool:
    """Whether all that the last run was asked for stands beside its work, of the same points, as it noted last."""
    from raybundle.errors import InputError
    from raybundle.io.reading.trees import read_toml
    from raybundle.surfaces.products import PRODUCTS

    try:
        asked = read_toml(work / "project.toml").tree().get("surface")
    except InputError:
        return False
    wanted = [n for n in PRODUCTS if not n or (asked.has(n) and asked.get(n).value is not False)]
    noted = _written(work)
    there = all(any((work.parent / f).exists() for f in PRODUCTS[n].files) for n in wanted)
    return there and len({noted.get(n or POINTS, n).partition(" ")[0] for n in wanted}) == 1 and POINTS in noted


def _note(work: Path, known: Mapping[str, str], fingerprint: str = "") -> None:
    """Write down the key of the points of each product, and of which result they are where that is given."""
    from raybundle.pipeline.project import Project
    from raybundle.pipeline.settings_file import with_table
    from raybundle.results.fingerprint import FINGERPRINT

    project = Project.open(work)
    try:
        for table, values in ((TABLE, known), (MEASURED, {FINGERPRINT: fingerprint})):
            if table == TABLE or fingerprint:
                lines = [f"[{table}]", *(f'{name} = "{k}"' for name, k in sorted(values.items()))]
                project.write_settings(with_table(work / "project.toml", table, "\n".join(lines)))
    finally:
        project.close()


def _thinned(thin: float | None) -> str:
    """As it is noted."""
    return "" if thin is None else f"{thin:g}"


def _key(surface: Surface) -> str:
    from raybundle.pipeline.keys import key_of

    return key_of("points", surface.clouds)


def _written(work: Path) -> dict[str, str]:
    """Product -> the key of its points, as the last run noted, and what they were thinned by."""
    return _table(work, TABLE)


def _table(work: Path, name: str) -> dict[str, str]:
    """A table of project.toml; empty where it cannot be read."""
    from raybundle.errors import InputError
    from raybundle.io.reading.trees import read_toml

    path = work / "project.toml"
    try:
        return {k: v.text() for k, v in read_toml(path).tree().get(name).mapping().items()} if path.is_file() else {}
    except InputError:
        return {}
