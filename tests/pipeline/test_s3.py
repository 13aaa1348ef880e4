"""Stores at an S3: the same bits as in a folder, and what a bucket or a server that is gone reports."""

import json
import os
import subprocess
import sys
from pathlib import Path

import pytest

from raybundle.pipeline.executors import Threads
from raybundle.pipeline.store import Folder
from tests.pipeline.graph import done_by, tasks_of

ROOT = Path(__file__).parents[2]
S3 = """
import json, os, sys
from pathlib import Path
from moto.server import ThreadedMotoServer
from raybundle.errors import InputError
from raybundle.pipeline.executors import Processes, Threads
from raybundle.pipeline.store import Folder
from tests.pipeline.graph import done_by, tasks_of
if __name__ == "__main__":
    server = ThreadedMotoServer(ip_address="127.0.0.1", port=0, verbose=False)
    server.start()
    os.environ["AWS_ENDPOINT_URL"] = "http://%s:%s" % server.get_host_and_port()
    import boto3
    boto3.client("s3").create_bucket(Bucket="surveys")
    tasks, codes = tasks_of(16), []
    keys = [t.key for t in tasks if not t.small]
    stores = [Folder(Path("s"), "s3://surveys/" + name) for name in ("threads", "processes")]
    digests = [done_by(e, tasks, s) for e, s in zip((Threads(2), Processes(2)), stores)]
    store = stores[0]
    fs, path = store.place._fs(), store.place._path(keys[0])
    fs.pipe_file(path, fs.cat_file(path)[:-40])
    store.place._copies.forget(keys[0])
    damaged = store.load(keys[0]) is None and not store.has(keys[0])
    there = len(store.those(keys)), len(store.keys_of_kind("node"))
    store.forget_kind("node")
    there += (len(store.keys_of_kind("node")),)
    store.place.clear()
    there += (len(fs.find("surveys/threads")), len(fs.find("surveys/processes")))
    for k, url in enumerate(("s3://nowhere/x", "s3://surveys/late")):
        if k:
            server.stop()
        try:
            Folder(Path("n"), url).place.check()
        except InputError as error:
            codes.append([error.code, error.file, error.message.values])
    print(json.dumps([digests, damaged, there, codes]), flush=True)
    os._exit(0)
"""


@pytest.mark.long
def test_an_s3_on_this_machine(tmp_path):
    """By s3fs, against moto's server: requests as they go over a network."""
    for name in ("moto", "s3fs"):
        pytest.importorskip(name, reason=f"{name} is not installed")
    (tmp_path / "s3.py").write_text(S3)
    keys = dict.fromkeys(("AWS_ACCESS_KEY_ID", "AWS_SECRET_ACCESS_KEY"), "test")
    env = {**os.environ, **keys, "AWS_DEFAULT_REGION": "us-east-1", "PYTHONPATH": str(ROOT), "NO_PROXY": "127.0.0.1"}
    done = subprocess.run(
        [sys.executable, tmp_path / "s3.py"], env=env, cwd=tmp_path, capture_output=True, text=True, check=True
    )
    expected = done_by(Threads(1), tasks_of(16), Folder(tmp_path / "store"))
    digests, damaged, there, (no_bucket, no_server) = json.loads(done.stdout.splitlines()[-1])
    assert digests == [expected, expected]
    assert damaged
    assert there == [30, 15, 0, 0, 32]  # 16 leaves and 15 nodes, one of them damaged; those and the token
    assert no_bucket == ["store.no_bucket", "s3://nowhere/x", {}]
    code, file, values = no_server
    assert (code, file) == ("store.lost", "s3://surveys/late")
    assert values["detail"].startswith("Could not ")
