"""What the calibration of each camera is worth: verdict, what to photograph next, parameters and figures."""

from __future__ import annotations

import threading
from collections.abc import Mapping
from dataclasses import dataclass, field, replace
from typing import Any

import numpy as np

from raybundle.adjustment.evaluation.residual_structure import ResidualStructure, residual_structure
from raybundle.adjustment.records.figures import InteriorResult
from raybundle.adjustment.result import Adjustment
from raybundle.calibration.quality import calibration_quality
from raybundle.commands.calibrate import quality_table
from raybundle.errors import InputError, phrase
from raybundle.io.reading.trees import read_json
from raybundle.planning.next.calibration import advised
from raybundle.report.figures.interior import coverage_map
from raybundle.report.languages.language import Language
from raybundle.report.languages.setting import drawing_in, section_in
from raybundle.report.parts import Figure, Figures, Folded, Heading, Part, Section
from raybundle.report.sections.interior import MOST_DRAWN, interior_section
from raybundle.report.single_figure import svg_of
from raybundle.report.view import View, view_of
from raybundle.results.project_results import own_result
from raybundle.studio.answers import finite
from raybundle.studio.desk import Desk
from raybundle.studio.shelf import Shelf

STORED, COMPUTED = "stored", "computed"


@dataclass(slots=True)
class Drawn:
    """Verdicts and figures of one adjustment."""

    adjustment: Adjustment
    cameras: list[dict[str, Any]] = field(default_factory=list[dict[str, Any]])
    figures: list[str] = field(default_factory=list[str])
    """SVG documents"""


@dataclass(slots=True)
class Calibrations:
    """Made once for each adjustment, when they are looked at."""

    desk: Desk
    shelf: Shelf
    language: Language
    _drawn: Drawn | None = None
    _lock: threading.Lock = field(default_factory=threading.Lock)

    def reported(self) -> dict[str, Any]:
        """The cameras with their verdicts, parameters and numbers of figures, or why there are none."""
        drawn = self._made()
        if drawn is None:
            return {"cameras": [], "why": phrase("studio_decide.wait")}
        why = "" if drawn.cameras else phrase("studio_decide.no_interior")
        return {"cameras": drawn.cameras, "why": why}

    def figure(self, number: int) -> str:
        """A figure as an SVG document; raises InputError where it is not there."""
        drawn = self._made()
        figures = [] if drawn is None else drawn.figures
        if not 0 <= number < len(figures):
            raise InputError("studio.no_figure", number=number, n=len(figures))
        return figures[number]

    def _made(self) -> Drawn | None:
        a = self.desk.adjustment
        if a is None:
            return None
        with self._lock:
            if self._drawn is None or self._drawn.adjustment is not a:
                self._drawn = _drawn(a, self._stored(), self.language)
            return self._drawn

    def _stored(self) -> Mapping[str, Any]:
        """Verdicts that `calibrate` has written, as long as nothing was adjusted since."""
        last, result = self.shelf.adjustments[-1:], own_result(self.desk.source)
        if result is None or any(a.origin not in {"opened", "calibrated"} for a in last):
            return {}
        tree = read_json(result / "result.json")
        return {k: v.value for k, v in tree.get("calibration").mapping().items()} if tree.has("calibration") else {}


def _drawn(a: Adjustment, stored: Mapping[str, Any], language: Language) -> Drawn:
    view, found = view_of(a), Drawn(a)
    figures = _by_camera(section_in(interior_section(view), language))
    structure = residual_structure(a) if a.precision is not None and a.noise.kind == "white" else None
    single = [i for i in a.interior if i.image is None]
    for k, interior in enumerate(single[:MOST_DRAWN]):
        numbers: list[dict[str, Any]] = []
        for figure in (*_coverage(view, interior, language), *(figures[k] if k < len(figures) else ())):
            numbers.append({"number": len(found.figures), "caption": figure.caption,
                            "width": figure.drawing.width})  # fmt: skip
            found.figures.append(svg_of(figure))
        verdict = stored.get(interior.camera)
        how = STORED if verdict is not None else COMPUTED
        if verdict is None:
            verdict = _verdict(a, interior, structure)
        found.cameras.append({
            "camera": interior.camera, "verdict": verdict, "verdict_is": how, "figures": numbers,
            "about": _about(view, interior), "parameters": _parameters(interior),
        })  # fmt: skip
    return found


def _verdict(a: Adjustment, interior: InteriorResult, structure: ResidualStructure | None) -> dict[str, Any] | None:
    """The verdict without cross-validation, which takes as long as ten adjustments; None where nothing is estimated."""
    is_camera = any(c.id == interior.camera and not c.is_scene for c in a.given.cameras)
    if a.precision is None or not interior.free or not is_camera:
        return None
    quality = advised(calibration_quality(a, interior.camera, None, structure), a)
    return _plain(quality_table(replace(quality, validation=None)))


def _plain(value: Any) -> Any:
    """As JSON knows it."""
    if isinstance(value, dict):
        return {k: _plain(v) for k, v in value.items()}  # pyright: ignore[reportUnknownVariableType]
    if isinstance(value, list):
        return [_plain(v) for v in value]  # pyright: ignore[reportUnknownVariableType]
    return finite(float(value)) if isinstance(value, float) else value


def _parameters(interior: InteriorResult) -> list[dict[str, Any]]:
    return [
        {"symbol": p.symbol, "meaning": p.words, "unit": "" if p.unit == "1" else p.unit, "value": finite(p.value),
         "sigma": None if p.std is None else finite(p.std), "status": p.status,
         "determinability": None if p.determinability is None else finite(p.determinability)}
        for p in interior.parameters.values()
    ]  # fmt: skip


def _about(view: View, interior: InteriorResult) -> str:
    camera = next((c for c in view.adjusted.cameras if c.id == interior.camera), None)
    if camera is None:
        return ""
    return phrase(
        "studio_decide.about", model=camera.model, width_px=camera.width_px, height_px=camera.height_px,
        pixel_um=1000 * camera.pixel_mm[0],
    )  # fmt: skip


def _coverage(view: View, interior: InteriorResult, language: Language) -> tuple[Figure, ...]:
    """How the image points that take part are spread over the format."""
    k = next((i for i, c in enumerate(view.given.cameras) if c.id == interior.camera and not c.is_scene), None)
    if k is None:
        return ()
    o = view.given.observations
    mine = view.used & (view.given.images.camera[o.image] == k)
    what = language.text(phrase("studio_decide.coverage_of", camera=interior.camera))
    drawing = drawing_in(coverage_map(view.given.cameras[k], np.asarray(o.xy_px[mine]), what), language)
    return (Figure(drawing=drawing, caption=phrase("studio_decide.coverage_caption")),)


def _by_camera(section: Section) -> list[list[Figure]]:
    """The figures of the report's section, by its headings: one a camera; single images stand in folded parts."""
    found: list[list[Figure]] = []
    for part in section.parts:
        if isinstance(part, Heading):
            found.append([])
        elif found and isinstance(part, Figures | Folded):
            found[-1] += _figures(part)
    return found


def _figures(part: Part) -> list[Figure]:
    if isinstance(part, Folded) and not any(isinstance(p, Heading) for p in part.parts):
        return [f for p in part.parts for f in _figures(p)]
    return [*part.figures] if isinstance(part, Figures) else []
