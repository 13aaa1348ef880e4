"""The first page, for the client: verdict, key figures, accuracy and next steps."""

from __future__ import annotations

import math
from collections.abc import Sequence

import numpy as np

from raybundle.adjustment.blunders.accuracy import Compared
from raybundle.adjustment.evaluation.counts import counts
from raybundle.adjustment.statistics.far_points_share import few_hold, of_points
from raybundle.calibration.quality import CalibrationQuality
from raybundle.errors import Message, Text, note, phrase
from raybundle.numerics.arrays import Array
from raybundle.numerics.counting import decimals_for
from raybundle.report.chapters import Occasion, chapter
from raybundle.report.delivery import Delivery, delivery_of
from raybundle.report.figures.object_view import object_view
from raybundle.report.figures.photograph_view import photograph_view
from raybundle.report.figures.svg import spread_rows
from raybundle.report.languages import Localised
from raybundle.report.parts import (
    Column,
    Fact,
    Facts,
    Figure,
    Figures,
    Heading,
    Paragraph,
    Part,
    Section,
    Statements,
    Table,
    number,
    table,
    text,
    whole,
)
from raybundle.report.sections.calibration import grade_code, worst
from raybundle.report.sections.front_lengths import length_parts
from raybundle.report.text.front_words import handed_over, next_steps, steps_left, taken_words, verdict_sentence
from raybundle.report.text.metrology_words import length_figures
from raybundle.report.text.numbers import (
    NONE,
    cells,
    fixed,
    grouped,
    per_cent,
    significant,
    with_sigma,
)
from raybundle.report.text.words import each_axis, free_std, relative_values
from raybundle.report.view import View, in_unit, rms
from raybundle.results.folder import MAP_CONTROL

MOST_ROWS, FEW_ROWS = 5, 3
"""Points of a kind that the first page lists, and where the statements of a standard take their place"""
MOST_TURNED = 100_000
"""Points whose standard deviations are turned into the client's axes"""
HECTARE = 1e4


@chapter("front", after="", part="client")
def front(o: Occasion) -> tuple[Section, ...]:
    """The page that a client reads."""
    d = o.delivery or delivery_of(o.view.adjustment)
    parts = [Statements(statements=head_of(o, d)), *glance_parts(o, d), *next_parts(o, d)]
    return (Section(anchor="front", title=phrase("front.title"), parts=tuple(parts)),)


def glance_parts(o: Occasion, d: Delivery) -> tuple[Part, ...]:
    """Key figures, the object, and how good its points are."""
    parts: list[Part] = [Facts(facts=_facts(o, d))]
    drawn = object_view(o.view, from_above=d.flight is not None, heights=d.heights)
    if drawn is not None:
        seen = photograph_view(o.view, d.pictures, drawn.classes)
        views = (drawn,) if seen is None else (drawn, seen)
        parts.append(Figures(figures=tuple(Figure(drawing=v.drawing, caption=v.caption) for v in views)))
    return (*parts, *(_cameras(o) if o.qualities else (*_accuracy(o.view, d), *length_parts(o.view))))


def head_of(o: Occasion, d: Delivery) -> tuple[tuple[str, str], ...]:
    """Who, what, where and when, the verdict, and what was asked for."""
    r = d.record
    pairs: list[tuple[str, str]] = [
        (phrase("front.verdict"), verdict_sentence(o)),
        *((x.label, x.sentence) for x in d.outcomes),
        *_lengths(o, d),
        *((phrase("front.asprs_statement", height=k > 0), s) for k, s in enumerate(d.statements)),
        (phrase("front.client"), Localised(r.client)), (phrase("front.operator"), Localised(r.operator)),
        (phrase("front.object"), Localised(r.object)), (phrase("front.place"), Localised(r.place)),
        (phrase("front.date"), Localised(r.date) if r.date else taken_words(o)),
        (phrase("front.instruments"), Localised(r.instruments)), (phrase("front.rights"), Localised(r.rights)),
        *_system(d),
    ]  # fmt: skip
    return tuple((word, sentence) for word, sentence in pairs if sentence)


