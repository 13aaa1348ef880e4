"""Fingerprints: equal for equal tables, different for any change."""

from dataclasses import replace

import numpy as np

from raybundle.report.fingerprint import fingerprint, fingerprints, versions


def test_equal_tables_have_equal_fingerprints():
    a = np.array([[0.0, np.nan], [1.0, -2.5]])
    assert fingerprint(a) == fingerprint(np.array([[-0.0, -np.nan], [1.0, -2.5]]))
    assert fingerprint(a) == fingerprint(np.asfortranarray(a))
    assert fingerprint(np.arange(3, dtype=np.int32)) == fingerprint(np.arange(3.0))


def test_shape_order_and_bounds_count():
    a = np.arange(6.0)
    assert fingerprint(a) != fingerprint(a.reshape(2, 3))
    assert fingerprint(a[:3], a[3:]) != fingerprint(a[:2], a[2:])
    assert fingerprint(["ab", "c"]) != fingerprint(["a", "bc"])
    assert fingerprint(["a\0b"]) != fingerprint(["a", "b"])


def test_every_table_of_a_block_counts(case):
    block = case("rich").given
    before = {name: print_ for name, _, print_ in fingerprints(block)}
    assert set(before) == {"cameras", "images", "observations", "points", "distances", "stations"}
    xy = block.observations.xy_px.copy()
    xy[3, 1] += 1e-9
    changed = {
        "observations": replace(block, observations=replace(block.observations, xy_px=xy)),
        "points": replace(block, points=replace(block.points, ids=("other", *block.points.ids[1:]))),
        "cameras": replace(block, cameras=(replace(block.cameras[0], width_px=1),)),
        "distances": block.having(replace(block.distances, sigma=block.distances.sigma * 2)),
        "stations": block.having(replace(block.stations, sigma=block.stations.sigma * 2)),
        "images": replace(block, images=replace(block.images, centre=block.images.centre + 1)),
    }
    for table, other in changed.items():
        after = {name: print_ for name, _, print_ in fingerprints(other)}
        assert {n for n in before if before[n] != after[n]} == {table}


def test_versions_are_known():
    found = versions()
    assert found["NumPy"] == np.__version__
    assert all(found.values())
