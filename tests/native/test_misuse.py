"""Wrong calls of the compiled functions: a Python exception each, never a dead process; each call in a child."""

import os
import signal

import numpy as np
import pytest

from raybundle.adjustment.system.dense import set_dense_kernels
from raybundle.numerics import native

pytestmark = [
    pytest.mark.skipif(not native.available(), reason="the kernels are not compiled"),
    pytest.mark.skipif(not hasattr(os, "fork"), reason="the system has no fork"),
]
IMAGES, POINTS, ROWS, STRIDE = 2, 2, 4, 10
BROWN = sorted(native.sensor_models() | {"brown"}).index("brown")
GOOD = {
    "image": np.array([0, 1, 0, 1]),
    "point": np.array([0, 0, 1, 1]),
    "xy": np.full((ROWS, 2), 0.5),
    "whiten": np.ones((ROWS, 3)),
    "external_row": np.full(ROWS, -1),
    "model": np.array([BROWN, BROWN]),
    "corrected": np.zeros(IMAGES),
    "interior": np.zeros(IMAGES),
    "pattern": np.zeros(IMAGES),
    "own": np.array([0, 1]),
    "shared": np.array([2, 2]),
    "parameters": np.array([STRIDE, STRIDE]),
    "stride": STRIDE,
    "patterns": [([0, 1, 2, 3, 4, 5], [6, 7])],
    "first": np.array([0, 2, 4]),
    "node": np.array([-1, 3]),
    "held": np.zeros(POINTS),
    "weight": np.zeros((POINTS, 3)),
    "value": np.zeros((POINTS, 3)),
    "sizes": np.array([6, 6, 2, 3]),
    "extra": [(0, 1)],
}
WRONG = {
    "image": ([0, 1, 0, 99_999_999], [0, 1, 0, -1], [0, 1, 0], []),
    "point": ([0, 0, 1, 2], [0, 0, 1, -7], [0] * 5),
    "xy": (np.zeros((3, 2)), np.zeros(0)),
    "whiten": (np.zeros((4, 2)),),
    "external_row": ([0] * 3,),
    "model": ([BROWN, 9999], [BROWN, -2], [-1, -1], [BROWN]),
    "corrected": ([0],),
    "interior": ([0, -1], [0, 2_000_000_000], [0]),
    "pattern": ([0, 1], [0, -1], [0]),
    "own": ([0, 4], [0, -2], [0, -1], [0, 3], [0]),
    "shared": ([2, 4], [2, -2], [-1, -1], [2]),
    "parameters": ([10, -1], [10, 65], [10]),
    "stride": (0, -10, 9, 100_000),
    "patterns": ([], [([0, 99], [])], [([-1], [])], [([0, 1, 2, 3, 4, 5], [5])], [(list(range(6)) * 2, [])]),
    "first": ([0, 2, 99], [0, 5, 4], [1, 2, 4], [0, 2], [0, 2, 3], [0, -1, 4]),
    "node": ([-1, 4], [-1, -2], [-1, 2], [-1]),
    "held": ([0],),
    "weight": (np.zeros((1, 3)), np.zeros(0)),
    "value": (np.zeros((2, 2)),),
    "sizes": ([6, 6, 2], [6, 6, 2, -3], [0, 0, 0, 0], [5, 6, 2, 3], [2**30] * 4, []),
    "extra": ([(0, 9)], [(-1, 0)]),
}
CASES = [(name, k) for name, values in WRONG.items() for k in range(len(values))]


def whole(values):
    return np.asarray(values, np.int32)


def solver(**changes):
    a = GOOD | changes
    s = native.module().Solver()
    s.set_observations(
        whole(a["image"]),
        whole(a["point"]),
        np.asarray(a["xy"], float),
        np.asarray(a["whiten"], float),
        whole(a["external_row"]),
    )
    names = ("model", "corrected", "interior", "pattern", "own", "shared", "parameters")
    s.set_images(*(whole(a[n]) for n in names), a["stride"])
    s.set_patterns(a["patterns"])
    weight, value = (np.asarray(a[n], float) for n in ("weight", "value"))
    s.set_points(np.asarray(a["first"], np.int64), whole(a["node"]), np.asarray(a["held"], np.uint8), weight, value)
    s.set_nodes(whole(a["sizes"]), a["extra"])
    return s


