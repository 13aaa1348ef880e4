"""Missions that several tests plan."""

import numpy as np

from raybundle.missions.build import Task, plan_mission
from raybundle.missions.patterns import Wish, patterns
from raybundle.missions.terrain import level_ground
from raybundle.missions.vehicle import KNOWN

CRS = "EPSG:32632"
PLACE = np.array([364_000.0, 5_551_600.0])
OUTLINES = {
    "area": np.array([[0.0, 0], [300, 50], [280, 260], [-10, 200]]) + PLACE,
    "line": np.array([[0.0, 0], [100, 20], [160, 80]]) + PLACE,
    "place": np.array([[0.0, 0], [10, 0], [10, 8], [0, 8]]) + PLACE,
}
VEHICLE, CAMERA = KNOWN["mavic-3e"]
LEVEL = level_ground(100.0)


def wish(pattern, **more):
    gsd = 0.02 if patterns[pattern].ground else 0.005
    given = {"heights": (0.0, 20.0), "width": 60.0, "overlap": (0.8, 0.7), "distance": CAMERA.distance(gsd)}
    return Wish(camera=CAMERA, **{**given, **more})


def mission(pattern, *, ground=LEVEL, outline=None, more=None, **task):
    given = {"vehicle": VEHICLE, "crs": CRS, "take_off": tuple(PLACE - 20), "ground": ground}
    outline = OUTLINES[patterns[pattern].shape] if outline is None else outline
    return plan_mission(Task(pattern=pattern, outline=outline, wish=wish(pattern, **(more or {})), **{**given, **task}))


ACROSS_30 = {"tilt_deg": 30.0, "headings": False, "control": 0}
"""Values of the change of a flight that adds lines across"""


def change(forecast):
    """Code and values of the change of a flight."""
    found = forecast.name.message
    return found.code, found.values
