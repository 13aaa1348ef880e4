"""Published adjustments, to the printed digit."""

import csv
import json
from dataclasses import replace

import numpy as np
import pytest

from raybundle.adjustment.records.options import AdjustmentOptions
from raybundle.errors import InputError
from raybundle.io.block.folder import read_block
from raybundle.numerics.rotation import angles_from_rotation
from raybundle.numerics.transform import similarity
from raybundle.workflows.adjust import adjust

KNOWN = [
    "aicon", "camcal21", "camcal21-free", "camcal5", "prague-c1", "prague-s1", "prague-s2", "rc30-pair",
    "resection-mikhail", "resection-wuhan",
]  # fmt: skip
XYZ = ("X", "Y", "Z")
OPK = ("omega_deg", "phi_deg", "kappa_deg")
pytestmark = pytest.mark.data


def load(blocks, name):
    return read_block(blocks / name), json.loads((blocks / name / "expected.json").read_text())


def table(expected, ids, keys):
    return np.array([[expected[i].get(k, np.nan) for k in keys] for i in ids])


@pytest.mark.parametrize("name", KNOWN)
def test_sigma0_counts_and_interior_orientation(blocks, name):
    block, expected = load(blocks, name)
    result = adjust(block)
    assert result.sigma0 == pytest.approx(expected["sigma0"], rel=1e-9)
    for key in ("redundancy", "unknowns", "observations", "constraints"):
        assert getattr(result, key) == expected[key]
    sums = float(np.nansum(result.image_observations.redundancy))
    assert sums == pytest.approx(expected["redundancy_numbers"]["sum_image"], abs=1e-3)
    for interior in result.interior:
        for symbol, e in expected["cameras"][interior.camera].items():
            p = interior.parameters[symbol]
            if "std" in e:
                assert p.value == pytest.approx(e["value"], abs=1e-4 * e["std"])
                assert p.std == pytest.approx(e["std"], rel=1e-5)
        rows = expected.get("correlations", {}).get(interior.camera, {})
        for a, row in rows.items():
            mine = interior.correlations[interior.free.index(a)]
            assert [mine[interior.free.index(b)] for b in row] == pytest.approx(list(row.values()), abs=2e-6)


@pytest.mark.parametrize("name", KNOWN)
def test_points_and_images_with_their_sigmas(blocks, name):
    block, expected = load(blocks, name)
    result = adjust(block)
    points = [i for i in block.points.ids if i in expected.get("points", {})]
    images = list(expected["images"])
    at = [block.points.ids.index(i) for i in points]
    im = [block.images.ids.index(i) for i in images]
    xyz, C = result.adjusted.points.xyz[at], result.precision.object_points[at]
    centre, rotation = result.adjusted.images.centre[im], result.adjusted.images.rotation[im]
    CI = result.precision.images[im]
    CC = CI[:, :3, :3]
    if result.constraints:
        s = similarity(xyz, table(expected["points"], points, XYZ))
        xyz, C = s.points(xyz), s.covariances(C)
        centre, CC, rotation = s.points(centre), s.covariances(CC), s.rotations(rotation)
    else:
        sigma = np.degrees(np.sqrt(np.diagonal(CI, axis1=1, axis2=2))[:, 3:])
        np.testing.assert_allclose(sigma, table(expected["images"], images, ["s" + k for k in OPK]), rtol=1e-5)
    std = table(expected["images"], images, ["s" + k for k in XYZ])
    np.testing.assert_allclose(np.sqrt(np.diagonal(CC, axis1=1, axis2=2)), std, rtol=1e-5)
    assert np.abs((centre - table(expected["images"], images, XYZ)) / std).max() < 1e-4
    angle = np.degrees(angles_from_rotation(rotation)) - table(expected["images"], images, OPK)
    angle = (angle + 180) % 360 - 180
    assert np.abs(angle / table(expected["images"], images, ["s" + k for k in OPK])).max() < 1e-4
    if points:
        std = table(expected["points"], points, ["s" + k for k in XYZ])
        free = std > 0
        np.testing.assert_allclose(np.sqrt(np.diagonal(C, axis1=1, axis2=2))[free], std[free], rtol=1e-5)
        error = (xyz - table(expected["points"], points, XYZ))[free] / std[free]
        assert np.abs(error).max() < 1e-4


@pytest.mark.parametrize("name", ["aicon", "camcal21", "camcal21-free", "camcal5", "prague-c1"])
def test_residuals_in_the_measured_image(blocks, name):
    block, expected = load(blocks, name)
    result = adjust(block, AdjustmentOptions(residuals="measured"))
    variant = expected.get("variant_residual_in_measured_image", {"sigma0": 1.37126320})
    assert result.sigma0 == pytest.approx(variant["sigma0"], rel=1e-6 if name != "camcal21-free" else 1e-8)


def aicon_rows(blocks, result):
    o = result.given.observations
    place = {
        (result.given.images.ids[i], result.given.points.ids[p]): k
        for k, (i, p) in enumerate(zip(o.image, o.point, strict=True))
    }
    with (blocks / "aicon/expected_observations.csv").open() as file:
        for row in csv.DictReader(file):
            yield place[row["image"], row["point"]], row


