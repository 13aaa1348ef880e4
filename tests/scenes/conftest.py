"""A scene of our own, for tests that need no data: a satellite 617 km up, a detector of 8000 elements, 0.7 s."""

import numpy as np
import pytest

from raybundle.numerics.geodesy import LocalPlace
from raybundle.scenes.linescan import LineScene
from raybundle.scenes.rpc_fit import fit_rpc
from raybundle.scenes.trajectory import Trajectory
from tests.conftest import DATA

SENSORS = DATA / "sensors"
RADIUS, HEIGHT = 6371e3, 617e3
GM = 3.986004418e14


def quaternion(R):
    from scipy.spatial.transform import Rotation

    return Rotation.from_matrix(R).as_quat()


def make_scene(pitch=0.15, roll=0.1, width=8000, height=7000, **changes):
    """A scene over 40 N; pitch and roll of the sensor [rad], with a slow drift of the attitude."""
    t = np.arange(-2.0, 2.001, 0.02)
    r = RADIUS + HEIGHT
    rate = np.sqrt(GM / r**3)
    phase = np.radians(40.0) + rate * t
    P = r * np.stack([np.cos(phase) * 0.8, np.cos(phase) * 0.6, np.sin(phase)], axis=1)
    V = np.gradient(P, t, axis=0, edge_order=2)
    down = -P / np.linalg.norm(P, axis=1)[:, None]
    along = V / np.linalg.norm(V, axis=1)[:, None]
    across = np.cross(down, along)
    level = np.stack([along, across, down], axis=2)  # columns: detector x along track, y across, z down
    a, b = pitch + 2e-4 * t + 1e-5 * np.sin(9 * t), roll - 1e-4 * t
    zero, one = np.zeros_like(t), np.ones_like(t)
    Ry = np.moveaxis(np.array([[np.cos(a), zero, np.sin(a)], [zero, one, zero], [-np.sin(a), zero, np.cos(a)]]), 2, 0)
    Rx = np.moveaxis(np.array([[one, zero, zero], [zero, np.cos(b), -np.sin(b)], [zero, np.sin(b), np.cos(b)]]), 2, 0)
    x = np.array([0.0, float(width)])
    given = {
        "width_px": width,
        "height_px": height,
        "line_y": np.array([0.5, height + 0.5]),
        "line_times": np.array([-0.35, 0.35]),
        "detector_x": x,
        "detector_look": np.stack([np.full(2, 1e-4), (x - width / 2) * 1.2e-6], axis=1),
        "trajectory": Trajectory(
            position_times=t, positions=P, attitude_times=t, quaternions=quaternion(level @ Ry @ Rx)
        ),
    }
    return LineScene(**(given | changes))


@pytest.fixture(scope="session")
def scene():
    return make_scene()


@pytest.fixture(scope="session")
def rpc_fit(scene):
    return fit_rpc(scene.localise, (scene.width_px, scene.height_px), (-100.0, 900.0))


@pytest.fixture(scope="session")
def rpc(rpc_fit):
    return rpc_fit.rpc


@pytest.fixture(scope="session")
def place(rpc):
    return LocalPlace(origin=tuple(rpc.ground_offset))


@pytest.fixture(scope="session")
def sensors():
    """The folder of public sensor files; skips where it is absent."""
    if not SENSORS.is_dir():
        pytest.skip("no public data: set RAYBUNDLE_DATA to the folder that holds sensors/")
    return SENSORS


@pytest.fixture
def geoid_grid(tmp_path):
    """EGM96 installed for PROJ with heights of our own: a function of longitude, latitude (n, 2 or more)."""
    import pyproj.datadir
    import rasterio

    from raybundle.io.geo import coordinate_systems

    folder = tmp_path / "proj"
    folder.mkdir()
    lon = np.arange(-180, 180.1, 1.0)
    values = np.tile(20.0 + 0.25 * (lon - 30), (181, 1)).astype("float32")
    with rasterio.open(
        folder / "us_nga_egm96_15.tif", "w", driver="GTiff", width=361, height=181, count=1, dtype="float32",
        crs="EPSG:4979", transform=rasterio.Affine(1, 0, -180.5, 0, -1, 90.5),
    ) as grid:  # fmt: skip
        grid.write(values, 1)
        grid.update_tags(
            AREA_OR_POINT="Point", TYPE="VERTICAL_OFFSET_GEOGRAPHIC_TO_VERTICAL", target_crs_epsg_code="5773"
        )
        grid.set_band_description(1, "geoid_undulation")
        grid.update_tags(1, UNITTYPE="metre")
    before = pyproj.datadir.get_data_dir()
    caches = [f for f in vars(coordinate_systems).values() if hasattr(f, "cache_clear")]
    pyproj.datadir.append_data_dir(str(folder))
    for cached in caches:
        cached.cache_clear()
    yield lambda ground: 20.0 + 0.25 * (np.asarray(ground)[:, 0] - 30)
    pyproj.datadir.set_data_dir(before)
    for cached in caches:
        cached.cache_clear()
