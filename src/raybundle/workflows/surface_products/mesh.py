"""Product: a mesh above the plane as PLY with standard deviations, and as OBJ and glTF with the orthophoto on it."""

from __future__ import annotations

import json
import struct
from pathlib import Path
from typing import TextIO

import numpy as np
from PIL import Image

from raybundle.io.folders import new_files
from raybundle.io.formats.ply import write_vertices
from raybundle.numerics.arrays import Array
from raybundle.workflows.surface import Surface
from raybundle.workflows.surface_mesh import Mesh, mesh_of
from raybundle.workflows.surface_product import Context, Product, Written, register

PLY, OBJ, MTL, PICTURE, GLB = FILES = ("mesh.ply", "mesh.obj", "mesh.mtl", "mesh.jpg", "mesh.glb")
ROWS = 100_000
"""Of a text that are made at once."""
Y_UP = np.array([[1.0, 0, 0], [0, 0, 1], [0, -1, 0]])
"""glTF 2.0, section 3.4: Y points up."""


def _write(surface: Surface, out: Path, context: Context) -> Written:
    assert context.mesh is not None
    mesh = mesh_of(surface, context.mesh)
    unit = context.unit
    with new_files(*(out / f for f in FILES)) as (ply, obj, mtl, picture, glb):
        comments = (f"unit {unit}" if unit else 'scale = "free"', "sigma: one standard deviation of the height")
        write_vertices(ply, mesh.xyz, mesh.colours, {"sigma": mesh.sigma}, comments, mesh.triangles)
        Image.fromarray(mesh.picture).save(picture, format="JPEG", quality=92, subsampling=0)
        mtl.write_text(f"newmtl surface\nKa 0 0 0\nKd 1 1 1\nKs 0 0 0\nillum 1\nmap_Kd {PICTURE}\n", encoding="ascii")
        _write_obj(obj, mesh, unit)
        _write_glb(glb, mesh, picture.read_bytes(), unit)
    told = (
        f"{len(mesh.xyz)} vertices, {len(mesh.triangles)} triangles; standard deviation of a height "
        f"{float(np.median(mesh.sigma)):.2g} {unit}".rstrip() + " in the median"
    )  # fmt: skip
    return Written(files=tuple(out / f for f in FILES), told=(told,))


def _write_obj(path: Path, mesh: Mesh, unit: str) -> None:
    with path.open("w", encoding="ascii", newline="\n") as file:
        file.write(f"# raybundle; {f'unit {unit}' if unit else 'no unit: the scale is free'}\nmtllib {MTL}\n")
        _rows(file, "v %.6f %.6f %.6f", mesh.xyz)
        _rows(file, "vt %.6f %.6f", mesh.place)
        file.write("usemtl surface\n")
        numbers = np.repeat(mesh.triangles + 1, 2, axis=1)
        _rows(file, "f %d/%d %d/%d %d/%d", numbers)


def _rows(file: TextIO, row: str, values: Array) -> None:
    for begin in range(0, len(values), ROWS):
        part = values[begin : begin + ROWS]
        file.write("\n".join([row] * len(part)) % tuple(part.ravel().tolist()) + "\n")


def _write_glb(path: Path, mesh: Mesh, picture: bytes, unit: str) -> None:
    """Write glTF 2.0 in one binary file: vertices in single precision about their middle, which its node tells."""
    middle = np.round((mesh.xyz.min(axis=0) + mesh.xyz.max(axis=0)) / 2, 3)
    xyz = ((mesh.xyz - middle) @ Y_UP.T).astype("<f4")
    uv = (mesh.place * [1, -1] + [0, 1]).astype("<f4")  # from the upper left corner
    index = mesh.triangles.astype("<u4")
    views, data = [], b""
    for part, target in ((xyz.tobytes(), 34962), (uv.tobytes(), 34962), (index.tobytes(), 34963), (picture, 0)):
        views.append(
            {"buffer": 0, "byteOffset": len(data), "byteLength": len(part), **({"target": target} if target else {})}
        )
        data += part + b"\0" * (-len(part) % 4)
    whole = {
        "asset": {"version": "2.0", "generator": "raybundle", "extras": {"unit": unit or "none: the scale is free"}},
        "scene": 0, "scenes": [{"nodes": [0]}],
        "nodes": [{"mesh": 0, "name": "surface", "translation": (Y_UP @ middle).tolist()}],
        "meshes": [{"primitives": [{"attributes": {"POSITION": 0, "TEXCOORD_0": 1}, "indices": 2, "material": 0}]}],
        "materials": [{
            "name": "surface", "doubleSided": True,
            "pbrMetallicRoughness": {"baseColorTexture": {"index": 0}, "metallicFactor": 0.0, "roughnessFactor": 1.0},
        }],
        "textures": [{"source": 0, "sampler": 0}],
        "samplers": [{"magFilter": 9729, "minFilter": 9987, "wrapS": 33071, "wrapT": 33071}],
        "images": [{"bufferView": 3, "mimeType": "image/jpeg"}],
        "accessors": [
            {"bufferView": 0, "componentType": 5126, "count": len(xyz), "type": "VEC3",
             "min": xyz.min(axis=0).tolist(), "max": xyz.max(axis=0).tolist()},
            {"bufferView": 1, "componentType": 5126, "count": len(uv), "type": "VEC2"},
            {"bufferView": 2, "componentType": 5125, "count": index.size, "type": "SCALAR"},
        ],
        "bufferViews": views, "buffers": [{"byteLength": len(data)}],
    }  # fmt: skip
    text = json.dumps(whole, separators=(",", ":")).encode()
    text += b" " * (-len(text) % 4)
    with path.open("wb") as file:
        file.write(struct.pack("<4sII", b"glTF", 2, 12 + 8 + len(text) + 8 + len(data)))
        file.write(struct.pack("<I4s", len(text), b"JSON") + text)
        file.write(struct.pack("<I4s", len(data), b"BIN\0") + data)


PRODUCT = register(Product(name="mesh", files=FILES, write=_write))