def _lengths(o: Occasion, d: Delivery) -> list[tuple[Text, Text]]:
    """What independent lengths show, where nobody asked for a limit of their errors."""
    if o.view.lengths is None or any(x.name == "lengths" for x in d.outcomes):
        return []
    return [(phrase("outcome.name", name="lengths"), Text.of(*length_figures(o.view.lengths)))]


def _system(d: Delivery) -> list[tuple[Text, str]]:
    """In which system coordinates stand, and what heights are."""
    label = phrase("front.coordinate_system")
    if d.frame is None:
        return [] if d.flight is None else [(label, phrase("front.system_of_control"))]
    from raybundle.report.map_axes import height_words, system_words

    return [(label, system_words(d.frame)), (phrase("front.heights"), height_words(d.frame, measured=d.heights))]


def _facts(o: Occasion, d: Delivery) -> tuple[Fact, ...]:
    view = o.view
    n = counts(view.adjustment)
    facts = [
        Fact(
            label=phrase("label.photographs"), value=grouped(n.images_used),
            remark="" if n.images_used == n.images_given else phrase("front.of_given", n=n.images_given),
        ),
        *_flight_facts(d),
        Fact(label=phrase("label.object_points"), value=grouped(n.points_used), remark=_rays(view)),
        *(_camera_facts(o.qualities) if o.qualities else (*_precision_facts(view, d), *_tested_facts(view, d))),
    ]  # fmt: skip
    return tuple(facts)


def _camera_facts(qualities: Sequence[CalibrationQuality]) -> list[Fact]:
    """What calibrated cameras are good for: of the worst one."""
    q = worst(qualities)
    which = note("front.worst_camera", camera=q.camera, n=len(qualities))
    return [
        Fact(
            label=phrase("label.projection_uncertainty"), value=f"{significant(q.typical_px, 2)} px",
            remark=Text.of(
                note("front.uncertainty", largest_px=q.uncertainty_px), *([which] if len(qualities) > 1 else [])
            ),
        ),
        Fact(
            label=phrase("front.good_to"), value=f"{significant(q.worst_px, 2)} px",
            remark=phrase("front.largest_error"),
        ),
        Fact(label=phrase("label.format"), value=per_cent(q.coverage), remark=phrase("front.coverage")),
    ]  # fmt: skip


def _cameras(o: Occasion) -> list[Part]:
    """Calibrated cameras, one a row."""
    rows: list[list[str]] = []
    for q in o.qualities:
        interior = next((i for i in o.view.adjustment.interior if i.camera == q.camera and i.image is None), None)
        c = None if interior is None else interior.parameters.get("c")
        pair = (NONE, NONE) if c is None else with_sigma(c.value, math.nan if c.std is None else c.std)
        sizes = (q.image_sigma_px, q.typical_px, q.uncertainty_px)
        grade = phrase("calibration_quality.grade", grade=grade_code(q))
        rows.append([q.camera, grade, grouped(q.photographs), *pair, *(significant(v, 2) for v in sizes)])
    shape = (
        whole(phrase("label.camera")), text(phrase("front.verdict")), number(phrase("label.photographs")),
        number("c", "mm"), number("σ", "mm"), number(phrase("label.image_points"), "px"),
        number(phrase("front.median_uncertainty"), "px"), number(phrase("front.largest_uncertainty"), "px"),
    )  # fmt: skip
    remark = phrase("front.uncertainty_meaning")
    return [Heading(text=phrase("label.heading_cameras")), table(shape, zip(*rows, strict=True), note=remark)]


def _rays(view: View) -> str:
    seen = view.rays[view.rays > 0]
    return phrase("front.rays", n=float(np.median(seen))) if len(seen) else ""


