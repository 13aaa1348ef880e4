"""Kinds of observations and platforms in files of one's own: imported last of all, they are known all the same."""

import re
import subprocess
import sys
from pathlib import Path

from tests.docs.samples import with_tests

HOW_TO = Path(__file__).resolve().parents[2] / "docs/how-to"
TEXT = "".join(with_tests(HOW_TO / f"{name}.md") for name in ("own-observation-kind", "your-own-platform"))
CODE = re.findall(r"^```python\n(.*?)^```", TEXT, re.MULTILINE | re.DOTALL)
EVERYTHING = """
import raybundle.adjustment.records.severity
import raybundle.block.merge
import raybundle.io.block.arrays
import raybundle.io.block.folder
import raybundle.report.sections.control
import raybundle.report.write
import raybundle.results.folder
import raybundle.results.tables
from raybundle.results.tables import TABLES
before = set(TABLES)
"""
AFTERWARDS = """
from raybundle.adjustment.records.severity import SEVERITY
from raybundle.block.merge import merge_blocks
from raybundle.io.block.arrays import arrays_of_block, block_of_arrays
from raybundle.results.folder import read_result

assert set(TABLES) - before == {"azimuths"}
assert "azimuth_suspect" in SEVERITY
again = block_of_arrays(arrays_of_block(block))
assert (again.tables["azimuths"].angle == block.tables["azimuths"].angle).all()
assert len(merge_blocks([block, again]).tables["azimuths"]) == 3
shown = read_result("result")
v = shown.others["azimuths"].numbers("v_deg")[:, 0]
assert (abs(np.radians(v) - g.residual) <= 1e-3 * abs(g.residual / g.w)).all()
report = Path("result/report.html").read_text()
assert "Azimuths" in report
assert any(c.kind == "azimuths" for c in result.variance_components)
write_result(result, "result2")
try:
    write_block(block, "result2/block")
except InputError as error:
    assert error.code == "folder.exists"
for name, table in (("azimuth", None), ("azimuth 2", Azimuths)):
    try:
        type("Twice", (Azimuth,), {"name": name, "table": table})
    except TypeError as error:
        assert "azimuth" in str(error)
    else:
        raise AssertionError(name)
"""
PLATFORM = """
from raybundle.platforms import sensor_models
before = dict(sensor_models)
"""
CARRIED = """
assert all(sensor_models[n] is m for n, m in before.items())
new = set(sensor_models) - set(before)
assert {"brown_swept", "fisheye_swept", "brown_swept_mounted"} <= new
assert not any("rolling" in n or "trajectory" in n for n in new)
"""


def run(script, folder):
    file = folder / "page.py"
    file.write_text(script)
    done = subprocess.run(
        [sys.executable, "-W", "error", str(file)], cwd=folder, capture_output=True, text=True, check=False
    )
    assert done.returncode == 0, done.stderr[-3000:]


def test_a_kind_that_is_imported_last_is_read_kept_merged_written_and_reported(tmp_path):
    table, kind, use = CODE[:3]
    assert "class Azimuths" in table
    assert "write_result" in use
    run(f"{EVERYTHING}\n{table}\n{kind}\n{use}\n{AFTERWARDS}", tmp_path)


def test_a_platform_that_is_imported_last_carries_the_sensors_that_are_there(tmp_path):
    platform = next(code for code in CODE if "class Swept" in code)
    run(f"{PLATFORM}\n{platform}\n{CARRIED}", tmp_path)
