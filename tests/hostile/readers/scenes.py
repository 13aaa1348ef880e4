"""Satellite scenes, airborne strips, trajectories."""

import contextlib
import functools
import json
from pathlib import Path

import numpy as np

from raybundle.errors import RaybundleError
from tests.hostile.readers.registry import not_finite, only, place, target, texts


@functools.cache
def small_rpc():
    from raybundle.scenes.rpc_fit import fit_rpc
    from tests.scenes.conftest import make_scene

    scene = make_scene()
    return fit_rpc(scene.localise, (scene.width_px, scene.height_px), (-100.0, 900.0)).rpc


def rpc_text_seeds(top: Path) -> None:
    from raybundle.io.scenes.rpc_text import write_rpc_text

    write_rpc_text(small_rpc(), place(top) / "a_RPC.TXT")


def rpb_seeds(top: Path) -> None:
    from tests.scenes.test_readers import rpb

    for k, kind in enumerate(("RPC00B", "RPC00A")):
        (place(top, k) / "a.RPB").write_text(rpb(small_rpc(), kind))


def tiff_seeds(top: Path) -> None:
    from tests.scenes.test_readers import tiff

    (place(top, 0) / "a.tif").write_bytes(tiff(small_rpc()))
    (place(top, 1) / "a.tif").write_bytes(tiff(small_rpc(), ">", big=True))


def nitf_seeds(top: Path) -> None:
    from tests.scenes.test_readers import nitf

    (place(top) / "a.ntf").write_bytes(nitf(small_rpc()))


def dimap_seeds(top: Path) -> None:
    from tests.scenes.test_dimap_orbit import PLAN, orbit_scene, product
    from tests.scenes.test_readers import dimap

    (place(top, 0) / "RPC_a.XML").write_text(dimap(small_rpc()))
    (place(top, 1) / "DIM_a.XML").write_text(product(orbit_scene(PLAN)))


def spot_seeds(top: Path) -> None:
    from tests.scenes.test_spot import document

    (place(top) / "METADATA.DIM").write_text(document())


def maxar_seeds(top: Path) -> None:
    from tests.scenes.test_readers import KEYS, offsets

    rpc = small_rpc()
    off, scale = offsets(rpc)
    pairs = "".join(f"<{k}OFFSET>{float(v)!r}</{k}OFFSET>" for k, v in zip(KEYS, off, strict=True))
    pairs += "".join(f"<{k}SCALE>{float(v)!r}</{k}SCALE>" for k, v in zip(KEYS, scale, strict=True))
    names = ("LINENUMCOEF", "LINEDENCOEF", "SAMPNUMCOEF", "SAMPDENCOEF")
    rows = "".join(
        f"<{n}List><{n}>{' '.join(repr(float(c)) for c in row)}</{n}></{n}List>"
        for n, row in zip(names, rpc.coefficients, strict=True)
    )
    text = (
        "<isd><IMD><NUMROWS>7000</NUMROWS><NUMCOLUMNS>8000</NUMCOLUMNS><IMAGE><SATID>X</SATID>"
        "<FIRSTLINETIME>2020-01-01T00:00:00.000000Z</FIRSTLINETIME></IMAGE></IMD>"
        f"<RPB><SPECID>RPC00B</SPECID><IMAGE><ERRBIAS>3.5</ERRBIAS><ERRRAND>0.2</ERRRAND>{pairs}{rows}</IMAGE></RPB></isd>"
    )
    (place(top) / "a.XML").write_text(text)


def csm_seeds(top: Path) -> None:
    n = 9
    turned = [[0.0, 0.0, 0.0, 1.0]] * n
    isd = {
        "name_model": "USGS_ASTRO_LINE_SCANNER_SENSOR_MODEL", "name_sensor": "TEST", "center_ephemeris_time": 1000.0,
        "starting_ephemeris_time": 999.2, "line_scan_rate": [[0.5, -0.85, 0.1]], "detector_sample_summing": 1,
        "detector_line_summing": 1, "t0_ephemeris": -0.8, "dt_ephemeris": 0.2, "t0_quaternion": -0.8,
        "dt_quaternion": 0.2, "focal2pixel_lines": [0.0, 10.0, 0.0], "focal2pixel_samples": [0.0, 0.0, 10.0],
        "focal_length_model": {"focal_length": 50}, "image_lines": 16, "image_samples": 16,
        "detector_center": {"line": 0.5, "sample": 8.0}, "interpolation_method": "lagrange",
        "optical_distortion": {"radial": {"coefficients": [0.0, 0.0, 0.0]}},
        "radii": {"semimajor": 1000.0, "semiminor": 1000.0, "unit": "km"},
        "reference_height": {"maxheight": 1000, "minheight": -1000, "unit": "m"},
        "instrument_position": {
            "unit": "km", "positions": [[1050.0, 0.1 * k, 1.0 * k] for k in range(n)],
            "velocities": [[0.0, 0.5, 5.0]] * n, "reference_frame": 1,
        },
        "instrument_pointing": {"quaternions": turned}, "body_rotation": {"quaternions": turned},
        "starting_detector_line": 0, "starting_detector_sample": 0,
        "sun_position": {"positions": [[0.1, 0.1, 0.0]], "velocities": [[0.0, 0.0, 0.0]], "unit": "km"},
    }  # fmt: skip
    (place(top) / "a.json").write_text(json.dumps(isd))


