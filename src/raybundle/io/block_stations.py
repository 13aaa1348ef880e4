"""Observed projection centres and attitudes in a block folder: stations.csv and attitudes.csv."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path

import numpy as np

from raybundle.block import Block, Camera, Stations
from raybundle.block.block import Attitudes, no_attitudes, no_stations
from raybundle.errors import InputError
from raybundle.io.block_tables import ANGLES, SIGMA_XYZ, XYZ, columns_of, named, problems_of, require
from raybundle.io.reading.words import quoted
from raybundle.io.tables import Column, read_table, write_table
from raybundle.numerics.arrays import Array, Mask
from raybundle.sensors.antenna import ANTENNA
from raybundle.sensors.imu import IMU

VELOCITY = ("vX", "vY", "vZ")
SIGMA_ANGLES = ("somega_deg", "sphi_deg", "skappa_deg")


def read_stations(path: Path, images: dict[str, int], cameras: tuple[Camera, ...]) -> Stations:
    """Observed projection centres; none where there is no file."""
    if not path.exists():
        return no_stations()
    table = read_table(
        path,
        (
            Column(name="image", kind="reference", known=images, where="images.csv"),
            *(Column(name=n, kind="number", empty=True) for n in XYZ),
            *(Column(name=n, kind="number", empty=True, limit="> 0") for n in SIGMA_XYZ),
            Column(name="antenna", kind="text", optional=True, empty=True),
            Column(name="time_s", kind="number", optional=True, empty=True),
            *(Column(name=n, kind="number", optional=True, empty=True) for n in VELOCITY),
        ),
    )
    image = table.index["image"]
    known = {c.id: k for k, c in enumerate(cameras) if c.sensor is ANTENNA}
    names = table.text.get("antenna", ("",) * len(image))
    strange = np.array([bool(n) and n not in known for n in names], bool)
    parts = [n for n in VELOCITY if n in table.number]
    if 0 < len(parts) < 3:
        raise InputError(f"{parts[0]} stands there alone; give {', '.join(VELOCITY)}", file=path, line=1)
    xyz, sigma = table.numbers(*XYZ), table.numbers(*SIGMA_XYZ)
    _, first = np.unique(image, return_index=True)
    again = np.ones(len(image), bool)
    again[first] = False
    half: Mask = np.any(np.isfinite(xyz) ^ np.isfinite(sigma), axis=1)
    none: Mask = np.all(~np.isfinite(xyz), axis=1)
    require(
        path,
        problems_of(again, "image", lambda _: "this image has a row already; delete one of the two"),
        problems_of(half, "sX", lambda _: "each coordinate needs its sigma, each sigma its coordinate"),
        problems_of(none, "X", lambda _: "the row holds no coordinate; delete it"),
        problems_of(strange, "antenna", lambda k: f"{quoted(names[k])} is none of the antennas of block.toml"),
    )
    return Stations(
        image=image,
        xyz=xyz,
        sigma=sigma,
        antenna=np.array([known.get(n, -1) for n in names], np.int32) if any(names) else None,
        time=np.nan_to_num(table.number["time_s"]) if "time_s" in table.number else None,
        velocity=table.numbers(*VELOCITY) if parts else None,
    )


def read_attitudes(path: Path, images: dict[str, int], cameras: tuple[Camera, ...]) -> Attitudes:
    """Observed attitudes; none where there is no file."""
    if not path.exists():
        return no_attitudes()
    table = read_table(
        path,
        (
            Column(name="image", kind="reference", known=images, where="images.csv"),
            *(Column(name=n, kind="number") for n in ANGLES),
            *(Column(name=n, kind="number", empty=True, limit="> 0") for n in SIGMA_ANGLES),
            Column(name="imu", kind="text", optional=True, empty=True),
        ),
    )
    image = table.index["image"]
    known = {c.id: k for k, c in enumerate(cameras) if c.sensor is IMU}
    names = table.text.get("imu", ("",) * len(image))
    strange = np.array([bool(n) and n not in known for n in names], bool)
    _, first = np.unique(image, return_index=True)
    again = np.ones(len(image), bool)
    again[first] = False
    sigma = table.numbers(*SIGMA_ANGLES)
    blind: Mask = np.all(np.isnan(sigma), axis=1)
    require(
        path,
        problems_of(again, "image", lambda _: "this image has a row already; delete one of the two"),
        problems_of(blind, "somega_deg", lambda _: "no angle has a sigma; give one, or delete it"),
        problems_of(strange, "imu", lambda k: f"{quoted(names[k])} is none of the imus of block.toml"),
    )
    return Attitudes(
        image=image,
        angles=np.radians(table.numbers(*ANGLES)),
        sigma=np.radians(sigma),
        imu=np.array([known.get(n, -1) for n in names], np.int32) if any(names) else None,
    )


def write_stations(folder: Path, block: Block) -> None:
    """Write both tables, each where it has rows."""
    images, s, a = block.images, block.stations, block.attitudes
    if len(s):
        rows: dict[str, Sequence[str] | Array] = {
            "image": named(images.ids, s.image), **columns_of(XYZ, s.xyz), **columns_of(SIGMA_XYZ, s.sigma)
        }  # fmt: skip
        if s.antenna is not None:
            rows["antenna"] = [block.cameras[k].id if k >= 0 else "" for k in s.antenna.tolist()]
        if s.time is not None:
            rows["time_s"] = s.time
        if s.velocity is not None:
            rows |= columns_of(VELOCITY, s.velocity)
        write_table(folder / "stations.csv", rows)
    if len(a):
        rows = {
            "image": named(images.ids, a.image),
            **columns_of(ANGLES, np.round(np.degrees(a.angles), 12) + 0.0),
            **columns_of(SIGMA_ANGLES, np.degrees(a.sigma)),
        }
        if a.imu is not None:
            rows["imu"] = [block.cameras[k].id if k >= 0 else "" for k in a.imu.tolist()]
        write_table(folder / "attitudes.csv", rows)
