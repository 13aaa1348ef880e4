"""A block as named arrays, for the cache of a project: exact, quick, without objects."""

from __future__ import annotations

import json
from collections.abc import Mapping, Sequence
from dataclasses import asdict
from typing import Any

import numpy as np

from raybundle.block import Block, Camera, Images, Instrument, Observations, Points
from raybundle.block.block import PixelFrame, Relation
from raybundle.io.reading.trees import own_json_of
from raybundle.numerics.arrays import Array
from raybundle.observations import tables
from raybundle.observations.parameter import Calibrated
from raybundle.observations.table import Table


def arrays_of_block(block: Block) -> dict[str, Array]:
    """The arrays; `block_of_arrays` makes the equal block of them."""
    head = {
        "name": block.name,
        "about": block.about,
        "source": block.source,
        "licence": block.licence,
        "length_unit": block.length_unit,
        "free_scale": block.free_scale,
        "sigma0_apriori": block.sigma0_apriori,
        "residuals": block.residuals,
        "noise": block.noise,
        "datum_over": block.datum_over,
        "cameras": [
            {**asdict(c), "values": dict(c.values), "sigma": dict(c.sigma), "known": dict(c.known)}
            for c in block.cameras
        ],
        "instruments": [
            {**asdict(c), "values": dict(c.values), "sigma": dict(c.sigma), "known": dict(c.known)}
            for c in block.instruments
        ],
        "interior": {str(k): dict(v) for k, v in block.images.interior.items()},
        "held": block.images.held is not None,
        "frames": {str(k): asdict(f) for k, f in block.images.frames.items()},
    }
    i, o, p = block.images, block.observations, block.points
    return {
        "head": np.array(json.dumps(head)),
        "image_ids": np.array(i.ids, dtype=np.str_),
        "image_file": np.array(i.file, dtype=np.str_),
        "image_camera": i.camera,
        "centre": i.centre,
        "rotation": i.rotation,
        "image_held": np.zeros(0, bool) if i.held is None else i.held,
        "observation_image": o.image,
        "observation_point": o.point,
        "xy_px": o.xy_px,
        "cov_px2": o.cov_px2,
        "point_ids": np.array(p.ids, dtype=np.str_),
        "rejected": np.array(block.rejected, dtype=np.str_).reshape(-1, 2),
        "role": p.role,
        "xyz": p.xyz,
        "sigma": p.sigma,
        **{f"{t.name}.{field}": values for t in block.tables.values() for field, values in t.arrays().items()},
        **({} if i.station is None else {"image_station": i.station}),
    }


def _frame(kept: dict[str, Any]) -> PixelFrame:
    affine: Any = kept.get("affine")
    same: dict[str, Any] = {**kept, "affine": None if affine is None else tuple(affine)}
    return PixelFrame(**same)


def block_of_arrays(a: Mapping[str, Array]) -> Block:
    """The block that `arrays_of_block` was given."""
    head: dict[str, Any] = own_json_of(str(a["head"]))
    return Block(
        name=head["name"],
        about=head["about"],
        source=head["source"],
        licence=head["licence"],
        length_unit=head["length_unit"],
        free_scale=bool(head["free_scale"]),
        sigma0_apriori=head["sigma0_apriori"],
        residuals=head["residuals"],
        noise=head["noise"],
        datum_over=head["datum_over"],
        rejected=tuple((i, p) for i, p in a["rejected"].tolist()),
        cameras=tuple(_camera(c) for c in head["cameras"]),
        instruments=tuple(Instrument(**_parameters(c)) for c in head["instruments"]),
        images=Images(
            ids=tuple(a["image_ids"].tolist()),
            camera=a["image_camera"],
            file=tuple(a["image_file"].tolist()),
            centre=a["centre"],
            rotation=a["rotation"],
            held=a["image_held"] if head["held"] else None,
            interior={int(k): v for k, v in head["interior"].items()},
            station=a.get("image_station"),
            frames={int(k): _frame(f) for k, f in head["frames"].items()},
        ),
        observations=Observations(
            image=a["observation_image"], point=a["observation_point"], xy_px=a["xy_px"], cov_px2=a["cov_px2"]
        ),
        points=Points(ids=tuple(a["point_ids"].tolist()), role=a["role"], xyz=a["xyz"], sigma=a["sigma"]),
        tables={name: kept for name, table in tables.items() if (kept := _table(table, a)) is not None},
    )


def text_of_names(names: Sequence[str]) -> str:
    """Names as one text, for an array of texts; `names_of_text` gives them back."""
    return json.dumps(list(names))


def names_of_text(text: str) -> tuple[str, ...]:
    """The names that `text_of_names` was given."""
    return tuple(own_json_of(text))


def _table(table: type[Table], a: Mapping[str, Array]) -> Table | None:
    """A table of a block; None where nothing of it was kept."""
    head = f"{table.name}."
    found = {name.removeprefix(head): values for name, values in a.items() if name.startswith(head)}
    return table.of_arrays(found) if found else None


def _camera(values: dict[str, Any]) -> Camera:
    return Camera(
        **_parameters(values),
        width_px=values["width_px"],
        height_px=values["height_px"],
        pixel_mm=(values["pixel_mm"][0], values["pixel_mm"][1]),
        interior=values["interior"],
        per_image=tuple(values["per_image"]),
    )


def _parameters(values: dict[str, Any]) -> dict[str, Any]:
    """What cameras and instruments have in common."""
    return {
        "id": values["id"],
        "model": values["model"],
        "values": values["values"],
        "estimate": "auto" if values["estimate"] == "auto" else tuple(values["estimate"]),
        "sigma": values["sigma"],
        "calibrated": _calibrated(values["calibrated"]),
        "relations": tuple(Relation(**r) for r in values["relations"]),
        "known": values["known"],
    }


def _calibrated(values: dict[str, Any] | None) -> Calibrated | None:
    if values is None:
        return None
    rows = tuple(tuple(row) for row in values["correlations"])
    return Calibrated(
        symbols=tuple(values["symbols"]), values=tuple(values["values"]), sigma=tuple(values["sigma"]),
        correlations=rows,
    )  # fmt: skip
