"""Control files: gcp_list.txt, CSV and block folders; what is wrong is named by file, line and column."""

import re

import numpy as np
import pytest
from PIL import Image
from tests.conftest import DATA
from tests.messages import refused

from raybundle.block import Role
from raybundle.errors import InputError
from raybundle.io.block.folder import write_block
from raybundle.io.geo.control_files import ControlDefaults, named_apart, read_control
from raybundle.io.geo.control_systems import check_degrees, in_one_system, sigma_in_metres
from raybundle.io.geo.coordinate_systems import local_frame
from raybundle.placing.marks import Given, ScaleBar
from raybundle.planning.simulate import Survey, simulate
from raybundle.planning.synthetic_networks import TargetField, field_scene
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


def remark_codes(control):
    return {m.code for r in control.remarks for m in r.messages}


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
    assert control.remarks[0].messages[0].code == "control_file.heights_unknown"
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
    assert control.remarks[0].messages[0].code == "control_file.no_names"


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
    "empty": (GCP, "", 1, None, r"gcp_list\.empty"),
    "no system": ("EPSG:32611\n", "", 2, None, r"gcp_list\.no_system"),
    "unknown system": ("EPSG:32611", "UTM eleven", 2, None, r"gcp_list\.no_system"),
    "only a system": (GCP[GCP.index("235") :], "", 2, None, r"gcp_list\.no_point"),
    "few columns": (" IMG_0121.jpg", "", 4, None, r"5.*gcp_list\.too_few_columns"),
    "text": ("294.84", "29a.84", 4, "x_px", r"value\.not_finite"),
    "comma": ("294.84", "294,84", 4, "x_px", r"table\.two_decimal_signs"),
    "infinite": ("3811203.5", "inf", 7, "Y", r"value\.not_finite"),
    "underscore": ("3811203.5", "3_8", 7, "Y", r"value\.not_finite"),
    "twice": (
        "IMG_0121.jpg",
        "IMG_0052.jpg\n235269.88 3811198.11 12.5 3 4 IMG_0052.jpg",
        5,
        "image",
        r"4.*table\.pair_twice",
    ),
    "some names": ("IMG_0052.jpg", "IMG_0052.jpg p2", 3, "name", r"gcp_list\.name_missing"),
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
    with pytest.raises(InputError, match=r"3.*gcp_list\.coordinates_differ") as caught:
        read_control(write(tmp_path, text))
    assert (caught.value.line, caught.value.column) == (7, "X")


def test_bytes_that_are_no_text(tmp_path):
    path = tmp_path / "gcp_list.txt"
    path.write_bytes(b"EPSG:32611\n\xff\xfe")  # UTF-16
    with refused("file.not_utf8", line=2):
        read_control(path)
    with pytest.raises(InputError, match=r"file\.missing"):
        read_control(tmp_path / "nothing.txt")


def test_a_list_with_decimal_commas(tmp_path):
    plain = read_control(write(tmp_path, GCP))
    path = tmp_path / "gcp_list.txt"
    path.write_bytes(re.sub(r"(?<=[0-9])\.(?=[0-9])", ",", GCP.replace("IMG 37", "Süd 37")).encode("cp1252"))
    commas = read_control(path)
    np.testing.assert_array_equal(commas.xyz, plain.xyz)
    np.testing.assert_array_equal(commas.measurements.xy_px, plain.measurements.xy_px)
    assert commas.measurements.image[0] == "Süd 37.jpg"


def test_a_table_saved_as_text_is_one(tmp_path):
    path = write(tmp_path, CSV.replace(",", "\t"), "control.txt")
    np.testing.assert_array_equal(read_control(path).xyz, read_control(write(tmp_path, CSV, "control.csv")).xyz)


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
    assert control.remarks[0].messages[0].values["plan"] == 0.1


