"""Image files: what kind a file is, its size without decoding, the metadata it carries, its pixels.

Only the decoders named here are ever reached, and the size is read before anything is decoded.
HEIC needs the extra `raybundle[heic]`, camera raw files `raybundle[raw]`.
"""

from __future__ import annotations

import mmap
import struct
import threading
import warnings
from dataclasses import dataclass
from importlib import import_module
from pathlib import Path
from typing import Any, Literal

import numpy as np

from raybundle.errors import InputError, Message, message
from raybundle.io.photos.exif import read_tags
from raybundle.io.photos.tiff_bands import BandImage, band_image, colour_of, grey_of, jpeg2000_image
from raybundle.io.reading.tiff import tiff_tags
from raybundle.numerics.arrays import Array

Kind = Literal["jpeg", "png", "tiff", "webp", "heic", "raw", "jp2"]
RAW_SUFFIXES = {".dng", ".nef", ".nrw", ".cr2", ".cr3", ".crw", ".arw", ".raf", ".rw2", ".orf", ".pef", ".srw", ".3fr"}
JPEG_SUFFIXES = {".jpg", ".jpeg", ".jpe"}
HEIC_SUFFIXES = {".heic", ".heif", ".hif"}
JPEG2000_SUFFIXES = {".jp2", ".j2k", ".jpx"}
SUFFIXES = {".png", ".tif", ".tiff", ".webp", *JPEG_SUFFIXES, *JPEG2000_SUFFIXES, *HEIC_SUFFIXES, *RAW_SUFFIXES}
HEIC_BRANDS = {b"heic", b"heix", b"heim", b"heis", b"hevc", b"hevx", b"mif1", b"msf1"}
SEGMENT_BYTES = 1 << 22
WHOLE_BYTES = 1 << 26
"""A TIFF's directories may stand anywhere in it; longer files are mapped into memory, not read."""
BAND = 1024
"""Rows that are taken over at once."""
_opening = threading.Lock()


class Unusable(InputError):
    """A file that is no photograph raybundle can read; the message is the reason."""


@dataclass(frozen=True, slots=True, kw_only=True)
class Header:
    """What a file states before its pixels are decoded."""

    kind: Kind
    width_px: int
    """As stored, before any rotation that the metadata ask for."""
    height_px: int
    bits: int
    exif: bytes | memoryview | None = None
    xmp: bytes | None = None
    remarks: tuple[str, ...] = ()
    """How the numbers of a raster become grey values."""


def kind_of(path: Path, head: bytes) -> Kind:
    """The kind by the first bytes of the file (raw files by their suffix); raises Unusable."""
    if path.suffix.lower() in RAW_SUFFIXES:
        return "raw"
    if head[:3] == b"\xff\xd8\xff":
        return "jpeg"
    if head[:8] == b"\x89PNG\r\n\x1a\n":
        return "png"
    if head[:4] in {b"II*\0", b"MM\0*", b"II+\0", b"MM\0+"}:
        return "tiff"
    if head[4:8] == b"jP  " or head[:4] == b"\xff\x4f\xff\x51":
        return "jp2"
    if head[:4] == b"RIFF" and head[8:12] == b"WEBP":
        return "webp"
    if head[4:8] == b"ftyp" and head[8:12] in HEIC_BRANDS:
        return "heic"
    if not head:
        raise Unusable("photograph.empty")
    if (other := other_kind(path.suffix, head)) is not None:
        raise Unusable(other)
    shown = "".join(chr(b) if 32 <= b < 127 else "." for b in head[:12])
    raise Unusable("photograph.kind_unknown", begin=str(shown))


def other_kind(suffix: str, head: bytes = b"") -> Message | None:
    """What to do with a file that is no photograph but comes from one, by its suffix or its beginning; None for others.

    A video is asked for its suffix first: its container begins as that of HEIC photographs does.
    """
    video = head[4:8] == b"ftyp" or head[:4] == b"\x1aE\xdf\xa3" or (head[:4] == b"RIFF" and head[8:12] == b"AVI ")
    if suffix.lower() in VIDEO_SUFFIXES or video:
        return message("photograph.video")
    if suffix.lower() in ANYMAP_SUFFIXES or (head[:1] == b"P" and head[1:2] in b"1234567" and head[2:3].isspace()):
        return message("photograph.anymap")
    return None


