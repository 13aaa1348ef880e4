"""Three photographs of the rendered portal at half their size, with their block: small enough for tests."""

from dataclasses import replace
from pathlib import Path

import cv2
import numpy as np

from raybundle.block.select import select_block
from raybundle.io.block.folder import read_block, write_block

PORTAL = Path(__file__).parents[2] / "demo_data/portal"
NAMES = ("portal_02.jpg", "portal_03.jpg", "portal_08.jpg")


def half_portal(folder: Path, by: int = 2) -> Path:
    """Write photographs, and the block into folder/block; the folder.

    by  how many times smaller photographs are
    """
    block = read_block(PORTAL / "truth")
    block = select_block(block, "image", np.isin(block.images.file, NAMES))
    rays = np.bincount(block.observations.point, minlength=len(block.points))
    block = select_block(block, "point", rays > 1)
    o, (camera,) = block.observations, block.cameras
    camera = replace(
        camera, width_px=camera.width_px // by, height_px=camera.height_px // by,
        pixel_mm=(by * camera.pixel_mm[0], by * camera.pixel_mm[1]), estimate=(),
    )  # fmt: skip
    rng = np.random.default_rng(1)
    xy = o.xy_px / by + rng.normal(0, 0.1, o.xy_px.shape)
    cov = np.tile([0.01, 0.01, 0.0], (len(o), 1))
    block = replace(block, cameras=(camera,), observations=replace(o, xy_px=xy, cov_px2=cov))
    for name in NAMES:
        grey = cv2.imread(str(PORTAL / "photos" / name), cv2.IMREAD_COLOR | cv2.IMREAD_IGNORE_ORIENTATION)
        cv2.imwrite(
            str(folder / name.replace(".jpg", ".png")),
            cv2.resize(grey, None, fx=1 / by, fy=1 / by, interpolation=cv2.INTER_AREA),
        )
    images = replace(block.images, file=tuple(f.replace(".jpg", ".png") for f in block.images.file))
    write_block(replace(block, images=images), folder / "block")
    return folder
