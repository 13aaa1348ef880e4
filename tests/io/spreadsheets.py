"""Readers of tables that users bring, each with a good file of its own, for tests that write it as spreadsheets do.

A module that reads such a table registers itself here by an entry; a test fails where one is missing.
"""

from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path

import numpy as np


@dataclass(frozen=True, kw_only=True)
class Reader:
    """A reader of tables."""

    module: str
    """Where it is, under raybundle"""
    files: dict[str, str]
    """Good files by name; those that end in .csv are tables"""
    read: Callable[[Path], object]
    """Values from the folder with the files"""


def control(folder):
    from raybundle.io.geo.control_files import read_control

    c = read_control(folder / "c.csv")
    m = c.measurements
    return c.ids, c.xyz, c.sigma, c.role, c.radius, c.normal, c.reported, m.image, m.point, m.xy_px


def marks(folder):
    from raybundle.io.geo.control_files import read_control

    return read_control(folder / "m.csv").measurements.xy_px


def calibrated(folder):
    from raybundle.io.film.fiducials import read_calibrated

    found = read_calibrated(folder / "c.csv")
    return found.names, found.xy_mm, found.sigma_mm


def film_marks(folder):
    from raybundle.io.film.fiducials import read_marks

    found = read_marks(folder / "m.csv", "point")
    return found.image, found.name, found.xy_px, found.sigma_px


def trajectory(folder):
    from raybundle.io.trajectories.base import read_trajectory

    t = read_trajectory(folder / "t.csv")
    rotation = np.zeros(0) if t.rotation is None else t.rotation
    return t.names, t.xyz, t.sigma, rotation, t.crs


def scene_control(folder):
    from raybundle.io.scenes.control import read_scene_control

    c = read_scene_control(folder / "g.csv")
    return c.ids, c.geographic, c.xy_px, c.sigma_m, c.check


def grid_scene_control(folder):
    from raybundle.io.scenes.control import read_scene_control

    c = read_scene_control(folder / "g.csv", crs="EPSG:32633+ellipsoid")
    return c.ids, c.geographic, c.xy_px, c.check


def strip(folder):
    from raybundle.io.block.toml_section import read_toml
    from raybundle.io.scenes import airborne

    top = read_toml(folder / "s.toml")
    t = airborne._table(folder / "t.csv", "both")
    return (
        t.xyz, t.sigma, t.rotation, t.time, *airborne._look(top.section("lens"), 100),
        *airborne._lines(top.section("lines"), 100),
    )  # fmt: skip


def empirical(folder):
    from raybundle.commands.empirical import read_points

    p = read_points(folder / "p.csv")
    return p.ids, p.xyz, p.xy_px, p.check


def photograph_list(folder):
    from raybundle.commands.planning.check_list import _rows

    return _rows(folder / "l.csv")


def stations(folder):
    from raybundle.commands.planning.network import stations_of

    s = stations_of(folder / "s.csv")
    return s.centre, s.at, s.roll


def lengths(folder):
    from raybundle.commands.measure_files import known_lengths

    return known_lengths(folder / "l.csv", 1.0)


def nominal(folder):
    from raybundle.commands.measure_files import nominal_points

    n = nominal_points(folder / "n.csv", 1.0)
    return n.ids, n.xyz, n.tolerance, n.sigma


def projected(folder):
    from raybundle.commands.rpc import _table

    return _table(folder / "p.csv", ("lon_deg", "lat_deg", "h_m"))


def outline(folder):
    from raybundle.io.outlines import read_outline

    return read_outline(folder / "o.csv")


def codes(folder):
    from raybundle.targets.codes import read_table

    return dict(read_table(folder / "r.csv", 12).table)