VIDEO_SUFFIXES = {".mp4", ".mov", ".m4v", ".avi", ".mkv", ".webm", ".mts", ".m2ts", ".mpg", ".mpeg", ".3gp", ".wmv"}
ANYMAP_SUFFIXES = {".pgm", ".ppm", ".pnm", ".pbm", ".pam"}


def read_header(path: Path, *, limit_pixels: int) -> Header:
    """Kind, size, depth and metadata of a file; raises Unusable with the reason, or OSError."""
    with path.open("rb") as file:
        head = file.read(32)
    kind = kind_of(path, head)
    if kind == "webp":
        _check_size(*_webp_size(path), limit_pixels)
    if (raster := _raster(path, kind)) is not None:
        _check_size(raster.width_px, raster.height_px, limit_pixels)
        exif = _tiff_structure(path) if kind == "tiff" else None
        return Header(kind=kind, width_px=raster.width_px, height_px=raster.height_px, bits=raster.bits, exif=exif,
                      remarks=raster.remarks)  # fmt: skip
    try:
        image = _open(path, kind)
    except Unusable:
        raise
    except Exception as error:  # noqa: BLE001  (decoders raise anything on a damaged file; it costs that file only)
        reason = unread_tiff(path) if kind == "tiff" else None
        raise Unusable(reason or message("photograph.header_unreadable", detail=_first_line(error))) from None
    try:
        width, height = _stored_size(image, kind)
        _check_size(width, height, limit_pixels)
        exif, xmp = _embedded(path, kind, image)
        return Header(kind=kind, width_px=width, height_px=height, bits=_bits(image, kind, path), exif=exif, xmp=xmp)
    finally:
        _close(image)


def _raster(path: Path, kind: Kind) -> BandImage | None:
    """The raster in a file that Pillow does not read; None for other files; raises Unusable."""
    if kind not in {"tiff", "jp2"}:
        return None
    try:
        return band_image(path) if kind == "tiff" else jpeg2000_image(path)
    except InputError as error:
        if kind == "tiff" and error.message is not None and error.message.code.startswith("tiff."):
            return None  # which is found again, and named, by the usual decoder
        raise Unusable(error.message or str(error)) from None


BITS, SAMPLES, FORMAT, PLANAR = 258, 277, 339, 284
"""Tags of TIFF: bits of each sample, samples of a pixel, their format, their arrangement"""
FORMATS = {1: "whole", 2: "signed", 3: "floating"}


def unread_tiff(path: Path) -> Message | None:
    """Bands, bits and format of a sound TIFF whose pixels are of no kind that is read; None where it is not sound."""
    try:
        _, tags = tiff_tags(path, frozenset({BITS, SAMPLES, FORMAT, PLANAR}))
    except (InputError, OSError):
        return None
    bits, bands = sorted({int(b) for b in tags.get(BITS, (1,))}), int(next(iter(tags.get(SAMPLES, (1,)))))
    kind = FORMATS.get(int(next(iter(tags.get(FORMAT, (1,))))), "other")
    planar = tags.get(PLANAR, (1,))[0] == 2
    return message("photograph.tiff_pixels", bands=bands, bits=bits, format=kind, planar=planar)


def _close(image: Any) -> None:
    """Close what can be closed; a HEIC image holds no file."""
    if hasattr(image, "close"):
        image.close()


def _check_size(width: int, height: int, limit_pixels: int) -> None:
    if width < 1 or height < 1:
        raise Unusable("photograph.no_size", width_px=width, height_px=height)
    if width * height > limit_pixels:
        raise Unusable(
            "photograph.too_large", width_px=width, height_px=height, megapixels=width * height / 1e6,
            limit_megapixels=limit_pixels / 1e6,
        )  # fmt: skip


