"""Control files: gcp_list.txt, CSV and block folders; what is wrong is named by file, line and column."""

import numpy as np
import pytest
from PIL import Image
from tests.conftest import DATA

from raybundle.block import Role
from raybundle.errors import InputError
from raybundle.io.block.folder import write_block
from raybundle.io.geo.control_files import ControlDefaults, named_apart, read_control
from raybundle.placing.marks import Given, ScaleBar
from raybundle.planning.scenes import TargetField, field_scene
from raybundle.planning.simulate import Survey, simulate
from raybundle.workflows import orient as workflow

COPR = DATA / "photos" / "copr-uav" / "gcp_list.txt"
GCP = """\
# taken with a level
EPSG:32611
235269.88\t3811198.11\t12.5\t1804.68\t1146.89\tIMG 37.jpg
235269.88 3811198.11 12.5 294.84 513.24 IMG_0121.jpg

# another one
235262.54 3811203.5 13.5 1736.08 500.27 IMG_0052.jpg
"""
CSV = "point,X,Y,Z,sX,sY,sZ,role\na,1,2,3,0,0,0.01,\nb,4,5,,,,,check\n"
MEASURED = "image,point,x_px,y_px\n1.jpg,a,10,20\n2.jpg,a,30,40.5\n2.jpg,b,5,6\n"


def write(tmp_path, text, name="gcp_list.txt"):
    (tmp_path / name).write_text(text, encoding="utf-8")
    return tmp_path / name


@pytest.mark.data
@pytest.mark.skipif(not COPR.is_file(), reason="the public data sets are not here; set RAYBUNDLE_DATA")
def test_the_public_list():
    control = read_control(COPR)
    assert len(control.ids) == 10
    assert set(control.ids) == {f"gcp0{k}" for k in range(10)}
    assert len(control.measurements) == 27
    assert np.isnan(control.xyz[:, 2]).all()
    assert np.isnan(control.sigma[:, 2]).all()
    assert "plan alone" in control.remarks[0]
    rays = dict(zip(control.ids, np.bincount(control.measurements.point).tolist(), strict=True))
    assert (rays["gcp00"], rays["gcp01"], rays["gcp06"]) == (1, 2, 3)
    assert control.crs is not None
    assert control.crs.startswith("+proj=utm +zone=11")


def test_lines_with_the_same_coordinates_are_one_point(tmp_path):
    control = read_control(write(tmp_path, GCP), defaults=ControlDefaults(plan=0.5, height=0.7))
    assert control.crs == "EPSG:32611"
    assert control.ids == ("gcp00", "gcp01")
    assert control.measurements.image == ("IMG 37.jpg", "IMG_0121.jpg", "IMG_0052.jpg")
    assert control.measurements.point.tolist() == [0, 0, 1]
    assert control.measurements.line.tolist() == [3, 4, 7]
    np.testing.assert_array_equal(control.xyz[1], [235262.54, 3811203.5, 13.5])
    np.testing.assert_array_equal(control.sigma[1], [0.5, 0.5, 0.7])
    assert control.role.tolist() == [Role.CONTROL] * 2
    assert "no names" in control.remarks[0]


def test_windows_files_and_byte_order_marks(tmp_path):
    path = tmp_path / "gcp_list.txt"
    path.write_bytes(b"\xef\xbb\xbf" + GCP.replace("\n", "\r\n").encode())
    assert len(read_control(path).ids) == 2


def test_one_height_that_is_not_zero_makes_them_known(tmp_path):
    text = GCP.replace(" 12.5 ", " 0 ").replace("\t12.5\t", "\t0\t")
    assert read_control(write(tmp_path, text)).xyz[:, 2].tolist() == [0.0, 13.5]
    unknown = read_control(write(tmp_path, text.replace(" 13.5 ", " 0.0 ")))
    assert np.isnan(unknown.xyz[:, 2]).all()
    single = read_control(write(tmp_path, text.replace(" 13.5 ", " nan ")))
    assert np.isnan(single.xyz[1, 2])


GCP_CASES = {
    "empty": (GCP, "", 1, None, "the file is empty"),
    "no system": ("EPSG:32611\n", "", 2, None, "must name the coordinate system"),
    "unknown system": ("EPSG:32611", "UTM eleven", 2, None, "no coordinate system"),
    "only a system": (GCP[GCP.index("235") :], "", 2, None, "there is no point"),
    "few columns": (" IMG_0121.jpg", "", 4, None, "5 columns"),
    "text": ("294.84", "29a.84", 4, "x_px", "'29a.84' is not a finite number"),
    "comma": ("294.84", "294,84", 4, "x_px", "decimal sign"),
    "infinite": ("3811203.5", "inf", 7, "Y", "'inf' is not a finite number"),
    "underscore": ("3811203.5", "3_8", 7, "Y", "is not a finite number"),
    "twice": ("IMG_0121.jpg", "IMG_0052.jpg\n235269.88 3811198.11 12.5 3 4 IMG_0052.jpg", 5, "image", "in line 4"),
    "some names": ("IMG_0052.jpg", "IMG_0052.jpg p2", 3, "name", "has no name"),
}


