"""Extended JSON of Capella: truth of an orbit of its own, the centres of published files, gross faults."""

import contextlib
import json
import warnings

import numpy as np
import pytest

from raybundle.errors import InputError
from raybundle.io.scenes import read_scene
from raybundle.numerics.geodesy import WGS84, geocentric_from_geographic
from tests.messages import refused
from tests.scenes.radar_products import Product, centre_of
from tests.scenes.test_mda_products import assert_meets


def capella(p):
    """The keys of the format of Capella (product version 1.10) that a ray needs."""
    at = centre_of(p, (p.columns // 2, p.rows // 2))
    state = [
        {"time": p.utc(t), "position": P.tolist(), "velocity": V.tolist()} for t, P, V in zip(*p.table(), strict=True)
    ]
    return {
        "product_type": "SLC",
        "collect": {
            "platform": "capella-0", "mode": "stripmap", "radar": {"pointing": "right" if p.side > 0 else "left"},
            "state": {"coordinate_system": {"type": "ecef"}, "state_vectors": state},
            "image": {
                "rows": p.rows, "columns": p.columns,
                "image_geometry": {
                    "type": "slant_plane", "first_line_time": p.utc(p.first_s), "delta_line_time": p.line_s,
                    "range_to_first_sample": p.near_m, "delta_range_sample": p.spacing_m,
                    "doppler_centroid_polynomial": {"degree": 1, "coefficients": [[0.0, 0.0], [0.0, 0.0]]},
                },
                "center_pixel": {"target_position": geocentric_from_geographic(at, WGS84)[0].tolist()},
            },
        },
    }  # fmt: skip


def written(folder, keys):
    path = folder / "CAPELLA_extended.json"
    path.write_text(json.dumps(keys))
    return read_scene(path)


@pytest.mark.parametrize("shape", [{}, {"side": -1.0}, {"rows": 1999, "columns": 1201}])
def test_the_json_meets_its_orbit_and_ranges(tmp_path, shape):
    product = Product(**shape)
    product.rows -= product.rows % 2 == 0 and bool(shape)  # its first line at whole microseconds
    found = written(tmp_path, capella(product))
    assert (found.format, found.width_px, found.height_px) == ("capella", product.columns, product.rows)
    assert [r.code for r in found.remarks] == ["scene.radar_delays"]
    assert_meets(found.rigorous, product)
    geographic, _, _, xy = product.truth()
    assert np.abs(found.rigorous.project(geographic) - xy).max() < 1e-6
    assert read_scene(tmp_path).format == "capella"


FAULTS = [
    (("collect", "image", "image_geometry", "type"), "pfa", "scene.image_formation"),
    (("collect", "image", "image_geometry", "type"), "geotransform", "scene.map_product"),
    (("collect", "image", "image_geometry", "first_line_time"), "soon", "value.no_time"),
    (("collect", "image", "image_geometry", "delta_line_time"), None, "value.key_missing"),
    (("collect", "image", "image_geometry", "delta_range_sample"), -1.0, None),
    (
        ("collect", "image", "image_geometry", "doppler_centroid_polynomial"), {"coefficients": [[1.0]]},
        "value.not_supported",
    ),
    (("collect", "image", "rows"), 0, None),
    (("collect", "radar", "pointing"), "up", "value.not_supported"),
    (("collect", "state", "coordinate_system", "type"), "eci", "value.not_supported"),
    (("collect", "state", "state_vectors"), [], "scene.position_count"),
]  # fmt: skip


@pytest.mark.parametrize(("way", "value", "code"), FAULTS)
def test_gross_faults_are_refused_by_name(tmp_path, way, value, code):
    keys = capella(Product())
    holder = keys
    for step in way[:-1]:
        holder = holder[step]
    holder[way[-1]] = value
    with pytest.raises(InputError) as caught:
        written(tmp_path, keys)
    assert code is None or caught.value.code == code
    assert caught.value.place.column


def test_a_wrong_side_is_reported_by_the_centre(tmp_path):
    keys = capella(Product())
    keys["collect"]["radar"]["pointing"] = "left"
    assert [r.code for r in written(tmp_path, keys).remarks] == ["scene.radar_delays", "scene.tie_points"]


@pytest.mark.parametrize(("zone", "known"), [("Z", True), ("+00:00", True), ("+02:00", False)])
def test_times_are_utc(tmp_path, zone, known):
    text = json.dumps(capella(Product())).replace('Z"', f'{zone}"')
    path = tmp_path / "a_extended.json"
    path.write_text(text)
    with contextlib.nullcontext() if known else refused("value.no_time"), warnings.catch_warnings():
        warnings.simplefilter("error")
        assert_meets(read_scene(path).rigorous, Product())
