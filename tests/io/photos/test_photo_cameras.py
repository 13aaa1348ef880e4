"""Which photographs share an interior orientation, and where its camera constant starts."""

import math
from dataclasses import replace
from pathlib import Path

import pytest
from tests.conftest import DATA

from raybundle.adjustment.records.severity import Severity
from raybundle.block import Camera
from raybundle.block.known import known_before
from raybundle.errors import InputError, code_of, phrase
from raybundle.io.photos.cameras import camera_groups, camera_of, may_share_sensor, with_calibration, with_what_is_known
from raybundle.io.photos.metadata import Metadata
from raybundle.io.photos.photo import Photo, find_photos
from raybundle.io.photos.start import starting_value, stated_projection
from raybundle.placing.recorded_positions import camera_notices
from raybundle.sensors import sensor_models

BODY = Metadata(make="Canon", model="Canon EOS 5D Mark II", focal_mm=24.0)


def photo(name="a.jpg", width=5616, height=3744, metadata=BODY, **more):
    values = {"path": Path(name), "name": name, "width_px": width, "height_px": height, "sha256": name}
    return Photo(**values, metadata=metadata, **more)


def stored(id_, width=5616, height=3744, c=25.0):
    values = dict.fromkeys(sensor_models["brown"].symbols, 0.0) | {"c": c}
    return Camera(id=id_, model="brown", width_px=width, height_px=height, pixel_mm=(0.00641, 0.00641), values=values)


# ---- groups


def test_a_camera_on_its_side_is_the_same_camera():
    (group,) = camera_groups([photo(), photo("b.jpg", orientation=6), photo("c.jpg", orientation=8)])
    assert group.photos == (0, 1, 2)
    assert (group.width_px, group.height_px) == (5616, 3744)


@pytest.mark.parametrize(
    "change",
    [
        {"make": "Other"},
        {"model": "Other"},
        {"serial": "7"},
        {"lens": "macro"},
        {"focal_mm": 35.0},
        {"zoom_ratio": 2.0},
    ],
)
def test_what_tells_cameras_apart(change):
    full = replace(BODY, serial="1", lens="EF 24")
    photos = [photo(n, metadata=replace(full, **(change if n == "b.jpg" else {}))) for n in ("a.jpg", "b.jpg", "c.jpg")]
    groups = camera_groups(photos)
    assert [g.photos for g in groups] == [(0, 2), (1,)]
    assert len({g.id for g in groups}) == 2


def test_another_size_is_another_camera_and_one_without_metadata_is_named():
    groups = camera_groups([photo(), photo("b.jpg", 2808, 1872), photo("c.jpg", metadata=Metadata())])
    assert [g.id for g in groups] == ["canon-eos-5d-mark-ii-24mm", "canon-eos-5d-mark-ii-24mm-2808x1872", "5616x3744"]
    assert "another source" in groups[2].remarks[-1]


def test_photographs_turned_by_a_program_are_apart_until_they_are_measured_and_may_be_of_one_sensor():
    upright = photo("b.jpg", 3744, 5616)
    groups = camera_groups([photo(), upright])
    assert len(groups) == 2
    assert groups[0].c_px == pytest.approx(groups[1].c_px)
    assert may_share_sensor(photo(), upright)


def values_of(start, code):
    """Values of the one remark of a code."""
    (found,) = [r.message.values for r in start.remarks if code_of(r) == code]
    return found


@pytest.mark.parametrize("field", ["lens", "serial"])
@pytest.mark.parametrize("many", [True, False])
def test_a_lens_or_number_that_some_photographs_do_not_state_makes_no_second_camera(field, many):
    stated = replace(BODY, **{field: "EF 24"})
    few, others = (stated, BODY) if many else (BODY, stated)
    (group,) = camera_groups([photo("a.jpg", metadata=few), *(photo(f"{k}.jpg", metadata=others) for k in range(3))])
    assert group.photos == (0, 1, 2, 3)
    (told,) = group.joined
    assert code_of(told) == "camera_start.one_camera"
    values = told.message.values
    assert (values["first"], values["n"], values["others"], values["stated"]) == ("a.jpg", 1, 3, many)
    assert (values["lens"], values["serial"]) == (("EF 24", "") if field == "lens" else ("", "EF 24"))


