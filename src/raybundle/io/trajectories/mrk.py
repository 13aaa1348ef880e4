"""MRK files of DJI aircraft: time and position of each exposure, a line each.

    1  282401.669089  [2404]  101,N  107,E  129,V  22.77995359,Lat  114.10089118,Lon  139.231,Ellh
       0.002967, 0.003104, 0.007622  50,Q

(on one line, separated by tabs): running number; GPS second of the week; [GPS week]; offset from the antenna's phase
centre to the camera north, east, down [mm]; latitude, longitude [deg] and height above the ellipsoid [m] of the camera,
to which that offset has been applied; standard deviations north, east, up [m]; state (0 none, 16 single, 32 to 49
float, 50 fixed).  After the user manuals of the Phantom 4 RTK and the Matrice 4; the order of latitude and longitude
differs among aircraft and is taken from the letters.  Positions computed afterwards from the raw data belong to the
antenna: there the offset must still be applied.
"""

from __future__ import annotations

import re
from pathlib import Path
from typing import NoReturn

import numpy as np

from raybundle.errors import InputError, Message, Value, content, phrase
from raybundle.io.reading.files import read_text
from raybundle.io.reading.words import no_number, number_of, quoted
from raybundle.io.trajectories.base import WEEK_S, WGS84_HEIGHT, Trajectory, TrajectoryFormat, register
from raybundle.numerics.arrays import Array

NUMBER = r"[-+]?[0-9]+(?:\.[0-9]*)?(?:[eE][-+]?[0-9]+)?"
LETTERS = ("N", "E", "V", "Lat", "Lon", "Ellh", "Q")
TAGGED = re.compile(rf"({NUMBER})\s*,\s*({'|'.join(LETTERS)})(?![A-Za-z])")
HEAD = re.compile(rf"^\s*([0-9]{{1,9}})\s+({NUMBER})\s+\[\s*([0-9]{{1,5}})\s*\]")
SIGMAS = re.compile(rf"Ellh[\s,]+({NUMBER})[\s,]+({NUMBER})[\s,]+({NUMBER})(?!\s*,\s*Q)[\s,]")
LARGEST_SIGMA_M = 1e6
LIMITS = {"Lat": 90.0, "Lon": 180.0, "Ellh": 20_000.0, "N": 1e5, "E": 1e5, "V": 1e5}


def read(path: Path) -> Trajectory:
    """Camera positions of an MRK file, in longitude, latitude and height above the ellipsoid.

    raises  InputError with line and column for a line that cannot be read; also where the file holds no line
    Limits: attitudes, and to which photographs the numbers belong.
    """
    numbers: dict[str, int] = {}
    rows: list[list[float]] = []
    fix: list[str] = []
    at: list[int] = []
    for line, text in enumerate(read_text(path).split("\n"), 1):
        if not text.strip():
            continue
        name, values, state = _line(path, line, text)
        if name in numbers:
            raise InputError(
                "cell.id_twice", id=name, earlier=numbers[name], rows=False, file=path, line=line, column="1"
            )
        numbers[name] = line
        rows.append(values)
        fix.append(state)
        at.append(line)
    if not rows:
        raise InputError("mrk.empty", file=path, line=1)
    table = np.array(rows)
    xyz = table[:, 4:7].copy()
    lost = (xyz[:, :2] == 0).all(axis=1)
    xyz[lost] = np.nan
    sigma = np.where(table[:, 7:10] > 0, table[:, 7:10], np.nan)
    remarks = [
        phrase("position_list.of_camera"),
        *([phrase("position_list.exposures_without", n=int(lost.sum()), of=len(lost))] if lost.any() else []),
    ]
    weak = sum(f != "rtk fixed" for f in fix)
    if weak:
        remarks.append(phrase("position_list.not_fixed", n=weak, of=len(fix)))
    return Trajectory(
        path=path,
        names=tuple(numbers),
        numbered=True,
        xyz=xyz,
        sigma=sigma,
        crs=WGS84_HEIGHT,
        time=table[:, 0],
        offset=table[:, 1:4],
        fix=tuple(fix),
        remarks=tuple(remarks),
        lines=np.array(at, np.int32),
    )


