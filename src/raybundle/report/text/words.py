"""The verdict: what was adjusted, how good it is, and the limits of these figures, in plain words."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any, Literal

import numpy as np

from raybundle.adjustment.evaluation.counts import counts
from raybundle.adjustment.records.figures import NetworkFigures, ObservationGroup
from raybundle.adjustment.records.severity import NEARLY, POOR_FIT, Severity
from raybundle.adjustment.result import Adjustment
from raybundle.adjustment.statistics.far_points_share import FewHold, few_hold
from raybundle.adjustment.statistics.network import classed
from raybundle.adjustment.statistics.reliability import UNCONTROLLED
from raybundle.adjustment.system.datum import ABOUT_LINE, NAMES, SHORT, open_part
from raybundle.errors import Message, Text, joined_texts, message_of_text, note, phrase
from raybundle.numerics.arrays import Array, Mask
from raybundle.numerics.statistics import chi_square_tails
from raybundle.observations import observation_kinds
from raybundle.report.text.metrology_words import MM as LENGTH_MM
from raybundle.report.text.metrology_words import length_figures
from raybundle.report.text.numbers import unit_text
from raybundle.report.view import View, rms

Grade = Literal["good", "remarks", "attention"]


@dataclass(frozen=True, slots=True, kw_only=True)
class Verdict:
    """The first thing that a reader sees."""

    grade: Grade
    headline: Text
    statements: tuple[tuple[Text, Text], ...]


def verdict(view: View) -> Verdict:
    """The verdict on an adjustment."""
    statements = [
        (phrase("label.heading_adjusted"), _adjusted(view)),
        (phrase("label.precision"), _precision(view)),
        (phrase("label.accuracy"), _accuracy(view)),
        (phrase("label.fit"), Text.of(*_fit(view))),
        (phrase("label.control"), Text.of(*_control(view))),
        (phrase("label.blunders"), Text.of(*_blunders(view))),
        (phrase("label.heading_cameras"), Text.of(*_cameras(view))),
    ]
    grade = _grade(view)
    return Verdict(grade=grade, headline=_headline(view, grade), statements=tuple(s for s in statements if s[1]))


def printed(view: View, unit: str) -> tuple[float, str]:
    """Factor and unit in print of a parameter's unit: lengths as elsewhere in the report, angles in degrees."""
    if unit == "length":
        return view.factor, view.unit
    if unit == "length/s":
        return view.factor, f"{view.unit}/s"
    if unit in {"rad", "rad/s"}:
        return math.degrees(1), unit.replace("rad", "°")
    return 1.0, unit_text(unit)


def _grade(view: View) -> Grade:
    a = view.adjustment
    worst = {n.severity for n in a.notices}
    if a.precision is None or Severity.FAULT in worst or not math.isfinite(a.sigma0) or a.sigma0 > POOR_FIT:
        return "attention"
    return "good" if view.compared and Severity.WARNING not in worst else "remarks"


def _headline(view: View, grade: Grade) -> Text:
    if view.adjustment.precision is None:
        return phrase("verdict.no_statistics")
    return Text.of(*_gained(view), *_state(view, grade))


def _gained(view: View) -> list[Message]:
    """What was determined, and how well."""
    std, network = free_std(view), view.adjustment.network
    n, unit = len(std), view.unit
    if not n:
        return _resection(view)[-1:]
    if any(found.code == "levelled" for found in view.adjustment.notices):  # heights that nobody measured
        return [note("verdict.points_plan", n=n, sigma=rms(std[:, :2]), unit=unit)]
    relative = None if network is None else relative_number(network)
    if view.arbitrary_scale and relative is not None:
        return [note("verdict.points_relative", n=n, relative=relative)]
    if (few := few_hold(std)) is not None:
        found = [note("verdict.points_median", n=n, sigma=few.coordinate, rms=rms(std), unit=unit), held_by(few)]
    else:
        found = [note("verdict.points_rms", n=n, sigma=rms(std), unit=unit)]
    if relative is not None:
        found.append(note("verdict.relative", relative=relative))
    if np.isfinite(view.check_difference).any():
        found.append(note("verdict.at_check_points", rms=rms(view.check_difference) * view.factor, unit=unit))
    elif view.lengths is not None:
        found.append(note("verdict.at_lengths", n=view.lengths.independent, rms_mm=view.lengths.rms * LENGTH_MM))
    return found