def test_what_two_lenses_or_bodies_leave_unstated_joins_neither():
    names = [photo("a.jpg", metadata=replace(BODY, lens=lens)) for lens in ("", "EF 24", "TS-E 24")]
    assert len(camera_groups(names)) == 3
    assert len(camera_groups([photo("a.jpg", metadata=Metadata()), photo("b.jpg", metadata=BODY)])) == 2
    without_focal = replace(BODY, focal_mm=None)
    assert len(camera_groups([photo(metadata=without_focal), photo(metadata=replace(without_focal, lens="a"))])) == 2


@pytest.mark.parametrize(
    ("change", "may"),
    [
        ({}, True),
        ({"lens": "24"}, True),
        ({"serial": "2"}, False),
        ({"focal_mm": 35.0}, False),
        ({"model": "X"}, False),
    ],
)
def test_what_speaks_against_one_sensor(change, may):
    one = photo(metadata=replace(BODY, serial="1"))
    assert may_share_sensor(one, photo("b.jpg", 3744, 5616, metadata=replace(one.metadata, **change))) is may


def test_a_zoom_lens_is_remarked():
    zoom = replace(BODY, focal_range_mm=(24.0, 70.0))
    (group,) = camera_groups([photo(metadata=zoom), photo("b.jpg", metadata=zoom)])
    assert "24 to 70 mm" in group.remarks[-1]


def test_the_camera_of_a_group_is_a_brown_camera_with_the_starting_value():
    (group,) = camera_groups([photo()])
    camera = camera_of(group)
    assert (camera.model, camera.width_px, camera.values["c"]) == ("brown", 5616, 24.0)
    assert set(camera.values) == set(sensor_models["brown"].symbols)
    assert camera.pixel_mm[0] == pytest.approx(36 / 5616)


# ---- stored calibrations


def test_a_stored_calibration_is_taken_by_format():
    (group,) = camera_groups([photo()], [stored("mine")])
    assert group.source == phrase("camera_start.stored", camera="mine")
    assert (group.c_mm, group.sigma_c_mm) == (25.0, 0.0)
    assert camera_of(group).values["c"] == 25.0
    assert camera_of(group).id == group.id


def test_a_stored_calibration_is_taken_by_name_where_two_fit():
    photos = [photo(metadata=replace(BODY, serial="1")), photo("b.jpg", metadata=replace(BODY, serial="7"))]
    with pytest.raises(InputError, match=r"2.*calibration\.several_cameras"):
        camera_groups(photos, [stored("mine")])
    names = [g.id for g in camera_groups(photos)]
    groups = camera_groups(photos, [stored(names[1])])
    assert [g.stored is not None for g in groups] == [False, True]


def test_a_stored_calibration_that_fits_nothing_is_an_error():
    with pytest.raises(InputError, match=r"calibration\.format_differs"):
        camera_groups([photo()], [stored("mine", 100, 100)])
    with pytest.raises(InputError, match=r"calibration\.two_for_camera"):
        camera_groups([photo()], [stored("mine"), stored("yours")])


def test_a_stored_calibration_far_from_the_metadata_is_remarked():
    (group,) = camera_groups([photo()], [stored("mine", c=50.0)])
    assert code_of(group.remarks[0]) == "camera_start.calibration_differs"
    (notice,) = camera_notices([group])
    assert "7\u202f800" in notice.text.replace(" ", "\u202f")
    assert notice.severity is Severity.WARNING
    plain = replace(group, stored=None)
    assert [n.severity for n in camera_notices([plain])] == [Severity.NOTE]


# ---- starting values


def px(metadata, width, height):
    start = starting_value(metadata, width, height)
    return start.c_mm / start.pixel_mm, start


def test_the_order_of_sources():
    steps = {
        "XMP calibration": {"xmp": {"drone-dji:CalibratedFocalLength": "4625.0"}},
        "focal plane resolution": {"focal_plane_px_per_mm": (156.0, 156.0)},
        "sensor size table": {"make": "Canon", "model": "Canon EOS 5D Mark II"},
        "35 mm equivalent": {"focal35_mm": 30.0},
        "default: 1.2 times the longer side": {},
    }
    names = list(steps)
    sigmas = []
    for k, name in enumerate(names):
        fields = {key: v for n in names[k:] for key, v in steps[n].items()}
        c, start = px(Metadata(focal_mm=30.0, **fields), 5616, 3744)
        assert start.source == name
        assert abs(c / 4680 - 1) < 2 * start.sigma
        sigmas.append(start.sigma)
    assert sigmas == sorted(sigmas)


