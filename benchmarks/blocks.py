"""Benchmark problems (npz of the shared generator, or BAL) as blocks with the model `radial`."""

from __future__ import annotations

from pathlib import Path

import numpy as np

from raybundle.block import Block, Camera, Images, Observations, Points
from raybundle.numerics.rotation import rotation_from_vector


def block_from_npz(path: Path | str, *, truth: bool = False) -> Block:
    """A block from an npz file: y down and z forward there, y up and -z forward here; pixels of 1 mm."""
    data = np.load(path)
    cam = data["cam" if truth else "cam0"]
    n, p, m = len(cam), len(data["pts0"]), len(data["ci"])
    flip = np.diag([1.0, -1.0, -1.0])
    R = rotation_from_vector(cam[:, :3])
    centre = -np.einsum("nji,nj->ni", R, cam[:, 3:6])
    camera = Camera(
        id="1",
        model="radial",
        width_px=3000,
        height_px=2000,
        pixel_mm=(1.0, 1.0),
        values={"c": float(cam[0, 6]), "k1": 0.0, "k2": 0.0},
        estimate=("c", "k1", "k2"),
        interior="per_image",
    )
    return Block(
        name=Path(path).stem,
        cameras=(camera,),
        images=Images(
            ids=tuple(str(i) for i in range(n)),
            camera=np.zeros(n, np.int32),
            file=("",) * n,
            centre=centre,
            rotation=flip @ R,
            interior={
                i: {"c": float(f), "k1": float(k1), "k2": float(k2)} for i, (f, k1, k2) in enumerate(cam[:, 6:9])
            },
        ),
        observations=Observations(
            image=data["ci"].astype(np.int32),
            point=data["pi"].astype(np.int32),
            xy_px=data["xy"] + [1500, 1000],
            cov_px2=np.tile([1.0, 1.0, 0.0], (m, 1)),
        ),
        points=Points(
            ids=tuple(str(i) for i in range(p)),
            role=np.zeros(p, np.int32),
            xyz=data["pts" if truth else "pts0"].copy(),
            sigma=np.full((p, 3), np.nan),
        ),
    )
