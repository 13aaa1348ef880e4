"""RPC as tools and vendors write them: parts cut out of scenes, negative scales, EnMAP, PHRDIMAP, JSON."""

import json
import warnings
from dataclasses import replace

import numpy as np
import pytest

from raybundle.errors import InputError
from raybundle.io.scenes import read_scene
from raybundle.io.scenes.base import CUT_OUT
from raybundle.io.scenes.rpc_text import write_rpc_text
from raybundle.io.scenes.writing import write_rpc
from raybundle.scenes.rpc import TERMS, fill_terms, rpc_of
from raybundle.scenes.rpc_image import rpc_of_image
from tests.conftest import DATA
from tests.messages import refused
from tests.scenes.test_readers import dimap, tiff

ROUND_TRIP_PX = 1e-6
POLYNOMIALS = ("row_num", "row_den", "col_num", "col_den")


def grid(width, height, steps=7):
    x, y = np.linspace(0, width, steps), np.linspace(0, height, steps)
    return np.stack([a.ravel() for a in np.meshgrid(x, y)], axis=1)


def round_trip_px(scene):
    """The largest error [px] of image to ground to image, over the image at the least, middle and largest height."""
    rpc = scene.rpc
    width, height = scene.width_px, scene.height_px
    if width is None or height is None:
        width, height = rpc.image_offset + rpc.image_scale
    xy = grid(width, height)
    heights = rpc.ground_offset[2] + rpc.ground_scale[2] * np.array([-1, 0, 1])
    return max(float(np.abs(rpc.project(rpc.localise(xy, h)) - xy).max()) for h in heights)


def cut(rpc, left, top, width, height):
    """The RPC of a part of an image as s2p's cropping writes it: offset and scale of the part, beside its place."""
    part = rpc.shifted(np.array([-left, -top], float))
    return part.spread_over(np.array([width, height])), part


def as_cropped(rpc, left, top, width, height):
    """The same function with an offset far outside the image and a scale of half its size."""
    _, part = cut(rpc, left, top, width, height)
    offset, scale = np.array([20000.0, 19000.0]), np.array([width, height]) / 2
    c = part.coefficients.copy()
    for axis, top_row in ((0, 2), (1, 0)):
        away = part.image_offset[axis] - offset[axis]
        c[top_row] = (part.image_scale[axis] * c[top_row] + away * c[top_row + 1]) / scale[axis]
    return replace(part, coefficients=c, image_offset=offset, image_scale=scale), part


def test_part_of_a_scene_whose_offsets_are_not_its_range(rpc, tmp_path):
    cropped, part = as_cropped(rpc, 3000, 2500, 1024, 1024)
    assert not cropped.middle_in_range()
    path = tmp_path / "part.tif"
    path.write_bytes(tiff(cropped, width=1024, height=1024))
    scene = read_scene(path)
    assert CUT_OUT in scene.remarks
    assert scene.rpc.image_offset.tolist() == [512, 512]
    xy = grid(1024, 1024)
    assert np.abs(scene.rpc.project(part.localise(xy, 300.0)) - xy).max() < ROUND_TRIP_PX


def test_an_rpc_of_another_place_is_still_refused(rpc):
    with pytest.raises(InputError, match=r"rpc\.other_image"):
        rpc_of_image(rpc.shifted(np.array([20000.0, 0.0])), 4000, 4000, "a")
    # its offsets are no range, and the image's ground lies far from the ground that it is for
    away, _ = as_cropped(rpc, 60000, 2500, 1024, 1024)
    with pytest.raises(InputError, match=r"rpc\.other_image"):
        rpc_of_image(away, 1024, 1024, "a")


def test_rewritten_offsets_are_exact(rpc, place):
    spread = rpc.spread_over(np.array([1000, 600]))
    ground = rpc.ground_offset + rpc.ground_scale * np.random.default_rng(1).uniform(-0.9, 0.9, (50, 3))
    assert np.abs(spread.project(ground) - rpc.project(ground)).max() < 1e-8
    a, b = (r.project_with_partials(ground)[1] for r in (spread, rpc))
    assert np.abs(a - b).max() < 1e-9 * np.abs(b).max()