def held_by(few: FewHold) -> Message:
    """Which share of the variance few points contribute."""
    return note("verdict.few_points", n=few.points, share=few.share, of=few.of)


def relative_number(network: NetworkFigures) -> int | None:
    """N of a relative precision 1 : N, with two significant digits; None where there is none."""
    relative = network.relative_precision
    return round(float(f"{relative:.2g}")) if math.isfinite(relative) else None


def relative_values(view: View) -> dict[str, Any] | None:
    """Values of a phrase on the relative precision 1 : N and the quotient behind it; None where there is none."""
    network = view.adjustment.network
    if network is None or (relative := relative_number(network)) is None:
        return None
    return {
        "relative": relative, "mean": network.mean_std * view.factor, "unit": view.unit, "extent": network.extent,
        "length_unit": view.length_unit, "share": 1 - network.mean_share,
    }  # fmt: skip


def class_of(network: NetworkFigures) -> str:
    """The class of a relative precision as a value of phrases: "professional"."""
    return network.precision_class.partition(" ")[0]


def _state(view: View, grade: Grade) -> list[Message]:
    """Whether that can be relied upon."""
    a = view.adjustment
    if a.redundancy == 0:
        return [note("verdict.no_redundancy")]
    if a.sigma0 > POOR_FIT:
        return [note("verdict.contradicting", sigma0=a.sigma0)]
    if grade == "attention":
        return [note("verdict.faults", n=_faults(view))]
    systematic = {n.code for n in a.notices} & {"systematic_residuals", "residual_structure"}
    scale = any(n.code == "scale_unchecked" for n in a.notices)
    fit = [note("verdict.systematic")] if systematic else _fits(a)
    return [*fit, *([note("verdict.scale_unchecked")] if scale else [])]


def _faults(view: View) -> int:
    return sum(1 for n in view.adjustment.notices if n.severity is Severity.FAULT)


def _fits(a: Adjustment) -> list[Message]:
    """How the observations fit."""
    lower, value, upper = a.global_test
    if value > upper and f"{a.sigma0:.1f}" != "1.0":
        return [note("verdict.fits_worse", sigma0=a.sigma0)]
    if a.options.weights == "residuals":  # that they fit is no test then, as "Fit" has it
        return []
    return [note("verdict.fits_better", sigma0=a.sigma0) if value < lower else note("verdict.fits")]


def unsettled(view: View) -> tuple[Text, ...]:
    """What a headline of another kind, as that of a calibration, has to add where there are faults."""
    return (phrase("verdict.faults", n=n),) if (n := _faults(view)) else ()


def axis_values(values: Array, unit: str, names: Sequence[str] = "XYZ") -> dict[str, Any]:
    """Values of `verdict.each_axis`: the root mean squares (n, 3) or (3,) along the axes that have any.

    Without heights (n, 2).
    """
    columns = [*np.atleast_2d(values).T, np.full(1, np.nan)][:3]
    known = [bool(np.isfinite(c).any()) for c in columns]
    x, y, z = (rms(c) if there else 0.0 for c, there in zip(columns, known, strict=True))
    axes = "".join(name for name, there in zip("xyz", known, strict=True) if there)
    a, b, c = (*names, "")[:3]
    return {
        "axes": axes, "a": a, "b": b, "c": c, "x": x, "y": y, "z": z, "all": rms(values), "unit": unit,
    }  # fmt: skip


def each_axis(values: Array, unit: str, names: Sequence[str] = "XYZ") -> Message:
    """Root mean squares (n, 3) or (n, 2) along each axis."""
    v = axis_values(values, unit, names)
    return note("verdict.each_axis", **v)