def largest(blocks, result, names):
    worst = dict.fromkeys(names, 0.0)
    for k, row in aicon_rows(blocks, result):
        for name, (values, axis) in names.items():
            if row[name]:
                worst[name] = max(worst[name], abs(abs(values[k, axis]) - abs(float(row[name]))))
    return worst


def test_aicon_redundancy_numbers_and_test_values(blocks):
    block, _ = load(blocks, "aicon")
    o = adjust(block).image_observations
    result = adjust(block)
    names = {f"{n}{'xy'[a]}": (v, a) for n, v in (("r", o.redundancy), ("w", o.w), ("t", o.t)) for a in (0, 1)}
    assert max(largest(blocks, result, names).values()) < 1e-3


def test_aicon_in_the_model_of_its_own_program(blocks):
    block, expected = load(blocks, "aicon")
    values = {
        "c": 28.8, "x0": 0.0, "y0": 0.0, "K1": 0.0, "K2": 0.0, "P1": 0.0, "P2": 0.0,
        "C1": -7.00801e-5, "C2": -3.12627e-5, "R0": 13.488,
    }  # fmt: skip
    free = ("c", "x0", "y0", "K1", "K2", "P1", "P2")
    camera = replace(block.cameras[0], model="aicon", values=values, estimate=free)
    result = adjust(replace(block, cameras=(camera,), residuals="measured"))
    assert result.redundancy == 18804
    assert result.sigma0 * 0.0005 == pytest.approx(0.000405364017, rel=1e-8)
    o = result.image_observations
    names = {
        "source_rx": (o.redundancy, 0),
        "source_ry": (o.redundancy, 1),
        "source_tx": (o.t, 0),
        "source_ty": (o.t, 1),
    }
    assert max(largest(blocks, result, names).values()) < 0.0051
    rms = np.sqrt(np.mean(result.precision.object_point_std**2, axis=0))
    source = expected["source_values"]
    assert rms == pytest.approx([source[f"rms_s{k}"] for k in XYZ], abs=5e-6)
    for symbol in ("c", "x0", "y0"):
        p = result.interior[0].parameters[symbol]
        assert p.std == pytest.approx(source["parameters"][symbol]["std"], rel=1e-6)


@pytest.mark.parametrize(
    ("name", "sigma0", "c", "tolerance"),
    [
        ("riva-net1", 1.604, 7.4585, 2e-3),
        ("riva-net2", 1.1449, 20.932, 1e-2),
        ("riva-net3", 3.5529, 17.9236, 4e-3),
        ("roma", 0.58277, 24.5425, 4e-3),
        ("sxb", 1.0694, 123.939, 1e-9),
        ("prague-c2", 1.6097, 7.4693, 1e-9),
        ("prague-s3", None, None, None),
        ("prague-s4", 1.0745, 123.939, 1e-9),
    ],
)
def test_blocks_without_a_published_answer_adjust_from_what_they_have(blocks, name, sigma0, c, tolerance):
    """Orientations are found where none are given.  The figures are those of this program, against regressions."""
    result = adjust(read_block(blocks / name))
    assert result.converged
    if sigma0 is not None:
        assert result.sigma0 == pytest.approx(sigma0, rel=1e-3)
        assert result.interior[0].parameters["c"].value == pytest.approx(c, abs=tolerance)


@pytest.mark.parametrize(
    "name", ["camcal21", "camcal21-free", "prague-c1", "rc30-pair", "resection-wuhan", "aicon", "prague-s2"]
)
def test_the_same_from_no_orientation_at_all(blocks, name):
    block, expected = load(blocks, name)
    images = block.images
    blank = replace(images, centre=np.full_like(images.centre, np.nan), rotation=np.full_like(images.rotation, np.nan))
    result = adjust(replace(block, images=blank))
    assert result.sigma0 == pytest.approx(expected["sigma0"], rel=1e-6)


@pytest.mark.parametrize("name", ["camcal21-1ray", "camcal21-missing-obs"])
def test_error_paths_name_the_points_and_no_other(blocks, name):
    block, expected = load(blocks, name)
    with pytest.raises(InputError) as error:
        adjust(block)
    text = " ".join(str(error.value).splitlines()[1:]).replace(".", " ").replace("[", " ")  # points in lines of details
    wanted = expected["must_be_named"]["points"]
    words = set(text.replace(",", " ").replace(";", " ").split())
    assert words & set(block.points.ids) == set(wanted)
    keep = ~np.isin(block.observations.point, [block.points.ids.index(i) for i in wanted])
    o = block.observations
    stay = np.array([i not in wanted for i in block.points.ids])
    place = np.cumsum(stay) - 1
    points = block.points
    left = replace(
        block,
        observations=replace(
            o, image=o.image[keep], point=place[o.point[keep]].astype(np.int32), xy_px=o.xy_px[keep],
            cov_px2=o.cov_px2[keep],
        ),
        points=replace(
            points, ids=tuple(i for i, s in zip(points.ids, stay, strict=True) if s), role=points.role[stay],
            xyz=points.xyz[stay], sigma=points.sigma[stay],
        ),
    )  # fmt: skip
    assert adjust(left).sigma0 == pytest.approx(expected["if_left_out"]["sigma0"], rel=1e-6)
