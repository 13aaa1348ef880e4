"""RPC as text: `_RPC.TXT` (KEY: value with or without units), `.RPB` (assignments) and OSSIM's `.geom`.

All three count lines and samples from the centre of the first one (0, 0); ours is 0.5, 0.5.
"""

from __future__ import annotations

import re
from pathlib import Path

import numpy as np

from raybundle.errors import InputError, Message, note
from raybundle.io.digits import exact
from raybundle.io.folders import new_files
from raybundle.io.reading.files import as_utf8, read_bytes
from raybundle.io.reading.words import fortran_of, no_number, quoted, whole_of
from raybundle.io.scenes.base import Scene, SceneFormat, check_denominators, register
from raybundle.numerics.arrays import Array
from raybundle.scenes.rpc import Rpc, rpc_of

FILE_BYTES = 1 << 20
SCALARS = {
    "line_off": ("lineoffset", "lineoff"),
    "samp_off": ("sampoffset", "sampoff"),
    "lat_off": ("latoffset", "latoff"),
    "long_off": ("longoffset", "longoff"),
    "height_off": ("heightoffset", "heightoff"),
    "line_scale": ("linescale",),
    "samp_scale": ("sampscale",),
    "lat_scale": ("latscale",),
    "long_scale": ("longscale",),
    "height_scale": ("heightscale",),
    "err_bias": ("errbias", "biaserror", "ceerror"),
    "err_rand": ("errrand", "randerror"),
}
"""Our key and its spellings, without underscores, in lower case."""
POLYNOMIALS = ("linenumcoef", "linedencoef", "sampnumcoef", "sampdencoef")
UNITS = {
    "line_off": ("pixels", "pixel", "lines", "px"),
    "samp_off": ("pixels", "pixel", "samples", "px"),
    "lat_off": ("degrees", "degree", "deg"),
    "long_off": ("degrees", "degree", "deg"),
    "height_off": ("meters", "metres", "meter", "metre", "m"),
}
_NUMBER = r"[-+]?(?:\d+\.?\d*|\.\d+)(?:[eEdD][-+]?\d+)?"
_PAIR = re.compile(rf"^\s*([A-Za-z]\w*)\s*[:=]\s*({_NUMBER})\s*([A-Za-z]*)\s*;?\s*$")
_LIST = re.compile(r"([A-Za-z]\w*)\s*=\s*\(([^()]*)\)", re.DOTALL)
_LISTS = re.compile(rb"_coeff\s*:\s*(\[|-\s|$)", re.MULTILINE)
"""As YAML has them."""
_INDEXED = re.compile(r"^([a-z]+?)([0-9]{1,3})$")


def read(path: Path) -> Scene:
    """The RPC of a text file; raises InputError that names the line of a bad value or the keys that lack."""
    text = as_utf8(read_bytes(path, FILE_BYTES)).decode("latin-1").replace("\r\n", "\n")
    scalars, polynomials = _collected(path, text)
    coefficients, remarks = _coefficients(path, polynomials, text)
    needed = [k for k in SCALARS if not k.startswith("err_")]
    lacking = [k.upper() for k in needed if k not in scalars]
    if lacking:
        raise InputError("rpc.keys_missing", names=lacking, file=path)

    def pick(*keys: str) -> Array:
        return np.array([scalars[k] for k in keys])

    rpc = rpc_of(
        coefficients=coefficients,
        ground_offset=pick("long_off", "lat_off", "height_off"),
        ground_scale=pick("long_scale", "lat_scale", "height_scale"),
        image_offset=pick("samp_off", "line_off") + 0.5,
        image_scale=pick("samp_scale", "line_scale"),
        err_bias_m=scalars.get("err_bias") or None,
        err_rand_m=scalars.get("err_rand") or None,
    )
    check_denominators(rpc, path)
    return Scene(file=path, format="rpc-text", rpc=rpc, remarks=remarks)