@pytest.mark.parametrize("axis", [0, 1, 2])
def test_negative_scales_are_the_same_function(rpc, tmp_path, axis):
    """Written with a negative scale of one coordinate, as Planet does with latitudes."""
    signs = np.array([(-1.0) ** t.count("LPH"[axis]) for t in TERMS])
    turned = replace(rpc, coefficients=rpc.coefficients * signs)
    path = tmp_path / "planet_RPC.TXT"
    write_rpc_text(turned, path)
    key = ("LONG_SCALE", "LAT_SCALE", "HEIGHT_SCALE")[axis]
    text = path.read_text()
    assert f"\n{key}: " in text
    path.write_text(text.replace(f"{key}: ", f"{key}: -"))
    found = read_scene(path).rpc
    assert (found.ground_scale > 0).all()
    ground = rpc.ground_offset + rpc.ground_scale * np.random.default_rng(1).uniform(-0.9, 0.9, (50, 3))
    assert np.abs(found.project(ground) - rpc.project(ground)).max() < ROUND_TRIP_PX


def test_negative_scales_of_the_image(rpc):
    c = rpc.coefficients.copy()
    c[0] *= -1
    turned = rpc_of(
        coefficients=c, ground_offset=rpc.ground_offset, ground_scale=rpc.ground_scale,
        image_offset=rpc.image_offset, image_scale=rpc.image_scale * [1, -1],
    )  # fmt: skip
    assert np.array_equal(turned.coefficients, rpc.coefficients)


def enmap(rpcs):
    """Metadata with these RPC, one a band."""
    bands = []
    for k, r in enumerate(rpcs, 1):
        lines = [f'<bandID number="{k}">']
        for name, value in zip(("COL", "ROW"), r.image_offset - 0.5, strict=True):
            lines.append(f"<{name}_OFF>{float(value)!r}</{name}_OFF>")
        for name, value in zip(("COL", "ROW"), r.image_scale, strict=True):
            lines.append(f"<{name}_SCALE>{float(value)!r}</{name}_SCALE>")
        for name, offset, scale in zip(("LONG", "LAT", "HEIGHT"), r.ground_offset, r.ground_scale, strict=True):
            lines += [f"<{name}_OFF>{float(offset)!r}</{name}_OFF>", f"<{name}_SCALE>{float(scale)!r}</{name}_SCALE>"]
        for name, row in zip(POLYNOMIALS, r.coefficients, strict=True):
            tag = name.upper()
            lines += [f"<{tag}_{i:02d}>{float(c)!r}</{tag}_{i:02d}>" for i, c in enumerate(row, 1)]
        bands.append("\n".join([*lines, "</bandID>"]))
    size = "<widthOfScene unit='pixel'>8000</widthOfScene><heightOfScene unit='pixel'>7000</heightOfScene>"
    return (
        "<level_X><metadata><copyright>(c) DLR EnMAP 2022</copyright></metadata>"
        f"<specific><mission>EnMAP</mission>{size}</specific>"
        f"<product><navigation><RPC>{''.join(bands)}</RPC></navigation></product></level_X>"
    )


def test_enmap(rpc, tmp_path):
    path = tmp_path / "ENMAP01-____L1B-METADATA.XML"
    path.write_text(enmap([rpc, rpc.shifted(np.array([0.25, 20.0]))]))
    scene = read_scene(path)
    assert (scene.format, scene.sensor, scene.width_px, scene.height_px) == ("enmap", "EnMAP", 8000, 7000)
    (band,) = scene.remarks
    assert (band.code, band.values["band"], band.values["n"]) == ("enmap.one_band", "1", 2)
    assert band.values["apart_px"] == pytest.approx(20.0)
    assert np.array_equal(scene.rpc.coefficients, rpc.coefficients)
    assert scene.rpc.image_offset == pytest.approx(rpc.image_offset)
    path.write_text(enmap([]))
    with pytest.raises(InputError, match=r"bandID.*enmap\.no_rpc"):
        read_scene(path)


def phrdimap(rpc, size):
    """The first format of Pleiades; its first pixel is 1, 1."""

    def ab(name, a, b):
        return f"<{name}><A>{float(a)!r}</A><B>{float(b)!r}</B></{name}>"

    ground = zip(("Lon", "Lat", "Alt"), rpc.ground_scale, rpc.ground_offset, strict=True)
    image = zip(("Col", "Row"), rpc.image_scale, rpc.image_offset + 0.5, strict=True)
    row, column = (" ".join(repr(float(c)) for c in rpc.coefficients[k : k + 2].ravel()) for k in (0, 2))
    return (
        "<PHR_Dimap_Document><Metadata_Identification><METADATA_PROFILE version='1.4'>PHR_SYSTEM</METADATA_PROFILE>"
        "<METADATA_FORMAT>DIMAP_PHR</METADATA_FORMAT></Metadata_Identification><Geoposition><Rational_Sensor_Model>"
        f"<Global_RFM><Inverse_Model><F_COL>{column}</F_COL><F_ROW>{row}</F_ROW></Inverse_Model><RFM_Validity>"
        f"<Direct_Model_Validity_Domain><FIRST_ROW>1</FIRST_ROW><FIRST_COL>1</FIRST_COL><LAST_ROW>{size[1]}</LAST_ROW>"
        f"<LAST_COL>{size[0]}</LAST_COL></Direct_Model_Validity_Domain>"
        f"{''.join(ab(*g) for g in ground)}{''.join(ab(*i) for i in image)}"
        "</RFM_Validity></Global_RFM></Rational_Sensor_Model></Geoposition></PHR_Dimap_Document>"
    )


