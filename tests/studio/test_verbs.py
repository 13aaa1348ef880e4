"""Each action shows a command; the commands of a journal, typed, make the same state."""

import shlex
import shutil

import numpy as np
from click.testing import CliRunner

from raybundle.cli.main import cli
from raybundle.io.block.folder import read_block
from raybundle.measuring.actions.verbs import VERBS
from raybundle.measuring.journal import Journal, entries_of, journal_path, state_of
from raybundle.measuring.names import Known
from raybundle.measuring.selection import latest_figures, selected
from raybundle.measuring.state import State
from raybundle.studio.verbs import command_of

ROWS = [
    {"point": "G1", "role": "control", "xyz": [1.5, -2.0, 3.0], "sigma": [0.01, 0.0, 0.02]},
    {"point": "G2", "role": "check", "xyz": [4.0, 5.0, None], "sigma": [0.01, 0.01, None]},
]
TABLE = "point,X,Y,Z,sX,sY,sZ,role\nG1,1.5,-2,3,0.01,0,0.02,control\nG2,4,5,,0.01,0.01,,check\n"
LIMITS = {"w": 2.25, "sigma": 0.0123, "rays": 2.5, "redundancy": 0.05}


def beyond(project, quantity, limit):
    """What the page sends: the image observations that it found."""
    rows = selected(latest_figures(project), State(), quantity, limit).rows
    assert rows
    return {"quantity": quantity, "limit": limit, "rows": rows}


def test_the_commands_of_a_journal_make_the_same_state(project, tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    (tmp_path / "given 1.csv").write_text(TABLE)
    block = read_block(project / "result" / "block")
    a, b = block.images.ids[:2]
    o = block.observations
    seen = block.points.ids[int(o.point[np.flatnonzero(o.image == 0)[0]])]
    other = [p for p in block.points.ids if p != seen][:4]
    actions = [
        ("put", {"image": a, "point": "gate", "x_px": 100.123456789, "y_px": 50.5, "covariance": [0.01, 0.02, 0.001]}),
        ("put", {"image": b, "point": "-odd 'name", "x_px": 1.0, "y_px": 2.0}),
        ("move", {"image": a, "point": "gate", "x_px": 101.0, "y_px": 51.25, "covariance": [0.04, 0.04, 0.0]}),
        ("point", {"point": "gate", "role": "control", "xyz": [-1.5, 2.0, None], "sigma": [0.01, 0.0, None]}),
        ("point", {"point": "free"}),
        ("rename", {"point": "-odd 'name", "to": "even"}),
        ("bar", {"start": other[0], "end": other[1], "length": 1.0003, "sigma": 1e-4}),
        ("bar", {"start": other[1], "end": other[2], "length": 2.0, "sigma": 1e-3}),
        ("unbar", {"start": other[1], "end": other[2]}),
        ("line", {"line": "edge", "points": other[:2], "kind": "plumb", "sigma": 0.002}),
        ("line", {"line": "rim", "points": other[:3]}),
        ("line", {"line": "rim", "points": []}),
        ("datum", {"origin": other[0], "axis": other[1], "plane": other[2]}),
        ("reject", {"image": a, "point": seen}),
        ("accept", {"image": a, "point": seen}),
        ("reject", {"image": a, "point": seen}),
        ("parameter", {"camera": block.cameras[0].id, "symbol": "K3", "choice": "held"}),
        ("parameter", {"camera": block.cameras[0].id, "symbol": "A", "choice": "free"}),
        ("parameter", {"camera": block.cameras[0].id, "symbol": "K3", "choice": "auto"}),
        *(("reject_beyond", beyond(project, name, limit)) for name, limit in LIMITS.items()),
        ("fiducial", {"image": a, "name": "F1", "x_px": 7.25, "y_px": 8.5, "covariance": [0.04, 0.01, 0.0]}),
        ("fiducial", {"image": a, "name": "F2", "x_px": 7.25, "y_px": 80.5}),
        ("fiducial", {"image": a, "name": "F2"}),
        ("control", {"file": "given 1.csv", "points": ROWS}),
        ("mask", {"mask": "tree", "image": a, "polygon": [[0.5, 0], [90.25, 0], [90, 70.125]]}),
        ("mask", {"mask": "-bonnet", "image": b, "polygon": [[0, 9], [9, 0], [9, 9]], "camera": True}),
        ("mask", {"mask": "sky", "image": b, "polygon": [[0, 9], [9, 0], [9, 9], [1, 9]]}),
        ("unmask", {"mask": "sky"}),
        ("draw", {"drawing": "edge", "kind": "line", "corners": [[-2.5, 1], [4, 1.125]], "layer": "b 1", "note": "x"}),
        ("draw", {"drawing": "-pile", "kind": "area", "corners": [[0, 0], [2, 0], [2, 2]], "surface": "f-1/surface"}),
        ("draw", {"drawing": "gone", "kind": "line", "corners": [[0, 0], [2, 0]]}),
        ("erase", {"drawing": "gone"}),
        ("remove", {"image": b, "point": "even"}),
        ("forget", {"point": "free"}),
        ("undo", {}),
        ("undo", {}),
        ("redo", {}),
    ]
    assert {verb for verb, _ in actions} == set(VERBS)
    (project / "film").mkdir()
    (project / "film" / "film.toml").write_text('[film]\npixel_mm = 0.01\nmodel = "affine"\n')
    (project / "film" / "certificate.csv").write_text("mark,x_mm,y_mm\nF1,-5,0\nF2,5,0\n")
    again = tmp_path / "again"
    shutil.copytree(project, again)
    with Journal.open(journal_path(project), Known.of(block, ("F1", "F2"))) as journal:
        for verb, arguments in actions:
            journal.append_verb(verb, arguments)
    for entry in entries_of(journal_path(project)):
        program, *words = shlex.split(command_of(again, entry.verb, entry.arguments))
        assert program == "raybundle"
        done = CliRunner().invoke(cli, words, standalone_mode=False)
        assert done.exception is None, (words, done.exception)
    assert state_of(journal_path(again)) == state_of(journal_path(project))
