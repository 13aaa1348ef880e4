"""The network in three dimensions: one HTML file that needs no other and no network access."""

from __future__ import annotations

import json
import math
from base64 import b64encode
from collections.abc import Iterable
from dataclasses import dataclass, field, replace
from importlib.resources import files
from pathlib import Path
from typing import Any

import numpy as np
from markupsafe import Markup

from raybundle.adjustment.result import Adjustment
from raybundle.block import Block, Role
from raybundle.errors import Text, note, phrase
from raybundle.io.folders import new_files
from raybundle.numerics.arrays import Array, Index
from raybundle.objects.cloud import CloudSample
from raybundle.report.document import environment
from raybundle.report.figures.svg import spread_rows
from raybundle.report.languages import ENGLISH
from raybundle.report.languages.language import Language, language_of
from raybundle.report.network.detail import Detail, detail_of, shown_images
from raybundle.report.network.shape import frusta
from raybundle.report.network.sigma_classes import sigma_classes
from raybundle.report.text.words import datum_words
from raybundle.report.view import FREE_UNIT, View, view_of, with_near_viewpoints

MOST_ELLIPSOIDS = 2_000
"""Error ellipsoids that a page holds; those of control and check points before others."""
FAR = 4.0
"""Points farther from the middle than so many times what half of them lie within do not widen the first view: of evenly
spread points on a line none is farther than twice, on a disc or in a ball less"""


@dataclass(frozen=True, slots=True, kw_only=True)
class Planned:
    """What the page of a plan shows besides, and in the place of what residuals would show; lengths of the block."""

    covariance: Array
    """(p, 3, 3) of the object points"""
    image_words: tuple[str, ...]
    """(n,) what each image is there for"""
    remarks: tuple[str, ...]
    corners: Array = field(default_factory=lambda: np.zeros((0, 3, 3)))
    """(m, 3, 3) of the triangles of the object's surface"""
    sigma: Array = field(default_factory=lambda: np.zeros(0))
    """(m,) standard deviation that a coordinate would have there; NaN where less than two images see it"""
    proposed: tuple[int, ...] = ()
    """Images that are to be taken yet, where others were"""
    length_unit: str = "m"
    """Empty where nothing fixes the scale"""
    wanted: tuple[float, str] | None = None
    """Standard deviation of a coordinate that was wanted, and of what: worst or mean; None: none was"""


OF_PAGE = (
    "network_page.colour_of_points", "network_page.number_of_rays", "network_page.standard_deviation",
    "network_page.role", "network_page.sigma_of_object", "network_page.colour_of_dense_points",
    "network_page.own_colour", "network_page.source_photograph", "network_page.show", "network_page.dense_points",
    "network_page.object_points", "network_page.known_points", "network_page.images", "network_page.proposals",
    "network_page.object", "network_page.scale_bars", "network_page.ellipsoids", "network_page.enlarged",
    "network_page.first_view", "network_page.mouse", "network_page.click",
)  # fmt: skip
"""Texts of the page's template"""
OF_SCRIPT = (
    "network_page.tie_points", "network_page.control_points", "network_page.check_points", "network_page.tie_point",
    "network_page.control_point", "network_page.check_point", "network_page.rays_2", "network_page.rays_3",
    "network_page.rays_4", "network_page.rays_6", "network_page.rays_10", "network_page.image", "network_page.sigma",
    "network_page.rays", "network_page.click", "network_page.no_graphics",
)  # fmt: skip
"""Texts of the page's script"""


def texts_of(codes: Iterable[str], language: Language) -> dict[str, str]:
    """Texts in a language, by what is behind the dot of their codes."""
    return {code.partition(".")[2]: language.text(phrase(code)) for code in codes}