def _flight_facts(d: Delivery) -> list[Fact]:
    f = d.flight
    if f is None:
        return []
    factor, unit = (100.0, "cm") if f.gsd_m >= 0.01 else (1000.0, "mm")
    low, high = (factor * v for v in f.gsd_range_m)
    one, of_one = _area(f.area_one_m2)
    three, of_three = _area(f.area_three_m2)
    return [
        Fact(
            label=phrase("front.gsd"), value=in_unit(factor * f.gsd_m, unit),
            remark=phrase("front.gsd_range", low=low, high=high, unit=unit),
        ),
        Fact(
            label=phrase("front.flying_height"), value=f"{significant(f.height_m)} m",
            remark=phrase("front.above_ground"),
        ),
        Fact(
            label=phrase("front.area"), value=f"{significant(three)} {of_three}",
            remark=phrase("front.area_of_one", area=one, unit=of_one),
        ),
    ]  # fmt: skip


def _area(m2: float) -> tuple[float, str]:
    return (m2 / HECTARE, "ha") if m2 >= HECTARE else (m2, "m²")


def _precision_facts(view: View, d: Delivery) -> list[Fact]:
    std = client_std(view, d)
    facts: list[Fact] = []
    if len(std):
        # as the headline has it
        median = few_hold(free_std(view)) is not None
        each = np.array([[_typical(c, median=median) for c in std.T]])
        # of each point the rms of its coordinates, as `few_hold` has it: the headline's number, not another beside it
        size = _typical(of_points(std) if median else std, median=median)
        facts.append(Fact(
            label=phrase("label.standard_deviation"), value=in_unit(size, view.unit, 2),
            remark=Text.of(note("front.std_of_coordinate", median=median), each_axis(each, view.unit, _axes(d))),
        ))  # fmt: skip
    values = relative_values(view)
    if values is not None and d.flight is None:
        value = f"1\u00a0:\u00a0{grouped(int(str(values['relative'])))}"
        facts.append(
            Fact(label=phrase("label.relative_precision"), value=value, remark=phrase("front.quotient", **values))
        )
    return facts


def _axes(d: Delivery) -> tuple[str, ...]:
    return tuple(d.accuracy.axes.names)


def _typical(std: Array, *, median: bool) -> float:
    """Median or root mean square of standard deviations; NaN without any."""
    known = std[np.isfinite(std)]
    if not len(known):
        return math.nan
    return float(np.median(known)) if median else rms(known)


def client_std(view: View, d: Delivery) -> Array:
    """Standard deviations (k, 3) of the object points along the client's axes [view.unit]; NaN where held.

    Without heights that anybody measured (k, 2): those of the result have no accuracy.  Of very many points some.
    """
    precision = view.adjustment.precision
    if precision is None:
        return np.zeros((0, 3))
    free = np.flatnonzero(np.isfinite(view.std).any(axis=1)) if view.std is not None else np.zeros(0, int)
    rows = free[spread_rows(len(free), MOST_TURNED)]
    C = np.nan_to_num(precision.object_points[rows])
    std = d.accuracy.axes.std(view.adjusted.points.xyz[rows], C) * view.factor
    return np.where(std > 0, std, np.nan)[:, : 3 if d.heights else 2]


def _tested_facts(view: View, d: Delivery) -> list[Fact]:
    """Differences at independent points; without check points, at control left out."""
    whole_ = d.accuracy.check if d.accuracy.check.any else d.accuracy.left_out
    if not whole_.any:
        return []
    factor, unit = _unit(view, whole_.difference)
    each = each_axis(whole_.rms * factor, unit, _axes(d))
    n = int(np.isfinite(whole_.difference).any(axis=1).sum())
    value = in_unit(rms(whole_.difference) * factor, unit, 2)
    if whole_ is d.accuracy.check:
        label, remark = phrase("label.check_points"), note("front.check_rms", n=n)
    else:
        label, remark = phrase("front.leave_one_out"), note("front.leave_one_out_rms", n=n)
    return [Fact(label=label, value=value, remark=Text.of(remark, each))]


