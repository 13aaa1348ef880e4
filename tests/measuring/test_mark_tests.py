"""Marks of hands against each other: named, contradictory or not tested, at the click and by adjusting."""

from functools import cache

import numpy as np
import pytest
from click.testing import CliRunner
from scipy.stats import chi2

import raybundle as rb
from raybundle.adjustment.records.options import AdjustmentOptions
from raybundle.adjustment.system.predict import image_points
from raybundle.cli.main import cli
from raybundle.io.block.folder import write_block
from raybundle.measuring.actions.verbs import Put
from raybundle.measuring.mark_tests import mark_verdict, point_test_of
from raybundle.measuring.merge import merge
from raybundle.measuring.session import Session
from raybundle.measuring.start import adjusted
from raybundle.measuring.state import folded
from raybundle.workflows.adjust import adjust

from .scenes import simulation

HAND_PX = 0.5
PLACE = np.array([0.99, 0.05, 0.1])
TURN = np.array([[0.6, 0.8], [-0.8, 0.6], [0.0, -1.0]])


@cache
def session():
    return Session.of(adjust(simulation(stations=28).observed))


def seeing(xyz, block):
    """Images that look at a point of the cylinder from its own side, and where they show it."""
    found = []
    for k, name in enumerate(block.images.ids):
        sight = block.images.centre[k] - xyz
        if sight @ [*xyz[:2], 0] > 0.4 * np.linalg.norm(sight):
            found.append((name, image_points(block.camera_of(k), block.images.rotation[k], block.images.centre[k],
                                             xyz[None])[0]))  # fmt: skip
    return found


def marks(count, off=(), seed=0, xyz=PLACE, point="gate"):
    """Marks of a point in so many images spread over those that see it; `off`: [px] of the first ones."""
    rng = np.random.default_rng(seed)
    seen = seeing(xyz, simulation(stations=28).truth)
    chosen = [seen[k] for k in np.linspace(0, len(seen) - 1, count).round().astype(int)]
    made = []
    for k, (image, xy) in enumerate(chosen):
        x, y = xy + rng.normal(0, HAND_PX, 2) + (off[k] * TURN[k] if k < len(off) else 0)
        made.append(Put(image=image, point=point, x_px=float(x), y_px=float(y)))
    return made


def result_of(actions):
    made = merge(session().block, folded(actions))
    return adjusted(made, lambda block: adjust(block, AdjustmentOptions(jobs=1)))


def notices(result, code):
    return [n for n in result.notices if n.data.code == code]


@pytest.mark.parametrize("off", [(5,), (20,), (70, 20)])
def test_mistaken_marks_are_left_out_and_named_with_size_and_effect(off):
    actions = marks(6 if len(off) == 1 else 8, off)
    result = result_of(actions)
    found = notices(result, "mark_contradicts.excluded")
    assert {n.ids for n in found} == {("gate", a.image) for a in actions[: len(off)]}
    for n in found:
        true = off[[a.image for a in actions].index(n.ids[1])]
        assert abs(n.wrong.size_px - true) < 4
        assert n.wrong.shift > 0
        assert result.given.length_unit in n.text
    k = result.adjusted.points.ids.index("gate")
    e = result.adjusted.points.xyz[k] - PLACE
    assert e @ np.linalg.solve(result.precision.object_points[k], e) < 20


@pytest.mark.parametrize(("count", "off"), [(3, (20,)), (3, (70, 70)), (4, (70, 70, 70))])
def test_a_point_is_contradictory_where_too_few_agree(count, off):
    (n,) = notices(result_of(marks(count, off)), "mark_contradicts.undecided")
    assert n.severity == "fault"
    assert n.ids[0] == "gate"
    assert len(n.ids) == 1 + count


def test_right_marks_are_not_named_and_few_are_not_tested():
    result = result_of([*marks(9), *marks(2, seed=1, xyz=PLACE * [1, -1, 1], point="door")])
    assert not [n for n in result.notices if n.data.code.startswith("mark_contradicts")]
    (n,) = notices(result, "marks_untested.open")
    assert n.ids == ("door",)
    assert n.severity == "warning"
    assert n.data.values["n"] == 2


@pytest.mark.parametrize(("scale", "true"), [(1.0, True), (0.8, False)])
def test_the_statistic_is_distributed_as_chi_square(scale, true):
    """Clean points of four to eight marks; with errors of which the marks state too little it is not."""
    rng, total, freedom = np.random.default_rng(2), 0.0, 0
    for seed in range(60):
        turn = rng.uniform(0, 2 * np.pi)
        xyz = np.array([np.cos(turn), np.sin(turn), rng.uniform(-0.5, 0.5)])
        n = int(rng.integers(4, 8))
        actions = [
            Put(image=a.image, point="p", x_px=a.x_px, y_px=a.y_px, covariance=((scale * HAND_PX) ** 2,) * 2 + (0.0,))
            for a in marks(n, seed=seed, xyz=xyz)
        ]
        test = point_test_of(session(), folded(actions), "p")
        total, freedom = total + test.square, freedom + 2 * len(test.images) - 3
    low, high = chi2(freedom).ppf([0.0005, 0.9995])
    assert (low < total < high) == true


def test_a_click_is_red_at_once():
    actions = marks(6, (30,))
    images = [a.image for a in actions]
    late = [*actions[1:], actions[0]]
    texts = [mark_verdict(session(), folded(late[: k + 1]), "gate", a.image) for k, a in enumerate(late)]
    assert texts[0] is None
    assert texts[1].message.code == "mark.open"
    assert texts[4].message.code == "mark.fits"
    values = texts[5].message.values
    assert texts[5].message.code == "mark.off"
    assert (values["image"], [*values["images"]]) == (images[0], images[:1])
    assert abs(values["distance_px"] - 30) < 4
    # put first, it is found when others agree
    third = mark_verdict(session(), folded(actions[:3]), "gate", images[2]).message
    assert third.code == "mark.off"
    assert {*third.values["images"]} == {*images[:3]}
    last = mark_verdict(session(), folded(actions), "gate", images[5]).message
    assert (last.code, last.values["image"]) == ("mark.off", images[0])


def test_the_command_line_states_it(tmp_path):
    write_block(session().block, tmp_path / "block")
    actions = marks(5, (0, 40))
    outputs = []
    for a in [actions[k] for k in (0, 2, 3, 4, 1)]:
        place = ["mark", "put", str(tmp_path), a.image, "gate", repr(a.x_px), repr(a.y_px)]
        outputs.append(CliRunner().invoke(cli, place, standalone_mode=False, catch_exceptions=False).output)
    assert not any("[mark.off]" in text for text in outputs[:4])
    assert "[mark.off]" in outputs[4]
    assert len(rb.marks(tmp_path).marks) == 5