def _open(path: Path, kind: Kind) -> Any:
    """An image whose pixels are not decoded yet: Pillow's, or rawpy's."""
    if kind == "raw":
        return _extra("rawpy", "raw").imread(str(path))
    with _opening, warnings.catch_warnings():
        warnings.simplefilter("ignore")
        if kind == "heic":
            return _extra("pi_heif", "heic").open_heif(str(path), convert_hdr_to_8bit=True)
        plugin = import_module(f"PIL.{_PLUGINS[kind][0]}")
        return getattr(plugin, _PLUGINS[kind][1])(str(path))


_PLUGINS: dict[str, tuple[str, str]] = {
    "jpeg": ("JpegImagePlugin", "JpegImageFile"),
    "png": ("PngImagePlugin", "PngImageFile"),
    "tiff": ("TiffImagePlugin", "TiffImageFile"),
    "webp": ("WebPImagePlugin", "WebPImageFile"),
}


def _extra(module: str, extra: str) -> Any:
    try:
        return import_module(module)
    except ImportError:
        raise Unusable("photograph.package_missing", extra=extra) from None


def _stored_size(image: Any, kind: Kind) -> tuple[int, int]:
    if kind == "raw":
        return int(image.sizes.iwidth), int(image.sizes.iheight)
    return int(image.size[0]), int(image.size[1])


def _bits(image: Any, kind: Kind, path: Path) -> int:
    if kind == "png":
        with path.open("rb") as file:
            return 16 if file.read(25)[24] == 16 else 8
    if kind == "tiff":
        bits = image.tag_v2.get(258, (8,))
        deepest = max(bits) if isinstance(bits, tuple) else int(bits)
        if deepest > 16 or image.mode == "F":
            raise Unusable("photograph.bits", bits=deepest)
        return 16 if deepest > 8 else 8
    return 8


def _webp_size(path: Path) -> tuple[int, int]:
    """Canvas size from the first chunk (RFC 9649); the decoder allocates it on opening."""
    with path.open("rb") as file:
        head = file.read(40)
    chunk, body = head[12:16], head[20:]
    if chunk == b"VP8X" and len(body) >= 10:
        return 1 + int.from_bytes(body[4:7], "little"), 1 + int.from_bytes(body[7:10], "little")
    if chunk == b"VP8L" and len(body) >= 5:
        word = int.from_bytes(body[1:5], "little")
        return 1 + (word & 0x3FFF), 1 + (word >> 14 & 0x3FFF)
    if chunk == b"VP8 " and len(body) >= 10:
        width, height = struct.unpack_from("<HH", body, 6)
        return width & 0x3FFF, height & 0x3FFF
    raise Unusable("photograph.header_unreadable", detail="WebP")


def _embedded(path: Path, kind: Kind, image: Any) -> tuple[bytes | memoryview | None, bytes | None]:
    """EXIF and XMP as they stand in the file."""
    if kind == "jpeg":
        return _jpeg_segments(path)
    if kind in {"tiff", "raw"}:
        return _tiff_structure(path), None
    info = image.info
    exif, xmp = info.get("exif"), info.get("xmp")
    if kind == "png" and exif is None and "Raw profile type exif" in info:
        exif = _png_profile(info["Raw profile type exif"])
    if xmp is None:
        xmp = info.get("XML:com.adobe.xmp")
    if isinstance(xmp, str):
        xmp = xmp.encode()
    return exif if isinstance(exif, bytes) else None, xmp if isinstance(xmp, bytes) else None


def _whole(path: Path) -> bytes | memoryview:
    """The bytes of a file, without holding a long one in memory."""
    with path.open("rb") as file:
        if path.stat().st_size <= WHOLE_BYTES:
            return file.read()
        return memoryview(mmap.mmap(file.fileno(), 0, access=mmap.ACCESS_READ))


def _tiff_structure(path: Path) -> bytes | memoryview | None:
    data = _whole(path)
    return data if bytes(data[:2]) in {b"II", b"MM"} else None