def write_network_page(
    adjustment: Adjustment, path: str | Path, planned: Planned | None = None, *, title: str = "",
    language: str = ENGLISH, cloud: CloudSample | None = None,
) -> None:  # fmt: skip
    """Write the network view: object points, images, control, scale bars, error ellipsoids and rays, to be turned.

    adjustment  any result; what it lacks (statistics, control, scale bars) is left out
    path        the HTML file; its folder exists; an older file is overwritten
    planned     of a plan: its object in colours of its precision, photographs that are to be taken yet
    title       what the page is called; empty: after the block
    language    of the page, as "de"; InputError for one that there is not
    cloud       dense points of the surface, to be coloured by photograph or by standard deviation

    For a page of at most 10 MB, points are thinned by a grid that keeps the worst, and images and ellipsoids evenly.
    The page reports this.  Limits: an ellipsoid describes random errors in the datum of the result; one that
    is enlarged is no distance.
    """
    view = with_near_viewpoints(view_of(adjustment))
    if planned is not None:
        view = _as_planned(view, planned)
    contents = network_contents(view)
    if planned is not None:
        contents |= _of_plan(contents, planned, view)
    if cloud is not None and len(cloud.xyz):
        contents |= _of_cloud(contents, cloud, view)
    say = language_of(language, [title, *view.given.points.ids, *view.given.images.ids, view.given.name])
    remarks: list[Text] = contents.pop("remarks")
    if "words" in contents["images"]:
        contents["images"]["words"] = [say.text(w) for w in contents["images"]["words"]]
    contents |= {"words": texts_of(OF_SCRIPT, say), "decimal": say.text(phrase("network_page.decimal"))}
    for classes in filter(None, contents["classes"].values()):
        classes["legend"] = [(colour, say.text(words)) for colour, words in classes["legend"]]
    html = (
        environment()
        .get_template("network.html.j2")
        .render(
            title=title or say.text(title_of(view.given.name, planned)),
            remarks=[say.text(w) for w in remarks],
            language=say.code,
            words=texts_of(OF_PAGE, say),
            data=Markup(_json(contents)),  # noqa: S704  (what could end the element is escaped by _json)
            program=Markup(_program()),  # noqa: S704  (our own script, built from web/network)
        )
    )
    with new_files(Path(path)) as (file,):
        file.write_text(html, encoding="utf-8")


def title_of(name: str, planned: Planned | None) -> str:
    """What the page is called."""
    if planned is not None and name:
        return f"{name[:1].upper()}{name[1:]}"
    return phrase("network_page.title", name=name)


def _program() -> str:
    """The page's script: three.js and our own code, built by `npm run build` in the folder web."""
    return (files("raybundle.report") / "templates" / "network.js").read_text(encoding="utf-8")


def _json(contents: dict[str, Any]) -> str:
    """JSON that cannot end the script element it stands in."""
    plain = json.dumps(contents, ensure_ascii=False, allow_nan=False, separators=(",", ":"))
    return plain.replace("&", "\\u0026").replace("<", "\\u003c").replace(">", "\\u003e")


def _packed(values: Array, kind: str) -> str:
    """An array as base64 of its little-endian bytes; the page knows shape and kind."""
    return b64encode(np.ascontiguousarray(values, dtype=kind).tobytes()).decode("ascii")


def network_contents(view: View) -> dict[str, Any]:
    """All that the page draws, relative to `origin`, and the sentences to be stated beside it ("remarks")."""
    detail, images = detail_of(view), shown_images(view)
    points = detail.points
    xyz, centre = view.adjusted.points.xyz[points], view.adjusted.images.centre[images]
    every = xyz if len(xyz) else centre
    origin = np.median(every, axis=0) if len(every) else np.zeros(3)
    extent = extent_of(xyz - origin)
    precision = view.adjustment.precision
    ellipsoids, axes_ = ellipsoids_of(view.given, None if precision is None else precision.object_points, points)
    starts, seen = _rays(view, points, images)
    bars = _bars(view, points)
    sigma = np.full((len(points), 3), np.nan) if view.std is None else view.std[points]
    decimals = max(0, 4 - math.floor(math.log10(extent)))
    return {
        "remarks": _remarks(view, detail, images, len(ellipsoids)),
        "unit": view.length_unit,
        "sigmaUnit": view.unit,
        "decimals": min(decimals, 9),
        "origin": origin.tolist(),
        "extent": extent,
        "basis": basis_of(view.adjusted, images, xyz, free=_free(view)).ravel().tolist(),
        "points": {
            "id": [view.given.points.ids[i] for i in points],
            "xyz": _packed(xyz - origin, "<f4"),
            "role": _packed(view.given.points.role[points], "u1"),
            "rays": _packed(np.minimum(view.rays[points], 65535), "<u2"),
            "sigma": _packed(sigma, "<f4"),
            "starts": _packed(starts, "<u4"),
            "seen": _packed(seen, "<u4"),
        },
        "images": {
            "id": [view.given.images.ids[i] for i in images],
            "frusta": _packed(frusta(view.adjusted, images, 1.0) - origin, "<f4"),
            "size": 0.06 * extent / max(1.0, math.sqrt(len(images) / 40)),
        },
        "ellipsoids": {
            "point": _packed(ellipsoids, "<u4"),
            "axes": _packed(axes_, "<f4"),
            "enlarged": _enlarged(axes_, extent),
        },
        "bars": _packed(bars, "<u4"),
        "surface": None,
        "classes": {"points": _classes(of_coordinates(sigma), view.unit), "surface": None},
    }


