"""Drawings of heights look alike with and without their style sheet."""

import re
from types import SimpleNamespace

import numpy as np
import pytest

from raybundle.surfaces.files.drawings import ATTRIBUTES, STYLE, contours_svg, sections_svg
from raybundle.surfaces.heights.contours import Contour

HEIGHT = np.array([0.0, 0.1, np.nan, 0.2, 0.4])


def profile():
    section = SimpleNamespace(
        distance=np.arange(5.0), height=HEIGHT, sigma=np.full(5, 0.01), corners=np.array([[0.0, 0], [2, 0], [4, 0]]),
        model=SimpleNamespace(cell=1.0),
    )  # fmt: skip
    return sections_svg([section], ["a wall"], "m")


def contours():
    line = np.stack([np.linspace(0, 90, 50), np.linspace(5, 40, 50)], axis=1)
    return contours_svg([Contour(height=h, lines=(line,)) for h in (0.0, 0.1, 0.2)], (50, 100), 0.02, (0.0, 0.0), "m")


@pytest.mark.parametrize("drawn", [profile, contours])
def test_strokes_and_fills_stand_at_each_line_too(drawn):
    """MuPDF, and what is made with it, heeds no style sheet: without attributes all is black."""
    body = drawn().partition("</style>")[2]
    for element in re.findall(r"<(?:line|path|polygon|polyline|rect|text) [^>]*>", body):
        assert ' fill="' in element or ' stroke="' in element, element
    for element in re.findall(r'<(?:path|polyline|rect) class="[^>]*>', body):
        assert 'fill="none"' in element, element


def test_attributes_say_what_the_style_sheet_says():
    rules = dict(re.findall(r"\.(\w+)\{([^}]*)\}", STYLE))
    assert rules.keys() == ATTRIBUTES.keys()
    for name, rule in rules.items():
        told = dict(re.findall(r'([\w-]+)="([^"]*)"', ATTRIBUTES[name]))
        for key, value in (r.split(":") for r in rule.split(";")):
            if name == "name" and key in {"paint-order", "stroke", "stroke-width"}:
                continue
            assert told[key] == value.removesuffix("px"), (name, key)
