"""What a block and options from Python must be, asked once where they come in: readers of files ask it of files."""

from __future__ import annotations

import typing
from typing import Any

import numpy as np

from raybundle.adjustment.records.options import AdjustmentOptions
from raybundle.block import Block, Role
from raybundle.errors import InputError, message
from raybundle.numerics.arrays import Array
from raybundle.sensors import sensor_models

LARGEST = 1e18
"""Greatest size of a number, as in files: what is computed from such numbers stays finite."""


def check_entry(block: object, options: object) -> None:
    """Raise InputError for a block or options with which nothing can be adjusted, by object, value and remedy."""
    if not isinstance(options, AdjustmentOptions):
        raise InputError("adjustment.options_type", type=type(options).__name__)
    if not isinstance(block, Block):
        raise InputError("adjustment.block_type", type=type(block).__name__)
    _check_options(options)
    _check_shapes(block)
    _check_indices(block)
    _check_numbers(block)
    _check_tables(block)
    _check_cameras(block)


def _check_options(options: AdjustmentOptions) -> None:
    for name, kind in typing.get_type_hints(AdjustmentOptions).items():
        value = getattr(options, name)
        allowed = typing.get_args(kind)
        if typing.get_origin(kind) is typing.Literal and value not in allowed:
            raise InputError("adjustment.option_choice", name=name, given=repr(value), known=[str(a) for a in allowed])
        if kind is bool and not isinstance(value, bool):
            raise InputError("adjustment.option_not_bool", name=name, given=repr(value))
        pairs = bool(allowed) and typing.get_origin(allowed[0]) is tuple
        if typing.get_origin(kind) is tuple and not _is_names(value, pairs=pairs):
            raise InputError("adjustment.option_not_names", name=name, given=repr(value), pairs=pairs)
    numbers: tuple[tuple[str, float, float, bool], ...] = (
        ("max_iterations", 1, 1e6, True), ("jobs", 0, 4096, True), ("tolerance", 1e-15, 1.0, False),
        ("significance", 1e-15, 0.5, False),
    )  # fmt: skip
    for name, low, high, whole in numbers:
        value = getattr(options, name)
        kinds = (int, np.integer) if whole else (int, float, np.number)
        if not isinstance(value, kinds) or isinstance(value, bool) or not low <= float(value) <= high:
            raise InputError("adjustment.option_range", name=name, given=repr(value), whole=whole, low=low, high=high)


def _is_names(value: object, *, pairs: bool) -> bool:
    """Whether a value is a tuple of texts, or of pairs of texts."""
    if not isinstance(value, tuple):
        return False
    values = typing.cast("tuple[object, ...]", value)
    if pairs:
        return all(_is_names(v, pairs=False) and len(typing.cast("tuple[str, ...]", v)) == 2 for v in values)
    return all(isinstance(v, str) for v in values)


def _check_shapes(block: Block) -> None:
    n, p, m = len(block.images.ids), len(block.points.ids), len(np.atleast_1d(block.observations.image))
    shapes: dict[str, dict[str, tuple[int, ...]]] = {
        "images": {"camera": (n,), "file": (n,), "centre": (n, 3), "rotation": (n, 3, 3)},
        "points": {"role": (p,), "xyz": (p, 3), "sigma": (p, 3)},
        "observations": {"image": (m,), "point": (m,), "xy_px": (m, 2), "cov_px2": (m, 3)},
    }
    figures = ("window", "misfit", "relief", "sigma_curvature")
    shapes["points"] |= {name: (p,) for name in figures if getattr(block.points, name) is not None}
    held: dict[str, Any] = {name: getattr(block, name) for name in shapes} | dict(block.tables)
    for name, table in block.tables.items():
        first: Any = getattr(table, next(table.cells())[0])
        k = len(first if isinstance(first, tuple) else np.atleast_1d(first))
        there = [(field, c) for field, c in table.cells() if getattr(table, field) is not None]
        shapes[name] = {field: (k, len(c.names)) if len(c.names) > 1 else (k,) for field, c in there}
    for table, columns in shapes.items():
        for name, shape in columns.items():
            value: Any = getattr(held[table], name)
            found = (len(value),) if isinstance(value, tuple) else getattr(value, "shape", None)
            if found != shape:
                raise InputError(
                    "block.shape", block=block.name, name=f"{table}.{name}", shape=[*shape],
                    type=type(value).__name__, found=[*found] if isinstance(found, tuple) else [],
                )  # fmt: skip
            if not isinstance(value, tuple) and value.dtype.kind not in "fiu":
                raise InputError("block.not_numbers", block=block.name, name=f"{table}.{name}", type=str(value.dtype))


