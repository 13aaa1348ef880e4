"""Marks that are centres of ellipses: with the radii of the targets the points are where their covariance says."""

from dataclasses import replace
from types import SimpleNamespace

import numpy as np
import pytest

from raybundle.adjustment.engine import adjust_block
from raybundle.adjustment.records.options import AdjustmentOptions
from raybundle.block import Role
from raybundle.block.transform import transform_block
from raybundle.errors import InputError
from raybundle.io.geo.control_files import read_control
from raybundle.numerics.rotation import rotation_from_angles
from raybundle.numerics.transform import SimilarityTransform
from raybundle.placing.georeference import georeference
from raybundle.placing.marks import Given
from raybundle.planning.simulate import Survey, simulate
from raybundle.planning.synthetic_networks import TargetField, brown_camera, field_scene
from raybundle.sensors import sensor_models

SIGMA_PX, RADIUS_M = 0.01, 0.009
CONTROL_M = 1e-6
SEEDS = range(1, 9)


def ellipse_centres(truth, rows):
    """Centres (k, 2) [px] of conics through 120 projected points of each circle in the plane Z = 0, and their radii."""
    o, camera = truth.observations, truth.cameras[0]
    t = 2 * np.pi * np.arange(120) / 120
    ring = RADIUS_M * np.stack([np.cos(t), np.sin(t), np.zeros(120)], axis=1)
    centres, radii = [], []
    for k in rows:
        i = o.image[k]
        P = (truth.points.xyz[o.point[k]] + ring - truth.images.centre[i]) @ truth.images.rotation[i].T
        image, _ = sensor_models[camera.model].project(P.T, camera.parameters)
        x, y = (camera.pixel_from_image(image.T) - o.xy_px[k]).T / 10
        a, b, c, d, e = np.linalg.lstsq(np.stack([x * x, x * y, y * y, x, y], axis=1), np.ones(120), rcond=None)[0]
        centre = -np.linalg.solve([[2 * a, b], [b, 2 * c]], [d, e])
        centres.append(o.xy_px[k] + 10 * centre)
        radii.append(10 * np.hypot(x - centre[0], y - centre[1]).mean())
    return np.array(centres), np.array(radii)


@pytest.fixture(scope="module")
def networks(tmp_path_factory):
    """Free blocks of features, and files of control and of marks of every third point; the truth."""
    folder = tmp_path_factory.mktemp("marks")
    return [network(seed, folder) for seed in SEEDS]


def network(seed, folder):
    camera = brown_camera(values={"K1": 3e-4}, estimate=())
    scene = field_scene(TargetField(camera=camera, depth=0.0, stations=40, frontal=0, tilt_deg=45.0, seed=seed))
    aside = scene.centre[:, 1] < -0.3  # from one side: what moves centres does not cancel out
    scene = replace(scene, centre=scene.centre[aside], rotation=scene.rotation[aside])
    seen = simulate(scene, Survey(seed=seed, image_sigma_px=SIGMA_PX, interior="exact"))
    truth = seen.truth
    o = truth.observations
    marked = np.flatnonzero(np.arange(len(truth.points)) % 3 == 0)
    rows = np.flatnonzero(np.isin(o.point, marked))
    centres, radii = ellipse_centres(truth, rows)
    rng = np.random.default_rng(seed)
    xy = centres + rng.normal(0, SIGMA_PX, centres.shape)
    x, y, _ = truth.points.xyz[marked].T
    corners = {
        int(marked[k]) for side in (x + y, x - y, x + 0.3 * y, y - 0.3 * x) for k in (side.argmin(), side.argmax())
    }
    lines, plain = ["point,X,Y,Z,sX,sY,sZ,role,radius"], ["point,X,Y,Z,sX,sY,sZ,role"]
    for p in marked.tolist():
        at = ",".join(f"{v:.9f}" for v in truth.points.xyz[p] + rng.normal(0, CONTROL_M, 3))
        cells = f"m{p},{at},{CONTROL_M},{CONTROL_M},{CONTROL_M},control" if p in corners else f"m{p},,,,,,,tie"
        lines.append(f"{cells},{RADIUS_M}")
        plain.append(cells)
    files = [folder / f"with{seed}.csv", folder / f"without{seed}.csv"]
    marks = ["image,point,x_px,y_px"]
    marks += [f"{truth.images.ids[o.image[k]]},m{o.point[k]},{x:.5f},{y:.5f}" for k, (x, y) in zip(rows, xy)]  # noqa: B905
    for file, text in zip(files, (lines, plain), strict=True):
        file.write_text("\n".join(text) + "\n")
        file.with_name(f"{file.stem}-measurements.csv").write_text("\n".join(marks) + "\n")
    free = replace(
        truth, observations=seen.observed.observations,
        points=replace(truth.points, role=np.full_like(truth.points.role, Role.TIE),
                       sigma=np.full_like(truth.points.xyz, np.nan)),
    )  # fmt: skip
    free = transform_block(
        free,
        SimilarityTransform(
            scale=0.4, rotation=rotation_from_angles(np.array([0.4, -0.3, 2.0])), translation=np.array([1.0, 2.0, 3.0])
        ),
        observed="stay",
    )
    photos = [
        SimpleNamespace(
            name=name, width_px=camera.width_px, height_px=camera.height_px, orientation=1,
            metadata=SimpleNamespace(gps=None, make="", model="", serial="", taken=None),
        )
        for name in truth.images.ids
    ]  # fmt: skip
    return SimpleNamespace(free=free, photos=photos, truth=truth, files=files, radii=radii)


