"""Push-frame and frame ISD JSON of the Community Sensor Model (UsgsAstroPushFrameSensorModel, ...FrameSensorModel).

Framelet k = floor(line / h) of `framelet_height` / `detector_line_summing` lines, without `num_lines_overlap`, is taken
at starting_ephemeris_time + exposure_duration / 2 + k interframe_delay; its lines may be flipped, the order of the
framelets reversed.  A frame is one framelet, taken at the centre time.
"""

from __future__ import annotations

from collections.abc import Callable

import numpy as np

from raybundle.io.reading.trees import Json
from raybundle.numerics.arrays import Array

PUSH_FRAME = "USGS_ASTRO_PUSH_FRAME_SENSOR_MODEL"
ACROSS, ALONG = 257, 9
"""Nodes of a framelet at which viewing directions are computed where the optics distort."""


def frame_keys(
    root: Json, rows: int, columns: int, focal_plane: Callable[[Json, Array, Array], Array]
) -> dict[str, Array | float | int]:
    """Framelets, their times [s after the centre] and viewing directions: what a push-frame scene has beside others.

    focal_plane  viewing directions (n, 2) at samples and lines (n,) of the detector
    """
    pushed = root.get("name_model").text() == PUSH_FRAME
    summing = root.get("detector_line_summing").positive()
    overlap, flipped = root.optional("num_lines_overlap"), False
    height, times = float(rows), np.zeros(1)
    if pushed:
        whole = root.get("framelet_height").positive()
        height = (whole - overlap) / summing
        count = int(rows // (whole / summing)) if height > 0 else 0
        delay = root.get("interframe_delay").number()
        if count < 1 or delay <= 0 or overlap % 2:
            root.get("framelet_height").fail("isd.framelets", height=height, lines=rows, delay_s=delay, overlap=overlap)
        start = root.get("starting_ephemeris_time").number() - root.get("center_ephemeris_time").number()
        times = start + root.get("exposure_duration").positive() / 2 + delay * np.arange(count)
        times = times[::-1].copy() if root.get("framelet_order_reversed").truth() else times
        flipped = root.get("framelets_flipped").truth()
    distorted = root.has("optical_distortion")
    x = np.linspace(0, columns, ACROSS if distorted else 2)
    at = np.linspace(0, height, ALONG if distorted else 2)
    lines = (height - at if flipped else at) + overlap / 2
    look = np.stack([focal_plane(root, x, np.full(len(x), y)) for y in lines.tolist()])
    return {
        "framelet_px": height, "framelet_times": times, "look_x": x, "look_l": at, "look": look,
        "height_px": round(height * len(times)),
    }  # fmt: skip
