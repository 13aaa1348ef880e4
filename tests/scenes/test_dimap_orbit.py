"""The rigorous model of DIMAP 2 product files: a simulated scene written as such a file is read as it was."""

from dataclasses import replace
from datetime import datetime, timedelta

import numpy as np
import pytest

from raybundle.errors import InputError, note
from raybundle.io.scenes import read_scene
from raybundle.scenes.simulate import OrbitPlan, orbit_scene

START = datetime.fromisoformat("2021-11-07T23:59:59.800000")
PLAN = OrbitPlan(target=(5.4, 43.3, 100.0), pitch_deg=1.2, roll_deg=-2.0, gsd_m=0.5, altitude_m=694e3)


def stamp(seconds):
    return (START + timedelta(seconds=float(seconds))).isoformat(timespec="microseconds") + "Z"


def product(scene, *, table=False, refraction="true", period_unit="ms", first_col=1, bands=1, extra=""):
    """The text of a product file; the attitude as cubics or as a table; elements look along (Y, -X, 1)."""
    first = float(scene.line_times[0])
    path = scene.trajectory
    times = path.position_times[::5]
    points = "".join(
        f"<Point><LOCATION_XYZ unit='m'>{p[0]:.9f} {p[1]:.9f} {p[2]:.9f}</LOCATION_XYZ>"
        f"<VELOCITY_XYZ>0 0 0</VELOCITY_XYZ><TIME>{stamp(t - first)}</TIME></Point>"
        for t, p in zip(times, path.position(times)[0], strict=True)
    )
    q = path.quaternions * np.sign(path.quaternions @ path.quaternions[0])[:, None]
    seconds = path.attitude_times - first
    if table:
        entries = "".join(
            f"<Quaternion><Q0>{w:.17g}</Q0><Q1>{x:.17g}</Q1><Q2>{y:.17g}</Q2><Q3>{z:.17g}</Q3>"
            f"<TIME>{stamp(t)}</TIME></Quaternion>"
            for t, (x, y, z, w) in zip(seconds, q, strict=True)
        )
        attitude = f"<Quaternion_List>{entries}</Quaternion_List>"
    else:
        offset, scale = 0.25, 0.8  # of the day after midnight, for the scene is taken around it
        s = (seconds - 0.2 - offset) / scale
        fits = [np.polynomial.polynomial.polyfit(s, q[:, k], 3) for k in (3, 0, 1, 2)]
        parts = "".join(
            f"<Q{k}><DEGREE>3</DEGREE><COEFFICIENTS>{' '.join(f'{c:.17g}' for c in fit)}</COEFFICIENTS></Q{k}>"
            for k, fit in enumerate(fits)
        )
        attitude = (
            f"<Polynomial_Quaternions><OFFSET>{86400 + offset}</OFFSET><SCALE>{scale}</SCALE>{parts}"
            "</Polynomial_Quaternions>"
        )
    line = float(np.diff(scene.line_times)[0]) / scene.height_px
    factor = {"ms": 1e3, "microsecond": 1e6, "fortnight": 1.0}[period_unit]
    (y0, x0), (y1, x1) = scene.detector_look
    slope = -(x1 - x0) / scene.width_px
    xlos = -x0 + slope * (0.5 - (first_col - 1))
    calibration = (
        f"<Instrument_Calibration><BAND_ID>PAN</BAND_ID><Swath_Range><FIRST_COL>{first_col}</FIRST_COL></Swath_Range>"
        f"<Polynomial_Look_Angles><XLOS_0>{xlos:.17g}</XLOS_0><XLOS_1>{slope:.17g}</XLOS_1><YLOS_0>{y0:.17g}</YLOS_0>"
        "</Polynomial_Look_Angles></Instrument_Calibration>"
    )
    assert y0 == y1
    return (
        "<?xml version='1.0'?><Dimap_Document><Metadata_Identification><METADATA_FORMAT version='2.0'>DIMAP"
        "</METADATA_FORMAT><METADATA_PROFILE>PHR_SENSOR</METADATA_PROFILE></Metadata_Identification>"
        "<Processing_Information><Product_Settings><Geometric_Settings><LIGHT_SPEED_SETTING>true</LIGHT_SPEED_SETTING>"
        f"<ATMOSPHERIC_REFRACTION_SETTING>{refraction}</ATMOSPHERIC_REFRACTION_SETTING></Geometric_Settings>"
        "</Product_Settings></Processing_Information>"
        f"<Raster_Data><Raster_Dimensions><NROWS>{scene.height_px}</NROWS><NCOLS>{scene.width_px}</NCOLS>"
        "</Raster_Dimensions></Raster_Data>"
        f"<Geometric_Data><Refined_Model><Time><Time_Range><START>{stamp(0)}</START></Time_Range><Time_Stamp>"
        f"<LINE_PERIOD unit='{period_unit}'>{line * factor:.17g}</LINE_PERIOD></Time_Stamp></Time>"
        f"<Ephemeris><Point_List>{points}</Point_List></Ephemeris><Attitudes>{attitude}</Attitudes>"
        f"<Geometric_Calibration>{calibration * bands}</Geometric_Calibration></Refined_Model></Geometric_Data>{extra}"
        "</Dimap_Document>"
    )


