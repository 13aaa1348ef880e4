"""What actions add up to, and what they refuse."""

import random

import pytest

from raybundle.errors import InputError
from raybundle.measuring.actions.verbs import (
    Accept,
    Forget,
    Move,
    Point,
    Put,
    Redo,
    Reject,
    Remove,
    Rename,
    SetBar,
    SetDatum,
    SetLine,
    Unbar,
    Undo,
)  # fmt: skip
from raybundle.measuring.names import Known
from raybundle.measuring.state import EMPTY, Fold, MeasuredPoint, folded

from .scenes import small_block

KNOWN = Known.of_photos({"a.jpg": (400, 300), "in/b.jpg": (400, 300)})
NAN, INF = float("nan"), float("inf")


def put(point, image="a.jpg", x=10.0, **more):
    return Put(image=image, point=point, x_px=x, y_px=20.0, **more)


THREE = [put("A"), put("B"), put("C")]


def after(actions, known=KNOWN):
    fold = Fold()
    for a in actions:
        fold.add([a.settled(fold.state, known)])
    return fold.state


@pytest.mark.parametrize(
    ("actions", "words"),
    [
        ([put("A", "c.jpg")], r"c\.jpg.*2.*a\.jpg.*in/b\.jpg.*mark\.unknown_image"),
        ([put("A", x=400.1)], r"400\.1.*20.*400.*300.*mark\.outside_image"),
        ([put("A", x=NAN)], r"x_px.*number\.not_finite"),
        ([put("A", covariance=(0.0, 1.0, 0.0))], r"2.*0.*number\.too_small"),
        ([put("A", covariance=(1.0, 1.0, 1.0))], r"mark\.covariance"),
        ([put("A", clicked=(INF, 0.0))], r"number\.not_finite"),
        ([put("A", quality=2.0)], r"2.*1.*number\.too_large"),
        ([put("")], r"1.*200.*mark\.bad_name"),
        ([put("a\nb")], "printable"),
        ([put(" a")], r"mark\.bad_name"),
        ([put("A"), put("A")], r"a\.jpg.*mark\.exists"),
        ([Move(image="a.jpg", point="A", x_px=1, y_px=1)], r"mark\.unknown_point"),
        ([put("A"), Remove(image="b.jpg", point="A")], r"in/b\.jpg.*a\.jpg.*mark\.not_marked"),
        ([Point(point="A", role="control")], r"mark\.role_without_coordinate"),
        ([Point(point="A", role="control", xyz=(1.0, None, None))], r"mark\.control_without_sigma"),
        ([Point(point="A", xyz=(1.0, 2.0, NAN))], r"number\.not_finite"),
        ([Point(point="A", xyz=(1.0, 2.0, 3.0), sigma=(-1.0, 0.0, 0.0))], r"1.*0.*number\.below"),
        ([Point(point="A", xyz=(1.0, 2.0, None), sigma=(0.1, 0.1, 0.1))], r"mark\.sigma_without_coordinate"),
        ([put("A"), put("B"), Rename(point="A", to="B")], r"mark\.name_taken"),
        ([Rename(point="A", to="B")], r"mark\.unknown_point"),
        ([Forget(point="A")], r"mark\.unknown_point"),
        ([put("A"), SetBar(start="A", end="A", length=1, sigma=1)], r"mark\.bar_same_ends"),
        ([put("A"), SetBar(start="A", end="B", length=1, sigma=1)], r"mark\.unknown_point"),
        ([*THREE, SetBar(start="A", end="B", length=0, sigma=1)], r"0.*number\.too_small"),
        ([*THREE, SetBar(start="A", end="B", length=1, sigma=NAN)], r"number\.not_finite"),
        ([*THREE, SetBar(start="A", end="B", length=1e-320, sigma=1e-320)], r"12.*number\.below"),
        ([*THREE, SetBar(start="A", end="B", length=1, sigma=0.5)], r"3.*mark\.bar_sigma"),
        ([*THREE, Unbar(start="A", end="B")], r"mark\.no_bar"),
        ([*THREE, SetLine(line="l", points=("A", "B"))], r"2.*3.*mark\.line_points"),
        ([*THREE, SetLine(line="l", points=("A", "A"), kind="plumb")], r"1.*2.*mark\.line_points"),
        ([*THREE, SetLine(line="l", points=())], r"mark\.no_line"),
        ([*THREE, SetLine(line="l", points=("A", "B", "C"), sigma=0)], r"0.*number\.too_small"),
        ([*THREE, SetDatum(origin="A", plane="B")], r"axes\.point_missing"),
        ([*THREE, SetDatum(axis="B")], r"axes\.point_missing"),
        ([*THREE, SetLine(line="l", points=("A",), kind="level")], r"1.*2.*mark\.line_points"),
        ([*THREE, SetLine(line="l", points=("A", "B", "C"), kind="plane")], r"3.*4.*mark\.line_points"),
        ([*THREE, SetDatum(origin="A", axis="B", plane="A")], r"axes\.same_points"),
        ([put("A"), Reject(image="a.jpg", point="A")], r"mark\.no_observation"),
        ([put("A"), Accept(image="a.jpg", point="A")], r"mark\.not_rejected"),
        ([Undo()], r"journal\.nothing_to_undo"),
        ([put("A"), Redo()], r"journal\.nothing_to_redo"),
    ],
)  # fmt: skip
def test_what_is_refused_says_why(actions, words):
    with pytest.raises(InputError, match=words):
        after(actions)


