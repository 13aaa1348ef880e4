"""Invented lists of exterior orientations as aerial firms write them, of one block of a large frame camera."""

from dataclasses import dataclass, replace
from functools import cache

import numpy as np

from raybundle.io.geo.coordinate_systems import local_frame
from raybundle.numerics.attitude import GON, opk_from_rotation, pok_from_rotation, rotation_from_opk, rotation_from_pok
from raybundle.planning.flights.uav_networks import Flight, flight_block
from raybundle.planning.synthetic_networks import brown_camera

UTM = "EPSG:25832+ellipsoid"
PLACE = (430_000.0, 5_400_000.0, 500.0)
UNITS = {"deg": np.pi / 180, "gon": GON, "rad": 1.0}
MAKE = {"opk": (opk_from_rotation, rotation_from_opk), "pok": (pok_from_rotation, rotation_from_pok)}


@cache
def dmc():
    """A nadir block of 13824 x 7680 px of 12 um, c = 120 mm, 1500 m above ground, lines flown to and fro."""
    values = dict.fromkeys(("x0", "y0", "K1", "K2", "K3", "P1", "P2", "A", "S"), 0.0)
    camera = brown_camera(values={"c": 120.0, **values}, size_px=(13824, 7680), pixel_mm=0.012, estimate=())
    flight = Flight(
        camera=camera, height=1500.0, lines=3, photographs=4, spacing=1000.0, base=450.0, size=2400.0, length=2000.0,
        points=14, alternating=True, angle_jitter_deg=2.0, relief=0.05, image_sigma_px=0.3,
        station_sigma=(0.05, 0.05, 0.08),
    )  # fmt: skip
    block = flight_block(flight)
    names = tuple(f"DMC_{1001 + k}" for k in range(len(block.images)))
    return replace(block, images=replace(block.images, ids=names))


@cache
def frame():
    return local_frame(UTM, PLACE)


@dataclass
class Orientations:
    """Places in the grid and rotations against it, as far as a file has their digits."""

    names: tuple[str, ...]
    xyz: np.ndarray
    angles: np.ndarray
    rotation: np.ndarray


def orientations(order="opk", unit="deg", *, places=9, digits=13, full=0.0):
    """The block's orientations as numbers of a file; full: angles below 0 get a full circle."""
    block = dmc()
    xyz = np.round(frame().crs_from_local(block.images.centre), places)
    R = block.images.rotation @ np.swapaxes(frame().crs_from_local_rotation(xyz), 1, 2)
    back, forth = MAKE[order]
    angles = back(R) / UNITS[unit]
    angles = np.round(np.where(angles < 0, angles + full, angles), digits)
    return Orientations(block.images.ids, xyz, angles, forth(angles * UNITS[unit]))


def rows(o, separator=" ", *, places=9, digits=13, comma=False, name="{}.tif", columns=None, extra=()):
    """Lines name, X, Y, Z, angles, and more numbers; columns: their order."""
    lines = []
    for k, n in enumerate(o.names):
        cells = [name.format(n), *(f"{v:.{places}f}" for v in o.xyz[k]), *(f"{v:.{digits}f}" for v in o.angles[k])]
        cells += [f"{v:.6f}" for v in extra]
        if comma:
            cells[1:] = [c.replace(".", ",") for c in cells[1:]]
        lines.append(separator.join([cells[c] for c in columns] if columns else cells))
    return "\n".join(lines) + "\n"


def fixed(o, widths=(11, 12, 9, 10, 10, 9)):
    """Lines in columns that may touch: 3 decimals of places, 5 of angles."""
    lines = []
    for k, n in enumerate(o.names):
        cells = [f"{v:{w}.3f}" for v, w in zip(o.xyz[k], widths[:3], strict=True)]
        cells += [f"{v:{w}.5f}" for v, w in zip(o.angles[k], widths[3:], strict=True)]
        lines.append(f"{n:<12}" + "".join(cells))
    return "\n".join(lines) + "\n"


def matrices(o, *, inverse=False):
    return np.swapaxes(o.rotation, 1, 2) if inverse else o.rotation


def of_matrices(o, separator=" ", *, inverse=False):
    R = matrices(o, inverse=inverse).reshape(-1, 9)
    return "".join(
        separator.join([n, *(f"{v:.9f}" for v in x), *(f"{v:.15f}" for v in r)]) + "\n"
        for n, x, r in zip(o.names, o.xyz, R, strict=True)
    )


