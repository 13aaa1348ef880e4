"""COLMAP's cameras.txt: one line for each camera.  Its pixel frame is ours: the origin is the corner."""

from __future__ import annotations

import re
from collections.abc import Sequence
from pathlib import Path

from raybundle.cameras.forward_camera import ForwardCamera
from raybundle.errors import InputError
from raybundle.io.calibrations.base import Calibration, CalibrationFormat, Conversion, Variant, register
from raybundle.io.digits import exact
from raybundle.io.formats.colmap_cameras import MODELS, NUMBERS, PARAMETERS, forward_of, own_camera
from raybundle.io.reading.files import read_text
from raybundle.io.reading.words import number_of, numbers_of, quoted

WRITTEN = ("PINHOLE", "SIMPLE_RADIAL", "RADIAL", "OPENCV", "FULL_OPENCV", "OPENCV_FISHEYE")
LEAST_WORDS = 5


def read(path: Path, size_px: tuple[int, int] | None) -> tuple[Calibration, ...]:
    """The cameras of a cameras.txt, in its order."""
    del size_px  # every line shows it
    found: list[Calibration] = []
    for number, line in enumerate(read_text(path).split("\n"), 1):
        if line.startswith("#") or not line.strip():
            continue
        calibration = _camera(path, number, line.split())
        if calibration.id in {c.id for c in found}:
            raise InputError("name.twice", kind="camera", name=calibration.id, file=path, line=number)
        found.append(calibration)
    if not found:
        raise InputError("calibration.no_camera", file=path)
    return tuple(found)


def _camera(path: Path, line: int, words: Sequence[str]) -> Calibration:
    if len(words) < LEAST_WORDS:
        raise InputError("colmap.camera_line", file=path, line=line)
    id_, model, *rest = words
    if model not in PARAMETERS:
        raise InputError(
            "camera.model_unknown", camera=id_, model=quoted(model), known=list(PARAMETERS), file=path, line=line
        )
    given = numbers_of(rest)
    if given is None:
        raise InputError(
            "value.not_finite", value=quoted(next(w for w in rest if number_of(w) is None)), file=path, line=line
        )
    width, height, *values = given.tolist()
    terms = PARAMETERS[model]
    if len(values) != len(terms):
        raise InputError(
            "camera.parameter_count", camera=id_, n=len(values), model=model, needed=len(terms), file=path, line=line
        )
    if not all(s == int(s) and 0 < s <= 10_000_000 for s in (width, height)) or values[0] <= 0:
        raise InputError(
            "calibration.size_or_distance",
            width_px=width,
            height_px=height,
            distance_px=values[0],
            file=path,
            line=line,
        )
    size = int(width), int(height)
    camera = forward_of(model, *size, values) if model in NUMBERS else own_camera(model, id_, *size, values)
    return Calibration(id=id_, camera=camera)


def write(conversions: Sequence[Conversion], suffix: str) -> str:
    """A cameras.txt; ids that are no numbers become 1, 2, ..."""
    del suffix
    ids = [c.calibration.id for c in conversions]
    if not all(re.fullmatch(r"[1-9]\d{0,8}", i) for i in ids):
        ids = [str(k) for k in range(1, len(ids) + 1)]
    lines = ["# CAMERA_ID, MODEL, WIDTH, HEIGHT, PARAMS[]"]
    for id_, conversion in zip(ids, conversions, strict=True):
        camera = conversion.calibration.camera
        assert isinstance(camera, ForwardCamera)
        terms = MODELS[NUMBERS[conversion.variant]][1]
        values = " ".join(exact(getattr(camera, "fx" if t == "f" else t)) for t in terms)
        lines.append(f"{id_} {conversion.variant} {camera.width_px} {camera.height_px} {values}")
    return "\n".join(lines) + "\n"


def _variant(name: str) -> Variant:
    terms = tuple("fx" if t == "f" else t for t in MODELS[NUMBERS[name]][1])
    return Variant(name=name, terms=terms, projection="equidistant" if "FISHEYE" in name else "central")


register(
    CalibrationFormat(
        name="colmap",
        title="COLMAP cameras.txt",
        suffixes=(".txt",),
        read=read,
        write=write,
        several=True,
        variants=tuple(_variant(n) for n in WRITTEN),
        recognises=lambda text, suffix: (
            suffix == ".txt" and bool(re.search(rf"^\d+ ({'|'.join(NUMBERS)}) \d+ \d+ ", text, re.MULTILINE))
        ),
    )
)