READERS = {
    "control": Reader(
        module="io/geo/control_files.py", read=control,
        files={
            "c.csv": "point,X,Y,Z,sX,sY,sZ,role,radius,nX,nY,nZ,tolerance\n"
                     "Münze,235269.881,3811198.119,12.5,0.01,0.01,0.02,"
                     "control,0.005,0,0.6,0.8,\nB,235262.5,3811203.25,,,,,check,,,,,0.25\n",
            "c-measurements.csv": "image,point,x_px,y_px\n1.jpg,Münze,812.5,410.0\n2.jpg,B,799,512.125\n",
        },
    ),
    "marks": Reader(
        module="io/geo/control_files.py", read=marks,
        files={"m.csv": "image,point,x_px,y_px\n1.jpg,é,812.5,410.0\n2.jpg,é,799,512.125\n"},
    ),
    "calibrated": Reader(
        module="io/film/fiducials.py", read=calibrated,
        files={"c.csv": "mark,x_mm,y_mm,sx_mm,sy_mm\nü,-105.998,0.012,0.002,0.002\nb,106.002,-1e-3,0.002,0.002\n"},
    ),
    "film marks": Reader(
        module="io/film/fiducials.py", read=film_marks,
        files={"m.csv": 'image,point,x_px,y_px,sx_px,sy_px\n"s, 1",ä,812.5,41.25,0.3,0.3\ns2,ä,799,512.125,,\n'},
    ),
    "positions": Reader(
        module="io/trajectories/position_csv.py", read=trajectory,
        files={"t.csv": "image,X,Y,Z,sX,sY,sZ\nÖ.jpg,1000.125,2000.5,100.25,0.05,0.05,0.1\nb.jpg,1010,20.75,100,,,\n"},
    ),
    "angles": Reader(
        module="io/trajectories/angle_csv.py", read=trajectory,
        files={
            "t.csv": "image,longitude_deg,latitude_deg,height_m,omega_deg,phi_deg,kappa_deg,somega_deg,sphi_deg,"
                     "skappa_deg\n"
                     "ö.jpg,13.123456789,45.25,100.25,0.5,-0.25,90.125,0.01,0.01,0.02\nb.jpg,13.2,45.5,101,1,2,3,0.01,0.01,0.02\n",
        },
    ),
    "gimbal": Reader(
        module="io/trajectories/angle_csv.py", read=trajectory,
        files={
            "t.csv": "image,X,Y,Z,roll_deg,pitch_deg,yaw_deg\nô.jpg,1.5,2.5,3.5,0.5,-0.25,90.125\nb.jpg,2,3,4,1,2,3\n",
        },
    ),
    "scene control": Reader(
        module="io/scenes/control.py", read=scene_control,
        files={
            "g.csv": "point,lon_deg,lat_deg,h_m,x_px,y_px,sE_m,sN_m,sU_m,role\n"
                     "å,13.125,45.25,100.5,812.5,410.25,0.1,0.1,0.2,\n"
                     "b,13.25,45.5,99,8000,41,0.1,0.1,0.2,check\n",
        },
    ),
    "scene control in a grid": Reader(
        module="io/scenes/control.py", read=grid_scene_control,
        files={"g.csv": "point,X,Y,Z,x_px,y_px\nå,500000.5,5000000.25,100.5,812.5,410.25\nb,500100,5000100,99,80,41\n"},
    ),
    "strip": Reader(
        module="io/scenes/airborne.py", read=strip,
        files={
            "s.toml": '[lens]\nc_mm = 60.0\ndetector = "d.csv"\n[lines]\ntable = "y.csv"\n',
            "d.csv": "x_px,x_mm,y_mm\n0,-3.5,0.01\n100,3.5,0.02\n", "y.csv": "y_px,time_s\n0.5,10.25\n99.5,12.5\n",
            "t.csv": "time_s,longitude_deg,latitude_deg,height_m,sX,sY,sZ,omega_deg,phi_deg,kappa_deg\n"
                     "10,13.125,45.25,1200.5,0.05,0.05,0.1,0.5,0.25,30\n13.5,13.25,45.3,1201,0.05,0.05,0.1,0.5,0.25,30.5\n",
        },
    ),
    "empirical": Reader(
        module="commands/empirical.py", read=empirical,
        files={"p.csv": "point,X,Y,Z,x_px,y_px,role\nß,10.5,20.25,0.5,300.125,400,\nb,11,21,1,310,410.5,check\n"},
    ),
    "list of photographs": Reader(
        module="commands/planning/check_list.py", read=photograph_list,
        files={"l.csv": 'image,group,see,how,taken\n1,side 1,"wall, left",level,x\n2,side 1,wall,level,\n'},
    ),
    "stations": Reader(
        module="commands/planning/network.py", read=stations,
        files={
            "s.csv": "image,X,Y,Z,at_X,at_Y,at_Z,azimuth_deg,elevation_deg,roll_deg,points,what_for\n"
                     "é,0.5,1.25,2,0,5.5,2,0,0,90.5,12,all\nb,1.5,1.25,2,0,5.5,2,0,0,0,12,\n",
        },
    ),
    "lengths": Reader(
        module="commands/measure_files.py", read=lengths,
        files={"l.csv": "from,to,length,sigma\nä,b,1.0003,0.0001\nb,c,2,\n"},
    ),
    "nominal": Reader(
        module="commands/measure_files.py", read=nominal,
        files={"n.csv": "point,X,Y,Z,sX,sY,sZ,tolerance\nø,1.5,2.25,3,0.01,0.01,0.01,0.1\nb,2,3,4.5,,,,\n"},
    ),
    "projected": Reader(
        module="commands/rpc.py", read=projected,
        files={"p.csv": "point,lon_deg,lat_deg,h_m\nþ,13.125,45.25,100\nb,13.25,45.5,99.5\n"},
    ),
    "outline": Reader(module="io/outlines.py", read=outline, files={"o.csv": "x,y\n1.5,2.25\n3,4.5\n5.5,6\n"}),
    "codes": Reader(module="targets/codes.py", read=codes, files={"r.csv": "id,code\n1,21\n2,23\n"}),
}  # fmt: skip