def patb(o, *, inverse=True):
    R = matrices(o, inverse=inverse).reshape(-1, 9)
    return "".join(
        f"{n:>16}" + "".join(f"{v:20.9f}" for v in x) + "\n" + "".join(f"{v:19.15f}" for v in r[:5]) + "\n"
        + "".join(f"{v:19.15f}" for v in r[5:]) + "\n"
        for n, x, r in zip(o.names, o.xyz, R, strict=True)
    ) + "-99\n"  # fmt: skip


def bingo(o):
    lines = rows(o, name="{}").splitlines()
    return "C adjusted\n" + "".join(f"ORIA {t}\n" for t in lines) + "COOR 12 430000.0 5400000.0 500.0\n"


def inpho(o, *, inverse=False):
    text = "$PROJECT 6.0.0\n  $ANGULAR_UNITS : deg\n$END\n"
    for n, x, R in zip(o.names, o.xyz, matrices(o, inverse=inverse), strict=True):
        text += f"$PHOTO\n  $PHOTO_NUM : {n}\n  $PHOTO_FILE : D:/images/{n}.tif\n  $CAMERA_ID : DMC\n"
        text += "  $EXT_ORI : 12:00:00 01/05/2026\n     120.0 " + " ".join(f"{v:.9f}" for v in x) + "\n"
        text += "".join("     " + " ".join(f"{v:.15f}" for v in r) + "\n" for r in R) + "$END\n"
    return text + "$STRIP\n  $STRIP_ID : 1\n$END\n"


NAMES = "name X Y Z omega phi kappa"
POSPAC = (
    "POS Exterior Orientation Computation Utility\nMapping frame projection : UTM;\n"
    "Sequence of the rotation from mapping to image frame:\nFirst rotation is about the '{0}' axis by '{1}' angle.\n"
    "Boresight values: tx = 0.1000 arc min, ty = 0.2000 arc min\n\n"
    "ID, TIME (s), EASTING, NORTHING, ELLIPSOID HEIGHT, OMEGA, PHI, KAPPA\n"
    "    (s)   (m)   (m)   (m)   (deg)   (deg)   (deg)\n\n"
)
POSEO = "(position in Meters, orientation in Degrees, lat, long in Deg)\n\n"
TIMED = [0, 7, 1, 2, 3, 4, 5, 6]


def geographic():
    """Longitude and latitude, the attitude against east, north, up there."""
    block = dmc()
    place = np.round(frame().wgs84_from_local(block.images.centre), 12)
    R = block.images.rotation @ np.swapaxes(np.swapaxes(frame().local_from_enu(
        frame().crs_from_local(block.images.centre)), 1, 2), 1, 2)  # fmt: skip
    angles = np.round(np.degrees(opk_from_rotation(R)), 13)
    return Orientations(block.images.ids, place, angles, rotation_from_opk(np.radians(angles)))


