"""What `raybundle strain` writes: tables, maps and result.json."""

from __future__ import annotations

import json
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np

from raybundle.commands.strain_results import StrainImage, Strains, state_counts
from raybundle.errors import phrase
from raybundle.report.figures.svg import tick_labels, ticks

if TYPE_CHECKING:
    from raybundle.numerics.arrays import Array

DISPLACEMENTS, STRAIN, AREAS, RESULT, MAPS = "displacements.csv", "strain.csv", "areas.csv", "result.json", "maps"
RAMP = np.array([(48, 18, 59), (70, 107, 227), (40, 188, 235), (50, 242, 152), (164, 252, 60), (238, 207, 58),
                 (251, 128, 34), (210, 49, 5), (122, 4, 3)], float)  # fmt: skip
"""From low to high (after Turbo by Anton Mikhailov)"""
ENDS = 0.01
"""Share of the values on either side that have the colour of the end"""
SHOWN_PX, BAR_PX, MARGIN_PX = (500, 1000), 18, 96
"""Longer side of a map at least and at most, width of its colour bar and of the room for its figures"""
FADED = 0.35
"""Strength of the reference image below the colours"""


def write_strains(done: Strains, reference: Array, size: Array) -> tuple[Path, ...]:
    """Write the folder of a result; the tables, result.json and the folder of the maps are returned."""
    from raybundle.io.digits import PIXEL, SHORT, STD, TEST, Places, by_sigma, reported
    from raybundle.io.folders import new_folder
    from raybundle.io.tables import write_table
    from raybundle.results.contents import clean

    s = done.settings
    displacements, strains = _displacements(done), _strains(done)
    digits: dict[str, Any] = {"x_px": PIXEL, "y_px": PIXEL, "row": Places(0), "column": Places(0)}
    d, e = displacements, strains
    units = ["px", *(["mm"] if s.scale else [])]
    for unit in units:
        for a in "uv":
            sigma = d[f"sd_{a}_{unit}"]
            digits |= {f"{a}_{unit}": by_sigma(sigma), f"{a}_relative_{unit}": by_sigma(sigma)}
            digits[f"sd_{a}_{unit}"] = STD
    digits |= dict.fromkeys(("r_uv", "correlation", "noise_reference", "noise_deformed", "parts_px"), Places(4))
    for a in ("xx", "yy", "xy"):
        digits |= {f"e{a}": by_sigma(e[f"sd_e{a}"]), f"sd_e{a}": STD}
    digits |= dict.fromkeys(("e1", "e2"), Places(8)) | dict.fromkeys(("direction_deg", "rotation_deg"), Places(4))
    digits |= dict.fromkeys(("r_xx_yy", "r_xx_xy", "r_yy_xy"), TEST) | {"displacements": Places(0)}
    with new_folder(s.out) as folder:
        write_table(folder / DISPLACEMENTS, d, digits)
        write_table(folder / STRAIN, e, digits)
        if s.area:
            a = _areas(done)
            more = {f"{c}_{u}": by_sigma(a[f"sd_{c}_{u}"]) for u in units for c in "uv"}
            more |= {f"sd_{c}_{u}": STD for u in units for c in "uv"} | {"subsets": Places(0), "misfit": Places(2)}
            more |= {f"e{c}": by_sigma(a[f"sd_e{c}"]) for c in ("xx", "yy", "xy")}
            write_table(folder / AREAS, a, digits | more)
        contents = reported(_contents(done, size), SHORT)
        (folder / RESULT).write_text(json.dumps(clean(contents), indent=1) + "\n", encoding="utf-8")
        (folder / MAPS).mkdir()
        for k, image in enumerate(done.images, 1):
            stem = f"{k:0{len(str(len(done.images)))}d}-{Path(image.name).stem}"
            for name, values, unit in _mapped(done, image):
                _draw(folder / MAPS / f"{stem}-{name}.png", done, reference, values, f"{image.name}: {name} [{unit}]")
    return tuple(s.out / name for name in (DISPLACEMENTS, STRAIN, *([AREAS] if s.area else []), RESULT, MAPS))


def _places(done: Strains, rows: list[Array]) -> dict[str, Any]:
    """The first columns of a table, for these rows of each image."""
    xy, cell = done.grid.xy_px, done.grid.cell
    names = [i.name for i, r in zip(done.images, rows, strict=True) for _ in range(len(r))]
    at = np.concatenate(rows)
    return {"image": names, "row": cell[at, 0].astype(float), "column": cell[at, 1].astype(float),
            "x_px": xy[at, 0], "y_px": xy[at, 1]}  # fmt: skip