def state(interior=None):
    I = np.tile([10.0, *[0.0] * (STRIDE - 1)], (2, 1)) if interior is None else interior
    return np.tile(np.eye(3), (IMAGES, 1, 1)), np.zeros((IMAGES, 3)), I, np.array([[0.1, 0.2, -5.0], [0.3, 0.1, -6.0]])


def reduced(s, at=None, *, threads=1, size=None):
    v, r, d = (np.zeros(n) for n in size or (s.values_size, s.unknowns, s.unknowns))
    s.reduce(*(at or state()), 0.0, 0.0, threads, v, r, d)
    return v


def factorised():
    set_dense_kernels()
    s = solver()
    v = reduced(s)
    diagonal = [s.block_start(s.block(k, k)) for k in range(4)]
    for start, n in zip(diagonal, (6, 6, 2, 3), strict=True):
        v[start : start + n * n : n + 1] += 1e9
    assert s.factorise(v, np.zeros(0)) == 0
    return s


def unfactorised(what=None):
    """A solver whose factor stood and whose next factorisation stops, at a NaN or without information."""
    s = factorised()
    values = reduced(s) * 0.0 if what is None else np.full(s.values_size, what)
    assert s.factorise(values, np.zeros(0)) > 0
    return s


def in_child(call):
    """The name of the exception that a call raises, "" for none, or the signal that ended the process."""
    reading, writing = os.pipe()
    child = os.fork()
    if child == 0:
        os.close(reading)
        signal.alarm(60)
        try:
            call()
            text = ""
        except BaseException as error:  # noqa: BLE001  (its name is what is asked for)
            text = type(error).__name__
        os.write(writing, text.encode())
        os._exit(0)
    os.close(writing)
    with os.fdopen(reading, "rb") as pipe:
        text = pipe.read().decode()
    status = os.waitpid(child, 0)[1]
    return text if status == 0 else f"signal {status & 127}"


def test_the_right_calls_are_taken():
    s = factorised()
    assert np.isfinite(reduced(s)).all()
    x = np.ones(s.unknowns)
    s.solve(x, 1)
    assert np.isfinite(x).all()
    assert s.pivots(np.zeros(s.unknowns)) is None


@pytest.mark.parametrize(("name", "k"), CASES)
def test_wrong_arrays_are_refused(name, k):
    def call():
        reduced(solver(**{name: WRONG[name][k]}))

    assert in_child(call) in {"ValueError", "IndexError"}


ORDER = {
    "values_size": lambda: native.module().Solver().values_size,
    "factor_entries": lambda: native.module().Solver().factor_entries,
    "smallest_pivot": lambda: solver().smallest_pivot,
    "pivots": lambda: solver().pivots(np.zeros(17)),
    "solve first": lambda: native.module().Solver().solve(np.zeros(0), 1),
    "solve before factorise": lambda: solver().solve(np.zeros(17), 1),
    "solve after a factorisation that stops": lambda: unfactorised().solve(np.zeros(17), 1),
    "solve after a factorisation of NaN": lambda: unfactorised(np.nan).solve(np.zeros(17), 1),
    "inverse after a factorisation that stops": lambda: (s := unfactorised()).selected_inverse(np.zeros(s.values_size)),
    "pivots after a factorisation that stops": lambda: unfactorised().pivots(np.zeros(17)),
    "selected inverse": lambda: solver().selected_inverse(np.zeros(solver().values_size)),
    "block": lambda: native.module().Solver().block(0, 0),
    "set_held first": lambda: native.module().Solver().set_held(np.zeros(0, np.uint8)),
    "set_external first": lambda: native.module().Solver().set_external(np.zeros(11), np.zeros(1, np.int32), 1),
    "set_nodes alone": lambda: native.module().Solver().set_nodes(whole([6]), []),
    "set_nodes twice": lambda: solver().set_nodes(whole(GOOD["sizes"]), []),
    "set_images after set_nodes": lambda: (s := solver(), s.set_patterns(GOOD["patterns"]), s.values_size),
    "reduce of nothing": lambda: (
        native.module().Solver().reduce(*state(), 0.0, 0.0, 1, np.zeros(0), np.zeros(0), np.zeros(0))
    ),
}


