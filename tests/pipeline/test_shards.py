"""Tasks by shards: a list in the store, shares in any order, the same bits."""

import itertools
import os
import subprocess
import sys
from dataclasses import replace
from pathlib import Path
from types import SimpleNamespace

import pytest
from PIL import Image

from raybundle.cli.main import main
from raybundle.errors import InputError, TasksWaiting
from raybundle.io.photos.metadata import Metadata
from raybundle.io.photos.photo import Photo
from raybundle.matching.methods import feature_method
from raybundle.pipeline.choosing import executor_for
from raybundle.pipeline.executors import Threads
from raybundle.pipeline.keys import key_of
from raybundle.pipeline.project import Project
from raybundle.pipeline.running import note
from raybundle.pipeline.shards import Shards, do_shard
from raybundle.pipeline.stage import Means
from raybundle.pipeline.store import Folder
from raybundle.pipeline.tasks import read_task, written
from raybundle.settings import option
from raybundle.ties.points import FeatureStore, verified_pairs
from raybundle.words import headline
from tests.cli.reported import reported, values_of
from tests.pipeline.graph import NO_MATRIX, digest, done_by, executions, tasks_of

LEAVES = 8
ENV = {**os.environ, "PYTHONPATH": str(Path(__file__).parents[2])}


@pytest.fixture(scope="module")
def expected(tmp_path_factory):
    store = Folder(tmp_path_factory.mktemp("store"))
    return done_by(Threads(1), tasks_of(LEAVES), store)


def asked(folder, tasks):
    """What a run says that wants these tasks; empty where all are done, and the digest."""
    project = Project.open(folder)
    try:
        means = Means(project=project, executor=executor_for("shards", 1, 1e9))
        try:
            failed = means.do(tasks, "graph")
        except TasksWaiting as waiting:
            return str(waiting), ""
        if failed:
            return failed, ""
        small = {t.key: means.small(t.key) for t in tasks if t.small}
        return "", digest(project.products, tasks, small)
    finally:
        project.close()


@pytest.mark.parametrize("order", [(0, 1, 2), (2, 0, 1)])
def test_shards_in_any_order_make_the_same_bits(tmp_path, expected, order):
    log = tmp_path / "log"
    tasks = tasks_of(LEAVES, log=log)
    said, _ = asked(tmp_path / "p", tasks)
    assert said.startswith(f"{len(tasks)} tasks ")
    assert str(tmp_path / "p/cache/tasks.jsonl") in said
    assert f"raybundle worker {option('shard', 'I/N')} {tmp_path / 'p'}" in said
    rounds = 0
    for number in itertools.cycle(order):
        done = do_shard(tmp_path / "p", number, 3, wait_s=0.0)
        assert done.failed == ()
        rounds += 1
        said, found = asked(tmp_path / "p", tasks)
        if not said:
            break
    assert found == expected
    assert rounds > 3, "those above wait for those below"
    assert set(executions(log).values()) == {1}
    assert not (tmp_path / "p/cache/tasks.jsonl").exists()
    assert do_shard(tmp_path / "p", 0, 1).made == 0  # nothing is left


def test_small_products_are_kept_before_what_was_handed_over_is_removed(tmp_path, expected):
    tasks = tasks_of(LEAVES)
    asked(tmp_path / "p", tasks)
    done = do_shard(tmp_path / "p", 0, 1)
    assert (done.made, done.waiting) == (len(tasks), 0)
    store = Folder(tmp_path / "p/cache")
    assert store.keys_of_kind("handed")
    first = Shards().run([t for t in tasks if t.small], store)
    assert [next(first).keep_now for _ in range(LEAVES)] == [*[False] * (LEAVES - 1), True]
    first.close()
    list(Shards().run([], store))  # as of a stage before
    assert store.keys_of_kind("handed")  # a run that is killed here takes them again
    assert asked(tmp_path / "p", tasks) == ("", expected)
    assert not store.keys_of_kind("handed")