def airborne_seeds(top: Path) -> None:
    from tests.scenes.test_airborne import write_strip

    folder = place(top)
    write_strip(folder, "strip1", 30.0)
    rows = (folder / "strip1.csv").read_text().splitlines()
    (folder / "strip1.csv").write_text("\n".join([rows[0], *rows[1::40]]) + "\n")


def keys_seeds(top: Path) -> None:
    from tests.scenes.test_rpc_writing import gdal_json, gdal_xml, orthority

    rpc = small_rpc()
    (place(top, 0) / "a.vrt").write_text(gdal_xml(rpc))
    (place(top, 1) / "a.json").write_text(gdal_json(rpc))
    (place(top, 2) / "a.yaml").write_text(orthority({"a.tif": rpc}))


def geom_seeds(top: Path) -> None:
    from raybundle.io.scenes.rpc_text import write_geom

    write_geom(small_rpc(), place(top) / "a.geom")


def rpcm_seeds(top: Path) -> None:
    rpc = small_rpc()
    numbers = {f"{n}_offset": 45.0 for n in ("lat", "lon", "alt", "row", "col")}
    numbers |= {f"{n}_scale": 45.0 for n in ("lat", "lon", "alt", "row", "col")}
    terms = {n: [float(v) for v in c] for n, c in zip(RPCM, np.asarray(rpc.coefficients), strict=True)}
    (place(top) / "a.json").write_text(json.dumps({"rpc": {**numbers, **terms}, "width": 100, "height": 80}))


RPCM = ("row_num", "row_den", "col_num", "col_den")


def radar_isd_seeds(top: Path) -> None:
    from tests.scenes.test_radar_files import radar_isd

    (place(top) / "radar.json").write_text(json.dumps(radar_isd()))


def enmap_seeds(top: Path) -> None:
    rpc = np.asarray(small_rpc().coefficients)
    names = ("ROW_NUM", "ROW_DEN", "COL_NUM", "COL_DEN")
    terms = "".join(
        f"<{n}_{k + 1:02d}>{float(v)!r}</{n}_{k + 1:02d}>"
        for n, c in zip(names, rpc, strict=True)
        for k, v in enumerate(c)
    )
    places = "".join(f"<{n}_OFF>45</{n}_OFF><{n}_SCALE>45</{n}_SCALE>" for n in ("LONG", "LAT", "HEIGHT", "COL", "ROW"))
    bands = "".join(f'<bandID number="{k}">{terms}{places}</bandID>' for k in (1, 2))
    (place(top) / "a.xml").write_text(
        "<level_X><specific><mission>EnMAP</mission><widthOfScene>100</widthOfScene><heightOfScene>80</heightOfScene>"
        f"</specific><product><navigation><RPC>{bands}</RPC></navigation></product></level_X>"
    )


def sentinel1_seeds(top: Path) -> None:
    from tests.scenes.test_radar_files import annotation

    for k, kind in enumerate(("slant", "ground", "bursts")):
        (place(top, k) / "s1.xml").write_text(annotation(kind))


def product_seeds(top: Path) -> None:
    from tests.scenes.radar_products import Product, iceye, nitf, radarsat2, rcm, sicd, terrasar

    shapes = (Product(columns=40, rows=40), Product(columns=40, rows=40, ground=True, timed=True, polynomials=2))
    makers = (("product.xml", radarsat2), ("product.xml", rcm), ("TSX1.xml", terrasar))
    for k, (name, maker, shape) in enumerate((n, m, s) for n, m in makers for s in shapes):
        (place(top, k) / name).write_text(maker(shape))
    (place(top, 6) / "a.xml").write_text(sicd(shapes[0]))
    for k, shape in enumerate((Product(), Product(ground=True)), 8):
        (place(top, k) / "a.xml").write_text(iceye(shape))
    (place(top, 7) / "a.nitf").write_bytes(nitf(sicd(shapes[0])))


def esa_seeds(top: Path) -> None:
    from tests.scenes.esa_products import Esa, leader, n1

    for k, ground in enumerate((False, True)):
        small = {"columns": 60, "rows": 41, "line_s": 0.05, "ground": ground}
        (place(top, k) / "a.N1").write_bytes(n1(Esa(**small), "IMP" if ground else "IMS")[0])
        (place(top, k + 2) / "LEA_01.001").write_bytes(leader(Esa(single=False, **small))[0])


