"""Two result folders side by side: statistics, interior orientations, points after a similarity, images, warnings."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any, cast

import numpy as np

from raybundle.adjustment.records.severity import SEVERITY, Severity
from raybundle.errors import InputError, Text, joined_texts, note, phrase
from raybundle.io.folders import new_files
from raybundle.io.reading.files import read_text
from raybundle.numerics.arrays import Array
from raybundle.numerics.rotation import rotation_from_angles
from raybundle.numerics.transform import Similarity, similarity
from raybundle.report.comparison.common_points import Common, common_points, common_rows
from raybundle.report.comparison.differences import (
    PARAMETERS,
    SMALL_BASIS,
    PointDifferences,
    as_float,
    basis_words,
    columns_of,
    compared,
    taken_otherwise,
    to_first,
)
from raybundle.report.comparison.shared import Shared, shared_of
from raybundle.report.languages import ENGLISH
from raybundle.report.parts import Folded, Heading, Paragraph, Part, Section, Table, number, pick, table, text
from raybundle.report.text.numbers import (
    NONE,
    cells,
    column_decimals,
    fixed,
    grouped,
    significant,
    unit_text,
    with_sigma,
)
from raybundle.report.view import rms
from raybundle.results.folder import ResultFolder

LIMIT = 3.29
"""Differences beyond so many standard deviations stand out."""
LARGEST = 25


def write_comparison(first: ResultFolder, second: ResultFolder, path: str | Path) -> tuple[str, ...]:
    """Write one self-contained HTML file that puts two results side by side.

    first, second  what `read_result` returns
    path           the file; its folder exists
    returns        cautions that stand on the page, for who reads the command line alone
    raises         InputError where something else than an older comparison stands there

    Points that nobody named are common where their image points agree (`common_points`).  Where no points are common,
    the similarity is that of the projection centres.
    Differences are second minus first.  If the observations of one result are part of the other's, a difference is
    compared with the root of the difference of both variances; else with that of their sum, as for independent
    results.  If the results share image observations, this sum is too large; the head of the page has a warning
    (`report.comparison.shared`).
    """
    if Path(path).exists() and not is_comparison(Path(path)):
        raise InputError("comparison.path_taken", file=path)
    shared = shared_of(first, second)
    points, differences = _differences(first, second, shared)
    html = _html(first, second, points, differences, shared)
    with new_files(Path(path)) as (file,):
        file.write_text(html, encoding="utf-8")
    sentences = shared.sentences if shared.too_large or shared.noise else ()
    return (*_cautions(first, second, differences), *sentences)


def comparison(first: ResultFolder, second: ResultFolder, language: str = ENGLISH) -> str:
    """The page that `write_comparison` writes."""
    shared = shared_of(first, second)
    return _html(first, second, *_differences(first, second, shared), shared, language)


def _differences(first: ResultFolder, second: ResultFolder, shared: Shared) -> tuple[Common, list[PointDifferences]]:
    """The common points, and their differences after a similarity and as they stand."""
    points = common_points(first.points.text["point"], second.points.text["point"], (first.block, second.block))
    found = (compared(first, second, points, fitted=fitted, shared=shared) for fitted in (True, False))
    return points, [d for d in found if d]


def _html(
    first: ResultFolder, second: ResultFolder, points: Common, differences: Sequence[PointDifferences], shared: Shared,
    language: str = ENGLISH,
) -> str:  # fmt: skip
    from raybundle.report.document import page

    sections = (
        Section(anchor="summary", title=phrase("report_compare.summary"), parts=_summary(first, second)),
        Section(anchor="interior", title=phrase("report_compare.interior"), parts=_interior(first, second, shared)),
        Section(
            anchor="points", title=phrase("report_compare.points"), parts=_points(first, points, differences, shared)
        ),
        Section(anchor="images", title=phrase("report_compare.images"), parts=_images(first, second, differences)),
        Section(anchor="warnings", title=phrase("report_compare.warnings"), parts=_warnings(first, second)),
    )
    sentences = _apart(first.path, second.path)
    return page(
        title=phrase("report_compare.title", first=_name(first), second=_name(second)),
        subtitle=phrase("report_compare.subtitle", first=sentences[0], second=sentences[1]),
        headline=_headline(first, second, points, differences, shared),
        grade="remarks",
        sections=sections,
        language=language,
    )


def _cautions(first: ResultFolder, second: ResultFolder, differences: Sequence[PointDifferences]) -> tuple[str, ...]:
    """What the page states of the similarity that its differences come after, where it rests on little."""
    fitted = next((d for d in differences if d.fit is not None), None)
    if fitted is not None:
        count, centres = len(fitted.ids), False
    elif not differences and _by_centres(*(both := _common_centres(first, second))) is not None:
        count, centres = _known_in_both(*both), True
    else:
        return ()
    return (basis_words(count, centres=centres),) if 3 * count - PARAMETERS < SMALL_BASIS else ()


def _common_centres(first: ResultFolder, second: ResultFolder) -> tuple[Array, Array]:
    """Projection centres (n, 3) of the images that both have, in the first's unit."""
    common = common_rows(first.images.text["image"], second.images.text["image"])
    of_first = columns_of(first.images, "XYZ", common.first)
    return of_first, to_first(first, second) * columns_of(second.images, "XYZ", common.second)


