"""Maxar (DigitalGlobe) ISD XML: ephemeris, attitude, line times, detector and RPC of a Basic (1B) scene.

Line and sample 0 are the centres of the first ones.  Positions and attitudes are in the frame that turns with the
earth; quaternions have the scalar last.
"""

from __future__ import annotations

from datetime import datetime
from pathlib import Path

import numpy as np

from raybundle.errors import Message, note
from raybundle.io.reading.words import quoted
from raybundle.io.reading.xml import Element, read_xml
from raybundle.io.scenes.base import Scene, SceneFormat, check_denominators, element_text, numbers_of, register
from raybundle.io.scenes.maxar_detector import chosen_angle, read_mounting
from raybundle.numerics.arrays import Array
from raybundle.numerics.geodesy import WGS84
from raybundle.scenes.linescan import LineScene
from raybundle.scenes.rpc import Rpc, rpc_of
from raybundle.scenes.scan import EPOCH
from raybundle.scenes.trajectory import Trajectory

ORBIT_M = (WGS84.a + 1.0e5, 5.0e7)
"""Geocentric distances that an orbit can have."""
RPC00A_IN_B = (0, 1, 2, 3, 4, 5, 6, 10, 7, 8, 9, 11, 14, 17, 12, 15, 18, 13, 16, 19)
"""Position in the order RPC00B of each term of the order RPC00A (STDI-0002)."""


def read(path: Path) -> Scene:
    """The scene of an ISD XML file; a rigorous model that cannot be used is left out with a remark."""
    root = read_xml(path, "isd")
    image = root.get("IMD", "IMAGE")
    rows, columns = (_whole(root.get("IMD", k)) for k in ("NUMROWS", "NUMCOLUMNS"))
    remarks: list[Message] = []
    rpc = None
    if root.find("RPB") is not None:
        rpc, more = _rpc(root.get("RPB"))
        remarks += more
        check_denominators(rpc, path)
    line = None
    if root.find("EPH") is not None and root.find("ATT") is not None and root.find("GEO") is not None:
        line, more = _line(root, rows, columns, rpc)
        remarks += more
    else:
        remarks.append(note("maxar.no_rigorous_model"))
    return Scene(
        file=path,
        format="maxar",
        rpc=rpc,
        rigorous=line,
        width_px=columns,
        height_px=rows,
        sensor=element_text(image, "SATID"),
        time=element_text(image, "FIRSTLINETIME") or element_text(image, "TLCTIME"),
        remarks=tuple(remarks),
    )


def _whole(element: Element) -> int:
    value = float(element.numbers(1)[0])
    if value != int(value) or not 1 <= value <= 10_000_000:
        element.fail("scene.pixel_count", value=value)
    return int(value)


def _rpc(group: Element) -> tuple[Rpc, list[Message]]:
    image = group.get("IMAGE")
    specification = element_text(group, "SPECID")
    remarks: list[Message] = []
    order = list(range(20))
    if specification == "RPC00A":
        order = list(RPC00A_IN_B)
        remarks.append(note("rpc.terms_reordered"))
    elif specification != "RPC00B":
        remarks.append(note("rpc.specification_assumed", specification=specification or "none"))
    coefficients = np.zeros((4, 20))
    for k, name in enumerate(("LINENUMCOEF", "LINEDENCOEF", "SAMPNUMCOEF", "SAMPDENCOEF")):
        coefficients[k, order] = image.get(f"{name}List", name).numbers(20)

    def number(name: str) -> float:
        return image.number(name)

    return rpc_of(
        coefficients=coefficients,
        ground_offset=np.array([number("LONGOFFSET"), number("LATOFFSET"), number("HEIGHTOFFSET")]),
        ground_scale=np.array([number("LONGSCALE"), number("LATSCALE"), number("HEIGHTSCALE")]),
        image_offset=np.array([number("SAMPOFFSET"), number("LINEOFFSET")]) + 0.5,
        image_scale=np.array([number("SAMPSCALE"), number("LINESCALE")]),
        err_bias_m=image.number("ERRBIAS", 0.0) or None,
        err_rand_m=image.number("ERRRAND", 0.0) or None,
    ), remarks