def _unit(view: View, difference: Array) -> tuple[float, str]:
    """Factor and unit in print of differences: as standard deviations, but metres where they are that large."""
    if view.unit == "mm" and view.length_unit == "m" and rms(difference) >= 1:
        return 1.0, "m"
    return view.factor, view.unit


def _accuracy(view: View, d: Delivery) -> list[Part]:
    """Check points and control in the client's coordinates; where there are none, standard deviations."""
    accuracy = d.accuracy
    listed = [("check", accuracy.check, "check.csv"), ("control", accuracy.control, "control.csv")]
    if d.frame is not None:  # the others are in the frame of the adjustment
        listed = [(role, c, MAP_CONTROL) for role, c, _ in listed]
    listed = [(role, c, file) for role, c, file in listed if len(c.rows)]
    if not listed:
        return _standard_deviations(view, d)
    factor, unit = _unit(view, np.vstack([c.difference for _, c, _ in listed]))
    columns, decimals = _coordinate_columns(view, d, np.vstack([c.difference for _, c, _ in listed]))
    rows: list[list[str]] = []
    notes = [note("front.minus_given")]
    most = FEW_ROWS if d.statements else MOST_ROWS
    fine = _fine(d, [(role, c) for role, c, _ in listed], factor)
    for role, c, file in listed:
        rows += _rows(view, role, c, decimals, fine, factor, most)
        n = int(np.isfinite(c.difference).any(axis=1).sum())
        if n > most:
            notes.append(note("front.largest_differences", role=role, n=n, most=most, file_name=file))
    if accuracy.left_out.any and not accuracy.check.any:
        values = cells((accuracy.left_out.rms * factor).tolist(), fine)
        rows.append([phrase("front.leave_one_out_row"), "", *[""] * 3, *values])
        notes.append(note("front.leave_one_out_meaning"))
    differences = [number(f"d{a}", unit) for a in accuracy.axes.names]
    shape = (text(phrase("label.point")), text(phrase("label.role")), *columns, *differences)
    remark = Text.of(*notes, *_unknown(listed))
    return [Heading(text=phrase("label.accuracy")), Table(columns=shape, rows=rows, note=remark)]


def _fine(d: Delivery, listed: Sequence[tuple[str, Compared]], factor: float) -> int:
    """Decimals of the differences: those of control that is held are nothing but rounding."""
    free = [np.where((c.sigma == 0) & (role == "control"), np.nan, c.difference) for role, c in listed]
    if d.accuracy.left_out.any and not d.accuracy.check.any:
        free.append(np.atleast_2d(d.accuracy.left_out.rms))
    size = rms(np.vstack(free)) * factor
    return int(np.clip(decimals_for(size), 0, 6)) if np.isfinite(size) else 0


def _unknown(listed: Sequence[tuple[str, Compared, str]]) -> list[Message]:
    """What a dash means, where there is any."""
    lost = any((~np.isfinite(c.given[:, 2]) & np.isfinite(c.given[:, 0])).any() for _, c, _ in listed)
    open_ = any(not c.any for _, c, _ in listed)
    cause = "both" if lost and open_ else "lost" if lost else "open"
    return [note("front.dash", cause=cause)] if lost or open_ else []


def _coordinate_columns(view: View, d: Delivery, difference: Array) -> tuple[list[Column], list[int]]:
    """Headings of the client's coordinates, and their decimals."""
    places = int(np.clip(decimals_for(rms(difference)), 0, 6))
    if d.frame is None:
        return [number(a, view.length_unit) for a in "XYZ"], [places] * 3
    from raybundle.report.map_axes import MapAxes

    labels = MapAxes(frame=d.frame).labels
    return [number(a, u) for a, u in labels], [places + 5 if u == "°" else places for _, u in labels]


