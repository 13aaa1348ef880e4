"""Metashape: components, rigs, spheres, markers with coordinates, elements with errors, and the ledger."""

from dataclasses import replace

import numpy as np
import pytest

from raybundle.block import Role
from raybundle.errors import InputError
from raybundle.io.formats import Export, read_format, write_format
from raybundle.planning.simulate import Survey, simulate
from raybundle.planning.synthetic_networks import TargetField, field_scene

R = np.array([[0.36, 0.48, -0.8], [-0.8, 0.6, 0.0], [0.48, 0.64, 0.6]])
T = np.array([100.0, 200.0, 30.0])
SCALE = 4.0
CENTRES = {"0": (0.0, 0.0, 2.0), "1": (0.5, 0.1, 2.0), "2": (1.0, 0.2, 2.0)}
TRANSFORM = (
    f"<transform><rotation>{' '.join(map(str, R.ravel()))}</rotation>"
    f"<translation>100 200 30</translation><scale>{SCALE}</scale></transform>"
)
LOCAL = 'LOCAL_CS["Local Coordinates (m)",LOCAL_DATUM["Local Datum",0],UNIT["metre",1]]'
CALIBRATION = (
    '<calibration type="frame" class="adjusted"><resolution width="4000" height="3000"/><f>3550</f></calibration>'
)
SENSOR = f'<sensor id="0" label="X" type="frame"><resolution width="4000" height="3000"/>{CALIBRATION}</sensor>'


def transform(centre):
    M = np.diag([1.0, -1.0, -1.0, 1.0])
    M[:3, 3] = centre
    return f"<transform>{' '.join(map(str, M.ravel()))}</transform>"


def camera(id_, words="", inner=""):
    return f'<camera id="{id_}" sensor_id="0" label="IMG_{id_}" {words}>{transform(CENTRES[id_])}{inner}</camera>'


def cameras(words="", inner=""):
    return "".join(camera(k, words, inner) for k in CENTRES)


def read(tmp_path, *, sensors=SENSOR, shots=None, chunk=TRANSFORM, reference=LOCAL):
    text = (
        f'<document version="2.0.0"><chunk><sensors>{sensors}</sensors><cameras>{shots or cameras()}</cameras>'
        f"<reference>{reference}</reference>{chunk}</chunk></document>"
    )
    path = tmp_path / "cameras.xml"
    path.write_text(text)
    return read_format("metashape", path)


def placed(point):
    return SCALE * R @ np.array(point) + T


EXPECTED = np.array([placed(c) for c in CENTRES.values()])


def component(id_, inner="", members=""):
    listed = f"<partition><camera_ids>{members}</camera_ids></partition>" if members else ""
    return f'<component id="{id_}">{inner}{listed}</component>'


COMPONENTS = {
    "by attribute": (f"<components>{component(0, TRANSFORM)}</components>", 'component_id="0"'),
    "by list": (f"<components>{component(0, TRANSFORM, '0 1 2')}</components>", ""),
    "only one": (f"<components>{component(0, TRANSFORM)}</components>", ""),
    "other number": (f"<components>{component(7, TRANSFORM)}</components>", 'component_id="7"'),
    "unknown number": (f"<components>{component(7, TRANSFORM)}</components>", 'component_id="8"'),
    "before that of the chunk": (
        f"<components>{component(0, TRANSFORM)}</components><transform><scale>9</scale></transform>",
        'component_id="0"',
    ),
    "of the chunk": (f"<components>{component(0)}</components>{TRANSFORM}", 'component_id="0"'),
    "no components": (TRANSFORM, ""),
    "no component in the list": (f"<components/>{TRANSFORM}", ""),
    "two, one listed": (f"<components>{component(0, TRANSFORM, '0 1 2')}{component(1)}</components>", ""),
}


@pytest.mark.parametrize("case", COMPONENTS.values(), ids=COMPONENTS)
def test_the_transform_of_the_component_leads_to_object_space(case, tmp_path):
    chunk, words = case
    found = read(tmp_path, chunk=chunk, shots=cameras(words))
    np.testing.assert_allclose(found.block.images.centre, EXPECTED, atol=1e-9)
    assert not found.block.free_scale
    assert found.unread == {}


