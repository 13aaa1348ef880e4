"""Pixel origin of DIMAP RPCs, from the specification of each profile; GDAL is the referee where it reads it."""

import warnings

import numpy as np
import pytest

from raybundle.cli.main import main
from raybundle.io.scenes import read_scene
from raybundle.io.scenes.dimap import POLYNOMIALS
from tests.conftest import DATA

REPORTS = DATA / "reports"
NEWER = ("GroundtoImage_Values", "ImagetoGround_Validity_Domain")
OLDER = ("Inverse_Model", "Direct_Model_Validity_Domain")


def dimap(rpc, profile, version, names, first, last=(8000, 7000)):
    """A file RPC_*.XML, whose offsets are those of an RPC, written as they are."""
    model, domain = names
    terms = "".join(
        f"<{p}_{k}>{float(c)!r}</{p}_{k}>"
        for p, row in zip(POLYNOMIALS, rpc.coefficients, strict=True)
        for k, c in enumerate(row, 1)
    )
    offsets = dict(zip(("LONG", "LAT", "HEIGHT"), rpc.ground_offset, strict=True))
    scales = dict(zip(("LONG", "LAT", "HEIGHT"), rpc.ground_scale, strict=True))
    offsets |= {"SAMP": rpc.image_offset[0] - 0.5, "LINE": rpc.image_offset[1] - 0.5}
    scales |= {"SAMP": rpc.image_scale[0], "LINE": rpc.image_scale[1]}
    pairs = [(f"{k}_OFF", v) for k, v in offsets.items()] + [(f"{k}_SCALE", v) for k, v in scales.items()]
    ends = {"FIRST_COL": first[0], "FIRST_ROW": first[1], "LAST_COL": last[0], "LAST_ROW": last[1]}
    return (
        f'<?xml version="1.0"?><Dimap_Document version="{version}"><Metadata_Identification>'
        f'<METADATA_FORMAT version="{version}">DIMAP</METADATA_FORMAT><METADATA_PROFILE>{profile}</METADATA_PROFILE>'
        "<METADATA_SUBPROFILE>RPC</METADATA_SUBPROFILE></Metadata_Identification><Rational_Function_Model><Global_RFM>"
        f"<{model}>{terms}</{model}><RFM_Validity>{''.join(f'<{k}>{float(v)!r}</{k}>' for k, v in pairs)}"
        f"<{domain}>{''.join(f'<{k}>{v}</{k}>' for k, v in ends.items())}</{domain}></RFM_Validity>"
        "</Global_RFM></Rational_Function_Model></Dimap_Document>"
    )


@pytest.mark.parametrize(
    ("profile", "version", "names", "first", "number"),
    [
        ("PNEO_SENSOR", "3.0", NEWER, (0, 0), 0),
        ("PNEO_SENSOR", "3.0", NEWER, (-120, -80), 0),
        ("PNEO_SENSOR", "3.1", NEWER, (1, 1), 0),
        ("PNEO_SENSOR", "3.0", NEWER, (300, 0), 0),
        ("PNEO_SENSOR", "2.15", NEWER, (0, 0), 0),
        ("PHR_SENSOR", "2.0", OLDER, (1, 1), 1),
        ("PHR_SENSOR", "2.15", OLDER, (-3, -3), 1),
        ("S6_SENSOR", "2.0", OLDER, (1, 1), 1),
        ("S7_SENSOR", "2.0", OLDER, (101, 1), 1),
        ("PHR_SENSOR", "3.0", NEWER, (0, 0), 1),
    ],
)
def test_the_profile_fixes_the_first_pixel(rpc, tmp_path, profile, version, names, first, number):
    file = tmp_path / "RPC_A.XML"
    text = dimap(rpc, profile, version, names, first)
    rasterio = pytest.importorskip("rasterio")
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")
        picture = tmp_path / "IMG_A_R1C1.TIF"
        with rasterio.open(picture, "w", driver="GTiff", width=20, height=20, count=1, dtype="uint8"):
            pass
        file.write_text(text)
        (tmp_path / "DIM_A.XML").write_text(text)
        with rasterio.open(picture) as opened:
            referee = opened.rpcs
    found = read_scene(file).rpc
    assert found.image_offset == pytest.approx(np.array([referee.samp_off, referee.line_off]) + 0.5, abs=1e-9)
    assert found.image_offset == pytest.approx(rpc.image_offset - number, abs=1e-9)


@pytest.mark.parametrize(
    ("profile", "names", "first", "number", "size"),
    [
        ("PHR_SENSOR", OLDER, (1, 1), 1, (8000, 7000)),
        ("PHR_SENSOR", OLDER, (0, 0), 1, (None, None)),
        ("PNEO_SENSOR", NEWER, (0, 0), 0, (None, None)),
        ("OTHER_SENSOR", OLDER, (1, 1), 1, (8000, 7000)),
        ("OTHER_SENSOR", OLDER, (0, 0), 0, (8001, 7001)),
        ("OTHER_SENSOR", NEWER, (-5, -5), 0, (None, None)),
    ],
)
def test_the_size_is_the_domain_of_validity_only_where_it_begins_with_the_image(
    rpc, tmp_path, profile, names, first, number, size
):
    file = tmp_path / "RPC_A.XML"
    file.write_text(dimap(rpc, profile, "3.0", names, first))
    found = read_scene(file)
    assert found.rpc.image_offset == pytest.approx(rpc.image_offset - number)
    assert (found.width_px, found.height_px) == size


@pytest.mark.skipif(not REPORTS.is_dir(), reason="no public data: set RAYBUNDLE_DATA to the folder of reports/")
def test_a_pleiades_neo_file_agrees_with_its_text(tmp_path):
    folder = REPORTS / "pneo-rpc-one-pixel"
    tables = []
    for name in ("RPC_PNEO3.XML", "same_RPC.TXT"):
        out = tmp_path / f"{name}.csv"
        assert main(["rpc", "project", str(folder / name), str(folder / "pts.csv"), "--out", str(out)]) == 0
        tables.append(out.read_text())
    assert tables[0] == tables[1]
    assert tables[0].splitlines()[1].startswith("A,5883.85")