@pytest.mark.parametrize("case", GCP_CASES.values(), ids=GCP_CASES)
def test_what_is_wrong_in_a_list_is_named(case, tmp_path):
    old, new, line, column, words = case
    assert old in GCP
    path = write(tmp_path, GCP.replace(old, new))
    with pytest.raises(InputError, match=words) as caught:
        read_control(path)
    assert (caught.value.file, caught.value.line, caught.value.column) == (str(path), line, column)


def test_one_name_with_two_positions(tmp_path):
    text = GCP.replace("IMG_0121.jpg", "IMG_0121.jpg p").replace("IMG_0052.jpg", "IMG_0052.jpg p")
    text = text.replace("IMG 37.jpg", "IMG 37.jpg\tp")
    with pytest.raises(InputError, match="'p' has other coordinates in line 3") as caught:
        read_control(write(tmp_path, text))
    assert (caught.value.line, caught.value.column) == (7, "X")


def test_bytes_that_are_no_text(tmp_path):
    path = tmp_path / "gcp_list.txt"
    path.write_bytes(b"EPSG:32611\n\xff\xfe")
    with pytest.raises(InputError, match="not UTF-8") as caught:
        read_control(path)
    assert caught.value.line == 2
    with pytest.raises(InputError, match="cannot be read"):
        read_control(tmp_path / "nothing.txt")


def test_csv_with_measurements_beside(tmp_path):
    path = write(tmp_path, CSV, "control.csv")
    assert len(read_control(path).measurements) == 0
    write(tmp_path, MEASURED, "control-measurements.csv")
    control = read_control(path, defaults=ControlDefaults(plan=0.1, height=0.2))
    assert control.crs is None
    assert control.role.tolist() == [Role.CONTROL, Role.CHECK]
    np.testing.assert_array_equal(control.sigma, [[0, 0, 0.01], [0.1, 0.1, np.nan]])
    assert np.isnan(control.xyz[1, 2])
    assert control.measurements.image == ("1.jpg", "2.jpg", "2.jpg")
    np.testing.assert_array_equal(control.measurements.xy_px, [[10, 20], [30, 40.5], [5, 6]])
    assert "0.1 in plan" in control.remarks[0]


CSV_CASES = {
    "role": ("control.csv", "check", "checked", 3, "role", "'checked' is not one of"),
    "sigma": ("control.csv", ",,,check", ",,1,check", 3, "sZ", "has sZ but no Z"),
    "nothing": ("control.csv", "b,4,5,", "b,,,", 3, "X", "has no coordinate"),
    "negative": ("control.csv", "0.01", "-0.01", 2, "sZ", "negative"),
    "point": ("m.csv", "2.jpg,b", "2.jpg,c", 4, "point", "'c' stands nowhere in"),
    "twice": ("m.csv", "2.jpg,a", "1.jpg,a", 3, "point", "already in line 2"),
    "pixel": ("m.csv", "40.5", "", 3, "y_px", "the cell is empty"),
}


@pytest.mark.parametrize("case", CSV_CASES.values(), ids=CSV_CASES)
def test_what_is_wrong_in_a_csv_is_named(case, tmp_path):
    file, old, new, line, column, words = case
    texts = {"control.csv": CSV, "m.csv": MEASURED}
    assert old in texts[file]
    texts[file] = texts[file].replace(old, new, 1)
    for name, text in texts.items():
        write(tmp_path, text, name)
    with pytest.raises(InputError, match=words) as caught:
        read_control(tmp_path / "control.csv", measurements=tmp_path / "m.csv")
    assert caught.value.file == str(tmp_path / file)
    assert (caught.value.line, caught.value.column) == (line, column)


def test_a_list_holds_its_own_measurements(tmp_path):
    with pytest.raises(InputError, match="belongs to a CSV"):
        read_control(write(tmp_path, GCP), measurements=tmp_path / "m.csv")


def test_the_points_of_a_block(tmp_path):
    survey = Survey(control=3, check=2, control_sigma=(0.0, 0.01, float("nan")))
    block = simulate(field_scene(TargetField(stations=3, frontal=1, rows=4, columns=4)), survey).observed
    write_block(block, tmp_path / "b")
    control = read_control(tmp_path / "b")
    assert sorted(np.bincount(control.role).tolist()) == [0, 2, 3]
    named = [k for k, r in enumerate(block.points.role) if r != Role.TIE]
    assert control.ids == tuple(block.points.ids[k] for k in named)
    assert len(control.measurements) == int(np.isin(block.observations.point, named).sum())
    write_block(simulate(field_scene(TargetField(stations=3)), Survey()).observed, tmp_path / "c")
    with pytest.raises(InputError, match="neither control nor check"):
        read_control(tmp_path / "c")