def test_components_with_different_transforms_each_use_their_own(tmp_path):
    other = "<transform><scale>2</scale></transform>"
    chunk = f"<components>{component(0, TRANSFORM, '0 1')}{component(1, other, '2')}</components>"
    found = read(tmp_path, chunk=chunk)
    np.testing.assert_allclose(found.block.images.centre, [EXPECTED[0], EXPECTED[1], (2.0, 0.4, 4.0)], atol=1e-9)


@pytest.mark.parametrize("other", ["", TRANSFORM])
def test_images_of_a_component_without_transform_have_no_orientation_beside_others(other, tmp_path):
    chunk = f"<components>{component(0, other, '0 1')}{component(1, '', '2')}</components>"
    found = read(tmp_path, chunk=chunk)
    assert found.block.images.oriented.tolist() == [True, True, False]
    assert found.block.free_scale == (not other)
    assert any((r.code, r.values.get("n")) == ("import.components_apart", 1) for r in found.remarks)


@pytest.mark.parametrize("chunk", ["", f"<components>{component(0)}</components>"])
def test_without_a_transform_the_scale_is_free_and_no_map_is_written(chunk, tmp_path):
    found = read(tmp_path, chunk=chunk)
    assert found.block.free_scale
    with pytest.raises(InputError, match=r"format\.free_scale"):
        write_format("geojson", Export(block=found.block, frame=FRAME), tmp_path / "a.geojson")


def frame():
    from raybundle.io.geo.coordinate_systems import local_frame

    return local_frame("EPSG:32633", (500_000.0, 5_300_000.0, 300.0))


FRAME = frame()

QUARTER = np.array([[0.0, -1, 0], [1, 0, 0], [0, 0, 1]])
MOUNTINGS = {
    "shifted": (np.eye(3), (0.1, 0.0, 0.0)),
    "turned": (QUARTER, (0.0, 0.0, 0.0)),
    "both": (QUARTER, (0.1, -0.2, 0.3)),
    "neither": (np.eye(3), (0.0, 0.0, 0.0)),
    "far": (R, (1.0, 2.0, 3.0)),
}


@pytest.mark.parametrize("case", MOUNTINGS.values(), ids=MOUNTINGS)
@pytest.mark.parametrize("where", ["component", "chunk"])
def test_slaves_of_a_rig_follow_their_masters(case, where, tmp_path):
    rotation, location = case
    slave = (
        f'<sensor id="1" label="S" type="frame" master_id="0">'
        f"<rotation>{' '.join(map(str, rotation.ravel()))}</rotation>"
        f"<location>{' '.join(map(str, location))}</location>{CALIBRATION}</sensor>"
    )
    inside = f"<components>{component(0, TRANSFORM, '0 1 2')}{component(1, '', '9')}</components>"
    shots = cameras() + "".join(f'<camera id="1{k}" sensor_id="1" master_id="{k}" label="S_{k}"/>' for k in CENTRES)
    found = read(tmp_path, sensors=SENSOR + slave, shots=shots, chunk=inside if where == "component" else TRANSFORM)
    images = found.block.images
    axes = np.diag([1.0, -1.0, -1.0])
    for k, centre in enumerate(CENTRES.values()):
        np.testing.assert_allclose(images.centre[3 + k], placed(np.array(centre) + axes @ location), atol=1e-9)
        expected = axes @ (axes @ rotation).T @ R.T
        np.testing.assert_allclose(images.rotation[3 + k], expected, atol=1e-9)
    assert found.unread == {}


@pytest.mark.parametrize("sensor", ['<sensor id="1" master_id="0">{}</sensor>', '<sensor id="1">{}</sensor>'])
def test_a_slave_without_mounting_has_no_orientation(sensor, tmp_path):
    shots = cameras() + '<camera id="9" sensor_id="1" master_id="0" label="S"/>'
    found = read(tmp_path, sensors=SENSOR + sensor.format(CALIBRATION), shots=shots)
    assert found.block.images.oriented.tolist() == [True] * 3 + [False]


