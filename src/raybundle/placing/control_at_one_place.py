"""Control that lies in one place, by which nothing can be placed: found before anything is computed."""

from __future__ import annotations

import numpy as np

from raybundle.block import Role
from raybundle.errors import InputError
from raybundle.placing.marks import Given

ROUNDING = 1e-12
"""Share of the largest coordinate up to which two are the same number, written differently."""
SHOWN = 10


def check_apart(given: Given) -> None:
    """Raise InputError where two or more control points are given and all of them have the same coordinates.

    Two places at least are needed for position, direction and scale.  One name and a second one for the same point are
    allowed beside others, and a single control point is: it claims nothing that it cannot show.
    """
    control = [
        (name, file.xyz[k], file)
        for file in given.control
        for k, name in enumerate(file.ids)
        if int(file.role[k]) == Role.CONTROL and np.isfinite(file.xyz[k, :2]).all()
    ]
    if len(control) < 2 or len({file.crs for _, _, file in control}) > 1:
        return
    xyz = np.array([at for _, at, _ in control])
    apart = np.nan_to_num(np.abs(xyz - xyz[0]))  # heights that are not known show nothing
    if (apart > ROUNDING * np.nan_to_num(np.abs(xyz)).max(axis=0)).any():
        return
    names = [name for name, _, _ in control]
    raise InputError(
        "control.one_place", n=len(names), names=names, coordinates=[f"{v:.12g}" for v in xyz[0][np.isfinite(xyz[0])]],
        file=control[0][2].path,
    )  # fmt: skip
