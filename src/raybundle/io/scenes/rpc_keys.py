"""RPC under the keys of GDAL's metadata domain RPC: XML of GDAL (.vrt, .aux.xml), JSON (gdalinfo, rasterio), YAML.

    VRT, .aux.xml    <Metadata domain="RPC"><MDI key="LINE_OFF">...
    JSON             "metadata": {"RPC": {"LINE_OFF": "..."}} as `gdalinfo -json` prints it; or the same keys in small
                     letters, as `rasterio.rpc.RPC.to_dict` has them, alone or below "rpc" or "rpcs"
    YAML             orthority's parameters of an RPC: NAME: {rpc: {line_off: ...}}

All count from the centre of the first pixel (0, 0); ours is 0.5, 0.5.
"""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping
from pathlib import Path
from typing import Any

import numpy as np

from raybundle.errors import InputError
from raybundle.io.reading.trees import Json, read_json
from raybundle.io.reading.words import finite, no_number, number_of, whole_of
from raybundle.io.reading.xml import Element, read_xml
from raybundle.io.scenes.base import Scene, SceneFormat, check_denominators, register
from raybundle.numerics.arrays import Array
from raybundle.scenes.rpc import rpc_of

POLYNOMIALS = ("LINE_NUM_COEFF", "LINE_DEN_COEFF", "SAMP_NUM_COEFF", "SAMP_DEN_COEFF")
ROOTS = ("VRTDataset", "PAMDataset")
MOST_BYTES = 1 << 24
"""Of a file in which an RPC is looked for."""
_DOMAIN = re.compile(rb"""domain\s*=\s*["']RPC["']""")
_YAML = re.compile(rb"^\s*line_(num|den)_coeff\s*:\s*(\[.*|-.*)?$", re.MULTILINE)


def scene_of_keys(values: Mapping[str, Any], path: Path, format_: str, size: tuple[int, int] | None = None) -> Scene:
    """The scene of GDAL's keys, whose values are numbers or texts of them; raises InputError for what is missing."""
    by_key = {str(k).upper(): v for k, v in values.items()}

    def pick(*keys: str) -> Array:
        return np.array([_number(by_key, k, path) for k in keys])

    errors = [_number(by_key, k, path) if by_key.get(k) is not None else 0.0 for k in ("ERR_BIAS", "ERR_RAND")]
    rpc = rpc_of(
        coefficients=np.array([_twenty(by_key, k, path) for k in POLYNOMIALS]),
        ground_offset=pick("LONG_OFF", "LAT_OFF", "HEIGHT_OFF"),
        ground_scale=pick("LONG_SCALE", "LAT_SCALE", "HEIGHT_SCALE"),
        image_offset=pick("SAMP_OFF", "LINE_OFF") + 0.5,
        image_scale=pick("SAMP_SCALE", "LINE_SCALE"),
        err_bias_m=errors[0] if errors[0] > 0 else None,
        err_rand_m=errors[1] if errors[1] > 0 else None,
    )
    check_denominators(rpc, path, size)
    width, height = size or (None, None)
    return Scene(file=path, format=format_, rpc=rpc, width_px=width, height_px=height)


def _number(values: Mapping[str, Any], key: str, path: Path) -> float:
    if values.get(key) is None:
        raise InputError("rpc.keys_missing", names=[key], file=path)
    value = values[key]
    words = value.split() if isinstance(value, str) else []
    found = number_of(words[0]) if words else finite(value)  # "4089.5 pixels"
    if found is None:
        raise InputError(no_number(value), file=path, column=key)
    return found


def _twenty(values: Mapping[str, Any], key: str, path: Path) -> list[float]:
    value = values.get(key)
    if value is None:
        value = [values.get(f"{key}_{k}") for k in range(1, 21)]
    words = value.split() if isinstance(value, str) else value
    if not isinstance(words, list) or len(words) != 20 or any(w is None for w in words):
        count = len([w for w in words if w is not None]) if isinstance(words, list) else 1
        raise InputError("rpc.coefficient_count", name=key, n=count, file=path)
    numbers = [number_of(w) if isinstance(w, str) else finite(w) for w in words]
    known = [n for n in numbers if n is not None]
    if len(known) != 20:
        raise InputError(no_number(words[numbers.index(None)]), file=path, column=key)
    return known


