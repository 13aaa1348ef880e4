"""Keys of scenes and of their trajectories in block.toml: read and written."""

from __future__ import annotations

import json
from collections.abc import Mapping, Sequence
from typing import TYPE_CHECKING, Any, cast

from raybundle.errors import InputError
from raybundle.io.digits import exact
from raybundle.io.reading.words import quoted

if TYPE_CHECKING:
    from raybundle.io.block.toml_section import Section
    from raybundle.scenes.corrections import Pieces
    from raybundle.scenes.sensor import Key, SceneSensor


def free_symbols(section: Section, sensor: SceneSensor) -> tuple[str, ...] | None:
    """What `estimate` names, in the order of the parameters; None where it is left out."""
    estimate = section.values.get("estimate")
    if estimate is None:
        return None
    if not isinstance(estimate, list):
        section.fail("estimate", "estimate.no_list", known=sensor.symbols)
    order = {s: k for k, s in enumerate(sensor.symbols)}
    members = [m for s in cast("list[Any]", estimate) for m in sensor.groups.get(str(s), (str(s),))]
    return tuple(sorted(dict.fromkeys(members), key=lambda s: order.get(s, -1)))


def sigma_of(section: Section, sensor: SceneSensor, sigmas: Mapping[str, float]) -> dict[str, float] | None:
    """Standard deviations that `sigma` states, before those of a file of fixes; None where there are none."""
    stated = section.section("sigma") if "sigma" in section.values else None
    sigma = None if stated is None else _sigma(stated, sensor)
    found = sensor.priors() | dict(sigmas) if sigma is None else sigma
    return {**sigmas, **found} if sigmas else sigma


def _sigma(stated: Section, sensor: SceneSensor) -> dict[str, float]:
    """Standard deviations by parameter; that of a single one stands before that of its curve."""
    given = _positive(stated)
    wide = {m: v for s, v in given.items() for m in sensor.groups.get(s, (s,))}
    return wide | {s: v for s, v in given.items() if s in wide}


def _positive(section: Section) -> dict[str, float]:
    return {s: section.checked(s, v, above=0) for s, v in section.values.items()}


def key_value(section: Section, key: Key, model: Any, known: dict[str, float], sigmas: dict[str, float]) -> Any:
    """The value of a key of a kind of scene; what a file of fixes states of the corrections goes to the last two."""
    from raybundle.io.block.scene_fixes import read_fixes

    name, default = key.name, key.default
    if name not in section.values:
        return default
    if key.holds == "fixes":
        fixes = read_fixes(section, name, model)
        known |= fixes.values
        sigmas |= fixes.sigma
        return fixes.curve
    if key.holds == "pieces":
        return _pieces(section, name)
    if isinstance(default, dict):
        return _positive(section.section(name))
    if isinstance(default, str):
        return section.choice(name, key.options, default)
    if isinstance(default, bool):
        value = section.values[name]
        if not isinstance(value, bool):
            section.fail(name, "value.no_truth_value", value=quoted(value))
        return value
    value = section.number(name)
    if not key.options:
        return value
    if value not in key.options:
        section.fail(name, "value.not_supported", value=f"{value:g}", known=list(key.options))
    return int(value)


def _pieces(section: Section, key: str) -> Pieces:
    from raybundle.scenes.corrections import Pieces

    own = section.section(key)
    own.allow(("count", "degree", "continuity"))
    try:
        degree = own.whole("degree") if "degree" in own.values else 3
        continuity = own.number("continuity", degree - 1)
        if continuity != int(continuity):
            own.fail("continuity", "value.no_whole_number", value=f"{continuity:g}")
        return Pieces(count=own.whole("count"), degree=degree, continuity=int(continuity))
    except InputError as error:
        if error.file is not None:
            raise
        section.fail(key, error.message or str(error))


def toml_value(value: Any) -> str:
    """A value as TOML has it, numbers exact."""
    match value:
        case bool() | str():
            return json.dumps(value)
        case int():
            return str(value)
        case dict():
            return "{" + ", ".join(f"{k} = {toml_value(v)}" for k, v in cast("dict[str, Any]", value).items()) + "}"
        case list():
            return "[" + ", ".join(toml_value(v) for v in cast("list[Any]", value)) + "]"
        case _:
            return exact(value)


def short_names(names: Sequence[str], groups: Mapping[str, tuple[str, ...]]) -> list[str]:
    """The names, those of a whole curve's axis as one."""
    whole = {axis: members for axis, members in groups.items() if set(members) <= set(names)}
    inside = {m: axis for axis, members in whole.items() for m in members}
    return list(dict.fromkeys(inside.get(n, n) for n in names))


def short_sigma(sigma: Mapping[str, float], groups: Mapping[str, tuple[str, ...]]) -> dict[str, float]:
    """The standard deviations, one that holds for a whole curve's axis once."""
    even = {a: members for a, members in groups.items() if len({sigma.get(m, 0.0) for m in members} - {0.0}) == 1}
    even = {axis: members for axis, members in even.items() if set(members) <= set(sigma)}
    inside = {m: axis for axis, members in even.items() for m in members}
    return {inside.get(s, s): v for s, v in sigma.items()}
