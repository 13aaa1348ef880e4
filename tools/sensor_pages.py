"""One reference page for each sensor model: what it is, its formula as MathML, its parameters, the text behind them.

The formula is read from the condition itself: each line of it is evaluated with symbols, so that it cannot differ from
what is computed.
"""

from __future__ import annotations

import ast
import inspect
import re
import textwrap
from collections.abc import Callable, Sequence
from typing import Any

import sympy as sp
from sympy.printing.mathml import mathml

from raybundle.platforms import Carried, InstrumentModel, Platform, instrument_models, platforms, sensor_models
from raybundle.scenes.empirical import empirical_models
from raybundle.scenes.kinds import SceneSensor, scene_kinds
from raybundle.sensors.model import Parameter, SensorModel

MANY, LISTED = 60, 10
"""Parameters of a model beyond which only the first ones are listed."""
POINT = ("x", "y", "X", "Y", "Z")
HEAD = "| parameter | key in block.toml | unit | meaning | default |\n|---|---|---|---|---|"
EMPIRICAL = {
    "affine": ("x = a1 X + a2 Y + a3 Z + a4", "y = b1 X + b2 Y + b3 Z + b4"),
    "affine2": (
        "x = a1 X + a2 Y + a3 Z + a4 + a5 XY + a6 XZ + a7 YZ + a8 X² + a9 Y²",
        "y = b1 X + b2 Y + b3 Z + b4 + b5 XY + b6 XZ + b7 YZ + b8 X² + b9 Y²",
    ),
    "parallel-perspective": (
        "x = (L1 X + L2 Y + L3 Z + L4) / (1 + L5 X + L6 Y + L7 Z)", "y = L8 X + L9 Y + L10 Z + L11",
    ),
    "dlt": (
        "x = (L1 X + L2 Y + L3 Z + L4) / (1 + L9 X + L10 Y + L11 Z)",
        "y = (L5 X + L6 Y + L7 Z + L8) / (1 + L9 X + L10 Y + L11 Z)",
    ),
    "dlt-brown": (
        "x + dx = (L1 X + L2 Y + L3 Z + L4) / (1 + L9 X + L10 Y + L11 Z)",
        "y + dy = (L5 X + L6 Y + L7 Z + L8) / (1 + L9 X + L10 Y + L11 Z)",
        "dx = u (K1 r² + K2 r⁴ + K3 r⁶) + P1 (r² + 2 u²) + 2 P2 u v",
        "dy = v (K1 r² + K2 r⁴ + K3 r⁶) + P2 (r² + 2 v²) + 2 P1 u v",
        "u, v: x, y from the principal point, (L1 L9 + L2 L10 + L3 L11, L5 L9 + L6 L10 + L7 L11) / (L9² + L10² + L11²)",
    ),
    "sdlt": (
        "x = (L1 X + L2 Y + L3 Z + L4) / (1 + L9 X + L10 Y + L11 Z)",
        "y = (L5 X + L6 Y + L7 Z + L8) / (1 + L9 X + L10 Y + L11 Z) / (1 - L12 x)",
    ),
    "plane-affine": ("x = a1 X + a2 Y + a3", "y = b1 X + b2 Y + b3"),
    "plane-projective": (
        "x = (h1 X + h2 Y + h3) / (1 + h7 X + h8 Y)", "y = (h4 X + h5 Y + h6) / (1 + h7 X + h8 Y)",
    ),
}  # fmt: skip


def pages() -> dict[str, str]:
    """Name of the page -> its text, for every model."""
    found = {n: model_page(n, m) for n, m in sorted(sensor_models.items()) if not isinstance(m, Carried)}
    on_a_way = {n: m for n, m in sensor_models.items() if isinstance(m, Carried) and m.sensor.line}
    found |= {name: carried_line_page(name, model) for name, model in sorted(on_a_way.items())}
    found |= {name: platform_page(name, platform) for name, platform in sorted(platforms.items())}
    found |= {name: instrument_page(name, model) for name, model in sorted(instrument_models.items())}
    found |= {name: scene_page(kind) for name, kind in scene_kinds.items()}
    found["empirical"] = empirical_page()
    return found


def overview() -> str:
    """What the pages are of."""
    lines = [
        "# Sensor models\n",
        (
            "Each model of a camera is one condition `g(x, y, X, Y, Z, parameters) = 0` between the image point (mm, "
            "image frame) and the object point in the sensor's own frame (x right, y up, view along -Z). Jacobians and "
            "kernels are derived from the text that its page shows.\n"
        ),
        "| model | what it is |\n|---|---|",
    ]
    for name, text in pages().items():
        lines.append(f"| [{name}](sensors/{name}.md) | {text.split(chr(10) + chr(10))[1].split(chr(10))[0]} |")
    return "\n".join(lines) + "\n"