def _check_indices(block: Block) -> None:
    n, p, c = len(block.images.ids), len(block.points.ids), len(block.cameras)
    o, counts = block.observations, {"image": n, "point": p, "camera": c}
    named = [
        (f"{table.name}.{field}", getattr(table, field), counts[cells.of], -1 if cells.empty else 0)
        for table in block.tables.values()
        for field, cells in table.cells()
        if cells.of in counts and getattr(table, field) is not None
    ]
    for name, values, count, least in (
        ("images.camera", block.images.camera, c, 0), ("observations.image", o.image, n, 0),
        ("observations.point", o.point, p, 0), *named,
    ):  # fmt: skip
        if values.dtype.kind not in "iu":
            raise InputError("block.not_whole_numbers", block=block.name, name=name, type=str(values.dtype))
        bad = np.flatnonzero((values < least) | (values >= count))
        if len(bad):
            raise InputError(
                "block.position_out_of_range",
                block=block.name,
                name=name,
                row=int(bad[0]),
                position=int(values[bad[0]]),
                last=count - 1,
            )


def _check_tables(block: Block) -> None:
    """What readers ask of the rows of files: limits, no gaps where there must be none, what a table refuses."""
    for table in block.tables.values():
        for field, c in table.cells():
            values: Any = getattr(table, field)
            if c.of != "number" or values is None or not len(values):
                continue
            wide = np.reshape(values, (len(values), -1))
            for mask, code in (
                (np.isnan(wide) & (not c.empty), "cell.empty"), ((wide <= 0) & (c.limit == "> 0"), "cell.not_positive"),
                ((wide < 0) & (c.limit == ">= 0"), "cell.negative_sigma"),
            ):  # fmt: skip
                for k, axis in np.argwhere(mask)[:1].tolist():
                    value = f"{wide[k, axis]:g}"
                    why = message(code) if code == "cell.empty" else message(code, value=value)
                    raise table.refused(k, c.names[axis], why)
        table.check()


def _check_cameras(block: Block) -> None:
    for camera in block.cameras:
        if camera.is_scene:
            continue
        if camera.model not in sensor_models:
            raise InputError("camera.model_unknown", camera=camera.id, model=camera.model, known=sorted(sensor_models))
        symbols = sensor_models[camera.model].symbols
        unknown = [s for s, value in camera.values.items() if value and s not in symbols]  # a term of 0 has no effect
        if unknown:
            known = list(symbols)
            raise InputError("camera.symbols_unknown", camera=camera.id, model=camera.model, names=unknown, known=known)


def _check_numbers(block: Block) -> None:
    images, points, o = block.images, block.points, block.observations
    for name, ids, values, gaps in (
        ("image", images.ids, images.centre, True), ("point", points.ids, points.xyz, True),
        ("", (), o.xy_px, False), ("", (), o.cov_px2, False),
    ):  # fmt: skip
        wrong = ~(np.abs(values) <= LARGEST) & ~(np.isnan(values) & gaps)
        rows = np.flatnonzero(wrong.any(axis=1))
        if len(rows):
            k = int(rows[0])
            raise InputError(
                "block.number_too_large", kind=name or "observation",
                image="" if name == "point" else ids[k] if ids else images.ids[o.image[k]],
                point="" if name == "image" else ids[k] if ids else points.ids[o.point[k]],
                number=float(values[k][wrong[k]][0]), limit=LARGEST,
            )  # fmt: skip
    for name in ("window", "misfit", "relief", "sigma_curvature"):
        figures: Array | None = getattr(points, name)
        if figures is None:
            continue
        for k in np.flatnonzero(figures <= 0)[:1].tolist():
            value = f"{figures[k]:g}"
            raise InputError("cell.not_positive", file="points.csv", line=k + 2, column=name, value=value)
    sigma = points.sigma
    wrong = (sigma < 0) | (sigma > LARGEST)
    control = (np.asarray(points.role) == Role.CONTROL)[:, None]
    lost = control & np.isfinite(sigma) & ~np.isfinite(points.xyz)
    for mask, code in ((wrong, "point.sigma_out_of_range"), (lost, "point.no_coordinate")):
        rows = np.argwhere(mask)
        if len(rows):
            k, axis = rows[0]
            raise InputError(code, point=points.ids[k], axis="XYZ"[axis], sigma=float(sigma[k, axis]))
