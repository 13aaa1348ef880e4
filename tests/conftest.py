"""Where the public data sets are, and what all tests of a process share."""

import atexit
import ctypes
import gc
import os
import shutil
import sys
import tempfile
from pathlib import Path

import psutil
import pytest
from hypothesis import HealthCheck, settings

from tests import slow

DATA = Path(os.environ.get("RAYBUNDLE_DATA", Path(__file__).resolve().parents[2] / "shared/data"))


os.environ.pop("PYTHONDONTWRITEBYTECODE", None)
sys.dont_write_bytecode = False
"""Hundreds of processes begin within the tests: each would compile the package anew."""
gc.disable()
"""While tests are collected nothing becomes garbage; what is collected is never looked at again, see below."""
os.environ.setdefault("OPENBLAS_NUM_THREADS", "1")
"""Tests run side by side: threads within small matrices only stand in each other's way."""
os.environ["RAYBUNDLE_CAMERAS"] = str(Path(__file__).parent / "no-cameras")
"""No test finds the calibrations of whoever runs it."""
os.environ["RAYBUNDLE_PRODUCTS"] = tempfile.mkdtemp(prefix="raybundle-products-")
"""Nor leaves copies of products with them."""
atexit.register(shutil.rmtree, os.environ["RAYBUNDLE_PRODUCTS"], ignore_errors=True)
os.environ["RAYBUNDLE_CONFIG"] = tempfile.mkdtemp(prefix="raybundle-config-")
"""Nor stores that were confirmed."""
atexit.register(shutil.rmtree, os.environ["RAYBUNDLE_CONFIG"], ignore_errors=True)
os.environ["RAYBUNDLE_TASK_MODULES"] = "tests.pipeline.graph,tests.pipeline.test_executors,tests.pipeline.test_stage"
"""Tasks of tests, in this process and in those that it begins."""

settings.register_profile("busy", deadline=None, suppress_health_check=[HealthCheck.too_slow])
settings.load_profile("busy")
"""How long an example takes says how busy the machine is."""


SLOW = slow.names()


def pytest_addoption(parser):
    parser.addoption("--cpu", metavar="FILE", help="append the processor seconds of each test, see tests/slow.py")
    parser.addoption("--part", type=slow.part, metavar="K/N", help="of all selected tests the Kth of N parts")


def pytest_configure(config):
    if config.getoption("--cpu"):
        config.pluginmanager.register(slow.Measured(config.getoption("--cpu")))


@pytest.hookimpl(wrapper=True)
def pytest_collection_modifyitems(config, items):
    for item in items:
        if item.nodeid in SLOW:
            item.add_marker(pytest.mark.long)
    yield
    if config.getoption("--part"):
        k, n = config.getoption("--part")
        first, last = (len(items) * i // n for i in (k - 1, k))
        config.hook.pytest_deselected(items=[*items[:first], *items[last:]])
        items[:] = items[first:last]


def pytest_collection_finish():
    gc.freeze()
    gc.enable()


TRIM = getattr(ctypes.CDLL(None), "malloc_trim", None) if sys.platform == "linux" else None
GROWN = 50e6
"""Bytes more than after the last time, with which memory is given back"""
_resident = [0]


@pytest.hookimpl(trylast=True)
def pytest_runtest_teardown(item, nextitem):
    """Give memory back to the system after the last test of a file, where the process has grown."""
    if not TRIM or (nextitem is not None and nextitem.path == item.path):
        return
    process = psutil.Process()
    if process.memory_info().rss > _resident[0] + GROWN:
        gc.collect()
        TRIM(0)
        _resident[0] = process.memory_info().rss


@pytest.fixture(scope="session")
def blocks():
    """The folder of public adjustment blocks; skips where it is absent."""
    folder = DATA / "blocks"
    if not folder.is_dir():
        pytest.skip("no public data: set RAYBUNDLE_DATA to the folder that holds blocks/")
    return folder


@pytest.fixture(scope="module")
def browser():
    """A Chromium that a test drives; skips where there is none."""
    from tests.studio.browser import ARGUMENTS, chromium

    sync_api = pytest.importorskip("playwright.sync_api", reason="playwright is not installed: no page is tested here")
    path = chromium()
    if path is None:
        pytest.skip("no Chromium is here (RAYBUNDLE_CHROMIUM may name one): the page is not tested here")
    with sync_api.sync_playwright() as playwright:
        found = playwright.chromium.launch(executable_path=path, args=list(ARGUMENTS))
        yield found
        found.close()
