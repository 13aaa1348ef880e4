"""Any block: every field of every table, drawn by hypothesis from what the tables declare."""

from dataclasses import MISSING, fields

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


@st.composite
def blocks(draw):
    """Blocks of any numbers, tables of any length, names in any script."""
    n, p = draw(st.integers(1, 4)), draw(st.integers(0, 5))
    m = draw(st.integers(0, 8)) if p else 0
    cameras = tuple(draw(st.lists(camera, min_size=1, max_size=3)))
    instruments = tuple(draw(st.lists(instrument, max_size=2)))

    def table(*shape):
        return draw(arrays(float, shape, elements=st.floats(width=64)))

    def index(count, below):
        return draw(arrays(np.int32, count, elements=st.integers(0, max(below - 1, 0))))

    images = Images(
        ids=tuple(f"{k} {draw(name)}" for k in range(n)), camera=index(n, len(cameras)),
        file=tuple(draw(st.one_of(st.just(""), name)) for _ in range(n)), centre=table(n, 3), rotation=table(n, 3, 3),
        held=draw(st.one_of(st.none(), arrays(bool, n))),
        interior=draw(st.dictionaries(st.integers(0, n - 1), symbols, max_size=3)),
        station=draw(st.one_of(st.none(), arrays(np.int32, n, elements=st.integers(0, 3)))),
        frames=draw(st.dictionaries(st.integers(0, n - 1), frame, max_size=2)),
    )  # fmt: skip
    points = Points(
        ids=tuple(f"{k} {draw(name)}" for k in range(p)), role=index(p, 3), xyz=table(p, 3), sigma=table(p, 3)
    )
    counts = {"point": p, "image": n, "instrument": len(instruments)}
    return Block(
        name=draw(name), about=draw(st.text(max_size=20)), source=draw(name), licence=draw(name),
        length_unit=draw(st.sampled_from(["m", "mm"])), free_scale=draw(st.booleans()), sigma0_apriori=draw(number),
        residuals=draw(st.sampled_from(["measured", "corrected"])),
        noise=draw(st.sampled_from(["", "white", "fields"])), datum_over=draw(st.sampled_from(["", "all", "good"])),
        rejected=tuple(draw(st.lists(st.tuples(name, name), max_size=2))), cameras=cameras, instruments=instruments,
        images=images, points=points,
        observations=Observations(image=index(m, n), point=index(m, p), xy_px=table(m, 2), cov_px2=table(m, 3)),
    ).having(*(any_rows(draw, t, counts) for t in tables.values()))  # fmt: skip


def any_rows(draw, table, counts):
    """A table of any kind with any content."""
    least = min(counts[c.of] for _, c in table.cells() if c.of in counts and not c.empty)
    k = draw(st.integers(0, 4)) if least else 0

    def values(c):
        if c.optional and draw(st.booleans()):
            return None
        if c.of == "text":
            return tuple(draw(name) for _ in range(k))
        if c.of != "number":
            low = -1 if c.empty else 0
            return draw(arrays(np.int32, k, elements=st.integers(low, max(counts[c.of] - 1, low))))
        shape = (k, len(c.names)) if len(c.names) > 1 else k
        return draw(arrays(float, shape, elements=st.floats(width=64)))

    return table(**{field: values(c) for field, c in table.cells()})


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
