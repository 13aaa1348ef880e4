"""Draw docs/images/calibration-networks.svg: good and bad networks and what their calibrations are worth.

python tools/calibration_figures.py [--check]
"""

from __future__ import annotations

import sys
from pathlib import Path

import numpy as np

from raybundle.adjustment.engine import adjust_block
from raybundle.adjustment.records.options import AdjustmentOptions
from raybundle.calibration.maps import projection_uncertainty
from raybundle.numerics.arrays import Array
from raybundle.planning.network.calibration_networks import ROLLS, FlatField, flat_field_scene
from raybundle.planning.simulate import Survey, simulate
from raybundle.planning.synthetic_networks import Scene

PICTURE = Path(__file__).resolve().parents[1] / "docs/images/calibration-networks.svg"
SURVEY = Survey(orientation="exact", points="exact", interior="exact", image_sigma_px=0.05)
FIELD = 1.7
"""Side of the field [m]: it fills the format."""
PLANS = {
    "square views": FlatField(size=FIELD, tilt_deg=0.0, shift=0.25),
    "tilted 10°, never rolled": FlatField(size=FIELD, tilt_deg=10.0),
    "tilted 40°, never rolled": FlatField(size=FIELD, tilt_deg=40.0),
    "tilted 40°, rolled": FlatField(size=FIELD, tilt_deg=40.0, rolls_deg=ROLLS),
}
SIDE, MAP, TOP = 230.0, 150.0, 208.0
LOWEST, HIGHEST = 0.01, 1.0
"""Ends of the colour scale [px]; logarithmic."""
UP = (np.array([0.86, 0.30, 0.0]), np.array([-0.5, 0.52, 0.86]))
"""Right and up of the sketch, in object axes X, Y, Z."""


def place(xyz: Array) -> Array:
    """Points of the sketch (n, 2) of object points (n, 3)."""
    x, y = (np.atleast_2d(xyz) @ axis for axis in UP)
    return np.stack([SIDE / 2 + 66 * x, TOP - 62 - 66 * y], axis=1)


def path(xy: Array, style: str) -> str:
    """A closed line."""
    return f'<path d="M{" L".join(f"{x:.1f} {y:.1f}" for x, y in xy)} Z" {style}/>'


def sketch(scene: Scene) -> list[str]:
    """The field and the cameras."""
    h = FIELD / 2
    field = np.array([[-h, -h, 0], [h, -h, 0], [h, h, 0], [-h, h, 0]])
    parts = [path(place(field), 'fill="#eef3f6" stroke="#8aa"')]
    for point in scene.xyz[::3]:
        x, y = place(point)[0]
        parts.append(f'<circle cx="{x:.1f}" cy="{y:.1f}" r="1" fill="#456"/>')
    for X0, R in zip(scene.centre, scene.rotation, strict=True):
        # a pyramid whose base is the format, with a bar on its upper side
        base = np.array([[-0.75, -0.5, -1], [0.75, -0.5, -1], [0.75, 0.5, -1], [-0.75, 0.5, -1]]) * 0.17
        corner = place(X0 + base @ R)
        apex = place(X0)[0]
        parts += [
            f'<line x1="{apex[0]:.1f}" y1="{apex[1]:.1f}" x2="{c[0]:.1f}" y2="{c[1]:.1f}" stroke="#1d5c77" '
            'stroke-width=".7"/>'
            for c in corner
        ]
        parts.append(path(corner, 'fill="#fff" fill-opacity=".6" stroke="#1d5c77" stroke-width=".9"'))
        parts.append(
            f'<line x1="{corner[2, 0]:.1f}" y1="{corner[2, 1]:.1f}" x2="{corner[3, 0]:.1f}" y2="{corner[3, 1]:.1f}" '
            'stroke="#b5532a" stroke-width="2.2"/>'
        )
    return parts


def colour(value: float) -> str:
    """From nearly white to dark red, logarithmic."""
    t = float(np.clip(np.log(value / LOWEST) / np.log(HIGHEST / LOWEST), 0, 1))
    low, high = np.array([246, 240, 234]), np.array([150, 40, 20])
    return "#" + "".join(f"{int(v):02x}" for v in low + t * (high - low))


def worth(scene: Scene) -> tuple[list[str], str]:
    """The map of the uncertainty of projection, and what it says in words."""
    result = adjust_block(simulate(scene, SURVEY).observed, AdjustmentOptions(jobs=1))
    lost = [s for s, p in result.interior[0].parameters.items() if p.status == "not determinable"]
    left, width, height = (SIDE - MAP) / 2, MAP, MAP * 2 / 3
    if "c" in lost:
        words = f'<text x="{SIDE / 2}" y="{TOP + height / 2:.0f}" class="n">not determinable</text>'
        frame = f'<rect x="{left}" y="{TOP}" width="{width}" height="{height:.0f}" fill="none" stroke="#b99"/>'
        return [frame, words], f"not determinable: {', '.join(lost)}"
    assert result.precision is not None
    free, C = result.interior[0].free, result.precision.interior["1"]
    found = projection_uncertainty(result.adjusted.cameras[0], free, C, columns=30, rows=20)
    std = found.std
    rows, columns = std.shape
    w, h = width / columns, height / rows
    parts = [
        f'<rect x="{left + i * w:.1f}" y="{TOP + j * h:.1f}" width="{w + 0.2:.1f}" height="{h + 0.2:.1f}" '
        f'fill="{colour(std[j, i])}"/>'
        for j in range(rows)
        for i in range(columns)
    ]
    return parts, f"{np.nanmedian(std):.2g} px, at worst {found.largest:.2g} px"


def picture() -> str:
    """The whole drawing."""
    parts: list[str] = []
    for k, (name, plan) in enumerate(PLANS.items()):
        scene = flat_field_scene(plan)
        cells, words = worth(scene)
        parts += [
            f'<g transform="translate({k * SIDE:.0f} 0)">', *sketch(scene), *cells,
            f'<text x="{SIDE / 2}" y="16" class="h">{name}</text>',
            f'<text x="{SIDE / 2}" y="{TOP + MAP * 2 / 3 + 18:.0f}">{words}</text></g>',
        ]  # fmt: skip
    width, height = SIDE * len(PLANS), TOP + MAP * 2 / 3 + 30
    return (
        f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {width:.0f} {height:.0f}" width="{width:.0f}" '
        f'height="{height:.0f}" role="img"><title>Calibration networks and the uncertainty of projection</title>'
        "<style>text{font:12px sans-serif;fill:#234;text-anchor:middle}.h{font-weight:bold}.n{fill:#a33}</style>"
        '<rect width="100%" height="100%" fill="#fff"/>' + "".join(parts) + "</svg>\n"
    )


def main() -> int:
    """Write or compare; 1 if the picture differs."""
    text = picture()
    if "--check" in sys.argv[1:]:
        same = PICTURE.is_file() and PICTURE.read_text(encoding="utf-8") == text
        if not same:
            print(f"{PICTURE.name} is not what tools/calibration_figures.py draws; run it")
        return int(not same)
    PICTURE.write_text(text, encoding="utf-8")
    return 0


if __name__ == "__main__":
    sys.exit(main())