@pytest.mark.parametrize("what", ORDER)
def test_the_wrong_order_is_refused(what):
    assert in_child(ORDER[what]) == "ValueError"


SIZES = {
    "values": lambda: reduced(solver(), size=(1, 17, 17)),
    "right": lambda: reduced(solver(), size=(solver().values_size, 1, 17)),
    "rotations": lambda: reduced(solver(), (np.zeros((1, 3, 3)), *state()[1:])),
    "interior rows": lambda: reduced(solver(interior=[0, 2])),
    "interior width": lambda: reduced(solver(), state(np.ones((2, 9)))),
    "no interior": lambda: reduced(solver(), state(np.zeros((0, 10)))),
    "points": lambda: reduced(solver(), (*state()[:3], np.zeros((1, 3)))),
    "no threads": lambda: reduced(solver(), threads=0),
    "threads": lambda: reduced(solver(), threads=-5),
    "residuals": lambda: solver().evaluate(*state(), 0.0, 1, np.zeros(3), np.zeros(4, np.uint8)),
    "behind": lambda: solver().evaluate(*state(), 0.0, 1, np.zeros(8), np.zeros(3, np.uint8)),
    "block": lambda: solver().block(99_999_999, 5),
    "block, negative": lambda: solver().block(-1, 0),
    "block start": lambda: solver().block_start(-1),
    "held": lambda: solver().set_held(np.zeros(1, np.uint8)),
    "factorise": lambda: (set_dense_kernels(), solver().factorise(np.zeros(1), np.zeros(0))),
    "added": lambda: (set_dense_kernels(), s := solver(), s.factorise(reduced(s), np.ones(3))),
    "solve": lambda: factorised().solve(np.zeros(17), 2),
    "no columns": lambda: factorised().solve(np.zeros(0), 0),
    "columns": lambda: factorised().solve(np.zeros(0), -1),
    "inverse": lambda: factorised().selected_inverse(np.zeros(3)),
    "condense": lambda: solver().condense(*state(), 1, np.zeros((6, 17)), 17),
    "condense nothing": lambda: solver().condense(*state(), 1, np.zeros(0), 0),
    "expand": lambda: solver().expand(*state(), 1, np.zeros((17, 1)), np.zeros(5), 1),
    "datum": lambda: solver().statistics(*state(), 1, np.zeros(solver().values_size), -1, *[np.zeros(0)] * 4),
    "external width": lambda: solver().set_external(np.zeros(11), np.zeros(2, np.int32), 1),
    "external columns": lambda: solver().set_external(np.zeros(9 + 130), np.zeros(65, np.int32), 65),
    "external is missing": lambda: reduced(solver(model=[BROWN, -1], external_row=[-1, 0, -1, 1])),
    "half a window": lambda: windows(half=2**30),
    "half a window, 1": lambda: windows(half=1),
    "half a window, 257": lambda: windows(half=257),
    "starts": lambda: windows(start=np.zeros((2, 2))),
    "dots": lambda: native.module().fit_dots(grey(), np.zeros((1, 2)), np.zeros((1, 2)), np.ones(1), 5, 0.01, 5.0, 0.5),
    "masked dots": lambda: masked(np.zeros((1, 9)), [[0, 0, 5, 5]], [0, 25]),
    "boxes of dots": lambda: masked(np.zeros((1, 10)), [[0, 0, 5, 500]], [0, 2500]),
    "boxes turned round": lambda: masked(np.zeros((1, 10)), [[5, 5, 0, 0]], [0, 25]),
    "pixels of dots": lambda: masked(np.zeros((1, 10)), [[0, 0, 5, 5]], [0, 24]),
    "judged dots": lambda: judged(np.ones((1, 9)), [[0, 0, 5, 5]], [0, 25]),
    "boxes of judged dots": lambda: judged(np.ones((1, 10)), [[0, 0, 5, 500]], [0, 25]),
    "judged dots without a size": lambda: judged(np.zeros((1, 10)), [[0, 0, 5, 5]], [0, 25]),
    "judged dots that are no numbers": lambda: judged(np.full((1, 10), np.nan), [[0, 0, 5, 5]], [0, 25]),
    "pixels of judged dots": lambda: judged(np.ones((1, 10)), [[0, 0, 5, 5]], [0, 24]),
    "residuals of judged dots": lambda: judged(np.ones((1, 10)), [[0, 0, 5, 5]], [0, 25], np.full(25, np.inf)),
    "descriptors": lambda: native.module().best_matches(np.zeros((2, 8), np.float32), np.zeros((2, 9), np.float32)),
    "bytes": lambda: native.module().best_matches_of_bytes(np.zeros((2, 8), np.uint8), np.zeros((2, 12), np.uint8)),
    "odd bytes": lambda: native.module().best_matches_of_bytes(*np.zeros((2, 3, 7), np.uint8)),
}


