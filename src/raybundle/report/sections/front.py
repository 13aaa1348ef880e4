"""The first page, for the client: what it is, whether it is good enough, how precise where, and what to do next."""

from __future__ import annotations

import math
from collections.abc import Sequence

import numpy as np

from raybundle.adjustment.accuracy import Compared
from raybundle.adjustment.counts import counts
from raybundle.adjustment.spread import few_hold, of_points
from raybundle.calibration.quality import CalibrationQuality
from raybundle.numerics.arrays import Array
from raybundle.numerics.counting import decimals_for
from raybundle.report.chapters import Occasion, chapter
from raybundle.report.delivery import Delivery, delivery_of
from raybundle.report.figures.object_view import object_view
from raybundle.report.figures.svg import spread_rows
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
from raybundle.report.sections.calibration import worst
from raybundle.report.sections.front_lengths import length_parts
from raybundle.report.text.front_words import handed_over, next_steps, steps_left, taken_words, verdict_sentence
from raybundle.report.text.metrology_words import lengths_told
from raybundle.report.text.numbers import (
    NONE,
    cells,
    counted,
    fixed,
    grouped,
    per_cent,
    plain,
    significant,
    with_sigma,
)
from raybundle.report.text.words import free_std, relative_words
from raybundle.report.view import View, rms
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
    return (Section(anchor="front", title="At a glance", parts=tuple(parts)),)


def glance_parts(o: Occasion, d: Delivery) -> tuple[Part, ...]:
    """Key figures, the object, and how good its points are."""
    parts: list[Part] = [Facts(facts=_facts(o, d))]
    drawn = object_view(o.view, from_above=d.flight is not None, heights=d.heights)
    if drawn is not None:
        parts.append(Figures(figures=(Figure(drawing=drawn.drawing, caption=drawn.caption),)))
    return (*parts, *(_cameras(o) if o.qualities else (*_accuracy(o.view, d), *length_parts(o.view))))


def head_of(o: Occasion, d: Delivery) -> tuple[tuple[str, str], ...]:
    """Who, what, where and when, the verdict, and what was asked for."""
    r = d.record
    pairs = [
        ("Verdict", verdict_sentence(o)),
        *((f"{x.name[:1].upper()}{x.name[1:]}", f"{x.sentence[:1].upper()}{x.sentence[1:]}.") for x in d.outcomes),
        *_lengths(o, d),
        *((f"ASPRS statement{'' if k == 0 else ', height'}", s) for k, s in enumerate(d.statements)),
        ("Client", r.client), ("Operator", r.operator), ("Object", r.object), ("Place", r.place),
        ("Date", r.date or taken_words(o)), ("Instruments", r.instruments), ("Rights", r.rights),
        *_system(d),
    ]  # fmt: skip
    return tuple((word, sentence) for word, sentence in pairs if sentence)


def _lengths(o: Occasion, d: Delivery) -> list[tuple[str, str]]:
    """What lengths that took no part show, where nobody asked for a limit of their errors."""
    if o.view.lengths is None or any(x.name == "lengths" for x in d.outcomes):
        return []
    return [("Lengths", f"{lengths_told(o.view.lengths)}.")]


def _system(d: Delivery) -> list[tuple[str, str]]:
    """In which system coordinates stand, and what heights are."""
    if d.frame is None:
        if d.flight is None:
            return []
        return [("Coordinate system", "not said: that of the control, without a name; heights as it has them")]
    from raybundle.report.map_axes import height_words, system_words  # noqa: PLC0415  (pyproj only where it is used)

    return [("Coordinate system", system_words(d.frame)), ("Heights", height_words(d.frame, measured=d.heights))]


def _facts(o: Occasion, d: Delivery) -> tuple[Fact, ...]:
    view = o.view
    n = counts(view.adjustment)
    facts = [
        Fact(
            label="photographs", value=grouped(n.images_used),
            remark="" if n.images_used == n.images_given else f"of {grouped(n.images_given)} given",
        ),
        *_flight_facts(d),
        Fact(label="object points", value=grouped(n.points_used), remark=_rays(view)),
        *(_camera_facts(o.qualities) if o.qualities else (*_precision_facts(view, d), *_tested_facts(view, d))),
    ]  # fmt: skip
    return tuple(facts)


def _camera_facts(qualities: Sequence[CalibrationQuality]) -> list[Fact]:
    """What calibrated cameras are good for: of the worst one."""
    q = worst(qualities)
    which = "" if len(qualities) == 1 else f"; camera {q.camera}, the worst of {grouped(len(qualities))}"
    return [
        Fact(
            label="uncertainty of projection", value=f"{significant(q.typical_px, 2)} px",
            remark=f"median over the format, {significant(q.uncertainty_px, 2)} px at worst{which}",
        ),
        Fact(
            label="good for measurements to", value=f"{significant(q.worst_px, 2)} px",
            remark="an error that is not exceeded anywhere in the format, with 95 % certainty",
        ),
        Fact(label="format", value=per_cent(q.coverage), remark="covered by image points of all photographs"),
    ]  # fmt: skip