def _known_in_both(centre: Array, other: Array) -> int:
    """Rows of which both have all three coordinates."""
    return int((np.isfinite(centre) & np.isfinite(other)).all(axis=1).sum())


MARK = "Comparison of two adjustments."
"""By which a page that this module wrote is known."""


def is_comparison(path: Path) -> bool:
    """Whether a file is a page that `write_comparison` wrote."""
    try:
        return MARK in read_text(path)
    except InputError:
        return False


def _name(result: ResultFolder) -> str:
    return str(result.result.get("name") or result.path.name)


def _apart(first: Path, second: Path) -> tuple[str, str]:
    """The last folders of two paths, as many as distinguish them: "a/result" and "b/result"."""
    a, b = first.resolve().parts, second.resolve().parts
    for n in range(1, max(len(a), len(b)) + 1):
        if a[-n:] != b[-n:]:
            return "/".join(a[-n:]), "/".join(b[-n:])
    return first.name, second.name


def _headline(
    first: ResultFolder, second: ResultFolder, common: Common, differences: Sequence[PointDifferences], shared: Shared
) -> str:
    a, b = (as_float(r.result.get("sigma0")) for r in (first, second))
    found = [note("report_compare.sigma0", first=a, second=b)]
    ratios = [abs(r) for row in _parameter_rows(first, second, shared) if math.isfinite(r := row.ratio)]
    if ratios:
        found.append(note("report_compare.interior_ratio", ratio=max(ratios), part=bool(shared.part)))
    if differences:
        d, (factor, unit) = differences[0], _small(first)
        size, fitted = rms(d.difference) * factor, d.fit is not None
        found.append(note("report_compare.points_differ", n=len(d.ids), rms=size, unit=unit, fitted=fitted))
        if d.fit is not None and d.redundancy < SMALL_BASIS:
            found.append(note("report_compare.small_redundancy", n=d.redundancy))
    elif common.namesakes:
        found.append(note("report_compare.no_same_point"))
    return Text.of(*found, *(m for text in shared.sentences for m in text.messages))


def _small(result: ResultFolder) -> tuple[float, str]:
    """Factor to, and name of, the unit in which differences are shown."""
    if result.block.free_scale:
        return 1.0, "units"
    return (1000.0, "mm") if result.block.length_unit == "m" else (1.0, "mm")


SUMMARY = (
    "sigma0", "redundancy", "observations", "unknowns", "constraints", "image_points", "rejected", "images_count",
    "points_count", "relative_precision", "iterations", "seconds",
)  # fmt: skip
"""Numbers of result.json"""