def test_what_fails_in_a_shard_is_told_by_the_run_and_tried_again_by_the_next(tmp_path, capsys):
    tasks = tasks_of(2, crash={1: "bad input"}, small=False)
    asked(tmp_path / "p", tasks)
    found = reported(capsys, "worker", tmp_path / "p", "--shard", "0/1", "--wait", 0)
    assert values_of(found)["task_share.done"] == {"n": 1, "waiting": 0}
    assert [m["values"]["name"] for m in found["warnings"]] == ["leaf 1", "node 2"]
    assert all("leaf.csv" in m["text"] for m in found["warnings"])
    project = Project.open(tmp_path / "p")
    try:
        means = Means(project=project, executor=Shards())
        failed = means.do(tasks, "graph")
        assert [failed[t.key].messages[0].code for t in tasks[1:]] == ["error.other", "task.needs_failed"]
        assert all(NO_MATRIX in failed[t.key] for t in tasks[1:])
    finally:
        project.close()
    assert "task.shards_waiting" in asked(tmp_path / "p", tasks)[0]


def test_little_is_not_given_to_shards(tmp_path):
    """One task of a minute, or some of a second together: a queue takes longer to begin."""
    one = tasks_of(2)[:1]
    said, found = asked(tmp_path / "p", one)
    assert (said, len(found)) == ("", 64)
    assert not (tmp_path / "p/cache/tasks.jsonl").exists()
    assert "task.shards_waiting" in asked(tmp_path / "long", [replace(one[0], cost=61.0)])[0]
    assert asked(tmp_path / "short", tasks_of(4, cost=0.05))[0] == ""


@pytest.mark.parametrize(
    ("damage", "line", "said"),
    [
        (lambda _: "", 1, "[task.list_damaged]"),
        (lambda _: "[1]\n", 1, "[task.list_damaged]"),
        (lambda text: text[: len(text) - 40], 16, "[task.list_no_task]"),
        (lambda text: "\n".join(text.splitlines()[:-2]) + "\n", 14, "[task.list_count]"),
        (lambda text: text.replace("graph:leaf", "graph:none", 1), 2, "[task.list_no_task]"),
        (lambda text: text.replace("tests.pipeline.graph:leaf", "os:system", 1), 2, "'os:system' is no function of"),
        (lambda text: text.replace("tests.pipeline.graph:leaf", "no.such:thing", 1), 2, "is no function of tasks"),
        (lambda text: text.replace('"key":"', '"key":"../../x', 1), 2, "[task.list_no_key]"),
        (lambda text: text.replace('"number":0', '"number":7', 1), 2, "[task.list_checksum]"),
        (
            lambda text: "\n".join([text.splitlines()[0], *text.splitlines()[2:], text.splitlines()[2]]),
            2,
            "[task.list_checksum]",
        ),
    ],
)
def test_a_damaged_list_is_named_by_its_line_and_nothing_is_done(tmp_path, capsys, damage, line, said):
    asked(tmp_path / "p", tasks_of(LEAVES, small=False))
    file = tmp_path / "p/cache/tasks.jsonl"
    file.write_text(damage(file.read_text()))
    assert main(["worker", str(tmp_path / "p"), "--shard", "0/1", "--wait", "0"]) == 2
    told = capsys.readouterr().err
    assert f"{file}:{line}: " in told or f"{file}, line {line}: " in told, told
    assert said in told
    assert "[task.list_" in told
    assert not list((tmp_path / "p/cache").glob("*/*.npz"))


def test_a_share_reads_what_it_does_and_of_the_rest_the_keys(tmp_path, monkeypatch):
    tasks = tasks_of(LEAVES, small=False)
    asked(tmp_path / "p", tasks)
    read = []
    monkeypatch.setattr("raybundle.pipeline.shards.read_task", lambda line: read.append(line) or read_task(line))
    assert do_shard(tmp_path / "p", 1, 3, wait_s=0.0).made == 3
    assert len(read) == len(tasks[1::3])


