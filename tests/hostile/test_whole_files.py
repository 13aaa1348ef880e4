"""Files that commands and writers leave: the old one or the new one, whole, however the writing ends."""

import signal
import subprocess
import sys
from pathlib import Path

import numpy as np
import pytest

from raybundle.adjustment.engine import adjust_block
from raybundle.errors import InputError
from raybundle.io.calibrations.base import write_whole
from raybundle.io.scenes.writing import write_rpc
from raybundle.planning.simulate import Survey, simulate
from raybundle.planning.synthetic_networks import TargetField, field_scene
from raybundle.report.network.page import write_network_page
from raybundle.report.writing import write_report
from raybundle.scenes.rpc import Rpc

KILLED = """
import os, signal, sys
from raybundle.io import tables
tables.WRITTEN_ROWS = 2
rows, calls = tables.rows_of, []

def fatal(values):
    calls.append(values)
    if len(calls) > 2:  # some rows are written
        os.kill(os.getpid(), signal.SIGKILL)
    return rows(values)

if sys.argv.pop(1) == "kill":
    tables.rows_of = fatal
from raybundle.cli.main import main
sys.exit(main(sys.argv[1:]))
"""


def rpc():
    coefficients = np.zeros((4, 20))
    coefficients[[1, 3], 0] = 1
    coefficients[0, 2] = coefficients[2, 1] = 1
    return Rpc(
        image_offset=np.array([500.0, 500.0]), image_scale=np.array([500.0, 500.0]),
        ground_offset=np.array([10.0, 50.0, 100.0]), ground_scale=np.array([0.01, 0.01, 100.0]),
        coefficients=coefficients,
    )  # fmt: skip


@pytest.fixture(scope="module")
def result():
    field = TargetField(rows=3, columns=4, stations=4, frontal=1)
    exact = Survey(orientation="exact", points="exact", interior="exact")
    return adjust_block(simulate(field_scene(field), exact).observed)


WRITERS = {
    "a_RPC.TXT": lambda path, _: write_rpc(rpc(), path),
    "a.RPB": lambda path, _: write_rpc(rpc(), path),
    "a.geom": lambda path, _: write_rpc(rpc(), path),
    "report.html": lambda path, result: write_report(result, path),
    "network.html": lambda path, result: write_network_page(result, path),
    "camera.toml": lambda path, _: write_whole(path, "new"),
}


@pytest.mark.parametrize("name", WRITERS)
@pytest.mark.parametrize("how", [OSError(28, "No space left on device"), KeyboardInterrupt()], ids=["full", "stopped"])
def test_the_old_file_stays_whole_where_writing_breaks_off(name, how, result, tmp_path, monkeypatch):
    path = tmp_path / name
    path.write_text("old")
    text_, bytes_ = Path.write_text, Path.write_bytes

    def half(write):
        def written(self, what, *words, **more):
            write(self, what[: len(what) // 2], *words, **more)
            raise how

        return written

    with monkeypatch.context() as patched:
        patched.setattr(Path, "write_text", half(text_))
        patched.setattr(Path, "write_bytes", half(bytes_))
        with pytest.raises(InputError if isinstance(how, OSError) else KeyboardInterrupt):
            WRITERS[name](path, result)
    assert path.read_text() == "old"
    assert [p.name for p in tmp_path.iterdir()] == [name]
    WRITERS[name](path, result)
    assert path.read_text(encoding="utf-8") != "old"
    assert [p.name for p in tmp_path.iterdir()] == [name]


@pytest.mark.skipif(sys.platform == "win32", reason="a process cannot be killed by a signal here")
def test_a_table_of_points_is_there_whole_or_not_at_all_when_killed(tmp_path):
    write_rpc(rpc(), tmp_path / "a_RPC.TXT")
    rows = "".join(f"{k},10.00{k},50.00{k},{100 + k}\n" for k in range(8))
    (tmp_path / "ground.csv").write_text(f"point,lon_deg,lat_deg,h_m\n{rows}")
    out = tmp_path / "image.csv"
    words = ["rpc", "project", str(tmp_path / "a_RPC.TXT"), str(tmp_path / "ground.csv"), "--out", str(out)]

    def run(how):
        return subprocess.run([sys.executable, "-c", KILLED, how, *words], check=False, capture_output=True, text=True)

    assert run("kill").returncode == -signal.SIGKILL
    assert not out.exists()
    done = run("let live")
    assert done.returncode == 0, done.stderr
    assert len(out.read_text().splitlines()) == 9
    assert sorted(p.name for p in tmp_path.iterdir()) == ["a_RPC.TXT", "ground.csv", "image.csv"]
