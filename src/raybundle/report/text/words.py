"""The verdict: what was adjusted, how good it is, and what the numbers do not tell, in plain words."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Literal

import numpy as np

from raybundle.adjustment.counts import counts
from raybundle.adjustment.network import classed
from raybundle.adjustment.reliability import UNCONTROLLED
from raybundle.adjustment.result import Adjustment, NetworkFigures, ObservationGroup
from raybundle.adjustment.severity import NEARLY, POOR_FIT, Severity
from raybundle.adjustment.spread import FewHold, few_hold
from raybundle.numerics.arrays import Array, Mask
from raybundle.numerics.statistics import chi_square_tails
from raybundle.observations import observation_kinds
from raybundle.report.text.metrology_words import MM as LENGTH_MM
from raybundle.report.text.metrology_words import lengths_told
from raybundle.report.text.numbers import counted, grouped, listed, significant, unit_text
from raybundle.report.view import View, rms
from raybundle.settings import option

Grade = Literal["good", "remarks", "attention"]


@dataclass(frozen=True, slots=True, kw_only=True)
class Verdict:
    """The first thing that a reader sees."""

    grade: Grade
    headline: str
    statements: tuple[tuple[str, str], ...]


def verdict(view: View) -> Verdict:
    """The verdict on an adjustment."""
    statements = [
        ("Adjusted", _adjusted(view)),
        ("Precision", _precision(view)),
        ("Accuracy", _accuracy(view)),
        ("Fit", _fit(view)),
        ("Control", _control(view)),
        ("Blunders", _blunders(view)),
        ("Cameras", _cameras(view)),
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


def _headline(view: View, grade: Grade) -> str:
    a = view.adjustment
    if a.precision is None:
        return "Coordinates without a stated accuracy: the statistics were switched off."
    return f"{_gained(view)} {_state(view, grade)}".rstrip()


def _gained(view: View) -> str:
    """What was determined, and how well, in one sentence."""
    std, network = free_std(view), view.adjustment.network
    if not len(std):
        return _resection(view).removeprefix("All object points are held. ")
    if any(n.code == "levelled" for n in view.adjustment.notices):  # heights that nobody measured have no accuracy
        size = significant(rms(std[:, :2]), 2)
        return (
            f"{counted(len(std), 'object point')} with a standard deviation of {size} {view.unit} rms in X and Y; "
            "heights are relative."
        )
    each = significant(rms(std), 2)
    n = (
        ""
        if network is None or not math.isfinite(network.relative_precision)
        else f" ({_relative(network.relative_precision)} in the mean)"
    )
    if view.arbitrary_scale and network is not None and n:
        relative = _relative(network.relative_precision)
        return f"{counted(len(std), 'object point')} with a relative precision of {relative}; no length is absolute."
    if np.isfinite(view.check_difference).any():
        n += f", {significant(rms(view.check_difference) * view.factor, 2)} {view.unit} rms at the check points"
    elif view.lengths is not None:
        off = significant(view.lengths.rms * LENGTH_MM, 2)
        n += f", {off} mm rms at {counted(view.lengths.independent, 'length')} that took no part"
    deviation = f"{each} {view.unit} rms a coordinate"
    if (few := few_hold(std)) is not None:
        deviation = (
            f"{significant(few.coordinate, 2)} {view.unit} a coordinate in the median ({each} {view.unit} rms, "
            f"{held_by(few)})"
        )
    return f"{counted(len(std), 'object point')} with a standard deviation of {deviation}{n}."


def held_by(few: FewHold) -> str:
    """Whose the variance is."""
    return f"{100 * few.share:.0f} % of the variance is that of {counted(few.points, 'point')}"


def left_out(network: NetworkFigures) -> str:
    """Which points the mean standard deviation leaves out, as the end of a sentence; empty where none."""
    share = 100 * (1 - network.mean_share)
    return "" if share == 0 else f", without the {share:.0f} % of the points that are least precise"


def relative_words(view: View) -> str:
    """The quotient behind 1 : N in numbers that a reader can divide; empty where there is none."""
    network = view.adjustment.network
    if network is None or not math.isfinite(network.relative_precision):
        return ""
    mean, extent = significant(network.mean_std * view.factor), significant(network.extent)
    few = left_out(network)
    return f"mean standard deviation {mean} {view.unit} of an extent of {extent} {view.length_unit}{few}"


def _relative(relative: float) -> str:
    return f"1\u00a0:\u00a0{grouped(float(f'{relative:.2g}'))}"


def _state(view: View, grade: Grade) -> str:
    """Whether that can be relied upon, in one sentence."""
    a = view.adjustment
    if a.redundancy == 0:
        return "Nothing checks it: there are no more observations than unknowns."
    serious = sum(1 for n in a.notices if n.severity is Severity.FAULT)
    if a.sigma0 > POOR_FIT:
        return (
            f"But the observations contradict each other {significant(a.sigma0, 2)} times more than stated: find out "
            "why first."
        )
    if grade == "attention":
        return f"{counted(serious, 'matter')} to settle before it is used: see the warnings."
    systematic = {n.code for n in a.notices} & {"systematic_residuals", "residual_structure", "noise_in_parts"}
    scale = any(n.code == "scale_unchecked" for n in a.notices)
    alone = " The scale rests on lengths that nothing controls." if scale else ""
    if systematic:
        return f"But the residuals have a systematic part, which these figures leave out: see the warnings.{alone}"
    return (_fits(view) + alone).strip()


def _fits(view: View) -> str:
    """How the observations fit, in one sentence."""
    a = view.adjustment
    lower, value, upper = a.global_test
    if value > upper and significant(a.sigma0, 2) != significant(1.0, 2):
        return (
            f"The observations fit {significant(a.sigma0, 2)} times worse than stated, which these figures take into "
            "account."
        )
    if a.options.weights == "residuals":  # that they fit is no test then, which "Fit" says
        return ""
    if value < lower:
        return f"The observations fit better than stated (σ₀ {significant(a.sigma0, 2)})."
    return "The observations fit each other and the model as stated."


def unsettled(view: View) -> str:
    """What a headline of another kind, as that of a calibration, has to add where there are faults; else empty."""
    serious = sum(1 for n in view.adjustment.notices if n.severity is Severity.FAULT)
    return f" {counted(serious, 'matter')} to settle before it is used: see the warnings." if serious else ""


def _adjusted(view: View) -> str:
    a = view.adjustment
    n = counts(a)
    parts = [
        f"{counted(n.images_used, 'image')} of {counted(len(view.cameras()), 'camera')}",
        counted(n.points_used, "object point"),
        counted(n.image_observations_used, "image observation"),
    ]
    for count, noun in (
        (len({i for g in a.groups if g.kind == "control" for i in g.ids}), "control point"),
        (len(view.check_rows), "check point"),
        *((len(np.unique(g.item)), observation_kinds[g.kind].noun) for g in a.groups if observation_kinds[g.kind].noun),
    ):
        if count:
            parts.append(counted(count, noun))
    return (
        f"{', '.join(parts)}; {counted(a.unknowns, 'unknown')}, redundancy {grouped(a.redundancy)}. {datum_words(view)}"
    )


def datum_words(view: View) -> str:
    """The datum in a sentence that a client understands."""
    a = view.adjustment
    if not a.datum_defect:
        return "Position, orientation and scale are fixed by what was given."
    open_parts = listed(open_datum(a.datum_defect), 7)
    tail = " Lengths have no absolute unit: nothing fixes the scale." if view.arbitrary_scale else ""
    return f"Nothing given fixes {open_parts}; there the datum is: {a.datum}.{tail}"


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


def _precision(view: View) -> str:
    a = view.adjustment
    if a.precision is None:
        return "Standard deviations were not computed. Adjust again with statistics."
    std = free_std(view)
    if not len(std):
        return _resection(view)
    each = ", ".join(f"{axis} {significant(rms(std[:, k]))}" for k, axis in enumerate("XYZ"))
    worst = np.unravel_index(int(np.nanargmax(np.nan_to_num(view.std))), view.std.shape)  # type: ignore[union-attr]
    where = f"{'XYZ'[int(worst[1])]} of point {view.given.points.ids[int(worst[0])]}"
    text = (
        f"Standard deviation of the object points (rms): {each} {view.unit}; the largest is "
        f"{significant(float(np.nanmax(std)))} {view.unit} ({where})."
    )
    if (few := few_hold(std)) is not None:
        middle = ", ".join(f"{axis} {significant(m)}" for axis, m in zip("XYZ", few.median, strict=True))
        text += f" Their medians are {middle} {view.unit}: {held_by(few)} of {grouped(few.of)}, far away as a rule."
    network = a.network
    if network is not None and math.isfinite(network.relative_precision):
        text += f" Relative precision {_relative(network.relative_precision)}: {relative_words(view)}"
        text += f"; class: {network.precision_class}." if classed(view.given) else "."
    return text


def _resection(view: View) -> str:
    precision = view.adjustment.precision
    assert precision is not None
    std = precision.image_std
    centre = np.nanmean(np.where(std[:, :3] > 0, std[:, :3], np.nan)) if (std[:, :3] > 0).any() else math.nan
    if not math.isfinite(centre):
        return "All object points and images are held."
    angle = np.degrees(np.nanmean(np.where(std[:, 3:] > 0, std[:, 3:], np.nan)))
    return (
        "All object points are held. Standard deviation of the projection centres (mean): "
        f"{significant(float(centre) * view.factor)} {view.unit}, of the angles {significant(float(angle))}°."
    )


def _accuracy(view: View) -> str:
    difference = view.check_difference * view.factor
    if not np.isfinite(difference).any():
        if len(difference) and view.lengths is None:
            return (
                "Check points are not compared: the datum fixes none of their coordinates, so that the accuracy is not "
                "tested by anything that the adjustment did not use."
            )
        if view.lengths is not None:
            return (
                "There are no check points; the accuracy is tested by known lengths, which the adjustment did not use: "
                f"{lengths_told(view.lengths)}."
            )
        return "There are no check points: the accuracy is not tested by anything that the adjustment did not use."
    known = int(np.isfinite(difference).any(axis=1).sum())
    each = ", ".join(
        f"{axis} {significant(rms(difference[:, k]))}"
        for k, axis in enumerate("XYZ")
        if np.isfinite(difference[:, k]).any()
    )
    text = f"At {counted(known, 'check point')} the rms difference, adjusted minus given, is {each} {view.unit}."
    expected = expected_check_std(view)
    ratio = rms(difference / expected)
    if math.isfinite(ratio):
        apart = any(n.code == "check_points_apart" for n in view.adjustment.notices)
        count = int(np.isfinite(difference).sum())
        meaning = f"within chance of {counted(count, 'value')}"
        if apart:
            meaning = "more than the standard deviations promise: see the warnings"
        elif chi_square_tails(count * ratio**2, count)[0] < 0.001:
            meaning = f"less than {counted(count, 'value')} differ by chance, unless they have errors in common"
        text += f" That is {significant(ratio, 2)} times what the standard deviations predict ({meaning})."
    if view.free_frame:
        text += " The datum is not that of the check points, so the differences hold its shift as well."
    return text


def expected_check_std(view: View) -> Array:
    """Standard deviation (k, 3) of adjusted minus given at check points [view.unit]; NaN without statistics."""
    rows = view.check_rows
    if view.std is None:
        return np.full((len(rows), 3), np.nan)
    given = np.nan_to_num(view.given.points.sigma[rows]) * view.factor
    return np.hypot(np.nan_to_num(view.std[rows], nan=np.nan), given)


def _fit(view: View) -> str:
    a = view.adjustment
    if a.redundancy == 0:
        return "There is no redundancy: the fit cannot be tested, and no blunder can be found."
    lower, value, upper = a.global_test
    sigma0 = f"σ₀ = {significant(a.sigma0)} (a priori 1)"
    if a.options.variance_groups:
        return (
            f"{sigma0}, as it must be: each group of observations has the variance factor that its residuals tell, and "
            "where they tell none its stated precision."
        )
    if lower <= value <= upper and a.options.weights == "residuals":
        return f"{sigma0}, as it must be: the standard deviations of the image points were taken from these residuals."
    if lower <= value <= upper:
        return (
            f"{sigma0}: the residuals are as large as the stated precision of the observations says (global test at "
            "5 %)."
        )
    if value < lower and a.options.weights == "residuals":
        return (
            f"{sigma0}: the residuals are smaller than when the standard deviations of the image points were taken "
            "from them, which says nothing of the observations. All standard deviations here carry the smaller value."
        )
    if value < lower:
        return (
            f"{sigma0}: the observations are more precise than stated (global test at 5 %). All standard deviations "
            "here carry the smaller value."
        )
    if a.sigma0 < NEARLY:
        text = (
            f"{sigma0}: the residuals are larger than stated (global test at 5 %), by less than "
            f"{100 * (NEARLY - 1):.0f} %, which so many observations show. All standard deviations here carry the "
            "larger value."
        )
        return text + (" That harms nothing." if all(n.severity is Severity.NOTE for n in a.notices) else "")
    return (
        f"{sigma0}: the residuals are larger than stated (global test at 5 %). Either the observations are less "
        "precise than assumed, or the model lacks something, or blunders are left. All standard deviations here "
        "carry the larger value."
    )


def _control(view: View) -> str:
    kinds = (("control", "control coordinates"), ("distance", "scale bars"), ("station", "projection centres"))
    words = [
        told
        for kind, noun in kinds
        for g in view.adjustment.groups
        if g.kind == kind and (told := _group_words(view, g, noun))
    ]
    text = "; ".join(words)
    return f"{text[0].upper()}{text[1:]}." if text else ""


def controlled(group: ObservationGroup) -> Mask:
    """(k,) whether a weighted observation is controlled by others, so that its residual says something."""
    return (group.sigma > 0) & ~(group.redundancy < UNCONTROLLED)


def _group_words(view: View, g: ObservationGroup, noun: str) -> str:
    weighted, told = int((g.sigma > 0).sum()), controlled(g)
    held = len(g.sigma) - weighted
    if not weighted:
        return f"{grouped(held)} {noun} held as given; they are not tested by residuals of their own"
    if not told.any():
        return f"{noun}: {grouped(weighted)} observed, all needed to fix the datum; nothing controls them"
    residual = g.residual[told] * view.factor
    also = f", {grouped(held)} held" if held else ""
    return (
        f"{noun}: rms residual {significant(rms(residual))} {view.unit}, largest "
        f"{significant(float(np.nanmax(np.abs(residual))))} {view.unit} ({grouped(weighted)} observed{also})"
    )


def _blunders(view: View) -> str:
    a = view.adjustment
    lost = len(view.rejected)
    t = np.abs(a.image_observations.t[view.used])
    beyond = (
        int((np.nan_to_num(t).max(axis=1, initial=0) > a.critical_tau).sum()) if math.isfinite(a.critical_tau) else 0
    )
    text = (
        f"{counted(lost, 'image observation')} rejected, listed with the reasons."
        if lost
        else "No observation was rejected."
    )
    if a.precision is None or not math.isfinite(a.critical_tau):
        return text + " Blunders were not tested."
    if beyond:
        text += (
            f" {counted(beyond, 'image observation')} with a residual beyond the critical value of "
            f"{significant(a.critical_tau)} standard deviations took part"
            + (f"; consider data snooping ({option('reject', 'snooping')})." if a.options.reject == "none" else ".")
        )
    else:
        text += f" No residual exceeds the critical value of {significant(a.critical_tau)} standard deviations."
    return text


def _cameras(view: View) -> str:
    a = view.adjustment
    estimated = sum(len(i.free) for i in a.interior)
    if not estimated and not a.not_determinable:
        return "The interior orientation was given and held; its errors are not in the standard deviations."
    parts = [f"{counted(estimated, 'parameter')} of the interior orientation estimated"]
    if a.not_determinable:
        parts.append(f"not determinable by this network: {listed(a.not_determinable)}")
    if a.not_significant:
        parts.append(f"not significant and left out: {listed(a.not_significant)}")
    if not a.not_determinable and a.precision is not None:
        parts.append(f"all of them better than known beforehand{_least_certain(a)}")
    return f"{'; '.join(parts)}."


def _least_certain(a: Adjustment) -> str:
    """Which estimated parameter moves image points most within its standard deviation: it may be weak all the same."""
    stds = [
        (p.effect_std_px, p.symbol, i.camera)
        for i in a.interior
        for p in i.parameters.values()
        if p.symbol in i.free and p.effect_std_px is not None and math.isfinite(p.effect_std_px)
    ]
    if not stds:
        return ""
    px, symbol, camera = max(stds)
    of = f" of camera {camera}" if len({i.camera for i in a.interior}) > 1 else ""
    return f", the least certain {symbol}{of} with {significant(px, 2)} px (its standard deviation in the image)"


INDEPENDENT_ERRORS = """\
A standard deviation describes random errors that are independent from one image point to the next. An error common to \
many of them (distortion that the model lacks, eccentric targets, refraction, an unstable camera) is not in it."""
COMMON_ERRORS = """\
A standard deviation describes random errors, here with smooth ones that differ from image to image. An error common \
to all of them (distortion that the model lacks, eccentric targets, refraction) is not in it."""
HIDDEN_BLUNDERS = """\
Residuals show only what the redundancy lets through: a share r of each error. Blunders below the smallest detectable \
ones stay in the result."""
NO_COMPARISON = """\
Without check points, or a length that took no part, the accuracy stated here is the network's own opinion."""
DATUM_OF_SIGMAS = "They describe the shape of the object, not its place in a superior coordinate system"
NO_SCALE = (
    "The scale was chosen, not measured: lengths are in units of their own. Give a scale bar or two control points."
)
NOMINAL_SCALE = """\
All lengths are as right as the length that was given for the target. Its error is in no standard deviation."""
HELD_CONTROL = """\
Its real uncertainty is missing in all standard deviations; give control with its standard deviation instead."""
HELD_INTERIOR = "It was held; what is wrong with it goes into the object coordinates unseen."
AFTER_REJECTION = "σ₀ after data snooping is estimated from the observations that were kept."