def parameter_table(parameters: Sequence[Parameter]) -> str:
    """Symbols, keys, units, meanings and defaults."""
    shown = parameters[:LISTED] if len(parameters) > MANY else parameters
    rows = [HEAD, *(f"| {p.symbol} | `{p.key}` | {p.unit} | {p.words} | {p.default:g} |" for p in shown)]
    if len(shown) < len(parameters):
        last = parameters[-1]
        more = len(parameters) - len(shown)
        rows.append(f"| ... {last.symbol} | | {last.unit} | {more} more, the last: {last.words} | {last.default:g} |")
    return "\n".join(rows)


def model_page(name: str, model: SensorModel) -> str:
    """Page of a model that states a condition."""
    source = inspect.cleandoc(inspect.getsource(type(model).condition))
    formula = formulas(type(model).condition, model.symbols) if len(model.parameters) <= MANY else ""
    parts = [f"# {name}", inspect.getdoc(type(model)) or ""]
    if formula:
        parts += ["## Formula", formula]
    parts += ["## Parameters", parameter_table(model.parameters), "## As it is written"]
    return "\n\n".join([*parts, f"```text\n{source}\n```"]) + "\n"


def carried_line_page(name: str, model: Carried) -> str:
    """Page of a line sensor, which is a model on a platform that moves."""
    sensor, platform = model.sensor, model.platform.name
    condition = type(sensor).condition
    return "\n\n".join([
        f"# {name}", inspect.getdoc(type(sensor)) or "",
        f"The line stands on the platform [{platform}]({platform}.md), which describes its motion.",
        "## Formula",
        f"X, Y, Z: the point in the axes that the line had when it was measured, U, V, W of {platform}.",
        formulas(condition, sensor.symbols),
        "## Parameters", parameter_table(model.parameters),
        "## As it is written", f"```text\n{inspect.cleandoc(inspect.getsource(condition))}\n```",
    ]) + "\n"  # fmt: skip


def platform_page(name: str, platform: Platform) -> str:
    """Page of a platform: where a point lies for the sensor that it carries, and which models that makes."""
    point = type(platform).point
    carries = (
        f"A platform carries a sensor: the model `SENSOR_{name}` has the parameters of the sensor and those below. "
        "Condition and Jacobian follow from both by the chain rule."
    )
    made = [f"`{n}`" for n, m in sorted(sensor_models.items()) if isinstance(m, Carried) and m.platform is platform]
    return "\n\n".join([
        f"# {name}", inspect.getdoc(type(platform)) or "",
        carries,
        "Models: " + ", ".join(made) + ".",
        "## Formula", formulas(point, platform.symbols, left="U, V, W"), "## Parameters",
        parameter_table(platform.parameters),
        "## As it is written", f"```text\n{inspect.cleandoc(inspect.getsource(point))}\n```",
    ]) + "\n"  # fmt: skip


def instrument_page(name: str, model: InstrumentModel) -> str:
    """Page of what a platform carries beside sensors."""
    return "\n\n".join([
        f"# {name}", inspect.getdoc(type(model)) or "", "## Formula", f"```text\n{model.formula}\n```", "## Parameters",
        parameter_table(model.parameters),
    ]) + "\n"  # fmt: skip


def scene_page(kind: type[SceneSensor]) -> str:
    """A kind of satellite scenes."""
    keys = ["| key in block.toml | values |", "|---|---|"]
    of_type = {bool: "true, false", dict: "table of standard deviations by axis"}
    for k in kind.keys:
        values = k.holds if k.holds != "value" else of_type.get(type(k.default), "number")
        keys.append(f"| {k.name} | {', '.join(map(str, k.options)) or values} |")
    rows = ["| parameter | unit | meaning |", "|---|---|---|"]
    rows += [f"| {p.symbol} | {p.unit} | {p.words} |" for p in kind.possible]
    return "\n\n".join([
        f"# {kind.name}", inspect.getdoc(kind) or "", "## Formula", f"```text\n{kind.formula}\n```",
        "## Parameters", "\n".join(rows), "## Keys", "\n".join(keys),
    ]) + "\n"  # fmt: skip