def _summary(first: ResultFolder, second: ResultFolder) -> tuple[Part, ...]:
    rows: list[tuple[str, str, str, str]] = []
    for key in SUMMARY:
        quantity = phrase("report_compare.quantity", name=key)
        a, b = as_float(first.result.get(key)), as_float(second.result.get(key))
        whole = key not in {"sigma0", "seconds"}
        shown = [grouped(v) if whole else significant(v, 5 if key == "sigma0" else 3) for v in (a, b)]
        change = b - a
        rows.append(
            (quantity, shown[0], shown[1], "" if change == 0 else grouped(change) if whole else significant(change, 3))
        )
    for key in ("datum", "raybundle"):
        quantity = phrase("report_compare.quantity", name=key)
        rows.append((quantity, str(first.result.get(key, NONE)), str(second.result.get(key, NONE)), ""))
    settings = [cast("Mapping[str, Any]", r.result.get("options") or {}) for r in (first, second)]
    for key in sorted(set(settings[0]) | set(settings[1])):
        a, b = (s.get(key) for s in settings)
        if a != b:
            rows.append((phrase("report_compare.setting", name=key), str(a), str(b), ""))
    columns = (
        text(phrase("label.quantity")), text(phrase("report_compare.first")), text(phrase("report_compare.second")),
        number(phrase("report_compare.difference")),
    )  # fmt: skip
    return (
        table(columns, zip(*rows, strict=True)),
        Paragraph(text=taken_otherwise(first, second)),
    )


@dataclass(frozen=True, slots=True, kw_only=True)
class _ParameterRow:
    camera: str
    symbol: str
    unit: str
    values: tuple[float, float]
    std: tuple[float, float]
    shared: Shared

    @property
    def ratio(self) -> float:
        """Difference in its standard deviations; NaN where both are held or one is missing."""
        sigma = float(self.shared.std(*(np.array(s if math.isfinite(s) else 0.0) for s in self.std)))
        return (self.values[1] - self.values[0]) / sigma if sigma > 0 else math.nan


def _parameter_rows(first: ResultFolder, second: ResultFolder, shared: Shared) -> list[_ParameterRow]:
    """Parameters that both results have."""
    a, b = (
        cast("Mapping[str, Mapping[str, Mapping[str, Any]]]", r.result.get("cameras") or {}) for r in (first, second)
    )
    return [
        _ParameterRow(
            camera=camera,
            symbol=symbol,
            unit=str(p.get("unit", "")),
            values=(as_float(p.get("value")), as_float(b[camera][symbol].get("value"))),
            std=(as_float(p.get("std")), as_float(b[camera][symbol].get("std"))),
            shared=shared,
        )
        for camera in a
        if camera in b
        for symbol, p in a[camera].items()
        if symbol in b[camera]
    ]


def _interior(first: ResultFolder, second: ResultFolder, shared: Shared) -> tuple[Part, ...]:
    rows = _parameter_rows(first, second, shared)
    cameras = [set(cast("Mapping[str, Any]", r.result.get("cameras") or {})) for r in (first, second)]
    alone = sorted(cameras[0] ^ cameras[1])
    parts: list[Part] = []
    if alone:
        parts.append(Paragraph(text=phrase("report_compare.cameras_of_one", names=alone)))
    if not rows:
        return (*parts, Paragraph(text=phrase("report_compare.no_common_camera")))
    shown = [(with_sigma(r.values[0], r.std[0]), with_sigma(r.values[1], r.std[1])) for r in rows]
    difference = [with_sigma(r.values[1] - r.values[0], _least(r.std))[0] for r in rows]
    body = table(
        (
            text(phrase("label.camera")), text(phrase("label.symbol")), text(phrase("label.unit")),
            number(phrase("report_compare.first")), number(phrase("label.sigma")),
            number(phrase("report_compare.second")), number(phrase("label.sigma")),
            number(phrase("report_compare.difference")),
            number(phrase("report_compare.in_sigmas", part=bool(shared.part))),
        ),
        (
            [r.camera for r in rows], [r.symbol for r in rows], [unit_text(r.unit) for r in rows],
            [s[0][0] for s in shown],
            [s[0][1] for s in shown], [s[1][0] for s in shown], [s[1][1] for s in shown], difference,
            cells([r.ratio for r in rows], 2),
        ),
        note=Text.of(shared.meaning, note("report_compare.correlated")),
        rest="result.json",
        marked=[k for k, r in enumerate(rows) if abs(r.ratio) > LIMIT],
    )  # fmt: skip
    return (*parts, body)


