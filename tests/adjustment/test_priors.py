"""What was added to hold an interior orientation is no knowledge: what it shows alone is not determinable."""

from dataclasses import replace

import numpy as np
import pytest

from raybundle.adjustment.engine import adjust_block
from raybundle.adjustment.evaluation.held_interiors import determined_by_network
from raybundle.adjustment.noise_sample import IMAGES, _neighbouring
from raybundle.adjustment.records.options import AdjustmentOptions
from raybundle.adjustment.system.predict import exact_tables
from raybundle.block.select import with_rows
from raybundle.planning.simulate import Survey, simulate
from raybundle.planning.synthetic_networks import AerialStrips, aerial_scene
from tests.native.cases import block_of


@pytest.mark.parametrize("variance", [0.0, 0.25, 4.0])
@pytest.mark.parametrize(("share", "status"), [(0.49, "estimated"), (0.51, "not determinable")])
def test_from_half_of_the_added_standard_deviation_on_it_is_that_which_shows(share, status, variance):
    interior = adjust_block(block_of(control=6), AdjustmentOptions(jobs=1)).interior[0]
    observed = replace(interior.parameters["c"], status="observed")
    interior = replace(interior, parameters={**interior.parameters, "c": observed})
    added = {("1", "c"): observed.std / np.sqrt(variance or 1.0) / share, ("2", "x0"): 1e-9}
    found = determined_by_network(interior, added, variance).parameters
    assert found["c"].status == status
    assert found["x0"].status == interior.parameters["x0"].status
    assert determined_by_network(interior, {}, variance).parameters["c"].status == "observed"


def test_a_sample_grows_by_the_image_that_shares_most_with_it():
    scene = aerial_scene(AerialStrips(strips=3, images_per_strip=16, points_per_image=40))
    block = simulate(scene, Survey(orientation="exact", points="exact")).observed
    o, n = block.observations, len(block.images)
    block = with_rows(block, (o.image != 20) | (np.arange(len(o)) % 2 == 0))
    seen = np.zeros((n, len(block.points)), int)
    seen[block.observations.image, block.observations.point] = 1
    chosen = [int(seen.sum(axis=1).argmax())]
    while len(chosen) < IMAGES:
        share = [-1 if i in chosen else int((seen[i] * seen[chosen]).sum()) for i in range(n)]
        chosen.append(int(np.argmax(share)))
    assert set(np.flatnonzero(_neighbouring(block))) == set(chosen)
    apart = with_rows(block, np.isin(block.observations.image, [0, 1, 2, 40, 41]))
    assert np.flatnonzero(_neighbouring(apart)).tolist() in ([0, 1, 2], [40, 41])


def test_tables_without_errors_are_those_of_the_exact_block():
    survey = Survey(points="exact", orientation="exact", interior="exact", scale_bars=3, station_sigma=1e-3)
    made = simulate(aerial_scene(AerialStrips(strips=2, images_per_strip=3)), survey)
    tables = {type(t).__name__: t for t in exact_tables(made.truth.having(made.observed.distances))}
    bars, xyz = made.observed.distances, made.truth.points.xyz
    exact = np.linalg.norm(xyz[bars.start] - xyz[bars.end], axis=1)
    np.testing.assert_allclose(tables["Distances"].length, exact, rtol=1e-12)
    assert np.abs(bars.length - exact).max() > 1e-9
    moved = made.truth.having(replace(made.observed.stations, xyz=made.observed.stations.xyz + 7))
    found = next(t for t in exact_tables(moved) if type(t).__name__ == "Stations")
    np.testing.assert_allclose(found.xyz, made.truth.images.centre[found.image], atol=1e-9)
