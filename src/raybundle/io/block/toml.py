"""block.toml: the head of a block folder, cameras included."""

from __future__ import annotations

import json
import re
from collections.abc import Iterator, Mapping
from dataclasses import dataclass, replace
from pathlib import Path
from typing import TYPE_CHECKING, Any, Literal, NoReturn, cast

import numpy as np

from raybundle.block import Block, Camera, Instrument
from raybundle.block.block import LengthUnit, Relation, Residuals
from raybundle.block.stored import without_relations_of_calibration
from raybundle.errors import UnknownSensorModel
from raybundle.io.block.scenes import frame_lines, read_frame, read_scene_camera, scene_lines
from raybundle.io.block.toml_section import Section, read_toml
from raybundle.io.digits import exact
from raybundle.io.reading.words import quoted
from raybundle.numerics.places import Place
from raybundle.observations.parameter import Calibrated
from raybundle.platforms import InstrumentModel, instrument_models
from raybundle.sensors import SensorModel, sensor_models

if TYPE_CHECKING:
    from raybundle.io.block.scene_trajectories import GivenTrajectory

SCALES = ("fixed", "free", "nominal")
RELATION = {"name", "terms", "observed", "sigma", "logarithm", "origin"}
"""What a table of `relations` may hold."""
ORIGINS: tuple[Literal["known before", "calibration"], ...] = ("known before", "calibration")
_BARE = re.compile(r"[A-Za-z0-9_-]+")


@dataclass(frozen=True, slots=True, kw_only=True)
class Head:
    """What block.toml states."""

    name: str
    about: str
    source: str
    licence: str
    length_unit: LengthUnit
    free_scale: bool
    nominal_scale: bool
    sigma0_apriori: float
    noise: Literal["", "white", "fields"]
    datum_over: Literal["", "all", "good"]
    residuals: Residuals
    place: Place | None
    cameras: tuple[Camera, ...]
    instruments: tuple[Instrument, ...]


def read_head(path: Path) -> Head:
    """The contents of a block.toml; raises InputError with the line of the key at fault."""
    top = read_toml(path)
    top.allow(
        (
            "name",
            "about",
            "source",
            "licence",
            "length_unit",
            "scale",
            "sigma0_apriori",
            "residuals",
            "noise",
            "datum_over",
            "frame",
            "cameras",
            "antennas",
            "imus",
            "trajectories",
            "mounts",
        ),
    )
    place = read_frame(top.section("frame"))
    cameras = top.section("cameras")
    if not cameras.values:
        top.fail("cameras", "block.no_camera")
    trajectories = _trajectories(top, place)
    shared = tuple(t.instrument for t in trajectories.values())
    instruments = (*_instruments(top, shared), *shared)
    return Head(
        name=top.text("name", path.parent.name or "block"),
        about=top.text("about", ""),
        source=top.text("source", ""),
        licence=top.text("licence", ""),
        length_unit=cast("LengthUnit", top.choice("length_unit", ("m", "mm"), "m")),
        free_scale=(scale := top.choice("scale", SCALES, "fixed")) == "free",
        nominal_scale=scale == "nominal",
        sigma0_apriori=top.number("sigma0_apriori", 1.0, above=0),
        residuals=cast("Residuals", top.choice("residuals", ("measured", "corrected"), "measured")),
        noise=cast("Any", top.choice("noise", ("", "white", "fields"), "")),
        datum_over=cast("Any", top.choice("datum_over", ("", "all", "good"), "")),
        place=place,
        cameras=tuple(_linked(_camera(cameras, id_, place, trajectories), instruments) for id_ in cameras.values),
        instruments=instruments,
    )


def _trajectories(top: Section, place: Place | None) -> Mapping[str, GivenTrajectory]:
    """Trajectories that scenes share; refuses names of them where there are none."""
    cameras = top.section("cameras")
    named = any({"trajectory", "mount"} & set(cameras.section(c).values) for c in cameras.values)
    if not named and not top.section("trajectories").values:
        return {}
    from raybundle.io.block.scene_trajectories import read_trajectories

    return read_trajectories(top, place)


def _linked(camera: Camera, instruments: tuple[Instrument, ...]) -> Camera:
    """A camera with the values of the instruments that have its parameters."""
    of = {i.id: i.values for i in instruments}
    return replace(camera, values={**camera.values, **{s: of[n][s] for s, n in camera.sensor.links.items()}})


def read_cameras(path: Path) -> tuple[Camera, ...]:
    """The `[cameras.*]` tables of a TOML file that holds nothing else."""
    top = read_toml(path)
    top.allow(("cameras",))
    cameras = top.section("cameras")
    return tuple(_camera(cameras, id_) for id_ in cameras.values)


