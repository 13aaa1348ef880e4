"""Sensor sizes of well-known cameras, width and height [mm].

Facts from the manufacturers' data sheets and manuals (imaging area or, where only the pixel pitch is given,
pitch times the effective pixels; drones and phones).  Widths are good to about 0.5 %.
"""

from __future__ import annotations

import re

from raybundle.io.photos.metadata import Metadata

FULL = (36.0, 24.0)
NIKON_FX = (35.9, 24.0)
NIKON_DX = (23.5, 15.6)
CANON_APS = (22.3, 14.9)
CANON_APS_OLD = (22.2, 14.8)
FOUR_THIRDS = (17.3, 13.0)
ONE_INCH = (13.2, 8.8)

_BY_SIZE: dict[tuple[float, float], str] = {
    # Canon; the second and third names of a body are its American and Japanese ones
    FULL: "canon eos 5d mark ii|canon eos 5d mark iii|canon eos 5d mark iv|canon eos 5ds|canon eos 5ds r|canon eos r|"
    "canon eos r5|canon eos r5m2|canon eos 1ds mark iii|canon eos 1d x|canon eos 1d x mark ii",
    (35.8, 23.9): "canon eos 5d|canon eos 6d|sony ilce 7|sony ilce 7s|sony ilce 7m2|sony dsc rx1|sony dsc rx1r",
    (35.9, 24.0): "canon eos 6d mark ii|canon eos rp|canon eos r6|canon eos r6m2|canon eos r8|nikon d600|nikon d610|"
    "nikon d750|nikon d780|nikon d800|nikon d800e|nikon d810|nikon d5|nikon d850|nikon z 5|nikon z 6|nikon z 6 2|"
    "nikon z 7|nikon z 7 2|nikon z 8|nikon z 9|nikon zf|sony ilce 7r|sony ilce 7rm2|sony ilce 7rm3|sony ilce 7m4|"
    "sony dsc rx1rm2|dji zenmusep1|dji zenmuse p1",
    (35.7, 23.8): "sony ilce 7m3|sony ilce 7c|sony ilce 7rm4|sony ilce 7rm5|sony ilce 9|sony ilce 1",
    (36.0, 23.9): "nikon d3|nikon d3s|nikon d700|nikon d4|nikon d4s|nikon df",
    (22.7, 15.1): "canon eos 300d digital|canon eos digital rebel|canon eos kiss digital|canon eos 10d|canon eos d60",
    (22.5, 15.0): "canon eos 20d|canon eos 30d|canon eos 70d",
    CANON_APS_OLD: "canon eos 350d digital|canon eos digital rebel xt|canon eos kiss digital n|canon eos 400d digital|"
    "canon eos digital rebel xti|canon eos kiss digital x|canon eos 450d|canon eos digital rebel xsi|canon eos kiss x2|"
    "canon eos 40d|canon eos 1000d|canon eos rebel xs|canon eos kiss f|canon eos 1100d|canon eos rebel t3",
    CANON_APS: "canon eos 50d|canon eos 60d|canon eos 80d|canon eos 90d|canon eos 7d|canon eos 500d|"
    "canon eos rebel t1i|"
    "canon eos 550d|canon eos rebel t2i|canon eos 600d|canon eos rebel t3i|canon eos 650d|canon eos rebel t4i|"
    "canon eos 700d|canon eos rebel t5i|canon eos 750d|canon eos rebel t6i|canon eos 760d|canon eos 800d|"
    "canon eos rebel t7i|canon eos 850d|canon eos 1200d|canon eos rebel t5|canon eos 1300d|canon eos rebel t6|"
    "canon eos 2000d|canon eos rebel t7|canon eos 4000d|canon eos 100d|canon eos 200d|canon eos m|canon eos m3|"
    "canon eos m5|canon eos m6|canon eos m50|canon eos m100|canon eos r7|canon eos r10|canon eos r50",
    (22.4, 15.0): "canon eos 7d mark ii",
    # Nikon
    (23.7, 15.6): "nikon d70|nikon d70s|nikon d50|nikon d100|nikon d40|nikon d2x",
    (23.6, 15.8): "nikon d60|nikon d80|nikon d90|nikon d200|nikon d300|nikon d300s|nikon d40x|nikon d3000|nikon d5000",
    (23.1, 15.4): "nikon d3100",
    (23.2, 15.4): "nikon d3200",
    (23.6, 15.6): "nikon d5100|nikon d7000|fujifilm x t1|fujifilm x t10|fujifilm x pro1|fujifilm x e1|fujifilm x e2",
    NIKON_DX: "nikon d3300|nikon d3400|nikon d3500|nikon d5200|nikon d5300|nikon d5500|nikon d5600|nikon d7100|"
    "nikon d7200|nikon d7500|sony nex 7|sony nex 6|sony ilce 5100|sony ilce 6000|sony ilce 6100|sony ilce 6300|"
    "sony ilce 6400|sony ilce 6500|sony ilce 6600|sony ilce 6700|fujifilm x t2|fujifilm x t20|fujifilm x t3|"
    "fujifilm x t30|fujifilm x t4|fujifilm x t5|fujifilm x100f|fujifilm x100v|fujifilm x h1|ricoh gr iii|"
    "ricoh gr iiix",
    (23.5, 15.7): "nikon d500|nikon z 50|nikon z fc|nikon z 30",
    (23.4, 15.6): "sony nex 3|sony nex 5|sony nex 5n|sony nex 5r|sony nex c3",
    (23.5, 15.701): "pentax k10d|pentax k20d|pentax k100d",
    (23.7, 15.7): "pentax k 5|pentax k 7|pentax k 3|ricoh gr|ricoh gr ii",
    # four thirds, one inch, medium format
    FOUR_THIRDS: "olympus e m1|olympus e m1markii|olympus e m5|olympus e m5markii|olympus e m10|olympus e m10markii|"
    "olympus e pl5|olympus e 510|olympus e 520|panasonic dmc gh3|panasonic dmc gh4|panasonic dc gh5|panasonic dc g9|"
    "panasonic dmc gx7|panasonic dmc gx8|panasonic dmc gm1|dji fc6520|dji fc6540|dji fc550|hasselblad l2d 20c|"
    "dji fc4170",
    ONE_INCH: "sony dsc rx100|sony dsc rx100m2|sony dsc rx100m3|sony dsc rx100m4|sony dsc rx100m5|sony dsc rx100m6|"
    "sony dsc rx100m7|sony dsc rx10|sony dsc qx100|canon powershot g7 x|canon powershot g9 x|nikon 1 j1|nikon 1 v1|"
    "dji fc6310|dji fc6310s|dji fc6310r|dji fc6510|dji fc3411|hasselblad l1d 20c",
    (43.8, 32.9): "fujifilm gfx 50s|fujifilm gfx 50r|fujifilm gfx100|fujifilm gfx 100s|hasselblad x1d 50c|pentax 645d|"
    "pentax 645z",
    (12.75, 8.5): "sensefly s o d a|sensefly soda",
    # smaller sensors of drones and compact cameras
    (6.25, 4.69): "dji fc300s|dji fc300x|dji fc330|dji fc350|dji fc300c",
    (6.17, 4.63): "dji fc220|dji fc200",
    (6.4, 4.8): "dji fc3170",
    (9.7, 7.3): "dji fc3582|dji fc8482",
    (4.8, 3.6): "micasense rededge|micasense rededge m|apple iphone 6|apple iphone 6 plus|"
    "apple iphone 6s|apple iphone 5s",
    (4.54, 3.42): "apple iphone 4s|apple iphone 5",
    (4.0, 3.0): "apple iphone 7|apple iphone 8",
    (5.76, 4.29): "kodak z612 zoom digital camera|kodak z712 is zoom digital camera|konica minolta dimage z3|"
    "canon digital ixus 40|canon powershot sd300|panasonic dmc fz7",
    (7.18, 5.32): "canon digital ixus 400|canon powershot s40|canon powershot g5|canon powershot g3|olympus c4040z|"
    "olympus c3040z|nikon coolpix p1|panasonic dmc fz30|nikon e950|nikon e990|nikon e4500",
    (7.6, 5.7): "canon powershot g9|canon powershot g10|canon powershot g11|canon powershot g12|canon powershot s90|"
    "canon powershot s95|nikon coolpix p6000",
    (8.8, 6.6): "olympus c8080wz|sony dsc f828|nikon e8700|canon powershot pro1",
}
_SIZES = {name: (size[0], round(size[1], 3)) for size, names in _BY_SIZE.items() for name in names.split("|")}
_SEVERAL: dict[str, tuple[tuple[tuple[int, int], tuple[float, float]], ...]] = {
    # one name for several cameras in one housing: format [px] and size [mm] of each
    "parrot sequoia": (((4608, 3456), (6.17, 4.63)), ((1280, 960), (4.8, 3.6))),
    "dji m3e": (((5280, 3956), FOUR_THIRDS), ((4000, 3000), (6.4, 4.8))),
    "dji m3m": (((5280, 3956), FOUR_THIRDS), ((2592, 1944), (5.18, 3.89))),
}
SAME_FORMAT = 0.02
"""Relative difference of pixel numbers: cameras leave out some columns at the edge, or write some more."""
_MAKERS = {
    "eastman": "", "kodak": "kodak", "nikon": "nikon", "olympus": "olympus", "om": "olympus", "sony": "sony",
    "canon": "canon", "fujifilm": "fujifilm", "pentax": "pentax", "ricoh": "ricoh", "panasonic": "panasonic",
    "dji": "dji", "hasselblad": "hasselblad", "apple": "apple", "konica": "konica", "parrot": "parrot",
    "micasense": "micasense", "sensefly": "sensefly", "yuneec": "yuneec", "gopro": "gopro",
}  # fmt: skip