def _cameras(o: Occasion) -> list[Part]:
    """Calibrated cameras, one a row."""
    rows: list[list[str]] = []
    for q in o.qualities:
        interior = next((i for i in o.view.adjustment.interior if i.camera == q.camera and i.image is None), None)
        c = None if interior is None else interior.parameters.get("c")
        pair = (NONE, NONE) if c is None else with_sigma(c.value, math.nan if c.std is None else c.std)
        sizes = (q.image_sigma_px, q.typical_px, q.uncertainty_px)
        rows.append([q.camera, q.grade, grouped(q.photographs), *pair, *(significant(v, 2) for v in sizes)])
    shape = (
        whole("camera"), text("verdict"), number("photographs"), number("c", "mm"), number("sigma", "mm"),
        number("image points", "px"), number("uncertainty, median", "px"), number("at worst", "px"),
    )  # fmt: skip
    note = "Uncertainty: of the place of an image point by the calibration alone, over the format, at infinity."
    return [Heading(text="Cameras"), table(shape, zip(*rows, strict=True), note=note)]


def _rays(view: View) -> str:
    seen = view.rays[view.rays > 0]
    return f"each in {plain(float(np.median(seen)), 3)} photographs (median)" if len(seen) else ""


def _flight_facts(d: Delivery) -> list[Fact]:
    f = d.flight
    if f is None:
        return []
    low, high = (_gsd(v) for v in f.gsd_range_m)
    return [
        Fact(
            label="ground sample distance", value=_gsd(f.gsd_m),
            remark=f"median over the object points; {low} to {high} for 98 % of them",
        ),
        Fact(
            label="flying height", value=f"{significant(f.height_m)} m",
            remark="above the ground, median over the photographs",
        ),
        Fact(
            label="area", value=_area(f.area_three_m2),
            remark="in three photographs or more, within the extent of the object points; "
            f"{_area(f.area_one_m2)} in one or more",
        ),
    ]  # fmt: skip


def _gsd(metres: float) -> str:
    return f"{significant(100 * metres)} cm" if metres >= 0.01 else f"{significant(1000 * metres)} mm"


def _area(m2: float) -> str:
    return f"{significant(m2 / HECTARE)} ha" if m2 >= HECTARE else f"{significant(m2)} m²"


def _precision_facts(view: View, d: Delivery) -> list[Fact]:
    std, network = client_std(view, d), view.adjustment.network
    facts: list[Fact] = []
    if len(std):
        # as the headline has it
        median = few_hold(free_std(view)) is not None
        names = zip(d.accuracy.axes.names, (_typical(c, median=median) for c in std.T), strict=False)
        each = ", ".join(f"{a}\u00a0{significant(m, 2)}" for a, m in names if math.isfinite(m))
        told = f"of a coordinate, rms over the object points; {each}"
        told = f"of a coordinate, median over the object points; {each}" if median else told
        # of each point the rms of its coordinates, as `few_hold` has it: the headline's number, not another beside it
        size = significant(_typical(of_points(std) if median else std, median=median), 2)
        facts.append(Fact(label="standard deviation", value=f"{size} {view.unit}", remark=told))
    if network is not None and math.isfinite(network.relative_precision) and d.flight is None:
        size = grouped(float(f"{network.relative_precision:.2g}"))
        facts.append(Fact(label="relative precision", value=f"1 : {size}", remark=relative_words(view)))
    return facts


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
    """What independent points say; without check points, control left out."""
    whole_ = d.accuracy.check if d.accuracy.check.any else d.accuracy.left_out
    if not whole_.any:
        return []
    factor, unit = _unit(view, whole_.difference)
    each = ", ".join(
        f"{a}\u00a0{significant(r * factor, 2)}" for a, r in zip(d.accuracy.axes.names, whole_.rms, strict=True)
        if math.isfinite(r)
    )  # fmt: skip
    n = int(np.isfinite(whole_.difference).any(axis=1).sum())
    value = f"{significant(rms(whole_.difference) * factor, 2)} {unit}"
    if whole_ is d.accuracy.check:
        label, remark = "check points", f"rms difference of a coordinate at {counted(n, 'check point')}; {each}"
    else:
        label = "leave-one-out of control"
        remark = f"rms difference of a coordinate of {counted(n, 'control point')}, each had it taken no part; {each}"
    return [Fact(label=label, value=value, remark=remark)]


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
    notes: list[str] = []
    most = FEW_ROWS if d.statements else MOST_ROWS
    fine = _fine(d, [(role, c) for role, c, _ in listed], factor)
    for role, c, file in listed:
        rows += _rows(view, role, c, decimals, fine, factor, most)
        n = int(np.isfinite(c.difference).any(axis=1).sum())
        if n > most:
            notes.append(
                f"Of {counted(n, f'{role} point')} the {most} with the largest differences; all are in {file}."
            )
    if accuracy.left_out.any and not accuracy.check.any:
        values = cells((accuracy.left_out.rms * factor).tolist(), fine)
        rows.append(["leave-one-out of control, rms", "", *[""] * 3, *values])
        notes.append("Leave-one-out: had the control point taken no part, to first order.")
    differences = [number(f"d{a}", unit) for a in accuracy.axes.names]
    note = " ".join(["d: adjusted minus given; control took part, check points did not.", *notes, *_unknown(listed)])
    shape = (text("point"), text("role"), *columns, *differences)
    return [
        Heading(text="Accuracy"),
        Table(columns=shape, rows=rows, note=note),
    ]


