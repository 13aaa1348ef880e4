"""What images that do not fit come from is named: another camera constant, pixels, a single image, the unit."""

from dataclasses import replace

import numpy as np
import pytest

from raybundle import adjust
from raybundle.adjustment.records.options import AdjustmentOptions
from raybundle.errors import NotSolvable, message
from raybundle.orientation.approximate import approximate_values
from raybundle.placing.image_blunders import origin_message
from raybundle.planning.simulate import Survey, simulate
from raybundle.planning.synthetic_networks import Ring, TargetField, field_scene, ring_scene

OPTIONS = AdjustmentOptions(jobs=1)
SCENES = {"testfield": lambda: field_scene(TargetField(stations=4)), "ring": lambda: ring_scene(Ring())}


def simulated(kind="testfield", **survey):
    return simulate(SCENES[kind](), Survey(seed=6, scale_bars=2, **survey)).observed


def fault(block, options=OPTIONS):
    """The first fault, or the error."""
    try:
        return adjust(block, options).notices[0]
    except NotSolvable as error:
        return str(error)


def zoomed(block, images, factor):
    o, camera = block.observations, block.cameras[0]
    middle = np.array([camera.width_px, camera.height_px]) / 2
    mine = np.isin(o.image, images)[:, None]
    return replace(block, observations=replace(o, xy_px=np.where(mine, middle + factor * (o.xy_px - middle), o.xy_px)))


@pytest.mark.parametrize(("kind", "count", "factor"), [
    ("testfield", 1, 0.9), ("testfield", 3, 1.02), ("testfield", 4, 0.97), ("ring", 10, 1.05),
])  # fmt: skip
def test_images_of_another_camera_constant_are_named(kind, count, factor):
    block = simulated(kind)
    notice = fault(zoomed(block, range(count), factor))
    mine, others = block.images.ids[:count], block.images.ids[count:]
    assert notice.code == "image_contradicts"
    if 2 * count == len(block.images):
        assert notice.ids in (mine, others)
    else:
        assert notice.ids == mine
    ratio = factor if notice.ids == mine else 1 / factor
    assert notice.values["ratio"] == pytest.approx(ratio, rel=2e-3)


@pytest.mark.parametrize("reject", ["none", "snooping"])
@pytest.mark.parametrize(("count", "factor", "seed"), [(3, 1.05, 1), (3, 0.95, 2), (2, 1.08, 3), (1, 1.05, 4)])
def test_no_other_image_is_named_and_snooping_does_not_hide_them(reject, count, factor, seed):
    block = simulate(SCENES["testfield"](), Survey(seed=seed, scale_bars=2)).observed
    images = np.random.default_rng(seed).choice(len(block.images), count, replace=False)
    notice = fault(zoomed(block, images, factor), replace(OPTIONS, reject=reject))
    assert (notice.code, set(notice.ids)) == ("image_contradicts", {block.images.ids[k] for k in images})


@pytest.mark.parametrize("ratio", [1.25, 1.02, 0.9])
def test_pixels_that_are_not_square_are_named(ratio):
    block = simulated()
    camera = block.cameras[0]
    other = replace(camera, pixel_mm=(camera.pixel_mm[0], camera.pixel_mm[1] * ratio))
    notice = fault(replace(block, cameras=(other,)))
    assert notice.code == "camera_contradicts"
    assert notice.variant == "pixels"
    (height,) = notice.details
    assert height.values["camera"] == "1"
    assert height.values["factor"] == pytest.approx(1 / ratio, rel=2e-3)


@pytest.mark.parametrize(("kind", "image"), [("testfield", 0), ("testfield", 5), ("ring", 11)])
def test_an_image_whose_points_have_the_names_of_others_is_named(kind, image):
    block = simulated(kind)
    o, point = block.observations, block.observations.point.copy()
    rows = np.flatnonzero(o.image == image)
    point[rows] = np.roll(point[rows], 1)
    notice = fault(replace(block, observations=replace(o, point=point)))
    assert (notice.code, notice.ids) == ("image_contradicts", (block.images.ids[image],))


@pytest.mark.parametrize("origin", [0.0, 0.5])
def test_image_points_in_mm_are_named(origin):
    block = simulated()
    o, camera = block.observations, block.cameras[0]
    size = np.array([camera.width_px, camera.height_px])
    xy = (o.xy_px - origin * size) * np.array(camera.pixel_mm)
    found = fault(replace(block, observations=replace(o, xy_px=xy)))
    assert " in mm, " in (found if isinstance(found, str) else found.text)


AXES = {
    "the origin in the middle of the image": lambda xy, size: xy - size / 2,
    "the origin in the middle of the image and y counted upward": lambda xy, size: (xy - size / 2) * [1, -1],
    "y counted upward": lambda xy, size: xy * [1, -1] + size * [0, 1],
    "x counted to the left": lambda xy, size: xy * [-1, 1] + size * [1, 0],  # the former turned by 180 degrees
    "x and y exchanged": lambda xy, size: xy[:, ::-1] + 0 * size,
}


def counted_otherwise(block, images, way):
    o, camera = block.observations, block.cameras[0]
    other = AXES[way](o.xy_px, np.array([camera.width_px, camera.height_px], float))
    mine = np.isin(o.image, images)[:, None]
    return replace(block, observations=replace(o, xy_px=np.where(mine, other, o.xy_px)))


@pytest.mark.parametrize("kind", ["testfield", "ring"])
@pytest.mark.parametrize("way", [w for w in AXES if "middle" in w])
@pytest.mark.parametrize("images", [[0], [0, 2, 3], [0, 1, 2, 3]])
def test_images_counted_from_their_middle_are_named_all_of_them(kind, way, images):
    block = counted_otherwise(simulated(kind), images, way)
    found = fault(block)
    words = found if isinstance(found, str) else found.text
    names = [block.images.ids[k] for k in images]
    assert message("image_contradicts.origin", n=len(names), names=names).text() in words


@pytest.mark.parametrize("way", AXES)
def test_an_image_with_other_axes_that_cannot_be_oriented_names_them(way):
    axes = {
        "the origin in the middle of the image": "middle",
        "the origin in the middle of the image and y counted upward": "middle_mirrored",
        "x and y exchanged": "exchanged",
    }
    with pytest.raises(NotSolvable, match=r"orientation\.not_found") as error:
        approximate_values(counted_otherwise(simulated(orientation="absent"), [1], way))
    (image,) = error.value.message.details
    (found,) = image.details
    assert (found.code, found.values["axes"]) == ("not_oriented.axes", axes.get(way, "mirrored"))


def test_images_with_points_under_wrong_names_have_the_axes_of_the_others():
    block = simulated(orientation="absent")
    o = block.observations
    mine = np.flatnonzero(o.image == 1)
    mixed = o.xy_px.copy()
    mixed[mine] = mixed[np.random.default_rng(1).permutation(mine)]
    with pytest.raises(NotSolvable) as error:
        approximate_values(replace(block, observations=replace(o, xy_px=mixed)))
    codes = [d.code for d in error.value.message.details]
    assert "not_oriented.no_pose" in codes
    assert "not_oriented.axes" not in str(error.value.message.details)


@pytest.mark.parametrize("kind", ["testfield", "ring"])
def test_right_images_are_counted_from_their_corner(kind):
    assert origin_message(simulated(kind)) is None