def radarsat1_seeds(top: Path) -> None:
    from tests.scenes.esa_products import Esa
    from tests.scenes.test_esa_products import radarsat1_files

    small = {"columns": 60, "rows": 21, "line_s": 0.1, "spacing_m": 12.5, "ground": True, "single": False}
    for k in (0, 1):
        radarsat1_files(place(top, k), Esa(**small), trailer=bool(k))


def hdf5_seeds(top: Path) -> None:
    from tests.scenes.hdf5_products import cosmo, iceye_hdf5, lengths_vary, nisar
    from tests.scenes.radar_products import Product

    small = {"columns": 40, "rows": 40, "vectors": 5}
    for k, maker in enumerate((cosmo, nisar, iceye_hdf5)):
        maker(place(top, k) / "a.h5", Product(**small if maker is not nisar else {}))
    cosmo(place(top, 3) / "a.h5", Product(ground=True, **small), mission="KMPS", mode="WIDE SWATH")
    iceye_hdf5(place(top, 4) / "a.h5", Product(ground=True, **small))
    lengths_vary(iceye_hdf5(place(top, 5) / "a.h5", Product(**small)), table="state_vector_time_utc")
    lengths_vary(cosmo(place(top, 6) / "a.h5", Product(**small)), "Look Side", "Lines Order", "Product Type")


def capella_seeds(top: Path) -> None:
    from tests.scenes.radar_products import Product
    from tests.scenes.test_capella import capella

    (place(top) / "a_extended.json").write_text(json.dumps(capella(Product(columns=40, rows=40, vectors=5))))


def optical_bar_seeds(top: Path) -> None:
    from tests.scenes.test_push_frame import bar

    bar(place(top, 0))


def read_a_scene(folder: Path) -> list[str]:
    from raybundle.io.scenes import read_scene

    leader = folder / "LEA_01.001"
    scene = read_scene(leader if leader.is_file() else only(folder, but=".csv"))
    wrong: list[str] = []
    if scene.rpc is not None:
        names = ("coefficients", "ground_offset", "ground_scale", "image_offset", "image_scale")
        wrong += not_finite(**{n: getattr(scene.rpc, n) for n in names})
        if not (scene.rpc.ground_scale.all() and scene.rpc.image_scale.all()):
            wrong.append("scale 0")
    if scene.rigorous is not None:
        with contextlib.suppress(RaybundleError):
            scene.rigorous.project(np.array([[11.0, 48.0, 0.0]]))
    return wrong


for _name, _seeds in (
    ("rpc-text", rpc_text_seeds), ("rpb", rpb_seeds), ("tiff", tiff_seeds), ("nitf", nitf_seeds),
    ("dimap", dimap_seeds), ("spot", spot_seeds), ("maxar", maxar_seeds), ("csm", csm_seeds),
    ("airborne", airborne_seeds), ("keys", keys_seeds), ("geom", geom_seeds), ("rpcm", rpcm_seeds),
    ("enmap", enmap_seeds), ("sentinel1", sentinel1_seeds), ("radar-isd", radar_isd_seeds),
    ("radar-products", product_seeds), ("esa-products", esa_seeds),
    ("hdf5", hdf5_seeds), ("capella", capella_seeds),
    ("radarsat1", radarsat1_seeds), ("optical-bar", optical_bar_seeds),
):  # fmt: skip
    target(f"scene-{_name}", _seeds, read_a_scene)


def control_seeds(top: Path) -> None:
    from tests.scenes.test_scene_control import geojson

    rng = np.random.default_rng(1)
    ground, xy = rng.uniform([10, 48, 300], [11, 49, 500], (4, 3)), rng.uniform(0, 1000, (4, 2))
    texts(
        {"c.geojson": json.dumps(geojson(ground, xy, image="a.tif", role="control", sX=0.1))},
        {"c.csv": "point,lon_deg,lat_deg,h_m,x_px,y_px\na,10.5,48.5,400,12.5,13\nb,10.6,48.5,400,112.5,13\n"},
        {"c.csv": "point,X,Y,Z,x_px,y_px,image,role\na,10.5,48.5,400,12.5,13,s.tif,check\n"},
    )(top)


def read_the_scene_control(folder: Path) -> list[str]:
    from raybundle.io.scenes.control import read_scene_control

    found = read_scene_control(only(folder))
    return not_finite(geographic=found.geographic, xy=found.xy_px)


target("scene-control", control_seeds, read_the_scene_control)