def _rows(
    view: View, role: str, c: Compared, decimals: list[int], fine: int, factor: float, most: int
) -> list[list[str]]:
    """Rows of a kind of points, those with the largest differences where there are many, and their rms."""
    size = np.sqrt(np.nansum(c.difference**2, axis=1))
    known = np.flatnonzero(np.isfinite(c.difference).any(axis=1))
    if not len(known):  # what the datum leaves open is given, but not compared
        known = np.arange(len(c.rows))
    shown = known if len(known) <= most else np.sort(known[np.argsort(-size[known], kind="stable")[:most]])
    rows = [
        [
            view.given.points.ids[int(c.rows[k])], phrase("front.role", role=role),
            *(fixed(float(v), n) for v, n in zip(c.given[k], decimals, strict=True)),
            *_differences(c, k, fine, factor, role),
        ]
        for k in shown.tolist()
    ]  # fmt: skip
    if not c.any:
        return rows
    head = [phrase("front.rms_of", n=len(known)), phrase("front.role", role=role), *[""] * 3]
    return [*rows, [*head, *cells((c.rms * factor).tolist(), fine)]]


def _differences(c: Compared, k: int, fine: int, factor: float, role: str) -> list[str]:
    """Of one point; control that was held has none."""
    shown = cells((c.difference[k] * factor).tolist(), fine)
    held = phrase("front.held")
    return [held if role == "control" and s == 0 else t for s, t in zip(c.sigma[k], shown, strict=True)]


def _standard_deviations(view: View, d: Delivery) -> list[Part]:
    std = client_std(view, d)
    if not len(std):
        return []
    rows: list[list[str]] = []
    for axis, column in zip(d.accuracy.axes.names, std.T, strict=False):
        good = column[np.isfinite(column)]
        if len(good):
            four = (rms(good), *np.quantile(good, [0.5, 0.95]), good.max())
            rows.append([axis, *(significant(float(v), 2) for v in four)])
    heads = ("front.rms", "front.median", "front.quantile_95", "front.largest")
    shape = (text(phrase("label.coordinate")), *(number(phrase(n), view.unit) for n in heads))
    remark = Text.of(note("front.standard_deviations", lengths=view.lengths is not None), *_weakest(view))
    return [Heading(text=phrase("label.precision")), table(shape, zip(*rows, strict=True), note=remark)]


def _weakest(view: View) -> list[Message]:
    """Which point has the largest standard deviation, and in how many photographs it is seen: a far one, mostly."""
    if view.std is None or not np.isfinite(view.std).any():
        return []
    k = int(np.unravel_index(int(np.nanargmax(view.std)), view.std.shape)[0])
    return [note("front.weakest_point", point=view.given.points.ids[k], n=int(view.rays[k]))]


def next_parts(o: Occasion, d: Delivery) -> list[Part]:
    """What to do next, and what is handed over all the same."""
    steps, files = next_steps(o), handed_over(d.files)
    dense = [Paragraph(text=phrase("front.dense_points", file_name=d.surface))] if d.surface else []
    if steps:
        every = len(steps) + steps_left(o)
        rests = tuple(phrase("front.more_matters", n=every - k) if k < every else "" for k in range(len(steps) + 1))
        shown = tuple((phrase("front.severity", level=s), sentence) for s, sentence in steps)
        names = [name for name, _ in files]
        return [
            Heading(text=phrase("front.next")), Statements(statements=shown, rests=rests),
            *([Heading(text=phrase("front.handed_over")), Paragraph(text=phrase("front.files", names=names))]
              if names else []),
            *dense,
        ]  # fmt: skip
    lost = any(x.kept is False for x in d.outcomes)
    reported = [m for name, content in files for m in (note("front.file_name", name=name), *content.messages)]
    return [
        Heading(text=phrase("front.handed_over")),
        Paragraph(text=Text.of(note("front.not_kept_only") if lost else note("front.settled"), *reported)), *dense,
    ]  # fmt: skip
