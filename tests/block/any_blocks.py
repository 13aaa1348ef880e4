"""Any block: every field of every table, drawn by hypothesis from what the tables declare."""

from dataclasses import MISSING, fields, replace

import numpy as np
from hypothesis import strategies as st
from hypothesis.extra.numpy import arrays

from raybundle.block import Block, Camera, Images, Instrument, Observations, Points
from raybundle.block.block import PixelFrame, Relation
from raybundle.observations import tables
from raybundle.observations.parameter import Calibrated
from raybundle.platforms import instrument_models

number = st.floats(allow_nan=False, width=64)
name = st.text(st.characters(exclude_categories=["Cs", "Cc"]), min_size=1, max_size=12)
symbols = st.dictionaries(st.sampled_from(["c", "x0", "K1", "P1", "own symbol"]), number, max_size=4)
estimate = st.one_of(st.just("auto"), st.tuples(), st.tuples(st.just("c"), st.just("K1")))
relation = st.builds(
    Relation, name=name, terms=symbols, sigma=number, observed=number, logarithm=st.booleans(),
    origin=st.sampled_from(["", "known before", "calibration"]),
)  # fmt: skip
calibrated = st.builds(
    Calibrated, symbols=st.just(("c", "K1")), values=st.tuples(number, number), sigma=st.tuples(number, number),
    correlations=st.just(((1.0, 0.25), (0.25, 1.0))),
)  # fmt: skip
common = {
    "estimate": estimate, "sigma": symbols, "known": symbols, "calibrated": st.none() | calibrated,
    "relations": st.lists(relation, max_size=2).map(tuple),
}  # fmt: skip
camera = st.builds(
    Camera, id=name, model=name, width_px=st.integers(1, 10**6), height_px=st.integers(1, 10**6),
    pixel_mm=st.tuples(number, number), values=symbols, interior=st.sampled_from(["shared", "per_image"]),
    per_image=st.sampled_from([(), ("K1",), ("c", "x0")]), scene=st.none(), **common,
)  # fmt: skip
instrument = st.builds(
    Instrument, id=name, model=st.sampled_from(sorted(instrument_models)),
    values=st.dictionaries(st.sampled_from(["ax", "sx", "bx"]), number), **common,
)  # fmt: skip
frame = st.builds(
    PixelFrame, turned=st.sampled_from([0, 90, 180, 270]), width_px=st.integers(1, 9999),
    height_px=st.integers(1, 9999), affine=st.one_of(st.none(), st.tuples(*[number] * 6)),
)  # fmt: skip
ELSEWHERE = {"place", "scene"}
"""Fields that are kept in other ways: a place by the project, a scene as the file that it is read from."""


BY_ROW = {"interior": symbols, "frames": frame}
"""What columns hold that are mappings by row."""


@st.composite
def blocks(draw, elements=None):
    """Blocks of any numbers, tables of any length, names in any script.

    elements  of arrays of numbers; any by default
    """
    n, p = draw(st.integers(1, 4)), draw(st.integers(0, 5))
    m = draw(st.integers(0, 8)) if p else 0
    cameras = named_apart(draw(st.lists(camera, min_size=1, max_size=3)))
    instruments = named_apart(draw(st.lists(instrument, max_size=2)))
    counts = {
        "point": p, "image": n, "camera": len(cameras), "instrument": len(instruments), "station": 4, "choice": 3,
    }  # fmt: skip

    def rows(kind, count):
        return any_rows(draw, kind, counts, count, elements)

    def some(kind):
        least = min(counts[c.of] for _, c in kind.columns() if c.of in counts and not c.empty)
        return rows(kind, draw(st.integers(0, 4)) if least else 0)

    images, points = (
        replace(t, ids=tuple(f"{k} {i}" for k, i in enumerate(t.ids))) for t in (rows(Images, n), rows(Points, p))
    )
    return Block(
        name=draw(name), about=draw(st.text(max_size=20)), source=draw(name), licence=draw(name),
        length_unit=draw(st.sampled_from(["m", "mm"])), free_scale=draw(st.booleans()),
        nominal_scale=draw(st.booleans()), sigma0_apriori=draw(number),
        residuals=draw(st.sampled_from(["measured", "corrected"])),
        noise=draw(st.sampled_from(["", "white", "fields"])), datum_over=draw(st.sampled_from(["", "all", "good"])),
        rejected=tuple(draw(st.lists(st.tuples(name, name), max_size=2))), cameras=cameras, instruments=instruments,
        images=images, points=points, observations=rows(Observations, m),
    ).having(*map(some, tables.values()))  # fmt: skip


def named_apart(things):
    """Cameras or instruments with ids of their own."""
    return tuple(replace(t, id=f"{k} {t.id}") for k, t in enumerate(things))


def any_rows(draw, kind, counts, k, elements=None):
    """A table of any kind with any content, from what its columns say."""
    elements = st.floats(width=64) if elements is None else elements

    def values(field, c):
        if c.optional and draw(st.booleans()):
            return None
        if c.of == "text":
            return tuple(draw(name) for _ in range(k))
        if c.of == "by row":
            return draw(st.dictionaries(st.integers(0, k - 1), BY_ROW[field], max_size=3)) if k else {}
        if c.of == "mask":
            return draw(arrays(bool, k))
        if c.of != "number":
            low = -1 if c.empty else 0
            return draw(arrays(np.int32, k, elements=st.integers(low, max(counts[c.of] - 1, low))))
        return draw(arrays(float, (k, *c.shape), elements=elements))

    return kind(**{field: values(field, c) for field, c in kind.columns()})


def always_as_by_default(drawn):
    """Names of fields that none of the drawn blocks has set: what a property over them says nothing of."""
    found = set()
    for kind, made in (
        (Block, drawn), (Camera, [c for b in drawn for c in b.cameras]), (Images, [b.images for b in drawn]),
        (Instrument, [i for b in drawn for i in b.instruments]),
        *((t, [b.tables[name] for b in drawn if name in b.tables]) for name, t in tables.items()),
    ):  # fmt: skip
        for f in fields(kind):
            usual = f.default_factory() if f.default_factory is not MISSING else f.default
            if f.name not in ELSEWHERE and all(_same(getattr(x, f.name), usual) for x in made):
                found.add(f"{kind.__name__}.{f.name}")
    return found


def _same(value, usual):
    return value is usual or (
        not isinstance(value, np.ndarray) and not isinstance(usual, np.ndarray) and value == usual
    )
