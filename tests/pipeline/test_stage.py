"""Stages: a product is what its inputs make it, and is made once."""

from dataclasses import dataclass, field, replace
from datetime import UTC, datetime
from enum import Enum
from itertools import product
from pathlib import Path

import numpy as np
import pytest

from raybundle.errors import NoOrientation
from raybundle.pipeline.executors import Processes, Threads
from raybundle.pipeline.keys import key_of
from raybundle.pipeline.project import Project
from raybundle.pipeline.queues import drive
from raybundle.pipeline.stage import Alternative, Codec, Run, Stage, Workflow
from raybundle.pipeline.store import Folder
from raybundle.pipeline.tasks import Task, do_written, written
from tests.pipeline.test_executors import HERE, Sum

MADE: list[str] = []


@dataclass(frozen=True, slots=True)
class State:
    """Of a workflow of this test."""

    given: float = 1.0
    unused: float = 0.0
    doubled: float = 0.0
    sums: tuple[float, ...] = ()


def _double(given, means):
    del means
    MADE.append("double")
    return 2 * given


def _sums(given, means):
    tasks = [
        Task(key=key_of("sums", given, k), function=f"{HERE}:total", options=Sum(number=given + k)) for k in range(3)
    ]
    failed = means.do(tasks, "sums")
    assert not failed
    return tuple(float(means.store.wanted(t.key)["sum"][0]) for t in tasks)


DOUBLE = Stage(
    name="double", inputs=lambda s: s.given, function=_double, put=lambda s, p: replace(s, doubled=p),
    codec=Codec(arrays=lambda p: {"p": np.array(p)}, product=lambda a: float(a["p"])),
    reported=lambda s: f"{s.doubled:g}",
)  # fmt: skip
SUMS = Stage(
    name="sums", after=("double",), inputs=lambda s: s.doubled, function=_sums, put=lambda s, p: replace(s, sums=p)
)


@pytest.fixture
def run(tmp_path):
    project = Project.open(tmp_path / "p")
    MADE.clear()
    yield Run(project=project, executor=Threads(2))
    project.close()


def test_a_product_is_made_once_and_again_when_what_it_depends_on_changes(run):
    first = run.stages((DOUBLE, SUMS), State(given=3.0))
    assert first == State(given=3.0, doubled=6.0, sums=(6.0, 7.0, 8.0))
    assert run.stages((DOUBLE, SUMS), State(given=3.0, unused=1.0)) == replace(first, unused=1.0)
    assert MADE == ["double"]
    assert [r.from_cache for r in run.project.records] == [False, False, True, True]
    assert run.stages((DOUBLE,), State(given=4.0)).doubled == 8.0
    assert run.stages((replace(DOUBLE, version=2),), State(given=4.0)).doubled == 8.0
    assert MADE == ["double"] * 3
    run.forget((DOUBLE,))
    run.stages((DOUBLE, SUMS), State(given=3.0))
    assert [r.from_cache for r in run.project.records][-2:] == [False, True]
    assert run.project.records[0].summary == "6"


def test_a_product_with_the_fields_of_another_version_is_made_again(run):
    earlier = replace(DOUBLE, codec=Codec(arrays=lambda p: {"q": np.array(p)}, product=lambda a: float(a["q"])))
    assert run.stages((earlier,), State(given=3.0)).doubled == 6.0
    for made in (2, 2):
        assert run.stages((DOUBLE,), State(given=3.0)).doubled == 6.0
        assert len(MADE) == made


def test_stages_of_one_line_are_told_together(run):
    other = replace(SUMS, line="double", reported=lambda s: f"{len(s.sums)} sums")
    run.stages((DOUBLE, other), State(given=3.0))
    (record,) = run.project.records
    assert (record.name, record.summary, record.from_cache) == ("double", "6; 3 sums", False)
    assert [r.summary for r in run.project.stages()] == ["6; 3 sums"]


