"""Stores at a URL: the same bits as in a folder, whatever fails, and copies that take no more than they may."""

import contextlib
import gc
import os
import shutil
import signal
import subprocess
import sys
from pathlib import Path

import numpy as np
import pytest

from raybundle.cli.main import main
from raybundle.errors import InputError, TasksWaiting, code_of
from raybundle.io.copies import Copies, StoreLost
from raybundle.pipeline import objects
from raybundle.pipeline.archives import is_complete
from raybundle.pipeline.clusters import token_of, unseen
from raybundle.pipeline.confirmed_stores import confirm_store
from raybundle.pipeline.executors import Processes, Threads
from raybundle.pipeline.keys import key_of
from raybundle.pipeline.place import ProductGone
from raybundle.pipeline.project import Project, products_of
from raybundle.pipeline.shards import Shards, do_shard
from raybundle.pipeline.stage import Means
from raybundle.pipeline.store import Folder
from tests.messages import refused
from tests.pipeline.graph import digest, done_by, executions, tasks_of
from tests.pipeline.machines import Machines

fsspec = pytest.importorskip("fsspec", reason="stores at a URL are an extra")
MemoryFileSystem = pytest.importorskip("fsspec.implementations.memory").MemoryFileSystem

LEAVES = 16
ROOT = Path(__file__).parents[2]
KEY = key_of("test", 1)
PRODUCT = {"a": np.arange(1000.0), "names": np.array(["x", "雪"])}


class Flaky(MemoryFileSystem):
    """A service that does what a test says before it does what it is asked for."""

    protocol = "flaky"
    store = {}  # noqa: RUF012  (as of its class)
    pseudo_dirs = [""]  # noqa: RUF012
    plan = []  # noqa: RUF012
    """what happens to the next calls: an exception, or the share of a file that goes through"""
    calls = 0

    @classmethod
    def _next(cls):
        cls.calls += 1
        happens = cls.plan.pop(0) if cls.plan else 1.0
        if isinstance(happens, Exception):
            raise happens
        return happens

    @classmethod
    def _strip_protocol(cls, path):
        return MemoryFileSystem._strip_protocol(path.replace("flaky://", "memory://"))

    def info(self, path, **more):
        self._next()
        return super().info(path, **more)

    def put_file(self, lpath, rpath, **_):
        share, data = self._next(), Path(lpath).read_bytes()
        self.pipe_file(rpath, data[: int(len(data) * share)])

    def get_file(self, rpath, lpath, **_):
        share, data = self._next(), self.cat_file(rpath)
        Path(lpath).write_bytes(data[: int(len(data) * share)])


fsspec.register_implementation("flaky", Flaky, clobber=True)
objects.SCHEMES.add("flaky")


@pytest.fixture(autouse=True)
def copies(tmp_path, monkeypatch):
    """Copies of this test alone; nothing is left in memory."""
    monkeypatch.setenv("RAYBUNDLE_PRODUCTS", str(tmp_path / "copies"))
    monkeypatch.setattr(objects, "PAUSE_S", 0.001)
    yield tmp_path / "copies"
    objects.objects_at.cache_clear()
    unseen.cache_clear()
    for system in (MemoryFileSystem, Flaky):
        system.store.clear()
        system.pseudo_dirs[:] = [""]
    Flaky.plan = []


@pytest.fixture(scope="module")
def expected(tmp_path_factory):
    """What one thread makes in a folder."""
    return done_by(Threads(1), tasks_of(LEAVES), Folder(tmp_path_factory.mktemp("store")))


@pytest.fixture
def url(tmp_path):
    return f"{(tmp_path / 'objects').as_uri()}/site"


@pytest.fixture
def flaky(tmp_path):
    store = Folder(tmp_path / "p", "flaky://bucket/site")
    store.store(KEY, PRODUCT)
    Flaky.plan, Flaky.calls = [], 0
    return store


def file_of(tmp_path, key):
    (found,) = (tmp_path / "objects").rglob(f"{key}.npz")
    return found


def raced(monkeypatch, race):
    """What another process does to an object between the look at it and the way here."""
    get = objects.Objects._get

    def late(self, fs, path, size, here):
        race(Path(path))
        get(self, fs, path, size, here)

    monkeypatch.setattr(objects.Objects, "_get", late)


