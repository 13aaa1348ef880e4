"""Laws that every kind of observation outside the images keeps; a new kind is tested by having an example here."""

from dataclasses import replace

import numpy as np
import pytest
from tests.adjustment.test_attitudes import noisy
from tests.observations.test_total_station import total_station
from tests.truth.mixed_blocks import mixed

from raybundle.adjustment.observation_contract import partials_off, partials_off_in
from raybundle.adjustment.records.options import AdjustmentOptions
from raybundle.adjustment.system.assemble import assemble
from raybundle.block import Relation
from raybundle.errors import InputError
from raybundle.io.block.folder import read_block, write_block
from raybundle.observations import in_order, observation_kinds, tables
from raybundle.observations.alignment import Levels, Lines, Planes, PlumbLines
from raybundle.observations.coordinates import Coordinates
from raybundle.observations.deviation import Deviations
from raybundle.observations.total_station import Differences
from raybundle.planning.simulate import Survey, simulate
from raybundle.planning.synthetic_networks import TargetField, field_scene


def a_field():
    """Control, scale bars, an observed camera constant and a relation."""
    block = simulate(
        field_scene(TargetField(rows=4, columns=5, stations=4, frontal=1)),
        Survey(scale_bars=3, control=5, control_sigma=(1e-3, 2e-3, 3e-3)),
    ).truth
    c = block.cameras[0]
    relations = (
        Relation(name="sum", terms={"c": 2.0, "x0": -1.0}, sigma=0.1, observed=2 * c.values["c"]),
        Relation(name="log", terms={"c": 1.0}, sigma=0.01, observed=np.log(c.values["c"]), logarithm=True),
    )
    return replace(block, cameras=(replace(c, sigma={"c": 0.01}, relations=relations),))


def figures():
    """Points near planes, lines, plumb lines and levels."""
    block = a_field()
    xyz, rng = block.points.xyz, np.random.default_rng(4)
    rows = np.sort(rng.permutation(len(xyz))[:12])

    def of(table):
        return table(figure=("a",) * 6 + ("b",) * 6, point=rows.astype(np.int32), sigma=np.full(12, 0.01))

    return block.having(of(Planes), of(Lines), of(PlumbLines), of(Levels))


def networks():
    """Points of two networks, correlated within each."""
    block = replace(a_field(), tables={})
    xyz, rng = block.points.xyz, np.random.default_rng(6)
    free = np.flatnonzero(block.points.role == 0)[:9].astype(np.int32)
    found = []
    for name, points in (("a", free[:4]), ("b", free[4:])):
        root = rng.normal(0, 1e-3, (3 * len(points),) * 2)
        C = (root @ root.T + 1e-6 * np.eye(len(root))).reshape(len(points), 3, len(points), 3)
        a, b = np.triu_indices(len(points))
        found.append(
            Coordinates(
                network=(name,) * len(a),
                point=points[a],
                other=points[b],
                xyz=np.where((a == b)[:, None], xyz[points[a]] + 1e-3, np.nan),
                covariance=C[a, :, b].reshape(-1, 9),
            )
        )
    return block.having(found[0].append(found[1]))


def single_images():
    """A camera constant of each image, near that of the others."""
    block = replace(a_field(), tables={})
    camera = replace(block.cameras[0], sigma={}, relations=(), estimate=("c", "K1"), per_image=("c",))
    images = np.arange(len(block.images), dtype=np.int32)
    own = {int(i): {"c": camera.values["c"] + 0.01 * int(i)} for i in images}
    block = replace(block, cameras=(camera,), images=replace(block.images, interior=own))
    return block.having(Deviations(image=images, parameter=("c",) * len(images), sigma=np.full(len(images), 0.02)))


def sighted():
    """A total station that no image sees, two sets of directions."""
    truth, block = total_station(1)
    return truth.having(*block.tables.values())


def correlated():
    """Positions, attitudes and coordinate differences with correlations within their rows."""
    block = noisy()
    points, rng = np.flatnonzero(block.points.role == 0)[:6].astype(np.int32), np.random.default_rng(12)
    steps = Differences(
        station=points[:-1], target=points[1:], xyz=np.diff(block.points.xyz[points], axis=0),
        sigma=np.array([[0.01, 0.02, 0.03]] * 4 + [[0.01, 0.02, np.nan]]),
    )  # fmt: skip
    steps = replace(steps, xyz=np.where(np.isnan(steps.sigma), np.nan, steps.xyz))
    block = block.having(steps)
    return block.of_tables(
        lambda t: replace(
            t, correlation=np.where(np.isfinite(t.sigma[:, [1, 2, 2]]), rng.uniform(-0.45, 0.45, (len(t), 3)), 0.0)
        )
    )