def test_a_stage_that_has_nothing_to_do_is_passed_over(run):
    assert run.stages((replace(DOUBLE, when=lambda s: s.given > 5),), State()) == State()
    assert not run.project.records


def test_stages_stand_where_they_say():
    steps = Workflow("test")
    for name, after, before in (("z", (), ()), ("m", ("z",), ()), ("a", ("m",), ()), ("k", (), ("m",))):
        steps.register(replace(DOUBLE, name=name, after=after, before=before))
    assert [s.name for s in steps.in_order()] == ["k", "z", "m", "a"]
    assert [s.name for s in steps.from_title("m")] == ["m", "a"]
    with pytest.raises(ValueError, match="two stages z"):
        steps.register(replace(DOUBLE, name="z"))
    steps.register(replace(DOUBLE, name="q", after=("a",), before=("m",)))
    with pytest.raises(ValueError, match="a, m, q"):
        steps.in_order()


@pytest.mark.parametrize(
    ("first", "second", "result"), [(1, 2, 2), (3, 2, 3), (None, 2, -2), (1, None, 1), (9, 10, 9), (None, None, None)]
)
def test_the_better_of_two_ways_goes_on(run, first, second, result):
    """Ways that give so much, None: nothing; from 5 on there is no second way."""

    def give(given, means):
        del means
        found = second if given < 0 else first
        if found is None:
            raise NoOrientation("nothing")
        return found

    def begin(before, state):
        return None if state is not None and state.doubled > 5 else replace(before, given=-1.0)

    steps = Workflow("test")
    steps.register(Stage(name="begun", inputs=lambda _: 0, function=lambda *_: 0, put=lambda s, _: s))
    steps.register(
        Stage(
            name="give", after=("begun",), inputs=lambda s: s.given, function=give,
            put=lambda s, p: replace(s, doubled=p),
        )
    )  # fmt: skip
    steps.register_alternative(
        Alternative(
            first=("give",), second=("give",), begin=begin,
            better=lambda a, b: max(a, b, key=lambda s: s.doubled),
            only=lambda s: replace(s, doubled=-s.doubled), nothing=NoOrientation,
        )
    )  # fmt: skip
    if result is None:
        with pytest.raises(NoOrientation):
            run.workflow(steps, State())
    else:
        assert run.workflow(steps, State()).doubled == result


class Colour(Enum):
    """A part of a key."""

    RED = "red"


@dataclass(frozen=True)
class Known:
    """What is known by less than its fields."""

    name: str
    place: Path

    @property
    def content(self):
        return self.name


@dataclass(frozen=True)
class Other:
    """As `State`, by another name."""

    given: float = 1.0
    more: dict[int, float] = field(default_factory=dict)


PARTS = [
    1, 2, 1.5, "1", True, None, Path("a"), Path("b"), Colour.RED, datetime(2026, 1, 2, tzinfo=UTC), {"a": 1}, {"a": 2},
    {"b"}, np.arange(3), np.arange(3.0), np.arange(4).reshape(2, 2), np.arange(4), np.float64(0.25), State(), Other(),
    Other(more={1: 2.0}), Known("k", Path("x")), [State(given=2.0)], float("nan"),
]  # fmt: skip


def test_every_kind_of_content_tells_keys_apart():
    keys = [key_of("test", part) for part in PARTS]
    assert len(set(keys)) == len(PARTS)
    assert keys == [key_of("test", part) for part in PARTS]
    assert key_of("test", Known("k", Path("elsewhere"))) == key_of("test", Known("k", Path("x")))
    assert key_of("test", {"b", "a"}) == key_of("test", {"a", "b"})
    with pytest.raises(TypeError, match="object cannot be part of a key"):
        key_of("test", object())


