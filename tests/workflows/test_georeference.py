"""Onto control, robustly: blunders are named, heights that are not known are said."""

from dataclasses import replace
from pathlib import Path
from types import SimpleNamespace

import numpy as np
import pytest

from raybundle.block import Role
from raybundle.block.select import transformed
from raybundle.block.simulate import AerialStrips, Survey, aerial_scene, simulate
from raybundle.errors import InputError
from raybundle.io.control_files import ControlFile, Measurements
from raybundle.numerics.rotation import rotation_from_angles
from raybundle.workflows.georeference import georeference
from raybundle.workflows.marks import Given, ScaleBar

NAMES = ("A", "B", "C", "D", "E", "F")


@pytest.fixture(scope="module")
def flight():
    """A free block somewhere, the truth, and six points with their marks."""
    simulation = simulate(aerial_scene(AerialStrips()), Survey(image_sigma_px=0.1, interior="exact"))
    truth = simulation.truth
    rays = truth.ray_count
    xyz = truth.points.xyz
    chosen: list[int] = []
    for corner in np.array([[-1, -1], [1, -1], [1, 1], [-1, 1], [0, 0], [0.5, -0.2]]):
        half = np.ptp(xyz[:, :2], axis=0) * 0.35
        distance = np.linalg.norm(xyz[:, :2] - (xyz[:, :2].mean(axis=0) + corner * half), axis=1)
        distance[rays < 4] = np.inf
        distance[chosen] = np.inf
        chosen.append(int(distance.argmin()))
    o = simulation.observed.observations
    rows = np.flatnonzero(np.isin(o.point, chosen))
    marks = Measurements(
        image=tuple(truth.images.ids[i] for i in o.image[rows]),
        point=np.array([chosen.index(p) for p in o.point[rows]], np.int32),
        xy_px=o.xy_px[rows],
        line=np.arange(2, 2 + len(rows), dtype=np.int32),
    )
    role = np.zeros(len(truth.points), np.int32)
    free = replace(
        truth,
        points=replace(truth.points, role=role, sigma=np.full_like(xyz, np.nan)),
        observations=simulation.observed.observations,
    )
    free = transformed(free, 0.013, rotation_from_angles(np.array([0.4, -0.3, 2.0])), np.array([1.0, 2.0, 3.0]))
    photos = [
        SimpleNamespace(
            name=name, width_px=truth.cameras[0].width_px, height_px=truth.cameras[0].height_px,
            metadata=SimpleNamespace(gps=None),
        )
        for name in truth.images.ids
    ]  # fmt: skip
    return SimpleNamespace(free=free, truth=truth, photos=photos, marks=marks, xyz=xyz[chosen])


def control(flight, xyz=None, marks=None, sigma=0.01):
    xyz = flight.xyz if xyz is None else xyz
    return ControlFile(
        path=Path("control.csv"), crs=None, ids=NAMES, xyz=xyz, sigma=np.where(np.isfinite(xyz), sigma, np.nan),
        role=np.full(6, Role.CONTROL, np.int32), measurements=marks or flight.marks,
    )  # fmt: skip


def error(flight, placed):
    return np.linalg.norm(placed.block.images.centre - flight.truth.images.centre, axis=1).max()


def codes(placed):
    return {n.code for n in placed.notices}


def test_onto_six_points(flight):
    placed = georeference(flight.free, flight.photos, Given(control=(control(flight),)))
    assert error(flight, placed) < 0.5
    assert placed.block.points.ids[-6:] == NAMES
    assert placed.marked.sum() == 6


def test_a_wrong_control_point_does_not_bend_the_start(flight):
    xyz = flight.xyz.copy()
    xyz[2, 0] += 40
    placed = georeference(flight.free, flight.photos, Given(control=(control(flight, xyz),), sigma_given=True))
    assert error(flight, placed) < 0.5