def _collected(path: Path, text: str) -> tuple[dict[str, float], dict[str, dict[int, float]]]:
    """Scalars by our keys, and coefficients by polynomial and position (0 to 19)."""
    spelling = {s: k for k, all_ in SCALARS.items() for s in all_}
    scalars: dict[str, float] = {}
    polynomials: dict[str, dict[int, float]] = {}
    stated: dict[str, tuple[int, float]] = {}
    for match in _LIST.finditer(text):
        if (name := _polynomial(match[1])) is not None:
            words = match[2].replace(",", " ").split()
            line = text.count("\n", 0, match.start()) + 1
            polynomials[name] = {k: _number(path, w, line, match[1]) for k, w in enumerate(words)}
            for k, value in polynomials[name].items():
                _check_once(path, stated, f"{name}({k + 1})", match[1], line, value)
    first = 0 if re.search(r"coeff?_0?0\s*[:=]", text, re.IGNORECASE) else 1
    for number, row in enumerate(text.split("\n"), 1):
        match = _PAIR.match(row)
        if match is None:
            _check_unreadable(path, row, number, spelling)
            continue
        plain = match[1].replace("_", "").lower()
        value = _number(path, match[2], number, match[1])
        indexed = _INDEXED.match(plain)
        if plain in spelling:
            key = spelling[plain]
            _check_unit(path, key, match[3], number)
            _check_once(path, stated, plain, match[1], number, value)
            scalars[key] = value
        elif indexed and (name := _polynomial(indexed[1])) is not None:
            k = (whole_of(indexed[2]) or 0) - first
            _check_once(path, stated, f"{name}({k + 1})", match[1], number, value)
            polynomials.setdefault(name, {})[k] = value
    return scalars, polynomials


def _check_once(
    path: Path, stated: dict[str, tuple[int, float]], plain: str, key: str, line: int, value: float
) -> None:
    """Raise InputError where a key has another value than in a line before."""
    before, old = stated.setdefault(plain, (line, value))
    if old != value:
        raise InputError(
            "rpc.two_values",
            value=exact(value),
            other=exact(old),
            other_line=before,
            file=path,
            line=line,
            column=key,
        )


def _polynomial(name: str) -> str | None:
    plain = name.replace("_", "").lower().replace("coeff", "coef")
    return plain if plain in POLYNOMIALS else None


def _number(path: Path, word: str, line: int, key: str) -> float:
    value = fortran_of(word)
    if value is None:
        raise InputError(no_number(word), file=path, line=line, column=key)
    return value


def _check_unreadable(path: Path, row: str, line: int, spelling: dict[str, str]) -> None:
    key, separator, value = row.replace("=", ":", 1).partition(":")
    plain = key.strip().replace("_", "").lower()
    if separator and plain in spelling:
        raise InputError("value.not_a_number", value=quoted(value.strip()), file=path, line=line, column=key.strip())


def _check_unit(path: Path, key: str, unit: str, line: int) -> None:
    kind = key if key in UNITS else key.replace("_scale", "_off")
    if unit and kind in UNITS and unit.lower() not in UNITS[kind]:
        raise InputError(
            "rpc.unit",
            unit=quoted(unit),
            needed=UNITS[kind][0],
            file=path,
            line=line,
            column=key.upper(),
        )


def _coefficients(path: Path, polynomials: dict[str, dict[int, float]], text: str) -> tuple[Array, tuple[Message, ...]]:
    result = np.zeros((4, 20))
    for k, name in enumerate(POLYNOMIALS):
        found = polynomials.get(name, {})
        if sorted(found) != list(range(20)):
            raise InputError(
                "rpc.coefficient_count",
                name=name.upper(),
                n=len(found),
                file=path,
            )
        result[k] = [found[i] for i in range(20)]
    specification = re.search(r'(?:specId\s*=\s*"?|polynomial_format\s*:\s*)(\w+)', text, re.IGNORECASE)
    if specification is None or specification[1] in {"RPC00B", "B"}:
        return result, ()
    if specification[1] in {"RPC00A", "A"}:
        from raybundle.io.scenes.maxar import RPC00A_IN_B

        ordered = np.zeros((4, 20))
        ordered[:, list(RPC00A_IN_B)] = result
        return ordered, (note("rpc.terms_reordered"),)
    return result, (note("rpc.specification_assumed", specification=specification[1]),)