def _displacements(done: Strains) -> dict[str, Any]:
    from raybundle.matching.subsets import State

    images = done.images
    d, relative = (np.concatenate(a) for a in ([i.displacement for i in images], [i.relative for i in images]))
    cov = np.concatenate([i.followed.cov_px2 for i in images])
    std = np.sqrt(np.diagonal(cov, axis1=1, axis2=2))
    columns = _places(done, [np.arange(len(i.displacement)) for i in images])
    columns["state"] = [State(k).name.lower() for i in images for k in i.followed.state.tolist()]
    for unit, f in (("px", 1.0), ("mm", done.settings.scale)):
        if f:
            for k, a in enumerate("uv"):
                columns |= {f"{a}_{unit}": f * d[:, k], f"sd_{a}_{unit}": f * std[:, k],
                            f"{a}_relative_{unit}": f * relative[:, k]}  # fmt: skip
    noise = np.concatenate([i.followed.noise for i in images])
    return columns | {
        "r_uv": cov[:, 0, 1] / (std[:, 0] * std[:, 1]),
        "correlation": np.concatenate([i.followed.correlation for i in images]),
        "noise_reference": noise[:, 0], "noise_deformed": noise[:, 1],
        "parts_px": np.concatenate([i.followed.parts_px for i in images]),
    }  # fmt: skip


def _strains(done: Strains) -> dict[str, Any]:
    rows = [np.flatnonzero(np.isfinite(i.strain.strain[:, 0])) for i in done.images]

    def of(name: str) -> Array:
        return np.concatenate([getattr(i.strain, name)[r] for i, r in zip(done.images, rows, strict=True)])

    columns = _places(done, rows)
    columns |= _strain_columns(of("strain"), of("cov"), of("principal"), of("direction"), of("rotation"))
    return columns | {"displacements": of("count").astype(float)}


def _strain_columns(e: Array, cov: Array, principal: Array, direction: Array, rotation: Array) -> dict[str, Any]:
    e, cov, principal = e.reshape(-1, 3), cov.reshape(-1, 3, 3), principal.reshape(-1, 2)
    std = np.sqrt(np.diagonal(cov, axis1=1, axis2=2))
    columns: dict[str, Any] = {f"e{a}": e[:, k] for k, a in enumerate(("xx", "yy", "xy"))}
    columns |= {f"sd_e{a}": std[:, k] for k, a in enumerate(("xx", "yy", "xy"))}
    for a, b, name in ((0, 1, "r_xx_yy"), (0, 2, "r_xx_xy"), (1, 2, "r_yy_xy")):
        columns[name] = cov[:, a, b] / (std[:, a] * std[:, b])
    return columns | {
        "e1": principal[:, 0], "e2": principal[:, 1], "direction_deg": np.degrees(direction),
        "rotation_deg": np.degrees(rotation),
    }  # fmt: skip


def _areas(done: Strains) -> dict[str, Any]:
    """Rows of each area in each image; without those that have too few subsets."""
    rows = [(i.name, name, a) for i in done.images for name, a in i.areas.items() if a is not None]
    columns: dict[str, Any] = {
        "image": [i for i, _, _ in rows], "area": [n for _, n, _ in rows],
        "subsets": np.array([float(a.strain.count[0]) for *_, a in rows]),
    }  # fmt: skip
    mean = np.array([a.mean for *_, a in rows]).reshape(-1, 2)
    mean_std = np.sqrt(np.array([np.diag(a.mean_cov) for *_, a in rows])).reshape(-1, 2)
    for unit, f in (("px", 1.0), ("mm", done.settings.scale)):
        if f:
            for k, c in enumerate("uv"):
                columns |= {f"{c}_{unit}": f * mean[:, k], f"sd_{c}_{unit}": f * mean_std[:, k]}
    fields = [a.strain for *_, a in rows]
    columns |= _strain_columns(
        *(np.array([getattr(e, n)[0] for e in fields]) for n in ("strain", "cov", "principal", "direction", "rotation"))
    )
    return columns | {"misfit": np.array([a.misfit for *_, a in rows])}


