"""Tasks done by threads and by processes of their own: the same products, in whatever order they end."""

import os
import re
import threading
from contextlib import nullcontext
from dataclasses import dataclass
from pathlib import Path

import numpy as np
import pytest

from raybundle.errors import InputError, message
from raybundle.pipeline.executors import Processes, Threads
from raybundle.pipeline.keys import key_of
from raybundle.pipeline.store import Folder
from raybundle.pipeline.tasks import Task, do_written, function_of, read_task, written
from raybundle.settings import option
from raybundle.words import COMMAND_LINE, reading
from tests.barriers import DEADLINE_S
from tests.messages import with_details
from tests.pipeline.graph import executions, tasks_of

HERE = "tests.pipeline.test_executors"
NEGATIVE = "is negative"


@dataclass(frozen=True, slots=True, kw_only=True)
class Sum:
    """Options of a task of this test."""

    number: float
    of: tuple[str, ...] = ()
    file: Path | None = None


def total(store: Folder, options: Sum):
    """A number and the sums of other products."""
    if options.number < 0:
        raise InputError(NEGATIVE, file=options.file)
    if options.number == 13:
        raise ZeroDivisionError
    return {"sum": options.number + sum((store.held(k)["sum"] for k in options.of), np.zeros(2))}


def named(store: Folder, options: Sum):
    del store, options
    return {"control": np.array(option("control"))}


def where(store: Folder, options: Sum):
    """The process in which it was done, and its threads."""
    del store, options
    return {"process": np.array(os.getpid()), "threads": np.array(os.environ.get("OPENBLAS_NUM_THREADS", ""))}


def task(number, *needs, function="total", **more):
    options = Sum(number=number, of=tuple(t.key for t in needs), file=Path("a.txt"))
    key = key_of("sum", options, function)
    return Task(key=key, function=f"{HERE}:{function}", options=options, inputs=options.of, name=str(number), **more)


@pytest.fixture
def store(tmp_path):
    return Folder(tmp_path / "store")


EXECUTORS = [Threads(1), Threads(3), Processes(2)]


@pytest.mark.parametrize("executor", EXECUTORS, ids=["one thread", "threads", "processes"])
def test_tasks_are_done_after_those_that_they_need(store, executor):
    first = [task(k) for k in (1, 2, 4)]
    second = task(10, *first)
    third = task(100, second, first[0])
    ended = [d.task.key for d in executor.run([third, second, *first], store)]
    assert sorted(ended) == sorted(t.key for t in (*first, second, third))
    assert ended.index(second.key) == 3
    assert store.load(third.key)["sum"].tolist() == [118, 118]


@pytest.mark.parametrize("executor", EXECUTORS, ids=["one thread", "threads", "processes"])
def test_bad_input_costs_its_task_and_what_needs_it(store, executor):
    good, bad = task(1), task(-1)
    needs, further = task(5, bad), task(6, good)
    after = task(7, needs)
    ended = {d.task.name: d.failed for d in executor.run([good, bad, needs, further, after], store)}
    assert ended["-1"].values == {"detail": f"a.txt: {NEGATIVE}"}
    assert ended["5"] == message("task.needs_failed", details=[ended["-1"]])
    assert with_details(ended["7"])[-1] == ended["-1"]
    assert not ended["1"]
    assert not ended["6"]
    assert [store.has(t.key) for t in (good, bad, needs, further, after)] == [True, False, False, True, False]


@pytest.mark.parametrize("executor", EXECUTORS, ids=["one thread", "threads", "processes"])
def test_what_is_no_bad_input_is_tried_three_times_and_told_in_the_log(store, executor, tmp_path):
    bad = task(13)
    tasks = [bad, *(task(k) for k in range(20, 40)), task(7, bad)]
    ended = {d.task.name: d.failed for d in executor.run(tasks, store)}
    assert len(ended) == len(tasks)
    log = tmp_path / "failed-tasks.log"
    cause = message("task.failed", kind="ZeroDivisionError", detail="")
    assert ended["13"] == message("task.failed_repeatedly", details=[cause], name="13", n=3, log=str(log))
    assert ended["7"] == message("task.needs_failed", details=[ended["13"]])
    assert [name for name, failed in ended.items() if failed] == ["13", "7"] or not ended["39"]
    assert all(store.has(t.key) for t in tasks[1:-1])
    shown = log.read_text()
    assert [f"attempt {k}" in shown for k in (1, 2, 3, 4)] == [True, True, True, False]
    assert shown.count("  raise ") == 3
    assert len(re.findall(r"^\s*ZeroDivisionError$", shown, re.MULTILINE)) == 3


