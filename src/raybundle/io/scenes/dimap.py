"""DIMAP 2 XML of SPOT 6/7 and Pleiades: the RPC (RPC_*.XML) or the rigorous model (DIM_*.XML); and PHRDIMAP_*.XML.

The first pixel has the number that the file says (1).
"""

from __future__ import annotations

from pathlib import Path

import numpy as np

from raybundle.io.reading.files import read_bytes
from raybundle.io.reading.xml import Element, read_xml
from raybundle.io.scenes.base import HEAD_BYTES, Scene, SceneFormat, check_denominators, element_text, register
from raybundle.io.scenes.dimap_orbit import line_scene
from raybundle.numerics.arrays import Array
from raybundle.scenes.rpc import Rpc, rpc_of

POLYNOMIALS = ("LINE_NUM_COEFF", "LINE_DEN_COEFF", "SAMP_NUM_COEFF", "SAMP_DEN_COEFF")


def read(path: Path) -> Scene:
    """The RPC of a DIMAP file, whose inverse model (ground to image) is the RPC of everyone else; or its orbit."""
    if _is_phr(read_bytes(path)[:HEAD_BYTES]):
        return _phr(path)
    root = read_xml(path, "Dimap_Document")
    if root.find("Geometric_Data", "Refined_Model") is not None:
        return _product(path, root)
    model = root.find("Rational_Function_Model", "Global_RFM")
    if model is None:
        root.fail(
            "neither Rational_Function_Model/Global_RFM nor Geometric_Data/Refined_Model stands in it; give the file "
            "RPC_*.XML or DIM_*.XML of the product"
        )
    validity = model.get("RFM_Validity")
    first, size = _image(validity)
    values = model.find("GroundtoImage_Values") or model.get("Inverse_Model")
    rpc = rpc_of(
        coefficients=np.stack([_coefficients(values, name) for name in POLYNOMIALS]),
        ground_offset=np.array([validity.number(f"{k}_OFF") for k in ("LONG", "LAT", "HEIGHT")]),
        ground_scale=np.array([validity.number(f"{k}_SCALE") for k in ("LONG", "LAT", "HEIGHT")]),
        image_offset=np.array([validity.number("SAMP_OFF"), validity.number("LINE_OFF")]) - first + 0.5,
        image_scale=np.array([validity.number("SAMP_SCALE"), validity.number("LINE_SCALE")]),
    )
    return _rpc_scene(path, root, rpc, size)


def _rpc_scene(path: Path, root: Element, rpc: Rpc, size: tuple[int | None, int | None]) -> Scene:
    """The scene of an RPC, whichever of the two formats told it; raises InputError where its denominators vanish."""
    check_denominators(rpc, path)
    return Scene(
        file=path,
        format="dimap",
        rpc=rpc,
        width_px=size[0],
        height_px=size[1],
        sensor=element_text(root, "Metadata_Identification", "METADATA_PROFILE"),
        remarks=(NO_PRIOR,),
    )


def _is_phr(head: bytes) -> bool:
    return b"<PHR_Dimap_Document" in head


def _phr(path: Path) -> Scene:
    """The RPC of the first format of Pleiades (METADATA_FORMAT DIMAP_PHR): forty coefficients in a row, A and B."""
    root = read_xml(path, "PHR_Dimap_Document")
    model = root.get("Geoposition", "Rational_Sensor_Model", "Global_RFM")
    validity = model.get("RFM_Validity")
    first, size = _image(validity)
    rows = [model.get("Inverse_Model", name).numbers(40).reshape(2, 20) for name in ("F_ROW", "F_COL")]

    def pick(part: str, *names: str) -> list[float]:
        return [validity.get(n).number(part) for n in names]

    rpc = rpc_of(
        coefficients=np.concatenate(rows),
        ground_offset=pick("B", "Lon", "Lat", "Alt"),
        ground_scale=pick("A", "Lon", "Lat", "Alt"),
        image_offset=np.array(pick("B", "Col", "Row")) - first + 0.5,
        image_scale=pick("A", "Col", "Row"),
    )
    return _rpc_scene(path, root, rpc, size)


NO_PRIOR = "DIMAP states how well its RPC fits the orbit, not how well the orbit is known: no prior for the bias"


def _image(validity: Element) -> tuple[Array, tuple[int | None, int | None]]:
    """Number of the first column and row, and the size of the image where the file tells it."""
    domain = validity.find("Direct_Model_Validity_Domain")
    if domain is None and validity.find("ImagetoGround_Validity_Domain") is not None:
        # Pleiades Neo: the domain reaches beyond the image, which begins with column and row 1
        return np.ones(2), (None, None)
    domain = validity.get("Direct_Model_Validity_Domain")
    first = np.array([domain.number("FIRST_COL"), domain.number("FIRST_ROW")])
    last = np.array([domain.number("LAST_COL"), domain.number("LAST_ROW")])
    size = np.round(last - first).astype(int) + 1
    if (size < 2).any():
        domain.fail(f"an image of {size[0]} x {size[1]} px; rows or columns are exchanged")
    return first, (int(size[0]), int(size[1]))


def _product(path: Path, root: Element) -> Scene:
    """The rigorous model of a product file."""
    line, remarks = line_scene(root)
    source = root.find("Dataset_Sources", "Source_Identification", "Strip_Source")
    names = () if source is None else (element_text(source, k) for k in ("MISSION", "MISSION_INDEX"))
    return Scene(
        file=path,
        format="dimap",
        line=line,
        width_px=line.width_px,
        height_px=line.height_px,
        sensor=" ".join(n for n in names if n) or element_text(root, "Metadata_Identification", "METADATA_PROFILE"),
        time=element_text(root.get("Geometric_Data"), "Refined_Model", "Time", "Time_Range", "START"),
        remarks=remarks,
    )


def _coefficients(model: Element, name: str) -> Array:
    """(20,) coefficients NAME_1 to NAME_20."""
    return np.array([model.number(f"{name}_{k}") for k in range(1, 21)])


def _recognises(path: Path, head: bytes) -> bool:
    del path
    if _is_phr(head):
        return True
    return b"<Dimap_Document" in head and b"METADATA_FORMAT version='1." not in head.replace(b'"', b"'")


register(
    SceneFormat(
        name="dimap", title="DIMAP 2 XML (SPOT 6/7, Pleiades; PHRDIMAP): RPC, orbit", recognises=_recognises, read=read
    )
)