@pytest.fixture(scope="module")
def orbit():
    return orbit_scene(PLAN)


@pytest.mark.parametrize(
    "how",
    [{}, {"table": True}, {"period_unit": "microsecond", "first_col": 31}, {"refraction": "false", "table": True}],
    ids=["cubics", "table", "microseconds, a part of the detector", "no refraction"],
)
def test_a_product_file_is_read_as_it_was_written(tmp_path, orbit, how):
    file = tmp_path / "DIM.XML"
    file.write_text(product(orbit, **how))
    found = read_scene(file)
    assert (found.width_px, found.height_px, found.rpc) == (4000, 4000, None)
    refraction = how.get("refraction") != "false"
    assert found.remarks[-1] == note("dimap.corrections", refraction=refraction, aberration=True)
    truth = orbit if refraction else replace(orbit, refraction=False)
    xy = np.random.default_rng(1).uniform(0, 4000, (300, 2))
    heights = np.resize([0.0, 900.0, 300.0], 300)
    ground = truth.localise(xy, heights)
    # times are written to a microsecond, a hundredth of a line
    assert np.abs(found.rigorous.project(ground) - xy).max() < 0.02
    assert np.abs(found.rigorous.without_corrections().project(ground) - xy).max() > 5


def test_several_bands_are_told(tmp_path, orbit):
    file = tmp_path / "DIM.XML"
    file.write_text(product(orbit, bands=2))
    assert note("scene.one_band", n=2, band="PAN") in read_scene(file).remarks


@pytest.mark.parametrize(
    ("old", "new", "message"),
    [
        ("unit='ms'", "unit='fortnight'", r"LINE_PERIOD.*'fortnight'.*ms.*value\.unit_unknown"),
        ("Polynomial_Quaternions", "Polynomials", r"dimap\.no_attitude"),
        ("<SCALE>0.8</SCALE>", "<SCALE>0</SCALE>", r"SCALE.*value\.zero"),
        ("Polynomial_Look_Angles", "Look_Table", r"Polynomial_Look_Angles.*scene\.no_look_angles"),
        ("Instrument_Calibration", "Calibration", r"Instrument_Calibration.*scene\.no_look_angles"),
        ("<START>2021", "<START>yesterday", r"value\.no_time"),
        ("<NCOLS>4000", "<NCOLS>-1", r"-1.*scene\.pixel_count"),
    ],
)
def test_product_files_with_mistakes(tmp_path, orbit, old, new, message):
    text = product(orbit)
    assert old in text
    file = tmp_path / "DIM.XML"
    file.write_text(text.replace(old, new))
    with pytest.raises(InputError, match=message):
        read_scene(file)


def test_positions_in_kilometres_are_refused(tmp_path, orbit):
    path = orbit.trajectory
    near = replace(orbit, trajectory=replace(path, positions=path.positions / 1000))
    file = tmp_path / "DIM.XML"
    file.write_text(product(near))
    with pytest.raises(InputError, match=r"scene\.not_an_orbit"):
        read_scene(file)
