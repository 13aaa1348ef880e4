"""Detector mounting of a Maxar ISD file: viewing directions of its elements, and the unit of its rotation angle.

The specification gives DETROTANGLE in degrees; files of some satellites hold radians.  The file's own attribute
`unit` decides; without one both units are tried: against the vendor's RPC, else by the place of the array, whose
middle lies near the optical axis.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np

from raybundle.errors import Message, RaybundleError, note
from raybundle.io.reading.words import quoted
from raybundle.io.reading.xml import Element
from raybundle.io.scenes.base import element_text
from raybundle.numerics.arrays import Array
from raybundle.scenes.linescan import LineScene
from raybundle.scenes.model_agreement import model_agreement
from raybundle.scenes.rpc import Rpc
from raybundle.scenes.trajectory import rotation_from_quaternion

UNITS = {
    **dict.fromkeys(("deg", "degree", "degrees"), "degrees"),
    **dict.fromkeys(("rad", "radian", "radians"), "radians"),
}
SAME_PX = 0.1
"""Displacement at the end of the array below which the unit makes no difference."""
CLEARER = 4.0
"""Ratio of the distances of the array's middle from the axis from which on the nearer one decides."""


@dataclass(frozen=True, slots=True, kw_only=True)
class Mounting:
    """Place of the detector array in the camera, and of the camera in the satellite."""

    angle: float
    """DETROTANGLE as written"""
    unit: str
    """"degrees", "radians", or "" where the file states none"""
    origin: Array
    """(2,) of the first element [mm]"""
    pitch: float
    distance: float
    """principal distance [mm]"""
    rotation: Array
    """(3, 3) satellite axes from camera axes"""
    element: Element

    def place(self, x: Array, angle: float) -> Array:
        """(n, 2) places [mm] of elements x [px] for a rotation angle [rad]."""
        along = -(x - 0.5) * self.pitch
        return np.stack([self.origin[0] - np.sin(angle) * along, self.origin[1] + np.cos(angle) * along], axis=1)

    def look(self, x: Array, angle: float) -> Array:
        """(n, 2) tangents of the viewing directions in the satellite's axes."""
        d = np.concatenate([self.place(x, angle), np.full((len(x), 1), self.distance)], axis=1) @ self.rotation.T
        if not (d[:, 2] > 0).all():
            self.element.fail("maxar.camera_backwards")
        return d[:, :2] / d[:, 2:]


def read_mounting(root: Element, geo: Element) -> Mounting:
    """The mounting of the band of this file."""
    mounting = geo.get("DETECTOR_MOUNTING")
    band = element_text(root, "IMD", "BANDID")
    group = mounting.find(f"BAND_{band}") or (mounting.children[-1] if mounting.children else None)
    if group is None:
        mounting.fail("maxar.no_band")
    array = group.get("DETECTOR_ARRAY")
    camera = geo.get("CAMERA_ATTITUDE")
    q = np.array([[camera.number(f"QCS{k}") for k in (1, 2, 3, 4)]])
    return Mounting(
        angle=array.number("DETROTANGLE"),
        unit=_stated(array.get("DETROTANGLE")),
        origin=np.array([array.number("DETORIGINX"), array.number("DETORIGINY")]),
        pitch=array.number("DETPITCH"),
        distance=geo.get("PRINCIPAL_DISTANCE").number("PD"),
        rotation=rotation_from_quaternion(q)[0],
        element=camera,
    )


def _stated(element: Element) -> str:
    for name, value in element.attributes.items():
        if name.lower() in {"unit", "units", "uom"}:
            unit = UNITS.get(value.strip().lower())
            if unit is None:
                element.fail("value.unit_unknown", unit=quoted(value), known=list(UNITS))
            return unit
    return ""


def chosen_angle(
    mounting: Mounting, columns: int, scene: Callable[[float], LineScene], rpc: Rpc | None
) -> tuple[float, list[Message]]:
    """The rotation angle [rad], and a remark where its unit was not stated and matters."""
    angles = {"degrees": float(np.radians(mounting.angle)), "radians": mounting.angle}
    if mounting.unit:
        return angles[mounting.unit], []

    ends = [mounting.place(np.array([0.5, float(columns)]), a) for a in angles.values()]
    apart = float(np.linalg.norm(ends[0] - ends[1], axis=1).max()) / mounting.pitch
    if apart < SAME_PX:
        return angles["degrees"], []
    if rpc is not None:
        rms = {unit: _rms(scene, angle, rpc) for unit, angle in angles.items()}
        unit = min(rms, key=lambda u: rms[u])
        if unit == "degrees":
            return angles[unit], []
        finite = bool(np.isfinite(rms["degrees"]))
        compared = note(
            "maxar.radians_by_rpc", angle=mounting.angle, rms_px=rms[unit], meets=finite,
            rms_degrees_px=rms["degrees"] if finite else None,
        )  # fmt: skip
        return angles[unit], [compared]
    middle = np.array([columns / 2])
    off = {u: float(np.linalg.norm(mounting.place(middle, a))) / mounting.pitch for u, a in angles.items()}
    nearer, other = sorted(off, key=lambda u: off[u])
    if off[other] > CLEARER * off[nearer] and off[other] - off[nearer] > columns / CLEARER:
        if nearer == "degrees":
            return angles[nearer], []
        nearest = note("maxar.radians_by_axis", angle=mounting.angle, off_px=off[nearer], off_degrees_px=off[other])
        return angles[nearer], [nearest]
    return angles["degrees"], [note("maxar.degrees_assumed", angle=mounting.angle, apart_px=apart)]


def _rms(scene: Callable[[float], LineScene], angle: float, rpc: Rpc) -> float:
    try:
        return model_agreement(scene(angle), rpc).rms_px
    except RaybundleError:
        return float("inf")
