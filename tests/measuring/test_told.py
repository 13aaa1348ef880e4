"""What the commands say of what was done, and of what waits to be adjusted."""

import pytest
from click.testing import CliRunner

import raybundle as rb
from raybundle.cli.main import cli
from raybundle.errors import InputError
from raybundle.measuring.journal import measured_result
from tests.messages import refused

from .scenes import small_block


@pytest.fixture
def folder(tmp_path):
    rb.write_block(small_block(), tmp_path / "block")
    for k, image in enumerate(small_block().images.ids[:2]):
        rb.mark(tmp_path / "block", "put", image=image, point="gate", x_px=100.0 + k, y_px=50.0)
    return tmp_path / "block"


def said(*words):
    done = CliRunner().invoke(cli, [str(w) for w in words], standalone_mode=False)
    assert done.exception is None
    return done.output


def test_undo_and_redo_say_of_what(folder):
    image = small_block().images.ids[1]
    shown = said("mark", "undo", folder)
    assert all(part in shown for part in ("Action 3", "undo", "action 2", image, "gate", "101", "50"))
    again = said("mark", "redo", folder)
    assert all(part in again for part in ("Action 4", "redo", "action 2"))
    said("mark", "undo", folder)
    lines = said("mark", "list", folder, "--history").splitlines()
    assert [line.endswith("(taken back)") for line in lines] == [False, True, False, False, False]
    assert "null" not in "".join(lines)


def test_a_marked_point_is_asked_of_the_result_that_has_it(folder):
    with refused("mark.not_in_result", point="gate", adjusted=False):
        rb.query(folder, coordinates=("gate",))
    measured_result(folder).mkdir()
    with refused("mark.not_in_result", point="gate", adjusted=True):
        rb.query(folder, coordinates=("gate",))
    with pytest.raises(InputError, match=r"joint\.unknown_point"):
        rb.query(folder, coordinates=("nowhere",))


def test_a_result_that_was_read_is_asked_as_its_folder_is(tmp_path):
    result = rb.adjust(small_block())
    rb.write_result(result, tmp_path / "result", report="none")
    names = small_block().points.ids[:2]
    (a,), (b,) = rb.query(rb.read_result(tmp_path / "result"), distance=names), rb.query(result, distance=names)
    assert a.values == pytest.approx(b.values, rel=1e-9)
    assert a.sigma == pytest.approx(b.sigma, rel=1e-6)


def test_what_is_no_path_is_said(tmp_path):
    with refused("setting.no_path", name="out", type="Block"):
        rb.convert(tmp_path, small_block(), to="colmap")
