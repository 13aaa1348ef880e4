"""record.toml: the recording sheet of a result, with what the photographs know by themselves."""

from __future__ import annotations

import json
from collections.abc import Iterator
from dataclasses import asdict, dataclass
from pathlib import Path

from raybundle.adjustment.result import Adjustment
from raybundle.io.reading.trees import Json, read_toml
from raybundle.results.record import RECORD_FILE, Record, record_from, record_lines

PHOTOGRAPHS = "photographs"
MOST_CAMERAS = 20


@dataclass(frozen=True, slots=True, kw_only=True)
class KnownByPhotographs:
    """What nobody has to write: it is in the photographs, or was determined from them."""

    photographs: int
    first: str = ""
    last: str = ""
    """dates"""
    cameras: tuple[str, ...] = ()
    """make and model, format and camera constant"""

    @property
    def dates(self) -> str:
        """First to last."""
        return self.first if self.first == self.last else f"{self.first} to {self.last}"


def known_by_photographs(adjustment: Adjustment, devices: dict[str, str], taken: tuple[str, ...]) -> KnownByPhotographs:
    """What photographs and adjustment show.

    devices  make and model, by camera
    taken    dates and times of the photographs
    """
    block = adjustment.adjusted
    cameras: list[str] = []
    for camera in block.cameras[:MOST_CAMERAS]:
        if camera.is_scene:
            continue
        c = camera.sensor.camera_constant(camera.parameters)
        count = sum(1 for k in block.images.camera.tolist() if block.cameras[int(k)].id == camera.id)
        name = devices.get(camera.id) or camera.id
        cameras.append(f"{name}, {camera.width_px} x {camera.height_px} px, c = {c:.4g} mm, {count} photographs")
    days = sorted({t.split()[0] for t in taken if t.strip()})
    return KnownByPhotographs(
        photographs=len(block.images), first=days[0] if days else "", last=days[-1] if days else "",
        cameras=tuple(cameras),
    )  # fmt: skip


def recorded_text(record: Record, known: KnownByPhotographs | None) -> str:
    """The file."""
    lines = ["# recording sheet of this result; change it with `raybundle record`, not here", *record_lines(record)]
    if known is not None:
        lines += ["", "# from the photographs, not written by anybody", f"[{PHOTOGRAPHS}]"]
        lines += [f"{k} = {json.dumps(v, ensure_ascii=False)}" for k, v in asdict(known).items() if v]
    return ("\n".join(lines) + "\n").encode("utf-8", "replace").decode()


def read_recorded(result: Path) -> tuple[Record, KnownByPhotographs | None]:
    """What a result folder states of itself; nothing where it has no record.toml."""
    file = result / RECORD_FILE
    if not file.is_file():
        return Record(), None
    tree = read_toml(file).tree()
    if not tree.has(PHOTOGRAPHS):
        return record_from(tree), None
    return record_from(tree), _known(tree.get(PHOTOGRAPHS))


def _known(tree: Json) -> KnownByPhotographs:
    words = {n: tree.get(n).text() for n in ("first", "last") if tree.has(n)}
    cameras = tuple(c.text() for c in tree.get("cameras").items()) if tree.has("cameras") else ()
    count = tree.get(PHOTOGRAPHS).whole(0) if tree.has(PHOTOGRAPHS) else 0
    return KnownByPhotographs(photographs=count, cameras=cameras, **words)


def rows_of(known: KnownByPhotographs) -> Iterator[tuple[str, str]]:
    """As a sheet lists them."""
    yield "photographs", str(known.photographs)
    if known.first:
        yield "taken", known.dates
    for camera in known.cameras:
        yield "camera", camera