def test_processes_are_others_and_use_one_thread(store, monkeypatch):
    monkeypatch.setenv("OPENBLAS_NUM_THREADS", "7")
    done = list(Processes(2).run([task(k, function="where", small=True) for k in range(4)], store))
    assert os.getpid() not in {int(d.product["process"]) for d in done}
    assert {str(d.product["threads"]) for d in done} == {"1"}
    assert os.environ["OPENBLAS_NUM_THREADS"] == "7"
    here = list(Threads(2).run([task(1, function="where", small=True)], store))
    assert int(here[0].product["process"]) == os.getpid()
    assert not any(store.has(d.task.key) for d in (*done, *here))  # small products are handed back


def test_messages_of_processes_name_settings_as_those_of_their_parent(store):
    for flags in (False, True):
        with reading(COMMAND_LINE) if flags else nullcontext():
            (done,) = Processes(1).run([task(1, function="named", small=True)], store)
        assert str(done.product["control"]) == ("--control" if flags else "control=")


def test_a_task_can_be_written_down():
    given = task(2.5, task(1), memory=3e9, cost=2.0)
    assert read_task(written(given)) == given


def test_a_worker_makes_no_product_that_is_there_already(store, tmp_path):
    """One that was killed after its product was kept, and before anybody was told."""
    log = tmp_path / "log"
    tasks = tasks_of(2, log=log)
    for task in (*tasks, *tasks):
        done = do_written(written(task), store)
        assert not done.failed
        assert done.task.key == task.key
        assert bool(done.product) == task.small
    assert executions(log) == {str(t.options.number): 1 + t.small for t in tasks}
    store.forget(tasks[0].key)
    do_written(written(tasks[0]), store)
    assert executions(log)["0"] == 2


def test_tasks_that_wait_for_each_other_are_named(store):
    a, b = task(1), task(2)
    circle = [
        Task(key=a.key, function=a.function, options=a.options, after=(b.key,), name="a"),
        Task(key=b.key, function=b.function, options=b.options, after=(a.key,), name="b"),
    ]
    with pytest.raises(InputError, match=r"2.*task\.cycle"):
        list(Threads(1).run(circle, store))


def test_two_tasks_of_one_key_are_refused(store):
    with pytest.raises(ValueError, match="same key"):
        list(Threads(1).run([task(1), task(1)], store))


@pytest.mark.parametrize("name", ["nothing", "json:nothing", "tests.pipeline.test_executors:HERE"])
def test_a_function_is_called_by_its_name(name):
    with pytest.raises(TypeError, match=f"'{name}' "):
        function_of(name)


def together(store: Folder, options: Sum):
    """How many of these work at once; each waits for as many as `TOGETHER` says."""
    del store, options
    WORKING.append(1)
    TOGETHER[0].wait(DEADLINE_S)
    most = len(WORKING)
    TOGETHER[0].wait(DEADLINE_S)
    WORKING.pop()
    return {"at_once": np.array(most)}


WORKING: list[int] = []
TOGETHER = [threading.Barrier(1)]


@pytest.mark.parametrize(("memory", "most"), [(3e9, 3), (2e9, 2), (0.5e9, 1)])
def test_memory_limits_how_many_work_at_once(store, memory, most):
    TOGETHER[0] = threading.Barrier(most)
    tasks = [task(k, function="together", small=True, memory=1e9) for k in range(6)]
    assert {int(d.product["at_once"]) for d in Threads(6, memory).run(tasks, store)} == {most}