def test_an_object_that_another_process_removes_meanwhile_is_missing(tmp_path, url, copies, monkeypatch):
    store = Folder(tmp_path / "s", url)
    store.store(KEY, PRODUCT)
    shutil.rmtree(copies)
    raced(monkeypatch, lambda path: path.unlink())
    assert store.load(KEY) is None
    store.store(KEY, PRODUCT)
    assert np.array_equal(store.load(KEY)["a"], PRODUCT["a"])


def test_an_object_that_another_process_makes_again_meanwhile_is_got(tmp_path, url, copies, monkeypatch):
    store = Folder(tmp_path / "s", url)
    store.store(KEY, PRODUCT)
    shutil.rmtree(copies)
    whole = file_of(tmp_path, KEY).read_bytes()
    file_of(tmp_path, KEY).write_bytes(whole[:-30])
    raced(monkeypatch, lambda path: path.write_bytes(whole))
    assert np.array_equal(store.load(KEY)["a"], PRODUCT["a"])


def test_copies_that_vanish_meanwhile_are_no_missing_object(tmp_path, url, copies, monkeypatch):
    store = Folder(tmp_path / "s", url)
    store.store(KEY, PRODUCT)
    shutil.rmtree(copies)
    raced(monkeypatch, lambda _: shutil.rmtree(copies))
    with pytest.raises(StoreLost):
        store.load(KEY)
    assert file_of(tmp_path, KEY).exists()


@pytest.mark.parametrize("executor", [Threads(3), Processes(1), Processes(2)], ids=str)
def test_the_same_bits_as_in_a_folder(tmp_path, expected, url, executor, copies):
    tasks, store = tasks_of(LEAVES), Folder(tmp_path / "s", url)
    assert done_by(executor, tasks, store) == expected
    shutil.rmtree(copies)  # another machine has none
    objects.objects_at.cache_clear()
    other = Folder(tmp_path / "t", url)
    small = {d.task.key: d.product for d in Threads(1).run([t for t in tasks if t.small], other)}
    assert digest(other, tasks, small) == expected
    plain = Folder(tmp_path / "f")
    plain.store(tasks[0].key, other.load(tasks[0].key))
    assert file_of(tmp_path, tasks[0].key).read_bytes() == plain.place.file(tasks[0].key).read_bytes()
    assert not list((tmp_path / "objects").rglob(".*"))


def test_in_the_memory_of_one_process(tmp_path, expected):
    store = Folder(tmp_path / "s", "memory://site")
    assert done_by(Threads(2), tasks_of(LEAVES), store) == expected
    with pytest.raises(InputError, match=r"store\.in_memory"):
        list(Processes(2).run(tasks_of(2), store))


def test_what_is_there_by_single_looks_and_by_lists(tmp_path, url):
    store, keys = Folder(tmp_path / "s", url), [key_of(kind, k) for kind in ("one kind", "other") for k in range(12)]
    assert store.those(keys) == set()
    for key in keys[::2]:
        store.store(key, PRODUCT)
    assert store.those(keys) == {*keys[::2]}
    assert store.those(keys[:3]) == {keys[0], keys[2]}
    assert store.keys_of_kind("other") == sorted(keys[12::2])
    store.forget_kind("other")
    assert store.those(keys) == {*keys[:12:2]}
    assert store.load(keys[12]) is None
    (tmp_path / "objects/site/mine.txt").write_text("mine")
    store.place.clear()
    assert [p.name for p in (tmp_path / "objects/site").rglob("*") if p.is_file()] == ["mine.txt"]