CSV_CASES = {
    "role": ("control.csv", "check", "checked", 3, "role", r"value\.not_supported"),
    "sigma": ("control.csv", ",,,check", ",,1,check", 3, "sZ", r"point\.sigma_without_coordinate"),
    "nothing": ("control.csv", "b,4,5,", "b,,,", 3, "X", r"control\.no_coordinate"),
    "negative": ("control.csv", "0.01", "-0.01", 2, "sZ", r"cell\.negative_sigma"),
    "point": ("m.csv", "2.jpg,b", "2.jpg,c", 4, "point", r"cell\.unknown_id"),
    "twice": ("m.csv", "2.jpg,a", "1.jpg,a", 3, "point", r"2.*table\.pair_twice"),
    "pixel": ("m.csv", "40.5", "", 3, "y_px", r"cell\.empty"),
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
    with pytest.raises(InputError, match=r"control\.own_measurements"):
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
    with pytest.raises(InputError, match=r"control\.none_in_block"):
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
    assert ("control_file.heights_unknown" in remark_codes(control)) != believed


def test_control_and_check_points_without_names_have_names_of_their_own(tmp_path):
    """And one name in two files is refused before anything is computed."""
    lines = "EPSG:32633\n500000 5000000 10 5 6 a.jpg\n500010 5000000 11 5 6 a.jpg\n"
    first, second = write(tmp_path, lines, "control.txt"), write(tmp_path, lines, "check.txt")
    control, check = read_control(first), read_control(second, defaults=ControlDefaults(role="check"))
    assert control.ids == ("gcp00", "gcp01")
    assert check.ids == ("check00", "check01")
    assert "check00" in check.remarks[0]
    assert Given(control=(control, check)).control == (control, check)
    with pytest.raises(InputError, match=r"gcp00.*control\.txt.*control\.point_twice") as caught:
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

    monkeypatch.setattr("raybundle.workflows.orienting.stages.features.find_features", computed)
    told = {
        "mark": r"900, 6 .*a\.jpg.*mark\.outside_photograph", "bar": r"point two .*scale_bar\.end_not_measured",
        "set": r"IMG_1\.JPG.*a\.jpg.*b\.jpg.*control\.other_photographs",
    }  # fmt: skip
    with pytest.raises(InputError, match=told[wrong]):
        workflow.orient([photos], tmp_path / "project", given=Given(control=(control,), scale_bars=bars))


def test_marks_alone_are_points_of_which_nothing_is_given(tmp_path):
    (tmp_path / "marks.csv").write_text("image,point,x_px,y_px\n1.jpg,A,10.5,20\n2.jpg,A,11,21\n1.jpg,B,30,40\n")
    control = read_control(tmp_path / "marks.csv")
    assert control.ids == ("A", "B")
    assert (control.role == Role.TIE).all()
    assert np.isnan(control.xyz).all()
    assert control.measurements.image == ("1.jpg", "2.jpg", "1.jpg")
    (tmp_path / "marks.csv").write_text("image,point,x_px,y_px\n1.jpg,A,10.5,20\n1.jpg,A,11,21\n")
    with pytest.raises(InputError, match=r"3.*table\.pair_twice"):
        read_control(tmp_path / "marks.csv")


@pytest.mark.parametrize(("east", "told"), [(500_010.0, False), (310.0, True)])
def test_a_file_without_a_system_stands_in_that_of_the_others(tmp_path, east, told):
    (tmp_path / "list.txt").write_text(
        "EPSG:32633\n500000 5300000 300 1 1 1.jpg A\n500100 5300000 301 2 2 1.jpg B\n500000 5300080 300 3 3 1.jpg C\n"
    )
    (tmp_path / "checks.csv").write_text(f"point,X,Y,Z\nK,{east},5300010,300\n")
    first, second = in_one_system([read_control(tmp_path / n) for n in ("list.txt", "checks.csv")])
    assert first.crs == second.crs == "EPSG:32633"
    assert ("control_file.system_of_others" in remark_codes(second)) == told
    (alone,) = in_one_system([read_control(tmp_path / "checks.csv")])
    assert alone.crs is None


def test_the_system_that_the_user_names_is_that_of_a_file_that_names_none(tmp_path):
    foot = 1200 / 3937
    (tmp_path / "c.csv").write_text(
        "point,X,Y,Z,sX,sY,sZ\nA,985000,195000,100,0.03,0.03,0.06\nB,985300,195000,101,,,\nC,985000,195400,104,0,0,0\n"
    )
    given = ControlDefaults(plan=0.01, height=0.02, unit="m")
    (taken,) = in_one_system([read_control(tmp_path / "c.csv", defaults=given)], "EPSG:2263")
    assert taken.crs == "EPSG:2263"
    [system] = [m for r in taken.remarks for m in r.messages if m.code == "control_file.system_given"]
    assert (system.values["name"], system.values["system"]) == ("c.csv", "EPSG:2263")
    [assumed] = [m for r in taken.remarks for m in r.messages if m.code == "control_file.sigma_assumed"]
    assert assumed.values == {"plan": 0.01, "height": 0.02, "unit": "m"}
    sigma = sigma_in_metres(taken)
    np.testing.assert_allclose(sigma[0], np.array([0.03, 0.03, 0.06]) * foot)  # stated in feet
    np.testing.assert_allclose(sigma[1], [0.01, 0.01, 0.02])  # assumed, in metres
    np.testing.assert_array_equal(sigma[2], 0)
    (bare,) = in_one_system([read_control(tmp_path / "c.csv")])
    assert bare.crs is None
    assert "control_file.cartesian_assumed" in remark_codes(bare)


@pytest.mark.parametrize(
    ("xy", "degrees"),
    [
        ([(8.541200, 47.371200), (8.541900, 47.371800), (8.542500, 47.370900)], True),
        ([(47.371200, 8.541200), (47.371800, 8.541900)], True),
        ([(-70.66, -33.45), (-70.665, -33.448)], True),
        ([(0.12345, 0.05432), (0.22345, 0.15432)], False),  # a part, metres
        ([(100.0, 50.0), (100.2, 50.1)], False),  # axes with a false origin
        ([(985000, 195000), (985300, 195400)], False),
        ([(8.5412, 47.3712)], False),  # one place proves nothing
    ],
)
def test_longitude_and_latitude_without_a_system_are_refused(tmp_path, xy, degrees):
    rows = "".join(f"P{k},{x},{y},400\n" for k, (x, y) in enumerate(xy))
    (tmp_path / "c.csv").write_text(f"point,X,Y,Z\n{rows}")
    read = read_control(tmp_path / "c.csv")
    if not degrees:
        check_degrees(in_one_system([read]))
        return
    with pytest.raises(InputError, match="longitude and latitude") as caught:
        check_degrees(in_one_system([read]))
    assert caught.value.code == "control_file.degrees"
    check_degrees(in_one_system([read], "EPSG:4979"))


def test_standard_deviations_of_degrees_are_metres(tmp_path):
    (tmp_path / "c.csv").write_text("point,X,Y,Z,sX,sY,sZ\nA,15.0,48.0,300,0.02,0.02,0.03\n")
    (taken,) = in_one_system([read_control(tmp_path / "c.csv")], "EPSG:4979")
    np.testing.assert_allclose(sigma_in_metres(taken)[0], [0.02, 0.02, 0.03])


@pytest.mark.parametrize(
    ("crs", "place"), [("EPSG:2263", "12.0,20.0"), ("EPSG:32633", "12.0,20.0"), ("EPSG:32633", "985000,195000")]
)
def test_coordinates_outside_the_area_of_the_named_system_are_refused(tmp_path, crs, place):
    (tmp_path / "c.csv").write_text(f"point,X,Y,Z\nA,{place},3\n")
    with pytest.raises(InputError, match=r"crs\.outside_area"):
        in_one_system([read_control(tmp_path / "c.csv")], crs)


def test_a_grid_is_taken_a_little_beyond_its_zone(tmp_path):
    east = local_frame("EPSG:32632", (700_000.0, 5_400_000.0, 0.0)).wgs84_from_local(np.zeros((1, 3)))[0]
    assert east[0] > 11.7
    (tmp_path / "c.csv").write_text("point,X,Y,Z\nA,250000,5400000,3\n")  # 11.6 degrees, of zone 32, in zone 33
    (taken,) = in_one_system([read_control(tmp_path / "c.csv")], "EPSG:32633")
    assert taken.crs == "EPSG:32633"


def test_the_named_system_tells_the_heights_of_files_in_the_same_plan(tmp_path):
    (tmp_path / "list.txt").write_text("EPSG:32633\n500000 5300000 300 1 1 1.jpg A\n")
    (tmp_path / "checks.csv").write_text("point,X,Y,Z\nK,500010,5300010,300\n")
    files = [read_control(tmp_path / n) for n in ("list.txt", "checks.csv")]
    assert {c.crs for c in in_one_system(files, "EPSG:32633+ellipsoid")} == {"EPSG:32633+ellipsoid"}
    assert {c.crs for c in in_one_system(files, "EPSG:32632+ellipsoid")} == {"EPSG:32633"}


BEHIND = {  # words behind the image; names of the points, and what a remark names
    "g1": ("g1", None),
    "corner one": ("corner", ("'one'", "'corner'", 2)),
    "g1 extra1 extra2": ("g1", ("'extra1 extra2'", "'g1'", 2)),
    "g1 0.02 0.03": ("g1", ("'0.02 0.03'", "'g1'", 2)),
    "north corner of wall": ("north", ("'corner of wall'", "'north'", 2)),
    "g.1": ("g.1", None),
}


@pytest.mark.parametrize("words", BEHIND)
def test_words_behind_the_names_of_points(tmp_path, words):
    path = tmp_path / "gcp_list.txt"
    name, remark = BEHIND[words]
    path.write_text(
        f"EPSG:32633\n500010.5 5400020.25 123.5 10 20 a.jpg {words}\n500110.5 5400020.25 124 10 20 b.jpg h\n"
    )
    found = read_control(path)
    assert found.ids == (name, "h")
    values = [r.messages[0].values for r in found.remarks]
    assert [(v["words"], v["point"], v["line_number"]) for v in values] == [remark] * bool(remark)
    path.write_text(f"EPSG:32633\n500010.5\t5400020.25\t123.5\t10\t20\ta.jpg\t{words}\n")
    assert read_control(path).ids == (words,)
    assert read_control(path).remarks == ()