def empirical_page() -> str:
    """All empirical models; their formulas are held against the program."""
    parts = [
        "# empirical",
        "Models without a camera: fitted to points by least squares (`raybundle.scenes.empirical.fit_empirical`).",
        "Object and image coordinates are first centred and scaled to -1 .. 1; the parameters belong to those.",
    ]
    for name, model in empirical_models.items():
        if name not in EMPIRICAL:
            raise ValueError(f"the empirical model {name} has no formula in tools/sensor_pages.py")
        lines = "\n".join(EMPIRICAL[name])
        words = set(re.findall(r"[abLhKP]\d+", lines))
        if words != set(model.symbols):
            raise ValueError(f"the formula of {name} has {sorted(words ^ set(model.symbols))} of its own")
        parts += [
            f"## {name}",
            f"{len(model.symbols)} parameters, {model.least_points} points at least.",
            f"```text\n{lines}\n```",
        ]
    return "\n\n".join(parts) + "\n"


def formulas(condition: Callable[..., Any], symbols: Sequence[str], left: str = "") -> str:
    """The lines of a condition as formulas, its result as 0 = ... or `left`; '' where a line is more than a formula."""
    tree = ast.parse(textwrap.dedent(inspect.getsource(condition))).body[0]
    assert isinstance(tree, ast.FunctionDef)
    names: dict[str, Any] = {n: sp.Symbol(n, real=True) for n in (*POINT, *symbols)}
    around = getattr(condition, "__func__", condition).__globals__
    lines: list[str] = []
    for statement in tree.body:
        if isinstance(statement, ast.Expr | ast.Delete):
            continue  # the docstring
        if left and isinstance(statement, ast.Return) and statement.value is not None:
            lines.append(_words(f"{left} = {ast.unparse(statement.value)}"))
            continue
        if isinstance(statement, ast.Return) and statement.value is not None and _other_model(statement.value):
            lines.append(_words(f"0 = condition of {_other_model(statement.value)} at {_arguments(statement.value)}"))
            continue
        if isinstance(statement, ast.Return) and isinstance(statement.value, ast.Tuple):
            lines += [_equation("0", _value(part, around, names)) for part in statement.value.elts]
            continue
        if not isinstance(statement, ast.Assign) or len(statement.targets) != 1:
            return ""
        target = statement.targets[0]
        if not isinstance(target, ast.Name | ast.Tuple):
            return ""
        targets = [target] if isinstance(target, ast.Name) else target.elts
        if not all(isinstance(t, ast.Name) for t in targets):
            return ""
        own = [t.id for t in targets if isinstance(t, ast.Name)]
        model = _other_model(statement.value)
        if model:
            lines.append(_words(f"{', '.join(own)}: as of {model}"))
        elif _of_vectors(statement.value, own):
            told = ast.unparse(statement.value)
            lines.append(_words(f"{', '.join(own)} = {told.strip('()') if told.startswith('(') else told}"))
        else:
            value = _value(statement.value, around, names)
            values = [value] if isinstance(target, ast.Name) else list(value)
            if len(values) != len(own) or not all(isinstance(v, sp.Expr | int | float) for v in values):
                return ""
            lines += [_equation(n, v) for n, v in zip(own, values, strict=True)]
        names |= {n: sp.Symbol(n, real=True) for n in own}
    return "\n".join(f"<p>{line}</p>" for line in lines)


def _value(node: ast.expr, around: dict[str, Any], names: dict[str, Any]) -> Any:
    return eval(compile(ast.Expression(node), "condition", "eval"), around, names)  # noqa: S307  (our own models)


def _of_vectors(node: ast.expr, names: Sequence[str]) -> bool:
    """Whether a line holds whole vectors: three from a function of frames, or three under one name."""
    if isinstance(node, ast.Tuple):
        return len(names) == 1
    return isinstance(node, ast.Call) and len(names) == 3


def _words(text: str) -> str:
    """A line that is told, with its symbols as they are written."""
    return f"<code>{text.replace('**', '^')}</code>"


def _arguments(node: ast.expr) -> str:
    """The image and object point at which another condition is taken."""
    assert isinstance(node, ast.Call)
    return ", ".join(ast.unparse(a) for a in node.args[:5])


def _other_model(node: ast.expr) -> str:
    """The name of the model whose condition is called."""
    if isinstance(node, ast.Call) and isinstance(node.func, ast.Attribute) and node.func.attr == "condition":
        return ast.unparse(node.func.value).lower()
    return ""


def _equation(left: str, right: Any) -> str:
    both = [mathml(sp.Symbol(left) if left != "0" else sp.Integer(0), printer="presentation")]
    both.append(mathml(sp.sympify(right), printer="presentation"))
    return f"<math>{both[0]}<mo>=</mo>{both[1]}</math>"