def test_a_copy_that_is_damaged_is_got_again_and_an_object_is_made_again(tmp_path, url, copies):
    store = Folder(tmp_path / "s", url)
    store.store(KEY, PRODUCT)
    there = file_of(tmp_path, KEY)
    whole, about = there.read_bytes(), there.stat()
    altered = bytearray(whole)
    altered[len(whole) // 2] ^= 1
    (copy,) = copies.rglob("*.npz")
    for data in (altered, whole[:-30], b""):
        copy.write_bytes(data)
        np.testing.assert_array_equal(store.mapped(KEY)["a"], PRODUCT["a"])
        assert there.stat() == about
    for data in (altered, whole[:-30], b"a letter", b""):
        there.write_bytes(data)
        copy.unlink()
        with pytest.raises(ProductGone, match=r"product\.gone"):
            store.wanted(KEY)
        assert not there.exists()
        store.makers[KEY] = lambda: store.store(KEY, PRODUCT)
        assert store.wanted(KEY)["names"][1] == "雪"
        assert there.read_bytes() == whole
        del store.makers[KEY]


def test_what_is_not_ours_is_told_and_stays(tmp_path, url):
    store = Folder(tmp_path / "s", url)
    at = tmp_path / "objects/site/test" / f"{KEY}.npz"
    at.mkdir(parents=True)
    (at / "mine").write_text("mine")
    with pytest.raises(InputError, match=r"store\.occupied"):
        store.store(KEY, PRODUCT)
    assert (at / "mine").read_text() == "mine"
    other = Folder(tmp_path / "t", f"{(tmp_path / 'other').as_uri()}")
    (tmp_path / "other").mkdir()
    (tmp_path / "other/token").write_text("a letter")
    with pytest.raises(InputError, match=r"store\.foreign_token"):
        other.place.check()


def test_what_fails_is_tried_three_times(flaky, copies):
    shutil.rmtree(copies)
    for plan in ([OSError("line"), TimeoutError("line")], [1.0, 0.5, 1.0], [1.0, 0.0, 0.7]):
        Flaky.plan = [*plan]
        flaky.place.damaged(KEY, again=False, which=None)
        np.testing.assert_array_equal(flaky.load(KEY)["a"], PRODUCT["a"])
        assert not Flaky.plan
    other = key_of("test", 2)
    Flaky.plan = [FileNotFoundError("no folder there"), 0.3, 1.0]  # is a folder at its place, half of it, its length
    flaky.store(other, PRODUCT)
    assert len(Flaky.store) == 3, "two products and the token, nothing beside"
    flaky.place.damaged(other, again=False, which=None)
    assert flaky.load(other)["a"][-1] == 999.0


@pytest.mark.parametrize(
    ("error", "told"),
    [
        (OSError("Could not connect to host"), r"store\.lost"),
        (PermissionError("Access Denied"), r"store\.lost"),
        (RuntimeError("Unable to locate credentials"), r"store\.lost"),
    ],
)
def test_what_fails_three_times_stops_everything_and_says_what_to_do(flaky, error, told, copies):
    shutil.rmtree(copies)
    flaky.place.damaged(KEY, again=False, which=None)
    Flaky.plan = [error] * 3
    with pytest.raises(StoreLost, match=r"bucket/site.*3.*store\.lost"):
        flaky.has(KEY)
    Flaky.plan = [error] * 3
    with pytest.raises(StoreLost, match=told):
        flaky.load(KEY)
    assert flaky.load(KEY)["a"][1] == 1.0, "nothing was removed"
    Flaky.plan = [FileNotFoundError("no folder there"), *[error] * 9]
    with pytest.raises(StoreLost, match=told):
        flaky.store(key_of("test", 3), PRODUCT)
    assert len(Flaky.store) == 2


def test_an_object_of_which_a_part_comes_each_time_is_no_damaged_one(flaky, copies):
    flaky.place.damaged(KEY, again=False, which=None)
    Flaky.plan = [1.0, *(0.5, 1.0) * 3]  # its length is asked for before and after
    with pytest.raises(StoreLost, match=r"store\.lost"):
        flaky.load(KEY)
    assert flaky.has(KEY)


def test_a_store_that_is_lost_costs_no_photograph(flaky):
    """The run ends; no task is said to have failed."""
    tasks, seen = tasks_of(4, small=False), []

    def cut(done):
        seen.append(done)
        Flaky.plan = [ConnectionError("cut")] * 99

    with refused("store.lost", detail="cut") as error:
        [*map(cut, Threads(1).run(tasks, flaky))]
    assert error.value.file == "flaky://bucket/site"
    assert not any(d.failed for d in seen)
    Flaky.plan = []
    assert all(not d.failed for d in Threads(1).run(tasks, flaky))


@pytest.mark.parametrize(
    ("where", "told"),
    [
        ("nowhere://b/c", r"s3.*store\.unknown_scheme"),
        ("s3://", r"store\.no_bucket_name"),
        ("ftp://me:secret@host/p", r"host/p.*store\.unknown_scheme"),
        ("s3://me:secret@host/p", r"s3.*host/p.*store\.secret"),
        ("products", r"s3.*bucket/folder.*store\.no_url"),
    ],
)
def test_urls_that_are_none(tmp_path, where, told):
    with pytest.raises(InputError, match=told) as error:
        Folder(tmp_path / "s", where).place.check()
    assert "secret@" not in str(error.value)


def test_no_such_bucket(tmp_path, monkeypatch):
    def nowhere(*_, **__):
        raise FileNotFoundError("The specified bucket does not exist")

    for name in ("info", "put_file", "pipe_file", "cat_file"):
        monkeypatch.setattr(Flaky, name, nowhere)
    with pytest.raises(StoreLost, match=r"store\.no_bucket"):
        Folder(tmp_path / "s", "flaky://none").place.check()


def test_copies_take_no_more_than_they_may_and_the_last_used_stay(tmp_path, url, copies, monkeypatch):
    store, keys = Folder(tmp_path / "s", url), [key_of("test", k) for k in range(12)]
    monkeypatch.setenv("RAYBUNDLE_PRODUCTS_GB", "0.0001")  # 100 kB: some ten products
    for k, key in enumerate(keys):
        store.store(key, {**PRODUCT, "k": np.array(k)})
        store.load(keys[0])
        assert sum(p.stat().st_size for p in copies.rglob("*.npz")) <= 100_000
    left = {p.stem for p in copies.rglob("*.npz")}
    assert {keys[0], keys[-1]} <= left
    assert keys[1] not in left
    assert [int(store.load(k)["k"]) for k in keys] == [*range(12)]
    held = [store.held(k) for k in keys]  # what is mapped stays, whoever takes the copy away
    assert [int(h["k"]) for h in held] == [*range(12)]
    monkeypatch.setenv("RAYBUNDLE_PRODUCTS_GB", "much")
    with pytest.raises(InputError, match=r"store\.copies_size"):
        store.store(keys[0], PRODUCT)


READER = """
import random, sys
from pathlib import Path
from raybundle.pipeline.store import Folder
store, keys = Folder(Path("s"), sys.argv[1]), sys.argv[3:]
random.seed(int(sys.argv[2]))
for _ in range(200):
    key = random.choice(keys)
    assert int(store.mapped(key)["k"]) == keys.index(key)
"""


def test_several_processes_share_copies_that_come_and_go(tmp_path, url, copies, monkeypatch):
    monkeypatch.setenv("RAYBUNDLE_PRODUCTS_GB", "0.00004")  # four products
    store, keys = Folder(tmp_path / "s", url), [key_of("test", k) for k in range(9)]
    for k, key in enumerate(keys):
        store.store(key, {**PRODUCT, "k": np.array(k)})
    begun = [
        subprocess.Popen([sys.executable, "-c", READER, url, str(n), *keys], stderr=subprocess.PIPE) for n in range(2)
    ]
    most = 0
    while any(p.poll() is None for p in begun):
        sizes = []
        for path in copies.rglob("*.npz"):
            with contextlib.suppress(FileNotFoundError):
                sizes.append(path.stat().st_size)
        most = max(most, sum(sizes))
    said = [p.communicate()[1] for p in begun]
    assert [p.returncode for p in begun] == [0, 0], said
    assert 0 < most <= 60_000, "one that is begun, and one that was listed before it was taken away"
    assert not list(copies.rglob(".*"))


def test_a_disk_of_copies_that_is_full(tmp_path, url, monkeypatch):
    disk = tmp_path / "disk"
    disk.mkdir()
    if subprocess.run(["mount", "-t", "tmpfs", "-o", "size=128k", "none", disk], check=False).returncode:
        pytest.skip("no small disk can be made here")
    try:
        monkeypatch.setenv("RAYBUNDLE_PRODUCTS", str(disk))
        monkeypatch.setenv("RAYBUNDLE_PRODUCTS_GB", "1")  # more than there is
        store, keys = Folder(tmp_path / "s", url), [key_of("test", k) for k in range(20)]
        for k, key in enumerate(keys):
            store.store(key, {**PRODUCT, "k": np.array(k)})
        assert [int(store.load(k)["k"]) for k in keys] == [*range(20)]
        with pytest.raises(StoreLost, match=r"store\.copies_not_writable"):
            store.store(key_of("test", "large"), {"a": np.ones(100_000)})
        assert not list(disk.rglob(".*"))
        assert not store.has(key_of("test", "large"))
    finally:
        subprocess.run(["umount", "-l", disk], check=True)


def test_a_copy_that_was_begun_long_ago_is_swept(tmp_path):
    copies = Copies(tmp_path, "store")
    old = tmp_path / "store/ab/.test-x.01234567"
    old.parent.mkdir(parents=True)
    for name in (old, old.with_name(".test-y.01234567")):
        name.write_bytes(bytes(10))
    os.utime(old, (1, 1))
    copies.make(KEY, 10, lambda p: p.write_bytes(bytes(10)), lambda _: None)
    assert copies._freed(10) == 10
    assert [p.name for p in old.parent.iterdir()] == [".test-y.01234567"]


DRIVER = """
import sys
from pathlib import Path
from raybundle.pipeline.executors import Processes
from raybundle.pipeline.project import Project
from raybundle.pipeline.stage import Means
from tests.pipeline.graph import tasks_of
if __name__ == "__main__":
    project = Project.open(Path(sys.argv[1]), store=sys.argv[2])
    means = Means(project=project, executor=Processes(2), progress=lambda *_: print("one", flush=True))
    try:
        gate, free = (Path(sys.argv[5]), int(sys.argv[6])) if len(sys.argv) > 5 else (None, 0)
        tasks = tasks_of(16, log=Path(sys.argv[3]), seconds=float(sys.argv[4]), gate=gate, free=free)
        assert not means.do(tasks, "graph")
    finally:
        project.close()
"""


@pytest.mark.skipif(not hasattr(signal, "SIGKILL"), reason="there is no kill -9 here")
def test_runs_that_are_killed_go_on_and_leave_nothing_half(tmp_path, url, expected, copies):
    (tmp_path / "driver.py").write_text(DRIVER)
    words = [sys.executable, tmp_path / "driver.py", tmp_path / "p", url, tmp_path / "log"]
    env, kills = {**os.environ, "PYTHONPATH": str(ROOT)}, 3
    for k in range(kills):
        gated = ["0.05", tmp_path / "gate", str(4 * (k + 1))]  # it can do four tasks more, and no other
        with subprocess.Popen([*words, *gated], stdout=subprocess.PIPE, env=env) as driver:
            assert all(driver.stdout.readline() for _ in range(3))
            driver.kill()
            driver.stdout.read()
        assert all(is_complete(p) for p in (tmp_path / "objects").rglob("[!.]*.npz"))
    shutil.rmtree(copies)  # it goes on at another machine
    subprocess.run([*words, "0"], check=True, stdout=subprocess.DEVNULL, env=env)
    tasks = tasks_of(LEAVES)
    project = Project.open(tmp_path / "p", store=url)
    try:
        assert digest(project.products, tasks, project.small([t.key for t in tasks if t.small])) == expected
    finally:
        project.close()
    again = sum(n - 1 for name, n in executions(tmp_path / "log").items() if int(name) < 10_000)
    assert again <= 2 * kills
    assert not list((tmp_path / "p/cache").rglob("*.npz"))


def test_products_that_were_damaged_are_made_again_in_the_same_run(tmp_path, url, expected, copies):
    tasks = tasks_of(LEAVES)
    leaves, rest = tasks[:LEAVES], tasks[LEAVES:]
    project = Project.open(tmp_path / "p", store=url)
    try:
        means = Means(project=project, executor=Processes(2))
        assert means.do(leaves, "leaves") == {}
        for k, t in enumerate(leaves[:6]):
            path = file_of(tmp_path, t.key)
            data = bytearray(path.read_bytes())
            data[len(data) // 2] ^= 255
            path.write_bytes(data[:-30] if k % 2 else data)
        shutil.rmtree(copies)
        assert means.do(rest, "rest") == {}
        small = {t.key: means.small(t.key) for t in rest if t.small}
        assert digest(project.products, tasks, small) == expected
    finally:
        project.close()


def test_a_project_remembers_where_its_products_lie(tmp_path, url):
    folder = tmp_path / "p"
    folder.mkdir()
    (folder / "project.toml").write_text(f'[orient]\nstore = "{url}"\n')
    confirm_store(url)
    assert products_of(folder).url == url
    assert products_of(folder, "memory://x").url == "memory://x"
    assert products_of(folder, "project").url == ""
    (folder / "project.toml").write_text("[orient]\njobs = 1\n")
    assert products_of(folder) == Folder(folder / "cache")


def test_a_folder_that_is_named_from_here_is_the_same_from_elsewhere(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    assert Folder(Path("s"), "file://bucket/site").url == f"{tmp_path.as_uri()}/bucket/site"
    for url in ("file:///bucket", "s3://bucket/site", "memory://site", ""):
        assert Folder(Path("s"), url).url == url


def test_shards_need_the_url_alone(tmp_path, url, expected, capsys, monkeypatch):
    tasks, shown = tasks_of(LEAVES), ""
    monkeypatch.chdir(tmp_path)
    for _ in range(9):
        project = Project.open(tmp_path / "p", store=url)
        try:
            means = Means(project=project, executor=Shards())
            assert means.do(tasks, "graph") == {}
            small = {t.key: means.small(t.key) for t in tasks if t.small}
            assert digest(project.products, tasks, small) == expected
            break
        except TasksWaiting as waiting:
            shown = shown or waiting.message
        finally:
            project.close()
        for share in ("0/2", "1/2"):
            main(["worker", url, "--shard", share, "--wait", "0"])
    else:
        pytest.fail("shards have not done it")
    assert shown.code == "task.shards_waiting"
    assert (shown.values["file_name"], shown.values["project"]) == (f"{url}/tasks.jsonl", url)
    assert "Tasks done: " in capsys.readouterr().out
    assert not (tmp_path / "objects/site/tasks.jsonl").exists()


def test_a_shard_in_the_memory_of_one_process_is_refused():
    with pytest.raises(InputError, match=r"store\.in_memory"):
        do_shard("memory://x", 0, 1)


def test_workers_of_a_cluster_by_the_url_alone(tmp_path, url, expected):
    """They do not see the folder of the project: it is another machine's."""
    pytest.importorskip("distributed", reason="Dask distributed is an extra")
    from raybundle.pipeline.clusters import cluster_at
    from raybundle.pipeline.on_dask import Dask

    machines = Machines(tmp_path / "cluster")
    try:
        machines.scheduler()
        machines.worker()
        executor = Dask(cluster_at(str(machines.folder)))
        assert done_by(executor, tasks_of(LEAVES), Folder(tmp_path / "p/cache", url)) == expected
    finally:
        machines.close()


@pytest.mark.long
def test_parts_of_an_adjustment_lie_there_while_it_runs(tmp_path, url, copies):
    """The same result, and nothing is left."""
    main(["simulate", "aerial", "--out", str(tmp_path / "flight")])
    words = ["adjust", str(tmp_path / "flight/block"), "--memory", "0.1", "--jobs", "2", "--no-report"]
    assert main([*words, "--out", str(tmp_path / "here")]) == 0
    assert main([*words, "--out", str(tmp_path / "there"), "--store", url]) == 0
    gc.collect()
    tables = [p.relative_to(tmp_path / "here") for p in (tmp_path / "here").rglob("*.csv")]
    assert tables
    for name in tables:
        assert (tmp_path / "there" / name).read_bytes() == (tmp_path / "here" / name).read_bytes()
    assert not [p for p in (tmp_path / "objects").rglob("*") if p.is_file()]
    assert copies.is_dir(), "it was used"
    assert not list(copies.rglob("*.npz"))


def test_why_a_worker_does_not_see_a_store(tmp_path, url, monkeypatch):
    monkeypatch.setattr("raybundle.pipeline.clusters.APPEAR_S", 0.0)
    token = token_of(Folder(tmp_path / "s", url))
    assert unseen(str(tmp_path / "elsewhere"), url, token) == ""
    assert code_of(unseen("s", url, "0" * 32)) == "cluster.other_store"
    assert code_of(unseen("s", f"{url}-not", token)) == "cluster.no_store"
    assert "store.unknown_scheme" in unseen("s", "nowhere://x", token)