def _line(root: Element, rows: int, columns: int, rpc: Rpc | None) -> tuple[LineScene | None, list[Message]]:
    geo, image = root.get("GEO"), root.get("IMD", "IMAGE")
    distortion = geo.find("OPTICAL_DISTORTION")
    if distortion is not None and any(np.any(numbers_of(e)) for e in _lists(distortion)):
        return None, [note("maxar.distortion_not_supported")]
    start = _time(root.get("EPH", "STARTTIME"))
    ephemeris = _table(root.get("EPH"), "EPHEMLIST", 7)
    attitude = _table(root.get("ATT"), "ATTLIST", 5)
    _check_orbit(root.get("EPH"), ephemeris[:, 1:4])
    interval = [root.get(k).number("TIMEINTERVAL") for k in ("EPH", "ATT")]
    turned = (_time(root.get("ATT", "STARTTIME")) - start).total_seconds()
    attitude_times = turned + (attitude[:, 0] - attitude[0, 0]) * interval[1]
    position_times = (ephemeris[:, 0] - ephemeris[0, 0]) * interval[0]
    # the perspective centre lies off the point to which the ephemeris refers, a fixed way in the satellite's axes
    centre = geo.get("PERSPECTIVE_CENTER")
    lever = np.array([centre.number(f"C{a}") for a in "XYZ"])
    positions = ephemeris[:, 1:4]
    if lever.any():
        bare = Trajectory(
            position_times=position_times,
            positions=positions,
            attitude_times=attitude_times,
            quaternions=attitude[:, 1:5],
        )
        positions = positions + np.einsum("nij,j->ni", bare.rotation(position_times)[0], lever)
    line_y, line_times = _line_times(image, start, rows)
    x = np.array([0.0, float(columns)])
    mounting = read_mounting(root, geo)

    def scene(angle: float) -> LineScene:
        return LineScene(
            epoch_s=(start - EPOCH).total_seconds(),
            width_px=columns,
            height_px=rows,
            line_y=line_y,
            line_times=line_times,
            detector_x=x,
            detector_look=mounting.look(x, angle),
            trajectory=Trajectory(
                position_times=position_times,
                positions=positions,
                attitude_times=attitude_times,
                quaternions=attitude[:, 1:5],
            ),
        )

    angle, remarks = chosen_angle(mounting, columns, scene, rpc)
    return scene(angle), remarks


def _lists(distortion: Element) -> list[Element]:
    """The elements that hold coefficients: ALIST, BLIST, alone or in a list."""
    found: list[Element] = []
    for name in ("ALIST", "BLIST"):
        found += [*distortion.all(name), *(e for group in distortion.all(f"{name}List") for e in group.all(name))]
    return found


def _line_times(image: Element, start: datetime, rows: int) -> tuple[Array, Array]:
    """Lines y [px] and times [s] of the lines that the time table lists."""
    offset = (_time(image.get("TLCTIME")) - start).total_seconds()
    table = np.array([e.numbers(2) for e in image.get("TLCLISTList").all("TLCLIST")]).reshape(-1, 2)
    if len(table) == 0:
        image.get("TLCLISTList").fail("maxar.no_line_times")
    if len(table) == 1:
        sign = -1.0 if element_text(image, "SCANDIRECTION").lower() == "reverse" else 1.0
        last = table[0] + [rows, sign * rows / image.number("AVGLINERATE")]
        table = np.stack([table[0], last])
    return table[:, 0] + 0.5, offset + table[:, 1]


def _table(group: Element, name: str, least: int) -> Array:
    """The rows (n, k >= least) of a list whose first column counts them."""
    entries = list(group.get(f"{name}List").all(name))
    announced = int(group.number("NUMPOINTS", float(len(entries))))
    if len(entries) != announced or announced < 2:
        group.fail("maxar.entry_count", n=len(entries), name=name, announced=announced)
    rows = [numbers_of(e) for e in entries]
    for k, row in enumerate(rows):
        if len(row) < least or len(row) != len(rows[0]):
            entries[k].fail("value.count", n=len(row), needed=max(least, len(rows[0])))
    table = np.stack(rows)
    step = np.diff(table[:, 0])
    if (step != 1).any():
        k = int(np.flatnonzero(step != 1)[0])
        entries[k + 1].fail("maxar.gap", entry=table[k + 1, 0], before=table[k, 0])
    return table


def _check_orbit(group: Element, positions: Array) -> None:
    radius = np.linalg.norm(positions, axis=1)
    bad = np.flatnonzero((radius < ORBIT_M[0]) | (radius > ORBIT_M[1]))
    if len(bad):
        k = int(bad[0])
        group.fail("scene.not_an_orbit", distance_m=radius[k], least_m=ORBIT_M[0], most_m=ORBIT_M[1])


def _time(element: Element) -> datetime:
    text = element.content.strip()
    try:
        time = datetime.fromisoformat(text)
    except ValueError:
        element.fail("value.no_time", value=quoted(text))
    return time.replace(tzinfo=None)


def _recognises(path: Path, head: bytes) -> bool:
    del path
    return b"<isd" in head


register(
    SceneFormat(
        name="maxar", title="Maxar/DigitalGlobe ISD XML (orbit, detector, RPC)", recognises=_recognises, read=read
    )
)
