"""What learned feature methods share: a reduced image, descriptors in bytes, matching by LightGlue.

Torch, kornia and the packages with the weights are imported when the first image or pair is worked on.
"""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

import numpy as np

from raybundle.matching.features import Described, Features, spread
from raybundle.numerics.arrays import Array, Index

INSTALL = "pip install 'raybundle[learned]'"
RADIUS = 4.0
"""Scale that features are given, in pixels of the reduced image."""


def load_torch() -> Any:
    """Torch, one thread for each of ours: they work on different images, and sums do not depend on their number."""
    import torch  # pyright: ignore[reportMissingImports]

    torch.set_num_threads(1)
    return torch


def reduced(grey: Array, longest_px: int, multiple: int) -> tuple[Array, Array]:
    """An image (h, w) no longer than wanted, its sides multiples of a number, and its pixel in original pixels (2,).

    Networks have seen photographs of this size, and recognise the surroundings of a point of some ten pixels: reduced
    images show more of them, and the precision comes from least-squares matching afterwards.
    """
    import cv2

    h, w = grey.shape
    factor = min(1.0, longest_px / max(h, w))
    size = [int(side * factor) // multiple * multiple for side in (w, h)]
    if min(size) == 0:
        return np.zeros((0, 0), np.uint8), np.ones(2)
    return cv2.resize(grey, size, interpolation=cv2.INTER_AREA), np.array([w, h]) / size


def chosen_features(
    xy_small: Array, strength: Array, unit_vectors: Array, pixel: Array, shape: tuple[int, ...], count: int
) -> Features:
    """At most `count` of the points (n, 2) [index of a pixel of the reduced image], spread over the format.

    pixel  (2,) size of that pixel in pixels of the image of this shape (h, w)
    They have no direction, and all the same scale.
    """
    xy = (xy_small.astype(float) + 0.5) * pixel
    rows = spread(xy, strength, count, shape[1], shape[0])
    n = len(rows)
    return Features(
        xy_px=xy[rows], scale_px=np.full(n, RADIUS * pixel.mean()), angle=np.zeros(n),
        descriptors=to_bytes(unit_vectors[rows]),
    )  # fmt: skip


def to_bytes(unit_vectors: Array) -> Array:
    """Unit vectors (n, k) as uint8; 128 is zero."""
    return (np.round(unit_vectors * 127) + 128).astype(np.uint8)


def from_bytes(descriptors: Array) -> Array:
    """Unit vectors (n, k) float32 of `to_bytes`."""
    v = descriptors.astype(np.float32) - 128
    return v / np.maximum(np.linalg.norm(v, axis=1, keepdims=True), 1)


def light_glue(settings: Mapping[str, object], weights: Mapping[str, Any]) -> Any:
    """LightGlue (Lindenberger et al. 2023) with given weights, ready to match."""
    from kornia.feature.lightglue import LightGlue  # pyright: ignore[reportMissingImports]

    net = LightGlue(None, **settings)
    state = dict(weights)
    for i in range(net.conf.n_layers):
        for kind in ("self_attn", "cross_attn"):
            state = {k.replace(f"{kind}.{i}.", f"transformers.{i}.{kind}."): v for k, v in state.items()}
    known = net.state_dict()
    net.load_state_dict({**known, **{k: v for k, v in state.items() if k in known}})
    return net.eval()


def glued(net: Any, first: Described, second: Described) -> Index:
    """Matches (k, 2) that a LightGlue finds between two images."""
    if not len(first.xy_px) or not len(second.xy_px):
        return np.zeros((0, 2), np.int32)
    torch = load_torch()

    def side(one: Described) -> dict[str, Any]:
        return {
            "keypoints": torch.from_numpy(one.xy_px.astype(np.float32))[None],
            "descriptors": torch.from_numpy(from_bytes(one.descriptors))[None],
            "image_size": torch.tensor([one.size_px]),
        }

    with torch.inference_mode():
        found = net({"image0": side(first), "image1": side(second)})["matches"][0].numpy()
    return found.astype(np.int32)