def read_gdal_xml(path: Path) -> Scene:
    """The domain RPC of a VRT or of persistent auxiliary metadata."""
    with path.open("rb") as file:
        head = file.read(4096)
    root = read_xml(path, next(r for r in ROOTS if f"<{r}".encode() in head))
    for metadata in root.all("Metadata"):
        if metadata.attributes.get("domain") == "RPC":
            values = {m.attribute("key"): m.content.strip() for m in metadata.all("MDI")}
            return scene_of_keys(values, path, "gdal-xml", _size_of(root))
    return root.fail("rpc.metadata_below")


def _size_of(root: Element) -> tuple[int, int] | None:
    words = [root.attributes.get(n, "") for n in ("rasterXSize", "rasterYSize")]
    width, height = (whole_of(w) for w in words)
    return (width, height) if width and height else None


def read_gdal_json(path: Path) -> Scene:
    """What gdalinfo or rasterio print of an RPC."""
    root = read_json(path, MOST_BYTES)
    size: tuple[int, int] | None = None
    if root.has("size") and isinstance(root.get("size").value, list):
        sides = root.get("size").items()
        if len(sides) != 2:
            root.get("size").fail("value.count", n=len(sides), needed=2)
        size = sides[0].whole(), sides[1].whole()
    return scene_of_keys(_group(root).value, path, "gdal-json", size)


def _group(root: Json) -> Json:
    for way in (("metadata", "RPC"), ("rpc",), ("rpcs",), ("RPC",)):
        found = root
        for name in way:
            if not found.has(name):
                break
            found = found.get(name)
        else:
            found.mapping()
            return found
    root.mapping()
    return root


def read_orthority(path: Path) -> Scene:
    """The RPC of orthority's parameter file of one image; its `im_size` is not taken, its order has changed."""
    from raybundle.io.calibrations.yaml_text import read_yaml

    found = list(_rpcs_below(read_yaml(path)))
    if len(found) != 1:
        raise InputError("rpc.not_one", n=len(found), names=[name for name, _ in found], file=path)
    return scene_of_keys(found[0][1].value, path, "orthority")


def _rpcs_below(root: Json) -> Iterator[tuple[str, Json]]:
    if root.has("line_num_coeff"):
        yield "", root
        return
    for name, entry in root.mapping().items():
        if entry.has("line_num_coeff"):
            yield name, entry
        elif entry.has("rpc"):
            yield name, entry.get("rpc")


def _is_gdal_xml(path: Path, head: bytes) -> bool:
    """Such XML with an RPC; without one it shows other things of a picture."""
    if not any(f"<{r}".encode() in head for r in ROOTS):
        return False
    with path.open("rb") as file:
        return _DOMAIN.search(file.read(MOST_BYTES)) is not None


def is_json(path: Path, head: bytes) -> bool:
    """JSON with such keys; where they stand far from the file's beginning, all of it is looked at."""
    if not head.lstrip(b"\xef\xbb\xbf \t\r\n").startswith(b"{") or b"name_model" in head:
        return False
    if path.suffix.lower() != ".json" and b"_coeff" not in head.lower():
        return False
    with path.open("rb") as file:
        return b'"line_num_coeff"' in file.read(MOST_BYTES).lower()


def _is_orthority(path: Path, head: bytes) -> bool:
    del path
    return not head.lstrip().startswith((b"{", b"<")) and b"\0" not in head and _YAML.search(head) is not None


register(
    SceneFormat(name="gdal-xml", title="RPC of GDAL (.vrt, .aux.xml)", recognises=_is_gdal_xml, read=read_gdal_xml)
)
register(
    SceneFormat(name="gdal-json", title="RPC as JSON (gdalinfo, rasterio)", recognises=is_json, read=read_gdal_json)
)
register(SceneFormat(name="orthority", title="RPC as YAML (orthority)", recognises=_is_orthority, read=read_orthority))
