"""Photographs of a plan that was flown: small files that state what those of a vehicle state."""

import io
import math
from datetime import datetime, timedelta
from functools import cache

import numpy as np
from PIL import Image
from PIL.TiffImagePlugin import IFDRational

from raybundle.io.geo.coordinate_systems import local_frame
from raybundle.io.missions.areas import in_crs
from raybundle.missions.mission import exposures

XMP_NAME = b"http://ns.adobe.com/xap/1.0/\0"
XMP = (
    '<x:xmpmeta xmlns:x="adobe:ns:meta/"><rdf:RDF xmlns:rdf="http://www.w3.org/1999/02/22-rdf-syntax-ns#">'
    '<rdf:Description xmlns:drone-dji="http://www.dji.com/drone-dji/1.0/" drone-dji:RelativeAltitude="{above:+.2f}" '
    'drone-dji:GimbalYawDegree="{yaw:.2f}" drone-dji:GimbalPitchDegree="{pitch:.2f}" '
    'drone-dji:GimbalRollDegree="0.0"/></rdf:RDF></x:xmpmeta>'
)
SIZE = 400


@cache
def texture(seed=0):
    """A picture whose structure is that of nature: the amplitude falls with the frequency."""
    rng = np.random.default_rng(seed)
    f = np.hypot(*np.meshgrid(np.fft.fftfreq(SIZE), np.fft.fftfreq(SIZE)))
    f[0, 0] = 1
    picture = np.fft.ifft2(np.fft.fft2(rng.normal(0, 1, (SIZE, SIZE))) / f).real
    return np.clip(128 + 40 * picture / picture.std(), 0, 255)


@cache
def encoded(seed, blurred):
    """The bytes of such a picture as a JPEG without metadata."""
    picture = texture(seed)
    if blurred:
        picture = np.mean([np.roll(picture, n, axis=1) for n in range(5)], axis=0)
    file = io.BytesIO()
    Image.fromarray(picture.astype(np.uint8)).save(file, "JPEG", quality=90)
    return file.getvalue()


def segment(data):
    """An APP1 segment of a JPEG."""
    return b"\xff\xe1" + (len(data) + 2).to_bytes(2, "big") + data


def rational(value):
    return IFDRational(round(value * 1e7), 10_000_000)


def dms(degrees):
    degrees = abs(degrees)
    minutes = (degrees % 1) * 60
    return tuple(map(rational, (int(degrees), int(minutes), (minutes % 1) * 60)))


def fly(mission, folder, *, drop=(), blur=(), tilt=(), off=0.0, up=0.0, bare=False, position=True, seed=1, step_s=1.2):
    """Write the photographs; `bare` ones state their position and time alone."""
    e = exposures(mission)
    folder.mkdir(exist_ok=True)
    rng = np.random.default_rng(seed)
    xy = e.xyz[:, :2] + rng.normal(0, off, (len(e), 2)) if off else e.xyz[:, :2]
    lonlat = in_crs(xy, mission.crs, "EPSG:4326")
    turn = local_frame(mission.crs, np.array(mission.take_off)).scale_and_convergence(e.xyz)[:, 1]
    start = datetime(2026, 5, 1, 10)  # noqa: DTZ001  (a camera's clock)
    for k in range(len(e)):
        if k in drop:
            continue
        exif = Image.Exif()
        exif[0x010F], exif[0x0110] = "DJI", "M3E"
        taken = start + timedelta(seconds=step_s * k)
        inner = exif.get_ifd(0x8769)
        inner[0x9003], inner[0x9291] = taken.strftime("%Y:%m:%d %H:%M:%S"), f"{taken.microsecond // 1000:03d}"
        inner[0x829A], inner[0x920A] = IFDRational(1, 1000), rational(12.29)
        if position:
            gps = exif.get_ifd(0x8825)
            gps[1], gps[2] = "N", dms(lonlat[k, 1])
            gps[3], gps[4] = "E" if lonlat[k, 0] > 0 else "W", dms(lonlat[k, 0])
            gps[5], gps[6] = b"\0", rational(e.xyz[k, 2] + 48 + up)
        metadata = segment(exif.tobytes())
        if not bare:
            pitch = math.degrees(e.pitch[k]) + (15 if k in tilt else 0)
            yaw = math.degrees(e.heading[k] + turn[k])
            above = e.xyz[k, 2] - mission.take_off[2] + up
            metadata += segment(XMP_NAME + XMP.format(above=above, yaw=yaw, pitch=pitch).encode())
        picture = encoded(k % 3, k in blur)
        (folder / f"DJI_{k + 1:04d}.jpg").write_bytes(picture[:2] + metadata + picture[2:])
    return e