def _camera(
    cameras: Section, id_: str, place: Place | None = None, trajectories: Mapping[str, GivenTrajectory] | None = None
) -> Camera:
    section = cameras.section(id_)
    if not id_ or id_ != id_.strip() or not id_.isprintable():
        cameras.fail(id_, "cell.no_id", value=quoted(id_))
    if "model" not in section.values:
        section.fail("model", "value.key_missing", name="model")
    model_name = section.text("model", "")
    model = sensor_models.get(model_name)
    if model is None:
        from raybundle.scenes.kinds import scene_kinds

        if model_name in scene_kinds:
            return read_scene_camera(section, id_, place, trajectories)
        line = section.lines.get((*section.at, "model"), 0)
        raise UnknownSensorModel(model_name, known=(*sensor_models, *scene_kinds), file=section.file, line=line)
    keys = [p.key for p in model.parameters]
    section.allow(
        (
            "model",
            "width_px",
            "height_px",
            "pixel_mm",
            *keys,
            "estimate",
            "sigma",
            "calibration",
            "relations",
            "interior",
            "per_image",
        )
    )
    interior = section.choice("interior", ("shared", "per_image"), "shared")
    camera = Camera(
        id=id_,
        model=model_name,
        width_px=section.whole("width_px"),
        height_px=section.whole("height_px"),
        pixel_mm=_pixel(section),
        values=_values(section, model),
        estimate=_estimate(section, model),
        sigma=_sigma(section, model),
        interior=cast("Literal['shared', 'per_image']", interior),
        per_image=_per_image(section, model, interior),
        calibrated=_calibration(section, model),
        relations=_relations(section, model),
    )
    return camera if camera.calibrated is not None else without_relations_of_calibration(camera)


def _instruments(top: Section, shared: tuple[Instrument, ...]) -> Iterator[Instrument]:
    """The tables [antennas.*], [imus.*] and [mounts.*]; `shared` the trajectories, which have names of their own."""
    taken = dict.fromkeys(top.section("cameras").values, "camera") | {i.id: i.sensor.noun for i in shared}
    for model in instrument_models.values():
        what, section = model.noun, top.section(model.section)
        for id_ in section.values:
            own = section.section(id_)
            if id_ in taken:
                section.fail(id_, "instrument.name_taken", name=id_, kind=what.lower(), other=taken[id_].lower())
            taken[id_] = what
            own.allow((*model.symbols, "estimate", "sigma"))
            estimate = _estimate(own, model)
            if estimate == "auto":
                own.fail("estimate", "estimate.no_list", known=model.symbols)
            yield Instrument(
                id=id_, model=model.name, values={s: own.number(s, 0.0) for s in model.symbols}, estimate=estimate,
                sigma=_sigma(own, model),
            )  # fmt: skip


def _pixel(section: Section) -> tuple[float, float]:
    value = section.values.get("pixel_mm")
    if not isinstance(value, list) or len(cast("list[Any]", value)) != 2:
        section.fail("pixel_mm", "camera.pixel_size_missing")
    width, height = (section.checked("pixel_mm", v, above=0) for v in cast("list[Any]", value))
    return width, height


def _values(section: Section, model: SensorModel) -> dict[str, float]:
    values: dict[str, float] = {}
    for p in model.parameters:
        if p.kind == "scale":
            values[p.symbol] = section.number(p.key, above=0)
        else:
            values[p.symbol] = section.number(p.key, p.default if p.unit.startswith("length") else 0.0)
    return values


def _estimate(section: Section, model: SensorModel | InstrumentModel) -> tuple[str, ...] | Literal["auto"]:
    value = section.values.get("estimate", [])
    if value == "auto":
        return "auto"
    if not isinstance(value, list):
        section.fail("estimate", "estimate.neither_auto_nor_list", value=quoted(value), known=model.symbols)
    symbols = cast("list[Any]", value)
    for position, symbol in enumerate(symbols):
        if symbol not in model.symbols:
            _unknown_parameter(section, "estimate", symbol, model)
        if symbol in symbols[:position]:
            section.fail("estimate", "parameter.twice", name=symbol)
    return tuple(symbols)


def _per_image(section: Section, model: SensorModel, interior: str) -> tuple[str, ...]:
    """Symbols that each image has for itself."""
    value = section.values.get("per_image", [])
    if not isinstance(value, list) or any(s not in model.symbols for s in cast("list[Any]", value)):
        section.fail("per_image", "parameter.no_list", value=quoted(value), known=model.symbols)
    for symbol in cast("list[str]", value):
        if cast("list[str]", value).count(symbol) > 1:
            section.fail("per_image", "parameter.twice", name=symbol)
    if value and interior == "per_image":
        section.fail("per_image", "interior.per_image_twice")
    return tuple(cast("list[str]", value))


