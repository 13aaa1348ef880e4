"""Photographs, their metadata, films and videos."""

import math
import shutil
import struct
from pathlib import Path

import numpy as np

from tests.hostile.readers.registry import not_finite, only, place, target, texts

XMP = (
    b'<?xpacket begin="" id="W5M0MpCehiHzreSzNTczkc9d"?><x:xmpmeta xmlns:x="adobe:ns:meta/"><rdf:RDF '
    b'xmlns:rdf="http://www.w3.org/1999/02/22-rdf-syntax-ns#"><rdf:Description rdf:about="" '
    b'xmlns:drone-dji="http://www.dji.com/drone-dji/1.0/" drone-dji:RtkFlag="50" drone-dji:RtkStdLon="0.01" '
    b'drone-dji:RtkStdHgt="0.02" drone-dji:GimbalYawDegree="+12.3" drone-dji:GimbalPitchDegree="-90" '
    b'drone-dji:GimbalRollDegree="0" drone-dji:AbsoluteAltitude="+512.3" '
    b'drone-dji:DewarpData="2022-06-08;3713.29,3713.29,7.02,-8.72,-0.11,0.01,-0.0001,0,0.0"><drone-dji:GpsLatitude>48.1'
    b"</drone-dji:GpsLatitude></rdf:Description></rdf:RDF></x:xmpmeta>"
)


def photo_seeds(suffix: str):
    def write(top: Path) -> None:
        from PIL import Image

        from tests.io.photos.test_photo_files import save, scene

        exif = Image.Exif()
        exif[0x0112], exif[0x010F], exif[0x0110] = 6, "Mäker", "M1"
        exif.get_ifd(0x8769).update({0x920A: 5.0, 0xA405: 28, 0x9003: "2024:05:06 07:08:09"})
        exif.get_ifd(0x8825).update({1: "N", 2: (48.0, 7.0, 3.2), 3: "E", 4: (11.0, 7.0, 3.2), 6: 500.0})
        save(place(top, 0) / f"a.{suffix}", scene(40, 40), exif=exif)
        if suffix == "jpg":
            save(place(top, 1) / "a.jpg", scene(40, 40), exif=exif, xmp=XMP)
        elif suffix in {"png", "tif"}:
            wide = (np.arange(1600).reshape(40, 40) * 40).astype(np.uint16)
            Image.fromarray(wide).save(place(top, 1) / f"a.{suffix}")

    return write


def read_a_photograph(folder: Path) -> list[str]:
    from raybundle.io.photos.cameras import camera_groups, camera_of
    from raybundle.io.photos.photo import find_photos, read_grey
    from raybundle.io.reading.tiff import is_tiff, tiff_tags

    file = only(folder)
    wrong: list[str] = []
    found = find_photos([folder])  # a bad file costs that file: no exception here
    for photo in found.photos:
        for camera in map(camera_of, camera_groups([photo])):
            wrong += not_finite(**camera.values, **{f"sigma {s}": v for s, v in camera.sigma.items()})
            if camera.values["c"] <= 0 or any(v <= 0 for v in camera.sigma.values()):
                wrong.append("c or a sigma is not positive")
        gps = photo.metadata.gps
        if gps is not None:
            wrong += not_finite(latitude=gps.latitude_deg, longitude=gps.longitude_deg, altitude=gps.altitude_m or 0.0)
        read_grey(photo)
    if is_tiff(file):
        tiff_tags(file)
    return wrong


def read_metadata_of_xmp(folder: Path) -> list[str]:
    from raybundle.io.photos.read_metadata import read_metadata

    metadata, _ = read_metadata(None, only(folder).read_bytes())
    sigma = metadata.gps.sigma_m if metadata.gps is not None else None
    return [] if sigma is None or all(s > 0 for s in sigma if not math.isnan(s)) else ["sigma"]


def movie_seeds(top: Path) -> None:
    from tests.io.photos.test_video_frames import PHONE, box, movie

    said = {b"\xa9mak": b"Maker", b"\xa9mod": b"Action 7", b"\xa9xyz": b"+47.5+008.25/"}
    boxes = [box(k, struct.pack(">HH", len(v), 0), v) for k, v in said.items()]
    texts({"a.mov": movie(PHONE)}, {"a.mp4": movie(box(b"udta", *boxes), creation=0)})(top)


def read_a_movie(folder: Path) -> list[str]:
    from raybundle.io.photos.movie import read_movie_metadata

    position = read_movie_metadata(only(folder)).position
    return [] if position is None else not_finite(position=[v for v in position if v is not None])


def video_seeds(top: Path) -> None:
    import cv2

    writer = cv2.VideoWriter(str(place(top) / "a.mp4"), cv2.VideoWriter_fourcc(*"mp4v"), 10, (64, 48))
    noise = np.random.default_rng(0).integers(0, 255, (48, 200, 3), dtype=np.uint8)
    for k in range(8):
        writer.write(np.ascontiguousarray(noise[:, 4 * k : 4 * k + 64]))
    writer.release()


def read_a_video(folder: Path) -> list[str]:
    from raybundle.io.photos.video import FrameOptions, extract_frames

    out = folder.parent / "frames"
    shutil.rmtree(out, ignore_errors=True)
    extract_frames(only(folder), out, FrameOptions(count=2))
    return []


for _name in ("jpg", "png", "tif", "webp"):
    target(f"photo-{_name}", photo_seeds(_name), read_a_photograph)
target("xmp", texts({"x.xmp": XMP}), read_metadata_of_xmp)
target("movie", movie_seeds, read_a_movie)
target("video", video_seeds, read_a_video, slow=True)