def _png_profile(text: str) -> bytes | None:
    """ImageMagick's hexadecimal EXIF in a text chunk."""
    try:
        return bytes.fromhex("".join(text.split()[2:]))
    except ValueError:
        return None


def _jpeg_segments(path: Path) -> tuple[bytes | None, bytes | None]:
    """The first EXIF and the first XMP segment (ISO 10918-1 markers up to the first scan)."""
    exif: bytes | None = None
    xmp: bytes | None = None
    with path.open("rb") as file:
        data = file.read(SEGMENT_BYTES)
    at = 2
    while at + 4 <= len(data) and data[at] == 0xFF:
        marker = data[at + 1]
        if marker == 0xFF:
            at += 1
            continue
        if marker in {0xDA, 0xD9}:
            break
        length = int.from_bytes(data[at + 2 : at + 4], "big")
        if length < 2:
            break
        body = data[at + 4 : at + 2 + length]
        if marker == 0xE1 and exif is None and body[:5] == b"Exif\0":
            exif = body[6:]
        elif marker == 0xE1 and xmp is None and body[:29] == b"http://ns.adobe.com/xap/1.0/\0":
            xmp = body[29:]
        at += 2 + length
    return exif, xmp


def check_pixels(path: Path, kind: Kind) -> None:
    """Raise Unusable where the pixel data end too early.

    A file that ends as its kind should is believed; any other is decoded once to find out.
    """
    with path.open("rb") as file:
        size = file.seek(0, 2)
        file.seek(max(0, size - 64))
        tail = file.read()
    if kind == "raw":
        return  # developing takes seconds; `decode` finds out
    if kind == "jpeg" and tail.rstrip(b"\0").endswith(b"\xff\xd9"):
        return
    if kind == "png" and b"IEND" in tail[-16:]:
        return
    if kind == "tiff" and _tiff_complete(path, size):
        return
    try:
        decode(path, kind, "grey")
    except Unusable:
        raise
    except InputError as error:
        raise Unusable(error.message or str(error)) from None


def _tiff_complete(path: Path, size: int) -> bool:
    """Whether the strips or tiles of the first image lie within the file."""
    tags = read_tags(_whole(path))
    offsets, counts = tags.numbers(273) or tags.numbers(324), tags.numbers(279) or tags.numbers(325)
    if not offsets or len(offsets) != len(counts):
        return False
    return all(offset + count <= size and count > 0 for offset, count in zip(offsets, counts, strict=True))


def decode(path: Path, kind: Kind, mode: Literal["grey", "colour"]) -> Array:
    """Pixels as stored: (h, w) uint8 or uint16, or (h, w, 3) uint8; raises InputError where they cannot be read."""
    try:
        if kind == "raw":
            return _decode_raw(path, mode)
        if (raster := _raster(path, kind)) is not None:
            return grey_of(raster) if mode == "grey" else _as_colour(colour_of(raster))
        image = _open(path, kind)
        try:
            return _decode(path, kind, image, mode)
        finally:
            _close(image)
    except InputError as error:
        raise error.at(path) from None
    except Exception as error:  # noqa: BLE001  (decoders raise anything on a damaged file; it costs that file only)
        disk = type(error) is PermissionError
        raise InputError("photograph.pixels_unreadable", detail=_first_line(error), disk=disk, file=path) from None


def _decode(path: Path, kind: Kind, image: Any, mode: Literal["grey", "colour"]) -> Array:
    if kind == "heic":
        image = image.to_pillow()
    if kind == "jpeg" and mode == "grey":
        image.draft("L", image.size)
    if kind in {"png", "tiff"} and _bits(image, kind, path) == 16:
        return _decode_16(path, image, mode)
    wanted = "L" if mode == "grey" else "RGB"
    return _in_bands(image if image.mode == wanted else image.convert(wanted))


def _in_bands(image: Any) -> Array:
    """The pixels of an image in Pillow's memory, taken over in bands: as a whole they would be held four times."""
    width, height = image.size
    pixels = np.empty((height, width, *([3] if image.mode == "RGB" else [])), np.uint8)
    for top in range(0, height, BAND):
        below = min(top + BAND, height)
        pixels[top:below] = np.asarray(image.crop((0, top, width, below)))
    return pixels