def _adjusted(view: View) -> Text:
    a = view.adjustment
    n = counts(a)
    found = [
        note("verdict.adjusted", images=n.images_used, cameras=len(view.cameras()), points=n.points_used,
             observations=n.image_observations_used)
    ]  # fmt: skip
    for count, kind in (
        (len({i for g in a.groups if g.kind == "control" for i in g.ids}), "control"),
        (len(view.check_rows), "check"),
        *((len(np.unique(g.item)), g.kind) for g in a.groups if observation_kinds[g.kind].noun),
    ):
        if count:
            found.append(note("verdict.observed", n=count, kind=kind))
    found.append(note("verdict.redundancy", unknowns=a.unknowns, redundancy=a.redundancy))
    return joined_texts(Text.of(*found), datum_words(view))


def datum_words(view: View) -> Text:
    """The datum, as a client understands it."""
    a = view.adjustment
    if not a.datum_defect:
        return phrase("verdict.datum_fixed")
    found = [note("verdict.datum_open", **open_values(a.datum_defect))]
    if view.arbitrary_scale:
        found.append(note("verdict.lengths_without_unit"))
    taken = a.datum.messages if isinstance(a.datum, Text) else (message_of_text(a.datum),)
    return Text.of(*found, note("verdict.datum_by"), *taken)


def open_values(names: tuple[str, ...]) -> dict[str, Any]:
    """Values of a phrase on the open parts of the datum: which by name, else their symbols."""
    whole = open_datum(names)
    if whole == [ABOUT_LINE]:
        return {"which": "line", "parts": []}
    if set(whole) <= {"position", "orientation", "scale"}:
        return {"which": "_".join(whole), "parts": []}
    symbols: dict[str, str] = dict(zip((*NAMES, ABOUT_LINE), (*SHORT, "r"), strict=True))
    return {"which": "other", "parts": [symbols.get(name) or _combined(open_part(name)) for name in names]}


def _combined(part: Message) -> str:
    """Symbols of combinations of datum parameters: 2 (tX tY rZ)."""
    among = part.values["among"]
    assert isinstance(among, list)
    return f"{part.values['n']} ({' '.join(map(str, among))})"


def open_datum(names: tuple[str, ...]) -> list[str]:
    """Open parts of the datum, three components of a kind in one word."""
    left = list(names)
    for kind, word in (("position", "position"), ("rotation", "orientation")):
        all_three = [f"{kind} {axis}" for axis in "XYZ"]
        if set(all_three) <= set(left):
            at = left.index(all_three[0])
            left = [*left[:at], word, *(n for n in left[at:] if n not in all_three)]
    return left


def free_std(view: View) -> Array:
    """Standard deviations (k, 3) of the object points with a free coordinate [view.unit]."""
    if view.std is None:
        return np.zeros((0, 3))
    return view.std[np.isfinite(view.std).any(axis=1)]


def _precision(view: View) -> Text:
    a = view.adjustment
    if a.precision is None:
        return phrase("verdict.not_computed")
    std = free_std(view)
    if not len(std):
        return Text.of(*_resection(view))
    worst = np.unravel_index(int(np.nanargmax(np.nan_to_num(view.std))), view.std.shape)  # type: ignore[union-attr]
    axis, point = "XYZ"[int(worst[1])], view.given.points.ids[int(worst[0])]
    found = [
        note("verdict.std_rms"), each_axis(std, view.unit),
        note("verdict.std_largest", largest=float(np.nanmax(std)), unit=view.unit, axis=axis, point=point),
    ]  # fmt: skip
    if (few := few_hold(std)) is not None:
        found += [note("verdict.std_median"), each_axis(few.median, view.unit), held_by(few)]
    if (values := relative_values(view)) is not None:
        found.append(note("verdict.relative_precision", **values))
        if a.network is not None and classed(view.given):
            found.append(note("verdict.precision_class", name=class_of(a.network)))
    return Text.of(*found)