def datum_of_sigmas(defect: tuple[str, ...]) -> str:
    """What the standard deviations mean where these parts of the datum are open, and what is free of it."""
    if "scale" in defect:
        return f"{DATUM_OF_SIGMAS}, nor its size; angles and ratios of distances are free of it, distances are not."
    return f"{DATUM_OF_SIGMAS}; distances and angles are free of it."


def _weakest_control(view: View) -> str:
    """The coordinate of control whose errors hide best, and how large they are; "" where none is tested."""
    tested = [
        (float(mdb), component, name)
        for g in view.adjustment.groups
        if g.kind == "control"
        for mdb, component, name in zip(g.mdb, g.component, g.ids, strict=True)
        if math.isfinite(mdb)
    ]
    if not tested:
        return ""
    mdb, component, name = max(tested)
    size = f"{significant(mdb * view.factor, 2)} {view.unit}"
    return (
        f" The weakest tested control coordinate is {component} of {name}: of errors of {size} one in five is missed."
    )


def not_told(view: View) -> tuple[tuple[str, str], ...]:
    """What the numbers of this report do not tell."""
    a = view.adjustment
    held = any((g.sigma == 0).any() for g in a.groups if g.kind == "control")
    snooped = len(view.rejected) > 0 and a.options.reject == "snooping"
    found = (
        (True, "Precision is not accuracy.", INDEPENDENT_ERRORS if a.noise.kind == "white" else COMMON_ERRORS),
        (
            True,
            "A small σ₀ is no proof of correct coordinates.",
            " ".join(filter(None, [HIDDEN_BLUNDERS, _weakest_control(view)])),
        ),
        (not view.compared, "Nothing independent was compared.", NO_COMPARISON),
        (view.free_frame, "The standard deviations belong to the datum stated.", datum_of_sigmas(a.datum_defect)),
        (view.arbitrary_scale, "No length is absolute.", NO_SCALE),
        ("scale" in a.datum_defect and not a.free_scale, "The scale was given, not measured.", NOMINAL_SCALE),
        (held, "Held control counts as free of error.", HELD_CONTROL),
        (not any(i.free for i in a.interior), "The interior orientation counts as free of error.", HELD_INTERIOR),
        (snooped, "What is left after rejection looks better than it is.", AFTER_REJECTION),
    )
    return tuple((title, sentence) for applies, title, sentence in found if applies)