def _line(path: Path, line: int, text: str) -> tuple[str, list[float], str]:
    """Number; time, offset east, north, up [m], longitude, latitude, height, sigma east, north, up; state."""

    def fail(code: str | Message, /, column: str, **values: Value) -> NoReturn:
        raise InputError(content(code, values), file=path, line=line, column=column)

    def value_of(word: str, column: str) -> float:
        value = number_of(word)
        if value is None:
            fail(no_number(word), column)
        return value

    head = HEAD.match(text)
    if head is None:
        fail("mrk.line", "1", text=quoted(text.strip()))
    found: dict[str, float] = {}
    for value, letter in TAGGED.findall(text):
        if letter in found:
            fail("mrk.tag_twice", letter, tag=letter)
        found[letter] = value_of(value, letter)
    for letter in LETTERS:
        if letter not in found:
            fail("mrk.tag_missing", letter, tag=letter, text=quoted(text.strip()[-40:]))
    for letter, limit in LIMITS.items():
        if abs(found[letter]) > limit:
            fail("mrk.out_of_range", letter, tag=letter, value=found[letter], limit=limit)
    sigmas = SIGMAS.search(text)
    if sigmas is None:
        fail("mrk.sigmas_missing", "sigma")
    north, east, up = (value_of(v, "sigma") for v in sigmas.groups())
    if min(north, east, up) < 0 or max(north, east, up) > LARGEST_SIGMA_M:
        fail("mrk.sigmas_out_of_range", "sigma", sigmas_m=[north, east, up], largest_m=LARGEST_SIGMA_M)
    second = value_of(head[2], "2")
    if not 0 <= second < WEEK_S + 1:
        fail("mrk.second_of_week", "2", second=second)
    values = [
        value_of(head[3], "3") * WEEK_S + second,
        found["E"] / 1000,
        found["N"] / 1000,
        -found["V"] / 1000,
        found["Lon"],
        found["Lat"],
        found["Ellh"],
        east,
        north,
        up,
    ]
    return head[1], values, fix_of(found["Q"])


def fix_of(state: float) -> str:
    """The state of a solution in words."""
    if state == 50:
        return "rtk fixed"
    if 32 <= state <= 49:
        return "rtk float"
    return "single" if state == 16 else "none"


STATE = {"rtk fixed": 50, "rtk float": 34, "single": 16, "none": 0, "": 0}


def write(trajectory: Trajectory, path: Path) -> None:
    """Write an MRK file; raises InputError where the positions are not geographic."""
    if trajectory.crs != WGS84_HEIGHT:
        raise InputError("mrk.not_geographic", crs=str(trajectory.crs), file=path)
    n = len(trajectory)
    zero = np.zeros((n, 3))
    time = zero[:, 0] if trajectory.time is None else trajectory.time
    offset = zero if trajectory.offset is None else trajectory.offset
    sigma = np.where(np.isfinite(trajectory.sigma), trajectory.sigma, 0.0)
    xyz = np.where(np.isfinite(trajectory.xyz), trajectory.xyz, 0.0)
    fix = trajectory.fix or ("",) * n
    names = trajectory.names if trajectory.numbered else tuple(str(k + 1) for k in range(n))
    lines = [_text(*row) for row in zip(names, time, offset, xyz, sigma, fix, strict=True)]
    path.write_text("".join(lines), encoding="utf-8")


def _text(name: str, time: float, offset: Array, xyz: Array, sigma: Array, fix: str) -> str:
    week, second = divmod(time, WEEK_S)
    mm = offset * 1000
    return "\t".join(
        [
            name,
            f"{second:.6f}",
            f"[{int(week)}]",
            f"{mm[1]:6.0f},N",
            f"{mm[0]:6.0f},E",
            f"{-mm[2]:6.0f},V",
            f"{xyz[1]:.9f},Lat",
            f"{xyz[0]:.9f},Lon",
            f"{xyz[2]:.4f},Ellh",
            f"{sigma[1]:.6f}, {sigma[0]:.6f}, {sigma[2]:.6f}",
            f"{STATE[fix]},Q\n",
        ]
    )


register(
    TrajectoryFormat(
        name="mrk",
        title="MRK file of a DJI aircraft (time and position of each exposure)",
        read=read,
        write=write,
        recognises=lambda head, suffix: suffix == ".mrk" or (",Lat" in head and ",Ellh" in head),
    )
)
