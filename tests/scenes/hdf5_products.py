"""HDF5 products of the layouts that the vendors specify; independent of their readers.

COSMO-SkyMed: ASI-CSM-PMG-NT-001, tables of attributes (KOMPSAT-5 has the same, its mission KMPS); CSG: IMG for SBI.
NISAR: JPL D-102268, RSLC.  ICEYE: the names of its XML, state vectors as tables.
"""

import re

import numpy as np

from tests.scenes.radar_products import START, TARGET, C, Product, centre_of, iceye

REFERENCE_S = 43200.0
"""Times of COSMO-SkyMed count from so many seconds before the middle of the image."""


def corner(p, late, far):
    return [p.columns - 1 if far == p.near_first else 0, p.rows - 1 if late == p.forwards else 0]


def cosmo(path, p, *, mission="CSK", kind=None, mode="HIMAGE", ellipsoid="WGS84", swaths=1, reference_m=0.0):
    import h5py

    kind = kind or ("DGM_B" if p.ground else "SCS_B")
    edges = p.first_s + REFERENCE_S + np.array([0.0, (p.rows - 1) * p.line_s * (1 if p.forwards else -1)])
    ranges = p.near_m + (p.columns - 1) * p.spacing_m * np.array([0.0, 1.0])
    if p.ground:
        ranges = p.slant((p.columns - 1) * p.spacing_m * np.array([0.0, 1.0]), np.zeros(2))
    t, P, V = p.table()
    with h5py.File(path, "w") as file:
        texts = {
            "Mission ID": mission, "Satellite ID": f"{mission}1", "Product Type": kind, "Acquisition Mode": mode,
            "Look Side": "RIGHT" if p.side > 0 else "LEFT", "Ellipsoid Designator": ellipsoid,
            "Lines Order": "EARLY-LATE" if p.forwards else "LATE-EARLY",
            "Columns Order": "NEAR-FAR" if p.near_first else "FAR-NEAR",
            "Scene Sensing Start UTC": f"{START}000".replace("T", " "),
            "Reference UTC": "2023-05-06 05:06:00.000000000",
        }  # fmt: skip
        for name, text in texts.items():
            file.attrs[name] = np.bytes_(text)
        file.attrs["State Vectors Times"] = t + REFERENCE_S
        file.attrs["ECEF Satellite Position"], file.attrs["ECEF Satellite Velocity"] = P, V
        file.attrs["Scene Centre Geodetic Coordinates"] = [TARGET[1], TARGET[0], TARGET[2]]
        if p.ground:
            c = p.sets()[1][0] * p.spacing_m ** np.arange(4)
            file.attrs["Ground Projection Polynomial Reference Range"] = c[0] + reference_m
            file.attrs["Ground to Slant Polynomial"] = [-reference_m, *c[1:], 0.0, 0.0]
        scansar = p.ground and mode in {"WIDEREGION", "WIDE SWATH"}
        for k in range(swaths):
            swath = file.create_group(f"S{k + 1:02}")
            swath.attrs["Polarisation"] = np.bytes_("HH")
            swath.create_group("B001")
            if not scansar or k == 0:
                name = "MBI" if scansar else f"S{k + 1:02}/{'IMG' if mission == 'CSG' else 'SBI'}"
                shape = (p.rows, p.columns) if p.ground else (p.rows, p.columns, 2)
                image = file.create_dataset(name, shape, "i2", chunks=(1, *shape[1:]))
                image.attrs["Zero Doppler Azimuth First Time"] = edges[0]
                image.attrs["Zero Doppler Azimuth Last Time"] = edges[1]
                both = ranges[:: 1 if p.near_first else -1] * 2 / C
                image.attrs["Zero Doppler Range First Time"], image.attrs["Zero Doppler Range Last Time"] = both
                image.attrs["Column Spacing"], image.attrs["Line Spacing"] = p.spacing_m, 3.3
                image.attrs["Line Time Interval"] = p.line_s
                if not p.ground:
                    image.attrs["Column Time Interval"] = 2 * p.spacing_m / C
                    for late in (0, 1):
                        for far in (0, 1):
                            lon, lat, h = centre_of(p, corner(p, late, far))[0].tolist()
                            name = f"{('Near', 'Far')[far]} {('Early', 'Late')[late]} Geodetic Coordinates"
                            image.attrs[name] = [lat, lon, h]
    return path


