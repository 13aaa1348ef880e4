"""Photographs that get a camera of their own leave the group of the old one."""

from types import SimpleNamespace

from raybundle.io.photos.cameras import CameraGroup
from raybundle.workflows.orienting.adjustment import with_cameras_apart


def test_photographs_move_to_the_group_of_their_own_camera():
    group = CameraGroup(
        id="a", name="a", photos=(0, 1, 2), width_px=30, height_px=20, pixel_mm=(1.0, 1.0), c_mm=25.0, sigma_c_mm=1.0,
        source="",
    )  # fmt: skip
    photos = [SimpleNamespace(name=n) for n in ("p", "q", "r")]
    found = with_cameras_apart([group], {"q": ("a", "a-2")}, photos)
    assert [(g.id, g.photos) for g in found] == [("a", (0, 2)), ("a-2", (1,))]
