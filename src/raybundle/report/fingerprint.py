"""Fingerprints of the input and versions of the software, so that a result can be repeated."""

from __future__ import annotations

import hashlib
import json
import platform
from collections.abc import Sequence
from dataclasses import asdict
from importlib.metadata import PackageNotFoundError, version

import numpy as np

from raybundle.block import Block, Camera
from raybundle.errors import phrase
from raybundle.numerics import native
from raybundle.numerics.arrays import Array, Index, Mask
from raybundle.observations import tables
from raybundle.report.text.numbers import grouped


def fingerprint(*parts: Array | Index | Mask | Sequence[str]) -> str:
    """SHA-256 of arrays and texts, in an order of bytes that is the same on every machine.

    Arrays count with their shape and as doubles,
    -0 as 0 and every NaN as the same: equal tables have equal fingerprints.
    """
    digest = hashlib.sha256()
    for part in parts:
        if isinstance(part, np.ndarray):
            numbers = np.ascontiguousarray(part, "<f8") + 0.0
            numbers[np.isnan(numbers)] = np.nan
            digest.update(f"array {part.shape}\0".encode())
            digest.update(numbers.tobytes())
        else:
            digest.update(json.dumps(list(part)).encode())
    return digest.hexdigest()


def fingerprints(block: Block) -> list[tuple[str, str, str]]:
    """Name, number of rows and fingerprint of each table of a block."""
    i, o, p = block.images, block.observations, block.points
    cameras = [
        json.dumps([
            c.id, c.model, c.width_px, c.height_px, c.pixel_mm, sorted(c.values.items()), c.estimate,
            sorted(c.sigma.items()),
            c.interior,
            *([c.per_image] if c.per_image else []),
            *([asdict(c.calibrated)] if c.calibrated else []),
            *(
                [r.name, sorted(r.terms.items()), r.sigma, r.observed, *([True] if r.logarithm else [])]
                for r in c.relations
            ),
            *([_scene(c)] if c.is_scene else []),
        ])
        for c in block.cameras
    ]  # fmt: skip
    held = np.zeros(len(i), bool) if i.held is None else i.held
    own = [json.dumps([k, sorted(v.items())]) for k, v in sorted(i.interior.items())]
    own += [json.dumps([k, f.turned, f.width_px, f.height_px, *(f.affine or ())]) for k, f in sorted(i.frames.items())]
    instruments = [
        json.dumps([c.id, c.model, sorted(c.values.items()), c.estimate, sorted(c.sigma.items())])
        for c in block.instruments
    ]
    rows = [
        ("cameras", len(block.cameras), fingerprint([block.length_unit, block.residuals], cameras)),
        ("images", len(i), fingerprint(i.ids, i.camera, i.centre, i.rotation, held, own)),
        ("observations", len(o), fingerprint(o.image, o.point, o.xy_px, o.cov_px2)),
        ("points", len(p), fingerprint(p.ids, p.role, p.xyz, p.sigma)),
    ]
    for name, table in ((name, block.tables[name]) for name in tables if name in block.tables):
        rows.append(
            (name, len(table), fingerprint(*(v for f, _ in table.cells() if (v := getattr(table, f)) is not None)))
        )
    if block.instruments:
        rows.append(("instruments", len(block.instruments), fingerprint(instruments)))
    if i.station is not None:
        rows.append(("rig_stations", len(i), fingerprint(i.station)))
    return [(name, grouped(count), print_) for name, count, print_ in rows]


def _scene(camera: Camera) -> list[float]:
    """Where a satellite scene shows five of its points: given by everything in it."""
    sensor = camera.sensor
    t = np.array([[0.0, 0.4, 0.4, -0.4, -0.4], [0.0, 0.4, -0.4, 0.4, -0.4]])
    values = camera.parameters
    return np.round(sensor.ray(t * camera.size_mm[:, None], values), 6).ravel().tolist()


def versions() -> dict[str, str]:
    """Versions of what computed the result."""

    def of(package: str) -> str:
        try:
            return version(package)
        except PackageNotFoundError:
            return phrase("report_tables.not_installed")

    return {
        "raybundle": of("raybundle"),
        "kernel": phrase("report_tables.kernel", native=native.available()),
        "Python": platform.python_version(),
        "NumPy": of("numpy"),
        "SciPy": of("scipy"),
        "machine": f"{platform.system()} {platform.machine()}",
    }