def test_a_pair_is_listed_without_the_metadata_of_its_photographs(tmp_path):
    photos = [
        Photo(
            path=Path(f"/data/surveys/flight/DJI_20260412_{k}.JPG"), name=f"DJI_20260412_{k}.JPG", width_px=5280,
            height_px=3956, orientation=6, sha256=f"{k:064x}",
            metadata=Metadata(make="DJI", model="M3E", focal35_mm=24.0),
        )
        for k in range(2)
    ]  # fmt: skip
    project = Project.open(tmp_path / "p")
    listed = []
    try:
        means = Means(project=project, executor=SimpleNamespace(run=lambda tasks, _: iter(listed.extend(tasks) or ())))
        store = FeatureStore(project.products, tuple(key_of("features", k) for k in range(2)))
        with pytest.raises(KeyError):
            verified_pairs(means, photos, store, feature_method("rootsift"), [(0, 1)])
    finally:
        project.close()
    (task,) = listed
    assert len(written(task)) < 650
    assert read_task(written(task)) == task
    assert [f.upright_size for f in task.options.formats] == [p.upright_size for p in photos]


def test_what_is_no_project_is_said(tmp_path, capsys):
    pytest.importorskip("fsspec", reason="the extra [cluster] is not installed")
    (tmp_path / "empty/cache").mkdir(parents=True)
    for where, said in ((tmp_path / "empty", "[project.no_run]"), (f"file://{tmp_path}/bucket", "[store.no_products]")):
        assert main(["worker", str(where), "--shard", "0/1"]) == 2
        assert said in capsys.readouterr().err
    assert not (tmp_path / "bucket").exists()