def _resection(view: View) -> list[Message]:
    precision = view.adjustment.precision
    assert precision is not None
    std = precision.image_std
    centre = np.nanmean(np.where(std[:, :3] > 0, std[:, :3], np.nan)) if (std[:, :3] > 0).any() else math.nan
    if not math.isfinite(centre):
        return [note("verdict.all_held")]
    angle = float(np.degrees(np.nanmean(np.where(std[:, 3:] > 0, std[:, 3:], np.nan))))
    centres = note("verdict.centres", centre=float(centre) * view.factor, unit=view.unit, angle_deg=angle)
    return [note("verdict.points_held"), centres]


def _accuracy(view: View) -> Text:
    difference = view.check_difference * view.factor
    if not np.isfinite(difference).any():
        if view.lengths is not None:
            return Text.of(note("verdict.tested_by_lengths"), *length_figures(view.lengths))
        return phrase("verdict.not_compared") if len(difference) else phrase("verdict.not_tested")
    known = int(np.isfinite(difference).any(axis=1).sum())
    found = [note("verdict.check_points", n=known), each_axis(difference, view.unit)]
    ratio = rms(difference / expected_check_std(view))
    if math.isfinite(ratio):
        count = int(np.isfinite(difference).sum())
        meaning = "chance"
        if any(n.code == "check_points_apart" for n in view.adjustment.notices):
            meaning = "larger"
        elif chi_square_tails(count * ratio**2, count)[0] < 0.001:
            meaning = "smaller"
        found.append(note("verdict.check_ratio", ratio=ratio, n=count, meaning=meaning))
    if view.free_frame:
        found.append(note("verdict.check_shift"))
    return Text.of(*found)


def expected_check_std(view: View) -> Array:
    """Standard deviation (k, 3) of adjusted minus given at check points [view.unit]; NaN without statistics."""
    rows = view.check_rows
    if view.std is None:
        return np.full((len(rows), 3), np.nan)
    given = np.nan_to_num(view.given.points.sigma[rows]) * view.factor
    return np.hypot(np.nan_to_num(view.std[rows], nan=np.nan), given)


def _fit(view: View) -> list[Message]:
    a = view.adjustment
    if a.redundancy == 0:
        return [note("verdict.no_fit")]
    return [note("verdict.sigma0", sigma0=a.sigma0), _tested(a)]


def _tested(a: Adjustment) -> Message:
    """The outcome of the global test."""
    lower, value, upper = a.global_test
    estimated = a.options.weights == "residuals"
    if a.options.variance_groups:
        return note("verdict.fit_groups")
    if lower <= value <= upper:
        return note("verdict.fit_from_residuals") if estimated else note("verdict.fit_passed")
    if value < lower:
        return note("verdict.fit_smaller_estimated") if estimated else note("verdict.fit_smaller")
    if a.sigma0 < NEARLY:
        harmless = all(n.severity is Severity.NOTE for n in a.notices)
        return note("verdict.fit_nearly", percent=round(100 * (NEARLY - 1)), harmless=harmless)
    return note("verdict.fit_larger")


def _control(view: View) -> list[Message]:
    kinds = ("control", "distance", "station")
    return [_of_group(view, g) for kind in kinds for g in view.adjustment.groups if g.kind == kind and len(g.sigma)]


def controlled(group: ObservationGroup) -> Mask:
    """(k,) whether a weighted observation is controlled by others, so that its residual states something."""
    return (group.sigma > 0) & ~(group.redundancy < UNCONTROLLED)


def _of_group(view: View, g: ObservationGroup) -> Message:
    """How control of one kind fits."""
    weighted, checked = int((g.sigma > 0).sum()), controlled(g)
    held = len(g.sigma) - weighted
    if not weighted:
        return note("verdict.control_held", kind=g.kind, n=held)
    if not checked.any():
        return note("verdict.control_unchecked", kind=g.kind, n=weighted)
    residual = g.residual[checked] * view.factor
    return note(
        "verdict.control_residual", kind=g.kind, rms=rms(residual), largest=float(np.nanmax(np.abs(residual))),
        unit=view.unit, n=weighted, held=held,
    )  # fmt: skip