def test_a_focal_plane_width_that_contradicts_the_body_gives_way():
    wrong = replace(BODY, focal_plane_px_per_mm=(3849.21 / 25.4, 3908.14 / 25.4))
    c, start = px(wrong, 5616, 3744)
    assert c == pytest.approx(24 * 5616 / 36.0)
    assert values_of(start, "camera_start.table_taken") == pytest.approx({"plane_mm": 36.78, "table_mm": 36}, abs=0.01)


def test_a_focal_plane_that_is_too_wide_by_a_millimetre_gives_way():
    """5616 px at a resolution that makes them 37.06 mm; the body is 36.0 mm wide."""
    wrong = replace(BODY, focal_plane_px_per_mm=(5616 / 37.06, 5616 / 37.06))
    c, start = px(wrong, 5616, 3744)
    assert 24 * 5616 / c == pytest.approx(36.0, abs=0.2)
    assert values_of(start, "camera_start.table_taken") == pytest.approx({"plane_mm": 37.06, "table_mm": 36}, abs=0.01)


def test_a_reduced_copy_keeps_the_sensor():
    small = replace(BODY, focal_plane_px_per_mm=(156.0, 156.0), exif_width=5616, exif_height=3744)
    c, start = px(small, 1404, 936)
    assert c == pytest.approx(24 * 156 / 4)
    assert values_of(start, "camera_start.copy")["ratio"] == 4
    turned, _ = px(small, 936, 1404)
    assert turned == pytest.approx(c)


def test_a_cut_copy_keeps_the_scale_with_a_large_sigma():
    cut = replace(BODY, exif_width=5616, exif_height=3744)
    c, start = px(cut, 3000, 3000)
    assert c == pytest.approx(3744)
    assert start.sigma > 0.1
    assert code_of(start.remarks[0]) == "camera_start.cropped"


def test_the_equivalent_is_taken_by_the_diagonal():
    c, _ = px(Metadata(focal_mm=4.25, focal35_mm=26.0), 4032, 3024)
    assert c == pytest.approx(26 * 5040 / 43.2666, rel=1e-5)
    without, start = px(Metadata(focal35_mm=26.0), 4032, 3024)
    assert without == pytest.approx(c)
    assert start.source == "35 mm equivalent"


def test_digital_zoom_and_near_focus():
    c, start = px(replace(BODY, zoom_ratio=2.0), 5616, 3744)
    assert c == pytest.approx(2 * 3744)
    near = starting_value(replace(BODY, focal_mm=100.0, subject_distance_m=0.5), 5616, 3744)
    assert near.sigma > 0.2
    assert values_of(near, "camera_start.focused")["distance_m"] == 0.5
    assert values_of(start, "camera_start.digital_zoom") == {"zoom": 2.0}


def test_xmp_that_cannot_be_meant_is_left_out():
    c, start = px(replace(BODY, xmp={"drone-dji:CalibratedFocalLength": "9000"}), 5616, 3744)
    assert c == pytest.approx(3744)
    assert values_of(start, "camera_start.xmp_contradicts") == {"c_px": 9000, "expected_px": 3744}


@pytest.mark.parametrize(
    ("entry", "told"),
    [
        ({"DewarpData": "2024-01-31;abc,3651.2,-10.5,4.2,-0.27,0.11,0.0001,0,-0.03"}, ("no_number", "'abc'")),
        ({"DewarpData": "none"}, ("dewarp_data", "'none'")),
        ({"DewarpData": "2024-01-31;3.6,3651.2,-10.5,4.2,-0.27,0.11,0.0001,0,-0.03"}, ("no_constant", "'3.6'")),
        ({"CalibratedFocalLength": "long"}, ("no_number", "'long'")),
    ],
)
def test_xmp_that_cannot_be_read_is_remarked(entry, told):
    plain, _ = px(BODY, 5616, 3744)
    c, start = px(replace(BODY, xmp={f"drone-dji:{k}": v for k, v in entry.items()}), 5616, 3744)
    assert c == plain
    code, value = told
    assert values_of(start, f"camera_start.{code}")["value"] == value