def nisar(path, p, *, group="RSLC", bands="A", epsg=4326, geolocation=True):
    """A product whose state vectors count from another date than its lines."""
    import h5py
    from pyproj import Transformer

    x, y = np.arange(p.columns), np.arange(p.rows)
    times = 61560.0 + p.first_s + y * p.line_s * (1 if p.forwards else -1)
    ranges = p.near_m + p.spacing_m * (x if p.near_first else x[::-1])
    t, P, V = p.table()
    with h5py.File(path, "w") as file:
        radar = file.create_group("science/LSAR")
        for name, text in (("lookDirection", "Right" if p.side > 0 else "left"), ("missionId", "NISAR"),
                           ("productType", group), ("zeroDopplerStartTime", str(START))):  # fmt: skip
            radar[f"identification/{name}"] = np.bytes_(text)
        product = radar.create_group(group)
        for band in bands:
            product[f"swaths/frequency{band}/slantRange"] = ranges + (0.0 if band == "A" else 1.0)
        product["swaths/zeroDopplerTime"] = times
        product["swaths/zeroDopplerTime"].attrs["units"] = np.bytes_("seconds since 2023-05-06 00:00:00")
        product["metadata/orbit/time"] = t + 61560.0 + 86400.0
        product["metadata/orbit/time"].attrs["units"] = np.bytes_("seconds since 2023-05-05T00:00:00")
        product["metadata/orbit/position"], product["metadata/orbit/velocity"] = P, V
        product["metadata/processingInformation/parameters/referenceTerrainHeight"] = np.full(3, 300.0)
        if geolocation:
            geographic, _, _, xy = p.truth(9, 7)
            grid = product.create_group("metadata/geolocationGrid")
            lon, lat = geographic[:, 0], geographic[:, 1]
            if epsg != 4326:
                lon, lat = Transformer.from_crs(4326, epsg, always_xy=True).transform(lon, lat)
            axes = (
                ranges[0] + (xy[:, 0] - 0.5) * (ranges[1] - ranges[0]),
                times[0] + (xy[:, 1] - 0.5) * (times[1] - times[0]),
            )
            # every point has an own height, time and range: all others of the cube are unknown
            cube = np.full((2, 9, 9, 9), np.nan)
            order = [np.argsort(np.argsort(v)) for v in (geographic[:, 2], axes[1], axes[0])]
            cube[:, order[0], order[1], order[2]] = lon, lat
            grid["heightAboveEllipsoid"], grid["epsg"] = np.sort(geographic[:, 2]), epsg
            grid["slantRange"], grid["zeroDopplerTime"] = np.sort(axes[0]), np.sort(axes[1])
            grid["coordinateX"], grid["coordinateY"] = cube
    return path


def iceye_hdf5(path, p):
    """The values of the XML as tables."""
    import h5py

    xml = iceye(p)
    t, P, V = p.table()
    with h5py.File(path, "w") as file:
        for name, text in re.findall(r"<(\w+)>([^<>]+)</\1>", xml):
            if name.startswith("coord_"):
                file[name] = np.array(text.split(), float)
            elif re.fullmatch(r"[-+.\de]+", text) and name not in {"time", "count", *VECTOR}:
                file[name] = int(text) if text.isdecimal() else float(text)
            elif name in {
                "product_name",
                "satellite_name",
                "look_side",
                "zerodoppler_start_utc",
                "zerodoppler_end_utc",
            }:
                file[name] = text
        file["state_vector_time_utc"] = np.array([[p.utc(v)[:-1].encode()] for v in t])
        for k, table in (("pos", P), ("vel", V)):
            for a, column in zip("XYZ", table.T, strict=True):
                file[f"{k}{a}"] = column
        if p.ground:
            file["grsr_coefficients"], file["grsr_ground_range_origin"] = p.sets()[1][0], 0.0
            del file["ground_range_origin"]
        for name in ("s_amplitude",) if p.ground else ("s_i", "s_q"):
            file.create_dataset(name, (p.rows, p.columns), "f4", chunks=(1, p.columns))
    return path


VECTOR = {f"{k}{a}" for k in ("pos", "vel") for a in "XYZ"}
__all__ = ["Product", "cosmo", "iceye_hdf5", "nisar"]


def lengths_vary(path, *attributes, table="", damage=False):
    """The file with texts in heaps: these attributes and a table in chunks; damaged: an object of them has no end."""
    import h5py

    with h5py.File(path, "r+") as data:
        for name in attributes:
            text = data.attrs[name].decode()
            del data.attrs[name]
            data.attrs.create(name, text, dtype=h5py.string_dtype())
        if table:
            values = np.ravel(data[table][()])
            del data[table]
            data.create_dataset(table, data=values, dtype=h5py.string_dtype(), chunks=(4,))
    if damage:
        whole = bytearray(path.read_bytes())
        at = whole.index(b"GCOL\x01") + 16
        whole[at : at + 2], whole[at + 8 : at + 16] = b"\0\0", bytes(8)
        path.write_bytes(whole)
    return path