def _blunders(view: View) -> list[Message]:
    a = view.adjustment
    lost = len(view.rejected)
    rejected = note("verdict.rejected", n=lost) if lost else note("verdict.none_rejected")
    critical = float(a.critical_tau)
    if a.precision is None or not math.isfinite(critical):
        return [rejected, note("verdict.blunders_not_tested")]
    t = np.abs(a.image_observations.t[view.used])
    beyond = int((np.nan_to_num(t).max(axis=1, initial=0) > critical).sum())
    if not beyond:
        return [rejected, note("verdict.none_beyond", critical=critical)]
    return [rejected, note("verdict.beyond", n=beyond, critical=critical, snooping=a.options.reject != "none")]


def _cameras(view: View) -> list[Message]:
    a = view.adjustment
    estimated = sum(len(i.free) for i in a.interior)
    if not estimated and not a.not_determinable:
        return [note("verdict.interior_held")]
    found = [note("verdict.interior_estimated", n=estimated)]
    if a.not_determinable:
        found.append(note("verdict.not_determinable", names=a.not_determinable))
    if a.not_significant:
        found.append(note("verdict.not_significant", names=a.not_significant))
    if not a.not_determinable and a.precision is not None:
        found += [note("verdict.interior_better"), *_least_certain(a)]
    return found


def _least_certain(a: Adjustment) -> list[Message]:
    """Which estimated parameter moves image points most within its standard deviation: it may be weak all the same."""
    stds = [
        (p.effect_std_px, p.symbol, i.camera)
        for i in a.interior
        for p in i.parameters.values()
        if p.symbol in i.free and p.effect_std_px is not None and math.isfinite(p.effect_std_px)
    ]
    if not stds:
        return []
    px, symbol, camera = max(stds)
    cameras = len({i.camera for i in a.interior})
    return [note("verdict.least_certain", symbol=symbol, camera=camera, cameras=cameras, px=px)]


def _weakest_control(view: View) -> list[Message]:
    """The coordinate of control whose errors hide best, and how large they are; empty where none is tested."""
    tested = [
        (float(mdb), component, name)
        for g in view.adjustment.groups
        if g.kind == "control"
        for mdb, component, name in zip(g.mdb, g.component, g.ids, strict=True)
        if math.isfinite(mdb)
    ]
    if not tested:
        return []
    mdb, component, name = max(tested)
    return [note("limits.weakest_control", component=component, point=name, mdb=mdb * view.factor, unit=view.unit)]


def limits(view: View) -> tuple[tuple[Text, Text], ...]:
    """Limits of the figures of this report."""
    a = view.adjustment
    held = any((g.sigma == 0).any() for g in a.groups if g.kind == "control")
    snooped = len(view.rejected) > 0 and a.options.reject == "snooping"
    common = phrase("limits.independent_errors" if a.noise.kind == "white" else "limits.common_errors")
    hidden = Text.of(note("limits.hidden_blunders"), *_weakest_control(view))
    datum = "limits.datum_unscaled" if "scale" in a.datum_defect else "limits.datum_scaled"
    found = [(phrase("limits.precision"), common), (phrase("limits.small_sigma0"), hidden)]
    found += [
        (phrase(title), phrase(sentence))
        for applies, title, sentence in (
            (not view.compared, "limits.no_comparison", "limits.own_accuracy"),
            (view.free_frame, "limits.datum", datum),
            (view.arbitrary_scale, "limits.no_scale", "limits.scale_chosen"),
            ("scale" in a.datum_defect and not a.free_scale, "limits.nominal_scale", "limits.nominal_length"),
            (held, "limits.held_control", "limits.control_sigma"),
            (not any(i.free for i in a.interior), "limits.held_interior", "limits.interior_errors"),
            (snooped, "limits.rejection", "limits.sigma0_after_rejection"),
        )
        if applies
    ]
    return tuple(found)
