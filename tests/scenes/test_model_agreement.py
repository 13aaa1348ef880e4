"""Maxar ISD files made from the specification: unit of the rotation angle, models that contradict each other."""

import json
from dataclasses import replace
from datetime import UTC, datetime, timedelta

import numpy as np
import pytest

from raybundle.cli.main import main
from raybundle.io.block.folder import read_block
from raybundle.io.scenes import agreement_of, read_scene, remarks_of
from raybundle.scenes.model_agreement import ModelsContradict
from raybundle.scenes.rpc_fit import fit_rpc
from tests.cli.reported import reported, values_of
from tests.scenes.conftest import make_scene

PD, WIDTH = 13246.0, 8000
PITCH = 1.2e-6 * PD
START = datetime(2013, 5, 8, 0, 3, 30, tzinfo=UTC)


def line_of(angle):
    """A scene whose array is turned by an angle [rad] about its middle, which lies near the optical axis."""
    x = np.array([0.0, float(WIDTH)])
    along = -(x - WIDTH / 2) * PITCH
    look = np.stack([1e-4 * PD - np.sin(angle) * along, np.cos(angle) * along], axis=1) / PD
    return make_scene(detector_look=look)


def isd(line, angle, written, attribute="", rpc=None, errors=(5.0, 0.5)):
    """An ISD file of a scene; the array's first element lies at the end of the turned array."""
    t, table = line.trajectory.position_times, line.trajectory
    half = -(0.5 - WIDTH / 2) * PITCH
    origin = (float(1e-4 * PD - np.sin(angle) * half), float(np.cos(angle) * half))
    rows = "".join(
        f"<EPHEMLIST>{k + 1} {' '.join(map(repr, p))} 0 0 0</EPHEMLIST>" for k, p in enumerate(table.positions.tolist())
    )
    turns = "".join(
        f"<ATTLIST>{k + 1} {' '.join(map(repr, q))}</ATTLIST>" for k, q in enumerate(table.quaternions.tolist())
    )
    start = (START + timedelta(seconds=float(t[0]))).isoformat()
    step = float(t[1] - t[0])
    times = "".join(
        f"<TLCLIST>{y - 0.5!r} {s - float(line.line_times[0])!r}</TLCLIST>"
        for y, s in zip(line.line_y.tolist(), line.line_times.tolist(), strict=True)
    )
    first = (START + timedelta(seconds=float(line.line_times[0]))).isoformat()
    tables = "".join(
        f"<{n}><STARTTIME>{start}</STARTTIME><NUMPOINTS>{len(t)}</NUMPOINTS><TIMEINTERVAL>{step!r}</TIMEINTERVAL>"
        f"<{e}LISTList>{r}</{e}LISTList></{n}>"
        for n, e, r in (("EPH", "EPHEM", rows), ("ATT", "ATT", turns))
    )
    return (
        f"<isd><IMD><BANDID>P</BANDID><NUMROWS>{line.height_px}</NUMROWS><NUMCOLUMNS>{WIDTH}</NUMCOLUMNS><IMAGE>"
        f"<SATID>XX01</SATID><TLCTIME>{first}</TLCTIME><TLCLISTList>{times}</TLCLISTList></IMAGE></IMD>{tables}<GEO>"
        f"<PRINCIPAL_DISTANCE><PD>{PD!r}</PD></PRINCIPAL_DISTANCE>"
        "<PERSPECTIVE_CENTER><CX>0</CX><CY>0</CY><CZ>0</CZ></PERSPECTIVE_CENTER>"
        "<CAMERA_ATTITUDE><QCS1>0</QCS1><QCS2>0</QCS2><QCS3>0</QCS3><QCS4>1</QCS4></CAMERA_ATTITUDE>"
        f"<DETECTOR_MOUNTING><BAND_P><DETECTOR_ARRAY><DETORIGINX>{origin[0]!r}</DETORIGINX>"
        f"<DETORIGINY>{origin[1]!r}</DETORIGINY><DETROTANGLE{attribute}>{written!r}</DETROTANGLE>"
        f"<DETPITCH>{PITCH!r}</DETPITCH></DETECTOR_ARRAY></BAND_P></DETECTOR_MOUNTING></GEO>"
        f"{'' if rpc is None else rpb(rpc, errors)}</isd>"
    )


