"""An adjustment that fails leaves nothing behind: no reference cycle keeps its normal equations."""

import contextlib
import gc

import pytest

from raybundle import adjust
from raybundle.adjustment.system.normals import Normals
from raybundle.errors import RaybundleError
from tests.verdicts.cases import CASES


@pytest.mark.parametrize("name", ["square views of a plane", "one place", "one panorama", "collinear points"])
def test_nothing_is_kept(name):
    make, options = CASES[name]
    block = make()
    gc.collect()
    before = sum(isinstance(o, Normals) for o in gc.get_objects())
    gc.disable()  # cycles stay until it is enabled
    try:
        with contextlib.suppress(RaybundleError):
            adjust(block, options)
        left = sum(isinstance(o, Normals) for o in gc.get_objects())
    finally:
        gc.enable()
    assert left == before
