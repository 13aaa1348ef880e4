"""Drawings of heights as PNG, by the same elements as their SVG."""

from __future__ import annotations

import re
from collections.abc import Mapping
from pathlib import Path
from xml.etree.ElementTree import Element, fromstring  # of what this program wrote itself

from PIL import Image, ImageDraw, ImageFont

FINER = 3
"""Dots along the side of a pixel of the drawing while it is drawn"""
SHOWN = 2
"""and of the picture"""
ANCHORS = {"start": "l", "middle": "m", "end": "r"}


def write_png(svg: str, path: Path) -> None:
    """A drawing of `drawings.sheet` as a picture, twice as many pixels along a side as the drawing has units."""
    root = fromstring(svg)  # noqa: S314
    width, height = (round(float(root.attrib[name])) for name in ("width", "height"))
    image = Image.new("RGB", (FINER * width, FINER * height), (255, 255, 255))
    for e in root.iter():
        kind = e.tag.rpartition("}")[2]
        if kind == "text":
            _text(image, e)
        elif kind in {"polygon", "polyline", "line", "circle", "rect"} and e.get("width") != "100%":
            _shape(image, kind, e.attrib)
    image.resize((SHOWN * width, SHOWN * height), Image.Resampling.LANCZOS).save(path)


def _shape(image: Image.Image, kind: str, a: Mapping[str, str]) -> None:
    """Filled with its opacity, then its outline."""

    def at(name: str) -> float:
        return FINER * float(a.get(name, "0"))

    draw = ImageDraw.Draw(image, "RGBA")
    fill, opacity = a.get("fill", "#000"), float(a.get("fill-opacity", "1"))
    stroke, width = a.get("stroke", "none"), max(1, round(FINER * float(a.get("stroke-width", "1"))))
    line = None if stroke == "none" else stroke
    inside = None if fill == "none" else (*_colour(fill), round(255 * opacity))
    if kind in {"polygon", "polyline"}:
        points = [(FINER * float(x), FINER * float(y)) for x, y in re.findall(r"([-.0-9]+),([-.0-9]+)", a["points"])]
        if kind == "polygon" and inside is not None:
            draw.polygon(points, fill=inside)
        if line is not None:
            draw.line([*points, *(points[:1] if kind == "polygon" else [])], fill=line, width=width, joint="curve")
    elif kind == "line" and line is not None:
        draw.line((at("x1"), at("y1"), at("x2"), at("y2")), fill=line, width=width)
    elif kind == "circle":
        r, x, y = at("r"), at("cx"), at("cy")
        draw.ellipse((x - r, y - r, x + r, y + r), fill=inside, outline=line)
    elif kind == "rect":
        x, y = at("x"), at("y")
        draw.rectangle((x, y, x + at("width"), y + at("height")), fill=inside, outline=line, width=width)


def _text(image: Image.Image, e: Element) -> None:
    """As it is anchored; turned by a quarter where the drawing turns it."""
    font = ImageFont.load_default(FINER * float(e.get("font-size", "13")))
    colour, anchor, words = _colour(e.get("fill", "#000")), ANCHORS[e.get("text-anchor", "start")], e.text or ""
    turned = re.fullmatch(r"translate\(([-.0-9]+) ([-.0-9]+)\) rotate\(-90\)", e.get("transform", ""))
    if turned is None:
        place = FINER * float(e.get("x", "0")), FINER * float(e.get("y", "0"))
        ImageDraw.Draw(image).text(place, words, fill=colour, font=font, anchor=f"{anchor}s")
        return
    left, top, right, bottom = font.getbbox(words, anchor="ls")
    held = Image.new("L", (round(right - left) + 4, round(bottom - top) + 4))
    ImageDraw.Draw(held).text((2 - left, 2 - top), words, fill=255, font=font, anchor="ls")
    held = held.transpose(Image.Transpose.ROTATE_90)
    x, y = (FINER * float(v) for v in turned.groups())
    image.paste(colour, (round(x - held.width), round(y - held.height / 2)), held)


def _colour(text: str) -> tuple[int, int, int]:
    """#rgb or #rrggbb."""
    digits = text[1:] if len(text) == 7 else "".join(2 * c for c in text[1:])
    red, green, blue = (int(digits[k : k + 2], 16) for k in (0, 2, 4))
    return red, green, blue