EXAMPLES = {
    "correlated": correlated,
    "total station": sighted,
    "single images": single_images,
    "networks": networks,
    "figures": figures,
    "field": a_field,
    "airborne": noisy,
    "mixed": mixed,
}


def system_of(block):
    free = {c.id: c.sensor.symbols if c.estimate == "auto" else c.estimate for c in block.parametrised}
    return assemble(block, AdjustmentOptions(), np.zeros(len(block.observations), bool), free)


@pytest.fixture(scope="module")
def systems():
    return {name: system_of(make()) for name, make in EXAMPLES.items()}


@pytest.fixture(scope="module")
def parts(systems):
    """Kind -> the systems and parts in which it has rows."""
    return {
        kind: [(s, part) for s in systems.values() if (part := s.extra.of(kind)) is not None]
        for kind in observation_kinds
    }


@pytest.mark.parametrize("kind", observation_kinds)
def test_each_kind_has_an_example(parts, kind):
    assert parts[kind], f"add a block with {kind} observations to EXAMPLES"


@pytest.mark.parametrize("kind", observation_kinds)
def test_partials_are_those_of_the_residuals(parts, kind):
    for system, _ in parts[kind]:
        assert partials_off_in(system, kind) < 2e-6


def test_partials_that_are_wrong_are_found(monkeypatch):
    kind = observation_kinds["distance"]
    right = type(kind).observed
    block = EXAMPLES["field"]()
    assert partials_off(block, "distance") < 1e-6

    def half(self, *args):
        found = right(self, *args)
        return replace(
            found, partials=(replace(found.partials[0], value=found.partials[0].value / 2), *found.partials[1:])
        )

    monkeypatch.setattr(type(kind), "observed", half)
    assert partials_off(block, "distance") > 0.1
    with pytest.raises(InputError, match=r"zenith_angle.*observations\.none_of_kind"):
        partials_off(block, "zenith_angle")


@pytest.mark.parametrize("kind", observation_kinds)
def test_points_that_rows_touch_are_unknowns_of_nodes(parts, kind):
    for system, part in parts[kind]:
        at = part.kind.observed(part.table, part.rows, system.extra.scope, system.initial_state())
        touched = [p.item for p in at.partials if p.of == "point"]
        for point in np.unique(np.concatenate([np.zeros(0, np.int32), *touched])):
            assert system.point_node[point] >= 0 or system.control_held[point].all()


@pytest.mark.parametrize("kind", observation_kinds)
def test_rows_have_names_and_weights(parts, kind):
    for system, part in parts[kind]:
        named = part.kind.named(part.table, part.rows, system.extra.scope)
        assert len(named.ids) == len(named.component) == len(part.rows)
        assert not named.origin or len(named.origin) == len(part.rows)
        wider = system_of(part.kind.weighted(system.block, 3.0)).extra.of(kind)
        told = np.array([o == "known before" for o in named.origin] or [False] * len(part.rows))
        np.testing.assert_allclose(wider.rows.sigma, part.rows.sigma * np.where(told, 1, 3), rtol=1e-14)
        np.testing.assert_array_equal(wider.rows.value, part.rows.value)


def test_orders_and_groups_are_each_kinds_own():
    kinds = in_order()
    assert len({k.order for k in kinds}) == len({k.group for k in kinds}) == len({k.name for k in kinds}) == len(kinds)


def test_tables_of_every_kind_read_back_equal(tmp_path):
    there = set()
    for example, make in EXAMPLES.items():
        block = make()
        if any(c.is_scene for c in block.cameras):
            continue
        write_block(block, tmp_path / example)
        again = read_block(tmp_path / example)
        assert again.tables.keys() == block.tables.keys()
        for name, found in block.tables.items():
            there.add(name)
            for field, c in found.cells():
                mine, read = getattr(found, field), getattr(again.tables[name], field)
                if c.unit == "deg":  # written in degrees, to their last figure
                    np.testing.assert_allclose(read, mine, rtol=1e-11, atol=1e-14)
                elif mine is None or isinstance(mine, tuple):
                    assert read == mine
                else:
                    np.testing.assert_array_equal(read, mine)
    assert there == set(tables)