@pytest.mark.parametrize("size", [(5760, 2880), (1000, 500), (4000, 1000), (101, 50)])
def test_a_spherical_sensor_needs_no_calibration(size, tmp_path):
    sensor = f'<sensor id="0" type="spherical"><resolution width="{size[0]}" height="{size[1]}"/></sensor>'
    found = read(tmp_path, sensors=sensor).block.cameras[0]
    assert found.model == "spherical"
    assert found.values["c"] * 2 * np.pi == pytest.approx(size[0] * found.pixel_mm[0])
    assert found.pixel_mm[0] == found.pixel_mm[1]


@pytest.mark.parametrize("kind", ["cylindrical", "rpc", "", "Frame"])
def test_other_sensors_cost_their_images_alone(kind, tmp_path):
    sensor = f'<sensor id="1" type="{kind}"><resolution width="100" height="50"/></sensor>'
    shots = cameras() + f'<camera id="9" sensor_id="1" label="P">{transform((0, 0, 1))}</camera>'
    found = read(tmp_path, sensors=SENSOR + sensor, shots=shots)
    assert found.block.images.ids == ("IMG_0", "IMG_1", "IMG_2")
    assert [d.code for r in found.remarks if r.values.get("kind") == "sensor" for d in r.details] == [
        "value.not_supported"
    ]
    with pytest.raises(InputError, match=r"value\.not_supported"):
        read(tmp_path, sensors=sensor.replace('id="1"', 'id="0"'))


BAD = {
    "no label": f'<camera id="9" sensor_id="0">{transform((0, 0, 1))}</camera>',
    "empty label": f'<camera id="9" sensor_id="0" label="">{transform((0, 0, 1))}</camera>',
    "blank label": f'<camera id="9" sensor_id="0" label=" ">{transform((0, 0, 1))}</camera>',
    "label twice": f'<camera id="9" sensor_id="0" label="IMG_1">{transform((0, 0, 1))}</camera>',
    "no sensor": f'<camera id="9" label="P">{transform((0, 0, 1))}</camera>',
}


@pytest.mark.parametrize("bad", BAD.values(), ids=BAD)
@pytest.mark.parametrize("last", [True, False])
def test_a_camera_with_an_error_costs_itself_alone(bad, last, tmp_path):
    found = read(tmp_path, shots=cameras() + bad if last else bad.replace("IMG_1", "") + cameras())
    assert found.block.images.ids == ("IMG_0", "IMG_1", "IMG_2")
    assert [r.values["n"] for r in found.remarks if r.values.get("kind") == "camera"] == [1]


@pytest.mark.parametrize("matrix", ["1 2 3", "x" * 3, " ".join(["0"] * 16), " ".join(["2"] * 16), ""])
def test_a_camera_with_a_bad_transform_stays_without_orientation(matrix, tmp_path):
    bad = f'<camera id="9" sensor_id="0" label="P"><transform>{matrix}</transform></camera>'
    found = read(tmp_path, shots=cameras() + bad)
    assert found.block.images.oriented.tolist() == [True] * 3 + [False]
    assert [r.values["n"] for r in found.remarks if r.values.get("kind") == "transform"] == [1]


def markers(*references):
    inside = "".join(f'<marker id="{k}" label="G{k}">{r}</marker>' for k, r in enumerate(references))
    seen = "".join(
        f'<marker marker_id="{k}"><location camera_id="0" x="1000" y="1000"/></marker>' for k in range(len(references))
    )
    return f"<markers>{inside}</markers><frames><frame><markers>{seen}</markers></frame></frames>"