def lists():
    """Name of a form: file, bytes, the orientations and the reading that is right."""
    deg, gon, rad = (orientations(unit=u) for u in UNITS)
    pok, pok_deg = orientations("pok", "gon"), orientations("pok", "deg")
    full, short = orientations(unit="gon", full=400.0), orientations(places=3, digits=5, full=360.0)
    head = NAMES.split()

    def table(separator, names=None):
        return separator.join(names or head) + "\n"

    found = {
        "degrees in brackets": ("a.txt", "name X Y Z omega[deg] phi[deg] kappa[deg]\n" + rows(deg), deg, "opk-deg"),
        "gon in brackets": ("a.csv", "Image,X (m),Y (m),Z (m),Omega (gon),Phi (gon),Kappa (gon)\n"
                            + rows(gon, ","), gon,
                            "opk-gon"),
        "radians": ("a.eo", table(";", [*head[:4], "omega_rad", "phi_rad", "kappa_rad"]) + rows(rad, ";"), rad,
                    "opk-rad"),
        "semicolons, decimal commas": ("a.csv", table(";", [*head[:4], "omega_deg", "phi_deg", "kappa_deg"])
                                       + rows(deg, ";", comma=True), deg, "opk-deg"),
        "tabs, decimal commas": ("a.txt", table("\t", [*head[:4], "omega (gon)", "phi (gon)", "kappa (gon)"])
                                 + rows(gon, "\t", comma=True), gon, "opk-gon"),
        "blanks, decimal commas": ("a.txt", "name X Y Z omega[gon] phi[gon] kappa[gon]\n" + rows(gon, comma=True), gon,
                                   "opk-gon"),
        "full circle of gon": ("a.txt", table(" ") + rows(full), full, "opk-gon"),
        "names alone, degrees": ("a.txt", table(" ") + rows(deg), deg, "opk-deg"),
        "names alone, gon": ("a.txt", table(" ") + rows(gon), gon, "opk-gon"),
        "names alone, radians": ("a.txt", table(" ") + rows(rad), rad, "opk-rad"),
        "phi omega kappa": ("a.txt", "name X Y Z phi[gon] omega[gon] kappa[gon]\n" + rows(pok), pok, "pok-gon"),
        "phi in front of omega only": ("a.txt", "name X Y Z phi[deg] omega[deg] kappa[deg]\n"
                                       + rows(deg, columns=[0, 1, 2, 3, 5, 4, 6]), deg, "opk-deg"),
        "UltraMap": ("cam0.txt", "# Camera; Session; Nr; X; Y; Z; Rot_X; Rot_Y; Rot_Z;\n"
                     + "".join(f"0; 1; {t};\n" for t in rows(deg, "; ", name="{}").replace("DMC_", "").splitlines()),
                     deg, "opk-deg"),
        "Applanix POSEO": ("eo.txt", POSEO + "ID\t# EVENT\tTIME(s)\tEASTING\tNORTHING\tELLIPSOID HEIGHT\tOMEGA\tPHI\t"
                           "KAPPA\tLAT\tLONG\n" + rows(deg, "\t", name="{}\t3\t564155.65", extra=(48.7, 8.0)), deg,
                           "opk-deg"),
        "Applanix POSEO, events": ("eo.txt", POSEO + "# EVENT  TIME (s)  EASTING  NORTHING  ELLIPSOID HEIGHT  OMEGA  "
                                   "PHI  KAPPA\n" + rows(deg, "  ", name="{} 564155.65").replace("DMC_", ""), deg,
                                   "opk-deg"),
        "POSPac": ("eo.txt", POSPAC.format("x", "omega") + rows(deg, "  ", name="{} 564155.65"), deg, "opk-deg"),
        "POSPac, phi primary": ("eo.txt", POSPAC.format("y", "phi")
                                + rows(pok_deg, "  ", name="{} 564155.65", columns=[0, 1, 2, 3, 5, 4, 6]), pok_deg,
                                "pok-deg"),
        "Match-AT list": ("at.txt", "# PHOTO x y z omega phi kappa\n# [m] [m] [m] [deg] [deg] [deg]\n"
                          + rows(deg, "   ", name="{}"), deg, "opk-deg"),
        "Greek letters": ("a.txt", "Bild X0 Y0 Z0 ω[gon] φ[gon] κ[gon]\n" + rows(gon), gon, "opk-gon"),
        "degree signs": ("a.csv", ("Bild;Rechtswert;Hochwert;Höhe;Omega[°];Phi[°];Kappa[°]\n"
                                   + rows(deg, ";", comma=True)).encode("cp1252"), deg, "opk-deg"),
        "unit in a title": ("a.csv", "Äußere Orientierung, Winkel in gon\n"
                            "Bild;Rechtswert;Hochwert;Höhe;Omega;Phi;Kappa\n"
                            + rows(gon, ";", comma=True), gon, "opk-gon"),
        "standard deviations": ("a.csv", "name,X,Y,Z,Omega[deg],Phi[deg],Kappa[deg],sX,sY,sZ,sOmega,sPhi,sKappa\n"
                                + rows(deg, ",", extra=(0.02, 0.02, 0.03, 0.002, 0.003, 0.004)), deg, "opk-deg"),
        "kappa first": ("a.csv", "name,kappa[deg],omega[deg],phi[deg],X,Y,Z\n"
                        + rows(deg, ",", columns=[0, 6, 4, 5, 1, 2, 3]), deg, "opk-deg"),
        "name last": ("a.csv", "Easting,Northing,Height,Omega[deg],Phi[deg],Kappa[deg],ImageName\n"
                      + rows(deg, ",", columns=[1, 2, 3, 4, 5, 6, 0]), deg, "opk-deg"),
        "Metashape": ("a.txt", "# CoordinateSystem: EPSG:25832\n#Label,X/Easting,Y/Northing,Z/Altitude,"
                      "Omega,Phi,Kappa\n" + rows(deg, ",", name="{}"), deg, "opk-deg"),
        "geographic": ("a.txt", "photo longitude latitude height omega(deg) phi(deg) kappa(deg)\n"
                       + rows(geographic(), places=12), geographic(), "opk-deg"),
        "a mark, CR LF, capitals": ("A.TXT", ("\ufeff" + "NAME X Y Z OMEGA(DEG) PHI(DEG) KAPPA(DEG)\n"
                                             + rows(deg)).replace("\n", "\r\n"), deg, "opk-deg"),
        "separators at the end": ("a.csv", rows(deg, ";").replace("\n", ";\n"), deg, "opk-deg"),
        "elements with names": ("a.txt", "name X Y Z r11 r12 r13 r21 r22 r23 r31 r32 r33\n" + of_matrices(deg), deg,
                                "matrix"),
        "quoted names": ("a.csv", '"name","X","Y","Z","omega [gon]","phi [gon]","kappa [gon]"\n'
                         + rows(gon, ",", name='"{}.tif"'), gon, "opk-gon"),
        "no names, degrees": ("a.txt", rows(deg), deg, "opk-deg"),
        "no names, gon, phi primary": ("a.ori", rows(pok, columns=[0, 1, 2, 3, 4, 5, 6]), pok, "pok-gon"),
        "no names, radians, commas": ("a.csv", rows(rad, ","), rad, "opk-rad"),
        "no names, names with blanks": ("a.txt", rows(deg, name="my {}.tif"), deg, "opk-deg"),
        "columns that touch": ("a.txt", fixed(short), short, "opk-deg"),
        "title above numbers": ("a.txt", "Block 12: omega phi kappa in gon\n" + rows(gon, "  "), gon, "opk-gon"),
        "title, phi primary": ("a.txt", "angles phi omega kappa [deg]\n" + rows(pok_deg, "  "), pok_deg, "pok-deg"),
        "elements without names": ("a.txt", of_matrices(deg, inverse=True), deg, "matrix-inverse"),
        "PATB, three lines": ("block.ori", patb(deg), deg, "matrix-inverse"),
        "PATB, three lines, the other sense": ("block.ori", patb(deg, inverse=False), deg, "matrix"),
        "BINGO": ("itera.dat", bingo(pok), pok, "pok-gon"),
        "BINGO with omega first": ("itera.dat", bingo(gon), gon, "opk-gon"),
        "Inpho": ("a.prj", inpho(deg), deg, "matrix"),
        "Inpho, the other sense": ("a.prj", inpho(deg, inverse=True), deg, "matrix-inverse"),
    }  # fmt: skip
    return {k: (f, t if isinstance(t, bytes) else t.encode(), o, r) for k, (f, t, o, r) in found.items()}


