"""Width of a sensor: what the photograph states twice outvotes a table; cameras under one name are told apart."""

import pytest

from raybundle.errors import code_of, phrase
from raybundle.io.photos.metadata import Metadata
from raybundle.io.photos.sensor_sizes import sensor_size
from raybundle.io.photos.start import DIAGONAL_35MM, starting_value


def photograph(make, model, size, sensor, focal, **more):
    """Metadata of a camera whose sensor [mm] is stated by focal plane resolution and 35 mm equivalent."""
    density = size[0] / sensor[0]
    equivalent = focal * DIAGONAL_35MM / (sensor[0] ** 2 + sensor[1] ** 2) ** 0.5
    given = {
        "make": make, "model": model, "focal_mm": focal, "focal35_mm": round(equivalent),
        "focal_plane_px_per_mm": (density, density), "exif_width": size[0], "exif_height": size[1],
    }  # fmt: skip
    return Metadata(**(given | more))


OUTVOTED = {
    "Sequoia (RGB)": ("Parrot", "Sequoia", (4608, 3456), (6.17, 4.63), 4.88),
    "another firmware's format": ("Parrot", "Sequoia", (4000, 3000), (6.17, 4.63), 4.88),
    "a body with another sensor": ("Canon", "Canon EOS 5D Mark II", (5184, 3456), (22.3, 14.9), 24.0),
    "half a format": ("NIKON CORPORATION", "NIKON D7000", (4928, 3264), (13.2, 8.8), 18.0),
    "a phone's second lens": ("Apple", "iPhone 7", (4032, 3024), (5.6, 4.2), 4.0),
    "a drone's second camera": ("DJI", "FC6310", (4000, 3000), (6.4, 4.8), 29.9),
    "a band of a multispectral camera": ("MicaSense", "RedEdge-M", (2064, 1544), (7.12, 5.33), 8.0),
    "a compact camera": ("SONY", "DSC-RX100", (4896, 3672), (7.6, 5.7), 9.0),
    "a larger sensor": ("PENTAX", "PENTAX K-5", (7360, 4912), (35.9, 24.0), 50.0),
    "as a reduced copy": ("DJI", "FC330", (5472, 3648), (13.2, 8.8), 8.8),
}


@pytest.mark.parametrize("name", OUTVOTED)
def test_two_sources_of_the_photograph_outvote_the_table(name):
    make, model, size, sensor, focal = OUTVOTED[name]
    m = photograph(make, model, size, sensor, focal)
    by = 4 if "reduced" in name else 1
    start = starting_value(m, size[0] // by, size[1] // by)
    assert start.c_mm / start.pixel_mm == pytest.approx(focal * size[0] / sensor[0] / by, rel=0.01)
    assert start.source == phrase("camera_start.focal_plane")
    table = sensor_size(m, size)
    told = any(code_of(r) == "camera_start.table_outvoted" for r in start.remarks)
    assert told == (table is not None and abs(table[0] / sensor[0] - 1) > 0.1)


@pytest.mark.parametrize(
    "more",
    [{"focal35_mm": None}, {"focal_plane_px_per_mm": None}, {"focal35_mm": 24.0}],
    ids=["one", "other", "contradiction"],
)
def test_one_source_alone_does_not(more):
    m = photograph("Canon", "Canon EOS 5D Mark II", (5184, 3456), (22.3, 14.9), 24.0, **more)
    assert starting_value(m, 5184, 3456).source == phrase("camera_start.table")


@pytest.mark.parametrize(
    ("make", "model", "size", "width"),
    [
        ("Parrot", "Sequoia", (4608, 3456), 6.17),
        ("Parrot", "Sequoia", (1280, 960), 4.8),
        ("Parrot", "Sequoia", (4000, 3000), None),
        ("DJI", "M3M", (5280, 3956), 17.3),
        ("DJI", "M3M", (2592, 1944), 5.18),
        ("DJI", "M3E", (5280, 3956), 17.3),
        ("DJI", "M3E", (4000, 3000), 6.4),
        ("DJI", "M3E", (640, 512), None),
        ("DJI", "FC6310", (5472, 3648), 13.2),
        ("MicaSense", "RedEdge", (1280, 960), 4.8),
    ],
)
def test_cameras_of_one_name_are_told_apart_by_their_format(make, model, size, width):
    found = sensor_size(Metadata(make=make, model=model), size)
    assert (found and found[0]) == width