def _sigma(section: Section, model: SensorModel | InstrumentModel) -> dict[str, float]:
    sigma = section.section("sigma")
    values: dict[str, float] = {}
    for symbol in sigma.values:
        if symbol not in model.symbols:
            _unknown_parameter(section, "sigma", symbol, model)
        value = sigma.checked(symbol, sigma.values[symbol])
        if value <= 0:
            section.fail("sigma", "parameter.sigma_not_positive", name=symbol, sigma=value)
        values[symbol] = value
    estimate = section.values.get("estimate", [])
    idle = [s for s in values if estimate != "auto" and s not in estimate]
    if idle:
        section.fail("sigma", "parameter.sigma_of_fixed", name=idle[0])
    return values


def _unknown_parameter(section: Section, key: str, symbol: object, model: SensorModel | InstrumentModel) -> NoReturn:
    section.fail(key, "parameter.unknown", name=quoted(symbol), model=model.name, known=model.symbols)


def _calibration(section: Section, model: SensorModel) -> Calibrated | None:
    """Parameters that are observed with their covariance."""
    value = section.values.get("calibration")
    if value is None:
        return None
    if not isinstance(value, list) or not value:
        section.fail("calibration", "calibration.no_list", value=quoted(value))
    symbols, values, sigma, rows = list[str](), list[float](), list[float](), list[tuple[float, ...]]()
    for number, given in enumerate(cast("list[Any]", value), 1):
        table = cast("dict[str, Any]", given) if isinstance(given, dict) else {}
        before = table.get("correlations", [])
        if set(table) - {"correlations"} != {"parameter", "value", "sigma"} or not isinstance(before, list):
            section.fail("calibration", "calibration.incomplete_entry", number=number)
        if table["parameter"] not in model.symbols:
            _unknown_parameter(section, "calibration", table["parameter"], model)
        if table["parameter"] in symbols:
            section.fail("calibration", "parameter.twice", name=table["parameter"])
        if len(cast("list[Any]", before)) != len(symbols):
            n = len(cast("list[Any]", before))
            section.fail("calibration", "calibration.correlation_count", number=number, n=n, needed=len(symbols))
        symbols.append(table["parameter"])
        values.append(section.checked("calibration", table["value"]))
        sigma.append(section.checked("calibration", table["sigma"], above=0))
        rows.append((*(section.checked("calibration", r) for r in cast("list[Any]", before)), 1.0))
    known = Calibrated(symbols=tuple(symbols), values=tuple(values), sigma=tuple(sigma), correlations=tuple(rows))
    try:
        np.linalg.cholesky(known.correlation)
    except np.linalg.LinAlgError:
        section.fail("calibration", "calibration.not_positive_definite")
    return known


def _relations(section: Section, model: SensorModel) -> tuple[Relation, ...]:
    """What is observed of several parameters together."""
    value = section.values.get("relations", [])
    if not isinstance(value, list):
        section.fail("relations", "relation.no_list", value=quoted(value))
    found: list[Relation] = []
    for number, given in enumerate(cast("list[Any]", value), 1):
        table = cast("dict[str, Any]", given) if isinstance(given, dict) else {}
        terms = cast("dict[str, Any]", table.get("terms")) if isinstance(table.get("terms"), dict) else {}
        if not terms or set(table) - RELATION or "sigma" not in table:
            section.fail("relations", "relation.incomplete_entry", number=number)
        unknown = [s for s in terms if s not in model.symbols]
        if unknown:
            _unknown_parameter(section, "relations", unknown[0], model)
        found.append(
            Relation(
                name=str(table.get("name", f"relation {number}")),
                terms={s: section.checked("relations", f) for s, f in terms.items()},
                observed=section.checked("relations", table.get("observed", 0.0)),
                sigma=section.checked("relations", table["sigma"], above=0),
                logarithm=_flag(section, table.get("logarithm", False)),
                origin=_origin(section, table),
            )
        )
    return tuple(found)


def _origin(section: Section, table: dict[str, Any]) -> Literal["", "known before", "calibration"]:
    """Where a relation comes from; files written before this was a key say it at the beginning of its name."""
    given = table.get("origin")
    for origin in ORIGINS:
        if given == origin or (given is None and str(table.get("name", "")).startswith(f"{origin}: ")):
            return origin
    if given is not None:
        section.fail("relations", "value.not_supported", value=quoted(given), known=ORIGINS)
    return ""