def decode_channels(path: Path, kind: Kind) -> tuple[Array, Array | None]:
    """Colour (h, w, k) of 1 or 3 channels without any loss of depth, and alpha (h, w) where the file has it.

    raises  InputError where the pixels cannot be read, also where a PNG's checksum contradicts
    """
    if kind in {"raw", "heic"}:
        return decode(path, kind, "colour"), None
    if (raster := _raster(path, kind)) is not None:
        return colour_of(raster), None
    try:
        image = _open(path, kind)
        try:
            return _channels(path, kind, image)
        finally:
            _close(image)
    except Exception as error:  # noqa: BLE001  (decoders raise anything on a damaged file; it costs that file only)
        raise InputError("photograph.pixels_unreadable", detail=_first_line(error), disk=False, file=path) from None


def _channels(path: Path, kind: Kind, image: Any) -> tuple[Array, Array | None]:
    if image.mode == "P":
        image = image.convert("RGBA" if "transparency" in image.info else "RGB")
    elif image.mode not in {"L", "LA", "RGB", "RGBA"} and not image.mode.startswith("I"):
        image = image.convert("L" if image.mode == "1" else "RGB")
    pixels: Array = np.asarray(image)
    if kind in {"png", "tiff"} and _bits(image, kind, path) == 16 and not image.mode.startswith("I"):
        import cv2

        found: Array | None = cv2.imdecode(np.frombuffer(path.read_bytes(), np.uint8), cv2.IMREAD_UNCHANGED)
        if found is not None and found.shape[:2] == pixels.shape[:2]:
            pixels = found  # Pillow keeps 8 bits
    pixels = pixels.reshape(*pixels.shape[:2], -1)
    k = pixels.shape[2]
    return (pixels[..., :-1], pixels[..., -1]) if k in {2, 4} else (pixels, None)


def _decode_16(path: Path, image: Any, mode: Literal["grey", "colour"]) -> Array:
    """Pillow keeps 16 bits of grey images only; OpenCV keeps them of colour images too."""
    if image.mode.startswith("I"):
        pixels: Array = np.asarray(image).astype(np.uint16)
    else:
        import cv2

        data = np.frombuffer(path.read_bytes(), np.uint8)
        found: Array | None = cv2.imdecode(data, cv2.IMREAD_UNCHANGED)
        if found is None or found.shape[:2] != image.size[::-1]:
            raise InputError("photograph.pixels_16_bit", file=path)
        pixels = np.asarray(found)[..., :3]
        if pixels.ndim == 3 and pixels.shape[2] == 3:
            pixels = pixels[..., ::-1]
            if mode == "grey":
                pixels = np.round(pixels @ np.array([0.299, 0.587, 0.114])).astype(pixels.dtype)
    if mode == "grey":
        return np.ascontiguousarray(pixels.reshape(pixels.shape[:2]))
    return _as_colour(pixels)


def _as_colour(pixels: Array) -> Array:
    """(h, w, 3) uint8 of grey or colour values; of 16 bits the highest 8 that occur."""
    if pixels.dtype == np.uint16:
        pixels = pixels >> max(0, int(pixels.max(initial=0)).bit_length() - 8)
    colour = np.broadcast_to(pixels.reshape(*pixels.shape[:2], -1), (*pixels.shape[:2], 3))
    return np.ascontiguousarray(colour, np.uint8)


def _decode_raw(path: Path, mode: Literal["grey", "colour"]) -> Array:
    with _extra("rawpy", "raw").imread(str(path)) as raw:
        colour = raw.postprocess(use_camera_wb=True, no_auto_bright=True, output_bps=8, user_flip=0)
    if mode == "colour":
        return np.ascontiguousarray(colour)
    return np.round(colour @ np.array([0.299, 0.587, 0.114])).astype(np.uint8)


def _first_line(error: BaseException) -> str:
    return str(error).strip().partition("\n")[0] or type(error).__name__
