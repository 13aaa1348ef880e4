"""A click brought to the picture: the part around it, the kind that was asked for, the first picture of a point."""

from __future__ import annotations

from typing import Any

import cv2
import numpy as np

from raybundle.errors import InputError, phrase
from raybundle.measuring.fiducials import Found, find_fiducials
from raybundle.measuring.predict import affine
from raybundle.measuring.snap import MARGIN_PX, REACH_PX, Reference, Snapped, snap
from raybundle.measuring.snap import Found as Taken
from raybundle.measuring.state import How
from raybundle.numerics.arrays import Array
from raybundle.studio.desk import Desk, named

LARGEST = 1e9
"""Pixels of a place, and more."""
KINDS = ("auto", "ellipse", "corner", "cross", "patch")


def snapped(desk: Desk, given: dict[str, Any]) -> dict[str, Any]:
    """Place and covariance, or why there is none.

    given  image, x, y [px], kind, point, reach: how far the click is moved at most [px]
    """
    image, kind, point = str(given.get("image", "")), given.get("kind", "auto"), str(given.get("point", ""))
    k = named(desk, image)
    x, y = _number(given, "x"), _number(given, "y")
    desk.session.known.inside(image, x, y)
    if kind not in KINDS:
        raise InputError("value.not_one_of", entry="kind", given=str(kind), known=list(KINDS))
    reach = _number(given, "reach") if "reach" in given else REACH_PX
    part, corner = _part(desk, k, x, y)
    reference = _reference(desk, point, image) if point and kind in {"auto", "patch"} else None
    if kind == "patch" and reference is None:
        return {"why": phrase("studio_point.patch_reference")}
    found = snap(part, x - corner[0], y - corner[1], kind, reference, reach_px=reach)
    if not isinstance(found, Snapped):
        return {"why": found.why}
    return {
        "x": found.x_px + corner[0], "y": found.y_px + corner[1], "cov": list(found.covariance), "how": found.kind,
        "quality": found.quality,
    }  # fmt: skip


def fiducials_found(desk: Desk, image: str) -> Found:
    """The other fiducial marks of a scan."""
    if desk.scans is None:
        raise InputError("fiducial.no_scans")
    k = named(desk, image)
    size = desk.session.known.size_px[image]
    return find_fiducials(desk.journal.state, image, desk.scans, size, lambda x, y: _part(desk, k, x, y))


def _number(given: dict[str, Any], name: str) -> float:
    value = given.get(name)
    if isinstance(value, bool) or not isinstance(value, int | float) or not abs(value) < LARGEST:
        raise InputError("setting.no_number", name=name, given=str(value))
    return float(value)


def _part(desk: Desk, image: int, x: float, y: float) -> tuple[Array, tuple[int, int]]:
    """The grey picture around a place, and its first pixel."""
    whole = desk.tiles.pixels(image)
    h, w = whole.shape[:2]
    left, top = max(int(x) - MARGIN_PX, 0), max(int(y) - MARGIN_PX, 0)
    part = np.ascontiguousarray(whole[top : min(int(y) + MARGIN_PX, h), left : min(int(x) + MARGIN_PX, w)])
    grey = part if part.ndim == 2 else cv2.cvtColor(part, cv2.COLOR_RGB2GRAY)
    return np.asarray(grey), (left, top)


def _reference(desk: Desk, point: str, image: str) -> Reference | None:
    """The point in the first image in which it is marked, and how that picture turns into this one."""
    state = desk.journal.state
    for other, mark in state.marks_of(point).items():
        k = desk.session.index.get(other)
        if other == image or k is None or k not in desk.tiles.paths:
            continue
        part, corner = _part(desk, k, mark.x_px, mark.y_px)
        turn = affine(desk.session, state, point, other, image)
        kinds: dict[How, Taken] = {"ellipse": "ellipse", "corner": "corner", "cross": "cross"}
        kind = kinds.get(mark.how, "patch")
        return Reference(grey=part, x_px=mark.x_px - corner[0], y_px=mark.y_px - corner[1], affine=turn, kind=kind)
    return None
