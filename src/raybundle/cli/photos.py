"""`raybundle photos`."""

from __future__ import annotations

import json
import math
from collections.abc import Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Any

import click

from raybundle.cli.common import FOLDER, Command, common_options
from raybundle.cli.settings import options_of, values_of
from raybundle.cli.summary import Summary, not_usable, of_texts
from raybundle.cli.summary import report as report_summary
from raybundle.commands.photos import PhotosSettings, run_photos
from raybundle.errors import Message, Severity, note, text_json
from raybundle.settings import made

if TYPE_CHECKING:
    from raybundle.io.photos.cameras import CameraGroup
    from raybundle.io.photos.photo import Found, Photo

SHOWN = 100
"""Photographs that the table lists."""


@click.command("photos", cls=Command)
@click.argument("photos", type=FOLDER, nargs=-1, required=True, metavar="PHOTOS...")
@options_of(PhotosSettings)
@click.option("--json", "as_json", is_flag=True, help="Print everything as JSON.")
@common_options
def command(photos: tuple[Path, ...], as_json: bool, progress: str, **given: Any) -> int:  # noqa: FBT001
    """List facts about photographs: cameras, approximate values, positions, unusable files.

    Exit status 2 if none can be used.

    \b
    Example:
      raybundle photos images/
      raybundle photos images/ --json
    """
    from raybundle.cli.progress import reporting

    settings = made(PhotosSettings, {"photos": photos, **values_of(PhotosSettings, given)})
    with reporting(progress) as notify:
        known = run_photos(settings, notify)
    found, groups = known.found, known.cameras
    if as_json:
        click.echo(json.dumps(report(found, groups), indent=1))
    else:
        report_summary(summary(found, groups))
    return 0 if found.photos else 2


def report(found: Found, groups: Sequence[CameraGroup]) -> dict[str, Any]:
    """What is known, for JSON."""
    return {
        "cameras": [
            {
                "id": g.id, "name": g.name, "photos": len(g.photos), "width_px": g.width_px, "height_px": g.height_px,
                "pixel_mm": list(g.pixel_mm), "c_mm": g.c_mm, "sigma_c_mm": g.sigma_c_mm, "c_px": g.c_px,
                "sigma_c_px": g.sigma_c_px, "source": g.source, "remarks": list(g.stated),
            }
            for g in groups
        ],
        "photos": [
            _photo(p, next(g.id for g in groups if k in g.photos)) for k, p in enumerate(found.photos)
        ],
        "refused": [{"file": str(path), "reason": reason, **text_json(reason)} for path, reason in found.refused],
        "remarks": list(found.remarks),
    }  # fmt: skip


def _photo(photo: Photo, camera: str) -> dict[str, Any]:
    m = photo.metadata
    position = None
    if m.gps is not None:
        sigma = None if m.gps.sigma_m is None else [None if math.isnan(s) else s for s in m.gps.sigma_m]
        position = {
            "latitude_deg": m.gps.latitude_deg, "longitude_deg": m.gps.longitude_deg, "altitude_m": m.gps.altitude_m,
            "altitude_reference": m.gps.altitude_reference, "sigma_m": sigma, "fix": m.gps.fix,
        }  # fmt: skip
    return {
        "name": photo.name, "file": str(photo.path), "camera": camera, "width_px": photo.width_px,
        "height_px": photo.height_px, "orientation": photo.orientation, "bits": photo.bits, "sha256": photo.sha256,
        "make": m.make, "model": m.model, "serial": m.serial, "lens": m.lens, "focal_mm": m.focal_mm,
        "focal35_mm": m.focal35_mm, "taken": None if m.taken is None else m.taken.isoformat(), "position": position,
        "gimbal_deg": m.gimbal, "flight_deg": m.flight, "remarks": list(m.remarks),
    }  # fmt: skip


def summary(found: Found, groups: Sequence[CameraGroup]) -> Summary:
    """What is known, for a terminal."""
    cameras = [
        note("photographs.camera", camera=g.id, name=g.name, n=len(g.photos), width_px=g.width_px,
             height_px=g.height_px, c_px=g.c_px, sigma_px=g.sigma_c_px, c_mm=g.c_mm, source=str(g.source))
        for g in groups
    ]  # fmt: skip
    return Summary(
        done=[note("photographs.found", n=len(found.photos), cameras=len(groups))],
        table=[*cameras, *_table(found, groups)],
        notices=[*not_usable([(p.name, why) for p, why in found.refused]),
                 *of_texts([*(r for g in groups for r in g.stated), *found.remarks], Severity.NOTE)],
    )  # fmt: skip


def _table(found: Found, groups: Sequence[CameraGroup]) -> list[Message | str]:
    of = {k: g.id for g in groups for k in g.photos}
    rows = [("photograph", "camera", "turn", "taken", "position", "sigma")]
    for k, p in enumerate(found.photos[:SHOWN]):
        m = p.metadata
        taken = "" if m.taken is None else m.taken.strftime("%Y-%m-%d %H:%M:%S")
        turn = {1: "", 3: "180", 6: "90", 8: "270"}.get(p.orientation, "mirror")
        rows.append((p.name, of[k], turn, taken, *_position(p)))
    used = [c for c in range(len(rows[0])) if any(r[c] for r in rows[1:])]
    widths = {c: max(len(r[c]) for r in rows) for c in used}
    text = ["   " + "  ".join(r[c].ljust(widths[c]) for c in used).rstrip() for r in rows if len(rows) > 1]
    more = len(found.photos) - SHOWN
    return [*text, *([note("photographs.more", n=more)] if more > 0 else [])]


def _position(photo: Photo) -> tuple[str, str]:
    gps = photo.metadata.gps
    if gps is None:
        return "", ""
    height = "" if gps.altitude_m is None else f" {gps.altitude_m:.1f} m"
    fix = f" ({gps.fix})" if gps.fix else ""
    sigma = "" if gps.sigma_m is None else " ".join("?" if math.isnan(s) else f"{s:.3g}" for s in gps.sigma_m) + " m"
    return f"{gps.latitude_deg:.6f} {gps.longitude_deg:.6f}{height}{fix}", sigma
