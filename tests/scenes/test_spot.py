"""SPOT 5 (DIMAP 1): a file of our own, its rays against the handbook's matrices written out."""

from datetime import datetime, timedelta

import numpy as np
import pytest

from raybundle.errors import InputError
from raybundle.io.scenes import read_scene

CENTRE = datetime.fromisoformat("2008-03-04T12:31:39.349737")
COLUMNS, ROWS, PERIOD = 300, 2000, 7.5e-4
PITCH, ROLL, YAW = -9.5e-4, 2e-3, 1.2e-3
RATE = 1.04e-3


def orbit(t):
    """Position and velocity of a circle that is inclined and 820 km up."""
    r, phase = 7.2e6, 0.7 + RATE * t
    one, two = np.array([0.6, 0.8, 0.0]), np.array([-0.16, 0.12, np.sqrt(1 - 0.04)])
    return r * (one * np.cos(phase) + two * np.sin(phase)), r * RATE * (two * np.cos(phase) - one * np.sin(phase))


def stamp(t):
    return (CENTRE + timedelta(seconds=t)).isoformat()


def xyz(v):
    return "".join(f"<{k}>{x:.10e}</{k}>" for k, x in zip("XYZ", v, strict=True))


def psi(column):
    return 0.02 + 1e-6 * column, -0.07 + 1.2e-5 * column


def document(times=range(-180, 181, 30), attitudes=np.arange(-1.5, 1.51, 0.125), columns=COLUMNS, unit=1.0):  # noqa: B008
    points = ""
    for t in times:
        P, V = orbit(t)
        place = f"<Location>{xyz(P * unit)}</Location><Velocity>{xyz(V * unit)}</Velocity>"
        points += f"<Point>{place}<TIME>{stamp(t)}</TIME></Point>"
    angles = "".join(
        f"<Angles><TIME>{stamp(float(t))}</TIME><YAW>{YAW}</YAW><PITCH>{PITCH}</PITCH><ROLL>{ROLL}</ROLL></Angles>"
        for t in attitudes
    )
    looks = "".join(
        f"<Look_Angles><DETECTOR_ID>{k}</DETECTOR_ID>"
        f"<PSI_X>{psi(k)[0]:.12e}</PSI_X><PSI_Y>{psi(k)[1]:.12e}</PSI_Y></Look_Angles>"
        for k in range(1, columns + 1)
    )
    return (
        "<?xml version='1.0'?><Dimap_Document><Metadata_Id><METADATA_FORMAT version='1.1'>DIMAP</METADATA_FORMAT>"
        f"</Metadata_Id><Raster_Dimensions><NCOLS>{COLUMNS}</NCOLS><NROWS>{ROWS}</NROWS></Raster_Dimensions>"
        f"<Data_Strip><Ephemeris><Points>{points}</Points></Ephemeris><Satellite_Attitudes><Corrected_Attitudes>"
        f"<Corrected_Attitude>{angles}</Corrected_Attitude></Corrected_Attitudes></Satellite_Attitudes>"
        f"<Sensor_Configuration><Time_Stamp><LINE_PERIOD>{PERIOD}</LINE_PERIOD>"
        f"<SCENE_CENTER_TIME>{stamp(0)}</SCENE_CENTER_TIME><SCENE_CENTER_LINE>1001</SCENE_CENTER_LINE></Time_Stamp>"
        "<Instrument_Look_Angles_List><Instrument_Look_Angles><BAND_INDEX>1</BAND_INDEX><Look_Angles_List>"
        f"{looks}</Look_Angles_List></Instrument_Look_Angles></Instrument_Look_Angles_List></Sensor_Configuration>"
        "</Data_Strip></Dimap_Document>"
    )


def saved(tmp_path, text):
    path = tmp_path / "METADATA.DIM"
    path.write_text(text)
    return path


def test_rays_by_the_handbook(tmp_path):
    scene = read_scene(saved(tmp_path, document()))
    assert scene.format == "spot"
    line = scene.rigorous
    for column, row in ((1, 1), (150, 1001), (300, 2000)):
        P, d = line.rays(np.array([[column - 0.5, row - 0.5]]))
        position, velocity = orbit((row - 1001) * PERIOD)
        assert np.abs(P[0] - position).max() < 1e-3
        Z = position / np.linalg.norm(position)
        X = np.cross(velocity, Z)
        X /= np.linalg.norm(X)
        Y = np.cross(Z, X)
        sp, cp, sr, cr, sy, cy = np.sin(PITCH), np.cos(PITCH), np.sin(ROLL), np.cos(ROLL), np.sin(YAW), np.cos(YAW)
        Mp = np.array([[1, 0, 0], [0, cp, sp], [0, -sp, cp]])
        Mr = np.array([[cr, 0, -sr], [0, 1, 0], [sr, 0, cr]])
        My = np.array([[cy, -sy, 0], [sy, cy, 0], [0, 0, 1]])
        x, y = psi(column)
        u = np.stack([X, Y, Z], axis=1) @ Mp @ Mr @ My @ np.array([-np.tan(y), np.tan(x), -1])
        assert np.abs(d[0] - u / np.linalg.norm(u)).max() < 1e-9


def test_there_and_back(tmp_path):
    line = read_scene(saved(tmp_path, document())).rigorous
    xy = np.random.default_rng(1).uniform(0, [COLUMNS, ROWS], (100, 2))
    assert np.abs(line.project(line.localise(xy, 250.0)) - xy).max() < 1e-6


@pytest.mark.parametrize(
    ("text", "message"),
    [
        (document(attitudes=np.array([-1.5, -1.375, -1.25, 0.5, 0.625, 0.75, 0.875])), r"trajectory\.gap"),
        (document(times=range(60, 400, 30)), r"ephemeris .*60.*390 s.*trajectory\.not_covered"),
        (document(times=range(0, 90, 30)), r"3.*scene\.position_count"),
        (document(columns=200), r"200.*300.*scene\.look_angle_count"),
        (document(unit=1e-3), r"scene\.not_an_orbit"),
        (document().replace("<DETECTOR_ID>7<", "<DETECTOR_ID>8<"), r"8.*scene\.detector_order"),
        (document().replace("<LINE_PERIOD>", "<LINE_PERIOD>x"), r"value\.not_finite"),
        (document().replace("12:31:39.349737", "noon"), r"value\.no_time"),
    ],
)
def test_bad_files(tmp_path, text, message):
    path = saved(tmp_path, text)
    with pytest.raises(InputError, match=message) as caught:
        read_scene(path)
    assert caught.value.file == str(path)