def squared_errors(networks, which):
    """Mean normalised squared errors (3 degrees) of the marked points of each network."""
    found = []
    for n in networks:
        placed = georeference(n.free, n.photos, Given(control=(read_control(n.files[which]),), mark_px=SIGMA_PX))
        result = adjust_block(placed.block, AdjustmentOptions(datum="control"))
        ids = result.adjusted.points.ids
        mine = [k for k, name in enumerate(ids) if name.startswith("m")]
        e = result.adjusted.points.xyz[mine] - n.truth.points.xyz[[int(ids[k][1:]) for k in mine]]
        C = result.precision.object_points[mine] / result.sigma0**2
        found.append(np.mean(np.einsum("ni,nij,nj->n", e, np.linalg.inv(C), e)))
    return np.array(found), placed.notices


@pytest.mark.long
def test_points_are_where_their_covariance_says(networks):
    """Errors of the points of one network depend on each other, those of networks do not: the band of their mean."""
    radii = np.concatenate([n.radii for n in networks])
    assert 9 < radii.min() < np.median(radii) < 23
    error, notices = squared_errors(networks, 0)
    band = 3.29 * error.std(ddof=1) / np.sqrt(len(error))
    assert abs(error.mean() - 3) < band < 2
    assert "target_eccentricity" in {n.code for n in notices}


@pytest.mark.long
def test_centres_of_ellipses_taken_for_images_of_centres_would_be_noticed(networks):
    error, notices = squared_errors(networks, 1)
    assert error.mean() - 3 > 3.29 * error.std(ddof=1) / np.sqrt(len(error))
    assert (error > squared_errors(networks, 0)[0]).all()
    assert "target_eccentricity" not in {n.code for n in notices}


@pytest.mark.long
def test_targets_that_face_nobody_knows_where_are_told(networks, tmp_path):
    """Three of them make no plane; a stated vector does."""
    n = networks[0]
    lines = n.files[0].read_text().splitlines()
    kept = [line.rsplit(",", 1)[0] + "," if k > 3 else line for k, line in enumerate(lines)]
    kept[0] = lines[0]
    marks = n.files[0].with_name(n.files[0].stem + "-measurements.csv").read_text()
    codes = []
    for head, tail in (("", ""), (",nX,nY,nZ", ",0,0,-2")):
        file = tmp_path / f"few{len(head)}.csv"
        rows = [kept[0] + head] + [line + (tail if k < 3 else ",,," if head else "") for k, line in enumerate(kept[1:])]
        file.write_text("\n".join(rows) + "\n")
        file.with_name(f"{file.stem}-measurements.csv").write_text(marks)
        placed = georeference(n.free, n.photos, Given(control=(read_control(file),), mark_px=SIGMA_PX))
        codes.append({x.code for x in placed.notices} & {"target_eccentricity", "target_without_normal"})
    assert codes == [{"target_without_normal"}, {"target_eccentricity"}]


def test_half_a_vector_is_refused(tmp_path):
    (tmp_path / "c.csv").write_text("point,X,Y,Z,radius,nX,nY,nZ\nA,1,2,3,0.01,1,,\n")
    with pytest.raises(InputError, match=r"c\.csv.*2.*control\.normal"):
        read_control(tmp_path / "c.csv")
    (tmp_path / "d.csv").write_text("point,X,Y,Z,radius\nA,1,2,3,-0.01\n")
    with pytest.raises(InputError, match=r"cell\.not_positive"):
        read_control(tmp_path / "d.csv")
