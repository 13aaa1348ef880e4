"""Names of unknowns are those of what a step of them moves."""

import numpy as np
import pytest

from raybundle.adjustment.system.defects import named_unknown, shares
from tests.native.cases import CASES
from tests.native.test_kernels import setting

PARTS = ("X", "Y", "Z", "rotation_x", "rotation_y", "rotation_z")


@pytest.mark.parametrize("case", ["scale bars", "interior orientation per image", "held images, observed c"])
def test_each_unknown_is_called_by_what_it_moves(case):
    normals, state = setting(CASES[case](), compiled=True, threads=1)
    system, block = normals.system, normals.system.block
    still = np.zeros_like(state.xyz)
    retained = {int(system.offsets[n]): p for p, n in enumerate(system.point_node.tolist()) if n >= 0}
    for unknown in range(int(system.offsets[-1])):
        step = np.zeros(int(system.offsets[-1]))
        step[unknown] = 1e-3
        moved = system.updated(state, step, still)
        stated, words = named_unknown(system, unknown)
        images, axes = np.nonzero(moved.centre != state.centre)
        turned = np.flatnonzero((moved.rotation != state.rotation).any(axis=(1, 2)))
        rows, places = np.nonzero(moved.interior != state.interior)
        if len(images):
            assert (stated.kind, stated.name) == ("image", block.images.ids[images[0]])
            assert words.values == {"image": stated.name, "part": PARTS[axes[0]]}
        elif len(turned):
            assert (stated.kind, stated.name) == ("image", block.images.ids[turned[0]])
            change = moved.rotation[turned[0]] @ state.rotation[turned[0]].T - np.eye(3)
            axis = int(np.abs([change[2, 1], change[0, 2], change[1, 0]]).argmax())
            assert words.values == {"image": stated.name, "part": PARTS[3 + axis]}
        elif len(rows):
            row = system.interior[rows[0]]
            symbol = row.model.symbols[places[0]]
            of_image = "" if row.image < 0 else block.images.ids[row.image]
            assert (stated.kind, stated.name, stated.symbol, stated.image) == ("parameter", "1", symbol, of_image)
            assert words.values == {"symbol": symbol, "camera": f"1/{of_image}" if of_image else "1"}
        else:
            first = max(u for u in retained if u <= unknown)
            assert (stated.kind, stated.name) == ("point", block.points.ids[retained[first]])
            assert words.values == {"point": stated.name, "axis": "XYZ"[unknown - first]}


@pytest.mark.parametrize("case", ["scale bars", "interior orientation per image", "held images, observed c"])
def test_shares_of_objects_are_those_of_their_unknowns(case):
    """Of a space of drawn vectors, by the names of the unknowns; together they are its dimension."""
    normals, _ = setting(CASES[case](), compiled=True, threads=1)
    N = int(normals.system.offsets[-1])
    vectors = np.linalg.qr(np.random.default_rng(2).normal(size=(N, 4)))[0]
    expected = {}
    for unknown, row in enumerate(vectors):
        of = named_unknown(normals.system, unknown)[0]
        key = of.kind, of.name, of.symbol, of.image
        expected[key] = expected.get(key, 0.0) + float(row @ row)
    found = shares(normals, vectors)
    assert {(u.kind, u.name, u.symbol, u.image): u.share for u in found} == pytest.approx(expected)
    assert sum(u.share for u in found) == pytest.approx(4)
    assert [round(u.share, 2) for u in found] == sorted((round(u.share, 2) for u in found), reverse=True)
