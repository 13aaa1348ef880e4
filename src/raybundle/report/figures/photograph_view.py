"""Figure: the photograph with most object points, these in the colour of their standard deviation."""

from __future__ import annotations

import io
from base64 import b64encode
from collections.abc import Mapping
from pathlib import Path

import numpy as np

from raybundle.errors import InputError, Text, note, phrase
from raybundle.io.photos.photo import read_colour, read_photo, upright, upright_from_stored
from raybundle.measuring.frames import to_file
from raybundle.report.figures.object_view import DOTS, ObjectView, coloured_dots, rms_of
from raybundle.report.figures.svg import drawing, spread_rows
from raybundle.report.network.sigma_classes import Classes
from raybundle.report.view import View

WIDTH, MOST_HEIGHT, SHARP, QUALITY = 330.0, 300.0, 2.5, 80
"""Of the figure [px]; pixels of the picture in one of the figure; quality of the JPEG"""
TRIED = 3
"""Photographs that are opened, where the first cannot be read"""


def photograph_view(view: View, pictures: Mapping[str, Path], classes: Classes | None) -> ObjectView | None:
    """The photograph with most points that take part; None where none can be shown.

    pictures  file of an image in the block -> where it is
    classes   of standard deviations, as the figure beside it shows them
    """
    o, files = view.given.observations, view.adjusted.images.file
    count = np.bincount(o.image[view.used], minlength=len(files))
    order = [k for k in np.argsort(-count, kind="stable").tolist() if count[k] and files[k] in pictures]
    for k in order[:TRIED]:
        try:
            return _drawn(view, k, pictures[files[k]], classes)
        except InputError:  # of a photograph that is gone or damaged, which other commands name
            continue
    return None


def _drawn(view: View, image: int, path: Path, classes: Classes | None) -> ObjectView:
    from PIL import Image

    photo, o = read_photo(path), view.given.observations
    rows = np.flatnonzero(view.used & (o.image == image))
    wide, high = photo.upright_size
    scale = min(WIDTH / wide, MOST_HEIGHT / high)
    picture = Image.fromarray(upright(read_colour(photo), photo.orientation))
    picture.thumbnail((round(SHARP * scale * wide), round(SHARP * scale * high)), reducing_gap=2.0)
    file = io.BytesIO()
    picture.save(file, "JPEG", quality=QUALITY)
    data = b64encode(file.getvalue()).decode("ascii")
    embedded = (
        f'<image x="0" y="0" width="{scale * wide:.1f}" height="{scale * high:.1f}" preserveAspectRatio="none" '
        f'href="data:image/jpeg;base64,{data}"/>'
    )
    some = rows[spread_rows(len(rows), DOTS)]
    std = np.full(len(some), np.nan) if view.std is None else rms_of(view.std[o.point[some]])
    xy = upright_from_stored(to_file(view.adjusted, image, o.xy_px[some]), photo) * scale
    name, n = view.adjusted.images.ids[image], len(rows)
    return ObjectView(
        drawing=drawing(
            scale * wide, scale * high, [embedded, coloured_dots(xy, std, classes)],
            phrase("drawn.photograph_points", name=name, n=n),
        ),
        caption=Text.of(note("drawn.photograph_points", name=name, n=n)), classes=classes,
    )  # fmt: skip