def grey(height=50, width=50):
    return np.random.default_rng(1).integers(0, 65535, (height, width)).astype(np.uint16)


def masked(values, box, offset):
    free = np.ones(offset[-1], np.uint8)
    return native.module().fit_masked_dots(
        grey(), values, np.array(box, np.int32), np.array(offset), free, 5, 0.01, 5.0, 0.5
    )


def judged(values, box, offset, residuals=None):
    n = offset[-1]
    e = np.zeros(n) if residuals is None else residuals
    return native.module().cover_dots(
        values, np.zeros((len(values), 10, 10)), np.array(box, np.int32), np.array(offset), np.ones(n, np.uint8),
        e, np.zeros((n, 10)), np.array([[3.0, 3.0, 1.5, 0.0]]),
    )  # fmt: skip


def windows(half=5, start=None, at=25.0):
    xy = np.full((3, 2), at)
    affine = np.tile(np.eye(2), (3, 1, 1))
    start = xy if start is None else start
    return native.module().match_windows(grey(), grey(), xy, start, affine, half, 1.0, 20, 0.01, 5.0, 0.1, False, False)


@pytest.mark.parametrize("what", SIZES)
def test_wrong_sizes_are_refused(what):
    assert in_child(SIZES[what]) in {"ValueError", "IndexError"}


def test_rows_of_other_models_are_held_against_their_images():
    def call(touched):
        s = solver(model=[BROWN, -1], external_row=[-1, 0, -1, 1])
        s.set_external(np.zeros((2, 13)), whole(touched), 2)
        reduced(s)

    assert in_child(lambda: call([[0, 1], [1, 0]])) == ""
    assert in_child(lambda: call([[0, 2], [1, 0]])) == "ValueError"
    assert in_child(lambda: call([[-1, -1], [1, 0]])) == "ValueError"


def test_wild_numbers_end_with_an_outcome():
    """Places, windows and shapes that are no numbers, or far outside: measured nowhere, and nobody dies."""

    def call():
        m, rng = native.module(), np.random.default_rng(0)
        wild = np.array([0, 1, -1, 10, 25, np.nan, np.inf, 1e300, 2.0**31, -(2.0**31), 2.0**63])
        for _ in range(300):
            image, n = grey(*rng.integers(1, 60, 2)), 3
            draw = lambda *shape: rng.choice(wild) * rng.random(shape)  # noqa: E731
            m.match_windows(
                image,
                image,
                draw(n, 2),
                draw(n, 2),
                draw(n, 2, 2),
                int(rng.integers(2, 20)),
                1.0,
                5,
                0.01,
                5.0,
                0.1,
                bool(rng.integers(2)),
                bool(rng.integers(2)),
            )
            m.fit_dots(image, draw(n, 2), draw(n, 3), draw(n), 5, 0.01, 5.0, 0.5)
            h, w = image.shape
            m.fit_masked_dots(
                image, draw(1, 10), np.array([[0, 0, w, h]], np.int32), np.array([0, h * w]),
                np.ones(h * w, np.uint8), 5, 0.01, 5.0, 0.5,
            )  # fmt: skip
            m.fit_corners(image, draw(n, 2), draw(n, 2), draw(n, 2), draw(n, 2), draw(n), 1.0, 5)
        m.match_windows(
            grey(0, 0),
            grey(0, 0),
            np.ones((1, 2)),
            np.ones((1, 2)),
            np.ones((1, 2, 2)),
            5,
            1.0,
            5,
            0.01,
            5.0,
            0.1,
            False,
            False,
        )
        reduced(solver(), tuple(np.full_like(a, np.nan) for a in state()))

    assert in_child(call) == ""
