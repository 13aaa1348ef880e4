"""Bundler bundle.out and its list of images, written.

The camera frame is ours (x right, y up, the view along -z); the principal point is the image centre, so what a
calibrated principal point or decentring distortion moves is lost, and stated.
"""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path

import numpy as np

from raybundle.cameras.conversions import forward_fit
from raybundle.errors import InputError
from raybundle.io.digits import exact
from raybundle.io.formats.base import Draft, Export, Format, Scene, deviation_remark, register, scene


def write(export: Export, path: Path) -> Draft:
    """Write version 0.3, and beside it NAME-list.txt with the names of the images."""
    s = scene(export)
    fitted: list[tuple[float, float, float]] = []
    deviations: list[tuple[str, str, float]] = []
    for camera in s.cameras:
        if camera.sensor.all_round:
            raise InputError("camera.not_in_format", camera=camera.id, kind="fisheye", format="bundle.out")
        fit = forward_fit(camera, ("fx", "k1", "k2"), centred=True)
        fitted.append((fit.camera.fx, fit.camera.k1, fit.camera.k2))
        deviations.append((camera.id, "f, k1, k2", fit.deviation_px))
    lines = ["# Bundle file v0.3", f"{len(s.names)} {len(s.xyz)}"]
    t = -np.einsum("nij,nj->ni", s.rotation, s.centre)
    for k in range(len(s.names)):
        lines.append(_row(fitted[int(s.camera[k])]))
        lines += [_row(row) for row in s.rotation[k].tolist()]
        lines.append(_row(t[k].tolist()))
    views = _views(s)
    for k, xyz in enumerate(s.xyz.tolist()):
        lines += [_row(xyz), " ".join(map(str, s.colours[k].tolist())), " ".join([str(len(views[k])), *views[k]])]
    path.write_text("\n".join(lines) + "\n", encoding="utf-8")
    path.with_name(f"{path.stem}-list.txt").write_text("\n".join(s.names) + "\n", encoding="utf-8")
    remarks, largest = deviation_remark(deviations)
    return Draft(remarks=(*s.remarks, *remarks), deviation_px=largest)


def _views(s: Scene) -> list[list[str]]:
    """Per point: image, row in its list, x right and y up from the image centre [px]."""
    size = np.array([(c.width_px, c.height_px) for c in s.cameras], float)[s.camera[s.image]].reshape(-1, 2)
    xy = ((s.xy_px - size / 2) * [1, -1]).tolist()
    first = np.searchsorted(s.image, np.arange(len(s.names)))
    views: list[list[str]] = [[] for _ in range(len(s.xyz))]
    for row, (image, point) in enumerate(zip(s.image.tolist(), s.point.tolist(), strict=True)):
        views[point].append(f"{image} {row - int(first[image])} {exact(xy[row][0])} {exact(xy[row][1])}")
    return views


def _row(values: Sequence[float]) -> str:
    return " ".join(exact(v) for v in values)


register(
    Format(
        name="bundler",
        title="Bundler bundle.out and its list of images",
        kind="file",
        colours=True,
        suffix=".out",
        write=write,
    )
)
