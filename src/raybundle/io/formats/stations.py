"""Stations for maps: GeoJSON (RFC 7946) and KML 2.2, in WGS 84, heights above the ellipsoid."""

from __future__ import annotations

import json
from html import escape
from pathlib import Path
from typing import Any

import numpy as np

from raybundle.errors import InputError, phrase
from raybundle.io.formats.base import Draft, Export, Format, Scene, register, scene
from raybundle.numerics.arrays import Array


def _places(export: Export) -> tuple[Scene, Array, Array, tuple[str, ...]]:
    """The scene, longitude, latitude and height (n, 3), and the azimuth of the view (n,) [deg]."""
    s, frame = scene(export), export.frame
    if frame is None:
        raise InputError("stations.no_crs")
    metres = s.centre * (0.001 if export.block.length_unit == "mm" else 1.0)
    places = frame.wgs84_from_local(metres)
    view = -s.rotation[:, 2, :]
    azimuth = np.degrees(np.arctan2(view[:, 0], view[:, 1])) % 360
    return s, places, azimuth, s.remarks + frame.remarks


def write_geojson(export: Export, path: Path) -> Draft:
    """Write one point a station, with file, view and standard deviations [m, east, north, up of the frame]."""
    s, places, azimuth, remarks = _places(export)
    unit = 0.001 if export.block.length_unit == "mm" else 1.0
    features: list[dict[str, Any]] = []
    for k, name in enumerate(s.names):
        properties: dict[str, Any] = {
            "image": export.block.images.ids[int(s.source[k])],
            "file": name,
            "camera": s.cameras[int(s.camera[k])].id,
            "azimuth_deg": round(float(azimuth[k]), 3),
            "nadir_deg": round(float(np.degrees(np.arccos(np.clip(s.rotation[k, 2, 2], -1, 1)))), 3),
        }
        if export.station_sigma is not None and np.isfinite(export.station_sigma[s.source[k]]).all():
            sigma = (export.station_sigma[s.source[k]] * unit).tolist()
            properties |= dict(zip(("sigma_east_m", "sigma_north_m", "sigma_up_m"), sigma, strict=True))
        lon, lat, h = places[k].tolist()
        geometry = {"type": "Point", "coordinates": [round(lon, 10), round(lat, 10), round(h, 4)]}
        features.append({"type": "Feature", "geometry": geometry, "properties": properties})
    text = json.dumps({"type": "FeatureCollection", "features": features}, indent=1, ensure_ascii=False)
    path.write_text(text + "\n", encoding="utf-8")
    return Draft(remarks=remarks)


def write_kml(export: Export, path: Path) -> Draft:
    """Write one placemark a station, in the order of the images."""
    s, places, azimuth, remarks = _places(export)
    marks = [
        f"<Placemark><name>{escape(name)}</name>"
        f"<description>view to {a:.1f} deg, height above the ellipsoid {h:.3f} m</description>"
        f"<Point><altitudeMode>absolute</altitudeMode><coordinates>{lon:.10f},{lat:.10f},{h:.4f}</coordinates></Point>"
        "</Placemark>"
        for name, (lon, lat, h), a in zip(s.names, places.tolist(), azimuth.tolist(), strict=True)
    ]
    text = "\n".join(
        [
            '<?xml version="1.0" encoding="UTF-8"?>',
            '<kml xmlns="http://www.opengis.net/kml/2.2"><Document>',
            f"<name>{escape(export.block.name)}</name>",
            *marks,
            "</Document></kml>",
        ]
    )
    path.write_text(text + "\n", encoding="utf-8")
    return Draft(remarks=(*remarks, phrase("conversion.kml_heights")))


for _name, _title, _write in (
    ("geojson", "stations as GeoJSON (needs the coordinate system)", write_geojson),
    ("kml", "stations as KML (needs the coordinate system)", write_kml),
):
    register(
        Format(
            name=_name,
            title=_title,
            kind="file",
            suffix=f".{_name}",
            write=_write,
            needs_frame=True,
            metric=True,
            points="none",
        )
    )