def test_a_wrong_mark_is_named_with_the_point_that_stands_there(flight):
    marks = flight.marks
    mine = np.flatnonzero(np.array(marks.image) == marks.image[int(np.flatnonzero(marks.point == 4)[0])])
    a = mine[marks.point[mine] == 4][0]
    others = mine[marks.point[mine] != 4]
    xy = marks.xy_px.copy()
    xy[a] = xy[others[0]] if len(others) else xy[a] + 200
    wrong = replace(marks, xy_px=xy)
    placed = georeference(flight.free, flight.photos, Given(control=(control(flight, marks=wrong),)))
    (notice,) = [n for n in placed.notices if n.code == "mark_rejected"]
    assert notice.ids == ("E", marks.image[a])
    if len(others):
        assert NAMES[marks.point[others[0]]] in notice.message
    assert error(flight, placed) < 0.5


def test_plan_control_levels_by_the_view(flight):
    xyz = flight.xyz.copy()
    xyz[:, 2] = np.nan
    placed = georeference(flight.free, flight.photos, Given(control=(control(flight, xyz),)))
    assert "levelled" in codes(placed)
    plan = placed.block.images.centre - flight.truth.images.centre
    assert np.abs(plan[:, :2]).max() < 0.1 * np.ptp(flight.truth.points.xyz[:, :2], axis=0).max()


def test_one_point_is_too_little(flight):
    xyz = np.full_like(flight.xyz, np.nan)
    xyz[0] = flight.xyz[0]
    with pytest.raises(InputError, match="at least 2 are needed"):
        georeference(flight.free, flight.photos, Given(control=(control(flight, xyz),)))


def test_a_scale_bar_gives_the_scale(flight):
    length = float(np.linalg.norm(flight.xyz[0] - flight.xyz[2]))
    nothing = control(flight, np.full_like(flight.xyz, np.nan))
    bar = ScaleBar(start="A", end="C", length=length, sigma=0.001)
    placed = georeference(flight.free, flight.photos, Given(control=(nothing,), scale_bars=(bar,)))
    base = np.linalg.norm(placed.block.images.centre[0] - placed.block.images.centre[-1])
    true = np.linalg.norm(flight.truth.images.centre[0] - flight.truth.images.centre[-1])
    assert base == pytest.approx(true, rel=1e-3)
    assert set(placed.block.points.role[-6:]) == {Role.TIE}
    with pytest.raises(InputError, match="point Q is not measured"):
        georeference(flight.free, flight.photos, Given(control=(nothing,), scale_bars=(replace(bar, end="Q"),)))


def test_a_mark_outside_the_photograph_is_an_error_with_its_line(flight):
    xy = flight.marks.xy_px.copy()
    xy[3] = 1e6, 5
    with pytest.raises(InputError, match=r"control\.csv, line 5"):
        georeference(
            flight.free, flight.photos, Given(control=(control(flight, marks=replace(flight.marks, xy_px=xy)),))
        )


def test_gps_places_the_block(flight):
    rng = np.random.default_rng(1)
    photos = []
    for photo, c in zip(flight.photos, flight.truth.images.centre, strict=True):
        east, north, up = c + rng.normal(0, 0.02, 3)
        gps = SimpleNamespace(
            latitude_deg=50 + north / 111_229.0, longitude_deg=8 + east / 71_695.0, altitude_m=200 + up,
            sigma_m=(0.02, 0.02, 0.03), fix="RTK",
        )  # fmt: skip
        photos.append(SimpleNamespace(**{**vars(photo), "metadata": SimpleNamespace(gps=gps)}))
    placed = georeference(flight.free, photos, Given())
    assert placed.frame is not None
    assert "gps" in codes(placed)
    base = np.linalg.norm(placed.block.images.centre[0] - placed.block.images.centre[-1])
    true = np.linalg.norm(flight.truth.images.centre[0] - flight.truth.images.centre[-1])
    assert base == pytest.approx(true, rel=0.01)
