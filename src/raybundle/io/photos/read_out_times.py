"""Read-out times of rolling shutters of well-known cameras [s].

Measured by users of OpenDroneMap with blinking lamps (github.com/OpenDroneMap/ODM, opendm/rollingshutter.py, and
github.com/OpenDroneMap/RSCalibration, 2022-2024).  Some of these bodies have a mechanical shutter as well, and stop for
a photograph where a flight is planned so: a time here states what may be, not what was.
"""

from __future__ import annotations

from raybundle.io.photos.metadata import Metadata
from raybundle.io.photos.sensor_sizes import body_names

_MS: dict[str, float] = {
    "dji phantom vision fc200": 74, "dji fc200": 74,
    "dji fc300s": 33, "dji fc300c": 33, "dji fc300x": 33, "dji fc330": 33, "dji fc6310": 33,
    "dji fc350": 30, "dji fc7203": 20, "dji fc3170": 27, "dji fc3411": 32, "dji fc3582": 26,
    "hasselblad l1d 20c": 56,
    "yuneec e90": 44,
    "gopro hero4 black": 30, "gopro hero8 black": 17,
    "fujifilm x t2": 35,
    "teracube one": 32,
}  # fmt: skip


def read_out_time(metadata: Metadata) -> float | None:
    """Time in which a body that the table knows reads a frame of its largest format [s]; else None."""
    found = next((_MS[name] for name in body_names(metadata) if name in _MS), None)
    return None if found is None else found / 1000