def sensor_size(metadata: Metadata, format_px: tuple[int, int]) -> tuple[float, float] | None:
    """Width and height [mm] of the sensor of a body that the table knows, longer side first; else None.

    format_px  longer and shorter side of the image as taken, by which cameras under one name are distinguished

    Limits: whether the photograph shows the whole sensor.
    """
    for name in body_names(metadata):
        if name in _SEVERAL:
            return next((size for px, size in _SEVERAL[name] if _same_format(px, format_px)), None)
        if name in _SIZES:
            return _SIZES[name]
    return None


def _same_format(a: tuple[int, int], b: tuple[int, int]) -> bool:
    return all(abs(x / y - 1) <= SAME_FORMAT for x, y in zip(a, b, strict=True))


def body_names(metadata: Metadata) -> tuple[str, ...]:
    """Names by which a body may stand in a table: lower case, with its maker and without."""
    maker = next((_MAKERS[w] for w in _words(metadata.make) if _MAKERS.get(w)), "")
    model = " ".join(w for w in _words(metadata.model) if w != "corporation")
    return (model, f"{maker} {model}", *((f"{maker} {model.removeprefix(maker + ' ')}",) if maker else ()))


def _words(text: str) -> list[str]:
    return re.sub(r"[^a-z0-9]+", " ", text.lower()).split()
