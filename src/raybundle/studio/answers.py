"""What the studio shows of a desk: plain data, made from block, adjustment and journal; pixels are those of files."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from typing import Any

import numpy as np

from raybundle.adjustment.result import Adjustment
from raybundle.errors import Severity, Text
from raybundle.io.reading.trees import read_json
from raybundle.measuring.frames import file_matrix, to_file
from raybundle.measuring.journal import measured_result
from raybundle.measuring.mark_tests import mark_verdict, off_images, point_test_of
from raybundle.measuring.predict import Prediction, predict, visible, worst
from raybundle.measuring.state import State
from raybundle.numerics.arrays import Array
from raybundle.pipeline.project import masks_given
from raybundle.report.text.words import verdict
from raybundle.report.view import view_of
from raybundle.results.project_results import own_result
from raybundle.studio.desk import Desk, named

TURNS = {6: 1, 3: 2, 8: 3}
"""EXIF orientation -> quarter turns clockwise that show a stored photograph the right way up."""
MOST_PREDICTIONS = 12


def overview(desk: Desk) -> dict[str, Any]:
    """All that the page needs first."""
    block, a = desk.block, desk.adjustment
    o = block.observations
    rays = np.bincount(o.image, minlength=len(block.images))
    rms = _rms(desk)
    wrong = _p_wrong(desk)
    images: list[dict[str, Any]] = []
    for k, name in enumerate(block.images.ids):
        width, height = desk.session.known.size_px[name]
        images.append({
            "id": name, "file": block.images.file[k], "width": width, "height": height,
            "camera": block.cameras[int(block.images.camera[k])].id, "oriented": bool(block.images.oriented[k]),
            "rays": int(rays[k]), "rms_px": finite(rms[k]), "p_wrong": wrong.get(name),
            "turn": _turn(desk, k), "photo": k in desk.tiles.paths,
        })  # fmt: skip
    reported = None if a is None else verdict(view_of(a))
    return {
        "title": block.name, "kind": desk.kind, "times": desk.times, "path": str(desk.source),
        "free_scale": bool(block.free_scale),
        "unit": "" if block.free_scale else block.length_unit,
        "sigma0": None if a is None else finite(a.sigma0), "redundancy": None if a is None else a.redundancy,
        "neglected": desk.session.neglected, "headline": "" if reported is None else reported.headline,
        "grade": "" if reported is None else reported.grade, "images": images, "points": len(block.points),
        "observations": len(o), "state": state_of(desk), "standing": standing_of(desk),
        "masks_given": "" if (given := masks_given(desk.source)) is None else str(given),
        "fiducials": [] if desk.scans is None else list(desk.scans.calibrated.names),
        "report": (measured_result(desk.source) / "report.html").is_file(),
    }  # fmt: skip


def standing_of(desk: Desk) -> dict[str, Any]:
    """How far the photographs are oriented, and what the others lack, as data and in words."""
    s = desk.standing
    return {
        "oriented": s.oriented, "images": s.images, "line": [Text.of(m) for m in s.line.messages],
        "words": [*(Text.of(k.message) for k in s.lacking), *s.words[len(s.lacking) :]], "trouble": s.trouble,
        "lacking": [
            {"image": k.image, "other": k.other, "kind": k.kind, "have": k.have, "need": k.need,
             "words": Text.of(k.message)}
            for k in s.lacking
        ],
        "wrong": [{"point": w.point, "images": list(w.images), "words": w.words} for w in s.wrong],
    }  # fmt: skip


def state_of(desk: Desk) -> dict[str, Any]:
    """What was measured by hand."""
    with desk.lock:
        state, seq = desk.journal.state, desk.journal.seq
    return {"seq": seq, **plain_state(state)}


def plain_state(state: State) -> dict[str, Any]:
    """A state as JSON states it."""
    return {
        "can_undo": state.can_undo, "can_redo": state.can_redo,
        "marks": [
            {"image": i, "point": p, "x": m.x_px, "y": m.y_px, "cov": list(m.covariance), "how": m.how,
             "quality": m.quality, "clicked": None if m.clicked is None else list(m.clicked)}
            for (i, p), m in state.marks.items()
        ],
        "points": [{"point": p, "role": v.role, "xyz": list(v.xyz), "sigma": list(v.sigma)}
                   for p, v in state.points.items()],
        "bars": [{"start": a, "end": b, "length": v.length, "sigma": v.sigma} for (a, b), v in state.bars.items()],
        "lines": [{"line": n, "kind": v.kind, "points": list(v.points), "sigma": v.sigma}
                  for n, v in state.lines.items()],
        "datum": None if state.datum is None else
        {"origin": state.datum.origin, "axis": state.datum.axis, "plane": state.datum.plane},
        "fiducials": [
            {"image": i, "name": n, "x": m.x_px, "y": m.y_px, "cov": list(m.covariance), "how": m.how}
            for (i, n), m in state.fiducials.items()
        ],
        "rejected": sorted([i, p] for i, p in state.rejected), "renamed": dict(state.renamed),
        "parameters": [{"camera": c, "symbol": s, "choice": v} for (c, s), v in state.parameters.items()],
        "masks": [{"mask": n, "image": m.image, "camera": m.camera, "polygon": [list(xy) for xy in m.polygon]}
                  for n, m in state.masks.items()],
        "drawings": [{"drawing": n, "kind": d.kind, "corners": [list(xy) for xy in d.corners], "layer": d.layer,
                      "note": d.note, "surface": d.surface} for n, d in state.drawings.items()],
    }  # fmt: skip


def observations(desk: Desk, image: str) -> dict[str, Any]:
    """The image points of one image, with residuals and test values where there is an adjustment."""
    k = named(desk, image)
    rows, block, a = desk.rows_in(k), desk.block, desk.adjustment
    o = block.observations
    xy = to_file(block, k, o.xy_px[rows])
    found: dict[str, Any] = {
        "point": [block.points.ids[p] for p in o.point[rows]], "x": xy[:, 0].tolist(), "y": xy[:, 1].tolist(),
        "s": np.sqrt(o.cov_px2[rows, :2].mean(axis=1)).tolist(), "rays": block.ray_count[o.point[rows]].tolist(),
        "role": np.asarray(block.points.role)[o.point[rows]].astype(int).tolist(),
    }  # fmt: skip
    if a is None:
        nothing = [None] * len(rows)
        return {**found, "vx": nothing, "vy": nothing, "w": nothing, "rejected": [""] * len(rows)}
    s = a.image_observations
    v = s.residuals_px[rows] @ file_matrix(block, k).T
    w = np.nanmax(np.nan_to_num(np.abs(s.w[rows]), nan=-1.0), axis=1, initial=-1.0)
    reasons = [s.rejected[int(r)] for r in rows]
    return {
        **found, "vx": numbers(v[:, 0]), "vy": numbers(v[:, 1]), "w": [None if x < 0 else x for x in w.tolist()],
        "rejected": ["" if r is None else r.text for r in reasons],
    }  # fmt: skip


def predictions(desk: Desk, point: str, images: Sequence[str]) -> dict[str, Any]:
    """Where a point is, where it should be seen in some images, and where else it may be measured."""
    from raybundle.measuring.position import locate

    session, state = desk.session, desk.journal.state
    located = locate(session, state, point)
    return {
        "point": point,
        "located": {
            "xyz": None if located.xyz is None else located.xyz.tolist(), "source": located.kind,
            "sigma": None if located.sigma is None else located.sigma.tolist(), "rays": len(located.rows),
            "neglected": located.neglected,
            "residuals": {i: list(v) for i, v in located.residuals_px.items()},
        },
        "off": list(off_images(point_test_of(session, state, point))),
        "predictions": [_prediction(predict(session, state, point, i)) for i in images[:MOST_PREDICTIONS]],
        "visible": [
            {"image": v.image, "x": v.xy_px[0], "y": v.xy_px[1], "angle_deg": v.angle_deg, "distance": v.distance}
            for v in visible(session, state, point)
        ],
    }  # fmt: skip


def tested(desk: Desk, verb: str, arguments: Mapping[str, Any]) -> dict[str, Any] | None:
    """How far a mark that was just put or moved lies from the others, and whether it is mistaken."""
    if verb not in {"put", "move"}:
        return None
    found = mark_verdict(desk.session, desk.journal.state, str(arguments["point"]), str(arguments["image"]))
    if found is None:
        return None
    return {"words": found, "off": any(m.severity is Severity.WARNING for m in found.messages)}


def _prediction(p: Prediction) -> dict[str, Any]:
    e = p.ellipse()
    return {
        "image": p.image, "x": None if p.xy_px is None else p.xy_px[0], "y": None if p.xy_px is None else p.xy_px[1],
        "ellipse": None if e is None else {"a": e.a, "b": e.b, "angle_deg": e.angle_deg}, "inside": p.inside,
        "segment": None if p.segment is None else p.segment.tolist(), "segment_sigma_px": p.segment_sigma_px,
        "why": p.why, "neglected": p.neglected,
    }  # fmt: skip


def worst_of(desk: Desk) -> dict[str, Any]:
    """What is worth looking at next."""
    found = worst(desk.session, desk.journal.state)
    return {"worst": [{"kind": x.kind, "point": x.point, "image": x.image, "value": x.value} for x in found]}


def finite(value: float) -> float | None:
    """A number as JSON knows it."""
    return float(value) if math.isfinite(value) else None


def numbers(values: Array) -> list[float | None]:
    """Numbers as JSON knows them."""
    return [finite(v) for v in values.tolist()]


def _p_wrong(desk: Desk) -> Mapping[str, float]:
    """Probability that the station of an image is wrong, as the result that is open states it."""
    result = own_result(desk.source)
    if result is None:
        return {}
    tree = read_json(result / "result.json")
    return {n: v.number() for n, v in tree.get("p_wrong").mapping().items()} if tree.has("p_wrong") else {}


def _rms(desk: Desk) -> Array:
    """Root mean square residual of each image [px]; NaN without an adjustment."""
    a: Adjustment | None = desk.adjustment
    count = len(desk.block.images)
    if a is None:
        return np.full(count, np.nan)
    used, o = a.image_observations.used, a.given.observations
    v2 = (np.nan_to_num(a.image_observations.residuals_px[used]) ** 2).mean(axis=1)
    n = np.bincount(o.image[used], minlength=count)
    with np.errstate(invalid="ignore"):
        return np.sqrt(np.bincount(o.image[used], weights=v2, minlength=count) / n)


def _turn(desk: Desk, image: int) -> int:
    """Quarter turns clockwise that show a photograph the right way up; a mirrored one is shown as stored."""
    from PIL import Image

    path = desk.tiles.paths.get(image)
    if path is None:
        return 0
    try:
        with Image.open(path) as opened:
            return TURNS.get(int(opened.getexif().get(0x0112, 1)), 0)
    except (OSError, ValueError, SyntaxError, TypeError, Image.DecompressionBombError):
        return 0
