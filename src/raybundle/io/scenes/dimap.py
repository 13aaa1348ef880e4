"""DIMAP XML of SPOT 6/7, Pleiades (2) and Pleiades Neo (3): RPC (RPC_*.XML), orbit (DIM_*.XML); and PHRDIMAP_*.XML.

The centre of the first pixel is 1, 1 for SPOT 6/7 and Pleiades, 0, 0 for Pleiades Neo; in files of other profiles it
has the first number of the domain of validity.
"""

from __future__ import annotations

from pathlib import Path

import numpy as np

from raybundle.errors import InputError, note
from raybundle.io.reading.files import read_bytes
from raybundle.io.reading.xml import Element, read_xml
from raybundle.io.scenes.base import HEAD_BYTES, Scene, SceneFormat, check_denominators, element_text, register
from raybundle.io.scenes.dimap_orbit import line_scene
from raybundle.io.scenes.products import orthoimage
from raybundle.numerics.arrays import Array
from raybundle.scenes.rpc import Rpc, rpc_of

FIRST_PIXEL = {"PHR": 1.0, "S6": 1.0, "S7": 1.0, "PNEO": 0.0}
"""Number of the first pixel by the first word of METADATA_PROFILE (PHR_SENSOR, PNEO_SENSOR)."""
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
        if (product := orthoimage(read_bytes(path))) is not None:
            raise InputError(product, file=path)
        root.fail("dimap.no_model")
    validity = model.get("RFM_Validity")
    first, size = _image(root, validity)
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
    """The scene of an RPC, whichever of the two formats stated it; raises InputError where its denominators vanish."""
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
    first, size = _image(root, validity)
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


NO_PRIOR = note("dimap.no_bias_prior")


def _image(root: Element, validity: Element) -> tuple[Array, tuple[int | None, int | None]]:
    """Number of the first column and row, and the size of the image where the file states it.

    The profile fixes the number of the first pixel.  The domain of validity need not begin there: it may reach beyond
    the image or cover a part of it, so that its size is that of the image only where it does.
    """
    domain = validity.find("Direct_Model_Validity_Domain")
    newer = domain is None and validity.find("ImagetoGround_Validity_Domain") is not None
    family = element_text(root, "Metadata_Identification", "METADATA_PROFILE").partition("_")[0].upper()
    number = FIRST_PIXEL.get(family)
    if newer:
        return np.full(2, 0.0 if number is None else number), (None, None)
    domain = validity.get("Direct_Model_Validity_Domain")
    first = np.array([domain.number("FIRST_COL"), domain.number("FIRST_ROW")])
    last = np.array([domain.number("LAST_COL"), domain.number("LAST_ROW")])
    size = np.round(last - first).astype(int) + 1
    if (size < 2).any():
        domain.fail("dimap.image_size", width_px=int(size[0]), height_px=int(size[1]))
    if number is not None and (first != number).any():
        return np.full(2, number), (None, None)
    return first, (int(size[0]), int(size[1]))


def _product(path: Path, root: Element) -> Scene:
    """The rigorous model of a product file."""
    line, remarks = line_scene(root)
    source = root.find("Dataset_Sources", "Source_Identification", "Strip_Source")
    names = () if source is None else (element_text(source, k) for k in ("MISSION", "MISSION_INDEX"))
    return Scene(
        file=path,
        format="dimap",
        rigorous=line,
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
        name="dimap",
        title="DIMAP 2 and 3 XML (SPOT 6/7, Pleiades, Pleiades Neo; PHRDIMAP): RPC, orbit",
        recognises=_recognises,
        read=read,
    )
)