def test_phrdimap(rpc, tmp_path):
    path = tmp_path / "PHRDIMAP_1.XML"
    path.write_text(phrdimap(rpc, (8000, 7000)))
    scene = read_scene(path)
    assert (scene.format, scene.width_px, scene.height_px, scene.sensor) == ("dimap", 8000, 7000, "PHR_SYSTEM")
    assert np.array_equal(scene.rpc.coefficients, rpc.coefficients)
    assert scene.rpc.image_offset == pytest.approx(rpc.image_offset)
    newer = tmp_path / "RPC_1.XML"
    newer.write_text(dimap(rpc))
    assert np.array_equal(read_scene(newer).rpc.coefficients, rpc.coefficients)
    path.write_text(phrdimap(rpc, (8000, 7000)).replace("F_COL", "F_COLUMN"))
    with pytest.raises(InputError, match=r"Inverse_Model/F_COL.*xml\.element_missing"):
        read_scene(path)


def test_rpc_as_json(rpc, tmp_path):
    group = {
        "row_offset": rpc.image_offset[1] - 0.5, "col_offset": rpc.image_offset[0] - 0.5,
        "row_scale": rpc.image_scale[1], "col_scale": rpc.image_scale[0],
    } | {
        f"{n}_{k}": v[i] for k, v in (("offset", rpc.ground_offset), ("scale", rpc.ground_scale))
        for i, n in enumerate(("lon", "lat", "alt"))
    } | {n: row.tolist() for n, row in zip(POLYNOMIALS, rpc.coefficients, strict=True)}  # fmt: skip
    path = tmp_path / "a.json"
    path.write_text(json.dumps({"img": "a.tif", "geojson": [0.0] * 2000, "width": 8000, "height": 7000, "rpc": group}))
    scene = read_scene(path)
    assert (scene.format, scene.width_px, scene.height_px) == ("rpc-json", 8000, 7000)
    assert np.array_equal(scene.rpc.coefficients, rpc.coefficients)
    assert scene.rpc.image_offset == pytest.approx(rpc.image_offset)


# of the programs' own files


def folder(name):
    path = DATA / "sensors" / name
    if not path.is_dir():
        pytest.skip(f"the files of {name} are not in {path}: set RAYBUNDLE_DATA to the folder that holds them")
    return path


def test_s2p():
    found = sorted(folder("s2p").glob("input_*/img_*.tif"))
    assert len(found) == 5
    for path in found:
        scene = read_scene(path)
        assert round_trip_px(scene) < ROUND_TRIP_PX, path


def test_s2p_published_matches():
    """Points that s2p's tests expect to correspond, at five heights over the range of the first RPC."""
    first, second = (read_scene(folder("s2p") / f"input_pair/img_0{k}.tif").rpc for k in (1, 2))
    published = np.loadtxt(folder("s2p") / "expected_output/units/unit_matches_from_rpc.txt")
    assert published.shape == (125, 4)
    xy = published + 0.5  # it counts from the centre of the first pixel
    heights = first.ground_offset[2] + first.ground_scale[2] * np.linspace(-1, 1, 5)
    off = [np.abs(second.project(first.localise(xy[:, :2], h)) - xy[:, 2:]).max(axis=1) for h in heights]
    assert np.min(off, axis=0).max() < 1e-6  # its own test allows 0.1 px


def test_rpcm():
    found = [p for p in sorted(folder("rpcm").iterdir()) if p.suffix.lower() in {".txt", ".xml", ".json"}]
    assert len(found) >= 11
    for path in found:
        if path.name == "rpc_unsupported.xml":
            with refused("scene.format_unknown"):
                read_scene(path)
            continue
        assert round_trip_px(read_scene(path)) < ROUND_TRIP_PX, path.name