def _flag(section: Section, value: object) -> bool:
    if not isinstance(value, bool):
        section.fail("relations", "value.no_truth_value", value=quoted(value))
    return value


def head_text(block: Block) -> str:
    """The block.toml of a block; reads back equal."""
    lines = [f"{key} = {_quoted(getattr(block, key))}" for key in ("name", "about", "source", "licence", "length_unit")]
    if block.free_scale or block.nominal_scale:
        lines.append(f'scale = "{"free" if block.free_scale else "nominal"}"')
    lines.append(f"sigma0_apriori = {exact(block.sigma0_apriori)}")
    lines.append(f"residuals = {_quoted(block.residuals)}")
    if block.noise:
        lines.append(f"noise = {_quoted(block.noise)}")
    if block.datum_over:
        lines.append(f"datum_over = {_quoted(block.datum_over)}")
    lines += frame_lines(block.place)
    for number, camera in enumerate(block.cameras, 1):
        key = camera.id if _BARE.fullmatch(camera.id) else _quoted(camera.id)
        own = _camera_lines(camera) if camera.scene is None else scene_lines(camera, number)
        lines += ["", f"[cameras.{key}]", *own]
    for instrument in block.instruments:
        key = instrument.id if _BARE.fullmatch(instrument.id) else _quoted(instrument.id)
        lines += ["", f"[{instrument.sensor.section}.{key}]", *_instrument_lines(instrument)]
    return "\n".join(lines) + "\n"


def _instrument_lines(instrument: Instrument) -> list[str]:
    if instrument.scene is not None:
        from raybundle.io.block.scene_trajectories import trajectory_lines

        return trajectory_lines(instrument)
    lines = [f"{s} = {exact(instrument.values.get(s, 0.0))}" for s in instrument.sensor.symbols]
    lines.append(f"estimate = [{', '.join(_quoted(s) for s in instrument.estimate)}]")
    if instrument.sigma:
        lines.append("sigma = {" + ", ".join(f"{s} = {exact(v)}" for s, v in instrument.sigma.items()) + "}")
    return lines


def _camera_lines(camera: Camera) -> list[str]:
    model = sensor_models[camera.model]
    width, height = (float(p) for p in camera.pixel_mm)
    lines = [
        f"model = {_quoted(camera.model)}",
        f"width_px = {camera.width_px}",
        f"height_px = {camera.height_px}",
        f"pixel_mm = [{exact(width)}, {exact(height)}]",
    ]
    lines += [f"{p.key} = {exact(camera.values.get(p.symbol, 0.0))}" for p in model.parameters]
    if camera.estimate == "auto":
        lines.append('estimate = "auto"')
    else:
        lines.append(f"estimate = [{', '.join(_quoted(s) for s in camera.estimate)}]")
    if camera.sigma:
        lines.append("sigma = {" + ", ".join(f"{s} = {exact(v)}" for s, v in camera.sigma.items()) + "}")
    if camera.calibrated is not None:
        lines += ["calibration = [", *(f"    {text}," for text in _calibration_texts(camera.calibrated)), "]"]
    if camera.relations:
        lines += ["relations = [", *(f"    {_relation_text(r)}," for r in camera.relations), "]"]
    if camera.interior != "shared":
        lines.append(f"interior = {_quoted(camera.interior)}")
    if camera.per_image:
        lines.append(f"per_image = [{', '.join(_quoted(s) for s in camera.per_image)}]")
    return lines


def _calibration_texts(known: Calibrated) -> list[str]:
    rows = zip(known.symbols, known.values, known.sigma, known.correlations, strict=True)
    return [
        f"{{parameter = {_quoted(s)}, value = {exact(v)}, sigma = {exact(std)}, "
        f"correlations = [{', '.join(map(repr, row[:-1]))}]}}"
        for s, v, std, row in rows
    ]


def _relation_text(relation: Relation) -> str:
    terms = ", ".join(f"{s} = {exact(f)}" for s, f in relation.terms.items())
    tail = f"observed = {exact(relation.observed)}, sigma = {exact(relation.sigma)}"
    tail += ", logarithm = true" if relation.logarithm else ""
    tail += f", origin = {_quoted(relation.origin)}" if relation.origin else ""
    return f"{{name = {_quoted(relation.name)}, terms = {{{terms}}}, {tail}}}"


def _quoted(text: str) -> str:
    return json.dumps(text, ensure_ascii=False).replace("\x7f", "\\u007f")