SETTINGS = '<settings><property name="accuracy_markers" value="{}"/></settings>'
NAN = np.nan
REFERENCES = {
    "one for all": ('<reference x="1" y="2" z="3" sxyz="0.01" enabled="true"/>', "", 1, (1, 2, 3), (0.01, 0.01, 0.01)),
    "each": ('<reference x="1" y="2" z="3" sx="0.1" sy="0.2" sz="0.3"/>', "", 1, (1, 2, 3), (0.1, 0.2, 0.3)),
    "plan and height": ('<reference x="1" y="2" z="3" sxy="0.1" sz="0.3"/>', "", 1, (1, 2, 3), (0.1, 0.1, 0.3)),
    "one before all": ('<reference x="1" y="2" z="3" sxyz="0.1" sz="0.3"/>', "", 1, (1, 2, 3), (0.1, 0.1, 0.3)),
    "held": ('<reference x="1" y="2" z="3" sxyz="0"/>', "", 1, (1, 2, 3), (0, 0, 0)),
    "disabled": ('<reference x="1" y="2" z="3" sxyz="0.01" enabled="false"/>', "", 2, (1, 2, 3), (0.01, 0.01, 0.01)),
    "disabled by number": ('<reference x="1" y="2" z="3" sxyz="1" enabled="0"/>', "", 2, (1, 2, 3), (1, 1, 1)),
    "default": ('<reference x="1" y="2" z="3"/>', "", 1, (1, 2, 3), (0.005, 0.005, 0.005)),
    "of the chunk": ('<reference x="1" y="2" z="3"/>', SETTINGS.format("0.02"), 1, (1, 2, 3), (0.02, 0.02, 0.02)),
    "three of the chunk": ('<reference x="1" y="2" z="3"/>', SETTINGS.format("1 2 3"), 1, (1, 2, 3), (1, 2, 3)),
    "plan and height of the chunk": ('<reference x="1" y="2" z="3"/>', SETTINGS.format("1/2"), 1, (1, 2, 3), (1, 1, 2)),
    "height alone": ('<reference z="3" sz="0.3"/>', "", 1, (NAN, NAN, 3), (NAN, NAN, 0.3)),
    "no reference": ("", "", 0, (NAN, NAN, NAN), (NAN, NAN, NAN)),
    "empty reference": ('<reference enabled="true"/>', "", 0, (NAN, NAN, NAN), (NAN, NAN, NAN)),
    "no number": ('<reference x="a" y="2" z="3"/>', "", 0, (NAN, NAN, NAN), (NAN, NAN, NAN)),
    "negative": ('<reference x="1" y="2" z="3" sxyz="-1"/>', "", 0, (NAN, NAN, NAN), (NAN, NAN, NAN)),
}


@pytest.mark.parametrize("case", REFERENCES.values(), ids=REFERENCES)
def test_markers_with_coordinates_are_control_or_check_points(case, tmp_path):
    reference, settings, role, xyz, sigma = case
    found = read(tmp_path, chunk=TRANSFORM + settings + markers(reference, "")).block.points
    assert found.role.tolist() == [{0: Role.TIE, 1: Role.CONTROL, 2: Role.CHECK}[role], Role.TIE]
    np.testing.assert_array_equal(found.xyz[0], xyz)
    np.testing.assert_array_equal(found.sigma[0], sigma)


GEOGRAPHIC = (
    'GEOGCS["WGS 84",DATUM["WGS_1984",SPHEROID["WGS 84",6378137,298.257223563]],PRIMEM["Greenwich",0],'
    'UNIT["degree",0.0174532925199433]]'
)


def test_control_of_a_georeferenced_chunk_is_geocentric_as_its_cameras(tmp_path):
    pytest.importorskip("pyproj")
    found = read(tmp_path, reference=GEOGRAPHIC, chunk=TRANSFORM + markers('<reference x="0" y="0" z="10" sxyz="1"/>',
                 '<reference x="90" y="0" z="0" sxyz="1"/>', '<reference x="0" y="90" z="0" sxyz="1"/>'))  # fmt: skip
    a, b = 6378137.0, 6356752.314245179
    np.testing.assert_allclose(found.block.points.xyz, np.diag([a + 10, a, b]), atol=1e-6)
    np.testing.assert_allclose(found.block.points.sigma, 1.0)