def test_planet_l1a_and_l1b_are_one_function():
    """The same RPC for two image sizes, as rpcm's tests say: equal but for offsets and scales."""
    a, b = (read_scene(folder("rpcm") / f"rpc_PLANET_{k}.txt").rpc for k in ("L1A", "L1B"))
    assert np.array_equal(a.coefficients, b.coefficients)
    ground = a.localise(grid(2560, 1080), 31.0)
    u, v = ((r.project(ground) - r.image_offset) / r.image_scale for r in (a, b))
    assert np.abs(u - v).max() < 1e-12


def test_enmap_sees_its_corners():
    """Corners of the scene that its own metadata state, at the mean height of the ground (1722.85 m)."""
    [path] = folder("rpcm").glob("ENMAP*")
    rpc = read_scene(path).rpc
    corners = np.array(
        [
            [44.128210631, 16.293925071],
            [44.069112065, 16.021507933],
            [44.343208625, 15.982662195],
            [44.403060265, 16.254998701],
        ]
    )
    seen = rpc.project(np.column_stack([corners, np.full(4, 1722.85)]))
    assert np.abs(seen - [[0.5, 0.5], [0.5, 1023.5], [999.5, 1023.5], [999.5, 0.5]]).max() < 0.7


def test_phrdimap_agrees_with_its_own_direct_model():
    """Ground points by the polynomials from image to ground in the file; it states 0.0004 and 0.0010 px."""
    from raybundle.io.reading.xml import read_xml

    found = sorted(folder("shareloc").glob("PHRDIMAP*.XML"))
    if not found:
        pytest.skip("no PHRDIMAP file in sensors/shareloc")
    for path in found:
        scene = read_scene(path)
        rpc = scene.rpc
        assert round_trip_px(scene) < ROUND_TRIP_PX
        model = read_xml(path, "PHR_Dimap_Document").get("Geoposition", "Rational_Sensor_Model", "Global_RFM")
        uvh = np.random.default_rng(1).uniform(-0.9, 0.9, (50, 3))
        T = fill_terms(uvh.T.copy(), np.empty((20, 50)))
        f = [model.get("Direct_Model", k).numbers(40).reshape(2, 20) @ T for k in ("F_LON", "F_LAT")]
        plan = np.stack([n / d for n, d in f], axis=1)
        ground = rpc.ground_offset + rpc.ground_scale * np.column_stack([plan, uvh[:, 2]])
        stated = max(model.get("Inverse_Model").number(f"MODEL_PRECISION_{k}") for k in ("ROW", "COL"))
        off = np.abs(rpc.project(ground) - rpc.image_offset - rpc.image_scale * uvh[:, :2]).max()
        assert off < 3 * stated


# what is written is what its name says


@pytest.mark.parametrize("ending", ["_RPC.TXT", ".RPB", ".rpb"])
def test_gdal_sees_what_is_written(rpc, tmp_path, ending):
    rasterio = pytest.importorskip("rasterio")
    image = tmp_path / "a.tif"
    with warnings.catch_warnings():
        warnings.simplefilter("ignore", rasterio.errors.NotGeoreferencedWarning)
        with rasterio.open(image, "w", driver="GTiff", width=8, height=8, count=1, dtype="uint8") as file:
            file.write(np.zeros((1, 8, 8), np.uint8))
        written = replace(rpc, err_bias_m=3.5, err_rand_m=0.25)
        write_rpc(written, tmp_path / f"a{ending}")
        with rasterio.open(image) as file:
            seen = file.rpcs
    assert seen is not None
    x, y = rpc.image_offset - 0.5
    assert (seen.samp_off, seen.line_off) == (x, y)
    assert (seen.long_off, seen.lat_off, seen.height_off) == tuple(rpc.ground_offset)
    assert (seen.long_scale, seen.lat_scale, seen.height_scale) == tuple(rpc.ground_scale)
    rows = (seen.line_num_coeff, seen.line_den_coeff, seen.samp_num_coeff, seen.samp_den_coeff)
    assert np.array_equal(rows, rpc.coefficients)
    again = read_scene(tmp_path / f"a{ending}").rpc
    assert (again.err_bias_m, again.err_rand_m) == (3.5, 0.25)
    assert np.array_equal(again.coefficients, rpc.coefficients)
    assert np.array_equal(again.image_offset, rpc.image_offset)


@pytest.mark.parametrize("name", ["a.xml", "a", "a.png"])
def test_an_unknown_ending_is_refused(rpc, tmp_path, name):
    with pytest.raises(InputError, match=r"NAME_RPC\.TXT.*NAME\.RPB.*NAME\.geom.*NAME\.tif.*rpc\.name_ending"):
        write_rpc(rpc, tmp_path / name)
    assert not (tmp_path / name).exists()