@pytest.mark.parametrize("focal", [None, 1e9])
@pytest.mark.parametrize("equivalent", [1.0, 5000.0, 65535.0])
def test_an_equivalent_that_no_lens_has_is_not_taken(focal, equivalent):
    c, start = px(Metadata(focal_mm=focal, focal35_mm=equivalent), 640, 480)
    plain, _ = px(Metadata(focal_mm=focal), 640, 480)
    assert c == plain == pytest.approx(1.2 * 640)
    assert values_of(start, "camera_start.equivalent_impossible")["equivalent_mm"] == equivalent


def test_a_panorama_is_remarked():
    (stated,) = stated_projection(Metadata(xmp={"GPano:ProjectionType": "equirectangular"})).messages
    assert (stated.code, stated.values["kind"]) == ("camera_start.panorama", "equirectangular")
    assert stated_projection(Metadata()) == ""
    (group,) = camera_groups([photo(metadata=replace(BODY, xmp={"GPano:ProjectionType": "equirectangular"}))])
    assert group.stated[0] == group.projection  # as `photos` and the report print it
    assert next(n.code for n in camera_notices([group])) == "camera_projection"
    assert with_calibration(group, stored("mine")).stated == ()


@pytest.mark.parametrize(("folder", "count", "truth_px"), [("sceaux-castle", 11, 2905.88), ("copr-uav", 41, 2843.0)])
def test_public_sets_start_within_their_sigma(folder, count, truth_px):
    images = DATA / "photos" / folder / "images"
    if not images.is_dir():
        pytest.skip("no public data: set RAYBUNDLE_DATA to the folder that holds photos/")
    found = find_photos([images])
    (group,) = camera_groups(found.photos)
    assert len(group.photos) == count
    assert abs(group.c_px - truth_px) < group.sigma_c_px
    assert group.sigma_c_px < 0.03 * truth_px


def test_patterns_of_names_take_cameras_apart():
    names = ("left_1.jpg", "right_1.jpg", "left_2.jpg", "right_2.jpg", "other.jpg")
    groups = camera_groups([photo(n) for n in names], (), ("left_*", "right_*"))
    assert [g.photos for g in groups] == [(0, 2), (1, 3), (4,)]
    listed = camera_groups([photo(n) for n in names], (), ("left_1.jpg|right_2.jpg",))
    assert [g.photos for g in listed] == [(0, 3), (1, 2, 4)]
    with pytest.raises(InputError, match=r"camera\.pattern_without_photograph"):
        camera_groups([photo("left_1.jpg")], (), ("up_*",))
    with pytest.raises(InputError, match=r"camera\.two_patterns"):
        camera_groups([photo("left_1.jpg")], (), ("left_*", "*_1.jpg"))


# ---- what is known before


@pytest.mark.parametrize(
    ("metadata", "c", "centre"),
    [
        (BODY, 0.05, 0.02),  # a nominal focal length
        (Metadata(), 0.5, 0.05),  # nothing: by a factor, and it may be cropped
        (replace(BODY, exif_width=5616, exif_height=3744), 0.05, 0.02),
        (replace(BODY, exif_width=5616, exif_height=4744), None, (0.02**2 + (1000 / 5616) ** 2 / 12) ** 0.5),
    ],
)
def test_what_is_known_of_a_camera_without_a_calibration(metadata, c, centre):
    (group,) = camera_groups([photo(metadata=metadata)])
    camera = with_what_is_known(camera_of(group), group)
    known, side = known_before(camera), 5616 * camera.pixel_mm[0]
    assert known["x0"].sigma == known["y0"].sigma == pytest.approx(centre * side)
    assert known["x0"].observed == 0
    assert known["c"].logarithm
    assert known["c"].observed == pytest.approx(math.log(group.c_mm))
    if c is not None:
        assert known["c"].sigma == pytest.approx(c)
    assert camera.known == camera.values