def test_control_in_a_system_that_is_unknown_is_counted_as_not_read(tmp_path):
    found = read(tmp_path, reference="NOTHING[]", chunk=TRANSFORM + markers('<reference x="1" y="2" z="3"/>'))
    assert found.unread == {"<reference> of <marker>": 1}
    assert found.block.points.role.tolist() == [Role.TIE]


def test_control_and_check_points_of_our_own_export_come_back(tmp_path):
    block = simulate(field_scene(TargetField(stations=4, frontal=1, rows=4, columns=5)), Survey()).truth
    count = len(block.points)
    role = np.full(count, Role.TIE, np.int32)
    role[:4], role[4:6] = Role.CONTROL, Role.CHECK
    sigma = np.full((count, 3), np.nan)
    sigma[:6] = 0.01, 0.02, 0.03
    sigma[0] = 0.0
    sigma[1, :2] = np.nan
    block = replace(block, points=replace(block.points, role=role, sigma=sigma))
    given = np.full((count, 3), np.nan)
    given[:6] = block.points.xyz[:6] + 0.001
    write_format("metashape", Export(block=block, given=given), tmp_path / "c.xml", approximate=True)
    found = read_format("metashape", tmp_path / "c.xml")
    points = found.block.points
    assert found.unread == {}
    at = [points.ids.index(block.points.ids[k]) for k in range(6)]
    assert points.role[at].tolist() == role[:6].tolist()
    np.testing.assert_array_equal(points.sigma[at], sigma[:6])
    known = np.isfinite(sigma[:6])
    np.testing.assert_allclose(points.xyz[at][known], given[:6][known], atol=1e-12)
    assert np.isnan(points.xyz[at][~known]).all()


PASSED_OVER = {
    "shutter": ("", "<rolling_shutter>1 0 0</rolling_shutter>", {"<rolling_shutter>": 3}),
    "of the chunk": ("<scalebars><scalebar id='0'/></scalebars>", "", {"<scalebars>": 1}),
    "positions": ("", '<reference x="1" y="2" z="3" enabled="true"/>', {"<reference>": 3}),
    "two kinds": ("<shapes/>", "<depth/>", {"<depth>": 3, "<shapes>": 1}),
    "attribute": ("<markers version='1' unit='ft'/>", "", {"unit of <markers>": 1}),
    "without geometry": ("<region/><settings/><meta/>", "<orientation>6</orientation><covariance>1</covariance>", {}),
}


@pytest.mark.parametrize("case", PASSED_OVER.values(), ids=PASSED_OVER)
def test_elements_passed_over_are_counted(case, tmp_path):
    chunk, inner, counts = case
    found = read(tmp_path, chunk=TRANSFORM + chunk, shots=cameras("", inner))
    assert found.unread == counts
    assert sum(r.code == "import.not_read" for r in found.remarks) == bool(counts)


FOOT = 'LOCAL_CS["Local Coordinates",LOCAL_DATUM["Local Datum",0],UNIT["{}",{}]]'
UNITS = {
    "metre": (FOOT.format("metre", 1), 1.0), "foot": (FOOT.format("foot", 0.3048), 0.3048),
    "US survey foot": (FOOT.format("US survey foot", 0.3048006096012192), 0.3048006096012192),
    "millimetre": (FOOT.format("millimetre", 1e-3), 1e-3), "kilometre": (FOOT.format("kilometre", "1E+3"), 1e3),
    "none": ('LOCAL_CS["Local Coordinates",LOCAL_DATUM["Local Datum",0]]', 1.0),
}  # fmt: skip


@pytest.mark.parametrize("unit", UNITS)
def test_markers_of_a_local_system_are_in_metres(unit, tmp_path):
    reference, length = UNITS[unit]
    found = read(tmp_path, reference=reference, chunk=TRANSFORM + markers('<reference x="1" y="2" z="3" sxyz="0.01"/>'))
    np.testing.assert_allclose(found.block.points.xyz[0], length * np.array([1, 2, 3]))
    np.testing.assert_allclose(found.block.points.sigma[0], 0.01)
    assert any(r.code == "import.markers_converted" for r in found.remarks) == (length != 1)
    np.testing.assert_allclose(found.block.images.centre, EXPECTED, atol=1e-9)