def of_coordinates(sigma: Array) -> Array:
    """(n,) standard deviation of a coordinate of points: root mean square of the three of each (n, 3)."""
    return np.sqrt(np.mean(np.square(sigma), axis=1))


def _classes(sigma: Array, unit: str, wanted: float | None = None, unknown: str = "") -> dict[str, Any] | None:
    found = sigma_classes(sigma, unit, wanted, unknown)
    return None if found is None else found.reported()


def _as_planned(view: View, planned: Planned) -> View:
    """The view with the standard deviations of a plan."""
    precision = view.adjustment.precision
    assert precision is not None
    std = np.sqrt(np.diagonal(planned.covariance, axis1=1, axis2=2))
    adjustment = replace(view.adjustment, precision=replace(precision, object_points=planned.covariance))
    factor, unit = (1000.0, "mm") if planned.length_unit == "m" else (1.0, planned.length_unit or FREE_UNIT)
    return replace(
        view, adjustment=adjustment, std=factor * std, factor=factor, unit=unit,
        length_unit=planned.length_unit or FREE_UNIT,
    )  # fmt: skip


def _of_plan(contents: dict[str, Any], planned: Planned, view: View) -> dict[str, Any]:
    images = shown_images(view)
    surface = {
        "xyz": _packed(planned.corners.reshape(-1, 3) - np.array(contents["origin"]), "<f4"),
        "sigma": _packed(view.factor * planned.sigma, "<f4"),
    }
    wanted = None if planned.wanted is None else view.factor * planned.wanted[0]
    sigma = of_coordinates(np.zeros((0, 3)) if view.std is None else view.std[shown_points(view)])
    return {
        "remarks": [contents["remarks"][0], *_wanted_words(planned, view), *planned.remarks],
        "images": contents["images"]
        | {
            "words": [planned.image_words[i] for i in images],
            "proposed": np.flatnonzero(np.isin(images, planned.proposed)).tolist(),
        },
        "surface": surface if len(planned.corners) else None,
        "classes": {
            "points": _classes(sigma, view.unit, wanted),
            "surface": _classes(view.factor * planned.sigma, view.unit, wanted, phrase("network_page.unseen")),
        },
    }


def _of_cloud(contents: dict[str, Any], cloud: CloudSample, view: View) -> dict[str, Any]:
    """Dense points in 16 bits a coordinate, and what is stated of them."""
    low = cloud.xyz.min(axis=0)
    step = max(float(np.ptp(cloud.xyz, axis=0).max()) / 65535, 1e-300)
    sigma = view.factor * cloud.sigma
    shown = phrase("network_page.dense_shown", n=len(cloud.xyz), cell=cloud.cell, unit=view.length_unit)
    return {
        "remarks": [shown, *contents["remarks"]],
        "cloud": {
            "low": (low - np.array(contents["origin"])).tolist(), "step": step,
            "xyz": _packed(np.round((cloud.xyz - low) / step), "<u2"), "rgb": _packed(cloud.colour, "u1"),
            "image": _packed(cloud.image, "<u2"), "sigma": _packed(sigma, "<f4"), "names": list(cloud.names),
        },
        "classes": {**contents["classes"], "cloud": _classes(sigma, view.unit)},
    }  # fmt: skip


def _wanted_words(planned: Planned, view: View) -> list[Text]:
    """What was wanted, and what the colours say of it."""
    if planned.wanted is None:
        return []
    length, what = planned.wanted
    return [phrase("network_page.wanted", sigma=view.factor * length, unit=view.unit, what=what)]


def shown_points(view: View) -> Index:
    """Rows of the object points of the page."""
    return detail_of(view).points


def extent_of(xyz: Array) -> float:
    """Length that holds most of the points, of places (n, 3) about their middle; 1 where they have none.

    Points that lie far from all others, as those of a background, do not widen it.
    """
    if not len(xyz):
        return 1.0
    away = np.linalg.norm(xyz, axis=1)
    near = xyz[away <= FAR * np.median(away)]
    low, high = np.quantile(near, [0.02, 0.98], axis=0)
    size = float(np.linalg.norm(high - low))
    return size if size > 0 else 1.0


def _free(view: View) -> bool:
    """Whether the rotation of the system is arbitrary."""
    return any(part.startswith("rotation") for part in view.adjustment.datum_defect)