def rpb(rpc, errors):
    """The group RPB of an ISD file."""
    (x, y), (lon, lat, h) = rpc.image_offset - 0.5, rpc.ground_offset
    sx, sy, (slon, slat, sh) = *rpc.image_scale, rpc.ground_scale
    keys = {
        "ERRBIAS": errors[0], "ERRRAND": errors[1], "LINEOFFSET": y, "SAMPOFFSET": x, "LATOFFSET": lat,
        "LONGOFFSET": lon, "HEIGHTOFFSET": h, "LINESCALE": sy, "SAMPSCALE": sx, "LATSCALE": slat, "LONGSCALE": slon,
        "HEIGHTSCALE": sh,
    }  # fmt: skip
    text = "".join(f"<{k}>{float(v)!r}</{k}>" for k, v in keys.items())
    for name, row in zip(("LINENUM", "LINEDEN", "SAMPNUM", "SAMPDEN"), rpc.coefficients.tolist(), strict=True):
        text += f"<{name}COEFList><{name}COEF>{' '.join(map(repr, row))}</{name}COEF></{name}COEFList>"
    return f"<RPB><SPECID>RPC00B</SPECID><IMAGE>{text}</IMAGE></RPB>"


def of_line(line):
    return fit_rpc(line.localise, (WIDTH, line.height_px), (0.0, 800.0)).rpc


CASES = [
    # angle [rad], as written, attribute
    (np.pi, np.pi, ""),
    (np.pi, 180.0, ""),
    (-np.pi, -np.pi, ""),
    (np.pi, 3.14159, ""),
    (np.pi, np.pi, ' unit="rad"'),
    (np.pi, 180.0, ' units="degrees"'),
    (0.0, 0.0, ""),
    (np.pi + 0.01, np.pi + 0.01, ""),
    (np.radians(3.0), 3.0, ""),
    (0.05, 0.05, ""),
    (np.radians(0.05), 0.05, ""),
    (np.pi / 6, np.pi / 6, ""),
]


@pytest.mark.parametrize(("angle", "written", "attribute"), CASES)
def test_the_unit_of_the_angle_is_found_by_the_rpc(tmp_path, angle, written, attribute):
    line = line_of(angle)
    file = tmp_path / "scene.xml"
    file.write_text(isd(line, angle, float(written), attribute, of_line(line)))
    found = read_scene(file)
    agreement = agreement_of(found)
    assert agreement.rms_px < 0.2
    assert agreement.stated
    radians = not attribute and written not in {180.0, 0.0} and abs(angle - written) < 1e-3
    assert any(r.code == "maxar.radians_by_rpc" for r in found.remarks) == radians


@pytest.mark.parametrize(("angle", "written"), [(np.pi, np.pi), (np.pi, 180.0), (-np.pi, -np.pi), (0.0, 0.0)])
def test_without_an_rpc_the_place_of_the_array_decides(tmp_path, angle, written):
    line = line_of(angle)
    file = tmp_path / "scene.xml"
    file.write_text(isd(line, angle, float(written)))
    xy = np.array([[100.0, 100.0], [7900.0, 3500.0]])
    # the ISD states positions, no velocities are taken; times are whole microseconds
    assert np.abs(read_scene(file).rigorous.project(line.localise(xy, 300.0)) - xy).max() < 0.05


def test_without_an_rpc_a_small_angle_is_reported(tmp_path):
    file = tmp_path / "scene.xml"
    file.write_text(isd(line_of(0.01), 0.01, 0.01))
    assert any(r.code == "maxar.degrees_assumed" for r in read_scene(file).remarks)