def test_a_unit_without_length_is_refused(tmp_path):
    with pytest.raises(InputError, match=r"metashape\.unit_length"):
        read(tmp_path, reference=FOOT.format("foot", 0), chunk=TRANSFORM + markers('<reference x="1" y="2" z="3"/>'))


@pytest.mark.parametrize(("word", "count"), [("false", 2), ("0", 2), ("False", 2), ("true", 3), ("1", 3), (None, 3)])
def test_disabled_cameras_are_not_used(word, count, tmp_path):
    words = "" if word is None else f'enabled="{word}"'
    found = read(tmp_path, shots=camera("0") + camera("1", words) + camera("2"))
    assert len(found.block.images) == count
    assert found.unread == {}
    assert [r.values["n"] for r in found.remarks if r.code == "import.elements_disabled"] == [1] * (count == 2)


def test_all_cameras_disabled(tmp_path):
    with pytest.raises(InputError, match=r"metashape\.cameras_disabled"):
        read(tmp_path, shots=cameras('enabled="false"'))


def test_disabled_markers_are_not_used(tmp_path):
    text = markers('<reference x="1" y="2" z="3"/>', "", '<reference x="4" y="5" z="6"/>')
    found = read(tmp_path, chunk=TRANSFORM + text.replace('<marker id="0"', '<marker id="0" enabled="false"'))
    assert found.block.points.ids == ("G1", "G2")
    assert found.unread == {}
    assert [r.values["n"] for r in found.remarks if r.values.get("kind") == "disabled_marker"] == [1]
    for word in ('valid="false"', 'valid="0"', 'pinned="0"'):
        off = read(tmp_path, chunk=TRANSFORM + text.replace("<location", f"<location {word}"))
        assert len(off.block.observations) == 0


CHUNKS = {  # attributes of chunks, whether they have cameras; the one that is read, the remark
    "one": ([("", True)], 0, ""),
    "one disabled": ([('enabled="false"', True)], 0, "import.chunk_disabled"),
    "two": ([("", True), ("", True)], 0, (1, 2)),
    "first disabled": ([('enabled="false"', True), ('enabled="true"', True)], 1, (2, 2)),
    "first disabled by number": ([('enabled="0"', True), ("", True)], 1, (2, 2)),
    "second disabled": ([("", True), ('enabled="0"', True)], 0, (1, 2)),
    "first empty": ([("", False), ("", True)], 1, (2, 2)),
    "first empty, second disabled": ([("", False), ('enabled="0"', True), ("", True)], 2, (3, 3)),
    "empty and disabled": ([("", False), ('enabled="0"', True)], 1, "import.chunk_disabled"),
}


@pytest.mark.parametrize("case", CHUNKS.values(), ids=CHUNKS)
def test_the_first_enabled_chunk_with_cameras_is_read(case, tmp_path):
    chunks, right, told = case
    text = "".join(
        f"<chunk {attributes}><sensors>{SENSOR}</sensors><cameras>{shots}</cameras>{TRANSFORM}</chunk>"
        for attributes, shots in (
            (a, cameras().replace("IMG", f"C{k}") if full else "") for k, (a, full) in enumerate(chunks)
        )
    )
    path = tmp_path / "cameras.xml"
    path.write_text(f'<document version="2.0.0">{text}</document>')
    found = read_format("metashape", path)
    assert found.block.images.ids[0] == f"C{right}_0"
    assert found.unread == {}
    chunk = [r for r in found.remarks if "chunk" in r.code]
    if isinstance(told, tuple):
        assert [(r.values["number"], r.values["n"]) for r in chunk] == [told]
    else:
        assert told in {r.code for r in chunk} if told else not chunk
