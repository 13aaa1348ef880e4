"""Run calibsense over board views in its own Python: peer_calibsense.py VIEWS.npz prints fx, fy, cx, cy, covariance."""

import json
import sys

import numpy as np
from calibsense import (
    CalibrationSession,
    Checkerboard,
    ObservationSet,
    RefitOptions,
    ViewObservations,
    instrument,
)

data = np.load(sys.argv[1])
columns, rows = int(data["column"].max()) + 1, int(data["row"].max()) + 1
board = Checkerboard(columns=columns, rows=rows, square_size=float(data["spacing_mm"]))
views = []
for k in np.unique(data["view"]):
    mine = data["view"] == k
    ids = data["row"][mine] * columns + data["column"][mine]
    views.append(ViewObservations(view_id=str(k), point_ids=ids, image_points=data["xy"][mine]))
size = tuple(int(x) for x in data["size"])
session = CalibrationSession(observations=ObservationSet(target=board, image_size=size, views=tuple(views)))
fit = instrument(session, RefitOptions(model="pinhole", distortion_terms=int(data["terms"])))
names = list(fit.covariance.intrinsic_names)
at = [names.index(n) for n in ("fx", "fy", "cx", "cy")]
values = [float(getattr(fit.camera, n)) for n in ("fx", "fy", "cx", "cy")]
print(json.dumps({"values": values, "covariance": fit.covariance.intrinsic[np.ix_(at, at)].tolist()}))