def _contents(done: Strains, size: Array) -> dict[str, Any]:
    s = done.settings
    return {
        "reference": s.reference.name, "width_px": int(size[0]), "height_px": int(size[1]), "step_px": s.step,
        "window_px": s.window // 2 * 2 + 1, "shape": s.shape, "scale_mm_per_px": s.scale,
        "strain": "green-lagrange", "shear": "tensor", "axes": ["right", "down"],
        "strain_gauge_px": (s.gauge // 2 * 2) * s.step + s.window // 2 * 2 + 1,
        "subsets": len(done.grid.xy_px), "images": [_of_image(i, state_counts(i.followed)) for i in done.images],
        "warnings": [{"code": m.code, "severity": m.severity.value, "message": m.text()} for m in done.reported],
    }  # fmt: skip


def _of_image(image: StrainImage, counts: dict[str, int]) -> dict[str, Any]:
    f, e, r = image.followed, image.strain, image.rigid
    followed, some = (bool(np.isfinite(v).any()) for v in (f.correlation, e.strain))
    sigma = np.sqrt(np.diag(r.cov))
    return {
        "image": image.name, "states": counts,
        "rigid_motion": {
            "centre_px": r.centre.tolist(), "shift_px": r.shift.tolist(), "sigma_shift_px": sigma[:2].tolist(),
            "rotation_deg": float(np.degrees(r.rotation)), "sigma_rotation_deg": float(np.degrees(sigma[2])),
        },
        "median_sd_px": np.sqrt(np.nanmedian(np.diagonal(f.cov_px2, axis1=1, axis2=2), axis=0)).tolist()
        if followed else None,
        "noise": np.nanmedian(f.noise, axis=0).tolist() if followed else None,
        "median_strain": np.nanmedian(e.strain, axis=0).tolist() if some else None,
        "median_sd_strain": np.sqrt(np.nanmedian(np.diagonal(e.cov, axis1=1, axis2=2), axis=0)).tolist()
        if some else None,
    }  # fmt: skip


def _mapped(done: Strains, image: StrainImage) -> list[tuple[str, Array, str]]:
    """Names, values (n,) and units of the maps of an image."""
    f, unit = (done.settings.scale, "mm") if done.settings.scale else (1.0, "px")
    e = image.strain
    found = [(a, f * image.displacement[:, k], unit) for k, a in enumerate("uv")]
    found += [(f"{a}-relative", f * image.relative[:, k], unit) for k, a in enumerate("uv")]
    found += [(f"e{a}", 1e6 * e.strain[:, k], "1e-6") for k, a in enumerate(("xx", "yy", "xy"))]
    return [*found, ("e1", 1e6 * e.principal[:, 0], "1e-6")]


def _draw(path: Path, done: Strains, reference: Array, values: Array, title: str) -> None:
    """A map of colours on the reference image, with a colour bar."""
    import cv2
    from PIL import Image, ImageDraw, ImageFont

    h, w = reference.shape
    zoom = np.clip(max(h, w), *SHOWN_PX) / max(h, w)
    size = (max(round(zoom * w), 1), max(round(zoom * h), 1))
    grey = cv2.resize(reference, size, interpolation=cv2.INTER_AREA if zoom < 1 else cv2.INTER_LINEAR)
    low, high = np.quantile(grey, [0.01, 0.99])
    back = np.clip((grey.astype(float) - low) / max(high - low, 1e-9), 0, 1)[..., None]
    colours = np.repeat(255 - FADED * 255 * (1 - back), 3, axis=2)
    known = values[np.isfinite(values)]
    if len(known):
        low, high = np.quantile(known, [ENDS, 1 - ENDS])
        high = high if high > low else low + max(abs(low), 1.0) * 1e-3
        cells, (x, y) = done.grid.raster(values), done.grid.xy_px.min(axis=0)
        half, column, row = done.settings.step / 2, *done.grid.cell.min(axis=0)[::-1].tolist()
        at_x = np.floor(((np.arange(size[0]) + 0.5) / zoom - x + half) / done.settings.step).astype(int) + column
        at_y = np.floor(((np.arange(size[1]) + 0.5) / zoom - y + half) / done.settings.step).astype(int) + row
        inside = ((at_y >= 0) & (at_y < cells.shape[0]))[:, None] & ((at_x >= 0) & (at_x < cells.shape[1]))
        shown = cells[np.clip(at_y, 0, cells.shape[0] - 1)][:, np.clip(at_x, 0, cells.shape[1] - 1)]
        seen = inside & np.isfinite(shown)
        colours[seen] = _coloured((shown[seen] - low) / (high - low)) * (0.75 + 0.25 * back[seen])
    sheet = Image.new("RGB", (size[0] + BAR_PX + MARGIN_PX, max(size[1], 220) + 40), (255, 255, 255))
    sheet.paste(Image.fromarray(np.clip(colours, 0, 255).astype(np.uint8)), (0, 40))
    draw, font = ImageDraw.Draw(sheet), ImageFont.load_default(15)
    draw.text((4, 10), title, fill=(40, 40, 40), font=font)
    if not len(known):
        draw.text((4, 60), phrase("strain.map_empty"), fill=(40, 40, 40), font=font)
    else:
        tall = max(size[1], 220) - 20
        bar = _coloured(np.linspace(1, 0, tall))[:, None].repeat(BAR_PX, axis=1)
        sheet.paste(Image.fromarray(bar.astype(np.uint8)), (size[0] + 12, 50))
        places = ticks((float(low), float(high)))
        for value, text in zip(places, tick_labels(places), strict=True):
            down = 50 + tall * (high - value) / (high - low)
            draw.text((size[0] + BAR_PX + 18, down), text, fill=(40, 40, 40), font=font, anchor="lm")
    sheet.save(path, compress_level=1)


def _coloured(share: Array) -> Array:
    """(..., 3) of shares from 0 to 1 of the ramp."""
    place = np.clip(share, 0, 1) * (len(RAMP) - 1)
    at = np.minimum(place.astype(int), len(RAMP) - 2)
    rest = (place - at)[..., None]
    return RAMP[at] * (1 - rest) + RAMP[at + 1] * rest
