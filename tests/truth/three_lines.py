"""Strips of an aerial three-line camera: an unsteady flight, GNSS and INS, lines that share a trajectory."""

from __future__ import annotations

from dataclasses import dataclass, replace
from pathlib import Path

import numpy as np

from raybundle.block import Block
from raybundle.io.block.folder import read_block
from raybundle.io.digits import EVERY
from raybundle.io.tables import write_table
from raybundle.numerics.attitude import opk_from_rotation, rotation_from_rpy
from raybundle.numerics.geodesy import LocalPlace
from raybundle.planning.simulate import measured

PLACE = (15.0, 48.0, 300.0)
C_MM, PIXEL_MM, WIDTH = 62.77, 0.0065, 12000
INTERVAL, SECONDS, ABOVE_M, SPEED = 0.002, 40.0, 1200.0, 60.0
LINES = {"forward": 27.0, "nadir": 0.0, "backward": -14.0}
"""Angles of the lines against the vertical, along the flight [deg]"""
SIGMA_M, SIGMA_DEG, SIGMA_PX = 0.05, 0.003, 0.4
SCENE = """scanner = "one line of three"
width_px = {width}
height_px = {height}

[lens]
c_mm = {c}
pixel_mm = {pixel}
y0_mm = {y0}

[lines]
first_s = {first}
interval_s = {interval}

[trajectory]
file = "{flight}.csv"
"""
TRAJECTORY = """
[trajectories.{name}]
attitude_degree = -1
position_fixes = {fixes}
attitude_fixes = {fixes}
"""
MOUNT = """
[mounts.{name}]
bx = 0.0
by = 0.0
bz = 0.0
bt = 0.0
estimate = ["bx", "by", "bz", "bt"]
"""


@dataclass(frozen=True, slots=True, kw_only=True)
class Plan:
    """What is flown and adjusted."""

    headings: tuple[float, ...] = (80.0, 260.0)
    lines: tuple[str, ...] = tuple(LINES)
    together: bool = True
    """Whether the lines of a strip share its trajectory; else each has one of its own"""
    mounts: bool = True
    fixes: int = 6
    points: int = 60
    control: int = 6


def flight(heading_deg: float, across_m: float) -> dict[str, np.ndarray]:
    """Table of an unsteady flight: waves of some seconds in the path and the attitude."""
    t, h = np.arange(-1.0, SECONDS + 1.0, 0.02), np.radians(heading_deg)
    along = SPEED * (t - SECONDS / 2) + 5 * np.sin(0.6 * t)
    across = across_m + 4 * np.sin(0.45 * t + 1) + 1.5 * np.sin(1.3 * t)
    local = np.stack([along * np.sin(h) + across * np.cos(h), along * np.cos(h) - across * np.sin(h),
                      ABOVE_M + 3 * np.sin(0.35 * t)], axis=1)  # fmt: skip
    wave = np.stack([1.5 * np.sin(0.9 * t), 0.9 * np.sin(0.7 * t + 2), 1.2 * np.sin(0.4 * t + 4)], axis=1)
    wave[:, :2] += 0.3 * np.sin(2.3 * t)[:, None]
    angles = np.degrees(opk_from_rotation(rotation_from_rpy(np.radians(wave) + np.array([0.0, 0.0, h]))))
    places = LocalPlace(origin=PLACE).geographic_from_local(local)
    names = ("time_s", "longitude_deg", "latitude_deg", "height_m", "omega_deg", "phi_deg", "kappa_deg")
    columns = dict(zip(names, np.column_stack([t, places, angles]).T, strict=True))
    columns |= {n: np.full(len(t), SIGMA_M) for n in ("sX", "sY", "sZ")}
    return columns | {n: np.full(len(t), SIGMA_DEG) for n in ("somega_deg", "sphi_deg", "skappa_deg")}


def three_line_block(folder: Path, plan: Plan | None = None) -> Block:
    """The block without errors, read from a folder that is written here."""
    plan = plan or Plan()
    folder.mkdir(parents=True, exist_ok=True)
    head = [f'[frame]\nkind = "local"\norigin = {list(PLACE)}\n']
    images = ["image,camera,file,X,Y,Z,omega_deg,phi_deg,kappa_deg"]
    for k, heading in enumerate(plan.headings):
        write_table(folder / f"flight{k}.csv", flight(heading, 200.0 * (-1) ** k), EVERY)
        if plan.together:
            head.append(TRAJECTORY.format(name=f"strip{k}", fixes=plan.fixes))
        for line in plan.lines:
            name = f"{line}{k}"
            (folder / f"{name}.toml").write_text(
                SCENE.format(
                    width=WIDTH, height=int(SECONDS / INTERVAL), c=C_MM, pixel=PIXEL_MM, interval=INTERVAL,
                    y0=C_MM * np.tan(np.radians(LINES[line])), first=INTERVAL / 2, flight=f"flight{k}",
                )
            )  # fmt: skip
            own = f"strip{k}" if plan.together else f"strip-{name}"
            if not plan.together:
                head.append(TRAJECTORY.format(name=own, fixes=plan.fixes))
            mount = f'mount = "{line}"\n' if plan.mounts else ""
            head.append(
                f'\n[cameras.{name}]\nmodel = "linescan"\nscene = "{name}.toml"\nheight_m = {PLACE[2]}\n'
                f'trajectory = "{own}"\n{mount}'
            )
            images.append(f"{name},{name},,,,,,,")
    head += [MOUNT.format(name=line) for line in plan.lines if plan.mounts]
    (folder / "block.toml").write_text("".join(head))
    (folder / "images.csv").write_text("\n".join(images) + "\n")
    rng = np.random.default_rng(5)
    h = np.radians(plan.headings[0])
    along, across = rng.uniform(-520, 520, plan.points), rng.uniform(-450, 450, plan.points)
    xyz = np.column_stack([along * np.sin(h) + across * np.cos(h), along * np.cos(h) - across * np.sin(h),
                           rng.uniform(-40, 40, plan.points)])  # fmt: skip
    rows = ["point,role,X,Y,Z,sX,sY,sZ"]
    for k, (x, y, z) in enumerate(xyz.tolist()):
        given = "control" if k < plan.control else "tie"
        rows.append(f"{k},{given},{x!r},{y!r},{z!r}," + ("0.03,0.03,0.04" if k < plan.control else ",,"))
    (folder / "points.csv").write_text("\n".join(rows) + "\n")
    pairs = [f"{i.split(',')[0]},{k},1.0,1.0,{SIGMA_PX},{SIGMA_PX}" for i in images[1:] for k in range(plan.points)]
    (folder / "observations.csv").write_text("image,point,x_px,y_px,sx_px,sy_px\n" + "\n".join(pairs) + "\n")
    block = read_block(folder)
    seen = measured(block, SIGMA_PX)
    return replace(block, observations=seen.observations)