def test_marks_points_bars_lines_and_axes():
    state = after([
        *THREE, put("A", "b.jpg", x=30.0, how="ellipse", clicked=(29.0, 21.0), quality=0.9),
        Move(image="a.jpg", point="B", x_px=11.0, y_px=12.0), Remove(image="a.jpg", point="C"),
        Point(point="A", role="control", xyz=(1.0, 2.0, None), sigma=(0.0, 0.1, None)),
        SetBar(start="A", end="B", length=2.0, sigma=0.1), SetBar(start="B", end="A", length=3.0, sigma=0.1),
        SetLine(line="edge", points=("A", "B"), kind="plumb", sigma=0.02), SetDatum(origin="A", axis="B", plane="C"),
    ])  # fmt: skip
    assert set(state.marks) == {("a.jpg", "A"), ("in/b.jpg", "A"), ("a.jpg", "B")}
    assert state.marks["in/b.jpg", "A"].clicked == (29.0, 21.0)
    assert state.marks["a.jpg", "B"].x_px == 11.0
    assert set(state.marks_of("A")) == {"a.jpg", "in/b.jpg"}
    assert set(state.marks_in("a.jpg")) == {"A", "B"}
    assert state.points["A"].sigma == (0.0, 0.1, None)
    assert state.points["C"] == MeasuredPoint()
    assert set(state.bars) == {("B", "A")}
    assert state.lines["edge"].points == ("A", "B")
    assert state.datum.points == ("A", "B", "C")
    assert state.can_undo == 11


def test_a_new_name_and_forgetting_reach_everywhere():
    made = [
        *THREE, SetBar(start="A", end="B", length=2.0, sigma=0.1),
        SetLine(line="l", points=("A", "B", "C")), SetDatum(origin="A", axis="B", plane="C"),
    ]  # fmt: skip
    state = after([*made, Rename(point="A", to="<script>alert(1)</script>")])
    name = "<script>alert(1)</script>"
    assert ("a.jpg", name) in state.marks
    assert (name, "B") in state.bars
    assert state.lines["l"].points[0] == name
    assert state.datum.origin == name
    assert not state.renamed
    state = after([*made, Forget(point="A")])
    assert (set(state.points), set(state.marks)) == ({"B", "C"}, {("a.jpg", "B"), ("a.jpg", "C")})
    assert not state.bars
    assert not state.lines
    assert state.datum is None
    assert after([*made, Forget(point="A"), Undo()]) == after([*made, put("D"), Undo()])


def test_points_of_the_block():
    block = small_block()
    known = Known.of(block)
    first = int(block.observations.image[0])
    image, point = block.images.ids[first], block.points.ids[int(block.observations.point[0])]
    row = Reject(image=block.images.file[first], point=point)
    state = after([row], known)
    assert state.rejected == {(image, point)}
    assert not after([row, Accept(image=image, point=point)], known).rejected
    state = after([row, Rename(point=point, to="gate")], known)
    assert state.renamed == {point: "gate"}
    assert state.rejected == {(image, "gate")}
    assert after([row, Rename(point=point, to="gate"), Rename(point="gate", to=point)], known) == after(
        [row, Rename(point=point, to="gate"), Rename(point="gate", to=point)], known
    )
    assert not after([Rename(point=point, to="gate"), Rename(point="gate", to=point)], known).renamed
    with pytest.raises(InputError, match=r"mark\.point_of_block"):
        after([Forget(point=point)], known)
    with pytest.raises(InputError, match=r"mark\.unknown_point"):
        after([Rename(point=point, to="gate"), SetBar(start=point, end="gate", length=1, sigma=1)], known)


def test_the_state_is_the_fold_however_it_is_cut():
    """Undo and redo at random: folded at once, one by one, and as the plain list of what counts."""
    rng = random.Random(3)
    actions, counts, back = [], [], []
    for k in range(400):
        choice = rng.random()
        if choice < 0.3 and counts:
            actions.append(Undo())
            back.append(counts.pop())
        elif choice < 0.5 and back:
            actions.append(Redo())
            counts.append(back.pop())
        else:
            actions.append(put(f"p{k}"))
            counts.append(actions[-1])
            back.clear()
    one_by_one = after(actions)
    assert one_by_one == folded(actions)
    assert set(one_by_one.points) == {a.point for a in counts}
    assert (one_by_one.can_undo, one_by_one.can_redo) == (len(counts), len(back))
    assert EMPTY.marks == {}