def _fine(d: Delivery, listed: Sequence[tuple[str, Compared]], factor: float) -> int:
    """Decimals of the differences: those of control that is held are nothing but rounding."""
    free = [np.where((c.sigma == 0) & (role == "control"), np.nan, c.difference) for role, c in listed]
    if d.accuracy.left_out.any and not d.accuracy.check.any:
        free.append(np.atleast_2d(d.accuracy.left_out.rms))
    size = rms(np.vstack(free)) * factor
    return int(np.clip(decimals_for(size), 0, 6)) if np.isfinite(size) else 0


def _unknown(listed: Sequence[tuple[str, Compared, str]]) -> list[str]:
    lost = any((~np.isfinite(c.given[:, 2]) & np.isfinite(c.given[:, 0])).any() for _, c, _ in listed)
    open_ = any(not c.any for _, c, _ in listed)
    words = ["was not given"] * lost + ["is not compared, as the datum leaves it open"] * open_
    return [f"{NONE}: {' or '.join(words)}."] if words else []


def _coordinate_columns(view: View, d: Delivery, difference: Array) -> tuple[list[Column], list[int]]:
    """Headings of the client's coordinates, and their decimals."""
    places = int(np.clip(decimals_for(rms(difference)), 0, 6))
    if d.frame is None:
        return [number(a, view.length_unit) for a in "XYZ"], [places] * 3
    from raybundle.report.map_axes import MapAxes  # noqa: PLC0415  (pyproj only where it is used)

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
            view.given.points.ids[int(c.rows[k])], role,
            *(fixed(float(v), n) for v, n in zip(c.given[k], decimals, strict=True)),
            *_differences(c, k, fine, factor, role),
        ]
        for k in shown.tolist()
    ]  # fmt: skip
    if not c.any:
        return rows
    return [*rows, [f"rms of {grouped(len(known))}", role, *[""] * 3, *cells((c.rms * factor).tolist(), fine)]]


def _differences(c: Compared, k: int, fine: int, factor: float, role: str) -> list[str]:
    """Of one point; control that was held has none."""
    shown = cells((c.difference[k] * factor).tolist(), fine)
    return ["held" if role == "control" and s == 0 else t for s, t in zip(c.sigma[k], shown, strict=True)]


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
    shape = (text("coordinate"), *(number(n, view.unit) for n in ("rms", "median", "95 % are below", "largest")))
    note = (
        "Standard deviations of the object points. Neither control nor check points were given: the network judges "
        "itself."
    )
    if view.lengths is not None:
        note = "Standard deviations of the object points; what lengths that took no part say of them is told above."
    note += _weakest(view)
    return [Heading(text="Precision"), table(shape, zip(*rows, strict=True), note=note)]


def _weakest(view: View) -> str:
    """Which point has the largest standard deviation, and in how many photographs it is seen: a far one, mostly."""
    if view.std is None or not np.isfinite(view.std).any():
        return ""
    k = int(np.unravel_index(int(np.nanargmax(view.std)), view.std.shape)[0])
    seen = counted(int(view.rays[k]), "photograph")
    return f" The largest is that of point {view.given.points.ids[k]}, seen in {seen}."


def next_parts(o: Occasion, d: Delivery) -> list[Part]:
    """What to do next, and what is handed over all the same."""
    steps, files = next_steps(o), handed_over(d.files)
    dense = [Paragraph(text=f"Dense points: {d.surface}, of the result that stood here when they were measured.")]
    dense = dense if d.surface else []
    if steps:
        every = len(steps) + steps_left(o)
        rests = tuple(f"{counted(every - k, 'more matter')}: see the warnings." if k < every else ""
                      for k in range(len(steps) + 1))  # fmt: skip
        listed_ = f"Handed over: {', '.join(name for name, _ in files)}." if files else ""
        return [
            Heading(text="What to do next"), Statements(statements=steps, rests=rests),
            *([Heading(text="What is handed over"), Paragraph(text=listed_)] if listed_ else []), *dense,
        ]  # fmt: skip
    settled = "Nothing has to be settled."
    if any(x.kept is False for x in d.outcomes):
        settled = "What was asked for is not kept, as told above; the measurement itself has nothing to be settled."
    told = "; ".join(f"{name} ({words})" for name, words in files)
    return [
        Heading(text="What is handed over"), Paragraph(text=f"{settled} Handed over: {told}." if told else settled),
        *dense,
    ]  # fmt: skip
