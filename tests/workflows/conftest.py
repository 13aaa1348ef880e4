"""The portal at half its size and the surface of it, made once in a run and read by many tests."""

import shutil

import pytest

import raybundle as rb
from raybundle.commands.surface import surface
from raybundle.io.block.folder import read_block
from raybundle.report.write import write_result
from tests.once import made_once
from tests.workflows.half_portal import half_portal


@pytest.fixture(scope="session")
def half(tmp_path_factory):
    """Folder of three photographs at half their size, their block as given and as adjusted; no test writes into it."""

    def make(folder):
        half_portal(folder)
        (folder / "block").rename(folder / "given")
        result = folder.parent / "half-result"
        write_result(rb.adjust(read_block(folder / "given")), result, report="none")
        shutil.move(result / "block", folder)
        shutil.rmtree(result)

    return made_once(tmp_path_factory, "half", make)


@pytest.fixture(scope="session")
def copy_of_surface(half, tmp_path_factory):
    """Function that copies the output folder of their surface, every fourth pixel, without products."""

    def make(folder):
        surface(half / "block", folder / "s", photos=(half,), density="4", jobs=1)

    return lambda to: shutil.copytree(made_once(tmp_path_factory, "surface", make) / "s", to)