def refused():
    """Name of a form: file, text, the code of the refusal, and the column that it names."""
    deg = orientations()
    text = rows(deg)
    touching = fixed(orientations(places=3, digits=5), widths=(10, 11, 9, 11, 11, 11))
    head = NAMES + "\n"
    first = text.splitlines()[0]
    return {
        "feet": ("a.txt", head.replace("X Y", "X[ft] Y[ft]") + text, "image_list.unit", "X[ft]"),
        "angles of no unit": ("a.txt", head + first.rpartition(" ")[0] + " 512.5\n", "exterior_list.angle_size",
                              "kappa"),
        "columns without names": ("a.txt", first + "\n" + first + " 1 2\n", "exterior_list.columns", "8"),
        "letters": ("a.txt", head + first.replace(".", "x", 2) + "\n", "value.not_finite", None),
        "degrees, minutes": ("a.txt", head + first.rpartition(" ")[0] + " 12°30'10\"\n", "value.not_finite", "kappa"),
        "no rotation": ("a.txt", first.rsplit(" ", 3)[0] + " 1 0 0 0 2 0 0 0 1\n", "rotation.not_orthogonal",
                        "5 6 7 8 9 10 11 12 13"),
        "numbers that touch": ("a.txt", touching, "exterior_list.touching", "2"),
        "Inpho, cut off": ("a.prj", inpho(deg).split("$END\n")[1], "inpho.not_closed", None),
        "PATB, cut off": ("a.ori", "\n".join(patb(deg).splitlines()[:5]), "patb.rotation_missing", None),
    }  # fmt: skip