def _least(std: tuple[float, float]) -> float:
    known = [s for s in std if math.isfinite(s) and s > 0]
    return min(known) if known else math.nan


def _points(
    first: ResultFolder, common: Common, differences: Sequence[PointDifferences], shared: Shared
) -> tuple[Part, ...]:
    parts: list[Part] = [Paragraph(text=phrase("report_compare.common_points", n=len(common.ids)))]
    for which, ids in (("first", common.only_first), ("second", common.only_second)):
        if ids:
            parts.append(Paragraph(text=phrase("report_compare.only_in", which=which, names=list(ids)), note=True))
    if common.namesakes:
        words = phrase("report_compare.namesakes", n=len(common.namesakes), names=list(common.namesakes))
        parts.append(Paragraph(text=words, note=True))
    for d in differences:
        parts += _point_parts(first, d, shared)
    if len(differences) > 1:
        parts.append(Paragraph(text=phrase("report_compare.free_datum"), note=True))
    if not any(d.fit for d in differences):
        parts.append(Paragraph(text=phrase("report_compare.too_few_points"), note=True))
    return tuple(parts)


def _point_parts(first: ResultFolder, d: PointDifferences, shared: Shared) -> list[Part]:
    factor, unit = _small(first)
    parts: list[Part] = [Heading(text=phrase("report_compare.transformed", fitted=d.fit is not None))]
    if d.fit is not None:
        parts.append(Paragraph(text=basis_words(len(d.ids), centres=False)))
        turn = math.degrees(math.acos(min(1.0, max(-1.0, (float(np.trace(d.fit.rotation)) - 1) / 2))))
        length = "units" if first.block.free_scale else first.block.length_unit
        parts.append(
            Paragraph(
                text=phrase(
                    "report_compare.transformation",
                    larger=d.fit.scale >= 1,
                    scale=abs(d.fit.scale - 1),
                    rotation_deg=turn,
                    translation=d.fit.translation.tolist(),
                    unit=length,
                )
            )
        )
    values, std = d.difference * factor, d.std * factor
    ratio = np.abs(d.difference) / np.where(d.std > 0, d.std, np.nan)
    places = column_decimals(std)
    rows = [
        [
            axis,
            fixed(float(v.mean()), places),
            significant(rms(v)),
            significant(float(np.abs(v).max())),
            fixed(rms(r), 2),
        ]
        for axis, v, r in zip("XYZ", values.T, ratio.T, strict=True)
    ]
    parts.append(
        table(
            (
                text(phrase("label.coordinate")),
                number(phrase("label.mean"), unit),
                number(phrase("label.rms"), unit),
                number(phrase("label.largest"), unit),
                number(phrase("report_compare.rms_ratio")),
            ),
            zip(*rows, strict=True),
        )
    )
    parts.append(
        Folded(summary=phrase("report_compare.largest_differences"), parts=(_largest(d, values, std, unit, shared),))
    )
    return parts


def _largest(d: PointDifferences, values: Array, std: Array, unit: str, shared: Shared) -> Table:
    order = np.argsort(-np.linalg.norm(values, axis=1), kind="stable")[:LARGEST]
    decimals = column_decimals(std)
    return table(
        (
            text(phrase("label.point")),
            *(number(f"d{axis}", unit) for axis in "XYZ"),
            *(number(phrase("report_compare.sigma_of", part=bool(shared.part), axis=axis), unit) for axis in "XYZ"),
        ),
        (
            pick(order, d.ids),
            *(cells(values[order, k].tolist(), decimals) for k in range(3)),
            *(cells(std[order, k].tolist(), decimals) for k in range(3)),
        ),
    )