def test_a_damaged_product_is_made_again_by_the_run_that_asks(tmp_path, expected):
    tasks = tasks_of(LEAVES)
    store = Folder(tmp_path / "p/cache")
    asked(tmp_path / "p", tasks[:LEAVES])
    do_shard(tmp_path / "p", 0, 1)
    path = store.place._path(tasks[0].key)
    data = bytearray(path.read_bytes())
    data[len(data) // 2] ^= 1
    path.write_bytes(data)
    said, found = asked(tmp_path / "p", tasks)
    for _ in range(3):
        if not said:
            break
        do_shard(tmp_path / "p", 0, 1, wait_s=0.0)
        said, found = asked(tmp_path / "p", tasks)
    assert found == expected


def test_a_list_of_another_version_is_refused(tmp_path):
    asked(tmp_path / "p", tasks_of(2))
    file = tmp_path / "p/cache/tasks.jsonl"
    file.write_text(file.read_text().replace("raybundle 0", "raybundle 9", 1))
    with pytest.raises(InputError, match=r"tasks\.jsonl.*9.*0.*cluster\.other_version"):
        do_shard(tmp_path / "p", 0, 1)


@pytest.mark.parametrize(
    ("words", "said"),
    [
        (["p", "--shard", "4/4"], "4/4 is not a shard. [worker.shard_form]"),
        (["p", "--shard", "one"], "[worker.shard_form]"),
        (["--shard", "0/1"], "[worker.project_missing]"),
        (["p"], "--cluster FOLDER and --shard I/N is needed. [worker.cluster_or_shard]"),
        (["--cluster", "c", "--shard", "0/1"], "--cluster FOLDER and --shard I/N is needed. [worker.cluster_or_shard]"),
        (["p", "--shard", "0/99999999999"], "9 999 999 shards are possible. [worker.too_many_shards]"),
        (["p", "--shard", f"0/{'9' * 5000}"], "[worker.too_many_shards]"),
        (["p", "--shard", "0/1"], "[project.no_run]"),
        (["--cluster", "tcp://10.0.0.5:8786"], "[cluster.other_machine]"),
        (["--cluster", "tls://127.0.0.1:8786"], "[cluster.needs_certificates]"),
        (["--cluster", "tcp://localhost"], "[cluster.no_address]"),
    ],
)
def test_what_is_asked_wrongly_is_named(tmp_path, monkeypatch, capsys, words, said):
    monkeypatch.chdir(tmp_path)
    assert main(["worker", *words]) == 2
    assert said in capsys.readouterr().err


def test_shards_are_processes_of_one_thread_and_leave_the_other_folder_alone(tmp_path, expected):
    """By the command, beside each other."""
    tasks = tasks_of(LEAVES)
    asked(tmp_path / "p", tasks)
    shards = [
        subprocess.Popen([sys.executable, "-m", "raybundle", "worker", "p", "--shard", f"{k}/2"], cwd=tmp_path, env=ENV)
        for k in range(2)
    ]
    assert [s.wait() for s in shards] == [0, 0]
    assert asked(tmp_path / "p", tasks) == ("", expected)


PORTAL = Path(__file__).resolve().parents[2] / "demo_data/portal/photos"


@pytest.mark.long
@pytest.mark.skipif(not PORTAL.is_dir(), reason="demo_data/portal is part of the repository")
def test_orient_by_shards_is_orient_on_one_machine(tmp_path, capsys, monkeypatch):
    """By commands, from photographs that are named from where the run was begun; results bit by bit."""
    monkeypatch.chdir(tmp_path)
    monkeypatch.setattr("raybundle.pipeline.shards.ALONE_S", 0.0)  # as with photographs that take longer
    monkeypatch.setattr("raybundle.pipeline.shards.TOGETHER_S", 0.0)
    photos = Path("photos")
    photos.mkdir()
    for k in (2, 3, 4):
        with Image.open(PORTAL / f"portal_{k:02d}.jpg") as image:
            image.reduce(2).save(photos / f"portal_{k:02d}.jpg", quality=92, exif=image.info["exif"])
    words = ["orient", "photos", "--feature-count", "800", "--quick", "--no-report"]
    assert main([*words, "--out", "here/project", "--jobs", "2"]) == 0
    rounds = 0
    for _ in range(9):
        if main([*words, "--out", "there/project", "--cluster", "shards"]) == 0:
            break
        assert "task.shards_waiting" in capsys.readouterr().err
        rounds += 1
        for k in (1, 0):
            shard = subprocess.run(
                [sys.executable, "-m", "raybundle", "worker", str(tmp_path / "there/project"), "--shard", f"{k}/2"],
                cwd="/", check=False, capture_output=True, text=True,
            )  # fmt: skip
            assert shard.returncode == 0, shard.stderr
    assert 2 <= rounds < 8
    for name in ("points.csv", "images.csv", "observations.csv"):
        assert (tmp_path / "here/project/result" / name).read_bytes() == (
            tmp_path / "there/project/result" / name
        ).read_bytes()


def test_status_says_how_far_work_is_and_where_products_lie(tmp_path, capsys):
    tasks = tasks_of(LEAVES, crash={3: "bad input"})
    asked(tmp_path / "p", tasks)
    do_shard(tmp_path / "p", 0, 2, wait_s=0.0)
    found = reported(capsys, "status", tmp_path / "p")
    done, n = found["listed"]
    assert n == len(tasks)
    assert 0 < done < len(tasks)
    lines = found["lines"]
    assert headline("project_status.listed", {"n": n, "done": done}) in lines
    running = {"state": "waiting", "stage": "graph", "done": done, "total": n, "at": ""}
    begin = headline("project_status.running", running).partition("(")[0]
    assert any(line.startswith(begin) for line in lines)  # not as many as when the run ended
    products = headline("project_status.products", {"size": "", "store": "none"}).partition(":")[0]
    assert any(line.startswith(products) for line in lines)
    project = Project.open(tmp_path / "p")
    try:
        note(project.folder, "matching", 7, 12)
        assert main(["status", str(tmp_path / "p")]) == 0
        running = {"state": "working", "stage": "matching", "done": 7, "total": 12, "at": ""}
        begin = headline("project_status.running", running).partition("(")[0]
        assert any(line.startswith(begin) for line in capsys.readouterr().out.splitlines())
        means = Means(project=project, executor=Threads(1))
        means.do(tasks, "graph")
        assert main(["status", str(tmp_path / "p")]) == 0
        said = capsys.readouterr().out
        assert headline("project_status.works", {}) in said
        assert "7 of 12" not in said
    finally:
        project.close()