@pytest.mark.parametrize(
    ("wrong", "errors"),
    [
        ({"unit": True}, (5.0, 0.5)),
        ({"shift": 20.0}, (5.0, 0.5)),
        ({"shift": -20.0}, (0.0, 5.0)),
        ({"shift": 200.0}, (0.0, 0.0)),
        ({"distance": 1.01}, (5.0, 0.5)),
    ],
    ids=["unit", "shift", "random error alone", "no stated error", "principal distance"],
)
def test_models_that_contradict_each_other_are_a_fault(tmp_path, capsys, wrong, errors):
    line = line_of(np.pi)
    rpc = of_line(line)
    if "shift" in wrong:
        rpc = replace(rpc, image_offset=rpc.image_offset + np.array([wrong["shift"], 0]))
    text = isd(line, np.pi, np.pi, ' unit="deg"' if "unit" in wrong else "", rpc, errors)
    text = text.replace(f"<PD>{PD!r}", f"<PD>{PD * wrong.get('distance', 1.0)!r}")
    file, points = tmp_path / "scene.xml", tmp_path / "points.csv"
    file.write_text(text)
    lon, lat, h = rpc.ground_offset.tolist()
    points.write_text(f"point,lon_deg,lat_deg,h_m\nA,{lon!r},{lat!r},{h!r}\n")
    out = tmp_path / "new_RPC.TXT"
    assert main(["rpc", "info", str(file)]) == 3
    assert main(["rpc", "fit", str(file), "--out", str(out)]) == 3
    assert main(["rpc", "project", str(file), str(points), "--out", str(tmp_path / "o.csv")]) == 3
    assert "[scene.models_contradict]" in capsys.readouterr().err
    assert not out.exists()
    assert main(["rpc", "project", str(file), str(points), "--model", "rpc", "--out", str(tmp_path / "o.csv")]) == 0
    [preferred] = [r for r in remarks_of(read_scene(file)) if r.code == "scene.rpc_preferred"]
    control = tmp_path / "control.csv"
    control.write_text("point,lon_deg,lat_deg,h_m,x_px,y_px\n" + control_rows(rpc))
    for words, to in (
        (["correct", str(file), str(control)], "corrected_RPC.TXT"),
        (["batch", str(file), "--control", str(control)], "all"),
    ):
        found = reported(capsys, "rpc", *words, "--out", tmp_path / to)
        assert preferred.values == pytest.approx(values_of(found)["scene.rpc_preferred"])
    with pytest.raises(ModelsContradict, match=r"scene\.models_contradict"):
        read_block(scene_block(tmp_path / "block", file, "linescan"))
    assert read_block(scene_block(tmp_path / "other", file, "rpc")).cameras


def control_rows(rpc):
    """Six points of a scene, where its RPC has them."""
    steps = np.array([[-0.5, -0.5], [0.5, -0.5], [0, 0], [-0.5, 0.5], [0.5, 0.5], [0.2, -0.3]])
    lonlat = rpc.ground_offset[:2] + steps * rpc.ground_scale[:2]
    ground = np.column_stack([lonlat, np.full(len(steps), rpc.ground_offset[2])])
    return "".join(
        f"P{k},{','.join(map(repr, (*g.tolist(), *xy.tolist())))}\n"
        for k, (g, xy) in enumerate(zip(ground, rpc.project(ground), strict=True))
    )


def scene_block(folder, file, model):
    """A block of one scene, whose model is read with it."""
    folder.mkdir()
    (folder / "block.toml").write_text(
        'name = "one"\nlength_unit = "m"\n[frame]\nkind = "local"\norigin = [36.9, 40.0, 300.0]\n'
        f'[cameras.one]\nmodel = "{model}"\nscene = "../{file.name}"\n'
    )
    (folder / "images.csv").write_text("image,camera,file,X,Y,Z,omega_deg,phi_deg,kappa_deg\none,one,,,,,,,\n")
    (folder / "observations.csv").write_text("image,point,x_px,y_px,sx_px,sy_px\none,a,4000,2500,0.3,0.3\n")
    (folder / "points.csv").write_text("point,role,X,Y,Z,sX,sY,sZ\na,control,0,0,0,0.1,0.1,0.1\n")
    return folder


@pytest.mark.parametrize("shift", [0.0, 1.0, 4.0])
def test_differences_within_the_stated_error_are_none(tmp_path, capsys, shift):
    line = line_of(np.pi)
    rpc = of_line(line)
    file = tmp_path / "scene.xml"
    file.write_text(isd(line, np.pi, np.pi, "", replace(rpc, image_offset=rpc.image_offset + np.array([shift, 0]))))
    assert main(["rpc", "info", str(file), "--json"]) == 0
    facts = json.loads(capsys.readouterr().out)
    assert facts["rigorous_minus_rpc"]["mean_px"][0] == pytest.approx(-shift, abs=0.1)