def write_rpb(rpc: Rpc, path: Path) -> None:
    """Write `.RPB`, which GDAL and most programs read beside an image of the same name; numbers lose nothing."""
    x, y = rpc.image_offset - 0.5
    lon, lat, height = rpc.ground_offset
    lon_scale, lat_scale, height_scale = rpc.ground_scale
    rows = [
        ("errBias", rpc.err_bias_m or 0.0), ("errRand", rpc.err_rand_m or 0.0),
        ("lineOffset", y), ("sampOffset", x), ("latOffset", lat), ("longOffset", lon), ("heightOffset", height),
        ("lineScale", rpc.image_scale[1]), ("sampScale", rpc.image_scale[0]),
        ("latScale", lat_scale), ("longScale", lon_scale), ("heightScale", height_scale),
    ]  # fmt: skip
    lines = ['satId = "unknown";', 'bandId = "P";', 'SpecId = "RPC00B";', "BEGIN_GROUP = IMAGE"]
    lines += [f"\t{key} = {exact(value)};" for key, value in rows]
    for name, polynomial in zip(("lineNum", "lineDen", "sampNum", "sampDen"), rpc.coefficients, strict=True):
        numbers = ",\n".join(f"\t\t\t{exact(c)}" for c in polynomial)
        lines.append(f"\t{name}Coef = (\n{numbers});")
    _write(path, [*lines, "END_GROUP = IMAGE", "END;"])


def _write(path: Path, lines: list[str]) -> None:
    with new_files(path) as (file,):
        file.write_text("\n".join(lines) + "\n", encoding="ascii")


def write_rpc_text(rpc: Rpc, path: Path) -> None:
    """Write `_RPC.TXT`, which GDAL and most programs read beside an image; numbers lose nothing."""
    x, y = rpc.image_offset - 0.5
    rows = [
        ("LINE_OFF", y, "pixels"),
        ("SAMP_OFF", x, "pixels"),
        ("LAT_OFF", rpc.ground_offset[1], "degrees"),
        ("LONG_OFF", rpc.ground_offset[0], "degrees"),
        ("HEIGHT_OFF", rpc.ground_offset[2], "meters"),
        ("LINE_SCALE", rpc.image_scale[1], "pixels"),
        ("SAMP_SCALE", rpc.image_scale[0], "pixels"),
        ("LAT_SCALE", rpc.ground_scale[1], "degrees"),
        ("LONG_SCALE", rpc.ground_scale[0], "degrees"),
        ("HEIGHT_SCALE", rpc.ground_scale[2], "meters"),
    ]
    lines = [f"{key}: {exact(value)} {unit}" for key, value, unit in rows]
    for name, polynomial in zip(("LINE_NUM", "LINE_DEN", "SAMP_NUM", "SAMP_DEN"), rpc.coefficients, strict=True):
        lines += [f"{name}_COEFF_{k}: {exact(c)}" for k, c in enumerate(polynomial, 1)]
    errors = (("ERR_BIAS", rpc.err_bias_m), ("ERR_RAND", rpc.err_rand_m))
    _write(path, [f"{key}: {exact(value)} meters" for key, value in errors if value] + lines)


def write_geom(rpc: Rpc, path: Path) -> None:
    """Write `.geom`, the keyword list of an RPC model that OSSIM and OTB read beside an image; numbers lose nothing."""
    x, y = rpc.image_offset - 0.5
    lon, lat, height = rpc.ground_offset
    lon_scale, lat_scale, height_scale = rpc.ground_scale
    rows = [
        ("type", "ossimRpcModel"), ("polynomial_format", "B"),
        ("bias_error", rpc.err_bias_m or 0.0), ("rand_error", rpc.err_rand_m or 0.0),
        ("line_off", y), ("samp_off", x), ("lat_off", lat), ("long_off", lon), ("height_off", height),
        ("line_scale", rpc.image_scale[1]), ("samp_scale", rpc.image_scale[0]),
        ("lat_scale", lat_scale), ("long_scale", lon_scale), ("height_scale", height_scale),
    ]  # fmt: skip
    lines = [f"{key}:  {value if isinstance(value, str) else exact(value)}" for key, value in rows]
    for name, polynomial in zip(("line_num", "line_den", "samp_num", "samp_den"), rpc.coefficients, strict=True):
        lines += [f"{name}_coeff_{k:02d}:  {exact(c)}" for k, c in enumerate(polynomial)]
    _write(path, lines)


def _recognises(path: Path, head: bytes) -> bool:
    del path
    plain = head.replace(b"_", b"").lower()
    if head.lstrip().startswith((b"<", b"{")) or b"\0" in head or _LISTS.search(head):
        return False
    return any(word in plain for word in (b"lineoff", b"linenumcoef", b"linedencoef"))


register(SceneFormat(name="rpc-text", title="RPC as text (_RPC.TXT, .RPB, .geom)", recognises=_recognises, read=read))
