"""A small simulated block whose truth is known."""

from dataclasses import replace
from functools import cache

from raybundle.planning.simulate import Survey, simulate
from raybundle.planning.synthetic_networks import Ring, brown_camera, ring_scene


@cache
def simulation(seed=1, stations=14, control=5):
    camera = brown_camera(size_px=(3000, 2000), pixel_mm=0.008, estimate=("c", "x0", "y0", "K1"))
    scene = ring_scene(Ring(camera=camera, stations=stations, rings=1))
    survey = Survey(
        seed=seed, image_sigma_px=0.3, control=control, control_sigma=(0.002, 0.002, 0.002),
        orientation="exact", points="exact",
    )  # fmt: skip
    made = simulate(scene, survey)
    images = made.observed.images
    images = replace(images, file=tuple(f"ring/IMG_{name}.jpg" for name in images.ids))
    return replace(made, observed=replace(made.observed, images=images))


def small_block():
    return simulation().observed
