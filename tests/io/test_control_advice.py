"""Names with blanks in gcp_list.txt, and what is advised about heights of systems that have no code."""

import numpy as np
import pytest
from tests.conftest import DATA

from raybundle.errors import InputError
from raybundle.io.geo.control_files import read_control
from raybundle.io.geo.coordinate_systems import height_remarks
from raybundle.io.geo.gcp_rows import words_of
from raybundle.io.geo.parsed_systems import parse_crs
from raybundle.settings import option

REPORTS = DATA / "reports"
HEAD = "1 2 3 4 5 "


@pytest.mark.parametrize(
    ("rest", "image", "point"),
    [
        ("2022-09-26 15-24-47 DJI_0293.JPG g1", "2022-09-26 15-24-47 DJI_0293.JPG", "g1"),
        ("2022-09-26 15-24-47 DJI_0293.JPG", "2022-09-26 15-24-47 DJI_0293.JPG", ""),
        ("IMG (2).jpeg g1", "IMG (2).jpeg", "g1"),
        ("left  camera.tif P 7", "left  camera.tif", "P"),
        ("a.jpg copy.jpg g1", "a.jpg copy.jpg", "g1"),
        ("a b c d.DNG g1 extra", "a b c d.DNG", "g1"),
        ("Foto vom 3. Mai.heic g1", "Foto vom 3. Mai.heic", "g1"),
        ("a.jpg g1", "a.jpg", "g1"),
        ("a.jpg g1 extra1 extra2", "a.jpg", "g1"),
        ("a g1", "a", "g1"),
        ("a.jpg", "a.jpg", ""),
    ],
)
def test_the_name_of_an_image_ends_with_its_suffix(rest, image, point):
    words = words_of(HEAD + rest)
    assert words[5] == image
    assert (words[6] if len(words) > 6 else "") == point


def test_tabs_separate_whatever_stands_between_them():
    assert words_of("1\t2\t3\t4\t5\ta b\tg 1") == ["1", "2", "3", "4", "5", "a b", "g 1"]


def test_names_without_suffix_are_suggested_where_coordinates_differ(tmp_path):
    file = tmp_path / "gcp_list.txt"
    file.write_text("EPSG:32633\n1 2 3 4 5 26 Sep one g1\n9 2 3 4 5 26 Sep two g2\n")
    with pytest.raises(InputError, match=r"gcp_list\.coordinates_differ") as caught:
        read_control(file)
    values = caught.value.message.values
    assert (values["image"], values["point"], values["blanks"]) == ("26", "Sep", True)


SYSTEMS = [
    "+proj=tmerc +lat_0=0 +lon_0=27.5 +k=1 +x_0=500000 +y_0=0 +ellps=GRS80 +units=m +no_defs",
    "+proj=tmerc +lat_0=10 +lon_0=-60 +k=1 +x_0=0 +y_0=0 +ellps=GRS80 +units=m +no_defs",
    "+proj=lcc +lat_1=41 +lat_2=43 +lat_0=40 +lon_0=-100 +x_0=1000 +y_0=2000 +ellps=GRS80 +units=m",
    "+proj=laea +lat_0=-33 +lon_0=151 +ellps=WGS84 +units=m",
    "+proj=stere +lat_0=60 +lon_0=100 +k=0.999 +ellps=WGS84 +units=m",
    "+proj=omerc +lat_0=4 +lonc=115 +alpha=53 +k=0.99984 +x_0=0 +y_0=0 +gamma=53 +ellps=evrstSS +units=m",
]


@pytest.mark.parametrize("system", SYSTEMS)
def test_no_code_of_another_place_is_advised(system):
    (remark,) = height_remarks(system)
    values = remark.messages[0].values
    assert (values["coded"], values["ellipsoidal"]) == (False, "+ellipsoid")
    assert "EPSG" not in remark.replace(values["system"], "")
    assert not height_remarks(system + "+ellipsoid")


@pytest.mark.parametrize("code", ["EPSG:32633", "EPSG:25832", "EPSG:5254", "EPSG:2056", "EPSG:32755"])
def test_the_own_code_is_advised(code):
    (remark,) = height_remarks(code)
    assert remark.messages[0].values["ellipsoidal"] == f"{code}+ellipsoid"
    assert parse_crs(f"{code}+ellipsoid").axis_info


@pytest.mark.parametrize("behind", ["+5773", " +5773", "+7837"])
def test_a_code_of_heights_behind_a_proj_string_is_refused(behind):
    with pytest.raises(InputError, match=r"crs\.heights_of_proj_string"):
        parse_crs(SYSTEMS[0] + behind)
    assert parse_crs("EPSG:32633+5773").is_compound


def test_messages_print_all_digits_of_coordinates():
    assert option("extent", 500010.25, 5400020.125) in {
        "--extent 500010.25 5400020.125",
        "extent=(500010.25, 5400020.125)",
    }
    assert option("gsd", 0.1 + 0.2).endswith("0.3")
    assert option("gsd", 1e-3).endswith("0.001")


@pytest.mark.skipif(not REPORTS.is_dir(), reason="no public data: set RAYBUNDLE_DATA to the folder of reports/")
def test_reported_lists():
    found = read_control(REPORTS / "gcp-blank-in-image-name" / "gcp_list.txt")
    assert found.ids == ("g1", "g2", "g3")
    assert found.measurements.image == ("2022-09-26 15-24-47 DJI_0293.JPG",) * 2 + ("b.jpg",)
    assert np.isfinite(found.xyz).all()
    other = read_control(REPORTS / "hint-names-another-zone" / "gcp_list.txt")
    assert "32633" not in height_remarks(other.crs)[0]
