"""Product: a mesh above the plane as PLY with standard deviations, and as OBJ and glTF with the orthophoto on it."""

from __future__ import annotations

from pathlib import Path
from typing import Any, TextIO

import numpy as np
from PIL import Image
from PIL.JpegImagePlugin import JpegImageFile

from raybundle.errors import phrase
from raybundle.io.folders import new_files
from raybundle.io.formats.ply import write_vertices
from raybundle.numerics.arrays import Array
from raybundle.numerics.length_units import precision_unit
from raybundle.surfaces.mesh_of_heights import Mesh, mesh_of
from raybundle.surfaces.product import Context, Product, Written, register
from raybundle.surfaces.run import Surface

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
        _write_glb(glb, mesh, picture, unit)
    sigma = float(np.median(mesh.sigma))
    factor, of = precision_unit(sigma, unit)
    reported = phrase(
        "product.mesh", vertices=len(mesh.xyz), triangles=len(mesh.triangles), sigma=factor * sigma, unit=of
    )
    return Written(files=tuple(out / f for f in FILES), reported=(reported,))


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


class _AsStored(JpegImageFile):
    """A picture that is written as it stands in its file: encoded once more it would lose what it shows."""

    def save(self, fp: Any, format: str | None = None, **params: Any) -> None:  # noqa: A002  (as its base calls it)
        """Write the bytes of the file."""
        del format, params
        fp.write(Path(str(self.filename)).read_bytes())


def _write_glb(path: Path, mesh: Mesh, picture: Path, unit: str) -> None:
    """Write glTF 2.0 in one binary file: vertices in single precision about their middle, which its node shows."""
    import trimesh
    from trimesh.exchange.gltf import export_glb
    from trimesh.visual.material import PBRMaterial
    from trimesh.visual.texture import TextureVisuals

    def reported(tree: dict[str, Any]) -> None:
        tree["asset"] |= {"generator": "raybundle", "extras": {"unit": unit or "none: the scale is free"}}

    middle = np.round((mesh.xyz.min(axis=0) + mesh.xyz.max(axis=0)) / 2, 3)
    with _AsStored(picture) as image:
        material = PBRMaterial(
            "surface", baseColorTexture=image, metallicFactor=0.0, roughnessFactor=1.0, doubleSided=True
        )
        visual = TextureVisuals(uv=mesh.place, material=material)
        surface = trimesh.Trimesh(
            (mesh.xyz - middle) @ Y_UP.T, mesh.triangles, visual=visual, process=False, validate=False
        )
        scene = trimesh.Scene()
        place = np.eye(4)
        place[:3, 3] = Y_UP @ middle
        scene.add_geometry(surface, node_name="surface", geom_name="surface", transform=place)
        path.write_bytes(export_glb(scene, include_normals=False, tree_postprocessor=reported))


PRODUCT = register(Product(name="mesh", files=FILES, write=_write))