@pytest.mark.parametrize(
    ("heights", "sigma", "believed"),
    [
        (("0", "0", "0"), False, False),
        (("0", "0"), False, False),
        (("0", "0", "0"), True, True),
        (("12.345", "12.345", "12.345"), False, False),
        (("12.345", "12.345", "12.346"), False, True),
        (("12", "12", "12"), False, True),  # in whole metres level ground is all the same
        (("0", "0", "0.1"), False, True),
        (("0",), False, True),
    ],
)
@pytest.mark.parametrize("kind", ["csv", "gcp"])
def test_equal_heights_are_no_measurement(tmp_path, heights, sigma, believed, kind):
    if kind == "gcp":
        if sigma:
            pytest.skip("gcp_list.txt states no standard deviations")
        path = tmp_path / "gcp_list.txt"
        rows = [f"{500000 + 3 * k} {4000000 + 5 * k} {z} 10 10 a.jpg P{k}" for k, z in enumerate(heights)]
        path.write_text("\n".join(["EPSG:32611", *rows]) + "\n")
    else:
        path = tmp_path / "control.csv"
        head = "point,X,Y,Z,sX,sY,sZ" if sigma else "point,X,Y,Z"
        tail = ",0.01,0.01,0.02" if sigma else ""
        rows = [f"P{k},{3 * k},{5 * k},{z}{tail}" for k, z in enumerate(heights)]
        path.write_text("\n".join([head, *rows]) + "\n")
    control = read_control(path)
    assert np.isfinite(control.xyz[:, 2]).all() == believed
    assert np.isfinite(control.sigma[:, 2]).all() == believed
    assert np.isfinite(control.xyz[:, :2]).all()
    assert any("taken as unknown" in r for r in control.remarks) != believed


def test_control_and_check_points_without_names_have_names_of_their_own(tmp_path):
    """And one name in two files is refused before anything is computed."""
    lines = "EPSG:32633\n500000 5000000 10 5 6 a.jpg\n500010 5000000 11 5 6 a.jpg\n"
    first, second = write(tmp_path, lines, "control.txt"), write(tmp_path, lines, "check.txt")
    control, check = read_control(first), read_control(second, defaults=ControlDefaults(role="check"))
    assert control.ids == ("gcp00", "gcp01")
    assert check.ids == ("check00", "check01")
    assert "check00" in check.remarks[0]
    assert Given(control=(control, check)).control == (control, check)
    with pytest.raises(InputError, match=r"gcp00 is given twice, here and in control\.txt") as caught:
        Given(control=(control, read_control(second)))
    assert caught.value.file == str(second)


def test_two_lists_without_names_of_one_role_count_on(tmp_path):
    """Made names leave out those that another file gives."""
    lines = "EPSG:32633\n500000 5000000 10 5 6 a.jpg\n500010 5000000 11 5 6 a.jpg\n"
    files = [read_control(write(tmp_path, lines, n)) for n in ("first.txt", "second.txt")]
    own = read_control(write(tmp_path, "EPSG:32633\n500020 5000000 12 5 6 a.jpg gcp02\n", "own.txt"))
    apart = named_apart((*files, own))
    assert [f.ids for f in apart] == [("gcp00", "gcp01"), ("gcp03", "gcp04"), ("gcp02",)]
    assert "gcp03, gcp04" in apart[1].remarks[0]
    assert Given(control=apart).control == apart


@pytest.mark.parametrize("wrong", ["mark", "bar", "set"])
def test_an_error_of_a_control_file_comes_before_anything_is_computed(tmp_path, monkeypatch, wrong):
    photos = tmp_path / "photos"
    photos.mkdir()
    pixels = np.random.default_rng(1).integers(0, 255, (2, 60, 80, 3), dtype=np.uint8)
    for name, p in zip("ab", pixels, strict=True):
        Image.fromarray(p).save(photos / f"{name}.jpg")
    place = "900 6" if wrong == "mark" else "5 6"
    photo = "IMG_1.JPG" if wrong == "set" else "a.jpg"
    control = read_control(write(tmp_path, f"EPSG:32633\n500000 5000000 10 {place} {photo} one\n"))
    bars = (ScaleBar(start="one", end="two", length=1.0, sigma=0.001),) if wrong == "bar" else ()

    def computed(*_args):
        pytest.fail("features were looked for before the files of control were judged")

    monkeypatch.setattr("raybundle.workflows.orienting.features.find_features", computed)
    told = {
        "mark": r"900, 6 lies outside photograph a\.jpg", "bar": "point two is not measured",
        "set": r"measures points in IMG_1\.JPG, and none of these is among the photographs \(a\.jpg, b\.jpg\)",
    }  # fmt: skip
    with pytest.raises(InputError, match=told[wrong]):
        workflow.orient([photos], tmp_path / "project", given=Given(control=(control,), scale_bars=bars))