def _images(first: ResultFolder, second: ResultFolder, differences: Sequence[PointDifferences]) -> tuple[Part, ...]:
    """Projection centres and rotations, the second in the frame of the first where there is a similarity."""
    common = common_rows(first.images.text["image"], second.images.text["image"])
    parts: list[Part] = [Paragraph(text=phrase("report_compare.common_images", n=len(common.ids)))]
    for which, ids in (("first", common.only_first), ("second", common.only_second)):
        if ids:
            parts.append(Paragraph(text=phrase("report_compare.only_in", which=which, names=list(ids)), note=True))
    if not len(common.ids):
        return tuple(parts)
    fit = differences[0].fit if differences else None
    angles = ("omega_deg", "phi_deg", "kappa_deg")
    centre, other = _common_centres(first, second)
    R = rotation_from_angles(np.radians(columns_of(first.images, angles, common.first)))
    S = rotation_from_angles(np.radians(columns_of(second.images, angles, common.second)))
    by_points = fit is not None
    if fit is None and not differences:
        fit = _by_centres(centre, other)
    own = _by_centres(centre, other)
    good = _known_in_both(centre, other)
    both = [_second_opinion(first, own, centre, other, good)] if by_points and own is not None else []
    if fit is not None:
        other, S = fit.points(other), fit.rotations(S)
        if not by_points:
            parts.append(Paragraph(text=basis_words(good, centres=True)))
    factor, unit = _small(first)
    shift = np.linalg.norm(other - centre, axis=1) * factor
    turn = np.degrees(2 * np.arcsin(np.clip(np.linalg.norm(S - R, axis=(1, 2)) / math.sqrt(8), 0, 1)))
    by = "none" if fit is None else "points" if by_points else "centres"
    summary = phrase("report_compare.centres", rms=rms(shift), unit=unit, rotation_deg=rms(turn), by=by)
    order = np.argsort(-np.nan_to_num(shift), kind="stable")
    body = table(
        (
            text(phrase("label.image")),
            number(phrase("report_compare.projection_centre"), unit),
            number(phrase("report_compare.rotation"), "°"),
        ),
        (
            pick(order, common.ids),
            [significant(float(v)) for v in shift[order]],
            [significant(float(v)) for v in turn[order]],
        ),
        rest="images.csv",
    )
    sentences = [Paragraph(text=words) for words in (summary, *both)]
    return (*parts, *sentences, Folded(summary=phrase("report_compare.all_images"), parts=(body,)))


def _second_opinion(first: ResultFolder, fit: Similarity, centre: Array, other: Array, good: int) -> Text:
    """What projection centres differ by after a similarity of their own: a basis apart from the points'."""
    factor, unit = _small(first)
    left = np.linalg.norm(fit.points(other) - centre, axis=1) * factor
    own = phrase("report_compare.own_transformation", rms=rms(left), unit=unit)
    return joined_texts(own, basis_words(good, centres=True))


def _by_centres(centre: Array, other: Array) -> Similarity | None:
    """The similarity onto projection centres (n, 3) from others; None where these do not determine it."""
    good = np.isfinite(centre).all(axis=1) & np.isfinite(other).all(axis=1)
    try:
        return similarity(other[good], centre[good])
    except InputError:
        return None


def _warnings(first: ResultFolder, second: ResultFolder) -> tuple[Part, ...]:
    """Notices of both, the gravest first; results of older versions do not say how grave theirs are: by the code."""
    a, b = (
        [
            (
                str(w.get("severity") or SEVERITY.get(str(w["code"]), Severity.WARNING)),
                str(w["code"]),
                str(w["message"]),
            )
            for w in r.result.get("warnings") or []
        ]
        for r in (first, second)
    )
    both, one, two = (phrase(code) for code in ("report_compare.both", "report_compare.first", "report_compare.second"))
    rows = [(both if w in b else one, *w) for w in a] + [(two, *w) for w in b if w not in a]
    order = [s.value for s in Severity]
    rows.sort(key=lambda row: order.index(row[1]) if row[1] in order else len(order))
    if not rows:
        return (Paragraph(text=phrase("report_compare.no_warning")),)
    return (
        table(
            (
                text(phrase("label.result")),
                text(phrase("report_compare.severity")),
                text(phrase("report_compare.code")),
                text(phrase("report_compare.message")),
            ),
            zip(*rows, strict=True),
            most=300,
            rest="result.json",
        ),
    )