def trajectory_seeds(top: Path) -> None:
    from tests.io.trajectories.test_position_lists import META, POS
    from tests.io.trajectories.test_trajectories import MRK

    texts(
        {"flight_Timestamp.MRK": MRK},
        {"p.csv": "image,X,Y,Z,sX,sY,sZ\na,500000,5400000,1200,0.02,0.02,0.04\nb,500010,5400000,1200,0.02,0.02,0.04\n"},
        {"eo.csv": "image,X,Y,Z,omega_gon,phi_gon,kappa_gon,sX,sY,sZ\na,500000,5400000,1200,1,-2,100,0.02,0.02,0.04\n"},
        {"ins.csv": "image,X,Y,Z,roll_deg,pitch_deg,yaw_deg\na,500000,5400000,1200,0,0,0\n"},
        {"gim.csv": "image,longitude_deg,latitude_deg,height_m,roll_deg,pitch_deg,yaw_deg\na,11.2,48.1,1200,0,0,0\n"},
        {"geo.txt": "EPSG:32633\na.jpg 500010.5 5400020.25 450 12 0 1 0.02 0.03\nb.jpg 500020.5 5400020.25 450\n"},
        {"list.csv": f'# CoordinateSystem: "EPSG:4326"\n{META}a.jpg,8.25,47.5,450,1,2,3,0.1,0.1,8.2,47.4,449\n'},
        {"flight_events.pos": f"% (lat/lon/height=WGS84/ellipsoidal,Q=1:fix,2:float)\n{POS['date']}"},
    )(top)


def read_a_trajectory(folder: Path) -> list[str]:
    from raybundle.io.trajectories import read_trajectory

    found = read_trajectory(only(folder))
    wrong = ["xyz"] if np.isinf(found.xyz).any() else []
    return wrong + (["sigma"] if np.isinf(found.sigma).any() or (found.sigma < 0).any() else [])


target("trajectory", trajectory_seeds, read_a_trajectory)


def trajectory_texts() -> dict[str, list[dict[str, str]]]:
    """Files of each format of positions and attitudes."""
    from tests.io.trajectories.exterior_lists import lists
    from tests.io.trajectories.test_position_lists import GEO_TXT, POS, TABLES
    from tests.io.trajectories.test_trajectories import MRK

    forms = {k: {f: d.decode("latin-1") if k == "degree signs" else d.decode()} for k, (f, d, *_) in lists().items()}
    ecef = "%  GPST  x-ecef(m)  y-ecef(m)  z-ecef(m)  Q  ns\n2312 295200.237 4273000.0 619500.0 4680000.0 2 9\n"
    place, at = "image,X,Y,Z", "a,500000,5400000,1200"
    return {
        "mrk": [{"flight_Timestamp.MRK": MRK}],
        "positions": [{"p.csv": f"{place},sX,sY,sZ\n{at},0.02,0.02,0.04\n{at.replace('a', 'b')},0.02,0.02,0.04\n"}],
        "opk": [{"eo.csv": f"{place},omega_gon,phi_gon,kappa_gon,sX,sY,sZ\n{at},1,-2,100,0.02,0.02,0.04\n"}],
        "rpy": [
            {"ins.csv": f"{place},roll_deg,pitch_deg,yaw_deg\n{at},0,0,0\n"},
            {"gim.csv": "image,longitude_deg,latitude_deg,height_m,roll_deg,pitch_deg,yaw_deg\na,11,48,12,0,0,0\n"},
        ],
        "geo-txt": [{"geo.txt": text} for text, *_ in GEO_TXT.values()],
        "image-list": [{"list.csv": text} for text, *_ in TABLES.values()],
        "exterior-list": [t for k, t in forms.items() if not k.startswith(("PATB", "BINGO", "Inpho"))],
        "patb-ori": [forms["PATB, three lines"]],
        "bingo-oria": [forms["BINGO"]],
        "inpho": [forms["Inpho"]],
        "rtklib": [{"a_events.pos": text} for text in (*POS.values(), ecef)],
    }


def trajectory_target(name: str, seeds: list[dict[str, str]]) -> None:
    """A format by its name: a file whose beginning is damaged is read, too."""

    def read(folder: Path) -> list[str]:
        from raybundle.io.trajectories import read_trajectory

        found = read_trajectory(only(folder), name=name)
        count = len(found)
        wrong = [n for n in ("xyz", "sigma") if getattr(found, n).shape != (count, 3)]
        wrong += ["xyz"] if np.isinf(found.xyz).any() else []
        wrong += ["sigma"] if np.isinf(found.sigma).any() or (found.sigma < 0).any() else []
        wrong += ["names"] if len({*found.names}) < count or "" in found.names else []
        wrong += ["lines"] if len(found.lines) not in {0, count} or len(found.fix) not in {0, count} else []
        c = found.correlation
        return wrong + (["correlation"] if c is not None and (np.abs(c) > 1).any() else [])

    target(f"trajectory-{name}", texts(*seeds), read)


for _name, _seeds in trajectory_texts().items():
    trajectory_target(_name, _seeds)