def _over_kept(given, means):
    """Tasks of sums of what the stage itself keeps for them; they are done."""
    keys = [key_of("kept", given, k) for k in range(3)]
    for k, key in enumerate(keys):
        if not means.store.has(key):
            MADE.append(key)
            means.store.store(key, {"sum": np.full(2, given + k)})
    tasks = [
        Task(key=key_of("over", key), function=f"{HERE}:total", options=Sum(number=1.0, of=(key,)), inputs=(key,))
        for key in keys
    ]
    assert not means.do(tasks, "sums")
    return tasks


def _from_kept(given, means):
    """Sums of what the stage itself keeps for its tasks."""
    return tuple(float(means.store.wanted(t.key)["sum"][0]) for t in _over_kept(given, means))


@pytest.mark.parametrize("executor", [Threads(1), Processes(2)], ids=str)
def test_what_a_stage_keeps_for_its_tasks_is_made_again_where_it_is_damaged(tmp_path, executor):
    """Also many of them, of which a task tells one at a time, with what was made of them."""
    steps = Workflow("test")
    steps.register(replace(SUMS, after=(), inputs=lambda s: s.given, function=_from_kept))
    MADE.clear()
    for attempt in range(2):
        project = Project.open(tmp_path / "p")
        try:
            found = Run(project=project, executor=executor).workflow(steps, State(given=3.0))
            assert found.sums == (4.0, 5.0, 6.0)
            assert len(project.records) == 1
            assert len(MADE) == 3 + 3 * attempt
            assert project.products.mended == ({*MADE} if attempt else set())
        finally:
            project.close()
        for path in (tmp_path / "p/cache").rglob("kept-*.npz"):
            data = bytearray(path.read_bytes())
            data[len(data) // 2] ^= 255
            path.write_bytes(data)
        for path in (tmp_path / "p/cache").rglob("over-*.npz"):
            path.unlink()


class Foreign:
    """Does tasks as another process does, which does not know how products are made; the last one first."""

    jobs = 2

    def __init__(self):
        self.waiting = []

    def run(self, tasks, store):
        self.store = Folder(store.path)
        yield from drive(tasks, self, store, float("inf"))

    def room(self):
        return 100

    def submit(self, task):
        self.waiting.append(task)

    def ended(self):
        task = self.waiting.pop()
        return [(task.key, do_written(written(task), self.store))]


def _over_two(given, means):
    """Sums of sums of what the stage keeps."""
    below = [t.key for t in _over_kept(given, means)]
    tasks = [
        Task(key=key_of("top", key), function=f"{HERE}:total", options=Sum(number=1.0, of=(key,)), inputs=(key,))
        for key in below
    ]
    failed = means.do(tasks, "top")
    assert not failed
    return tuple(float(means.store.wanted(t.key)["sum"][0]) for t in tasks)


def damage(path, how):
    data = bytearray(path.read_bytes())
    if how == "flipped":
        data[len(data) // 2] ^= 255
        path.write_bytes(data)
    elif how == "cut":
        path.write_bytes(data[: len(data) // 2])
    elif how == "gone":
        path.unlink()


@pytest.mark.parametrize("damages", [*product(["whole", "flipped", "cut", "gone"], repeat=3)], ids="-".join)
@pytest.mark.parametrize("executor", [Threads(1), Foreign()], ids=["here", "elsewhere"])
def test_whatever_is_damaged_at_three_levels_is_made_again(tmp_path, executor, damages):
    steps = Workflow("test")
    steps.register(replace(SUMS, after=(), inputs=lambda s: s.given, function=_over_two))
    for attempt in range(2):
        project = Project.open(tmp_path / "p")
        try:
            found = Run(project=project, executor=executor).workflow(steps, State(given=3.0))
        finally:
            project.close()
        assert found.sums == (5.0, 6.0, 7.0)
        if not attempt:
            for level, how in zip(("kept", "over", "top"), damages, strict=True):
                for path in (tmp_path / "p/cache").rglob(f"{level}-*.npz"):
                    damage(path, how)
