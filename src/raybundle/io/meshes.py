"""Meshes of objects: PLY, OBJ, STL and what else trimesh reads, as surfaces in metres."""

from __future__ import annotations

import logging
from pathlib import Path
from typing import Any

import numpy as np

from raybundle.errors import InputError, phrase
from raybundle.io.reading.files import check_regular
from raybundle.objects.surface import Surface

SUFFIXES = (".ply", ".obj", ".stl", ".off", ".glb")
MOST = 5_000_000
"""Triangles; rays against more of them are not needed to plan photographs"""


def read_mesh(path: Path, unit: float = 1.0) -> Surface:
    """The triangles of a mesh file.

    unit    metres of one unit of the file
    raises  InputError where the file is no mesh, is damaged, or holds no triangles
    """
    logging.getLogger("trimesh").setLevel(logging.CRITICAL)
    import trimesh

    check_regular(path)
    try:
        mesh: Any = trimesh.load(path, force="mesh", process=False)
    except (MemoryError, RecursionError):
        raise
    except Exception as error:  # noqa: BLE001  (a reader of many formats raises many kinds)
        detail = str(error).splitlines()[0][:200] if str(error) else type(error).__name__
        raise InputError("mesh.not_readable", detail=detail, file=path) from None
    triangles = np.asarray(getattr(mesh, "faces", np.zeros((0, 3))), np.int64)
    if not len(triangles):
        raise InputError("mesh.no_triangles", name=path.name, file=path)
    if len(triangles) > MOST:
        raise InputError("mesh.too_many_triangles", n=len(triangles), most=MOST, file=path)
    vertices = np.asarray(mesh.vertices, float) * unit
    try:
        Surface(name=path.stem, vertices=vertices, triangles=triangles)
    except InputError as error:
        raise error.at(path) from None
    x, y, z = np.ptp(vertices[np.unique(triangles)], axis=0)
    about = phrase("object_size.mesh", x_m=x, y_m=y, z_m=z, n=len(triangles))
    return Surface(name=path.stem, vertices=vertices, triangles=triangles, about=about)
