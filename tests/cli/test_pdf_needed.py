"""A PDF that cannot be set is told before anything is computed, and nothing is lost by it."""

import pytest

import raybundle as rb
from raybundle.errors import InputError
from raybundle.planning.simulate import Survey, simulate
from raybundle.planning.synthetic_networks import TargetField, field_scene
from raybundle.report.paper import needed

ASKED = {
    "adjust": lambda _, out: rb.write_result(adjusted(), out, pdf=True),
    "orient": lambda empty, out: rb.orient(empty, out, pdf=True),
    "calibrate": lambda empty, out: rb.calibrate(empty, out, target="aicon14", pdf=True),
    "measure": lambda empty, out: rb.measure(empty, out, target=("aicon14",), pdf=True),
    "moved": lambda empty, out: rb.moved_points([empty, empty], out, pdf=True),
}


def adjusted():
    return rb.adjust(simulate(field_scene(TargetField(columns=4, rows=3, stations=3)), Survey()).observed)


@pytest.mark.parametrize("command", sorted(ASKED))
def test_it_is_told_first(command, tmp_path, monkeypatch):
    monkeypatch.setattr(needed, "find_spec", lambda _: None)
    empty = tmp_path / "empty"
    empty.mkdir()
    with pytest.raises(InputError, match=r"raybundle\[pdf\]"):
        ASKED[command](empty, tmp_path / "out")
    assert not (tmp_path / "out").exists()