def basis_of(block: Block, images: Index, xyz: Array, *, free: bool) -> Array:
    """Right, back and up of the first view (3, 3).

    Up is Z; where the rotation of the system is arbitrary (free), the mean upward direction of the images.  The view
    looks as the images do in the mean.
    """
    up = np.array([0.0, 0.0, 1.0])
    R = block.images.rotation[images]
    if len(images) and free:
        mean = R[:, 1].mean(axis=0)
        if np.linalg.norm(mean) > 0.5:
            up = mean / np.linalg.norm(mean)
    back = R[:, 2].mean(axis=0) if len(images) else np.array([0.0, -1.0, 0.0])
    back = back - up * (back @ up)
    if np.linalg.norm(back) < 0.2 and len(images) and len(xyz):
        back = np.array([0.0, -1.0, 0.0])
        back = back - up * (back @ up)
    if np.linalg.norm(back) < 1e-6:
        back = np.cross(up, [1.0, 0.0, 0.0])
    back = back / np.linalg.norm(back)
    return np.stack([np.cross(up, -back) * -1.0, back, up])


def ellipsoids_of(block: Block, covariance: Array | None, points: Index) -> tuple[Index, Array]:
    """Places among the shown points (k,), and half axes (k, 3, 3), one in each row, of their 1 sigma ellipsoids.

    covariance  (p, 3, 3) of all object points; None: there is none
    """
    if covariance is None or not len(points):
        return np.zeros(0, np.int32), np.zeros((0, 3, 3))
    C = covariance[points]
    known = np.flatnonzero(np.isfinite(C).all(axis=(1, 2)) & (np.trace(C, axis1=1, axis2=2) > 0))
    special = known[np.asarray(block.points.role)[points[known]] != Role.TIE]
    tie = np.setdiff1d(known, special)
    room = max(MOST_ELLIPSOIDS - len(special), 0)
    rows = np.sort(np.concatenate([special, tie[spread_rows(len(tie), room)] if room else tie[:0]])).astype(np.int32)
    values, vectors = np.linalg.eigh(C[rows])
    return rows, np.swapaxes(vectors * np.sqrt(np.maximum(values, 0))[:, None, :], 1, 2)


def _enlarged(axes_: Array, extent: float) -> float:
    """A round factor that makes a typical ellipsoid about a hundredth of the extent."""
    if not len(axes_):
        return 1.0
    major = float(np.quantile(np.linalg.norm(axes_[:, 2], axis=1), 0.75))
    wanted = 0.01 * extent / major if major > 0 else 1.0
    return max(1.0, 10.0 ** round(math.log10(wanted)))


def _rays(view: View, points: Index, images: Index) -> tuple[Array, Array]:
    """Images (positions among the shown ones) of every shown point: starts (p + 1,) and the images (m,)."""
    point_of = np.full(len(view.given.points), -1)
    point_of[points] = np.arange(len(points))
    image_of = np.full(len(view.given.images), -1)
    image_of[images] = np.arange(len(images))
    o = view.given.observations
    p, i = point_of[o.point[view.used]], image_of[o.image[view.used]]
    keep = (p >= 0) & (i >= 0)
    p, i = p[keep], i[keep]
    order = np.lexsort((i, p))
    starts = np.concatenate([[0], np.cumsum(np.bincount(p, minlength=len(points)))])
    return starts, i[order]


def _bars(view: View, points: Index) -> Array:
    """Ends (k, 2) of the scale bars, positions among the shown points."""
    row = np.full(len(view.given.points), -1)
    row[points] = np.arange(len(points))
    d = view.given.distances
    ends = np.stack([row[d.start], row[d.end]], axis=1)
    return ends[(ends >= 0).all(axis=1)]


def _remarks(view: View, detail: Detail, images: Index, ellipsoids: int) -> list[Text]:
    """What the page holds and leaves out, in sentences."""
    known = int(((view.rays > 0) & np.isfinite(view.adjusted.points.xyz).all(axis=1)).sum())
    taken = len(np.unique(view.given.observations.image[view.used]))
    shown, drawn = len(detail.points), len(images)
    words = [
        phrase(
            "network_page.contents", points=shown, of_points=known, all_points=shown == known, images=drawn,
            of_images=taken, all_images=drawn == taken,
        )
    ]  # fmt: skip
    if detail.cell:
        found = [note("network_page.one_per_cell", cell=detail.cell, unit=view.length_unit)]
        if detail.worst:
            found.append(note("network_page.worst_points", n=detail.worst))
        words.append(Text.of(*found, note("network_page.all_in_table")))
    if drawn < taken:
        words.append(phrase("network_page.images_chosen"))
    if ellipsoids:
        words.append(phrase("network_page.ellipsoids_of", n=ellipsoids))
    elif view.adjustment.precision is None:
        words.append(phrase("network_page.no_statistics"))
    words.append(datum_words(view))
    if view.arbitrary_scale:
        words.append(phrase("network_page.arbitrary_scale"))
    return words
